//! Descriptions of codes, for the table of supported codes.

use super::language::Language;
use crate::control::codes::{Effect, Function, Section};

impl Section {
    /// The title in a language.
    pub fn title(self, language: Language) -> &'static str {
        language.text(self)
    }
}

impl Function {
    /// The description in a language.
    pub fn describe(self, language: Language) -> &'static str {
        language.text(self)
    }
}

impl Effect {
    /// The note on a code in a language; empty for a code that is executed.
    pub fn note(self, language: Language) -> &'static str {
        language.text(self)
    }
}
