//! Places annotations in a picture, so that labels meet no stroke, no other label and no border.
//!
//! In: annotations in mm, the scene and a camera. Out: [`Placed`]: lines, arrow heads, dots and labels in CSS
//! pixels, which the canvas and the SVG file draw alike. For each annotation several positions are tried, the
//! nearest first; a label without a free position gets a leader line, then a number with a row in a free area, and
//! is otherwise omitted, unless it is required. The width of a text is estimated, so that both
//! painters get the same positions.

use super::annotation::{Annotation, Detail, Importance, Shape};
use super::camera::{Camera, Pixel};
use super::hatch::hatch;
use super::occupied::{Occupied, Rectangle};
use crate::geometry::bounds::Bounds;
use crate::geometry::{Point, SAME, within};
use crate::units::Unit;

/// Height of a label, CSS pixels.
pub const LABEL_HEIGHT: f64 = 16.0;
/// Size of the font, CSS pixels.
pub const FONT_SIZE: f64 = 12.0;
/// Space between text and the edge of its label, CSS pixels.
const PADDING: f64 = 3.0;
/// Length and half width of an arrow head, CSS pixels.
const HEAD: [f64; 2] = [8.0, 2.4];
/// Distance of the first dimension line from the point that it measures.
const FIRST: f64 = 20.0;
/// Distance of each further dimension line, CSS pixels.
pub const NEXT: f64 = 18.0;
/// Number of distances that are tried, and of those that are tried outside before any inside.
const TRIES: usize = 14;
const OUTSIDE: usize = 4;
/// Number of candidates whose label may be moved.
const MOVED: usize = 12;
/// A label at most this far from its dimension line, stroke or point needs no leader line, CSS pixels.
const ADJACENT: f64 = 6.0;
/// A leader line longer than this is replaced by a number with a row, if there is room, CSS pixels: 15 mm on paper.
const LONG_LEADER: f64 = 15.0 / 25.4 * 96.0;
/// Length of an extension line beyond its dimension line, and its distance from the point.
const BEYOND: f64 = 4.0;
const GAP: f64 = 2.0;
/// Length of the tail of an arrow that points at a short distance from outside.
const TAIL: f64 = 12.0;
/// Distance between the places that are tried for the texts of numbers, CSS pixels.
const ROW_STEP: f64 = 20.0;
/// Scales of a detail relative to the picture, and the greatest width and height of its lines, CSS pixels.
const DETAIL_SCALES: [f64; 7] = [50.0, 40.0, 20.0, 10.0, 8.0, 5.0, 2.0];
const DETAIL_SIZE: [f64; 2] = [260.0, 150.0];
/// Space for the labels of a detail to its left and right, and above and below, CSS pixels.
const DETAIL_ROOM: [f64; 2] = [96.0, 40.0];
/// Least radius of the circle around what is enlarged, CSS pixels.
const LEAST_CIRCLE: f64 = 7.0;
/// The name of a detail.
const DETAIL_NAME: &str = "I";
/// Distance of a named point from the middle of its letter.
const BESIDE: f64 = 14.0;

/// A polyline.
type Line = Vec<Pixel>;
/// An arrow head, tip first.
type Head = [Pixel; 3];

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
    /// The labels.
    pub labels: Vec<PlacedLabel>,
    /// The labels that found no place.
    pub omitted: Vec<String>,
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
    place_in(room, annotations, occupied, camera, unit)
}

