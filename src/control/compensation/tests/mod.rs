//! All tests use [`run`]: input and output paths are in drawing coordinates (X diameter).

mod faults;
#[cfg(not(target_arch = "wasm32"))]
mod properties;

use super::*;
use crate::geometry::{Arc, Turn};

const NEAR: f64 = 1e-6;

/// A point of a drawing: X diameter and Z.
fn at(diameter: f64, z: f64) -> Point {
    Point::new(diameter / 2.0, z)
}

fn nose(radius: f64, tip: u8) -> Nose {
    Nose { radius, tip }
}

fn line(id: u32, from: Point, to: Point) -> Element {
    Element { id, travel: Travel::Feed, from, to, shape: Shape::Line }
}

fn rapid(id: u32, from: Point, to: Point) -> Element {
    Element { travel: Travel::Rapid, ..line(id, from, to) }
}

fn arc(id: u32, from: Point, to: Point, center: Point, turn: Turn) -> Element {
    Element { shape: Shape::Arc { center, turn }, ..line(id, from, to) }
}

/// Straight elements through points, numbered from 0.
fn lines(points: &[Point]) -> Vec<Element> {
    (0..).zip(points.windows(2)).map(|(id, pair)| line(id, pair[0], pair[1])).collect()
}

/// Compensates a path from its first point, then G40 with `leave`, if given.
fn run(side: Side, nose: Nose, path: &[Element], leave: Option<Element>) -> Vec<Outcome> {
    let mut outcomes = Vec::new();
    let mut compensator = Compensator::start(side, nose, path[0].from);
    for element in path {
        compensator.push(*element, &mut |outcome| outcomes.push(outcome));
    }
    compensator.cancel(leave, None, &mut |outcome| outcomes.push(outcome));
    outcomes
}

fn moves(outcomes: &[Outcome]) -> Vec<Compensated> {
    outcomes.iter().map(|outcome| outcome.expect("no fault")).collect()
}

fn faults(outcomes: &[Outcome]) -> Vec<CompensationError> {
    outcomes.iter().filter_map(|outcome| outcome.err()).collect()
}

#[track_caller]
fn assert_ends(moves: &[Compensated], expected: &[Point]) {
    let ends: Vec<Point> = moves.iter().map(|compensated| compensated.to).collect();
    let same = ends.len() == expected.len()
        && ends.iter().zip(expected).all(|(end, expected)| end.distance(*expected) < 1e-4);
    assert!(same, "{ends:?}\nexpected {expected:?}");
    for pair in moves.windows(2) {
        assert_eq!(pair[0].to, pair[1].from);
    }
}

fn distance(point: Point, element: &Element) -> f64 {
    match element.shape {
        Shape::Line => {
            let along = Vector::between(element.from, element.to);
            let t = Vector::between(element.from, point).dot(along) / along.dot(along);
            point.distance((along * t.clamp(0.0, 1.0)).from(element.from))
        }
        Shape::Arc { center, turn } => {
            let arc = Arc { start: element.from, end: element.to, center, turn };
            let sweep = arc.sweep();
            let reached = Arc { end: point, ..arc }.sweep();
            let ends = point.distance(arc.start).min(point.distance(arc.end));
            match reached / sweep <= 1.0 {
                true => ends.min((point.distance(center) - arc.radius()).abs()),
                false => ends,
            }
        }
    }
}

/// Positions of the nose centre along a move.
fn centers(compensated: &Compensated, nose: Nose) -> Vec<Point> {
    const STEPS: usize = 40;
    let place = |step: usize| {
        let t = step as f64 / STEPS as f64;
        match compensated.shape {
            Shape::Line => (Vector::between(compensated.from, compensated.to) * t).from(compensated.from),
            Shape::Arc { center, turn } => {
                Arc { start: compensated.from, end: compensated.to, center, turn }.at(t)
            }
        }
    };
    (0..=STEPS).map(|step| nose.offset().from(place(step))).collect()
}

/// Checks that no move after the start-up brings the nose into an element of `path` that `belongs`, and that
/// every programmed move except start-up and cancel touches its element.
#[track_caller]
fn assert_tangent(
    moves: &[Compensated],
    nose: Nose,
    path: &[Element],
    belongs: impl Fn(&Compensated, &Element) -> bool,
) {
    assert_clear(moves, nose, path, belongs, NEAR);
}

