//! The motions for JavaScript: as objects, and as columns of numbers.

use js_sys::{Float64Array, Uint8Array, Uint32Array};
use wasm_bindgen::prelude::*;

use super::{Playground, to_js, view_of};
use crate::api;
use crate::motion::{Chunk, Motions};
use crate::parts::late;

#[wasm_bindgen]
impl Playground {
    /// The motions `first..end` as objects; for short lists. Read long ones with [`Self::chunk`].
    #[wasm_bindgen(unchecked_return_type = "Motion[]")]
    pub fn motions(&self, first: u32, end: u32) -> Result<JsValue, JsValue> {
        rows(self, first as usize, end as usize)
    }

    /// Number of chunks of the motions.
    #[wasm_bindgen(js_name = chunkCount)]
    pub fn chunk_count(&self) -> usize {
        self.current.motions().chunks().len()
    }

    /// The columns of a chunk of motions, each copied out of wasm memory.
    pub fn chunk(&self, index: usize) -> Option<MotionChunk> {
        chunk(self.current.motions(), index)
    }

    /// The columns of a chunk of motions in wasm memory, without a copy. They are valid until the next call
    /// into this module, which may move the motions or make the memory grow (a view is then empty). Read them
    /// immediately, or copy them with `slice()`. [`Self::chunk`] does that for you.
    #[wasm_bindgen(js_name = chunkView)]
    pub fn chunk_view(&self, index: usize) -> Option<MotionChunkView> {
        self.current.motions().chunks().get(index).map(view_of)
    }
}

late! {
    fn chunk(motions: &Motions, index: usize) -> Option<MotionChunk> {
        motions.chunks().get(index).map(MotionChunk::new)
    }

    fn rows(playground: &Playground, first: usize, end: usize) -> Result<JsValue, JsValue> {
        let motions = playground.current.motions();
        let machine = &playground.current.run().setup().machine;
        let range = first.min(motions.len())..end.min(motions.len());
        let rows = range.map(|index| api::motion(&motions.get(index), motions.line(index), machine));
        to_js(&rows.collect::<Vec<_>>())
    }
}

/// The motions of a chunk as columns.
#[wasm_bindgen(getter_with_clone)]
pub struct MotionChunk {
    /// 0 rapid, 1 feed, 2 arc clockwise, 3 arc counter-clockwise, 4 thread, 5 dwell.
    pub kind: Uint8Array,
    /// X of the end points: radius, mm.
    pub x: Float64Array,
    /// Z of the end points, mm.
    pub z: Float64Array,
    /// Lines, from 1.
    pub line: Uint32Array,
}

impl MotionChunk {
    fn new(chunk: &Chunk) -> Self {
        Self {
            kind: chunk.kinds().into(),
            x: chunk.xs().into(),
            z: chunk.zs().into(),
            line: (0..chunk.len()).map(|index| chunk.line(index) + 1).collect::<Vec<_>>()[..].into(),
        }
    }
}

/// The columns of a chunk in the memory of the module; see [`Playground::chunk_view`].
#[wasm_bindgen(getter_with_clone)]
pub struct MotionChunkView {
    /// As in [`MotionChunk`].
    pub kind: Uint8Array,
    /// X of the end points: radius, mm.
    pub x: Float64Array,
    /// Z of the end points, mm.
    pub z: Float64Array,
}
