//! What happens at the machine: the part that appears, the time it takes, and what runs into what.
//!
//! In: the motions and the setup. Out: [`Shop`], with the work at any moment and the findings. Comes after the control and
//! before the picture; must not know the text of the program.

pub mod danger;
pub mod fitting;
pub mod guess;
pub mod part;
pub mod region;
pub mod sweep;
pub mod tally;
pub mod timing;
pub mod tool;

use crate::control::setup::{Machine, Setup};
use crate::motion::Motions;
use danger::{Finding, Watch};
use fitting::Fitting;
use part::{MOST_MOTIONS, Part};
use region::Region;

/// A program at the machine.
#[derive(Clone, Debug)]
pub struct Shop {
    fitting: Fitting,
    part: Option<Part>,
    watch: Watch,
    machine: Machine,
}

impl Shop {
    /// Fits out a program that has run.
    pub fn new(motions: &Motions, setup: &Setup) -> Self {
        let fitting = Fitting::new(motions, setup);
        let part = fitting.stock().map(|(stock, _)| Part::new(&stock));
        let watch = Watch::new(&fitting, setup);
        Self { fitting, part, watch, machine: setup.machine }
    }

    /// A program with all its material off.
    pub fn done(motions: &Motions, setup: &Setup) -> Self {
        let mut shop = Self::new(motions, setup);
        shop.advance(motions, usize::MAX);
        shop
    }

    /// Takes the material of at most so many motions off; true once all are done, or more than can be.
    pub fn advance(&mut self, motions: &Motions, count: usize) -> bool {
        let Some(part) = &mut self.part else { return true };
        let end = motions.len().min(MOST_MOTIONS);
        for index in part.done()..end.min(part.done().saturating_add(count)) {
            let motion = motions.get(index);
            self.watch.look(index, &motion, &self.fitting, part);
            part.step(&motion, self.fitting.tool(&motion));
        }
        part.done() >= end
    }

    /// What runs into what, as far as motions are done.
    pub fn findings(&self) -> &[Finding] {
        &self.watch.findings
    }

    /// Tools and blank.
    pub fn fitting(&self) -> &Fitting {
        &self.fitting
    }

    /// The machine.
    pub fn machine(&self) -> &Machine {
        &self.machine
    }

    /// What is left of the blank after all motions that were done; nothing where there is no blank.
    pub fn finished(&self) -> Option<Region> {
        Some(self.part.as_ref()?.finished())
    }

    /// What is left when so many motions are done, and of the next one the fraction `share`.
    pub fn part_at(&self, motions: &Motions, count: usize, share: f64) -> Option<Region> {
        Some(self.part.as_ref()?.at(motions, &self.fitting, count, share))
    }

    /// The blank.
    pub fn blank(&self) -> Option<&Region> {
        Some(self.part.as_ref()?.blank())
    }
}