/// The same, but the nose may cut in by the permitted depth, mm.
#[track_caller]
fn assert_clear(
    moves: &[Compensated],
    nose: Nose,
    path: &[Element],
    belongs: impl Fn(&Compensated, &Element) -> bool,
    allowed: f64,
) {
    for compensated in moves.iter().filter(|compensated| compensated.id != path[0].id) {
        for center in centers(compensated, nose) {
            if compensated.made_by == MadeBy::Compensation {
                let gap = center.distance(compensated.programmed) - nose.radius;
                assert!(gap >= -allowed, "{gap} too near the corner: {center:?} {compensated:?}");
            }
            for element in path[1..].iter().filter(|element| belongs(compensated, element)) {
                let gap = distance(center, element) - nose.radius;
                assert!(gap >= -allowed, "{gap} too near: {center:?} {compensated:?} {element:?}");
            }
        }
    }
}

#[track_caller]
fn assert_touches(moves: &[Compensated], nose: Nose, path: &[Element]) {
    for element in &path[1..] {
        let compensated = moves.iter().find(|made| made.id == element.id && made.made_by == MadeBy::Program);
        let centers = centers(compensated.expect("one move for each element"), nose);
        let nearest = centers.iter().map(|center| distance(*center, element)).fold(f64::MAX, f64::min);
        assert!((nearest - nose.radius).abs() <= NEAR, "{nearest} from {element:?}");
    }
}

#[test]
fn the_tip_stays_on_cylinder_and_face() {
    let (start, corner, end) = (at(20.0, 2.0), at(20.0, -20.0), at(40.0, -20.0));
    let path = [rapid(2, at(50.0, 5.0), start), line(3, start, corner), line(4, corner, end)];
    let leave = rapid(5, at(40.0, -20.0), at(50.0, 5.0));
    let moves = moves(&run(Side::Right, nose(0.8, 3), &path, Some(leave)));
    assert_ends(&moves, &[at(20.0, 1.2), at(20.0, -20.0), at(38.4, -20.0), at(50.0, 5.0)]);
    assert_eq!(moves.iter().map(|made| made.id).collect::<Vec<_>>(), [2, 3, 4, 5]);
    assert_eq!(moves[0].travel, Travel::Rapid);
    assert_eq!(moves[1].to, at(20.0, -20.0), "exactly, not nearly");
    assert_eq!(moves[2].programmed, at(40.0, -20.0));
}

/// Face, taper, cylinder, step, fillet and shoulder.
fn shaft() -> (Vec<Element>, Element) {
    let points = [
        at(10.0, 3.0),
        at(10.0, 0.0),
        at(20.0, 0.0),
        at(30.0, -10.0),
        at(30.0, -20.0),
        at(36.0, -20.0),
        at(36.0, -28.0),
    ];
    let mut path = lines(&points);
    path.push(arc(6, at(36.0, -28.0), at(46.0, -33.0), at(46.0, -28.0), Turn::Clockwise));
    path.push(line(7, at(46.0, -33.0), at(56.0, -33.0)));
    (path, rapid(8, at(56.0, -33.0), at(200.0, 200.0)))
}

#[test]
fn round_a_shaft_the_taper_shifts_and_the_fillet_shrinks() {
    let (path, leave) = shaft();
    let moves = moves(&run(Side::Right, nose(0.4, 3), &path, Some(leave)));
    assert_ends(
        &moves,
        &[
            at(9.2, 0.0),
            at(19.6944, 0.0),
            at(30.0, -10.3056),
            at(30.0, -20.0),
            at(36.0, -20.0),
            at(36.0, -28.4),
            at(45.2, -33.0),
            at(55.2, -33.0),
            at(200.0, 200.0),
        ],
    );
    let Shape::Arc { center, turn: Turn::Clockwise } = moves[6].shape else { panic!("{:?}", moves[6]) };
    assert!(center.distance(at(45.2, -28.4)) < NEAR);
}

#[test]
fn finishing_with_g42_never_goes_through_the_profile() {
    let (path, leave) = shaft();
    for radius in [0.2, 0.4, 0.8, 1.2, 2.4] {
        for tip in 0..=9 {
            let nose = nose(radius, tip);
            let moves = moves(&run(Side::Right, nose, &path, Some(leave)));
            assert_tangent(&moves[..8], nose, &path, |_, _| true);
            assert_touches(&moves, nose, &path);
        }
    }
}

