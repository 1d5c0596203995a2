//! G90, G92 and G94 as blocks call them: memory, spellings of the taper, checks (seeds 000, 001 and 004).

use super::*;
use crate::control::compensation::{Axis, cycle_shift};
use crate::control::doubt::Doubt;
use crate::lint;

/// A span longer than this, bytes, is a block and not the word of a taper.
const LONGEST_WORD: usize = 12;

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
        if cycle == Single::Threading
            && self.dialect.i_in_g92 == IInG92::Taper
            && words.get(b'I').is_some()
            && self.state.told.first(Once::LetterIInG92)
        {
            let word = words.quote(text, b'I');
            let fix = Fix::write(words.span(b'I'), format!("R{}", words::behind_letter(&word)));
            self.tell(Diagnostic::new(Message::LetterIInG92, words.span(b'I')).with(fix));
        }
        if !words.has_any(AXES) {
            self.watch_axis_missing(text, words, cycle, taper);
            return;
        }
        if let Some(index) = request.comma.into_iter().flatten().next() {
            let span = block.words[index].span;
            let word = quote(text, span);
            let told = match cycle {
                Single::Threading => {
                    Diagnostic::new(Message::CornerInThread { word }, span).with(Fix::delete(text, span))
                }
                Single::Turning | Single::Facing => Diagnostic::new(Message::CornerNoLine { word }, span),
            };
            self.tell(told);
            request.drop = true;
            return;
        }
        let other = [b'Y', b'V', b'C', b'H'].into_iter().find(|&address| words.get(address).is_some());
        if let Some(address) = other {
            let message = Message::CycleAxis { code: cycle.cycle().code(), word: words.quote(text, address) };
            let fix = Fix::delete(text, words.span(address));
            self.tell(Diagnostic::new(message, words.span(address)).with(fix));
            request.drop = true;
            return;
        }
        match self.axis(text, words, b'X', b'U', 0.5) {
            Target::Stay => {}
            target => self.state.memory.x = target,
        }
        match self.axis(text, words, b'Z', b'W', 1.0) {
            Target::Stay => {}
            target => self.state.memory.z = target,
        }
        let named = block.words.iter().rfind(|word| matches!(word.address, b'X' | b'U' | b'Z' | b'W'));
        self.state.memory.named =
            named.map(|word| if matches!(word.address, b'X' | b'U') { Axis::X } else { Axis::Z });
        self.arrive_for_cycle();
        let start = self.state.position;
        let memory = self.state.memory;
        let end = Point::new(memory.x.from(start.x), memory.z.from(start.z));
        if end.is_same(start) && memory.taper == 0.0 {
            // `U0 W0` after a header with G90: nothing to cut.
            return;
        }
        if let Some(span) = self.state.g90_alone.take()
            && self.state.told.first(Once::G90AsAbsolute)
        {
            self.tell(Diagnostic::new(Message::G90AsAbsolute, span));
        }
        let taper_span = taper.map_or_else(|| block.words_span(), |word| word.span);
        let taper_word = |control: &Self| match taper {
            Some(word) => words::quote(text, word.span),
            // It is that of a block before.
            None => {
                let taper = control.state.memory.taper / control.state.unit.millimetres();
                format!("R{}", crate::units::number(taper))
            }
        };
        if !self.taper_fits(cycle, start, end, taper_span, taper_word) {
            request.drop = true;
            return;
        }
        let lead = match cycle {
            Single::Threading => {
                let Some(lead) = self.lead(block, words, "G92") else {
                    request.drop = true;
                    return;
                };
                if !self.watch_thread(text, block, words, "G92") {
                    request.drop = true;
                    return;
                }
                Some(lead)
            }
            Single::Turning | Single::Facing => {
                if !self.may_cut(text, block, words, request) {
                    return;
                }
                self.watch_cycle_compensation(block, cycle);
                None
            }
        };
        self.watch_cycle(text, block, words, cycle, start, end, lead);
        for _ in 0..self.starts(words, cycle) {
            self.state.memory.passes += 1;
            let pass = self.state.memory.passes;
            match (cycle, lead) {
                (Single::Threading, Some(lead)) => {
                    let moves = single::threading(start, end, memory.taper, self.pull_out(words, lead));
                    self.run_moves(block, cycle, pass, Some(lead), &moves);
                }
                (Single::Facing, _) => {
                    let begin = Point::new(start.x, end.z + memory.taper);
                    let end = Point::new(end.x, end.z + self.nose_shift(begin, end, Axis::Z));
                    self.run_moves(block, cycle, pass, None, &single::facing(start, end, memory.taper));
                }
                _ => {
                    let begin = Point::new(end.x + memory.taper, start.z);
                    let end = Point::new(end.x + self.nose_shift(begin, end, Axis::X), end.z);
                    self.run_moves(block, cycle, pass, None, &single::turning(start, end, memory.taper));
                }
            }
        }
    }

    /// A block of a cycle with R or F, but without an axis: no pass is made. A new F may be meant for a later cut.
    fn watch_axis_missing(&mut self, text: &[u8], words: &Words, cycle: Single, taper: Option<&Word>) {
        let memory = self.state.memory;
        let end = memory.named.map(|axis| (axis, if axis == Axis::X { memory.x } else { memory.z }));
        let Some(end) = end.filter(|_| memory.passes > 0) else { return };
        if let Some(word) = taper {
            self.tell_axis_missing(text, word.span, cycle, end);
        } else if let Some(word) = words.get(b'F') {
            self.state.feed_alone = Some(FeedAlone { span: word.span, cycle, end });
        }
    }

    /// F changes again, or the program ends: was a cut made with the F that was alone in a block of a cycle?
    #[inline(never)]
    pub(super) fn tell_feed_alone(&mut self, text: &[u8]) {
        if let Some(FeedAlone { span, cycle, end }) = self.state.feed_alone.take()
            && self.state.feed_use == FeedUse::Open
        {
            self.tell_axis_missing(text, span, cycle, end);
        }
    }

    fn tell_axis_missing(&mut self, text: &[u8], span: Span, cycle: Single, end: (Axis, Target)) {
        let (axis, target) = end;
        let (letters, scale) = if axis == Axis::X { (['X', 'U'], 2.0) } else { (['Z', 'W'], 1.0) };
        let (letter, value) = match target {
            Target::Stay => return,
            Target::Absolute(place) => (letters[0], place),
            Target::Incremental(way) => (letters[usize::from(!self.state.incremental)], way),
        };
        let number = crate::units::number(scale * value / self.state.unit.millimetres());
        let needs_point = self.dialect.decimal == DecimalRule::LeastIncrement && !number.contains('.');
        let end = format!("{letter}{number}{}", if needs_point { "." } else { "" });
        let word = quote(text, span);
        let fix = Fix::insert(span.start, format!("{end} "));
        let meant = format!("{end} {word}");
        let message = Message::CycleAxisMissing { word, code: cycle.cycle().code(), meant };
        self.tell(Diagnostic::new(message, span).with(fix));
    }

    /// What an instructor would remark of a pass of a single cycle.
    #[allow(clippy::too_many_arguments, reason = "one call, all of its words")]
    fn watch_cycle(
        &mut self,
        text: &[u8],
        block: &Block,
        words: &Words,
        cycle: Single,
        start: Point,
        end: Point,
        lead: Option<f64>,
    ) {
        if let Some(lead) = lead {
            let own_start = Point::new(end.x + self.state.memory.taper, start.z);
            self.watch_thread_pass(block, words, own_start, end, lead);
        }
        let taper = self.state.memory.taper;
        let own = DeepestPass { start, end, taper };
        let before = self.state.memory.deepest.filter(|_| self.state.memory.passes > 0);
        if let Some(address) = self.taper_word(words, cycle) {
            let word = words.quote(text, address);
            if let Some(message) = lint::taper_shape(cycle, start, end, taper, &word, self.setup.stock) {
                let fix = matches!(message, Message::TaperNarrows { .. })
                    .then(|| Fix::write(words.span(address), with_other_sign(&word)));
                let told = Diagnostic::new(message, words.span(address));
                self.tell(Diagnostic { fixes: fix.into_iter().collect(), ..told });
            }
        }
        let surface = before
            .map(|before| before.end.x + before.taper)
            .or(self.setup.stock.map(|stock| start.x.min(stock.diameter.radius())));
        if let Some(depth) = lint::cycle::edge_depth(cycle, &own, surface, before.is_none()) {
            self.tell(Diagnostic::new(Message::TaperEdge { depth }, block.words_span()));
        }
        let moved = match cycle {
            Single::Facing => [b'Z', b'W'],
            _ => [b'X', b'U'],
        };
        let own_word = moved.into_iter().find(|&address| words.get(address).is_some());
        if let (Some(before), Some(address)) = (before, own_word) {
            let word = words.quote(text, address);
            if let Some(message) = lint::cycle::pass_not_deeper(cycle, &own, &before, word)
                && self.state.told.first(Once::PassNotDeeper)
            {
                self.tell(Diagnostic::new(message, words.span(address)));
            }
        } else if before.is_none()
            && let Some(message) =
                self.setup.stock.as_ref().and_then(|stock| lint::cycle::start(cycle, &own, stock))
        {
            self.tell(Diagnostic::new(message, block.words_span()));
        }
        if cycle != Single::Threading {
            self.state.memory.deepest = Some(lint::cycle::deeper(cycle, own, before));
        }
        let switches = block.words.iter().find(|word| {
            let code = if word.address == b'G' { plain(word) } else { None };
            code.is_some_and(|code| {
                (41.0..=42.0).contains(&code) || code == 40.0 && self.state.compensating.is_some()
            })
        });
        if let Some(word) = switches {
            let message =
                Message::CompensationInCycle { word: quote(text, word.span), code: cycle.cycle().code() };
            self.tell(Diagnostic::new(message, word.span));
        }
    }

    /// How far compensation moves a straight cut along an axis, mm, so that the nose touches the programmed line;
    /// nothing without compensation or radius.
    fn nose_shift(&self, from: Point, to: Point, along: Axis) -> f64 {
        let Some(side) = self.side() else { return 0.0 };
        cycle_shift(side, self.nose(), from, to, along).unwrap_or(0.0)
    }

    /// The letter that holds the taper in a block of a cycle: R, or its older spelling.
    pub(super) fn taper_word(&self, words: &Words, cycle: Single) -> Option<u8> {
        let old = match cycle {
            Single::Turning => Some(b'I'),
            Single::Facing => Some(b'K'),
            Single::Threading => (self.dialect.i_in_g92 == IInG92::Taper).then_some(b'I'),
        };
        [Some(b'R'), old].into_iter().flatten().find(|&address| words.get(address).is_some())
    }

    /// Checks the taper (its place and its word) against the start point and, where a blank is known, against the drawing.
    pub(super) fn taper_fits(
        &mut self,
        cycle: Single,
        start: Point,
        end: Point,
        span: Span,
        word: impl FnOnce(&Self) -> String,
    ) -> bool {
        let taper = self.state.memory.taper;
        let way = match cycle {
            Single::Turning | Single::Threading => end.x - start.x,
            Single::Facing => end.z - start.z,
        };
        if single::begins_beyond_start(way, taper) {
            // GSK states it as an error (seed 000); no FANUC alarm is known for it.
            let error = self.dialect.control == Control::Gsk || self.dialect.strict;
            let severity = if error { Severity::Error } else { Severity::Warning };
            let word = word(self);
            let message = match cycle {
                Single::Turning | Single::Threading => Message::TaperBeyondHalf { word, limit: 2.0 * way },
                Single::Facing => Message::TaperBeyondLength { word, limit: way },
            };
            self.tell(Diagnostic::new(message, span).graded(severity));
            return !error;
        }
        if let Some(stock) = self.setup.stock
            && let Some((message, reading)) = lint::taper_not_extended(cycle, start, end, taper, stock)
            && self.state.told.first(Once::TaperNotExtended)
        {
            let mut told = Diagnostic::new(message, span);
            let sure = reading == lint::TaperReading::HeightOnDrawing;
            if !sure {
                told = told.graded(Severity::Info);
            }
            if let Message::TaperNotExtended { needed, .. } = told.message
                && sure
                && self.state.unit == Unit::Millimetre
                && span.len() < LONGEST_WORD
            {
                let needed = crate::units::number((1000.0 * needed).round() / 1000.0);
                told = told.with(Fix::write(span, format!("R{needed}")));
            }
            self.tell(told);
        }
        true
    }

    /// How often a G92 pass is cut: once, or for each start (GSK L).
    pub(super) fn starts(&self, words: &Words, cycle: Single) -> u64 {
        let several = cycle == Single::Threading && self.dialect.control == Control::Gsk;
        let starts = words.get(b'L').filter(|_| several).and_then(plain);
        starts.map_or(1, |starts| crate::geometry::within(starts, 1.0, 99.0) as u64)
    }

    /// How G92 leaves the thread: J and K (GSK), or the chamfer in tenths of a lead.
    pub(super) fn pull_out(&self, words: &Words, lead: f64) -> Option<PullOut> {
        let reading = self.reading();
        let gsk = self.dialect.control == Control::Gsk;
        let given = |address: u8| words.get(address).filter(|_| gsk).and_then(|word| reading.length(word));
        match (given(b'J'), given(b'K')) {
            (None, None) => {
                let length = 0.1 * f64::from(self.state.thread_chamfer) * lead;
                (self.state.thread_chamfer_on && length > 0.0)
                    .then_some(PullOut { along: length, out: length })
            }
            (j, k) => {
                let (j, k) = (j.map(f64::abs), k.map(f64::abs));
                Some(PullOut { along: k.or(j).unwrap_or(0.0), out: j.or(k).unwrap_or(0.0) })
            }
        }
    }

    pub(super) fn run_moves(
        &mut self,
        block: &Block,
        cycle: Single,
        pass: u32,
        lead: Option<f64>,
        moves: &[Move],
    ) {
        for step in moves {
            let tag = CycleStep { cycle: cycle.cycle(), pass, step: step.step };
            let mut motion = Motion { cycle: Some(tag), lead, ..self.motion(step.kind, step.to) };
            motion.process.uncertain |= self.state.doubts.has(Doubt::Cycle);
            self.push(block, motion);
        }
    }
}

/// A word with a minus where it had none, and the other way round.
pub(super) fn with_other_sign(word: &str) -> String {
    let number = words::behind_letter(word);
    let letter = &word[..word.len() - number.len()];
    let number = number.trim_start();
    match number.strip_prefix('-') {
        Some(rest) => format!("{letter}{}", rest.trim_start()),
        None => format!("{letter}-{}", number.trim_start_matches('+')),
    }
}
