//! Completion: codes, words with their values, existing numbers, and snippets with fields.
//!
//! In: a prepared place. Out: the proposals, the most likely first.

use gen_lsp_types::{
    CompletionItem, CompletionItemKind, CompletionItemTextEdit, CompletionList, CompletionParams,
    CompletionResponse, CompletionTriggerKind, InsertTextFormat, Range, TextEdit,
};

use super::context::Asked;
use super::message::Failure;
use crate::api::assist::{self, CompletionHelp};

/// The answer to `textDocument/completion`.
pub fn completion(asked: &Asked, params: &CompletionParams) -> Result<Option<CompletionResponse>, Failure> {
    let trigger = params.context.as_ref().map(|context| context.trigger_kind);
    let is_explicit = trigger.is_none_or(|kind| kind == CompletionTriggerKind::Invoked);
    let end = asked.document.run().state();
    let help = asked.at_place(|byte, query, reader| reader.completion(query, byte, end, is_explicit));
    Ok(help.map(|help| CompletionResponse::CompletionList(list(asked, &help))))
}

fn list(asked: &Asked, help: &CompletionHelp) -> CompletionList {
    let range = asked.positions().range_of_offsets(help.from, help.to);
    let typed = asked.positions().span(range).quote(asked.text()).to_lowercase();
    let items = help.items.iter().enumerate();
    CompletionList {
        // Another letter can lead to other proposals.
        is_incomplete: true,
        items: items.map(|(index, own)| item(asked, own, index, range, &typed)).collect(),
        ..CompletionList::default()
    }
}

fn item(
    asked: &Asked,
    own: &assist::CompletionItem,
    index: usize,
    range: Range,
    typed: &str,
) -> CompletionItem {
    let has_fields = asked.client.inserts_snippets && !own.fills.is_empty();
    let text = asked.with_line_ends(&own.text);
    let new_text = if has_fields { snippet(&own.text, &own.fills) } else { text };
    // Clients filter by the typed text: `G1` finds G01, `rough` finds G71.
    let begins_so = own.text.to_lowercase().starts_with(typed);
    CompletionItem {
        label: own.label.clone(),
        kind: Some(kind(own.kind)),
        detail: Some(own.detail.clone()),
        sort_text: Some(format!("{index:04}")),
        filter_text: Some(if begins_so { own.text.clone() } else { typed.to_owned() }),
        insert_text_format: has_fields.then_some(InsertTextFormat::Snippet),
        text_edit: Some(CompletionItemTextEdit::TextEdit(TextEdit { range, new_text })),
        ..CompletionItem::default()
    }
}

fn kind(name: &str) -> CompletionItemKind {
    match name {
        "code" => CompletionItemKind::Keyword,
        "place" => CompletionItemKind::Reference,
        "variable" => CompletionItemKind::Variable,
        "snippet" => CompletionItemKind::Snippet,
        _ => CompletionItemKind::Value,
    }
}

/// A text with fields, in the syntax of snippets. Completions are ASCII, so offsets are bytes.
fn snippet(text: &str, fills: &[(u32, u32)]) -> String {
    let mut out = String::new();
    let mut last = 0;
    for (number, &(from, to)) in (1..).zip(fills) {
        let (from, to) = (from as usize, to as usize);
        out += &escaped(text.get(last..from).unwrap_or_default());
        out += &format!("${{{number}:{}}}", escaped(text.get(from..to).unwrap_or_default()));
        last = to;
    }
    out + &escaped(text.get(last..).unwrap_or_default()) + "$0"
}

fn escaped(text: &str) -> String {
    let escape =
        |letter: char| matches!(letter, '$' | '}' | '\\').then_some('\\').into_iter().chain([letter]);
    text.chars().flat_map(escape).collect()
}

#[cfg(test)]
mod tests {
    use super::snippet;

    #[test]
    fn fields_are_numbered_and_signs_escaped() {
        assert_eq!(snippet("G71 U2 R1", &[(5, 6), (8, 9)]), "G71 U${1:2} R${2:1}$0");
        assert_eq!(snippet("#1=$}\\", &[]), "#1=\\$\\}\\\\$0");
    }
}
