//! Every message with its arguments, and what is the same in all languages: code, slug,
//! severity, kind and alarm.
//!
//! In: nothing. Out: the enum [`Message`] and the table [`RULES`], which the build script makes from
//! `src/rules/<slug>.md`. Knows no language.

use super::rule::{Group, Kind, Rule, Severity};
use crate::units::Diameter;

/// A word or number that a sentence quotes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value<'a> {
    /// Words, as they are.
    Text(&'a str),
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
}

/// Values by the names that stand in templates.
pub type Arguments<'a> = Vec<(&'static str, Value<'a>)>;

include!(concat!(env!("OUT_DIR"), "/message.rs"));

impl Message {
    /// The rule it belongs to.
    pub fn rule(&self) -> &'static Rule {
        &RULES[usize::from(RULE_OF[self.index()])]
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
        self.rule().severity
    }

    /// The alarm a real control raises.
    pub fn alarm(&self) -> Option<&'static str> {
        self.own_alarm().or_else(|| self.rule().alarms.first().copied())
    }

    /// Its category.
    pub fn kind(&self) -> Kind {
        self.rule().kind
    }

    /// The name of the variant, by which the templates of a language are found.
    pub fn name(&self) -> &'static str {
        NAMES[self.index()]
    }

    /// What its sentences quote, in the order of the rule file.
    pub fn arguments(&self) -> Arguments<'_> {
        ARGUMENTS[self.index()].iter().copied().zip(self.values()).collect()
    }
}
