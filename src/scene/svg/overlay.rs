//! The tool paths of two programs in one file, marked by whether the first, the second or both make them.
//!
//! In: the motions of both. Out: an SVG file with a legend. The three kinds of stroke differ in colour, width
//! and dashes. Strokes are equal if their kind, ends and centre are, regardless of their place in the
//! programs.

use std::collections::HashSet;
use std::fmt::Write;

use crate::geometry::bounds::{Bounds, join};
use crate::motion::Motions;

use super::super::camera::{Camera, Pixel, Size};
use super::super::palette::Palette;
use super::super::path_index::PathIndex;
use super::super::ruler::ticks;
use super::super::{Plane, Scene, Stroke, StrokeShape, StrokeStyle};
use super::apart::Apart;
use super::caption::escaped;
use super::{BOTTOM_RULER, Drawing, Ground, HEIGHTS, LEFT_RULER, SHAPES, SvgOptions, colours, number};

/// Maximum number of strokes that are drawn of each program; with more, the picture would be unreadable and
/// the file too large for a browser.
pub const MAX_STROKES: usize = 20_000;

/// Distance between lines of the legend, CSS pixels.
const LEADING: f64 = 20.0;

/// The three kinds of stroke, in drawing order.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Owner {
    Both,
    First,
    Second,
}

impl Owner {
    const ALL: [Self; 3] = [Self::Both, Self::First, Self::Second];

    fn class(self) -> &'static str {
        match self {
            Self::Both => "both",
            Self::First => "first",
            Self::Second => "second",
        }
    }
}

/// The key by which strokes are compared, in thousandths of a millimetre.
type Key = (u8, [i64; 6]);

/// The drawing. `legend` names the strokes of the first only, of the second only, and of both.
pub fn overlay(programs: [&Motions; 2], legend: &[String; 3], options: &SvgOptions) -> String {
    let indices = programs.map(PathIndex::of);
    let scenes = [0, 1].map(|side| Scene::new(programs[side], &indices[side], None));
    let bounds =
        join(Some(scenes[0].bounds()), Some(scenes[1].bounds())).unwrap_or_else(|| scenes[0].bounds());
    let size = size(bounds, options);
    let camera = Camera::fit_with(bounds, size, options.x_plus);
    let mut drawing = Drawing { text: String::new(), camera, apart: Apart::default(), down: None };
    drawing.overlay(&scenes, legend, options);
    drawing.text
}

fn size(bounds: Bounds, options: &SvgOptions) -> Size {
    let width = options.width.max(120.0);
    let chosen = || Camera::height_for(bounds, width, HEIGHTS[0], HEIGHTS[1]);
    Size { width, height: options.height.map_or_else(chosen, |height| height.max(80.0)) }
}

