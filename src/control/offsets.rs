//! The tables a program can change: work zero points, and what G10 and macros write into the tool offsets.
//!
//! Plain values, part of [`super::modal::State`]. Lengths in mm, X as a radius.

use std::sync::Arc;

use crate::geometry::Point;

/// Frames of G54 to G59; those of G54.1 P1 and on come after them.
pub const STANDARD_FRAMES: u16 = 6;

/// Most frames of G54.1.
pub const EXTENDED_FRAMES: u16 = 300;

/// A few points by frame; a frame without one is at zero.
#[derive(Clone, Debug, Default, PartialEq)]
struct ByFrame(Vec<(u16, Point)>);

impl ByFrame {
    fn get(&self, frame: u16) -> Point {
        self.0.iter().find(|entry| entry.0 == frame).map_or(Point::default(), |entry| entry.1)
    }

    fn has(&self, frame: u16) -> bool {
        self.0.iter().any(|entry| entry.0 == frame)
    }

    fn entry(&mut self, frame: u16) -> &mut Point {
        let at = self.0.iter().position(|entry| entry.0 == frame).unwrap_or_else(|| {
            self.0.push((frame, Point::default()));
            self.0.len() - 1
        });
        &mut self.0[at].1
    }
}

/// Work zero points: where the machine stands is the place in the work frame plus all of these (§3.9).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Frames {
    /// Shift of all frames by G50 X Z.
    pub shift: Point,
    /// Shift of all frames in the offset table (G10 P0, #5201).
    pub external: Point,
    /// Zero of each frame (G10 L2 and L20, #5221 and on).
    work: ByFrame,
    /// Local shift by G52, in every frame.
    pub local: Point,
    /// The frame in force: 0 for G54 to 5 for G59, then those of G54.1.
    pub active: u16,
    /// The frame in which the first cut was made.
    cut_in: Option<u16>,
}

impl Frames {
    /// Takes in that something is cut in the frame in force.
    #[inline]
    pub fn cut(&mut self) {
        self.cut_in.get_or_insert(self.active);
    }

    /// Whether nobody has said where the zero of the frame in force is, while the first
    /// cut was made in another one.
    #[inline]
    pub fn is_elsewhere(&self) -> bool {
        self.cut_in.is_some_and(|first| first != self.active) && !self.work.has(self.active)
    }

    /// Machine place minus work place.
    pub fn offset(&self) -> Point {
        let (work, local) = (self.work.get(self.active), self.local);
        Point::new(
            self.shift.x + self.external.x + work.x + local.x,
            self.shift.z + self.external.z + work.z + local.z,
        )
    }

    /// Zero of a frame.
    pub fn work(&self, frame: u16) -> Point {
        self.work.get(frame)
    }

    /// Zero of a frame, to be changed.
    pub fn work_mut(&mut self, frame: u16) -> &mut Point {
        self.work.entry(frame)
    }
}

/// A column of the tool offset table.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Column {
    /// Wear of X.
    WearX,
    /// Wear of Z.
    WearZ,
    /// Wear of the nose radius.
    WearRadius,
    /// Geometry of X.
    X,
    /// Geometry of Z.
    Z,
    /// Nose radius.
    Radius,
    /// Tip direction.
    Tip,
}

/// What the program has written into the tool offset table; all else is as the setup says. In order of
/// number and column.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ToolOffsets(Arc<Vec<((u16, Column), f64)>>);

/// Most offset numbers of a control.
pub const OFFSETS: u16 = 999;

impl ToolOffsets {
    /// What was written, mm (X values as diameters, as tables have them).
    pub fn get(&self, offset: u16, column: Column) -> Option<f64> {
        self.find(offset, column).ok().map(|at| self.0[at].1)
    }

    /// Writes an entry; numbers past [`OFFSETS`] are ignored.
    pub fn set(&mut self, offset: u16, column: Column, value: f64) {
        if (1..=OFFSETS).contains(&offset) {
            let at = self.find(offset, column);
            let entries = Arc::make_mut(&mut self.0);
            match at {
                Ok(at) => entries[at].1 = value,
                Err(at) => entries.insert(at, ((offset, column), value)),
            }
        }
    }

    fn find(&self, offset: u16, column: Column) -> Result<usize, usize> {
        self.0.binary_search_by_key(&(offset, column), |entry| entry.0)
    }
}
