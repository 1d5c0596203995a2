//! One block: what kind it is, what its words request, and where the program continues.
//!
//! In: a block. Out: its [`Request`] carried out.

use super::contours::contour_use_of;
use super::macros::Statement;
use super::request::{OneShot, Request};
use super::trace::{keep_block, keep_process};
use super::unread::{UNREAD, unread_corner, unread_words};
use super::{AXES, BlockPosition, Flow, Interpreter, TURNS};
use crate::control::codes::{Compensation, MotionMode, Plane};
use crate::control::doubt::Doubt;
use crate::control::events::Event;
use crate::control::modal::{CycleMemory, MACROS, Once};
use crate::control::second_axis::with_c;
use crate::control::words::{Words, letters, plain, quote};
use crate::geometry::Point;
use crate::message::{Diagnostic, Message, Severity, said};
use crate::motion::{Quill, SpindleTurn};
use crate::parts::early;
use crate::text::block::{Block, BlockKind, Word};

/// The words of M97, M98 and M99, which a modal cycle or a move in the same block does not use.
const OF_CALL: u32 = letters(b"LPQ");

early! {
    fn words_with_expressions(control: &mut Interpreter, text: &[u8], block: &Block, here: BlockPosition) -> Flow {
        control.words_with_expressions(text, block, here)
    }
}

impl Interpreter {
    /// Carries out one block.
    pub fn run(&mut self, text: &[u8], block: &Block, here: BlockPosition) -> Flow {
        if self.contours.recorded.is_none() && !self.count_block(block) {
            return Flow::End;
        }
        self.carry_out(text, block, here)
    }

    fn carry_out(&mut self, text: &[u8], block: &Block, here: BlockPosition) -> Flow {
        if block.delete.is_some_and(|level| self.setup.block_skip.contains(&level)) {
            self.report_faults(block);
            return Flow::Next;
        }
        if block.optional.is_some_and(|(_, level)| self.setup.block_skip.contains(&level)) {
            return self.carry_out(text, &without_optional(block), here);
        }
        self.sink.fault = None;
        let broken = (!block.faults.is_empty() || block.is_unread) && {
            self.report_faults(block);
            block.is_broken()
        };
        if self.trace.is_some() {
            keep_block(self, block, here);
        }
        self.state.sequence = block.sequence.unwrap_or(self.state.sequence);
        match block.kind {
            BlockKind::Percent => return Flow::Next,
            BlockKind::Macro if broken => {
                self.doubt_statement(block.span.of(text));
                return Flow::Next;
            }
            BlockKind::Macro => {
                return match self.macro_statement(text, block, here) {
                    Statement::Done(flow) => flow,
                    Statement::Words(own) => self.words_of(text, &own, here),
                };
            }
            BlockKind::Words => {}
        }
        if self.state.data_input {
            let ends = |word: &Word| word.address == b'G' && plain(word) == Some(11.0);
            self.state.data_input = !block.words.iter().any(ends);
            return Flow::Next;
        }
        if block.words.is_empty() {
            if !block.comments.is_empty() {
                self.look_for_other_end(text, block, None);
            }
            // Blocks that can only be text make no moves; any other broken block may have been a motion.
            if broken && block.faults.iter().any(|fault| !super::doubts::is_text(fault)) {
                self.suppress_missing_feed(text, block);
                self.add_doubts(super::doubts::faults_of(text, block));
            }
            return Flow::Next;
        }
        if block.is_overlong() {
            return self.partly_read_block(text, block, here);
        }
        if self.state.virtual_plane.is_some() && self.names_second_axis_y(text, block) {
            return self.words_of(text, &with_c(block), here);
        }
        self.words_of(text, block, here)
    }

    /// A block of which only the first words could be parsed. These take effect. Nothing more is reported for
    /// the block, nor for settings that its other words may have made.
    #[cold]
    fn partly_read_block(&mut self, text: &[u8], block: &Block, here: BlockPosition) -> Flow {
        self.sink.muted = true;
        let flow = self.words_of(text, block, here);
        self.sink.muted = false;
        for once in [Once::NoFeed, Once::FeedZero] {
            self.state.reported.mark_reported(once);
        }
        self.observe(&[], Event::SettingsUnknown);
        flow
    }

    /// Carries out a block of words, some of which may have expressions as values.
    #[inline]
    fn words_of(&mut self, text: &[u8], block: &Block, here: BlockPosition) -> Flow {
        if !block.has_expressions {
            return self.words(text, block, here);
        }
        if self.has(MACROS) { words_with_expressions(self, text, block, here) } else { Flow::Next }
    }

