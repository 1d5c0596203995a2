//! G90, G92 and G94 as blocks call them: memory, spellings of the taper, checks (seeds 000, 001 and 004).

use super::cycle_moves::{Thread, angle_of_start};
use super::repairs::offer_other_sign;
use super::request::Request;
use super::{AXES, Interpreter};
use crate::control::compensation::{Axis, cycle_shift};
use crate::control::doubt::Doubt;
use crate::control::events::{Event, SinglePass};
use crate::control::modal::Target;
use crate::control::tool_offset;
use crate::control::words::{self, Counts, Words, quote};
use crate::cycles::Move;
use crate::cycles::single::{self, PullOut, Single, Work};
use crate::geometry::Point;
use crate::message::{Diagnostic, Fix, Message, Severity, said};
use crate::motion::{CycleStep, Motion};
use crate::parts::{Part, late};
use crate::setup::dialect::{Control, IInG92};
use crate::source::Span;
use crate::text::block::Block;
use crate::units::Diameter;

/// The part of the module that formats numbers for messages.
const QUOTING: Part = Part::Late;

late! {
    fn taper_word(taper: f64) -> String {
        format!("R{}", crate::units::number(taper))
    }
}

impl Interpreter {
    /// G90, G92, G94 (seeds 000, 001 and 004).
    #[inline(never)]
    pub(super) fn cycle(
        &mut self,
        text: &[u8],
        block: &Block,
        request: &mut Request,
        words: &Words,
        cycle: Single,
    ) {
        let reading = self.reading();
        let taper = self.taper_word(words, cycle).and_then(|address| words.get(address));
        if let Some(value) = taper.and_then(|word| reading.length(word)) {
            self.state.memory.taper = value;
        }
        if cycle.is_thread() && self.dialect.i_in_g92 == IInG92::Taper && words.peek(b'I').is_some() {
            self.observe(text, Event::OldTaperWord { words });
        }
        if !words.has_any(AXES) {
            self.observe(text, Event::CycleWithoutAxis { words, cycle, taper });
            return;
        }
        if let Some(index) = request.comma.into_iter().flatten().next() {
            let span = block.words[index].span;
            let word = quote(text, span);
            let diagnostic = match cycle.work() {
                Work::Threading => {
                    Diagnostic::new(said::CornerInThread { word }, span).with(Fix::delete(text, span))
                }
                Work::Turning | Work::Facing => Diagnostic::new(said::CornerNoLine { word }, span),
            };
            self.report(diagnostic);
            request.drop = true;
            return;
        }
        let other = [b'Y', b'V', b'C', b'H'].into_iter().find(|&address| words.peek(address).is_some());
        if let Some(address) = other {
            let message = said::CycleAxis { code: cycle.cycle().code(), word: words.quote(text, address) };
            let fix = Fix::delete(text, words.span(address));
            self.report(Diagnostic::new(message, words.span(address)).with(fix));
            request.drop = true;
            return;
        }
        match self.axis(text, words, b'X', b'U', Counts::Diameter) {
            Target::Stay => {}
            target => self.state.memory.x = target,
        }
        match self.axis(text, words, b'Z', b'W', Counts::Length) {
            Target::Stay => {}
            target => self.state.memory.z = target,
        }
        self.flush_before_cycle();
        let start = self.state.position;
        let memory = self.state.memory;
        let end = Point::new(memory.x.from(start.x), memory.z.from(start.z));
        if end.is_same(start) && memory.taper == 0.0 {
            // `U0 W0` after a header with G90: nothing to cut.
            return;
        }
        let taper_span = taper.map_or_else(|| block.words_span(), |word| word.span);
        let taper_word = |control: &Self| match taper {
            Some(word) => words::quote(text, word.span),
            // The taper of an earlier block.
            None => {
                let taper = control.state.memory.taper / control.state.unit.millimetres();
                // Without the part no messages are shown.
                if QUOTING.is_loaded() { taper_word(taper) } else { String::new() }
            }
        };
        let own_word = taper.map(|word| (text, word.span));
        if !self.taper_fits(cycle, start, end, taper_span, own_word, taper_word) {
            request.drop = true;
            return;
        }
        let lead = match cycle.work() {
            Work::Threading => {
                let lead = self.lead(text, block, words, "G92");
                if lead.is_some() {
                    self.observe(text, Event::Thread { block, code: "G92", to: None });
                }
                lead.filter(|_| self.has_whole_angle(text, words))
            }
            Work::Turning | Work::Facing => None,
        };
        let may_cut = match cycle.work() {
            Work::Threading => lead.is_some(),
            Work::Turning | Work::Facing => self.may_cut(text, block, words, request),
        };
        let (taper_word, starts) = (self.taper_word(words, cycle), self.starts(words, cycle));
        if may_cut {
            let pass = SinglePass { block, words, cycle, start, end, taper_word, taper_span, lead, starts };
            self.observe(text, Event::SinglePass(pass));
        } else {
            // Its moves are known in spite of the error.
            request.drop = true;
            self.state.doubts.add(Doubt::Cycle);
        }
        let own_angle = if cycle.is_thread() { self.start_angle(words) } else { 0.0 };
        for start_number in 0..starts {
            self.state.memory.passes += 1;
            let pass = self.state.memory.passes;
            match cycle {
                Single::Threading => {
                    let pull_out = lead.and_then(|lead| self.pull_out(words, lead));
                    let moves = single::threading(start, end, memory.taper, pull_out);
                    let start_angle = own_angle + angle_of_start(start_number, starts);
                    let thread = lead.map(|lead| Thread { lead, start_angle });
                    self.run_moves(block, cycle, pass, thread, &moves);
                }
                Single::Facing => {
                    let begin = Point::new(start.x, end.z + memory.taper);
                    let end = Point::new(end.x, end.z + self.nose_shift(begin, end, Axis::Z));
                    self.run_moves(block, cycle, pass, None, &single::facing(start, end, memory.taper));
                }
                Single::Turning => {
                    let begin = Point::new(end.x + memory.taper, start.z);
                    let end = Point::new(end.x + self.nose_shift(begin, end, Axis::X), end.z);
                    self.run_moves(block, cycle, pass, None, &single::turning(start, end, memory.taper));
                }
            }
        }
    }

