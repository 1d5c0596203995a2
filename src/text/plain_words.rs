//! Plain words: text of a natural language among the words of a program.
//!
//! In: a block and its comments. Out: the runs of letters that can only be text, and those that may be words
//! with misread digits. Must not know codes.

use super::lexer::is_blank;
use super::misread::is_full_width;
use crate::limits::WORDS_PER_BLOCK;
use crate::source::Span;

/// The text of a block outside brackets.
#[derive(Debug, Default, PartialEq, Eq)]
pub struct PlainWords {
    /// Plain words: runs of two or more letters between blanks or block ends. Adjacent words are one span.
    pub groups: Vec<Span>,
    /// Number of runs of letters that can only be text, whatever surrounds them: `finish` in `finish.`
    pub texts: usize,
    /// Whether letters may be words with misread or lost digits: `XSO` for `X50`, a lone `Z`.
    pub is_ambiguous: bool,
    /// Whether a letter is followed by a number or an expression, possibly with marks and blanks between.
    pub has_value: bool,
    /// Whether one of [`SMALL_WORDS`] was found.
    has_small_word: bool,
}

/// Keywords of macro statements, which are not plain words.
const KEYWORDS: [&str; 37] = [
    "ABS", "ACOS", "ADP", "AND", "ASIN", "ATAN", "BCD", "BIN", "BPRNT", "COS", "DO", "DPRNT", "END", "EQ",
    "EXP", "FIX", "FUP", "GE", "GOTO", "GT", "IF", "LE", "LN", "LT", "MOD", "NE", "OR", "PCLOS", "POPEN",
    "POW", "ROUND", "SETVN", "SIN", "SQRT", "TAN", "THEN", "WHILE",
];

/// Words that are ambiguous unless two other words are beside them.
const SMALL_WORDS: [&str; 6] = ["ALL", "IS", "NO", "OIL", "TO", "TOOL"];

/// Letters that are easily confused with a digit.
const LIKE_DIGITS: &str = "OoIilSsBZz";

/// More such letters, used if only one address is possible.
const LESS_LIKE_DIGITS: &str = "QDLEAGTgqbОоЗзб";

/// Longest block that is examined, bytes.
const LONGEST: usize = 4096;

/// Most digits of a word with misread digits.
const MAX_DIGITS: usize = 9;

impl PlainWords {
    /// Reads a block; `comments` in order of place.
    pub fn of(text: &[u8], block: Span, comments: &[Span]) -> Self {
        let mut found = Self::default();
        if comments.len() >= WORDS_PER_BLOCK {
            // Not all comments are known, and brackets must not nest.
            found.has_value = true;
            return found;
        }
        if block.len() > LONGEST {
            found.is_ambiguous =
                block.of(text).iter().any(|byte| byte.is_ascii_alphanumeric() || !byte.is_ascii());
            return found;
        }
        let (mut at, end) = (block.start as usize, block.end as usize);
        let mut comments = comments.iter().filter(|comment| block.contains(**comment)).peekable();
        // Whether the last letter or digit was a letter; the state of the last group before its last word;
        // whether the next word joins that group.
        let (mut after_letter, mut before, mut joins) = (false, None, false);
        // Number of open brackets of expressions.
        let mut depth = 0_usize;
        while at < end {
            if let Some(comment) = comments.next_if(|comment| comment.start as usize <= at) {
                at = at.max(comment.end as usize);
                (before, joins) = (None, false);
                continue;
            }
            let blank = blank(&text[at..end]);
            if blank > 0 {
                at += blank;
                continue;
            }
            let start = at;
            let stop = comments.peek().map_or(end, |comment| comment.start as usize);
            while at < stop && self::blank(&text[at..stop]) == 0 {
                at += 1;
            }
            let piece = String::from_utf8_lossy(&text[start..at]);
            found.read_piece(&piece, &mut after_letter);
            let is_bounded = (start == block.start as usize || ends_in_blank(&text[..start]))
                && (at == end || self::blank(&text[at..end]) > 0);
            if !piece.starts_with(char::is_alphabetic)
                && let Some(before) = before.take()
            {
                // `retract 5`: T has a value.
                found.groups.pop();
                found.groups.extend::<Option<Span>>(before);
            }
            let is_in_expression = depth > 0;
            for byte in piece.bytes() {
                depth = match byte {
                    b'[' => depth + 1,
                    b']' => depth.saturating_sub(1),
                    _ => depth,
                };
            }
            // A comment would end the expression.
            found.is_ambiguous |= is_in_expression && is_plain(&piece);
            if is_in_expression || !is_bounded || !is_plain(&piece) {
                (before, joins) = (None, false);
                continue;
            }
            let last = if joins { found.groups.pop() } else { None };
            let word = Span::new(start, at);
            found.groups.push(last.map_or(word, |last| last.to(word)));
            (before, joins) = (Some(last), true);
        }
        found.is_ambiguous |= found.has_small_word && found.texts < 2;
        found
    }

