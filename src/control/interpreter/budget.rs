//! The limits of a run: steps of blocks and macros, repeats, rounds of loops.

use super::Interpreter;
use crate::message::Message;
use crate::source::Span;
use crate::text::block::Block;

impl Interpreter {
    /// Counts a block that is read or executed again because of another one. False: the limit is exceeded.
    pub(super) fn count_repeat(&mut self, block: &Block, cause: &Block) -> bool {
        let span = self.program.jumped_by.unwrap_or_else(|| cause.words_span());
        let spent = self.program.budget.repeat(block.span.len(), &self.setup.limits);
        self.check_budget(spent, span)
    }

    /// Counts a round of a loop or call. False: the limit is exceeded, and the run ends here.
    pub(super) fn count_round(&mut self, block: &Block) -> bool {
        let span = self.program.jumped_by.unwrap_or_else(|| block.words_span());
        let spent = self.program.budget.round(&self.setup.limits);
        self.check_budget(spent, span)
    }

    /// Counts a macro statement or expression after the program has left the linear order of the text. False:
    /// the limit is exceeded, and the run ends here.
    pub(super) fn count_macro_step(&mut self, block: &Block) -> bool {
        if !self.program.has_left_linear_order() {
            return !self.sink.is_full();
        }
        let spent = self.program.budget.macro_step(&self.setup.limits);
        self.check_budget(spent, block.words_span())
    }

    /// Counts steps without a motion. False: the limit is exceeded, and the run ends here.
    pub(super) fn spend(&mut self, steps: usize, block: &Block) -> bool {
        let spent = self.program.budget.work(steps, &self.setup.limits);
        self.check_budget(spent, block.words_span())
    }

    /// Ends the run if a limit is exceeded. Returns whether it continues.
    #[inline]
    fn check_budget(&mut self, spent: Result<(), Message>, span: Span) -> bool {
        if let Err(message) = spent {
            self.sink.end(message, span);
        }
        !self.sink.is_full()
    }
}
