//! The exit status of a command.
//!
//! In: the result of a command. Out: the exit status of the process.

use std::process::{ExitCode, Termination};

/// Exit status of the process.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Status {
    /// 0: no errors.
    Right = 0,
    /// 1: errors in a program; or, for commands that compare, programs that differ.
    Faulty = 1,
    /// 2: bad usage, or a file that cannot be read or written.
    Unusable = 2,
}

impl Status {
    /// `Faulty` if there are errors.
    pub(super) fn faulty_if(has_errors: bool) -> Self {
        if has_errors { Self::Faulty } else { Self::Right }
    }

    /// The exit status of `diff`.
    pub(super) fn differing_if(differ: bool) -> Self {
        if differ { Self::Faulty } else { Self::Right }
    }
}

impl Termination for Status {
    fn report(self) -> ExitCode {
        ExitCode::from(self as u8)
    }
}
