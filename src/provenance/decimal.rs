//! The unit of numbers without a decimal point if the setup does not give it: whole units or least input
//! increments.
//!
//! In: statements. Out: the rule, and the number that is the best evidence. Controls differ by one parameter
//! (FANUC 3401#0, B-64114EN §8.3), and programs by habit: for a control that counts increments, authors write
//! a point in all millimetres and inches, even after a whole number. So this habit decides, together with one
//! number that is impossible as a length on a lathe.

use super::statement::{Statement, Word};
use crate::control::codes::words::Amount;
use crate::control::codes::{G, Multiple, g_code};
use crate::control::words::letters;
use crate::message::{Message, said};
use crate::setup::dialect::{CodeList, DecimalRule};
use crate::source::Span;
use crate::units::Unit;

/// Number of whole coordinates with a point that show the habit. A fraction has its point on every control.
const HABIT: usize = 3;
/// Least number of coordinates without a point in a program without any point.
const WITHOUT_ANY: usize = 2;

/// The kind of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Measure {
    /// A length under G21.
    Millimetre,
    /// A length under G20.
    Inch,
    /// The time of a dwell.
    Second,
}

impl Measure {
    /// Least input increment: 0.001 mm, 0.0001 inch, 0.001 s (IS-B).
    pub fn increment(self) -> f64 {
        match self {
            Self::Millimetre | Self::Second => 1e-3,
            Self::Inch => 1e-4,
        }
    }
}

/// A number without a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NumberWithoutPoint {
    /// Its word.
    pub span: Span,
    /// The number as written, with its sign.
    pub value: f64,
    /// Its kind.
    pub measure: Measure,
}

impl NumberWithoutPoint {
    /// Its value under a rule, in the unit of its kind.
    pub fn counts(&self, rule: DecimalRule) -> f64 {
        match rule {
            DecimalRule::Calculator => self.value,
            DecimalRule::LeastIncrement => self.value * self.measure.increment(),
        }
    }

    /// The message about it under a rule; `word` is its word as written.
    pub fn message(&self, rule: DecimalRule, word: String) -> Message {
        let value = self.counts(rule);
        match (rule, self.measure) {
            (DecimalRule::LeastIncrement, Measure::Millimetre) => {
                said::LeastIncrementsMillimetres { word, value }.into()
            }
            (DecimalRule::LeastIncrement, Measure::Inch) => {
                said::LeastIncrementsInches { word, value }.into()
            }
            (DecimalRule::LeastIncrement, Measure::Second) => {
                said::LeastIncrementsSeconds { word, value }.into()
            }
            (DecimalRule::Calculator, Measure::Millimetre) => {
                said::TooLargeMillimetres { word, value }.into()
            }
            (DecimalRule::Calculator, Measure::Inch) => said::TooLargeInches { word, value }.into(),
            (DecimalRule::Calculator, Measure::Second) => said::TooLargeSeconds { word, value }.into(),
        }
    }
}

impl Amount {
    /// The value from which it is impossible as millimetres, inches or seconds.
    ///
    /// * X: a swing of 1 m. Larger parts are turned on special machines; Z: 2 m, beyond most beds.
    /// * A cut: 50 mm deep, or the same as a finishing allowance; the deepest roughing takes about 15 mm a
    ///   side. Under G20 10 in, since `U1` without a point is too much as inches and too little as
    ///   increments, and so is no evidence.
    /// * G73 removes the excess of a casting: 100 mm at most.
    /// * A thread is some millimetres deep; its last cut cannot be 10 mm.
    /// * No dwell lasts eight minutes.
    fn limit(self, measure: Measure) -> f64 {
        let (millimetres, inches) = match self {
            Self::Diameter => (1000.0, 40.0),
            Self::Length => (2000.0, 80.0),
            Self::Cut => (50.0, 10.0),
            Self::Relief => (100.0, 10.0),
            Self::ThreadAllowance => (10.0, 2.0),
            Self::Time => return 500.0,
        };
        if measure == Measure::Inch { inches } else { millimetres }
    }

    /// The same limit for a program without any point, in which many numbers are large.
    fn usual_limit(self, measure: Measure) -> f64 {
        match self {
            Self::Length => Self::Diameter.limit(measure),
            own => own.limit(measure),
        }
    }

    /// The amount of the word with a letter, given its statement; `None` if it is not an amount, or may have
    /// any size.
    fn of(letter: u8, among: &StatementContext) -> Option<Self> {
        if among.dwells {
            return matches!(letter, b'X' | b'U').then_some(Self::Time);
        }
        let of_cycle = among.cycle.and_then(|cycle| {
            let spec = cycle.spec();
            spec.amount(spec.block(among.given), letter)
        });
        of_cycle.or(match letter {
            b'X' | b'U' | b'Y' | b'V' => Some(Self::Diameter),
            b'Z' | b'W' => Some(Self::Length),
            _ => None,
        })
    }
}

