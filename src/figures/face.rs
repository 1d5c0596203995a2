//! The figure of a contour milled on the end face, as in seed 002: letters at its corners, the numbers of its moves,
//! its size, and the cutter at each corner.
//!
//! In: the moves over the face. Out: annotations in the plane of the face.

use super::NUMBERS;
use crate::geometry::bounds::Bounds;
use crate::geometry::{Point, at_share, share_along};
use crate::motion::{Motion, MotionKind};
use crate::scene::StrokeShape;
use crate::scene::annotation::{Annotation, Measure, Shape};
use crate::scene::surface_moves::SurfaceMoves;

/// The names of the corners. I is the name of a detail, O that of the zero of the program.
const LETTERS: [&str; 20] =
    ["A", "B", "C", "D", "E", "F", "G", "H", "J", "K", "L", "M", "N", "P", "Q", "R", "S", "T", "U", "V"];

/// A point this near to a line is on it, mm.
const ON_LINE: f64 = 1e-3;
/// A piece of a move that is a smaller share of it has no room for a number.
const LEAST_SHARE: f64 = 0.1;

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
    for (own, name) in (0..cuts.len()).zip(NUMBERS) {
        let others =
            cuts.iter().enumerate().filter(|(other, (_, motion))| *other != own && motion.arc().is_none());
        let others = others.map(|(_, (_, motion))| [motion.from, motion.to]);
        all.push(Annotation::step(middle_of(&cuts[own].1, others), name));
    }
    let mut size = corners.iter().map(|corner| Bounds::of(*corner)).reduce(Bounds::union);
    for (_, motion) in contour.iter().skip(1) {
        size = size.map(|size| size.union(StrokeShape::of(&programmed(motion)).bounds()));
    }
    all.extend(size.filter(|_| corners.len() > 2).into_iter().flat_map(dimensions_of));
    all.push(super::origin());
    all
}

/// Two points with the middle of a move between them: of an arc, near its middle; of a line, the ends of its longest piece
/// that is on no other line, so that the numbers of the ways in and out are apart.
fn middle_of(motion: &Motion, others: impl Iterator<Item = [Point; 2]>) -> [Point; 2] {
    let ends = [motion.from, motion.to];
    if let Some(arc) = motion.arc() {
        return [arc.at(0.45), arc.at(0.55)];
    }
    let is_on_line = |at: &Point| at_share(ends, share_along(ends, *at)).distance(*at) < ON_LINE;
    let on_line = others.filter(|other| other.iter().all(is_on_line));
    let shares = on_line.map(|other| other.map(|at| share_along(ends, at).clamp(0.0, 1.0)));
    let mut covered: Vec<[f64; 2]> = shares.map(|[a, b]| [a.min(b), a.max(b)]).collect();
    covered.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let (mut longest, mut end) = ([0.0, 0.0], 0.0);
    for [low, high] in covered.into_iter().chain([[1.0, 1.0]]) {
        if low - end > longest[1] - longest[0] {
            longest = [end, low];
        }
        end = f64::max(end, high);
    }
    if longest[1] - longest[0] < LEAST_SHARE { ends } else { longest.map(|share| at_share(ends, share)) }
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
