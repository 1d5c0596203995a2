//! G and M words: their immediate effect, and their part of the block's request.
//!
//! In: one word after the other. Out: the modal state, and the [`Request`] of the block.

use super::Interpreter;
use super::request::{CallCode, Exclusive, OneShot, Request};
use crate::control::codes::{self, Compensation, G, M, MotionMode, Switch};
use crate::control::contour::ContourUse;
use crate::control::doubt::{Doubt, Doubts};
use crate::control::events::Event;
use crate::control::words::{self, Words, quote};
use crate::control::words::{letters, letters_of};
use crate::message::{Diagnostic, Fix, Severity, said};
use crate::motion::{Quill, SpindleTurn};
use crate::parts::{Part, early};
use crate::source::Span;
use crate::text::block::{Block, Value, Word};

impl Interpreter {
    /// Reads one word: codes change the request and the modal state, data words are stored for later.
    #[inline]
    pub(super) fn read_word<'b>(
        &mut self,
        text: &[u8],
        block: &'b Block,
        request: &mut Request,
        words: &mut Words<'b>,
        index: usize,
        word: &Word,
    ) {
        let Value::Number { number, .. } = word.value else { return };
        let is_argument = request.macro_call.is_some() || request.arguments;
        if is_argument || (word.address == b'H' && request.length_offset) {
            return;
        }
        if let Some(wrong) = words::check(text, word) {
            let wrong = if self.dialect.strict { wrong.with_severity(Severity::Error) } else { wrong };
            request.drop |= wrong.is_error();
            let carried_out = !wrong.is_error();
            self.report(wrong);
            if !carried_out {
                return;
            }
        }
        match word.address {
            b'G' if number.mantissa == 7 && is_diameter_mode(word, block) => {}
            b'G' => self.read_g(text, request, number.tenths(), word),
            b'M' => self.read_m(text, request, number.mantissa, word),
            b'C' if word.comma => request.comma[0] = Some(index),
            b'R' if word.comma => request.comma[1] = Some(index),
            b'A' if word.comma => request.comma[2] = Some(index),
            _ if word.comma => {
                let text = quote(text, word.span);
                self.report(Diagnostic::new(said::NotUnderstood { text }, word.span));
                request.drop = true;
            }
            address => {
                if let Some(before) = words.take(index, word) {
                    let used = quote(text, block.words[index].span);
                    let message = said::DuplicateWord { address: address as char, used };
                    let fixes = [before.span, word.span].map(|span| Fix::delete(text, span));
                    let duplicate = Diagnostic::new(message, word.span);
                    request.duplicates.push(Diagnostic { fixes: fixes.into(), ..duplicate });
                }
            }
        }
    }

    /// Reports addresses that appear twice. Both blocks of a cycle in one line are a single error.
    #[cold]
    pub(super) fn report_duplicates(&mut self, text: &[u8], block: &Block, request: &mut Request) {
        let duplicates = std::mem::take(&mut request.duplicates);
        if self.has(Part::Early) && !cycle_in_one_block(self, text, block, request) {
            duplicates.into_iter().for_each(|duplicate| self.report(duplicate));
        }
    }

    fn read_g(&mut self, text: &[u8], request: &mut Request, tenths: Option<u64>, word: &Word) {
        let Some(found) = tenths.and_then(|key| codes::g_code(key, self.dialect.code_list())) else {
            self.unknown_g(text, request, tenths, word);
            return;
        };
        let group = match found.group {
            1 => Some(Exclusive::Motion),
            2 => Some(Exclusive::Surface),
            5 => Some(Exclusive::Feed),
            7 => Some(Exclusive::Compensation),
            _ => None,
        };
        if let (Some(group), Some(key)) = (group, tenths) {
            self.note_group(text, request, group, key, word.span);
        }
        if self.state.virtual_plane.is_some() && !self.allowed_in_plane(text, found.code, word) {
            request.drop = true;
            return;
        }
        let state = &mut self.state;
        match found.code {
            G::Polar(switch) => request.one_shot = Some(OneShot::Polar(switch)),
            G::Cylinder => request.one_shot = Some(OneShot::Cylinder),
            G::Motion(mode) => {
                request.motion = Some(mode);
            }
            G::Hole(hole) => request.hole = Some(hole),
            G::NoHole => {
                if let Some(hole) = state.hole.take() {
                    state.motion = hole.before;
                }
            }
            G::HoleReturn(level) => state.hole_return = level,
            G::MacroCall(call) => request.macro_call = Some(call),
            G::NoModalMacro => state.call_stack.modal = None,
            G::Distance { incremental } => state.incremental = incremental,
            G::OtherHome => request.one_shot = Some(OneShot::OtherHome),
            G::CheckHome => request.one_shot = Some(OneShot::CheckHome),
            G::FromHome => request.one_shot = Some(OneShot::FromHome),
            G::Machine => request.one_shot = Some(OneShot::Machine),
            G::Data => request.one_shot = Some(OneShot::Data),
            G::EndOfData => {}
            G::ExtendedFrame => request.extended_frame = Some(word.span),
            G::Dwell => request.one_shot = Some(OneShot::Dwell),
            G::Home => request.one_shot = Some(OneShot::Home),
            G::Setting => request.one_shot = Some(OneShot::Setting),
            G::LocalFrame => request.one_shot = Some(OneShot::LocalFrame),
            G::Multiple(cycle) => request.one_shot = Some(OneShot::Multiple(cycle)),
            G::Plane(plane) if plane != state.plane && state.compensation != Compensation::Off => {
                self.report(Diagnostic::new(said::CompensationPlane, word.span));
                request.drop = true;
            }
            G::Plane(plane) => state.plane = plane,
            G::Unit(unit) => state.unit = unit,
            // Roughing cycles ignore compensation in their contour (GSK980TDb p. 102).
            G::Compensation(compensation) if self.contours.purpose == Some(ContourUse::Roughing) => {
                let before = std::mem::replace(&mut self.contours.ignored_compensation, compensation);
                request.ends_compensation |= compensation == Compensation::Off && before != compensation;
            }
            G::Compensation(compensation) => {
                request.switches_compensation = compensation != state.compensation;
                request.ends_compensation =
                    request.switches_compensation && compensation == Compensation::Off;
                state.compensation = compensation;
                self.observe(text, Event::Compensation);
            }
            G::Frame(frame) => {
                self.change_frame(|frames| frames.active = frame);
            }
            G::SurfaceSpeed => request.surface = Some(true),
            G::ConstantSpeed => request.surface = Some(false),
            G::Feed(mode) => {
                self.observe(text, Event::FeedMode(mode));
                self.state.feed_mode = mode;
            }
            // Switches off a function that makes coordinates doubtful.
            G::Idle if matches!(tenths, Some(150 | 501 | 502 | 690 | 691)) => self.clear_coordinate_doubts(),
            G::Idle => {}
            G::NotSupported => {
                request.one_shot = Some(OneShot::NotSupported);
                request.unsupported = tenths;
                self.not_supported(text, word.span);
            }
        }
    }

    /// A G code that this control does not have: an alarm, or, for numbers that machine builders use, a note
    /// that it depends on the machine.
    #[inline(never)]
    fn unknown_g(&mut self, text: &[u8], request: &mut Request, tenths: Option<u64>, word: &Word) {
        let quoted = quote(text, word.span);
        // Tool length offsets of mills: a lathe has them in the T word, and some machines with a B axis in
        // G43. The other words of the block take effect.
        if matches!(tenths, Some(430 | 440)) {
            request.length_offset = true;
            self.report(Diagnostic::new(said::LengthOffset { word: quoted }, word.span));
            return;
        }
        if tenths.is_some_and(|key| codes::is_of_machine(key, self.dialect.code_list())) {
            request.arguments = true;
            self.report(Diagnostic::new(said::MakerG { word: quoted }, word.span));
            self.doubt_after_missing_program();
            return;
        }
        let is_limit = tenths == Some(500);
        let meant = match tenths {
            // The speed limit of system A; the other systems write G92.
            Some(500) => Some("G92"),
            // A thread: G32 in system A, G33 in the other systems.
            Some(320) => Some("G33"),
            Some(330) => Some("G32"),
            _ => None,
        };
        let fix = meant.map(|code| Fix::write(word.span, code.to_owned()));
        let unknown = Diagnostic::new(said::UnknownG { word: quoted }, word.span);
        self.report(Diagnostic { fixes: fix.into_iter().collect(), ..unknown });
        if is_limit {
            request.one_shot = Some(OneShot::Setting);
        } else if meant.is_some() {
            request.motion = Some(MotionMode::Thread);
        }
        // It may have been a code of group 01.
        self.add_doubts(Doubts::of(&[Doubt::Code]));
        request.drop = true;
    }

    /// Two different codes of a group in a block: the last is effective, but M05 takes effect at the end of
    /// the block.
    fn note_group(&mut self, text: &[u8], request: &mut Request, group: Exclusive, key: u64, span: Span) {
        const STOP: u64 = 5;
        if let Some((other, before)) = request.group_words[group as usize].replace((key, span))
            && other != key
        {
            let (mut dropped, mut used) = (quote(text, before), quote(text, span));
            if group == Exclusive::Spindle && other == STOP {
                std::mem::swap(&mut dropped, &mut used);
            }
            let fixes = [before, span].map(|span| Fix::delete(text, span));
            let diagnostic = Diagnostic::new(said::SameGroup { dropped, used }, span);
            self.report(Diagnostic { fixes: fixes.into(), ..diagnostic });
        }
    }

    #[inline(never)]
    fn read_m(&mut self, text: &[u8], request: &mut Request, number: u64, word: &Word) {
        let code = codes::m_code(number);
        if matches!(code, Some(M::Spindle(_))) {
            self.note_group(text, request, Exclusive::Spindle, number, word.span);
        }
        self.observe(text, Event::MCode { number, known: code, word });
        let state = &mut self.state;
        state.m_code = number.min(u64::from(u32::MAX)) as u32;
        request.changes_tool |= number == 6;
        match code {
            Some(M::Spindle(SpindleTurn::Stopped)) => request.stop_spindle = true,
            Some(M::Spindle(turn)) => {
                state.spindle.turn = turn;
                state.spindle.is_stopped = false;
                state.spindle.is_held = false;
                // A turning spindle is not an axis.
                state.c_axis = false;
            }
            Some(M::Orientation) => state.spindle.is_held = true,
            Some(M::LiveTool) => state.spindle.live_tool = true,
            Some(M::ThreadPullOut(switch)) => state.thread_chamfer_on = switch == Switch::On,
            // The quill comes forward after the block, so it is not an obstacle for this block.
            Some(M::Quill(Quill::Forward)) => request.extends_quill = true,
            Some(M::Quill(quill)) => state.quill = quill,
            Some(M::End) => request.end = true,
            Some(M::CAxis(switch)) => state.c_axis = switch == Switch::On,
            Some(M::Pause(kind)) => request.stop = Some(kind),
            Some(M::Idle) => {}
            Some(M::Call) => request.call_code = Some(CallCode::Call),
            Some(M::LocalCall) => request.call_code = Some(CallCode::LocalCall),
            Some(M::Return) => request.call_code = Some(CallCode::Return),
            None => {
                request.has_machine_m_code = true;
                self.report(Diagnostic::new(said::UnknownM { word: quote(text, word.span) }, word.span));
            }
        }
    }
}

