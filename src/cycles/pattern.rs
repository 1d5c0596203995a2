//! Pattern repeating, G73: the whole contour several times, each time closer to its final position.
//!
//! In: the contour of blocks ns to nf, the relief of the first pass and the number of passes. Out: the moves.
//! Pass j of d is the contour moved by `allowance + relief · (d − j) / (d − 1)` (GSK980TDi p. 136), including
//! its arcs, so it may have any shape. Must not know words.

use super::{Contour, Move};
use crate::geometry::Point;
use crate::motion::{MotionKind, Step};

/// Number of steps into which the relief is divided.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Intervals {
    /// One less than the passes: the first pass is the whole relief away, the last none of it.
    OneFewer,
    /// The number of passes: the first pass is one step closer already (text of seed 003).
    Same,
}

/// The parameters of the two blocks of G73, without the contour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pattern {
    /// Δi and Δk: from the last pass to the first, signed; `x` a radius, mm.
    pub relief: Point,
    /// d: number of passes.
    pub passes: u32,
    /// Δu and Δw: the finishing allowance, signed; `x` a radius, mm.
    pub allowance: Point,
    /// Number of steps into which the relief is divided.
    pub intervals: Intervals,
}

/// Why there are no moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PatternError {
    /// There is no pass (PS0321).
    NoPasses,
    /// More moves than allowed.
    TooManyMoves,
}

impl Pattern {
    /// Displacement of the contour in a pass (from 1): `x` a radius, mm.
    ///
    /// A single pass is the last one and has no relief. No manual states this; it follows from the formula.
    pub fn shift(&self, pass: u32) -> Point {
        let left = f64::from(self.passes.saturating_sub(pass));
        let steps = match self.intervals {
            Intervals::OneFewer => f64::from(self.passes) - 1.0,
            Intervals::Same => f64::from(self.passes),
        };
        let part = if left > 0.0 { left / steps } else { 0.0 };
        Point::new(self.allowance.x + part * self.relief.x, self.allowance.z + part * self.relief.z)
    }
}

