//! The origin of a picture.
//!
//! In: a run and its progress. Out: [`Source`], which distinguishes a picture from pictures of other runs and
//! of other stages of the same run; [`Picture`], the input of a painter.

use super::Scene;
use super::view::View;
use crate::run::RunId;

/// The input of a painter, all from the same run.
#[derive(Clone, Copy, Debug)]
pub struct Picture<'a> {
    /// The scene to paint.
    pub scene: Scene<'a>,
    /// The view of the scene.
    pub view: &'a View,
    /// The run and its progress.
    pub source: Source,
}

/// The run that a picture shows, and its progress at that time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Source {
    /// The run.
    pub run: RunId,
    /// The progress of the run.
    pub stage: Stage,
}

/// The progress of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// The program is running: a part of its path is known.
    Running,
    /// The program has finished: its path is known, but the part is not.
    Path,
    /// All material is removed: everything is known.
    Whole,
}
