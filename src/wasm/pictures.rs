//! The pictures: the section along the spindle axis, the end face and the side, each with a separate canvas
//! and view.
//!
//! In: user actions in a picture. Out: drawn canvases and small objects. Knows no G-code.

use wasm_bindgen::prelude::*;
use web_sys::{ImageBitmap, OffscreenCanvas};

use super::picture_name::PictureName;
use super::{Playground, error, to_js};
use crate::api;
use crate::current::Current;
use crate::geometry::Point;
use crate::machine::compare::Comparison;
use crate::parts::late;
use crate::scene::Plane;
use crate::scene::camera::{Pixel, Size};
use crate::scene::canvas::{Painter, Progress};
use crate::scene::palette::Palette;
use crate::scene::view::Frame;
use crate::setup::Turret;
use crate::units::Diameter;

/// Maximum distance of the pointer from a stroke or an edge, CSS pixels.
const REACH: f64 = 8.0;

/// How much of a picture has been painted.
#[wasm_bindgen]
#[derive(Clone, Copy, Debug)]
pub enum Drawn {
    /// The whole picture.
    All,
    /// A part; the next call continues.
    Part,
    /// The previous image was moved with the camera; call again in the next frame.
    Moved,
}

impl From<Progress> for Drawn {
    fn from(progress: Progress) -> Self {
        match progress {
            Progress::Done => Self::All,
            Progress::InProgress => Self::Part,
            Progress::Waiting => Self::Moved,
        }
    }
}

#[wasm_bindgen]
impl Playground {
    /// Sets the canvas of a picture.
    #[wasm_bindgen(js_name = attachCanvas)]
    pub fn attach_canvas(&mut self, picture: PictureName, canvas: OffscreenCanvas) -> Result<(), JsValue> {
        self.painters[picture.into()] = Some(Painter::new(canvas)?);
        Ok(())
    }

    /// Sets the size of a picture in CSS pixels, and the number of device pixels per CSS pixel.
    pub fn resize(&mut self, picture: PictureName, width: f64, height: f64, pixel_ratio: f64) {
        self.current
            .look(picture.into(), |view, scene| view.resize(scene, Size { width, height }, pixel_ratio));
    }

