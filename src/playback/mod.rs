//! The program over time: the time of each motion, the position of the tool at a time, and steps.
//!
//! In: the motions and the machine's rates. Out: times, places, totals. Must not know the part.

pub mod clock;
pub mod holds;
pub mod steps;
pub mod timing;
pub mod totals;
