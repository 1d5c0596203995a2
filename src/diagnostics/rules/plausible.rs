//! Numbers that do not fit the rest of their program: a lost point, a lost minus, U where X was meant.
//!
//! In: the text, its motions. Out: remarks, each with repairs to choose from. A control carries all of it out; only who
//! compares a block with the others sees it. So nothing is said of what occurs often in the same program: that is its
//! style.

use std::collections::BTreeMap;

use crate::diagnostics::{Diagnostic, Fix, Message};
use crate::motion::{Motion, MotionKind, Motions, Step};
use crate::text::block::{Block, BlockKind, Value};
use crate::text::parser::Parser;
use crate::text::source::Span;

/// A word with a number, where it stands.
#[derive(Clone, Copy, Debug)]
struct Word {
    address: u8,
    /// As written, with its sign.
    value: f64,
    negative: bool,
    /// Digits behind the point; nothing without a point.
    decimals: Option<u8>,
    span: Span,
    /// Index of its block.
    block: usize,
}

/// What a chamfer or a rounded corner may take off a move, mm.
const CORNER: f64 = 5.0;

/// What a block is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Role {
    /// Moves to a place.
    Place,
    /// Cuts by a multiple cycle whose X and Z are a place.
    Deep,
    /// Parameters of a cycle, settings.
    Other,
}

/// A block with what it moved.
#[derive(Clone, Debug)]
struct Row {
    span: Span,
    role: Role,
    words: std::ops::Range<usize>,
    /// Its first motion, and one past its last.
    motions: Option<(usize, usize)>,
    arc: bool,
    /// It moves at rapid, as far as the text tells.
    rapid: bool,
    /// It stands in a contour, P to Q.
    contour: bool,
    /// Its sequence number.
    sequence: Option<u32>,
    /// A tool is called, or the program ends: what stands behind has nothing to do with what stood before.
    parts: bool,
}

/// A program taken apart.
struct Program<'a> {
    text: &'a [u8],
    rows: Vec<Row>,
    words: Vec<Word>,
    motions: &'a Motions,
    /// Millimetres in one unit of the text.
    unit: f64,
}

/// Remarks about the numbers of a program of no more than `blocks` blocks; none of a longer one. `unit`: millimetres in one of
/// its units. Of a program that is not
/// `sound` (a block was not carried out) only the writing is looked at: its motions are not what was meant.
pub fn remarks(text: &[u8], motions: &Motions, unit: f64, sound: bool, blocks: usize) -> Vec<Diagnostic> {
    let Some(program) = Program::read(text, motions, unit, blocks) else { return Vec::new() };
    let mut told = program.leading_zeros();
    told.extend(program.missing_points());
    told.extend(program.lost_minus_in_row());
    told.extend(program.increments_in_row());
    if sound {
        told.extend(program.far_off());
        told.extend(program.lost_minus());
        told.extend(program.increments());
    }
    told.truncate(MOST);
    // One fault, one message: what was told first of a word stays.
    let mut seen = Vec::new();
    told.retain(|one| {
        let new = !seen.contains(&one.span);
        seen.push(one.span);
        new
    });
    told
}

/// More of them are a consequence of something else.
const MOST: usize = 50;

const MULTIPLE: std::ops::RangeInclusive<u64> = 70..=76;
/// G04, G10, G28, G30, G50, G52, G53, G65, G66.
const SETTINGS: [u64; 9] = [4, 10, 28, 30, 50, 52, 53, 65, 66];

