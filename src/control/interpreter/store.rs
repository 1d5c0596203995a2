//! The variables of a run, as the evaluation of macros reads and writes them.
//!
//! In: numbers of variables. Out: their values, whether these are known, and the effects of reading and
//! writing on the run.

use super::Interpreter;
use crate::control::macros::{Found, Knowledge, MacroErrorKind, Memory, Stored, Variables};
use crate::control::offsets::Setting;
use crate::setup::dialect::Control;
use crate::text::block::Block;

/// The variables for a statement of a block.
pub(super) struct Store<'a> {
    interpreter: &'a mut Interpreter,
    text: &'a [u8],
    block: &'a Block,
    /// The system variable that was read last.
    read: Option<u32>,
    /// Whether all values read are known.
    pub(super) knowledge: Knowledge,
}

impl<'a> Store<'a> {
    pub(super) fn new(interpreter: &'a mut Interpreter, text: &'a [u8], block: &'a Block) -> Self {
        Self { interpreter, text, block, read: None, knowledge: Knowledge::Known }
    }

    /// Checks that a variable exists on this control; `Variables` checks everything except the variables that
    /// only GSK has.
    fn exists(&self, variable: u32) -> Result<(), MacroErrorKind> {
        let is_gsk = self.interpreter.dialect.control == Control::Gsk;
        if is_gsk || !Variables::is_of_gsk(variable) { Ok(()) } else { Err(MacroErrorKind::VariableNumber) }
    }
}

impl Memory for Store<'_> {
    fn read(&mut self, variable: u32) -> Result<Option<f64>, MacroErrorKind> {
        self.exists(variable)?;
        Ok(match self.interpreter.state.variables.read(variable)? {
            Found::Value(value) => {
                if value.is_none() && Variables::may_be_argument(variable) {
                    self.interpreter.report_missing_arguments(self.text, self.block, variable);
                }
                self.interpreter.note_access(self.block.span.start, variable, Some(value));
                if self.interpreter.state.variables.is_unknown(variable) {
                    self.knowledge = Knowledge::Unknown;
                }
                value
            }
            Found::System => {
                self.read = Some(variable);
                self.interpreter.read_system(self.text, self.block, variable)
            }
        })
    }

    fn write(&mut self, variable: u32, value: Option<f64>) -> Result<(), MacroErrorKind> {
        self.exists(variable)?;
        if self.interpreter.state.variables.write(variable, value)? == Stored::System {
            let setting = if self.read == Some(variable) { Setting::Relative } else { Setting::Absolute };
            self.interpreter.write_system(self.block, variable, value, setting);
        }
        self.interpreter.state.variables.set_unknown(variable, self.knowledge);
        let level = self.interpreter.state.variables.level();
        self.interpreter.note_access(self.block.span.start, variable, None);
        self.interpreter.note_assigned(level, variable, self.block.span.start);
        Ok(())
    }
}

/// Values that a pass of the main program reads before it assigns them.
impl Interpreter {
    /// Ends a pass of the main program at M99. Returns whether the next pass, from the block at byte `from`
    /// or from the head, begins with a different value of a variable that it reads.
    pub(super) fn begin_next_pass(&mut self, text: &[u8], block: &Block, from: Option<u32>) -> bool {
        let pass = std::mem::take(&mut self.state.call_stack.main_pass);
        let differs = |&(variable, at_start): &(u32, Option<f64>)| {
            let now = match self.state.variables.read(variable) {
                Ok(Found::Value(value)) => value,
                _ => self.system_value(text, block, variable),
            };
            now != at_start
        };
        let goes_on = !pass.is_compared() || pass.inputs(from).iter().any(differs);
        let read = pass.system_read().into_iter();
        let system = read.filter_map(|variable| Some((variable, self.system_value(text, block, variable)?)));
        self.state.call_stack.main_pass = pass.next(from, system.collect());
        goes_on
    }
}
