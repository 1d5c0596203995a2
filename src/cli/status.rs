//! How a command ended.
//!
//! In: what was found. Out: the exit status of the process.

use std::process::{ExitCode, Termination};

/// What the exit status says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Status {
    /// 0: no errors.
    Right = 0,
    /// 1: errors in a program, or programs that differ where that was asked.
    Faulty = 1,
    /// 2: bad usage, or a file that cannot be read or written.
    Unusable = 2,
}

impl Status {
    /// Errors, if there are any.
    pub(super) fn faulty_if(has_errors: bool) -> Self {
        if has_errors { Self::Faulty } else { Self::Right }
    }

    /// What `diff` answers a script.
    pub(super) fn differing_if(differ: bool) -> Self {
        if differ { Self::Faulty } else { Self::Right }
    }
}

impl Termination for Status {
    fn report(self) -> ExitCode {
        ExitCode::from(self as u8)
    }
}
