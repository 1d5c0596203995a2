//! Every bound in one place, so that no program can hang a page or exhaust its memory. Each has its message.

/// What a run may use up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Longest text, bytes.
    pub text: usize,
    /// Most motions that are kept.
    pub motions: usize,
    /// Most messages that are kept.
    pub messages: usize,
}

impl Default for Limits {
    fn default() -> Self {
        Self { text: 64 << 20, motions: 4_000_000, messages: 500 }
    }
}

/// Most words, and comments, of one block; a control takes far fewer.
pub const WORDS_PER_BLOCK: usize = 64;
