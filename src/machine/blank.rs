//! Infers the blank from the cuts of a program.
//!
//! In: how far the cuts of each tool reach, and the kind of each tool. Out: a [`Stock`] that shows the cuts:
//! a wall around a bore, material on both sides of a groove, the bar left by parting off. Must not know how
//! tools are inferred.

use super::evidence::Evidence;
use super::tool::BLADE;
use crate::cycles::drilling::OFF_CENTER;
use crate::geometry::{Point, SAME};
use crate::motion::{Cycle, Motion, MotionKind, Step};
use crate::setup::{Side, Stock, Tool, ToolKind};
use crate::units::Diameter;

/// Smallest radius of a bore, mm.
pub(super) const ON_AXIS: f64 = 0.5;

/// Wall around a bore if no cut turns the outside: as a multiple of the bore's radius, and its minimum in mm.
const WALL: (f64, f64) = (0.25, 5.0);

/// Material beside a groove that nothing else cuts, mm: its flank, without which it would not look like a
/// groove.
const FLANK: f64 = 5.0;

/// Material beyond the deepest cut, mm: the bar behind a part-off, the bottom below a drilled hole.
const BEHIND: f64 = 5.0;

/// Depth of the first pass of a thread below its crest, as a share of the lead.
const FIRST_PASS: f64 = 0.2;

/// The first pass does not get deeper with leads above this, mm.
const COARSEST: f64 = 5.0;

/// Radius of a blank that is only drilled, mm.
const DRILLED: f64 = 15.0;

/// Largest size that a setup accepts, mm. A program that needs more has a typing error.
const MAX_SIZE: f64 = 5000.0;

/// The blank is smaller than the rapids along its outside by this much on every side, mm: a start point is
/// clear of the bar.
const CLEAR: f64 = 1.0;

/// Shrinks a blank if rapids would run along its outside: between grooves, and past an area that is faced
/// later, tools move at the diameter of the start point.
///
/// The diameter is never smaller than that of the widest cut along Z.
pub fn clear_of_rapids(stock: Stock, evidence: &Evidence) -> Stock {
    let radius = stock.diameter.radius();
    let turns = |motion: &Motion| {
        let along = (motion.from.z - motion.to.z).abs() > SAME && motion.from.z.min(motion.to.z) < -SAME;
        along && motion.kind.cuts() && motion.process.removes_material()
    };
    let turned = || {
        let turned = evidence.moves().filter(turns).map(|motion| motion.from.x.min(motion.to.x));
        turned.filter(|&turned| turned < radius - SAME).fold(0.0, f64::max)
    };
    let on = |at: Point| (at.x - radius).abs() <= SAME;
    // Z down to which cuts along Z have gone below the outside.
    let mut cut = stock.face;
    for motion in evidence.moves() {
        let (from, to) = (motion.from, motion.to);
        let low = from.z.min(to.z).max(stock.back());
        let along = (from.z - to.z).abs() > SAME;
        if motion.process.other_setup || motion.process.uncertain {
            continue;
        }
        if motion.kind == MotionKind::Rapid && on(from) && on(to) && along && low < cut - SAME {
            let diameter = Diameter::from_radius((radius - CLEAR).max(turned()));
            return if diameter > stock.bore { Stock { diameter, ..stock } } else { stock };
        }
        if motion.kind.cuts() && motion.process.removes_material() && along {
            cut = cut.min(low);
        }
    }
    stock
}

/// Enlarges the blank if the tool came to the first cut along Z from outside, so that this cut removes
/// material.
pub fn larger_than_first_pass(stock: Stock, evidence: &Evidence) -> Stock {
    let radius = stock.diameter.radius();
    let mut before = None;
    for motion in evidence.moves() {
        let (from, to) = (motion.from, motion.to);
        let is_turned =
            motion.kind.cuts() && motion.process.removes_material() && from.x.max(to.x) > OFF_CENTER;
        if is_turned && from.z - to.z > SAME && to.z < stock.face - SAME {
            let is_outside = from.x.min(to.x) >= radius - SAME && motion.kind != MotionKind::Thread;
            let infeed =
                before.filter(|infeed: &Motion| is_outside && infeed.to == from && from.z >= stock.face);
            let outside = infeed
                .filter(|infeed| (infeed.from.z - from.z).abs() <= SAME)
                .map_or(0.0, |infeed| infeed.from.x);
            let larger = (radius + CLEAR).min((radius + outside) / 2.0);
            return Stock { diameter: Diameter::from_radius(larger.max(radius)), ..stock };
        }
        before = Some(motion);
    }
    stock
}

