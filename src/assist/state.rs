//! The state of the control before and after a block: the values in force, and the blocks that set them.
//!
//! In: an executed block. Out: rows in display order, marking what the block changed.

use super::Query;
use super::fact::Quantity;
use super::hover::{code_in_force, feed_of};
use super::place::of_c;
use super::role::Role;
use crate::control::codes::{self, Function, G, GCode, Switch};
use crate::control::contour::ContourUse;
use crate::control::macros::{Found, LOCALS};
use crate::control::modal::{State, Target};
use crate::control::origins::Modal;
use crate::control::program::{Call, CallKind};
use crate::cycles::units;
use crate::geometry::virtual_plane::Surface;
use crate::motion::SpindleTurn;
use crate::playback::timing;
use crate::run::replay::{Moment, Visit};
use crate::setup::dialect::{CodeList, GSystem, PqUnit};
use crate::units::Diameter;

/// A value in force.
#[derive(Clone, Debug, PartialEq)]
pub enum InForce {
    /// A code as the control writes it, its row in the table of codes, and its meaning if the row describes
    /// several codes.
    Code(String, Option<Function>, Option<Role>),
    /// A number.
    Quantity(Quantity),
    /// Two numbers: of X and Z.
    Pair(Quantity, Quantity),
    /// A tool: turret station and offset number.
    Tool(u16, u16),
    /// A value with a name.
    Role(Role),
    /// No value, or off.
    Nothing,
}

/// One value in force, before and after a block.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Which value.
    pub modal: Modal,
    /// Value before the block.
    pub before: InForce,
    /// Value after the block.
    pub after: InForce,
    /// First byte of the block that set the value; `None` if it is unchanged since power-on.
    pub since: Option<u32>,
}

/// Position of one axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisRow {
    /// `X`, `Y`, `Z` or `C`.
    pub axis: char,
    /// Position before the block.
    pub before: Quantity,
    /// Position after the block.
    pub after: Quantity,
}

/// A macro variable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VariableRow {
    /// Its number.
    pub number: u32,
    /// Value before the block; `None` if vacant.
    pub before: Option<f64>,
    /// Value after the block.
    pub after: Option<f64>,
    /// First byte of the block that set the value; `None` if no block has set it.
    pub since: Option<u32>,
}

/// A call or loop in progress.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Frame {
    /// A program that was called.
    Call {
        /// Kind of call.
        kind: CallKind,
        /// First byte of its first block.
        head: u32,
        /// First byte of the calling block.
        caller: u32,
        /// Remaining repetitions, including the current one.
        rounds_left: u32,
    },
    /// A loop.
    Loop {
        /// Number m of its DO.
        number: u32,
        /// First byte of its first block.
        head: u32,
    },
}

/// The state of the control at a block.
#[derive(Clone, Debug, PartialEq)]
pub struct StateTable {
    /// Number of this visit of the block, from 1. A visit is an execution, or a reading by a cycle.
    pub number: u32,
    /// Number of visits of the block in the run.
    pub times: u32,
    /// Number of this execution, from 1; 0 if a cycle only reads the block.
    pub carried_out: u32,
    /// Why a cycle reads the block as a part of its contour; `None` if the block is executed.
    pub purpose: Option<ContourUse>,
    /// Positions of the axes.
    pub axes: Vec<AxisRow>,
    /// Spindle speed and cutting speed after the block, if known.
    pub speeds: Option<(Quantity, Quantity)>,
    /// The values in force.
    pub rows: Vec<Row>,
    /// Variables with a value before or after the block.
    pub variables: Vec<VariableRow>,
    /// Number of variables not shown.
    pub variables_hidden: usize,
    /// Calls and loops in progress, the outermost first.
    pub frames: Vec<Frame>,
}

/// Maximum number of variables shown.
const MAX_VARIABLES: usize = 200;

impl Query<'_> {
    /// The state before and after the block; `None` if it is never executed.
    pub fn state(&self) -> Option<StateTable> {
        let visit = self.visit?;
        let (before, after) = (&visit.before, &visit.after);
        let rows = Modal::ALL.iter().filter_map(|&modal| self.row(modal, before, after)).collect();
        let (variables, variables_hidden) = variables(visit);
        Some(StateTable {
            number: visit.number,
            times: self.times,
            carried_out: visit.carried_out,
            purpose: visit.purpose,
            axes: axes(&before.state, &after.state),
            speeds: self.speeds(&after.state),
            rows,
            variables,
            variables_hidden,
            frames: frames(&before.state),
        })
    }

    fn row(&self, modal: Modal, before: &Moment, after: &Moment) -> Option<Row> {
        let [was, is] =
            [before, after].map(|moment| in_force(modal, &moment.state, self.codes, self.dialect.pq_unit));
        let since = after.origins.since(modal);
        // Hide rarely used values that the program never set.
        let is_shown = is_always_shown(modal, self.dialect.g_system)
            || (since.is_some() && is != InForce::Nothing)
            || before.origins.since(modal).is_some() && was != InForce::Nothing
            || goes_with(modal).is_some_and(|other| after.origins.since(other).is_some());
        is_shown.then_some(Row { modal, before: was, after: is, since })
    }

    fn speeds(&self, state: &State) -> Option<(Quantity, Quantity)> {
        let x = state.turning_place().x;
        let speed = timing::speed_at(&state.process(), &self.setup.machine, x)?;
        Some((Quantity::Speed(speed), Quantity::CuttingSpeed(timing::surface_speed(speed, x))))
    }
}

