//! Values of macro expressions, and the actions of macro statements.

use super::loops::{Mark, loop_mark};
use super::store::Store;
use super::{BlockPosition, Flow, Interpreter};
use crate::control::codes;
use crate::control::events::Event;
use crate::control::macros::{self, Action, Knowledge, MacroError};
use crate::control::words::quote;
use crate::message::{Diagnostic, said};
use crate::setup::dialect::Control;
use crate::source::Span;
use crate::text::block::{Block, Value, Word};
use crate::text::lexer::Number;
use crate::units::Unit;

/// Result of a statement.
pub(super) enum Evaluated {
    /// The action to carry out.
    Action(Action),
    /// Finished; the program continues here.
    Flow(Flow),
    /// The statement cannot be carried out.
    Fault(MacroError),
}

impl Interpreter {
    /// Evaluates the statement of a block. Unknown values are handled here.
    pub(super) fn evaluate(
        &mut self,
        text: &[u8],
        block: &Block,
        statement: &[u8],
        here: BlockPosition,
    ) -> Evaluated {
        let mut store = Store::new(self, text, block);
        let outcome = macros::statement(statement, &mut store);
        let unknown = store.knowledge == Knowledge::Unknown;
        match outcome {
            Err(fault) if unknown && fault.kind.depends_on_values() => {
                Evaluated::Flow(self.unknown_statement(text, block, statement, here))
            }
            Ok(Action::Goto(_) | Action::While { .. }) if unknown => {
                Evaluated::Flow(self.unknown_statement(text, block, statement, here))
            }
            // The macro checks its arguments with an alarm; they are unknown here.
            Ok(Action::Alarm { .. }) if self.state.variables.has_unknown_arguments() => {
                self.doubt_after_missing_program();
                Evaluated::Flow(Flow::Next)
            }
            Ok(action) => {
                if unknown {
                    self.unknown_condition(text, block, statement);
                }
                Evaluated::Action(action)
            }
            Err(fault) => {
                self.doubt_statement(statement);
                Evaluated::Fault(fault)
            }
        }
    }

    /// The block with values in place of expressions; words with a vacant variable are left out. `None`: an
    /// error was reported.
    #[cold]
    pub(super) fn evaluated(&mut self, text: &[u8], block: &Block) -> Option<Block> {
        let mut own = block.clone();
        own.has_expressions = false;
        own.words.clear();
        let mut handed_over = false;
        for word in &block.words {
            if word.value != Value::Expression {
                own.words.push(*word);
                handed_over |= codes::calls_macro(word);
                continue;
            }
            if matches!(word.address, b'N' | b'O') && !handed_over {
                let message = said::NumberFromVariable { word: quote(text, word.span) };
                self.report(Diagnostic::new(message, word.span));
                return None;
            }
            // Arguments of a macro keep all digits.
            let places =
                (!handed_over || matches!(word.address, b'P' | b'L')).then(|| self.places(word.address));
            let (number, negative) = self.value_of(text, block, word, places)?;
            if number.is_none() && !handed_over && !self.uses_unknown_value {
                self.observe(text, Event::VacantWord { word });
            }
            let value = number.map(|number| Word { value: Value::Number { number, negative }, ..*word });
            handed_over |= value.as_ref().is_some_and(codes::calls_macro);
            own.words.extend(value);
        }
        Some(own)
    }

