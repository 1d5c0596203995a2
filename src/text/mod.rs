//! What was written: places, tokens, words and blocks. Knows nothing of what any of it means to a control.

pub mod source;
