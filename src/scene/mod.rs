//! The picture: the analysis as shapes, each with the block that made it.
//!
//! In: the motion list and the workpiece. Out: [`Scene`], a neutral picture in mm that exporters only read:
//! `svg` writes it as a file, `canvas` draws it in the page, `pick` finds the stroke under a pointer. Nothing
//! is copied: strokes are made from motions on demand. Must not know G-code words, and contains no human
//! language except the names of the axes.

pub mod annotation;
pub mod camera;
#[cfg(target_arch = "wasm32")]
pub mod canvas;
pub mod clip;
pub mod face;
pub mod hatch;
pub mod ink;
pub mod marks;
pub mod occupied;
pub mod palette;
pub mod path_index;
pub mod pick;
pub mod placement;
pub mod plot;
pub mod ruler;
mod seam;
pub mod side;
pub mod source;
pub mod speed_chart;
pub mod steps;
pub mod surface_moves;
pub mod svg;
pub mod view;
pub mod work;

use std::ops::Range;

use crate::geometry::virtual_plane::VirtualMove;
use crate::geometry::{Arc, Point, SAME};
use crate::motion::{Chunk, Motion, MotionKind, Motions};
use crate::playback::clock::Playhead;
use crate::source::Span;

use crate::geometry::bounds::{Bounds, join};
use camera::XPlus;
use path_index::{PathIndex, Stretch};
use ruler::Axis;
use view::Frame;
use work::Work;

/// The line style of a stroke, as in technical drawings.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum StrokeStyle {
    /// Rapid traverse: thin and dashed.
    Rapid,
    /// Dwell: a dot.
    Dwell,
    /// Cut at feed, straight or an arc: solid.
    Feed,
    /// Cut synchronised with the spindle.
    Thread,
}

impl StrokeStyle {
    /// All styles, in drawing order.
    pub const ALL: [StrokeStyle; 4] = [Self::Rapid, Self::Dwell, Self::Feed, Self::Thread];

    /// The class name in the SVG.
    pub fn name(self) -> &'static str {
        match self {
            Self::Rapid => "rapid",
            Self::Dwell => "dwell",
            Self::Feed => "feed",
            Self::Thread => "thread",
        }
    }

    /// The style of motions of a kind.
    pub fn of(kind: MotionKind) -> Self {
        match kind {
            MotionKind::Rapid => Self::Rapid,
            MotionKind::Feed | MotionKind::ArcClockwise | MotionKind::ArcCounterclockwise => Self::Feed,
            MotionKind::Thread => Self::Thread,
            MotionKind::Dwell => Self::Dwell,
        }
    }
}

/// Maximum distance of a drawn curve from the true one, mm.
const CHORD: f64 = 0.02;

/// The shape of a stroke, in mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StrokeShape {
    /// A straight line.
    Line {
        /// Start point.
        from: Point,
        /// End point.
        to: Point,
    },
    /// A true arc, possibly a full circle.
    Arc(Arc),
    /// A line or an arc in a virtual plane, and therefore a curve in the turning plane.
    Virtual(VirtualMove),
    /// A dwell at this point.
    Dot(Point),
}

impl StrokeShape {
    /// The shape of a motion.
    pub fn of(motion: &Motion) -> Self {
        match (motion.kind, motion.arc()) {
            (MotionKind::Dwell, _) => Self::Dot(motion.to),
            _ if motion.from.is_same(motion.to) && motion.is_turn() => Self::Dot(motion.to),
            _ if motion.virtual_move().is_some() => {
                motion.virtual_move().map_or(Self::Dot(motion.to), Self::Virtual)
            }
            (_, Some(arc)) => Self::Arc(arc),
            (_, None) => Self::Line { from: motion.from, to: motion.to },
        }
    }

    /// The shape of a motion of a chunk; fast for straight lines, the most frequent kind.
    #[inline]
    pub fn in_chunk(chunk: &Chunk, index: usize) -> Self {
        match chunk.straight_on_workpiece(index) {
            Some((from, to)) => Self::Line { from, to },
            None => Self::of(&chunk.get_on_workpiece(index)),
        }
    }

