//! Plain moves that form a single cycle, written as that cycle.
//!
//! In: a program and its setup. Out: [`Offer`]s: the blocks, the cycle, and the edits that write them so. An
//! offer is made only once the changed program has been run and made the same motions. `places` says which
//! blocks are nothing but a move, `shape` which moves are a cycle, `write` what is written. Knows no
//! language; the reverse is `expand`.

mod places;
mod shape;
mod write;

use crate::order;
use std::collections::BTreeMap;

use crate::cycles::single::Single;
use crate::message::{Diagnostic, Edit, Severity, said};
use crate::motion::{Motion, MotionKind, Motions};
use crate::run::{Analysis, Run};
use crate::sentences::{Language, describe_rewrite};
use crate::setup::Setup;
use crate::setup::dialect::Dialect;
use crate::source::Span;

/// Most offers for one program.
pub const MOST_OFFERS: usize = 200;
/// Most blocks and motions of changed programs that are tried, together; one is tried however long it is.
const MOST_WORK: usize = 2_000_000;
/// What one try counts at least: a short program may still take its time.
const LEAST_WORK: usize = 10_000;
/// Most rounds of taking offers.
const MOST_ROUNDS: usize = 50;
/// Motions nearer than this are the same, mm.
const SAME: f64 = 1e-6;

/// Blocks that can be written as a cycle.
#[derive(Clone, Debug, PartialEq)]
pub struct Offer {
    /// From the first of the blocks to the last.
    pub span: Span,
    /// Which cycle.
    pub single: Single,
    /// Its code, as the program's control writes it.
    pub code: String,
    /// Passes, four moves each.
    pub passes: usize,
    /// The edits, in order of place, not overlapping.
    pub edits: Vec<Edit>,
}

impl Offer {
    /// What it does, in a few words.
    pub fn title(&self, language: Language) -> String {
        describe_rewrite(&self.code, self.passes, language)
    }

    /// The blocks as they are written then.
    pub fn written(&self, text: &[u8]) -> String {
        // A following block that only gets its G00 is none of them.
        let inside = |edit: &&Edit| edit.span.start < self.span.end;
        let edits: Vec<Edit> = self.edits.iter().filter(inside).cloned().collect();
        let end = edits.last().map_or(0, |last| last.span.end).max(self.span.end);
        let changed = applied(&text[..end as usize], &edits);
        String::from_utf8_lossy(&changed[self.span.start as usize..]).trim().to_owned()
    }
}

/// The offers for a program, in order of place. Those nearest to `near` are tried first,
/// where there are very many.
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
    let mut tries = Tries { text, setup, before: &before, left: MOST_WORK };
    let mut found = Vec::new();
    for candidate in candidates {
        if found.len() >= MOST_OFFERS || !tries.may_go_on() {
            break;
        }
        let fits = |offer: &Offer, tries: &mut Tries| tries.keeps(&offer.edits);
        if fits(&candidate.offer, &mut tries) {
            found.push(candidate.offer);
        } else if let Some(first) = candidate.first_alone.filter(|first| fits(first, &mut tries)) {
            found.push(first);
        }
    }
    order::by_key(&mut found, |offer| offer.span.start);
    found
}

