//! Tokens, words and blocks as written. Must not know what they mean to a control.

pub mod block;
pub mod highlight;
pub mod lexer;
pub(crate) mod long_comment;
mod lost_letter;
pub mod misread;
pub mod parser;
pub mod plain_line;
mod plain_words;
pub mod program_name;