/// Another value of the same cycle: if the program has set it, this one is shown, too.
fn goes_with(modal: Modal) -> Option<Modal> {
    match modal {
        Modal::Escape => Some(Modal::Depth),
        Modal::ThreadFinishing | Modal::ThreadAngle | Modal::ThreadAllowance => Some(Modal::ThreadLeast),
        _ => None,
    }
}

/// Values that are always shown.
fn is_always_shown(modal: Modal, system: GSystem) -> bool {
    match modal {
        Modal::Motion
        | Modal::FeedMode
        | Modal::Feed
        | Modal::SpeedMode
        | Modal::Speed
        | Modal::SpindleTurn
        | Modal::Tool
        | Modal::Compensation
        | Modal::Frame
        | Modal::Unit => true,
        Modal::Distance => system != GSystem::A,
        _ => false,
    }
}

fn in_force(modal: Modal, state: &State, list: CodeList, pq_unit: PqUnit) -> InForce {
    let (cycle, multiple) = (&state.memory, &state.parameters);
    let length = |length: f64| InForce::Quantity(Quantity::Length(length));
    let optional = |value: Option<f64>| value.map_or(InForce::Nothing, length);
    match modal {
        Modal::Motion => code(G::Motion(state.motion), list),
        Modal::FeedMode => code(G::Feed(state.feed_mode), list),
        Modal::SpeedMode if state.spindle.surface => code(G::SurfaceSpeed, list),
        Modal::SpeedMode => code(G::ConstantSpeed, list),
        Modal::Compensation => code(G::Compensation(state.compensation), list),
        Modal::Unit => code(G::Unit(state.unit), list),
        Modal::Distance => code(G::Distance { incremental: state.incremental }, list),
        Modal::Plane => code(G::Plane(state.plane), list),
        Modal::Hole => state.hole.map_or(InForce::Nothing, |memory| code(G::Hole(memory.kind), list)),
        Modal::HoleReturn => code(G::HoleReturn(state.hole_return), list),
        Modal::Frame => match code_in_force(modal, state, list) {
            Some(text) => InForce::Code(text, Some(Function::Frame), Some(Role::WorkFrame)),
            None => InForce::Nothing,
        },
        Modal::Zero => {
            let zero = state.frames.offset();
            InForce::Pair(Quantity::Diameter(Diameter::from_radius(zero.x)), Quantity::Length(zero.z))
        }
        Modal::Interpolation => match state.interpolation() {
            Some(plane) if plane.surface == Surface::Face => code(G::Polar(Switch::On), list),
            Some(_) => code(G::Cylinder, list),
            None => InForce::Nothing,
        },
        Modal::ModalMacro if state.call_stack.modal.is_some() => InForce::Role(Role::MacroModal),
        Modal::ModalMacro => InForce::Nothing,
        Modal::Feed => feed_of(state).map_or(InForce::Nothing, InForce::Quantity),
        Modal::Speed if state.spindle.surface => {
            InForce::Quantity(Quantity::CuttingSpeed(state.spindle.cutting_speed))
        }
        Modal::Speed => InForce::Quantity(Quantity::Speed(state.spindle.rpm)),
        Modal::HighestSpeed => speed(state.spindle.highest),
        Modal::LowestSpeed => speed(state.spindle.lowest),
        Modal::SpindleTurn => InForce::Role(match state.spindle.turn {
            SpindleTurn::Stopped => Role::SpindleStop,
            SpindleTurn::Forward => Role::SpindleForward,
            SpindleTurn::Reverse => Role::SpindleReverse,
        }),
        Modal::LiveTool if state.spindle.live_tool => InForce::Role(Role::LiveTool),
        Modal::LiveTool => InForce::Nothing,
        Modal::Tool if state.tool == (0, 0) => InForce::Nothing,
        Modal::Tool => InForce::Tool(state.tool.0, state.tool.1),
        Modal::CAxis => InForce::Role(if state.c_axis { Role::CAxisOn } else { Role::CAxisOff }),
        Modal::ThreadPullOut => {
            InForce::Role(if state.thread_chamfer_on { Role::PullOutOn } else { Role::PullOutOff })
        }
        Modal::CycleX => target(cycle.x, true),
        Modal::CycleZ => target(cycle.z, false),
        Modal::CycleTaper if cycle.taper == 0.0 => InForce::Nothing,
        Modal::CycleTaper => length(cycle.taper),
        Modal::Depth => optional(multiple.depth),
        Modal::Escape => length(multiple.escape),
        Modal::Relief => multiple.relief.map_or(InForce::Nothing, |relief| {
            InForce::Pair(Quantity::Length(relief.x), Quantity::Length(relief.z))
        }),
        Modal::PatternPasses => multiple
            .pattern_passes
            .map_or(InForce::Nothing, |count| InForce::Quantity(Quantity::Count(count))),
        Modal::Retract => length(multiple.retract),
        Modal::ThreadFinishing => InForce::Quantity(Quantity::Count(f64::from(multiple.finishing))),
        Modal::ThreadAngle => InForce::Quantity(Quantity::Degrees(multiple.angle)),
        Modal::ThreadLeast => optional(multiple.least_amount.map(|amount| {
            let reading = match pq_unit {
                PqUnit::Um => units::Reading::Micrometres,
                PqUnit::Mm => units::Reading::Millimetres(units::Because::Point),
                PqUnit::Auto => units::threading(Some(amount), None, None),
            };
            amount.mm(reading, state.unit)
        })),
        Modal::ThreadAllowance => length(multiple.thread_allowance),
    }
}

