//! Tool changes: where the turret turns.

use crate::control::events::Moment;
use crate::control::words::quote;
use crate::message::{Diagnostic, Message};
use crate::setup::Stock;
use crate::text::block::Word;

/// Nearer to the work than this, mm, no turret should turn.
const NEAR_WORK: f64 = 20.0;

/// What is remembered of tool changes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ToolChanges {
    /// A code has sent the tool home since the last motion; where home is the program does not say.
    is_home: bool,
}

impl ToolChanges {
    /// G28 or G30, in a block before the T word or in its own.
    pub fn home(&mut self) {
        self.is_home = true;
    }

    /// The words of a block are carried out.
    #[inline]
    pub fn block_ends(&mut self, moved: bool) {
        self.is_home &= !moved;
    }

    /// The turret turns.
    pub fn turns(&self, word: &Word, at: &Moment) -> Option<Diagnostic> {
        let tip = at.state.position;
        let near = |stock: &Stock| {
            2.0 * tip.x.abs() < stock.diameter + 2.0 * NEAR_WORK && tip.z < stock.face + NEAR_WORK
        };
        let is_near = at.contour.is_none() && !self.is_home && at.setup.stock.as_ref().is_some_and(near);
        let tool = || quote(at.text, word.span);
        let message = || Message::ToolChangeNear { tool: tool(), x: 2.0 * tip.x, z: tip.z };
        is_near.then(|| Diagnostic::new(message(), word.span))
    }
}
