//! Clips polygons and lines to the picture, because browsers lose edges with very distant ends.
//!
//! In: corners on the screen, and the size of the picture. Out: the same shape within the picture and a
//! margin around it. Each edge keeps its direction.

use super::camera::{Pixel, Size};

/// Margin around the picture, CSS pixels: more than half of the widest line.
const MARGIN: f64 = 10.0;

/// A piece of a line inside the picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Piece {
    /// The corners, at least two.
    pub corners: Vec<Pixel>,
    /// Length of the line before this piece, CSS pixels, for the phase of its dashes.
    pub before: f64,
}

/// Signed distances of a position from the sides of the clipping rectangle, CSS pixels; negative outside.
fn inside(at: Pixel, size: Size) -> [f64; 4] {
    [at.x + MARGIN, size.width + MARGIN - at.x, at.y + MARGIN, size.height + MARGIN - at.y]
}

/// The position at the fraction `share` of the way from `a` to `b`.
fn between(a: Pixel, b: Pixel, share: f64) -> Pixel {
    Pixel::new(a.x + share * (b.x - a.x), a.y + share * (b.y - a.y))
}

/// The part of a polygon inside the picture. A polygon that leaves the picture is closed along the clipping
/// rectangle, outside the picture. Uses the algorithm of Sutherland and Hodgman (1974).
pub fn polygon(corners: &[Pixel], size: Size) -> Vec<Pixel> {
    let mut clipped = corners.to_vec();
    for side in 0..4 {
        let whole = std::mem::take(&mut clipped);
        let Some(&last) = whole.last() else { break };
        let mut from = last;
        for to in whole {
            let (a, b) = (inside(from, size)[side], inside(to, size)[side]);
            if (a < 0.0) != (b < 0.0) {
                clipped.push(between(from, to, a / (a - b)));
            }
            if b >= 0.0 {
                clipped.push(to);
            }
            from = to;
        }
    }
    clipped
}

/// The pieces of a line inside the picture, in order.
pub fn polyline(corners: &[Pixel], size: Size) -> Vec<Piece> {
    let mut pieces: Vec<Piece> = Vec::new();
    let (mut before, mut goes_on) = (0.0, false);
    for edge in corners.windows(2) {
        let [from, to] = [edge[0], edge[1]];
        let length = from.distance(to);
        let Some([first, last]) = shares(from, to, size) else {
            (before, goes_on) = (before + length, false);
            continue;
        };
        let end = if last < 1.0 { between(from, to, last) } else { to };
        match pieces.last_mut() {
            Some(piece) if goes_on && first == 0.0 => piece.corners.push(end),
            _ => {
                let begin = if first > 0.0 { between(from, to, first) } else { from };
                pieces.push(Piece { corners: vec![begin, end], before: before + first * length });
            }
        }
        (before, goes_on) = (before + length, last == 1.0);
    }
    pieces
}

