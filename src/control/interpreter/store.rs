//! The variables of a run, as the evaluation of macros reads and writes them.
//!
//! In: numbers of variables. Out: their values, whether they are known, and what reading
//! and writing does to the run.

use super::Interpreter;
use crate::control::macros::{Found, Knowledge, MacroErrorKind, Memory, Stored, Variables};
use crate::text::block::Block;

/// The variables as a statement of a block sees them.
pub(super) struct Store<'a> {
    interpreter: &'a mut Interpreter,
    text: &'a [u8],
    block: &'a Block,
    /// Whether everything read so far is known.
    pub(super) knowledge: Knowledge,
}

impl<'a> Store<'a> {
    pub(super) fn new(interpreter: &'a mut Interpreter, text: &'a [u8], block: &'a Block) -> Self {
        Self { interpreter, text, block, knowledge: Knowledge::Known }
    }
}

impl Memory for Store<'_> {
    fn read(&mut self, variable: u32) -> Result<Option<f64>, MacroErrorKind> {
        Ok(match self.interpreter.state.variables.read(variable)? {
            Found::Value(value) => {
                if value.is_none() && Variables::may_be_argument(variable) {
                    self.interpreter.miss_arguments(self.text, self.block, variable);
                }
                if self.interpreter.state.variables.is_unknown(variable) {
                    self.knowledge = Knowledge::Unknown;
                }
                value
            }
            Found::System => self.interpreter.read_system(self.text, self.block, variable),
        })
    }

    fn write(&mut self, variable: u32, value: Option<f64>) -> Result<(), MacroErrorKind> {
        if self.interpreter.state.variables.write(variable, value)? == Stored::System {
            self.interpreter.write_system(self.block, variable, value);
        }
        self.interpreter.state.variables.set_unknown(variable, self.knowledge);
        let level = self.interpreter.state.variables.level();
        self.interpreter.note_assigned(level, variable, self.block.span.start);
        Ok(())
    }
}
