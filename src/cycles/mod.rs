//! Canned cycles: expands one call of a cycle to its moves. Pure geometry; called by the interpreter, never
//! the reverse.

pub mod drilling;
pub mod grooving;
#[cfg(test)]
mod listing;
pub mod pattern;
pub mod roughing;
pub mod single;
pub mod threading;
pub mod units;

use crate::geometry::{Point, SAME, Turn};
use crate::motion::{MotionKind, Step};

/// One move of a cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Move {
    /// Rapid, feed, arc or thread.
    pub kind: MotionKind,
    /// The step of the cycle.
    pub step: Step,
    /// Pass, from 1; 0 for moves outside of the passes (to the first pass, along the contour at the end, to
    /// the start point).
    pub pass: u32,
    /// End point.
    pub to: Point,
    /// Centre, for arcs only.
    pub center: Option<Point>,
}

impl Move {
    /// A straight move.
    pub fn new(kind: MotionKind, step: Step, pass: u32, to: Point) -> Self {
        Self { kind, step, pass, to, center: None }
    }

    /// A move along a piece of a contour at feed.
    pub fn along(piece: &Piece, step: Step, pass: u32) -> Self {
        let (kind, center) = match piece.arc {
            None => (MotionKind::Feed, None),
            Some((center, Turn::Clockwise)) => (MotionKind::ArcClockwise, Some(center)),
            Some((center, Turn::Counterclockwise)) => (MotionKind::ArcCounterclockwise, Some(center)),
        };
        Self { kind, step, pass, to: piece.to, center }
    }
}

/// A line or arc of the contour in blocks ns to nf.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece {
    /// Start point.
    pub from: Point,
    /// End point.
    pub to: Point,
    /// Centre and direction of an arc.
    pub arc: Option<(Point, Turn)>,
}

impl Piece {
    /// The piece displaced by `x` (a radius) and `z`, mm.
    pub fn shifted(self, x: f64, z: f64) -> Self {
        let shift = |point: Point| Point::new(point.x + x, point.z + z);
        Self {
            from: shift(self.from),
            to: shift(self.to),
            arc: self.arc.map(|(center, turn)| (shift(center), turn)),
        }
    }

    /// Whether the piece has no length. A full circle has one.
    pub fn is_empty(&self) -> bool {
        self.from.is_same(self.to) && self.arc.is_none()
    }
}

/// Motion of the first block of a contour (ns), which the infeed of every pass uses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Approach {
    /// G00.
    Rapid,
    /// G01.
    Feed,
}

impl Approach {
    /// The kind of motion.
    pub fn kind(self) -> MotionKind {
        match self {
            Self::Rapid => MotionKind::Rapid,
            Self::Feed => MotionKind::Feed,
        }
    }
}

/// The finished contour in blocks ns to nf.
#[derive(Clone, Debug, PartialEq)]
pub struct Contour {
    /// A: position of the tool when the cycle is called.
    pub start: Point,
    /// B: the end of the first block (ns), where the contour begins.
    pub first: Point,
    /// Motion from A to B.
    pub approach: Approach,
    /// The pieces from B to the end, each beginning at the end of the last one; none of them is empty.
    pub pieces: Vec<Piece>,
}

impl Contour {
    /// The end of the contour.
    pub fn last(&self) -> Point {
        self.pieces.last().map_or(self.first, |piece| piece.to)
    }
}

/// The sign of a length; zero for lengths of at most [`SAME`].
pub fn sign(value: f64) -> f64 {
    if value > SAME {
        1.0
    } else if value < -SAME {
        -1.0
    } else {
        0.0
    }
}
