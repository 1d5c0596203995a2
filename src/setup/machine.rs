//! What the machine can do, and what stands in its way.

use serde::Deserialize;

use crate::units::Diameter;

/// The machine. What is not given is not known, and nothing is made up for it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "camelCase")]
pub struct Machine {
    /// Rapid rate along X, mm of the slide a minute.
    pub rapid_x: Option<f64>,
    /// Rapid rate along Z, mm/min.
    pub rapid_z: Option<f64>,
    /// Highest speed of the spindle, rpm.
    pub max_speed: Option<f64>,
    /// K of the rule of thumb for threads, n ≤ 1200/P − K, rpm (seed 001); 80 where nothing is said. A slide that
    /// is slow to reach its speed needs more.
    pub thread_speed_margin: Option<f64>,
    /// Where the tip can go.
    pub travel: Travel,
    /// Which side of the spindle the turret is on.
    pub turret: Turret,
    /// Whether it has a Y axis; where nothing is said, it has none.
    pub y_axis: Option<bool>,
}

impl Machine {
    /// Whether the turret moves along Y. Few lathes do, and on the others a Y of a milling program is an alarm: so this
    /// has to be said.
    pub fn has_y(&self) -> bool {
        self.y_axis == Some(true)
    }
}

/// Where the tip can go, in the coordinates of the program: X a diameter, mm.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize)]
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

/// Which side of the spindle the turret is on; the picture has X+ on that side.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Turret {
    /// At the rear: X+ is drawn upwards.
    #[default]
    Rear,
    /// In front of it: X+ is drawn downwards.
    Front,
}

/// The centre of the tailstock: a cone of 60° in front of a quill.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Tailstock {
    /// Z of its point, mm.
    pub z: f64,
    /// Diameter of the quill, mm.
    pub diameter: Diameter,
}
