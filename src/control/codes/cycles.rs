//! The turning cycles: the code of each, its blocks, and the words of each block with their roles.
//!
//! This is the only list of these words. The registry of codes, the check for two cycle blocks in one, the help,
//! the snippets and the evidence for the decimal rule read it. The geometry of a cycle is in `crate::cycles`, its
//! execution in `interpreter`, its sentences in `src/sentences`.

use super::function::Function;
use super::role::Role;
use super::words::{Amount, CodeWord, FEED, START_ANGLE, Sample, word};
use crate::control::words::letters;
use crate::cycles::single::Single;
use crate::motion::Cycle;

/// Which block of a multiple cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CycleBlock {
    /// The first block, with the amounts.
    First,
    /// The second block, which cuts.
    Second,
    /// One block with everything, as on older controls.
    Whole,
}

/// A multiple cycle.
#[derive(Debug)]
pub struct CycleSpec {
    /// Its name in motions.
    pub cycle: Cycle,
    /// Its row in the table of codes.
    pub function: Function,
    /// Ten times its number in G-code systems A and B and on GSK; C has a number that is two higher.
    pub key: u16,
    /// Letters of which the block that cuts has at least one, as the bits of [`letters`]; 0 if every block cuts.
    pub cuts_with: u32,
    /// Letters that only the one-block form has.
    pub whole_with: u32,
    /// Whether it reads the contour that P and Q name.
    pub reads_contour: bool,
    /// The words of the first block.
    pub first: &'static [CodeWord],
    /// The words of the second block.
    pub second: &'static [CodeWord],
    /// The words of the one-block form.
    pub whole: &'static [CodeWord],
}

impl CycleSpec {
    /// Which block has these letters, the bits of [`letters`].
    pub fn block(&self, given: u32) -> CycleBlock {
        match (self.cuts_with == 0 || given & self.cuts_with != 0, given & self.whole_with != 0) {
            (false, _) => CycleBlock::First,
            (true, false) => CycleBlock::Second,
            (true, true) => CycleBlock::Whole,
        }
    }

    /// The words of a block.
    pub fn words(&self, block: CycleBlock) -> &'static [CodeWord] {
        match block {
            CycleBlock::First => self.first,
            CycleBlock::Second => self.second,
            CycleBlock::Whole => self.whole,
        }
    }

    /// What the size of the word with a letter shows, if it is no coordinate.
    pub fn amount(&self, block: CycleBlock, letter: u8) -> Option<Amount> {
        self.words(block).iter().find(|word| word.letters.contains(&letter))?.amount
    }

    /// Letters of the amounts of the first block, as the bits of [`letters`].
    pub fn first_letters(&self) -> u32 {
        let amounts = self.first.iter().filter(|word| word.otherwise.is_some() || word.amount.is_some());
        amounts.fold(0, |all, word| all | letters(word.letters))
    }
}

/// F in the signature of a block.
const SHOWN_FEED: CodeWord = FEED.as_set();
const LEAD: CodeWord = word(b"F", &[Role::Lead]).must();
const CONTOUR_FIRST: CodeWord = word(b"P", &[Role::ContourFirst]).must().sample(Sample::First);
const CONTOUR_LAST: CodeWord = word(b"Q", &[Role::ContourLast]).must().sample(Sample::Last);
const ALLOWANCE_X: CodeWord =
    word(b"U", &[Role::AllowanceX]).zero().amount(Amount::Cut).sample(Sample::Length(0.4));
const ALLOWANCE_Z: CodeWord =
    word(b"W", &[Role::AllowanceZ]).zero().amount(Amount::Cut).sample(Sample::Length(0.1));
const FINISH_AFTER: CodeWord = word(b"J", &[Role::FinishAfter]);
const SPEED: CodeWord = word(b"S", &[Role::SpindleSpeed]).as_set();
const TOOL: CodeWord = word(b"T", &[Role::ToolAndOffset]).as_set();

const CONTOUR_WITH: u32 = letters(b"PQ");
const PLACE_WITH: u32 = letters(b"XZUW");

/// G70.
pub const FINISHING: CycleSpec = CycleSpec {
    cycle: Cycle::Finishing,
    function: Function::Finishing,
    key: 700,
    cuts_with: 0,
    whole_with: 0,
    reads_contour: true,
    first: &[],
    second: &[CONTOUR_FIRST, CONTOUR_LAST, FEED],
    whole: &[],
};

