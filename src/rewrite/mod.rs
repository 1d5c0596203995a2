//! Finds plain moves that form a single cycle, and rewrites them as that cycle.
//!
//! In: a program and its setup. Out: [`Offer`]s: the blocks, the cycle, and the edits. An offer is made only
//! if a run of the changed program makes the same motions. `places` finds blocks that are nothing but a move,
//! `shape` recognises cycles, `write` makes the edits. Independent of the language; the reverse is `expand`.

mod places;
mod shape;
mod write;

pub use places::g;

use crate::order;
use std::collections::BTreeMap;

use crate::cycles::single::Single;
use crate::message::{Diagnostic, Edit, Severity, applied, said};
use crate::motion::{Motion, MotionKind, Motions};
use crate::run::{Analysis, Run};
use crate::sentences::{Language, describe_rewrite};
use crate::setup::Setup;
use crate::setup::dialect::Dialect;
use crate::source::Span;

/// Maximum number of offers for one program.
pub const MAX_OFFERS: usize = 200;
/// Maximum total number of blocks and motions in trial runs; one trial is made whatever its length.
const MAX_WORK: usize = 2_000_000;
/// Minimum cost of one trial: a short program may still take long.
const MIN_TRIAL_COST: usize = 10_000;
/// Maximum number of rounds of applying offers.
const MAX_ROUNDS: usize = 50;
/// Tolerance for equal positions, mm.
const SAME: f64 = 1e-6;

/// Blocks that can be written as a cycle.
#[derive(Clone, Debug, PartialEq)]
pub struct Offer {
    /// From the first to the last of the blocks.
    pub span: Span,
    /// The cycle.
    pub single: Single,
    /// Its code, as the program's control writes it.
    pub code: String,
    /// Number of passes, four moves each.
    pub passes: usize,
    /// The edits, sorted by position, not overlapping.
    pub edits: Vec<Edit>,
}

impl Offer {
    /// A short description.
    pub fn title(&self, language: Language) -> String {
        describe_rewrite(&self.code, self.passes, language)
    }

    /// The blocks after the edits.
    pub fn written(&self, text: &[u8]) -> String {
        // A following block that only gets its G00 is not included.
        let inside = |edit: &&Edit| edit.span.start < self.span.end;
        let edits: Vec<Edit> = self.edits.iter().filter(inside).cloned().collect();
        let end = edits.last().map_or(0, |last| last.span.end).max(self.span.end);
        let changed = applied(&text[..end as usize], &edits);
        String::from_utf8_lossy(&changed[self.span.start as usize..]).trim().to_owned()
    }
}

/// The offers for a program, sorted by position. If there are very many candidates, those nearest to `near`
/// are tried first.
pub fn offers(text: &[u8], setup: &Setup, near: Option<Span>) -> Vec<Offer> {
    let before = traced(text, setup);
    let mut candidates = candidates(text, &before);
    let distance = |offer: &Candidate, near: Span| {
        let span = offer.offer.span;
        span.start.saturating_sub(near.end).max(near.start.saturating_sub(span.end))
    };
    if let Some(near) = near {
        order::by_key(&mut candidates, |candidate| distance(candidate, near));
    }
    let mut tries = Trials { text, setup, before: &before, left: MAX_WORK };
    let mut found = Vec::new();
    for candidate in candidates {
        if found.len() >= MAX_OFFERS || !tries.may_continue() {
            break;
        }
        let fits = |offer: &Offer, tries: &mut Trials| tries.keeps_motions(&offer.edits);
        if fits(&candidate.offer, &mut tries) {
            found.push(candidate.offer);
        } else if let Some(first) = candidate.first_alone.filter(|first| fits(first, &mut tries)) {
            found.push(first);
        }
    }
    order::by_key(&mut found, |offer| offer.span.start);
    found
}

