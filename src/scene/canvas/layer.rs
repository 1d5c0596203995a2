//! The strokes of a scene as an image, which is redrawn when they or the camera change, and moved until then.
//!
//! In: a scene and a view. Out: the strokes on a separate canvas. Few strokes are drawn immediately, with
//! their widths and dashes. Many are plotted in slices, so that the caller is not blocked; meanwhile the last
//! image is moved to match the camera. While the tool moves forward, only the new strokes are added. Knows
//! nothing of the layers under and over the strokes.

use std::ops::Range;

use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;
use web_sys::OffscreenCanvas;

use super::super::camera::Camera;
use super::super::camera::Pixel;
use super::super::ink::Ink;
use super::super::marks::{MAX_WITH_ARROWS, MIN_FOR_ARROW, add_arrow_heads};
use super::super::palette::Palette;
use super::super::path_index::{Stretch, StretchKey};
use super::super::plot::Plot;
use super::super::view::View;
use super::super::{Scene, StrokeShape, StrokeStyle};
use super::OVER;
use super::paths::{Paths, finished_part, path_of, split_stretch};
use super::pen::{Dash, Pen, rgb};
use super::sheet;
use crate::parts::late;
use crate::playback::clock::Playhead;

/// Opacity of the motions ahead of the playhead.
const OPACITY_AHEAD: f64 = 0.22;
/// Number of visible motions above which widths and dashes cannot be distinguished.
const CROWDED: usize = 40_000;
/// Number of visible motions that can be drawn in a few milliseconds, including widths and dashes.
const QUICK: usize = 4_000;
/// Above this number of new motions, everything is redrawn.
const FEW: usize = 400;
/// Number of frames without tool movement before strokes that were added one by one are redrawn together.
/// With a delay, one late frame does not make the next ones late.
const SETTLE_FRAMES: u32 = 12;
/// Maximum time for one slice of plotting, ms.
const SLICE: f64 = 8.0;
/// The layers of a plot: motions ahead of the tool and finished ones (both by ink), and the programmed path.
const DONE: usize = Ink::ALL.len();
const PROGRAMMED: usize = 2 * Ink::ALL.len();

#[wasm_bindgen]
extern "C" {
    /// Milliseconds since the worker started.
    #[wasm_bindgen(js_namespace = performance)]
    fn now() -> f64;
}

late! {
    fn stroke_until(
        layer: &StrokeLayer,
        scene: &Scene,
        view: &View,
        in_view: &[&Stretch],
        until: usize,
    ) -> Result<(), JsValue> {
        layer.stroke_until(scene, view, in_view, until)
    }

    fn add(
        layer: &mut StrokeLayer,
        scene: &Scene,
        view: &View,
        done: Range<usize>,
        motions: usize,
    ) -> Result<(), JsValue> {
        layer.add(scene, view, done, motions)
    }

    fn ink_under_way(pen: &Pen, scene: &Scene, view: &View, at: Playhead) -> Result<(), JsValue> {
        match scene.place(at) {
            Some(place) => ink(pen, view, &mut [&finished_part(scene, place)?].into_iter()),
            None => Ok(()),
        }
    }
}

/// The playhead, if it is shown.
fn tool_of(view: &View) -> Option<Playhead> {
    view.playhead.filter(|_| OVER.is_loaded())
}

/// Whether there is more to draw.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Progress {
    /// The image is up to date.
    Done,
    /// The last image is shown; the next call continues the new one.
    InProgress,
    /// The last image is shown; the new one is drawn once the camera has not moved for a frame.
    Waiting,
}

/// Red, green and blue of each ink, by [`Ink::index`], and of the programmed path.
type Colours = [[u8; 3]; Ink::ALL.len() + 1];

/// The state from which the strokes are drawn.
#[derive(Clone, Debug, PartialEq)]
struct Target {
    /// Without a selection, and with the tool at the start of a motion: the finished part of this motion is
    /// drawn over the image.
    view: View,
    path_index: u64,
}

