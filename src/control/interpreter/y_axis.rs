//! The Y axis: moves outside the plane of X and Z, and the planes of G17 and G19 (seed 002, figure 5-5).
//!
//! In: the words of a block. Out: moves of X, Y and Z if the machine has a Y axis; otherwise the messages of
//! a lathe without one. The state is in a Y plane only during a block, or while compensation or a corner
//! waits for the next move in it. All other code finds the state in the turning plane, with Y as a separate
//! value.

use super::request::Request;
use super::rotary::TURNS;
use super::{AXES, Interpreter};
use crate::control::codes::{Compensation, MotionMode, Plane};
use crate::control::doubt::{Doubt, Doubts};
use crate::control::modal::{Once, VirtualPlane};
use crate::control::second_axis;
use crate::control::words::{Words, letters, quote};
use crate::geometry::virtual_plane::{Flat, Space, Surface, VirtualMove, Way};
use crate::geometry::{Point, SAME};
use crate::message::{Diagnostic, Severity, said};
use crate::motion::{Motion, MotionKind, Rotary};
use crate::parts::{Part, early};
use crate::text::block::{Block, Word};

/// The part of the module that makes moves along Y.
const Y_AXIS: Part = Part::Early;

/// Words that move Y.
const Y: u32 = letters(b"YV");

early! {
    fn move_beside(control: &mut Interpreter, text: &[u8], block: &Block, request: &mut Request, words: &Words) -> bool {
        control.move_beside(text, block, request, words)
    }

    fn name_y(control: &mut Interpreter, text: &[u8], block: &Block, words: &Words) {
        control.name_y(text, block, words);
    }

    fn go_along_y(control: &mut Interpreter, text: &[u8], block: &Block, word: &Word, y: f64) {
        control.go_along_y(text, block, word, y);
    }

    fn back_to_turning(control: &mut Interpreter) {
        control.back_to_turning();
    }
}

impl Interpreter {
    /// A block with Y, or with Y not at 0, or in a plane other than the turning plane. True: it is done.
    #[cold]
    pub(super) fn moves_beside_plane(
        &mut self,
        text: &[u8],
        block: &Block,
        request: &mut Request,
        words: &Words,
    ) -> bool {
        self.has(Y_AXIS) && move_beside(self, text, block, request, words)
    }

    /// Y and V in a block whose code uses the other words.
    pub(super) fn other_axes(&mut self, text: &[u8], block: &Block, words: &Words) {
        if words.has_any(Y) && self.has(Y_AXIS) {
            name_y(self, text, block, words);
        }
    }

    /// Moves the tip to a position along Y, mm.
    pub(super) fn move_y(&mut self, text: &[u8], block: &Block, word: &Word, y: f64) {
        if self.has(Y_AXIS) {
            go_along_y(self, text, block, word, y);
        }
    }

    /// Returns from a Y plane to the turning plane.
    #[inline]
    pub(super) fn leave_flat(&mut self) {
        if self.state.virtual_plane.is_some_and(|plane| matches!(plane.surface, Surface::Flat(_))) {
            back_to_turning(self);
        }
    }

    fn move_beside(&mut self, text: &[u8], block: &Block, request: &mut Request, words: &Words) -> bool {
        let (mode, is_hole) = (self.state.motion, self.state.hole.is_some());
        let interpolates = self.state.interpolation().is_some();
        let is_path = !is_hole && matches!(mode, MotionMode::Rapid | MotionMode::Line | MotionMode::Arc(_));
        let is_arc = !is_hole && matches!(mode, MotionMode::Arc(_));
        let takes_y = words.has_any(Y) && (is_hole || !matches!(mode, MotionMode::Cycle(_)));
        if !self.setup.machine.has_y() {
            if takes_y {
                self.name_y(text, block, words);
            }
            let is_here = self.state.plane == Plane::Zx || interpolates;
            if is_here || !is_arc || !words.has_any(AXES | TURNS | letters(b"IJKR")) {
                return false;
            }
            if self.state.reported.first(Once::PlaneNotHere) {
                let word = if self.state.plane == Plane::Xy { "G17" } else { "G19" };
                self.report(Diagnostic::new(said::PlaneNotHere { word }, block.words_span()));
            }
            request.drop = true;
            return true;
        }
        let spindle = &self.state.spindle;
        let cuts_itself = self.state.c_axis || spindle.live_tool;
        let mills = self.state.plane != Plane::Zx
            && (is_arc || cuts_itself || self.state.compensation != Compensation::Off);
        let leaves = self.y_named(words).is_some_and(|(_, y)| y.abs() > SAME);
        let is_beside = self.state.y != 0.0 || leaves || self.is_in_flat();
        if interpolates || !is_path || self.contours.recorded.is_some() {
            if is_beside && (takes_y || !interpolates && self.makes_moves(words)) {
                self.y_is_not_done(text, block, words);
            }
            return false;
        }
        let centre = if is_arc { letters(b"IJKR") } else { 0 };
        if !words.has_any(AXES | Y | centre) || !(is_beside || mills) {
            self.leave_flat();
            return false;
        }
        if is_arc && self.state.plane == Plane::Zx && self.is_arc_along_y(text, words) {
            self.y_is_not_done(text, block, words);
            return true;
        }
        if words.has_any(TURNS) {
            // C turns independently of the plane.
            self.leave_flat();
        }
        let c = self.turn_target(text, words);
        self.enter_flat(match self.state.plane {
            Plane::Xy => Flat::Xy,
            Plane::Zx => Flat::Zx,
            Plane::Yz => Flat::Yz,
        });
        self.state.c = c.unwrap_or(self.state.c);
        match mode {
            MotionMode::Arc(turn) => self.arc(text, block, request, words, turn),
            MotionMode::Line => self.line(text, block, request, words),
            _ => self.rapid(text, block, request, words),
        }
        request.moved |= !request.drop;
        if self.state.pending.is_none() && self.state.compensating.is_none() {
            self.leave_flat();
        }
        let is_named = words.peek(b'Y').is_some() && !self.state.incremental;
        if is_named || self.state.y.abs() <= SAME {
            self.state.doubts.remove(Doubt::Y);
        }
        true
    }

