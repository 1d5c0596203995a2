//! Worked corners, each error beside its nearest correct neighbour, and properties of every corner.

use super::*;
#[cfg(not(target_arch = "wasm32"))]
use crate::geometry::Arc;
use crate::geometry::{Point, Turn};
use Turn::{Clockwise, Counterclockwise};

/// Tolerance of numbers computed by hand, which have six decimals.
const BY_HAND: f64 = 1e-6;

fn at(x: f64, z: f64) -> Point {
    Point::new(x, z)
}

fn line(from: Point, to: Point) -> Piece {
    Piece { from, to, arc: None }
}

fn arc(from: Point, to: Point, center: Point, turn: Turn) -> Piece {
    Piece { from, to, arc: Some((center, turn)) }
}

/// Points given as (x, z).
fn straight(from: (f64, f64), to: (f64, f64)) -> Piece {
    line(at(from.0, from.1), at(to.0, to.1))
}

fn round(from: (f64, f64), to: (f64, f64), center: (f64, f64), turn: Turn) -> Piece {
    arc(at(from.0, from.1), at(to.0, to.1), at(center.0, center.1), turn)
}

#[track_caller]
fn same_piece(found: &Piece, expected: &Piece) {
    let near = |a: Point, b: Point| a.distance(b) < BY_HAND;
    let arcs = match (found.arc, expected.arc) {
        (None, None) => true,
        (Some((center, turn)), Some((other, other_turn))) => near(center, other) && turn == other_turn,
        (None, Some(_)) | (Some(_), None) => false,
    };
    assert!(
        near(found.from, expected.from) && near(found.to, expected.to) && arcs,
        "{found:?}\n{expected:?}"
    );
}

/// Joins two moves and compares the inserted piece; the neighbours keep their other ends and meet it.
#[track_caller]
fn check(first: Piece, second: Piece, corner: Corner, inserted: Piece) {
    let joined = join(&first, &second, corner).unwrap();
    same_piece(&joined.inserted.unwrap(), &inserted);
    same_piece(&joined.first, &Piece { to: inserted.from, ..first });
    same_piece(&joined.second, &Piece { from: inserted.to, ..second });
}

#[track_caller]
fn check_fault(first: Piece, second: Piece, corner: Corner, alarm: Option<&str>) -> CornerError {
    let fault = join(&first, &second, corner).unwrap_err();
    assert_eq!(fault.alarm(), alarm, "{fault:?}");
    fault
}

/// Along the diameter 20 towards the chuck, to Z-20.
fn along_z() -> Piece {
    straight((10.0, 0.0), (10.0, -20.0))
}

/// Up the shoulder at Z-20, from diameter 20 to 40.
fn up_x() -> Piece {
    straight((10.0, -20.0), (20.0, -20.0))
}

#[test]
fn a_chamfer_of_2_on_a_shoulder_takes_2_of_z_and_2_of_radius() {
    check(along_z(), up_x(), Corner::Chamfer(2.0), straight((10.0, -18.0), (12.0, -20.0)));
}

#[test]
fn a_chamfer_before_a_30_degree_taper_is_measured_along_the_taper() {
    let taper = straight((10.0, -20.0), (20.0, -20.0 - 10.0 * 3_f64.sqrt()));
    check(along_z(), taper, Corner::Chamfer(3.0), straight((10.0, -17.0), (11.5, -22.598076)));
}

#[test]
fn a_shoulder_is_rounded_by_a_quarter_circle() {
    let inner = round((10.0, -15.0), (15.0, -20.0), (15.0, -15.0), Clockwise);
    check(along_z(), up_x(), Corner::Round(5.0), inner);
    let face = straight((0.0, 0.0), (10.0, 0.0));
    let outer = round((7.0, 0.0), (10.0, -3.0), (7.0, -3.0), Counterclockwise);
    check(face, along_z(), Corner::Round(3.0), outer);
}

#[test]
fn a_45_degree_taper_is_rounded_from_r_tan_22_5() {
    let taper = straight((10.0, -20.0), (20.0, -30.0));
    let inner = round((10.0, -15.857864), (12.928932, -22.928932), (20.0, -15.857864), Clockwise);
    check(along_z(), taper, Corner::Round(10.0), inner);
}

