//! Re-runs only the part of a program that an edit can have affected.
//!
//! In: the replaced bytes and their replacement. The run goes back to the last snapshot before the edit. When
//! it reaches a snapshot of the previous run in the same state, apart from places in the text, it takes over
//! the remaining results of that run.

use std::collections::BTreeMap;

use super::repeated::FaultyBlocks;
use super::{Recognised, Run, RunId, TextEdit};
use crate::control::interpreter::{RunTail, Snapshot};
use crate::heap;
use crate::parts::{Part, late};
use crate::provenance;
use crate::setup::notes::{self, Notes};
use crate::source::shift::Shift;
use crate::text::long_comment;
use crate::text::parser::{LEADER, Resume};

/// Maximum distance between two snapshots, in blocks per motion of the stride.
const BLOCKS_PER_MOTION: usize = 4;

/// A snapshot of a run between the first word of the main program and its end. All checkpoints of a run have
/// seen the same O numbers.
#[derive(Clone, Debug)]
pub(super) struct Checkpoint {
    pub(super) snapshot: Snapshot,
    /// Blocks read before the snapshot.
    pub(super) blocks: usize,
}

impl Checkpoint {
    pub(super) fn byte(&self) -> u32 {
        self.snapshot.at().byte
    }
}

/// The results of the run before the edit, from the first snapshot after the edit on.
#[derive(Clone, Debug)]
pub(super) struct PreviousRun {
    tail: RunTail,
    /// Blocks read at each of its snapshots.
    blocks: Vec<usize>,
    /// Blocks read at its end.
    last: usize,
    /// O numbers of the programs read before its snapshots, in order.
    heads: Vec<u32>,
    /// First byte of each program read after them, by O number.
    others: BTreeMap<u32, u32>,
    /// Index of the next snapshot at which the runs may join.
    next: usize,
    /// The shift of the old places by the edit; the shift of lines is unknown until the two runs join.
    shift: Shift,
    /// First byte of the first changed line.
    unchanged: u32,
    /// From this byte of the new text on, lines are parsed as before the edit.
    same_from: i64,
    /// Length of the new text without trailing blanks.
    filled: usize,
}

impl PreviousRun {
    /// Adds a further edit of the new text.
    fn edit(mut self, line: u32, end: u32, bytes: i64, same_from: i64) -> Self {
        self.unchanged = self.unchanged.min(line);
        let behind = i64::from(self.shift.from) + self.shift.bytes;
        self.shift.from += (i64::from(end) - behind).max(0) as u32;
        self.shift.bytes += bytes;
        self.same_from = same_from.max(self.same_from + bytes);
        self.next = 0;
        self
    }

    /// The next byte after `behind`, in the new text, at which the runs may join.
    fn next_join(&mut self, behind: u32) -> Option<u32> {
        while let Some(there) = self.tail.at(self.next) {
            let byte = self.shift.byte(there.byte);
            if self.shift.moves(there.byte) && byte > behind && i64::from(byte) >= self.same_from {
                return Some(byte);
            }
            self.next += 1;
        }
        None
    }
}

/// The part that makes edits incremental; before it is loaded, each edit runs the text from the beginning.
pub(super) const EDITS: Part = Part::Late;

late! {
    fn go_back(run: &mut Run, edit: TextEdit) {
        run.go_back(edit);
    }

    fn snapshot_if_due(run: &mut Run, at: Resume) -> bool {
        run.take_checkpoint(at)
    }
}

impl Run {
    /// Begins a run of the changed text. Positions outside the text are clamped.
    pub fn edit(&mut self, edit: TextEdit) {
        if EDITS.is_loaded() {
            go_back(self, edit);
            return;
        }
        let before = self.take_text();
        let end = edit.end.min(before.len());
        let text = [&before[..edit.start.min(end)], &edit.insert, &before[end..]].concat();
        *self = Self::begin(text, self.given.clone(), self.decided);
    }

    /// Goes back to the last snapshot before the change.
    fn go_back(&mut self, edit: TextEdit) {
        self.id = RunId::next();
        let end = edit.end.min(self.text.len());
        let start = edit.start.min(end);
        let bytes = edit.insert.len() as i64 - (end - start) as i64;
        // The parsing of a line may depend on the lines around it.
        let (first, last) = long_comment::around(&self.text, start, end);
        let line = self.text[..start]
            .iter()
            .rposition(|byte| matches!(byte, b'\n' | b'\r'))
            .map_or(0, |end| end + 1);
        let before = self.before_edit(line as u32, end as u32, bytes, last as i64 + bytes);
        let keep = self.checkpoints.partition_point(|checkpoint| (checkpoint.byte() as usize) < first);
        self.checkpoints.truncate(keep);
        self.numbers = None;
        self.faulty = FaultyBlocks::default();
        let mut text = std::mem::take(&mut self.text);
        let mut ignored = self.ignored.take();
        let inserted = edit.insert.len();
        text.splice(start..end, edit.insert);
        if let Some(ignored) = &mut ignored {
            ignored.edit(&text, &(start..end), inserted);
        }
        let checkpoint = self.checkpoints.last().filter(|_| {
            text.len() <= self.setup().limits.text
                && start >= LEADER
                && (start >= provenance::HEAD
                    || Some(self.recognised)
                        == Recognised::of(&text, provenance::quick_check_head(&text), &self.setup().dialect))
                && (start >= notes::HEAD || (Notes::can_be_read(&text) && self.notes.match_text(&text)))
        });
        let same_way = match checkpoint {
            Some(checkpoint) => {
                self.text = text;
                self.interpreter.restore(&checkpoint.snapshot);
                (self.at, self.blocks) = (checkpoint.snapshot.at(), checkpoint.blocks);
                self.programs.retain(|_, start| *start < self.at.byte);
                (self.begun, self.ended, self.finished, self.stopped) = (true, false, false, false);
                self.due = self.next_due();
                true
            }
            None => {
                let (recognised, setup) = (self.recognised, self.setup().clone());
                *self = Self::begin(text, self.given.clone(), self.decided);
                !self.finished && self.recognised == recognised && *self.setup() == setup
            }
        };
        self.ignored = ignored;
        let filled = self.text.trim_ascii_end().len();
        self.previous = before.filter(|_| same_way).map(|before| PreviousRun { filled, ..before });
        self.find_next_join(self.at);
    }

