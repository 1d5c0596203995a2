//! The drawing of the wanted part of an exercise, with its tolerances.
//!
//! In: the target, which no program has made, and its blank. Out: the part with its dimensions. A tolerance that differs
//! from the general one is at its dimension; the general one is below the drawing. Must not know how an answer is checked.

use super::file::caption;
use crate::exercise::{Edge, Exercise, Size, Target, Tolerance};
use crate::figures;
use crate::geometry::Point;
use crate::machine::SimulationResult;
use crate::motion::Motions;
use crate::scene::Scene;
use crate::scene::annotation::{Annotation, Measure, Shape};
use crate::scene::path_index::PathIndex;
use crate::scene::svg::{Contents, SvgOptions, svg};
use crate::scene::work::Work;
use crate::sentences::Language;
use crate::sentences::exercise::general_tolerance;
use crate::units::Diameter;

/// Two places closer than this are one, mm.
const SAME_PLACE: f64 = 0.005;

/// The drawing; `None` if the setup has no blank.
pub fn drawing(exercise: &Exercise, options: SvgOptions, language: Language) -> Option<String> {
    let Exercise { target, setup, tolerance, .. } = exercise;
    let motions = Motions::default();
    let simulation = SimulationResult::of(&motions, setup);
    let work = Work::of(&simulation, &motions, None)?.with_part(&target.region);
    let path_index = PathIndex::of(&motions);
    let scene = Scene::new(&motions, &path_index, Some(&work));
    let annotations = dimensions(target, *tolerance);
    let caption = Some(caption(general_tolerance(*tolerance, language), language));
    Some(svg(&scene, &SvgOptions { annotations, contents: Contents::Part, caption, ..options }))
}

/// The dimensions of the target: threads by name, and each size with its own tolerance. `general`: the tolerance of the
/// other sizes.
fn dimensions(target: &Target, general: Tolerance) -> Vec<Annotation> {
    let mut all = figures::of_part(&target.region, &[], &Motions::default());
    for annotation in &mut all {
        let Some((edge, tolerance)) = measured(annotation, target) else { continue };
        if let Some(thread) = edge.thread {
            let [nominal, lead] = [Diameter::from_radius(edge.from.x).mm(), thread.lead];
            annotation.shape = Shape::Note(edge.middle());
            annotation.label.value = Some(Measure::Thread(nominal, lead));
        } else if tolerance != general {
            annotation.label.deviations = Some([tolerance.lower, tolerance.upper]);
        }
    }
    all
}

/// The edge whose size a dimension is, and the tolerance of this size; `None` if it is not measured.
fn measured<'a>(dimension: &Annotation, target: &'a Target) -> Option<(&'a Edge, Tolerance)> {
    let has_end = |edge: &Edge, at: Point| [edge.from, edge.to].iter().any(|end| is_near(*end, at));
    let is_angle = matches!(dimension.label.value, Some(Measure::Degrees(_)));
    let is_own = |edge: &&Edge| match (edge.size(), &dimension.shape) {
        (Size::Diameter, Shape::DiameterThrough(at)) => is_near(edge.middle(), *at),
        (Size::Taper, Shape::Diameter(at)) => has_end(edge, *at),
        (Size::Length, Shape::Axial([_, end])) => (edge.from.z - end.z).abs() < SAME_PLACE,
        (Size::Radius, Shape::Radius { on, .. }) => edge.distance(*on) < SAME_PLACE,
        (Size::Taper, Shape::Note(at)) => is_angle && is_near(edge.middle(), *at),
        _ => false,
    };
    let edge = target.edges.iter().filter(|edge| !edge.is_free).find(is_own)?;
    Some((edge, if is_angle { edge.angle } else { edge.tolerance }))
}

fn is_near(a: Point, b: Point) -> bool {
    a.distance(b) < SAME_PLACE
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A line of the target has the tolerance of the edge that ends there: Z-20 that of Ø26, X30 that of the shoulder at
    /// 20. Ø30 and 40 have the general tolerance of ±0.1.
    #[test]
    fn a_size_with_its_own_tolerance_shows_it() {
        let file = "---\nid: own\nkind: write\n---\n\n```setup\n(STOCK D=60 LENGTH=70 FACE=0 GRIP=15)\n```\n\n```target\n\
            X0 Z0\nX26 ±0.1\nZ-20 ±0.05\nX30 +0.02 -0.01\nZ-40 ±0.1\nX60 ±0.1\nZ-50 free\n```\n\n# en: A shaft\n\nTurn it.\n";
        let exercise = Exercise::read(file).expect("an exercise");
        let texts: Vec<String> = dimensions(&exercise.target, exercise.tolerance)
            .iter()
            .map(|own| own.label.text(crate::units::Unit::Millimetre))
            .collect();
        for text in ["Ø26 ±0.05", "20 +0.02 −0.01", "Ø30", "40"] {
            assert!(texts.contains(&text.to_owned()), "{text} in {texts:?}");
        }
    }
}
