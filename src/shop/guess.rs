//! What a program lets one guess of the tools and the blank that nobody has named.
//!
//! In: the motions. Out: a [`Tool`] for each use a station is put to, and a [`Stock`]. A guess is sharp, and can follow every
//! slope it is led along; it is shown as a guess, and no alarm is raised because of one.

use crate::control::setup::{Side, Stock, Tool, ToolKind};
use crate::geometry::SAME;
use crate::motion::{Cycle, Motion, MotionKind, Motions};

/// So many motions are looked at.
const LOOKED_AT: usize = 200_000;

/// What a motion does, as far as it decides about the tool.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Use {
    /// Turns, faces, bores.
    Turning,
    /// Cuts a thread.
    Threading,
    /// Plunges.
    Grooving,
    /// Drills or taps on the axis.
    Hole,
    /// The tool turns, not the work.
    Live,
}

impl Use {
    /// That of a motion.
    pub fn of(motion: &Motion) -> Self {
        let on_axis = motion.from.x.abs() <= 0.01 && motion.to.x.abs() <= 0.01;
        let along = (motion.to.z - motion.from.z).abs() > SAME;
        match motion.cycle.map(|step| step.cycle) {
            _ if motion.rotary.is_some() => Self::Live,
            Some(Cycle::SideDrilling | Cycle::SideTapping | Cycle::SideBoring) => Self::Live,
            _ if on_axis && along && motion.kind.cuts() => Self::Hole,
            Some(Cycle::Threading | Cycle::MultiThreading) => Self::Threading,
            _ if motion.kind == MotionKind::Thread => Self::Threading,
            Some(Cycle::Grooving | Cycle::FacePecking) => Self::Grooving,
            _ => Self::Turning,
        }
    }
}

/// What is seen of one use of a station.
#[derive(Clone, Copy, Debug)]
struct Seen {
    station: u16,
    purpose: Use,
    /// Cuts along Z that the tool leaves outwards, less those it leaves inwards.
    outside: i32,
    /// Plunges that come back the way they went, and other cuts.
    plunges: u32,
    cuts: u32,
    /// Steepest way into the work behind the tip, radians from the spindle axis: outside and inside.
    slopes: [f64; 2],
    /// Whether it taps: on the axis, locked to the spindle.
    taps: bool,
    /// Whether grooves are in the end face.
    face: bool,
    /// Least radius of its cuts, mm.
    low: f64,
}

/// The guesses for a program.
#[derive(Clone, Debug, Default)]
pub struct Guesses {
    tools: Vec<(u16, Use, Tool)>,
    /// The blank; nothing where nothing cuts.
    pub stock: Option<Stock>,
}

impl Guesses {
    /// Looks at a program.
    pub fn of(motions: &Motions) -> Self {
        let mut seen: Vec<Seen> = Vec::new();
        let mut extents = Extents::default();
        let mut all = motions.iter().take(LOOKED_AT).peekable();
        while let Some(motion) = all.next() {
            if !motion.kind.cuts() || motion.process.uncertain {
                continue;
            }
            let (station, purpose) = (motion.process.tool.0, Use::of(&motion));
            let at = seen
                .iter()
                .position(|own| (own.station, own.purpose) == (station, purpose))
                .unwrap_or_else(|| {
                    seen.push(Seen::new(station, purpose));
                    seen.len() - 1
                });
            seen[at].look(&motion, all.peek());
            if purpose != Use::Live {
                extents.add(&motion);
            }
        }
        // What a drill leaves is where boring begins.
        let bored =
            seen.iter().filter(|own| own.purpose == Use::Turning && own.outside < 0).map(|own| own.low);
        let bore = bored.fold(f64::INFINITY, f64::min);
        let drilled = seen.iter().any(|own| own.purpose == Use::Hole);
        let tools = seen.iter().map(|own| (own.station, own.purpose, own.tool(bore))).collect();
        let hollow = if bore.is_finite() && !drilled { 2.0 * bore } else { 0.0 };
        Self { tools, stock: extents.stock(hollow) }
    }

    /// All tools: station, use and tool, in the order in which they are first put to use.
    pub fn tools(&self) -> impl Iterator<Item = (u16, Use, &Tool)> {
        self.tools.iter().map(|(station, purpose, tool)| (*station, *purpose, tool))
    }
}

impl Seen {
    fn new(station: u16, purpose: Use) -> Self {
        Self {
            station,
            purpose,
            outside: 0,
            plunges: 0,
            cuts: 0,
            slopes: [0.0; 2],
            taps: false,
            face: false,
            low: f64::INFINITY,
        }
    }

