//! Rows for a program that is written in another form.

use serde::Serialize;

#[cfg(target_arch = "wasm32")]
use tsify::Tsify;

use super::{Edit, Places};
use crate::convert::{self, ProgramForm};
use crate::proof::{Difference, is_for_other_control};
use crate::run::Run;
use crate::sentences::Language;

/// The edits that write a program in another form, or why it stays as it is.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
#[serde(tag = "kind", rename_all = "camelCase", rename_all_fields = "camelCase")]
pub enum Converted {
    /// The program makes the same motions with these edits.
    Edits {
        /// The edits, sorted by place.
        edits: Vec<Edit>,
        /// Number of words, or blocks, that stay in their form.
        left: u32,
        /// The first of them.
        #[serde(skip_serializing_if = "Option::is_none")]
        #[cfg_attr(target_arch = "wasm32", tsify(optional))]
        first_left: Option<LeftWord>,
    },
    /// The program stays as it is.
    Refused {
        /// The reason, without a full stop.
        reason: String,
    },
}

/// A word, or a block, that stays in its form.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct LeftWord {
    /// Its line, from 1.
    pub line: u32,
    /// Its text.
    pub text: String,
}

impl Places<'_> {
    /// The edits that write the program in a form.
    pub fn converted(&self, run: &Run, form: ProgramForm, language: Language) -> Converted {
        if run.diagnostics().iter().any(is_for_other_control) {
            return Converted::Refused { reason: Difference::OtherControl.reason(language).to_owned() };
        }
        let found = convert::converted(self.text, self.text.len(), &run.setup_to_repeat(), form);
        let first_left = found.left.first().map(|word| LeftWord {
            line: self.lines.line_of(word.start.min(self.text.len() as u32)) + 1,
            text: word.quote(self.text),
        });
        Converted::Edits {
            edits: found.edits.iter().map(|edit| self.edit(edit.span, edit.text.clone())).collect(),
            left: found.left.len() as u32,
            first_left,
        }
    }
}
