//! Rows of what can be written as a cycle.
//!
//! In: offers. Out: titles, places and edits for a page that knows no cycle.

use serde::Serialize;

#[cfg(target_arch = "wasm32")]
use tsify::Tsify;

use super::{Edit, Places};
use crate::rewrite::Offer;
use crate::sentences::Language;
use crate::source::Span;

/// Blocks that can be written as a cycle.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
#[serde(rename_all = "camelCase")]
pub struct Rewriting {
    /// What it does.
    pub title: String,
    /// The cycle's code as the program writes it.
    pub cycle: String,
    /// First line of the blocks, from 1.
    pub line: u32,
    /// Their last line.
    pub end_line: u32,
    /// UTF-16 offset of their start.
    pub from: u32,
    /// UTF-16 offset of their end.
    pub to: u32,
    /// The blocks as they are.
    pub before: String,
    /// The blocks as they are written then.
    pub after: String,
    /// The cursor or the selection stands in them.
    pub here: bool,
    /// What writes them so.
    pub edits: Vec<Edit>,
}

impl Places<'_> {
    /// The row of an offer; `selection` is where the reader is.
    pub fn rewriting(&self, offer: &Offer, selection: Option<Span>, language: Language) -> Rewriting {
        let (start, end) = self.corners(offer.span);
        let (from, to) = self.offsets(offer.span);
        let edits = offer.edits.iter().map(|edit| self.edit(edit.span, edit.text.clone()));
        // The cursor is in the blocks wherever it is on their lines.
        let on_lines = |selection: Span| {
            let line = |byte| self.lines.line_of(byte) + 1;
            line(selection.start) <= end.0 && start.0 <= line(selection.end)
        };
        Rewriting {
            title: offer.title(language),
            cycle: offer.code.clone(),
            line: start.0,
            end_line: end.0,
            from,
            to,
            before: offer.span.quote(self.text),
            after: offer.written(self.text),
            here: selection.is_some_and(on_lines),
            edits: edits.collect(),
        }
    }
}
