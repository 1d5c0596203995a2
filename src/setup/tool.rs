//! A tool and its insert.

use serde::Deserialize;

use super::side::Side;
use super::thread_insert::ThreadInsert;
use crate::parts::early;
use crate::units::Diameter;

/// Largest wear value, mm (FANUC parameter 5013).
pub const LARGEST_WEAR: f64 = 9.999;

/// A tool as on a setup sheet. Missing values have the default of its kind.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[serde(default, deny_unknown_fields, rename_all = "camelCase")]
pub struct Tool {
    /// Nose radius, mm; for a grooving insert the radius of its corners.
    pub nose_radius: Option<f64>,
    /// Tip direction, 0 to 9 (FANUC 16/18-T B-62754EN p. 224).
    pub tip: Option<u8>,
    /// Radius of a live cutter, mm.
    pub tool_radius: Option<f64>,
    /// The R entry of the geometry offset, mm.
    pub geometry_r: Option<f64>,
    /// X of the geometry offset: the length of the tool, mm.
    pub geometry_x: Option<Diameter>,
    /// Z of the geometry offset: the length of the tool, mm.
    pub geometry_z: Option<f64>,
    /// X of the wear offset, mm.
    pub wear_x: Option<Diameter>,
    /// Z of the wear offset, mm.
    pub wear_z: Option<f64>,
    /// R of the wear offset, mm: added to the nose radius that compensation uses.
    pub wear_r: Option<f64>,
    /// Kind of the tool.
    #[serde(rename = "type")]
    pub kind: Option<ToolKind>,
    /// Side of the workpiece that a grooving insert or a threading tool is for.
    pub side: Option<Side>,
    /// ISO 1832 designation of the insert: the first letter is its shape, and `CNMG120408` also gives edge
    /// length and nose radius. For a threading tool the designation of a lay-down insert: `16ER AG60`.
    pub insert: Option<String>,
    /// Angle between the two edges of a turning insert, degrees; by default that of its shape.
    pub point_angle: Option<f64>,
    /// Angle of the main edge to the direction of feed along Z, degrees (κr, 95 for a common turning tool).
    pub entering_angle: Option<f64>,
    /// Length of the cutting edge, mm; for a threading tool the length of each flank of its point.
    pub edge_length: Option<f64>,
    /// Width of a grooving insert, mm.
    pub width: Option<f64>,
    /// Diameter of a drill, a tap or a cutter, mm.
    pub diameter: Option<Diameter>,
    /// Length of a grooving insert, a threading point or a drill from its holder, or of a boring bar into the
    /// workpiece, mm.
    pub reach: Option<f64>,
    /// Diameter of a boring bar, mm.
    pub shank: Option<f64>,
    /// Angle of a thread or of the point of a drill, degrees.
    pub angle: Option<f64>,
}

/// Kind of a tool.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema), schemars(inline))]
#[serde(rename_all = "lowercase")]
pub enum ToolKind {
    /// Turns outsides and faces.
    Turning,
    /// Turns bores.
    Boring,
    /// A grooving insert: grooves and parts off.
    Grooving,
    /// Cuts threads with one point.
    Threading,
    /// Drills on the spindle axis.
    Drill,
    /// Taps on the spindle axis.
    Tap,
    /// A live cutter.
    Endmill,
}

impl ToolKind {
    /// All kinds.
    pub const ALL: [ToolKind; 7] =
        [Self::Turning, Self::Boring, Self::Grooving, Self::Threading, Self::Drill, Self::Tap, Self::Endmill];

    /// Name in a setup.
    pub fn name(self) -> &'static str {
        match self {
            Self::Turning => "turning",
            Self::Boring => "boring",
            Self::Grooving => "grooving",
            Self::Threading => "threading",
            Self::Drill => "drill",
            Self::Tap => "tap",
            Self::Endmill => "endmill",
        }
    }
}

/// The meaning of an insert's designation (ISO 1832): lengths in mm, angles in degrees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Insert {
    /// Letter of the shape.
    pub shape: char,
    /// Angle between two edges; `None` for a round one.
    pub point_angle: Option<f64>,
    /// Length of the edge, or diameter of a round insert.
    pub edge_length: Option<f64>,
    /// Nose radius.
    pub nose_radius: Option<f64>,
}

