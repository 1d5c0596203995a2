//! An open document: its text, its run, and the answers to questions about it.
//!
//! In: the text of the editor and its edits. Out: the run of the text, prepared in slices as far as a
//! request needs it. After an edit only the affected part runs again. If the program calls subprograms in
//! other files, they are run as if they followed it; an edit then runs everything again.

use std::ops::Range;

use gen_lsp_types::{self as lsp, Position, TextDocumentContentChangePartial};

use super::client::{Client, HintKinds};
use super::hinting::{Hint, Hinting};
use super::host::{Host, Settings};
use super::positions::{Encoding, Positions};
use crate::control::program::may_call;
use crate::current::Current;
use crate::current::question::Question;
use crate::message::{Diagnostic, Edit, applied, sort_by_place};
use crate::run::replay::{Found, VisitChoice};
use crate::run::subprograms::Joined;
use crate::run::{Run, RunId};
use crate::sentences::Language;
use crate::source::{LineIndex, Span, line_around};

/// Blocks that are run in one slice.
pub const BLOCKS: usize = 100_000;

/// Blocks that are replayed in one slice.
const REPLAYED_BLOCKS: usize = 10_000;

/// What a request needs of a document.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Need {
    /// The text.
    Text,
    /// The run.
    Run,
    /// The messages of the run and of the machine.
    Messages,
    /// The messages that have fixes. Messages of the machine have no fixes.
    Fixes,
    /// The block at a position, as it is executed.
    Place(Position),
    /// The hints in a range.
    Hints(lsp::Range),
}

/// An open document.
pub struct Document {
    /// The version that the client has given it.
    pub version: i32,
    /// How it is run and checked.
    settings: Settings,
    /// The run. Its text is that of the editor, or that of `apart` with subprograms.
    current: Current,
    /// The text of the editor, if the run has another one.
    apart: Option<Box<Apart>>,
    /// Whether the text may call a program.
    may_call: bool,
    /// Whether subprograms have been searched for since the last edit.
    is_joined: bool,
    question: Question,
    /// The place of the latest question and its run.
    asked: Option<(RunId, u32)>,
    /// The messages, and their run.
    messages: Option<(RunId, Vec<Diagnostic>)>,
    /// The messages that have fixes, and their run.
    fixable: Option<(RunId, Vec<Diagnostic>)>,
    hinting: Option<Hinting>,
    /// The run whose messages were sent to the client.
    pub published: Option<RunId>,
}

/// A text whose run continues in subprograms.
struct Apart {
    text: Vec<u8>,
    lines: LineIndex,
    joined: Joined,
}

impl Document {
    /// A document that was opened.
    pub fn new(text: String, version: i32, settings: Settings) -> Self {
        let text = text.into_bytes();
        Self {
            version,
            may_call: may_call(&text),
            current: Current::new(text, settings.setup.clone()),
            settings,
            apart: None,
            is_joined: false,
            question: Question::default(),
            asked: None,
            messages: None,
            fixable: None,
            hinting: None,
            published: None,
        }
    }

    /// The text.
    pub fn text(&self) -> &[u8] {
        self.apart.as_ref().map_or_else(|| self.current.run().text(), |apart| &apart.text)
    }

    /// The lines of the text.
    pub fn lines(&self) -> &LineIndex {
        self.apart.as_ref().map_or_else(|| self.current.lines(), |apart| &apart.lines)
    }

