//! `rewrite`: writes plain moves as cycles. The program goes to standard output, a report to standard error.

use std::path::Path;

use super::options::Input;
use super::system::print_error_line;
use super::{Status, encoded, program, save, setup_of, status};
use crate::rewrite::rewritten;
use crate::sentences::Language;
use crate::source::LineIndex;

/// Writes the program with all suggested cycles applied.
pub(super) fn write(input: &Input, language: Language, output: Option<&Path>) -> Result<Status, String> {
    let program = program(input)?;
    let (text, taken) = rewritten(&program.text, &setup_of(&input.file, &input.with)?);
    let lines = LineIndex::new(&program.text);
    for offer in taken {
        let (first, last) = (lines.line_of(offer.span.start) + 1, lines.line_of(offer.span.end) + 1);
        print_error_line(format_args!("{}:{first}-{last}: {}", program.name, offer.title(language)));
    }
    save(output, &encoded(&program, &String::from_utf8_lossy(&text)))?;
    Ok(status(&program.analysis))
}
