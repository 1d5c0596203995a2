//! The view of a picture: the camera, and the selection.
//!
//! In: the user's pans, zooms, selections and playhead. Out: [`View`], used by a painter to draw a scene. It
//! is independent of the canvas, so that picking and measuring work before there is one.

use std::ops::Range;

use crate::geometry::{Point, within};
use crate::playback::clock::Playhead;

use super::Scene;
use super::annotation::Annotation;
use super::camera::{Camera, Pixel, Size, XPlus};
use super::palette::Palette;
use super::ruler::Scale;
use super::steps::StepLabel;

/// Maximum length of a side of a picture, in CSS pixels and in device pixels: no canvas is larger.
const LONGEST_SIDE: f64 = 16_384.0;

/// Space for labels around a fitted picture, CSS pixels, at most; less in a small picture.
const ROOM_FOR_LABELS: f64 = 56.0;

/// Minimum distance of the tool from the edge of the picture, CSS pixels.
const IN_VIEW: f64 = 40.0;

/// Whether the camera still shows the fitted picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Framing {
    /// Fitted: the camera follows as the picture grows.
    Fitted,
    /// Moved by the user: the camera stays.
    Moved,
}

/// The extent of a fitted picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Frame {
    /// Cuts, stock, and the rapids that end nearby.
    #[default]
    Usual,
    /// The cuts and the spindle axis, as large as possible, such as for a class.
    Cuts,
    /// The stock, or the cuts if there is none.
    Part,
    /// All motions.
    Path,
}

/// A named point, such as the start point A of a cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mark {
    /// The position, radius and Z in mm.
    pub at: Point,
    /// Its name, as in manuals.
    pub name: &'static str,
}

/// The camera, the colours, and the selection.
#[derive(Clone, Debug, PartialEq)]
pub struct View {
    camera: Camera,
    framing: Framing,
    frame: Frame,
    /// The extent of a picture with labels around it, if the user has chosen none; `None` without labels.
    labelled: Option<Frame>,
    pixel_ratio: f64,
    /// The colours.
    pub palette: Palette,
    /// The unit of the rulers.
    pub scale: Scale,
    /// Motions of the selected block or blocks.
    pub highlight: Vec<Range<usize>>,
    /// Named points of the selected cycle.
    pub marks: Vec<Mark>,
    /// The labels of the steps of one of its passes.
    pub steps: Vec<StepLabel>,
    /// Dimensions and letters over the strokes; not shown while there is a tool.
    pub annotations: Vec<Annotation>,
    /// The annotations of a measurement, shown instead; `None` while nothing is measured.
    pub measured: Option<Vec<Annotation>>,
    /// The edge of the part under the pointer.
    pub edge: Vec<Point>,
    /// The motion under the pointer.
    pub hover: Option<usize>,
    /// The progress of the tool; `None` shows all strokes and no tool.
    pub playhead: Option<Playhead>,
}

impl View {
    /// A view of a scene, fitted to a picture of `size`, CSS pixels.
    #[inline(never)]
    pub fn new(scene: &Scene, size: Size) -> Self {
        Self {
            camera: Camera::fit_with(scene.bounds(), size, scene.plane().x_plus(XPlus::Up)),
            framing: Framing::Fitted,
            frame: Frame::default(),
            labelled: None,
            pixel_ratio: 1.0,
            palette: Palette::default(),
            scale: Scale::default(),
            highlight: Vec::new(),
            marks: Vec::new(),
            steps: Vec::new(),
            annotations: Vec::new(),
            measured: None,
            edge: Vec::new(),
            hover: None,
            playhead: None,
        }
    }

    /// The camera of the picture.
    pub fn camera(&self) -> &Camera {
        &self.camera
    }

    /// Whether the camera is fitted or moved.
    pub fn framing(&self) -> Framing {
        self.framing
    }

    /// Device pixels per CSS pixel.
    pub fn pixel_ratio(&self) -> f64 {
        self.pixel_ratio
    }

    /// Width and height of the picture, device pixels.
    pub fn device_size(&self) -> (u32, u32) {
        let device = |length: f64| ((length * self.pixel_ratio).round() as u32).clamp(1, LONGEST_SIDE as u32);
        let Size { width, height } = self.camera.size();
        (device(width), device(height))
    }

    /// Whether the views are equal apart from the selection.
    pub fn shows_same_ground(&self, other: &View) -> bool {
        let Self { camera, framing, pixel_ratio, palette, scale, playhead, .. } = self;
        (camera, framing, pixel_ratio) == (&other.camera, &other.framing, &other.pixel_ratio)
            && (palette, scale, playhead) == (&other.palette, &other.scale, &other.playhead)
    }

    /// The same view without a selection, and with another playhead.
    pub fn without_selection(&self, playhead: Option<Playhead>) -> View {
        View {
            palette: self.palette.clone(),
            highlight: Vec::new(),
            marks: Vec::new(),
            steps: Vec::new(),
            annotations: Vec::new(),
            measured: None,
            edge: Vec::new(),
            hover: None,
            playhead,
            ..*self
        }
    }

