//! Messages with their arguments, and properties that no language changes: code, slug, severity, kind, alarm.
//!
//! In: a value of a type of [`said`]. Out: a [`Message`]: an index and values, one type for all messages, so
//! that code that stores, copies and compares messages does not depend on each of them. The build script
//! generates the types of [`said`] and the table [`RULES`] from `src/rules/<slug>.md`. Independent of the
//! language.

use std::borrow::Cow;

use super::rule::{Group, Kind, Rule, Severity};
use crate::units::Diameter;

/// An argument of a message.
#[derive(Clone, Debug, PartialEq)]
pub enum Value<'a> {
    /// Text, used verbatim.
    Text(Cow<'a, str>),
    /// An address or an axis.
    Letter(char),
    /// An integer.
    Count(i64),
    /// A number in the usual notation.
    Number(f64),
    /// A length, mm; or a feed, mm/min or mm/rev. Displayed in the unit of the program.
    Length(f64),
    /// A program number, displayed with at least four digits.
    Program(u32),
    /// The alarm of a real control; not used in sentences.
    Alarm(&'static str),
}

impl Value<'_> {
    /// A count.
    pub fn count(count: usize) -> Self {
        Self::Count(i64::try_from(count).unwrap_or(i64::MAX))
    }

    /// A copy that borrows the text.
    fn borrowed(&self) -> Value<'_> {
        match *self {
            Self::Text(ref text) => Value::Text(Cow::Borrowed(text)),
            Self::Letter(letter) => Value::Letter(letter),
            Self::Count(count) => Value::Count(count),
            Self::Number(number) => Value::Number(number),
            Self::Length(length) => Value::Length(length),
            Self::Program(program) => Value::Program(program),
            Self::Alarm(alarm) => Value::Alarm(alarm),
        }
    }
}

/// Arguments by their names in templates.
pub type Arguments<'a> = Vec<(&'static str, Value<'a>)>;

/// A message to the user with its arguments.
#[derive(Clone, Debug, PartialEq)]
pub struct Message {
    /// Index in the tables of messages.
    index: u16,
    /// Its arguments, in the order of `ARGUMENTS`; the alarm comes last.
    values: Box<[Value<'static>]>,
}

/// A type of [`said`].
pub trait Said: Into<Message> {
    /// Index in the tables of messages.
    const INDEX: u16;
}

include!(concat!(env!("OUT_DIR"), "/message.rs"));

impl Message {
    /// Creates a message from its index and values.
    #[cold]
    #[inline(never)]
    fn of<const N: usize>(index: u16, values: [Value<'static>; N]) -> Self {
        Self { index, values: Box::new(values) }
    }

    /// Index in the tables of messages.
    pub(crate) fn index(&self) -> usize {
        usize::from(self.index)
    }

    /// Whether the message has this type.
    pub fn is<M: Said>(&self) -> bool {
        self.index == M::INDEX
    }

    /// The alarm in the arguments, if any.
    fn own_alarm(&self) -> Option<&'static str> {
        match self.values.last() {
            Some(Value::Alarm(alarm)) => Some(alarm),
            _ => None,
        }
    }

    /// Index of its rule in `RULES`.
    pub fn rule_index(&self) -> u16 {
        RULE_OF[self.index()]
    }

    /// The rule of the message.
    pub fn rule(&self) -> &'static Rule {
        &RULES[usize::from(self.rule_index())]
    }

    /// Stable code: an identifier of this project, or the number of the alarm.
    pub fn code(&self) -> &'static str {
        match (self.own_alarm(), self.rule().codes) {
            (_, [code]) => code,
            (Some(alarm), _) => alarm,
            (None, codes) => codes.first().copied().unwrap_or_default(),
        }
    }

    /// Stable name of the fault.
    pub fn slug(&self) -> &'static str {
        self.rule().slug
    }

    /// Default severity.
    pub fn severity(&self) -> Severity {
        SEVERITIES[usize::from(self.rule_index())]
    }

    /// The alarm of a real control, if any.
    pub fn alarm(&self) -> Option<&'static str> {
        self.own_alarm().or_else(|| self.rule().alarms.first().copied())
    }

    /// Category.
    pub fn kind(&self) -> Kind {
        self.rule().kind
    }

    /// Name of the type, the key of its templates.
    pub fn name(&self) -> &'static str {
        NAMES[self.index()]
    }

    /// Converts the line numbers in its arguments.
    pub fn with_lines(mut self, elsewhere: impl Fn(i64) -> i64) -> Self {
        for (&name, value) in ARGUMENTS[self.index()].iter().zip(&mut self.values) {
            if let (true, Value::Count(line)) = (name == "line", value) {
                *line = elsewhere(*line);
            }
        }
        self
    }

    /// Its arguments, in the order of the rule file.
    pub fn arguments(&self) -> Arguments<'_> {
        ARGUMENTS[self.index()].iter().copied().zip(self.values.iter().map(Value::borrowed)).collect()
    }
}
