//! The role of a word in its block: the first depth of cut, a coordinate of the end point, an argument.
//!
//! In: a word and the form of its block. Out: its [`Role`]. The build fails if a role lacks a text in one of
//! the languages (`sentences::assist`).

use super::form::Form;
pub use crate::control::codes::role::Role;
use crate::control::codes::{G, Hole, M, MotionMode, Plane};
use crate::control::modal::State;
use crate::geometry::virtual_plane::Surface;
use crate::setup::dialect::FeedMode;
use crate::text::block::Word;
use crate::units::Unit;

impl Role {
    /// The meaning of an M code whose row in the table describes several codes.
    pub fn of_m(number: u64) -> Option<Self> {
        Some(match number {
            0 => Self::ProgramStop,
            1 => Self::OptionalStop,
            3 => Self::SpindleForward,
            4 => Self::SpindleReverse,
            5 => Self::SpindleStop,
            6 => Self::ToolChange,
            7 | 8 => Self::CoolantOn,
            9 => Self::CoolantOff,
            10 | 68 => Self::ChuckClamp,
            11 | 69 => Self::ChuckUnclamp,
            13 => Self::LiveToolForward,
            14 => Self::LiveToolReverse,
            19 => Self::FirstOrientation,
            20 => Self::SecondOrientation,
            23 => Self::PullOutOn,
            24 => Self::PullOutOff,
            25 => Self::TailstockForward,
            26 => Self::TailstockBack,
            45 => Self::CAxisOn,
            46 => Self::CAxisOff,
            90 => Self::SynchronousOn,
            91 => Self::SynchronousOff,
            200 => Self::ConveyorForward,
            201 => Self::ConveyorStop,
            712 => Self::InterlockOff,
            713 => Self::InterlockOn,
            _ => return None,
        })
    }

    /// The meaning of a G code whose row in the table describes several codes.
    pub fn of_g(code: G) -> Option<Self> {
        use crate::control::codes::{HoleReturn, MacroCall};
        Some(match code {
            G::Unit(Unit::Inch) => Self::InchInput,
            G::Unit(Unit::Millimetre) => Self::MetricInput,
            G::Feed(FeedMode::PerMinute) => Self::FeedPerMinute,
            G::Feed(FeedMode::PerTurn) => Self::FeedPerTurn,
            G::Plane(Plane::Xy) => Self::PlaneXy,
            G::Plane(Plane::Zx) => Self::PlaneZx,
            G::Plane(Plane::Yz) => Self::PlaneYz,
            G::Distance { incremental: false } => Self::Absolute,
            G::Distance { incremental: true } => Self::Incremental,
            G::HoleReturn(HoleReturn::Initial) => Self::InitialLevel,
            G::HoleReturn(HoleReturn::RPoint) => Self::RPointLevel,
            G::MacroCall(MacroCall::Once) => Self::MacroOnce,
            G::MacroCall(MacroCall::Modal) => Self::MacroModal,
            G::NoModalMacro => Self::MacroOff,
            G::Data => Self::DataInput,
            G::EndOfData => Self::DataEnd,
            G::Frame(_) => Self::WorkFrame,
            _ => return None,
        })
    }

    /// The role of a word other than G, M, N and O in a block of a form. `surface`: S is a cutting speed;
    /// `c_axis`: C is an axis word.
    pub fn of(word: &Word, form: Form, surface: bool, c_axis: bool) -> Self {
        let letter = word.address;
        match (letter, word.comma, form) {
            (_, _, Form::MacroCall) if !matches!(letter, b'P' | b'L') => return Self::Argument,
            (b'C', true, _) => return Self::Chamfer,
            (b'R', true, _) => return Self::Rounding,
            (b'A', true, _) => return Self::LineAngle,
            (_, true, _) => return Self::Ignored,
            (b'T', ..) => return Self::ToolAndOffset,
            (b'S', _, Form::OneShot(G::Setting)) => return Self::HighestSpeed,
            (b'Q', _, Form::OneShot(G::Setting)) => return Self::LowestSpeed,
            (b'S', ..) if surface => return Self::CuttingSpeed,
            (b'S', ..) => return Self::SpindleSpeed,
            _ => {}
        }
        match form {
            Form::Motion { mode, .. } => of_motion(letter, mode, c_axis),
            Form::Hole { hole, .. } => of_hole(letter, hole),
            Form::Multiple(cycle, block) => cycle.spec().role(block, letter),
            Form::OneShot(code) => of_one_shot(letter, code),
            Form::MacroCall => {
                if letter == b'P' {
                    Self::CalledProgram
                } else {
                    Self::CallRepeats
                }
            }
            Form::Call(call) => of_call(letter, call),
            Form::Macro | Form::Nothing => Self::Ignored,
        }
    }
}

impl Role {
    /// Adjusts the role for an arc outside the plane of turning: the centre is I and J on the end face
    /// (G12.1) and under G17, and J and K under G19 (seed 002, figure 5-5).
    pub fn in_plane_of(self, letter: u8, state: &State) -> Self {
        let on_face = state.virtual_plane.is_some_and(|plane| plane.surface == Surface::Face);
        match (self, letter, state.plane) {
            (Self::Ignored, b'J', _) if on_face => Self::ArcCenterC,
            (Self::Ignored, b'J', Plane::Xy | Plane::Yz) => Self::ArcCenterY,
            (Self::ArcCenterZ, b'K', _) if on_face => Self::Ignored,
            (Self::ArcCenterZ, b'K', Plane::Xy) => Self::Ignored,
            (Self::ArcCenterX, b'I', Plane::Yz) if !on_face => Self::Ignored,
            (role, ..) => role,
        }
    }
}

