//! The contour between blocks ns and nf of G70 to G73 (GSK980TDb p. 102).
//!
//! In: P and Q. Out: the moves of these blocks. The interpreter itself reads them into a list instead of the
//! motion list, so that a contour may contain everything that a path may.

use super::core::shortened;
use super::repairs::REPAIRS;
use super::request::Request;
use super::{BlockPosition, Flow, Interpreter};
use crate::control::codes::{self, Compensation, G, MotionMode, Multiple, Plane};
use crate::control::contour::{ContourUse, FirstBlock, Landmarks};
use crate::control::doubt::Doubt;
use crate::control::events::{ContourCall, Event, Observer};
use crate::control::modal::{PathMove, State};
use crate::control::words::{Words, letters, plain, quote};
use crate::cycles::{Approach, Contour, Piece};
use crate::geometry::Point;
use crate::limits::BYTES_PER_STEP;
use crate::message::{Diagnostic, Fix, Message, Severity, said};
use crate::motion::MotionKind;
use crate::parts::late;
use crate::source::Span;
use crate::text::block::{Block, BlockKind, Value};
use crate::text::parser::{Parser, Resume};

/// The contours of a run.
#[derive(Default)]
pub(super) struct Contours {
    /// The motions of a contour while it is read; they are kept here instead of being stored.
    pub recorded: Option<Vec<PathMove>>,
    /// Why a contour is read, while one is.
    pub purpose: Option<ContourUse>,
    /// Compensation as programmed, while a contour is read for a roughing cycle, which ignores it.
    pub ignored_compensation: Compensation,
    /// Positions of the contour cycles, for the picture.
    pub landmarks: Vec<Landmarks>,
    /// The contours of G71 to G73.
    roughed: Vec<Roughed>,
}

struct Roughed {
    /// P and Q.
    named: (u32, u32),
    /// Its first block.
    begins: Resume,
    /// First byte of its program.
    program: u32,
}

/// The contour from block ns to nf, as executed; after an error, the part that could be read.
pub(super) struct Shape {
    /// The moves of the contour.
    pub moves: Vec<PathMove>,
    /// Contents of the first block.
    pub first: FirstBlock,
    /// Span of the first block.
    pub first_span: Span,
    /// The first byte of block ns.
    pub begins: u32,
    /// Where the program continues after nf.
    pub ends: Resume,
    /// The state of the control after nf.
    pub state: State,
    /// The observer after nf.
    pub observer: Option<Box<dyn Observer>>,
}

/// Carries out a block of a contour: [`Interpreter::run`], which is above this file.
pub(super) type RunBlock = fn(&mut Interpreter, &[u8], &Block, BlockPosition) -> Flow;

/// Why a contour could not be read.
enum ShapeError {
    /// Another operation is in between. Reported.
    OtherOperation,
    /// nf was not found.
    NotFound,
}

/// Whether a contour may contain a block.
enum InContour {
    Allowed,
    /// It is ignored. Reported.
    Ignored,
    /// It is an error. Reported.
    Forbidden,
    /// It begins another cycle, with this word.
    OtherOperation(String),
}

