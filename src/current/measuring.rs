//! Measuring in the section.
//!
//! In: the positions that the user picks, CSS pixels. Out: a [`Measurement`], and its annotations in the view. The
//! next run forgets what was picked.

use crate::figures::measure::{self, Measured, Picked};
use crate::geometry::bounds::Bounds;
use crate::machine::feature::{self, Feature, Shape};
use crate::scene::camera::Pixel;

use super::Current;

/// The result of a pick.
#[derive(Clone, Debug, PartialEq)]
pub enum Measurement {
    /// One place: a corner or an edge, and the feature of the part at that edge.
    One(Picked, Option<Feature>),
    /// Two places.
    Two(Measured),
}

impl Current {
    /// Begins or ends measuring; nothing is picked then.
    pub fn set_measuring(&mut self, measures: bool) {
        self.view_state.picked.clear();
        self.view_state.section_mut().measured = measures.then(Vec::new);
    }

    /// Picks the corner or edge within `reach` of a position, both in CSS pixels, as the first or the second place.
    /// A position without either clears both places. While a tool is shown, only strokes can be picked.
    pub fn measure_at(&mut self, at: Pixel, reach: f64) -> Option<Measurement> {
        let camera = *self.view_state.section().camera();
        let (place, reach_mm) = (camera.to_world(at), reach / camera.scale());
        let machined = self.machined().filter(|_| self.view_state.section().playhead.is_none());
        let side = if place.x < 0.0 { -1.0 } else { 1.0 };
        let part = machined.and_then(|machined| Some((machined.part_on(side)?, machined.threads())));
        let features: Vec<Feature> = part
            .map_or_else(Vec::new, |(part, threads)| feature::all(part, threads))
            .into_iter()
            .map(|feature| feature.as_programmed(self.run.motions()))
            .collect();
        let lines = measure::lines(&features, &self.scene(), Bounds::of(place).grown(reach_mm));
        let picked = measure::pick(lines.into_iter(), place, reach_mm);
        if picked.is_none() || self.view_state.picked.len() == 2 {
            self.view_state.picked.clear();
        }
        self.view_state.picked.extend(picked);
        let (result, annotations) = match &self.view_state.picked[..] {
            [one, other] => {
                (Measurement::Two(measure::between(one, other)), measure::annotations(one, other))
            }
            [one] => {
                let one = *one;
                let feature = one.edge.and_then(|_| self.mark_edge(at, reach));
                let feature = feature.filter(|feature| feature.shape != Shape::Across);
                let annotations = measure::annotations_of_one(&one, feature.as_ref());
                (Measurement::One(one, feature), annotations)
            }
            _ => {
                self.view_state.section_mut().measured = Some(Vec::new());
                return None;
            }
        };
        self.view_state.section_mut().measured = Some(annotations);
        Some(result)
    }
}
