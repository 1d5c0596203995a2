//! The other views of the picture: the end face on a canvas of its own, the turret's side, the dimensions of an edge, and the
//! part laid over one that was kept.
//!
//! In: what the user does with them. Out: drawn canvases and small objects. Knows no G-code.

use wasm_bindgen::prelude::*;
use web_sys::OffscreenCanvas;

use super::{Drawn, Playground, REACH, to_js};
use crate::api;
use crate::control::setup::{Setup, Turret};
use crate::geometry::Point;
use crate::motion::Motions;
use crate::scene::camera::{Pixel, Size, XPlus};
use crate::scene::canvas::{Painter, Progress};
use crate::scene::face::Face;
use crate::scene::outline::Outline;
use crate::scene::pick::pick;
use crate::scene::steps::labels;
use crate::scene::view::View;
use crate::scene::work::{Moment, Work};
use crate::scene::{Place, Scene};
use crate::shop::compare::{Comparison, parts};
use crate::shop::feature::{self, Feature, Thread, threads};
use crate::shop::region::Region;

/// What the other views need to know.
#[derive(Default)]
pub(super) struct Views {
    face: Option<Face>,
    face_view: Option<View>,
    face_work: Option<Work>,
    face_moment: Option<Moment>,
    face_painter: Option<Painter>,
    /// The side the user has turned the turret to; that of the setup where nothing is chosen.
    turret: Option<Turret>,
    /// The finished part and its threads, for dimensions.
    finished: Option<(Region, Vec<Thread>)>,
    kept: Option<Kept>,
    comparison: Option<Comparison>,
}

/// A program whose part was kept for comparison.
struct Kept {
    motions: Motions,
    setup: Setup,
}

#[wasm_bindgen]
impl Playground {
    /// Draws the end face on a canvas from now on.
    #[wasm_bindgen(js_name = attachFaceCanvas)]
    pub fn attach_face_canvas(&mut self, canvas: OffscreenCanvas) -> Result<(), JsValue> {
        self.views.face_painter = Some(Painter::new(canvas)?);
        Ok(())
    }

    /// Whether anything moves on the end face; known once all material is off.
    #[wasm_bindgen(js_name = hasFace)]
    pub fn has_face(&self) -> bool {
        self.views.face.is_some()
    }

    /// Size of the picture of the face in CSS pixels, and device pixels a CSS pixel.
    #[wasm_bindgen(js_name = resizeFace)]
    pub fn resize_face(&mut self, width: f64, height: f64, pixel_ratio: f64) {
        self.with_face_view(|view, scene| view.resize(scene, Size { width, height }, pixel_ratio));
    }

    /// Shows all of the face.
    #[wasm_bindgen(js_name = fitFace)]
    pub fn fit_face(&mut self) {
        self.with_face_view(|view, scene| view.fit(scene));
    }

    /// Moves the picture of the face, CSS pixels.
    #[wasm_bindgen(js_name = panFace)]
    pub fn pan_face(&mut self, dx: f64, dy: f64) {
        self.with_face_view(|view, _| view.pan(dx, dy));
    }

    /// Makes the picture of the face `factor` times as large about a place, CSS pixels.
    #[wasm_bindgen(js_name = zoomFace)]
    pub fn zoom_face(&mut self, factor: f64, x: f64, y: f64) {
        self.with_face_view(|view, _| view.zoom(factor, Pixel::new(x, y)));
    }

    /// The stroke at a place of the picture of the face, CSS pixels.
    #[wasm_bindgen(js_name = pickOnFace, unchecked_return_type = "Stroke | undefined")]
    pub fn pick_on_face(&mut self, x: f64, y: f64) -> Result<JsValue, JsValue> {
        let (Some(face), Some(view)) = (&self.views.face, &self.views.face_view) else {
            return Ok(JsValue::UNDEFINED);
        };
        let found = pick(&face.scene(None), view.camera(), Pixel::new(x, y), REACH, &view.highlight)
            .and_then(|found| Some((face.motion(found.stroke.motion)?, found.at)));
        match found {
            // Told as in the section: there the tool stands at a diameter and a Z.
            Some((motion, at)) => {
                self.stroke(motion, Point::new(at.x.hypot(at.z), self.run.motions().get(motion).to.z))
            }
            None => Ok(JsValue::UNDEFINED),
        }
    }

