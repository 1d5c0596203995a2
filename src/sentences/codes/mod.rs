//! What each code does, for the table of supported codes: one exhaustive match for each language.

mod en;
mod ru;
mod zh;

use super::language::Language;
use crate::control::codes::{Effect, Function, Section};

impl Section {
    /// Its title in a language.
    pub fn title(self, language: Language) -> &'static str {
        match language {
            Language::English => en::title(self),
            Language::Chinese => zh::title(self),
            Language::Russian => ru::title(self),
        }
    }
}

impl Function {
    /// What it does, in a language.
    pub fn describe(self, language: Language) -> &'static str {
        match language {
            Language::English => en::describe(self),
            Language::Chinese => zh::describe(self),
            Language::Russian => ru::describe(self),
        }
    }
}

impl Effect {
    /// The note beside a code in a language; empty for a code that is carried out.
    pub fn note(self, language: Language) -> &'static str {
        match language {
            Language::English => en::note(self),
            Language::Chinese => zh::note(self),
            Language::Russian => ru::note(self),
        }
    }
}