    /// Notes the letters and numbers of a run without blanks.
    fn read_piece(&mut self, piece: &str, after_letter: &mut bool) {
        let has_number = piece.contains(|letter: char| letter.is_numeric() || matches!(letter, '#' | '['));
        let runs = piece.split(|letter: char| !letter.is_alphabetic());
        for run in runs.filter(|run| !run.is_empty() && !has_number) {
            let is_small_word = SMALL_WORDS.iter().any(|word| run.eq_ignore_ascii_case(word));
            let is_like_words = is_like_words(run);
            self.has_small_word |= is_small_word;
            self.is_ambiguous |= is_like_words && !is_small_word;
            self.texts += usize::from(run.chars().nth(1).is_some() && !is_like_words && !is_keyword(run));
        }
        for letter in piece.chars() {
            self.has_value |= *after_letter && (letter.is_numeric() || matches!(letter, '#' | '['));
            if letter.is_alphanumeric() {
                // `CO2`: the letter may be a digit of the word.
                let goes_on = *after_letter && matches!(letter, 'O' | 'o' | 'l');
                *after_letter = goes_on || is_address(letter);
            }
        }
    }
}

/// Whether a run between blanks is a plain word.
fn is_plain(piece: &str) -> bool {
    let is_letters = piece.chars().all(char::is_alphabetic) && piece.chars().nth(1).is_some();
    is_letters && !is_keyword(piece) && !is_like_words(piece)
}

/// Whether some bytes begin with a word of prose, whatever numbers follow: `turn to Z-50`.
pub fn begins_as_sentence(bytes: &[u8]) -> bool {
    const LETTERS: usize = 3;
    let Ok(text) = std::str::from_utf8(bytes.trim_ascii()) else { return false };
    // Emoji in front of headings: `🔧 Facing`.
    let text = text.trim_start_matches(|sign: char| !sign.is_ascii() && !sign.is_alphanumeric()).trim_start();
    let (word, rest) = text.split_at(text.find(|letter: char| !letter.is_alphabetic()).unwrap_or(text.len()));
    let ends = |sign: char| sign.is_whitespace() || matches!(sign, ',' | ':' | '.' | '!' | '?' | '/' | '—');
    // The `ç` in `Posição` is not a misread digit.
    let has_accent = word.chars().any(|letter| matches!(letter, 'À'..='ɏ'));
    let follows = rest.chars().next().is_none_or(ends);
    if !follows || is_keyword(word) {
        // `end of program`, but not `END1`, `IF [`.
        let goes_on = rest.trim_start().chars().next().is_none_or(char::is_alphabetic);
        return follows && goes_on && !rest.contains(['#', '[']);
    }
    let next = rest.trim_start().split(|letter: char| !letter.is_alphabetic()).next().unwrap_or_default();
    let is_long = |word: &str| word.chars().count() >= LETTERS;
    // `ID bore`, `to home`; `TOOL` is a word, although its letters look like digits.
    let is_short = word.chars().count() + 1 == LETTERS && is_long(next) && is_plain(next);
    is_short || is_long(word) && (has_accent || is_plain(word)) || word.eq_ignore_ascii_case("TOOL")
}

fn is_keyword(run: &str) -> bool {
    KEYWORDS.iter().any(|keyword| run.eq_ignore_ascii_case(keyword))
}

/// Whether letters may be words with misread or lost digits: one address (`XSO`, `GI`, `Z`) or several
/// (`GOOXSOZO`).
fn is_like_words(run: &str) -> bool {
    let like = |letter: char| LIKE_DIGITS.contains(letter);
    let mut letters = run.chars();
    let Some(address) = letters.next() else { return false };
    let digits = letters.clone().count();
    if digits == 0 {
        return is_address(address) && !matches!(address, 'a' | 'A');
    }
    let is_digit = |letter: char| {
        like(letter)
            || LESS_LIKE_DIGITS.contains(letter)
            || is_full_width(letter)
            || address.is_ascii() && !letter.is_ascii() && is_address(letter)
    };
    if digits <= MAX_DIGITS && letters.clone().all(is_digit) {
        return true;
    }
    // At least one digit after each address.
    let mut after_address = true;
    let alternates = letters.all(|letter| {
        let fits = like(letter) || !after_address;
        after_address = !like(letter);
        fits
    });
    alternates && !after_address
}

