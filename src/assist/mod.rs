//! Help at a place of the program: what the word there is, and what the control knows there.
//!
//! In: the text, a place in it, a run and the block there as it was carried out (`run::replay`). Out: answers that any
//! language can be made of: roles, facts and quantities, with the places of the blocks they name. Pure functions:
//! nothing here runs a program, and nothing knows a language or an editor.

pub mod complete;
pub mod explain;
pub mod fact;
pub mod form;
pub mod hover;
pub mod names;
pub mod outline;
pub mod place;
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

/// What an answer is made from: a block, and how it was carried out.
#[derive(Clone, Copy)]
pub struct Asked<'a> {
    /// The program.
    pub text: &'a [u8],
    /// The block.
    pub block: &'a Block,
    /// The block once carried out; `None` where it never is.
    pub visit: Option<&'a Visit>,
    /// How often it is carried out.
    pub times: u32,
    /// The setup of the run.
    pub setup: &'a Setup,
    /// The switches of the control.
    pub dialect: &'a Dialect,
    /// The G codes the program is read with.
    pub codes: CodeList,
}

impl<'a> Asked<'a> {
    /// What a replay of a run has found of a block.
    pub fn new(run: &'a Run, found: &'a Found, block: &'a Block) -> Self {
        Self {
            text: run.text(),
            block,
            visit: found.visit.as_ref(),
            times: found.times,
            setup: run.setup(),
            dialect: run.dialect(),
            codes: run.code_list(),
        }
    }
}

impl Asked<'_> {
    /// The control before the block; where that is never carried out, as it is at power-on.
    fn before(&self) -> Cow<'_, State> {
        match self.visit {
            Some(visit) => Cow::Borrowed(&visit.before.state),
            None => Cow::Owned(State::new(self.setup, self.dialect)),
        }
    }
}
