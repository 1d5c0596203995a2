//! G74 and G75 as blocks call them, and the unit of P and Q in G74 to G76.
//!
//! In: the words of a block. Out: the moves of the cycle, amounts as lengths. `cycles::grooving` has the
//! geometry, `cycles::units` guesses the unit.

use super::cycle_moves::LENGTH_TOLERANCE;
use super::request::Request;
use super::{AXES, Interpreter};
use crate::control::codes::Multiple;
use crate::control::doubt::Doubt;
use crate::control::words::{Words, letters, quote};
use crate::cycles::grooving::{self, Pecking};
use crate::cycles::units;
use crate::message::{Diagnostic, Message, Severity, said};
use crate::source::Span;
use crate::text::block::Block;

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
                    self.report(Diagnostic::new(message, words.span(b'R')).with_severity(Severity::Warning));
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
            self.report(Diagnostic::new(message, span).with_severity(severity));
            if self.dialect.strict {
                return None;
            }
        }
        let width = self.blade_width();
        if let (Some(width), Some(step)) = (width, stepover)
            && cycle == Multiple::Grooving
            && (end.z - start.z).abs() > LENGTH_TOLERANCE
            // With larger distances they are separate grooves.
            && (width - LENGTH_TOLERANCE..=1.5 * width).contains(&step)
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
}
