//! The rows for the programs in a manual, other than their messages.

use serde::Serialize;

/// A row with its place in a manual.
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

/// A fault in the element around a program.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ElementNote {
    /// `element-not-closed`, `attribute-wrong` or `setup-unreadable`; distinguishes the row from messages.
    pub note: &'static str,
    /// The same as a text.
    pub message: String,
}
