//! Splits any text into items: words of a block, comments, ends of blocks, and everything between them.
//!
//! In: a text. Out: [`Item`]s in order, without spaces. The work is proportional to the length of the text.

use super::reason::Reason;
use crate::source::Span;
use crate::units::read_number;

/// Maximum length of a comment, bytes; a parenthesis that closes later does not begin a comment.
const LONGEST_BRACKET: usize = 400;
/// Maximum length of an expression, bytes.
const LONGEST_EXPRESSION: usize = 200;
/// Number of unreadable chunks that make the rest of a line noise.
const NOISE_CHUNKS: usize = 2;

/// A word: a letter and its value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Word {
    /// The address, an upper-case ASCII letter.
    pub letter: u8,
    /// The number; NaN for an expression.
    pub value: f64,
    /// Whether a character between letter and number may have been a minus sign.
    pub lost_sign: bool,
    /// Why its spelling was corrected.
    pub reason: Option<Reason>,
}

impl Word {
    /// The number of a code in tenths: `G12.1` is 121.
    pub fn tenths(self) -> i64 {
        (self.value * 10.0).round() as i64
    }
}

/// Kind of an item.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Kind {
    Word(Word),
    /// `( … )`, closed on the same line.
    Comment,
    /// A macro statement up to the end of its block.
    Macro,
    /// `/`, `/2` before a word.
    Slash,
    Semicolon,
    LineEnd,
    /// `%` in a separate line.
    Percent,
    /// A bullet, `>`, `|`.
    Bullet,
    /// A number before the first word of a line.
    LineNumber,
    /// `…`.
    Ellipsis,
    /// Letters of a script that is used neither in programs nor by the users.
    Foreign,
    /// `X(U)_`.
    Placeholder,
    /// A letter without a number.
    Letter,
    /// A comma.
    Comma,
    /// Other punctuation.
    Mark,
    /// Meaningless characters.
    Noise,
    /// Anything else.
    Prose,
}

impl Kind {
    /// Whether a control would not accept the text.
    pub fn is_text(self, text: &str, span: Span) -> bool {
        match self {
            Self::Comment | Self::Semicolon | Self::LineEnd | Self::Percent | Self::Slash => false,
            // DOS files may end with the control character 0x1A.
            Self::Mark => !slice(text, span).chars().all(|c| c.is_control()),
            _ => true,
        }
    }
}

/// An item and its span.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Item {
    pub kind: Kind,
    pub span: Span,
}

/// The text of a span.
pub(super) fn slice(text: &str, span: Span) -> &str {
    &text[span.start as usize..span.end as usize]
}

/// Whether a character has zero width.
pub(super) fn is_invisible(c: char) -> bool {
    matches!(c, '\u{200b}'..='\u{200f}' | '\u{2060}' | '\u{feff}' | '\u{ad}')
}

/// Whether a character is white space within a line; like the lexer, includes control characters.
pub(super) fn is_blank(c: char) -> bool {
    is_invisible(c) || ((c.is_whitespace() || c.is_control()) && c != '\n' && c != '\r')
}

/// The ASCII equivalent of a character, and the reason for the replacement.
fn plain(c: char) -> (char, Option<Reason>) {
    match c {
        '\u{2212}' | '\u{2010}'..='\u{2013}' | '\u{ff0d}' | '\u{fe63}' => ('-', Some(Reason::Minus)),
        '\u{ff01}'..='\u{ff5e}' => (char::from_u32(c as u32 - 0xfee0).unwrap_or(c), Some(Reason::FullWidth)),
        _ => (c, None),
    }
}

/// The Latin capital that a Cyrillic capital looks like.
fn look_alike(c: char) -> Option<char> {
    let at = "АВСЕНКМОРТХ".chars().position(|other| other == c)?;
    "ABCEHKMOPTX".chars().nth(at)
}

/// Whether a character belongs to a script that is used neither in programs nor by the users.
fn is_foreign(c: char) -> bool {
    matches!(c as u32, 0x530..=0x1cff | 0xa000..=0xabff)
}

