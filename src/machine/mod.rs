//! The machine: material removal, collisions, and comparison of parts.
//!
//! In: the motions and the setup. Out: a [`Simulation`], which removes the material in slices, and at the end
//! a [`SimulationResult`], with the part at any moment and the findings. Comes after the control and before
//! the picture; must not know the text of the program.

pub mod blank;
mod choice;
pub mod compare;
pub mod danger;
pub mod defaults;
pub mod detector;
mod evidence;
pub mod feature;
mod finishing;
pub mod inferred;
pub mod live_holes;
mod live_path;
mod misuse;
pub mod part;
pub mod region;
pub mod removal;
pub mod resolved_setup;
mod surface;
pub mod sweep;
mod thread_depth;
pub mod thread_point;
pub mod thread_run_out;
mod tip_place;
pub mod tool;
mod tool_use;
pub mod turned_material;
mod z_positions;

use crate::limits::Limits;
use crate::motion::{Motion, Motions};
use crate::setup::{Machine, Setup};
use danger::Finding;
use detector::DangerDetector;
use part::Part;
use region::Region;
use removal::{RemovalWatch, Unusual};
use resolved_setup::ResolvedSetup;

/// A simulated program, after all its material was removed or a limit was reached. A partly cut part is never
/// shown.
#[derive(Clone, Debug)]
pub struct SimulationResult {
    resolved: ResolvedSetup,
    part: Option<Part>,
    opposite: Option<OppositeHalf>,
    detector: DangerDetector,
    watch: RemovalWatch,
    machine: Machine,
    limits: Limits,
    limit: Option<SimulationLimit>,
    /// The first cut of an unknown tool.
    first_unknown: Option<usize>,
    /// Number of motions of the program.
    motions: usize,
}

/// The half of the section on the other side of the axis than the tool; before the first thread it mirrors that half.
#[derive(Clone, Debug)]
struct OppositeHalf {
    /// Index of the first motion that cuts turns of a thread.
    first_thread: usize,
    /// Whether this half is above the axis: the tool is at −X.
    is_above: bool,
    part: Part,
}

/// Why the removal of material ended early.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SimulationLimit {
    /// The program has more motions than this.
    Motions(usize),
    /// The part has more corners than this.
    Corners(usize),
    /// The simulation was stopped.
    Stopped {
        /// Number of motions whose material was removed.
        done: usize,
        /// Number of all motions.
        all: usize,
    },
}

/// A simulation in progress. The part and the findings are not available until it is done.
#[derive(Clone, Debug)]
pub struct Simulation {
    result: SimulationResult,
}

/// Progress of a simulation after a slice.
#[derive(Debug)]
pub enum SimulationStep {
    /// There is more material to remove.
    InProgress(Simulation),
    /// All material was removed, or a limit was reached.
    Done(SimulationResult),
}

impl Simulation {
    /// Starts the simulation of a program that has run.
    pub fn new(motions: &Motions, setup: &Setup) -> Self {
        Self::of_resolved(ResolvedSetup::new(motions, setup), motions, setup)
    }

    /// Starts the simulation with known tools and blank.
    fn of_resolved(resolved: ResolvedSetup, motions: &Motions, setup: &Setup) -> Self {
        let limits = setup.limits;
        let part = resolved.blank().map(|(blank, _)| Part::new(blank));
        let detector = DangerDetector::new(&resolved, motions, setup);
        let watch = RemovalWatch::new(&resolved, motions);
        let limit =
            (motions.len() > limits.part_motions).then_some(SimulationLimit::Motions(limits.part_motions));
        let first_unknown = resolved.unknown().iter().copied().min();
        let result = SimulationResult {
            first_unknown,
            resolved,
            part,
            opposite: None,
            detector,
            watch,
            machine: setup.machine,
            limits,
            limit,
            motions: motions.len(),
        };
        Self { result }
    }

    /// Removes the material of at most `count` motions.
    pub fn advance(mut self, motions: &Motions, count: usize) -> SimulationStep {
        if self.result.remove_material(motions, count) {
            SimulationStep::Done(self.result)
        } else {
            SimulationStep::InProgress(self)
        }
    }

    /// Ends the simulation early.
    pub fn stop(mut self) -> SimulationResult {
        let done = self.result.part.as_ref().map_or(0, Part::done);
        self.result.limit.get_or_insert(SimulationLimit::Stopped { done, all: self.result.motions });
        self.result
    }

    /// Share of the motions whose material was removed, 0 to 1.
    pub fn progress(&self) -> f64 {
        let done = self.result.part.as_ref().map_or(0, Part::done);
        if self.result.motions == 0 { 1.0 } else { done as f64 / self.result.motions as f64 }
    }

    /// Tools and blank.
    pub fn resolved_setup(&self) -> &ResolvedSetup {
        &self.result.resolved
    }
}

impl SimulationResult {
    /// Simulates a whole program.
    pub fn of(motions: &Motions, setup: &Setup) -> Self {
        Self::of_resolved(ResolvedSetup::new(motions, setup), motions, setup)
    }

