//! The measuring report: each size of the target, and the size of the part there.
//!
//! In: the part and the target. Out: one [`Measured`] for each size. A cylinder and a cone are measured at several
//! places, and the place with the greatest deviation counts; a face is measured where it is nearest.

use super::answer::Answer;
use super::edge::{Edge, Size, ThreadOf};
use super::quantity::{Measured, Quantity};
use super::shape::Shape;
use super::target::Target;
use super::values::Tolerance;
use crate::geometry::{Point, SAME, at_share};
use crate::machine::feature::{self, Shape as FeatureShape, Thread};
use crate::units::Diameter;

/// Number of places at which an edge is measured.
const PLACES: usize = 9;
/// Share of a cylinder or a face that is not measured at each end: another size decides there.
const END: f64 = 0.2;
/// The same of a cone.
const END_OF_CONE: f64 = 0.05;
/// Number of places in each of two leads at which the crests of a thread are measured.
const CREST_PLACES: i32 = 20;
/// Deviations that differ by less than this, mm, are the same.
const SAME_DEVIATION: f64 = 1e-4;
/// Greatest distance of the arc of the part from that of the target, mm.
const REACH: f64 = 1.0;
/// How much shorter than its cylinder a thread may be, and how much longer: it runs out into a groove. In leads.
const SHORTER: f64 = 0.5;
const LONGER: f64 = 4.0;
/// Tolerance of a lead, mm.
const LEAD: Tolerance = Tolerance::both(0.001);

/// Measures each size of the target.
pub(super) fn report(target: &Target, shape: &Shape, answer: &Answer) -> Vec<Measured> {
    let edges = target.edges.iter().enumerate().filter(|(_, edge)| !edge.is_free);
    let report = Report { target, shape, threads: &answer.threads };
    let sizes = edges.flat_map(|(index, edge)| report.edge(index, edge));
    let resolved = answer.simulation.resolved_setup();
    let flats = target.flats.map(|flats| flats.measure(&answer.analysis.motions, resolved));
    sizes.chain(flats).collect()
}

struct Report<'a> {
    target: &'a Target,
    shape: &'a Shape<'a>,
    threads: &'a [Thread],
}

