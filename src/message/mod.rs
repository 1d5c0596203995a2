//! Messages to the user: the problem, its position, the effect on a control, and the fix.
//!
//! In: a message with its arguments and a position. Out: the type that reaches the page and the command line,
//! in one list. Contains no sentences; these are in `sentences`.

mod diagnostic;
pub mod levels;
mod rule;
mod variants;

pub use diagnostic::{Diagnostic, Edit, Fix, Repair, applied, sort_by_place};
pub use levels::Levels;
pub use rule::{Group, Kind, Rule, Severity};
pub use variants::{Arguments, Message, RULES, Said, Value, said};
