//! System variables that a program assigns.
//!
//! In: numbers of variables. Out: values as in a program: X is a diameter, lengths are in the program's unit.

use super::Interpreter;
use super::system_values::System;
use crate::control::offsets::{Column, Setting};
use crate::geometry::Point;
use crate::text::block::Block;
use crate::units::Diameter;

impl Interpreter {
    /// Writes a system variable. A variable that is unknown here is reported once and ignored. `setting`:
    /// whether the value was computed from the previous one.
    pub(super) fn write_system(
        &mut self,
        block: &Block,
        variable: u32,
        value: Option<f64>,
        setting: Setting,
    ) {
        let unit = self.state.unit.millimetres();
        let value = value.unwrap_or(0.0);
        self.trace_write(variable, value);
        match System::of(variable) {
            Some(System::External(axis)) => {
                self.change_frame(|frames| set_axis(&mut frames.external, axis, value * unit));
            }
            Some(System::Frame(frame, axis)) => {
                let change = |zero: &mut Point| set_axis(zero, axis, value * unit);
                self.set_zero(frame, setting, change, block.words_span());
            }
            Some(System::Offset(offset, Column::Tip)) => {
                self.set_offset(offset, Column::Tip, value, setting);
            }
            Some(System::Offset(offset, column)) => self.set_offset(offset, column, value * unit, setting),
            Some(System::Kept) => {
                std::sync::Arc::make_mut(&mut self.state.system).insert(variable, value);
            }
            Some(System::Group(_) | System::Letter(_) | System::Work(_) | System::Machine(_)) | None => {
                self.unknown_system(block, variable);
            }
        }
    }
}

/// Sets a zero along X (axis 1, a diameter) or Z.
fn set_axis(zero: &mut Point, axis: u32, value: f64) {
    match axis {
        1 => zero.x = Diameter::new(value).radius(),
        _ => zero.z = value,
    }
}
