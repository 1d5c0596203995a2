//! Hole cycles: G83 to G85 into the face, G87 to G89 into the side.
//!
//! In: the points of one hole. Out: its moves, from the initial level and back to it or to the R point. One
//! axis moves; which one follows from the points. Must not know words or C.

use super::{Move, sign};
use crate::geometry::{Point, SAME};
use crate::motion::{MotionKind, Step};

/// Greatest offset from the axis, mm, of a drill while the spindle turns: an indexable drill is offset to
/// enlarge the hole.
pub const OFF_CENTER: f64 = 2.5;

/// How the tool leaves the bottom.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Exit {
    /// At rapid: a drill.
    Rapid,
    /// At feed: a boring tool or reamer.
    Feed,
    /// Synchronized with the reversed spindle: a tap.
    Thread,
}

/// One hole.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hole {
    /// Position of the tool at the initial level, above the hole.
    pub initial: Point,
    /// The R point, where feeding begins.
    pub r: Point,
    /// The bottom.
    pub bottom: Point,
    /// Depth of a peck, mm; `None` for a single cut.
    pub peck: Option<f64>,
    /// Distance above the last depth at which the next peck begins, mm.
    pub clearance: f64,
    /// Whether the tool dwells at the bottom.
    pub waits: bool,
    /// Position of the tool at the end: the initial level or the R point.
    pub back_to: Point,
    /// How the tool leaves the bottom.
    pub exit: Exit,
}

impl Hole {
    /// The same hole at another place.
    pub fn moved_by(self, way: Point) -> Self {
        let moved = |point: Point| point.moved(way);
        Self {
            initial: moved(self.initial),
            r: moved(self.r),
            bottom: moved(self.bottom),
            back_to: moved(self.back_to),
            ..self
        }
    }
}

/// The hole needs more moves than allowed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TooManyMoves;

/// The moves of a hole. Between pecks the drill returns to the R point to clear the chips.
pub fn drill(hole: &Hole, most: usize) -> Result<Vec<Move>, TooManyMoves> {
    let depth = (hole.bottom.x - hole.r.x) + (hole.bottom.z - hole.r.z);
    let direction = sign(depth);
    let along_x = (hole.bottom.x - hole.r.x).abs() > SAME;
    let at = |depth: f64| match along_x {
        true => Point::new(hole.r.x + direction * depth, hole.r.z),
        false => Point::new(hole.r.x, hole.r.z + direction * depth),
    };
    let full = depth.abs();
    let peck = hole.peck.filter(|&peck| peck > SAME).unwrap_or(full).min(full);
    let pecks = if peck > SAME { ((full - SAME) / peck).ceil().max(1.0) } else { 1.0 };
    if pecks * 3.0 + 4.0 > most as f64 {
        return Err(TooManyMoves);
    }
    let cut = if hole.exit == Exit::Thread { MotionKind::Thread } else { MotionKind::Feed };
    let mut moves = vec![Move::new(MotionKind::Rapid, Step::Infeed, 0, hole.r)];
    let pecks = pecks as u32;
    for number in 1..=pecks {
        let reached = f64::from(number) * peck;
        if number > 1 {
            let before = f64::from(number - 1) * peck;
            moves.push(Move::new(MotionKind::Rapid, Step::Retract, number - 1, hole.r));
            let next = at((before - hole.clearance).max(0.0));
            moves.push(Move::new(MotionKind::Rapid, Step::Infeed, number, next));
        }
        let to = if number == pecks { hole.bottom } else { at(reached) };
        moves.push(Move::new(cut, Step::Cut, number, to));
    }
    if hole.waits {
        moves.push(Move::new(MotionKind::Dwell, Step::Cut, pecks, hole.bottom));
    }
    let out = match hole.exit {
        Exit::Rapid => MotionKind::Rapid,
        Exit::Feed => MotionKind::Feed,
        Exit::Thread => MotionKind::Thread,
    };
    if hole.exit != Exit::Rapid {
        moves.push(Move::new(out, Step::Retract, pecks, hole.r));
    }
    moves.push(Move::new(MotionKind::Rapid, Step::Return, 0, hole.back_to));
    Ok(moves)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cycles::listing::listing;

    const HOLE: Hole = Hole {
        initial: Point { x: 0.0, z: 5.0 },
        r: Point { x: 0.0, z: 2.0 },
        bottom: Point { x: 0.0, z: -10.0 },
        peck: None,
        clearance: 1.0,
        waits: false,
        back_to: Point { x: 0.0, z: 5.0 },
        exit: Exit::Rapid,
    };

    fn check(hole: &Hole, expected: &str) {
        assert_eq!(listing(hole.initial, &drill(hole, 100).unwrap()), expected);
    }

    #[test]
    fn a_drill_goes_down_and_comes_back() {
        check(&Hole { back_to: HOLE.r, ..HOLE }, "#0 R(0,2)\n#1 F(0,-10)\n#0 R(0,2)");
        check(&HOLE, "#0 R(0,2)\n#1 F(0,-10)\n#0 R(0,5)");
    }

    #[test]
    fn pecks_clear_the_chips() {
        let pecks = "#0 R(0,2)\n#1 F(0,-3) R(0,2)\n#2 R(0,-2) F(0,-8) R(0,2)\n#3 R(0,-7) F(0,-10)\n#0 R(0,5)";
        check(&Hole { peck: Some(5.0), ..HOLE }, pecks);
        assert_eq!(drill(&Hole { peck: Some(1e-5), ..HOLE }, 10_000), Err(TooManyMoves));
    }

    #[test]
    fn a_tap_comes_back_in_step_and_a_boring_tool_at_feed() {
        check(&Hole { exit: Exit::Thread, ..HOLE }, "#0 R(0,2)\n#1 T(0,-10) T(0,2)\n#0 R(0,5)");
        let side = Hole {
            initial: Point { x: 30.0, z: -10.0 },
            r: Point { x: 27.0, z: -10.0 },
            bottom: Point { x: 20.0, z: -10.0 },
            back_to: Point { x: 30.0, z: -10.0 },
            exit: Exit::Feed,
            ..HOLE
        };
        check(&side, "#0 R(54,-10)\n#1 F(40,-10) F(54,-10)\n#0 R(60,-10)");
    }
}
