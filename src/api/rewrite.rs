//! Rows for blocks that can be rewritten as a cycle.
//!
//! In: offers. Out: titles, places and edits for a page that knows no cycle.

use serde::Serialize;

#[cfg(target_arch = "wasm32")]
use tsify::Tsify;

use super::{Edit, Places};
use crate::rewrite::Offer;
use crate::sentences::Language;
use crate::source::Span;

/// Blocks that can be rewritten as a cycle.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
#[serde(rename_all = "camelCase")]
pub struct Rewriting {
    /// Description of the change.
    pub title: String,
    /// The code of the cycle, as the program writes it.
    pub cycle: String,
    /// First line of the blocks, from 1.
    pub line: u32,
    /// Last line of the blocks.
    pub end_line: u32,
    /// UTF-16 offset of the start.
    pub from: u32,
    /// UTF-16 offset of the end.
    pub to: u32,
    /// The current text of the blocks.
    pub before: String,
    /// The text after the change.
    pub after: String,
    /// Whether the cursor or the selection is in the blocks.
    pub here: bool,
    /// The edits that rewrite the blocks.
    pub edits: Vec<Edit>,
}

impl Places<'_> {
    /// The row of an offer; `selection` is the cursor or selection of the user.
    pub fn rewriting(&self, offer: &Offer, selection: Option<Span>, language: Language) -> Rewriting {
        let (start, end) = self.corners(offer.span);
        let (from, to) = self.offsets(offer.span);
        let edits = offer.edits.iter().map(|edit| self.edit(edit.span, edit.text.clone()));
        // The cursor counts as inside anywhere on the lines of the blocks.
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
