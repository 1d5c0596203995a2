//! `gcode-playground schema`: the schemas accept what the parsers accept, and the TypeScript types of a setup
//! are made from its schema.
#[path = "schemas/checker.rs"]
mod checker;
#[path = "schemas/typescript.rs"]
mod typescript;

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use expect_test::expect_file;
use gcode_playground::message::RULES;
use gcode_playground::setup::Setup;
use serde_json::{Map, Value, json};

use crate::project::{ROOT, files, source};
use checker::Checker;

fn run(arguments: &[&str]) -> (String, Option<i32>) {
    let output =
        Command::new(env!("CARGO_BIN_EXE_gcode-playground")).args(arguments).output().expect("it runs");
    (String::from_utf8(output.stdout).expect("UTF-8"), output.status.code())
}

fn schema(of: &str) -> Value {
    let (text, status) = run(&["schema", of]);
    assert_eq!(status, Some(0));
    serde_json::from_str(&text).expect("JSON")
}

#[test]
fn every_setup_of_the_programs_is_valid() {
    let schema = schema("setup");
    let setups: Vec<String> = files()
        .into_iter()
        .filter(|file| file.starts_with("tests/programs/") && file.ends_with("/setup.json"))
        .collect();
    assert!(setups.len() > 50, "{}", setups.len());
    for file in setups {
        let setup: Value = serde_json::from_str(&source(&file)).expect("JSON");
        assert!(Checker(&schema).accepts(&setup), "{file}: {setup}");
    }
}

/// Setups that are right, and setups with one fault each.
#[test]
fn the_schema_of_a_setup_agrees_with_its_parser() {
    let schema = schema("setup");
    let right = [
        json!({}),
        json!({"dialect": {"control": "gsk", "g73Intervals": "d-1", "iInG92": "tpi", "typeII": true}}),
        json!({"stock": {"diameter": 65, "length": 60}}),
        json!({"stock": {"outline": [[36, 2], [56, -80]], "grip": 25}}),
        json!({"tools": {"T0101": {"type": "endmill", "tip": 3}, "t2": {}}}),
        json!({"rules": {"no-program-end": "off", "classroom": "warning"}, "lints": "off"}),
        json!({"limits": {"motions": 20_000_000}, "blockSkip": [1, 9], "program": 4_294_967_295_u32}),
        json!({"stock": null, "program": null, "machine": {"travel": {"xMin": null}}}),
    ];
    let wrong = [
        json!({"stok": {}}),
        json!({"dialect": {"feedmode": "G98"}}),
        json!({"dialect": {"feedMode": "G97"}}),
        json!({"tools": {"T0101": {"radius": 1}}}),
        json!({"tools": {"0101": {}}}),
        json!({"tools": {"T01011": {}}}),
        json!({"tools": {"T0101": {"tip": 256}}}),
        json!({"tools": {"T0101": {"tip": 1.5}}}),
        json!({"stock": {"diameter": 1, "length": 2, "width": 3}}),
        json!({"stock": {"diameter": 1}}),
        json!({"stock": {"outline": [[36, 2], [56, -80]], "length": 80}}),
        json!({"stock": {"outline": [[36, 2, 1]]}}),
        json!({"stock": {"outline": []}}),
        json!({"initial": {"x": 200}}),
        json!({"rules": {"no-program-ends": "off"}}),
        json!({"rules": {"no-program-end": "loud"}}),
        json!({"limits": {"motions": 20_000_001}}),
        json!({"limits": {"stride": 1}}),
        json!({"program": 4_294_967_296_u64}),
        json!({"machine": {"turret": "left"}}),
    ];
    for (setups, is_right) in [(&right[..], true), (&wrong[..], false)] {
        for setup in setups {
            assert_eq!(Setup::from_json(&setup.to_string()).is_ok(), is_right, "the parser: {setup}");
            assert_eq!(Checker(&schema).accepts(setup), is_right, "the schema: {setup}");
        }
    }
}

/// Values of every type, of which each key accepts some.
fn values() -> Vec<Value> {
    vec![
        json!(null),
        json!(true),
        json!(-1),
        json!(0.5),
        json!(7),
        json!(300),
        json!(1e12),
        json!("zz"),
        json!("fanuc"),
        json!([]),
        json!([1, 2]),
        json!([[1, 2]]),
        json!({}),
        json!({"zz": 1}),
    ]
}

/// Objects with one key set to each of the values, and the required other keys; deeper objects in the same way.
fn variations(schema: &Value, root: &Value) -> Vec<Value> {
    let own = schema["$ref"].as_str().and_then(|address| root.pointer(address.trim_start_matches('#')));
    let alternative = || schema["anyOf"].as_array()?.iter().find(|one| one.get("$ref").is_some());
    if let Some(own) = own.or_else(alternative) {
        return variations(own, root);
    }
    let required =
        schema["required"].as_array().or(schema.pointer("/else/required").and_then(Value::as_array));
    let base: Map<String, Value> = required
        .into_iter()
        .flatten()
        .filter_map(|name| Some((name.as_str()?.to_owned(), json!(1))))
        .collect();
    let with = |key: &str, value: Value| {
        let mut object = base.clone();
        object.insert(key.to_owned(), value);
        Value::Object(object)
    };
    let mut found = Vec::new();
    for (key, own) in schema["properties"].as_object().into_iter().flatten() {
        found.extend(values().into_iter().chain(variations(own, root)).map(|value| with(key, value)));
    }
    if let Some(own) = schema.get("additionalProperties").filter(|own| own.is_object()) {
        found.extend(variations(own, root).into_iter().map(|value| json!({"T0101": value})));
    }
    found
}

