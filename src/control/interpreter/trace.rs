//! The blocks that were carried out, kept for whoever writes the program out again.
//!
//! In: blocks as they run. Out: [`Executed`]. Costs nothing where it is not asked for.

use super::Interpreter;
use super::calls::Here;
use crate::control::codes;
use crate::motion::Process;
use crate::parts::in_part;
use crate::text::block::{Block, BlockKind, Value};
use crate::text::parser::Resume;

/// A block that was carried out.
#[derive(Clone, Debug, PartialEq)]
pub struct Executed {
    /// Where it stands.
    pub at: Resume,
    /// Motions kept before it.
    pub first: usize,
    /// Its words with values in place of expressions.
    pub values: Option<String>,
    /// It only steers the program: a macro statement, a call, a return.
    pub steers: bool,
    /// Feed, spindle and tool before it.
    pub before: Process,
    /// The same once its own words for them count, before it moves.
    pub ready: Process,
}

in_part! {
    Tools "0412"
    pub(super) fn keep_block(interpreter: &mut Interpreter, block: &Block, here: Here) {
        interpreter.trace_block(block, here);
    }

    Tools "0413"
    pub(super) fn keep_process(interpreter: &mut Interpreter) {
        interpreter.trace_process();
    }

    Tools "0410"
    // Only tools ask for a trace.
    fn assigned(variable: u32, value: f64) -> String {
        format!("#{variable}={value}")
    }

    Tools "0411"
    fn values_of(block: &Block) -> String {
        let mut values = String::new();
        for word in &block.words {
            let Value::Number { number, negative } = word.value else { continue };
            let (comma, minus) = (if word.comma { "," } else { "" }, if negative { "-" } else { "" });
            let space = if values.is_empty() { "" } else { " " };
            let whole = number.value().fract() == 0.0;
            let point = if number.has_point() && whole { "." } else { "" };
            values += &format!("{space}{comma}{}{minus}{}{point}", word.address as char, number.value());
        }
        values
    }
}

impl Interpreter {
    /// Keeps a block that is carried out.
    fn trace_block(&mut self, block: &Block, here: Here) {
        let first = self.sink.kept();
        let process = self.state.process();
        let Some(trace) = self.trace.as_mut().filter(|_| self.contours.recorded.is_none()) else { return };
        let steers =
            !block.is_broken() && block.kind == BlockKind::Macro || block.words.iter().any(codes::steers);
        trace.push(Executed { at: here.at, first, values: None, steers, before: process, ready: process });
    }

    /// Keeps what the last block has made of feed, spindle and tool.
    fn trace_process(&mut self) {
        let process = self.state.process();
        let Some(trace) = self.trace.as_mut().filter(|_| self.contours.recorded.is_none()) else { return };
        if let Some(last) = trace.last_mut() {
            last.ready = process;
        }
    }

    /// Keeps what the last block wrote into a table of the control.
    pub(super) fn trace_write(&mut self, variable: u32, value: f64) {
        if let Some(last) = self.trace.as_mut().and_then(|trace| trace.last_mut()) {
            last.values = Some(assigned(variable, value));
        }
    }

    /// The last block could not be carried out, and stays as it is.
    pub(super) fn trace_fault(&mut self) {
        if let Some(last) = self.trace.as_mut().and_then(|trace| trace.last_mut()) {
            last.steers = false;
        }
    }

    /// Keeps the words of the last block with their values.
    #[cold]
    pub(super) fn trace_values(&mut self, block: &Block) {
        let Some(trace) = self.trace.as_mut().filter(|_| self.contours.recorded.is_none()) else { return };
        let values = values_of(block);
        if let Some(last) = trace.last_mut() {
            last.values = Some(values);
            last.steers = !block.is_broken() && block.words.iter().any(codes::steers);
        }
    }

    /// The last block was not carried out, for want of a value.
    pub(super) fn trace_nothing(&mut self) {
        if let Some(last) = self.trace.as_mut().and_then(|trace| trace.last_mut()) {
            (last.values, last.steers) = (Some(String::new()), false);
        }
    }
}