/// Places annotations in an area of a picture.
fn place_in(
    room: Rectangle,
    annotations: &[Annotation],
    occupied: &Occupied,
    camera: &Camera,
    unit: Unit,
) -> Placed {
    let points = annotations.iter().filter_map(|own| match own.shape {
        Shape::Point(at) => Some(camera.to_screen(at)),
        _ => None,
    });
    let mut placing = Placing {
        points: points.collect(),
        camera,
        unit,
        room,
        occupied,
        dimension_lines: Vec::new(),
        extensions: Vec::new(),
        rows: Vec::new(),
        placed: Placed::default(),
    };
    let mut all: Vec<&Annotation> = annotations.iter().collect();
    // Outlines have a fixed place. Details need the largest areas.
    for annotation in annotations {
        match &annotation.shape {
            Shape::Outline(corners) => placing.add_outline(corners),
            // Without room, its dimensions are at their true places.
            Shape::Detail(detail) if !placing.add_detail(detail) => {
                all.extend(detail.annotations.iter().filter(|own| own.label.value.is_some()));
            }
            _ => {}
        }
    }
    for importance in [Importance::Required, Importance::Usual, Importance::Low] {
        for annotation in all.iter().filter(|annotation| annotation.importance == importance) {
            placing.add(annotation);
        }
    }
    placing.add_rows();
    placing.placed
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
    /// The texts of the labels that are only a number, and the indices of these labels.
    rows: Vec<(String, usize)>,
    placed: Placed,
}

/// A possible way to draw an annotation.
#[derive(Clone)]
struct Candidate {
    /// Dimension lines and leaders.
    lines: Vec<Vec<Pixel>>,
    /// Lines from the points to the dimension line; lines of several dimensions may coincide.
    extensions: Vec<Vec<Pixel>>,
    heads: Vec<[Pixel; 3]>,
    dots: Vec<Pixel>,
    /// The area of the label.
    area: Rectangle,
    /// The line that a leader may touch: the stroke, or a point twice; `None` for the dimension line.
    feature: Option<[Pixel; 2]>,
}

/// The ways to draw an annotation, the best first.
struct Candidates {
    /// As a dimension, with its arrows.
    full: Vec<Candidate>,
    /// Only a leader to the label.
    notes: Vec<Candidate>,
}

