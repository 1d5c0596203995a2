//! The centre of a G02 or G03 arc from R or from I and K.
//!
//! In: start, end and the words of the block, in mm. Out: the centre, or the error (FANUC 16/18-T B-62754EN
//! p. 67, GSK980TDb p. 72).

use crate::geometry::{Point, SAME, Turn};

/// Largest difference between the distances of start and end from the centre, mm (parameter 3410).
pub const RADIUS_TOLERANCE: f64 = 0.01;

/// How the centre is given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CenterWords {
    /// R, mm; negative for an arc of more than 180°.
    Radius(f64),
    /// I and K: from the start to the centre, mm, I a radius value.
    Offset {
        /// Along X, radius.
        i: f64,
        /// Along Z.
        k: f64,
    },
}

/// Why the arc does not exist.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ArcError {
    /// The diameter is smaller than the distance between start and end.
    RadiusTooSmall {
        /// From start to end, mm.
        distance: f64,
    },
    /// Start and end have different distances from the centre, mm.
    EndOffCircle {
        /// From the centre to the start.
        start_radius: f64,
        /// From the centre to the end.
        end_radius: f64,
    },
}

/// The centre of an arc. `None` if R defines no arc because start and end are the same point.
pub fn center(start: Point, end: Point, turn: Turn, words: CenterWords) -> Result<Option<Point>, ArcError> {
    match words {
        CenterWords::Radius(_) if start.is_same(end) => Ok(None),
        CenterWords::Radius(radius) => by_radius(start, end, turn, radius).map(Some),
        CenterWords::Offset { i, k } => {
            let center = Point::new(start.x + i, start.z + k);
            let (start_radius, end_radius) = (start.distance(center), end.distance(center));
            if (start_radius - end_radius).abs() > RADIUS_TOLERANCE || start_radius <= SAME {
                return Err(ArcError::EndOffCircle { start_radius, end_radius });
            }
            Ok(Some(center))
        }
    }
}

/// The centre is on the perpendicular through the middle of the chord: for a short arc to the right of the
/// direction of travel with G02, to the left with G03; on the other side if R is negative.
fn by_radius(start: Point, end: Point, turn: Turn, radius: f64) -> Result<Point, ArcError> {
    let chord = start.distance(end);
    let half = chord / 2.0;
    if half - radius.abs() > RADIUS_TOLERANCE {
        return Err(ArcError::RadiusTooSmall { distance: chord });
    }
    let height = (radius * radius - half * half).max(0.0).sqrt();
    let left = match turn {
        Turn::Clockwise => -height,
        Turn::Counterclockwise => height,
    };
    let left = if radius < 0.0 { -left } else { left };
    let (along_z, along_x) = ((end.z - start.z) / chord, (end.x - start.x) / chord);
    Ok(Point::new((start.x + end.x) / 2.0 + along_z * left, (start.z + end.z) / 2.0 - along_x * left))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Arc;

    #[test]
    fn r_arcs_turn_as_commanded_whatever_the_direction() {
        for (end_x, end_z) in [(5.0, -3.0), (-5.0, -3.0), (5.0, 3.0), (-5.0, 3.0), (0.0, 4.0), (4.0, 0.0)] {
            let (start, end) = (Point::new(10.0, 0.0), Point::new(10.0 + end_x, end_z));
            for turn in [Turn::Clockwise, Turn::Counterclockwise] {
                for radius in [6.0, -6.0] {
                    let found = center(start, end, turn, CenterWords::Radius(radius)).unwrap().unwrap();
                    let arc = Arc { start, end, center: found, turn };
                    assert!((arc.radius() - 6.0).abs() < 1e-9);
                    assert!((end.distance(found) - 6.0).abs() < 1e-9);
                    let long = arc.sweep().abs() > std::f64::consts::PI;
                    assert_eq!(long, radius < 0.0, "{end:?} {turn:?} {radius}");
                }
            }
        }
    }

    #[test]
    fn an_end_off_the_circle_is_told() {
        let offset = CenterWords::Offset { i: 0.0, k: -5.0 };
        let end = Point::new(10.0, -10.5);
        let wrong = center(Point::new(10.0, 0.0), end, Turn::Clockwise, offset);
        assert!(matches!(wrong, Err(ArcError::EndOffCircle { .. })));
    }
}
