//! Compares two parts: the material that only one of them has, how much, and where.
//!
//! In: the half-sections of two parts. Out: a [`Comparison`] with its [`Difference`]s, measured along and
//! across the spindle axis. A piece thinner than [`SAME_PART`] is ignored, because arcs are approximated by
//! chords. Must not know the text of the programs.

use super::SimulationResult;
use super::region::{Piece, Region};
use super::resolved_setup::{Basis, ResolvedSetup};
use crate::geometry::Point;
use crate::geometry::bounds::Bounds;
use crate::motion::Motions;
use crate::order;
use crate::setup::{Blank, Setup, Stock};
use crate::units::Diameter;

/// Parts that differ by less than this, mm, are the same.
pub const SAME_PART: f64 = 0.005;

/// Distance beside a corner at which a piece is measured, mm: at the corner itself its width may be zero.
const BESIDE: f64 = 1e-5;

/// Most places at which one piece is measured.
const MAX_PLACES: usize = 2000;

/// One of the two parts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// The first part, or the saved one.
    First,
    /// The second part, or the current one.
    Second,
}

/// A straight distance through a piece.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measure {
    /// The end nearer to the axis or to −Z: radius and Z, mm.
    pub from: Point,
    /// The other end.
    pub to: Point,
}

impl Measure {
    /// Length, mm.
    pub fn length(&self) -> f64 {
        self.from.distance(self.to)
    }
}

/// A connected piece of material that only one part has.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// The part that has it.
    pub side: Side,
    /// Outline in the half-section.
    pub piece: Piece,
    /// Area in the half-section, mm².
    pub area: f64,
    /// Bounding box.
    pub bounds: Bounds,
    /// Greatest thickness across the spindle axis.
    pub radial: Measure,
    /// Greatest length along the spindle axis.
    pub axial: Measure,
}

/// The differences between two parts, the largest first.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Comparison {
    /// The pieces.
    pub differences: Vec<Difference>,
}

impl Comparison {
    /// Compares two half-sections.
    pub fn of(first: &Region, second: &Region) -> Self {
        let sides = [(Side::First, first.difference(second)), (Side::Second, second.difference(first))];
        let pieces = sides.iter().flat_map(|(side, region)| region.pieces().map(|piece| (*side, piece)));
        let mut differences: Vec<_> = pieces.filter_map(|(side, piece)| measure(side, piece)).collect();
        order::by(&mut differences, |a, b| b.area.total_cmp(&a.area));
        Self { differences }
    }

    /// Whether the parts are the same.
    pub fn is_empty(&self) -> bool {
        self.differences.is_empty()
    }

    /// The pieces that only one part has.
    pub fn only(&self, side: Side) -> impl Iterator<Item = &Difference> {
        self.differences.iter().filter(move |difference| difference.side == side)
    }

    /// Area of the pieces that only one part has, mm².
    pub fn area(&self, side: Side) -> f64 {
        self.only(side).map(|difference| difference.area).sum()
    }

    /// The largest measure across the spindle axis.
    pub fn radial(&self) -> Option<Measure> {
        longest(self.differences.iter().map(|difference| difference.radial))
    }

    /// The largest measure along the spindle axis.
    pub fn axial(&self) -> Option<Measure> {
        longest(self.differences.iter().map(|difference| difference.axial))
    }
}

/// The finished parts of two programs. An inferred blank is replaced by the given blank of the other program;
/// two inferred ones by their common part. Otherwise the comparison would show differences of the inference.
pub fn parts(programs: [(&Motions, &Setup); 2]) -> [Option<Region>; 2] {
    let resolved = programs.map(|(motions, setup)| ResolvedSetup::new(motions, setup));
    let both = |blank: Blank| [Some(blank.clone()), Some(blank)];
    let chosen = match [resolved[0].blank(), resolved[1].blank()] {
        [Some((a, Basis::Given)), Some((b, Basis::Given))] => [Some(a.clone()), Some(b.clone())],
        [Some((given, Basis::Given)), _] | [_, Some((given, Basis::Given))] => both(given.clone()),
        [Some((a, _)), Some((b, _))] => both(in_both(a.extents(), b.extents()).into()),
        [Some((only, _)), None] | [None, Some((only, _))] => both(only.clone()),
        [None, None] => [None, None],
    };
    let [first, second] = chosen;
    [(programs[0], first), (programs[1], second)].map(|((motions, setup), stock)| {
        let setup = Setup { stock, ..setup.clone() };
        SimulationResult::of(motions, &setup).finished()
    })
}

/// The common part of two blanks.
fn in_both(a: Stock, b: Stock) -> Stock {
    let face = a.face.min(b.face);
    Stock {
        diameter: Diameter::new(a.diameter.mm().min(b.diameter.mm())),
        bore: Diameter::new(a.bore.mm().max(b.bore.mm())),
        face,
        length: (face - a.back().max(b.back())).max(0.0),
        grip: a.grip.or(b.grip),
    }
}