impl Placing<'_> {
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
        if let Some(candidate) = self.found(&annotation.shape, size, LONG_LEADER) {
            return self.draw(candidate, text);
        }
        // A name is as short as its number would be.
        if annotation.label.value.is_some() && self.has_room_for_row(&text) {
            let number = self.next_number();
            if let Some(candidate) = self.found(&annotation.shape, size_of(&number), LONG_LEADER) {
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

    /// The number of the next row; with its sign it is no number of a pass.
    fn next_number(&self) -> String {
        format!("*{}", self.rows.len() + 1)
    }

    /// Draws an annotation with a number, whose text is in a row.
    fn draw_number(&mut self, candidate: Candidate, number: String, text: &str) {
        let row = row_of(&number, text);
        self.draw(candidate, number);
        self.rows.push((row, self.placed.labels.len() - 1));
    }

    /// Whether the texts of all numbers and one more text have room.
    fn has_room_for_row(&self, text: &str) -> bool {
        let row = (row_of(&self.next_number(), text), 0);
        let rows: Vec<(String, usize)> = self.rows.iter().cloned().chain([row]).collect();
        self.free_block(&rows).is_some()
    }

    /// The best way to draw an annotation with a label of a size: as a dimension, if necessary with a leader line to
    /// its label; otherwise as a note. `longest`: of a leader line, CSS pixels; if it is limited, a dimension does not
    /// become a note.
    fn found(&self, shape: &Shape, size: [f64; 2], longest: f64) -> Option<Candidate> {
        let Candidates { full, notes } = self.candidates(shape, size);
        let notes = if longest.is_finite() && !full.is_empty() { Vec::new() } else { notes };
        [full, notes].into_iter().find_map(|candidates| {
            let possible = |is_strict: bool| {
                candidates.iter().position(|candidate| {
                    self.is_possible(candidate) && !(is_strict && self.is_confusing(candidate))
                })
            };
            match possible(true).or_else(|| possible(false)) {
                Some(index) => candidates.into_iter().nth(index),
                None => {
                    let mut moved = candidates.into_iter().take(MOVED);
                    moved.find_map(|candidate| self.with_leader(candidate, size, longest))
                }
            }
        })
    }

    fn draw(&mut self, candidate: Candidate, text: String) {
        let Candidate { lines, extensions, heads, dots, area, .. } = candidate;
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

    /// Adds the texts of the numbers where the picture is free, in as few blocks as possible. The labels of the
    /// texts without room are omitted.
    fn add_rows(&mut self) {
        let mut rows = std::mem::take(&mut self.rows);
        while !rows.is_empty() {
            let first = |count: usize| Some((count, self.free_block(&rows[..count])?));
            let Some((count, at)) = (1..=rows.len()).rev().find_map(first) else { break };
            for (row, (text, _)) in rows.drain(..count).enumerate() {
                let min = Pixel::new(at.x, at.y + LABEL_HEIGHT * row as f64);
                let max = Pixel::new(min.x + size_of(&text)[0], min.y + LABEL_HEIGHT);
                self.placed.labels.push(PlacedLabel { text, area: Rectangle { min, max } });
            }
        }
        let (texts, omitted): (Vec<String>, Vec<usize>) = rows.into_iter().unzip();
        self.placed.omitted.extend(texts);
        let mut index = 0;
        self.placed.labels.retain(|_| {
            index += 1;
            !omitted.contains(&(index - 1))
        });
    }

    /// The upper left corner of a free area for rows: at the upper or lower border from the right to the left,
    /// then anywhere else.
    fn free_block(&self, rows: &[(String, usize)]) -> Option<Pixel> {
        let width = rows.iter().map(|(text, _)| size_of(text)[0]).fold(0.0, f64::max);
        let height = LABEL_HEIGHT * rows.len() as f64;
        let [across, down] = self.inside(4.0);
        let steps = |room: f64| (room.max(0.0) / ROW_STEP) as usize;
        let (columns, lines) = (steps(across[1] - across[0] - width), steps(down[1] - down[0] - height));
        let row =
            |y: f64| (0..=columns).map(move |step| Pixel::new(across[1] - width - ROW_STEP * step as f64, y));
        let borders = [down[0], down[1] - height].into_iter();
        let others = (1..lines).map(|step| down[1] - height - ROW_STEP * step as f64);
        borders
            .chain(others)
            .flat_map(row)
            .find(|at| self.is_free(&Rectangle { min: *at, max: Pixel::new(at.x + width, at.y + height) }))
    }

    /// Whether the label meets nothing, and no line meets a label or lies on another dimension line.
    fn is_possible(&self, candidate: &Candidate) -> bool {
        self.is_free(&candidate.area)
            && !candidate.extensions.iter().any(|line| crosses(line, &candidate.area))
            && self.has_free_lines(candidate)
    }

    /// Whether no line meets a label or lies on another dimension line.
    fn has_free_lines(&self, candidate: &Candidate) -> bool {
        let coincides =
            |line: &Vec<Pixel>| self.dimension_lines.iter().any(|other| run_together(line, other));
        !self.meet_label(candidate.lines.iter().chain(&candidate.extensions))
            && !candidate.lines.iter().any(coincides)
    }

    /// Whether a dimension line lies on a stroke or an edge, or crosses an extension line of another dimension.
    fn is_confusing(&self, candidate: &Candidate) -> bool {
        let mut ends = candidate.lines.iter().filter_map(|line| Some([*line.first()?, *line.last()?]));
        ends.any(|[from, to]| self.occupied.covers(from, to)) || self.crosses_dimension(candidate)
    }

    /// Whether a dimension line crosses an extension line of another dimension.
    fn crosses_dimension(&self, candidate: &Candidate) -> bool {
        let cross = |lines: &[Vec<Pixel>], others: &[Vec<Pixel>]| {
            lines.iter().any(|line| others.iter().any(|other| do_cross(line, other)))
        };
        cross(&candidate.lines, &self.extensions) || cross(&candidate.extensions, &self.dimension_lines)
    }

    /// Whether one of the lines passes through a label.
    fn meet_label<'a>(&self, mut lines: impl Iterator<Item = &'a Vec<Pixel>>) -> bool {
        lines.any(|line| self.placed.labels.iter().any(|label| crosses(line, &label.area)))
    }

    fn is_free(&self, area: &Rectangle) -> bool {
        self.is_inside(area)
            && !self.placed.labels.iter().any(|label| label.area.overlaps(area))
            && !self.placed.lines.iter().chain(&self.placed.edges).any(|line| crosses(line, area))
            && !self.placed.hatch.iter().any(|line| crosses(line, area))
            && self.occupied.is_free(area)
    }

    /// The horizontal and vertical ranges for labels, without a margin.
    fn inside(&self, margin: f64) -> [[f64; 2]; 2] {
        let Rectangle { min, max } = self.room;
        [[min.x + margin, max.x - margin], [min.y + margin, max.y - margin]]
    }

    fn is_inside(&self, area: &Rectangle) -> bool {
        let [across, down] = self.inside(2.0);
        across[0] <= area.min.x && area.max.x <= across[1] && down[0] <= area.min.y && area.max.y <= down[1]
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
        Candidate {
            lines: vec![vec![tail, tip]],
            extensions: Vec::new(),
            heads: vec![head(tail, tip)],
            dots: Vec::new(),
            area: Rectangle::around(middle, size[0], size[1]),
            feature: None,
        }
    }

    fn add_outline(&mut self, corners: &[Point]) {
        let closed = corners.iter().chain(corners.first());
        self.placed.lines.push(closed.map(|at| self.camera.to_screen(*at)).collect());
    }

    /// A circle around the detail, and its drawing in a free area, at the largest scale that fits. Returns whether one
    /// fits.
    fn add_detail(&mut self, detail: &Detail) -> bool {
        let middle = self.camera.to_screen(detail.at);
        let radius = (detail.radius * self.camera.scale()).max(LEAST_CIRCLE);
        let circle = (0..=32).map(|step| {
            let (sin, cos) = (f64::from(step) * std::f64::consts::TAU / 32.0).sin_cos();
            Pixel::new(middle.x + radius * cos, middle.y + radius * sin)
        });
        self.placed.lines.push(circle.collect());
        let mut sizes = detail_sizes(detail, self.camera.scale());
        let Some((scale, area)) = sizes.find_map(|(scale, size)| Some((scale, self.free_area(size)?))) else {
            self.placed.lines.pop();
            return false;
        };
        let mut camera = *self.camera;
        camera.zoom(scale, camera.to_screen(detail.at));
        let Bounds { min, max } = bounds_of(detail);
        let middle = Point::new((min.x + max.x) / 2.0, (min.z + max.z) / 2.0);
        let (from, to) = (camera.to_screen(middle), area.middle());
        camera.pan(to.x - from.x, to.y - from.y);
        let on_screen = |lines: &[Vec<Point>]| -> Vec<Vec<Pixel>> {
            let line = |line: &Vec<Point>| line.iter().map(|at| camera.to_screen(*at)).collect();
            lines.iter().map(line).collect()
        };
        let [lines, edges, part] = [&detail.lines, &detail.edges, &detail.part].map(|own| on_screen(own));
        let hatch = hatch(&part, camera.to_screen(detail.at), camera.size());
        let occupied = Occupied::of_lines(&[&lines[..], &edges[..]].concat(), &camera);
        // Below its title.
        let room = Rectangle { min: Pixel::new(area.min.x, area.min.y + LABEL_HEIGHT), max: area.max };
        let mut placed = place_in(room, &detail.annotations, &occupied, &camera, self.unit);
        let text = format!("{DETAIL_NAME} ×{scale}");
        let [width, height] = size_of(&text);
        let title = Rectangle::around(Pixel::new(area.middle().x, area.min.y + height / 2.0), width, height);
        placed.labels.push(PlacedLabel { text, area: title });
        self.placed.lines.extend(lines.into_iter().chain(placed.lines));
        self.placed.edges.extend(edges);
        self.placed.hatch.extend(hatch);
        self.placed.heads.extend(placed.heads);
        self.placed.dots.extend(placed.dots);
        self.placed.labels.extend(placed.labels);
        self.placed.omitted.extend(placed.omitted);
        self.add(&Annotation::note(detail.at, DETAIL_NAME));
        true
    }

    /// A free area of a size: from the lower right corner to the left and up.
    fn free_area(&self, [width, height]: [f64; 2]) -> Option<Rectangle> {
        let [across, down] = self.inside(2.0);
        let steps = |room: f64| if room < 0.0 { 0 } else { (room / ROW_STEP) as usize + 1 };
        let columns = steps(across[1] - across[0] - width);
        let lines = (0..steps(down[1] - down[0] - height)).map(|step| down[1] - ROW_STEP * step as f64);
        let mut areas = lines.flat_map(|bottom| {
            (0..columns).map(move |step| {
                let right = across[1] - ROW_STEP * step as f64;
                let min = Pixel::new(right - width, bottom - height);
                Rectangle { min, max: Pixel::new(right, bottom) }
            })
        });
        areas.find(|area| self.is_free(area))
    }

    fn candidates(&self, shape: &Shape, size: [f64; 2]) -> Candidates {
        let screen = |at: Point| self.camera.to_screen(at);
        let note = |at: Point| around_point(screen(at), size, false);
        let (full, notes) = match *shape {
            Shape::Detail(_) | Shape::Outline(_) => (Vec::new(), Vec::new()),
            Shape::Point(at) => (self.letters(screen(at), size), Vec::new()),
            Shape::Note(at) => (Vec::new(), note(at)),
            Shape::Axial(ends) => {
                let out = self.camera.upward().signum();
                (dimension_lines(ends.map(screen), size, out), note(ends[1]))
            }
            Shape::Radial(ends) => {
                let is_on_axis = ends.map(|at| at.x.abs() < SAME);
                let middle = Point::new((ends[0].x + ends[1].x) / 2.0, (ends[0].z + ends[1].z) / 2.0);
                (dimension_columns(ends.map(screen), is_on_axis, size), note(middle))
            }
            Shape::Diameter(at) => (self.across(at, size, FIRST), note(at)),
            Shape::DiameterThrough(at) => (self.across(at, size, 0.0), note(at)),
            Shape::Step(ends) => (beside(ends.map(screen), size), Vec::new()),
            Shape::Radius { center, on } => (radii(screen(center), screen(on), size), note(on)),
            Shape::Angle { vertex, base, end } => {
                (angles([vertex, base, end].map(screen), size), note(vertex))
            }
        };
        Candidates { full, notes }
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

    /// A candidate with its label at the nearest free place, and a leader line from its dimension line, stroke or
    /// point to the label.
    fn with_leader(&self, candidate: Candidate, size: [f64; 2], longest: f64) -> Option<Candidate> {
        // The gap for the label is closed.
        let lines = match &candidate.lines[..] {
            [first, last] => vec![vec![*first.first()?, *last.last()?]],
            // A note gets a new leader.
            _ if candidate.feature.is_some() && candidate.heads.is_empty() => Vec::new(),
            _ => candidate.lines.clone(),
        };
        let feature = match candidate.feature {
            Some(feature) => feature,
            None => middle_part(lines.first()?)?,
        };
        let candidate = Candidate { lines, ..candidate };
        if !self.has_free_lines(&candidate) {
            return None;
        }
        let (area, leader) = self.nearest_free(&candidate, feature, size, longest)?;
        Some(Candidate { lines: [candidate.lines, leader].concat(), area, ..candidate })
    }

    /// The free area for a label that is nearest to its usual place, and the leader line to it from `feature`, if one is
    /// needed. `longest`: of the leader line, CSS pixels.
    fn nearest_free(
        &self,
        candidate: &Candidate,
        feature: [Pixel; 2],
        size: [f64; 2],
        longest: f64,
    ) -> Option<(Rectangle, Vec<Vec<Pixel>>)> {
        let usual = candidate.area.middle();
        let own = || candidate.lines.iter().chain(&candidate.extensions);
        let rings = (0..24).flat_map(|ring| (0..16).map(move |turn| (f64::from(ring), f64::from(turn))));
        rings
            .map(|(ring, turn)| {
                let (sin, cos) = (turn * std::f64::consts::TAU / 16.0 + 0.4).sin_cos();
                let middle = Pixel::new(usual.x + 14.0 * ring * cos, usual.y - 14.0 * ring * sin);
                let area = Rectangle::around(middle, size[0], size[1]);
                let from = nearest_on(feature, middle);
                (area, [from, area.nearest(from)])
            })
            .find_map(|(area, leader)| {
                let is_possible = self.is_free(&area) && !own().any(|line| crosses(line, &area));
                let length = leader[0].distance(leader[1]);
                if !is_possible || length <= ADJACENT {
                    return is_possible.then(|| (area, Vec::new()));
                }
                let line = leader.to_vec();
                let is_clear = length <= longest
                    && is_slanted(leader)
                    && !self.meet_label(std::iter::once(&line))
                    && !own().any(|other| do_cross(&line, other));
                is_clear.then(|| (area, vec![line]))
            })
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

/// The scales of a detail that are small enough, the largest first, each with the size of the drawing and its labels,
/// CSS pixels; `scale`: that of the picture.
pub fn detail_sizes(detail: &Detail, scale: f64) -> impl Iterator<Item = (f64, [f64; 2])> {
    let bounds = bounds_of(detail);
    let own = [bounds.length() * scale, bounds.height() * scale];
    let sizes = DETAIL_SCALES.into_iter().map(move |factor| (factor, own.map(|length| factor * length)));
    sizes.filter(|(_, size)| size[0] <= DETAIL_SIZE[0] && size[1] <= DETAIL_SIZE[1]).map(
        |(factor, [width, height])| {
            let [beside, around] = DETAIL_ROOM;
            (factor, [width + 2.0 * beside, height + 2.0 * around])
        },
    )
}

fn bounds_of(detail: &Detail) -> Bounds {
    let Detail { lines, edges, part, .. } = detail;
    let corners = [lines, edges, part].into_iter().flatten().flatten();
    corners.fold(Bounds::of(detail.at), |bounds, at| bounds.with(*at))
}

/// The middle of a label that begins where a line in the direction `towards` ends.
fn beyond(end: Pixel, towards: Pixel, [width, height]: [f64; 2]) -> Pixel {
    let across = (width / 2.0 + 2.0) / towards.x.abs().max(1e-6);
    let up = (height / 2.0 + 2.0) / towards.y.abs().max(1e-6);
    let reach = across.min(up);
    Pixel::new(end.x + reach * towards.x, end.y + reach * towards.y)
}

/// The row of a number with its text.
fn row_of(number: &str, text: &str) -> String {
    format!("{number}: {text}")
}

/// Width and height of the label of a text, CSS pixels.
fn size_of(text: &str) -> [f64; 2] {
    [text_width(text) + 2.0 * PADDING, LABEL_HEIGHT]
}

/// A letter at eight positions around a point.
fn around_point(at: Pixel, size: [f64; 2], dot: bool) -> Vec<Candidate> {
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
            let feature = Some([at, at]);
            all.push(Candidate { lines, extensions: Vec::new(), heads: Vec::new(), dots, area, feature });
        }
    }
    all
}

/// Positions beside a stroke, at its middle first.
fn beside([from, to]: [Pixel; 2], size: [f64; 2]) -> Vec<Candidate> {
    let unit = direction(from, to);
    let mut all = Vec::new();
    for share in [0.5, 0.35, 0.65, 0.2, 0.8] {
        for side in [1.0, -1.0] {
            let away = side * (size[1] / 2.0 + 3.0 + (size[0] - size[1]).max(0.0) / 2.0 * unit.y.abs());
            let at = |share: f64| Pixel::at_share([from, to], share);
            let middle = Pixel::new(at(share).x + away * unit.y, at(share).y - away * unit.x);
            let area = Rectangle::around(middle, size[0], size[1]);
            all.push(Candidate {
                lines: Vec::new(),
                extensions: Vec::new(),
                heads: Vec::new(),
                dots: Vec::new(),
                area,
                feature: Some([at(0.25), at(0.75)]),
            });
        }
    }
    all
}

/// Horizontal dimension lines above and below two points. `out`: 1 if away from the axis is up on the screen.
fn dimension_lines([a, b]: [Pixel; 2], size: [f64; 2], out: f64) -> Vec<Candidate> {
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
            all.push(Candidate { lines, extensions, heads, dots: Vec::new(), area, feature: None });
        }
    }
    all
}

