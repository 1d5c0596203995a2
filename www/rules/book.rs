//! Renders the pages of the rules as HTML.
//!
//! In: pages. Out: files by name: plain HTML without scripts, one style sheet with the colours of the
//! playground, and the pictures, which all languages share.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;
use std::{fs, io};

use gcode_playground::message::{Diagnostic, RULES, Rule, Severity};
use gcode_playground::sentences::{Language, labels};
use gcode_playground::setup::Setup;
use gcode_playground::source::address::percent_encoded;

use super::outcome::{Marked, Outcome, Picture, same_word};
use super::words::words;
use crate::format::RuleFile;
use crate::format::page::{Mark, Page, Text};

/// The colours come first, so that the pages and the playground share them.
const STYLES: [&str; 2] = [include_str!("../../www/src/tokens.css"), include_str!("rules.css")];

/// The pages run no scripts; styles and pictures come from their own host.
const POLICY: &str = include_str!("policy.html");

/// A page with the results of its programs.
struct Shown<'a> {
    page: &'a Page,
    rule: &'static Rule,
    /// Severity in the failing program, which may be lower than the default.
    severity: Severity,
    told: Diagnostic,
    /// Name and marks of each picture, failing and corrected; `None` if nothing moves.
    pictures: [Option<(String, Marked)>; 2],
}

/// The pages of the manual that link to a rule, by its slug: name and title.
type InManual = BTreeMap<String, Vec<(String, String)>>;

/// Reads the pages of the manual in a language.
fn in_manual(folder: &Path) -> io::Result<InManual> {
    let mut found = InManual::new();
    let mut paths: Vec<_> = fs::read_dir(folder)?.flatten().map(|entry| entry.path()).collect();
    paths.sort();
    for path in paths {
        let text = fs::read_to_string(&path)?;
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let title = text.lines().find_map(|line| line.strip_prefix("# ")).unwrap_or(&name).to_owned();
        for rest in text.split("](../../../src/rules/").skip(1) {
            let slug = rest.split(".md)").next().unwrap_or_default();
            let pages = found.entry(slug.to_owned()).or_default();
            if !pages.iter().any(|(other, _)| *other == name) {
                pages.push((name.clone(), title.clone()));
            }
        }
    }
    Ok(found)
}