/// Whether a letter is an address or looks like one: letters of alphabets, and full-width letters.
fn is_address(letter: char) -> bool {
    letter.is_alphabetic() && (letter < '\u{530}' || is_full_width(letter))
}

/// Whether text begins with a letter of a script without addresses, such as Chinese.
pub fn begins_in_other_script(bytes: &[u8]) -> bool {
    let text = String::from_utf8_lossy(bytes);
    text.trim_start().starts_with(|letter: char| letter.is_alphabetic() && !is_address(letter))
}

/// Length in bytes of the blank at the head of some bytes, 0 without one.
fn blank(bytes: &[u8]) -> usize {
    match bytes {
        [byte, ..] if is_blank(*byte) => 1,
        [0xC2, 0xA0, ..] => 2,
        [0xE3, 0x80, 0x80, ..] | [0xEF, 0xBB, 0xBF, ..] => 3,
        _ => 0,
    }
}

fn ends_in_blank(bytes: &[u8]) -> bool {
    (1..=3).any(|len| bytes.len() >= len && blank(&bytes[bytes.len() - len..]) == len)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str, comments: &[Span]) -> PlainWords {
        PlainWords::of(text.as_bytes(), Span::new(0, text.len()), comments)
    }

    fn groups(text: &str) -> Vec<&str> {
        let found = read(text, &[]);
        found.groups.iter().map(|group| &text[group.start as usize..group.end as usize]).collect()
    }

    #[test]
    fn plain_words_are_runs_of_letters_between_blanks() {
        let cases: [(&str, &[&str]); 18] = [
            ("G00 X64 retract", &["retract"]),
            ("G28 U0 home", &["home"]),
            ("M03 S500 rpm", &["rpm"]),
            ("N10 turning the outside", &["turning the outside"]),
            ("rough X20 then finish Z-5 slowly", &["rough", "finish", "slowly"]),
            ("\tmm  X5\u{a0}退刀", &["mm", "退刀"]),
            ("X5 отвод", &["отвод"]),
            // An address with a value, also across blanks.
            ("retract 5", &[]),
            ("slowly retract -5", &["slowly"]),
            ("retract #5", &[]),
            ("retract=5", &[]),
            // Not between blanks, or not only letters.
            ("X64retract", &[]),
            ("X60 “safe” finish.", &[]),
            ("T0303 groove 3mm", &[]),
            ("Gº0 X60", &[]),
            ("X5 m/min a", &[]),
            // Macro statements.
            ("X5 GOTO AND EQ", &[]),
            ("X5 and slowly", &["slowly"]),
        ];
        for (text, expected) in cases {
            assert_eq!(groups(text), expected, "{text}");
        }
    }

    #[test]
    fn letters_that_may_be_words_are_no_plain_words() {
        for text in [
            "XZ", "XSO", "XAA", "TOEOE", "GI", "FS", "TOIOI", "TOOL", "tool", "GOOXSOZO", "MOSSIOOO", "ＸＯ",
            "Gº", "ХО",
        ] {
            let found = read(text, &[]);
            assert!(found.is_ambiguous && found.groups.is_empty(), "{text}");
        }
        for text in ["BORING", "finish", "Facing", "DRILL", "ROUGH", "mm", "ok", "roughing", "groove", "home"]
        {
            let found = read(text, &[]);
            assert!(!found.is_ambiguous && found.texts == 1 && found.groups.len() == 1, "{text}");
        }
        assert!(read("Z retract", &[]).is_ambiguous && read("GO home slowly", &[]).is_ambiguous);
        assert!(!read("turn to the shoulder", &[]).is_ambiguous);
    }

    #[test]
    fn a_value_is_a_number_after_a_letter() {
        for text in ["X5", "X=64", "X - .5", "step 2", "X#1", "SIN[1]", "Ｘ５", "Gº0", "Шаг 2", "X“5”"]
        {
            assert!(read(text, &[]).has_value, "{text}");
        }
        for text in ["turning the outside", "1. roughing", "-----", "粗车2刀", "50"] {
            assert!(!read(text, &[]).has_value, "{text}");
        }
    }

    #[test]
    fn comments_are_passed_over() {
        let text = "rough (X5) finish(Z5) slowly";
        let comments = [Span::new(6, 10), Span::new(17, 21)];
        let found = read(text, &comments);
        assert_eq!(found.groups, [Span::new(0, 5), Span::new(22, 28)]);
        assert!(!found.has_value);
    }
}
