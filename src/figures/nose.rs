//! The figure of the tool nose: the imaginary tip P, the centre C, and the error on a taper without compensation.
//!
//! In: the motions and the simulation of a run. Out: a detail at the first compensated taper.

use crate::geometry::Point;
use crate::machine::SimulationResult;
use crate::motion::{Motion, Motions};
use crate::scene::annotation::{Annotation, Detail, Measure, Shape};
use crate::scene::surface_moves::circle;

/// The nose at the middle of the first taper that a tool for outside turning cuts with G41 or G42. Without
/// compensation P moves along the programmed line, and the nose cuts a parallel line. `Δ` is their distance along X,
/// on the radius. `None` without a taper, or if the nose radius is not known.
pub fn of_nose(simulation: &SimulationResult, motions: &Motions) -> Option<Annotation> {
    let oblique = |motion: &Motion| {
        let (x, z) = (motion.to.x - motion.from.x, motion.to.z - motion.from.z);
        motion.kind.cuts() && motion.arc().is_none() && x.abs() > 1e-3 && z.abs() > 1e-3
    };
    // Its nose is above and to the right of its tip.
    let turns_outside = |motion: &Motion| simulation.resolved_setup().tool(motion).tool.tip_direction() == 3;
    let all = (0..motions.len()).map(|index| motions.get_on_workpiece(index)).filter(turns_outside);
    let (taper, motion) =
        all.filter_map(|motion| Some((motion.as_programmed()?, motion))).find(|(own, _)| oblique(own))?;
    let tool = simulation.resolved_setup().tool(&motion);
    let radius = Some(tool.shape.nose).filter(|radius| *radius > 0.0)?;
    let tip = Point::new((taper.from.x + taper.to.x) / 2.0, (taper.from.z + taper.to.z) / 2.0);
    let center = Point::new(tip.x + radius, tip.z + radius);
    let (x, z) = (taper.to.x - taper.from.x, taper.to.z - taper.from.z);
    let slope = x / z;
    // The line through P is this far below the tangent of the circle along X.
    let error = radius * (1.0 - slope - (1.0 + slope * slope).sqrt());
    let at = |z: f64| tip.x + slope * (z - tip.z);
    let span = [tip.z - 2.0 * radius, tip.z + 3.5 * radius];
    let programmed = span.map(|z| Point::new(at(z), z)).to_vec();
    let cut = span.map(|z| Point::new(at(z) + error, z)).to_vec();
    let mut circle: Vec<Point> = circle(radius).into_iter().map(|corner| corner.moved(center)).collect();
    circle.extend_from_within(..1);
    let measured = vec![Point::new(center.x, tip.z), tip, Point::new(tip.x, center.z)];
    let side = tip.z + 2.8 * radius;
    let (sin, cos) = 45f64.to_radians().sin_cos();
    let on = Point::new(center.x + radius * sin, center.z + radius * cos);
    let annotations = vec![
        Annotation::point(tip, "P"),
        Annotation::point(center, "C"),
        Annotation::dimension(Shape::Radius { center, on }, "r", Measure::Length(radius)),
        Annotation::dimension(
            Shape::Radial([Point::new(at(side), side), Point::new(at(side) + error, side)]),
            "Δ",
            Measure::Length(error.abs()),
        ),
    ];
    let lines = vec![programmed, cut, circle, measured];
    Some(Annotation::detail(Detail {
        at: tip,
        radius: 2.0 * radius,
        lines,
        annotations,
        ..Detail::default()
    }))
}
