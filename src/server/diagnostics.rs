//! Diagnostics: the messages of a run, as the client shows them.
//!
//! In: a prepared document. Out: its messages, each with the place, the code and, if the site with the rule
//! pages is known, the address of its page.

use gen_lsp_types::{
    Code, CodeDescription, Diagnostic, DiagnosticRelatedInformation, DiagnosticSeverity,
    DocumentDiagnosticParams, DocumentDiagnosticReport, FullDocumentDiagnosticReport, Message,
    PublishDiagnosticsParams, RelatedFullDocumentDiagnosticReport,
};

use super::context::Asked;
use super::message::Failure;
use crate::message::{self, Severity, Value};
use crate::sentences::server;

/// The source that clients show beside a diagnostic.
const SOURCE: &str = "gcode-playground";

/// The answer to `textDocument/diagnostic`.
pub fn pulled(asked: &Asked, _: &DocumentDiagnosticParams) -> Result<DocumentDiagnosticReport, Failure> {
    let full_document_diagnostic_report = FullDocumentDiagnosticReport { result_id: None, items: all(asked) };
    Ok(DocumentDiagnosticReport::RelatedFullDocumentDiagnosticReport(RelatedFullDocumentDiagnosticReport {
        related_documents: None,
        full_document_diagnostic_report,
    }))
}

/// The parameters of `textDocument/publishDiagnostics`.
pub fn published(asked: &Asked) -> PublishDiagnosticsParams {
    PublishDiagnosticsParams {
        uri: asked.address.into(),
        version: Some(asked.document.version),
        diagnostics: all(asked),
    }
}

fn all(asked: &Asked) -> Vec<Diagnostic> {
    asked.document.messages().iter().map(|found| diagnostic(asked, found)).collect()
}

/// A message as a diagnostic.
pub fn diagnostic(asked: &Asked, found: &message::Diagnostic) -> Diagnostic {
    let sentence = found.sentence(asked.language);
    let message = match sentence.help {
        Some(help) => format!("{}\n{help}", sentence.message),
        None => sentence.message,
    };
    Diagnostic {
        range: asked.range(found.span),
        severity: Some(severity(found.severity)),
        code: Some(Code::String(found.code())),
        code_description: rule_page(asked, found.message.slug())
            .map(|address| CodeDescription { href: address.into() }),
        source: Some(SOURCE.to_owned()),
        message: Message::String(message),
        tags: None,
        related_information: related(asked, found),
        data: None,
    }
}

/// The address of the page of a rule; `None` if the folder is not known.
pub fn rule_page(asked: &Asked, slug: &str) -> Option<String> {
    let folder = asked.client.rules_url.as_ref().or(asked.document.settings().rules_url.as_ref())?;
    Some(asked.language.rule_page(folder, slug))
}

fn severity(severity: Severity) -> DiagnosticSeverity {
    match severity {
        Severity::Error => DiagnosticSeverity::Error,
        Severity::Warning => DiagnosticSeverity::Warning,
        Severity::Info | Severity::Off => DiagnosticSeverity::Information,
    }
}

/// The other lines that a message names.
fn related(asked: &Asked, found: &message::Diagnostic) -> Option<Vec<DiagnosticRelatedInformation>> {
    if !asked.client.shows_related {
        return None;
    }
    let arguments = found.message.arguments();
    let lines = arguments.iter().filter_map(|(name, value)| match value {
        Value::Count(line) if *name == "line" => u32::try_from(*line).ok()?.checked_sub(1),
        _ => None,
    });
    let lines = lines.filter(|line| *line < asked.document.lines().len());
    let related: Vec<_> = lines
        .map(|line| DiagnosticRelatedInformation {
            location: asked.location(asked.document.lines().line(asked.text(), line)),
            message: server::line(line + 1, asked.language),
        })
        .collect();
    (!related.is_empty()).then_some(related)
}
