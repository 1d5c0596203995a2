//! The machined part, compared with independent geometry in the tests.
mod contours;
mod gallery;
mod inferred;
mod invariants;
mod reach;
mod threads;
mod worked;
