//! G70 to G76 as blocks call them (seed 003): the common code, and the contour cycles. G74 and G75 are in
//! `pecks`, G76 in `threads`.
//!
//! In: the words of a block. Out: the moves of the cycle. `cycles` has the geometry; this file has the words,
//! their units and their alarms. After an error in its blocks or contour a cycle makes uncertain motions of
//! what could be read: its passes if they are known, otherwise the contour as written.

use super::Interpreter;
use super::contours::{RunBlock, Shape};
use super::cycle_moves::LENGTH_TOLERANCE;
use super::repairs::offer_other_sign;
use super::request::Request;
use crate::control::codes::Multiple;
use crate::control::contour::ContourUse;
use crate::control::doubt::Doubt;
use crate::control::events::{Event, FinishingCall};
use crate::control::modal::{PathMove, State};
use crate::control::words::{self, Words, letters, plain};
use crate::cycles::pattern::{self, Pattern};
use crate::cycles::roughing::{self, Direction, Roughing};
use crate::cycles::{Contour, Move};
use crate::geometry::Point;
use crate::message::{Diagnostic, Fix, Message, Severity, said};
use crate::motion::{Cycle, CycleStep, Motion, MotionKind, Step};
use crate::setup::dialect::{Control, G71Retract, G73Intervals};
use crate::text::block::Block;

impl Interpreter {
    pub(super) fn multiple(
        &mut self,
        text: &[u8],
        block: &Block,
        request: &mut Request,
        words: &Words,
        cycle: Multiple,
        shape: Option<Shape>,
    ) {
        if self.contours.recorded.is_some() {
            // Already reported: a contour may not contain a cycle.
            request.drop = true;
            return;
        }
        let done = match cycle {
            Multiple::Finishing => self.finishing(text, block, shape),
            Multiple::RoughTurning | Multiple::RoughFacing => self.roughing(text, block, words, cycle, shape),
            Multiple::Pattern => self.pattern(text, block, words, shape),
            Multiple::FacePecking | Multiple::Grooving => self.pecking(text, block, words, cycle),
            Multiple::Threading => self.multi_threading(text, block, words),
        };
        self.state.doubts.remove(Doubt::Contour);
        request.drop |= done.is_none();
    }

    /// G70: the contour as written, then back to the start point.
    fn finishing(&mut self, text: &[u8], block: &Block, shape: Option<Shape>) -> Option<()> {
        let shape = shape?;
        let start = self.state.position;
        if !shape.is_valid() {
            // Its blocks have not changed the modal state.
            self.push_contour(block, Cycle::Finishing, &shape.moves);
            self.return_to(block, Cycle::Finishing, start);
            self.continue_after_contour(block, shape.begins, shape.ends);
            return None;
        }
        let ends: Vec<_> = shape.moves.iter().map(|path_move| path_move.motion.to).collect();
        let leaves_at_rapid =
            shape.moves.last().is_some_and(|path_move| path_move.motion.kind == MotionKind::Rapid);
        let landmarks = std::mem::take(&mut self.contours.landmarks);
        let call = FinishingCall { block, landmarks: &landmarks, ends: &ends, leaves_at_rapid };
        self.observe(text, Event::Finishing(call));
        self.contours.landmarks = landmarks;
        self.push_contour(block, Cycle::Finishing, &shape.moves);
        // The blocks change the modal state as they would on their own; the tool returns to the start point.
        let (position, reported, doubts) = (self.state.position, self.state.reported, self.state.doubts);
        self.state = State { position, reported, doubts, ..shape.state };
        self.replace_observer(shape.observer);
        self.return_to(block, Cycle::Finishing, start);
        Some(())
    }

