//! The context of a move: the path of the tool to it, and the previous cuts.
//!
//! In: motions in order. Out: the current pass.

use crate::geometry::Point;
use crate::motion::{Glance, MotionKind, Motions};

/// Largest X of a facing cut's end, mm: at or past the centre.
pub(super) const CENTRE: f64 = 0.5;

/// The cuts of a tool since its last rapid, and the face made by earlier cuts.
#[derive(Clone, Debug, Default)]
pub(super) struct Pass {
    /// Number of motions that were added.
    next: usize,
    /// Start of its first cut; `None` before a cut.
    pub begins: Option<Point>,
    /// Its last cut; `None` before the first.
    pub before: Option<Glance>,
    /// Z of the lowest face that was cut to the centre, mm.
    faced: Option<f64>,
    tool: u16,
    /// The farthest Z at which earlier tools, and the current tool, began their cuts, mm.
    others: Option<f64>,
    own: Option<f64>,
}

fn farther(front: Option<f64>, z: f64) -> Option<f64> {
    Some(front.map_or(z, |front| front.max(z)))
}

impl Pass {
    /// Adds the motions before `to`, which must not decrease from call to call.
    pub fn advance(&mut self, motions: &Motions, to: usize) {
        for index in self.next..to {
            self.take(motions.glance(index));
        }
        self.next = self.next.max(to);
    }

    fn take(&mut self, motion: Glance) {
        if motion.kind == MotionKind::Dwell {
            return;
        }
        let tool = motion.station;
        if tool != self.tool {
            if let Some(own) = self.own.take() {
                self.others = farther(self.others, own);
            }
            self.tool = tool;
            (self.begins, self.before) = (None, None);
        }
        if !motion.kind.cuts() || motion.is_of_cycle {
            (self.begins, self.before) = (None, None);
        }
        if !motion.kind.cuts() {
            return;
        }
        let along_face = (motion.to.z - motion.from.z).abs() <= 0.001;
        if along_face && motion.to.x < motion.from.x && motion.to.x <= CENTRE {
            self.faced = Some(self.faced.map_or(motion.to.z, |face| face.min(motion.to.z)));
        }
        if motion.is_of_cycle {
            self.own = farther(self.own, motion.from.z);
            return;
        }
        if self.begins.is_none() {
            self.begins = Some(motion.from);
            self.own = farther(self.own, motion.from.z);
        }
        self.before = Some(motion);
    }

    /// The Z beyond which the blank has no material: a face was cut there, or other tools than `tool` began
    /// their cuts.
    pub fn empty_beyond(&self, tool: u16) -> Option<f64> {
        let others = match self.own.filter(|_| tool != self.tool) {
            Some(own) => farther(self.others, own),
            None => self.others,
        };
        match (self.faced, others) {
            (Some(face), Some(front)) => Some(face.min(front)),
            (face, front) => face.or(front),
        }
    }
}
