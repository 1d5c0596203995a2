//! The dimensions of the finished part, as in a workshop drawing.
//!
//! In: the section of the part, its threads, and the motions. Out: one dimension for each size: diameters,
//! lengths from the right end, radii, chamfers, cones, threads. A size is that of the program where the part
//! agrees with it (`Feature::as_programmed`). ISO 129-1: no size twice, none missing.

use crate::geometry::Point;
use crate::machine::feature::{self, Feature, Shape as FeatureShape, Thread};
use crate::machine::region::Region;
use crate::motion::Motions;
use crate::scene::annotation::{Annotation, Measure, Shape};
use crate::units::Diameter;

/// Two positions closer than this, mm, are one.
const SAME_PLACE: f64 = 0.005;
/// Radius within which edges have no dimensions, mm: parting leaves them at the axis.
const LARGEST_NIB: f64 = 0.5;
/// Least number of pieces of a curve, and their greatest length, mm.
const LEAST_PIECES: usize = 5;
const LONGEST_PIECE: f64 = 4.0;
/// Longest leg of a taper at 45° that is a chamfer, mm.
const LONGEST_CHAMFER: f64 = 5.0;

/// The dimensions of a part.
pub fn of_part(part: &Region, threads: &[Thread], motions: &Motions) -> Vec<Annotation> {
    let left = left_end(part);
    let features: Vec<Feature> = feature::all(part, threads)
        .into_iter()
        .filter(|feature| feature.ends().iter().all(|end| end.z > left - SAME_PLACE))
        .filter(|feature| feature.ends().iter().any(|end| end.x > LARGEST_NIB))
        .map(|feature| feature.as_programmed(motions))
        .collect();
    let (features, curves) = without_curves(without_teeth(features));
    let mut drawing = Drawing { annotations: Vec::new(), features: &features, curves };
    // Lengths first: they need free space beside the part.
    drawing.lengths();
    drawing.features();
    drawing.annotations
}

/// Z of the left end of the piece farthest to the right: the rest of a bar is not the part.
fn left_end(part: &Region) -> f64 {
    let ends = part.pieces().map(|piece| {
        let z = || piece.outline.iter().map(|at| at.z);
        (z().fold(f64::MIN, f64::max), z().fold(f64::MAX, f64::min))
    });
    ends.max_by(|a, b| a.0.total_cmp(&b.0)).map_or(f64::MIN, |(_, left)| left)
}

/// The features without the incomplete teeth at the ends of threads.
fn without_teeth(features: Vec<Feature>) -> Vec<Feature> {
    let threads: Vec<Feature> =
        features.iter().filter(|own| matches!(own.shape, FeatureShape::Thread { .. })).cloned().collect();
    let is_tooth = |feature: &Feature| {
        threads.iter().any(|thread| {
            let FeatureShape::Thread { lead, minor, major } = thread.shape else { return false };
            let [a, b] = thread.ends();
            let (left, right) = (a.z.min(b.z) - lead, a.z.max(b.z) + lead);
            let (inner, outer) = (minor.min(major) - SAME_PLACE, minor.max(major) + SAME_PLACE);
            let is_between = |at: &Point| (left..right).contains(&at.z) && (inner..outer).contains(&at.x);
            let is_other = matches!(feature.shape, FeatureShape::Thread { .. } | FeatureShape::Face);
            !is_other && chamfer(feature).is_none() && feature.ends().iter().all(is_between)
        })
    };
    features.into_iter().filter(|feature| !is_tooth(feature)).collect()
}

/// Separates curves that are cut in short straight pieces, such as an ellipse from a macro, from the other features.
/// Returns these, and the ends of each curve.
fn without_curves(features: Vec<Feature>) -> (Vec<Feature>, Vec<[Point; 2]>) {
    let is_piece = |feature: &Feature| {
        let [from, to] = feature.ends();
        matches!(feature.shape, FeatureShape::Taper { .. }) && from.distance(to) < LONGEST_PIECE
    };
    let (mut others, mut curves) = (Vec::new(), Vec::new());
    for run in features.chunk_by(|before, next| {
        is_piece(before) && is_piece(next) && is_same(before.ends()[1], next.ends()[0])
    }) {
        match run {
            [first, .., last] if run.len() >= LEAST_PIECES => curves.push([first.ends()[0], last.ends()[1]]),
            _ => others.extend_from_slice(run),
        }
    }
    (others, curves)
}

/// The dimensions of a single feature.
pub fn of_feature(feature: &Feature) -> Vec<Annotation> {
    let mut drawing =
        Drawing { annotations: Vec::new(), features: std::slice::from_ref(feature), curves: Vec::new() };
    drawing.features();
    drawing.lengths();
    if let FeatureShape::Face = feature.shape {
        let [from, to] = feature.ends();
        drawing.ends(feature);
        let middle = Point::new((from.x + to.x) / 2.0, from.z);
        drawing.add(Shape::Note(middle), Measure::Coordinate('Z', from.z));
    }
    drawing.annotations
}

struct Drawing<'a> {
    annotations: Vec<Annotation>,
    features: &'a [Feature],
    /// The ends of curves that have no other dimensions.
    curves: Vec<[Point; 2]>,
}