    /// Sets the colours of the pictures.
    #[wasm_bindgen(js_name = setPalette)]
    pub fn set_palette(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "Palette")] colours: JsValue,
    ) -> Result<(), JsValue> {
        let palette = palette(&colours)?;
        // The other pictures follow the section.
        self.current.look(Plane::Section, |view, _| view.palette = palette);
        Ok(())
    }

    /// Paints the next images even if they are unchanged, because the last ones were not shown.
    #[wasm_bindgen(js_name = paintAgain)]
    pub fn paint_again(&mut self) {
        self.painters.iter_mut().flatten().for_each(Painter::force_repaint);
    }

    /// Releases the memory cached for the next images; they are painted from scratch.
    #[wasm_bindgen(js_name = releaseImages)]
    pub fn release_images(&mut self) {
        self.painters.iter_mut().flatten().for_each(Painter::release);
    }

    /// Fits a picture to its contents.
    pub fn fit(&mut self, picture: PictureName) {
        self.current.look(picture.into(), |view, scene| view.fit(scene));
    }

    /// Sets the extent of a fitted picture: the `cuts`, the `part` or the whole `path`; anything else selects
    /// the default.
    #[wasm_bindgen(js_name = setFrame)]
    pub fn set_frame(&mut self, frame: &str) {
        let frame = match frame {
            "cuts" => Frame::Cuts,
            "part" => Frame::Part,
            "path" => Frame::Path,
            _ => Frame::Usual,
        };
        for plane in Plane::ALL {
            self.current.look(plane, |view, scene| view.set_frame(scene, frame));
        }
    }

    /// Moves a picture by a distance in CSS pixels.
    pub fn pan(&mut self, picture: PictureName, dx: f64, dy: f64) {
        self.current.look(picture.into(), |view, _| view.pan(dx, dy));
    }

    /// Zooms a picture by `factor` about a position in CSS pixels.
    pub fn zoom(&mut self, picture: PictureName, factor: f64, x: f64, y: f64) {
        self.current.look(picture.into(), |view, _| view.zoom(factor, Pixel::new(x, y)));
    }

    /// The stroke at a position in a picture, CSS pixels.
    #[wasm_bindgen(unchecked_return_type = "Stroke | undefined")]
    pub fn pick(&mut self, picture: PictureName, x: f64, y: f64) -> Result<JsValue, JsValue> {
        picked(self, picture.into(), Pixel::new(x, y))
    }

    /// Converts a position to CSS pixels from the top left corner of a picture; returns two numbers. The
    /// position is X (a diameter) and Z in the section, X (a diameter) and C on the face, and on the side Z
    /// and the value on its other ruler: degrees of C, or Y. Lengths are mm.
    #[wasm_bindgen(js_name = screenOf)]
    pub fn screen_of(&mut self, picture: PictureName, first: f64, second: f64) -> Vec<f64> {
        let plane = Plane::from(picture);
        let at = match plane {
            Plane::Section => Point::new(Diameter::new(first).radius(), second),
            Plane::Face => Point::new(second, Diameter::new(first).radius()),
            Plane::Side => on_side(&self.current, first, second),
        };
        let mut pixel = Pixel::new(0.0, 0.0);
        self.current.look(plane, |view, _| pixel = view.camera().to_screen(at));
        vec![pixel.x, pixel.y]
    }

    /// Paints the changes of a picture, and returns when to call again.
    pub fn draw(&mut self, picture: PictureName) -> Result<Drawn, JsValue> {
        let plane = picture.into();
        match (self.current.picture(plane), &mut self.painters[plane]) {
            (Some(picture), Some(painter)) => Ok(painter.draw(&picture)?.into()),
            _ => Ok(Drawn::All),
        }
    }

    /// Takes the image painted since the last call off the canvas of a picture; `undefined` if nothing was
    /// painted.
    #[wasm_bindgen(js_name = takeImage)]
    pub fn take_image(&mut self, picture: PictureName) -> Result<Option<ImageBitmap>, JsValue> {
        self.painters[picture.into()].as_mut().map_or(Ok(None), Painter::take_image)
    }

    /// Whether anything moves over the surface that a picture shows; known once all material is removed.
    pub fn has(&self, picture: PictureName) -> bool {
        self.current.moves(picture.into()).is_some()
    }

    /// What the pictures show besides strokes, known once all material is removed: `blank`, `chuck`,
    /// `tailstock`, `collision`.
    #[wasm_bindgen(js_name = workShown, unchecked_return_type = "('blank' | 'chuck' | 'tailstock' | 'collision')[]")]
    pub fn work_shown(&self) -> Result<JsValue, JsValue> {
        work_shown(&self.current)
    }

    /// Puts the turret in `front` of the spindle, on the side of the operator, or to the `rear`; X+ is drawn
    /// on that side. Anything else selects the side in the setup.
    #[wasm_bindgen(js_name = setTurret)]
    pub fn set_turret(&mut self, side: &str) {
        self.current.set_turret(match side {
            "front" => Some(Turret::Front),
            "rear" => Some(Turret::Rear),
            _ => None,
        });
    }

    /// The side on which the turret is drawn.
    #[wasm_bindgen(unchecked_return_type = "'front' | 'rear'")]
    pub fn turret(&self) -> JsValue {
        JsValue::from_str(match self.current.turret() {
            Turret::Front => "front",
            Turret::Rear => "rear",
        })
    }

    /// The edge of the part at a position in the picture, CSS pixels, with its dimensions. The edge stays
    /// marked until the next call.
    #[wasm_bindgen(unchecked_return_type = "Dimension | undefined")]
    pub fn dimension(&mut self, x: f64, y: f64) -> Result<JsValue, JsValue> {
        dimension(self, Pixel::new(x, y))
    }

    /// Removes the mark from the edge.
    #[wasm_bindgen(js_name = leaveEdge)]
    pub fn leave_edge(&mut self) {
        self.current.leave_edge();
    }

    /// Begins or ends measuring.
    #[wasm_bindgen(js_name = setMeasuring)]
    pub fn set_measuring(&mut self, measures: bool) {
        self.current.set_measuring(measures);
    }

    /// Picks the corner or edge at a position in the section, CSS pixels, as the first or second place to
    /// measure. `undefined` if there is none.
    #[wasm_bindgen(js_name = measureAt, unchecked_return_type = "Measurement | undefined")]
    pub fn measure_at(&mut self, x: f64, y: f64) -> Result<JsValue, JsValue> {
        measure_at(self, Pixel::new(x, y))
    }

    /// Keeps the part of this program, if there is one, for comparison with the parts of later texts.
    pub fn keep(&mut self) {
        self.current.keep();
    }

    /// Ends the comparison.
    #[wasm_bindgen(js_name = endComparison)]
    pub fn end_comparison(&mut self) {
        self.current.end_comparison();
    }

    /// The differences between the part and the kept one (`first`); `undefined` if no part is kept.
    #[wasm_bindgen(unchecked_return_type = "Comparison | undefined")]
    pub fn comparison(&self) -> Result<JsValue, JsValue> {
        self.current.comparison().map_or(Ok(JsValue::UNDEFINED), comparison)
    }
}

