//! Formatting: blanks, case and leading zeros, as the command `format` writes them.
//!
//! In: a document whose run has ended. Out: an edit for each changed line; or the reason why the program stays
//! as it is. The changed text is run, and its motions and messages must be the same.

use gen_lsp_types::{DocumentFormattingParams, TextEdit};

use super::context::Asked;
use super::message::{Failure, Reason};
use super::rewritten::changed_lines;
use crate::format;
use crate::message::applied;
use crate::proof::{Difference, difference_by};
use crate::sentences::server;

/// The answer to `textDocument/formatting`. The options of the editor, such as the width of a tab, have no
/// effect.
pub fn formatting(asked: &Asked, _: &DocumentFormattingParams) -> Result<Option<Vec<TextEdit>>, Failure> {
    let run = asked.document.run();
    let edits = format::edits(asked.text());
    // Subprograms from other files follow the text.
    match difference_by(&edits, run.text(), &run.setup_to_repeat()) {
        Some(found) => Err(refused(asked, found)),
        None => Ok(Some(asked.text_edits(&changed_lines(asked.text(), &applied(asked.text(), &edits))))),
    }
}

fn refused(asked: &Asked, found: Difference) -> Failure {
    let line = found.span().map(|span| asked.document.lines().line_of(span.start) + 1);
    let message = server::not_formatted(line, found.reason(asked.language), asked.language);
    Failure::new(Reason::RequestFailed, message)
}
