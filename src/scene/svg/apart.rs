//! Draws overlapping passes apart, as manuals do: the passes of G76, and pecks along one line.
//!
//! In: the motions of a scene, the size of a pixel. Out: the displaced strokes and points. The last pass is in place.
//! The path of the tool stays connected: the strokes before and after a displaced pass lead to it.

use std::ops::Range;

use super::super::annotation::Shape;
use super::super::{Scene, Stroke, StrokeShape};
use crate::geometry::bounds::Bounds;
use crate::geometry::{Arc, Point, at_share, share_along, within};
use crate::motion::{Cycle, CycleFamily, Motions, Step};

/// Distance between two passes, and between two pecks, CSS pixels, if there is room.
const GAP: f64 = 3.0;
const PECK_GAP: f64 = 10.0;

/// Maximum displacement of the passes of a cycle, CSS pixels.
const ROOM: f64 = 36.0;

/// Maximum displacement, as a share of the distance to the start of the cycle, and to the next column of pecks.
const SHARE: f64 = 0.6;

/// A point this near to a stroke is on it, mm.
const ON_STROKE: f64 = 1e-4;

/// Displacements of motions.
#[derive(Default)]
pub(super) struct Apart {
    /// Displacement of the start and the end of each motion, mm; empty if there is none.
    places: Vec<[Point; 2]>,
    /// Whether passes are drawn side by side.
    pub(super) has_passes: bool,
}

const IN_PLACE: Point = Point { x: 0.0, z: 0.0 };

impl Apart {
    /// The displacements in a scene, with `pixel` mm per CSS pixel; `has_detail`: the passes of threads are in a detail,
    /// so they are in place.
    pub(super) fn of(scene: &Scene, has_detail: bool, pixel: f64) -> Self {
        let motions = scene.motions;
        let mut apart = Self::default();
        let mut first = 0;
        while first < scene.len() {
            let own = motions.get(first).cycle.map(|step| step.cycle);
            let line = motions.line(first);
            let mut end = first + 1;
            while own.is_some()
                && end < scene.len()
                && motions.line(end) == line
                && motions.get(end).cycle.map(|step| step.cycle) == own
            {
                end += 1;
            }
            match own.map(|cycle| (cycle, cycle.family())) {
                Some((Cycle::MultiThreading, _)) if has_detail => {}
                Some((Cycle::MultiThreading, _)) => apart.thread(motions, first..end, pixel),
                Some((_, CycleFamily::Pecking | CycleFamily::FaceHole | CycleFamily::SideHole)) => {
                    apart.pecks(motions, first..end, pixel);
                }
                _ => {}
            }
            first = end;
        }
        apart
    }

    /// The displaced shape of a stroke.
    pub(super) fn shape(&self, stroke: &Stroke) -> StrokeShape {
        let shape = stroke.drawn_shape();
        let Some([start, end]) = self.places.get(stroke.motion) else { return shape };
        match shape {
            StrokeShape::Line { from, to } => {
                // Rapids may be drawn in the opposite direction.
                let turned = stroke.shape.start() != from;
                let (first, last) = if turned { (end, start) } else { (start, end) };
                StrokeShape::Line { from: from.moved(*first), to: to.moved(*last) }
            }
            StrokeShape::Dot(at) => StrokeShape::Dot(at.moved(*start)),
            StrokeShape::Arc(arc) => StrokeShape::Arc(Arc {
                start: arc.start.moved(*start),
                end: arc.end.moved(*start),
                center: arc.center.moved(*start),
                ..arc
            }),
            StrokeShape::Virtual(_) => shape,
        }
    }

    /// The displaced shape of a stroke in the direction of the move; dashes of rapids may be drawn the other way round.
    pub(super) fn directed(&self, stroke: &Stroke) -> StrokeShape {
        match (self.shape(stroke), stroke.drawn_shape().start() == stroke.shape.start()) {
            (StrokeShape::Line { from, to }, false) => StrokeShape::Line { from: to, to: from },
            (shape, _) => shape,
        }
    }

