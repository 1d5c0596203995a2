//! What happens at the machine: the part that appears, and what runs into what.
//!
//! In: the motions and the setup. Out: [`Simulation`], which takes the material off in slices and can show
//! nothing of it, and in the end the [`SimulationResult`], with the work at any moment and the findings.
//! Comes after the control and before the picture; must not know the text of the program.

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
mod live_way;
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

/// A program at the machine, once all its material is off or a bound was met: there is no
/// half-cut part to be shown.
#[derive(Clone, Debug)]
pub struct SimulationResult {
    resolved: ResolvedSetup,
    part: Option<Part>,
    detector: DangerDetector,
    watch: RemovalWatch,
    machine: Machine,
    limits: Limits,
    limit: Option<SimulationLimit>,
    /// The first cut of a tool that is not known.
    first_unknown: Option<usize>,
    /// How many motions the program has.
    motions: usize,
}

/// Why the removal of material ended early.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SimulationLimit {
    /// The program has more motions than this.
    Motions(usize),
    /// What is left has more corners than this.
    Corners(usize),
    /// Somebody has stopped it after so many of all motions.
    Stopped {
        /// Motions whose material is off.
        done: usize,
        /// All motions.
        all: usize,
    },
}

/// A program whose material is being taken off. Nobody sees the work, or what runs into
/// what, before all of it is off.
#[derive(Clone, Debug)]
pub struct Simulation {
    result: SimulationResult,
}

/// How far the taking off of material has come.
#[derive(Debug)]
pub enum SimulationStep {
    /// There is more to take off.
    UnderWay(Simulation),
    /// All is off, or a bound was met.
    Done(SimulationResult),
}

impl Simulation {
    /// Begins with a program that has run.
    pub fn new(motions: &Motions, setup: &Setup) -> Self {
        Self::of_resolved(ResolvedSetup::new(motions, setup), motions, setup)
    }

    /// The same with the tools and the blank that are already known.
    fn of_resolved(resolved: ResolvedSetup, motions: &Motions, setup: &Setup) -> Self {
        let limits = setup.limits;
        let part = resolved.stock().map(|(stock, _)| Part::new(&stock));
        let detector = DangerDetector::new(&resolved, motions, setup);
        let watch = RemovalWatch::new(&resolved, motions);
        let limit =
            (motions.len() > limits.part_motions).then_some(SimulationLimit::Motions(limits.part_motions));
        let first_unknown = resolved.unknown().iter().copied().min();
        let result = SimulationResult {
            first_unknown,
            resolved,
            part,
            detector,
            watch,
            machine: setup.machine,
            limits,
            limit,
            motions: motions.len(),
        };
        Self { result }
    }

    /// Takes the material of at most so many motions off.
    pub fn advance(mut self, motions: &Motions, count: usize) -> SimulationStep {
        if self.result.remove_material(motions, count) {
            SimulationStep::Done(self.result)
        } else {
            SimulationStep::UnderWay(self)
        }
    }

    /// Takes no more material off.
    pub fn stop(mut self) -> SimulationResult {
        let done = self.result.part.as_ref().map_or(0, Part::done);
        self.result.limit.get_or_insert(SimulationLimit::Stopped { done, all: self.result.motions });
        self.result
    }

    /// Share of the motions whose material is off, 0 to 1.
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
    /// A program with all its material off.
    pub fn of(motions: &Motions, setup: &Setup) -> Self {
        Self::of_resolved(ResolvedSetup::new(motions, setup), motions, setup)
    }

    /// The same with the [`ResolvedSetup`] of these motions and this setup.
    pub fn of_resolved(resolved: ResolvedSetup, motions: &Motions, setup: &Setup) -> Self {
        let mut simulation = Simulation::of_resolved(resolved, motions, setup);
        loop {
            match simulation.advance(motions, usize::MAX) {
                SimulationStep::UnderWay(more) => simulation = more,
                SimulationStep::Done(simulation) => return simulation,
            }
        }
    }

    /// Takes the material of at most so many motions off; true once all are done, or a bound is met.
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
            // After a cut that takes nothing off it is not known what is in the way.
            motion.process.incomplete |= self.first_unknown.is_some_and(|first| first <= index);
            self.detector.check_motion(index, &motion, &self.resolved, part);
            let block = || motions.span(index).start;
            self.watch.check_motion(index, &motion, block, &self.resolved, part);
            part.step(&motion, self.resolved.tool(&motion));
            if part.corners() > self.limits.part_corners {
                self.limit = Some(SimulationLimit::Corners(self.limits.part_corners));
            }
        }
        let all = part.done() >= motions.len();
        if all && self.limit.is_none() {
            self.watch.finish();
        }
        self.limit.is_some() || all
    }

    /// The bound that was met.
    pub fn limit(&self) -> Option<SimulationLimit> {
        self.limit
    }

    /// What runs into what; as far as motions are done, where a bound was met.
    pub fn findings(&self) -> &[Finding] {
        &self.detector.findings
    }

    /// What is unusual about what is taken off.
    pub fn removals(&self) -> &[Unusual] {
        &self.watch.found
    }

    /// Whether there is a chuck with jaws, and a tailstock.
    pub fn has_chuck_and_tailstock(&self) -> [bool; 2] {
        self.detector.has_chuck_and_tailstock()
    }

    /// What stands around the work: the chuck, and the tailstock where it is forward: in this motion, or in
    /// any.
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

    /// What is left of the blank after all motions that were done; nothing where there is no
    /// blank, or a bound was met.
    pub fn finished(&self) -> Option<Region> {
        Some(self.shown().filter(|_| self.limit.is_none())?.finished())
    }

    /// What is left when so many motions are done, and of the next one the fraction `share`.
    pub fn part_at(&self, motions: &Motions, count: usize, share: f64) -> Option<Region> {
        Some(self.shown().filter(|_| self.limit.is_none())?.at(motions, &self.resolved, count, share))
    }

    /// The blank.
    pub fn blank(&self) -> Option<&Region> {
        Some(self.shown()?.blank())
    }

    /// The work, where there is a part to show.
    fn shown(&self) -> Option<&Part> {
        self.part.as_ref().filter(|_| self.resolved.shows_part())
    }
}
