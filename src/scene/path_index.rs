//! An index of the path: bounding boxes of short stretches of the motions.
//!
//! In: the motion list, complete or while it grows and is edited. Out: [`PathIndex`], so that a picture of a
//! million motions can skip invisible ones without visiting all of them. A stretch lies within one chunk and
//! is measured once; an edit shifts the stretches of unchanged chunks. Knows nothing of pixels.

use std::ops::Range;
use std::sync::atomic::{AtomicU64, Ordering};

use crate::motion::{Chunk, Motions};
use crate::source::Span;

use super::{StrokeShape, StrokeStyle};
use crate::geometry::bounds::{Bounds, join};

/// Maximum number of motions in a stretch.
pub const STRETCH: usize = 1024;

/// A stretch of successive motions.
#[derive(Clone, Debug, PartialEq)]
pub struct Stretch {
    /// The motions, as indices over all motions.
    pub motions: Range<usize>,
    /// Bounding box of all cuts and dwells.
    pub cuts: Option<Bounds>,
    /// Bounding box of the ends of rapids.
    pub rapids: Option<Bounds>,
    /// Bounding box of all strokes.
    pub bounds: Bounds,
    /// Bytes from the first to the last of its blocks.
    pub span: Span,
    /// Identifies the stretch, unique within this process. It stays the same as long as the motions do.
    pub key: StretchKey,
    /// The index of its chunk.
    chunk: usize,
    /// The base of the chunk when `span` was determined.
    base: u32,
}

/// The id of a chunk, and the index of the first motion of a stretch in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StretchKey {
    chunk: u64,
    first: usize,
}

/// The bounding boxes of all motions.
#[derive(Clone, Debug)]
pub struct PathIndex {
    /// Changes with the motions, so that a cache can detect that it is stale.
    id: u64,
    stretches: Vec<Stretch>,
    /// Stretches of chunks that are currently not in the list.
    gone: Vec<Stretch>,
}

impl Default for PathIndex {
    fn default() -> Self {
        Self::new()
    }
}

impl PathIndex {
    /// An empty path index.
    pub fn new() -> Self {
        Self { id: next_id(), stretches: Vec::new(), gone: Vec::new() }
    }

    /// The path index of all of `motions`.
    pub fn of(motions: &Motions) -> Self {
        let mut path_index = Self::new();
        path_index.update(motions);
        path_index
    }

    /// Updates the index after `motions` grew or were edited; measures only new chunks. Removed chunks may
    /// reappear after re-run ones, so their stretches are kept until [`PathIndex::settle`].
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
            // Ids increase, so a newer one is not in the list; kept chunks keep their order.
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

    /// Drops the stretches of removed chunks. Call it when the run has ended, because no removed chunk will
    /// reappear then.
    pub fn settle(&mut self) {
        self.gone.clear();
    }

    /// An id that is unique among path indices of different motions.
    pub fn id(&self) -> u64 {
        self.id
    }

    /// Number of motions in the index.
    pub fn len(&self) -> usize {
        self.stretches.last().map_or(0, |last| last.motions.end)
    }

    /// Whether the index is empty.
    pub fn is_empty(&self) -> bool {
        self.stretches.is_empty()
    }

    /// The stretches, in order.
    pub fn stretches(&self) -> &[Stretch] {
        &self.stretches
    }

    /// The stretch that contains a motion.
    pub fn stretch_of(&self, motion: usize) -> Option<&Stretch> {
        self.stretches.get(self.stretches.partition_point(|stretch| stretch.motions.end <= motion))
    }

    /// Bounding box of all cuts and dwells.
    pub fn cuts(&self) -> Option<Bounds> {
        self.stretches.iter().fold(None, |bounds, stretch| join(bounds, stretch.cuts))
    }

    /// Bounding box of all strokes.
    pub fn bounds(&self) -> Option<Bounds> {
        self.stretches.iter().fold(None, |bounds, stretch| join(bounds, Some(stretch.bounds)))
    }

    /// Bounding box of the ends of all rapids.
    pub fn rapids(&self) -> Option<Bounds> {
        self.stretches.iter().fold(None, |bounds, stretch| join(bounds, stretch.rapids))
    }

    /// The chunk of a motion and its index there; for a motion past the end, the chunk is `usize::MAX`.
    pub(super) fn locate(&self, motion: usize) -> (usize, usize) {
        match self.stretch_of(motion) {
            Some(stretch) => (stretch.chunk, stretch.key.first + motion - stretch.motions.start),
            None => (usize::MAX, 0),
        }
    }
}

impl Stretch {
    /// The index of the chunk, and the indices of the motions in it.
    pub fn in_chunk(&self) -> (usize, Range<usize>) {
        (self.chunk, self.key.first..self.key.first + self.motions.len())
    }

    /// Updates the stretch after its chunk was shifted.
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

/// Measures motions of a chunk; the indices over all motions are left to the caller.
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