impl<'a> Program<'a> {
    fn read(text: &'a [u8], motions: &'a Motions, unit: f64, most: usize) -> Option<Self> {
        let mut parser = Parser::new(text);
        let mut block = Block::default();
        let (mut rows, mut words) = (Vec::new(), Vec::new());
        let mut rapid = true;
        while parser.next_block(&mut block) {
            if rows.len() >= most {
                return None;
            }
            let first = words.len();
            let mut role = Role::Place;
            let mut arc = false;
            let has = |letters: &[u8]| block.words.iter().any(|word| letters.contains(&word.address));
            for word in &block.words {
                let Value::Number { number, negative } = word.value else { continue };
                let written = word.span.of(text);
                // A misread word was told; a corner word counts from its corner.
                if !written.is_ascii() || !written[0].is_ascii_alphabetic() {
                    continue;
                }
                let value = if negative { -number.value() } else { number.value() };
                let decimals = number.has_point().then_some(number.decimals);
                if word.address == b'G' && number.decimals == 0 {
                    match number.mantissa {
                        code if SETTINGS.contains(&code) => role = Role::Other,
                        74..=76 if has(b"XZ") => role = Role::Deep,
                        // R and Q of a hole are no places.
                        83 | 84 | 85 | 87 | 88 | 89 => role = Role::Deep,
                        code if MULTIPLE.contains(&code) => role = Role::Other,
                        0 => rapid = true,
                        1 | 32 | 34 | 90 | 92 | 94 => rapid = false,
                        2 | 3 => (arc, rapid) = (true, false),
                        _ => {}
                    }
                }
                words.push(Word {
                    address: word.address,
                    value,
                    negative,
                    decimals,
                    span: word.span,
                    block: rows.len(),
                });
            }
            let ends = |word: &crate::text::block::Word| match word.value {
                Value::Number { number, .. } => {
                    word.address == b'T'
                        || word.address == b'M' && matches!(number.mantissa, 2 | 30 | 98 | 99)
                }
                Value::Expression => true,
            };
            let parts =
                block.program.is_some() || block.kind != BlockKind::Words || block.words.iter().any(ends);
            if block.kind != BlockKind::Words || block.is_broken() {
                role = Role::Other;
            }
            rows.push(Row {
                span: block.span,
                role,
                words: first..words.len(),
                motions: None,
                arc,
                rapid,
                contour: false,
                sequence: block.sequence,
                parts,
            });
        }
        let mut program = Self { text, rows, words, motions, unit };
        program.match_motions();
        program.find_contours();
        Some(program)
    }

    /// Which motions each block made, where it ran in one go.
    fn match_motions(&mut self) {
        let starts: BTreeMap<u32, usize> =
            self.rows.iter().enumerate().map(|(index, row)| (row.span.start, index)).collect();
        for index in 0..self.motions.len() {
            let Some(&row) = starts.get(&self.motions.span(index).start) else { continue };
            match &mut self.rows[row].motions {
                Some((_, end)) if *end == index => *end = index + 1,
                Some(_) => {}
                none => *none = Some((index, index + 1)),
            }
        }
    }

    /// Which blocks stand in a contour that a cycle before them names.
    fn find_contours(&mut self) {
        for index in 0..self.rows.len() {
            let words = self.words_of(&self.rows[index]);
            let cycle = words.iter().any(|word| word.address == b'G' && (71.0..=73.0).contains(&word.value));
            let named =
                |address: u8| words.iter().find(|word| word.address == address).map(|word| word.value as u32);
            let (true, Some(first), Some(last)) = (cycle, named(b'P'), named(b'Q')) else { continue };
            let at = |number: u32| {
                (index + 1..self.rows.len()).find(|&row| self.rows[row].sequence == Some(number))
            };
            if let (Some(first), Some(last)) = (at(first), at(last)) {
                self.rows[first.min(last)..=last].iter_mut().for_each(|row| row.contour = true);
            }
        }
    }

    fn words_of(&self, row: &Row) -> &[Word] {
        &self.words[row.words.clone()]
    }

    fn quote(&self, word: &Word) -> String {
        word.span.quote(self.text)
    }

