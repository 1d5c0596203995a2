//! What a teacher would remark before a cut: feed, spindle, threads, compensation.

use super::*;

impl Interpreter {
    /// Checks before a cut at feed: whether there is a feed, and what a teacher would remark.
    #[inline]
    pub(super) fn may_cut(&mut self, block: &Block, words: &Words, request: &mut Request) -> bool {
        let feed = match self.state.feed {
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
            if mixed_up && self.state.told.first(Once::FeedUnit) {
                self.tell(Diagnostic::new(Message::FeedUnit { feed, per_turn }, words.span(b'F')));
            }
        } else if self.state.feed_is_old {
            self.state.feed_is_old = false;
            let per_turn = self.state.feed_mode == FeedMode::PerTurn;
            self.tell(Diagnostic::new(Message::FeedNotRepeated { feed, per_turn }, block.words_span()));
        }
        self.watch_spindle(block);
        true
    }

    /// A cut before any F. Fresh from power-on a control stops there with PS0011; else it cuts with the F of the
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

    #[inline]
    pub(super) fn watch_spindle(&mut self, block: &Block) {
        let spindle = &self.state.spindle;
        if (spindle.turn == SpindleTurn::Stopped || spindle.still)
            && !spindle.live_tool
            && self.state.told.first(Once::SpindleStopped)
        {
            self.tell(Diagnostic::new(Message::SpindleStopped, block.words_span()));
        }
    }

    /// A thread needs a spindle that turns at a constant speed, and no compensation.
    pub(super) fn watch_thread_spindle(&mut self, block: &Block, code: &'static str) {
        self.watch_spindle(block);
        if self.state.spindle.surface && self.state.told.first(Once::ThreadAtSurfaceSpeed) {
            self.tell(Diagnostic::new(Message::ThreadAtSurfaceSpeed { code }, block.words_span()));
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

    /// Whether a word is written without a point, as its address demands here (PS0007). False: told.
    pub(super) fn is_whole(&mut self, text: &[u8], word: &Word) -> bool {
        let whole = !matches!(word.value, Value::Number { number, .. } if number.has_point());
        if !whole {
            self.tell(Diagnostic::new(Message::PointNotAllowed { word: quote(text, word.span) }, word.span));
        }
        whole
    }

    /// G90 and G94 are compensated, but only with a nose radius (semantics §4.4).
    pub(super) fn watch_cycle_compensation(&mut self, block: &Block, cycle: Single) {
        if self.state.compensation != Compensation::Off
            && self.nose().radius == 0.0
            && self.state.told.first(Once::CompensationIdle)
        {
            let code = cycle.cycle().code();
            self.tell(Diagnostic::new(Message::CompensationIdle { code }, block.words_span()));
        }
    }
}
