//! The part as a solid for other programs: binary STL, in mm.
//!
//! In: the half-section. Out: its outlines rotated about the spindle axis, as a closed mesh of triangles. Z
//! of the file is Z of the lathe. Threads are rings, as in the section, not helices.

use std::f64::consts::{PI, TAU};

use crate::geometry::Point;
use crate::machine::region::Region;

/// Maximum distance of the middle of a flat from its corners, measured radially, mm. The true surface is
/// between the two, so that the mesh has the volume of the part.
pub const FLATNESS: f64 = 0.01;

/// Minimum and maximum number of flats around the axis.
const FLATS: [usize; 2] = [24, 360];

/// Maximum number of triangles; a part with very many corners gets fewer flats.
const MAX_TRIANGLES: usize = 1_500_000;

/// Coordinates are rounded to this step, mm, so that equal corners stay equal in the 32-bit numbers of the
/// file.
const STEP: f64 = 1e-4;

/// Three points in mm, counter-clockwise as seen from outside.
pub type Triangle = [[f64; 3]; 3];

/// Writes the file; `None` if nothing is left of the blank.
pub fn stl(region: &Region) -> Option<Vec<u8>> {
    let triangles = triangles(region);
    if triangles.is_empty() {
        return None;
    }
    let mut file = Vec::with_capacity(84 + 50 * triangles.len());
    // An 80-byte header with any text that does not begin with "solid", which marks a text STL.
    file.extend_from_slice(format!("{:<80}", "gcode-playground: turned part, mm").as_bytes());
    file.extend_from_slice(&(triangles.len() as u32).to_le_bytes());
    for triangle in &triangles {
        for place in [normal(triangle)].iter().chain(triangle) {
            for &value in place {
                file.extend_from_slice(&(value as f32).to_le_bytes());
            }
        }
        file.extend_from_slice(&[0, 0]);
    }
    Some(file)
}

/// The surface mesh.
pub fn triangles(region: &Region) -> Vec<Triangle> {
    let outlines: Vec<Vec<Point>> = region.outlines().map(|outline| rounded(outline.collect())).collect();
    let flats = flats(&outlines);
    // A regular polygon with this circumradius has the area of the unit circle.
    let flat = TAU / flats as f64;
    let mean = (flat / flat.sin()).sqrt();
    let around: Vec<(f64, f64)> =
        (0..=flats).map(|flat| (TAU * (flat % flats) as f64 / flats as f64).sin_cos()).collect();
    let place = |at: Point, (sin, cos): (f64, f64)| [mean * at.x * cos, mean * at.x * sin, at.z];
    let mut triangles = Vec::new();
    for outline in &outlines {
        let next = outline.iter().cycle().skip(1);
        for (&a, &b) in outline.iter().zip(next) {
            for sides in around.windows(2) {
                let [a0, a1, b0, b1] =
                    [(a, 0), (a, 1), (b, 0), (b, 1)].map(|(at, side)| place(at, sides[side]));
                // A corner on the axis is a single point for all flats.
                if a.x > 0.0 {
                    triangles.push([a0, b0, a1]);
                }
                if b.x > 0.0 {
                    triangles.push([a1, b0, b1]);
                }
            }
        }
    }
    triangles
}

/// The number of flats that keeps the deviation within [`FLATNESS`].
fn flats(outlines: &[Vec<Point>]) -> usize {
    let corners: usize = outlines.iter().map(Vec::len).sum();
    let radius = outlines.iter().flatten().fold(0.0, |radius: f64, point| radius.max(point.x));
    let wanted = PI / (1.0 - FLATNESS / radius.max(FLATNESS)).acos();
    let most = (MAX_TRIANGLES / (2 * corners.max(1))).clamp(FLATS[0], FLATS[1]);
    (wanted.ceil() as usize).clamp(FLATS[0], most)
}

fn rounded(mut outline: Vec<Point>) -> Vec<Point> {
    for point in &mut outline {
        let round = |value: f64| (value / STEP).round() * STEP;
        *point = Point::new(round(point.x).max(0.0), round(point.z));
    }
    outline.dedup();
    while outline.len() > 1 && outline.first() == outline.last() {
        outline.pop();
    }
    outline
}

fn normal([a, b, c]: &Triangle) -> [f64; 3] {
    let way = |to: &[f64; 3]| [to[0] - a[0], to[1] - a[1], to[2] - a[2]];
    let (u, v) = (way(b), way(c));
    let across = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    let length = across.iter().map(|value| value * value).sum::<f64>().sqrt().max(f64::MIN_POSITIVE);
    across.map(|value| value / length)
}
