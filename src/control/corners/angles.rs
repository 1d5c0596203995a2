//! End points from angle words, and intersections of two lines given by angles (§3.2.2).
//!
//! Angles are in radians, counter-clockwise from +Z with X up. An angle gives a *line*, not a direction along
//! it: `A30` and `A210` are the same, since the end point gives the direction. (Programs write `X-21.75,A30`
//! and `X109.83 A-30` for tapers that run towards -Z.)

use super::{ANGLE_ALLOWANCE, CornerError};
use crate::geometry::Point;

/// The end of a move given by an angle and X (radius, mm) or Z: `Z = Z0 + (r - r0) / tan A`, or
/// `r = r0 + (Z - Z0) · tan A`.
///
/// With both, the end point is as given, if its direction is within [`ANGLE_ALLOWANCE`] of the angle. With
/// neither, this is an error; the end follows from the next block ([`after_angle`]).
pub fn end_by_angle(from: Point, angle: f64, x: Option<f64>, z: Option<f64>) -> Result<Point, CornerError> {
    match (x, z) {
        (Some(x), Some(z)) => {
            let end = Point::new(x, z);
            let actual = (end.x - from.x).atan2(end.z - from.z);
            if !end.is_same(from) && between(angle, actual) > ANGLE_ALLOWANCE {
                return Err(CornerError::AngleDisagrees { actual });
            }
            Ok(end)
        }
        (Some(x), None) => {
            check_intersection(angle, 0.0)?;
            Ok(Point::new(x, from.z + (x - from.x) * angle.cos() / angle.sin()))
        }
        (None, Some(z)) => {
            check_intersection(angle, std::f64::consts::FRAC_PI_2)?;
            Ok(Point::new(from.x + (z - from.z) * angle.tan(), z))
        }
        (None, None) => Err(CornerError::NoEndPoint),
    }
}

/// Intersection of the line through `from` at the first angle and the line through `to` at the second: the
/// end of a block with only an angle.
pub fn meet(from: Point, first_angle: f64, to: Point, second_angle: f64) -> Result<Point, CornerError> {
    check_intersection(first_angle, second_angle)?;
    let (dx, dz) = (to.x - from.x, to.z - from.z);
    let along = (dz * second_angle.sin() - dx * second_angle.cos()) / (second_angle - first_angle).sin();
    Ok(Point::new(from.x + along * first_angle.sin(), from.z + along * first_angle.cos()))
}

/// The end of an angle-only block from X (radius, mm), Z and angle of the next block, by [`meet`].
///
/// X and Z of the next block are absolute, because increments would be relative to the unknown point. Only
/// one of X and Z, with an angle, leaves a whole line of solutions: [`CornerError::NoEndPoint`]. Without an
/// angle, or with only an angle: [`CornerError::NextIncomplete`].
pub fn after_angle(
    from: Point,
    first_angle: f64,
    x: Option<f64>,
    z: Option<f64>,
    second_angle: Option<f64>,
) -> Result<Point, CornerError> {
    match (x, z, second_angle) {
        (Some(x), Some(z), Some(second_angle)) => meet(from, first_angle, Point::new(x, z), second_angle),
        (Some(_), None, Some(_)) | (None, Some(_), Some(_)) => Err(CornerError::NoEndPoint),
        (None, None, Some(_)) | (_, _, None) => Err(CornerError::NextIncomplete),
    }
}

/// Checks that two lines at these angles have an intersection that is not too far away.
fn check_intersection(first: f64, second: f64) -> Result<(), CornerError> {
    let between = between(first, second);
    // Written so that NaN has no solution either.
    if between > ANGLE_ALLOWANCE { Ok(()) } else { Err(CornerError::NoSolution { between }) }
}

/// The smaller angle between two lines, radians, 0 to π/2.
fn between(first: f64, second: f64) -> f64 {
    let angle = (second - first).rem_euclid(std::f64::consts::PI);
    angle.min(std::f64::consts::PI - angle)
}
