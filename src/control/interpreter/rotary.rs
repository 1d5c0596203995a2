//! The C axis: as an axis of its own, and as the second axis of a virtual plane under polar (G12.1) and cylindrical
//! (G07.1) interpolation (seed 002, FANUC 15i B-63324EN p. 80).
//!
//! In: the words of a block. Out: moves of the path, in the plane while one is in force, and what the machine makes
//! of them.

use super::*;
use crate::control::modal::VirtualPlane;
use crate::geometry::Arc;
use crate::geometry::virtual_plane::{Surface, VirtualMove, Way};
use crate::motion::Rotary;
use crate::setup::dialect::PolarX;

/// Words that name the C axis.
pub(super) const TURNS: u32 = letters(b"CH");

/// Nearest to the centre that C can follow without running away, mm.
const CENTER: f64 = 0.1;

impl Interpreter {
    /// The G codes that may stand in polar or cylindrical interpolation; all others are an alarm.
    pub(super) fn may_stand_in_plane(&mut self, text: &[u8], code: G, word: &Word) -> bool {
        let Some(plane) = self.state.virtual_plane else { return true };
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
        self.tell(Diagnostic::new(
            match plane.surface {
                Surface::Face if frame => Message::PolarFrame { word: word_text },
                Surface::Face => Message::PolarForbidden { word: word_text },
                Surface::Cylinder { .. } => Message::CylinderForbidden { word: word_text },
            },
            word.span,
        ));
        false
    }

    /// A tool change or the end of the program, while a virtual plane is in force.
    pub(super) fn plane_left_on(&mut self, text: &[u8], span: Span) {
        let Some(plane) = self.state.virtual_plane else { return };
        let (code, face) = (quote(text, span), plane.surface == Surface::Face);
        let off = if face { "G13.1" } else { "G07.1 C0" };
        self.tell(Diagnostic::new(Message::PlaneLeftOn { code, off }, span));
    }

    /// G12.1 and G13.1.
    pub(super) fn polar(&mut self, text: &[u8], block: &Block, request: &mut Request, switch: Switch) {
        let code = if switch == Switch::On { "G12.1" } else { "G13.1" };
        if let Some(other) = block.words.iter().find(|word| word.address != b'G' || !is_polar(word)) {
            let other_text = quote(text, other.span);
            self.tell(Diagnostic::new(Message::PolarNotAlone { code, other: other_text }, other.span));
            request.drop = true;
            self.leave_plane_refused(switch);
            return;
        }
        if switch == Switch::Off && self.state.virtual_plane.is_none() {
            // What kept it from being switched on was reported.
            return;
        }
        if self.compensates_at(block, code) {
            request.drop = true;
            self.leave_plane_refused(switch);
            return;
        }
        match switch {
            Switch::On => {
                self.watch_c_axis(block.words_span());
                self.enter_plane(Surface::Face);
            }
            Switch::Off => self.leave_plane(),
        }
    }

    /// Whether compensation is on where a virtual plane begins or ends; reported.
    fn compensates_at(&mut self, block: &Block, code: &'static str) -> bool {
        let compensates = self.state.compensation != Compensation::Off;
        if compensates {
            self.tell(Diagnostic::new(Message::PlaneCompensation { code }, block.words_span()));
        }
        compensates
    }

    /// G07.1 with the radius of the cylinder as C; C0 ends it.
    pub(super) fn cylinder(&mut self, text: &[u8], block: &Block, request: &mut Request, words: &Words) {
        let reading = self.reading();
        let radius = words.get(b'C').and_then(|word| reading.length(word));
        let Some(radius) = radius.filter(|&radius| radius >= 0.0 && block.words.len() == 2) else {
            self.tell(Diagnostic::new(Message::CylinderFormat, block.words_span()));
            request.drop = true;
            if radius == Some(0.0) {
                self.leave_plane_refused(Switch::Off);
            }
            return;
        };
        if radius == 0.0 && self.state.virtual_plane.is_none() {
            // What kept it from being switched on was reported.
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
            self.tell(Diagnostic::new(Message::CylinderFormat, block.words_span()));
            request.drop = true;
            return;
        }
        if self.state.motion == MotionMode::Rapid {
            let word = "G00".to_owned();
            self.tell(Diagnostic::new(Message::CylinderForbidden { word }, block.words_span()));
            request.drop = true;
            return;
        }
        let _ = text;
        self.watch_c_axis(block.words_span());
        self.enter_plane(Surface::Cylinder { radius, turned: self.state.plane == Plane::Yz });
    }