    /// The start point.
    pub fn start(&self) -> Point {
        match self {
            Self::Line { from, .. } => *from,
            Self::Arc(arc) => arc.start,
            Self::Virtual(own) => own.at(0.0),
            Self::Dot(at) => *at,
        }
    }

    /// The end point.
    pub fn end(&self) -> Point {
        match self {
            Self::Line { to, .. } => *to,
            Self::Arc(arc) => arc.end,
            Self::Virtual(own) => own.at(1.0),
            Self::Dot(at) => *at,
        }
    }

    /// The points of a polyline that approximates a virtual move.
    pub fn curve(own: &VirtualMove) -> Vec<Point> {
        own.machine_path(CHORD)
    }

    /// The bounding box; exact for arcs.
    pub fn bounds(&self) -> Bounds {
        match self {
            Self::Line { from, to } => Bounds::around(*from, *to),
            Self::Arc(arc) => Bounds::of_arc(arc),
            Self::Virtual(own) => Self::curve(own).into_iter().fold(Bounds::of(own.at(0.0)), Bounds::with),
            Self::Dot(at) => Bounds::of(*at),
        }
    }

    /// Length along it, mm.
    pub fn length(&self) -> f64 {
        match self {
            // Faster than `Point::distance`, which also handles values beyond the range of any machine.
            Self::Line { from, to } => ((from.x - to.x).powi(2) + (from.z - to.z).powi(2)).sqrt(),
            Self::Arc(arc) => arc.length(),
            Self::Virtual(own) => own.length(),
            Self::Dot(_) => 0.0,
        }
    }

    /// The point at the fraction `t` of the path, from 0 (start) to 1 (end).
    pub fn at(&self, t: f64) -> Point {
        match self {
            Self::Line { from, to } => Point::new(from.x + t * (to.x - from.x), from.z + t * (to.z - from.z)),
            Self::Arc(arc) => arc.at(t),
            Self::Virtual(own) => own.at(t),
            Self::Dot(at) => *at,
        }
    }

    /// The parts before and after the fraction `t` of the path, from 0 (start) to 1 (end).
    pub fn split(&self, t: f64) -> (StrokeShape, StrokeShape) {
        let point = self.at(t);
        // An arc with its end at its start is a full circle, so a part without length must not stay an arc.
        let line = |part: StrokeShape, share: f64| {
            if share * self.length() > SAME {
                part
            } else {
                Self::Line { from: part.start(), to: part.end() }
            }
        };
        match self {
            Self::Line { from, to } => {
                (Self::Line { from: *from, to: point }, Self::Line { from: point, to: *to })
            }
            Self::Arc(arc) => (
                line(Self::Arc(Arc { end: point, ..*arc }), t),
                line(Self::Arc(Arc { start: point, ..*arc }), 1.0 - t),
            ),
            Self::Virtual(own) => {
                let (first, second) = own.split(t);
                (Self::Virtual(first), Self::Virtual(second))
            }
            Self::Dot(_) => (*self, *self),
        }
    }
}

/// A motion as it is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stroke {
    /// Index of the motion, over all motions.
    pub motion: usize,
    /// The line style.
    pub style: StrokeStyle,
    /// Whether the stroke may be wrong because an earlier block was not executed; it is then drawn dimmed.
    pub uncertain: bool,
    /// The shape, in mm.
    pub shape: StrokeShape,
    /// Bytes of the block that made the stroke.
    pub span: Span,
    /// Line of the block, from 0.
    pub line: u32,
}

