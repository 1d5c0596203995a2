//! The moves over a surface of the workpiece, shown in a separate picture.
//!
//! In: moves in the plane of the picture, each with its motion in the run, or a piece of it. Out:
//! [`SurfaceMoves`], with a [`Scene`] that is drawn, picked in and exported like the section; the tool
//! position there, and the area swept by its cutters. Must not know which surface it is.

use std::f64::consts::TAU;
use std::ops::Range;

use super::path_index::PathIndex;
use super::ruler::Axis;
use super::work::{ToolOutline, Work};
use super::{Place, Plane, Scene};
use crate::geometry::virtual_plane::Way;
use crate::geometry::{Point, Turn};
use crate::machine::resolved_setup::{ResolvedSetup, ResolvedTool};
use crate::machine::sweep::{self, path_of};
use crate::motion::{Chunk, Motion, MotionKind, Motions};
use crate::playback::clock::Playhead;
use crate::source::Span;

/// Maximum number of moves whose swept area is computed; with more, only the paths are drawn.
const MAX_SWEPT: usize = 2000;

/// Number of corners of a circle.
const CORNERS: u32 = 256;

pub(super) struct Passed {
    /// Its index in the run.
    pub index: usize,
    pub motion: Motion,
    pub block: (Span, u32),
    /// Angle of C after it, degrees.
    pub c: f64,
}

/// The motions of a run that may be over a surface, in order: all motions of each chunk that contains one.
pub(super) fn passed(motions: &Motions, resolved: &ResolvedSetup) -> impl Iterator<Item = Passed> {
    let drills = resolved.has_live_drill();
    let chunks = motions.chunks().iter().zip(motions.before());
    let chunks = chunks.filter(move |(chunk, _)| drills || !chunk.only_turns());
    let all = chunks.flat_map(|(chunk, &before)| (0..chunk.len()).map(move |at| (before + at, chunk, at)));
    let mut c = 0.0;
    all.map(move |(index, chunk, at)| {
        let motion = chunk.get_on_workpiece(at);
        c = motion.rotary.map_or(c, |rotary| rotary.to);
        Passed { index, motion, block: (chunk.span(at), chunk.line(at)), c }
    })
}

/// Moves over a surface.
#[derive(Clone, Debug)]
pub struct SurfaceMoves {
    /// The moves, in the plane of the picture.
    motions: Motions,
    path_index: PathIndex,
    /// For each move, the source motion (or a piece of it).
    of: Vec<Origin>,
    plane: Plane,
    axes: [Axis; 2],
}

/// The source of a move: a motion of the run, or a piece of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Origin {
    /// The motion of the run.
    pub motion: usize,
    /// Start and end of the piece as fractions of the motion, 0 to 1.
    pub shares: [f64; 2],
    /// The radius that the cutter sweeps, mm; `None` if it is unknown or does not cut.
    pub cutter: Option<f64>,
}

/// A list of such moves that is being built.
#[derive(Default)]
pub(super) struct Gathered {
    own: Option<Chunk>,
    of: Vec<Origin>,
}

impl Gathered {
    /// Adds a move of the block at a place in the text.
    pub fn push(&mut self, flat: &Motion, (span, line): (Span, u32), origin: Origin) {
        self.own.get_or_insert_with(|| Chunk::new(0, 0, flat.from)).push(flat, span, line);
        self.of.push(origin);
    }

    /// Number of moves.
    pub fn len(&self) -> usize {
        self.of.len()
    }

    /// The finished list, in its plane, with the axes along its bottom and its left edge; `None` if it is
    /// empty.
    pub fn finish(self, plane: Plane, axes: [Axis; 2]) -> Option<SurfaceMoves> {
        let mut motions = Motions::default();
        motions.push(self.own?);
        let path_index = PathIndex::of(&motions);
        Some(SurfaceMoves { motions, path_index, of: self.of, plane, axes })
    }
}

impl SurfaceMoves {
    /// The picture.
    pub fn scene<'a>(&'a self, work: Option<&'a Work>) -> Scene<'a> {
        Scene::new(&self.motions, &self.path_index, work).on(self.plane).with_axes(self.axes)
    }

    /// The moves, in the plane of the picture.
    pub fn motions(&self) -> &Motions {
        &self.motions
    }

    /// The outline of the cutter at the end of a move, if it cuts and its radius is known.
    pub fn cutter_after(&self, own: usize) -> Option<Vec<Point>> {
        let radius = self.of.get(own)?.cutter?;
        let at = self.motions.get_on_workpiece(own).to;
        Some(circle(radius).into_iter().map(|corner| corner.moved(at)).collect())
    }

