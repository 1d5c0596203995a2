//! The single cycles G90 (turning), G92 (threading) and G94 (facing): four moves from and back to the start
//! point.
//!
//! In: start point A, end point E, taper R. Out: the moves. The signs alone determine the quadrant, so no
//! case table is needed (seed 000 Fig. 3-57, seeds 001 and 004). Zero-length moves are kept: the code that
//! stores motions drops them.

use super::threading::Pass;
pub use super::threading::PullOut;
use super::{Move, sign};
use crate::geometry::Point;
use crate::motion::{Cycle, MotionKind, Step};

/// Defines the single cycles, in the order of the snippets: the name of the [`Cycle`], and the work.
macro_rules! singles {
    ($($(#[$doc:meta])* $single:ident = $work:ident;)+) => {
        /// One of the single cycles.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Single { $($(#[$doc])* $single),+ }

        impl Single {
            /// All of them.
            pub const ALL: &[Self] = &[$(Self::$single),+];

            /// The cycle of the motions.
            pub fn cycle(self) -> Cycle {
                match self { $(Self::$single => Cycle::$single),+ }
            }

            /// Its work.
            pub fn work(self) -> Work {
                match self { $(Self::$single => Work::$work),+ }
            }
        }
    };
}

singles! {
    /// G90.
    Turning = Turning;
    /// G94.
    Facing = Facing;
    /// G92.
    Threading = Threading;
}

/// The work of a single cycle, for code that does not need the exact cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Work {
    /// A cut along Z.
    Turning,
    /// A thread along Z.
    Threading,
    /// A cut along X.
    Facing,
}

impl Single {
    /// The single cycle of a motion, if the motion belongs to one.
    pub fn of(cycle: Cycle) -> Option<Self> {
        Self::ALL.iter().copied().find(|single| single.cycle() == cycle)
    }

    /// Whether it cuts a thread.
    pub fn is_thread(self) -> bool {
        self.work() == Work::Threading
    }
}

/// Whether the cuts of a cycle go along X.
pub fn cuts_along_x(cycle: Cycle) -> bool {
    cycle == Cycle::RoughFacing || Single::of(cycle).is_some_and(|single| single.work() == Work::Facing)
}

fn step(kind: MotionKind, step: Step, x: f64, z: f64) -> Move {
    Move::new(kind, step, 1, Point::new(x, z))
}

/// G90: rapid to depth, cut along Z (on a taper with `taper` ≠ 0), retract at feed, rapid to the start point.
///
/// `taper`: radius at the start of the cut minus radius at its end, mm.
pub fn turning(start: Point, end: Point, taper: f64) -> [Move; 4] {
    [
        step(MotionKind::Rapid, Step::Infeed, end.x + taper, start.z),
        step(MotionKind::Feed, Step::Cut, end.x, end.z),
        step(MotionKind::Feed, Step::Retract, start.x, end.z),
        step(MotionKind::Rapid, Step::Return, start.x, start.z),
    ]
}

/// G94: rapid to depth, cut along X (on a cone face with `taper` ≠ 0), retract at feed, rapid to the start
/// point.
///
/// `taper`: Z at the start of the cut minus Z at its end, mm; not halved (seed 004).
pub fn facing(start: Point, end: Point, taper: f64) -> [Move; 4] {
    [
        step(MotionKind::Rapid, Step::Infeed, start.x, end.z + taper),
        step(MotionKind::Feed, Step::Cut, end.x, end.z),
        step(MotionKind::Feed, Step::Retract, end.x, start.z),
        step(MotionKind::Rapid, Step::Return, start.x, start.z),
    ]
}

/// G92: like G90, but the cut is synchronized with the spindle, the retract is rapid, and the thread pulls
/// out early by `pull_out`, if any. The pull-out never passes the start X, and is not longer than the thread.
pub fn threading(start: Point, end: Point, taper: f64, pull_out: Option<PullOut>) -> Vec<Move> {
    let begin = Point::new(end.x + taper, start.z);
    let pass = Pass { number: 1, begin, end, away: sign(start.x - end.x), pull_out };
    let mut moves = Vec::with_capacity(5);
    pass.push_moves(start, &mut moves);
    moves
}

/// Whether a taper makes the cut begin beyond the start point: the signs of `taper` and of `way`, the distance
/// to the end point, differ, and the taper is longer (seed 000: |R| ≤ |U/2|). False if `way` is zero.
pub fn begins_beyond_start(way: f64, taper: f64) -> bool {
    // A thousandth of a millimetre, the least increment, is accepted.
    way != 0.0 && taper != 0.0 && (way > 0.0) != (taper > 0.0) && taper.abs() > way.abs() + 0.001
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::Diameter;

    fn ends(moves: &[Move]) -> Vec<(f64, f64)> {
        moves.iter().map(|step| (Diameter::from_radius(step.to.x).mm(), step.to.z)).collect()
    }

    #[test]
    fn g92_leaves_the_work_at_45_degrees() {
        let (start, end) = (Point::new(17.5, 4.0), Point::new(14.0, -26.0));
        let pull_out = Some(PullOut { along: 2.0, out: 2.0 });
        let moves = threading(start, end, 0.0, pull_out);
        assert_eq!(ends(&moves), [(28.0, 4.0), (28.0, -24.0), (32.0, -26.0), (35.0, -26.0), (35.0, 4.0)]);
    }

    #[test]
    fn a_long_pull_out_ends_at_the_start_diameter() {
        let (start, end) = (Point::new(15.0, 4.0), Point::new(14.0, -26.0));
        let pull_out = Some(PullOut { along: 3.0, out: 3.0 });
        let moves = threading(start, end, 0.0, pull_out);
        assert_eq!(ends(&moves), [(28.0, 4.0), (28.0, -23.0), (30.0, -24.0), (30.0, -24.0), (30.0, 4.0)]);
    }

    #[test]
    fn a_pull_out_is_no_longer_than_its_thread() {
        let (start, end) = (Point::new(20.0, 0.0), Point::new(14.0, -1.0));
        let moves = threading(start, end, 0.0, Some(PullOut { along: 5.0, out: 5.0 }));
        assert_eq!(ends(&moves), [(28.0, 0.0), (28.0, 0.0), (30.0, -1.0), (40.0, -1.0), (40.0, 0.0)]);
    }

    #[test]
    fn mirrored_cycles_make_mirrored_moves() {
        let (start, end, taper) = (Point::new(30.0, 2.0), Point::new(20.0, -40.0), -3.0);
        let flip = |point: Point| Point::new(point.x, -point.z);
        for (plain, mirrored) in turning(start, end, taper).iter().zip(turning(flip(start), flip(end), taper))
        {
            assert_eq!(flip(plain.to), mirrored.to);
        }
        for (plain, mirrored) in facing(start, end, taper).iter().zip(facing(flip(start), flip(end), -taper))
        {
            assert_eq!(flip(plain.to), mirrored.to);
        }
    }

    #[test]
    fn the_taper_rule_asks_only_when_there_is_a_way() {
        assert!(begins_beyond_start(-5.0, 8.0));
        assert!(!begins_beyond_start(-5.0, 5.0));
        assert!(!begins_beyond_start(-5.0, -8.0));
        assert!(!begins_beyond_start(0.0, -30.0));
    }
}
