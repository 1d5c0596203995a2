//! The words of the codes: their letters, roles and defaults.
//!
//! This is the only list of the words of moves, holes, calls and one-shot codes; `cycles` has the words of the turning
//! cycles. The help, the completion and the snippets read them. A code has one list for each set of axes and
//! plane in which its words differ.

use super::role::Role;
use super::{G, Hole, M, MotionMode, Plane};
use crate::geometry::virtual_plane::Surface;

/// Meaning of an omitted word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WhenOmitted {
    /// The block is wrong, or does not do what was intended.
    Missing,
    /// The axis does not move.
    Stays,
    /// Zero.
    Zero,
    /// The value set by an earlier block.
    AsSet,
    /// Nothing: the word is optional.
    Nothing,
}

/// A kind of number whose size shows what it counts without a decimal point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Amount {
    /// A coordinate along X.
    Diameter,
    /// A coordinate along Z.
    Length,
    /// A depth of cut or an allowance.
    Cut,
    /// The excess of a casting.
    Relief,
    /// The last cut of a thread.
    ThreadAllowance,
    /// A dwell.
    Time,
}

/// The value of a word in a snippet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Sample {
    /// A length, mm.
    Length(f64),
    /// A length that is written without a decimal point, mm.
    Depth(f64),
    /// A feed rate, mm per revolution.
    Feed(f64),
    /// Digits.
    Digits(&'static str),
    /// The first sequence number of the contour.
    First,
    /// The last sequence number of the contour.
    Last,
    /// A diameter that is smaller than the blank by at most this, mm.
    Inward(f64),
    /// A place along Z: this part of the length of the cut.
    Along(f64),
    /// A diameter that is smaller than the blank by this, mm.
    Smaller(f64),
    /// A place along Z behind the face by this, mm.
    Behind(f64),
    /// The lead of a thread.
    Lead,
    /// The root diameter of the thread on the blank.
    ThreadRoot,
    /// The height of the thread.
    ThreadHeight,
    /// The depth of the first pass of the thread.
    ThreadFirst,
    /// Finishing passes, pull-out and tool angle of G76.
    ThreadPacked,
}

/// A word of a code, or several letters of which a block has one.
#[derive(Clone, Copy, Debug)]
pub struct CodeWord {
    /// Its possible letters, such as X or U.
    pub letters: &'static [u8],
    /// Whether it follows a comma: `,C`.
    pub comma: bool,
    /// The role of each letter.
    pub roles: &'static [Role],
    /// Meaning if it is omitted; `None` if the signature of the block does not show it.
    pub otherwise: Option<WhenOmitted>,
    /// What its size shows, if it is an amount other than a coordinate.
    pub amount: Option<Amount>,
    /// Its value in a snippet, if the snippet contains it.
    pub sample: Option<Sample>,
}

impl CodeWord {
    /// The role of a letter.
    pub fn role(&self, letter: u8) -> Option<Role> {
        let at = self.letters.iter().position(|own| *own == letter)?;
        self.roles.get(at).copied()
    }

    const fn or(mut self, otherwise: WhenOmitted) -> Self {
        self.otherwise = Some(otherwise);
        self
    }

    /// The word is required.
    pub const fn must(self) -> Self {
        self.or(WhenOmitted::Missing)
    }

    /// Without the word the axis does not move.
    pub const fn stays(self) -> Self {
        self.or(WhenOmitted::Stays)
    }

    /// Without the word its value is zero.
    pub const fn zero(self) -> Self {
        self.or(WhenOmitted::Zero)
    }

    /// Without the word the value of an earlier block is in force.
    pub const fn as_set(self) -> Self {
        self.or(WhenOmitted::AsSet)
    }

    /// The word is optional.
    pub const fn may(self) -> Self {
        self.or(WhenOmitted::Nothing)
    }

    /// The word follows a comma, and is optional.
    const fn after_comma(self) -> Self {
        Self { comma: true, ..self.may() }
    }

    /// The size of its value shows how it counts without a decimal point.
    pub const fn amount(mut self, amount: Amount) -> Self {
        self.amount = Some(amount);
        self
    }

    /// The snippet of the code contains the word.
    pub const fn sample(mut self, sample: Sample) -> Self {
        self.sample = Some(sample);
        self
    }
}

/// A word that the signature does not show.
pub const fn word(letters: &'static [u8], roles: &'static [Role]) -> CodeWord {
    CodeWord { letters, comma: false, roles, otherwise: None, amount: None, sample: None }
}

/// The role of a letter in a list of words. `comma`: it follows a comma.
pub fn role_in(words: &[CodeWord], letter: u8, comma: bool) -> Role {
    let own = words.iter().filter(|word| word.comma == comma);
    own.filter_map(|word| word.role(letter)).next().unwrap_or(Role::Ignored)
}

