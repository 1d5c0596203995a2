//! Snapshots of the control between two blocks, so that after an edit only a part of the program runs again.
//!
//! In: the position of the next block. Out: a [`Snapshot`], which the run can return to or another run can
//! meet. A snapshot is only made while nothing executed has looked elsewhere in the text: no call, jump, loop
//! or contour yet.

use std::ops::Range;

use super::Interpreter;
use super::contours::Contours;
use crate::control::events::Observer;
use crate::control::modal::State;
use crate::control::origins::OriginRecorder;
use crate::message::Diagnostic;
use crate::motion::{Chunk, Motions};
use crate::source::shift::Shift;
use crate::text::parser::Resume;

/// The control between two blocks, while the program runs in the linear order of the text. The state does not
/// depend on later blocks.
#[derive(Clone, Debug)]
pub struct Snapshot {
    /// Position of the next block.
    at: Resume,
    state: State,
    recorder: Option<Box<dyn OriginRecorder>>,
    observer: Option<Box<dyn Observer>>,
    /// Number of chunks of motions before it.
    chunks: usize,
    /// Number of messages reported before it.
    reported: usize,
    /// Number of messages before it that were not kept.
    hidden: usize,
    work: usize,
    /// A block since the previous snapshot could not be carried out.
    failed: bool,
    /// A block before it could not be carried out.
    incomplete: bool,
}

impl Snapshot {
    /// Position of the next block.
    pub fn at(&self) -> Resume {
        self.at
    }

    /// Number of chunks of motions before it.
    pub fn chunks(&self) -> usize {
        self.chunks
    }

    /// Whether results of the blocks in `changed` depend on later blocks. A waiting move may come from
    /// several blocks; its first block counts.
    fn waits_for(&self, changed: Range<u32>) -> bool {
        self.state.first_waiting() < changed.end
            || self.observer.as_ref().is_some_and(|observer| observer.waits_for(changed))
    }

    /// Whether it has a record of which block set what.
    pub fn has_origins(&self) -> bool {
        self.recorder.is_some()
    }

    /// Moves the spans it holds after a change of the text before them.
    fn shift(&mut self, shift: &Shift) {
        self.at = self.at.shifted(shift);
        self.state.shift(shift);
        if let Some(observer) = &mut self.observer {
            observer.shift(shift);
        }
    }
}

/// The results of a finished run after one of its snapshots.
#[derive(Clone, Debug)]
pub struct RunTail {
    /// That snapshot and the later ones, in order.
    snapshots: Vec<Snapshot>,
    /// The motions after the first snapshot.
    motions: Motions,
    /// The messages after the first snapshot, in the order in which they were reported.
    diagnostics: Vec<Diagnostic>,
    /// Number of messages of the whole run that were not kept.
    hidden: usize,
    /// The state at the end.
    state: State,
    recorder: Option<Box<dyn OriginRecorder>>,
    observer: Option<Box<dyn Observer>>,
}

impl RunTail {
    /// Position of the snapshot `index`.
    pub fn at(&self, index: usize) -> Option<Resume> {
        self.snapshots.get(index).map(|snapshot| snapshot.at)
    }

    fn motions_after(&self, there: &Snapshot) -> usize {
        let chunks = there.chunks - self.snapshots[0].chunks;
        let before = self.motions.before().get(chunks).copied();
        before.map_or(0, |before| self.motions.len() - before)
    }

    fn reported_after(&self, there: &Snapshot) -> usize {
        self.diagnostics.len() - (there.reported - self.snapshots[0].reported)
    }
}

impl Interpreter {
    /// Whether there are enough motions for a chunk.
    #[inline]
    pub fn has_full_chunk(&self) -> bool {
        self.sink.chunk.len() >= self.setup.limits.stride
    }

    /// Number of motions that the chunk still has room for.
    #[inline]
    pub fn room_in_chunk(&self) -> usize {
        self.setup.limits.stride.saturating_sub(self.sink.chunk.len())
    }

