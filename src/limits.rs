//! Every bound in one place, so that no program can hang a page or exhaust its memory. Each has its message.
//!
//! Those in [`Limits`] can be set (`limits` of the setup): lower as one likes, higher up to what
//! memory and the numbers that count things have room for. The constants are those of the controls,
//! or of how things are kept.

use serde::Deserialize;

/// What a run may use up.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "camelCase")]
pub struct Limits {
    /// Longest text, bytes.
    pub text: usize,
    /// Most motions that are kept.
    pub motions: usize,
    /// Most moves of one cycle call, and of the contour it reads. A bar of 1 m diameter roughed by 0.02 mm
    /// takes half as many; more is a slip of the point, and is refused as a whole.
    pub moves_per_cycle: usize,
    /// Most steps spent on what leaves no motion: each block of a contour read again (a long one takes
    /// several), each move of a cycle that is refused or leads nowhere. Keeps many cheap calls of a
    /// dear cycle from adding up.
    pub cycle_work: usize,
    /// Most blocks that are carried out through jumps, loops and calls; those run
    /// straight through do not count.
    pub repeated_blocks: usize,
    /// Most bytes of blocks that are carried out so: a block can be as long as the text.
    pub repeated_text: usize,
    /// Most rounds of loops (`END` back to `WHILE` or `DO`) and of calls (L), all together.
    pub rounds: usize,
    /// Most macro statements, and words with an expression, that are worked out
    /// through jumps, loops and calls.
    pub macro_steps: usize,
    /// Most subprograms called one within the other (0i-D and later).
    pub call_depth: usize,
    /// Most macros (G65, G66) called one within the other, among them.
    pub macro_depth: usize,
    /// Most messages that are kept.
    pub messages: usize,
    /// Most motions of a program whose material is taken off the blank; of a longer
    /// one only the path is shown.
    pub part_motions: usize,
    /// Most corners of what is left of the blank.
    pub part_corners: usize,
    /// Most blocks of a program whose numbers are compared with each other, and a tenth of its motions.
    pub compared_blocks: usize,
    /// Motions from one snapshot to the next: after a change of the text, at least so many run again. It
    /// changes nothing that can be seen, so it is no setting.
    #[serde(skip)]
    pub stride: usize,
}

impl Default for Limits {
    fn default() -> Self {
        Self {
            text: 64 << 20,
            motions: 4_000_000,
            moves_per_cycle: 200_000,
            cycle_work: 1_000_000,
            repeated_blocks: 1_000_000,
            repeated_text: 10_000_000,
            rounds: 400_000,
            macro_steps: 1_500_000,
            call_depth: 10,
            macro_depth: 5,
            messages: 500,
            part_motions: 20_000,
            part_corners: 50_000,
            compared_blocks: 10_000,
            stride: 4096,
        }
    }
}

impl Limits {
    /// The settings by name: what is set, and the most that can be.
    pub fn settings(&self) -> [(&'static str, usize, usize); 14] {
        [
            // Places in the text and in memory are numbers of 32 bits, and a page has 4 GB.
            ("text", self.text, 256 << 20),
            ("motions", self.motions, 20_000_000),
            ("movesPerCycle", self.moves_per_cycle, 2_000_000),
            // From here on it is a matter of patience.
            ("cycleWork", self.cycle_work, 1_000_000_000),
            ("repeatedBlocks", self.repeated_blocks, 1_000_000_000),
            ("repeatedText", self.repeated_text, 1_000_000_000),
            ("rounds", self.rounds, 1_000_000_000),
            ("macroSteps", self.macro_steps, 1_000_000_000),
            ("callDepth", self.call_depth, 100),
            ("macroDepth", self.macro_depth, MACRO_LEVELS),
            ("messages", self.messages, 100_000),
            ("partMotions", self.part_motions, 1_000_000),
            ("partCorners", self.part_corners, 1_000_000),
            ("comparedBlocks", self.compared_blocks, 10_000_000),
        ]
    }

    /// Whether each is within what there is room for. The error names the one that is not.
    pub fn check(&self) -> Result<(), String> {
        match self.settings().into_iter().find(|(_, set, most)| set > most) {
            Some((name, set, most)) => Err(format!("limits.{name} is {set}; it can be {most} at most")),
            None => Ok(()),
        }
    }
}

/// Bytes of a block of a contour that count as one step of [`Limits::cycle_work`].
pub const BYTES_PER_STEP: usize = 64;

/// The number of motions, from the first of a program, from which tools and blank are inferred.
pub const INFERRED_FROM: usize = 100_000;

/// Most words, and comments, of one block; a control takes far fewer.
pub const WORDS_PER_BLOCK: usize = 64;

/// Most digits of a number (PS0003).
pub const DIGITS: u8 = 8;

/// Largest value of a variable.
pub const LARGEST_VARIABLE: f64 = 1e47;

/// Most brackets inside each other, those of functions and of `#[…]` among them (PS0118).
pub const BRACKETS: u8 = 5;

/// Most loops (`DO`) of a program that are under way, one within the other; a control takes three.
pub const LOOPS: usize = 30;

/// Levels of local variables below the main program.
pub const MACRO_LEVELS: usize = 5;

/// Most bytes of the room a page can ask for to hand a text in: twice the longest text that a setup can allow.
pub const TEXT_BUFFER: usize = 512 << 20;

/// Longest text that is searched for programs, bytes.
pub const PASTED_TEXT: usize = 16 << 20;

/// Most programs that are listed of a text; how many more there are is said.
pub const FOUND_PROGRAMS: usize = 200;

/// Most changed blocks of two versions of a program that are listed; how many more there are is said.
pub const CHANGED_BLOCKS: usize = 2000;

/// Most characters that are shown of a changed block.
pub const SHOWN_OF_BLOCK: usize = 400;
