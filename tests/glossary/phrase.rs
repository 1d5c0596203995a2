//! A forbidden word or phrase, and the search for it in a text.

/// A column of the glossary.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    English,
    Chinese,
    Russian,
}

/// A word or phrase.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Phrase {
    pub language: Language,
    /// As the glossary writes it; `*` at the end of a word matches any ending.
    pub words: String,
}

/// Whether a character belongs to a word. Hyphens do, so that `spindle-stops-behind-move` is one word.
fn in_word(letter: char) -> bool {
    letter.is_alphanumeric() || letter == '_' || letter == '-'
}

fn is_cyrillic(letter: char) -> bool {
    ('а'..='я').contains(&letter) || letter == 'ё'
}

impl Phrase {
    pub fn new(language: Language, words: &str) -> Self {
        Phrase { language, words: words.to_lowercase() }
    }

    /// The matches in a lower-case text, as character positions. Russian entries apply to Russian texts:
    /// Latin ones such as `mm` are searched only in texts with Cyrillic letters.
    pub fn find(&self, text: &str) -> Vec<usize> {
        let beginning = self.words.split([' ', '*']).next().unwrap_or_default();
        if !text.contains(beginning) || self.language == Language::Russian && !text.contains(is_cyrillic) {
            return Vec::new();
        }
        let letters: Vec<char> = text.chars().collect();
        let pattern: Vec<char> = self.words.chars().collect();
        // Chinese is written without spaces between words.
        let whole_words = self.language != Language::Chinese;
        let begins = |at: usize| !whole_words || at == 0 || !in_word(letters[at - 1]);
        let ends = |rest: &[char]| !whole_words || rest.first().is_none_or(|&next| !in_word(next));
        let is_here = |at: &usize| begins(*at) && rest(&letters[*at..], &pattern).is_some_and(ends);
        (0..letters.len()).filter(is_here).collect()
    }
}

/// The rest of a text after a match of the pattern at its start. One blank in the pattern matches any number
/// of blanks.
fn rest<'a>(text: &'a [char], pattern: &[char]) -> Option<&'a [char]> {
    let skip = |skipped: fn(char) -> bool| text.iter().take_while(|&&letter| skipped(letter)).count();
    let length = match pattern.first() {
        None => return Some(text),
        Some('*') => skip(in_word),
        Some(' ') => skip(char::is_whitespace).max(1),
        Some(_) => 1,
    };
    let fits = match pattern.first() {
        Some('*') => true,
        Some(' ') => text.first().is_some_and(|letter| letter.is_whitespace()),
        wanted => wanted == text.first(),
    };
    if fits { rest(&text[length..], &pattern[1..]) } else { None }
}

#[test]
fn whole_words_and_phrases_are_found_in_any_case() {
    let count = |words, text: &str| Phrase::new(Language::English, words).find(&text.to_lowercase()).len();
    assert_eq!(count("told", "Told. It was (told), not untold, retold or told-off: told"), 3);
    assert_eq!(count("behind", "`spindle-stops-behind-move` stands behind"), 1);
    assert_eq!(count("turns a minute", "500 turns a\n    minute"), 1);
    assert_eq!(count("1/min", "500 1/min, 11/min, 1/minute"), 1);
}

#[test]
fn a_star_matches_any_ending() {
    let count = |words, text: &str| Phrase::new(Language::Russian, words).find(&text.to_lowercase()).len();
    assert_eq!(count("стойк*", "Стойка прочтёт, на стойках; пристойка"), 2);
    assert_eq!(count("номер* вершин*", "Номера вершин и номер вершины, номер положения вершины"), 2);
    assert_eq!(count("рез", "рез, резец, резьба, прорез"), 1);
    assert_eq!(count("mm", "a length in mm"), 0);
    assert_eq!(count("mm", "длина в mm"), 1);
    assert_eq!(Phrase::new(Language::Chinese, "程序卡").find("打印程序卡，程序卡片"), [2, 6]);
}
