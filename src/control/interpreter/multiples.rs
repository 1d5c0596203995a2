//! G70 to G76 as blocks call them: first and second blocks, one-block forms, checks (semantics §7).
//!
//! In: the words of a block. Out: the moves of the cycle. The geometry is in `cycles`; here are the words,
//! their units and their alarms. A cycle that cannot run makes no motion at all.

use super::contours::{Purpose, Shape};
use super::singles;
use super::*;
use crate::cycles::grooving::{self, Pecking};
use crate::cycles::pattern::{self, Pattern};
use crate::cycles::roughing::{self, Direction, Roughing};
use crate::cycles::threading::{self, MultiThread};
use crate::cycles::units::{self, Amount, Written};
use crate::diagnostics::{Edit, Repair};
use crate::motion::Cycle;

/// The least input increment, mm: D of the one-block forms counts it when written without a point.
const INCREMENT: f64 = 0.001;

/// Tool angles that FANUC takes, degrees (PS0315).
const THREAD_ANGLES: [f64; 6] = [0.0, 29.0, 30.0, 55.0, 60.0, 80.0];

/// Lengths this near are the same, mm.
const NEAR: f64 = 0.001;

/// A least depth of G76 beyond this, mm, is no depth that somebody meant.
const LEAST_DEPTH: f64 = 1.0;

impl Interpreter {
    pub(super) fn multiple(
        &mut self,
        text: &[u8],
        block: &Block,
        request: &mut Request,
        words: &Words,
        cycle: Multiple,
    ) {
        if self.recorded.is_some() {
            // Told already: no cycle may stand in a contour.
            request.drop = true;
            return;
        }
        if cycle != Multiple::Finishing && self.state.compensation != Compensation::Off {
            // Roughing, pecking and threads run without compensation (semantics §4.4).
            if self.nose().radius == 0.0 || self.state.told.first(Once::CompensationIdle) {
                let code = cycle.cycle().code();
                self.tell(Diagnostic::new(Message::CompensationIdle { code }, block.words_span()));
            }
        }
        let done = match cycle {
            Multiple::Finishing => self.finishing(text, block, words),
            Multiple::RoughTurning | Multiple::RoughFacing => self.roughing(text, block, words, cycle),
            Multiple::Pattern => self.pattern(text, block, words),
            Multiple::FacePecking | Multiple::Grooving => self.pecking(text, block, words, cycle),
            Multiple::Threading => self.multi_threading(text, block, words),
        };
        request.drop |= done.is_none();
    }

    /// G70: the contour as it is written, then home.
    fn finishing(&mut self, text: &[u8], block: &Block, words: &Words) -> Option<()> {
        let shape = self.shape(text, block, words, "G70", Purpose::Finishing)?;
        self.watch_finish(block);
        let start = self.state.position;
        for routed in &shape.moves {
            let step = match routed.motion.kind {
                MotionKind::Rapid => Step::Approach,
                _ => Step::Contour,
            };
            let tag = CycleStep { cycle: Cycle::Finishing, pass: 0, step };
            self.push(block, Motion { cycle: Some(tag), ..routed.motion });
        }
        // The blocks change the modal state as they would on their own; the tool goes home.
        let (position, told) = (self.state.position, self.state.told);
        self.state = State { position, told, ..shape.state };
        let tag = CycleStep { cycle: Cycle::Finishing, pass: 0, step: Step::Return };
        let home = Motion { cycle: Some(tag), ..self.motion(MotionKind::Rapid, start) };
        self.push(block, home);
        Some(())
    }

    /// G70 begins and ends with rapids: it wants the start point of the roughing cycle (semantics §7.8).
    fn watch_finish(&mut self, block: &Block) {
        let Some(own) = self.landmarks.last().copied().filter(|own| own.span == block.span) else { return };
        let roughed = self.landmarks.iter().rev().find(|other| other.roughed && other.named == own.named);
        let message = match roughed {
            None => Message::FinishWithoutRoughing { first: own.named.0, last: own.named.1 },
            Some(other) if other.start.distance(own.start) > 0.001 => {
                Message::FinishStart { roughed_x: 2.0 * other.start.x, roughed_z: other.start.z }
            }
            Some(_) => return,
        };
        self.tell(Diagnostic::new(message, block.words_span()));
    }

