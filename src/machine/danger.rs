//! The dangers that can be found at the machine.
//!
//! Values only. Must not know how they are found, or their messages.

use crate::geometry::Point;
use crate::setup::ToolKind;

/// A danger and its place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Finding {
    /// Index of the motion.
    pub motion: usize,
    /// Place, mm: radius and Z.
    pub at: Point,
    /// The danger.
    pub danger: Danger,
}

/// A danger at the machine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Danger {
    /// A rapid goes through the workpiece.
    RapidThroughStock,
    /// A rapid goes through the workpiece if each axis moves at its own rapid rate (dogleg).
    DoglegThroughStock,
    /// A rapid goes along the outside of the blank.
    RapidAlongStock,
    /// A rapid out of a bore goes through its wall.
    LeavesBore,
    /// The passes of a cycle return at rapid to a start point within the material.
    CycleStart,
    /// A facing cycle starts on the chuck side of the face, so the first pass takes off all material in front
    /// of it.
    BehindFace {
        /// Z of the face of the blank, mm.
        face: f64,
    },
    /// The tool hits the jaws.
    IntoJaws,
    /// The tool hits the tailstock.
    IntoTailstock,
    /// The holder hits the workpiece.
    HolderInStock,
    /// The slope is steeper than the trailing edge of the insert, so that edge cuts too. Degrees.
    SlopeTooSteep {
        /// Angle of the slope.
        slope: f64,
        /// Steepest angle that the tool can follow.
        tool: f64,
    },
    /// The tip cuts beyond the spindle axis.
    BelowCenter,
    /// The tip leaves the travel of an axis.
    OverTravel {
        /// The axis.
        axis: Axis,
        /// End of its travel as written in a program, mm.
        limit: f64,
    },
    /// The setup names tools, but not this one.
    ToolNotListed {
        /// Station of the tool.
        station: u16,
    },
    /// The tool of the setup is of a kind that is not made for this cut.
    OtherWork {
        /// Kind of the tool.
        kind: ToolKind,
        /// Station of the tool.
        station: u16,
    },
    /// A boring bar of the setup turns the outside, or an outside turning tool bores.
    WrongSide {
        /// Kind of the tool.
        kind: ToolKind,
        /// Station of the tool.
        station: u16,
    },
    /// The feed of a cut is higher than an insert takes.
    FastFeed {
        /// The feed, mm/rev.
        per_turn: f64,
    },
}

impl Danger {
    /// Whether it has a place that the picture can mark.
    pub fn has_place(&self) -> bool {
        !matches!(self, Self::ToolNotListed { .. } | Self::OtherWork { .. } | Self::WrongSide { .. })
    }
}

/// An axis of the machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// Across the spindle axis.
    X,
    /// Along the spindle axis.
    Z,
}