    /// Where a place is in the picture of the face: X a diameter, C in mm; two CSS pixels from the top left corner.
    #[wasm_bindgen(js_name = screenOfFace)]
    pub fn screen_of_face(&mut self, x: f64, c: f64) -> Vec<f64> {
        let pixel = self.views.face_view.as_ref().map(|view| view.camera().to_screen(Point::new(c, x / 2.0)));
        pixel.map_or_else(Vec::new, |pixel| vec![pixel.x, pixel.y])
    }

    /// Paints what has changed of the face, and says when to call again.
    #[wasm_bindgen(js_name = drawFace)]
    pub fn draw_face(&mut self) -> Result<Drawn, JsValue> {
        self.show_face();
        let Views { face: Some(face), face_view: Some(view), face_work, face_painter: Some(painter), .. } =
            &mut self.views
        else {
            return Ok(Drawn::All);
        };
        Ok(match painter.draw(&face.scene(face_work.as_ref()), view)? {
            Progress::Done => Drawn::All,
            Progress::UnderWay => Drawn::Part,
            Progress::Waiting => Drawn::Moved,
        })
    }

    /// Puts the turret in `front` of the spindle, where the worker stands, or to the `rear`; X+ is drawn on its side.
    /// Anything else leaves it where the setup has it.
    #[wasm_bindgen(js_name = setTurret)]
    pub fn set_turret(&mut self, side: &str) {
        self.views.turret = match side {
            "front" => Some(Turret::Front),
            "rear" => Some(Turret::Rear),
            _ => None,
        };
        self.turn();
    }

    /// Which side the turret is drawn on.
    #[wasm_bindgen(unchecked_return_type = "'front' | 'rear'")]
    pub fn turret(&self) -> JsValue {
        JsValue::from_str(match self.side_of_turret() {
            Turret::Front => "front",
            Turret::Rear => "rear",
        })
    }

    /// The edge of the part at a place of the picture, CSS pixels, with its dimensions; it is marked until another is asked for.
    #[wasm_bindgen(unchecked_return_type = "Dimension | undefined")]
    pub fn dimension(&mut self, x: f64, y: f64) -> Result<JsValue, JsValue> {
        let camera = *self.view.camera();
        let pointer = camera.to_world(Pixel::new(x, y));
        let place = Point::new(pointer.x.abs(), pointer.z);
        let feature = match (&self.views.finished, self.view.playhead) {
            (Some((part, threads)), None) => feature::at(part, threads, place, REACH / camera.scale()),
            _ => None,
        };
        let side = if pointer.x < 0.0 { -1.0 } else { 1.0 };
        self.view.edge = feature
            .iter()
            .flat_map(|feature| &feature.corners)
            .map(|at| Point::new(side * at.x, at.z))
            .collect();
        feature.map_or(Ok(JsValue::UNDEFINED), |feature: Feature| to_js(&api::Dimension::new(&feature)))
    }

    /// Marks no edge any more.
    #[wasm_bindgen(js_name = leaveEdge)]
    pub fn leave_edge(&mut self) {
        self.view.edge.clear();
    }

    /// Keeps the part of this program, to lay those of later texts over it.
    pub fn keep(&mut self) {
        self.views.kept = Some(Kept { motions: self.run.motions().clone(), setup: self.run.setup().clone() });
        self.compare();
    }

    /// Ends the comparison.
    #[wasm_bindgen(js_name = endComparison)]
    pub fn end_comparison(&mut self) {
        self.views.kept = None;
        self.compare();
    }

    /// Where the part differs from the one that was kept (`first`); nothing while none is.
    #[wasm_bindgen(unchecked_return_type = "Comparison | undefined")]
    pub fn comparison(&self) -> Result<JsValue, JsValue> {
        match &self.views.comparison {
            Some(comparison) => to_js(&api::Comparison::new(comparison)),
            None => Ok(JsValue::UNDEFINED),
        }
    }
}

