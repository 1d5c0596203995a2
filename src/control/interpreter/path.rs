//! From the programmed path to the motion list: corners first, then nose radius compensation.
//!
//! In: straight moves and arcs as programmed. Out: motions. A move with a chamfer, a rounding or an open
//! angle waits for the next one; with compensation every move does. Everything that is not part of the path
//! (cycles, threads, G28, frame changes) first outputs the waiting moves.

use super::Interpreter;
use super::compensated::PATH;
use crate::control::codes::Compensation;
use crate::control::modal::{Angle, Compensating, Joint, PathMove, Pending, VirtualPlane};
use crate::control::offsets::Frames;
use crate::geometry::Point;
use crate::geometry::virtual_plane::{Flat, Space, Surface};
use crate::message::{Diagnostic, said};
use crate::motion::{MotionKind, StopKind};
use crate::parts::early;
use crate::text::block::Block;

early! {
    fn close_angle(control: &mut Interpreter, x: Option<f64>, z: Option<f64>, angle: Option<f64>) -> bool {
        control.end_open_angle(x, z, angle)
    }

    fn back_to_turning(control: &mut Interpreter) {
        control.back_to_turning();
    }
}

/// Number of blocks without a move after which a control no longer sees the next move.
const IDLE_BLOCKS: u32 = 2;

impl Interpreter {
    /// Adds a move of the programmed path.
    #[inline(never)]
    pub(super) fn push_path_move(&mut self, mut path_move: PathMove, joint: Option<Joint>) {
        let motion = path_move.motion;
        let still = motion.from.is_same(motion.to) && motion.center.is_none();
        if still && (motion.rotary.is_some() || path_move.third.is_some_and(|(from, to)| from != to)) {
            // Nothing moves in the plane of the path: there is no corner, and nothing to compensate.
            return self.push_dwell(path_move);
        }
        if self.state.pending.is_some()
            && let Some(pending) = self.state.pending.take()
            && !self.join(pending, &mut path_move)
        {
            self.mark_left_out();
            path_move.motion.process.uncertain = true;
        }
        self.state.position = path_move.motion.to;
        match joint {
            Some(_) => {
                self.state.pending =
                    Some(Pending { path_move, joint, angle: None, before: None, dwells: Vec::new() })
            }
            None => self.offset(path_move),
        }
    }

    /// Fast path for a move while nothing is waiting, compensated or recorded: puts it directly into the
    /// motion list, as most moves of long programs. False: the move has to take the normal path.
    #[inline]
    pub(super) fn push_fast(
        &mut self,
        block: &Block,
        kind: MotionKind,
        to: Point,
        center: Option<Point>,
    ) -> bool {
        let state = &self.state;
        let plain = state.compensation == Compensation::Off
            && state.compensating.is_none()
            && state.pending.is_none()
            && state.virtual_plane.is_none()
            && state.tip.is_none()
            && state.stop.is_none()
            && self.contours.recorded.is_none()
            && !self.sink.is_full()
            && self.sink.kept() < self.setup.limits.motions;
        if !plain {
            return false;
        }
        let from = state.position;
        if !from.is_same(to) || center.is_some() {
            let process = state.process();
            if kind.cuts() && self.state.frames.cut() {
                self.place_motions_before();
            }
            self.sink.chunk.push_move(kind, from, to, center, &process, block.span, block.line);
        }
        self.state.position = to;
        true
    }

    /// Adds a move of which only the angle is known, until the next block gives its end.
    #[inline(never)]
    pub(super) fn push_at_angle(&mut self, block: &Block, angle: Angle, joint: Option<Joint>) {
        let motion = self.motion(MotionKind::Feed, self.state.position);
        let mut path_move = self.path_move(block, motion);
        let mut before = None;
        if let Some(pending) = self.state.pending.take() {
            if pending.angle.is_none() && pending.joint.is_some() {
                // The corner waits until the end of this open angle is known.
                before = Some(Box::new(pending));
            } else if !self.join(pending, &mut path_move) {
                self.mark_left_out();
                path_move.motion.process.uncertain = true;
            }
        }
        self.state.pending =
            Some(Pending { path_move, joint, angle: Some(angle), before, dwells: Vec::new() });
    }

    /// Closes an open angle with the end point and angle of the next block. False: an error was reported.
    pub(super) fn close_angle(&mut self, x: Option<f64>, z: Option<f64>, angle: Option<f64>) -> bool {
        let is_open = self.state.pending.as_ref().is_some_and(|pending| pending.angle.is_some());
        !is_open || self.has(PATH) && close_angle(self, x, z, angle)
    }

