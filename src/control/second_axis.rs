//! The second axis of polar interpolation if the program names it Y.
//!
//! In: a block and the state before it. Out: the word that names the axis, and the block with FANUC's name
//! for it. The interpreter and the help share this file, so that both read the axis in the same way.

use super::modal::State;
use crate::geometry::virtual_plane::Surface;
use crate::setup::machine::Machine;
use crate::text::block::{Block, Word};

/// The word Y or V if it means the second axis of polar interpolation, on a machine without a Y axis. It is a
/// length, as C is (Haas operator's manual, G112).
pub fn named_y<'b>(block: &'b Block, state: &State, machine: &Machine) -> Option<&'b Word> {
    let on_face = state.virtual_plane.is_some_and(|plane| plane.surface == Surface::Face);
    if !on_face || machine.has_y() {
        return None;
    }
    let find =
        |letters: &[u8]| block.words.iter().find(|word| letters.contains(&word.address) && !word.comma);
    find(b"YV").filter(|_| find(b"CH").is_none())
}

/// The block with FANUC's name for the axis: C, and H for increments.
pub fn with_c(block: &Block) -> Block {
    let mut own = block.clone();
    for word in own.words.iter_mut().filter(|word| !word.comma) {
        word.address = match word.address {
            b'Y' => b'C',
            b'V' => b'H',
            other => other,
        };
    }
    own
}
