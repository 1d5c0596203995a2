//! The surface that the tips of all tools leave together, and whether a tool would cut into it.
//!
//! In: cuts, as polylines. Out: for the outside or the bore, how deep each use of a tool goes at positions
//! along Z, and whether an outline on its path removes material that no tip removes. Depths are *heights*:
//! radii for the outside, negative radii for a bore, mm; a cut lowers them. Must not know which tool is
//! which.

use super::sweep::Outline;
use super::z_positions::{Profile, ZPositions, without_narrow_peaks};
use crate::geometry::{Point, SAME};
use crate::order;

/// Most plunges of a track that are kept.
const MAX_PLUNGES: usize = 800;

/// Largest distance along Z that counts as right beside a place, mm.
const BESIDE: f64 = 0.3;

/// How much too deep an inferred tool may cut, mm.
pub const GOUGE: f64 = 0.05;

/// How far along Z an inferred tool may shift a wall, mm.
pub const SHIFT: f64 = 0.05;

/// The same for a tool that is taken because no other one fits, mm.
pub const WIDEST_SHIFT: f64 = 0.08;

/// A roughing pass ends at most this far in front of the last step of a contour, mm.
const ALLOWANCE: f64 = 1.0;

/// The side of the workpiece that a surface is on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Facing {
    /// Material towards the axis.
    Outwards,
    /// Material away from the axis.
    Inwards,
}

impl Facing {
    fn height(self, x: f64) -> f64 {
        match self {
            Self::Outwards => x,
            Self::Inwards => -x,
        }
    }
}

/// The path of a tool in one of its uses.
#[derive(Clone, Debug)]
pub struct Track {
    /// Least height at each position; infinite where the tip does not move along Z.
    pub along: Vec<f64>,
    /// Ends of straight moves into the workpiece: Z and height.
    pub plunges: Vec<(f64, f64)>,
}

impl Track {
    /// An empty track.
    pub fn new(positions: &ZPositions) -> Self {
        Self { along: vec![f64::INFINITY; positions.all().len()], plunges: Vec::new() }
    }

    /// Adds a cut along some points.
    pub fn add(&mut self, way: &[Point], facing: Facing, positions: &ZPositions) {
        for ends in way.windows(2) {
            let (from, to) = (ends[0], ends[1]);
            let (start, end) = (facing.height(from.x), facing.height(to.x));
            if (to.z - from.z).abs() > SAME {
                let slope = (end - start) / (to.z - from.z);
                let range = positions.range(from.z.min(to.z), from.z.max(to.z));
                for (own, z) in self.along[range.clone()].iter_mut().zip(&positions.all()[range]) {
                    *own = own.min(start + (z - from.z) * slope);
                }
            } else if end < start - SAME {
                self.plunge(to.z, end);
            }
        }
    }

    fn plunge(&mut self, z: f64, height: f64) {
        const RECENT: usize = 8;
        let room = self.plunges.len() < MAX_PLUNGES;
        match self.plunges.iter_mut().rev().take(RECENT).find(|own| (own.0 - z).abs() <= SAME) {
            Some(own) => own.1 = own.1.min(height),
            None if room => self.plunges.push((z, height)),
            None => {}
        }
    }

    /// The greatest Z at which the height of the path along Z is between two heights.
    pub fn highest_between(&self, positions: &ZPositions, low: f64, high: f64) -> Option<f64> {
        let index = self.along.iter().rposition(|height| (low..high).contains(height))?;
        Some(positions.all()[index])
    }

    /// The same track without part-offs: plunges that end below a height.
    pub fn without_parting(&self, least: f64) -> Self {
        let mut track = self.clone();
        track.plunges.retain(|(_, height)| *height > least);
        track
    }

    /// Whether the path continues along Z right behind a place.
    pub fn continues_after(&self, positions: &ZPositions, z: f64) -> bool {
        self.along[positions.range(z - BESIDE, z - SAME)].iter().any(|height| height.is_finite())
    }

    /// Whether the surface only falls and then rises along Z. Small bulges are ignored, because an arc may
    /// not be exactly tangent; so are the narrow peaks between cuts that meet from two sides.
    pub fn is_valley(&self, positions: &ZPositions) -> bool {
        let heights = without_narrow_peaks(positions, &self.along, WIDEST_SHIFT);
        let (mut lowest, mut highest) = (f64::INFINITY, f64::NEG_INFINITY);
        heights.iter().all(|&height| {
            if height.is_infinite() {
                (lowest, highest) = (f64::INFINITY, f64::NEG_INFINITY);
                return true;
            }
            lowest = lowest.min(height);
            // Once the surface rises.
            if height > lowest + GOUGE {
                highest = highest.max(height);
            }
            height >= highest - GOUGE
        })
    }

    /// The same track without plunges at the end of its path along Z: the last step of a contour may continue
    /// into the bar.
    pub fn without_last_step(&self, positions: &ZPositions) -> Self {
        let mut track = self.clone();
        if let Some(back) = self.along.iter().position(|height| height.is_finite()) {
            track.plunges.retain(|(z, _)| *z > positions.all()[back] + ALLOWANCE);
        }
        track
    }

