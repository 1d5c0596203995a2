//! The program formatted, renumbered, converted or repaired, for JavaScript.

use wasm_bindgen::prelude::*;

use super::{Playground, error, to_js, variant};
use crate::convert::ProgramForm;
use crate::parts::late;
use crate::renumber::{Blocks, Numbering};
use crate::repair::repaired;

#[wasm_bindgen]
impl Playground {
    /// The edits that write blanks, case and leading zeros of G and M codes uniformly.
    #[wasm_bindgen(unchecked_return_type = "Tidied")]
    pub fn formatted(&self) -> Result<JsValue, JsValue> {
        formatted(self)
    }

    /// The edits that write sequence numbers from `from` in steps of `step`; both are at least 1. `blocks`: `numbered` for
    /// the blocks that have a number, `all`, or `none`, which removes the numbers that nothing refers to.
    #[wasm_bindgen(unchecked_return_type = "Tidied")]
    pub fn renumbered(
        &self,
        from: u32,
        step: u32,
        #[wasm_bindgen(unchecked_param_type = "'numbered' | 'all' | 'none'")] blocks: &str,
    ) -> Result<JsValue, JsValue> {
        renumbered(self, from, step, blocks)
    }

    /// The edits that write the program in a form: coordinates as positions or distances, arcs by radius or centre,
    /// multiple cycles in one block or two, lengths in a unit, or the codes of a G-code system.
    #[wasm_bindgen(unchecked_return_type = "Converted")]
    pub fn converted(
        &self,
        #[wasm_bindgen(unchecked_param_type = "ProgramForm")] form: &str,
    ) -> Result<JsValue, JsValue> {
        converted(self, form)
    }

    /// The program with all safe fixes, which do not change what it does.
    pub fn repaired(&self) -> String {
        safely_repaired(self)
    }
}

late! {
    fn formatted(playground: &Playground) -> Result<JsValue, JsValue> {
        to_js(&playground.places().formatted(playground.current.run(), playground.language))
    }

    fn renumbered(playground: &Playground, from: u32, step: u32, blocks: &str) -> Result<JsValue, JsValue> {
        let ascending = |blocks| Numbering::Ascending { from: from.max(1), step: step.max(1), blocks };
        let numbering = match blocks {
            "numbered" => ascending(Blocks::Numbered),
            "all" => ascending(Blocks::All),
            "none" => Numbering::Remove,
            other => return Err(error(&format!("`blocks` is `numbered`, `all` or `none`, not `{other}`"))),
        };
        to_js(&playground.places().renumbered(playground.current.run(), numbering, playground.language))
    }

    fn converted(playground: &Playground, form: &str) -> Result<JsValue, JsValue> {
        let form: ProgramForm = variant(form)?;
        to_js(&playground.places().converted(playground.current.run(), form, playground.language))
    }

    fn safely_repaired(playground: &Playground) -> String {
        let run = playground.current.run();
        String::from_utf8_lossy(&repaired(run.text(), &run.setup_to_repeat()).text).into_owned()
    }
}
