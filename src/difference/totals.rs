//! Totals of a program.
//!
//! In: its motions. Out: [`Totals`].

use crate::motion::Motions;
use crate::playback::timing::Total;
use crate::playback::totals::totals;
use crate::setup::Machine;

/// Totals of a program.
#[derive(Clone, Debug, PartialEq)]
pub struct Totals {
    /// Total time.
    pub time: Total,
    /// Number of motions.
    pub motions: usize,
    /// Number of passes of cycles.
    pub passes: usize,
    /// Path length at feed, mm.
    pub cut: f64,
    /// Path length at rapid, mm.
    pub rapid: f64,
    /// Tools in the order of first use.
    pub tools: Vec<(u16, u16)>,
}

impl Totals {
    /// Adds up all motions.
    pub(super) fn of(motions: &Motions, machine: &Machine) -> Self {
        let (tools, all) = totals(motions, machine);
        let (mut passes, mut last) = (0, None);
        for step in motions.iter().map(|motion| motion.cycle) {
            let pass = step.filter(|step| step.pass > 0).map(|step| (step.cycle, step.pass));
            passes += usize::from(pass.is_some() && pass != last);
            last = pass;
        }
        let tools = tools.into_iter().map(|own| own.tool).filter(|(station, _)| *station > 0).collect();
        Self { time: all.time, motions: motions.len(), passes, cut: all.cut, rapid: all.rapid, tools }
    }
}
