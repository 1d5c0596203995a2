//! Combines messages about a repeated habit into one message per program.
//!
//! In: the messages of a run, sorted by place. Out: the same messages, with one for all unclosed comments and
//! one for all remarks without brackets: at the first occurrence, with the number of the others and all
//! fixes.

use crate::message::{Diagnostic, Message, Repair, said};
use crate::text::parser::short_quote;

/// Combines the messages about each habit. Keeps errors without a safe fix separate, because a word may be
/// lost there.
pub(super) fn combine_repeated(messages: &mut Vec<Diagnostic>, text: &[u8]) {
    let all = std::mem::take(messages);
    // The index of each first message, and the number of further ones.
    let mut habits: Vec<(usize, usize)> = Vec::new();
    for reported in all {
        let is_open = reported.is_error() && !reported.fixes.iter().any(|fix| fix.safe);
        if is_open || !is_habit(&reported.message) {
            messages.push(reported);
            continue;
        }
        let like = |first: &Diagnostic| {
            first.message.name() == reported.message.name() && first.severity == reported.severity
        };
        let Some(habit) = habits.iter().position(|&(first, _)| like(&messages[first])) else {
            habits.push((messages.len(), 0));
            messages.push(reported);
            continue;
        };
        habits[habit].1 += 1;
        let fixes = &mut messages[habits[habit].0].fixes;
        for fix in reported.fixes {
            match fixes.iter_mut().find(|own| own.safe == fix.safe) {
                Some(own) => own.edits.extend(fix.edits),
                None => fixes.push(fix),
            }
        }
    }
    for (first, more) in habits.into_iter().filter(|(_, more)| *more > 0) {
        let first = &mut messages[first];
        first.message = with_count(first, more, text);
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
fn with_count(reported: &Diagnostic, more: usize, text: &[u8]) -> Message {
    if reported.message.is::<said::CommentOpen>() {
        return said::CommentsOpen { more }.into();
    }
    let is_slashed = reported.message.is::<said::TextAfterSlashes>();
    let text = short_quote(text, reported.span);
    if is_slashed {
        said::TextsAfterSlashes { text, more }.into()
    } else {
        said::TextsAfterSemicolon { text, more }.into()
    }
}
