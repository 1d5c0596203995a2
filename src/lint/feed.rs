//! Lints for F: whether it fits its unit, and whether it was given for its current use.

use super::once::Once;
use super::single_cycle;
use crate::control::codes::{self, G};
use crate::control::compensation::Axis;
use crate::control::events::EventContext;
use crate::control::modal::Target;
use crate::control::words::{Words, letters, quote};
use crate::cycles::single::Single;
use crate::message::{Diagnostic, Message, said};
use crate::motion;
use crate::setup::dialect::{DecimalRule, FeedMode};
use crate::source::Span;
use crate::source::shift::Shift;
use crate::text::block::{Block, Value, Word};

/// The use of the active F since it was given.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Use {
    /// None, or both.
    #[default]
    Open,
    /// Cuts at feed.
    Cut,
    /// Threads.
    Thread,
}

/// A block of a single cycle with a new F and without an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
struct LoneFeed {
    /// The word F.
    span: Span,
    /// The active cycle.
    cycle: Single,
    /// The last named axis and its end point.
    end: (Axis, Target),
}

/// F under G99 from which it may be a fast approach in the air, mm/rev. A smaller feed per revolution that
/// follows shows that the unit is intended.
const MIN_DOUBTFUL: f64 = 5.0;

/// Usual feed per revolution of a tool, mm/rev.
const USUAL: f64 = 1.0;

/// A code in the notation of the active G-code system.
pub fn code_of(code: G, at: &EventContext) -> String {
    codes::written(code, at.dialect.code_list()).unwrap_or_default()
}

/// The codes of feed per revolution and feed per minute.
pub fn feed_codes(at: &EventContext) -> (String, String) {
    (code_of(G::Feed(FeedMode::PerTurn), at), code_of(G::Feed(FeedMode::PerMinute), at))
}

/// The state of the lints for F.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Feed {
    /// Whether the feed mode changed after the last F.
    is_old: bool,
    /// The use of the last F.
    used_for: Use,
    /// Whether a code of the feed mode appeared in the program.
    pub mode_named: bool,
    /// F in a block of a single cycle without an axis; `used_for` says whether a cut has used it.
    lone_feed: Option<LoneFeed>,
    /// Remark: the number does not fit the unit of F.
    unit: Once,
    /// F under G99 from [`MIN_DOUBTFUL`] on, and its value, mm/rev.
    doubtful: Option<(Span, f64)>,
}

impl Feed {
    /// Handles a code of the feed mode.
    pub fn mode(&mut self, mode: FeedMode, at: &EventContext) {
        self.is_old |= mode != at.state.feed_mode && at.state.feed.is_some();
        self.mode_named = true;
        self.unit.reset();
    }

    /// Suppresses the remark about the unit of F: a lone G94 in code system B has chosen it.
    pub fn unit_is_chosen(&mut self) {
        self.unit.suppress();
    }

    /// Handles an F word.
    pub fn given(&mut self, at: &EventContext, reports: &mut Vec<Diagnostic>) {
        self.report_lone_feed(at, reports);
        self.is_old = false;
        self.used_for = Use::Open;
    }

    /// Checks a cut at feed.
    pub fn cut(
        &mut self,
        block: &Block,
        words: &Words,
        feed: f64,
        at: &EventContext,
        reports: &mut Vec<Diagnostic>,
    ) {
        if words.has_any(letters(b"F")) {
            self.fits_unit(words, feed, at, reports);
        } else if self.is_old {
            self.is_old = false;
            if self.used_for == Use::Thread {
                // Only the change of the unit is reported, not the lead.
                self.used_for = Use::Open;
            }
            let code = code_of(G::Feed(at.state.feed_mode), at);
            let message: Message = match at.state.feed_mode {
                FeedMode::PerTurn => said::FeedNotRepeatedPerTurn { feed, code }.into(),
                FeedMode::PerMinute => said::FeedNotRepeatedPerMinute { feed, code }.into(),
            };
            reports.push(Diagnostic::new(message, block.words_span()));
        } else if self.used_for == Use::Thread {
            self.used_for = Use::Open;
            reports.push(Diagnostic::new(said::FeedOfThread { feed }, block.words_span()));
        }
        if self.used_for == Use::Open {
            self.used_for = Use::Cut;
        }
    }

