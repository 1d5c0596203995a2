//! What a picture is made of.
//!
//! In: a run, and how far it is. Out: [`Source`], which distinguishes a picture from those of every other
//! run, and from the unfinished ones of its own; [`Picture`], what a painter draws.

use super::Scene;
use super::view::View;
use crate::run::RunId;

/// What a painter draws, all of it of one run.
#[derive(Clone, Copy, Debug)]
pub struct Picture<'a> {
    /// What there is to see.
    pub scene: Scene<'a>,
    /// How it is looked at.
    pub view: &'a View,
    /// The run, and how far it is.
    pub source: Source,
}

/// Of which run a picture is, and how much of it was known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Source {
    /// The run.
    pub run: RunId,
    /// How far it was.
    pub stage: Stage,
}

/// How far a run is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// The program runs: there is a part of its path.
    Running,
    /// The program has run: there is its path, and no part yet.
    Path,
    /// All material is off: there is all there will be.
    Whole,
}
