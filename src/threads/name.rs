//! Reads the name of a thread, as written on a drawing.
//!
//! In: a name such as `M10×1,25-6g`, `#10-32 UNF`, `1 1/4-11.5 NPT`, `G 1/2 A` or `Tr40×14 P7 LH`. Out: a
//! [`Name`]. Does not know which threads exist.

use super::table::Standard;
use crate::units::read_number;

/// The longest name that is read, bytes.
const LONGEST: usize = 64;

/// Sizes and pitches that differ by less are equal, mm or inches: `.4375` is also written `.438`.
const SAME: f64 = 0.0006;

/// Hand of a thread.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Hand {
    /// RH, or not written.
    #[default]
    Right,
    /// LH.
    Left,
}

/// Series of Unified threads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Series {
    Coarse,
    Fine,
    ExtraFine,
    /// UN: a series with one pitch for all sizes. Named by the threads per inch.
    Constant,
}

/// The contents of a name.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Name {
    pub standard: Standard,
    /// Nominal size: mm for M and Tr, inches for the others.
    size: f64,
    /// Size in inches if a whole number is the number of a screw: 0.19 for `10-32`.
    numbered: Option<f64>,
    /// Pitch in mm for M and Tr, threads per inch for the others.
    pitch: Option<f64>,
    /// Lead of a thread with several starts, mm.
    pub lead: Option<f64>,
    series: Option<Series>,
    pub hand: Hand,
}

impl Name {
    /// Reads a name, without tolerance classes. `None` if it is not the name of a thread.
    pub fn read(name: &str) -> Option<Self> {
        let text = compact(name)?;
        let mut rest = Cursor(&text);
        let first = rest.letters();
        let mut name = match first {
            "M" => millimetres(Standard::Metric, &mut rest)?,
            "TR" => millimetres(Standard::Trapezoidal, &mut rest)?,
            "G" => {
                let size = rest.size()?;
                if !rest.eat("A") {
                    rest.eat("B");
                }
                Self::of(Standard::Pipe, size)
            }
            _ => inches(first, &mut rest)?,
        };
        name.hand = rest.end()?;
        Some(name)
    }

    /// Whether it is a name of the thread with this designation, read by the same rules, and this pitch in mm.
    pub fn names(&self, designation: &Self, pitch: f64) -> bool {
        let is = |one: f64, other: f64| (one - other).abs() < SAME;
        let of_table = match self.standard {
            Standard::Metric | Standard::Trapezoidal => pitch,
            Standard::Unified | Standard::Pipe | Standard::TaperPipe => 25.4 / pitch,
        };
        let has_pitch = match (self.pitch, self.series) {
            (Some(pitch), _) => is(pitch, of_table),
            // `M10` has the coarse pitch: its designation contains no pitch.
            (None, _) if self.standard == Standard::Metric => designation.pitch.is_none(),
            (None, None) => matches!(self.standard, Standard::Pipe | Standard::TaperPipe),
            (None, Some(series)) => series != Series::Constant,
        };
        let has_series = match self.series {
            None | Some(Series::Constant) => true,
            series => series == designation.series,
        };
        self.standard == designation.standard && is(self.size, designation.size) && has_pitch && has_series
    }

    /// The same name with its whole number read as the number of a screw.
    pub fn numbered(&self) -> Option<Self> {
        Some(Self { size: self.numbered?, ..*self })
    }

    fn of(standard: Standard, size: f64) -> Self {
        Self { standard, size, numbered: None, pitch: None, lead: None, series: None, hand: Hand::Right }
    }
}

/// After `M` or `Tr`: `10`, `10×1`, `16×Ph3P1.5`, `40×14 P7`, `40×14(P7)`.
fn millimetres(standard: Standard, rest: &mut Cursor) -> Option<Name> {
    let mut name = Name::of(standard, rest.number()?);
    if rest.eat("X") {
        let is_lead = rest.eat("PH");
        let value = rest.number()?;
        let is_open = rest.eat("(");
        if rest.eat("P") {
            (name.lead, name.pitch) = (Some(value), Some(rest.number()?));
        } else if is_lead || is_open {
            return None;
        } else {
            name.pitch = Some(value);
        }
        if is_open && !rest.eat(")") {
            return None;
        }
    }
    Some(name)
}