fn is_han(c: char) -> bool {
    matches!(c as u32, 0x2e80..=0x2fdf | 0x3040..=0x31ff | 0x3400..=0x9fff | 0xac00..=0xd7af | 0xf900..=0xfaff)
}

fn is_cyrillic(c: char) -> bool {
    matches!(c as u32, 0x400..=0x52f)
}

fn is_bullet(c: char) -> bool {
    matches!(
        c,
        '•' | '·'
            | '●'
            | '◆'
            | '■'
            | '▪'
            | '❖'
            | '○'
            | '◦'
            | '‣'
            | '✓'
            | '►'
            | '▶'
            | '➢'
            | '\u{f06c}'
            | '\u{f0d8}'
    )
}

/// A normalised character and the position of the next one; zero-width characters before it are skipped.
#[derive(Clone, Copy)]
struct Seen {
    sign: char,
    end: usize,
    reason: Option<Reason>,
}

fn look(text: &str, at: usize) -> Option<Seen> {
    let mut end = at;
    let mut invisible = None;
    for c in text[at..].chars() {
        end += c.len_utf8();
        if is_invisible(c) {
            invisible = Some(Reason::Invisible);
            continue;
        }
        let (sign, reason) = plain(c);
        return Some(Seen { sign, end, reason: reason.or(invisible) });
    }
    None
}

fn sign_at(text: &str, at: usize) -> Option<char> {
    look(text, at).map(|seen| seen.sign)
}

/// Normalises the characters of a text, and returns the reason for the first change.
pub(super) fn plain_signs(text: &str) -> (String, Option<Reason>) {
    let (mut now, mut reason, mut at) = (String::new(), None, 0);
    while let Some(seen) = look(text, at) {
        now.push(seen.sign);
        reason = reason.or(seen.reason);
        at = seen.end;
    }
    (now, reason)
}

/// Splits a text into items.
pub(super) fn read(text: &str) -> Vec<Item> {
    let mut reader = Reader { text, at: 0, items: Vec::new(), close: 0 };
    while reader.at < text.len() {
        reader.line();
    }
    reader.items
}

struct Reader<'a> {
    text: &'a str,
    at: usize,
    items: Vec<Item>,
    /// No parenthesis closes before this byte.
    close: usize,
}

