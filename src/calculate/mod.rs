//! The calculators of the manual and of the page: a cone, the R of a taper, the passes of a thread.
//!
//! In: the name of a calculator and the texts of its fields, or a word of a program. Out: results, a table of passes,
//! the block with the result, edits of the program, or the field with the wrong value. Lengths are in the unit of the
//! program; the formulas use millimetres. Must not know a language.

pub mod at_word;
mod formulas;
mod programs;

pub use formulas::ALL;

use crate::assist::snippet::written;
use crate::control::codes::cycles::CycleBlock;
use crate::control::words::Reading;
use crate::setup::dialect::{DecimalRule, PqUnit};
use crate::threads::{self, Thread};
use crate::units::{Unit, number, read_number};

/// The kind of a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// A diameter, mm.
    Diameter,
    /// A length or coordinate, mm.
    Length,
    /// A thread pitch or a feed, mm per revolution.
    PerTurn,
    /// An angle, degrees.
    Degrees,
    /// A spindle speed, rpm.
    Speed,
    /// A cutting speed, m/min.
    CuttingSpeed,
    /// A roughness, µm.
    Roughness,
    /// A number without a unit.
    Number,
    /// The name of a thread: `M30×2`.
    ThreadName,
}

impl Quantity {
    /// The millimetres, or metres per minute, of one unit of a value; 1 for a value without a unit of length.
    fn scale(self, unit: Unit) -> f64 {
        match self {
            Self::Diameter | Self::Length | Self::PerTurn => unit.millimetres(),
            Self::CuttingSpeed => unit.surface_metres(),
            Self::Degrees | Self::Speed | Self::Roughness | Self::Number | Self::ThreadName => 1.0,
        }
    }
}

/// A field of a calculator.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Field {
    /// The letter of the figure.
    pub name: &'static str,
    /// The kind of its value.
    pub quantity: Quantity,
    /// The value of the worked example; [`THREAD`] for a name.
    pub example: f64,
}

/// A word of a block.
#[derive(Clone, Debug, PartialEq)]
pub struct Word {
    /// Its address.
    pub letter: u8,
    /// Its value.
    pub value: WordValue,
}

/// The value of a word.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum WordValue {
    /// A length or a diameter, mm, rounded to the least input increment.
    Length(f64),
    /// A feed or a lead, mm per revolution.
    PerTurn(f64),
    /// A length, mm, that is written in least input increments: P and Q of G76.
    Increments(f64),
    /// A number.
    Number(f64),
    /// P of the first block of G76: one finishing pass, no pull-out, and the angle of the tool.
    Packed(f64),
}

/// A block.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    /// Its code in G-code system A; empty if the code of the block before stays in force.
    pub code: &'static str,
    /// Which block of a multiple cycle it is.
    pub half: Option<CycleBlock>,
    /// Its words.
    pub words: Vec<Word>,
}

/// The results of a calculator.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Outcome {
    /// Results with their letters, in millimetres.
    pub results: Vec<(&'static str, Quantity, f64)>,
    /// The columns of the table of passes.
    pub columns: Vec<(&'static str, Quantity)>,
    /// The passes.
    pub rows: Vec<Vec<f64>>,
    /// The blocks with the result; empty if there are none.
    pub blocks: Vec<Block>,
    /// The thread that was found, with its standard.
    pub thread: Option<Thread>,
}

/// Why a value is wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// It is not a number.
    NotANumber,
    /// It must be greater than zero.
    NotPositive,
    /// It must not be negative.
    Negative,
    /// It must be at least 2.
    TooFew,
    /// It must be a whole number.
    NotWhole,
    /// It equals another value, so that the length is zero.
    SamePlace,
    /// It makes more passes than the table can have.
    TooMany,
    /// It is too large for the other values.
    TooLarge,
    /// It is too small for the other values.
    TooSmall,
    /// No standard has a thread with this name.
    UnknownThread,
}

impl Fault {
    /// All faults.
    pub const ALL: [Self; 10] = [
        Self::NotANumber,
        Self::NotPositive,
        Self::Negative,
        Self::TooFew,
        Self::NotWhole,
        Self::SamePlace,
        Self::TooMany,
        Self::TooLarge,
        Self::TooSmall,
        Self::UnknownThread,
    ];
}

/// The index of a field, and the fault of its value.
pub type Wrong = (usize, Fault);

/// A calculator.
#[derive(Clone, Copy, Debug)]
pub struct Calculator {
    /// Its name.
    pub name: &'static str,
    /// Its fields.
    pub fields: &'static [Field],
    formula: Formula,
    /// The lines of a program that shows the result, for values in millimetres; `{}` is the place of the blocks.
    program: fn(&[f64], &Outcome) -> Vec<String>,
}

