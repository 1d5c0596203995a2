//! Parses `gcode-playground.toml`.
//!
//! In: the text of a file. Out: its values, each with its line; or the first error, with its position and the
//! most similar valid key. Must not know: the programs that the values apply to.

use toml::Spanned;
use toml::de::{DeString, DeTable, DeValue};

use super::super::rules::{level, named};
use super::keys::{Key, OF_OVERRIDES, USUAL, VALUES};
use crate::message::Severity;
use crate::message::levels::{known, nearest_of};
use crate::sentences::Language;
use crate::setup::dialect::Control;

/// A value, and its line in the file, from 1.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::cli) struct Located<T> {
    /// The value.
    pub value: T,
    /// The line, from 1.
    pub line: u32,
}

/// The contents of a configuration file.
#[derive(Debug, Default, PartialEq)]
pub(in crate::cli) struct Keys {
    /// Values for all programs.
    pub usual: Values,
    /// Language of messages.
    pub language: Option<Located<Language>>,
    /// Endings of programs in folders.
    pub extension: Vec<Located<String>>,
    /// Patterns of excluded files, in the syntax of `.gitignore`.
    pub exclude: Vec<Located<String>>,
    /// Folders with subprograms.
    pub library: Vec<Located<String>>,
    /// Path of the list of known findings.
    pub baseline: Option<Located<String>>,
    /// Maximum number of warnings.
    pub max_warnings: Option<Located<usize>>,
    /// The address of the rule pages.
    pub rules_url: Option<Located<String>>,
    /// Values for some programs, in the order of the file.
    pub overrides: Vec<Override>,
}

/// Values for programs.
#[derive(Debug, Default, PartialEq)]
pub(in crate::cli) struct Values {
    /// The control.
    pub control: Option<Located<Control>>,
    /// Setup files: machines, tools.
    pub setup: Vec<Located<String>>,
    /// Rules to report; all others are not reported.
    pub select: Vec<Located<&'static str>>,
    /// Rules that are not reported.
    pub ignore: Vec<Located<&'static str>>,
    /// Severities of rules and groups.
    pub rules: Vec<Located<(&'static str, Severity)>>,
}

/// Values for the programs that match a pattern.
#[derive(Debug, Default, PartialEq)]
pub(in crate::cli) struct Override {
    /// Patterns of the programs, in the syntax of `.gitignore`.
    pub files: Vec<Located<String>>,
    /// Values for these programs.
    pub values: Values,
}

/// An error: byte offset in the file, and message.
type Fault = (usize, String);

/// Parses a file; an error message begins with line and column.
pub(super) fn read(text: &str) -> Result<Keys, String> {
    let lines = Lines(text);
    let placed = |(at, problem): Fault| {
        let (line, column) = lines.place(at);
        format!("{line}:{column}: {problem}")
    };
    let table = DeTable::parse(text).map_err(|error| {
        let at = error.span().map_or(0, |span| span.start);
        placed((at, error.message().to_owned()))
    })?;
    keys(table.get_ref(), &lines).map_err(placed)
}

fn keys(table: &DeTable<'_>, lines: &Lines<'_>) -> Result<Keys, Fault> {
    let mut keys = Keys::default();
    for (key, value) in table {
        match key.get_ref().as_ref() {
            "language" => keys.language = Some(lines.said(value, language(value)?)),
            "extension" => {
                let said = texts(value, lines)?;
                let each = |one: Located<String>| {
                    let endings: Vec<_> =
                        one.value.split(',').map(|ending| ending.trim().to_owned()).collect();
                    endings.into_iter().map(move |value| Located { value, line: one.line })
                };
                keys.extension = said.into_iter().flat_map(each).collect();
            }
            "exclude" => keys.exclude = texts(value, lines)?,
            "library" => keys.library = texts(value, lines)?,
            "baseline" => keys.baseline = Some(lines.said(value, text(value)?.to_owned())),
            "max-warnings" => keys.max_warnings = Some(lines.said(value, count(value)?)),
            "rules-url" => keys.rules_url = Some(lines.said(value, address(value)?)),
            "override" => keys.overrides = overrides(value, lines)?,
            _ => keys.usual.read(key, value, lines, &USUAL)?,
        }
    }
    Ok(keys)
}

fn overrides(value: &Spanned<DeValue<'_>>, lines: &Lines<'_>) -> Result<Vec<Override>, Fault> {
    let wrong = |at: usize| (at, "write each of them as a table of its own: [[override]]".to_owned());
    let DeValue::Array(list) = value.get_ref() else { return Err(wrong(value.span().start)) };
    let mut overrides = Vec::new();
    for one in list {
        let DeValue::Table(table) = one.get_ref() else { return Err(wrong(one.span().start)) };
        let mut read = Override::default();
        for (key, value) in table {
            match key.get_ref().as_ref() {
                "files" => read.files = texts(value, lines)?,
                _ => read.values.read(key, value, lines, &OF_OVERRIDES)?,
            }
        }
        if read.files.is_empty() {
            return Err((one.span().start, "an override names its files: files = [\"gsk/**\"]".to_owned()));
        }
        overrides.push(read);
    }
    Ok(overrides)
}

impl Values {
    /// Reads a key; `others` are the other keys allowed here, for suggestions.
    fn read(
        &mut self,
        key: &Spanned<DeString<'_>>,
        value: &Spanned<DeValue<'_>>,
        lines: &Lines<'_>,
        others: &[Key],
    ) -> Result<(), Fault> {
        match key.get_ref().as_ref() {
            "control" => self.control = Some(lines.said(value, control(value)?)),
            "setup" => self.setup = texts(value, lines)?,
            "select" => self.select = rules(value, lines)?,
            "ignore" => self.ignore = rules(value, lines)?,
            "rules" => self.rules = levels(value, lines)?,
            unknown => {
                let keys = VALUES.iter().chain(others).map(|key| key.name);
                let near = nearest_of(unknown, keys)
                    .map_or_else(String::new, |near| format!("; the nearest is `{near}`"));
                return Err((key.span().start, format!("there is no key `{unknown}`{near}")));
            }
        }
        Ok(())
    }
}

/// Rules from a list, by slug or code.
fn rules(value: &Spanned<DeValue<'_>>, lines: &Lines<'_>) -> Result<Vec<Located<&'static str>>, Fault> {
    let mut rules = Vec::new();
    for one in list(value) {
        let slugs = named(text(one)?).map_err(|problem| (one.span().start, problem))?;
        rules.extend(slugs.into_iter().map(|slug| lines.said(one, slug)));
    }
    Ok(rules)
}

