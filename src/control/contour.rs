//! Contours between blocks ns and nf, as the cycles G70 to G73 name them (GSK980TDb p. 102).
//!
//! Plain values. How they are read is in `interpreter/contours`.

use crate::geometry::Point;
use crate::source::Span;

/// The places manuals name in a cycle along a contour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Landmarks {
    /// The cycle block.
    pub span: Span,
    /// A: where the cycle starts.
    pub start: Point,
    /// A′: where the contour begins.
    pub first: Point,
    /// B: where the contour ends.
    pub last: Point,
    /// What is added to these for a place on the workpiece.
    pub zero: Point,
    /// P and Q.
    pub named: (u32, u32),
    /// Whether it was roughed there.
    pub roughed: bool,
}

/// What the block ns names.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FirstBlock {
    /// X or U.
    pub x: bool,
    /// Z or W.
    pub z: bool,
    /// `U0`, the idiom that asks for type II of G72.
    pub u_zero: bool,
    /// `W0`, the same for G71.
    pub w_zero: bool,
    /// The word of X or U.
    pub x_word: Span,
    /// The word of Z or W.
    pub z_word: Span,
}

/// What a shape is read for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// G71 to G73: F, S, T and compensation of the blocks are ignored.
    Roughing,
    /// G70: they are not.
    Finishing,
}