/// G71.
pub const ROUGH_TURNING: CycleSpec = CycleSpec {
    cycle: Cycle::RoughTurning,
    function: Function::RoughTurning,
    key: 710,
    cuts_with: CONTOUR_WITH,
    whole_with: letters(b"D"),
    reads_contour: true,
    first: &[
        word(b"U", &[Role::PassDepth]).as_set().amount(Amount::Cut).sample(Sample::Length(2.0)),
        word(b"R", &[Role::Escape]).as_set().amount(Amount::Cut).sample(Sample::Length(1.0)),
        // Written in place of U.
        word(b"W", &[Role::Ignored]).amount(Amount::Cut),
        FEED,
    ],
    second: ROUGHING,
    whole: &[
        CONTOUR_FIRST,
        CONTOUR_LAST,
        ALLOWANCE_X,
        ALLOWANCE_Z,
        word(b"D", &[Role::PassDepth]).must(),
        SHOWN_FEED,
        FINISH_AFTER,
    ],
};

/// G72.
pub const ROUGH_FACING: CycleSpec = CycleSpec {
    cycle: Cycle::RoughFacing,
    function: Function::RoughFacing,
    key: 720,
    first: &[
        word(b"W", &[Role::PassDepthZ]).as_set().amount(Amount::Cut).sample(Sample::Length(2.0)),
        word(b"R", &[Role::Escape]).as_set().amount(Amount::Cut).sample(Sample::Length(1.0)),
        // Written in place of W.
        word(b"U", &[Role::Ignored]).amount(Amount::Cut),
        FEED,
    ],
    whole: &[
        CONTOUR_FIRST,
        CONTOUR_LAST,
        ALLOWANCE_X,
        ALLOWANCE_Z,
        word(b"D", &[Role::PassDepthZ]).must(),
        SHOWN_FEED,
        FINISH_AFTER,
    ],
    ..ROUGH_TURNING
};

/// The second block of G71 to G73.
const ROUGHING: &[CodeWord] = &[
    CONTOUR_FIRST,
    CONTOUR_LAST,
    ALLOWANCE_X,
    ALLOWANCE_Z,
    SHOWN_FEED.sample(Sample::Feed(0.25)),
    SPEED,
    TOOL,
    FINISH_AFTER,
];

/// G73.
pub const PATTERN: CycleSpec = CycleSpec {
    cycle: Cycle::Pattern,
    function: Function::Pattern,
    key: 730,
    first: &[
        word(b"U", &[Role::ReliefX]).as_set().amount(Amount::Relief).sample(Sample::Length(4.0)),
        word(b"W", &[Role::ReliefZ]).as_set().amount(Amount::Relief).sample(Sample::Length(2.0)),
        word(b"R", &[Role::PatternPasses]).as_set().sample(Sample::Digits("3")),
        FEED,
    ],
    second: &[
        CONTOUR_FIRST,
        CONTOUR_LAST,
        ALLOWANCE_X,
        ALLOWANCE_Z,
        SHOWN_FEED.sample(Sample::Feed(0.25)),
        SPEED,
        TOOL,
    ],
    whole: &[
        CONTOUR_FIRST,
        CONTOUR_LAST,
        ALLOWANCE_X,
        ALLOWANCE_Z,
        word(b"I", &[Role::ReliefX]).zero(),
        word(b"K", &[Role::ReliefZ]).zero(),
        word(b"D", &[Role::PatternPasses]).must(),
        SHOWN_FEED,
    ],
    ..ROUGH_TURNING
};

const PECK_END_X: CodeWord = word(b"XU", &[Role::PeckEndX, Role::PeckWayX]).stays();
const PECK_END_Z: CodeWord = word(b"ZW", &[Role::PeckEndZ, Role::PeckWayZ]).stays();
const BOTTOM_RELIEF: &[Role] = &[Role::BottomRelief];
const PECK: &[Role] = &[Role::Peck];
const STEP_OVER: &[Role] = &[Role::StepOver];
const PECK_RETRACT: CodeWord =
    word(b"R", &[Role::PeckRetract]).as_set().amount(Amount::Cut).sample(Sample::Length(0.5));

