//! Rapids into material that must exist for any blank: below the surfaces that the program itself has turned.
//!
//! In: the motions of a program whose blank is inferred, and its tools. Out: the rapids whose tip enters such
//! material. Only outside tools are checked, because the surfaces of bores and drilled holes are less
//! certain. After a stop, a part-off or a cut of an unknown tool, no material is certain. Must not know
//! messages.

use super::choice::TO_AXIS;
use super::danger::{Danger, Finding};
use super::evidence::Evidence;
use super::resolved_setup::{Basis, ResolvedSetup, ResolvedTool};
use super::tip_place::{Route, TipPlace};
use crate::geometry::{Point, SAME};
use crate::limits::INFERRED_FROM;
use crate::motion::{Cycle, Motion, MotionKind, Motions, StopKind};
use crate::setup::{Side, Stock, ToolKind};

/// Number of places along Z into which the blank is divided.
const PLACES: usize = 1000;

/// Most places that are checked in total; beyond, there are no more findings.
const MAX_WORK: usize = 20_000_000;

/// Least depth of the tip below a surface and beyond a wall to be reported, mm: more than a nose radius
/// leaves.
const DEEP: f64 = 0.5;

/// Depth below a surface to which material is certain, mm: deeper, the workpiece may be hollow.
const THICK: f64 = 5.0;

/// Length on the chuck side of the last wall over which material is certain, mm.
const BEHIND: f64 = 5.0;

/// A cut at most this far below the outside of the inferred blank, mm, may be in the air.
const SKIN: f64 = 0.5;

/// Width that a plunging tool clears beside its tip at most, mm: the programmed corner is unknown.
const WIDEST: f64 = 6.0;

/// The rapids into turned material, in order. Empty if the blank is given: the detector finds them then.
pub fn rapids_into_material(motions: &Motions, resolved: &ResolvedSetup) -> Vec<Finding> {
    let Some((stock, Basis::Inferred)) = resolved.stock() else { return Vec::new() };
    if !resolved.unknown().is_empty() || Evidence::of(motions, None).is_mirrored() {
        return Vec::new();
    }
    let stops = motions.stops(0..motions.len()).filter(|(_, stop)| stop.kind == StopKind::Always);
    let mut stops = stops.map(|(index, _)| index).peekable();
    let mut material = TurnedMaterial::new(stock);
    let mut found = Vec::new();
    let moves = motions.on_workpiece().take(INFERRED_FROM).map(Motion::on_positive_side);
    for (index, motion) in moves.enumerate() {
        while stops.next_if(|&stop| stop <= index).is_some() {
            material.mark_unknown();
        }
        if motion.kind == MotionKind::Dwell {
            continue;
        }
        if let Some(at) = material.next(&motion, resolved.tool(&motion)) {
            found.push(Finding { motion: index, at, danger: Danger::RapidThroughStock });
            // Later findings would be consequences of this one.
            material.mark_unknown();
        }
    }
    found
}

/// The remaining material under the turned surfaces.
#[derive(Clone, Debug)]
struct TurnedMaterial {
    stock: Stock,
    /// Smallest radius of the cuts at each place, mm, from the back on; infinite if there is none.
    turned: Vec<f64>,
    /// Radius at half the height of a wall with material on its −Z side, mm; 0 without a wall. The tool may
    /// have left the workpiece along the upper half.
    walls: Vec<f64>,
    /// Radius up to which material is certain; computed again after a cut.
    certain: Option<Vec<f64>>,
    /// Whether the motion before is a cut along the workpiece.
    follows_cut: bool,
    tip: TipPlace,
    work: usize,
}

impl TurnedMaterial {
    fn new(stock: Stock) -> Self {
        Self {
            stock,
            turned: vec![f64::INFINITY; PLACES],
            walls: vec![0.0; PLACES],
            certain: None,
            follows_cut: false,
            tip: TipPlace::default(),
            work: 0,
        }
    }

    /// From here on no material is certain.
    fn mark_unknown(&mut self) {
        self.turned.fill(f64::INFINITY);
        self.walls.fill(0.0);
        self.certain = None;
    }

