//! Macro statements.
//!
//! ```text
//! statement  = assignment | jump | loop | "IF" condition ( assignment | jump | "THEN" then ) | print
//! then       = assignment | jump | words of an ordinary block
//! assignment = variable "=" sum [ comment ]
//! jump       = "GOTO" ( number | variable | "[" sum "]" | function )
//! loop       = [ "WHILE" condition ] "DO" number | "END" number
//! print      = ( "POPEN" | "PCLOS" | "BPRNT" | "DPRNT" | "SETVN" ) …
//! ```
//!
//! In: the text of a block without its `/` and sequence number, and the memory of the variables. Out: the
//! action for the caller. Knows the grammar of a single block; the caller finds loops and jump targets.

use std::ops::Range;

use super::expression::Evaluator;
use super::functions::count;
use super::{MacroError, MacroErrorKind, Memory};

/// What the caller has to do after a statement. Texts are byte ranges of the statement.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// Nothing: the statement was carried out, or its condition is false.
    Done,
    /// Continue at the block with this sequence number, 1 to 99 999 999.
    Goto(u32),
    /// WHILE … DO: with `enter`, continue after it and return at END; otherwise continue after the END.
    While {
        /// The loop number, 1 to 3.
        number: u32,
        /// The condition is true.
        enter: bool,
    },
    /// DO without WHILE: continue after it and return at END.
    Do {
        /// The loop number, 1 to 3.
        number: u32,
    },
    /// END: return to the beginning of the loop.
    End {
        /// The loop number, 1 to 3.
        number: u32,
    },
    /// Run these bytes as an ordinary block: the condition of IF … THEN is true.
    Words(Range<usize>),
    /// `#3000=n(…)`: the program stops with an alarm.
    Alarm {
        /// The number as written; the control displays this number plus 3000.
        number: i64,
        /// The text in the brackets.
        message: Range<usize>,
    },
    /// `#3006=n(…)`: the program stops until the operator starts it again.
    Pause {
        /// The text in the brackets.
        message: Range<usize>,
    },
    /// Output to a device, which is not parsed because no motion depends on it.
    Print,
}

/// Assigning this variable raises an alarm.
const ALARM: u32 = 3000;

/// Assigning this variable stops the program with a message.
const PAUSE: u32 = 3006;

/// Largest sequence number.
const MAX_SEQUENCE: u32 = 99_999_999;

/// Carries out the macro statement of a block. The text after a false condition is not parsed.
pub fn statement(text: &[u8], memory: &mut impl Memory) -> Result<Action, MacroError> {
    let mut reader = Evaluator::new(text, memory);
    match reader.cursor.peek() {
        Some(b'#') => assignment(&mut reader),
        Some(b'I') if reader.cursor.eat_word(b"IF") => conditional(&mut reader),
        Some(b'W') if reader.cursor.eat_word(b"WHILE") => {
            let enter = reader.condition()?;
            if !reader.cursor.eat_word(b"DO") {
                return Err(MacroErrorKind::Format.at(reader.cursor.here()));
            }
            let number = loop_number(&mut reader)?;
            ended(&mut reader, Action::While { number, enter })
        }
        Some(b'G') if reader.cursor.eat_word(b"GOTO") => jump(&mut reader),
        Some(b'D') if reader.cursor.eat_word(b"DO") => {
            let number = loop_number(&mut reader)?;
            ended(&mut reader, Action::Do { number })
        }
        Some(b'E') if reader.cursor.eat_word(b"END") => {
            let number = loop_number(&mut reader)?;
            ended(&mut reader, Action::End { number })
        }
        Some(b'P' | b'B' | b'D' | b'S')
            if [b"POPEN", b"PCLOS", b"BPRNT", b"DPRNT", b"SETVN"]
                .into_iter()
                .any(|word| reader.cursor.eat_word(word)) =>
        {
            Ok(Action::Print)
        }
        _ => Err(MacroErrorKind::Format.at(reader.cursor.here())),
    }
}

