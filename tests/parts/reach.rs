//! The material that a tool removes at one place along Z, calculated without areas.
//!
//! In: motions, and separately defined outlines of tools. Out: the intervals of radius that are left of a
//! blank at a Z. For each straight piece of a cut, the smallest radius that the outline reaches at that Z is
//! the minimum of a convex function of the position on the path, and the largest is the maximum of a concave
//! one; both are found by narrowing the interval. Uses nothing of `machine`.

use gcode_playground::geometry::Point;
use gcode_playground::motion::{Motion, MotionKind};
use gcode_playground::setup::Stock;

/// An interval of radius: from, to; mm.
pub type Interval = (f64, f64);

/// A convex outline relative to the tip: a polygon, and a disc that rounds its corner.
#[derive(Clone, Debug)]
pub struct Reach {
    /// Corners in order: (z, x).
    pub corners: Vec<(f64, f64)>,
    /// Centre (z, x) and radius.
    pub disc: Option<((f64, f64), f64)>,
    /// Whether it cuts one notch per spindle revolution.
    pub threads: bool,
}

/// Largest distance of an arc from its chord, mm.
const SAGITTA: f64 = 1e-4;

impl Reach {
    fn new(corners: Vec<(f64, f64)>) -> Self {
        Self { corners, disc: None, threads: false }
    }

    /// A rhombus whose edges lie `trailing` and `trailing + point` degrees from +Z, positioned by the corner
    /// at the lower left of its nose. `flip` (±1 for Z and X) mirrors it for other tip directions. With
    /// `tall`, everything above it cuts as well.
    pub fn rhombus(trailing: f64, point: f64, edge: f64, nose: f64, flip: (f64, f64), tall: bool) -> Self {
        let (low, high) = (trailing.to_radians(), (trailing + point).to_radians());
        let bisector = (low + high) / 2.0;
        let half = point.to_radians() / 2.0;
        // The corner without a nose, so that a disc that touches both axes touches both edges.
        let sharp = (nose - nose / half.sin() * bisector.cos(), nose - nose / half.sin() * bisector.sin());
        let along = |from: (f64, f64), angle: f64, length: f64| {
            (from.0 + length * angle.cos(), from.1 + length * angle.sin())
        };
        let tangent = nose / half.tan();
        let edge = edge.max(1.01 * tangent);
        let (one, other) = (along(sharp, low, edge), along(sharp, high, edge));
        let mut corners = match nose {
            0.0 => vec![sharp],
            _ => vec![along(sharp, high, tangent), along(sharp, low, tangent)],
        };
        corners.extend([one, along(one, high, edge), other]);
        if tall {
            // The minimum and maximum along Z, extended far upwards.
            let (left, right) = extent(&corners, nose);
            corners = lower_chain(&corners, left, right);
        }
        let turned = |(z, x): (f64, f64)| (flip.0 * z, flip.1 * x);
        let disc = (nose > 0.0).then(|| (turned((nose, nose)), nose));
        Self { corners: corners.into_iter().map(turned).collect(), disc, threads: false }
    }

    /// A grooving insert from its left corner to `width`, outwards (`up` 1) or inwards (−1).
    pub fn blade(width: f64, up: f64) -> Self {
        Self::new(vec![(0.0, 0.0), (width, 0.0), (width, 400.0 * up), (0.0, 400.0 * up)])
    }

    /// A face grooving insert: it cuts `width` outwards from its lower corner.
    pub fn face_blade(width: f64) -> Self {
        Self::new(vec![(0.0, 0.0), (400.0, 0.0), (400.0, width), (0.0, width)])
    }

    /// A 60° thread profile for a pitch: it widens to the width for that pitch, and continues with that width
    /// for the height of the insert.
    pub fn thread(up: f64, pitch: f64) -> Self {
        let half = 0.55 * pitch + 0.1;
        let shoulder = half * 3f64.sqrt();
        let size = if pitch <= 3.0 {
            16.0
        } else if pitch <= 6.0 {
            22.0
        } else {
            27.0
        };
        let top = f64::max(size, shoulder);
        let corners = [(0.0, 0.0), (half, shoulder), (half, top), (-half, top), (-half, shoulder)];
        Self { threads: true, ..Self::new(corners.map(|(z, x)| (z, up * x)).to_vec()) }
    }

    /// A drill with a point of 118°.
    pub fn drill(diameter: f64) -> Self {
        let (radius, shoulder) = (diameter / 2.0, diameter / 2.0 / 59f64.to_radians().tan());
        Self::new(vec![
            (0.0, 0.0),
            (shoulder, radius),
            (400.0, radius),
            (400.0, -radius),
            (shoulder, -radius),
        ])
    }

