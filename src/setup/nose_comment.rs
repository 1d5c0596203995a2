//! The nose radius of a tool in a comment that names the tool: `(T01 = 80 DEG ROUGH TOOL, TOOL NOSE RADIUS: .0315,
//! TOOL TIP: 3)`.
//!
//! In: a comment. Out: station, nose radius and tip direction. Compensation uses them if the setup does not give
//! the tool, because the offset table of the machine contains them.

use crate::units::{Unit, read_number};

/// The nose of a tool as a comment describes it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DescribedNose {
    /// Turret station.
    pub station: u16,
    /// Nose radius, mm.
    pub radius: f64,
    /// Tip direction, 0 to 9.
    pub tip: u8,
}

/// Names of the nose radius, in capitals.
const RADIUS: [&str; 5] = ["NOSE RADIUS", "NOSE RAD", "TNR", "刀尖半径", "РАДИУС ПРИ ВЕРШИНЕ"];

/// Names of the tip direction, in capitals.
const TIP: [&str; 4] = ["TIP", "TIP DIRECTION", "刀尖方位", "刀尖号"];

/// Nose radii of inserts, mm.
const RADII: std::ops::RangeInclusive<f64> = 0.05..=3.2;

/// A radius up to this, without G20 or G21, is in inches: the smallest one in mm is larger.
const LARGEST_IN_INCHES: f64 = 0.049;

/// Whether a comment may describe a nose. Never false if it does.
pub fn may_describe(inside: &[u8]) -> bool {
    inside.trim_ascii_start().first().is_some_and(|first| first.eq_ignore_ascii_case(&b'T'))
        && inside.len() > 2
        && RADIUS
            .iter()
            .any(|name| inside.windows(name.len()).any(|part| part.eq_ignore_ascii_case(name.as_bytes())))
}

/// The nose that a comment describes. `unit` is that of the program, if it contains G20 or G21.
pub fn read(inside: &str, unit: Option<Unit>) -> Option<DescribedNose> {
    let text = inside.trim_start().to_ascii_uppercase();
    // `TO1`: a letter O for the zero.
    let name = text.strip_prefix('T')?.replace('O', "0");
    let name = &name[..name.find(|c: char| !c.is_ascii_digit()).unwrap_or(name.len())];
    let number: u16 = name.parse().ok().filter(|_| matches!(name.len(), 1..=4))?;
    let station = if name.len() > 2 { number / 100 } else { number };
    let written = RADIUS.iter().find_map(|name| number_after(&text, name))?;
    let unit = unit.unwrap_or(if written <= LARGEST_IN_INCHES { Unit::Inch } else { Unit::Millimetre });
    let radius = written * unit.millimetres();
    let tip = TIP.iter().find_map(|name| number_after(&text, name))?;
    let is_plausible = RADII.contains(&radius) && station > 0 && tip.fract() == 0.0 && tip <= 9.0;
    is_plausible.then_some(DescribedNose { station, radius, tip: tip as u8 })
}

/// The number that follows a name, without a unit.
fn number_after(text: &str, name: &str) -> Option<f64> {
    text.match_indices(name).find_map(|(at, _)| {
        let rest = text[at + name.len()..].trim_start_matches([' ', ':', '=']);
        let end = rest.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(rest.len());
        read_number(rest[..end].trim_end_matches('.'))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_that_name_tool_and_radius() {
        let nose = |station, radius, tip| Some(DescribedNose { station, radius, tip });
        for (comment, unit, expected) in [
            (
                "TO1 = 80* Rough Turning Tool, Insert: 02-0083, Tool Nose Radius: .04, Tool Tip: 3",
                None,
                nose(1, 1.016, 3),
            ),
            ("T0202 FINISH, NOSE RADIUS 0.4 TIP 8", Some(Unit::Millimetre), nose(2, 0.4, 8)),
            ("T2 NOSE RAD=.0625 TIP=2", Some(Unit::Inch), nose(2, 1.5875, 2)),
            ("T12 刀尖半径0.8 刀尖方位3", None, nose(12, 0.8, 3)),
            // No tool, no radius, no tip, values that are not plausible.
            ("ROUGH TOOL, NOSE RADIUS .8, TIP 3", None, None),
            ("T01 ROUGH TOOL, TIP 3", None, None),
            ("T3 TNR 0.8, TIP ANGLE 118", None, None),
            ("T01 NOSE RADIUS 8 TIP 3", None, None),
            ("T01 NOSE RADIUS 0.8 TIP 30", None, None),
            ("TURN NOSE RADIUS 0.8 TIP 3", None, None),
        ] {
            assert_eq!(read(comment, unit), expected, "{comment}");
            assert!(expected.is_none() || may_describe(comment.as_bytes()), "{comment}");
        }
    }
}
