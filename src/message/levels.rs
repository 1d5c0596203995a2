//! Severities that a setup sets for rules, instead of their defaults.
//!
//! In: names of rules or groups, each with a severity. Out: diagnostics with the configured severity; those
//! of rules set to `off` are dropped. Affects messages only, never the motions.

use std::collections::BTreeMap;

use serde::de::{Deserialize, Deserializer, Error, MapAccess, Visitor};
use strsim::levenshtein;

use super::diagnostic::Diagnostic;
use super::rule::{Group, Severity};
use super::variants::RULES;
use crate::parts::early;

/// Configured severities, by the name of a rule or a group.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Levels(BTreeMap<&'static str, Severity>);

impl Levels {
    /// Sets the severity of a rule or a group; the name is case-insensitive. Returns false if the name is
    /// unknown.
    pub fn set(&mut self, name: &str, level: Severity) -> bool {
        known(name).map(|name| self.0.insert(name, level)).is_some()
    }

    /// Removes the entry with exactly this name.
    pub fn unset(&mut self, name: &str) {
        self.0.remove(name);
    }

    /// The rules set to `off` by their own name, sorted by name.
    pub fn rules_off(&self) -> impl Iterator<Item = &'static str> {
        let is_group = |name: &str| Group::ALL.iter().any(|group| group.name() == name);
        self.iter()
            .filter(move |(name, level)| *level == Severity::Off && !is_group(name))
            .map(|(name, _)| name)
    }

    /// The entry with exactly this name.
    pub fn get(&self, name: &str) -> Option<Severity> {
        self.0.get(name).copied()
    }

    /// The severity of a rule. An entry for the rule overrides one for its group.
    pub fn of(&self, slug: &str) -> Option<Severity> {
        let group = || RULES.iter().find(|rule| rule.slug == slug)?.group;
        self.get(slug).or_else(|| self.get(group()?.name()))
    }

    /// Applies the severity to a diagnostic; `None` if its rule is off.
    pub fn apply_to(&self, mut diagnostic: Diagnostic) -> Option<Diagnostic> {
        if !self.0.is_empty()
            && let Some(level) = level_of(self, &diagnostic)
        {
            diagnostic.severity = level;
        }
        (diagnostic.severity > Severity::Off).then_some(diagnostic)
    }

    /// Merges with `others`, which take precedence. An entry for a group there also overrides entries for its
    /// rules here.
    pub fn with(mut self, others: &Self) -> Self {
        for rule in &RULES {
            if rule.group.is_some_and(|group| others.get(group.name()).is_some()) {
                self.0.remove(rule.slug);
            }
        }
        self.0.extend(&others.0);
        self
    }

    /// Removes the entries for groups.
    pub fn without_groups(mut self) -> Self {
        self.0.retain(|name, _| Group::ALL.iter().all(|group| group.name() != *name));
        self
    }

    /// Whether there are no entries.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Names and severities, sorted by name.
    pub fn iter(&self) -> impl Iterator<Item = (&'static str, Severity)> {
        self.0.iter().map(|(name, level)| (*name, *level))
    }
}

early! {
    /// The configured severity of a diagnostic.
    fn level_of(levels: &Levels, told: &Diagnostic) -> Option<Severity> {
        levels.of(told.message.slug())
    }
}

/// Valid names: of rules and groups.
fn names() -> impl Iterator<Item = &'static str> {
    RULES.iter().map(|rule| rule.slug).chain(Group::ALL.map(Group::name))
}

/// The canonical name of a rule or group; case-insensitive.
pub fn known(name: &str) -> Option<&'static str> {
    names().find(|known| known.eq_ignore_ascii_case(name))
}

/// The most similar name of a rule or group; `None` if no name is similar.
pub fn nearest(name: &str) -> Option<&'static str> {
    nearest_of(name, names())
}

