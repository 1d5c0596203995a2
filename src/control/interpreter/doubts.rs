//! Doubts: values that are unknown after a failed block, and the words that make them known again.
//!
//! In: refused blocks, and calls of missing programs. Out: [`Doubts`] of the state. A motion is uncertain if
//! its start, end or path depends on something in doubt. The next absolute position of an axis makes that
//! axis certain again.

use super::Interpreter;
use super::request::{OneShot, Request};
use crate::control::codes::cycles::CycleBlock;
use crate::control::codes::{self, Function, MotionMode, Switch};
use crate::control::doubt::{Doubt, Doubts};
use crate::control::events::Event;
use crate::control::modal::Once;
use crate::control::words::{Words, letters, plain};
use crate::limits::BYTES_PER_STEP;
use crate::message::{Diagnostic, said};
use crate::setup::dialect::XuConflict;
use crate::text::block::{Block, Value, is_read_as_meant};
use crate::text::parser::{Parser, Resume};

/// The position of the tip.
const PLACE: Doubts = Doubts::of(&[Doubt::X, Doubt::Z]);

/// What a missing program may have changed. It may also have set a tool or a frame, but few programs leave
/// them changed.
const BY_A_PROGRAM: Doubts = Doubts::of(&[Doubt::X, Doubt::Z, Doubt::C, Doubt::Code, Doubt::Values]);

impl Interpreter {
    /// Something was left out: material may remain that the program removes.
    #[cold]
    pub(super) fn mark_left_out(&mut self) {
        self.state.incomplete = true;
        self.block_failed = true;
        self.trace_refusal();
        self.observe(&[], Event::LeftOut);
    }

    /// Adds these doubts.
    #[cold]
    pub(super) fn add_doubts(&mut self, lost: Doubts) {
        self.mark_left_out();
        self.state.doubts.join(lost);
        if lost.has_any(PLACE)
            && let Some(compensating) = &mut self.state.compensating
        {
            // The waiting moves end at the start of the next move, which is uncertain.
            for (_, path_move) in &mut compensating.waiting {
                path_move.motion.process.uncertain = true;
            }
        }
    }

    /// Marks the position of the tip as doubtful.
    #[cold]
    pub(super) fn doubt_position(&mut self) {
        self.add_doubts(PLACE);
    }

    /// Marks the path of the next move as doubtful: it may begin elsewhere.
    #[cold]
    pub(super) fn doubt_path(&mut self) {
        self.add_doubts(Doubts::of(&[Doubt::Path]));
    }

    /// A missing program, or a jump to a missing block: no messages are reported about values that it may
    /// have set.
    #[cold]
    pub(super) fn doubt_after_missing_program(&mut self) {
        self.add_doubts(BY_A_PROGRAM);
        self.state.reported.mark_reported(Once::NoFeed);
        self.observe(&[], Event::SettingsUnknown);
    }

    /// A macro statement was not carried out.
    #[cold]
    pub(super) fn doubt_statement(&mut self, statement: &[u8]) {
        let assigns = statement.trim_ascii_start().first() == Some(&b'#');
        self.add_doubts(if assigns { Doubts::of(&[Doubt::Values]) } else { BY_A_PROGRAM });
    }

    /// A block was refused: its axes are not at the programmed positions.
    #[cold]
    pub(super) fn refuse(&mut self, text: &[u8], block: &Block, request: &Request, words: &Words) {
        self.suppress_missing_feed(text, block);
        let mut lost = faults_of(text, block);
        let mut named = Doubts::default();
        for (doubt, letters) in
            [(Doubt::X, letters(b"XU")), (Doubt::Z, letters(b"ZW")), (Doubt::C, letters(b"CH"))]
        {
            if words.has_any(letters) {
                named.add(doubt);
            }
        }
        match request.one_shot {
            // These return to their start point.
            Some(OneShot::Multiple(cycle)) => {
                lost = Doubts::default();
                if cycle.spec().block(words.given()) == CycleBlock::First {
                    lost.add(Doubt::Cycle);
                }
            }
            Some(OneShot::Dwell) => {}
            Some(OneShot::Polar(Switch::On) | OneShot::Cylinder) if self.state.virtual_plane.is_none() => {
                lost.add(Doubt::Coordinates);
            }
            Some(OneShot::Polar(_) | OneShot::Cylinder) => {}
            Some(
                OneShot::Home
                | OneShot::OtherHome
                | OneShot::CheckHome
                | OneShot::FromHome
                | OneShot::Machine
                | OneShot::Data
                | OneShot::Setting
                | OneShot::LocalFrame
                | OneShot::NotSupported,
            ) => lost.join(named),
            None if self.state.hole.is_some() => lost.join(PLACE),
            None if matches!(request.motion.unwrap_or(self.state.motion), MotionMode::Cycle(_)) => {
                let code_is_known = !lost.has(Doubt::Code);
                lost = if code_is_known { Doubts::default() } else { lost };
                lost.add(Doubt::Cycle);
            }
            None if request.comma[2].is_some() || words.peek(b'A').is_some() => lost.join(PLACE),
            None => lost.join(named),
        }
        self.add_doubts(lost);
    }

