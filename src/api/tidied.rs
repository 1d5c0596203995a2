//! Rows for a program that is formatted or renumbered.

use serde::Serialize;

#[cfg(target_arch = "wasm32")]
use tsify::Tsify;

use super::{Edit, Places};
use crate::format;
use crate::message;
use crate::proof::difference_by;
use crate::renumber::{self, Numbering, Source};
use crate::run::Run;
use crate::sentences::Language;
use crate::source::Span;

/// The edits that format or renumber a program, or why it stays as it is.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
#[serde(tag = "kind", rename_all = "camelCase")]
pub enum Tidied {
    /// The program is the same with these edits; none if there is nothing to change.
    Edits {
        /// The edits, sorted by place.
        edits: Vec<Edit>,
    },
    /// The program stays as it is.
    Refused {
        /// The line of the reason, from 1.
        #[serde(skip_serializing_if = "Option::is_none")]
        #[cfg_attr(target_arch = "wasm32", tsify(optional))]
        line: Option<u32>,
        /// The reason, without a full stop.
        reason: String,
    },
}

impl Places<'_> {
    /// The edits that write blanks, case and leading zeros of G and M codes uniformly.
    pub fn formatted(&self, run: &Run, language: Language) -> Tidied {
        self.proved(run, &format::edits(self.text), language)
    }

    /// The edits that write new sequence numbers, and the words that refer to them.
    pub fn renumbered(&self, run: &Run, numbering: Numbering, language: Language) -> Tidied {
        let control = run.setup().dialect.control.unwrap_or_default();
        let source = Source { text: self.text, own: self.text.len(), codes: run.code_list(), control };
        match renumber::edits(source, numbering) {
            Ok(edits) => self.proved(run, &edits, language),
            Err(refused) => self.refused(Some(refused.span), refused.reason(self.text, language)),
        }
    }

    fn proved(&self, run: &Run, edits: &[message::Edit], language: Language) -> Tidied {
        match difference_by(edits, run) {
            Some(found) => self.refused(found.span(), found.reason(language).to_owned()),
            None => {
                let rows = edits.iter().map(|edit| self.edit(edit.span, edit.text.clone()));
                Tidied::Edits { edits: rows.collect() }
            }
        }
    }

    fn refused(&self, span: Option<Span>, reason: String) -> Tidied {
        let line = span.map(|span| self.lines.line_of(span.start.min(self.text.len() as u32)) + 1);
        Tidied::Refused { line, reason }
    }
}
