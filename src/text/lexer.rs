//! Splits text into tokens without loss: every byte belongs to exactly one token, in order.
//!
//! In: the bytes of a program, which may be any bytes. Out: [`Token`]s. Never fails: unrecognised bytes
//! become a token, too. Must not know words, blocks or codes.

use std::ops::Range;

use crate::source::Span;

/// An unsigned number as written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Number {
    /// All digits as one integer, without the point; digits after the first 18 significant ones are dropped.
    pub mantissa: u64,
    /// Digits after the point.
    pub decimals: u8,
    /// Digits as written; leading zeros of long numbers do not count. At most 255.
    pub digits: u8,
    /// Number of decimal points: 0, 1, or more by mistake.
    pub points: u8,
}

/// Powers of ten that a double represents exactly.
const POWERS: [f64; 19] =
    [1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18];

/// Most digits that are kept, so that `mantissa` cannot overflow.
const KEPT_DIGITS: u8 = 18;

impl Number {
    /// The value as a double; correctly rounded up to 15 significant digits.
    pub fn value(self) -> f64 {
        // The conversion from a signed integer is faster. There are at most 18 digits.
        self.mantissa as i64 as f64 / POWERS[self.decimals as usize]
    }

    /// The value without the digits after the first `places` decimals: controls cut off digits below the
    /// least input increment (FANUC B-64114EN §8.3).
    pub fn truncated(self, places: u8) -> f64 {
        if self.decimals <= places {
            return self.value();
        }
        let dropped = 10u64.pow(u32::from(self.decimals - places));
        (self.mantissa / dropped) as f64 / POWERS[places as usize]
    }

    /// Whether it has a decimal point.
    pub fn has_point(self) -> bool {
        self.points > 0
    }

    /// The value of a whole number written without a point.
    pub fn integer(self) -> Option<u64> {
        (self.points == 0).then_some(self.mantissa)
    }

    /// Ten times the value, if that is a whole number as written: `12.1` is 121.
    #[inline]
    pub fn tenths(self) -> Option<u64> {
        match self.decimals {
            0 => Some(10 * self.mantissa),
            1 => Some(self.mantissa),
            _ => None,
        }
    }

    /// Parses the digits and points of some bytes and skips all other bytes.
    pub fn read(bytes: &[u8]) -> Self {
        let mut number = Self::default();
        for &byte in bytes {
            number.push(byte);
        }
        number
    }

    #[inline]
    fn push(&mut self, byte: u8) {
        match byte {
            b'0'..=b'9' => {
                if self.digits > 0 || byte != b'0' {
                    self.digits = self.digits.saturating_add(1);
                }
                // A second point ends the value. Whole digits past the limit are dropped without moving the
                // point.
                if self.points <= 1 && self.digits <= KEPT_DIGITS && self.decimals < KEPT_DIGITS {
                    self.mantissa = self.mantissa * 10 + u64::from(byte - b'0');
                    self.decimals += u8::from(self.points == 1);
                }
            }
            b'.' => self.points = self.points.saturating_add(1),
            _ => {}
        }
    }
}

/// Most digits of a [`PlainWord`]. So few that the rule about leading zeros of long numbers never applies.
pub const PLAIN_DIGITS: usize = 8;

/// A letter and a number with nothing between them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlainWord {
    /// The address, upper-case.
    pub letter: u8,
    /// Whether the number has a minus sign.
    pub negative: bool,
    /// The number.
    pub number: Number,
    /// Letter, sign and number.
    pub span: Span,
}

/// The kind of a token.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TokenKind {
    /// Spaces, tabs and other control characters, a byte order mark.
    Blank,
    /// `\n`, `\r\n` or a lone `\r`.
    LineEnd,
    /// `;`: an end of block inside a line.
    Semicolon,
    /// A letter in upper case: the address of a word.
    Letter(u8),
    /// Digits and points.
    Number(Number),
    /// `+`.
    Plus,
    /// `-`.
    Minus,
    /// A typographic dash instead of a minus (U+2212, U+2013, U+FF0D).
    PrintedMinus,
    /// `( … )`, closed on its line.
    Comment,
    /// A comment with more brackets inside.
    NestedComment,
    /// `(` without `)` before the end of the line.
    OpenComment,
    /// `%`.
    Percent,
    /// `/`.
    Slash,
    /// `:`.
    Colon,
    /// `,` or the full-width comma.
    Comma,
    /// `#`, `[`, `]`, `=`, `*`: characters of macro expressions.
    Macro(u8),
    /// The longest run of other bytes.
    Unknown,
}