/// Vertical dimension lines to the right and left of two points. `is_on_axis`: these have no extension line, which
/// would hide the centre line.
fn dimension_columns([a, b]: [Pixel; 2], is_on_axis: [bool; 2], size: [f64; 2]) -> Vec<Candidate> {
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
                all.push(Candidate { lines, extensions, heads, dots: Vec::new(), area, feature: None });
            }
            // Beside the line, on the side away from the points.
            let beside = Pixel::new(x + side * (size[0] / 2.0 + 4.0), (top + bottom) / 2.0);
            let (lines, heads) = arrows(ends, Pixel::new(0.0, 1.0));
            let area = Rectangle::around(beside, size[0], size[1]);
            let extensions = extensions.to_vec();
            all.push(Candidate { lines, extensions, heads, dots: Vec::new(), area, feature: None });
        }
    }
    all
}

/// Vertical lines across the axis, beside the contour.
/// `first`: distance of the first one from the points.
fn diameters(ends: [Pixel; 2], size: [f64; 2], first: f64) -> Vec<Candidate> {
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
                        dots: Vec::new(),
                        area,
                        feature: None,
                    });
                }
            }
        }
    }
    all
}

/// An arrow from outside or from the centre to an arc.
fn radii(center: Pixel, on: Pixel, size: [f64; 2]) -> Vec<Candidate> {
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
                extensions: Vec::new(),
                heads: vec![head(tail, on)],
                dots: Vec::new(),
                area,
                feature: Some([tail, tail]),
            });
        }
    }
    all
}

