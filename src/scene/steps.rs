//! The labels of a single cycle's steps, as in manuals: ① ② ③ ④. The line shows rapid or feed.
//!
//! In: the motions of the selected block. Out: a label for each stroke of one pass of G90, G92 or G94. Must
//! not know canvases.

use std::ops::Range;

use super::camera::{Camera, Pixel};
use crate::cycles::single::Single;
use crate::geometry::Point;
use crate::motion::{CycleStep, Motion, MotionKind, Motions, Step};

/// Distance from a stroke to the middle of its label, CSS pixels.
const BESIDE: f64 = 13.0;
/// Minimum length of a stroke with a label, CSS pixels.
const MIN_LENGTH: f64 = 10.0;
/// Maximum number of motions in a pass of these cycles.
const MAX_MOTIONS: usize = 8;

/// The label of a stroke.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepLabel {
    /// The text of the label.
    pub text: &'static str,
    from: Point,
    to: Point,
    /// The middle of the pass; each label is on the side of its stroke that faces away from it.
    middle: Point,
}

impl StepLabel {
    /// The position of the middle of the label; `None` if the stroke is too short for a label.
    pub fn place(&self, camera: &Camera) -> Option<Pixel> {
        let [from, to, middle] = [self.from, self.to, self.middle].map(|at| camera.to_screen(at));
        let length = from.distance(to);
        if length < MIN_LENGTH {
            return None;
        }
        let half = Pixel::new((from.x + to.x) / 2.0, (from.y + to.y) / 2.0);
        let (mut nx, mut ny) = ((to.y - from.y) / length, (from.x - to.x) / length);
        if nx * (half.x - middle.x) + ny * (half.y - middle.y) < 0.0 {
            (nx, ny) = (-nx, -ny);
        }
        Some(Pixel::new(half.x + BESIDE * nx, half.y + BESIDE * ny))
    }
}

/// The labels of one pass among the selected motions: the pass that contains the motion `pointed`, otherwise
/// the first.
pub fn labels(motions: &Motions, picked: &[Range<usize>], pointed: Option<usize>) -> Vec<StepLabel> {
    let holds = |index: usize| picked.iter().any(|range| range.contains(&index));
    let pass_of =
        |index: usize| Some(motions.get(index).cycle.filter(is_single)?).map(|own| (own.cycle, own.pass));
    let first = picked.first().map(|range| range.start);
    let Some(at) = pointed.filter(|&index| holds(index)).or(first).filter(|&index| index < motions.len())
    else {
        return Vec::new();
    };
    let Some(pass) = pass_of(at) else { return Vec::new() };
    let is_of_pass = |index: &usize| holds(*index) && pass_of(*index) == Some(pass);
    let begin = (at.saturating_sub(MAX_MOTIONS)..=at).rev().take_while(is_of_pass).last().unwrap_or(at);
    let end = motions.len().min(begin + MAX_MOTIONS);
    let own: Vec<Motion> =
        (begin..end).take_while(is_of_pass).map(|index| motions.get_on_workpiece(index)).collect();
    let ends = own.iter().fold((0.0, 0.0), |sum, motion| (sum.0 + motion.to.x, sum.1 + motion.to.z));
    let count = own.len() as f64;
    let middle = Point::new(ends.0 / count, ends.1 / count);
    let label = |motion: &Motion| {
        let text = text(motion)?;
        Some(StepLabel { text, from: motion.from, to: motion.to, middle })
    };
    own.iter().filter_map(label).collect()
}

fn is_single(step: &CycleStep) -> bool {
    Single::of(step.cycle).is_some()
}

/// The label of a step: its number. The letters R and F are words of the program.
fn text(motion: &Motion) -> Option<&'static str> {
    match motion.cycle?.step {
        _ if motion.kind == MotionKind::Dwell => None,
        Step::Infeed => Some("①"),
        Step::Cut => Some("②"),
        Step::Retract => Some("③"),
        Step::Return => Some("④"),
        // Leaving the thread belongs to the second step.
        _ => None,
    }
}

#[cfg(test)]
#[allow(clippy::single_range_in_vec_init, reason = "one range of motions is picked out")]
mod tests {
    use super::*;
    use crate::analyze;
    use crate::geometry::bounds::Bounds;
    use crate::scene::camera::Size;
    use crate::setup::Setup;

    fn motions(program: &str) -> Motions {
        analyze(program.as_bytes(), &Setup::default()).motions
    }

    fn said(labels: &[StepLabel]) -> Vec<&str> {
        labels.iter().map(|label| label.text).collect()
    }

    #[test]
    fn a_pass_reads_as_in_the_manual() {
        let list = motions("G00 X62 Z2\nG90 X50 Z-30 F0.2\nX46\nG00 X100");
        assert_eq!(said(&labels(&list, &[1..5], None)), ["①", "②", "③", "④"]);
        let second = labels(&list, &[1..9], Some(7));
        assert_eq!(said(&second), ["①", "②", "③", "④"]);
        assert!((second[1].to.x - 23.0).abs() < 1e-9);
        assert!(labels(&list, &[0..1], None).is_empty() && labels(&list, &[], None).is_empty());
        let thread = motions("G97 S500 M03\nG00 X32 Z5\nG92 X29 Z-30 F2");
        assert_eq!(said(&labels(&thread, &[1..thread.len()], None)), ["①", "②", "③", "④"]);
    }

    #[test]
    fn labels_stand_outside_of_the_pass() {
        let list = motions("G00 X62 Z2\nG90 X50 Z-30 F0.2");
        let camera = Camera::fit(
            Bounds::around(Point::new(0.0, -40.0), Point::new(40.0, 10.0)),
            Size { width: 800.0, height: 600.0 },
        );
        let places: Vec<Point> = labels(&list, &[1..5], None)
            .iter()
            .map(|label| camera.to_world(label.place(&camera).expect("room")))
            .collect();
        assert!(places[0].z > 2.0 && places[1].x < 25.0 && places[2].z < -30.0 && places[3].x > 31.0);
    }
}
