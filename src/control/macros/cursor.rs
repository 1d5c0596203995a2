//! A position in the text of a macro.
//!
//! In: any bytes. Out: signs, names and numbers, one after another. Blanks and comments are allowed between
//! them. Knows nothing of their meaning.

use std::ops::Range;

use crate::text::lexer::{Number, is_blank};

/// An operator between two numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Arithmetic {
    Add,
    Subtract,
    Multiply,
    Divide,
    Modulo,
    And,
    Or,
    Xor,
}

/// A comparison of two numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Comparison {
    Equal,
    NotEqual,
    Greater,
    GreaterOrEqual,
    Less,
    LessOrEqual,
}

/// An operator between two values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Operator {
    Arithmetic(Arithmetic),
    Comparison(Comparison),
}

/// Maximum number of digits of a whole number that [`Number`] keeps exactly.
const KEPT_DIGITS: usize = 18;

/// Reads the text of a macro.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cursor<'t> {
    text: &'t [u8],
    at: usize,
    /// End of the last token.
    end: usize,
    /// A comment with an unbalanced bracket was found: from then on the first `)` ends a comment, so that the
    /// text is not searched repeatedly for a missing bracket.
    unbalanced: bool,
}

impl<'t> Cursor<'t> {
    pub fn new(text: &'t [u8]) -> Self {
        Self { text, at: 0, end: 0, unbalanced: false }
    }

    /// The next significant byte, as a capital.
    pub fn peek(&mut self) -> Option<u8> {
        loop {
            match *self.text.get(self.at)? {
                byte if is_blank(byte) => self.at += 1,
                b'(' => self.at = self.comment_end(),
                byte => return Some(byte.to_ascii_uppercase()),
            }
        }
    }

    /// Position of the next significant byte.
    pub fn start(&mut self) -> usize {
        self.peek();
        self.at
    }

    /// The range from `start` to the end of the last token.
    pub fn since(&self, start: usize) -> Range<usize> {
        start..self.end.max(start)
    }

    /// The next significant character; at the end of the text, the last character.
    pub fn here(&mut self) -> Range<usize> {
        let continues = |byte: &u8| byte & 0xC0 == 0x80;
        let mut start = self.start();
        if start >= self.text.len() {
            start = self.text.len().saturating_sub(1);
            while start > 0 && continues(&self.text[start]) {
                start -= 1;
            }
        }
        let Some(rest) = self.text.get(start + 1..) else { return start..start };
        start..start + 1 + rest.iter().take_while(|&byte| continues(byte)).count()
    }

    /// The range from the next significant byte to the end of the text, without trailing blanks.
    pub fn rest(&mut self) -> Range<usize> {
        let start = self.start();
        let blanks = self.text[start..].iter().rev().take_while(|byte| byte.is_ascii_whitespace()).count();
        start..self.text.len() - blanks
    }

    /// Takes `length` bytes.
    pub fn take(&mut self, length: usize) {
        self.at += length;
        self.end = self.at;
    }

    /// Takes this sign if it is next.
    pub fn eat(&mut self, sign: u8) -> bool {
        let found = self.peek() == Some(sign);
        if found {
            self.take(1);
        }
        found
    }

    /// Takes this word of capitals if it is next, even directly before other characters: `GOTO10`.
    pub fn eat_word(&mut self, word: &[u8]) -> bool {
        self.peek();
        let found = self.begins(word);
        if found {
            self.take(word.len());
        }
        found
    }

