//! The seam along which the side of the workpiece is cut open to be unrolled, and paths that cross it.
//!
//! In: the extents of paths around the workpiece, mm, and paths. Out: [`Window`], one turn of the workpiece,
//! and the pieces of a path, each inside the window. The seam is placed where nothing is cut, if possible.
//! Must not know motions.

use std::f64::consts::{PI, TAU};

use crate::geometry::virtual_plane::Way;
use crate::geometry::{Arc, Point, SAME, within};
use crate::order;

/// Number of strips of a turn, used to find where nothing is cut.
const STRIPS: usize = 360;

/// Maximum number of crossings of a path that is split; one with more stays whole and is drawn beyond the
/// edge of the workpiece.
const MAX_CROSSINGS: f64 = 100.0;

/// The visible turn of the workpiece, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Window {
    /// Its lower edge.
    pub low: f64,
    /// The length of a turn.
    pub around: f64,
}

/// The parts of a turn where something is cut.
pub struct Taken {
    around: f64,
    strips: [bool; STRIPS],
    /// The first and last position of all cuts, without wrapping at a turn.
    all: Option<[f64; 2]>,
    first: f64,
}

/// A piece of a path.
#[derive(Clone, Copy, Debug)]
pub struct Piece {
    /// The piece, moved into the window.
    pub way: Way,
    /// Start and end of the piece as fractions of the path, 0 to 1.
    pub shares: [f64; 2],
    /// The distance by which it was moved, mm.
    pub moved: f64,
}

impl Taken {
    /// No cuts, on a turn of length `around`.
    pub fn none(around: f64) -> Self {
        Self { around, strips: [false; STRIPS], all: None, first: 0.0 }
    }

    /// Adds a cut of a cutter with a radius, mm, from `low` to `high`.
    pub fn add(&mut self, [low, high]: [f64; 2], radius: f64) {
        let Self { around, .. } = *self;
        if self.all.is_none() {
            self.first = low;
        }
        self.all = Some(self.all.map_or([low, high], |all| [all[0].min(low), all[1].max(high)]));
        let begin = self.strip(low - radius);
        let count = ((high - low + 2.0 * radius) / around * STRIPS as f64).ceil() as usize + 1;
        for strip in 0..count.min(STRIPS) {
            self.strips[(begin + strip) % STRIPS] = true;
        }
    }

    fn strip(&self, at: f64) -> usize {
        // Rounding can turn a value just below zero into a whole turn.
        ((at.rem_euclid(self.around) / self.around * STRIPS as f64) as usize).min(STRIPS - 1)
    }

    /// The visible turn. The seam is in the middle of the widest gap without cuts; among equally wide gaps,
    /// in the one before the first cut. If there is no gap, it is where the cuts begin.
    pub fn window(&self) -> Window {
        let around = self.around;
        let [low, high] = self.all.unwrap_or([-around / 2.0, around / 2.0]);
        let begin = self.strip(self.first);
        let (mut widest, mut width, mut free) = (0, 0, 0);
        for strip in 1..=STRIPS {
            let is_taken = strip == STRIPS || self.strips[(begin + strip) % STRIPS];
            if !is_taken {
                free += 1;
                continue;
            }
            if free > 0 && free >= width {
                (widest, width) = (strip - free, free);
            }
            free = 0;
        }
        let low = match width {
            0 if high - low <= around * (1.0 + 1e-9) => low,
            0 => self.first,
            _ => {
                let of = |strips: f64| strips * around / STRIPS as f64;
                let first = self.first - self.first.rem_euclid(of(1.0));
                first + of(widest as f64 + width as f64 / 2.0) - around
            }
        };
        Window { low, around }
    }
}

impl Window {
    /// The distance by which a position must be moved to be inside the window.
    pub fn move_of(&self, at: f64) -> f64 {
        -self.around * ((at - self.low) / self.around).floor()
    }

    /// Splits a path into pieces that are inside the window; keeps it whole if there would be too many.
    pub fn pieces(&self, way: &Way) -> Vec<Piece> {
        let [low, high] = extent(way);
        let first = ((low - self.low) / self.around).floor() + 1.0;
        let crossings = ((high - self.low) / self.around).ceil() - first;
        if !(crossings > 0.0 && crossings <= MAX_CROSSINGS) {
            let moved = if crossings > 0.0 { 0.0 } else { self.move_of((low + high) / 2.0) };
            return vec![Piece { way: way.moved(Point::new(moved, 0.0)), shares: [0.0, 1.0], moved }];
        }
        let mut cuts = vec![0.0];
        for crossing in 0..crossings as u32 {
            cuts.extend(crossed(way, self.low + (first + f64::from(crossing)) * self.around));
        }
        cuts.push(1.0);
        order::by(&mut cuts, f64::total_cmp);
        let parts = cuts.windows(2).map(|ends| [ends[0], ends[1]]);
        let length = match way {
            Way::Line(from, to) => from.distance(*to),
            Way::Arc(arc) => arc.length(),
        };
        let parts = parts.filter(|[from, to]| (to - from) * length > SAME);
        parts
            .map(|shares| {
                let part = part(way, shares);
                let moved = self.move_of(part.at(0.5).x);
                Piece { way: part.moved(Point::new(moved, 0.0)), shares, moved }
            })
            .collect()
    }
}

