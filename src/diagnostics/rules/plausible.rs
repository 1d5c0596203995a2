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

/// Remarks about the numbers of a program of no more than `blocks` blocks; none of a longer one. Of a program that is not
/// `sound` (a block was not carried out) only the writing is looked at: its motions are not what was meant.
pub fn remarks(text: &[u8], motions: &Motions, sound: bool, blocks: usize) -> Vec<Diagnostic> {
    let Some(program) = Program::read(text, motions, blocks) else { return Vec::new() };
    let mut told = program.leading_zeros();
    told.extend(program.missing_points());
    if sound {
        told.extend(program.far_off());
        told.extend(program.lost_minus());
        told.extend(program.increments());
    }
    // One fault, one message: what was told first of a word stays.
    let mut seen = Vec::new();
    told.retain(|one| {
        let new = !seen.contains(&one.span);
        seen.push(one.span);
        new
    });
    told
}

const MULTIPLE: std::ops::RangeInclusive<u64> = 70..=76;
/// G04, G10, G28, G30, G50, G52, G53, G65, G66.
const SETTINGS: [u64; 9] = [4, 10, 28, 30, 50, 52, 53, 65, 66];

impl<'a> Program<'a> {
    fn read(text: &'a [u8], motions: &'a Motions, most: usize) -> Option<Self> {
        let mut parser = Parser::new(text);
        let mut block = Block::default();
        let (mut rows, mut words) = (Vec::new(), Vec::new());
        let mut inch = false;
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
                        code if MULTIPLE.contains(&code) => role = Role::Other,
                        2 | 3 => arc = true,
                        20 => inch = true,
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
            if block.kind != BlockKind::Words || block.is_broken() {
                role = Role::Other;
            }
            rows.push(Row { span: block.span, role, words: first..words.len(), motions: None, arc });
        }
        let mut program = Self { text, rows, words, motions, unit: if inch { 25.4 } else { 1.0 } };
        program.match_motions();
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
        let mut told = Vec::new();
        for word in
            self.words.iter().filter(|word| numbers.contains(&word.address) && word.decimals.is_none())
        {
            let written = self.quote(word);
            let digits = written[1..].trim_start_matches([' ', '-', '+']);
            if word.value == 0.0 || digits.len() < 2 || !digits.starts_with('0') {
                continue;
            }
            let head = &written[..written.len() - digits.len()];
            let meant = format!("{head}0.{}", &digits[1..]);
            let fix = Fix::write(word.span, meant.clone());
            let message = Message::LeadingZero { word: written, value: word.value, meant };
            told.push(Diagnostic::new(message, word.span).with(fix));
        }
        // Who writes `X05 Z010` throughout counts on it.
        if told.len() > 3 && 4 * told.len() > self.words.len() / 3 { Vec::new() } else { told }
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
        bare.into_iter().map(tell).collect()
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

    /// Along X (twice the radius) and Z: how far all motions of a block go, mm.
    fn reach(&self, row: &Row) -> Option<(f64, f64)> {
        let ends = self.made(row).filter(|motion| motion.rotary.is_none());
        let far = |reach: (f64, f64), motion: Motion| {
            (reach.0.max(2.0 * motion.to.x.abs()), reach.1.max(motion.to.z.abs()))
        };
        row.motions.map(|_| ends.fold((0.0, 0.0), far))
    }

