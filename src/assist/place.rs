//! The motions of one execution of a block, at the positions the block programs.
//!
//! In: an execution of a block, and the motions of the run. Out: the motions of this block. A move before a
//! corner, and every move under nose radius compensation, becomes a motion while a later block is executed,
//! so motions made during a block may belong to another one.

use super::fact::Quantity;
use crate::control::modal::State;
use crate::geometry::Point;
use crate::geometry::virtual_plane::{Surface, VirtualMove, Way};
use crate::motion::{Motion, MotionKind, Motions};
use crate::run::replay::Visit;
use crate::source::Span;

/// Maximum number of later motions searched for motions of a block.
const MAX_LATER: usize = 64;

/// A position, in the axes that a block programs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// X, mm, as a radius.
    pub x: Option<f64>,
    /// Z, mm.
    pub z: Option<f64>,
    /// C: an angle, or a length under G12.1.
    pub c: Option<Quantity>,
}

impl Place {
    /// A position in the plane of turning.
    pub fn turning(at: Point) -> Self {
        Self { x: Some(at.x), z: Some(at.z), c: None }
    }

    /// The position at a fraction of a move in a virtual plane: both its axes, and the third axis if it
    /// moves.
    pub fn on(own: &VirtualMove, t: f64) -> Self {
        let at = own.way.at(t);
        let third = own.third.0 + t * (own.third.1 - own.third.0);
        let third = (own.third.0 != own.third.1).then_some(third);
        match own.surface {
            Surface::Face => Self { x: Some(at.z), z: third, c: Some(Quantity::Length(at.x)) },
            Surface::Cylinder { radius, .. } => {
                Self { x: third, z: Some(at.z), c: Some(Quantity::Degrees((at.x / radius).to_degrees())) }
            }
            Surface::Flat(_) => Self::turning(own.at(t)),
        }
    }
}

/// C with its unit: a length in the virtual plane of G12.1.
pub fn of_c(state: &State, c: f64) -> Quantity {
    match state.interpolation() {
        Some(plane) if plane.surface == Surface::Face => Quantity::Length(c),
        _ => Quantity::Degrees(c),
    }
}

/// The motions of one execution of the block at `span`, in order.
pub fn own_motions(motions: &Motions, span: Span, visit: &Visit) -> Vec<Motion> {
    let made = visit.motions.start..visit.motions.end.min(motions.len());
    let until = match holds(&visit.after.state, span) {
        true => motions.len().min(made.end + MAX_LATER),
        false => made.end,
    };
    let earlier = holds(&visit.before.state, span);
    let begins = visit.before.state.position;
    let mut own: Vec<Motion> = Vec::new();
    for index in made.start..until {
        let motion = motions.get(index);
        let is_later = index >= made.end;
        let is_own = motions.span(index) == span || !is_later && motion.cycle.is_some();
        // The next execution of the same block starts where this one ends.
        let is_next = is_later && start(&motion).is_same(visit.after.state.position);
        match (is_own, own.is_empty()) {
            (true, true) if earlier && !start(&motion).is_same(begins) => {}
            (true, false) if is_next => break,
            (true, _) => own.push(motion),
            (false, false) if is_later => break,
            (false, _) => {}
        }
    }
    own
}

/// Whether moves of a block are still pending.
fn holds(state: &State, span: Span) -> bool {
    let compensating = state.compensating.iter().flat_map(|own| own.waiting.iter().chain(&own.dwells));
    let compensating = compensating.map(|(_, path_move)| path_move);
    let pending = state.pending.iter().flat_map(|own| {
        let before = own.before.iter().map(|before| &before.path_move);
        before.chain([&own.path_move]).chain(&own.dwells)
    });
    compensating.chain(pending).any(|path_move| path_move.span == span)
}

/// The start of a motion in path coordinates: in the virtual plane, if one is in force.
fn start(motion: &Motion) -> Point {
    let in_plane = || motion.virtual_move().map_or(motion.from, |own| own.way.at(0.0));
    motion.programmed.map_or_else(in_plane, |programmed| programmed.from)
}

/// The moves of a block at their programmed positions, without moves inserted by compensation.
pub fn as_programmed(own: &[Motion]) -> Vec<Motion> {
    let is_compensated = own.iter().any(|motion| motion.programmed.is_some());
    let is_inserted = |motion: &Motion| {
        is_compensated && motion.programmed.is_none() && motion.cycle.is_none() && motion.seconds.is_none()
    };
    own.iter().filter(|motion| !is_inserted(motion)).map(at_programmed_place).collect()
}

fn at_programmed_place(motion: &Motion) -> Motion {
    let Some(programmed) = motion.programmed else { return *motion };
    let mut motion = *motion;
    (motion.from, motion.to, motion.center) = (programmed.from, programmed.to, programmed.center);
    let arc = motion.arc();
    if let Some(own) = motion.rotary.as_mut().and_then(|rotary| rotary.virtual_move.as_mut()) {
        own.way = arc.map_or(Way::Line(programmed.from, programmed.to), Way::Arc);
        (motion.from, motion.to, motion.center) = (own.at(0.0), own.at(1.0), None);
    }
    motion
}

/// Whether an arc is clockwise by its code: the direction is reversed for a cylinder seen from inside.
pub fn is_clockwise(motion: &Motion, own: Option<&VirtualMove>) -> bool {
    let is_turned = own.is_some_and(|own| matches!(own.surface, Surface::Cylinder { turned: true, .. }));
    (motion.kind == MotionKind::ArcClockwise) != is_turned
}