#[test]
fn an_arc_is_rounded_from_outside_and_from_inside() {
    // The centre of the rounding is 10 + 2 from the centre of the ball, then 10 - 2 from the centre of the
    // hollow.
    let ball = round((10.0, -20.0), (20.0, -30.0), (10.0, -30.0), Counterclockwise);
    let outside = round((10.0, -18.16784), (11.666667, -20.139867), (12.0, -18.16784), Clockwise);
    check(along_z(), ball, Corner::Round(2.0), outside);
    let inside = round((10.0, -17.745967), (7.5, -19.682458), (8.0, -17.745967), Counterclockwise);
    check(along_z(), hollow(), Corner::Round(2.0), inside);
}

/// A quarter circle of radius 10 below the line of [`along_z`], back from its end.
fn hollow() -> Piece {
    round((10.0, -20.0), (0.0, -10.0), (10.0, -10.0), Counterclockwise)
}

#[test]
fn the_valley_between_two_balls_is_rounded_and_chamfered() {
    let one = round((10.0, 6.0), (8.0, 0.0), (0.0, 6.0), Counterclockwise);
    let other = round((8.0, 0.0), (10.0, -6.0), (0.0, -6.0), Counterclockwise);
    let valley = round((9.165151, 2.0), (9.165151, -2.0), (13.747727, 0.0), Clockwise);
    check(one, other, Corner::Round(5.0), valley);
    // 2 mm straight from the corner to each end of the chamfer.
    let joined = join(&one, &other, Corner::Chamfer(2.0)).unwrap();
    let chamfer = joined.inserted.unwrap();
    assert!((chamfer.from.distance(at(8.0, 0.0)) - 2.0).abs() < 1e-9);
    assert!((chamfer.from.distance(at(0.0, 6.0)) - 10.0).abs() < 1e-9);
    assert!(chamfer.from.z > 0.0 && chamfer.from.x > 8.0);
    assert!((chamfer.from.x - chamfer.to.x).abs() < 1e-9 && (chamfer.from.z + chamfer.to.z).abs() < 1e-9);
    // At most from end to end of the first ball.
    let reach = at(10.0, 6.0).distance(at(8.0, 0.0));
    assert!(join(&one, &other, Corner::Chamfer(reach)).is_ok());
    check_fault(one, other, Corner::Chamfer(reach + 0.001), Some("PS0055"));
}

#[test]
fn nothing_is_inserted_for_zero_and_a_negative_value_is_told() {
    for corner in [Corner::Chamfer(0.0), Corner::Round(0.0), Corner::Round(-0.0), Corner::Round(f64::NAN)] {
        let untouched = Joined { first: along_z(), inserted: None, second: up_x() };
        assert_eq!(join(&along_z(), &up_x(), corner).unwrap(), untouched);
    }
    let fault = check_fault(along_z(), up_x(), Corner::Chamfer(-2.0), None);
    assert_eq!(fault, CornerError::Negative { value: -2.0 });
    assert!(join(&along_z(), &up_x(), Corner::Chamfer(f64::INFINITY)).is_err());
    assert!(join(&along_z(), &hollow(), Corner::Round(f64::INFINITY)).is_err());
}

#[test]
fn a_move_may_be_used_up_but_not_more() {
    let joined = join(&along_z(), &up_x(), Corner::Round(10.0)).unwrap();
    assert_eq!(joined.second, line(at(20.0, -20.0), at(20.0, -20.0)));
    let fault = check_fault(along_z(), up_x(), Corner::Round(10.001), Some("PS0051"));
    let CornerError::TooLong { side: Side::Second, needed, available } = fault else { panic!("{fault:?}") };
    assert!((needed - 10.001).abs() < 1e-9 && (available - 10.0).abs() < 1e-9);
    let short = straight((10.0, -18.0), (10.0, -20.0));
    assert!(join(&short, &up_x(), Corner::Chamfer(2.0)).is_ok());
    check_fault(short, up_x(), Corner::Chamfer(2.001), Some("PS0055"));
    let nothing = straight((10.0, -20.0), (10.0, -20.0));
    check_fault(nothing, up_x(), Corner::Chamfer(2.0), Some("PS0055"));
    check_fault(along_z(), nothing, Corner::Chamfer(2.0), Some("PS0051"));
}

