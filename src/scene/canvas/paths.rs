//! Converts strokes to the browser's `Path2d`, in mm.
//!
//! In: strokes. Out: one `Path2d` for each ink, and the points of the dwells. World coordinates: Z is the
//! first axis, the radius the second. The transform under which the paths are drawn turns X up, which also
//! reverses the direction of arcs. Functions fail only if the browser refuses a path.

use wasm_bindgen::JsValue;
use web_sys::Path2d;

use crate::geometry::{Arc, Point, Turn};

use super::super::ink::Ink;
use super::super::{Place, Scene, Stroke, StrokeShape, StrokeStyle};

/// If the radii at the two ends of an arc differ by more than this, mm, the arc is drawn as a spiral.
const MAX_RADIUS_DIFFERENCE: f64 = 1e-3;
/// Number of line segments in such a spiral.
const SPIRAL_SEGMENTS: u32 = 64;

/// Some strokes as paths.
#[derive(Debug, Default)]
pub struct Paths {
    lines: [Option<OpenPath>; Ink::ALL.len()],
    dots: [Vec<Point>; Ink::ALL.len()],
}

/// A path and its current end.
#[derive(Debug)]
struct OpenPath {
    path: Path2d,
    end: Option<Point>,
}

impl Paths {
    /// The paths of strokes.
    pub fn of(strokes: impl Iterator<Item = Stroke>) -> Result<Self, JsValue> {
        let mut paths = Self::default();
        for stroke in strokes {
            paths.push(&stroke)?;
        }
        Ok(paths)
    }

    /// Adds a stroke.
    pub fn push(&mut self, stroke: &Stroke) -> Result<(), JsValue> {
        let index = Ink::of(stroke).index();
        let shape = stroke.drawn_shape();
        if let StrokeShape::Dot(at) = shape {
            self.dots[index].push(at);
            return Ok(());
        }
        let line = match &mut self.lines[index] {
            Some(line) => line,
            empty => empty.insert(OpenPath { path: Path2d::new()?, end: None }),
        };
        let start = shape.start();
        // Each rapid starts its own dash pattern, see `drawn_shape`.
        if line.end != Some(start) || stroke.style == StrokeStyle::Rapid {
            line.path.move_to(start.z, start.x);
        }
        append(&line.path, shape)?;
        line.end = Some(shape.end());
        Ok(())
    }

    /// The path of an ink, if it has one.
    pub fn get(&self, ink: Ink) -> Option<&Path2d> {
        self.lines[ink.index()].as_ref().map(|line| &line.path)
    }

    /// The points where the tool waits.
    pub fn dots(&self, ink: Ink) -> &[Point] {
        &self.dots[ink.index()]
    }
}

/// The paths of the stretch (see `path_index`) that contains the motion `until`: before it, and from it on.
/// Empty if there is none.
pub fn split_stretch(scene: &Scene, until: usize) -> Result<(Paths, Paths), JsValue> {
    let Some(stretch) = scene.path_index().stretch_of(until) else {
        return Ok((Paths::default(), Paths::default()));
    };
    let before = Paths::of(scene.strokes_of(stretch.motions.start..until))?;
    Ok((before, Paths::of(scene.strokes_of(until..stretch.motions.end))?))
}

/// The finished part of the current motion.
pub fn finished_part(scene: &Scene, place: Place) -> Result<Paths, JsValue> {
    let done = |stroke: Stroke| Stroke { shape: stroke.shape.split(place.fraction).0, ..stroke };
    Paths::of(scene.stroke(place.motion).map(done).into_iter())
}

/// Shapes as one path, regardless of their style.
pub fn path_of(shapes: impl Iterator<Item = StrokeShape>) -> Result<Path2d, JsValue> {
    let path = Path2d::new()?;
    for shape in shapes {
        let start = shape.start();
        path.move_to(start.z, start.x);
        append(&path, shape)?;
    }
    Ok(path)
}

/// Adds a shape from its start point; a dwell adds nothing.
fn append(path: &Path2d, shape: StrokeShape) -> Result<(), JsValue> {
    match shape {
        StrokeShape::Line { to, .. } => path.line_to(to.z, to.x),
        StrokeShape::Arc(arc) => trace(path, &arc)?,
        StrokeShape::Virtual(own) => follow(path, &StrokeShape::curve(&own)),
        StrokeShape::Dot(_) => {}
    }
    Ok(())
}

/// Adds lines through the points.
fn follow(path: &Path2d, points: &[Point]) {
    for point in points {
        path.line_to(point.z, point.x);
    }
}

/// Adds an arc from its start point.
fn trace(path: &Path2d, arc: &Arc) -> Result<(), JsValue> {
    let radius = arc.radius();
    if (radius - arc.end.distance(arc.center)).abs() > MAX_RADIUS_DIFFERENCE {
        for segment in 1..=SPIRAL_SEGMENTS {
            let at = arc.at(f64::from(segment) / f64::from(SPIRAL_SEGMENTS));
            path.line_to(at.z, at.x);
        }
        return Ok(());
    }
    let start = arc.start_angle();
    // The canvas measures angles from its first axis to its second, here from +Z to +X. This direction is our
    // counter-clockwise, and is called clockwise by the canvas.
    let against = arc.turn == Turn::Clockwise;
    let end = start + arc.sweep();
    path.arc_with_anticlockwise(arc.center.z, arc.center.x, radius, start, end, against)
}
