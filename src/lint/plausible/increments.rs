//! Lint: U instead of X, increments among places.

use super::{Program, is_among, round};
use crate::message::{Diagnostic, Fix, said};
use crate::units::Diameter;

impl Program<'_> {
    /// Reports a U as in `X16`, `U24`, `X36`: its number is a place between its neighbours, but as an
    /// increment it goes beyond them.
    pub(super) fn increments_in_row(&self) -> Vec<Diagnostic> {
        let mut diagnostics = Vec::new();
        let places = self.places().filter(|word| is_among(b"XZ", word.address)).count();
        let increments = self.places().filter(|word| is_among(b"UW", word.address)).count();
        if increments > 2 || places < 3 * increments {
            return diagnostics;
        }
        let largest =
            self.places().filter(|word| word.address == b'X').map(|word| word.value).fold(0.0, f64::max);
        for (before, word, behind) in self.neighbours(b"XU") {
            let Some(before) = before.filter(|before| before.address == b'X') else { continue };
            if word.address != b'U' || word.negative || word.value < 2.0 {
                continue;
            }
            let leads = before.value + word.value;
            let flagged = match behind.filter(|behind| behind.address == b'X') {
                Some(behind) => {
                    let (low, high) = (before.value.min(behind.value), before.value.max(behind.value));
                    (low <= word.value && word.value <= high && leads > high + 0.001)
                        || leads > largest + 0.001 && word.value >= 10.0 && !self.rows[word.block].rapid
                }
                None => leads > largest + 0.001 && word.value >= 10.0 && !self.rows[word.block].rapid,
            };
            if !flagged {
                continue;
            }
            let written = self.quote(word);
            let meant = format!("X{}", &written[1..]);
            let fix = Fix::write(word.span, meant.clone());
            let to = round(leads * self.unit);
            let message = said::IncrementalForAbsolute { word: written, axis: 'X', to, meant };
            diagnostics.push(Diagnostic::new(message, word.span).with(fix));
        }
        diagnostics
    }

    /// Reports a single U among places if nothing else in the program is at its end point.
    pub(super) fn increments(&self) -> Vec<Diagnostic> {
        let moves =
            |letters: &'static [u8]| self.places().filter(move |word| is_among(letters, word.address));
        let (places, increments) = (moves(b"XZ").count(), moves(b"UW").count());
        // A program that uses increments several times intends them.
        if increments == 0 || increments > 2 || places < 3 * increments {
            return Vec::new();
        }
        let mut diagnostics = Vec::new();
        for word in moves(b"U") {
            let row = &self.rows[word.block];
            let Some((from, to)) = row.motions else { continue };
            let start = self.motions.glance(from).from;
            let (now, value) = (Diameter::from_radius(start.x).mm(), word.value * self.unit);
            let leads = now + value;
            if word.negative || row.arc && value < 1.0 || to <= from {
                continue;
            }
            let with_place = self.words_of(row).iter().any(|other| other.address == b'Z');
            let known = |place: f64| moves(b"X").any(|other| (other.value * self.unit - place).abs() < 0.001);
            let farthest = moves(b"X").map(|other| other.value * self.unit).fold(0.0, f64::max);
            // A short move outwards is a retract or a taper.
            let small = value <= 10.0;
            let suspicious = !known(leads) && (with_place || leads > farthest + 0.001 || known(value));
            if small || !suspicious {
                continue;
            }
            let written = self.quote(word);
            let meant = format!("X{}", &written[1..]);
            let fix = Fix::write(word.span, meant.clone());
            let message = said::IncrementalForAbsolute { word: written, axis: 'X', to: round(leads), meant };
            diagnostics.push(Diagnostic::new(message, word.span).with(fix));
        }
        diagnostics
    }
}
