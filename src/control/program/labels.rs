//! Index of the program text: O programs, and the sequence numbers in each of them.
//!
//! In: the text. Out: positions from which a parser can continue. Built on first use, because most programs
//! need none. Knows nothing of the meaning of a block, apart from the program numbers in calls.

use std::collections::{BTreeMap, BTreeSet};

use crate::control::codes;
use crate::order;
use crate::source::Span;
use crate::text::block::{Block, Value, Word};
use crate::text::parser::{Parser, Resume};
use crate::text::program_name;

/// A number and the position of its block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Label {
    number: u32,
    /// Index of its O program in the text; 0 for program numbers.
    program: u32,
    /// Start of its block.
    at: Resume,
}

impl Label {
    fn key(&self) -> (u32, u32, u32) {
        (self.program, self.number, self.at.byte)
    }
}

/// Labels sorted by program, number and position.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
struct Sorted(Vec<Label>);

impl Sorted {
    fn new(mut labels: Vec<Label>) -> Self {
        order::by_key(&mut labels, Label::key);
        Self(labels)
    }

    /// The first label of a number in a program, at byte `from` or after it.
    fn first(&self, program: u32, number: u32, from: u32) -> Option<Resume> {
        let at = self.0.partition_point(|label| label.key() < (program, number, from));
        let label = self.0.get(at)?;
        ((label.program, label.number) == (program, number)).then_some(label.at)
    }
}

/// An O program of the text.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Program {
    /// Its number, if any: the first program of a text may have none.
    number: Option<u32>,
    /// The number in its name, if it also has a name.
    name: Option<u32>,
    /// Its first block.
    head: Resume,
}

/// All programs and sequence numbers of a text.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Labels {
    /// The sequence numbers.
    labels: Sorted,
    /// In text order; the first begins at the start of the text.
    programs: Vec<Program>,
    /// The programs by number.
    heads: Sorted,
    /// By called number: the calling programs.
    calls: Sorted,
    /// The same, but only programs that are not called themselves.
    callers: Sorted,
}

impl Labels {
    /// Reads the program numbers and sequence numbers of a text.
    pub fn new(text: &[u8]) -> Self {
        let mut parser = Parser::new(text);
        let mut block = Block::default();
        let mut labels = Self {
            programs: vec![Program { number: None, name: None, head: Resume::default() }],
            ..Self::default()
        };
        let mut sequences = Vec::new();
        // Pairs of the index of the calling program and the called number.
        let mut calls = Vec::new();
        let mut begun = false;
        loop {
            let at = parser.position();
            if !parser.next_block(&mut block) {
                break;
            }
            if let Some((number, _)) = block.program {
                let program = Program {
                    number: Some(number),
                    name: block.second_name.map(|(number, _)| number),
                    head: at,
                };
                match labels.programs.last_mut().filter(|_| !begun) {
                    Some(first) => *first = program,
                    None => labels.programs.push(program),
                }
            }
            begun |= !block.is_empty();
            if let Some(sequence) = block.sequence {
                sequences.push(Label { number: sequence, program: labels.programs.len() as u32 - 1, at });
            }
            let call = called(&block).map(|(called, _)| (labels.programs.len() - 1, called));
            calls.extend(call.map(|call| (call, codes::macro_a(&block).is_some())));
        }
        let label = |number, at| Label { number, program: 0, at };
        let numbers = |program: &Program| [program.number, program.name].into_iter().flatten();
        let heads = labels
            .programs
            .iter()
            .flat_map(|program| numbers(program).map(|number| label(number, program.head)));
        labels.heads = Sorted::new(heads.collect());
        // `G65 H80 P90` is a statement of macro A, unless P is the number of a program in the text.
        let is_call = |&((_, number), is_macro_a): &((usize, u32), bool)| {
            !is_macro_a || labels.heads.first(0, number, 0).is_some()
        };
        let calls: Vec<_> = calls.into_iter().filter(is_call).map(|(call, _)| call).collect();
        let made_by = |&(caller, called): &(usize, u32)| label(called, labels.programs[caller].head);
        let called = Sorted::new(calls.iter().map(made_by).collect());
        let is_called = |&(caller, _): &(usize, u32)| {
            numbers(&labels.programs[caller]).any(|own| called.first(0, own, 0).is_some())
        };
        let callers = calls.iter().filter(|call| !is_called(call)).map(made_by).collect();
        (labels.labels, labels.calls, labels.callers) =
            (Sorted::new(sequences), called, Sorted::new(callers));
        labels
    }

    /// The block with a sequence number: the first match after byte `from`, otherwise the first from the head
    /// of the same O program.
    pub fn find(&self, sequence: u32, from: u32) -> Option<Resume> {
        let head = || self.first_from(sequence, from, 0);
        self.first_from(sequence, from, from + 1).or_else(head)
    }

    /// Whether there is a block with that number at byte `from` or after it, in the same O program.
    pub fn is_at_or_after(&self, sequence: u32, from: u32) -> bool {
        self.first_from(sequence, from, from).is_some()
    }

    /// The first block of the O program with a number.
    pub fn program(&self, number: u32) -> Option<Resume> {
        self.heads.first(0, number, 0)
    }

    /// The number of the O program that contains byte `at`.
    pub fn number_at(&self, at: u32) -> Option<u32> {
        self.programs.get(self.index_at(at)).and_then(|program| program.number)
    }

