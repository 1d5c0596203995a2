//! Infers the unit of a program without G20 or G21: inches, if its numbers indicate them.
//!
//! In: statements. Out: the word that is the best evidence for inches, if any. A lathe starts in the unit of
//! its power-on parameter, so inch programs often omit G20. Small parts in millimetres have small numbers,
//! too: the size of the numbers only permits inches. The indications are weighted, and their total must reach
//! [`MIN_WEIGHT`].

use super::statement::Statement;
use crate::source::Span;

/// X from which a program is not in inches; the same for Z.
const TOO_LARGE_FOR_INCHES: [f64; 2] = [10.0, 20.0];

/// Fastest feed of a cut, inches per revolution: 0.75 mm.
const MAX_FEED: f64 = 0.03;

/// Coarsest lead of a thread, inches.
const MAX_LEAD: f64 = 0.5;

/// From this S under G96, a cutting speed is in feet per minute if the workpiece is smaller than
/// [`SMALL_DIAMETER`]: 60 m/min in feet.
const MIN_SPEED_IN_FEET: f64 = 200.0;

/// Diameter as written below which [`MIN_SPEED_IN_FEET`] cannot be m/min: if 4 were millimetres, the
/// workpiece would turn at 16,000 rpm.
const SMALL_DIAMETER: f64 = 4.0;

/// From this S under G96, a cutting speed is too high for any insert in metres per minute.
const MAX_CUTTING_SPEED: f64 = 600.0;

/// A cutting speed this many times higher than the speed limit of the spindle allows is not in metres per
/// minute.
const BEYOND_LIMIT: f64 = 5.0;

/// Minimum lead in millimetres; a smaller one is in inches.
const MIN_LEAD: f64 = 0.2;

/// Minimum number of coordinates with three decimals, the last of which is 0, that indicate inches: `Z1.000`.
const MIN_PADDED: u32 = 3;

/// Minimum total weight of the indications.
const MIN_WEIGHT: usize = 3;

/// Whether a program may be in inches: no code gives a unit, and no coordinate is too large.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct UnitHint {
    /// Whether a unit is given, or a number is too large for inches.
    excluded: bool,
    /// Whether a coordinate has a point.
    has_point: bool,
}

impl UnitHint {
    /// Adds a statement.
    pub fn take(&mut self, statement: &Statement) {
        if self.excluded {
            return;
        }
        let mut no_places = false;
        for (code, _) in statement.codes(b'G') {
            match code {
                // Codes are in tenths: 200 is G20.
                200 | 210 => self.excluded = true,
                // System C, unless they call a cycle.
                700 | 710 if !statement.has_any(b"PQUX") => self.excluded = true,
                // Not coordinates of the workpiece.
                40 | 100 | 530 => no_places = true,
                _ => {}
            }
        }
        let [x, z] = TOO_LARGE_FOR_INCHES;
        for word in statement.words().iter().filter(|word| !word.assigned && !no_places) {
            let Some(number) = word.number else { continue };
            let most = match word.letter {
                b'X' | b'U' => x,
                b'Z' | b'W' => z,
                _ => continue,
            };
            let value = number.value();
            if number.has_point() {
                self.has_point = true;
                self.excluded |= value >= most;
            } else if matches!(word.letter, b'X' | b'Z') {
                // `X10` without a point is 10 mm, or 0.001 inch, which is too small to be meant.
                self.excluded |= (x..100.0).contains(&value);
            }
        }
    }

    /// Whether the program may be in inches.
    pub fn may_be_inches(&self) -> bool {
        self.has_point && !self.excluded
    }
}