fn measure(side: Side, piece: Piece) -> Option<Difference> {
    let edges: Vec<(Point, Point)> = [&piece.outline]
        .into_iter()
        .chain(&piece.holes)
        .flat_map(|corners| corners.iter().copied().zip(corners.iter().copied().cycle().skip(1)))
        .collect();
    let bounds = piece.outline.iter().fold(Bounds::of(*piece.outline.first()?), |all, at| all.with(*at));
    let area = edges.iter().map(|(a, b)| (a.z * b.x - b.z * a.x) / 2.0).sum();
    let radial = thickest(&edges, |at| (at.z, at.x), |at, along| Point::new(along, at))?;
    let axial = thickest(&edges, |at| (at.x, at.z), Point::new)?;
    let is_worth_it = radial.length() >= SAME_PART && axial.length() >= SAME_PART;
    is_worth_it.then_some(Difference { side, piece, area, bounds, radial, axial })
}

/// The longest straight distance within edges. `split` returns the measuring line that a point lies on and
/// its position along that line; `join` is its inverse.
fn thickest(
    edges: &[(Point, Point)],
    split: impl Fn(Point) -> (f64, f64),
    join: impl Fn(f64, f64) -> Point,
) -> Option<Measure> {
    // Between two corners the thickness changes linearly, so it is greatest beside one of them.
    let step = edges.len().div_ceil(MAX_PLACES);
    let corners = edges.iter().step_by(step).map(|(corner, _)| split(*corner).0);
    let mut best: Option<Measure> = None;
    for corner in corners {
        for place in [corner - BESIDE, corner + BESIDE] {
            let mut crossings: Vec<f64> = edges
                .iter()
                .map(|(a, b)| (split(*a), split(*b)))
                .filter(|(a, b)| (a.0 < place) != (b.0 < place))
                .map(|(a, b)| a.1 + (place - a.0) / (b.0 - a.0) * (b.1 - a.1))
                .collect();
            crossings.sort_unstable_by(f64::total_cmp);
            let own = crossings
                .chunks_exact(2)
                .map(|pair| Measure { from: join(corner, pair[0]), to: join(corner, pair[1]) });
            best = longest(own.chain(best));
        }
    }
    best
}

fn longest(measures: impl Iterator<Item = Measure>) -> Option<Measure> {
    measures.max_by(|a, b| a.length().total_cmp(&b.length()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rectangle(z: (f64, f64), x: (f64, f64)) -> Vec<Point> {
        vec![Point::new(x.0, z.0), Point::new(x.0, z.1), Point::new(x.1, z.1), Point::new(x.1, z.0)]
    }

    fn section(cuts: &[Vec<Point>]) -> Region {
        let mut region = Region::inside(&rectangle((-50.0, 0.0), (0.0, 20.0)));
        region.cut(cuts);
        region
    }

    #[test]
    fn each_side_has_its_own_pieces() {
        let first = section(&[rectangle((-10.0, 5.0), (15.0, 30.0))]);
        let second =
            section(&[rectangle((-10.0, 5.0), (17.0, 30.0)), rectangle((-30.0, -26.0), (12.0, 30.0))]);
        let comparison = Comparison::of(&first, &second);
        assert_eq!(comparison.differences.len(), 2);
        let [groove, step] = &comparison.differences[..] else { panic!("two pieces") };
        assert_eq!((groove.side, step.side), (Side::First, Side::Second));
        assert!((groove.area - 32.0).abs() < 1e-3 && (step.area - 20.0).abs() < 1e-3);
        assert!((groove.radial.length() - 8.0).abs() < 1e-3 && (groove.axial.length() - 4.0).abs() < 1e-3);
        assert!((step.radial.length() - 2.0).abs() < 1e-3 && (step.axial.length() - 10.0).abs() < 1e-3);
        assert!((comparison.area(Side::First) - 32.0).abs() < 1e-3);
        assert!((comparison.axial().expect("one").length() - 10.0).abs() < 1e-3);
    }

    #[test]
    fn a_part_does_not_differ_from_itself_nor_by_a_hair() {
        let part = section(&[rectangle((-10.0, 5.0), (15.0, 30.0))]);
        assert!(Comparison::of(&part, &part).is_empty());
        let hair = section(&[rectangle((-10.0, 5.0), (15.002, 30.0))]);
        assert!(Comparison::of(&part, &hair).is_empty());
        let more = section(&[rectangle((-10.0, 5.0), (15.01, 30.0))]);
        assert_eq!(Comparison::of(&part, &more).differences.len(), 1);
    }

    #[test]
    fn inferred_blanks_are_no_difference() {
        let part = |program: &str| crate::analyze(program.as_bytes(), &Setup::default());
        let a = part("T0101\nG00 X62 Z2\nG90 X50 Z-30 F0.2\nG00 X100");
        let b = part("T0101\nG00 X72 Z2\nG90 X50 Z-30 F0.2\nG00 X100");
        let [first, second] = parts([(&a.motions, &a.setup), (&b.motions, &b.setup)]);
        let comparison = Comparison::of(&first.expect("a part"), &second.expect("a part"));
        assert!(comparison.is_empty(), "{:?}", comparison.radial());
    }
}
