//! Steps through the program: to the end of the next or previous motion, block or pass.
//!
//! In: a position in the program. Out: the nearest end of a step after or before it.

use super::clock::Playhead;
use crate::motion::{Cycle, Motions};
use crate::source::Span;

/// Size of a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// One motion.
    Motion,
    /// All motions of a block.
    Block,
    /// All motions of a pass of a cycle; outside of cycles, a block.
    Pass,
}

/// Direction of a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// Forward.
    Next,
    /// Backward.
    Previous,
}

/// Identifies the motions of one step.
type Key = (Span, Option<(Cycle, u32)>);

/// The position one step away; without `from`, from the start or the end of the program.
pub fn step(motions: &Motions, from: Option<Playhead>, unit: Unit, direction: Direction) -> Playhead {
    let Some(last) = motions.len().checked_sub(1) else { return Playhead::START };
    match direction {
        Direction::Next => {
            let first = match from {
                None => 0,
                Some(at) if at.share >= 1.0 => at.motion + 1,
                Some(at) => at.motion,
            };
            if first > last {
                return Playhead::end_of(last);
            }
            let own = key(motions, first, unit);
            let end = (first + 1..=last).find(|&next| !is_same_step(own, key(motions, next, unit), unit));
            Playhead::end_of(end.unwrap_or(last + 1) - 1)
        }
        Direction::Previous => {
            // Undoes the current step, or the step that was just finished.
            let under_way = from.map_or(last, |at| at.motion.min(last));
            let own = key(motions, under_way, unit);
            let before =
                (0..under_way).rev().find(|&before| !is_same_step(own, key(motions, before, unit), unit));
            before.map_or(Playhead::START, Playhead::end_of)
        }
    }
}

fn key(motions: &Motions, motion: usize, unit: Unit) -> Key {
    let pass = match unit {
        Unit::Pass => motions.get(motion).cycle.map(|step| (step.cycle, step.pass)),
        Unit::Motion | Unit::Block => None,
    };
    (motions.span(motion), pass)
}

/// Whether a motion belongs to the same step as another.
fn is_same_step(own: Key, other: Key, unit: Unit) -> bool {
    match unit {
        Unit::Motion => false,
        Unit::Block => own.0 == other.0,
        // The blocks of a contour are motions of the same cycle.
        Unit::Pass => own.1 == other.1 && (own.1.is_some() || own.0 == other.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analyze;
    use crate::setup::Setup;

    /// The lines (from 1) and motions at the ends of steps.
    fn steps(text: &str, unit: Unit, direction: Direction) -> Vec<(u32, usize)> {
        let motions = analyze(text.as_bytes(), &Setup::default()).motions;
        let mut ends = Vec::new();
        let mut at = None;
        loop {
            let next = step(&motions, at, unit, direction);
            if at == Some(next) {
                return ends;
            }
            ends.push((motions.line(next.motion) + 1, next.motion + usize::from(next.share >= 1.0)));
            at = Some(next);
        }
    }

    // Approach, two passes of four motions each, one return motion.
    const TWO_PASSES: &str = "M3 S500\nG0 X62 Z2\nG90 X50 Z-30 F0.2\nX45\nG0 X100\nM30\n";

    #[test]
    fn steps_end_with_motions_blocks_and_passes() {
        assert_eq!(steps(TWO_PASSES, Unit::Motion, Direction::Next).len(), 10);
        assert_eq!(steps(TWO_PASSES, Unit::Block, Direction::Next), [(2, 1), (3, 5), (4, 9), (5, 10)]);
        let g72 = include_str!("../../tests/programs/s003-g71/program.nc");
        let (blocks, passes) =
            (steps(g72, Unit::Block, Direction::Next), steps(g72, Unit::Pass, Direction::Next));
        assert!(passes.len() > blocks.len(), "{passes:?} {blocks:?}");
    }

    #[test]
    fn steps_back_end_where_steps_forward_do() {
        for unit in [Unit::Motion, Unit::Block, Unit::Pass] {
            let mut there: Vec<usize> =
                steps(TWO_PASSES, unit, Direction::Next).into_iter().map(|end| end.1).collect();
            let back: Vec<usize> =
                steps(TWO_PASSES, unit, Direction::Previous).into_iter().map(|end| end.1).collect();
            there.pop();
            there.reverse();
            there.push(0);
            assert_eq!(back, there);
        }
    }
}