/// A token and its place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Token {
    /// The kind of the token.
    pub kind: TokenKind,
    /// Its span.
    pub span: Span,
}

/// Splits text into tokens, one at a time.
#[derive(Clone, Debug)]
pub struct Lexer<'a> {
    text: &'a [u8],
    at: usize,
    /// The part of a line in which brackets are known not to balance. There the first `)` ends a comment, so
    /// that the rest of the line is not searched repeatedly for an end that does not exist.
    unbalanced: Range<usize>,
}

impl<'a> Lexer<'a> {
    /// Starts at byte `at` of `text`.
    pub fn new(text: &'a [u8], at: usize) -> Self {
        Self { text, at, unbalanced: 0..0 }
    }

    /// The text.
    pub fn text(&self) -> &'a [u8] {
        self.text
    }

    /// Byte of the next token.
    pub fn position(&self) -> usize {
        self.at
    }

    /// Continues at another byte.
    pub fn seek(&mut self, at: usize) {
        self.at = at;
    }

    /// The next byte, without consuming it.
    #[inline]
    pub fn peek_byte(&self) -> Option<u8> {
        self.text.get(self.at).copied()
    }

    /// The next token, or `None` at the end of the text.
    #[inline]
    pub fn next_token(&mut self) -> Option<Token> {
        let start = self.at;
        let &byte = self.text.get(start)?;
        let kind = match byte {
            b'A'..=b'Z' => self.one(TokenKind::Letter(byte)),
            b'0'..=b'9' | b'.' => self.number(),
            _ if is_blank(byte) => {
                while self.peek_byte().is_some_and(is_blank) {
                    self.at += 1;
                }
                TokenKind::Blank
            }
            b'-' => self.one(TokenKind::Minus),
            b'\n' => self.one(TokenKind::LineEnd),
            b'a'..=b'z' => self.one(TokenKind::Letter(byte.to_ascii_uppercase())),
            b'\r' => {
                self.at += 1 + usize::from(self.text.get(start + 1) == Some(&b'\n'));
                TokenKind::LineEnd
            }
            b';' => self.one(TokenKind::Semicolon),
            b'+' => self.one(TokenKind::Plus),
            b'(' => self.comment(1),
            b'%' => self.one(TokenKind::Percent),
            b'/' => self.one(TokenKind::Slash),
            b':' => self.one(TokenKind::Colon),
            b',' => self.one(TokenKind::Comma),
            b'#' | b'[' | b']' | b'=' | b'*' => self.one(TokenKind::Macro(byte)),
            _ => match self.printed() {
                Some((kind, len)) => {
                    self.at += len;
                    match kind {
                        TokenKind::OpenComment => self.comment(0),
                        kind => kind,
                    }
                }
                None => self.unknown(),
            },
        };
        Some(Token { kind, span: Span::new(start, self.at) })
    }

    #[inline]
    fn one(&mut self, kind: TokenKind) -> TokenKind {
        self.at += 1;
        kind
    }

    fn number(&mut self) -> TokenKind {
        let start = self.at;
        while let Some(b'0'..=b'9' | b'.') = self.peek_byte() {
            self.at += 1;
        }
        TokenKind::Number(Number::read(&self.text[start..self.at]))
    }

    /// The word at the current position if it is plain: a letter, an optional minus, a number of up to
    /// [`PLAIN_DIGITS`] digits, nothing between them. Nearly all words are; reading the same word as tokens
    /// gives the same result, only slower. Consumes nothing if it returns `None`.
    #[inline]
    pub fn plain_word(&mut self) -> Option<PlainWord> {
        let start = self.at;
        let letter = *self.text.get(start)?;
        let (negative, number, end) = plain_number(self.text, start + 1)?;
        self.at = end;
        let span = Span::new(start, end);
        Some(PlainWord { letter: letter.to_ascii_uppercase(), negative, number, span })
    }

    /// Reads a comment at the current position. Its opening bracket has `skip` bytes (0: already consumed).
    fn comment(&mut self, skip: usize) -> TokenKind {
        self.at += skip;
        let start = self.at;
        let balances = !self.unbalanced.contains(&start);
        let mut depth = 1u32;
        let mut nested = false;
        let mut first_close = None;
        while let Some(byte) = self.peek_byte() {
            let (open, close, len) = match byte {
                b'\n' | b'\r' => break,
                b'(' => (true, false, 1),
                b')' => (false, true, 1),
                0xEF if self.text[self.at..].starts_with("（".as_bytes()) => (true, false, 3),
                0xEF if self.text[self.at..].starts_with("）".as_bytes()) => (false, true, 3),
                _ => (false, false, 1),
            };
            self.at += len;
            if open {
                depth += 1;
                nested = true;
            }
            if close {
                depth -= 1;
                first_close.get_or_insert(self.at);
                if depth == 0 || !balances {
                    return if nested { TokenKind::NestedComment } else { TokenKind::Comment };
                }
            }
        }
        // Not balanced: the first closing bracket ends it, as on a control, or else the end of the line.
        self.unbalanced = start..self.at;
        match first_close {
            Some(end) => {
                self.at = end;
                TokenKind::NestedComment
            }
            None => TokenKind::OpenComment,
        }
    }

    /// A typographic or full-width character in place of an ASCII one, and its length in bytes.
    fn printed(&self) -> Option<(TokenKind, usize)> {
        let rest = &self.text[self.at..];
        // The first bytes of the characters below; checking them first is fast for other text.
        if !matches!(rest.first(), Some(0xC2 | 0xE2 | 0xE3 | 0xEF)) {
            return None;
        }
        let signs: [(&str, TokenKind); 9] = [
            ("\u{feff}", TokenKind::Blank),
            ("\u{a0}", TokenKind::Blank),
            ("\u{3000}", TokenKind::Blank),
            ("；", TokenKind::Semicolon),
            ("（", TokenKind::OpenComment),
            ("，", TokenKind::Comma),
            ("\u{2212}", TokenKind::PrintedMinus),
            ("\u{2013}", TokenKind::PrintedMinus),
            ("\u{ff0d}", TokenKind::PrintedMinus),
        ];
        signs
            .into_iter()
            .find(|(sign, _)| rest.starts_with(sign.as_bytes()))
            .map(|(sign, kind)| (kind, sign.len()))
    }

    fn unknown(&mut self) -> TokenKind {
        loop {
            self.at += 1;
            match self.peek_byte() {
                Some(byte) if byte >= 0x80 && self.printed().is_some() => break,
                Some(0x80..) => {}
                Some(b'!' | b'"' | b'$' | b'&' | b'\'' | b')' | b'<' | b'>' | b'?' | b'@') => {}
                Some(b'\\' | b'^' | b'_' | b'`' | b'{' | b'|' | b'}' | b'~') => {}
                _ => break,
            }
        }
        TokenKind::Unknown
    }
}

