//! The finished part of an answer beside the target: its surfaces, and the place where they differ most.
//!
//! In: the half-section of the part, the target. Out: positions of surfaces near an edge; the [`Excess`] of the
//! differences over the tolerances. Must not know how the part was made.

use super::edge::{Edge, Material};
use super::target::Target;
use crate::geometry::{Point, SAME, at_share};
use crate::machine::feature::Thread;
use crate::machine::region::Region;

/// Greatest distance of two places at which a line is compared, mm.
const STEP: f64 = 0.5;
/// Most places of one line.
const MOST_PLACES: f64 = 60.0;
/// Error of chords, of the nose and of the grid, mm.
const ERROR: f64 = 0.012;
/// Radius up to which facing and parting leave a nib on the axis, mm.
const NIB: f64 = 0.5;

/// The part of an answer as far as the target goes.
pub(super) struct Shape<'a> {
    target: &'a Target,
    /// The half-section.
    pub region: Region,
    /// The threads of the program.
    threads: &'a [Thread],
}

/// A place at which the part differs from the target by more than the tolerance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Excess {
    /// The place: radius and Z, mm.
    pub at: Point,
    /// The nearest edge of the target.
    pub edge: usize,
    /// The difference beyond the tolerance, mm.
    pub excess: f64,
    /// Whether there is more or less material.
    pub material: Material,
}

impl<'a> Shape<'a> {
    /// The finished part, without the rest of the bar.
    pub fn new(target: &'a Target, mut part: Region, threads: &'a [Thread]) -> Self {
        if target.is_parted {
            part.drop_pieces(|own, all| own.max.z < all.max.z - SAME);
        } else {
            let (low, high) = (target.left, target.right.max(target.left) + 1000.0);
            let corners = [(0.0, low), (0.0, high), (8000.0, high), (8000.0, low)];
            part = part.intersection(&[corners.map(|(x, z)| Point::new(x, z))]);
        }
        Self { target, region: part, threads }
    }

    /// Radius of the surface at Z that is nearest to an edge of a cylinder or cone, mm; `None` without material.
    pub fn radius(&self, z: f64, edge: &Edge, nominal: f64) -> Option<f64> {
        let is_outside = edge.inwards.x < 0.0;
        let ends = self.region.radii(z).into_iter().map(|(low, high)| if is_outside { high } else { low });
        nearest(ends, nominal)
    }

    /// Z of the surface at a radius that is nearest to an edge of a face or a steep cone, mm; `None` without
    /// material.
    pub fn length(&self, x: f64, edge: &Edge, nominal: f64) -> Option<f64> {
        let faces_right = edge.inwards.z < 0.0;
        let ends = self.region.lengths(x).into_iter().map(|(low, high)| if faces_right { high } else { low });
        nearest(ends, nominal)
    }

    /// The place with the greatest difference beyond the tolerances; `None` if the part is within them.
    pub fn excess(&self) -> Option<Excess> {
        let own: Vec<[Point; 2]> = self.region.edges().map(|(a, b)| [a, b]).collect();
        let of_part = own.iter().filter(|ends| !self.is_cut_line(**ends)).flat_map(|ends| {
            let ends = *ends;
            shares(ends[0].distance(ends[1])).map(move |share| at_share(ends, share))
        });
        let of_part = of_part.filter_map(|at| self.excess_of_part(at));
        let of_target = self
            .target
            .edges
            .iter()
            .enumerate()
            .flat_map(|(index, edge)| shares(edge.length()).map(move |share| (index, edge.at(share))));
        let of_target = of_target.filter_map(|(index, at)| self.excess_of_target(index, at, &own));
        of_part.chain(of_target).max_by(|a, b| a.excess.total_cmp(&b.excess))
    }

    /// Whether a line of the part is on the axis, or at the end of the rest of the bar.
    fn is_cut_line(&self, [a, b]: [Point; 2]) -> bool {
        let is_axis = a.x.max(b.x) <= SAME;
        let left = self.target.left + ERROR;
        is_axis || !self.target.is_parted && a.z <= left && b.z <= left
    }

    /// The excess of a place on the surface of the part.
    fn excess_of_part(&self, at: Point) -> Option<Excess> {
        let is_inside = self.target.region.contains(at);
        let material = if is_inside { Material::Less } else { Material::More };
        let is_rounding = material == Material::More && self.target.is_in_corner(at);
        if is_rounding || self.is_ignored(at) {
            return None;
        }
        let (edge, excess) = self.target.excess(at, material)?;
        (excess > ERROR).then_some(Excess { at, edge, excess, material })
    }

    /// The excess of a place on an edge of the target.
    fn excess_of_target(&self, index: usize, at: Point, own: &[[Point; 2]]) -> Option<Excess> {
        let edge = &self.target.edges[index];
        if edge.is_free || self.is_ignored(at) || self.target.is_in_corner(at) {
            return None;
        }
        let nearest = |ends: &[Point; 2]| crate::geometry::nearest_on(*ends, at).distance(at);
        let distance = own.iter().map(nearest).fold(f64::INFINITY, f64::min);
        let beside = Point::new(at.x + ERROR * edge.inwards.x, at.z + ERROR * edge.inwards.z);
        let material = if self.region.contains(beside) { Material::More } else { Material::Less };
        let excess = distance.min(1e6) - edge.permitted(material);
        (excess > ERROR).then_some(Excess { at, edge: index, excess, material })
    }

    /// Whether a place is between the teeth of a thread, or on the nib that facing or parting leaves on the axis.
    pub fn is_ignored(&self, at: Point) -> bool {
        at.x <= NIB || self.target.edges.iter().any(|edge| self.is_between_teeth(at, edge))
    }

    /// Whether a place is between the roots of a thread and the surface of its edge. A groove at its end is deeper.
    fn is_between_teeth(&self, at: Point, edge: &Edge) -> bool {
        let Some(wanted) = edge.thread else { return false };
        let crest = [edge.from.x, edge.to.x];
        edge.distance(at) <= 1.5 * wanted.lead
            && self.threads.iter().any(|thread| {
                let [low, high] = thread.z;
                let (inner, outer) =
                    (thread.depth.min(crest[0]).min(crest[1]), thread.depth.max(crest[0]).max(crest[1]));
                (low - thread.lead..=high + thread.lead).contains(&at.z)
                    && (inner - ERROR..=outer + ERROR).contains(&at.x)
            })
    }
}

/// The position that is nearest to the nominal one.
fn nearest(positions: impl Iterator<Item = f64>, nominal: f64) -> Option<f64> {
    positions.min_by(|a, b| (a - nominal).abs().total_cmp(&(b - nominal).abs()))
}

/// The shares of a line of some length, mm, at which it is compared, with its ends.
fn shares(length: f64) -> impl Iterator<Item = f64> {
    let count = (length / STEP).ceil().clamp(1.0, MOST_PLACES);
    (0..=count as usize).map(move |index| index as f64 / count)
}
