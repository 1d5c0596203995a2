//! The setup form of the page: rows, the check of entries, and assumed values.

use wasm_bindgen::prelude::*;

use super::{Playground, to_js};
use crate::api::ReadAs;
use crate::api::setup::{FormInput, SetupOverview, SetupPlace};
use crate::machine::inferred::inferred_setup;
use crate::machine::resolved_setup::ResolvedSetup;
use crate::parts::late;
use crate::setup::draft::Entry;
use crate::units::Unit;

#[wasm_bindgen(typescript_custom_section)]
const PLACE: &str = "/** Where a setup is kept. */\nexport type SetupPlace = \"program\" | \"page\";";

#[wasm_bindgen]
impl Playground {
    /// Which of stock and tools are given, and which are inferred.
    #[wasm_bindgen(js_name = setupOverview, unchecked_return_type = "SetupOverview")]
    pub fn setup_overview(&self) -> Result<JsValue, JsValue> {
        overview(self)
    }

    /// How the program was read: control, system, units, switches.
    #[wasm_bindgen(js_name = readAs, unchecked_return_type = "ReadAs")]
    pub fn read_as(&self) -> Result<JsValue, JsValue> {
        read_as(self)
    }

    /// The initial state of the setup form.
    #[wasm_bindgen(js_name = setupForm, unchecked_return_type = "SetupForm")]
    pub fn setup_form(&self) -> Result<JsValue, JsValue> {
        form(self)
    }

    /// Fields for one more tool; `undefined` if `word` is not a T word.
    #[wasm_bindgen(js_name = anotherTool, unchecked_return_type = "SetupGroup | undefined")]
    pub fn another_tool(&self, word: &str) -> Result<JsValue, JsValue> {
        another_tool(self, word)
    }

    /// Checks the texts in the fields with these keys, and returns the changes that store them in a place;
    /// `json` is the setup of the page.
    #[wasm_bindgen(js_name = readSetupForm, unchecked_return_type = "SetupAnswer")]
    pub fn read_setup_form(
        &self,
        keys: Vec<String>,
        texts: Vec<String>,
        #[wasm_bindgen(unchecked_param_type = "SetupPlace")] keep: String,
        json: &str,
    ) -> Result<JsValue, JsValue> {
        answer(self, keys, texts, keep, json)
    }

    /// The fraction of the material removal that is done, 0 to 1.
    #[wasm_bindgen(js_name = machiningProgress)]
    pub fn machining_progress(&self) -> f64 {
        self.current.machining_progress()
    }

    /// Stops removing material, and reports that.
    #[wasm_bindgen(js_name = stopMachining)]
    pub fn stop_machining(&mut self) {
        self.current.stop_machining();
    }
}

late! {
    fn overview(playground: &Playground) -> Result<JsValue, JsValue> {
        let (run, language) = (playground.current.run(), playground.language);
        match playground.current.resolved_setup() {
            Some(resolved) => to_js(&SetupOverview::new(resolved, run.motions(), language)),
            None => {
                let resolved = ResolvedSetup::new(run.motions(), &run.setup_at_machine());
                to_js(&SetupOverview::new(&resolved, run.motions(), language))
            }
        }
    }

    fn read_as(playground: &Playground) -> Result<JsValue, JsValue> {
        to_js(&ReadAs::new(playground.current.run(), playground.language))
    }

    fn form(playground: &Playground) -> Result<JsValue, JsValue> {
        playground.about_setup(|subject| to_js(&subject.form()))
    }

    fn another_tool(playground: &Playground, word: &str) -> Result<JsValue, JsValue> {
        playground.about_setup(|subject| match subject.another_tool(word) {
            Some(group) => to_js(&group),
            None => Ok(JsValue::UNDEFINED),
        })
    }

    fn answer(
        playground: &Playground,
        keys: Vec<String>,
        texts: Vec<String>,
        keep: String,
        json: &str,
    ) -> Result<JsValue, JsValue> {
        let entries: Vec<_> = keys.into_iter().zip(texts).map(|(key, text)| Entry { key, text }).collect();
        let keep = SetupPlace::of(&keep);
        let (text, places) = (playground.current.run().text(), playground.places());
        playground.about_setup(|subject| to_js(&subject.answer(&entries, keep, json, text, &places)))
    }
}

impl Playground {
    fn about_setup<T>(&self, answer: impl FnOnce(&FormInput) -> T) -> T {
        let run = self.current.run();
        let (inferred, given) = (inferred_setup(run.motions(), &run.setup_at_machine()), run.as_given());
        answer(&FormInput {
            given: &given,
            page: &self.setup,
            notes: run.notes(),
            inferred: &inferred,
            decimal: run.decimal_rule(),
            system: run.recognised_system(),
            unit: run.concludes_inches().then_some(Unit::Inch),
            language: self.language,
        })
    }
}
