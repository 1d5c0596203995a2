//! What numbers without a decimal point count, where nobody says so: units, or least input increments.
//!
//! In: statements. Out: the rule, and the number that shows it best. Controls differ by one parameter
//! (FANUC 3401#0, B-64114EN §8.3), and programs by habit: who runs a control that counts increments writes
//! a point wherever he means millimetres or inches, even after a whole number. So the habit decides, and
//! one number that no lathe can mean.

use super::statement::{Statement, Word};
use crate::control::codes::{G, Multiple, g_code};
use crate::message::{Message, said};
use crate::setup::dialect::{CodeList, DecimalRule};
use crate::source::Span;
use crate::units::Unit;

/// Whole coordinates with a point that show the habit. A fraction has its point on every control.
const HABIT: usize = 3;
/// Least coordinates without a point of a program that has no point at all.
const WITHOUT_ANY: usize = 2;

/// What a number measures.
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
    /// The number as it is written, with its sign.
    pub value: f64,
    /// What it measures.
    pub measure: Measure,
}

impl NumberWithoutPoint {
    /// What it counts under a rule, in its measure.
    pub fn counts(&self, rule: DecimalRule) -> f64 {
        match rule {
            DecimalRule::Calculator => self.value,
            DecimalRule::LeastIncrement => self.value * self.measure.increment(),
        }
    }

    /// What is said of it under a rule; `word` as it is written.
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

/// What a word of a statement is, as far as its size is concerned.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Amount {
    /// A place or a way along X, a diameter.
    Diameter,
    /// A place or a way along Z.
    Length,
    /// Depth of a cut, escape, allowance of a roughing or grooving cycle.
    Cut,
    /// What G73 takes off in all.
    Relief,
    /// Finishing allowance of a thread.
    ThreadAllowance,
    /// A dwell.
    Time,
}

impl Amount {
    /// From where on no lathe can mean it as millimetres, inches or seconds.
    ///
    /// * X: a swing of 1 m. What is larger is turned on special machines; Z: 2 m, beyond most beds.
    /// * A cut: 50 mm deep, or as much left for finishing; the deepest roughing takes about 15 mm a side.
    ///   Under G20 10 in, since a bare `U1` is too much for inches and too little for increments, and so
    ///   shows nothing.
    /// * G73 takes off what a casting has too much: 100 mm at most.
    /// * A thread is some millimetres deep; its last cut cannot be 10 mm.
    /// * Nobody dwells eight minutes.
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

    /// The same where every number of the program says it: small ones do not hide that
    /// the large ones are too many.
    fn usual_limit(self, measure: Measure) -> f64 {
        match self {
            Self::Length => Self::Diameter.limit(measure),
            own => own.limit(measure),
        }
    }

    /// What the word of a letter is among the others of its statement; nothing for what is
    /// no amount, or may be any.
    fn of(letter: u8, among: &Among) -> Option<Self> {
        if among.dwells {
            return matches!(letter, b'X' | b'U').then_some(Self::Time);
        }
        // In the first of their two blocks the cycles have amounts, in the second a contour or a place.
        let of_cycle = match (among.cycle, letter) {
            (Some(Multiple::Pattern), b'U' | b'W') if !among.names_contour => Some(Self::Relief),
            (Some(Multiple::Pattern | Multiple::RoughTurning | Multiple::RoughFacing), b'U' | b'W') => {
                Some(Self::Cut)
            }
            (Some(Multiple::RoughTurning | Multiple::RoughFacing), b'R') if !among.names_contour => {
                Some(Self::Cut)
            }
            (Some(Multiple::FacePecking | Multiple::Grooving), b'R') if !among.names_place => Some(Self::Cut),
            (Some(Multiple::Threading), b'R') if !among.names_place => Some(Self::ThreadAllowance),
            (
                Some(
                    Multiple::Finishing
                    | Multiple::RoughTurning
                    | Multiple::RoughFacing
                    | Multiple::Pattern
                    | Multiple::FacePecking
                    | Multiple::Grooving
                    | Multiple::Threading,
                )
                | None,
                _,
            ) => None,
        };
        of_cycle.or(match letter {
            b'X' | b'U' | b'Y' | b'V' => Some(Self::Diameter),
            b'Z' | b'W' => Some(Self::Length),
            _ => None,
        })
    }
}

/// What of a statement decides what its amounts are.
#[derive(Clone, Copy, Debug, Default)]
struct Among {
    /// G04.
    dwells: bool,
    /// The multiple cycle it calls.
    cycle: Option<Multiple>,
    /// P or Q.
    names_contour: bool,
    /// X, Z, U or W.
    names_place: bool,
    /// F.
    has_feed: bool,
    /// G codes.
    codes: usize,
    /// G20 or G21.
    unit: Option<Unit>,
    /// G65, G66: its words are arguments of a macro, and what the macro makes of them.
    calls_macro: bool,
}

impl Among {
    fn of(statement: &Statement) -> Self {
        let mut among = Self::default();
        for word in statement.words() {
            match word.letter {
                b'G' => {
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
                b'P' | b'Q' => among.names_contour = true,
                b'X' | b'Z' | b'U' | b'W' => among.names_place = true,
                b'F' => among.has_feed = true,
                _ => {}
            }
        }
        // In system C G20 and G21 are cycles.
        if among.codes == 1 && among.has_feed && among.names_place {
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

/// What the numbers of a program show.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DecimalEvidence {
    /// Coordinates with a point.
    pointed: usize,
    /// Those of them that are whole.
    whole: usize,
    /// Coordinates without a point, zeros left out.
    bare: usize,
    /// Those of them that would be too large as units.
    large: usize,
    /// G20 is in force.
    inch: bool,
    /// The first number without a point.
    first: Option<NumberWithoutPoint>,
    /// The first that is too large as a unit in a program of few numbers without a point.
    implausible: Option<NumberWithoutPoint>,
    /// The first that is too large as a unit in a program without points.
    large_number: Option<NumberWithoutPoint>,
}

impl DecimalEvidence {
    /// Takes in one more statement.
    pub fn take(&mut self, statement: &Statement) {
        let among = Among::of(statement);
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

    fn take_word(&mut self, word: &Word, among: &Among) {
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

    /// What numbers without a point count.
    pub fn rule(&self) -> DecimalRule {
        match self.evidence() {
            Some(_) => DecimalRule::LeastIncrement,
            None => DecimalRule::Calculator,
        }
    }

    /// The number that shows that they count least increments.
    pub fn evidence(&self) -> Option<NumberWithoutPoint> {
        let habit = self.implausible.filter(|_| self.whole >= HABIT);
        let without_any = self.pointed == 0 && self.bare >= WITHOUT_ANY && 2 * self.large > self.bare;
        habit.or(self.large_number.filter(|_| without_any))
    }

    /// A number without a point to show a rule by: the best there is.
    pub fn example(&self) -> Option<NumberWithoutPoint> {
        self.evidence().or(self.implausible).or(self.first)
    }
}