/// The properties of a statement that decide the meaning of its words.
#[derive(Clone, Copy, Debug, Default)]
struct StatementContext {
    /// G04.
    dwells: bool,
    /// The multiple cycle that it calls.
    cycle: Option<Multiple>,
    /// Its letters, as the bits of [`letters`].
    given: u32,
    /// Number of G codes.
    codes: usize,
    /// G20 or G21.
    unit: Option<Unit>,
    /// G65 or G66: its words are arguments, whose meaning depends on the macro.
    calls_macro: bool,
}

impl StatementContext {
    fn of(statement: &Statement) -> Self {
        let mut among = Self::default();
        for word in statement.words() {
            among.given |= letters(&[word.letter]);
            if word.letter == b'G' {
                among.codes += 1;
                match word.number.and_then(|number| number.tenths()) {
                    Some(40) => among.dwells = true,
                    Some(650 | 660 | 661) => among.calls_macro = true,
                    Some(200) => among.unit = Some(Unit::Inch),
                    Some(210) => among.unit = Some(Unit::Millimetre),
                    Some(key) => among.cycle = multiple(key).or(among.cycle),
                    None => {}
                }
            }
        }
        let has = |any: &[u8]| among.given & letters(any) != 0;
        // In system C G20 and G21 are cycles.
        if among.codes == 1 && has(b"F") && has(b"XZUW") {
            among.unit = None;
        }
        among
    }
}

/// The multiple cycle of a code, ten times its number, in systems A and B.
fn multiple(key: u64) -> Option<Multiple> {
    match g_code(key, CodeList::A)?.code {
        G::Multiple(cycle) => Some(cycle),
        _ => None,
    }
}

/// The evidence in the numbers of a program.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DecimalEvidence {
    /// Number of coordinates with a point.
    pointed: usize,
    /// Number of whole coordinates among them.
    whole: usize,
    /// Number of coordinates without a point, except zeros.
    bare: usize,
    /// Number of coordinates among them that would be too large as whole units.
    large: usize,
    /// Whether G20 is active.
    inch: bool,
    /// The first number without a point.
    first: Option<NumberWithoutPoint>,
    /// The first number that is too large as whole units, in a program with few numbers without a point.
    implausible: Option<NumberWithoutPoint>,
    /// The first number that is too large as whole units, in a program without points.
    large_number: Option<NumberWithoutPoint>,
}

impl DecimalEvidence {
    /// Adds a statement.
    pub fn take(&mut self, statement: &Statement) {
        let among = StatementContext::of(statement);
        if among.calls_macro {
            return;
        }
        self.inch = among.unit.map_or(self.inch, |unit| unit == Unit::Inch);
        for word in statement.words() {
            if !word.assigned {
                self.take_word(word, &among);
            }
        }
    }

    fn take_word(&mut self, word: &Word, among: &StatementContext) {
        let Some(number) = word.number else { return };
        let Some(amount) = Amount::of(word.letter, among) else { return };
        let is_coordinate = word.letter != b'R' && amount != Amount::Time;
        let magnitude = number.value();
        if number.has_point() {
            self.pointed += usize::from(is_coordinate);
            self.whole += usize::from(is_coordinate && magnitude.fract() == 0.0);
            return;
        }
        if magnitude == 0.0 {
            return;
        }
        let measure = match (amount, self.inch) {
            (Amount::Time, _) => Measure::Second,
            (_, true) => Measure::Inch,
            (_, false) => Measure::Millimetre,
        };
        let value = if word.negative { -magnitude } else { magnitude };
        let bare = NumberWithoutPoint { span: word.span, value, measure };
        self.first = self.first.or(Some(bare));
        if magnitude >= amount.limit(measure) {
            self.implausible = self.implausible.or(Some(bare));
        }
        if is_coordinate {
            self.bare += 1;
            if magnitude >= amount.usual_limit(measure) {
                self.large += 1;
                self.large_number = self.large_number.or(Some(bare));
            }
        }
    }

    /// The rule for numbers without a point.
    pub fn rule(&self) -> DecimalRule {
        match self.evidence() {
            Some(_) => DecimalRule::LeastIncrement,
            None => DecimalRule::Calculator,
        }
    }

    /// The number that proves least increments.
    pub fn evidence(&self) -> Option<NumberWithoutPoint> {
        let habit = self.implausible.filter(|_| self.whole >= HABIT);
        let without_any = self.pointed == 0 && self.bare >= WITHOUT_ANY && 2 * self.large > self.bare;
        habit.or(self.large_number.filter(|_| without_any))
    }

    /// The best number without a point to demonstrate a rule.
    pub fn example(&self) -> Option<NumberWithoutPoint> {
        self.evidence().or(self.implausible).or(self.first)
    }
}