    fn enter_plane(&mut self, surface: Surface) {
        self.settle();
        self.state.tip = None;
        self.state.told.forget(Once::PlaneRapid);
        let (at, third) = surface.enter(self.state.position, self.state.c);
        self.state.position = at;
        self.state.virtual_plane = Some(VirtualPlane { surface, third: (third, third), angle: self.state.c });
    }

    /// Back to the plane of turning: the tool stands where the machine has taken it.
    pub(super) fn leave_plane(&mut self) {
        self.settle();
        if let Some(plane) = self.state.virtual_plane.take() {
            self.state.tip = None;
            self.state.compensating = None;
            self.state.position = plane.surface.machine(self.state.position, plane.third.1);
            self.state.c = plane.angle;
        }
    }

    /// A code that ends the plane is refused: what follows is written for the plane of turning all the same. One fault,
    /// one message.
    fn leave_plane_refused(&mut self, switch: Switch) {
        if switch == Switch::Off && self.state.virtual_plane.is_some() {
            self.leave_plane();
            self.state.compensation = Compensation::Off;
        }
    }

    /// Checks before a move in the virtual plane. False: reported.
    pub(super) fn may_move_in_plane(&mut self, text: &[u8], block: &Block, words: &Words) -> bool {
        let Some(plane) = self.state.virtual_plane else { return true };
        if !matches!(self.state.motion, MotionMode::Line | MotionMode::Arc(_)) {
            let word = match self.state.motion {
                MotionMode::Rapid => "G00".to_owned(),
                _ => quote(text, block.words_span()),
            };
            let message = match plane.surface {
                Surface::Face => Message::PolarForbidden { word },
                Surface::Cylinder { .. } => Message::CylinderForbidden { word },
            };
            if self.state.told.first(Once::PlaneRapid) {
                self.tell(Diagnostic::new(message, block.words_span()));
            }
            return false;
        }
        self.watch_plane(text, block, words, plane);
        true
    }

    /// What an instructor would remark in a virtual plane.
    fn watch_plane(&mut self, text: &[u8], block: &Block, words: &Words, plane: VirtualPlane) {
        self.watch_live_tool(block);
        if plane.surface != Surface::Face {
            return;
        }
        if self.state.feed_mode == FeedMode::PerTurn && self.state.told.first(Once::PolarFeed) {
            self.tell(Diagnostic::new(Message::PolarFeedPerTurn, block.words_span()));
            // Not that the old F counts otherwise as well.
            self.state.feed_is_old = false;
        }
        if self.state.compensation != Compensation::Off
            && self.nose().radius == 0.0
            && self.state.told.first(Once::PolarRadius)
        {
            let span = block.words_span();
            self.tell(match self.unknown_offset() {
                Some(offset) => {
                    let message = Message::PolarRadiusUnknown { offset: u32::from(offset) };
                    Diagnostic::new(message, span).graded(Severity::Info)
                }
                None => Diagnostic::new(Message::PolarNoRadius, span),
            });
        }
        let reading = self.reading();
        if let Some((word, c)) = words.get(b'C').and_then(|word| Some((word, reading.length(word)?.abs()))) {
            let x = words.get(b'X').and_then(|word| reading.radius(word)).unwrap_or(self.state.position.z);
            let like_degrees = c >= 90.0 && c % 90.0 == 0.0 && x.abs() < c / 2.0;
            let outside = self.setup.stock.is_some_and(|stock| c > stock.diameter.mm());
            if (like_degrees || outside) && self.state.told.first(Once::PolarAngle) {
                let message = Message::PolarAngle { word: quote(text, word.span) };
                self.tell(Diagnostic::new(message, word.span));
            }
        }
    }

    /// A live tool should turn where the spindle only positions; which M code starts it depends on the machine.
    pub(super) fn watch_live_tool(&mut self, block: &Block) {
        if !self.state.spindle.live_tool && !self.state.unknown_m && self.state.told.first(Once::LiveTool) {
            // It is reported for the live tool, not for the spindle as well.
            self.state.told.first(Once::SpindleStopped);
            self.tell(Diagnostic::new(Message::LiveToolStopped, block.words_span()));
        }
    }

