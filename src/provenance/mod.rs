//! Infers the control that a text was written for: another control or machine, another G-code system of
//! FANUC's lathes, a control that counts least increments.
//!
//! In: the text, of which only the head is read. Out: the target and the place that shows it, if any. A
//! program for a FANUC, GSK or Haas lathe must never be reported as foreign, so one uncertain sign is not
//! enough: the weights of signs add up, each sign counts once, and signs of such a lathe count against the
//! target. G-code system and numbers are read as those of a FANUC lathe: check for a foreign target first.

mod decimal;
mod finder;
mod hints;
mod signs;
mod statement;
mod system;
mod unit;

pub use self::decimal::{DecimalEvidence, NumberWithoutPoint};
use self::finder::Finder;
use self::signs::{Sign, Weight};
use self::statement::{Statement, Statements};
use self::system::SystemScores;
use self::unit::{UnitEvidence, UnitHint};
use crate::message::{Message, said};
use crate::parts::{Part, early};
use crate::setup::dialect::GSystem;
use crate::source::Span;

/// Most bytes of a text that are read.
pub const HEAD: usize = 64 << 10;

/// Most bytes of a text whose numbers are read. Habits are visible early, but the first cycle may come late.
pub const NUMBERS: usize = 256 << 10;

/// A control or machine whose programs cannot be run here.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// Huazhong HNC, turning.
    Hnc,
    /// Siemens SINUMERIK.
    Siemens,
    /// LinuxCNC.
    LinuxCnc,
    /// Fagor.
    Fagor,
    /// Heidenhain, plain text.
    Heidenhain,
    /// Okuma OSP.
    Okuma,
    /// GSK 928.
    Gsk928,
    /// A lathe with a program for each of its paths: Citizen, Star, Tsugami.
    Channels,
    /// Mazak, programs in EIA/ISO.
    Mazak,
    /// CNCSimulator.
    CncSimulator,
    /// Philips 3000, later MAHO.
    Philips,
    /// A milling machine.
    Mill,
    /// A 3D printer.
    Printer,
}

impl Target {
    /// The name of the control, the same in all languages; empty for a kind of machine.
    pub fn name(self) -> &'static str {
        match self {
            Self::Hnc => "HNC (华中)",
            Self::Siemens => "Siemens SINUMERIK",
            Self::LinuxCnc => "LinuxCNC",
            Self::Fagor => "Fagor",
            Self::Heidenhain => "Heidenhain",
            Self::Okuma => "Okuma OSP",
            Self::Gsk928 => "GSK 928",
            Self::Channels => "Citizen / Star / Tsugami ($1 $2)",
            Self::Mazak => "Mazak (EIA/ISO)",
            Self::CncSimulator => "CNCSimulator",
            Self::Philips => "Philips / MAHO",
            Self::Mill | Self::Printer => "",
        }
    }

    /// The message about a program for it.
    pub fn message(self) -> Message {
        match self {
            Self::Mill => said::ForeignMill.into(),
            Self::Printer => said::ForeignPrinter.into(),
            Self::Hnc
            | Self::Siemens
            | Self::LinuxCnc
            | Self::Fagor
            | Self::Heidenhain
            | Self::Okuma
            | Self::Gsk928
            | Self::Channels
            | Self::Mazak
            | Self::CncSimulator
            | Self::Philips => said::ForeignControl { control: self.name() }.into(),
        }
    }

    /// All targets, in the order of their discriminants.
    pub const ALL: [Target; 13] = [
        Self::Hnc,
        Self::Siemens,
        Self::LinuxCnc,
        Self::Fagor,
        Self::Heidenhain,
        Self::Okuma,
        Self::Gsk928,
        Self::Channels,
        Self::Mazak,
        Self::CncSimulator,
        Self::Philips,
        Self::Mill,
        Self::Printer,
    ];

    /// Least weight of its signs. Milling has no unique words: a lathe with a Y axis uses most of them.
    fn min_weight(self) -> i32 {
        match self {
            Self::Mill => 7,
            Self::Printer => 5,
            _ => 4,
        }
    }
}

/// A program that is not for a FANUC, GSK or Haas lathe.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Foreign {
    /// The control or machine.
    pub target: Target,
    /// The sign with the greatest weight; the first one if there are several.
    pub evidence: Span,
}

/// The control that a text was written for.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Provenance {
    /// Another control or machine, if there is no doubt.
    pub foreign: Option<Foreign>,
    /// System B or C of a FANUC lathe, if there is no doubt; `None` means system A.
    pub system: Option<(GSystem, Span)>,
    /// The word or remark that shows inches, if no code gives the unit.
    pub inches: Option<Span>,
}

/// The result of a first look at a text.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct QuickCheck {
    /// Whether it contains something that most programs do not: only then can [`recognise`] find anything.
    pub is_unusual: bool,
    /// The evidence for the decimal rule in its numbers.
    pub numbers: DecimalEvidence,
    /// Whether its head gives no unit and it may be in inches, which [`recognise`] decides.
    pub may_be_inches: bool,
}

