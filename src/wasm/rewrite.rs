//! Plain moves that can be rewritten as cycles, for JavaScript.

use wasm_bindgen::prelude::*;

use super::{Playground, to_js};
use crate::parts::late;
use crate::rewrite::offers;
use crate::source::Span;

#[wasm_bindgen]
impl Playground {
    /// The blocks that can be rewritten as a cycle without changing a motion, sorted by place. `from` and
    /// `to` are the user's selection, UTF-16 offsets: in a long program only the text near it is searched.
    #[wasm_bindgen(unchecked_return_type = "Rewriting[]")]
    pub fn rewritings(&self, from: u32, to: u32) -> Result<JsValue, JsValue> {
        rewritings(self, from, to)
    }
}

late! {
    fn rewritings(playground: &Playground, from: u32, to: u32) -> Result<JsValue, JsValue> {
    let (text, places) = (playground.current.run().text(), playground.places());
    let byte = |offset: u32| playground.current.lines().byte_at_utf16(text, offset) as usize;
    let start = byte(from);
    let selection = Some(Span::new(start, byte(to).max(start)));
    let found = offers(text, &playground.current.run().setup_to_repeat(), selection);
    let rows = found.iter().map(|offer| places.rewriting(offer, selection, playground.language));
    to_js(&rows.collect::<Vec<_>>())
}
}
