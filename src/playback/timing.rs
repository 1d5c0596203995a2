//! Computes the time of motions, and spindle speeds.
//!
//! In: a motion and the machine. Out: seconds, rpm, feed; `None` if unknown. Must not know the program.

use std::f64::consts::PI;

use crate::geometry::virtual_plane::VirtualMove;
use crate::geometry::{Point, SAME, within};
use crate::motion::{Feed, Motion, MotionKind, Process, SpindleSpeed, SpindleTurn};
use crate::setup::Machine;

/// Maximum plausible spindle speed, rpm: a higher result means that no limit is set, so the speed is unknown.
const NO_LIMIT: f64 = 100_000.0;

/// Rate of rapids of a machine whose setup gives none, mm/min: that of a small lathe.
pub const ASSUMED_RAPID: f64 = 8000.0;

/// Number of pieces for the integration of the time of an arc under G96.
const PIECES: u32 = 32;

/// Spindle speed, rpm, with the tip at a radius, mm; `None` if the spindle is stopped, or without a limit at
/// the axis.
pub fn speed_at(process: &Process, machine: &Machine, radius: f64) -> Option<f64> {
    if process.turn == SpindleTurn::Stopped {
        return None;
    }
    let limit = highest(process, machine);
    let speed = match process.speed {
        SpindleSpeed::Constant(speed) => limit.map_or(speed, |limit| speed.min(limit)),
        SpindleSpeed::Surface { speed } if speed <= 0.0 => 0.0,
        SpindleSpeed::Surface { speed } => {
            let free = 1000.0 * speed / (2.0 * PI * radius.abs());
            let wanted = process.lowest.map_or(free, |lowest| free.max(lowest));
            limit.map_or(wanted, |limit| wanted.min(limit))
        }
    };
    (speed > 0.0 && speed < NO_LIMIT).then_some(speed)
}

/// Cutting speed at a radius, m/min; `speed` in rpm, `radius` in mm.
pub fn surface_speed(speed: f64, radius: f64) -> f64 {
    2.0 * PI * radius.abs() * speed / 1000.0
}

/// Feed along the path with the tip at a radius, mm/min; for a thread with a variable lead, at its end.
/// `None` for rapids and dwells.
pub fn feed_at(motion: &Motion, machine: &Machine, radius: f64) -> Option<f64> {
    let per_turn = match (motion.kind, motion.process.feed) {
        (MotionKind::Rapid | MotionKind::Dwell, _) => return None,
        // The lead is measured along the longer axis, the feed along the path.
        (MotionKind::Thread, _) => motion.last_lead()? * motion.length() / motion.longer_axis(),
        (_, Feed::PerMinute(feed)) => return Some(feed),
        (_, Feed::PerTurn(feed)) => feed,
        (_, Feed::Unset) => return None,
    };
    Some(per_turn * speed_at(&motion.process, machine, radius)?).filter(|feed| feed.is_finite())
}

/// Time of a motion, seconds.
pub fn seconds(motion: &Motion, machine: &Machine) -> Option<f64> {
    if motion.kind == MotionKind::Dwell {
        return motion.seconds;
    }
    let length = motion.length();
    if motion.kind == MotionKind::Rapid {
        return rapid(motion, machine);
    }
    // Degrees count as length for a feed (B-64304EN, feed of rotary axes).
    let way = length.hypot(motion.turned());
    if way <= SAME {
        return Some(0.0);
    }
    let seconds = match (motion.kind, motion.process.feed, motion.process.speed) {
        (MotionKind::Thread, _, SpindleSpeed::Surface { .. }) => under_surface_speed(motion, machine)?,
        (_, Feed::PerTurn(_), SpindleSpeed::Surface { .. }) if length > SAME => {
            under_surface_speed(motion, machine)? * way / length
        }
        (MotionKind::Thread, ..) => 60.0 * motion.turns()? / speed_at(&motion.process, machine, motion.to.x)?,
        _ => 60.0 * way / feed_at(motion, machine, motion.to.x)?,
    };
    Some(seconds).filter(|seconds| seconds.is_finite())
}

/// Each axis moves at its own rate: the time of the slower one.
fn rapid(motion: &Motion, machine: &Machine) -> Option<f64> {
    let axis = |length: f64, rate: Option<f64>| match length.abs() {
        length if length <= SAME => Some(0.0),
        length => Some(60.0 * length / rate?),
    };
    // The rapid rates of C and Y are not in the setup.
    let moves_y = |own: VirtualMove| own.y_at(0.0) != own.y_at(1.0);
    if motion.rotary.is_some_and(|rotary| rotary.from != rotary.to)
        || motion.virtual_move().is_some_and(moves_y)
    {
        return None;
    }
    let x = axis(motion.to.x - motion.from.x, machine.rapid_x)?;
    let z = axis(motion.to.z - motion.from.z, machine.rapid_z)?;
    Some(x.max(z))
}

