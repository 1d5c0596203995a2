//! Replays a run up to a block, to find the state of the control there.
//!
//! In: a run, a place in its text. Out: the state before and after the block at that place, for one of its
//! executions. The replay starts at the last snapshot before the place, or at the start of the program if
//! there is none (after a jump, a call, a loop or a contour), and advances in slices.

use std::ops::Range;
use std::sync::Arc;

use super::repeated::FaultyBlocks;
use super::tried::set_tried_value;
use super::{Checkpoint, Run, RunId};
use crate::control::contour::ContourUse;
use crate::control::interpreter::Interpreter;
use crate::control::modal::State;
use crate::control::origins::{OriginRecord, Origins};
use crate::control::program::Labels;
use crate::control::second_axis;
use crate::text::block::Block;
use crate::text::parser::{Parser, Resume};
use crate::units::Unit;

/// The state of the control between two blocks.
#[derive(Clone, Debug)]
pub struct Moment {
    /// Its modal state.
    pub state: State,
    /// The block that set each value.
    pub origins: Origins,
}

/// A visit to a block: it is executed, or read as a part of a contour.
#[derive(Clone, Debug)]
pub struct Visit {
    /// The number of the visit, from 1.
    pub number: u32,
    /// The purpose, if a cycle reads the block as a part of its contour.
    pub purpose: Option<ContourUse>,
    /// The number of the execution, from 1; 0 if the block is only read.
    pub carried_out: u32,
    /// The state before the block.
    pub before: Moment,
    /// The state after the block.
    pub after: Moment,
    /// The words of the block with values in place of expressions, if it has any and is executed.
    pub values: Option<String>,
    /// The motions made during the visit. Motions of a corner or of compensation may be made by a later
    /// block.
    pub motions: Range<usize>,
}

/// The result of a replay.
#[derive(Clone, Debug)]
pub struct Found {
    /// The start of the block, and the start of the next one.
    pub place: Range<Resume>,
    /// The number of visits; 0 if the block is never executed or read.
    pub visits: u32,
    /// The requested visit.
    pub visit: Option<Visit>,
    /// Whether roughing reads the block as a part of its contour, and whether finishing does.
    pub read_by: [bool; 2],
}

impl Found {
    /// The block as it is executed.
    pub fn block(&self, run: &Run) -> Block {
        let (_, block) = block_at(run.text(), self.place.start, self.place.start.byte);
        let state = self.visit.as_ref().map(|visit| &visit.before.state);
        let names_y = |state: &State| second_axis::named_y(&block, state, &run.setup().machine).is_some();
        if state.is_some_and(names_y) { second_axis::with_c(&block) } else { block }
    }
}

/// Selects one of the visits to a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VisitChoice {
    /// The first visit that uses all words of the block: roughing ignores some of them in its contour.
    Usual,
    /// The visit with this number, from 1; the last one if there are fewer.
    Number(u32),
    /// The visit that makes the motion with this index; the usual one if none does.
    Motion(usize),
}

/// A replay in progress.
pub struct Replay {
    of: RunId,
    /// The repeated run; it has the text only while the replay advances.
    run: Run,
    place: Range<Resume>,
    choice: VisitChoice,
    /// Index of the first motion of the repeated run.
    motions_before: usize,
    visits: u32,
    carried_out: u32,
    visit: Option<Visit>,
    read_by: [bool; 2],
    is_done: bool,
}

/// The block at a byte. `line` is the position of the first byte of its line.
pub fn block_at(text: &[u8], line: Resume, byte: u32) -> (Range<Resume>, Block) {
    let mut parser = Parser::resume(text, line);
    let mut block = Block::default();
    loop {
        let at = parser.position();
        let more = parser.next_block(&mut block);
        let next = parser.position();
        if !more || next.byte > byte || next.byte as usize >= text.len() {
            return (at..next, block);
        }
    }
}

impl Run {
    /// Starts a replay up to the block at `byte`; `line` is the beginning of its line. The run must have
    /// ended; an edit invalidates the replay.
    pub fn replay(&self, line: Resume, byte: u32, choice: VisitChoice) -> Replay {
        self.replay_to(block_at(&self.text, line, byte).0, choice)
    }

