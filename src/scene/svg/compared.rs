//! Draws the differences of two parts: each in its colour and with its own hatching, with a legend.

use crate::geometry::Point;
use crate::machine::compare::Side;

use super::super::Scene;
use super::super::camera::Pixel;
use super::super::hatch::{Slant, hatch_slanted};
use super::caption::escaped;
use super::{Drawing, number, pixel, polylines};

/// Distance between lines of the legend, CSS pixels.
const LEADING: f64 = 20.0;

impl Drawing {
    /// Draws the areas that only one of two parts has.
    pub(super) fn compared(&mut self, scene: &Scene) {
        let Some(compared) = scene.work().and_then(|work| work.compared.as_ref()) else { return };
        for (outlines, side) in compared.iter().zip([Side::First, Side::Second]) {
            let (name, slant) = look(side);
            for upper in scene.plane().sides() {
                let place = |at: &Point| self.camera.to_screen(Point::new(upper * at.x, at.z));
                let pieces: Vec<Vec<Pixel>> =
                    outlines.iter().map(|outline| outline.iter().map(place).collect()).collect();
                let zero = self.camera.to_screen(Point::default());
                let lines = hatch_slanted(&pieces, zero, self.camera.size(), slant);
                let hatching: String =
                    lines.iter().map(|[a, b]| format!("M{}L{}", pixel(*a), pixel(*b))).collect();
                for (class, d) in [("", polylines(&pieces, "Z")), (" hatch", hatching)] {
                    if !d.is_empty() {
                        self.line(&format!(r#"<path class="only {name}{class}" d="{d}"/>"#));
                    }
                }
            }
        }
    }

    /// Draws the legend of the colours, in the upper right corner.
    pub(super) fn legend(&mut self, entries: &[(Side, String)]) {
        let right = self.camera.size().width - 12.0;
        for (index, (side, text)) in entries.iter().enumerate() {
            let y = 20.0 + LEADING * index as f64;
            let (name, _) = look(*side);
            let (x, top) = (number(right - 12.0), number(y - 10.0));
            self.line(&format!(
                r#"<rect class="only {name}" x="{x}" y="{top}" width="12" height="12"/><text class="legend" x="{}" y="{}">{}</text>"#,
                number(right - 20.0),
                number(y),
                escaped(text),
            ));
        }
    }
}

/// The class of a side, and the direction of its hatching.
fn look(side: Side) -> (&'static str, Slant) {
    match side {
        Side::First => ("first", Slant::Falling),
        Side::Second => ("second", Slant::Rising),
    }
}