impl Reader<'_> {
    fn line(&mut self) {
        let rest = &self.text[self.at..];
        let length = memchr::memchr2(b'\n', b'\r', rest.as_bytes()).unwrap_or(rest.len());
        let end = self.at + length;
        self.inside(end);
        if end < self.text.len() {
            let width = if self.text[end..].starts_with("\r\n") { 2 } else { 1 };
            self.push(Kind::LineEnd, end, end + width);
        }
        self.at = (end + 1).min(self.text.len());
        if self.text[end..].starts_with("\r\n") {
            self.at = end + 2;
        }
    }

    fn push(&mut self, kind: Kind, start: usize, end: usize) {
        self.items.push(Item { kind, span: Span::new(start, end) });
    }

    fn inside(&mut self, end: usize) {
        let text = self.text;
        let line = &text[self.at..end];
        let trimmed = line.trim_matches(is_blank);
        if trimmed == "%" {
            let start = self.at + line.find('%').unwrap_or(0);
            return self.push(Kind::Percent, start, start + 1);
        }
        if trimmed.starts_with("```") || trimmed.starts_with("~~~") {
            let start = self.at + line.find(trimmed).unwrap_or(0);
            return self.push(Kind::Bullet, start, start + trimmed.len());
        }
        // Only after the last words of a line can the rest be noise.
        let readable = self.at + last_prose(line);
        let mut noisy = None;
        let mut first = true;
        while self.at < end {
            let start = self.at;
            let c = text[start..].chars().next().unwrap_or(' ');
            if is_blank(c) {
                self.at += c.len_utf8();
                continue;
            }
            if let Some((kind, to)) = self.known(start, end, first) {
                first &= matches!(kind, Kind::Bullet | Kind::LineNumber);
                self.push(kind, start, to.min(end));
                self.at = to.min(end);
                continue;
            }
            first = false;
            if start >= readable
                && *noisy.get_or_insert_with(|| unreadable_chunks(&text[start..end]) >= NOISE_CHUNKS)
            {
                let to = start + text[start..end].trim_end_matches(is_blank).len();
                self.push(Kind::Noise, start, to);
                self.at = end;
                break;
            }
            self.junk(start, end);
        }
        self.at = end;
    }

    /// The item at `start`, if it is part of a program or usual beside one.
    fn known(&mut self, start: usize, end: usize, first: bool) -> Option<(Kind, usize)> {
        let text = self.text;
        let seen = look(text, start)?;
        let before = text[..start].chars().next_back();
        match seen.sign {
            ';' => return Some((Kind::Semicolon, seen.end)),
            // `[BILLET X62 Z70`: the stock comment of simulators used in schools.
            '[' if first && sign_at(text, seen.end).is_some_and(is_latin) => {
                return Some((Kind::Comment, end));
            }
            '(' => return self.comment(start, end),
            ',' if !matches!(sign_at(text, seen.end), Some('C' | 'R' | 'A')) => {
                return Some((Kind::Comma, seen.end));
            }
            '…' => return Some((Kind::Ellipsis, run(text, start, end, |c| c == '…'))),
            '.' if text[start..end].starts_with("...") => {
                return Some((Kind::Ellipsis, run(text, start, end, |c| c == '.')));
            }
            '|' => return Some((Kind::Bullet, seen.end)),
            c if is_bullet(c) => return Some((Kind::Bullet, seen.end)),
            '-' | '*' | '>' | '+' if first && sign_at(text, seen.end).is_none_or(is_blank) => {
                return Some((Kind::Bullet, seen.end));
            }
            '/' => {
                let level = look(text, seen.end).filter(|level| matches!(level.sign, '1'..='9'));
                let to = level.map_or(seen.end, |level| level.end);
                let next = to + blanks(text, to);
                let glued = before.is_some_and(char::is_alphabetic);
                let alone = first && sign_at(text, next).is_none_or(|c| matches!(c, '\n' | '\r'));
                if alone {
                    return Some((Kind::Slash, to));
                }
                if !glued && to <= end && (self.word(next).is_some() || self.is_macro(next, end)) {
                    return Some((Kind::Slash, to));
                }
            }
            ':' if first => {
                let to = run(text, seen.end, end, |c| c.is_ascii_digit());
                if (1..=8).contains(&(to - seen.end)) && ends_block(text, to) {
                    let value = read_number(&text[seen.end..to]).unwrap_or(0.0);
                    return Some((
                        Kind::Word(Word { letter: b'O', value, lost_sign: false, reason: None }),
                        to,
                    ));
                }
            }
            '0'..='9' if first => return self.leading_number(start, end),
            c if is_foreign(c) => {
                let to = run(text, start, end, |c| is_foreign(c) || is_blank(c));
                return Some((Kind::Foreign, start + text[start..to].trim_end_matches(is_blank).len()));
            }
            _ => {}
        }
        if self.is_macro(start, end) {
            let to = memchr::memchr(b';', &text.as_bytes()[start..end]).map_or(end, |at| start + at);
            return Some((Kind::Macro, start + text[start..to].trim_end_matches(is_blank).len()));
        }
        if let Some((word, to)) = self.word(start) {
            return Some((Kind::Word(word), to));
        }
        let to = self.placeholder(start, end)?;
        Some((Kind::Placeholder, to))
    }

    fn comment(&mut self, start: usize, end: usize) -> Option<(Kind, usize)> {
        if self.close < start {
            let found = self.text[start..end].find([')', '）']);
            self.close = found.map_or(end, |at| start + at);
        }
        if self.close >= end || self.close - start > LONGEST_BRACKET {
            return self.open_comment(start, end);
        }
        let mut depth = 0;
        for (at, c) in self.text[start..end].char_indices() {
            if at > LONGEST_BRACKET {
                break;
            }
            match plain(c).0 {
                '(' => depth += 1,
                ')' => {
                    depth -= 1;
                    if depth == 0 {
                        let to = start + at + c.len_utf8();
                        return (!self.is_noise(start, to, end)).then_some((Kind::Comment, to));
                    }
                }
                _ => {}
            }
        }
        self.open_comment(start, end)
    }

    /// Whether a parenthesis after a word is noise that continues to the end of the line.
    fn is_noise(&self, start: usize, to: usize, end: usize) -> bool {
        let is_behind = matches!(self.items.last().map(|item| item.kind), Some(Kind::Word(_)));
        is_behind
            && end - to <= LONGEST_BRACKET
            && unreadable_chunks(&self.text[to..end]) > 0
            && unreadable_chunks(&self.text[start..to]) >= NOISE_CHUNKS
            && last_prose(&self.text[start..end]) == 0
    }

    /// A parenthesis that is not closed.
    fn open_comment(&self, start: usize, end: usize) -> Option<(Kind, usize)> {
        // The parser reports it. It is a comment if it is in the place of one and contains readable words.
        let last = self.items.last().map(|item| item.kind);
        let behind = matches!(last, None | Some(Kind::LineEnd | Kind::Semicolon | Kind::Word(_)));
        let note = behind && end - start <= LONGEST_BRACKET && last_prose(&self.text[start..end]) > 0;
        note.then_some((Kind::Comment, end))
    }

    /// A number at the start of a line: a program number whose O was misread, or a line number.
    fn leading_number(&self, start: usize, end: usize) -> Option<(Kind, usize)> {
        let text = self.text;
        let to = run(text, start, end, |c| c.is_ascii_digit());
        if to - start == 5 && text[start..].starts_with('0') && ends_block(text, to) {
            let value = read_number(&text[start..to]).unwrap_or(0.0);
            let reason = Some(Reason::ZeroForO);
            return Some((Kind::Word(Word { letter: b'O', value, lost_sign: false, reason }), to));
        }
        let mark = sign_at(text, to).filter(|c| matches!(c, '.' | ')' | ':' | '、'));
        let to = if mark.is_some() { look(text, to)?.end } else { to };
        let gap = blanks(text, to);
        let next = to + gap;
        let follows = self.word(next).is_some() || self.is_macro(next, end);
        (to - start <= 6 && gap > 0 && next < end && follows).then_some((Kind::LineNumber, to))
    }

    /// Whether a macro statement begins here.
    fn is_macro(&self, at: usize, end: usize) -> bool {
        let rest = &self.text.as_bytes()[at..end];
        let before = self.text[..at].chars().next_back();
        if !rest.first().is_some_and(|byte| b"#IiWwGgDdEeBbSsPp".contains(byte)) {
            return false;
        }
        if rest.first() == Some(&b'#') {
            let near = &rest[..rest.len().min(60)];
            let next = rest.get(1);
            return next.is_some_and(|byte| byte.is_ascii_digit() || matches!(byte, b'[' | b'#'))
                && near.contains(&b'=');
        }
        if before.is_some_and(char::is_alphabetic) {
            return false;
        }
        let follows = |word: &str, is: fn(u8) -> bool| {
            rest.len() > word.len()
                && rest[..word.len()].eq_ignore_ascii_case(word.as_bytes())
                && rest[word.len()..].iter().copied().find(|byte| *byte != b' ').is_some_and(is)
        };
        let bracket = |byte: u8| byte == b'[';
        let number = |byte: u8| byte.is_ascii_digit() || matches!(byte, b'#' | b'[');
        follows("IF", bracket)
            || follows("WHILE", bracket)
            || follows("GOTO", number)
            || follows("DO", |byte| byte.is_ascii_digit())
            || follows("END", |byte| byte.is_ascii_digit())
            || follows("DPRNT", bracket)
            || follows("BPRNT", bracket)
            || follows("SETVN", number)
            || ["POPEN", "PCLOS"].iter().any(|word| rest == word.as_bytes())
    }

    fn word(&self, at: usize) -> Option<(Word, usize)> {
        if let Some(plain) = plain_word(self.text, at) {
            return Some(plain);
        }
        let (word, end, _) = spell(self.text, at)?;
        Some((word, end))
    }

    /// A letter with a placeholder for its number: `X(U)_`, `UΔd`, `F~`.
    fn placeholder(&mut self, start: usize, end: usize) -> Option<usize> {
        let text = self.text;
        let letter = look(text, start).filter(|seen| seen.sign.is_ascii_alphabetic())?;
        if text[..start].chars().next_back().is_some_and(char::is_alphabetic) {
            return None;
        }
        let mut at = letter.end;
        loop {
            match sign_at(text, at) {
                Some('_' | '~' | '～' | '□') => at = look(text, at)?.end,
                Some('Δ' | '∆' | 'α') => at = run(text, at, end, char::is_alphanumeric),
                Some('(') => match self.comment(at, end) {
                    // `A(54, -24)` is a point, not a placeholder.
                    Some((_, to)) if text[at..to].chars().nth(1).is_some_and(char::is_alphabetic) => at = to,
                    _ => break,
                },
                _ => break,
            }
        }
        (at > letter.end && at <= end).then_some(at)
    }

    /// Consumes unknown text up to a space, or to where a known item may begin.
    fn junk(&mut self, start: usize, end: usize) {
        let text = self.text;
        let mut at = start;
        let mut last = None;
        for c in text[start..end].chars() {
            let sign = plain(c).0;
            let begins = at > start
                && (is_blank(c)
                    || matches!(sign, ';' | '(' | '…' | '|')
                    || is_bullet(c)
                    || is_foreign(c)
                    || (may_begin(c) && !last.is_some_and(is_latin) && self.word(at).is_some()));
            if begins {
                break;
            }
            last = Some(c);
            at += c.len_utf8();
        }
        let chunk = &text[start..at];
        let letters = chunk.chars().filter(|c| c.is_alphabetic()).count();
        let kind = match letters {
            0 if chunk.chars().all(|c| !c.is_numeric()) => Kind::Mark,
            1 if chunk.len() == 1 => Kind::Letter,
            _ => Kind::Prose,
        };
        self.push(kind, start, at);
        self.at = at;
    }
}