    /// G71 and G72.
    fn roughing(
        &mut self,
        text: &[u8],
        block: &Block,
        words: &Words,
        cycle: Multiple,
        shape: Option<Shape>,
    ) -> Option<()> {
        let code = cycle.cycle().code();
        let turning = cycle == Multiple::RoughTurning;
        let reading = self.reading();
        let length = |address: u8| words.get(address).and_then(|word| reading.length(word));
        let radius = |address: u8| words.get(address).and_then(|word| reading.radius(word));
        let depth_word = if turning { b'U' } else { b'W' };
        if !words.has_any(letters(b"PQ")) {
            // X or Z in the first block: a wrong letter for the depth (PS0066).
            if (!words.has_any(letters(&[depth_word])) || self.dialect.strict)
                && let Some(address) = [b'X', b'Z'].into_iter().find(|&address| words.peek(address).is_some())
            {
                let own = if address == b'X' { 'U' } else { 'W' };
                let word = words.quote(text, address);
                let fix = Fix::write(words.span(address), format!("{own}{}", words::after_letter(&word)));
                let message = said::CycleWord { code, word };
                self.report(Diagnostic::new(message, words.span(address)).with(fix));
                self.state.parameters.depth = Some(0.0);
                return None;
            }
            if !words.has_any(letters(b"UWR")) {
                self.report(Diagnostic::new(said::ContourNotNamed { code }, block.words_span()));
                return None;
            }
            if let Some(depth) = length(depth_word) {
                self.state.parameters.depth = Some(depth);
                if depth <= 0.0 {
                    let message = said::DepthNotPositive { code, depth };
                    let diagnostic = Diagnostic::new(message, words.span(depth_word));
                    let span = words.span(depth_word);
                    self.report(if depth < 0.0 {
                        offer_other_sign(diagnostic, text, span)
                    } else {
                        diagnostic
                    });
                    return None;
                }
            }
            let other_word = if turning { b'W' } else { b'U' };
            if words.get(depth_word).is_none() && words.peek(other_word).is_some() {
                // U and W are exchanged: the depth is U for G71, W for G72.
                let word = words.quote(text, other_word);
                let fix = Fix::write(
                    words.span(other_word),
                    format!("{}{}", depth_word as char, words::after_letter(&word)),
                );
                let message = said::DepthMissing { code };
                self.report(Diagnostic::new(message, words.span(other_word)).with(fix));
                self.state.parameters.depth = Some(0.0);
                return None;
            }
            if let Some(escape) = length(b'R') {
                self.state.parameters.escape = escape.abs();
                let depth = self.state.parameters.depth.unwrap_or(f64::INFINITY);
                if escape.abs() > depth {
                    let message = said::EscapeTooLarge { word: words.quote(text, b'R'), depth };
                    self.report(Diagnostic::new(message, words.span(b'R')));
                }
            }
            return Some(());
        }
        if let Some(word) = words.get(b'D') {
            self.state.parameters.depth = self.one_block_depth(word);
        }
        let shape = shape?;
        self.continue_after_contour(block, shape.begins, shape.ends);
        let Some(depth) = self.state.parameters.depth.filter(|&depth| depth > 0.0) else {
            let depth = self.state.parameters.depth;
            // A wrong depth in the first block was reported there.
            if let Some(word) = words.get(b'D').filter(|_| shape.is_valid()) {
                let depth = plain(word).map(|depth| depth * self.state.unit.millimetres());
                let message: Message = depth.map_or(said::DepthMissing { code }.into(), |depth| {
                    said::DepthNotPositive { code, depth }.into()
                });
                self.report(Diagnostic::new(message, word.span));
            } else if depth.is_none() && shape.is_valid() {
                self.report(Diagnostic::new(said::DepthMissing { code }, block.words_span()));
            }
            self.contour_alone(block, cycle.cycle(), &shape);
            return None;
        };
        let contour = shape.contour(self.state.position);
        let allowance = Point::new(radius(b'U').unwrap_or(0.0), length(b'W').unwrap_or(0.0));
        let how = Roughing {
            direction: if turning { Direction::Turning } else { Direction::Facing },
            shape: roughing::Shape::Monotone,
            depth,
            escape: self.state.parameters.escape,
            allowance,
            escape_kind: match self.dialect.g71_retract {
                G71Retract::Rapid => MotionKind::Rapid,
                G71Retract::Feed => MotionKind::Feed,
            },
            last_pass: roughing::LastPass::Contour,
            checks: roughing::Checks::All,
        };
        if !shape.is_valid() {
            let most = self.moves_left();
            self.state.doubts.add(Doubt::Contour);
            match self.rough_leniently(block, &contour, &shape, &how, most) {
                Some(moves) => self.run_cycle(block, cycle.cycle(), None, &moves),
                None => self.contour_alone(block, cycle.cycle(), &shape),
            }
            return None;
        }
        let (moves, used) = match self.rough(text, block, words, &shape, &contour, &how, code) {
            Ok(found) => found,
            Err(refused) => {
                if refused == Refused::Contour {
                    self.contour_alone(block, cycle.cycle(), &shape);
                }
                return None;
            }
        };
        let how = Roughing { shape: used, ..how };
        self.observe(text, Event::Roughing(shape.call(block, words, &contour, &how)));
        self.run_cycle(block, cycle.cycle(), None, &moves);
        Some(())
    }

