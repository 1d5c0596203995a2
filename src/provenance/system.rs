//! Infers the G-code system of a FANUC lathe program.
//!
//! In: statements. Out: system B or C and the place that shows it; otherwise it is A, like most programs.

use super::statement::Statement;
use crate::setup::dialect::GSystem;
use crate::source::Span;

/// Least weight of the signs of B or C.
const MIN_WEIGHT: u8 = 3;

/// Most contours that are kept.
const MAX_CONTOURS: usize = 16;

/// Constructs of one system only. Each counts once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Sign {
    /// `G95`: feed per revolution in B and C.
    G95,
    /// `G92 S` without X and Z: speed clamp in B and C.
    G92S,
    /// `G92 X Z` before any F: the coordinate system in B and C, since a thread needs a lead.
    G92Place,
    /// `G77 X Z`: turning cycle of B.
    G77,
    /// `G78 X Z`: threading cycle of B.
    G78,
    /// `G79 X Z`: facing cycle of B.
    G79,
    /// `G91`: incremental.
    G91,
    /// `G94 F` or `G90 G94` without X and Z: feed per minute.
    G94F,
    /// `G33 Z F`: threading in B and C.
    G33,
    /// `G90 G95`, `G91 G94` in one block: absolute or incremental, and the unit of the feed.
    FeedBesideAbsolute,
    /// `G90 G00 X`: in A both codes are of group 01.
    AbsoluteBesideMove,
    /// `G90` without X, Z, U and W: in A a cycle without a place.
    AbsoluteAlone,
    /// `G24 X Z`: facing cycle of C.
    G24,
    /// `G21 X Z F` alone: threading cycle of C.
    G21Cycle,
    /// `G20 X Z F` alone: turning cycle of C.
    G20Cycle,
    /// `G78 P021560 Q R`: first block of the threading cycle of C.
    G78Data,
    /// `G78 X Z P Q F`: its second block.
    G78Depths,
    /// `G77 X Z P Q F`: grooving cycle of C.
    G77Steps,
    /// `G72 P Q` for the contour of a `G73`, `G74` or `G75 P Q`: finishing after roughing in C.
    Finishing,
    /// `G70`, `G71` without a word: inch and millimetre in C.
    Unit,
    /// `G98`, `G99` without a hole cycle: the feed units of A.
    FeedUnit,
    /// `G50 S`: speed clamp of A.
    G50S,
    /// `G92 X Z F`: threading cycle of A.
    G92Cycle,
    /// `G94 X Z`: facing cycle of A.
    G94Cycle,
    /// `G90 X Z R`: turning cycle of A.
    G90Taper,
    /// `G90 X Z F` alone.
    G90Cycle,
    /// `G32 Z F`: threading in A.
    G32,
    /// U or W in a move: increments in A.
    Increments,
}

impl Sign {
    /// The systems that it suggests, and its weight.
    fn weight(self) -> (Side, u8) {
        match self {
            Self::G95 | Self::G92S => (Side::BAndC, 3),
            Self::G91
            | Self::G94F
            | Self::G33
            | Self::FeedBesideAbsolute
            | Self::AbsoluteBesideMove
            | Self::AbsoluteAlone => (Side::BAndC, 2),
            Self::G92Place => (Side::BAndC, 1),
            Self::G77 | Self::G78 | Self::G79 => (Side::B, 3),
            Self::G78Data => (Side::C, 3),
            Self::G24 | Self::G21Cycle | Self::G78Depths | Self::G77Steps | Self::Finishing | Self::Unit => {
                (Side::C, 2)
            }
            Self::G20Cycle => (Side::C, 1),
            Self::FeedUnit | Self::G50S | Self::G92Cycle | Self::G94Cycle | Self::G90Taper => (Side::A, 3),
            // Controls in B and C also accept these if the machine builder enables them, and postprocessors
            // use them.
            Self::G32 | Self::G90Cycle | Self::Increments => (Side::A, 1),
        }
    }
}

/// The systems that a sign suggests.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Side {
    A,
    BAndC,
    B,
    C,
}

/// Weighs the statements of a program.
#[derive(Clone, Debug, Default)]
pub struct SystemScores {
    seen: u32,
    /// Total for each side.
    totals: [u8; 4],
    /// The heaviest sign of each side; the first one if there are several.
    heaviest: [Option<(u8, Span)>; 4],
    /// P and Q of the contours that a `G73`, `G74` or `G75` has named.
    roughed: Vec<[Option<u64>; 2]>,
    /// Whether a hole cycle is active: then G98 and G99 may be its return levels.
    hole_cycle: bool,
    /// Whether an F was read.
    has_feed: bool,
}

