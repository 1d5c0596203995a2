//! Determines where playback pauses: at program stops, at the end of a block, before a marked line.
//!
//! In: the next motions. Out: the first pause before one of them, and its reason.

use std::ops::Range;

use super::clock::{Clock, Playhead};
use crate::motion::{Motions, Stop, StopKind};

/// Which program stops pause playback.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stops {
    /// M00 and M01.
    All,
    /// M00 only: the switch for optional stops is off.
    NotOptional,
}

/// Everything that may pause playback.
#[derive(Clone, Copy, Debug)]
pub struct PauseRules<'a> {
    /// Program stops.
    pub stops: Stops,
    /// Whether the single-block switch is on: pause at the end of each block that moves the tool.
    pub each_block: bool,
    /// Marked lines, from 0, sorted: pause before each of their blocks.
    pub lines: &'a [u32],
}

impl PauseRules<'_> {
    /// Pauses at program stops only.
    pub fn stops(stops: Stops) -> Self {
        Self { stops, each_block: false, lines: &[] }
    }
}

/// Reason of a pause.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PauseReason {
    /// M00 or M01.
    Stop,
    /// The end of a block.
    Block,
    /// A marked line is next.
    Line,
}

/// The position after `seconds` of the animation, or the first pause before it with its reason.
pub fn play(
    clock: &Clock,
    motions: &Motions,
    from: Playhead,
    seconds: f64,
    holds: PauseRules,
) -> (Playhead, Option<PauseReason>) {
    let to = clock.playhead_at(motions, clock.at(motions, from).animation_seconds + seconds.max(0.0));
    // Motions of zero time are skipped, but the position must not move back.
    let to = if to.motion < from.motion { from } else { to };
    // Resuming has already passed a pause at the current position.
    let begun = |place: Playhead| place.motion + 1 + usize::from(place.share >= 1.0);
    match first_hold(motions, begun(from)..begun(to), holds) {
        Some((place, by)) => (place, Some(by)),
        None => (to, None),
    }
}

/// The first pause before a motion of a range, which must not include the first motion.
fn first_hold(motions: &Motions, range: Range<usize>, holds: PauseRules) -> Option<(Playhead, PauseReason)> {
    let stop = stop_in(motions, range.clone(), holds.stops).map(|(motion, _)| motion);
    let until = stop.unwrap_or(range.end).min(motions.len());
    let at_stop = || stop.map(|motion| (Playhead::end_of(motion - 1), PauseReason::Stop));
    block_hold(motions, range.start..until, holds).or_else(at_stop)
}

/// The first pause at a block: its end, or a marked line that is next.
fn block_hold(motions: &Motions, range: Range<usize>, holds: PauseRules) -> Option<(Playhead, PauseReason)> {
    if !holds.each_block && holds.lines.is_empty() {
        return None;
    }
    let mut starts = range.filter(|&motion| motions.span(motion) != motions.span(motion - 1));
    starts.find_map(|motion| {
        if holds.lines.binary_search(&motions.line(motion)).is_ok() {
            return Some((Playhead { motion, share: 0.0 }, PauseReason::Line));
        }
        holds.each_block.then(|| (Playhead::end_of(motion - 1), PauseReason::Block))
    })
}

/// The program stop at a position.
pub fn stop_at(motions: &Motions, playhead: Playhead) -> Option<Stop> {
    let next = playhead.motion + 1;
    (playhead.share >= 1.0).then(|| stop_in(motions, next..next + 1, Stops::All))?.map(|(_, stop)| stop)
}

fn stop_in(motions: &Motions, range: Range<usize>, stops: Stops) -> Option<(usize, Stop)> {
    motions.stops(range).find(|(_, stop)| match (stop.kind, stops) {
        (StopKind::Always, _) | (_, Stops::All) => true,
        (StopKind::Optional, Stops::NotOptional) => false,
    })
}

