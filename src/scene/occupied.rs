//! The areas of a picture that labels must not cover.
//!
//! In: the strokes and edges of a scene, and a camera. Out: [`Occupied`], a coarse map of the picture. A map
//! costs the same for ten strokes and for a million.

use super::camera::{Camera, Pixel, Size};
use super::work::{closed, outlines};
use super::{Plane, Scene, StrokeShape};
use crate::geometry::Point;
use crate::machine::region::Region;

/// Edge length of a cell, CSS pixels.
const CELL: f64 = 4.0;
/// Maximum number of strokes that are entered; in a picture with more, labels may cover some.
const MAX_STROKES: usize = 50_000;
/// Maximum number of straight strokes that are compared with a line.
const MAX_STRAIGHT: usize = 5_000;
/// A line this near to a stroke is drawn over it, CSS pixels.
const ALONG: f64 = 1.5;
/// Least length of a piece of a line, CSS pixels.
const LEAST_PIECE: f64 = 2.0;

/// A rectangle, CSS pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rectangle {
    /// The upper left corner.
    pub min: Pixel,
    /// The lower right corner.
    pub max: Pixel,
}

impl Rectangle {
    /// A rectangle around its middle.
    pub fn around(middle: Pixel, width: f64, height: f64) -> Self {
        let (x, y) = (width / 2.0, height / 2.0);
        Self { min: Pixel::new(middle.x - x, middle.y - y), max: Pixel::new(middle.x + x, middle.y + y) }
    }

    /// The middle.
    pub fn middle(&self) -> Pixel {
        Pixel::new((self.min.x + self.max.x) / 2.0, (self.min.y + self.max.y) / 2.0)
    }

    /// Whether both have a common area.
    pub fn overlaps(&self, other: &Self) -> bool {
        self.min.x < other.max.x
            && other.min.x < self.max.x
            && self.min.y < other.max.y
            && other.min.y < self.max.y
    }

    /// The point of the border nearest to `at`.
    pub fn nearest(&self, at: Pixel) -> Pixel {
        Pixel::new(at.x.clamp(self.min.x, self.max.x), at.y.clamp(self.min.y, self.max.y))
    }
}

/// A straight stroke beside a straight line, CSS pixels.
struct Neighbour {
    /// The part of the line, from its start.
    part: [f64; 2],
    /// The distances of the stroke at both ends of the part; negative on the other side.
    away: [f64; 2],
    /// Length of the stroke along the line; negative in the opposite direction.
    forward: f64,
}

/// A map of the cells that strokes or edges pass through.
#[derive(Clone, Debug)]
pub struct Occupied {
    columns: usize,
    rows: usize,
    cells: Vec<bool>,
    /// The cells of thin lines, over which a label may be drawn if there is no other place.
    thin: Vec<bool>,
    /// The straight strokes, in the direction of the moves.
    straight: Vec<[Pixel; 2]>,
}

impl Occupied {
    /// The map of a scene, with its strokes where they are drawn, in the direction of the moves.
    pub fn of(scene: &Scene, camera: &Camera, strokes: impl Iterator<Item = StrokeShape>) -> Self {
        let map = Self::of_strokes(camera, strokes);
        map.with_part(scene, camera).with_blank(scene, camera).with_obstacles(scene, camera)
    }

    /// The map with the part of a scene.
    pub fn with_part(mut self, scene: &Scene, camera: &Camera) -> Self {
        if let Some(work) = scene.work() {
            for &side in scene.plane().sides() {
                self.outlines(closed(work.part_on(side)).into_iter(), side, camera);
            }
        }
        self
    }

    /// The map with the blank of a scene, as thin lines.
    pub fn with_blank(mut self, scene: &Scene, camera: &Camera) -> Self {
        if let Some(work) = scene.work() {
            let mut thin = Self::empty(camera);
            for &side in scene.plane().sides() {
                thin.outlines(closed(&work.blank).into_iter(), side, camera);
            }
            self.thin = thin.cells;
        }
        self
    }

