//! Chamfers and rounded corners between two moves of the path, and moves given by their angle.
//!
//! In: a waiting move, and the next one. Out: both shortened, and the piece between them.

use super::Interpreter;
use super::compensated::PATH;
use super::request::Request;
use crate::control::codes::MotionMode;
use crate::control::corners::{self, ANGLE_ALLOWANCE, Corner, CornerError, Joined, Letter};
use crate::control::modal::{Follower, Joint, PathMove, Pending};
use crate::control::words::{Words, letters, quote};
use crate::cycles::Piece;
use crate::geometry::{Point, Turn};
use crate::message::{Diagnostic, Message, said};
use crate::motion::{Motion, MotionKind};
use crate::parts::early;
use crate::setup::dialect::{Control, Dialect};
use crate::text::block::Block;

early! {
    fn join(control: &mut Interpreter, pending: &Pending, joint: &Joint, next: &mut PathMove) -> bool {
        control.put_corner_in(pending, joint, next)
    }

    fn end_by_angle(from: Point, angle: f64, x: Option<f64>, z: Option<f64>) -> Result<Point, CornerError> {
        corners::end_by_angle(from, angle, x, z)
    }

    fn read_joint(
        control: &mut Interpreter,
        text: &[u8],
        block: &Block,
        request: &Request,
        words: &Words,
    ) -> Result<Option<Joint>, ()> {
        control.read_joint(text, block, request, words)
    }
}

impl Interpreter {
    /// The chamfer or rounding word of a move: with comma, without, or L and D on GSK.
    fn read_joint(
        &mut self,
        text: &[u8],
        block: &Block,
        request: &Request,
        words: &Words,
    ) -> Result<Option<Joint>, ()> {
        let straight = self.state.motion == MotionMode::Line && self.state.virtual_plane.is_none();
        let gsk = self.dialect.control == Control::Gsk;
        let [chamfer, round, _] = request.comma;
        let comma = |index: Option<usize>| index.map(|index| &block.words[index]);
        let plain_word = |letter: u8, allowed: bool| if allowed { words.get(letter) } else { None };
        let candidates = [
            (comma(chamfer), None, Corner::Chamfer as fn(f64) -> Corner),
            (comma(round), None, Corner::Round),
            (plain_word(b'L', gsk), None, Corner::Chamfer),
            (plain_word(b'D', gsk), None, Corner::Round),
            (plain_word(b'I', straight && request.wall.is_none()), Some(Letter::I), Corner::Chamfer),
            (plain_word(b'K', straight && request.wall.is_none()), Some(Letter::K), Corner::Chamfer),
            (plain_word(b'C', straight && !self.state.c_axis), Some(Letter::C), Corner::Chamfer),
            (plain_word(b'R', straight), Some(Letter::R), Corner::Round),
        ];
        let mut found =
            candidates.into_iter().filter_map(|(word, letter, corner)| Some((word?, letter, corner)));
        let Some((word, letter, corner)) = found.next() else { return Ok(None) };
        let quoted = quote(text, word.span);
        if let Some((other, ..)) = found.next() {
            let message = said::CornerTwice { word: quoted, other: quote(text, other.span) };
            self.report(Diagnostic::new(message, word.span));
            return Err(());
        }
        if request.switches_compensation {
            self.report(Diagnostic::new(said::CornerWithCompensation { word: quoted }, word.span));
            return Err(());
        }
        let Some(value) = self.reading().length(word).filter(|&value| value != 0.0) else { return Ok(None) };
        Ok(Some(Joint {
            corner: corner(if letter.is_some() { value.abs() } else { value }),
            signed: letter.map(|letter| (letter, value)),
            // Newer controls round the corner between a line and an arc; older ones raise PS0052.
            before: if letter.is_none() && (gsk || !self.dialect.strict) {
                Follower::LineOrArc
            } else {
                Follower::Line
            },
            span: word.span,
            word: quoted,
        }))
    }

    /// Closes an open angle with the end point and angle of the next block. False: an error was reported.
    pub(super) fn end_open_angle(&mut self, x: Option<f64>, z: Option<f64>, angle: Option<f64>) -> bool {
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
                        self.mark_left_out();
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
                self.doubt_position();
                self.report(diagnostic);
                false
            }
        }
    }

    /// Inserts the corner between a waiting move and the next one, whose start it may shorten. False: the
    /// corner does not fit, and the waiting move is dropped; reported unless an earlier error explains it.
    fn put_corner_in(&mut self, pending: &Pending, joint: &Joint, next: &mut PathMove) -> bool {
        let first = piece(&pending.path_move.motion);
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
            // The control inserts nothing, and continues.
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
                // After an earlier error the move before the corner may not be the programmed one.
                if !pending.path_move.motion.process.uncertain {
                    self.report_corner(joint, fault);
                }
                // The start of an arc stays on its circle.
                if next.motion.center.is_none() {
                    next.motion.from = pending.path_move.motion.from;
                }
                false
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

    /// The end of a straight move given by its angle and one axis.
    pub(super) fn end_by_angle(
        &mut self,
        angle: f64,
        x: Option<f64>,
        z: Option<f64>,
    ) -> Result<Point, CornerError> {
        let from = self.state.position;
        if self.has(PATH) { end_by_angle(from, angle, x, z) } else { Ok(from) }
    }

    /// The chamfer or rounding word of a move: with comma, without, or L and D on GSK.
    pub(super) fn joint(
        &mut self,
        text: &[u8],
        block: &Block,
        request: &Request,
        words: &Words,
    ) -> Result<Option<Joint>, ()> {
        // Most moves have no such word.
        let is_straight = self.state.motion == MotionMode::Line && self.state.virtual_plane.is_none();
        let candidates = if is_straight { letters(b"CDIKLR") } else { letters(b"DL") };
        if request.comma == [None; 3] && !words.has_any(candidates) || !self.has(PATH) {
            return Ok(None);
        }
        read_joint(self, text, block, request, words)
    }

    /// Joins a waiting move to the next one, whose start it may shorten. False: an error was reported, and
    /// the waiting move is dropped.
    pub(super) fn join(&mut self, pending: Pending, next: &mut PathMove) -> bool {
        if let Some(joint) = &pending.joint {
            return self.has(PATH) && join(self, &pending, joint, next);
        }
        self.offset(pending.path_move);
        self.wait_all(&pending.dwells, next.motion.from);
        true
    }
}

/// A motion as a piece of a path.
fn piece(motion: &Motion) -> Piece {
    let arc = motion.arc().map(|arc| (arc.center, arc.turn));
    Piece { from: motion.from, to: motion.to, arc }
}

/// The error of a corner word without comma. The sign and axis of I and K are always checked. Many controls
/// read C and R like the comma forms, so these are checked only if they are negative or the control is
/// strict.
fn signed_fault(
    first: &Piece,
    second: &Piece,
    (letter, value): (Letter, f64),
    dialect: &Dialect,
) -> Option<CornerError> {
    let held = dialect.strict || matches!(letter, Letter::I | Letter::K) || value < 0.0;
    corners::check_signed(first, second, letter, value).err().filter(|_| held)
}
