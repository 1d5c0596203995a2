//! Finds the side of the workpiece that G70 finishes: the side of the roughing cycle of the same contour.
//!
//! In: the motions. Out: the side of each finishing cycle that follows a roughing cycle of a contour in the
//! same place. The moves to and from the start point of G70 are ignored, because that point may be anywhere.
//! Must not know tools.

use std::ops::RangeInclusive;

use super::evidence::Evidence;
use crate::geometry::bounds::Bounds;
use crate::geometry::{Point, SAME};
use crate::motion::{Cycle, Motion, Step};

/// Maximum distance of roughing from the contour, mm: the allowances U and W.
const MAX_ALLOWANCE: f64 = 3.0;

/// Maximum number of roughing cycles that are compared with a finishing cycle.
const MAX_COMPARED: usize = 50;

/// The finishing cycles whose side is known, in order: their motions, and 1 outside, −1 inside.
#[derive(Clone, Debug, Default)]
pub(super) struct Finishings(Vec<(RangeInclusive<usize>, i32)>);

impl Finishings {
    /// Finds the finishing cycles of a program.
    pub fn of(evidence: &Evidence) -> Self {
        let (mut found, mut roughed) = (Vec::new(), Vec::new());
        let mut call: Option<Call> = None;
        for (index, motion) in evidence.moves().enumerate() {
            let current = call.as_mut().filter(|call| call.contains(&motion));
            match current {
                Some(call) => call.add(index, &motion),
                None => {
                    close(call.take(), &mut roughed, &mut found);
                    call = Call::begin(index, &motion);
                }
            }
        }
        close(call, &mut roughed, &mut found);
        Self(found)
    }

    /// The side of the finishing cycle that a motion belongs to, if known.
    pub fn side(&self, index: usize) -> Option<i32> {
        let next = self.0.partition_point(|(motions, _)| *motions.end() < index);
        self.0.get(next).filter(|(motions, _)| motions.contains(&index)).map(|own| own.1)
    }
}

/// The current call of a cycle.
#[derive(Clone, Copy, Debug)]
struct Call {
    cycle: Cycle,
    first: usize,
    last: usize,
    /// Start point.
    start: Point,
    /// The box around the cuts along the contour.
    area: Option<Bounds>,
    pass: u32,
    is_over: bool,
}

impl Call {
    fn begin(index: usize, motion: &Motion) -> Option<Self> {
        let cycle = motion.cycle?.cycle;
        if !matches!(cycle, Cycle::Finishing | Cycle::RoughTurning | Cycle::RoughFacing | Cycle::Pattern) {
            return None;
        }
        let start = motion.from;
        let mut call = Self { cycle, first: index, last: index, start, area: None, pass: 0, is_over: false };
        call.add(index, motion);
        Some(call)
    }

    /// Whether a motion belongs to this call. After the move back to the start point, the next call begins.
    fn contains(&self, motion: &Motion) -> bool {
        !self.is_over && motion.cycle.is_some_and(|step| step.cycle == self.cycle)
    }

    fn add(&mut self, index: usize, motion: &Motion) {
        let Some(step) = motion.cycle else { return };
        self.last = index;
        self.is_over = step.step == Step::Return && step.pass == 0;
        if !motion.kind.cuts() {
            return;
        }
        // The passes of G73 approach the contour, so the area of each pass replaces that of the last one.
        if step.cycle == Cycle::Pattern && step.pass != self.pass {
            (self.pass, self.area) = (step.pass, None);
        }
        let (from, to) = (motion.from, motion.to);
        self.area = Some(self.area.unwrap_or(Bounds::of(from)).with(from).with(to));
    }
}

/// Whether a finishing cycle follows a roughed contour: both end at about the same Z and the same depth in X.
fn is_same_contour(roughed: Bounds, finished: Bounds, side: i32) -> bool {
    let near = |a: f64, b: f64| (a - b).abs() <= MAX_ALLOWANCE;
    let is_as_deep =
        if side > 0 { near(roughed.min.x, finished.min.x) } else { near(roughed.max.x, finished.max.x) };
    is_as_deep && near(roughed.min.z, finished.min.z)
}

/// Records a finished call: roughing in `roughed`; finishing in `found`, if its side is known.
fn close(
    call: Option<Call>,
    roughed: &mut Vec<(Bounds, i32)>,
    found: &mut Vec<(RangeInclusive<usize>, i32)>,
) {
    let Some(call) = call else { return };
    let Some(area) = call.area else { return };
    if call.cycle == Cycle::Finishing {
        let roughed = roughed.iter().rev().take(MAX_COMPARED);
        if let Some((_, side)) =
            roughed.copied().find(|&(roughed, side)| is_same_contour(roughed, area, side))
        {
            found.push((call.first..=call.last, side));
        }
        return;
    }
    // The material lies between the start point and the contour.
    let away = call.start.x - (area.min.x + area.max.x) / 2.0;
    if away.abs() > SAME {
        roughed.push((area, if away > 0.0 { 1 } else { -1 }));
    }
}
