//! The blocks of a program as they are written, without blanks, comments and N numbers.
//!
//! In: a text. Out: its blocks, and a key that is the same for identical texts. Number formats count: `G1` and `G01`
//! are different texts.

use crate::text::block::Block;
use crate::text::parser::Parser;

/// The blocks of a text without blanks, comments, N numbers and empty blocks.
pub(super) fn blocks_of(text: &[u8]) -> Vec<Vec<u8>> {
    let (mut parser, mut block) = (Parser::new(text), Block::default());
    let mut blocks = Vec::new();
    while parser.next_block(&mut block) {
        let written = written(text, &block);
        if !written.is_empty() {
            blocks.push(written);
        }
    }
    blocks
}

/// A key of a text: the same for texts that differ only in blanks, comments and N numbers.
pub fn key_of(text: &[u8]) -> Vec<u8> {
    blocks_of(text).join(&b'\n')
}

/// The characters of a block.
fn written(text: &[u8], block: &Block) -> Vec<u8> {
    let (start, end) = (block.span.start as usize, block.span.end as usize);
    let is_comment = |at: usize| {
        block.comments.iter().any(|comment| (comment.start as usize..comment.end as usize).contains(&at))
    };
    let kept = (start..end).filter(|&at| !is_comment(at) && !text[at].is_ascii_whitespace());
    let kept: Vec<u8> = kept.map(|at| text[at]).collect();
    if block.sequence.is_none() {
        return kept;
    }
    let letter = kept.iter().position(|byte| byte.eq_ignore_ascii_case(&b'N')).unwrap_or(0);
    let digits = kept[letter..].iter().skip(1).take_while(|byte| byte.is_ascii_digit()).count();
    [&kept[..letter], &kept[letter + 1 + digits..]].concat()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blanks_comments_and_numbers_do_not_count() {
        let key = key_of(b"O0001 (step)\nG00 X32 Z2\nG90X26 Z-30 F0.1;\nM30\n");
        assert_eq!(key_of(b"O0001\n\nN10 G00X32Z2 (start)\nN20 G90 X26 Z-30 F0.1\nN30M30"), key);
        for other in
            ["O0001\nG0 X32 Z2\nG90 X26 Z-30 F0.1\nM30", "O0001\nG00 X32 Z2\nG90 X26. Z-30 F0.1\nM30"]
        {
            assert_ne!(key_of(other.as_bytes()), key, "{other}");
        }
    }
}
