//! Whether a candidate meets what is drawn: strokes, labels, lines and the border.
//!
//! In: a candidate, and all that is placed. Out: answers.

use super::super::camera::Pixel;
use super::super::occupied::Rectangle;
use super::Placing;
use super::candidates::{Candidate, Feature};
use super::lines::{crosses, direction, do_cross, meets, run_together};

/// Least distance of a dimension line from a parallel stroke, CSS pixels.
const FROM_LINES: f64 = 2.5;
/// Space between the number of a step and a stroke on its other side, CSS pixels: it is nearer to its own stroke.
const FROM_OTHERS: f64 = 6.0;
/// Least distance between the places that two numbers beside their strokes mark, CSS pixels.
const BESIDE_APART: f64 = 4.0;

impl Placing<'_> {
    /// Whether the label meets nothing, and no line meets a label or lies on another dimension line.
    pub(super) fn is_possible(&self, candidate: &Candidate) -> bool {
        self.is_free(&candidate.area)
            && !candidate.extensions.iter().any(|line| crosses(line, &candidate.area))
            && self.has_free_lines(candidate)
    }

    /// Whether no line meets a label or lies on another dimension line.
    pub(super) fn has_free_lines(&self, candidate: &Candidate) -> bool {
        let coincides =
            |line: &Vec<Pixel>| self.dimension_lines.iter().any(|other| run_together(line, other));
        !self.meet_label(candidate.lines.iter().chain(&candidate.extensions))
            && !candidate.lines.iter().any(coincides)
    }

    /// Whether a dimension line lies on a stroke or an edge, or beside one.
    pub(super) fn lies_on_stroke(&self, candidate: &Candidate) -> bool {
        self.lies_aside(candidate, &[0.0, FROM_LINES, -FROM_LINES])
    }

    /// Whether a line, displaced by one of the distances, lies on a stroke or an edge.
    fn lies_aside(&self, candidate: &Candidate, distances: &[f64]) -> bool {
        let mut ends = candidate.lines.iter().filter_map(|line| Some([*line.first()?, *line.last()?]));
        ends.any(|[from, to]| {
            let unit = direction(from, to);
            let aside = |at: Pixel, by: f64| Pixel::new(at.x + by * unit.y, at.y - by * unit.x);
            distances.iter().any(|by| self.occupied.covers(aside(from, *by), aside(to, *by)))
        })
    }

    /// Whether a line of the picture passes under the label or a line, a dimension line crosses an extension line of another
    /// dimension or a leader line, or two numbers mark nearly the same place.
    pub(super) fn is_confusing(&self, candidate: &Candidate) -> bool {
        let own = || candidate.lines.iter().chain(&candidate.extensions);
        let is_marked = match candidate.feature {
            Feature::Stroke(tip) => self.is_marked(tip, BESIDE_APART),
            Feature::DimensionLine | Feature::Place(_) => false,
        };
        is_marked
            || self.is_between_strokes(candidate.feature, &candidate.area)
            || self.lies_aside(candidate, &[0.0])
            || !self.occupied.is_clear(&candidate.area)
            || self.leaders.iter().any(|leader| own().any(|line| meets(*leader, line)))
            || self.crosses_dimension(candidate)
    }

    /// Whether the number of a step beside its stroke is as near to another stroke.
    pub(super) fn is_between_strokes(&self, feature: Feature, area: &Rectangle) -> bool {
        let Feature::Stroke(tip) = feature else { return false };
        let away = direction(tip, area.middle());
        let moved = |at: Pixel| Pixel::new(at.x + FROM_OTHERS * away.x, at.y + FROM_OTHERS * away.y);
        !self.occupied.is_free(&Rectangle { min: moved(area.min), max: moved(area.max) })
    }

    /// Whether a number of a step marks a place within a distance.
    pub(super) fn is_marked(&self, at: Pixel, distance: f64) -> bool {
        self.tips.iter().any(|other| other.distance(at) < distance)
    }

    /// Whether a dimension line crosses an extension line of another dimension.
    fn crosses_dimension(&self, candidate: &Candidate) -> bool {
        let cross = |lines: &[Vec<Pixel>], others: &[Vec<Pixel>]| {
            lines.iter().any(|line| others.iter().any(|other| do_cross(line, other)))
        };
        cross(&candidate.lines, &self.extensions) || cross(&candidate.extensions, &self.dimension_lines)
    }

    /// Whether one of the lines passes through a label.
    pub(super) fn meet_label<'a>(&self, mut lines: impl Iterator<Item = &'a Vec<Pixel>>) -> bool {
        lines.any(|line| self.placed.labels.iter().any(|label| crosses(line, &label.area)))
    }

    pub(super) fn is_free(&self, area: &Rectangle) -> bool {
        self.is_inside(area)
            && !self.placed.labels.iter().any(|label| label.area.overlaps(area))
            && !self.placed.lines.iter().chain(&self.placed.edges).any(|line| crosses(line, area))
            && !self.placed.hatch.iter().any(|line| crosses(line, area))
            && self.occupied.is_free(area)
    }

    /// The horizontal and vertical ranges for labels, without a margin.
    pub(super) fn inside(&self, margin: f64) -> [[f64; 2]; 2] {
        let Rectangle { min, max } = self.room;
        [[min.x + margin, max.x - margin], [min.y + margin, max.y - margin]]
    }

    fn is_inside(&self, area: &Rectangle) -> bool {
        let [across, down] = self.inside(2.0);
        across[0] <= area.min.x && area.max.x <= across[1] && down[0] <= area.min.y && area.max.y <= down[1]
    }
}
