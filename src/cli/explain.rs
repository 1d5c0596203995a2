//! `explain`: prints the page of a rule.
//!
//! In: a slug, or a code from a message. Out: what the rule checks, why, how to fix it, a failing program and
//! the corrected one, in the requested language.

use std::io::{self, Write};

use super::rules::named;
use crate::message::{RULES, Rule};
use crate::sentences::{Language, labels};

/// The page of a rule.
struct Page {
    slug: &'static str,
    /// The setup of both programs, JSON; `{}` for the default.
    setup: &'static str,
    wrong: &'static str,
    right: &'static str,
    /// In English, Chinese, Russian.
    texts: [Text; 3],
}

/// The page in one language.
struct Text {
    title: &'static str,
    what: &'static str,
    why: &'static str,
    repair: &'static str,
}

include!(concat!(env!("OUT_DIR"), "/pages.rs"));

/// Line width in characters.
const WIDTH: usize = 100;

/// Writes the pages of a rule, or of all rules with a code. The error names the most similar rule.
pub(super) fn write(out: &mut dyn Write, name: &str, language: Language) -> Result<io::Result<()>, String> {
    let found = named(name)?;
    let pages = RULES.iter().filter(|rule| found.contains(&rule.slug));
    Ok(pages.enumerate().try_for_each(|(at, rule)| {
        if at > 0 {
            writeln!(out)?;
        }
        page(out, rule, language)
    }))
}

fn page(out: &mut dyn Write, rule: &Rule, language: Language) -> io::Result<()> {
    let Some(page) = PAGES.iter().find(|page| page.slug == rule.slug) else { return Ok(()) };
    let (index, [what, why, repair, wrong, right, setup, off]) = match language {
        Language::English => (
            0,
            [
                "What it looks at",
                "Why it matters",
                "Repair",
                "Failing",
                "Corrected",
                "Setup",
                "Switch it off",
            ],
        ),
        Language::Chinese => {
            (1, ["检查什么", "为什么重要", "如何改正", "有误的程序", "改正后的程序", "设置", "关闭"])
        }
        Language::Russian => (
            2,
            [
                "Что проверяется",
                "Почему это важно",
                "Как исправить",
                "С ошибкой",
                "Исправлено",
                "Настройка",
                "Отключить",
            ],
        ),
    };
    let text = &page.texts[index];
    writeln!(out, "{}\n", text.title)?;
    let severity = labels::severity(rule.severity, language);
    let alarms =
        if rule.alarms == rule.codes { String::new() } else { format!("  {}", rule.alarms.join(" ")) };
    writeln!(out, "{}  {}  {severity}{alarms}", rule.slug, rule.codes.join(" "))?;
    for (head, said) in [(what, text.what), (why, text.why), (repair, text.repair)] {
        writeln!(out, "\n{head}\n{}", wrapped(said, WIDTH))?;
    }
    if page.setup != "{}" {
        writeln!(out, "\n{setup}\n  {}", page.setup)?;
    }
    for (head, program) in [(wrong, page.wrong), (right, page.right)] {
        writeln!(out, "\n{head}")?;
        program.lines().try_for_each(|line| writeln!(out, "  {line}"))?;
    }
    writeln!(out, "\n{off}\n  (RULES {}=OFF)    --ignore {}", rule.slug.to_uppercase(), rule.slug)
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
    use super::{PAGES, RULES, wrapped};

    #[test]
    fn each_rule_has_its_page() {
        let slugs: Vec<_> = RULES.iter().map(|rule| rule.slug).collect();
        assert_eq!(PAGES.iter().map(|page| page.slug).collect::<Vec<_>>(), slugs);
    }

    #[test]
    fn lines_end_between_words_and_between_chinese_letters() {
        assert_eq!(wrapped("one two three", 10), "  one two\n  three");
        assert_eq!(wrapped("刀尖角度不存在。", 10), "  刀尖角度\n  不存在。");
        assert_eq!(wrapped("a-word-that-is-too-long", 10), "  a-word-that-is-too-long");
    }
}