    /// The value of a word's expression, rounded to `places` decimals if given. The outer `None`: an error
    /// was reported.
    fn value_of(
        &mut self,
        text: &[u8],
        block: &Block,
        word: &Word,
        places: Option<u8>,
    ) -> Option<(Option<Number>, bool)> {
        if !self.count_macro_step(block) {
            return None;
        }
        // The letter, with an optional comma and blanks, comes before the expression.
        let written = word.span.of(text);
        let letter = written.iter().position(u8::is_ascii_alphabetic).unwrap_or(0) + 1;
        let increment = 10f64.powi(-i32::from(self.places(word.address)));
        let mut store = Store::new(self, text, block);
        let value = macros::address_value(&written[letter..], increment, &mut store);
        if store.knowledge == Knowledge::Unknown {
            self.uses_unknown_value = true;
        }
        match value {
            Err(fault) if self.uses_unknown_value && fault.kind.depends_on_values() => {
                self.mark_left_out();
                None
            }
            Ok(None) => Some((None, false)),
            Ok(Some(value)) => match number_of(value, places.unwrap_or_else(|| places_of(value))) {
                Some(number) => Some((Some(number), value < 0.0)),
                None => {
                    let (word, word_span) = (quote(text, word.span), word.span);
                    self.report(Diagnostic::new(said::TooManyDigits { word }, word_span));
                    None
                }
            },
            Err(fault) => {
                let start = word.span.start + letter as u32;
                self.report_fault(text, &fault, Span { start, end: word.span.end });
                None
            }
        }
    }

    /// Number of decimals of an address.
    fn places(&self, address: u8) -> u8 {
        match address {
            b'M' | b'S' | b'T' | b'N' | b'O' | b'L' => 0,
            b'P' | b'Q' if self.dialect.control != Control::Forum => 0,
            b'G' => 1,
            b'F' | b'E' => 6,
            _ => match self.state.unit {
                Unit::Millimetre => 3,
                Unit::Inch => 4,
            },
        }
    }

    /// A statement depends on an unknown value and has no value itself, or jumps: the program continues after
    /// it.
    #[cold]
    fn unknown_statement(
        &mut self,
        text: &[u8],
        block: &Block,
        statement: &[u8],
        here: BlockPosition,
    ) -> Flow {
        self.unknown_condition(text, block, statement);
        if let Some((Mark::Do, number)) = loop_mark(text, block)
            && self.block_after_end(text, block, number, here).is_some()
        {
            self.run_once(number, here);
        }
        Flow::Next
    }

    /// A statement depends on an unknown value: it may have assigned a variable or jumped.
    #[cold]
    fn unknown_condition(&mut self, text: &[u8], block: &Block, statement: &[u8]) {
        match macros::assigned(after_condition(statement), &mut Store::new(self, text, block)) {
            Some(variable) => self.state.variables.set_unknown(variable, Knowledge::Unknown),
            None => self.doubt_after_missing_program(),
        }
    }
}

/// Number of decimals that keeps all significant digits of a double.
fn places_of(value: f64) -> u8 {
    const DIGITS: f64 = 15.0;
    crate::geometry::within(DIGITS - value.abs().max(1.0).log10().ceil(), 0.0, DIGITS) as u8
}

/// A value as a number with `places` decimals; `None` if it is too large for any address.
fn number_of(value: f64, places: u8) -> Option<Number> {
    const MAX_VALUE: f64 = 99_999_999.0;
    if value.is_nan() || value.abs() > MAX_VALUE {
        return None;
    }
    let mantissa = (value.abs() * 10f64.powi(i32::from(places))).round() as u64;
    // A value never counts least increments: it has a point if the address allows one.
    Some(Number { mantissa, decimals: places, digits: 8, points: u8::from(places > 0) })
}

/// The text after the condition of IF; the whole text of any other statement.
fn after_condition(statement: &[u8]) -> &[u8] {
    let statement = statement.trim_ascii_start();
    if !statement.get(..2).is_some_and(|head| head.eq_ignore_ascii_case(b"IF")) {
        return statement;
    }
    let mut depth = 0;
    let closing = statement.iter().position(|byte| {
        depth += i32::from(*byte == b'[') - i32::from(*byte == b']');
        *byte == b']' && depth == 0
    });
    let rest = closing.map_or(&[][..], |closing| statement[closing + 1..].trim_ascii_start());
    match rest.get(..4) {
        Some(then) if then.eq_ignore_ascii_case(b"THEN") => rest[4..].trim_ascii_start(),
        _ => rest,
    }
}
