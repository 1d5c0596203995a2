//! A question about a block: its execution, found by a replay of the run in slices.
//!
//! In: a place, and which visit to its block. Out: the result of the replay. The answer is kept until the
//! question is about another block, or the run changes.

use super::Current;
use crate::run::RunId;
use crate::run::replay::{Found, Replay, VisitChoice};

/// The current question about a block.
#[derive(Default)]
pub struct Question {
    /// The place of the question.
    byte: u32,
    replay: Option<Replay>,
    /// The last replay, if it can continue.
    ended: Option<Replay>,
    found: Option<(RunId, VisitChoice, Found)>,
}

impl Question {
    /// The byte that the question is about.
    pub fn byte(&self) -> u32 {
        self.byte
    }

    /// Asks about the block at a byte. The run must have ended. Returns whether the answer is already
    /// available.
    pub fn ask(&mut self, current: &Current, byte: u32, time: VisitChoice) -> bool {
        (self.byte, self.replay) = (byte, None);
        let is_known = self.found.as_ref().is_some_and(|(run, of, found)| {
            let place = found.place.start.byte..found.place.end.byte;
            *run == current.run().id() && *of == time && place.contains(&byte)
        });
        if !is_known {
            self.found = None;
            let replay = match self.ended.take() {
                Some(earlier) => current.replay_after(earlier, byte, time),
                None => current.replay(byte, time),
            };
            self.replay = Some(replay);
        }
        is_known
    }

    /// Continues the search for at most `blocks` blocks. Returns whether the answer is available.
    pub fn look(&mut self, current: &mut Current, blocks: usize) -> bool {
        let Some(mut replay) = self.replay.take() else { return true };
        if current.advance_replay(&mut replay, blocks) {
            self.found = Some((current.run().id(), replay.choice(), replay.found()));
            self.ended = replay.can_continue().then_some(replay);
            return true;
        }
        self.replay = Some(replay);
        false
    }

    /// The answer for the current run; `None` if there is none yet.
    pub fn found(&self, current: &Current) -> Option<&Found> {
        let answer = self.found.as_ref().filter(|(run, ..)| *run == current.run().id());
        answer.map(|(.., found)| found)
    }
}