#[test]
fn a_used_up_arc_is_not_read_as_a_full_circle() {
    // 5 is the largest radius between the line and the hollow: it touches at the end of the quarter circle.
    let joined = join(&along_z(), &hollow(), Corner::Round(5.0)).unwrap();
    assert_eq!(joined.second, line(at(0.0, -10.0), at(0.0, -10.0)));
    // A chamfer from end to end, minus less than the tolerance between two points.
    let reach = 10.0 * 2_f64.sqrt();
    let joined = join(&along_z(), &hollow(), Corner::Chamfer(reach - 0.5 * SAME)).unwrap();
    assert_eq!(joined.second, line(at(0.0, -10.0), at(0.0, -10.0)));
    let fault = check_fault(along_z(), hollow(), Corner::Round(5.001), Some("PS0055"));
    assert_eq!(fault, CornerError::NoFit { radius: 5.001 });
    // Larger than the arc itself.
    check_fault(along_z(), hollow(), Corner::Round(11.0), Some("PS0055"));
}

#[test]
fn the_middle_move_of_two_corners_loses_both_ends() {
    let last = straight((20.0, -20.0), (20.0, -40.0));
    let one = join(&along_z(), &up_x(), Corner::Round(6.0)).unwrap();
    let two = join(&one.second, &last, Corner::Chamfer(4.0)).unwrap();
    same_piece(&two.first, &straight((16.0, -20.0), (16.0, -20.0)));
    check_fault(one.second, last, Corner::Chamfer(4.1), Some("PS0055"));
}

#[test]
fn straight_on_and_straight_back_are_no_corners() {
    for (degrees, corner) in
        [(0.0, false), (0.9, false), (1.1, true), (178.9, true), (179.1, false), (180.0, false)]
    {
        for degrees in [degrees, -degrees] {
            let angle = (180.0_f64 - degrees).to_radians();
            let second = line(at(10.0, -20.0), at(10.0 + 50.0 * angle.sin(), -20.0 + 50.0 * angle.cos()));
            for kind in [Corner::Chamfer(0.1), Corner::Round(0.1)] {
                if corner {
                    assert!(join(&along_z(), &second, kind).is_ok(), "{degrees}");
                } else {
                    check_fault(along_z(), second, kind, Some("PS0051"));
                }
            }
        }
    }
    // A line tangent to an arc.
    let smooth = round((10.0, -20.0), (20.0, -30.0), (20.0, -20.0), Clockwise);
    check_fault(along_z(), smooth, Corner::Round(1.0), Some("PS0051"));
}

#[test]
fn without_comma_letter_and_sign_follow_the_next_move() {
    use Letter::{C, I, K, R};
    let down_x = straight((10.0, -20.0), (5.0, -20.0));
    let on = straight((10.0, -20.0), (10.0, -30.0));
    let taper = straight((10.0, -20.0), (20.0, -30.0));
    let nothing = straight((10.0, -20.0), (10.0, -20.0));
    let from_x = straight((0.0, -20.0), (10.0, -20.0));
    let cases = [
        (along_z(), up_x(), I, 2.0, None),
        (along_z(), up_x(), C, 2.0, None),
        (along_z(), up_x(), R, 2.0, None),
        (along_z(), up_x(), R, 0.0, None),
        (along_z(), up_x(), I, -2.0, Some(CornerError::WrongSign)),
        (along_z(), up_x(), K, 2.0, Some(CornerError::WrongLetter)),
        (along_z(), down_x, C, -2.0, None),
        (along_z(), down_x, C, 2.0, Some(CornerError::WrongSign)),
        (from_x, on, K, -2.0, None),
        (from_x, on, R, -2.0, None),
        (from_x, on, K, 2.0, Some(CornerError::WrongSign)),
        (from_x, on, I, -2.0, Some(CornerError::WrongLetter)),
        (along_z(), on, C, 2.0, Some(CornerError::SecondNotPerpendicular)),
        (along_z(), taper, C, 2.0, Some(CornerError::SecondNotPerpendicular)),
        (along_z(), hollow(), R, -2.0, Some(CornerError::SecondNotPerpendicular)),
        (straight((0.0, -10.0), (10.0, -20.0)), on, C, 2.0, Some(CornerError::FirstNotAlongAxis)),
        (nothing, up_x(), C, 2.0, Some(CornerError::FirstNotAlongAxis)),
        (
            along_z(),
            nothing,
            C,
            2.0,
            Some(CornerError::TooLong { side: Side::Second, needed: 2.0, available: 0.0 }),
        ),
    ];
    for (first, second, letter, value, fault) in cases {
        let found = check_signed(&first, &second, letter, value).err();
        assert_eq!(found, fault, "{letter:?}{value} {first:?} {second:?}");
    }
    assert_eq!(CornerError::WrongLetter.alarm(), Some("PS0306"));
    assert_eq!(CornerError::WrongSign.alarm(), Some("PS0051"));
    assert_eq!(CornerError::SecondNotPerpendicular.alarm(), Some("PS0052"));
    assert_eq!(CornerError::FirstNotAlongAxis.alarm(), Some("PS0054"));
}

