//! The variables of a control as plain values: local to each call level, and common.
//!
//! In and out: variable numbers and values. System variables (#1000 and up) are not kept here: they stand for
//! something else, which only the caller knows. Cloning is cheap, since what is cloned is shared until one of
//! the two is written to.

use std::sync::Arc;

use super::{MacroErrorKind, Memory};
use crate::limits::MACRO_LEVELS;

/// Local variables of one level: #1 to #33.
pub const LOCALS: usize = 33;

/// The local variables of one level; #1 stands first.
pub type Locals = [Option<f64>; LOCALS];

/// Most levels: the main program and five calls inside each other.
pub const MOST_LEVELS: usize = 1 + MACRO_LEVELS;

/// Common variables lost at power off: #100 to #199, on GSK to #231.
const PASSING: usize = 132;

/// Common variables kept at power off: #500 to #999.
const KEPT: usize = 500;

/// What reading a variable found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Found {
    /// Its value; `None` when it is vacant.
    Value(Option<f64>),
    /// A system variable: the caller knows its value.
    System,
}

/// What became of writing a variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stored {
    /// It has the value.
    Done,
    /// A system variable: the caller knows what it means.
    System,
}

/// All variables but those of the system.
#[derive(Clone, Debug)]
pub struct Variables {
    /// One for each level, the main program first; never empty.
    levels: Arc<Vec<Locals>>,
    /// #100 to #231.
    passing: Arc<[Option<f64>; PASSING]>,
    /// #500 to #999.
    kept: Arc<[Option<f64>; KEPT]>,
    /// A bit for each variable of the main program whose value nobody knows; `None` while all are known.
    unknown: Option<Arc<Bits>>,
}

/// A bit for each variable below #1024.
type Bits = [u64; 16];

impl Default for Variables {
    /// At the level of the main program, everything vacant.
    fn default() -> Self {
        Self {
            levels: Arc::new(vec![[None; LOCALS]]),
            passing: Arc::new([None; PASSING]),
            kept: Arc::new([None; KEPT]),
            unknown: None,
        }
    }
}

impl PartialEq for Variables {
    /// Shared values are the same without being looked at.
    fn eq(&self, other: &Self) -> bool {
        (Arc::ptr_eq(&self.levels, &other.levels) || self.levels == other.levels)
            && (Arc::ptr_eq(&self.passing, &other.passing) || self.passing == other.passing)
            && (Arc::ptr_eq(&self.kept, &other.kept) || self.kept == other.kept)
            && self.unknown == other.unknown
    }
}

/// Where a variable is kept.
enum Place {
    /// #0.
    Vacant,
    /// Index among the local variables of the level.
    Local(usize),
    /// Index from #100.
    Passing(usize),
    /// Index from #500.
    Kept(usize),
    /// #1000 and up.
    System,
}

impl Place {
    fn of(variable: u32) -> Result<Self, MacroErrorKind> {
        let number = variable as usize;
        Ok(match variable {
            0 => Self::Vacant,
            1..=33 => Self::Local(number - 1),
            100..=231 => Self::Passing(number - 100),
            500..=999 => Self::Kept(number - 500),
            1000.. => Self::System,
            34..=99 | 232..=499 => return Err(MacroErrorKind::VariableNumber),
        })
    }
}

impl Variables {
    /// The value of a variable.
    pub fn read(&self, variable: u32) -> Result<Found, MacroErrorKind> {
        Ok(Found::Value(match Place::of(variable)? {
            Place::Vacant => None,
            Place::Local(index) => self.levels.last().and_then(|locals| locals[index]),
            Place::Passing(index) => self.passing[index],
            Place::Kept(index) => self.kept[index],
            Place::System => return Ok(Found::System),
        }))
    }

    /// Gives a variable a value, or makes it vacant.
    pub fn write(&mut self, variable: u32, value: Option<f64>) -> Result<Stored, MacroErrorKind> {
        match Place::of(variable)? {
            Place::Vacant => return Err(MacroErrorKind::ReadOnly),
            Place::Local(index) => {
                if let Some(locals) = Arc::make_mut(&mut self.levels).last_mut() {
                    locals[index] = value;
                }
            }
            Place::Passing(index) => Arc::make_mut(&mut self.passing)[index] = value,
            Place::Kept(index) => Arc::make_mut(&mut self.kept)[index] = value,
            Place::System => return Ok(Stored::System),
        }
        Ok(Stored::Done)
    }