    fn made(&self, row: &Row) -> impl Iterator<Item = Motion> + '_ {
        let (from, to) = row.motions.unwrap_or_default();
        (from..to).map(|index| self.motions.get(index))
    }

    /// `F02`, `R05`: a zero in front of a number without a point.
    fn leading_zeros(&self) -> Vec<Diagnostic> {
        let numbers = b"XZUWRFIKCA";
        let padded = |word: &&Word| {
            let written = word.span.of(self.text);
            let digits = written[1..].iter().skip_while(|byte| matches!(byte, b' ' | b'-' | b'+'));
            let digits: Vec<u8> = digits.copied().collect();
            word.value != 0.0 && digits.len() >= 2 && digits[0] == b'0'
        };
        let bare = |word: &&Word| numbers.contains(&word.address) && word.decimals.is_none();
        let found: Vec<&Word> = self.words.iter().filter(bare).filter(padded).collect();
        // Who pads lengths more than once, `Z02`, counts on it; nobody pads a feed.
        let lengths = found.iter().filter(|word| word.address != b'F').count();
        let alone = found.into_iter().filter(|word| word.address == b'F' || lengths == 1);
        let tell = |word: &Word| {
            let written = self.quote(word);
            let zero = written.find('0').unwrap_or_default();
            let meant = format!("{}0.{}", &written[..zero], &written[zero + 1..]);
            let fix = Fix::write(word.span, meant.clone());
            let message = Message::LeadingZero { word: written, value: word.value, meant };
            Diagnostic::new(message, word.span).with(fix)
        };
        alone.map(tell).collect()
    }

    /// Words that place the tool, along either axis, with a number that is not zero.
    fn places(&self) -> impl Iterator<Item = &Word> {
        self.words.iter().filter(|word| {
            b"XZUW".contains(&word.address) && self.rows[word.block].role != Role::Other && word.value != 0.0
        })
    }

    /// A single number without a point in a program that writes points.
    fn missing_points(&self) -> Vec<Diagnostic> {
        let lengths = |word: &&Word| {
            (b"XZUWRIK".contains(&word.address)
                && self.rows[word.block].role == Role::Place
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
            let message = Message::PointMissing { word: self.quote(word), thousandths: word.value / 1000.0 };
            let told = Diagnostic::new(message, word.span);
            Diagnostic { fixes: self.with_point(word), ..told }
        };
        // A place far away is often a round number.
        let cuts = |word: &&Word| self.made(&self.rows[word.block]).any(|motion| motion.kind.cuts());
        bare.into_iter().filter(cuts).map(tell).collect()
    }

    /// The word with a point where its like have theirs, and with one at its end.
    fn with_point(&self, word: &Word) -> Vec<Fix> {
        let written = self.quote(word);
        let alike =
            self.words.iter().filter(|other| other.address == word.address && other.decimals.is_some());
        let mut counts: BTreeMap<u8, usize> = BTreeMap::new();
        for other in alike {
            *counts.entry(other.decimals.unwrap_or_default()).or_default() += 1;
        }
        let mut usual: Vec<(u8, usize)> = counts.into_iter().collect();
        usual.sort_by_key(|&(decimals, count)| (std::cmp::Reverse(count), decimals));
        let mut decimals: Vec<u8> = usual.into_iter().map(|(decimals, _)| decimals).collect();
        decimals.extend([1, 2, 3]);
        // Others have it at their end.
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

    /// Where a word leads, mm as people write it.
    fn leads_to(&self, word: &Word) -> Option<f64> {
        let value = word.value * self.unit;
        let (from, to) = self.rows[word.block].motions?;
        let start = self.motions.get(from).from;
        let place = match word.address {
            b'X' | b'Z' => Some(value),
            b'U' => Some(2.0 * start.x + value),
            b'W' => Some(start.z + value),
            _ => None,
        };
        place.filter(|_| from < to)
    }

    /// A place far beyond all others.
    fn far_off(&self) -> Vec<Diagnostic> {
        let start = if self.motions.is_empty() { Default::default() } else { self.motions.get(0).from };
        let mut told = Vec::new();
        for (axis, letters, begins) in [('X', b"XU", 2.0 * start.x.abs()), ('Z', b"ZW", start.z.abs())] {
            let mut places: Vec<(f64, &Word, bool)> = Vec::new();
            for word in self.places().filter(|word| letters.contains(&word.address)) {
                let cuts = self.made(&self.rows[word.block]).any(|motion| motion.kind.cuts());
                places.extend(self.leads_to(word).map(|place| (place, word, cuts)));
            }
            let top = places.iter().max_by(|a, b| a.0.abs().total_cmp(&b.0.abs()));
            let Some(&(place, word, cuts)) = top else { continue };
            let others = || places.iter().filter(|other| other.1.span != word.span);
            let far = |found: &mut dyn Iterator<Item = f64>| found.fold(0.0, f64::max);
            let cut = far(&mut others().filter(|other| other.2).map(|other| other.0.abs()));
            let next = far(&mut others().map(|other| other.0.abs())).max(begins);
            let cut_others = others().filter(|other| other.2).count();
            // A retreat may go farther than all cuts; a cut hardly farther than the retreat.
            let (limit, farthest) = match cuts && cut_others >= 2 {
                true => (2.0 * cut + 50.0, cut),
                false => (3.0 * next + 50.0, next),
            };
            if others().count() < 2 || place.abs() <= limit {
                continue;
            }
            let (to, farthest) = (round(place), round(farthest));
            let message = Message::FarOff { word: self.quote(word), axis, to, farthest };
            let fixes = if word.decimals.is_none() { self.with_point(word) } else { Vec::new() };
            told.push(Diagnostic { fixes, ..Diagnostic::new(message, word.span) });
        }
        told
    }

    /// The places along an axis in the order of the text, with what stands before and behind each in the same stretch.
    fn neighbours(&self, letters: &'static [u8]) -> Vec<(Option<&Word>, &Word, Option<&Word>)> {
        let own: Vec<&Word> = self.places_or_zero().filter(|word| letters.contains(&word.address)).collect();
        let together = |a: &Word, b: &Word| {
            let between = &self.rows[a.block + 1..=b.block];
            b.block > a.block && !between.iter().any(|row| row.parts)
        };
        let at = |index: Option<usize>| index.and_then(|index| own.get(index).copied());
        let mut found = Vec::new();
        for (index, &word) in own.iter().enumerate() {
            let before = at(index.checked_sub(1)).filter(|other| together(other, word));
            let behind = at(Some(index + 1)).filter(|other| together(word, other));
            found.push((before, word, behind));
        }
        found
    }

    fn places_or_zero(&self) -> impl Iterator<Item = &Word> {
        self.words
            .iter()
            .filter(|word| b"XZUW".contains(&word.address) && self.rows[word.block].role != Role::Other)
    }

    /// `Z-8`, `Z18`, `Z-24`: a Z without its minus in a row that goes one way with it.
    fn lost_minus_in_row(&self) -> Vec<Diagnostic> {
        let mut told = Vec::new();
        for (before, word, behind) in self.neighbours(b"ZW") {
            let row = &self.rows[word.block];
            let Some(before) = before else { continue };
            if word.address != b'Z'
                || word.negative
                || word.value <= 0.0
                || row.rapid
                || before.address != b'Z'
            {
                continue;
            }
            let meant = -word.value;
            let flagged =
                match behind.filter(|behind| behind.address == b'Z' && !self.rows[behind.block].rapid) {
                    // Between its neighbours with the minus, and the next one lies at −Z.
                    Some(behind) => {
                        let (low, high) = (before.value.min(behind.value), before.value.max(behind.value));
                        behind.negative && low <= meant && meant <= high && word.value > before.value + 0.001
                    }
                    // A contour leads into the work, and so does an arc.
                    None if row.contour && before.value >= 0.0 && !self.rows[before.block].contour => {
                        word.value > before.value + 0.001
                    }
                    None if row.arc && before.value.abs() < 0.001 => true,
                    // The last of a row that went on that way: no retreat goes so far.
                    None => {
                        let near = word.value <= 3.0 * before.value.abs() && word.value * self.unit >= 5.0;
                        before.negative && meant < before.value && near && !self.rows[before.block].rapid
                    }
                };
            if flagged {
                told.push(self.minus(word));
            }
        }
        told
    }

    fn minus(&self, word: &Word) -> Diagnostic {
        let written = self.quote(word);
        let meant = format!("Z-{}", written[1..].trim_start_matches([' ', '+']));
        let fix = Fix::write(word.span, meant.clone());
        Diagnostic::new(Message::MinusMissing { word: written, meant }, word.span).with(fix)
    }

    /// `X16`, `U24`, `X36`: a U whose number is a place between its neighbours, but leads beyond them.
    fn increments_in_row(&self) -> Vec<Diagnostic> {
        let mut told = Vec::new();
        let places = self.places().filter(|word| b"XZ".contains(&word.address)).count();
        let increments = self.places().filter(|word| b"UW".contains(&word.address)).count();
        if increments > 2 || places < 3 * increments {
            return told;
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
            let message = Message::IncrementalForAbsolute { word: written, axis: 'X', to, meant };
            told.push(Diagnostic::new(message, word.span).with(fix));
        }
        told
    }

    /// The Z at which cuts begin behind a rapid: in front of the work.
    fn approach(&self) -> Option<f64> {
        let mut front: Option<f64> = None;
        let mut last = MotionKind::Rapid;
        for index in 0..self.motions.len() {
            let motion = self.motions.get(index);
            if motion.kind == MotionKind::Dwell {
                continue;
            }
            if motion.kind.cuts() && last == MotionKind::Rapid {
                front = Some(front.map_or(motion.from.z, |front| front.max(motion.from.z)));
            }
            last = motion.kind;
        }
        front
    }

    /// A cut that leads away from the chuck, in front of the work: `Z20` for `Z-20`.
    fn lost_minus(&self) -> Vec<Diagnostic> {
        let mut told = Vec::new();
        let Some(front) = self.approach() else { return Vec::new() };
        // Which tools cut toward the chuck: one that never does works on the other side.
        let mut inward: BTreeMap<u16, usize> = BTreeMap::new();
        for index in 0..self.motions.len() {
            let motion = self.motions.get(index);
            if motion.kind.cuts() && motion.to.z < motion.from.z && motion.to.z < 0.0 {
                *inward.entry(motion.process.tool.0).or_default() += 1;
            }
        }
        let mut outward: BTreeMap<u16, usize> = BTreeMap::new();
        for row in self.rows.iter().filter(|row| row.role != Role::Other) {
            let Some(word) = self.words_of(row).iter().find(|word| word.address == b'Z') else { continue };
            let Some((from, to)) = row.motions else { continue };
            let place = word.value * self.unit;
            if word.negative || place <= 0.0 || !self.leads_away(from, to, place, front) {
                continue;
            }
            let tool = self.motions.get(from).process.tool.0;
            *outward.entry(tool).or_default() += 1;
            told.push((tool, self.minus(word)));
        }
        let works_outward = |tool: &u16| outward[tool] > 1 && !inward.contains_key(tool);
        told.into_iter().filter(|(tool, _)| !works_outward(tool)).map(|(_, told)| told).collect()
    }

    /// Whether the motions of a block cut toward +Z to `place`, in front of the work, where cuts begin at `front`.
    fn leads_away(&self, from: usize, to: usize, place: f64, front: f64) -> bool {
        // A corner takes off a little at the end.
        let reaches = |z: f64| (place - CORNER..=place + 0.001).contains(&z);
        let goes_there = |motion: &Motion| reaches(motion.to.z) && motion.to.z > motion.from.z + 0.001;
        let leaves = |motion: &Motion| {
            motion.cycle.is_some_and(|tag| matches!(tag.step, Step::Retract | Step::Return))
        };
        let mut motions = (from..to).map(|index| self.motions.get(index));
        let first = self.motions.get(from);
        if first.rotary.is_some() || first.virtual_move().is_some() {
            return false;
        }
        if first.cycle.is_some() {
            // The infeed of G94 leads to its Z.
            let infeed = |motion: &Motion| motion.cycle.is_some_and(|tag| tag.step == Step::Infeed);
            let away = |motion: &Motion| {
                goes_there(motion) && !leaves(motion) && (motion.kind.cuts() || infeed(motion))
            };
            return first.from.z >= -0.001 && motions.any(|motion| away(&motion));
        }
        let Some(cut) = motions.find(|motion| motion.kind.cuts() && goes_there(motion)) else { return false };
        let next = (to < self.motions.len()).then(|| self.motions.get(to));
        let goes_on = next.is_some_and(|next| next.kind.cuts());
        // Who leaves at feed goes a little way; who cuts on there cuts air.
        place - cut.from.z.max(front) > if goes_on { 3.0 } else { 10.0 }
    }

    /// A single U among places: where it leads, nothing else of the program is.
    fn increments(&self) -> Vec<Diagnostic> {
        let moves =
            |letters: &'static [u8]| self.places().filter(move |word| letters.contains(&word.address));
        let (places, increments) = (moves(b"XZ").count(), moves(b"UW").count());
        // Who counts in increments now and then means it.
        if increments == 0 || increments > 2 || places < 3 * increments {
            return Vec::new();
        }
        let mut told = Vec::new();
        for word in moves(b"U") {
            let row = &self.rows[word.block];
            let Some((from, to)) = row.motions else { continue };
            let start = self.motions.get(from).from;
            let (now, value) = (2.0 * start.x, word.value * self.unit);
            let leads = now + value;
            if word.negative || row.arc && value < 1.0 || to <= from {
                continue;
            }
            let with_place = self.words_of(row).iter().any(|other| other.address == b'Z');
            let known = |place: f64| moves(b"X").any(|other| (other.value * self.unit - place).abs() < 0.001);
            let farthest = moves(b"X").map(|other| other.value * self.unit).fold(0.0, f64::max);
            // A little out is a retract or a taper.
            let small = value <= 10.0;
            let suspicious = !known(leads) && (with_place || leads > farthest + 0.001 || known(value));
            if small || !suspicious {
                continue;
            }
            let written = self.quote(word);
            let meant = format!("X{}", &written[1..]);
            let fix = Fix::write(word.span, meant.clone());
            let message =
                Message::IncrementalForAbsolute { word: written, axis: 'X', to: round(leads), meant };
            told.push(Diagnostic::new(message, word.span).with(fix));
        }
        told
    }
}

/// To a thousandth of a millimetre.
fn round(length: f64) -> f64 {
    (1000.0 * length).round() / 1000.0
}
