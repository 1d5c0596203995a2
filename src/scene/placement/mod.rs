//! Places annotations in a picture, so that labels meet no stroke, no other label and no border.
//!
//! In: annotations in mm, the scene and a camera. Out: [`Placed`]: lines, arrow heads, dots and labels in CSS
//! pixels, which the canvas and the SVG file draw alike. For each annotation several positions are tried, the
//! nearest first; a label without a free position gets a leader line, then a number with a row in a free area, and
//! is otherwise omitted, unless it is required. The width of a text is estimated, so that both
//! painters get the same positions.

use std::cmp::Reverse;

use super::annotation::{Annotation, Importance, Shape};
use super::camera::{Camera, Pixel};
use super::hatch::{Slant, hatch_slanted};
use super::occupied::{Occupied, Rectangle};
use crate::geometry::{Point, SAME, extent, within};
use crate::units::Unit;

mod candidates;
mod conflicts;
mod detail;
mod leaders;
mod lines;
mod rows;

use candidates::{
    ARROW_AWAY, BESIDE, Candidate, Candidates, FIRST, Feature, angles, around_point, beside, beside_arrow,
    beyond, diameters, dimension_columns, dimension_lines, radii,
};
pub use detail::detail_sizes;
use lines::{HEAD, OTHER_POSITION, dashed, direction, ends_of, head, nearest_on};

/// Height of a label, CSS pixels.
pub const LABEL_HEIGHT: f64 = 16.0;
/// Size of the font, CSS pixels.
pub const FONT_SIZE: f64 = 12.0;
/// Radius of the dot of a named point, CSS pixels.
pub const DOT: f64 = 3.0;
/// Radius of the dot at the end of a leader line, CSS pixels.
pub const END: f64 = 2.0;
/// Space between text and the edge of its label, CSS pixels.
const PADDING: f64 = 3.0;
/// Distance of each further dimension line, CSS pixels.
pub const NEXT: f64 = 18.0;
/// Number of candidates whose label may be moved.
const MOVED: usize = 12;
/// A leader line longer than this share of the width of the picture, at most 15 mm on paper, is replaced by a number with
/// a row, if there is room.
const LONG_LEADER: f64 = 15.0 / 25.4 * 96.0;
const LONG_SHARE: f64 = 0.09;
/// A leader line of a step that is preferred, CSS pixels: 8 mm on paper.
const SHORT_LEADER: f64 = 8.0 / 25.4 * 96.0;
/// Least length of the part of a stroke that no stroke in the opposite direction covers, CSS pixels; on a shorter one, an
/// arrow is beside the number.
const LEAST_OWN: f64 = 12.0;
/// Distance between the places that are tried for the texts of numbers, CSS pixels.
const ROW_STEP: f64 = 20.0;

/// A label at its place.
#[derive(Clone, Debug, PartialEq)]
pub struct PlacedLabel {
    /// The text, centred in the rectangle.
    pub text: String,
    /// The area of the label.
    pub area: Rectangle,
}

/// Annotations at their places.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Placed {
    /// Thin lines.
    pub lines: Vec<Vec<Pixel>>,
    /// Thick lines: the edges of the part in details.
    pub edges: Vec<Vec<Pixel>>,
    /// Hatching of the part in details.
    pub hatch: Vec<[Pixel; 2]>,
    /// Arrow heads, tip first.
    pub heads: Vec<[Pixel; 3]>,
    /// Dots of named points.
    pub dots: Vec<Pixel>,
    /// Small dots at the ends of leader lines on strokes.
    pub ends: Vec<Pixel>,
    /// The labels.
    pub labels: Vec<PlacedLabel>,
    /// The labels that found no place.
    pub omitted: Vec<String>,
}

impl Placed {
    /// The highest and the lowest place of the lines and labels, CSS pixels; `None` if there are none.
    pub fn down(&self) -> Option<[f64; 2]> {
        let lines = self.lines.iter().chain(&self.edges).flatten().chain(&self.dots).map(|at| at.y);
        let areas = self.labels.iter().flat_map(|label| [label.area.min.y, label.area.max.y]);
        extent(lines.chain(areas))
    }
}

