//! Measuring in the picture: the distances between two places that the user picks.
//!
//! In: the edges of the part and the strokes in mm, and the picked positions. Out: [`Picked`], the corner or edge
//! at a position; [`Measured`], the distances and the angle between two of them. X is a radius; below the axis it
//! is negative, so that a diameter can be picked at both of its edges.

use crate::geometry::bounds::Bounds;
use crate::geometry::{Point, at_share, nearest_on, share_along};
use crate::machine::feature::{Feature, Shape as FeatureShape};
use crate::scene::annotation::{Annotation, Importance, Measure, Shape};
use crate::scene::{Scene, StrokeShape};
use crate::units::Diameter;

use super::part;

/// Two directions that differ by less, degrees, are parallel.
const PARALLEL: f64 = 0.01;
/// Lengths below this, mm, are no distance.
const NONE: f64 = 1e-6;

/// A corner or an edge of the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Picked {
    /// The corner, or the point of the edge nearest to the picked position.
    pub at: Point,
    /// The ends of the edge; `None` for a corner.
    pub edge: Option<[Point; 2]>,
}

/// What lies between two picked places.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Measured {
    /// Between corners or parallel edges, mm.
    Lengths {
        /// The distance along Z.
        axial: f64,
        /// The distance along X, on the radius.
        radial: f64,
        /// The shortest distance.
        distance: f64,
    },
    /// The acute angle between two edges that are not parallel, degrees.
    Angle(f64),
}

/// The straight edges of the part and of its mirror image, and the straight strokes in an area. The ends of arcs
/// and threads are lines without length.
pub fn lines(features: &[Feature], scene: &Scene, area: Bounds) -> Vec<[Point; 2]> {
    let mut all = Vec::new();
    for feature in features {
        let [from, to] = feature.ends();
        let own = match feature.shape {
            FeatureShape::Cylinder | FeatureShape::Face | FeatureShape::Taper { .. } => vec![[from, to]],
            FeatureShape::Arc { .. } | FeatureShape::Thread { .. } => vec![[from; 2], [to; 2]],
            FeatureShape::Across => Vec::new(),
        };
        for side in scene.plane().sides() {
            all.extend(own.iter().map(|ends| ends.map(|at| Point::new(side * at.x, at.z))));
        }
    }
    for stroke in scene.strokes_near(area) {
        match stroke.drawn_shape() {
            StrokeShape::Line { from, to } => all.push([from, to]),
            StrokeShape::Dot(at) => all.push([at; 2]),
            shape => all.extend([[shape.start(); 2], [shape.end(); 2]]),
        }
    }
    all
}

/// The corner within `reach` mm of a position, or else the edge; `lines` are straight, and their ends are corners.
pub fn pick(lines: impl Iterator<Item = [Point; 2]>, position: Point, reach: f64) -> Option<Picked> {
    let mut corner: Option<(f64, Point)> = None;
    let mut edge: Option<(f64, Picked)> = None;
    for ends in lines {
        for at in ends {
            let away = at.distance(position);
            if away <= reach && corner.is_none_or(|(nearest, _)| away < nearest) {
                corner = Some((away, at));
            }
        }
        let at = nearest_on(ends, position);
        let away = at.distance(position);
        if away <= reach && edge.is_none_or(|(nearest, _)| away < nearest) {
            edge = Some((away, Picked { at, edge: Some(ends) }));
        }
    }
    let corner = corner.map(|(_, at)| Picked { at, edge: None });
    corner.or(edge.map(|(_, picked)| picked))
}

/// The distances between two picked places: perpendicular to an edge if one of them is an edge.
pub fn between(one: &Picked, other: &Picked) -> Measured {
    match (one.edge, other.edge) {
        (None, None) => lengths(one.at, other.at),
        (Some(edge), None) => lengths(foot(edge, other.at), other.at),
        (None, Some(edge)) => lengths(one.at, foot(edge, one.at)),
        (Some(a), Some(b)) => match angle_between(a, b) {
            angle if angle < PARALLEL => lengths(foot(a, other.at), other.at),
            angle => Measured::Angle(angle),
        },
    }
}

/// The annotations of one picked place. `feature`: that of the part at this edge.
pub fn annotations_of_one(picked: &Picked, feature: Option<&Feature>) -> Vec<Annotation> {
    let mut all = match (picked.edge, feature) {
        (Some(_), Some(feature)) => part::of_feature(feature),
        (Some([from, to]), None) => {
            annotations(&Picked { at: from, edge: None }, &Picked { at: to, edge: None })
        }
        (None, _) => {
            let x = Measure::Coordinate('X', Diameter::from_radius(picked.at.x.abs()).mm());
            let z = Measure::Coordinate('Z', picked.at.z);
            let mut all = vec![Annotation::point(picked.at, "")];
            all.extend([x, z].map(|value| Annotation::dimension(Shape::Note(picked.at), "", value)));
            all
        }
    };
    all.iter_mut().for_each(|annotation| annotation.importance = Importance::Required);
    all
}

