//! Draws the picture on a canvas of the page.
//!
//! In: a scene and a view of it. Out: pixels on an `OffscreenCanvas`. The layers that seldom change (grid,
//! stock, strokes, rulers) are cached as an image, so that a moving pointer costs one copy. The strokes are
//! cached separately too, so that many of them can be moved immediately and redrawn a little later. Reads the
//! scene, knows nothing of the page.

mod annotations;
pub(crate) mod layer;
mod paths;
mod pen;
pub(crate) mod sheet;

use std::ops::Range;

use wasm_bindgen::JsValue;
use web_sys::{ImageBitmap, OffscreenCanvas};

use super::camera::{Pixel, XPlus};
use super::clip;
use super::ink::Ink;
use super::marks::{arrow_heads, insert};
use super::source::{Picture, Source};
use super::view::{Framing, View};
use super::work::{ToolOutline, Work};
use super::{Place, Plane, Scene, Stroke, StrokeStyle};
use crate::geometry::{Point, within};
use crate::parts::{Part, late};
pub use layer::Progress;
use layer::StrokeLayer;
use paths::Paths;
use pen::{Dash, Pen, Text};

/// Width of selected strokes, CSS pixels. `CLEAR` is the width of the clear edge around them.
const PICKED: f64 = 3.0;
/// Above this number, selected strokes are drawn thinner.
const MANY_PICKED: usize = 24;
const CLEAR: f64 = 7.0;
/// Minimum length on screen of a selected stroke with an arrow head, CSS pixels.
const MIN_FOR_PICKED_ARROW: f64 = 22.0;

/// The part that draws the layer over the strokes; no selection and no tool is shown before it is loaded.
const OVER: Part = Part::Late;

late! {
    fn draw_over(painter: &mut Painter, scene: &Scene, view: &View) -> Result<(), JsValue> {
        painter.draw_over(scene, view)
    }
}

/// Draws scenes on a canvas.
#[derive(Debug)]
pub struct Painter {
    screen: Pen,
    /// The layers that seldom change, as an image of the same size.
    sheet: Pen,
    strokes: StrokeLayer,
    /// The highlighted motions as paths.
    picked: Option<(Vec<Range<usize>>, Paths)>,
    painted: Option<Painted>,
    /// Whether anything was painted since the last image was taken.
    is_new: bool,
    /// Whether the layer over the strokes is drawn.
    draws_over: bool,
}

/// The state that the last picture showed.
#[derive(Clone, Debug, PartialEq)]
struct Painted {
    source: Source,
    view: View,
    work: Option<u64>,
    path_index: u64,
    /// The version of the stroke image.
    strokes: u32,
}

impl Painter {
    /// A painter for a canvas that nothing else draws on.
    pub fn new(canvas: OffscreenCanvas) -> Result<Self, JsValue> {
        let sheet = Pen::new(OffscreenCanvas::new(1, 1)?)?;
        let screen = Pen::new(canvas)?;
        Ok(Self {
            screen,
            sheet,
            strokes: StrokeLayer::new()?,
            picked: None,
            painted: None,
            is_new: false,
            draws_over: false,
        })
    }

    /// Paints the changes since the last call; a picture with many strokes takes several calls.
    pub fn draw(&mut self, picture: &Picture) -> Result<Progress, JsValue> {
        let Picture { scene, view, source } = picture;
        let draws_over = OVER.is_loaded();
        if draws_over != self.draws_over {
            (self.draws_over, self.painted) = (draws_over, None);
        }
        let progress = self.strokes.update(scene, view)?;
        let now = Painted {
            source: *source,
            view: (*view).clone(),
            work: scene.work().map(Work::id),
            path_index: scene.path_index().id(),
            strokes: self.strokes.version(),
        };
        let before = self.painted.take();
        if before.as_ref().is_some_and(|before| before.path_index != now.path_index) {
            self.picked = None;
        }
        if before.as_ref() != Some(&now) {
            if !before.as_ref().is_some_and(|before| before.has_same_sheet(&now)) {
                self.draw_sheet(scene, view)?;
            }
            self.draw_screen(scene, view)?;
            self.is_new = true;
        }
        self.painted = Some(now);
        Ok(progress)
    }

