//! The registry: every recognised code, listed once.
//!
//! In: a number, and the control's list. Out: the meaning of the code, and its [`Function`] for the table of
//! supported codes. Lookup uses indices that are computed from the rows at compile time, so a code without a
//! row is not recognised.

use super::cycles::{CycleSpec, SingleSpec};
use super::function::Function;
use super::role::Role;
use super::{Compensation, G, Group, Hole, HoleReturn, M, MacroCall, MotionMode, Multiple, Plane, Switch};
use crate::cycles::single::Single;
use crate::geometry::Turn;
use crate::motion::{Quill, SpindleTurn, StopKind};
use crate::setup::dialect::{CodeList, FeedMode};
use crate::units::Unit;

/// How this project treats a code.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effect {
    /// It is carried out.
    Done,
    /// It is accepted, and does not affect the path.
    Accepted,
    /// It is recognised and reported as not supported.
    NotSupported,
}

/// Key for a list that does not have the code.
const NOT_THERE: u16 = u16::MAX;

/// A G code.
pub struct GCode {
    function: Function,
    /// Its meaning, if its function has several codes.
    role: Option<Role>,
    /// Its meaning.
    pub code: G,
    /// Modal group: two codes of one group cannot be in force together.
    pub group: Group,
    /// Ten times its number, for each list.
    keys: [u16; CodeList::ALL.len()],
}

impl GCode {
    /// As a program writes it with a list; `None` if the list lacks it.
    pub fn text(&self, list: CodeList) -> Option<String> {
        let key = self.keys[list as usize];
        let mut text = String::new();
        spell(&mut text, 'G', key / 10, key % 10);
        (key != NOT_THERE).then_some(text)
    }
}

struct MCode {
    function: Function,
    role: Option<Role>,
    code: M,
    number: u16,
}

/// A G code with the same number in all lists.
const fn same(key: u16, function: Function, code: G, group: Group) -> GCode {
    spelled([key; 4], function, code, group)
}

/// A G code by its keys in systems A, B, C and on GSK.
const fn spelled(keys: [u16; 4], function: Function, code: G, group: Group) -> GCode {
    GCode { function, role: None, code, group, keys }
}

const fn mode(key: u16, function: Function, mode: MotionMode) -> GCode {
    same(key, function, G::Motion(mode), 1)
}

const fn cycle(cycle: Single) -> GCode {
    let SingleSpec { keys, function, .. } = *cycle.spec();
    spelled(keys, function, G::Motion(MotionMode::Cycle(cycle)), 1)
}

/// G70 to G76, two numbers higher in system C.
const fn multiple(cycle: Multiple) -> GCode {
    let CycleSpec { key, function, .. } = *cycle.spec();
    spelled([key, key, key + 20, key], function, G::Multiple(cycle), 0)
}

const fn hole(function: Function, hole: Hole) -> GCode {
    same(810 + 10 * hole as u16, function, G::Hole(hole), 10)
}

const fn idle(key: u16, function: Function) -> GCode {
    same(key, function, G::Idle, 0)
}

const fn not_supported(key: u16, function: Function) -> GCode {
    same(key, function, G::NotSupported, 0)
}

/// A G code of systems B and C only.
const fn not_in_a(key: u16, function: Function, code: G, group: Group) -> GCode {
    spelled([NOT_THERE, key, key, NOT_THERE], function, code, group)
}

/// A G code with one number in A and GSK, and another in B and C.
const fn differs_in_b_and_c(a: u16, b: u16, function: Function, code: G, group: Group) -> GCode {
    spelled([a, b, b, a], function, code, group)
}

