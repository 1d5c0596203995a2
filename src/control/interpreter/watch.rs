//! What a teacher would remark before a cut: feed, spindle, threads, compensation.

use super::*;
use crate::lint;

/// Nearer to the work than this, mm, no turret should turn.
const NEAR_WORK: f64 = 20.0;

impl Interpreter {
    /// Checks before a cut at feed: whether there is a feed, and what a teacher would remark.
    #[inline]
    pub(super) fn may_cut(
        &mut self,
        text: &[u8],
        block: &Block,
        words: &Words,
        request: &mut Request,
    ) -> bool {
        let feed = match self.state.feed {
            // The F of the cycle counts, and what is to be said of it is said there.
            Some(_) if self.purpose == Some(contours::Purpose::Roughing) => return true,
            Some(feed) if feed > 0.0 => feed,
            Some(_) => {
                if self.state.told.first(Once::FeedZero) {
                    self.tell(Diagnostic::new(Message::FeedMissing, block.words_span()));
                }
                request.drop = true;
                return false;
            }
            None => return self.without_feed(block, request),
        };
        if words.has_any(letters(b"F")) {
            let per_turn = self.state.feed_mode == FeedMode::PerTurn;
            let mixed_up = if per_turn { feed >= 5.0 } else { feed < 2.0 };
            // Without a point it counts increments, which each machine has its own of.
            let counts = self.dialect.decimal == DecimalRule::LeastIncrement
                && words.get(b'F').is_some_and(
                    |word| matches!(word.value, Value::Number { number, .. } if !number.has_point()),
                );
            if mixed_up && !counts && self.state.told.first(Once::FeedUnit) {
                let word = words.quote(text, b'F');
                let message = match per_turn {
                    true => Message::FeedPerTurnTooLarge { word, feed },
                    false => Message::FeedPerMinuteTooSmall { word, feed },
                };
                self.tell(Diagnostic::new(message, words.span(b'F')));
            }
        } else if self.state.feed_is_old {
            self.state.feed_is_old = false;
            if self.state.feed_use == FeedUse::Thread {
                // The unit was changed: that is reported, not the lead as well.
                self.state.feed_use = FeedUse::Open;
            }
            let message = match self.state.feed_mode {
                FeedMode::PerTurn => Message::FeedNotRepeatedPerTurn { feed },
                FeedMode::PerMinute => Message::FeedNotRepeatedPerMinute { feed },
            };
            self.tell(Diagnostic::new(message, block.words_span()));
        } else if self.state.feed_use == FeedUse::Thread {
            self.state.feed_use = FeedUse::Open;
            self.tell(Diagnostic::new(Message::FeedOfThread { feed }, block.words_span()));
        }
        if self.state.feed_use == FeedUse::Open {
            self.state.feed_use = FeedUse::Cut;
        }
        if !stays(words) {
            self.watch_spindle(block);
        }
        true
    }

    /// A cut before any F. After power-up a control stops there with PS0011; else it cuts with the F of the
    /// program before. The block is left out as after an error; later ones go on, for it is the same fault.
    #[cold]
    pub(super) fn without_feed(&mut self, block: &Block, request: &mut Request) -> bool {
        let strict = self.dialect.strict;
        if strict || self.state.told.first(Once::NoFeed) {
            let severity = if strict { Severity::Error } else { Severity::Warning };
            self.tell(Diagnostic::new(Message::FeedMissing, block.words_span()).graded(severity));
            request.drop = true;
        } else {
            self.watch_spindle(block);
        }
        !request.drop
    }

    /// What a teacher wants to see before the first cut of a tool.
    #[inline(never)]
    fn watch_checklist(&mut self, block: &Block) {
        let (station, offset) = self.state.tool;
        let missing = [
            (station == 0 && offset == 0).then_some(Message::ToolNotNamed),
            (!self.state.feed_mode_named).then_some(Message::FeedModeNotNamed),
            (!self.state.coolant).then_some(Message::CoolantOff),
        ];
        for message in missing.into_iter().flatten() {
            self.tell(Diagnostic::new(message, block.words_span()));
        }
    }

    #[inline]
    pub(super) fn watch_spindle(&mut self, block: &Block) {
        if self.state.told.first(Once::Checklist) {
            self.watch_checklist(block);
        }
        if self.state.unclamped.is_some() {
            self.tell_speed_clamp();
        }
        let spindle = &self.state.spindle;
        // Which M code turns a live tool depends on the machine.
        let milling = self.state.c_axis || self.state.virtual_plane.is_some();
        let may_turn = spindle.live_tool || spindle.by_maker || milling && self.state.unknown_m;
        if (spindle.turn == SpindleTurn::Stopped || spindle.still)
            && !may_turn
            && self.state.told.first(Once::SpindleStopped)
        {
            let still = StillMove { block: block.span, words: block.words_span() };
            match self.recorded {
                None => self.state.still_move = Some(still),
                // The state of a contour is given up.
                Some(_) => self.tell_of_still(still),
            }
            return;
        }
        let spindle = &self.state.spindle;
        let speed = if spindle.surface { spindle.cutting_speed } else { spindle.rpm };
        if speed == 0.0
            && spindle.turn != SpindleTurn::Stopped
            && !may_turn
            && !spindle.still
            && self.state.told.first(Once::SpeedMissing)
        {
            let of_surface = spindle.surface && spindle.rpm > 0.0;
            let message = if of_surface { Message::SurfaceSpeedMissing } else { Message::SpeedMissing };
            self.tell(Diagnostic::new(message, block.words_span()));
        }
    }

