//! What can be found wrong at the machine.
//!
//! In and out: values alone. Must not know how it is found, or its message.

use crate::geometry::Point;
use crate::setup::ToolKind;

/// A place where something is wrong.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Finding {
    /// The motion.
    pub motion: usize,
    /// Where, mm: radius and length.
    pub at: Point,
    /// What.
    pub danger: Danger,
}

/// What can be wrong at the machine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Danger {
    /// A rapid goes through the work.
    RapidThroughStock,
    /// A rapid goes through the work where each axis moves at its own rate until it is there.
    DoglegThroughStock,
    /// A rapid goes along the outside of the blank.
    RapidAlongStock,
    /// A rapid out of a bore goes through its wall.
    LeavesBore,
    /// A cycle comes back at rapid to a start within the material.
    CycleStart,
    /// A facing cycle starts on the chuck side of the face: what stands in front of it is cut at once.
    BehindFace {
        /// Z of the face of the blank, mm.
        face: f64,
    },
    /// The tool meets the jaws.
    IntoJaws,
    /// The tool meets the tailstock.
    IntoTailstock,
    /// The holder meets the work.
    HolderInStock,
    /// The slope falls more steeply than the trailing edge behind the tip: it cuts too. Degrees.
    SlopeTooSteep {
        /// The slope.
        slope: f64,
        /// What the tool can follow.
        tool: f64,
    },
    /// The tip cuts beyond the spindle axis.
    BelowCenter,
    /// The tip leaves the travel of an axis.
    OverTravel {
        /// The axis.
        axis: Axis,
        /// The end of its travel as a program writes it, mm.
        limit: f64,
    },
    /// The setup names tools, but not this one.
    ToolNotListed {
        /// Its station.
        station: u16,
    },
    /// The tool of the setup is of a kind that does not do this.
    OtherWork {
        /// The tool.
        kind: ToolKind,
        /// Its station.
        station: u16,
    },
    /// A cut with more feed than an insert takes.
    FastFeed {
        /// The feed, mm/rev.
        per_turn: f64,
    },
}

impl Danger {
    /// Whether there is a place of the picture to mark.
    pub fn has_place(&self) -> bool {
        !matches!(self, Self::ToolNotListed { .. } | Self::OtherWork { .. })
    }
}

/// An axis of the machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// Across the spindle axis.
    X,
    /// Along it.
    Z,
}
