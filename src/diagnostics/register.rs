//! The list of all rules: what the messages are known by.
//!
//! In: a message of every wording. Out: one row for each slug. The list is made from the messages themselves, so it
//! cannot say anything else than they do; a test finds a message without a sample.

use super::message::{Kind, Severity};
use super::messages::samples::samples;

/// A rule: what all messages of one slug have in common.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Rule {
    /// Stable name of the fault.
    pub slug: &'static str,
    /// Codes its messages have; mostly one.
    pub codes: Vec<&'static str>,
    /// How grave it usually is.
    pub severity: Severity,
    /// Whose matter it is.
    pub kind: Kind,
    /// Alarms a control raises for it; mostly one or none.
    pub alarms: Vec<&'static str>,
}

/// All rules, in the order of the messages.
pub fn register() -> Vec<Rule> {
    let mut rules: Vec<Rule> = Vec::new();
    for message in samples() {
        let (severity, kind) = (message.severity(), message.kind());
        let slug = message.slug();
        let at = rules.iter().position(|rule| rule.slug == slug).unwrap_or_else(|| {
            rules.push(Rule { slug, codes: Vec::new(), severity, kind, alarms: Vec::new() });
            rules.len() - 1
        });
        let Some(rule) = rules.get_mut(at) else { continue };
        if !rule.codes.contains(&message.code()) {
            rule.codes.push(message.code());
        }
        rule.alarms.extend(message.alarm().filter(|alarm| !rule.alarms.contains(alarm)));
    }
    rules
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn messages_of_one_slug_are_of_one_rule() {
        let rules = register();
        for message in samples() {
            let slug = message.slug();
            let rule = rules.iter().find(|rule| rule.slug == slug).expect(slug);
            assert_eq!((rule.severity, rule.kind), (message.severity(), message.kind()), "{slug}");
            let is_name =
                |letter: char| letter.is_ascii_lowercase() || letter.is_ascii_digit() || letter == '-';
            assert!(slug.chars().all(is_name), "{slug}");
        }
    }
}
