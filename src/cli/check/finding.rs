//! Findings of a file: messages of its programs, and remarks about the page that contains them.
//!
//! In: analysed programs. Out: findings in the order of the file, each with its row for reports.

use crate::api::{self, InferredStock, Places};
use crate::message::{Diagnostic, Severity};
use crate::sentences::Language;

/// A checked file.
pub(super) struct Subject {
    /// Its name.
    pub name: String,
    /// Its text, in UTF-8.
    pub text: Vec<u8>,
    /// How many of its programs were checked, and how many opt out of the check.
    pub programs: Programs,
    /// Its findings.
    pub findings: Vec<Finding>,
}

/// Number of programs in a file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Programs {
    /// Programs that were checked.
    pub checked: usize,
    /// Programs that were skipped.
    pub left_out: usize,
}

/// A finding.
pub(super) struct Finding {
    /// Index of the program in the file, from 0.
    pub program: usize,
    /// Kind and content of the finding.
    pub what: What,
}

/// Kind and content of a finding.
pub(super) enum What {
    /// A message, with a span in the file.
    Message(Diagnostic),
    /// An error in the element that contains a program.
    Remark(Remark),
    /// The stock is inferred, so collisions were not checked. In a page, with line and column of the program.
    InferredStock(Option<(u32, u32)>, InferredStock),
}

/// An error in an element of a page.
pub(super) struct Remark {
    /// Line and column, from 1.
    pub place: (u32, u32),
    /// Slug of the fault.
    pub slug: &'static str,
    /// Message text.
    pub message: String,
}

impl Finding {
    /// Slug of the rule or of the fault; `None` if the finding is not a fault.
    pub(super) fn slug(&self) -> Option<&'static str> {
        match &self.what {
            What::Message(message) => Some(message.message.slug()),
            What::Remark(remark) => Some(remark.slug),
            What::InferredStock(..) => None,
        }
    }

    /// Severity; `None` if the finding is not a fault.
    pub(super) fn severity(&self) -> Option<Severity> {
        match &self.what {
            What::Message(message) => Some(message.severity),
            What::Remark(_) => Some(Severity::Error),
            What::InferredStock(..) => None,
        }
    }

    /// The row for reports; `None` if the finding is not a fault.
    pub(super) fn row(&self, places: Places<'_>, language: Language) -> Option<api::Diagnostic> {
        match &self.what {
            What::Message(message) => Some(places.diagnostic(message, language)),
            What::Remark(Remark { place: (line, column), slug, message }) => Some(api::Diagnostic {
                line: *line,
                column: *column,
                end_line: *line,
                end_column: *column,
                from: 0,
                to: 0,
                code: (*slug).to_owned(),
                slug: (*slug).to_owned(),
                severity: "error".to_owned(),
                kind: "wrong".to_owned(),
                message: message.clone(),
                help: None,
                alarm: None,
                fixes: Vec::new(),
            }),
            What::InferredStock(..) => None,
        }
    }
}
