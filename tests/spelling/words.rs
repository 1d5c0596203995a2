//! In: a text. Out: its words that can be checked with a dictionary.

/// The letters of a language.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Script {
    Latin,
    Cyrillic,
}

impl Script {
    fn has(self, letter: char) -> bool {
        match self {
            Self::Latin => letter.is_ascii_alphabetic(),
            Self::Cyrillic => ('\u{400}'..='\u{52f}').contains(&letter),
        }
    }
}

/// The combining accent on the letter before it: `Бо́льшие`.
const ACCENT: char = '\u{301}';

/// The words of a script, each with its character position. Not included are single letters, which are
/// addresses and axes; names and abbreviations with a digit, an underscore or a capital letter inside
/// (`utf8`, `rpm_max`, `WebKitGTK`); stems (`word*`); markup (`<b class="x">`, `&lt;`); parts of paths and of
/// code (`a/b.c`, `d::e`).
pub fn words(text: &str, script: Script) -> Vec<(usize, String)> {
    let letters: Vec<char> = text.chars().collect();
    let mut found = Vec::new();
    let mut at = 0;
    while at < letters.len() {
        let markup = markup(&letters[at..]);
        let length = letters[at..].iter().take_while(|&&letter| in_word(letter)).count();
        if markup == 0 && length > 0 && !is_code(&letters, at, at + length) {
            found.extend(word(&letters[at..at + length], script).map(|word| (at, word)));
        }
        at += markup.max(length).max(1);
    }
    found
}

/// Whether a character can be part of a word, a name or a number. Hyphens separate words.
fn in_word(letter: char) -> bool {
    letter.is_alphanumeric() || ['_', '\'', '’', ACCENT].contains(&letter)
}

/// The length of the tag or character reference at the start of a text, otherwise 0.
fn markup(letters: &[char]) -> usize {
    let begins = |letter: &char| letter.is_ascii_alphabetic() || ['/', '!'].contains(letter);
    let is_name = |letter: &char| letter.is_ascii_alphanumeric();
    match letters {
        ['<', next, ..] if begins(next) => {
            letters.iter().position(|&letter| letter == '>').map_or(0, |end| end + 1)
        }
        ['&', rest @ ..] => {
            let length = rest.iter().take_while(|letter| is_name(letter)).count();
            if rest.get(length) == Some(&';') { length + 2 } else { 0 }
        }
        _ => 0,
    }
}

/// Whether a word is a stem, or part of a path, a file name, an address or code.
fn is_code(letters: &[char], begin: usize, end: usize) -> bool {
    const JOINS: [char; 9] = ['□', '/', '\\', '.', ':', '=', '@', '#', '$'];
    let letter = |at: usize| letters.get(at).copied();
    let before = begin.checked_sub(1).and_then(letter);
    let (after, next) = (letter(end), letter(end + 1));
    let joined_before = before.is_some_and(|before| JOINS.contains(&before));
    let joined_after = after.is_some_and(|after| after == '(' || JOINS.contains(&after))
        && next.is_some_and(|next| in_word(next) || next == '/' || Some(next) == after && next == ':')
        || after == Some('=');
    let is_stem = after == Some('*') && next != Some('*');
    joined_before || joined_after || is_stem
}

/// A word of a script in its dictionary form.
fn word(letters: &[char], script: Script) -> Option<String> {
    let letters = letters.iter().filter(|&&letter| letter != ACCENT);
    let word: String = letters.map(|&letter| if letter == '’' { '\'' } else { letter }).collect();
    let word = word.trim_matches('\'');
    // Any noun has a possessive; dictionaries list only some.
    let word = word.strip_suffix("'s").unwrap_or(word);
    let capital_inside = word.chars().skip(1).any(char::is_uppercase);
    let own = |letter| letter == '\'' || script.has(letter);
    let is_word = word.chars().count() > 1 && !capital_inside && word.chars().all(own);
    is_word.then(|| word.to_owned())
}

#[test]
fn words_of_a_script_are_found() {
    let found =
        |text, script| -> Vec<String> { words(text, script).into_iter().map(|(_, word)| word).collect() };
    assert_eq!(
        found("The tool’s X-axis (G01) isn't 'here', WebKitGTK: utf8 and a_b. Резец", Script::Latin),
        ["The", "tool", "axis", "isn't", "here", "and"]
    );
    assert_eq!(found("Бо́льшие дуги: X20, из-за R", Script::Cyrillic), ["Большие", "дуги", "из", "за"]);
    assert_eq!(words("a bc", Script::Latin), [(2, "bc".to_owned())]);
}

#[test]
fn markup_stems_and_code_are_no_words() {
    let found =
        |text| -> Vec<String> { words(text, Script::Latin).into_iter().map(|(_, word)| word).collect() };
    assert_eq!(
        found("<b class=\"x\">two</b> words &lt;here&gt; if one < two & three"),
        ["two", "words", "here", "if", "one", "two", "three"]
    );
    assert_eq!(found("Of src/api.rs, std::fs, is(so), key=value: https://example.org/x!"), ["Of", "so"]);
    assert_eq!(found("told*; **bold** (in brackets). End: yes"), ["bold", "in", "brackets", "End", "yes"]);
}