    /// Adds the next motion. Returns the first point where a rapid meets certain material.
    fn next(&mut self, motion: &Motion, tool: &ResolvedTool) -> Option<Point> {
        let follows_cut = std::mem::take(&mut self.follows_cut);
        let route = self.tip.follow(motion, self.is_near(motion.from));
        if !motion.process.removes_material() || motion.process.incomplete {
            if motion.kind.cuts() {
                self.mark_unknown();
            }
            return None;
        }
        let is_turning = matches!(tool.tool.kind, Some(ToolKind::Turning | ToolKind::Grooving));
        let is_outside = is_turning && tool.tool.working_side() == Side::Outside && !tool.is_live_in(motion);
        if self.work >= MAX_WORK {
            return None;
        }
        if motion.kind.cuts() {
            self.cut(motion, is_outside, follows_cut);
            return None;
        }
        let is_looked_at = is_outside && motion.cycle.is_none() && route != Route::Unknown;
        is_looked_at.then(|| self.meets(motion, route == Route::EndKnown)).flatten()
    }

    fn is_near(&self, at: Point) -> bool {
        at.x < self.stock.diameter.radius() + 1.0 && at.z < self.stock.face + 1.0
    }

    /// Length of a place, mm.
    fn step(&self) -> f64 {
        self.stock.length / PLACES as f64
    }

    /// The places within an interval of Z.
    fn places(&self, low: f64, high: f64) -> std::ops::Range<usize> {
        let at = |z: f64| ((z - self.stock.back()) / self.step()).clamp(0.0, PLACES as f64);
        let (first, last) = ((at(low) - SAME).ceil() as usize, (at(high) + SAME).floor() as usize);
        first..last.max(first)
    }

    fn cut(&mut self, motion: &Motion, is_outside: bool, follows_cut: bool) {
        let (from, to) = (motion.from, motion.to);
        let (low, high) = (from.z.min(to.z), from.z.max(to.z));
        if high - low <= SAME {
            self.cut_across(motion, is_outside, follows_cut);
            return;
        }
        if !is_outside || motion.kind == MotionKind::Thread {
            return;
        }
        self.follows_cut = low < self.stock.face - SAME;
        let (places, step) = (self.places(low, high), self.step());
        self.work += places.len();
        self.certain = None;
        let (back, outside) = (self.stock.back(), self.stock.diameter.radius() - SKIN);
        for place in places {
            let z = back + place as f64 * step;
            let x = radius_at(motion, z).min(radius_at(motion, z + step));
            if x <= outside {
                self.turned[place] = self.turned[place].min(x);
            }
        }
    }

    /// Adds a cut straight across the axis: a part-off, a wall, or a groove.
    fn cut_across(&mut self, motion: &Motion, is_outside: bool, follows_cut: bool) {
        let (from, to) = (motion.from, motion.to);
        let least = from.x.min(to.x);
        if least <= TO_AXIS {
            for place in self.places(to.z - WIDEST, self.stock.face) {
                (self.turned[place], self.walls[place]) = (f64::INFINITY, 0.0);
            }
        } else if is_outside && to.x > from.x {
            // The first passes of G73 may be in the air.
            let is_pattern = motion.cycle.is_some_and(|step| step.cycle == Cycle::Pattern);
            if !follows_cut || is_pattern {
                return;
            }
            let half = (from.x + to.x.min(self.stock.diameter.radius())) / 2.0;
            if let Some(place) = self.places(to.z - BEHIND, to.z).last() {
                let wall = &mut self.walls[place];
                *wall = if *wall > 0.0 { wall.min(half) } else { half };
            }
        } else if is_outside && to.x < from.x {
            let places = self.places(to.z - WIDEST, to.z + WIDEST);
            self.work += places.len();
            for place in places {
                self.turned[place] = self.turned[place].min(least);
            }
        }
        self.certain = None;
    }

    /// The first point where the tip of a rapid is within certain material. With `only_end`, the start is
    /// unknown.
    fn meets(&mut self, motion: &Motion, only_end: bool) -> Option<Point> {
        let (from, to) = (motion.from, motion.to);
        let (low, high) = (from.z.min(to.z), from.z.max(to.z));
        if from.x.min(to.x) >= self.stock.diameter.radius() || low >= self.stock.face {
            return None;
        }
        if self.certain.is_none() {
            self.work += PLACES;
            self.certain = Some(self.certain_radii());
        }
        let certain = self.certain.as_ref()?;
        let is_within = |at: Point, place: usize| {
            certain.get(place).is_some_and(|&radius| (radius - THICK..radius).contains(&at.x))
        };
        let place_of = |z: f64| ((z - self.stock.back()) / self.step()).max(0.0) as usize;
        if only_end {
            return is_within(to, place_of(to.z)).then_some(to);
        }
        // The rapid begins within the material, so the estimate is wrong.
        if is_within(from, place_of(from.z)) {
            return None;
        }
        if high - low <= self.step() {
            let radius = *certain.get(place_of(to.z))?;
            let goes_in = radius > 0.0 && from.x >= radius && to.x < radius;
            return goes_in.then(|| Point::new(radius, to.z));
        }
        let (places, step, back) = (self.places(low, high), self.step(), self.stock.back());
        self.work += places.len();
        let at = |place: usize| {
            let z = back + (place as f64 + 0.5) * step;
            Point::new(from.x + (z - from.z) / (to.z - from.z) * (to.x - from.x), z)
        };
        let hit = |&place: &usize| is_within(at(place), place);
        let place = if to.z < from.z { places.rev().find(hit) } else { places.into_iter().find(hit) };
        place.map(at)
    }

