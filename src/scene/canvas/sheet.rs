//! The layers under the strokes: background, grid, workpiece, centre line and rulers; and the style of
//! strokes.
//!
//! In: a scene and a view. Out: pixels. Line weights follow technical drawings: cuts heavy, everything else
//! thin.

use wasm_bindgen::JsValue;

use super::super::camera::{BOTTOM_RULER, LEFT_RULER, Pixel, Size};
use super::super::clip::{self, Piece};
use super::super::hatch::{Slant, hatch, hatch_slanted};
use super::super::ink::Ink;
use super::super::palette::Palette;
use super::super::ruler::{Axis, Tick, TickWeight, ticks};
use super::super::view::View;
use super::super::work::{Outlines, closed, edges};
use super::super::{Plane, Scene, StrokeStyle};
use super::pen::{Dash, Pen, Text};
use crate::geometry::Point;
use crate::machine::resolved_setup::Basis;
use crate::parts::{Part, late};

const FONT: &str = "12px system-ui, sans-serif";
const NAME_FONT: &str = "600 12px system-ui, sans-serif";

/// The colour of an ink.
pub fn colour(palette: &Palette, ink: Ink) -> &str {
    match ink {
        Ink::Uncertain(_) => &palette.uncertain,
        Ink::Sure(StrokeStyle::Rapid) => &palette.rapid,
        Ink::Sure(StrokeStyle::Dwell | StrokeStyle::Feed) => &palette.feed,
        Ink::Sure(StrokeStyle::Thread) => &palette.thread,
    }
}

/// Maximum line width, CSS pixels.
pub const WIDEST: f64 = 1.75;

/// The line width of an ink, CSS pixels.
pub fn width(ink: Ink) -> f64 {
    match ink.style() {
        StrokeStyle::Rapid => 1.0,
        StrokeStyle::Dwell | StrokeStyle::Feed => WIDEST,
        StrokeStyle::Thread => 1.25,
    }
}

/// The dash pattern of an ink.
pub fn dash(ink: Ink) -> Dash {
    match ink.style() {
        StrokeStyle::Rapid => Dash::Broken(5.0, 4.0),
        StrokeStyle::Dwell | StrokeStyle::Feed | StrokeStyle::Thread => Dash::Solid,
    }
}

late! {
    fn draw_work(pen: &Pen, scene: &Scene, view: &View) -> Result<(), JsValue> {
        work(pen, scene, view)
    }
}

/// Draws the layers under the strokes.
pub fn paper(pen: &Pen, scene: &Scene, view: &View) -> Result<(), JsValue> {
    let (camera, palette) = (view.camera(), &view.palette);
    let Size { width, height } = camera.size();
    pen.block(&palette.background, Pixel::default(), Pixel::new(width, height));
    pen.clip(view)?;
    let major = |tick: &Tick| tick.weight == TickWeight::Major;
    let [along, across] = scene.axes().map(|axis| ticks(axis, camera, view.scale.unit));
    let upright =
        along.iter().filter(|tick| major(tick)).map(|tick| from_to((tick.pixel, 0.0), (tick.pixel, height)));
    pen.hairlines(view, &palette.grid, Dash::Solid, upright)?;
    let level =
        across.iter().filter(|tick| major(tick)).map(|tick| from_to((0.0, tick.pixel), (width, tick.pixel)));
    pen.hairlines(view, &palette.grid, Dash::Solid, level)?;
    // The functions that compute the workpiece are in this part.
    if Part::Late.is_loaded() {
        draw_work(pen, scene, view)?;
    }
    center_lines(pen, scene.plane(), view)?;
    pen.unclip();
    Ok(())
}

