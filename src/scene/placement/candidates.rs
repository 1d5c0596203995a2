//! The ways to draw an annotation: its lines, arrow heads and dots, and the place of its label.
//!
//! In: points on the screen, and the size of a label. Out: candidates, the best first.

use super::super::camera::Pixel;
use super::super::occupied::Rectangle;
use super::NEXT;
use super::lines::{HEAD, direction, head};

/// Distance of the first dimension line from the point that it measures.
pub(super) const FIRST: f64 = 20.0;
/// Number of distances that are tried, and of those that are tried outside before any inside.
const TRIES: usize = 14;
const OUTSIDE: usize = 4;
/// Length of an extension line beyond its dimension line, and its distance from the point.
const BEYOND: f64 = 4.0;
const GAP: f64 = 2.0;
/// Length of the tail of an arrow that points at a short distance from outside.
const TAIL: f64 = 12.0;
/// Distance of a named point from the middle of its letter.
pub(super) const BESIDE: f64 = 14.0;
/// The positions of the number of a step along its stroke, as shares of its length. In the middle of a long stroke there is
/// an arrow head.
const SHARES: [f64; 5] = [0.5, 0.35, 0.65, 0.2, 0.8];
const SHARES_OF_LONG: [f64; 6] = [0.4, 0.6, 0.3, 0.7, 0.2, 0.8];
/// Least length of a long stroke, CSS pixels.
const LONG: f64 = 32.0;
/// Distance of the number of a step from its stroke, CSS pixels: it has room before the first dimension line.
const FROM_STROKE: f64 = 3.5;
/// The arrow of a step: its distance from the stroke, and its least and greatest length, CSS pixels.
pub(super) const ARROW_AWAY: f64 = 7.0;
const ARROW: [f64; 2] = [14.0, 40.0];

/// A polyline.
type Line = Vec<Pixel>;

/// An arrow head, tip first.
type Head = [Pixel; 3];

/// A possible way to draw an annotation.
#[derive(Clone)]
pub(super) struct Candidate {
    /// Dimension lines, and lines from a point to its label.
    pub(super) lines: Vec<Vec<Pixel>>,
    /// Lines from the points to the dimension line; lines of several dimensions may coincide.
    pub(super) extensions: Vec<Vec<Pixel>>,
    pub(super) heads: Vec<[Pixel; 3]>,
    pub(super) dots: Vec<Pixel>,
    /// The area of the label.
    pub(super) area: Rectangle,
    /// The leader line, and its end on a stroke.
    pub(super) leader: Option<[Pixel; 2]>,
    pub(super) ends: Vec<Pixel>,
    /// What a leader may touch.
    pub(super) feature: Feature,
}

impl Candidate {
    /// A label in an area, without lines.
    pub(super) fn label(area: Rectangle, feature: Feature) -> Self {
        Self {
            lines: Vec::new(),
            extensions: Vec::new(),
            heads: Vec::new(),
            dots: Vec::new(),
            area,
            leader: None,
            ends: Vec::new(),
            feature,
        }
    }
}

/// What the label of a candidate marks; a leader leads to it.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Feature {
    /// The first line of the candidate.
    DimensionLine,
    /// A point, or an arc.
    Place(Pixel),
    /// A position on the stroke of a step, or on the arrow beside it.
    Stroke(Pixel),
}

/// The ways to draw an annotation, the best first.
pub(super) struct Candidates {
    /// As a dimension, with its arrows.
    pub(super) full: Vec<Candidate>,
    /// Only a leader to the label.
    pub(super) notes: Vec<Candidate>,
}

/// The middle of a label that begins where a line in the direction `towards` ends.
pub(super) fn beyond(end: Pixel, towards: Pixel, [width, height]: [f64; 2]) -> Pixel {
    let across = (width / 2.0 + 2.0) / towards.x.abs().max(1e-6);
    let up = (height / 2.0 + 2.0) / towards.y.abs().max(1e-6);
    let reach = across.min(up);
    Pixel::new(end.x + reach * towards.x, end.y + reach * towards.y)
}