    /// Whether an arc of G18 with R goes only along Y, which controls handle differently.
    fn is_arc_along_y(&mut self, text: &[u8], words: &Words) -> bool {
        let moves = self.y_named(words).is_some_and(|(_, y)| (y - self.state.y).abs() > SAME);
        moves && words.get(b'R').is_some() && self.target(text, words).is_same(self.state.position)
    }

    fn is_in_flat(&self) -> bool {
        self.state.virtual_plane.is_some_and(|plane| matches!(plane.surface, Surface::Flat(_)))
    }

    /// Whether a block moves X or Z with the codes in force.
    fn makes_moves(&self, words: &Words) -> bool {
        words.has_any(AXES) || self.state.hole.is_some() && words.has_any(TURNS)
    }

    /// The last Y word of a block, and its target, mm.
    fn y_named<'b>(&self, words: &Words<'b>) -> Option<(&'b Word, f64)> {
        let reading = self.reading();
        let mut named = None;
        for address in [b'Y', b'V'] {
            let Some(word) = words.get(address) else { continue };
            let way = reading.length(word).unwrap_or(0.0);
            let absolute = address == b'Y' && !self.state.incremental;
            named = Some((word, if absolute { way } else { self.state.y + way }));
        }
        named
    }

    /// Y and V as a separate move, in a block whose code moves only X and Z. A target of Y0 changes nothing on a
    /// machine without a Y axis.
    fn name_y(&mut self, text: &[u8], block: &Block, words: &Words) {
        if let Some((word, y)) = self.y_named(words) {
            self.go_along_y(text, block, word, y);
        }
    }

    /// Whether a block of polar interpolation has Y as its second axis; reported once.
    #[cold]
    pub(super) fn names_second_axis_y(&mut self, text: &[u8], block: &Block) -> bool {
        let Some(word) = second_axis::named_y(block, &self.state, &self.setup.machine) else { return false };
        if self.state.reported.first(Once::SecondAxisY) {
            let message = said::SecondAxisY { word: quote(text, word.span) };
            self.report(Diagnostic::new(message, word.span).graded(Severity::Info));
        }
        true
    }

    /// With a Y axis: a rapid to a position along Y. Without one: a position other than Y0 is reported once,
    /// and the motion of X and Z is drawn as uncertain.
    fn go_along_y(&mut self, text: &[u8], block: &Block, word: &Word, y: f64) {
        if self.setup.machine.has_y() {
            self.rapid_along_y(block, y);
            return;
        }
        self.state.y = y;
        if y.abs() <= SAME {
            self.state.doubts.remove(Doubt::Y);
            return;
        }
        if self.state.reported.first(Once::AxisNotHere) {
            let message = said::AxisNotHere { word: quote(text, word.span) };
            self.report(Diagnostic::new(message, word.span));
        }
        self.lose(Doubts::of(&[Doubt::Y]));
    }

    /// The reference point of Y is over the spindle axis.
    pub(super) fn y_goes_home(&mut self, block: &Block) {
        if self.setup.machine.has_y() && self.state.y != 0.0 {
            self.rapid_along_y(block, 0.0);
        }
        self.state.y = 0.0;
        self.state.doubts.remove(Doubt::Y);
    }

    /// A rapid of only Y.
    fn rapid_along_y(&mut self, block: &Block, y: f64) {
        if (y - self.state.y).abs() > SAME {
            let at = self.state.position;
            let own = VirtualMove {
                surface: Surface::Flat(Flat::Zx),
                way: Way::Line(at, at),
                third: (self.state.y, y),
            };
            let rotary =
                Some(Rotary { from: self.state.c, to: self.state.c, degree: 1.0, virtual_move: Some(own) });
            let motion = Motion { rotary, ..self.motion(MotionKind::Rapid, at) };
            self.push(block, motion);
        }
        self.state.y = y;
    }

    /// Something outside Y0 that is only supported at Y0: it is drawn at Y0, and everything after it is
    /// uncertain until Y is 0.
    fn y_is_not_done(&mut self, text: &[u8], block: &Block, words: &Words) {
        let named = self.y_named(words);
        if self.state.reported.first(Once::AxisNotHere) {
            let span = named.map_or_else(|| block.words_span(), |(word, _)| word.span);
            self.not_supported(text, span);
        }
        self.state.y = named.map_or(self.state.y, |(_, y)| y);
        self.lose(Doubts::of(&[Doubt::Y]));
    }

    fn enter_flat(&mut self, flat: Flat) {
        let surface = Surface::Flat(flat);
        if self.state.virtual_plane.is_some_and(|plane| plane.surface == surface) {
            return;
        }
        self.leave_compensation();
        self.leave_flat();
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