/// The estimated width of a text in the font of labels, CSS pixels; a little more than the true one.
pub fn text_width(text: &str) -> f64 {
    let width = |character: char| match character {
        '①'..='⑳' => 1.05,
        '.' | ',' | '′' | ' ' | '°' | 'i' | 'l' => 0.36,
        'Δ' | 'm' | 'M' | 'W' | 'Ø' | '=' | '−' => 0.84,
        _ if character as u32 >= 0x2e80 => 1.05,
        _ => 0.66,
    };
    text.chars().map(width).sum::<f64>() * FONT_SIZE
}

/// Places annotations, the most important first. `occupied`: the strokes of the picture.
pub fn place(annotations: &[Annotation], occupied: &Occupied, camera: &Camera, unit: Unit) -> Placed {
    let [across, down] = camera.inside(0.0);
    let room = Rectangle { min: Pixel::new(across[0], down[0]), max: Pixel::new(across[1], down[1]) };
    let mut placing = Placing::new(room, occupied, camera, unit);
    placing.add_all(annotations);
    placing.add_rows();
    placing.placed
}

/// Where the texts of numbers are: in the area itself, or in the picture around a detail.
#[derive(Clone, Copy, PartialEq)]
enum PlaceOfRows {
    Inside,
    Outside,
}

/// The annotations that are placed, and the free space.
struct Placing<'a> {
    /// The named points.
    points: Vec<Pixel>,
    camera: &'a Camera,
    unit: Unit,
    /// The area for all labels.
    room: Rectangle,
    occupied: &'a Occupied,
    /// The placed dimension lines and extension lines.
    dimension_lines: Vec<Vec<Pixel>>,
    extensions: Vec<Vec<Pixel>>,
    /// The placed leader lines, and the positions on strokes that numbers of steps mark.
    leaders: Vec<[Pixel; 2]>,
    tips: Vec<Pixel>,
    /// Number of details.
    details: usize,
    /// The texts of the labels that are only a number, and the indices of these labels.
    rows: Vec<(String, usize)>,
    place_of_rows: PlaceOfRows,
    placed: Placed,
}

impl<'a> Placing<'a> {
    /// Nothing in an area of a picture.
    fn new(room: Rectangle, occupied: &'a Occupied, camera: &'a Camera, unit: Unit) -> Self {
        Self {
            points: Vec::new(),
            camera,
            unit,
            room,
            occupied,
            dimension_lines: Vec::new(),
            extensions: Vec::new(),
            leaders: Vec::new(),
            tips: Vec::new(),
            details: 0,
            rows: Vec::new(),
            place_of_rows: PlaceOfRows::Inside,
            placed: Placed::default(),
        }
    }

    fn add_all(&mut self, annotations: &[Annotation]) {
        let points = annotations.iter().filter_map(|own| match own.shape {
            Shape::Point(at) => Some(self.camera.to_screen(at)),
            _ => None,
        });
        self.points = points.collect();
        let mut all: Vec<&Annotation> = annotations.iter().collect();
        let mut names = Vec::new();
        // Outlines have a fixed place. Details need the largest areas.
        for annotation in annotations {
            match &annotation.shape {
                Shape::Outline(corners) => self.add_outline(corners),
                Shape::Zone { outline, way, .. } => self.add_zone(outline, *way),
                Shape::Detail(detail) => match self.add_detail(detail) {
                    Some(name) => names.push(name),
                    // Its dimensions are at their true places.
                    None => all.extend(detail.annotations.iter().filter(|own| own.label.value.is_some())),
                },
                _ => {}
            }
        }
        // A short stroke has the fewest places for its number, then dimensions and the names of details; the number of a long
        // stroke may be anywhere along it.
        all.extend(&names);
        all.sort_by_key(|own| (Reverse(own.importance), self.freedom(&own.shape)));
        for annotation in all {
            self.add(annotation);
        }
    }

    /// How much choice a label has: the number of a short stroke and the label of a zone least, the number of a long stroke
    /// most.
    fn freedom(&self, shape: &Shape) -> u8 {
        match shape {
            Shape::Step(ends) => {
                let [from, to] = ends.map(|at| self.camera.to_screen(at));
                if from.distance(to) < LEAST_OWN { 0 } else { 2 }
            }
            Shape::Zone { .. } => 0,
            _ => 1,
        }
    }

