//! The whole of a program in a few numbers.
//!
//! In: its motions. Out: [`Totals`].

use crate::motion::Motions;
use crate::playback::timing::Total;
use crate::playback::totals::totals;
use crate::setup::Machine;

/// The whole of a program.
#[derive(Clone, Debug, PartialEq)]
pub struct Totals {
    /// Its time.
    pub time: Total,
    /// Motions.
    pub motions: usize,
    /// Passes of cycles.
    pub passes: usize,
    /// Path cut at feed, mm.
    pub cut: f64,
    /// Path at rapid, mm.
    pub rapid: f64,
    /// Tools in the order of their first motion.
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