    fn words_with_expressions(&mut self, text: &[u8], block: &Block, here: BlockPosition) -> Flow {
        if let Some(operation) = self.macro_a_of(text, block).filter(|_| !block.is_broken()) {
            return self.macro_a(text, block, here, operation);
        }
        self.uses_unknown_value = false;
        let own = self.evaluated(text, block);
        if std::mem::take(&mut self.uses_unknown_value) && !self.sink.muted {
            // Messages about such values do not apply to the macro.
            self.sink.muted = true;
            let flow = self.evaluated_words(text, block, own, here);
            self.sink.muted = false;
            return flow;
        }
        self.evaluated_words(text, block, own, here)
    }

    /// Carries out a block with the values of its expressions. `None`: an expression has no value, which was
    /// reported.
    fn evaluated_words(
        &mut self,
        text: &[u8],
        block: &Block,
        own: Option<Block>,
        here: BlockPosition,
    ) -> Flow {
        match own {
            Some(own) => {
                if self.trace.is_some() {
                    self.trace_values(&own, &block.words);
                }
                if !self.state.doubts.has(Doubt::Values) {
                    return self.words(text, &own, here);
                }
                // Values from variables are as doubtful as the variables.
                let doubtful = Self::from_variables(block);
                self.add_doubts(doubtful);
                let flow = self.words(text, &own, here);
                self.add_doubts(doubtful);
                flow
            }
            None => {
                self.trace_nothing();
                self.add_doubts(Self::from_variables(block));
                if self.sink.is_full() { Flow::End } else { Flow::Next }
            }
        }
    }

    /// Carries out a block of words.
    #[inline]
    fn words(&mut self, text: &[u8], block: &Block, here: BlockPosition) -> Flow {
        let broken = block.is_broken();
        let mut request = Request { drop: broken, ..Request::default() };
        let mut words = Words::new(block);
        for (index, word) in block.words.iter().enumerate() {
            self.read_word(text, block, &mut request, &mut words, index, word);
        }
        if !request.duplicates.is_empty() {
            self.report_duplicates(text, block, &mut request);
        }
        if request.arguments {
            words = Words::new(block);
        }
        self.set_feed_speed_tool(text, block, &request, &words);
        request.wall = if request.ends_compensation { self.wall_of(&words) } else { None };
        self.state.spindle.may_turn |= request.has_machine_m_code;
        self.state.spindle.machine_code_with_speed |=
            request.has_machine_m_code && words.has_any(letters(b"SP"));
        if self.trace.is_some() {
            keep_process(self);
        }
        if request.drop {
            if let Some(mode) = request.motion {
                self.enter(text, mode, block, &words);
            }
            // The speed limit of a G50 that does not exist in this system takes effect: no consequences are
            // reported.
            if !broken && request.one_shot == Some(OneShot::Setting) && !words.has_any(AXES) {
                self.setting(text, &words);
            }
            self.refuse(text, block, &request, &words);
            self.forget_next_move();
            if let Some(OneShot::Multiple(cycle)) = request.one_shot {
                self.skip_contour(text, block, &words);
                if self.program.jump.is_some() {
                    self.contour_of_broken(text, block, &words, cycle, Self::run);
                }
            }
        } else {
            if !self.state.doubts.is_empty() {
                self.doubt_block(&request, &words);
            }
            let before = self.state.doubts;
            let without_call;
            let of_move = if request.call_code.is_some() && request.one_shot.is_none() {
                without_call = words.without(OF_CALL);
                &without_call
            } else {
                &words
            };
            self.make_motions(text, block, &mut request, of_move);
            let unread = words.unread();
            if request.drop {
                self.refuse(text, block, &request, &words);
            } else {
                if unread != 0 && UNREAD.is_loaded() {
                    unread_words(self, text, block, &request, &words, unread);
                }
                if request.comma != [None; 3] && UNREAD.is_loaded() {
                    unread_corner(self, text, block, &request, &words);
                }
                if !self.state.doubts.is_empty() {
                    self.clear_doubts(&request, &words, before);
                }
                if self.state.call_stack.main_pass.absolute_axes != [true; 2] {
                    self.note_absolute_axes(&request, &words);
                }
            }
        }
        if !request.moved {
            self.idle_block();
        }
        if self.state.compensation != Compensation::Off || self.state.compensating.is_some() {
            self.observe(text, Event::CompensatedBlock { block, moved: request.moved });
        }
        if request.stop.is_some() || !block.comments.is_empty() {
            self.look_for_other_end(text, block, request.stop);
        }
        if let Some(kind) = request.stop {
            self.stop(block, kind);
        }
        if request.end {
            self.end_of_program(text, block);
        }
        if request.stop_spindle {
            self.observe(text, Event::SpindleStops { block, moved: request.moved });
            self.state.spindle.is_stopped |= self.state.spindle.turn != SpindleTurn::Stopped;
            self.state.spindle.turn = SpindleTurn::Stopped;
            self.state.spindle.is_held = false;
            self.state.spindle.live_tool = false;
            self.state.spindle.machine_code_with_speed = false;
            self.state.spindle.may_turn = false;
        }
        if request.extends_quill {
            self.state.quill = Quill::Forward;
        }
        match (self.program.jump.take(), request.call_code) {
            _ if request.end || self.sink.is_full() => Flow::End,
            (Some(at), _) => {
                if self.trace.is_some() {
                    self.trace_contour(at.byte);
                }
                Flow::Jump(at)
            }
            // A call in a contour was already reported.
            (None, _) if self.contours.recorded.is_some() => Flow::Next,
            (None, Some(call_code)) => self.carry_out_call(text, block, &words, call_code, here),
            (None, None) => match request.macro_call {
                Some(call) => self.macro_call(text, block, here, call),
                None if request.moved && self.state.call_stack.modal.is_some() => {
                    self.modal_call(block, here.next).unwrap_or(Flow::Next)
                }
                None => Flow::Next,
            },
        }
    }