/// Makes the bore of a tube smaller than the cut that makes it, if after that cut the tool goes further in
/// and comes back through the bore. So the end of the cut is visible.
pub fn smaller_than_bored(stock: Stock, evidence: &Evidence) -> Stock {
    let bored = stock.bore.radius();
    let mut at_end = false;
    for motion in evidence.moves() {
        let (from, to) = (motion.from, motion.to);
        if at_end && motion.kind == MotionKind::Rapid && to.x < bored - SAME {
            let bore = ((bored + to.x) / 2.0).max(bored - CLEAR).max(0.0);
            return Stock { bore: Diameter::from_radius(bore), ..stock };
        }
        let is_straight = (from.x - bored).abs().max((to.x - bored).abs()) <= SAME;
        at_end = is_straight && motion.kind.cuts() && motion.process.removes_material() && to.z < -SAME;
    }
    stock
}

/// How far cuts reach, mm.
#[derive(Clone, Copy, Debug)]
struct Reach {
    /// Greatest radius at negative Z, and anywhere.
    behind: f64,
    radius: f64,
    /// Smallest radius.
    least: f64,
    low: f64,
    high: f64,
    /// Greatest Z of cuts across the face and of roundings that begin on the axis.
    faced: f64,
    /// Smallest radius of cuts at negative Z, without threads and faces that are cut to the axis.
    turned: f64,
    /// Greatest radius from which a feed move starts inwards across the axis.
    approach: f64,
}

impl Default for Reach {
    fn default() -> Self {
        Self {
            behind: 0.0,
            radius: 0.0,
            least: f64::INFINITY,
            low: f64::INFINITY,
            high: f64::NEG_INFINITY,
            faced: f64::NEG_INFINITY,
            turned: f64::INFINITY,
            approach: 0.0,
        }
    }
}

impl Reach {
    fn add(&mut self, motion: &Motion) {
        let (from, to) = (motion.from, motion.to);
        let step = motion.cycle.map(|step| (step.cycle, step.step));
        self.low = self.low.min(from.z.min(to.z));
        self.high = self.high.max(from.z.max(to.z));
        if (from.z - to.z).abs() <= SAME && from.x.min(to.x) <= 1.0 && (from.x - to.x).abs() > 1.0 {
            self.faced = self.faced.max(to.z);
        }
        if motion.center.is_some() && from.x.abs() <= SAME && to.z < from.z {
            self.faced = self.faced.max(from.z);
        }
        let (along, goes_in) = ((from.z - to.z).abs() > SAME, to.x < from.x - SAME);
        let is_face = !along && from.x.min(to.x) <= 1.0;
        if from.z.min(to.z) < -SAME && motion.kind != MotionKind::Thread && !is_face {
            self.turned = self.turned.min(from.x.min(to.x));
        }
        if !along && goes_in {
            self.approach = self.approach.max(from.x);
        }
        // While it pulls out of the thread, the tool is in the air.
        if let Some((_, Step::PullOut)) = step {
            return;
        }
        // A tap on the axis has no crest.
        let is_turned = motion.kind == MotionKind::Thread && from.x.max(to.x) > SAME;
        let crest = match motion.lead.filter(|_| is_turned) {
            Some(lead) => FIRST_PASS * lead.min(COARSEST),
            None => 0.0,
        };
        self.least = self.least.min(from.x.min(to.x) - crest);
        let greatest = |from: Point, to: Point| from.x.max(to.x) + crest;
        self.radius = self.radius.max(greatest(from, to));
        // Cuts in front of the face do not show the size of the blank.
        let cross = |from: Point, to: Point| {
            let x = from.x + from.z / (from.z - to.z) * (to.x - from.x);
            // Bars have diameters in whole millimetres.
            let bar = Diameter::new((Diameter::from_radius(x).mm() - SAME).ceil());
            Point::new(bar.radius().min(from.x.max(to.x)), 0.0)
        };
        self.behind = match (from.z <= SAME, to.z <= SAME) {
            (true, true) => self.behind.max(greatest(from, to)),
            (true, false) => self.behind.max(greatest(from, cross(from, to))),
            (false, true) => self.behind.max(greatest(cross(from, to), to)),
            (false, false) => self.behind,
        };
    }

