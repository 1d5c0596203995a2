//! Comparison with another version of the program, for JavaScript.
//!
//! In: the finished runs of this program and of another one. Out: the differences, in the user's language,
//! and a drawing of both.

use wasm_bindgen::prelude::*;

use super::{Playground, to_js};
use crate::api;
use crate::difference::{ProgramDifference, Version};
use crate::parts::late;
use crate::scene::camera::XPlus;
use crate::scene::ruler::Scale;
use crate::scene::svg::{SvgOptions, overlay};
use crate::sentences::difference::{Said, said, said_with};
use crate::sentences::labels;
use crate::setup::Setup;

/// Parts of longer programs are not compared here, because the page waits for the answer.
const MAX_MOTIONS: usize = 5_000;

#[wasm_bindgen]
impl Playground {
    /// Another program with the same setup and language. Run it ([`Self::advance`]) and remove its material
    /// before comparing it.
    pub fn another(&self, text: String) -> Playground {
        let mut other = Playground::new();
        other.setup = Setup { tried: Vec::new(), ..self.setup.clone() };
        other.language = self.language;
        other.begin(text.into_bytes());
        other
    }

    /// The differences between `other`, which is the first version, and this program.
    #[wasm_bindgen(js_name = differenceFrom, unchecked_return_type = "ProgramDifference")]
    pub fn difference_from(&self, other: &Playground) -> Result<JsValue, JsValue> {
        difference(self, other)
    }

    /// The tool paths of both as SVG, with a legend; `first` is the name of `other`, `second` that of this
    /// program.
    #[wasm_bindgen(js_name = drawnWith)]
    pub fn drawn_with(&self, other: &Playground, first: String, second: String) -> String {
        drawn(self, other, first, second)
    }
}

late! {
    fn difference(playground: &Playground, other: &Playground) -> Result<JsValue, JsValue> {
        let both = [other, playground];
        let found = both.map(Playground::all_diagnostics);
        let setups = both.map(Playground::setup_to_compare);
        let versions = [0, 1].map(|side| {
            let run = both[side].current.run();
            Version {
                text: run.text(),
                motions: run.motions(),
                diagnostics: &found[side],
                setup: &setups[side],
                codes: run.code_list(),
                unit: run.state().unit,
            }
        });
        let differ = ProgramDifference::of(versions);
        let (unit, language) = (playground.current.unit(), playground.language);
        to_js(&api::difference::ProgramDifference::new(&differ, both.map(Playground::places), unit, language))
    }

    fn drawn(playground: &Playground, other: &Playground, first: String, second: String) -> String {
        let language = playground.language;
        let [first, second] = [first, second].map(|name| said_with(Said::OnlyIn, &name, language));
        let legend = [first, second, said(Said::InBoth, language).to_owned()];
        let unit = playground.current.unit();
        let scale = Scale { symbol: labels::unit_of_ruler(unit, language), ..Scale::of(unit) };
        let options = SvgOptions { x_plus: XPlus::from(playground.current.turret()), scale, ..SvgOptions::default() };
        overlay([other, playground].map(|own| own.current.motions()), &legend, &options)
    }
}

impl Playground {
    fn setup_to_compare(&self) -> Setup {
        let mut setup = self.current.run().setup().clone();
        setup.limits.part_motions = setup.limits.part_motions.min(MAX_MOTIONS);
        setup
    }
}