#[track_caller]
fn check_point(found: Result<Point, CornerError>, x: f64, z: f64) {
    let found = found.unwrap();
    assert!(found.distance(at(x, z)) < BY_HAND, "{found:?}");
}

#[test]
fn an_angle_takes_the_place_of_one_coordinate() {
    for half_turn in [0.0, 180.0, -180.0] {
        let angle = |degrees: f64| (degrees + half_turn).to_radians();
        check_point(end_by_angle(at(15.0, 0.0), angle(150.0), Some(20.0), None), 20.0, -8.660254);
        check_point(end_by_angle(at(15.0, 0.0), angle(135.0), None, Some(-10.0)), 25.0, -10.0);
        check_point(end_by_angle(at(15.0, -3.0), angle(90.0), Some(20.0), None), 20.0, -3.0);
        check_point(end_by_angle(at(15.0, -3.0), angle(0.0), None, Some(-9.0)), 15.0, -9.0);
    }
}

#[test]
fn an_angle_near_the_open_axis_has_no_solution() {
    for axis in [0.0_f64, 180.0, 360.0] {
        for (off, solved) in [(-1.1, true), (-0.9, false), (0.0, false), (0.9, false), (1.1, true)] {
            let (along_z, along_x) = ((axis + off).to_radians(), (axis + 90.0 + off).to_radians());
            let by_x = end_by_angle(at(10.0, 0.0), along_z, Some(20.0), None);
            let by_z = end_by_angle(at(10.0, 0.0), along_x, None, Some(-20.0));
            let met = meet(at(10.0, 0.0), 0.5, at(20.0, -20.0), 0.5 + along_z);
            for found in [by_x, by_z, met] {
                assert_eq!(found.is_ok(), solved, "{axis} {off} {found:?}");
                assert!(solved || found.unwrap_err().alarm() == Some("PS0057"));
            }
        }
    }
    assert!(end_by_angle(at(10.0, 0.0), f64::NAN, Some(20.0), None).is_err());
}

#[test]
fn an_end_point_beside_an_angle_must_agree_with_it() {
    let end = |degrees: f64| end_by_angle(at(10.0, 0.0), degrees.to_radians(), Some(20.0), Some(-10.0));
    check_point(end(135.0), 20.0, -10.0);
    check_point(end(-44.1), 20.0, -10.0);
    let actual = 135_f64.to_radians();
    assert_eq!(end(-43.9), Err(CornerError::AngleDisagrees { actual }));
    assert_eq!(CornerError::AngleDisagrees { actual }.alarm(), None);
    assert_eq!(end_by_angle(at(10.0, 0.0), 1.0, None, None).unwrap_err().alarm(), Some("PS0058"));
}

