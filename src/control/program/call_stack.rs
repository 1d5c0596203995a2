//! The active calls and loops of a program.
//!
//! Plain values, part of [`State`](crate::control::modal::State). `interpreter/calls` carries out calls and
//! jumps.

use super::main_pass::MainPass;
use crate::text::parser::Resume;

/// Kind of a call.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CallKind {
    /// M98, or M97: a subprogram, which shares the variables of its caller.
    Subprogram,
    /// G65 or G66: a macro, with its own local variables.
    Macro,
}

/// An active call.
#[derive(Clone, Debug, PartialEq)]
pub struct Call {
    /// Kind of the call.
    pub kind: CallKind,
    /// First block of the called program.
    pub head: Resume,
    /// Where the caller continues.
    pub back: Resume,
    /// First byte of the calling block.
    pub caller: u32,
    /// Remaining number of executions, including the current one.
    pub rounds: u32,
    /// Its active loops.
    pub loops: Vec<Loop>,
}

/// An active loop: `WHILE … DO m` or `DO m` up to `END m`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Loop {
    /// m, 1 to 3.
    pub number: u32,
    /// Its first block.
    pub head: Resume,
    /// How often it runs.
    pub rounds: Rounds,
}

/// How often a loop runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rounds {
    /// While its condition is true.
    All,
    /// Once: its DO is faulty, which was reported.
    One,
}

/// A macro that every block with a move calls (G66).
#[derive(Clone, Debug, PartialEq)]
pub struct ModalCall {
    /// First block of the macro.
    pub head: Resume,
    /// Number of executions per call.
    pub rounds: u32,
    /// Its arguments, by the number of their variable.
    pub arguments: [Option<f64>; 33],
}

/// Active calls and loops: where the program returns to.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CallStack {
    /// Active calls, innermost last.
    pub calls: Vec<Call>,
    /// Active loops of the main program.
    loops: Vec<Loop>,
    /// G66.
    pub modal: Option<ModalCall>,
    /// First block of the main program.
    pub head: Resume,
    /// The current pass of the main program.
    pub main_pass: MainPass,
}

impl CallStack {
    /// The active loops of the current program.
    pub fn loops(&mut self) -> &mut Vec<Loop> {
        match self.calls.last_mut() {
            Some(call) => &mut call.loops,
            None => &mut self.loops,
        }
    }

    /// The active loops of the main program, outermost first.
    pub fn loops_of_main(&self) -> &[Loop] {
        &self.loops
    }

    /// First block of the current program.
    pub fn program_head(&self) -> Resume {
        self.calls.last().map_or(self.head, |call| call.head)
    }

    /// Number of macros among the active calls.
    pub fn macros(&self) -> usize {
        self.calls.iter().filter(|call| call.kind == CallKind::Macro).count()
    }
}
