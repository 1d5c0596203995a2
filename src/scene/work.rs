//! The work as it is drawn: blank, what is left of it, what stands around it, and the tool.
//!
//! In: the shop, and the moment. Out: outlines in mm above the spindle axis; an exporter draws them below it too. Must not
//! know how material is taken off.

use std::sync::atomic::{AtomicU64, Ordering};

use crate::geometry::bounds::Bounds;
use crate::geometry::{Point, SAME};
use crate::motion::Motions;
use crate::shop::Shop;
use crate::shop::compare::{Comparison, Side};
use crate::shop::fitting::Known;
use crate::shop::region::Region;

/// Closed outlines, those of holes among them: the material on the left.
pub type Outlines = Vec<Vec<Point>>;

/// The work at a moment.
#[derive(Clone, Debug)]
pub struct Work {
    id: u64,
    /// The blank.
    pub blank: Outlines,
    /// What is left of it.
    pub part: Outlines,
    /// Whether somebody has named the blank.
    pub known: Known,
    /// Chuck and tailstock.
    pub obstacles: Outlines,
    /// The tool, where it stands.
    pub tool: Option<ToolOutline>,
    /// Places where something runs into something.
    pub dangers: Vec<Point>,
    /// What only one of two compared parts has: the first, the second.
    pub compared: Option<[Outlines; 2]>,
    bounds: Bounds,
}

/// A tool in its place.
#[derive(Clone, Debug, PartialEq)]
pub struct ToolOutline {
    /// The cutting part.
    pub edge: Vec<Point>,
    /// The holder, as far as it is known.
    pub body: Option<Vec<Point>>,
    /// Where its tip is.
    pub tip: Point,
}

/// A moment: so many motions are done, and of the next one a share; the tip is there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moment {
    /// Motions that are done.
    pub motion: usize,
    /// How much of the next one is done: 0 to 1.
    pub share: f64,
    /// Where the tip is.
    pub tip: Point,
}

impl Work {
    /// The work when all motions are done, or at a moment; nothing where there is no blank.
    pub fn of(shop: &Shop, motions: &Motions, moment: Option<Moment>) -> Option<Self> {
        let (stock, known) = shop.fitting().stock()?;
        let part = match moment {
            Some(at) => shop.part_at(motions, at.motion, at.share),
            None => shop.finished(),
        };
        let part = part.unwrap_or_default();
        let tool = moment.filter(|at| at.motion < motions.len()).map(|at| {
            let shape = &shop.fitting().tool(&motions.get(at.motion)).shape;
            ToolOutline {
                edge: shape.edge.at(at.tip),
                body: shape.body.as_ref().map(|body| body.at(at.tip)),
                tip: at.tip,
            }
        });
        Some(Self {
            id: next_id(),
            blank: outlines(shop.blank()?),
            part: outlines(&part),
            known,
            obstacles: shop.obstacles().flat_map(outlines).collect(),
            tool,
            dangers: shop
                .findings()
                .iter()
                .filter(|found| found.danger.has_place())
                .map(|found| found.at)
                .collect(),
            compared: None,
            bounds: Bounds {
                min: Point::new(stock.bore / 2.0, stock.back()),
                max: Point::new(stock.diameter / 2.0, stock.face),
            },
        })
    }

    /// An end face of a radius, mm, at a moment: the points have C in `x` and X in `z`.
    pub fn on_face(
        blank: &Region,
        part: &Region,
        known: Known,
        tool: Option<ToolOutline>,
        radius: f64,
    ) -> Self {
        Self {
            id: next_id(),
            blank: outlines(blank),
            part: outlines(part),
            known,
            obstacles: Vec::new(),
            tool,
            dangers: Vec::new(),
            compared: None,
            bounds: Bounds { min: Point::new(-radius, -radius), max: Point::new(radius, radius) },
        }
    }

    /// The same with something else left of the blank.
    pub fn with_part(self, part: &Region) -> Self {
        Self { id: next_id(), part: outlines(part), ..self }
    }

    /// The same with the differences of two parts marked.
    pub fn compared_with(self, comparison: &Comparison) -> Self {
        let only = |side: Side| {
            let pieces = comparison.only(side).map(|difference| &difference.piece);
            pieces.flat_map(|piece| [&piece.outline].into_iter().chain(&piece.holes).cloned()).collect()
        };
        Self { id: next_id(), compared: Some([only(Side::First), only(Side::Second)]), ..self }
    }

    /// A number that no other work has.
    pub fn id(&self) -> u64 {
        self.id
    }

    /// The box of the blank above the axis.
    pub fn bounds(&self) -> Bounds {
        self.bounds
    }
}

fn next_id() -> u64 {
    static NEXT: AtomicU64 = AtomicU64::new(0);
    NEXT.fetch_add(1, Ordering::Relaxed)
}

/// The lines all around outlines.
pub fn closed(outlines: &Outlines) -> Vec<Vec<Point>> {
    outlines.iter().map(|outline| outline.iter().chain(outline.first()).copied().collect()).collect()
}

/// The lines along the edges of outlines: those on the spindle axis are no edges of the work, and would fill the gaps of the
/// centre line.
pub fn edges(outlines: &Outlines) -> Vec<Vec<Point>> {
    let mut lines: Vec<Vec<Point>> = Vec::new();
    for outline in outlines {
        let on_axis = |point: &Point| point.x.abs() <= SAME;
        // From a corner on the axis on, so that no line is broken at its first corner.
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

fn outlines(region: &Region) -> Outlines {
    region.outlines().map(Iterator::collect).collect()
}