impl Stroke {
    /// The shape in the direction in which it is drawn. Rapids are always drawn down and to the left,
    /// regardless of the motion: the dashes of overlapping rapids then coincide instead of filling each
    /// other's gaps.
    pub fn drawn_shape(&self) -> StrokeShape {
        match (self.style, self.shape) {
            (StrokeStyle::Rapid, StrokeShape::Line { from, to }) if (from.x, from.z) < (to.x, to.z) => {
                StrokeShape::Line { from: to, to: from }
            }
            (_, shape) => shape,
        }
    }
}

/// A position on the path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// The current motion.
    pub motion: usize,
    /// The fraction of the motion that is finished, 0 at its start, 1 at its end.
    pub fraction: f64,
    /// The position of the tool tip.
    pub at: Point,
}

/// The plane that a picture shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Plane {
    /// The section along the spindle axis: Z to the right, X up, the workpiece on both sides of the axis.
    #[default]
    Section,
    /// The end face, seen from the tailstock: X to the right, C or Y up. Points have C or Y in `x` and X in
    /// `z`, as in [`virtual_plane`](crate::geometry::virtual_plane).
    Face,
    /// The side, seen from outside and usually unrolled: Z to the right, C or Y down. Points have the
    /// distance around the workpiece in `x`.
    Side,
}

impl Plane {
    /// All planes.
    pub const ALL: [Self; 3] = [Self::Section, Self::Face, Self::Side];

    /// The planes that show a surface of the workpiece.
    pub const SURFACES: [Self; 2] = [Self::Face, Self::Side];

    /// The axes along the bottom and the left edge.
    fn axes(self) -> [Axis; 2] {
        match self {
            Self::Section => [Axis::Z, Axis::X],
            Self::Face => [Axis::FaceX, Axis::FaceC],
            Self::Side => [Axis::Z, Axis::Y],
        }
    }

    /// The sides of the axis on which the outlines of the workpiece are drawn: 1 unchanged, −1 mirrored.
    pub fn sides(self) -> &'static [f64] {
        match self {
            Self::Section => &[1.0, -1.0],
            Self::Face | Self::Side => &[1.0],
        }
    }

    /// The direction of the vertical axis, given the direction of X+ in the section.
    pub fn x_plus(self, of_section: XPlus) -> XPlus {
        match self {
            Self::Section => of_section,
            Self::Face => XPlus::Up,
            Self::Side => XPlus::Down,
        }
    }
}

/// The picture of a run: a view over its motions and the workpiece, without copies.
#[derive(Clone, Copy, Debug)]
pub struct Scene<'a> {
    motions: &'a Motions,
    path_index: &'a PathIndex,
    work: Option<&'a Work>,
    plane: Plane,
    /// The axes along the bottom and the left edge.
    axes: [Axis; 2],
}

impl<'a> Scene<'a> {
    /// The picture of `motions`, with their `path_index`, and of the workpiece. Motions that are not yet in
    /// the index are omitted.
    pub fn new(motions: &'a Motions, path_index: &'a PathIndex, work: Option<&'a Work>) -> Self {
        Self { motions, path_index, work, plane: Plane::Section, axes: Plane::Section.axes() }
    }

    /// The same picture, with its points in another plane.
    pub fn on(self, plane: Plane) -> Self {
        Self { plane, axes: plane.axes(), ..self }
    }

    /// The same picture, with other axes along the bottom and the left edge.
    pub fn with_axes(self, axes: [Axis; 2]) -> Self {
        Self { axes, ..self }
    }

    /// The axes along the bottom and the left edge.
    pub fn axes(&self) -> [Axis; 2] {
        self.axes
    }

    /// The plane of the picture.
    pub fn plane(&self) -> Plane {
        self.plane
    }

