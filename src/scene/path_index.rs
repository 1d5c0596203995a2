//! An index over the path: boxes around short stretches of the motions.
//!
//! In: the motion list, whole or as it grows and is edited. Out: [`PathIndex`], so that a picture of a
//! million motions can skip what is out of view without walking all of it. A stretch lies within one chunk and is measured once: an edit moves those of the chunks that
//! stayed. Knows nothing of pixels.

use std::ops::Range;
use std::sync::atomic::{AtomicU64, Ordering};

use crate::motion::{Chunk, Motions};
use crate::source::Span;

use super::{StrokeShape, StrokeStyle};
use crate::geometry::bounds::{Bounds, join};

/// Most motions in a stretch.
pub const STRETCH: usize = 1024;

/// Some successive motions.
#[derive(Clone, Debug, PartialEq)]
pub struct Stretch {
    /// Which motions, over all motions.
    pub motions: Range<usize>,
    /// Box around everything that cuts or waits.
    pub cuts: Option<Bounds>,
    /// Box around where the rapids end.
    pub rapids: Option<Bounds>,
    /// Box around all strokes.
    pub bounds: Bounds,
    /// Bytes from the first to the last of the blocks that made them.
    pub span: Span,
    /// Distinguishes it from every other stretch of this process; it keeps it as long as
    /// its motions are the same.
    pub key: StretchKey,
    /// Which of the chunks it lies in.
    chunk: usize,
    /// Base of that chunk when the span was worked out.
    base: u32,
}

/// The id of a chunk, and which of its motions is the first of a stretch.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StretchKey {
    chunk: u64,
    first: usize,
}

/// Boxes around all motions.
#[derive(Clone, Debug)]
pub struct PathIndex {
    /// Changes with the motions, so that a cache can detect that it is stale.
    id: u64,
    stretches: Vec<Stretch>,
    /// Those of chunks that are not in the list just now.
    gone: Vec<Stretch>,
}

impl Default for PathIndex {
    fn default() -> Self {
        Self::new()
    }
}

impl PathIndex {
    /// The path index of no motions.
    pub fn new() -> Self {
        Self { id: next_id(), stretches: Vec::new(), gone: Vec::new() }
    }

    /// The path index of all of `motions`.
    pub fn of(motions: &Motions) -> Self {
        let mut path_index = Self::new();
        path_index.update(motions);
        path_index
    }

    /// Follows `motions` as they grew or were edited; only chunks that are new are measured. Those that are
    /// gone may come back after the ones that are run again, until [`PathIndex::settle`].
    pub fn update(&mut self, motions: &Motions) {
        let ids = motions.ids();
        let changed = self.stretches.last().map_or(0, |last| last.chunk + 1) != ids.len()
            || self.stretches.iter().any(|stretch| ids[stretch.chunk] != stretch.key.chunk);
        if changed {
            self.id = next_id();
        }
        let mut known = std::mem::take(&mut self.stretches);
        known.append(&mut self.gone);
        let newest = known.iter().map(|stretch| stretch.key.chunk).max();
        let mut known: Vec<Option<Stretch>> = known.into_iter().map(Some).collect();
        let mut next = 0;
        for (index, (chunk, &id)) in motions.chunks().iter().zip(ids).enumerate() {
            // Identifiers grow, so a newer one need not be looked for; chunks that stay keep their order.
            let is_of = |stretch: &Option<Stretch>| stretch.as_ref().is_some_and(|s| s.key.chunk == id);
            if newest.is_some_and(|newest| id <= newest) {
                next += known[next..].iter().position(is_of).unwrap_or(0);
            }
            let before = motions.before()[index];
            for first in (0..chunk.len()).step_by(STRETCH) {
                let own = first..chunk.len().min(first + STRETCH);
                let mut stretch =
                    match known.get_mut(next).filter(|stretch| is_of(stretch)).and_then(Option::take) {
                        Some(stretch) => {
                            next += 1;
                            stretch
                        }
                        None => measure(chunk, own.clone(), StretchKey { chunk: id, first }),
                    };
                stretch.motions = before + own.start..before + own.end;
                stretch.move_to(index, chunk.base);
                self.stretches.push(stretch);
            }
        }
        self.gone = known.into_iter().flatten().collect();
    }

