//! The files of `export`.
//!
//! In: a program that was run. Out: the bytes of a file.

use clap::ValueEnum;

use super::{Program, encoded};
use crate::export::card::{self, Card};
use crate::export::{csv, dxf, stl};
use crate::machine::region::Region;
use crate::run::Run;
use crate::scene::Scene;
use crate::scene::path_index::PathIndex;
use crate::scene::svg::{Ground, SvgOptions, svg};
use crate::scene::work::Work;
use crate::sentences::{Language, labels};
use crate::setup::fields::Unit;

/// A kind of file.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum FileFormat {
    /// The drawing, as SVG.
    Svg,
    /// All motions, as a table.
    Csv,
    /// The setup sheet, as HTML that prints well.
    Card,
    /// The profile of the part, for drawing programs.
    Dxf,
    /// The part as a solid, for other programs.
    Stl,
    /// The program with every cycle expanded.
    Program,
}

impl FileFormat {
    /// How the program is run for it.
    pub(super) fn begin(self, run: Run) -> Run {
        if self == Self::Program { run.traced() } else { run }
    }
}

/// A file made from a program.
pub(super) fn file(program: &Program, format: FileFormat, language: Language) -> Result<Vec<u8>, String> {
    let analysis = &program.analysis;
    let no_part = || format!("{}: no blank is given, or nothing is left of it", program.name);
    Ok(match format {
        FileFormat::Svg => drawing(program, Ground::AsSystem, language).into_bytes(),
        FileFormat::Csv => csv::csv(&analysis.motions, &analysis.setup.machine).into_bytes(),
        FileFormat::Card => {
            let drawing = (analysis.motions.len() <= card::MOST_DRAWN)
                .then(|| drawing(program, Ground::Paper, language));
            let card = Card {
                text: &program.text,
                motions: &analysis.motions,
                setup: &analysis.setup,
                codes: analysis.codes,
                drawing: drawing.as_deref(),
            };
            card.html(language).into_bytes()
        }
        FileFormat::Dxf => part(program).and_then(|part| dxf::dxf(&part)).ok_or_else(no_part)?.into_bytes(),
        FileFormat::Stl => part(program).and_then(|part| stl::stl(&part)).ok_or_else(no_part)?,
        FileFormat::Program => {
            encoded(program, &crate::expand::write_out(&program.text, analysis)).into_owned()
        }
    })
}

/// The drawing.
pub(super) fn drawing(program: &Program, ground: Ground, language: Language) -> String {
    let motions = &program.analysis.motions;
    let path_index = PathIndex::of(motions);
    let work = Work::of(&program.analysis.simulate(), motions, None);
    let x_plus = program.analysis.setup.machine.turret.into();
    let millimetre = labels::unit(Unit::Millimetre, language);
    svg(
        &Scene::new(motions, &path_index, work.as_ref()),
        &SvgOptions { ground, x_plus, millimetre, ..SvgOptions::default() },
    )
}

fn part(program: &Program) -> Option<Region> {
    program.analysis.simulate().finished()
}