const G_CODES: &[GCode] = &[
    mode(0, Function::Rapid, MotionMode::Rapid),
    mode(10, Function::Line, MotionMode::Line),
    mode(20, Function::ArcClockwise, MotionMode::Arc(Turn::Clockwise)),
    mode(30, Function::ArcCounterclockwise, MotionMode::Arc(Turn::Counterclockwise)),
    same(40, Function::Dwell, G::Dwell, 0),
    differs_in_b_and_c(320, 330, Function::Thread, G::Motion(MotionMode::Thread), 1),
    spelled([NOT_THERE, NOT_THERE, NOT_THERE, 330], Function::Tapping, G::Motion(MotionMode::Tapping), 1),
    mode(340, Function::VariableThread, MotionMode::VariableThread),
    cycle(Single::Turning),
    cycle(Single::Threading),
    cycle(Single::Facing),
    multiple(Multiple::Finishing),
    multiple(Multiple::RoughTurning),
    multiple(Multiple::RoughFacing),
    multiple(Multiple::Pattern),
    multiple(Multiple::FacePecking),
    multiple(Multiple::Grooving),
    multiple(Multiple::Threading),
    same(800, Function::NoHole, G::NoHole, 10),
    hole(Function::Drilling, Hole::G81),
    hole(Function::CounterBoring, Hole::G82),
    hole(Function::FaceDrilling, Hole::G83),
    hole(Function::FaceTapping, Hole::G84),
    hole(Function::FaceBoring, Hole::G85),
    hole(Function::BoringStop, Hole::G86),
    hole(Function::SideDrilling, Hole::G87),
    hole(Function::SideTapping, Hole::G88),
    hole(Function::SideBoring, Hole::G89),
    // Return level after a hole; the initial level is used.
    not_in_a(980, Function::HoleReturn, G::HoleReturn(HoleReturn::Initial), 11).means(Role::InitialLevel),
    not_in_a(990, Function::HoleReturn, G::HoleReturn(HoleReturn::RPoint), 11).means(Role::RPointLevel),
    same(400, Function::CompensationOff, G::Compensation(Compensation::Off), 7),
    same(410, Function::CompensationLeft, G::Compensation(Compensation::Left), 7),
    same(420, Function::CompensationRight, G::Compensation(Compensation::Right), 7),
    same(121, Function::PolarOn, G::Polar(Switch::On), 21),
    same(1120, Function::PolarOn, G::Polar(Switch::On), 21),
    same(131, Function::PolarOff, G::Polar(Switch::Off), 21),
    same(1130, Function::PolarOff, G::Polar(Switch::Off), 21),
    same(71, Function::Cylinder, G::Cylinder, 0),
    same(1070, Function::Cylinder, G::Cylinder, 0),
    differs_in_b_and_c(500, 920, Function::Setting, G::Setting, 0),
    same(520, Function::LocalFrame, G::LocalFrame, 0),
    same(530, Function::Machine, G::Machine, 0),
    same(540, Function::Frame, G::Frame(0), 14).means(Role::WorkFrame),
    same(550, Function::Frame, G::Frame(1), 14).means(Role::WorkFrame),
    same(560, Function::Frame, G::Frame(2), 14).means(Role::WorkFrame),
    same(570, Function::Frame, G::Frame(3), 14).means(Role::WorkFrame),
    same(580, Function::Frame, G::Frame(4), 14).means(Role::WorkFrame),
    same(590, Function::Frame, G::Frame(5), 14).means(Role::WorkFrame),
    same(541, Function::ExtendedFrame, G::ExtendedFrame, 14),
    not_in_a(900, Function::Distance, G::Distance { incremental: false }, 3).means(Role::Absolute),
    not_in_a(910, Function::Distance, G::Distance { incremental: true }, 3).means(Role::Incremental),
    same(270, Function::CheckHome, G::CheckHome, 0),
    same(280, Function::Home, G::Home, 0),
    same(290, Function::FromHome, G::FromHome, 0),
    same(300, Function::OtherHome, G::OtherHome, 0),
    same(100, Function::Data, G::Data, 0).means(Role::DataInput),
    same(110, Function::Data, G::EndOfData, 0).means(Role::DataEnd),
    same(170, Function::Plane, G::Plane(Plane::Xy), 16).means(Role::PlaneXy),
    same(180, Function::Plane, G::Plane(Plane::Zx), 16).means(Role::PlaneZx),
    same(190, Function::Plane, G::Plane(Plane::Yz), 16).means(Role::PlaneYz),
    spelled([200, 200, 700, 200], Function::Unit, G::Unit(Unit::Inch), 6).means(Role::InchInput),
    spelled([210, 210, 710, 210], Function::Unit, G::Unit(Unit::Millimetre), 6).means(Role::MetricInput),
    differs_in_b_and_c(980, 940, Function::Feed, G::Feed(FeedMode::PerMinute), 5).means(Role::FeedPerMinute),
    differs_in_b_and_c(990, 950, Function::Feed, G::Feed(FeedMode::PerTurn), 5).means(Role::FeedPerTurn),
    same(960, Function::SurfaceSpeed, G::SurfaceSpeed, 2),
    same(970, Function::ConstantSpeed, G::ConstantSpeed, 2),
    same(650, Function::MacroCall, G::MacroCall(MacroCall::Once), 0).means(Role::MacroOnce),
    same(660, Function::ModalMacro, G::MacroCall(MacroCall::Modal), 12).means(Role::MacroModal),
    same(670, Function::ModalMacro, G::NoModalMacro, 12).means(Role::MacroOff),
    same(220, Function::StrokeCheck, G::Idle, 9),
    same(230, Function::StrokeCheck, G::Idle, 9),
    idle(90, Function::ExactStop),
    idle(610, Function::ExactStop),
    idle(630, Function::ExactStop),
    idle(640, Function::ExactStop),
    idle(250, Function::SpindleCheck),
    idle(260, Function::SpindleCheck),
    // Off states of functions that this project does not support: program headers often contain them.
    idle(80, Function::Off),
    idle(490, Function::Off),
    idle(502, Function::Off),
    idle(690, Function::Off),
    idle(150, Function::Off),
    idle(401, Function::Off),
    idle(491, Function::Off),
    idle(501, Function::Off),
    idle(691, Function::Off),
    not_supported(50, Function::HighSpeed),
    not_supported(51, Function::HighSpeed),
    not_supported(310, Function::Skip),
    not_supported(360, Function::AutomaticOffset),
    not_supported(370, Function::AutomaticOffset),
    not_supported(512, Function::Polygon),
    not_supported(680, Function::Mirror),
    // FANUC's lists of the series 30i, 31i, 32i and 0i-F for lathes (B-64304EN-1, B-64694EN-1), and GSK 980TDi.
    not_supported(311, Function::Skip),
    not_supported(312, Function::Skip),
    not_supported(313, Function::Skip),
    not_supported(314, Function::Skip),
    not_supported(318, Function::Skip),
    not_supported(371, Function::AutomaticOffset),
    not_supported(372, Function::AutomaticOffset),
    not_supported(373, Function::AutomaticOffset),
    not_supported(21, Function::OtherInterpolation),
    not_supported(31, Function::OtherInterpolation),
    not_supported(22, Function::OtherInterpolation),
    not_supported(32, Function::OtherInterpolation),
    not_supported(23, Function::OtherInterpolation),
    not_supported(33, Function::OtherInterpolation),
    not_supported(62, Function::OtherInterpolation),
    not_supported(63, Function::OtherInterpolation),
    not_supported(70, Function::OtherInterpolation),
    not_supported(72, Function::OtherInterpolation),
    not_supported(73, Function::OtherInterpolation),
    not_supported(350, Function::OtherInterpolation),
    not_supported(54, Function::OtherFeedControl),
    not_supported(600, Function::OtherFeedControl),
    not_supported(611, Function::OtherFeedControl),
    not_supported(620, Function::OtherFeedControl),
    not_supported(930, Function::OtherFeedControl),
    not_supported(380, Function::OtherCompensation),
    not_supported(390, Function::OtherCompensation),
    not_supported(411, Function::OtherCompensation),
    not_supported(421, Function::OtherCompensation),
    not_supported(412, Function::OtherCompensation),
    not_supported(422, Function::OtherCompensation),
    not_supported(414, Function::OtherCompensation),
    not_supported(424, Function::OtherCompensation),
    not_supported(415, Function::OtherCompensation),
    not_supported(425, Function::OtherCompensation),
    not_supported(416, Function::OtherCompensation),
    not_supported(426, Function::OtherCompensation),
    not_supported(431, Function::OtherCompensation),
    not_supported(433, Function::OtherCompensation),
    not_supported(434, Function::OtherCompensation),
    not_supported(435, Function::OtherCompensation),
    not_supported(437, Function::OtherCompensation),
    not_supported(438, Function::OtherCompensation),
    not_supported(439, Function::OtherCompensation),
    not_supported(441, Function::OtherCompensation),
    not_supported(447, Function::OtherCompensation),
    not_supported(103, Function::OtherCoordinates),
    not_supported(106, Function::OtherCoordinates),
    not_supported(109, Function::OtherCoordinates),
    not_supported(160, Function::OtherCoordinates),
    not_supported(171, Function::OtherCoordinates),
    not_supported(301, Function::OtherCoordinates),
    not_supported(503, Function::OtherCoordinates),
    not_supported(511, Function::OtherCoordinates),
    not_supported(531, Function::OtherCoordinates),
    not_supported(532, Function::OtherCoordinates),
    not_supported(536, Function::OtherCoordinates),
    not_supported(542, Function::OtherCoordinates),
    not_supported(544, Function::OtherCoordinates),
    not_supported(681, Function::OtherCoordinates),
    not_supported(682, Function::OtherCoordinates),
    not_supported(683, Function::OtherCoordinates),
    not_supported(684, Function::OtherCoordinates),
    not_supported(504, Function::OtherSynchronization),
    not_supported(505, Function::OtherSynchronization),
    not_supported(506, Function::OtherSynchronization),
    not_supported(514, Function::OtherSynchronization),
    not_supported(515, Function::OtherSynchronization),
    not_supported(516, Function::OtherSynchronization),
    not_supported(804, Function::OtherSynchronization),
    not_supported(805, Function::OtherSynchronization),
    not_supported(811, Function::OtherSynchronization),
    not_supported(814, Function::OtherSynchronization),
    not_supported(815, Function::OtherSynchronization),
    not_supported(961, Function::OtherSynchronization),
    not_supported(962, Function::OtherSynchronization),
    not_supported(963, Function::OtherSynchronization),
    not_supported(964, Function::OtherSynchronization),
    not_supported(707, Function::OtherCycles),
    not_supported(717, Function::OtherCycles),
    not_supported(727, Function::OtherCycles),
    not_supported(737, Function::OtherCycles),
    not_supported(747, Function::OtherCycles),
    not_supported(757, Function::OtherCycles),
    not_supported(767, Function::OtherCycles),
    not_supported(835, Function::OtherCycles),
    not_supported(836, Function::OtherCycles),
    not_supported(842, Function::OtherCycles),
    not_supported(853, Function::OtherCycles),
    not_supported(875, Function::OtherCycles),
    not_supported(876, Function::OtherCycles),
    not_supported(882, Function::OtherCycles),
    not_supported(661, Function::OtherMacroCall),
];

