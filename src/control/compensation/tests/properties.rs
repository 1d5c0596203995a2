//! Properties of all paths: random lines and arcs.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, PI};

use proptest::prelude::*;

use super::*;
use crate::control::compensation::clearance::ALLOWED;

/// A piece of a random path: length, turn before it in radians, and bend as an arc.
type Piece = (f64, f64, Option<f64>);

fn pieces(arcs: bool) -> impl Strategy<Value = Vec<Piece>> {
    let bend = match arcs {
        true => prop_oneof![Just(None), (-1.2..1.2f64).prop_map(Some)].boxed(),
        false => Just(None).boxed(),
    };
    prop::collection::vec((1.0..20.0f64, -2.9..2.9f64, bend), 2..8)
}

/// The same with short pieces, large arcs, and usual turns: tangential, reverse and square, and slightly
/// different ones, as with coordinates of three decimals.
fn drawn_pieces() -> impl Strategy<Value = Vec<Piece>> {
    let length = prop_oneof![0.05..2.0f64, 1.0..20.0f64];
    let square = prop::sample::select(vec![0.0, FRAC_PI_2, PI, -FRAC_PI_2, -PI, FRAC_PI_3, -FRAC_PI_3]);
    let off = prop_oneof![Just(0.0), -3e-7..3e-7f64, -1e-3..1e-3f64, -0.05..0.05f64];
    let turn = prop_oneof![-3.1..3.1f64, (square, off).prop_map(|(square, off)| square + off)];
    let bend = prop_oneof![Just(None), (-4.5..4.5f64).prop_map(Some)];
    prop::collection::vec((length, turn, bend), 2..8)
}

fn random_path(pieces: &[Piece]) -> Vec<Element> {
    let (mut point, mut heading) = (Point::new(30.0, 0.0), 0.0f64);
    let mut path = Vec::new();
    for (id, &(length, turn, bend)) in (0..).zip(pieces) {
        heading += turn;
        let bend = bend.filter(|bend| id > 0 && bend.abs() > 0.05).unwrap_or(0.0);
        let chord = heading + bend / 2.0;
        let to = Point::new(point.x + length * chord.sin(), point.z + length * chord.cos());
        let mut element = line(id, point, to);
        if bend != 0.0 {
            let radius = length / 2.0 / (bend / 2.0).sin();
            let center = Point::new(point.x + radius * heading.cos(), point.z - radius * heading.sin());
            let turn = if bend > 0.0 { Turn::Counterclockwise } else { Turn::Clockwise };
            element.shape = Shape::Arc { center, turn };
        }
        path.push(element);
        (point, heading) = (to, heading + bend);
    }
    path
}

fn mirrored(point: Point, axis: Axis) -> Point {
    match axis {
        Axis::X => Point::new(-point.x, point.z),
        Axis::Z => Point::new(point.x, -point.z),
    }
}

fn mirrored_shape(shape: Shape, axis: Axis) -> Shape {
    match shape {
        Shape::Line => Shape::Line,
        Shape::Arc { center, turn } => {
            let turn = match turn {
                Turn::Clockwise => Turn::Counterclockwise,
                Turn::Counterclockwise => Turn::Clockwise,
            };
            Shape::Arc { center: mirrored(center, axis), turn }
        }
    }
}

fn sides() -> impl Strategy<Value = Side> {
    prop_oneof![Just(Side::Left), Just(Side::Right)]
}

