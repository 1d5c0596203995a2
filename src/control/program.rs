//! Where things stand in the program text: sequence numbers within their O program.
//!
//! In: the text. Out: places a parser can go on from. Made when first asked for, because most programs never
//! ask. Knows nothing of what a block means.

use crate::text::block::Block;
use crate::text::parser::{Parser, Resume};

/// A sequence number and the block it stands before.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Label {
    sequence: u32,
    /// Which O program of the text it belongs to, from 0.
    program: u32,
    /// Where its block begins.
    at: Resume,
}

/// All sequence numbers of a text, in order.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Labels {
    labels: Vec<Label>,
    /// First bytes of the O programs behind the first.
    programs: Vec<u32>,
}

impl Labels {
    /// Reads the sequence numbers of a text.
    pub fn new(text: &[u8]) -> Self {
        let mut parser = Parser::new(text);
        let mut block = Block::default();
        let mut labels = Self::default();
        let mut begun = false;
        loop {
            let at = parser.position();
            if !parser.next_block(&mut block) {
                return labels;
            }
            if block.program.is_some() && begun {
                labels.programs.push(at.byte);
            }
            begun |= !block.is_empty();
            if let Some(sequence) = block.sequence {
                labels.labels.push(Label { sequence, program: labels.programs.len() as u32, at });
            }
        }
    }

    /// The block of a sequence number: the first match behind byte `from`, then from the head of the same O
    /// program (semantics §1.1 rule 7).
    pub fn find(&self, sequence: u32, from: u32) -> Option<Resume> {
        let program = self.programs.partition_point(|&start| start <= from) as u32;
        let own =
            || self.labels.iter().filter(|label| label.program == program && label.sequence == sequence);
        own().find(|label| label.at.byte > from).or_else(|| own().next()).map(|label| label.at)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_search_goes_forward_then_from_the_head_of_its_own_program() {
        let text = b"O1\nN10 G0 X1\nG71 P10 Q20\nN10 X2\nM30\nO2\nN30 X3\nN10 X4\n";
        let labels = Labels::new(text);
        let at = |sequence, from| labels.find(sequence, from).map(|at| &text[at.byte as usize..][..6]);
        assert_eq!(at(10, 15), Some(&b"N10 X2"[..]));
        assert_eq!(at(10, 30), Some(&b"N10 G0"[..]));
        assert_eq!(at(30, 15), None);
        assert_eq!(at(30, 50), Some(&b"N30 X3"[..]));
    }
}