/// The most similar of some names; `None` if none is similar.
pub fn nearest_of<'a>(name: &str, names: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    let name = name.to_ascii_lowercase();
    // Longer names are no misspellings, and the limit bounds the work.
    const LONGEST: usize = 60;
    if name.len() > LONGEST {
        return None;
    }
    let near = names.map(|known| (levenshtein(&name, known), known)).min()?;
    (near.0 <= name.chars().count().div_ceil(2)).then_some(near.1)
}

impl<'de> Deserialize<'de> for Levels {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_map(Rules)
    }
}

#[cfg(feature = "cli")]
impl schemars::JsonSchema for Levels {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "Levels".into()
    }

    fn inline_schema() -> bool {
        true
    }

    fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
        schemars::json_schema!({
            "type": "object",
            "propertyNames": {"enum": names().collect::<Vec<_>>()},
            "additionalProperties": {"enum": Severity::ALL.map(Severity::name)},
        })
    }
}

/// Deserializes `{"slug": "level"}`.
struct Rules;

impl<'de> Visitor<'de> for Rules {
    type Value = Levels;

    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("an object of rules, each with its level")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Levels, A::Error> {
        let mut levels = Levels::default();
        while let Some((name, level)) = map.next_entry::<String, String>()? {
            let Some(level) = Severity::named(&level) else {
                let levels = "it can be off, info, warning or error";
                return Err(Error::custom(format_args!("`{level}` is no level of a rule; {levels}")));
            };
            if !levels.set(&name, level) {
                let near =
                    nearest(&name).map_or_else(String::new, |near| format!("; the nearest is `{near}`"));
                return Err(Error::custom(format_args!("there is no rule `{name}`{near}")));
            }
        }
        Ok(levels)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use Severity::{Error, Info, Off, Warning};

    fn levels(list: &[(&str, Severity)]) -> Levels {
        let mut levels = Levels::default();
        for (name, level) in list {
            assert!(levels.set(name, *level), "{name}");
        }
        levels
    }

    #[test]
    fn a_rule_goes_before_its_group_and_a_later_group_before_an_earlier_rule() {
        let rule_first = levels(&[("coolant-off", Error), ("CLASSROOM", Info)]);
        let group_first = levels(&[("classroom", Info), ("Coolant-Off", Error)]);
        assert_eq!(rule_first, group_first);
        let classroom = RULES.iter().filter(|rule| rule.group == Some(Group::Classroom));
        assert_eq!(classroom.clone().count(), 5);
        for slug in classroom.map(|rule| rule.slug) {
            let level = if slug == "coolant-off" { Error } else { Info };
            assert_eq!((rule_first.of(slug), Levels::default().of(slug)), (Some(level), None), "{slug}");
        }
        let over = rule_first.clone().with(&levels(&[("classroom", Off), ("no-program-end", Warning)]));
        assert_eq!(over.of("coolant-off"), Some(Off));
        assert_eq!(over.of("no-program-end"), Some(Warning));
        let under = levels(&[("classroom", Off)]).with(&rule_first);
        assert_eq!((under.of("coolant-off"), under.of("tool-not-named")), (Some(Error), Some(Info)));
        assert_eq!(rule_first.without_groups(), levels(&[("coolant-off", Error)]));
    }

    #[test]
    fn every_name_is_known_in_any_case() {
        for name in names() {
            assert_eq!((known(name), known(&name.to_uppercase())), (Some(name), Some(name)));
        }
        assert_eq!((known(""), known("no-program-ends")), (None, None));
    }

    #[test]
    fn the_nearest_name_is_found() {
        assert_eq!(nearest("no-program-ends"), Some("no-program-end"));
        assert_eq!(nearest("NO-PROGRAM"), Some("no-program-end"));
        assert_eq!(nearest("clasroom"), Some("classroom"));
        assert_eq!((nearest("xyz"), nearest("没有程序结束代码"), nearest("перебег")), (None, None, None));
        assert_eq!(nearest(&"no-program-end".repeat(100)), None);
    }
}