    /// Estimated size in bytes of all motions of a text of `text` bytes, if the rest of it is like the part
    /// up to `at`. 0 for a short text.
    pub fn expected_bytes(&self, at: Resume, text: usize) -> usize {
        /// Minimum size of a text, in bytes, for which memory is reserved.
        const MIN_LONG_TEXT: usize = 1 << 20;
        /// Maximum bytes of motions per byte of text; only loops can exceed it.
        const MAX_EXPANSION: usize = 4;
        let so_far = self.sink.chunk.len() * Chunk::BYTES_PER_MOTION;
        let whole = so_far as u64 * text as u64 / u64::from(at.byte.max(1));
        if text < MIN_LONG_TEXT { 0 } else { whole.min((MAX_EXPANSION * text) as u64) as usize }
    }

    /// Begins a chunk at the next block. A chunk without motions begins again there.
    pub fn begin_chunk(&mut self, at: Resume) {
        let mut next = Chunk::new(at.byte, at.line, self.state.position);
        // A program that has filled a chunk is likely to fill another one; a single block may make far more
        // motions.
        let stride = self.setup.limits.stride;
        if (stride..2 * stride).contains(&self.sink.chunk.len()) {
            next.reserve_as(&self.sink.chunk);
        }
        self.sink.begin_chunk(next);
    }

    /// Whether the program has run only in the linear order of the text, without looking elsewhere in it.
    pub fn is_in_linear_order(&self) -> bool {
        self.program.is_in_linear_order() && !self.sink.is_full() && self.trace.is_none()
    }

    /// Takes a snapshot before the next block, which begins a chunk.
    pub fn snapshot(&mut self, at: Resume) -> Snapshot {
        // Errors are counted from zero again, so that the state does not depend on earlier ones.
        let failed = std::mem::take(&mut self.state.incomplete);
        self.sink.incomplete |= failed;
        self.begin_chunk(at);
        Snapshot {
            at,
            state: self.state.clone(),
            recorder: self.recorder.clone(),
            observer: self.observer.clone(),
            chunks: self.sink.motions.chunks().len(),
            reported: self.sink.diagnostics.len(),
            hidden: self.sink.hidden,
            work: self.program.budget.work,
            failed,
            incomplete: self.sink.incomplete,
        }
    }

    /// Returns to a snapshot of the same run, as if nothing after it had been carried out.
    pub fn restore(&mut self, snapshot: &Snapshot) {
        let Snapshot { at, state, recorder, observer, chunks, reported, hidden, work, failed: _, incomplete } =
            snapshot;
        let chunk = Chunk::new(at.byte, at.line, state.position);
        self.sink.truncate_to(*chunks, *reported, *hidden, *incomplete, chunk);
        self.state = state.clone();
        self.recorder = recorder.clone();
        self.observer = observer.clone();
        self.program = std::mem::take(&mut self.program).reset_at(*at, *work);
        self.contours = Contours::default();
        (self.block_failed, self.uses_unknown_value, self.cut_context_changed) = (false, false, true);
    }

    /// A new control that continues from a snapshot of this one, without an observer, and contains only the
    /// later motions.
    pub fn resumed(&self, snapshot: &Snapshot) -> Self {
        let mut interpreter = self.restarted();
        interpreter.restore(&Snapshot {
            chunks: 0,
            reported: 0,
            hidden: 0,
            observer: None,
            ..snapshot.clone()
        });
        interpreter
    }

    /// A control like this one at power-on, without an observer.
    pub fn restarted(&self) -> Self {
        Self::of(self.setup.clone(), self.dialect.clone())
    }

    /// Takes the results after the first of these snapshots out of this run, which has ended.
    pub fn take_tail(&mut self, snapshots: Vec<Snapshot>) -> Option<RunTail> {
        let first = snapshots.first()?;
        Some(RunTail {
            motions: self.sink.motions.split_off(first.chunks),
            diagnostics: self.sink.diagnostics.split_off(first.reported),
            hidden: self.sink.hidden,
            state: self.state.clone(),
            recorder: self.recorder.clone(),
            observer: self.observer.clone(),
            snapshots,
        })
    }

