//! Canned cycles: one call of a cycle to its moves. Pure geometry; called by the interpreter, never the reverse.

pub mod single;
