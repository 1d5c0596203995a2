//! The sentences. A message has a [`Wording`] and arguments; each language is one exhaustive match from wordings to
//! templates, so a message without a translation does not compile; one small function fills the templates in.

mod arguments;
pub mod codes;
mod en;
pub mod labels;
mod phrases;
mod ru;
pub(crate) mod samples;
mod wording;
mod zh;

use super::message::Message;
use crate::units::Unit;
use arguments::fill;
use phrases::Phrase;
pub use phrases::{describe_motion, describe_rewrite};
use wording::Wording;

/// A language the messages exist in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Language {
    /// English.
    #[default]
    English,
    /// Chinese, simplified.
    Chinese,
    /// Russian.
    Russian,
}

impl Language {
    /// All languages, in the order they are offered.
    pub const ALL: [Language; 3] = [Self::English, Self::Chinese, Self::Russian];

    /// Its tag: `en`, `zh`, `ru`.
    pub fn tag(self) -> &'static str {
        match self {
            Self::English => "en",
            Self::Chinese => "zh",
            Self::Russian => "ru",
        }
    }

    /// The language of a tag such as `zh` or `zh-CN`; English for one that is not spoken here.
    pub fn from_tag(tag: &str) -> Self {
        Self::ALL
            .into_iter()
            .find(|language| tag.to_ascii_lowercase().starts_with(language.tag()))
            .unwrap_or_default()
    }

    fn template(self, wording: Wording) -> &'static str {
        match self {
            Self::English => en::sentence(wording),
            Self::Chinese => zh::sentence(wording),
            Self::Russian => ru::sentence(wording),
        }
    }

    fn phrase(self, phrase: Phrase) -> &'static str {
        match self {
            Self::English => en::phrase(phrase),
            Self::Chinese => zh::phrase(phrase),
            Self::Russian => ru::phrase(phrase),
        }
    }
}

/// What is said of a message.
pub struct Sentence {
    /// One sentence that stands alone.
    pub message: String,
    /// Why, and what to do about it.
    pub help: Option<String>,
}

impl Message {
    /// The message in a language, lengths in millimetres.
    pub fn sentence(&self, language: Language) -> Sentence {
        self.sentence_in(language, Unit::Millimetre)
    }

    /// The message in a language, lengths in a unit.
    pub fn sentence_in(&self, language: Language, unit: Unit) -> Sentence {
        let template = language.template(Wording::of(self));
        let arguments = self.arguments_in(language, unit);
        let (message, help) = match template.split_once('\n') {
            Some((message, help)) => (message, Some(fill(help, &arguments))),
            None => (template, None),
        };
        Sentence { message: fill(message, &arguments), help }
    }
}
