//! What each code does, for the table of supported codes: one exhaustive match for each language.

pub(super) mod en;
pub(super) mod ru;
pub(super) mod zh;

use super::language::Language;
use crate::control::codes::{Effect, Function, Section};

impl Section {
    /// Its title in a language.
    pub fn title(self, language: Language) -> &'static str {
        (language.texts().title)(self)
    }
}

impl Function {
    /// What it does, in a language.
    pub fn describe(self, language: Language) -> &'static str {
        (language.texts().describe)(self)
    }
}

impl Effect {
    /// The note beside a code in a language; empty for a code that is carried out.
    pub fn note(self, language: Language) -> &'static str {
        (language.texts().note)(self)
    }
}
