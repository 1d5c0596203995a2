//! What is worth remembering about the motions: boxes and lengths of short stretches of them.
//!
//! In: the motion list, whole or as it grows. Out: [`Outline`], so that a picture of a million motions can skip
//! what is out of view and find a place along the path without walking all of it. Knows nothing of pixels.

use std::ops::Range;
use std::sync::atomic::{AtomicU64, Ordering};

use crate::motion::{Chunk, Motions};
use crate::text::source::Span;

use super::bounds::{Bounds, join};
use super::{StrokeShape, StrokeStyle};

/// Motions in a stretch.
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
    /// Length of the path before this stretch, mm.
    pub length_before: f64,
    /// Length of the path in this stretch, mm.
    pub length: f64,
    /// Where the first motion lies: chunk, and index in it.
    first: (usize, usize),
}

/// Boxes and lengths of all motions.
#[derive(Clone, Debug)]
pub struct Outline {
    /// Tells this outline from every other made in this process, so that a cache can tell that it is stale.
    id: u64,
    stretches: Vec<Stretch>,
}

impl Default for Outline {
    fn default() -> Self {
        Self::new()
    }
}

impl Outline {
    /// The outline of no motions.
    pub fn new() -> Self {
        static NEXT: AtomicU64 = AtomicU64::new(0);
        Self { id: NEXT.fetch_add(1, Ordering::Relaxed), stretches: Vec::new() }
    }

    /// The outline of all of `motions`.
    pub fn of(motions: &Motions) -> Self {
        let mut outline = Self::new();
        outline.extend(motions);
        outline
    }

    /// Takes in what was added to `motions` since the last call; the motions taken in before must not have
    /// changed (a new run begins with a new outline).
    pub fn extend(&mut self, motions: &Motions) {
        if self.len() == motions.len() {
            return;
        }
        if self.stretches.last().is_some_and(|last| last.motions.len() < STRETCH) {
            self.stretches.pop();
        }
        let chunks = motions.chunks();
        let (mut chunk, mut at) = self.locate(self.len(), chunks);
        while self.len() < motions.len() {
            let first = self.len();
            let end = motions.len().min(first + STRETCH);
            let stretch = stretch(first..end, self.length(), chunks, (chunk, at));
            at += end - first;
            while chunk < chunks.len() && at >= chunks[chunk].len() {
                at -= chunks[chunk].len();
                chunk += 1;
            }
            self.stretches.push(stretch);
        }
    }

    /// A number no other outline has; it stays when the outline is extended.
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
        self.stretches.get(motion / STRETCH).filter(|stretch| motion < stretch.motions.end)
    }

    /// The stretch that reaches `length` mm along the path; the last one beyond the end.
    pub fn stretch_at(&self, length: f64) -> Option<&Stretch> {
        let index = self.stretches.partition_point(|s| s.length_before + s.length < length);
        let moving = |stretch: &&Stretch| stretch.length > 0.0;
        self.stretches[index..].iter().find(moving).or_else(|| self.stretches.iter().rev().find(moving))
    }

    /// Box around everything that cuts or waits.
    pub fn cuts(&self) -> Option<Bounds> {
        self.stretches.iter().fold(None, |bounds, stretch| join(bounds, stretch.cuts))
    }

    /// Box around where the rapids end.
    pub fn rapids(&self) -> Option<Bounds> {
        self.stretches.iter().fold(None, |bounds, stretch| join(bounds, stretch.rapids))
    }

    /// Length of the whole path, mm, rapids included.
    pub fn length(&self) -> f64 {
        self.stretches.last().map_or(0.0, |last| last.length_before + last.length)
    }

    /// The chunk a motion lies in and its index there; the index may run on into the chunks that follow.
    pub(super) fn locate(&self, motion: usize, chunks: &[Chunk]) -> (usize, usize) {
        let (mut chunk, mut at) = match self.stretches.get(motion / STRETCH).or(self.stretches.last()) {
            Some(stretch) if stretch.motions.start <= motion => {
                (stretch.first.0, stretch.first.1 + motion - stretch.motions.start)
            }
            _ => (0, motion),
        };
        while chunk < chunks.len() && at >= chunks[chunk].len() {
            at -= chunks[chunk].len();
            chunk += 1;
        }
        (chunk, at)
    }
}

/// Measures a stretch that is not empty.
fn stretch(motions: Range<usize>, length_before: f64, chunks: &[Chunk], first: (usize, usize)) -> Stretch {
    let (mut cuts, mut rapids, mut bounds, mut span) = (None, None, None, None::<Span>);
    let mut length = 0.0;
    let (mut chunk, mut at) = first;
    for _ in motions.clone() {
        while at >= chunks[chunk].len() {
            at -= chunks[chunk].len();
            chunk += 1;
        }
        let motion = chunks[chunk].get(at);
        let shape = StrokeShape::of(&motion);
        let own = Bounds::of_shape(&shape);
        match StrokeStyle::of(motion.kind) {
            StrokeStyle::Rapid => rapids = join(rapids, Some(Bounds::of(shape.end()))),
            StrokeStyle::Dwell | StrokeStyle::Feed | StrokeStyle::Thread => cuts = join(cuts, Some(own)),
        }
        bounds = join(bounds, Some(own));
        let block = chunks[chunk].span(at);
        span = Some(span.map_or(block, |span| span.to(block)));
        length += shape.length();
        at += 1;
    }
    Stretch {
        motions,
        cuts,
        rapids,
        bounds: bounds.unwrap_or(Bounds::of(Default::default())),
        span: span.unwrap_or_default(),
        length_before,
        length,
        first,
    }
}
