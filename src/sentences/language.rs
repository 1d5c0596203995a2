//! The languages of all texts.

/// A language of the messages.
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
    /// All languages, in the order of menus.
    pub const ALL: [Language; 3] = [Self::English, Self::Chinese, Self::Russian];

    /// Its tag: `en`, `zh`, `ru`.
    pub fn tag(self) -> &'static str {
        match self {
            Self::English => "en",
            Self::Chinese => "zh",
            Self::Russian => "ru",
        }
    }

    /// The language of a tag such as `zh` or `zh-CN`; English if the language is not supported.
    pub fn from_tag(tag: &str) -> Self {
        Self::ALL
            .into_iter()
            .find(|language| tag.to_ascii_lowercase().starts_with(language.tag()))
            .unwrap_or_default()
    }
}