/// The annotations of a measurement between two picked places.
pub fn annotations(one: &Picked, other: &Picked) -> Vec<Annotation> {
    let mut all = vec![Annotation::point(one.at, ""), Annotation::point(other.at, "")];
    let middle = Point::new((one.at.x + other.at.x) / 2.0, (one.at.z + other.at.z) / 2.0);
    match between(one, other) {
        Measured::Angle(degrees) => {
            all.push(Annotation::of_word(Shape::Note(middle), "", Measure::Degrees(degrees)));
        }
        Measured::Lengths { axial, radial, distance } => {
            let is_across = (one.at.x + other.at.x).abs() < NONE;
            let ends = [one.at, other.at];
            if radial > NONE {
                let value = if is_across { Measure::Diameter(radial) } else { Measure::Length(radial) };
                all.push(Annotation::of_word(Shape::Radial(ends), "", value));
            }
            if axial > NONE {
                all.push(Annotation::of_word(Shape::Axial(ends), "", Measure::Length(axial)));
            }
            if axial > NONE && radial > NONE {
                all.push(Annotation::of_word(Shape::Note(middle), "", Measure::Length(distance)));
                let angle = Measure::Degrees(radial.atan2(axial).to_degrees());
                all.push(Annotation::dimension(Shape::Note(one.at), "", angle));
            }
        }
    }
    all
}

/// The distances between two points.
pub fn lengths(one: Point, other: Point) -> Measured {
    let (radial, axial) = ((one.x - other.x).abs(), (one.z - other.z).abs());
    Measured::Lengths { axial, radial, distance: radial.hypot(axial) }
}

/// The acute angle between two edges, degrees.
fn angle_between([a, b]: [Point; 2], [c, d]: [Point; 2]) -> f64 {
    let [one, other] = [[b.x - a.x, b.z - a.z], [d.x - c.x, d.z - c.z]];
    let cross = one[0] * other[1] - one[1] * other[0];
    let dot = one[0] * other[0] + one[1] * other[1];
    cross.abs().atan2(dot.abs()).to_degrees()
}