    fn add(&mut self, annotation: &Annotation) {
        if let Shape::Detail(_) | Shape::Outline(_) = annotation.shape {
            return;
        }
        let text = annotation.label.text(self.unit);
        let size = size_of(&text);
        if let Some((at, towards)) = self.direction_outside(&annotation.shape) {
            if annotation.importance == Importance::Low {
                return;
            }
            let candidate = self.beyond_border(at, towards, size);
            return match self.is_possible(&candidate) || annotation.importance == Importance::Required {
                true => self.draw(candidate, text),
                false => self.placed.omitted.push(text),
            };
        }
        let longest = LONG_LEADER.min(LONG_SHARE * self.camera.size().width);
        // The number of a step is as near as possible.
        let is_step = matches!(annotation.shape, Shape::Step(_));
        let near = if is_step { self.found(&annotation.shape, size, SHORT_LEADER) } else { None };
        if let Some(candidate) = near.or_else(|| self.found(&annotation.shape, size, longest)) {
            return self.draw(candidate, text);
        }
        // A name is as short as its number would be.
        if annotation.label.value.is_some() && self.has_room_for_row(&text) {
            let number = self.next_number();
            if let Some(candidate) = self.found(&annotation.shape, size_of(&number), longest) {
                return self.draw_number(candidate, number, &text);
            }
        }
        if let Some(candidate) = self.found(&annotation.shape, size, f64::INFINITY) {
            return self.draw(candidate, text);
        }
        let number = self.next_number();
        if !text.is_empty()
            && let Some(candidate) = self.found(&annotation.shape, size_of(&number), f64::INFINITY)
        {
            return self.draw_number(candidate, number, &text);
        }
        let Candidates { full, notes } = self.candidates(&annotation.shape, size);
        let first = full.into_iter().chain(notes).next();
        match first.filter(|_| annotation.importance == Importance::Required) {
            Some(first) => self.draw(self.moved_inside(first, size), text),
            None => self.placed.omitted.push(text),
        }
    }

    /// The best way to draw an annotation with a label of a size: as a dimension, if necessary with a leader line to
    /// its label; otherwise as a note. `longest`: of a leader line, CSS pixels; if it is limited, a dimension does not
    /// become a note, and does not lie on a stroke.
    fn found(&self, shape: &Shape, size: [f64; 2], longest: f64) -> Option<Candidate> {
        let Candidates { full, notes } = self.candidates(shape, size);
        let notes = if longest.is_finite() && !full.is_empty() { Vec::new() } else { notes };
        let found = [&full, &notes].into_iter().find_map(|candidates| self.best(candidates, size, longest));
        found.or_else(|| if longest.is_finite() { None } else { self.over_strokes(full, size) })
    }

    /// The best of the candidates: in its place without confusion, in its place, with a leader. The number of a step is
    /// rather at a leader than where it is confusing.
    fn best(&self, candidates: &[Candidate], size: [f64; 2], longest: f64) -> Option<Candidate> {
        // A leader may lie over strokes.
        let is_clear =
            |own: &&Candidate| matches!(own.feature, Feature::Place(_)) || !self.lies_on_stroke(own);
        let in_place = || candidates.iter().filter(is_clear).filter(|own| self.is_possible(own));
        let moved = || {
            let mut moved = candidates.iter().filter(is_clear).take(MOVED).cloned();
            moved.find_map(|own| self.with_leader(own, size, longest))
        };
        let is_of_step = candidates.first().is_some_and(|own| matches!(own.feature, Feature::Stroke(_)));
        let found = in_place().find(|own| !self.is_confusing(own)).cloned();
        let found = found.or_else(|| if is_of_step { moved() } else { in_place().next().cloned() });
        found.or_else(|| if is_of_step { None } else { moved() })
    }

    /// A candidate whose lines may lie on strokes.
    fn over_strokes(&self, candidates: Vec<Candidate>, size: [f64; 2]) -> Option<Candidate> {
        let possible = candidates.iter().find(|own| self.is_possible(own)).cloned();
        possible.or_else(|| {
            candidates.into_iter().take(MOVED).find_map(|own| self.with_leader(own, size, f64::INFINITY))
        })
    }