    /// No chunk that is gone will come back: the run has ended.
    pub fn settle(&mut self) {
        self.gone.clear();
    }

    /// A number that no path index of other motions has.
    pub fn id(&self) -> u64 {
        self.id
    }

    /// Number of motions taken in.
    pub fn len(&self) -> usize {
        self.stretches.last().map_or(0, |last| last.motions.end)
    }

    /// Whether no motion was taken in.
    pub fn is_empty(&self) -> bool {
        self.stretches.is_empty()
    }

    /// The stretches, in order.
    pub fn stretches(&self) -> &[Stretch] {
        &self.stretches
    }

    /// The stretch a motion belongs to.
    pub fn stretch_of(&self, motion: usize) -> Option<&Stretch> {
        self.stretches.get(self.stretches.partition_point(|stretch| stretch.motions.end <= motion))
    }

    /// Box around everything that cuts or waits.
    pub fn cuts(&self) -> Option<Bounds> {
        self.stretches.iter().fold(None, |bounds, stretch| join(bounds, stretch.cuts))
    }

    /// Box around all strokes.
    pub fn bounds(&self) -> Option<Bounds> {
        self.stretches.iter().fold(None, |bounds, stretch| join(bounds, Some(stretch.bounds)))
    }

    /// Box around where the rapids end.
    pub fn rapids(&self) -> Option<Bounds> {
        self.stretches.iter().fold(None, |bounds, stretch| join(bounds, stretch.rapids))
    }

    /// The chunk a motion lies in and its index there; past the end no chunk.
    pub(super) fn locate(&self, motion: usize) -> (usize, usize) {
        match self.stretch_of(motion) {
            Some(stretch) => (stretch.chunk, stretch.key.first + motion - stretch.motions.start),
            None => (usize::MAX, 0),
        }
    }
}

impl Stretch {
    /// Which of the chunks it lies in, and which of its motions those are.
    pub fn in_chunk(&self) -> (usize, Range<usize>) {
        (self.chunk, self.key.first..self.key.first + self.motions.len())
    }

    /// The same motions in a chunk that was moved along.
    fn move_to(&mut self, chunk: usize, base: u32) {
        let moved = base.wrapping_sub(self.base);
        self.span.start = self.span.start.wrapping_add(moved);
        self.span.end = self.span.end.wrapping_add(moved);
        (self.chunk, self.base) = (chunk, base);
    }
}

fn next_id() -> u64 {
    static NEXT: AtomicU64 = AtomicU64::new(0);
    NEXT.fetch_add(1, Ordering::Relaxed)
}

/// Measures some motions of a chunk; where they stand among all motions is left open.
fn measure(chunk: &Chunk, motions: Range<usize>, key: StretchKey) -> Stretch {
    let (mut cuts, mut rapids, mut bounds) = (None, None, None);
    let mut span = chunk.span(motions.start);
    for at in motions.clone() {
        let shape = StrokeShape::in_chunk(chunk, at);
        let own = shape.bounds();
        match StrokeStyle::of(chunk.kind(at)) {
            StrokeStyle::Rapid => add(&mut rapids, Bounds::of(shape.end())),
            StrokeStyle::Dwell | StrokeStyle::Feed | StrokeStyle::Thread => add(&mut cuts, own),
        }
        add(&mut bounds, own);
        span = span.to(chunk.span(at));
    }
    Stretch {
        motions,
        cuts,
        rapids,
        bounds: bounds.unwrap_or(Bounds::of(Default::default())),
        span,
        key,
        chunk: 0,
        base: chunk.base,
    }
}

fn add(bounds: &mut Option<Bounds>, own: Bounds) {
    *bounds = join(*bounds, Some(own));
}