    /// An annotation where its strokes are drawn. The ends of a stroke move with it, even if other strokes are at
    /// the same points.
    pub(super) fn annotated(&self, scene: &Scene, shape: &Shape) -> Shape {
        let of_stroke = match *shape {
            Shape::Step(ends) => self.ends(scene, ends).map(Shape::Step),
            Shape::Axial(ends) => self.ends(scene, ends).map(Shape::Axial),
            Shape::Radial(ends) => self.ends(scene, ends).map(Shape::Radial),
            _ => None,
        };
        with_true_size(shape, of_stroke.unwrap_or_else(|| shape.map(|at| self.point(scene, at))))
    }

    /// Where the ends of a straight stroke are drawn; `None` without a displaced stroke between them.
    fn ends(&self, scene: &Scene, [from, to]: [Point; 2]) -> Option<[Point; 2]> {
        if self.places.is_empty() {
            return None;
        }
        let is_own = |stroke: &Stroke| {
            matches!(stroke.shape, StrokeShape::Line { .. })
                && stroke.shape.start().distance(from) < ON_STROKE
                && stroke.shape.end().distance(to) < ON_STROKE
        };
        let own = scene.strokes_near(Bounds::of(from).grown(ON_STROKE)).find(is_own)?;
        let [start, end] = self.places.get(own.motion)?;
        Some([from.moved(*start), to.moved(*end)])
    }

    /// Where a point of the section is drawn: displaced if it is on displaced strokes only.
    pub(super) fn point(&self, scene: &Scene, at: Point) -> Point {
        if self.places.is_empty() {
            return at;
        }
        let mut found = None;
        for stroke in scene.strokes_near(Bounds::of(at).grown(ON_STROKE)) {
            let Some(share) = share_of(&stroke.shape, at) else { continue };
            let [start, end] = self.places.get(stroke.motion).copied().unwrap_or([IN_PLACE; 2]);
            let by = at_share([start, end], share);
            if by == IN_PLACE {
                return at;
            }
            found.get_or_insert(by);
        }
        found.map_or(at, |by| at.moved(by))
    }

    /// Sets the displacement of a motion.
    fn put(&mut self, motion: usize, start: Point, end: Point) {
        if self.places.len() <= motion {
            self.places.resize(motion + 1, [IN_PLACE; 2]);
        }
        self.places[motion] = [start, end];
    }

    /// The last pass of a thread is in place; the earlier passes are displaced away from the part.
    fn thread(&mut self, motions: &Motions, call: Range<usize>, pixel: f64) {
        let home = motions.get_on_workpiece(call.start).from.x;
        let (mut last, mut deepest) = (0, home);
        for motion in call.clone() {
            let motion = motions.get_on_workpiece(motion);
            if let Some(step) = motion.cycle.filter(|step| step.pass >= last) {
                last = step.pass;
                deepest = if step.step == Step::Cut { motion.from.x } else { deepest };
            }
        }
        // All passes stay nearer to the thread than to the start.
        let room = (ROOM * pixel).min(SHARE * (home - deepest).abs());
        let gap = (GAP * pixel).min(room / f64::from(last.max(1)));
        self.has_passes |= last > 1;
        for index in call {
            let motion = motions.get_on_workpiece(index);
            let Some(step) = motion.cycle.filter(|step| step.pass > 0 && step.pass < last) else { continue };
            let deep = if step.step == Step::Infeed { motion.to.x } else { motion.from.x };
            let out = Point { x: (home - deep).signum() * gap * f64::from(last - step.pass), z: 0.0 };
            match step.step {
                Step::Infeed => self.put(index, IN_PLACE, out),
                Step::Cut | Step::PullOut => self.put(index, out, out),
                Step::Retract => self.put(index, out, IN_PLACE),
                _ => {}
            }
        }
    }

