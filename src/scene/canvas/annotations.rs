//! Draws the annotations of a picture: the same lines and labels as in the SVG file.

use wasm_bindgen::JsValue;

use super::super::Scene;
use super::super::camera::Pixel;
use super::super::clip::Piece;
use super::super::occupied::{Occupied, Rectangle};
use super::super::placement::{DOT, END, FONT_SIZE, place};
use super::super::view::View;
use super::Painter;
use super::pen::{Dash, Text};

impl Painter {
    /// Draws the measurement over the strokes, or the annotations unless a tool is shown.
    pub(super) fn annotations(&self, scene: &Scene, view: &View) -> Result<(), JsValue> {
        let annotations = match &view.measured {
            Some(measured) => measured,
            None if view.playhead.is_some() => return Ok(()),
            None => &view.annotations,
        };
        if annotations.is_empty() {
            return Ok(());
        }
        let (pen, camera, colour) = (&self.screen, view.camera(), &view.palette.tool);
        let occupied = Occupied::of(scene, camera, scene.strokes().map(|stroke| stroke.shape));
        let placed = place(annotations, &occupied, camera, view.scale.unit);
        pen.page(view)?;
        let clipped = |lines: &[Vec<Pixel>]| -> Vec<Piece> {
            lines.iter().flat_map(|line| super::clip::polyline(line, camera.size())).collect()
        };
        let part = &view.palette.part_edge;
        pen.opacity(0.35);
        pen.lines(part, 1.0, placed.hatch.iter().copied());
        pen.opacity(1.0);
        pen.polylines(part, &clipped(&placed.edges), 1.5, Dash::Solid)?;
        pen.polylines(colour, &clipped(&placed.lines), 1.0, Dash::Solid)?;
        pen.fill(colour, placed.heads.iter().map(|head| &head[..]));
        pen.dots(colour, placed.dots.iter().copied(), DOT)?;
        pen.dots(colour, placed.ends.iter().copied(), END)?;
        let font = format!("600 {FONT_SIZE}px system-ui, sans-serif");
        for label in &placed.labels {
            let Rectangle { min, max } = label.area;
            pen.opacity(0.85);
            pen.block(&view.palette.background, min, max);
            pen.opacity(1.0);
            let text = Text { text: &label.text, font: &font, align: "center", baseline: "middle" };
            let middle = label.area.middle();
            pen.write(&text, Pixel::new(middle.x, middle.y + 1.0), colour)?;
        }
        Ok(())
    }
}
