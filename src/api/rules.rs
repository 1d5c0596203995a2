//! The rows of a rule and its page.

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

/// The page of a rule, as `explain --format json` writes it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RulePage {
    /// The rule, with its default severity.
    #[serde(flatten)]
    pub rule: Rule,
    /// The name of the fault.
    pub title: &'static str,
    /// What the rule checks.
    pub what: &'static str,
    /// The consequence at the machine.
    pub why: &'static str,
    /// How to repair it.
    pub repair: &'static str,
    /// The setup of both programs; absent for the default.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub setup: Option<serde_json::Value>,
    /// A program that triggers the rule.
    pub wrong: &'static str,
    /// The corrected program.
    pub right: &'static str,
}