    /// Pecks on one line are drawn side by side: each cut is parallel to its line, and each retract leads to the next
    /// cut. The move before the column ends at its first cut.
    fn pecks(&mut self, motions: &Motions, call: Range<usize>, pixel: f64) {
        let step = |motion: usize| motions.get(motion).cycle.map(|step| step.step);
        let is_along = |motion: usize| {
            !matches!(
                step(motion),
                Some(Step::Relief | Step::Stepover | Step::Return | Step::Approach) | None
            )
        };
        let columns = columns_of(motions, call.clone());
        let mut first = call.start;
        while first < call.end {
            let mut end = first;
            while end < call.end && is_along(end) {
                end += 1;
            }
            let cuts = (first..end).filter(|&motion| step(motion) == Some(Step::Cut)).count();
            if cuts > 1 {
                self.has_passes = true;
                let motion = motions.get_on_workpiece(first);
                let is_along_z = motion.from.x == motion.to.x;
                // They are displaced towards the next column in the positive direction.
                let place = |at: Point| if is_along_z { at.x } else { at.z };
                let others = columns.iter().map(|at| place(*at) - place(motion.from));
                let pitch = others.filter(|by| *by > ON_STROKE).fold(f64::INFINITY, f64::min);
                let room = (ROOM * pixel).min(SHARE * pitch);
                let gap = (PECK_GAP * pixel).min(room / cuts as f64);
                let at = |left: usize| {
                    let by = gap * left as f64;
                    if is_along_z { Point { x: by, z: 0.0 } } else { Point { x: 0.0, z: by } }
                };
                let mut left = cuts - 1;
                if let Some(before) = first.checked_sub(1) {
                    let start = self.places.get(before).map_or(IN_PLACE, |places| places[0]);
                    self.put(before, start, at(left));
                }
                for index in first..end {
                    let is_retract = step(index) == Some(Step::Retract);
                    let next = if is_retract { left.saturating_sub(1) } else { left };
                    self.put(index, at(left), at(next));
                    left = next;
                }
            }
            first = end + 1;
        }
    }
}

/// A displaced dimension that is as long as the true one: if its ends are displaced differently in the measured
/// direction, they are in place in that direction. A diameter is always measured from the axis.
fn with_true_size(shape: &Shape, displaced: Shape) -> Shape {
    match (shape, displaced) {
        (Shape::Axial([a, b]), Shape::Axial([from, to])) => {
            let is_same = (to.z - from.z - (b.z - a.z)).abs() < ON_STROKE;
            let ends = if is_same { [from.z, to.z] } else { [a.z, b.z] };
            Shape::Axial([Point::new(from.x, ends[0]), Point::new(to.x, ends[1])])
        }
        (Shape::Radial([a, b]), Shape::Radial([from, to])) => {
            let is_same = (to.x - from.x - (b.x - a.x)).abs() < ON_STROKE;
            let ends = if is_same { [from.x, to.x] } else { [a.x, b.x] };
            Shape::Radial([Point::new(ends[0], from.z), Point::new(ends[1], to.z)])
        }
        (Shape::Diameter(at), Shape::Diameter(to)) => Shape::Diameter(Point::new(at.x, to.z)),
        (Shape::DiameterThrough(at), Shape::DiameterThrough(to)) => {
            Shape::DiameterThrough(Point::new(at.x, to.z))
        }
        (_, displaced) => displaced,
    }
}

/// The starts of the columns of pecks.
fn columns_of(motions: &Motions, call: Range<usize>) -> Vec<Point> {
    let is_over = |index: &usize| motions.get(*index).cycle.is_some_and(|step| step.step == Step::Stepover);
    let ends = call.filter(is_over).map(|index| motions.get_on_workpiece(index));
    ends.flat_map(|motion| [motion.from, motion.to]).collect()
}

/// The share of a stroke at a point on it, from 0 to 1; `None` if the point is not on it.
fn share_of(shape: &StrokeShape, at: Point) -> Option<f64> {
    match shape {
        StrokeShape::Line { from, to } => {
            let share = within(share_along([*from, *to], at), 0.0, 1.0);
            let place = at_share([*from, *to], share);
            (place.distance(at) < ON_STROKE).then_some(share)
        }
        StrokeShape::Dot(place) => (place.distance(at) < ON_STROKE).then_some(0.0),
        // Displaced as a whole.
        StrokeShape::Arc(arc) => {
            let off = (arc.center.distance(at) - arc.radius()).abs();
            (off < ON_STROKE).then_some(0.0)
        }
        StrokeShape::Virtual(_) => None,
    }
}