fn is_latin(c: char) -> bool {
    c.is_ascii_alphabetic()
}

/// Whether a word may begin with this character in the middle of other text.
fn may_begin(c: char) -> bool {
    plain(c).0.is_ascii_alphabetic()
}

/// The end of a run of matching characters.
fn run(text: &str, start: usize, end: usize, is: impl Fn(char) -> bool) -> usize {
    text[start..end].char_indices().find(|&(_, c)| !is(c)).map_or(end, |(at, _)| start + at)
}

/// Length of the white space at `at`, bytes.
fn blanks(text: &str, at: usize) -> usize {
    text[at..].chars().take(8).take_while(|&c| is_blank(c)).map(char::len_utf8).sum()
}

/// Whether a block may end here.
fn ends_block(text: &str, at: usize) -> bool {
    let next = text[at..].chars().find(|&c| !is_blank(c));
    next.is_none_or(|c| matches!(plain(c).0, ';' | '\n' | '\r' | '(') || is_bullet(c))
        || text[at + blanks(text, at)..].starts_with('N')
}

/// Offset of the end of the last natural-language word in a line.
fn last_prose(line: &str) -> usize {
    let mut last = 0;
    let mut latin = 0;
    for (at, c) in line.char_indices() {
        latin = if c.is_ascii_alphabetic() { latin + 1 } else { 0 };
        if is_han(c) || (is_cyrillic(c) && look_alike(c).is_none()) || latin >= 3 {
            last = at + c.len_utf8();
        }
    }
    last
}

