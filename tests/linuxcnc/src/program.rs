//! A program in the language that lathe controls and LinuxCNC share, independent of either syntax.
//!
//! Numbers are counts of the least increment of the active unit: 0.001 mm, 0.0001 inch. X is a diameter, as
//! written; I and R are radius values. Any list of blocks is a valid program, so blocks can be deleted one by
//! one.

use gcode_playground::control::compensation::Side;
use gcode_playground::geometry::Turn;
use gcode_playground::units::Unit;

/// A count of least increments.
pub type Count = i64;

/// One program.
#[derive(Clone, Debug, PartialEq)]
pub struct Program {
    /// Tool position at the start: diameter and Z, 0.001 mm.
    pub start: (Count, Count),
    /// Nose radius of every tool, 0.001 mm.
    pub nose: Count,
    /// Its blocks.
    pub blocks: Vec<Block>,
}

/// How one axis is programmed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// Not at all.
    Stay,
    /// X, Z.
    To(Count),
    /// U, W.
    By(Count),
}

/// Whether the code of group 01 is written although it is modal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Code {
    /// It is written.
    Written,
    /// It is omitted.
    Modal,
}

/// Whether a code is in a separate block or in the block of the next move, if that move is straight.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Joined {
    /// A separate block.
    Alone,
    /// With the next move; LinuxCNC always gets a separate block.
    WithMove,
}

/// Kind of a straight move.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Straight {
    /// G00.
    Rapid,
    /// G01.
    Feed,
    /// G32; G33 in LinuxCNC.
    Thread,
}

/// The words that give the centre of an arc.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Center {
    /// R.
    pub r: Option<Count>,
    /// I.
    pub i: Option<Count>,
    /// K.
    pub k: Option<Count>,
}

/// The unit of F.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FeedMode {
    /// G98; G94 in LinuxCNC.
    PerMinute,
    /// G99; G95 in LinuxCNC.
    PerTurn,
}

/// The word that gives the time of a dwell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DwellWord {
    /// Seconds.
    X,
    /// Seconds.
    U,
    /// Milliseconds.
    P,
}

/// One block.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Block {
    /// G20, G21.
    Unit(Unit),
    /// G98, G99.
    Feed { mode: FeedMode, feed: Option<Count> },
    /// G00, G01, G32.
    Straight { kind: Straight, x: Axis, z: Axis, feed: Option<Count>, code: Code },
    /// G02, G03.
    Arc { turn: Turn, x: Axis, z: Axis, center: Center, feed: Option<Count>, code: Code },
    /// G04.
    Dwell { milliseconds: Count, word: DwellWord },
    /// G28: via an intermediate point to the reference point, in the programmed axes.
    Home { x: Axis, z: Axis },
    /// G50 X Z or U W: sets the coordinates of the current position. G92 in LinuxCNC.
    Preset { x: Axis, z: Axis },
    /// G52: shifts all frames. For LinuxCNC the shift is added to each frame by G10 L2, because its G52 is a
    /// variant of G92.
    Local { x: Option<Count>, z: Option<Count> },
    /// G54 to G59, counted from 0.
    Frame(usize),
    /// G10 L2: the origin of a frame; frames are counted from 0.
    Origin { frame: usize, x: Count, z: Count },
    /// G41, G42 with a tool of this tip.
    Nose { side: Side, tip: u8, joined: Joined },
    /// G40.
    NoseOff { joined: Joined },
}

impl Block {
    /// Whether it moves the tool along a programmed path.
    pub fn moves(&self) -> bool {
        matches!(self, Self::Straight { .. } | Self::Arc { .. })
    }
}

/// Compensation state of a block.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Place {
    /// Compensation is off.
    Plain,
    /// Compensation is on: side and tip.
    Compensated(Side, u8),
}

impl Program {
    /// Compensation state of each block.
    pub fn places(&self) -> Vec<Place> {
        let mut place = Place::Plain;
        let step = |block: &Block| {
            match *block {
                Block::Nose { side, tip, .. } => place = Place::Compensated(side, tip),
                Block::NoseOff { .. } => place = Place::Plain,
                _ => {}
            }
            place
        };
        self.blocks.iter().map(step).collect()
    }
}

/// Decimals of the least increment.
pub fn places_of(unit: Unit) -> usize {
    match unit {
        Unit::Millimetre => 3,
        Unit::Inch => 4,
    }
}

/// A count with a decimal point and without trailing zeros.
pub fn written(count: Count, places: usize) -> String {
    let scale = 10i64.pow(places as u32);
    let sign = if count < 0 { "-" } else { "" };
    let text = format!("{sign}{}.{:0places$}", count.abs() / scale, count.abs() % scale);
    text.trim_end_matches('0').to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_are_written_with_a_point() {
        assert_eq!(written(1500, 3), "1.5");
        assert_eq!(written(-20_000, 3), "-20.");
        assert_eq!(written(-7, 4), "-0.0007");
        assert_eq!(written(0, 3), "0.");
    }
}
