//! The words of a block that the control did not read: an axis that is not shown, or an ignored word.
//!
//! In: a block that was carried out, and which of its words were read ([`Words::unread`]). Out: a note about
//! the axis, and an event for the other words. Words that a machine-specific code or an unsupported function
//! may read are not reported.

use super::request::{OneShot, Request};
use super::{AXES, Interpreter, TURNS};
use crate::control::codes::{self, G, MotionMode, Plane};
use crate::control::events::Event;
use crate::control::modal::Once;
use crate::control::words::{Words, letters, plain, quote};
use crate::geometry::Turn;
use crate::message::{Diagnostic, Fix, Message, Severity, said};
use crate::parts::{Part, late};
use crate::setup::dialect::{CodeList, Control};
use crate::text::block::{Block, Value, Word};

/// Addresses that every code reads, or a later block: N and O, F, S and T.
const ALWAYS: u32 = letters(b"FNOST");

/// Addresses of the axes whose moves are shown.
const SHOWN_AXES: u32 = letters(b"CHYV");

/// Addresses of the axes that are not shown.
const OTHER_AXES: u32 = letters(b"AB");

late! {
    /// Reports the unread words of a block; `unread` contains their letters.
    pub(super) fn unread_words(
        control: &mut Interpreter,
        text: &[u8],
        block: &Block,
        request: &Request,
        words: &Words,
        unread: u32,
    ) {
        control.report_unread(text, block, request, words, unread);
    }

    /// Reports a corner word in a block without a path move: `,R2` in a block of G71, or alone.
    pub(super) fn unread_corner(
        control: &mut Interpreter,
        text: &[u8],
        block: &Block,
        request: &Request,
        words: &Words,
    ) {
        control.report_unread_corner(text, block, request, words);
    }
}

/// The part of the module that reports unread words. A run without it starts again when it is loaded, for the
/// lints.
pub(super) const UNREAD: Part = Part::Late;

impl Interpreter {
    fn report_unread(&mut self, text: &[u8], block: &Block, request: &Request, words: &Words, unread: u32) {
        let is_flat = self.state.virtual_plane.is_none() && self.state.plane != Plane::Zx;
        if is_flat || self.reads_all(request) || block.words.iter().any(|word| self.reads_others(word)) {
            return;
        }
        let unread = unread & !ALWAYS & !self.read_by_others(block, request, words);
        let is_cycle = matches!(request.one_shot, Some(OneShot::Multiple(_) | OneShot::Dwell))
            || request.one_shot.is_none()
                && self.state.hole.is_none()
                && matches!(self.state.motion, MotionMode::Cycle(_));
        if !is_cycle {
            for address in *b"AB" {
                if unread & letters(&[address]) != 0 {
                    self.other_axis(text, words, address);
                }
            }
        }
        let unread = if is_cycle { unread } else { unread & !OTHER_AXES };
        if unread != 0 {
            let code = self.code_of_block(request, words);
            self.observe(text, Event::UnreadWords { block, words, unread, code });
        }
    }

    /// Whether all words of a block may be read: by a macro, a machine-specific code or an unsupported
    /// function.
    fn reads_all(&self, request: &Request) -> bool {
        request.has_machine_m_code
            || request.call_code.is_some()
            || request.macro_call.is_some()
            || self.state.call_stack.modal.is_some()
            || matches!(request.one_shot, Some(OneShot::Data | OneShot::NotSupported))
    }

    fn report_unread_corner(&mut self, text: &[u8], block: &Block, request: &Request, words: &Words) {
        let is_path = request.one_shot.is_none()
            && self.state.hole.is_none()
            && (words.has_any(AXES | TURNS) || request.comma[2].is_some());
        let is_open = self.reads_all(request);
        let Some(index) = request.comma.into_iter().flatten().min().filter(|_| !is_path && !is_open) else {
            return;
        };
        let span = block.words[index].span;
        let word = quote(text, span);
        let message: Message = match self.code_of_block(request, words) {
            Some(code) => said::WordIgnored { word, code }.into(),
            None => said::WordNotRead { word }.into(),
        };
        self.report(Diagnostic::new(message, span).with(Fix::delete(text, span)));
    }

    /// Reports a word of an axis that is not shown: one note for each axis.
    fn other_axis(&mut self, text: &[u8], words: &Words, address: u8) {
        let once = if address == b'A' { Once::AxisA } else { Once::AxisB };
        if self.state.reported.mark_reported(once) {
            let (axis, word) = (address as char, words.quote(text, address));
            let note = Diagnostic::new(said::OtherAxis { word, axis }, words.span(address));
            self.report(note.with_severity(Severity::Info));
        }
    }

