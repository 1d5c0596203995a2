//! What is found in a file: messages of its programs, and remarks about a page that holds them.
//!
//! In: programs that were run. Out: findings in the order of the file, each with the row that reports have of it.

use crate::api::{self, InferredStock, Places};
use crate::message::{Diagnostic, Severity};
use crate::sentences::Language;

/// A file that was looked into.
pub(super) struct Subject {
    /// Its name.
    pub name: String,
    /// Its text, as UTF-8.
    pub text: Vec<u8>,
    /// How many programs are in it that were checked, and how many that say they are not to be.
    pub programs: Programs,
    /// What was found.
    pub findings: Vec<Finding>,
}

/// How many programs a file has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Programs {
    /// That were checked.
    pub checked: usize,
    /// That are left out.
    pub left_out: usize,
}

/// Something that was found.
pub(super) struct Finding {
    /// The program of the file it is about, from 0.
    pub program: usize,
    /// What.
    pub what: What,
}

/// What was found.
pub(super) enum What {
    /// A message, by places of the file.
    Message(Diagnostic),
    /// Something about the element that holds a program: an error.
    Remark(Remark),
    /// The stock is assumed: no collisions were looked for. Of a program in a page, with its place.
    AssumedStock(Option<(u32, u32)>, InferredStock),
}

/// Something about an element in a page.
pub(super) struct Remark {
    /// Line and column, from 1.
    pub place: (u32, u32),
    /// The name of the fault.
    pub slug: &'static str,
    /// A sentence.
    pub message: String,
}

impl Finding {
    /// The rule, or the name of the fault; nothing for what is no fault.
    pub(super) fn slug(&self) -> Option<&'static str> {
        match &self.what {
            What::Message(message) => Some(message.message.slug()),
            What::Remark(remark) => Some(remark.slug),
            What::AssumedStock(..) => None,
        }
    }

    /// Its severity; nothing for what is no fault.
    pub(super) fn severity(&self) -> Option<Severity> {
        match &self.what {
            What::Message(message) => Some(message.severity),
            What::Remark(_) => Some(Severity::Error),
            What::AssumedStock(..) => None,
        }
    }

    /// The row of a report; nothing for what is no fault.
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
            What::AssumedStock(..) => None,
        }
    }
}