impl Drawing<'_> {
    /// Diameters, radii, chamfers, cones and threads.
    fn features(&mut self) {
        for feature in self.features {
            let [from, to] = feature.ends();
            let middle = Point::new((from.x + to.x) / 2.0, (from.z + to.z) / 2.0);
            match feature.shape {
                FeatureShape::Cylinder => {
                    let value = Measure::Diameter(Diameter::from_radius(from.x).mm());
                    self.add(Shape::DiameterThrough(middle), value);
                }
                FeatureShape::Thread { lead, major, .. } => {
                    self.add(Shape::Note(middle), Measure::Thread(Diameter::from_radius(major).mm(), lead));
                }
                FeatureShape::Arc { radius } => {
                    let on = feature.corners[feature.corners.len() / 2];
                    let chord = Point::new(middle.x - on.x, middle.z - on.z);
                    let length = chord.x.hypot(chord.z).max(1e-9);
                    let center =
                        Point::new(on.x + radius * chord.x / length, on.z + radius * chord.z / length);
                    self.add(Shape::Radius { center, on }, Measure::Radius(radius));
                    self.ends(feature);
                }
                FeatureShape::Taper { .. } if chamfer(feature).is_some() => {
                    let leg = (to.x - from.x).abs();
                    self.add(Shape::Note(middle), Measure::Coordinate('C', leg));
                }
                FeatureShape::Taper { half_angle, ratio } => {
                    let value = match ratio {
                        Some(ratio) => Measure::Ratio(ratio),
                        None => Measure::Degrees(half_angle.to_degrees()),
                    };
                    self.add(Shape::Note(middle), value);
                    self.ends(feature);
                }
                FeatureShape::Face | FeatureShape::Across => {}
            }
        }
        for ends in self.curves.clone() {
            self.diameters(ends);
        }
    }

    /// The diameters at the ends of a cone or an arc, unless a neighbour gives them.
    fn ends(&mut self, feature: &Feature) {
        self.diameters(feature.ends());
    }

    fn diameters(&mut self, ends: [Point; 2]) {
        for end in ends {
            let is_given = self.features.iter().any(|other| {
                matches!(other.shape, FeatureShape::Cylinder)
                    && other.ends().iter().any(|at| is_same(*at, end))
            });
            let is_added = self.annotations.iter().any(|own| match own.shape {
                Shape::Diameter(at) => is_same(at, end),
                _ => false,
            });
            if !is_given && !is_added && end.x > SAME_PLACE {
                self.add(Shape::Diameter(end), Measure::Diameter(Diameter::from_radius(end.x).mm()));
            }
        }
    }

    /// The distance of each shoulder and each end from the right end, the shortest first.
    fn lengths(&mut self) {
        let mut ends: Vec<Point> = Vec::new();
        let features = self.features.iter().filter(|feature| chamfer(feature).is_none()).map(Feature::ends);
        for both in features.chain(self.curves.iter().copied()) {
            for end in both.into_iter().filter(|end| !self.follows_from_chamfer(*end)) {
                match ends.iter_mut().find(|other| (other.z - end.z).abs() < SAME_PLACE) {
                    Some(other) if other.x < end.x => *other = end,
                    Some(_) => {}
                    None => ends.push(end),
                }
            }
        }
        let Some(right) = ends.iter().copied().max_by(|a, b| a.z.total_cmp(&b.z)) else { return };
        ends.sort_by(|a, b| b.z.total_cmp(&a.z));
        for end in ends.into_iter().filter(|end| right.z - end.z > SAME_PLACE) {
            self.add(Shape::Axial([right, end]), Measure::Length(right.z - end.z));
        }
    }

    /// Whether a chamfer gives the position of its end from that of a face at its other end.
    fn follows_from_chamfer(&self, end: Point) -> bool {
        let is_face_at = |at: Point| {
            let faces = self.features.iter().filter(|feature| matches!(feature.shape, FeatureShape::Face));
            faces.flat_map(Feature::ends).any(|other| is_same(other, at))
        };
        self.features.iter().filter(|feature| chamfer(feature).is_some()).any(|feature| {
            let [from, to] = feature.ends();
            is_same(from, end) && is_face_at(to) || is_same(to, end) && is_face_at(from)
        })
    }

    fn add(&mut self, shape: Shape, value: Measure) {
        self.annotations.push(Annotation::dimension(shape, "", value));
    }
}

/// The leg of a chamfer at 45°, mm; `None` for other features.
fn chamfer(feature: &Feature) -> Option<f64> {
    let [from, to] = feature.ends();
    let (x, z) = ((to.x - from.x).abs(), (to.z - from.z).abs());
    let is_chamfer = matches!(feature.shape, FeatureShape::Taper { .. })
        && (x - z).abs() < SAME_PLACE
        && x <= LONGEST_CHAMFER;
    is_chamfer.then_some(x)
}

fn is_same(a: Point, b: Point) -> bool {
    (a.x - b.x).abs() < SAME_PLACE && (a.z - b.z).abs() < SAME_PLACE
}
