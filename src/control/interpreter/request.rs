//! The codes of one block, until the block is carried out.
//!
//! Plain values: `read_words` fills them in, `block` carries them out.

use crate::control::codes::{self, MacroCall, MotionMode, Multiple, Switch};
use crate::geometry::Point;
use crate::message::Diagnostic;
use crate::motion::StopKind;
use crate::source::Span;

/// One-shot codes: they use the words of their block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum OneShot {
    Dwell,
    Home,
    OtherHome,
    CheckHome,
    FromHome,
    Machine,
    Data,
    Setting,
    LocalFrame,
    /// G12.1, G13.1.
    Polar(Switch),
    /// G07.1.
    Cylinder,
    /// G70 to G76.
    Multiple(Multiple),
    NotSupported,
}

/// Groups of codes of which a block can have only one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Exclusive {
    Motion,
    Surface,
    Feed,
    Compensation,
    /// M03, M04, M05.
    Spindle,
}

/// M97, M98 or M99, to be carried out after all other words of its block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum CallCode {
    /// M98.
    Call,
    /// M97.
    LocalCall,
    /// M99.
    Return,
}

/// The codes of one block.
#[derive(Default)]
pub(super) struct Request {
    pub one_shot: Option<OneShot>,
    /// Ten times the number of a G code that is not supported.
    pub unsupported: Option<u64>,
    /// The code of group 01 in the block.
    pub motion: Option<MotionMode>,
    /// G96 (true) or G97.
    pub surface: Option<bool>,
    /// M05.
    pub stop_spindle: bool,
    /// M25: the quill of the tailstock comes forward.
    pub extends_quill: bool,
    /// M00, M01.
    pub stop: Option<StopKind>,
    /// M02, M30.
    pub end: bool,
    /// A machine-specific M code.
    pub has_machine_m_code: bool,
    /// M06: the tool of the block is changed.
    pub changes_tool: bool,
    /// M97, M98, M99.
    pub call_code: Option<CallCode>,
    /// G65 or G66: the words after it are arguments.
    pub macro_call: Option<MacroCall>,
    /// The hole cycle in the block.
    pub hole: Option<codes::Hole>,
    /// Words whose address appears twice.
    pub duplicates: Vec<Diagnostic>,
    /// G43: H is a length offset.
    pub length_offset: bool,
    /// A machine-specific G code: the words of its block are arguments of a macro.
    pub arguments: bool,
    /// G54.1, with the frame in P.
    pub extended_frame: Option<Span>,
    /// The motion of the block is not carried out.
    pub drop: bool,
    /// For each group in `Exclusive`: number and span of the last code.
    pub group_words: [Option<(u64, Span)>; 5],
    /// Indices of the words with a comma: `,C2`, `,R1`, `,A30`.
    pub comma: [Option<usize>; 3],
    /// The block made a move of the path.
    pub moved: bool,
    /// G40, G41 or G42 changes compensation.
    pub switches_compensation: bool,
    /// G40 ends compensation, even if a roughing cycle ignores it.
    pub ends_compensation: bool,
    /// For that block: the direction of the wall given by I and K; radius and length in mm.
    pub wall: Option<Point>,
}

impl Request {
    /// Whether a move of the block uses the code of an earlier block.
    pub fn uses_modal_code(&self) -> bool {
        self.motion.is_none() && self.one_shot.is_none() && self.hole.is_none()
    }
}
