//! The table of G and M codes.
//!
//! In: the number of a G or M word. Out: what it asks for, and the modal group it belongs to. System A of a
//! FANUC 0i-T and GSK 980TD; facts from semantics §2.1 and §8.1.

use super::dialect::{FeedMode, GSystem};
use super::words::Unit;
use crate::cycles::single::Single;
use crate::geometry::Turn;
use crate::motion::{Cycle, SpindleTurn};

/// What a G code asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum G {
    /// G00 to G03, G32 to G34, G90, G92, G94, and the codes of group 01 that are not done yet.
    Motion(MotionMode),
    /// G04.
    Dwell,
    /// G17, G18, G19.
    Plane(Plane),
    /// G20, G21.
    Unit(Unit),
    /// G27.
    CheckHome,
    /// G28.
    Home,
    /// G29.
    FromHome,
    /// G30: to another reference point.
    OtherHome,
    /// G53.
    Machine,
    /// G10.
    Data,
    /// G11.
    EndOfData,
    /// G90, G91 of systems B and C.
    Distance {
        /// G91.
        incremental: bool,
    },
    /// G80 to G89.
    Hole(Hole),
    /// G98, G99 of systems B and C.
    HoleReturn(HoleReturn),
    /// G80.
    NoHole,
    /// G65 and G66.
    MacroCall(&'static str),
    /// G67.
    NoModalMacro,
    /// G40, G41, G42.
    Compensation(Compensation),
    /// G50.
    Setting,
    /// G52.
    LocalFrame,
    /// G54 to G59, counted from 0.
    Frame(u16),
    /// G54.1 with P.
    ExtendedFrame,
    /// G12.1, G13.1: polar interpolation.
    Polar(Switch),
    /// G07.1: cylindrical interpolation.
    Cylinder,
    /// G96.
    SurfaceSpeed,
    /// G97.
    ConstantSpeed,
    /// G98, G99.
    Feed(FeedMode),
    /// G70 to G76.
    Multiple(Multiple),
    /// Accepted; nothing in this project depends on it.
    Idle,
    /// Recognised; the block's axis words are not carried out.
    NotSupported,
}

/// The hole cycles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "each is one code; into the face, then into the side")]
pub enum Hole {
    G81,
    G82,
    G83,
    G84,
    G85,
    G86,
    G87,
    G88,
    G89,
}

impl Hole {
    /// The code.
    pub fn code(self) -> &'static str {
        self.cycle().code()
    }

    /// Number of the code.
    pub fn number(self) -> u32 {
        81 + self as u32
    }

    /// Whether it goes along Z.
    pub fn is_face(self) -> bool {
        !matches!(self, Self::G87 | Self::G88 | Self::G89)
    }

    /// Whether it drills, rather than taps or bores.
    pub fn is_drill(self) -> bool {
        matches!(self, Self::G81 | Self::G82 | Self::G83 | Self::G87)
    }

    /// Whether it taps.
    pub fn is_tap(self) -> bool {
        matches!(self, Self::G84 | Self::G88)
    }

    /// The cycle as motions name it.
    pub fn cycle(self) -> Cycle {
        match self {
            Self::G81 => Cycle::Drilling,
            Self::G82 => Cycle::CounterBoring,
            Self::G83 => Cycle::FaceDrilling,
            Self::G84 => Cycle::FaceTapping,
            Self::G85 => Cycle::FaceBoring,
            Self::G86 => Cycle::BoringStop,
            Self::G87 => Cycle::SideDrilling,
            Self::G88 => Cycle::SideTapping,
            Self::G89 => Cycle::SideBoring,
        }
    }
}

/// Where the tool goes behind a hole (G98 and G99 of systems B and C; system A knows only the first).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HoleReturn {
    /// To the initial level.
    Initial,
    /// To the R point.
    RPoint,
}

/// The multiple cycles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Multiple {
    /// G70.
    Finishing,
    /// G71.
    RoughTurning,
    /// G72.
    RoughFacing,
    /// G73.
    Pattern,
    /// G74.
    FacePecking,
    /// G75.
    Grooving,
    /// G76.
    Threading,
}