/// Number of space-separated chunks that cannot be part of a block.
fn unreadable_chunks(rest: &str) -> usize {
    let readable = |chunk: &str| {
        let chunk = chunk.trim_end_matches([',', ';']);
        let mut at = 0;
        if chunk.bytes().all(|byte| byte.is_ascii_digit()) {
            return !chunk.is_empty();
        }
        while at < chunk.len() {
            match spell(chunk, at) {
                Some((_, end, _)) => at = end,
                None => return false,
            }
        }
        true
    };
    rest.split(is_blank).filter(|chunk| !chunk.is_empty() && !readable(chunk)).take(NOISE_CHUNKS).count()
}

/// Reads a word that needs no correction: a capital, an optional sign, a number, and no further character
/// that could belong to it. A fast path for most words; [`spell`] is several times slower.
pub(super) fn plain_word(text: &str, at: usize) -> Option<(Word, usize)> {
    let bytes = text.as_bytes();
    if at > 0 && (bytes[at - 1].is_ascii_alphabetic() || !bytes[at - 1].is_ascii()) {
        return None;
    }
    let letter = *bytes.get(at).filter(|byte| byte.is_ascii_uppercase())?;
    let start = at + 1 + usize::from(matches!(bytes.get(at + 1), Some(b'-' | b'+')));
    let (mut end, mut points) = (start, 0);
    while let Some(byte @ (b'0'..=b'9' | b'.')) = bytes.get(end) {
        points += usize::from(*byte == b'.');
        end += 1;
    }
    let goes_on =
        bytes.get(end).is_some_and(|byte| matches!(byte, b',' | b'O' | b'o' | b'l') || !byte.is_ascii());
    if goes_on || points > 1 || end - start == points {
        return None;
    }
    let value = read_number(&text[start..end]).unwrap_or(0.0);
    let value = if bytes[at + 1] == b'-' { -value } else { value };
    Some((Word { letter, value, lost_sign: false, reason: None }, end))
}

