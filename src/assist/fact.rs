//! What an answer is made of: quantities, and facts with their places.
//!
//! Plain values. Lengths in mm, X as a radius where a field says nothing else; the sentences show them in the unit of the
//! reader.

use crate::control::codes::Group;
use crate::control::contour::Purpose;
use crate::source::Span;
use crate::units::Diameter;

/// A number with what it counts.
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
    /// Threads to the inch.
    ThreadsPerInch(f64),
    /// A spindle speed, rpm.
    Speed(f64),
    /// A cutting speed, m/min.
    CuttingSpeed(f64),
    /// An angle, degrees.
    Degrees(f64),
    /// A time, seconds.
    Seconds(f64),
    /// A number of things, or a number as it is.
    Count(f64),
    /// A sequence number: `N10`.
    Sequence(u32),
    /// The number of a program: `O0001`.
    Program(u32),
    /// A variable: `#100`.
    Variable(u32),
}

/// Something that is known of a word or of a block. Blocks are named by their first byte.
#[derive(Clone, Debug, PartialEq)]
pub enum Fact {
    /// The modal group of a code; 0: the code is not modal.
    Group(Group),
    /// What the word sets was in force before, since a block.
    Unchanged(Option<u32>),
    /// Before this block something else was in force: a code, since a block.
    CodeBefore(String, Option<u32>),
    /// Before this block the value was another one, since a block.
    ValueBefore(Quantity, Option<u32>),
    /// The block moves by a code that an earlier block has set.
    ByCode(String, Option<u32>),
    /// The cut is made at the feed that an earlier block has set.
    ByFeed(Quantity, Option<u32>),
    /// A way along an axis leads from one place to another.
    FromTo(Quantity, Quantity),
    /// A number without a decimal point counts this.
    WithoutPoint(Quantity),
    /// A feed per revolution at a speed is so much a minute.
    FeedAtSpeed(Quantity, Quantity),
    /// A cutting speed at a diameter is a speed.
    SpeedAt(Quantity, Quantity),
    /// That speed is held to a limit, set by a block.
    SpeedHeld(Quantity, Option<u32>),
    /// P of the first block of G76: finishing passes, thread pull-out in tenths of a lead, tool angle in degrees.
    ThreadPacked(u32, u32, u32),
    /// Turret station and number of the offset.
    StationAndOffset(u16, u16),
    /// The nose radius of the tool.
    NoseRadius(Quantity),
    /// The pass before, to the same end, had another taper: the first way of roughing a cone (seed 004).
    TaperBefore(Quantity),
    /// The taper of the pass before goes on while the end moves: the second way (seed 004).
    TaperKept(Quantity),
    /// The block makes so many passes.
    Passes(u32),
    /// The last of them is at this diameter.
    LastPass(Quantity),
    /// The contour from one block to another.
    Contour(Span, Span),
    /// The block of a number that a word names.
    Names(u32),
    /// The number that a word names is not there.
    NamesNothing,
    /// The value of a variable before the block; `None`: it is vacant.
    Variable(u32, Option<f64>),
    /// The block that gave a variable its value.
    VariableSet(u32, u32),
    /// The block gives a variable a value.
    VariableBecomes(u32, Option<f64>),
    /// The argument becomes a variable of the macro.
    Argument(u32),
    /// While it cuts a thread, feed override counts as 100 % and feed hold waits.
    ThreadLocked,
    /// The block is never carried out.
    NotCarriedOut,
    /// It is left out: a level of block skip is on.
    Skipped(u8),
    /// A cycle reads the block as a part of its contour.
    ReadBy(Purpose),
    /// Roughing reads the block as a part of its contour, and ignores the word.
    IgnoredByRoughing,
    /// Finishing takes the word.
    TakenByFinishing,
    /// This is one of the times the block is carried out.
    Time(u32, u32),
}