proptest! {
    #[test]
    fn the_nose_never_cuts_into_its_lines(
        pieces in pieces(false), side in sides(), radius in 0.05..4.0f64, tip in 0..=9u8,
    ) {
        let (path, nose) = (random_path(&pieces), nose(radius, tip));
        let outcomes = run(side, nose, &path, None);
        if faults(&outcomes).is_empty() {
            assert_tangent(&moves(&outcomes), nose, &path, |made, element| match made.made_by {
                MadeBy::Program => made.id.abs_diff(element.id) <= 1,
                MadeBy::Compensation => made.id == element.id || made.id == element.id + 1,
            });
        }
    }

    #[test]
    fn the_nose_never_cuts_into_its_arcs(
        pieces in pieces(true), side in sides(), radius in 0.05..4.0f64, tip in 0..=9u8,
    ) {
        let (path, nose) = (random_path(&pieces), nose(radius, tip));
        let outcomes = run(side, nose, &path, None);
        if faults(&outcomes).is_empty() {
            assert_tangent(&moves(&outcomes), nose, &path, |made, element| {
                made.made_by == MadeBy::Program && made.id == element.id
            });
        }
    }

    #[test]
    fn the_nose_never_cuts_into_the_moves_beside_its_own(
        pieces in drawn_pieces(), side in sides(), radius in 0.05..4.0f64, tip in 0..=9u8,
    ) {
        let (path, nose) = (random_path(&pieces), nose(radius, tip));
        let outcomes = run(side, nose, &path, None);
        if faults(&outcomes).is_empty() {
            assert_clear(&moves(&outcomes), nose, &path, |made, element| match made.made_by {
                MadeBy::Program => made.id.abs_diff(element.id) <= 2,
                MadeBy::Compensation => made.id == element.id || made.id == element.id + 1,
            }, ALLOWED + NEAR);
        }
    }

    #[test]
    fn radius_zero_is_the_programmed_path(pieces in pieces(true), side in sides(), tip in 0..=9u8) {
        let path = random_path(&pieces);
        let made = moves(&run(side, nose(0.0, tip), &path, None));
        prop_assert_eq!(made.len(), path.len());
        for (made, element) in made.iter().zip(&path) {
            prop_assert_eq!((made.id, made.from, made.to), (element.id, element.from, element.to));
            prop_assert_eq!((made.shape, made.made_by), (element.shape, MadeBy::Program));
        }
    }

    #[test]
    fn a_small_nose_stays_near_the_programmed_path(pieces in pieces(true), side in sides(), tip in 0..=9u8) {
        let path = random_path(&pieces);
        let outcomes = run(side, nose(1e-4, tip), &path, None);
        for made in outcomes.iter().filter_map(|outcome| outcome.ok()) {
            prop_assert!(made.to.distance(made.programmed) < 0.01);
        }
    }

    #[test]
    fn every_element_comes_out_once_and_in_order(
        pieces in pieces(true), side in sides(), radius in 0.05..8.0f64,
    ) {
        let path = random_path(&pieces);
        let outcomes = run(side, nose(radius, 3), &path, None);
        let mut ids: Vec<u32> = outcomes.iter().filter_map(|outcome| match outcome {
            Ok(made) => (made.made_by == MadeBy::Program).then_some(made.id),
            Err(fault) => Some(fault.id),
        }).collect();
        ids.sort_unstable();
        prop_assert_eq!(ids, (0..path.len() as u32).collect::<Vec<_>>());
        let made: Vec<Compensated> = outcomes.iter().filter_map(|outcome| outcome.ok()).collect();
        prop_assert!(made.windows(2).all(|pair| pair[0].to == pair[1].from && pair[0].id <= pair[1].id));
        prop_assert!(made.iter().all(|made| made.to.x.is_finite() && made.to.z.is_finite()));
    }

    #[test]
    fn a_mirrored_program_makes_the_mirrored_path(
        pieces in pieces(true), side in sides(), radius in 0.05..4.0f64, tip in 0..=9usize,
    ) {
        let path = random_path(&pieces);
        let plain = run(side, nose(radius, tip as u8), &path, None);
        for (axis, tips) in [(Axis::X, [0, 4, 3, 2, 1, 5, 8, 7, 6, 9]), (Axis::Z, [0, 2, 1, 4, 3, 7, 6, 5, 8, 9])] {
            let other: Vec<Element> = path.iter().map(|element| Element {
                from: mirrored(element.from, axis),
                to: mirrored(element.to, axis),
                shape: mirrored_shape(element.shape, axis),
                ..*element
            }).collect();
            let made = run(side.opposite(), nose(radius, tips[tip]), &other, None);
            prop_assert_eq!(made.len(), plain.len());
            for (made, plain) in made.iter().zip(&plain) {
                match (made, plain) {
                    (Ok(made), Ok(plain)) => {
                        prop_assert!(mirrored(made.to, axis).distance(plain.to) < NEAR);
                        prop_assert_eq!((made.id, made.made_by), (plain.id, plain.made_by));
                        match (mirrored_shape(made.shape, axis), plain.shape) {
                            (
                                Shape::Arc { center, turn },
                                Shape::Arc { center: plain_center, turn: plain_turn },
                            ) => prop_assert!(center.distance(plain_center) < NEAR && turn == plain_turn),
                            (shape, plain) => prop_assert_eq!(shape, plain),
                        }
                    }
                    (Err(made), Err(plain)) => prop_assert_eq!(made.id, plain.id),
                    _ => prop_assert!(false, "{:?} {:?}", made, plain),
                }
            }
        }
    }
}
