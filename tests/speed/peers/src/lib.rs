//! The floor and the peers behind one interface, for wasm and native alike.
//!
//! In: the bytes of a program and a name. Out: how many rows came of it, and the rows themselves, so that
//! dropping them is not measured.

pub mod floor;
#[cfg(feature = "peers")]
mod peers;

use std::any::Any;
use std::hint::black_box;

use wasm_bindgen::prelude::wasm_bindgen;

/// What came of a program.
#[wasm_bindgen]
pub struct Outcome {
    /// Rows: segments where a peer makes motions, else lines or words.
    pub rows: usize,
    /// Kept alive for as long as this is.
    _kept: Box<dyn Any>,
}

impl Outcome {
    fn new<T: 'static>(rows: Vec<T>) -> Self {
        // Rows that nobody reads might else not be written.
        let rows = black_box(rows);
        Self { rows: rows.len(), _kept: Box::new(rows) }
    }
}

/// Runs one of them by name; nothing if there is none of that name.
pub fn run(name: &str, text: Vec<u8>) -> Option<Outcome> {
    match name {
        "floor" => Some(Outcome::new(floor::segments(&text))),
        #[cfg(feature = "peers")]
        _ => peers::run(name, text),
        #[cfg(not(feature = "peers"))]
        _ => None,
    }
}

/// A text on its way in: JavaScript writes it where it is wanted, without a copy.
#[wasm_bindgen]
pub struct Input(Vec<u8>);

#[wasm_bindgen]
impl Input {
    /// Room for so many bytes.
    #[wasm_bindgen(constructor)]
    pub fn new(capacity: usize) -> Self {
        Self(vec![0; capacity])
    }

    /// Where they are in the memory of the module.
    pub fn address(&mut self) -> usize {
        self.0.as_mut_ptr() as usize
    }

    /// Runs one by name.
    pub fn run(self, name: &str) -> Option<Outcome> {
        run(name, self.0)
    }
}
