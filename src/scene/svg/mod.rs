//! Writes the picture as a self-contained SVG file.
//!
//! In: a scene. Out: text that any browser, manual or drawing program shows: no scripts, no identifiers that
//! could clash in a page, light and dark colours. Every stroke has the line of its block (`data-line`, from
//! 1); there is one path for each block and style. The same scene gives the same bytes.

use std::fmt::Write;
use std::ops::Range;

use crate::geometry::bounds::Bounds;
use crate::geometry::{Arc, Point, Turn};
use crate::machine::SimulationResult;
use crate::machine::compare::Side;
use crate::machine::resolved_setup::Basis;
use crate::motion::Motions;

use super::annotation::{Annotation, Shape};
use super::camera::{BOTTOM_RULER, Camera, LEFT_RULER, Pixel, Size, XPlus};
use super::face::Face;
use super::hatch::hatch;
use super::marks::{MAX_WITH_ARROWS, MIN_FOR_ARROW, arrow_heads};
use super::occupied::Occupied;
use super::palette::Palette;
use super::path_index::PathIndex;
use super::placement::{NEXT, detail_sizes};
use super::ruler::{Axis, Scale, Tick, TickWeight, ticks};
use super::view::Frame;
use super::work::{Outlines, Work, closed, edges};
use super::{Plane, Scene, Stroke, StrokeShape, StrokeStyle};

mod annotations;
mod apart;
mod caption;
mod compared;
mod once;
mod overlay;

use apart::Apart;
pub use caption::{Caption, LEGEND};
pub use overlay::{MAX_STROKES, overlay};

/// The options of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct SvgOptions {
    /// Width, CSS pixels.
    pub width: f64,
    /// Height, CSS pixels; chosen by the contents if absent.
    pub height: Option<f64>,
    /// The background.
    pub ground: Ground,
    /// The direction of X+.
    pub x_plus: XPlus,
    /// The unit of the rulers.
    pub scale: Scale,
    /// The meaning of the two colours of a comparison.
    pub legend: Vec<(Side, String)>,
    /// The caption under the drawing.
    pub caption: Option<Caption>,
    /// How overlapping passes are drawn.
    pub passes: Passes,
    /// Dimensions and letters over the strokes.
    pub annotations: Vec<Annotation>,
    /// What is drawn.
    pub contents: Contents,
    /// The motions that are drawn; `None` for all. Only what is near them is in the picture.
    pub motions: Option<Vec<Range<usize>>>,
}

/// What a picture contains.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Contents {
    /// Path, blank, part and chuck.
    #[default]
    All,
    /// The finished part only, as in a workshop drawing.
    Part,
}

/// How overlapping passes are drawn (passes of G76, and pecks along one line).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Passes {
    /// At their true positions.
    #[default]
    InPlace,
    /// Side by side, as in manuals.
    Apart,
}

/// The background of a picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Ground {
    /// Light or dark, depending on the user's system.
    #[default]
    AsSystem,
    /// White paper.
    Paper,
    /// Black lines on white paper, without rulers and grid, for a printed page: cuts 0.5 mm wide, rapids 0.25 mm.
    Print,
}

impl Default for SvgOptions {
    fn default() -> Self {
        Self {
            width: 960.0,
            height: None,
            ground: Ground::default(),
            x_plus: XPlus::Up,
            scale: Scale::default(),
            legend: Vec::new(),
            caption: None,
            passes: Passes::default(),
            annotations: Vec::new(),
            contents: Contents::default(),
            motions: None,
        }
    }
}

impl SvgOptions {
    /// Whether the picture is a figure of some motions: without the chuck and the paths of others.
    fn is_figure(&self) -> bool {
        self.motions.is_some()
    }

    /// The options for a printed page, with a width in mm on paper: without rulers, at 96 CSS pixels per inch.
    pub fn on_paper(self, width: f64) -> Self {
        Self { width: width / 25.4 * 96.0 + LEFT_RULER, ground: Ground::Print, ..self }
    }
}

/// Space above and below an annotated picture on paper, CSS pixels.
const MARGIN: f64 = 12.0;

/// Space around an annotated picture, CSS pixels.
const ROOM_FOR_LABELS: f64 = 64.0;

/// Most space for lengths above each other, CSS pixels.
const MAX_STACKED: f64 = 240.0;

/// Space around the motions of a figure, as a share of their extent.
const AROUND: f64 = 0.2;

/// Minimum length of a stroke with an arrow head in a figure, CSS pixels.
const MIN_FOR_ARROW_IN_FIGURE: f64 = 18.0;