impl Multiple {
    /// The cycle as motions name it.
    pub fn cycle(self) -> Cycle {
        match self {
            Self::Finishing => Cycle::Finishing,
            Self::RoughTurning => Cycle::RoughTurning,
            Self::RoughFacing => Cycle::RoughFacing,
            Self::Pattern => Cycle::Pattern,
            Self::FacePecking => Cycle::FacePecking,
            Self::Grooving => Cycle::Grooving,
            Self::Threading => Cycle::MultiThreading,
        }
    }
}

/// Group 01: what axis words do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MotionMode {
    /// G00.
    Rapid,
    /// G01.
    Line,
    /// G02, G03.
    Arc(Turn),
    /// G32.
    Thread,
    /// G34.
    VariableThread,
    /// G33 on GSK.
    Tapping,
    /// G90, G92, G94.
    Cycle(Single),
}

impl MotionMode {
    /// Number of the code in system A.
    pub fn number(self) -> u32 {
        match self {
            Self::Rapid => 0,
            Self::Line => 1,
            Self::Arc(Turn::Clockwise) => 2,
            Self::Arc(Turn::Counterclockwise) => 3,
            Self::Thread => 32,
            Self::Tapping => 33,
            Self::VariableThread => 34,
            Self::Cycle(Single::Turning) => 90,
            Self::Cycle(Single::Threading) => 92,
            Self::Cycle(Single::Facing) => 94,
        }
    }
}

/// Working plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Plane {
    /// G17.
    Xy,
    /// G18, the plane of turning.
    Zx,
    /// G19.
    Yz,
}

/// Tool nose radius compensation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Compensation {
    /// G40.
    Off,
    /// G41: the tool is left of the path.
    Left,
    /// G42: the tool is right of the path.
    Right,
}

/// Modal group of a code: two codes of one group exclude each other. 0: not modal.
pub type Group = u8;

/// The G code of a word in a G-code system: `key` is ten times the number, so that G12.1 is 121 (semantics §9).
pub fn g_code(key: u64, system: GSystem) -> Option<(G, Group)> {
    if system == GSystem::A {
        return g_code_a(key);
    }
    let in_a = match (key, system) {
        (770, GSystem::B) | (200, GSystem::C) => 900,
        (780, GSystem::B) | (210, GSystem::C) => 920,
        (790, GSystem::B) | (240, GSystem::C) => 940,
        (700, GSystem::C) => 200,
        (710, GSystem::C) => 210,
        (720..=780, GSystem::C) if key.is_multiple_of(10) => key - 20,
        (330, _) => 320,
        (940, _) => 980,
        (950, _) => 990,
        (920, _) => 500,
        (900, _) => return Some((G::Distance { incremental: false }, 3)),
        (910, _) => return Some((G::Distance { incremental: true }, 3)),
        (980, _) => return Some((G::HoleReturn(HoleReturn::Initial), 11)),
        (990, _) => return Some((G::HoleReturn(HoleReturn::RPoint), 11)),
        (320 | 500 | 770 | 780 | 790, _) => return None,
        _ => key,
    };
    g_code_a(in_a)
}

