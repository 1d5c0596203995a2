//! Every message with its arguments, and what is the same in all languages: code, slug,
//! severity, kind and alarm.
//!
//! In: a value of a type of [`said`]. Out: a [`Message`], which is the same for all: its number and its values,
//! so that what keeps, copies and compares messages knows none of them. The build script makes these types and
//! the table [`RULES`] from `src/rules/<slug>.md`. Knows no language.

use std::borrow::Cow;

use super::rule::{Group, Kind, Rule, Severity};
use crate::units::Diameter;

/// A word or number that a sentence quotes.
#[derive(Clone, Debug, PartialEq)]
pub enum Value<'a> {
    /// Words, as they are.
    Text(Cow<'a, str>),
    /// An address or an axis.
    Letter(char),
    /// A whole number.
    Count(i64),
    /// A measure, as people write it.
    Number(f64),
    /// A length, mm; or a feed, mm/min or mm/rev. It is shown in the unit of the program.
    Length(f64),
    /// The number of a program, in four digits at least.
    Program(u32),
    /// The alarm that a real control raises; no sentence quotes it.
    Alarm(&'static str),
}

impl Value<'_> {
    /// How many.
    pub fn count(count: usize) -> Self {
        Self::Count(i64::try_from(count).unwrap_or(i64::MAX))
    }

    /// The same value, its words where they are.
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

/// Values by the names that stand in templates.
pub type Arguments<'a> = Vec<(&'static str, Value<'a>)>;

/// A message to the user with its arguments.
#[derive(Clone, Debug, PartialEq)]
pub struct Message {
    /// Its place in the tables of messages.
    index: u16,
    /// Its arguments, in the order of `ARGUMENTS`; the alarm stands last.
    values: Box<[Value<'static>]>,
}

/// A type of [`said`].
pub trait Said: Into<Message> {
    /// Its place in the tables of messages.
    const INDEX: u16;
}

include!(concat!(env!("OUT_DIR"), "/message.rs"));

impl Message {
    /// The message of a number with its values.
    #[cold]
    #[inline(never)]
    fn of<const N: usize>(index: u16, values: [Value<'static>; N]) -> Self {
        Self { index, values: Box::new(values) }
    }

    /// Its place in the tables of messages.
    pub(crate) fn index(&self) -> usize {
        usize::from(self.index)
    }

    /// Whether it is a message of this type.
    pub fn is<M: Said>(&self) -> bool {
        self.index == M::INDEX
    }

    /// The alarm among its arguments.
    fn own_alarm(&self) -> Option<&'static str> {
        match self.values.last() {
            Some(Value::Alarm(alarm)) => Some(alarm),
            _ => None,
        }
    }

    /// The place of its rule in `RULES`.
    pub fn rule_index(&self) -> u16 {
        RULE_OF[self.index()]
    }

    /// The rule it belongs to.
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

    /// How severe it usually is.
    pub fn severity(&self) -> Severity {
        SEVERITIES[usize::from(self.rule_index())]
    }

    /// The alarm a real control raises.
    pub fn alarm(&self) -> Option<&'static str> {
        self.own_alarm().or_else(|| self.rule().alarms.first().copied())
    }

    /// Its category.
    pub fn kind(&self) -> Kind {
        self.rule().kind
    }

    /// The name of its type, by which the templates of a language are found.
    pub fn name(&self) -> &'static str {
        NAMES[self.index()]
    }

    /// The same with the lines that its sentences name as they are counted elsewhere.
    pub fn with_lines(mut self, elsewhere: impl Fn(i64) -> i64) -> Self {
        for (&name, value) in ARGUMENTS[self.index()].iter().zip(&mut self.values) {
            if let (true, Value::Count(line)) = (name == "line", value) {
                *line = elsewhere(*line);
            }
        }
        self
    }

    /// What its sentences quote, in the order of the rule file.
    pub fn arguments(&self) -> Arguments<'_> {
        ARGUMENTS[self.index()].iter().copied().zip(self.values.iter().map(Value::borrowed)).collect()
    }
}