    /// G71 and G72.
    fn roughing(&mut self, text: &[u8], block: &Block, words: &Words, cycle: Multiple) -> Option<()> {
        let code = cycle.cycle().code();
        let turning = cycle == Multiple::RoughTurning;
        let reading = self.reading();
        let length = |address: u8| words.get(address).and_then(|word| reading.length(word));
        let depth_word = if turning { b'U' } else { b'W' };
        if !words.has_any(letters(b"PQ")) {
            // X or Z in the first block: the depth lost its letter's place (PS0066).
            if let Some(address) = [b'X', b'Z'].into_iter().find(|&address| words.get(address).is_some())
                && (words.get(depth_word).is_none() || self.dialect.strict)
            {
                let own = if address == b'X' { 'U' } else { 'W' };
                let word = words.quote(text, address);
                let fix = Fix::write(words.span(address), format!("{own}{}", words::behind_letter(&word)));
                let message = Message::CycleWord { code, word };
                self.tell(Diagnostic::new(message, words.span(address)).with(fix));
                self.state.parameters.depth = Some(0.0);
                return None;
            }
            if !words.has_any(letters(b"UWR")) {
                self.tell(Diagnostic::new(Message::ContourNotNamed { code }, block.words_span()));
                return None;
            }
            if let Some(depth) = length(depth_word) {
                self.state.parameters.depth = Some(depth);
                if depth <= 0.0 {
                    let message = Message::DepthNotPositive { code, depth: Some(depth) };
                    let told = Diagnostic::new(message, words.span(depth_word));
                    let word = words.quote(text, depth_word);
                    let fix = (depth < 0.0)
                        .then(|| Fix::write(words.span(depth_word), singles::with_other_sign(&word)));
                    self.tell(Diagnostic { fixes: fix.into_iter().collect(), ..told });
                    return None;
                }
            }
            let other_word = if turning { b'W' } else { b'U' };
            if words.get(depth_word).is_none() && words.get(other_word).is_some() {
                // U and W have changed their roles: G71 takes U, G72 takes W.
                let word = words.quote(text, other_word);
                let fix = Fix::write(
                    words.span(other_word),
                    format!("{}{}", depth_word as char, words::behind_letter(&word)),
                );
                let message = Message::DepthNotPositive { code, depth: None };
                self.tell(Diagnostic::new(message, words.span(other_word)).with(fix));
                self.state.parameters.depth = Some(0.0);
                return None;
            }
            if let Some(escape) = length(b'R') {
                self.state.parameters.escape = escape.abs();
                let depth = self.state.parameters.depth.unwrap_or(f64::INFINITY);
                if escape.abs() > depth {
                    let message = Message::EscapeTooLarge { escape: escape.abs(), depth };
                    self.tell(Diagnostic::new(message, words.span(b'R')));
                }
            }
            return Some(());
        }
        if let Some(word) = words.get(b'D') {
            self.state.parameters.depth = self.one_block_depth(word);
        }
        let shape = self.shape(text, block, words, code, Purpose::Roughing)?;
        self.go_on_behind(block, shape.begins, shape.ends);
        let Some(depth) = self.state.parameters.depth.filter(|&depth| depth > 0.0) else {
            let depth = self.state.parameters.depth;
            // A depth that is wrong in the first block was told there.
            if let Some(word) = words.get(b'D') {
                let depth = plain(word);
                self.tell(Diagnostic::new(Message::DepthNotPositive { code, depth }, word.span));
            } else if depth.is_none() {
                self.tell(Diagnostic::new(Message::DepthNotPositive { code, depth }, block.words_span()));
            }
            return None;
        };
        let contour = shape.contour(self.state.position);
        let allowance = Point::new(length(b'U').unwrap_or(0.0) / 2.0, length(b'W').unwrap_or(0.0));
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
        let moves = self.rough(text, block, words, &shape, &contour, &how, code)?;
        let stock = self.setup.stock;
        for message in rules::contour::remarks(code, turning, &contour, shape.first.x && shape.first.z, stock)
        {
            let place = match message {
                Message::ContourNotClosed { .. } => shape.span_of(contour.pieces.len().saturating_sub(1)),
                _ => Some(shape.first_span),
            };
            self.tell(Diagnostic::new(message, place.unwrap_or_else(|| block.words_span())));
        }
        self.run_cycle(block, cycle.cycle(), None, &moves);
        Some(())
    }