impl Interpreter {
    /// Reads the contour given by P and Q. `None`: the error was reported; the program continues after nf if
    /// nf was found. The contour of a roughing cycle without a feed rate is in doubt.
    pub(super) fn shape(
        &mut self,
        text: &[u8],
        block: &Block,
        words: &Words,
        code: &'static str,
        purpose: ContourUse,
        run: RunBlock,
    ) -> Option<Shape> {
        for word in [b'P', b'Q'].into_iter().filter_map(|address| words.get(address)) {
            if !self.is_whole(text, word) {
                return None;
            }
        }
        // `get`, because the message explains the word.
        if let Some(address) = [b'X', b'Z'].into_iter().find(|&address| words.get(address).is_some()) {
            let message = said::CycleWord { code, word: words.quote(text, address) };
            let severity = if self.dialect.strict { Severity::Error } else { Severity::Warning };
            self.report(Diagnostic::new(message, words.span(address)).with_severity(severity));
            if severity == Severity::Error {
                return None;
            }
        }
        if self.state.plane != Plane::Zx {
            let message = said::CyclePlane { code, alarm: "PS0327" };
            let span = block.words_span();
            self.report(Diagnostic::new(message, span).with(Fix::insert(span.start, "G18 ".to_owned())));
            return None;
        }
        let named = |address: u8| words.get(address).and_then(plain).map(|number| number as u32);
        let (Some(first), Some(last)) = (named(b'P'), named(b'Q')) else {
            self.report(Diagnostic::new(said::ContourNotNamed { code }, block.words_span()));
            return None;
        };
        self.observe(text, Event::ContourNamed { purpose, named: (first, last) });
        // G70 uses the blocks that roughing found, because FANUC keeps their positions; all other cycles
        // search.
        let roughed = match purpose {
            ContourUse::Roughing => None,
            ContourUse::Finishing => self.roughed_in_program(text, block, (first, last)),
        };
        let Some(begins) = roughed.or_else(|| self.program.labels(text).find(first, block.span.start)) else {
            let word = words.quote(text, b'P');
            let diagnostic = Diagnostic::new(said::ContourNotFound { word }, words.span(b'P'));
            let may_offer = REPAIRS.is_loaded() && self.sink.has_room_for(&diagnostic);
            let fix = may_offer.then(|| number_missing(text, block.span.end, first, false)).flatten();
            self.report(Diagnostic { fixes: fix.into_iter().collect(), ..diagnostic });
            return None;
        };
        if !self.program.labels(text).is_at_or_after(last, begins.byte) {
            let word = words.quote(text, b'Q');
            let message: Message = match self.program.labels(text).find(last, block.span.start) {
                Some(_) => said::ContourReversed { first, word }.into(),
                None => said::ContourNotFound { word }.into(),
            };
            let is_missing = message.is::<said::ContourNotFound>();
            let diagnostic = Diagnostic::new(message, words.span(b'Q'));
            let may_offer = is_missing && REPAIRS.is_loaded() && self.sink.has_room_for(&diagnostic);
            let fix = may_offer.then(|| number_missing(text, begins.byte, last, true)).flatten();
            self.report(Diagnostic { fixes: fix.into_iter().collect(), ..diagnostic });
            return None;
        }
        // Reports a sequence number that also appears a second time within the contour.
        for (address, number) in [(b'P', first), (b'Q', last)] {
            let again = self.program.labels(text).find(number, begins.byte.max(block.span.start));
            let other = again.filter(|again| again.byte > begins.byte);
            let other = match address {
                b'P' => other,
                _ => other
                    .and_then(|first| self.program.labels(text).find(number, first.byte))
                    .filter(|next| Some(*next) != again && next.byte > begins.byte),
            };
            if let Some(other) = other.filter(|_| purpose == ContourUse::Roughing) {
                let message = said::DuplicateSequence { sequence: number, line: other.line + 1 };
                self.report(Diagnostic::new(message, words.span(address)));
            }
        }
        let before = self.state.clone();
        if let Some(recorder) = &mut self.recorder {
            recorder.contour_begins();
        }
        let aside = self.observer.as_mut().map(|observer| observer.fork_for_contour());
        let outer = self.contours.recorded.replace(Vec::new());
        let outer_purpose = self.contours.purpose.replace(purpose);
        let no_feed = before.feed.unwrap_or(0.0) == 0.0;
        if purpose == ContourUse::Roughing && no_feed {
            // The F of the contour is ignored. A missing F is reported for the cycle, not for each of these
            // blocks.
            self.state.feed = Some(1.0);
        }
        let read = self.read_shape(text, block, (begins, last), code, purpose, run);
        let moves = std::mem::replace(&mut self.contours.recorded, outer).unwrap_or_default();
        self.contours.purpose = outer_purpose;
        let reported = self.state.reported;
        let mut state = std::mem::replace(&mut self.state, before);
        if let Some(recorder) = &mut self.recorder {
            recorder.contour_ends();
        }
        self.state.reported = reported;
        let observer = self.replace_observer(aside);
        if self.sink.is_full() {
            return None;
        }
        let most = self.setup.limits.moves_per_cycle;
        // Other errors of the cycle are reported only if its contour is correct.
        let reads_sound = read.is_ok() && !state.doubts.has(Doubt::Contour);
        let may_cut = purpose == ContourUse::Finishing
            || reads_sound && self.may_cut(text, block, words, &mut Request::default());
        if !may_cut {
            state.doubts.add(Doubt::Contour);
        }
        let is_valid = reads_sound && may_cut;
        match read {
            Ok((.., ends)) if moves.len() > most => {
                if is_valid {
                    self.report(Diagnostic::new(said::TooManyPasses { code, most }, block.words_span()));
                }
                self.continue_after_contour(block, begins.byte, ends);
                None
            }
            Ok((first_block, first_span, ends)) => {
                let shape = Shape {
                    moves,
                    first: first_block,
                    first_span,
                    begins: begins.byte,
                    ends,
                    state,
                    observer,
                };
                if !is_valid {
                    self.state.doubts.add(Doubt::Contour);
                    self.state.incomplete = true;
                } else if self.contours.landmarks.len() < self.setup.limits.messages {
                    let (start, span) = (self.state.position, block.span);
                    let contour = shape.contour(start);
                    let (a, b) = (contour.first, contour.last());
                    let (named, roughed) = ((first, last), purpose == ContourUse::Roughing);
                    self.contours.landmarks.push(Landmarks {
                        span,
                        start,
                        first: a,
                        last: b,
                        zero: self.state.frames.on_workpiece(),
                        named,
                        roughed,
                    });
                    if roughed {
                        let program = self.program.labels(text).head_at(begins.byte).byte;
                        self.contours.roughed.push(Roughed { named, begins, program });
                    }
                }
                Some(shape)
            }
            // The blocks in between are no contour: they run as written.
            Err(ShapeError::OtherOperation) => None,
            Err(ShapeError::NotFound) => {
                let word = words.quote(text, b'Q');
                self.report(Diagnostic::new(said::ContourNotFound { word }, words.span(b'Q')));
                None
            }
        }
    }

