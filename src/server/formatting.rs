//! Formatting: blanks, case and leading zeros, as the command `format` writes them.
//!
//! In: a document whose run has ended. Out: an edit for each changed line; or the reason why the program stays
//! as it is. The changed text is run, and its motions and messages must be the same.

use std::task::{Poll, ready};

use gen_lsp_types::{DocumentFormattingParams, TextEdit};

use super::context::Asked;
use super::document::BLOCKS;
use super::message::{Failure, Progress, Reason};
use super::rewritten::changed_lines;
use crate::format;
use crate::proof::{Comparison, Difference};
use crate::sentences::server;

/// A formatted text that is being compared.
pub struct Formatting {
    text: Vec<u8>,
    comparison: Comparison,
}

impl Formatting {
    /// `None` if the text stays as it is.
    fn begin(asked: &Asked) -> Option<Self> {
        let (run, text) = (asked.document.run(), format::formatted(asked.text()));
        if text == asked.text() {
            return None;
        }
        let changed = match asked.document.has_subprograms() {
            true => asked.document.changed_run(&format::edits(asked.text())),
            false => text.clone(),
        };
        Some(Self { text, comparison: Comparison::new(run, changed) })
    }
}

/// The answer to `textDocument/formatting`, in slices. The options of the editor, such as the width of a tab, have
/// no effect.
pub fn formatting(
    formatting: &mut Option<Formatting>,
    asked: &Asked,
    _: &DocumentFormattingParams,
) -> Progress<Option<Vec<TextEdit>>> {
    if formatting.is_none() {
        *formatting = Formatting::begin(asked);
    }
    let Some(Formatting { text, comparison }) = formatting else {
        return Poll::Ready(Ok(Some(Vec::new())));
    };
    let found = ready!(comparison.advance(asked.document.run(), BLOCKS));
    Poll::Ready(match found {
        Some(found) => Err(refused(asked, found)),
        None => Ok(Some(asked.text_edits(&changed_lines(asked.text(), text)))),
    })
}

fn refused(asked: &Asked, found: Difference) -> Failure {
    let line = found.span().map(|span| asked.document.lines().line_of(span.start) + 1);
    let message = server::not_formatted(line, found.reason(asked.language), asked.language);
    Failure::new(Reason::RequestFailed, message)
}
