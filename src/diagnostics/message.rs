//! Every message there is, with the numbers it tells, and what is the same in all languages: code, slug,
//! severity, kind and alarm.
//!
//! A new message is a variant here and a sentence in each of `messages/`; one without a translation does not
//! compile. `code` is the identifier of the semantics (`W-…`, `E-…`) or, where there is none, the alarm a
//! control raises; `slug` is named after the fault.

use std::borrow::Cow;

use crate::control::macros::FaultKind;
use crate::origin::{Measure, Origin};
use crate::setup::dialect::{DecimalRule, GSystem};
use crate::setup::faults::Need;

/// How grave a message is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// Told only where somebody asks for it (`levels`).
    Off,
    /// Good to know.
    Info,
    /// The program runs, but perhaps not as meant.
    Warning,
    /// The block is not carried out.
    Error,
}

impl Severity {
    /// All of them, the lowest first.
    pub const ALL: [Self; 4] = [Self::Off, Self::Info, Self::Warning, Self::Error];

    /// The one of a name, written in any case.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|severity| severity.name().eq_ignore_ascii_case(name))
    }

    /// Name in the output of the command line and in the wasm interface.
    pub fn name(self) -> &'static str {
        match self {
            Self::Off => "off",
            Self::Info => "info",
            Self::Warning => "warning",
            Self::Error => "error",
        }
    }
}

/// Whose matter it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// The program is wrong, or likely so.
    Wrong,
    /// The program may be right; the playground does not do this.
    Unsupported,
    /// It depends on the machine.
    Machine,
}

impl Kind {
    /// Name in the wasm interface.
    pub fn name(self) -> &'static str {
        match self {
            Self::Wrong => "wrong",
            Self::Unsupported => "unsupported",
            Self::Machine => "machine",
        }
    }
}

