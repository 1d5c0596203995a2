//! Lay-down threading inserts by their usual designation.
//!
//! In: a designation such as `16ER AG60`, `22IL 4.0ISO` or `16ERM 14W`: edge length, outside or inside, hand,
//! and threads. Out: [`ThreadInsert`]. Must not know how an insert is drawn.

use super::Side;

/// The meaning of a threading insert's designation: lengths in mm, angles in degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThreadInsert {
    /// Edge length: 16 for `16ER`.
    pub size: f64,
    /// Side of the workpiece; `None` for both sides.
    pub side: Option<Side>,
    /// Hand of the insert.
    pub hand: Hand,
    /// The largest pitch it is made for.
    pub pitch: Option<f64>,
    /// Angle between the flanks.
    pub angle: Option<f64>,
}

/// Hand of a tool.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Hand {
    /// Feeds towards the chuck.
    #[default]
    Right,
    /// Feeds away from the chuck.
    Left,
}

/// Letters of inserts for a range of pitches, and the largest pitch of the range, mm.
const RANGES: [(&str, f64); 6] = [("AG", 3.0), ("A", 1.5), ("G", 3.0), ("N", 5.0), ("Q", 6.0), ("U", 8.0)];

/// Thread standards, the angle of their flanks, and whether they use threads per inch.
const STANDARDS: [(&str, f64, Measure); 11] = [
    ("ISO", 60.0, Measure::Millimetres),
    ("TR", 30.0, Measure::Millimetres),
    ("UNJ", 60.0, Measure::PerInch),
    ("UN", 60.0, Measure::PerInch),
    ("NPTF", 60.0, Measure::PerInch),
    ("NPT", 60.0, Measure::PerInch),
    ("BSPT", 55.0, Measure::PerInch),
    ("BSW", 55.0, Measure::PerInch),
    ("W", 55.0, Measure::PerInch),
    ("STACME", 29.0, Measure::PerInch),
    ("ACME", 29.0, Measure::PerInch),
];

#[derive(Clone, Copy)]
enum Measure {
    Millimetres,
    PerInch,
}

impl ThreadInsert {
    /// Parses a designation; `None` if it does not begin with size, side and hand.
    pub fn read(designation: &str) -> Option<Self> {
        let text: String = designation
            .chars()
            .filter(|c| !c.is_whitespace() && *c != '-')
            .collect::<String>()
            .to_ascii_uppercase();
        let digits = text.bytes().take_while(u8::is_ascii_digit).count();
        let (size, rest) = text.split_at_checked(digits)?;
        let size = crate::units::read_number(size).filter(|size| (6.0..=40.0).contains(size))?;
        // `U` before the side: a shape with its point at the middle of the edge.
        let rest = rest.strip_prefix('U').unwrap_or(rest);
        // One manufacturer uses N for inside.
        let sides =
            [("EI", None), ("E", Some(Side::Outside)), ("I", Some(Side::Inside)), ("N", Some(Side::Inside))];
        let (side, rest) =
            sides.iter().find_map(|(letters, side)| Some((*side, rest.strip_prefix(letters)?)))?;
        let hands = [("R", Hand::Right), ("L", Hand::Left)];
        let (hand, rest) =
            hands.iter().find_map(|(letter, hand)| Some((*hand, rest.strip_prefix(letter)?)))?;
        // `RL`: made for both hands. `M`: a pressed-in chip breaker.
        let rest = rest.strip_prefix('L').filter(|_| hand == Hand::Right).unwrap_or(rest);
        let rest = rest.strip_prefix('M').unwrap_or(rest);
        let (pitch, angle) = threads(rest);
        Some(Self { size, side, hand, pitch, angle })
    }
}

/// Largest pitch, mm, and angle, degrees, of the threads an insert is made for: `AG60`, `2.0ISO`, `14UN`.
fn threads(text: &str) -> (Option<f64>, Option<f64>) {
    let range = |(letters, pitch): &(&str, f64)| Some((text.strip_prefix(letters)?, *pitch));
    if let Some((rest, pitch)) = RANGES.iter().find_map(range) {
        return (Some(pitch), rest.get(..2).and_then(crate::units::read_number));
    }
    let length = text.bytes().take_while(|byte| byte.is_ascii_digit() || *byte == b'.').count();
    let (number, rest) = text.split_at_checked(length).unwrap_or_default();
    let Some(number) = crate::units::read_number(number).filter(|&number| number > 0.0) else {
        return (None, None);
    };
    let standard = STANDARDS.iter().find(|standard| rest.starts_with(standard.0));
    let (angle, measure) = match standard {
        Some((_, angle, measure)) => (Some(*angle), *measure),
        // Threads per inch are whole numbers, and larger than any pitch in mm.
        None if number >= 9.0 => (None, Measure::PerInch),
        None => (None, Measure::Millimetres),
    };
    let pitch = match measure {
        Measure::Millimetres => number,
        Measure::PerInch => 25.4 / number,
    };
    (Some(pitch), angle)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn designations() {
        let read = |text| {
            let insert = ThreadInsert::read(text)?;
            Some((insert.size, insert.side, insert.hand, insert.pitch, insert.angle))
        };
        let (outside, inside) = (Some(Side::Outside), Some(Side::Inside));
        assert_eq!(read("16ER"), Some((16.0, outside, Hand::Right, None, None)));
        assert_eq!(read("16ER AG60"), Some((16.0, outside, Hand::Right, Some(3.0), Some(60.0))));
        assert_eq!(read("16erm2.0iso"), Some((16.0, outside, Hand::Right, Some(2.0), Some(60.0))));
        assert_eq!(read("22IL N55"), Some((22.0, inside, Hand::Left, Some(5.0), Some(55.0))));
        assert_eq!(read("11NR A60"), Some((11.0, inside, Hand::Right, Some(1.5), Some(60.0))));
        assert_eq!(read("16IR-14W"), Some((16.0, inside, Hand::Right, Some(25.4 / 14.0), Some(55.0))));
        assert_eq!(read("16ER1.5"), Some((16.0, outside, Hand::Right, Some(1.5), None)));
        assert_eq!(read("22UEIRL U60"), Some((22.0, None, Hand::Right, Some(8.0), Some(60.0))));
        assert_eq!(read("16ER3TR"), Some((16.0, outside, Hand::Right, Some(3.0), Some(30.0))));
        for none in ["CNMG120408", "16", "16E", "ER16", "", "1600ER", "16ÜR"] {
            assert_eq!(read(none), None, "{none}");
        }
    }
}
