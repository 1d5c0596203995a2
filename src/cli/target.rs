//! `target`: writes the blocks `setup` and `target` of an exercise from a program.
//!
//! In: an analysed program. Out: the blocks, to be put into an exercise file.

use super::Program;
use crate::exercise::blocks_of_exercise;
use crate::sentences::Language;
use crate::sentences::exercise_file::describe_no_target;

/// The blocks of an exercise file.
pub(super) fn blocks(program: &Program) -> Result<String, String> {
    let analysis = &program.analysis;
    let simulation = analysis.simulate();
    blocks_of_exercise(&simulation, &analysis.motions, &analysis.setup, analysis.decides_decimal)
        .map_err(|why| format!("{}: {}", program.name, describe_no_target(why, Language::English)))
}