/// The foot of the perpendicular from a point to the line through an edge.
fn foot(edge: [Point; 2], at: Point) -> Point {
    at_share(edge, share_along(edge, at))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The upper half of a shaft: Ø30 to Z-20 with C2 at its end, a cone to Ø40 at Z-40, a shoulder to Ø50 at Z-60.
    const CORNERS: [(f64, f64); 8] = [
        (0.0, 0.0),
        (13.0, 0.0),
        (15.0, -2.0),
        (15.0, -20.0),
        (20.0, -40.0),
        (20.0, -60.0),
        (25.0, -60.0),
        (25.0, -80.0),
    ];

    fn lines() -> Vec<[Point; 2]> {
        let half = |side: f64| {
            let corners = CORNERS.map(|(x, z)| Point::new(side * x, z));
            corners.windows(2).map(|ends| [ends[0], ends[1]]).collect::<Vec<_>>()
        };
        [half(1.0), half(-1.0)].concat()
    }

    fn picked(x: f64, z: f64) -> Picked {
        pick(lines().into_iter(), Point::new(x, z), 0.5).unwrap_or_else(|| panic!("nothing at X{x} Z{z}"))
    }

    #[track_caller]
    fn check(one: (f64, f64), other: (f64, f64), expected: Measured) {
        let found = between(&picked(one.0, one.1), &picked(other.0, other.1));
        let same = |a: f64, b: f64| (a - b).abs() < 1e-9;
        let is_same = match (found, expected) {
            (Measured::Angle(a), Measured::Angle(b)) => same(a, b),
            (
                Measured::Lengths { axial, radial, distance },
                Measured::Lengths { axial: z, radial: x, distance: d },
            ) => same(axial, z) && same(radial, x) && same(distance, d),
            _ => false,
        };
        assert!(is_same, "{one:?} to {other:?}: {found:?}, not {expected:?}");
    }

    fn apart(axial: f64, radial: f64, distance: f64) -> Measured {
        Measured::Lengths { axial, radial, distance }
    }

    #[test]
    fn corners_are_preferred_to_edges() {
        assert_eq!(picked(15.2, -20.3), Picked { at: Point::new(15.0, -20.0), edge: None });
        let edge = picked(15.2, -11.0);
        assert_eq!(edge.at, Point::new(15.0, -11.0));
        assert_eq!(edge.edge, Some([Point::new(15.0, -2.0), Point::new(15.0, -20.0)]));
        assert_eq!(pick(lines().into_iter(), Point::new(40.0, -20.0), 0.5), None);
    }

    /// Between corners: differences of the coordinates above, and the hypotenuse.
    #[test]
    fn between_corners() {
        check((13.0, 0.0), (15.0, -2.0), apart(2.0, 2.0, 8f64.sqrt()));
        check((15.0, -2.0), (15.0, -20.0), apart(18.0, 0.0, 18.0));
        check((15.0, -20.0), (20.0, -40.0), apart(20.0, 5.0, 425f64.sqrt()));
        check((20.0, -60.0), (25.0, -60.0), apart(0.0, 5.0, 5.0));
        check((13.0, 0.0), (25.0, -80.0), apart(80.0, 12.0, 6544f64.sqrt()));
        check((0.0, 0.0), (25.0, -80.0), apart(80.0, 25.0, 7025f64.sqrt()));
        check((15.0, -20.0), (-15.0, -20.0), apart(0.0, 30.0, 30.0));
        check((20.0, -40.0), (-20.0, -60.0), apart(20.0, 40.0, 2000f64.sqrt()));
        check((25.0, -80.0), (-25.0, -80.0), apart(0.0, 50.0, 50.0));
        check((13.0, 0.0), (-13.0, 0.0), apart(0.0, 26.0, 26.0));
    }

    /// Between parallel edges: the perpendicular distance, wherever they are picked.
    #[test]
    fn between_parallel_edges() {
        check((15.0, -11.0), (-15.0, -7.0), apart(0.0, 30.0, 30.0));
        check((20.0, -50.0), (-20.0, -45.0), apart(0.0, 40.0, 40.0));
        check((25.0, -70.0), (-25.0, -75.0), apart(0.0, 50.0, 50.0));
        check((15.0, -11.0), (20.0, -50.0), apart(0.0, 5.0, 5.0));
        check((15.0, -5.0), (25.0, -70.0), apart(0.0, 10.0, 10.0));
        check((6.0, 0.0), (22.0, -60.0), apart(60.0, 0.0, 60.0));
        check((6.0, 0.0), (-22.0, -60.0), apart(60.0, 0.0, 60.0));
    }

    /// Between a corner and an edge: the perpendicular. The cone falls 5 over 20: its normal is (4, 1) / √17.
    #[test]
    fn between_a_corner_and_an_edge() {
        check((15.0, -2.0), (6.0, 0.0), apart(2.0, 0.0, 2.0));
        check((15.0, -20.0), (6.0, 0.0), apart(20.0, 0.0, 20.0));
        check((20.0, -40.0), (6.0, 0.0), apart(40.0, 0.0, 40.0));
        check((25.0, -80.0), (15.0, -11.0), apart(0.0, 10.0, 10.0));
        check((13.0, 0.0), (-25.0, -70.0), apart(0.0, 38.0, 38.0));
        // From (20, −60) to the line through (15, −20) and (20, −40): 20 beyond the end, so 5 too low.
        let perpendicular = 20.0 / 17f64.sqrt();
        let (radial, axial) = (perpendicular * 4.0 / 17f64.sqrt(), perpendicular / 17f64.sqrt());
        check((20.0, -60.0), (17.5, -30.0), apart(axial, radial, perpendicular));
    }

    /// arctan(5 / 20) = 14.04°; a chamfer has 45°.
    #[test]
    fn between_other_edges() {
        let cone = 0.25f64.atan().to_degrees();
        check((17.5, -30.0), (15.0, -11.0), Measured::Angle(cone));
        check((17.5, -30.0), (25.0, -70.0), Measured::Angle(cone));
        check((17.5, -30.0), (-17.5, -30.0), Measured::Angle(2.0 * cone));
        check((17.5, -30.0), (6.0, 0.0), Measured::Angle(90.0 - cone));
        check((14.0, -1.0), (15.0, -11.0), Measured::Angle(45.0));
        check((14.0, -1.0), (6.0, 0.0), Measured::Angle(45.0));
        check((14.0, -1.0), (17.5, -30.0), Measured::Angle(45.0 - cone));
        check((15.0, -11.0), (6.0, 0.0), Measured::Angle(90.0));
    }

    #[test]
    fn a_diameter_is_picked_at_both_edges() {
        let labels = |one: (f64, f64), other: (f64, f64)| -> Vec<String> {
            let all = annotations(&picked(one.0, one.1), &picked(other.0, other.1));
            let texts = all.iter().map(|own| own.label.text(crate::units::Unit::Millimetre));
            texts.filter(|text| !text.is_empty()).collect()
        };
        assert_eq!(labels((15.0, -20.0), (-15.0, -20.0)), ["Ø30"]);
        assert_eq!(labels((15.0, -20.0), (20.0, -40.0)), ["5", "20", "20.616", "14.04°"]);
        assert_eq!(labels((14.0, -1.0), (15.0, -11.0)), ["45°"]);
    }
}
