//! `target`: writes the blocks `setup` and `target` of an exercise from a program.
//!
//! In: an analysed program. Out: the blocks, to be put into an exercise file. They contain no block of the program.

use super::Program;
use crate::exercise::target_of;
use crate::sentences::Language;
use crate::sentences::exercise_file::describe_no_target;
use crate::setup::{Setup, as_comments};

/// The blocks of an exercise file.
pub(super) fn blocks(program: &Program) -> Result<String, String> {
    let analysis = &program.analysis;
    let simulation = analysis.simulate();
    let target = target_of(&simulation, &analysis.motions)
        .map_err(|why| format!("{}: {}", program.name, describe_no_target(why, Language::English)))?;
    let stock = simulation.resolved_setup().blank().map(|(blank, _)| blank.clone());
    let mut setup = Setup { stock, ..analysis.setup.clone() };
    if analysis.decides_decimal {
        setup.dialect.decimal = None;
    }
    let setup = as_comments::lines(&setup).join("\n");
    Ok(format!("```setup\n{setup}\n```\n\n```target\n{target}```\n"))
}
