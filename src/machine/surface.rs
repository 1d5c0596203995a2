//! The surface that the tips of all tools leave together, and whether a tool would cut into it.
//!
//! In: cuts, as lines from one point to the next. Out: for the outside or the bore how deep each use of a tool goes at stations
//! along Z, and whether an outline led along them takes off what no tip was led along. Depths are *heights*: radii for the
//! outside, negative radii for a bore, mm; a cut makes them less. Must not know which tool is which.

use super::sweep::Outline;
use crate::geometry::{Point, SAME};

/// Stations along Z.
const STATIONS: usize = 800;

/// What a guessed tool may cut too deep, mm.
pub const GOUGE: f64 = 0.05;

/// A roughing pass ends no further in front of the last step of a contour than this, mm.
const ALLOWANCE: f64 = 1.0;

/// On which side of the work a surface is.
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

/// Stations along Z, evenly spaced.
#[derive(Clone, Copy, Debug)]
pub struct Stations {
    low: f64,
    step: f64,
}

impl Stations {
    /// Stations from `low` to `high`, mm.
    pub fn between(low: f64, high: f64) -> Self {
        Self { low, step: ((high - low) / STATIONS as f64).max(SAME) }
    }

    fn z(&self, index: usize) -> f64 {
        self.low + (index as f64 + 0.5) * self.step
    }

    /// The first station at or behind `z`; may be beyond the last.
    fn at_least(&self, z: f64) -> usize {
        ((z - self.low) / self.step - 0.5 - 1e-9).ceil().max(0.0) as usize
    }

    /// Stations from one Z to another, both counted.
    fn range(&self, from: f64, to: f64) -> std::ops::Range<usize> {
        let end = ((to - self.low) / self.step - 0.5 + 1e-9).floor() + 1.0;
        self.at_least(from).min(STATIONS)..(end.max(0.0) as usize).min(STATIONS)
    }
}

/// Where a use of a tool is led.
#[derive(Clone, Debug)]
pub struct Track {
    /// Least height at each station; infinite where the tip is not led along Z.
    pub along: Vec<f64>,
    /// Ends of straight ways into the work: Z and height.
    pub plunges: Vec<(f64, f64)>,
}

impl Default for Track {
    fn default() -> Self {
        Self { along: vec![f64::INFINITY; STATIONS], plunges: Vec::new() }
    }
}

impl Track {
    /// Adds a cut along some points.
    pub fn add(&mut self, way: &[Point], facing: Facing, stations: &Stations) {
        for ends in way.windows(2) {
            let (from, to) = (ends[0], ends[1]);
            let (before, behind) = (facing.height(from.x), facing.height(to.x));
            if (to.z - from.z).abs() > SAME {
                for index in stations.range(from.z.min(to.z), from.z.max(to.z)) {
                    let share = (stations.z(index) - from.z) / (to.z - from.z);
                    let height = before + share * (behind - before);
                    self.along[index] = self.along[index].min(height);
                }
            } else if behind < before - SAME {
                self.plunge(to.z, behind);
            }
        }
    }

    fn plunge(&mut self, z: f64, height: f64) {
        const LATELY: usize = 8;
        let room = self.plunges.len() < STATIONS;
        match self.plunges.iter_mut().rev().take(LATELY).find(|own| (own.0 - z).abs() <= SAME) {
            Some(own) => own.1 = own.1.min(height),
            None if room => self.plunges.push((z, height)),
            None => {}
        }
    }

    /// The highest Z where it is led along Z between two heights.
    pub fn highest_between(&self, stations: &Stations, low: f64, high: f64) -> Option<f64> {
        let index = self.along.iter().rposition(|height| (low..high).contains(height))?;
        Some(stations.z(index))
    }

    /// The same without the ways that part the work off: those that end below a height.
    pub fn without_parting(&self, least: f64) -> Self {
        let mut track = self.clone();
        track.plunges.retain(|(_, height)| *height > least);
        track
    }

    /// Whether it is led along Z right behind a place.
    pub fn goes_on_behind(&self, stations: &Stations, z: f64) -> bool {
        let next = stations.at_least(z).min(STATIONS);
        self.along[next.saturating_sub(2)..next].iter().any(|height| height.is_finite())
    }

    /// Whether along Z the surface only falls and then rises, from one end of each stretch to the other. An arc that is not quite
    /// tangent bulges a little.
    pub fn is_valley(&self) -> bool {
        let (mut lowest, mut highest) = (f64::INFINITY, f64::NEG_INFINITY);
        self.along.iter().all(|&height| {
            if height.is_infinite() {
                (lowest, highest) = (f64::INFINITY, f64::NEG_INFINITY);
                return true;
            }
            lowest = lowest.min(height);
            // Once it rises.
            if height > lowest + GOUGE {
                highest = highest.max(height);
            }
            height >= highest - GOUGE
        })
    }

    /// The same without plunges where what it is led along ends: the last step of a contour may go on into the bar.
    pub fn without_last_step(&self, stations: &Stations) -> Self {
        let mut track = self.clone();
        if let Some(back) = self.along.iter().position(|height| height.is_finite()) {
            track.plunges.retain(|(z, _)| *z > stations.z(back) + ALLOWANCE);
        }
        track
    }

