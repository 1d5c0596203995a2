//! What numbers without a decimal point count: the notice on the page, and the decision.

use wasm_bindgen::prelude::*;

use super::Playground;
use crate::api;
use crate::parts::late;

#[wasm_bindgen]
impl Playground {
    /// One line about numbers without a decimal point, if their unit was inferred or looks wrong.
    #[wasm_bindgen(js_name = decimalNotice)]
    pub fn decimal_notice(&self) -> Option<String> {
        notice(self)
    }

    /// Decides again, for the current text, what numbers without a decimal point count; restarts the run if
    /// the rule changes. To be called after a paste or a click, not during typing.
    #[wasm_bindgen(js_name = decideDecimalRule)]
    pub fn decide_decimal_rule(&mut self) {
        self.current.reinfer_decimal_rule();
    }
}

late! {
    fn notice(playground: &Playground) -> Option<String> {
        api::decimal_notice(playground.current.run(), playground.language)
    }
}
