//! Writes a program in another G-code system.
//!
//! In: a program and its setup. Out: the edits of its codes and of the letters of its distances, or the places that
//! prevent the conversion. It is all or nothing: a program has one system. System A writes distances as U and W, systems
//! B and C write them as X and Z under G91. The motions stay the same in a run with the other system.

use std::collections::BTreeSet;

use super::{Conversion, EXACT, first_block, is_run, labels, runs, with_blank};
use crate::assist::form::{Form, g_of};
use crate::assist::role::Role;
use crate::control::codes::words::Axes;
use crate::control::codes::{G, g_code};
use crate::control::modal::State;
use crate::message::{Edit, applied};
use crate::rewrite::{first_other_motion, has_no_new_complaints};
use crate::run::{Analysis, analyze};
use crate::setup::Setup;
use crate::setup::dialect::{CodeList, Dialect, GSystem};
use crate::source::Span;
use crate::text::block::{Block, BlockKind, Value, Word};
use crate::text::parser::Parser;

/// Writes a program in a system. `own`: the length of the program itself, bytes.
pub(super) fn converted(text: &[u8], own: usize, setup: &Setup, to: GSystem) -> Conversion {
    let runs = runs(text, setup);
    let analysis = &runs[0].1;
    let dialect = Dialect::new(&analysis.setup.dialect);
    let [from, to_list] = [analysis.codes, CodeList::new(dialect.control, to)];
    if from == to_list || !is_run(analysis) {
        return Conversion::default();
    }
    let first_block = first_block(text);
    let refused = |place: Span| Conversion { edits: Vec::new(), left: vec![place] };
    let writer = Writer { text, from, to: to_list, labels: labels(text, from) };
    // Subprograms in other files would stay in the other system.
    let edits = if own < text.len() { Err(first_block) } else { writer.edits(State::new(setup, &dialect)) };
    let edits = match edits {
        Ok(edits) => edits,
        Err(place) => return refused(place),
    };
    let after = applied(text, &edits);
    let other = runs.iter().find_map(|(setup, before)| {
        let mut setup = setup.clone();
        setup.dialect.g_system = Some(to);
        let after = analyze(&after, &setup);
        first_other(before, &after, first_block).or_else(|| (after.codes != to_list).then_some(first_block))
    });
    match other {
        None => Conversion { edits, left: Vec::new() },
        Some(place) => refused(place),
    }
}

/// The block from which on the motions differ; the first one if only the messages differ, or `first_block` without
/// motions.
fn first_other(before: &Analysis, after: &Analysis, first_block: Span) -> Option<Span> {
    let motions = &before.motions;
    let place = |index: usize| if index < motions.len() { motions.span(index) } else { first_block };
    match first_other_motion(motions, &after.motions, EXACT) {
        Some(index) => Some(place(index)),
        None => (!has_no_new_complaints(before, after)).then(|| place(0)),
    }
}

struct Writer<'a> {
    text: &'a [u8],
    from: CodeList,
    to: CodeList,
    labels: BTreeSet<u32>,
}

