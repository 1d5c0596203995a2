//! Messages on the terminal, with carets under the word they are about, as rustc prints them.

use annotate_snippets::{AnnotationKind, Level, Patch, Renderer, Snippet};

use crate::message::{Diagnostic, Severity};
use crate::sentences::Language;
use crate::source::LineIndex;

/// The messages of a program as text, coloured where the terminal is; `lines` are those of the text.
pub fn render(
    name: &str,
    text: &[u8],
    lines: &LineIndex,
    diagnostics: &[Diagnostic],
    language: Language,
) -> String {
    let renderer = match std::io::IsTerminal::is_terminal(&std::io::stdout()) {
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
    let sentence = diagnostic.sentence(language);
    let level = match diagnostic.severity {
        Severity::Error => Level::ERROR,
        Severity::Warning => Level::WARNING,
        Severity::Info => Level::INFO,
        // Never reported.
        Severity::Off => Level::NOTE,
    };
    // Only the line of the fault is given to the renderer: programs can be long, and bytes that are not UTF-8
    // must not move the carets.
    let line = lines.line_of(diagnostic.span.start.min(text.len() as u32));
    let place = lines.line(text, line);
    let window = window(place.start as usize, place.end as usize, diagnostic.span.start as usize);
    let shown = printable(&text[window.clone()]);
    let start = (diagnostic.span.start as usize).clamp(window.start, window.end) - window.start;
    let end = (diagnostic.span.end as usize).clamp(window.start, window.end) - window.start;
    let range = boundary(&shown, start)..boundary(&shown, end.max(start));
    let snippet = Snippet::source(shown.as_str())
        .line_start(line as usize + 1)
        .path(name)
        .annotation(AnnotationKind::Primary.span(range));
    let code = diagnostic.code();
    let title = match diagnostic.message.alarm() {
        Some(alarm) if alarm != code => format!("{} ({alarm})", sentence.message),
        _ => sentence.message,
    };
    let mut group = level.primary_title(title.as_str()).id(code.as_str()).element(snippet);
    if let Some(help) = &sentence.help {
        group = group.element(Level::HELP.message(help.as_str()));
    }
    let mut report = vec![group];
    let fix_titles: Vec<String> = diagnostic.fixes.iter().map(|fix| fix.title.words(language)).collect();
    for (fix, title) in diagnostic.fixes.iter().zip(&fix_titles) {
        let inside = |at: u32| boundary(&shown, (at as usize).clamp(window.start, window.end) - window.start);
        let patches = fix
            .edits
            .iter()
            .map(|edit| Patch::new(inside(edit.span.start)..inside(edit.span.end), edit.text.as_str()));
        let snippet =
            Snippet::source(shown.as_str()).line_start(line as usize + 1).path(name).patches(patches);
        report.push(Level::HELP.secondary_title(title.as_str()).element(snippet));
    }
    renderer.render(&report)
}

/// The part of a line to show around a fault.
fn window(start: usize, end: usize, at: usize) -> std::ops::Range<usize> {
    const AROUND: usize = 200;
    if end - start <= 2 * AROUND {
        return start..end;
    }
    at.saturating_sub(AROUND).max(start)..(at + AROUND).min(end)
}

/// The bytes as text of the same length: what is not UTF-8 or not printable becomes `?`.
fn printable(bytes: &[u8]) -> String {
    let mut text = String::with_capacity(bytes.len());
    for chunk in bytes.utf8_chunks() {
        text.extend(
            chunk.valid().chars().map(|ch| if ch.is_ascii_control() && ch != '\t' { '?' } else { ch }),
        );
        text.extend(chunk.invalid().iter().map(|_| '?'));
    }
    text
}

fn boundary(text: &str, mut at: usize) -> usize {
    at = at.min(text.len());
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}
