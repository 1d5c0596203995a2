//! The tables that a program can change: work zero points, and the tool offsets that G10 and macros write.
//!
//! Plain values, part of [`super::modal::State`]. Lengths in mm, X as a radius.

use std::sync::Arc;

use crate::geometry::{Point, SAME};
use crate::motion::LeftFrame;
use crate::setup::tool::LARGEST_WEAR;

/// Number of frames of G54 to G59; the frames of G54.1 P1 and up follow them.
pub const STANDARD_FRAMES: u16 = 6;

/// Number of frames of G54.1.
pub const EXTENDED_FRAMES: u16 = 300;

/// The zero of a frame.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Zero {
    at: Point,
    /// Whether the program sets the zero, rather than only shifting it.
    is_given: bool,
}

/// Zeros by frame; a frame without an entry is at 0.
#[derive(Clone, Debug, Default, PartialEq)]
struct ByFrame(Vec<(u16, Zero)>);

impl ByFrame {
    fn get(&self, frame: u16) -> Zero {
        self.0.iter().find(|entry| entry.0 == frame).map_or(Zero::default(), |entry| entry.1)
    }

    fn entry(&mut self, frame: u16) -> &mut Zero {
        let at = self.0.iter().position(|entry| entry.0 == frame).unwrap_or_else(|| {
            self.0.push((frame, Zero::default()));
            self.0.len() - 1
        });
        &mut self.0[at].1
    }
}

/// Work zero points: machine position = position in the work frame + all of these (§3.9).
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
    /// The frame in force: 0 for G54 to 5 for G59, then the frames of G54.1.
    pub active: u16,
    /// The frame of the workpiece; `None` before the first cut.
    workpiece: Option<Workpiece>,
    /// Zero of the frame in force, in coordinates of the workpiece, if it is known.
    on_workpiece: Point,
    /// Which end of the workpiece is machined.
    side: Side,
}

/// Which end of the workpiece is machined, judged by stops and comments.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Side {
    /// The first end.
    #[default]
    First,
    /// The first end; since the last cut a comment says that the part is turned round.
    Announced,
    /// The first end; the program has stopped since the last cut.
    Stopped,
    /// The other end, whose zero is unknown.
    Other,
}

/// The frame of the workpiece: the frame of the first cut, as it was at that time.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Workpiece {
    /// 0 for G54, as [`Frames::active`].
    frame: u16,
    /// Its zero, in machine coordinates.
    zero: Point,
}

impl Frames {
    /// Records a cut in the frame in force. Returns true for the first cut.
    #[inline]
    pub fn cut(&mut self) -> bool {
        let is_first = self.workpiece.is_none();
        if matches!(self.side, Side::Announced | Side::Stopped) {
            self.side = Side::First;
        }
        if is_first {
            self.workpiece = Some(Workpiece { frame: self.active, zero: self.offset() });
        }
        is_first
    }

    /// The frame in force, if nothing has been cut yet.
    pub fn before_first_cut(&self) -> Option<LeftFrame> {
        let own = LeftFrame { frame: self.active, offset: self.offset() };
        self.workpiece.is_none().then_some(own)
    }

    /// Records a comment that says that the part is turned round. Returns true if the program has already
    /// stopped for it: from here on the other end is machined.
    pub fn announce_other_end(&mut self) -> bool {
        self.record_turn_sign(Side::Stopped, Side::Announced)
    }

    /// Records a stop (M00, M01). Returns true if the other end is machined from here on.
    pub fn stop(&mut self) -> bool {
        self.record_turn_sign(Side::Announced, Side::Stopped)
    }

    /// Records one of the two signs that the part is turned round, in either order. `own` is the state after
    /// this sign, `other` the state after the other sign. Returns true if this is the second sign.
    fn record_turn_sign(&mut self, other: Side, own: Side) -> bool {
        let turns = self.side == other;
        self.side = if turns || self.side == Side::Other { Side::Other } else { own };
        turns
    }

    /// Whether anything has been cut.
    pub fn has_cut(&self) -> bool {
        self.workpiece.is_some()
    }

    /// Whether the position on the workpiece is unknown: the other end is machined, or the first cut was made
    /// in another frame and the program does not give the zeros of both frames.
    #[inline]
    pub fn has_unknown_workpiece_position(&self) -> bool {
        self.side == Side::Other
            || self.workpiece.is_some_and(|workpiece| !self.is_known(self.active, workpiece))
    }

    /// Whether the program defines the position of a frame on the workpiece.
    fn is_known(&self, frame: u16, workpiece: Workpiece) -> bool {
        let is_given = |frame: u16| self.work.get(frame).is_given;
        frame == workpiece.frame || is_given(workpiece.frame) && is_given(frame)
    }

    /// Zero of a frame that was left before the first cut, in coordinates of the workpiece, if it is known.
    pub fn place(&self, LeftFrame { frame, offset }: LeftFrame) -> Option<Point> {
        let workpiece = self.workpiece.filter(|&workpiece| self.is_known(frame, workpiece))?;
        Some(distance(workpiece.zero, offset))
    }

