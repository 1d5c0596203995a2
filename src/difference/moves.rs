//! Compares the motions of a block in both versions.
//!
//! In: motions, by block. Out: [`Change`]s, each with the values of both versions; none if the tool does the
//! same. The start of a motion is the end of the previous one, so it is not a separate change. Feed and
//! spindle matter for cuts only.

use super::written::Written;
use crate::geometry::Point;
use crate::motion::{Cycle, Feed, Motion, MotionKind, Motions, Process, SpindleSpeed, SpindleTurn, Step};
use crate::playback::timing;
use crate::setup::Machine;

/// Tolerance for equal positions, mm.
const SAME: f64 = 1e-5;

/// A difference in the motions of two blocks; values are of the first and second version.
#[derive(Clone, Debug, PartialEq)]
pub enum Change {
    /// Only one of them moves: number of motions, and the last motion or cut.
    Moves([Option<(usize, Box<Motion>)>; 2]),
    /// Another cycle, or none.
    Cycle([Option<Cycle>; 2]),
    /// Number of passes of a cycle.
    Passes(Cycle, [usize; 2]),
    /// Number of motions of the block.
    Motions([usize; 2]),
    /// Kind of motion, such as rapid and feed.
    Kind([Box<Motion>; 2]),
    /// End point.
    End([Box<Motion>; 2]),
    /// The radius of an arc, mm.
    Radius([f64; 2]),
    /// Path between the same end points.
    Way,
    /// The feed of a cut.
    Feed([Feed; 2]),
    /// The lead of a thread, mm.
    Lead([f64; 2]),
    /// The spindle speed.
    Speed([SpindleSpeed; 2]),
    /// Maximum spindle speed, rpm.
    Highest([Option<f64>; 2]),
    /// Direction of the spindle.
    Turn([SpindleTurn; 2]),
    /// The tool and its offset.
    Tool([(u16, u16); 2]),
    /// A dwell, s.
    Dwell([f64; 2]),
}

/// The motions of a version, grouped by block.
pub(super) struct Moves<'a> {
    motions: &'a Motions,
    /// Start of each block's motions in `order`; the last entry is the end.
    begins: Vec<u32>,
    order: Vec<u32>,
}

/// The motions of a block, in order.
pub(super) struct OfBlock<'a> {
    motions: &'a Motions,
    own: &'a [u32],
}

impl<'a> Moves<'a> {
    /// Groups the motions of a version by block.
    pub(super) fn of(motions: &'a Motions, text: &Written) -> Self {
        let count = motions.len();
        let blocks: Vec<u32> = (0..count)
            .map(|index| text.block_at(motions.span(index).start).map_or(u32::MAX, |block| block as u32))
            .collect();
        let mut begins = vec![0; text.len() + 1];
        let known = |block: &u32| (*block as usize) < text.len();
        for &block in blocks.iter().filter(|block| known(block)) {
            begins[block as usize + 1] += 1;
        }
        for block in 1..begins.len() {
            begins[block] += begins[block - 1];
        }
        let mut free = begins.clone();
        let mut order = vec![0; begins.last().map_or(0, |&all| all as usize)];
        for (index, &block) in blocks.iter().enumerate().filter(|(_, block)| known(block)) {
            order[free[block as usize] as usize] = index as u32;
            free[block as usize] += 1;
        }
        Self { motions, begins, order }
    }

    /// The motions of a block.
    pub(super) fn block(&self, block: usize) -> OfBlock<'_> {
        let own = &self.order[self.begins[block] as usize..self.begins[block + 1] as usize];
        OfBlock { motions: self.motions, own }
    }

    /// The motions of a missing block: none.
    pub(super) fn none(&self) -> OfBlock<'_> {
        OfBlock { motions: self.motions, own: &[] }
    }

    /// Known time of the motions of a block, s.
    pub(super) fn seconds(&self, block: usize, machine: &Machine) -> f64 {
        let own = self.block(block);
        own.iter().filter_map(|motion| timing::seconds(&motion, machine)).fold(0.0, |sum, own| sum + own)
    }

    /// Whether two programs make the same motions in the same order.
    pub(super) fn are_same([first, second]: [&Motions; 2]) -> bool {
        let stops = |motions: &Motions| -> Vec<_> {
            motions.stops(0..motions.len()).map(|(index, stop)| (index, stop.kind)).collect()
        };
        first.len() == second.len()
            && first.iter().zip(second.iter()).all(|(first, second)| is_same(&first, &second))
            && stops(first) == stops(second)
    }
}

impl OfBlock<'_> {
    fn len(&self) -> usize {
        self.own.len()
    }

    fn get(&self, index: usize) -> Motion {
        self.motions.get(self.own[index] as usize)
    }

    fn iter(&self) -> impl DoubleEndedIterator<Item = Motion> + '_ {
        self.own.iter().map(|&index| self.motions.get(index as usize))
    }

    /// The most significant motion of the block: the last cut, or the last motion.
    fn last(&self) -> Option<Motion> {
        let cut = |motion: &Motion| match motion.cycle {
            Some(step) => matches!(step.step, Step::Cut | Step::Contour),
            None => true,
        };
        self.iter().rev().find(cut).or_else(|| self.iter().next_back())
    }

    fn cut(&self) -> Option<Motion> {
        self.iter().find(|motion| motion.kind.cuts())
    }

    fn passes(&self) -> usize {
        let passes = self.iter().map(|motion| motion.cycle.map_or(0, |step| step.pass));
        passes.fold((0, 0), |(count, last), pass| (count + usize::from(pass > 0 && pass != last), pass)).0
    }
}