    /// The beginning of the contour with these numbers that a roughing cycle has found in the program of
    /// `block`.
    fn roughed_in_program(&mut self, text: &[u8], block: &Block, named: (u32, u32)) -> Option<Resume> {
        let own = self.program.labels(text).head_at(block.span.start).byte;
        let found =
            self.contours.roughed.iter().rev().find(|other| (other.named, other.program) == (named, own));
        found.map(|found| found.begins)
    }

    /// Runs the blocks ns to nf. After an error in one of them the contour is in [doubt](Doubt::Contour).
    fn read_shape(
        &mut self,
        text: &[u8],
        cycle: &Block,
        (begins, last): (Resume, u32),
        code: &'static str,
        purpose: ContourUse,
        run: RunBlock,
    ) -> Result<(FirstBlock, Span, Resume), ShapeError> {
        if purpose == ContourUse::Roughing {
            self.contours.ignored_compensation =
                std::mem::replace(&mut self.state.compensation, Compensation::Off);
            self.state.tip = None;
        }
        let mut parser = Parser::resume(text, begins);
        let mut block = Block::default();
        let mut first = None;
        let mut sound = true;
        loop {
            let at = parser.position();
            if !parser.next_block(&mut block) {
                break;
            }
            let here = BlockPosition { at, next: parser.position() };
            if !self.spend(1 + block.span.len() / BYTES_PER_STEP, cycle) {
                break;
            }
            let is_first = first.is_none();
            let (named, span) = *first.get_or_insert_with(|| (self.first_block(&block), block.span));
            self.report_faults(&block);
            match self.allowed_in_contour(text, &block) {
                InContour::Allowed => sound &= !block.is_broken(),
                InContour::Ignored => {
                    if block.sequence == Some(last) {
                        self.end_shape(sound);
                        return Ok((named, span, parser.position()));
                    }
                    continue;
                }
                InContour::Forbidden => sound = false,
                InContour::OtherOperation(word) => {
                    let line = block.line + 1;
                    let message = said::ContourReachesOver { code, word, line };
                    self.report(Diagnostic::new(message, cycle.words_span()));
                    return Err(ShapeError::OtherOperation);
                }
            }
            let moves = self.contours.recorded.as_ref().map_or(0, Vec::len);
            let refused = std::mem::replace(&mut self.block_failed, false);
            if let Some(recorder) = &mut self.recorder {
                recorder.before_reading(at, &self.state);
            }
            let flow = run(self, text, &block, here);
            if let Some(recorder) = &mut self.recorder {
                recorder.after_reading(&block, &self.state, purpose);
            }
            if block.kind == BlockKind::Macro && matches!(flow, Flow::Jump(_)) {
                let span = block.words_span();
                let word = shortened(&span.quote(text));
                self.report(Diagnostic::new(said::ContourIllegal { word }, span));
                sound = false;
            }
            sound &= !self.block_failed;
            self.block_failed |= refused;
            if is_first {
                let straight = matches!(self.state.motion, MotionMode::Rapid | MotionMode::Line);
                let moved = self.contours.recorded.as_ref().map_or(0, Vec::len) > moves;
                // One error, one message.
                let stays = !moved && !named.x && !named.z;
                if sound && (!straight || stays) {
                    self.report(Diagnostic::new(said::ContourFirstBlock { code }, block.words_span()));
                    sound = false;
                }
                if stays {
                    // The contour is drawn from the first block that moves.
                    first = None;
                }
            }
            if block.sequence == Some(last) {
                self.end_shape(sound);
                return Ok((named, span, parser.position()));
            }
            if block.program.is_some() && !is_first {
                break;
            }
        }
        Err(ShapeError::NotFound)
    }