    /// Paints the next image even if it is unchanged, because the last one was not shown.
    pub fn force_repaint(&mut self) {
        self.painted = None;
    }

    /// Releases the memory of all cached images; the next picture is painted from scratch.
    pub fn release(&mut self) {
        self.screen.release();
        self.sheet.release();
        self.strokes.release();
        (self.picked, self.painted, self.is_new) = (None, None, false);
    }

    /// Takes the image painted since the last call off the canvas; `None` if nothing was painted.
    pub fn take_image(&mut self) -> Result<Option<ImageBitmap>, JsValue> {
        std::mem::take(&mut self.is_new).then(|| self.screen.take_image()).transpose()
    }

    /// Draws everything except the selection.
    fn draw_sheet(&self, scene: &Scene, view: &View) -> Result<(), JsValue> {
        // The background covers only a part of the last row and column of pixels, so clear them first: an
        // earlier picture must not show through.
        self.sheet.clear()?;
        self.sheet.begin(view)?;
        sheet::paper(&self.sheet, scene, view)?;
        self.sheet.clip(view)?;
        self.strokes.copy_to(&self.sheet, scene, view)?;
        self.sheet.unclip();
        sheet::rulers(&self.sheet, scene.axes(), view)
    }

    /// Copies the sheet to the screen, and draws the selection over it.
    fn draw_screen(&mut self, scene: &Scene, view: &View) -> Result<(), JsValue> {
        self.screen.clear()?;
        self.screen.begin(view)?;
        self.screen.copy(&self.sheet)?;
        self.screen.clip(view)?;
        if self.draws_over {
            draw_over(self, scene, view)?;
        }
        self.screen.unclip();
        Ok(())
    }

    /// Draws the layer over the strokes: selection, names, tool.
    fn draw_over(&mut self, scene: &Scene, view: &View) -> Result<(), JsValue> {
        self.point_beyond(scene, view)?;
        self.highlight(scene, view)?;
        self.edge(view)?;
        self.name_steps(view)?;
        self.name_places(view)?;
        self.annotations(scene, view)?;
        if let Some(stroke) = view.hover.and_then(|motion| scene.stroke(motion)) {
            let paths = Paths::of([stroke].into_iter())?;
            self.pick_out(view, &paths, &view.palette.hover, || [stroke].into_iter())?;
        }
        if let Some(work) = scene.work() {
            self.dangers(view, work)?;
        }
        match (scene.work().and_then(|work| work.tool.as_ref()), view.playhead) {
            (Some(tool), _) => self.real_tool(view, tool)?,
            (None, Some(playhead)) => {
                if let Some(place) = scene.place(playhead) {
                    self.tool(view, place)?;
                }
            }
            (None, None) => {}
        }
        Ok(())
    }

    /// Draws arrow heads at the edge of a picture: in a fitted picture towards the path outside it, and
    /// always towards a tool outside it.
    fn point_beyond(&self, scene: &Scene, view: &View) -> Result<(), JsValue> {
        let palette = &view.palette;
        self.screen.page(view)?;
        if view.framing() == Framing::Fitted
            && scene.plane() == Plane::Section
            && let Some(all) = scene.path_index().bounds()
        {
            let heads: Vec<_> =
                [all.min, all.max].into_iter().filter_map(|at| head_towards(view, at, 6.0)).collect();
            self.screen.fill(&palette.rapid, heads.iter().map(|head| &head[..]));
        }
        let tool = view.playhead.and_then(|playhead| scene.place(playhead));
        if let Some(head) = tool.and_then(|place| head_towards(view, place.at, 10.0)) {
            self.screen.fill(&palette.tool, [&head[..]].into_iter());
        }
        Ok(())
    }

