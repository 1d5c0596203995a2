//! What each code does, for the table of supported codes.

use super::language::Language;
use crate::control::codes::{Effect, Function, Section};

impl Section {
    /// Its title in a language.
    pub fn title(self, language: Language) -> &'static str {
        language.text(self)
    }
}

impl Function {
    /// What it does, in a language.
    pub fn describe(self, language: Language) -> &'static str {
        language.text(self)
    }
}

impl Effect {
    /// The note beside a code in a language; empty for a code that is carried out.
    pub fn note(self, language: Language) -> &'static str {
        language.text(self)
    }
}
