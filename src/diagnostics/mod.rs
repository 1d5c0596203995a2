//! Messages to the user: what is wrong, where, what a control would do, and the repair.

mod diagnostic;
pub mod levels;
mod message;
pub mod messages;
mod rule;

pub use diagnostic::{Diagnostic, Edit, Fix, Repair, sort_by_place};
pub use levels::Levels;
pub use message::{Arguments, Message, RULES, Value};
pub use rule::{Group, Kind, Rule, Severity};