    /// The source motion of a move in this picture.
    pub fn motion(&self, own: usize) -> Option<usize> {
        self.of.get(own).map(|of| of.motion)
    }

    /// The moves of this picture that come from a motion of the run: none, one, or several pieces.
    pub fn own(&self, motion: usize) -> Range<usize> {
        self.before(motion)..self.of.partition_point(|of| of.motion <= motion)
    }

    /// Number of moves whose source motion comes before `motion`.
    pub(super) fn before(&self, motion: usize) -> usize {
        self.of.partition_point(|of| of.motion < motion)
    }

    /// The playhead of this picture for a position in the run: on one of its moves, or before the next one.
    pub fn playhead(&self, place: Place) -> Playhead {
        let own = self.own(place.motion);
        let motion = own.clone().find(|&own| place.fraction <= self.of[own].shares[1]).unwrap_or(own.start);
        let share = if own.is_empty() { 0.0 } else { self.share_of(motion, place.fraction) };
        Playhead { motion, share }
    }

    /// The finished fraction of a move, given that of its source motion.
    fn share_of(&self, own: usize, fraction: f64) -> f64 {
        let [from, to] = self.of[own].shares;
        if to > from { ((fraction - from) / (to - from)).clamp(0.0, 1.0) } else { 1.0 }
    }

    /// The cutter, if it is on one of the moves.
    pub(super) fn tool(&self, place: Place) -> Option<ToolOutline> {
        let Playhead { motion, share } = self.playhead(place);
        let of = self.of.get(motion).filter(|of| of.motion == place.motion)?;
        let tip = self.scene(None).stroke(motion)?.shape.at(share);
        let edge = sweep::Outline::around(circle(of.cutter?)).at(tip);
        Some(ToolOutline { edge, body: None, tip })
    }

    /// The areas that the cutters sweep: in all moves, or up to a position in the run.
    pub(super) fn swept(&self, place: Option<Place>) -> Vec<Vec<Point>> {
        if self.of.len() > MAX_SWEPT {
            return Vec::new();
        }
        let mut swept = Vec::new();
        let mut cutter: Option<(f64, sweep::Outline)> = None;
        for (index, of) in self.of.iter().enumerate() {
            let share = match place {
                Some(at) if of.motion > at.motion => break,
                Some(at) if of.motion == at.motion && at.fraction <= of.shares[0] => break,
                Some(at) if of.motion == at.motion => self.share_of(index, at.fraction),
                _ => 1.0,
            };
            let Some(radius) = of.cutter else { continue };
            let motion = self.motions.get_on_workpiece(index);
            let motion = if share < 1.0 { motion.first_part(share) } else { motion };
            let outline = match cutter.take() {
                Some((own, outline)) if own == radius => outline,
                _ => sweep::Outline::around(circle(radius)),
            };
            swept.extend(outline.along(&path_of(&motion)));
            cutter = Some((radius, outline));
        }
        swept
    }
}

/// A motion along a path in the plane of a picture.
pub(super) fn on_way(motion: &Motion, way: &Way) -> Motion {
    let (kind, from, to, center) = match *way {
        Way::Line(from, to) => (MotionKind::Feed, from, to, None),
        Way::Arc(arc) => {
            let kind = match arc.turn {
                Turn::Clockwise => MotionKind::ArcClockwise,
                Turn::Counterclockwise => MotionKind::ArcCounterclockwise,
            };
            (kind, arc.start, arc.end, Some(arc.center))
        }
    };
    let kind = if motion.kind.cuts() { kind } else { motion.kind };
    Motion {
        kind,
        from,
        to,
        center,
        rotary: None,
        lead: None,
        lead_change: None,
        start_angle: 0.0,
        cycle: None,
        ..*motion
    }
}

/// The radius of a live tool, mm, if it is given.
pub(super) fn cutter_radius(resolved_tool: &ResolvedTool) -> Option<f64> {
    let tool = &resolved_tool.tool;
    let radius = tool.cutter_radius().or(tool.geometry_r)?;
    (radius > 0.0 && radius.is_finite()).then_some(radius)
}

/// A circle around the origin as a polygon, counter-clockwise.
pub fn circle(radius: f64) -> Vec<Point> {
    let corner = |index: u32| {
        let angle = TAU * f64::from(index) / f64::from(CORNERS);
        Point::new(radius * angle.sin(), radius * angle.cos())
    };
    (0..CORNERS).map(corner).collect()
}