    fn draw(&mut self, candidate: Candidate, text: String) {
        let Candidate { lines, extensions, heads, dots, ends, leader, area, feature } = candidate;
        if let Feature::Stroke(tip) = feature {
            self.tips.push(tip);
        }
        self.tips.extend(&ends);
        // The line from a dot to its label is a leader.
        let from_dot = ends.first().and_then(|_| ends_of(lines.first()?));
        self.leaders.extend(leader.or(from_dot));
        self.placed.lines.extend(leader.map(|ends| ends.to_vec()));
        self.placed.ends.extend(ends);
        self.dimension_lines.extend(lines.iter().cloned());
        self.extensions.extend(extensions.iter().cloned());
        self.placed.lines.extend(lines);
        for line in extensions {
            match ends_of(&line) {
                Some(ends) => {
                    let pieces = self.occupied.beside_strokes(ends).into_iter();
                    self.placed.lines.extend(pieces.map(|piece| piece.to_vec()));
                }
                None => self.placed.lines.push(line),
            }
        }
        self.placed.heads.extend(heads);
        self.placed.dots.extend(dots);
        if !text.is_empty() {
            self.placed.labels.push(PlacedLabel { text, area });
        }
    }

    /// If no point of a shape is visible: the nearest position at the border, and the direction outwards.
    fn direction_outside(&self, shape: &Shape) -> Option<(Pixel, Pixel)> {
        let [across, down] = self.inside(0.0);
        let points: Vec<Pixel> = shape.points().into_iter().map(|at| self.camera.to_screen(at)).collect();
        let is_seen =
            |at: &Pixel| (across[0]..=across[1]).contains(&at.x) && (down[0]..=down[1]).contains(&at.y);
        if points.iter().any(is_seen) {
            return None;
        }
        let at = *points.first()?;
        let [across, down] = self.inside(4.0);
        let tip = Pixel::new(within(at.x, across[0], across[1]), within(at.y, down[0], down[1]));
        Some((tip, at))
    }

    /// An arrow at the border towards a shape outside the picture.
    fn beyond_border(&self, tip: Pixel, towards: Pixel, size: [f64; 2]) -> Candidate {
        let unit = direction(tip, towards);
        let tail = Pixel::new(tip.x - 20.0 * unit.x, tip.y - 20.0 * unit.y);
        let middle = beyond(tail, Pixel::new(-unit.x, -unit.y), size);
        let label = Candidate::label(Rectangle::around(middle, size[0], size[1]), Feature::DimensionLine);
        Candidate { lines: vec![vec![tail, tip]], heads: vec![head(tail, tip)], ..label }
    }

    fn add_outline(&mut self, corners: &[Point]) {
        let closed = corners.iter().chain(corners.first());
        self.placed.lines.push(closed.map(|at| self.camera.to_screen(*at)).collect());
    }

    /// Hatches a zone; `way`: a path along it that is not taken.
    fn add_zone(&mut self, outline: &[Point], way: [Point; 2]) {
        let corners: Vec<Pixel> = outline.iter().map(|at| self.camera.to_screen(*at)).collect();
        let zero = self.camera.to_screen(Point::default());
        self.placed.lines.extend(dashed(way.map(|at| self.camera.to_screen(at)), OTHER_POSITION));
        self.placed.hatch.extend(hatch_slanted(&[corners], zero, self.camera.size(), Slant::Falling));
    }

    fn candidates(&self, shape: &Shape, size: [f64; 2]) -> Candidates {
        let screen = |at: Point| self.camera.to_screen(at);
        let note = |at: Point| around_point(screen(at), size, false);
        let (full, notes) = match *shape {
            Shape::Detail(_) | Shape::Outline(_) => (Vec::new(), Vec::new()),
            Shape::Point(at) => (self.letters(screen(at), size), Vec::new()),
            Shape::Note(at) => (Vec::new(), note(at)),
            Shape::Zone { mark, .. } => {
                let at = screen(mark);
                let notes = around_point(at, size, false).into_iter();
                (Vec::new(), notes.map(|note| Candidate { ends: vec![at], ..note }).collect())
            }
            Shape::Axial(ends) => {
                // Away from the axis, also below it.
                let below = ends[0].x + ends[1].x < -SAME;
                let out = self.camera.upward().signum() * if below { -1.0 } else { 1.0 };
                (dimension_lines(ends.map(screen), size, out), note(ends[1]))
            }
            Shape::Radial(ends) => {
                let is_on_axis = ends.map(|at| at.x.abs() < SAME);
                let middle = Point::new((ends[0].x + ends[1].x) / 2.0, (ends[0].z + ends[1].z) / 2.0);
                (dimension_columns(ends.map(screen), is_on_axis, size), note(middle))
            }
            Shape::Diameter(at) => (self.across(at, size, FIRST), note(at)),
            Shape::DiameterThrough(at) => (self.across(at, size, 0.0), note(at)),
            Shape::Step(ends) => {
                let stroke = ends.map(screen);
                (self.steps(stroke, size), beside(stroke, size))
            }
            Shape::Radius { center, on } => (radii(screen(center), screen(on), size), note(on)),
            Shape::Angle { vertex, base, end } => {
                (angles([vertex, base, end].map(screen), size), note(vertex))
            }
        };
        Candidates { full, notes }
    }