/// A letter at eight positions around a point.
pub(super) fn around_point(at: Pixel, size: [f64; 2], dot: bool) -> Vec<Candidate> {
    let mut all = Vec::new();
    for distance in [BESIDE, 2.0 * BESIDE, 3.5 * BESIDE] {
        // Above and below a point there are extension lines.
        for degrees in [45.0, 135.0, 315.0, 225.0, 0.0, 180.0, 90.0, 270.0f64] {
            let (sin, cos) = degrees.to_radians().sin_cos();
            let middle = Pixel::new(
                at.x + cos * (distance + size[0] / 2.0 - 8.0),
                at.y - sin * (distance + size[1] / 2.0 - 8.0),
            );
            let area = Rectangle::around(middle, size[0], size[1]);
            let lines = if distance > BESIDE || !dot { vec![vec![at, area.nearest(at)]] } else { Vec::new() };
            let dots = if dot { vec![at] } else { Vec::new() };
            let feature = Feature::Place(at);
            all.push(Candidate { lines, dots, ..Candidate::label(area, feature) });
        }
    }
    all
}

/// Positions of a number beside a stroke, at its middle first.
pub(super) fn beside(stroke: [Pixel; 2], size: [f64; 2]) -> Vec<Candidate> {
    let candidate = |share: f64, side: f64| {
        Candidate::label(
            area_beside(stroke, share, FROM_STROKE * side, size),
            Feature::Stroke(Pixel::at_share(stroke, share)),
        )
    };
    let is_long = stroke[0].distance(stroke[1]) >= LONG;
    on_both_sides(if is_long { &SHARES_OF_LONG[..] } else { &SHARES[..] }, candidate)
}

/// Positions of a number with an arrow in the direction of its stroke, beside it: on the stroke itself are the arrow
/// heads of others.
pub(super) fn beside_arrow(stroke: [Pixel; 2], size: [f64; 2]) -> Vec<Candidate> {
    let length = stroke[0].distance(stroke[1]);
    let half = (0.6 * length).clamp(ARROW[0], ARROW[1]) / 2.0;
    let unit = direction(stroke[0], stroke[1]);
    let candidate = |share: f64, side: f64| {
        let middle = away(stroke, share, side * ARROW_AWAY);
        let [from, to] = [-half, half].map(|by| Pixel::new(middle.x + by * unit.x, middle.y + by * unit.y));
        Candidate {
            lines: vec![vec![from, to]],
            heads: vec![head(from, to)],
            ..Candidate::label(
                area_beside(stroke, share, side * (ARROW_AWAY + 3.0), size),
                Feature::Stroke(middle),
            )
        }
    };
    on_both_sides(&SHARES, candidate)
}

/// Candidates at each position along a stroke, on its left and on its right.
fn on_both_sides(shares: &[f64], candidate: impl Fn(f64, f64) -> Candidate) -> Vec<Candidate> {
    shares.iter().flat_map(|share| [1.0, -1.0].map(|side| candidate(*share, side))).collect()
}

/// The area of a label at a distance from a stroke.
fn area_beside(stroke: [Pixel; 2], share: f64, by: f64, size: [f64; 2]) -> Rectangle {
    let unit = direction(stroke[0], stroke[1]);
    let half = size[1] / 2.0 + (size[0] - size[1]).max(0.0) / 2.0 * unit.y.abs();
    Rectangle::around(away(stroke, share, by + half.copysign(by)), size[0], size[1])
}

/// A position beside a stroke.
fn away(stroke: [Pixel; 2], share: f64, by: f64) -> Pixel {
    let (unit, at) = (direction(stroke[0], stroke[1]), Pixel::at_share(stroke, share));
    Pixel::new(at.x + by * unit.y, at.y - by * unit.x)
}

/// Horizontal dimension lines above and below two points. `out`: 1 if away from the axis is up on the screen.
pub(super) fn dimension_lines([a, b]: [Pixel; 2], size: [f64; 2], out: f64) -> Vec<Candidate> {
    let mut all = Vec::new();
    let (left, right) = (a.x.min(b.x), a.x.max(b.x));
    // Away from the axis first: there the line does not cross the part.
    let outside = (0..OUTSIDE).map(|step| (step, -out));
    let inside = (0..TRIES).map(|step| (step, out));
    let beyond = (OUTSIDE..TRIES).map(|step| (step, -out));
    for (step, side) in outside.chain(inside).chain(beyond) {
        let base = if side < 0.0 { a.y.min(b.y) } else { a.y.max(b.y) };
        let y = base + side * (FIRST + NEXT * step as f64);
        let extensions = [a, b].map(|at| {
            let toward = (y - at.y).signum();
            vec![Pixel::new(at.x, at.y + GAP * toward), Pixel::new(at.x, y + BEYOND * toward)]
        });
        let ends = [Pixel::new(left, y), Pixel::new(right, y)];
        for (middle, lines, heads) in line_with_label(ends, right - left, size[0], Pixel::new(1.0, 0.0)) {
            let area = Rectangle::around(middle, size[0], size[1]);
            let extensions = extensions.to_vec();
            all.push(Candidate {
                lines,
                extensions,
                heads,
                ..Candidate::label(area, Feature::DimensionLine)
            });
        }
    }
    all
}

