//! Definition, references and highlights of a number: a sequence number, a program, a variable.
//!
//! In: a position. Out: the places of the number. A program that the document does not contain is searched
//! for in the other open documents.

use gen_lsp_types::{
    Definition, DefinitionParams, DefinitionResponse, DocumentHighlight, DocumentHighlightKind,
    DocumentHighlightParams, Location, Position, ReferenceParams, Uri,
};

use super::context::{Asked, Context};
use super::message::Failure;
use crate::assist::names::{Name, Named};
use crate::assist::uses::{Uses, uses};
use crate::control::program::Labels;
use crate::source::{Span, line_end};

/// The answer to `textDocument/definition`.
pub fn definition(
    context: &Context,
    uri: &Uri,
    params: &DefinitionParams,
) -> Result<Option<DefinitionResponse>, Failure> {
    let asked = context.asked(uri)?;
    let found = uses_at(&asked, params.text_document_position_params.position);
    let locations = found.map_or_else(Vec::new, |(found, own)| match defining(&found, own) {
        places if !places.is_empty() => places.iter().map(|named| asked.location(named.span)).collect(),
        _ => elsewhere(context, uri, found.name),
    });
    let response = DefinitionResponse::Definition(Definition::LocationList(locations));
    Ok(Some(response))
}

/// The definitions of a number: of a variable all assignments, otherwise that which the control finds.
fn defining(found: &Uses, own: Named) -> Vec<Named> {
    let all = found.places.iter().filter(|named| named.defines).copied();
    match found.name {
        Name::Variable(_) => all.collect(),
        _ if own.defines => vec![own],
        _ => found.places.get(found.next).filter(|named| named.defines).copied().into_iter().collect(),
    }
}

/// A program in another open document.
fn elsewhere(context: &Context, uri: &Uri, name: Name) -> Vec<Location> {
    let Name::Program(number) = name else { return Vec::new() };
    let others = context.all().filter(|other| other.address != uri.as_ref());
    let head = |other: Asked| {
        let start = Labels::new(other.text()).program(number)?.byte;
        let end = line_end(other.text(), start as usize) as u32;
        Some(other.location(Span { start, end }))
    };
    others.filter_map(head).collect()
}

/// The answer to `textDocument/references`.
pub fn references(asked: &Asked, params: &ReferenceParams) -> Result<Option<Vec<Location>>, Failure> {
    let found = uses_at(asked, params.text_document_position_params.position);
    let with_definitions = params.context.include_declaration;
    Ok(found.map(|(found, _)| {
        let places = found.places.iter().filter(|named| with_definitions || !named.defines);
        places.map(|named| asked.location(named.span)).collect()
    }))
}

/// The answer to `textDocument/documentHighlight`.
pub fn highlights(
    asked: &Asked,
    params: &DocumentHighlightParams,
) -> Result<Option<Vec<DocumentHighlight>>, Failure> {
    let found = uses_at(asked, params.text_document_position_params.position);
    let highlight = |named: &Named| DocumentHighlight {
        range: asked.range(named.span),
        kind: Some(if named.defines { DocumentHighlightKind::Write } else { DocumentHighlightKind::Read }),
    };
    Ok(found.map(|(found, _)| found.places.iter().map(highlight).collect()))
}

/// The uses of the number at a position, and the use there.
fn uses_at(asked: &Asked, position: Position) -> Option<(Uses, Named)> {
    let byte = asked.positions().byte(position);
    let found = uses(asked.text(), asked.document.run().code_list(), byte)?;
    let is_here = |named: &&Named| named.span.start <= byte && byte <= named.span.end;
    let own = found.places.iter().find(is_here).copied()?;
    Some((found, own))
}
