//! Output of motions into the list, and the limits of that list.
//!
//! In: motions. Out: those that change anything, in machine coordinates. A dwell and a rotation of C count as
//! changes.

use super::Interpreter;
use crate::control::events::Event;
use crate::control::modal::PathMove;
use crate::geometry::virtual_plane::{Surface, VirtualMove, Way};
use crate::geometry::{Arc, Point, Turn};
use crate::message::said;
use crate::motion::{Motion, MotionKind, Process, Rotary, Stop, StopKind};
use crate::parts::{Part, late};
use crate::setup::tool_words::{flips_part, is_second_operation};
use crate::text::block::Block;

/// The part of the module that reads comments about flipping the part. The lints are in the same part; a run
/// that began without them is repeated once the part is loaded.
const OTHER_END: Part = Part::Late;

late! {
    /// Whether the comments of a block say that the part is flipped, so that the other end is machined.
    fn announces_other_end(text: &[u8], block: &Block, stop: Option<StopKind>) -> bool {
        // A comment in a block with a T word is about the tool.
        !block.words.iter().any(|word| word.address == b'T')
            && block.comments.iter().any(|comment| {
                let comment = String::from_utf8_lossy(comment.of(text));
                let comment = comment.trim_matches(['(', ')']);
                flips_part(comment, stop.is_some())
                    || stop == Some(StopKind::Always) && is_second_operation(comment)
            })
    }
}

impl Interpreter {
    /// A motion from the position of the tip.
    #[inline]
    pub(super) fn motion(&self, kind: MotionKind, to: Point) -> Motion {
        // `store` determines whether a block has failed, because the motion may wait for the next one.
        let process = Process { incomplete: false, ..self.state.process() };
        Motion::straight(kind, self.state.position, to, process)
    }

    /// Outputs a motion unless it changes nothing, and moves the tip to its end.
    #[inline]
    pub(super) fn push(&mut self, block: &Block, motion: Motion) {
        self.emit(self.path_move(block, motion));
        self.state.position = motion.to;
    }

    /// Looks for comments about flipping the part. `stop`: the block is M00 or M01.
    #[cold]
    pub(super) fn look_for_other_end(&mut self, text: &[u8], block: &Block, stop: Option<StopKind>) {
        if !self.state.frames.has_cut() || self.contours.recorded.is_some() {
            return;
        }
        let is_announced = OTHER_END.is_loaded() && announces_other_end(text, block, stop);
        let frames = &mut self.state.frames;
        let mut is_flipped = stop.is_some() && frames.stop();
        is_flipped |= is_announced && frames.announce_other_end();
        if is_flipped {
            self.state.frames.update_workpiece_zero();
        }
    }

    /// Outputs a motion unless it changes nothing.
    #[inline]
    pub(super) fn emit(&mut self, mut path_move: PathMove) {
        if let Some(kind) = path_move.stop {
            let stop = Stop { kind, span: path_move.span, line: path_move.line };
            // Of several stops at one position, a stop that cannot be skipped wins.
            let waiting = &mut self.state.stop;
            if waiting.is_none_or(|before| before.kind == StopKind::Optional) {
                *waiting = Some(stop);
            }
            return;
        }
        // Compensation or a tool offset has left the tip beside the programmed point.
        if let Some(tip) = self.state.tip.take() {
            path_move.motion.from = tip;
        }
        let motion = &path_move.motion;
        let still = motion.from.is_same(motion.to)
            && motion.center.is_none()
            && motion.seconds.is_none()
            && motion.rotary.is_none()
            && path_move.third.is_none_or(|(from, to)| from == to);
        if still || self.sink.is_full() {
            return;
        }
        if let Some(third) = path_move.third {
            path_move = self.on_machine(path_move, third);
        }
        match &mut self.contours.recorded {
            // One more than a cycle may have, so that the cycle is refused, not truncated.
            Some(recorded) if recorded.len() <= self.setup.limits.moves_per_cycle => recorded.push(path_move),
            Some(_) => {}
            None => self.store(path_move),
        }
    }

    /// Stores a motion in the list.
    #[inline]
    fn store(&mut self, mut path_move: PathMove) {
        if !self.sink.has_room() {
            self.sink.end(said::TooManyMotions { most: self.setup.limits.motions }.into(), path_move.span);
            return;
        }
        // Read again: a later block may have failed while this motion waited.
        path_move.motion.process.incomplete |= self.state.incomplete;
        if let Some(stop) = self.state.stop.take() {
            self.sink.chunk.stop(&stop);
        }
        if path_move.motion.kind.cuts() && self.state.frames.cut() {
            self.place_motions_before();
        }
        self.sink.chunk.push(&path_move.motion, path_move.span, path_move.line);
    }

    /// Adds the rotation of C to a motion outside a virtual plane.
    pub(super) fn turning(&mut self, motion: Motion, c: Option<f64>) -> Motion {
        let Some(to) = c else { return motion };
        let from = std::mem::replace(&mut self.state.c, to);
        // The feed distance of one degree.
        let degree = self.state.unit.millimetres();
        let rotary = (from != to).then_some(Rotary { from, to, degree, virtual_move: None });
        Motion { rotary, ..motion }
    }

    /// A motion of a block for the next stages: corners, compensation, output.
    #[inline]
    pub(super) fn path_move(&self, block: &Block, motion: Motion) -> PathMove {
        let third = self.state.virtual_plane.map(|plane| plane.third);
        let (span, words, line) = (block.span, block.words_span(), block.line);
        PathMove { motion, span, words, line, third, stop: None, wall: None }
    }

    /// The motion of the machine for a motion in a virtual plane.
    #[cold]
    fn on_machine(&mut self, mut path_move: PathMove, third: (f64, f64)) -> PathMove {
        let Some(plane) = &mut self.state.virtual_plane else { return path_move };
        let motion = &mut path_move.motion;
        let turn = match motion.kind {
            MotionKind::ArcClockwise => Some(Turn::Clockwise),
            MotionKind::ArcCounterclockwise => Some(Turn::Counterclockwise),
            _ => None,
        };
        let way = match (turn, motion.center) {
            (Some(turn), Some(center)) => Way::Arc(Arc { start: motion.from, end: motion.to, center, turn }),
            _ => Way::Line(motion.from, motion.to),
        };
        let from = plane.angle;
        match plane.surface {
            // C turns independently of the path.
            Surface::Flat(_) => plane.angle = self.state.c,
            surface => plane.angle += surface.turn_along(&way),
        }
        let own = VirtualMove { surface: plane.surface, way, third };
        motion.rotary = Some(Rotary { from, to: plane.angle, degree: 1.0, virtual_move: Some(own) });
        (motion.from, motion.to, motion.center) = (own.at(0.0), own.at(1.0), None);
        let distance = way.distance_from_center();
        if plane.surface == Surface::Face {
            self.observe(&[], Event::NearCenter { distance, words: path_move.words });
        }
        path_move
    }

    /// Places the motions before the first cut on the workpiece, whose position the first cut determines.
    #[cold]
    pub(super) fn place_motions_before(&mut self) {
        let frames = &self.state.frames;
        self.sink.chunk.place_on_workpiece(|left| frames.place(left));
    }
}
