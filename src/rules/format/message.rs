//! A message of a rule: its name, its arguments, and its sentences in all languages.

use super::{LANGUAGES, Mistake, Mistakes};

/// A message; becomes a type in `message::said`.
#[derive(Clone, Debug, Default)]
pub struct Message {
    /// The line of its heading, from 1.
    pub line: usize,
    /// The name of the variant.
    pub name: String,
    /// When the message is reported, in one sentence.
    pub doc: String,
    /// The arguments of its sentences.
    pub arguments: Vec<Argument>,
    /// The sentence in each language, in the order of `LANGUAGES`.
    pub sentences: [Sentence; 3],
}

/// The text of a message in one language.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Sentence {
    /// The template of the message, a self-contained sentence.
    pub message: String,
    /// The template of the help: the reason, and what to do.
    pub help: Option<String>,
}

/// A word or number that is inserted into the sentences.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Argument {
    /// The name of the field, and of the placeholder in the templates.
    pub name: String,
    /// The type of the argument.
    pub kind: Type,
    /// An example value, as in a real program; empty for an alarm.
    pub sample: String,
    /// Meaning and unit.
    pub doc: String,
}

/// The type of an argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Type {
    /// An address or an axis.
    Letter,
    /// Text from the program or the setup.
    Text,
    /// A code or a name from the source code of the project.
    Word,
    /// A number of things.
    Count,
    /// The number of a line, a block or a variable.
    Index,
    /// The number of a program, shown with at least four digits.
    Program,
    /// A signed integer.
    Integer,
    /// A quantity with a fixed unit.
    Number,
    /// A length, mm, or a feed, mm/min or mm/rev; shown in the unit of the program.
    Length,
    /// An X value as a diameter, mm; shown in the unit of the program.
    Diameter,
    /// The alarm of the control, one of the alarms of the rule; not inserted into sentences.
    Alarm,
}

impl Type {
    /// All types by their names in a rule file.
    pub const NAMES: [(&str, Type); 11] = [
        ("letter", Self::Letter),
        ("text", Self::Text),
        ("word", Self::Word),
        ("count", Self::Count),
        ("index", Self::Index),
        ("program", Self::Program),
        ("integer", Self::Integer),
        ("number", Self::Number),
        ("length", Self::Length),
        ("diameter", Self::Diameter),
        ("alarm", Self::Alarm),
    ];

    /// The name in a rule file.
    pub fn name(self) -> &'static str {
        Self::NAMES.iter().find(|known| known.1 == self).map_or("", |known| known.0)
    }

    /// Whether a sample is a valid value of this type.
    fn takes(self, sample: &str) -> bool {
        match self {
            Self::Letter => sample.chars().count() == 1,
            Self::Text | Self::Word => !sample.is_empty(),
            Self::Count | Self::Index | Self::Program => sample.parse::<u32>().is_ok(),
            Self::Integer => sample.parse::<i64>().is_ok(),
            Self::Number | Self::Length | Self::Diameter => sample.parse::<f64>().is_ok_and(f64::is_finite),
            Self::Alarm => sample.is_empty(),
        }
    }
}

/// The placeholder for the program's unit of length, allowed in every template.
pub const UNIT: &str = "mm";

impl Message {
    pub(super) fn new(name: &str, line: usize, mistakes: &mut Mistakes) -> Self {
        let is_name = name.starts_with(|letter: char| letter.is_ascii_uppercase())
            && name.chars().all(|letter| letter.is_ascii_alphanumeric());
        if !is_name {
            mistakes.add(format!("`{name}` is not a name in Rust, such as `NumberMissing`"));
        }
        Self { line, name: name.to_owned(), ..Self::default() }
    }

    pub(super) fn read_line(&mut self, line: &str, mistakes: &mut Mistakes) {
        if line.trim().is_empty() {
            return;
        }
        if let Some(argument) = line.strip_prefix("* ") {
            match read_argument(argument) {
                Ok(argument) if self.arguments.iter().any(|known| known.name == argument.name) => {
                    mistakes.add(format!("a second argument `{}`", argument.name));
                }
                Ok(argument) => self.arguments.push(argument),
                Err(what) => mistakes.add(what),
            }
            return;
        }
        let said = LANGUAGES.iter().position(|tag| line.starts_with(tag)).and_then(|index| {
            let rest = &line[LANGUAGES[index].len()..];
            let (what, text) = rest.split_once(':')?;
            matches!(what, "" | " help").then_some((index, what, text.trim()))
        });
        match said {
            Some((index, "", text)) if self.sentences[index].message.is_empty() => {
                text.clone_into(&mut self.sentences[index].message);
            }
            Some((index, " help", text)) if self.sentences[index].help.is_none() => {
                self.sentences[index].help = Some(text.to_owned());
            }
            Some(_) => mistakes.add("this was said before"),
            None if self.doc.is_empty() => line.trim().clone_into(&mut self.doc),
            None => mistakes.add("neither `* argument: type`, nor `en:`, `en help:`, `zh:` …"),
        }
    }

