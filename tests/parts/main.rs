//! The part that a program makes, against geometry of the tests' own.
mod contours;
mod gallery;
mod inferred;
mod invariants;
mod reach;
mod threads;
mod worked;
