//! Programs inside a text, for JavaScript.
//!
//! In: a text that was pasted, dropped or opened. Out: the list of its programs, and the pieces of each
//! program.

use wasm_bindgen::prelude::*;

use super::to_js;
use crate::api::paste::{self as rows, FoundPrograms};
use crate::parts::late;
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
    /// Searches a text for programs.
    #[wasm_bindgen(constructor)]
    pub fn new(text: String) -> PastedText {
        let found = programs_in(&text);
        PastedText { text, found }
    }

    /// The list of programs.
    #[wasm_bindgen(unchecked_return_type = "FoundPrograms")]
    pub fn programs(&self) -> Result<JsValue, JsValue> {
        programs(&self.found)
    }

    /// The pieces of a program, with reasons in the language `tag`; `undefined` if there is no program with
    /// this index.
    #[wasm_bindgen(unchecked_return_type = "FoundPiece[]")]
    pub fn pieces(&self, program: usize, tag: &str) -> Result<JsValue, JsValue> {
        pieces(self, program, Language::from_tag(tag))
    }
}

late! {
    fn programs_in(text: &str) -> Found {
        find(text)
    }

    fn programs(found: &Found) -> Result<JsValue, JsValue> {
        to_js(&FoundPrograms::new(found))
    }

    fn pieces(pasted: &PastedText, program: usize, language: Language) -> Result<JsValue, JsValue> {
        let program = pasted.found.programs.get(program);
        to_js(&program.map(|program| rows::pieces(&pasted.text, program, language)).unwrap_or_default())
    }
}
