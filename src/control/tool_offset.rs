//! The tool offset in force, according to setup and program.
//!
//! In: state and setup. Out: the tool nose, its radius and tip direction; the shift of the tip.

use super::compensation::Nose;
use super::modal::State;
use super::offsets::{Column, Setting};
use crate::geometry::Point;
use crate::parts::{Part, early};
use crate::setup::{Setup, Tool};
use crate::units::Diameter;

/// The part of the module that reads and writes the values of offsets.
pub const OFFSETS: Part = Part::Early;

early! {
    /// Position of the tip minus the programmed position with the offset in force, mm, X as a radius.
    ///
    /// Coordinates are positions of the tip, so the length of a tool (the geometry X and Z of the setup)
    /// moves nothing. Wear does, and so does a change of the geometry by the program. Offset 00 cancels both.
    pub fn tip_shift(state: &State, setup: &Setup) -> Point {
        let (station, offset) = state.tool;
        if offset == 0 {
            return Point::default();
        }
        let tool = tool_of(setup, station, offset);
        let written = |column| state.offsets.tip_shift(offset, column);
        let along = |wear, given: Option<f64>, geometry| {
            written(wear).or(given).unwrap_or(0.0) + written(geometry).unwrap_or(0.0)
        };
        let wear_x = tool.and_then(|tool| tool.wear_x).map(Diameter::mm);
        Point::new(
            Diameter::new(along(Column::WearX, wear_x, Column::X)).radius(),
            along(Column::WearZ, tool.and_then(|tool| tool.wear_z), Column::Z),
        )
    }

    /// A column of a tool offset, mm (X values as diameters, as in the table): as written by the program,
    /// otherwise as in the setup.
    pub fn value(state: &State, setup: &Setup, offset: u16, column: Column) -> f64 {
        let of_setup = || setup_offset(setup, state.tool.0, offset, column);
        state.offsets.get(offset, column).or_else(of_setup).unwrap_or(0.0)
    }

    /// Writes a column of a tool offset, mm.
    pub fn write(
        state: &mut State,
        setup: &Setup,
        entry: (u16, Column),
        value: f64,
        setting: Setting,
    ) {
        let (offset, column) = entry;
        let length = match column {
            Column::X | Column::Z => setup_offset(setup, state.tool.0, offset, column),
            _ => None,
        };
        state.offsets.set(offset, column, value, length, setting);
    }
}

/// A tool offset of the setup, mm (X values as diameters, as in the table).
fn setup_offset(setup: &Setup, station: u16, offset: u16, column: Column) -> Option<f64> {
    let tool = tool_of(setup, station, offset)?;
    match column {
        Column::WearX => tool.wear_x.map(Diameter::mm),
        Column::WearZ => tool.wear_z,
        Column::WearRadius => tool.wear_r,
        Column::X => tool.geometry_x.map(Diameter::mm),
        Column::Z => tool.geometry_z,
        Column::Radius => Some(tool.compensation_radius()),
        Column::Tip => Some(f64::from(tool.tip_direction())),
    }
}

/// The tool with an offset: that of the station, or else any tool with this offset number, because the table
/// of the control has one row for each number.
fn tool_of(setup: &Setup, station: u16, offset: u16) -> Option<&Tool> {
    let ends = |key: &str| key.len() == 5 && key.is_ascii() && key[3..].parse() == Ok(offset);
    let own = setup.tool((station, offset));
    own.or_else(|| setup.tools.iter().find(|(key, _)| ends(key)).map(|(_, tool)| tool))
}

/// Radius (mm; negative if the offset reverses the side of compensation) and tip direction of the offset in
/// force. Values written by the program override the setup.
pub fn nose_entry(state: &State, setup: &Setup) -> (f64, u8) {
    let (station, offset) = state.tool;
    if offset == 0 {
        return (0.0, 0);
    }
    let tool: Option<&Tool> = setup.tool((station, offset));
    let described = setup.described_nose(station).map_or((0.0, 0), |nose| (nose.radius, nose.tip));
    let (radius, tip) = tool.map_or(described, |tool| (tool.compensation_radius(), tool.tip_direction()));
    let written = |column| state.offsets.get(offset, column);
    let wear = tool.and_then(|tool| tool.wear_r).unwrap_or(0.0);
    let radius = written(Column::Radius).unwrap_or(radius) + written(Column::WearRadius).unwrap_or(wear);
    (radius, written(Column::Tip).map_or(tip, |tip| tip as u8))
}

/// The offset in force, if neither the setup nor the program defines it: the machine's own table may.
pub fn unknown(state: &State, setup: &Setup) -> Option<u16> {
    let (station, offset) = state.tool;
    let known =
        setup.tool((station, offset)).is_some() || state.offsets.get(offset, Column::Radius).is_some();
    (offset != 0 && !known).then_some(offset)
}

/// The offset in force, if neither the setup nor the program gives its nose radius.
pub fn unknown_radius(state: &State, setup: &Setup) -> Option<u16> {
    let (station, offset) = state.tool;
    let tool = setup.tool((station, offset));
    let known = tool.map_or(setup.described_nose(station).is_some(), Tool::has_compensation_radius)
        || state.offsets.get(offset, Column::Radius).is_some()
        || state.offsets.get(offset, Column::WearRadius).is_some();
    (offset != 0 && !known).then_some(offset)
}

/// The nose of the tool in force.
pub fn nose(state: &State, setup: &Setup) -> Nose {
    let (radius, tip) = nose_entry(state, setup);
    // In a virtual plane the cutter's centre is programmed.
    Nose { radius: radius.abs(), tip: if state.virtual_plane.is_some() { 0 } else { tip } }
}