    /// The results of this run, or of the one before it, that come after an edit that is about to be made.
    fn before_edit(&mut self, line: u32, end: u32, bytes: i64, same_from: i64) -> Option<PreviousRun> {
        if let Some(before) = self.previous.take() {
            return Some(before.edit(line, end, bytes, same_from));
        }
        if !self.finished || self.stopped || !self.interpreter.is_in_linear_order() {
            return None;
        }
        let behind = self.checkpoints.partition_point(|checkpoint| checkpoint.byte() < end);
        let checkpoints = self.checkpoints.split_off(behind);
        let first = checkpoints.first()?.byte();
        let (snapshots, blocks) =
            checkpoints.into_iter().map(|checkpoint| (checkpoint.snapshot, checkpoint.blocks)).unzip();
        let programs = std::mem::take(&mut self.programs);
        let (heads, others) = programs.into_iter().partition(|(_, start)| *start < first);
        self.programs = heads;
        Some(PreviousRun {
            tail: self.interpreter.take_tail(snapshots)?,
            blocks,
            last: self.blocks,
            heads: self.programs.keys().copied().collect(),
            others,
            next: 0,
            shift: Shift { from: end, bytes, lines: 0 },
            unchanged: line,
            same_from,
            filled: 0,
        })
    }

    /// Whether a snapshot is due before the next block, or this run may join the previous one there.
    #[inline]
    pub(super) fn is_due(&self, at: Resume) -> bool {
        self.interpreter.has_full_chunk() || self.blocks >= self.due || at.byte >= self.next_join
    }

    /// Number of blocks after which a snapshot may be due.
    #[inline]
    pub(super) fn until_due(&self) -> usize {
        self.interpreter.room_in_chunk().min(self.due.saturating_sub(self.blocks))
    }

    /// Takes a snapshot before the next block of a text of `text` bytes. Returns true if the run has joined
    /// the previous one and taken over its remaining results.
    #[cold]
    pub(super) fn snapshot_if_due(&mut self, at: Resume, text: usize) -> bool {
        if self.interpreter.motions().is_empty() {
            heap::reserve(self.interpreter.expected_bytes(at, text));
        }
        if EDITS.is_loaded() {
            return snapshot_if_due(self, at);
        }
        if self.interpreter.has_full_chunk() {
            self.interpreter.begin_chunk(at);
        }
        self.due = self.next_due();
        false
    }

    fn take_checkpoint(&mut self, at: Resume) -> bool {
        self.due = self.next_due();
        if self.ended || !self.interpreter.is_in_linear_order() {
            self.previous = None;
        }
        // Tried values count executions from the start, so such a run always begins there.
        let may_pause = self.begun
            && !self.ended
            && at.begins_line()
            && self.interpreter.is_in_linear_order()
            && self.tried.is_empty();
        let joined = may_pause && {
            let snapshot = self.interpreter.snapshot(at);
            self.checkpoints.push(Checkpoint { snapshot, blocks: self.blocks });
            self.join_at(at)
        };
        if !may_pause && self.interpreter.has_full_chunk() {
            self.interpreter.begin_chunk(at);
        }
        self.find_next_join(at);
        joined
    }

    fn next_due(&self) -> usize {
        self.blocks + BLOCKS_PER_MOTION * self.setup().limits.stride
    }

    /// Finds the next byte after `at` at which this run may join the previous one.
    fn find_next_join(&mut self, at: Resume) {
        let next = self.previous.as_mut().and_then(|before| before.next_join(at.byte));
        if next.is_none() {
            self.previous = None;
        }
        self.next_join = next.unwrap_or(u32::MAX);
    }

    /// Takes over the remaining results of the previous run, if its state here was the same.
    fn join_at(&mut self, at: Resume) -> bool {
        let Some(before) = &mut self.previous else { return false };
        let index = before.next;
        let Some(there) = before.tail.at(index) else { return false };
        before.shift.lines = i64::from(at.line) - i64::from(there.line);
        let shift = before.shift;
        // The end of the text is reported at the last character before it, so joining there would misplace
        // the message.
        let is_last = at.byte as usize >= before.filled;
        if is_last
            || there.shifted(&shift) != at
            || !self.interpreter.continues_as(&before.tail, index, before.unchanged, &shift)
        {
            return false;
        }
        let Some(PreviousRun { tail, blocks, last, heads, others, .. }) = self.previous.take() else {
            return false;
        };
        if !heads.iter().eq(self.programs.keys()) {
            // They will differ at later snapshots too.
            return false;
        }
        let later = self.interpreter.adopt_tail(tail, index, &shift);
        let (met, own) = (blocks[index], self.blocks);
        let moved = |blocks: usize| blocks - met + own;
        let blocks = blocks.into_iter().skip(index + 1).map(moved);
        self.checkpoints
            .extend(later.into_iter().zip(blocks).map(|(snapshot, blocks)| Checkpoint { snapshot, blocks }));
        self.blocks = moved(last);
        self.programs.extend(others.into_iter().map(|(number, start)| (number, shift.byte(start))));
        true
    }
}
