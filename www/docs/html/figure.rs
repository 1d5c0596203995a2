//! Draws the figures of the manual.
//!
//! In: a program and the kind of its figure: `cycle:LINE`, `part`, `word:LINE:COLUMN` or `nose`; `face`, the end face;
//! `side`, the unrolled side; `speeds`, the spindle speed over the diameter. Out: SVG, with a legend in the language of
//! the page.

use std::fs;
use std::path::Path;

use gcode_playground::export::figure::Subject;
use gcode_playground::export::file::caption;
use gcode_playground::figures;
use gcode_playground::machine::SimulationResult;
use gcode_playground::run::{Analysis, Run};
use gcode_playground::scene::face::Face;
use gcode_playground::scene::ruler::Scale;
use gcode_playground::scene::side::Side;
use gcode_playground::scene::svg::{Passes, SvgOptions, section, svg};
use gcode_playground::sentences::{Language, labels};
use gcode_playground::setup::Setup;

/// Width of a figure, CSS pixels: that of the text.
const WIDTH: f64 = 736.0;

/// Draws the figure of a program with its setup.
pub fn draw(program: &Path, setup: &str, kind: &str, language: Language) -> Result<String, String> {
    let text = fs::read(program).map_err(|error| format!("{}: {error}", program.display()))?;
    let setup = Setup::from_json(setup).map_err(|error| format!("setup: {error}"))?;
    let finished = || Run::finished(text.clone(), setup.clone());
    let Analysis { motions, setup: own, unit, .. } = &finished().into_analysis();
    let simulation = SimulationResult::of(motions, own);
    let symbol = labels::unit_of_ruler(*unit, language);
    let options = SvgOptions {
        width: WIDTH,
        x_plus: own.machine.turret.into(),
        scale: Scale { unit: *unit, symbol },
        caption: Some(caption(String::new(), language)),
        passes: Passes::Apart,
        ..SvgOptions::default()
    };
    let drawn = if kind == "speeds" {
        let (chart, annotations) = figures::of_speeds(&mut finished()).ok_or("no cutting speed is set")?;
        let options = SvgOptions { annotations, caption: None, ..options };
        (svg(&chart.moves().scene(None), &options), true)
    } else if kind == "side" {
        let side = Side::of(motions, &simulation).ok_or("nothing is milled on the side")?;
        let work = side.work(&simulation, None);
        (svg(&side.moves().scene(work.as_ref()), &options), true)
    } else if kind == "face" {
        let face = Face::of(motions, &simulation).ok_or("nothing is milled on the end face")?;
        let work = face.work(&simulation, None);
        let annotations = figures::of_face(face.moves());
        let options = SvgOptions { annotations, x_plus: SvgOptions::default().x_plus, ..options };
        (svg(&face.moves().scene(work.as_ref()), &options), true)
    } else {
        let options = Subject::parse(kind)?.options(options, finished, &simulation, motions);
        let has_annotations = !options.annotations.is_empty();
        (section(motions, Some(&simulation), &options), has_annotations)
    };
    match drawn {
        (svg, true) => Ok(svg),
        _ => Err(format!("`{kind}` of {} has no annotations", program.display())),
    }
}