/// The number of a plain word, from byte `first` after its letter: whether it is negative, the number, and
/// its end.
#[inline(always)]
pub(super) fn plain_number(text: &[u8], first: usize) -> Option<(bool, Number, usize)> {
    let negative = text.get(first) == Some(&b'-');
    let first = first + usize::from(negative);
    let (mut end, mut mantissa) = digits(text, first, 0);
    let (mut points, mut decimals) = (0, 0);
    if text.get(end) == Some(&b'.') {
        let point = end;
        (end, mantissa) = digits(text, point + 1, mantissa);
        (points, decimals) = (1, (end - point - 1) as u8);
    }
    let digits = end - first - usize::from(points);
    if digits == 0 || digits > PLAIN_DIGITS {
        return None;
    }
    match text.get(end) {
        // Digits after a blank belong to the same number: the parser joins and reports them.
        Some(&byte)
            if is_blank(byte)
                && text
                    .get(end + 1)
                    .is_some_and(|&next| is_blank(next) || matches!(next, b'0'..=b'9' | b'.')) =>
        {
            None
        }
        // So does a second point or a misread digit.
        Some(b'.' | b'O' | b'o' | b'l' | 0xEF) => None,
        _ => Some((negative, Number { mantissa, decimals, digits: digits as u8, points }, end)),
    }
}

/// End of the digits from byte `at` on, and the integer that they make when appended to `before`.
#[inline(always)]
fn digits(text: &[u8], mut at: usize, before: u64) -> (usize, u64) {
    let mut integer = before;
    while let Some(digit) = text.get(at).map(|byte| byte.wrapping_sub(b'0')).filter(|digit| *digit < 10) {
        // May overflow: the callers reject numbers with too many digits.
        integer = integer.wrapping_mul(10).wrapping_add(u64::from(digit));
        at += 1;
    }
    (at, integer)
}

