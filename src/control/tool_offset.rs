//! The tool offset in force: the tool nose according to setup and program.
//!
//! In: state and setup. Out: radius and tip direction.

use super::compensation::Nose;
use super::modal::State;
use super::offsets::Column;
use crate::setup::{Setup, Tool};

/// Radius (mm; negative if the offset reverses the side of compensation) and tip direction of the offset in
/// force. Values written by the program override the setup.
pub fn nose_entry(state: &State, setup: &Setup) -> (f64, u8) {
    let (station, offset) = state.tool;
    if offset == 0 {
        return (0.0, 0);
    }
    let tool: Option<&Tool> = setup.tools.get(&format!("T{station:02}{offset:02}"));
    let (radius, tip) = tool.map_or((0.0, 0), |tool| (tool.compensation_radius(), tool.tip_direction()));
    let written = |column| state.offsets.get(offset, column);
    let radius = written(Column::Radius).unwrap_or(radius) + written(Column::WearRadius).unwrap_or(0.0);
    (radius, written(Column::Tip).map_or(tip, |tip| tip as u8))
}

/// The offset in force, if neither the setup nor the program defines it: the machine's own table may.
pub fn unknown(state: &State, setup: &Setup) -> Option<u16> {
    let (station, offset) = state.tool;
    let known = setup.tools.contains_key(&format!("T{station:02}{offset:02}"))
        || state.offsets.get(offset, Column::Radius).is_some();
    (offset != 0 && !known).then_some(offset)
}

/// The offset in force, if neither the setup nor the program gives its nose radius.
pub fn unknown_radius(state: &State, setup: &Setup) -> Option<u16> {
    let (station, offset) = state.tool;
    let tool = setup.tools.get(&format!("T{station:02}{offset:02}"));
    let known = tool.is_some_and(Tool::has_compensation_radius)
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
