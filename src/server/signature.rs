//! Signature help: the words of a cycle or a move, and the one at the cursor.
//!
//! In: a prepared place. Out: a signature for each block of the form, such as the two blocks of G71.

use gen_lsp_types::{
    ActiveParameter, Documentation, ParameterInformation, ParameterInformationLabel, SignatureHelp,
    SignatureHelpParams, SignatureInformation,
};

use super::context::Asked;
use super::message::Failure;
use crate::api::assist::{FormLine, FormWord};

/// The answer to `textDocument/signatureHelp`.
pub fn signature(asked: &Asked, _: &SignatureHelpParams) -> Result<Option<SignatureHelp>, Failure> {
    let form = asked.at_place(|byte, query, reader| reader.form(query, byte));
    Ok(form.map(|form| {
        let own = form.lines.iter().position(|line| line.own).unwrap_or_default();
        SignatureHelp {
            signatures: form.lines.iter().map(|line| information(asked, line)).collect(),
            active_signature: Some(own as u32),
            active_parameter: form.lines.get(own).and_then(active),
        }
    }))
}

/// The word at the cursor, or the next one to write: the first that is required, or else the first that is
/// left out.
fn active(line: &FormLine) -> Option<ActiveParameter> {
    let find = |is: fn(&FormWord) -> bool| line.words.iter().position(is);
    let index = find(|word| word.marked)
        .or_else(|| find(|word| word.state == "missing"))
        .or_else(|| find(|word| word.state == "left-out"))?;
    Some(ActiveParameter::Int(index as u32))
}

/// `G90 X/U Z/W [R] [F]`: words in brackets can be left out.
fn information(asked: &Asked, line: &FormLine) -> SignatureInformation {
    let mut label = line.code.clone();
    let mut parameters = Vec::new();
    for word in &line.words {
        let shown = if word.optional { format!("[{}]", word.letters) } else { word.letters.clone() };
        label.push(' ');
        // The label is ASCII: bytes are UTF-16 units.
        let from = label.len() as u32;
        label += &shown;
        let label = match asked.client.marks_by_offset {
            true => ParameterInformationLabel::Tuple((from, label.len() as u32)),
            false => ParameterInformationLabel::String(shown),
        };
        parameters.push(ParameterInformation { label, documentation: Some(documentation(word)) });
    }
    SignatureInformation { label, parameters: Some(parameters), ..SignatureInformation::default() }
}

fn documentation(word: &FormWord) -> Documentation {
    let otherwise = if word.otherwise.is_empty() { String::new() } else { format!(" ({})", word.otherwise) };
    Documentation::String(format!("{}: {}{otherwise}", word.letters, word.title))
}
