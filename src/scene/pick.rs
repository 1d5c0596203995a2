//! Finds the stroke under the pointer.
//!
//! In: a scene, a camera, a position in the picture. Out: the nearest stroke within a tolerance. Pure.

use std::ops::Range;

use crate::geometry::{Arc, Point, Turn, nearest_on};

use super::camera::{Camera, Pixel};
use super::{Scene, Stroke, StrokeShape, StrokeStyle};
use crate::geometry::bounds::Bounds;

/// Distances that differ by less than this, CSS pixels, count as equal, because users cannot point more
/// precisely.
const TIE: f64 = 1.0;
/// Radius of the dot of a dwell, CSS pixels.
const DOT: f64 = 3.0;

/// A stroke and a point on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pick {
    /// The stroke.
    pub stroke: Stroke,
    /// The point of the stroke nearest to the pointer.
    pub at: Point,
}

/// The stroke nearest to `pixel`, at most `tolerance` CSS pixels away. Among equally near ones, those that
/// are `lit` (motions of the selected block) take precedence; then the shortest, because it may not be
/// reachable elsewhere (the passes of a cycle overlap); then cuts before rapids, and later before earlier
/// ones.
pub fn pick(
    scene: &Scene,
    camera: &Camera,
    pixel: Pixel,
    tolerance: f64,
    lit: &[Range<usize>],
) -> Option<Pick> {
    let pointer = camera.to_world(pixel);
    let reach = tolerance / camera.scale();
    let dot = DOT / camera.scale();
    let near = |reach: f64| {
        scene.strokes_near(Bounds::of(pointer).grown(reach + dot)).filter_map(move |stroke| {
            let at = nearest(&stroke.shape, pointer);
            let distance = match stroke.shape {
                StrokeShape::Dot(_) => (at.distance(pointer) - dot).max(0.0),
                _ => at.distance(pointer),
            };
            (distance <= reach).then_some((distance, Pick { stroke, at }))
        })
    };
    let least = near(reach).map(|(distance, _)| distance).min_by(f64::total_cmp)?;
    let tied = near(reach.min(least + TIE / camera.scale()));
    let is_lit = |motion: usize| lit.iter().any(|range| range.contains(&motion));
    tied.map(|(_, pick)| pick).max_by_key(|pick| {
        let stroke = &pick.stroke;
        let micrometres = (stroke.shape.length() * 1000.0).round() as i64;
        (is_lit(stroke.motion), -micrometres, rank(stroke.style), stroke.motion)
    })
}

/// The point of a shape nearest to `pointer`.
fn nearest(shape: &StrokeShape, pointer: Point) -> Point {
    match shape {
        StrokeShape::Virtual(own) => {
            let curve = StrokeShape::curve(own);
            let pieces = curve.windows(2).map(|ends| StrokeShape::Line { from: ends[0], to: ends[1] });
            let places = pieces.map(|piece| nearest(&piece, pointer));
            places.min_by(|a, b| a.distance(pointer).total_cmp(&b.distance(pointer))).unwrap_or(own.at(0.0))
        }
        StrokeShape::Line { from, to } => nearest_on([*from, *to], pointer),
        StrokeShape::Arc(arc) => nearest_on_arc(arc, pointer),
        StrokeShape::Dot(at) => *at,
    }
}

/// The point of an arc nearest to `pointer`: on the ray from the centre, or one of the ends.
fn nearest_on_arc(arc: &Arc, pointer: Point) -> Point {
    let angle = (pointer.x - arc.center.x).atan2(pointer.z - arc.center.z);
    let turned = match arc.turn {
        Turn::Counterclockwise => angle - arc.start_angle(),
        Turn::Clockwise => arc.start_angle() - angle,
    };
    let t = turned.rem_euclid(std::f64::consts::TAU) / arc.sweep().abs();
    if t <= 1.0 {
        arc.at(t)
    } else if pointer.distance(arc.start) < pointer.distance(arc.end) {
        arc.start
    } else {
        arc.end
    }
}

