//! The row of a rule.

use serde::Serialize;

use crate::message;
use crate::message::Severity;

/// A rule, as `rules --format json` lists it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Rule {
    /// Stable name of the fault.
    pub slug: &'static str,
    /// The codes of its messages.
    pub codes: &'static [&'static str],
    /// The severity under a setup.
    pub severity: &'static str,
    /// Whether the program is wrong, the playground does not support something, or it depends on the machine.
    pub kind: &'static str,
    /// The alarms that controls raise.
    pub alarms: &'static [&'static str],
}

impl Rule {
    /// The row of a rule, with its severity under a setup.
    pub fn new(rule: &message::Rule, severity: Severity) -> Self {
        let &message::Rule { slug, codes, kind, alarms, .. } = rule;
        Self { slug, codes, severity: severity.name(), kind: kind.name(), alarms }
    }
}