    /// Roughs as type I or II (GSK980TDb pp. 99, 100; for G72 with X and Z exchanged), and returns the type.
    #[allow(clippy::too_many_arguments, reason = "one call, all of its words")]
    fn rough(
        &mut self,
        text: &[u8],
        block: &Block,
        words: &Words,
        shape: &Shape,
        contour: &Contour,
        how: &Roughing,
        code: &'static str,
    ) -> Result<(Vec<Move>, roughing::Shape), Refused> {
        let turning = how.direction == Direction::Turning;
        let (start, first) = (contour.start, contour.first);
        let (second_named, idiom, second_moves) = if turning {
            (shape.first.z, shape.first.w_zero, (first.z - start.z).abs() > crate::geometry::SAME)
        } else {
            (shape.first.x, shape.first.u_zero, (first.x - start.x).abs() > crate::geometry::SAME)
        };
        let pockets = second_named && (idiom || second_moves);
        self.observe(text, Event::RoughingCalled(shape.call(block, words, contour, how)));
        let most = self.moves_left();
        let mut how = *how;
        // GSK runs along the contour after its pockets only on request (GSK980TDb p. 100).
        if pockets && self.dialect.control == Control::Gsk && words.get(b'J').and_then(plain) != Some(1.0) {
            how.last_pass = roughing::LastPass::Nothing;
        }
        how.shape = if pockets { roughing::Shape::Pockets } else { roughing::Shape::Monotone };
        let mut moves = roughing::rough(contour, &how, most);
        if !self.dialect.strict
            && matches!(
                moves,
                Err(roughing::RoughingError::NotMonotoneAlong { .. }
                    | roughing::RoughingError::NotMonotoneAcross { .. })
            )
            && let Some(without) = shape.without_final_rapids(contour)
            && let Ok(found) = roughing::rough(&without, &how, most)
        {
            moves = Ok(found);
        }
        // On a control without type II the pocket is the error, even if the block asks for type II.
        let may_change = !pockets && second_named && self.dialect.type_ii;
        if may_change && matches!(moves, Err(roughing::RoughingError::NotMonotoneAcross { .. })) {
            how.shape = roughing::Shape::Pockets;
            moves = roughing::rough(contour, &how, most);
        }
        if how.shape == roughing::Shape::Pockets && !self.dialect.type_ii {
            self.report(Diagnostic::new(said::ContourTypeTwo { code }, block.words_span()));
            return Err(Refused::Contour);
        }
        let fault = match moves {
            Ok(moves) => return Ok((moves, how.shape)),
            Err(fault) => fault,
        };
        let type_two = Roughing { shape: roughing::Shape::Pockets, ..how };
        let can_be_pocket = how.shape == roughing::Shape::Monotone
            && self.dialect.type_ii
            && matches!(fault, roughing::RoughingError::NotMonotoneAcross { .. })
            && roughing::rough(contour, &type_two, most).is_ok();
        let remedy = if can_be_pocket { Remedy::Pockets } else { Remedy::AnotherCycle };
        let Some(message) = contour_message(fault, code, turning, shape, remedy) else {
            // This was only found after that many moves.
            self.refuse_long_cycle(block, code, most, most);
            return Err(Refused::Length);
        };
        // Reported at the block of the contour, where it can be fixed.
        let place = match fault {
            roughing::RoughingError::NotMonotoneAlong { piece }
            | roughing::RoughingError::NotMonotoneAcross { piece }
            | roughing::RoughingError::BeyondStart { piece: Some(piece), .. } => shape.span_of(piece),
            _ => None,
        };
        // If much of the contour is beyond the start point, the start point is wrong.
        let side =
            if turning { contour.first.x - contour.start.x } else { contour.first.z - contour.start.z };
        let beyond = |piece: &&crate::cycles::Piece| {
            let end = if turning { piece.to.x - contour.start.x } else { piece.to.z - contour.start.z };
            end.abs() > LENGTH_TOLERANCE && end.signum() != side.signum()
        };
        let start_is_wrong = matches!(fault, roughing::RoughingError::BeyondStart { .. })
            && contour.pieces.iter().filter(beyond).count() > 2;
        let place = place.filter(|_| !start_is_wrong);
        let mut message = Diagnostic::new(message, place.unwrap_or_else(|| block.words_span()));
        let (own, other) = if turning { (shape.first.x_word, " W0") } else { (shape.first.z_word, " U0") };
        if can_be_pocket && !second_named && !own.is_empty() {
            message = message.with(Fix::insert(own.end, other.to_owned()));
        }
        if self.dialect.strict {
            self.report(message);
            return Err(Refused::Contour);
        }
        // Many such programs run: some controls have no such check, others allow a tolerance.
        let found = self.rough_leniently(block, contour, shape, &how, most);
        self.report(if found.is_some() { message.with_severity(Severity::Warning) } else { message });
        found.map(|moves| (moves, how.shape)).ok_or(Refused::Contour)
    }

