//! The unit of a program that names none with G20 or G21: inches, where its numbers show it.
//!
//! In: statements. Out: the word that shows inches best, or nothing. A lathe starts in the unit of its power-on
//! parameter, so inch programs often leave G20 out. Small millimetre parts have small numbers, too: the size of
//! the numbers only permits inches, and at least two signs must show them.

use super::statement::Statement;
use crate::source::Span;

/// Largest X of a program in inches that shows it, inches; the same for Z.
const LARGEST: [f64; 2] = [10.0, 20.0];

/// Largest feed of a cut, inches per revolution: 0.75 mm.
const FASTEST: f64 = 0.03;

/// Coarsest lead of a thread, inches.
const COARSEST: f64 = 0.5;

/// Least cutting speed that shows feet per minute on work of less than [`LARGEST_TURNED`]: 60 m/min in feet.
const FEET: f64 = 200.0;

/// Work of this diameter at [`FEET`] metres a minute would turn at 16,000 rpm.
const LARGEST_TURNED: f64 = 4.0;

/// A cutting speed that no insert bears in metres a minute.
const FASTEST_CUT: f64 = 600.0;

/// A cutting speed so many times as high as the speed limit of the spindle allows is none in metres a minute.
const BEYOND_LIMIT: f64 = 5.0;

/// Least weight of the signs.
const ENOUGH: usize = 2;

/// What the numbers and remarks of a program show of its unit.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct UnitEvidence {
    /// A unit is named, or a number is too large for inches.
    excluded: bool,
    /// G98 is in force.
    per_minute: bool,
    /// Largest X so far.
    largest: f64,
    /// Coordinates with a point.
    pointed: usize,
    /// A feed of cuts.
    has_feed: bool,
    /// A remark names inches.
    remark: Option<Span>,
    /// A coordinate or a lead with four decimals or more.
    fine: Option<Span>,
    /// The highest cutting speed of 200 or more.
    feet: Option<(f64, Span)>,
    /// The highest speed limit of G50 or G92, rpm.
    limit: f64,
}

impl UnitEvidence {
    /// Takes in one more statement.
    pub fn take(&mut self, text: &[u8], statement: &Statement) {
        if self.excluded {
            return;
        }
        let (mut threads, mut speeds, mut dwells, mut limits) = (false, false, false, false);
        for (code, _) in statement.codes(b'G') {
            match code {
                200 | 210 => self.excluded = true,
                // System C, unless they call a cycle.
                700 | 710 if !statement.has_any(b"PQUX") => self.excluded = true,
                980 | 940 if !statement.has_any(b"XZUW") => self.per_minute = true,
                990 | 950 => self.per_minute = false,
                320 | 330 | 340 | 760 | 780 | 840 | 880 | 920 => threads = true,
                960 => speeds = true,
                500 => limits = true,
                40 => dwells = true,
                _ => {}
            }
        }
        if let Some(remark) = statement.remark.filter(|_| self.remark.is_none()) {
            self.remark = names_inches(remark.of(text)).then_some(remark);
        }
        for word in statement.words().iter().filter(|word| !word.assigned && !dwells) {
            let Some(number) = word.number else { continue };
            let (value, written) = (number.value(), word.span.of(text));
            let decimals = written.iter().rev().take_while(|&&byte| byte != b'.').count();
            let is_fine = number.has_point() && decimals >= 4;
            match word.letter {
                b'X' | b'Z' | b'U' | b'W' if number.has_point() => {
                    let [x, z] = LARGEST;
                    self.excluded |= value >= if matches!(word.letter, b'X' | b'U') { x } else { z };
                    self.pointed += 1;
                    if word.letter == b'X' {
                        self.largest = self.largest.max(value);
                    }
                    self.fine = self.fine.or(is_fine.then_some(word.span));
                }
                // Without a point 10 mm, or a thousandth of an inch.
                b'X' | b'Z' => self.excluded |= (LARGEST[0]..100.0).contains(&value),
                b'F' | b'E' if threads => {
                    self.excluded |= value >= COARSEST;
                    self.fine = self.fine.or(is_fine.then_some(word.span));
                }
                b'F' if !self.per_minute => {
                    self.has_feed = true;
                    self.excluded |= value > FASTEST;
                }
                b'S' if speeds && value >= self.feet.map_or(FEET, |feet| feet.0) => {
                    self.feet = Some((value, word.span));
                }
                b'S' if limits => self.limit = self.limit.max(value),
                _ => {}
            }
        }
    }

    /// The word or remark that shows that the program is in inches.
    pub fn inches(&self) -> Option<Span> {
        // The highest cutting speed in metres a minute that work of this size reaches at the speed limit.
        let reached = std::f64::consts::PI * self.largest * self.limit / 1000.0;
        let of_feet = |(speed, _): (f64, Span)| match speed >= FASTEST_CUT
            || speed > BEYOND_LIMIT * reached && self.limit > 0.0
        {
            true => 2,
            false => usize::from(self.largest < LARGEST_TURNED),
        };
        let feet = self.feet.filter(|&feet| of_feet(feet) > 0);
        let weight = 2 * usize::from(self.remark.is_some())
            + 2 * usize::from(self.fine.is_some())
            + feet.map_or(0, of_feet)
            + usize::from(self.has_feed);
        let found = self.fine.or(self.remark).or(feet.map(|feet| feet.1))?;
        (!self.excluded && self.pointed > 0 && self.has_feed && weight > ENOUGH).then_some(found)
    }
}

/// Whether a remark names inches: `1/2 IN`, `3/8"`, `INCH`, `1/32R`.
fn names_inches(remark: &[u8]) -> bool {
    let is_letter = |at: usize| remark.get(at).is_some_and(u8::is_ascii_alphabetic);
    let is_digit = |at: usize| remark.get(at).is_some_and(u8::is_ascii_digit);
    (0..remark.len()).any(|at| match remark[at] {
        b'"' => at > 0 && is_digit(at - 1),
        // Halves to sixty-fourths: other fractions are dates, quantities and pages.
        b'/' => {
            let parts = [&b"2"[..], b"4", b"8", b"16", b"32", b"64"];
            let digits = remark[at + 1..].iter().take_while(|byte| byte.is_ascii_digit()).count();
            at > 0 && is_digit(at - 1) && parts.contains(&&remark[at + 1..at + 1 + digits])
        }
        b'I' | b'i' => {
            let word = remark[at..].iter().take_while(|byte| byte.is_ascii_alphabetic()).count();
            let name = remark[at..at + word].to_ascii_uppercase();
            let begins = at == 0 || !is_letter(at - 1);
            let behind_number =
                remark[..at].iter().rev().find(|byte| **byte != b' ').is_some_and(u8::is_ascii_digit);
            begins && (matches!(&name[..], b"INCH" | b"INCHES") || name == b"IN" && behind_number)
        }
        _ => false,
    })
}