/// G73: for each pass a rapid to the displaced start point, the move of ns, the contour at feed; at last a
/// rapid to the start point.
pub fn pattern(contour: &Contour, pattern: &Pattern, most_moves: usize) -> Result<Vec<Move>, PatternError> {
    if pattern.passes == 0 {
        return Err(PatternError::NoPasses);
    }
    let moves = u64::from(pattern.passes) * (contour.pieces.len() as u64 + 2) + 1;
    if moves > most_moves as u64 {
        return Err(PatternError::TooManyMoves);
    }
    let mut out = Vec::with_capacity(moves as usize);
    for pass in 1..=pattern.passes {
        let shift = pattern.shift(pass);
        let moved = |point: Point| Point::new(point.x + shift.x, point.z + shift.z);
        out.push(Move::new(MotionKind::Rapid, Step::Approach, pass, moved(contour.start)));
        out.push(Move::new(contour.approach.kind(), Step::Infeed, pass, moved(contour.first)));
        out.extend(
            contour
                .pieces
                .iter()
                .map(|piece| Move::along(&piece.shifted(shift.x, shift.z), Step::Contour, pass)),
        );
    }
    out.push(Move::new(MotionKind::Rapid, Step::Return, 0, contour.start));
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cycles::listing::{at, check};
    use crate::cycles::{Approach, Piece};
    use crate::geometry::Turn;

    fn line(from: Point, to: Point) -> Piece {
        Piece { from, to, arc: None }
    }

    /// Blocks N050 to N100 of seed 003, example 3.
    fn contour() -> Contour {
        Contour {
            start: at(50.0, 10.0),
            first: at(0.0, 1.0),
            approach: Approach::Feed,
            pieces: vec![
                Piece {
                    from: at(0.0, 1.0),
                    to: at(12.0, -5.0),
                    arc: Some((at(0.0, -5.0), Turn::Counterclockwise)),
                },
                line(at(12.0, -5.0), at(12.0, -15.0)),
                line(at(12.0, -15.0), at(20.0, -30.0)),
                line(at(20.0, -30.0), at(20.0, -43.0)),
                Piece {
                    from: at(20.0, -43.0),
                    to: at(34.0, -50.0),
                    arc: Some((at(34.0, -43.0), Turn::Clockwise)),
                },
            ],
        }
    }

    const EXAMPLE: Pattern = Pattern {
        relief: Point { x: 18.0, z: 5.0 },
        passes: 10,
        allowance: Point { x: 0.25, z: 0.5 },
        intervals: Intervals::OneFewer,
    };

    #[test]
    fn seed_003_example_3() {
        let moves = pattern(&contour(), &EXAMPLE, 1000).unwrap();
        check(
            contour().start,
            &moves,
            "
            #1 R(86.5,15.5) F(36.5,6.5) A+(48.5,0.5) c(36.5,0.5) r6 F(48.5,-9.5) F(56.5,-24.5) F(56.5,-37.5) A-(70.5,-44.5) c(70.5,-37.5) r7
            #2 R(82.5,14.9444) F(32.5,5.9444) A+(44.5,-0.0556) c(32.5,-0.0556) r6 F(44.5,-10.0556) F(52.5,-25.0556) F(52.5,-38.0556) A-(66.5,-45.0556) c(66.5,-38.0556) r7
            #3 R(78.5,14.3889) F(28.5,5.3889) A+(40.5,-0.6111) c(28.5,-0.6111) r6 F(40.5,-10.6111) F(48.5,-25.6111) F(48.5,-38.6111) A-(62.5,-45.6111) c(62.5,-38.6111) r7
            #4 R(74.5,13.8333) F(24.5,4.8333) A+(36.5,-1.1667) c(24.5,-1.1667) r6 F(36.5,-11.1667) F(44.5,-26.1667) F(44.5,-39.1667) A-(58.5,-46.1667) c(58.5,-39.1667) r7
            #5 R(70.5,13.2778) F(20.5,4.2778) A+(32.5,-1.7222) c(20.5,-1.7222) r6 F(32.5,-11.7222) F(40.5,-26.7222) F(40.5,-39.7222) A-(54.5,-46.7222) c(54.5,-39.7222) r7
            #6 R(66.5,12.7222) F(16.5,3.7222) A+(28.5,-2.2778) c(16.5,-2.2778) r6 F(28.5,-12.2778) F(36.5,-27.2778) F(36.5,-40.2778) A-(50.5,-47.2778) c(50.5,-40.2778) r7
            #7 R(62.5,12.1667) F(12.5,3.1667) A+(24.5,-2.8333) c(12.5,-2.8333) r6 F(24.5,-12.8333) F(32.5,-27.8333) F(32.5,-40.8333) A-(46.5,-47.8333) c(46.5,-40.8333) r7
            #8 R(58.5,11.6111) F(8.5,2.6111) A+(20.5,-3.3889) c(8.5,-3.3889) r6 F(20.5,-13.3889) F(28.5,-28.3889) F(28.5,-41.3889) A-(42.5,-48.3889) c(42.5,-41.3889) r7
            #9 R(54.5,11.0556) F(4.5,2.0556) A+(16.5,-3.9444) c(4.5,-3.9444) r6 F(16.5,-13.9444) F(24.5,-28.9444) F(24.5,-41.9444) A-(38.5,-48.9444) c(38.5,-41.9444) r7
            #10 R(50.5,10.5) F(0.5,1.5) A+(12.5,-4.5) c(0.5,-4.5) r6 F(12.5,-14.5) F(20.5,-29.5) F(20.5,-42.5) A-(34.5,-49.5) c(34.5,-42.5) r7
            #0 R(50,10)
            ",
        );
    }

    #[test]
    fn a_rapid_ns_makes_a_rapid_infeed() {
        let contour = Contour { approach: Approach::Rapid, ..contour() };
        let moves = pattern(&contour, &Pattern { passes: 1, ..EXAMPLE }, 1000).unwrap();
        assert_eq!((moves[1].kind, moves[1].step), (MotionKind::Rapid, Step::Infeed));
        assert_eq!((moves[2].kind, moves[2].step), (MotionKind::ArcCounterclockwise, Step::Contour));
    }

    #[test]
    fn a_single_pass_leaves_only_the_allowance() {
        for intervals in [Intervals::OneFewer, Intervals::Same] {
            let single = Pattern { passes: 1, intervals, ..EXAMPLE };
            assert_eq!(single.shift(1), single.allowance);
        }
    }

    #[test]
    fn as_many_intervals_as_passes_begin_one_step_nearer() {
        let same = Pattern { intervals: Intervals::Same, ..EXAMPLE };
        assert!(same.shift(1).is_same(Point::new(0.25 + 18.0 * 0.9, 0.5 + 5.0 * 0.9)));
        assert_eq!(same.shift(10), same.allowance);
    }

    #[test]
    fn a_mirrored_bore_makes_mirrored_moves() {
        // Reflected in X about the start point, and in Z: with both reflections arcs keep their direction.
        let flip = |point: Point| Point::new(50.0 - point.x, -point.z);
        let outside = contour();
        let inside = Contour {
            start: flip(outside.start),
            first: flip(outside.first),
            approach: outside.approach,
            pieces: outside
                .pieces
                .iter()
                .map(|piece| Piece {
                    from: flip(piece.from),
                    to: flip(piece.to),
                    arc: piece.arc.map(|(center, turn)| (flip(center), turn)),
                })
                .collect(),
        };
        let negative = |point: Point| Point::new(-point.x, -point.z);
        let mirrored =
            Pattern { relief: negative(EXAMPLE.relief), allowance: negative(EXAMPLE.allowance), ..EXAMPLE };
        let plain = pattern(&outside, &EXAMPLE, 1000).unwrap();
        let other = pattern(&inside, &mirrored, 1000).unwrap();
        assert_eq!(plain.len(), other.len());
        for (plain, other) in plain.iter().zip(&other) {
            assert!(flip(plain.to).is_same(other.to));
            assert_eq!((plain.kind, plain.step, plain.pass), (other.kind, other.step, other.pass));
            assert_eq!(plain.center.is_some(), other.center.is_some());
        }
    }

    #[test]
    fn faults_answer_at_once() {
        let with = |passes| pattern(&contour(), &Pattern { passes, ..EXAMPLE }, 4_000_000);
        assert_eq!(with(0), Err(PatternError::NoPasses));
        assert_eq!(with(u32::MAX), Err(PatternError::TooManyMoves));
        assert_eq!(pattern(&contour(), &EXAMPLE, 71).map(|moves| moves.len()), Ok(71));
        assert_eq!(pattern(&contour(), &EXAMPLE, 70), Err(PatternError::TooManyMoves));
    }
}
