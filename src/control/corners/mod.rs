//! Chamfers, rounded corners and angle words: the geometry between two blocks.
//!
//! In: two moves that meet in a virtual corner, or points and angles; mm, radius, radians. Out: the shortened
//! moves and the piece inserted between them, or end points; otherwise the [`CornerError`]. Knows nothing of
//! letters, except in [`check_signed`], and not which control reads which form (GSK980TDi p. 96, NCT 2000M p.
//! 120).

mod angles;
mod join;
#[cfg(test)]
mod tests;

pub use angles::{after_angle, end_by_angle, meet};
pub use join::join;

use crate::cycles::{Piece, sign};
use crate::geometry::SAME;

/// Two directions that differ by less than this, radians (1°), make no corner and no intersection. The
/// control refuses an angle word this close to the axis whose coordinate it leaves open, since the path to
/// the end would be too long. It leaves out the chamfer or rounding of such a corner. \[K\]
pub const ANGLE_ALLOWANCE: f64 = std::f64::consts::PI / 180.0;

/// What replaces the virtual corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Corner {
    /// A straight piece; the value is the straight distance from the corner to each of its ends, mm.
    Chamfer(f64),
    /// An arc tangent to both moves; the value is its radius, mm.
    Round(f64),
}

/// Two moves and the piece between them: each piece begins at the end of the previous one.
///
/// A move that is used up completely is a line without length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joined {
    /// The first move, shortened at its end.
    pub first: Piece,
    /// The chamfer or arc; `None` if it is too small to matter.
    pub inserted: Option<Piece>,
    /// The second move, shortened at its start: the `first` of the next corner.
    pub second: Piece,
}

/// One of the two moves at a corner.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// The move with the chamfer or rounding word, which ends at the corner.
    First,
    /// The next move, which begins at the corner.
    Second,
}

/// The letter of a chamfer or rounding without comma.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Letter {
    /// Chamfer, towards the axis that moves next.
    C,
    /// Chamfer towards X: from a move along Z.
    I,
    /// Chamfer towards Z: from a move along X.
    K,
    /// Rounding, towards the axis that moves next.
    R,
}

/// Why there is no corner or no end point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CornerError {
    /// A move is shorter than the part that the chamfer or rounding removes.
    TooLong {
        /// The move that is too short.
        side: Side,
        /// Length that the corner needs, mm. On an arc: straight for a chamfer, along the arc for a rounding.
        needed: f64,
        /// Length of the move, mm, measured in the same way.
        available: f64,
    },
    /// No arc of this radius, mm, touches both moves: one of them is an arc and bends away or is too small.
    NoFit {
        /// The programmed radius, mm.
        radius: f64,
    },
    /// The second move continues straight, or goes back the same way.
    NoCorner {
        /// Angle from the first direction to the second, radians, counter-clockwise: near 0 straight, near ±π
        /// back.
        turn: f64,
    },
    /// The value of a chamfer or rounding is negative where the sign has no meaning; it has one only without
    /// comma.
    Negative {
        /// The value, mm.
        value: f64,
    },
    /// A chamfer or rounding without comma in a move that is not along one axis.
    FirstNotAlongAxis,
    /// The move after a chamfer or rounding without comma is not along the other axis.
    SecondNotPerpendicular,
    /// I after a move along X, or K after a move along Z.
    WrongLetter,
    /// The sign of a chamfer or rounding without comma differs from the direction of the next move.
    WrongSign,
    /// The angle gives no end point: it is nearly parallel to the axis whose coordinate is open, or both
    /// lines are nearly parallel.
    NoSolution {
        /// The angle between the two lines, or to the axis, radians, 0 to [`ANGLE_ALLOWANCE`].
        between: f64,
    },
    /// Not enough coordinates for an end point.
    NoEndPoint,
    /// The block after an angle-only block needs both an end point and an angle, and lacks one of them.
    NextIncomplete,
    /// X, Z and an angle in one block, and the angle differs from the direction of the end point.
    AngleDisagrees {
        /// The direction of the end point, radians, counter-clockwise from +Z.
        actual: f64,
    },
}

impl CornerError {
    /// The alarm of a FANUC control; `None` if none is known.
    ///
    /// PS0056 has the title "no end point & angle", and is raised if one of them is missing; some tables say
    /// "were specified" instead of "were not".
    pub fn alarm(&self) -> Option<&'static str> {
        match self {
            Self::TooLong { side: Side::First, .. } | Self::NoFit { .. } => Some("PS0055"),
            Self::TooLong { side: Side::Second, .. } | Self::NoCorner { .. } | Self::WrongSign => {
                Some("PS0051")
            }
            Self::SecondNotPerpendicular => Some("PS0052"),
            Self::FirstNotAlongAxis => Some("PS0054"),
            Self::WrongLetter => Some("PS0306"),
            Self::NextIncomplete => Some("PS0056"),
            Self::NoSolution { .. } => Some("PS0057"),
            Self::NoEndPoint => Some("PS0058"),
            Self::Negative { .. } | Self::AngleDisagrees { .. } => None,
        }
    }
}

/// Checks the forms without comma and without direct drawing: both moves along an axis and at right angles,
/// the letter of the right axis, the sign of the direction of the next move (§3.2.1).
///
/// A value of 0 has no wrong sign. The corner itself is then made by `join` with the absolute value.
pub fn check_signed(first: &Piece, second: &Piece, letter: Letter, value: f64) -> Result<(), CornerError> {
    let first_axis = axis(first).ok_or(CornerError::FirstNotAlongAxis)?;
    if second.is_empty() {
        return Err(CornerError::TooLong { side: Side::Second, needed: value.abs(), available: 0.0 });
    }
    let second_axis = axis(second).ok_or(CornerError::SecondNotPerpendicular)?;
    if first_axis == second_axis {
        return Err(CornerError::SecondNotPerpendicular);
    }
    let direction = match second_axis {
        Axis::X => second.to.x - second.from.x,
        Axis::Z => second.to.z - second.from.z,
    };
    match (letter, second_axis) {
        (Letter::I, Axis::Z) | (Letter::K, Axis::X) => Err(CornerError::WrongLetter),
        (Letter::I, Axis::X) | (Letter::K, Axis::Z) | (Letter::C | Letter::R, _) => {
            if value.abs() > SAME && sign(value) != sign(direction) {
                return Err(CornerError::WrongSign);
            }
            Ok(())
        }
    }
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Axis {
    X,
    Z,
}

/// The one axis along which a straight piece moves.
fn axis(piece: &Piece) -> Option<Axis> {
    let x_moves = (piece.to.x - piece.from.x).abs() > SAME;
    let z_moves = (piece.to.z - piece.from.z).abs() > SAME;
    match (piece.arc, x_moves, z_moves) {
        (None, true, false) => Some(Axis::X),
        (None, false, true) => Some(Axis::Z),
        (None, true, true) | (None, false, false) | (Some(_), _, _) => None,
    }
}