    /// A move at feed with the spindle stopped was no work of a bar puller.
    pub(super) fn tell_still_move(&mut self) {
        if let Some(still) = self.state.still_move.take() {
            self.tell_of_still(still);
        }
    }

    #[cold]
    fn tell_of_still(&mut self, still: StillMove) {
        let fix = Fix::insert(still.block.start, "M03\n".to_owned());
        self.tell(Diagnostic::new(Message::SpindleStopped, still.words).with(fix));
    }

    /// What is to be remarked of a pass of a thread, against the one before.
    pub(super) fn watch_thread_pass(
        &mut self,
        block: &Block,
        words: &Words,
        start: Point,
        end: Point,
        lead: f64,
    ) {
        let spindle = &self.state.spindle;
        let speed = if spindle.surface { 0.0 } else { spindle.rpm };
        let own = ThreadPass { start, end, lead, speed, tool: self.state.tool };
        let before = self.state.thread.replace(own);
        let angle = words.get(b'Q').is_some();
        // L of GSK's G92: so many starts.
        let starts = self.starts(words, Single::Threading) as f64;
        let face = self.setup.stock.map(|stock| stock.face);
        for told in lint::thread::remarks(&own, before.as_ref(), angle, starts, face, block.words_span()) {
            self.tell(told);
        }
    }

    /// A tap on the axis goes in by G32 and must be turned out again by a G32 with the spindle reversed.
    pub(super) fn watch_tap(&mut self, block: &Block, from: Point, to: Point) {
        if from.x.abs() > crate::geometry::SAME || to.x.abs() > crate::geometry::SAME {
            return;
        }
        let turn = self.state.spindle.turn;
        if to.z < from.z {
            self.state.tap = Some(turn);
            if self.state.spindle.surface {
                self.tell(Diagnostic::new(Message::TapSurface, block.words_span()));
            }
        } else if self.state.tap.take() == Some(turn) && turn != SpindleTurn::Stopped {
            self.tell(Diagnostic::new(Message::TapReverse, block.words_span()));
        }
    }

    /// A tap that leaves its hole by another move than a thread.
    pub(super) fn watch_tap_leaving(&mut self, block: &Block, to: Point) {
        if to.z > self.state.position.z && self.state.tap.take().is_some() {
            self.tell(Diagnostic::new(Message::TapReverse, block.words_span()));
        }
    }

    /// The turret turns: near the work, or with compensation still on.
    pub(super) fn watch_tool_change(&mut self, text: &[u8], word: &Word, before: (u16, u16)) {
        let (station, _) = self.state.tool;
        if station == before.0 {
            return;
        }
        self.state.told.forget(Once::Checklist);
        self.tell_still_move();
        if before.0 != 0 {
            self.watch_compensation_left_on(text, word.span);
        }
        let at = self.state.position;
        let near = |stock: &crate::setup::Stock| {
            2.0 * at.x.abs() < stock.diameter.mm() + 2.0 * NEAR_WORK && at.z < stock.face + NEAR_WORK
        };
        if before.0 != 0
            && self.recorded.is_none()
            && !self.state.sent_home
            && self.setup.stock.as_ref().is_some_and(near)
        {
            let message = Message::ToolChangeNear { tool: quote(text, word.span), x: 2.0 * at.x, z: at.z };
            self.tell(Diagnostic::new(message, word.span));
        }
    }

    /// Compensation that nobody has cancelled where the tool leaves the work.
    pub(super) fn watch_compensation_left_on(&mut self, text: &[u8], span: Span) {
        let code = match self.state.compensation {
            Compensation::Off => return,
            Compensation::Left => "G41",
            Compensation::Right => "G42",
        };
        // Switched on for the tool that comes now, it has shifted no path yet.
        if self.recorded.is_none()
            && !self.state.compensation_idle
            && self.state.virtual_plane.is_none()
            && self.state.told.first(Once::CompensationLeftOn)
        {
            let message = Message::CompensationLeftOn { code, word: quote(text, span) };
            self.tell(Diagnostic::new(message, span));
        }
    }

    /// Compensation that is still on where the tool goes to a place of the machine (G27, G28, G30, G53).
    pub(super) fn watch_compensation_at_home(&mut self, text: &[u8], block: &Block) {
        let goes = |word: &&Word| {
            word.address == b'G'
                && matches!(plain(word), Some(code) if [27.0, 28.0, 30.0, 53.0].contains(&code))
        };
        if let Some(word) = block.words.iter().find(goes) {
            self.watch_compensation_left_on(text, word.span);
        }
    }