    fn is_empty(&self) -> bool {
        self.low > self.high
    }

    fn join(&mut self, other: &Self) {
        self.behind = self.behind.max(other.behind);
        self.radius = self.radius.max(other.radius);
        self.least = self.least.min(other.least);
        self.low = self.low.min(other.low);
        self.high = self.high.max(other.high);
        self.faced = self.faced.max(other.faced);
        self.turned = self.turned.min(other.turned);
        self.approach = self.approach.max(other.approach);
    }
}

/// How far the cuts of a tool reach.
#[derive(Clone, Copy, Debug, Default)]
pub struct Extents {
    /// Cuts outside of the current G73.
    cuts: Reach,
    /// The latest pass of G73. Earlier passes reach beyond the blank.
    pattern: Reach,
    pass: u32,
}

impl Extents {
    /// Adds a cut.
    pub fn add(&mut self, motion: &Motion) {
        let Some(step) = motion.cycle.filter(|step| step.cycle == Cycle::Pattern) else {
            self.cuts.add(motion);
            return;
        };
        match step.pass {
            pass if pass < self.pass => self.cuts = self.all(),
            // The first pass of G73 touches the blank where the contour is deepest.
            pass if pass > self.pass && self.pass == 1 => {
                let touched = self.pattern.least;
                self.cuts.radius = self.cuts.radius.max(touched);
                self.cuts.behind = self.cuts.behind.max(touched);
            }
            _ => {}
        }
        if step.pass != self.pass {
            (self.pass, self.pattern) = (step.pass, Reach::default());
        }
        self.pattern.add(motion);
    }

    fn all(&self) -> Reach {
        let mut all = self.cuts;
        all.join(&self.pattern);
        all
    }

    /// Smallest radius, mm; infinite if there are no cuts.
    pub fn least(&self) -> f64 {
        self.all().least
    }

    /// Greatest radius at negative Z, mm.
    pub fn behind(&self) -> f64 {
        self.all().behind
    }
}

/// The cuts by kind of tool.
#[derive(Clone, Copy, Debug, Default)]
pub struct Cuts {
    /// Turning, threading and facing.
    outside: Reach,
    /// Boring, and grooves and threads inside.
    inside: Reach,
    /// Grooves in the outside and part-offs. Their points are the left corner of the grooving insert, its
    /// tip.
    grooves: Reach,
    /// Grooves in the end face. The tip is the inner corner.
    face_grooves: Reach,
    /// Holes on the spindle axis, or a little off it.
    holes: Reach,
    /// Whether there is milling, which shows nothing of the blank.
    is_milled: bool,
}

/// Z of the first cut if that is a full face at negative Z: the blank has nothing in front of it. `is_blade`
/// tells whether the tool of a cut is a grooving tool, which parts off.
pub fn first_face(evidence: &Evidence, is_blade: impl Fn(&Motion) -> bool) -> Option<f64> {
    let mut cuts = evidence.moves();
    let first = cuts.find(|motion| motion.kind.cuts() && motion.process.removes_material())?;
    let is_face = (first.to.z - first.from.z).abs() <= SAME && first.to.x <= 1.0 && first.from.x > 1.0;
    (is_face && first.to.z < -SAME && !is_blade(&first)).then_some(first.to.z)
}