/// The axes and the plane in which a move is made.
#[derive(Clone, Copy, Debug)]
pub struct Axes {
    /// The surface of G12.1 or G07.1.
    pub surface: Option<Surface>,
    /// The plane of G17 to G19.
    pub plane: Plane,
    /// Whether the C axis is connected.
    pub c_axis: bool,
}

const X: CodeWord = word(b"XU", &[Role::EndX, Role::WayX]);
const Z: CodeWord = word(b"ZW", &[Role::EndZ, Role::WayZ]);
const C: CodeWord = word(b"CH", &[Role::EndC, Role::WayC]);
const Y: CodeWord = word(b"YV", &[Role::EndY, Role::WayY]);
/// F, the feed rate.
pub const FEED: CodeWord = word(b"F", &[Role::Feed]);
/// Q, the start angle of a thread.
pub const START_ANGLE: CodeWord = word(b"Q", &[Role::StartAngle]);
const LEAD: CodeWord = word(b"F", &[Role::Lead]).as_set();
const LEAD_E: CodeWord = word(b"E", &[Role::Lead]);
const COMMA_C: CodeWord = word(b"C", &[Role::Chamfer]).after_comma();
const COMMA_R: CodeWord = word(b"R", &[Role::Rounding]).after_comma();
const COMMA_A: CodeWord = word(b"A", &[Role::LineAngle]).after_comma();
/// The words after a comma. They have these roles in every block.
pub const AFTER_COMMA: &[CodeWord] = &[COMMA_C, COMMA_R, COMMA_A];
/// Corners and the angle without a comma.
const CORNERS: CodeWord = word(
    b"RLDIKA",
    &[Role::Rounding, Role::Chamfer, Role::Rounding, Role::CornerX, Role::CornerZ, Role::LineAngle],
);

const RAPID: &[CodeWord] = &[X.stays(), Z.stays(), C, Y, FEED];
const RAPID_AND_C: &[CodeWord] = &[X.stays(), Z.stays(), C.stays(), Y, FEED];
const LINE: &[CodeWord] = &[
    X.stays(),
    Z.stays(),
    FEED.as_set(),
    COMMA_C,
    COMMA_R,
    COMMA_A,
    word(b"C", &[Role::Chamfer]),
    word(b"H", &[Role::WayC]),
    Y,
    CORNERS,
];
const LINE_AND_C: &[CodeWord] =
    &[X.stays(), Z.stays(), C.stays(), FEED.as_set(), COMMA_C, COMMA_R, COMMA_A, Y, CORNERS];
const FACE_LINE: &[CodeWord] = &[X.stays(), C.stays(), FEED.as_set(), Z, Y, CORNERS];
const SIDE_LINE: &[CodeWord] = &[Z.stays(), C.stays(), FEED.as_set(), X, Y, CORNERS];
const ARC: &[CodeWord] = &[
    X.stays(),
    Z.stays(),
    word(b"RIK", &[Role::ArcRadius, Role::ArcCenterX, Role::ArcCenterZ]).must(),
    FEED.as_set(),
    C,
    Y,
];
/// On the end face the centre is I and J (seed 002, figure 5-5).
const FACE_ARC: &[CodeWord] = &[
    X.stays(),
    C.stays(),
    word(b"RIJ", &[Role::ArcRadius, Role::ArcCenterX, Role::ArcCenterC]).must(),
    FEED.as_set(),
    Z,
    Y,
];
const SIDE_ARC: &[CodeWord] = &[
    Z.stays(),
    C.stays(),
    word(b"R", &[Role::ArcRadius]).must(),
    FEED.as_set(),
    word(b"IK", &[Role::ArcCenterX, Role::ArcCenterZ]),
    X,
    Y,
];
const XY_ARC: &[CodeWord] = &[
    X.stays(),
    Y.stays(),
    word(b"RIJ", &[Role::ArcRadius, Role::ArcCenterX, Role::ArcCenterY]).must(),
    FEED.as_set(),
    Z,
    C,
];
const YZ_ARC: &[CodeWord] = &[
    Y.stays(),
    Z.stays(),
    word(b"RJK", &[Role::ArcRadius, Role::ArcCenterY, Role::ArcCenterZ]).must(),
    FEED.as_set(),
    X,
    C,
];
const THREAD: &[CodeWord] = &[
    X.stays(),
    Z.stays(),
    LEAD,
    START_ANGLE.zero(),
    LEAD_E,
    word(b"I", &[Role::ThreadsPerInch]),
    word(b"JK", &[Role::PullOutAcross, Role::PullOutAlong]),
    C,
    Y,
];
const VARIABLE_THREAD: &[CodeWord] = &[
    X.stays(),
    Z.stays(),
    LEAD,
    word(b"K", &[Role::LeadChange]).must(),
    START_ANGLE,
    LEAD_E,
    word(b"J", &[Role::PullOutAcross]),
    C,
    Y,
];

