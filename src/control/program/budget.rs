//! Limits on reading blocks again, and on steps without a motion.
//!
//! In: each such step. Out: the message of the exceeded limit (`limits`).

use crate::limits::Limits;
use crate::message::{Message, said};

/// How much of each limit is used.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Budget {
    /// Steps without a motion: see [`Limits::cycle_work`].
    pub work: usize,
    /// Blocks executed in jumps, loops and calls.
    repeated: usize,
    /// The size of these blocks, bytes.
    repeated_text: usize,
    /// Rounds of loops and calls.
    rounds: usize,
    /// Macro statements and expressions in these blocks.
    macro_steps: usize,
}

impl Budget {
    /// A budget with `work` steps without a motion used, and nothing else.
    pub fn after_work(work: usize) -> Self {
        Self { work, ..Self::default() }
    }

    /// Counts a block of `bytes` that is read or executed again.
    pub fn repeat(&mut self, bytes: usize, limits: &Limits) -> Result<(), Message> {
        self.repeated += 1;
        self.repeated_text += bytes;
        let (blocks, text) = (limits.repeated_blocks, limits.repeated_text);
        if self.repeated > blocks {
            Err(said::TooManyRepeats { most: blocks }.into())
        } else if self.repeated_text > text {
            Err(said::TooMuchRepeated { most: text }.into())
        } else {
            Ok(())
        }
    }

    /// Counts a round of a loop or call.
    pub fn round(&mut self, limits: &Limits) -> Result<(), Message> {
        self.rounds += 1;
        within(self.rounds, limits.rounds, |most| said::TooManyRounds { most }.into())
    }

    /// Counts a macro statement or expression that is evaluated in a jump, loop or call.
    pub fn macro_step(&mut self, limits: &Limits) -> Result<(), Message> {
        self.macro_steps += 1;
        within(self.macro_steps, limits.macro_steps, |most| said::TooManyMacroSteps { most }.into())
    }

    /// Counts steps without a motion.
    pub fn work(&mut self, steps: usize, limits: &Limits) -> Result<(), Message> {
        self.work = self.work.saturating_add(steps);
        within(self.work, limits.cycle_work, |most| said::TooMuchWork { most }.into())
    }
}

fn within(used: usize, most: usize, exceeded: impl FnOnce(usize) -> Message) -> Result<(), Message> {
    if used > most { Err(exceeded(most)) } else { Ok(()) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_limit_is_reached_and_then_has_its_own_message() {
        let limits = Limits {
            cycle_work: 5,
            repeated_blocks: 2,
            repeated_text: 100,
            rounds: 1,
            macro_steps: 1,
            ..Limits::default()
        };
        let mut budget = Budget::default();
        assert_eq!(budget.repeat(10, &limits), Ok(()));
        assert_eq!(budget.repeat(10, &limits), Ok(()));
        assert_eq!(budget.repeat(10, &limits), Err(said::TooManyRepeats { most: 2 }.into()));
        let mut budget = Budget::default();
        assert_eq!(budget.repeat(101, &limits), Err(said::TooMuchRepeated { most: 100 }.into()));
        assert_eq!(budget.round(&limits), Ok(()));
        assert_eq!(budget.round(&limits), Err(said::TooManyRounds { most: 1 }.into()));
        assert_eq!(budget.macro_step(&limits), Ok(()));
        assert_eq!(budget.macro_step(&limits), Err(said::TooManyMacroSteps { most: 1 }.into()));
        assert_eq!(budget.work(5, &limits), Ok(()));
        assert_eq!(budget.work(usize::MAX, &limits), Err(said::TooMuchWork { most: 5 }.into()));
    }
}