impl Report<'_> {
    fn edge(&self, index: usize, edge: &Edge) -> Vec<Measured> {
        let mut sizes = match edge.size() {
            Size::Diameter if edge.thread.is_some() => Vec::new(),
            Size::Diameter => self.worst(index, edge, END).into_iter().collect(),
            Size::Length => self.length(index, edge).into_iter().collect(),
            Size::Taper => self.cone(index, edge),
            Size::Radius => vec![self.radius(index, edge)],
        };
        sizes.extend(self.width(index, edge));
        if let Some(thread) = edge.thread {
            sizes.extend(self.thread(index, edge, thread));
        }
        sizes
    }

    /// The diameter with the greatest deviation along a cylinder or a cone.
    fn worst(&self, index: usize, edge: &Edge, end: f64) -> Option<Measured> {
        let places = self.places(edge, end).filter(|at| !self.shape.is_ignored(*at));
        let all: Vec<Measured> = places.map(|at| self.diameter(index, edge, at)).collect();
        let off = |own: &Measured| own.deviation().map_or(f64::INFINITY, f64::abs);
        let most = all.iter().map(off).fold(0.0, f64::max);
        let middle = edge.middle();
        let worst = all.into_iter().filter(|own| off(own) >= most - SAME_DEVIATION);
        worst.min_by(|a, b| a.at.distance(middle).total_cmp(&b.at.distance(middle)))
    }

    fn diameter(&self, index: usize, edge: &Edge, at: Point) -> Measured {
        let actual = self.shape.radius(at.z, edge, at.x);
        Measured {
            quantity: Quantity::Diameter,
            at,
            nominal: Diameter::from_radius(at.x).mm(),
            actual: actual.map(|radius| Diameter::from_radius(radius).mm()),
            tolerance: edge.tolerance,
            edge: index,
        }
    }

    /// The radius at the crests of a thread, mm: the greatest of an external thread, the least of an internal one, within two
    /// leads at the middle.
    fn crest(&self, edge: &Edge, lead: f64) -> Option<f64> {
        let at = edge.middle();
        let places = (-CREST_PLACES..=CREST_PLACES)
            .map(|place| at.z + lead * f64::from(place) / f64::from(CREST_PLACES));
        let radii = places.filter_map(|z| self.shape.radius(z, edge, at.x));
        let is_outside = edge.inwards.x < 0.0;
        if is_outside { radii.reduce(f64::max) } else { radii.reduce(f64::min) }
    }

    /// Places on an edge, without its ends and the rounding of inside corners, at round values of Z.
    fn places(&self, edge: &Edge, end: f64) -> impl Iterator<Item = Point> {
        let length = edge.length();
        let margin = |at: Point| {
            let corner = if self.target.has_inside_corner(at) { self.target.corners } else { 0.0 };
            (corner / length).max(end).min(0.4)
        };
        let (from, to) = (margin(edge.from), 1.0 - margin(edge.to));
        let grid = match (edge.to.z - edge.from.z).abs() {
            longer if longer > 20.0 => 1.0,
            longer if longer > 2.0 => 0.1,
            _ => 0.001,
        };
        let ends = [edge.from, edge.to];
        (0..PLACES).map(move |place| {
            let share = from + (to - from) * place as f64 / (PLACES - 1) as f64;
            let rounded = (at_share(ends, share).z / grid).round() * grid;
            let share = (rounded - ends[0].z) / (ends[1].z - ends[0].z);
            Point::new(at_share(ends, share).x, rounded)
        })
    }

    /// The distance of a face from the right end; of the right end its Z.
    fn length(&self, index: usize, edge: &Edge) -> Option<Measured> {
        let z = edge.from.z;
        let shares = (0..PLACES).map(|place| END + (1.0 - 2.0 * END) * place as f64 / (PLACES - 1) as f64);
        let found = shares.map(|share| {
            let x = at_share([edge.from, edge.to], share).x;
            (x, self.shape.length(x, edge, z))
        });
        let off = |found: Option<f64>| found.map_or(f64::INFINITY, |found| (found - z).abs());
        let (x, found) = found.min_by(|a, b| off(a.1).total_cmp(&off(b.1)))?;
        let is_right = (z - self.target.right).abs() <= SAME;
        let size = |z: f64| if is_right { z } else { self.target.right - z };
        Some(Measured {
            quantity: if is_right { Quantity::Face } else { Quantity::Length },
            at: Point::new(x, z),
            nominal: size(z),
            actual: found.map(size),
            tolerance: edge.tolerance,
            edge: index,
        })
    }

    /// The greatest deviation of diameter of a cone, and its angle.
    fn cone(&self, index: usize, edge: &Edge) -> Vec<Measured> {
        let worst = self.worst(index, edge, END_OF_CONE);
        let places = self.places(edge, END_OF_CONE).filter(|at| !self.shape.is_ignored(*at));
        let places: Vec<Point> = places.collect();
        let ends = [places.first(), places.last()].map(|at| {
            let at = *at?;
            Some(Point::new(self.shape.radius(at.z, edge, at.x)?, at.z))
        });
        let angle = |a: Point, b: Point| (b.x - a.x).abs().atan2((b.z - a.z).abs()).to_degrees();
        let measured = Measured {
            quantity: Quantity::Angle,
            at: edge.middle(),
            nominal: angle(edge.from, edge.to),
            actual: ends[0].zip(ends[1]).map(|(a, b)| angle(a, b)),
            tolerance: edge.angle,
            edge: index,
        };
        worst.into_iter().chain((places.len() > 1).then_some(measured)).collect()
    }

    /// The radius of the arc of the part that is nearest to that of the target.
    fn radius(&self, index: usize, edge: &Edge) -> Measured {
        let at = edge.middle();
        let found = feature::at(&self.shape.region, &[], at, REACH);
        let actual = found.and_then(|found| match found.shape {
            FeatureShape::Arc { radius } => Some(radius),
            _ => None,
        });
        let nominal = edge.arc.map_or(0.0, |arc| arc.radius());
        Measured { quantity: Quantity::Radius, at, nominal, actual, tolerance: edge.tolerance, edge: index }
    }

    /// The width of a groove at half its depth.
    fn width(&self, index: usize, edge: &Edge) -> Option<Measured> {
        let tolerance = edge.width?;
        let next = |index: Option<usize>| index.and_then(|index| self.target.edges.get(index));
        let walls = [next(index.checked_sub(1))?, next(Some(index + 1))?];
        let tops = walls.map(|wall| if wall.to.is_same(edge.from) { wall.from.x } else { wall.to.x });
        let is_outside = edge.inwards.x < 0.0;
        let top = if is_outside { tops[0].min(tops[1]) } else { tops[0].max(tops[1]) };
        let middle = edge.middle();
        let x = f64::midpoint(edge.from.x, top);
        let lengths = self.shape.region.lengths(x);
        let mut gaps = lengths.windows(2).map(|pair| (pair[0].1, pair[1].0));
        let gap = gaps.find(|(low, high)| (*low..=*high).contains(&middle.z));
        Some(Measured {
            quantity: Quantity::Width,
            at: middle,
            nominal: edge.length(),
            actual: gap.map(|(low, high)| high - low),
            tolerance,
            edge: index,
        })
    }

    /// Lead, root diameter, length and crest diameter of a thread. A wrong lead also changes the crests, so they are last.
    fn thread(&self, index: usize, edge: &Edge, wanted: ThreadOf) -> [Measured; 4] {
        let (low, high) = (edge.from.z.min(edge.to.z), edge.from.z.max(edge.to.z));
        let is_near = |own: &&Thread| {
            let near = (own.depth - wanted.root.radius()).abs() <= 2.0 * wanted.lead;
            near && own.z[0] < high && low < own.z[1]
        };
        let found = self.threads.iter().find(is_near);
        let row = |quantity, nominal, actual: Option<f64>, tolerance| Measured {
            quantity,
            at: edge.middle(),
            nominal,
            actual,
            tolerance,
            edge: index,
        };
        let diameter = |radius: f64| Diameter::from_radius(radius).mm();
        let root = found.map(|own| diameter(own.depth));
        let crest = self.crest(edge, wanted.lead).map(diameter);
        let right = self.target.right;
        let length = Tolerance { lower: -SHORTER * wanted.lead, upper: LONGER * wanted.lead };
        [
            row(Quantity::Lead, wanted.lead, found.map(|own| own.lead.abs()), LEAD),
            row(Quantity::Root, wanted.root.mm(), root, wanted.tolerance),
            row(Quantity::ThreadLength, right - low, found.map(|own| right - own.z[0]), length),
            row(Quantity::Crest, diameter(edge.middle().x), crest, edge.tolerance),
        ]
    }
}
