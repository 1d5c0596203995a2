//! The results of a run: motions and messages, each up to a limit.
//!
//! In: motions in machine coordinates, diagnostics. Out: a list of each, in the order in which they were
//! made. Knows no blocks and no state of the control.

use crate::limits::Limits;
use crate::message::{Diagnostic, Levels, Message};
use crate::motion::{Chunk, Motion, Motions};
use crate::order;
use crate::source::Span;

/// Motions and messages of a running program.
pub struct Sink {
    /// Severities that the setup sets.
    levels: Levels,
    /// Maximum number of motions and messages.
    limits: Limits,
    /// Finished chunks.
    pub motions: Motions,
    /// The unfinished chunk.
    pub chunk: Chunk,
    /// A block before the chunk could not be carried out.
    pub incomplete: bool,
    /// In the order in which they were reported.
    pub diagnostics: Vec<Diagnostic>,
    /// Span and rule of each diagnostic, sorted: blocks that run again are not reported again.
    reported: Vec<(u32, u16)>,
    /// Number of messages that were not kept.
    pub hidden: usize,
    /// A limit of the run is exceeded: nothing more is carried out.
    is_full: bool,
    /// The first syntax error in the current block.
    pub fault: Option<Span>,
    /// Nothing more is reported for the current block.
    pub muted: bool,
}

impl Sink {
    /// An empty sink. `chunk`: the first chunk.
    pub fn new(levels: Levels, limits: Limits, chunk: Chunk) -> Self {
        Self {
            levels,
            limits,
            motions: Motions::default(),
            chunk,
            incomplete: false,
            diagnostics: Vec::new(),
            reported: Vec::new(),
            hidden: 0,
            is_full: false,
            fault: None,
            muted: false,
        }
    }

    /// Number of motions kept.
    pub fn kept(&self) -> usize {
        self.motions.len() + self.chunk.len()
    }

    /// All motions, in order.
    pub fn all_motions(&self) -> impl Iterator<Item = Motion> + '_ {
        let chunks = self.motions.chunks().iter().chain([&self.chunk]);
        chunks.flat_map(|chunk| (0..chunk.len()).map(|index| chunk.get(index)))
    }

    /// Whether one more motion can be kept.
    #[inline]
    pub fn has_room(&self) -> bool {
        self.kept() < self.limits.motions
    }

    /// Closes the chunk and begins another with `next`.
    pub fn begin_chunk(&mut self, mut next: Chunk) {
        next.set_incomplete(self.incomplete);
        self.motions.push(std::mem::replace(&mut self.chunk, next));
    }

    /// Whether a limit of the run is exceeded, so that nothing more is carried out.
    #[inline]
    pub fn is_full(&self) -> bool {
        self.is_full
    }

    /// Ends the run because a limit is exceeded; `message` gives the reason.
    #[cold]
    pub fn end(&mut self, message: Message, span: Span) {
        if !self.is_full {
            self.is_full = true;
            self.report_always(Diagnostic::new(message, span));
        }
    }

    /// Whether the current block is muted, or this diagnostic is a consequence of a syntax error in it: one
    /// error, one message.
    pub fn suppresses(&self, diagnostic: &Diagnostic) -> bool {
        let about_all = |fault: Span| diagnostic.span.contains(fault) && diagnostic.span != fault;
        self.muted || self.fault.is_some_and(about_all)
    }

    /// Keeps a message, unless it was reported for the same place before. `repeats`: the message may have
    /// been reported before, so it is not counted if there is no room for it.
    pub fn report(&mut self, diagnostic: Diagnostic, repeats: bool) {
        // A message that is switched off takes no room.
        let Some(diagnostic) = self.levels.apply_to(diagnostic) else { return };
        if self.diagnostics.len() >= self.limits.messages {
            self.hidden += usize::from(!repeats);
            return;
        }
        self.keep(diagnostic);
    }

    /// Keeps a message even if the list is full: the reason why the run ends.
    pub fn report_always(&mut self, diagnostic: Diagnostic) {
        if let Some(diagnostic) = self.levels.apply_to(diagnostic) {
            self.keep(diagnostic);
        }
    }

    /// Keeps a message about the setup. Several messages of the same rule are allowed, because all of them
    /// are placed at the beginning of the text.
    pub fn report_of_setup(&mut self, diagnostic: Diagnostic) {
        let graded = self.levels.apply_to(diagnostic);
        self.diagnostics.extend(graded.filter(|_| self.diagnostics.len() < self.limits.messages));
    }

    fn keep(&mut self, diagnostic: Diagnostic) {
        let known = key(&diagnostic);
        if let Err(place) = self.reported.binary_search(&known) {
            self.reported.insert(place, known);
            self.diagnostics.push(diagnostic);
        }
    }

    /// Whether the message is new, and there is room for it.
    pub fn has_room_for(&self, diagnostic: &Diagnostic) -> bool {
        let room = self.diagnostics.len() < self.limits.messages;
        room && self.reported.binary_search(&key(diagnostic)).is_err()
    }

    /// The sink with only the first `chunks` and `diagnostics`, followed by a new chunk.
    pub fn truncate_to(
        &mut self,
        chunks: usize,
        diagnostics: usize,
        hidden: usize,
        incomplete: bool,
        chunk: Chunk,
    ) {
        self.motions.split_off(chunks);
        self.diagnostics.truncate(diagnostics);
        self.reported = self.diagnostics.iter().map(key).collect();
        order::by_key(&mut self.reported, |known| *known);
        (self.hidden, self.incomplete) = (hidden, incomplete);
        (self.is_full, self.fault, self.muted) = (false, None, false);
        self.chunk = chunk;
        self.chunk.set_incomplete(incomplete);
    }
}

