//! The notice about a stock that was inferred because the setup gives none.

use serde::Serialize;

use crate::run::Analysis;
use crate::sentences::{Language, labels};
use crate::setup::Stock;
use crate::setup::as_comments;
use crate::units::Diameter;

/// An inferred stock, and the checks that were skipped because of it.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct InferredStock {
    /// Always `stock-assumed`, an older name for inferred; distinguishes the row from messages.
    pub note: &'static str,
    /// The skipped checks.
    pub not_checked: [&'static str; 1],
    /// The notice as text, with the program comment that gives this stock.
    pub message: String,
    /// The stock, as a setup has it.
    pub stock: StockRow,
}

/// A bar or a tube, mm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct StockRow {
    /// Outside diameter.
    pub diameter: Diameter,
    /// Bore diameter; 0 for solid.
    pub bore: Diameter,
    /// Z of the front face.
    pub face: f64,
    /// Length from the face towards −Z.
    pub length: f64,
}

impl InferredStock {
    /// The inferred stock of a program. `None` if the setup gives a stock, nothing is cut, or no part is
    /// shown because a tool is unknown.
    pub fn of(analysis: &Analysis, language: Language) -> Option<Self> {
        if analysis.setup.stock.is_some() {
            return None;
        }
        let resolved = analysis.resolved_setup();
        let (stock, _) = resolved.stock().filter(|_| resolved.shows_part())?;
        let Stock { diameter, bore, face, length, .. } = stock;
        let [diameter, bore] = [diameter, bore].map(|value| value.map(super::rounded_to_thousandth));
        let [face, length] = [face, length].map(super::rounded_to_thousandth);
        let note = as_comments::stock(&Stock { diameter, bore, face, length, grip: None });
        Some(Self {
            note: "stock-assumed",
            not_checked: ["collisions"],
            message: labels::inferred_stock(&note, language),
            stock: StockRow { diameter, bore, face, length },
        })
    }
}
