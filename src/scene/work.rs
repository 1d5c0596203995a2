//! The workpiece as it is drawn: blank, part, obstacles around it, and the tool.
//!
//! In: the simulation, and the moment. Out: outlines in mm above the spindle axis; an exporter draws them
//! below it too. Must not know how material is removed.

use std::sync::atomic::{AtomicU64, Ordering};

use super::Plane;
use crate::geometry::bounds::Bounds;
use crate::geometry::{Point, SAME};
use crate::machine::SimulationResult;
use crate::machine::compare::{Comparison, Side};
use crate::machine::region::Region;
use crate::machine::resolved_setup::Basis;
use crate::motion::Motions;

/// A point is on an edge if the detour over it is longer than the edge by at most this, mm.
const ON_EDGE: f64 = 1e-6;

/// Closed outlines, including outlines of holes, with the material on the left.
pub type Outlines = Vec<Vec<Point>>;

/// The workpiece at a moment.
#[derive(Clone, Debug)]
pub struct Work {
    id: u64,
    /// The blank.
    pub blank: Outlines,
    /// The part: the blank without the removed material.
    pub part: Outlines,
    /// The part on the other side of the axis than the tool, with X positive: the grooves of threads are half a turn
    /// further there. `None` if it mirrors `part`.
    opposite: Option<Outlines>,
    /// Whether `opposite` is above the axis.
    is_opposite_above: bool,
    /// Whether the blank is given or inferred.
    pub basis: Basis,
    /// The chuck, and the tailstock if it is extended.
    pub obstacles: Outlines,
    /// The tool at its position.
    pub tool: Option<ToolOutline>,
    /// Positions of collisions.
    pub dangers: Vec<Point>,
    /// The extent of milling in the section, which shows the part as turned.
    pub milled: Option<Bounds>,
    /// The areas that only the first of two compared parts has, and those that only the second has.
    pub compared: Option<[Outlines; 2]>,
    /// The lines along which it was cut open to be unrolled.
    seams: Vec<Vec<Point>>,
    bounds: Bounds,
}

/// A tool at its position.
#[derive(Clone, Debug, PartialEq)]
pub struct ToolOutline {
    /// The cutting part.
    pub edge: Vec<Point>,
    /// The holder, if it is known.
    pub body: Option<Vec<Point>>,
    /// The position of the tip.
    pub tip: Point,
}

/// A moment during a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moment {
    /// Number of finished motions, which is the index of the current motion.
    pub motion: usize,
    /// The finished fraction of the current motion, 0 to 1.
    pub share: f64,
    /// The position of the tip.
    pub tip: Point,
}

impl Work {
    /// The workpiece at a moment, or at the end of all motions; `None` without a blank.
    pub fn of(simulation: &SimulationResult, motions: &Motions, moment: Option<Moment>) -> Option<Self> {
        let (stock, basis) = simulation.resolved_setup().stock()?;
        let (part, opposite) = match moment {
            Some(Moment { motion, share, .. }) => {
                (simulation.part_at(motions, motion, share), simulation.opposite_at(motions, motion, share))
            }
            None => (simulation.finished(), simulation.opposite_finished()),
        };
        let part = part.unwrap_or_default();
        let last = motions.len().checked_sub(1);
        let motion = moment.zip(last).map(|(at, last)| motions.get_on_workpiece(at.motion.min(last)));
        let tool = moment.filter(|at| at.motion < motions.len()).map(|at| {
            let shape = &simulation.resolved_setup().tool(&motions.get_on_workpiece(at.motion)).shape;
            ToolOutline {
                edge: shape.edge.at(at.tip),
                body: shape.body.as_ref().map(|body| body.at(at.tip)),
                tip: at.tip,
            }
        });
        Some(Self {
            id: next_id(),
            blank: outlines(simulation.blank()?),
            part: outlines(&part),
            opposite: opposite.as_ref().map(outlines),
            is_opposite_above: simulation.is_opposite_above(),
            basis,
            obstacles: simulation.obstacles(motion.as_ref()).flat_map(outlines).collect(),
            tool,
            dangers: simulation
                .findings()
                .iter()
                .filter(|found| found.danger.has_place())
                .map(|found| found.at)
                .collect(),
            milled: None,
            compared: None,
            seams: Vec::new(),
            bounds: Bounds {
                min: Point::new(stock.bore.radius(), stock.back()),
                max: Point::new(stock.diameter.radius(), stock.face),
            },
        })
    }

