//! What leaves the crate of a stock that nobody has named.

use serde::Serialize;

use crate::run::Analysis;
use crate::sentences::{Language, labels};
use crate::setup::Stock;
use crate::setup::as_comments;
use crate::units::Diameter;

/// A stock that is inferred, and what was not checked because of that.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct InferredStock {
    /// `stock-assumed`: what sets the row apart from those of messages.
    pub note: &'static str,
    /// What was not looked for.
    pub not_checked: [&'static str; 1],
    /// The same in words, with the comment that names this stock.
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
    /// From the face towards −Z.
    pub length: f64,
}

impl InferredStock {
    /// That of a program; nothing where its setup names a stock, nothing is cut, or a tool is not
    /// known and no part is shown.
    pub fn of(analysis: &Analysis, language: Language) -> Option<Self> {
        if analysis.setup.stock.is_some() {
            return None;
        }
        let resolved = analysis.resolved_setup();
        let (stock, _) = resolved.stock().filter(|_| resolved.shows_part())?;
        let Stock { diameter, bore, face, length, .. } = stock;
        let [diameter, bore] = [diameter, bore].map(|own| own.map(super::to_micrometres));
        let [face, length] = [face, length].map(super::to_micrometres);
        let note = as_comments::stock(&Stock { diameter, bore, face, length, grip: None });
        Some(Self {
            note: "stock-assumed",
            not_checked: ["collisions"],
            message: labels::inferred_stock(&note, language),
            stock: StockRow { diameter, bore, face, length },
        })
    }
}
