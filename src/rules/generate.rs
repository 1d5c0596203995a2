//! Rust and JSON of rule files that were read without a mistake.

use std::collections::BTreeMap;
use std::fmt::{Display, Write};

use crate::format::message::{Argument, Message, Type};
use crate::format::{LANGUAGES, RuleFile};

/// Variants that two messages share, each with its place.
pub fn duplicates(rules: &[RuleFile]) -> Vec<String> {
    let mut known: BTreeMap<&str, &str> = BTreeMap::new();
    let mut mistakes = Vec::new();
    for (rule, message) in messages(rules) {
        if let Some(other) = known.insert(&message.name, &rule.slug) {
            let (slug, name) = (&rule.slug, &message.name);
            mistakes.push(format!(
                "src/rules/{slug}.md:{}: `{name}` is a message of {other}.md too",
                message.line
            ));
        }
    }
    mistakes
}

/// The files by name.
pub fn files(rules: &[RuleFile]) -> Vec<(String, String)> {
    let mut files = vec![
        ("message.rs".to_owned(), message(rules)),
        ("sentences.rs".to_owned(), sentences(rules)),
        ("example_messages.rs".to_owned(), example_messages(rules)),
    ];
    for (index, tag) in LANGUAGES.iter().enumerate() {
        files.push((format!("messages.{tag}.json"), json(rules, index)));
    }
    files
}

/// All messages, each with its rule.
fn messages(rules: &[RuleFile]) -> impl Iterator<Item = (&RuleFile, &Message)> {
    rules.iter().flat_map(|rule| rule.messages.iter().map(move |message| (rule, message)))
}

/// The enum, and what is known of each message.
fn message(rules: &[RuleFile]) -> String {
    let mut out = String::new();
    put(
        &mut out,
        "/// A message to the user with its arguments. Lengths are in mm, as people write them: X values are diameters.",
    );
    put(&mut out, "#[derive(Clone, Debug, PartialEq)]");
    put(&mut out, "pub enum Message {");
    for (_, Message { name, doc, arguments, .. }) in messages(rules) {
        put(&mut out, format_args!("    /// {doc}"));
        if arguments.is_empty() {
            put(&mut out, format_args!("    {name},"));
            continue;
        }
        put(&mut out, format_args!("    {name} {{"));
        for Argument { name, kind, doc, .. } in arguments {
            put(&mut out, format_args!("        /// {doc}\n        {name}: {},", rust_type(*kind)));
        }
        put(&mut out, "    },");
    }
    put(&mut out, "}\n\nimpl Message {");
    index(&mut out, rules);
    own_alarm(&mut out, rules);
    values(&mut out, rules);
    put(&mut out, "}\n");
    tables(&mut out, rules);
    out
}

fn index(out: &mut String, rules: &[RuleFile]) {
    put(out, "    /// Its place in the tables of messages.");
    put(out, "    pub(crate) fn index(&self) -> usize {\n        match self {");
    for (index, (_, message)) in messages(rules).enumerate() {
        put(out, format_args!("            {} => {index},", pattern(message, &[])));
    }
    put(out, "        }\n    }\n");
}

fn own_alarm(out: &mut String, rules: &[RuleFile]) {
    put(out, "    /// The alarm among its arguments.");
    put(out, "    fn own_alarm(&self) -> Option<&'static str> {\n        match self {");
    for (_, message) in messages(rules) {
        if message.arguments.iter().any(|argument| argument.kind == Type::Alarm) {
            let pattern = pattern(message, &[("alarm", "alarm")]);
            put(out, format_args!("            {pattern} => Some(alarm),"));
        }
    }
    put(out, "            _ => None,\n        }\n    }\n");
}

