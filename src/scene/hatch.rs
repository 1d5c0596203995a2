//! Hatching, which marks cut material in a section.
//!
//! In: outlines on the screen. Out: lines at 45° inside them. Their positions do not depend on how much of an
//! outline is visible.

use super::camera::{Pixel, Size};
use crate::geometry::within;

/// Distance between two lines, CSS pixels along an axis.
const SPACING: f64 = 9.0;

/// Maximum number of lines in one picture.
const MAX_LINES: usize = 20_000;

/// The direction of the lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Slant {
    /// From the lower left to the upper right.
    Rising,
    /// From the upper left to the lower right.
    Falling,
}

/// Lines inside outlines, in either direction; see [`hatch`].
pub fn hatch_slanted(outlines: &[Vec<Pixel>], zero: Pixel, size: Size, slant: Slant) -> Vec<[Pixel; 2]> {
    match slant {
        Slant::Rising => hatch(outlines, zero, size),
        Slant::Falling => {
            let mirrored = |at: Pixel| Pixel::new(at.x, size.height - at.y);
            let outlines: Vec<Vec<Pixel>> =
                outlines.iter().map(|outline| outline.iter().map(|at| mirrored(*at)).collect()).collect();
            hatch(&outlines, mirrored(zero), size).into_iter().map(|line| line.map(mirrored)).collect()
        }
    }
}

/// Lines inside outlines, from the lower left to the upper right. `zero` is a point on one of the lines, so
/// that the lines stay in place in the outline when the picture is moved. Nothing is drawn far outside a
/// picture of `size`.
pub fn hatch(outlines: &[Vec<Pixel>], zero: Pixel, size: Size) -> Vec<[Pixel; 2]> {
    // x + y is constant on each line, and x − y is the position along it.
    let across = |at: Pixel| (at.x + at.y - zero.x - zero.y) / SPACING;
    let seen = [Pixel::default(), Pixel::new(size.width, size.height)].map(across);
    // For each visible line, in order, its intersections with the outlines; there are few.
    let first = seen[0].ceil();
    let mut crossings: Vec<Vec<f64>> =
        vec![Vec::new(); (within(seen[1] - first, 0.0, MAX_LINES as f64) as usize) + 1];
    let mut count = 0;
    for outline in outlines {
        let next = outline.iter().cycle().skip(1);
        for (&a, &b) in outline.iter().zip(next) {
            let (from, to) = (across(a), across(b));
            let (low, high) = (from.min(to).max(seen[0]), from.max(to).min(seen[1]));
            let mut line = low.ceil();
            // An end point on a line belongs to the edge that begins below it.
            while line < high && count < 2 * MAX_LINES && (line - first) < crossings.len() as f64 {
                let share = (line - from) / (to - from);
                let along = (a.x - a.y) + share * ((b.x - b.y) - (a.x - a.y));
                let own = &mut crossings[(line - first) as usize];
                own.insert(own.partition_point(|other| *other < along), along);
                (line, count) = (line + 1.0, count + 1);
            }
        }
    }
    let place = |line: usize, along: f64| {
        let sum = (first + line as f64) * SPACING + zero.x + zero.y;
        Pixel::new((sum + along) / 2.0, (sum - along) / 2.0)
    };
    let of_line = |(line, places): (usize, Vec<f64>)| {
        let pairs = places.chunks_exact(2).map(|pair| [place(line, pair[0]), place(line, pair[1])]);
        pairs.collect::<Vec<_>>()
    };
    crossings.into_iter().enumerate().flat_map(of_line).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: Size = Size { width: 200.0, height: 200.0 };

    fn square(from: f64, to: f64) -> Vec<Pixel> {
        [(from, from), (to, from), (to, to), (from, to)].map(|(x, y)| Pixel::new(x, y)).to_vec()
    }

    #[test]
    fn lines_end_at_the_outline_and_leave_holes_out() {
        let lines = hatch(&[square(10.0, 100.0)], Pixel::default(), SIZE);
        assert_eq!(lines.len(), 20);
        for [a, b] in &lines {
            assert!((a.x + a.y - b.x - b.y).abs() < 1e-9);
            for at in [a, b] {
                let on = |value: f64| (value - 10.0).abs() < 1e-9 || (value - 100.0).abs() < 1e-9;
                assert!(on(at.x) || on(at.y), "{at:?}");
            }
        }
        let with_hole = hatch(&[square(10.0, 100.0), square(40.0, 70.0)], Pixel::default(), SIZE);
        assert!(with_hole.len() > lines.len());
        let inside = |at: Pixel| at.x > 41.0 && at.x < 69.0 && at.y > 41.0 && at.y < 69.0;
        let middle = |[a, b]: [Pixel; 2]| Pixel::new((a.x + b.x) / 2.0, (a.y + b.y) / 2.0);
        assert!(!with_hole.into_iter().any(|line| inside(middle(line))));
    }

    #[test]
    fn falling_lines_are_rising_ones_in_a_mirror() {
        for [a, b] in hatch_slanted(&[square(10.0, 100.0)], Pixel::default(), SIZE, Slant::Falling) {
            assert!((a.x - a.y - b.x + b.y).abs() < 1e-9, "{a:?} {b:?}");
        }
    }

    #[test]
    fn far_away_nothing_is_drawn() {
        assert!(hatch(&[square(-1e9, 1e9)], Pixel::default(), SIZE).len() < 100);
        assert!(hatch(&[square(1e6, 2e6)], Pixel::default(), SIZE).is_empty());
    }
}
