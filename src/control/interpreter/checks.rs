//! Checks that several kinds of blocks share: is there a feed rate, is a word a whole number?
//!
//! In: a block and its words. Out: whether it can be carried out; if not, the error was reported.

use super::Interpreter;
use super::request::Request;
use crate::control::contour::ContourUse;
use crate::control::events::Event;
use crate::control::modal::Once;
use crate::control::words::{Words, letters, quote};
use crate::message::{Diagnostic, Fix, Severity, said};
use crate::setup::dialect::Control;
use crate::text::block::{Block, Value, Word};

impl Interpreter {
    /// Checks before a cut at feed whether there is a feed rate.
    #[inline]
    pub(super) fn may_cut(
        &mut self,
        text: &[u8],
        block: &Block,
        words: &Words,
        request: &mut Request,
    ) -> bool {
        match self.state.feed {
            // The F of the cycle applies, and is checked for the cycle.
            Some(_) if self.contours.purpose == Some(ContourUse::Roughing) => true,
            Some(feed) if feed > 0.0 => {
                if self.cut_context_changed || words.has_any(letters(b"F")) {
                    self.observe(text, Event::Cut { block, words, feed });
                    // `U0 W0` makes no cut.
                    self.cut_context_changed = !words.has_any(letters(b"XZ"));
                }
                true
            }
            Some(_) => {
                if self.state.reported.mark_reported(Once::FeedZero) {
                    self.report(Diagnostic::new(said::FeedMissing, block.words_span()));
                }
                request.drop = true;
                false
            }
            None => self.without_feed(text, block, request),
        }
    }

    /// A cut before any F. After power-up a control stops here with PS0011; otherwise it cuts with the F of
    /// the previous program. The block is left out as after an error. Later blocks continue without another
    /// message, because the error is the same.
    #[cold]
    fn without_feed(&mut self, text: &[u8], block: &Block, request: &mut Request) -> bool {
        let strict = self.dialect.strict;
        if strict || self.state.reported.mark_reported(Once::NoFeed) {
            let severity = if strict { Severity::Error } else { Severity::Warning };
            self.report(Diagnostic::new(said::FeedMissing, block.words_span()).with_severity(severity));
            request.drop = true;
        } else {
            self.observe(text, Event::CutWithoutFeed { block });
        }
        !request.drop
    }

    /// Whether Q of G32 or G92, a start angle, is a whole number of 0.001°. False: an error was reported.
    pub(super) fn has_whole_angle(&mut self, text: &[u8], words: &Words) -> bool {
        let any_number = self.dialect.control == Control::Forum;
        any_number || words.get(b'Q').is_none_or(|word| self.is_whole(text, word))
    }

    /// Whether a word has no point, as its address requires here (PS0007). False: an error was reported.
    pub(super) fn is_whole(&mut self, text: &[u8], word: &Word) -> bool {
        let whole = !matches!(word.value, Value::Number { number, .. } if number.has_point());
        if !whole {
            let diagnostic =
                Diagnostic::new(said::PointNotAllowed { word: quote(text, word.span) }, word.span);
            let fix = without_point(text, word);
            self.report(Diagnostic { fixes: fix.into_iter().collect(), ..diagnostic });
        }
        whole
    }
}

/// `P10.` as `P10`; `None` if there are digits after the point.
fn without_point(text: &[u8], word: &Word) -> Option<Fix> {
    let Value::Number { number, .. } = word.value else { return None };
    let written = quote(text, word.span);
    let (head, tail) = written.split_once('.')?;
    let whole = number.value().fract() == 0.0 && tail.bytes().all(|byte| byte == b'0');
    whole.then(|| Fix::write(word.span, head.to_owned()))
}
