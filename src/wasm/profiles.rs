//! Machines and tool tables that the page saves under names.

use wasm_bindgen::prelude::*;

use super::{Playground, error, to_js};
use crate::api::Profiles;
use crate::parts::late;
use crate::setup::Setup;
use crate::setup::draft::put_into_json;
use crate::setup::profile::Profile;

#[wasm_bindgen(typescript_custom_section)]
const KIND: &str = "/** What is kept under a name. */\nexport type ProfileKind = \"machine\" | \"tools\";";

#[wasm_bindgen]
impl Playground {
    /// The machine and the tools of a given setup, such as one from a file. Throws if the setup is invalid.
    #[wasm_bindgen(js_name = profilesIn, unchecked_return_type = "Profiles")]
    pub fn profiles_in(&self, json: &str) -> Result<JsValue, JsValue> {
        profiles_in(json)
    }

    /// The machine and the tools of the program as it is run, including those from its comments; `json` is
    /// the setup of the page.
    #[wasm_bindgen(js_name = profilesOfRun, unchecked_return_type = "Profiles")]
    pub fn profiles_of_run(&self, json: &str) -> Result<JsValue, JsValue> {
        profiles_of_run(self, json)
    }

    /// A setup with its machine or tools replaced by a profile; empty if nothing is left in it.
    #[wasm_bindgen(js_name = withProfile)]
    pub fn with_profile(
        &self,
        json: &str,
        #[wasm_bindgen(unchecked_param_type = "ProfileKind")] kind: &str,
        profile: &str,
    ) -> String {
        with_profile(json, kind, profile)
    }
}

late! {
    fn profiles_in(json: &str) -> Result<JsValue, JsValue> {
        let setup = Setup::from_json(json).map_err(|problem| error(&problem))?;
        // Written in the same format as the setup of a run, so that the two can be compared.
        to_js(&Profiles::of_setup(&put_into_json(json, &setup)))
    }

    fn profiles_of_run(playground: &Playground, json: &str) -> Result<JsValue, JsValue> {
        let as_run = put_into_json(json, &playground.current.run().as_given());
        to_js(&Profiles::of_setup(&as_run))
    }

    fn with_profile(json: &str, kind: &str, profile: &str) -> String {
        Profile::of(kind).put_into(json, profile)
    }
}
