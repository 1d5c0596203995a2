//! Draws overlapping passes apart, as manuals do: the passes of G76, and pecks along one line.
//!
//! In: the motions of a scene, the size of a pixel. Out: the displaced strokes. The path of the tool stays
//! connected: the strokes before and after a displaced pass lead to it.

use std::ops::Range;

use super::super::{Scene, Stroke, StrokeShape};
use crate::geometry::Point;
use crate::motion::{Cycle, CycleFamily, Motions, Step};

/// Distance between two passes, and between two pecks, CSS pixels, if there is room.
const GAP: f64 = 3.0;
const PECK_GAP: f64 = 5.0;

/// Maximum displacement of the passes of a cycle, CSS pixels.
const ROOM: f64 = 36.0;

/// Displacement of the start and the end of each motion, mm; empty if there is none.
#[derive(Default)]
pub(super) struct Apart(Vec<[Point; 2]>);

const IN_PLACE: Point = Point { x: 0.0, z: 0.0 };

impl Apart {
    /// The displacements in a scene, with `pixel` mm per CSS pixel.
    pub(super) fn of(scene: &Scene, pixel: f64) -> Self {
        let motions = scene.motions;
        let mut places = Vec::new();
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
                Some((Cycle::MultiThreading, _)) => thread(motions, first..end, pixel, &mut places),
                Some((_, CycleFamily::Pecking | CycleFamily::FaceHole | CycleFamily::SideHole)) => {
                    pecks(motions, first..end, pixel, &mut places);
                }
                _ => {}
            }
            first = end;
        }
        Self(places)
    }

    /// Whether any pass is displaced.
    pub(super) fn is_any(&self) -> bool {
        !self.0.is_empty()
    }

    /// The displaced shape of a stroke.
    pub(super) fn shape(&self, stroke: &Stroke) -> StrokeShape {
        let shape = stroke.drawn_shape();
        let Some([start, end]) = self.0.get(stroke.motion) else { return shape };
        match shape {
            StrokeShape::Line { from, to } => {
                // Rapids may be drawn in the opposite direction.
                let turned = stroke.shape.start() != from;
                let (first, last) = if turned { (end, start) } else { (start, end) };
                StrokeShape::Line { from: from.moved(*first), to: to.moved(*last) }
            }
            StrokeShape::Dot(at) => StrokeShape::Dot(at.moved(*start)),
            StrokeShape::Arc(_) | StrokeShape::Virtual(_) => shape,
        }
    }
}

/// Sets the displacement of a motion.
fn put(places: &mut Vec<[Point; 2]>, motion: usize, start: Point, end: Point) {
    if places.len() <= motion {
        places.resize(motion + 1, [IN_PLACE; 2]);
    }
    places[motion] = [start, end];
}

/// The last pass of a thread is in place; the earlier passes are displaced away from the part.
fn thread(motions: &Motions, call: Range<usize>, pixel: f64, places: &mut Vec<[Point; 2]>) {
    let home = motions.get_on_workpiece(call.start).from.x;
    let mut last = 0;
    for motion in call.clone() {
        last = motions.get(motion).cycle.map_or(0, |step| step.pass).max(last);
    }
    let gap = GAP.min(ROOM / f64::from(last.max(1))) * pixel;
    for index in call {
        let motion = motions.get_on_workpiece(index);
        let Some(step) = motion.cycle.filter(|step| step.pass > 0 && step.pass < last) else { continue };
        let deep = if step.step == Step::Infeed { motion.to.x } else { motion.from.x };
        let out = Point { x: (home - deep).signum() * gap * f64::from(last - step.pass), z: 0.0 };
        match step.step {
            Step::Infeed => put(places, index, IN_PLACE, out),
            Step::Cut | Step::PullOut => put(places, index, out, out),
            Step::Retract => put(places, index, out, IN_PLACE),
            _ => {}
        }
    }
}

/// Pecks on one line are drawn side by side; the move to the next line ends in place.
fn pecks(motions: &Motions, call: Range<usize>, pixel: f64, places: &mut Vec<[Point; 2]>) {
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
            let gap = PECK_GAP.min(ROOM / column as f64) * pixel;
            let motion = motions.get_on_workpiece(first);
            let is_along_z = motion.from.x == motion.to.x;
            let at = |count: usize| {
                let by = gap * count as f64;
                if is_along_z { Point { x: by, z: 0.0 } } else { Point { x: 0.0, z: by } }
            };
            for index in 0..column {
                put(places, first + index, at(index), at(index + 1));
            }
            if end < call.end {
                put(places, end, at(column), IN_PLACE);
            }
        }
        first = end + 1;
    }
}
