//! The other views of the picture: the end face on a canvas of its own, the turret's side, the dimensions of an edge, and the
//! part laid over one that was kept.
//!
//! In: what the user does with them. Out: drawn canvases and small objects. Knows no G-code.

use wasm_bindgen::prelude::*;
use web_sys::{ImageBitmap, OffscreenCanvas};

use super::{Drawn, Playground, REACH, to_js};
use crate::api;
use crate::geometry::Point;
use crate::scene::camera::{Pixel, Size};
use crate::scene::canvas::Painter;
use crate::scene::pick::pick;
use crate::setup::Turret;

#[wasm_bindgen]
impl Playground {
    /// Draws the end face on a canvas from now on.
    #[wasm_bindgen(js_name = attachFaceCanvas)]
    pub fn attach_face_canvas(&mut self, canvas: OffscreenCanvas) -> Result<(), JsValue> {
        self.face_painter = Some(Painter::new(canvas)?);
        Ok(())
    }

    /// Whether anything moves on the end face; known once all material is off.
    #[wasm_bindgen(js_name = hasFace)]
    pub fn has_face(&self) -> bool {
        self.current.face().is_some()
    }

    /// Size of the picture of the face in CSS pixels, and device pixels a CSS pixel.
    #[wasm_bindgen(js_name = resizeFace)]
    pub fn resize_face(&mut self, width: f64, height: f64, pixel_ratio: f64) {
        self.current.look_at_face(|view, scene| view.resize(scene, Size { width, height }, pixel_ratio));
    }

    /// Shows all of the face.
    #[wasm_bindgen(js_name = fitFace)]
    pub fn fit_face(&mut self) {
        self.current.look_at_face(|view, scene| view.fit(scene));
    }

    /// Moves the picture of the face, CSS pixels.
    #[wasm_bindgen(js_name = panFace)]
    pub fn pan_face(&mut self, dx: f64, dy: f64) {
        self.current.look_at_face(|view, _| view.pan(dx, dy));
    }

    /// Makes the picture of the face `factor` times as large about a place, CSS pixels.
    #[wasm_bindgen(js_name = zoomFace)]
    pub fn zoom_face(&mut self, factor: f64, x: f64, y: f64) {
        self.current.look_at_face(|view, _| view.zoom(factor, Pixel::new(x, y)));
    }

    /// The stroke at a place of the picture of the face, CSS pixels.
    #[wasm_bindgen(js_name = pickOnFace, unchecked_return_type = "Stroke | undefined")]
    pub fn pick_on_face(&mut self, x: f64, y: f64) -> Result<JsValue, JsValue> {
        let (Some(face), view) = (self.current.face(), self.current.face_view()) else {
            return Ok(JsValue::UNDEFINED);
        };
        let found = pick(&face.scene(None), view.camera(), Pixel::new(x, y), REACH, &view.highlight)
            .and_then(|found| Some((face.motion(found.stroke.motion)?, found.at)));
        match found {
            // Told as in the section: there the tool stands at a diameter and a Z.
            Some((motion, at)) => {
                let z = self.current.motions().get(motion).to.z;
                self.stroke(motion, Point::new(at.x.hypot(at.z), z))
            }
            None => Ok(JsValue::UNDEFINED),
        }
    }

    /// Where a place is in the picture of the face: X a diameter, C in mm; two CSS pixels from the top left corner.
    #[wasm_bindgen(js_name = screenOfFace)]
    pub fn screen_of_face(&mut self, x: f64, c: f64) -> Vec<f64> {
        let pixel = self.current.face_view().camera().to_screen(Point::new(c, x / 2.0));
        vec![pixel.x, pixel.y]
    }

    /// Paints what has changed of the face, and says when to call again.
    #[wasm_bindgen(js_name = drawFace)]
    pub fn draw_face(&mut self) -> Result<Drawn, JsValue> {
        match (self.current.face_picture(), &mut self.face_painter) {
            (Some(picture), Some(painter)) => Ok(painter.draw(&picture)?.into()),
            _ => Ok(Drawn::All),
        }
    }

    /// Takes what was painted of the face since the last time off its canvas, as an image; nothing where nothing was.
    #[wasm_bindgen(js_name = takeFaceImage)]
    pub fn take_face_image(&mut self) -> Result<Option<ImageBitmap>, JsValue> {
        self.face_painter.as_mut().map_or(Ok(None), Painter::take_image)
    }

    /// Puts the turret in `front` of the spindle, where the worker stands, or to the `rear`; X+ is drawn on its side.
    /// Anything else leaves it where the setup has it.
    #[wasm_bindgen(js_name = setTurret)]
    pub fn set_turret(&mut self, side: &str) {
        self.current.set_turret(match side {
            "front" => Some(Turret::Front),
            "rear" => Some(Turret::Rear),
            _ => None,
        });
    }

    /// Which side the turret is drawn on.
    #[wasm_bindgen(unchecked_return_type = "'front' | 'rear'")]
    pub fn turret(&self) -> JsValue {
        JsValue::from_str(match self.current.turret() {
            Turret::Front => "front",
            Turret::Rear => "rear",
        })
    }

    /// The edge of the part at a place of the picture, CSS pixels, with its dimensions; it is marked until another is asked for.
    #[wasm_bindgen(unchecked_return_type = "Dimension | undefined")]
    pub fn dimension(&mut self, x: f64, y: f64) -> Result<JsValue, JsValue> {
        let edge = self.current.mark_edge(Pixel::new(x, y), REACH);
        edge.map_or(Ok(JsValue::UNDEFINED), |feature| to_js(&api::Dimension::new(&feature)))
    }

    /// Marks no edge any more.
    #[wasm_bindgen(js_name = leaveEdge)]
    pub fn leave_edge(&mut self) {
        self.current.leave_edge();
    }

    /// Keeps the part of this program, if there is one, to lay those of later texts over it.
    pub fn keep(&mut self) {
        self.current.keep();
    }

    /// Ends the comparison.
    #[wasm_bindgen(js_name = endComparison)]
    pub fn end_comparison(&mut self) {
        self.current.end_comparison();
    }

    /// Where the part differs from the one that was kept (`first`); nothing while none is.
    #[wasm_bindgen(unchecked_return_type = "Comparison | undefined")]
    pub fn comparison(&self) -> Result<JsValue, JsValue> {
        match self.current.comparison() {
            Some(comparison) => to_js(&api::Comparison::new(comparison)),
            None => Ok(JsValue::UNDEFINED),
        }
    }
}