    /// Takes a run of letters.
    pub fn name(&mut self) -> &'t [u8] {
        let start = self.start();
        let length = self.text[start..].iter().take_while(|byte| byte.is_ascii_alphabetic()).count();
        self.take(length);
        &self.text[start..start + length]
    }

    /// Takes a number without sign. `None`, and nothing is taken, if there is none or it has two points.
    pub fn number(&mut self) -> Option<f64> {
        let start = self.start();
        let rest = &self.text[start..];
        let length = rest.iter().take_while(|byte| matches!(byte, b'0'..=b'9' | b'.')).count();
        let written = &rest[..length];
        let points = written.iter().filter(|&&byte| byte == b'.').count();
        if points > 1 || length == points {
            return None;
        }
        self.take(length);
        let whole = written.iter().take_while(|&&byte| byte != b'.');
        if whole.clone().skip_while(|&&byte| byte == b'0').count() > KEPT_DIGITS {
            return Some(whole.fold(0.0, |value, byte| value * 10.0 + f64::from(byte - b'0')));
        }
        Some(Number::read(written).value())
    }

    /// The operator at this position and its length; it is not taken.
    pub fn operator(&mut self) -> Option<(Operator, usize)> {
        let first = self.peek()?;
        self.operator_of(first)
    }

    /// Whether the AND, OR or XOR at this position joins conditions: a comparison follows before the next
    /// AND, OR or XOR. Not so in `#1 EQ #2 AND 7`.
    pub fn joins_conditions(&self) -> bool {
        let mut ahead = *self;
        let mut depth = 0u32;
        if let Some((_, length)) = ahead.operator() {
            ahead.take(length);
        }
        while let Some(byte) = ahead.peek() {
            let mut length = 1;
            match byte {
                b'[' => depth += 1,
                b']' if depth == 0 => return false,
                b']' => depth -= 1,
                _ => match ahead.operator_of(byte) {
                    Some((Operator::Comparison(_), _)) => return true,
                    Some((Operator::Arithmetic(Arithmetic::And | Arithmetic::Or | Arithmetic::Xor), _))
                        if depth == 0 =>
                    {
                        return false;
                    }
                    Some((Operator::Arithmetic(_), taken)) => length = taken,
                    None => {}
                },
            }
            ahead.take(length);
        }
        false
    }

    /// The text of the comment after the last token; empty if there is none.
    pub fn comment(&self) -> Range<usize> {
        let blanks = self.text[self.end..].iter().take_while(|byte| matches!(byte, b' ' | b'\t')).count();
        let start = self.end + blanks;
        if self.text.get(start) != Some(&b'(') {
            return self.end..self.end;
        }
        let end = Self { at: start, ..*self }.comment_end();
        start + 1..(end - usize::from(self.text[end - 1] == b')')).max(start + 1)
    }

    fn operator_of(&self, first: u8) -> Option<(Operator, usize)> {
        use Operator::{Arithmetic as Number, Comparison as Compare};
        let sign = |operator| Some((Number(operator), 1));
        let word = |word: &[u8], operator| self.begins(word).then_some((operator, word.len()));
        match first {
            b'+' => sign(Arithmetic::Add),
            b'-' => sign(Arithmetic::Subtract),
            b'*' => sign(Arithmetic::Multiply),
            b'/' => sign(Arithmetic::Divide),
            b'M' => word(b"MOD", Number(Arithmetic::Modulo)),
            b'A' => word(b"AND", Number(Arithmetic::And)),
            b'O' => word(b"OR", Number(Arithmetic::Or)),
            b'X' => word(b"XOR", Number(Arithmetic::Xor)),
            b'E' => word(b"EQ", Compare(Comparison::Equal)),
            b'N' => word(b"NE", Compare(Comparison::NotEqual)),
            b'G' => word(b"GT", Compare(Comparison::Greater))
                .or_else(|| word(b"GE", Compare(Comparison::GreaterOrEqual))),
            b'L' => word(b"LT", Compare(Comparison::Less))
                .or_else(|| word(b"LE", Compare(Comparison::LessOrEqual))),
            _ => None,
        }
    }

    fn begins(&self, word: &[u8]) -> bool {
        self.text[self.at..].get(..word.len()).is_some_and(|found| found.eq_ignore_ascii_case(word))
    }

    /// End of the comment at this position: its closing bracket; if the brackets inside are not balanced, the
    /// first `)`; without any `)`, the end of the text.
    fn comment_end(&mut self) -> usize {
        let (mut depth, mut first_close) = (0u32, None);
        for (at, byte) in self.text.iter().enumerate().skip(self.at) {
            match byte {
                b'(' => depth += 1,
                b')' => {
                    depth -= 1;
                    first_close.get_or_insert(at + 1);
                    if depth == 0 || self.unbalanced {
                        return at + 1;
                    }
                }
                _ => {}
            }
        }
        self.unbalanced = true;
        first_close.unwrap_or(self.text.len())
    }
}