    /// Minimum and maximum Z.
    fn support(&self) -> Interval {
        let mut found = (f64::INFINITY, f64::NEG_INFINITY);
        for &(z, _) in &self.corners {
            found = (found.0.min(z), found.1.max(z));
        }
        if let Some(((z, _), radius)) = self.disc {
            found = (found.0.min(z - radius), found.1.max(z + radius));
        }
        found
    }

    /// Minimum and maximum X at a Z.
    fn column(&self, z: f64) -> Interval {
        let mut found = (f64::INFINITY, f64::NEG_INFINITY);
        let mut add = |x: f64| found = (found.0.min(x), found.1.max(x));
        for (index, &(az, ax)) in self.corners.iter().enumerate() {
            let (bz, bx) = self.corners[(index + 1) % self.corners.len()];
            if az == z {
                add(ax);
            }
            if (az < z) != (bz < z) {
                add(ax + (z - az) / (bz - az) * (bx - ax));
            }
        }
        if let Some(((center_z, center_x), radius)) = self.disc {
            let across = radius * radius - (z - center_z).powi(2);
            if across >= 0.0 {
                add(center_x - across.sqrt());
                add(center_x + across.sqrt());
            }
        }
        found
    }

    /// What one straight move removes at a Z.
    fn along(&self, from: Point, to: Point, z: f64) -> Option<Interval> {
        let (dx, dz) = (to.x - from.x, to.z - from.z);
        let (left, right) = self.support();
        // left ≤ z − z(t) ≤ right
        let (mut begin, mut end) = (0.0, 1.0);
        if dz.abs() < 1e-12 {
            if z - from.z < left || z - from.z > right {
                return None;
            }
        } else {
            let (one, other) = ((z - right - from.z) / dz, (z - left - from.z) / dz);
            (begin, end) = (one.min(other).max(0.0), one.max(other).min(1.0));
            if begin > end {
                return None;
            }
        }
        let at = |t: f64| {
            let (low, high) = self.column((z - from.z - t * dz).clamp(left, right));
            (from.x + t * dx + low, from.x + t * dx + high)
        };
        let low = least(begin, end, |t| at(t).0);
        let high = -least(begin, end, |t| -at(t).1);
        (low.is_finite() && high.is_finite()).then_some((low, high))
    }

    /// What a motion removes at a Z. `turned` is how far the spindle has turned in the thread before the
    /// motion.
    pub fn taken(&self, motion: &Motion, turned: f64, z: f64) -> Vec<Interval> {
        if !motion.kind.cuts() {
            return Vec::new();
        }
        let Motion { from, to, .. } = *motion;
        let part = |t: f64| Point::new(from.x + t * (to.x - from.x), from.z + t * (to.z - from.z));
        match (motion.center, motion.lead.filter(|_| self.threads && motion.kind == MotionKind::Thread)) {
            (None, None) => self.along(from, to, z).into_iter().collect(),
            (None, Some(lead)) => {
                let turns = turns(motion, lead);
                let whole = (turned - 1e-6).ceil() as u32..=(turned + turns + 1e-6).floor() as u32;
                let places = whole.map(|turn| part((f64::from(turn) - turned) / turns));
                places.filter_map(|place| self.along(place, place, z)).collect()
            }
            (Some(center), _) => {
                let angle = |point: Point| (point.x - center.x).atan2(point.z - center.z);
                let radius = from.distance(center);
                let mut sweep = angle(to) - angle(from);
                match motion.kind {
                    MotionKind::ArcCounterclockwise if sweep <= 1e-9 => sweep += std::f64::consts::TAU,
                    MotionKind::ArcClockwise if sweep >= -1e-9 => sweep -= std::f64::consts::TAU,
                    _ => {}
                }
                let pieces = (sweep.abs() / (8.0 * SAGITTA / radius).sqrt()).ceil().max(1.0);
                let at = |piece: u32| {
                    let angle = angle(from) + f64::from(piece) / pieces * sweep;
                    Point::new(center.x + radius * angle.sin(), center.z + radius * angle.cos())
                };
                (0..pieces as u32).filter_map(|piece| self.along(at(piece), at(piece + 1), z)).collect()
            }
        }
    }

    /// What the insert removes at a Z at the end of a thread after `turned` revolutions: all around, one turn
    /// wide.
    pub fn groove(&self, thread: &Motion, turned: f64, z: f64) -> Option<Interval> {
        let lead = thread.lead.filter(|_| thread.kind == MotionKind::Thread)?;
        let between = (turned - turned.round()).abs() > 1e-6;
        let (dx, dz) = ((thread.to.x - thread.from.x).abs(), (thread.to.z - thread.from.z).abs());
        let within = dz < dx || (z - thread.to.z).abs() <= lead.abs() / 2.0;
        if between && within { self.along(thread.to, thread.to, z) } else { None }
    }
}