fn code(code: G, list: CodeList) -> InForce {
    match codes::written(code, list) {
        Some(text) => {
            let found = codes::g_code_of(code);
            InForce::Code(text, found.map(GCode::function), found.and_then(GCode::role))
        }
        None => InForce::Nothing,
    }
}

fn speed(speed: Option<f64>) -> InForce {
    speed.map_or(InForce::Nothing, |speed| InForce::Quantity(Quantity::Speed(speed)))
}

fn target(target: Target, across: bool) -> InForce {
    let place = |place: f64| match across {
        true => Quantity::Diameter(Diameter::from_radius(place)),
        false => Quantity::Length(place),
    };
    match target {
        Target::Stay => InForce::Nothing,
        Target::Absolute(at) => InForce::Quantity(place(at)),
        Target::Incremental(way) => {
            InForce::Quantity(Quantity::Length(if across { Diameter::from_radius(way).mm() } else { way }))
        }
    }
}

fn axes(before: &State, after: &State) -> Vec<AxisRow> {
    let across = |radius: f64| Quantity::Diameter(Diameter::from_radius(radius));
    let (from, to) = (before.turning_place(), after.turning_place());
    let mut axes = vec![
        AxisRow { axis: 'X', before: across(from.x), after: across(to.x) },
        AxisRow { axis: 'Z', before: Quantity::Length(from.z), after: Quantity::Length(to.z) },
    ];
    let [was, is] = [before.place_along_y(), after.place_along_y()];
    if was != 0.0 || is != 0.0 {
        axes.insert(1, AxisRow { axis: 'Y', before: Quantity::Length(was), after: Quantity::Length(is) });
    }
    let [was, is] = [before.place_of_c(), after.place_of_c()];
    if before.c_axis || after.c_axis || was != 0.0 || is != 0.0 {
        axes.push(AxisRow { axis: 'C', before: of_c(before, was), after: of_c(after, is) });
    }
    axes
}

/// The variables with a value, those changed by the block first; and the number of hidden ones.
fn variables(visit: &Visit) -> (Vec<VariableRow>, usize) {
    let value = |moment: &Moment, number: u32| match moment.state.variables.read(number) {
        Ok(Found::Value(value)) => value,
        _ => None,
    };
    let level = visit.after.state.variables.level();
    let numbers = (1..=LOCALS as u32).chain(100..200).chain(500..1000);
    let mut rows: Vec<_> = numbers
        .filter_map(|number| {
            let (before, after) = (value(&visit.before, number), value(&visit.after, number));
            let since = visit.after.origins.set_by(level, number);
            (before.is_some() || after.is_some()).then_some(VariableRow { number, before, after, since })
        })
        .collect();
    let (changed, same): (Vec<_>, Vec<_>) = rows.drain(..).partition(|row| row.before != row.after);
    rows.extend(changed);
    rows.extend(same);
    let hidden = rows.len().saturating_sub(MAX_VARIABLES);
    rows.truncate(MAX_VARIABLES);
    (rows, hidden)
}

fn frames(state: &State) -> Vec<Frame> {
    let stack = &state.call_stack;
    let loops = |loops: &[crate::control::program::Loop]| {
        loops.iter().map(|own| Frame::Loop { number: own.number, head: own.head.byte }).collect::<Vec<_>>()
    };
    let mut frames = loops(stack.loops_of_main());
    for Call { kind, head, caller, rounds, loops: own, .. } in &stack.calls {
        frames.push(Frame::Call { kind: *kind, head: head.byte, caller: *caller, rounds_left: *rounds });
        frames.extend(loops(own));
    }
    frames
}
