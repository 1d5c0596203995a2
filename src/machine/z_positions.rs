//! Positions along Z at which a surface of revolution is sampled.
//!
//! In: the cuts. Out: Z positions in ascending order: an even grid, both sides of each end of a cut (there
//! may be a wall), and the points of arcs where they are steep. The number of positions is bounded: ends and
//! points closer together than a spacing share one, and the spacing grows until they fit.

use std::rc::Rc;

use crate::geometry::{Point, SAME};

/// Number of evenly spaced positions.
const GRID: usize = 800;

/// Most ends of cuts; each has two positions.
const MAX_ENDS: usize = 400;

/// Most points of steep arcs.
const MAX_BENDS: usize = 400;

/// Least distance of the two positions of a wall from it, mm.
const SIDE: f64 = 0.001;

/// Positions that differ by at most this are equal, mm.
const ROUNDING: f64 = 1e-9;

/// Collects the positions of cuts.
#[derive(Clone, Debug)]
pub struct Places {
    ends: Spaced,
    bends: Spaced,
}

impl Default for Places {
    fn default() -> Self {
        Self { ends: Spaced::new(MAX_ENDS), bends: Spaced::new(MAX_BENDS) }
    }
}

impl Places {
    /// Adds the path of a cut, as the points of a polyline.
    pub fn add(&mut self, way: &[Point]) {
        let [first, inner @ .., last] = way else { return };
        self.end(first.z);
        self.end(last.z);
        for (before, point) in way.iter().zip(inner) {
            // Elsewhere the grid is as exact as the chord.
            if (point.x - before.x).abs() > (point.z - before.z).abs() {
                self.bends.push(point.z);
            }
        }
    }

    /// Adds a place where the surface may have a wall: Z, mm.
    pub fn end(&mut self, z: f64) {
        self.ends.push(z);
    }

    /// The positions, with a grid from `low` to `high`, mm.
    pub fn between(mut self, low: f64, high: f64) -> ZPositions {
        let step = ((high - low) / GRID as f64).max(SAME);
        self.ends.thin_out();
        self.bends.thin_out();
        let mut all: Vec<f64> = (0..GRID).map(|index| low + (index as f64 + 0.5) * step).collect();
        // Each end represents all ends within one spacing in front of it.
        all.extend(self.ends.points.iter().flat_map(|z| [z - SIDE, z + self.ends.spacing]));
        all.extend(&self.bends.points);
        all.sort_unstable_by(f64::total_cmp);
        all.dedup_by(|next, kept| *next - *kept <= ROUNDING);
        let exact_to = if self.ends.spacing > SIDE { self.ends.spacing.min(step) } else { SIDE };
        ZPositions { all: all.into(), exact_to }
    }
}

/// A bounded number of positions with a least distance.
#[derive(Clone, Debug)]
struct Spaced {
    points: Vec<f64>,
    /// Least distance, mm.
    spacing: f64,
    most: usize,
}

impl Spaced {
    /// Number of positions that are collected before they are thinned out.
    const ROOM: usize = 1 << 14;

    fn new(most: usize) -> Self {
        Self { points: Vec::new(), spacing: SIDE, most }
    }

    fn push(&mut self, z: f64) {
        if self.points.last() == Some(&z) {
            return;
        }
        if self.points.len() == Self::ROOM {
            self.thin_out();
        }
        self.points.push(z);
    }

    /// Merges positions that are closer together than the spacing into the first of them.
    fn thin_out(&mut self) {
        self.points.sort_unstable_by(f64::total_cmp);
        loop {
            let spacing = self.spacing;
            self.points.dedup_by(|next, kept| *next - *kept < spacing);
            if self.points.len() <= self.most {
                return;
            }
            self.spacing *= 2.0;
        }
    }
}

/// Positions along Z in ascending order, mm.
#[derive(Clone, Debug)]
pub struct ZPositions {
    all: Rc<[f64]>,
    exact_to: f64,
}

impl ZPositions {
    /// All positions.
    pub fn all(&self) -> &[f64] {
        &self.all
    }

    /// Largest distance along Z between a wall and its positions, mm.
    pub fn exact_to(&self) -> f64 {
        self.exact_to
    }

    /// Index of the first position at `z` or in front of it; may be one past the end.
    pub fn at_least(&self, z: f64) -> usize {
        self.all.partition_point(|own| *own < z - ROUNDING)
    }

    /// Indices of the positions from one Z to another, both included.
    pub fn range(&self, from: f64, to: f64) -> std::ops::Range<usize> {
        let begin = self.at_least(from);
        let count = self.all[begin..].partition_point(|own| *own <= to + ROUNDING);
        begin..begin + count
    }
}

/// Heights at positions with linear interpolation, queried at ascending Z.
pub struct Profile<'a> {
    positions: &'a [f64],
    heights: &'a [f64],
    next: usize,
}

impl<'a> Profile<'a> {
    /// Takes one height for each position; an infinite one means that there is none.
    pub fn new(positions: &'a ZPositions, heights: &'a [f64]) -> Self {
        Self { positions: positions.all(), heights, next: 0 }
    }

    /// The height at `z`, which must not be less than in the last call.
    pub fn at(&mut self, z: f64) -> Option<f64> {
        self.skip_to(z);
        let (after, height) = (self.positions.get(self.next)?, self.heights[self.next]);
        if after - z <= ROUNDING {
            return Some(height).filter(|height| height.is_finite());
        }
        let index = self.next.checked_sub(1)?;
        let (before, from) = (self.positions[index], self.heights[index]);
        let between = from + (z - before) / (after - before) * (height - from);
        Some(between).filter(|height| height.is_finite())
    }

