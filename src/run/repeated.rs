//! A cache of faulty blocks that a loop executes again, because reading one takes far longer than executing
//! it.
//!
//! In: a block read after a jump, and the positions before and after it. Out: the cached block when the same
//! position is read again. A block depends only on the text and the state of the parser, so it stays valid
//! for the whole run.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::Run;
use crate::parts::early;
use crate::text::block::Block;
use crate::text::parser::{Parser, Resume};

/// Maximum number of faults in all cached blocks: about 30 MB.
const MAX_FAULTS: usize = 100_000;

/// Faulty blocks by the first byte of their position.
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
    /// Reads the next block of a program that has jumped; returns false at the end of the text.
    pub(super) fn next_block(run: &mut Run, parser: &mut Parser<'_>) -> bool {
        let at = parser.position();
        if let Some(kept) = run.faulty.blocks.get(&at.byte).filter(|kept| kept.at == at) {
            run.block = Arc::clone(&kept.block);
            parser.go_to(kept.next);
            return true;
        }
        let more = parser.next_block(run.block_to_read());
        if more && !run.block.faults.is_empty() && run.faulty.faults < MAX_FAULTS {
            run.faulty.faults += run.block.faults.len();
            let kept = Kept { at, next: parser.position(), block: Arc::clone(&run.block) };
            run.faulty.blocks.insert(at.byte, kept);
        }
        more
    }
}