/// The words of a code of group 01, without the single cycles.
pub fn of_motion(mode: MotionMode, axes: Axes) -> &'static [CodeWord] {
    match (mode, axes.surface, axes.plane) {
        (MotionMode::Arc(_), Some(Surface::Face), _) => FACE_ARC,
        (MotionMode::Arc(_), Some(_), _) => SIDE_ARC,
        (MotionMode::Arc(_), None, Plane::Xy) => XY_ARC,
        (MotionMode::Arc(_), None, Plane::Yz) => YZ_ARC,
        (MotionMode::Arc(_), None, Plane::Zx) => ARC,
        (MotionMode::Line, Some(Surface::Face), _) => FACE_LINE,
        (MotionMode::Line, Some(_), _) => SIDE_LINE,
        (MotionMode::Line, None, _) if axes.c_axis => LINE_AND_C,
        (MotionMode::Line, None, _) => LINE,
        (MotionMode::Rapid, None, _) if axes.c_axis => RAPID_AND_C,
        (MotionMode::Rapid, ..) => RAPID,
        (MotionMode::Thread | MotionMode::Tapping, ..) => THREAD,
        (MotionMode::VariableThread, ..) => VARIABLE_THREAD,
        (MotionMode::Cycle(cycle), ..) => cycle.spec().words,
    }
}

const HOLE_ANGLE: CodeWord = word(b"CH", &[Role::HoleAngle, Role::HoleAngle]).may();
const R_POINT: CodeWord = word(b"R", &[Role::RPoint]).zero();
const HOLE_PECK: CodeWord = word(b"Q", &[Role::HolePeck]).may();
const HOLE_DWELL: CodeWord = word(b"P", &[Role::HoleDwell]).zero();
const HOLE_REPEATS: CodeWord = word(b"K", &[Role::Repeats]).may();
const FACE_HOLE: &[CodeWord] = &[
    word(b"XU", &[Role::HolePlaceX, Role::HolePlaceX]).stays(),
    HOLE_ANGLE,
    word(b"ZW", &[Role::HoleEndZ, Role::HoleWayZ]).must(),
    R_POINT,
    HOLE_PECK,
    HOLE_DWELL,
    FEED.as_set(),
    HOLE_REPEATS,
];
const SIDE_HOLE: &[CodeWord] = &[
    word(b"XU", &[Role::HoleEndX, Role::HoleWayX]).must(),
    HOLE_ANGLE,
    word(b"ZW", &[Role::HolePlaceZ, Role::HolePlaceZ]).stays(),
    R_POINT,
    HOLE_PECK,
    HOLE_DWELL,
    FEED.as_set(),
    HOLE_REPEATS,
];

/// The words of a hole cycle.
pub fn of_hole(hole: Hole) -> &'static [CodeWord] {
    if hole.is_face() { FACE_HOLE } else { SIDE_HOLE }
}

const VIA_X: CodeWord = word(b"XU", &[Role::ViaX, Role::ViaWayX]).stays();
const VIA_Z: CodeWord = word(b"ZW", &[Role::ViaZ, Role::ViaWayZ]).stays();
const VIA_C: CodeWord = word(b"CH", &[Role::ViaC, Role::ViaC]);
const DWELL: &[CodeWord] =
    &[word(b"XUP", &[Role::DwellSeconds, Role::DwellSeconds, Role::DwellMilliseconds]).must(), FEED];
const HOME: &[CodeWord] = &[VIA_X, VIA_Z, VIA_C, FEED];
const OTHER_HOME: &[CodeWord] = &[word(b"P", &[Role::ReferencePoint]).may(), VIA_X, VIA_Z, VIA_C, FEED];
const MACHINE: &[CodeWord] =
    &[word(b"X", &[Role::MachineX]).stays(), word(b"Z", &[Role::MachineZ]).stays(), FEED];
const SETTING: &[CodeWord] = &[
    word(b"XU", &[Role::OriginX, Role::ShiftX]).may(),
    word(b"ZW", &[Role::OriginZ, Role::ShiftZ]).may(),
    word(b"S", &[Role::HighestSpeed]).may(),
    word(b"Q", &[Role::LowestSpeed]).may(),
    FEED,
];
const LOCAL_FRAME: &[CodeWord] =
    &[word(b"X", &[Role::LocalX]).stays(), word(b"Z", &[Role::LocalZ]).stays(), FEED];
