//! The given blank: a bar, a tube, or a forging or casting whose half section is an outline.
//!
//! In: the sizes of a bar, or the points of an outline, from JSON, comments or a form. Out: the corners of the
//! half section, its extents as a bar, and the fault of an outline. Must not know how material is removed.

use serde::Deserialize;

use super::Position;
use super::stock::Stock;
use crate::geometry::{Point, SAME, nearest_on, within};
use crate::limits::OUTLINE_POINTS;
use crate::units::{Diameter, read_number};

/// A blank. With an outline, `extents` is the bar or tube around it.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(try_from = "WrittenBlank")]
pub struct Blank {
    extents: Stock,
    outline: Outline,
}

/// The blank: a bar or a tube, which needs `diameter` and `length`; or a forging or casting, whose `outline`
/// replaces all sizes except `grip`.
#[derive(Deserialize)]
#[cfg_attr(
    feature = "cli",
    derive(schemars::JsonSchema),
    schemars(
        rename = "Stock",
        extend(
            "if" = {"required": ["outline"], "properties": {"outline": {"type": "array"}}},
            "then" = {"properties": {"diameter": {"type": "null"}, "bore": {"type": "null"}, "face": {"type": "null"}, "length": {"type": "null"}}},
            "else" = {"required": ["diameter", "length"],
                "properties": {"diameter": {"type": "number"}, "length": {"type": "number"}}}
        )
    )
)]
#[serde(deny_unknown_fields)]
pub(super) struct WrittenBlank {
    /// Outside diameter, mm.
    diameter: Option<Diameter>,
    /// Diameter of the bore, mm; 0 for a bar.
    bore: Option<Diameter>,
    /// Z of the front face, mm.
    face: Option<f64>,
    /// Length from the front face towards −Z, mm.
    length: Option<f64>,
    /// Clamping length from the back end, mm.
    grip: Option<f64>,
    /// Points of the half section, joined by straight lines: X, a diameter, and Z, mm. The outline is closed along
    /// the spindle axis, unless its last point repeats the first.
    #[cfg_attr(feature = "cli", schemars(with = "Option<Vec<[f64; 2]>>", length(min = 1)))]
    outline: Option<Vec<Vec<f64>>>,
}

impl TryFrom<WrittenBlank> for Blank {
    type Error = &'static str;

    fn try_from(written: WrittenBlank) -> Result<Self, Self::Error> {
        let WrittenBlank { diameter, bore, face, length, grip, outline } = written;
        if let Some(points) = outline {
            let sizes = [diameter.is_some(), bore.is_some(), face.is_some(), length.is_some()];
            if sizes.contains(&true) {
                return Err("an `outline` replaces `diameter`, `bore`, `face` and `length`");
            }
            let point = |pair: &Vec<f64>| match pair[..] {
                [x, z] => Ok(Position { x: Diameter::new(x), z }),
                _ => Err("a point of `outline` is [x, z]"),
            };
            let points: Vec<_> = points.iter().map(point).collect::<Result<_, _>>()?;
            if points.is_empty() {
                return Err("an `outline` needs points");
            }
            return Ok(Self::with_outline(Outline(points), grip));
        }
        let diameter = diameter.ok_or("missing field `diameter`")?;
        let length = length.ok_or("missing field `length`")?;
        let (bore, face) = (bore.unwrap_or_default(), face.unwrap_or_default());
        Ok(Stock { diameter, bore, face, length, grip }.into())
    }
}

impl From<Stock> for Blank {
    fn from(bar: Stock) -> Self {
        Self { extents: bar, outline: Outline::default() }
    }
}

impl Blank {
    /// A blank with an outline, clamped over a length from its back, mm.
    pub fn with_outline(outline: Outline, grip: Option<f64>) -> Self {
        Self { extents: Stock { grip, ..outline.extents() }, outline }
    }

    /// The bar or tube, or that around the outline.
    pub fn extents(&self) -> Stock {
        self.extents
    }

    /// The outline; `None` for a bar or tube.
    pub fn outline(&self) -> Option<&Outline> {
        (!self.outline.0.is_empty()).then_some(&self.outline)
    }

    /// Whether it is a bar or tube, or its outline is that of one.
    pub fn is_bar(&self) -> bool {
        let Stock { diameter, bore, face, .. } = self.extents;
        let back = self.extents.back();
        let is_one_of = |value: f64, ends: [f64; 2]| ends.iter().any(|end| (value - end).abs() <= SAME);
        let is_of_bar = |corner: &Point| {
            is_one_of(corner.x, [bore.radius(), diameter.radius()]) && is_one_of(corner.z, [back, face])
        };
        let corners = self.outline().map(Outline::corners);
        corners.is_none_or(|corners| corners.len() == 4 && corners.iter().all(is_of_bar))
    }

