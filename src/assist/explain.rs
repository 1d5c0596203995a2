//! Explains a block with computed numbers: start and end, depth, number of passes, time.
//!
//! In: the motions of a block, and the machine. Out: an [`Explanation`]: plain values, independent of the
//! language. Does not use the program text, so a stroke of the picture is explained in the same way.

use super::Query;
use super::fact::Quantity;
use super::place::{Place, as_programmed, is_clockwise, own_motions};
use crate::cycles::single::cuts_along_x;
use crate::geometry::virtual_plane::{VirtualMove, Way};
use crate::geometry::{Point, SAME};
use crate::motion::{Cycle, CycleFamily, CycleStep, Feed, Motion, MotionKind, Motions, Step};
use crate::playback::timing;
use crate::setup::Machine;
use crate::units::Diameter;

/// Maximum number of plain moves that are listed individually.
const MAX_LISTED: usize = 3;

/// One step of a block, with programmed positions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Action {
    /// A rapid, from and to.
    Rapid(Place, Place),
    /// A straight cut along one axis: from, to, length.
    Straight(Place, Place, Quantity),
    /// A straight cut along both axes: from, to, angle with Z.
    Taper(Place, Place, Quantity),
    /// An arc: end, radius, whether it is clockwise.
    Arc(Place, Quantity, bool),
    /// A thread cut, synchronised with the spindle: from, to, lead.
    Thread(Place, Place, Quantity),
    /// The tool waits.
    Dwell(Quantity),
    /// A rotation of C: its end.
    Turn(Quantity),
    /// A motion along Y: start and end.
    AlongY(Quantity, Quantity),
    /// Several moves: their number, start and end.
    Moves(u32, Place, Place),
    /// One pass of a single cycle: the cycle, its diameter or Z if it is not a taper, start and end.
    Pass(Cycle, Option<Quantity>, Place, Place),
    /// Several passes of a cycle.
    Passes {
        /// The cycle.
        cycle: Cycle,
        /// Number of passes.
        passes: u32,
        /// Depth of each pass; the last may differ.
        each: Quantity,
        /// Total depth.
        depth: Quantity,
        /// Position of the last pass: a diameter; for facing, Z.
        last: Quantity,
    },
    /// Passes of different depth, or along the contour: cycle, number, position of the last pass.
    PassesTo(Cycle, u32, Quantity),
    /// Passes parallel to the contour: cycle, number.
    Pattern(Cycle, u32),
    /// One finishing pass along the contour: its length.
    Contour(Quantity),
    /// Pecks of a cycle: cycle, number of pecks, number of columns, end position.
    Pecks(Cycle, u32, u32, Quantity),
    /// A hole: cycle, start, end, number of pecks.
    Hole(Cycle, Quantity, Quantity, u32),
}

/// Explanation of a block.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Explanation {
    /// The steps, in order.
    pub actions: Vec<Action>,
    /// The feed of its cuts that are not threads, if it is the same for all.
    pub feed: Option<Quantity>,
    /// Duration. `None` for a dwell, whose step contains it; if the time of a motion other than a rapid is
    /// unknown; and if nothing is cut and a rapid has no known speed.
    pub time: Option<Quantity>,
    /// Whether the time excludes rapids, because no rapid speed is given.
    pub without_rapids: bool,
}

impl Explanation {
    /// Explains the motions of one execution of a block.
    pub fn of(motions: &[Motion], machine: &Machine) -> Self {
        let moves = as_programmed(motions);
        let (Some(first), Some(last)) = (moves.first(), moves.last()) else { return Self::default() };
        let cycle = moves.iter().find_map(|motion| motion.cycle);
        let actions = match cycle {
            Some(step) => of_cycle(step.cycle, &moves, first.from),
            None if moves.len() > MAX_LISTED => {
                vec![Action::Moves(moves.len() as u32, place_of(first, 0.0), place_of(last, 1.0))]
            }
            None => moves.iter().flat_map(plain).collect(),
        };
        let (mut seconds, mut is_known, mut without_rapids) = (0.0, true, false);
        for motion in motions {
            match timing::seconds(motion, machine) {
                Some(duration) => seconds += duration,
                None if motion.kind == MotionKind::Rapid => without_rapids = true,
                None => is_known = false,
            }
        }
        let cuts = motions.iter().any(|motion| motion.kind.cuts());
        let is_dwell = matches!(actions[..], [Action::Dwell(_)]);
        let time = (is_known && !is_dwell && (cuts || !without_rapids))
            .then_some(Quantity::Seconds(rounded_seconds(seconds)));
        Self { actions, feed: feed_of_all(motions), time, without_rapids }
    }
}

