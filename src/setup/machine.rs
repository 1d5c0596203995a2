//! The machine, its travel and its tailstock.

use serde::Deserialize;

use crate::units::Diameter;

/// The machine. A missing value is unknown and has no default.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[serde(default, deny_unknown_fields, rename_all = "camelCase")]
pub struct Machine {
    /// Rapid rate of the slide along X, mm/min.
    pub rapid_x: Option<f64>,
    /// Rapid rate along Z, mm/min.
    pub rapid_z: Option<f64>,
    /// Highest spindle speed, rpm.
    pub max_speed: Option<f64>,
    // Seed 001.
    /// K of the rule of thumb for threads, n ≤ 1200/P − K, rpm. A slide that accelerates slowly needs more.
    pub thread_speed_margin: Option<f64>,
    /// Travel of the tip.
    pub travel: Travel,
    /// Side of the spindle that the turret is on.
    pub turret: Turret,
    /// Whether it has a Y axis; false by default.
    pub y_axis: Option<bool>,
}

impl Machine {
    /// Whether the turret moves along Y. Few lathes have a Y axis, and on the others a Y from a milling
    /// program is an alarm, so the setup must state it.
    pub fn has_y(&self) -> bool {
        self.y_axis == Some(true)
    }
}

/// Travel of the tip in program coordinates: X a diameter, mm.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[serde(default, deny_unknown_fields, rename_all = "camelCase")]
pub struct Travel {
    /// Minimum X, a diameter.
    pub x_min: Option<Diameter>,
    /// Maximum X, a diameter.
    pub x_max: Option<Diameter>,
    /// Minimum Z.
    pub z_min: Option<f64>,
    /// Maximum Z.
    pub z_max: Option<f64>,
}

/// Side of the spindle that the turret is on; the picture has X+ on that side.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema), schemars(inline))]
#[serde(rename_all = "lowercase")]
pub enum Turret {
    /// At the rear: X+ is drawn upwards.
    #[default]
    Rear,
    /// At the front: X+ is drawn downwards.
    Front,
}

/// The centre of the tailstock: a cone of 60° in front of a quill.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Tailstock {
    /// Z of its point, mm.
    pub z: f64,
    /// Diameter of the quill, mm.
    pub diameter: Diameter,
}
