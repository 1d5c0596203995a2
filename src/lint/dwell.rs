//! Lint for G04: seconds and milliseconds mixed up.

use crate::control::events::EventContext;
use crate::control::words::{Words, after_letter, plain, quote};
use crate::message::{Diagnostic, Fix, said};
use crate::motion::SpindleTurn;
use crate::text::block::{Value, Word};

/// Seconds from which a whole number is probably milliseconds: no cut needs such a long dwell.
const MIN_AS_MILLISECONDS: f64 = 100.0;

/// Milliseconds up to which P is probably seconds: in so short a time no spindle makes a turn.
const MAX_AS_SECONDS: f64 = 9.0;

/// Reports seconds that were meant as milliseconds, or the reverse. `seconds` is the dwell on the control.
pub fn check_dwell(words: &Words, seconds: f64, at: &EventContext) -> Option<Diagnostic> {
    // With the spindle stopped, the dwell is for something else: the chuck, or a part that cools down.
    let spindle = &at.state.spindle;
    if spindle.turn == SpindleTurn::Stopped && !spindle.live_tool && !spindle.machine_code_with_speed {
        return None;
    }
    let whole = |word: &&Word| matches!(word.value, Value::Number { number, .. } if !number.has_point());
    let text = |word: &Word| quote(at.text, word.span);
    if let Some(word) = words.peek(b'X').or(words.peek(b'U')) {
        let value = plain(word).filter(|_| whole(&word))?;
        if seconds < MIN_AS_MILLISECONDS || value != seconds {
            return None;
        }
        let message = said::DwellLong { word: text(word), seconds, meant: value / 1000.0 };
        let fix = Fix::write(word.span, format!("{}{}", word.address as char, value / 1000.0));
        return Some(Diagnostic::new(message, word.span).with(fix));
    }
    // Macros use a very short dwell to stop the look-ahead of the control.
    let is_main = at.state.variables.level() == 0;
    let word = words.peek(b'P').filter(|word| is_main && whole(word))?;
    let value =
        plain(word).filter(|value| (1.0..=MAX_AS_SECONDS).contains(value) && value / 1000.0 == seconds)?;
    let quoted = text(word);
    let fix = Fix::write(word.span, format!("P{}000", after_letter(&quoted).trim_start_matches(['0', '+'])));
    Some(Diagnostic::new(said::DwellShort { word: quoted, milliseconds: value }, word.span).with(fix))
}
