//! Messages to the user: what is wrong, where, what a control would do, and the fix.
//!
//! In: a message with its arguments, at a place. Out: what travels, in one list, to the page and the command
//! line. Knows no sentence: `sentences` says it.

mod diagnostic;
pub mod levels;
mod rule;
mod variants;

pub use diagnostic::{Diagnostic, Edit, Fix, Repair, sort_by_place};
pub use levels::Levels;
pub use rule::{Group, Kind, Rule, Severity};
pub use variants::{Arguments, Message, RULES, Said, Value, said};
