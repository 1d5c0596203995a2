//! Whole blocks that are lost, duplicated, or swapped with the next one.
//!
//! In: a correct program. Out: programs with one such fault each. How much the rest of the program reveals
//! depends on the role of the block.

use crate::classes::{Mutant, Need, Place};
use crate::text::Words;

/// The role of a block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Role {
    /// A call of a cycle, or a block with its parameters.
    Cycle,
    /// A further pass of a modal single cycle.
    Pass,
    /// A rapid move.
    Rapid,
    /// A move at feed.
    Cut,
    /// A block without a move.
    Setting,
    /// A block that cannot be lost: an O number, the end, an empty block.
    Other,
}

const CYCLES: [f64; 10] = [70.0, 71.0, 72.0, 73.0, 74.0, 75.0, 76.0, 90.0, 92.0, 94.0];

/// The role of each block.
fn roles(words: &Words) -> Vec<Role> {
    let mut group_01 = 0.0;
    let role = |block: usize| {
        let has = |letters: &str| words.of_block(block).any(|word| letters.contains(word.address));
        let g = |code: f64| words.has_g(block, code);
        for word in words.of_block(block).filter(|word| word.address == 'G') {
            if [0.0, 1.0, 2.0, 3.0, 32.0, 34.0, 90.0, 92.0, 94.0].contains(&word.value) {
                group_01 = word.value;
            }
        }
        let ends =
            words.of_block(block).any(|word| word.address == 'M' && [2.0, 30.0, 99.0].contains(&word.value));
        if ends || words.of_block(block).next().is_none() || has("O") {
            Role::Other
        } else if CYCLES.iter().any(|&code| g(code)) {
            Role::Cycle
        } else if g(50.0) || g(28.0) || g(4.0) || !has("XZUW") {
            Role::Setting
        } else if group_01 >= 90.0 {
            Role::Pass
        } else if group_01 == 0.0 {
            Role::Rapid
        } else {
            Role::Cut
        }
    };
    (0..words.blocks.len()).map(role).collect()
}

/// Removes each block of a role; its line stays, empty.
fn lost(words: &Words, role: Role) -> Vec<Mutant> {
    let blocks = roles(words).into_iter().enumerate().filter(|own| own.1 == role);
    let mutants = blocks.map(|(block, _)| {
        let (start, end) = whole(words, block);
        let (text, ..) = words.replaced(start, end, "");
        Mutant { text, place: Place::Needed(start, Need::Cut) }
    });
    mutants.collect()
}

/// A block without its line end.
fn whole(words: &Words, block: usize) -> (usize, usize) {
    let (start, end) = words.blocks[block];
    (start, start + words.text[start..end].trim_end().len())
}

pub fn lost_cycle(words: &Words) -> Vec<Mutant> {
    lost(words, Role::Cycle)
}

pub fn lost_pass(words: &Words) -> Vec<Mutant> {
    lost(words, Role::Pass)
}

pub fn lost_rapid(words: &Words) -> Vec<Mutant> {
    lost(words, Role::Rapid)
}

pub fn lost_cut(words: &Words) -> Vec<Mutant> {
    lost(words, Role::Cut)
}

/// The first block that starts the spindle of a program. Without it, the next cut is made with the spindle
/// stopped.
fn start_of_spindle(words: &Words) -> Option<usize> {
    let starts = |word: &&crate::text::Word| word.address == 'M' && [3.0, 4.0, 13.0].contains(&word.value);
    let first = words.words.iter().find(starts)?.block;
    // With an axis word it is also a move.
    (roles(words)[first] == Role::Setting).then_some(first)
}

pub fn lost_spindle(words: &Words) -> Vec<Mutant> {
    let made = start_of_spindle(words).map(|block| {
        let (start, end) = whole(words, block);
        let (text, ..) = words.replaced(start, end, "");
        Mutant { text, place: Place::Needed(start, Need::Cut) }
    });
    made.into_iter().collect()
}

/// The spindle starts only after the first cut.
pub fn late_spindle(words: &Words) -> Vec<Mutant> {
    let Some(block) = start_of_spindle(words) else { return Vec::new() };
    let roles = roles(words);
    // Multiple repetitive cycles can have two blocks.
    let is_first =
        |cut: usize| roles.get(cut + 1) == Some(&Role::Cycle) && words.has_g(cut + 1, cycle(words, cut));
    let cuts = |&cut: &usize| match roles[cut] {
        Role::Cut => true,
        Role::Cycle => !is_first(cut),
        Role::Pass | Role::Rapid | Role::Setting | Role::Other => false,
    };
    let made = (block + 1..roles.len()).find(cuts).map(|cut| {
        let ((start, end), (_, last)) = (whole(words, block), whole(words, cut));
        let moved = format!("{}\n{}", &words.text[end..last], &words.text[start..end]);
        let (text, ..) = words.replaced(start, last, &moved);
        Mutant { text, place: Place::Needed(start, Need::Cut) }
    });
    made.into_iter().collect()
}

