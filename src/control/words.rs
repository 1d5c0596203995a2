//! Words as the control reads them: numbers become millimetres, times and counts.
//!
//! In: a block and the rules for numbers. Out: values by address. The only place that knows the decimal-point
//! rule, inches, and that X is a diameter.

use std::cell::Cell;

use crate::message::{Diagnostic, Severity, said};
use crate::setup::dialect::DecimalRule;
use crate::source::Span;
use crate::text::block::{Block, Value, Word};
use crate::text::lexer::Number;
use crate::text::misread;
use crate::units::{Diameter, Unit};

/// The text of a word after its letter.
pub fn after_letter(word: &str) -> &str {
    let mut characters = word.chars();
    characters.next();
    characters.as_str()
}

/// The text of a word with the opposite sign.
pub fn with_other_sign(word: &str) -> String {
    let number = after_letter(word);
    let letter = word.strip_suffix(number).unwrap_or_default();
    let number = number.trim_start();
    match number.strip_prefix('-') {
        Some(rest) => format!("{letter}{}", rest.trim_start()),
        None => format!("{letter}-{}", number.trim_start_matches('+')),
    }
}

/// The data words of a block by address; if an address appears twice, the later word.
pub struct Words<'b> {
    block: &'b Block,
    /// Index of the word of each address, plus one; 0 if there is none.
    index: [u8; 26],
    /// Bit `n` for each letter `A + n` in the block.
    given: u32,
    /// The same for each letter that the control has read with [`Words::get`].
    read: Cell<u32>,
}

/// The bits of some letters, for [`Words::has_any`].
pub const fn letters(letters: &[u8]) -> u32 {
    let mut bits = 0;
    let mut at = 0;
    while at < letters.len() {
        bits |= 1 << (letters[at] - b'A');
        at += 1;
    }
    bits
}

/// The bits of the letters of some words.
pub fn letters_of<'a>(words: impl IntoIterator<Item = &'a Word>) -> u32 {
    words.into_iter().fold(0, |bits, word| bits | letters(&[word.address]))
}

impl<'b> Words<'b> {
    /// No words yet.
    #[inline]
    pub fn new(block: &'b Block) -> Self {
        Self { block, index: [0; 26], given: 0, read: Cell::new(0) }
    }

    /// Takes the word at `index` of the block; returns the previous word of the same address, if any.
    #[inline]
    pub fn take(&mut self, index: usize, word: &Word) -> Option<&'b Word> {
        let letter = (word.address - b'A') as usize;
        let before = self.index[letter];
        self.index[letter] = index as u8 + 1;
        self.given |= 1 << letter;
        (before > 0).then(|| &self.block.words[before as usize - 1])
    }

    /// The same words without these letters.
    pub fn without(&self, bits: u32) -> Self {
        let index =
            std::array::from_fn(|letter| if bits & 1 << letter == 0 { self.index[letter] } else { 0 });
        Self { block: self.block, index, given: self.given & !bits, read: self.read.clone() }
    }

    /// The letters in the block, as the bits of [`letters`].
    pub fn given(&self) -> u32 {
        self.given
    }

    /// Whether any of these letters is in the block.
    #[inline]
    pub fn has_any(&self, bits: u32) -> bool {
        self.given & bits != 0
    }

    /// The words that were not read, as the bits of [`letters`].
    #[inline]
    pub fn unread(&self) -> u32 {
        self.given & !self.read.get()
    }

    /// The word of an address that the control uses or reports in a message: it counts as read.
    #[inline]
    pub(super) fn get(&self, address: u8) -> Option<&'b Word> {
        self.read.set(self.read.get() | 1 << (address - b'A'));
        self.peek(address)
    }

    /// The word of an address for a message or a check: it does not count as read.
    #[inline]
    pub fn peek(&self, address: u8) -> Option<&'b Word> {
        match self.index[(address - b'A') as usize] {
            0 => None,
            index => Some(&self.block.words[index as usize - 1]),
        }
    }

    /// Span of a word; of the whole block if there is no such word.
    pub fn span(&self, address: u8) -> Span {
        self.peek(address).map_or_else(|| self.block.words_span(), |word| word.span)
    }

    /// The text of a word without blanks.
    pub fn quote(&self, text: &[u8], address: u8) -> String {
        self.peek(address).map_or_else(String::new, |word| quote(text, word.span))
    }
}

/// The intended text of a word: no blanks, digits instead of similar letters, a point instead of a comma.
pub fn as_meant(text: &[u8], span: Span) -> String {
    let written = quote(text, span);
    match misread::read(written.as_bytes(), 0) {
        Some(misread) if misread.len == written.len() => misread.plain,
        // A leading comma belongs to a corner word: `,R2`.
        _ => written
            .char_indices()
            .map(|(at, sign)| if at > 0 && matches!(sign, ',' | '，') { '.' } else { sign })
            .collect(),
    }
}

