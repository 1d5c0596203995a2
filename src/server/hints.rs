//! Inlay hints: where incremental words lead.
//!
//! In: a document whose hints in a range are prepared. Out: the hints of the client.

use gen_lsp_types::{InlayHint, InlayHintParams, Label};

use super::context::Asked;
use super::message::Failure;

/// The answer to `textDocument/inlayHint`.
pub fn hints(asked: &Asked, _: &InlayHintParams) -> Result<Option<Vec<InlayHint>>, Failure> {
    let hints = asked.document.hints().iter().map(|hint| InlayHint {
        position: asked.positions().position(hint.at),
        label: Label::String(hint.text.clone()),
        kind: None,
        text_edits: None,
        tooltip: None,
        padding_left: Some(true),
        padding_right: None,
        data: None,
    });
    Ok(Some(hints.collect()))
}
