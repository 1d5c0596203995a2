//! What the client can do.
//!
//! In: the parameters of `initialize`. Out: a [`Client`]. The parameters are
//! read key by key, so that a wrong one that is not needed does not keep a client out.

use serde_json::Value;

use super::positions::Encoding;
use crate::sentences::Language;

/// The kind of the action that applies all safe fixes.
pub const FIX_ALL: &str = "source.fixAll.gcode-playground";

/// The optional hints that a client requests.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct HintKinds {
    /// The code in force, before the words of a move.
    pub code: bool,
    /// The feed per minute, after a feed per revolution.
    pub feed: bool,
    /// The number of passes, after the code of a cycle.
    pub passes: bool,
}

/// What the client can do.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Client {
    /// The unit of columns.
    pub encoding: Encoding,
    /// The language of the user.
    pub language: Language,
    /// The address of the folder with the rule pages.
    pub rules_url: Option<String>,
    /// Whether it asks for diagnostics; otherwise they are sent.
    pub pulls_diagnostics: bool,
    /// Whether it supports `workspace/diagnostic/refresh`.
    pub refreshes_diagnostics: bool,
    /// Whether it supports `workspace/inlayHint/refresh`.
    pub refreshes_hints: bool,
    /// Whether it supports `workspace/codeLens/refresh`.
    pub refreshes_lenses: bool,
    /// Whether it shows places that belong to a diagnostic.
    pub shows_related: bool,
    /// Whether it renders Markdown in a hover.
    pub reads_markdown: bool,
    /// Whether it inserts snippets with fields.
    pub inserts_snippets: bool,
    /// Whether a part of a signature can be given by its place.
    pub marks_by_offset: bool,
    /// Whether symbols can contain symbols.
    pub nests_symbols: bool,
    /// Whether edits can name the version of their document.
    pub checks_versions: bool,
    /// Whether it asks for the edit of an action when the user chooses the action.
    pub resolves_edits: bool,
    /// The hints that it requests.
    pub hints: HintKinds,
    /// Whether it requests lenses with times and passes.
    pub shows_lenses: bool,
    /// Whether it tells when files change.
    pub watches_files: bool,
}

impl Client {
    /// Reads the parameters of `initialize`.
    pub fn read(params: &Value) -> Self {
        let at = |path: &str| params.pointer(path).unwrap_or(&Value::Null);
        let has = |path: &str| *at(path) == Value::Bool(true);
        let lists = |path: &str, name: &str| {
            at(path).as_array().is_some_and(|list| list.iter().any(|one| one.as_str() == Some(name)))
        };
        let document = "/capabilities/textDocument";
        let has_document = |path: &str| has(&format!("{document}/{path}"));
        let encoding = match lists("/capabilities/general/positionEncodings", "utf-8") {
            true => Encoding::Utf8,
            false => Encoding::Utf16,
        };
        Self {
            encoding,
            language: at("/locale").as_str().map_or(Language::default(), Language::from_tag),
            rules_url: at("/initializationOptions/pages").as_str().map(rules_of_site),
            pulls_diagnostics: at(&format!("{document}/diagnostic")).is_object(),
            refreshes_diagnostics: has("/capabilities/workspace/diagnostics/refreshSupport"),
            refreshes_hints: has("/capabilities/workspace/inlayHint/refreshSupport"),
            refreshes_lenses: has("/capabilities/workspace/codeLens/refreshSupport"),
            shows_related: has_document("publishDiagnostics/relatedInformation")
                || has_document("diagnostic/relatedInformation"),
            reads_markdown: lists(&format!("{document}/hover/contentFormat"), "markdown"),
            inserts_snippets: has_document("completion/completionItem/snippetSupport"),
            marks_by_offset: has_document(
                "signatureHelp/signatureInformation/parameterInformation/labelOffsetSupport",
            ),
            nests_symbols: has_document("documentSymbol/hierarchicalDocumentSymbolSupport"),
            checks_versions: has("/capabilities/workspace/workspaceEdit/documentChanges"),
            resolves_edits: lists(&format!("{document}/codeAction/resolveSupport/properties"), "edit"),
            hints: {
                let has = |name| lists("/initializationOptions/hints", name);
                HintKinds { code: has("code"), feed: has("feed"), passes: has("passes") }
            },
            shows_lenses: has("/initializationOptions/codeLens"),
            watches_files: has("/capabilities/workspace/didChangeWatchedFiles/dynamicRegistration"),
        }
    }
}

/// The address of the folder with the rule pages of a site.
fn rules_of_site(address: &str) -> String {
    format!("{}/rules", address.trim_end_matches('/'))
}
