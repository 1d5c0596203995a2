//! Every bound in one place, so that no program can hang a page or exhaust its memory. Each has its message.

/// What a run may use up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Longest text, bytes.
    pub text: usize,
    /// Most motions that are kept.
    pub motions: usize,
    /// Most moves of one cycle call, and of the contour it reads. A bar of 1 m diameter roughed by 0.02 mm
    /// takes half as many; more is a slip of the point, and is refused as a whole.
    pub moves_per_cycle: usize,
    /// Most steps spent on what leaves no motion: each block of a contour read again (a long one takes several), each
    /// move of a cycle that is refused or leads nowhere. Keeps many cheap calls of a dear cycle from adding up.
    pub cycle_work: usize,
    /// Most blocks that are carried out through jumps, loops and calls; those run straight through do not count.
    pub repeated_blocks: usize,
    /// Most bytes of blocks that are carried out so: a block can be as long as the text.
    pub repeated_text: usize,
    /// Most subprograms called one within the other (0i-D and later).
    pub call_depth: usize,
    /// Most macros (G65, G66) called one within the other, among them.
    pub macro_depth: usize,
    /// Most messages that are kept.
    pub messages: usize,
    /// Motions from one snapshot to the next: after a change of the text, at least so many run again.
    pub stride: usize,
}

impl Default for Limits {
    fn default() -> Self {
        Self {
            text: 64 << 20,
            motions: 4_000_000,
            moves_per_cycle: 200_000,
            cycle_work: 2_000_000,
            repeated_blocks: 1_000_000,
            repeated_text: 10_000_000,
            call_depth: 10,
            macro_depth: 5,
            messages: 500,
            stride: 4096,
        }
    }
}

/// Bytes of a block of a contour that count as one step of [`Limits::cycle_work`].
pub const BYTES_PER_STEP: usize = 64;

/// Most words, and comments, of one block; a control takes far fewer.
pub const WORDS_PER_BLOCK: usize = 64;
