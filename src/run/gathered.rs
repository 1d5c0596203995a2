//! Combines messages about a repeated habit into one message per program.
//!
//! In: the messages of a run, sorted by place. Out: the same messages, with one for all unclosed comments and
//! one for all remarks without brackets: at the first occurrence, with the number of the others and all
//! fixes.

use crate::message::{Diagnostic, Message, Repair, said};
use crate::text::parser::short_quote;

/// Combines the messages about each habit. Keeps errors without a safe fix separate, because a word may be
/// lost there.
pub(super) fn gather(messages: &mut Vec<Diagnostic>, text: &[u8]) {
    let all = std::mem::take(messages);
    // The index of each first message, and the number of further ones.
    let mut habits: Vec<(usize, usize)> = Vec::new();
    for told in all {
        let is_open = told.is_error() && !told.fixes.iter().any(|fix| fix.safe);
        if is_open || !is_habit(&told.message) {
            messages.push(told);
            continue;
        }
        let like = |first: &Diagnostic| {
            first.message.name() == told.message.name() && first.severity == told.severity
        };
        let Some(habit) = habits.iter().position(|&(first, _)| like(&messages[first])) else {
            habits.push((messages.len(), 0));
            messages.push(told);
            continue;
        };
        habits[habit].1 += 1;
        let fixes = &mut messages[habits[habit].0].fixes;
        for fix in told.fixes {
            match fixes.iter_mut().find(|own| own.safe == fix.safe) {
                Some(own) => own.edits.extend(fix.edits),
                None => fixes.push(fix),
            }
        }
    }
    for (first, more) in habits.into_iter().filter(|(_, more)| *more > 0) {
        let first = &mut messages[first];
        first.message = with_more(first, more, text);
        for fix in first.fixes.iter_mut().filter(|fix| fix.edits.len() > 1) {
            if let Repair::Write { text } = &mut fix.title {
                text.push_str(", …");
            }
        }
    }
}

fn is_habit(message: &Message) -> bool {
    message.is::<said::CommentOpen>()
        || message.is::<said::TextAfterSemicolon>()
        || message.is::<said::TextAfterSlashes>()
}

/// The message with the number of further occurrences.
fn with_more(told: &Diagnostic, more: usize, text: &[u8]) -> Message {
    if told.message.is::<said::CommentOpen>() {
        return said::CommentsOpen { more }.into();
    }
    let is_slashed = told.message.is::<said::TextAfterSlashes>();
    let text = short_quote(text, told.span);
    if is_slashed {
        said::TextsAfterSlashes { text, more }.into()
    } else {
        said::TextsAfterSemicolon { text, more }.into()
    }
}