    /// The number of a step beside its stroke. Where strokes in the opposite direction cover it, the number has an arrow,
    /// which is not nearer to another stroke.
    fn steps(&self, stroke: [Pixel; 2], size: [f64; 2]) -> Vec<Candidate> {
        let length = |piece: &[Pixel; 2]| piece[0].distance(piece[1]);
        if length(&stroke) < LEAST_OWN {
            return beside(stroke, size);
        }
        let pieces = self.occupied.beside_opposite(stroke);
        let longest = pieces.into_iter().max_by(|a, b| length(a).total_cmp(&length(b)));
        let Some(own) = longest.filter(|own| length(own) >= LEAST_OWN) else {
            return self.arrows(stroke, size);
        };
        // There is its arrow head.
        let middle = Pixel::at_share(stroke, 0.5);
        if nearest_on(own, middle).distance(middle) < HEAD[0] {
            beside(own, size)
        } else {
            self.arrows(stroke, size)
        }
    }

    fn arrows(&self, stroke: [Pixel; 2], size: [f64; 2]) -> Vec<Candidate> {
        let is_own = |own: &Candidate| {
            let arrow = own.lines.first().and_then(|line| ends_of(line));
            arrow.is_some_and(|arrow| self.occupied.distance_beside(arrow) > ARROW_AWAY - 0.5)
        };
        beside_arrow(stroke, size).into_iter().filter(is_own).collect()
    }

    /// A letter beside its point. If another point is so near that the letters could be confused, it has a leader line,
    /// and is on the side away from the other point.
    fn letters(&self, at: Pixel, size: [f64; 2]) -> Vec<Candidate> {
        let mut all = around_point(at, size, true);
        let near = |other: &&Pixel| (0.1..BESIDE).contains(&other.distance(at));
        // A picked place without a letter needs no leader.
        if size[0] > 2.0 * PADDING
            && let Some(other) = self.points.iter().find(near)
        {
            let away = direction(*other, at);
            let side = |candidate: &Candidate| {
                let middle = candidate.area.middle();
                (middle.x - at.x) * away.x + (middle.y - at.y) * away.y
            };
            all.retain(|candidate| !candidate.lines.is_empty() && side(candidate) > 0.0);
        }
        all
    }

    /// Lines across the axis.
    fn across(&self, at: Point, size: [f64; 2], first: f64) -> Vec<Candidate> {
        diameters([at, Point::new(-at.x, at.z)].map(|at| self.camera.to_screen(at)), size, first)
    }

    /// A candidate whose label is moved into the picture, whatever it hides.
    fn moved_inside(&self, candidate: Candidate, size: [f64; 2]) -> Candidate {
        let [across, down] = self.inside(2.0);
        let inside = |at: f64, half: f64, [least, most]: [f64; 2]| within(at, least + half, most - half);
        let middle = candidate.area.middle();
        let middle =
            Pixel::new(inside(middle.x, size[0] / 2.0, across), inside(middle.y, size[1] / 2.0, down));
        Candidate { area: Rectangle::around(middle, size[0], size[1]), ..candidate }
    }
}

/// The row of a number with its text.
fn row_of(number: &str, text: &str) -> String {
    format!("{number}: {text}")
}

/// Width and height of the label of a text, CSS pixels.
fn size_of(text: &str) -> [f64; 2] {
    [text_width(text) + 2.0 * PADDING, LABEL_HEIGHT]
}