    /// The path index of the picture.
    pub fn path_index(&self) -> &'a PathIndex {
        self.path_index
    }

    /// Number of motions.
    pub fn len(&self) -> usize {
        self.path_index.len()
    }

    /// Whether there are no motions.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The workpiece, if it is shown.
    pub fn work(&self) -> Option<&'a Work> {
        self.work
    }

    /// The stroke of one motion; `None` past the end.
    pub fn stroke(&self, motion: usize) -> Option<Stroke> {
        self.strokes_of(motion..motion.saturating_add(1)).next()
    }

    /// All strokes, in the order of the run.
    pub fn strokes(&self) -> impl Iterator<Item = Stroke> + use<'a> {
        self.strokes_of(0..self.len())
    }

    /// The strokes of a range of motions, in the order of the run.
    pub fn strokes_of(&self, range: Range<usize>) -> impl Iterator<Item = Stroke> + use<'a> {
        let chunks = self.motions.chunks();
        let end = range.end.min(self.len());
        let (mut chunk, mut at) = self.path_index.locate(range.start);
        (range.start..end).map(move |motion| {
            if at == chunks[chunk].len() {
                (chunk, at) = (chunk + 1, 0);
            }
            let value = chunks[chunk].get_on_workpiece(at);
            let stroke = Stroke {
                motion,
                style: StrokeStyle::of(value.kind),
                uncertain: value.process.uncertain,
                shape: StrokeShape::of(&value),
                span: chunks[chunk].span(at),
                line: chunks[chunk].line(at),
            };
            at += 1;
            stroke
        })
    }

    /// The strokes that meet an area.
    pub fn strokes_near(&self, area: Bounds) -> impl Iterator<Item = Stroke> + use<'a> {
        let scene = *self;
        let stretches =
            self.path_index.stretches().iter().filter(move |stretch| stretch.bounds.overlaps(area));
        let strokes = stretches.flat_map(move |stretch| scene.strokes_of(stretch.motions.clone()));
        strokes.filter(move |stroke| stroke.shape.bounds().overlaps(area))
    }

    /// The chunk of a stretch, and the indices of its motions in the chunk.
    pub fn chunk_of(&self, stretch: &Stretch) -> (&'a Chunk, Range<usize>) {
        let (chunk, motions) = stretch.in_chunk();
        (&self.motions.chunks()[chunk], motions)
    }

    /// The programmed path of compensated motions.
    pub fn programmed(&self) -> impl Iterator<Item = StrokeShape> + use<'a> {
        let scene = *self;
        self.path_index.stretches().iter().flat_map(move |stretch| scene.programmed_in(stretch))
    }

    /// The programmed path of the compensated motions of a stretch.
    pub fn programmed_in(&self, stretch: &Stretch) -> impl Iterator<Item = StrokeShape> + use<'a> {
        let (chunk, motions) = self.chunk_of(stretch);
        let own = chunk.compensated().filter(move |index| motions.contains(index));
        own.filter_map(|index| chunk.get_on_workpiece(index).as_programmed())
            .map(|motion| StrokeShape::of(&motion))
    }

    /// The motions made by blocks inside `block`, as ranges: a block may be executed several times.
    pub fn motions_of(&self, block: Span) -> Vec<Range<usize>> {
        let mut ranges: Vec<Range<usize>> = Vec::new();
        for stretch in self.path_index.stretches() {
            if stretch.span.end <= block.start || block.end <= stretch.span.start {
                continue;
            }
            for stroke in self.strokes_of(stretch.motions.clone()) {
                if stroke.span.start < block.start || block.end < stroke.span.end {
                    continue;
                }
                match ranges.last_mut() {
                    Some(last) if last.end == stroke.motion => last.end += 1,
                    _ => ranges.push(stroke.motion..stroke.motion + 1),
                }
            }
        }
        ranges
    }

    /// The extent of a fitted picture.
    pub fn bounds_of(&self, frame: Frame) -> Bounds {
        match frame {
            Frame::Usual => self.bounds(),
            Frame::Cuts => {
                let near = |cuts| self.stock().map_or(cuts, |stock| self.cuts_near(stock, cuts));
                let cuts = self.path_index.cuts().map(near);
                cuts.map_or_else(|| self.bounds(), |cuts| self.with_axis(cuts))
            }
            Frame::Part => {
                let core = self.stock().or(self.path_index.cuts());
                core.map_or_else(|| self.bounds(), |core| self.with_axis(core))
            }
            Frame::Path => {
                join(self.path_index.bounds(), Some(self.bounds())).unwrap_or_else(|| self.bounds())
            }
        }
    }

    /// Extends the box to the spindle axis, if the plane shows it.
    fn with_axis(&self, bounds: Bounds) -> Bounds {
        match self.plane {
            Plane::Section | Plane::Face => bounds.with(Point::new(0.0, bounds.min.z)),
            Plane::Side => bounds,
        }
    }

    /// The box of the stock, in the section on both sides of the centre line.
    fn stock(&self) -> Option<Bounds> {
        self.work.map(|work| {
            let bounds = work.bounds();
            match self.plane {
                Plane::Section => bounds.with(Point::new(-bounds.max.x, bounds.min.z)),
                Plane::Face => bounds.with(Point::default()),
                Plane::Side => bounds,
            }
        })
    }

    /// The default extent: cuts and stock, with the rapids that end nearby; all motions if there are no cuts.
    /// It always includes the spindle axis.
    pub fn bounds(&self) -> Bounds {
        let stock = self.stock();
        let Some(cuts) = self.path_index.cuts() else {
            let all = join(self.path_index.rapids(), stock)
                .unwrap_or(Bounds { min: Point::new(0.0, -50.0), max: Point::new(20.0, 10.0) });
            return self.with_axis(all);
        };
        let cuts = match stock {
            Some(stock) => self.cuts_near(stock, cuts),
            None => cuts,
        };
        let core = self.with_axis(join(Some(cuts), stock).unwrap_or(cuts));
        let near = core.grown(core.length().max(core.height()) / 2.0);
        let mut bounds = core;
        for stretch in self.path_index.stretches() {
            let Some(rapids) = stretch.rapids.filter(|rapids| rapids.overlaps(near)) else { continue };
            if near.contains(rapids.min) && near.contains(rapids.max) {
                bounds = bounds.union(rapids);
                continue;
            }
            let rapids = self.strokes_of(stretch.motions.clone()).filter(|s| s.style == StrokeStyle::Rapid);
            let ends = rapids.map(|stroke| stroke.shape.end()).filter(|end| near.contains(*end));
            bounds = ends.fold(bounds, Bounds::with);
        }
        bounds
    }

    /// The box of the cuts near the stock. A distant cut would make the workpiece small: a program may begin
    /// without a rapid, or return home at feed.
    fn cuts_near(&self, stock: Bounds, cuts: Bounds) -> Bounds {
        let near = stock.grown(stock.length().max(stock.height()) / 2.0);
        let all_near = |bounds: Bounds| near.contains(bounds.min) && near.contains(bounds.max);
        if all_near(cuts) {
            return cuts;
        }
        let mut found = None;
        for stretch in self.path_index.stretches() {
            let Some(cuts) = stretch.cuts.filter(|cuts| cuts.overlaps(near)) else { continue };
            if all_near(cuts) {
                found = join(found, Some(cuts));
                continue;
            }
            let strokes = self.strokes_of(stretch.motions.clone()).filter(|s| s.style != StrokeStyle::Rapid);
            for shape in strokes.map(|stroke| stroke.shape) {
                let bounds = shape.bounds();
                if all_near(bounds) {
                    found = join(found, Some(bounds));
                } else {
                    let ends = [shape.start(), shape.end()].into_iter().filter(|end| near.contains(*end));
                    found = ends.fold(found, |found, end| join(found, Some(Bounds::of(end))));
                }
            }
        }
        found.unwrap_or(cuts)
    }

    /// The position of the tool at a playhead; `None` after the end of the program.
    pub fn place(&self, playhead: Playhead) -> Option<Place> {
        let Playhead { motion, share } = playhead;
        let stroke = self.stroke(motion)?;
        Some(Place { motion, fraction: share, at: stroke.shape.at(share) })
    }
}

#[cfg(test)]
mod tests;