/// Differences between the motions of two blocks.
pub(super) fn changes(first: &OfBlock, second: &OfBlock) -> Vec<Change> {
    let counts = [first.len(), second.len()];
    if counts[0] == counts[1]
        && first.iter().zip(second.iter()).all(|(first, second)| is_same(&first, &second))
    {
        return Vec::new();
    }
    if counts.contains(&0) {
        let told = |own: &OfBlock| own.last().map(|motion| (own.len(), Box::new(motion)));
        return vec![Change::Moves([told(first), told(second)])];
    }
    let mut found = Vec::new();
    let cycles = [first, second].map(|own| own.get(0).cycle.map(|step| step.cycle));
    let passes = [first.passes(), second.passes()];
    match cycles {
        [Some(cycle), Some(other)] if cycle == other => {
            if passes[0] != passes[1] {
                found.push(Change::Passes(cycle, passes));
            }
        }
        [None, None] => {}
        _ => found.push(Change::Cycle(cycles)),
    }
    if counts[0] != counts[1] && found.is_empty() {
        found.push(Change::Motions(counts));
    }
    found.extend(path(first, second));
    if let Some((first, second)) = first.cut().zip(second.cut()) {
        found.extend(cut(&first, &second));
    }
    let tools = [first, second].map(|own| own.get(0).process.tool);
    if tools[0] != tools[1] {
        found.push(Change::Tool(tools));
    }
    found
}

/// Differences of the tool path.
fn path(first: &OfBlock, second: &OfBlock) -> Vec<Change> {
    let aligned = first.len() == second.len();
    let is_cycle = first.get(0).cycle.is_some() || second.get(0).cycle.is_some();
    let pair = if aligned {
        // For a cycle, the first cut that differs; for other blocks, the last motion.
        let differing = || (0..first.len()).map(|index| (first.get(index), second.get(index)));
        let ends = |(first, second): &(Motion, Motion)| !is_same_end(first, second);
        let is_cut = |(first, _): &(Motion, Motion)| first.cycle.is_some_and(|step| step.step == Step::Cut);
        let of_cycle = differing().filter(ends).find(is_cut);
        of_cycle.or_else(|| differing().rfind(ends))
    } else {
        first.last().zip(second.last()).filter(|_| !is_cycle).filter(|(a, b)| !is_same_end(a, b))
    };
    let mut found: Vec<Change> =
        pair.map(|(first, second)| Change::End([Box::new(first), Box::new(second)])).into_iter().collect();
    if !aligned {
        return found;
    }
    for (first, second) in first.iter().zip(second.iter()) {
        let own = if first.kind != second.kind {
            Some(Change::Kind([Box::new(first), Box::new(second)]))
        } else if let Some(dwells) = both(first.seconds, second.seconds) {
            Some(Change::Dwell(dwells))
        } else if let Some(leads) = both(first.lead, second.lead) {
            Some(Change::Lead(leads))
        } else if is_same_end(&first, &second) && !is_same_way(&first, &second) {
            let radius = |motion: &Motion| motion.arc().map(|arc| arc.center.distance(arc.end));
            Some(both(radius(&first), radius(&second)).map_or(Change::Way, Change::Radius))
        } else {
            None
        };
        if let Some(own) = own {
            found.push(own);
            break;
        }
    }
    found
}

/// Differences of the cutting conditions.
fn cut(first: &Motion, second: &Motion) -> Vec<Change> {
    let processes = [first.process, second.process];
    let mut found = Vec::new();
    let is_thread = first.kind == MotionKind::Thread && second.kind == MotionKind::Thread;
    if processes[0].feed != processes[1].feed && !is_thread {
        found.push(Change::Feed(processes.map(|own| own.feed)));
    }
    if processes[0].speed != processes[1].speed {
        found.push(Change::Speed(processes.map(|own| own.speed)));
    }
    let highest = processes.map(|own| own.clamp.filter(|_| holds_surface_speed(&own)));
    if highest[0] != highest[1] {
        found.push(Change::Highest(highest));
    }
    if processes[0].turn != processes[1].turn {
        found.push(Change::Turn(processes.map(|own| own.turn)));
    }
    found
}

/// Two numbers, if both exist and differ.
fn both(first: Option<f64>, second: Option<f64>) -> Option<[f64; 2]> {
    first
        .zip(second)
        .filter(|(first, second)| (first - second).abs() > SAME)
        .map(|(first, second)| [first, second])
}

fn holds_surface_speed(process: &Process) -> bool {
    matches!(process.speed, SpindleSpeed::Surface { .. })
}

fn is_same(first: &Motion, second: &Motion) -> bool {
    let ways = first.kind == second.kind && is_same_end(first, second) && is_same_way(first, second);
    let of = |motion: &Motion| (motion.lead, motion.lead_change, motion.start_angle, motion.seconds);
    let numbers = of(first) == of(second);
    let tools = first.process.tool == second.process.tool;
    let is_same_place = is_near(first.process.zero, second.process.zero)
        && is_near(first.process.tip_shift, second.process.tip_shift);
    ways && numbers && tools && is_same_place && (!first.kind.cuts() || cut(first, second).is_empty())
}

fn is_same_end(first: &Motion, second: &Motion) -> bool {
    let turns = |motion: &Motion| motion.rotary.map(|rotary| rotary.to);
    let is_same_turn = match [turns(first), turns(second)] {
        [Some(first), Some(second)] => (first - second).abs() <= SAME,
        [None, None] => true,
        [_, _] => false,
    };
    is_same_turn && is_near(first.to, second.to)
}

fn is_same_way(first: &Motion, second: &Motion) -> bool {
    let is_same_arc = match [first.center, second.center] {
        [Some(first), Some(second)] => is_near(first, second),
        [None, None] => true,
        [_, _] => false,
    };
    is_same_arc && first.virtual_move() == second.virtual_move()
}

fn is_near(first: Point, second: Point) -> bool {
    first.distance(second) <= SAME
}