/// The evidence for the unit in the numbers and remarks of a program.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct UnitEvidence {
    /// Whether it may be in inches at all.
    hint: UnitHint,
    /// Whether G98 is active.
    per_minute: bool,
    /// Largest X with a point.
    largest: f64,
    /// Whether a cut has a feed.
    has_feed: bool,
    /// A remark with inches.
    remark: Option<Span>,
    /// A coordinate or a lead with four decimals or more.
    fine: Option<Span>,
    /// A lead that is too fine for millimetres.
    lead: Option<Span>,
    /// The highest cutting speed from [`MIN_SPEED_IN_FEET`].
    feet: Option<(f64, Span)>,
    /// The highest speed limit of G50 or G92, rpm.
    limit: f64,
    /// Number of coordinates with a point.
    with_point: u32,
    /// Number of those whose third and last decimal is a zero: `Z1.000`, `Z-.050`.
    padded: u32,
    /// The first of these.
    first_padded: Option<Span>,
    /// Whether a coordinate or feed below 1 has a zero before its point, as numbers in millimetres do.
    leading_zero: bool,
}

impl UnitEvidence {
    /// Adds a statement.
    pub fn take(&mut self, text: &[u8], statement: &Statement) {
        self.hint.take(statement);
        if self.hint.excluded {
            return;
        }
        let (mut threads, mut speeds, mut no_places, mut limits) = (false, false, false, false);
        let moves = statement.codes(b'G').any(|(code, _)| matches!(code, 0 | 10 | 20 | 30));
        for (code, _) in statement.codes(b'G') {
            match code {
                // In system B, G98 beside a hole cycle is the return level.
                980 | 940 if !statement.has_any(b"XZUW") || moves => self.per_minute = true,
                990 | 950 => self.per_minute = false,
                320 | 330 | 340 | 760 | 780 | 840 | 880 | 920 => threads = true,
                960 => speeds = true,
                500 => limits = true,
                40 | 100 | 530 => no_places = true,
                _ => {}
            }
        }
        if let Some(remark) = statement.remark.filter(|_| self.remark.is_none()) {
            self.remark = names_inches(remark.of(text)).then_some(remark);
        }
        for word in statement.words().iter().filter(|word| !word.assigned && !no_places) {
            let Some(number) = word.number else { continue };
            let (value, written) = (number.value(), word.span.of(text));
            let decimals = written.iter().rev().take_while(|&&byte| byte != b'.').count();
            let is_fine = number.has_point() && decimals >= 4;
            let is_fraction = number.has_point() && value > 0.0 && value < 1.0;
            self.leading_zero |= is_fraction && written.windows(2).any(|pair| pair == b"0.");
            match word.letter {
                b'X' | b'Z' | b'U' | b'W' if number.has_point() => {
                    if word.letter == b'X' {
                        self.largest = self.largest.max(value);
                    }
                    self.fine = self.fine.or(is_fine.then_some(word.span));
                    let is_padded = decimals == 3 && written.ends_with(b"0");
                    self.first_padded = self.first_padded.or(is_padded.then_some(word.span));
                    self.with_point += 1;
                    self.padded += u32::from(is_padded);
                }
                b'F' | b'E' if threads => {
                    let is_too_fine = number.has_point() && value > 0.0 && value < MIN_LEAD;
                    self.lead = self.lead.or(is_too_fine.then_some(word.span));
                    self.hint.excluded |= value >= MAX_LEAD;
                    self.fine = self.fine.or(is_fine.then_some(word.span));
                }
                b'F' if !self.per_minute => {
                    self.has_feed = true;
                    self.hint.excluded |= value > MAX_FEED;
                }
                b'S' if speeds && value >= self.feet.map_or(MIN_SPEED_IN_FEET, |feet| feet.0) => {
                    self.feet = Some((value, word.span));
                }
                b'S' if limits => self.limit = self.limit.max(value),
                _ => {}
            }
        }
    }