#[test]
fn each_key_of_a_setup_accepts_the_same_in_schema_and_parser() {
    let schema = schema("setup");
    let all = variations(&schema, &schema);
    assert!(all.len() > 1000, "{}", all.len());
    let mut accepted = 0;
    for setup in all {
        let is_read = Setup::from_json(&setup.to_string());
        let is_accepted = Checker(&schema).accepts(&setup);
        // The parser reads an array as the values of an object in their order; the schema knows objects only.
        let is_list = is_read.is_ok() && !is_accepted && setup.to_string().contains('[');
        assert!(is_accepted == is_read.is_ok() || is_list, "{setup}: {is_read:?}");
        accepted += usize::from(is_read.is_ok());
    }
    assert!(accepted > 200, "{accepted}");
}

/// The keys of a configuration, each with a value that is accepted and one that is not.
const KEYS: [(&str, &str, &str); 14] = [
    ("control", "'gsk'", "'siemens'"),
    ("setup", "[]", "3"),
    ("select", "['rapid-through-stock', 'PS0010', 'classroom']", "'nothing-such'"),
    ("ignore", "'no-program-end'", "[3]"),
    ("rules", "{no-program-end = 'off'}", "{no-program-end = 'loud'}"),
    ("language", "'zh'", "'de'"),
    ("extension", "['nc', 'txt']", "true"),
    ("exclude", "'old/**'", "[1]"),
    ("library", "'subs'", "{}"),
    ("baseline", "'known.json'", "['known.json']"),
    ("max-warnings", "0", "-1"),
    ("rules-url", "'https://a.example/rules'", "'rules'"),
    ("override", "[{files = 'gsk/**', control = 'gsk'}]", "[{control = 'gsk'}]"),
    ("override", "[]", "{files = 'gsk/**'}"),
];

#[test]
fn the_schema_of_a_configuration_agrees_with_its_parser() {
    let schema = schema("config");
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("configurations");
    fs::create_dir_all(&folder).expect("a folder");
    let file = folder.join("gcode-playground.toml");
    let path = file.to_str().expect("UTF-8");
    let check = |text: &str, is_right: bool| {
        fs::write(&file, text).expect("a file");
        let (_, status) = run(&["config", "--config", path]);
        assert_eq!(status, Some(if is_right { 0 } else { 2 }), "the parser: {text}");
        let value: Value = toml::from_str(text).expect("TOML");
        assert_eq!(Checker(&schema).accepts(&value), is_right, "the schema: {text}");
    };
    for (key, right, wrong) in KEYS {
        check(&format!("{key} = {right}\n"), true);
        check(&format!("{key} = {wrong}\n"), false);
    }
    check("", true);
    check("controls = 'gsk'\n", false);
    check("[[override]]\nfiles = 'a'\nlanguage = 'zh'\n", false);
    let listed: BTreeSet<&str> = KEYS.iter().map(|(key, ..)| *key).collect();
    let known = schema["properties"].as_object().expect("properties");
    assert_eq!(listed, known.keys().map(String::as_str).collect());
    let rules = schema["$defs"]["Rule"]["enum"].as_array().expect("rules");
    assert!(RULES.iter().all(|rule| rules.contains(&Value::from(rule.slug))));
}

#[test]
fn the_configuration_of_the_example_is_valid() {
    let text = source("tests/example-repository/gcode-playground.toml");
    let value: Value = toml::from_str(&text).expect("TOML");
    assert!(Checker(&schema("config")).accepts(&value), "{value}");
}

/// Each key of both schemas is described.
#[test]
fn editors_show_the_meaning_of_each_key() {
    fn undescribed(schema: &Value, place: &str) -> Vec<String> {
        let properties = schema["properties"].as_object().into_iter().flatten();
        let mut found: Vec<String> = properties
            .filter(|(_, own)| own["description"].as_str().is_none_or(str::is_empty))
            .map(|(key, _)| format!("{place}.{key}"))
            .collect();
        for (name, own) in schema["$defs"].as_object().into_iter().flatten() {
            found.extend(undescribed(own, name));
        }
        found
    }
    for of in ["setup", "config"] {
        assert_eq!(undescribed(&schema(of), of), [""; 0]);
    }
    // The descriptions are for users: no names of the sources.
    for part in ["crate::", "seed", "`provenance"] {
        assert!(!schema("setup").to_string().contains(part), "{part}");
    }
}

#[test]
fn the_types_of_a_setup_are_made_from_its_schema() {
    let file = Path::new(ROOT).join("www/embed/node/setup.d.ts");
    expect_file![file].assert_eq(&typescript::interfaces(&schema("setup")));
}