/// How an image was drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Made {
    /// All strokes together.
    AtOnce,
    /// Strokes were added one by one as the tool moved forward; overlapping ones are slightly darker.
    Added {
        /// The last position of the tool.
        tool: Playhead,
        /// Number of frames the tool has been there.
        frames: u32,
    },
}

/// The strokes as an image.
#[derive(Debug)]
pub struct StrokeLayer {
    image: Pen,
    /// The state that the image shows.
    shown: Option<Target>,
    /// Version of the image.
    version: u32,
    /// Strokes as paths, one entry for each stretch that has recently been visible.
    paths: Vec<(StretchKey, Paths)>,
    /// The colours of a plot, with their palette.
    colours: Option<(Palette, Colours)>,
    /// The image in progress, and the index of the next stretch.
    plot: Option<(Target, Plot, usize)>,
    /// The camera at the last time that the image was moved instead of redrawn.
    moved: Option<Camera>,
    made: Made,
    /// The arrow heads of the image: on cuts, and on threads.
    heads: [Vec<[Pixel; 3]>; 2],
}

impl StrokeLayer {
    /// A layer without strokes.
    pub fn new() -> Result<Self, JsValue> {
        let image = Pen::new(OffscreenCanvas::new(1, 1)?)?;
        let (shown, paths, colours, plot, moved) = (None, Vec::new(), None, None, None);
        Ok(Self {
            image,
            shown,
            version: 0,
            paths,
            colours,
            plot,
            moved,
            made: Made::AtOnce,
            heads: Default::default(),
        })
    }

    /// Releases the memory of the image, which is redrawn when it is needed.
    pub fn release(&mut self) {
        self.image.release();
        (self.shown, self.plot, self.paths) = (None, None, Vec::new());
    }

    /// A number that identifies this image within the layer.
    pub fn version(&self) -> u32 {
        self.version
    }

    /// Updates the image, completely or in part.
    pub fn update(&mut self, scene: &Scene, view: &View) -> Result<Progress, JsValue> {
        let path_index = scene.path_index().id();
        let tool = tool_of(view);
        let target = Target { view: view.without_selection(tool.map(before)), path_index };
        let same =
            |shown: &Target| shown.path_index == path_index && shown.view.shows_same_ground(&target.view);
        if self.shown.as_ref().is_some_and(same) {
            match (self.made, tool) {
                (Made::Added { tool, frames }, Some(now)) if tool != now || frames < SETTLE_FRAMES => {
                    let frames = if tool == now { frames + 1 } else { 0 };
                    self.made = Made::Added { tool: now, frames };
                    return Ok(Progress::Waiting);
                }
                (Made::Added { .. }, _) => {}
                (Made::AtOnce, _) => return Ok(Progress::Done),
            }
        }
        // An image with the opposite direction of X cannot be reused by moving it.
        let turned = |shown: &Target| shown.view.camera().x_plus() != view.camera().x_plus();
        if self.shown.as_ref().is_some_and(turned) {
            self.shown = None;
        }
        let view = &target.view;
        let seen = view.camera().seen().grown(2.0 * sheet::WIDEST / view.camera().scale());
        let in_view: Vec<&Stretch> =
            scene.path_index().stretches().iter().filter(|stretch| stretch.bounds.overlaps(seen)).collect();
        let motions: usize = in_view.iter().map(|stretch| stretch.motions.len()).sum();
        if motions > CROWDED {
            return self.plot(scene, target, &in_view);
        }
        self.plot = None;
        if let Some((done, tool)) = self.done_since(&target).zip(tool) {
            add(self, scene, view, done, motions)?;
            self.finish(target);
            self.made = Made::Added { tool, frames: 0 };
            return Ok(Progress::Waiting);
        }
        // While the camera moves, an image that takes long is only moved; it is redrawn once the camera has
        // not moved for a frame.
        let camera = Some(*view.camera());
        if motions > QUICK && self.shown.is_some() && self.moved != camera && !self.shows_same_camera(view) {
            self.moved = camera;
            return Ok(Progress::Waiting);
        }
        self.stroke(scene, view, &in_view, motions)?;
        self.finish(target);
        Ok(Progress::Done)
    }