    /// G73.
    fn pattern(&mut self, text: &[u8], block: &Block, words: &Words, shape: Option<Shape>) -> Option<()> {
        let reading = self.reading();
        let length = |address: u8| words.get(address).and_then(|word| reading.length(word));
        let radius = |address: u8| words.get(address).and_then(|word| reading.radius(word));
        let parameters = &mut self.state.parameters;
        if !words.has_any(letters(b"PQ")) {
            if let Some(address) = [b'X', b'Z'].into_iter().find(|&address| words.peek(address).is_some()) {
                let own = if address == b'X' { 'U' } else { 'W' };
                let word = words.quote(text, address);
                let fix = Fix::write(words.span(address), format!("{own}{}", words::after_letter(&word)));
                let message = said::CycleWord { code: "G73", word };
                self.report(Diagnostic::new(message, words.span(address)).with(fix));
                return None;
            }
            let old = parameters.relief.unwrap_or_default();
            if words.has_any(letters(b"UW")) {
                parameters.relief =
                    Some(Point::new(length(b'U').unwrap_or(old.x), length(b'W').unwrap_or(old.z)));
            }
            let old = parameters.pattern_passes.filter(|&passes| passes >= 1.0);
            parameters.pattern_passes = words.get(b'R').and_then(plain).or(old);
            let passes = self.pattern_passes(words, b'R');
            // A missing value is reported here, and not again for the second block.
            self.state.parameters.pattern_passes.get_or_insert(0.0);
            return passes.map(|_| ());
        }
        if words.has_any(letters(b"D")) {
            parameters.pattern_passes = words.get(b'D').and_then(plain);
            parameters.relief = Some(Point::new(length(b'I').unwrap_or(0.0), length(b'K').unwrap_or(0.0)));
        }
        let shape = shape?;
        self.continue_after_contour(block, shape.begins, shape.ends);
        let passes = self.state.parameters.pattern_passes;
        let was_reported = passes.is_some_and(|passes| passes < 1.0) && words.get(b'D').is_none();
        let has_passes = passes.is_some_and(|passes| passes >= 1.0);
        let passes = match has_passes || shape.is_valid() && !was_reported {
            true => self.pattern_passes(words, b'D'),
            false => None,
        };
        let Some(passes) = passes else {
            self.contour_alone(block, Cycle::Pattern, &shape);
            return None;
        };
        let how = Pattern {
            relief: self.state.parameters.relief.unwrap_or_default(),
            passes,
            allowance: Point::new(radius(b'U').unwrap_or(0.0), length(b'W').unwrap_or(0.0)),
            intervals: match self.dialect.g73_intervals {
                G73Intervals::OneFewer => pattern::Intervals::OneFewer,
                G73Intervals::Same => pattern::Intervals::Same,
            },
        };
        let contour = shape.contour(self.state.position);
        if shape.is_valid() {
            self.observe(text, Event::Pattern(shape.call(block, words, &contour, &how)));
        }
        let most = self.moves_left();
        match pattern::pattern(&contour, &how, most) {
            Ok(moves) => self.run_cycle(block, Cycle::Pattern, None, &moves),
            Err(_) => {
                self.refuse_long_cycle(block, "G73", 0, most);
                return None;
            }
        }
        shape.is_valid().then_some(())
    }

    fn pattern_passes(&mut self, words: &Words, address: u8) -> Option<u32> {
        let passes = self.state.parameters.pattern_passes;
        match passes {
            Some(passes) if passes >= 1.0 => Some(passes as u32),
            _ => {
                let message: Message = passes
                    .map_or(said::PatternNoPasses.into(), |passes| said::PatternPasses { passes }.into());
                self.report(Diagnostic::new(message, words.span(address)));
                None
            }
        }
    }

    /// The contour of a roughing cycle whose passes are unknown, and the return move.
    #[cold]
    fn contour_alone(&mut self, block: &Block, cycle: Cycle, shape: &Shape) {
        let start = self.state.position;
        self.state.doubts.add(Doubt::Contour);
        let feed = self.state.process().feed;
        let mut moves = shape.moves.clone();
        // The F of the contour is ignored.
        moves.iter_mut().for_each(|path_move| path_move.motion.process.feed = feed);
        self.push_contour(block, cycle, &moves);
        self.return_to(block, cycle, start);
    }

