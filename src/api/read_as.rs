//! How a program was read: the control, its system, units and switches, and the source of each.
//!
//! In: a run. Out: a list of facts as text, each with the key of the setup that changes it. The page shows
//! them on one line.

use serde::Serialize;

#[cfg(target_arch = "wasm32")]
use tsify::Tsify;

use crate::run::Run;
use crate::sentences::{Language, labels};
use crate::setup::dialect::{Control, DecimalRule};
use crate::setup::fields::Name;
use crate::text::program_name;

/// How a program was read.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct ReadAs {
    /// The facts, in display order.
    pub facts: Vec<ReadFact>,
}

/// A fact about how a program was read.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct ReadFact {
    /// The key of the setup that changes it; absent if it is not changed by the setup.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub key: Option<&'static str>,
    /// The fact as text: `system B`.
    pub text: String,
    /// The source of the fact: `set` in the setup, `recognised` from the text, selected by a code of the
    /// `program`, or `usual` (the default).
    #[cfg_attr(target_arch = "wasm32", tsify(type = "\"set\" | \"recognised\" | \"usual\" | \"program\""))]
    pub basis: &'static str,
}

impl ReadAs {
    /// How the program of a run was read.
    pub fn new(run: &Run, language: Language) -> Self {
        let (given, state) = (run.as_given().dialect, run.state());
        let fact = |key, text: &str, basis| ReadFact { key: Some(key), text: text.to_owned(), basis };
        let said = |is_said: bool| if is_said { "set" } else { "usual" };
        if let Some(foreign) = run.foreign() {
            let text = labels::not_run(foreign.name(), language);
            return Self { facts: vec![fact("dialect.recognise", &text, "recognised")] };
        }
        let control = given.control.unwrap_or_default();
        let name = labels::choice(Name::Control, control.name(), language);
        let mut facts = vec![fact("dialect.control", name, said(given.control.is_some()))];
        let system = run.recognised_system().or(given.g_system);
        if control != Control::Gsk || system.is_some() {
            let basis = if run.recognised_system().is_some() { "recognised" } else { said(system.is_some()) };
            let text = labels::system(system.unwrap_or_default(), language);
            facts.push(fact("dialect.gSystem", &text, basis));
        }
        let text = labels::unit_of_program(state.unit, language);
        let basis = match (run.concludes_inches(), given.unit) {
            (true, _) => "recognised",
            (false, Some(unit)) if unit == state.unit => "set",
            (false, _) => "program",
        };
        facts.push(fact("dialect.unit", text, basis));
        let basis = match (run.decided_rule(), run.decimal_rule()) {
            (None, _) => "set",
            (Some(_), DecimalRule::LeastIncrement) => "recognised",
            (Some(_), DecimalRule::Calculator) => "usual",
        };
        let text = labels::without_point(run.decimal_rule(), state.unit, language);
        facts.push(fact("dialect.decimal", &text, basis));
        let text = labels::feed_unit(state.feed_mode, state.unit, language);
        let at_start = given.feed_mode.or(given.power_on_feed);
        let basis = if at_start == Some(state.feed_mode) { "set" } else { "program" };
        facts.push(fact("dialect.feedMode", text, basis));
        let levels = &run.setup().block_skip;
        let text = labels::block_skip(levels, language);
        facts.push(ReadFact { key: None, text, basis: said(!levels.is_empty()) });
        if let Some(number) = run.program_number().filter(|&number| !program_name::is_name(number)) {
            let basis = said(run.setup().program.is_some());
            facts.push(ReadFact { key: None, text: format!("O{number:04}"), basis });
        }
        Self { facts }
    }
}
