//! Leader lines: a label at the nearest free place, with a line to its feature.
//!
//! In: a candidate whose label has no place. Out: the same with its label elsewhere.

use super::super::camera::Pixel;
use super::super::occupied::Rectangle;
use super::Placing;
use super::candidates::{Candidate, Feature};
use super::lines::{crosses, do_cross, do_meet, do_touch, is_slanted, meets, middle_part, nearest_on};

/// A label at most this far from its dimension line, stroke or point needs no leader line, CSS pixels.
const ADJACENT: f64 = 6.0;
/// Least distance of a leader line from the dot of a named point, CSS pixels.
const FROM_POINTS: f64 = 5.0;
/// Least distance of the ends of a leader line from other leaders, CSS pixels; the second, if there is no other place.
const FROM_LEADERS: [f64; 2] = [3.0, 1.0];
/// A place for a label without lines under it and under its leader is preferred to one that is nearer by at most this number
/// of rings.
const PREFERRED: u8 = 2;
/// Number of directions that are tried; the second, if there is no other place.
const TURNS: [u8; 2] = [16, 64];
/// Least distance between the strokes that two leaders mark, CSS pixels; the second, if there is no other place.
const TIPS_APART: [f64; 2] = [10.0, 5.0];

impl Placing<'_> {
    /// A candidate with its label at the nearest free place, and a leader line from its dimension line, stroke or
    /// point to the label.
    pub(super) fn with_leader(
        &self,
        candidate: Candidate,
        size: [f64; 2],
        longest: f64,
    ) -> Option<Candidate> {
        // The gap for the label is closed.
        let lines = match &candidate.lines[..] {
            [first, last] => vec![vec![*first.first()?, *last.last()?]],
            // A note gets a new leader.
            _ if candidate.feature != Feature::DimensionLine && candidate.heads.is_empty() => Vec::new(),
            _ => candidate.lines.clone(),
        };
        let (feature, ends) = match candidate.feature {
            Feature::Place(at) => ([at, at], candidate.ends.clone()),
            Feature::Stroke(at) => ([at, at], if candidate.heads.is_empty() { vec![at] } else { Vec::new() }),
            Feature::DimensionLine => (middle_part(lines.first()?)?, Vec::new()),
        };
        let candidate = Candidate { lines, ..candidate };
        let apart = if longest.is_finite() { TIPS_APART[0] } else { TIPS_APART[1] };
        let is_marked = matches!(candidate.feature, Feature::Stroke(_)) && self.is_marked(feature[0], apart);
        if is_marked || !self.has_free_lines(&candidate) {
            return None;
        }
        let turns = if longest.is_finite() { &TURNS[..1] } else { &TURNS[..] };
        let found =
            turns.iter().find_map(|turns| self.nearest_free(&candidate, feature, size, longest, *turns));
        let (area, leader) = found?;
        let ends = if leader.is_some() { ends } else { Vec::new() };
        Some(Candidate { leader, ends, area, ..candidate })
    }

    /// The free area for a label that is nearest to its usual place, and the leader line to it from `feature`, if one is
    /// needed; preferably no line of the picture passes under the label, and the leader crosses no dimension.
    /// `longest`: of the leader line, CSS pixels.
    fn nearest_free(
        &self,
        candidate: &Candidate,
        feature: [Pixel; 2],
        size: [f64; 2],
        longest: f64,
        turns: u8,
    ) -> Option<(Rectangle, Option<[Pixel; 2]>)> {
        let usual = candidate.area.middle();
        let own = || candidate.lines.iter().chain(&candidate.extensions);
        let rings = (0..24u8).flat_map(|ring| (0..turns).map(move |turn| (ring, turn)));
        let (mut second, mut last) = (None, u8::MAX);
        let touch = if longest.is_finite() { FROM_LEADERS[0] } else { FROM_LEADERS[1] };
        for (ring, turn) in rings {
            if ring > last {
                break;
            }
            let (sin, cos) = (f64::from(turn) * std::f64::consts::TAU / f64::from(turns) + 0.4).sin_cos();
            let away = 14.0 * f64::from(ring);
            let middle = Pixel::new(usual.x + away * cos, usual.y - away * sin);
            let area = Rectangle::around(middle, size[0], size[1]);
            let from = nearest_on(feature, middle);
            let line = [from, area.nearest(from)];
            if line[0].distance(line[1]) > longest
                || !self.is_free(&area)
                || own().any(|line| crosses(line, &area))
            {
                continue;
            }
            let leader = Some(line).filter(|line| line[0].distance(line[1]) > ADJACENT);
            let is_refused =
                |line: [Pixel; 2]| !self.is_leader(line, touch) || own().any(|own| do_cross(&line, own));
            let is_between = leader.is_none() && self.is_between_strokes(candidate.feature, &area);
            if leader.is_some_and(is_refused) || is_between {
                continue;
            }
            let crosses_dimension =
                |line: [Pixel; 2]| self.placed.lines.iter().any(|other| meets(line, other));
            if self.occupied.is_clear(&area) && !leader.is_some_and(crosses_dimension) {
                return Some((area, leader));
            }
            if second.is_none() {
                (second, last) = (Some((area, leader)), ring + PREFERRED);
            }
        }
        second
    }

    /// Whether a line may be a leader: slanted, and away from labels, other leaders and named points. `touch`: least distance
    /// of the ends of leaders from other leaders, CSS pixels.
    fn is_leader(&self, line: [Pixel; 2], touch: f64) -> bool {
        let is_passed = |at: &Pixel| {
            let nearest = nearest_on(line, *at);
            nearest.distance(*at) < FROM_POINTS && nearest.distance(line[0]) > FROM_POINTS
        };
        is_slanted(line)
            && !self.meet_label(std::iter::once(&line.to_vec()))
            && !self.leaders.iter().any(|other| do_meet(line, *other) || do_touch(line, *other, touch))
            && !self.points.iter().any(is_passed)
    }
}
