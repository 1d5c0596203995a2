//! JUnit XML: each file is a suite of failing tests (its errors and warnings), or of one passing test.

use std::fmt::Write;

use super::{api, sentence};

pub(super) const BEGIN: &str =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"gcode-playground\">\n";
pub(super) const END: &str = "</testsuites>\n";

/// The suite of a program.
pub(super) fn suite(name: &str, rows: impl Iterator<Item = api::Diagnostic>) -> String {
    let failing: Vec<_> = rows.filter(|row| row.severity != "info").collect();
    let name = escaped(name);
    let (tests, failures) = (failing.len().max(1), failing.len());
    let mut text = format!("  <testsuite name=\"{name}\" tests=\"{tests}\" failures=\"{failures}\">\n");
    if failing.is_empty() {
        let _ = writeln!(text, "    <testcase classname=\"{name}\" name=\"check\"/>");
    }
    for row in &failing {
        let place = format!("{}:{}", row.line, row.column);
        let _ = writeln!(text, "    <testcase classname=\"{name}\" name=\"{} {place}\">", escaped(&row.slug));
        let _ = writeln!(
            text,
            "      <failure type=\"{}\" message=\"{}\">{name}:{place}: {}</failure>",
            escaped(&row.severity),
            escaped(&row.message),
            escaped(&sentence(row))
        );
        text += "    </testcase>\n";
    }
    text += "  </testsuite>\n";
    text
}

/// Escapes text for XML; characters that XML cannot represent become `?`.
fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            '\t' | '\n' | '\r' => escaped.push(' '),
            '\0'..='\u{1f}' | '\u{fffe}' | '\u{ffff}' => escaped.push('?'),
            _ => escaped.push(letter),
        }
    }
    escaped
}
