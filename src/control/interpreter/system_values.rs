//! System variables (#1000 and up): values of the control that a program can read.
//!
//! In: numbers of variables. Out: values as in a program: X is a diameter, lengths are in the program's unit.

use super::Interpreter;
use crate::control::codes::{Compensation, Plane};
use crate::control::modal::State;
use crate::control::offsets::{Column, EXTENDED_FRAMES, STANDARD_FRAMES, Setting};
use crate::control::tool_offset;
use crate::geometry::Point;
use crate::message::{Diagnostic, said};
use crate::setup::dialect::FeedMode;
use crate::text::block::Block;
use crate::units::{Diameter, Unit};

/// Meaning of a system variable.
pub(super) enum System {
    /// Modal G code of a group.
    Group(u32),
    /// F, M, N, O, S, T in force.
    Letter(u8),
    /// X, Z or C of the tip, in the work frame.
    Work(u32),
    /// The same in machine coordinates.
    Machine(u32),
    /// X or Z of the external shift, or of the zero of a frame.
    External(u32),
    Frame(u16, u32),
    /// A column of the offset table.
    Offset(u16, Column),
    /// A stored number: counters, switches, and outputs to the machine builder's interface.
    Kept,
}

/// Columns of the offset table in memory A, by the first variable of each column.
const COLUMNS: [(u32, Column); 7] = [
    (2000, Column::WearX),
    (2100, Column::WearZ),
    (2200, Column::WearRadius),
    (2300, Column::Tip),
    (2700, Column::X),
    (2800, Column::Z),
    (2900, Column::Radius),
];

/// The same for tables with more than 64 offsets.
const LONG_COLUMNS: [(u32, Column); 7] = [
    (10_000, Column::WearX),
    (11_000, Column::WearZ),
    (12_000, Column::WearRadius),
    (13_000, Column::Tip),
    (15_000, Column::X),
    (16_000, Column::Z),
    (17_000, Column::Radius),
];

impl System {
    pub(super) fn of(variable: u32) -> Option<Self> {
        let column = |table: &[(u32, Column)], last: u32| {
            let found = table.iter().find(|(first, _)| (first + 1..=first + last).contains(&variable));
            found.map(|&(first, column)| Self::Offset((variable - first) as u16, column))
        };
        match variable {
            1000..=1999 | 3001..=3008 | 3901 | 3902 => Some(Self::Kept),
            2000..=2999 => column(&COLUMNS, 99),
            10_000..=17_999 => column(&LONG_COLUMNS, 999),
            4001..=4030 => Some(Self::Group(variable - 4000)),
            4201..=4230 => Some(Self::Group(variable - 4200)),
            4109 | 4309 => Some(Self::Letter(b'F')),
            4113 | 4313 => Some(Self::Letter(b'M')),
            4114 | 4314 => Some(Self::Letter(b'N')),
            4115 | 4315 => Some(Self::Letter(b'O')),
            4119 | 4319 => Some(Self::Letter(b'S')),
            4120 | 4320 => Some(Self::Letter(b'T')),
            5001..=5003 | 5041..=5043 | 5061..=5063 => Some(Self::Work(variable % 20)),
            5021..=5023 => Some(Self::Machine(variable % 20)),
            5081..=5083 => Some(Self::Kept),
            5201 | 5202 => Some(Self::External(variable - 5200)),
            5221..=5339 if (1..=2).contains(&(variable % 20)) => {
                Some(Self::Frame(((variable - 5221) / 20) as u16, variable % 20))
            }
            7001..
                if variable < 7001 + 20 * u32::from(EXTENDED_FRAMES)
                    && (1..=2).contains(&(variable % 20)) =>
            {
                let frame = STANDARD_FRAMES + ((variable - 7001) / 20) as u16;
                Some(Self::Frame(frame, variable % 20))
            }
            _ => None,
        }
    }
}

impl Interpreter {
    /// Reads a system variable. A variable that is unknown here is vacant, and reported once.
    pub(super) fn read_system(&mut self, text: &[u8], block: &Block, variable: u32) -> Option<f64> {
        let value = self.system_value(text, block, variable);
        if value.is_none() {
            self.unknown_system(block, variable);
        } else if self.state.call_stack.main_pass.is_new(self.main_block(block.span.start), variable) {
            let at_start = self.system_at_start(text, block, variable);
            self.note_access(block.span.start, variable, at_start.map(Some));
        }
        value
    }

    pub(super) fn unknown_system(&mut self, block: &Block, variable: u32) {
        self.report(Diagnostic::new(said::SystemVariable { variable }, block.words_span()));
    }