/// An arc between two arms, with an arrow at each end, and both arms as lines.
fn angles([vertex, base, end]: [Pixel; 3], size: [f64; 2]) -> Vec<Candidate> {
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
                dots: Vec::new(),
                area,
                feature: Some([arc[6], arc[6]]),
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

/// Whether two straight lines along one axis of the screen run side by side, too close to tell apart.
fn run_together(a: &[Pixel], b: &[Pixel]) -> bool {
    let (Some(a), Some(b)) = (ends_of(a), ends_of(b)) else { return false };
    let overlap =
        |a: [f64; 2], b: [f64; 2]| a[0].max(a[1]).min(b[0].max(b[1])) - a[0].min(a[1]).max(b[0].min(b[1]));
    let [ax, ay] = [[a[0].x, a[1].x], [a[0].y, a[1].y]];
    let [bx, by] = [[b[0].x, b[1].x], [b[0].y, b[1].y]];
    let is_flat = |values: [f64; 2]| (values[0] - values[1]).abs() < 0.5;
    let is_near = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).abs() < LABEL_HEIGHT / 2.0;
    (is_flat(ay) && is_flat(by) && is_near(ay, by) && overlap(ax, bx) > 1.0)
        || (is_flat(ax) && is_flat(bx) && is_near(ax, bx) && overlap(ay, by) > 1.0)
}