const fn m(number: u16, function: Function, code: M) -> MCode {
    MCode { function, role: None, code, number }
}

/// The table of seed 002, and other common codes.
static M_CODES: &[MCode] = &[
    m(3, Function::Spindle, M::Spindle(SpindleTurn::Forward)).means(Role::SpindleForward),
    m(4, Function::Spindle, M::Spindle(SpindleTurn::Reverse)).means(Role::SpindleReverse),
    m(5, Function::Spindle, M::Spindle(SpindleTurn::Stopped)).means(Role::SpindleStop),
    m(0, Function::Pause, M::Pause(StopKind::Always)).means(Role::ProgramStop),
    m(1, Function::Pause, M::Pause(StopKind::Optional)).means(Role::OptionalStop),
    m(2, Function::End, M::End),
    m(30, Function::End, M::End),
    m(98, Function::Call, M::Call),
    m(97, Function::LocalCall, M::LocalCall),
    m(198, Function::CardCall, M::Call),
    m(99, Function::Return, M::Return),
    m(6, Function::ToolChange, M::Idle).means(Role::ToolChange),
    m(7, Function::Coolant, M::Idle).means(Role::CoolantOn),
    m(8, Function::Coolant, M::Idle).means(Role::CoolantOn),
    m(9, Function::Coolant, M::Idle).means(Role::CoolantOff),
    m(10, Function::Chuck, M::Idle).means(Role::ChuckClamp),
    m(11, Function::Chuck, M::Idle).means(Role::ChuckUnclamp),
    m(68, Function::Chuck, M::Idle).means(Role::ChuckClamp),
    m(69, Function::Chuck, M::Idle).means(Role::ChuckUnclamp),
    m(13, Function::LiveTool, M::LiveTool).means(Role::LiveToolForward),
    m(14, Function::LiveTool, M::LiveTool).means(Role::LiveToolReverse),
    m(19, Function::Orientation, M::Orientation).means(Role::FirstOrientation),
    m(20, Function::Orientation, M::Idle).means(Role::SecondOrientation),
    m(23, Function::ThreadPullOut, M::ThreadPullOut(Switch::On)).means(Role::PullOutOn),
    m(24, Function::ThreadPullOut, M::ThreadPullOut(Switch::Off)).means(Role::PullOutOff),
    m(25, Function::Tailstock, M::Quill(Quill::Forward)).means(Role::TailstockForward),
    m(26, Function::Tailstock, M::Quill(Quill::Back)).means(Role::TailstockBack),
    m(29, Function::RigidTapping, M::Idle),
    m(40, Function::Gear, M::Idle),
    m(41, Function::Gear, M::Idle),
    m(42, Function::Gear, M::Idle),
    m(43, Function::Gear, M::Idle),
    m(44, Function::Gear, M::Idle),
    m(45, Function::CAxis, M::CAxis(Switch::On)).means(Role::CAxisOn),
    m(46, Function::CAxis, M::CAxis(Switch::Off)).means(Role::CAxisOff),
    m(90, Function::Synchronous, M::Idle).means(Role::SynchronousOn),
    m(91, Function::Synchronous, M::Idle).means(Role::SynchronousOff),
    m(200, Function::Conveyor, M::Idle).means(Role::ConveyorForward),
    m(201, Function::Conveyor, M::Idle).means(Role::ConveyorStop),
    m(712, Function::Interlock, M::Idle).means(Role::InterlockOff),
    m(713, Function::Interlock, M::Idle).means(Role::InterlockOn),
    m(12, Function::OtherMachine, M::Idle),
];

