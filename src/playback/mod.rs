//! The program as time: how long each motion takes, where the tool is at any moment, and where steps end.
//!
//! In: the motions and the machine's rates. Out: times, places, totals. Must not know the part.

pub mod clock;
pub mod holds;
pub mod steps;
pub mod timing;
pub mod totals;
