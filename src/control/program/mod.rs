//! The way a program takes through its text: where to read next, and the limits on
//! reading the same blocks again.
//!
//! In: places in the text, and what asks for a jump, a call or another round. Out: the next place; the
//! message of the limit that is exceeded. Knows nothing of what a block does. What has to be known to go back
//! to a block (calls and loops under way) is [`CallStack`], a part of the state.

mod budget;
mod call_stack;
mod labels;
mod main_pass;

use std::collections::{BTreeMap, BTreeSet};

pub use budget::Budget;
pub use call_stack::{Call, CallKind, CallStack, Loop, ModalCall, Rounds};
pub use labels::{Labels, calls_elsewhere, program_and_repeats};
pub use main_pass::MainPass;

use crate::order;
use crate::source::Span;
use crate::text::parser::Resume;

/// How a program is read: straight through, or by jumps, calls and loops.
#[derive(Debug, Default)]
pub struct Program {
    /// Sequence numbers, made when first asked for.
    labels: Option<Labels>,
    /// Where loops go on after their END, by the first byte of their DO; found when first asked for.
    pub loop_ends: BTreeMap<u32, Option<Resume>>,
    /// A loop has no END.
    pub lacks_end: bool,
    /// Where the program goes on after the block under way.
    pub jump: Option<Resume>,
    /// Blocks of the main program from this byte on have not been run yet.
    unread_from: u32,
    /// How much has been read again.
    pub budget: Budget,
    /// The block that jumped or called last.
    pub jumped_by: Option<Span>,
    /// A jump, call or loop has led away from the straight way through the text.
    has_jumped: bool,
    /// The run began with another program than the first of the text.
    pub begun_elsewhere: bool,
    /// First bytes of the programs that were run.
    heads: BTreeSet<u32>,
    /// Whether the main program is the body of a macro; found when first asked for.
    pub is_macro_body: Option<bool>,
}

impl Program {
    /// The sequence and program numbers of the text.
    pub fn labels(&mut self, text: &[u8]) -> &Labels {
        self.labels.get_or_insert_with(|| Labels::new(text))
    }

    /// Whether the block at byte `start` of the main program is read for the first time; it
    /// counts as read from here on.
    #[inline]
    pub fn is_first_reading(&mut self, start: u32) -> bool {
        let is_first = start >= self.unread_from;
        if is_first {
            self.unread_from = start + 1;
        }
        is_first
    }

    /// Whether nothing of the main program from byte `start` on has been read.
    pub fn is_unread_from(&self, start: u32) -> bool {
        start >= self.unread_from
    }

    /// A jump, call or loop leads elsewhere. `by`: the words of its block.
    pub fn jump_by(&mut self, by: Span) {
        self.has_jumped = true;
        self.jumped_by = Some(by);
    }

    /// A loop that is not run is left out.
    pub fn skip_loop(&mut self) {
        self.has_jumped = true;
    }

    /// Whether the program has left the straight way through its text.
    pub fn has_jumped(&self) -> bool {
        self.has_jumped
    }

    /// Whether nothing so far was carried out, or looked for, anywhere else than on the
    /// straight way through the text.
    pub fn is_straight(&self) -> bool {
        self.labels.is_none() && self.loop_ends.is_empty() && !self.has_jumped
    }

    /// An O program that begins at `head` is run.
    pub fn enter(&mut self, head: Resume) {
        self.heads.insert(head.byte);
    }

    /// The program to run begins at `head`, and is not the first of the text.
    pub fn begin_elsewhere(&mut self, head: Resume) {
        self.enter(head);
        self.unread_from = head.byte;
        self.has_jumped = true;
        self.begun_elsewhere = true;
    }

    /// Whether the program that begins here was run.
    pub fn was_run(&self, at: Resume) -> bool {
        self.heads.contains(&at.byte)
    }

    /// The same program, of which nothing from `at` on has been read. Only right for one that was
    /// read straight through so far.
    pub fn back_at(self, at: Resume, work: usize) -> Self {
        let heads = order::gathered(self.heads.into_iter().filter(|&head| head < at.byte));
        let budget = Budget::after_work(work);
        Self { unread_from: at.byte, heads, budget, ..Self::default() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(byte: u32) -> Resume {
        Resume::inside(byte, 0)
    }

    #[test]
    fn a_block_is_read_for_the_first_time_once() {
        let mut program = Program::default();
        assert!(program.is_first_reading(0) && program.is_first_reading(10));
        assert!(!program.is_first_reading(0) && !program.is_first_reading(10));
        assert!(program.is_first_reading(11));
    }

    #[test]
    fn whoever_jumps_or_looks_for_a_number_leaves_the_straight_way() {
        let mut program = Program::default();
        assert!(program.is_straight());
        program.labels(b"N10 G00 X10");
        assert!(!program.is_straight() && !program.has_jumped());
        let mut program = Program::default();
        program.jump_by(Span::new(0, 3));
        assert!(!program.is_straight() && program.has_jumped());
    }

    #[test]
    fn going_back_forgets_what_was_read_after() {
        let mut program = Program::default();
        program.enter(at(0));
        program.enter(at(40));
        assert!(program.is_first_reading(60));
        let mut program = program.back_at(at(40), 7);
        assert!(program.was_run(at(0)) && !program.was_run(at(40)));
        assert!(program.is_first_reading(40) && program.is_straight() && program.budget.work == 7);
    }

    #[test]
    fn a_program_chosen_by_its_number_begins_at_its_head() {
        let mut program = Program::default();
        program.begin_elsewhere(at(40));
        assert!(program.was_run(at(40)) && program.begun_elsewhere && !program.is_straight());
        assert!(!program.is_first_reading(0) && program.is_first_reading(40));
    }
}
