//! Where the tip is after tool changes: a tool that is changed near the work comes from an unknown place.
//!
//! In: the motions in order. Out: which part of each path is known. Must not depend on the blank.

use crate::geometry::SAME;
use crate::motion::Motion;

/// The known part of the path of a motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Route {
    /// All of it.
    Known,
    /// Its end: the tool was changed near the work before it.
    EndKnown,
    /// Not its end either.
    Unknown,
}

/// Which coordinates of the tip are unknown.
#[derive(Clone, Copy, Debug, Default)]
pub struct TipPlace {
    /// Station of the tool of the last motion.
    station: Option<u16>,
    /// Axes whose place is not known, X and Z: the tool was changed near the work, and they have not moved since.
    unknown: [bool; 2],
}

impl TipPlace {
    /// Takes in the next motion. `is_near`: it begins near the work, where tools are not changed.
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