/// Reads a word and corrects its spelling: letter, sign, number or expression. Returns the word, its end, and
/// the new text.
pub(super) fn spell(text: &str, at: usize) -> Option<(Word, usize, String)> {
    let before = text[..at].chars().next_back();
    let mut now = String::new();
    let mut reason = None;
    let mut at = at;
    let mut seen = look(text, at)?;
    if seen.sign == ',' {
        // `,C2`, `,R1`: the comma is part of the word.
        now.push(',');
        reason = reason.or(seen.reason);
        at = seen.end;
        seen = look(text, at)?;
        if !matches!(seen.sign, 'C' | 'R' | 'A') {
            return None;
        }
    } else if before.is_some_and(|c| c.is_alphabetic() && !is_han(c)) {
        return None;
    }
    let letter = match look_alike(seen.sign) {
        Some(letter) => {
            reason = Some(Reason::LookAlike);
            letter
        }
        None => seen.sign,
    };
    if !letter.is_ascii_alphabetic() {
        return None;
    }
    reason = reason.or(seen.reason);
    now.push(letter);
    at = seen.end;
    let upper = letter.is_ascii_uppercase();
    if upper && reason != Some(Reason::LookAlike) {
        at = skip_blanks(text, at, &mut now);
    }
    let mut lost_sign = false;
    let mut seen = look(text, at)?;
    let negative = seen.sign == '-';
    if matches!(seen.sign, '-' | '+') {
        now.push(seen.sign);
        reason = reason.or(seen.reason);
        at = skip_blanks(text, seen.end, &mut now);
        seen = look(text, at)?;
    } else if matches!(seen.sign, '?' | '\u{fffd}' | '¬' | '□') {
        lost_sign = true;
        now.push(seen.sign);
        at = seen.end;
        seen = look(text, at)?;
    }
    let address = letter.to_ascii_uppercase() as u8;
    if matches!(seen.sign, '#' | '[') && !lost_sign {
        let end = expression(text, at)?;
        now.push_str(&text[at..end]);
        let word = Word { letter: address, value: f64::NAN, lost_sign: false, reason };
        return Some((word, end, now));
    }
    let (digits, end, how) = number(text, at, letter)?;
    reason = how.or(reason);
    now.push_str(&digits);
    let head = digits.splitn(3, '.').take(2).collect::<Vec<_>>().join(".");
    let value = read_number(&head).unwrap_or(0.0);
    if lost_sign {
        reason = Some(Reason::UnreadableSign);
    }
    let value = if negative { -value } else { value };
    Some((Word { letter: address, value, lost_sign, reason }, end, now))
}