    /// Copies the image, moved to match the camera, and draws the finished part of the current motion.
    pub fn copy_to(&self, pen: &Pen, scene: &Scene, view: &View) -> Result<(), JsValue> {
        if let Some(shown) = &self.shown {
            pen.copy_moved(&self.image, &shown.view, view)?;
        }
        match tool_of(view).filter(|playhead| playhead.share < 1.0) {
            Some(at) => ink_under_way(pen, scene, view, at),
            None => Ok(()),
        }
    }

    /// The motions that are missing in the image, if it is up to date except for a few new motions of the
    /// tool.
    fn done_since(&self, target: &Target) -> Option<Range<usize>> {
        let shown = self.shown.as_ref()?;
        let (from, to) = (shown.view.playhead?.motion, target.view.playhead?.motion);
        let standing = target.view.without_selection(shown.view.playhead);
        let same = shown.path_index == target.path_index && shown.view.shows_same_ground(&standing);
        (same && from < to && to - from <= FEW).then_some(from..to)
    }

    fn shows_same_camera(&self, view: &View) -> bool {
        self.shown.as_ref().is_some_and(|shown| shown.view.camera() == view.camera())
    }

    fn finish(&mut self, target: Target) {
        (self.shown, self.moved, self.made) = (Some(target), None, Made::AtOnce);
        self.version = self.version.wrapping_add(1);
    }

    // ---- many strokes -------------------------------------------------------------------------------

    fn plot(&mut self, scene: &Scene, target: Target, in_view: &[&Stretch]) -> Result<Progress, JsValue> {
        let view = &target.view;
        // Finish an image even if the tool has moved since: while the tool moves, no image would ever be
        // finished otherwise.
        let goes_on = |of: &Target| {
            of.path_index == target.path_index
                && of.view.camera() == view.camera()
                && of.view.pixel_ratio() == view.pixel_ratio()
        };
        let (of, mut plot, mut next) = match self.plot.take() {
            Some(under_way) if goes_on(&under_way.0) => under_way,
            _ => {
                let plot = Plot::new(view.camera(), view.device_size(), view.pixel_ratio(), PROGRAMMED + 1);
                (target.clone(), plot, 0)
            }
        };
        let done = of.view.playhead.map(|playhead| playhead.motion);
        let until = now() + SLICE;
        while let Some(stretch) = in_view.get(next) {
            plot_stretch(&mut plot, scene, stretch, done);
            next += 1;
            if now() > until {
                break;
            }
        }
        if next < in_view.len() {
            self.plot = Some((of, plot, next));
            return Ok(Progress::InProgress);
        }
        let rows = plot.rows();
        let colours = self.colours(&of.view.palette)?;
        let pixels = coloured(&plot, rows.clone(), &colours);
        self.image.begin(&of.view)?;
        self.image.clear()?;
        if !rows.is_empty() {
            self.image.put(&pixels, plot.size().0, rows.start)?;
        }
        let same = of == target;
        self.finish(of);
        Ok(if same { Progress::Done } else { Progress::InProgress })
    }

    /// The colours of a plot; they are read from the browser only when the palette has changed.
    fn colours(&mut self, palette: &Palette) -> Result<Colours, JsValue> {
        if let Some((_, colours)) = self.colours.as_ref().filter(|(of, _)| of == palette) {
            return Ok(*colours);
        }
        let mut names = [&palette.axis[..]; Ink::ALL.len() + 1];
        for ink in Ink::ALL {
            names[ink.index()] = sheet::colour(palette, ink);
        }
        let colours = rgb(names)?;
        self.colours = Some((palette.clone(), colours));
        Ok(colours)
    }

