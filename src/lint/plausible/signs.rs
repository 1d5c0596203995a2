//! Lint: lost minus signs, a Z that cuts away from the chuck.
//!
//! A positive Z is often intended: the tool leaves over the face, comes out of a bore, or works from the
//! chuck outwards or in the sub-spindle. `passes` has the context of a move; a minus is only reported as
//! missing if none of these explanations applies.

use crate::order;
use std::collections::{BTreeMap, BTreeSet};

use super::passes::{CENTRE, Pass};
use super::{CORNER, Program, Role, Row, Word, is_among};
use crate::geometry::Point;
use crate::message::{Diagnostic, Fix, said};
use crate::motion::{Motion, MotionKind, SpindleTurn, Step};

/// Greatest distance that a tool leaves the face at feed before the next rapid, mm.
const MAX_EXIT: f64 = 10.0;

/// Greatest distance that a tool continues beyond the place where cuts begin, mm.
const MAX_OVERRUN: f64 = 3.0;

/// Where and how the motions of a program cut.
#[derive(Default)]
struct Cuts {
    /// The Z at which cuts begin after a rapid, mm: in front of the workpiece.
    front: Option<f64>,
    /// Whether a cut is made with the spindle turning.
    turns: bool,
    /// The tools that cut towards the chuck: a tool that never does works on the other side.
    inward: BTreeSet<u16>,
}