    /// Fits the camera to the scene.
    pub fn fit(&mut self, scene: &Scene) {
        let frame = if self.frame == Frame::Usual { self.labelled.unwrap_or_default() } else { self.frame };
        let bounds = scene.bounds_of(frame);
        let size = self.camera.size();
        let most = ROOM_FOR_LABELS.min(size.width.min(size.height) / 8.0);
        let room = self.labelled.map_or(0.0, |_| most);
        let inside = Size { width: size.width - 2.0 * room, height: size.height - 2.0 * room };
        self.camera = Camera::fit_with(bounds, inside, self.camera.x_plus());
        self.camera.resize(size);
        self.framing = Framing::Fitted;
    }

    /// Gives a fitted picture room for labels around it, and the extent if the user has chosen none; `None`: no
    /// labels.
    pub fn set_labels(&mut self, scene: &Scene, frame: Option<Frame>) {
        self.labelled = frame;
        self.follow(scene);
    }

    /// Fits the camera unless the user has moved it. Call this when a run has ended.
    pub fn follow(&mut self, scene: &Scene) {
        match self.framing {
            Framing::Fitted => self.fit(scene),
            Framing::Moved => {}
        }
    }

    /// Sets the extent of a fitted picture.
    pub fn set_frame(&mut self, scene: &Scene, frame: Frame) {
        self.frame = frame;
        self.follow(scene);
    }

    /// Sets the direction of X+.
    pub fn turn(&mut self, scene: &Scene, x_plus: XPlus) {
        self.camera.turn(x_plus);
        self.follow(scene);
    }

    /// Moves the picture by CSS pixels, to the right and down.
    pub fn pan(&mut self, dx: f64, dy: f64) {
        self.camera.pan(dx, dy);
        self.framing = Framing::Moved;
    }

    /// Moves a picture that the user has moved, so that a point such as the tool stays in view.
    pub fn keep_in_view(&mut self, at: Point) {
        if self.framing == Framing::Fitted {
            return;
        }
        let (at, inside) = (self.camera.to_screen(at), self.camera.inside(IN_VIEW));
        let back =
            |at: f64, [least, most]: [f64; 2]| if least < most { within(at, least, most) - at } else { 0.0 };
        let (dx, dy) = (back(at.x, inside[0]), back(at.y, inside[1]));
        if dx != 0.0 || dy != 0.0 {
            self.pan(dx, dy);
        }
    }

    /// Zooms the picture by `factor` about a position.
    pub fn zoom(&mut self, factor: f64, fixed: Pixel) {
        self.camera.zoom(factor, fixed);
        self.framing = Framing::Moved;
    }

    /// Sets the size of the picture, CSS pixels, up to [`LONGEST_SIDE`], and the ratio of device pixels to
    /// CSS pixels.
    pub fn resize(&mut self, scene: &Scene, size: Size, pixel_ratio: f64) {
        let possible = |length: f64| within(length.max(0.0), 0.0, LONGEST_SIDE);
        self.camera.resize(Size { width: possible(size.width), height: possible(size.height) });
        self.pixel_ratio = if pixel_ratio.is_finite() { within(pixel_ratio, 0.25, 8.0) } else { 1.0 };
        self.follow(scene);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::Motions;
    use crate::scene::Scene;
    use crate::scene::path_index::PathIndex;

    #[test]
    fn labels_have_room_around_a_fitted_picture() {
        let (motions, path_index) = (Motions::default(), PathIndex::new());
        let scene = Scene::new(&motions, &path_index, None);
        let bounds = scene.bounds();
        let mut view = View::new(&scene, Size { width: 800.0, height: 500.0 });
        let extent = |view: &View| {
            let [low, high] = [bounds.min, bounds.max].map(|at| view.camera().to_screen(at));
            [high.x - low.x, low.y - high.y]
        };
        let middle = |view: &View| view.camera().to_screen(Point::new(10.0, -20.0));
        let (before, center) = (extent(&view), middle(&view));
        view.set_labels(&scene, Some(Frame::Usual));
        let after = extent(&view);
        assert!((before[0] - after[0] - 112.0).abs() < 1e-6, "{before:?} {after:?}");
        assert!(middle(&view).distance(center) < 1e-6);
        view.set_labels(&scene, None);
        assert_eq!(extent(&view), before);
    }

    #[test]
    fn a_picture_that_was_moved_follows_the_tool_and_a_fitted_one_stays() {
        let (motions, path_index) = (Motions::default(), PathIndex::new());
        let scene = Scene::new(&motions, &path_index, None);
        let mut view = View::new(&scene, Size { width: 800.0, height: 500.0 });
        let fitted = *view.camera();
        let outside = Point::new(40.0, -300.0);
        view.keep_in_view(outside);
        assert_eq!(*view.camera(), fitted);
        view.zoom(4.0, Pixel::new(400.0, 250.0));
        view.keep_in_view(outside);
        let at = view.camera().to_screen(outside);
        let [across, down] = view.camera().inside(IN_VIEW - 0.1);
        assert!(across[0] <= at.x && at.x <= across[1] && down[0] <= at.y && at.y <= down[1], "{at:?}");
        let moved = *view.camera();
        view.keep_in_view(outside);
        assert_eq!(*view.camera(), moved);
    }
}