/// The start and end of the part of an edge inside the picture, as fractions of the edge. Uses the algorithm
/// of Liang and Barsky (1984).
fn shares(from: Pixel, to: Pixel, size: Size) -> Option<[f64; 2]> {
    let (mut first, mut last) = (0.0_f64, 1.0_f64);
    for (a, b) in inside(from, size).into_iter().zip(inside(to, size)) {
        match (a < 0.0, b < 0.0) {
            (true, true) => return None,
            (true, false) => first = first.max(a / (a - b)),
            (false, true) => last = last.min(a / (a - b)),
            (false, false) => {}
        }
    }
    (first <= last).then_some([first, last])
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use proptest::test_runner::RngSeed;

    use super::*;

    const SIZE: Size = Size { width: 100.0, height: 80.0 };

    fn pixels(corners: &[(f64, f64)]) -> Vec<Pixel> {
        corners.iter().map(|&(x, y)| Pixel::new(x, y)).collect()
    }

    /// Twice the area, by the shoelace formula.
    fn area(corners: &[Pixel]) -> f64 {
        let next = corners.iter().cycle().skip(1);
        corners.iter().zip(next).map(|(a, b)| a.x * b.y - b.x * a.y).sum::<f64>().abs()
    }

    #[test]
    fn a_polygon_in_the_picture_stays_as_it_is() {
        let corners = pixels(&[(0.0, 0.0), (100.0, 5.0), (60.0, 80.0)]);
        let (mut clipped, mut expected) = (polygon(&corners, SIZE), corners.clone());
        let order = |at: &Pixel, other: &Pixel| at.x.total_cmp(&other.x);
        clipped.sort_by(order);
        expected.sort_by(order);
        assert_eq!(clipped, expected);
        assert_eq!(area(&polygon(&corners, SIZE)), area(&corners));
    }

    #[test]
    fn a_taper_that_leaves_the_picture_keeps_its_slope() {
        // From (50, 40) to (1050, 540): slope of one down to two right.
        let corners = pixels(&[(50.0, 40.0), (1050.0, 540.0), (50.0, 540.0)]);
        let clipped = polygon(&corners, SIZE);
        // The clipping rectangle ends at x = 110 and y = 90.
        assert!(clipped.contains(&Pixel::new(110.0, 70.0)), "{clipped:?}");
        assert!(
            clipped.contains(&Pixel::new(110.0, 90.0)) && clipped.contains(&Pixel::new(50.0, 90.0)),
            "{clipped:?}"
        );
        // A trapezium 60 wide, with sides of 50 and 20.
        assert!((area(&clipped) / 2.0 - 60.0 * 35.0).abs() < 1e-9, "{clipped:?}");
    }

    #[test]
    fn a_polygon_around_the_picture_fills_it_and_one_beside_it_is_gone() {
        let around = pixels(&[(-1e9, -1e9), (1e9, -1e9), (1e9, 1e9), (-1e9, 1e9)]);
        assert!((area(&polygon(&around, SIZE)) / 2.0 - 120.0 * 100.0).abs() < 1e-3);
        assert_eq!(polygon(&pixels(&[(200.0, 0.0), (300.0, 0.0), (300.0, 50.0)]), SIZE), []);
        assert_eq!(polygon(&[], SIZE), []);
    }

    #[test]
    fn a_line_is_cut_where_it_leaves_and_goes_on_where_it_returns() {
        // Out to the right at y = 10, back at y = 30.
        let line = pixels(&[(10.0, 10.0), (210.0, 10.0), (210.0, 30.0), (10.0, 30.0), (10.0, 50.0)]);
        let expected = [
            Piece { corners: pixels(&[(10.0, 10.0), (110.0, 10.0)]), before: 0.0 },
            // 200 to the corner, 20 down, 100 back.
            Piece { corners: pixels(&[(110.0, 30.0), (10.0, 30.0), (10.0, 50.0)]), before: 320.0 },
        ];
        assert_eq!(polyline(&line, SIZE), expected);
    }

    #[test]
    fn a_line_across_a_corner_of_the_picture_is_found_and_one_past_it_is_not() {
        // x + y = −15 goes through the margin, from (−10, −5) to (−5, −10).
        let across = polyline(&pixels(&[(-100.0, 85.0), (85.0, -100.0)]), SIZE);
        assert_eq!(across.len(), 1);
        let ends: Vec<_> = across[0].corners.iter().map(|at| (at.x.round(), at.y.round())).collect();
        assert_eq!(ends, [(-10.0, -5.0), (-5.0, -10.0)]);
        // x + y = −25 misses the margin.
        assert_eq!(polyline(&pixels(&[(-100.0, 75.0), (75.0, -100.0)]), SIZE), []);
        assert_eq!(polyline(&pixels(&[(5.0, 5.0)]), SIZE), []);
    }

    /// Whether a position is inside a polygon, by the even-odd rule.
    fn holds(corners: &[Pixel], at: Pixel) -> bool {
        let next = corners.iter().cycle().skip(1);
        let crosses = |(a, b): &(&Pixel, &Pixel)| {
            (a.y > at.y) != (b.y > at.y) && at.x < a.x + (at.y - a.y) / (b.y - a.y) * (b.x - a.x)
        };
        corners.iter().zip(next).filter(crosses).count() % 2 == 1
    }

    /// Distance of a position from a line through corners.
    fn distance(corners: &[Pixel], at: Pixel) -> f64 {
        let of_edge = |edge: &[Pixel]| {
            let ([a, b], length) = ([edge[0], edge[1]], edge[0].distance(edge[1]));
            let along = (at.x - a.x) * (b.x - a.x) + (at.y - a.y) * (b.y - a.y);
            at.distance(between(a, b, (along / (length * length).max(1e-12)).clamp(0.0, 1.0)))
        };
        corners.windows(2).map(of_edge).fold(f64::INFINITY, f64::min)
    }

    proptest! {
        #![proptest_config(ProptestConfig { rng_seed: RngSeed::Fixed(7), failure_persistence: None, ..ProptestConfig::with_cases(200) })]

        /// Zoomed in up to a thousand times, a picture looks the same as one of the whole outline.
        #[test]
        fn what_is_seen_of_an_outline_is_that_of_the_whole(
            corners in prop::collection::vec((-2.0..3.0_f64, -2.0..3.0_f64), 3..40),
            zoom in 0.0..3.0_f64,
            places in prop::collection::vec((0.0..1.0_f64, 0.0..1.0_f64), 100),
        ) {
            let scale = 100.0 * 10.0_f64.powf(zoom);
            let corners: Vec<Pixel> = corners.iter().map(|&(x, y)| Pixel::new(x * scale, y * scale)).collect();
            let (clipped, pieces) = (polygon(&corners, SIZE), polyline(&corners, SIZE));
            let closed: Vec<Pixel> = corners.iter().chain(&corners[..1]).copied().collect();
            for (x, y) in places {
                let at = Pixel::new(x * SIZE.width, y * SIZE.height);
                if distance(&closed, at) > 1e-6 {
                    prop_assert_eq!(holds(&clipped, at), holds(&corners, at), "{:?}", at);
                }
                // Lines within the margin keep their distance.
                let (near, whole) = (pieces.iter().map(|piece| distance(&piece.corners, at)).fold(f64::INFINITY, f64::min), distance(&corners, at));
                prop_assert!(if whole < MARGIN { (near - whole).abs() < 1e-6 } else { near >= whole - 1e-6 }, "{:?}", at);
            }
            let length = |corners: &[Pixel]| corners.windows(2).map(|edge| edge[0].distance(edge[1])).sum::<f64>();
            for piece in pieces {
                prop_assert!(piece.before + length(&piece.corners) <= length(&corners) + 1e-6);
            }
        }
    }
}
