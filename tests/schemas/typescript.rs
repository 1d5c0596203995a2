//! In: the JSON Schema of a setup. Out: the TypeScript interfaces of `www/embed/node/setup.d.ts`.
use serde_json::{Map, Value};

const HEAD: &str = "// Made from the types that read a setup: `UPDATE_EXPECT=1 cargo test --test it schemas::` writes this file.\n// Reference: `docs/setup.html` of the site.\n";

/// All interfaces; the root is `Setup`, a definition such as `Tool` is `SetupTool`.
pub fn interfaces(schema: &Value) -> String {
    let root = std::iter::once(("Setup".to_owned(), schema));
    let definitions = schema["$defs"].as_object().expect("definitions").iter();
    let all = root.chain(definitions.map(|(name, own)| (format!("Setup{name}"), own)));
    all.fold(HEAD.to_owned(), |file, (name, own)| file + "\n" + &interface(&name, own))
}

fn interface(name: &str, schema: &Value) -> String {
    let required = schema["required"].as_array().map(Vec::as_slice).unwrap_or_default();
    let properties = schema["properties"].as_object().expect("properties");
    let mut text = format!("{}export interface {name} {{\n", comment(schema, ""));
    for (key, own) in properties {
        let mark = if required.contains(&Value::from(key.as_str())) { "" } else { "?" };
        text += &comment(own, "  ");
        text += &format!("  readonly {key}{mark}: {};\n", type_of(own));
    }
    text + "}\n"
}

/// The description as a comment, in lines of at most 120 characters.
fn comment(schema: &Value, indent: &str) -> String {
    let Some(text) = schema["description"].as_str() else { return String::new() };
    let mut lines: Vec<String> = vec![String::new()];
    for word in text.split_whitespace() {
        match lines.last_mut().filter(|line| indent.len() + 4 + line.len() + word.len() < 120) {
            Some(line) => line.push_str(&format!(" {word}")),
            None => lines.push(format!(" {word}")),
        }
    }
    match &lines[..] {
        [line] if indent.len() + line.len() + 6 <= 120 => format!("{indent}/**{line} */\n"),
        lines => {
            let lines: String = lines.iter().map(|line| format!("{indent} *{line}\n")).collect();
            format!("{indent}/**\n{lines}{indent} */\n")
        }
    }
}

fn type_of(schema: &Value) -> String {
    let object: &Map<String, Value> = schema.as_object().expect("a schema");
    let several = ["anyOf", "oneOf"].iter().find_map(|name| object.get(*name)).and_then(Value::as_array);
    if let Some(address) = object.get("$ref").and_then(Value::as_str) {
        return format!("Setup{}", address.rsplit('/').next().expect("a name"));
    }
    if let Some(several) = several {
        return union(several.iter().map(type_of));
    }
    if let Some(values) = object.get("enum").and_then(Value::as_array) {
        return union(values.iter().map(literal));
    }
    if let Some(value) = object.get("const") {
        return literal(value);
    }
    match &object["type"] {
        Value::Array(types) => union(types.iter().map(|name| named(name, object))),
        name => named(name, object),
    }
}

/// The types without `null`: an absent key means the same.
fn union(types: impl Iterator<Item = String>) -> String {
    types.filter(|name| name != "null").collect::<Vec<_>>().join(" | ")
}

fn literal(value: &Value) -> String {
    value.as_str().map_or_else(|| value.to_string(), |text| format!("'{text}'"))
}

fn named(name: &Value, schema: &Map<String, Value>) -> String {
    match name.as_str().expect("the name of a type") {
        "integer" => "number".to_owned(),
        "array" => {
            let item = type_of(&schema["items"]);
            let length = |key: &str| schema.get(key).and_then(Value::as_u64);
            match (length("minItems"), length("maxItems")) {
                (Some(least), Some(most)) if least == most => {
                    format!("readonly [{}]", vec![item; most as usize].join(", "))
                }
                _ if item.contains(' ') => format!("readonly ({item})[]"),
                _ => format!("readonly {item}[]"),
            }
        }
        "object" => format!("{{ readonly [name: string]: {} }}", type_of(&schema["additionalProperties"])),
        plain => plain.to_owned(),
    }
}