#[test]
fn a_square_is_milled_from_outside_in_the_virtual_plane() {
    // First axis: virtual X as a radius; second axis: virtual C. The cutter is programmed at its centre.
    let at = |x: f64, c: f64| Point::new(c, x);
    let corners =
        [at(40.0, 0.0), at(25.0, 0.0), at(25.0, 25.0), at(-25.0, 25.0), at(-25.0, -25.0), at(25.0, -25.0), {
            at(25.0, 0.0)
        }];
    let leave = line(9, at(25.0, 0.0), at(50.0, 0.0));
    let made = moves(&run(Side::Right, nose(10.0, 0), &lines(&corners), Some(leave)));
    let round = [at(35.0, 35.0), at(-35.0, 35.0), at(-35.0, -35.0), at(35.0, -35.0), at(35.0, 0.0)];
    let mut expected = vec![at(35.0, 0.0)];
    expected.extend(round);
    expected.push(at(50.0, 0.0));
    assert_ends(&made, &expected);

    // As printed in the manual: straight to the second corner.
    let mut printed = corners.to_vec();
    printed.remove(1);
    let made = moves(&run(Side::Right, nose(10.0, 0), &lines(&printed), Some(leave)));
    expected.splice(..2, [at(25.0, 35.0)]);
    assert_ends(&made, &expected);
}

#[test]
fn a_sharp_outer_corner_is_rounded_with_a_straight_feed() {
    // A point of 45°: out along the cylinder, back with a turn of 135°.
    let path = lines(&[at(60.0, 5.0), at(60.0, 0.0), at(60.0, -20.0), at(40.0, -10.0)]);
    let made = moves(&run(Side::Right, nose(2.0, 0), &path, None));
    assert_eq!(made[2].made_by, MadeBy::Compensation);
    assert_eq!((made[2].id, made[2].programmed), (2, at(60.0, -20.0)));
    let root = 2f64.sqrt();
    assert!(made[1].to.distance(Point::new(32.0, -22.0)) < NEAR);
    assert!(made[2].to.distance(Point::new(30.0, -20.0 - 2.0 * root)) < NEAR, "{:?}", made[2]);
    assert_tangent(&made, nose(2.0, 0), &path, |_, _| true);
}

#[test]
fn a_quarter_turn_outside_needs_no_extra_move() {
    let path = lines(&[at(60.0, 5.0), at(60.0, 0.0), at(60.0, -20.0), at(40.0, -20.0)]);
    let made = moves(&run(Side::Right, nose(2.0, 0), &path, None));
    assert_ends(&made, &[at(64.0, 0.0), at(64.0, -22.0), at(40.0, -22.0)]);
}

#[test]
fn a_full_circle_stays_full() {
    let start = Point::new(0.0, 20.0);
    let circle = arc(1, start, start, Point::new(0.0, 0.0), Turn::Counterclockwise);
    let path = |approach: Point, leave: Point, element: fn(u32, Point, Point) -> Element| {
        [
            line(0, Point::new(-30.0, 5.0), approach),
            element(2, approach, start),
            circle,
            element(3, start, leave),
        ]
    };
    // Along the tangent, and at a right angle to it from inside: if it were lengthened, the circle would
    // intersect itself.
    let (below, above, inside) = (Point::new(-10.0, 20.0), Point::new(10.0, 20.0), Point::new(0.0, 5.0));
    for path in [path(below, above, line), path(inside, inside, line)] {
        let made = moves(&run(Side::Right, nose(5.0, 0), &path, None));
        let round = made.iter().find(|made| matches!(made.shape, Shape::Arc { .. })).expect("the circle");
        assert!(round.from.is_same(round.to) && round.to.is_same(Point::new(0.0, 25.0)), "{round:?}");
    }
    // Back along the tangent, the nose would change to the inside.
    let found = faults(&run(Side::Right, nose(5.0, 0), &path(below, below, line), None));
    assert!(matches!(found[..], [CompensationError { id: 3, reason: Reason::CutsIn { .. } }]), "{found:?}");
    // From outside, the corner shortens both ends by the same amount.
    let outside = Point::new(0.0, 40.0);
    let path =
        [line(0, Point::new(-30.0, 40.0), outside), line(2, outside, start), circle, line(3, start, outside)];
    let made = moves(&run(Side::Right, nose(5.0, 0), &path, None));
    let (begins, ends) = (Point::new(5.0, 600f64.sqrt()), Point::new(-5.0, 600f64.sqrt()));
    assert!(made[2].from.is_same(begins) && made[2].to.is_same(ends), "{:?}", made[2]);
}

