//! Runs a program of a page.
//!
//! In: a program and its setup. Out: its messages, as `gcode-playground check` reports them, and its picture.

use gcode_playground::figures;
use gcode_playground::findings;
use gcode_playground::machine::compare::{self, Comparison, Side};
use gcode_playground::machine::{Simulation, SimulationResult};
use gcode_playground::message::{Diagnostic, sort_by_place};
use gcode_playground::run::{Analysis, Run};
use gcode_playground::scene::Scene;
use gcode_playground::scene::annotation::Annotation;
use gcode_playground::scene::face::Face;
use gcode_playground::scene::path_index::PathIndex;
use gcode_playground::scene::ruler::Scale;
use gcode_playground::scene::svg::{SvgOptions, svg};
use gcode_playground::scene::work::Work;
use gcode_playground::setup::Setup;

use crate::format::page::Stop;

/// Width of a picture, CSS pixels: half of a page, or the width of a phone.
const WIDTH: f64 = 520.0;

/// Time after which the run of an example is stopped, s, as the message states it.
const STOPPED_AFTER: f64 = 10.0;

/// Blocks that were executed by then.
const STOPPED_AFTER_BLOCKS: usize = 20;

/// A difference smaller than this fraction of the part's area is marked; a larger one is visible without
/// marks.
const HARDLY_SEEN: f64 = 0.2;

/// A picture and its marks.
pub struct Picture {
    /// The picture as SVG.
    pub svg: String,
    /// What is marked in the picture.
    pub marked: Marked,
}

/// What is marked in a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Marked {
    /// Nothing.
    Nothing,
    /// The differences from the corrected part.
    Difference,
}

/// A program that was run.
pub struct Outcome {
    text: Vec<u8>,
    /// Its analysis.
    pub analysis: Analysis,
}

impl Outcome {
    /// Runs a program; `stop` stops it early.
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
        Self { text: text.as_bytes().to_vec(), analysis }
    }

    /// The messages of a rule.
    pub fn told(&self, slug: &str) -> impl Iterator<Item = &Diagnostic> {
        self.analysis.diagnostics.iter().filter(move |found| found.message.slug() == slug)
    }

    /// The half-section, or the end face if polar interpolation mills there; `None` if nothing moves. If the
    /// part hardly differs from that of `corrected`, the difference is marked. The word at the byte `word` has its
    /// dimension.
    pub fn picture(&self, corrected: Option<&Self>, word: Option<u32>) -> Option<Picture> {
        let Analysis { motions, setup, .. } = &self.analysis;
        if motions.is_empty() {
            return None;
        }
        let simulation = SimulationResult::of(motions, setup);
        let scale = Scale::of(self.analysis.unit);
        let options =
            SvgOptions { width: WIDTH, x_plus: setup.machine.turret.into(), scale, ..SvgOptions::default() };
        if let Some(face) = Face::of(motions, &simulation) {
            let work = face.work(&simulation, None);
            let options = SvgOptions { x_plus: SvgOptions::default().x_plus, ..options };
            return Some(Picture {
                svg: svg(&face.moves().scene(work.as_ref()), &options),
                marked: Marked::Nothing,
            });
        }
        let comparison = corrected.and_then(|corrected| self.small_difference(corrected));
        let marked = if comparison.is_some() { Marked::Difference } else { Marked::Nothing };
        let work = Work::of(&simulation, motions, None).map(|work| match &comparison {
            Some(comparison) => work.compared_with(comparison),
            None => work,
        });
        let path_index = PathIndex::of(motions);
        let annotations = word.map_or_else(Vec::new, |byte| self.dimension(byte));
        let options = SvgOptions { annotations, ..options };
        Some(Picture { svg: svg(&Scene::new(motions, &path_index, work.as_ref()), &options), marked })
    }

    /// The dimension of the word at a byte.
    fn dimension(&self, byte: u32) -> Vec<Annotation> {
        figures::of_word(&mut Run::finished(self.text.clone(), self.analysis.setup.clone()), byte)
    }

    /// The difference from another part of the same blank, if it is small.
    fn small_difference(&self, other: &Self) -> Option<Comparison> {
        let programs = [self, other].map(|outcome| (&outcome.analysis.motions, &outcome.analysis.setup));
        if programs[0].1.stock.is_none() || programs[0].1.stock != programs[1].1.stock {
            return None;
        }
        let [own, others] = compare::parts(programs);
        let (own, others) = own.zip(others)?;
        let comparison = Comparison::of(&own, &others);
        let area = comparison.area(Side::First) + comparison.area(Side::Second);
        (!comparison.is_empty() && area < HARDLY_SEEN * others.area()).then_some(comparison)
    }
}

/// The word of a corrected program at the place of a word of the faulty one: in the same line, with the same address.
pub fn same_word(faulty: &str, byte: u32, corrected: &str) -> Option<u32> {
    let before = faulty.get(..byte as usize)?;
    let address = faulty[byte as usize..].chars().next()?;
    let number = before.matches('\n').count();
    let mut lines = corrected.split_inclusive('\n');
    let start: usize = lines.by_ref().take(number).map(str::len).sum();
    Some((start + lines.next()?.find(address)?) as u32)
}