fn of_motion(letter: u8, mode: MotionMode, c_axis: bool) -> Role {
    let threads = matches!(mode, MotionMode::Thread | MotionMode::VariableThread | MotionMode::Tapping);
    match (letter, mode) {
        (b'F' | b'E', _) if threads => return Role::Lead,
        (b'I', MotionMode::Thread | MotionMode::Tapping) => return Role::ThreadsPerInch,
        (b'Q', _) if threads => return Role::StartAngle,
        (b'K', MotionMode::VariableThread) => return Role::LeadChange,
        (b'F', mode) if !matches!(mode, MotionMode::Cycle(_)) => return Role::Feed,
        _ => {}
    }
    match mode {
        MotionMode::Cycle(cycle) => cycle.spec().role(letter),
        MotionMode::Arc(_) => match letter {
            b'R' => Role::ArcRadius,
            b'I' => Role::ArcCenterX,
            b'K' => Role::ArcCenterZ,
            _ => of_place(letter),
        },
        MotionMode::Line => match letter {
            b'C' if !c_axis => Role::Chamfer,
            b'R' => Role::Rounding,
            b'L' => Role::Chamfer,
            b'D' => Role::Rounding,
            b'I' => Role::CornerX,
            b'K' => Role::CornerZ,
            b'A' => Role::LineAngle,
            _ => of_place(letter),
        },
        MotionMode::Rapid | MotionMode::Thread | MotionMode::VariableThread | MotionMode::Tapping => {
            match letter {
                b'J' if threads => Role::PullOutAcross,
                b'K' if threads => Role::PullOutAlong,
                _ => of_place(letter),
            }
        }
    }
}

/// A coordinate of the end point.
fn of_place(letter: u8) -> Role {
    match letter {
        b'X' => Role::EndX,
        b'Z' => Role::EndZ,
        b'C' => Role::EndC,
        b'Y' => Role::EndY,
        b'U' => Role::WayX,
        b'W' => Role::WayZ,
        b'H' => Role::WayC,
        b'V' => Role::WayY,
        _ => Role::Ignored,
    }
}

fn of_hole(letter: u8, hole: Hole) -> Role {
    match (letter, hole.is_face()) {
        (b'F', _) => Role::Feed,
        (b'R', _) => Role::RPoint,
        (b'Q', _) => Role::HolePeck,
        (b'P', _) => Role::HoleDwell,
        (b'K', _) => Role::Repeats,
        (b'C' | b'H', _) => Role::HoleAngle,
        (b'Z', true) => Role::HoleEndZ,
        (b'W', true) => Role::HoleWayZ,
        (b'X', false) => Role::HoleEndX,
        (b'U', false) => Role::HoleWayX,
        (b'X' | b'U', true) => Role::HolePlaceX,
        (b'Z' | b'W', false) => Role::HolePlaceZ,
        _ => Role::Ignored,
    }
}

fn of_one_shot(letter: u8, code: G) -> Role {
    match (code, letter) {
        (G::Dwell, b'X' | b'U') => Role::DwellSeconds,
        (G::Dwell, b'P') => Role::DwellMilliseconds,
        (G::OtherHome, b'P') => Role::ReferencePoint,
        (G::Home | G::OtherHome | G::CheckHome | G::FromHome, b'X') => Role::ViaX,
        (G::Home | G::OtherHome | G::CheckHome | G::FromHome, b'Z') => Role::ViaZ,
        (G::Home | G::OtherHome | G::CheckHome | G::FromHome, b'C' | b'H') => Role::ViaC,
        (G::Home | G::OtherHome | G::CheckHome | G::FromHome, b'U') => Role::ViaWayX,
        (G::Home | G::OtherHome | G::CheckHome | G::FromHome, b'W') => Role::ViaWayZ,
        (G::Machine, b'X') => Role::MachineX,
        (G::Machine, b'Z') => Role::MachineZ,
        (G::Setting, b'X') => Role::OriginX,
        (G::Setting, b'Z') => Role::OriginZ,
        (G::Setting, b'U') => Role::ShiftX,
        (G::Setting, b'W') => Role::ShiftZ,
        (G::LocalFrame, b'X') => Role::LocalX,
        (G::LocalFrame, b'Z') => Role::LocalZ,
        (G::ExtendedFrame, b'P') => Role::FrameNumber,
        (G::ExtendedFrame, _) => of_place(letter),
        (G::Data, b'P') => Role::DataNumber,
        (G::Data, b'L') => Role::DataKind,
        (G::Data, b'R' | b'C') => Role::DataRadius,
        (G::Data, b'Q') => Role::DataTip,
        (G::Data, b'X' | b'Z' | b'U' | b'W' | b'Y') => Role::DataValue,
        (G::Cylinder, b'C' | b'H') => Role::CylinderRadius,
        (_, b'F') => Role::Feed,
        _ => Role::Ignored,
    }
}

fn of_call(letter: u8, call: M) -> Role {
    match (call, letter) {
        (M::Call, b'P') => Role::CalledProgram,
        (M::LocalCall, b'P') => Role::CalledSequence,
        (M::Return, b'P') => Role::ReturnsTo,
        (_, b'L') => Role::CallRepeats,
        (M::Call, b'Q') => Role::BeginsAt,
        (_, b'F') => Role::Feed,
        _ => of_place(letter),
    }
}