/// Whether a horizontal and a vertical line cross, not only touch.
fn do_cross(a: &[Pixel], b: &[Pixel]) -> bool {
    let (Some(a), Some(b)) = (ends_of(a), ends_of(b)) else { return false };
    let is_inside = |at: f64, one: f64, other: f64| one.min(other) + 1.0 < at && at < one.max(other) - 1.0;
    let cross = |flat: [Pixel; 2], steep: [Pixel; 2]| {
        (flat[0].y - flat[1].y).abs() < 0.5
            && (steep[0].x - steep[1].x).abs() < 0.5
            && is_inside(steep[0].x, flat[0].x, flat[1].x)
            && is_inside(flat[0].y, steep[0].y, steep[1].y)
    };
    cross(a, b) || cross(b, a)
}

/// The ends of a line with two corners.
fn ends_of(line: &[Pixel]) -> Option<[Pixel; 2]> {
    line.try_into().ok()
}

/// The part of a line that a leader may touch: not its arrows.
fn middle_part(line: &[Pixel]) -> Option<[Pixel; 2]> {
    let ends = [*line.first()?, *line.last()?];
    Some([0.35, 0.65].map(|share| Pixel::at_share(ends, share)))
}

/// The point of a straight line that is nearest to `at`.
fn nearest_on([from, to]: [Pixel; 2], at: Pixel) -> Pixel {
    let (x, y) = (to.x - from.x, to.y - from.y);
    let square = x * x + y * y;
    let share = if square < 1e-9 { 0.0 } else { ((at.x - from.x) * x + (at.y - from.y) * y) / square };
    Pixel::at_share([from, to], within(share, 0.0, 1.0))
}