    /// Ends the contour: no move may wait for another. `sound`: no error was reported before.
    fn end_shape(&mut self, sound: bool) {
        let waits = self.state.pending.take().and_then(|pending| {
            let angle = pending.angle.map(|angle| (angle.word, angle.span, "PS0326"));
            angle.or(pending.joint.map(|joint| (joint.word, joint.span, "PS0069")))
        });
        self.leave_compensation();
        self.state.tip = None;
        let waits_for_a_move = waits.is_some();
        if let Some((word, span, alarm)) = waits {
            self.report(Diagnostic::new(said::ContourOpenEnd { word, alarm }, span));
        }
        if !sound || waits_for_a_move {
            self.state.doubts.add(Doubt::Contour);
        }
    }

    /// The program continues after a contour that follows its cycle block. A contour before the cycle block
    /// has already run (GSK980TDb p. 102).
    pub(super) fn continue_after_contour(&mut self, block: &Block, begins: u32, ends: Resume) {
        if begins > block.span.start {
            self.program.jump = Some(ends);
        }
    }

    fn first_block(&self, block: &Block) -> FirstBlock {
        let reading = self.reading();
        let mut first = FirstBlock::default();
        for word in &block.words {
            let zero = reading.length(word) == Some(0.0);
            match word.address {
                b'X' => first.x = true,
                b'Z' => first.z = true,
                b'U' => (first.x, first.u_zero) = (true, zero),
                b'W' => (first.z, first.w_zero) = (true, zero),
                _ => {}
            }
            match word.address {
                b'X' | b'U' => first.x_word = word.span,
                b'Z' | b'W' => first.z_word = word.span,
                _ => {}
            }
        }
        first
    }

    /// A contour may contain only moves (alarm PS0325). A retract or setting in between is ignored unless the
    /// control is strict: in many programs Q names the block after the contour.
    fn allowed_in_contour(&mut self, text: &[u8], block: &Block) -> InContour {
        let skips = !self.dialect.strict;
        for word in &block.words {
            let Value::Number { number, .. } = word.value else { continue };
            let quoted = || quote(text, word.span);
            let illegal = |severity| (said::ContourIllegal { word: quoted() }.into(), severity);
            let (message, severity): (Message, Severity) = match word.address {
                b'M' => match number.mantissa {
                    98 | 99 => (said::ContourCall { word: quoted() }.into(), Severity::Error),
                    // The program would end in the middle of the cycle.
                    2 | 30 => illegal(Severity::Error),
                    _ => continue,
                },
                b'G' => {
                    let key = number.tenths();
                    let found = key.and_then(|key| codes::g_code(key, self.dialect.code_list()));
                    match found.map(|found| found.code) {
                        Some(
                            G::Motion(MotionMode::Rapid | MotionMode::Line | MotionMode::Arc(_))
                            | G::Dwell
                            | G::Plane(Plane::Zx)
                            | G::Compensation(_)
                            | G::Distance { .. }
                            | G::HoleReturn(_)
                            | G::SurfaceSpeed
                            | G::ConstantSpeed
                            | G::Feed(_),
                        ) => continue,
                        Some(G::MacroCall(_)) => {
                            (said::ContourCall { word: quoted() }.into(), Severity::Error)
                        }
                        // G70 repeats blocks: some programs use it to drill a hole again.
                        Some(G::Hole(_) | G::NoHole)
                            if skips && self.contours.purpose == Some(ContourUse::Finishing) =>
                        {
                            let message = said::ContourIllegal { word: quoted() };
                            self.report(Diagnostic::new(message, word.span).with_severity(Severity::Warning));
                            continue;
                        }
                        Some(G::Multiple(_) | G::Motion(MotionMode::Cycle(_)) | G::Hole(_)) => {
                            return InContour::OtherOperation(quoted());
                        }
                        _ if skips => illegal(Severity::Warning),
                        _ => illegal(Severity::Error),
                    }
                }
                _ => continue,
            };
            self.report(Diagnostic::new(message, word.span).with_severity(severity));
            return if severity == Severity::Error { InContour::Forbidden } else { InContour::Ignored };
        }
        InContour::Allowed
    }
}

impl Shape {
    /// Whether the contour has no reported error.
    pub(super) fn is_valid(&self) -> bool {
        !self.state.doubts.has(Doubt::Contour)
    }