/// Reads the beginning of a text once, for all evidence.
pub fn quick_check(text: &[u8]) -> QuickCheck {
    quick_check_until(text, NUMBERS)
}

/// The same, but for the numbers of the head only: enough to recognise the target.
pub fn quick_check_head(text: &[u8]) -> QuickCheck {
    quick_check_until(text, HEAD)
}

fn quick_check_until(text: &[u8], end: usize) -> QuickCheck {
    let (mut seen, mut unit) = (QuickCheck::default(), UnitHint::default());
    let mut statement = Statement::default();
    let mut statements = Statements::new(&text[..text.len().min(NUMBERS)]);
    while statements.read(&mut statement) && (statement.span.start as usize) < end {
        let is_head = (statement.span.start as usize) < HEAD;
        seen.is_unusual = seen.is_unusual || is_head && hints::is_unusual(text, &statement);
        seen.numbers.take(&statement);
        if is_head {
            unit.take(&statement);
        }
    }
    QuickCheck { may_be_inches: unit.may_be_inches(), ..seen }
}

early! {
    fn read_closely(text: &[u8]) -> Provenance {
        let (mut scores, mut finder, mut scales) = (Scores::default(), Finder::default(), SystemScores::default());
        let mut unit = UnitEvidence::default();
        let mut statement = Statement::default();
        let mut statements = Statements::new(&text[..text.len().min(NUMBERS)]);
        while statements.read(&mut statement) && (statement.span.start as usize) < HEAD {
            finder.look(text, &statement, |sign, span| scores.add(sign, span));
            scales.take(&statement);
            unit.take(text, &statement);
        }
        Provenance { foreign: scores.verdict(), system: scales.verdict(), inches: unit.inches() }
    }
}

/// The control that a text was written for, by its head; `None` if the part of the module that recognises it
/// is not loaded. It is needed for texts that are [unusual](QuickCheck::is_unusual) or [may be in
/// inches](QuickCheck::may_be_inches).
pub fn recognise(text: &[u8]) -> Option<Provenance> {
    RECOGNISED_BY.is_loaded().then(|| read_closely(text))
}

/// The part that recognises other controls.
pub const RECOGNISED_BY: Part = Part::Early;

/// The evidence for the decimal rule in the numbers of a text.
pub fn numbers(text: &[u8]) -> DecimalEvidence {
    quick_check(text).numbers
}

/// The total weight of the signs.
#[derive(Clone, Debug, Default)]
struct Scores {
    /// The signs that were found, one bit for each.
    seen: u128,
    /// Total for each target.
    totals: [i32; Target::ALL.len()],
    /// The heaviest sign of each target; the first one if there are several.
    heaviest: [Option<(u8, Span)>; Target::ALL.len()],
    /// Weight against a mill or a printer.
    lathe: i32,
    /// Weight against another lathe control with words like FANUC's.
    fanuc: i32,
}

impl Scores {
    fn add(&mut self, sign: Sign, span: Span) {
        if self.seen & sign.bit() != 0 {
            return;
        }
        self.seen |= sign.bit();
        match sign.weight() {
            Weight::For(target, weight) => {
                let at = target as usize;
                self.totals[at] += i32::from(weight);
                if self.heaviest[at].is_none_or(|(most, _)| weight > most) {
                    self.heaviest[at] = Some((weight, span));
                }
            }
            Weight::Lathe(weight) => self.lathe += i32::from(weight),
            Weight::Fanuc(weight) => self.fanuc += i32::from(weight),
            Weight::FanucLathe(weight) => {
                self.lathe += i32::from(weight);
                self.fanuc += i32::from(weight);
            }
        }
    }

    fn verdict(&self) -> Option<Foreign> {
        let surplus =
            |target: Target| self.totals[target as usize] - self.against(target) - target.min_weight();
        let target = Target::ALL.into_iter().rev().max_by_key(|&target| surplus(target))?;
        let (_, evidence) = self.heaviest[target as usize]?;
        (surplus(target) >= 0 && self.is_possible(target)).then_some(Foreign { target, evidence })
    }

    fn against(&self, target: Target) -> i32 {
        match target {
            Target::Mill | Target::Printer => self.lathe,
            Target::Hnc | Target::LinuxCnc | Target::Fagor | Target::Gsk928 => self.fanuc,
            // Their languages have words that no FANUC program has.
            Target::Siemens
            | Target::Heidenhain
            | Target::Okuma
            | Target::Channels
            | Target::Mazak
            | Target::CncSimulator
            | Target::Philips => 0,
        }
    }

    /// A mill moves in Y, as a lathe may too; but it changes its tools by M6 or activates their length
    /// offset.
    fn is_possible(&self, target: Target) -> bool {
        let tools = self.seen & (Sign::ToolLength.bit() | Sign::ToolChange.bit()) != 0;
        target != Target::Mill || tools && self.seen & Sign::MoveY.bit() != 0
    }
}

#[cfg(test)]
mod tests;
