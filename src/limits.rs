//! The limits of a run, so that no program can hang a page or exhaust its memory. A run that exceeds one of
//! [`Limits`] reports it. Limits of single functions are next to these functions.
//!
//! [`Limits`] can be set (`limits` of the setup): to any lower value, or to a higher one as far as
//! memory and the integer types allow. The constants are limits of the controls or of the data structures.

use serde::Deserialize;

/// The resources that a run may use.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema), schemars(transform = with_maxima))]
#[serde(default, deny_unknown_fields, rename_all = "camelCase")]
pub struct Limits {
    /// Maximum length of the text, bytes.
    pub text: usize,
    /// Maximum number of motions.
    pub motions: usize,
    /// Maximum moves of one cycle call, and of the contour it reads. Roughing a bar of 1 m diameter in steps
    /// of 0.02 mm takes half of the default; more are probably a misplaced decimal point, and the call is
    /// refused.
    pub moves_per_cycle: usize,
    /// Maximum steps for work that produces no motion: each block of a contour that is read again (a long one
    /// takes several steps), and each move of a cycle that is refused or has no effect. Keeps many calls of
    /// an expensive cycle from adding up.
    pub cycle_work: usize,
    /// Maximum blocks executed through jumps, loops and calls; blocks in sequence do not count.
    pub repeated_blocks: usize,
    /// Maximum bytes of such blocks, because a block can be as long as the text.
    pub repeated_text: usize,
    /// Maximum iterations of loops (`END` back to `WHILE` or `DO`) and calls (L), in total.
    pub rounds: usize,
    /// Maximum macro statements, and words with an expression, evaluated through jumps, loops and calls.
    pub macro_steps: usize,
    /// Maximum nesting of subprograms (0i-D and later).
    pub call_depth: usize,
    /// Maximum nesting of macros (G65, G66), which count as subprograms too.
    pub macro_depth: usize,
    /// Maximum number of messages.
    pub messages: usize,
    /// Maximum motions of a program whose material is removed from the blank; for a longer program only the
    /// path is shown.
    pub part_motions: usize,
    /// Maximum corners of the part.
    pub part_corners: usize,
    /// Maximum blocks of a program for the lints that compare its numbers with each other; the maximum number
    /// of motions is ten times this.
    pub compared_blocks: usize,
    /// Motions between two snapshots: after a change of the text, at least this many run again. It has no
    /// visible effect, so it is not a setting.
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
    /// The settings by name: the value, and its maximum.
    pub fn settings(&self) -> [(&'static str, usize, usize); 14] {
        [
            // Positions in text and memory are 32-bit numbers, and a page has 4 GB.
            ("text", self.text, 256 << 20),
            ("motions", self.motions, 20_000_000),
            ("movesPerCycle", self.moves_per_cycle, 2_000_000),
            // These limits only bound the run time.
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

    /// Checks that no limit exceeds its maximum. The error names the first limit that does.
    pub fn check(&self) -> Result<(), String> {
        match self.settings().into_iter().find(|(_, set, most)| set > most) {
            Some((name, set, most)) => Err(format!("limits.{name} is {set}; the maximum is {most}")),
            None => Ok(()),
        }
    }
}

/// Adds the maximum of each limit to its schema.
#[cfg(feature = "cli")]
fn with_maxima(schema: &mut schemars::Schema) {
    let Some(properties) = schema.get_mut("properties") else { return };
    for (name, _, most) in Limits::default().settings() {
        properties[name]["maximum"] = most.into();
    }
}

/// Bytes of a block of a contour that count as one step of [`Limits::cycle_work`].
pub const BYTES_PER_STEP: usize = 64;

/// Number of motions at the start of a program from which tools and blank are inferred.
pub const INFERRED_FROM: usize = 100_000;

/// Maximum points of the outline of a blank.
pub const OUTLINE_POINTS: usize = 200;

/// Maximum number of words of a block, and of its comments; a control accepts far fewer.
pub const WORDS_PER_BLOCK: usize = 64;

/// Maximum digits of a number (PS0003).
pub const MAX_DIGITS: u8 = 8;

/// Largest value of a variable.
pub const LARGEST_VARIABLE: f64 = 1e47;

/// Maximum nesting of brackets, including brackets of functions and of `#[…]` (PS0118).
pub const MAX_BRACKETS: u8 = 5;

/// Maximum nesting of loops (`DO`) in a program; a control accepts three.
pub const MAX_LOOPS: usize = 30;

/// Levels of local variables below the main program.
pub const MACRO_LEVELS: usize = 5;

/// Maximum size of a text that is read, bytes: from a page, a file or a message of an editor. Twice the
/// maximum of [`Limits::text`], so that a run reports a text that is too long.
pub const TEXT_BUFFER: usize = 512 << 20;

/// Maximum length of a text that is searched for programs, bytes.
pub const MAX_PASTED_TEXT: usize = 16 << 20;

/// Maximum number of programs listed for a text; the number of the others is reported.
pub const MAX_FOUND_PROGRAMS: usize = 200;

/// Maximum number of changed blocks listed for two versions of a program; the number of the others is
/// reported.
pub const CHANGED_BLOCKS: usize = 2000;

/// Maximum number of characters shown of a changed block.
pub const SHOWN_OF_BLOCK: usize = 400;