/// Severities from a table.
fn levels(
    value: &Spanned<DeValue<'_>>,
    lines: &Lines<'_>,
) -> Result<Vec<Located<(&'static str, Severity)>>, Fault> {
    let DeValue::Table(table) = value.get_ref() else {
        return Err((value.span().start, "write it as a table: [rules], then `rule = \"level\"`".to_owned()));
    };
    let mut levels = Vec::new();
    for (key, value) in table {
        let name = key.get_ref().as_ref();
        let slugs = match known(name) {
            Some(name) => vec![name],
            None => named(name).map_err(|problem| (key.span().start, problem))?,
        };
        let level = level(text(value)?).map_err(|problem| (value.span().start, problem))?;
        levels.extend(slugs.into_iter().map(|slug| lines.said(value, (slug, level))));
    }
    Ok(levels)
}

fn control(value: &Spanned<DeValue<'_>>) -> Result<Control, Fault> {
    one_of("control", value, Control::ALL, Control::name)
}

fn language(value: &Spanned<DeValue<'_>>) -> Result<Language, Fault> {
    one_of("language", value, Language::ALL, Language::tag)
}

/// Looks up a value by its name.
fn one_of<T: Copy, const COUNT: usize>(
    what: &str,
    value: &Spanned<DeValue<'_>>,
    all: [T; COUNT],
    name: fn(T) -> &'static str,
) -> Result<T, Fault> {
    let written = text(value)?;
    all.into_iter().find(|one| name(*one) == written).ok_or_else(|| {
        let names = all.map(name).join(", ");
        (value.span().start, format!("there is no {what} `{written}`; there are {names}"))
    })
}

fn address(value: &Spanned<DeValue<'_>>) -> Result<String, Fault> {
    web_address(text(value)?).map_err(|problem| (value.span().start, problem))
}

/// An address of the web, checked only as far as a report needs it.
pub(in crate::cli) fn web_address(text: &str) -> Result<String, String> {
    let is_printable = !text.contains(|letter: char| letter.is_whitespace() || letter.is_control());
    match text.starts_with("https://") || text.starts_with("http://") {
        true if is_printable => Ok(text.to_owned()),
        _ => Err("write an address that begins with https://".to_owned()),
    }
}

fn count(value: &Spanned<DeValue<'_>>) -> Result<usize, Fault> {
    let number = match value.get_ref() {
        DeValue::Integer(number) => usize::from_str_radix(number.as_str(), number.radix()).ok(),
        _ => None,
    };
    number.ok_or_else(|| (value.span().start, "write a whole number, 0 or more".to_owned()))
}

