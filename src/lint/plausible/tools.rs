//! Lint: a T word whose station and offset differ, if they agree in the rest of the program.

use std::collections::BTreeSet;

use super::Program;
use crate::control::words::as_meant;
use crate::message::{Diagnostic, Fix, said};
use crate::source::Span;

/// Least number of other tools that use the offset of their station.
const MIN_OTHERS: usize = 3;

/// Usual differences between a station and its second offset: T0111, T0121.
const SECOND: [u64; 2] = [10, 20];

/// A T word.
struct Call {
    station: u64,
    offset: u64,
    span: Span,
}

impl Program<'_> {
    /// Reports the only tool that is called with the offset of another station.
    pub(super) fn other_offset(&self) -> Vec<Diagnostic> {
        let (mut calls, mut known): (Vec<Call>, BTreeSet<(u64, u64)>) = Default::default();
        for word in self.words.iter().filter(|word| word.address == b'T') {
            let digits = as_meant(self.text, word.span).bytes().filter(u8::is_ascii_digit).count();
            if !matches!(digits, 3 | 4) {
                continue;
            }
            let (station, offset) = (word.value as u64 / 100, word.value as u64 % 100);
            // Offset 0 switches the offset off; a tool that is called again counts once.
            if offset > 0 && known.insert((station, offset)) {
                calls.push(Call { station, offset, span: word.span });
            }
        }
        let mut others = calls.iter().filter(|call| call.station != call.offset);
        let (Some(odd), None) = (others.next(), others.next()) else { return Vec::new() };
        let agreeing = || calls.iter().filter(|call| call.station == call.offset);
        let has_own = agreeing().any(|call| call.station == odd.station);
        let is_of_other = agreeing().any(|call| call.station == odd.offset);
        // A second offset of a station that also uses its own is usual, for example for the other edge of a
        // grooving insert. So is an offset with the number of a second one, unless that is the number of
        // another tool.
        let is_numbered_as_second = SECOND.map(|way| odd.station + way).contains(&odd.offset)
            && !calls.iter().any(|call| call.station == odd.offset);
        if agreeing().count() < MIN_OTHERS || has_own && !is_of_other || is_numbered_as_second {
            return Vec::new();
        }
        let word = odd.span.quote(self.text);
        let (station, offset) = (odd.station as usize, odd.offset as usize);
        let fixes = [station, offset].map(|number| Fix::write(odd.span, format!("T{number:02}{number:02}")));
        let message = said::ToolOffsetDiffers { word, station, offset };
        vec![Diagnostic { fixes: fixes.into(), ..Diagnostic::new(message, odd.span) }]
    }
}