/// The values of the arguments: messages whose arguments have the same types share an arm.
fn values(out: &mut String, rules: &[RuleFile]) {
    put(out, "    /// The values its sentences quote, in the order of `ARGUMENTS`.");
    put(out, "    fn values(&self) -> Vec<Value<'_>> {\n        match self {");
    let mut arms: BTreeMap<Vec<Type>, Vec<String>> = BTreeMap::new();
    for (_, message) in messages(rules) {
        let quoted: Vec<_> = quoted(message).collect();
        let types = quoted.iter().map(|argument| argument.kind).collect();
        let bindings: Vec<String> = (0..quoted.len()).map(|index| format!("value{index}")).collect();
        let names: Vec<_> = quoted
            .iter()
            .zip(&bindings)
            .map(|(argument, own)| (argument.name.as_str(), own.as_str()))
            .collect();
        arms.entry(types).or_default().push(pattern(message, &names));
    }
    for (types, patterns) in arms {
        let values: Vec<String> =
            types.iter().enumerate().map(|(index, kind)| value(*kind, &format!("value{index}"))).collect();
        let patterns = patterns.join("\n            | ");
        put(out, format_args!("            {patterns} => vec![{}],", values.join(", ")));
    }
    put(out, "        }\n    }");
}

fn tables(out: &mut String, rules: &[RuleFile]) {
    let count = messages(rules).count();
    put(out, "/// All rules, in the order of their slugs.");
    put(out, format_args!("pub static RULES: [Rule; {}] = [", rules.len()));
    for rule in rules {
        let list =
            |texts: Vec<&str>| format!("&[{}]", texts.iter().map(quote).collect::<Vec<_>>().join(", "));
        let alarms: Vec<&str> = rule.alarms.iter().map(String::as_str).collect();
        let group = rule.group.map_or("None".to_owned(), |group| format!("Some(Group::{group})"));
        put(
            out,
            format_args!(
                "    Rule {{ slug: {}, codes: {}, severity: Severity::{}, kind: Kind::{}, alarms: {}, group: {group} }},",
                quote(&rule.slug),
                list(rule.code.as_deref().map_or_else(|| alarms.clone(), |code| vec![code])),
                rule.severity,
                rule.kind,
                list(alarms),
            ),
        );
    }
    put(out, "];\n\n/// The place of the rule of each message in `RULES`.");
    put(out, format_args!("static RULE_OF: [u16; {count}] = ["));
    for (index, rule) in rules.iter().enumerate() {
        put(out, format_args!("    {}", format!("{index}, ").repeat(rule.messages.len())));
    }
    put(out, "];\n\n/// The name of each message.");
    put(out, format_args!("static NAMES: [&str; {count}] = ["));
    for (_, message) in messages(rules) {
        put(out, format_args!("    {},", quote(&message.name)));
    }
    put(out, "];\n\n/// The names of the arguments that the sentences of each message quote.");
    put(out, format_args!("static ARGUMENTS: [&[&str]; {count}] = ["));
    for (_, message) in messages(rules) {
        let names: Vec<_> = quoted(message).map(|argument| quote(&argument.name)).collect();
        put(out, format_args!("    &[{}],", names.join(", ")));
    }
    put(out, "];");
}

/// The templates of all languages: a sentence, and on a second line its help.
fn sentences(rules: &[RuleFile]) -> String {
    let mut out = String::new();
    put(
        &mut out,
        "// The templates of each language, in the order of the messages: a sentence, and on a second line its help.",
    );
    let count = messages(rules).count();
    for (index, language) in LANGUAGES.iter().enumerate() {
        let name = language.to_uppercase();
        put(&mut out, format_args!("pub(super) static {name}: [&str; {count}] = ["));
        for (_, message) in messages(rules) {
            let said = &message.sentences[index];
            let help = said.help.iter().map(|help| format!("\n{help}")).collect::<String>();
            put(&mut out, format_args!("    {},", quote(format!("{}{help}", said.message))));
        }
        put(&mut out, "];\n");
    }
    out
}

/// A value of each message with the samples of its arguments, one for each alarm.
fn example_messages(rules: &[RuleFile]) -> String {
    let mut out = String::new();
    put(
        &mut out,
        "/// Every message with the samples of its rule file; where a rule has several alarms, once for each.",
    );
    put(&mut out, "pub fn example_messages() -> Vec<Message> {\n    vec![");
    for (rule, message) in messages(rules) {
        let has_alarm = message.arguments.iter().any(|argument| argument.kind == Type::Alarm);
        let without = [String::new()];
        for alarm in if has_alarm { &rule.alarms[..] } else { &without[..] } {
            let fields: Vec<String> = message
                .arguments
                .iter()
                .map(|Argument { name, kind, sample, .. }| {
                    let value = match kind {
                        Type::Letter => format!("{:?}", sample.chars().next().unwrap_or_default()),
                        Type::Text => format!("{}.into()", quote(sample)),
                        Type::Word => quote(sample),
                        Type::Count | Type::Index | Type::Program | Type::Integer => sample.clone(),
                        Type::Number | Type::Length => {
                            format!("{:?}", sample.parse::<f64>().unwrap_or_default())
                        }
                        Type::Diameter => {
                            format!("Diameter::new({:?})", sample.parse::<f64>().unwrap_or_default())
                        }
                        Type::Alarm => quote(alarm),
                    };
                    format!("{name}: {value}")
                })
                .collect();
            let fields =
                if fields.is_empty() { String::new() } else { format!(" {{ {} }}", fields.join(", ")) };
            put(&mut out, format_args!("        Message::{}{fields},", message.name));
        }
    }
    put(&mut out, "    ]\n}");
    out
}

