//! Flats that are milled around the spindle axis, such as the faces of a hexagon.
//!
//! In: the line `flats 6 width 24 ±0.1 Z-10` of a target; the motions under polar interpolation. Out: the width across
//! the flats. The section of the part does not show them.

use std::f64::consts::{PI, TAU};

use super::fault::TargetFault;
use super::quantity::{Measured, Quantity};
use super::values::Tolerance;
use crate::geometry::virtual_plane::{Surface, Way};
use crate::geometry::{Point, at_share, share_along, wrapped};
use crate::machine::resolved_setup::ResolvedSetup;
use crate::motion::{Motion, Motions};
use crate::setup::blank::Outline;
use crate::units::{Diameter, read_number};

/// Largest number of flats.
const MOST: usize = 60;
/// Greatest angle between two flats that are the same, radians, and greatest missing depth, mm.
const SAME_ANGLE: f64 = 2e-3;
const SAME_DEPTH: f64 = 0.1;
/// Part of a flat beyond its ends in which the point nearest to the axis may be, for rounding.
const BEYOND: f64 = 0.01;

/// The wanted flats.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Flats {
    /// Their number.
    pub count: usize,
    /// Width across two opposite flats; twice the distance of one flat from the axis, mm.
    pub width: f64,
    /// Its tolerance, mm.
    pub tolerance: Tolerance,
    /// Z of their end, mm.
    pub z: f64,
}

/// A flat that was milled.
struct Flat {
    /// Angle of its normal about the axis, radians.
    angle: f64,
    /// Distance from the axis, mm.
    distance: f64,
}

impl Flats {
    /// Reads the words after `flats`.
    pub(super) fn read(words: &[&str]) -> Result<Self, TargetFault> {
        let wrong = TargetFault::Word { word: "flats".to_owned() };
        let [count, "width", width, rest @ ..] = words else { return Err(wrong) };
        let number = |text: &str| read_number(text).filter(|value| value.abs() <= Outline::FARTHEST);
        let count = count.parse().ok().filter(|count| (1..=MOST).contains(count));
        let z = rest.last().and_then(|word| number(word.strip_prefix(['Z', 'z'])?));
        let read = count.zip(number(width)).zip(Tolerance::read(rest)).zip(z);
        let (((count, width), (tolerance, taken)), z) = read.ok_or(wrong.clone())?;
        let is_whole = taken + 1 == rest.len() && width > 0.0;
        is_whole.then_some(Self { count, width, tolerance, z }).ok_or(wrong)
    }

    /// The width that deviates most; no actual width if the number of flats is another one.
    pub(super) fn measure(self, motions: &Motions, resolved: &ResolvedSetup) -> Measured {
        let milled = self.milled(motions, resolved);
        let widths = milled.iter().map(|flat| width(flat, &milled));
        let off = |width: &f64| (width - self.width).abs();
        let worst = widths.max_by(|a, b| off(a).total_cmp(&off(b)));
        Measured {
            quantity: Quantity::Flats,
            at: Point::new(Diameter::new(self.width).radius(), self.z),
            nominal: self.width,
            actual: worst.filter(|_| milled.len() == self.count),
            tolerance: self.tolerance,
            edge: 0,
        }
    }

    /// The flats that reach the wanted depth; of those with one angle the deepest.
    fn milled(self, motions: &Motions, resolved: &ResolvedSetup) -> Vec<Flat> {
        let mut all: Vec<Flat> = Vec::new();
        let cuts = motions.on_workpiece().filter(|motion| motion.kind.cuts());
        for flat in cuts.filter_map(|motion| self.flat(&motion, resolved)) {
            let same = all.iter().position(|own| is_same_angle(own.angle, flat.angle));
            match same {
                Some(own) => all[own].distance = all[own].distance.min(flat.distance),
                None if all.len() < MOST => all.push(flat),
                None => {}
            }
        }
        all
    }

    /// The flat that a straight move over the end face mills.
    fn flat(self, motion: &Motion, resolved: &ResolvedSetup) -> Option<Flat> {
        let own = motion.virtual_move().filter(|own| own.surface == Surface::Face)?;
        let Way::Line(from, to) = own.way else { return None };
        let share = share_along([from, to], Point::default());
        let foot = at_share([from, to], share);
        let tool = &resolved.tool(motion).tool;
        let radius = tool.tool_radius.or(tool.diameter.map(Diameter::radius))?;
        let distance = foot.distance(Point::default()) - radius;
        let is_beside = (-BEYOND..=1.0 + BEYOND).contains(&share) && distance > 0.0;
        let is_deep = own.third.0.max(own.third.1) <= self.z + SAME_DEPTH;
        (is_beside && is_deep).then(|| Flat { angle: wrapped(foot.x.atan2(foot.z), TAU), distance })
    }
}

/// The width across a flat and the opposite one.
fn width(flat: &Flat, all: &[Flat]) -> f64 {
    let opposite = all.iter().find(|other| is_same_angle(other.angle, flat.angle + PI));
    flat.distance + opposite.map_or(flat.distance, |other| other.distance)
}

fn is_same_angle(a: f64, b: f64) -> bool {
    let between = wrapped(a - b, TAU);
    between.min(TAU - between) <= SAME_ANGLE
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_of_flats_is_read() {
        let read = |text: &str| Flats::read(&text.split(' ').collect::<Vec<_>>());
        let hexagon = Flats { count: 6, width: 24.0, tolerance: Tolerance::both(0.1), z: -10.0 };
        assert_eq!(read("6 width 24 ±0.1 Z-10"), Ok(hexagon));
        for text in
            ["", "6", "0 width 24 ±0.1 Z-10", "6 width 24 Z-10", "6 width 24 ±0.1", "6 width -4 ±0.1 Z-1"]
        {
            assert!(read(text).is_err(), "{text}");
        }
    }
}