#[test]
fn two_angles_meet_in_the_corner_between_the_blocks() {
    let angle = |degrees: f64| Some(degrees.to_radians());
    for first in [180.0_f64, 0.0] {
        for second in [150.0, -30.0] {
            let found =
                after_angle(at(10.0, 0.0), first.to_radians(), Some(20.0), Some(-30.0), angle(second));
            check_point(found, 10.0, -12.679492);
        }
    }
    let start = at(10.0, 0.0);
    let alarm = |x, z, angle| after_angle(start, 1.0, x, z, angle).unwrap_err().alarm();
    assert_eq!(alarm(Some(20.0), None, angle(150.0)), Some("PS0058"));
    assert_eq!(alarm(None, Some(-30.0), angle(150.0)), Some("PS0058"));
    assert_eq!(alarm(None, None, angle(150.0)), Some("PS0056"));
    assert_eq!(alarm(Some(20.0), Some(-30.0), None), Some("PS0056"));
    assert_eq!(alarm(None, None, None), Some("PS0056"));
}

#[cfg(not(target_arch = "wasm32"))]
mod properties {
    use super::*;
    use crate::control::corners::join::join;
    use proptest::prelude::*;

    fn towards(angle: f64, distance: f64) -> (f64, f64) {
        (distance * angle.sin(), distance * angle.cos())
    }

    /// A piece that begins at a point: a line, or an arc of up to nearly a full circle.
    fn leaving(corner: Point) -> impl Strategy<Value = Piece> {
        let turn = prop_oneof![Just(None), Just(Some(Clockwise)), Just(Some(Counterclockwise))];
        (turn, 0.0..std::f64::consts::TAU, 0.5..40.0, 0.05..6.2_f64).prop_map(
            move |(turn, angle, size, sweep)| {
                let (x, z) = towards(angle, size);
                let middle = at(corner.x + x, corner.z + z);
                let Some(turn) = turn else { return line(corner, middle) };
                let swept = if turn == Counterclockwise { sweep } else { -sweep };
                let (x, z) = towards(angle + std::f64::consts::PI + swept, size);
                arc(corner, at(middle.x + x, middle.z + z), middle, turn)
            },
        )
    }

    fn reversed(piece: Piece) -> Piece {
        let arc = piece.arc.map(|(center, turn)| (center, other(turn)));
        Piece { from: piece.to, to: piece.from, arc }
    }

    fn mirrored(piece: Piece) -> Piece {
        let over = |point: Point| at(-point.x, point.z);
        let arc = piece.arc.map(|(center, turn)| (over(center), other(turn)));
        Piece { from: over(piece.from), to: over(piece.to), arc }
    }

    fn other(turn: Turn) -> Turn {
        match turn {
            Clockwise => Counterclockwise,
            Counterclockwise => Clockwise,
        }
    }

    fn corners() -> impl Strategy<Value = (Piece, Piece, f64)> {
        (0.0..60.0, -80.0..10.0).prop_flat_map(|(x, z)| {
            let corner = at(x, z);
            (leaving(corner).prop_map(reversed), leaving(corner), 0.1..15.0)
        })
    }

    /// Direction of a piece at one of its points, radians.
    fn heading(piece: &Piece, point: Point) -> f64 {
        match piece.arc {
            None => (piece.to.x - piece.from.x).atan2(piece.to.z - piece.from.z),
            Some((center, turn)) => {
                let quarter = std::f64::consts::FRAC_PI_2;
                let outwards = (point.x - center.x).atan2(point.z - center.z);
                outwards + if turn == Counterclockwise { quarter } else { -quarter }
            }
        }
    }

    fn same_heading(one: f64, other: f64) -> bool {
        let off = (one - other).rem_euclid(std::f64::consts::TAU);
        off.min(std::f64::consts::TAU - off) < 1e-9
    }

    fn length(piece: &Piece) -> f64 {
        match piece.arc {
            None => piece.from.distance(piece.to),
            Some((center, turn)) => Arc { start: piece.from, end: piece.to, center, turn }.length(),
        }
    }

