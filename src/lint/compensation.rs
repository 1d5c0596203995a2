//! Nose radius compensation: the side that belongs to a cut.

use crate::control::codes::Compensation;
use crate::geometry::Point;

/// A cut along Z at least this many times as long as across it shows where the work is.
const ALONG: f64 = 2.0;

/// The code in force and the one that belongs to the cut, where they differ. `tip`: direction of the imaginary tip, which
/// distinguishes outside work (3) from a bore (2).
pub fn wrong_side(
    compensation: Compensation,
    tip: u8,
    from: Point,
    to: Point,
) -> Option<(&'static str, &'static str)> {
    let (dx, dz) = ((to.x - from.x).abs(), to.z - from.z);
    if dz.abs() < ALONG * dx || dz == 0.0 || from.x <= 0.0 {
        return None;
    }
    let outside = match tip {
        3 | 4 => true,
        1 | 2 => false,
        _ => return None,
    };
    // In the picture (Z to the right, X up): toward the chuck, the work outside is on the left of the way.
    let right = if outside == (dz < 0.0) { Compensation::Right } else { Compensation::Left };
    let name = |side| if side == Compensation::Right { "G42" } else { "G41" };
    (compensation != right).then(|| (name(compensation), name(right)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn outside_work_toward_the_chuck_needs_g42() {
        let (from, to) = (Point::new(20.0, 2.0), Point::new(20.0, -30.0));
        assert_eq!(wrong_side(Compensation::Left, 3, from, to), Some(("G41", "G42")));
        assert_eq!(wrong_side(Compensation::Right, 3, from, to), None);
        assert_eq!(wrong_side(Compensation::Right, 2, from, to), Some(("G42", "G41")));
        assert_eq!(wrong_side(Compensation::Left, 3, to, from), None);
    }
}