    /// C moves though nothing has connected it: which M code does depends on the machine.
    fn watch_c_axis(&mut self, span: Span) {
        if !self.state.c_axis && !self.state.unknown_m && self.state.told.first(Once::CAxis) {
            self.tell(Diagnostic::new(Message::CAxisNotConnected, span));
        }
        self.state.c_axis = true;
    }

    /// The angle that C and H name outside a virtual plane, degrees; `None` where C stays.
    pub(super) fn turn_target(&mut self, words: &Words) -> Option<f64> {
        if !words.has_any(TURNS) || self.state.virtual_plane.is_some() {
            return None;
        }
        let is_axis =
            self.state.c_axis || self.state.motion == MotionMode::Rapid || words.get(b'H').is_some();
        if !is_axis {
            return None;
        }
        let (reading, from) = (self.reading(), self.state.c);
        let absolute = words.get(b'C').and_then(|word| reading.degrees(word));
        let turned = words.get(b'H').and_then(|word| reading.degrees(word));
        let span = words.span(if absolute.is_some() { b'C' } else { b'H' });
        self.watch_c_axis(span);
        match (absolute, turned) {
            (Some(way), _) if self.state.incremental => Some(from + way),
            (absolute, turned) => absolute.or(turned.map(|turned| from + turned)),
        }
    }

    /// Gives a motion its part of C, outside a virtual plane.
    pub(super) fn turning(&mut self, motion: Motion, c: Option<f64>) -> Motion {
        let Some(to) = c else { return motion };
        let from = std::mem::replace(&mut self.state.c, to);
        Motion { rotary: (from != to).then_some(Rotary { from, to, virtual_move: None }), ..motion }
    }

    /// What X, Z, C and their incremental words say of the two axes of the path: upwards and to the right.
    pub(super) fn plane_targets(&mut self, text: &[u8], words: &Words) -> (Target, Target) {
        let Some(plane) = self.state.virtual_plane else {
            let x = self.axis(text, words, b'X', b'U', 0.5);
            return (x, self.axis(text, words, b'Z', b'W', 1.0));
        };
        let (up, right, third) = match plane.surface {
            Surface::Face => {
                let scale = if self.dialect.polar_x == PolarX::Diameter { 0.5 } else { 1.0 };
                let up = self.axis(text, words, b'C', b'H', 1.0);
                let right = self.axis(text, words, b'X', b'U', scale);
                (up, right, self.axis(text, words, b'Z', b'W', 1.0))
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
                let right = self.axis(text, words, b'Z', b'W', 1.0);
                (up, right, self.axis(text, words, b'X', b'U', 0.5))
            }
        };
        if let Some(plane) = &mut self.state.virtual_plane {
            let from = plane.third.1;
            plane.third = (from, third.from(from));
        }
        (up, right)
    }

    /// A motion of a block, on its way through the pipeline.
    #[inline]
    pub(super) fn routed(&self, block: &Block, motion: Motion) -> Routed {
        let third = self.state.virtual_plane.map(|plane| plane.third);
        Routed { motion, span: block.span, words: block.words_span(), line: block.line, third, stop: None }
    }

    /// What the machine does for a motion of a virtual plane.
    #[cold]
    pub(super) fn on_machine(&mut self, mut routed: Routed, third: (f64, f64)) -> Routed {
        let Some(plane) = &mut self.state.virtual_plane else { return routed };
        let motion = &mut routed.motion;
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
        plane.angle += plane.surface.turn_along(&way);
        let own = VirtualMove { surface: plane.surface, way, third };
        motion.rotary = Some(Rotary { from, to: plane.angle, virtual_move: Some(own) });
        (motion.from, motion.to, motion.center) = (own.at(0.0), own.at(1.0), None);
        let distance = way.distance_from_center();
        if plane.surface == Surface::Face && distance < CENTER && self.state.told.first(Once::PolarCenter) {
            self.tell(Diagnostic::new(Message::PolarCenter { distance }, routed.words));
        }
        routed
    }
}

fn is_polar(word: &Word) -> bool {
    let Value::Number { number, .. } = word.value else { return false };
    matches!((number.mantissa, number.decimals), (121 | 131, 1) | (112 | 113, 0))
}
