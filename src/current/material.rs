//! The material of a run, from the blank to the part.
//!
//! In: a finished run. Out: how much of its material is removed, and [`Machined`] once all of it is.

use super::machined::Machined;
use crate::machine::resolved_setup::ResolvedSetup;
use crate::machine::{Simulation, SimulationResult, SimulationStep};
use crate::run::Run;

#[derive(Default)]
pub(super) enum Material {
    /// Nothing removed yet: the program has to finish first.
    #[default]
    Untouched,
    /// Being removed; not shown yet.
    InProgress(Box<Simulation>),
    /// All removed.
    Off(Box<Machined>),
}

impl Material {
    /// Removes the material of at most `motions` motions. Returns the result once all of it is removed; the
    /// caller makes [`Self::Off`] of it.
    pub(super) fn remove(&mut self, run: &Run, motions: usize) -> Option<SimulationResult> {
        let simulation = match std::mem::take(self) {
            Self::Untouched => Simulation::new(run.motions(), &run.setup_at_machine()),
            Self::InProgress(simulation) => *simulation,
            off @ Self::Off(_) => {
                *self = off;
                return None;
            }
        };
        match simulation.advance(run.motions(), motions) {
            SimulationStep::InProgress(simulation) => {
                *self = Self::InProgress(Box::new(simulation));
                None
            }
            SimulationStep::Done(result) => Some(result),
        }
    }

    /// Stops removing material. Returns the result, of which the caller makes [`Self::Off`]; `None` if nothing is
    /// being removed.
    pub(super) fn stop(&mut self) -> Option<SimulationResult> {
        match std::mem::take(self) {
            Self::InProgress(simulation) => Some(simulation.stop()),
            other => {
                *self = other;
                None
            }
        }
    }

    /// The fraction of the motions whose material has been removed, 0 to 1.
    pub(super) fn progress(&self) -> f64 {
        match self {
            Self::Untouched => 0.0,
            Self::InProgress(simulation) => simulation.progress(),
            Self::Off(_) => 1.0,
        }
    }

    pub(super) fn machined(&self) -> Option<&Machined> {
        match self {
            Self::Off(machined) => Some(machined),
            Self::Untouched | Self::InProgress(_) => None,
        }
    }

    pub(super) fn machined_mut(&mut self) -> Option<&mut Machined> {
        match self {
            Self::Off(machined) => Some(machined),
            Self::Untouched | Self::InProgress(_) => None,
        }
    }

    /// Tools and blank, once material is being removed.
    pub(super) fn resolved_setup(&self) -> Option<&ResolvedSetup> {
        match self {
            Self::Untouched => None,
            Self::InProgress(simulation) => Some(simulation.resolved_setup()),
            Self::Off(machined) => Some(machined.simulation().resolved_setup()),
        }
    }
}