/// Time of a rapid along X and Z, seconds; an axis without a rate moves at [`ASSUMED_RAPID`].
pub fn assumed_seconds(motion: &Motion, machine: &Machine) -> f64 {
    let along = |length: f64, rate: Option<f64>| 60.0 * length.abs() / rate.unwrap_or(ASSUMED_RAPID);
    let (x, z) = (motion.to.x - motion.from.x, motion.to.z - motion.from.z);
    along(x, machine.rapid_x).max(along(z, machine.rapid_z))
}

/// The time of a cut under constant surface speed. For a straight cut the integral is exact: the time per mm
/// is proportional to the radius while the speed follows it, and constant below the radius at which the limit
/// is reached.
fn under_surface_speed(motion: &Motion, machine: &Machine) -> Option<f64> {
    let SpindleSpeed::Surface { speed } = motion.process.speed else { return None };
    let held = 1000.0 * speed / (2.0 * PI);
    let limit = highest(&motion.process, machine);
    // Revolutions per mm of path.
    let turns = match (motion.kind, motion.process.feed) {
        (MotionKind::Thread, _) => motion.turns()? / motion.length(),
        (_, Feed::PerTurn(feed)) => 1.0 / feed,
        _ => return None,
    };
    // The spindle must turn, and at the axis there must be a limit.
    let nearest =
        if motion.from.x * motion.to.x <= 0.0 { 0.0 } else { motion.from.x.abs().min(motion.to.x.abs()) };
    speed_at(&motion.process, machine, nearest)?;
    let points: Vec<Point> = match motion.arc() {
        Some(arc) => (0..=PIECES).map(|piece| arc.at(f64::from(piece) / f64::from(PIECES))).collect(),
        None => vec![motion.from, motion.to],
    };
    let share = motion.length() / points.windows(2).map(|ends| ends[0].distance(ends[1])).sum::<f64>();
    // Near the axis the maximum speed applies, far out the minimum speed.
    let near = limit.map_or(0.0, |limit| held / limit);
    let far = motion.process.lowest.filter(|&lowest| lowest > 0.0).map_or(f64::MAX, |lowest| held / lowest);
    let corners = (near, far.max(near));
    let minutes: f64 = points
        .windows(2)
        .map(|ends| {
            let length = share * ends[0].distance(ends[1]);
            turns * length * mean_within(ends[0].x, ends[1].x, corners) / held
        })
        .sum();
    Some(60.0 * minutes)
}

/// The mean of `|x|`, clamped to two bounds, for x uniformly from `a` to `b`.
fn mean_within(a: f64, b: f64, (least, most): (f64, f64)) -> f64 {
    if (a < 0.0) != (b < 0.0) && a != 0.0 && b != 0.0 {
        // If x crosses the axis, the mean of both sides is weighted by their lengths.
        let (left, right) = (a.abs(), b.abs());
        let side = |end: f64| end * mean_within(0.0, end, (least, most));
        return (side(left) + side(right)) / (left + right);
    }
    let (low, high) = (a.abs().min(b.abs()), a.abs().max(b.abs()));
    if high - low <= 1e-12 {
        return within(f64::midpoint(low, high), least, most);
    }
    let (first, last) = (within(low, least, most), within(high, least, most));
    let below = (high.min(least) - low).max(0.0);
    let above = (high - low.max(most)).max(0.0);
    let between = (high - low - below - above).max(0.0);
    (below * least + between * f64::midpoint(first, last) + above * most) / (high - low)
}

fn highest(process: &Process, machine: &Machine) -> Option<f64> {
    // G50 S is a limit under G96 only.
    let clamp = process.clamp.filter(|_| matches!(process.speed, SpindleSpeed::Surface { .. }));
    match (clamp, machine.max_speed) {
        (Some(clamp), Some(most)) => Some(clamp.min(most)),
        (clamp, most) => clamp.or(most),
    }
}

/// The total time of a run, and the number of motions of unknown time.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Total {
    /// Total of the known times, seconds.
    pub known: f64,
    /// Number of cuts of unknown time.
    pub unknown_cuts: u32,
    /// Number of rapids of unknown time.
    pub unknown_rapids: u32,
    /// Total of the times of those rapids at [`ASSUMED_RAPID`], seconds.
    pub assumed: f64,
}

impl Total {
    /// Adds a motion.
    pub fn add(&mut self, motion: &Motion, machine: &Machine) {
        match (seconds(motion, machine), motion.kind) {
            (Some(seconds), _) => self.known += seconds,
            (None, MotionKind::Rapid) => {
                self.unknown_rapids += 1;
                self.assumed += assumed_seconds(motion, machine);
            }
            (None, _) => self.unknown_cuts += 1,
        }
    }

    /// The time with the rapids of unknown rate, seconds.
    pub fn estimated(&self) -> f64 {
        self.known + self.assumed
    }
}
