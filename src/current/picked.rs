//! The selection at the cursor: the strokes of its block, and the named points of its cycle.
//!
//! In: a run and an offset in its text. Out: ranges of motions, and marks.

use std::ops::Range;

use crate::order;
use crate::run::Run;
use crate::scene::Scene;
use crate::scene::view::Mark;
use crate::source::{LineIndex, Span};

/// The motions of the block at a UTF-16 offset, and the points of its cycle.
pub(super) fn at(run: &Run, lines: &LineIndex, scene: &Scene, offset: u32) -> (Vec<Range<usize>>, Vec<Mark>) {
    let block = block(run, lines, offset);
    let motions = scene.motions_of(block);
    let marks = marks(run, block, motions.first());
    (motions, marks)
}

/// The motions of lines, from 0; lines beyond the text have none.
pub(super) fn of_lines(
    run: &Run,
    lines: &LineIndex,
    scene: &Scene,
    marked: &[Range<u32>],
) -> Vec<Range<usize>> {
    let text = run.text();
    let span = |range: &Range<u32>| {
        let end = range.end.min(lines.len());
        (range.start < end).then(|| lines.line(text, range.start).to(lines.line(text, end - 1)))
    };
    let mut found: Vec<Range<usize>> =
        marked.iter().filter_map(span).flat_map(|block| scene.motions_of(block)).collect();
    order::by_key(&mut found, |range| range.start);
    let mut joined: Vec<Range<usize>> = Vec::new();
    for range in found {
        match joined.last_mut() {
            Some(last) if range.start <= last.end => last.end = last.end.max(range.end),
            _ => joined.push(range),
        }
    }
    joined
}

/// The first motion of the block at a UTF-16 offset, or of the next one in the text that has any.
pub(super) fn first_motion(run: &Run, lines: &LineIndex, scene: &Scene, offset: u32) -> Option<usize> {
    let block = block(run, lines, offset);
    let own = scene.motions_of(block).first().map(|range| range.start);
    let motions = run.motions();
    own.or_else(|| {
        (0..motions.len())
            .filter(|&motion| motions.span(motion).start >= block.end)
            .min_by_key(|&motion| motions.span(motion).start)
    })
}

fn block(run: &Run, lines: &LineIndex, offset: u32) -> Span {
    let text = run.text();
    let byte = lines.byte_at_utf16(text, offset);
    let line = lines.line(text, lines.line_of(byte.min(text.len() as u32)));
    block_at(text, line, byte)
}

/// The points of a cycle that is called in a block: A, and A′ and B of its contour.
fn marks(run: &Run, block: Span, motions: Option<&Range<usize>>) -> Vec<Mark> {
    let inside = |span: Span| block.start <= span.start && span.end <= block.end;
    if let Some(found) = run.landmarks().iter().find(|landmarks| inside(landmarks.span)) {
        let names = [(found.start, "A"), (found.first, "A′"), (found.last, "B")];
        return names.into_iter().map(|(at, name)| Mark { at: at.moved(found.zero), name }).collect();
    }
    let first = motions
        .map(|range| run.motions().get_on_workpiece(range.start))
        .filter(|motion| motion.cycle.is_some());
    first.map(|motion| Mark { at: motion.from, name: "A" }).into_iter().collect()
}

/// The part of a line between the semicolons around a byte.
fn block_at(text: &[u8], line: Span, byte: u32) -> Span {
    let bytes = line.of(text);
    let at = (byte - line.start) as usize;
    let start = bytes[..at].iter().rposition(|&byte| byte == b';').map_or(0, |found| found + 1);
    let end = bytes[at..].iter().position(|&byte| byte == b';').map_or(bytes.len(), |found| at + found);
    // After the last semicolon there is often only the cursor; the block before it is then meant.
    if bytes[start..end].trim_ascii().is_empty() && start > 0 {
        return block_at(text, line, line.start + start as u32 - 1);
    }
    Span::new(line.start as usize + start, line.start as usize + end)
}