    /// Starts a replay like [`Run::replay`]. Continues from the block of an earlier replay if that is nearer than the
    /// last snapshot.
    pub fn replay_after(&self, earlier: Replay, line: Resume, byte: u32, choice: VisitChoice) -> Replay {
        let (place, _) = block_at(&self.text, line, byte);
        let between = earlier.run.at.byte..=place.start.byte;
        let has_snapshot =
            self.last_checkpoint(place.start.byte).is_some_and(|last| between.contains(&last.byte()));
        let is_later = earlier.of == self.id && earlier.run.at.byte <= place.start.byte;
        if has_snapshot || !is_later || !earlier.can_continue() {
            return self.replay_to(place, choice);
        }
        let mut replay =
            Replay { place, choice, visits: 0, carried_out: 0, visit: None, is_done: false, ..earlier };
        replay.watch();
        replay
    }

    /// The last snapshot before a byte.
    fn last_checkpoint(&self, byte: u32) -> Option<&Checkpoint> {
        let before = self.checkpoints.partition_point(|checkpoint| checkpoint.byte() <= byte);
        before.checked_sub(1).map(|last| &self.checkpoints[last])
    }

    fn replay_to(&self, place: Range<Resume>, choice: VisitChoice) -> Replay {
        let checkpoint = self.last_checkpoint(place.start.byte);
        let checkpoint = checkpoint.filter(|checkpoint| checkpoint.snapshot.has_origins());
        let motions_before = checkpoint.map_or(0, |checkpoint| {
            let chunks = checkpoint.snapshot.chunks();
            self.motions().before().get(chunks).copied().unwrap_or(self.motions().len())
        });
        let run = self.replay_from(checkpoint);
        let is_done = !self.finished || self.recognised.foreign.is_some() || run.finished;
        let mut replay = Replay {
            of: self.id,
            run,
            place,
            choice,
            motions_before,
            visits: 0,
            carried_out: 0,
            visit: None,
            read_by: [false; 2],
            is_done,
        };
        replay.watch();
        replay
    }

    /// Continues a replay for at most `blocks` blocks; returns true once it has ended.
    pub fn advance_replay(&mut self, replay: &mut Replay, blocks: usize) -> bool {
        if replay.of != self.id {
            replay.is_done = true;
        }
        if replay.is_done {
            return true;
        }
        std::mem::swap(&mut self.text, &mut replay.run.text);
        replay.advance(blocks);
        std::mem::swap(&mut self.text, &mut replay.run.text);
        replay.is_done
    }

    /// This run from a snapshot or from its beginning, without its text and without lints.
    fn replay_from(&self, checkpoint: Option<&Checkpoint>) -> Self {
        let interpreter = match checkpoint {
            Some(checkpoint) => self.interpreter.resumed(&checkpoint.snapshot),
            None => {
                let mut interpreter = self.interpreter.restarted();
                interpreter.begin_recording();
                interpreter
            }
        };
        let at = checkpoint.map_or_else(Resume::default, |checkpoint| checkpoint.snapshot.at());
        let programs = self.programs.iter().filter(|(_, start)| **start < at.byte);
        let mut run = Self {
            id: RunId::next(),
            text: Vec::new(),
            block: Arc::default(),
            at,
            blocks: checkpoint.map_or(0, |checkpoint| checkpoint.blocks),
            programs: programs.map(|(number, start)| (*number, *start)).collect(),
            recognised: self.recognised,
            given: self.given.clone(),
            notes: self.notes.clone(),
            decided: self.decided,
            numbers: None,
            of_setup: 0,
            has_lints: self.has_lints,
            missing: None,
            tried: vec![0; self.tried.len()],
            begun: checkpoint.is_some(),
            ended: false,
            finished: false,
            stopped: false,
            sorted: Vec::new(),
            ignored: None,
            checkpoints: Vec::new(),
            due: usize::MAX,
            previous: None,
            next_join: u32::MAX,
            faulty: FaultyBlocks::default(),
            interpreter,
        };
        if let Some((system, _)) = self.recognised.system {
            run.interpreter.set_system(system);
        }
        // A snapshot already contains the unit.
        if checkpoint.is_none() && self.recognised.inches.is_some() {
            run.interpreter.set_unit(Unit::Inch);
        }
        if checkpoint.is_none()
            && let Some(number) = self.setup().program
        {
            match Labels::new(&self.text).program(number) {
                Some(head) => run.begin_at(head),
                None => run.finished = true,
            }
        }
        run
    }
}

