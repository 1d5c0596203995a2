//! The interface of the element. Each fact has one source: members and events are in `www/embed/element.d.ts`,
//! attributes and slots in the tables of `www/docs/element.md`, parts in the sources of the page, custom
//! properties in `www/src/tokens.css`. `UPDATE_EXPECT=1 cargo test --test it element::` writes
//! `www/embed/custom-elements.json` and the list of parts in the reference.
#[path = "element/declarations.rs"]
mod declarations;
#[path = "element/sources.rs"]
mod sources;

use crate::project;
use std::collections::BTreeSet;
use std::path::Path;

use expect_test::expect_file;
use serde_json::{Value, json};

use declarations::{Declaration, Kind, body, declarations};
use project::{ROOT, source};

const REFERENCE: &str = "www/docs/element.md";
const TYPES: &str = "www/embed/element.d.ts";
const MANIFEST: &str = "www/embed/custom-elements.json";

/// Public members of the class that are not part of its interface: calls of the browser, of other elements, and
/// of the page of the playground.
const INTERNAL: [&str; 9] = [
    "ask",
    "attributeChangedCallback",
    "commands",
    "connectedCallback",
    "constructor",
    "disconnectedCallback",
    "focus",
    "handleKey",
    "marksPrograms",
];

/// A row of a table of the reference: its cells.
type Row = Vec<String>;

/// The rows of the table whose header begins with `head`.
fn table(head: &str) -> Vec<Row> {
    let text = source(REFERENCE);
    let rows = text.lines().skip_while(|line| !line.starts_with(head)).skip(2);
    let rows: Vec<Row> = rows
        .take_while(|line| line.starts_with('|'))
        .map(|row| row.trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect())
        .collect();
    assert!(!rows.is_empty(), "{REFERENCE} has no table {head}");
    rows
}

/// The code spans of a cell.
fn spans(cell: &str) -> Vec<&str> {
    cell.split('`').skip(1).step_by(2).collect()
}

/// A text of the reference without links.
fn without_links(text: &str) -> String {
    let mut parts = text.split("](");
    let first = parts.next().unwrap_or_default().to_owned();
    let whole = parts.fold(first, |done, part| done + part.split_once(')').map_or("", |(_, rest)| rest));
    whole.replace('[', "")
}

/// The values of an attribute as a type: `fanuc | gsk | forum`, or the words of the reference.
fn type_of(values: &str) -> String {
    let outside: String = values.split('`').step_by(2).collect();
    let named = outside.chars().any(char::is_alphabetic);
    match values {
        "present or not" => "boolean".to_owned(),
        _ if named => values.replace('`', ""),
        _ => spans(values).join(" | "),
    }
}

/// The property of an attribute: `blockSkip` for `block-skip`.
fn property(attribute: &str) -> String {
    let mut words = attribute.split('-');
    let first = words.next().unwrap_or_default().to_owned();
    words.fold(first, |name, word| name + &word[..1].to_uppercase() + &word[1..])
}

fn attributes() -> Vec<Value> {
    let rows = table("| attribute |");
    rows.iter()
        .map(|row| {
            let name = row[0].trim_matches('`');
            json!({
                "name": name,
                "fieldName": property(name),
                "type": {"text": type_of(&row[1])},
                "description": without_links(&row[2]),
            })
        })
        .collect()
}

fn members() -> Vec<Declaration> {
    declarations(body(&source(TYPES), "export class GcodePlayground extends HTMLElement {"))
}

fn events() -> Vec<Declaration> {
    declarations(body(&source(TYPES), "export interface GcodePlaygroundEvents {"))
}

/// A member as the schema of manifests describes it.
fn in_manifest(member: &Declaration, attributes: &[Value]) -> Value {
    let mut value = json!({"name": member.name});
    if !member.doc.is_empty() {
        value["description"] = json!(member.doc);
    }
    match &member.kind {
        Kind::Method(parameters) => {
            value["kind"] = json!("method");
            value["return"] = json!({"type": {"text": member.of}});
            if !parameters.is_empty() {
                value["parameters"] =
                    parameters.iter().map(|(name, of)| json!({"name": name, "type": {"text": of}})).collect();
            }
        }
        Kind::Field { is_readonly } => {
            value["kind"] = json!("field");
            value["type"] = json!({"text": member.of});
            if *is_readonly {
                value["readonly"] = json!(true);
            }
        }
    }
    if let Some(attribute) = attributes.iter().find(|attribute| attribute["fieldName"] == member.name) {
        value["attribute"] = attribute["name"].clone();
    }
    value
}

fn slots() -> Vec<Value> {
    let rows = table("| slot |");
    let named = rows.iter().flat_map(|row| spans(&row[0]).into_iter().map(|name| (name, &row[1])));
    named.map(|(name, place)| json!({"name": name, "description": place})).collect()
}

