//! The position of the tip after tool changes: after a change near the workpiece it is unknown.
//!
//! In: the motions in order. Out: which part of each path is known. Must not depend on the blank.

use crate::geometry::SAME;
use crate::motion::Motion;

/// The known part of the path of a motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Route {
    /// The whole path.
    Known,
    /// The end: the tool was changed near the workpiece before this motion.
    EndKnown,
    /// Nothing, not even the end.
    Unknown,
}

/// The unknown coordinates of the tip.
#[derive(Clone, Copy, Debug, Default)]
pub struct TipPlace {
    /// Station of the tool of the last motion.
    station: Option<u16>,
    /// Axes whose position is unknown, X and Z: the tool was changed near the workpiece, and the axis has not
    /// moved since.
    unknown: [bool; 2],
}

impl TipPlace {
    /// Adds the next motion. `is_near` tells whether it begins near the workpiece, where tools are not
    /// changed.
    pub fn follow(&mut self, motion: &Motion, is_near: bool) -> Route {
        let station = motion.process.tool.0;
        if self.station.replace(station).is_some_and(|last| last != station) && is_near {
            self.unknown = [true; 2];
        }
        let comes_from_elsewhere = self.unknown != [false; 2];
        self.unknown[0] &= (motion.to.x - motion.from.x).abs() <= SAME;
        self.unknown[1] &= (motion.to.z - motion.from.z).abs() <= SAME;
        match (comes_from_elsewhere, self.unknown) {
            (false, _) => Route::Known,
            (true, [false, false]) => Route::EndKnown,
            (true, _) => Route::Unknown,
        }
    }
}
