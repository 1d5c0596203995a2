//! Inlay hints: where incremental words lead and, on request, the code in force, the feed per minute, and the
//! number of passes.
//!
//! In: a document whose hints in a range are prepared. Out: the hints of the client.

use gen_lsp_types::{InlayHint, InlayHintParams, Label};

use super::context::Asked;
use super::hinting::{Content, Hint};
use super::message::Failure;
use crate::sentences::server;

/// The answer to `textDocument/inlayHint`.
pub fn hints(asked: &Asked, _: &InlayHintParams) -> Result<Option<Vec<InlayHint>>, Failure> {
    Ok(Some(asked.document.hints().iter().map(|hint| shown(asked, hint)).collect()))
}

fn shown(asked: &Asked, hint: &Hint) -> InlayHint {
    let label = match &hint.content {
        Content::Absolute(text) | Content::Code(text) => text.clone(),
        Content::Feed(feed) => asked.reader().quantity(*feed),
        Content::Passes(passes) => server::passes(*passes, asked.language),
    };
    let is_before = matches!(hint.content, Content::Code(_));
    InlayHint {
        position: asked.positions().position(hint.at),
        label: Label::String(label),
        kind: None,
        text_edits: None,
        tooltip: None,
        padding_left: Some(!is_before),
        padding_right: is_before.then_some(true),
        data: None,
    }
}