/// After `UNC`, `NPT` or no letters: `1/4`, `1/4-20`, `#10-32`; then the letters if there were none.
fn inches(first: &str, rest: &mut Cursor) -> Option<Name> {
    let is_number = rest.eat("#");
    let value = rest.size()?;
    let of_number = 0.06 + 0.013 * value;
    let is_whole = value.fract() == 0.0;
    let pitch = if rest.eat("-") { Some(rest.size()?) } else { None };
    let letters = if first.is_empty() { rest.letters() } else { first };
    let (standard, series) = match letters {
        "" => (Standard::Unified, None),
        "UNC" => (Standard::Unified, Some(Series::Coarse)),
        "UNF" => (Standard::Unified, Some(Series::Fine)),
        "UNEF" => (Standard::Unified, Some(Series::ExtraFine)),
        "UN" => (Standard::Unified, Some(Series::Constant)),
        "NPT" => (Standard::TaperPipe, None),
        _ => return None,
    };
    let mut name = Name::of(standard, value);
    (name.pitch, name.series) = (pitch, series);
    if standard == Standard::Unified && is_number {
        name.size = of_number;
    } else if standard == Standard::Unified && is_whole {
        name.numbered = Some(of_number);
    } else if is_number {
        return None;
    }
    Some(name)
}

/// A name in capital letters, with `X` for the multiplication sign, without inch marks and without spaces,
/// except those between digits. `None` if it is too long or contains other characters.
pub(super) fn compact(name: &str) -> Option<String> {
    let mut text = String::new();
    let mut is_apart = false;
    for letter in (name.len() <= LONGEST).then_some(name)?.chars() {
        let letter = match letter.to_ascii_uppercase() {
            // Inch marks.
            '"' | '\u{2033}' | '\u{201c}' | '\u{201d}' => continue,
            space if space.is_whitespace() => {
                is_apart = true;
                continue;
            }
            // With the Cyrillic letters of the same shape.
            '×' | '*' | '\u{425}' | '\u{445}' => 'X',
            '\u{41c}' | '\u{43c}' => 'M',
            ',' => '.',
            // Hyphen, en dash and minus sign.
            '\u{2010}'..='\u{2013}' | '\u{2212}' => '-',
            letter if letter.is_ascii_graphic() => letter,
            _ => return None,
        };
        if is_apart && letter.is_ascii_digit() && text.ends_with(|last: char| last.is_ascii_digit()) {
            text.push(' ');
        }
        is_apart = false;
        text.push(letter);
    }
    Some(text)
}

/// The rest of a compact name.
struct Cursor<'a>(&'a str);

impl<'a> Cursor<'a> {
    /// Skips a text if it is next.
    fn eat(&mut self, text: &str) -> bool {
        let rest = self.0.strip_prefix(text);
        self.0 = rest.unwrap_or(self.0);
        rest.is_some()
    }

    /// The characters of a kind that are next.
    fn take(&mut self, is_kind: impl Fn(char) -> bool) -> &'a str {
        let rest = self.0.trim_start_matches(is_kind);
        let taken = &self.0[..self.0.len() - rest.len()];
        self.0 = rest;
        taken
    }

    fn letters(&mut self) -> &'a str {
        self.take(|letter| letter.is_ascii_uppercase())
    }

    /// A decimal number without a sign.
    fn number(&mut self) -> Option<f64> {
        read_number(self.take(|letter| letter.is_ascii_digit() || letter == '.'))
    }

    /// A decimal number, a fraction, or a whole number with a fraction: `11.5`, `1/2`, `1 1/2`, `1-1/2`.
    fn size(&mut self) -> Option<f64> {
        let whole = self.number()?;
        if self.eat("/") {
            return Some(whole / self.number()?);
        }
        let mut ahead = Cursor(self.0);
        if ahead.eat(" ") || ahead.eat("-") {
            let above = ahead.number();
            if let Some(above) = above.filter(|_| ahead.eat("/")) {
                self.0 = ahead.0;
                return Some(whole + above / self.number()?);
            }
        }
        Some(whole)
    }

    /// The end of a name: tolerance classes and the hand.
    fn end(&mut self) -> Option<Hand> {
        let mut hand = Hand::Right;
        while !self.0.is_empty() {
            if !self.eat("-") {
                self.eat(" ");
            }
            if self.eat("LH") {
                hand = Hand::Left;
            } else if !self.eat("RH") {
                // `6g`, `5g6g`, `2A`.
                let digits = self.take(|letter| letter.is_ascii_digit());
                let class = self.take(|letter| ('A'..='H').contains(&letter));
                if digits.len() != 1 || class.len() != 1 {
                    return None;
                }
            }
        }
        Some(hand)
    }
}
