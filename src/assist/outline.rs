//! The outline of a text (programs, tools, operations, cycles, referenced blocks), and its folding ranges.
//!
//! In: the text, its G code list. Out: entries in text order, with their depth. Does not need a run.

use super::form::{cycle_block, g_of};
use super::names::{Name, Named, names, number_after};
use crate::control::codes::cycles::CycleBlock;
use crate::control::codes::{self, Function, G, GCode, MotionMode};
use crate::control::words::plain;
use crate::setup::dialect::CodeList;
use crate::setup::ignored::is_ignore_comment;
use crate::setup::notes::Notes;
use crate::source::{Span, line_end};
use crate::text::block::{Block, BlockKind};
use crate::text::parser::Parser;

/// Maximum number of bytes of the text that are read.
const MAX_BYTES: usize = 4 << 20;
/// Maximum number of entries.
const MAX_ENTRIES: usize = 3000;

/// Kind of an entry.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A program.
    Program,
    /// A tool change.
    Tool,
    /// A comment in a separate block: an operation, as named by the programmer.
    Operation,
    /// A block that a jump, a call or a cycle refers to.
    Sequence,
    /// A cycle.
    Cycle(Function),
}

/// An entry of the outline.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entry {
    /// Kind of the entry.
    pub kind: Kind,
    /// Nesting depth.
    pub depth: u8,
    /// Start of its block.
    pub at: u32,
    /// Span of its name: the word, the block, or the comment.
    pub name: Span,
    /// A comment with further information.
    pub comment: Option<Span>,
}

/// The outline of a text.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Outline {
    /// The entries, in text order.
    pub entries: Vec<Entry>,
    /// Folding ranges: from the end of a block to the end of the last block that belongs to it.
    pub folds: Vec<Span>,
    /// Whether the text is longer than the part that was read.
    pub is_cut: bool,
}

/// Creates the outline of a text.
pub fn outline(text: &[u8], codes: CodeList) -> Outline {
    let end = text.len().min(MAX_BYTES);
    let notes = Notes::read(&text[..end]).spans().collect();
    let mut outlining = Outlining { text, codes, notes, ..Outlining::default() };
    let mut parser = Parser::new(&text[..end]);
    let mut block = Block::default();
    while parser.next_block(&mut block) && outlining.entries.len() < MAX_ENTRIES {
        outlining.take(&block);
    }
    let is_cut = end < text.len() || outlining.entries.len() >= MAX_ENTRIES;
    outlining.finish(is_cut)
}

#[derive(Default)]
struct Outlining<'a> {
    text: &'a [u8],
    codes: CodeList,
    /// Comments that set up the program: they are not names.
    notes: Vec<Span>,
    entries: Vec<Entry>,
    /// Sequence numbers that are referred to, and entries of defined ones. An entry is dropped if nothing
    /// refers to it.
    named: Vec<u32>,
    sequences: Vec<(u32, Entry)>,
    /// The last comment in a separate block, until another block follows.
    comment: Option<Span>,
    /// Whether comments belong to the head of the program.
    is_head: bool,
    /// Blocks of the current program and tool.
    program: Option<Span>,
    tool: Option<Span>,
    station: Option<u32>,
    /// The last block that is not a comment.
    last: Option<Span>,
    /// Open loops: the number of the DO, and its block.
    loops: Vec<(u32, Span)>,
    /// The contour of the last cycle: the block of the cycle, and the last sequence number.
    contour: Option<(Span, u32)>,
    folds: Vec<Span>,
}

