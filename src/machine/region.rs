//! Areas of the half-section, and their Boolean operations.
//!
//! In: closed outlines in mm (`z` to the right, `x` the radius upwards). Out: areas with holes, and queries
//! on them. The operations are those of `i_overlay` on an integer grid: an outline comes back unchanged, and
//! the scale of the picture does not matter. Must not know tools, motions or stock.

use i_overlay::core::fill_rule::FillRule;
use i_overlay::core::overlay::{Overlay, ShapeType};
use i_overlay::core::overlay_rule::OverlayRule;
use i_overlay::i_float::int::point::IntPoint;
use i_overlay::i_shape::int::shape::IntShapes;

use crate::geometry::bounds::Bounds;
use crate::geometry::{Point, within};

/// Grid steps per millimetre: a power of two, so that binary fractions are exact.
const STEPS: f64 = 131_072.0;

/// Largest coordinate, mm: the range of `i_overlay` with a margin.
const MAX_COORDINATE: f64 = 8000.0;

/// Smaller pieces are caused by rounding, mm².
const DUST: f64 = 1e-7;

/// An overlap of at most this depth, mm, is mere contact: twice the error of the grid.
const TOUCH: f64 = 2e-5;

/// A corner closer to the line between its neighbours than this, mm, is removed: nearly parallel edges have
/// split each other there.
const STRAIGHT: f64 = 2e-4;

/// Area that such corners may change along a line, mm². Along a very long line, they may change as much as the error of
/// the grid.
const NEGLIGIBLE: f64 = 1e-4;

/// An area of the half-section: any number of pieces, with holes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Region {
    shapes: IntShapes<i32>,
}

/// One piece of an area.
#[derive(Clone, Debug, PartialEq)]
pub struct Piece {
    /// Outer contour, counter-clockwise.
    pub outline: Vec<Point>,
    /// Holes, clockwise.
    pub holes: Vec<Vec<Point>>,
}

impl Region {
    /// The area inside an outline, which may have either direction and intersect itself.
    pub fn inside(outline: &[Point]) -> Self {
        Self::combined(&Self::default(), &[outline], OverlayRule::Union)
    }

    /// Whether the region is empty.
    pub fn is_empty(&self) -> bool {
        self.shapes.is_empty()
    }

    /// Removes all outlines from the region.
    pub fn cut(&mut self, outlines: &[impl AsRef<[Point]>]) {
        if !outlines.is_empty() {
            *self = Self::combined(self, outlines, OverlayRule::Difference);
        }
    }

    /// Removes the pieces for which `is_dropped` is true. Its arguments are the bounds of the piece and of
    /// the whole region. A region with a single piece is left unchanged.
    pub fn drop_pieces(&mut self, is_dropped: impl Fn(Bounds, Bounds) -> bool) {
        if self.shapes.len() < 2 {
            return;
        }
        let bounds = |shape: &Vec<Vec<IntPoint<i32>>>| {
            let mut points = shape.iter().flatten().map(off_grid);
            let first = Bounds::of(points.next()?);
            Some(points.fold(first, Bounds::with))
        };
        let all = self.shapes.iter().filter_map(bounds).reduce(|a, b| a.with(b.min).with(b.max));
        let Some(all) = all else { return };
        self.shapes.retain(|shape| bounds(shape).is_none_or(|own| !is_dropped(own, all)));
    }

    /// The part of the region that lies in the outlines.
    pub fn intersection(&self, outlines: &[impl AsRef<[Point]>]) -> Self {
        Self::combined(self, outlines, OverlayRule::Intersect)
    }

    /// The part of the region that is not in `other`.
    pub fn difference(&self, other: &Region) -> Self {
        let mut overlay = Overlay::from_subj_and_clip(&self.shapes, &other.shapes);
        Self { shapes: overlay.overlay(OverlayRule::Difference, FillRule::NonZero) }
    }

    /// Whether a convex counter-clockwise outline overlaps the region by more than an edge. Much faster than
    /// computing the intersection: an edge of the region crosses the outline, or the outline lies inside all
    /// edges.
    pub fn overlaps(&self, outline: &[Point]) -> bool {
        let Some(&first) = outline.first().filter(|_| outline.len() > 2) else { return false };
        let extents = outline.iter().fold(Bounds::of(first), |bounds, point| bounds.with(*point));
        let crosses = |(a, b): (Point, Point)| {
            let Bounds { min, max } = Bounds::around(a, b);
            let apart = max.x <= extents.min.x
                || extents.max.x <= min.x
                || max.z <= extents.min.z
                || extents.max.z <= min.z;
            !apart && runs_through(outline, a, b)
        };
        // The mean of the corners of a convex outline lies inside it.
        let count = outline.len() as f64;
        let (x, z) = outline.iter().fold((0.0, 0.0), |sum, point| (sum.0 + point.x, sum.1 + point.z));
        let middle = Point::new(x / count, z / count);
        self.edges().any(crosses) || self.contains(middle)
    }