/// Skips at most two spaces if a number follows.
fn skip_blanks(text: &str, at: usize, now: &mut String) -> usize {
    let mut end = at;
    for c in text[at..].chars().take(3) {
        if !is_blank(c) {
            break;
        }
        end += c.len_utf8();
    }
    let follows =
        sign_at(text, end).is_some_and(|c| c.is_ascii_digit() || matches!(c, '.' | '-' | '+' | '#' | '['));
    if end > at && follows {
        now.push(' ');
        return end;
    }
    at
}

/// The end of a macro expression.
fn expression(text: &str, at: usize) -> Option<usize> {
    let mut depth = 0u32;
    let mut end = at;
    let mut begun = false;
    for c in text[at..].chars() {
        match c {
            '[' => depth += 1,
            ']' if depth > 0 => {
                depth -= 1;
                begun = true;
            }
            '\n' | '\r' => break,
            '#' if depth == 0 && !begun => {}
            c if depth > 0 && c.is_ascii() => {}
            '0'..='9' => begun = true,
            _ => break,
        }
        end += c.len_utf8();
        if end - at > LONGEST_EXPRESSION {
            return None;
        }
        if depth == 0 && c == ']' {
            break;
        }
    }
    (begun && depth == 0).then_some(end)
}

/// Reads the digits of a word, including letters misprinted for digits.
fn number(text: &str, start: usize, letter: char) -> Option<(String, usize, Option<Reason>)> {
    let mut digits = String::new();
    let mut reason = None;
    let mut at = start;
    let mut real = 0;
    let mut point = false;
    while let Some(seen) = look(text, at) {
        let next = |from: usize| sign_at(text, from);
        let digit_follows = next(seen.end).is_some_and(|c| c.is_ascii_digit());
        match seen.sign {
            c @ '0'..='9' => {
                digits.push(c);
                real += 1;
            }
            // In `Z5..` the second point is punctuation, not a decimal point.
            '.' if next(seen.end) != Some('.') || digits.is_empty() => {
                if point && !digit_follows {
                    digits.push('.');
                    at = seen.end;
                    break;
                }
                digits.push('.');
                point = true;
            }
            '。' | ',' if real > 0 && !point && digit_follows => {
                digits.push('.');
                point = true;
                reason = Some(Reason::DecimalPoint);
                at = seen.end;
                continue;
            }
            c @ ('O' | 'o' | 'l') if letter.is_ascii_uppercase() && letter != 'O' => {
                digits.push(if c == 'l' { '1' } else { '0' });
                reason = Some(Reason::LetterForDigit);
                at = seen.end;
                continue;
            }
            _ => break,
        }
        reason = reason.or(seen.reason);
        at = seen.end;
    }
    let misread = reason == Some(Reason::LetterForDigit);
    // `GO` is G0 if a word follows; `Go` in a sentence is not.
    let bare = letter == 'G'
        && (1..=2).contains(&digits.len())
        && text[at..].starts_with(' ')
        && text[start..at].bytes().all(|byte| byte == b'O')
        && spell(text, at + 1).is_some();
    let prose = misread && text[at..].starts_with(|c: char| c.is_alphabetic() && spell(text, at).is_none());
    if (real == 0 && !(misread && bare)) || prose || digits.bytes().all(|byte| byte == b'.') {
        return None;
    }
    Some((digits, at, reason))
}