impl Drawing {
    fn overlay(&mut self, scenes: &[Scene; 2], legend: &[String; 3], options: &SvgOptions) {
        let Size { width, height } = self.camera.size();
        let [w, h] = [width, height].map(number);
        self.line(&format!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" class="lathe" role="img" viewBox="0 0 {w} {h}" width="{w}" height="{h}">"#
        ));
        self.line(&format!("<title>{}</title>", escaped(&legend.join(", "))));
        self.line("<style>");
        self.line(SHAPES);
        self.line(STROKES);
        self.line(&[colours(&Palette::light()), owners(&Palette::light())].concat());
        if options.ground == Ground::AsSystem {
            let dark = [colours(&Palette::dark()), owners(&Palette::dark())].concat();
            self.line(&format!("@media (prefers-color-scheme: dark) {{\n{dark}\n}}"));
        }
        self.line("</style>");
        self.line(&format!(r#"<rect class="background" width="{w}" height="{h}"/>"#));
        let (x, inner, high) =
            (number(LEFT_RULER), number(width - LEFT_RULER), number(height - BOTTOM_RULER));
        self.line(&format!(
            r#"<svg x="{x}" width="{inner}" height="{high}" viewBox="{x} 0 {inner} {high}">"#
        ));
        let [along, across] = scenes[0].axes().map(|axis| ticks(axis, &self.camera, options.scale.unit));
        self.grid(&along, &across);
        self.center_lines(Plane::Section);
        let keys = scenes.each_ref().map(keys);
        for owner in Owner::ALL {
            let (scene, others) = match owner {
                Owner::Second => (&scenes[1], &keys[0]),
                Owner::Both | Owner::First => (&scenes[0], &keys[1]),
            };
            let own = |stroke: &Stroke| others.contains(&key(stroke)) == (owner == Owner::Both);
            self.owned(scene, owner, own);
        }
        self.explain(legend);
        self.line("</svg>");
        self.rulers(scenes[0].axes(), options.scale.symbol, &along, &across);
        self.line("</svg>");
    }

    /// Draws the strokes of one kind: one path for cuts and one for rapids.
    fn owned(&mut self, scene: &Scene, owner: Owner, own: impl Fn(&Stroke) -> bool) {
        for is_rapid in [true, false] {
            let mut d = String::new();
            for stroke in scene.strokes().take(MAX_STROKES) {
                if (stroke.style == StrokeStyle::Rapid) != is_rapid || !own(&stroke) {
                    continue;
                }
                let shape = stroke.drawn_shape();
                let _ = write!(d, "M{}", self.place(shape.start()));
                self.shape(&mut d, &shape);
            }
            if !d.is_empty() {
                let (class, rapid) = (owner.class(), if is_rapid { " rapid" } else { "" });
                self.line(&format!(r#"<path class="owned {class}{rapid}" d="{d}"/>"#));
            }
        }
    }

    /// Draws the legend in the upper right corner: a sample of each kind beside its name.
    fn explain(&mut self, [first, second, both]: &[String; 3]) {
        let right = self.camera.size().width - 12.0;
        let entries = [(Owner::First, first), (Owner::Second, second), (Owner::Both, both)];
        for (index, (owner, text)) in entries.into_iter().enumerate() {
            let y = 20.0 + LEADING * index as f64;
            let from = Pixel::new(right - 34.0, y - 4.0);
            let [x, top] = [from.x, from.y].map(number);
            self.line(&format!(
                r#"<path class="owned {}" d="M{x} {top}h34"/><text class="legend" x="{}" y="{}">{}</text>"#,
                owner.class(),
                number(right - 42.0),
                number(y),
                escaped(text),
            ));
        }
    }
}

fn keys(scene: &Scene) -> HashSet<Key> {
    scene.strokes().take(MAX_STROKES).map(|stroke| key(&stroke)).collect()
}

fn key(stroke: &Stroke) -> Key {
    let shape = stroke.drawn_shape();
    let (from, to) = (shape.start(), shape.end());
    let (kind, middle) = match &shape {
        StrokeShape::Line { .. } => (0, to),
        StrokeShape::Dot(_) => (1, to),
        StrokeShape::Arc(arc) => (2, arc.at(0.5)),
        StrokeShape::Virtual(_) => (3, shape.at(0.5)),
    };
    let thousandths = |mm: f64| (1000.0 * mm).round() as i64;
    let ends = [from.x, from.z, to.x, to.z, middle.x, middle.z].map(thousandths);
    (4 * stroke.style as u8 + kind, ends)
}

/// Widths and dashes.
const STROKES: &str = "\
.lathe .owned { fill: none; stroke-linejoin: round }
.lathe .owned.both { stroke-width: 1 }
.lathe .owned.first { stroke-width: 2.5; stroke-dasharray: 7 4 }
.lathe .owned.second { stroke-width: 2 }
.lathe .owned.rapid { stroke-width: 1; stroke-dasharray: 2 4 }";

fn owners(palette: &Palette) -> String {
    let Palette { axis, only_first, only_second, .. } = palette;
    format!(
        "\n.lathe .owned.both {{ stroke: {axis} }}\n.lathe .owned.first {{ stroke: {only_first} }}\n.lathe .owned.second {{ stroke: {only_second} }}"
    )
}