/// For each line, from 0, the first line at or after it that moves the tool. Sorted, without duplicates.
pub fn lines_that_move(motions: &Motions, lines: &[u32]) -> Vec<u32> {
    let mut next = vec![u32::MAX; lines.len()];
    let mut last = u32::MAX;
    for motion in 0..motions.len() {
        let line = motions.line(motion);
        if line == last {
            continue;
        }
        last = line;
        for (wanted, next) in lines.iter().zip(&mut next) {
            if *wanted <= line {
                *next = line.min(*next);
            }
        }
    }
    next.retain(|&line| line != u32::MAX);
    crate::order::by_key(&mut next, |line| *line);
    next.dedup();
    next
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analyze;
    use crate::playback::clock::tests::run;
    use crate::setup::Setup;

    const LOOP: &str = "O1\nT0101 M3 S500\nG0 X50 Z2\n#1=0\nWHILE[#1LT2]DO1\nG90 X[40-#1] Z-5 F0.2\n#1=#1+1\nEND1\nG0 X100\nM00\nZ100\nM30\n";

    /// Reason and line (from 1) of each pause, until the end.
    fn held(text: &str, each_block: bool, lines: &[u32]) -> Vec<(PauseReason, u32)> {
        let (motions, clock) = run(text);
        let motions = &motions;
        let lines = lines_that_move(motions, lines);
        let holds = PauseRules { stops: Stops::All, each_block, lines: &lines };
        let (mut at, mut found) = (Playhead::START, Vec::new());
        for _ in 0..100_000 {
            // Time steps like animation frames.
            let (next, by) = play(&clock, motions, at, 0.05, holds);
            if let Some(by) = by {
                found.push((by, motions.line(next.motion) + 1));
            }
            if next == Playhead::end_of(motions.len() - 1) {
                return found;
            }
            at = next;
        }
        panic!("it does not end: {at:?}");
    }

    #[test]
    fn single_blocks_are_held_at_their_ends() {
        use PauseReason::{Block, Stop};
        assert_eq!(held(LOOP, true, &[]), [(Block, 3), (Block, 6), (Stop, 9)]);
        // In each iteration of a loop.
        let lines: Vec<u32> =
            held(&LOOP.replace("END1", "G0 W1\nEND1"), true, &[]).iter().map(|held| held.1).collect();
        assert_eq!(lines, [3, 6, 8, 6, 8, 10]);
    }

    #[test]
    fn a_marked_line_holds_the_tool_in_each_round() {
        let text = LOOP.replace("#1=#1+1\n", "#1=#1+1\nG0 W1\n");
        assert_eq!(
            held(&text, false, &[5]),
            [(PauseReason::Line, 6), (PauseReason::Line, 6), (PauseReason::Stop, 10)]
        );
        // A marked line takes precedence over the end of a block.
        assert_eq!(held(&text, true, &[5])[..2], [(PauseReason::Line, 6), (PauseReason::Block, 6)]);
    }

    #[test]
    fn a_line_that_moves_nothing_stands_for_the_next_that_does() {
        let motions = analyze(LOOP.as_bytes(), &Setup::default()).motions;
        // Variables and M codes do not move the tool; after the last move there is no such line.
        assert_eq!(lines_that_move(&motions, &[1, 3, 4, 11]), [2, 5]);
        assert!(lines_that_move(&motions, &[]).is_empty());
        assert_eq!(held(LOOP, false, &[3]), [(PauseReason::Line, 6), (PauseReason::Stop, 9)]);
    }

    #[test]
    fn the_tool_is_held_at_stops_and_goes_on_from_them() {
        let (motions, clock) = run("G0 X50 Z2\nM3 S500\nG1 Z-10 F0.2\nM01\nG0 Z2\nM00\nG0 X40\nM30\n");
        let codes: Vec<_> = motions
            .stops(0..usize::MAX)
            .map(|(index, stop)| (motions.len() - index, stop.kind.code()))
            .collect();
        assert_eq!(codes, [(2, "M01"), (1, "M00")]);
        let play = |from, stops| super::play(&clock, &motions, from, 1e6, PauseRules::stops(stops)).0;
        let last = motions.len() - 1;
        let first = play(Playhead::START, Stops::All);
        assert_eq!(first, Playhead::end_of(last - 2));
        assert_eq!(stop_at(&motions, first).map(|stop| stop.line), Some(3));
        let second = play(first, Stops::All);
        assert_eq!(second, Playhead::end_of(last - 1));
        assert_eq!(play(second, Stops::All), Playhead::end_of(last));
        assert_eq!(play(Playhead::START, Stops::NotOptional), second);
        // Frame-by-frame playback pauses as well.
        let mut place = Playhead::START;
        for _ in 0..10_000 {
            let next = super::play(&clock, &motions, place, 0.016, PauseRules::stops(Stops::NotOptional)).0;
            if next == second {
                return;
            }
            place = next;
        }
        panic!("not held: {place:?}");
    }

    #[test]
    fn a_stop_waits_for_the_moves_before_it() {
        // The chamfer is only known at the block after M00, but the stop comes after the block that the
        // chamfer ends.
        let (motions, _) = run("G0 X50 Z2\nM3 S500\nG1 Z-10 ,C1 F0.2\nM00\nX60\nG0 Z2\nM30\n");
        let (index, stop) = motions.stops(0..usize::MAX).next().expect("a stop");
        assert_eq!((motions.line(index - 1), motions.line(index), stop.line), (2, 4, 3));
    }

    #[test]
    fn whatever_number_is_asked_for_the_tool_is_somewhere() {
        let (motions, clock) = run("G0 X50 Z2\nG1 Z-20 F0.2\nG4 X1\nM30\n");
        for seconds in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -0.0, 1e300, 5e-324] {
            let (place, _) =
                super::play(&clock, &motions, Playhead::START, seconds, PauseRules::stops(Stops::All));
            assert!(
                (0.0..=1.0).contains(&place.share) && place.motion < motions.len(),
                "{seconds}: {place:?}"
            );
        }
    }
}
