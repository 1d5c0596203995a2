//! The files of `export`.
//!
//! In: an analysed program. Out: the bytes of a file; a program is in the encoding of the original.

use std::cell::OnceCell;

use clap::ValueEnum;

use super::options::LanguageName;
use super::system::print_error_line;
use super::{NAME, Program, encoded, finished};
use crate::export::file::{self, Exportable, FileFormat, file as export};
use crate::machine::SimulationResult;
use crate::motion::Motions;
use crate::run::Run;
use crate::scene::camera::XPlus;
use crate::scene::svg::SvgOptions;
use crate::sentences::Language;
use crate::setup::Setup;
use crate::setup::dialect::CodeList;
use crate::units::Unit;

/// The language of a file; an error if one is given for a format without texts.
pub(super) fn language(format: FileFormat, chosen: Option<LanguageName>) -> Result<Language, String> {
    match chosen {
        Some(_) if !format.has_texts() => {
            let name = |format: FileFormat| {
                format.to_possible_value().map_or_else(String::new, |value| value.get_name().to_owned())
            };
            let with: Vec<String> = FileFormat::value_variants()
                .iter()
                .copied()
                .filter(|format| format.has_texts())
                .map(name)
                .collect();
            Err(format!(
                "`--lang` has no effect on `export {}`: only {} contain texts in a language",
                name(format),
                with.join(" and ")
            ))
        }
        chosen => Ok(chosen.map_or(Language::English, LanguageName::language)),
    }
}

/// Exports a program in a format.
pub(super) fn file(program: &Program, format: FileFormat, language: Language) -> Result<Vec<u8>, String> {
    let ran = FinishedProgram { program, simulation: OnceCell::new() };
    export(format, &ran, language)
        .ok_or_else(|| format!("{}: no blank is given, or nothing is left of it", program.name))
}

/// The expanded program, in the encoding of its file. If it cannot be expanded, it is returned unchanged,
/// with a note on standard error.
pub(super) fn expanded(program: &Program) -> Vec<u8> {
    let expanded = crate::expand::write_out(&program.text, &program.analysis).unwrap_or_else(|| {
        let name = &program.name;
        print_error_line(format_args!("{NAME}: {name}: not expanded: plain blocks would make other motions"));
        String::from_utf8_lossy(&program.text).into_owned()
    });
    encoded(program, &expanded).into_owned()
}

/// Options for the drawing of a program.
pub(super) fn svg_options(program: &Program, language: Language) -> SvgOptions {
    file::svg_options(&FinishedProgram { program, simulation: OnceCell::new() }, language)
}

/// The chart of the speeds of a program that does not move. `adapt`: changes the options of the picture.
pub(super) fn speed_chart(program: &Program, adapt: impl FnOnce(SvgOptions) -> SvgOptions) -> Option<String> {
    file::speed_chart(&FinishedProgram { program, simulation: OnceCell::new() }, adapt)
}

/// An analysed program; the simulation is computed on first use.
struct FinishedProgram<'a> {
    program: &'a Program,
    simulation: OnceCell<SimulationResult>,
}

impl Exportable for FinishedProgram<'_> {
    fn text(&self) -> &[u8] {
        &self.program.text
    }

    fn motions(&self) -> &Motions {
        &self.program.analysis.motions
    }

    fn setup(&self) -> &Setup {
        &self.program.analysis.setup
    }

    fn codes(&self) -> CodeList {
        self.program.analysis.codes
    }

    fn simulation(&self) -> Option<&SimulationResult> {
        Some(self.simulation.get_or_init(|| self.program.analysis.simulate()))
    }

    fn expanded(&self) -> Vec<u8> {
        expanded(self.program)
    }

    fn finished_run(&self) -> Run {
        finished(self.program)
    }

    fn unit(&self) -> Unit {
        self.program.analysis.unit
    }

    fn x_plus(&self) -> XPlus {
        self.program.analysis.setup.machine.turret.into()
    }
}
