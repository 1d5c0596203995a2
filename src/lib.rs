//! A lathe G-code playground: program text in, tool motions and messages out.

pub mod control;
pub mod geometry;
pub mod motion;
pub mod scene;
pub mod text;