/// Whether a byte is a blank: a space, or any control character but a line end. A control ignores them: NUL
/// is the feed of paper tape, 0x11 to 0x14 start and stop the reader and the punch, 0x0C is a form feed, 0x1A
/// the end of a DOS file.
#[inline]
pub const fn is_blank(byte: u8) -> bool {
    matches!(byte, 0..=b'\t' | 0x0B | 0x0C | 0x0E..=b' ' | 0x7F)
}

/// Whether a byte belongs to no word, statement or comment: a blank or the end of a block.
pub const fn is_between_blocks(byte: u8) -> bool {
    is_blank(byte) || matches!(byte, b';' | b'\n' | b'\r')
}

/// The blocks of a text, without their ends: a line end, or a `;` outside of comments.
pub fn blocks(text: &[u8]) -> impl Iterator<Item = Span> + '_ {
    let mut lexer = Lexer::new(text, 0);
    let mut start = Some(0);
    std::iter::from_fn(move || {
        let from = start?;
        let ends = |token: &Token| matches!(token.kind, TokenKind::LineEnd | TokenKind::Semicolon);
        let end = lexer.by_ref().find(ends);
        start = end.map(|end| end.span.end as usize);
        Some(Span::new(from, end.map_or(text.len(), |end| end.span.start as usize)))
    })
}

impl Iterator for Lexer<'_> {
    type Item = Token;

    fn next(&mut self) -> Option<Token> {
        self.next_token()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kinds(text: &str) -> Vec<TokenKind> {
        Lexer::new(text.as_bytes(), 0).map(|token| token.kind).collect()
    }

    #[test]
    fn every_line_end_and_every_semicolon_ends_a_block() {
        let split = |text: &'static str| {
            blocks(text.as_bytes())
                .map(|block| &text[block.start as usize..block.end as usize])
                .collect::<Vec<_>>()
        };
        let expected = ["O1", "G0 X1", "(A;B)", ""];
        for end in ["\n", "\r\n", "\r", ";"] {
            let text: &'static str = expected.join(end).leak();
            assert_eq!(split(text), expected, "{text:?}");
        }
        assert_eq!(split(""), [""]);
        assert_eq!(split("X1;\r\n"), ["X1", "", ""]);
        // An unclosed comment ends with its line.
        assert_eq!(split("(A;B\rX1"), ["(A;B", "X1"]);
    }

    #[test]
    fn numbers_keep_what_was_written() {
        let read = |text: &str| Number::read(text.as_bytes());
        assert_eq!(read("1.25").value(), 1.25);
        assert_eq!(read("1.23456").truncated(3), 1.234);
        assert_eq!(read("1.23").truncated(3), 1.23);
        assert_eq!(read("0010").integer(), Some(10));
        assert_eq!(read("0010").digits, 2);
        assert_eq!(read("12.8.").points, 2);
        assert_eq!(read(".5").value(), 0.5);
        assert_eq!(read("5.").integer(), None);
        assert!(read(&"9".repeat(500)).value() > 1e17);
        assert!(read(&format!("0.{}", "1".repeat(500))).value() < 0.2);
        assert!(read(&format!("0.{}", "0".repeat(500))).value() == 0.0);
    }

    #[test]
    fn comments_end_on_their_line() {
        use TokenKind::*;
        assert_eq!(kinds("(A)X"), [Comment, Letter(b'X')]);
        assert_eq!(kinds("(A(B)C)"), [NestedComment]);
        assert_eq!(kinds("(A\nX"), [OpenComment, LineEnd, Letter(b'X')]);
        assert_eq!(kinds("((A)X(B)(C"), [NestedComment, Letter(b'X'), Comment, OpenComment]);
        assert_eq!(kinds(&"(()".repeat(3)), [NestedComment; 3]);
        assert_eq!(kinds("（外圆）；"), [Comment, Semicolon]);
    }

    #[test]
    fn every_byte_belongs_to_one_token() {
        let text: Vec<u8> = (0..=255u8).chain("−（x）；（".bytes()).collect();
        let mut at = 0;
        for token in Lexer::new(&text, 0) {
            assert_eq!(token.span.start, at);
            assert!(!token.span.is_empty());
            at = token.span.end;
        }
        assert_eq!(at as usize, text.len());
    }
}
