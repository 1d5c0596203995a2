//! Groups blocks into programs, and finds the name of each program.
//!
//! In: blocks. Out: lists of blocks. A program number begins a program and M30 ends it. Blocks without either
//! are a program if there are enough of them close together; a code mentioned in a sentence is not.

use super::Name;
use super::blocks::{Block, Blocks, NO_BLOCK};
use super::items::{Item, Kind, slice};
use crate::order;

/// Maximum length of the text between two blocks of a program with a number, in bytes and in lines.
const LONGEST_GAP: usize = 240;
const MAX_LINES: usize = 3;
/// The same for a program without a number.
const LONGEST_FRAGMENT_GAP: usize = 40;
const MAX_FRAGMENT_LINES: usize = 2;
/// Minimum number of moves in a program without a number; and if there are sentences between all blocks.
const MIN_MOVES: usize = 2;
const MIN_SCATTERED: usize = 4;
/// Maximum length of a title, characters.
const TITLE: usize = 60;

/// The blocks of a program, in order.
#[derive(Clone, Debug, Default)]
pub(super) struct Stretch {
    /// Indices of its blocks.
    pub blocks: Vec<u32>,
    head: Option<u32>,
    /// Whether the number is in the title of a table; it is repeated if the table continues.
    table: bool,
    moves: usize,
    words: usize,
    ended: bool,
    last_sequence: f64,
    /// Positions of text between blocks, as the number of preceding blocks.
    seams: Vec<usize>,
}

impl Stretch {
    fn is_table_of(&self, head: u32) -> bool {
        self.table && !self.ended && self.head == Some(head)
    }
}

/// Groups blocks into programs. Blocks outside of programs lose their items.
pub(super) fn join(items: &[Item], blocks: &mut Blocks) -> Vec<Stretch> {
    let mut found = Vec::new();
    let mut now = Stretch::default();
    // A table whose program has not ended, and the number of programs found before its first gap.
    let mut table: Option<(Stretch, usize)> = None;
    // Lines and bytes that sentences mentioning a code add to the next gap.
    let mut passed = (0, 0);
    for (number, block) in blocks.list.iter().enumerate() {
        if block.mention {
            passed.0 += block.gap.lines + usize::from(!block.gap.same_line);
            passed.1 += block.gap.text() + bytes(items, block);
            continue;
        }
        let mut gap = block.gap;
        gap.lines += passed.0;
        gap.beyond += passed.1;
        let was_passed = std::mem::take(&mut passed) != (0, 0);
        let close = gap.is_close() && !was_passed;
        if let Some(head) = block.head {
            if block.table_head && now.is_table_of(head) {
                continue;
            }
            if block.table_head
                && let Some((before, programs)) = table.take_if(|(table, _)| table.is_table_of(head))
            {
                finish(std::mem::take(&mut now), blocks, &mut found);
                if found.len() == programs {
                    now = before;
                    continue;
                }
                // There is another program between the two parts, so the table ends before it.
                finish(before, blocks, &mut found);
            }
            let leading = now.blocks.len() <= 20 && now.words == 0 && now.head.is_none() && close;
            if !leading {
                finish(std::mem::take(&mut now), blocks, &mut found);
            }
            now.head = Some(head);
            now.table = block.table_head;
        } else if !now.blocks.is_empty() && !belongs(&now, block, gap, close) {
            let before = std::mem::take(&mut now);
            if before.table && !before.ended {
                table.take().into_iter().for_each(|(older, _)| finish(older, blocks, &mut found));
                table = Some((before, found.len()));
            } else {
                finish(before, blocks, &mut found);
            }
        }
        if !close && !now.blocks.is_empty() {
            now.seams.push(now.blocks.len());
        }
        now.blocks.push(number as u32);
        now.words += block.words;
        now.moves += usize::from(block.moves);
        now.ended |= block.ends_program;
        now.last_sequence = block.sequence.unwrap_or(now.last_sequence);
    }
    finish(now, blocks, &mut found);
    table.into_iter().for_each(|(older, _)| finish(older, blocks, &mut found));
    order::by_key(&mut found, |stretch| stretch.blocks.first().copied());
    release(blocks, &found);
    found
}

fn bytes(items: &[Item], block: &Block) -> usize {
    (items[block.end - 1].span.end - items[block.first].span.start) as usize
}

