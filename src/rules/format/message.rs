//! A message of a rule: its name, its arguments, and its sentences in all languages.

use super::{LANGUAGES, Mistake, Mistakes};

/// A message: a type of `message::said`.
#[derive(Clone, Debug, Default)]
pub struct Message {
    /// The line of its heading, from 1.
    pub line: usize,
    /// The name of the variant.
    pub name: String,
    /// When it is given, in one sentence.
    pub doc: String,
    /// What its sentences quote.
    pub arguments: Vec<Argument>,
    /// What is said in each language, in the order of `LANGUAGES`.
    pub sentences: [Sentence; 3],
}

/// What a message says in one language.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Sentence {
    /// The template of a sentence that stands alone.
    pub message: String,
    /// The template of why, and what to do.
    pub help: Option<String>,
}

/// A word or number that sentences quote.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Argument {
    /// Its name: that of the field, and in the templates.
    pub name: String,
    /// What it is.
    pub kind: Type,
    /// A value, as it would be in a program; empty for an alarm.
    pub sample: String,
    /// Meaning and unit.
    pub doc: String,
}

/// What an argument is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Type {
    /// An address or an axis.
    Letter,
    /// Words of the program or the setup.
    Text,
    /// A code or a name that the source of the project contains.
    Word,
    /// How many.
    Count,
    /// The number of a line, a block, a variable.
    Index,
    /// The number of a program, shown in four digits at least.
    Program,
    /// A whole number with a sign.
    Integer,
    /// A measure in a unit of its own.
    Number,
    /// A length, mm, or a feed, mm per minute or turn: shown in the unit of the program.
    Length,
    /// A length across the spindle axis as a diameter, mm: shown in the unit of the program.
    Diameter,
    /// The alarm of the control, one of those of the rule; not quoted.
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

    /// Its name in a rule file.
    pub fn name(self) -> &'static str {
        Self::NAMES.iter().find(|known| known.1 == self).map_or("", |known| known.0)
    }

    /// Whether a sample can be read as a value of this type.
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

/// The name of the program's unit of length, which every template may quote.
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

    /// Puts the English sentence or help where a language has none; returns what was missing.
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

    /// Checks that all languages say it, and quote all arguments and nothing else.
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
    /// The names in brackets, each once.
    fn quoted(&self) -> Vec<&str> {
        let help = self.help.as_deref().unwrap_or_default();
        let parts = self.message.split('{').skip(1).chain(help.split('{').skip(1));
        // A bracket that is not closed is a name that is no argument.
        let mut names: Vec<&str> =
            parts.map(|part| part.split_once('}').map_or(part, |(name, _)| name)).collect();
        names.sort_unstable();
        names.dedup();
        names
    }
}

/// Reads ``name: type `sample`. Meaning``; of an alarm there is no sample.
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