impl Cuts {
    /// Adds the cuts of a tool.
    pub fn add(&mut self, extents: &Extents, tool: &Tool) {
        let side = tool.working_side();
        let mut all = extents.all();
        let cuts = match (tool.kind.unwrap_or(ToolKind::Turning), side) {
            // A live tool leaves the profile unchanged.
            (ToolKind::Endmill, _) => {
                self.is_milled = true;
                return;
            }
            (ToolKind::Drill | ToolKind::Tap, _) => {
                // An indexable drill that is set a little off the axis shows no more of the bar than one on
                // the axis.
                if all.radius <= OFF_CENTER {
                    (all.radius, all.behind) = (0.0, 0.0);
                }
                &mut self.holes
            }
            (ToolKind::Boring, _) | (ToolKind::Grooving | ToolKind::Threading, Side::Inside) => {
                &mut self.inside
            }
            (ToolKind::Grooving, Side::Face) => &mut self.face_grooves,
            (ToolKind::Grooving, Side::Outside) => &mut self.grooves,
            (ToolKind::Turning, _) | (ToolKind::Threading, _) => &mut self.outside,
        };
        cuts.join(&all);
    }

    /// A blank that shows the cuts: a bar, or a tube if there is only boring. `None` without cuts.
    pub fn blank(&self, first_face: Option<f64>) -> Option<Stock> {
        let mut across = self.outside;
        across.join(&self.grooves);
        across.join(&self.holes);
        let mut all = across;
        all.join(&self.face_grooves);
        all.join(&self.inside);
        if all.is_empty() {
            return None;
        }
        let behind = all.low < -SAME;
        let face = self.face(&all, behind, first_face);
        let reach = |of: &Reach| if behind { of.behind } else { of.radius };
        let (around, bored) = (reach(&across), reach(&self.inside));
        let walled = if bored > SAME { bored + (WALL.0 * bored).max(WALL.1) } else { 0.0 };
        let radius = match around {
            around if around > bored + 1.0 => around,
            around if walled > around => (2.0 * walled / 5.0).ceil() * 2.5,
            around if around > SAME => around,
            _ if self.face_grooves.is_empty() => DRILLED,
            _ => 0.0,
        };
        // A bar of the diameter of its only pass would lose nothing. Before the pass, the tool was at the
        // outside of the bar or came at rapid.
        let Reach { turned, approach, .. } = self.outside;
        let others = !self.grooves.is_empty() || self.is_milled;
        let is_one_pass = turned.is_finite() && turned >= radius - SAME && !others;
        let outside = if approach > radius + SAME { approach - CLEAR } else { radius + CLEAR };
        let radius = if is_one_pass { outside.max((approach + radius) / 2.0) } else { radius };
        // The outermost groove in the face needs an outer wall.
        let ringed = self.face_grooves.radius + BLADE;
        let radius = if self.face_grooves.is_empty() || radius > ringed { radius } else { ringed + FLANK };
        let diameter = Diameter::from_radius(radius);
        // A tool that begins at the axis makes its own hole.
        let is_tube = (ON_AXIS..f64::INFINITY).contains(&self.inside.least) && self.holes.is_empty();
        let bore = if is_tube { self.inside.least } else { 0.0 };
        let bore = Diameter::from_radius(if bore < radius { bore.max(0.0) } else { 0.0 });
        // A fifth longer than the cuts reach, and not shorter than the radius.
        let depth = face - all.low.min(0.0);
        let blade = if self.grooves.low <= all.low + SAME { BLADE } else { 0.0 };
        let length = (1.2 * depth).max(depth + blade + BEHIND).max(radius);
        let length = (length / 5.0).ceil() * 5.0;
        let fits = diameter.mm() <= MAX_SIZE && length <= MAX_SIZE && face.abs() <= MAX_SIZE;
        fits.then_some(Stock { diameter, bore, face, length, grip: None })
    }

    /// Z of the front face. Z0 is the finished face if there are cuts behind it, otherwise the back of the
    /// part.
    fn face(&self, all: &Reach, behind: bool, first_face: Option<f64>) -> f64 {
        // Longest piece that a first facing cut takes off, mm.
        const FACED_OFF: f64 = 3.0;
        if first_face.is_some_and(|face| all.high <= face + FACED_OFF) {
            return all.high;
        }
        let face = if behind { 0.0 } else { all.high }.max(all.faced);
        let Reach { high, faced, .. } = self.grooves;
        let right = high + BLADE;
        // A grooving insert that goes to the axis in front of all its grooves faces the part.
        let only_grooves = self.outside.is_empty() && self.holes.is_empty() && faced < high - SAME;
        // Without material on both sides a groove would look like a shoulder.
        if only_grooves && right > face + SAME { (right + FLANK).ceil() } else { face }
    }
}