    /// An end face with a radius, mm, at a moment. Points have C in `x` and X in `z`.
    pub fn on_face(
        blank: &Region,
        part: &Region,
        basis: Basis,
        tool: Option<ToolOutline>,
        radius: f64,
    ) -> Self {
        Self {
            id: next_id(),
            blank: outlines(blank),
            part: outlines(part),
            opposite: None,
            is_opposite_above: false,
            basis,
            obstacles: Vec::new(),
            tool,
            dangers: Vec::new(),
            milled: None,
            compared: None,
            seams: Vec::new(),
            bounds: Bounds { min: Point::new(-radius, -radius), max: Point::new(radius, radius) },
        }
    }

    /// The side of the workpiece, within a box. Points have the distance around it in `x`.
    pub fn on_side(
        blank: &Region,
        part: &Region,
        basis: Basis,
        tool: Option<ToolOutline>,
        bounds: Bounds,
    ) -> Self {
        Self { bounds, ..Self::on_face(blank, part, basis, tool, 0.0) }
    }

    /// Adds the seams along which it was cut open to be unrolled; they are not drawn as edges.
    pub fn with_seams(self, seams: Vec<Vec<Point>>) -> Self {
        Self { seams, ..self }
    }

    /// Replaces the part.
    pub fn with_part(self, part: &Region) -> Self {
        Self { id: next_id(), part: outlines(part), opposite: None, ..self }
    }

    /// Sets the extent of milling in the section.
    pub fn with_milled(self, milled: Option<Bounds>) -> Self {
        Self { id: next_id(), milled, ..self }
    }

    /// The marks of a milled area, as for a flat on a turned part: its frame, and thin diagonal lines (ISO
    /// 128).
    pub fn milled_lines(&self) -> Vec<Vec<Point>> {
        let Some(Bounds { min, max }) = self.milled else { return Vec::new() };
        let [a, b, c, d] =
            [(min.x, min.z), (max.x, min.z), (max.x, max.z), (min.x, max.z)].map(|(x, z)| Point::new(x, z));
        vec![vec![a, b, c, d, a], vec![a, c], vec![b, d]]
    }

    /// Marks the differences of two parts, which are those on the side of the tool in both halves.
    pub fn compared_with(self, comparison: &Comparison) -> Self {
        let only = |side: Side| {
            let pieces = comparison.only(side).map(|difference| &difference.piece);
            pieces.flat_map(|piece| [&piece.outline].into_iter().chain(&piece.holes).cloned()).collect()
        };
        let compared = Some([only(Side::First), only(Side::Second)]);
        Self { id: next_id(), compared, opposite: None, ..self }
    }

    /// The part on a side of the axis, as in [`Plane::sides`]; X is positive on both.
    pub fn part_on(&self, side: f64) -> &Outlines {
        let is_opposite = (side > 0.0) == self.is_opposite_above;
        self.opposite.as_ref().filter(|_| is_opposite).unwrap_or(&self.part)
    }

    /// The edges of the part on a side of the axis, in two lists: cut edges, and edges of a blank that is only
    /// inferred.
    pub fn part_edges(&self, plane: Plane, side: f64) -> [Vec<Vec<Point>>; 2] {
        let part = self.part_on(side);
        let lines = match plane {
            Plane::Section => edges(part),
            Plane::Face => closed(part),
            Plane::Side => {
                let [edges, _] = without(&closed(part), &self.seams);
                edges
            }
        };
        match self.basis {
            Basis::Given => [lines, Vec::new()],
            Basis::Inferred | Basis::Unknown => without(&lines, &closed(&self.blank)),
        }
    }

    /// A unique id.
    pub fn id(&self) -> u64 {
        self.id
    }

    /// The bounding box of the blank above the axis.
    pub fn bounds(&self) -> Bounds {
        self.bounds
    }
}