    /// Suppresses the message for a missing feed if an F could not be read: it is the same error.
    #[cold]
    pub(super) fn suppress_missing_feed(&mut self, text: &[u8], block: &Block) {
        let is_feed = |at: u32| text.get(at as usize).is_some_and(|byte| byte.eq_ignore_ascii_case(&b'F'));
        let has_feed = block.faults.iter().any(|fault| is_feed(fault.span.start))
            || block.words.iter().any(|word| word.address == b'F');
        if self.state.feed.is_none() && has_feed {
            self.state.reported.mark_reported(Once::NoFeed);
        }
    }

    /// Skips the contour of a cycle whose block cannot be parsed: the contour does not run as part of the
    /// program.
    #[cold]
    pub(super) fn skip_contour(&mut self, text: &[u8], cycle: &Block, words: &Words) {
        let sequence = |address: u8| words.peek(address).and_then(plain).map(|number| number as u32);
        if self.program.jump.is_some() || self.contours.recorded.is_some() {
            return;
        }
        let (Some(first), Some(last)) = (sequence(b'P'), sequence(b'Q')) else {
            // The contour runs as if there were no cycle.
            if words.has_any(letters(b"PQ")) {
                self.doubt_position();
            }
            return;
        };
        let behind = |at: &Resume| at.byte > cycle.span.start;
        let Some(begins) = self.program.labels(text).find(first, cycle.span.start).filter(behind) else {
            return;
        };
        let mut parser = Parser::resume(text, begins);
        let mut block = Block::default();
        let mut faults = Vec::new();
        while parser.next_block(&mut block) && self.spend(1 + block.span.len() / BYTES_PER_STEP, cycle) {
            faults.append(&mut block.faults.clone());
            if block.sequence == Some(last) {
                faults.into_iter().for_each(|fault| self.report(fault));
                self.program.jump = Some(parser.position());
                return;
            }
        }
    }

    /// A code that is recognised but not supported: how long the following moves are in doubt depends on its
    /// function.
    #[cold]
    pub(super) fn doubt_after_unsupported(&mut self, tenths: Option<u64>, words: &Words) {
        match tenths {
            // High-speed cutting: the same path.
            Some(50 | 51) => {}
            // Polygons, mirror images, rotated and polar coordinates, until they are switched off.
            Some(160 | 511 | 512 | 680..=684) => self.add_doubts(Doubts::of(&[Doubt::Coordinates])),
            _ => {
                let mut lost = Doubts::default();
                // They may be modal, in which case the following blocks move in the same way.
                let code = tenths.and_then(|key| codes::g_code(key, self.dialect.code_list()));
                if let Some(Function::OtherInterpolation | Function::OtherCycles) =
                    code.map(codes::GCode::function)
                {
                    lost.add(Doubt::Code);
                }
                for (doubt, letters) in [(Doubt::X, letters(b"XU")), (Doubt::Z, letters(b"ZW"))] {
                    if words.has_any(letters) {
                        lost.add(doubt);
                    }
                }
                self.add_doubts(lost);
            }
        }
    }

    /// Coordinates have their usual meaning again; the position of the tip remains unknown.
    #[cold]
    pub(super) fn clear_coordinate_doubts(&mut self) {
        if self.state.doubts.has(Doubt::Coordinates) {
            self.state.doubts.remove(Doubt::Coordinates);
            self.doubt_position();
        }
    }

    /// At the start of a block: removes doubts that the block ends, and adds doubts that it depends on.
    #[cold]
    pub(super) fn doubt_block(&mut self, request: &Request, words: &Words) {
        let doubts = &mut self.state.doubts;
        if doubts.has(Doubt::Code) && request.uses_modal_code() {
            doubts.add(Doubt::Path);
        }
        let leaves_cycle = request.motion.is_some_and(|mode| !matches!(mode, MotionMode::Cycle(_)));
        let names_all = matches!(request.motion.unwrap_or(self.state.motion), MotionMode::Cycle(_))
            && words.has_any(letters(b"XU"))
            && words.has_any(letters(b"ZW"))
            && (request.motion.is_some() || words.has_any(letters(b"RIK")));
        if leaves_cycle || names_all || request.hole.is_some() {
            doubts.remove(Doubt::Cycle);
        }
    }

    /// After a block that was carried out: removes the doubts that it ends. `before`: the doubts at its
    /// start.
    #[cold]
    pub(super) fn clear_doubts(&mut self, request: &Request, words: &Words, before: Doubts) {
        let by_angle = request.comma[2].is_some() || words.peek(b'A').is_some();
        for doubt in [Doubt::X, Doubt::Z, Doubt::C] {
            let known = self.ends_at_place(request, words, doubt);
            let doubts = &mut self.state.doubts;
            if known {
                doubts.remove(doubt);
            } else if by_angle && doubts.has_any(PLACE) && doubt != Doubt::C {
                // The end was computed from the start, which is in doubt.
                doubts.add(doubt);
            }
        }
        let doubts = &mut self.state.doubts;
        if let Some(OneShot::Multiple(cycle)) = request.one_shot
            && cycle.spec().block(words.given()) == CycleBlock::First
        {
            doubts.remove(Doubt::Cycle);
        }
        if request.moved && before.has(Doubt::Path) {
            doubts.remove(Doubt::Path);
        }
    }

