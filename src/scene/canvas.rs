//! The picture on a canvas of the page.
//!
//! In: a scene and a view of it. Out: pixels on an `OffscreenCanvas`. What seldom changes (grid, stock, strokes,
//! rulers) is kept as an image, so that a moving pointer costs one copy; strokes are kept as paths in mm, one
//! for each stretch and style, so that a pan or zoom of a million motions only strokes what is in view.
//! Reads the scene, knows nothing of the page.

mod paths;
mod pen;
mod sheet;

use std::ops::Range;

use wasm_bindgen::JsValue;
use web_sys::OffscreenCanvas;

use super::camera::Pixel;
use super::marks::{LEAST_FOR_ARROW, MOST_WITH_ARROWS, arrow_heads, insert};
use super::outline::{STRETCH, StretchKey};
use super::view::View;
use super::{Place, Scene, StockShape, Stroke, StrokeStyle};
use paths::{Ink, Paths, path_of};
use pen::{Dash, Pen, Text};

/// Opacity of what has not run yet, while there is a playhead.
const AHEAD: f64 = 0.22;
/// Width of picked-out strokes, CSS pixels, and of the clear edge around them.
const PICKED: f64 = 3.0;
/// More strokes than this are picked out thinner.
const MANY_PICKED: usize = 24;
const CLEAR: f64 = 7.0;
/// Picked-out strokes bear arrow heads from this length on the screen, CSS pixels.
const LEAST_FOR_PICKED_ARROW: f64 = 22.0;

/// Stretches in view from which on the picture counts as crowded.
const CROWDED: usize = 40;

/// Draws scenes on a canvas.
#[derive(Debug)]
pub struct Painter {
    screen: Pen,
    /// What seldom changes, as an image of the same size.
    sheet: Pen,
    /// Strokes as paths, one entry for each stretch that has been in view.
    stretches: Vec<(StretchKey, Paths)>,
    /// The highlighted motions as paths.
    picked: Option<(Vec<Range<usize>>, Paths)>,
    painted: Option<Painted>,
}

/// What the last picture showed.
#[derive(Clone, Debug, PartialEq)]
struct Painted {
    view: View,
    stock: Option<StockShape>,
    outline: u64,
}

impl Painter {
    /// A painter of a canvas that nothing else draws on.
    pub fn new(canvas: OffscreenCanvas) -> Result<Self, JsValue> {
        let sheet = Pen::new(OffscreenCanvas::new(1, 1)?)?;
        let screen = Pen::new(canvas)?;
        Ok(Self { screen, sheet, stretches: Vec::new(), picked: None, painted: None })
    }

    /// Paints, if anything has changed since the last time.
    pub fn draw(&mut self, scene: &Scene, view: &View) -> Result<(), JsValue> {
        let now = Painted { view: view.clone(), stock: scene.stock(), outline: scene.outline().id() };
        let before = self.painted.take();
        if before.as_ref() != Some(&now) {
            self.forget_stale(scene, before.as_ref(), &now);
            if !before.as_ref().is_some_and(|before| before.has_same_sheet(&now)) {
                self.draw_sheet(scene, view)?;
            }
            self.draw_screen(scene, view)?;
        }
        self.painted = Some(now);
        Ok(())
    }

    /// Drops the paths of motions that are no more.
    fn forget_stale(&mut self, scene: &Scene, before: Option<&Painted>, now: &Painted) {
        if before.is_some_and(|before| before.outline != now.outline) {
            let stretches = scene.outline().stretches();
            self.stretches.retain(|(key, _)| stretches.iter().any(|stretch| stretch.key == *key));
            self.picked = None;
        }
    }

    /// Draws everything but what is picked out.
    fn draw_sheet(&mut self, scene: &Scene, view: &View) -> Result<(), JsValue> {
        self.sheet.begin(view)?;
        sheet::paper(&self.sheet, scene, view)?;
        self.sheet.clip(view)?;
        let programmed = path_of(scene.programmed())?;
        self.sheet.world(view, 1.0, Dash::Broken(2.0, 3.0), &view.palette.axis)?;
        self.sheet.stroke(&programmed);
        self.strokes(scene, view)?;
        self.sheet.unclip();
        sheet::rulers(&self.sheet, view)
    }