fn rank(style: StrokeStyle) -> u8 {
    match style {
        StrokeStyle::Rapid => 0,
        StrokeStyle::Dwell | StrokeStyle::Feed | StrokeStyle::Thread => 1,
    }
}

#[cfg(test)]
mod tests {
    use super::super::path_index::PathIndex;
    use super::super::tests::{Path, point};
    use super::*;
    use crate::scene::camera::Size;

    /// Picks at a diameter and Z, with an offset of `off` CSS pixels and a tolerance of 6 pixels.
    fn check(path: Path, (diameter, z): (f64, f64), off: (f64, f64), expected: Option<usize>) {
        let motions = path.motions();
        let path_index = PathIndex::of(&motions);
        let scene = Scene::new(&motions, &path_index, None);
        let camera = Camera::fit(scene.bounds(), Size { width: 700.0, height: 500.0 });
        let at = camera.to_screen(point(diameter, z));
        let found = pick(&scene, &camera, Pixel::new(at.x + off.0, at.y + off.1), 6.0, &[]);
        assert_eq!(found.map(|pick| pick.stroke.motion), expected);
    }

    fn turning() -> Path {
        Path::from(100.0, 10.0).rapid(60.0, 2.0).feed(60.0, -50.0).feed(80.0, -50.0).rapid(60.0, 2.0)
    }

    #[test]
    fn the_stroke_under_the_pointer() {
        check(turning(), (60.0, -20.0), (0.0, 4.0), Some(1));
        check(turning(), (70.0, -50.0), (-5.0, 0.0), Some(2));
        check(turning(), (60.0, -20.0), (0.0, 9.0), None);
        check(Path::from(100.0, 10.0), (60.0, -20.0), (0.0, 0.0), None);
    }

    #[test]
    fn what_cuts_goes_before_rapids_and_later_before_earlier() {
        let over = Path::from(60.0, 0.0).feed(60.0, -50.0).rapid(60.0, 0.0);
        check(over, (60.0, -20.0), (0.0, 0.0), Some(0));
        let twice = Path::from(60.0, 0.0).feed(60.0, -50.0).feed(60.0, 0.0);
        check(twice, (60.0, -20.0), (0.0, 3.0), Some(1));
    }

    #[test]
    fn passes_that_lie_over_one_another_are_each_reached_where_they_end() {
        let passes = || {
            let home = |path: Path| path.feed(130.0, -30.0).rapid(130.0, 3.0);
            let one = home(Path::from(130.0, 3.0).rapid(80.0, 3.0).feed(80.0, -30.0));
            home(one.rapid(70.0, 3.0).feed(70.0, -30.0))
        };
        check(passes(), (84.0, 3.0), (0.0, 0.0), Some(0));
        check(passes(), (74.0, 3.0), (0.0, 0.0), Some(4));
        check(passes(), (120.0, -30.0), (0.0, 0.0), Some(2));
    }

    #[test]
    fn arcs_are_met_on_the_arc_and_not_on_the_chord() {
        let arc = || Path::from(40.0, 0.0).arc(Turn::Clockwise, (80.0, 20.0), (80.0, 0.0));
        let middle = (80.0 - 2.0 * 20.0 * 0.5f64.sqrt(), 20.0 * 0.5f64.sqrt());
        check(arc(), middle, (0.0, 0.0), None);
        let arc = || Path::from(40.0, 0.0).arc(Turn::Counterclockwise, (80.0, 20.0), (80.0, 0.0));
        check(arc(), middle, (2.0, 2.0), Some(0));
        check(arc(), (60.0, 10.0), (0.0, 0.0), None);
        check(arc(), (80.0, 20.0), (1.0, -4.0), Some(0));
    }

    #[test]
    fn far_stretches_are_found_too() {
        let mut path = Path::from(20.0, 0.0);
        for step in 1..3000 {
            path = path.feed(20.0, -0.001 * f64::from(step));
        }
        check(path.feed(80.0, -3.0).feed(80.0, -50.0), (80.0, -40.0), (0.0, 1.0), Some(3000));
    }
}