/// G74.
pub const FACE_PECKING: CycleSpec = CycleSpec {
    cycle: Cycle::FacePecking,
    function: Function::FacePecking,
    key: 740,
    cuts_with: PLACE_WITH,
    whole_with: letters(b"IK"),
    reads_contour: false,
    first: &[
        PECK_RETRACT,
        word(b"QK", &[Role::Peck, Role::Peck]),
        word(b"PI", &[Role::StepOver, Role::StepOver]),
        word(b"D", BOTTOM_RELIEF),
        FEED,
    ],
    second: &[
        PECK_END_X,
        PECK_END_Z.sample(Sample::Along(2.0 / 3.0)),
        word(b"P", STEP_OVER).zero(),
        word(b"Q", PECK).must().sample(Sample::Depth(5.0)),
        word(b"R", BOTTOM_RELIEF).zero(),
        SHOWN_FEED.sample(Sample::Feed(0.1)),
        word(b"D", BOTTOM_RELIEF),
    ],
    whole: &[
        PECK_END_X,
        PECK_END_Z,
        word(b"I", STEP_OVER).zero(),
        word(b"K", PECK).must(),
        word(b"D", BOTTOM_RELIEF).zero(),
        SHOWN_FEED,
        word(b"P", STEP_OVER),
        word(b"Q", PECK),
        word(b"R", BOTTOM_RELIEF),
    ],
};

/// G75.
pub const GROOVING: CycleSpec = CycleSpec {
    cycle: Cycle::Grooving,
    function: Function::Grooving,
    key: 750,
    first: &[
        PECK_RETRACT,
        word(b"PI", &[Role::Peck, Role::Peck]),
        word(b"QK", &[Role::StepOver, Role::StepOver]),
        word(b"D", BOTTOM_RELIEF),
        FEED,
    ],
    second: &[
        PECK_END_X.sample(Sample::Inward(10.0)),
        PECK_END_Z.sample(Sample::Along(2.0 / 3.0)),
        word(b"P", PECK).must().sample(Sample::Depth(2.0)),
        word(b"Q", STEP_OVER).zero().sample(Sample::Depth(2.0)),
        word(b"R", BOTTOM_RELIEF).zero(),
        SHOWN_FEED.sample(Sample::Feed(0.1)),
        word(b"D", BOTTOM_RELIEF),
    ],
    whole: &[
        PECK_END_X,
        PECK_END_Z,
        word(b"I", PECK).must(),
        word(b"K", STEP_OVER).zero(),
        word(b"D", BOTTOM_RELIEF).zero(),
        SHOWN_FEED,
        word(b"P", PECK),
        word(b"Q", STEP_OVER),
        word(b"R", BOTTOM_RELIEF),
    ],
    ..FACE_PECKING
};

const THREAD_END_X: CodeWord = word(b"XU", &[Role::ThreadEndX, Role::ThreadWayX]).must();
const THREAD_END_Z: CodeWord = word(b"ZW", &[Role::ThreadEndZ, Role::ThreadWayZ]).stays();
const THREAD_HEIGHT: &[Role] = &[Role::ThreadHeight];
const FIRST_DEPTH: &[Role] = &[Role::FirstDepth];
const THREAD_TAPER: &[Role] = &[Role::ThreadTaper];
const THREAD_ANGLE: &[Role] = &[Role::ThreadAngle];
const STARTS: CodeWord = word(b"L", &[Role::Starts]);

/// G76.
pub const THREADING: CycleSpec = CycleSpec {
    cycle: Cycle::MultiThreading,
    function: Function::MultiThreading,
    key: 760,
    cuts_with: PLACE_WITH,
    whole_with: letters(b"K"),
    reads_contour: false,
    first: &[
        word(b"P", &[Role::ThreadPacked]).as_set().sample(Sample::ThreadPacked),
        word(b"Q", &[Role::LeastDepth]).as_set().sample(Sample::Depth(0.1)),
        word(b"R", &[Role::ThreadAllowance])
            .as_set()
            .amount(Amount::ThreadAllowance)
            .sample(Sample::Length(0.05)),
        word(b"F", &[Role::Lead]),
        word(b"K", THREAD_HEIGHT),
        word(b"D", FIRST_DEPTH),
        word(b"A", THREAD_ANGLE),
        STARTS,
    ],
    second: &[
        THREAD_END_X.sample(Sample::ThreadRoot),
        THREAD_END_Z.sample(Sample::Along(2.0 / 3.0)),
        word(b"R", THREAD_TAPER).zero(),
        word(b"P", THREAD_HEIGHT).must().sample(Sample::ThreadHeight),
        word(b"Q", FIRST_DEPTH).must().sample(Sample::ThreadFirst),
        LEAD.sample(Sample::Lead),
        word(b"I", THREAD_TAPER),
        word(b"D", FIRST_DEPTH),
        word(b"A", THREAD_ANGLE),
        STARTS,
    ],
    whole: &[
        THREAD_END_X,
        THREAD_END_Z,
        word(b"I", THREAD_TAPER).zero(),
        word(b"K", THREAD_HEIGHT).must(),
        word(b"D", FIRST_DEPTH).must(),
        LEAD,
        word(b"A", THREAD_ANGLE).zero(),
        word(b"P", &[Role::InfeedMethod]).may(),
        word(b"R", THREAD_TAPER),
        START_ANGLE,
        STARTS,
    ],
};