impl Playground {
    /// Follows a run whose material is off.
    pub(super) fn machined(&mut self) {
        let Some(shop) = &self.shop else { return };
        let motions = self.run.motions();
        self.views.face = Face::of(motions, shop);
        (self.views.face_work, self.views.face_moment) = (None, None);
        self.views.finished = shop.finished().map(|part| (part, threads(motions, shop.fitting())));
        self.view.edge.clear();
        self.turn();
        self.compare();
        self.show_face();
        self.with_face_view(|view, scene| view.follow(scene));
    }

    /// Forgets what was worked out of the last run.
    pub(super) fn forget_views(&mut self) {
        (self.views.finished, self.views.face) = (None, None);
        self.view.edge.clear();
        self.view.steps.clear();
    }

    /// The work as it is shown, with what differs from the part that was kept.
    pub(super) fn compared(&self, work: Work) -> Work {
        match &self.views.comparison {
            Some(comparison) if self.view.playhead.is_none() => work.compared_with(comparison),
            _ => work,
        }
    }

    /// Labels the steps of the pass that is picked out.
    pub(super) fn name_steps(&mut self) {
        self.view.steps = labels(self.run.motions(), &self.view.highlight, self.view.hover);
    }

    fn side_of_turret(&self) -> Turret {
        self.views.turret.unwrap_or(self.run.setup().machine.turret)
    }

    fn turn(&mut self) {
        let x_plus = XPlus::from(self.side_of_turret());
        self.view.turn(&Scene::new(self.run.motions(), &self.outline, self.work.as_ref()), x_plus);
    }

    fn compare(&mut self) {
        self.views.comparison = self.views.kept.as_ref().and_then(|kept| {
            let now = (self.run.motions(), self.run.setup());
            let [first, second] = parts([(&kept.motions, &kept.setup), now]);
            Some(Comparison::of(&first?, &second?))
        });
        self.work = None;
        self.show_work();
    }

    /// Brings the face to the moment at which the tool stands, with the same strokes picked out as in the section.
    fn show_face(&mut self) {
        let (Some(shop), Some(face)) = (&self.shop, &self.views.face) else { return };
        let scene = Scene::new(self.run.motions(), &self.outline, None);
        let place: Option<Place> = self.view.playhead.and_then(|playhead| scene.place(playhead));
        let moment = place.map(|place| Moment { motion: place.motion, share: place.fraction, tip: place.at });
        if self.views.face_work.is_none() || moment != self.views.face_moment {
            self.views.face_work = face.work(shop, place);
            self.views.face_moment = moment;
        }
        let picture = face.scene(self.views.face_work.as_ref());
        let view = self
            .views
            .face_view
            .get_or_insert_with(|| View::new(&picture, Size { width: 300.0, height: 300.0 }));
        view.palette = self.view.palette.clone();
        view.playhead = place.map(|place| face.playhead(place));
        view.hover = self.view.hover.and_then(|motion| face.own(motion));
        let own =
            self.view.highlight.iter().flat_map(|range| range.clone().filter_map(|motion| face.own(motion)));
        view.highlight.clear();
        for own in own {
            match view.highlight.last_mut() {
                Some(last) if last.end == own => last.end += 1,
                _ => view.highlight.push(own..own + 1),
            }
        }
    }

    fn with_face_view(&mut self, change: impl FnOnce(&mut View, &Scene)) {
        let (empty, none) = (Motions::default(), Outline::new());
        let Views { face, face_view, face_work, .. } = &mut self.views;
        let scene = match face {
            Some(face) => face.scene(face_work.as_ref()),
            None => Scene::new(&empty, &none, None).on(crate::scene::Plane::Face),
        };
        let view = face_view.get_or_insert_with(|| View::new(&scene, Size { width: 300.0, height: 300.0 }));
        change(view, &scene);
    }
}
