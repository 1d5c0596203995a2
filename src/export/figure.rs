//! The picture of a figure: a program with the letters and dimensions of a cycle, a word or the part.
//!
//! In: a subject, a finished run and its simulation. Out: options of the drawing. For the command line and the pages of
//! the manual.

use crate::figures;
use crate::machine::SimulationResult;
use crate::motion::Motions;
use crate::run::Run;
use crate::scene::svg::{Contents, Passes, SvgOptions};
use crate::source::LineIndex;

/// What a figure explains.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Subject {
    /// A cycle: the one in a line, from 1, or the first.
    Cycle {
        /// The line; `None` for the first cycle.
        line: Option<u32>,
    },
    /// The finished part.
    Part,
    /// The tool nose at the first compensated taper.
    Nose,
    /// A word.
    Word {
        /// Its line, from 1.
        line: u32,
        /// Its first column, from 1.
        column: u32,
    },
}

impl Subject {
    /// Parses `cycle`, `cycle:LINE`, `part`, `nose` or `word:LINE:COLUMN`.
    pub fn parse(text: &str) -> Result<Self, String> {
        let number = |text: &str| text.parse().ok().filter(|number| *number > 0);
        let mut parts = text.split(':');
        let figure = match (parts.next(), parts.next(), parts.next(), parts.next()) {
            (Some("cycle"), None, None, None) => Some(Self::Cycle { line: None }),
            (Some("cycle"), Some(line), None, None) => {
                number(line).map(|line| Self::Cycle { line: Some(line) })
            }
            (Some("part"), None, None, None) => Some(Self::Part),
            (Some("nose"), None, None, None) => Some(Self::Nose),
            (Some("word"), Some(line), Some(column), None) => {
                number(line).zip(number(column)).map(|(line, column)| Self::Word { line, column })
            }
            _ => None,
        };
        figure.ok_or_else(|| "expected cycle, cycle:LINE, part, nose or word:LINE:COLUMN".to_owned())
    }

    /// The options of the section with the annotations of this figure. `run`: makes the finished run.
    pub fn options(
        self,
        options: SvgOptions,
        run: impl FnOnce() -> Run,
        simulation: &SimulationResult,
        motions: &Motions,
    ) -> SvgOptions {
        match self {
            Self::Word { line, column } => {
                let mut run = run();
                let (start, end) = line_of(&run, line);
                let byte = start.saturating_add(column.saturating_sub(1)).min(end);
                let annotations = figures::of_word(&mut run, byte);
                // A dimension is true only between passes in place.
                SvgOptions { annotations, passes: Passes::InPlace, ..options }
            }
            Self::Cycle { line } => {
                let mut run = run();
                let byte = match line {
                    Some(line) => Some(line_of(&run, line).0),
                    None => figures::first_cycle(&run),
                };
                let figure = byte.map(|byte| figures::of_cycle(&mut run, byte)).unwrap_or_default();
                let shown = figure.motions(motions);
                if shown.is_empty() {
                    return options;
                }
                let mut annotations = figure.annotations;
                annotations.extend(figures::of_tool(simulation, motions, &shown));
                SvgOptions { annotations, motions: Some(shown), ..options }
            }
            Self::Nose => {
                let annotations = figures::of_nose(simulation, motions).into_iter().collect();
                SvgOptions { annotations, ..options }
            }
            Self::Part => {
                let annotations = figures::of_finished(simulation, motions);
                SvgOptions { annotations, contents: Contents::Part, ..options }
            }
        }
    }
}

/// First and last byte of a line, from 1.
fn line_of(run: &Run, line: u32) -> (u32, u32) {
    let lines = LineIndex::new(run.text());
    let span = lines.line(run.text(), line.saturating_sub(1).min(lines.len() - 1));
    (span.start, span.end)
}
