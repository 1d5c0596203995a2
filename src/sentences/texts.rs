//! The texts of each language: a list that the build script makes from the rule files and
//! `src/sentences/<language>.txt`.
//!
//! The module of the page contains no list; the page loads the file of its language
//! ([`Language::load`]). Every other program contains all lists.

use std::sync::OnceLock;

use super::assist::Told;
use super::language::Language;
use super::phrases::Phrase;
use crate::assist::role::Role;
use crate::control::codes::{Effect, Function, Section};
use crate::control::origins::Modal;

/// A variant that has a text.
pub(super) trait Place {
    /// Its index in the list of each language.
    fn place(self) -> usize;
}

include!(concat!(env!("OUT_DIR"), "/places.rs"));

/// The texts of each language: first the sentence and help of each message, by its index, then those that have a [`Place`].
static TEXTS: [OnceLock<Vec<&'static str>>; 3] = [const { OnceLock::new() }; 3];

impl Language {
    pub(super) fn texts(self) -> &'static [&'static str] {
        #[cfg(not(parts))]
        return TEXTS[self as usize].get_or_init(|| self.list().lines().skip(1).collect());
        #[cfg(parts)]
        return TEXTS[self as usize].get().unwrap_or_else(|| crate::parts::missing(self.tag()));
    }

    pub(super) fn text(self, of: impl Place) -> &'static str {
        self.texts()[of.place()]
    }

    /// The list of its texts, a line each.
    #[cfg(not(parts))]
    fn list(self) -> &'static str {
        match self {
            Self::English => include_str!(concat!(env!("OUT_DIR"), "/en.txt")),
            Self::Chinese => include_str!(concat!(env!("OUT_DIR"), "/zh.txt")),
            Self::Russian => include_str!(concat!(env!("OUT_DIR"), "/ru.txt")),
        }
    }

    /// Takes the list of its texts from the page, the first time. False: it is no list of this version.
    pub fn load(self, list: String) -> bool {
        // A list that was cut short is none either.
        let is_of_this_version = list.lines().next() == Some(ORDER) && list.lines().count() == COUNT + 1;
        if is_of_this_version {
            TEXTS[self as usize].get_or_init(|| String::leak(list).lines().skip(1).collect());
        }
        is_of_this_version
    }
}