    /// Uses the English message or help for languages without one; returns what was missing.
    pub(super) fn fill_in_english(&mut self) -> Vec<Mistake> {
        let (line, [english, others @ ..]) = (self.line, &mut self.sentences);
        let mut missing = Vec::new();
        for (said, tag) in others.iter_mut().zip(&LANGUAGES[1..]) {
            let what = if said.message.is_empty() {
                said.clone_from(english);
                ""
            } else if said.help.is_none() && english.help.is_some() {
                said.help.clone_from(&english.help);
                " help"
            } else {
                continue;
            };
            missing.push(Mistake { line, what: format!("{}: no `{tag}{what}:`", self.name) });
        }
        missing
    }

    /// Checks that there is a text in every language, and that its placeholders are exactly the arguments.
    pub(super) fn check(&self, mistakes: &mut Mistakes) {
        let mut add = |what: String| mistakes.add_at(self.line, format!("{}: {what}", self.name));
        if self.doc.is_empty() {
            add("no line says when it is given".to_owned());
        }
        let quoted = self.sentences.each_ref().map(Sentence::quoted);
        for (index, tag) in LANGUAGES.iter().enumerate() {
            let Sentence { message, help } = &self.sentences[index];
            if message.is_empty() {
                add(format!("no `{tag}:`"));
                continue;
            }
            if help.is_some() != self.sentences[0].help.is_some() {
                add(format!("`{tag} help:` exists in one language only"));
            }
            if help.as_ref().is_some_and(String::is_empty) {
                add(format!("`{tag} help:` is empty"));
            }
            for name in &quoted[index] {
                let known = |argument: &Argument| argument.name == *name && argument.kind != Type::Alarm;
                if *name != UNIT && !self.arguments.iter().any(known) {
                    add(format!("`{tag}` quotes {{{name}}}, which is no argument"));
                }
            }
            for argument in self.arguments.iter().filter(|argument| argument.kind != Type::Alarm) {
                if !quoted[index].contains(&argument.name.as_str()) {
                    add(format!("`{tag}` does not quote {{{}}}", argument.name));
                }
            }
        }
    }
}

impl Sentence {
    /// The names of the placeholders, without duplicates.
    fn quoted(&self) -> Vec<&str> {
        let help = self.help.as_deref().unwrap_or_default();
        let parts = self.message.split('{').skip(1).chain(help.split('{').skip(1));
        // An unclosed bracket gives a name that is not an argument, so `check` reports it.
        let mut names: Vec<&str> =
            parts.map(|part| part.split_once('}').map_or(part, |(name, _)| name)).collect();
        names.sort_unstable();
        names.dedup();
        names
    }
}

/// Parses ``name: type `sample`. Meaning``; an alarm has no sample.
fn read_argument(line: &str) -> Result<Argument, String> {
    const FORM: &str = "an argument is written ``* name: type `sample`. Meaning and unit.``";
    let (name, rest) = line.split_once(": ").ok_or(FORM)?;
    let (head, doc) = match rest.split_once('`') {
        Some((kind, rest)) if !kind.contains('.') => {
            let (sample, doc) = rest.split_once('`').ok_or(FORM)?;
            ((kind.trim(), sample), doc.strip_prefix(". ").ok_or(FORM)?)
        }
        _ => {
            let (kind, doc) = rest.split_once(". ").ok_or(FORM)?;
            ((kind, ""), doc)
        }
    };
    let (kind, sample) = head;
    let kind = Type::NAMES.iter().find(|known| known.0 == kind).map(|known| known.1);
    let kind = kind.ok_or_else(|| {
        let names: Vec<_> = Type::NAMES.iter().map(|known| known.0).collect();
        format!("`{}` is none of the types {}", head.0, names.join(", "))
    })?;
    let is_name = name.starts_with(|letter: char| letter.is_ascii_lowercase())
        && name.chars().all(|letter| letter.is_ascii_lowercase() || letter.is_ascii_digit() || letter == '_');
    if !is_name || name == UNIT {
        return Err(format!("`{name}` cannot be the name of an argument"));
    }
    if !kind.takes(sample) {
        return Err(format!("`{sample}` is no {}", kind.name()));
    }
    if (kind == Type::Alarm) != (name == "alarm") {
        return Err("an argument of the type `alarm` is called `alarm`, and no other is".to_owned());
    }
    Ok(Argument { name: name.to_owned(), kind, sample: sample.to_owned(), doc: doc.trim().to_owned() })
}