/// A row of the table that is neither a G nor an M code.
struct Other {
    function: Function,
    /// The usual spelling.
    written: &'static str,
    effect: Effect,
    /// The lists that have it.
    lists: &'static [CodeList],
}

const fn other(function: Function, written: &'static str) -> Other {
    Other { function, written, effect: Effect::Done, lists: &CodeList::ALL }
}

static OTHERS: &[Other] = &[
    other(Function::Chamfer, ",C C I K"),
    other(Function::Rounding, ",R R"),
    Other { lists: &[CodeList::Gsk], ..other(Function::GskCorner, "L D") },
    other(Function::Angle, ",A A"),
    other(Function::Tool, "T"),
    other(Function::Variables, "#"),
    other(Function::If, "IF THEN"),
    other(Function::Goto, "GOTO"),
    other(Function::While, "WHILE DO END"),
    Other { effect: Effect::Accepted, ..other(Function::Output, "POPEN BPRNT DPRNT PCLOS SETVN") },
    other(Function::BlockSkip, "/ /2…/9"),
];

/// Index for a missing row.
const NO_ROW: u8 = u8::MAX;

/// Rows of [`G_CODES`] by list and key.
const G_ROWS: [[u8; 1131]; CodeList::ALL.len()] = {
    let mut rows = [[NO_ROW; 1131]; CodeList::ALL.len()];
    let mut row = 0;
    while row < G_CODES.len() {
        let mut list = 0;
        while list < CodeList::ALL.len() {
            let key = G_CODES[row].keys[list];
            if key != NOT_THERE {
                assert!(rows[list][key as usize] == NO_ROW, "a number has one meaning in a list");
                rows[list][key as usize] = row as u8;
            }
            list += 1;
        }
        row += 1;
    }
    assert!(row < NO_ROW as usize);
    rows
};

