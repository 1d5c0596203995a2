//! Lint: blocks that cannot be reached, after the end of their program.

use std::collections::BTreeSet;

use super::{Program, is_among};
use crate::message::{Diagnostic, said};
use crate::order;
use crate::text::block::BlockKind;

impl Program<'_> {
    /// Reports moves after M02 or M30, or after the M99 of a subprogram, that no jump, call or contour
    /// reaches.
    pub(super) fn unreached(&self) -> Vec<Diagnostic> {
        let mut diagnostics = Vec::new();
        let mut after: Option<usize> = None;
        let mut named: Option<Named> = None;
        for (index, row) in self.rows.iter().enumerate() {
            let mut leads_to = |number| named.get_or_insert_with(|| Named::of(self)).holds(number);
            if row.begins || after.is_some() && row.sequence.is_some_and(&mut leads_to) {
                after = None;
            } else if row.kind == BlockKind::Percent && after.is_some() {
                // The second percent sign ends the file; the first one is at its head.
                break;
            } else if let Some(end) = after.filter(|_| self.names_place(index)) {
                let word = self.words[end].span.quote(self.text);
                let words = self.words_of(row);
                let span = words[0].span.to(words[words.len() - 1].span);
                diagnostics.push(Diagnostic::new(said::BlocksAfterEnd { end: word }, span));
                after = None;
            }
            if row.end.is_some() {
                after = row.end.filter(|_| !self.is_searched_for(index));
            }
        }
        diagnostics
    }

    /// Whether the section after an end is started by a block search: its first block has a sequence number
    /// and does not move an axis, and the section has its own end.
    fn is_searched_for(&self, end: usize) -> bool {
        let section = || {
            let behind = self.rows.iter().enumerate().skip(end + 1);
            behind.take_while(|(_, row)| !row.begins && row.kind != BlockKind::Percent)
        };
        let first = section().find(|(_, row)| row.sequence.is_some() || !row.words.is_empty());
        first.is_some_and(|(index, row)| row.sequence.is_some() && !self.names_place(index))
            && section().any(|(_, row)| row.end.is_some())
    }

    /// Whether a block moves an axis.
    fn names_place(&self, index: usize) -> bool {
        let row = &self.rows[index];
        row.kind == BlockKind::Words && self.words_of(row).iter().any(|word| is_among(b"XZUW", word.address))
    }
}

/// The sequence numbers that are searched for: P and Q of a cycle, a call or M99, and targets of GOTO.
struct Named {
    numbers: BTreeSet<u32>,
    /// Whether the target of a GOTO is a variable, and so may be any number.
    any: bool,
}

impl Named {
    fn of(program: &Program) -> Self {
        let by_word = program.words.iter().filter(|word| is_among(b"PQ", word.address));
        let jumps = program.jumps.iter().copied().flatten();
        Self {
            numbers: order::gathered(by_word.map(|word| word.value as u32).chain(jumps)),
            any: program.jumps.contains(&None),
        }
    }

    fn holds(&self, number: u32) -> bool {
        self.any || self.numbers.contains(&number)
    }
}