    /// Copies the sheet to the screen, and draws what is picked out over it.
    fn draw_screen(&mut self, scene: &Scene, view: &View) -> Result<(), JsValue> {
        self.screen.begin(view)?;
        self.screen.copy(&self.sheet)?;
        self.screen.clip(view)?;
        self.highlight(scene, view)?;
        self.name_places(view)?;
        if let Some(stroke) = view.hover.and_then(|motion| scene.stroke(motion)) {
            let paths = Paths::of([stroke].into_iter())?;
            self.pick_out(view, &paths, &view.palette.hover, || [stroke].into_iter())?;
        }
        if let Some(place) = view.playhead.and_then(|length| scene.at_length(length)) {
            self.tool(view, place)?;
        }
        self.screen.unclip();
        Ok(())
    }

    /// Rings with a letter at the named places; the letter stands on paper, so that no line runs through it.
    fn name_places(&self, view: &View) -> Result<(), JsValue> {
        const FONT: &str = "600 13px system-ui, sans-serif";
        self.screen.page(view)?;
        for mark in &view.marks {
            let at = view.camera().to_screen(mark.at);
            // Above and to the right, where a tool comes from: the path seldom runs there.
            let (text, baseline) = (Pixel::new(at.x + 9.0, at.y - 11.0), "middle");
            let (from, to) = (Pixel::new(at.x + 6.0, at.y - 20.0), Pixel::new(at.x + 27.0, at.y - 3.0));
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

    fn strokes(&mut self, scene: &Scene, view: &View) -> Result<(), JsValue> {
        let seen = view.camera().seen().grown(PICKED / view.camera().scale());
        let stretches = scene.outline().stretches();
        let in_view: Vec<usize> =
            (0..stretches.len()).filter(|&index| stretches[index].bounds.meets(seen)).collect();
        for &index in &in_view {
            let key = stretches[index].key;
            if self.paths(key).is_none() {
                let paths = Paths::of(scene.strokes_of(stretches[index].motions.clone()))?;
                self.stretches.push((key, paths));
            }
        }
        let place = view.playhead.and_then(|length| scene.at_length(length));
        let at = place.and_then(|place| scene.outline().index_of(place.motion));
        let whole = |index: &usize| self.paths(stretches[*index].key);
        let shown = |index: &&usize| at.is_none_or(|at| **index < at);
        let mut done: Vec<&Paths> = in_view.iter().filter(shown).filter_map(whole).collect();
        let Some(place) = place else { return self.inked(scene, view, &done, None, &in_view) };
        let (before, after) = halves(scene, place)?;
        let shown = |index: &&usize| at.is_some_and(|at| **index > at);
        let mut ahead: Vec<&Paths> = in_view.iter().filter(shown).filter_map(whole).collect();
        ahead.insert(0, &after);
        done.push(&before);
        let detail = Detail::of(&in_view);
        self.sheet.opacity(AHEAD);
        self.ink(view, &ahead, detail)?;
        self.sheet.opacity(1.0);
        self.inked(scene, view, &done, Some(place), &in_view)
    }

    fn paths(&self, key: StretchKey) -> Option<&Paths> {
        self.stretches.iter().find(|(of, _)| *of == key).map(|(_, paths)| paths)
    }

    /// Strokes paths in their own styles, with arrow heads where there are few.
    fn inked(
        &self,
        scene: &Scene,
        view: &View,
        paths: &[&Paths],
        until: Option<Place>,
        in_view: &[usize],
    ) -> Result<(), JsValue> {
        self.ink(view, paths, Detail::of(in_view))?;
        if in_view.len() * STRETCH > MOST_WITH_ARROWS + STRETCH {
            return Ok(());
        }
        let stretches = scene.outline().stretches();
        for style in [StrokeStyle::Feed, StrokeStyle::Thread] {
            let strokes = in_view.iter().flat_map(|&at| scene.strokes_of(stretches[at].motions.clone()));
            let run = strokes.filter(|stroke| until.is_none_or(|place| stroke.motion < place.motion));
            let shapes = run.filter(|s| s.style == style && !s.uncertain).map(|stroke| stroke.shape);
            let heads = arrow_heads(shapes, view.camera(), LEAST_FOR_ARROW);
            self.sheet
                .fill(sheet::colour(&view.palette, Ink::Sure(style)), heads.iter().map(|head| &head[..]));
        }
        Ok(())
    }

    fn ink(&self, view: &View, paths: &[&Paths], detail: Detail) -> Result<(), JsValue> {
        for ink in Ink::ALL {
            let colour = sheet::colour(&view.palette, ink);
            self.sheet.world(view, detail.width(view, ink), detail.dash(ink), colour)?;
            for path in paths.iter().filter_map(|paths| paths.get(ink)) {
                self.sheet.stroke(path);
            }
            self.sheet.page(view)?;
            let dots = paths.iter().flat_map(|paths| paths.dots(ink));
            self.sheet.dots(colour, dots.map(|at| view.camera().to_screen(*at)), 3.0)?;
        }
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

    /// Strokes paths thick and in one colour, with a dot where they start and arrow heads.
    fn pick_out<S: Iterator<Item = Stroke>>(
        &self,
        view: &View,
        paths: &Paths,
        colour: &str,
        strokes: impl Fn() -> S,
    ) -> Result<(), JsValue> {
        let pen = &self.screen;
        let camera = view.camera();
        // Many strokes close together, as the passes of a thread, must not run into one.
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
        let heads = arrow_heads(strokes().map(|s| s.shape), camera, LEAST_FOR_PICKED_ARROW);
        pen.fill(colour, heads.iter().map(|head| &head[..]));
        let start = strokes().next().map(|stroke| camera.to_screen(stroke.shape.start()));
        pen.dots(&view.palette.background, start.into_iter(), 6.0)?;
        pen.dots(colour, start.into_iter(), 4.5)
    }

    fn tool(&self, view: &View, place: Place) -> Result<(), JsValue> {
        let tip = view.camera().to_screen(place.at);
        let corners = insert(tip);
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

/// How finely strokes are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Detail {
    /// With their widths and dashes.
    Full,
    /// So many are in view that nobody could tell: all solid and one device pixel wide, which browsers draw
    /// many times as fast.
    Crowded,
}

impl Detail {
    fn of(in_view: &[usize]) -> Self {
        if in_view.len() > CROWDED { Self::Crowded } else { Self::Full }
    }

    /// Line width, CSS pixels.
    fn width(self, view: &View, ink: Ink) -> f64 {
        match self {
            Self::Full => sheet::width(ink),
            Self::Crowded => 1.0 / view.pixel_ratio(),
        }
    }

    fn dash(self, ink: Ink) -> Dash {
        match self {
            Self::Full => sheet::dash(ink),
            Self::Crowded => Dash::Solid,
        }
    }
}

impl Painted {
    /// Whether the sheet under what is picked out is the same.
    fn has_same_sheet(&self, now: &Painted) -> bool {
        let bare = |painted: &Painted| Painted { view: painted.view.bare(), ..painted.clone() };
        bare(self) == bare(now)
    }
}

/// The paths of the stretch that the tool is in, before and after its place.
fn halves(scene: &Scene, place: Place) -> Result<(Paths, Paths), JsValue> {
    let Some(stretch) = scene.outline().stretch_of(place.motion) else {
        return Ok((Paths::default(), Paths::default()));
    };
    let mut before = Paths::of(scene.strokes_of(stretch.motions.start..place.motion))?;
    let mut after = Paths::default();
    if let Some(stroke) = scene.stroke(place.motion) {
        let (done, ahead) = stroke.shape.split(place.fraction);
        before.push(&Stroke { shape: done, ..stroke })?;
        after.push(&Stroke { shape: ahead, ..stroke })?;
    }
    for stroke in scene.strokes_of(place.motion + 1..stretch.motions.end) {
        after.push(&stroke)?;
    }
    Ok((before, after))
}
