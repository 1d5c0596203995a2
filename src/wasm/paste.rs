//! Programs inside a text, for JavaScript.
//!
//! In: a text that was pasted, dropped or opened. Out: the list of its programs, and each of them in pieces.

use wasm_bindgen::prelude::*;

use super::to_js;
use crate::api::paste::{self as rows, FoundPrograms};
use crate::paste::{Found, find};
use crate::sentences::Language;

/// A text and the programs found in it.
#[wasm_bindgen]
pub struct PastedText {
    text: String,
    found: Found,
}

#[wasm_bindgen]
impl PastedText {
    /// Looks through a text.
    #[wasm_bindgen(constructor)]
    pub fn new(text: String) -> PastedText {
        let found = find(&text);
        PastedText { text, found }
    }

    /// What there is.
    #[wasm_bindgen(unchecked_return_type = "FoundPrograms")]
    pub fn programs(&self) -> Result<JsValue, JsValue> {
        to_js(&FoundPrograms::new(&self.found))
    }

    /// One of the programs, with the reasons in the language of a tag; nothing where
    /// there is none of that number.
    #[wasm_bindgen(unchecked_return_type = "FoundPiece[]")]
    pub fn pieces(&self, program: usize, tag: &str) -> Result<JsValue, JsValue> {
        let program = self.found.programs.get(program);
        let language = Language::from_tag(tag);
        to_js(&program.map(|program| rows::pieces(&self.text, program, language)).unwrap_or_default())
    }
}