impl Query<'_> {
    /// The explanation of the block. Empty if a cycle reads the block as a part of its contour: the cycle
    /// makes the moves.
    pub fn explanation(&self, motions: &Motions) -> Explanation {
        match self.visit {
            Some(visit) if visit.purpose.is_none() => {
                Explanation::of(&own_motions(motions, self.block.span, visit), &self.setup.machine)
            }
            _ => Explanation::default(),
        }
    }
}

/// Start (`t` = 0) or end (`t` = 1) of a motion.
fn place_of(motion: &Motion, t: f64) -> Place {
    match motion.virtual_move() {
        Some(virtual_move) => Place::on(&virtual_move, t),
        None => Place::turning(if t == 0.0 { motion.from } else { motion.to }),
    }
}

/// Steps of a plain move: first in the plane of the path, then along the other axes.
fn plain(motion: &Motion) -> Vec<Action> {
    let virtual_move = motion.virtual_move();
    let path = match &virtual_move {
        Some(virtual_move) => Some(in_virtual_plane(motion, virtual_move)),
        None if motion.is_turn() && motion.from.is_same(motion.to) => None,
        None => Some(in_plane(motion)),
    };
    let y = virtual_move
        .filter(VirtualMove::has_y)
        .map(|virtual_move| (virtual_move.y_at(0.0), virtual_move.y_at(1.0)));
    let along_y = y.filter(|(from, to)| from != to);
    let along_y = along_y.map(|(from, to)| Action::AlongY(Quantity::Length(from), Quantity::Length(to)));
    let turned = motion.rotary.filter(|rotary| rotary.from != rotary.to);
    let turn = turned.map(|rotary| Action::Turn(Quantity::Degrees(rotary.to)));
    [path, along_y, turn].into_iter().flatten().collect()
}

/// A move in the plane of G12.1 or G07.1, or on a machine with a Y axis.
fn in_virtual_plane(motion: &Motion, virtual_move: &VirtualMove) -> Action {
    let (from, to) = (Place::on(virtual_move, 0.0), Place::on(virtual_move, 1.0));
    match virtual_move.way {
        _ if motion.kind == MotionKind::Rapid => Action::Rapid(from, to),
        Way::Arc(arc) => {
            Action::Arc(to, Quantity::Length(arc.radius()), is_clockwise(motion, Some(virtual_move)))
        }
        Way::Line(..) => {
            let length = (virtual_move.length() * 100.0).round() / 100.0;
            Action::Straight(from, to, Quantity::Length(length))
        }
    }
}

fn in_plane(motion: &Motion) -> Action {
    let (from, to) = (Place::turning(motion.from), Place::turning(motion.to));
    match motion.kind {
        MotionKind::Rapid => Action::Rapid(from, to),
        MotionKind::Dwell => Action::Dwell(Quantity::Seconds(motion.seconds.unwrap_or_default())),
        MotionKind::Thread => {
            Action::Thread(from, to, Quantity::FeedPerTurn(motion.lead.unwrap_or_default()))
        }
        MotionKind::ArcClockwise | MotionKind::ArcCounterclockwise => {
            let radius = motion.center.map_or(0.0, |center| center.distance(motion.to));
            Action::Arc(to, Quantity::Length(radius), is_clockwise(motion, None))
        }
        MotionKind::Feed => {
            let (x, z) = ((motion.to.x - motion.from.x).abs(), (motion.to.z - motion.from.z).abs());
            if x > SAME && z > SAME {
                Action::Taper(from, to, Quantity::Degrees(x.atan2(z).to_degrees()))
            } else {
                Action::Straight(from, to, Quantity::Length(x.max(z)))
            }
        }
    }
}

