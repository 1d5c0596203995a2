//! Two versions of a text as a unified diff, the format of `diff -u` that `patch` reads.
//!
//! In: a name, two texts. Out: the diff; empty if the texts are equal. Lines keep CR before LF.

use std::ops::Range;

use similar::{Algorithm, DiffOp, DiffTag, capture_diff_slices, group_diff_ops};

use crate::source::only_line_end;

/// Number of unchanged lines around a change.
const CONTEXT: usize = 3;

/// The unified diff of a text and its new version.
pub(super) fn unified(name: &str, [before, after]: [&str; 2]) -> String {
    if before == after {
        return String::new();
    }
    let lines = [before, after].map(lines);
    let changes = capture_diff_slices(Algorithm::Myers, &lines[0], &lines[1]);
    let hunks = group_diff_ops(changes, CONTEXT);
    let hunks = hunks.iter().map(|hunk| shown(hunk, &lines));
    hunks.fold(format!("--- {name}\n+++ {name}\n"), |diff, hunk| diff + &hunk)
}

/// The lines of a text with their line ends.
fn lines(text: &str) -> Vec<&str> {
    let end = if only_line_end(text.as_bytes()) == "\r" { '\r' } else { '\n' };
    text.split_inclusive(end).collect()
}

/// A hunk with its header.
fn shown(hunk: &[DiffOp], lines: &[Vec<&str>; 2]) -> String {
    let (Some(first), Some(last)) = (hunk.first(), hunk.last()) else { return String::new() };
    let before = first.old_range().start..last.old_range().end;
    let after = first.new_range().start..last.new_range().end;
    let mut text = format!("@@ -{} +{} @@\n", place(before), place(after));
    for change in hunk {
        let (tag, [old, new]) = (change.tag(), [change.old_range(), change.new_range()]);
        let (removed, added) = match tag {
            DiffTag::Equal => (' ', None),
            DiffTag::Delete | DiffTag::Insert | DiffTag::Replace => ('-', Some('+')),
        };
        lines[0][old].iter().for_each(|line| put(&mut text, removed, line));
        if let Some(sign) = added {
            lines[1][new].iter().for_each(|line| put(&mut text, sign, line));
        }
    }
    text
}

/// First line, from 1, and number of lines. An empty range is after its line.
fn place(lines: Range<usize>) -> String {
    let first = lines.start + usize::from(!lines.is_empty());
    format!("{first},{}", lines.len())
}

/// Adds a line with its sign.
fn put(text: &mut String, sign: char, line: &str) {
    text.push(sign);
    text.push_str(line.strip_suffix('\n').or(line.strip_suffix('\r')).unwrap_or(line));
    text.push('\n');
    if !line.ends_with(['\n', '\r']) {
        text.push_str("\\ No newline at end of file\n");
    }
}

#[cfg(test)]
mod tests {
    use super::unified;

    #[test]
    fn equal_texts_have_no_difference() {
        assert_eq!(unified("a.nc", ["G0\n", "G0\n"]), "");
        assert_eq!(unified("a.nc", ["", ""]), "");
    }

    #[test]
    fn changes_are_shown_with_three_lines_around_them() {
        let before = "1\n2\n3\n4\n5\n6\n7\n8\n9\n10\n11\n12\n13\n";
        let after = before.replace("\n2\n", "\ntwo\n").replace("\n12\n", "\n12\nM30\n");
        let expected = "--- a.nc\n+++ a.nc\n@@ -1,5 +1,5 @@\n 1\n-2\n+two\n 3\n 4\n 5\n\
                        @@ -10,4 +10,5 @@\n 10\n 11\n 12\n+M30\n 13\n";
        assert_eq!(unified("a.nc", [before, &after]), expected);
    }

    #[test]
    fn line_ends_are_kept() {
        let expected = "--- a\n+++ a\n@@ -1,2 +1,2 @@\n-GO\r\n+G0\r\n M30\r\n";
        assert_eq!(unified("a", ["GO\r\nM30\r\n", "G0\r\nM30\r\n"]), expected);
        let expected = "--- a\n+++ a\n@@ -1,1 +1,2 @@\n-G0\n\\ No newline at end of file\n+G0\n+M30\n\
                        \\ No newline at end of file\n";
        assert_eq!(unified("a", ["G0", "G0\nM30"]), expected);
        let expected = "--- a\n+++ a\n@@ -1,2 +1,2 @@\n-GO\n+G0\n M30\n";
        assert_eq!(unified("a", ["GO\rM30\r", "G0\rM30\r"]), expected);
        assert_eq!(unified("a", ["", "M30\n"]), "--- a\n+++ a\n@@ -0,0 +1,1 @@\n+M30\n");
    }
}
