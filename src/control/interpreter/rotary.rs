//! The C axis: as a separate axis, and as the second axis of a virtual plane in polar (G12.1) and cylindrical
//! (G07.1) interpolation (seed 002, FANUC 15i B-63324EN p. 80).
//!
//! In: the words of a block. Out: moves of the path, in the virtual plane while one is in force, and the
//! machine's motions for them.

use super::Interpreter;
use super::request::Request;
use crate::control::codes::{Compensation, G, MotionMode, Plane, Switch};
use crate::control::events::Event;
use crate::control::modal::{Once, PathMove, Target, VirtualPlane};
use crate::control::words::{Counts, Words, letters, quote};
use crate::geometry::virtual_plane::{Flat, Surface, VirtualMove, Way};
use crate::geometry::{Arc, Turn};
use crate::message::{Diagnostic, Message, said};
use crate::motion::{Motion, MotionKind, Rotary};
use crate::setup::dialect::PolarX;
use crate::source::Span;
use crate::text::block::{Block, Value, Word};

/// Addresses of the C axis.
pub(super) const TURNS: u32 = letters(b"CH");

impl Interpreter {
    /// Whether a G code is allowed in polar or cylindrical interpolation; all others raise an alarm.
    pub(super) fn may_stand_in_plane(&mut self, text: &[u8], code: G, word: &Word) -> bool {
        let Some(plane) = self.state.virtual_plane else { return true };
        if matches!(plane.surface, Surface::Flat(_)) {
            return true;
        }
        let allowed = match code {
            G::Polar(Switch::Off) => plane.surface == Surface::Face,
            G::Cylinder => plane.surface != Surface::Face,
            G::Motion(mode) => matches!(mode, MotionMode::Line | MotionMode::Arc(_)),
            G::Dwell | G::Compensation(_) | G::MacroCall(_) | G::NoModalMacro => true,
            G::Feed(_) | G::Distance { .. } => true,
            _ => false,
        };
        if allowed {
            return true;
        }
        let word_text = quote(text, word.span);
        let frame = matches!(code, G::Setting | G::LocalFrame | G::Machine | G::Frame(_) | G::ExtendedFrame);
        let message: Message = match plane.surface {
            Surface::Face if frame => said::PolarFrame { word: word_text }.into(),
            Surface::Face => said::PolarForbidden { word: word_text }.into(),
            Surface::Cylinder { .. } | Surface::Flat(_) => said::CylinderForbidden { word: word_text }.into(),
        };
        self.report(Diagnostic::new(message, word.span));
        false
    }

    /// Reports a tool change or the end of the program while a virtual plane is in force.
    pub(super) fn plane_left_on(&mut self, text: &[u8], span: Span) {
        // Moves that wait in a Y plane are made when it is left.
        self.leave_flat();
        let Some(plane) = self.state.virtual_plane else { return };
        let (code, face) = (quote(text, span), plane.surface == Surface::Face);
        let off = if face { "G13.1" } else { "G07.1 C0" };
        self.report(Diagnostic::new(said::PlaneLeftOn { code, off }, span));
    }

    /// G12.1 and G13.1.
    pub(super) fn polar(&mut self, text: &[u8], block: &Block, request: &mut Request, switch: Switch) {
        let code = if switch == Switch::On { "G12.1" } else { "G13.1" };
        if let Some(other) = block.words.iter().find(|word| word.address != b'G' || !is_polar(word)) {
            let other_text = quote(text, other.span);
            self.report(Diagnostic::new(said::PolarNotAlone { code, other: other_text }, other.span));
            request.drop = true;
            self.leave_plane_refused(switch);
            return;
        }
        if switch == Switch::Off && self.state.virtual_plane.is_none() {
            // The reason why it was not switched on has been reported.
            return;
        }
        if self.compensates_at(block, code) {
            request.drop = true;
            self.leave_plane_refused(switch);
            return;
        }
        match switch {
            Switch::On => {
                self.connect_c(text, block.words_span());
                self.enter_plane(Surface::Face);
            }
            Switch::Off => self.leave_plane(),
        }
    }