/// The same for whole numbers, which are nearly all codes: a tenth of the table size.
static WHOLE_G_ROWS: [[u8; 114]; CodeList::ALL.len()] = {
    let mut rows = [[NO_ROW; 114]; CodeList::ALL.len()];
    let mut list = 0;
    while list < CodeList::ALL.len() {
        let mut number = 0;
        while number < 114 {
            rows[list][number] = G_ROWS[list][10 * number];
            number += 1;
        }
        list += 1;
    }
    rows
};

/// Rows of [`M_CODES`] by number.
const M_ROWS: [u8; 714] = {
    let mut rows = [NO_ROW; 714];
    let mut row = 0;
    while row < M_CODES.len() {
        let number = M_CODES[row].number as usize;
        assert!(rows[number] == NO_ROW, "a number has one meaning");
        rows[number] = row as u8;
        row += 1;
    }
    rows
};

/// The same for the usual numbers.
static USUAL_M_ROWS: [u8; 100] = {
    let mut rows = [NO_ROW; 100];
    let mut number = 0;
    while number < 100 {
        rows[number] = M_ROWS[number];
        number += 1;
    }
    rows
};

/// The row of a key with the same meaning in all lists.
const fn same_in_all_lists(key: usize) -> &'static GCode {
    let row = G_ROWS[0][key];
    assert!(row == G_ROWS[1][key] && row == G_ROWS[2][key] && row == G_ROWS[3][key]);
    &G_CODES[row as usize]
}

