//! The motions from which tools and blank are inferred.
//!
//! In: all motions. Out: the first of them, on the workpiece, mirrored to +X, and in Z if the tools come from
//! −Z: inference only handles tools at +X that come from +Z. Knows of tools only how to mirror them.

use crate::geometry::{Point, SAME};
use crate::limits::INFERRED_FROM;
use crate::motion::{CycleFamily, Motion, MotionKind, Motions, Step};
use crate::setup::{Stock, Tool};

/// Maximum length of a cut towards −Z that is still an approach, mm.
const MAX_APPROACH: f64 = 2.0;

/// Maximum distance in front of the face at which a cut begins, mm.
const MAX_IN_FRONT: f64 = 5.0;

/// Minimum depth of a cut into the workpiece, mm.
const MIN_DEPTH: f64 = 3.0;

/// The first motions of a program.
#[derive(Clone, Copy, Debug)]
pub struct Evidence<'a> {
    motions: &'a Motions,
    /// Whether Z is mirrored: the tools work towards +Z.
    is_mirrored: bool,
}

impl<'a> Evidence<'a> {
    /// The evidence of a program; `stock` is the given blank, if any.
    pub fn of(motions: &'a Motions, stock: Option<Stock>) -> Self {
        let evidence = Self { motions, is_mirrored: false };
        // A given blank that lies behind Z0 is not cut towards +Z.
        let can_be_mirrored = stock.is_none_or(|stock| stock.face > SAME);
        Self { is_mirrored: can_be_mirrored && evidence.is_towards_positive_z(), ..evidence }
    }

    /// Whether Z is mirrored.
    pub fn is_mirrored(&self) -> bool {
        self.is_mirrored
    }

    /// Whether the whole motion is on the side of −X.
    pub fn is_on_negative_x(&self, index: usize) -> bool {
        let motion = self.motions.get_on_workpiece(index);
        motion.from.x.max(motion.to.x) < -SAME
    }

    /// The first motions, on the workpiece: those on −X mirrored to +X, and Z mirrored if the tools come from
    /// −Z.
    pub fn moves(&self) -> impl Iterator<Item = Motion> + 'a {
        let is_mirrored = self.is_mirrored;
        let moves = self.motions.on_workpiece().take(INFERRED_FROM).map(Motion::on_positive_side);
        let mirror = |at: Point| Point::new(at.x, -at.z);
        moves.map(move |motion| if is_mirrored { motion.mirrored(mirror) } else { motion })
    }

    /// Whether all cuts begin at or in front of the face on the side of −Z and go towards +Z into the
    /// workpiece: the second side of a part, in a sub-spindle or turned around. The tools come from −Z, or
    /// begin at Z0 in the bore.
    fn is_towards_positive_z(&self) -> bool {
        let (mut goes_in, mut clears, mut faces, mut bores) = (false, false, false, false);
        for motion in self.moves() {
            let (from, to) = (motion.from, motion.to);
            // The motion after a facing cut is its way back, not a cut into the workpiece.
            let comes_from_face = std::mem::replace(
                &mut faces,
                motion.kind.cuts() && (to.z - from.z).abs() <= SAME && to.x < from.x - SAME,
            );
            clears |= to.z < -SAME;
            // A pass of a single cycle that goes outwards from its start at the face.
            let pass = motion.cycle.filter(|step| step.cycle.family() == CycleFamily::Turning);
            let goes_outwards = pass.is_some_and(|step| step.step == Step::Infeed) && to.x > from.x + SAME;
            bores |= goes_outwards && from.z.abs() <= SAME;
            if !motion.kind.cuts() || !motion.process.removes_material() {
                continue;
            }
            let on_axis = from.x.max(to.x) <= SAME;
            if on_axis
                || motion.rotary.is_some()
                || to.z < from.z - MAX_APPROACH
                || from.z.min(to.z) < -MAX_IN_FRONT
            {
                return false;
            }
            let is_turned = motion.kind != MotionKind::Thread && !comes_from_face;
            goes_in |= is_turned && to.z > from.z + MAX_APPROACH && to.z > MIN_DEPTH;
        }
        goes_in && (clears || bores)
    }

    /// Mirrors a blank if Z is mirrored. Its own inverse.
    pub fn stock(&self, stock: Stock) -> Stock {
        if self.is_mirrored { Stock { face: -stock.back(), ..stock } } else { stock }
    }

    /// Mirrors an inferred tool if Z is mirrored.
    pub fn tool(&self, tool: &mut Tool) {
        if self.is_mirrored {
            tool.tip = Some(match tool.tip_direction() {
                1 => 2,
                2 => 1,
                3 => 4,
                4 => 3,
                5 => 7,
                7 => 5,
                other => other,
            });
        }
    }
}