/// The sentences of one language: of each message by its name the rule, the types of the
/// arguments, and the templates.
fn json(rules: &[RuleFile], language: usize) -> String {
    let mut out = String::from("{\n");
    let last = messages(rules).count() - 1;
    for (index, (rule, message)) in messages(rules).enumerate() {
        let said = &message.sentences[language];
        let arguments: Vec<_> = quoted(message)
            .map(|Argument { name, kind, .. }| format!("{}: {}", json_text(name), json_text(kind.name())))
            .collect();
        let help =
            said.help.iter().map(|help| format!(", \"help\": {}", json_text(help))).collect::<String>();
        let comma = if index == last { "" } else { "," };
        put(
            &mut out,
            format_args!(
                "{}: {{\"rule\": {}, \"arguments\": {{{}}}, \"message\": {}{help}}}{comma}",
                json_text(&message.name),
                json_text(&rule.slug),
                arguments.join(", "),
                json_text(&said.message),
            ),
        );
    }
    out.push_str("}\n");
    out
}

/// The arguments that sentences quote.
fn quoted(message: &Message) -> impl Iterator<Item = &Argument> {
    message.arguments.iter().filter(|argument| argument.kind != Type::Alarm)
}

/// A pattern of a message that binds fields.
fn pattern(message: &Message, bindings: &[(&str, &str)]) -> String {
    let name = &message.name;
    if message.arguments.is_empty() {
        return format!("Self::{name}");
    }
    let bound = |(field, own): &(&str, &str)| {
        if field == own { (*field).to_owned() } else { format!("{field}: {own}") }
    };
    let mut parts: Vec<String> = bindings.iter().map(bound).collect();
    if bindings.len() < message.arguments.len() {
        parts.push("..".to_owned());
    }
    format!("Self::{name} {{ {} }}", parts.join(", "))
}

fn rust_type(kind: Type) -> &'static str {
    match kind {
        Type::Letter => "char",
        Type::Text => "String",
        Type::Word | Type::Alarm => "&'static str",
        Type::Count => "usize",
        Type::Index | Type::Program => "u32",
        Type::Integer => "i64",
        Type::Number | Type::Length => "f64",
        Type::Diameter => "Diameter",
    }
}

fn value(kind: Type, name: &str) -> String {
    match kind {
        Type::Letter => format!("Value::Letter(*{name})"),
        Type::Text | Type::Word | Type::Alarm => format!("Value::Text({name})"),
        Type::Count => format!("Value::Count(i64::try_from(*{name}).unwrap_or(i64::MAX))"),
        Type::Index => format!("Value::Count(i64::from(*{name}))"),
        Type::Program => format!("Value::Program(*{name})"),
        Type::Integer => format!("Value::Count(*{name})"),
        Type::Number => format!("Value::Number(*{name})"),
        Type::Length => format!("Value::Length(*{name})"),
        Type::Diameter => format!("Value::Length({name}.mm())"),
    }
}

/// A literal of Rust.
fn quote(text: impl AsRef<str>) -> String {
    format!("{:?}", text.as_ref())
}

/// A string of JSON.
fn json_text(text: &str) -> String {
    let mut out = String::from("\"");
    for letter in text.chars() {
        match letter {
            '"' | '\\' => out.extend(['\\', letter]),
            letter if letter.is_control() => drop(write!(out, "\\u{:04x}", u32::from(letter))),
            letter => out.push(letter),
        }
    }
    out + "\""
}

fn put(out: &mut String, line: impl Display) {
    let _ = writeln!(out, "{line}");
}