    /// The value of a system variable at the beginning of the pass of the main program; `None` if the pass
    /// has assigned it before this block.
    fn system_at_start(&mut self, text: &[u8], block: &Block, variable: u32) -> Option<f64> {
        let system = System::of(variable)?;
        if let System::Kept = system {
            return self.system_value(text, block, variable);
        }
        let pass = &self.state.call_stack.main_pass;
        if let System::Work(axis @ 1..=2) | System::Machine(axis @ 1..=2) = system
            && pass.absolute_axes[axis as usize - 1]
        {
            return None;
        }
        let at_start = match pass.is_first() {
            true => {
                let power_on = State::new(&self.setup, &self.dialect);
                let now = std::mem::replace(&mut self.state, power_on);
                let value = self.system_value(text, block, variable);
                self.state = now;
                value?
            }
            false => pass.system_at_start(variable),
        };
        // Only an absolute assignment changes these.
        let is_set = matches!(system, System::Group(_) | System::Letter(_));
        let is_unchanged =
            !is_set || at_start.is_nan() || self.system_value(text, block, variable) == Some(at_start);
        is_unchanged.then_some(at_start)
    }

    /// The value of a system variable; `None` if the variable is unknown here.
    pub(super) fn system_value(&mut self, text: &[u8], block: &Block, variable: u32) -> Option<f64> {
        let unit = self.state.unit.millimetres();
        let coordinate = |place: Point, axis: u32| match axis {
            1 => Diameter::from_radius(place.x).mm() / unit,
            _ => place.z / unit,
        };
        let system = System::of(variable)?;
        let state = &self.state;
        let offset = state.frames.offset();
        Some(match system {
            System::Group(group) => f64::from(self.modal_code(group)) / 10.0,
            System::Letter(b'F') => state.feed.unwrap_or(0.0) / unit,
            System::Letter(b'S') if state.spindle.surface => {
                state.spindle.cutting_speed / state.unit.surface_metres()
            }
            System::Letter(b'S') => state.spindle.rpm,
            System::Letter(b'T') => f64::from(state.tool.0) * 100.0 + f64::from(state.tool.1),
            System::Letter(b'M') => f64::from(state.m_code),
            System::Letter(b'N') => f64::from(state.sequence),
            System::Letter(_) => {
                let at = block.span.start;
                f64::from(self.program.labels(text).number_at(at).unwrap_or(0))
            }
            System::Work(3) | System::Machine(3) => state.place_of_c(),
            System::Work(axis) => coordinate(state.turning_place(), axis),
            System::Machine(axis) => {
                coordinate(state.turning_place().moved(offset).moved(state.tip_shift), axis)
            }
            System::External(axis) => coordinate(state.frames.external, axis),
            System::Frame(frame, axis) => coordinate(state.frames.work(frame), axis),
            System::Offset(offset, column) => {
                let value = tool_offset::value(&self.state, &self.setup, offset, column);
                if column == Column::Tip { value } else { value / unit }
            }
            System::Kept => state.system.get(&variable).copied().unwrap_or(0.0),
        })
    }

    /// Writes a column of a tool offset, mm.
    pub(super) fn set_offset(&mut self, offset: u16, column: Column, value: f64, setting: Setting) {
        if self.has(tool_offset::OFFSETS) {
            tool_offset::write(&mut self.state, &self.setup, (offset, column), value, setting);
            self.update_tip_shift();
        }
    }

    /// Ten times the G code in force in a modal group.
    fn modal_code(&self, group: u32) -> u32 {
        let state = &self.state;
        if group == 1 {
            return state.motion.key();
        }
        10 * match group {
            2 => 96 + u32::from(!state.spindle.surface),
            3 => 90 + u32::from(state.incremental),
            5 => 98 + u32::from(state.feed_mode == FeedMode::PerTurn),
            6 => 20 + u32::from(state.unit == Unit::Millimetre),
            7 => match state.compensation {
                Compensation::Off => 40,
                Compensation::Left => 41,
                Compensation::Right => 42,
            },
            9 => 22,
            10 => state.hole.as_ref().map_or(80, |hole| hole.kind.number()),
            12 => 66 + u32::from(state.call_stack.modal.is_none()),
            14 => 54 + u32::from(state.frames.active.min(STANDARD_FRAMES - 1)),
            16 => match state.plane {
                Plane::Xy => 17,
                Plane::Zx => 18,
                Plane::Yz => 19,
            },
            21 => 113 - u32::from(state.interpolation().is_some()),
            _ => 0,
        }
    }
}
