//! The keys of `gcode-playground.toml`, with the values that each accepts.
//!
//! In: nothing. Out: the tables that `file` reads a configuration by, and the JSON Schema of a configuration.

use serde_json::{Map, Value, json};

use crate::message::{Group, RULES, Severity};
use crate::sentences::Language;
use crate::setup::dialect::Control;

/// A key of a configuration.
pub(super) struct Key {
    /// Its name.
    pub name: &'static str,
    /// The values that it accepts.
    accepts: Accepts,
    /// Its meaning.
    about: &'static str,
}

/// The values that a key accepts.
#[derive(Clone, Copy)]
enum Accepts {
    /// A control.
    Control,
    /// A language.
    Language,
    /// A text.
    Text,
    /// A text, or several.
    Texts,
    /// An address of the web.
    Address,
    /// A whole number.
    Count,
    /// A rule, by slug or code, or a group of rules; or several.
    Rules,
    /// The severity of each rule.
    Levels,
    /// Tables for some programs.
    Overrides,
}

const fn key(name: &'static str, accepts: Accepts, about: &'static str) -> Key {
    Key { name, accepts, about }
}

/// The keys for programs, at the top level of a file and in an override.
pub(super) const VALUES: [Key; 5] = [
    key("control", Accepts::Control, "The control."),
    key("setup", Accepts::Texts, "Setup files: machines, tools, blanks. Of each group the last one holds."),
    key("select", Accepts::Rules, "Rules to report; all others are not reported."),
    key("ignore", Accepts::Rules, "Rules that are not reported."),
    key("rules", Accepts::Levels, "Severities of rules and groups of rules."),
];

/// Further keys at the top level of a file.
pub(super) const USUAL: [Key; 8] = [
    key("language", Accepts::Language, "Language of messages."),
    key("extension", Accepts::Texts, "Endings of programs in folders."),
    key("exclude", Accepts::Texts, "Patterns of excluded files, as in a .gitignore."),
    key("library", Accepts::Texts, "Folders with subprograms."),
    key("baseline", Accepts::Text, "The list of known findings."),
    key("max-warnings", Accepts::Count, "Maximum number of warnings."),
    key("rules-url", Accepts::Address, "The address of the rule pages, a folder `rules` of the site."),
    key("override", Accepts::Overrides, "Values for some programs; later ones override earlier ones."),
];

/// Further keys of an override.
pub(super) const OF_OVERRIDES: [Key; 1] =
    [key("files", Accepts::Texts, "Patterns of the programs, as in a .gitignore.")];

/// The JSON Schema of a configuration.
pub(in crate::cli) fn schema() -> Value {
    let rules = RULES.iter().flat_map(|rule| std::iter::once(&rule.slug).chain(rule.codes));
    let mut rules: Vec<&str> = rules.copied().chain(Group::ALL.map(Group::name)).collect();
    rules.sort_unstable();
    rules.dedup();
    json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "Configuration",
        "description": "How programs are run and checked: gcode-playground.toml.",
        "type": "object",
        "properties": properties(VALUES.iter().chain(&USUAL)),
        "additionalProperties": false,
        "$defs": {
            "Override": {
                "type": "object",
                "properties": properties(OF_OVERRIDES.iter().chain(&VALUES)),
                "required": ["files"],
                "additionalProperties": false,
            },
            "Rule": {"enum": rules},
        },
    })
}

/// The properties of an object with these keys.
fn properties<'a>(keys: impl Iterator<Item = &'a Key>) -> Map<String, Value> {
    keys.map(|key| {
        let mut schema = key.accepts.schema();
        schema["description"] = key.about.into();
        (key.name.to_owned(), schema)
    })
    .collect()
}

impl Accepts {
    fn schema(self) -> Value {
        let text = json!({"type": "string"});
        let rule = json!({"$ref": "#/$defs/Rule"});
        match self {
            Self::Control => json!({"enum": Control::ALL.map(Control::name)}),
            Self::Language => json!({"enum": Language::ALL.map(Language::tag)}),
            Self::Text => text,
            Self::Texts => one_or_several(&text),
            Self::Address => json!({"type": "string", "pattern": "^https?://[^\\s]*$"}),
            Self::Count => json!({"type": "integer", "minimum": 0}),
            Self::Rules => one_or_several(&rule),
            Self::Levels => json!({
                "type": "object",
                "propertyNames": rule,
                "additionalProperties": {"enum": Severity::ALL.map(Severity::name)},
            }),
            Self::Overrides => json!({"type": "array", "items": {"$ref": "#/$defs/Override"}}),
        }
    }
}

/// One value, or an array of values.
fn one_or_several(value: &Value) -> Value {
    json!({"anyOf": [value, {"type": "array", "items": value}]})
}
