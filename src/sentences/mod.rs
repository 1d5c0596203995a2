//! All texts in all languages: the sentences of the messages, and the words shown beside them.

pub mod assist;
pub mod codes;
pub mod difference;
pub mod labels;
mod language;
mod phrases;
mod template;
#[cfg(test)]
mod tests;
mod texts;

pub use language::Language;
pub use phrases::{describe_motion, describe_rewrite};
pub use template::Sentence;
