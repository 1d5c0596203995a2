//! The run of an answer with the setup of its exercise.
//!
//! In: the program of an answer. Out: an [`Answer`]: motions, messages, simulation and finished part. Setup comments
//! of the program are ignored: an answer cannot bring its own blank or tools.

use crate::findings;
use crate::machine::SimulationResult;
use crate::machine::feature::{self, Thread};
use crate::machine::region::Region;
use crate::message::Diagnostic;
use crate::run::{Analysis, Run};
use crate::setup::Setup;
use crate::setup::notes::Notes;

/// A program that has run.
pub(super) struct Answer {
    /// The text, with blanks in place of its setup comments.
    pub text: Vec<u8>,
    pub analysis: Analysis,
    pub simulation: SimulationResult,
    /// The finished part; `None` if it cannot be shown.
    pub part: Option<Region>,
    pub threads: Vec<Thread>,
    /// The first error of the run: the control stops there.
    pub alarm: Option<Diagnostic>,
}

impl Answer {
    /// Runs a program, with its messages about the machine.
    pub fn run(text: &[u8], setup: &Setup) -> Self {
        let mut answer = Self::without_findings(text, setup);
        let Analysis { motions, diagnostics, setup, unit, .. } = &answer.analysis;
        let found = findings::diagnostics(&answer.simulation, motions, &setup.rules, diagnostics);
        let found: Vec<_> = found.into_iter().map(|found| found.in_unit(*unit)).collect();
        answer.analysis.diagnostics.extend(found);
        crate::message::sort_by_place(&mut answer.analysis.diagnostics);
        answer
    }

    /// Runs a program for its part alone.
    pub fn without_findings(text: &[u8], setup: &Setup) -> Self {
        let text = without_setup_comments(text);
        let mut run = Run::new(text.clone(), setup.clone()).traced();
        while !run.advance(usize::MAX) {}
        let analysis = run.into_analysis();
        let simulation = analysis.simulate();
        let threads = feature::threads(&analysis.motions, simulation.resolved_setup());
        let alarm = analysis.diagnostics.iter().find(|found| found.is_error()).cloned();
        Self { text, part: simulation.finished(), threads, alarm, analysis, simulation }
    }
}

/// The text with blanks in place of the words of setup comments; every other byte keeps its place.
fn without_setup_comments(text: &[u8]) -> Vec<u8> {
    let mut text = text.to_vec();
    for span in Notes::read(&text).spans() {
        text[span.start as usize..span.end as usize].fill(b' ');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn setup_comments_are_blanked() {
        let text = b"O1 (STOCK D=30 LENGTH=60)\n(TOOL T0101 TYPE=BORING) (first cut)\nM30\n";
        let blanked = without_setup_comments(text);
        assert_eq!(blanked.len(), text.len());
        let blanked = String::from_utf8(blanked).expect("UTF-8");
        assert!(!blanked.contains("STOCK") && !blanked.contains("TOOL") && blanked.contains("(first cut)"));
    }
}
