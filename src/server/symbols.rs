//! Symbols: the outline of a document, its foldable ranges, and the programs of all open documents.
//!
//! In: texts. Out: symbols in text order, nested if the client can show that. Needs no run.

use std::ops;

use gen_lsp_types::{
    BaseSymbolInformation, DocumentSymbol, DocumentSymbolParams, DocumentSymbolResponse, FoldingRange,
    FoldingRangeParams, Range, SymbolInformation, SymbolKind, WorkspaceSymbolParams, WorkspaceSymbolResponse,
};

use super::context::{Asked, Context};
use super::message::Failure;
use crate::api::assist::{OutlineEntry, OutlineHelp};
use crate::source::Span;

/// Maximum number of symbols in an answer about all documents.
const MAX_SYMBOLS: usize = 500;

/// The answer to `textDocument/documentSymbol`.
pub fn symbols(asked: &Asked, _: &DocumentSymbolParams) -> Result<Option<DocumentSymbolResponse>, Failure> {
    let outline = outline(asked);
    Ok(Some(match asked.client.nests_symbols {
        true => {
            let places = places(asked, &outline.entries);
            DocumentSymbolResponse::DocumentSymbolList(nested(
                asked,
                &outline.entries,
                &places,
                0..places.len(),
            ))
        }
        false => {
            let entries = outline.entries.iter();
            DocumentSymbolResponse::SymbolInformationList(
                entries.map(|entry| information(asked, entry)).collect(),
            )
        }
    }))
}

/// The answer to `textDocument/foldingRange`.
pub fn folds(asked: &Asked, _: &FoldingRangeParams) -> Result<Option<Vec<FoldingRange>>, Failure> {
    let folds = outline(asked).folds;
    let range = |&(from, to): &(u32, u32)| asked.positions().range_of_offsets(from, to);
    let fold = |range: Range| FoldingRange {
        start_line: range.start.line,
        start_character: Some(range.start.character),
        end_line: range.end.line,
        end_character: Some(range.end.character),
        ..FoldingRange::default()
    };
    Ok(Some(folds.iter().map(range).map(fold).collect()))
}

/// The answer to `workspace/symbol`: the programs whose number or comment contains the query.
pub fn programs(
    context: &Context,
    params: &WorkspaceSymbolParams,
) -> Result<Option<WorkspaceSymbolResponse>, Failure> {
    let query = params.query.to_lowercase();
    let fits = |entry: &OutlineEntry| {
        entry.kind == "program" && format!("{} {}", entry.name, entry.detail).to_lowercase().contains(&query)
    };
    let of_document = |asked: Asked| {
        let entries = outline(&asked).entries.into_iter().filter(fits);
        entries.map(|entry| information(&asked, &entry)).collect::<Vec<_>>()
    };
    let found = context.all().flat_map(of_document).take(MAX_SYMBOLS);
    Ok(Some(WorkspaceSymbolResponse::SymbolInformationList(found.collect())))
}

fn outline(asked: &Asked) -> OutlineHelp {
    asked.reader().outline(asked.document.run().code_list())
}

/// The first byte of the block of each entry.
fn places(asked: &Asked, entries: &[OutlineEntry]) -> Vec<u32> {
    let lines = asked.document.lines();
    entries.iter().map(|entry| lines.byte_at_utf16(asked.text(), entry.from)).collect()
}

/// The entries of a range, each with those below it.
fn nested(
    asked: &Asked,
    entries: &[OutlineEntry],
    places: &[u32],
    own: ops::Range<usize>,
) -> Vec<DocumentSymbol> {
    let mut symbols = Vec::new();
    let mut at = own.start;
    while at < own.end {
        let entry = &entries[at];
        let is_after = |next: &usize| entries[*next].depth <= entry.depth;
        let end = (at + 1..own.end).find(is_after).unwrap_or(own.end);
        let children = nested(asked, entries, places, at + 1..end);
        symbols.push(symbol(asked, entry, span_of(asked, places, at, end), children));
        at = end;
    }
    symbols
}

/// From the block of entry `at` to the block before entry `end`, which is the next one that does not belong
/// to it.
fn span_of(asked: &Asked, places: &[u32], at: usize, end: usize) -> Span {
    let (text, start) = (asked.text(), places[at] as usize);
    let until = places.get(end).map_or(text.len(), |next| *next as usize);
    Span::new(start, start + text[start..until.max(start)].trim_ascii_end().len())
}

#[allow(deprecated, reason = "the field must be given")]
fn symbol(asked: &Asked, entry: &OutlineEntry, span: Span, children: Vec<DocumentSymbol>) -> DocumentSymbol {
    DocumentSymbol {
        name: name(entry),
        detail: Some(entry.detail.clone()).filter(|detail| !detail.is_empty()),
        kind: kind(entry.kind),
        tags: None,
        deprecated: None,
        range: asked.range(span),
        selection_range: asked.range(own_line(asked, span)),
        children: Some(children).filter(|children| !children.is_empty()),
    }
}

/// The part of a span on its first line.
fn own_line(asked: &Asked, span: Span) -> Span {
    let end = crate::source::line_end(asked.text(), span.start as usize) as u32;
    Span { end: end.min(span.end), ..span }
}

#[allow(deprecated, reason = "the field must be given")]
fn information(asked: &Asked, entry: &OutlineEntry) -> SymbolInformation {
    let start = asked.document.lines().byte_at_utf16(asked.text(), entry.from);
    let end = crate::source::line_end(asked.text(), start as usize) as u32;
    let container_name = Some(entry.detail.clone()).filter(|detail| !detail.is_empty());
    SymbolInformation {
        deprecated: None,
        location: asked.location(Span { start, end }),
        base_symbol_information: BaseSymbolInformation {
            name: name(entry),
            kind: kind(entry.kind),
            tags: None,
            container_name,
        },
    }
}

/// The name of an entry; clients refuse an empty one.
fn name(entry: &OutlineEntry) -> String {
    if entry.name.is_empty() { "-".to_owned() } else { entry.name.clone() }
}

fn kind(name: &str) -> SymbolKind {
    match name {
        "program" => SymbolKind::Module,
        "tool" => SymbolKind::Class,
        "operation" => SymbolKind::Namespace,
        "cycle" => SymbolKind::Function,
        _ => SymbolKind::Key,
    }
}