impl SystemScores {
    /// Adds a statement.
    pub fn take(&mut self, statement: &Statement) {
        if !statement.names().is_empty() {
            return;
        }
        let axes = statement.has_any(b"XZUW");
        let cycle = statement.has_any(b"XU") && statement.has_any(b"ZW") && !statement.has_any(b"PQ");
        let alone = statement.codes(b'G').count() == 1;
        let codes = |wanted: [u32; 2]| statement.codes(b'G').any(|(code, _)| wanted.contains(&code));
        let steps = statement.has_any(b"XU") && statement.has_any(b"ZW") && statement.has(b'F');
        let contour = [b'P', b'Q'].map(|letter| statement.word(letter)?.number?.integer());
        let names_contour = contour.iter().all(Option::is_some);
        let hole = |(code, _): (u32, Span)| (810..=890).contains(&code);
        self.hole_cycle |= statement.codes(b'G').any(hole);
        let mut plain = true;
        for (code, span) in statement.codes(b'G') {
            plain &= matches!(code, 0 | 10);
            let sign = match code {
                950 => Sign::G95,
                920 if !axes && statement.has(b'S') => Sign::G92S,
                920 if cycle && statement.has(b'F') => Sign::G92Cycle,
                920 if cycle && !self.has_feed => Sign::G92Place,
                900 | 910 if codes([940, 950]) && !axes => Sign::FeedBesideAbsolute,
                900 if axes && codes([0, 10]) && !statement.has_any(b"UW") => Sign::AbsoluteBesideMove,
                780 if !axes && statement.word(b'P').is_some_and(|word| word.span.len() > 5) => Sign::G78Data,
                780 if steps && names_contour => Sign::G78Depths,
                770 if steps && names_contour => Sign::G77Steps,
                730..=750 if names_contour && !statement.has_any(b"XZ") => {
                    if self.roughed.len() < MAX_CONTOURS {
                        self.roughed.push(contour);
                    }
                    continue;
                }
                720 if names_contour && !statement.has_any(b"XZUW") && self.roughed.contains(&contour) => {
                    Sign::Finishing
                }
                700 | 710 if statement.words().iter().all(|word| matches!(word.letter, b'G' | b'N')) => {
                    Sign::Unit
                }
                770 if cycle => Sign::G77,
                780 if cycle => Sign::G78,
                790 if cycle => Sign::G79,
                900 if !axes => Sign::AbsoluteAlone,
                910 => Sign::G91,
                940 if axes => Sign::G94Cycle,
                940 if statement.has(b'F') || codes([900, 910]) => Sign::G94F,
                330 if axes && statement.has(b'F') => Sign::G33,
                320 if axes && statement.has(b'F') => Sign::G32,
                240 if cycle => Sign::G24,
                210 if cycle && alone && statement.has(b'F') => Sign::G21Cycle,
                200 if cycle && alone && statement.has(b'F') => Sign::G20Cycle,
                980 | 990 if !self.hole_cycle => Sign::FeedUnit,
                500 if statement.has(b'S') => Sign::G50S,
                900 if cycle && statement.has(b'R') => Sign::G90Taper,
                900 if cycle && alone => Sign::G90Cycle,
                0..=30 | 800 => {
                    self.hole_cycle = false;
                    continue;
                }
                _ => continue,
            };
            self.add(sign, span);
        }
        self.has_feed |= statement.has(b'F');
        let increment = statement.words().iter().find(|word| matches!(word.letter, b'U' | b'W'));
        if let Some(word) = increment
            && plain
            && statement.words().iter().any(|word| matches!(word.letter, b'G' | b'X' | b'Z'))
        {
            self.add(Sign::Increments, word.span);
        }
    }

    fn add(&mut self, sign: Sign, span: Span) {
        let bit = 1 << (sign as u8);
        if self.seen & bit != 0 {
            return;
        }
        self.seen |= bit;
        let (side, weight) = sign.weight();
        self.totals[side as usize] += weight;
        let heaviest = &mut self.heaviest[side as usize];
        if heaviest.is_none_or(|(most, _)| weight > most) {
            *heaviest = Some((weight, span));
        }
    }

    /// The system, if it certainly is not A: enough weight for it and little for A.
    pub fn verdict(&self) -> Option<(GSystem, Span)> {
        let total = |side: Side| self.totals[side as usize];
        let (system, own) =
            if total(Side::C) > total(Side::B) + 1 { (GSystem::C, Side::C) } else { (GSystem::B, Side::B) };
        let [of_own, shared] = [own, Side::BAndC].map(|side| self.heaviest[side as usize]);
        // A sign of C alone proves it, whatever its weight.
        let heavier = |(weight, span): &(u8, Span)| (*weight, std::cmp::Reverse(span.start));
        let shown =
            if system == GSystem::C { of_own } else { of_own.into_iter().chain(shared).max_by_key(heavier) };
        let (_, span) = shown?;
        let for_it = total(own) + total(Side::BAndC);
        (for_it >= MIN_WEIGHT + 2 * self.weight_of_a()).then_some((system, span))
    }

    /// Weight of the signs of A. A program that changes between G90 and G91 is not in A: its `G50 S` is a
    /// mistake or a habit.
    fn weight_of_a(&self) -> u8 {
        let has = |signs: &[Sign]| signs.iter().any(|&sign| self.seen & 1 << (sign as u8) != 0);
        let absolute = [Sign::AbsoluteAlone, Sign::AbsoluteBesideMove, Sign::FeedBesideAbsolute];
        let is_slip = has(&[Sign::G91]) && has(&absolute) && has(&[Sign::G50S]);
        self.totals[Side::A as usize] - if is_slip { 3 } else { 0 }
    }
}