/// The extent of a path around the workpiece.
pub fn extent(way: &Way) -> [f64; 2] {
    match way {
        Way::Line(from, to) => [from.x.min(to.x), from.x.max(to.x)],
        Way::Arc(arc) => {
            let bounds = crate::geometry::bounds::Bounds::of_arc(arc);
            [bounds.min.x, bounds.max.x]
        }
    }
}

/// The fractions of a path at which it crosses a position.
fn crossed(way: &Way, seam: f64) -> Vec<f64> {
    let shares = match way {
        Way::Line(from, to) => vec![(seam - from.x) / (to.x - from.x)],
        Way::Arc(arc) => {
            let sine = within((seam - arc.center.x) / arc.radius(), -1.0, 1.0);
            let sweep = arc.sweep();
            let share = |angle: f64| {
                let turned = angle - arc.start_angle();
                let turned = if sweep < 0.0 { -turned } else { turned };
                turned.rem_euclid(TAU) / sweep.abs()
            };
            vec![share(sine.asin()), share(PI - sine.asin())]
        }
    };
    shares.into_iter().filter(|share| *share > 0.0 && *share < 1.0).collect()
}

fn part(way: &Way, [from, to]: [f64; 2]) -> Way {
    match way {
        Way::Line(..) => Way::Line(way.at(from), way.at(to)),
        Way::Arc(arc) => Way::Arc(Arc { start: way.at(from), end: way.at(to), ..*arc }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Turn;

    /// One degree is one mm.
    const AROUND: f64 = 360.0;

    fn window(taken: &[[f64; 2]], radius: f64) -> Window {
        let mut all = Taken::none(AROUND);
        taken.iter().for_each(|own| all.add(*own, radius));
        all.window()
    }

    #[test]
    fn the_seam_is_where_nothing_is_cut() {
        let low = |taken: &[[f64; 2]]| window(taken, 4.0).low;
        let near = |taken: &[[f64; 2]], expected: f64| {
            assert!((low(taken) - expected).abs() <= 1.0, "{taken:?}: {}", low(taken));
        };
        near(&[[0.0, 0.0]], -180.0);
        assert!(low(&[[0.0, 358.0]]) == 0.0 && window(&[[0.0, 340.0]], 1.0).low < -9.0);
        // Four holes: half-way before the first one.
        near(&[0.0, 90.0, 180.0, 270.0].map(|at| [at, at]), -45.0);
        near(&[[0.0, 90.0]], -135.0);
        // All around, in both directions.
        near(&[[0.0, 200.0], [200.0, 360.0]], 0.0);
        near(&[[-200.0, 0.0], [-360.0, -200.0]], -360.0);
        near(&[[0.0, 5000.0]], 0.0);
        near(&[], -180.0);
    }

    #[test]
    fn a_way_over_the_seam_is_two_pieces() {
        let window = Window { low: -180.0, around: AROUND };
        let pieces = window.pieces(&Way::Line(Point::new(170.0, 0.0), Point::new(190.0, -20.0)));
        let ends: Vec<_> = pieces.iter().map(|piece| (piece.way.at(0.0), piece.way.at(1.0))).collect();
        assert_eq!(ends.len(), 2);
        assert!(ends[0].1.is_same(Point::new(180.0, -10.0)) && ends[1].0.is_same(Point::new(-180.0, -10.0)));
        assert!(ends[1].1.is_same(Point::new(-170.0, -20.0)) && pieces[1].shares == [0.5, 1.0]);
        // Once around and back to the start: a circle that is cut at two places.
        let start = Point::new(160.0, 0.0);
        let circle = Arc { start, end: start, center: Point::new(175.0, 0.0), turn: Turn::Clockwise };
        let pieces = window.pieces(&Way::Arc(circle));
        assert_eq!(pieces.len(), 3);
        let length: f64 = pieces
            .iter()
            .map(|piece| match piece.way {
                Way::Arc(arc) => arc.length(),
                Way::Line(..) => 0.0,
            })
            .sum();
        assert!((length - TAU * 15.0).abs() < 1e-9, "{length}");
        for piece in &pieces {
            let [low, high] = extent(&piece.way);
            assert!(low >= -180.0 - 1e-9 && high <= 180.0 + 1e-9, "{piece:?}");
        }
    }

    #[test]
    fn many_turns_stay_one_way() {
        let window = Window { low: 0.0, around: AROUND };
        let way = Way::Line(Point::new(0.0, 0.0), Point::new(1e9, -20.0));
        assert_eq!(window.pieces(&way).len(), 1);
        assert_eq!(window.pieces(&Way::Line(Point::new(0.0, 0.0), Point::new(AROUND * 90.0, 0.0))).len(), 90);
    }
}
