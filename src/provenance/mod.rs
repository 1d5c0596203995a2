//! What a text shows of the control it was written for: another control or machine, another G-code system of
//! FANUC's lathes, a control that counts least increments.
//!
//! In: the text; only its head is read. Out: the target and the place that shows it, or nothing. A program
//! for a FANUC, GSK or Haas lathe must never be called foreign, so one uncertain sign decides nothing: signs
//! add up, each counts once, and what only such a lathe uses counts against. The G-code system and the
//! numbers are read as those of a FANUC lathe: check for a foreign target first.

mod decimal;
mod finder;
mod hints;
mod signs;
mod statement;
mod system;
mod unit;

pub use self::decimal::{DecimalEvidence, Measure, NumberWithoutPoint};
use self::finder::Finder;
use self::signs::{Sign, Weight};
use self::statement::{Statement, Statements};
use self::system::Scales;
use self::unit::{UnitEvidence, UnitHint};
use crate::message::{Message, said};
use crate::parts::{Part, early};
use crate::setup::dialect::GSystem;
use crate::source::Span;

/// Most bytes of a text that are looked at.
pub const HEAD: usize = 64 << 10;

/// Most bytes of a text whose numbers are looked at. Habits show early, but the first cycle may come late.
pub const NUMBERS: usize = 256 << 10;

/// A control or machine that a program was written for, and whose programs are not read here.
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
    /// The name of the control, the same in all languages; none for a kind of machine.
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

    /// What is said of a program for it.
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

    /// All of them, in the order of their numbers.
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

    /// Least weight of its signs. Milling has no word of its own: even a lathe with a Y
    /// axis writes most of them.
    fn enough(self) -> i32 {
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
    /// The sign that says most, the first of its weight.
    pub evidence: Span,
}

/// What a text shows of the control it was written for.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Provenance {
    /// Another control or machine, where the text is beyond doubt written for one.
    pub foreign: Option<Foreign>,
    /// System B or C, where the text of a FANUC lathe is beyond doubt written in it;
    /// nothing is no reason to leave A.
    pub system: Option<(GSystem, Span)>,
    /// The word or remark that shows inches, where no code names the unit.
    pub inches: Option<Span>,
}

/// What the first look at a text shows.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Look {
    /// It has something that most programs have not: [`recognise`] may find something. Otherwise it does not.
    pub is_unusual: bool,
    /// What its numbers show of the decimal rule.
    pub numbers: DecimalEvidence,
    /// Its head names no unit and may be in inches: [`recognise`] says whether it is.
    pub may_be_inches: bool,
}

/// Looks at the beginning of a text, once for everything it shows.
pub fn look(text: &[u8]) -> Look {
    look_until(text, NUMBERS)
}

/// The same, but of the numbers only those of the head: all that shows the target of the text.
pub fn look_at_head(text: &[u8]) -> Look {
    look_until(text, HEAD)
}

fn look_until(text: &[u8], end: usize) -> Look {
    let (mut seen, mut unit) = (Look::default(), UnitHint::default());
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
    Look { may_be_inches: unit.is_open(), ..seen }
}

early! {
    fn read_closely(text: &[u8]) -> Provenance {
        let (mut scores, mut finder, mut scales) = (Scores::default(), Finder::default(), Scales::default());
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

/// For what control a text was written, by its head; `None` where the part of the module that can say so has not
/// been loaded. It is needed for texts that are [unusual](Look::is_unusual) or
/// [may be in inches](Look::may_be_inches).
pub fn recognise(text: &[u8]) -> Option<Provenance> {
    RECOGNISED_BY.is_loaded().then(|| read_closely(text))
}

/// The part that recognises other controls.
pub const RECOGNISED_BY: Part = Part::Early;

/// What the numbers of a text show of the decimal rule.
pub fn numbers(text: &[u8]) -> DecimalEvidence {
    look(text).numbers
}

/// What the signs so far weigh.
#[derive(Clone, Debug, Default)]
struct Scores {
    /// Bits of the signs seen.
    seen: u128,
    /// For each target.
    totals: [i32; Target::ALL.len()],
    /// The heaviest sign of each target, the first of its weight.
    heaviest: [Option<(u8, Span)>; Target::ALL.len()],
    /// Against a mill or a printer.
    lathe: i32,
    /// Against another lathe control with words like FANUC's.
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
        let surplus = |target: Target| self.totals[target as usize] - self.against(target) - target.enough();
        let target = Target::ALL.into_iter().rev().max_by_key(|&target| surplus(target))?;
        let (_, evidence) = self.heaviest[target as usize]?;
        (surplus(target) >= 0 && self.is_possible(target)).then_some(Foreign { target, evidence })
    }

    fn against(&self, target: Target) -> i32 {
        match target {
            Target::Mill | Target::Printer => self.lathe,
            Target::Hnc | Target::LinuxCnc | Target::Fagor | Target::Gsk928 => self.fanuc,
            // Their languages have words no FANUC program has.
            Target::Siemens
            | Target::Heidenhain
            | Target::Okuma
            | Target::Channels
            | Target::Mazak
            | Target::CncSimulator
            | Target::Philips => 0,
        }
    }

    /// A mill moves in Y, as a lathe may too; but it changes its tools by M6 or takes up their length.
    fn is_possible(&self, target: Target) -> bool {
        let tools = self.seen & (Sign::ToolLength.bit() | Sign::ToolChange.bit()) != 0;
        target != Target::Mill || tools && self.seen & Sign::MoveY.bit() != 0
    }
}

#[cfg(test)]
mod tests;
