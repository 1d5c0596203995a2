//! All that is said in one language, a part of the module each: a page loads that of its reader.

use super::assist::{self, Told};
use super::codes;
use super::language::Language;
use super::phrases::{self, Phrase};
use crate::assist::role::Role;
use crate::control::codes::{Effect, Function, Section};
use crate::control::origins::Modal;
use crate::parts::{Part, in_part};

/// The sentences.
mod templates {
    include!(concat!(env!("OUT_DIR"), "/sentences.rs"));
}

/// The texts of a language.
pub(super) struct Texts {
    /// The template of each message, by its index; on a second line that of its help.
    pub templates: &'static [&'static str],
    /// The title of a section of the table of codes.
    pub title: fn(Section) -> &'static str,
    /// What a code does.
    pub describe: fn(Function) -> &'static str,
    /// The note beside a code.
    pub note: fn(Effect) -> &'static str,
    /// A part of a sentence.
    pub phrase: fn(Phrase) -> &'static str,
    /// What a word is in its block.
    pub role: fn(Role) -> &'static str,
    /// The name of what is in force.
    pub modal: fn(Modal) -> &'static str,
    /// The template of a fact about a word or block.
    pub told: fn(Told) -> &'static str,
}

impl Language {
    /// The part of the module its texts are in.
    pub fn part(self) -> Part {
        match self {
            Self::English => Part::English,
            Self::Chinese => Part::Chinese,
            Self::Russian => Part::Russian,
        }
    }

    pub(super) fn texts(self) -> &'static Texts {
        match self {
            Self::English => english(),
            Self::Chinese => chinese(),
            Self::Russian => russian(),
        }
    }
}

macro_rules! texts {
    ($templates:ident, $language:ident) => {{
        static TEXTS: Texts = Texts {
            templates: &templates::$templates,
            title: codes::$language::title,
            describe: codes::$language::describe,
            note: codes::$language::note,
            phrase: phrases::$language::phrase,
            role: assist::$language::role,
            modal: assist::$language::modal,
            told: assist::$language::told,
        };
        &TEXTS
    }};
}

in_part! {
    English "0001" fn english() -> &'static Texts { texts!(EN, en) }
    Chinese "0002" fn chinese() -> &'static Texts { texts!(ZH, zh) }
    Russian "0003" fn russian() -> &'static Texts { texts!(RU, ru) }
}
