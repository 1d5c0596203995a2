//! Formats messages for the terminal, with carets under the source text as in rustc; and masks control
//! characters in all output.

use std::io::{self, Write};

use annotate_snippets::{AnnotationKind, Group, Level, Patch, Renderer, Snippet};

use crate::message::{Diagnostic, Edit, Severity};
use crate::sentences::Language;
use crate::source::{LineIndex, Span, is_unprintable};

/// Formats the messages of a program as text; `lines` is the line index of its text.
pub fn render(
    name: &str,
    text: &[u8],
    lines: &LineIndex,
    diagnostics: &[Diagnostic],
    language: Language,
    is_coloured: bool,
) -> String {
    let renderer = match is_coloured {
        true => Renderer::styled(),
        false => Renderer::plain(),
    };
    let mut out = String::new();
    for diagnostic in diagnostics {
        out.push_str(&render_one(name, text, lines, diagnostic, language, &renderer));
        out.push_str("\n\n");
    }
    out
}

fn render_one(
    name: &str,
    text: &[u8],
    lines: &LineIndex,
    diagnostic: &Diagnostic,
    language: Language,
    renderer: &Renderer,
) -> String {
    let (name, sentence) = (masked(name), diagnostic.sentence(language));
    let level = match diagnostic.severity {
        Severity::Error => Level::ERROR,
        Severity::Warning => Level::WARNING,
        Severity::Info => Level::INFO,
        // Never reported.
        Severity::Off => Level::NOTE,
    };
    // Only the line of the fault is passed to the renderer: programs can be long, and bytes that are not
    // UTF-8 must not shift the carets.
    let line = lines.line_of(diagnostic.span.start.min(text.len() as u32));
    let place = lines.line(text, line);
    let window = window(place.start as usize, place.end as usize, diagnostic.span.start as usize);
    let shown = printable(&text[window.clone()]);
    let start = (diagnostic.span.start as usize).clamp(window.start, window.end) - window.start;
    let end = (diagnostic.span.end as usize).clamp(window.start, window.end) - window.start;
    let range = boundary(&shown, start)..boundary(&shown, end.max(start));
    let snippet = Snippet::source(shown.as_str())
        .line_start(line as usize + 1)
        .path(name.as_str())
        .annotation(AnnotationKind::Primary.span(range));
    let code = diagnostic.code();
    let title = match diagnostic.message.alarm() {
        Some(alarm) if alarm != code => format!("{} ({alarm})", sentence.message),
        _ => sentence.message,
    };
    let (title, help) = (masked(&title), sentence.help.as_deref().map(masked));
    let mut group = level.primary_title(title.as_str()).id(code.as_str()).element(snippet);
    if let Some(help) = &help {
        group = group.element(Level::HELP.message(help.as_str()));
    }
    let mut report = vec![group];
    let fix_titles: Vec<String> =
        diagnostic.fixes.iter().map(|fix| masked(&fix.title.words(language))).collect();
    let shown_lines: Vec<_> =
        diagnostic.fixes.iter().map(|fix| lines_of_edits(text, lines, &fix.edits, line)).collect();
    for ((fix, title), edited) in diagnostic.fixes.iter().zip(&fix_titles).zip(&shown_lines) {
        let mut group = Group::with_title(Level::HELP.secondary_title(title.as_str()));
        for shown in edited {
            let own = fix.edits.iter().filter(|edit| shown.holds(edit));
            let patches = own.map(|edit| Patch::new(shown.inside(edit.span), masked(&edit.text)));
            let snippet =
                Snippet::source(shown.text.as_str()).line_start(shown.line as usize + 1).path(name.as_str());
            group = group.element(snippet.patches(patches));
        }
        report.push(group);
    }
    renderer.render(&report)
}

/// A line after edits, for display.
struct EditedLine {
    line: u32,
    /// The displayed byte range of the text.
    window: std::ops::Range<usize>,
    /// End of the line, including its line end.
    end: usize,
    text: String,
}

impl EditedLine {
    fn holds(&self, edit: &Edit) -> bool {
        let from = edit.span.start as usize;
        self.window.start <= from && (from < self.end || from <= self.window.end)
    }

    /// Converts a span of the text to a range of the displayed text.
    fn inside(&self, span: Span) -> std::ops::Range<usize> {
        let place = |at: u32| {
            let at = (at as usize).clamp(self.window.start, self.window.end) - self.window.start;
            boundary(&self.text, at)
        };
        place(span.start)..place(span.end)
    }
}

