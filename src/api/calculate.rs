//! Rows for the calculators: fields with their meaning, results, a table of passes, edits.
//!
//! In: a calculator, the texts of its fields, a language. Out: texts.

use serde::Serialize;
#[cfg(target_arch = "wasm32")]
use tsify::Tsify;

use super::{Edit, Places};
use crate::assist::Query;
use crate::calculate::at_word;
use crate::calculate::{Calculator, Fault, Outcome, Quantity, THREAD, Writing};
use crate::motion::Motions;
use crate::sentences::Language;
use crate::sentences::calculate as texts;
use crate::threads;

/// A calculator with its fields.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
#[serde(rename_all = "camelCase")]
pub struct CalculatorForm {
    /// Its name.
    pub name: &'static str,
    /// Its title.
    pub title: &'static str,
    /// Its fields.
    pub fields: Vec<CalculatorField>,
}

/// A field of a calculator.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
#[serde(rename_all = "camelCase")]
pub struct CalculatorField {
    /// The letter of the figure.
    pub letter: &'static str,
    /// Its meaning.
    pub title: &'static str,
    /// The unit; empty for a number without one.
    pub unit: &'static str,
    /// Its first value; empty if it is unknown.
    pub value: String,
    /// Whether it is a name, not a number.
    pub is_text: bool,
}

/// The answer of a calculator.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
#[serde(tag = "kind", rename_all = "camelCase")]
pub enum Calculation {
    /// The results.
    Done(Calculated),
    /// A field has a wrong value.
    Wrong {
        /// The index of the field.
        field: u32,
        /// Why the value is wrong.
        reason: &'static str,
        /// Names that begin with the value.
        suggestions: Vec<&'static str>,
    },
}

/// The results of a calculator.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct Calculated {
    /// The results.
    pub results: Vec<CalculatedValue>,
    /// The headings of the table of passes.
    pub columns: Vec<&'static str>,
    /// Its rows.
    pub rows: Vec<Vec<String>>,
    /// The blocks with the result; empty if there are none.
    pub block: String,
    /// A program that shows the result.
    pub program: String,
    /// The edits that write the result into the block at the cursor; empty without such a block.
    pub edits: Vec<Edit>,
}

/// A result.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct CalculatedValue {
    /// Its letter.
    pub letter: &'static str,
    /// Its meaning.
    pub title: &'static str,
    /// Its value with the unit.
    pub value: String,
}

/// The form of a calculator with the values of its worked example, or `values`.
pub fn form(
    calculator: &'static Calculator,
    values: Option<Vec<String>>,
    writing: Writing,
    language: Language,
) -> CalculatorForm {
    let examples = || calculator.fields.iter().map(|field| Some(field.example)).collect::<Vec<_>>();
    let is_example = values.is_none();
    let values = values.unwrap_or_else(|| at_word::shown(calculator, &examples(), writing));
    let fields =
        calculator.fields.iter().zip(values).enumerate().map(|(at, (field, value))| CalculatorField {
            letter: field.name,
            title: texts::field(calculator, at, language),
            unit: texts::unit(field.quantity, writing.unit, language),
            value: if is_example && field.quantity == Quantity::ThreadName {
                THREAD.to_owned()
            } else {
                value
            },
            is_text: field.quantity == Quantity::ThreadName,
        });
    CalculatorForm {
        name: calculator.name,
        title: texts::title(calculator, language),
        fields: fields.collect(),
    }
}

/// The form of a calculator with the values of the block of a question.
pub fn form_at(
    calculator: &'static Calculator,
    asked: &Query,
    motions: &Motions,
    language: Language,
) -> CalculatorForm {
    let writing = Writing::of(asked);
    let values = at_word::values(calculator, asked, motions);
    form(calculator, Some(at_word::shown(calculator, &values, writing)), writing, language)
}

/// The results for the texts of the fields. `edits`: makes the edits of the program.
pub fn calculate(
    calculator: &Calculator,
    fields: &[String],
    writing: Writing,
    language: Language,
    edits: impl FnOnce(&Outcome) -> Vec<Edit>,
) -> Calculation {
    let computed = calculator.read(fields, writing.unit).and_then(|values| {
        let outcome = calculator.compute(&values, fields.first().map_or("", String::as_str))?;
        Ok((values, outcome))
    });
    let (values, outcome) = match computed {
        Ok(computed) => computed,
        Err((field, fault)) => {
            let suggestions = match fault {
                Fault::UnknownThread => fields.first().map_or_else(Vec::new, |name| threads::suggest(name)),
                _ => Vec::new(),
            };
            return Calculation::Wrong {
                field: field as u32,
                reason: texts::fault(fault, language),
                suggestions,
            };
        }
    };
    let results = outcome.results.iter().enumerate().map(|(at, &(letter, quantity, value))| {
        let unit = texts::unit(quantity, writing.unit, language);
        let value = writing.value(quantity, value);
        let gap = if matches!(unit, "" | "°") { "" } else { " " };
        let value = format!("{value}{gap}{unit}");
        CalculatedValue { letter, title: texts::result(calculator, at, language), value }
    });
    let standard = outcome.thread.iter().map(|thread| CalculatedValue {
        letter: "",
        title: texts::standard(language),
        value: format!("{}, {}", thread.designation, thread.source()),
    });
    let results = results.chain(standard);
    let row = |row: &Vec<f64>| {
        row.iter()
            .zip(&outcome.columns)
            .map(|(value, (_, quantity))| writing.value(*quantity, *value))
            .collect()
    };
    let blocks: Vec<String> = outcome.blocks.iter().map(|block| writing.block(block)).collect();
    Calculation::Done(Calculated {
        results: results.collect(),
        columns: (0..outcome.columns.len()).map(|at| texts::column(calculator, at, language)).collect(),
        rows: outcome.rows.iter().map(row).collect(),
        block: blocks.join("\n"),
        program: calculator.program(&values, &outcome),
        edits: edits(&outcome),
    })
}

impl Places<'_> {
    /// The edits that write a result into the block of a question.
    pub fn calculated(&self, asked: &Query, motions: &Motions, outcome: &Outcome) -> Vec<Edit> {
        let changes = at_word::edits(asked, motions, outcome, Writing::of(asked));
        changes.into_iter().map(|change| self.edit(change.span, change.text)).collect()
    }
}