    /// Draws a ring and a letter at each named point. The letter has a background, so that no line crosses
    /// it.
    fn name_places(&self, view: &View) -> Result<(), JsValue> {
        const FONT: &str = "600 13px system-ui, sans-serif";
        self.screen.page(view)?;
        for mark in &view.marks {
            let at = view.camera().to_screen(mark.at);
            // Outwards and to the right, where a tool comes from: the path is seldom there.
            let out = match view.camera().x_plus() {
                XPlus::Up => at.y,
                XPlus::Down => at.y + 22.0,
            };
            let (text, baseline) = (Pixel::new(at.x + 9.0, out - 11.0), "middle");
            let (from, to) = (Pixel::new(at.x + 6.0, out - 20.0), Pixel::new(at.x + 27.0, out - 3.0));
            self.screen.opacity(0.9);
            self.screen.block(&view.palette.background, from, to);
            self.screen.opacity(1.0);
            self.screen.dots(&view.palette.background, [at].into_iter(), 5.0)?;
            self.screen.dots(&view.palette.highlight, [at].into_iter(), 3.5)?;
            let name = Text { text: mark.name, font: FONT, align: "left", baseline };
            self.screen.write(&name, text, &view.palette.highlight)?;
        }
        Ok(())
    }

    /// Draws the labels of the steps of a pass, each with a background.
    fn name_steps(&self, view: &View) -> Result<(), JsValue> {
        const FONT: &str = "600 12px system-ui, sans-serif";
        self.screen.page(view)?;
        for step in &view.steps {
            let Some(at) = step.place(view.camera()) else { continue };
            let (from, to) = (Pixel::new(at.x - 10.0, at.y - 8.0), Pixel::new(at.x + 10.0, at.y + 8.0));
            self.screen.opacity(0.85);
            self.screen.block(&view.palette.background, from, to);
            self.screen.opacity(1.0);
            let text = Text { text: step.text, font: FONT, align: "center", baseline: "middle" };
            self.screen.write(&text, at, &view.palette.highlight)?;
        }
        Ok(())
    }

    /// Draws the edge of the part under the pointer.
    fn edge(&self, view: &View) -> Result<(), JsValue> {
        if view.edge.is_empty() {
            return Ok(());
        }
        self.screen.page(view)?;
        let camera = view.camera();
        let line: Vec<Pixel> = view.edge.iter().map(|at| camera.to_screen(*at)).collect();
        self.screen.opacity(0.55);
        self.screen.polylines(
            &view.palette.hover,
            &clip::polyline(&line, camera.size()),
            6.0,
            Dash::Solid,
        )?;
        self.screen.opacity(1.0);
        Ok(())
    }

    fn highlight(&mut self, scene: &Scene, view: &View) -> Result<(), JsValue> {
        if view.highlight.is_empty() {
            return Ok(());
        }
        let strokes = || view.highlight.iter().flat_map(|range| scene.strokes_of(range.clone()));
        let paths = match self.picked.take() {
            Some((ranges, paths)) if ranges == view.highlight => paths,
            _ => Paths::of(strokes())?,
        };
        self.pick_out(view, &paths, &view.palette.highlight, strokes)?;
        self.picked = Some((view.highlight.clone(), paths));
        Ok(())
    }

    /// Draws paths thick and in one colour, with a dot at the start and arrow heads.
    fn pick_out<S: Iterator<Item = Stroke>>(
        &self,
        view: &View,
        paths: &Paths,
        colour: &str,
        strokes: impl Fn() -> S,
    ) -> Result<(), JsValue> {
        let pen = &self.screen;
        let camera = view.camera();
        // Draw many strokes thinner: strokes close together, such as the passes of a thread, must not merge.
        let picked = if strokes().nth(MANY_PICKED).is_some() { PICKED * 0.55 } else { PICKED };
        pen.opacity(0.75);
        for path in Ink::ALL.into_iter().filter_map(|ink| paths.get(ink)) {
            pen.world(view, CLEAR, Dash::Solid, &view.palette.background)?;
            pen.stroke(path);
        }
        pen.opacity(1.0);
        for ink in Ink::ALL {
            let Some(path) = paths.get(ink) else { continue };
            let width = if ink.style() == StrokeStyle::Rapid { picked * 0.6 } else { picked };
            pen.world(view, width, sheet::dash(ink), colour)?;
            pen.stroke(path);
        }
        pen.page(view)?;
        let dots = Ink::ALL.into_iter().flat_map(|ink| paths.dots(ink));
        pen.dots(colour, dots.map(|at| camera.to_screen(*at)), 5.0)?;
        let heads = arrow_heads(strokes().map(|s| s.shape), camera, MIN_FOR_PICKED_ARROW);
        pen.fill(colour, heads.iter().map(|head| &head[..]));
        let start = strokes().next().map(|stroke| camera.to_screen(stroke.shape.start()));
        pen.dots(&view.palette.background, start.into_iter(), 6.0)?;
        pen.dots(colour, start.into_iter(), 4.5)
    }