    /// Its pieces.
    pub fn pieces(&self) -> impl Iterator<Item = Piece> + '_ {
        let points = |contour: &Vec<IntPoint<i32>>| contour.iter().map(off_grid).collect();
        self.shapes.iter().filter_map(move |shape| {
            let (outline, holes) = shape.split_first()?;
            Some(Piece { outline: points(outline), holes: holes.iter().map(points).collect() })
        })
    }

    /// All closed outlines, including holes.
    pub fn outlines(&self) -> impl Iterator<Item = impl Iterator<Item = Point> + '_> + '_ {
        self.shapes.iter().flatten().map(|contour| contour.iter().map(off_grid))
    }

    /// Number of corners.
    pub fn corners(&self) -> usize {
        self.shapes.iter().flatten().map(Vec::len).sum()
    }

    /// Area, mm².
    pub fn area(&self) -> f64 {
        self.edges().map(|(a, b)| (a.z * b.x - b.z * a.x) / 2.0).sum()
    }

    /// Area of the part on the +Z side of a line, mm².
    pub fn area_beside(&self, from: Point, to: Point) -> f64 {
        let length = from.distance(to).max(f64::MIN_POSITIVE);
        let (ux, uz) = ((to.x - from.x) / length, (to.z - from.z) / length);
        let side = if ux > 0.0 { -1.0 } else { 1.0 };
        let at = |along: f64, beside: f64| {
            Point::new(from.x + along * ux + side * beside * uz, from.z + along * uz - side * beside * ux)
        };
        let strip = [
            at(-MAX_COORDINATE / 4.0, 0.0),
            at(MAX_COORDINATE / 4.0, 0.0),
            at(MAX_COORDINATE / 4.0, MAX_COORDINATE / 4.0),
            at(-MAX_COORDINATE / 4.0, MAX_COORDINATE / 4.0),
        ];
        self.intersection(&[strip]).area()
    }

    /// The intervals of a line across the spindle axis at `z` that lie in the region: pairs of radii, mm,
    /// from the axis outwards. Exactly on a step, the material towards −Z counts.
    pub fn radii(&self, z: f64) -> Vec<(f64, f64)> {
        self.crossed(z, |at| (at.z, at.x))
    }

    /// The intervals of a line along the spindle axis at radius `x` that lie in the region: pairs of Z, mm, in
    /// ascending order.
    pub fn lengths(&self, x: f64) -> Vec<(f64, f64)> {
        self.crossed(x, |at| (at.x, at.z))
    }

    /// The intervals of a line that lie in the region. `split` returns the line that a point is on, and its place
    /// on that line.
    fn crossed(&self, line: f64, split: impl Fn(Point) -> (f64, f64)) -> Vec<(f64, f64)> {
        let edges = self.edges().map(|(a, b)| (split(a), split(b)));
        let crossing = edges.filter(|(a, b)| (a.0 < line) != (b.0 < line));
        let mut places: Vec<f64> =
            crossing.map(|(a, b)| a.1 + (line - a.0) / (b.0 - a.0) * (b.1 - a.1)).collect();
        places.sort_unstable_by(f64::total_cmp);
        places.chunks_exact(2).map(|pair| (pair[0], pair[1])).collect()
    }

    /// Whether a point lies in the region.
    pub fn contains(&self, point: Point) -> bool {
        self.radii(point.z).iter().any(|&(low, high)| low < point.x && point.x < high)
    }

    /// The point of its edges nearest to a point.
    pub fn nearest_on_edge(&self, to: Point) -> Option<Point> {
        let on_edge = |(a, b): (Point, Point)| {
            let (dx, dz) = (b.x - a.x, b.z - a.z);
            let along = (to.x - a.x) * dx + (to.z - a.z) * dz;
            let share = (along / (dx * dx + dz * dz).max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
            Point::new(a.x + share * dx, a.z + share * dz)
        };
        self.edges().map(on_edge).min_by(|a, b| a.distance(to).total_cmp(&b.distance(to)))
    }

    /// Its edges, with the material on the left.
    pub fn edges(&self) -> impl Iterator<Item = (Point, Point)> + '_ {
        self.shapes.iter().flatten().flat_map(|contour| {
            let next = contour.iter().cycle().skip(1);
            contour.iter().zip(next).map(|(a, b)| (off_grid(a), off_grid(b)))
        })
    }

    fn combined(region: &Region, outlines: &[impl AsRef<[Point]>], rule: OverlayRule) -> Self {
        let points = outlines.iter().map(|outline| outline.as_ref().len()).sum::<usize>() + region.corners();
        let mut overlay = Overlay::new(points);
        overlay.options.min_output_area = (DUST * STEPS * STEPS * 2.0) as u64;
        overlay.add_source(&region.shapes, ShapeType::Subject);
        let mut grid = Vec::new();
        for outline in outlines {
            grid.clear();
            grid.extend(outline.as_ref().iter().map(|&point| to_grid(point)));
            make_counterclockwise(&mut grid);
            overlay.add_contour(&grid, ShapeType::Clip);
        }
        let mut shapes = overlay.overlay(rule, FillRule::NonZero);
        shapes.iter_mut().flatten().for_each(straighten);
        Self { shapes }
    }
}

