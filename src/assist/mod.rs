//! Help at a place of the program: the meaning of the word there, and the state of the control.
//!
//! In: the text, a place in it, a run, and the block there as executed (`run::replay`). Out: answers
//! independent of the language: roles, facts and quantities, with the positions of the blocks they refer to.
//! Pure functions: nothing here runs a program or knows a language or an editor.

pub mod complete;
pub mod explain;
pub mod fact;
pub mod form;
pub mod hover;
pub mod names;
pub mod outline;
pub mod place;
pub mod rename;
pub mod role;
pub mod signature;
pub mod snippet;
pub mod state;
pub mod uses;

use std::borrow::Cow;

use crate::control::modal::State;
use crate::run::Run;
use crate::run::replay::{Found, Visit};
use crate::setup::Setup;
use crate::setup::dialect::{CodeList, Dialect};
use crate::text::block::Block;

/// Input of all questions: a block and its execution.
#[derive(Clone, Copy)]
pub struct Query<'a> {
    /// The program.
    pub text: &'a [u8],
    /// The block.
    pub block: &'a Block,
    /// The execution of the block; `None` if it is never executed.
    pub visit: Option<&'a Visit>,
    /// Number of executions.
    pub times: u32,
    /// Whether roughing reads the block as a part of its contour, and whether finishing does.
    pub read_by: [bool; 2],
    /// The setup of the run.
    pub setup: &'a Setup,
    /// The switches of the control.
    pub dialect: &'a Dialect,
    /// The G code list that the program is read with.
    pub codes: CodeList,
}

impl<'a> Query<'a> {
    /// Creates the input from the replay of a run.
    pub fn new(run: &'a Run, found: &'a Found, block: &'a Block) -> Self {
        Self {
            text: run.text(),
            block,
            visit: found.visit.as_ref(),
            times: found.visits,
            read_by: found.read_by,
            setup: run.setup(),
            dialect: run.dialect(),
            codes: run.code_list(),
        }
    }
}

impl Query<'_> {
    /// State of the control before the block; the state at power-on if the block is never executed.
    fn before(&self) -> Cow<'_, State> {
        match self.visit {
            Some(visit) => Cow::Borrowed(&visit.before.state),
            None => Cow::Owned(State::new(self.setup, self.dialect)),
        }
    }
}
