//! The work as it is drawn: blank, what is left of it, what stands around it, and the tool.
//!
//! In: the shop, and the moment. Out: outlines in mm above the spindle axis; an exporter draws them below it too. Must not
//! know how material is taken off.

use std::sync::atomic::{AtomicU64, Ordering};

use crate::geometry::Point;
use crate::geometry::bounds::Bounds;
use crate::motion::Motions;
use crate::shop::Shop;
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
        static NEXT: AtomicU64 = AtomicU64::new(0);
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
            id: NEXT.fetch_add(1, Ordering::Relaxed),
            blank: outlines(shop.blank()?),
            part: outlines(&part),
            known,
            obstacles: shop.obstacles().flat_map(outlines).collect(),
            tool,
            dangers: shop.findings().iter().map(|finding| finding.at).collect(),
            bounds: Bounds {
                min: Point::new(stock.bore / 2.0, stock.back()),
                max: Point::new(stock.diameter / 2.0, stock.face),
            },
        })
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

fn outlines(region: &Region) -> Outlines {
    region.outlines().map(Iterator::collect).collect()
}