    /// The corners of the half section, mm.
    pub fn corners(&self) -> Vec<Point> {
        if let Some(outline) = self.outline() {
            return outline.corners();
        }
        let Stock { diameter, bore, face, .. } = self.extents;
        let (low, high, back) = (bore.radius(), diameter.radius(), self.extents.back());
        [(low, back), (low, face), (high, face), (high, back)].map(|(x, z)| Point::new(x, z)).into()
    }

    /// Greatest radius between two places along Z, mm; `None` if the blank is not between them.
    pub fn greatest_radius(&self, low: f64, high: f64) -> Option<f64> {
        let corners = self.corners();
        let next = corners.iter().cycle().skip(1);
        let between = corners.iter().zip(next).filter(|(a, b)| a.z.max(b.z) >= low && a.z.min(b.z) <= high);
        let radii = between.flat_map(|(a, b)| {
            let at = |z: f64| match (b.z - a.z).abs() > SAME {
                true => a.x + (within(z, low, high) - a.z) / (b.z - a.z) * (b.x - a.x),
                false => a.x.max(b.x),
            };
            [at(a.z), at(b.z)]
        });
        radii.reduce(f64::max)
    }

    /// Radius at which the jaws hold the blank, mm.
    pub fn clamped_radius(&self) -> f64 {
        let Stock { diameter, grip, .. } = self.extents;
        let back = self.extents.back();
        // A shoulder at the end of the jaws is outside of them.
        let of_outline = || self.greatest_radius(back + SAME, back + grip.unwrap_or_default() - SAME);
        self.outline().and_then(|_| of_outline()).unwrap_or(diameter.radius())
    }
}

/// The half section of a blank: points joined by straight lines. The outline is closed along the spindle axis,
/// unless its last point repeats the first.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Outline(Vec<Position>);

/// The fault of an outline. Points count from 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum OutlineFault {
    /// It has too few or too many points.
    Points(usize),
    /// A point has a negative X.
    NegativeX {
        /// The point.
        point: usize,
        /// Its X.
        x: Diameter,
    },
    /// A coordinate of a point is larger than a setup accepts, mm.
    TooFar {
        /// The point.
        point: usize,
        /// X, a diameter, or Z.
        value: f64,
    },
    /// It has no area.
    Flat,
    /// Two of its lines meet between their ends.
    Crosses {
        /// The point where the second of them begins.
        point: usize,
    },
}

impl Outline {
    /// Fewest points of an outline.
    pub const FEWEST: usize = 2;

    /// Greatest X, a diameter, and greatest distance of Z from Z0, mm.
    pub const FARTHEST: f64 = 5000.0;

    /// An outline with these points.
    pub fn new(points: Vec<Position>) -> Self {
        Self(points)
    }

    /// Its points.
    pub fn points(&self) -> &[Position] {
        &self.0
    }

    /// Reads points such as `X0 Z2 X30 Z2 Z-20`. Each Z ends a point, and X keeps its value. `None` if the text
    /// contains anything else.
    pub fn read(text: &str) -> Option<Self> {
        let sign = |letter: char| match letter {
            // Many languages use a decimal comma.
            ',' => '.',
            '−' => '-',
            letter => letter.to_ascii_uppercase(),
        };
        let text: String = text.chars().filter(|c| !c.is_whitespace() && *c != '=').map(sign).collect();
        let mut reader = PointReader::default();
        let mut rest = &*text;
        while !rest.is_empty() {
            let letter = rest.chars().next()?;
            let behind = &rest[letter.len_utf8()..];
            let end = behind.find(['X', 'Z']).unwrap_or(behind.len());
            reader.add(letter, read_number(&behind[..end])?).ok()?;
            rest = &behind[end..];
        }
        reader.end().ok().filter(|outline| !outline.0.is_empty())
    }

    /// The corners of the closed half section, mm.
    pub fn corners(&self) -> Vec<Point> {
        let mut corners: Vec<Point> = self.0.iter().map(|at| Point::new(at.x.radius(), at.z)).collect();
        let (Some(&first), Some(&last)) = (corners.first(), corners.last()) else { return corners };
        if corners.len() == 1 || !first.is_same(last) {
            corners.extend([Point::new(0.0, last.z), Point::new(0.0, first.z)]);
        }
        corners.dedup_by(|a, b| a.is_same(*b));
        while corners.len() > 1 && corners.last().is_some_and(|last| last.is_same(corners[0])) {
            corners.pop();
        }
        corners
    }

