//! Writes the annotations of a picture.
//!
//! In: annotations at their places. Out: one group with lines, arrow heads, dots and labels.

use std::fmt::Write;

use super::super::Scene;
use super::super::occupied::{Occupied, Rectangle};
use super::super::palette::Palette;
use super::super::placement::{DOT, END, place};
use super::caption::escaped;
use super::{Contents, Drawing, SvgOptions, drawn, number, pixel, polylines};
use crate::geometry::{Point, extent};

/// Style rules of annotations.
pub(super) const SHAPES: &str = "\
.lathe .annotations .dimension { stroke-width: 0.75 }
.lathe .annotations text { font-weight: 600; text-anchor: middle; paint-order: stroke; stroke-width: 4; stroke-linejoin: round }";

/// The colours of annotations as style rules.
pub(super) fn colours(palette: &Palette) -> String {
    let Palette { tool, background, .. } = palette;
    format!(
        ".lathe .annotations .dimension {{ stroke: {tool} }}
.lathe .annotations .head, .lathe .annotations text {{ fill: {tool} }}
.lathe .annotations text {{ stroke: {background} }}"
    )
}

impl Drawing {
    /// Draws annotations over the strokes; their labels cover no stroke.
    pub(super) fn annotations(&mut self, scene: &Scene, options: &SvgOptions) {
        if options.annotations.is_empty() {
            return;
        }
        // The annotations are at the strokes as they are drawn.
        let mut annotations = options.annotations.clone();
        for annotation in &mut annotations {
            annotation.shape = self.apart.annotated(scene, &annotation.shape);
        }
        let strokes = drawn(scene, options).map(|stroke| self.apart.directed(&stroke));
        let camera = &self.camera;
        let occupied = match options.contents {
            Contents::All if options.is_figure() => {
                Occupied::of_strokes(camera, strokes).with_part(scene, camera).with_blank(scene, camera)
            }
            Contents::All => Occupied::of(scene, camera, strokes),
            Contents::Part => Occupied::of_strokes(camera, std::iter::empty()).with_part(scene, camera),
        };
        let placed = place(&annotations, &occupied, &self.camera, options.scale.unit);
        let axis = self.camera.to_screen(Point::default()).y;
        self.down = extent([occupied.down(), placed.down()].into_iter().flatten().flatten().chain([axis]));
        let mut heads = String::new();
        for [tip, a, b] in &placed.heads {
            let _ = write!(heads, "M{}L{}L{}Z", pixel(*tip), pixel(*a), pixel(*b));
        }
        for (dots, radius) in [(&placed.dots, DOT), (&placed.ends, END)] {
            for dot in dots {
                let (x, y, width) = (number(dot.x - radius), number(dot.y), 2.0 * radius);
                let _ = write!(
                    heads,
                    "M{x} {y}a{radius} {radius} 0 1 0 {width} 0a{radius} {radius} 0 1 0 -{width} 0"
                );
            }
        }
        self.line(r#"<g class="annotations">"#);
        let hatch: String =
            placed.hatch.iter().map(|[a, b]| format!("M{}L{}", pixel(*a), pixel(*b))).collect();
        for (class, d) in [("hatch", hatch), ("part-edge", polylines(&placed.edges, ""))] {
            if !d.is_empty() {
                self.line(&format!(r#"<path class="{class}" d="{d}"/>"#));
            }
        }
        self.line(&format!(r#"<path class="dimension" d="{}"/>"#, polylines(&placed.lines, "")));
        if !heads.is_empty() {
            self.line(&format!(r#"<path class="head" d="{heads}"/>"#));
        }
        // Lines under a label have a gap.
        let mut gaps = String::new();
        for Rectangle { min, max } in placed.labels.iter().map(|label| label.area) {
            let _ = write!(gaps, "M{}H{}V{}H{}Z", pixel(min), number(max.x), number(max.y), number(min.x));
        }
        if !gaps.is_empty() {
            self.line(&format!(r#"<path class="background" d="{gaps}"/>"#));
        }
        for label in &placed.labels {
            let middle = label.area.middle();
            let (x, y) = (number(middle.x), number(middle.y + 4.0));
            self.line(&format!(r#"<text x="{x}" y="{y}">{}</text>"#, escaped(&label.text)));
        }
        self.line("</g>");
    }
}
