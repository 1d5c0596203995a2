//! G76 as blocks call it: `P(m)(r)(a) Q R`, then the thread (seeds 001 and 003, GSK980TDb pp. 135, 138).
//!
//! In: the words of a block. Out: the passes. `cycles::threading` has the geometry, `lint::thread` the advice
//! of an instructor.

use super::cycle_moves::{Thread, angle_of_start};
use super::{AXES, Interpreter};
use crate::control::doubt::Doubt;
use crate::control::events::{Event, ThreadPass, ThreadSource, ThreadingCall};
use crate::control::words::{Words, plain, quote};
use crate::cycles::single::{self, Single};
use crate::cycles::threading::{self, MultiThread};
use crate::cycles::units;
use crate::geometry::Point;
use crate::message::{Diagnostic, Fix, Message, said};
use crate::motion::Cycle;
use crate::parts::{Part, late};
use crate::setup::dialect::{Control, G76Clamp, PqUnit};
use crate::text::block::{Block, Value, Word};

/// Tool angles that FANUC accepts, degrees (PS0315).
const THREAD_ANGLES: [f64; 6] = [0.0, 29.0, 30.0, 55.0, 60.0, 80.0];

/// A minimum depth of G76 above this, mm, is reported as implausible.
const MIN_DEPTH: f64 = 1.0;

/// The part of the module that contains fixes of words.
const FIXING: Part = Part::Late;

late! {
    // P of G76 with the nearest permitted angle.
    fn nearest_angle(text: &[u8], word: &Word, angle: f64) -> Option<Fix> {
        let Value::Number { number, .. } = word.value else { return None };
        let written = quote(text, word.span);
        let head = written.len().saturating_sub(2);
        let apart = |other: &f64| (other - angle).abs();
        let near = THREAD_ANGLES.into_iter().min_by(|a, b| apart(a).total_cmp(&apart(b)));
        near.filter(|_| written.is_char_boundary(head) && number.digits >= 3)
            .map(|near| Fix::write(word.span, format!("{}{near:02}", &written[..head])))
    }
}

impl Interpreter {
    /// G76.
    pub(super) fn multi_threading(&mut self, text: &[u8], block: &Block, words: &Words) -> Option<()> {
        let reading = self.reading();
        let length = |address: u8| words.get(address).and_then(|word| reading.length(word));
        if !words.has_any(AXES) {
            return self.threading_parameters(text, words);
        }
        let one_block = words.peek(b'K').is_some();
        let start = self.state.position;
        let end = self.target(text, words);
        let taper = if one_block { length(b'I') } else { length(b'R') }.unwrap_or(0.0);
        let Some(lead) = self.lead(text, block, words, "G76") else {
            self.last_pass(block, start, end, taper, None);
            return None;
        };
        self.observe(text, Event::Thread { block, code: "G76", to: None });
        let starts = self.starts(words, Single::Threading);
        let own_start = Point::new(end.x, start.z);
        let pass = ThreadPass { block, words, start: own_start, end, lead, starts, by: ThreadSource::Passes };
        self.observe(text, Event::ThreadPass(pass));
        let (height, first_depth, least_depth, method) = if one_block {
            let depth = words.get(b'D').and_then(|word| self.one_block_depth(word));
            (length(b'K'), depth, 0.0, words.get(b'P').and_then(plain).unwrap_or(1.0) as u32)
        } else {
            // Q of the first block is read in the unit of this block's P and Q.
            let least = self.state.parameters.least_amount;
            let Some((unit, p, q)) = self.amounts(text, words, |p, q| units::threading(least, p, q)) else {
                self.last_pass(block, start, end, taper, Some(lead));
                return None;
            };
            (p, q, least.map_or(0.0, |least| self.amount_in(least, unit)), 1)
        };
        let angle = if one_block {
            words.get(b'A').and_then(plain).unwrap_or(0.0)
        } else {
            self.state.parameters.angle
        };
        let gsk = self.dialect.control == Control::Gsk;
        if !gsk && !one_block && !THREAD_ANGLES.contains(&angle) {
            // Reported at the first block.
            self.last_pass(block, start, end, taper, Some(lead));
            return None;
        }
        let parameters = self.state.parameters;
        let how = MultiThread {
            end,
            taper,
            height: height.unwrap_or(0.0),
            first_depth: first_depth.unwrap_or(0.0),
            least_depth,
            allowance: if one_block { 0.0 } else { parameters.thread_allowance },
            finishing: parameters.finishing,
            pull_out: self.chamfer(lead),
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
        let message: Message = match threading::thread(start, &how, most) {
            Ok(moves) => {
                let angle = if one_block { 60.0 } else { angle };
                let how = &how;
                let call = ThreadingCall { block, words, start, how, lead, angle, one_block };
                self.observe(text, Event::Threading(call));
                // P and Q are depths in the two-block form; in the one-block form Q is the start angle.
                let own_angle = if one_block { self.start_angle(words) } else { 0.0 };
                for number in 0..starts {
                    let start_angle = own_angle + angle_of_start(number, starts);
                    let thread = Thread { lead, start_angle };
                    self.run_cycle(block, Cycle::MultiThreading, Some(thread), &moves);
                }
                return Some(());
            }
            Err(threading::ThreadingError::Angle) => said::ThreadAngle { angle }.into(),
            Err(threading::ThreadingError::LeastDepthTooLarge) => {
                said::ThreadLeastDepth { least: how.least_depth, height: how.height }.into()
            }
            Err(threading::ThreadingError::NoHeight) => said::ThreadNoHeight.into(),
            Err(threading::ThreadingError::NoFirstDepth) => said::ThreadNoFirstDepth.into(),
            Err(threading::ThreadingError::TooManyMoves) => {
                self.refuse_long_cycle(block, "G76", 0, most);
                return None;
            }
        };
        self.report(Diagnostic::new(message, block.words_span()));
        self.last_pass(block, start, end, taper, Some(lead));
        None
    }

    /// The last pass of a G76 whose other passes are unknown.
    #[cold]
    fn last_pass(&mut self, block: &Block, start: Point, end: Point, taper: f64, lead: Option<f64>) {
        self.state.doubts.add(Doubt::Contour);
        let moves = single::threading(start, end, taper, lead.and_then(|lead| self.chamfer(lead)));
        let thread = lead.map(|lead| Thread { lead, start_angle: 0.0 });
        self.run_cycle(block, Cycle::MultiThreading, thread, &moves);
    }

    /// The first block of G76: `P(m)(r)(a) Q R`.
    pub(super) fn threading_parameters(&mut self, text: &[u8], words: &Words) -> Option<()> {
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
                let diagnostic = Diagnostic::new(said::ThreadAngle { angle }, word.span);
                // Without the part no messages are shown.
                let fix = FIXING.is_loaded().then(|| nearest_angle(text, word, angle)).flatten();
                self.report(Diagnostic { fixes: fix.into_iter().collect(), ..diagnostic });
            }
        }
        if words.peek(b'Q').is_some() {
            self.state.parameters.least_amount = self.amount(words, b'Q');
            let least = self.state.parameters.least_amount.map_or(0.0, |least| least.in_increments);
            if self.dialect.pq_unit != PqUnit::Mm && least > MIN_DEPTH {
                let message = said::ThreadLeastLarge { word: words.quote(text, b'Q'), least };
                self.report(Diagnostic::new(message, words.span(b'Q')));
            }
        }
        if let Some(allowance) = words.get(b'R').and_then(|word| reading.length(word)) {
            self.state.parameters.thread_allowance = allowance.abs();
        }
        Some(())
    }
}
