//! G and M codes.
//!
//! In: the number of a G or M word. Out: the meaning of the code and its modal group. `registry` lists the
//! codes, and their spelling in each list of G codes; this file has the types of their meanings.

pub mod cycles;
mod function;
mod registry;
pub mod role;
pub mod words;

pub use function::{Function, Section};
pub use registry::{
    Effect, GCode, Row, g_code, g_code_of, g_codes, is_of_machine, m_code, m_codes, m_function, rows,
    written, written_m,
};

use super::words::plain;
use crate::cycles::single::Single;
use crate::geometry::Turn;
use crate::motion::{Cycle, Quill, SpindleTurn, StopKind};
use crate::setup::dialect::{CodeList, FeedMode};
use crate::text::block::{Block, Word};
use crate::units::Unit;
use cycles::CycleSpec;

/// Whether a code, given as ten times its number, is of modal group 01 on a control with list A or of GSK. A
/// block has at most one of these.
pub fn is_of_motion_group(key: u64) -> bool {
    [CodeList::A, CodeList::Gsk].iter().any(|&list| g_code(key, list).is_some_and(|code| code.group == 1))
}

/// The single and multiple turning cycles with their names in list A: `G90`, `G71`.
pub fn turning_cycles() -> impl Iterator<Item = String> {
    let is_cycle =
        |row: &Row| matches!(row.function.section(), Section::SingleCycles | Section::MultipleCycles);
    rows().filter(is_cycle).map(|row| row.codes[CodeList::A as usize].clone())
}

/// Whether a word calls another part of the program or returns from it: M97, M98, M99.
pub fn is_call_or_return(word: &Word) -> bool {
    let code = whole(word).filter(|_| word.address == b'M').and_then(m_code);
    matches!(code, Some(M::Call | M::LocalCall | M::Return))
}

/// Whether a word calls a macro: G65, G66. The words after it are arguments.
pub fn calls_macro(word: &Word) -> bool {
    matches!(whole_g(word), Some(G::MacroCall(_)))
}

/// The operation of a block of macro A: `G65 H01`, with H right after the code. (A block that calls a program
/// has P there.)
pub fn macro_a(block: &Block) -> Option<u32> {
    let code = |word: &Word| word.address == b'G' && whole(word) == Some(65);
    let after = block.words.iter().position(code)? + 1;
    let operation = block.words.get(after).filter(|word| word.address == b'H' && !word.comma)?;
    u32::try_from(whole(operation)?).ok()
}

/// Whether an operation of macro A jumps to the block in P: H80 to H86.
pub fn is_jump_of_macro_a(operation: u32) -> bool {
    (80..=86).contains(&operation)
}

/// Whether a word only controls the flow of the program: M97 to M99, G65 to G67.
pub fn is_flow_control(word: &Word) -> bool {
    is_call_or_return(word) || matches!(whole_g(word), Some(G::MacroCall(_) | G::NoModalMacro))
}

/// The G code of a word without decimals, if all lists have it.
fn whole_g(word: &Word) -> Option<G> {
    let number = whole(word).filter(|_| word.address == b'G')?;
    g_code(10 * number, CodeList::A).map(|found| found.code)
}

fn whole(word: &Word) -> Option<u64> {
    plain(word).filter(|number| *number >= 0.0 && number.fract() == 0.0).map(|number| number as u64)
}

/// Meaning of a G code.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum G {
    /// G00 to G03, G32 to G34, G90, G92, G94, and the unsupported codes of group 01.
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
    MacroCall(MacroCall),
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
    /// Accepted; the tool path does not depend on it.
    Idle,
    /// Recognised, but not supported: the axis words of the block are not carried out.
    NotSupported,
}

/// How a macro is called.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MacroCall {
    /// G65: once.
    Once,
    /// G66: after every move.
    Modal,
}

impl MacroCall {
    /// The code.
    pub fn code(self) -> &'static str {
        match self {
            Self::Once => "G65",
            Self::Modal => "G66",
        }
    }
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

    /// Whether Q is its peck depth.
    pub fn pecks(self) -> bool {
        matches!(self, Self::G83 | Self::G87)
    }

    /// Whether it taps.
    pub fn is_tap(self) -> bool {
        matches!(self, Self::G84 | Self::G88)
    }

    /// The name of the cycle in motions.
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

/// Where the tool goes after a hole (G98 and G99 of systems B and C; system A has only the first).
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
    /// Its code, blocks and words.
    pub const fn spec(self) -> &'static CycleSpec {
        match self {
            Self::Finishing => &cycles::FINISHING,
            Self::RoughTurning => &cycles::ROUGH_TURNING,
            Self::RoughFacing => &cycles::ROUGH_FACING,
            Self::Pattern => &cycles::PATTERN,
            Self::FacePecking => &cycles::FACE_PECKING,
            Self::Grooving => &cycles::GROOVING,
            Self::Threading => &cycles::THREADING,
        }
    }

    /// Whether it roughs a contour, given by P and Q.
    pub fn is_roughing(self) -> bool {
        self.spec().reads_contour && self != Self::Finishing
    }

    /// The name of the cycle in motions.
    pub fn cycle(self) -> Cycle {
        self.spec().cycle
    }
}

/// Group 01: how axis words are carried out.
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
    /// Ten times the number of the code in system A.
    pub fn key(self) -> u32 {
        match self {
            Self::Rapid => 0,
            Self::Line => 10,
            Self::Arc(Turn::Clockwise) => 20,
            Self::Arc(Turn::Counterclockwise) => 30,
            Self::Thread => 320,
            Self::Tapping => 330,
            Self::VariableThread => 340,
            Self::Cycle(cycle) => u32::from(cycle.spec().keys[0]),
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
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Compensation {
    /// G40.
    #[default]
    Off,
    /// G41: the tool is left of the path.
    Left,
    /// G42: the tool is right of the path.
    Right,
}

/// Modal group of a code: two codes of one group cannot be in force together. 0: not modal.
pub type Group = u8;

/// Meaning of an M code.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum M {
    /// M00, M01: wait for the operator.
    Pause(StopKind),
    /// M02, M30.
    End,
    /// M03, M04, M05.
    Spindle(SpindleTurn),
    /// M19: the spindle stops at an angle and is held there. M20 of seed 002 means something else on many
    /// machines.
    Orientation,
    /// M13, M14: a live tool turns.
    LiveTool,
    /// M45, M46: the C axis is connected or released.
    CAxis(Switch),
    /// M25, M26 (the machine of seed 002): the quill of the tailstock comes forward or goes back.
    Quill(Quill),
    /// M23, M24 (the machine of seed 002): thread pull-out on or off.
    ThreadPullOut(Switch),
    /// Accepted; the tool path does not depend on it.
    Idle,
    /// M98, and M198 of programs on a card.
    Call,
    /// M97: calls a part of the same program, from a sequence number (Haas).
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