/// Vertical dimension lines to the right and left of two points. `is_on_axis`: these have no extension line, which
/// would hide the centre line.
pub(super) fn dimension_columns([a, b]: [Pixel; 2], is_on_axis: [bool; 2], size: [f64; 2]) -> Vec<Candidate> {
    let mut all = Vec::new();
    let (top, bottom) = (a.y.min(b.y), a.y.max(b.y));
    for step in 0..TRIES {
        for side in [1.0, -1.0] {
            let base = if side < 0.0 { a.x.min(b.x) } else { a.x.max(b.x) };
            let x = base + side * (FIRST + NEXT * step as f64);
            let extensions = [(a, is_on_axis[0]), (b, is_on_axis[1])].into_iter().filter(|(_, is_on)| !is_on);
            let extensions: Vec<Vec<Pixel>> = extensions
                .map(|(at, _)| {
                    let toward = (x - at.x).signum();
                    vec![Pixel::new(at.x + GAP * toward, at.y), Pixel::new(x + BEYOND * toward, at.y)]
                })
                .collect();
            let ends = [Pixel::new(x, top), Pixel::new(x, bottom)];
            for (middle, lines, heads) in line_with_label(ends, bottom - top, size[1], Pixel::new(0.0, 1.0)) {
                let area = Rectangle::around(middle, size[0], size[1]);
                let extensions = extensions.to_vec();
                all.push(Candidate {
                    lines,
                    extensions,
                    heads,
                    ..Candidate::label(area, Feature::DimensionLine)
                });
            }
            // Beside the line, on the side away from the points.
            let beside = Pixel::new(x + side * (size[0] / 2.0 + 4.0), (top + bottom) / 2.0);
            let (lines, heads) = arrows(ends, Pixel::new(0.0, 1.0));
            let area = Rectangle::around(beside, size[0], size[1]);
            let extensions = extensions.to_vec();
            all.push(Candidate {
                lines,
                extensions,
                heads,
                ..Candidate::label(area, Feature::DimensionLine)
            });
        }
    }
    all
}

/// Vertical lines across the axis, beside the contour.
/// `first`: distance of the first one from the points.
pub(super) fn diameters(ends: [Pixel; 2], size: [f64; 2], first: f64) -> Vec<Candidate> {
    let mut all = Vec::new();
    let (top, bottom) = (ends[0].y.min(ends[1].y), ends[0].y.max(ends[1].y));
    for step in 0..TRIES {
        for side in [1.0, -1.0] {
            let x = ends[0].x + side * (first + NEXT * step as f64);
            let extensions =
                ends.map(|at| vec![Pixel::new(at.x + GAP * side, at.y), Pixel::new(x + BEYOND * side, at.y)]);
            let column = [Pixel::new(x, top), Pixel::new(x, bottom)];
            let (lines, heads) = arrows(column, Pixel::new(0.0, 1.0));
            // Not in the middle, where the centre line is.
            for share in [0.25, 0.75, 0.12, 0.88] {
                let y = top + share * (bottom - top);
                for beside in [1.0, -1.0] {
                    let middle = Pixel::new(x + beside * (size[0] / 2.0 + 4.0), y);
                    let area = Rectangle::around(middle, size[0], size[1]);
                    all.push(Candidate {
                        lines: lines.clone(),
                        extensions: extensions.to_vec(),
                        heads: heads.clone(),
                        ..Candidate::label(area, Feature::DimensionLine)
                    });
                }
            }
        }
    }
    all
}

