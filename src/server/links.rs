//! Document links: the rules that comments of the program name, to their pages.
//!
//! In: a document. Out: a link for each rule in a comment such as `(RULES NO-PROGRAM-END=OFF)`, if the site
//! with the pages is known.

use gen_lsp_types::{DocumentLink, DocumentLinkParams};

use super::context::Asked;
use super::diagnostics::rule_page;
use super::message::Failure;
use crate::message::RULES;
use crate::source::Span;

/// The keyword of the comments that name rules.
const KEYWORD: &[u8] = b"RULES";

/// The answer to `textDocument/documentLink`.
pub fn links(asked: &Asked, _: &DocumentLinkParams) -> Result<Option<Vec<DocumentLink>>, Failure> {
    let notes = asked.document.run().notes().spans();
    Ok(Some(notes.flat_map(|note| links_of(asked, note)).collect()))
}

fn links_of(asked: &Asked, note: Span) -> Vec<DocumentLink> {
    let words = words(asked.text(), note);
    let is_of_rules = words.first().is_some_and(|word| word.of(asked.text()).eq_ignore_ascii_case(KEYWORD));
    if is_of_rules { words.iter().filter_map(|word| link(asked, *word)).collect() } else { Vec::new() }
}

/// The words of a comment; a value after `=` is separate.
fn words(text: &[u8], note: Span) -> Vec<Span> {
    let end = (note.end as usize).min(text.len());
    let is_part = |at: &usize| text[*at].is_ascii_alphanumeric() || text[*at] == b'-';
    let mut words = Vec::new();
    let mut at = note.start as usize;
    while let Some(start) = (at..end).find(is_part) {
        let stop = (start..end).find(|at| !is_part(at)).unwrap_or(end);
        words.push(Span::new(start, stop));
        at = stop;
    }
    words
}

fn link(asked: &Asked, word: Span) -> Option<DocumentLink> {
    let name = word.quote(asked.text());
    let rule = RULES.iter().find(|rule| rule.slug.eq_ignore_ascii_case(&name))?;
    let target = rule_page(asked, rule.slug)?;
    Some(DocumentLink { range: asked.range(word), target: Some(target.into()), ..DocumentLink::default() })
}