    // ---- few strokes --------------------------------------------------------------------------------

    /// Draws the strokes of the visible stretches, which have `motions` motions.
    fn stroke(
        &mut self,
        scene: &Scene,
        view: &View,
        in_view: &[&Stretch],
        motions: usize,
    ) -> Result<(), JsValue> {
        self.image.begin(view)?;
        self.image.clear()?;
        self.image.clip(view)?;
        let programmed = path_of(in_view.iter().flat_map(|stretch| scene.programmed_in(stretch)))?;
        self.image.world(view, 1.0, Dash::Broken(2.0, 3.0), &view.palette.axis)?;
        self.image.stroke(&programmed);
        self.paths.retain(|(key, _)| in_view.iter().any(|stretch| stretch.key == *key));
        for stretch in in_view {
            if self.paths_of(stretch).is_none() {
                self.paths.push((stretch.key, Paths::of(scene.strokes_of(stretch.motions.clone()))?));
            }
        }
        let until = view.playhead.map(|playhead| playhead.motion);
        match until {
            Some(until) => stroke_until(self, scene, view, in_view, until)?,
            None => {
                let all = &mut in_view.iter().filter_map(|stretch| self.paths_of(stretch));
                ink(&self.image, view, all)?;
            }
        }
        self.heads = Default::default();
        if motions <= MAX_WITH_ARROWS {
            let done = |stretch: &&Stretch| {
                stretch.motions.start..stretch.motions.end.min(until.unwrap_or(usize::MAX))
            };
            self.arrows(scene, view, &in_view.iter().map(done).collect::<Vec<_>>());
        }
        self.image.unclip();
        Ok(())
    }

    /// Adds the strokes of new motions to an image of `motions` motions.
    fn add(&mut self, scene: &Scene, view: &View, done: Range<usize>, motions: usize) -> Result<(), JsValue> {
        self.image.begin(view)?;
        self.image.clip(view)?;
        ink(&self.image, view, &mut [&Paths::of(scene.strokes_of(done.clone()))?].into_iter())?;
        if motions <= MAX_WITH_ARROWS {
            self.arrows(scene, view, &[done]);
        }
        self.image.unclip();
        Ok(())
    }

    /// Draws the strokes before `until`, and those after it faintly.
    fn stroke_until(
        &self,
        scene: &Scene,
        view: &View,
        in_view: &[&Stretch],
        until: usize,
    ) -> Result<(), JsValue> {
        let (before, after) = split_stretch(scene, until)?;
        let ahead = in_view.iter().filter(|stretch| stretch.motions.start > until);
        let done = in_view.iter().filter(|stretch| stretch.motions.end <= until);
        let pen = &self.image;
        pen.opacity(OPACITY_AHEAD);
        ink(pen, view, &mut [&after].into_iter().chain(ahead.filter_map(|stretch| self.paths_of(stretch))))?;
        pen.opacity(1.0);
        ink(pen, view, &mut done.filter_map(|stretch| self.paths_of(stretch)).chain([&before]))
    }

    fn paths_of(&self, stretch: &Stretch) -> Option<&Paths> {
        self.paths.iter().find(|(key, _)| *key == stretch.key).map(|(_, paths)| paths)
    }

    /// Draws arrow heads on motions.
    fn arrows(&mut self, scene: &Scene, view: &View, run: &[Range<usize>]) {
        for (style, heads) in [StrokeStyle::Feed, StrokeStyle::Thread].into_iter().zip(&mut self.heads) {
            let before = heads.len();
            let strokes = run.iter().flat_map(|motions| scene.strokes_of(motions.clone()));
            let shapes = strokes.filter(|s| s.style == style && !s.uncertain).map(|stroke| stroke.shape);
            add_arrow_heads(heads, shapes, view.camera(), MIN_FOR_ARROW);
            let colour = sheet::colour(&view.palette, Ink::Sure(style));
            self.image.fill(colour, heads[before..].iter().map(|head| &head[..]));
        }
    }
}

