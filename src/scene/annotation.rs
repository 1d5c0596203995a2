//! Annotations of a picture, as in technical drawings: named points, dimensions, notes.
//!
//! In: nothing. Out: [`Annotation`], data in mm without positions on the screen. The room `figures` makes
//! annotations from a run, [`super::placement`] places them in a picture, and the painters draw the result.
//! A label contains letters and numbers only, no words of a language.

use crate::geometry::{Point, SAME};
use crate::units::{Unit, number};

/// Which annotations a picture shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Annotate {
    /// None.
    None,
    /// The dimension of the word at the cursor.
    #[default]
    Word,
    /// The letters and dimensions of the cycle at the cursor, or of the first one while there is no cursor.
    Cycle,
    /// The dimensions of the finished part.
    Part,
}

/// A named point, a dimension or a note.
#[derive(Clone, Debug, PartialEq)]
pub struct Annotation {
    /// What is marked.
    pub shape: Shape,
    /// The text beside it.
    pub label: Label,
    /// Whether the label may be omitted if there is no free place for it.
    pub importance: Importance,
}

/// What an annotation marks. X is a radius; all lengths in mm.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// A point with a dot.
    Point(Point),
    /// The distance of two points along Z.
    Axial([Point; 2]),
    /// The distance of two points along X.
    Radial([Point; 2]),
    /// A diameter across the axis, beside a point of the contour.
    Diameter(Point),
    /// A diameter across the axis, through a point of the contour.
    DiameterThrough(Point),
    /// The radius of an arc: its centre and a point on it.
    Radius {
        /// The centre.
        center: Point,
        /// The point that the arrow touches.
        on: Point,
    },
    /// The angle between two arms.
    Angle {
        /// Where the arms meet.
        vertex: Point,
        /// A point on the arm that the angle is measured from.
        base: Point,
        /// The end of the other arm.
        end: Point,
    },
    /// A note with a leader to a point.
    Note(Point),
    /// The number of a step, beside its stroke.
    Step([Point; 2]),
    /// A detail at a larger scale.
    Detail(Box<Detail>),
    /// The outline of a tool, without a label.
    Outline(Vec<Point>),
    /// Material that another path would leave: hatched, with that path.
    Zone {
        /// The corners of the material.
        outline: Vec<Point>,
        /// The other path.
        way: [Point; 2],
        /// The point inside that the label marks.
        mark: Point,
    },
}

/// A part of the picture that is drawn again at a larger scale, in a free area.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Detail {
    /// The middle of the circle around it.
    pub at: Point,
    /// The radius of the circle, mm.
    pub radius: f64,
    /// Thin lines.
    pub lines: Vec<Vec<Point>>,
    /// Rapids, which are dashed.
    pub rapids: Vec<[Point; 2]>,
    /// Thick lines: the edges of the part, and cuts.
    pub edges: Vec<Vec<Point>>,
    /// Outlines of the part, which are hatched.
    pub part: Vec<Vec<Point>>,
    /// Its own dimensions.
    pub annotations: Vec<Annotation>,
}

/// Which labels are placed first. A lower importance is omitted first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Importance {
    /// May be omitted, and has no arrow at the border if its place is outside the picture.
    Low,
    /// Omitted only after all others.
    Usual,
    /// The word at the cursor, and the letters of its cycle: never omitted.
    Required,
}

/// The text of a label: a name as in manuals, a value, or both.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Label {
    /// The name, such as `Δd`, `U/2` or `A′`; empty for a value alone.
    pub name: &'static str,
    /// The value.
    pub value: Option<Measure>,
    /// The permitted deviations of the value, lower and upper, mm or degrees.
    pub deviations: Option<[f64; 2]>,
}

/// The value of a label.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Measure {
    /// A length, mm.
    Length(f64),
    /// A diameter, mm.
    Diameter(f64),
    /// A radius of an arc, mm.
    Radius(f64),
    /// A coordinate, with the letter of its axis, mm.
    Coordinate(char, f64),
    /// An angle, degrees.
    Degrees(f64),
    /// A number of passes.
    Count(f64),
    /// A cone by its ratio 1:n.
    Ratio(f64),
    /// A metric thread by its diameter and lead, mm.
    Thread(f64, f64),
    /// The least value of a length, mm.
    AtLeast(f64),
    /// A length, mm, that is the root of a number times the length of its name.
    Root(usize, f64),
}