impl Writer<'_> {
    /// All edits; the place of a word that the other system lacks as the error. `state`: at power-on.
    fn edits(&self, mut state: State) -> Result<Vec<Edit>, Span> {
        let (mut parser, mut block) = (Parser::new(self.text), Block::default());
        let mut edits = Vec::new();
        // G90 or G91 as last written; unknown where another block may come from.
        let mut written = None;
        while parser.next_block(&mut block) {
            let is_entry =
                block.program.is_some() || block.sequence.is_some_and(|number| self.labels.contains(&number));
            if is_entry {
                written = None;
            }
            // The statement after THEN may contain codes.
            if block.kind == BlockKind::Macro && has_then(block.span.of(self.text)) {
                return Err(block.span);
            }
            let form = Form::of(&block, &state, self.from);
            for word in &block.words {
                let Some(code) = g_of(word, self.from) else { continue };
                follow(&mut state, code);
                edits.extend(self.code(word, code)?);
            }
            edits.extend(self.axes(&block, form, &state, &mut written)?);
        }
        edits.sort_by_key(|edit| (edit.span.start, edit.span.end));
        // Two removed codes share the blank between them.
        let mut end = 0;
        for edit in &mut edits {
            edit.span.start = edit.span.start.max(end);
            end = edit.span.end.max(end);
        }
        Ok(edits)
    }

    /// The edit of a code.
    fn code(&self, word: &Word, code: G) -> Result<Option<Edit>, Span> {
        let Value::Number { number, .. } = word.value else { return Ok(None) };
        let row = number.tenths().and_then(|key| g_code(key, self.from)).ok_or(word.span)?;
        match (row.text(self.from), row.text(self.to)) {
            (from, Some(to)) if from.as_ref() != Some(&to) => Ok(Some(Edit { span: word.span, text: to })),
            (_, Some(_)) => Ok(None),
            // System A has no code for these.
            (_, None) if matches!(code, G::Distance { .. } | G::HoleReturn(_)) => {
                Ok(Some(Edit { span: self.with_one_blank(word.span), text: String::new() }))
            }
            (_, None) => Err(word.span),
        }
    }

    /// The letters of the coordinates and distances of a block, with G90 or G91 if it needs another one than `written`.
    fn axes(
        &self,
        block: &Block,
        form: Form,
        state: &State,
        written: &mut Option<bool>,
    ) -> Result<Vec<Edit>, Span> {
        let axes = Axes { surface: None, plane: state.plane, c_axis: state.c_axis };
        let [from_a, to_a] = [self.from, self.to].map(|list| matches!(list, CodeList::A | CodeList::Gsk));
        let mut edits = Vec::new();
        let (mut distances, mut coordinates) = (None, None);
        for word in block.words.iter().filter(|word| !word.comma && b"XZCYUWHV".contains(&word.address)) {
            let role = Role::of(word, form, false, axes);
            let letter = match (axis(role), role) {
                (Some((letter, is_distance)), _) => {
                    let place = if is_distance { &mut distances } else { &mut coordinates };
                    place.get_or_insert(word.span);
                    let is_distance = if from_a { is_distance } else { state.incremental };
                    if is_distance && to_a { letter[1] } else { letter[0] }
                }
                (None, Role::DwellSeconds) if !to_a => 'X',
                (None, Role::ShiftX | Role::ShiftZ) => return Err(word.span),
                _ => continue,
            };
            if letter != char::from(word.address) {
                let span = Span { start: word.span.start, end: word.span.start + 1 };
                edits.push(Edit { span, text: letter.to_string() });
            }
        }
        if from_a && !to_a {
            let is_incremental = match (distances, coordinates) {
                // A block has one of G90 and G91.
                (Some(place), Some(_)) => return Err(place),
                (Some(_), None) => true,
                (None, Some(_)) => false,
                (None, None) => return Ok(edits),
            };
            if *written != Some(is_incremental) {
                *written = Some(is_incremental);
                let start = block.words.first().map_or(block.span.start, |word| word.span.start);
                let code = if is_incremental { "G91 " } else { "G90 " };
                edits.push(Edit { span: Span { start, end: start }, text: code.to_owned() });
            }
        }
        Ok(edits)
    }

    /// A span with the blank before it, or else the one after it.
    fn with_one_blank(&self, span: Span) -> Span {
        let own = with_blank(self.text, span);
        let has_blank = own == span && self.text.get(span.end as usize) == Some(&b' ');
        Span { end: span.end + u32::from(has_blank), ..own }
    }
}

fn has_then(block: &[u8]) -> bool {
    block.windows(4).any(|word| word.eq_ignore_ascii_case(b"THEN"))
}

/// Applies the codes that decide what a word means.
fn follow(state: &mut State, code: G) {
    match code {
        G::Motion(mode) => {
            state.motion = mode;
            state.hole = None;
        }
        G::NoHole => state.hole = None,
        G::Plane(plane) => state.plane = plane,
        G::Distance { incremental } => state.incremental = incremental,
        _ => {}
    }
}

/// The letters of the coordinate and of the distance of an axis, and whether a role is the distance.
fn axis(role: Role) -> Option<([char; 2], bool)> {
    use Role::*;
    const X: [char; 2] = ['X', 'U'];
    const Z: [char; 2] = ['Z', 'W'];
    Some(match role {
        EndX | ViaX | CycleEndX | PeckEndX | ThreadEndX | HoleEndX | HolePlaceX => (X, false),
        EndZ | ViaZ | CycleEndZ | PeckEndZ | ThreadEndZ | HoleEndZ | HolePlaceZ => (Z, false),
        WayX | ViaWayX | CycleWayX | PeckWayX | ThreadWayX | HoleWayX => (X, true),
        WayZ | ViaWayZ | CycleWayZ | PeckWayZ | ThreadWayZ | HoleWayZ => (Z, true),
        EndC | ViaC => (['C', 'H'], false),
        WayC => (['C', 'H'], true),
        EndY => (['Y', 'V'], false),
        WayY => (['Y', 'V'], true),
        _ => return None,
    })
}
