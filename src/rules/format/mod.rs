//! The parser of rule files, `src/rules/<slug>.md`.
//!
//! In: the text of the file. Out: its parts, or all its errors with their lines. `src/rules/README.md`
//! describes the format. Shared by the build script, the rule pages and their tests, so it uses only the
//! standard library and must not know the effect of programs or the use of the parts.

pub mod message;
pub mod page;

use std::fs;
use std::path::{Path, PathBuf};

use message::{Message, Type};
use page::Page;

/// The languages of all texts, in the order of all lists.
pub const LANGUAGES: [&str; 3] = ["en", "zh", "ru"];

/// Severities: the name in a rule file, and the variant in Rust.
pub const SEVERITIES: [(&str, &str); 4] =
    [("off", "Off"), ("info", "Info"), ("warning", "Warning"), ("error", "Error")];
/// Kinds, as pairs like [`SEVERITIES`].
pub const KINDS: [(&str, &str); 3] =
    [("wrong", "Wrong"), ("unsupported", "Unsupported"), ("machine", "Machine")];
/// Groups of rules that the setup switches under one name, as pairs like [`SEVERITIES`].
pub const GROUPS: [(&str, &str); 1] = [("classroom", "Classroom")];

/// A rule file.
#[derive(Clone, Debug, Default)]
pub struct RuleFile {
    /// Stable name of the fault.
    pub slug: String,
    /// The stable code of its messages. If there is none, the code is the alarm.
    pub code: Option<String>,
    /// The alarms that a control raises. If there are several, each message has an argument of the type
    /// `alarm`.
    pub alarms: Vec<String>,
    /// Default severity, as the variant in Rust.
    pub severity: &'static str,
    /// Category, as the variant in Rust.
    pub kind: &'static str,
    /// The group of the rule, as the variant in Rust.
    pub group: Option<&'static str>,
    /// Its messages.
    pub messages: Vec<Message>,
    /// Its page: texts and examples.
    pub page: Page,
    /// Texts that are missing in a language; the English text is used instead.
    pub missing: Vec<Mistake>,
}

/// An error in a rule file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mistake {
    /// The line, from 1.
    pub line: usize,
    /// Description of the error.
    pub what: String,
}

impl std::fmt::Display for Mistake {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "line {}: {}", self.line, self.what)
    }
}

/// The collected errors, and the current line.
#[derive(Default)]
struct Mistakes {
    line: usize,
    found: Vec<Mistake>,
}

impl Mistakes {
    fn add(&mut self, what: impl Into<String>) {
        self.add_at(self.line, what);
    }

    fn add_at(&mut self, line: usize, what: impl Into<String>) {
        self.found.push(Mistake { line, what: what.into() });
    }
}

/// A section of a rule file.
#[derive(Clone, Copy)]
enum Section {
    Head,
    Message,
    Page,
}

impl RuleFile {
    /// Parses a rule file; returns all its errors if there are any.
    pub fn read(text: &str) -> Result<Self, Vec<Mistake>> {
        let mut rule = Self::default();
        let mut mistakes = Mistakes::default();
        let mut page = page::Reader::default();
        let mut section = Section::Head;
        for (index, line) in text.lines().enumerate() {
            mistakes.line = index + 1;
            if let Some(name) = line.strip_prefix("## message ") {
                section = Section::Message;
                rule.messages.push(Message::new(name.trim(), index + 1, &mut mistakes));
            } else if line.starts_with("## ") && !page.is_in_program() {
                section = Section::Page;
                page.heading(line, &mut rule.page, &mut mistakes);
            } else {
                match (section, rule.messages.last_mut()) {
                    (Section::Message, Some(message)) => message.read_line(line, &mut mistakes),
                    (Section::Page, _) => page.read_line(line, &mut rule.page, &mut mistakes),
                    _ => rule.read_head(line, &mut mistakes),
                }
            }
        }
        mistakes.line = 1;
        rule.missing = rule.messages.iter_mut().flat_map(Message::fill_in_english).collect();
        rule.missing.extend(rule.page.fill_in_english());
        rule.check(&mut mistakes);
        page::check(&mut rule.page, &mut mistakes);
        mistakes.found.sort_by_key(|mistake| mistake.line);
        if mistakes.found.is_empty() { Ok(rule) } else { Err(mistakes.found) }
    }

