//! Faulty blocks that a loop executes again: reading one takes far longer than executing it.
//!
//! In: a block read after a jump, and the places before and after it. Out: the same block, at the next place like the first.
//! What a block says depends on the text and the state of the parser alone, so it can be kept for a run.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::Run;
use crate::parts::early;
use crate::text::block::Block;
use crate::text::parser::{Parser, Resume};

/// Most faults of the blocks that are kept: some 30 MB.
const MOST_FAULTS: usize = 100_000;

/// Faulty blocks by the first byte at which they were read.
#[derive(Clone, Debug, Default)]
pub(super) struct FaultyBlocks {
    blocks: BTreeMap<u32, Kept>,
    faults: usize,
}

#[derive(Clone, Debug)]
struct Kept {
    at: Resume,
    next: Resume,
    block: Arc<Block>,
}

early! {
    /// Reads the next block of a program that has jumped; false at the end of the text.
    pub(super) fn next_block(run: &mut Run, parser: &mut Parser<'_>) -> bool {
        let at = parser.position();
        if let Some(kept) = run.faulty.blocks.get(&at.byte).filter(|kept| kept.at == at) {
            run.block = Arc::clone(&kept.block);
            parser.go_to(kept.next);
            return true;
        }
        let more = parser.next_block(run.block_to_read());
        if more && !run.block.faults.is_empty() && run.faulty.faults < MOST_FAULTS {
            run.faulty.faults += run.block.faults.len();
            let kept = Kept { at, next: parser.position(), block: Arc::clone(&run.block) };
            run.faulty.blocks.insert(at.byte, kept);
        }
        more
    }
}
