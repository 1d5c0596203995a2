//! Data that is available once all material of a run is removed.
//!
//! In: the [`SimulationResult`] of a run. Out: the part and its threads, end face and side, the comparison
//! with a part that was kept, and the workpiece at the displayed moment.

use super::per_plane::PerPlane;
use crate::geometry::Point;
use crate::machine::SimulationResult;
use crate::machine::compare::{Comparison, parts};
use crate::machine::feature::{Thread, threads};
use crate::machine::live_holes::{LiveHole, live_holes};
use crate::machine::region::Region;
use crate::motion::Motions;
use crate::parts::late;
use crate::run::Run;
use crate::scene::face::Face;
use crate::scene::side::Side;
use crate::scene::surface_moves::SurfaceMoves;
use crate::scene::work::{Moment, Work};
use crate::scene::{Place, Plane};
use crate::setup::Setup;

/// The part that others are compared with.
pub(super) enum Kept {
    /// That of a program.
    Program { motions: Motions, setup: Box<Setup> },
    /// A wanted part; nothing is compared to the left of its end, whose Z is `left`, mm.
    Wanted { part: Region, left: f64 },
}

/// A run with all its material removed.
pub(super) struct Machined {
    simulation: SimulationResult,
    part: Option<Region>,
    /// The half on the other side of the axis than the tool, if it differs.
    opposite: Option<Region>,
    threads: Vec<Thread>,
    face: Option<Face>,
    side: Option<Side>,
    comparison: Option<Comparison>,
    shown: Option<Shown>,
}

/// The workpiece at a moment; `None` for the finished part.
struct Shown {
    moment: Option<Moment>,
    works: PerPlane<Option<Work>>,
}

impl Kept {
    pub(super) fn of(run: &Run) -> Self {
        kept(run)
    }
}

impl Machined {
    pub(super) fn new(simulation: SimulationResult, motions: &Motions) -> Self {
        let (part, opposite) = (simulation.finished(), simulation.opposite_finished());
        let threads = threads(motions, simulation.resolved_setup());
        let face = Face::of(motions, &simulation);
        let side = Side::of(motions, &simulation);
        Self { simulation, part, opposite, threads, face, side, comparison: None, shown: None }
    }

    /// Compares the part with the kept one; without a kept part, ends the comparison.
    pub(super) fn compare(&mut self, run: &Run, kept: Option<&Kept>) {
        compare(self, run, kept);
    }

    /// Updates the workpiece to the moment at which the tool is at a position.
    pub(super) fn show(&mut self, motions: &Motions, place: Option<Place>) {
        let moment = place.map(|place| Moment { motion: place.motion, share: place.fraction, tip: place.at });
        if self.shown.as_ref().is_some_and(|shown| shown.moment == moment) {
            return;
        }
        show(self, motions, moment, place);
    }

    pub(super) fn simulation(&self) -> &SimulationResult {
        &self.simulation
    }

    pub(super) fn part(&self) -> Option<&Region> {
        self.part.as_ref()
    }

    /// The half of the part on a side of the axis, 1 above it and −1 below it; X is positive in both.
    pub(super) fn part_on(&self, side: f64) -> Option<&Region> {
        let is_opposite = (side > 0.0) == self.simulation.is_opposite_above();
        // A comparison shows the half on the side of the tool twice.
        self.opposite.as_ref().filter(|_| is_opposite && self.comparison.is_none()).or(self.part())
    }

    pub(super) fn threads(&self) -> &[Thread] {
        &self.threads
    }

    pub(super) fn side(&self) -> Option<&Side> {
        self.side.as_ref()
    }

    /// The moves over a surface. `None` if nothing moves over it, and for the section.
    pub(super) fn moves(&self, plane: Plane) -> Option<&SurfaceMoves> {
        match plane {
            Plane::Section => None,
            Plane::Face => self.face.as_ref().map(Face::moves),
            Plane::Side => self.side.as_ref().map(Side::moves),
        }
    }

    pub(super) fn comparison(&self) -> Option<&Comparison> {
        self.comparison.as_ref()
    }

    /// The workpiece as shown in a picture.
    pub(super) fn work(&self, plane: Plane) -> Option<&Work> {
        self.shown.as_ref()?.works[plane].as_ref()
    }

    /// The holes of live tools in the part at the displayed moment.
    pub(super) fn holes_shown(&self, motions: &Motions) -> Vec<LiveHole> {
        let Some(part) = self.part_shown(motions) else { return Vec::new() };
        let until = self.shown.as_ref().and_then(|shown| shown.moment).map(|at| (at.motion, at.share));
        live_holes(motions, self.simulation.resolved_setup(), &part, until)
    }

    /// The part at the displayed moment.
    pub(super) fn part_shown(&self, motions: &Motions) -> Option<Region> {
        match self.shown.as_ref()?.moment {
            Some(at) => self.simulation.part_at(motions, at.motion, at.share),
            None => self.part.clone(),
        }
    }
}

late! {
    fn compare(machined: &mut Machined, run: &Run, kept: Option<&Kept>) {
        machined.comparison = kept.and_then(|kept| {
            let now = run.setup_at_machine();
            let [first, second] = match kept {
                Kept::Program { motions, setup } => parts([(motions, setup), (run.motions(), &now)]),
                Kept::Wanted { part, left } => {
                    [Some(part.clone()), machined.part.as_ref().map(|own| right_of(own, *left))]
                }
            };
            Some(Comparison::of(&first?, &second?))
        });
        machined.shown = None;
    }

    fn kept(run: &Run) -> Kept {
        Kept::Program { motions: run.motions().clone(), setup: Box::new(run.setup_at_machine()) }
    }

    fn show(machined: &mut Machined, motions: &Motions, moment: Option<Moment>, place: Option<Place>) {
        let work = Work::of(&machined.simulation, motions, moment);
        let until = moment.map_or(usize::MAX, |at| at.motion);
        let milled = machined.face.as_ref().and_then(|face| face.milled(until));
        let work = work.map(|work| work.with_milled(milled)).map(|work| match &machined.comparison {
            Some(comparison) if moment.is_none() => work.compared_with(comparison),
            _ => work,
        });
        let mut works = PerPlane::default();
        works[Plane::Section] = work;
        works[Plane::Face] = machined.face.as_ref().and_then(|face| face.work(&machined.simulation, place));
        works[Plane::Side] = machined.side.as_ref().and_then(|side| side.work(&machined.simulation, place));
        machined.shown = Some(Shown { moment, works });
    }
}

/// The piece of a part to the right of a place, mm.
fn right_of(part: &Region, z: f64) -> Region {
    const FAR: f64 = 1e5;
    let corners = [(0.0, z), (FAR, z), (FAR, FAR), (0.0, FAR)];
    part.intersection(&[corners.map(|(x, z)| Point::new(x, z))])
}