fn of_cycle(cycle: Cycle, motions: &[Motion], start: Point) -> Vec<Action> {
    let with = |wanted: Step| {
        motions.iter().filter(move |motion| motion.cycle.is_some_and(|step| step.step == wanted))
    };
    let cuts: Vec<&Motion> = with(Step::Cut).filter(|motion| motion.kind.cuts()).collect();
    let contour = with(Step::Contour).filter(|motion| motion.kind.cuts());
    let length: f64 = contour.map(Motion::length).sum();
    let along = Action::Contour(Quantity::Length((length * 100.0).round() / 100.0));
    let has_contour = along != Action::Contour(Quantity::Length(0.0));
    let passes = number_of_passes(motions);
    let Some(last) = cuts.last() else {
        return match cycle {
            Cycle::Pattern => vec![Action::Pattern(cycle, passes)],
            _ if has_contour => vec![along],
            _ => vec![Action::Moves(
                motions.len() as u32,
                Place::turning(start),
                Place::turning(motions[motions.len() - 1].to),
            )],
        };
    };
    let facing = cuts_along_x(cycle);
    let at = |point: Point| {
        if facing { Quantity::Length(point.z) } else { Quantity::Diameter(Diameter::from_radius(point.x)) }
    };
    match cycle.family() {
        CycleFamily::Turning | CycleFamily::Threading if passes == 1 => {
            let is_taper = if facing { last.from.z != last.to.z } else { last.from.x != last.to.x };
            let at = (!is_taper).then(|| at(last.from));
            vec![Action::Pass(cycle, at, Place::turning(last.from), Place::turning(last.to))]
        }
        CycleFamily::Threading => vec![Action::PassesTo(cycle, passes, at(last.to))],
        CycleFamily::Pecking => {
            let columns = 1 + with(Step::Stepover).count() as u32;
            let to = match cycle {
                Cycle::Grooving => Quantity::Diameter(Diameter::from_radius(last.to.x)),
                _ => Quantity::Length(last.to.z),
            };
            vec![Action::Pecks(cycle, cuts.len() as u32, columns, to)]
        }
        CycleFamily::FaceHole => vec![Action::Hole(
            cycle,
            Quantity::Length(cuts[0].from.z),
            Quantity::Length(last.to.z),
            cuts.len() as u32,
        )],
        CycleFamily::SideHole => vec![Action::Hole(
            cycle,
            Quantity::Diameter(Diameter::from_radius(cuts[0].from.x)),
            Quantity::Diameter(Diameter::from_radius(last.to.x)),
            cuts.len() as u32,
        )],
        CycleFamily::Turning | CycleFamily::Contour => {
            let across = |point: Point| if facing { point.z } else { point.x };
            let mut places: Vec<f64> = cuts.iter().map(|motion| across(motion.from)).collect();
            places.dedup_by(|a, b| (*a - *b).abs() <= SAME);
            let depths: Vec<f64> = places.windows(2).map(|two| (two[0] - two[1]).abs()).collect();
            // Not compared: the first pass, whose depth includes the allowance, and the last, which cuts the
            // rest.
            let each = depths.first().copied().unwrap_or_default();
            let is_even = depths.iter().rev().skip(1).all(|depth| (depth - each).abs() <= 1e-3);
            let mut actions = vec![if is_even && !depths.is_empty() {
                Action::Passes {
                    cycle,
                    passes: places.len() as u32,
                    each: Quantity::Length(each),
                    depth: Quantity::Length((across(start) - across(last.from)).abs()),
                    last: at(last.from),
                }
            } else {
                Action::PassesTo(cycle, places.len() as u32, at(last.from))
            }];
            if has_contour {
                actions.push(along);
            }
            actions
        }
    }
}

/// Whether a cycle cuts in passes; drilling and grooving cycles cut in pecks.
pub fn has_passes(cycle: Cycle) -> bool {
    matches!(cycle.family(), CycleFamily::Turning | CycleFamily::Threading | CycleFamily::Contour)
}

/// Number of passes among the motions of a block. Pass numbers continue while a cycle is modal.
pub fn number_of_passes(motions: &[Motion]) -> u32 {
    let mut passes = Passes::default();
    motions.iter().filter_map(|motion| motion.cycle).for_each(|step| passes.add(step));
    passes.count()
}

/// The least and the greatest pass number of some motions; `None` without passes.
#[derive(Clone, Copy, Debug, Default)]
pub struct Passes(Option<(u32, u32)>);

impl Passes {
    /// Adds a step of a cycle; one with the number 0 belongs to no pass.
    pub fn add(&mut self, step: CycleStep) {
        let pass = step.pass;
        if pass > 0 {
            let (least, most) = self.0.unwrap_or((pass, pass));
            self.0 = Some((least.min(pass), most.max(pass)));
        }
    }

    /// The number of passes.
    pub fn count(self) -> u32 {
        self.0.map_or(0, |(least, most)| most + 1 - least)
    }
}

/// The feed of the cuts that are not threads, if it is the same for all.
fn feed_of_all(motions: &[Motion]) -> Option<Quantity> {
    let cuts = motions.iter().filter(|motion| motion.kind.cuts() && motion.kind != MotionKind::Thread);
    let mut feeds = cuts.map(|motion| match motion.process.feed {
        Feed::Unset => None,
        Feed::PerMinute(feed) => Some(Quantity::FeedPerMinute(feed)),
        Feed::PerTurn(feed) => Some(Quantity::FeedPerTurn(feed)),
    });
    let first = feeds.next()??;
    feeds.all(|feed| feed == Some(first)).then_some(first)
}

/// Rounds to 0.1 s, or to 0.01 s below one second.
fn rounded_seconds(seconds: f64) -> f64 {
    let places = if seconds < 1.0 { 100.0 } else { 10.0 };
    (seconds * places).round() / places
}
