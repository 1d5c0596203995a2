//! Nose radius compensation of the programmed path.
//!
//! In: moves of the path, with corners inserted; the side and the nose. Out: motions of the tip. A move is
//! emitted when the next one is known, or when the path ends.

use super::Interpreter;
use crate::control::codes::Compensation;
use crate::control::compensation::{
    Compensator, Element, MadeBy, Nose, Outcome, Reason, Shape, Side, Travel,
};
use crate::control::events::{CompensatedMove, Event};
use crate::control::modal::{Compensating, PathMove};
use crate::control::tool_offset;
use crate::geometry::{Point, Turn};
use crate::message::{Diagnostic, Message, said};
use crate::motion::{Motion, MotionKind, Programmed};
use crate::parts::{Part, early};

/// The part of the module that inserts corners and compensates paths.
pub(super) const PATH: Part = Part::Early;

early! {
    fn compensate(control: &mut Interpreter, path_move: &PathMove, nose: Nose) {
        control.compensate(*path_move, nose);
    }

    fn flush(control: &mut Interpreter) {
        control.emit_rest();
    }
}

impl Interpreter {
    /// Compensates the next move of the path, with a nose that has a radius or replaces one that had.
    fn compensate(&mut self, path_move: PathMove, nose: Nose) {
        let side = self.side();
        let motion = path_move.motion;
        // Another tool or offset: the new nose applies from this move on.
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
            None => compensating.compensator.clone().cancel(Some(element), path_move.wall, &mut keep),
        }
        self.emit_outcomes(&mut compensating, outcomes);
        if side.is_some() {
            self.state.compensating = Some(compensating);
        }
    }

    /// Converts the emitted moves of compensation to motions.
    fn emit_outcomes(&mut self, compensating: &mut Compensating, outcomes: Vec<Outcome>) {
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
                    self.mark_left_out();
                    // The next move begins at another point.
                    match compensating.waiting.iter_mut().find(|(later, _)| *later > id) {
                        Some((_, later)) => later.motion.process.uncertain = true,
                        None => self.doubt_path(),
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

    /// Moves the centre to the end of the last move; no next move is known.
    fn emit_rest(&mut self) {
        if let Some(mut compensating) = self.state.compensating.take() {
            let mut outcomes = Vec::new();
            compensating.compensator.flush(&mut |outcome| outcomes.push(outcome));
            self.emit_outcomes(&mut compensating, outcomes);
            self.state.compensating = Some(compensating);
        }
    }

    /// The side of the path on which the nose is: a negative radius reverses it.
    pub(super) fn side(&self) -> Option<Side> {
        let side = match self.state.compensation {
            Compensation::Off => return None,
            Compensation::Left => Side::Left,
            Compensation::Right => Side::Right,
        };
        Some(if tool_offset::nose_entry(&self.state, &self.setup).0 < 0.0 { side.opposite() } else { side })
    }

    /// Adds a dwell after the waiting move, if there is one.
    pub(super) fn push_dwell(&mut self, path_move: PathMove) {
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

    pub(super) fn wait_all(&mut self, dwells: &[PathMove], at: Point) {
        for path_move in dwells {
            let motion = Motion { from: at, to: at, ..path_move.motion };
            self.push_dwell(PathMove { motion, ..*path_move });
        }
    }

    /// Compensates a move; outputs it directly if compensation is off.
    pub(super) fn offset(&mut self, path_move: PathMove) {
        if self.state.compensation == Compensation::Off && self.state.compensating.is_none() {
            return self.emit(path_move);
        }
        let motion = path_move.motion;
        if motion.from.is_same(motion.to) && motion.center.is_none() {
            return;
        }
        let nose = tool_offset::nose(&self.state, &self.setup);
        if self.state.compensating.is_none() && nose.radius <= 0.0 {
            return self.emit(path_move);
        }
        if self.has(PATH) {
            compensate(self, &path_move, nose);
        }
    }

    /// Moves the centre to the end of the last move; no next move is known.
    pub(super) fn flush_compensation(&mut self) {
        // If a move is being compensated, the part is loaded.
        if self.state.compensating.is_some() {
            flush(self);
        }
    }
}