    /// The same track without plunges that end below a surface, because they make separate grooves.
    pub fn without_grooves(&self, surface: &Surface) -> Self {
        let mut track = self.clone();
        track.plunges.retain(|&(z, height)| surface.is_reached(z, height));
        track
    }
}

/// A surface that must remain.
#[derive(Clone, Debug)]
pub struct Surface {
    facing: Facing,
    positions: ZPositions,
    heights: Vec<f64>,
}

impl Surface {
    /// The surface that the tracks leave of a blank with the given radius between `back` and `front`, mm.
    /// Outside of these limits all material may be cut.
    pub fn of<'a>(
        tracks: impl Iterator<Item = &'a Track>,
        (facing, positions): (Facing, ZPositions),
        radius: f64,
        (back, front): (f64, f64),
    ) -> Self {
        let mut heights = vec![facing.height(radius); positions.all().len()];
        for track in tracks {
            for (height, own) in heights.iter_mut().zip(&track.along) {
                *height = height.min(*own);
            }
        }
        for (height, z) in heights.iter_mut().zip(positions.all()) {
            if *z > front - SAME || *z < back {
                *height = f64::NEG_INFINITY;
            }
        }
        let heights = without_narrow_peaks(&positions, &heights, WIDEST_SHIFT);
        Self { facing, positions, heights }
    }

    /// The surface that a single track leaves; where the track does not move along Z, all material may be
    /// cut.
    pub fn of_one(track: &Track, (facing, positions): (Facing, ZPositions)) -> Self {
        let stays = |height: &f64| if height.is_finite() { *height } else { f64::NEG_INFINITY };
        let heights: Vec<f64> = track.along.iter().map(stays).collect();
        let heights = without_narrow_peaks(&positions, &heights, WIDEST_SHIFT);
        Self { facing, positions, heights }
    }

    /// Whether each plunge of a track behind `front` ends on or above the surface, so that no ring is left
    /// beside it.
    pub fn clears_plunges(&self, track: &Track, front: f64) -> bool {
        let mut behind = track.plunges.iter().filter(|(z, _)| *z < front - SAME);
        behind.all(|&(z, height)| self.is_reached(z, height))
    }

    /// Whether the surface is as deep as `height` at a place or right beside it.
    fn is_reached(&self, z: f64, height: f64) -> bool {
        let near = self.positions.range(z - BESIDE, z + BESIDE);
        self.heights[near].iter().any(|own| *own <= height + GOUGE)
    }

    /// Whether an outline on a track cuts into the surface, except for walls that it shifts by at most
    /// `shift`, mm.
    ///
    /// Track, surface and edge are straight between their points. So the outline is deepest in the surface
    /// where two of the three have a point: a point of the track, a point of the surface, a corner of the
    /// edge.
    pub fn is_gouged(&self, outline: &Outline, track: &Track, shift: f64) -> bool {
        // The positions do not show exactly where a wall is.
        let edge = Edge::of(outline, self.facing).narrowed(shift.max(self.positions.exact_to()));
        let led = self.positions.all().iter().copied().zip(track.along.iter().copied());
        let led: Vec<(f64, f64)> = led.filter(|(_, height)| height.is_finite()).collect();
        let mut plunges = track.plunges.clone();
        order::by(&mut plunges, |a, b| a.0.total_cmp(&b.0));
        self.is_below(&edge, &led) || self.is_below(&edge, &plunges) || self.is_above(&edge, track)
    }

    /// Whether an edge cuts into the surface while its tip is at the given places, in ascending order of Z.
    fn is_below(&self, edge: &Edge, tips: &[(f64, f64)]) -> bool {
        let cuts_points = |side: &[Point]| {
            let (a, b) = (side[0], side[1]);
            let slope = (b.x - a.x) / (b.z - a.z);
            let mut profile = Profile::new(&self.positions, &self.heights);
            tips.iter().any(|&(z, height)| {
                let mut under = profile.range(z + a.z, z + b.z);
                under.any(|(own, surface)| height + a.x + (own - z - a.z) * slope < surface - GOUGE)
            })
        };
        let cuts_with_corner = |corner: &Point| {
            let mut profile = Profile::new(&self.positions, &self.heights);
            tips.iter().any(|&(z, height)| {
                profile.at(z + corner.z).is_some_and(|surface| height + corner.x < surface - GOUGE)
            })
        };
        edge.0.windows(2).any(cuts_points) || edge.0.iter().any(cuts_with_corner)
    }

    /// Whether a corner of an edge on a track goes below a point of the surface.
    fn is_above(&self, edge: &Edge, track: &Track) -> bool {
        edge.0.iter().any(|corner| {
            let mut led = Profile::new(&self.positions, &track.along);
            let mut points = self.positions.all().iter().zip(&self.heights);
            points.any(|(z, surface)| {
                led.at(z - corner.z).is_some_and(|height| height + corner.x < surface - GOUGE)
            })
        })
    }
}

