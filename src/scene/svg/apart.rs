//! Draws overlapping passes apart, as manuals do: the passes of G76, pecks along one line, and in the figure of a
//! cycle roughing and finishing.
//!
//! In: the motions of a scene, the size of a pixel. Out: the displaced strokes and points. The path of the tool
//! stays connected: the strokes before and after a displaced pass lead to it.

use std::ops::Range;

use super::super::{Scene, Stroke, StrokeShape};
use super::Passes;
use crate::geometry::bounds::Bounds;
use crate::geometry::{Arc, Point, at_share, share_along, within};
use crate::motion::{Cycle, CycleFamily, Motions, Step};

/// Distance between two passes, and between two pecks, CSS pixels, if there is room.
const GAP: f64 = 3.0;
const PECK_GAP: f64 = 5.0;

/// Maximum displacement of the passes of a cycle, CSS pixels.
const ROOM: f64 = 36.0;

/// Least distance of roughing from finishing in the figure of a cycle, CSS pixels.
const LEAST_ALLOWANCE: f64 = 8.0;

/// A point this near to a stroke is on it, mm.
const ON_STROKE: f64 = 1e-4;

/// Displacements of motions.
#[derive(Default)]
pub(super) struct Apart {
    /// Displacement of the start and the end of each motion, mm; empty if there is none.
    places: Vec<[Point; 2]>,
    /// Whether passes are drawn side by side.
    pub(super) has_passes: bool,
    /// Whether an allowance is drawn larger than it is.
    pub(super) has_allowance: bool,
}

const IN_PLACE: Point = Point { x: 0.0, z: 0.0 };

impl Apart {
    /// The displacements in a scene, with `pixel` mm per CSS pixel.
    pub(super) fn of(scene: &Scene, passes: Passes, pixel: f64) -> Self {
        let motions = scene.motions;
        let mut apart = Self::default();
        let mut first = 0;
        while passes != Passes::InPlace && first < scene.len() {
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
                Some((Cycle::MultiThreading, _)) => apart.thread(motions, first..end, pixel),
                Some((_, CycleFamily::Pecking | CycleFamily::FaceHole | CycleFamily::SideHole)) => {
                    apart.pecks(motions, first..end, pixel);
                }
                Some((Cycle::RoughTurning | Cycle::RoughFacing, _)) if passes == Passes::Figure => {
                    apart.allowance(motions, first..end, pixel);
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
        let mut last = 0;
        for motion in call.clone() {
            last = motions.get(motion).cycle.map_or(0, |step| step.pass).max(last);
        }
        let gap = GAP.min(ROOM / f64::from(last.max(1))) * pixel;
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

    /// Pecks on one line are drawn side by side; the move to the next line ends in place.
    fn pecks(&mut self, motions: &Motions, call: Range<usize>, pixel: f64) {
        let along = |motion: usize| {
            let step = motions.get(motion).cycle.map(|step| step.step);
            !matches!(step, Some(Step::Relief | Step::Stepover | Step::Return | Step::Approach) | None)
        };
        let mut first = call.start;
        while first < call.end {
            let mut end = first;
            while end < call.end && along(end) {
                end += 1;
            }
            // A cut and the way back are at most two lines, which do not overlap with others.
            let column = end - first;
            if column > 2 {
                self.has_passes = true;
                let gap = PECK_GAP.min(ROOM / column as f64) * pixel;
                let motion = motions.get_on_workpiece(first);
                let is_along_z = motion.from.x == motion.to.x;
                let at = |count: usize| {
                    let by = gap * count as f64;
                    if is_along_z { Point { x: by, z: 0.0 } } else { Point { x: 0.0, z: by } }
                };
                for index in 0..column {
                    self.put(first + index, at(index), at(index + 1));
                }
                if end < call.end {
                    self.put(end, at(column), IN_PLACE);
                }
            }
            first = end + 1;
        }
    }

    /// Roughing is displaced away from the contour, until its distance from finishing can be seen.
    fn allowance(&mut self, motions: &Motions, call: Range<usize>, pixel: f64) {
        let first = motions.get_on_workpiece(call.start);
        if first.cycle.is_none_or(|step| step.step != Step::Approach) {
            return;
        }
        let (x, z) = (first.to.x - first.from.x, first.to.z - first.from.z);
        let factor = LEAST_ALLOWANCE * pixel / x.abs().max(z.abs());
        if !factor.is_finite() || factor <= 1.0 {
            return;
        }
        self.has_allowance = true;
        let by = Point { x: (factor - 1.0) * x, z: (factor - 1.0) * z };
        for index in call.clone() {
            let start = if index == call.start { IN_PLACE } else { by };
            let end = if index + 1 == call.end { IN_PLACE } else { by };
            self.put(index, start, end);
        }
    }
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
