//! The calls and loops that a program is in.
//!
//! Plain values, part of [`State`](crate::control::modal::State). What calls and jumps do
//! is in `interpreter/calls`.

use super::main_pass::MainPass;
use crate::text::parser::Resume;

/// What was called, and from where.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CallKind {
    /// M98, or M97: a subprogram, which shares the variables of its caller.
    Subprogram,
    /// G65 or G66: a macro, with local variables of its own.
    Macro,
}

/// A call under way.
#[derive(Clone, Debug, PartialEq)]
pub struct Call {
    /// What was called.
    pub kind: CallKind,
    /// The block it begins with.
    pub head: Resume,
    /// Where the caller goes on.
    pub back: Resume,
    /// First byte of the calling block.
    pub caller: u32,
    /// How often it is still to be run, this time included.
    pub rounds: u32,
    /// The loops it is in.
    pub loops: Vec<Loop>,
}

/// A loop under way: `WHILE … DO m` or `DO m` up to `END m`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Loop {
    /// m, 1 to 3.
    pub number: u32,
    /// Its first block.
    pub head: Resume,
    /// How often it is run.
    pub rounds: Rounds,
}

/// How often a loop is run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rounds {
    /// As long as its condition holds.
    All,
    /// Once: its DO is wrong, which was reported.
    One,
}

/// A macro that G66 has every block with a move call.
#[derive(Clone, Debug, PartialEq)]
pub struct ModalCall {
    /// The block it begins with.
    pub head: Resume,
    /// How often it is run each time.
    pub rounds: u32,
    /// Its arguments, by the number of their variable.
    pub arguments: [Option<f64>; 33],
}

/// Calls and loops under way: where the program goes back to.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CallStack {
    /// Calls under way, the innermost last.
    pub calls: Vec<Call>,
    /// Loops of the main program.
    loops: Vec<Loop>,
    /// G66.
    pub modal: Option<ModalCall>,
    /// First block of the main program.
    pub head: Resume,
    /// The pass of the main program under way.
    pub main_pass: MainPass,
}

impl CallStack {
    /// The loops of the program in force.
    pub fn loops(&mut self) -> &mut Vec<Loop> {
        match self.calls.last_mut() {
            Some(call) => &mut call.loops,
            None => &mut self.loops,
        }
    }

    /// The loops of the main program, the outermost first.
    pub fn loops_of_main(&self) -> &[Loop] {
        &self.loops
    }

    /// First block of the program in force.
    pub fn program_head(&self) -> Resume {
        self.calls.last().map_or(self.head, |call| call.head)
    }

    /// Macros among the calls under way.
    pub fn macros(&self) -> usize {
        self.calls.iter().filter(|call| call.kind == CallKind::Macro).count()
    }
}