    /// Whether compensation is active where a virtual plane begins or ends, which is reported.
    fn compensates_at(&mut self, block: &Block, code: &'static str) -> bool {
        let compensates = self.state.compensation != Compensation::Off;
        if compensates {
            self.report(Diagnostic::new(said::PlaneCompensation { code }, block.words_span()));
        }
        compensates
    }

    /// G07.1, with the radius of the cylinder in C; C0 ends it.
    pub(super) fn cylinder(&mut self, text: &[u8], block: &Block, request: &mut Request, words: &Words) {
        let reading = self.reading();
        let radius = words.get(b'C').and_then(|word| reading.length(word));
        let Some(radius) = radius.filter(|&radius| radius >= 0.0 && block.words.len() == 2) else {
            self.report(Diagnostic::new(said::CylinderFormat, block.words_span()));
            request.drop = true;
            if radius == Some(0.0) {
                self.leave_plane_refused(Switch::Off);
            }
            return;
        };
        if radius == 0.0 && self.state.virtual_plane.is_none() {
            // The reason why it was not switched on has been reported.
            return;
        }
        if self.compensates_at(block, "G07.1") {
            request.drop = true;
            self.leave_plane_refused(if radius == 0.0 { Switch::Off } else { Switch::On });
            return;
        }
        if radius == 0.0 {
            self.leave_plane();
            return;
        }
        if self.state.virtual_plane.is_some() {
            self.report(Diagnostic::new(said::CylinderFormat, block.words_span()));
            request.drop = true;
            return;
        }
        if self.state.motion == MotionMode::Rapid {
            let word = "G00".to_owned();
            self.report(Diagnostic::new(said::CylinderForbidden { word }, block.words_span()));
            request.drop = true;
            return;
        }
        self.connect_c(text, block.words_span());
        self.enter_plane(Surface::Cylinder { radius, turned: self.state.plane == Plane::Yz });
    }

    fn enter_plane(&mut self, surface: Surface) {
        self.settle();
        self.leave_flat();
        self.state.tip = None;
        self.state.reported.forget(Once::PlaneRapid);
        let (at, third) = surface.enter(self.state.position, self.state.y, self.state.c);
        self.state.position = at;
        self.state.virtual_plane = Some(VirtualPlane { surface, third: (third, third), angle: self.state.c });
    }

    /// Returns to the turning plane, with the tool at its position in the machine.
    pub(super) fn leave_plane(&mut self) {
        self.settle();
        if let Some(plane) = self.state.virtual_plane.take() {
            self.state.tip = None;
            self.state.compensating = None;
            self.state.position = plane.surface.machine(self.state.position, plane.third.1);
            self.state.c = plane.angle;
        }
    }

    /// A code that ends the plane was refused: the plane is left all the same, because the following blocks
    /// are written for the turning plane. One error, one message.
    fn leave_plane_refused(&mut self, switch: Switch) {
        if switch == Switch::Off && self.state.virtual_plane.is_some() {
            self.leave_plane();
            self.state.compensation = Compensation::Off;
        }
    }

    /// Checks a move in the virtual plane. False: an error was reported.
    pub(super) fn may_move_in_plane(&mut self, text: &[u8], block: &Block, words: &Words) -> bool {
        let Some(plane) = self.state.virtual_plane else { return true };
        if matches!(plane.surface, Surface::Flat(_)) {
            return true;
        }
        if !matches!(self.state.motion, MotionMode::Line | MotionMode::Arc(_)) {
            let word = match self.state.motion {
                MotionMode::Rapid => "G00".to_owned(),
                _ => quote(text, block.words_span()),
            };
            let message: Message = match plane.surface {
                Surface::Face => said::PolarForbidden { word }.into(),
                Surface::Cylinder { .. } | Surface::Flat(_) => said::CylinderForbidden { word }.into(),
            };
            if self.state.reported.first(Once::PlaneRapid) {
                self.report(Diagnostic::new(message, block.words_span()));
            }
            return false;
        }
        self.observe(text, Event::PlaneMove { block, words, plane });
        true
    }

    /// C moves: from here on C words are an axis, not a chamfer.
    fn connect_c(&mut self, text: &[u8], span: Span) {
        self.observe(text, Event::CAxis { span });
        self.state.c_axis = true;
    }

