//! The inferred stock of a program, reported after the messages, because collisions were not checked.
//!
//! In: an analysed program. Out: a line of text, or a JSON object with `note`. Empty if the setup names a
//! stock, or nothing is cut.

use std::io::{self, Write};

use super::{Format, Program, write_row};
use crate::api::{InFile, InferredStock};
use crate::sentences::Language;

/// Writes a note that the stock is inferred.
pub(super) fn write(
    out: &mut dyn Write,
    program: &Program,
    language: Language,
    format: Format,
) -> io::Result<()> {
    let Some(inferred) = InferredStock::of(&program.analysis, language) else { return Ok(()) };
    match format {
        Format::Json => write_row(out, &InFile { file: &program.name, row: inferred }),
        Format::Text => writeln!(out, "{}: {}", program.name, inferred.message),
    }
}