    fn look(&mut self, motion: &Motion, next: Option<&Motion>) {
        let (dx, dz) = (motion.to.x - motion.from.x, motion.to.z - motion.from.z);
        self.cuts += 1;
        self.low = self.low.min(motion.from.x.min(motion.to.x));
        self.taps |= motion.kind == MotionKind::Thread;
        if let Some(next) = next {
            let (after_x, after_z) = (next.to.x - next.from.x, next.to.z - next.from.z);
            if dz < -SAME && after_x.abs() > SAME {
                self.outside += if after_x > 0.0 { 1 } else { -1 };
            }
            let back = after_z.abs() <= SAME && after_x * dx < 0.0 && after_x.abs() >= dx.abs() - SAME;
            self.plunges += u32::from(dz.abs() <= SAME && back);
        }
        if motion.cycle.is_some_and(|step| step.cycle == Cycle::FacePecking) {
            self.face = true;
        }
        let [outside, inside] = &mut self.slopes;
        for (sx, slope) in [(1.0, outside), (-1.0, inside)] {
            // Only a slope that goes on along Z is a slope of the work; straight in is a plunge.
            for (dx, dz) in directions(motion) {
                if dz < -SAME && sx * dx < -SAME {
                    *slope = slope.max((sx * -dx).atan2(-dz));
                }
            }
        }
    }

    /// The tool that could do what was seen; `bore` is the radius at which boring begins.
    fn tool(&self, bore: f64) -> Tool {
        let inside = self.outside < 0;
        let side = if inside { Side::Inside } else { Side::Outside };
        match self.purpose {
            Use::Live => Tool { kind: Some(ToolKind::Endmill), ..Tool::default() },
            Use::Hole => {
                let kind = if self.taps { ToolKind::Tap } else { ToolKind::Drill };
                let diameter = if bore.is_finite() && bore > 0.0 { Some(2.0 * bore) } else { None };
                Tool { kind: Some(kind), diameter, ..Tool::default() }
            }
            Use::Threading => Tool { kind: Some(ToolKind::Threading), side: Some(side), ..Tool::default() },
            Use::Grooving => self.blade(if self.face { Side::Face } else { side }),
            Use::Turning if self.plunges > 0 && self.plunges == self.cuts => self.blade(Side::Outside),
            Use::Turning => {
                let kind = if inside { ToolKind::Boring } else { ToolKind::Turning };
                let slope = self.slopes[usize::from(inside)].to_degrees();
                // The usual roughing tool, or the bluntest that can follow.
                let (insert, entering) = match slope {
                    slope if slope < 4.5 => ("C", 95.0),
                    slope if slope < 31.5 => ("D", 93.0),
                    slope if slope < 51.5 => ("V", 93.0),
                    _ => {
                        let point = (88.0 - slope).max(1.0);
                        return Tool {
                            kind: Some(kind),
                            point_angle: Some(point),
                            entering_angle: Some(91.0),
                            ..Tool::default()
                        };
                    }
                };
                Tool {
                    kind: Some(kind),
                    insert: Some(insert.into()),
                    entering_angle: Some(entering),
                    ..Tool::default()
                }
            }
        }
    }

    fn blade(&self, side: Side) -> Tool {
        Tool { kind: Some(ToolKind::Grooving), side: Some(side), ..Tool::default() }
    }
}

/// Directions a cut takes: one of a line, those at both ends and the middle of an arc.
fn directions(motion: &Motion) -> Vec<(f64, f64)> {
    match motion.arc() {
        None => vec![(motion.to.x - motion.from.x, motion.to.z - motion.from.z)],
        Some(arc) => {
            let points: Vec<_> = (0..=8).map(|index| arc.at(f64::from(index) / 8.0)).collect();
            points.windows(2).map(|ends| (ends[1].x - ends[0].x, ends[1].z - ends[0].z)).collect()
        }
    }
}

/// How far the cuts reach, mm.
#[derive(Debug)]
struct Extents {
    radius: f64,
    low: f64,
    high: f64,
    /// Greatest Z of a cut across the face.
    faced: f64,
}

impl Default for Extents {
    fn default() -> Self {
        Self { radius: 0.0, low: f64::INFINITY, high: f64::NEG_INFINITY, faced: f64::NEG_INFINITY }
    }
}

impl Extents {
    fn add(&mut self, motion: &Motion) {
        let (from, to) = (motion.from, motion.to);
        self.radius = self.radius.max(from.x.max(to.x));
        self.low = self.low.min(from.z.min(to.z));
        self.high = self.high.max(from.z.max(to.z));
        if (from.z - to.z).abs() <= SAME && from.x.min(to.x) <= 1.0 && (from.x - to.x).abs() > 1.0 {
            self.faced = self.faced.max(to.z);
        }
    }

    /// A bar that all cuts are in, a fifth longer than they reach.
    fn stock(&self, bore: f64) -> Option<Stock> {
        if self.radius <= SAME || self.low >= self.high {
            return None;
        }
        // Zero is the finished face, or the back of the part.
        let zero = if self.low < -SAME { 0.0 } else { self.high };
        let face = zero.max(self.faced);
        let length = 1.2 * (face - self.low).max(1.0);
        let diameter = 2.0 * self.radius;
        let bore = if bore < diameter { bore.max(0.0) } else { 0.0 };
        Some(Stock { diameter, bore, face, length: (length / 5.0).ceil() * 5.0, grip: None })
    }
}