    /// Whether a block that was carried out has moved an axis (X, Z or C) to a position that does not depend
    /// on its previous position.
    pub(super) fn ends_at_place(&self, request: &Request, words: &Words, axis: Doubt) -> bool {
        let (absolute, incremental) = match axis {
            Doubt::X => (b'X', b'U'),
            Doubt::Z => (b'Z', b'W'),
            _ => (b'C', b'H'),
        };
        let is_absolute = self.is_absolute(words, absolute, incremental);
        let hole = self.state.hole.map(|hole| hole.kind.is_face());
        match request.one_shot {
            Some(OneShot::Home | OneShot::OtherHome) => {
                words.peek(absolute).is_some() || words.peek(incremental).is_some()
            }
            Some(OneShot::CheckHome | OneShot::FromHome | OneShot::Machine | OneShot::Setting) => is_absolute,
            Some(
                OneShot::Dwell
                | OneShot::Data
                | OneShot::LocalFrame
                | OneShot::Polar(_)
                | OneShot::Cylinder
                | OneShot::Multiple(_)
                | OneShot::NotSupported,
            ) => false,
            // A hole has one position and one depth, and the tool returns from the hole.
            None if hole.is_some() => is_absolute && (axis == Doubt::X) == (hole == Some(true)),
            None => match self.state.motion {
                // They return to their start point.
                MotionMode::Cycle(_) | MotionMode::Tapping => false,
                MotionMode::Rapid
                | MotionMode::Line
                | MotionMode::Arc(_)
                | MotionMode::Thread
                | MotionMode::VariableThread => is_absolute,
            },
        }
    }

    /// Whether the effective word of an axis is absolute.
    fn is_absolute(&self, words: &Words, absolute: u8, incremental: u8) -> bool {
        match (words.peek(absolute), words.peek(incremental)) {
            (Some(_), None) => !self.state.incremental,
            (Some(absolute), Some(incremental)) => match self.dialect.xu_conflict {
                XuConflict::Absolute => true,
                XuConflict::Last => absolute.span.start > incremental.span.start,
            },
            (None, _) => false,
        }
    }

    /// The axes whose words in a block have a value from variables.
    pub(super) fn from_variables(block: &Block) -> Doubts {
        let mut found = Doubts::default();
        for word in block.words.iter().filter(|word| word.value == Value::Expression) {
            match word.address {
                b'X' | b'U' => found.add(Doubt::X),
                b'Z' | b'W' => found.add(Doubt::Z),
                b'C' | b'H' => found.add(Doubt::C),
                b'G' => found.add(Doubt::Code),
                b'I' | b'K' | b'R' | b'A' => found.add(Doubt::Path),
                _ => {}
            }
        }
        found
    }
}

/// The doubts that the syntax errors of a block cause.
pub(super) fn faults_of(text: &[u8], block: &Block) -> Doubts {
    let mut lost = Doubts::default();
    for fault in
        block.faults.iter().filter(|fault| fault.is_error() && !is_text(fault) && !is_read_as_meant(fault))
    {
        // If text may be words with misread digits, each of its letters may be an address.
        let addresses = fault.span.of(text);
        let most = if reads_as_text(fault) { addresses.len() } else { 1 };
        for address in addresses.iter().take(most) {
            lost.join(doubts_of_address(address.to_ascii_uppercase()));
        }
    }
    lost
}

/// The doubts after a word of this address that could not be read.
fn doubts_of_address(address: u8) -> Doubts {
    match address {
        b'X' | b'U' => Doubts::of(&[Doubt::X]),
        b'Z' | b'W' => Doubts::of(&[Doubt::Z]),
        b'C' | b'H' => Doubts::of(&[Doubt::C]),
        b'G' => Doubts::of(&[Doubt::X, Doubt::Z, Doubt::Code]),
        b'F' | b'S' | b'M' | b'N' | b'I' | b'K' | b'R' | b'P' | b'Q' | b'L' => Doubts::default(),
        // Tool offsets change the position; a number without an address may be a G code.
        b'T' => PLACE,
        _ => Doubts::of(&[Doubt::X, Doubt::Z, Doubt::Code]),
    }
}

fn reads_as_text(fault: &Diagnostic) -> bool {
    fault.message.is::<said::PlainText>() || fault.message.is::<said::PlainWords>()
}

/// Whether a syntax error can only be text: putting it in brackets changes nothing else.
pub(super) fn is_text(fault: &Diagnostic) -> bool {
    reads_as_text(fault) && fault.fixes.iter().any(|fix| fix.safe)
}