/// An arrow from outside or from the centre to an arc.
pub(super) fn radii(center: Pixel, on: Pixel, size: [f64; 2]) -> Vec<Candidate> {
    let outward = direction(center, on);
    let mut all = Vec::new();
    for distance in [1.0, 1.8, 3.0, 5.0] {
        for side in [1.0, -1.0] {
            let tail = Pixel::new(
                on.x + side * outward.x * distance * 22.0,
                on.y + side * outward.y * distance * 22.0,
            );
            let middle = beyond(tail, Pixel::new(side * outward.x, side * outward.y), size);
            let area = Rectangle::around(middle, size[0], size[1]);
            all.push(Candidate {
                lines: vec![vec![tail, on]],
                heads: vec![head(tail, on)],
                ..Candidate::label(area, Feature::Place(tail))
            });
        }
    }
    all
}

/// An arc between two arms, with an arrow at each end, and both arms as lines.
pub(super) fn angles([vertex, base, end]: [Pixel; 3], size: [f64; 2]) -> Vec<Candidate> {
    let arm = vertex.distance(end);
    let direction = |at: Pixel| (vertex.y - at.y).atan2(at.x - vertex.x);
    let along = direction(base);
    let mut sweep = direction(end) - along;
    if sweep > std::f64::consts::PI {
        sweep -= std::f64::consts::TAU;
    }
    if sweep < -std::f64::consts::PI {
        sweep += std::f64::consts::TAU;
    }
    let mut all = Vec::new();
    for radius in [(0.7 * arm).clamp(16.0, 70.0), (0.9 * arm).clamp(28.0, 90.0)] {
        let at = |angle: f64, radius: f64| {
            Pixel::new(vertex.x + radius * angle.cos(), vertex.y - radius * angle.sin())
        };
        let arc: Vec<Pixel> =
            (0..=12).map(|step| at(along + sweep * f64::from(step) / 12.0, radius)).collect();
        let arms = [along, along + sweep].map(|angle| vec![vertex, at(angle, radius + BEYOND)]);
        let heads = vec![head(arc[10], arc[12]), head(arc[2], arc[0])];
        for share in [0.5, 0.3, 0.8, -0.4, 1.4] {
            let out = radius + 6.0 + size[0] / 2.0;
            let area = Rectangle::around(at(along + sweep * share, out), size[0], size[1]);
            all.push(Candidate {
                lines: vec![arc.clone()],
                extensions: arms.to_vec(),
                heads: heads.clone(),
                ..Candidate::label(area, Feature::Place(arc[6]))
            });
        }
    }
    all
}

/// The label positions on a dimension line: in a gap of the line, or beyond either end if it is too short.
/// `length`: of the line; `needed`: extent of the label along it.
fn line_with_label(
    ends: [Pixel; 2],
    length: f64,
    needed: f64,
    along: Pixel,
) -> Vec<(Pixel, Vec<Line>, Vec<Head>)> {
    let [from, to] = ends;
    let moved = |at: Pixel, by: f64| Pixel::new(at.x + along.x * by, at.y + along.y * by);
    if length >= needed + 2.0 * HEAD[0] + 6.0 {
        let half = (length - needed) / 2.0;
        let lines = vec![vec![from, moved(from, half)], vec![moved(to, -half), to]];
        let heads = vec![head(moved(from, half), from), head(moved(to, -half), to)];
        return vec![(moved(from, length / 2.0), lines, heads)];
    }
    let (lines, heads) = arrows(ends, along);
    let outside = TAIL + needed / 2.0 + 2.0;
    let room = if length >= 2.0 * HEAD[0] + 2.0 { outside - TAIL + 2.0 } else { outside };
    vec![(moved(to, room), lines.clone(), heads.clone()), (moved(from, -room), lines, heads)]
}

/// A dimension line without a gap: arrows from inside, or from outside if it is short.
fn arrows([from, to]: [Pixel; 2], along: Pixel) -> (Vec<Vec<Pixel>>, Vec<[Pixel; 3]>) {
    let moved = |at: Pixel, by: f64| Pixel::new(at.x + along.x * by, at.y + along.y * by);
    if from.distance(to) >= 2.0 * HEAD[0] + 2.0 {
        return (vec![vec![from, to]], vec![head(to, from), head(from, to)]);
    }
    let (before, after) = (moved(from, -TAIL), moved(to, TAIL));
    (vec![vec![before, after]], vec![head(before, from), head(after, to)])
}
