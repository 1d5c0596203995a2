//! The variables of a control as plain values: local variables of each call level, and common variables.
//!
//! In and out: variable numbers and values. System variables (#1000 and up) are not stored here, because only
//! the caller knows their meaning. Cloning is cheap: clones share their data until one of them is written.

use std::sync::Arc;

use super::{MacroErrorKind, Memory};
use crate::limits::MACRO_LEVELS;

/// Number of local variables of a level: #1 to #33.
pub const LOCALS: usize = 33;

/// The local variables of a level, beginning with #1.
pub type Locals = [Option<f64>; LOCALS];

/// Maximum number of levels: the main program and five nested calls.
pub const MAX_LEVELS: usize = 1 + MACRO_LEVELS;

/// Number of common variables that are lost at power off: #100 to #199, on GSK to #231.
const VOLATILE: usize = 132;

/// Number of common variables that are kept at power off: #500 to #999.
const PERSISTENT: usize = 500;

/// Result of reading a variable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Found {
    /// Its value; `None` if it is vacant.
    Value(Option<f64>),
    /// A system variable: the caller knows its value.
    System,
}

/// Result of writing a variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stored {
    /// The value was stored.
    Done,
    /// A system variable: the caller knows its meaning.
    System,
}

/// All variables except the system variables.
#[derive(Clone, Debug)]
pub struct Variables {
    /// One for each level, the main program first; never empty.
    levels: Arc<Vec<Locals>>,
    /// #100 to #231.
    volatile: Arc<[Option<f64>; VOLATILE]>,
    /// #500 to #999.
    persistent: Arc<[Option<f64>; PERSISTENT]>,
    /// A bit for each variable of the main program with an unknown value; `None` while all are known.
    unknown: Option<Arc<Bits>>,
}

/// A bit for each variable below #1024.
type Bits = [u64; 16];

impl Default for Variables {
    /// The main program's level, with all variables vacant.
    fn default() -> Self {
        Self {
            levels: Arc::new(vec![[None; LOCALS]]),
            volatile: Arc::new([None; VOLATILE]),
            persistent: Arc::new([None; PERSISTENT]),
            unknown: None,
        }
    }
}

impl PartialEq for Variables {
    /// Shared data is equal without a comparison.
    fn eq(&self, other: &Self) -> bool {
        (Arc::ptr_eq(&self.levels, &other.levels) || self.levels == other.levels)
            && (Arc::ptr_eq(&self.volatile, &other.volatile) || self.volatile == other.volatile)
            && (Arc::ptr_eq(&self.persistent, &other.persistent) || self.persistent == other.persistent)
            && self.unknown == other.unknown
    }
}

/// Where a variable is stored.
enum Place {
    /// #0.
    Vacant,
    /// Index among the local variables of the level.
    Local(usize),
    /// Index from #100.
    Volatile(usize),
    /// Index from #500.
    Persistent(usize),
    /// #1000 and up.
    System,
}

impl Place {
    fn of(variable: u32) -> Result<Self, MacroErrorKind> {
        let number = variable as usize;
        Ok(match variable {
            0 => Self::Vacant,
            1..=33 => Self::Local(number - 1),
            100..=231 => Self::Volatile(number - 100),
            500..=999 => Self::Persistent(number - 500),
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
            Place::Volatile(index) => self.volatile[index],
            Place::Persistent(index) => self.persistent[index],
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
            Place::Volatile(index) => Arc::make_mut(&mut self.volatile)[index] = value,
            Place::Persistent(index) => Arc::make_mut(&mut self.persistent)[index] = value,
            Place::System => return Ok(Stored::System),
        }
        Ok(Stored::Done)
    }

    /// Enters a macro with these local variables. False if the maximum number of levels is reached.
    pub fn push_level(&mut self, arguments: Locals) -> bool {
        let is_room = self.levels.len() < MAX_LEVELS;
        if is_room {
            Arc::make_mut(&mut self.levels).push(arguments);
        }
        is_room
    }

    /// Leaves a macro and restores the local variables of its caller. No effect in the main program.
    pub fn pop_level(&mut self) {
        if self.levels.len() > 1 {
            Arc::make_mut(&mut self.levels).pop();
        }
    }

    /// Number of nested calls: 0 in the main program.
    pub fn level(&self) -> usize {
        self.levels.len() - 1
    }
}

/// Unknown values: the arguments of a macro that runs without being called, and everything derived from them.
impl Variables {
    /// Whether only GSK has this variable: #200 to #231 (GSK980TD, common variables).
    pub fn is_of_gsk(variable: u32) -> bool {
        matches!(variable, 200..=231)
    }

    /// Whether a vacant variable may be an argument, passed by its letter.
    pub fn may_be_argument(variable: u32) -> bool {
        matches!(variable, 1..=9 | 11 | 13 | 17..=26)
    }

    /// Marks the arguments of the main program as unknown: vacant variables that have a letter.
    pub fn mark_arguments_unknown(&mut self) {
        let mut unknown = Bits::default();
        for (variable, value) in (1..).zip(&self.levels[0]) {
            if value.is_none() && Self::may_be_argument(variable) {
                let (index, bit) = bit_of(variable);
                unknown[index] |= bit;
            }
        }
        self.unknown = Some(Arc::new(unknown));
    }

    /// Whether the arguments of the main program are unknown.
    pub fn has_unknown_arguments(&self) -> bool {
        self.unknown.is_some()
    }

    /// Whether the value of a variable is unknown. The arguments of a macro that such a program calls count
    /// as known.
    pub fn is_unknown(&self, variable: u32) -> bool {
        let Some(unknown) = &self.unknown else { return false };
        let (index, bit) = bit_of(variable);
        match variable {
            1..=33 if self.level() > 0 => true,
            0..1000 => unknown[index] & bit != 0,
            1000.. => false,
        }
    }

    /// Records whether the new value of a variable is known.
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
    /// It is the value that the control would have.
    Known,
    /// It depends on arguments that were not given.
    Unknown,
}

/// Index and mask of a variable's bit.
fn bit_of(variable: u32) -> (usize, u64) {
    ((variable as usize / 64) % 16, 1 << (variable % 64))
}

impl Memory for Variables {
    /// Without system variables, which do not exist here.
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
