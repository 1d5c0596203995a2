//! Pairs the blocks of two texts.
//!
//! In: the blocks of both texts. Out: an [`Alignment`]: ranges that differ, with their blocks paired, and
//! pairs of unchanged blocks. Uses the diff of `similar`, which falls back to a longer diff rather than take
//! long. Must not know motions.

use std::ops::Range;

use similar::{Algorithm, DiffOp, capture_diff_slices};

use super::written::{Keys, Written};
use crate::limits::CHANGED_BLOCKS;

/// Longer ranges (blocks of both sides together) are paired by position, and so are all ranges after this
/// total, because a longer list of changes is not read.
const MAX_PAIRED_BY_WORDS: usize = 120;
const MAX_PAIRED_AT_ALL: usize = 2 * CHANGED_BLOCKS;

/// A pair of blocks; one may be missing.
pub(super) type Pair = [Option<usize>; 2];

/// Neighbouring blocks that differ.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Stretch {
    /// The blocks in each text.
    pub blocks: [Range<usize>; 2],
    /// The same blocks in pairs, in order.
    pub pairs: Vec<Pair>,
}

/// The alignment of two texts.
pub(super) struct Alignment {
    /// The ranges that differ.
    pub stretches: Vec<Stretch>,
    /// Pairs of unchanged blocks, in order.
    pub partners: Vec<[usize; 2]>,
}

impl Alignment {
    /// Aligns two texts.
    pub(super) fn of([first, second]: [&Written; 2], keys: &Keys) -> Self {
        let mut found = Self { stretches: Vec::new(), partners: Vec::new() };
        for op in capture_diff_slices(Algorithm::Myers, &first.numbers, &second.numbers) {
            match op {
                DiffOp::Equal { old_index, new_index, len } => {
                    found.partners.extend((0..len).map(|index| [old_index + index, new_index + index]));
                }
                DiffOp::Delete { old_index, old_len, new_index } => {
                    found.differs([old_index..old_index + old_len, new_index..new_index]);
                }
                DiffOp::Insert { old_index, new_index, new_len } => {
                    found.differs([old_index..old_index, new_index..new_index + new_len]);
                }
                DiffOp::Replace { old_index, old_len, new_index, new_len } => {
                    found.differs([old_index..old_index + old_len, new_index..new_index + new_len]);
                }
            }
        }
        let mut left = MAX_PAIRED_AT_ALL;
        for stretch in &mut found.stretches {
            let [own, other] = &stretch.blocks;
            let most = MAX_PAIRED_BY_WORDS.min(left);
            let blocks = own.len() + other.len();
            stretch.pairs = match own.is_empty() || other.is_empty() || blocks > most {
                true => in_order(&stretch.blocks),
                false => by_words(stretch.blocks.clone(), [first, second], keys),
            };
            left = left.saturating_sub(blocks);
        }
        found
    }

    /// Adds a differing range; merges it with the last one if they are adjacent.
    fn differs(&mut self, blocks: [Range<usize>; 2]) {
        match self.stretches.last_mut() {
            Some(last) if [0, 1].iter().all(|&side| last.blocks[side].end == blocks[side].start) => {
                let [first, second] = blocks;
                (last.blocks[0].end, last.blocks[1].end) = (first.end, second.end);
            }
            _ => self.stretches.push(Stretch { blocks, pairs: Vec::new() }),
        }
    }
}

fn in_order([first, second]: &[Range<usize>; 2]) -> Vec<Pair> {
    let at = |range: &Range<usize>, index: usize| Some(range.start + index).filter(|&at| at < range.end);
    (0..first.len().max(second.len())).map(|index| [at(first, index), at(second, index)]).collect()
}

/// The pairing in order that has the most words in common.
fn by_words([first, second]: [Range<usize>; 2], texts: [&Written; 2], keys: &Keys) -> Vec<Pair> {
    let wide = second.len() + 1;
    // Table of dynamic programming: the best score for the rest of both ranges from a pair of blocks on.
    let mut best = vec![0; (first.len() + 1) * wide];
    let alike = |i: usize, j: usize| {
        similarity(keys, texts[0].numbers[first.start + i], texts[1].numbers[second.start + j])
    };
    for i in (0..first.len()).rev() {
        for j in (0..second.len()).rev() {
            let together = alike(i, j).map_or(0, |own| own + best[(i + 1) * wide + j + 1]);
            best[i * wide + j] = together.max(best[(i + 1) * wide + j]).max(best[i * wide + j + 1]);
        }
    }
    let (mut i, mut j, mut found) = (0, 0, Vec::new());
    while i < first.len() || j < second.len() {
        let left = [i < first.len(), j < second.len()];
        let rest = if left == [true, true] { best[i * wide + j] } else { 0 };
        let together = (left == [true, true]).then(|| alike(i, j)).flatten();
        let is_pair = together.is_some_and(|own| own + best[(i + 1) * wide + j + 1] == rest);
        let (takes_first, takes_second) = match left {
            [true, true] if is_pair => (true, true),
            [true, true] => {
                let drops_first = best[(i + 1) * wide + j] == rest;
                (drops_first, !drops_first)
            }
            [takes_first, takes_second] => (takes_first, takes_second),
        };
        found.push([takes_first.then_some(first.start + i), takes_second.then_some(second.start + j)]);
        (i, j) = (i + usize::from(takes_first), j + usize::from(takes_second));
    }
    found
}

/// Similarity of two blocks: an equal word scores more than an equal address; `None` if they have neither in
/// common.
fn similarity(keys: &Keys, first: u32, second: u32) -> Option<u32> {
    let (mut common, mut count) = (0, 0);
    for word in keys.words(first) {
        count += 1;
        let mut others = keys.words(second);
        if others.clone().any(|other| other == word) {
            common += 3;
        } else if others.any(|other| other.first() == word.first()) {
            common += 1;
        }
    }
    (common > 0).then_some(1 + 20 * common / count.max(keys.words(second).count() as u32))
}