/// All files by name, or the errors in the pages. `manual`: the folder of the manual, whose pages link to rules.
pub fn files(rules: &[RuleFile], manual: &Path) -> Result<BTreeMap<String, String>, String> {
    let mut files = BTreeMap::from([("rules.css".to_owned(), STYLES.concat())]);
    let (mut shown, mut slips) = (Vec::new(), Vec::new());
    for rule in rules {
        match Shown::of(rule, &mut files) {
            Ok(one) => shown.push(one),
            Err(slip) => slips.push(format!("{}: {slip}", rule.slug)),
        }
    }
    if !slips.is_empty() {
        return Err(slips.join("\n"));
    }
    for language in Language::ALL {
        let tag = language.tag();
        let folder = manual.join(tag);
        let pages = in_manual(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
        for one in &shown {
            files.insert(format!("{tag}/{}.html", one.rule.slug), one.html(language, &pages));
        }
        files.insert(format!("{tag}/index.html"), index(&shown, language));
    }
    Ok(files)
}

impl<'a> Shown<'a> {
    /// Runs the programs of a page and draws them.
    fn of(file: &'a RuleFile, files: &mut BTreeMap<String, String>) -> Result<Self, String> {
        let RuleFile { slug, page, .. } = file;
        let rule = RULES.iter().find(|rule| rule.slug == slug).ok_or("there is no such rule")?;
        let setup = Setup::from_json(&page.setup).map_err(|error| format!("setup: {error}"))?;
        let wrong = Outcome::of(&page.wrong, &setup, page.stop);
        let right = Outcome::of(&page.right, &setup, None);
        let told = wrong.told(slug).next().cloned().ok_or("`wrong` does not trigger it")?;
        // A run that was stopped is not repeated for the dimension of a word.
        let word = Some(told.span.start).filter(|_| page.stop.is_none());
        let same = word.and_then(|word| same_word(&page.wrong, word, &page.right));
        let pictures = [("wrong", wrong.picture(Some(&right), word)), ("right", right.picture(None, same))];
        let pictures = pictures.map(|(name, picture)| {
            let Picture { svg, marked } = picture?;
            let name = format!("pictures/{slug}-{name}.svg");
            files.insert(name.clone(), svg);
            Some((name, marked))
        });
        Ok(Self { page, rule, severity: told.severity, told, pictures })
    }

    fn html(&self, language: Language, manual: &InManual) -> String {
        let words = words(language);
        let (Page { setup, .. }, slug) = (self.page, self.rule.slug);
        let text = self.text(language);
        let sentence = self.told.message.sentence(language);
        let mut out = String::new();
        let title = format!("{} · {}", text.title.replace('`', ""), words.playground);
        head(&mut out, language, &title, &format!("{slug}.html"));
        put(&mut out, format_args!("<h1>{}</h1>", prose(&text.title)));
        self.metadata(&mut out, language);
        put(&mut out, format_args!("<div class=\"said {}\">", self.severity.name()));
        put(&mut out, format_args!("<p>{}</p>", prose(&sentence.message)));
        if let Some(help) = sentence.help {
            put(&mut out, format_args!("<p class=\"help\">{}</p>", prose(&help)));
        }
        put(&mut out, "</div>");
        for (heading, said) in
            [(words.what, &text.what), (words.why, &text.why), (words.repair, &text.repair)]
        {
            put(&mut out, format_args!("<h2>{heading}</h2>\n<p>{}</p>", prose(said)));
        }
        if let Some(pages) = manual.get(slug) {
            put(&mut out, format_args!("<h2>{}</h2>\n<ul>", words.manual));
            for (name, title) in pages {
                let address = format!("../../manual/{}/{name}.html", language.tag());
                put(&mut out, format_args!("<li><a href=\"{address}\">{}</a></li>", prose(title)));
            }
            put(&mut out, "</ul>");
        }
        put(&mut out, format_args!("<h2>{}</h2>", words.example));
        if setup != "{}" {
            put(&mut out, format_args!("<p>{} <code>{}</code></p>", words.setup, escaped(setup)));
        }
        put(&mut out, "<div class=\"examples\">");
        let Page { wrong, right, marks, .. } = self.page;
        let [wrong_picture, right_picture] = &self.pictures;
        self.example(&mut out, language, (words.wrong, wrong, marks, wrong_picture), &text.title);
        self.example(&mut out, language, (words.right, right, &[], right_picture), &text.title);
        put(&mut out, "</div>");
        put(&mut out, format_args!("<h2>{}</h2>\n<p>{}</p>", words.off, prose(words.off_how)));
        put(&mut out, "<dl class=\"switch\">");
        put(&mut out, format_args!("<dt>{}</dt><dd><code>(RULES {slug}=OFF)</code></dd>", words.off_program));
        let json = escaped(&format!("{{\"rules\": {{\"{slug}\": \"off\"}}}}"));
        put(&mut out, format_args!("<dt>{}</dt><dd><code>{json}</code></dd>", words.off_setup));
        put(&mut out, "</dl>\n</main>\n</body>\n</html>");
        out
    }

    fn text(&self, language: Language) -> &Text {
        &self.page.texts[language as usize]
    }

    /// Writes severity, codes, name, kind and alarms.
    fn metadata(&self, out: &mut String, language: Language) {
        let words = words(language);
        let Rule { slug, codes, kind, alarms, .. } = self.rule;
        let codes: Vec<_> = codes.iter().map(|code| format!("<code>{code}</code>")).collect();
        let severity = labels::severity(self.severity, language);
        let mut metadata = vec![
            format!("<span class=\"severity {}\">{severity}</span>", self.severity.name()),
            codes.join(" "),
            format!("<code>{slug}</code>"),
            labels::category(*kind, language).to_owned(),
        ];
        if !alarms.is_empty() {
            metadata.push(format!("{} {}", words.alarm, alarms.join(", ")));
        }
        put(out, format_args!("<p class=\"metadata\">{}</p>", metadata.join(" · ")));
    }

    /// Writes a program with its picture.
    fn example(
        &self,
        out: &mut String,
        language: Language,
        (heading, program, marks, picture): (&str, &str, &[Mark], &Option<(String, Marked)>),
        title: &str,
    ) {
        let words = words(language);
        put(out, format_args!("<section>\n<h3>{heading}</h3>"));
        let listing = listing(program, marks, self.severity);
        put(out, format_args!("<pre lang=\"en\" tabindex=\"0\"><code>{listing}</code></pre>"));
        let address = address(program, &self.page.setup, language);
        put(out, format_args!("<p><a href=\"../../index.html#{address}\">{}</a></p>", words.open));
        match picture {
            Some((name, marked)) => {
                let alt = escaped(&format!("{heading}: {}", title.replace('`', "")));
                put(out, format_args!("<img src=\"../{name}\" alt=\"{alt}\">"));
                if *marked == Marked::Difference {
                    put(out, format_args!("<p class=\"marked\">{}</p>", words.difference));
                }
            }
            None => put(out, format_args!("<p class=\"nothing\">{}</p>", words.nothing_drawn)),
        }
        put(out, "</section>");
    }
}

/// The list of all rules, by kind and then by title.
fn index(shown: &[Shown], language: Language) -> String {
    let words = words(language);
    let mut out = String::new();
    head(&mut out, language, &format!("{} · {}", words.rules, words.playground), "index.html");
    put(&mut out, format_args!("<h1>{}</h1>\n<p>{}</p>", words.rules, words.about));
    for (kind, heading) in words.kinds {
        let mut rows: Vec<_> = shown.iter().filter(|one| one.rule.kind == kind).collect();
        if rows.is_empty() {
            continue;
        }
        rows.sort_by_key(|one| one.text(language).title.replace('`', "").to_lowercase());
        put(&mut out, format_args!("<h2>{heading}</h2>\n<table>\n<thead><tr>"));
        for heading in [words.message, words.severity, words.code, words.alarm] {
            put(&mut out, format_args!("<th scope=\"col\">{heading}</th>"));
        }
        put(&mut out, "</tr></thead>\n<tbody>");
        for one in rows {
            let Rule { slug, codes, alarms, .. } = one.rule;
            let (grade, severity) = (one.severity.name(), labels::severity(one.severity, language));
            let title = prose(&one.text(language).title);
            put(&mut out, format_args!("<tr><td><a href=\"{slug}.html\">{title}</a></td>"));
            put(&mut out, format_args!("<td><span class=\"severity {grade}\">{severity}</span></td>"));
            put(&mut out, format_args!("<td>{}</td><td>{}</td></tr>", codes.join(" "), alarms.join(" ")));
        }
        put(&mut out, "</tbody>\n</table>");
    }
    put(&mut out, "</main>\n</body>\n</html>");
    out
}

/// Writes the start of a page, before its content.
fn head(out: &mut String, language: Language, title: &str, file: &str) {
    let (tag, words) = (language.tag(), words(language));
    put(out, format_args!("<!doctype html>\n<html lang=\"{tag}\">\n<head>\n<meta charset=\"utf-8\">"));
    put(out, POLICY);
    put(out, "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">");
    put(out, "<meta name=\"color-scheme\" content=\"light dark\">");
    put(out, format_args!("<title>{}</title>", escaped(title)));
    put(out, "<link rel=\"stylesheet\" href=\"../rules.css\">");
    let others = || Language::ALL.into_iter().map(|other| (other.tag(), self::words(other).own_name));
    for (other, _) in others() {
        put(out, format_args!("<link rel=\"alternate\" hreflang=\"{other}\" href=\"../{other}/{file}\">"));
    }
    put(out, "</head>\n<body>\n<header>\n<nav>");
    put(out, format_args!("<a href=\"../../index.html\">{}</a>", words.playground));
    put(out, format_args!("<a href=\"index.html\">{}</a>\n</nav>", words.rules));
    put(out, format_args!("<nav aria-label=\"{}\">", words.languages));
    for (other, name) in others() {
        let link = format!("lang=\"{other}\" hreflang=\"{other}\" href=\"../{other}/{file}\"");
        match other == tag {
            true => put(out, format_args!("<span aria-current=\"true\">{name}</span>")),
            false => put(out, format_args!("<a {link}>{name}</a>")),
        }
    }
    put(out, "</nav>\n</header>\n<main>");
}

/// The lines of a program, with the marks.
fn listing(program: &str, marks: &[Mark], severity: Severity) -> String {
    let mut out = String::new();
    for (number, line) in program.lines().enumerate() {
        out.push_str("<span class=\"line\">");
        let letters: Vec<char> = line.chars().collect();
        let piece = |from: usize, to: usize| {
            let to = to.min(letters.len());
            escaped(&letters[from.min(to)..to].iter().collect::<String>())
        };
        let mut at = 0;
        // Marks may overlap: the earlier one wins.
        for mark in marks.iter().filter(|mark| mark.line == number) {
            let (from, to) = (mark.column.max(at), mark.column + mark.length);
            if from < to {
                let name = severity.name();
                let _ = write!(out, "{}<mark class=\"{name}\">{}</mark>", piece(at, from), piece(from, to));
                at = to;
            }
        }
        out.push_str(&piece(at, letters.len()));
        out.push_str("\n</span>");
    }
    out
}

/// The part after `#` of the playground's address of a program.
fn address(program: &str, setup: &str, language: Language) -> String {
    let setup = if setup == "{}" { String::new() } else { format!("&amp;setup={}", percent_encoded(setup)) };
    let program = percent_encoded(program);
    format!("program={program}{setup}&amp;language={}", language.tag())
}

/// A sentence as HTML; backticks enclose program text.
fn prose(text: &str) -> String {
    let mut out = String::new();
    for (index, part) in text.split('`').enumerate() {
        let part = escaped(part);
        match index % 2 {
            1 => drop(write!(out, "<code lang=\"en\">{part}</code>")),
            _ => out.push_str(&part),
        }
    }
    out
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

fn put(out: &mut String, line: impl std::fmt::Display) {
    let _ = writeln!(out, "{line}");
}