impl Annotation {
    /// The annotation of the word at the cursor.
    pub fn of_word(shape: Shape, name: &'static str, value: Measure) -> Self {
        Self { shape, label: Label::of(name, Some(value)), importance: Importance::Required }
    }

    /// The number of a step of a cycle.
    pub fn step(ends: [Point; 2], name: &'static str) -> Self {
        let label = Label::of(name, None);
        Self { shape: Shape::Step(ends), label, importance: Importance::Usual }
    }

    /// A dimension of a part or a cycle.
    pub fn dimension(shape: Shape, name: &'static str, value: Measure) -> Self {
        Self { shape, label: Label::of(name, Some(value)), importance: Importance::Usual }
    }

    /// A name with a leader to a point.
    pub fn note(at: Point, name: &'static str) -> Self {
        let label = Label::of(name, None);
        Self { shape: Shape::Note(at), label, importance: Importance::Usual }
    }

    /// A detail with its own dimensions.
    pub fn detail(detail: Detail) -> Self {
        let shape = Shape::Detail(Box::new(detail));
        Self { shape, label: Label::default(), importance: Importance::Usual }
    }

    /// The outline of a tool.
    pub fn outline(corners: Vec<Point>) -> Self {
        let shape = Shape::Outline(corners);
        Self { shape, label: Label::default(), importance: Importance::Usual }
    }

    /// A named point of a cycle.
    pub fn point(at: Point, name: &'static str) -> Self {
        let label = Label::of(name, None);
        Self { shape: Shape::Point(at), label, importance: Importance::Required }
    }
}

impl Shape {
    /// Whether there is anything to draw: a distance of 0 has no arrows.
    pub fn is_visible(&self) -> bool {
        match self {
            Self::Axial([a, b]) => (a.z - b.z).abs() > SAME,
            Self::Radial([a, b]) => (a.x - b.x).abs() > SAME,
            Self::Diameter(at) | Self::DiameterThrough(at) => at.x.abs() > SAME,
            Self::Point(_)
            | Self::Note(_)
            | Self::Step(_)
            | Self::Radius { .. }
            | Self::Angle { .. }
            | Self::Detail(_)
            | Self::Zone { .. }
            | Self::Outline(_) => true,
        }
    }

    /// The same shape with its points elsewhere; details, outlines and zones are not displaced.
    pub fn map(&self, place: impl Fn(Point) -> Point) -> Self {
        match *self {
            Self::Detail(ref detail) => Self::Detail(detail.clone()),
            Self::Outline(ref corners) => Self::Outline(corners.clone()),
            Self::Zone { ref outline, way, mark } => Self::Zone { outline: outline.clone(), way, mark },
            Self::Point(at) => Self::Point(place(at)),
            Self::Axial(ends) => Self::Axial(ends.map(place)),
            Self::Radial(ends) => Self::Radial(ends.map(place)),
            Self::Diameter(at) => Self::Diameter(place(at)),
            Self::DiameterThrough(at) => Self::DiameterThrough(place(at)),
            Self::Radius { center, on } => {
                let moved = place(on);
                let by = Point::new(moved.x - on.x, moved.z - on.z);
                Self::Radius { center: center.moved(by), on: moved }
            }
            Self::Angle { vertex, base, end } => {
                let moved = place(vertex);
                let by = Point::new(moved.x - vertex.x, moved.z - vertex.z);
                Self::Angle { vertex: moved, base: base.moved(by), end: end.moved(by) }
            }
            Self::Note(at) => Self::Note(place(at)),
            Self::Step(ends) => Self::Step(ends.map(place)),
        }
    }

    /// The points that it marks.
    pub fn points(&self) -> Vec<Point> {
        match *self {
            Self::Detail(ref detail) => vec![detail.at],
            Self::Outline(ref corners) | Self::Zone { outline: ref corners, .. } => corners.clone(),
            Self::Point(at) | Self::Note(at) => vec![at],
            Self::Axial(ends) | Self::Radial(ends) | Self::Step(ends) => ends.to_vec(),
            Self::Diameter(at) | Self::DiameterThrough(at) => vec![at, Point::new(-at.x, at.z)],
            Self::Radius { center, on } => vec![on, center],
            Self::Angle { vertex, end, .. } => vec![vertex, end],
        }
    }
}

