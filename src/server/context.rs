//! What an answer is made from: the open documents, the client, the options of the server.
//!
//! In: a request whose document is prepared. Out: the views of the document that the answers need.

use std::collections::BTreeMap;

use gen_lsp_types::{
    DocumentChange, Edit as DocumentEdit, OptionalVersionedTextDocumentIdentifier, TextDocumentEdit,
    TextDocumentIdentifier,
};
use gen_lsp_types::{Location, Range, TextEdit, Uri, WorkspaceEdit};

use super::client::Client;
use super::document::Document;
use super::message::{Failure, Reason};
use super::positions::Positions;
use crate::api::Places;
use crate::api::assist::Reader;
use crate::assist::Query;
use crate::message::Edit;
use crate::sentences::Language;
use crate::source::{Span, only_line_end};

/// The open documents by address.
pub type Documents = BTreeMap<String, Document>;

/// What all answers are made from.
pub struct Context<'a> {
    /// The open documents.
    pub documents: &'a Documents,
    /// The client.
    pub client: &'a Client,
    /// The language of the options, which overrides all others.
    pub language: Option<Language>,
}

impl<'a> Context<'a> {
    /// A document for a request about it.
    pub fn asked(&self, uri: &Uri) -> Result<Asked<'a>, Failure> {
        let found = self.documents.get_key_value(uri.as_ref());
        let (address, document) = found.ok_or_else(|| not_open(uri))?;
        Ok(Asked { address, document, client: self.client, language: self.language_of(document) })
    }

    /// All documents.
    pub fn all(&self) -> impl Iterator<Item = Asked<'a>> {
        self.documents.iter().map(|(address, document)| {
            let language = self.language_of(document);
            Asked { address, document, client: self.client, language }
        })
    }

    fn language_of(&self, document: &Document) -> Language {
        self.language.or(document.language()).unwrap_or(self.client.language)
    }
}

/// The error of a request about a document that is not open.
pub fn not_open(uri: &Uri) -> Failure {
    Failure::new(Reason::InvalidParams, format!("{uri} is not open"))
}

/// A document that a request is about.
#[derive(Clone, Copy)]
pub struct Asked<'a> {
    /// Its address.
    pub address: &'a str,
    /// The document.
    pub document: &'a Document,
    /// The client.
    pub client: &'a Client,
    /// The language of the texts.
    pub language: Language,
}

impl<'a> Asked<'a> {
    /// Its text.
    pub fn text(&self) -> &'a [u8] {
        self.document.text()
    }

    /// Its positions.
    pub fn positions(&self) -> Positions<'a> {
        self.document.positions(self.client.encoding)
    }

    /// The range of a span.
    pub fn range(&self, span: Span) -> Range {
        self.positions().range(span)
    }

    /// The place of a span.
    pub fn location(&self, span: Span) -> Location {
        Location { uri: self.address.into(), range: self.range(span) }
    }

    /// The texts about the document.
    pub fn reader(&self) -> Reader<'a> {
        let places = Places { text: self.text(), lines: self.document.lines() };
        Reader { places, language: self.language, unit: self.document.run().state().unit }
    }

    /// Calls `make` with the byte of the prepared place and the block there; `None` if there is none.
    pub fn at_place<R>(&self, make: impl FnOnce(u32, &Query, &Reader) -> Option<R>) -> Option<R> {
        let (byte, found) = self.document.found()?;
        let run = self.document.run();
        let block = found.block(run);
        make(byte, &Query::new(run, found, &block), &self.reader())
    }

    /// Edits of the document, for the client.
    pub fn edits(&self, edits: &[Edit]) -> WorkspaceEdit {
        self.workspace_edit(self.text_edits(edits))
    }

    /// Edits of the document, by themselves.
    pub fn text_edits(&self, edits: &[Edit]) -> Vec<TextEdit> {
        let (positions, line_end) = (self.positions(), only_line_end(self.text()));
        let edit = |edit: &Edit| TextEdit {
            range: positions.range(edit.span),
            new_text: with_line_end(&edit.text, line_end),
        };
        edits.iter().map(edit).collect()
    }

    /// New text with the line ends of the document.
    pub fn with_line_ends(&self, new: &str) -> String {
        with_line_end(new, only_line_end(self.text()))
    }

    fn workspace_edit(&self, edits: Vec<TextEdit>) -> WorkspaceEdit {
        let uri = Uri::from(self.address);
        if !self.client.checks_versions {
            return WorkspaceEdit { changes: Some([(uri, edits)].into()), ..WorkspaceEdit::default() };
        }
        let text_document = OptionalVersionedTextDocumentIdentifier {
            version: Some(self.document.version),
            text_document_identifier: TextDocumentIdentifier { uri },
        };
        let edits = edits.into_iter().map(DocumentEdit::TextEdit).collect();
        let change = DocumentChange::TextDocumentEdit(TextDocumentEdit { text_document, edits });
        WorkspaceEdit { document_changes: Some(vec![change]), ..WorkspaceEdit::default() }
    }
}

/// A text with the line ends of a document. The text may contain LF, CR LF or both.
fn with_line_end(new: &str, line_end: &str) -> String {
    if line_end == "\n" { new.to_owned() } else { new.replace("\r\n", "\n").replace('\n', line_end) }
}