    /// Makes the moves of a cycle along its contour.
    fn push_contour(&mut self, block: &Block, cycle: Cycle, moves: &[PathMove]) {
        for path_move in moves {
            let step = match path_move.motion.kind {
                MotionKind::Rapid => Step::Approach,
                _ => Step::Contour,
            };
            let tag = CycleStep { cycle, pass: 0, step };
            let mut motion = Motion { cycle: Some(tag), ..path_move.motion };
            motion.process.uncertain |= self.state.doubts.has(Doubt::Contour);
            self.push(block, motion);
        }
    }

    /// Moves from a cycle back to its start point.
    fn return_to(&mut self, block: &Block, cycle: Cycle, start: Point) {
        let tag = CycleStep { cycle, pass: 0, step: Step::Return };
        let mut home = Motion { cycle: Some(tag), ..self.motion(MotionKind::Rapid, start) };
        home.process.uncertain |= self.state.doubts.has(Doubt::Contour);
        self.push(block, home);
    }

    /// The passes of a contour with less strict checks: the contour as it is, or without its last blocks,
    /// which lead back.
    fn rough_leniently(
        &mut self,
        block: &Block,
        contour: &Contour,
        shape: &Shape,
        how: &Roughing,
        most: usize,
    ) -> Option<Vec<Move>> {
        let how = Roughing { checks: roughing::Checks::Forgiving, ..*how };
        let shorter = |dropped: usize| {
            let left = contour.pieces.len().checked_sub(dropped).filter(|&left| left > 0)?;
            Some(Contour { pieces: contour.pieces[..left].to_vec(), ..contour.clone() })
        };
        let candidates = [Some(contour.clone()), shape.without_final_rapids(contour), shorter(1), shorter(2)];
        for contour in candidates.into_iter().flatten() {
            match roughing::rough(&contour, &how, most) {
                Ok(moves) => return Some(moves),
                Err(roughing::RoughingError::TooManyMoves) if !self.spend(most, block) => return None,
                Err(_) => {}
            }
        }
        None
    }

    /// The contour of a cycle whose own block cannot be parsed. Errors in both were reported.
    #[cold]
    pub(super) fn contour_of_broken(
        &mut self,
        text: &[u8],
        block: &Block,
        words: &Words,
        cycle: Multiple,
        run: RunBlock,
    ) {
        let (reported, muted) = (self.state.reported, std::mem::replace(&mut self.sink.muted, true));
        let (observer, jump) = (self.observer.take(), self.program.jump);
        let shape = self.shape(text, block, words, cycle.cycle().code(), ContourUse::Roughing, run);
        (self.observer, self.program.jump) = (observer, jump);
        (self.state.reported, self.sink.muted) = (reported, muted);
        if let Some(shape) = shape {
            self.contour_alone(block, cycle.cycle(), &shape);
        }
        self.state.doubts.remove(Doubt::Contour);
    }
}

/// Why a contour is not roughed. The error was reported.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Refused {
    /// The contour cannot be roughed.
    Contour,
    /// It takes too many moves.
    Length,
}

/// How a contour that turns back can be cut.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Remedy {
    /// As type II: it is a pocket.
    Pockets,
    /// With another cycle: no type of this cycle can cut it on this control.
    AnotherCycle,
}

/// The message for a contour that cannot be roughed; `None` if it only needs too many moves.
fn contour_message(
    fault: roughing::RoughingError,
    code: &'static str,
    turning: bool,
    shape: &Shape,
    remedy: Remedy,
) -> Option<Message> {
    let (along, across) = if turning { ('Z', 'X') } else { ('X', 'Z') };
    let turns_back = |axis, piece| {
        let alarm = if axis == 'Z' { "PS0064" } else { "PS0329" };
        let line = shape.line_of(piece);
        match remedy {
            Remedy::Pockets => said::ContourTurnsBack { code, axis, line, alarm }.into(),
            Remedy::AnotherCycle => said::ContourNotOneWay { code, axis, line, alarm }.into(),
        }
    };
    Some(match fault {
        roughing::RoughingError::NotMonotoneAlong { piece } => turns_back(along, piece),
        roughing::RoughingError::NotMonotoneAcross { piece } => turns_back(across, piece),
        roughing::RoughingError::BeyondStart { along: is_along, .. } => {
            said::ContourBeyondStart { code, axis: if is_along { along } else { across } }.into()
        }
        roughing::RoughingError::NothingToCut => said::ContourNothingToCut { code }.into(),
        roughing::RoughingError::TooManyMoves => return None,
    })
}
