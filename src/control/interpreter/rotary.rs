//! The C axis: as a separate axis, and as the second axis of a virtual plane in polar (G12.1) and cylindrical
//! (G07.1) interpolation (seed 002, FANUC 15i B-63324EN p. 80).
//!
//! In: the words of a block. Out: moves of the path, in the virtual plane while one is in force, and the
//! machine's motions for them.

use super::Interpreter;
use super::request::Request;
use crate::control::codes::{Compensation, G, MotionMode, Plane, Switch};
use crate::control::events::Event;
use crate::control::modal::{Once, VirtualPlane};
use crate::control::words::{Words, quote};
use crate::geometry::virtual_plane::Surface;
use crate::message::{Diagnostic, Message, said};
use crate::source::Span;
use crate::text::block::{Block, Value, Word};

impl Interpreter {
    /// Whether a G code is allowed in polar or cylindrical interpolation; all others raise an alarm.
    pub(super) fn allowed_in_plane(&mut self, text: &[u8], code: G, word: &Word) -> bool {
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
        self.leave_y_plane();
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
        self.flush_pending();
        self.leave_y_plane();
        self.state.tip = None;
        self.state.reported.reset(Once::PlaneRapid);
        let (at, third) = surface.enter(self.state.position, self.state.y, self.state.c);
        self.state.position = at;
        self.state.virtual_plane = Some(VirtualPlane { surface, third: (third, third), angle: self.state.c });
    }

    /// Returns to the turning plane, with the tool at its position in the machine.
    pub(super) fn leave_plane(&mut self) {
        self.flush_pending();
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
            if self.state.reported.mark_reported(Once::PlaneRapid) {
                self.report(Diagnostic::new(message, block.words_span()));
            }
            return false;
        }
        self.observe(text, Event::PlaneMove { block, words, plane });
        true
    }
}

fn is_polar(word: &Word) -> bool {
    let Value::Number { number, .. } = word.value else { return false };
    matches!((number.mantissa, number.decimals), (121 | 131, 1) | (112 | 113, 0))
}