/// The playhead at the start of the current motion, so that its finished part is omitted.
fn before(playhead: Playhead) -> Playhead {
    Playhead { motion: playhead.motion + usize::from(playhead.share >= 1.0), share: 0.0 }
}

/// Draws paths, each in the style of its ink.
fn ink(pen: &Pen, view: &View, paths: &mut dyn Iterator<Item = &Paths>) -> Result<(), JsValue> {
    let paths: Vec<&Paths> = paths.collect();
    for ink in Ink::ALL {
        let inked: Vec<_> = paths.iter().filter_map(|paths| paths.get(ink)).collect();
        let dots = paths.iter().flat_map(|paths| paths.dots(ink));
        let colour = sheet::colour(&view.palette, ink);
        if !inked.is_empty() {
            pen.world(view, sheet::width(ink), sheet::dash(ink), colour)?;
            inked.into_iter().for_each(|path| pen.stroke(path));
        }
        pen.page(view)?;
        pen.dots(colour, dots.map(|at| view.camera().to_screen(*at)), 3.0)?;
    }
    Ok(())
}

/// Plots a stretch; motions ahead of the tool are faint.
fn plot_stretch(plot: &mut Plot, scene: &Scene, stretch: &Stretch, done: Option<usize>) {
    for shape in scene.programmed_in(stretch) {
        plot.draw(PROGRAMMED, &shape);
    }
    let until = done.unwrap_or(usize::MAX);
    let (chunk, places) = scene.chunk_of(stretch);
    for (at, motion) in places.zip(stretch.motions.clone()) {
        let ink = Ink::new(StrokeStyle::of(chunk.kind(at)), chunk.is_uncertain(at)).index();
        let layer = if motion >= until { ink } else { DONE + ink };
        match chunk.straight_on_workpiece(at) {
            Some((from, to)) => plot.line(layer, from, to),
            None => plot.draw(layer, &StrokeShape::in_chunk(chunk, at)),
        }
    }
    plot.lift();
}

/// Combines rows of the layers of a plot in their colours; returns red, green, blue and opacity of each
/// pixel.
fn coloured(plot: &Plot, rows: Range<usize>, colours: &Colours) -> Vec<u8> {
    let (width, _) = plot.size();
    let part = rows.start * width..rows.end * width;
    let mut pixels = vec![0; 4 * part.len()];
    let mut lay = |picture: usize, colour: usize, opacity: f64| {
        if let Some(cover) = plot.cover(picture).get(part.clone()) {
            lay_over(&mut pixels, cover, colours[colour], (opacity * 255.0) as u32);
        }
    };
    lay(PROGRAMMED, Ink::ALL.len(), 1.0);
    for (first, opacity) in [(0, OPACITY_AHEAD), (DONE, 1.0)] {
        for ink in Ink::ALL {
            lay(first + ink.index(), ink.index(), opacity);
        }
    }
    pixels
}

/// Blends a colour over pixels, in proportion to how much of each is covered.
fn lay_over(pixels: &mut [u8], cover: &[u8], colour: [u8; 3], opacity: u32) {
    for (pixel, &cover) in pixels.chunks_exact_mut(4).zip(cover) {
        if cover == 0 {
            continue;
        }
        let over = u32::from(cover) * opacity / 255;
        if pixel[3] == 0 {
            pixel.copy_from_slice(&[colour[0], colour[1], colour[2], over as u8]);
            continue;
        }
        let under = u32::from(pixel[3]) * (255 - over) / 255;
        let all = (over + under).max(1);
        for (channel, own) in pixel.iter_mut().zip(colour) {
            *channel = ((u32::from(own) * over + u32::from(*channel) * under) / all) as u8;
        }
        pixel[3] = all as u8;
    }
}
