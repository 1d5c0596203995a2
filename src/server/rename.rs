//! Rename: a sequence number, a program or a variable, with all words that refer to it.
//!
//! In: a position and the new number. Out: the edits; or the reason for a refusal. The changed text is run,
//! and its motions must be the same.

use gen_lsp_types::{
    PrepareRenameParams, PrepareRenamePlaceholder, PrepareRenameResult, RenameParams, WorkspaceEdit,
};

use super::context::Asked;
use super::message::{Failure, Reason};
use crate::analyze;
use crate::assist::rename::{Refusal, renamed, renamed_at};
use crate::message::Edit;
use crate::message::applied;
use crate::rewrite::same_motions;
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

/// The answer to `textDocument/rename`.
pub fn rename(asked: &Asked, params: &RenameParams) -> Result<Option<WorkspaceEdit>, Failure> {
    let byte = asked.positions().byte(params.text_document_position_params.position);
    let codes = asked.document.run().code_list();
    let edits = renamed(asked.text(), codes, byte, &params.new_name);
    let edits = edits.map_err(|refusal| refused(asked, &refusal))?;
    if !keeps_motions(asked, &edits) {
        return Err(Failure::new(Reason::RequestFailed, server::motions_would_change(asked.language)));
    }
    Ok(Some(asked.edits(&edits)))
}

/// Whether the program with the edits makes the same motions, and as many of its blocks cannot be executed.
fn keeps_motions(asked: &Asked, edits: &[Edit]) -> bool {
    let (text, setup) = (asked.text(), asked.document.run().setup_to_repeat());
    let (before, after) = (analyze(text, &setup), analyze(&applied(text, edits), &setup));
    let errors = |analysis: &crate::run::Analysis| {
        analysis.diagnostics.iter().filter(|found| found.is_error()).count()
    };
    same_motions(&before.motions, &after.motions) && errors(&before) == errors(&after)
}

fn refused(asked: &Asked, refusal: &Refusal) -> Failure {
    let line_of = |byte: u32| asked.document.lines().line_of(byte) + 1;
    Failure::new(Reason::RequestFailed, server::refusal(refusal, line_of, asked.language))
}