/// A single cycle.
#[derive(Debug)]
pub struct SingleSpec {
    /// Its row in the table of codes.
    pub function: Function,
    /// Ten times its number in systems A, B and C and on GSK.
    pub keys: [u16; 4],
    /// Its words on FANUC.
    pub words: &'static [CodeWord],
    /// Its words on GSK.
    pub on_gsk: &'static [CodeWord],
}

impl Single {
    /// Its code and words.
    pub const fn spec(self) -> &'static SingleSpec {
        match self {
            Self::Turning => &SINGLE_TURNING,
            Self::Threading => &SINGLE_THREADING,
            Self::Facing => &SINGLE_FACING,
        }
    }
}

const CYCLE_END_X: CodeWord = word(b"XU", &[Role::CycleEndX, Role::CycleWayX]).as_set();
const CYCLE_END_Z: CodeWord = word(b"ZW", &[Role::CycleEndZ, Role::CycleWayZ]).as_set();

const TURNING_WORDS: &[CodeWord] = &[
    CYCLE_END_X.sample(Sample::Smaller(2.0)),
    CYCLE_END_Z.sample(Sample::Along(2.0 / 3.0)),
    word(b"R", &[Role::TaperX]).zero(),
    SHOWN_FEED.sample(Sample::Feed(0.2)),
    word(b"I", &[Role::TaperX]),
];

/// G90.
const SINGLE_TURNING: SingleSpec = SingleSpec {
    function: Function::TurningCycle,
    keys: [900, 770, 200, 900],
    words: TURNING_WORDS,
    on_gsk: TURNING_WORDS,
};

const FACING_WORDS: &[CodeWord] = &[
    CYCLE_END_X.sample(Sample::Inward(20.0)),
    CYCLE_END_Z.sample(Sample::Behind(1.0)),
    word(b"R", &[Role::TaperZ]).zero(),
    SHOWN_FEED.sample(Sample::Feed(0.2)),
    word(b"K", &[Role::TaperZ]),
];

/// G94.
const SINGLE_FACING: SingleSpec = SingleSpec {
    function: Function::FacingCycle,
    keys: [940, 790, 240, 940],
    words: FACING_WORDS,
    on_gsk: FACING_WORDS,
};

const SINGLE_LEAD: CodeWord = word(b"F", &[Role::Lead]).as_set().sample(Sample::Lead);
const SINGLE_THREAD_X: CodeWord = CYCLE_END_X.sample(Sample::Smaller(0.5));
const SINGLE_THREAD_Z: CodeWord = CYCLE_END_Z.sample(Sample::Along(2.0 / 3.0));
const SINGLE_TAPER: CodeWord = word(b"R", &[Role::TaperX]).zero();
const PULL_OUT_ACROSS: CodeWord = word(b"J", &[Role::PullOutAcross]);
const PULL_OUT_ALONG: CodeWord = word(b"K", &[Role::PullOutAlong]);
/// Words of G92 for leads in other units.
const OTHER_LEADS: CodeWord = word(b"EI", &[Role::Lead, Role::ThreadsPerInch]);

/// G92.
const SINGLE_THREADING: SingleSpec = SingleSpec {
    function: Function::ThreadingCycle,
    keys: [920, 780, 210, 920],
    words: &[
        SINGLE_THREAD_X,
        SINGLE_THREAD_Z,
        SINGLE_TAPER,
        SINGLE_LEAD,
        START_ANGLE.zero(),
        OTHER_LEADS,
        PULL_OUT_ACROSS,
        PULL_OUT_ALONG,
        STARTS,
    ],
    on_gsk: &[
        SINGLE_THREAD_X,
        SINGLE_THREAD_Z,
        SINGLE_TAPER,
        SINGLE_LEAD,
        PULL_OUT_ACROSS.may(),
        PULL_OUT_ALONG.may(),
        STARTS.may(),
        OTHER_LEADS,
        START_ANGLE,
    ],
};