    /// Roughs as type I or II (the table of semantics §7.2; for G72 with X and Z exchanged).
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
    ) -> Option<Vec<Move>> {
        let turning = how.direction == Direction::Turning;
        let (start, first) = (contour.start, contour.first);
        let (second_named, idiom, second_moves) = if turning {
            (shape.first.z, shape.first.w_zero, (first.z - start.z).abs() > crate::geometry::SAME)
        } else {
            (shape.first.x, shape.first.u_zero, (first.x - start.x).abs() > crate::geometry::SAME)
        };
        let pockets = second_named && (idiom || second_moves);
        if second_named && !idiom && !second_moves {
            let other = if turning { 'Z' } else { 'X' };
            let word = if turning { shape.first.z_word } else { shape.first.x_word };
            self.tell(Diagnostic::new(Message::ContourBothAxes { code, other }, word));
        }
        for axis in roughing::allowance_into_material(contour, how) {
            let (address, other) = match axis {
                roughing::Axis::X => (b'U', words.quote(text, b'U')),
                roughing::Axis::Z => (b'W', words.quote(text, b'W')),
            };
            self.tell_allowance(words, address, other);
        }
        let most = self.moves_left();
        let mut how = *how;
        // GSK runs along the contour behind its pockets only when asked to (TAC p. 100).
        if pockets && self.dialect.control == Control::Gsk && words.get(b'J').and_then(plain) != Some(1.0) {
            how.last_pass = roughing::LastPass::Nothing;
        }
        how.shape = if pockets { roughing::Shape::Pockets } else { roughing::Shape::Monotone };
        let mut moves = roughing::rough(contour, &how, most);
        if !self.dialect.strict
            && matches!(
                moves,
                Err(roughing::Fault::NotMonotoneAlong { .. } | roughing::Fault::NotMonotoneAcross { .. })
            )
            && let Some(without) = shape.without_retreat(contour)
            && let Ok(found) = roughing::rough(&without, &how, most)
        {
            moves = Ok(found);
        }
        if !pockets && second_named && matches!(moves, Err(roughing::Fault::NotMonotoneAcross { .. })) {
            how.shape = roughing::Shape::Pockets;
            moves = roughing::rough(contour, &how, most);
        }
        if how.shape == roughing::Shape::Pockets && !self.dialect.type_ii {
            self.tell(Diagnostic::new(Message::ContourTypeTwo { code }, block.words_span()));
            return None;
        }
        let fault = match moves {
            Ok(moves) => return Some(moves),
            Err(fault) => fault,
        };
        let Some(message) = contour_message(fault, code, turning, shape) else {
            // Found out only after that many moves.
            self.refuse_long_cycle(block, code, most, most);
            return None;
        };
        // At the block of the contour, which is where it can be mended.
        let place = match fault {
            roughing::Fault::NotMonotoneAlong { piece }
            | roughing::Fault::NotMonotoneAcross { piece }
            | roughing::Fault::BeyondStart { piece: Some(piece) } => shape.span_of(piece),
            _ => None,
        };
        // Where much of the contour lies beyond the start, it is the start that is wrong.
        let side =
            if turning { contour.first.x - contour.start.x } else { contour.first.z - contour.start.z };
        let beyond = |piece: &&crate::cycles::Piece| {
            let end = if turning { piece.to.x - contour.start.x } else { piece.to.z - contour.start.z };
            end.abs() > NEAR && end.signum() != side.signum()
        };
        let start_is_wrong = matches!(fault, roughing::Fault::BeyondStart { .. })
            && contour.pieces.iter().filter(beyond).count() > 2;
        let place = place.filter(|_| !start_is_wrong);
        let message = Diagnostic::new(message, place.unwrap_or_else(|| block.words_span()));
        if self.dialect.strict {
            self.tell(message);
            return None;
        }
        // Many such programs run: some controls leave the check out, others allow a tolerance.
        let found = self.forgiving(block, contour, shape, &how, most);
        self.tell(if found.is_some() { message.graded(Severity::Warning) } else { message });
        found
    }

    /// An allowance that points into the part.
    fn tell_allowance(&mut self, words: &Words, address: u8, word: String) {
        let fix = Fix::write(words.span(address), singles::with_other_sign(&word));
        self.tell(Diagnostic::new(Message::AllowanceSign { word }, words.span(address)).with(fix));
    }

    /// G73.
    fn pattern(&mut self, text: &[u8], block: &Block, words: &Words) -> Option<()> {
        let reading = self.reading();
        let length = |address: u8| words.get(address).and_then(|word| reading.length(word));
        let parameters = &mut self.state.parameters;
        if !words.has_any(letters(b"PQ")) {
            if let Some(address) = [b'X', b'Z'].into_iter().find(|&address| words.get(address).is_some()) {
                let own = if address == b'X' { 'U' } else { 'W' };
                let word = words.quote(text, address);
                let fix = Fix::write(words.span(address), format!("{own}{}", words::behind_letter(&word)));
                let message = Message::CycleWord { code: "G73", word };
                self.tell(Diagnostic::new(message, words.span(address)).with(fix));
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
            // What is missing is told here, and not again of the second block.
            self.state.parameters.pattern_passes.get_or_insert(0.0);
            return passes.map(|_| ());
        }
        if words.has_any(letters(b"D")) {
            parameters.pattern_passes = words.get(b'D').and_then(plain);
            parameters.relief = Some(Point::new(length(b'I').unwrap_or(0.0), length(b'K').unwrap_or(0.0)));
        }
        let shape = self.shape(text, block, words, "G73", Purpose::Roughing)?;
        self.go_on_behind(block, shape.begins, shape.ends);
        let told = self.state.parameters.pattern_passes.is_some_and(|passes| passes < 1.0);
        if told && words.get(b'D').is_none() {
            return None;
        }
        let passes = self.pattern_passes(words, b'D')?;
        let how = Pattern {
            relief: self.state.parameters.relief.unwrap_or_default(),
            passes,
            allowance: Point::new(length(b'U').unwrap_or(0.0) / 2.0, length(b'W').unwrap_or(0.0)),
            intervals: match self.dialect.g73_intervals {
                G73Intervals::OneFewer => pattern::Intervals::OneFewer,
                G73Intervals::Same => pattern::Intervals::Same,
            },
        };
        let contour = shape.contour(self.state.position);
        for (axis, address) in rules::contour::allowance_into_part(&contour, how.allowance) {
            debug_assert!(axis == address as char);
            self.tell_allowance(words, address, words.quote(text, address));
        }
        if let Some(message) = rules::contour::pattern_remarks(&contour, how.relief.x, self.setup.stock) {
            self.tell(Diagnostic::new(message, block.words_span()));
        }
        let most = self.moves_left();
        match pattern::pattern(&shape.contour(self.state.position), &how, most) {
            Ok(moves) => self.run_cycle(block, Cycle::Pattern, None, &moves),
            Err(_) => {
                self.refuse_long_cycle(block, "G73", 0, most);
                return None;
            }
        }
        Some(())
    }

    fn pattern_passes(&mut self, words: &Words, address: u8) -> Option<u32> {
        let passes = self.state.parameters.pattern_passes;
        match passes {
            Some(passes) if passes >= 1.0 => Some(passes as u32),
            _ => {
                self.tell(Diagnostic::new(Message::PatternPasses { passes }, words.span(address)));
                None
            }
        }
    }

    /// G74 and G75.
    fn pecking(&mut self, text: &[u8], block: &Block, words: &Words, cycle: Multiple) -> Option<()> {
        let reading = self.reading();
        let length = |address: u8| words.get(address).and_then(|word| reading.length(word));
        if !words.has_any(AXES) {
            if let Some(retract) = length(b'R') {
                if retract < 0.0 {
                    let message = Message::ReliefNegative { word: words.quote(text, b'R') };
                    self.tell(Diagnostic::new(message, words.span(b'R')).graded(Severity::Warning));
                }
                self.state.parameters.retract = retract.abs();
            }
            return Some(());
        }
        let code = cycle.cycle().code();
        let direction = match cycle {
            Multiple::FacePecking => grooving::Direction::Face,
            _ => grooving::Direction::Radial,
        };
        let start = self.state.position;
        let end = self.target(text, words);
        if !self.may_cut(block, words, &mut Request::default()) {
            return None;
        }
        // The older one-block form spells P, Q and R as I, K and D, in millimetres.
        let (x_amount, z_amount, relief) = if words.has_any(letters(b"IK")) {
            (length(b'I'), length(b'K'), words.get(b'D').and_then(|word| self.one_block_depth(word)))
        } else {
            let (_, p, q) = self.amounts(text, words, |p, q| units::pecking(start, end, p, q))?;
            (p, q, length(b'R'))
        };
        let (peck, stepover) = match direction {
            grooving::Direction::Face => (z_amount, x_amount),
            grooving::Direction::Radial => (x_amount, z_amount),
        };
        let (address, other) = if cycle == Multiple::FacePecking { (b'Q', b'P') } else { (b'P', b'Q') };
        if peck.unwrap_or(0.0) == 0.0 {
            let message = Message::PeckMissing { code, address: address as char };
            let severity = if self.dialect.strict { Severity::Error } else { Severity::Warning };
            self.tell(Diagnostic::new(message, block.words_span()).graded(severity));
            if self.dialect.strict {
                return None;
            }
        }
        let width = self.blade_width();
        if let (Some(width), Some(step)) = (width, stepover)
            && cycle == Multiple::Grooving
            && (end.z - start.z).abs() > NEAR
            // Far apart they are grooves of their own.
            && (width - NEAR..=1.5 * width).contains(&step)
        {
            let message = Message::GrooveStep { word: words.quote(text, other), step, width };
            self.tell(Diagnostic::new(message, words.span(other)));
        }
        let how = Pecking {
            end,
            peck,
            stepover,
            retract: self.state.parameters.retract,
            relief: relief.unwrap_or(0.0),
            first_column: match self.dialect.relief_first {
                true => grooving::FirstColumn::WithRelief,
                false => grooving::FirstColumn::WithoutRelief,
            },
        };
        let most = self.moves_left();
        let (message, span) = match grooving::peck(start, direction, &how, most) {
            Ok(moves) => {
                self.run_cycle(block, cycle.cycle(), None, &moves);
                return Some(());
            }
            Err(grooving::Fault::NegativeRelief) => {
                (Message::ReliefNegative { word: words.quote(text, b'R') }, words.span(b'R'))
            }
            Err(grooving::Fault::NoStepover) => {
                (Message::PeckMissing { code, address: other as char }, block.words_span())
            }
            Err(grooving::Fault::NegativePeck) => {
                (Message::PeckNegative { word: words.quote(text, address) }, words.span(address))
            }
            Err(grooving::Fault::NegativeStepover) => {
                (Message::PeckNegative { word: words.quote(text, other) }, words.span(other))
            }
            Err(grooving::Fault::TooManyMoves) => {
                self.refuse_long_cycle(block, code, 0, most);
                return None;
            }
        };
        self.tell(Diagnostic::new(message, span));
        None
    }

    /// Width of the blade of the tool in force, mm, if the setup names one.
    fn blade_width(&self) -> Option<f64> {
        let (station, offset) = self.state.tool;
        self.setup.tools.get(&format!("T{station:02}{offset:02}")).and_then(|tool| tool.width)
    }

    /// What P and Q count (semantics §7.6), and both as lengths, mm.
    pub(super) fn amounts(
        &mut self,
        text: &[u8],
        words: &Words,
        by_size: impl FnOnce(Option<Amount>, Option<Amount>) -> units::Reading,
    ) -> Option<(units::Reading, Option<f64>, Option<f64>)> {
        let (p, q) = (self.amount(words, b'P'), self.amount(words, b'Q'));
        let reading = match self.dialect.pq_unit {
            PqUnit::Auto => by_size(p, q),
            PqUnit::Mm => units::Reading::Millimetres(units::Because::Point),
            PqUnit::Um => units::Reading::Micrometres,
        };
        if !self.tell_amounts(text, words, reading) {
            return None;
        }
        Some((
            reading,
            p.map(|amount| self.amount_in(amount, reading)),
            q.map(|amount| self.amount_in(amount, reading)),
        ))
    }

    /// A P or Q word as it would count least increments.
    fn amount(&self, words: &Words, address: u8) -> Option<Amount> {
        let word = words.get(address)?;
        let Value::Number { number, .. } = word.value else { return None };
        let increment = match self.state.unit {
            words::Unit::Millimetre => INCREMENT,
            words::Unit::Inch => INCREMENT / 10.0 * self.state.unit.millimetres(),
        };
        let written = if number.has_point() { Written::WithPoint } else { Written::WithoutPoint };
        Some(Amount { in_increments: plain(word)? * increment, written })
    }

    fn amount_in(&self, amount: Amount, reading: units::Reading) -> f64 {
        match (reading, self.state.unit) {
            (units::Reading::Micrometres, _) => amount.in_increments,
            (units::Reading::Millimetres(_), words::Unit::Millimetre) => amount.in_increments / INCREMENT,
            (units::Reading::Millimetres(_), words::Unit::Inch) => amount.in_increments / INCREMENT * 10.0,
        }
    }

    /// Says that P and Q were read as millimetres, or that a control takes no point there. False: it does not.
    fn tell_amounts(&mut self, text: &[u8], words: &Words, reading: units::Reading) -> bool {
        let pointed = [b'P', b'Q'].into_iter().find(|&address| {
            self.amount(words, address).is_some_and(|amount| amount.written == Written::WithPoint)
        });
        let forbidden = match self.dialect.pq_unit {
            PqUnit::Um => true,
            PqUnit::Auto => self.dialect.strict,
            PqUnit::Mm => false,
        };
        if let Some(address) = pointed.filter(|_| forbidden) {
            let word = words.quote(text, address);
            let fixes = self.in_micrometres(text, words);
            let told = Diagnostic::new(Message::PointNotAllowed { word }, words.span(address));
            self.tell(Diagnostic { fixes, ..told });
            return false;
        }
        if let (PqUnit::Auto, units::Reading::Millimetres(_)) = (self.dialect.pq_unit, reading) {
            let address = pointed.unwrap_or(if words.get(b'Q').is_some() { b'Q' } else { b'P' });
            let word = words.quote(text, address);
            let fixes = self.in_micrometres(text, words);
            let told = Diagnostic::new(Message::AmountInMillimetres { word }, words.span(address));
            self.tell(Diagnostic { fixes, ..told });
        }
        true
    }

    /// P and Q as a control counts them, thousandths of a millimetre without a point.
    fn in_micrometres(&self, text: &[u8], words: &Words) -> Vec<Fix> {
        if self.state.unit != words::Unit::Millimetre {
            return Vec::new();
        }
        let found = [b'P', b'Q'].into_iter().filter_map(|address| words.get(address));
        let mut edits: Vec<Edit> = found
            .filter_map(|word| {
                let (Value::Number { .. }, written) = (word.value, quote(text, word.span)) else {
                    return None;
                };
                let letter = written.chars().next()?;
                let thousandths = (1000.0 * plain(word)?).round();
                Some(Edit { span: word.span, text: format!("{letter}{thousandths}") })
            })
            .collect();
        edits.sort_by_key(|edit| edit.span.start);
        let title: Vec<&str> = edits.iter().map(|edit| edit.text.as_str()).collect();
        let title = Repair::Write { text: title.join(" ") };
        if edits.is_empty() { Vec::new() } else { vec![Fix { title, safe: false, edits }] }
    }

    /// G76.
    fn multi_threading(&mut self, text: &[u8], block: &Block, words: &Words) -> Option<()> {
        let reading = self.reading();
        let length = |address: u8| words.get(address).and_then(|word| reading.length(word));
        if !words.has_any(AXES) {
            return self.threading_parameters(text, words);
        }
        let one_block = words.get(b'K').is_some();
        let start = self.state.position;
        let end = self.target(text, words);
        let lead = self.lead(block, words, "G76")?;
        self.watch_thread_spindle(block, "G76");
        let taper_word = if one_block { b'I' } else { b'R' };
        self.watch_thread_pass(block, words, Point::new(end.x, start.z), end, lead);
        let (height, first_depth, least_depth, method) = if one_block {
            let depth = words.get(b'D').and_then(|word| self.one_block_depth(word));
            (length(b'K'), depth, 0.0, words.get(b'P').and_then(plain).unwrap_or(1.0) as u32)
        } else {
            // Q of the first block is read in the unit of this pair.
            let least = self.state.parameters.least_amount;
            let (unit, p, q) = self.amounts(text, words, |p, q| units::threading(least, p, q))?;
            (p, q, least.map_or(0.0, |least| self.amount_in(least, unit)), 1)
        };
        let angle = if one_block {
            words.get(b'A').and_then(plain).unwrap_or(0.0)
        } else {
            self.state.parameters.angle
        };
        let gsk = self.dialect.control == Control::Gsk;
        if !gsk && !one_block && !THREAD_ANGLES.contains(&angle) {
            // Told at the first block.
            return None;
        }
        let taper = if one_block { length(b'I') } else { length(b'R') }.unwrap_or(0.0);
        let pull_out = 0.1 * f64::from(self.state.thread_chamfer) * lead;
        let parameters = self.state.parameters;
        let how = MultiThread {
            end,
            taper,
            height: height.unwrap_or(0.0),
            first_depth: first_depth.unwrap_or(0.0),
            least_depth,
            allowance: if one_block { 0.0 } else { parameters.thread_allowance },
            finishing: parameters.finishing,
            pull_out: (self.state.thread_chamfer_on && pull_out > 0.0)
                .then_some(PullOut { along: pull_out, out: pull_out }),
            angle: angle.to_radians(),
            clamp: match self.dialect.g76_clamp {
                G76Clamp::Prev => threading::Clamp::Previous,
                G76Clamp::Sqrt => threading::Clamp::Root,
            },
            edge: if matches!(method, 2 | 4) { threading::Edge::InTurn } else { threading::Edge::Leading },
            load: if matches!(method, 3 | 4) {
                threading::Load::EvenDepth
            } else {
                threading::Load::EvenArea
            },
        };
        let most = self.moves_left();
        let message = match threading::thread(start, &how, most) {
            Ok(moves) => {
                self.check_thread_start(block, start, &how);
                let measured = if one_block { 60.0 } else { angle };
                if let Some(message) = rules::thread::amounts(how.height, how.first_depth, lead, measured) {
                    let address =
                        if matches!(message, Message::ThreadFirstDepth { .. }) { b'Q' } else { b'P' };
                    let span = if one_block { block.words_span() } else { words.span(address) };
                    let fixes = self.swapped_amounts(text, words, &message);
                    self.tell(Diagnostic { fixes, ..Diagnostic::new(message, span) });
                }
                let way = (start.x - end.x).abs();
                if let Some(out) = how.pull_out.filter(|pull_out| pull_out.out >= way - NEAR) {
                    let message = Message::ThreadPullOut { pull_out: out.out, way };
                    self.tell(Diagnostic::new(message, block.words_span()));
                }
                if words.get(taper_word).is_some() {
                    let word = words.quote(text, taper_word);
                    let stock = self.setup.stock;
                    if let Some(message) =
                        rules::taper_shape(Single::Threading, start, end, taper, &word, stock)
                    {
                        let fix = matches!(message, Message::TaperNarrows { .. })
                            .then(|| Fix::write(words.span(taper_word), singles::with_other_sign(&word)));
                        let told = Diagnostic::new(message, words.span(taper_word));
                        self.tell(Diagnostic { fixes: fix.into_iter().collect(), ..told });
                    }
                }
                self.run_cycle(block, Cycle::MultiThreading, Some(lead), &moves);
                return Some(());
            }
            Err(threading::Fault::Angle) => Message::ThreadAngle { angle },
            Err(threading::Fault::LeastDepthTooLarge) => {
                Message::ThreadLeastDepth { least: how.least_depth, height: how.height }
            }
            Err(threading::Fault::NoHeight) => Message::ThreadNoDepth { word: 'P' },
            Err(threading::Fault::NoFirstDepth) => Message::ThreadNoDepth { word: 'Q' },
            Err(threading::Fault::TooManyMoves) => {
                self.refuse_long_cycle(block, "G76", 0, most);
                return None;
            }
        };
        self.tell(Diagnostic::new(message, block.words_span()));
        None
    }

    /// P and Q of G76 with their letters exchanged, where that is what the message is about.
    fn swapped_amounts(&self, text: &[u8], words: &Words, message: &Message) -> Vec<Fix> {
        let (Some(p), Some(q), Message::ThreadFirstDepth { .. }) =
            (words.get(b'P'), words.get(b'Q'), message)
        else {
            return Vec::new();
        };
        let (p_text, q_text) = (quote(text, p.span), quote(text, q.span));
        let mut edits = [
            (p.span, format!("Q{}", words::behind_letter(&p_text))),
            (q.span, format!("P{}", words::behind_letter(&q_text))),
        ];
        edits.sort_by_key(|edit| edit.0.start);
        let title =
            Repair::Write { text: edits.iter().map(|edit| edit.1.as_str()).collect::<Vec<_>>().join(" ") };
        let edits = edits.map(|(span, text)| Edit { span, text });
        vec![Fix { title, safe: false, edits: edits.into() }]
    }

    /// The first block of G76: `P(m)(r)(a) Q R`.
    fn threading_parameters(&mut self, text: &[u8], words: &Words) -> Option<()> {
        let reading = self.reading();
        if let Some(word) = words.get(b'P') {
            let Value::Number { number, .. } = word.value else { return None };
            if !self.is_whole(text, word) {
                return None;
            }
            let packed = number.mantissa;
            self.state.parameters.finishing = (packed / 10_000 % 100).max(1) as u32;
            self.state.thread_chamfer = (packed / 100 % 100) as u8;
            let angle = (packed % 100) as f64;
            self.state.parameters.angle = angle;
            if self.dialect.control != Control::Gsk && !THREAD_ANGLES.contains(&angle) {
                let written = quote(text, word.span);
                let head = written.len().saturating_sub(2);
                let told = Diagnostic::new(Message::ThreadAngle { angle }, word.span);
                // The nearest angle there is.
                let apart = |other: &f64| (other - angle).abs();
                let near = THREAD_ANGLES.into_iter().min_by(|a, b| apart(a).total_cmp(&apart(b)));
                let fix = near
                    .filter(|_| written.is_char_boundary(head) && number.digits >= 3)
                    .map(|near| Fix::write(word.span, format!("{}{near:02}", &written[..head])));
                self.tell(Diagnostic { fixes: fix.into_iter().collect(), ..told });
            }
        }
        if words.get(b'Q').is_some() {
            self.state.parameters.least_amount = self.amount(words, b'Q');
            let least = self.state.parameters.least_amount.map_or(0.0, |least| least.in_increments);
            if self.dialect.pq_unit != PqUnit::Mm && least > LEAST_DEPTH {
                let message = Message::ThreadLeastLarge { word: words.quote(text, b'Q'), least };
                self.tell(Diagnostic::new(message, words.span(b'Q')));
            }
        }
        if let Some(allowance) = words.get(b'R').and_then(|word| reading.length(word)) {
            self.state.parameters.thread_allowance = allowance.abs();
        }
        Some(())
    }

    /// The tool returns to the start X after each pass: it must clear the crest.
    fn check_thread_start(&mut self, block: &Block, start: Point, how: &MultiThread) {
        let external = how.end.x < start.x;
        let crest = if external { how.end.x + how.height } else { how.end.x - how.height };
        let inside = if external { start.x <= crest + 0.001 } else { start.x >= crest - 0.001 };
        if inside {
            let message = Message::ThreadStartInside { start: 2.0 * start.x, crest: 2.0 * crest };
            self.tell(Diagnostic::new(message, block.words_span()));
        }
    }

    /// The D of a one-block form: a depth; without a point in least increments.
    fn one_block_depth(&self, word: &Word) -> Option<f64> {
        if self.dialect.control == Control::Gsk {
            return self.reading().length(word);
        }
        let Value::Number { number, .. } = word.value else { return None };
        let unit = self.state.unit.millimetres();
        let scale = match (number.has_point(), self.state.unit) {
            (true, _) => unit,
            (false, words::Unit::Millimetre) => INCREMENT,
            (false, words::Unit::Inch) => INCREMENT / 10.0 * unit,
        };
        Some(plain(word)? * scale)
    }

    /// Moves that a cycle may make.
    pub(super) fn moves_left(&self) -> usize {
        self.setup.limits.moves_per_cycle.min(self.setup.limits.motions.saturating_sub(self.kept()))
    }

    /// Refuses a cycle of more than `most` moves, found out after so many steps: it has too many by itself, or too few
    /// are left for it and the run ends.
    pub(super) fn refuse_long_cycle(&mut self, block: &Block, code: &'static str, steps: usize, most: usize) {
        let span = block.words_span();
        if !self.spend(steps, block) {
            return;
        }
        if most < self.setup.limits.moves_per_cycle {
            self.end_run(Message::TooManyMotions { most: self.setup.limits.motions }, span);
        } else {
            self.tell(Diagnostic::new(Message::TooManyPasses { code, most }, span));
        }
    }

    /// Makes the moves of a cycle.
    fn run_cycle(&mut self, block: &Block, cycle: Cycle, lead: Option<f64>, moves: &[Move]) {
        let kept = self.kept();
        for step in moves {
            let tag = CycleStep { cycle, pass: step.pass, step: step.step };
            let motion = self.motion(step.kind, step.to);
            self.push(block, Motion { cycle: Some(tag), center: step.center, lead, ..motion });
        }
        self.spend(moves.len() - (self.kept() - kept), block);
    }

    /// The moves of a contour that is held to less: as it is, or without the last blocks, which lead back.
    fn forgiving(
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
        let candidates = [Some(contour.clone()), shape.without_retreat(contour), shorter(1), shorter(2)];
        for contour in candidates.into_iter().flatten() {
            match roughing::rough(&contour, &how, most) {
                Ok(moves) => return Some(moves),
                Err(roughing::Fault::TooManyMoves) if !self.spend(most, block) => return None,
                Err(_) => {}
            }
        }
        None
    }
}

/// What to say of a contour that cannot be roughed; `None` where it only takes too many moves.
fn contour_message(
    fault: roughing::Fault,
    code: &'static str,
    turning: bool,
    shape: &Shape,
) -> Option<Message> {
    let (along, across) = if turning { ('Z', 'X') } else { ('X', 'Z') };
    Some(match fault {
        roughing::Fault::NotMonotoneAlong { piece } => {
            Message::ContourTurnsBack { code, axis: along, line: shape.line_of(piece) }
        }
        roughing::Fault::NotMonotoneAcross { piece } => {
            Message::ContourTurnsBack { code, axis: across, line: shape.line_of(piece) }
        }
        roughing::Fault::BeyondStart { .. } => Message::ContourBeyondStart { code, axis: across },
        roughing::Fault::NothingToCut => Message::ContourNothingToCut { code },
        roughing::Fault::TooManyMoves => return None,
    })
}