#[test]
fn what_leads_to_a_closed_contour_is_none() {
    // A circle of radius 20 in two halves, milled from outside, with tangential approach and retract.
    let (start, half, center) = (Point::new(0.0, 20.0), Point::new(0.0, -20.0), Point::new(0.0, 0.0));
    let (below, above) = (Point::new(-10.0, 20.0), Point::new(10.0, 20.0));
    let path = [
        line(0, Point::new(-30.0, 40.0), below),
        line(1, below, start),
        arc(2, start, half, center, Turn::Counterclockwise),
        arc(3, half, start, center, Turn::Counterclockwise),
        line(4, start, above),
    ];
    let made = moves(&run(Side::Right, nose(5.0, 0), &path, None));
    assert_eq!(made.len(), 5);
}

#[test]
fn line_and_arc_meet_exactly_at_inner_and_outer_corners() {
    // Into a ball of radius 10 from a smaller neck, and out of it onto a cylinder.
    let (neck, shoulder) = (at(12.0, -2.0), at(16.0, -16.0));
    let path = [
        line(0, at(30.0, 5.0), at(12.0, 5.0)),
        line(1, at(12.0, 5.0), neck),
        arc(2, neck, shoulder, at(0.0, -10.0), Turn::Counterclockwise),
        line(3, shoulder, at(16.0, -30.0)),
    ];
    for (side, radius) in [(Side::Right, 0.8), (Side::Right, 3.0), (Side::Left, 0.8), (Side::Left, 1.5)] {
        let nose = nose(radius, 3);
        let made = moves(&run(side, nose, &path, None));
        assert_eq!(made.len(), 4, "both corners meet without extra moves");
        assert_tangent(&made, nose, &path, |made, element| made.id == element.id);
        assert_touches(&made, nose, &path);
        let Shape::Arc { center, .. } = made[2].shape else { panic!("{:?}", made[2]) };
        let expected = if side == Side::Right { 10.0 + radius } else { 10.0 - radius };
        assert!((made[2].from.distance(center) - expected).abs() < NEAR);
        assert!((made[2].to.distance(center) - expected).abs() < NEAR);
    }
}

#[test]
fn two_arcs_meet_exactly() {
    // Two balls of radius 10, centres 12 apart: a valley of two arcs.
    let (valley, end) = (at(16.0, -16.0), at(16.0, -28.0));
    let path = [
        line(0, at(0.0, 5.0), at(0.0, 0.0)),
        arc(1, at(0.0, 0.0), valley, at(0.0, -10.0), Turn::Counterclockwise),
        arc(2, valley, end, at(0.0, -22.0), Turn::Counterclockwise),
    ];
    for side in [Side::Right, Side::Left] {
        let nose = nose(2.0, 0);
        let made = moves(&run(side, nose, &path, None));
        assert_eq!(made.len(), 3);
        assert!((made[1].to.z - -16.0).abs() < NEAR);
        assert_tangent(&made, nose, &path, |_, _| true);
    }
}

#[test]
fn arcs_rounded_to_the_micron_join_smoothly() {
    // A ball of radius 15, then tangent cylinder, in coordinates of three decimals;
    // then the arc in two pieces.
    let split = Point::new(10.607, -4.393);
    let path = [
        line(0, at(0.0, 5.0), at(0.0, 0.0)),
        arc(1, at(0.0, 0.0), split, at(0.0, -15.0), Turn::Counterclockwise),
        arc(2, split, at(30.0, -15.0), Point::new(0.0003, -15.0002), Turn::Counterclockwise),
        line(3, at(30.0, -15.0), at(30.0, -40.0)),
    ];
    let made = moves(&run(Side::Right, nose(0.8, 3), &path, None));
    assert_eq!(made.len(), 4);
    assert!(made[1].to.distance(Point::new(10.607 + 0.8 * (0.5f64.sqrt() - 1.0), -4.393 - 0.234)) < 2e-3);
}

#[test]
fn g40_alone_leaves_the_tip_beside_the_path() {
    let path = lines(&[at(50.0, 5.0), at(20.0, 2.0), at(20.0, -20.0), at(40.0, -20.0)]);
    let made = moves(&run(Side::Right, nose(0.8, 3), &path, None));
    assert!(made[2].to.is_same(at(38.4, -20.0)));
}