impl Label {
    /// A label without deviations.
    pub fn of(name: &'static str, value: Option<Measure>) -> Self {
        Self { name, value, deviations: None }
    }

    /// The text, with lengths in `unit`.
    pub fn text(&self, unit: Unit) -> String {
        let Some(value) = self.value else { return self.name.to_owned() };
        let text = match self.deviations {
            Some(deviations) => [value.text(unit), value.deviations(deviations, unit)].join(" "),
            None => value.text(unit),
        };
        match (self.name, value) {
            ("", _) => text,
            (name, Measure::Root(number, _)) => format!("{name}√{number} = {text}"),
            (name, Measure::AtLeast(_)) => format!("{name} {text}"),
            (name, _) => format!("{name} = {text}"),
        }
    }
}

impl Measure {
    /// The value as it is printed: rounded to the last digit that a control shows, with the sign of print (−).
    pub fn text(self, unit: Unit) -> String {
        let rounded = |mm: f64, decimals: u8| {
            let factor = 10f64.powi(i32::from(decimals));
            printed((mm / unit.millimetres() * factor).round() / factor)
        };
        let length = |mm: f64| rounded(mm, unit.decimals());
        match self {
            Self::Length(mm) | Self::Root(_, mm) => length(mm),
            // It is a rule of thumb.
            Self::AtLeast(mm) => format!("≥ {}", rounded(mm, unit.decimals() - 1)),
            Self::Diameter(mm) => format!("Ø{}", length(mm)),
            Self::Radius(mm) => format!("R{}", length(mm)),
            Self::Coordinate(axis, mm) => format!("{axis}{}", length(mm)),
            Self::Degrees(degrees) => format!("{}°", printed((degrees * 100.0).round() / 100.0)),
            Self::Count(count) => printed(count),
            Self::Ratio(ratio) => format!("1:{}", printed(ratio)),
            Self::Thread(diameter, lead) => format!("M{}×{}", length(diameter), length(lead)),
        }
    }
}

impl Measure {
    /// The deviations of the value as in drawings: `±0.1` or `+0.1 −0.05`.
    fn deviations(self, [lower, upper]: [f64; 2], unit: Unit) -> String {
        let own = |value: f64| match self {
            Self::Degrees(_) => Self::Degrees(value).text(unit),
            _ => Self::Length(value).text(unit),
        };
        match (lower + upper).abs() < SAME {
            true => format!("±{}", own(upper)),
            false => format!("+{} −{}", own(upper), own(-lower)),
        }
    }
}

fn printed(value: f64) -> String {
    number(value).replace('-', "−")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_label_has_the_sign_and_digits_of_print() {
        let text = |value: Measure, unit| Label::of("", Some(value)).text(unit);
        assert_eq!(text(Measure::Length(-7.5), Unit::Millimetre), "−7.5");
        assert_eq!(text(Measure::Length(25.4 / 3.0), Unit::Inch), "0.3333");
        assert_eq!(text(Measure::Diameter(33.8), Unit::Millimetre), "Ø33.8");
        assert_eq!(text(Measure::Degrees(30.963_756), Unit::Inch), "30.96°");
        assert_eq!(text(Measure::Coordinate('Z', -0.000_04), Unit::Millimetre), "Z0");
        let depth = Label::of("Δd", Some(Measure::Length(2.0)));
        assert_eq!(depth.text(Unit::Millimetre), "Δd = 2");
        // 0.7 · √10 = 2.2136
        let tenth = Label::of("Δd", Some(Measure::Root(10, 2.213_594)));
        assert_eq!(tenth.text(Unit::Millimetre), "Δd√10 = 2.214");
        let run_in = Label::of("δ1", Some(Measure::AtLeast(2.003)));
        assert_eq!(run_in.text(Unit::Millimetre), "δ1 ≥ 2");
        assert_eq!(Label::of("A′", None).text(Unit::Millimetre), "A′");
        let within = |value, deviations| Label { name: "", value: Some(value), deviations: Some(deviations) };
        assert_eq!(within(Measure::Diameter(26.0), [-0.1, 0.1]).text(Unit::Millimetre), "Ø26 ±0.1");
        assert_eq!(within(Measure::Length(20.0), [-0.05, 0.0]).text(Unit::Millimetre), "20 +0 −0.05");
        assert_eq!(within(Measure::Degrees(15.0), [-0.5, 0.5]).text(Unit::Inch), "15° ±0.5°");
    }
}
