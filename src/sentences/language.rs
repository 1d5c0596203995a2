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

    /// The address of the page of a rule in this language. `folder`: the address of the folder `rules` of a site, which
    /// contains a folder for each language.
    pub fn rule_page(self, folder: &str, slug: &str) -> String {
        format!("{}/{}/{slug}.html", folder.trim_end_matches('/'), self.tag())
    }

    /// The language of a tag such as `zh` or `zh-CN`; English if the language is not supported.
    pub fn from_tag(tag: &str) -> Self {
        Self::ALL
            .into_iter()
            .find(|language| tag.to_ascii_lowercase().starts_with(language.tag()))
            .unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_page_of_a_rule_is_in_the_folder_of_its_language() {
        let chinese = "https://a.example/rules/zh/number-missing.html";
        for folder in ["https://a.example/rules", "https://a.example/rules/"] {
            assert_eq!(Language::Chinese.rule_page(folder, "number-missing"), chinese);
        }
    }
}
