//! A completed run, and requests for help about it.

use gcode_playground::api::Places;
use gcode_playground::api::assist::{FormHelp, Reader, StateHelp, WordHelp};
use gcode_playground::assist::Query;
use gcode_playground::run::Run;
use gcode_playground::run::replay::{Found, VisitChoice};
use gcode_playground::sentences::Language;
use gcode_playground::setup::Setup;
use gcode_playground::source::{LineIndex, Span};
use gcode_playground::text::block::Block;
use gcode_playground::text::parser::Resume;

/// A completed run that answers requests for help.
pub struct Asking {
    pub run: Run,
    pub lines: LineIndex,
}

impl Asking {
    pub fn new(text: &str, setup: Setup) -> Self {
        let mut run = Run::new(text.into(), setup);
        while !run.advance(usize::MAX) {}
        let lines = LineIndex::new(run.text());
        Self { run, lines }
    }

    pub fn found(&mut self, byte: u32, time: VisitChoice) -> (Found, Block) {
        let line = self.lines.line_of(byte);
        let start = Resume::inside(self.lines.line(self.run.text(), line).start, line);
        let mut replay = self.run.replay(start, byte, time);
        while !self.run.advance_replay(&mut replay, 1000) {}
        let found = replay.found();
        let block = found.block(&self.run);
        (found, block)
    }

    pub fn with<R>(
        &mut self,
        byte: u32,
        time: VisitChoice,
        language: Language,
        say: impl FnOnce(&Query, &Reader, &Run) -> R,
    ) -> R {
        let (found, block) = self.found(byte, time);
        let run = &self.run;
        let asked = Query::new(run, &found, &block);
        let places = Places { text: run.text(), lines: &self.lines };
        say(&asked, &Reader { places, language, unit: run.state().unit }, run)
    }

    pub fn word(&mut self, byte: u32, time: VisitChoice, language: Language) -> Option<WordHelp> {
        self.with(byte, time, language, |asked, reader, run| {
            let notes: Vec<Span> = run.notes().spans().collect();
            reader.word(asked, byte, &notes, run.motions())
        })
    }

    pub fn form(&mut self, byte: u32, language: Language) -> Option<FormHelp> {
        self.with(byte, VisitChoice::Usual, language, |asked, reader, _| reader.form(asked, byte))
    }

    pub fn state(&mut self, byte: u32, time: VisitChoice, language: Language) -> StateHelp {
        self.with(byte, time, language, |asked, reader, run| reader.state(asked, run.motions()))
    }
}