impl Outlining<'_> {
    fn take(&mut self, block: &Block) {
        let found = names(self.text, block, self.codes);
        self.named.extend(found.iter().filter(|named| !named.defines).filter_map(|named| match named.name {
            Name::Sequence(number) => Some(number),
            _ => None,
        }));
        if block.program.is_some() {
            self.close_program();
            (self.program, self.is_head) = (Some(block.span), true);
            let name = block.program.map_or(block.span, |(_, span)| span);
            self.add(Kind::Program, 0, block, name, self.comment_of(block));
        } else if block.is_empty() && block.sequence.is_none() && block.kind == BlockKind::Words {
            self.comment_alone(block);
            return;
        }
        let depth = u8::from(self.program.is_some());
        if let Some((station, name)) = self.station_of(block) {
            self.close_tool();
            let own = self.comment_of(block);
            let before = self.comment.filter(|_| own.is_none());
            // The comment before a tool is the name of the tool, not a separate operation.
            self.entries.retain(|entry| entry.kind != Kind::Operation || Some(entry.name) != before);
            (self.station, self.tool) = (Some(station), Some(block.span));
            self.add(Kind::Tool, depth, block, name, own.or(before));
        }
        let depth = depth + u8::from(self.tool.is_some());
        let cycle = self.cycle(block);
        if let Some(function) = cycle {
            self.add(Kind::Cycle(function), depth, block, block.words_span(), None);
        } else if let Some(number) = block.sequence {
            let (at, comment) = (block.span.start, self.comment_of(block));
            let end = block.comments.first().map_or(block.span.end, |comment| comment.start);
            let name = Span { end, ..block.span };
            self.sequences.push((number, Entry { kind: Kind::Sequence, depth, at, name, comment }));
        }
        self.fold(block, cycle.is_some(), &found);
        if block.program.is_none() {
            self.is_head = false;
        }
        self.comment = None;
        self.last = Some(block.span);
    }

    /// A comment in a separate block. Of several, the first names the operation; in a program head, the last.
    fn comment_alone(&mut self, block: &Block) {
        let Some(comment) = self.comment_of(block) else { return };
        if self.is_head {
            self.comment = Some(comment);
        } else if self.comment.is_none() {
            self.comment = Some(comment);
            let depth = u8::from(self.program.is_some()) + u8::from(self.tool.is_some());
            self.add(Kind::Operation, depth, block, comment, None);
        }
    }

    /// The comment that names a block.
    fn comment_of(&self, block: &Block) -> Option<Span> {
        // Both lists are in text order.
        let is_note = |comment: &Span| {
            let next = self.notes.partition_point(|note| note.start < comment.start);
            let is_setup = self.notes.get(next).is_some_and(|note| comment.contains(*note));
            let inside = comment.of(self.text);
            is_setup || is_ignore_comment(inside.strip_prefix(b"(").unwrap_or(inside))
        };
        block.comments.iter().find(|comment| !is_note(comment)).copied()
    }

    fn add(&mut self, kind: Kind, depth: u8, block: &Block, name: Span, comment: Option<Span>) {
        self.entries.push(Entry { kind, depth, at: block.span.start, name, comment });
    }

    /// The station of a new tool, and its word. Cancelling the offset or repeating the station does not
    /// count.
    fn station_of(&self, block: &Block) -> Option<(u32, Span)> {
        let word = block.words.iter().find(|word| word.address == b'T')?;
        let number = plain(word).filter(|number| *number >= 0.0)? as u32;
        let (station, offset) = if number > 99 { (number / 100, number % 100) } else { (number, 1) };
        let is_new = offset != 0 && station != 0 && self.station != Some(station);
        is_new.then_some((station, word.span))
    }

    /// The cycle that a block executes.
    fn cycle(&self, block: &Block) -> Option<Function> {
        block.words.iter().find_map(|word| match g_of(word, self.codes)? {
            code @ G::Multiple(cycle) if cycle_block(cycle, block) != CycleBlock::First => {
                codes::g_code_of(code).map(GCode::function)
            }
            code @ (G::Motion(MotionMode::Cycle(_)) | G::Hole(_)) => {
                codes::g_code_of(code).map(GCode::function)
            }
            _ => None,
        })
    }

    // ---- folding ranges ---------------------------------------------------------------------------------

    /// Adds folding ranges. `found`: the names in the block.
    fn fold(&mut self, block: &Block, is_cycle: bool, found: &[Named]) {
        let (text, codes) = (self.text, self.codes);
        if is_cycle {
            // The contour follows its cycle.
            let last = found.iter().rev().find_map(|named| match named.name {
                Name::Sequence(number) if !named.defines => Some(number),
                _ => None,
            });
            let roughs = block
                .words
                .iter()
                .any(|word| matches!(g_of(word, codes), Some(G::Multiple(cycle)) if cycle.is_roughing()));
            self.contour = last.filter(|_| roughs).map(|last| (block.span, last));
        } else if let Some((cycle, last)) = self.contour
            && block.sequence == Some(last)
        {
            self.close(cycle, Some(block.span));
            self.contour = None;
        }
        if block.kind == BlockKind::Macro {
            let span = block.words_span();
            let statement = span.of(text).to_ascii_uppercase();
            let number = |at: usize| Some(number_after(text, span.start as usize + at, b" \t")?.0);
            let of = |word: &[u8]| statement.windows(word.len()).rposition(|part| part == word);
            if statement.starts_with(b"END") {
                let open = number(3).and_then(|end| self.loops.iter().rposition(|&(own, _)| own == end));
                if let Some(open) = open {
                    self.close(self.loops[open].1, Some(block.span));
                    self.loops.truncate(open);
                }
            } else if let Some(number) = of(b"DO").and_then(|at| number(at + 2)) {
                self.loops.push((number, block.span));
            }
        }
    }

    /// Adds a folding range from one block to the end of another.
    fn close(&mut self, head: Span, last: Option<Span>) {
        let Some(last) = last.filter(|last| last.start > head.start) else { return };
        let is_more_than_a_line = line_end(self.text, head.end as usize) < last.end as usize;
        if is_more_than_a_line {
            self.folds.push(Span { start: head.end, end: last.end });
        }
    }

    fn close_tool(&mut self) {
        if let Some(tool) = self.tool.take() {
            self.close(tool, self.last);
        }
        self.station = None;
    }

    fn close_program(&mut self) {
        self.close_tool();
        if let Some(program) = self.program.take() {
            self.close(program, self.last);
        }
        self.loops.clear();
        self.contour = None;
    }

    fn finish(mut self, is_cut: bool) -> Outline {
        self.close_program();
        crate::order::by_key(&mut self.named, |number| *number);
        let named = &self.named;
        let wanted = self.sequences.into_iter().filter(|(number, _)| named.binary_search(number).is_ok());
        self.entries.extend(wanted.map(|(_, entry)| entry));
        crate::order::by_key(&mut self.entries, |entry| entry.at);
        crate::order::by_key(&mut self.folds, |fold| (fold.start, std::cmp::Reverse(fold.end)));
        Outline { entries: self.entries, folds: self.folds, is_cut }
    }
}