/// The lines with edits, in order; line `first` if there are none.
fn lines_of_edits(text: &[u8], lines: &LineIndex, edits: &[Edit], first: u32) -> Vec<EditedLine> {
    let mut numbers: Vec<(u32, usize)> = Vec::new();
    for edit in edits {
        let line = lines.line_of(edit.span.start.min(text.len() as u32));
        if numbers.iter().all(|(own, _)| *own != line) {
            numbers.push((line, edit.span.start as usize));
        }
    }
    if numbers.is_empty() {
        numbers.push((first, lines.line(text, first).start as usize));
    }
    let shown = |(line, at): (u32, usize)| {
        let place = lines.line(text, line);
        let window = window(place.start as usize, place.end as usize, at);
        let next =
            if line + 1 < lines.len() { lines.line(text, line + 1).start as usize } else { text.len() };
        EditedLine { line, text: printable(&text[window.clone()]), window, end: next }
    };
    numbers.into_iter().map(shown).collect()
}

/// The part of a line to show around a fault.
fn window(start: usize, end: usize, at: usize) -> std::ops::Range<usize> {
    const AROUND: usize = 200;
    if end - start <= 2 * AROUND {
        return start..end;
    }
    at.saturating_sub(AROUND).max(start)..(at + AROUND).min(end)
}

/// The bytes as text of the same length; bytes that are not UTF-8 or not printable become `?`.
fn printable(bytes: &[u8]) -> String {
    let mut text = String::with_capacity(bytes.len());
    for chunk in bytes.utf8_chunks() {
        for letter in chunk.valid().chars() {
            match is_unprintable(letter) || letter == '\n' {
                true => text.extend(std::iter::repeat_n('?', letter.len_utf8())),
                false => text.push(letter),
            }
        }
        text.extend(chunk.invalid().iter().map(|_| '?'));
    }
    text
}

/// A file name without control characters that a terminal would interpret.
pub fn printable_name(file: &std::path::Path) -> String {
    let name = file.display().to_string();
    let is_shown = |letter: char| !is_unprintable(letter) && !matches!(letter, '\n' | '\t');
    name.chars().map(|letter| if is_shown(letter) { letter } else { '?' }).collect()
}

/// A text with `?` in place of unprintable characters.
pub fn masked(text: &str) -> String {
    text.chars().map(|letter| if is_unprintable(letter) { '?' } else { letter }).collect()
}

/// A value as one line of JSON, with unprintable characters escaped.
pub fn json(value: &impl serde::Serialize) -> io::Result<String> {
    let text = serde_json::to_string(value)?;
    if !text.contains(is_unprintable) {
        return Ok(text);
    }
    let escaped = text.chars().map(|letter| match is_unprintable(letter) {
        true => format!("\\u{:04x}", u32::from(letter)),
        false => letter.to_string(),
    });
    Ok(escaped.collect())
}

/// Writes text [without commands](without_commands). Each write must end at a character boundary.
pub struct Masked<W>(pub W);

impl<W: Write> Write for Masked<W> {
    fn write(&mut self, text: &[u8]) -> io::Result<usize> {
        // Fast path: most output is printable ASCII.
        match text.iter().all(|byte| matches!(byte, b'\n' | b'\t' | b' '..=b'~')) {
            true => self.0.write_all(text)?,
            false => self.0.write_all(&without_commands(text))?,
        }
        Ok(text.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        self.0.flush()
    }
}

/// A text without terminal control sequences: control characters become `?`, and line ends become LF. Bytes
/// that are not UTF-8 are kept: they are text in another encoding.
pub fn without_commands(text: &[u8]) -> Vec<u8> {
    let mut shown = Vec::with_capacity(text.len());
    for chunk in text.utf8_chunks() {
        let lines = chunk.valid().replace("\r\n", "\n").replace('\r', "\n");
        shown.extend(masked(&lines).as_bytes());
        shown.extend(chunk.invalid());
    }
    shown
}

fn boundary(text: &str, mut at: usize) -> usize {
    at = at.min(text.len());
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

#[cfg(test)]
mod tests {
    use super::without_commands;

    #[test]
    fn a_terminal_gets_no_commands() {
        let program = "O1 (a\x1b]0;x\x07 \u{9b}31m 外圆)\r\n\tG0\n".as_bytes();
        assert_eq!(without_commands(program), "O1 (a?]0;x? ?31m 外圆)\n\tG0\n".as_bytes());
        assert_eq!(without_commands("X1\rX\u{202e}2\u{2069}\x7f".as_bytes()), b"X1\nX?2??");
        // In a file with another encoding, too.
        assert_eq!(without_commands(b"(\xcd\xe2\x1b)"), b"(\xcd\xe2?)");
    }
}