    /// The positions of the text.
    pub fn positions(&self, encoding: Encoding) -> Positions<'_> {
        Positions { text: self.text(), lines: self.lines(), encoding }
    }

    /// The run. Its text may continue after that of the document.
    pub fn run(&self) -> &Run {
        self.current.run()
    }

    /// Whether the run continues in subprograms from other files.
    pub fn has_subprograms(&self) -> bool {
        self.apart.is_some()
    }

    /// The text of the run with edits of the text. With subprograms, a run does not contain what follows the program
    /// (a final `%`).
    pub fn changed_run(&self, edits: &[Edit]) -> Vec<u8> {
        let end = self.end_of_program();
        let own = edits.partition_point(|edit| edit.span.end <= end);
        applied(self.run().text(), &edits[..own])
    }

    /// How it is run and checked.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// The language that its configuration sets.
    pub fn language(&self) -> Option<Language> {
        self.settings.language
    }

    // ---- changes ----------------------------------------------------------------------------------------

    /// Replaces the whole text.
    pub fn set_text(&mut self, text: String) {
        let text = text.into_bytes();
        (self.apart, self.is_joined, self.may_call) = (None, false, may_call(&text));
        self.current.set_text(text, self.settings.setup.clone());
    }

    /// Replaces a range.
    pub fn edit(&mut self, change: &TextDocumentContentChangePartial, encoding: Encoding) {
        let span = self.positions(encoding).span(change.range);
        self.is_joined = false;
        match &mut self.apart {
            Some(apart) => apart.edit(span, &change.text),
            None => {
                let offset = |byte| self.current.lines().utf16_offset(self.current.run().text(), byte);
                let (from, to) = (offset(span.start), offset(span.end));
                self.current.edit(from, to, &change.text);
            }
        }
        let edited = span.start as usize..span.start as usize + change.text.len();
        self.may_call |= may_call(&self.text()[lines_around(self.text(), edited)]);
    }

    /// Changes how it is run and checked.
    pub fn set_settings(&mut self, settings: Settings) {
        (self.is_joined, self.messages, self.fixable, self.published) = (false, None, None, None);
        self.current.set_setup(settings.setup.clone());
        self.settings = settings;
    }

    /// Infers again what numbers without a decimal point count. Edits leave it as it was when the text was opened.
    pub fn infer_again(&mut self) {
        self.current.reinfer_decimal_rule();
    }

    /// Searches again for subprograms in other files.
    pub fn join_again(&mut self) {
        self.is_joined = false;
    }

    // ---- preparation ------------------------------------------------------------------------------------

    /// Prepares what a request needs, in one slice; returns true once it is ready.
    pub fn prepare(&mut self, address: &str, host: &dyn Host, need: Need, client: &Client) -> bool {
        if need == Need::Text {
            return true;
        }
        self.join(address, host);
        if !self.current.advance(BLOCKS) {
            return false;
        }
        match need {
            Need::Text | Need::Run => true,
            Need::Messages => self.find_messages(),
            Need::Fixes => self.find_fixable(),
            Need::Place(position) => self.find_block(self.positions(client.encoding).byte(position)),
            Need::Hints(range) => self.find_hints(self.positions(client.encoding).span(range), client.hints),
        }
    }

    /// Appends the subprograms that the text calls in other files.
    fn join(&mut self, address: &str, host: &dyn Host) {
        if self.is_joined {
            return;
        }
        self.is_joined = true;
        let most = self.settings.setup.limits.text;
        let joined = self.may_call.then(|| host.with_subprograms(address, self.text(), most)).flatten();
        match (joined, self.apart.take()) {
            (None, None) => {}
            (None, Some(apart)) => self.current.set_text(apart.text, self.settings.setup.clone()),
            (Some(joined), apart) => self.set_joined(joined, apart),
        }
    }

    fn set_joined(&mut self, mut joined: Joined, apart: Option<Box<Apart>>) {
        let run = std::mem::take(&mut joined.text);
        let (text, lines) = match apart {
            Some(apart) => (apart.text, apart.lines),
            None => (self.current.run().text().to_vec(), self.current.lines().clone()),
        };
        self.apart = Some(Box::new(Apart { text, lines, joined }));
        if self.current.run().text() != run {
            self.current.set_text(run, self.settings.setup.clone());
        }
    }

    /// Collects the messages.
    fn find_messages(&mut self) -> bool {
        let id = self.current.run().id();
        if self.messages.as_ref().is_none_or(|(of, _)| *of != id) {
            self.messages = Some((id, self.all_messages()));
        }
        true
    }

    fn all_messages(&self) -> Vec<Diagnostic> {
        let run = self.current.run();
        let mut all = run.diagnostics().to_vec();
        all.extend(run.machine_messages());
        self.own(all)
    }

    /// Collects the messages that have fixes.
    fn find_fixable(&mut self) -> bool {
        let id = self.current.run().id();
        if self.fixable.as_ref().is_none_or(|(of, _)| *of != id) {
            let all = self.current.run().diagnostics().iter();
            let fixable = all.filter(|found| !found.fixes.is_empty()).cloned().collect();
            self.fixable = Some((id, self.own(fixable)));
        }
        true
    }

    /// Messages of the run that are about the document and are not turned off, sorted by place.
    fn own(&self, mut all: Vec<Diagnostic>) -> Vec<Diagnostic> {
        sort_by_place(&mut all);
        if let Some(apart) = &self.apart {
            apart.joined.report_at_calls(&mut all, self.current.run().diagnostics());
        }
        all.retain(|found| self.settings.takes(found));
        all
    }

    /// Finds the block at a byte, in one slice.
    fn find_block(&mut self, byte: u32) -> bool {
        if byte > self.end_of_program() {
            // Nothing there is executed.
            self.asked = None;
            return true;
        }
        let asked = Some((self.current.run().id(), byte));
        if self.asked != asked {
            self.asked = asked;
            if self.question.ask(&self.current, byte, VisitChoice::Usual) {
                return true;
            }
        }
        self.question.look(&mut self.current, REPLAYED_BLOCKS)
    }

    /// Finds the hints in a span, in one slice.
    fn find_hints(&mut self, span: Span, kinds: HintKinds) -> bool {
        let end = self.end_of_program();
        let span = Span { start: span.start.min(end), end: span.end.min(end) };
        self.asked = None;
        let run = self.current.run().id();
        let Self { current, question, hinting, .. } = self;
        let hinting = match hinting {
            Some(hinting) if hinting.is_about(run, span) => hinting,
            hinting => hinting.insert(Hinting::new(current.run(), span, kinds)),
        };
        hinting.advance(current, question, REPLAYED_BLOCKS)
    }

    /// The byte after the program; the run may continue with subprograms there.
    fn end_of_program(&self) -> u32 {
        self.apart.as_ref().map_or(u32::MAX, |apart| apart.joined.own() as u32)
    }

    // ---- answers ----------------------------------------------------------------------------------------

    /// The messages, once they are prepared.
    pub fn messages(&self) -> &[Diagnostic] {
        self.messages.as_ref().map_or(&[], |(_, messages)| messages)
    }

    /// The messages that have fixes, once they are prepared.
    pub fn fixable(&self) -> &[Diagnostic] {
        self.fixable.as_ref().map_or(&[], |(_, messages)| messages)
    }

    /// The byte of the prepared place, and the execution of the block there.
    pub fn found(&self) -> Option<(u32, &Found)> {
        let (_, byte) = self.asked?;
        Some((byte, self.question.found(&self.current)?))
    }

    /// The hints, once they are prepared.
    pub fn hints(&self) -> &[Hint] {
        self.hinting.as_ref().map_or(&[], |hinting| &hinting.found)
    }

    /// Whether its messages have changed since they were sent.
    pub fn is_to_publish(&self) -> bool {
        !self.is_joined || self.published != Some(self.current.run().id())
    }

    /// Notes that its messages were sent.
    pub fn set_published(&mut self) {
        self.published = Some(self.current.run().id());
    }
}

impl Apart {
    fn edit(&mut self, span: Span, insert: &str) {
        let replaced = span.start as usize..span.end as usize;
        self.text.splice(replaced.clone(), insert.bytes());
        self.lines.edit(&self.text, replaced, insert.len());
    }
}

/// The bytes of the lines that a range touches.
fn lines_around(text: &[u8], range: Range<usize>) -> Range<usize> {
    let (first, last) = (line_around(text, range.start), line_around(text, range.end));
    first.start as usize..last.end as usize
}