    /// Shift, mm, of a straight cut along an axis due to compensation, so that the nose touches the
    /// programmed line; 0 without compensation or radius.
    fn nose_shift(&self, from: Point, to: Point, along: Axis) -> f64 {
        let Some(side) = self.side() else { return 0.0 };
        cycle_shift(side, tool_offset::nose(&self.state, &self.setup), from, to, along).unwrap_or(0.0)
    }

    /// The address of the taper in a block of a cycle: R, or its older spelling.
    pub(super) fn taper_word(&self, words: &Words, cycle: Single) -> Option<u8> {
        let old = match cycle.work() {
            Work::Turning => Some(b'I'),
            Work::Facing => Some(b'K'),
            Work::Threading => (self.dialect.i_in_g92 == IInG92::Taper).then_some(b'I'),
        };
        [Some(b'R'), old].into_iter().flatten().find(|&address| words.peek(address).is_some())
    }

    /// Checks the taper against the start point. `own_word`: the text, and the span of the taper word if this
    /// block has one. Errors are reported at `span`.
    pub(super) fn taper_fits(
        &mut self,
        cycle: Single,
        start: Point,
        end: Point,
        span: Span,
        own_word: Option<(&[u8], Span)>,
        word: impl FnOnce(&Self) -> String,
    ) -> bool {
        let taper = self.state.memory.taper;
        let way = match cycle.work() {
            Work::Turning | Work::Threading => end.x - start.x,
            Work::Facing => end.z - start.z,
        };
        if single::begins_beyond_start(way, taper) {
            // GSK documents it as an error (seed 000); no FANUC alarm is known for it.
            let error = self.dialect.control == Control::Gsk || self.dialect.strict;
            let severity = if error { Severity::Error } else { Severity::Warning };
            let word = word(self);
            let message: Message = match cycle.work() {
                Work::Turning | Work::Threading => {
                    said::TaperBeyondHalf { word, limit: Diameter::from_radius(way).mm() }.into()
                }
                Work::Facing => said::TaperBeyondLength { word, limit: way }.into(),
            };
            let mut diagnostic = Diagnostic::new(message, span).with_severity(severity);
            // With the opposite sign the cut begins inside the start point and has the same end.
            let crosses_axis = cycle.work() != Work::Facing && end.x > 0.0 && end.x < taper;
            if let Some((text, place)) = own_word
                && !crosses_axis
            {
                diagnostic = offer_other_sign(diagnostic, text, place);
            }
            self.report(diagnostic);
            return !error;
        }
        true
    }

    /// How G92 leaves the thread: J and K (GSK), or the chamfer in tenths of a lead.
    pub(super) fn pull_out(&self, words: &Words, lead: f64) -> Option<PullOut> {
        let reading = self.reading();
        let gsk = self.dialect.control == Control::Gsk;
        let given =
            |address: u8| if gsk { words.get(address).and_then(|word| reading.length(word)) } else { None };
        match (given(b'J'), given(b'K')) {
            (None, None) => self.chamfer(lead),
            (j, k) => {
                let (j, k) = (j.map(f64::abs), k.map(f64::abs));
                Some(PullOut { along: k.or(j).unwrap_or(0.0), out: j.or(k).unwrap_or(0.0) })
            }
        }
    }

    fn run_moves(&mut self, block: &Block, cycle: Single, pass: u32, thread: Option<Thread>, moves: &[Move]) {
        for step in moves {
            let tag = CycleStep { cycle: cycle.cycle(), pass, step: step.step };
            let motion = Motion { cycle: Some(tag), ..self.motion(step.kind, step.to) };
            let mut motion = thread.map_or(motion, |thread| thread.of(motion));
            motion.process.uncertain |= self.state.doubts.has(Doubt::Cycle);
            self.push(block, motion);
        }
    }
}