    /// Whether two pieces are equal apart from rounding; an arc by its centre and direction of rotation.
    fn alike(one: &Piece, other: &Piece) -> bool {
        let near = |a: Point, b: Point| a.distance(b) < 1e-7;
        let arcs = match (one.arc, other.arc) {
            (None, None) => true,
            (Some((center, turn)), Some((other, other_turn))) => near(center, other) && turn == other_turn,
            (None, Some(_)) | (Some(_), None) => false,
        };
        near(one.from, other.from) && near(one.to, other.to) && arcs
    }

    fn all_alike(found: &Joined, expected: [Piece; 3]) -> bool {
        let inserted = found.inserted.unwrap();
        alike(&found.first, &expected[0])
            && alike(&inserted, &expected[1])
            && alike(&found.second, &expected[2])
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4000))]

        #[test]
        fn a_rounding_touches_both_moves((first, second, radius) in corners()) {
            if let Ok(Joined { first: before, inserted: Some(arc), second: after }) =
                join(&first, &second, Corner::Round(radius))
            {
                let (center, _) = arc.arc.unwrap();
                prop_assert!((center.distance(arc.from) - radius).abs() < 1e-9);
                prop_assert!((center.distance(arc.to) - radius).abs() < 1e-9);
                prop_assert!(before.to == arc.from && arc.to == after.from);
                prop_assert!(same_heading(heading(&first, arc.from), heading(&arc, arc.from)));
                prop_assert!(same_heading(heading(&arc, arc.to), heading(&second, arc.to)));
                prop_assert!(length(&before) < length(&first) && length(&after) < length(&second));
            }
        }

        #[test]
        fn a_small_rounding_always_fits((first, second, _) in corners()) {
            let radius = 1e-5;
            match join(&first, &second, Corner::Round(radius)) {
                Ok(joined) => {
                    let cut = length(&first) - length(&joined.first);
                    prop_assert!(cut < 200.0 * radius, "cut {cut}");
                }
                Err(fault) => prop_assert!(matches!(fault, CornerError::NoCorner { .. }), "{fault:?}"),
            }
        }

        #[test]
        fn a_chamfer_ends_at_its_distance_from_the_corner((first, second, distance) in corners()) {
            if let Ok(joined) = join(&first, &second, Corner::Chamfer(distance)) {
                let chamfer = joined.inserted.unwrap();
                prop_assert!((chamfer.from.distance(first.to) - distance).abs() < 1e-9);
                prop_assert!((chamfer.to.distance(first.to) - distance).abs() < 1e-9);
                prop_assert!(joined.first.to == chamfer.from && chamfer.to == joined.second.from);
                prop_assert!(length(&joined.first) < length(&first) && length(&joined.second) < length(&second));
            }
        }

        #[test]
        fn mirrored_or_reversed_moves_are_joined_alike((first, second, value) in corners()) {
            for corner in [Corner::Chamfer(value), Corner::Round(value)] {
                let mirror = join(&mirrored(first), &mirrored(second), corner);
                let back = join(&reversed(second), &reversed(first), corner);
                let Ok(Joined { first: before, inserted: Some(middle), second: after }) =
                    join(&first, &second, corner)
                else {
                    prop_assert!(mirror.is_err() && back.is_err());
                    continue;
                };
                prop_assert!(all_alike(&mirror.unwrap(), [before, middle, after].map(mirrored)));
                prop_assert!(all_alike(&back.unwrap(), [after, middle, before].map(reversed)));
            }
        }

        #[test]
        fn lines_meet_on_both_lines(
            (x, z, to_x, to_z) in (0.0..60.0, -80.0..10.0, 0.0..60.0, -80.0..10.0),
            (first, second) in (-4.0..4.0, -4.0..4.0),
        ) {
            if let Ok(corner) = meet(at(x, z), first, at(to_x, to_z), second) {
                let off = |point: Point, angle: f64| {
                    (corner.x - point.x) * angle.cos() - (corner.z - point.z) * angle.sin()
                };
                prop_assert!(off(at(x, z), first).abs() < 1e-9 && off(at(to_x, to_z), second).abs() < 1e-9);
                let by_x = end_by_angle(at(x, z), first, Some(corner.x), None);
                prop_assert!(by_x.is_err() || by_x.unwrap().distance(corner) < 1e-6);
            }
        }
    }
}
