//! Fills the templates of the messages.
//!
//! In: a message, a language, the unit of the program. Out: its sentence and its help text. The templates
//! come from `src/rules/<slug>.md`.

use super::labels;
use super::language::Language;
use crate::message::{Arguments, Diagnostic, Message, Value};
use crate::units::{Unit, number};

/// The text of a message.
pub struct Sentence {
    /// A complete sentence.
    pub message: String,
    /// The reason, and how to fix it.
    pub help: Option<String>,
}

impl Diagnostic {
    /// The text of the diagnostic in a language, with lengths in its unit.
    pub fn sentence(&self, language: Language) -> Sentence {
        self.message.sentence_in(language, self.unit)
    }
}

impl Message {
    /// The message in a language, with lengths in millimetres.
    pub fn sentence(&self, language: Language) -> Sentence {
        self.sentence_in(language, Unit::Millimetre)
    }

    /// The message in a language, with lengths in a unit.
    pub fn sentence_in(&self, language: Language, unit: Unit) -> Sentence {
        let template = language.texts()[self.index()];
        let mut arguments = self.arguments();
        for (_, value) in &mut arguments {
            if let Value::Length(length) = value {
                *value = Value::Number(*length / unit.millimetres());
            }
        }
        arguments.push(("mm", Value::Text(labels::length(unit, language).into())));
        let (message, help) = match template.split_once('\t') {
            Some((message, help)) => (message, Some(fill(help, &arguments))),
            None => (template, None),
        };
        Sentence { message: fill(message, &arguments), help }
    }
}

/// Replaces `{names}` in a template by the arguments. Unknown names are kept.
pub(super) fn fill(template: &str, arguments: &Arguments) -> String {
    let mut out = String::with_capacity(template.len() + 16);
    let mut rest = template.split('{');
    out.push_str(rest.next().unwrap_or_default());
    for part in rest {
        let value =
            |name: &str| arguments.iter().find(|argument| argument.0 == name).map(|argument| &argument.1);
        match part.split_once('}').and_then(|(name, behind)| Some((value(name)?, behind))) {
            Some((value, behind)) => {
                write(value, &mut out);
                out.push_str(behind);
            }
            None => {
                out.push('{');
                out.push_str(part);
            }
        }
    }
    out
}

fn write(value: &Value, out: &mut String) {
    match *value {
        Value::Text(ref text) => out.push_str(text),
        Value::Alarm(alarm) => out.push_str(alarm),
        Value::Letter(letter) => out.push(letter),
        Value::Count(count) => out.push_str(&count.to_string()),
        // A length was converted to the unit of the program before.
        Value::Number(value) | Value::Length(value) => out.push_str(&number(value)),
        Value::Program(program) => {
            let digits = program.to_string();
            out.extend(std::iter::repeat_n('0', 4usize.saturating_sub(digits.len())));
            out.push_str(&digits);
        }
    }
}
