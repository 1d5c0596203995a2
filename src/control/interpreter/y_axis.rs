//! The Y axis: moves outside the plane of X and Z, and the planes of G17 and G19 (seed 002, figure 5-5).
//!
//! In: the words of a block. Out: moves of X, Y and Z if the machine has a Y axis; otherwise the messages of
//! a lathe without one. The state is in a Y plane only during a block, or while compensation or a corner
//! waits for the next move in it. All other code finds the state in the turning plane, with Y as a separate
//! value.

use super::Interpreter;
use crate::control::doubt::{Doubt, Doubts};
use crate::control::modal::Once;
use crate::control::second_axis;
use crate::control::words::{Words, letters, quote};
use crate::geometry::SAME;
use crate::geometry::virtual_plane::{Flat, Surface, VirtualMove, Way};
use crate::message::{Diagnostic, Severity, said};
use crate::motion::{Motion, MotionKind, Rotary};
use crate::parts::{Part, early};
use crate::text::block::{Block, Word};

/// The part of the module that makes moves along Y.
pub(super) const Y_AXIS: Part = Part::Early;

/// Words that move Y.
pub(super) const Y: u32 = letters(b"YV");

early! {
    fn apply_y_word(control: &mut Interpreter, text: &[u8], block: &Block, words: &Words) {
        control.apply_y_word(text, block, words);
    }

    fn go_along_y(control: &mut Interpreter, text: &[u8], block: &Block, word: &Word, y: f64) {
        control.go_along_y(text, block, word, y);
    }
}

impl Interpreter {
    /// Y and V in a block whose code uses the other words.
    pub(super) fn other_axes(&mut self, text: &[u8], block: &Block, words: &Words) {
        if words.has_any(Y) && self.has(Y_AXIS) {
            apply_y_word(self, text, block, words);
        }
    }

    /// Moves the tip to a position along Y, mm.
    pub(super) fn move_y(&mut self, text: &[u8], block: &Block, word: &Word, y: f64) {
        if self.has(Y_AXIS) {
            go_along_y(self, text, block, word, y);
        }
    }

    /// The last Y word of a block, and its target, mm.
    pub(super) fn y_named<'b>(&self, words: &Words<'b>) -> Option<(&'b Word, f64)> {
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
    pub(super) fn apply_y_word(&mut self, text: &[u8], block: &Block, words: &Words) {
        if let Some((word, y)) = self.y_named(words) {
            self.go_along_y(text, block, word, y);
        }
    }

    /// Whether a block of polar interpolation has Y as its second axis; reported once.
    #[cold]
    pub(super) fn names_second_axis_y(&mut self, text: &[u8], block: &Block) -> bool {
        let Some(word) = second_axis::named_y(block, &self.state, &self.setup.machine) else { return false };
        if self.state.reported.mark_reported(Once::SecondAxisY) {
            let message = said::SecondAxisY { word: quote(text, word.span) };
            self.report(Diagnostic::new(message, word.span).with_severity(Severity::Info));
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
        if self.state.reported.mark_reported(Once::AxisNotHere) {
            let message = said::AxisNotHere { word: quote(text, word.span) };
            self.report(Diagnostic::new(message, word.span));
        }
        self.add_doubts(Doubts::of(&[Doubt::Y]));
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
}
