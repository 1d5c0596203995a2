//! The pages of the rules, which the build script takes from `src/rules`.
//!
//! In: a slug. Out: the page of the rule: title, texts, examples. Must not know: how a page or a report is written.

use crate::sentences::Language;

/// The page of a rule.
pub(super) struct Page {
    slug: &'static str,
    /// The setup of both programs, JSON; `{}` for the default.
    pub setup: &'static str,
    /// A program that triggers the rule.
    pub wrong: &'static str,
    /// The corrected program.
    pub right: &'static str,
    /// In English, Chinese, Russian.
    texts: [Text; 3],
}

/// The page in one language.
pub(super) struct Text {
    /// The name of the fault.
    pub title: &'static str,
    /// What the rule checks.
    pub what: &'static str,
    /// The consequence at the machine.
    pub why: &'static str,
    /// How to repair it.
    pub repair: &'static str,
}

include!(concat!(env!("OUT_DIR"), "/pages.rs"));

impl Page {
    /// The page of a rule; `None` if there is no rule with this slug.
    pub(super) fn of(slug: &str) -> Option<&'static Self> {
        PAGES.iter().find(|page| page.slug == slug)
    }

    /// Its texts in a language.
    pub(super) fn text(&self, language: Language) -> &Text {
        let [english, chinese, russian] = &self.texts;
        match language {
            Language::English => english,
            Language::Chinese => chinese,
            Language::Russian => russian,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::message::RULES;

    #[test]
    fn each_rule_has_its_page() {
        let slugs: Vec<_> = RULES.iter().map(|rule| rule.slug).collect();
        assert_eq!(PAGES.iter().map(|page| page.slug).collect::<Vec<_>>(), slugs);
        assert!(slugs.iter().all(|slug| Page::of(slug).is_some_and(|page| page.slug == *slug)));
        assert!(Page::of("no-such-rule").is_none());
    }
}