    /// The positions in an interval with their heights; `from` must not be less than in the last call.
    pub fn range(&mut self, from: f64, to: f64) -> impl Iterator<Item = (f64, f64)> {
        self.skip_to(from);
        let positions = self.positions[self.next..].iter().copied();
        let heights = self.heights[self.next..].iter().copied();
        positions.zip(heights).take_while(move |(z, _)| *z <= to + ROUNDING)
    }

    fn skip_to(&mut self, z: f64) {
        while self.positions.get(self.next).is_some_and(|own| *own < z - ROUNDING) {
            self.next += 1;
        }
    }
}

/// Heights without peaks narrower than `width` along Z, mm; walls and slopes do not move. Heights of +∞ are
/// ignored; −∞ means that nothing is there.
pub fn without_narrow_peaks(positions: &ZPositions, heights: &[f64], width: f64) -> Vec<f64> {
    let all = positions.all();
    let point = |index: usize| (all[index], heights[index]);
    let kept = |index: usize| {
        let behind = least_within(width, point(index), (0..index).rev().map(point));
        let ahead = least_within(width, point(index), (index + 1..all.len()).map(point));
        behind.max(ahead)
    };
    (0..all.len()).map(kept).collect()
}

/// The least height between a position and the place `width` away, given the positions on one side of it,
/// nearest first.
fn least_within(width: f64, from: (f64, f64), beside: impl Iterator<Item = (f64, f64)>) -> f64 {
    let (mut least, mut last) = (from.1, from);
    for (z, height) in beside {
        let (away, last_away) = ((z - from.0).abs(), (last.0 - from.0).abs());
        if away >= width {
            let share = (width - last_away) / (away - last_away);
            return least.min(last.1 + share * (height - last.1));
        }
        least = least.min(height);
        last = (z, height);
    }
    least
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_of_cuts_have_stations_on_both_sides() {
        let mut places = Places::default();
        places.add(&[Point::new(10.0, 1.0), Point::new(10.0, -7.3)]);
        let positions = places.between(-50.0, 1.0);
        let near: Vec<f64> = positions.all()[positions.range(-7.31, -7.29)].to_vec();
        assert!(near.iter().any(|z| (z + 7.301).abs() < 1e-6), "{near:?}");
        assert!(near.iter().any(|z| (z + 7.299).abs() < 1e-6), "{near:?}");
    }

    #[test]
    fn a_long_program_has_no_more_stations_than_the_bound() {
        let mut places = Places::default();
        for index in 0..100_000 {
            let z = -f64::from(index) * 0.001;
            let way: Vec<Point> =
                (0..5).map(|step| Point::new(f64::from(step), z - f64::from(step) * 1e-4)).collect();
            places.add(&way);
        }
        let positions = places.between(-100.0, 0.0);
        let bound = GRID + 2 * MAX_ENDS + MAX_BENDS;
        assert!((GRID..=bound).contains(&positions.all().len()), "{}", positions.all().len());
        assert!(positions.all().windows(2).all(|pair| pair[0] < pair[1] && pair[1] - pair[0] < 0.13));
        assert!(positions.exact_to() <= 0.125);
    }

    #[test]
    fn a_profile_is_straight_between_stations() {
        let positions = ZPositions { all: [0.0, 1.0, 1.5, 4.0].into(), exact_to: SIDE };
        let heights = [2.0, 4.0, f64::INFINITY, 1.0];
        let mut profile = Profile::new(&positions, &heights);
        let found = [-1.0, 0.0, 0.5, 1.0, 1.2, 4.0, 5.0].map(|z| profile.at(z));
        assert_eq!(found, [None, Some(2.0), Some(3.0), Some(4.0), None, Some(1.0), None]);
        let within: Vec<_> = Profile::new(&positions, &heights).range(0.5, 1.0).collect();
        assert_eq!(within, [(1.0, 4.0)]);
    }

    #[test]
    fn narrow_peaks_go_and_walls_stay() {
        let open = |points: &[(f64, f64)]| {
            let (places, heights): (Vec<f64>, Vec<f64>) = points.iter().copied().unzip();
            without_narrow_peaks(&ZPositions { all: places.into(), exact_to: SIDE }, &heights, 0.1)
        };
        assert_eq!(open(&[(0.0, 1.0), (0.98, 1.0), (1.0, 5.0), (1.02, 1.0), (2.0, 1.0)]), [1.0; 5]);
        let wall = [(0.0, 1.0), (0.99, 1.0), (1.01, 5.0), (2.0, 5.0)];
        assert_eq!(open(&wall), wall.map(|point| point.1));
        let slope = [(0.0, 1.0), (0.05, 1.1), (0.2, 1.4), (1.0, 3.0)];
        assert_eq!(open(&slope), slope.map(|point| point.1));
        let nothing = f64::NEG_INFINITY;
        let strip = open(&[(0.0, nothing), (0.9, nothing), (0.92, 5.0), (0.94, 5.0), (0.96, nothing)]);
        assert_eq!(strip, [nothing; 5]);
        let gap = f64::INFINITY;
        assert_eq!(open(&[(0.0, gap), (0.9, 5.0), (1.1, 5.0), (1.15, gap)]), [gap, 5.0, 5.0, gap]);
    }
}
