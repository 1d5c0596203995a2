//! Common code of the cycles: their words, the limit of their moves, and the output of the moves.

use super::Interpreter;
use crate::control::doubt::{Doubt, Doubts};
use crate::control::words::{Words, plain, quote};
use crate::cycles::Move;
use crate::cycles::single::{PullOut, Single};
use crate::cycles::units::{self, Amount, Written};
use crate::message::{Diagnostic, Edit, Fix, Repair, said};
use crate::motion::{Cycle, CycleStep, Motion, Step};
use crate::order;
use crate::parts::{Part, late};
use crate::setup::dialect::{Control, PqUnit};
use crate::text::block::{Block, Value, Word};
use crate::units::Unit;

/// The least input increment, mm: unit of D in the one-block forms if it is written without a point.
pub(super) const INCREMENT: f64 = 0.001;

/// Lengths that differ by no more than this, mm, are equal.
pub(super) const LENGTH_TOLERANCE: f64 = 0.001;

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

/// Data shared by the moves of a thread cycle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Thread {
    /// Lead, mm.
    pub lead: f64,
    /// Start angle, degrees.
    pub start_angle: f64,
}

impl Thread {
    /// A motion of the cycle; the cut begins at the start angle.
    pub(super) fn of(self, motion: Motion) -> Motion {
        let begins = motion.cycle.is_some_and(|tag| tag.step == Step::Cut);
        let start_angle = if begins { self.start_angle } else { 0.0 };
        Motion { lead: Some(self.lead), start_angle, ..motion }
    }
}

/// Start angle, degrees, of start number `number` (from 0) of `starts` (GSK980TDb, L of G92).
pub(super) fn angle_of_start(number: u64, starts: u64) -> f64 {
    360.0 * number as f64 / starts as f64
}

impl Interpreter {
    /// The D of a one-block form: a depth; without a point in least increments.
    pub(super) fn one_block_depth(&self, word: &Word) -> Option<f64> {
        if self.dialect.control == Control::Gsk {
            return self.reading().length(word);
        }
        let Value::Number { number, .. } = word.value else { return None };
        let unit = self.state.unit.millimetres();
        let scale = match (number.has_point(), self.state.unit) {
            (true, _) => unit,
            (false, Unit::Millimetre) => INCREMENT,
            (false, Unit::Inch) => INCREMENT / 10.0 * unit,
        };
        Some(plain(word)? * scale)
    }

    /// Number of moves that a cycle may still make.
    pub(super) fn moves_left(&self) -> usize {
        self.setup.limits.moves_per_cycle.min(self.setup.limits.motions.saturating_sub(self.sink.kept()))
    }

    /// Refuses a cycle of more than `most` moves, after `steps` steps: either it is too long, or the run has
    /// too few moves left and ends.
    pub(super) fn refuse_long_cycle(&mut self, block: &Block, code: &'static str, steps: usize, most: usize) {
        let span = block.words_span();
        if !self.spend(steps, block) {
            return;
        }
        if most < self.setup.limits.moves_per_cycle {
            self.sink.end(said::TooManyMotions { most: self.setup.limits.motions }.into(), span);
        } else {
            self.report(Diagnostic::new(said::TooManyPasses { code, most }, span));
        }
    }

    /// Makes the moves of a cycle.
    pub(super) fn run_cycle(&mut self, block: &Block, cycle: Cycle, thread: Option<Thread>, moves: &[Move]) {
        let kept = self.sink.kept();
        for step in moves {
            let tag = CycleStep { cycle, pass: step.pass, step: step.step };
            let motion = Motion { cycle: Some(tag), center: step.center, ..self.motion(step.kind, step.to) };
            let mut motion = thread.map_or(motion, |thread| thread.of(motion));
            motion.process.uncertain |=
                self.state.doubts.has_any(Doubts::of(&[Doubt::Cycle, Doubt::Contour]));
            self.push(block, motion);
        }
        self.spend(moves.len() - (self.sink.kept() - kept), block);
    }

    /// Width of the grooving insert of the tool in force, mm, if the setup names one.
    pub(super) fn blade_width(&self) -> Option<f64> {
        let (station, offset) = self.state.tool;
        self.setup.tool((station, offset)).and_then(|tool| tool.width)
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
    fn report_amounts(&mut self, text: &[u8], words: &Words, reading: units::Reading) -> bool {
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
    fn in_micrometres(&self, text: &[u8], words: &Words) -> Vec<Fix> {
        // Without the part no messages are shown.
        match FIXING.is_loaded() && self.state.unit == Unit::Millimetre {
            true => in_micrometres(text, words),
            false => Vec::new(),
        }
    }

    /// Number of cuts of a G92 pass: one per start (GSK L).
    pub(super) fn starts(&self, words: &Words, cycle: Single) -> u64 {
        let several = cycle.is_thread() && self.dialect.control == Control::Gsk;
        let starts = if several { words.get(b'L').and_then(plain) } else { None };
        starts.map_or(1, |starts| crate::geometry::within(starts, 1.0, 99.0) as u64)
    }

    /// The start angle of a thread, degrees: Q is in units of 0.001°, up to a full turn, and applies only to
    /// its block (B-64304EN, multiple threads).
    pub(super) fn start_angle(&self, words: &Words) -> f64 {
        let angle = words.get(b'Q').and_then(plain).unwrap_or(0.0);
        crate::geometry::within(angle / 1000.0, 0.0, 360.0)
    }

    /// Pull-out of a thread by the chamfer in tenths of a lead (parameter 5130), if it is switched on.
    pub(super) fn chamfer(&self, lead: f64) -> Option<PullOut> {
        let length = 0.1 * f64::from(self.state.thread_chamfer) * lead;
        (self.state.thread_chamfer_on && length > 0.0).then_some(PullOut { along: length, out: length })
    }
}
