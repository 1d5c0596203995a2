//! Faults of an exercise file.
//!
//! Values only: a [`ReadError`] has the line and the [`Problem`]. `sentences` has the texts.

use crate::message::Message;

/// The first fault of an exercise file.
#[derive(Clone, Debug, PartialEq)]
pub struct ReadError {
    /// Line, from 1.
    pub line: usize,
    /// The fault.
    pub problem: Problem,
}

impl ReadError {
    pub(super) fn at(line: usize, problem: Problem) -> Self {
        Self { line, problem }
    }
}

/// A part of an exercise file whose size or number is limited.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Bytes of the file.
    File,
    /// Lines of the head.
    Head,
    /// Codes of one check.
    Codes,
    /// Bytes of the program.
    Program,
    /// Bytes of the setup.
    Setup,
    /// Characters of a title.
    Title,
    /// Characters of a task.
    Task,
    /// Hints.
    Hints,
    /// Characters of a hint.
    Hint,
}

/// A fault of an exercise file.
#[derive(Clone, Debug, PartialEq)]
pub enum Problem {
    /// A part is longer, or has more entries, than is allowed.
    TooMany {
        /// The part.
        part: Part,
        /// Its size.
        count: usize,
        /// The limit.
        most: usize,
    },
    /// The file does not begin with `---`.
    NoHead,
    /// The head has no second `---`.
    HeadOpen,
    /// A line of the head is not `key: value`.
    HeadLine,
    /// A key of the head is unknown.
    UnknownKey {
        /// The key.
        key: String,
        /// The known key that is most similar.
        nearest: Option<&'static str>,
    },
    /// A key, block or language appears twice.
    Twice {
        /// Its name.
        name: String,
    },
    /// A key, or a block, is missing.
    Missing {
        /// Its name.
        name: &'static str,
    },
    /// The value of a key is not what the key needs.
    Value {
        /// The key.
        key: &'static str,
        /// The values that are accepted; the same in all languages.
        expected: &'static str,
    },
    /// A block of code is not closed.
    BlockOpen,
    /// A block of code has another name than `setup`, `gcode` and `target`.
    UnknownBlock {
        /// The name.
        name: String,
    },
    /// Text between the blocks and the first language.
    StrayText,
    /// A heading is not `# en: Title`, `# zh: …` or `# ru: …`.
    Heading,
    /// The title or the task is missing, or no language is present.
    NoText,
    /// A text contains HTML.
    Html,
    /// A text contains a link that is neither relative nor `https:`.
    Link,
    /// A control character.
    ControlCharacter,
    /// The setup cannot be read: the reason, in English.
    Setup {
        /// The reason.
        reason: String,
    },
    /// A value of the setup is invalid.
    SetupValue(Box<Message>),
    /// The setup has no blank.
    NoBlank,
    /// The outline of the target.
    Target(TargetFault),
}

/// A fault of the outline of a target.
#[derive(Clone, Debug, PartialEq)]
pub enum TargetFault {
    /// The first line is not a point with X and Z alone.
    First,
    /// A line contains a word that is not understood there.
    Word {
        /// The word.
        word: String,
    },
    /// A line does not move.
    NoMove,
    /// Fewer lines than an area needs.
    TooFew,
    /// More lines than [`Self::MOST_LINES`].
    TooMany {
        /// The number of lines.
        lines: usize,
    },
    /// X is negative, or a coordinate is too large.
    Range {
        /// The word.
        word: String,
    },
    /// The radius of an arc is missing, or smaller than half the distance of its ends.
    Radius,
    /// The outline crosses itself or has no area.
    Crosses,
    /// The outline ends neither on the spindle axis, nor at its first point, nor at its left end.
    End,
    /// `thread` or `width` on a line that is not a cylinder, or `angle` on one that is no cone.
    NotFor {
        /// The word.
        word: &'static str,
    },
}

impl TargetFault {
    /// Most lines of an outline.
    pub const MOST_LINES: usize = 100;
}

/// Refuses a part that is too large.
pub(super) fn at_most(part: Part, count: usize, most: usize, line: usize) -> Result<(), ReadError> {
    if count > most { Err(ReadError::at(line, Problem::TooMany { part, count, most })) } else { Ok(()) }
}
