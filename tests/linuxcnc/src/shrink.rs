//! In: a program that fails. Out: a smaller one with the same failure. Removes blocks, many at a time first.

use crate::program::Program;

/// Removes blocks as long as `fails` stays true.
pub fn shrink(program: &Program, mut fails: impl FnMut(&Program) -> bool) -> Program {
    let mut smallest = program.clone();
    let mut size = smallest.blocks.len().div_ceil(2).max(1);
    loop {
        let before = smallest.blocks.len();
        let mut at = 0;
        while at < smallest.blocks.len() {
            let mut candidate = smallest.clone();
            candidate.blocks.drain(at..(at + size).min(smallest.blocks.len()));
            if !candidate.blocks.is_empty() && fails(&candidate) {
                smallest = candidate;
            } else {
                at += size;
            }
        }
        if size == 1 && smallest.blocks.len() == before {
            return smallest;
        }
        size = (size / 2).max(1);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::Block;

    #[test]
    fn only_the_blocks_that_matter_are_left() {
        let blocks = (0..40).map(|frame| Block::Frame(frame % 6)).collect();
        let program = Program { start: (0, 0), nose: 0, blocks };
        let fails = |program: &Program| {
            let count = |frame| program.blocks.iter().filter(|block| **block == Block::Frame(frame)).count();
            count(2) >= 2 && count(5) >= 1
        };
        assert!(fails(&program));
        assert_eq!(shrink(&program, fails).blocks.len(), 3);
    }
}