    /// Whether this is the frame of the workpiece, and the program has not given its zero.
    pub fn is_workpiece_not_given(&self, frame: u16) -> bool {
        self.workpiece.is_some_and(|workpiece| workpiece.frame == frame) && !self.work.get(frame).is_given
    }

    /// Zero of the frame in force, in coordinates of the workpiece: added to a programmed position it gives
    /// the position on the workpiece. Zero before the first cut, and if it is unknown.
    #[inline]
    pub fn on_workpiece(&self) -> Point {
        self.on_workpiece
    }

    /// Updates [`Frames::on_workpiece`] after a change.
    pub fn update_workpiece_zero(&mut self) {
        let known = self.workpiece.filter(|_| !self.has_unknown_workpiece_position());
        self.on_workpiece =
            known.map_or(Point::default(), |workpiece| distance(workpiece.zero, self.offset()));
    }

    /// G50 X Z: adds `by` to the coordinates of the tip. Neither the tip nor the workpiece moves.
    pub fn shift_coordinates(&mut self, by: Point) {
        self.shift = Point::new(self.shift.x - by.x, self.shift.z - by.z);
        if let Some(Workpiece { zero, .. }) = &mut self.workpiece {
            *zero = Point::new(zero.x - by.x, zero.z - by.z);
        }
    }

    /// Machine position minus work position.
    pub fn offset(&self) -> Point {
        let (work, local) = (self.work.get(self.active).at, self.local);
        Point::new(
            self.shift.x + self.external.x + work.x + local.x,
            self.shift.z + self.external.z + work.z + local.z,
        )
    }

    /// Zero of a frame.
    pub fn work(&self, frame: u16) -> Point {
        self.work.get(frame).at
    }

    /// Zero of a frame, mutable.
    pub fn work_mut(&mut self, frame: u16, setting: Setting) -> &mut Point {
        let zero = self.work.entry(frame);
        zero.is_given |= setting == Setting::Absolute;
        &mut zero.at
    }
}

/// Vector from one zero to another, without rounding errors.
fn distance(from: Point, to: Point) -> Point {
    let without_dust = |length: f64| if length.abs() < SAME { 0.0 } else { length };
    Point::new(without_dust(to.x - from.x), without_dust(to.z - from.z))
}

/// How a zero is set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Setting {
    /// To a position.
    Absolute,
    /// By a distance from its present position.
    Relative,
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

/// An entry of the tool offset table that the program has written. X values are diameters, as in the table.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Entry {
    /// Value, mm.
    value: f64,
    /// The value with which the tip is at the programmed position, mm: the length of the tool as it was
    /// measured, or 0 for wear.
    neutral: f64,
}

/// The entries of the tool offset table that the program has written, sorted by number and column. All other
/// entries are as in the setup.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ToolOffsets(Arc<Vec<((u16, Column), Entry)>>);

/// Largest offset number.
pub const OFFSETS: u16 = 999;

impl ToolOffsets {
    /// Whether the program has written no entry.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// The written value, mm (X values as diameters, as in the table).
    pub fn get(&self, offset: u16, column: Column) -> Option<f64> {
        self.find(offset, column).ok().map(|at| self.0[at].1.value)
    }

    /// Distance by which a written entry moves the tip, mm (X as a diameter).
    pub fn tip_shift(&self, offset: u16, column: Column) -> Option<f64> {
        let Entry { value, neutral } = self.0[self.find(offset, column).ok()?].1;
        Some(value - neutral)
    }

    /// Writes an entry, mm; ignores numbers above [`OFFSETS`]. `length` is the length of the tool that the
    /// setup gives in this column, if any.
    ///
    /// The length of a tool does not move its tip, so the first one that a program enters moves nothing if the
    /// setup gives none. A later one, or one computed from the value before, does.
    pub fn set(&mut self, offset: u16, column: Column, value: f64, length: Option<f64>, setting: Setting) {
        if !(1..=OFFSETS).contains(&offset) {
            return;
        }
        let at = self.find(offset, column);
        let entries = Arc::make_mut(&mut self.0);
        let is_wear = matches!(column, Column::WearX | Column::WearZ);
        let known = at.map_or(length, |at| Some(entries[at].1.neutral));
        let neutral = match setting {
            // A larger value is the length of a tool, on controls whose table has one column for both.
            _ if is_wear && value.abs() <= LARGEST_WEAR => 0.0,
            Setting::Absolute => known.filter(|known| !is_wear || *known != 0.0).unwrap_or(value),
            Setting::Relative => known.unwrap_or(0.0),
        };
        let entry = Entry { value, neutral };
        match at {
            Ok(at) => entries[at].1 = entry,
            Err(at) => entries.insert(at, ((offset, column), entry)),
        }
    }

    fn find(&self, offset: u16, column: Column) -> Result<usize, usize> {
        self.0.binary_search_by_key(&(offset, column), |entry| entry.0)
    }
}