/// How a calculator computes.
#[derive(Clone, Copy, Debug)]
enum Formula {
    /// From numbers.
    Numbers(fn(&[f64]) -> Result<Outcome, Wrong>),
    /// From the name of a thread, the first field, and numbers.
    Thread(fn(&Thread, &[f64]) -> Result<Outcome, Wrong>),
}

/// The name in the worked example.
pub const THREAD: &str = "M30×2";

/// Largest absolute value of a field, in its unit.
const MAX_VALUE: f64 = 1e6;

impl Calculator {
    /// The calculator with a name.
    pub fn find(name: &str) -> Option<&'static Self> {
        ALL.iter().find(|own| own.name == name)
    }

    /// The values of the texts of the fields, in millimetres; 0 for a name. A decimal comma is a point.
    pub fn read(&self, texts: &[String], unit: Unit) -> Result<Vec<f64>, Wrong> {
        let value = |(at, field): (usize, &Field)| {
            if field.quantity == Quantity::ThreadName {
                return Ok(0.0);
            }
            let text = texts.get(at).map_or("", |text| text.trim()).replace(',', ".").replace('−', "-");
            let value = read_number(&text).ok_or((at, Fault::NotANumber))?;
            if value.abs() > MAX_VALUE {
                Err((at, Fault::TooLarge))
            } else {
                Ok(value * field.quantity.scale(unit))
            }
        };
        self.fields.iter().enumerate().map(value).collect()
    }

    /// The results for the values of the fields, in millimetres. `name`: the text of the field for a thread.
    pub fn compute(&self, values: &[f64], name: &str) -> Result<Outcome, Wrong> {
        match self.formula {
            Formula::Numbers(formula) => formula(values),
            Formula::Thread(formula) => {
                let thread = threads::find(name).ok_or((0, Fault::UnknownThread))?;
                let outcome = formula(&thread, values)?;
                Ok(Outcome { thread: Some(thread), ..outcome })
            }
        }
    }

    /// A program that shows the result, in millimetres.
    pub fn program(&self, values: &[f64], outcome: &Outcome) -> String {
        let blocks =
            outcome.blocks.iter().map(|block| Writing::METRIC.block(block)).collect::<Vec<_>>().join("\n");
        let lines = (self.program)(values, outcome);
        lines.iter().map(|line| format!("{}\n", line.replace("{}", &blocks))).collect()
    }
}

/// How values are written.
#[derive(Clone, Copy, Debug)]
pub struct Writing {
    /// Unit of length.
    pub unit: Unit,
    /// Meaning of a number without a decimal point.
    pub decimal: DecimalRule,
    /// Unit of P and Q.
    pub pq_unit: PqUnit,
}

impl Writing {
    /// Millimetres, also in numbers without a decimal point.
    pub const METRIC: Self =
        Self { unit: Unit::Millimetre, decimal: DecimalRule::Calculator, pq_unit: PqUnit::Um };

    /// A value for a field or a result: three decimals, four in inches.
    pub fn value(self, quantity: Quantity, value: f64) -> String {
        let value = value / quantity.scale(self.unit);
        let grain = 10f64.powi(i32::from(self.unit.decimals()));
        number((value * grain).round() / grain)
    }

    /// A block.
    pub fn block(self, block: &Block) -> String {
        let words = block.words.iter().map(|word| self.word(word, None));
        let code = Some(block.code.to_owned()).filter(|code| !code.is_empty());
        code.into_iter().chain(words).collect::<Vec<_>>().join(" ")
    }

    /// A word. `before`: the digits of the present P of G76, whose passes and pull-out are kept.
    fn word(self, word: &Word, before: Option<&str>) -> String {
        let letter = char::from(word.letter);
        let grain = self.unit.increment() * self.unit.millimetres();
        let length = |mm: f64| {
            let reading = Reading { unit: self.unit, decimal: self.decimal };
            written((mm / grain).round() * grain, reading)
        };
        let value = match word.value {
            WordValue::Length(mm) => length(mm),
            WordValue::PerTurn(mm) => trimmed(format!("{:.6}", mm / self.unit.millimetres())),
            WordValue::Increments(mm) if self.pq_unit == PqUnit::Mm => length(mm),
            WordValue::Increments(mm) => number((mm / grain).round()),
            WordValue::Number(value) => number(value),
            WordValue::Packed(angle) => match before.filter(|digits| digits.len() == 6) {
                Some(digits) => format!("{}{angle:02.0}", &digits[..4]),
                None => format!("0100{angle:02.0}"),
            },
        };
        format!("{letter}{value}")
    }
}

/// A decimal number without trailing zeros.
fn trimmed(text: String) -> String {
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}
