//! Building blocks of answers: quantities, and facts with positions in the text.
//!
//! Plain values. Lengths are in mm, X is a radius unless stated otherwise; the sentences convert to the unit
//! of the user.

use crate::control::codes::Group;
use crate::control::contour::ContourUse;
use crate::source::Span;
use crate::units::Diameter;

/// A number with its unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Quantity {
    /// A length, mm.
    Length(f64),
    /// A diameter.
    Diameter(Diameter),
    /// A feed, mm/min.
    FeedPerMinute(f64),
    /// A feed or lead, mm/rev.
    FeedPerTurn(f64),
    /// Threads per inch.
    ThreadsPerInch(f64),
    /// A spindle speed, rpm.
    Speed(f64),
    /// A cutting speed, m/min.
    CuttingSpeed(f64),
    /// An angle, degrees.
    Degrees(f64),
    /// A time, seconds.
    Seconds(f64),
    /// A number without a unit.
    Count(f64),
    /// A sequence number: `N10`.
    Sequence(u32),
    /// The number of a program: `O0001`.
    Program(u32),
    /// A variable: `#100`.
    Variable(u32),
}

/// Why a block moves nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoMotion {
    /// It names no axis.
    WithoutAxis,
    /// It leads to the position of the tool.
    SamePlace,
    /// Its code does not move the tool: G50, G10.
    ByCode,
}

/// A known fact about a word or a block. Blocks are identified by their first byte.
#[derive(Clone, Debug, PartialEq)]
pub enum Fact {
    /// The modal group of a code; 0 if it is not modal.
    Group(Group),
    /// The word repeats a value that was in force already, and the block that set it.
    Unchanged(Option<u32>),
    /// The code that was in force before this block, and the block that set it.
    CodeBefore(String, Option<u32>),
    /// The value that was in force before this block, and the block that set it.
    ValueBefore(Quantity, Option<u32>),
    /// The modal code that moves the block, and the block that set it.
    ByCode(String, Option<u32>),
    /// The feed of the cut, and the block that set it.
    ByFeed(Quantity, Option<u32>),
    /// F of the contour gives the feed of the cut; the first block of the contour with F.
    ByFeedOfContour(u32),
    /// Start and end of an incremental coordinate.
    FromTo(Quantity, Quantity),
    /// The distance from the centre line that a diameter means.
    FromCentre(Quantity),
    /// Start and end of a taper's cut, diameters or lengths along Z, and its angle with the Z axis.
    TaperFromTo(Quantity, Quantity, Quantity),
    /// Start of that cut if R had the other sign.
    TaperOtherSign(Quantity),
    /// Meaning of a number without a decimal point.
    WithoutPoint(Quantity),
    /// The feed per minute that a feed per revolution gives, and the spindle speed.
    FeedAtSpeed(Quantity, Quantity),
    /// The spindle speed that a cutting speed gives, and the diameter.
    SpeedAt(Quantity, Quantity),
    /// The limit of that speed, and the block that set it.
    SpeedHeld(Quantity, Option<u32>),
    /// P of the first block of G76: finishing passes, pull-out in tenths of a lead, tool angle in degrees.
    ThreadPacked(u32, u32, u32),
    /// Turret station and offset number.
    StationAndOffset(u16, u16),
    /// Nose radius of the tool.
    NoseRadius(Quantity),
    /// Distance by which the offset moves the tip, X as a diameter: wear, and changes by the program.
    TipShift(Quantity, Quantity),
    /// The previous pass had the same end and another taper: the first way of roughing a cone (seed 004).
    TaperBefore(Quantity),
    /// The taper of the previous pass stays while the end moves: the second way (seed 004).
    TaperKept(Quantity),
    /// Number of passes in the block.
    Passes(u32),
    /// Diameter of the last pass.
    LastPass(Quantity),
    /// First and last block of the contour.
    Contour(Span, Span),
    /// The block that a word refers to.
    Names(u32),
    /// The word refers to a number that does not exist.
    NamesNothing,
    /// Value of a variable before the block; `None` if it is vacant.
    Variable(u32, Option<f64>),
    /// A variable, and the block that set it.
    VariableSet(u32, u32),
    /// A variable, and its value after the block.
    VariableBecomes(u32, Option<f64>),
    /// The macro variable that receives the argument.
    Argument(u32),
    /// During the thread cut, the feed override counts as 100 % and feed hold is delayed.
    ThreadLocked,
    /// The block moves nothing.
    NoMotion(NoMotion),
    /// The block is never executed.
    NotCarriedOut,
    /// The block is skipped: this level of block skip is on.
    Skipped(u8),
    /// A cycle reads the block as a part of its contour.
    ReadBy(ContourUse),
    /// A roughing cycle and finishing read the block as a part of their contour.
    ReadByBoth,
    /// Roughing reads the block as a part of its contour, and ignores the word.
    IgnoredByRoughing,
    /// Finishing uses the word.
    TakenByFinishing,
    /// Which execution of the block this is, and how often the block is executed.
    Time(u32, u32),
}
