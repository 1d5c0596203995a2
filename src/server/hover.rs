//! Hover: the word at a position, its value and the facts about it.
//!
//! In: a prepared place. Out: Markdown, or plain text for a client that does not render it.

use gen_lsp_types::{Contents, Hover, HoverParams, MarkupContent, MarkupKind};

use super::context::Asked;
use super::message::Failure;
use crate::api::assist::WordHelp;
use crate::source::Span;

/// The answer to `textDocument/hover`.
pub fn hover(asked: &Asked, _: &HoverParams) -> Result<Option<Hover>, Failure> {
    let run = asked.document.run();
    let notes: Vec<Span> = run.notes().spans().collect();
    let help = asked.at_place(|byte, query, reader| reader.word(query, byte, &notes, run.motions()));
    Ok(help.map(|help| Hover {
        range: Some(asked.positions().range_of_offsets(help.from, help.to)),
        contents: Contents::MarkupContent(content(&help, asked.client.reads_markdown)),
    }))
}

fn content(help: &WordHelp, reads_markdown: bool) -> MarkupContent {
    match reads_markdown {
        true => MarkupContent { kind: MarkupKind::Markdown, value: markdown(help) },
        false => MarkupContent { kind: MarkupKind::PlainText, value: plain(help) },
    }
}

fn markdown(help: &WordHelp) -> String {
    let value = help.value.as_ref().map_or_else(String::new, |value| format!(" = {}", escaped(value)));
    let mut text = format!("**{}**: {}{value}", escaped(&help.word), escaped(&help.title));
    if !help.facts.is_empty() {
        text.push('\n');
    }
    for fact in &help.facts {
        text += &format!("\n* {}", escaped(&fact.text));
    }
    text
}

fn plain(help: &WordHelp) -> String {
    let value = help.value.as_ref().map_or_else(String::new, |value| format!(" = {value}"));
    let head = format!("{}: {}{value}", help.word, help.title);
    let facts = help.facts.iter().map(|fact| fact.text.clone());
    std::iter::once(head).chain(facts).collect::<Vec<_>>().join("\n")
}

/// Text without meaning as Markdown. Code in backticks, which the texts contain, stays code.
pub fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    // An opening backtick without a closing one is escaped, too.
    let codes = text.matches('`').count() / 2;
    for (index, part) in text.split('`').enumerate() {
        let is_code = index % 2 == 1 && index / 2 < codes;
        match (index, is_code) {
            (0, _) => {}
            (_, true) => out.push('`'),
            (index, false) if index % 2 == 0 => out.push('`'),
            _ => out += "\\`",
        }
        if is_code { out.push_str(part) } else { out.extend(part.chars().flat_map(with_backslash)) }
    }
    out
}

fn with_backslash(letter: char) -> impl Iterator<Item = char> {
    let has_meaning = matches!(
        letter,
        '\\' | '*' | '_' | '{' | '}' | '[' | ']' | '<' | '>' | '#' | '|' | '~' | '!' | '&' | '$'
    );
    has_meaning.then_some('\\').into_iter().chain([letter])
}

#[cfg(test)]
mod tests {
    use super::escaped;

    #[test]
    fn signs_of_markdown_are_escaped_and_code_stays() {
        assert_eq!(escaped("#1 = [2*3]"), "\\#1 = \\[2\\*3\\]");
        assert_eq!(escaped("in `#1*2` and <b>"), "in `#1*2` and \\<b\\>");
        assert_eq!(escaped("a ` b*"), "a \\` b\\*");
        assert_eq!(escaped("外圆 Ø50 mm"), "外圆 Ø50 mm");
    }
}