/// The variable that an assignment writes; `None` for any other statement.
pub fn assigned(text: &[u8], memory: &mut impl Memory) -> Option<u32> {
    let mut reader = Evaluator::new(text, memory);
    (reader.cursor.peek() == Some(b'#')).then(|| reader.variable().ok()).flatten()
}

/// The rest of an IF statement.
fn conditional(reader: &mut Evaluator) -> Result<Action, MacroError> {
    let holds = reader.condition()?;
    let then = reader.cursor.eat_word(b"THEN");
    let start = reader.cursor.start();
    match reader.cursor.peek() {
        None => Err(MacroErrorKind::Format.at(reader.cursor.here())),
        Some(b'#') if holds => assignment(reader),
        Some(b'G') if reader.cursor.eat_word(b"GOTO") => {
            if holds {
                jump(reader)
            } else {
                Ok(Action::Done)
            }
        }
        Some(b'#') => Ok(Action::Done),
        Some(_) if !then => Err(MacroErrorKind::Format.at(reader.cursor.here())),
        Some(_)
            if ["IF", "WHILE", "DO", "END", "THEN"]
                .into_iter()
                .any(|word| reader.cursor.eat_word(word.as_bytes())) =>
        {
            Err(MacroErrorKind::Format.at(reader.cursor.since(start)))
        }
        Some(_) if holds => Ok(Action::Words(reader.cursor.rest())),
        Some(_) => Ok(Action::Done),
    }
}

fn assignment(reader: &mut Evaluator) -> Result<Action, MacroError> {
    let start = reader.cursor.start();
    let variable = reader.variable()?;
    let at = reader.cursor.since(start);
    if !reader.cursor.eat(b'=') {
        return Err(MacroErrorKind::Format.at(reader.cursor.here()));
    }
    let value = reader.sum()?.number()?;
    let message = reader.cursor.comment();
    let action = match variable {
        ALARM => Action::Alarm { number: value.unwrap_or(0.0).round() as i64, message },
        PAUSE => Action::Pause { message },
        _ => Action::Done,
    };
    // Checked before anything is written, so that a faulty block has no effect.
    let action = ended(reader, action)?;
    if action == Action::Done {
        reader.write(variable, value, at)?;
    }
    Ok(action)
}

fn jump(reader: &mut Evaluator) -> Result<Action, MacroError> {
    // `GOTO N10`: GOTO takes the number without N.
    let (start, mut ahead) = (reader.cursor.start(), reader.cursor);
    if ahead.eat(b'N') && ahead.number().is_some() {
        return Err(MacroErrorKind::JumpTarget.at(ahead.since(start)));
    }
    let value = reader.term()?;
    let target = count(value.or_zero()?).filter(|target| (1..=MAX_SEQUENCE).contains(target));
    let target = target.ok_or_else(|| MacroErrorKind::JumpTarget.at(value.at.clone()))?;
    ended(reader, Action::Goto(target))
}

/// The number of a loop, a literal.
fn loop_number(reader: &mut Evaluator) -> Result<u32, MacroError> {
    let start = reader.cursor.start();
    let Some(number) = reader.cursor.number() else {
        return Err(MacroErrorKind::LoopNumber.at(reader.cursor.here()));
    };
    let number = count(number).filter(|number| (1..=3).contains(number));
    number.ok_or_else(|| MacroErrorKind::LoopNumber.at(reader.cursor.since(start)))
}

/// The action of a statement, if nothing else follows it.
fn ended(reader: &mut Evaluator, action: Action) -> Result<Action, MacroError> {
    let kind = match reader.cursor.peek() {
        None => return Ok(action),
        Some(_) if reader.cursor.operator().is_some() => MacroErrorKind::Expression,
        Some(b']' | b'0'..=b'9' | b'.') => MacroErrorKind::Expression,
        Some(byte) if byte.is_ascii_alphabetic() => MacroErrorKind::WordsBehind,
        Some(_) => MacroErrorKind::Format,
    };
    Err(kind.at(reader.cursor.here()))
}
