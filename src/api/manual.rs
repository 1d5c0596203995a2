//! What leaves the crate of the programs in a manual, beside the messages about them.

use serde::Serialize;

/// A row about a place in a manual.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct InManual<T> {
    /// Line, from 1.
    pub line: u32,
    /// Column, from 1, in UTF-16 units.
    pub column: u32,
    /// The row.
    #[serde(flatten)]
    pub row: T,
}

/// What is wrong with the element around a program.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ElementNote {
    /// `element-not-closed`, `attribute-wrong` or `setup-unreadable`: what sets the row apart from those of messages.
    pub note: &'static str,
    /// The same in words.
    pub message: String,
}