    /// The map with the chuck and the tailstock of a scene.
    pub fn with_obstacles(mut self, scene: &Scene, camera: &Camera) -> Self {
        if let Some(work) = scene.work() {
            for &side in scene.plane().sides() {
                self.outlines(closed(&work.obstacles).into_iter(), side, camera);
            }
        }
        self
    }

    /// The map of strokes alone.
    pub fn of_strokes(camera: &Camera, strokes: impl Iterator<Item = StrokeShape>) -> Self {
        let mut map = Self::empty(camera);
        for shape in strokes.take(MAX_STROKES) {
            map.shape(&shape, camera);
        }
        map
    }

    /// The map of the half-section of a part, above and below the axis.
    pub fn of_part(part: &Region, camera: &Camera) -> Self {
        let mut map = Self::empty(camera);
        let closed = closed(&outlines(part));
        for &side in Plane::Section.sides() {
            map.outlines(closed.iter().cloned(), side, camera);
        }
        map
    }

    /// The map of lines in a picture.
    pub fn of_lines(lines: &[Vec<Pixel>], camera: &Camera) -> Self {
        let mut map = Self::empty(camera);
        lines.iter().flat_map(|line| line.windows(2)).for_each(|ends| map.line(ends[0], ends[1]));
        map
    }

    fn empty(camera: &Camera) -> Self {
        let Size { width, height } = camera.size();
        let [columns, rows] = [width, height].map(|length| (length / CELL).ceil() as usize + 1);
        let cells = vec![false; columns * rows];
        Self { columns, rows, thin: cells.clone(), cells, straight: Vec::new() }
    }

    /// The highest and the lowest place of all strokes and edges, CSS pixels; `None` without any.
    pub fn down(&self) -> Option<[f64; 2]> {
        let is_drawn = |row: &usize| {
            let cells = row * self.columns..(row + 1) * self.columns;
            self.cells[cells.clone()].contains(&true) || self.thin[cells].contains(&true)
        };
        let (first, last) = ((0..self.rows).find(is_drawn)?, (0..self.rows).rev().find(is_drawn)?);
        Some([first as f64 * CELL, (last + 1) as f64 * CELL])
    }

    /// Whether nothing is drawn in an area but thin lines.
    pub fn is_free(&self, area: &Rectangle) -> bool {
        self.is_empty(&self.cells, area)
    }

    /// Whether no thin line passes through an area: an edge of the blank.
    pub fn is_clear(&self, area: &Rectangle) -> bool {
        self.is_empty(&self.thin, area)
    }

    fn is_empty(&self, cells: &[bool], area: &Rectangle) -> bool {
        let cell = |at: f64, most: usize| ((at / CELL).max(0.0) as usize).min(most - 1);
        let columns = cell(area.min.x, self.columns)..=cell(area.max.x, self.columns);
        let rows = cell(area.min.y, self.rows)..=cell(area.max.y, self.rows);
        rows.into_iter().all(|row| columns.clone().all(|column| !cells[row * self.columns + column]))
    }

    /// Whether a line lies on what is drawn, for at least half of its length without a gap; crossing it is not lying on it.
    pub fn covers(&self, from: Pixel, to: Pixel) -> bool {
        let (mut run, mut longest, mut all) = (0, 0, 0);
        for cell in self.cells_along([from, to], CELL) {
            run = if self.cells[cell] { run + 1 } else { 0 };
            longest = longest.max(run);
            all += 1;
        }
        2 * longest >= all && longest > 0
    }

    /// The pieces of a straight line that are not drawn over a straight stroke: over a dashed stroke, the line would
    /// fill its gaps.
    pub fn beside_strokes(&self, line: [Pixel; 2]) -> Vec<[Pixel; 2]> {
        self.beside(line, |_| true)
    }

    /// The pieces of the straight stroke of a move that no stroke of a move in the opposite direction covers.
    pub fn beside_opposite(&self, line: [Pixel; 2]) -> Vec<[Pixel; 2]> {
        self.beside(line, |forward| forward < 0.0)
    }

