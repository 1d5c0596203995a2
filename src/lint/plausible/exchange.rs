//! Lint: exchanged values of X and Z, if the program names the same place several times the other way round.

use std::collections::BTreeMap;

use super::{Program, Row, Word, is_among};
use crate::control::words::after_letter;
use crate::message::{Diagnostic, Edit, Fix, Repair, said};
use crate::text::block::BlockKind;

/// Least number of times that the place is named the other way round.
const MIN_EXCHANGED: usize = 2;

impl Program<'_> {
    /// Reports a block whose X and Z are exchanged.
    pub(super) fn exchanged(&self) -> Vec<Diagnostic> {
        let mut places: Vec<(usize, &Word, &Word)> = Vec::new();
        for (index, row) in self.rows.iter().enumerate().filter(|(_, row)| row.moves_at_rapid) {
            let words = self.words_of(row);
            let word = |address: u8| words.iter().find(|word| word.address == address);
            let is_plain = !words.iter().any(|word| is_among(b"UWIKRCA", word.address));
            if let (Some(x), Some(z)) = (word(b'X'), word(b'Z'))
                && is_plain
            {
                places.push((index, x, z));
            }
        }
        let alone = |word: &Word| {
            let same = |other: &&Word| other.address == word.address && other.value == word.value;
            self.words.iter().filter(same).count() == 1
        };
        let key = |x: f64, z: f64| (x.to_bits(), z.to_bits());
        let mut times: BTreeMap<(u64, u64), usize> = BTreeMap::new();
        for (_, x, z) in &places {
            *times.entry(key(x.value, z.value)).or_default() += 1;
        }
        let mut diagnostics = Vec::new();
        for &(index, x, z) in places.iter().filter(|(_, x, z)| x.value != z.value) {
            let turned = times.get(&key(z.value, x.value)).copied().unwrap_or_default();
            let own = times.get(&key(x.value, z.value));
            if turned < MIN_EXCHANGED
                || own != Some(&1)
                || !alone(x)
                || !alone(z)
                || self.leaves_workpiece(index)
            {
                continue;
            }
            let (x_text, z_text) = (self.quote(x), self.quote(z));
            let (new_x, new_z) =
                (format!("X{}", after_letter(&z_text)), format!("Z{}", after_letter(&x_text)));
            let title = Repair::Write { text: format!("{new_x} {new_z}") };
            let mut edits = vec![Edit { span: x.span, text: new_x }, Edit { span: z.span, text: new_z }];
            if x.span.start > z.span.start {
                edits.reverse();
            }
            let (first, last) = (edits[0].span, edits[1].span);
            let message = said::AxesExchanged { x: x_text, z: z_text };
            let fix = Fix { title, safe: false, edits };
            diagnostics.push(Diagnostic::new(message, first.to(last)).with(fix));
        }
        diagnostics
    }

    /// Whether the tool only leaves the workpiece in a block: before the next move another tool is called,
    /// the spindle or the coolant stops, or the program ends.
    fn leaves_workpiece(&self, index: usize) -> bool {
        let own = self.words_of(&self.rows[index]);
        let is_last = own.iter().any(|word| stops(word) || word.address == b'T' && word.value % 100.0 == 0.0);
        let mut behind = self.rows[index + 1..].iter();
        is_last || behind.find_map(|row| self.shows_whether_left(row)).unwrap_or(true)
    }

    /// Whether a block shows that the tool has left the workpiece; `None` if it does not show either.
    fn shows_whether_left(&self, row: &Row) -> Option<bool> {
        let words = self.words_of(row);
        let leaves = |word: &Word| match word.address {
            b'T' => true,
            b'G' => matches!(word.value, 28.0 | 30.0),
            _ => stops(word),
        };
        if row.begins || row.kind == BlockKind::Percent || words.iter().any(leaves) {
            return Some(true);
        }
        // A call may move anything.
        let moves = |word: &Word| match word.address {
            b'M' => word.value == 98.0,
            b'G' => matches!(word.value, 65.0 | 66.0),
            _ => is_among(b"XZUW", word.address),
        };
        words.iter().any(moves).then_some(false)
    }
}

/// Whether an M code ends the work of a tool or of the program, at least temporarily.
fn stops(word: &Word) -> bool {
    word.address == b'M' && matches!(word.value, 0.0 | 1.0 | 2.0 | 5.0 | 6.0 | 9.0 | 30.0 | 99.0)
}