const EXTENDED_FRAME: &[CodeWord] = &[word(b"P", &[Role::FrameNumber]), X, Z, C, Y, FEED];
const DATA: &[CodeWord] = &[
    word(b"P", &[Role::DataNumber]),
    word(b"L", &[Role::DataKind]),
    word(b"RC", &[Role::DataRadius, Role::DataRadius]),
    word(b"Q", &[Role::DataTip]),
    word(b"XZUWY", &[Role::DataValue; 5]),
    FEED,
];
const CYLINDER: &[CodeWord] = &[word(b"CH", &[Role::CylinderRadius, Role::CylinderRadius]), FEED];

/// The words of a one-shot code other than a cycle.
pub fn of_one_shot(code: G) -> &'static [CodeWord] {
    match code {
        G::Dwell => DWELL,
        G::Home | G::FromHome | G::CheckHome => HOME,
        G::OtherHome => OTHER_HOME,
        G::Machine => MACHINE,
        G::Setting => SETTING,
        G::LocalFrame => LOCAL_FRAME,
        G::ExtendedFrame => EXTENDED_FRAME,
        G::Data => DATA,
        G::Cylinder => CYLINDER,
        _ => &[FEED],
    }
}

const CALL_REPEATS: CodeWord = word(b"L", &[Role::CallRepeats]);
const CALL: &[CodeWord] = &[
    word(b"P", &[Role::CalledProgram]).must(),
    CALL_REPEATS.may(),
    word(b"Q", &[Role::BeginsAt]),
    X,
    Z,
    C,
    Y,
    FEED,
];
const LOCAL_CALL: &[CodeWord] =
    &[word(b"P", &[Role::CalledSequence]).must(), CALL_REPEATS.may(), X, Z, C, Y, FEED];
const RETURN: &[CodeWord] = &[word(b"P", &[Role::ReturnsTo]).may(), CALL_REPEATS, X, Z, C, Y, FEED];

/// The words of M97, M98 and M99.
pub fn of_call(call: M) -> &'static [CodeWord] {
    match call {
        M::LocalCall => LOCAL_CALL,
        M::Return => RETURN,
        _ => CALL,
    }
}

/// The words of G65 and G66; every other letter is an argument.
pub const MACRO_CALL: &[CodeWord] = &[
    word(b"P", &[Role::CalledProgram]).must(),
    CALL_REPEATS.may(),
    word(b"ABC", &[Role::Argument; 3]).may(),
];

#[cfg(test)]
mod tests {
    use super::{Axes, CodeWord, MACRO_CALL, of_call, of_hole, of_motion, of_one_shot};
    use crate::control::codes::cycles::CycleBlock;
    use crate::control::codes::{self, G, M, MotionMode, Plane};
    use crate::geometry::virtual_plane::Surface;
    use crate::setup::dialect::CodeList;

    /// Every list of words: of all codes, with all axes and planes.
    fn lists() -> Vec<&'static [CodeWord]> {
        let blocks = [CycleBlock::First, CycleBlock::Second, CycleBlock::Whole];
        let surfaces = [None, Some(Surface::Face), Some(Surface::Cylinder { radius: 20.0, turned: false })];
        let planes = [Plane::Zx, Plane::Xy, Plane::Yz];
        let in_plane = surfaces.iter().flat_map(|surface| planes.map(|plane| (*surface, plane)));
        let axes: Vec<_> = in_plane
            .flat_map(|(surface, plane)| [false, true].map(|c_axis| Axes { surface, plane, c_axis }))
            .collect();
        let mut lists = vec![MACRO_CALL, of_call(M::Call), of_call(M::LocalCall), of_call(M::Return)];
        for (_, code) in codes::g_codes(CodeList::A) {
            match code.code {
                G::Multiple(cycle) => lists.extend(blocks.map(|block| cycle.spec().words(block))),
                G::Motion(MotionMode::Cycle(cycle)) => {
                    lists.extend([cycle.spec().words, cycle.spec().on_gsk]);
                }
                G::Motion(mode) => lists.extend(axes.iter().map(|axes| of_motion(mode, *axes))),
                G::Hole(hole) => lists.push(of_hole(hole)),
                code => lists.push(of_one_shot(code)),
            }
        }
        lists
    }

    #[test]
    fn each_letter_is_in_a_block_once_and_has_a_role() {
        let mut count = 0;
        for words in lists() {
            let mut seen = Vec::new();
            for CodeWord { letters, comma, roles, .. } in words {
                assert_eq!(letters.len(), roles.len(), "{letters:?}");
                for letter in *letters {
                    assert!(!seen.contains(&(*comma, letter)), "{} twice in {words:?}", *letter as char);
                    seen.push((*comma, letter));
                }
                count += letters.len();
            }
        }
        assert!(count > 400, "{count}");
    }
}
