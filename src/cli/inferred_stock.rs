//! What was inferred of a program, and therefore not checked: reported after the messages.
//!
//! In: a program that was run. Out: a line of text, or a JSON object with `note`; nothing where the setup names a stock, or
//! nothing is cut.

use std::io::{self, Write};

use serde::Serialize;

use super::{Format, Program, write_row};
use crate::api::InferredStock;
use crate::sentences::Language;

/// Writes that the stock is inferred.
pub(super) fn write(
    out: &mut dyn Write,
    program: &Program,
    language: Language,
    format: Format,
) -> io::Result<()> {
    #[derive(Serialize)]
    struct Row<'a> {
        file: &'a str,
        #[serde(flatten)]
        inferred: InferredStock,
    }
    let Some(inferred) = InferredStock::of(&program.analysis, language) else { return Ok(()) };
    match format {
        Format::Json => write_row(out, &Row { file: &program.name, inferred }),
        Format::Text => writeln!(out, "{}: {}", program.name, inferred.message),
    }
}
