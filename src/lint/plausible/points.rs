//! Lints for lost decimal points: leading zeros, single numbers without a point, places far beyond all
//! others.

use std::collections::BTreeMap;

use super::{Program, Role, Word, is_among, round};
use crate::message::{Diagnostic, Fix, said};
use crate::order;
use crate::setup::dialect::DecimalRule;
use crate::units::Diameter;

/// Usual distance of a position to change the tool, at most, mm.
const FARTHEST_RETRACT: f64 = 500.0;

impl Program<'_> {
    /// Reports a leading zero in a number without a point: `F02`, `R05`.
    pub(super) fn leading_zeros(&self) -> Vec<Diagnostic> {
        let numbers = b"XZUWRFIKCA";
        let padded = |word: &&Word| {
            let written = word.span.of(self.text);
            let digits = written[1..].iter().skip_while(|byte| matches!(byte, b' ' | b'-' | b'+'));
            let digits: Vec<u8> = digits.copied().collect();
            word.value != 0.0 && digits.len() >= 2 && digits[0] == b'0'
        };
        // If numbers without a point count increments, leading zeros of a length are a habit.
        let numbers: &[u8] = if self.decimal == DecimalRule::LeastIncrement { b"F" } else { numbers };
        let bare = |word: &&Word| {
            is_among(numbers, word.address) && word.decimals.is_none() && !self.is_threads_per_inch(word)
        };
        let found: Vec<&Word> = self.words.iter().filter(bare).filter(padded).collect();
        // Leading zeros in several lengths, `Z02` and `X00`, are a habit; in a feed they never are.
        let zero = |word: &&Word| {
            is_among(b"XZUW", word.address)
                && word.value == 0.0
                && word.span.of(self.text)[1..].starts_with(b"00")
        };
        let zeros = self.words.iter().filter(bare).filter(zero).count();
        let lengths = found.iter().filter(|word| word.address != b'F').count() + zeros;
        let alone = found.into_iter().filter(|word| word.address == b'F' || lengths == 1);
        let tell = |word: &Word| {
            let written = self.quote(word);
            let zero = written.find('0').unwrap_or_default();
            let meant = format!("{}0.{}", &written[..zero], &written[zero + 1..]);
            let fix = Fix::write(word.span, meant.clone());
            let message = said::LeadingZero { word: written, value: word.value, meant };
            Diagnostic::new(message, word.span).with(fix)
        };
        alone.map(tell).collect()
    }

    /// Whether a word is I of a thread on GSK controls: threads per inch, usually a whole number.
    fn is_threads_per_inch(&self, word: &Word) -> bool {
        word.address == b'I' && !word.negative && self.rows[word.block].thread
    }

    /// Reports a single number without a point in a program that uses points, unless such numbers count
    /// increments.
    pub(super) fn missing_points(&self) -> Vec<Diagnostic> {
        if self.decimal == DecimalRule::LeastIncrement {
            return Vec::new();
        }
        let lengths = |word: &&Word| {
            (is_among(b"XZUWRIK", word.address)
                && self.rows[word.block].role == Role::Place
                && !self.is_threads_per_inch(word)
                && word.value != 0.0)
                || word.address == b'F' && word.value != 0.0
        };
        let without = |word: &&Word| word.decimals.is_none();
        let all: Vec<&Word> = self.words.iter().filter(lengths).filter(|word| word.address != b'F').collect();
        let bare: Vec<&Word> = all.iter().copied().filter(without).collect();
        // One or two among many.
        if bare.is_empty() || all.len() < 6 || bare.len() * 6 > all.len() {
            return Vec::new();
        }
        let tell = |word: &Word| {
            let message =
                said::PointMissing { word: self.quote(word), thousandths: word.value * self.increment };
            let diagnostic = Diagnostic::new(message, word.span);
            Diagnostic { fixes: self.with_point(word), ..diagnostic }
        };
        // A distant place is often a round number.
        let cuts = |word: &&Word| self.is_cut(&self.rows[word.block]);
        bare.into_iter().filter(cuts).map(tell).collect()
    }

    /// Fixes that put a point where similar words have it, and at the end of the number.
    pub(super) fn with_point(&self, word: &Word) -> Vec<Fix> {
        let written = self.quote(word);
        let alike =
            self.words.iter().filter(|other| other.address == word.address && other.decimals.is_some());
        let mut counts: BTreeMap<u8, usize> = BTreeMap::new();
        for other in alike {
            *counts.entry(other.decimals.unwrap_or_default()).or_default() += 1;
        }
        let mut usual: Vec<(u8, usize)> = counts.into_iter().collect();
        order::by_key(&mut usual, |&(decimals, count)| (std::cmp::Reverse(count), decimals));
        let mut decimals: Vec<u8> = usual.into_iter().map(|(decimals, _)| decimals).collect();
        decimals.extend([1, 2, 3]);
        // Other words have it at their end.
        decimals.push(0);
        let digits = written.bytes().filter(u8::is_ascii_digit).count();
        let mut texts: Vec<String> = Vec::new();
        for places in decimals.into_iter().filter(|&places| usize::from(places) < digits) {
            let at = written.len() - usize::from(places);
            let text = format!("{}.{}", &written[..at], &written[at..]);
            if !texts.contains(&text) {
                texts.push(text);
            }
        }
        texts.truncate(3);
        texts.into_iter().map(|text| Fix::write(word.span, text)).collect()
    }

    /// End point of a word, mm, in the notation of programs.
    pub(super) fn leads_to(&self, word: &Word) -> Option<f64> {
        let value = word.value * self.unit;
        let (from, to) = self.rows[word.block].motions?;
        let start = self.motions.glance(from).from;
        let place = match word.address {
            b'X' | b'Z' => Some(value),
            b'U' => Some(Diameter::from_radius(start.x).mm() + value),
            b'W' => Some(start.z + value),
            _ => None,
        };
        place.filter(|_| from < to)
    }

    /// Reports a place far beyond all others.
    pub(super) fn far_off(&self) -> Vec<Diagnostic> {
        let start = if self.motions.is_empty() { Default::default() } else { self.motions.glance(0).from };
        let mut diagnostics = Vec::new();
        for (axis, letters, begins) in
            [('X', b"XU", Diameter::from_radius(start.x.abs()).mm()), ('Z', b"ZW", start.z.abs())]
        {
            let mut places: Vec<(f64, &Word, bool)> = Vec::new();
            for word in self.places().filter(|word| is_among(letters, word.address)) {
                let cuts = self.is_cut(&self.rows[word.block]);
                places.extend(self.leads_to(word).map(|place| (place, word, cuts)));
            }
            let top = places.iter().max_by(|a, b| a.0.abs().total_cmp(&b.0.abs()));
            let Some(&(place, word, cuts)) = top else { continue };
            let others = || places.iter().filter(|other| other.1.span != word.span);
            let far = |found: &mut dyn Iterator<Item = f64>| found.fold(0.0, f64::max);
            let cut = far(&mut others().filter(|other| other.2).map(|other| other.0.abs()));
            let next = far(&mut others().map(|other| other.0.abs())).max(begins);
            let cut_others = others().filter(|other| other.2).count();
            // A retract may go farther than all cuts; a cut hardly ever farther than the retract.
            let (limit, farthest) = match cuts && cut_others >= 2 {
                true => (2.0 * cut + 50.0, cut),
                false => (3.0 * next + 50.0, next),
            };
            // A position to change the tool is far away from a small part.
            let limit = if !cuts && place > 0.0 { limit.max(FARTHEST_RETRACT) } else { limit };
            if others().count() < 2 || place.abs() <= limit {
                continue;
            }
            let (to, farthest) = (round(place), round(farthest));
            let message = said::FarOff { word: self.quote(word), axis, to, farthest };
            let fixes = if word.decimals.is_none() { self.with_point(word) } else { Vec::new() };
            diagnostics.push(Diagnostic { fixes, ..Diagnostic::new(message, word.span) });
        }
        diagnostics
    }
}