/// Draws the blank, the part, and the obstacles around them, above and below the axis.
fn work(pen: &Pen, scene: &Scene, view: &View) -> Result<(), JsValue> {
    let Some(work) = scene.work() else { return Ok(()) };
    let (camera, palette) = (view.camera(), &view.palette);
    pen.page(view)?;
    for side in scene.plane().sides() {
        let corners = |outline: &Vec<Point>| -> Vec<Pixel> {
            outline.iter().map(|at| camera.to_screen(Point::new(side * at.x, at.z))).collect()
        };
        let areas = |outlines: &Outlines| -> Vec<Vec<Pixel>> {
            outlines.iter().map(|outline| clip::polygon(&corners(outline), camera.size())).collect()
        };
        let lines = |lines: &Outlines| -> Vec<Piece> {
            lines.iter().flat_map(|line| clip::polyline(&corners(line), camera.size())).collect()
        };
        let (blank, part, obstacles) =
            (areas(&work.blank), areas(work.part_on(*side)), areas(&work.obstacles));
        let blank_edges = match scene.plane() {
            Plane::Section => lines(&edges(&work.blank)),
            Plane::Face | Plane::Side => lines(&closed(&work.blank)),
        };
        let [cut, left] = work.part_edges(scene.plane(), *side);
        pen.opacity(1.0);
        pen.fill(&palette.stock, blank.iter().map(Vec::as_slice));
        pen.polylines(&palette.stock_edge, &blank_edges, 1.0, blank_dash(work.basis))?;
        pen.fill(&palette.part, part.iter().map(Vec::as_slice));
        // Only the section is hatched; the other pictures are views from outside.
        if scene.plane() == Plane::Section {
            pen.opacity(0.35);
            let hatching = hatch(&part, camera.to_screen(Point::default()), camera.size());
            pen.lines(&palette.part_edge, 1.0, hatching.into_iter());
        }
        pen.opacity(0.25);
        pen.fill(&palette.axis, obstacles.iter().map(Vec::as_slice));
        if scene.plane() == Plane::Section {
            // Jaws, chuck and tailstock are in section too.
            pen.opacity(0.45);
            let hatching = hatch(&obstacles, camera.to_screen(Point::default()), camera.size());
            pen.lines(&palette.axis, 1.0, hatching.into_iter());
        }
        pen.opacity(1.0);
        pen.polylines(&palette.part_edge, &lines(&left), 1.5, blank_dash(work.basis))?;
        pen.polylines(&palette.part_edge, &lines(&cut), 1.5, Dash::Solid)?;
        pen.polylines(&palette.axis, &lines(&closed(&work.obstacles)), 1.0, Dash::Solid)?;
        pen.polylines(&palette.part_edge, &lines(&work.milled_lines()), 0.75, Dash::Solid)?;
        let [first, second] =
            work.compared.as_ref().map_or([None, None], |[first, second]| [Some(first), Some(second)]);
        for (only, colour, slant) in
            [(first, &palette.only_first, Slant::Falling), (second, &palette.only_second, Slant::Rising)]
        {
            let Some(only) = only else { continue };
            let pieces = areas(only);
            pen.opacity(0.16);
            pen.fill(colour, pieces.iter().map(Vec::as_slice));
            pen.opacity(0.8);
            let hatching = hatch_slanted(&pieces, camera.to_screen(Point::default()), camera.size(), slant);
            pen.lines(colour, 1.0, hatching.into_iter());
            pen.opacity(1.0);
            pen.polylines(colour, &lines(&closed(only)), 1.25, Dash::Solid)?;
        }
    }
    Ok(())
}

/// The dash pattern of the blank's outline: dashed if the blank is only inferred.
fn blank_dash(basis: Basis) -> Dash {
    match basis {
        Basis::Given => Dash::Solid,
        Basis::Inferred | Basis::Unknown => Dash::Broken(7.0, 4.0),
    }
}

fn center_lines(pen: &Pen, plane: Plane, view: &View) -> Result<(), JsValue> {
    let (zero, Size { width, height }) = (view.camera().to_screen(Point::default()), view.camera().size());
    let level = from_to((LEFT_RULER, zero.y), (width, zero.y));
    let upright = (plane == Plane::Face).then(|| from_to((zero.x, 0.0), (zero.x, height)));
    let lines = [level].into_iter().chain(upright);
    pen.hairlines(view, &view.palette.axis, Dash::Center([16.0, 4.0, 2.0, 4.0]), lines)
}

/// Draws the rulers over the edges of the picture.
pub fn rulers(pen: &Pen, axes: [Axis; 2], view: &View) -> Result<(), JsValue> {
    let (camera, palette) = (view.camera(), &view.palette);
    let Size { width, height } = camera.size();
    let (left, bottom) = (LEFT_RULER, height - BOTTOM_RULER);
    pen.page(view)?;
    pen.block(&palette.background, Pixel::default(), Pixel::new(left, height));
    pen.block(&palette.background, Pixel::new(0.0, bottom), Pixel::new(width, height));
    let edges = [from_to((left, 0.0), (left, bottom)), from_to((left, bottom), (width, bottom))];
    pen.hairlines(view, &palette.axis, Dash::Solid, edges.into_iter())?;
    let [along, across] = axes.map(|axis| ticks(axis, camera, view.scale.unit));
    let lines =
        along.iter().map(|tick| from_to((tick.pixel, bottom), (tick.pixel, bottom + tick.weight.length())));
    pen.hairlines(view, &palette.axis, Dash::Solid, lines)?;
    let lines =
        across.iter().map(|tick| from_to((left - tick.weight.length(), tick.pixel), (left, tick.pixel)));
    pen.hairlines(view, &palette.axis, Dash::Solid, lines)?;
    for tick in &along {
        label(pen, tick, "center", Pixel::new(tick.pixel, height - 10.0), palette)?;
    }
    for tick in &across {
        label(pen, tick, "right", Pixel::new(left - 10.0, tick.pixel), palette)?;
    }
    let [level, upright] = axes;
    let name = |axis: Axis, align: &str, at: Pixel| {
        let text = &axis.name(view.scale.symbol);
        pen.write(&Text { text, font: NAME_FONT, align, baseline: "middle" }, at, &palette.text)
    };
    name(upright, "left", Pixel::new(left + 7.0, 12.0))?;
    // In the corner of the rulers it hides no label.
    let corner = Pixel::new(left - 4.0, height - 10.0);
    name(level, "right", if level.has_long_name() { Pixel::new(width - 6.0, bottom - 12.0) } else { corner })
}

fn label(pen: &Pen, tick: &Tick, align: &str, at: Pixel, palette: &Palette) -> Result<(), JsValue> {
    match &tick.label {
        Some(text) => pen.write(&Text { text, font: FONT, align, baseline: "middle" }, at, &palette.text),
        None => Ok(()),
    }
}

fn from_to(from: (f64, f64), to: (f64, f64)) -> (Pixel, Pixel) {
    (Pixel::new(from.0, from.1), Pixel::new(to.0, to.1))
}
