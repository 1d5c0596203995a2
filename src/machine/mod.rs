//! What happens at the machine: the part that appears, and what runs into what.
//!
//! In: the motions and the setup. Out: [`Machining`], which takes the material off in slices and can show nothing of it, and in
//! the end the [`Shop`], with the work at any moment and the findings. Comes after the control and before the picture; must
//! not know the text of the program.

pub mod assumed;
pub mod blank;
mod choice;
pub mod compare;
pub mod danger;
pub mod feature;
pub mod fitting;
pub mod guess;
pub mod part;
pub mod region;
mod seen;
mod stations;
mod surface;
pub mod sweep;
pub mod thread_point;
pub mod tool;

use crate::limits::Limits;
use crate::motion::Motions;
use crate::setup::{Machine, Setup};
use danger::{Finding, Watch};
use fitting::Fitting;
use part::Part;
use region::Region;

/// A program at the machine, once all its material is off or a bound was met: there is no half-cut part to be shown.
#[derive(Clone, Debug)]
pub struct Shop {
    fitting: Fitting,
    part: Option<Part>,
    watch: Watch,
    machine: Machine,
    limits: Limits,
    full: Option<Full>,
    /// How many motions the program has.
    motions: usize,
}

/// A bound that ends the taking off of material.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Full {
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

/// A program whose material is being taken off. Nobody sees the work, or what runs into what, before all of it is off.
#[derive(Clone, Debug)]
pub struct Machining {
    shop: Shop,
}

/// How far the taking off of material has come.
#[derive(Debug)]
pub enum Advanced {
    /// There is more to take off.
    UnderWay(Machining),
    /// All is off, or a bound was met.
    Done(Shop),
}

impl Machining {
    /// Fits out a program that has run.
    pub fn new(motions: &Motions, setup: &Setup) -> Self {
        Self::fitted(Fitting::new(motions, setup), motions, setup)
    }

    /// The same with the tools and the blank that are already known.
    fn fitted(fitting: Fitting, motions: &Motions, setup: &Setup) -> Self {
        let limits = setup.limits;
        // With a tool that nobody knows, no part is better than a wrong one.
        let known = fitting.stock().filter(|_| fitting.unknown().is_empty());
        let part = known.map(|(stock, _)| Part::new(&stock));
        let watch = Watch::new(&fitting, setup);
        let full = (motions.len() > limits.part_motions).then_some(Full::Motions(limits.part_motions));
        let shop =
            Shop { fitting, part, watch, machine: setup.machine, limits, full, motions: motions.len() };
        Self { shop }
    }

    /// Takes the material of at most so many motions off.
    pub fn advance(mut self, motions: &Motions, count: usize) -> Advanced {
        if self.shop.take_off(motions, count) { Advanced::Done(self.shop) } else { Advanced::UnderWay(self) }
    }

    /// Takes no more material off.
    pub fn stop(mut self) -> Shop {
        let done = self.shop.part.as_ref().map_or(0, Part::done);
        self.shop.full.get_or_insert(Full::Stopped { done, all: self.shop.motions });
        self.shop
    }

    /// Share of the motions whose material is off, 0 to 1.
    pub fn progress(&self) -> f64 {
        let done = self.shop.part.as_ref().map_or(0, Part::done);
        if self.shop.motions == 0 { 1.0 } else { done as f64 / self.shop.motions as f64 }
    }

    /// Tools and blank.
    pub fn fitting(&self) -> &Fitting {
        &self.shop.fitting
    }
}

impl Shop {
    /// A program with all its material off.
    pub fn done(motions: &Motions, setup: &Setup) -> Self {
        Self::fitted(Fitting::new(motions, setup), motions, setup)
    }

    /// The same with the [`Fitting`] of these motions and this setup.
    pub fn fitted(fitting: Fitting, motions: &Motions, setup: &Setup) -> Self {
        let mut machining = Machining::fitted(fitting, motions, setup);
        loop {
            match machining.advance(motions, usize::MAX) {
                Advanced::UnderWay(more) => machining = more,
                Advanced::Done(shop) => return shop,
            }
        }
    }

    /// Takes the material of at most so many motions off; true once all are done, or a bound is met.
    fn take_off(&mut self, motions: &Motions, count: usize) -> bool {
        let Some(part) = &mut self.part else { return true };
        for _ in 0..count {
            let index = part.done();
            if self.full.is_some() || index >= motions.len() {
                return true;
            }
            let motion = motions.get(index);
            self.watch.look(index, &motion, &self.fitting, part);
            part.step(&motion, self.fitting.tool(&motion));
            if part.corners() > self.limits.part_corners {
                self.full = Some(Full::Corners(self.limits.part_corners));
            }
        }
        self.full.is_some() || part.done() >= motions.len()
    }

    /// The bound that was met.
    pub fn full(&self) -> Option<Full> {
        self.full
    }

    /// What runs into what; as far as motions are done, where a bound was met.
    pub fn findings(&self) -> &[Finding] {
        &self.watch.findings
    }

    /// What stands around the work: the chuck, the tailstock.
    pub fn obstacles(&self) -> impl Iterator<Item = &Region> {
        self.watch.obstacles()
    }

    /// Tools and blank.
    pub fn fitting(&self) -> &Fitting {
        &self.fitting
    }

    /// The machine.
    pub fn machine(&self) -> &Machine {
        &self.machine
    }

    /// What is left of the blank after all motions that were done; nothing where there is no blank, or a bound was met.
    pub fn finished(&self) -> Option<Region> {
        Some(self.part.as_ref().filter(|_| self.full.is_none())?.finished())
    }

    /// What is left when so many motions are done, and of the next one the fraction `share`.
    pub fn part_at(&self, motions: &Motions, count: usize, share: f64) -> Option<Region> {
        Some(self.part.as_ref().filter(|_| self.full.is_none())?.at(motions, &self.fitting, count, share))
    }

    /// The blank.
    pub fn blank(&self) -> Option<&Region> {
        Some(self.part.as_ref()?.blank())
    }
}