fn next_id() -> u64 {
    static NEXT: AtomicU64 = AtomicU64::new(0);
    NEXT.fetch_add(1, Ordering::Relaxed)
}

/// Closed lines around outlines.
pub fn closed(outlines: &Outlines) -> Vec<Vec<Point>> {
    outlines.iter().map(|outline| outline.iter().chain(outline.first()).copied().collect()).collect()
}

/// The lines along the edges of outlines. Those on the spindle axis are omitted: they are not edges of the
/// workpiece, and would fill the gaps of the centre line.
pub fn edges(outlines: &Outlines) -> Vec<Vec<Point>> {
    let mut lines: Vec<Vec<Point>> = Vec::new();
    for outline in outlines {
        let on_axis = |point: &Point| point.x.abs() <= SAME;
        // Start at a corner on the axis, so that no line is split at its first corner.
        let first = outline.iter().position(on_axis).unwrap_or(0);
        let corners = outline.iter().cycle().skip(first).take(outline.len() + 1);
        let mut line: Vec<Point> = Vec::new();
        for &corner in corners {
            if line.last().is_some_and(|last| on_axis(last) && on_axis(&corner)) {
                lines.extend(Some(std::mem::take(&mut line)).filter(|line| line.len() > 1));
            }
            line.push(corner);
        }
        lines.extend(Some(line).filter(|line| line.len() > 1));
    }
    lines
}

/// Splits lines into the parts beside and on other lines.
fn without(lines: &[Vec<Point>], others: &[Vec<Point>]) -> [Vec<Vec<Point>>; 2] {
    let is_on = |a: Point, b: Point| {
        let mut edges = others.iter().flat_map(|line| line.windows(2));
        edges.any(|edge| is_between(a, edge) && is_between(b, edge))
    };
    let mut split = [Vec::new(), Vec::new()];
    for line in lines {
        let mut before = None;
        for ends in line.windows(2) {
            let part = usize::from(is_on(ends[0], ends[1]));
            match split[part].last_mut().filter(|_| before == Some(part)) {
                Some(run) => Vec::push(run, ends[1]),
                None => split[part].push(ends.to_vec()),
            }
            before = Some(part);
        }
    }
    split
}

/// Whether a point lies on an edge.
fn is_between(point: Point, edge: &[Point]) -> bool {
    let (from, to) = (edge[0], edge[1]);
    (from.distance(point) + point.distance(to) - from.distance(to)).abs() <= ON_EDGE
}

/// The outlines of a region.
pub(super) fn outlines(region: &Region) -> Outlines {
    region.outlines().map(Iterator::collect).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(x: f64, z: f64) -> Point {
        Point::new(x, z)
    }

    /// A bar of radius 10 from Z-20 to Z0 with a groove of radius 6 between Z-10 and Z-5.
    fn grooved(basis: Basis) -> Work {
        let blank = Region::inside(&[at(0.0, -20.0), at(0.0, 0.0), at(10.0, 0.0), at(10.0, -20.0)]);
        let mut part = blank.clone();
        part.cut(&[[at(6.0, -10.0), at(6.0, -5.0), at(12.0, -5.0), at(12.0, -10.0)]]);
        Work::on_face(&blank, &part, basis, None, 10.0)
    }

    #[test]
    fn edges_of_an_inferred_blank_are_told_from_those_that_were_cut() {
        let length = |lines: &[Vec<Point>]| -> f64 {
            lines.iter().flat_map(|line| line.windows(2)).map(|ends| ends[0].distance(ends[1])).sum()
        };
        let [cut, blank] = grooved(Basis::Inferred).part_edges(Plane::Section, 1.0);
        assert_eq!(cut.len(), 1, "{cut:?}");
        // Two flanks of 4 mm and a bottom of 5 mm; both ends of the bar and the rest of its outside.
        assert!(
            (length(&cut) - 13.0).abs() < 1e-3 && (length(&blank) - 35.0).abs() < 1e-3,
            "{cut:?} {blank:?}"
        );
        let [cut, blank] = grooved(Basis::Given).part_edges(Plane::Section, 1.0);
        assert!((length(&cut) - 48.0).abs() < 1e-3 && blank.is_empty(), "{cut:?} {blank:?}");
    }
}