/// One string, or an array of strings.
fn texts(value: &Spanned<DeValue<'_>>, lines: &Lines<'_>) -> Result<Vec<Located<String>>, Fault> {
    list(value).map(|one| Ok(lines.said(one, text(one)?.to_owned()))).collect()
}

/// The elements of an array; a single value counts as an array of one.
fn list<'a, 'b>(value: &'a Spanned<DeValue<'b>>) -> Box<dyn Iterator<Item = &'a Spanned<DeValue<'b>>> + 'a> {
    match value.get_ref() {
        DeValue::Array(list) => Box::new(list.iter()),
        _ => Box::new(std::iter::once(value)),
    }
}

fn text<'a>(value: &'a Spanned<DeValue<'_>>) -> Result<&'a str, Fault> {
    match value.get_ref() {
        DeValue::String(text) => Ok(text.as_ref()),
        _ => Err((value.span().start, "write a text in quotes".to_owned())),
    }
}

/// Finds lines and columns of byte offsets in a text.
struct Lines<'a>(&'a str);

impl Lines<'_> {
    fn said<T>(&self, from: &Spanned<DeValue<'_>>, value: T) -> Located<T> {
        Located { value, line: self.place(from.span().start).0 }
    }

    /// Line and column of a byte offset, from 1; columns count characters.
    fn place(&self, at: usize) -> (u32, usize) {
        let before = self.0.get(..at).unwrap_or(self.0);
        let start = before.rfind('\n').map_or(0, |end| end + 1);
        (before.matches('\n').count() as u32 + 1, before[start..].chars().count() + 1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_says_what_holds_with_the_lines() {
        let keys = read(concat!(
            "control = \"gsk\"\nsetup = [\"machine.json\",\n \"tools.toml\"]\nmax-warnings = 3\n",
            "[rules]\nrapid-through-stock = \"error\"\n[[override]]\nfiles = \"fanuc/**\"\ncontrol = \"fanuc\"\n",
        ))
        .expect("it is right");
        assert_eq!(keys.usual.control, Some(Located { value: Control::Gsk, line: 1 }));
        let setup = [("machine.json", 2), ("tools.toml", 3)];
        assert_eq!(keys.usual.setup, setup.map(|(name, line)| Located { value: name.to_owned(), line }));
        assert_eq!(keys.usual.rules, [Located { value: ("rapid-through-stock", Severity::Error), line: 6 }]);
        assert_eq!(keys.max_warnings, Some(Located { value: 3, line: 4 }));
        assert_eq!(keys.overrides[0].files, [Located { value: "fanuc/**".to_owned(), line: 8 }]);
        assert_eq!(keys.overrides[0].values.control, Some(Located { value: Control::Fanuc, line: 9 }));
    }

    #[test]
    fn what_is_wrong_is_said_with_its_place() {
        for (text, problem) in [
            ("\n controls = \"gsk\"", "2:2: there is no key `controls`; the nearest is `control`"),
            ("control = \"siemens\"", "1:11: there is no control `siemens`; there are fanuc, gsk, forum"),
            ("control = 3", "1:11: write a text in quotes"),
            ("language = \"de\"", "1:12: there is no language `de`; there are en, zh, ru"),
            (
                "[rules]\nrapid-trough-stock = \"error\"",
                "2:1: there is no rule `rapid-trough-stock`; the nearest is `rapid-through-stock`",
            ),
            (
                "[rules]\nrapid-through-stock = \"bad\"",
                "2:23: `bad` is no level of a rule; it can be off, info, warning or error",
            ),
            ("rules = 3", "1:9: write it as a table: [rules], then `rule = \"level\"`"),
            ("max-warnings = -1", "1:16: write a whole number, 0 or more"),
            ("rules-url = \"rules\"", "1:13: write an address that begins with https://"),
            ("[override]\nfiles = \"a\"", "1:1: write each of them as a table of its own: [[override]]"),
            ("[[override]]\ncontrol = \"gsk\"", "1:1: an override names its files: files = [\"gsk/**\"]"),
            ("[[override]]\nfile = \"a\"", "2:1: there is no key `file`; the nearest is `files`"),
            ("select = [\"nothing-such\"]", "1:11: there is no rule `nothing-such`"),
        ] {
            let said = read(text).expect_err(text);
            assert!(said.starts_with(problem), "{text}: {said}");
        }
        assert!(read("control = ").is_err_and(|problem| problem.starts_with("1:")));
    }
}