early! {
    /// Reports and drops a block that contains both blocks of a cycle; false for other blocks.
    fn cycle_in_one_block(control: &mut Interpreter, text: &[u8], block: &Block, request: &mut Request) -> bool {
        let Some(OneShot::Multiple(cycle)) = request.one_shot.filter(|_| request.macro_call.is_none()) else {
            return false;
        };
        let spec = cycle.spec();
        let second = |word: &Word| letters(&[word.address]) & spec.cuts_with != 0;
        let at = block.words.iter().position(second).unwrap_or(0);
        let (before, behind) = block.words.split_at(at);
        let is_in_both = letters_of(before) & letters_of(behind) & spec.first_letters() != 0;
        let Some(begins) = behind.first().filter(|_| is_in_both) else { return false };
        let list = control.dialect.code_list();
        let is_cycle = |word: &&Word| {
            let Value::Number { number, .. } = word.value else { return false };
            let code =
                number.tenths().filter(|_| word.address == b'G').and_then(|key| codes::g_code(key, list));
            code.is_some_and(|found| found.code == G::Multiple(cycle)) && word.span.start < begins.span.start
        };
        let code = block.words.iter().rfind(is_cycle).map(|word| quote(text, word.span));
        let fix = code.map(|code| Fix::insert(begins.span.start, format!("\n{code} ")));
        let message = said::CycleInOneBlock { code: cycle.cycle().code() };
        let diagnostic = Diagnostic::new(message, block.words_span());
        control.report(Diagnostic { fixes: fix.into_iter().collect(), ..diagnostic });
        request.drop = true;
        true
    }
}

/// `G7` of LinuxCNC: X is a diameter, as it always is here. FANUC writes G07, and names the axis that becomes
/// hypothetical.
fn is_diameter_mode(word: &Word, block: &Block) -> bool {
    word.span.len() == 2
        && block.words.iter().all(|word| matches!(word.address, b'G' | b'M' | b'S' | b'T' | b'F'))
}