impl Replay {
    /// The fraction of the text that has been read, 0 to 1.
    pub fn progress(&self) -> f64 {
        self.run.progress()
    }

    /// The requested visit.
    pub fn choice(&self) -> VisitChoice {
        self.choice
    }

    /// The result, once the replay has ended.
    pub fn found(&self) -> Found {
        let Self { place, visits, visit, read_by, .. } = self;
        Found { place: place.clone(), visits: *visits, visit: visit.clone(), read_by: *read_by }
    }

    /// Whether the replay can continue to a later block: it has executed its block, and all blocks before it in text
    /// order.
    pub fn can_continue(&self) -> bool {
        let has_ended = self.run.ended || self.run.finished;
        self.is_done && self.visits > 0 && !has_ended && self.run.interpreter.is_in_linear_order()
    }

    /// Records when a cycle reads the block as a part of its contour.
    fn watch(&mut self) {
        if let Some(record) = self.run.interpreter.record_mut() {
            record.watch(self.place.start.byte);
        }
    }

    fn advance(&mut self, blocks: usize) {
        for _ in 0..blocks {
            // Blocks after the end are only read.
            if self.run.finished || self.run.ended {
                self.is_done = true;
                return;
            }
            let is_there = self.run.at.byte == self.place.start.byte;
            let before = is_there.then(|| self.moment_of_block());
            if is_there {
                self.run.interpreter.keep_trace();
            }
            let first = self.kept();
            self.run.advance(1);
            let record = self.run.interpreter.record_mut();
            for reading in record.map(OriginRecord::take_readings).unwrap_or_default() {
                let moment = |(state, origins)| Moment { state, origins };
                let (before, after) = (moment(reading.before), moment(reading.after));
                self.record_visit(Some(reading.purpose), before, after, first..self.kept(), None);
            }
            if let Some(before) = before {
                let after = self.moment();
                let values = self.run.interpreter.take_trace().pop().and_then(|executed| executed.values);
                let values = values.map(String::from);
                self.record_visit(None, before, after, first..self.kept(), values);
                // While the program runs straight through, a block is visited only once. Contours are an
                // exception, but the way back from them is straight.
                self.is_done = self.run.interpreter.is_in_linear_order();
            }
            if self.is_done {
                return;
            }
        }
    }

    fn kept(&self) -> usize {
        self.motions_before + self.run.interpreter.kept_motions()
    }

    /// The state before the block, including values that are tried there.
    fn moment_of_block(&mut self) -> Moment {
        self.carried_out += 1;
        let mut moment = self.moment();
        for tried in &self.run.setup().tried {
            if (tried.block, tried.time) == (self.place.start.byte, self.carried_out) {
                set_tried_value(&mut moment.state.variables, *tried);
            }
        }
        moment
    }

    fn moment(&self) -> Moment {
        let Interpreter { state, .. } = &self.run.interpreter;
        let origins = match self.run.interpreter.recorder() {
            Some(recorder) => recorder.record().origins.clone(),
            None => Origins::new(state),
        };
        Moment { state: state.clone(), origins }
    }

    /// Records a visit to the block.
    fn record_visit(
        &mut self,
        purpose: Option<ContourUse>,
        before: Moment,
        after: Moment,
        motions: Range<usize>,
        values: Option<String>,
    ) {
        self.visits += 1;
        match purpose {
            Some(ContourUse::Roughing) => self.read_by[0] = true,
            Some(ContourUse::Finishing) => self.read_by[1] = true,
            None => {}
        }
        let number = self.visits;
        let carried_out = if purpose.is_none() { self.carried_out } else { 0 };
        let is_intended = match (self.choice, &self.visit) {
            (_, None) => true,
            (VisitChoice::Usual, Some(kept)) => {
                kept.purpose == Some(ContourUse::Roughing) && purpose != Some(ContourUse::Roughing)
            }
            (VisitChoice::Number(wanted), Some(_)) => number <= wanted,
            // A motion may be made by a block after its own.
            (VisitChoice::Motion(wanted), Some(kept)) => {
                !kept.motions.contains(&wanted) && motions.start <= wanted
            }
        };
        if is_intended {
            self.visit = Some(Visit { number, purpose, carried_out, before, after, values, motions });
        }
    }
}