    /// The radius up to which material is certain at each place: the turned radius, and between two turned
    /// stretches the lower one, or the middle of the wall where the front one ends.
    fn certain_radii(&self) -> Vec<f64> {
        let mut radii = vec![0.0; PLACES];
        // Radius of the next turned place towards −Z.
        let mut behind = vec![0.0; PLACES];
        let mut last = 0.0;
        for (own, &turned) in behind.iter_mut().zip(&self.turned) {
            *own = last;
            if turned.is_finite() {
                last = turned;
            }
        }
        let (mut front, mut wall, mut length) = (0.0, 0.0, 0.0);
        for place in (0..PLACES).rev() {
            if self.turned[place].is_finite() {
                (front, wall, length) = (self.turned[place], 0.0, 0.0);
                radii[place] = front;
                continue;
            }
            wall = f64::max(wall, self.walls[place]);
            length += self.step();
            radii[place] = match wall > 0.0 {
                true if behind[place] > 0.0 || length <= BEHIND => wall,
                true => 0.0,
                false => f64::min(front, behind[place]),
            };
        }
        // A nose radius leaves material beside a wall.
        let reach = (DEEP / self.step()).ceil() as usize;
        let lowest = lowest_within(&radii, reach);
        lowest.into_iter().map(|radius| radius - DEEP).collect()
    }
}

/// For each place, the least value among itself and `reach` neighbours on both sides. The window is doubled
/// until it has its width.
fn lowest_within(values: &[f64], reach: usize) -> Vec<f64> {
    let at = |list: &[f64], place: usize| list.get(place).copied().unwrap_or(f64::INFINITY);
    let reach = reach.min(values.len());
    // Least value of the window that begins at each place, including places in front of the first value.
    let mut lows: Vec<f64> =
        std::iter::repeat_n(f64::INFINITY, reach).chain(values.iter().copied()).collect();
    let (whole, mut width) = (2 * reach + 1, 1);
    while 2 * width <= whole {
        lows = (0..lows.len()).map(|place| at(&lows, place).min(at(&lows, place + width))).collect();
        width *= 2;
    }
    (0..values.len()).map(|place| at(&lows, place).min(at(&lows, place + whole - width))).collect()
}

/// The radius at `z` of a cut along Z, mm.
fn radius_at(motion: &Motion, z: f64) -> f64 {
    let (from, to) = (motion.from, motion.to);
    let Some(arc) = motion.arc() else {
        return from.x + (z - from.z) / (to.z - from.z) * (to.x - from.x);
    };
    let aside = (arc.radius().powi(2) - (z - arc.center.z).powi(2)).max(0.0).sqrt();
    let (least, greatest) = (from.x.min(to.x), from.x.max(to.x));
    if least >= arc.center.x - SAME {
        arc.center.x + aside
    } else if greatest <= arc.center.x + SAME {
        arc.center.x - aside
    } else {
        least.min(arc.center.x - arc.radius())
    }
}

#[cfg(test)]
mod tests {
    use super::lowest_within;

    #[test]
    fn the_least_value_near_each_place() {
        let values = [5.0, 3.0, 4.0, 9.0, 8.0, 7.0, 6.0];
        assert_eq!(lowest_within(&values, 0), values);
        assert_eq!(lowest_within(&values, 1), [3.0, 3.0, 3.0, 4.0, 7.0, 6.0, 6.0]);
        assert_eq!(lowest_within(&values, 2), [3.0, 3.0, 3.0, 3.0, 4.0, 6.0, 6.0]);
        assert_eq!(lowest_within(&values, 100), [3.0; 7]);
    }
}