    /// Whether this run continues from here as another run did from its snapshot `index`, after its positions
    /// are shifted. Blocks that begin before the byte `unchanged` are the same in both.
    pub fn continues_as(&self, other: &RunTail, index: usize, unchanged: u32, shift: &Shift) -> bool {
        let there = &other.snapshots[index];
        let reported = self.sink.diagnostics.len();
        let as_full = (reported, self.sink.hidden) == (there.reported, there.hidden);
        let has_room = (self.sink.hidden, other.hidden) == (0, 0)
            && reported + other.reported_after(there) <= self.setup.limits.messages;
        let holds_all = self.sink.kept() + other.motions_after(there) <= self.setup.limits.motions;
        if !self.is_in_linear_order()
            || self.program.budget.work != there.work
            || !(as_full || has_room)
            || !holds_all
            || there.waits_for(unchanged..shift.from)
        {
            return false;
        }
        let mut there = there.clone();
        there.shift(shift);
        let is_heard_alike = match (&self.observer, &there.observer) {
            (Some(own), Some(other)) => own.continues_like(other.as_ref()),
            (own, other) => own.is_none() && other.is_none(),
        };
        is_heard_alike && self.state.continues_like(&there.state)
    }

    /// Takes over the results of another run after its snapshot `index`, which this run has just met. The
    /// later snapshots of that run become snapshots of this run. The number of hidden messages is the same as
    /// there.
    pub fn adopt_tail(&mut self, other: RunTail, index: usize, shift: &Shift) -> Vec<Snapshot> {
        let RunTail {
            mut snapshots,
            mut motions,
            mut diagnostics,
            hidden,
            mut state,
            recorder,
            mut observer,
        } = other;
        let (chunks_out, reported_before) = (snapshots[0].chunks, snapshots[0].reported);
        let mut later = snapshots.split_off(index);
        let there = later.remove(0);
        let motions = motions.split_off(there.chunks - chunks_out);
        let mut diagnostics = diagnostics.split_off(there.reported - reported_before);
        diagnostics.iter_mut().for_each(|diagnostic| diagnostic.shift(shift));
        let chunks = self.sink.motions.chunks().len();
        let reported = self.sink.diagnostics.len();
        let mut incomplete = self.sink.incomplete;
        let met = there.at.byte;
        for snapshot in &mut later {
            snapshot.recorder = self.recorder_after(met, snapshot.recorder.as_deref(), shift);
            self.sink.incomplete |= snapshot.failed;
            snapshot.shift(shift);
            snapshot.chunks = snapshot.chunks - there.chunks + chunks;
            snapshot.reported = snapshot.reported - there.reported + reported;
            snapshot.incomplete = self.sink.incomplete;
        }
        let mut passed = later.iter().peekable();
        self.sink.motions.append(motions, |index, chunk| {
            while let Some(snapshot) = passed.next_if(|snapshot| snapshot.chunks <= chunks + index) {
                incomplete = snapshot.incomplete;
            }
            chunk.shift(shift);
            chunk.set_incomplete(incomplete);
        });
        self.sink.diagnostics.append(&mut diagnostics);
        self.sink.hidden = hidden;
        state.shift(shift);
        if let Some(observer) = &mut observer {
            observer.shift(shift);
        }
        self.recorder = self.recorder_after(met, recorder.as_deref(), shift);
        (self.state, self.observer) = (state, observer);
        later
    }

    /// The recorder of another run, which this run has met, with its positions moved into the text of this
    /// run.
    fn recorder_after(
        &self,
        met: u32,
        other: Option<&dyn OriginRecorder>,
        shift: &Shift,
    ) -> Option<Box<dyn OriginRecorder>> {
        let own = self.recorder()?.record();
        Some(Box::new(other?.record().merged_after(met, own, shift)))
    }
}
