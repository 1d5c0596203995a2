//! Applies all safe repairs of a program.
//!
//! In: a text and its messages. Out: the text with the first safe repair of each message, and a list of the
//! repairs. Repairs that need confirmation are left to the user.
//!
//! A repair is *safe* if the repaired program does what was intended: it changes misread letters, signs and
//! marks, and puts plain words in brackets. It never puts an address with a value in brackets, adds no error,
//! and repairing again changes nothing.

use crate::limits::Limits;
use crate::message::applied;
use crate::message::{Diagnostic, Edit, Fix, Repair};
use crate::order;
use crate::rewrite::before_edits;
use crate::setup::Setup;
use crate::source::Span;

/// Maximum number of rounds. A repaired text can reveal faults that were hidden by others, so it is run
/// again.
const MAX_ROUNDS: usize = 100;

/// Maximum messages per run; repairs for further messages take another round.
const MESSAGES: usize = 100_000;

/// A program after its repairs.
#[derive(Clone, Debug, PartialEq)]
pub struct Repaired {
    /// The new text.
    pub text: Vec<u8>,
    /// The repairs that were made, sorted by place.
    pub taken: Vec<AppliedFix>,
    /// A repair that is still open after the maximum number of rounds; the text must not be used then.
    pub open: Option<Repair>,
}

/// A repair that was applied.
#[derive(Clone, Debug, PartialEq)]
pub struct AppliedFix {
    /// The place in the text before all repairs.
    pub span: Span,
    /// Description of the repair.
    pub title: Repair,
}

/// Applies all safe repairs, until there are none left.
pub fn repaired(text: &[u8], setup: &Setup) -> Repaired {
    repaired_of(text, setup, &|_| true)
}

/// Applies the safe repairs of the messages that `wanted` accepts.
pub fn repaired_of(text: &[u8], setup: &Setup, wanted: &dyn Fn(&Diagnostic) -> bool) -> Repaired {
    within(MAX_ROUNDS, text, setup, wanted)
}

/// Repairs a program in at most `most` rounds.
fn within(most: usize, text: &[u8], setup: &Setup, wanted: &dyn Fn(&Diagnostic) -> bool) -> Repaired {
    let limits = Limits { messages: MESSAGES.max(setup.limits.messages), ..setup.limits };
    let setup = Setup { limits, ..setup.clone() };
    let (mut text, mut taken, mut open) = (text.to_vec(), Vec::new(), None);
    let mut earlier: Vec<Vec<Edit>> = Vec::new();
    loop {
        let mut analysis = crate::analyze(&text, &setup);
        analysis.diagnostics.retain(wanted);
        let fixes = safe(&analysis.diagnostics);
        if fixes.is_empty() {
            break;
        }
        if earlier.len() == most {
            open = fixes.first().map(|fix| fix.title.clone());
            break;
        }
        let edits: Vec<Edit> = fixes.iter().flat_map(|fix| fix.edits.iter().cloned()).collect();
        let first = |byte: u32| earlier.iter().rev().fold(byte, |byte, edits| before_edits(byte, edits));
        taken.extend(fixes.iter().filter_map(|fix| {
            let (start, end) = (fix.edits.first()?.span.start, fix.edits.last()?.span.end);
            Some(AppliedFix { span: Span { start: first(start), end: first(end) }, title: fix.title.clone() })
        }));
        text = applied(&text, &edits);
        earlier.push(edits);
    }
    order::by_key(&mut taken, |taken| taken.span.start);
    Repaired { text, taken, open }
}

/// The first safe repair of each message, sorted by place. If several touch the same text, only the first of
/// them.
pub fn safe(diagnostics: &[Diagnostic]) -> Vec<&Fix> {
    let safe = diagnostics.iter().filter_map(|found| found.fixes.iter().find(|fix| fix.safe));
    let mut fixes: Vec<(Span, &Fix)> = safe
        .filter_map(|fix| {
            let (first, last) = (fix.edits.first()?, fix.edits.last()?);
            Some((Span { start: first.span.start, end: last.span.end }, fix))
        })
        .collect();
    order::by_key(&mut fixes, |(whole, _)| whole.start);
    let mut last: Option<Span> = None;
    fixes.retain(|(whole, _)| {
        // The order of two insertions at the same place would be arbitrary.
        let apart = last.is_none_or(|last| last.end <= whole.start && last.start < whole.start);
        if apart {
            last = Some(*whole);
        }
        apart
    });
    fixes.into_iter().map(|(_, fix)| fix).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::message::said;

    fn told(fixes: Vec<Fix>) -> Diagnostic {
        fixes.into_iter().fold(Diagnostic::new(said::PrintedMinus, Span::new(0, 0)), Diagnostic::with)
    }

    fn replace(start: usize, end: usize, text: &str) -> Fix {
        Fix::replace(Repair::Minus, Span::new(start, end), text)
    }

    #[test]
    fn the_first_safe_repair_of_each_message_is_taken() {
        let messages = [
            told(vec![replace(9, 9, "z")]),
            told(vec![replace(0, 1, "a").needs_confirmation(), replace(1, 3, "b"), replace(1, 3, "c")]),
            told(vec![replace(5, 6, "d").needs_confirmation()]),
            told(vec![replace(2, 4, "overlaps")]),
            told(vec![replace(3, 3, "e")]),
            told(vec![replace(3, 4, "inserted there before")]),
            told(vec![]),
        ];
        let texts: Vec<_> = safe(&messages).iter().map(|fix| fix.edits[0].text.as_str()).collect();
        assert_eq!(texts, ["b", "e", "z"]);
    }

    #[test]
    fn what_is_hidden_by_a_fault_is_repaired_too() {
        for (before, after) in [
            ("GO1 X5O\nM30", "G01 X50\nM30"),
            ("G00 X1 Z–5\nG01 X２ F0.1\n(open\nM30", "G00 X1 Z-5\nG01 X2 F0.1\n(open)\nM30"),
            ("G00 X1\nM30", "G00 X1\nM30"),
        ] {
            let repaired = repaired(before.as_bytes(), &Setup::default());
            assert_eq!(String::from_utf8_lossy(&repaired.text), after);
            assert_eq!(repaired.taken.is_empty(), before == after);
        }
    }

    #[test]
    fn a_repair_that_is_still_open_is_named() {
        let text = b"G00 X5O\nM30";
        let repaired = within(0, text, &Setup::default(), &|_| true);
        assert_eq!(repaired.text, text);
        assert_eq!(repaired.open, Some(Repair::Write { text: "X50".into() }));
        assert_eq!(within(1, text, &Setup::default(), &|_| true).open, None);
    }

    #[test]
    fn a_rule_that_is_off_repairs_nothing() {
        let text = "(RULES PRINTED-MINUS=OFF)\nG00 X1 Z–5\nM30";
        let repaired = repaired(text.as_bytes(), &Setup::default());
        assert_eq!(repaired.text, text.as_bytes());
    }
}