/// Minimum and maximum height if it is chosen by the contents, CSS pixels.
const HEIGHTS: [f64; 2] = [240.0, 720.0];

/// The picture as an SVG file.
pub fn svg(scene: &Scene, options: &SvgOptions) -> String {
    let camera = camera(scene, options);
    // A detail shows the passes of a thread, with their height k.
    let is_of_thread = |own: &Annotation| match &own.shape {
        Shape::Detail(detail) => detail.annotations.iter().any(|own| own.label.name == "k"),
        _ => false,
    };
    let has_detail = options.annotations.iter().any(is_of_thread);
    let apart = match (scene.plane(), options.passes) {
        (Plane::Section, Passes::Apart) => Apart::of(scene, has_detail, 1.0 / camera.scale()),
        (Plane::Section, Passes::InPlace) | (Plane::Face | Plane::Side, _) => Apart::default(),
    };
    let mut drawing = Drawing { text: String::new(), camera, apart, down: None };
    drawing.all(scene, options);
    drawing.text
}

/// The camera of a picture: it shows all of the scene, with room for labels around it and for a detail below.
pub fn camera(scene: &Scene, options: &SvgOptions) -> Camera {
    let width = options.width.max(120.0);
    let drawn = match options.contents {
        Contents::All => bounds_of_figure(scene, options).unwrap_or_else(|| scene.bounds()),
        Contents::Part => scene.bounds_of(Frame::Part),
    };
    let room = if options.annotations.is_empty() { 0.0 } else { ROOM_FOR_LABELS };
    let bounds = drawn.grown(room * drawn.length() / (width - 2.0 * room - LEFT_RULER).max(1.0));
    let x_plus = scene.plane().x_plus(options.x_plus);
    // Lengths are above each other, away from the axis; a detail is below.
    let lengths = options.annotations.iter().filter(|own| matches!(own.shape, Shape::Axial(_))).count();
    let stacked = (lengths as f64 * NEXT).min(MAX_STACKED);
    let least = if options.ground == Ground::Print { 0.3 * width } else { HEIGHTS[0] };
    let chosen = || Camera::height_for(bounds, width, least.min(HEIGHTS[0]), HEIGHTS[1]);
    let drawn_height = options.height.unwrap_or_else(chosen).max(80.0);
    let mut camera = Camera::fit_with(bounds, Size { width, height: drawn_height }, x_plus);
    let below = room_for_details(options, &camera);
    let height = drawn_height + stacked + below;
    let shift = if camera.upward() > 0.0 { stacked } else { 0.0 };
    camera.resize(Size { width, height });
    camera.pan(0.0, shift - (height - drawn_height) / 2.0);
    camera
}

/// The height of the details of a picture, side by side where they have room, CSS pixels.
fn room_for_details(options: &SvgOptions, camera: &Camera) -> f64 {
    let sizes = options.annotations.iter().filter_map(|own| match &own.shape {
        Shape::Detail(detail) => Some(detail_sizes(detail, camera.scale()).next()?.1),
        _ => None,
    });
    let (mut all, mut row) = (0.0, [0.0, 0.0]);
    for [width, height] in sizes {
        let is_beside = row[0] + width < options.width - LEFT_RULER;
        let high = height + ROOM_FOR_LABELS / 4.0;
        all += if is_beside { (high - row[1]).max(0.0) } else { high };
        row = if is_beside { [row[0] + width, high.max(row[1])] } else { [width, high] };
    }
    all
}

/// The strokes that are drawn.
fn drawn<'a>(scene: &Scene<'a>, options: &SvgOptions) -> impl Iterator<Item = Stroke> {
    let strokes = Some(scene.strokes()).filter(|_| options.contents == Contents::All);
    strokes.into_iter().flatten().filter(|stroke| {
        options.motions.as_ref().is_none_or(|motions| motions.iter().any(|own| own.contains(&stroke.motion)))
    })
}

/// The box of a figure: its motions, and the workpiece above and below the axis near them. `None` if all motions are
/// drawn.
fn bounds_of_figure(scene: &Scene, options: &SvgOptions) -> Option<Bounds> {
    options.motions.as_ref()?;
    let own = drawn(scene, options).map(|stroke| stroke.drawn_shape().bounds()).reduce(Bounds::union)?;
    let margin = AROUND * own.length().max(own.height());
    let near = own.grown(margin);
    let stock = scene.work().into_iter().flat_map(|work| work.blank.iter().flatten());
    let low = stock.map(|at| -at.x).fold(own.min.x.min(0.0), f64::min);
    let all = scene.bounds().union(own);
    Some(Bounds {
        min: Point::new(low, near.min.z.max(all.min.z)),
        max: Point::new(own.max.x.max(-low), near.max.z.min(all.max.z)),
    })
}

