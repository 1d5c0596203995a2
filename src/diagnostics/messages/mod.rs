//! The sentences, one exhaustive match for each language: a message without a translation does not compile.

pub mod codes;
mod en;
mod ru;
mod zh;

use super::message::Message;
use crate::geometry::virtual_plane::Surface;

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
}

/// What is said of a message.
pub struct Sentence {
    /// One sentence that stands alone.
    pub message: String,
    /// Why, and what to do about it.
    pub help: Option<String>,
}

impl Sentence {
    fn new(message: impl Into<String>) -> Self {
        Self { message: message.into(), help: None }
    }

    fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }
}

impl Message {
    /// The message in a language.
    pub fn sentence(&self, language: Language) -> Sentence {
        match language {
            Language::English => en::sentence(self),
            Language::Chinese => zh::sentence(self),
            Language::Russian => ru::sentence(self),
        }
    }

    /// The title of its repair in a language.
    pub fn fix_title(&self, language: Language) -> String {
        match language {
            Language::English => en::fix_title(self),
            Language::Chinese => zh::fix_title(self),
            Language::Russian => ru::fix_title(self),
        }
    }
}

/// What a stroke of the picture is, in a language; `passes` is how many its cycle makes.
pub fn describe_motion(motion: &crate::motion::Motion, passes: Option<u32>, language: Language) -> String {
    match language {
        Language::English => en::motion(motion, passes),
        Language::Chinese => zh::motion(motion, passes),
        Language::Russian => ru::motion(motion, passes),
    }
}

/// Where a motion ends, in the words of a block; behind an arrow the place of the machine, where the program counts
/// in a virtual plane.
fn end_of(motion: &crate::motion::Motion) -> String {
    let (x, z) = (number(2.0 * motion.to.x), number(motion.to.z));
    let Some(rotary) = motion.rotary else { return format!("X{x} Z{z}") };
    let c = number(rotary.to);
    let Some(own) = rotary.virtual_move else { return format!("X{x} Z{z} C{c}°") };
    let end = own.way.at(1.0);
    match own.surface {
        Surface::Face => format!("X{} C{} Z{z} → X{x} C{c}°", number(2.0 * end.z), number(end.x)),
        Surface::Cylinder { .. } => format!("X{x} Z{z} C{c}°"),
    }
}

/// A number as people write it: at most four decimals, no trailing zeros, never `-0`.
pub fn number(value: f64) -> String {
    let mut text = format!("{value:.4}");
    while text.ends_with('0') {
        text.pop();
    }
    if text.ends_with('.') {
        text.pop();
    }
    if text == "-0" { "0".into() } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_read_as_people_write_them() {
        let cases = [(10.0, "10"), (-0.00001, "0"), (2.5, "2.5"), (1.0 / 3.0, "0.3333"), (-20.0, "-20")];
        for (value, text) in cases {
            assert_eq!(number(value), text);
        }
    }
}