/// Something to tell the user. Lengths are in mm as people write them: X values are diameters.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs, reason = "the fields are the numbers and words that the sentence quotes")]
pub enum Message {
    // Text
    /// An address without its number.
    NumberMissing { address: char },
    /// A number without an address.
    AddressMissing { number: String },
    /// Characters that belong to no word.
    NotUnderstood { text: String },
    /// A whole line of prose outside brackets.
    PlainText { text: String },
    /// `X-12.8.`
    SecondPoint { word: String },
    /// More digits than a control takes.
    TooManyDigits { word: String },
    /// `X1 0`: a control reads `X10`.
    BlankInNumber { written: String, joined: String },
    /// `GO1`.
    LetterForDigit { address: char, word: String, digit: &'static str },
    /// `00006` where a program number belongs.
    ZeroForO { number: String },
    /// A dash of print in place of a minus.
    PrintedMinus,
    /// `Ｘ５０`.
    FullWidth { word: String, plain: String },
    /// `Z,15`.
    CommaForPoint { address: char, word: String },
    /// `(` without `)`.
    CommentOpen,
    /// Brackets within a comment.
    CommentNested,
    /// Prose behind a `;`.
    TextAfterSemicolon { text: String },
    /// A block with more words than are read.
    BlockTooLong { most: usize },
    /// The text is longer than can be handled.
    TextTooLong { bytes: usize, most: usize },
    /// There is nothing to run.
    EmptyProgram,
    /// A program number of zero.
    ProgramNumberZero,
    /// The same program number twice.
    DuplicateProgram { number: u32 },
    /// The text ends without M30 or M02.
    NoEnd,

    // Bounds
    /// More messages than are shown.
    MoreMessages { hidden: usize },
    /// More motions than are kept.
    TooManyMotions { most: usize },
    /// The cycles take too many steps to work out.
    TooMuchWork { most: usize },
    /// The run was stopped from outside.
    Stopped { seconds: f64 },

    // Programs and calls
    /// M98, M97 or G65 without the program it calls.
    CallNoNumber { code: &'static str },
    /// No program of that number stands in the text.
    ProgramNotFound { word: String },
    /// No block of that number stands in the program.
    SequenceNotFound { sequence: u32 },
    /// Too many calls, one within the other.
    CallTooDeep { most: usize, alarm: &'static str },
    /// A subprogram ends without M99.
    NoReturn,
    /// M99 in the main program.
    EndlessMain,
    /// Too many blocks through jumps, loops and calls.
    TooManyRepeats { most: usize },
    /// Too many bytes of such blocks.
    TooMuchRepeated { most: usize },
    /// Too many rounds of loops and calls.
    TooManyRounds { most: usize },
    /// Too many macro statements and expressions.
    TooManyMacroSteps { most: usize },
    /// A program that nothing calls.
    NotRun { number: u32 },

    // Macros
    /// A variable behind N or O.
    NumberFromVariable { word: String },
    /// A macro statement or expression that cannot be carried out.
    Macro { kind: FaultKind },
    /// `#3000`: the program itself raises an alarm.
    MacroAlarm { number: i64, words: String },
    /// A system variable that is not known here.
    SystemVariable { variable: u32 },
    /// The body of a macro is run without the call that gives its arguments.
    ArgumentsUnknown { variable: u32 },

    // Where the program comes from
    /// A program for a control or machine that is not read here.
    Foreign { origin: Origin },
    /// The G-code system was concluded from the program.
    SystemGuessed { system: GSystem },
    /// What numbers without a point count was concluded from the program (least increments), or looks wrong (units). The word
    /// is one of them, `value` what it counts in its measure.
    DecimalRule { word: String, value: f64, measure: Measure, rule: DecimalRule },

    // Reference points, tables
    /// G30 with another P than 2, 3, 4.
    ReferenceNumber { word: String },
    /// G27 away from the reference point.
    NotAtReference { x: f64, z: f64 },
    /// G29 without an intermediate point.
    NoIntermediate,
    /// G53 counts from the reference point.
    MachineZero { x: f64, z: f64 },
    /// P of G10 or G54.1 names no entry.
    OffsetNumber { word: String },
    /// Q of G10 is no tip direction.
    TipNumber { word: String },
    /// Data for the control's tables.
    DataPassedOver,

    // Hole cycles
    /// A code that may not stand while a hole cycle is in force, and its alarm.
    HoleInForce { word: String, hole: &'static str, alarm: &'static str },
    /// Q of a peck cycle is zero.
    PeckZero { word: String },
    /// A hole cycle without its depth.
    HoleNoDepth { code: &'static str },
    /// A hole cycle system A does not have.
    HoleOfOthers { code: &'static str },

    // Codes and words
    /// No such G code.
    UnknownG { word: String },
    /// An M code this project does not know.
    UnknownM { word: String },
    /// Recognised, but not done here.
    NotSupported { what: String },
    /// A G code of a number that machine makers use.
    MakerG { word: String },
    /// A point in an address that takes none.
    PointNotAllowed { word: String },
    /// A minus in an address that takes none.
    MinusNotAllowed { word: String },
    /// The same address twice.
    DuplicateWord { address: char, used: String },
    /// Two G codes of one group.
    SameGroup { dropped: String, used: String },
    /// X with U, or Z with W.
    AbsoluteAndIncremental { absolute: String, incremental: String, used: String },
    /// T in a block with G50, G10 or G04; `only_speed`: with the highest speed of G50, which many controls take.
    ToolWithSetting { word: String, only_speed: bool },
    /// A T word of one or two digits.
    ShortTool { word: String, offset: u16 },
    /// A T word that names no tool; `of_machine`: it may on a machine with a tool changer or many offsets.
    ToolNumber { word: String, of_machine: bool },
    /// G90 without axis words, as mills use it.
    G90AsAbsolute,
    /// I in a G92 block.
    LetterIInG92,
    /// G28 or G30 without an axis.
    G28NoAxis { code: &'static str },
    /// P of G04 with a point.
    DwellWithPoint { word: String },
    /// G04 without a time.
    DwellNoTime,

    // C axis, polar and cylindrical interpolation
    /// Y or V, or another axis a lathe has only with a live tool.
    AxisNotHere { word: String },
    /// An arc in the plane of a milling head.
    PlaneNotHere { word: &'static str },
    /// C moves without being connected.
    CAxisNotConnected,
    /// A cut with a live tool that nothing has started.
    LiveToolStopped,
    /// A code that may not stand in polar interpolation.
    PolarForbidden { word: String },
    /// A change of coordinates in polar interpolation.
    PolarFrame { word: String },
    /// G12.1 or G13.1 with other words.
    PolarNotAlone { code: &'static str, other: String },
    /// G12.1 or G13.1 under compensation.
    PlaneCompensation { code: &'static str },
    /// Feed per turn in polar interpolation.
    PolarFeedPerTurn,
    /// Compensation without a cutter radius; `offset`: of it nothing is known, the machine may have its radius.
    PolarNoRadius { offset: Option<u16> },
    /// C looks like degrees, but is mm there.
    PolarAngle { word: String },
    /// The path comes too near to the centre.
    PolarCenter { distance: f64 },
    /// Polar interpolation is still on.
    PlaneLeftOn { code: String, off: &'static str },
    /// G07.1 is not written as it should be.
    CylinderFormat,
    /// Something that may not stand in cylindrical interpolation.
    CylinderForbidden { word: String },

    // Feed and spindle
    /// A cut before any F.
    FeedMissing,
    /// A thread without its lead.
    LeadMissing { code: &'static str },
    /// F looks like the other unit.
    FeedUnit { word: String, feed: f64, per_turn: bool },
    /// The feed unit changed, F did not.
    FeedNotRepeated { feed: f64, per_turn: bool },
    /// A cut with the spindle stopped.
    SpindleStopped,
    /// G96 without a highest speed.
    NoSpeedClamp,
    /// The lowest speed is above the highest.
    ClampReversed { lowest: f64, highest: f64 },
    /// G96 while threading.
    ThreadAtSurfaceSpeed { code: &'static str },

    // Arcs
    /// Neither R nor I, K.
    ArcNoCenter { code: &'static str },
    /// R is too small for the distance.
    ArcRadiusTooSmall { word: String, distance: f64 },
    /// The end does not lie on the circle.
    ArcEndOffCircle { start_radius: f64, end_radius: f64 },
    /// R is negative and the control does not take it.
    ArcRadiusNegative { word: String },
    /// R with an end that is the start.
    ArcNowhere,

    // Cycles
    /// The start of the cut lies beyond the start point of the cycle.
    TaperBeyondStart { word: String, limit: f64, axis: char },
    /// R fits the drawing but not the real start point.
    TaperNotExtended { taper: f64, needed: f64, crossing: f64, wanted: f64, axis: char },
    /// P or Q is missing in G70 to G73.
    ContourNotNamed { code: &'static str },
    /// No block has the number that P or Q names.
    ContourNotFound { word: String },
    /// The block that Q names stands before that of P.
    ContourReversed { first: u32, word: String },
    /// The first block of a contour does not move by G00 or G01.
    ContourFirstBlock { code: &'static str },
    /// A code that may not stand in a contour.
    ContourIllegal { word: String },
    /// P and Q take in another cycle.
    ContourReachesOver { code: &'static str, word: String, line: u32 },
    /// A subprogram call in a contour.
    ContourCall { word: String },
    /// The first block names both axes though the second does not move.
    ContourBothAxes { code: &'static str, other: char },
    /// The first block moves both axes and the control has no type II.
    ContourTypeTwo { code: &'static str },
    /// The contour turns back.
    ContourTurnsBack { code: &'static str, axis: char, line: u32 },
    /// The contour goes beyond the start point.
    ContourBeyondStart { code: &'static str, axis: char },
    /// The contour leaves no depth, or no way to cut along.
    ContourNothingToCut { code: &'static str },
    /// The contour ends with a corner or an angle that needs a further move.
    ContourOpenEnd { word: String, alarm: &'static str },
    /// The depth of a pass is missing, zero or negative.
    DepthNotPositive { code: &'static str, depth: Option<f64> },
    /// The allowance points into the part.
    AllowanceSign { word: String },
    /// G73 without a number of passes.
    PatternPasses { passes: Option<f64> },
    /// A cycle would take far too many passes.
    TooManyPasses { code: &'static str, most: usize },
    /// A peck or a step is negative.
    PeckNegative { word: String },
    /// A peck or a step is missing or zero though its axis moves.
    PeckMissing { code: &'static str, address: char },
    /// A relief that is negative though its direction is known.
    ReliefNegative { word: String },
    /// P or Q was read as millimetres.
    AmountInMillimetres { word: String },
    /// The tool angle of G76 is none a control takes.
    ThreadAngle { angle: f64 },
    /// The least depth of G76 is larger than the thread.
    ThreadLeastDepth { least: f64, height: f64 },
    /// The height or the first depth of G76 is zero or missing.
    ThreadNoDepth { word: char },
    /// G76 starts inside the crest of its thread, or just at it.
    ThreadStartInside { start: f64, crest: f64, at_crest: bool },
    /// A corner word whose next block is no straight move.
    CornerNoMove { word: String },
    /// A corner is larger than one of its moves.
    CornerTooLarge { word: String },
    /// A corner between moves that form none.
    CornerNone { word: String },
    /// A corner between moves less than 1° apart.
    CornerStraight { word: String },
    /// A corner word in a block that has no straight cut or arc of its own.
    CornerNoLine { word: String },
    /// The sign or axis of a corner word does not fit the next move.
    CornerAxis { word: String, alarm: &'static str },
    /// More than one corner word in a block.
    CornerTwice { word: String, other: String },
    /// A corner word in a block that threads.
    CornerInThread { word: String },
    /// A corner word where compensation begins or ends.
    CornerWithCompensation { word: String },
    /// The multiple cycles need the plane of turning.
    CyclePlane { code: &'static str, alarm: &'static str },
    /// A word that has no meaning in a multiple cycle.
    CycleWord { code: &'static str, word: String },
    /// An axis that a single cycle does not have.
    CycleAxis { code: &'static str, word: String },
    /// G70 does not start where roughing did.
    FinishStart { roughed_x: f64, roughed_z: f64 },
    /// G70 along a contour that was not roughed.
    FinishWithoutRoughing { first: u32, last: u32 },
    /// An angle leads nowhere.
    AngleNoPoint { word: String, alarm: &'static str },
    /// G41 or G42 begins or ends on an arc.
    CompensationOnArc { code: &'static str },
    /// The nose does not fit the contour.
    CompensationOvercut { radius: f64, alarm: &'static str },
    /// Two offset moves do not meet.
    CompensationNoIntersection { radius: f64 },
    /// The plane changes under compensation.
    CompensationPlane,
    /// G34 whose lead is zero after `reached` mm of a thread of `length` mm.
    LeadRunsOut { word: String, reached: f64, length: f64 },

    /// Nose compensation in force where it does nothing.
    CompensationIdle { code: &'static str },
    /// `F02`: a zero before a number without a point.
    LeadingZero { word: String, value: f64, meant: String },
    /// One number without a point among many with one.
    PointMissing { word: String, thousandths: f64 },
    /// A place far beyond all others of the program.
    FarOff { word: String, axis: char, to: f64, farthest: f64 },
    /// A cut that leads away from the work.
    MinusMissing { word: String, meant: String },
    /// U where X was probably meant.
    IncrementalForAbsolute { word: String, axis: char, to: f64, meant: String },
    /// The spindle is to turn, but has no speed; `of_surface`: G97 had one, G96 has none.
    SpeedMissing { of_surface: bool },
    /// G96 or G97 changes what S means, but no S stands there.
    SpeedNotRepeated { code: &'static str, speed: f64 },
    /// The spindle turns too fast for the lead.
    ThreadTooFast { speed: f64, pitch: f64, limit: f64, slide: f64 },
    /// The spindle changes between two passes of a thread.
    ThreadSpeedChanged { before: f64, now: f64 },
    /// Two passes of a thread do not start in the same groove.
    ThreadStartMoved { before: f64, now: f64, lead: f64 },
    /// Too little way before the thread.
    ThreadRunIn { have: f64, need: f64 },
    /// A thread much higher or lower than its pitch asks for.
    ThreadHeight { height: f64, pitch: f64, usual: f64 },
    /// The first cut of a thread is deeper than the thread.
    ThreadFirstDepth { first: f64, height: f64 },
    /// The least depth of G76 is very large.
    ThreadLeastLarge { word: String, least: f64 },
    /// The pull-out of a thread is longer than the way out.
    ThreadPullOut { pull_out: f64, way: f64 },
    /// The lead of a thread is still the feed of a cut.
    FeedOfThread { feed: f64 },
    /// The feed of a cut has become the lead of a thread.
    LeadOfFeed { code: &'static str, feed: f64 },
    /// A taper that becomes thinner toward the chuck.
    TaperNarrows { word: String },
    /// A taper whose cut begins beyond the axis.
    TaperCrossesAxis { word: String, x: f64 },
    /// The first pass of a taper is very deep at one end.
    TaperEdge { depth: f64 },
    /// A pass of a cycle that cuts nothing.
    PassNotDeeper { word: String, axis: char, deepest: f64 },
    /// A cycle that starts far from the work.
    AirCut { axis: char, distance: f64 },
    /// A facing cycle that starts behind the face.
    StartBehindFace { z: f64, face: f64 },
    /// A cycle that starts at a diameter within the blank.
    StartInStock { code: &'static str, x: f64 },
    /// The turret turns near the work.
    ToolChangeNear { tool: String, x: f64, z: f64 },
    /// The tool leaves a bore sideways.
    BoreRetract { x: f64, z: f64 },
    /// The step of a groove is as wide as the blade.
    GrooveStep { word: String, step: f64, width: f64 },
    /// The retract of a roughing pass is larger than the pass.
    EscapeTooLarge { word: String, depth: f64 },
    /// The contour does not begin where the cycle starts.
    ContourStartMoved { code: &'static str, axis: char, start: f64, first: f64 },
    /// The contour ends within the blank.
    ContourNotClosed { x: f64, diameter: f64 },
    /// The first pass of G73 is too deep.
    PatternShallow { depth: f64, relief: f64 },
    /// Most of the first pass of G73 cuts air.
    PatternAir { share: f64 },
    /// Compensation is switched within a cycle.
    CompensationInCycle { word: String, code: &'static str },
    /// Compensation is still on where the tool leaves.
    CompensationLeftOn { code: &'static str, word: String },
    /// The nose is on the wrong side of the path.
    CompensationSide { code: &'static str, right: &'static str },
    /// The path turns straight back under compensation.
    CompensationTurnsBack { code: &'static str },
    /// Blocks without a move under compensation.
    CompensationIdleBlocks,
    /// The move that begins or ends compensation is too short.
    CompensationShort { length: f64, radius: f64 },
    /// The tip number does not fit a turning tool.
    CompensationTip { tip: f64 },
    /// The chuck opens while the spindle turns.
    ChuckOpen { word: String },
    /// A tap is pulled out without turning back.
    TapReverse,
    /// Tapping at constant surface speed.
    TapSurface,
    /// A sequence number that is searched for stands twice.
    DuplicateSequence { sequence: u32, line: u32 },
    /// An arc of more than a half circle.
    ArcOverHalf { word: String },
    /// The program is too long for its numbers to be compared with each other.
    NotCompared { most: usize },
    /// A cut without coolant.
    CoolantOff,
    /// No G98 or G99 before the first cut.
    FeedModeNotNamed,
    /// A cut before any T.
    ToolNotNamed,
    /// F, S or T between P and Q.
    FeedOnlyForFinishing { word: String },
    /// M05 in a block with a move.
    StopBehindMove,

    // Setup
    /// A value of the setup that cannot be.
    SetupValue { key: String, value: f64, need: Need },
    /// A word of a setup comment that cannot be read.
    NoteWord { word: String, expected: Cow<'static, str> },

    // Machine
    /// The program has too many motions for the part to be worked out.
    PartTooManyMotions { most: usize },
    /// The outline of the part has too many corners.
    PartTooManyCorners { most: usize },
    /// Somebody has stopped the taking off of material.
    PartStopped { done: usize, all: usize },
    /// Behind a block that was not carried out: so many uncertain cuts are not taken off the part.
    BehindLeftOut { cuts: usize },
    /// So many cuts are made in another work frame whose zero nobody gave, and are not taken off the part.
    ElsewhereLeftOut { cuts: usize },
    /// Every tool that could be meant would cut into the contour.
    ToolUnknown { tool: String },
    /// The setup names tools, but not this one.
    ToolNotListed { tool: String },
    /// A rapid goes through the work.
    RapidThroughStock { x: f64, z: f64 },
    /// A rapid goes through the work where it is not a straight line.
    DoglegThroughStock { x: f64, z: f64 },
    /// A rapid goes along the outside of the blank.
    RapidAlongStock { x: f64 },
    /// The tool meets the jaws.
    IntoJaws { x: f64, z: f64 },
    /// The tool meets the tailstock.
    IntoTailstock { x: f64, z: f64 },
    /// The holder meets the work.
    HolderInStock { x: f64, z: f64 },
    /// The edge behind the tip cuts into a slope.
    SlopeTooSteep { slope: f64, follows: f64 },
    /// A cut goes far beyond the spindle axis.
    BelowCenter { x: f64 },
    /// The tip leaves the travel of an axis.
    OverTravel { axis: char, to: f64, limit: f64 },
}

impl Message {
    /// Stable code: the identifier of the semantics or the number of the alarm.
    pub fn code(&self) -> &'static str {
        self.facts().0
    }

    /// Stable name of the fault.
    pub fn slug(&self) -> &'static str {
        self.facts().1
    }

    /// How grave it usually is.
    pub fn severity(&self) -> Severity {
        self.facts().2
    }

    /// The alarm a real control raises.
    pub fn alarm(&self) -> Option<&'static str> {
        self.facts().3
    }

    /// Whose matter it is.
    pub fn kind(&self) -> Kind {
        match self {
            Self::NotSupported { .. }
            | Self::Foreign { .. }
            | Self::DataPassedOver
            | Self::AxisNotHere { .. }
            | Self::PlaneNotHere { .. }
            | Self::TooManyMotions { .. }
            | Self::TooMuchWork { .. }
            | Self::TooManyRepeats { .. }
            | Self::TooMuchRepeated { .. }
            | Self::TooManyRounds { .. }
            | Self::TooManyMacroSteps { .. }
            | Self::TextTooLong { .. }
            | Self::PartTooManyMotions { .. }
            | Self::PartTooManyCorners { .. }
            | Self::PartStopped { .. }
            | Self::BehindLeftOut { .. }
            | Self::ElsewhereLeftOut { .. }
            | Self::ToolUnknown { .. }
            | Self::NotCompared { .. }
            | Self::Stopped { .. } => Kind::Unsupported,
            // The control's own memory may hold the program.
            Self::UnknownM { .. }
            | Self::ShortTool { .. }
            | Self::LetterIInG92
            | Self::G28NoAxis { .. }
            | Self::ContourBothAxes { .. }
            | Self::MakerG { .. }
            | Self::HoleOfOthers { .. }
            | Self::MachineZero { .. }
            | Self::SystemVariable { .. }
            | Self::ArgumentsUnknown { .. }
            | Self::CAxisNotConnected
            | Self::LiveToolStopped
            | Self::FeedMissing
            | Self::ProgramNotFound { .. }
            | Self::ToolNotListed { .. }
            | Self::DoglegThroughStock { .. }
            | Self::CompensationTip { .. }
            | Self::ChuckOpen { .. }
            | Self::ThreadTooFast { .. }
            | Self::OverTravel { .. } => Kind::Machine,
            _ => Kind::Wrong,
        }
    }

    fn facts(&self) -> (&'static str, &'static str, Severity, Option<&'static str>) {
        use Severity::{Error, Info, Off, Warning};
        match self {
            Self::NumberMissing { .. } => ("PS0005", "number-missing", Error, Some("PS0005")),
            Self::AddressMissing { .. } => ("PS0004", "address-missing", Error, Some("PS0004")),
            Self::NotUnderstood { .. } => ("PS0009", "character-not-understood", Error, Some("PS0009")),
            Self::PlainText { .. } => ("W-PLAIN-TEXT", "text-outside-comment", Error, Some("PS0009")),
            Self::SecondPoint { .. } => ("PS0007", "second-decimal-point", Error, Some("PS0007")),
            Self::TooManyDigits { .. } => ("PS0003", "too-many-digits", Error, Some("PS0003")),
            Self::BlankInNumber { .. } => ("W-BLANK-IN-NUMBER", "blank-in-number", Warning, None),
            Self::LetterForDigit { .. } => ("W-OCR", "letter-for-digit", Error, Some("PS0005")),
            Self::ZeroForO { .. } => ("W-OCR", "zero-for-letter-o", Warning, None),
            Self::PrintedMinus => ("W-OCR", "printed-minus", Warning, None),
            Self::FullWidth { .. } => ("W-OCR", "full-width-character", Warning, None),
            Self::CommaForPoint { .. } => ("W-OCR", "comma-for-point", Error, Some("PS0004")),
            Self::CommentOpen => ("W-COMMENT-OPEN", "comment-not-closed", Warning, None),
            Self::CommentNested => ("W-COMMENT-NESTED", "comment-in-comment", Warning, None),
            Self::TextAfterSemicolon { .. } => ("W-TEXT-AFTER-EOB", "text-after-semicolon", Warning, None),
            Self::BlockTooLong { .. } => ("E-BLOCK-TOO-LONG", "block-too-long", Error, None),
            Self::TextTooLong { .. } => ("E-TEXT-TOO-LONG", "text-too-long", Error, None),
            Self::EmptyProgram => ("I-EMPTY", "empty-program", Info, None),
            Self::ProgramNumberZero => ("E-PROGRAM-ZERO", "program-number-zero", Error, None),
            Self::DuplicateProgram { .. } => ("W-DUP-O", "duplicate-program-number", Warning, None),
            Self::NoEnd => ("W-NO-END", "no-program-end", Warning, Some("PS5010")),
            Self::MoreMessages { .. } => ("I-MORE", "more-messages", Info, None),
            Self::TooManyMotions { .. } => ("E-TOO-MANY-MOTIONS", "too-many-motions", Error, None),
            Self::TooMuchWork { .. } => ("E-TOO-MUCH-WORK", "too-much-work", Error, None),
            Self::Stopped { .. } => ("E-STOPPED", "run-stopped", Error, None),
            Self::CallNoNumber { .. } => ("PS0076", "call-without-number", Error, Some("PS0076")),
            Self::ProgramNotFound { .. } => ("PS0076", "program-not-found", Warning, Some("PS0076")),
            Self::SequenceNotFound { .. } => ("PS0128", "sequence-number-not-found", Error, Some("PS0128")),
            Self::CallTooDeep { alarm, .. } => (alarm, "calls-too-deep", Error, Some(alarm)),
            Self::NoReturn => ("W-NO-RETURN", "subprogram-without-return", Warning, Some("PS5010")),
            Self::EndlessMain => ("W-ENDLESS", "main-program-without-end", Info, None),
            Self::TooManyRepeats { .. } => ("W-ENDLESS", "too-many-repeats", Error, None),
            Self::TooMuchRepeated { .. } => ("W-ENDLESS", "too-much-text-repeated", Error, None),
            Self::TooManyRounds { .. } => ("W-ENDLESS", "too-many-rounds", Error, None),
            Self::TooManyMacroSteps { .. } => ("W-ENDLESS", "too-many-macro-steps", Error, None),
            Self::NotRun { .. } => ("I-NOT-RUN", "program-not-run", Info, None),
            Self::NumberFromVariable { .. } => ("PS0114", "number-from-variable", Error, Some("PS0114")),
            Self::Macro { kind } => (kind.alarm(), kind.slug(), Error, Some(kind.alarm())),
            Self::MacroAlarm { .. } => ("E-MACRO-ALARM", "macro-alarm", Error, None),
            Self::SystemVariable { .. } => ("W-MACRO-SYSTEM", "unknown-system-variable", Info, None),
            Self::ArgumentsUnknown { .. } => ("I-MACRO-ARGUMENTS", "macro-arguments-unknown", Info, None),
            Self::Foreign { .. } => ("N-FOREIGN", "program-for-another-control", Error, None),
            Self::SystemGuessed { .. } => ("I-G-SYSTEM", "g-code-system-concluded", Info, None),
            Self::DecimalRule { rule: DecimalRule::LeastIncrement, .. } => {
                ("I-DECIMAL", "least-increments-concluded", Info, None)
            }
            Self::DecimalRule { rule: DecimalRule::Calculator, .. } => {
                ("W-DECIMAL", "too-large-without-point", Warning, None)
            }
            Self::ReferenceNumber { .. } => ("PS0046", "reference-point-number", Error, Some("PS0046")),
            Self::NotAtReference { .. } => ("PS0092", "not-at-reference-point", Error, Some("PS0092")),
            Self::NoIntermediate => ("PS0305", "no-intermediate-point", Error, Some("PS0305")),
            Self::MachineZero { .. } => ("I-MACHINE-ZERO", "machine-zero-unknown", Info, None),
            Self::OffsetNumber { .. } => ("PS0030", "offset-number", Error, Some("PS0030")),
            Self::TipNumber { .. } => ("PS0032", "tip-number", Error, Some("PS0032")),
            Self::HoleInForce { alarm, .. } => (alarm, "code-with-hole-cycle", Error, Some(alarm)),
            Self::PeckZero { .. } => ("PS0045", "peck-zero", Error, Some("PS0045")),
            Self::DataPassedOver => ("N-DATA", "data-passed-over", Info, None),
            Self::HoleNoDepth { .. } => ("W-HOLE-NO-DEPTH", "hole-without-depth", Error, None),
            Self::HoleOfOthers { .. } => {
                ("W-HOLE-G81", "hole-cycle-of-other-controls", Warning, Some("PS0010"))
            }
            Self::UnknownG { .. } => ("PS0010", "unknown-g-code", Error, Some("PS0010")),
            Self::UnknownM { .. } => ("W-M-UNKNOWN", "unknown-m-code", Info, None),
            Self::NotSupported { .. } => ("N-UNSUPPORTED", "not-supported", Warning, None),
            Self::MakerG { .. } => ("W-G-MAKER", "g-code-of-the-machine", Warning, Some("PS0010")),
            Self::PointNotAllowed { .. } => ("PS0007", "point-not-allowed", Error, Some("PS0007")),
            Self::MinusNotAllowed { .. } => ("PS0006", "minus-not-allowed", Error, Some("PS0006")),
            Self::DuplicateWord { .. } => ("W-DUP-WORD", "duplicate-word", Warning, Some("PS5074")),
            Self::SameGroup { .. } => ("W-SAME-GROUP", "two-codes-of-one-group", Warning, Some("PS5074")),
            Self::AbsoluteAndIncremental { .. } => ("W-X-AND-U", "absolute-and-incremental", Warning, None),
            Self::ToolWithSetting { .. } => ("PS0245", "tool-with-setting-code", Error, Some("PS0245")),
            Self::ShortTool { .. } => ("W-T1", "short-tool-word", Warning, None),
            Self::ToolNumber { .. } => ("PS0043", "tool-number", Error, Some("PS0043")),
            Self::G90AsAbsolute => ("W-G90-MILL", "g90-is-a-cycle", Warning, None),
            Self::LetterIInG92 => ("W-G92-I", "letter-i-in-g92", Warning, None),
            Self::G28NoAxis { .. } => ("W-G28-NO-AXIS", "g28-without-axis", Warning, None),
            Self::DwellWithPoint { .. } => ("PS0007", "dwell-with-point", Warning, Some("PS0007")),
            Self::DwellNoTime => ("W-DWELL-NO-TIME", "dwell-without-time", Warning, None),
            Self::AxisNotHere { .. } => ("N-AXIS", "axis-not-supported", Warning, None),
            Self::PlaneNotHere { .. } => ("N-PLANE", "plane-not-supported", Warning, None),
            Self::CAxisNotConnected => ("W-C-AXIS", "c-axis-not-connected", Info, Some("PS0197")),
            Self::LiveToolStopped => ("W-LIVE-TOOL", "live-tool-stopped", Warning, None),
            Self::PolarForbidden { .. } => {
                ("E-G121-GCODE", "code-not-allowed-in-polar", Error, Some("PS0146"))
            }
            Self::PolarFrame { .. } => {
                ("E-G121-COORD", "coordinates-changed-in-polar", Error, Some("PS0146"))
            }
            Self::PolarNotAlone { .. } => ("E-G121-NOT-ALONE", "polar-not-alone-in-block", Error, None),
            Self::PlaneCompensation { .. } => {
                ("E-G121-COMP", "polar-with-compensation", Error, Some("PS0146"))
            }
            Self::PolarFeedPerTurn => ("W-POLAR-FEEDMODE", "polar-with-feed-per-turn", Warning, None),
            Self::PolarNoRadius { .. } => ("W-POLAR-RADIUS", "polar-without-cutter-radius", Warning, None),
            Self::PolarAngle { .. } => ("W-POLAR-ANGLE", "polar-c-like-degrees", Warning, None),
            Self::PolarCenter { .. } => ("W-POLAR-CENTER", "polar-near-centre", Warning, None),
            Self::PlaneLeftOn { .. } => ("W-POLAR-END", "polar-left-on", Warning, None),
            Self::CylinderFormat => ("PS0175", "cylinder-not-well-formed", Error, Some("PS0175")),
            Self::CylinderForbidden { .. } => {
                ("PS0176", "code-not-allowed-on-cylinder", Error, Some("PS0176"))
            }
            Self::FeedMissing => ("PS0011", "feed-missing", Error, Some("PS0011")),
            Self::LeadMissing { .. } => ("PS0011", "lead-missing", Error, Some("PS0011")),
            Self::FeedUnit { .. } => ("W-FEED-MODE", "feed-unit-mixed-up", Warning, None),
            Self::FeedNotRepeated { .. } => ("W-FEED-KEPT", "feed-kept-in-other-unit", Warning, None),
            Self::SpindleStopped => ("W-NO-SPINDLE", "cut-with-spindle-stopped", Warning, None),
            Self::NoSpeedClamp => ("W-CSS-NOCLAMP", "surface-speed-without-clamp", Warning, None),
            Self::ClampReversed { .. } => ("W-CSS-UNSET", "speed-clamp-reversed", Warning, None),
            Self::ThreadAtSurfaceSpeed { .. } => ("W-THREAD-CSS", "thread-at-surface-speed", Warning, None),
            Self::ArcNoCenter { .. } => ("PS0022", "arc-without-radius", Error, Some("PS0022")),
            Self::ArcRadiusTooSmall { .. } => ("PS0020", "arc-radius-too-small", Error, Some("PS0020")),
            Self::ArcEndOffCircle { .. } => ("PS0020", "arc-end-off-circle", Error, Some("PS0020")),
            Self::ArcRadiusNegative { .. } => ("PS0023", "arc-radius-negative", Error, Some("PS0023")),
            Self::ArcNowhere => ("W-ARC-NOWHERE", "arc-without-way", Warning, None),
            Self::TaperBeyondStart { .. } => ("E-TAPER-R", "taper-beyond-start-point", Error, None),
            Self::TaperNotExtended { .. } => ("W-TAPER-NOT-EXTENDED", "taper-not-extended", Warning, None),
            Self::ContourNotNamed { .. } => ("PS0061", "contour-not-named", Error, Some("PS0061")),
            Self::ContourNotFound { .. } | Self::ContourReversed { .. } => {
                ("W-NS-NOT-FOUND", "contour-not-found", Error, Some("PS0063"))
            }
            Self::ContourFirstBlock { .. } => ("PS0065", "contour-first-block", Error, Some("PS0065")),
            Self::ContourIllegal { .. } => ("PS0325", "code-not-allowed-in-contour", Error, Some("PS0325")),
            Self::ContourReachesOver { .. } => {
                ("PS0325", "contour-reaches-over-other-cycle", Error, Some("PS0325"))
            }
            Self::ContourCall { .. } => ("E-SUB-IN-CONTOUR", "call-in-contour", Error, Some("PS0210")),
            Self::ContourBothAxes { .. } => ("W-NS-BOTH-AXES", "contour-names-both-axes", Info, None),
            Self::ContourTypeTwo { .. } => ("W-NS-BOTH-AXES", "pockets-not-available", Error, Some("PS0323")),
            Self::ContourTurnsBack { axis: 'Z', .. } => {
                ("W-NOT-MONOTONE", "contour-turns-back", Error, Some("PS0064"))
            }
            Self::ContourTurnsBack { .. } => ("W-NOT-MONOTONE", "contour-turns-back", Error, Some("PS0329")),
            Self::ContourBeyondStart { .. } => {
                ("PS0322", "contour-beyond-start-point", Error, Some("PS0322"))
            }
            Self::ContourNothingToCut { .. } => ("PS0322", "contour-without-cut", Warning, Some("PS0322")),
            Self::ContourOpenEnd { alarm, .. } => (alarm, "contour-ends-in-corner", Error, Some(alarm)),
            Self::DepthNotPositive { depth: Some(_), .. } => {
                ("W-G71-U-SIGN", "depth-not-positive", Error, Some("PS0062"))
            }
            Self::DepthNotPositive { depth: None, .. } => {
                ("W-G71-U-ROLE", "depth-missing", Error, Some("PS0062"))
            }
            Self::AllowanceSign { .. } => ("W-ALLOWANCE-SIGN", "allowance-into-part", Warning, None),
            Self::PatternPasses { .. } => ("PS0321", "pattern-without-passes", Error, Some("PS0321")),
            Self::TooManyPasses { .. } => ("E-TOO-MANY-PASSES", "too-many-passes", Error, None),
            Self::PeckNegative { .. } => ("PS0320", "peck-negative", Error, Some("PS0320")),
            Self::PeckMissing { .. } => ("W-PECK-ZERO", "peck-missing", Error, Some("PS0319")),
            Self::ReliefNegative { .. } => ("PS0318", "relief-negative", Error, Some("PS0318")),
            Self::AmountInMillimetres { .. } => {
                ("W-PQ-UNIT", "amount-in-millimetres", Warning, Some("PS0007"))
            }
            Self::ThreadAngle { .. } => ("PS0315", "thread-angle", Error, Some("PS0315")),
            Self::ThreadLeastDepth { .. } => ("PS0316", "thread-least-depth", Error, Some("PS0316")),
            Self::ThreadNoDepth { .. } => ("PS0317", "thread-without-depth", Error, Some("PS0317")),
            Self::ThreadStartInside { .. } => ("W-THREAD-START", "thread-start-inside-crest", Warning, None),
            Self::CornerNoMove { .. } => ("PS0052", "corner-without-next-move", Error, Some("PS0052")),
            Self::CornerTooLarge { .. } => ("PS0055", "corner-too-large", Error, Some("PS0055")),
            Self::CornerNone { .. } | Self::CornerNoLine { .. } => {
                ("PS0051", "no-corner-here", Error, Some("PS0051"))
            }
            Self::CornerStraight { .. } => ("W-CORNER-STRAIGHT", "corner-on-straight-path", Warning, None),
            Self::CornerAxis { alarm, .. } => (alarm, "corner-axis", Error, Some(alarm)),
            Self::CornerTwice { .. } => ("PS0053", "two-corner-words", Error, Some("PS0053")),
            Self::CornerInThread { .. } => ("PS0050", "corner-in-thread", Error, Some("PS0050")),
            Self::CornerWithCompensation { .. } => {
                ("PS0039", "corner-with-compensation", Error, Some("PS0039"))
            }
            Self::CyclePlane { alarm, .. } => (alarm, "cycle-in-other-plane", Error, Some(alarm)),
            Self::CycleWord { .. } => ("PS0066", "word-not-allowed-in-cycle", Error, Some("PS0066")),
            Self::CycleAxis { .. } => ("PS0330", "axis-not-allowed-in-cycle", Error, Some("PS0330")),
            Self::FinishStart { .. } => ("W-G70-START", "finish-starts-elsewhere", Warning, None),
            Self::FinishWithoutRoughing { .. } => {
                ("W-G70-NO-ROUGH", "finish-without-roughing", Warning, None)
            }
            Self::AngleNoPoint { alarm, .. } => (alarm, "angle-without-point", Error, Some(alarm)),
            Self::CompensationOnArc { .. } => ("W-TNRC-INSIDE", "compensation-on-arc", Error, Some("PS0034")),
            Self::CompensationOvercut { alarm, .. } => (alarm, "compensation-overcut", Error, Some(alarm)),
            Self::CompensationNoIntersection { .. } => {
                ("PS0033", "compensation-no-meeting", Error, Some("PS0033"))
            }
            Self::CompensationPlane => ("PS0037", "compensation-plane-change", Error, Some("PS0037")),
            Self::LeadRunsOut { .. } => ("PS0313", "lead-runs-out", Error, Some("PS0313")),
            Self::CompensationIdle { .. } => ("W-TNRC-CYCLE", "compensation-without-effect", Warning, None),
            Self::LeadingZero { .. } => ("W-POINT", "leading-zero", Warning, None),
            Self::PointMissing { .. } => ("W-POINT", "point-missing", Warning, None),
            Self::FarOff { .. } => ("W-FAR", "far-beyond-the-rest", Warning, None),
            Self::MinusMissing { .. } => ("W-SIGN", "minus-missing", Warning, None),
            Self::IncrementalForAbsolute { .. } => ("W-U-FOR-X", "incremental-for-absolute", Warning, None),
            Self::SpeedMissing { .. } => ("W-NO-SPEED", "speed-missing", Warning, None),
            Self::SpeedNotRepeated { .. } => ("W-SPEED-KEPT", "speed-kept-in-other-unit", Info, None),
            // The rule of thumb is for small lathes; few slides follow beyond 4 m a minute.
            Self::ThreadTooFast { slide, .. } => {
                let severity = if *slide > 4000.0 { Warning } else { Info };
                ("W-SPINDLE-THREAD", "thread-spindle-too-fast", severity, None)
            }
            Self::ThreadSpeedChanged { .. } => ("W-THREAD-S-CHANGE", "thread-speed-changed", Warning, None),
            Self::ThreadStartMoved { .. } => ("W-THREAD-START-Z", "thread-start-moved", Warning, None),
            Self::ThreadRunIn { .. } => ("W-THREAD-LEADIN", "thread-run-in-short", Info, None),
            Self::ThreadHeight { .. } => ("W-THREAD-DEPTH", "thread-height-unusual", Warning, None),
            Self::ThreadFirstDepth { .. } => {
                ("W-THREAD-DEPTH", "thread-first-depth-too-large", Warning, None)
            }
            Self::ThreadLeastLarge { .. } => ("W-THREAD-DEPTH", "thread-least-depth-large", Warning, None),
            Self::ThreadPullOut { .. } => ("W-THREAD-PULLOUT", "thread-pull-out-too-long", Warning, None),
            Self::FeedOfThread { .. } => ("W-FEED-KEPT", "feed-of-thread-kept", Warning, None),
            Self::LeadOfFeed { .. } => ("W-FEED-KEPT", "lead-of-feed-kept", Warning, None),
            Self::TaperNarrows { .. } => ("W-TAPER-SIGN", "taper-narrows-to-chuck", Warning, None),
            Self::TaperCrossesAxis { .. } => {
                ("W-TAPER-START-CROSS", "taper-begins-beyond-axis", Warning, None)
            }
            Self::TaperEdge { .. } => ("W-TAPER-EDGE", "taper-first-pass-deep", Info, None),
            Self::PassNotDeeper { .. } => ("W-PASS-NOT-DEEPER", "pass-not-deeper", Warning, None),
            Self::AirCut { .. } => ("W-AIR-CUT", "start-far-from-work", Info, None),
            Self::StartBehindFace { .. } => ("W-START-BEHIND-FACE", "start-behind-face", Warning, None),
            Self::StartInStock { .. } => ("W-START-IN-STOCK", "cycle-starts-in-stock", Warning, None),
            Self::ToolChangeNear { .. } => ("W-TOOLCHANGE-POS", "tool-change-near-work", Warning, None),
            Self::BoreRetract { .. } => ("W-BORE-RETRACT", "leaves-bore-sideways", Error, None),
            Self::GrooveStep { .. } => ("W-GROOVE-OVERLAP", "groove-step-too-wide", Warning, None),
            Self::EscapeTooLarge { .. } => ("W-G71-E-BIG", "escape-larger-than-depth", Info, None),
            Self::ContourStartMoved { .. } => ("W-NS-Z", "contour-begins-elsewhere", Info, None),
            Self::ContourNotClosed { .. } => ("W-CONTOUR-NOT-CLOSED", "contour-ends-in-stock", Info, None),
            Self::PatternShallow { .. } => ("W-G73-DI", "pattern-first-pass-deep", Warning, None),
            Self::PatternAir { .. } => ("W-G73-AIR", "pattern-cuts-air", Info, None),
            Self::CompensationInCycle { .. } => {
                ("W-TNRC-INSIDE", "compensation-switched-in-cycle", Warning, None)
            }
            Self::CompensationLeftOn { .. } => ("W-TNRC-LEFT-ON", "compensation-left-on", Warning, None),
            Self::CompensationSide { .. } => ("W-TNRC-SIDE", "compensation-side", Warning, None),
            Self::CompensationTurnsBack { .. } => ("W-TNRC-BACK", "compensation-turns-back", Warning, None),
            Self::CompensationIdleBlocks => ("W-TNRC-NOMOVE", "compensation-without-moves", Warning, None),
            Self::CompensationShort { .. } => ("W-TNRC-SHORT", "compensation-move-short", Warning, None),
            Self::CompensationTip { .. } => ("W-TNRC-TIP", "compensation-tip", Warning, None),
            Self::ChuckOpen { .. } => ("W-M11-SPINDLE", "chuck-opens-while-turning", Warning, None),
            Self::TapReverse => ("W-TAP-REVERSE", "tap-not-reversed", Error, None),
            Self::TapSurface => ("W-TAP-CSS", "tap-at-surface-speed", Warning, None),
            Self::DuplicateSequence { .. } => ("W-DUP-N", "sequence-number-twice", Warning, None),
            Self::ArcOverHalf { .. } => ("W-ARC-OVER-HALF", "arc-over-half-circle", Warning, None),
            Self::NotCompared { .. } => ("I-NOT-COMPARED", "numbers-not-compared", Info, None),
            Self::CoolantOff => ("W-COOLANT", "coolant-off", Off, None),
            Self::FeedModeNotNamed => ("W-FEED-MODE-MISSING", "feed-mode-not-named", Off, None),
            Self::ToolNotNamed => ("W-NO-TOOL", "tool-not-named", Off, None),
            Self::FeedOnlyForFinishing { .. } => ("W-F-IN-CONTOUR", "feed-only-for-finishing", Off, None),
            Self::StopBehindMove => ("W-SEED-M05-ORDER", "spindle-stops-behind-move", Off, None),
            Self::SetupValue { .. } => ("E-SETUP", "setup-value", Error, None),
            Self::NoteWord { .. } => ("W-SETUP-NOTE", "setup-comment", Warning, None),
            Self::PartTooManyMotions { .. } => ("I-PART-MOTIONS", "part-too-many-motions", Info, None),
            Self::ElsewhereLeftOut { .. } => ("I-FRAME-UNKNOWN", "work-zero-unknown", Info, None),
            Self::ToolUnknown { .. } => ("I-TOOL-UNKNOWN", "tool-unknown", Info, None),
            Self::PartStopped { .. } => ("I-PART-STOPPED", "part-stopped", Info, None),
            Self::BehindLeftOut { .. } => ("I-NOT-CHECKED", "not-checked-behind-fault", Info, None),
            Self::PartTooManyCorners { .. } => ("I-PART-CORNERS", "part-too-many-corners", Info, None),
            Self::ToolNotListed { .. } => ("W-TOOL-NOT-LISTED", "tool-not-in-setup", Warning, None),
            Self::RapidThroughStock { .. } => ("W-START-IN-STOCK", "rapid-through-stock", Error, None),
            Self::DoglegThroughStock { .. } => {
                ("W-START-IN-STOCK", "dogleg-rapid-through-stock", Warning, None)
            }
            Self::RapidAlongStock { .. } => ("W-START-IN-STOCK", "rapid-along-stock", Warning, None),
            Self::IntoJaws { .. } => ("W-JAWS", "tool-into-jaws", Error, None),
            Self::IntoTailstock { .. } => ("W-TAILSTOCK", "tool-into-tailstock", Error, None),
            Self::HolderInStock { .. } => ("W-HOLDER", "holder-in-stock", Warning, None),
            Self::SlopeTooSteep { .. } => ("W-SLOPE", "slope-steeper-than-tool", Warning, None),
            Self::BelowCenter { .. } => ("W-BELOW-CENTER", "cut-beyond-centre", Warning, None),
            Self::OverTravel { .. } => ("W-TRAVEL", "over-travel", Error, Some("OT0500")),
        }
    }
}
