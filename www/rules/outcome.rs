//! What a program of a page gives.
//!
//! In: a program and its setup. Out: its messages, as `gcode-playground check` reports them, and its picture.

use gcode_playground::findings;
use gcode_playground::machine::{Simulation, SimulationResult};
use gcode_playground::message::{Diagnostic, sort_by_place};
use gcode_playground::run::{Analysis, Run};
use gcode_playground::scene::face::Face;
use gcode_playground::scene::svg::{SvgOptions, section, svg};
use gcode_playground::setup::Setup;

use crate::format::page::Stop;

/// CSS pixels of a picture: one of two side by side, or as wide as a phone.
const WIDTH: f64 = 520.0;

/// Seconds after which the run of an example is stopped, as the message has them.
const STOPPED_AFTER: f64 = 10.0;

/// Blocks it has carried out by then.
const STOPPED_AFTER_BLOCKS: usize = 20;

/// A program that was run.
pub struct Outcome {
    /// What it gave.
    pub analysis: Analysis,
}

impl Outcome {
    /// Runs a program; somebody may stop it on the way.
    pub fn of(text: &str, setup: &Setup, stop: Option<Stop>) -> Self {
        let mut run = Run::new(text.as_bytes().to_vec(), setup.clone());
        if stop == Some(Stop::Run) {
            run.advance(STOPPED_AFTER_BLOCKS);
            run.stop(STOPPED_AFTER);
        }
        while !run.advance(usize::MAX) {}
        let mut analysis = run.into_analysis();
        if stop == Some(Stop::Part) {
            let simulation = Simulation::new(&analysis.motions, &analysis.setup).stop();
            let levels = &analysis.setup.rules;
            let found = findings::diagnostics(&simulation, &analysis.motions, levels, &analysis.diagnostics);
            analysis.diagnostics.extend(found);
            sort_by_place(&mut analysis.diagnostics);
        } else {
            analysis.check_at_machine();
        }
        Self { analysis }
    }

    /// The messages of a rule.
    pub fn told(&self, slug: &str) -> impl Iterator<Item = &Diagnostic> {
        self.analysis.diagnostics.iter().filter(move |found| found.message.slug() == slug)
    }

    /// The half-section, or the end face where polar interpolation mills there; nothing where nothing moves.
    pub fn picture(&self) -> Option<String> {
        let Analysis { motions, setup, .. } = &self.analysis;
        if motions.is_empty() {
            return None;
        }
        let simulation = SimulationResult::of(motions, setup);
        let options =
            SvgOptions { width: WIDTH, x_plus: setup.machine.turret.into(), ..SvgOptions::default() };
        if let Some(face) = Face::of(motions, &simulation) {
            let work = face.work(&simulation, None);
            let options = SvgOptions { x_plus: SvgOptions::default().x_plus, ..options };
            return Some(svg(&face.scene(work.as_ref()), &options));
        }
        Some(section(motions, Some(&simulation), &options))
    }
}
