//! Moves of a block that names Y, or runs beside the plane of X and Z.

use super::request::Request;
use super::y_axis::{Y, Y_AXIS};
use super::{AXES, Interpreter, TURNS};
use crate::control::codes::{Compensation, MotionMode, Plane};
use crate::control::doubt::{Doubt, Doubts};
use crate::control::modal::Once;
use crate::control::words::{Words, letters};
use crate::geometry::SAME;
use crate::geometry::virtual_plane::Flat;
use crate::message::{Diagnostic, said};
use crate::parts::early;
use crate::text::block::Block;

early! {
    fn move_with_y(control: &mut Interpreter, text: &[u8], block: &Block, request: &mut Request, words: &Words) -> bool {
        control.move_with_y(text, block, request, words)
    }
}

impl Interpreter {
    /// A block with Y, or with Y not at 0, or in a plane other than the turning plane. True: it is done.
    #[cold]
    pub(super) fn carry_out_with_y(
        &mut self,
        text: &[u8],
        block: &Block,
        request: &mut Request,
        words: &Words,
    ) -> bool {
        self.has(Y_AXIS) && move_with_y(self, text, block, request, words)
    }

    fn move_with_y(&mut self, text: &[u8], block: &Block, request: &mut Request, words: &Words) -> bool {
        let (mode, is_hole) = (self.state.motion, self.state.hole.is_some());
        let interpolates = self.state.interpolation().is_some();
        let is_path = !is_hole && matches!(mode, MotionMode::Rapid | MotionMode::Line | MotionMode::Arc(_));
        let is_arc = !is_hole && matches!(mode, MotionMode::Arc(_));
        let takes_y = words.has_any(Y) && (is_hole || !matches!(mode, MotionMode::Cycle(_)));
        if !self.setup.machine.has_y() {
            if takes_y {
                self.apply_y_word(text, block, words);
            }
            let is_here = self.state.plane == Plane::Zx || interpolates;
            if is_here || !is_arc || !words.has_any(AXES | TURNS | letters(b"IJKR")) {
                return false;
            }
            if self.state.reported.mark_reported(Once::PlaneNotHere) {
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
        let is_beside = self.state.y != 0.0 || leaves || self.is_in_y_plane();
        if interpolates || !is_path || self.contours.recorded.is_some() {
            if is_beside && (takes_y || !interpolates && self.makes_moves(words)) {
                self.y_not_supported(text, block, words);
            }
            return false;
        }
        let centre = if is_arc { letters(b"IJKR") } else { 0 };
        if !words.has_any(AXES | Y | centre) || !(is_beside || mills) {
            self.leave_y_plane();
            return false;
        }
        if is_arc && self.state.plane == Plane::Zx && self.is_arc_along_y(text, words) {
            self.y_not_supported(text, block, words);
            return true;
        }
        if words.has_any(TURNS) {
            // C turns independently of the plane.
            self.leave_y_plane();
        }
        let c = self.turn_target(text, words);
        self.enter_y_plane(match self.state.plane {
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
            self.leave_y_plane();
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

    /// Whether a block moves X or Z with the codes in force.
    fn makes_moves(&self, words: &Words) -> bool {
        words.has_any(AXES) || self.state.hole.is_some() && words.has_any(TURNS)
    }

    /// Something outside Y0 that is only supported at Y0: it is drawn at Y0, and everything after it is
    /// uncertain until Y is 0.
    fn y_not_supported(&mut self, text: &[u8], block: &Block, words: &Words) {
        let named = self.y_named(words);
        if self.state.reported.mark_reported(Once::AxisNotHere) {
            let span = named.map_or_else(|| block.words_span(), |(word, _)| word.span);
            self.not_supported(text, span);
        }
        self.state.y = named.map_or(self.state.y, |(_, y)| y);
        self.add_doubts(Doubts::of(&[Doubt::Y]));
    }
}
