//! Passes that lie on one another, drawn apart as manuals do: the passes of G76, and pecks along one line.
//!
//! In: the motions of a scene, how large a pixel is. Out: where a stroke is drawn. The way of the tool stays one line: where a
//! pass leaves its place, the strokes before and after it lead there.

use super::super::{Scene, Stroke, StrokeShape};
use crate::geometry::Point;
use crate::motion::{Cycle, CycleFamily, Motion, Step};

/// From one pass to the next, and from one peck to the next, CSS pixels, while there is room.
const GAP: f64 = 3.0;
const PECK_GAP: f64 = 5.0;

/// All passes of a cycle are within this, CSS pixels.
const ROOM: f64 = 36.0;

/// How far the start and the end of each motion are from their places, mm.
#[derive(Default)]
pub(super) struct Apart(Vec<[Point; 2]>);

impl Apart {
    /// Nothing is moved.
    pub(super) fn nothing() -> Self {
        Self::default()
    }

    /// Of a scene, where a CSS pixel is so many mm.
    pub(super) fn of(scene: &Scene, pixel: f64) -> Self {
        let none = Point::new(0.0, 0.0);
        let mut places = vec![[none; 2]; scene.len()];
        let all: Vec<(Motion, u32)> =
            scene.strokes().map(|stroke| (scene.motions.get(stroke.motion), stroke.line)).collect();
        let mut first = 0;
        while first < all.len() {
            let call = |(motion, line): &(Motion, u32)| Some((motion.cycle?.cycle, *line));
            let own = call(&all[first]);
            let count = all[first..].iter().take_while(|other| call(other) == own).count().max(1);
            let (motions, places) = (&all[first..first + count], &mut places[first..first + count]);
            match own.map(|(cycle, _)| cycle) {
                Some(Cycle::MultiThreading) => thread(motions, pixel, places),
                Some(cycle) => match cycle.family() {
                    CycleFamily::Pecking | CycleFamily::FaceHole | CycleFamily::SideHole => {
                        pecks(motions, pixel, places);
                    }
                    CycleFamily::Turning | CycleFamily::Threading | CycleFamily::Contour => {}
                },
                None => {}
            }
            first += count;
        }
        Self(places)
    }

    /// Whether any pass is drawn beside its place.
    pub(super) fn is_any(&self) -> bool {
        self.0.iter().flatten().any(|by| by.x != 0.0 || by.z != 0.0)
    }

    /// Where a stroke is drawn.
    pub(super) fn shape(&self, stroke: &Stroke) -> StrokeShape {
        let shape = stroke.drawn_shape();
        let Some([start, end]) = self.0.get(stroke.motion) else { return shape };
        match shape {
            StrokeShape::Line { from, to } => {
                // Rapids may be drawn the other way round.
                let turned = stroke.shape.start() != from;
                let (first, last) = if turned { (end, start) } else { (start, end) };
                StrokeShape::Line { from: moved(from, first), to: moved(to, last) }
            }
            StrokeShape::Dot(at) => StrokeShape::Dot(moved(at, start)),
            StrokeShape::Arc(_) | StrokeShape::Virtual(_) => shape,
        }
    }
}

fn moved(at: Point, by: &Point) -> Point {
    Point::new(at.x + by.x, at.z + by.z)
}

/// The last pass of a thread is in its place, those before it farther out of the work.
fn thread(motions: &[(Motion, u32)], pixel: f64, places: &mut [[Point; 2]]) {
    let passes = motions.iter().filter_map(|(motion, _)| motion.cycle).map(|step| step.pass);
    let last = passes.max().unwrap_or(0);
    let gap = GAP.min(ROOM / f64::from(last.max(1))) * pixel;
    let home = motions[0].0.from.x;
    for ((motion, _), place) in motions.iter().zip(places) {
        let Some(step) = motion.cycle.filter(|step| step.pass > 0) else { continue };
        let deep = if step.step == Step::Infeed { motion.to.x } else { motion.from.x };
        let out = Point::new((home - deep).signum() * gap * f64::from(last - step.pass), 0.0);
        let none = Point::new(0.0, 0.0);
        *place = match step.step {
            Step::Infeed => [none, out],
            Step::Cut | Step::PullOut => [out, out],
            Step::Retract => [out, none],
            _ => [none, none],
        };
    }
}

/// Pecks on one line go to and fro beside one another; what leads to the next line ends in its place.
fn pecks(motions: &[(Motion, u32)], pixel: f64, places: &mut [[Point; 2]]) {
    let along = |motion: &Motion| {
        let step = motion.cycle.map(|step| step.step);
        !matches!(step, Some(Step::Relief | Step::Stepover | Step::Return | Step::Approach) | None)
    };
    let mut first = 0;
    while first < motions.len() {
        let column = motions[first..].iter().take_while(|(motion, _)| along(motion)).count();
        // A cut and the way back are two lines at most: nothing lies on them.
        let gap = if column > 2 { PECK_GAP.min(ROOM / column as f64) * pixel } else { 0.0 };
        let is_along_z = motions[first].0.from.x == motions[first].0.to.x;
        let at = |index: usize| {
            let by = gap * index as f64;
            if is_along_z { Point::new(by, 0.0) } else { Point::new(0.0, by) }
        };
        for index in 0..column {
            places[first + index] = [at(index), at(index + 1)];
        }
        if let Some(place) = places.get_mut(first + column) {
            place[0] = at(column);
        }
        first += column + 1;
    }
}
