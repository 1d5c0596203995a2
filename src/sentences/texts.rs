//! The texts of each language: lists that the build script generates from the rule files and
//! `src/sentences/<language>.txt`.
//!
//! The module of the page contains no list; the page loads the file of its language ([`Language::load`]).
//! Every other program contains all lists.

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

/// The texts of each language: first the sentence and help of each message, by its index, then the texts with
/// a [`Place`].
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

    /// The embedded list of texts, one per line.
    #[cfg(not(parts))]
    fn list(self) -> &'static str {
        match self {
            Self::English => include_str!(concat!(env!("OUT_DIR"), "/en.txt")),
            Self::Chinese => include_str!(concat!(env!("OUT_DIR"), "/zh.txt")),
            Self::Russian => include_str!(concat!(env!("OUT_DIR"), "/ru.txt")),
        }
    }

    /// Loads the list of texts from the page, on the first call. Returns false if the list is not of this
    /// version.
    pub fn load(self, list: String) -> bool {
        // A truncated list is rejected as well.
        let is_of_this_version = list.lines().next() == Some(ORDER) && list.lines().count() == COUNT + 1;
        if is_of_this_version {
            TEXTS[self as usize].get_or_init(|| String::leak(list).lines().skip(1).collect());
        }
        is_of_this_version
    }
}
