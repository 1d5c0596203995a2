//! Messages that only one of two versions has.
//!
//! In: the messages of both versions, and the pairs of blocks. Out: messages without a counterpart in the
//! other version: another rule, or another block. A message that only moved with its block counts as the
//! same.

use std::collections::HashMap;

use super::Version;
use super::align::Pair;
use super::written::Written;
use crate::message::Diagnostic;

/// Position of a message, comparable between the versions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum At {
    /// Before the first block.
    Head,
    /// In a block, by its index in the second version.
    Block(usize),
    /// In a block that only the first version has.
    Gone,
}

/// The messages that only the first version has, and those that only the second has.
pub(super) fn only(
    versions: [Version; 2],
    texts: &[Written; 2],
    pairs: impl Iterator<Item = Pair>,
) -> (Vec<Diagnostic>, Vec<Diagnostic>) {
    let counterparts: HashMap<usize, usize> = pairs.filter_map(|[first, second]| first.zip(second)).collect();
    let key = |side: usize, found: &Diagnostic| {
        let at = match (side, texts[side].block_at(found.span.start)) {
            (_, None) => At::Head,
            (0, Some(block)) => counterparts.get(&block).map_or(At::Gone, |&other| At::Block(other)),
            (_, Some(block)) => At::Block(block),
        };
        (found.message.slug(), found.severity as u8, at)
    };
    let without = |side: usize| -> Vec<Diagnostic> {
        let mut known: HashMap<_, usize> = HashMap::new();
        for found in versions[1 - side].diagnostics {
            *known.entry(key(1 - side, found)).or_default() += 1;
        }
        let is_new = |found: &&Diagnostic| {
            let left = known.entry(key(side, found)).or_default();
            let is_known = *left > 0;
            *left -= usize::from(is_known);
            !is_known
        };
        versions[side].diagnostics.iter().filter(is_new).cloned().collect()
    };
    (without(0), without(1))
}