    /// Whether a code may read words that are unknown here.
    fn reads_others(&self, word: &Word) -> bool {
        let Value::Number { number, .. } = word.value else { return true };
        match word.address {
            b'M' => !matches!(number.mantissa, 0..=5 | 7..=9 | 30),
            b'G' => {
                let code = number.tenths().and_then(|key| codes::g_code(key, self.dialect.code_list()));
                code.is_none_or(|found| found.code == G::Idle)
            }
            _ => false,
        }
    }

    /// The letters of words that something other than the move of the block may read.
    fn read_by_others(&self, block: &Block, request: &Request, words: &Words) -> u32 {
        let mut read = 0;
        let code = |word: &Word| plain(word).filter(|_| word.address == b'G');
        let has_code = |from: f64, to: f64| {
            block.words.iter().any(|word| code(word).is_some_and(|code| (from..=to).contains(&code)))
        };
        let moves = request.one_shot.is_none() && self.state.hole.is_none();
        let is_path = matches!(self.state.motion, MotionMode::Rapid | MotionMode::Line | MotionMode::Arc(_));
        // L and D are the corner words of GSK.
        if self.dialect.control == Control::Gsk && moves && is_path {
            read |= letters(b"DL");
        }
        // K of GSK selects whether the contour is checked (GSK980TDb p. 100).
        if self.dialect.control == Control::Gsk && matches!(request.one_shot, Some(OneShot::Multiple(_))) {
            read |= letters(b"JK");
        }
        // D of G41 or T was an offset on other controls.
        if words.has_any(letters(b"T")) || has_code(40.0, 42.0) {
            read |= letters(b"D");
        }
        // P and Q give a spindle with S or M, P an axis with G96, and a frame with G54.
        let is_spindle = words.has_any(letters(b"S")) || block.words.iter().any(|word| word.address == b'M');
        if is_spindle || request.surface.is_some() || has_code(54.0, 59.0) {
            read |= letters(b"PQ");
        }
        // E is stored like F.
        if !words.has_any(AXES | TURNS) && request.one_shot.is_none() {
            read |= letters(b"E");
        }
        // An arc or a thread has no C word; if C is connected, it may turn during them.
        let takes_c = self.state.c_axis
            || self.state.virtual_plane.is_some()
            || matches!(self.state.motion, MotionMode::Rapid | MotionMode::Line);
        match request.one_shot {
            Some(OneShot::Multiple(_) | OneShot::Dwell) => {}
            _ if moves && !takes_c => read |= letters(b"YV"),
            _ => read |= SHOWN_AXES,
        }
        if request.one_shot == Some(OneShot::LocalFrame) {
            read |= AXES;
        }
        read
    }

    /// The code that reads the words of a block, in the spelling of list A; `None` if there is none, or if
    /// the list in force has another spelling.
    fn code_of_block(&self, request: &Request, words: &Words) -> Option<&'static str> {
        let is_list_a = matches!(self.dialect.code_list(), CodeList::A | CodeList::Gsk);
        let code = match request.one_shot {
            Some(OneShot::Dwell) => "G04",
            Some(OneShot::Home) => "G28",
            Some(OneShot::OtherHome) => "G30",
            Some(OneShot::CheckHome) => "G27",
            Some(OneShot::FromHome) => "G29",
            Some(OneShot::Machine) => "G53",
            Some(OneShot::LocalFrame) => "G52",
            Some(OneShot::Setting) if is_list_a => "G50",
            Some(OneShot::Multiple(cycle)) if is_list_a => cycle.cycle().code(),
            Some(_) => return None,
            None if !words.has_any(AXES | TURNS | letters(b"IJKR")) => return None,
            None => match (self.state.hole, self.state.motion) {
                (Some(hole), _) => hole.kind.code(),
                (None, MotionMode::Rapid) => "G00",
                (None, MotionMode::Line) => "G01",
                (None, MotionMode::Arc(Turn::Clockwise)) => "G02",
                (None, MotionMode::Arc(Turn::Counterclockwise)) => "G03",
                (None, MotionMode::Thread) => "G32",
                (None, MotionMode::Tapping) => "G33",
                (None, MotionMode::VariableThread) => "G34",
                (None, MotionMode::Cycle(cycle)) if is_list_a => cycle.cycle().code(),
                (None, MotionMode::Cycle(_)) => return None,
            },
        };
        Some(code)
    }
}