    /// The pieces of a straight line that straight strokes do not cover. `covers`: whether a stroke counts, by the way that
    /// it goes forward along the line.
    fn beside(&self, line: [Pixel; 2], covers: impl Fn(f64) -> bool) -> Vec<[Pixel; 2]> {
        let length = line[0].distance(line[1]);
        if length < LEAST_PIECE {
            return Vec::new();
        }
        let over = self.neighbours(line).filter(|own| covers(own.forward));
        let over = over.filter(|own| own.away.iter().all(|away| away.abs() < ALONG));
        let mut covered: Vec<[f64; 2]> = over.map(|own| own.part).collect();
        covered.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let (mut pieces, mut end) = (Vec::new(), 0.0);
        for [low, high] in covered.into_iter().chain([[length; 2]]) {
            if low - end >= LEAST_PIECE {
                pieces.push([end, low].map(|along| Pixel::at_share(line, along / length)));
            }
            end = f64::max(end, high);
        }
        pieces
    }

    /// The distance of a straight line from the nearest straight stroke that runs beside it, CSS pixels.
    pub fn distance_beside(&self, line: [Pixel; 2]) -> f64 {
        let away = self.neighbours(line).flat_map(|own| own.away);
        away.map(f64::abs).fold(f64::INFINITY, f64::min)
    }

    /// The straight strokes that run beside a straight line for a part of it.
    fn neighbours(&self, [from, to]: [Pixel; 2]) -> impl Iterator<Item = Neighbour> {
        let length = from.distance(to).max(LEAST_PIECE);
        let unit = Pixel::new((to.x - from.x) / length, (to.y - from.y) / length);
        // Along the line, and across it.
        let place = move |at: Pixel| {
            let (x, y) = (at.x - from.x, at.y - from.y);
            [x * unit.x + y * unit.y, x * unit.y - y * unit.x]
        };
        self.straight.iter().filter_map(move |stroke| {
            let [a, b] = stroke.map(place);
            let part = [a[0].min(b[0]).max(0.0), a[0].max(b[0]).min(length)];
            let across = |along: f64| a[1] + (along - a[0]) / (b[0] - a[0]) * (b[1] - a[1]);
            let own = || Neighbour { part, away: part.map(across), forward: b[0] - a[0] };
            (part[1] - part[0] >= LEAST_PIECE).then(own)
        })
    }

    /// The cells of the picture along a line, at steps of a length, CSS pixels; a cell may be repeated.
    fn cells_along(&self, [from, to]: [Pixel; 2], step: f64) -> impl Iterator<Item = usize> + use<> {
        let (columns, rows) = (self.columns, self.rows);
        let ends = clipped(from, to, [columns as f64 * CELL, rows as f64 * CELL]);
        ends.into_iter().flat_map(move |ends| {
            let steps = (ends[0].distance(ends[1]) / step).ceil().max(1.0);
            (0..=steps as usize).filter_map(move |at| {
                let Pixel { x, y } = Pixel::at_share(ends, at as f64 / steps);
                let (column, row) = ((x / CELL) as usize, (y / CELL) as usize);
                (column < columns && row < rows).then_some(row * columns + column)
            })
        })
    }

    /// The outlines on a side of the axis, as in [`Plane::sides`].
    fn outlines(&mut self, outlines: impl Iterator<Item = Vec<Point>>, side: f64, camera: &Camera) {
        for outline in outlines {
            let corners: Vec<Pixel> =
                outline.iter().map(|at| camera.to_screen(Point::new(side * at.x, at.z))).collect();
            corners.windows(2).for_each(|ends| self.line(ends[0], ends[1]));
        }
    }

