//! `compare`: the difference between the parts of two programs, as text, JSON or a picture.
//!
//! In: two analysed programs. Out: the areas that only one of the parts has, with measurements. Radial
//! measurements are reported as X, a diameter.

use std::io::{self, Write};

use super::{Format, Program, write_row};
use crate::api;
use crate::machine::compare::{Comparison, Side, parts};
use crate::machine::region::Region;
use crate::motion::Motions;
use crate::scene::Scene;
use crate::scene::camera::XPlus;
use crate::scene::path_index::PathIndex;
use crate::scene::ruler::Scale;
use crate::scene::svg::{SvgOptions, svg};
use crate::scene::work::Work;
use crate::units::Diameter;

/// The comparison of two parts.
pub(super) struct Compared<'a> {
    programs: [&'a Program; 2],
    comparison: Comparison,
    second: Region,
}

impl<'a> Compared<'a> {
    /// Compares the parts of two programs; `None` if a blank is missing.
    pub(super) fn of(programs: [&'a Program; 2]) -> Option<Self> {
        let [first, second] =
            parts(programs.map(|program| (&program.analysis.motions, &program.analysis.setup)));
        let second = second?;
        Some(Self { programs, comparison: Comparison::of(&first?, &second), second })
    }

    /// Writes the differences.
    pub(super) fn write(&self, out: &mut dyn Write, format: Format) -> io::Result<()> {
        let row = api::Comparison::new(&self.comparison);
        match format {
            Format::Json => write_row(out, &row),
            Format::Text => self.write_text(out, &row),
        }
    }

    fn write_text(&self, out: &mut dyn Write, row: &api::Comparison) -> io::Result<()> {
        if row.differences.is_empty() {
            return writeln!(out, "The parts are the same.");
        }
        for (side, name) in ["first", "second"].iter().zip(self.names()) {
            let own: Vec<_> = row.differences.iter().filter(|difference| difference.only == *side).collect();
            if own.is_empty() {
                continue;
            }
            let area: f64 = own.iter().map(|difference| difference.area).sum();
            writeln!(out, "Only in {name}: {} mm² of the half-section", short(area))?;
            for difference in own {
                let [x, z] =
                    [difference.x.map(Diameter::mm), difference.z].map(|ends| ends.map(short).join(" to "));
                let (radial, axial) = (&difference.radial, &difference.axial);
                let across = [radial.from.x, radial.to.x].map(|x| short(x.mm())).join(" to X");
                let along = [axial.from.z, axial.to.z].map(short).join(" to Z");
                writeln!(out, "  X{x}, Z{z}: {} mm²", short(difference.area))?;
                writeln!(
                    out,
                    "    radially {} mm at Z{}: X{across}",
                    short(radial.length),
                    short(radial.from.z)
                )?;
                writeln!(
                    out,
                    "    axially {} mm at X{}: Z{along}",
                    short(axial.length),
                    short(axial.from.x.mm())
                )?;
            }
        }
        Ok(())
    }

    fn names(&self) -> [String; 2] {
        let [first, second] = self.programs;
        [first.name_beside(second), second.name_beside(first)]
    }

    /// A picture of the second part, with the areas that only one of the parts has.
    pub(super) fn svg(&self) -> String {
        let analysis = &self.programs[1].analysis;
        let simulation = analysis.simulate();
        let work = Work::of(&simulation, &analysis.motions, None)
            .map(|work| work.with_part(&self.second).compared_with(&self.comparison));
        let legend = [Side::First, Side::Second]
            .into_iter()
            .zip(self.names())
            .filter(|(side, _)| self.comparison.only(*side).next().is_some())
            .map(|(side, name)| (side, format!("only in {name}")))
            .collect();
        let (none, path_index) = (Motions::default(), PathIndex::new());
        let scene = Scene::new(&none, &path_index, work.as_ref());
        let x_plus = XPlus::from(analysis.setup.machine.turret);
        let scale = Scale::of(self.programs[1].analysis.unit);
        svg(&scene, &SvgOptions { legend, x_plus, scale, ..SvgOptions::default() })
    }
}

/// Formats with at most three decimals, without trailing zeros.
fn short(value: f64) -> String {
    let text = format!("{value:.3}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".into() } else { text.into() }
}
