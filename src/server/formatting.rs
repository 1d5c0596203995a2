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

/// The answer to `textDocument/formatting`, in slices. The options of the editor, such as the width of a tab, have
/// no effect.
pub fn formatting(
    comparison: &mut Option<Comparison>,
    asked: &Asked,
    _: &DocumentFormattingParams,
) -> Progress<Option<Vec<TextEdit>>> {
    let (run, text) = (asked.document.run(), asked.text());
    let comparison = match comparison {
        Some(begun) => begun,
        None => {
            let mut changed = format::formatted(text);
            if changed == text {
                return Poll::Ready(Ok(Some(Vec::new())));
            }
            // Subprograms from other files follow the text.
            changed.extend_from_slice(&run.text()[text.len()..]);
            comparison.insert(Comparison::new(run, changed))
        }
    };
    let found = ready!(comparison.advance(run, BLOCKS));
    Poll::Ready(match found {
        Some(found) => Err(refused(asked, found)),
        None => {
            let subprograms = run.text().len() - text.len();
            let changed = comparison.changed();
            let own = &changed[..changed.len() - subprograms];
            Ok(Some(asked.text_edits(&changed_lines(text, own))))
        }
    })
}

fn refused(asked: &Asked, found: Difference) -> Failure {
    let line = found.span().map(|span| asked.document.lines().line_of(span.start) + 1);
    let message = server::not_formatted(line, found.reason(asked.language), asked.language);
    Failure::new(Reason::RequestFailed, message)
}