/// The program with all offers applied, and the applied offers in order. Their spans refer to `text`, but
/// their edits to the text of their round.
pub fn rewritten(text: &[u8], setup: &Setup) -> (Vec<u8>, Vec<Offer>) {
    let (mut text, mut taken) = (text.to_vec(), Vec::new());
    let mut earlier: Vec<Vec<Edit>> = Vec::new();
    // A cycle directly after another one begins where the edits of the first end: the next round finds it.
    for _ in 0..MAX_ROUNDS {
        let before = traced(&text, setup);
        let together = apart(candidates(&text, &before).into_iter().map(|candidate| candidate.offer));
        let mut tries = Trials { text: &text, setup, before: &before, left: usize::MAX };
        let mut round = if tries.keeps_motions(&edits_of(&together)) {
            together
        } else {
            apart(offers(&text, setup, None))
        };
        if round.len() > 1 && !tries.keeps_motions(&edits_of(&round)) {
            // Each offer alone keeps the motions, but all together do not.
            round.truncate(1);
        }
        if round.is_empty() {
            break;
        }
        let edits = edits_of(&round);
        text = applied(&text, &edits);
        for mut offer in round {
            let first = |byte: u32| earlier.iter().rev().fold(byte, |byte, edits| before_edits(byte, edits));
            offer.span = Span { start: first(offer.span.start), end: first(offer.span.end) };
            taken.push(offer);
        }
        earlier.push(edits);
    }
    order::by_key(&mut taken, |offer| offer.span.start);
    (text, taken)
}

/// Filters offers, sorted by position, so that their edits do not touch.
fn apart(offers: impl IntoIterator<Item = Offer>) -> Vec<Offer> {
    let mut kept: Vec<Offer> = Vec::new();
    for offer in offers {
        let last = kept.last().and_then(|last| last.edits.last());
        if last.is_none_or(|last| offer.edits.first().is_some_and(|first| last.span.end < first.span.start)) {
            kept.push(offer);
        }
    }
    kept
}

fn edits_of(offers: &[Offer]) -> Vec<Edit> {
    offers.iter().flat_map(|offer| offer.edits.iter().cloned()).collect()
}

/// Maps a byte of the edited text to the original text; a byte in inserted text maps to the start of the
/// replaced span.
pub fn before_edits(byte: u32, edits: &[Edit]) -> u32 {
    // One past the last processed byte: in the original, and in the edited text.
    let (mut old, mut new) = (0, 0);
    for edit in edits {
        let start = new + (edit.span.start - old);
        if byte < start {
            break;
        }
        (old, new) = (edit.span.end, start + edit.text.len() as u32);
        if byte < new {
            return edit.span.start;
        }
    }
    old + (byte - new)
}

/// A possible offer, not tried yet.
struct Candidate {
    offer: Offer,
    /// Its first pass alone, if there are more.
    first_alone: Option<Offer>,
}

fn traced(text: &[u8], setup: &Setup) -> Analysis {
    let mut run = Run::new(text.to_vec(), setup.clone()).traced();
    while !run.advance(usize::MAX) {}
    run.into_analysis()
}

/// Sequences of four plain moves that look like a cycle.
fn candidates(text: &[u8], analysis: &Analysis) -> Vec<Candidate> {
    let places = places::Places::of(text, analysis);
    let dialect = Dialect::new(&analysis.setup.dialect);
    let writer = write::Writer { text, analysis, places: &places, decimal: dialect.decimal };
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(passes) = (at < places.moves.len()).then(|| shape::passes(&places.moves[at..])) {
        let moves = places.moves.get(at..at + 4 * passes.len()).unwrap_or_default();
        at += moves.len().max(1);
        if passes.is_empty() {
            continue;
        }
        let alone = || (passes.len() > 1).then(|| writer.offer(&moves[..4], &passes[..1])).flatten();
        match writer.offer(moves, &passes) {
            Some(offer) => found.push(Candidate { offer, first_alone: alone() }),
            None => found.extend(alone().map(|offer| Candidate { offer, first_alone: None })),
        }
    }
    found
}