    /// A place far beyond all others.
    fn far_off(&self) -> Vec<Diagnostic> {
        let start = (self.motions.len() > 0).then(|| self.motions.get(0).from);
        let start = start.map_or((0.0, 0.0), |from| (2.0 * from.x.abs(), from.z.abs()));
        let reaches: Vec<Option<(f64, f64)>> = self.rows.iter().map(|row| self.reach(row)).collect();
        let mut told = Vec::new();
        for (axis, letters) in [('X', b"XU"), ('Z', b"ZW")] {
            let along = |reach: (f64, f64)| if axis == 'X' { reach.0 } else { reach.1 };
            // The farthest two blocks: who stands alone at the top is far off.
            let mut blocks: Vec<(f64, usize)> = Vec::new();
            for (index, row) in self.rows.iter().enumerate() {
                let Some(reach) = reaches[index].map(along) else { continue };
                let named = self.words_of(row).iter().any(|word| letters.contains(&word.address));
                if named && row.role != Role::Other {
                    blocks.push((reach, index));
                }
            }
            blocks.sort_by(|a, b| b.0.total_cmp(&a.0));
            let Some(&(reach, top)) = blocks.first() else { continue };
            let others: Vec<f64> =
                blocks.iter().filter(|other| other.1 != top).map(|other| other.0).collect();
            if others.len() < 2 {
                continue;
            }
            let next = others.iter().copied().fold(along(start), f64::max);
            let row = &self.rows[top];
            let cuts = self.made(row).any(|motion| motion.kind.cuts());
            // A retreat may go farther than all cuts; a cut hardly farther than the retreat.
            let cut_beyond = others_cut(self, top, &reaches, along);
            let (limit, farthest) = match cut_beyond {
                Some(cut) if cuts => (2.0 * cut + 20.0, cut),
                _ => (3.0 * next + 50.0, next),
            };
            if reach <= limit {
                continue;
            }
            let word = self.words_of(row).iter().find(|word| letters.contains(&word.address));
            let Some(word) = word else { continue };
            let message = Message::FarOff {
                word: self.quote(word),
                axis,
                to: round(reach * word.value.signum()),
                farthest: round(farthest),
            };
            let fixes = if word.decimals.is_none() { self.with_point(word) } else { Vec::new() };
            told.push(Diagnostic { fixes, ..Diagnostic::new(message, word.span) });
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
        let Some(front) = self.approach() else { return told };
        let cuts_inward = |index: usize| {
            let motion = self.motions.get(index);
            motion.kind.cuts() && motion.to.z < motion.from.z && motion.to.z < 0.0
        };
        let inward = (0..self.motions.len()).filter(|&index| cuts_inward(index)).count();
        for row in self.rows.iter().filter(|row| row.role != Role::Other) {
            let Some(word) = self.words_of(row).iter().find(|word| word.address == b'Z') else { continue };
            if word.negative || word.value <= 0.0 {
                continue;
            }
            let Some((from, to)) = row.motions else { continue };
            let cycle = self.motions.get(from).cycle.is_some();
            let place = word.value * self.unit;
            let cut = (from..to).map(|index| self.motions.get(index)).find(|motion| {
                motion.kind.cuts()
                    && (motion.to.z - place).abs() < 0.001
                    && motion.to.z > motion.from.z + 0.001
                    && !motion
                        .cycle
                        .is_some_and(|tag| matches!(tag.step, Step::Retract | Step::Return | Step::PullOut))
            });
            let facing = cycle
                && self.made(row).any(|motion| {
                    motion.cycle.is_some_and(|tag| tag.step == Step::Infeed)
                        && (motion.to.z - place).abs() < 0.001
                        && motion.to.z > motion.from.z + 0.001
                });
            let start = self.motions.get(from).from.z;
            let flagged = match cut {
                Some(_) if cycle => start >= -0.001 || place > 0.001,
                Some(motion) => {
                    let next = (to < self.motions.len()).then(|| self.motions.get(to));
                    let goes_on = next.is_some_and(|next| next.kind.cuts());
                    let beyond = place - motion.from.z.max(front);
                    // Who never cuts toward the chuck has another zero point.
                    (inward > 0 || motion.from.z >= front - 0.001)
                        && beyond > if goes_on { 0.5 } else { 10.0 }
                }
                None => facing && start >= -0.001,
            };
            if !flagged {
                continue;
            }
            let written = self.quote(word);
            let meant = format!("Z-{}", written[1..].trim_start_matches([' ', '+']));
            let fix = Fix::write(word.span, meant.clone());
            told.push(Diagnostic::new(Message::MinusMissing { word: written, meant }, word.span).with(fix));
        }
        // Who does so everywhere has the work on the other side.
        if told.len() > 2 && told.len() > inward { Vec::new() } else { told }
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
            let small = value <= 10.0 && !with_place;
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

/// How far the cuts of all other blocks go.
fn others_cut(
    program: &Program,
    top: usize,
    reaches: &[Option<(f64, f64)>],
    along: impl Fn((f64, f64)) -> f64,
) -> Option<f64> {
    let others = program
        .rows
        .iter()
        .enumerate()
        .filter(|(index, row)| *index != top && program.made(row).any(|motion| motion.kind.cuts()));
    others.filter_map(|(index, _)| reaches[index]).map(along).reduce(f64::max)
}

/// To a thousandth of a millimetre.
fn round(length: f64) -> f64 {
    (1000.0 * length).round() / 1000.0
}