/// The side of an outline that faces the workpiece: Z and height of its corners, from −Z on.
struct Edge(Vec<Point>);

impl Edge {
    fn of(outline: &Outline, facing: Facing) -> Self {
        let points = outline.points().iter().map(|point| Point::new(facing.height(point.x), point.z));
        let mut points: Vec<Point> = points.collect();
        order::by(&mut points, |a, b| {
            (a.z, a.x).partial_cmp(&(b.z, b.x)).unwrap_or(std::cmp::Ordering::Equal)
        });
        // The lower chain of Andrew's algorithm: the outline is convex.
        let mut lower: Vec<Point> = Vec::with_capacity(points.len());
        for point in points {
            while let [.., a, b] = lower[..]
                && (b.z - a.z) * (point.x - a.x) <= (b.x - a.x) * (point.z - a.z)
            {
                lower.pop();
            }
            if lower.last().is_none_or(|last| point.z > last.z + SAME) {
                lower.push(point);
            }
        }
        Self(lower)
    }

    /// The same edge, shorter by `by` at both ends, mm.
    fn narrowed(&self, by: f64) -> Self {
        let (Some(first), Some(last)) = (self.0.first(), self.0.last()) else { return Self(Vec::new()) };
        let (left, right) = (first.z + by, last.z - by);
        if left >= right {
            return Self(Vec::new());
        }
        let end = |z: f64| Point::new(self.height(z), z);
        let inner = self.0.iter().copied().filter(|point| point.z > left + SAME && point.z < right - SAME);
        Self([end(left)].into_iter().chain(inner).chain([end(right)]).collect())
    }

    /// Height above the tip at `z`.
    fn height(&self, z: f64) -> f64 {
        let next = self.0.partition_point(|point| point.z < z).clamp(1, self.0.len().max(2) - 1);
        match (self.0.get(next - 1), self.0.get(next)) {
            (Some(a), Some(b)) => a.x + (z - a.z) / (b.z - a.z) * (b.x - a.x),
            _ => f64::INFINITY,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::tool::Shape;
    use crate::machine::z_positions::Places;

    fn led(points: &[(f64, f64)]) -> (Track, ZPositions) {
        let way: Vec<Point> = points.iter().map(|&(x, z)| Point::new(x, z)).collect();
        let mut places = Places::default();
        way.windows(2).for_each(|ends| places.add(ends));
        let positions = places.between(-40.0, 8.0);
        let mut track = Track::new(&positions);
        track.add(&way, Facing::Outwards, &positions);
        (track, positions)
    }

    fn gouges(tool: &str, points: &[(f64, f64)]) -> bool {
        let (track, positions) = led(points);
        let surface = Surface::of([&track].into_iter(), (Facing::Outwards, positions), 30.0, (-40.0, 0.0));
        let shape = Shape::of(&serde_json::from_str(tool).expect("a tool"));
        surface.is_gouged(&shape.edge, &track, SHIFT)
    }

    #[test]
    fn an_insert_follows_what_its_edge_allows() {
        let (rhombus, sharp) =
            (r#"{"type": "turning"}"#, r#"{"type": "turning", "insert": "V", "enteringAngle": 93}"#);
        let steps = [(10.0, 1.0), (10.0, -10.0), (15.0, -10.0), (20.0, -20.0)];
        assert!(!gouges(rhombus, &steps) && !gouges(sharp, &steps));
        let falls = [(20.0, 1.0), (20.0, -10.0), (15.0, -15.0), (15.0, -20.0)];
        assert!(gouges(rhombus, &falls) && !gouges(sharp, &falls));
        // Straight into the bar, far from the face.
        let plunge = [(31.0, -20.0), (25.0, -20.0), (25.0, -30.0)];
        assert!(gouges(rhombus, &plunge) && gouges(sharp, &plunge));
    }

    #[test]
    fn valleys_and_rings() {
        let clears = |(track, positions): &(Track, ZPositions)| {
            let side = (Facing::Outwards, positions.clone());
            Surface::of([track].into_iter(), side, 30.0, (-40.0, 0.0)).clears_plunges(track, 0.0)
        };
        let valley = led(&[(30.0, -10.0), (25.0, -10.0), (25.0, -15.0), (30.0, -20.0)]);
        assert!(valley.0.is_valley(&valley.1) && clears(&valley));
        let hill = led(&[(30.0, -10.0), (25.0, -12.0), (28.0, -15.0), (20.0, -20.0)]);
        assert!(!hill.0.is_valley(&hill.1));
        assert!(!clears(&led(&[(30.0, -10.0), (25.0, -10.0)])));
        // It bulges a little before it falls.
        let bulging = led(&[(30.0, -20.0), (30.01, -19.9), (25.0, -15.0), (25.0, -11.0), (30.0, -10.0)]);
        assert!(bulging.0.is_valley(&bulging.1));
    }
}
