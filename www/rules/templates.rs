//! The message templates of one language as JSON, for the page.
//!
//! In: the rule files. Out: for each message, by name, its rule, the types of its arguments and its templates.

use serde_json::json;

use super::format::RuleFile;
use super::format::message::Type;

/// The templates in the language with this index in `LANGUAGES`, one message a line.
pub fn json(rules: &[RuleFile], language: usize) -> String {
    let messages = rules.iter().flat_map(|rule| rule.messages.iter().map(move |message| (rule, message)));
    let rows: Vec<String> = messages
        .map(|(rule, message)| {
            let said = &message.sentences[language];
            let quoted = message.arguments.iter().filter(|argument| argument.kind != Type::Alarm);
            let arguments: serde_json::Map<String, serde_json::Value> =
                quoted.map(|argument| (argument.name.clone(), argument.kind.name().into())).collect();
            let mut row = json!({ "rule": rule.slug, "arguments": arguments, "message": said.message });
            if let Some(help) = &said.help {
                row["help"] = help.as_str().into();
            }
            format!("{}: {row}", json!(message.name))
        })
        .collect();
    format!("{{\n{}\n}}\n", rows.join(",\n"))
}
