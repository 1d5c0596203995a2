//! A trace of the executed blocks, for tools that write the program out again.
//!
//! In: blocks as they run. Out: [`Executed`]. Has no cost if it is not requested.

use super::{BlockPosition, Interpreter};
use crate::control::codes::{self, Compensation, MotionMode};
use crate::control::doubt::Doubt;
use crate::control::modal::State;
use crate::motion::Process;
use crate::parts::late;
use crate::text::block::{Block, BlockKind, Value, Word};
use crate::text::parser::Resume;
use std::sync::Arc;

/// An executed block.
#[derive(Clone, Debug, PartialEq)]
pub struct Executed {
    /// Its first byte and line.
    pub at: Resume,
    /// End of the contour that a cycle skips, one past its last byte; the end of the block if there is none.
    pub passed: u32,
    /// End of the empty blocks that follow, one past the last byte.
    pub until: u32,
    /// Number of motions kept before it.
    pub first: u32,
    /// Its words with values in place of expressions.
    pub values: Option<Box<str>>,
    /// It only controls the flow: a macro statement, a call, a return.
    pub is_flow_control: bool,
    /// It was not carried out, or only in part.
    pub failed: bool,
    /// The code of group 01 in force before it.
    pub mode: MotionMode,
    /// What it depends on, apart from the modal codes.
    pub context: Context,
    /// Feed, spindle and tool before it. Blocks that do not change them share the value.
    pub before: Arc<Process>,
    /// Feed, spindle and tool after its own words for them, before its moves.
    pub ready: Arc<Process>,
}

/// What the moves of a block depend on, apart from the modal codes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Context {
    /// Nothing else.
    #[default]
    Settled,
    /// The words of earlier blocks of the cycle or hole cycle in force, until a code of group 01.
    Cycle,
    /// A move that waits for its corner, compensation, or a position that is in doubt.
    Open,
    /// The block is data for the tables of the control (G10 to G11).
    Data,
}

impl Context {
    fn of(state: &State) -> Self {
        let mut doubts = state.doubts;
        // A block with a value from such a variable is itself in doubt.
        doubts.remove(Doubt::Values);
        let waits = state.pending.is_some() || state.compensating.is_some() || state.tip.is_some();
        if state.data_input {
            Self::Data
        } else if waits || state.compensation != Compensation::Off || !doubts.is_empty() {
            Self::Open
        } else if state.hole.is_some() || matches!(state.motion, MotionMode::Cycle(_)) {
            Self::Cycle
        } else {
            Self::Settled
        }
    }
}

late! {
    pub(super) fn keep_block(interpreter: &mut Interpreter, block: &Block, here: BlockPosition) {
        interpreter.trace_block(block, here);
    }

    pub(super) fn keep_process(interpreter: &mut Interpreter) {
        interpreter.trace_process();
    }

    // Only tools request a trace.
    fn assigned(variable: u32, value: f64) -> String {
        format!("#{variable}={value}")
    }

    fn values_of(block: &Block, doubtful: &[Word]) -> String {
        let mut values = String::new();
        for word in &block.words {
            let Value::Number { number, negative } = word.value else { continue };
            let (comma, minus) = (if word.comma { "," } else { "" }, if negative { "-" } else { "" });
            let space = if values.is_empty() { "" } else { " " };
            let whole = number.value().fract() == 0.0;
            let point = if number.has_point() && whole { "." } else { "" };
            let (letter, number) = (word.address as char, number.value());
            // A value in doubt stays an expression.
            let is_doubtful = doubtful.iter().any(|own| own.span == word.span && own.value == Value::Expression);
            values += &match is_doubtful {
                true => format!("{space}{comma}{letter}[{minus}{number}{point}]"),
                false => format!("{space}{comma}{letter}{minus}{number}{point}"),
            };
        }
        values
    }
}

impl Interpreter {
    /// Adds an executed block. Empty blocks are merged into the previous one.
    fn trace_block(&mut self, block: &Block, here: BlockPosition) {
        let first = self.sink.kept() as u32;
        let Some(trace) = self.trace.as_mut().filter(|_| self.contours.recorded.is_none()) else { return };
        let is_blank = block.is_empty()
            && block.sequence.is_none()
            && block.comments.is_empty()
            && block.faults.is_empty()
            && block.delete.is_none();
        if let Some(last) = trace.last_mut().filter(|last| is_blank && last.until == here.at.byte) {
            last.until = here.next.byte;
            return;
        }
        let process = self.state.process();
        let before = match trace.last() {
            Some(last) if *last.ready == process => last.ready.clone(),
            _ => Arc::new(process),
        };
        let is_flow_control = !block.is_broken() && block.kind == BlockKind::Macro
            || block.words.iter().any(codes::is_flow_control);
        trace.push(Executed {
            at: here.at,
            passed: here.next.byte,
            until: here.next.byte,
            first,
            values: None,
            is_flow_control,
            failed: false,
            mode: self.state.motion,
            context: Context::of(&self.state),
            ready: before.clone(),
            before,
        });
    }

    /// Records feed, spindle and tool after the words of the last block.
    fn trace_process(&mut self) {
        let process = self.state.process();
        let Some(trace) = self.trace.as_mut().filter(|_| self.contours.recorded.is_none()) else { return };
        if let Some(last) = trace.last_mut().filter(|last| *last.ready != process) {
            last.ready = Arc::new(process);
        }
    }

    /// Records that the last block is a cycle that skips its contour, up to `end`.
    #[cold]
    pub(super) fn trace_contour(&mut self, end: u32) {
        let Some(trace) = self.trace.as_mut().filter(|_| self.contours.recorded.is_none()) else { return };
        if let Some(last) = trace.last_mut().filter(|last| !last.is_flow_control && last.until < end) {
            (last.passed, last.until) = (end, end);
        }
    }

    /// Records that the last block, or a part of it, was not carried out.
    #[cold]
    pub(super) fn trace_refusal(&mut self) {
        if let Some(last) = self.trace.as_mut().and_then(|trace| trace.last_mut()) {
            last.failed = true;
        }
    }

    /// Records what the last block wrote into a table of the control.
    pub(super) fn trace_write(&mut self, variable: u32, value: f64) {
        if let Some(last) = self.trace.as_mut().and_then(|trace| trace.last_mut()) {
            last.values = Some(assigned(variable, value).into());
        }
    }

    /// Records that the last block could not be carried out, and stays as written.
    pub(super) fn trace_fault(&mut self) {
        if let Some(last) = self.trace.as_mut().and_then(|trace| trace.last_mut()) {
            last.is_flow_control = false;
        }
    }

    /// Records the words of the last block with their values; `typed`: the words before evaluation.
    #[cold]
    pub(super) fn trace_values(&mut self, block: &Block, typed: &[Word]) {
        let Some(trace) = self.trace.as_mut().filter(|_| self.contours.recorded.is_none()) else { return };
        let doubtful = if self.state.doubts.has(Doubt::Values) { typed } else { &[] };
        let values = values_of(block, doubtful).into();
        if let Some(last) = trace.last_mut() {
            last.values = Some(values);
            last.is_flow_control = !block.is_broken() && block.words.iter().any(codes::is_flow_control);
        }
    }

    /// Records that the last block was not carried out because a value is missing.
    pub(super) fn trace_nothing(&mut self) {
        if let Some(last) = self.trace.as_mut().and_then(|trace| trace.last_mut()) {
            (last.values, last.is_flow_control) = (Some(Box::default()), false);
        }
    }
}