/// Whether a block without a program number continues the current program.
fn belongs(now: &Stretch, block: &Block, gap: super::blocks::Gap, close: bool) -> bool {
    let restarts = block.sequence.is_some_and(|number| number <= now.last_sequence);
    if gap.percent {
        return false;
    }
    if now.ended {
        // After M30 there may be subprograms, but never a smaller sequence number.
        let remark = block.words == 0;
        return close
            && (remark
                || block.sequence.is_some_and(|number| number > now.last_sequence)
                || now.blocks.is_empty());
    }
    if close {
        return true;
    }
    if gap.ellipsis || (restarts && !gap.same_line) {
        return false;
    }
    match now.head {
        Some(_) => {
            gap.lines <= MAX_LINES
                && gap.text() <= LONGEST_GAP
                && (gap.before == 0 || gap.same_line || block.words > 1)
        }
        None if gap.same_line => gap.text() <= LONGEST_FRAGMENT_GAP,
        None => gap.before == 0 && gap.lines <= MAX_FRAGMENT_LINES && gap.beyond <= LONGEST_FRAGMENT_GAP,
    }
}

/// Adds the programs in a list of blocks to `found`.
fn finish(stretch: Stretch, blocks: &Blocks, found: &mut Vec<Stretch>) {
    let list = &blocks.list;
    if stretch.head.is_some() {
        let bodies = stretch.blocks.iter().filter(|&&at| list[at as usize].words > 0).count();
        if stretch.moves > 0 || bodies >= 2 {
            found.push(stretch);
        }
        return;
    }
    let scattered = stretch.seams.iter().any(|&at| list[stretch.blocks[at] as usize].gap.same_line);
    if !scattered || stretch.moves >= MIN_SCATTERED {
        return keep(stretch.blocks, list, found);
    }
    let mut from = 0;
    for &seam in stretch.seams.iter().chain([&stretch.blocks.len()]) {
        keep(stretch.blocks[from..seam].to_vec(), list, found);
        from = seam;
    }
}

/// Adds blocks without a program number if they contain enough moves.
fn keep(numbers: Vec<u32>, list: &[Block], found: &mut Vec<Stretch>) {
    let moves = numbers.iter().filter(|&&at| list[at as usize].moves).count();
    if moves >= MIN_MOVES {
        found.push(Stretch { blocks: numbers, moves, ..Stretch::default() });
    }
}

/// Clears the owner of items whose blocks belong to no program.
fn release(blocks: &mut Blocks, found: &[Stretch]) {
    let mut used = vec![false; blocks.list.len()];
    for stretch in found {
        for &at in &stretch.blocks {
            used[at as usize] = true;
        }
    }
    for owner in &mut blocks.owner {
        if *owner != NO_BLOCK && !used[*owner as usize] {
            *owner = NO_BLOCK;
        }
    }
}

/// The name of a program: its number, or the title before it.
pub(super) fn name(text: &str, items: &[Item], blocks: &Blocks, stretch: &Stretch, line: u32) -> Name {
    if let Some(number) = stretch.head {
        return Name::Number(number);
    }
    let first = stretch.blocks.first().map_or(0, |&at| blocks.list[at as usize].first);
    // The last text line before it, unless another program is between.
    let mut end = None;
    let mut start = 0;
    for item in items[..first].iter().rev().take(400) {
        match item.kind {
            Kind::LineEnd if end.is_some() => break,
            Kind::Word(_) if end.is_none() => break,
            Kind::Prose => {
                end.get_or_insert(item.span.end);
                start = item.span.start;
            }
            Kind::Comment if end.is_none() => {
                end = Some(item.span.end);
                start = item.span.start;
            }
            Kind::Noise | Kind::Letter | Kind::LineEnd => {}
            _ if end.is_some() => start = item.span.start,
            _ => {}
        }
    }
    let Some(end) = end else { return Name::Line(line) };
    let title = slice(text, crate::source::Span { start, end });
    let title =
        title.trim_matches(|c: char| c.is_whitespace() || matches!(c, ':' | '：' | '#' | '*' | '.' | '。'));
    if title.chars().filter(|c| c.is_alphabetic()).count() < 2 {
        return Name::Line(line);
    }
    // A whole sentence is not a title.
    if title.chars().count() > TITLE { Name::Line(line) } else { Name::Title(title.to_string()) }
}
