//! Exercises: a task with a blank, tools, the outline of the wanted part and checks; and the report on an answer.
//!
//! In: the text of an exercise file, and the program of an answer. Out: an [`Exercise`], or a [`ReadError`] with its
//! line; a [`Report`]. An exercise contains the outline of the part with tolerances, never a program that makes it.
//! Must not know languages: `sentences` has the texts.

mod answer;
mod checks;
mod codes;
mod depth;
mod edge;
mod fault;
mod flats;
mod head;
mod measure;
mod outline;
mod quantity;
mod read;
mod report;
mod same_text;
mod shape;
mod slip;
mod target;
mod target_of;
mod texts;
mod values;

pub use checks::{Check, Checked, Checks, Finding};
pub use edge::{Edge, Size, ThreadOf};
pub use fault::{Part, Problem, ReadError, TargetFault};
pub use flats::Flats;
pub use quantity::{Measured, Quantity};
pub use report::{Place, Report, Verdict, check};
pub use same_text::key_of;
pub use slip::{Cause, Slip};
pub use target::Target;
pub use target_of::{NoTarget, blocks_of_exercise, target_of};
pub use texts::Texts;
pub use values::{Range, Tolerance};

use crate::setup::Setup;

/// An exercise.
#[derive(Clone, Debug, PartialEq)]
pub struct Exercise {
    /// Its name in files and links: small letters, digits and hyphens.
    pub id: String,
    /// What the learner does.
    pub kind: Kind,
    /// Points for a passed answer.
    pub points: u32,
    /// The page of the manual that it practises.
    pub chapter: Option<String>,
    /// Blank, tools, control and machine of every answer.
    pub setup: Setup,
    /// The block of the file that they were read from: JSON, or comments.
    pub setup_text: String,
    /// The program that the learner starts with; may be empty.
    pub program: String,
    /// The wanted part.
    pub target: Target,
    /// The tolerance of sizes without their own, mm.
    pub tolerance: Tolerance,
    /// What is checked besides the part.
    pub checks: Checks,
    /// Title, task and hints in English, Chinese and Russian; at least one language is present.
    pub texts: [Option<Texts>; 3],
}

/// What the learner does in an exercise.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Kind {
    /// Write the program.
    #[default]
    Write,
    /// Find the fault in the given program.
    Fault,
    /// Predict where motions of the given program end.
    Predict,
    /// Put the given blocks in order.
    Order,
    /// Fill in the blanks of the given program.
    Blanks,
}

impl Kind {
    /// All kinds.
    pub const ALL: [Self; 5] = [Self::Write, Self::Fault, Self::Predict, Self::Order, Self::Blanks];

    /// Its name in a file.
    pub fn name(self) -> &'static str {
        match self {
            Self::Write => "write",
            Self::Fault => "fault",
            Self::Predict => "predict",
            Self::Order => "order",
            Self::Blanks => "blanks",
        }
    }

    /// Whether the exercise needs a program to start with.
    pub fn needs_program(self) -> bool {
        self != Self::Write
    }
}

impl Exercise {
    /// Reads an exercise file.
    ///
    /// # Errors
    ///
    /// The first fault of the file, with its line.
    pub fn read(text: &str) -> Result<Self, ReadError> {
        read::read(text)
    }

    /// The texts of a language, by its index in the list of languages; if it is missing, the texts of the first
    /// language that is present.
    pub fn texts(&self, language: usize) -> Option<&Texts> {
        let own = self.texts.get(language).and_then(Option::as_ref);
        own.or_else(|| self.texts.iter().flatten().next())
    }
}