    /// Simulates a whole program with the [`ResolvedSetup`] of its motions and setup.
    pub fn of_resolved(resolved: ResolvedSetup, motions: &Motions, setup: &Setup) -> Self {
        let mut simulation = Simulation::of_resolved(resolved, motions, setup);
        loop {
            match simulation.advance(motions, usize::MAX) {
                SimulationStep::InProgress(more) => simulation = more,
                SimulationStep::Done(simulation) => return simulation,
            }
        }
    }

    /// Removes the material of at most `count` motions. Returns true when all are done, or a limit is
    /// reached.
    fn remove_material(&mut self, motions: &Motions, count: usize) -> bool {
        let Some(part) = &mut self.part else { return true };
        for _ in 0..count {
            let index = part.done();
            if self.limit.is_some() {
                return true;
            }
            if index >= motions.len() {
                self.watch.finish();
                return true;
            }
            let mut motion = motions.get_on_workpiece(index).on_positive_side();
            // After a cut of an unknown tool, which removes nothing, the remaining material is unknown.
            motion.process.incomplete |= self.first_unknown.is_some_and(|first| first <= index);
            self.detector.check_motion(index, &motion, &self.resolved, part);
            let block = || motions.span(index).start;
            self.watch.check_motion(index, &motion, block, &self.resolved, part);
            let tool = self.resolved.tool(&motion);
            if self.opposite.is_none() && part::cuts_turn_by_turn(&motion, tool) {
                let is_above = motions.get_on_workpiece(index).from.x < 0.0;
                self.opposite = Some(OppositeHalf { first_thread: index, is_above, part: part.opposite() });
            }
            if let Some(opposite) = &mut self.opposite {
                opposite.part.step(&motion, tool);
            }
            part.step(&motion, tool);
            let opposite_corners = self.opposite.as_ref().map_or(0, |opposite| opposite.part.corners());
            if part.corners().max(opposite_corners) > self.limits.part_corners {
                self.limit = Some(SimulationLimit::Corners(self.limits.part_corners));
            }
        }
        let all = part.done() >= motions.len();
        if all && self.limit.is_none() {
            self.watch.finish();
        }
        self.limit.is_some() || all
    }

    /// The limit that was reached.
    pub fn limit(&self) -> Option<SimulationLimit> {
        self.limit
    }

    /// Dangers that were found; if a limit was reached, only the dangers of the motions before it.
    pub fn findings(&self) -> &[Finding] {
        &self.detector.findings
    }

    /// Unusual removals of material.
    pub fn removals(&self) -> &[Unusual] {
        &self.watch.found
    }

    /// Whether there is a chuck with jaws, and a tailstock.
    pub fn has_chuck_and_tailstock(&self) -> [bool; 2] {
        self.detector.has_chuck_and_tailstock()
    }

    /// The obstacles around the workpiece: the chuck, and the tailstock if it is forward during `motion`, or
    /// during any motion if that is `None`.
    pub fn obstacles(&self, motion: Option<&Motion>) -> impl Iterator<Item = &Region> {
        self.detector.obstacles(motion.map(|motion| motion.process.quill))
    }

    /// Tools and blank.
    pub fn resolved_setup(&self) -> &ResolvedSetup {
        &self.resolved
    }

    /// The machine.
    pub fn machine(&self) -> &Machine {
        &self.machine
    }

    /// The finished part. `None` without a blank, or if a limit was reached.
    pub fn finished(&self) -> Option<Region> {
        Some(self.shown().filter(|_| self.limit.is_none())?.finished())
    }

    /// The part after `count` motions and the fraction `share` of the next one.
    pub fn part_at(&self, motions: &Motions, count: usize, share: f64) -> Option<Region> {
        Some(self.shown().filter(|_| self.limit.is_none())?.at(motions, &self.resolved, count, share))
    }

    /// The half of the finished part on the other side of the axis than the tool, with X positive; `None` if it
    /// mirrors [`Self::finished`]. The grooves of threads are half a turn further there.
    pub fn opposite_finished(&self) -> Option<Region> {
        Some(self.shown_opposite()?.part.finished())
    }

    /// As [`Self::part_at`], for the half on the other side of the axis than the tool; `None` if it mirrors that half.
    pub fn opposite_at(&self, motions: &Motions, count: usize, share: f64) -> Option<Region> {
        let opposite = self.shown_opposite()?;
        let has_thread = count > opposite.first_thread || count == opposite.first_thread && share > 0.0;
        has_thread.then(|| opposite.part.at(motions, &self.resolved, count, share))
    }

    /// Whether the opposite half is above the axis: the tool cuts its first thread at −X.
    pub fn is_opposite_above(&self) -> bool {
        self.opposite.as_ref().is_some_and(|opposite| opposite.is_above)
    }

    /// The blank.
    pub fn blank(&self) -> Option<&Region> {
        Some(self.shown()?.blank())
    }

    /// The part, if there is one to show.
    fn shown(&self) -> Option<&Part> {
        self.part.as_ref().filter(|_| self.resolved.shows_part())
    }

    fn shown_opposite(&self) -> Option<&OppositeHalf> {
        self.opposite.as_ref().filter(|_| self.limit.is_none() && self.resolved.shows_part())
    }
}