/// The text of a word without its blanks.
pub fn quote(text: &[u8], span: Span) -> String {
    span.quote(text).chars().filter(|ch| !ch.is_whitespace()).collect()
}

/// How numbers are read at present.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading {
    /// Unit of length.
    pub unit: Unit,
    /// Unit of a number without a point.
    pub decimal: DecimalRule,
}

/// Meaning of an axis value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Counts {
    /// A diameter: X and U.
    Diameter,
    /// A length: Z, W and, in a virtual plane, C and H.
    Length,
}

impl Reading {
    /// A coordinate or distance along an axis, mm; a radius if the program gives a diameter.
    #[inline]
    pub fn coordinate(self, word: &Word, counts: Counts) -> Option<f64> {
        match counts {
            Counts::Diameter => self.radius(word),
            Counts::Length => self.length(word),
        }
    }

    /// A length, mm, never a negative zero: digits below the least increment are cut off (FANUC B-64114EN
    /// §8.3). `None` for a macro expression.
    #[inline]
    pub fn length(self, word: &Word) -> Option<f64> {
        let Value::Number { number, negative } = word.value else { return None };
        Some(self.length_of(number, negative))
    }

    /// The length of a number, mm, as in [`Reading::length`].
    #[inline(never)]
    pub fn length_of(self, number: Number, negative: bool) -> f64 {
        let places = self.unit.decimals();
        let mut value = if self.decimal == DecimalRule::LeastIncrement && !number.has_point() {
            number.value() / 10f64.powi(i32::from(places))
        } else {
            number.truncated(places)
        };
        if self.unit == Unit::Inch {
            value *= self.unit.millimetres();
        }
        if negative { 0.0 - value } else { value }
    }

    /// A diameter as a radius, mm.
    #[inline]
    pub fn radius(self, word: &Word) -> Option<f64> {
        self.length(word).map(|diameter| Diameter::new(diameter).radius())
    }

    /// An angle, degrees; without a point under the least-increment rule the unit is 0.001°.
    pub fn degrees(self, word: &Word) -> Option<f64> {
        let Value::Number { number, .. } = word.value else { return None };
        let fine = self.decimal == DecimalRule::LeastIncrement && !number.has_point();
        plain(word).map(|value| if fine { value / 1000.0 } else { value })
    }

    /// A feed, mm/min or mm/rev, or a lead, mm; all digits count.
    pub fn feed(self, word: &Word) -> Option<f64> {
        plain(word).map(|value| value * self.unit.millimetres())
    }

    /// Seconds; without a point under the least-increment rule, milliseconds.
    pub fn seconds(self, word: &Word) -> Option<f64> {
        let Value::Number { number, .. } = word.value else { return None };
        let milliseconds = self.decimal == DecimalRule::LeastIncrement && !number.has_point();
        plain(word).map(|value| if milliseconds { value / 1000.0 } else { value })
    }
}

/// The number as written.
pub fn plain(word: &Word) -> Option<f64> {
    let Value::Number { number, negative } = word.value else { return None };
    // A bare minus would make a negative zero of `-0`, which would be visible in derived values.
    Some(if negative { 0.0 - number.value() } else { number.value() })
}

/// Which numbers an address allows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Form {
    /// Any number.
    Any,
    /// No minus.
    Positive,
    /// No minus and no point.
    Count,
}

/// Checks whether an address allows the number of its word (PS0006, PS0007).
#[inline]
pub fn check(text: &[u8], word: &Word) -> Option<Diagnostic> {
    let Value::Number { number, negative } = word.value else { return None };
    if !negative && !number.has_point() {
        return None;
    }
    let form = match word.address {
        b'F' | b'E' | b'L' => Form::Positive,
        b'G' => Form::Positive,
        b'S' | b'T' | b'M' | b'N' | b'O' => Form::Count,
        _ => Form::Any,
    };
    match form {
        Form::Positive | Form::Count if negative && number.mantissa > 0 => {
            Some(Diagnostic::new(said::MinusNotAllowed { word: quote(text, word.span) }, word.span))
        }
        Form::Count if number.has_point() => {
            let wrong = Diagnostic::new(said::PointNotAllowed { word: quote(text, word.span) }, word.span);
            // `S3000.`: some controls accept the point, and the number is unambiguous.
            let plain = word.address == b'S' && number.decimals == 0;
            Some(if plain { wrong.with_severity(Severity::Warning) } else { wrong })
        }
        _ => None,
    }
}
