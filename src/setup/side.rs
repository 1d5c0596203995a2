//! Side of the workpiece that a tool is for.

use serde::Deserialize;

/// Side of the workpiece that a tool is for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema), schemars(inline))]
#[serde(rename_all = "lowercase")]
pub enum Side {
    /// The outside.
    #[default]
    Outside,
    /// The bore.
    Inside,
    /// The end face.
    Face,
}

impl Side {
    /// All sides.
    pub const ALL: [Side; 3] = [Self::Outside, Self::Inside, Self::Face];

    /// Name in a setup.
    pub fn name(self) -> &'static str {
        match self {
            Self::Outside => "outside",
            Self::Inside => "inside",
            Self::Face => "face",
        }
    }
}