impl Program<'_> {
    /// Reports a Z without its minus in a monotone row, as in `Z-8`, `Z18`, `Z-24`.
    pub(super) fn missing_minus_in_row(&self) -> Vec<Diagnostic> {
        let mut diagnostics = Vec::new();
        let other_frame = self.other_frame();
        for (before, word, behind) in
            self.neighbours(b"ZW").into_iter().filter(|(_, word, _)| word.block < other_frame)
        {
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
            // A rapid between two places: the second belongs to another pass.
            let in_one_go = |behind: &&Word| {
                behind.address == b'Z'
                    && !self.rows[word.block + 1..=behind.block].iter().any(|row| row.moves_at_rapid)
            };
            let flagged = match behind.filter(in_one_go) {
                // With the minus it is between its neighbours, and the next one is at −Z.
                Some(behind) => {
                    let (low, high) = (before.value.min(behind.value), before.value.max(behind.value));
                    behind.negative && low <= meant && meant <= high && word.value > before.value + 0.001
                }
                // A contour goes into the workpiece, and so does an arc.
                None if row.contour && before.value >= 0.0 && !self.rows[before.block].contour => {
                    word.value > before.value + 0.001
                }
                None if row.arc && before.value.abs() < 0.001 => {
                    !self.comes_from_behind(word) && !self.has_several_frames()
                }
                // The last of a row, which would continue in its direction: retracts are shorter.
                None => {
                    let near = word.value <= 3.0 * before.value.abs() && word.value * self.unit >= 5.0;
                    before.negative
                        && meant < before.value
                        && near
                        && !self.rows[before.block].moves_at_rapid
                        && !self.draws_back(before, word)
                }
            };
            if flagged && !self.leaves_the_face(before, word, behind) {
                diagnostics.push(self.minus(word));
            }
        }
        diagnostics
    }

    /// Whether there are two moves along Z alone and then no further cut: the tool returns along the same
    /// path.
    fn draws_back(&self, before: &Word, word: &Word) -> bool {
        let row = &self.rows[word.block];
        let along_z = |row: &Row| !self.words_of(row).iter().any(|word| is_among(b"XU", word.address));
        let cycle = row.motions.is_some_and(|(from, _)| self.motions.glance(from).is_of_cycle);
        let mut moves = self.rows[before.block..=word.block].iter().filter(|row| row.role == Role::Place);
        let next = self.rows.get(word.block + 1);
        let goes_on =
            next.is_some_and(|row| row.role == Role::Place && !row.parts && !row.rapid && !along_z(row));
        !cycle && !goes_on && moves.all(along_z)
    }

    /// Whether the last rapid along Z before a word ended on the chuck side of the face, so that the next cut
    /// goes outwards.
    fn comes_from_behind(&self, word: &Word) -> bool {
        let stretch = self.rows[..word.block].iter().rev().take_while(|row| !row.parts);
        let rapids = stretch.filter(|row| row.moves_at_rapid);
        let mut lengths =
            rapids.filter_map(|row| self.words_of(row).iter().find(|word| word.address == b'Z'));
        lengths.next().is_some_and(|length| length.negative && length.value != 0.0)
    }

    /// Whether the tool came in along the face, to the centre or to the bore of a tube, and now leaves it.
    fn leaves_the_face(&self, before: &Word, word: &Word, behind: Option<&Word>) -> bool {
        let row = &self.rows[word.block];
        let own = |address: u8| self.words_of(row).iter().find(|word| word.address == address);
        if before.value < 0.0 || row.arc {
            return false;
        }
        let x_of = |row: &Row| self.words_of(row).iter().find(|word| word.address == b'X').copied();
        let mut crossways = self.rows[..word.block].iter().rev().take_while(|row| !row.parts);
        let Some((last, at_rapid)) =
            crossways.find_map(|row| x_of(row).map(|word| (word, row.moves_at_rapid)))
        else {
            return false;
        };
        if at_rapid {
            return false;
        }
        if last.value <= 0.0 {
            return true;
        }
        let Some(first) = crossways.find_map(x_of) else { return false };
        if own(b'X').is_some() || first.value <= last.value {
            return false;
        }
        // Back to the start, rather than to the next diameter.
        let to = behind.map_or(self.rows.len(), |behind| behind.block + 1);
        let next = self.rows[word.block + 1..to].iter().find_map(x_of);
        next.is_some_and(|next| next.value >= 0.8 * first.value)
    }

    pub(super) fn minus(&self, word: &Word) -> Diagnostic {
        let written = self.quote(word);
        let meant = format!("Z-{}", written[1..].trim_start_matches([' ', '+']));
        let fix = Fix::write(word.span, meant.clone());
        Diagnostic::new(said::MinusMissing { word: written, meant }, word.span).with(fix)
    }

    /// How all motions cut, in a single pass.
    fn cuts(&self) -> Cuts {
        let mut cuts = Cuts::default();
        let mut last = MotionKind::Rapid;
        for index in 0..self.motions.len() {
            let kind = self.motions.kind(index);
            if kind.cuts() {
                let motion = self.motions.glance(index);
                if last == MotionKind::Rapid {
                    cuts.front = Some(cuts.front.map_or(motion.from.z, |front| front.max(motion.from.z)));
                }
                cuts.turns |= motion.turn != SpindleTurn::Stopped;
                if motion.to.z < motion.from.z && motion.to.z < 0.0 {
                    cuts.inward.insert(motion.station);
                }
            }
            if kind != MotionKind::Dwell {
                last = kind;
            }
        }
        cuts
    }

    /// Reports a cut away from the chuck in front of the workpiece, `Z20` instead of `Z-20`, or a cut after a
    /// rapid to such a place.
    pub(super) fn missing_minus(&self) -> Vec<Diagnostic> {
        let mut diagnostics = Vec::new();
        // Most programs have no candidates, and then the motions need not be searched.
        let may_be_lost = |(row, word, (from, to)): &(&Row, &Word, (usize, usize))| {
            let place = word.value * self.unit;
            match row.moves_at_rapid {
                true => self.plunges(*to, place),
                false => self.goes_to(*from, *to, place) && !self.faces_in_steps(row),
            }
        };
        let lengths: Vec<_> = self.positive_lengths().into_iter().filter(may_be_lost).collect();
        if lengths.is_empty() {
            return Vec::new();
        }
        let Cuts { front: Some(front), turns, inward } = self.cuts() else { return Vec::new() };
        let mut outward: BTreeMap<u16, usize> = BTreeMap::new();
        let mut pass = Pass::default();
        for (row, word, (from, to)) in lengths {
            let place = word.value * self.unit;
            pass.advance(self.motions, from);
            let first = self.motions.glance(from);
            // A bar is pulled or stopped while the spindle is stopped.
            if turns && first.turn == SpindleTurn::Stopped {
                continue;
            }
            let lost = match row.moves_at_rapid {
                true => self.is_in_air(&pass, from, place),
                false => self.leads_away(&pass, from, to, place, front),
            };
            if lost {
                let tool = first.station;
                *outward.entry(tool).or_default() += 1;
                diagnostics.push((tool, self.minus(word)));
            }
        }
        let works_outward = |tool: &u16| outward[tool] > 1 && !inward.contains(tool);
        diagnostics
            .into_iter()
            .filter(|(tool, _)| !works_outward(tool))
            .map(|(_, diagnostic)| diagnostic)
            .collect()
    }

    /// Blocks with a positive Z and their motions, in the order of execution.
    fn positive_lengths(&self) -> Vec<(&Row, &Word, (usize, usize))> {
        let rows = self.rows.iter().filter(|row| row.role != Role::Other);
        let mut found: Vec<_> = rows
            .filter_map(|row| {
                let word = self.words_of(row).iter().find(|word| word.address == b'Z')?;
                (!word.negative && word.value > 0.0).then_some((row, word, row.motions?))
            })
            .collect();
        order::by_key(&mut found, |found| found.2.0);
        found
    }

    /// Whether `Z3`, `Z2`, `Z1` of a facing cycle are steps that remove a thick sawn end.
    fn faces_in_steps(&self, row: &Row) -> bool {
        let length = |row: &Row| self.words_of(row).iter().find(|word| word.address == b'Z').copied();
        let Some(own) = length(row) else { return false };
        let behind = self.rows[own.block + 1..].iter().take_while(|row| !row.parts && !row.moves_at_rapid);
        let cycle = row.motions.is_some_and(|(from, _)| self.motions.glance(from).is_of_cycle);
        let next = behind.into_iter().find_map(length);
        cycle && next.is_some_and(|next| !next.negative && next.value < own.value)
    }

    /// Whether a rapid goes to `place`, and the tool then cuts straight in and comes out there.
    fn plunges(&self, to: usize, place: f64) -> bool {
        let last = self.motions.glance(to - 1);
        if last.kind != MotionKind::Rapid || last.is_of_cycle || (last.to.z - place).abs() > 0.001 {
            return false;
        }
        let mut behind = (to..self.motions.len()).map(|index| self.motions.get(index));
        let first = behind.find(|motion| motion.kind != MotionKind::Dwell && motion.from.x != motion.to.x);
        let plunges = |cut: Motion| {
            cut.kind.cuts()
                && !cut.process.uncertain
                && cut.cycle.is_none()
                && (cut.from.z - place).abs() <= 0.001
                && (cut.to.z - place).abs() <= 0.001
                && cut.to.x < cut.from.x
        };
        if !first.is_some_and(plunges) {
            return false;
        }
        // Straight out again, as from a groove; a chamfer at a face continues along Z.
        let out = behind.find(|motion| motion.kind != MotionKind::Dwell);
        out.is_none_or(|motion| motion.to.x > motion.from.x && (motion.to.z - place).abs() <= 0.001)
    }

    /// Whether `place` is in front of a face that was cut already.
    fn is_in_air(&self, pass: &Pass, from: usize, place: f64) -> bool {
        let Some(face) = pass.empty_beyond(self.motions.glance(from).station) else { return false };
        place > face + MAX_OVERRUN && !self.has_several_frames()
    }

    /// Whether a motion of a block goes towards +Z to `place`, apart from a corner at its end.
    fn goes_to(&self, from: usize, to: usize, place: f64) -> bool {
        (from..to)
            .map(|index| self.motions.glance(index))
            .any(|motion| leads_to(motion.from, motion.to, place))
    }

    /// The first block with G55 to G59 after the first Z word: the origin of this frame may be that of a
    /// sub-spindle.
    fn other_frame(&self) -> usize {
        let first_place = self.words.iter().find(|word| word.address == b'Z').map_or(0, |word| word.block);
        let frames =
            self.words.iter().filter(|word| word.address == b'G' && (55.0..=59.0).contains(&word.value));
        frames.map(|word| word.block).find(|&block| block > first_place).unwrap_or(usize::MAX)
    }

    /// Whether the program uses G55 to G59: the origin of another spindle may be elsewhere.
    fn has_several_frames(&self) -> bool {
        self.words.iter().any(|word| word.address == b'G' && (55.0..=59.0).contains(&word.value))
    }

    /// Whether the motions of a block cut towards +Z to `place` in front of the workpiece, where cuts begin
    /// at `front`.
    fn leads_away(&self, pass: &Pass, from: usize, to: usize, place: f64, front: f64) -> bool {
        let goes_there = |motion: &Motion| leads_to(motion.from, motion.to, place);
        let leaves = |motion: &Motion| {
            motion.cycle.is_some_and(|tag| matches!(tag.step, Step::Retract | Step::Return))
        };
        let mut motions = (from..to).map(|index| self.motions.get(index));
        let first = self.motions.get(from);
        if first.rotary.is_some() || first.virtual_move().is_some() {
            return false;
        }
        if first.cycle.is_some() {
            // The infeed of G94 goes to its Z.
            let infeed = |motion: &Motion| motion.cycle.is_some_and(|tag| tag.step == Step::Infeed);
            let away = |motion: &Motion| {
                goes_there(motion) && !leaves(motion) && (motion.kind.cuts() || infeed(motion))
            };
            return first.from.z >= -0.001 && motions.any(|motion| away(&motion));
        }
        let Some(cut) = motions.find(|motion| motion.kind.cuts() && goes_there(motion)) else { return false };
        let next = (to < self.motions.len()).then(|| self.motions.get(to));
        let goes_on = next.is_some_and(|next| next.kind.cuts());
        if pass.begins.unwrap_or(first.from).z < -0.001 || self.has_several_frames() {
            // From the chuck outwards, or in the sub-spindle.
            return false;
        }
        if let Some(before) = &pass.before {
            let comes_in = before.to.x < before.from.x && before.to.z >= -0.001;
            let drawn_back = (before.from.x - before.to.x).abs() <= 0.001
                && (cut.to.x - cut.from.x).abs() <= 0.001
                && before.to.z < before.from.z;
            let centre = if cut.center.is_some() { -0.001 } else { CENTRE };
            let to_its_start = pass.begins.is_some_and(|begins| place <= begins.z + MAX_OVERRUN);
            if drawn_back && (to_its_start || !goes_on) || comes_in && before.to.x <= centre {
                return false;
            }
            if comes_in && !goes_on && place - cut.from.z <= MAX_EXIT {
                return false;
            }
        }
        // A retract at feed is short; a longer cut there removes nothing.
        place - cut.from.z.max(front) > if goes_on { MAX_OVERRUN } else { MAX_EXIT }
    }
}

/// Whether a motion goes towards +Z to `place`, apart from a corner at its end.
fn leads_to(from: Point, to: Point, place: f64) -> bool {
    (place - CORNER..=place + 0.001).contains(&to.z) && to.z > from.z + 0.001
}