/// The G code of a number in a list: `key` is ten times the number, 121 for G12.1.
#[inline]
pub fn g_code(key: u64, list: CodeList) -> Option<&'static GCode> {
    // Nearly every block has one of these: as constants they need no lookup.
    match key {
        0 => return Some(const { same_in_all_lists(0) }),
        10 => return Some(const { same_in_all_lists(10) }),
        20 => return Some(const { same_in_all_lists(20) }),
        30 => return Some(const { same_in_all_lists(30) }),
        _ => {}
    }
    if !key.is_multiple_of(10) {
        return with_decimal(key, list);
    }
    let row = *WHOLE_G_ROWS[list as usize].get(usize::try_from(key / 10).ok()?)?;
    G_CODES.get(usize::from(row))
}

/// Whether a G code that is not in the list calls a macro of the machine builder; `key` is ten times its
/// number. This is assumed from G100 on, Haas's G103 and G110 to G129 among them.
pub fn is_of_machine(key: u64, list: CodeList) -> bool {
    key >= 1_000 && g_code(key, list).is_none()
}

#[cold]
fn with_decimal(key: u64, list: CodeList) -> Option<&'static GCode> {
    G_CODES.iter().find(|code| u64::from(code.keys[list as usize]) == key && key != u64::from(NOT_THERE))
}

impl GCode {
    /// Its row in the table.
    pub fn function(&self) -> Function {
        self.function
    }

    /// Its meaning, if its row in the table has several codes.
    pub fn role(&self) -> Option<Role> {
        self.role
    }

    const fn means(mut self, role: Role) -> Self {
        self.role = Some(role);
        self
    }
}

impl MCode {
    const fn means(mut self, role: Role) -> Self {
        self.role = Some(role);
        self
    }
}

/// A G code as spelled in a list: `G99`; `None` if the list does not have it.
pub fn written(code: G, list: CodeList) -> Option<String> {
    G_CODES.iter().filter(|other| other.code == code).find_map(|found| found.text(list))
}