impl Insert {
    /// Parses a designation such as `C`, `DNMG` or `VBMT 160404`; `None` for an unknown shape.
    pub fn read(designation: &str) -> Option<Self> {
        let shape = designation.trim().chars().next()?.to_ascii_uppercase();
        let point_angle = match shape {
            'C' | 'W' => Some(80.0),
            'D' | 'K' => Some(55.0),
            'V' => Some(35.0),
            'T' => Some(60.0),
            'S' => Some(90.0),
            'R' => None,
            _ => return None,
        };
        // Digits in pairs: edge length and thickness in mm, nose radius in tenths.
        let digits: Vec<u32> = designation.chars().filter_map(|c| c.to_digit(10)).collect();
        let pair = |index: usize| match digits.get(2 * index..2 * index + 2) {
            Some([tens, ones]) => Some(f64::from(10 * tens + ones)),
            _ => None,
        };
        Some(Self {
            shape,
            point_angle,
            edge_length: pair(0),
            nose_radius: pair(2).map(|tenths| tenths / 10.0),
        })
    }
}

early! {
    fn read_insert(designation: &str) -> Option<Insert> {
        Insert::read(designation)
    }

    fn read_thread_insert(designation: &str) -> Option<ThreadInsert> {
        ThreadInsert::read(designation)
    }
}

impl Tool {
    /// Its insert, parsed as a turning insert.
    pub fn insert(&self) -> Option<Insert> {
        read_insert(self.insert.as_deref()?)
    }

    /// Its insert, parsed as a threading insert.
    pub fn thread_insert(&self) -> Option<ThreadInsert> {
        let designation = self.insert.as_deref().filter(|_| self.kind == Some(ToolKind::Threading))?;
        read_thread_insert(designation)
    }

    /// Side of the workpiece: as given, or from the designation of its threading insert, or else the outside.
    pub fn working_side(&self) -> Side {
        self.side.or_else(|| self.thread_insert()?.side).unwrap_or_default()
    }

    /// Tip direction: as given, or the default of its kind; 0 if the kind is unknown.
    pub fn tip_direction(&self) -> u8 {
        self.tip.unwrap_or(match (self.kind, self.working_side()) {
            (None | Some(ToolKind::Endmill), _) => 0,
            (Some(ToolKind::Drill | ToolKind::Tap), _) => 7,
            (Some(ToolKind::Turning), _) => 3,
            (Some(ToolKind::Boring), _) => 2,
            // A grooving insert is measured at its left corner (seed 003, example 5), or for face grooves at
            // the lower one.
            (Some(ToolKind::Grooving), Side::Outside | Side::Face) => 3,
            (Some(ToolKind::Grooving), Side::Inside) => 2,
            (Some(ToolKind::Threading), Side::Outside | Side::Face) => 8,
            (Some(ToolKind::Threading), Side::Inside) => 6,
        })
    }

    /// Whether it gives only tool lengths and wear, so that its shape is inferred as that of a tool that is not
    /// given.
    pub fn has_only_offsets(&self) -> bool {
        let shape = Self {
            geometry_x: None,
            geometry_z: None,
            wear_x: None,
            wear_z: None,
            wear_r: None,
            ..self.clone()
        };
        shape == Self::default()
    }

    /// Radius of a rotating cutter, mm: as given, or half of its diameter.
    pub fn cutter_radius(&self) -> Option<f64> {
        self.tool_radius.or(self.diameter.map(Diameter::radius))
    }

    /// The radius that compensation uses, mm: of the cutter, or of the nose. The offset R overrides the
    /// diameter.
    pub fn compensation_radius(&self) -> f64 {
        let cutter = self.cutter_radius().filter(|_| self.kind == Some(ToolKind::Endmill));
        self.tool_radius.or(self.geometry_r).or(cutter).unwrap_or_else(|| self.nose())
    }

    /// Nose radius, mm: as given, or from the insert's designation; 0 if unknown.
    pub fn nose(&self) -> f64 {
        self.known_nose().unwrap_or(0.0)
    }

    fn known_nose(&self) -> Option<f64> {
        self.nose_radius.or_else(|| self.insert()?.nose_radius)
    }

    /// Whether a radius for compensation is known.
    pub fn has_compensation_radius(&self) -> bool {
        let given = self.tool_radius.or(self.geometry_r).or_else(|| self.cutter_radius());
        given.is_some() || self.known_nose().is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn designations() {
        let read = |text| {
            Insert::read(text).map(|insert| (insert.point_angle, insert.edge_length, insert.nose_radius))
        };
        assert_eq!(read("CNMG120408"), Some((Some(80.0), Some(12.0), Some(0.8))));
        assert_eq!(read("vbmt 160404"), Some((Some(35.0), Some(16.0), Some(0.4))));
        assert_eq!(read("D"), Some((Some(55.0), None, None)));
        assert_eq!(read("RCMT 0602"), Some((None, Some(6.0), None)));
        assert_eq!(read("Q"), None);
        assert_eq!(read(""), None);
    }
}