    fn read_head(&mut self, line: &str, mistakes: &mut Mistakes) {
        if line.trim().is_empty() {
            return;
        }
        if let Some(slug) = line.strip_prefix("# ") {
            slug.trim().clone_into(&mut self.slug);
            let is_slug =
                |letter: char| letter.is_ascii_lowercase() || letter.is_ascii_digit() || letter == '-';
            if !self.slug.chars().all(is_slug) {
                mistakes.add(format!("`{}` is not a slug: small letters, digits and hyphens", self.slug));
            }
            return;
        }
        let (key, value) = line.split_once(':').unwrap_or((line, ""));
        let value = value.trim();
        let mut named = |names: &[(&str, &'static str)]| {
            let found = names.iter().find(|name| name.0 == value).map(|name| name.1);
            if found.is_none() {
                let known: Vec<_> = names.iter().map(|name| name.0).collect();
                mistakes.add(format!("`{key}` is one of {}", known.join(", ")));
            }
            found
        };
        match key {
            "severity" => self.severity = named(&SEVERITIES).unwrap_or_default(),
            "kind" => self.kind = named(&KINDS).unwrap_or_default(),
            "group" => self.group = named(&GROUPS),
            "code" => self.code = Some(value.to_owned()),
            "alarm" => self.alarms = value.split(',').map(|alarm| alarm.trim().to_owned()).collect(),
            _ => mistakes.add(format!("not understood: {line}")),
        }
    }

    /// Checks that required fields are present and that fields are consistent.
    fn check(&self, mistakes: &mut Mistakes) {
        for (name, value) in [("# slug", &*self.slug), ("severity", self.severity), ("kind", self.kind)] {
            if value.is_empty() {
                mistakes.add(format!("no `{name}`"));
            }
        }
        if self.code.is_none() && self.alarms.is_empty() {
            mistakes.add("neither `code` nor `alarm`");
        }
        let starts_with = |letter: &str| self.code.as_ref().is_some_and(|code| code.starts_with(letter));
        if starts_with("W-") && self.severity == "Error" || starts_with("E-") && self.severity != "Error" {
            mistakes.add("the code of an error begins with `E-`, and no other");
        }
        if self.severity == "Off" && self.group.is_none() {
            mistakes.add("a rule that is off by default needs a `group`, or nobody finds it");
        }
        if self.messages.is_empty() {
            mistakes.add("no `## message Name`");
        }
        for message in &self.messages {
            message.check(mistakes);
            let tells_alarm = message.arguments.iter().any(|argument| argument.kind == Type::Alarm);
            if tells_alarm != (self.alarms.len() > 1) {
                let what = "an argument of the type `alarm` belongs to a rule with several alarms";
                mistakes.add_at(message.line, format!("{}: {what}", message.name));
            }
        }
    }
}

/// All rule files of the project in the folder `project`, sorted by name, each parsed or with its errors.
pub fn all(project: &str) -> Vec<(String, Result<RuleFile, Vec<Mistake>>)> {
    let folder = Path::new(project).join("src/rules");
    let entries = fs::read_dir(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let paths = entries.map(|entry| entry.unwrap_or_else(|error| panic!("{error}")).path());
    let mut paths: Vec<PathBuf> =
        paths.filter(|path| path.extension().is_some_and(|extension| extension == "md")).collect();
    paths.sort();
    let name = |path: &Path| path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    paths.retain(|path| name(path) != "README");
    paths
        .iter()
        .map(|path| {
            let name = name(path);
            let text =
                fs::read_to_string(path).map_err(|error| vec![Mistake { line: 1, what: error.to_string() }]);
            let rule = text.and_then(|text| RuleFile::read(&text)).and_then(|rule| match rule.slug == name {
                true => Ok(rule),
                false => Err(vec![Mistake {
                    line: 1,
                    what: format!("the heading is `{}`, the file `{name}`", rule.slug),
                }]),
            });
            (name, rule)
        })
        .collect()
}
