//! Finds unchanged blocks with different motions, and the text change that is the cause.
//!
//! In: the unchanged blocks, their motions in both versions, and the changed blocks. Out: a [`Later`] for
//! each changed range. A block is attributed to the nearest earlier change of an address that can affect the
//! difference: F for the feed, T for the tool. A cycle is attributed to a change of its contour, wherever it
//! is in the text. This is inferred from the text, not tried.

use super::align::Stretch;
use super::moves::{Change, Moves, changes};
use super::written::{Keys, Written};
use super::{Hunk, Row};

/// Unchanged blocks with different motions.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Later {
    /// Their number.
    pub blocks: usize,
    /// The first block for each kind of change, in order.
    pub rows: Vec<Row>,
}

impl Later {
    fn add(&mut self, row: impl Fn(Vec<Change>) -> Row, own: Vec<Change>) {
        self.blocks += 1;
        let told = |change: &Change| {
            let known = self.rows.iter().flat_map(|row| &row.changes);
            known.map(std::mem::discriminant).any(|kind| kind == std::mem::discriminant(change))
        };
        let fresh: Vec<Change> = own.into_iter().filter(|change| !told(change)).collect();
        if !fresh.is_empty() {
            self.rows.push(row(fresh));
        }
    }
}

/// The data for the attribution.
pub(super) struct Places<'a> {
    /// The blocks of both texts.
    pub texts: &'a [Written; 2],
    /// The ranges that differ.
    pub stretches: &'a [Stretch],
    /// The words of the blocks.
    pub keys: &'a Keys,
}

/// Adds each unchanged block with different motions to the hunk that caused it, or to `unexplained`.
pub(super) fn follow(
    places: &Places,
    partners: &[[usize; 2]],
    moves: &[Moves; 2],
    hunks: &mut [Hunk],
    unexplained: &mut Later,
) {
    let touched: Vec<Touched> = places.stretches.iter().map(|stretch| Touched::of(stretch, places)).collect();
    // For each kind of change, the last range before the block that can be its cause.
    let (mut before, mut last) = (0, [None; CAUSES]);
    for &[first, second] in partners {
        while places.stretches.get(before).is_some_and(|stretch| stretch.blocks[1].start <= second) {
            let own = &touched[before];
            for (_, last) in last.iter_mut().enumerate().filter(|(cause, _)| own.can_cause(*cause)) {
                *last = Some(before);
            }
            before += 1;
        }
        let own = changes(&moves[0].block(first), &moves[1].block(second));
        if own.is_empty() {
            continue;
        }
        let of_cycle = OfCycle::of(places, [first, second]);
        let mut causes: Vec<(Option<usize>, Vec<Change>)> = Vec::new();
        for change in own {
            let cause = of_cycle.cause(&change).or(last[cause_of(&change)]).or(last[CAUSES - 1]);
            match causes.iter_mut().find(|(known, _)| *known == cause) {
                Some((_, changes)) => changes.push(change),
                None => causes.push((cause, vec![change])),
            }
        }
        let blocks = [Some(places.texts[0].place(first)), Some(places.texts[1].place(second))];
        for (cause, own) in causes {
            let later = cause.map_or(&mut *unexplained, |hunk| &mut hunks[hunk].later);
            later.add(|changes| Row { blocks, changes }, own);
        }
    }
}

/// Number of kinds of causes: addresses of feed, spindle, tool, path; any word; any text.
const CAUSES: usize = 6;

/// The addresses of each kind of cause.
const ADDRESSES: [&[u8]; CAUSES] = [
    b"FG",
    b"SGM",
    b"TG",
    b"XZUWCYHVRIJKABPQDELOGTM,",
    b"ABCDEFGHIJKLMNOPQRSTUVWXYZ,/",
    b"ABCDEFGHIJKLMNOPQRSTUVWXYZ,/(%",
];

/// Index of the cause "path".
const PATH: usize = 3;

fn cause_of(change: &Change) -> usize {
    match change {
        Change::Feed(_) => 0,
        Change::Speed(_) | Change::Highest(_) | Change::Turn(_) => 1,
        Change::Tool(_) => 2,
        Change::Moves(_)
        | Change::Cycle(_)
        | Change::Passes(..)
        | Change::Motions(_)
        | Change::Kind(_)
        | Change::End(_)
        | Change::Radius(_)
        | Change::Way
        | Change::Lead(_)
        | Change::Dwell(_) => PATH,
    }
}

/// The first letters of the words that a range changes.
struct Touched([bool; 256]);

impl Touched {
    fn of(stretch: &Stretch, places: &Places) -> Self {
        let mut letters = [false; 256];
        for [first, second] in &stretch.pairs {
            let number =
                |side: usize, block: &Option<usize>| block.map(|block| places.texts[side].numbers[block]);
            let [first, second] = [number(0, first), number(1, second)];
            for (own, other) in [(first, second), (second, first)] {
                let words = own.map(|own| places.keys.words(own)).into_iter().flatten();
                for word in words {
                    let is_common =
                        other.is_some_and(|other| places.keys.words(other).any(|other| other == word));
                    if !is_common {
                        letters[usize::from(word[0])] = true;
                    }
                }
            }
        }
        // A macro statement can change anything.
        if letters[usize::from(b'#')] {
            ADDRESSES[CAUSES - 2].iter().for_each(|&letter| letters[usize::from(letter)] = true);
        }
        Self(letters)
    }

    fn can_cause(&self, cause: usize) -> bool {
        ADDRESSES[cause].iter().any(|&letter| self.0[usize::from(letter)])
    }
}

/// Causes specific to a cycle along a contour.
#[derive(Default)]
struct OfCycle {
    /// The range that changes its contour (ns to nf).
    contour: Option<usize>,
    /// The range that changes the block above, which contains the depth of cut.
    above: Option<usize>,
}

impl OfCycle {
    fn of(places: &Places, blocks: [usize; 2]) -> Self {
        let words = |side: usize| places.keys.words(places.texts[side].numbers[blocks[side]]);
        if !words(0).any(|word| matches!(word, b"G70" | b"G71" | b"G72" | b"G73")) {
            return Self::default();
        }
        let changed = |side: usize, from: usize, to: usize| {
            let is_before = |stretch: &Stretch| {
                let own = &stretch.blocks[side];
                own.end.max(own.start + 1) <= from
            };
            let first = places.stretches.partition_point(is_before);
            places.stretches.get(first).filter(|stretch| stretch.blocks[side].start <= to).map(|_| first)
        };
        let contour = |side: usize| {
            let block = |address: u8| {
                let digits = words(side).find_map(|word| word.strip_prefix(&[address]))?;
                places.texts[side].sequence(std::str::from_utf8(digits).ok()?.parse().ok()?)
            };
            changed(side, block(b'P')?, block(b'Q')?)
        };
        let above = blocks[1].checked_sub(1).and_then(|above| changed(1, above, above));
        Self { contour: contour(0).or_else(|| contour(1)), above }
    }

    fn cause(&self, change: &Change) -> Option<usize> {
        match change {
            Change::Passes(..) => self.above.or(self.contour),
            _ if cause_of(change) == PATH => self.contour,
            _ => None,
        }
    }
}