fn g_code_a(key: u64) -> Option<(G, Group)> {
    Some(match key {
        0 => (G::Motion(MotionMode::Rapid), 1),
        10 => (G::Motion(MotionMode::Line), 1),
        20 => (G::Motion(MotionMode::Arc(Turn::Clockwise)), 1),
        30 => (G::Motion(MotionMode::Arc(Turn::Counterclockwise)), 1),
        40 => (G::Dwell, 0),
        170 => (G::Plane(Plane::Xy), 16),
        180 => (G::Plane(Plane::Zx), 16),
        190 => (G::Plane(Plane::Yz), 16),
        200 => (G::Unit(Unit::Inch), 6),
        210 => (G::Unit(Unit::Millimetre), 6),
        220 | 230 => (G::Idle, 9),
        100 => (G::Data, 0),
        110 => (G::EndOfData, 0),
        270 => (G::CheckHome, 0),
        280 => (G::Home, 0),
        290 => (G::FromHome, 0),
        300 => (G::OtherHome, 0),
        320 => (G::Motion(MotionMode::Thread), 1),
        330 => (G::Motion(MotionMode::Tapping), 1),
        340 => (G::Motion(MotionMode::VariableThread), 1),
        400 => (G::Compensation(Compensation::Off), 7),
        410 => (G::Compensation(Compensation::Left), 7),
        420 => (G::Compensation(Compensation::Right), 7),
        500 => (G::Setting, 0),
        520 => (G::LocalFrame, 0),
        530 => (G::Machine, 0),
        541 => (G::ExtendedFrame, 14),
        540 => (G::Frame(0), 14),
        550 => (G::Frame(1), 14),
        560 => (G::Frame(2), 14),
        570 => (G::Frame(3), 14),
        580 => (G::Frame(4), 14),
        590 => (G::Frame(5), 14),
        700 => (G::Multiple(Multiple::Finishing), 0),
        710 => (G::Multiple(Multiple::RoughTurning), 0),
        720 => (G::Multiple(Multiple::RoughFacing), 0),
        730 => (G::Multiple(Multiple::Pattern), 0),
        740 => (G::Multiple(Multiple::FacePecking), 0),
        750 => (G::Multiple(Multiple::Grooving), 0),
        760 => (G::Multiple(Multiple::Threading), 0),
        900 => (G::Motion(MotionMode::Cycle(Single::Turning)), 1),
        920 => (G::Motion(MotionMode::Cycle(Single::Threading)), 1),
        940 => (G::Motion(MotionMode::Cycle(Single::Facing)), 1),
        960 => (G::SurfaceSpeed, 2),
        970 => (G::ConstantSpeed, 2),
        980 => (G::Feed(FeedMode::PerMinute), 5),
        990 => (G::Feed(FeedMode::PerTurn), 5),
        121 | 1120 => (G::Polar(Switch::On), 21),
        131 | 1130 => (G::Polar(Switch::Off), 21),
        71 | 1070 => (G::Cylinder, 0),
        800 => (G::NoHole, 10),
        810 => (G::Hole(Hole::G81), 10),
        820 => (G::Hole(Hole::G82), 10),
        830 => (G::Hole(Hole::G83), 10),
        840 => (G::Hole(Hole::G84), 10),
        850 => (G::Hole(Hole::G85), 10),
        860 => (G::Hole(Hole::G86), 10),
        870 => (G::Hole(Hole::G87), 10),
        880 => (G::Hole(Hole::G88), 10),
        890 => (G::Hole(Hole::G89), 10),
        650 => (G::MacroCall("G65"), 0),
        660 => (G::MacroCall("G66"), 12),
        670 => (G::NoModalMacro, 12),
        // Stops, exact stop and cutting mode; off states of functions this project does not have switched on:
        // headers are full of them.
        80 | 90 | 250 | 260 | 490 | 502 | 610 | 630 | 640 | 690 => (G::Idle, 0),
        // High-speed cutting, skip, automatic offsets, polygon turning, mirror image.
        50 | 51 | 310 | 360 | 370 | 512 | 680 => (G::NotSupported, 0),
        _ => return None,
    })
}

/// What an M code asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum M {
    /// M00, M01: wait for the operator.
    Pause,
    /// M02, M30.
    End,
    /// M03, M04, M05.
    Spindle(SpindleTurn),
    /// M13, M14: a live tool turns.
    LiveTool,
    /// M45, M46: the C axis is connected or released.
    CAxis(Switch),
    /// M23, M24 (the machine of seed 002): thread pull-out on or off.
    ThreadPullOut(Switch),
    /// Accepted; the tool path does not depend on it.
    Idle,
    /// M98, and M198 of programs on a card.
    Call,
    /// M97: a part of the same program, from a sequence number on (Haas).
    LocalCall,
    /// M99.
    Return,
}

/// On or off.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Switch {
    /// On.
    On,
    /// Off.
    Off,
}

/// The M code of a number (seed 002's table, semantics §8.1); `None` for one that only some machines know.
pub fn m_code(number: u64) -> Option<M> {
    Some(match number {
        0 | 1 => M::Pause,
        2 | 30 => M::End,
        3 => M::Spindle(SpindleTurn::Forward),
        4 => M::Spindle(SpindleTurn::Reverse),
        5 => M::Spindle(SpindleTurn::Stopped),
        13 | 14 => M::LiveTool,
        23 => M::ThreadPullOut(Switch::On),
        24 => M::ThreadPullOut(Switch::Off),
        45 => M::CAxis(Switch::On),
        46 => M::CAxis(Switch::Off),
        97 => M::LocalCall,
        98 | 198 => M::Call,
        99 => M::Return,
        7..=12 | 19 | 20 | 25 | 26 | 29 | 40..=44 | 68 | 69 | 90 | 91 | 200 | 201 | 712 | 713 => M::Idle,
        _ => return None,
    })
}