    /// Two blocks without a move while compensation is on.
    pub(super) fn watch_idle_blocks(&mut self, block: &Block) {
        let idle = self
            .state
            .compensating
            .as_ref()
            .is_some_and(|own| own.idle_blocks == 2 && !own.waiting.is_empty());
        if idle && self.state.told.first(Once::CompensationIdleBlocks) {
            self.tell(Diagnostic::new(Message::CompensationIdleBlocks, block.words_span()));
        }
    }

    /// The side of compensation against where the work lies, for a cut along Z (outside toward the chuck
    /// G42, bores G41).
    pub(super) fn watch_compensation_side(&mut self, block: &Block, from: Point, to: Point) {
        if self.state.compensation == Compensation::Off || self.state.virtual_plane.is_some() {
            return;
        }
        let (radius, tip) = self.offset_entry();
        let (station, offset) = self.state.tool;
        let live = self.setup.tools.get(&format!("T{station:02}{offset:02}")).and_then(|tool| tool.kind);
        let turns = !matches!(live, Some(ToolKind::Endmill | ToolKind::Drill));
        if turns && matches!(tip, 0 | 9) && radius > 0.0 && self.state.told.first(Once::CompensationTip) {
            let message = Message::CompensationTip { tip: f64::from(tip) };
            self.tell(Diagnostic::new(message, block.words_span()));
        }
        let Some((code, right)) = lint::compensation::wrong_side(self.state.compensation, tip, from, to)
        else {
            return;
        };
        if self.state.told.first(Once::CompensationSide) {
            self.tell(Diagnostic::new(Message::CompensationSide { code, right }, block.words_span()));
        }
    }

    /// A thread needs a spindle that turns at a constant speed, and no compensation.
    pub(super) fn watch_thread_spindle(&mut self, block: &Block, code: &'static str) {
        self.watch_spindle(block);
        if self.state.spindle.surface && self.state.told.first(Once::ThreadAtSurfaceSpeed) {
            let told = Diagnostic::new(Message::ThreadAtSurfaceSpeed { code }, block.words_span());
            // The speed that G96 has here, to the next ten below.
            let speed = self.spindle_speed(self.state.position.x).filter(|&speed| speed >= 10.0);
            let block_before = |speed: f64| format!("G97 S{}\n", 10.0 * (speed / 10.0).floor());
            let fix = speed.map(|speed| Fix::insert(block.span.start, block_before(speed)));
            self.tell(Diagnostic { fixes: fix.into_iter().collect(), ..told });
        }
        if self.state.compensation != Compensation::Off && self.state.told.first(Once::CompensationIdle) {
            self.tell(Diagnostic::new(Message::CompensationIdle { code }, block.words_span()));
        }
    }

    /// The same for G32 and G92, whose Q is a start angle: a whole number of 0.001°.
    /// False: it is not.
    pub(super) fn watch_thread(
        &mut self,
        text: &[u8],
        block: &Block,
        words: &Words,
        code: &'static str,
    ) -> bool {
        self.watch_thread_spindle(block, code);
        let any_number = self.dialect.control == Control::Forum;
        any_number || words.get(b'Q').is_none_or(|word| self.is_whole(text, word))
    }

    /// Whether a word is written without a point, as its address demands here (PS0007). False: reported.
    pub(super) fn is_whole(&mut self, text: &[u8], word: &Word) -> bool {
        let whole = !matches!(word.value, Value::Number { number, .. } if number.has_point());
        if !whole {
            let told = Diagnostic::new(Message::PointNotAllowed { word: quote(text, word.span) }, word.span);
            let fix = without_point(text, word);
            self.tell(Diagnostic { fixes: fix.into_iter().collect(), ..told });
        }
        whole
    }

    /// G90 and G94 are compensated, but only with a nose radius.
    pub(super) fn watch_cycle_compensation(&mut self, block: &Block, cycle: Single) {
        if self.state.compensation != Compensation::Off
            && self.nose().radius == 0.0
            && self.state.told.first(Once::CompensationIdle)
        {
            let code = cycle.cycle().code();
            let told = Diagnostic::new(Message::CompensationIdle { code }, block.words_span());
            // The radius may stand in the control's own table.
            self.tell(told.graded(Severity::Info));
        }
    }
}

/// Whether the words of a block leave the tool where it is: `W0`.
fn stays(words: &Words) -> bool {
    let idle = |address: u8| words.get(address).and_then(plain).is_some_and(|way| way == 0.0);
    !words.has_any(letters(b"XZCHA"))
        && words.has_any(letters(b"UW"))
        && !words.has_any(letters(b"RIK"))
        && [b'U', b'W'].into_iter().all(|address| words.get(address).is_none() || idle(address))
}

/// `P10.` as `P10`; nothing where digits stand after the point.
fn without_point(text: &[u8], word: &Word) -> Option<Fix> {
    let Value::Number { number, .. } = word.value else { return None };
    let written = quote(text, word.span);
    let (head, tail) = written.split_once('.')?;
    let whole = number.value().fract() == 0.0 && tail.bytes().all(|byte| byte == b'0');
    whole.then(|| Fix::write(word.span, head.to_owned()))
}