    /// Records, for the pass of the main program, which axes the block has moved to an absolute position.
    #[cold]
    fn note_absolute_axes(&mut self, request: &Request, words: &Words) {
        for (index, axis) in [Doubt::X, Doubt::Z].into_iter().enumerate() {
            let is_placed = self.ends_at_place(request, words, axis);
            self.state.call_stack.main_pass.absolute_axes[index] |= is_placed;
        }
    }

    /// M02, M30.
    #[inline(never)]
    fn end_of_program(&mut self, text: &[u8], block: &Block) {
        self.flush_pending();
        let end = block.words.iter().rfind(|word| word.address == b'M');
        self.observe(text, Event::ProgramEnds { end });
        self.plane_left_on(text, end.map_or_else(|| block.words_span(), |word| word.span));
        self.state.compensation = Compensation::Off;
    }

    /// Coordinate systems, motion, cycles.
    fn make_motions(&mut self, text: &[u8], block: &Block, request: &mut Request, words: &Words) {
        if let Some(mode) = request.motion {
            self.enter(text, mode, block, words);
        }
        if let Some(span) = request.extended_frame {
            self.extended_frame(text, request, words, span);
        }
        if let Some(hole) = request.hole {
            self.enter_hole(hole, block.words_span());
        }
        if request.macro_call.is_some() {
            return;
        }
        if let Some(one_shot) = request.one_shot {
            self.one_shot(text, block, request, words, one_shot);
            return;
        }
        let beside = words.has_any(letters(b"YV")) || self.state.y != 0.0 || self.state.plane != Plane::Zx;
        if beside && self.carry_out_with_y(text, block, request, words) {
            return;
        }
        if self.state.hole.is_some() {
            self.hole(text, block, request, words);
            return;
        }
        if self.state.virtual_plane.is_some()
            && words.has_any(AXES | TURNS)
            && !self.may_move_in_plane(text, block, words)
        {
            request.drop = true;
            return;
        }
        match self.state.motion {
            MotionMode::Rapid if words.has_any(AXES | TURNS) => self.rapid(text, block, request, words),
            MotionMode::Line if words.has_any(AXES | TURNS | letters(b"A")) || request.comma[2].is_some() => {
                self.line(text, block, request, words);
            }
            MotionMode::Arc(turn) if words.has_any(AXES | TURNS | letters(b"IJKR")) => {
                self.arc(text, block, request, words, turn)
            }
            MotionMode::Thread | MotionMode::VariableThread | MotionMode::Tapping if words.has_any(AXES) => {
                self.thread(text, block, request, words);
            }
            MotionMode::Cycle(cycle) => self.cycle(text, block, request, words, cycle),
            _ => {}
        }
    }

    /// The direction of the wall given by I and K of a G40 block (FANUC 16-TC B-61804E 15.3.4).
    fn wall_of(&self, words: &Words) -> Option<Point> {
        let length = |address: u8| words.get(address).and_then(|word| self.reading().length(word));
        let (i, k) = (length(b'I'), length(b'K'));
        Some(Point::new(i.unwrap_or(0.0), k.unwrap_or(0.0))).filter(|_| i.is_some() || k.is_some())
    }