/// The program with all offers taken, and what was taken, in order: the blocks of this program, which the
/// edits of a later round do not know.
pub fn rewritten(text: &[u8], setup: &Setup) -> (Vec<u8>, Vec<Offer>) {
    let (mut text, mut taken) = (text.to_vec(), Vec::new());
    let mut earlier: Vec<Vec<Edit>> = Vec::new();
    // A cycle that follows another one at once begins where the first one's edits end: it
    // is found in the next round.
    for _ in 0..MOST_ROUNDS {
        let before = traced(&text, setup);
        let together = apart(candidates(&text, &before).into_iter().map(|candidate| candidate.offer));
        let mut tries = Tries { text: &text, setup, before: &before, left: usize::MAX };
        let mut round =
            if tries.keeps(&edits_of(&together)) { together } else { apart(offers(&text, setup, None)) };
        if round.len() > 1 && !tries.keeps(&edits_of(&round)) {
            // Each alone keeps the motions, and all together do not.
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

/// Those offers, in order of place, whose edits do not touch those of the one before.
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

/// A text with edits, which are in order of place and do not overlap.
pub fn applied(text: &[u8], edits: &[Edit]) -> Vec<u8> {
    let mut changed = Vec::with_capacity(text.len());
    let mut from = 0;
    for edit in edits {
        changed.extend_from_slice(&text[from..edit.span.start as usize]);
        changed.extend_from_slice(edit.text.as_bytes());
        from = edit.span.end as usize;
    }
    changed.extend_from_slice(&text[from..]);
    changed
}

/// Where a byte of a text with edits was before them; the start of what an edit took out
/// for a byte that it put in.
pub fn before_edits(byte: u32, edits: &[Edit]) -> u32 {
    // One past the last byte that was looked at: before the edits, and after them.
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

/// What may become an offer, once it was tried.
struct Candidate {
    offer: Offer,
    /// Its first pass alone, where there are more.
    first_alone: Option<Offer>,
}

fn traced(text: &[u8], setup: &Setup) -> Analysis {
    let mut run = Run::new(text.to_vec(), setup.clone()).traced();
    while !run.advance(usize::MAX) {}
    run.into_analysis()
}

/// Rows of four plain moves that look like a cycle.
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

/// Runs changed programs, as many as there is time for.
struct Tries<'a> {
    text: &'a [u8],
    setup: &'a Setup,
    before: &'a Analysis,
    /// Blocks and motions that may still be run.
    left: usize,
}

impl Tries<'_> {
    fn may_go_on(&self) -> bool {
        self.left > 0
    }

    /// Whether the program with these edits makes the same motions, and no control would object to it more.
    fn keeps(&mut self, edits: &[Edit]) -> bool {
        self.left =
            self.left.saturating_sub((self.before.blocks + self.before.motions.len()).max(LEAST_WORK));
        let after = crate::analyze(&applied(self.text, edits), self.setup);
        self.before.codes == after.codes
            && same_motions(&self.before.motions, &after.motions)
            && complains_no_more(self.before, &after)
    }
}

/// Whether two programs make the same motions: kinds, ends, feeds, spindle and tool, in the same
/// order, with the same stops.
pub fn same_motions(before: &Motions, after: &Motions) -> bool {
    let stops = |motions: &Motions| -> Vec<_> {
        motions.stops(0..motions.len()).map(|(index, stop)| (index, stop.kind)).collect()
    };
    before.len() == after.len()
        && before.iter().zip(after.iter()).all(|(before, after)| same_motion(&before, &after))
        && stops(before) == stops(after)
}

fn same_motion(before: &Motion, after: &Motion) -> bool {
    let near = |a: crate::geometry::Point, b: crate::geometry::Point| a.distance(b) <= SAME;
    let both = |a: Option<_>, b: Option<_>| a.zip(b).map_or(a.is_none() == b.is_none(), |(a, b)| near(a, b));
    let feeds = before.kind.cuts() && before.kind != MotionKind::Thread;
    let lead = |motion: &Motion| motion.lead.filter(|_| motion.kind == MotionKind::Thread);
    let same_lead = match (lead(before), lead(after)) {
        (Some(a), Some(b)) => (a - b).abs() <= SAME,
        (a, b) => a == b,
    };
    // What feed is in force during a rapid makes no difference to it.
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

/// Whether nothing is wrong in a program that was not wrong before.
fn complains_no_more(before: &Analysis, after: &Analysis) -> bool {
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

/// Whether a message that only the cycle brings contradicts it. That its cone becomes narrower toward the
/// chuck was so before, when nobody could say it.
fn counts(found: &Diagnostic) -> bool {
    found.severity >= Severity::Warning && !found.message.is::<said::TaperNarrows>()
}