late! {
    fn work_shown(current: &Current) -> Result<JsValue, JsValue> {
        let Some(simulation) = current.simulation() else { return to_js(&[""; 0]) };
        let [chuck, tailstock] = simulation.has_chuck_and_tailstock();
        let collision = simulation.findings().iter().any(|found| found.danger.has_place());
        let all = [("blank", simulation.blank().is_some()), ("chuck", chuck), ("tailstock", tailstock), ("collision", collision)];
        to_js(&all.into_iter().filter(|(_, shown)| *shown).map(|(name, _)| name).collect::<Vec<_>>())
    }

    fn on_side(current: &Current, z: f64, other: f64) -> Point {
        current.side().map_or(Point::default(), |side| side.point(z, other))
    }

    fn picked(playground: &mut Playground, plane: Plane, at: Pixel) -> Result<JsValue, JsValue> {
        match playground.current.pick(plane, at, REACH) {
            Some((motion, at)) => playground.stroke(motion, at),
            None => Ok(JsValue::UNDEFINED),
        }
    }

    fn dimension(playground: &mut Playground, at: Pixel) -> Result<JsValue, JsValue> {
        let edge = playground.current.mark_edge(at, REACH);
        edge.map_or(Ok(JsValue::UNDEFINED), |feature| to_js(&api::Dimension::new(&feature)))
    }

    fn measure_at(playground: &mut Playground, at: Pixel) -> Result<JsValue, JsValue> {
        let found = playground.current.measure_at(at, REACH);
        found.map_or(Ok(JsValue::UNDEFINED), |found| to_js(&api::Measurement::new(&found)))
    }

    fn comparison(found: &Comparison) -> Result<JsValue, JsValue> {
        to_js(&api::Comparison::new(found))
    }
}

/// Reads the colours given by a page, each a string.
fn palette(colours: &JsValue) -> Result<Palette, JsValue> {
    let mut palette = Palette::default();
    for (key, own) in palette.by_name() {
        let colour = js_sys::Reflect::get(colours, &JsValue::from_str(key))?.as_string();
        let missing = || error(&format!("the palette has no `{key}`"));
        *own = colour.ok_or_else(missing)?.into();
    }
    Ok(palette)
}