    /// The same without plunges that end below a surface: they make grooves of their own.
    pub fn without_grooves(&self, surface: &Surface) -> Self {
        let mut track = self.clone();
        track.plunges.retain(|&(z, height)| surface.is_reached(z, height));
        track
    }
}

/// A surface that is to stay.
#[derive(Clone, Debug)]
pub struct Surface {
    facing: Facing,
    stations: Stations,
    heights: Vec<f64>,
}

impl Surface {
    /// What the tracks leave of a blank whose surface has the height `blank` between `back` and `front`, mm; in front of that and
    /// behind it nothing is to stay.
    pub fn of<'a>(
        tracks: impl Iterator<Item = &'a Track>,
        (facing, stations): (Facing, Stations),
        radius: f64,
        (back, front): (f64, f64),
    ) -> Self {
        let mut heights = vec![facing.height(radius); STATIONS];
        for track in tracks {
            for (height, own) in heights.iter_mut().zip(&track.along) {
                *height = height.min(*own);
            }
        }
        for (index, height) in heights.iter_mut().enumerate() {
            if stations.z(index) > front - SAME || stations.z(index) < back {
                *height = f64::NEG_INFINITY;
            }
        }
        Self { facing, stations, heights }
    }

    /// What a track alone leaves; where it is not led along Z nothing is to stay.
    pub fn of_one(track: &Track, (facing, stations): (Facing, Stations)) -> Self {
        let stays = |height: &f64| if height.is_finite() { *height } else { f64::NEG_INFINITY };
        Self { facing, stations, heights: track.along.iter().map(stays).collect() }
    }

    /// Whether each plunge of a track behind `front` ends on or above the surface, so that no ring is left beside it.
    pub fn clears_plunges(&self, track: &Track, front: f64) -> bool {
        let mut behind = track.plunges.iter().filter(|(z, _)| *z < front - SAME);
        behind.all(|&(z, height)| self.is_reached(z, height))
    }

    /// Whether the surface is as deep as this at a place, or right beside it.
    fn is_reached(&self, z: f64, height: f64) -> bool {
        let next = self.stations.at_least(z);
        let near = next.saturating_sub(2).min(STATIONS)..(next + 3).min(STATIONS);
        self.heights[near].iter().any(|own| *own <= height + GOUGE)
    }

    /// Whether an outline led along a track takes off any of it.
    pub fn is_gouged(&self, outline: &Outline, track: &Track) -> bool {
        let edge = Edge::of(outline, self.facing);
        let led = track.along.iter().enumerate().filter(|(_, height)| height.is_finite());
        let led = led.map(|(index, height)| (self.stations.z(index), *height));
        led.chain(track.plunges.iter().copied()).any(|(z, height)| {
            self.stations.range(z + edge.left(), z + edge.right()).any(|index| {
                let low = height + edge.height(self.stations.z(index) - z);
                low < self.heights[index] - GOUGE
            })
        })
    }
}

/// The side of an outline that looks at the work: Z and height of its corners, from −Z on.
struct Edge(Vec<Point>);

impl Edge {
    fn of(outline: &Outline, facing: Facing) -> Self {
        let points = outline.points().iter().map(|point| Point::new(facing.height(point.x), point.z));
        let mut points: Vec<Point> = points.collect();
        points.sort_by(|a, b| (a.z, a.x).partial_cmp(&(b.z, b.x)).unwrap_or(std::cmp::Ordering::Equal));
        // The lower half of Andrew's chains: the outline is convex.
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

    fn left(&self) -> f64 {
        self.0.first().map_or(0.0, |point| point.z)
    }

    fn right(&self) -> f64 {
        self.0.last().map_or(0.0, |point| point.z)
    }

    /// Height above the tip at a place beside it.
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

    const PLACES: Stations = Stations { low: -40.0, step: 0.06 };

    fn led(points: &[(f64, f64)]) -> Track {
        let mut track = Track::default();
        let way: Vec<Point> = points.iter().map(|&(x, z)| Point::new(x, z)).collect();
        track.add(&way, Facing::Outwards, &PLACES);
        track
    }

    fn gouges(tool: &str, points: &[(f64, f64)]) -> bool {
        let track = led(points);
        let surface = Surface::of([&track].into_iter(), (Facing::Outwards, PLACES), 30.0, (-40.0, 0.0));
        let shape = Shape::of(&serde_json::from_str(tool).expect("a tool"));
        surface.is_gouged(&shape.edge, &track)
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
        let clears = |track: &Track| {
            let side = (Facing::Outwards, PLACES);
            Surface::of([track].into_iter(), side, 30.0, (-40.0, 0.0)).clears_plunges(track, 0.0)
        };
        let valley = led(&[(30.0, -10.0), (25.0, -10.0), (25.0, -15.0), (30.0, -20.0)]);
        assert!(valley.is_valley() && clears(&valley));
        assert!(!led(&[(30.0, -10.0), (25.0, -12.0), (28.0, -15.0), (20.0, -20.0)]).is_valley());
        assert!(!clears(&led(&[(30.0, -10.0), (25.0, -10.0)])));
        // It bulges a little before it falls.
        let bulging = led(&[(30.0, -20.0), (30.01, -19.9), (25.0, -15.0), (25.0, -11.0), (30.0, -10.0)]);
        assert!(bulging.is_valley());
    }
}