/// The half-section of a whole program as an SVG file; without a simulation, the workpiece is omitted.
pub fn section(motions: &Motions, simulation: Option<&SimulationResult>, options: &SvgOptions) -> String {
    let path_index = PathIndex::of(motions);
    let work = simulation.and_then(|simulation| {
        let milled = Face::of(motions, simulation).and_then(|face| face.milled(usize::MAX));
        Some(Work::of(simulation, motions, None)?.with_milled(milled))
    });
    svg(&Scene::new(motions, &path_index, work.as_ref()), options)
}

/// A file that is being written.
struct Drawing {
    text: String,
    camera: Camera,
    apart: Apart,
    /// The highest and the lowest place of an annotated picture, CSS pixels.
    down: Option<[f64; 2]>,
}

impl Drawing {
    fn all(&mut self, scene: &Scene, options: &SvgOptions) {
        let Size { width, height } = self.camera.size();
        let is_print = options.ground == Ground::Print;
        // A printed picture has neither grid nor rulers.
        let ticks = || scene.axes().map(|axis| ticks(axis, &self.camera, options.scale.unit));
        let ticks = (!is_print).then(ticks);
        if let Some([along, across]) = &ticks {
            self.grid(along, across);
        }
        self.picture(scene, options);
        let picture = std::mem::take(&mut self.text);
        // Without rulers their space is cut off, and so is that above and below an annotated picture.
        let [left, top, bottom] = match (is_print, self.down.filter(|_| options.height.is_none())) {
            (true, Some([highest, lowest])) => {
                [LEFT_RULER, (highest - MARGIN).max(0.0), (lowest + MARGIN).min(height - BOTTOM_RULER)]
            }
            (true, None) => [LEFT_RULER, 0.0, height - BOTTOM_RULER],
            (false, _) => [0.0, 0.0, height],
        };
        // The height of the caption is only known once it is written.
        let under = options.caption.as_ref().map(|caption| {
            let high = self.caption(scene, caption, options, [left, bottom]);
            (high, std::mem::take(&mut self.text))
        });
        let whole = bottom - top + under.as_ref().map_or(0.0, |(high, _)| *high);
        let [x, y, w, h] = [left, top, width - left, whole].map(number);
        self.line(&format!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" class="lathe" role="img" viewBox="{x} {y} {w} {h}" width="{w}" height="{h}">"#
        ));
        if let Some(caption) = options.caption.as_ref().filter(|caption| !caption.title.is_empty()) {
            self.line(&format!("<title>{}</title>", caption::escaped(&caption.title)));
        }
        self.line("<style>");
        self.line(SHAPES);
        let colours = |palette: Palette| match options.annotations.is_empty() {
            true => colours(&palette),
            false => format!("{}\n{}", colours(&palette), annotations::colours(&palette)),
        };
        if !options.annotations.is_empty() {
            self.line(annotations::SHAPES);
        }
        self.line(&colours(Palette::light()));
        if options.ground == Ground::AsSystem {
            self.line(&format!("@media (prefers-color-scheme: dark) {{\n{}\n}}", colours(Palette::dark())));
        }
        if is_print {
            self.line(PRINT);
        }
        self.line("</style>");
        let [from, down] = match is_print {
            true => [format!(r#" x="{x}""#), format!(r#" y="{y}""#)],
            false => [String::new(), String::new()],
        };
        self.line(&format!(r#"<rect class="background"{from}{down} width="{w}" height="{h}"/>"#));
        let bottom = bottom.min(height - BOTTOM_RULER);
        let [x, y, w, h] = [LEFT_RULER, top, width - LEFT_RULER, bottom - top].map(number);
        self.line(&format!(r#"<svg x="{x}"{down} width="{w}" height="{h}" viewBox="{x} {y} {w} {h}">"#));
        self.text.push_str(&picture);
        self.line("</svg>");
        if let Some([along, across]) = &ticks {
            self.rulers(scene.axes(), options.scale.symbol, along, across);
        }
        if let Some((_, rows)) = under {
            self.text.push_str(&rows);
        }
        self.line("</svg>");
    }

    /// The picture without grid, rulers and caption.
    fn picture(&mut self, scene: &Scene, options: &SvgOptions) {
        self.work(scene, options);
        self.compared(scene);
        self.center_lines(scene.plane());
        if options.contents == Contents::All {
            if !options.is_figure() {
                self.programmed(scene);
            }
            for style in StrokeStyle::ALL {
                match style {
                    StrokeStyle::Rapid if options.is_figure() => self.rapids(scene, options),
                    _ => self.strokes(scene, options, style),
                }
            }
            self.arrows(scene, options);
            self.dangers(scene);
        }
        self.annotations(scene, options);
        self.legend(&options.legend);
    }

    fn grid(&mut self, along: &[Tick], across: &[Tick]) {
        let Size { width, height } = self.camera.size();
        let mut d = String::new();
        for tick in along.iter().filter(|tick| tick.weight == TickWeight::Major) {
            let _ = write!(d, "M{} 0V{}", sharp(tick.pixel), number(height - BOTTOM_RULER));
        }
        for tick in across.iter().filter(|tick| tick.weight == TickWeight::Major) {
            let _ = write!(d, "M{} {}H{}", number(LEFT_RULER), sharp(tick.pixel), number(width));
        }
        self.line(&format!(r#"<path class="grid" d="{d}"/>"#));
    }

    /// Draws the blank, the part, and the obstacles around them, above and below the axis.
    fn work(&mut self, scene: &Scene, options: &SvgOptions) {
        let contents = options.contents;
        let Some(work) = scene.work() else { return };
        let guessed = match work.basis {
            Basis::Given => "",
            Basis::Inferred | Basis::Unknown => " guessed",
        };
        for side in scene.plane().sides() {
            let seen = |outlines: &Outlines, camera: &Camera| -> Vec<Vec<Pixel>> {
                let place = |at: &Point| camera.to_screen(Point::new(side * at.x, at.z));
                outlines.iter().map(|outline| outline.iter().map(place).collect()).collect()
            };
            let camera = &self.camera;
            let (part, zero) = (seen(work.part_on(*side), camera), camera.to_screen(Point::default()));
            // Only the section is hatched; the other pictures are views from outside.
            let hatching = |outlines: &[Vec<Pixel>]| -> String {
                let lines = match scene.plane() {
                    Plane::Section => hatch(outlines, zero, camera.size()),
                    Plane::Face | Plane::Side => Vec::new(),
                };
                lines.iter().map(|[a, b]| format!("M{}L{}", pixel(*a), pixel(*b))).collect()
            };
            let has_obstacles = contents == Contents::All && !options.is_figure();
            let obstacles = if has_obstacles { seen(&work.obstacles, camera) } else { Vec::new() };
            let blank_edges = match scene.plane() {
                Plane::Section => edges(&work.blank),
                Plane::Face | Plane::Side => closed(&work.blank),
            };
            let [cut, left] = work.part_edges(scene.plane(), *side);
            let lines = |lines: &Vec<Vec<Point>>| polylines(&seen(lines, camera), "");
            let shapes = [
                ("blank", polylines(&seen(&work.blank, camera), "Z")),
                ("part", polylines(&part, "Z")),
                ("hatch", hatching(&part)),
                ("obstacle", polylines(&obstacles, "Z")),
                ("hatch", hatching(&obstacles)),
            ];
            let edges = [
                (["blank-edge", guessed].concat(), lines(&blank_edges)),
                (["part-edge", guessed].concat(), lines(&left)),
                ("part-edge".to_owned(), lines(&cut)),
                ("milled".to_owned(), lines(&work.milled_lines())),
            ];
            let is_drawn = |class: &str| contents == Contents::All || !class.starts_with("blank");
            for (class, d) in shapes.iter().filter(|(class, d)| !d.is_empty() && is_drawn(class)) {
                self.line(&format!(r#"<path class="{class}" d="{d}"/>"#));
            }
            for (class, d) in edges.iter().filter(|(class, d)| !d.is_empty() && is_drawn(class)) {
                self.line(&format!(r#"<path class="{class}" d="{d}"/>"#));
            }
        }
    }

    /// Draws a cross at each collision.
    fn dangers(&mut self, scene: &Scene) {
        let Some(work) = scene.work().filter(|work| !work.dangers.is_empty()) else { return };
        let mut d = String::new();
        for at in work.dangers.iter().map(|at| self.camera.to_screen(*at)) {
            let (x, y) = (number(at.x - 8.0), number(at.y));
            let _ = write!(d, "M{x} {y}a8 8 0 1 0 16 0a8 8 0 1 0 -16 0m4 -4l8 8m0 -8l-8 8");
        }
        self.line(&format!(r#"<path class="danger" d="{d}"/>"#));
    }

    fn center_lines(&mut self, plane: Plane) {
        let zero = self.camera.to_screen(Point::default());
        let (from, to) = (number(LEFT_RULER), number(self.camera.size().width));
        let upright = match plane {
            Plane::Section | Plane::Side => String::new(),
            Plane::Face => {
                format!("M{} 0V{}", sharp(zero.x), number(self.camera.size().height - BOTTOM_RULER))
            }
        };
        self.line(&format!(r#"<path class="center" d="M{from} {}H{to}{upright}"/>"#, sharp(zero.y)));
    }

    fn strokes(&mut self, scene: &Scene, options: &SvgOptions, style: StrokeStyle) {
        let mut strokes = drawn(scene, options).filter(|stroke| stroke.style == style).peekable();
        if strokes.peek().is_none() {
            return;
        }
        self.line(&format!(r#"<g class="{}">"#, style.name()));
        let mut d = String::new();
        let (mut last, mut end) = (None::<Stroke>, None::<Point>);
        for stroke in strokes {
            if let Some(before) = last.filter(|before| is_other_path(before, &stroke)) {
                self.path(&before, &d);
                d.clear();
                last = None;
            }
            let shape = self.apart.shape(&stroke);
            let joined = end.is_some_and(|end| end.is_same(shape.start()));
            if !joined || last.is_none() || style == StrokeStyle::Rapid {
                let _ = write!(d, "M{}", self.place(shape.start()));
            }
            self.shape(&mut d, &shape);
            (last, end) = (Some(stroke), Some(shape.end()));
        }
        if let Some(before) = last {
            self.path(&before, &d);
        }
        self.line("</g>");
    }

    /// Draws the rapids of a figure, each line once: dashes over dashes would look like a cut.
    fn rapids(&mut self, scene: &Scene, options: &SvgOptions) {
        let (mut lines, mut d) = (Vec::new(), String::new());
        for stroke in drawn(scene, options).filter(|stroke| stroke.style == StrokeStyle::Rapid) {
            match self.apart.shape(&stroke) {
                StrokeShape::Line { from, to } => lines.push([from, to].map(|at| self.camera.to_screen(at))),
                shape => {
                    let _ = write!(d, "M{}", self.place(shape.start()));
                    self.shape(&mut d, &shape);
                }
            }
        }
        for [from, to] in once::each(&lines) {
            let _ = write!(d, "M{}L{}", pixel(from), pixel(to));
        }
        if !d.is_empty() {
            self.line(&format!(r#"<g class="rapid"><path class="rapid" d="{d}"/></g>"#));
        }
    }

    /// Draws the programmed path under the compensated one, thin and dotted.
    fn programmed(&mut self, scene: &Scene) {
        let mut d = String::new();
        for shape in scene.programmed() {
            let _ = write!(d, "M{}", self.place(shape.start()));
            self.shape(&mut d, &shape);
        }
        if !d.is_empty() {
            self.line(&format!(r#"<path class="programmed" d="{d}"/>"#));
        }
    }

    /// Writes a path element: all strokes of a block in one style.
    fn path(&mut self, stroke: &Stroke, d: &str) {
        let name = stroke.style.name();
        let dimmed = if stroke.uncertain { " uncertain" } else { "" };
        self.line(&format!(r#"<path data-line="{}" class="{name}{dimmed}" d="{d}"/>"#, stroke.line + 1));
    }

    /// Continues a path from the start of a shape to its end.
    fn shape(&self, d: &mut String, shape: &StrokeShape) {
        let _ = match shape {
            StrokeShape::Line { to, .. } => write!(d, "L{}", self.place(*to)),
            // A line of zero length with round caps is a dot.
            StrokeShape::Dot(_) => write!(d, "h0"),
            StrokeShape::Virtual(own) => {
                let curve = StrokeShape::curve(own);
                curve.iter().skip(1).try_for_each(|point| write!(d, "L{}", self.place(*point)))
            }
            StrokeShape::Arc(arc) => write!(d, "{}{}", self.half(arc, 0.5), self.half(arc, 1.0)),
        };
    }

    /// Half of an arc, up to the fraction `t`. In halves, a full circle has distinct ends, and no arc is
    /// ambiguous.
    fn half(&self, arc: &Arc, t: f64) -> String {
        let radius = number(self.camera.scale() * arc.center.distance(arc.at(t - 0.25)));
        let sweep = match arc.turn {
            Turn::Clockwise => self.camera.x_plus() == XPlus::Up,
            Turn::Counterclockwise => self.camera.x_plus() == XPlus::Down,
        };
        let sweep = u8::from(sweep);
        let end = if t < 1.0 { arc.at(t) } else { arc.end };
        format!("A{radius} {radius} 0 0 {sweep} {}", self.place(end))
    }

    /// Draws arrow heads at the cuts, in a figure also at the rapids and at shorter strokes.
    fn arrows(&mut self, scene: &Scene, options: &SvgOptions) {
        if scene.len() > MAX_WITH_ARROWS {
            return;
        }
        let is_figure = options.is_figure();
        let least = if is_figure { MIN_FOR_ARROW_IN_FIGURE } else { MIN_FOR_ARROW };
        let rapids = [StrokeStyle::Rapid].into_iter().filter(|_| is_figure);
        let cuts = drawn(scene, options).filter(|stroke| stroke.style != StrokeStyle::Rapid);
        let cuts = cuts.map(|cut| self.apart.directed(&cut)).filter(|_| is_figure);
        let cuts = Occupied::of_strokes(&self.camera, cuts);
        // The arrows of a cut and of a rapid over it would read as a zigzag.
        let camera = self.camera;
        let is_covered = |stroke: &StrokeShape| match *stroke {
            StrokeShape::Line { from, to } => {
                let ends = [from, to].map(|at| camera.to_screen(at));
                let own: f64 =
                    cuts.beside_strokes(ends).iter().map(|piece| piece[0].distance(piece[1])).sum();
                own < 0.5 * ends[0].distance(ends[1])
            }
            _ => false,
        };
        for style in rapids.chain([StrokeStyle::Feed, StrokeStyle::Thread]) {
            let strokes = drawn(scene, options).filter(|stroke| stroke.style == style && !stroke.uncertain);
            let shapes = strokes.map(|stroke| self.apart.directed(&stroke));
            let shapes = shapes.filter(|shape| style != StrokeStyle::Rapid || !is_covered(shape));
            let heads = arrow_heads(shapes, &self.camera, least);
            if heads.is_empty() {
                continue;
            }
            let mut d = String::new();
            for [tip, a, b] in heads {
                let _ = write!(d, "M{}L{}L{}Z", pixel(tip), pixel(a), pixel(b));
            }
            self.line(&format!(r#"<path class="arrow {}" d="{d}"/>"#, style.name()));
        }
    }

    fn rulers(&mut self, axes: [Axis; 2], symbol: &str, along: &[Tick], across: &[Tick]) {
        let Size { width, height } = self.camera.size();
        let (left, bottom) = (LEFT_RULER - 0.5, height - BOTTOM_RULER + 0.5);
        let mut d = format!("M{} 0V{}H{}", number(left), number(bottom), number(width));
        let mut labels = String::new();
        for tick in along {
            let length = tick.weight.length();
            let _ = write!(d, "M{} {}v{length}", sharp(tick.pixel), number(bottom));
            if let Some(label) = &tick.label {
                let (x, y) = (number(tick.pixel), number(height - 7.0));
                let _ = writeln!(labels, r#"<text class="z" x="{x}" y="{y}">{label}</text>"#);
            }
        }
        for tick in across {
            let length = tick.weight.length();
            let _ = write!(d, "M{} {}h-{length}", number(left), sharp(tick.pixel));
            if let Some(label) = &tick.label {
                let (x, y) = (number(LEFT_RULER - 10.0), number(tick.pixel + 4.0));
                let _ = writeln!(labels, r#"<text class="x" x="{x}" y="{y}">{label}</text>"#);
            }
        }
        self.line(&format!(r#"<path class="ruler" d="{d}"/>"#));
        self.text.push_str(&labels);
        let [z, x] = axes.map(|axis| axis.name(symbol));
        self.line(&format!(r#"<text class="name" x="{}" y="16">{x}</text>"#, number(LEFT_RULER + 7.0)));
        let (right, low) = match axes[0].has_long_name() {
            true => (number(width - 6.0), number(bottom - 8.0)),
            false => (number(LEFT_RULER - 4.0), number(height - 7.0)),
        };
        self.line(&format!(r#"<text class="name z" x="{right}" y="{low}">{z}</text>"#));
    }

    fn place(&self, point: Point) -> String {
        pixel(self.camera.to_screen(point))
    }

    fn line(&mut self, line: &str) {
        self.text.push_str(line);
        self.text.push('\n');
    }
}

/// The style rules that do not depend on the colours: line widths, dashes and fonts.
const SHAPES: &str = "\
.lathe .grid, .lathe .ruler, .lathe .center, .lathe g path, .lathe .programmed { fill: none }
.lathe g path { stroke-linejoin: round; stroke-width: 1.75 }
.lathe g path.rapid { stroke-width: 1; stroke-dasharray: 5 4 }
.lathe g path.thread { stroke-width: 1.25 }
.lathe g path.dwell { stroke-width: 6; stroke-linecap: round }
.lathe .center { stroke-dasharray: 16 4 2 4 }
.lathe .programmed { stroke-dasharray: 2 3 }
.lathe .blank-edge, .lathe .part-edge, .lathe .hatch, .lathe .milled { fill: none }
.lathe .milled { stroke-width: 0.75 }
.lathe .blank-edge.guessed, .lathe .part-edge.guessed { stroke-dasharray: 7 4 }
.lathe .part-edge { stroke-width: 1.5; stroke-linejoin: round }
.lathe .hatch { opacity: 0.35 }
.lathe .obstacle { fill-opacity: 0.25 }
.lathe .only { fill-opacity: 0.16; stroke-width: 1.25 }
.lathe .only.hatch { fill: none; opacity: 0.8; stroke-width: 1 }
.lathe text.legend { text-anchor: end }
.lathe .blank-frame, .lathe .part-frame { stroke-width: 1.5 }
.lathe .danger { fill: none; stroke-width: 2.5 }
.lathe text { font: 12px system-ui, sans-serif; font-variant-numeric: tabular-nums }
.lathe text.x { text-anchor: end }
.lathe text.z { text-anchor: middle }
.lathe text.name { font-weight: 600 }
.lathe text.name.z { text-anchor: end }";

/// Style rules of a printed page; they follow [`SHAPES`] and the palette.
const PRINT: &str = "\
.lathe .blank, .lathe .part { fill: #fff }
.lathe .obstacle { fill: #000; fill-opacity: 0.15; stroke: #000 }
.lathe .center, .lathe .programmed, .lathe .blank-edge, .lathe .blank-frame { stroke: #000; stroke-width: 0.7 }
.lathe .part-edge, .lathe .part-frame { stroke: #000; stroke-width: 1.3 }
.lathe .hatch, .lathe .milled { stroke: #000; stroke-width: 0.5; opacity: 0.6 }
.lathe g .feed, .lathe g .thread, .lathe g .dwell, .lathe g .uncertain { stroke: #000 }
.lathe g path.feed, .lathe g path.thread { stroke-width: 1.9 }
.lathe g .rapid { stroke: #000 }
.lathe g path.rapid { stroke-width: 0.95 }
.lathe text, .lathe .annotations text, .lathe .annotations .head { fill: #000 }
.lathe .annotations .dimension { stroke: #000 }
.lathe .arrow.rapid, .lathe .arrow.feed, .lathe .arrow.thread { fill: #000 }";

/// The colours of a palette as style rules.
fn colours(palette: &Palette) -> String {
    let Palette {
        background,
        grid,
        axis,
        text,
        stock,
        stock_edge,
        part,
        part_edge,
        danger,
        only_first,
        only_second,
        rapid,
        feed,
        thread,
        uncertain,
        ..
    } = palette;
    format!(
        "\
.lathe .background {{ fill: {background} }}
.lathe .grid {{ stroke: {grid} }}
.lathe .ruler, .lathe .center, .lathe .programmed {{ stroke: {axis} }}
.lathe text {{ fill: {text} }}
.lathe .blank {{ fill: {stock} }}
.lathe .blank-edge, .lathe .blank-frame {{ stroke: {stock_edge} }}
.lathe .part {{ fill: {part} }}
.lathe .hatch, .lathe .part-edge, .lathe .part-frame, .lathe .milled {{ stroke: {part_edge} }}
.lathe .obstacle {{ fill: {axis}; stroke: {axis} }}
.lathe .danger {{ stroke: {danger} }}
.lathe .only.first {{ fill: {only_first}; stroke: {only_first} }}
.lathe .only.second {{ fill: {only_second}; stroke: {only_second} }}
.lathe g .rapid {{ stroke: {rapid} }}
.lathe g .feed, .lathe g .dwell {{ stroke: {feed} }}
.lathe g .thread {{ stroke: {thread} }}
.lathe g .uncertain {{ stroke: {uncertain} }}
.lathe .arrow.rapid {{ fill: {rapid} }}
.lathe .arrow.feed {{ fill: {feed} }}
.lathe .arrow.thread {{ fill: {thread} }}"
    )
}

/// Whether a stroke begins another path element than the previous stroke.
fn is_other_path(before: &Stroke, stroke: &Stroke) -> bool {
    before.line != stroke.line || before.uncertain != stroke.uncertain
}

/// Path data of lines through corners; each line ends with `end`.
fn polylines(lines: &[Vec<Pixel>], end: &str) -> String {
    let mut d = String::new();
    for corners in lines {
        let mut last = String::new();
        for (index, corner) in corners.iter().enumerate() {
            // Merge corners that are too close to distinguish.
            let place = pixel(*corner);
            if place != last {
                d.push(if index == 0 { 'M' } else { 'L' });
                d.push_str(&place);
                last = place;
            }
        }
        d.push_str(end);
    }
    d
}

fn pixel(pixel: Pixel) -> String {
    format!("{} {}", number(pixel.x), number(pixel.y))
}

/// The middle of the pixel that contains a thin line.
fn sharp(value: f64) -> String {
    number(value.floor() + 0.5)
}

/// Formats a number with at most two decimals, without trailing zeros.
fn number(value: f64) -> String {
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".into() } else { text.into() }
}

#[cfg(test)]
mod tests {
    use super::super::tests::Path;
    use super::*;

    fn draw(path: Path) -> String {
        let motions = path.motions();
        let path_index = PathIndex::of(&motions);
        svg(&Scene::new(&motions, &path_index, None), &SvgOptions::default())
    }

    fn paths(file: &str) -> Vec<&str> {
        file.lines().filter(|line| line.contains("data-line")).collect()
    }

    #[test]
    fn every_block_has_its_own_path() {
        let path = Path::from(100.0, 20.0).rapid(60.0, 2.0).feed(60.0, -30.0).dwell().thread(60.0, -40.0);
        let file = draw(path.uncertain().feed(70.0, -40.0));
        let found = paths(&file);
        assert_eq!(found.len(), 5, "{file}");
        for (path, start) in found.iter().zip([
            r#"<path data-line="1" class="rapid" d="M"#,
            r#"<path data-line="3" class="dwell" d="M"#,
            r#"<path data-line="2" class="feed" d="M"#,
            r#"<path data-line="5" class="feed uncertain" d="M"#,
            r#"<path data-line="4" class="thread" d="M"#,
        ]) {
            assert!(path.starts_with(start), "{path}");
        }
    }

    #[test]
    fn arcs_are_true_arcs_that_turn_the_right_way() {
        let clockwise = Path::from(40.0, 0.0).arc(Turn::Clockwise, (80.0, 20.0), (80.0, 0.0));
        let file = draw(clockwise);
        assert_eq!(paths(&file)[0].matches(" 0 0 1 ").count(), 2, "{file}");
        let full = Path::from(40.0, 0.0).arc(Turn::Counterclockwise, (40.0, 0.0), (80.0, 0.0));
        let file = draw(full);
        assert_eq!(paths(&file)[0].matches(" 0 0 0 ").count(), 2, "{file}");
    }

    #[test]
    fn nothing_to_draw_is_an_empty_sheet() {
        let file = draw(Path::from(0.0, 0.0));
        assert!(paths(&file).is_empty() && file.contains(">\u{2212}50<") && !file.contains("NaN"), "{file}");
        assert!(file.ends_with("</svg>\n"));
    }

    #[test]
    fn rulers_name_the_unit_in_the_language_of_the_picture() {
        let motions = Path::from(100.0, 20.0).motions();
        let path_index = PathIndex::of(&motions);
        let options =
            SvgOptions { scale: Scale { symbol: "мм", ..Scale::default() }, ..SvgOptions::default() };
        let scene = Scene::new(&motions, &path_index, None);
        let names = |file: &str| -> Vec<String> {
            let names = file.lines().filter(|line| line.contains(r#"class="name"#));
            names.filter_map(|line| Some(line.split_once('>')?.1.split_once('<')?.0.to_owned())).collect()
        };
        assert_eq!(names(&svg(&scene, &options)), ["X Ø мм", "Z мм"]);
        assert_eq!(names(&svg(&scene.on(Plane::Face), &options)), ["C мм", "X Ø мм"]);
        assert_eq!(names(&svg(&scene, &SvgOptions::default())), ["X Ø mm", "Z mm"]);
    }

    #[test]
    fn numbers_are_short() {
        assert_eq!([1.0, -0.001, 12.345678, -3.5].map(number), ["1", "0", "12.35", "-3.5"]);
    }
}
