//! The floor and the peers behind one interface, for wasm and native.
//!
//! In: the bytes of a program and a name. Out: the number of rows, and the rows themselves, so that dropping
//! them is not measured.

pub mod floor;
#[cfg(feature = "peers")]
mod peers;

use std::any::Any;
use std::hint::black_box;

use wasm_bindgen::prelude::wasm_bindgen;

/// The result for a program.
#[wasm_bindgen]
pub struct Outcome {
    /// Number of rows: segments if a peer makes motions, otherwise lines or words.
    pub rows: usize,
    /// Keeps the rows alive as long as the outcome.
    _kept: Box<dyn Any>,
}

impl Outcome {
    fn new<T: 'static>(rows: Vec<T>) -> Self {
        // Otherwise the compiler could remove rows that are never read.
        let rows = black_box(rows);
        Self { rows: rows.len(), _kept: Box::new(rows) }
    }
}

/// Runs the named peer; `None` if the name is unknown.
pub fn run(name: &str, text: Vec<u8>) -> Option<Outcome> {
    match name {
        "floor" => Some(Outcome::new(floor::segments(&text))),
        #[cfg(feature = "peers")]
        _ => peers::run(name, text),
        #[cfg(not(feature = "peers"))]
        _ => None,
    }
}

/// A buffer for the text, which JavaScript fills without a copy.
#[wasm_bindgen]
pub struct Input(Vec<u8>);

#[wasm_bindgen]
impl Input {
    /// Allocates a buffer of `capacity` bytes.
    #[wasm_bindgen(constructor)]
    pub fn new(capacity: usize) -> Self {
        Self(vec![0; capacity])
    }

    /// Address of the buffer in the memory of the module.
    pub fn address(&mut self) -> usize {
        self.0.as_mut_ptr() as usize
    }

    /// Runs the named peer.
    pub fn run(self, name: &str) -> Option<Outcome> {
        run(name, self.0)
    }
}
