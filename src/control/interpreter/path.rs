//! The way of the programmed path to the motion list: corners first, then nose radius compensation.
//!
//! In: straight moves and arcs as blocks program them. Out: motions. A move with a chamfer, a rounding or an
//! open angle waits for the next one; under compensation every move does. Whatever is no part of the path
//! (cycles, threads, G28, changes of the frame) first settles what waits.

use super::Interpreter;
use crate::control::codes::Compensation;
use crate::control::compensation::{Compensator, Element, MadeBy, Outcome, Reason, Shape, Side, Travel};
use crate::control::corners::{self, ANGLE_ALLOWANCE, CornerError, Joined};
use crate::control::events::{CompensatedMove, Event};
use crate::control::modal::{Angle, Compensating, Follower, Joint, PathMove, Pending};
use crate::control::tool_offset;
use crate::cycles::Piece;
use crate::geometry::{Point, Turn};
use crate::message::{Diagnostic, Message, said};
use crate::motion::{Motion, MotionKind, Programmed};
use crate::setup::dialect::Dialect;
use crate::text::block::Block;

/// Blocks without a move after which a control no longer sees the next move.
const IDLE_BLOCKS: u32 = 2;

impl Interpreter {
    /// A move of the programmed path.
    #[inline(never)]
    pub(super) fn travel(&mut self, block: &Block, motion: Motion, joint: Option<Joint>) {
        let mut path_move = self.path_move(block, motion);
        let still = motion.from.is_same(motion.to) && motion.center.is_none();
        if still && (motion.rotary.is_some() || path_move.third.is_some_and(|(from, to)| from != to)) {
            // Nothing moves in the plane of the path: no corner, nothing to compensate.
            return self.wait_here(path_move);
        }
        if self.state.pending.is_some()
            && let Some(pending) = self.state.pending.take()
            && !self.join(pending, &mut path_move)
        {
            self.left_out();
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

    /// A move while nothing waits, is compensated or recorded: straight into the motion list, as nearly all
    /// moves of long programs. False: it has to go the whole way.
    #[inline]
    pub(super) fn travel_plainly(
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
            if kind.cuts() {
                self.state.frames.cut();
            }
            self.sink.chunk.push_move(kind, from, to, center, &process, block.span, block.line);
        }
        self.state.position = to;
        true
    }

    /// A move known by its angle alone, until the next block gives its end.
    #[inline(never)]
    pub(super) fn travel_at_angle(&mut self, block: &Block, angle: Angle, joint: Option<Joint>) {
        let motion = self.motion(MotionKind::Feed, self.state.position);
        let mut path_move = self.path_move(block, motion);
        let mut before = None;
        if let Some(pending) = self.state.pending.take() {
            if pending.angle.is_none() && pending.joint.is_some() {
                // The corner waits until the end of this open angle is known.
                before = Some(Box::new(pending));
            } else if !self.join(pending, &mut path_move) {
                self.left_out();
                path_move.motion.process.uncertain = true;
            }
        }
        self.state.pending =
            Some(Pending { path_move, joint, angle: Some(angle), before, dwells: Vec::new() });
    }

    /// Closes an open angle with the end point and angle of the next block. False: reported.
    #[inline(never)]
    pub(super) fn close_angle(&mut self, x: Option<f64>, z: Option<f64>, angle: Option<f64>) -> bool {
        let Some(pending) = &mut self.state.pending else { return true };
        let Some(open) = &pending.angle else { return true };
        match corners::after_angle(pending.path_move.motion.from, open.radians, x, z, angle) {
            Ok(end) => {
                pending.path_move.motion.to = end;
                pending.angle = None;
                self.state.position = end;
                if let Some(before) = pending.before.take() {
                    let mut path_move = pending.path_move;
                    if !self.join(*before, &mut path_move) {
                        self.left_out();
                        path_move.motion.process.uncertain = true;
                    }
                    if let Some(pending) = &mut self.state.pending {
                        pending.path_move = path_move;
                    }
                }
                true
            }
            Err(fault) => {
                let alarm = fault.alarm().unwrap_or("PS0057");
                let message = said::AngleNoPoint { word: open.word.clone(), alarm };
                let diagnostic = Diagnostic::new(message, open.span);
                self.state.pending = None;
                self.lose_place();
                self.report(diagnostic);
                false
            }
        }
    }

    /// Joins a waiting move to the next one, which it may shorten at its start. False: reported;
    /// the waiting move is dropped.
    fn join(&mut self, pending: Pending, next: &mut PathMove) -> bool {
        let first = piece(&pending.path_move.motion);
        let Some(joint) = &pending.joint else {
            self.offset(pending.path_move);
            self.wait_all(&pending.dwells, next.motion.from);
            return true;
        };
        let second = piece(&next.motion);
        let fault = match next.motion.kind {
            MotionKind::Rapid | MotionKind::Thread | MotionKind::Dwell => {
                Some(CornerError::SecondNotPerpendicular)
            }
            MotionKind::ArcClockwise | MotionKind::ArcCounterclockwise if joint.before == Follower::Line => {
                Some(CornerError::SecondNotPerpendicular)
            }
            _ => joint.signed.and_then(|signed| signed_fault(&first, &second, signed, &self.dialect)),
        };
        let joined = match fault {
            Some(fault) => Err(fault),
            None => corners::join(&first, &second, joint.corner),
        };
        let joined = match joined {
            // The control puts nothing in between, and goes on.
            Err(CornerError::NoCorner { turn }) if turn.abs() < ANGLE_ALLOWANCE => {
                self.report(Diagnostic::new(said::CornerStraight { word: joint.word.clone() }, joint.span));
                Ok(Joined { first, inserted: None, second })
            }
            joined => joined,
        };
        match joined {
            Ok(joined) => {
                let shortened = |path_move: PathMove, piece: Piece| PathMove {
                    motion: Motion { from: piece.from, to: piece.to, ..path_move.motion },
                    ..path_move
                };
                self.offset(shortened(pending.path_move, joined.first));
                if let Some(piece) = joined.inserted {
                    let (kind, center) = match piece.arc {
                        None => (MotionKind::Feed, None),
                        Some((center, Turn::Clockwise)) => (MotionKind::ArcClockwise, Some(center)),
                        Some((center, Turn::Counterclockwise)) => {
                            (MotionKind::ArcCounterclockwise, Some(center))
                        }
                    };
                    let motion = Motion { kind, center, ..pending.path_move.motion };
                    self.offset(shortened(PathMove { motion, ..pending.path_move }, piece));
                }
                next.motion.from = joined.second.from;
                self.wait_all(&pending.dwells, joined.second.from);
                true
            }
            Err(fault) => {
                self.report_corner(joint, fault);
                // An arc begins on its circle.
                if next.motion.center.is_none() {
                    next.motion.from = pending.path_move.motion.from;
                }
                false
            }
        }
    }

    /// A dwell: it comes after the move that waits, if there is one.
    pub(super) fn wait_here(&mut self, path_move: PathMove) {
        if let Some(pending) = &mut self.state.pending {
            pending.dwells.push(path_move);
            return;
        }
        match &mut self.state.compensating {
            Some(Compensating { waiting, dwells, .. }) if !waiting.is_empty() => {
                let last = waiting.last().map_or(0, |(id, _)| *id);
                dwells.push((last, path_move));
            }
            _ => self.emit(path_move),
        }
    }

    fn wait_all(&mut self, dwells: &[PathMove], at: Point) {
        for path_move in dwells {
            let motion = Motion { from: at, to: at, ..path_move.motion };
            self.wait_here(PathMove { motion, ..*path_move });
        }
    }

    /// Compensation: gives the move on at once where there is none.
    fn offset(&mut self, path_move: PathMove) {
        if self.state.compensation == Compensation::Off && self.state.compensating.is_none() {
            return self.emit(path_move);
        }
        self.compensate(path_move);
    }

    fn compensate(&mut self, path_move: PathMove) {
        let (nose, side) = (tool_offset::nose(&self.state, &self.setup), self.side());
        let motion = path_move.motion;
        if motion.from.is_same(motion.to) && motion.center.is_none() {
            return;
        }
        // Another tool or offset: the new nose counts from this move on.
        if side.is_some()
            && self.state.compensating.as_ref().is_some_and(|old| old.compensator.nose() != nose)
        {
            self.flush_compensation();
            let old = self.state.compensating.take();
            self.state.tip = old.map(|old| old.compensator.tip()).filter(|tip| !tip.is_same(motion.from));
        }
        let mut compensating = match (self.state.compensating.take(), side) {
            (Some(compensating), _) => compensating,
            (None, Some(side)) if nose.radius > 0.0 => Compensating {
                compensator: Compensator::start(side, nose, self.state.tip.take().unwrap_or(motion.from)),
                waiting: Vec::new(),
                dwells: Vec::new(),
                is_new: true,
                idle_blocks: 0,
            },
            (None, _) => return self.emit(path_move),
        };
        let starts = compensating.is_new && compensating.waiting.len() == 1;
        let before = compensating.waiting.last().map(|(_, before)| before.motion);
        compensating.is_new &= compensating.waiting.is_empty();
        let own = CompensatedMove {
            before: before.as_ref().filter(|_| !starts && side.is_some()),
            motion: &motion,
            begins_or_ends: (compensating.is_new && compensating.waiting.is_empty()) || side.is_none(),
            words: path_move.words,
            span: path_move.span,
        };
        self.observe(&[], Event::Compensated(own));
        let id = compensating.waiting.last().map_or(0, |(id, _)| id.wrapping_add(1));
        compensating.waiting.push((id, path_move));
        compensating.idle_blocks = 0;
        let element = Element {
            id,
            travel: if motion.kind == MotionKind::Rapid { Travel::Rapid } else { Travel::Feed },
            from: motion.from,
            to: motion.to,
            shape: motion.arc().map_or(Shape::Line, |arc| Shape::Arc { center: arc.center, turn: arc.turn }),
        };
        let mut outcomes = Vec::new();
        let mut keep = |outcome| outcomes.push(outcome);
        match side {
            Some(side) => {
                if side != compensating.compensator.side() {
                    compensating.compensator.change_side(side);
                }
                compensating.compensator.push(element, &mut keep);
            }
            None => compensating.compensator.clone().cancel(Some(element), &mut keep),
        }
        self.give_out(&mut compensating, outcomes);
        if side.is_some() {
            self.state.compensating = Some(compensating);
        }
    }

    /// Makes motions of what compensation gives out.
    fn give_out(&mut self, compensating: &mut Compensating, outcomes: Vec<Outcome>) {
        let mut last = None;
        for outcome in outcomes {
            let id = outcome.map_or_else(|fault| fault.id, |moved| moved.id);
            let Some(&(_, path_move)) = compensating.waiting.iter().find(|(waiting, _)| *waiting == id)
            else {
                continue;
            };
            match outcome {
                Ok(moved) => {
                    let (kind, center) = match (moved.shape, moved.travel) {
                        (Shape::Line, Travel::Rapid) => (MotionKind::Rapid, None),
                        (Shape::Line, Travel::Feed) => (MotionKind::Feed, None),
                        (Shape::Arc { center, turn: Turn::Clockwise }, _) => {
                            (MotionKind::ArcClockwise, Some(center))
                        }
                        (Shape::Arc { center, turn: Turn::Counterclockwise }, _) => {
                            (MotionKind::ArcCounterclockwise, Some(center))
                        }
                    };
                    let Motion { from, to, center: own, .. } = path_move.motion;
                    let programmed = matches!(moved.made_by, MadeBy::Program).then_some(Programmed {
                        from,
                        to,
                        center: own,
                    });
                    let motion = Motion {
                        kind,
                        center,
                        from: moved.from,
                        to: moved.to,
                        programmed,
                        ..path_move.motion
                    };
                    self.emit(PathMove { motion, ..path_move });
                }
                Err(fault) => {
                    let radius = compensating.compensator.nose().radius;
                    let code = if self.state.compensation == Compensation::Off { "G40" } else { "G41/G42" };
                    let message: Message = match fault.reason {
                        Reason::ArcAtSwitch => said::CompensationOnArc { code }.into(),
                        Reason::NoIntersection { .. } => said::CompensationNoIntersection { radius }.into(),
                        Reason::Overcut { .. } | Reason::CutsIn { .. } | Reason::ArcRadius { .. } => {
                            said::CompensationOvercut { radius, alarm: "PS0041" }.into()
                        }
                        Reason::ArcCenter => said::CompensationOvercut { radius, alarm: "PS0038" }.into(),
                    };
                    self.report(Diagnostic::new(message, path_move.words));
                    self.left_out();
                    // The next move begins elsewhere.
                    match compensating.waiting.iter_mut().find(|(later, _)| *later > id) {
                        Some((_, later)) => later.motion.process.uncertain = true,
                        None => self.lose_path(),
                    }
                }
            }
            if !matches!(outcome, Ok(moved) if moved.made_by == MadeBy::Compensation) {
                let at = compensating.compensator.tip();
                let at = outcome.map_or(at, |moved| moved.to);
                let (now, later) = compensating.dwells.drain(..).partition(|(after, _)| *after == id);
                compensating.dwells = later;
                let now: Vec<(u32, PathMove)> = now;
                for (_, dwell) in now {
                    let motion = Motion { from: at, to: at, ..dwell.motion };
                    self.emit(PathMove { motion, ..dwell });
                }
            }
            last = Some(id);
        }
        if let Some(last) = last {
            compensating.waiting.retain(|(id, _)| *id >= last);
        }
    }

    /// Makes what waits for a next move that will not come: end of program, a cycle, a new frame.
    #[inline(never)]
    pub(super) fn settle(&mut self) {
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
                self.lose_place();
            }
            self.wait_all(&pending.dwells, self.state.position);
        }
        self.flush_compensation();
    }

    /// The next move is not carried out: a corner or an open angle that waits for it is left out, and nothing
    /// is reported for it. One fault, one message.
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
            self.lose_place();
        }
    }

    /// The centre goes to the end of the last move; no next move is known.
    pub(super) fn flush_compensation(&mut self) {
        if let Some(mut compensating) = self.state.compensating.take() {
            let mut outcomes = Vec::new();
            compensating.compensator.flush(&mut |outcome| outcomes.push(outcome));
            self.give_out(&mut compensating, outcomes);
            self.state.compensating = Some(compensating);
        }
    }

    /// Compensation ends here without a move of its own: the tip stands beside the programmed point, and what
    /// comes next begins there.
    pub(super) fn leave_compensation(&mut self) {
        if self.state.pending.is_none() && self.state.compensating.is_none() {
            return;
        }
        self.settle();
        if let Some(compensating) = self.state.compensating.take() {
            let tip = compensating.compensator.tip();
            self.state.tip = (!tip.is_same(self.state.position)).then_some(tip);
        }
    }

    /// An open angle that no straight move with an end point follows.
    pub(super) fn settle_angle(&mut self) {
        if self.state.pending.as_ref().is_some_and(|pending| pending.angle.is_some()) {
            self.settle();
        }
    }

    /// Counts a block that made no move of the path.
    pub(super) fn idle_block(&mut self) {
        if let Some(compensating) = &mut self.state.compensating {
            compensating.idle_blocks += 1;
            if compensating.idle_blocks == IDLE_BLOCKS {
                self.flush_compensation();
            }
        }
    }

    fn report_corner(&mut self, joint: &Joint, fault: CornerError) {
        let word = joint.word.clone();
        let alarm = fault.alarm().unwrap_or("PS0051");
        let message: Message = match fault {
            CornerError::TooLong { .. } | CornerError::NoFit { .. } => said::CornerTooLarge { word }.into(),
            CornerError::NoCorner { .. } | CornerError::Negative { .. } => said::CornerNone { word }.into(),
            CornerError::SecondNotPerpendicular => said::CornerNoMove { word }.into(),
            CornerError::FirstNotAlongAxis | CornerError::WrongLetter | CornerError::WrongSign => {
                said::CornerAxis { word, alarm }.into()
            }
            CornerError::NoSolution { .. }
            | CornerError::NoEndPoint
            | CornerError::NextIncomplete
            | CornerError::AngleDisagrees { .. } => said::AngleNoPoint { word, alarm }.into(),
        };
        self.report(Diagnostic::new(message, joint.span));
    }

    /// The side of the path the nose is on: a negative radius changes it.
    pub(super) fn side(&self) -> Option<Side> {
        let side = match self.state.compensation {
            Compensation::Off => return None,
            Compensation::Left => Side::Left,
            Compensation::Right => Side::Right,
        };
        Some(if tool_offset::nose_entry(&self.state, &self.setup).0 < 0.0 { side.opposite() } else { side })
    }

    /// A cycle starts here: its start point is the programmed one, so an approach that only begins
    /// compensation goes there uncompensated.
    pub(super) fn arrive_for_cycle(&mut self) {
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
}

/// A motion as a piece of a path.
fn piece(motion: &Motion) -> Piece {
    let arc = motion.arc().map(|arc| (arc.center, arc.turn));
    Piece { from: motion.from, to: motion.to, arc }
}

/// What is wrong with a corner word without comma. I and K are always held to their sign and axis; C and R,
/// which many controls take as the comma forms, only where they are negative or the control is strict.
fn signed_fault(
    first: &Piece,
    second: &Piece,
    (letter, value): (corners::Letter, f64),
    dialect: &Dialect,
) -> Option<CornerError> {
    let held = dialect.strict || matches!(letter, corners::Letter::I | corners::Letter::K) || value < 0.0;
    corners::check_signed(first, second, letter, value).err().filter(|_| held)
}