/// Whether a leader is neither level nor upright: those could be taken for strokes and dimension lines (ISO 128-22).
fn is_slanted([from, to]: [Pixel; 2]) -> bool {
    let unit = direction(from, to);
    unit.x.abs().min(unit.y.abs()) > 0.12
}

/// The unit vector from one position to another.
fn direction(from: Pixel, to: Pixel) -> Pixel {
    let length = from.distance(to);
    if length < 1e-9 {
        return Pixel::new(0.0, -1.0);
    }
    Pixel::new((to.x - from.x) / length, (to.y - from.y) / length)
}

/// An arrow head with its tip at `tip`, coming from `from`.
fn head(from: Pixel, tip: Pixel) -> [Pixel; 3] {
    let unit = direction(from, tip);
    let corner = |side: f64| {
        Pixel::new(
            tip.x - unit.x * HEAD[0] - unit.y * side * HEAD[1],
            tip.y - unit.y * HEAD[0] + unit.x * side * HEAD[1],
        )
    };
    [tip, corner(1.0), corner(-1.0)]
}

/// Whether a polyline passes through a rectangle.
fn crosses(line: &[Pixel], area: &Rectangle) -> bool {
    line.windows(2).any(|ends| {
        let [from, to] = [ends[0], ends[1]];
        // Liang and Barsky: the part of the line inside each pair of parallel borders.
        let (mut enter, mut leave) = (0.0, 1.0f64);
        for (delta, start, min, max) in
            [(to.x - from.x, from.x, area.min.x, area.max.x), (to.y - from.y, from.y, area.min.y, area.max.y)]
        {
            if delta.abs() < 1e-9 {
                if start <= min || start >= max {
                    return false;
                }
                continue;
            }
            let (a, b) = ((min - start) / delta, (max - start) / delta);
            enter = f64::max(enter, a.min(b));
            leave = f64::min(leave, a.max(b));
        }
        enter < leave
    })
}