/// The G codes of a list, with their spelling.
pub fn g_codes(list: CodeList) -> impl Iterator<Item = (String, &'static GCode)> {
    G_CODES.iter().filter_map(move |code| Some((code.text(list)?, code)))
}

/// An M code as programs write it: `M98`.
pub fn written_m(code: M) -> Option<String> {
    let found = M_CODES.iter().find(|other| other.code == code)?;
    let mut text = String::new();
    spell(&mut text, 'M', found.number, 0);
    Some(text)
}

/// The M codes with their numbers, and their meaning if their row in the table has several codes.
pub fn m_codes() -> impl Iterator<Item = (u16, M, Function, Option<Role>)> {
    M_CODES.iter().map(|code| (code.number, code.code, code.function, code.role))
}

/// The G code with a meaning.
pub fn g_code_of(code: G) -> Option<&'static GCode> {
    G_CODES.iter().find(|other| other.code == code)
}

/// The table row of an M code, and its meaning if the row has several codes.
pub fn m_function(number: u64) -> Option<(Function, Option<Role>)> {
    m_row(number).map(|row| (row.function, row.role))
}

/// The M code of a number; `None` for a machine-specific code.
#[inline]
pub fn m_code(number: u64) -> Option<M> {
    m_row(number).map(|row| row.code)
}

#[inline]
fn m_row(number: u64) -> Option<&'static MCode> {
    match USUAL_M_ROWS.get(usize::try_from(number).ok()?) {
        Some(&row) => M_CODES.get(usize::from(row)),
        None => M_CODES.iter().find(|code| u64::from(code.number) == number),
    }
}

/// A row of the table of supported codes.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Function of the codes.
    pub function: Function,
    /// Spelling of the codes in each list of [`CodeList::ALL`], separated by blanks; empty if the list has
    /// none.
    pub codes: [String; CodeList::ALL.len()],
    /// Modal group; `None` if it is not a G code.
    pub group: Option<Group>,
    /// How this project treats them.
    pub effect: Effect,
}

/// The table of supported codes.
pub fn rows() -> impl Iterator<Item = Row> {
    Function::ALL.iter().map(|&function| Row::new(function))
}

impl Row {
    fn new(function: Function) -> Self {
        let mut row = Self { function, codes: Default::default(), group: None, effect: Effect::Accepted };
        for code in G_CODES.iter().filter(|code| code.function == function) {
            for (codes, key) in row.codes.iter_mut().zip(code.keys) {
                if key != NOT_THERE {
                    spell(codes, 'G', key / 10, key % 10);
                }
            }
            row.group = Some(code.group);
            row.take(match code.code {
                G::Idle => Effect::Accepted,
                G::NotSupported => Effect::NotSupported,
                _ => Effect::Done,
            });
        }
        for code in M_CODES.iter().filter(|code| code.function == function) {
            for codes in &mut row.codes {
                spell(codes, 'M', code.number, 0);
            }
            row.take(match code.code {
                M::Idle | M::Pause(_) | M::Orientation => Effect::Accepted,
                _ => Effect::Done,
            });
        }
        for other in OTHERS.iter().filter(|other| other.function == function) {
            for (codes, list) in row.codes.iter_mut().zip(CodeList::ALL) {
                if other.lists.contains(&list) {
                    codes.push_str(other.written);
                }
            }
            row.take(other.effect);
        }
        row
    }

    fn take(&mut self, effect: Effect) {
        if effect != Effect::Accepted {
            self.effect = effect;
        }
    }
}

/// Adds a code in its usual spelling: `G01`, `G12.1`.
fn spell(codes: &mut String, letter: char, number: u16, decimal: u16) {
    let digit = |digit: u16| char::from(b'0' + (digit % 10) as u8);
    if !codes.is_empty() {
        codes.push(' ');
    }
    codes.push(letter);
    if number >= 100 {
        codes.push(digit(number / 100));
    }
    codes.extend([digit(number / 10), digit(number)]);
    if decimal > 0 {
        codes.extend(['.', digit(decimal)]);
    }
}
