//! The figure of a contour milled on the end face, as in seed 002: letters at its corners, the numbers of its moves,
//! its size, and the cutter at each corner.
//!
//! In: the moves over the face. Out: annotations in the plane of the face.

use super::NUMBERS;
use crate::geometry::Point;
use crate::geometry::bounds::Bounds;
use crate::motion::{Motion, MotionKind};
use crate::scene::StrokeShape;
use crate::scene::annotation::{Annotation, Measure, Shape};
use crate::scene::surface_moves::SurfaceMoves;

const LETTERS: [&str; 20] =
    ["A", "B", "C", "D", "E", "F", "G", "H", "I", "J", "K", "L", "M", "N", "O", "P", "Q", "R", "S", "T"];

/// The annotations of the contour; empty if it has more moves than there are numbers. The last of several moves leaves
/// the contour, so its end has no letter. Arcs have their radius.
pub fn of_face(moves: &SurfaceMoves) -> Vec<Annotation> {
    let motions = moves.motions();
    let cuts: Vec<(usize, Motion)> = (0..motions.len())
        .map(|index| (index, motions.get_on_workpiece(index)))
        .filter(|(_, motion)| motion.kind != MotionKind::Dwell && motion.kind.cuts() && motion.length() > 0.0)
        .take(NUMBERS.len() + 1)
        .collect();
    if cuts.is_empty() || cuts.len() > NUMBERS.len() {
        return Vec::new();
    }
    let programmed = |motion: &Motion| motion.as_programmed().unwrap_or(*motion);
    let (mut all, mut corners): (Vec<Annotation>, Vec<Point>) = (Vec::new(), Vec::new());
    if let [(_, only)] = &cuts[..] {
        all.push(Annotation::point(programmed(only).from, LETTERS[0]));
        corners.push(programmed(only).from);
    }
    let contour = &cuts[..(cuts.len() - 1).max(1)];
    for (index, motion) in contour {
        let corner = programmed(motion).to;
        if let Some(arc) = programmed(motion).arc() {
            let shape = Shape::Radius { center: arc.center, on: arc.at(0.5) };
            all.push(Annotation::dimension(shape, "", Measure::Radius(arc.radius())));
        }
        if corners.iter().any(|other| other.is_same(corner)) {
            continue;
        }
        all.push(Annotation::point(corner, LETTERS[corners.len()]));
        corners.push(corner);
        all.extend(moves.cutter_after(*index).map(Annotation::outline));
    }
    for ((_, motion), name) in cuts.iter().zip(NUMBERS) {
        all.push(Annotation::step(middle_of(motion), name));
    }
    let mut size = corners.iter().map(|corner| Bounds::of(*corner)).reduce(Bounds::union);
    for (_, motion) in contour.iter().skip(1) {
        size = size.map(|size| size.union(StrokeShape::of(&programmed(motion)).bounds()));
    }
    all.extend(size.filter(|_| corners.len() > 2).into_iter().flat_map(dimensions_of));
    all
}

/// A short piece in the middle of a move: of an arc, its middle is not between its ends.
fn middle_of(motion: &Motion) -> [Point; 2] {
    motion.arc().map_or([motion.from, motion.to], |arc| [arc.at(0.45), arc.at(0.55)])
}

/// Width and height of the contour.
fn dimensions_of(size: Bounds) -> [Annotation; 2] {
    let Bounds { min, max } = size;
    let across = Shape::Axial([Point::new(max.x, min.z), Point::new(max.x, max.z)]);
    let upright = Shape::Radial([Point::new(min.x, max.z), Point::new(max.x, max.z)]);
    [
        Annotation::dimension(across, "", Measure::Length(max.z - min.z)),
        Annotation::dimension(upright, "", Measure::Length(max.x - min.x)),
    ]
}