/// Removes superfluous corners.
fn straighten(contour: &mut Vec<IntPoint<i32>>) {
    let mut kept: Vec<IntPoint<i32>> = Vec::with_capacity(contour.len());
    // Area between the line from the last kept corner and the corners removed since. Without it, the many
    // short edges of an arc would all be removed, because each of them bends so little.
    let mut area = 0.0;
    for (index, &corner) in contour.iter().enumerate() {
        let next = contour[(index + 1) % contour.len()];
        let none = kept.last().is_some_and(|last| {
            let (distance, length) = distance_from_line(corner, *last, next);
            area += distance * length / 2.0;
            distance.abs() <= STRAIGHT * STEPS && area.abs() <= most_changed(length)
        });
        if !none {
            kept.push(corner);
            area = 0.0;
        }
    }
    if kept.len() > 2 {
        *contour = kept;
    }
}

/// The area that the removed corners of a line of this length may change, in grid steps.
fn most_changed(length: f64) -> f64 {
    let negligible = 2.0 * NEGLIGIBLE * STEPS * STEPS / length.max(1.0);
    (STRAIGHT * STEPS).min(negligible.max(TOUCH * STEPS)) * length / 2.0
}

/// Distance of a point to the left of the line between two others, and the length of that line, in grid
/// steps. A corner that turns back is infinitely far, however narrow it is.
fn distance_from_line(point: IntPoint<i32>, from: IntPoint<i32>, to: IntPoint<i32>) -> (f64, f64) {
    let (dx, dy) = (f64::from(to.x) - f64::from(from.x), f64::from(to.y) - f64::from(from.y));
    let (px, py) = (f64::from(point.x) - f64::from(from.x), f64::from(point.y) - f64::from(from.y));
    let length = dx.hypot(dy);
    let turns_back = px * dx + py * dy < 0.0 || px.hypot(py) > length;
    (if turns_back { f64::INFINITY } else { (dx * py - dy * px) / length }, length)
}

/// Whether more than one point of a line is inside a convex counter-clockwise outline.
fn runs_through(outline: &[Point], a: Point, b: Point) -> bool {
    let (mut from, mut to) = (0.0, 1.0);
    let next = outline.iter().cycle().skip(1);
    for (p, q) in outline.iter().zip(next) {
        let length = p.distance(*q);
        if length <= 0.0 {
            continue;
        }
        // Depth of the ends inside this edge, mm.
        let depth = |at: Point| ((at.x - p.x) * (q.z - p.z) - (at.z - p.z) * (q.x - p.x)) / length;
        let (first, last) = (depth(a), depth(b));
        if first <= TOUCH && last <= TOUCH {
            return false;
        }
        if first < TOUCH {
            from = f64::max(from, (TOUCH - first) / (last - first));
        } else if last < TOUCH {
            to = f64::min(to, (first - TOUCH) / (first - last));
        }
    }
    (to - from) * a.distance(b) > TOUCH
}