    /// Draws a ring at each collision.
    fn dangers(&self, view: &View, work: &Work) -> Result<(), JsValue> {
        self.screen.page(view)?;
        for at in work.dangers.iter().map(|at| view.camera().to_screen(*at)) {
            self.screen.ring(&view.palette.danger, at, 8.0, 2.5)?;
            let arm = |x: f64, y: f64| [Pixel::new(at.x - x, at.y - y), Pixel::new(at.x + x, at.y + y)];
            self.screen.lines(&view.palette.danger, 2.5, [arm(4.0, 4.0), arm(4.0, -4.0)].iter().copied());
        }
        Ok(())
    }

    /// Draws the outline of the cutting tool and marks its tip.
    fn real_tool(&self, view: &View, tool: &ToolOutline) -> Result<(), JsValue> {
        let camera = view.camera();
        let seen = |points: &[Point]| {
            let corners: Vec<Pixel> = points.iter().map(|at| camera.to_screen(*at)).collect();
            clip::polygon(&corners, camera.size())
        };
        self.screen.page(view)?;
        if let Some(body) = tool.body.as_deref().map(seen) {
            self.screen.opacity(0.16);
            self.screen.fill(&view.palette.tool, [&body[..]].into_iter());
            self.screen.opacity(0.6);
            self.screen.outline(&view.palette.tool, &body, 1.0);
        }
        let edge = seen(&tool.edge);
        self.screen.opacity(0.85);
        self.screen.fill(&view.palette.background, [&edge[..]].into_iter());
        self.screen.opacity(0.3);
        self.screen.fill(&view.palette.tool, [&edge[..]].into_iter());
        self.screen.opacity(1.0);
        self.screen.outline(&view.palette.tool, &edge, 1.75);
        self.screen.dots(&view.palette.tool, [camera.to_screen(tool.tip)].into_iter(), 2.5)
    }

    fn tool(&self, view: &View, place: Place) -> Result<(), JsValue> {
        let tip = view.camera().to_screen(place.at);
        let corners = insert(tip, view.camera().x_plus());
        self.screen.page(view)?;
        self.screen.opacity(0.85);
        self.screen.fill(&view.palette.background, [&corners[..]].into_iter());
        self.screen.opacity(0.3);
        self.screen.fill(&view.palette.tool, [&corners[..]].into_iter());
        self.screen.opacity(1.0);
        self.screen.outline(&view.palette.tool, &corners, 1.75);
        let hole = Pixel::new((tip.x + corners[2].x) / 2.0, (tip.y + corners[2].y) / 2.0);
        self.screen.dots(&view.palette.tool, [hole].into_iter(), 2.5)
    }
}

/// An arrow head of `size` CSS pixels at the edge of the picture, towards a point outside it.
fn head_towards(view: &View, at: Point, size: f64) -> Option<[Pixel; 3]> {
    let at = view.camera().to_screen(at);
    let [across, down] = view.camera().inside(0.0);
    if (across[0]..=across[1]).contains(&at.x) && (down[0]..=down[1]).contains(&at.y) {
        return None;
    }
    let [across, down] = view.camera().inside(2.0);
    if across[0] >= across[1] || down[0] >= down[1] {
        return None;
    }
    let tip = Pixel::new(within(at.x, across[0], across[1]), within(at.y, down[0], down[1]));
    let far = tip.distance(at).max(1e-9);
    let (x, y) = (size * (at.x - tip.x) / far, size * (at.y - tip.y) / far);
    let foot = Pixel::new(tip.x - x - x, tip.y - y - y);
    let side = |turn: f64| Pixel::new(foot.x - turn * y, foot.y + turn * x);
    Some([tip, side(1.0), side(-1.0)])
}

impl Painted {
    /// Whether the sheet is unchanged, apart from the selection over it.
    fn has_same_sheet(&self, now: &Painted) -> bool {
        let image = |painted: &Painted| (painted.source, painted.work, painted.path_index, painted.strokes);
        self.view.shows_same_ground(&now.view) && image(self) == image(now)
    }
}
