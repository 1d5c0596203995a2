//! The blank.

use serde::Deserialize;

use crate::units::Diameter;

/// A bar or a tube, and how far it stands in the chuck.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Stock {
    /// Outside diameter, mm.
    pub diameter: Diameter,
    /// Bore diameter, mm; 0 for solid.
    #[serde(default)]
    pub bore: Diameter,
    /// Z of the front face, mm.
    #[serde(default)]
    pub face: f64,
    /// Length, mm, from the face towards −Z.
    pub length: f64,
    /// Clamping length, mm, from the back; there are no jaws where nothing is said.
    #[serde(default)]
    pub grip: Option<f64>,
}

impl Stock {
    /// Z of the back, mm.
    pub fn back(&self) -> f64 {
        self.face - self.length
    }
}