/// The code of the cycle that a block calls.
fn cycle(words: &Words, block: usize) -> f64 {
    CYCLES.into_iter().find(|&code| words.has_g(block, code)).unwrap_or_default()
}

/// Duplicates the second block of a grooving cycle, or its only one.
pub fn doubled_groove(words: &Words) -> Vec<Mutant> {
    doubled(words, |block, role| {
        role == Role::Cycle && words.has_g(block, 75.0) && words.find(block, 'X').is_some()
    })
}

pub fn lost_setting(words: &Words) -> Vec<Mutant> {
    lost(words, Role::Setting)
}

/// Duplicates a block; the message may be at either copy.
fn doubled(words: &Words, is_intended: impl Fn(usize, Role) -> bool) -> Vec<Mutant> {
    let blocks = roles(words).into_iter().enumerate().filter(|&(block, role)| is_intended(block, role));
    let mutants = blocks.map(|(block, _)| {
        let (start, end) = whole(words, block);
        let (text, _, second) = words.replaced(end, end, &format!("\n{}", &words.text[start..end]));
        Mutant { text, place: Place::At(start, second) }
    });
    mutants.collect()
}

pub fn doubled_cycle(words: &Words) -> Vec<Mutant> {
    doubled(words, |_, role| matches!(role, Role::Cycle | Role::Pass))
}

/// Repeating an absolute move changes nothing; an incremental one moves further.
pub fn doubled_increment(words: &Words) -> Vec<Mutant> {
    doubled(words, |block, role| {
        matches!(role, Role::Rapid | Role::Cut)
            && words.of_block(block).any(|word| matches!(word.address, 'U' | 'W'))
    })
}

/// Swaps two consecutive blocks.
fn swapped(words: &Words, is_intended: impl Fn(Role, Role) -> bool) -> Vec<Mutant> {
    let roles = roles(words);
    let pairs = (1..roles.len()).filter(|&block| is_intended(roles[block - 1], roles[block]));
    let mutants = pairs.filter_map(|block| {
        let ((start, middle), (next, end)) = (whole(words, block - 1), whole(words, block));
        if middle > next || words.text[start..middle] == words.text[next..end] {
            return None;
        }
        let (first, between, second) =
            (&words.text[start..middle], &words.text[middle..next], &words.text[next..end]);
        let (text, start, end) = words.replaced(start, end, &format!("{second}{between}{first}"));
        Some(Mutant { text, place: Place::At(start, end) })
    });
    mutants.collect()
}

pub fn swapped_cycles(words: &Words) -> Vec<Mutant> {
    swapped(words, |one, other| {
        let is_cycle = |role| matches!(role, Role::Cycle | Role::Pass);
        is_cycle(one) && is_cycle(other)
    })
}

pub fn swapped_moves(words: &Words) -> Vec<Mutant> {
    swapped(words, |one, other| {
        let is_move = |role| matches!(role, Role::Rapid | Role::Cut);
        is_move(one) && is_move(other)
    })
}

pub fn swapped_settings(words: &Words) -> Vec<Mutant> {
    swapped(words, |one, other| {
        let is_setting = |role| role == Role::Setting;
        let is_other = |role| role == Role::Other;
        is_setting(one) != is_setting(other) && !is_other(one) && !is_other(other)
    })
}

/// Repeats the blocks of G71, G72 or G73 after the contour.
pub fn roughed_twice(words: &Words) -> Vec<Mutant> {
    let mut made = Vec::new();
    for block in 1..words.blocks.len() {
        let Some(code) = [71.0, 72.0, 73.0].into_iter().find(|&code| words.has_g(block, code)) else {
            continue;
        };
        let (Some(_), Some(last)) = (words.find(block, 'P'), words.find(block, 'Q')) else { continue };
        let of_contour = words.words.iter().find(|word| word.address == 'N' && word.value == last.value);
        let Some(end) = of_contour.filter(|end| end.block > block) else { continue };
        let first = if words.has_g(block - 1, code) { block - 1 } else { block };
        let (from, to) = (words.blocks[first].0, whole(words, block).1);
        let (_, behind) = whole(words, end.block);
        let again = format!("\n{}", &words.text[from..to]);
        let (text, start, end) = words.replaced(behind, behind, &again);
        made.push(Mutant { text, place: Place::At(start + 1, end) });
    }
    made
}
