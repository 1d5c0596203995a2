//! What numbers without a decimal point count: the line the page shows of it, and the decision.

use wasm_bindgen::prelude::*;

use super::Playground;
use crate::api;
use crate::parts::late;

#[wasm_bindgen]
impl Playground {
    /// One line on what numbers without a point count, where that was concluded or looks wrong; nothing
    /// where there is nothing to say.
    #[wasm_bindgen(js_name = decimalNotice)]
    pub fn decimal_notice(&self) -> Option<String> {
        notice(self)
    }

    /// Decides what numbers without a point count anew, for the text as it is: after a paste or a click, not
    /// while somebody types. The run begins again where that is something else.
    #[wasm_bindgen(js_name = decideDecimalRule)]
    pub fn decide_decimal_rule(&mut self) {
        self.current.decide_decimal_rule();
    }
}

late! {
    fn notice(playground: &Playground) -> Option<String> {
        api::decimal_notice(playground.current.run(), playground.language)
    }
}