/// The whole manifest.
fn manifest() -> String {
    let attributes = attributes();
    let members: Vec<Value> = members().iter().map(|member| in_manifest(member, &attributes)).collect();
    let events = events();
    let events = events
        .iter()
        .map(|event| json!({"name": event.name, "type": {"text": event.of}, "description": event.doc}));
    let parts = sources::parts();
    let parts = parts.iter().map(|name| json!({"name": name}));
    let properties = sources::custom_properties();
    let properties = properties.iter().map(|(name, value)| json!({"name": name, "default": value}));
    let class = json!({
        "kind": "class",
        "customElement": true,
        "name": "GcodePlayground",
        "tagName": "gcode-playground",
        "superclass": {"name": "HTMLElement"},
        "description": "A lathe program, its drawing, its problems, and the tool moving along it.",
        "attributes": attributes,
        "members": members,
        "events": events.collect::<Vec<_>>(),
        "slots": slots(),
        "cssParts": parts.collect::<Vec<_>>(),
        "cssProperties": properties.collect::<Vec<_>>(),
    });
    let exported = |kind: &str, name: &str| json!({"kind": kind, "name": name, "declaration": {"name": "GcodePlayground"}});
    let whole = json!({
        "schemaVersion": "2.1.0",
        "readme": "README.md",
        "modules": [{
            "kind": "javascript-module",
            "path": "element.js",
            "declarations": [class],
            "exports": [
                exported("js", "GcodePlayground"),
                exported("custom-element-definition", "gcode-playground"),
            ],
        }],
    });
    format!("{whole:#}\n")
}

#[test]
fn the_manifest_describes_the_whole_element() {
    expect_file![Path::new(ROOT).join(MANIFEST)].assert_eq(&manifest());
}

#[test]
fn the_reference_lists_the_parts() {
    let text = source(REFERENCE);
    let (before, rest) = text.split_once("<!-- parts -->\n").expect("the beginning of the list");
    let (_, after) = rest.split_once("<!-- /parts -->").expect("the end of the list");
    let parts: Vec<String> = sources::parts().iter().map(|name| format!("`{name}`")).collect();
    let wanted = format!("{before}<!-- parts -->\n{}\n<!-- /parts -->{after}", parts.join(" "));
    expect_file![Path::new(ROOT).join(REFERENCE)].assert_eq(&wanted);
}

#[test]
fn reference_and_types_list_the_events_that_the_element_fires() {
    let fired = sources::events();
    let typed: BTreeSet<String> = events().into_iter().map(|event| event.name).collect();
    assert_eq!(typed, fired, "{TYPES}");
    let rows = table("| event |");
    let listed = rows.iter().flat_map(|row| spans(&row[0])).map(str::to_owned);
    assert_eq!(listed.collect::<BTreeSet<_>>(), fired, "{REFERENCE}");
    // A detail has the keys of its type.
    for (row, event) in rows.iter().flat_map(|row| spans(&row[0]).into_iter().map(move |name| (row, name))) {
        let types = events();
        let of = &types.iter().find(|declared| declared.name == event).expect("checked above").of;
        for key in row[1].trim_matches(['`', '{', '}']).split(", ") {
            let is_known = of.contains(&format!("readonly {key}:"))
                || ["CursorPlace", "PlaygroundError"].iter().any(|name| {
                    of.contains(name)
                        && body(&source(TYPES), &format!("export interface {name} {{"))
                            .contains(&format!("readonly {key}:"))
                });
            assert!(is_known, "{event}: `{key}` is not in {of}");
        }
    }
}

#[test]
fn reference_and_types_list_the_members_of_the_class() {
    let typed: BTreeSet<String> = members().into_iter().map(|member| member.name).collect();
    let public: BTreeSet<String> =
        sources::members().into_iter().filter(|name| !INTERNAL.contains(&name.as_str())).collect();
    assert_eq!(typed, public, "{TYPES}");
    let attributes: BTreeSet<String> =
        table("| attribute |").iter().map(|row| property(row[0].trim_matches('`'))).collect();
    let listed = table("| property or method |");
    let listed = listed.iter().flat_map(|row| spans(&row[0]));
    let listed: BTreeSet<String> = listed
        .map(|span| span.split('(').next().unwrap_or_default().to_owned())
        .filter(|name| name != "focus")
        .collect();
    assert_eq!(attributes.union(&listed).cloned().collect::<BTreeSet<_>>(), typed, "{REFERENCE}");
    assert_eq!(attributes.intersection(&listed).count(), 0, "listed twice");
}

#[test]
fn the_reference_lists_the_slots() {
    let listed: BTreeSet<String> =
        slots().iter().filter_map(|slot| slot["name"].as_str().map(str::to_owned)).collect();
    assert_eq!(listed, sources::slots());
}
