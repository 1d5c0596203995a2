//! Rename: a sequence number, a program or a variable, with all words that refer to it.
//!
//! In: a position and the new number. Out: the edits; or the reason for a refusal. The changed text is run,
//! and its motions must be the same.

use std::task::Poll;

use gen_lsp_types::{
    PrepareRenameParams, PrepareRenamePlaceholder, PrepareRenameResult, RenameParams, WorkspaceEdit,
};

use super::context::Asked;
use super::document::BLOCKS;
use super::message::{Failure, Progress, Reason};
use crate::assist::rename::{Refusal, renamed, renamed_at};
use crate::message::Edit;
use crate::rewrite::same_motions;
use crate::run::Run;
use crate::sentences::server;

/// The answer to `textDocument/prepareRename`: the word, which the user replaces.
pub fn prepare(asked: &Asked, params: &PrepareRenameParams) -> Result<Option<PrepareRenameResult>, Failure> {
    let byte = asked.positions().byte(params.text_document_position_params.position);
    let named = match renamed_at(asked.text(), asked.document.run().code_list(), byte) {
        Err(Refusal::NothingHere) => return Ok(None),
        found => found.map_err(|refusal| refused(asked, &refusal))?,
    };
    let placeholder = named.span.quote(asked.text());
    let found = PrepareRenamePlaceholder { range: asked.range(named.span), placeholder };
    Ok(Some(PrepareRenameResult::PrepareRenamePlaceholder(found)))
}

/// A rename whose motions are being checked.
pub struct Renaming {
    edits: Vec<Edit>,
    /// The run of the changed text.
    after: Run,
}

/// The answer to `textDocument/rename`, in slices.
pub fn rename(
    renaming: &mut Option<Renaming>,
    asked: &Asked,
    params: &RenameParams,
) -> Progress<Option<WorkspaceEdit>> {
    let run = asked.document.run();
    let Renaming { edits, after } = match renaming {
        Some(begun) => begun,
        None => {
            let byte = asked.positions().byte(params.text_document_position_params.position);
            let edits = match renamed(asked.text(), run.code_list(), byte, &params.new_name) {
                Ok(edits) => edits,
                Err(refusal) => return Poll::Ready(Err(refused(asked, &refusal))),
            };
            let after = asked.document.changed_run(&edits);
            let after = run.repeated(after, run.setup_to_repeat().block_skip);
            renaming.insert(Renaming { edits, after })
        }
    };
    if !after.advance(BLOCKS) {
        return Poll::Pending;
    }
    Poll::Ready(if is_same(run, after) {
        Ok(Some(asked.edits(edits)))
    } else {
        Err(Failure::new(Reason::RequestFailed, server::motions_would_change(asked.language)))
    })
}

/// Whether two programs make the same motions, and as many of their blocks cannot be executed.
fn is_same(before: &Run, after: &Run) -> bool {
    let errors = |run: &Run| run.diagnostics().iter().filter(|found| found.is_error()).count();
    same_motions(before.motions(), after.motions()) && errors(before) == errors(after)
}

fn refused(asked: &Asked, refusal: &Refusal) -> Failure {
    let line_of = |byte: u32| asked.document.lines().line_of(byte) + 1;
    Failure::new(Reason::RequestFailed, server::refusal(refusal, line_of, asked.language))
}