#[cfg(all(test, not(target_arch = "wasm32")))]
mod properties;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::control::origins::Modal;
    use crate::setup::Setup;

    fn ended(text: &str, setup: Setup) -> Run {
        let mut run = Run::new(text.into(), setup);
        while !run.advance(usize::MAX) {}
        run
    }

    fn begin_of_line(text: &str, line: usize) -> Resume {
        let byte: usize = text.split_inclusive('\n').take(line).map(str::len).sum();
        Resume::inside(byte as u32, line as u32)
    }

    #[track_caller]
    fn found(run: &mut Run, line: usize, choice: VisitChoice) -> Found {
        let text = String::from_utf8(run.text().to_vec()).unwrap();
        let line = begin_of_line(&text, line);
        let mut replay = run.replay(line, line.byte, choice);
        while !run.advance_replay(&mut replay, 3) {}
        assert_eq!(run.text(), text.as_bytes(), "the run has its text back");
        replay.found()
    }

    #[test]
    fn the_state_before_and_after_a_block() {
        let text = "O1\nG99 G00 X50 Z2\nG01 Z-20 F0.2\nX60\nG98 F100\nM30\n";
        let mut run = ended(text, Setup::default());
        let found = found(&mut run, 2, VisitChoice::Usual);
        let visit = found.visit.unwrap();
        assert_eq!((found.visits, visit.number, visit.purpose, visit.motions), (1, 1, None, 1..2));
        assert_eq!((visit.before.state.feed, visit.after.state.feed), (None, Some(0.2)));
        assert_eq!(visit.before.state.position.z, 2.0);
        assert_eq!(visit.after.state.position.z, -20.0);
        assert_eq!(visit.before.origins.since(Modal::Feed), None);
        assert_eq!(visit.after.origins.since(Modal::Feed), Some(begin_of_line(text, 2).byte));
        assert_eq!(visit.after.origins.since(Modal::FeedMode), None, "as at power-on");
    }

    #[test]
    fn what_holds_was_set_where_it_became_so() {
        let text = "O1\nG98 G00 X50 Z2\nG01 Z-20 F100\nG01 X60\nZ-30\nG0 X70\nZ2\nM30\n";
        let mut run = ended(text, Setup::default());
        let at = |line| Some(begin_of_line(text, line).byte);
        let visit = found(&mut run, 4, VisitChoice::Usual).visit.unwrap();
        assert_eq!(visit.before.origins.since(Modal::Motion), at(2));
        assert_eq!(visit.before.origins.since(Modal::FeedMode), at(1));
        let visit = found(&mut run, 6, VisitChoice::Usual).visit.unwrap();
        assert_eq!(visit.before.origins.since(Modal::Motion), at(5));
    }

    #[test]
    fn a_block_of_a_loop_is_met_in_each_round() {
        let text = "O1\n#1=0\nWHILE[#1LT3]DO1\nG0 X[#1*10] Z0\n#1=#1+1\nEND1\nM30\n";
        let mut run = ended(text, Setup::default());
        for round in 1..=3 {
            let found = found(&mut run, 3, VisitChoice::Number(round));
            let visit = found.visit.unwrap();
            assert_eq!((found.visits, visit.number), (3, round));
            assert_eq!(visit.after.state.position.x, 5.0 * f64::from(round - 1));
        }
        let by_motion = found(&mut run, 3, VisitChoice::Motion(1)).visit.unwrap();
        assert_eq!(by_motion.number, 2);
        let by_sum = found(&mut run, 4, VisitChoice::Number(2)).visit.unwrap();
        assert_eq!(by_sum.before.origins.set_by(0, 1), Some(begin_of_line(text, 4).byte));
    }

    #[test]
    fn a_block_of_a_contour_is_read_by_roughing_and_by_finishing() {
        let text = "O1\nT0101 M3 S800\nG0 X52 Z2\nG71 U2 R1\nG71 P10 Q20 U0.4 W0.1 F0.3\nN10 G0 X30\nG1 Z-10 F0.1\nN20 X50 Z-20\nG70 P10 Q20\nM30\n";
        let mut run = ended(text, Setup::default());
        let found_line = found(&mut run, 7, VisitChoice::Usual);
        let visit = found_line.visit.unwrap();
        assert_eq!((found_line.visits, visit.number, visit.purpose), (2, 2, Some(ContourUse::Finishing)));
        assert_eq!(visit.before.state.feed, Some(0.1));
        assert_eq!(visit.before.origins.since(Modal::Feed), Some(begin_of_line(text, 6).byte));
        let first = found(&mut run, 7, VisitChoice::Number(1)).visit.unwrap();
        assert_eq!(first.purpose, Some(ContourUse::Roughing));
        let after = found(&mut run, 8, VisitChoice::Usual).visit.unwrap();
        assert_eq!(after.before.state.feed, Some(0.3), "what the contour says does not outlive roughing");
    }

    #[test]
    fn a_block_that_is_jumped_over_is_never_met() {
        let text = "O1\nG0 X10 Z0\nGOTO 20\nX20\nN20 X30\nM30\nX40\n";
        let mut run = ended(text, Setup::default());
        for line in [3, 6] {
            assert_eq!(found(&mut run, line, VisitChoice::Usual).visits, 0, "line {line}");
        }
        assert_eq!(found(&mut run, 4, VisitChoice::Usual).visits, 1);
    }

    #[test]
    fn a_program_for_another_control_is_never_executed() {
        let text = "G18 G90 G95 DIAMON\nT1 D1\nG0 X46 Z2\nG1 Z-5 F0.1\nM30\n";
        let mut run = ended(text, Setup::default());
        assert!(run.foreign().is_some());
        let mut earlier: Option<Replay> = None;
        for line in [2, 3] {
            let line = begin_of_line(text, line);
            let mut replay = match earlier.take() {
                Some(earlier) => run.replay_after(earlier, line, line.byte, VisitChoice::Usual),
                None => run.replay(line, line.byte, VisitChoice::Usual),
            };
            while !run.advance_replay(&mut replay, 1) {}
            assert_eq!(replay.found().visits, 0);
            earlier = Some(replay);
        }
    }

    #[test]
    fn a_long_program_is_gone_through_from_the_last_snapshot() {
        let mut text = String::from("O1\nG98\nG01 F100 X100 Z0\n");
        for line in 0..2000 {
            text += &format!("X{} Z-{}\n", 10 + line % 7, line % 11);
        }
        text += "F200\nX3\nM30\n";
        let mut setup = Setup::default();
        setup.limits.stride = 50;
        let mut run = ended(&text, setup);
        let line = begin_of_line(&text, 1500);
        let mut replay = run.replay(line, line.byte, VisitChoice::Usual);
        let mut slices = 1;
        while !run.advance_replay(&mut replay, 10) {
            slices += 1;
        }
        assert!(slices < 50, "{slices} slices of ten blocks");
        let visit = replay.found().visit.unwrap();
        assert_eq!(visit.motions, 1498..1499);
        assert_eq!(visit.before.origins.since(Modal::Feed), Some(7));
        assert_eq!(visit.before.origins.since(Modal::FeedMode), Some(3));
    }

    #[test]
    fn after_an_edit_what_holds_was_set_where_it_stands_now() {
        let mut text = String::from("O1\nG98\nG01 F100 X100 Z0\n");
        for line in 0..1000 {
            text += &format!("X{} Z-{}\n", 10 + line % 7, line % 11);
        }
        text += "F200\n";
        for line in 0..500 {
            text += &format!("X{} Z-{}\n", 10 + line % 7, line % 11);
        }
        text += "M30\n";
        let mut setup = Setup::default();
        setup.limits.stride = 50;
        let mut run = ended(&text, setup.clone());
        let at = begin_of_line(&text, 600).byte as usize;
        run.edit(super::super::TextEdit { start: at, end: at, insert: b"(a remark)\n".to_vec() });
        while !run.advance(usize::MAX) {}
        text.insert_str(at, "(a remark)\n");
        let mut anew = ended(&text, setup);
        for line in [500, 700, 1003, 1004, 1005, 1400] {
            let own = found(&mut run, line, VisitChoice::Usual).visit.unwrap();
            let fresh = found(&mut anew, line, VisitChoice::Usual).visit.unwrap();
            assert_eq!(own.before.state, fresh.before.state);
            for &modal in Modal::ALL {
                assert_eq!(
                    own.before.origins.since(modal),
                    fresh.before.origins.since(modal),
                    "line {line}: {modal:?}"
                );
            }
        }
    }
}
