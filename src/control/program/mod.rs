//! Control flow of a program: where to read next, and limits on reading blocks again.
//!
//! In: positions in the text, and requests for jumps, calls or rounds. Out: the next position, or the message
//! of the exceeded limit. Knows nothing of the effect of a block. [`CallStack`], a part of the state, has the
//! active calls and loops, which are needed to return to a block.

mod budget;
mod call_stack;
mod labels;
mod main_pass;

use std::collections::{BTreeMap, BTreeSet};

pub use budget::Budget;
pub use call_stack::{Call, CallKind, CallStack, Loop, ModalCall, Rounds};
pub use labels::{Labels, calls_elsewhere, may_call, program_and_repeats};
pub use main_pass::MainPass;

use crate::order;
use crate::source::Span;
use crate::text::parser::Resume;

/// How a program is read: in the linear order of the text, or with jumps, calls and loops.
#[derive(Debug, Default)]
pub struct Program {
    /// Sequence numbers; computed on first use.
    labels: Option<Labels>,
    /// Where loops continue after their END, by the first byte of their DO; cached.
    pub loop_ends: BTreeMap<u32, Option<Resume>>,
    /// A loop has no END.
    pub lacks_end: bool,
    /// Where the program continues after the current block.
    pub jump: Option<Resume>,
    /// Blocks of the main program from this byte on have not been run yet.
    unread_from: u32,
    /// Repeated work, counted against the limits.
    pub budget: Budget,
    /// The words of the block that jumped or called last.
    pub jumped_by: Option<Span>,
    /// A jump, call or loop has left the linear order of the text.
    has_left_linear_order: bool,
    /// The run began with a program that is not the first of the text.
    pub started_at_other_program: bool,
    /// First bytes of the programs that have run.
    heads: BTreeSet<u32>,
    /// Whether the main program is the body of a macro; cached.
    pub is_macro_body: Option<bool>,
}

impl Program {
    /// The sequence and program numbers of the text.
    pub fn labels(&mut self, text: &[u8]) -> &Labels {
        self.labels.get_or_insert_with(|| Labels::new(text))
    }

    /// Whether the block at byte `start` of the main program is read for the first time. It counts as read
    /// afterwards.
    #[inline]
    pub fn is_first_reading(&mut self, start: u32) -> bool {
        let is_first = start >= self.unread_from;
        if is_first {
            self.unread_from = start + 1;
        }
        is_first
    }

    /// Whether no block of the main program from byte `start` on has been read.
    pub fn is_unread_from(&self, start: u32) -> bool {
        start >= self.unread_from
    }

    /// Records a jump, call or loop. `by`: the words of its block.
    pub fn jump_by(&mut self, by: Span) {
        self.has_left_linear_order = true;
        self.jumped_by = Some(by);
    }

    /// Records that a loop is skipped.
    pub fn skip_loop(&mut self) {
        self.has_left_linear_order = true;
    }

    /// Whether a jump, call or loop has left the linear order of the text.
    pub fn has_left_linear_order(&self) -> bool {
        self.has_left_linear_order
    }

    /// Whether nothing was executed or searched for outside the linear order of the text.
    pub fn is_in_linear_order(&self) -> bool {
        self.labels.is_none() && self.loop_ends.is_empty() && !self.has_left_linear_order
    }

    /// Starts the O program that begins at `head`.
    pub fn enter(&mut self, head: Resume) {
        self.heads.insert(head.byte);
    }

    /// Starts the program to run at `head`, which is not the first of the text.
    pub fn start_at_other_program(&mut self, head: Resume) {
        self.enter(head);
        self.unread_from = head.byte;
        self.has_left_linear_order = true;
        self.started_at_other_program = true;
    }

    /// Whether the program at this position has run.
    pub fn was_run(&self, at: Resume) -> bool {
        self.heads.contains(&at.byte)
    }

    /// The same program, reset so that nothing from `at` on has been read. Only valid for a program that was
    /// read in linear order.
    pub fn reset_at(self, at: Resume, work: usize) -> Self {
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
        assert!(program.is_in_linear_order());
        program.labels(b"N10 G00 X10");
        assert!(!program.is_in_linear_order() && !program.has_left_linear_order());
        let mut program = Program::default();
        program.jump_by(Span::new(0, 3));
        assert!(!program.is_in_linear_order() && program.has_left_linear_order());
    }

    #[test]
    fn going_back_forgets_what_was_read_after() {
        let mut program = Program::default();
        program.enter(at(0));
        program.enter(at(40));
        assert!(program.is_first_reading(60));
        let mut program = program.reset_at(at(40), 7);
        assert!(program.was_run(at(0)) && !program.was_run(at(40)));
        assert!(program.is_first_reading(40) && program.is_in_linear_order() && program.budget.work == 7);
    }

    #[test]
    fn a_program_chosen_by_its_number_begins_at_its_head() {
        let mut program = Program::default();
        program.start_at_other_program(at(40));
        assert!(program.was_run(at(40)) && program.started_at_other_program && !program.is_in_linear_order());
        assert!(!program.is_first_reading(0) && program.is_first_reading(40));
    }
}
