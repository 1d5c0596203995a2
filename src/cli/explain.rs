//! `explain`: prints the page of a rule.
//!
//! In: a slug, or a code from a message. Out: what the rule checks, why, how to fix it, a failing program and
//! the corrected one, in the requested language: as text, as Markdown, or as one JSON object a rule.

use std::io::{self, Write};

use super::options::PageFormat;
use super::rule_page::Page;
use super::rules::named;
use super::{markdown, write_row};
use crate::api;
use crate::message::{RULES, Rule};
use crate::sentences::{Language, labels};

/// Line width in characters.
const WIDTH: usize = 100;

/// Writes the pages of a rule, or of all rules with a code or in a group. The error names the most similar rule.
pub(super) fn write(
    out: &mut dyn Write,
    name: &str,
    language: Language,
    format: PageFormat,
) -> Result<io::Result<()>, String> {
    let found = named(name)?;
    let rules = RULES.iter().filter(|rule| found.contains(&rule.slug));
    let pages = rules.filter_map(|rule| Some(Explained { rule, page: Page::of(rule.slug)?, language }));
    Ok(pages.enumerate().try_for_each(|(at, explained)| {
        if at > 0 && format != PageFormat::Json {
            writeln!(out)?;
        }
        match format {
            PageFormat::Text => explained.text(out),
            PageFormat::Json => write_row(out, &explained.row()),
            PageFormat::Markdown => explained.markdown(out),
        }
    }))
}

/// A rule with its page, in a language.
struct Explained {
    rule: &'static Rule,
    page: &'static Page,
    language: Language,
}

/// The headings of a page.
struct Headings {
    what: &'static str,
    why: &'static str,
    repair: &'static str,
    wrong: &'static str,
    right: &'static str,
    setup: &'static str,
    off: &'static str,
}

impl Headings {
    fn of(language: Language) -> Self {
        match language {
            Language::English => Self {
                what: "What it looks at",
                why: "Why it matters",
                repair: "Repair",
                wrong: "Failing",
                right: "Corrected",
                setup: "Setup",
                off: "Switch it off",
            },
            Language::Chinese => Self {
                what: "检查什么",
                why: "为什么重要",
                repair: "如何改正",
                wrong: "有误的程序",
                right: "改正后的程序",
                setup: "设置",
                off: "关闭",
            },
            Language::Russian => Self {
                what: "Что проверяется",
                why: "Почему это важно",
                repair: "Как исправить",
                wrong: "С ошибкой",
                right: "Исправлено",
                setup: "Настройка",
                off: "Отключить",
            },
        }
    }
}

impl Explained {
    /// The paragraphs with their headings.
    fn paragraphs(&self) -> [(&'static str, &'static str); 3] {
        let (headings, text) = (Headings::of(self.language), self.page.text(self.language));
        [(headings.what, text.what), (headings.why, text.why), (headings.repair, text.repair)]
    }

    /// The programs with their headings.
    fn programs(&self) -> [(&'static str, &'static str); 2] {
        let headings = Headings::of(self.language);
        [(headings.wrong, self.page.wrong), (headings.right, self.page.right)]
    }