/// Runs changed programs within the work limit.
struct Trials<'a> {
    text: &'a [u8],
    setup: &'a Setup,
    before: &'a Analysis,
    /// Blocks and motions that may still be run.
    left: usize,
}

impl Trials<'_> {
    fn may_continue(&self) -> bool {
        self.left > 0
    }

    /// Whether the program with these edits makes the same motions and gets no additional complaints.
    fn keeps_motions(&mut self, edits: &[Edit]) -> bool {
        self.left =
            self.left.saturating_sub((self.before.blocks + self.before.motions.len()).max(MIN_TRIAL_COST));
        let after = crate::analyze(&applied(self.text, edits), self.setup);
        self.before.codes == after.codes
            && same_motions(&self.before.motions, &after.motions)
            && has_no_new_complaints(self.before, &after)
    }
}

/// Whether two programs make the same motions: kinds, end points, feeds, spindle and tool, in the same order,
/// with the same stops.
pub fn same_motions(before: &Motions, after: &Motions) -> bool {
    before.has_same_chunks(after) || first_other_motion(before, after, SAME).is_none()
}

/// The first motion that is not the same; the number of motions if only a stop or their number differs. Places are the
/// same within `tolerance`, mm.
pub fn first_other_motion(before: &Motions, after: &Motions, tolerance: f64) -> Option<usize> {
    let stops = |motions: &Motions| -> Vec<_> {
        motions.stops(0..motions.len()).map(|(index, stop)| (index, stop.kind)).collect()
    };
    let is_same = |(before, after): (Motion, Motion)| same_motion(&before, &after, tolerance);
    let other = before.iter().zip(after.iter()).position(|motions| !is_same(motions));
    let count = before.len();
    other.or_else(|| (count != after.len() || stops(before) != stops(after)).then_some(count))
}

fn same_motion(before: &Motion, after: &Motion, tolerance: f64) -> bool {
    let near = |a: crate::geometry::Point, b: crate::geometry::Point| a.distance(b) <= tolerance;
    let both = |a: Option<_>, b: Option<_>| a.zip(b).map_or(a.is_none() == b.is_none(), |(a, b)| near(a, b));
    let feeds = before.kind.cuts() && before.kind != MotionKind::Thread;
    let lead = |motion: &Motion| motion.lead.filter(|_| motion.kind == MotionKind::Thread);
    let same_lead = match (lead(before), lead(after)) {
        (Some(a), Some(b)) => (a - b).abs() <= SAME,
        (a, b) => a == b,
    };
    // The feed in force does not affect a rapid.
    let process = |motion: &Motion| {
        let mut process = motion.process;
        if !feeds {
            process.feed = crate::motion::Feed::Unset;
        }
        process
    };
    before.kind == after.kind
        && near(before.from, after.from)
        && near(before.to, after.to)
        && both(before.center, after.center)
        && same_lead
        && before.start_angle == after.start_angle
        && before.seconds == after.seconds
        && before.rotary == after.rotary
        && before.programmed.is_some() == after.programmed.is_some()
        && process(before) == process(after)
}

/// Whether the changed program has no additional complaints.
pub fn has_no_new_complaints(before: &Analysis, after: &Analysis) -> bool {
    let count = |analysis: &Analysis| {
        let mut told = BTreeMap::new();
        for found in analysis.diagnostics.iter().filter(|found| counts(found)) {
            *told.entry((found.message.slug(), found.severity)).or_insert(0) += 1;
        }
        told
    };
    let known = count(before);
    count(after).iter().all(|(what, times)| known.get(what).is_some_and(|before| before >= times))
}

/// Whether an additional message is an objection to the cycle. A cone that becomes narrower toward the chuck
/// is not: the plain moves had the same shape, but could not be checked for it.
fn counts(found: &Diagnostic) -> bool {
    found.severity >= Severity::Warning && !found.message.is::<said::TaperNarrows>()
}