    /// Carries out a code that uses the words of its block.
    #[inline(never)]
    fn one_shot(
        &mut self,
        text: &[u8],
        block: &Block,
        request: &mut Request,
        words: &Words,
        one_shot: OneShot,
    ) {
        if one_shot != OneShot::Dwell {
            self.state.memory = CycleMemory { passes: self.state.memory.passes, ..CycleMemory::EMPTY };
            self.observe(text, Event::OneShot);
        }
        if let (OneShot::Setting | OneShot::Data | OneShot::Dwell, Some(word)) = (one_shot, words.get(b'T')) {
            // Old controls accept T with G50; it was common there, especially with the speed limit.
            let taken = one_shot == OneShot::Setting && !self.dialect.strict;
            let only_speed = taken && !words.has_any(letters(b"XZUW"));
            let word_text = quote(text, word.span);
            let message: Message = match only_speed {
                true => said::ToolWithHighestSpeed { word: word_text }.into(),
                false => said::ToolWithSetting { word: word_text }.into(),
            };
            let diagnostic = Diagnostic::new(message, word.span);
            self.report(match (taken, only_speed) {
                (true, true) => diagnostic.with_severity(Severity::Info),
                (true, false) => diagnostic.with_severity(Severity::Warning),
                (false, _) => diagnostic,
            });
            if !taken {
                request.drop = true;
                return;
            }
        }
        if !self.allowed_with_hole(text, block, one_shot) {
            request.drop = true;
            return;
        }
        match one_shot {
            OneShot::Dwell | OneShot::Polar(_) | OneShot::Cylinder => {}
            OneShot::Multiple(cycle) => {
                self.observe(text, Event::MultipleCycle { block, cycle });
                self.flush_before_cycle();
            }
            OneShot::Home | OneShot::OtherHome | OneShot::CheckHome | OneShot::Machine => {
                if words.has_any(AXES) {
                    self.observe(text, Event::MachinePlace { block });
                }
                self.leave_compensation();
            }
            _ => self.leave_compensation(),
        }
        match one_shot {
            OneShot::Dwell => self.dwell(text, block, words, request),
            OneShot::Home | OneShot::OtherHome => self.home(text, block, request, words),
            OneShot::CheckHome => self.check_home(text, block, request, words),
            OneShot::FromHome => self.leave_home(text, block, request, words),
            OneShot::Machine => self.machine_move(text, block, request, words),
            OneShot::Data => self.write_data(text, request, words),
            OneShot::Setting => self.setting(text, words),
            OneShot::LocalFrame => self.local_frame(words),
            OneShot::Polar(switch) => self.polar(text, block, request, switch),
            OneShot::Cylinder => self.cylinder(text, block, request, words),
            OneShot::Multiple(cycle) => {
                let purpose = contour_use_of(cycle, words).filter(|_| self.contours.recorded.is_none());
                let code = cycle.cycle().code();
                let shape =
                    purpose.and_then(|purpose| self.shape(text, block, words, code, purpose, Self::run));
                self.multiple(text, block, request, words, cycle, shape);
            }
            OneShot::NotSupported => self.doubt_after_unsupported(request.unsupported, words),
        }
    }

    /// A code of group 01 comes into force.
    fn enter(&mut self, text: &[u8], mode: MotionMode, block: &Block, words: &Words) {
        match mode {
            MotionMode::Cycle(cycle) => self.observe(text, Event::CycleCode { cycle, block, words }),
            mode if mode != self.state.motion => self.observe(text, Event::MotionCode { mode }),
            _ => {}
        }
        let state = &mut self.state;
        state.hole = None;
        if !state.doubts.is_empty() {
            state.doubts.remove(Doubt::Code);
        }
        match (mode, state.motion) {
            (MotionMode::Cycle(new), MotionMode::Cycle(old)) => {
                // Repeated, the code resets the taper but keeps the end point (seed 000).
                state.memory.taper = 0.0;
                if new != old {
                    state.memory.passes = 0;
                }
            }
            _ => state.memory = CycleMemory::EMPTY,
        }
        state.motion = mode;
    }
}

/// The block if the slash within it takes effect.
fn without_optional(block: &Block) -> Block {
    let mut rest = block.clone();
    if let Some((first, _)) = rest.optional.take() {
        rest.words.truncate(first);
    }
    rest
}
