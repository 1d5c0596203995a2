//! What a teacher would remark before a cut: feed, spindle, threads, compensation.

use super::*;

impl Interpreter {
    /// Checks before a cut at feed: whether there is a feed, and what a teacher would remark.
    #[inline]
    pub(super) fn may_cut(&mut self, block: &Block, words: &Words, request: &mut Request) -> bool {
        let Some(feed) = self.state.feed.filter(|&feed| feed > 0.0) else {
            self.tell(Diagnostic::new(Message::FeedMissing, block.words_span()));
            request.drop = true;
            return false;
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

    #[inline]
    pub(super) fn watch_spindle(&mut self, block: &Block) {
        let spindle = &self.state.spindle;
        if spindle.turn == SpindleTurn::Stopped
            && !spindle.live_tool
            && self.state.told.first(Once::SpindleStopped)
        {
            self.tell(Diagnostic::new(Message::SpindleStopped, block.words_span()));
        }
    }

    pub(super) fn watch_thread(&mut self, text: &[u8], block: &Block, words: &Words, code: &'static str) {
        self.watch_spindle(block);
        if self.state.spindle.surface && self.state.told.first(Once::ThreadAtSurfaceSpeed) {
            self.tell(Diagnostic::new(Message::ThreadAtSurfaceSpeed { code }, block.words_span()));
        }
        if self.state.compensation != Compensation::Off && self.state.told.first(Once::CompensationIdle) {
            self.tell(Diagnostic::new(Message::CompensationIdle { code }, block.words_span()));
        }
        if let Some(word) = words.get(b'Q')
            && let Value::Number { number, .. } = word.value
            && number.has_point()
            && self.dialect.control != Control::Forum
        {
            let message = Message::PointNotAllowed { word: quote(text, word.span) };
            self.tell(Diagnostic::new(message, word.span));
        }
    }

    pub(super) fn watch_cycle_compensation(&mut self, text: &[u8], block: &Block, cycle: Single) {
        if self.state.compensation == Compensation::Off {
            return;
        }
        if self.nose_radius() > 0.0 {
            self.watch_compensation(text, block);
        } else if self.state.told.first(Once::CompensationIdle) {
            self.tell(Diagnostic::new(
                Message::CompensationIdle { code: cycle.cycle().code() },
                block.words_span(),
            ));
        }
    }

    /// Compensation with a radius would shift the path, which is not done yet; without one it changes nothing.
    #[inline]
    pub(super) fn watch_compensation(&mut self, _text: &[u8], block: &Block) {
        if self.state.compensation == Compensation::Off || self.nose_radius() == 0.0 {
            return;
        }
        if self.state.told.first(Once::CompensationNotYet) {
            let what = if self.state.compensation == Compensation::Left { "`G41`" } else { "`G42`" };
            self.tell(Diagnostic::new(Message::NotYet { what: what.into() }, block.words_span()));
        }
        self.state.uncertain = true;
    }

    /// Radius of the nose or cutter in force, mm; 0 without an offset.
    pub(super) fn nose_radius(&self) -> f64 {
        let (station, offset) = self.state.tool;
        if offset == 0 {
            return 0.0;
        }
        let tool: Option<&Tool> = self.setup.tools.get(&format!("T{station:02}{offset:02}"));
        tool.map_or(0.0, |tool| tool.tool_radius.or(tool.geometry_r).unwrap_or(tool.nose_radius))
    }
}