    /// The target angle of C and H outside a virtual plane, degrees; `None` if C does not move.
    pub(super) fn turn_target(&mut self, text: &[u8], words: &Words) -> Option<f64> {
        if !words.has_any(TURNS) || self.state.virtual_plane.is_some() {
            return None;
        }
        let is_axis =
            self.state.c_axis || self.state.motion == MotionMode::Rapid || words.peek(b'H').is_some();
        if !is_axis {
            return None;
        }
        let (reading, from) = (self.reading(), self.state.c);
        let (c, h) = match (words.get(b'C'), words.get(b'H')) {
            (Some(c), Some(h)) if self.absolute_counts(text, c, h) => (Some(c), None),
            (Some(_), Some(h)) => (None, Some(h)),
            one => one,
        };
        let absolute = c.and_then(|word| reading.degrees(word));
        let turned = h.and_then(|word| reading.degrees(word));
        let span = words.span(if absolute.is_some() { b'C' } else { b'H' });
        self.connect_c(&[], span);
        match (absolute, turned) {
            (Some(way), _) if self.state.incremental => Some(from + way),
            (absolute, turned) => absolute.or(turned.map(|turned| from + turned)),
        }
    }

    /// Adds the rotation of C to a motion outside a virtual plane.
    pub(super) fn turning(&mut self, motion: Motion, c: Option<f64>) -> Motion {
        let Some(to) = c else { return motion };
        let from = std::mem::replace(&mut self.state.c, to);
        let degree = self.state.unit.millimetres();
        let rotary = (from != to).then_some(Rotary { from, to, degree, virtual_move: None });
        Motion { rotary, ..motion }
    }

    /// The targets along the two axes of the path, upwards and to the right, from X, Z, C and their
    /// incremental words.
    pub(super) fn plane_targets(&mut self, text: &[u8], words: &Words) -> (Target, Target) {
        let Some(plane) = self.state.virtual_plane else {
            let x = self.axis(text, words, b'X', b'U', Counts::Diameter);
            return (x, self.axis(text, words, b'Z', b'W', Counts::Length));
        };
        let (up, right, third) = match plane.surface {
            Surface::Face => {
                let x_counts = match self.dialect.polar_x {
                    PolarX::Diameter => Counts::Diameter,
                    PolarX::Radius => Counts::Length,
                };
                let up = self.axis(text, words, b'C', b'H', Counts::Length);
                let right = self.axis(text, words, b'X', b'U', x_counts);
                (up, right, self.axis(text, words, b'Z', b'W', Counts::Length))
            }
            Surface::Cylinder { radius, .. } => {
                let reading = self.reading();
                let unrolled = |word: &Word| reading.degrees(word).map(|angle| radius * angle.to_radians());
                let up = match (words.get(b'C'), words.get(b'H')) {
                    (Some(c), _) if self.state.incremental => Target::Incremental(unrolled(c).unwrap_or(0.0)),
                    (Some(c), _) => Target::Absolute(unrolled(c).unwrap_or(0.0)),
                    (None, Some(h)) => Target::Incremental(unrolled(h).unwrap_or(0.0)),
                    (None, None) => Target::Stay,
                };
                let right = self.axis(text, words, b'Z', b'W', Counts::Length);
                (up, right, self.axis(text, words, b'X', b'U', Counts::Diameter))
            }
            Surface::Flat(flat) => {
                let x = self.axis(text, words, b'X', b'U', Counts::Diameter);
                let y = self.axis(text, words, b'Y', b'V', Counts::Length);
                let z = self.axis(text, words, b'Z', b'W', Counts::Length);
                match flat {
                    Flat::Xy => (y, x, z),
                    Flat::Zx => (x, z, y),
                    Flat::Yz => (z, y, x),
                }
            }
        };
        if let Some(plane) = &mut self.state.virtual_plane {
            let from = plane.third.1;
            plane.third = (from, third.from(from));
        }
        (up, right)
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
    pub(super) fn on_machine(&mut self, mut path_move: PathMove, third: (f64, f64)) -> PathMove {
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
}

fn is_polar(word: &Word) -> bool {
    let Value::Number { number, .. } = word.value else { return false };
    matches!((number.mantissa, number.decimals), (121 | 131, 1) | (112 | 113, 0))
}