    /// The event data of a cycle that reads this shape as its contour.
    pub(super) fn call<'a, How>(
        &self,
        block: &'a Block,
        words: &'a Words<'a>,
        contour: &'a Contour,
        how: &'a How,
    ) -> ContourCall<'a, How> {
        let last_span = self.span_of(contour.pieces.len().saturating_sub(1));
        let (first, first_span) = (self.first, self.first_span);
        ContourCall { block, words, contour, first, first_span, last_span, how }
    }

    /// The contour for a roughing cycle that starts at A: rapids inside it are cut at feed.
    pub(super) fn contour(&self, start: Point) -> Contour {
        let own = self.moves.first().filter(|path_move| path_move.span == self.first_span);
        let (first, approach) = match own {
            Some(path_move) if path_move.motion.kind == MotionKind::Rapid => {
                (path_move.motion.to, Approach::Rapid)
            }
            Some(path_move) => (path_move.motion.to, Approach::Feed),
            None => (start, Approach::Rapid),
        };
        let rest = &self.moves[usize::from(own.is_some())..];
        let pieces =
            rest.iter().filter(|path_move| path_move.motion.kind != MotionKind::Dwell).map(|path_move| {
                let motion = path_move.motion;
                let turn = motion.arc().map(|arc| (arc.center, arc.turn));
                Piece { from: motion.from, to: motion.to, arc: turn }
            });
        Contour { start, first, approach, pieces: pieces.filter(|piece| !piece.is_empty()).collect() }
    }

    /// The contour without the rapids at its end; `None` if there are none. In many programs the contour ends
    /// with a rapid away from it and back, which is not part of the shape to be roughed.
    pub(super) fn without_final_rapids(&self, contour: &Contour) -> Option<Contour> {
        let rapids = self
            .moves
            .iter()
            .rev()
            .take_while(|path_move| path_move.motion.kind == MotionKind::Rapid)
            .count();
        let left = contour.pieces.len().checked_sub(rapids).filter(|&left| rapids > 0 && left > 0)?;
        Some(Contour { pieces: contour.pieces[..left].to_vec(), ..contour.clone() })
    }

    /// Line (from 1) of the block that made piece `piece` of the contour.
    pub(super) fn line_of(&self, piece: usize) -> u32 {
        self.move_of(piece).map_or(0, |path_move| path_move.line + 1)
    }

    /// The block that made piece `piece` of the contour.
    pub(super) fn span_of(&self, piece: usize) -> Option<Span> {
        self.move_of(piece).map(|path_move| path_move.span)
    }

    fn move_of(&self, piece: usize) -> Option<&PathMove> {
        let own = usize::from(self.moves.first().is_some_and(|path_move| path_move.span == self.first_span));
        self.moves.get(piece + own).or(self.moves.last())
    }
}

late! {
    fn number_missing(text: &[u8], from: u32, number: u32, last: bool) -> Option<Fix> {
        numbered(text, from, number, last)
    }
}

/// A fix that adds a sequence number: to the block that begins a contour, after byte `from`, or to the block
/// that ends it, which is the last one before a retract, another cycle or another tool.
fn numbered(text: &[u8], from: u32, number: u32, last: bool) -> Option<Fix> {
    /// Maximum number of blocks searched.
    const MAX_BLOCKS: usize = 500;
    let mut parser = Parser::resume(text, Resume::inside(from, 0));
    let mut block = Block::default();
    let mut found = None;
    for count in 0..MAX_BLOCKS {
        if !parser.next_block(&mut block) {
            break;
        }
        let moves = block.words.iter().any(|word| b"XZUW".contains(&word.address));
        let rapid = block.words.iter().any(|word| word.address == b'G' && plain(word) == Some(0.0));
        let leaves = block.words.iter().any(|word| match word.address {
            b'G' => plain(word).is_some_and(|code| code >= 28.0 && !(40.0..=42.0).contains(&code)),
            b'T' | b'M' => true,
            _ => false,
        });
        if last && count > 0 && (leaves || rapid) {
            break;
        }
        if block.span.start < from || !moves || leaves {
            continue;
        }
        found = Some((block.span.start, block.sequence.is_none()));
        if !last {
            break;
        }
    }
    let (at, free) = found?;
    free.then(|| Fix::insert(at, format!("N{number} ")))
}

/// What a cycle reads a contour for; `None` if its block names none.
pub(super) fn contour_use_of(cycle: Multiple, words: &Words) -> Option<ContourUse> {
    match cycle {
        Multiple::Finishing => Some(ContourUse::Finishing),
        _ if cycle.is_roughing() && words.has_any(letters(b"PQ")) => Some(ContourUse::Roughing),
        _ => None,
    }
}