    /// Outputs the waiting moves, because no next move will come: end of program, a cycle, a new frame.
    #[inline(never)]
    pub(super) fn flush_pending(&mut self) {
        if let Some(pending) = self.state.pending.take() {
            match (&pending.joint, &pending.angle) {
                (_, Some(angle)) => {
                    let message = said::AngleNoPoint { word: angle.word.clone(), alarm: "PS0058" };
                    self.report(Diagnostic::new(message, angle.span));
                }
                (Some(joint), None) => {
                    let message = said::CornerNoMove { word: joint.word.clone() };
                    self.report(Diagnostic::new(message, joint.span));
                }
                (None, None) => {}
            }
            let from = pending
                .before
                .as_ref()
                .map_or(pending.path_move.motion.from, |first| first.path_move.motion.from);
            if pending.angle.is_none() && pending.joint.is_none() {
                self.offset(pending.path_move);
            } else {
                self.state.position = from;
                self.doubt_position();
            }
            self.wait_all(&pending.dwells, self.state.position);
        }
        self.flush_compensation();
    }

    /// The next move is not carried out: a corner or an open angle that waits for it is left out without a
    /// message. One error, one message.
    #[cold]
    pub(super) fn forget_next_move(&mut self) {
        let Some(pending) = &mut self.state.pending else { return };
        pending.joint = None;
        pending.path_move.motion.process.uncertain = true;
        if pending.angle.is_some() {
            self.state.position = pending
                .before
                .as_ref()
                .map_or(pending.path_move.motion.from, |first| first.path_move.motion.from);
            self.state.pending = None;
            self.doubt_position();
        }
    }

    /// Ends compensation without a separate move: the tip is beside the programmed point, and the next move
    /// begins there.
    pub(super) fn leave_compensation(&mut self) {
        if self.state.pending.is_none() && self.state.compensating.is_none() {
            return;
        }
        self.flush_pending();
        if let Some(compensating) = self.state.compensating.take() {
            let tip = compensating.compensator.tip();
            self.state.tip = (!tip.is_same(self.state.position)).then_some(tip);
        }
        self.leave_y_plane();
    }

    /// Outputs a move with an open angle if no straight move with an end point follows.
    pub(super) fn flush_open_angle(&mut self) {
        if self.state.pending.as_ref().is_some_and(|pending| pending.angle.is_some()) {
            self.flush_pending();
        }
    }

    /// Counts a block without a move of the path.
    pub(super) fn idle_block(&mut self) {
        if let Some(compensating) = &mut self.state.compensating {
            compensating.idle_blocks += 1;
            if compensating.idle_blocks == IDLE_BLOCKS {
                self.flush_compensation();
            }
        }
    }

    /// A cycle starts here. Its start point is the programmed point, so an approach that only starts
    /// compensation goes there without compensation.
    pub(super) fn flush_before_cycle(&mut self) {
        let only_approach =
            |compensating: &Compensating| compensating.is_new && compensating.waiting.len() == 1;
        if self.state.pending.is_none()
            && self.state.compensating.as_ref().is_some_and(only_approach)
            && let Some(compensating) = self.state.compensating.take()
        {
            for (_, path_move) in compensating.waiting.into_iter().chain(compensating.dwells) {
                self.emit(path_move);
            }
        }
        self.leave_compensation();
    }

    /// M00, M01: the program stops after all previous moves, including those that wait for a next one.
    #[cold]
    pub(super) fn stop(&mut self, block: &Block, kind: StopKind) {
        // A contour is read only for its shape.
        if self.contours.recorded.is_none() {
            let here = self.motion(MotionKind::Dwell, self.state.position);
            self.push_dwell(PathMove { stop: Some(kind), ..self.path_move(block, here) });
        }
    }

    /// Changes the frame without moving the machine.
    pub(super) fn change_frame(&mut self, change: impl FnOnce(&mut Frames)) {
        self.leave_compensation();
        if let Some(left) = self.state.frames.before_first_cut() {
            self.sink.chunk.leave_frame(left);
        }
        self.state.change_frame(change);
    }

    /// Returns from a Y plane to the turning plane.
    #[inline]
    pub(super) fn leave_y_plane(&mut self) {
        if self.state.virtual_plane.is_some_and(|plane| matches!(plane.surface, Surface::Flat(_))) {
            back_to_turning(self);
        }
    }

    pub(super) fn is_in_y_plane(&self) -> bool {
        self.state.virtual_plane.is_some_and(|plane| matches!(plane.surface, Surface::Flat(_)))
    }

    pub(super) fn enter_y_plane(&mut self, flat: Flat) {
        let surface = Surface::Flat(flat);
        if self.state.virtual_plane.is_some_and(|plane| plane.surface == surface) {
            return;
        }
        self.leave_compensation();
        self.leave_y_plane();
        let state = &mut self.state;
        let (at, third) = surface.enter(state.position, state.y, state.c);
        state.tip = state.tip.map(|tip| surface.enter(tip, state.y, state.c).0);
        state.position = at;
        state.virtual_plane = Some(VirtualPlane { surface, third: (third, third), angle: state.c });
    }

    fn back_to_turning(&mut self) {
        // Waiting moves lead back here.
        self.leave_compensation();
        let state = &mut self.state;
        let Some(plane) = state.virtual_plane.take() else { return };
        let Surface::Flat(flat) = plane.surface else { return };
        let Space { x, y, z } = flat.space(state.position, plane.third.1);
        state.tip = state.tip.map(|tip| plane.surface.machine(tip, plane.third.1));
        (state.position, state.y) = (Point::new(x, z), y);
    }
}