    fn shape(&mut self, shape: &StrokeShape, camera: &Camera) {
        let screen = |at: Point| camera.to_screen(at);
        match shape {
            StrokeShape::Line { from, to } => {
                let ends = [screen(*from), screen(*to)];
                self.line(ends[0], ends[1]);
                if self.straight.len() < MAX_STRAIGHT {
                    self.straight.push(ends);
                }
            }
            StrokeShape::Dot(at) => self.line(screen(*at), screen(*at)),
            StrokeShape::Arc(_) => {
                let points: Vec<Pixel> =
                    (0..=24).map(|step| screen(shape.at(f64::from(step) / 24.0))).collect();
                points.windows(2).for_each(|ends| self.line(ends[0], ends[1]));
            }
            StrokeShape::Virtual(own) => {
                let points: Vec<Pixel> = StrokeShape::curve(own).into_iter().map(screen).collect();
                points.windows(2).for_each(|ends| self.line(ends[0], ends[1]));
            }
        }
    }

    /// Marks the cells along a line.
    fn line(&mut self, from: Pixel, to: Pixel) {
        for cell in self.cells_along([from, to], CELL / 2.0) {
            self.cells[cell] = true;
        }
    }
}

/// The part of a line inside a picture.
fn clipped(from: Pixel, to: Pixel, [width, height]: [f64; 2]) -> Option<[Pixel; 2]> {
    if ![from.x, from.y, to.x, to.y].iter().all(|value| value.is_finite()) {
        return None;
    }
    let (mut enter, mut leave) = (0.0, 1.0f64);
    for (delta, start, max) in [(to.x - from.x, from.x, width), (to.y - from.y, from.y, height)] {
        if delta.abs() < 1e-9 {
            if start < 0.0 || start > max {
                return None;
            }
            continue;
        }
        let (a, b) = (-start / delta, (max - start) / delta);
        enter = f64::max(enter, a.min(b));
        leave = f64::min(leave, a.max(b));
    }
    (enter <= leave).then(|| [enter, leave].map(|share| Pixel::at_share([from, to], share)))
}

#[cfg(test)]
mod tests {
    use super::super::camera::XPlus;
    use super::*;
    use crate::geometry::bounds::Bounds;

    /// A rapid from Z60 to Z10 at X20: a line at X20 from Z0 to Z100 keeps 10 mm before it and 40 mm after it. A line
    /// across the rapid, and a line 5 mm beside it, are whole.
    #[test]
    fn a_line_along_a_stroke_is_left_out() {
        let bounds = Bounds::around(Point::new(0.0, 0.0), Point::new(100.0, 100.0));
        let camera = Camera::fit_with(bounds, Size { width: 600.0, height: 600.0 }, XPlus::Up);
        let mut map = Occupied::empty(&camera);
        let rapid = StrokeShape::Line { from: Point::new(20.0, 60.0), to: Point::new(20.0, 10.0) };
        map.shape(&rapid, &camera);
        let pieces = |ends: [(f64, f64); 2]| -> Vec<f64> {
            let line = ends.map(|(x, z)| camera.to_screen(Point::new(x, z)));
            let all = map.beside_strokes(line).into_iter();
            all.map(|[a, b]| a.distance(b) / camera.scale()).collect()
        };
        let is = |found: Vec<f64>, expected: &[f64]| {
            let same = found.len() == expected.len()
                && found.iter().zip(expected).all(|(found, expected)| (found - expected).abs() < 1e-6);
            assert!(same, "{found:?}, not {expected:?}");
        };
        is(pieces([(20.0, 0.0), (20.0, 100.0)]), &[10.0, 40.0]);
        is(pieces([(20.0, 20.0), (20.0, 50.0)]), &[]);
        is(pieces([(0.0, 30.0), (50.0, 30.0)]), &[50.0]);
        is(pieces([(25.0, 0.0), (25.0, 100.0)]), &[100.0]);
        // To Z100 the rapid is in the opposite direction, to Z0 in the same.
        let opposite = |from: f64, to: f64| -> Vec<f64> {
            let all = map.beside_opposite([from, to].map(|z| camera.to_screen(Point::new(20.0, z))));
            all.into_iter().map(|[a, b]| a.distance(b) / camera.scale()).collect()
        };
        is(opposite(0.0, 100.0), &[10.0, 40.0]);
        is(opposite(100.0, 0.0), &[100.0]);
    }
}