    #[inline(never)]
    fn fits_unit(&mut self, words: &Words, feed: f64, at: &EventContext, reports: &mut Vec<Diagnostic>) {
        let per_turn = at.state.feed_mode == FeedMode::PerTurn;
        let mixed_up = if per_turn { feed >= MIN_DOUBTFUL } else { feed < 2.0 };
        if per_turn && feed <= USUAL {
            self.doubtful = None;
        }
        // Without a point F counts increments, which differ between machines.
        let counts = at.dialect.decimal == DecimalRule::LeastIncrement
            && words.peek(b'F').is_some_and(
                |word| matches!(word.value, Value::Number { number, .. } if !number.has_point()),
            );
        if !mixed_up || counts {
            return;
        }
        let span = words.span(b'F');
        if per_turn {
            self.doubtful = self.doubtful.or(Some((span, feed)));
            if feed >= motion::Feed::OF_OTHER_UNIT {
                self.report_doubtful(at, reports);
            }
        } else if self.unit.mark_reported() {
            let word = words.quote(at.text, b'F');
            let (per_turn, per_minute) = feed_codes(at);
            let message = said::FeedPerMinuteTooSmall { word, feed, per_turn, per_minute };
            reports.push(Diagnostic::new(message, span));
        }
    }

    /// Reports a doubtful F if no smaller feed per revolution has followed, or the program ends.
    pub fn report_doubtful(&mut self, at: &EventContext, reports: &mut Vec<Diagnostic>) {
        if let Some((span, feed)) = self.doubtful.take()
            && self.unit.mark_reported()
        {
            let (per_turn, per_minute) = feed_codes(at);
            let word = quote(at.text, span);
            let message = said::FeedPerTurnTooLarge { word, feed, per_turn, per_minute };
            reports.push(Diagnostic::new(message, span));
        }
    }

    /// Suppresses the remark about an old F, because the unit of F was reported as wrong for its use.
    pub fn unit_is_reported(&mut self) {
        self.is_old = false;
    }

    /// Checks an F that is used as a lead, mm.
    pub fn check_lead(
        &mut self,
        block: &Block,
        code: &'static str,
        feed: f64,
        reports: &mut Vec<Diagnostic>,
    ) {
        if self.used_for == Use::Cut {
            reports.push(Diagnostic::new(said::LeadOfFeed { code, feed }, block.words_span()));
        }
        self.used_for = Use::Thread;
    }

    /// Handles F in a block of a single cycle without an axis: it may be intended for a later cut.
    pub fn note_lone_feed(&mut self, word: &Word, cycle: Single, end: (Axis, Target)) {
        self.lone_feed = Some(LoneFeed { span: word.span, cycle, end });
    }

    /// Handles a multiple cycle, which uses its own F.
    pub fn multiple_cycle(&mut self) {
        self.lone_feed = None;
    }

    /// Reports a cycle block with F and without an axis if no cut has used its F. Called when F changes or
    /// the program ends.
    pub fn report_lone_feed(&mut self, at: &EventContext, reports: &mut Vec<Diagnostic>) {
        if let Some(LoneFeed { span, cycle, end }) = self.lone_feed.take()
            && self.used_for == Use::Open
        {
            reports.extend(single_cycle::axis_missing(at, span, cycle, end));
        }
    }

    /// Takes over the remarks that `other` has made.
    pub fn inherit_reported(&mut self, other: &Self) {
        self.unit = other.unit;
    }

    /// First bytes of the words that may be reported later.
    pub fn waiting(&self) -> [Option<u32>; 2] {
        [self.lone_feed.map(|alone| alone.span.start), self.doubtful.map(|(span, _)| span.start)]
    }

    /// Shifts the stored spans after an edit.
    pub fn shift(&mut self, shift: &Shift) {
        self.lone_feed = self.lone_feed.map(|alone| LoneFeed { span: shift.span(alone.span), ..alone });
        self.doubtful = self.doubtful.map(|(span, feed)| (shift.span(span), feed));
    }
}
