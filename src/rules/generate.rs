//! Generates Rust code from rule files without errors.

use std::collections::BTreeMap;
use std::fmt::{Display, Write};

use crate::format::message::{Argument, Message, Type};
use crate::format::page::Text;
use crate::format::{LANGUAGES, RuleFile};
use crate::texts::{self, Texts};

/// Errors for message names that are used twice, each with its place.
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

/// The generated files, with their names.
pub fn files(rules: &[RuleFile], texts: &Texts) -> Vec<(String, String)> {
    let mut files = vec![
        ("message.rs".to_owned(), message(rules)),
        ("places.rs".to_owned(), places(rules, texts)),
        ("example_messages.rs".to_owned(), example_messages(rules)),
        ("pages.rs".to_owned(), pages(rules)),
    ];
    for (language, tag) in LANGUAGES.iter().enumerate() {
        files.push((format!("{tag}.txt"), texts::list(language, rules, texts)));
    }
    files
}

/// All messages, each with its rule.
fn messages(rules: &[RuleFile]) -> impl Iterator<Item = (&RuleFile, &Message)> {
    rules.iter().flat_map(|rule| rule.messages.iter().map(move |message| (rule, message)))
}

/// The source of `message.rs`: a type for each message, and the tables of rules.
fn message(rules: &[RuleFile]) -> String {
    let mut out = String::new();
    put(
        &mut out,
        "/// What code says: a type for each message, with its arguments. Lengths are in mm, as people write them: X values are diameters.",
    );
    put(&mut out, "pub mod said {\n    use super::{Diameter, Message, Said, Value};\n");
    for (index, (_, message)) in messages(rules).enumerate() {
        message_type(&mut out, index, message);
    }
    put(&mut out, "}\n");
    tables(&mut out, rules);
    out
}

/// The type of a message and its conversion to [`Message`]: its values in the order of `ARGUMENTS`, then its
/// alarm.
fn message_type(out: &mut String, index: usize, message: &Message) {
    let Message { name, doc, arguments, .. } = message;
    put(out, format_args!("    /// {doc}\n    #[derive(Clone, Debug, PartialEq)]"));
    if arguments.is_empty() {
        put(out, format_args!("    pub struct {name};\n"));
    } else {
        put(out, format_args!("    pub struct {name} {{"));
        for Argument { name, kind, doc, .. } in arguments {
            put(out, format_args!("        /// {doc}\n        pub {name}: {},", rust_type(*kind)));
        }
        put(out, "    }\n");
    }
    put(out, format_args!("    impl Said for {name} {{\n        const INDEX: u16 = {index};\n    }}\n"));
    let alarm = message.arguments.iter().filter(|argument| argument.kind == Type::Alarm);
    let values: Vec<String> = quoted(message)
        .chain(alarm)
        .map(|argument| value(argument.kind, &format!("said.{}", argument.name)))
        .collect();
    let said = if values.is_empty() { "_" } else { "said" };
    put(
        out,
        format_args!(
            "    impl From<{name}> for Message {{\n        #[inline(always)]\n        fn from({said}: {name}) -> Self {{"
        ),
    );
    put(
        out,
        format_args!("            Self::of({name}::INDEX, [{}])\n        }}\n    }}\n", values.join(", ")),
    );
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
    put(
        out,
        "];\n\n/// How severe the messages of each rule usually are, apart from `RULES`: the first picture needs no more.",
    );
    put(out, format_args!("static SEVERITIES: [Severity; {}] = [", rules.len()));
    for rule in rules {
        put(out, format_args!("    Severity::{},", rule.severity));
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

/// The index of each variant's text in the texts of a language. The generated code fails to compile if a
/// variant has no English text or a text has no variant.
fn places(rules: &[RuleFile], texts: &Texts) -> String {
    let mut out = format!(
        "/// The first line of each list: the order of its texts.\nconst ORDER: &str = {:?};\n\n/// How many texts each list has.\nconst COUNT: usize = {};\n\n",
        texts::order(rules, texts),
        messages(rules).count() + texts.list.len()
    );
    let mut kinds: BTreeMap<&str, Vec<(usize, &str)>> = BTreeMap::new();
    for (index, text) in (messages(rules).count()..).zip(&texts.list) {
        kinds.entry(&text.kind).or_default().push((index, &text.variant));
    }
    for (kind, variants) in kinds {
        put(
            &mut out,
            format_args!("impl Place for {kind} {{\n    fn place(self) -> usize {{\n        match self {{"),
        );
        for (index, variant) in variants {
            put(&mut out, format_args!("            {kind}::{variant} => {index},"));
        }
        put(&mut out, "        }\n    }\n}\n");
    }
    out
}

/// A value of each message from the samples of its arguments, one for each alarm.
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
            put(&mut out, format_args!("        said::{}{fields}.into(),", message.name));
        }
    }
    put(&mut out, "    ]\n}");
    out
}

/// The arguments that are inserted into sentences.
fn quoted(message: &Message) -> impl Iterator<Item = &Argument> {
    message.arguments.iter().filter(|argument| argument.kind != Type::Alarm)
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
        Type::Letter => format!("Value::Letter({name})"),
        Type::Text | Type::Word => format!("Value::Text({name}.into())"),
        Type::Alarm => format!("Value::Alarm({name})"),
        Type::Count => format!("Value::count({name})"),
        Type::Index => format!("Value::Count(i64::from({name}))"),
        Type::Program => format!("Value::Program({name})"),
        Type::Integer => format!("Value::Count({name})"),
        Type::Number => format!("Value::Number({name})"),
        Type::Length => format!("Value::Length({name})"),
        Type::Diameter => format!("Value::Length({name}.mm())"),
    }
}

/// The page of each rule, for the command line.
fn pages(rules: &[RuleFile]) -> String {
    let mut out = String::new();
    put(&mut out, "/// The pages of all rules, by slug.");
    put(&mut out, format_args!("static PAGES: [Page; {}] = [", rules.len()));
    for RuleFile { slug, page, .. } in rules {
        let text = |text: &Text| {
            let [title, what, why, repair] = [&text.title, &text.what, &text.why, &text.repair].map(quote);
            format!("Text {{ title: {title}, what: {what}, why: {why}, repair: {repair} }}")
        };
        let texts = page.texts.iter().map(text).collect::<Vec<_>>().join(", ");
        let [slug, setup, wrong, right] = [slug, &page.setup, &page.wrong, &page.right].map(quote);
        put(
            &mut out,
            format_args!(
                "    Page {{ slug: {slug}, setup: {setup}, wrong: {wrong}, right: {right}, texts: [{texts}] }},"
            ),
        );
    }
    put(&mut out, "];");
    out
}

/// A Rust string literal.
fn quote(text: impl AsRef<str>) -> String {
    format!("{:?}", text.as_ref())
}

fn put(out: &mut String, line: impl Display) {
    let _ = writeln!(out, "{line}");
}