    /// The bar around it. It is a tube if its front face is a ring.
    fn extents(&self) -> Stock {
        let z = || self.0.iter().map(|point| point.z);
        let (Some(face), Some(back)) = (z().reduce(f64::max), z().reduce(f64::min)) else {
            let none = Diameter::default();
            return Stock { diameter: none, bore: none, face: 0.0, length: 0.0, grip: None };
        };
        let diameter = self.0.iter().map(|point| point.x.mm()).fold(0.0, f64::max);
        let corners = self.corners();
        let front = || corners.iter().filter(|corner| corner.z >= face - SAME).map(|corner| corner.x);
        let least = front().fold(f64::INFINITY, f64::min);
        let is_ring = least < front().fold(0.0, f64::max) - SAME;
        let bore = Diameter::from_radius(if is_ring { least } else { 0.0 });
        Stock { diameter: Diameter::new(diameter), bore, face, length: face - back, grip: None }
    }

    /// Its first fault.
    pub fn fault(&self) -> Option<OutlineFault> {
        let count = self.0.len();
        if !(Self::FEWEST..=OUTLINE_POINTS).contains(&count) {
            return Some(OutlineFault::Points(count));
        }
        for (index, &Position { x, z }) in self.0.iter().enumerate() {
            let point = index + 1;
            if x.mm() < 0.0 {
                return Some(OutlineFault::NegativeX { point, x });
            }
            let far = [x.mm(), z].into_iter().find(|value| value.abs() > Self::FARTHEST);
            if let Some(value) = far {
                return Some(OutlineFault::TooFar { point, value });
            }
        }
        let corners = self.corners();
        let Stock { diameter, length, .. } = self.extents();
        if corners.len() < 3 || diameter.radius() <= SAME || length <= SAME {
            return Some(OutlineFault::Flat);
        }
        crossing(&corners).map(|index| OutlineFault::Crosses { point: count.min(index + 1) })
    }
}

impl std::fmt::Display for Outline {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        for (index, Position { x, z }) in self.0.iter().enumerate() {
            write!(f, "{}X{} Z{z}", if index == 0 { "" } else { " " }, x.mm())?;
        }
        Ok(())
    }
}

/// Reads the points of an outline word by word. Each Z ends a point, and X keeps its value.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PointReader {
    points: Vec<Position>,
    x: Option<Diameter>,
    /// Whether an X waits for its Z.
    is_open: bool,
}

/// A word that is not allowed where it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WrongWord;

impl PointReader {
    /// A reader that continues an outline.
    pub fn after(outline: &Outline) -> Self {
        let points = outline.0.clone();
        Self { x: points.last().map(|last| last.x), points, is_open: false }
    }

    /// Adds a word.
    pub fn add(&mut self, letter: char, value: f64) -> Result<(), WrongWord> {
        match (letter, self.x, self.is_open) {
            ('X', _, false) => (self.x, self.is_open) = (Some(Diameter::new(value)), true),
            ('Z', Some(x), _) => {
                self.points.push(Position { x, z: value });
                self.is_open = false;
            }
            _ => return Err(WrongWord),
        }
        if value.is_finite() { Ok(()) } else { Err(WrongWord) }
    }

    /// The outline of all points. The last X needs a Z.
    pub fn end(self) -> Result<Outline, WrongWord> {
        if self.is_open { Err(WrongWord) } else { Ok(Outline(self.points)) }
    }
}

/// The index of the corner that begins the second of two lines of a closed outline that meet between their ends.
fn crossing(corners: &[Point]) -> Option<usize> {
    let count = corners.len();
    let line = |index: usize| [corners[index % count], corners[(index + 1) % count]];
    (1..count).find(|&second| {
        (0..second).any(|first| {
            if first + 1 == second {
                turns_back(line(first), line(second))
            } else if (first, second) == (0, count - 1) {
                turns_back(line(second), line(first))
            } else {
                meet(line(first), line(second))
            }
        })
    })
}

/// Whether the second of two connected lines runs back along the first.
fn turns_back([before, corner]: [Point; 2], [_, after]: [Point; 2]) -> bool {
    let on = |line: [Point; 2], at: Point| nearest_on(line, at).distance(at) <= SAME;
    on([before, corner], after) || on([corner, after], before)
}

/// Whether two lines cross or touch each other.
fn meet(one: [Point; 2], other: [Point; 2]) -> bool {
    let side = |[from, to]: [Point; 2], at: Point| {
        (to.x - from.x) * (at.z - from.z) - (to.z - from.z) * (at.x - from.x)
    };
    let parts = |line: [Point; 2], ends: [Point; 2]| side(line, ends[0]) * side(line, ends[1]) < 0.0;
    let touches = |line: [Point; 2], at: Point| nearest_on(line, at).distance(at) <= SAME;
    parts(one, other) && parts(other, one)
        || other.iter().any(|&at| touches(one, at))
        || one.iter().any(|&at| touches(other, at))
}