/// Overlapping outlines add up only if they have the same direction.
fn make_counterclockwise(contour: &mut [IntPoint<i32>]) {
    let next = contour.iter().cycle().skip(1);
    let area: f64 = contour
        .iter()
        .zip(next)
        .map(|(a, b)| f64::from(a.x) * f64::from(b.y) - f64::from(b.x) * f64::from(a.y))
        .sum();
    if area < 0.0 {
        contour.reverse();
    }
}

fn to_grid(point: Point) -> IntPoint<i32> {
    let step = |value: f64| (within(value, -MAX_COORDINATE, MAX_COORDINATE) * STEPS).round() as i32;
    IntPoint::new(step(point.z), step(point.x))
}

fn off_grid(point: &IntPoint<i32>) -> Point {
    Point::new(f64::from(point.y) / STEPS, f64::from(point.x) / STEPS)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rectangle(z: (f64, f64), x: (f64, f64)) -> Vec<Point> {
        vec![Point::new(x.0, z.0), Point::new(x.0, z.1), Point::new(x.1, z.1), Point::new(x.1, z.0)]
    }

    #[test]
    fn cuts_leave_the_rest() {
        let mut region = Region::inside(&rectangle((-50.0, 0.0), (5.0, 20.0)));
        assert!((region.area() - 750.0).abs() < 1e-9);
        // One with the other direction, and two that overlap.
        let mut other_way = rectangle((-10.0, 5.0), (15.0, 30.0));
        other_way.reverse();
        region.cut(&[
            other_way,
            rectangle((-30.0, -20.0), (15.0, 30.0)),
            rectangle((-25.0, -15.0), (15.0, 30.0)),
        ]);
        assert!((region.area() - 750.0 + 50.0 + 75.0).abs() < 1e-9);
        assert_eq!(region.radii(-5.0), [(5.0, 15.0)]);
        assert_eq!(region.radii(-12.0), [(5.0, 20.0)]);
        assert_eq!(region.radii(-60.0), []);
        assert_eq!(region.lengths(17.0), [(-50.0, -30.0), (-15.0, -10.0)]);
        assert_eq!(region.lengths(10.0), [(-50.0, 0.0)]);
        assert!(region.contains(Point::new(17.0, -40.0)) && !region.contains(Point::new(17.0, -20.0)));
    }

    #[test]
    fn a_ring_has_a_hole() {
        let mut region = Region::inside(&rectangle((-10.0, 10.0), (0.0, 20.0)));
        region.cut(&[rectangle((-5.0, 5.0), (5.0, 15.0))]);
        let pieces: Vec<_> = region.pieces().collect();
        assert_eq!((pieces.len(), pieces[0].holes.len()), (1, 1));
        assert_eq!(region.radii(0.0), [(0.0, 5.0), (15.0, 20.0)]);
    }

    #[test]
    fn an_edge_in_common_is_no_meeting() {
        let region = Region::inside(&rectangle((-10.0, 0.0), (0.0, 20.0)));
        assert!(!region.overlaps(&rectangle((0.0, 5.0), (0.0, 20.0))));
        assert!(region.overlaps(&rectangle((-0.001, 5.0), (0.0, 20.0))));
        assert!(region.overlaps(&rectangle((-8.0, -7.0), (10.0, 11.0))), "inside");
        assert!(region.overlaps(&rectangle((-80.0, 70.0), (-10.0, 110.0))), "around");
        assert!(!region.overlaps(&rectangle((1.0, 5.0), (0.0, 20.0))));
    }

    #[test]
    fn short_edges_of_an_arc_stay_an_arc() {
        let around = |index: u32| {
            let angle = f64::from(index) / 20_000.0 * std::f64::consts::TAU;
            Point::new(5.0 * angle.sin(), 5.0 * angle.cos())
        };
        let circle: Vec<Point> = (0..20_000).map(around).collect();
        let region = Region::inside(&circle);
        assert!(region.corners() < 1000);
        for index in 0..1000 {
            let z = -4.99 + f64::from(index) * 0.00998;
            let radius = (25.0 - z * z).sqrt();
            // The steeper the arc, the more a deviation of a thousandth changes the radius.
            let least = 0.001 * 5.0 / radius;
            assert!(
                region
                    .radii(z)
                    .iter()
                    .all(|(low, high)| (low + radius).abs() < least && (high - radius).abs() < least),
                "{z}"
            );
        }
    }

    #[test]
    fn nothing_is_beyond_the_grid() {
        let far = Region::inside(&rectangle((-1e300, f64::INFINITY), (0.0, f64::NAN)));
        assert!(far.area().is_finite());
    }
}
