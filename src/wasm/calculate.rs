//! The calculators.
//!
//! In: the name of a calculator, the texts of its fields. Out: rows. The block is that of the current question
//! ([`super::assist`]).

use wasm_bindgen::prelude::*;

use super::assist::with_answer;
use super::{Playground, error, to_js};
use crate::api::calculate;
use crate::calculate::{Calculator, Writing};
use crate::export::figure::Subject;
use crate::figures;
use crate::machine::SimulationResult;
use crate::parts::late;
use crate::run::{Analysis, Run};
use crate::scene::ruler::Scale;
use crate::scene::svg::{Passes, SvgOptions, section};
use crate::sentences::labels;
use crate::setup::Setup;
use crate::units::Unit;

#[wasm_bindgen]
impl Playground {
    /// The form of a calculator: with the values of the requested block if it `is_at_cursor`, or with those of the worked
    /// example.
    #[wasm_bindgen(js_name = calculatorForm, unchecked_return_type = "CalculatorForm | undefined")]
    pub fn calculator_form(&self, name: &str, is_at_cursor: bool) -> Result<JsValue, JsValue> {
        calculator_form(self, name, is_at_cursor)
    }

    /// The results of a calculator, with edits of the requested block if it `is_at_cursor`.
    #[wasm_bindgen(unchecked_return_type = "Calculation | undefined")]
    pub fn calculate(&self, name: &str, fields: Vec<String>, is_at_cursor: bool) -> Result<JsValue, JsValue> {
        calculate_fields(self, name, fields, is_at_cursor)
    }

    /// SVG of a program with the letters of its first cycle, or with the dimensions of its part.
    #[wasm_bindgen(js_name = calculatorFigure)]
    pub fn calculator_figure(&self, program: String) -> String {
        figure(self, program)
    }
}

late! {
    fn calculator_form(playground: &Playground, name: &str, is_at_cursor: bool) -> Result<JsValue, JsValue> {
        let calculator = found(name)?;
        let language = playground.language;
        let motions = playground.current.motions();
        if is_at_cursor {
            return with_answer(playground, |_, asked| to_js(&calculate::form_at(calculator, asked, motions, language)));
        }
        to_js(&calculate::form(calculator, None, Writing::METRIC, language))
    }

    fn calculate_fields(
        playground: &Playground,
        name: &str,
        fields: Vec<String>,
        is_at_cursor: bool,
    ) -> Result<JsValue, JsValue> {
        let calculator = found(name)?;
        let language = playground.language;
        let motions = playground.current.motions();
        if is_at_cursor {
            return with_answer(playground, |reader, asked| {
                let edits = |outcome: &_| reader.places.calculated(asked, motions, outcome);
                to_js(&calculate::calculate(calculator, &fields, Writing::of(asked), language, edits))
            });
        }
        to_js(&calculate::calculate(calculator, &fields, Writing::METRIC, language, |_| Vec::new()))
    }

    fn figure(playground: &Playground, program: String) -> String {
        let finished = || Run::finished(program.clone().into_bytes(), Setup::default());
        let Analysis { motions, setup, .. } = &finished().into_analysis();
        let simulation = SimulationResult::of(motions, setup);
        let symbol = labels::unit_of_ruler(Unit::Millimetre, playground.language);
        let scale = Scale { unit: Unit::Millimetre, symbol };
        let options = SvgOptions { width: WIDTH, scale, passes: Passes::Apart, ..SvgOptions::default() };
        let has_cycle = figures::first_cycle(&finished()).is_some();
        let subject = if has_cycle { Subject::Cycle { line: None } } else { Subject::Part };
        let options = subject.options(options, finished, &simulation, motions);
        section(motions, Some(&simulation), &options)
    }
}

/// Width of a figure, CSS pixels.
const WIDTH: f64 = 360.0;

fn found(name: &str) -> Result<&'static Calculator, JsValue> {
    Calculator::find(name).ok_or_else(|| error(&format!("there is no calculator {name}")))
}
