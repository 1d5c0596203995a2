//! Lint for tool changes: the place where the turret turns.

use crate::control::events::EventContext;
use crate::control::words::quote;
use crate::geometry::Point;
use crate::message::{Diagnostic, said};
use crate::setup::{Blank, Stock};
use crate::text::block::Word;
use crate::units::Diameter;

/// Least distance from the workpiece at which the turret should turn, mm.
const NEAR_WORK: f64 = 20.0;

/// The state of the lint.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ToolChanges {
    /// Position of the tip on the workpiece when a code sent the tool home; the program does not contain the
    /// home position.
    sent_home_from: Option<Point>,
}

impl ToolChanges {
    /// Handles G28 or G30, in a block before the T word or in its own block.
    pub fn home(&mut self, at: &EventContext) {
        self.sent_home_from = Some(on_workpiece(at));
    }

    /// Checks a turn of the turret.
    pub fn turns(&self, word: &Word, at: &EventContext) -> Option<Diagnostic> {
        let tip = at.state.position;
        let near = |stock: &Stock| {
            tip.x.abs() < stock.diameter.radius() + NEAR_WORK && tip.z < stock.face + NEAR_WORK
        };
        // Without a move since then, the tool is still at its home position.
        let is_home = self.sent_home_from == Some(on_workpiece(at));
        let is_near = at.contour.is_none()
            && !is_home
            && at.stock().as_ref().is_some_and(near)
            && at.setup.stock.as_ref().is_some_and(|blank| is_beside(blank, on_workpiece(at)));
        let tool = || quote(at.text, word.span);
        let message =
            || said::ToolChangeNear { tool: tool(), x: Diameter::from_radius(tip.x).mm(), z: tip.z };
        is_near.then(|| Diagnostic::new(message(), word.span))
    }
}

/// Whether a tip near the extents of the blank is near the blank: in front of a shoulder it is thinner.
fn is_beside(blank: &Blank, tip: Point) -> bool {
    let radius = || blank.greatest_radius(tip.z - NEAR_WORK, f64::INFINITY);
    blank.is_bar() || radius().is_some_and(|radius| tip.x.abs() < radius + NEAR_WORK)
}

/// Position of the tip on the workpiece.
fn on_workpiece(at: &EventContext) -> Point {
    at.state.position.moved(at.state.frames.on_workpiece())
}
