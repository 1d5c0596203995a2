//! Lints for words that a move does not read, and words that a vacant variable removes.
//!
//! In: the words of a block that its code does not read. Out: remarks that the control ignores them.

use crate::control::doubt::Doubt;
use crate::control::events::EventContext;
use crate::control::macros::Variables;
use crate::control::words::{Words, after_letter, letters, quote};
use crate::cycles::single::Single;
use crate::message::{Diagnostic, Fix, Message, Severity, said};
use crate::source::Span;
use crate::source::shift::Shift;
use crate::text::block::{Block, Word};

/// Reports the first of the words that the control ignores; `unread` is the set of their letters. One
/// mistake, one message: P and Q usually belong together. `code` is the executed code that does not read
/// them.
pub fn unread(
    block: &Block,
    words: &Words,
    unread: u32,
    code: Option<&'static str>,
    at: &EventContext,
) -> Option<Diagnostic> {
    // If a letter occurs twice the last word is used; the other one was reported.
    let counts = |word: &&Word| words.peek(word.address).is_some_and(|own| own.span == word.span);
    let word = block
        .words
        .iter()
        .filter(|word| !word.comma && unread & letters(&[word.address]) != 0)
        .find(counts)?;
    let quoted = quote(at.text, word.span);
    let number = after_letter(&quoted);
    let corner = match word.address {
        b'L' => Some(format!(",C{number}")),
        b'D' => Some(format!(",R{number}")),
        _ => None,
    };
    if let Some(meant) = corner.filter(|_| code == Some("G01") && at.state.virtual_plane.is_none()) {
        let fix = Fix::write(word.span, meant.clone());
        return Some(Diagnostic::new(said::CornerWordIgnored { word: quoted, meant }, word.span).with(fix));
    }
    let is_arc = matches!(code, Some("G02" | "G03"));
    let message: Message = match code {
        Some(_) if is_arc && matches!(word.address, b'I' | b'J' | b'K') => {
            said::CentreWordIgnored { word: quoted, radius: words.quote(at.text, b'R') }.into()
        }
        Some(code) => said::WordIgnored { word: quoted, code }.into(),
        None => said::WordNotRead { word: quoted }.into(),
    };
    Some(Diagnostic::new(message, word.span).with(Fix::delete(at.text, word.span)))
}

/// Reports a word of another axis in a block of a single cycle without X and Z: the cycle does not run, and
/// nothing moves.
pub fn without_axis(words: &Words, cycle: Single, at: &EventContext) -> Option<Diagnostic> {
    let letter = b"CHYV".iter().copied().find(|&letter| words.peek(letter).is_some())?;
    let fix = Fix::delete(at.text, words.span(letter));
    let message = said::WordIgnored { word: words.quote(at.text, letter), code: cycle.cycle().code() };
    Some(Diagnostic::new(message, words.span(letter)).with(fix))
}

/// The vacant variables that were reported, each once.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Vacant(Vec<u32>);

impl Vacant {
    /// Reports a word that is dropped because its variable is vacant, once for each variable.
    pub fn report_vacant(&mut self, word: &Word, at: &EventContext) -> Option<Diagnostic> {
        let (variable, diagnostic) = vacant(word, at)?;
        let is_new = self.0.len() < MAX_RECORDED && !self.0.contains(&variable);
        is_new.then(|| {
            self.0.push(variable);
            diagnostic
        })
    }

    /// Takes over the remarks that `other` has made.
    pub fn inherit_reported(&mut self, other: &mut Self) {
        self.0 = std::mem::take(&mut other.0);
    }
}

/// The number of the vacant variable of a word, and the remark. An optional argument of a call is intended to
/// be vacant.
fn vacant(word: &Word, at: &EventContext) -> Option<(u32, Diagnostic)> {
    let quoted = quote(at.text, word.span);
    let variable = after_letter(quoted.trim_start_matches(',')).trim_start_matches('-').strip_prefix('#')?;
    let variable: u32 = variable.parse().ok()?;
    let is_handed_over = at.state.variables.level() > 0 && Variables::may_be_argument(variable);
    // After an assignment that was not executed, the value is unknown.
    let is_unknown = at.state.doubts.has(Doubt::Values) || at.state.variables.has_unknown_arguments();
    if variable == 0 || is_handed_over || is_unknown {
        return None;
    }
    // A variable that is kept at power-off may have a value on the machine.
    let kept = variable >= 500;
    let message: Message = match kept {
        true => said::VacantHere { word: quoted, variable }.into(),
        false => said::VacantWord { word: quoted, variable }.into(),
    };
    let diagnostic = Diagnostic::new(message, word.span);
    Some((variable, if kept { diagnostic.with_severity(Severity::Info) } else { diagnostic }))
}

/// Whether a condition reads a variable of the machine (#1000 and up) or, in a called macro, a local variable
/// (#1 to #33): the call has passed its value.
fn depends_on_caller(condition: &[u8], is_called: bool) -> bool {
    condition.split(|&byte| byte == b'#').skip(1).any(|behind| {
        let digits = behind.iter().skip_while(|byte| byte.is_ascii_whitespace());
        let digits: String =
            digits.take_while(|byte| byte.is_ascii_digit()).copied().map(char::from).collect();
        let variable = digits.parse::<u32>();
        variable.is_ok_and(|variable| variable >= 1000 || is_called && (1..=33).contains(&variable))
    })
}

/// All WHILE loops, and whether they were entered.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Loops(Vec<(Span, bool)>);

/// Most loops and most vacant variables; programs have fewer.
const MAX_RECORDED: usize = 200;

impl Loops {
    /// Handles a loop that begins or is skipped.
    pub fn record(&mut self, statement: Span, enter: bool, at: &EventContext) {
        // A value from outside may be different next time.
        let may_enter = enter || depends_on_caller(statement.of(at.text), at.state.variables.level() > 0);
        if let Some(own) = self.0.iter_mut().find(|own| own.0 == statement) {
            own.1 |= may_enter;
        } else if self.0.len() < MAX_RECORDED {
            self.0.push((statement, may_enter));
        }
    }

    /// Reports, at the end of the run, the loops that were never entered.
    pub fn report(&mut self, reports: &mut Vec<Diagnostic>) {
        let never = self.0.iter().filter(|own| !own.1);
        reports.extend(never.map(|own| Diagnostic::new(said::LoopNotEntered, own.0)));
    }

    /// Takes over the loops that `other` has seen.
    pub fn inherit_reported(&mut self, other: &mut Self) {
        self.0 = std::mem::take(&mut other.0);
    }

    /// Shifts the stored spans after an edit.
    pub fn shift(&mut self, shift: &Shift) {
        self.0.iter_mut().for_each(|own| own.0 = shift.span(own.0));
    }
}