    /// The word or remark that is the best evidence for inches; `None` if the evidence is too weak.
    pub fn inches(&self) -> Option<Span> {
        // The highest cutting speed in metres per minute for a workpiece of this size at the speed limit.
        let reached = std::f64::consts::PI * self.largest * self.limit / 1000.0;
        let weight_of_speed = |(speed, _): (f64, Span)| {
            let is_beyond_limit = self.limit > 0.0 && speed > BEYOND_LIMIT * reached;
            if speed >= MAX_CUTTING_SPEED || is_beyond_limit {
                2
            } else {
                usize::from(self.largest < SMALL_DIAMETER)
            }
        };
        let feet = self.feet.filter(|&feet| weight_of_speed(feet) > 0);
        // A CAM system that writes three decimals in millimetres also writes the zero before the point.
        let is_padded = self.padded >= MIN_PADDED && 2 * self.padded > self.with_point && !self.leading_zero;
        let padded = self.first_padded.filter(|_| is_padded);
        let weight = 2 * usize::from(self.remark.is_some())
            + 2 * usize::from(self.fine.is_some())
            + 3 * usize::from(self.lead.is_some())
            + feet.map_or(0, weight_of_speed)
            + 2 * usize::from(is_padded)
            + usize::from(self.has_feed);
        let found = self.fine.or(self.lead).or(self.remark).or(feet.map(|feet| feet.1)).or(padded)?;
        let cuts = self.has_feed || self.lead.is_some();
        (self.hint.may_be_inches() && cuts && weight >= MIN_WEIGHT).then_some(found)
    }
}

/// Whether a remark contains inches: `1/2 IN`, `3/8"`, `3/8-16`, `1/32R`, `.5 IN DIA`, `INCH`.
fn names_inches(remark: &[u8]) -> bool {
    let byte = |at: usize| remark.get(at).copied().unwrap_or(b')');
    let begins = |at: usize| at == 0 || !byte(at - 1).is_ascii_alphanumeric();
    let is_behind_number = |at: usize| {
        let gap = at > 0 && byte(at - 1) == b' ';
        at > usize::from(gap) && byte(at - 1 - usize::from(gap)).is_ascii_digit()
    };
    (0..remark.len()).any(|at| match remark[at] {
        b'"' => at > 0 && byte(at - 1).is_ascii_digit(),
        b'/' => at > 0 && byte(at - 1).is_ascii_digit() && is_fraction(&remark[at + 1..]),
        b'I' | b'i' => {
            let rest = &remark[at..];
            let is = |name: &[u8]| {
                let ends = !rest.get(name.len()).is_some_and(u8::is_ascii_alphanumeric);
                ends && rest.get(..name.len()).is_some_and(|own| own.eq_ignore_ascii_case(name))
            };
            let named = begins(at) && (is(b"INCH") || is(b"INCHES"));
            named || is(b"IN") && is_behind_number(at) && is_size(&rest[2..])
        }
        _ => false,
    })
}

/// Whether the denominator of an inch size follows the slash: a power of two up to 64, followed by a unit,
/// the pitch of a thread or R for a radius. Other fractions are dates, pages and operations.
fn is_fraction(rest: &[u8]) -> bool {
    let digits = rest.iter().take_while(|byte| byte.is_ascii_digit()).count();
    let is_denominator = [&b"2"[..], b"4", b"8", b"16", b"32", b"64"].contains(&&rest[..digits]);
    let after = rest[digits..].trim_ascii_start();
    let follows = match after {
        [b'"', ..] => true,
        [b'-', digit, ..] => digit.is_ascii_digit(),
        [b'R' | b'r', end, ..] => !end.is_ascii_alphanumeric(),
        [b'I' | b'i', b'N' | b'n', rest @ ..] => is_size(rest),
        _ => false,
    };
    is_denominator && follows
}

/// Whether `IN` is the unit of a size: at the end of the remark or before the name of a measured thing.
fn is_size(after: &[u8]) -> bool {
    const THINGS: [&[u8]; 9] = [b"DIA", b"BAR", b"DRILL", b"STOCK", b"OD", b"ID", b"LONG", b"ROUND", b"X"];
    let after = after.trim_ascii_start();
    let begins = |thing: &&[u8]| after.get(..thing.len()).is_some_and(|own| own.eq_ignore_ascii_case(thing));
    matches!(after.first(), None | Some(b')' | b',' | b';' | b'.')) || THINGS.iter().any(begins)
}