    /// Enters a macro, whose local variables are these. False: there are as many levels as a control has.
    pub fn push_level(&mut self, arguments: Locals) -> bool {
        let is_room = self.levels.len() < MOST_LEVELS;
        if is_room {
            Arc::make_mut(&mut self.levels).push(arguments);
        }
        is_room
    }

    /// Leaves a macro: the local variables of the program that called it are back. In the
    /// main program nothing happens.
    pub fn pop_level(&mut self) {
        if self.levels.len() > 1 {
            Arc::make_mut(&mut self.levels).pop();
        }
    }

    /// Calls inside each other: 0 in the main program.
    pub fn level(&self) -> usize {
        self.levels.len() - 1
    }
}

/// What is not known: the arguments of a macro that was not called, and what comes of them.
impl Variables {
    /// Whether GSK alone has a variable: #200 to #231 (GSK980TD, common variables).
    pub fn is_of_gsk(variable: u32) -> bool {
        matches!(variable, 200..=231)
    }

    /// Whether a vacant variable may be an argument that a call hands over by its letter.
    pub fn may_be_argument(variable: u32) -> bool {
        matches!(variable, 1..=9 | 11 | 13 | 17..=26)
    }

    /// The arguments of the main program are not known: what is vacant and stands for a letter.
    pub fn lack_arguments(&mut self) {
        let mut unknown = Bits::default();
        for (variable, value) in (1..).zip(&self.levels[0]) {
            if value.is_none() && Self::may_be_argument(variable) {
                let (index, bit) = bit_of(variable);
                unknown[index] |= bit;
            }
        }
        self.unknown = Some(Arc::new(unknown));
    }

    /// Whether the arguments of the main program are not known.
    pub fn lacks_arguments(&self) -> bool {
        self.unknown.is_some()
    }

    /// Whether the value of a variable is not known. What a macro was handed by a program
    /// without its arguments is not.
    pub fn is_unknown(&self, variable: u32) -> bool {
        let Some(unknown) = &self.unknown else { return false };
        let (index, bit) = bit_of(variable);
        match variable {
            1..=33 if self.level() > 0 => true,
            0..1000 => unknown[index] & bit != 0,
            1000.. => false,
        }
    }

    /// Says whether the value that a variable was given is unknown.
    pub fn set_unknown(&mut self, variable: u32, is: Knowledge) {
        let own_level = variable > 33 || self.level() == 0;
        if let Some(unknown) = &mut self.unknown
            && own_level
            && variable < 1000
        {
            let (index, bit) = bit_of(variable);
            let bits = &mut Arc::make_mut(unknown)[index];
            match is {
                Knowledge::Known => *bits &= !bit,
                Knowledge::Unknown => *bits |= bit,
            }
        }
    }
}

/// Whether a value is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Knowledge {
    /// It is what the control would have.
    Known,
    /// It depends on arguments that nobody gave.
    Unknown,
}

/// Where the bit of a variable is.
fn bit_of(variable: u32) -> (usize, u64) {
    ((variable as usize / 64) % 16, 1 << (variable % 64))
}

impl Memory for Variables {
    /// Without system variables: they do not exist here.
    fn read(&mut self, variable: u32) -> Result<Option<f64>, MacroErrorKind> {
        match Variables::read(self, variable)? {
            _ if Self::is_of_gsk(variable) => Err(MacroErrorKind::VariableNumber),
            Found::Value(value) => Ok(value),
            Found::System => Err(MacroErrorKind::VariableNumber),
        }
    }

    fn write(&mut self, variable: u32, value: Option<f64>) -> Result<(), MacroErrorKind> {
        if Self::is_of_gsk(variable) {
            return Err(MacroErrorKind::VariableNumber);
        }
        match Variables::write(self, variable, value)? {
            Stored::Done => Ok(()),
            Stored::System => Err(MacroErrorKind::VariableNumber),
        }
    }
}