#[test]
fn without_look_ahead_the_nose_waits_perpendicular_and_cuts_the_corner() {
    let path = lines(&[at(50.0, 5.0), at(20.0, 2.0), at(20.0, -20.0), at(40.0, -20.0)]);
    let mut made = Vec::new();
    let mut keep = |outcome: Outcome| made.push(outcome.unwrap());
    let mut compensator = Compensator::start(Side::Right, nose(0.8, 0), at(50.0, 5.0));
    compensator.push(path[0], &mut keep);
    compensator.push(path[1], &mut keep);
    compensator.flush(&mut keep);
    assert!(compensator.tip().is_same(at(21.6, -20.0)));
    compensator.push(path[2], &mut keep);
    compensator.flush(&mut keep);
    compensator.flush(&mut keep);
    assert_ends(&made, &[at(21.6, 2.0), at(21.6, -20.0), at(40.0, -19.2)]);
}

#[test]
fn a_block_without_length_is_no_move() {
    let corner = at(20.0, -20.0);
    let still = line(9, corner, corner);
    let with = [
        line(1, at(50.0, 5.0), at(20.0, 2.0)),
        line(2, at(20.0, 2.0), corner),
        still,
        line(3, corner, at(40.0, -20.0)),
    ];
    let without = [with[0], with[1], with[3]];
    let nose = nose(0.8, 3);
    assert_eq!(run(Side::Right, nose, &with, None), run(Side::Right, nose, &without, None));
}

#[test]
fn changing_the_side_crosses_the_path() {
    let points = [at(50.0, 5.0), at(20.0, 2.0), at(20.0, -10.0), at(20.0, -20.0)];
    let path = lines(&points);
    let mut made = Vec::new();
    let mut keep = |outcome: Outcome| made.push(outcome.unwrap());
    let mut compensator = Compensator::start(Side::Right, nose(1.0, 0), points[0]);
    compensator.push(path[0], &mut keep);
    compensator.push(path[1], &mut keep);
    compensator.change_side(Side::Left);
    compensator.push(path[2], &mut keep);
    compensator.flush(&mut keep);
    assert_ends(&made, &[at(22.0, 2.0), at(22.0, -10.0), at(18.0, -10.0), at(18.0, -20.0)]);
    assert_eq!(made[2].made_by, MadeBy::Compensation);
}

/// Two balls of radius 2 and 3 side by side, with perpendicular approach and retract: a valley of 180°.
fn cusp() -> Vec<Element> {
    let (begin, valley, end) = (at(32.0, 0.0), at(28.0, -2.0), at(34.0, -5.0));
    vec![
        rapid(0, at(40.0, 5.0), at(32.0, 2.0)),
        line(1, at(32.0, 2.0), begin),
        arc(2, begin, valley, at(28.0, 0.0), Turn::Counterclockwise),
        arc(3, valley, end, at(28.0, -5.0), Turn::Counterclockwise),
        line(4, end, at(34.0, -20.0)),
    ]
}

/// A groove in a cylinder, `width` wide at the bottom.
fn groove(width: f64) -> Vec<Element> {
    let wall = -20.0 - width;
    lines(&[
        at(40.0, 5.0),
        at(40.0, 0.0),
        at(40.0, -20.0),
        at(20.0, -20.0),
        at(20.0, wall),
        at(40.0, wall),
        at(40.0, -50.0),
    ])
}

#[test]
fn a_path_is_compensated_as_a_whole() {
    let (path, _) = shaft();
    let whole = compensate_path(Side::Right, nose(0.4, 3), path[0].from, &path).unwrap();
    assert_eq!(whole, moves(&run(Side::Right, nose(0.4, 3), &path, None)));
    let narrow = compensate_path(Side::Right, nose(1.5, 8), at(40.0, 5.0), &groove(2.0));
    assert!(matches!(narrow, Err(CompensationError { id: 3, reason: Reason::Overcut { .. } })));
}

#[test]
fn a_taper_of_a_single_cycle_is_moved_by_the_textbook_amount() {
    let (start, end) = (at(20.0, 0.0), at(40.0, -30.0));
    let angle = (10.0f64 / 30.0).atan();
    let nose = nose(0.8, 3);
    let z = cycle_shift(Side::Right, nose, start, end, Axis::Z).unwrap();
    let x = cycle_shift(Side::Right, nose, start, end, Axis::X).unwrap();
    assert!((z - -0.8 * (1.0 - (angle / 2.0).tan())).abs() < NEAR, "{z}");
    assert!((x / z - (angle.tan())).abs() < NEAR, "{x} {z}");
    assert_eq!(cycle_shift(Side::Right, nose, start, at(20.0, -30.0), Axis::X), Some(0.0));
    assert_eq!(cycle_shift(Side::Right, nose, start, at(20.0, -30.0), Axis::Z), None);
    assert_eq!(cycle_shift(Side::Right, nose, start, start, Axis::X), None);
}
