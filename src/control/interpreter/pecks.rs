//! G74 and G75 as blocks call them, and the unit of P and Q in G74 to G76.
//!
//! In: the words of a block. Out: the moves of the cycle, amounts as lengths. `cycles::grooving` has the
//! geometry, `cycles::units` guesses the unit.

use super::multiples::{INCREMENT, NEAR};
use super::request::Request;
use super::{AXES, Interpreter};
use crate::control::codes::Multiple;
use crate::control::doubt::Doubt;
use crate::control::words::{Words, letters, plain, quote};
use crate::cycles::grooving::{self, Pecking};
use crate::cycles::units::{self, Amount, Written};
use crate::message::{Diagnostic, Edit, Fix, Message, Repair, Severity, said};
use crate::order;
use crate::parts::{Part, late};
use crate::setup::dialect::PqUnit;
use crate::source::Span;
use crate::text::block::{Block, Value};
use crate::units::Unit;

impl Interpreter {
    /// G74 and G75.
    pub(super) fn pecking(
        &mut self,
        text: &[u8],
        block: &Block,
        words: &Words,
        cycle: Multiple,
    ) -> Option<()> {
        let reading = self.reading();
        let length = |address: u8| words.get(address).and_then(|word| reading.length(word));
        if !words.has_any(AXES) {
            if let Some(retract) = length(b'R') {
                if retract < 0.0 {
                    let message = said::ReliefNegative { word: words.quote(text, b'R') };
                    self.report(Diagnostic::new(message, words.span(b'R')).graded(Severity::Warning));
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
        let may_cut = self.may_cut(text, block, words, &mut Request::default());
        if !may_cut {
            self.state.doubts.add(Doubt::Contour);
        }
        // The older one-block form uses I, K and D instead of P, Q and R, in millimetres.
        let in_one_block = words.has_any(letters(b"IK"));
        let (x_amount, z_amount, relief) = if in_one_block {
            (length(b'I'), length(b'K'), words.get(b'D').and_then(|word| self.one_block_depth(word)))
        } else {
            let (_, p, q) = self.amounts(text, words, |p, q| units::pecking(start, end, p, q))?;
            (p, q, length(b'R'))
        };
        let (x_word, z_word) = if in_one_block { (b'I', b'K') } else { (b'P', b'Q') };
        let (peck, stepover, address, other) = match direction {
            grooving::Direction::Face => (z_amount, x_amount, z_word, x_word),
            grooving::Direction::Radial => (x_amount, z_amount, x_word, z_word),
        };
        let missing = |address: u8| -> (Message, Span) {
            match words.get(address) {
                Some(word) => (said::PeckWordZero { code, word: quote(text, word.span) }.into(), word.span),
                None => (said::PeckMissing { code, address: address as char }.into(), block.words_span()),
            }
        };
        if peck.unwrap_or(0.0) == 0.0 {
            let (message, span) = missing(address);
            let severity = if self.dialect.strict { Severity::Error } else { Severity::Warning };
            self.report(Diagnostic::new(message, span).graded(severity));
            if self.dialect.strict {
                return None;
            }
        }
        let width = self.blade_width();
        if let (Some(width), Some(step)) = (width, stepover)
            && cycle == Multiple::Grooving
            && (end.z - start.z).abs() > NEAR
            // With larger distances they are separate grooves.
            && (width - NEAR..=1.5 * width).contains(&step)
        {
            let message = said::GrooveStep { word: words.quote(text, other), step, width };
            self.report(Diagnostic::new(message, words.span(other)));
        }
        let mut how = Pecking {
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
        let (message, span): (Message, Span) = match grooving::peck(start, direction, &how, most) {
            Ok(moves) => {
                self.run_cycle(block, cycle.cycle(), None, &moves);
                return may_cut.then_some(());
            }
            Err(grooving::PeckingError::NegativeRelief) => {
                (said::ReliefNegative { word: words.quote(text, b'R') }.into(), words.span(b'R'))
            }
            Err(grooving::PeckingError::NoStepover) => missing(other),
            Err(grooving::PeckingError::NegativePeck) => {
                (said::PeckNegative { word: words.quote(text, address) }.into(), words.span(address))
            }
            Err(grooving::PeckingError::NegativeStepover) => {
                (said::PeckNegative { word: words.quote(text, other) }.into(), words.span(other))
            }
            Err(grooving::PeckingError::TooManyMoves) => {
                self.refuse_long_cycle(block, code, 0, most);
                return None;
            }
        };
        self.report(Diagnostic::new(message, span));
        // Without the wrong words: if their distance is missing, one column at each end.
        how.relief = how.relief.abs();
        how.peck = how.peck.map(f64::abs);
        how.stepover = how.stepover.map(f64::abs);
        if how.stepover.is_none_or(|step| step == 0.0) {
            how.stepover = Some(match direction {
                grooving::Direction::Face => (end.x - start.x).abs(),
                grooving::Direction::Radial => (end.z - start.z).abs(),
            });
        }
        self.state.doubts.add(Doubt::Contour);
        if let Ok(moves) = grooving::peck(start, direction, &how, most) {
            self.run_cycle(block, cycle.cycle(), None, &moves);
        }
        None
    }

    /// Width of the grooving insert of the tool in force, mm, if the setup names one.
    pub(super) fn blade_width(&self) -> Option<f64> {
        let (station, offset) = self.state.tool;
        self.setup.tools.get(&format!("T{station:02}{offset:02}")).and_then(|tool| tool.width)
    }

    /// The unit of P and Q (GSK980TDb pp. 119, 135), and both as lengths, mm.
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
        if !self.report_amounts(text, words, reading) {
            return None;
        }
        Some((
            reading,
            p.map(|amount| self.amount_in(amount, reading)),
            q.map(|amount| self.amount_in(amount, reading)),
        ))
    }

    /// A P or Q word as an amount in least increments.
    pub(super) fn amount(&self, words: &Words, address: u8) -> Option<Amount> {
        let word = words.get(address)?;
        let Value::Number { number, .. } = word.value else { return None };
        let increment = match self.state.unit {
            Unit::Millimetre => INCREMENT,
            Unit::Inch => INCREMENT / 10.0 * self.state.unit.millimetres(),
        };
        let written = if number.has_point() { Written::WithPoint } else { Written::WithoutPoint };
        Some(Amount { in_increments: plain(word)? * increment, written })
    }

    pub(super) fn amount_in(&self, amount: Amount, reading: units::Reading) -> f64 {
        amount.mm(reading, self.state.unit)
    }

    /// Reports that P and Q were read as millimetres, or that the control does not accept a point there.
    /// False: it does not.
    pub(super) fn report_amounts(&mut self, text: &[u8], words: &Words, reading: units::Reading) -> bool {
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
            let diagnostic = Diagnostic::new(said::PointNotAllowed { word }, words.span(address));
            self.report(Diagnostic { fixes, ..diagnostic });
            return false;
        }
        if let (PqUnit::Auto, units::Reading::Millimetres(_)) = (self.dialect.pq_unit, reading) {
            let address = pointed.unwrap_or(if words.peek(b'Q').is_some() { b'Q' } else { b'P' });
            let word = words.quote(text, address);
            let fixes = self.in_micrometres(text, words);
            let diagnostic = Diagnostic::new(said::AmountInMillimetres { word }, words.span(address));
            self.report(Diagnostic { fixes, ..diagnostic });
        }
        true
    }

    /// A fix that writes P and Q as a control reads them: thousandths of a millimetre without a point.
    pub(super) fn in_micrometres(&self, text: &[u8], words: &Words) -> Vec<Fix> {
        // Without the part no messages are shown.
        match FIXING.is_loaded() && self.state.unit == Unit::Millimetre {
            true => in_micrometres(text, words),
            false => Vec::new(),
        }
    }
}

/// The part of the module that contains fixes of words.
const FIXING: Part = Part::Late;

late! {
    fn in_micrometres(text: &[u8], words: &Words) -> Vec<Fix> {
        let found = [b'P', b'Q'].into_iter().filter_map(|address| words.get(address));
        let mut edits: Vec<Edit> = found
            .filter_map(|word| {
                let (Value::Number { .. }, written) = (word.value, quote(text, word.span)) else {
                    return None;
                };
                let letter = written.chars().next()?;
                let thousandths = crate::units::number((1000.0 * plain(word)?).round());
                Some(Edit { span: word.span, text: format!("{letter}{thousandths}") })
            })
            .collect();
        order::by_key(&mut edits, |edit| edit.span.start);
        let title: Vec<&str> = edits.iter().map(|edit| edit.text.as_str()).collect();
        let title = Repair::Write { text: title.join(" ") };
        if edits.is_empty() { Vec::new() } else { vec![Fix { title, safe: false, edits }] }
    }
}
