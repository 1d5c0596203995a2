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

impl Label {
    fn key(&self) -> (u32, u32, u32) {
        (self.program, self.sequence, self.at.byte)
    }
}

/// All sequence numbers of a text.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Labels {
    /// In order of program, number and place.
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
                labels.labels.sort_unstable_by_key(Label::key);
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
        let head = || self.first_from(sequence, from, 0);
        self.first_from(sequence, from, from + 1).or_else(head)
    }

    /// Whether a block of that number stands at byte `from` or behind it in the same O program.
    pub fn is_at_or_behind(&self, sequence: u32, from: u32) -> bool {
        self.first_from(sequence, from, from).is_some()
    }

    /// The first block of a number from byte `byte` on, in the O program around byte `around`.
    fn first_from(&self, sequence: u32, around: u32, byte: u32) -> Option<Resume> {
        let program = self.programs.partition_point(|&start| start <= around) as u32;
        let at = self.labels.partition_point(|label| label.key() < (program, sequence, byte));
        let label = self.labels.get(at)?;
        ((label.program, label.sequence) == (program, sequence)).then_some(label.at)
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
