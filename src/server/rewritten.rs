//! The edits that lead from a text to its rewritten form.
//!
//! In: both texts. Out: edits of the first one.

use crate::message::Edit;
use crate::source::{LineIndex, Span, line_around};

/// Greatest number of changed lines that have an edit each.
const MAX_LINES: usize = 10_000;

/// The edits that change a text into another one: one for each changed line, if both have the same number of
/// lines and not too many are changed.
pub fn changed_lines(before: &[u8], after: &[u8]) -> Vec<Edit> {
    let (old, new) = (LineIndex::new(before), LineIndex::new(after));
    let lines = || (0..old.len()).map(|line| (old.line(before, line), new.line(after, line)));
    let changed = || lines().filter(|(old, new)| old.of(before) != new.of(after));
    match old.len() == new.len() && changed().nth(MAX_LINES).is_none() {
        true => changed().map(|(old, new)| Edit { span: old, text: new.quote(after) }).collect(),
        false => vec![changed_middle(before, after)],
    }
}

/// The edit of the lines between those that are the same at the begin and at the end.
pub fn changed_middle(before: &[u8], after: &[u8]) -> Edit {
    let same = before.iter().zip(after).take_while(|(old, new)| old == new).count();
    let start = line_around(before, same).start as usize;
    let rest = before[start..].iter().rev().zip(after[start..].iter().rev());
    let same = rest.take_while(|(old, new)| old == new).count();
    // Neither a character nor a line end is cut.
    let is_cut = |byte: &usize| {
        before.get(*byte).is_some_and(|byte| byte & 0xC0 == 0x80)
            || *byte > start && before[*byte - 1] == b'\r' && before.get(*byte) == Some(&b'\n')
    };
    let end = (before.len() - same..=before.len()).find(|byte| !is_cut(byte)).unwrap_or(before.len());
    let behind = before.len() - end;
    let text = String::from_utf8_lossy(&after[start..after.len() - behind]).into_owned();
    Edit { span: Span::new(start, end), text }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::message::applied;

    #[test]
    fn the_edits_lead_from_one_text_to_the_other() {
        for (before, after, edits) in [
            ("GO1\nX5\nZ–2\n", "G01\nX5\nZ-2\n", 2),
            ("G0 X1\nG1", "G0 X1\nG1\nM30", 1),
            ("a外\nb", "a外\nb", 0),
            ("a外\nb\nc", "a夕\nc", 1),
            ("外", "外\n外", 1),
            ("G90\r\nM30\r\n", "G00\r\nG01\r\nM30\r\n", 1),
            ("G90\r\nM30\r\n", "G00\nG01\nM30\r\n", 1),
            ("", "M30\n", 1),
        ] {
            let found = changed_lines(before.as_bytes(), after.as_bytes());
            assert_eq!(found.len(), edits, "{before:?}");
            assert_eq!(String::from_utf8_lossy(&applied(before.as_bytes(), &found)), after);
        }
    }
}
