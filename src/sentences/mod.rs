//! All texts in all languages: the sentences of the messages, and the words shown beside them.

pub mod assist;
pub mod calculate;
pub mod codes;
mod descriptions;
pub mod difference;
pub mod exercise;
pub mod exercise_file;
pub mod labels;
mod language;
mod phrases;
pub mod server;
mod template;
#[cfg(test)]
mod tests;
mod texts;

pub use descriptions::{describe_motion, describe_rewrite};
pub use language::Language;
pub use template::Sentence;