    /// The head of the O program that contains byte `at`.
    pub fn head_at(&self, at: u32) -> Resume {
        self.programs.get(self.index_at(at)).map_or(Resume::default(), |program| program.head)
    }

    /// Whether a program of the text calls the program with a number, by number or by name.
    pub fn is_called(&self, number: u32) -> bool {
        let calls = |number: u32| self.calls.first(0, number, 0).is_some();
        calls(number) || self.name_of(number).is_some_and(calls)
    }

    /// The first program that calls the program with a number, and is not called itself.
    pub fn top_level_caller(&self, number: u32) -> Option<Resume> {
        let caller = |number: u32| self.callers.first(0, number, 0);
        caller(number).or_else(|| caller(self.name_of(number)?))
    }

    /// The number in the name of the program with a number.
    fn name_of(&self, number: u32) -> Option<u32> {
        let program = self.programs.get(self.index_at(self.program(number)?.byte))?;
        program.name.filter(|_| program.number == Some(number))
    }

    fn index_at(&self, at: u32) -> usize {
        self.programs.partition_point(|program| program.head.byte <= at).saturating_sub(1)
    }

    /// The first block with a number from byte `byte` on, in the O program that contains byte `around`.
    fn first_from(&self, sequence: u32, around: u32, byte: u32) -> Option<Resume> {
        let program = self.index_at(around) as u32;
        self.labels.first(program, sequence, byte)
    }
}

/// Whether a text can contain a call: it has M98, M198, G65 or G66.
pub fn may_call(text: &[u8]) -> bool {
    text.windows(2).enumerate().any(|(at, code)| {
        let before = &text[at.saturating_sub(4)..at];
        let letter = before.iter().rev().find(|byte| !matches!(byte, b'0' | b'1' | b' '));
        matches!(code, b"98" | b"65" | b"66") && matches!(letter, Some(b'M' | b'm' | b'G' | b'g'))
    })
}

/// The programs that a text calls but does not contain: each number once, with the first word that calls it.
pub fn calls_elsewhere(text: &[u8]) -> Vec<(u32, Span)> {
    let (mut parser, mut block) = (Parser::new(text), Block::default());
    let (mut heads, mut calls) = (BTreeSet::new(), BTreeMap::new());
    while parser.next_block(&mut block) {
        heads.extend(block.program.into_iter().chain(block.second_name).map(|(number, _)| number));
        if let Some((number, word)) = called(&block).filter(|_| codes::macro_a(&block).is_none()) {
            calls.entry(number).or_insert(word);
        }
    }
    calls.into_iter().filter(|(number, _)| !heads.contains(number)).collect()
}

/// The number of the program that a block calls with M98, M198, G65 or G66, and the word with it.
fn called(block: &Block) -> Option<(u32, Span)> {
    let code =
        |word: &Word| matches!((word.address, whole(word)), (b'M', Some(98 | 198)) | (b'G', Some(65 | 66)));
    block.words.iter().find(|word| code(word))?;
    let word = block.words.iter().find(|word| word.address == b'P')?;
    whole(word).map(|value| (program_and_repeats(value).0, word.span))
}

fn whole(word: &Word) -> Option<u64> {
    match word.value {
        Value::Number { number, negative: false } => number.integer(),
        _ => None,
    }
}

/// Splits P of M98: up to four digits are the program number; longer values have the repeats before the last
/// four digits (`P51002` calls O1002 five times).
pub fn program_and_repeats(value: u64) -> (u32, u32) {
    match value {
        0..=9999 => (value as u32, 1),
        _ if u32::try_from(value).is_ok_and(program_name::is_name) => (value as u32, 1),
        _ => ((value % 10_000) as u32, (value / 10_000).clamp(1, 9_999) as u32),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_calls_nothing_is_not_read() {
        for text in ["M98 P1", "m098P1", "G65 P1", "G 66 P1", "M198 P1"] {
            assert!(may_call(text.as_bytes()), "{text}");
        }
        assert!(!may_call(b"O1\nG01 X98. Z-65.66\nX1665\nM30\n"));
    }

    #[test]
    fn a_call_beside_h_is_one_where_there_is_its_program() {
        let labels = Labels::new(b"O1\nG65 H2 P9010\nG65 H80 P90\nM30\nO9010\nM99\n");
        assert!(labels.is_called(9010) && !labels.is_called(90));
    }

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

    #[test]
    fn programs_know_who_calls_whom() {
        let text = b"O1000\nG0 X1\nM99\nO2\nM98 P31000\nG65 P3 A1\nM30\nO3\nM99\n";
        let labels = Labels::new(text);
        assert_eq!(labels.program(2).map(|at| at.byte), Some(16));
        assert_eq!(labels.program(4), None);
        assert!(labels.is_called(1000) && labels.is_called(3) && !labels.is_called(2));
        assert_eq!(labels.top_level_caller(1000), labels.program(2));
        assert_eq!(labels.number_at(20), Some(2));
    }

    #[test]
    fn long_numbers_hold_the_repeats() {
        let cases = [(1002, (1002, 1)), (51_002, (1002, 5)), (30_010, (10, 3)), (100_005, (5, 10))];
        for (written, meant) in cases {
            assert_eq!(program_and_repeats(written), meant);
        }
    }
}