/// Identity of a message.
fn key(diagnostic: &Diagnostic) -> (u32, u16) {
    (diagnostic.span.start, diagnostic.message.rule_index())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Point;
    use crate::message::said;

    fn sink(messages: usize) -> Sink {
        let limits = Limits { messages, ..Limits::default() };
        Sink::new(Levels::default(), limits, Chunk::new(0, 0, Point::new(0.0, 0.0)))
    }

    fn diagnostic(start: usize) -> Diagnostic {
        Diagnostic::new(said::ArcNowhere, Span::new(start, start + 3))
    }

    #[test]
    fn a_message_is_kept_once_for_a_place() {
        let mut sink = sink(10);
        sink.report(diagnostic(4), false);
        sink.report(diagnostic(4), false);
        sink.report(diagnostic(9), false);
        assert_eq!((sink.diagnostics.len(), sink.hidden), (2, 0));
        assert!(!sink.has_room_for(&diagnostic(4)) && sink.has_room_for(&diagnostic(5)));
    }

    #[test]
    fn beyond_the_limit_messages_are_counted_but_for_why_the_run_ends() {
        let mut sink = sink(1);
        sink.report(diagnostic(0), false);
        sink.report(diagnostic(5), false);
        sink.report(diagnostic(5), true);
        sink.end(said::TooManyMotions { most: 3 }.into(), Span::new(7, 8));
        sink.end(said::TooManyRounds { most: 3 }.into(), Span::new(9, 10));
        assert_eq!((sink.diagnostics.len(), sink.hidden), (2, 1));
        assert!(sink.is_full() && !sink.has_room_for(&diagnostic(20)));
    }

    #[test]
    fn what_is_said_of_a_whole_block_follows_from_a_fault_within_it() {
        let mut sink = sink(10);
        sink.fault = Some(Span::new(4, 6));
        assert!(sink.suppresses(&Diagnostic::new(said::ArcNowhere, Span::new(0, 10))));
        assert!(!sink.suppresses(&Diagnostic::new(said::ArcNowhere, Span::new(4, 6))));
        assert!(!sink.suppresses(&Diagnostic::new(said::ArcNowhere, Span::new(7, 9))));
        sink.muted = true;
        assert!(sink.suppresses(&diagnostic(7)));
    }

    #[test]
    fn going_back_lets_later_messages_be_reported_again() {
        let mut sink = sink(10);
        sink.report(diagnostic(0), false);
        sink.begin_chunk(Chunk::new(5, 1, Point::new(0.0, 0.0)));
        let chunks = sink.motions.chunks().len();
        sink.report(diagnostic(8), false);
        sink.end(said::TooManyRounds { most: 3 }.into(), Span::new(9, 10));
        sink.truncate_to(chunks, 1, 0, false, Chunk::new(5, 1, Point::new(0.0, 0.0)));
        assert!(sink.diagnostics.len() == 1 && !sink.is_full());
        assert!(sink.has_room_for(&diagnostic(8)) && !sink.has_room_for(&diagnostic(0)));
    }
}
