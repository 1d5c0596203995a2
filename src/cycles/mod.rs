//! Canned cycles: one call of a cycle to its moves. Pure geometry; called by the
//! interpreter, never the reverse.

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
    /// The part it plays.
    pub step: Step,
    /// Pass from 1; 0 for moves between the passes (to the first, along the contour at the end, home).
    pub pass: u32,
    /// Where it ends.
    pub to: Point,
    /// Centre, of arcs only.
    pub center: Option<Point>,
}

impl Move {
    /// A straight move.
    pub fn new(kind: MotionKind, step: Step, pass: u32, to: Point) -> Self {
        Self { kind, step, pass, to, center: None }
    }

    /// A move along a piece of a contour, cut at feed.
    pub fn along(piece: &Piece, step: Step, pass: u32) -> Self {
        let (kind, center) = match piece.arc {
            None => (MotionKind::Feed, None),
            Some((center, Turn::Clockwise)) => (MotionKind::ArcClockwise, Some(center)),
            Some((center, Turn::Counterclockwise)) => (MotionKind::ArcCounterclockwise, Some(center)),
        };
        Self { kind, step, pass, to: piece.to, center }
    }
}

/// A straight or round piece of the contour that blocks ns to nf describe.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece {
    /// Where it begins.
    pub from: Point,
    /// Where it ends.
    pub to: Point,
    /// Centre and turn of an arc.
    pub arc: Option<(Point, Turn)>,
}

impl Piece {
    /// The same piece elsewhere: `x` a radius, mm.
    pub fn shifted(self, x: f64, z: f64) -> Self {
        let shift = |point: Point| Point::new(point.x + x, point.z + z);
        Self {
            from: shift(self.from),
            to: shift(self.to),
            arc: self.arc.map(|(center, turn)| (shift(center), turn)),
        }
    }

    /// Whether it leads nowhere: a full circle does not.
    pub fn is_empty(&self) -> bool {
        self.from.is_same(self.to) && self.arc.is_none()
    }
}

/// How the first block of a contour (ns) moves: the infeed of every pass does the same.
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

/// The finished contour as blocks ns to nf give it.
#[derive(Clone, Debug, PartialEq)]
pub struct Contour {
    /// A: where the tool stands when the cycle is called.
    pub start: Point,
    /// B: the end of the first block (ns), where the contour begins.
    pub first: Point,
    /// How the tool gets from A to B.
    pub approach: Approach,
    /// From B to the end, each beginning where the one before ends; none of them empty.
    pub pieces: Vec<Piece>,
}

impl Contour {
    /// The end of the contour.
    pub fn last(&self) -> Point {
        self.pieces.last().map_or(self.first, |piece| piece.to)
    }
}

/// The sign of a length; lengths of no more than [`SAME`] have none.
pub fn sign(value: f64) -> f64 {
    if value > SAME {
        1.0
    } else if value < -SAME {
        -1.0
    } else {
        0.0
    }
}