/// Number of spindle revolutions in a thread.
pub fn turns(motion: &Motion, lead: f64) -> f64 {
    (motion.to.x - motion.from.x).abs().max((motion.to.z - motion.from.z).abs()) / lead
}

fn extent(corners: &[(f64, f64)], nose: f64) -> Interval {
    let disc = if nose > 0.0 { 0.0 } else { f64::INFINITY };
    let left = corners.iter().map(|corner| corner.0).fold(disc, f64::min);
    (left, corners.iter().map(|corner| corner.0).fold(f64::NEG_INFINITY, f64::max))
}

/// The corners, with the upper ones moved far up.
fn lower_chain(corners: &[(f64, f64)], left: f64, right: f64) -> Vec<(f64, f64)> {
    let mut all: Vec<(f64, f64)> = corners.to_vec();
    all.extend([(right, 400.0), (left, 400.0)]);
    // The lower hull from left to right, by gift wrapping.
    let start = *all.iter().min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1))).expect("corners");
    let mut hull = vec![start];
    loop {
        let last = *hull.last().expect("a corner");
        let next = all.iter().copied().filter(|&point| point != last).reduce(|best, point| {
            let turn = (best.0 - last.0) * (point.1 - last.1) - (best.1 - last.1) * (point.0 - last.0);
            if turn < 0.0 { point } else { best }
        });
        let Some(next) = next.filter(|&next| next != start && hull.len() < 20) else { return hull };
        hull.push(next);
    }
}

/// The minimum of a convex function.
fn least(mut low: f64, mut high: f64, of: impl Fn(f64) -> f64) -> f64 {
    let mut found = of(low).min(of(high));
    for _ in 0..45 {
        let (one, other) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
        let (a, b) = (of(one), of(other));
        found = found.min(a).min(b);
        if a < b { high = other } else { low = one }
    }
    found
}

/// What is left of a blank at a Z.
pub fn left(stock: &Stock, taken: &[Interval], z: f64) -> Vec<Interval> {
    if z > stock.face || z < stock.face - stock.length {
        return Vec::new();
    }
    let mut rest = vec![(stock.bore.radius(), stock.diameter.radius())];
    for &(low, high) in taken {
        rest = rest
            .into_iter()
            .flat_map(|(a, b)| [(a, b.min(low)), (a.max(high), b)])
            .filter(|(a, b)| a < b)
            .collect();
    }
    rest.sort_by(|a, b| a.0.total_cmp(&b.0));
    rest
}

/// Removes slits and slivers that are thinner than any tolerance.
pub fn without_dust(intervals: &[Interval]) -> Vec<Interval> {
    const DUST: f64 = 0.004;
    let mut kept: Vec<Interval> = Vec::new();
    for &(low, high) in intervals {
        match kept.last_mut() {
            Some(last) if low - last.1 < DUST => last.1 = last.1.max(high),
            _ => kept.push((low, high)),
        }
    }
    kept.retain(|(low, high)| high - low > DUST);
    kept
}

/// Moves both ends of each interval outwards by `by`, or inwards if it is negative, and merges intervals that
/// meet.
pub fn moved(intervals: &[Interval], by: f64) -> Vec<Interval> {
    union(&intervals.iter().map(|(low, high)| (low - by, high + by)).collect::<Vec<_>>())
}

/// The union of the intervals, in order. Inverted intervals are empty.
pub fn union(intervals: &[Interval]) -> Vec<Interval> {
    let mut all: Vec<Interval> = intervals.iter().copied().filter(|(low, high)| low < high).collect();
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut kept: Vec<Interval> = Vec::new();
    for (low, high) in all {
        match kept.last_mut() {
            Some(last) if low <= last.1 => last.1 = last.1.max(high),
            _ => kept.push((low, high)),
        }
    }
    kept
}

/// The intersection of both.
pub fn common(one: &[Interval], other: &[Interval]) -> Vec<Interval> {
    let pairs = one.iter().flat_map(|a| other.iter().map(move |b| (a.0.max(b.0), a.1.min(b.1))));
    union(&pairs.collect::<Vec<_>>())
}

/// Whether `inner` lies completely in `outer`, whose intervals do not meet.
pub fn within(inner: &[Interval], outer: &[Interval]) -> bool {
    inner.iter().all(|a| outer.iter().any(|b| b.0 <= a.0 && a.1 <= b.1))
}
