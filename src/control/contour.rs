//! Contours between the blocks ns and nf of the cycles G70 to G73 (GSK980TDb p. 102).
//!
//! Plain values. `interpreter/contours` reads them.

use crate::geometry::Point;
use crate::source::Span;

/// The points that manuals name in a contour cycle.
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
    /// Offset that makes these points positions on the workpiece.
    pub zero: Point,
    /// P and Q.
    pub named: (u32, u32),
    /// Whether a roughing cycle has run there.
    pub roughed: bool,
}

/// Contents of the block ns.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FirstBlock {
    /// X or U.
    pub x: bool,
    /// Z or W.
    pub z: bool,
    /// `U0`: selects type II for G72.
    pub u_zero: bool,
    /// `W0`: selects type II for G71.
    pub w_zero: bool,
    /// The word of X or U.
    pub x_word: Span,
    /// The word of Z or W.
    pub z_word: Span,
}

/// Why a contour is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ContourUse {
    /// G71 to G73: F, S, T and compensation of the blocks are ignored.
    Roughing,
    /// G70: F, S, T and compensation of the blocks take effect.
    Finishing,
}