    /// The setup of both programs, if they need one.
    fn setup(&self) -> Option<&'static str> {
        Some(self.page.setup).filter(|setup| *setup != "{}")
    }

    fn severity(&self) -> &'static str {
        labels::severity(self.rule.severity, self.language)
    }

    /// The alarms of controls; empty if they are the codes.
    fn alarms(&self) -> &'static [&'static str] {
        if self.rule.alarms == self.rule.codes { &[] } else { self.rule.alarms }
    }

    /// A comment that switches the rule off in a program, and the option of `check`.
    fn switches(&self) -> [String; 2] {
        let slug = self.rule.slug;
        [format!("(RULES {}=OFF)", slug.to_uppercase()), format!("--ignore {slug}")]
    }

    fn text(&self, out: &mut dyn Write) -> io::Result<()> {
        let headings = Headings::of(self.language);
        writeln!(out, "{}\n", self.page.text(self.language).title)?;
        let head = [self.rule.slug.to_owned(), self.rule.codes.join(" "), self.severity().to_owned()];
        let alarms = Some(self.alarms().join(" ")).filter(|alarms| !alarms.is_empty());
        writeln!(out, "{}", head.into_iter().chain(alarms).collect::<Vec<_>>().join("  "))?;
        for (head, said) in self.paragraphs() {
            writeln!(out, "\n{head}\n{}", wrapped(said, WIDTH))?;
        }
        if let Some(setup) = self.setup() {
            writeln!(out, "\n{}\n  {setup}", headings.setup)?;
        }
        for (head, program) in self.programs() {
            writeln!(out, "\n{head}")?;
            program.lines().try_for_each(|line| writeln!(out, "  {line}"))?;
        }
        writeln!(out, "\n{}\n  {}", headings.off, self.switches().join("    "))
    }

    fn markdown(&self, out: &mut dyn Write) -> io::Result<()> {
        let headings = Headings::of(self.language);
        writeln!(out, "# {}\n", markdown::with_code(self.page.text(self.language).title))?;
        let names = std::iter::once(&self.rule.slug).chain(self.rule.codes);
        let head = names.map(|name| format!("`{name}`")).chain([self.severity().to_owned()]);
        let head = head.chain(self.alarms().iter().map(|alarm| format!("`{alarm}`")));
        writeln!(out, "{}", head.collect::<Vec<_>>().join(" · "))?;
        for (head, said) in self.paragraphs() {
            writeln!(out, "\n## {head}\n\n{}", markdown::with_code(said))?;
        }
        if let Some(setup) = self.setup() {
            write!(out, "\n## {}\n\n{}", headings.setup, markdown::block("json", setup))?;
        }
        for (head, program) in self.programs() {
            write!(out, "\n## {head}\n\n{}", markdown::block("gcode", program))?;
        }
        let switches = self.switches().map(|switch| format!("`{switch}`"));
        writeln!(out, "\n## {}\n\n{}", headings.off, switches.join(", "))
    }

    fn row(&self) -> api::RulePage {
        let text = self.page.text(self.language);
        api::RulePage {
            rule: api::Rule::new(self.rule, self.rule.severity),
            title: text.title,
            what: text.what,
            why: text.why,
            repair: text.repair,
            setup: self.setup().and_then(|setup| serde_json::from_str(setup).ok()),
            wrong: self.page.wrong,
            right: self.page.right,
        }
    }
}

/// Wraps a paragraph to a width, with indentation; Chinese characters are two columns wide.
fn wrapped(text: &str, width: usize) -> String {
    let mut lines = vec![String::from("  ")];
    let mut used = 2;
    for piece in pieces(text) {
        let room = piece.chars().map(wide).sum::<usize>();
        if used + room > width && used > 2 {
            lines.push(String::from("  "));
            used = 2;
        }
        let piece = if used == 2 { piece.trim_start() } else { piece };
        lines.last_mut().expect("a line").push_str(piece);
        used += piece.chars().map(wide).sum::<usize>();
    }
    lines.iter().map(|line| line.trim_end()).collect::<Vec<_>>().join("\n")
}

/// Pieces between which a line may break: before a space, and before each Chinese character.
fn pieces(text: &str) -> impl Iterator<Item = &str> {
    let mut starts: Vec<usize> = text
        .char_indices()
        .filter(|&(at, letter)| {
            at > 0 && (letter == ' ' || wide(letter) == 2 && !"，。；：、）”".contains(letter))
        })
        .map(|(at, _)| at)
        .collect();
    starts.push(text.len());
    starts.into_iter().scan(0, |from, to| {
        let piece = &text[*from..to];
        *from = to;
        Some(piece)
    })
}

fn wide(letter: char) -> usize {
    if matches!(letter, '\u{2e80}'..='\u{9fff}' | '\u{ff00}'..='\u{ff60}') { 2 } else { 1 }
}

#[cfg(test)]
mod tests {
    use super::wrapped;

    #[test]
    fn lines_end_between_words_and_between_chinese_letters() {
        assert_eq!(wrapped("one two three", 10), "  one two\n  three");
        assert_eq!(wrapped("刀尖角度不存在。", 10), "  刀尖角度\n  不存在。");
        assert_eq!(wrapped("a-word-that-is-too-long", 10), "  a-word-that-is-too-long");
    }
}
