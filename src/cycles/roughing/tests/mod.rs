//! Roughing: the worked examples, the quadrants, errors and limits; random contours are in `properties`.

use super::*;
use crate::cycles::listing::{self, at, listing};

#[cfg(not(target_arch = "wasm32"))]
mod properties;

fn line(from: Point, to: Point) -> Piece {
    Piece { from, to, arc: None }
}

/// A contour of lines: A, then B and the other points, as diameter and length.
fn straight(approach: Approach, start: (f64, f64), points: &[(f64, f64)]) -> Contour {
    let points: Vec<Point> = points.iter().map(|&(x, z)| at(x, z)).collect();
    let pieces = points.windows(2).map(|pair| line(pair[0], pair[1])).collect();
    Contour { start: at(start.0, start.1), first: points[0], approach, pieces }
}

/// Roughing parameters, with the allowance as diameter and length.
fn how(direction: Direction, shape: Shape, depth: f64, escape: f64, allowance: (f64, f64)) -> Roughing {
    Roughing {
        direction,
        shape,
        depth,
        escape,
        allowance: at(allowance.0, allowance.1),
        escape_kind: MotionKind::Rapid,
        last_pass: LastPass::Contour,
        checks: Checks::All,
    }
}

fn type_one(direction: Direction, depth: f64, escape: f64, allowance: (f64, f64)) -> Roughing {
    how(direction, Shape::Monotone, depth, escape, allowance)
}

fn type_two(depth: f64, escape: f64) -> Roughing {
    how(Direction::Turning, Shape::Pockets, depth, escape, (0.0, 0.0))
}

fn check(contour: &Contour, how: &Roughing, expected: &str) {
    let moves = rough(contour, how, 1000).expect("the contour can be roughed");
    listing::check(contour.start, &moves, expected);
}

/// An arc with a radius, of at most half a turn.
fn arc(from: Point, to: Point, radius: f64, turn: Turn) -> Piece {
    let chord = from.distance(to);
    let height = (radius * radius - 0.25 * chord * chord).sqrt() / chord;
    let height = if turn == Turn::Counterclockwise { height } else { -height };
    let center = Point::new(
        0.5 * (from.x + to.x) + height * (to.z - from.z),
        0.5 * (from.z + to.z) - height * (to.x - from.x),
    );
    Piece { from, to, arc: Some((center, turn)) }
}

fn ball_nose_and_fillet() -> Contour {
    let points = [
        (0.0, 0.0),
        (11.0, -5.5),
        (11.0, -15.5),
        (17.0, -25.5),
        (17.0, -40.5),
        (29.0, -47.848),
        (29.0, -60.5),
        (41.0, -60.5),
    ];
    let mut contour = straight(Approach::Feed, (41.0, 0.0), &points);
    let points = points.map(|(x, z)| at(x, z));
    contour.pieces[0] = arc(points[0], points[1], 5.5, Turn::Counterclockwise);
    contour.pieces[4] = arc(points[4], points[5], 7.5, Turn::Clockwise);
    contour
}

#[test]
fn g71_turns_a_ball_nose_a_cone_and_a_fillet() {
    check(
        &ball_nose_and_fillet(),
        &type_one(Direction::Turning, 2.0, 1.0, (0.5, 0.2)),
        "#0 R(41.5,0.2)
        #1 F(37.5,0.2) F(37.5,-60.3) R(39.5,-59.3) R(39.5,0.2)
        #2 F(33.5,0.2) F(33.5,-60.3) R(35.5,-59.3) R(35.5,0.2)
        #3 F(29.5,0.2) F(29.5,-60.3) R(31.5,-59.3) R(31.5,0.2)
        #4 F(25.5,0.2) F(25.5,-46.9328) R(27.5,-45.9328) R(27.5,0.2)
        #5 F(21.5,0.2) F(21.5,-45.3986) R(23.5,-44.3986) R(23.5,0.2)
        #6 F(17.5,0.2) F(17.5,-40.3) R(19.5,-39.3) R(19.5,0.2)
        #7 F(13.5,0.2) F(13.5,-18.6333) R(15.5,-17.6333) R(15.5,0.2)
        #8 F(9.5,0.2) F(9.5,-2.1377) R(11.5,-1.1377) R(11.5,0.2)
        #9 F(5.5,0.2) F(5.5,-0.401) R(7.5,0.599) R(7.5,0.2)
        #10 F(1.5,0.2) F(1.5,0.1772) R(3.5,1.1772) R(3.5,0.2)
        #0 F(0.5,0.2) A+(11.5,-5.3) c(0.5,-5.3) r5.5 F(11.5,-15.3) F(17.5,-25.3) F(17.5,-40.3) \
         A-(29.5,-47.648) c(32.5,-40.2995) r7.5 F(29.5,-60.3) F(41.5,-60.3) R(41,0)",
    );
}

#[test]
fn g71_bores() {
    let points = [(40.0, 2.0), (40.0, -10.0), (30.0, -20.0), (30.0, -35.0), (18.0, -35.0)];
    check(
        &straight(Approach::Rapid, (18.0, 2.0), &points),
        &type_one(Direction::Turning, 1.5, 0.5, (-0.4, 0.1)),
        "#0 R(17.6,2.1)
        #1 R(20.6,2.1) F(20.6,-34.9) R(19.6,-34.4) R(19.6,2.1)
        #2 R(23.6,2.1) F(23.6,-34.9) R(22.6,-34.4) R(22.6,2.1)
        #3 R(26.6,2.1) F(26.6,-34.9) R(25.6,-34.4) R(25.6,2.1)
        #4 R(29.6,2.1) F(29.6,-34.9) R(28.6,-34.4) R(28.6,2.1)
        #5 R(32.6,2.1) F(32.6,-16.9) R(31.6,-16.4) R(31.6,2.1)
        #6 R(35.6,2.1) F(35.6,-13.9) R(34.6,-13.4) R(34.6,2.1)
        #7 R(38.6,2.1) F(38.6,-10.9) R(37.6,-10.4) R(37.6,2.1)
        #0 R(39.6,2.1) F(39.6,-9.9) F(29.6,-19.9) F(29.6,-34.9) F(17.6,-34.9) R(18,2)",
    );
}

fn faced() -> Contour {
    let points = [(41.0, -31.0), (20.0, -20.0), (20.0, -2.0), (14.0, 1.0)];
    straight(Approach::Rapid, (41.0, 1.0), &points)
}

#[test]
fn g72_faces_from_the_far_end_back_to_the_face() {
    let moves = rough(&faced(), &type_one(Direction::Facing, 1.0, 1.0, (0.1, 0.2)), 1000).unwrap();
    let listing = listing(faced().start, &moves);
    let lines: Vec<&str> = listing.lines().collect();
    assert_eq!(lines.len(), 33);
    assert_eq!(lines[0], "#0 R(41.1,1.2)");
    assert_eq!(lines[1], "#1 R(41.1,0.2) F(16.1,0.2) R(18.1,1.2) R(41.1,1.2)");
    assert_eq!(lines[2], "#2 R(41.1,-0.8) F(18.1,-0.8) R(20.1,0.2) R(41.1,0.2)");
    for (pass, line) in lines.iter().enumerate().take(22).skip(3) {
        let z = 1.2 - pass as f64;
        let up = z + 1.0;
        let expected = format!("#{pass} R(41.1,{z:.1}) F(20.1,{z:.1}) R(22.1,{up:.1}) R(41.1,{up:.1})");
        assert_eq!(*line, expected);
    }
    assert_eq!(lines[22], "#22 R(41.1,-20.8) F(22.0091,-20.8) R(24.0091,-19.8) R(41.1,-19.8)");
    assert_eq!(lines[31], "#31 R(41.1,-29.8) F(39.1909,-29.8) R(41.1909,-28.8) R(41.1,-28.8)");
    assert_eq!(lines[32], "#0 R(41.1,-30.8) F(20.1,-19.8) F(20.1,-1.8) F(14.1,1.2) R(41,1)");
}

#[test]
fn g72_ends_a_pass_on_an_arc() {
    let points = [(62.0, -20.0), (50.0, -20.0), (38.0, -14.0), (38.0, -8.0), (28.0, -3.0), (28.0, 3.0)];
    let mut contour = straight(Approach::Rapid, (62.0, 3.0), &points);
    contour.pieces[1] = arc(at(50.0, -20.0), at(38.0, -14.0), 6.0, Turn::Counterclockwise);
    check(
        &contour,
        &type_one(Direction::Facing, 2.5, 0.5, (0.4, 0.2)),
        "#0 R(62.4,3.2)
        #1 R(62.4,0.7) F(28.4,0.7) R(29.4,1.2) R(62.4,1.2)
        #2 R(62.4,-1.8) F(28.4,-1.8) R(29.4,-1.3) R(62.4,-1.3)
        #3 R(62.4,-4.3) F(31.4,-4.3) R(32.4,-3.8) R(62.4,-3.8)
        #4 R(62.4,-6.8) F(36.4,-6.8) R(37.4,-6.3) R(62.4,-6.3)
        #5 R(62.4,-9.3) F(38.4,-9.3) R(39.4,-8.8) R(62.4,-8.8)
        #6 R(62.4,-11.8) F(38.4,-11.8) R(39.4,-11.3) R(62.4,-11.3)
        #7 R(62.4,-14.3) F(38.4417,-14.3) R(39.4417,-13.8) R(62.4,-13.8)
        #8 R(62.4,-16.8) F(40.0077,-16.8) R(41.0077,-16.3) R(62.4,-16.3)
        #9 R(62.4,-19.3) F(45.6042,-19.3) R(46.6042,-18.8) R(62.4,-18.8)
        #0 R(62.4,-19.8) F(50.4,-19.8) A+(38.4,-13.8) c(50.4,-13.8) r6 F(38.4,-7.8) F(28.4,-2.8) F(28.4,3.2) \
         R(62,3)",
    );
}

#[test]
fn each_move_says_which_part_it_plays() {
    let moves = rough(&faced(), &type_one(Direction::Facing, 20.0, 1.0, (0.0, 0.0)), 1000).unwrap();
    let parts: Vec<(u32, Step)> = moves.iter().map(|step| (step.pass, step.step)).collect();
    let expected = [
        (0, Step::Approach),
        (1, Step::Infeed),
        (1, Step::Cut),
        (1, Step::Escape),
        (1, Step::Return),
        (0, Step::Infeed),
        (0, Step::Contour),
        (0, Step::Contour),
        (0, Step::Contour),
        (0, Step::Return),
    ];
    assert_eq!(parts, expected);
}

/// LinuxCNC issue 707: Z-40 gave no moves, but Z-39.999 did.
#[test]
fn g72_to_a_round_number_is_as_good_as_to_one_beside_it() {
    for (far, approach) in [(-40.0, Approach::Rapid), (-39.999, Approach::Rapid), (-40.0, Approach::Feed)] {
        let contour = straight(approach, (60.0, 0.0), &[(60.0, far), (20.0, far), (20.0, 0.0)]);
        let moves = rough(&contour, &type_one(Direction::Facing, 2.0, 0.5, (0.0, 0.0)), 1000).unwrap();
        assert_eq!(moves.iter().map(|step| step.pass).max(), Some(19), "{far}");
        let cuts: Vec<Point> =
            moves.iter().filter(|step| step.step == Step::Cut).map(|step| step.to).collect();
        assert!(cuts.iter().enumerate().all(|(n, to)| to.is_same(at(20.0, -2.0 * (n + 1) as f64))));
    }
}

/// LinuxCNC issue 2939: an allowance added half circles between the pieces.
#[test]
fn an_allowance_moves_arcs_and_adds_none() {
    let plain =
        rough(&ball_nose_and_fillet(), &type_one(Direction::Turning, 2.0, 1.0, (0.0, 0.0)), 1000).unwrap();
    let moved =
        rough(&ball_nose_and_fillet(), &type_one(Direction::Turning, 2.0, 1.0, (0.5, 0.2)), 1000).unwrap();
    let arcs = |moves: &[Move]| -> Vec<(MotionKind, Point, Point)> {
        moves.iter().filter_map(|step| Some((step.kind, step.to, step.center?))).collect()
    };
    let (plain, moved) = (arcs(&plain), arcs(&moved));
    assert_eq!(plain.len(), 2);
    assert_eq!(moved.len(), 2);
    for (plain, moved) in plain.iter().zip(&moved) {
        assert_eq!(plain.0, moved.0);
        for (plain, moved) in [(plain.1, moved.1), (plain.2, moved.2)] {
            assert!(moved.is_same(Point::new(plain.x + 0.25, plain.z + 0.2)));
        }
    }
}

#[test]
fn each_pocket_is_cut_to_its_bottom_before_the_next() {
    let points = [
        (30.0, 2.0),
        (30.0, -10.0),
        (20.0, -15.0),
        (20.0, -25.0),
        (30.0, -25.0),
        (20.0, -35.0),
        (40.0, -45.0),
    ];
    check(
        &straight(Approach::Rapid, (40.0, 2.0), &points),
        &type_two(3.0, 0.5),
        "#1 R(34,2) F(34,-42) F(40,-45) R(41,-44.5) R(41,2)
        #2 R(41,-10) R(35,-10) F(30,-10) F(28,-11) F(28,-25) F(30,-25) R(31,-24.5) R(31,-11)
        #3 F(28,-11) F(22,-14) F(22,-25) F(28,-25) R(29,-24.5) R(29,-14)
        #4 R(35,-14) R(35,-25) F(30,-25) F(28,-27) F(28,-39) F(34,-42) R(35,-41.5) R(35,-27)
        #5 F(28,-27) F(22,-33) F(22,-36) F(28,-39) R(29,-38.5) R(29,-33)
        #0 R(40,-33) R(40,2) R(30,2) F(30,-10) F(20,-15) F(20,-25) F(30,-25) F(20,-35) F(40,-45) R(40,2)",
    );
}

#[test]
fn a_pocket_that_opens_at_the_first_point_is_deepened_at_feed() {
    let points = [(46.0, 2.0), (22.0, -10.0), (22.0, -18.0), (36.0, -25.0), (56.0, -25.0)];
    check(
        &straight(Approach::Feed, (56.0, 2.0), &points),
        &how(Direction::Turning, Shape::Pockets, 3.0, 0.5, (0.4, 0.0)),
        "#0 R(56.4,2)
        #1 F(50.4,2) F(50.4,-25) F(56.4,-25) R(57.4,-24.5) R(57.4,2)
        #2 F(46.4,2) F(44.4,1) F(44.4,-25) F(50.4,-25) R(51.4,-24.5) R(51.4,1)
        #3 F(44.4,1) F(38.4,-2) F(38.4,-25) F(44.4,-25) R(45.4,-24.5) R(45.4,-2)
        #4 F(38.4,-2) F(32.4,-5) F(32.4,-23) F(36.4,-25) F(38.4,-25) R(39.4,-24.5) R(39.4,-5)
        #5 F(32.4,-5) F(26.4,-8) F(26.4,-20) F(32.4,-23) R(33.4,-22.5) R(33.4,-8)
        #0 R(56.4,-8) R(56.4,2) F(46.4,2) F(22.4,-10) F(22.4,-18) F(36.4,-25) F(56.4,-25) R(56,2)",
    );
}

/// A groove whose first block goes down a slope: nothing in front of the slope is touched.
#[test]
fn a_first_block_along_the_passes_is_a_wall() {
    let points = [(40.0, -25.0), (40.0, -35.0), (52.0, -41.0)];
    check(
        &straight(Approach::Rapid, (52.0, -20.0), &points),
        &type_two(4.0, 1.0),
        "#1 F(44,-23.3333) F(44,-37) F(52,-41) R(54,-40) R(54,-23.3333)
        #0 R(54,-20) F(40,-25) F(40,-35) F(52,-41) R(52,-20)",
    );
}

#[test]
fn a_contour_that_ends_in_a_pocket_is_left_upwards() {
    let points = [(46.0, 2.0), (46.0, -10.0), (40.0, -10.0), (40.0, -20.0)];
    check(
        &straight(Approach::Rapid, (50.0, 2.0), &points),
        &type_two(2.5, 0.5),
        "#1 R(50,-10) F(46,-10) F(45,-10) F(45,-20) R(46,-19.5) R(46,-10)
        #0 R(50,-10) R(50,2) R(46,2) F(46,-10) F(40,-10) F(40,-20) R(50,-20) R(50,2)",
    );
}

#[test]
fn without_a_last_pass_the_tool_goes_home_over_the_work() {
    let points = [(50.0, 2.0), (50.0, -10.0), (40.0, -10.0), (40.0, -20.0), (50.0, -20.0)];
    let contour = straight(Approach::Rapid, (50.0, 2.0), &points);
    check(
        &contour,
        &Roughing { last_pass: LastPass::Nothing, checks: Checks::All, ..type_two(2.0, 0.5) },
        "#1 R(50,-10) F(46,-10) F(46,-20) F(50,-20) R(51,-19.5) R(51,-10)
        #2 F(46,-10) F(42,-10) F(42,-20) F(46,-20) R(47,-19.5) R(47,-10)
        #0 R(50,-10) R(50,2)",
    );
}

#[track_caller]
fn check_error(contour: &Contour, how: &Roughing, expected: RoughingError) {
    assert_eq!(rough(contour, how, 1000), Err(expected));
}

#[test]
fn a_contour_that_turns_back_is_refused_where_it_does() {
    let turning = type_one(Direction::Turning, 2.0, 0.5, (0.0, 0.0));
    let back_in_x = [(20.0, 2.0), (20.0, -10.0), (30.0, -20.0), (29.0, -25.0), (40.0, -30.0)];
    let contour = straight(Approach::Rapid, (40.0, 2.0), &back_in_x);
    check_error(&contour, &turning, RoughingError::NotMonotoneAcross { piece: 2 });
    assert!(rough(&contour, &type_two(2.0, 0.5), 1000).is_ok());

    let back_in_z = [(20.0, 2.0), (20.0, -10.0), (30.0, -5.0), (40.0, -30.0)];
    let contour = straight(Approach::Rapid, (40.0, 2.0), &back_in_z);
    check_error(&contour, &turning, RoughingError::NotMonotoneAlong { piece: 1 });
    check_error(&contour, &type_two(2.0, 0.5), RoughingError::NotMonotoneAlong { piece: 1 });

    // Facing: X is the axis of the passes, Z the depth axis.
    let facing = type_one(Direction::Facing, 2.0, 0.5, (0.0, 0.0));
    let back_in_z = [(40.0, -30.0), (30.0, -20.0), (30.0, -25.0), (20.0, 2.0)];
    let contour = straight(Approach::Rapid, (40.0, 2.0), &back_in_z);
    check_error(&contour, &facing, RoughingError::NotMonotoneAcross { piece: 1 });

    // A reversal within the rounding of drawings is accepted.
    let hardly = [(20.0, 2.0), (20.0, -10.0), (30.0, -20.0), (29.999, -25.0), (40.0, -25.0)];
    let contour = straight(Approach::Rapid, (40.0, 2.0), &hardly);
    assert!(rough(&contour, &turning, 1000).is_ok());
}

#[test]
fn an_arc_that_bulges_beyond_its_ends_turns_back() {
    let mut contour =
        straight(Approach::Rapid, (40.0, 2.0), &[(20.0, 2.0), (20.0, -10.0), (20.0, -20.0), (40.0, -20.0)]);
    let ends = (at(20.0, -10.0), at(20.0, -20.0));
    let turning = type_one(Direction::Turning, 2.0, 0.5, (0.0, 0.0));
    for turn in [Turn::Clockwise, Turn::Counterclockwise] {
        contour.pieces[1] = arc(ends.0, ends.1, 6.0, turn);
        check_error(&contour, &turning, RoughingError::NotMonotoneAcross { piece: 1 });
        assert!(rough(&contour, &type_two(2.0, 0.5), 1000).is_ok());
    }
    // More than half a turn also reverses in Z.
    let center = Point::new(12.0, -15.0);
    contour.pieces[1].arc = Some((center, Turn::Counterclockwise));
    check_error(&contour, &type_two(2.0, 0.5), RoughingError::NotMonotoneAlong { piece: 1 });
}

#[test]
fn a_contour_beyond_the_start_is_refused() {
    let turning = type_one(Direction::Turning, 2.0, 0.5, (0.0, 0.0));
    let high = [(20.0, 2.0), (20.0, -10.0), (41.0, -10.0), (41.0, -20.0)];
    let contour = straight(Approach::Rapid, (40.0, 2.0), &high);
    check_error(&contour, &turning, RoughingError::BeyondStart { piece: Some(1), along: false });
    let before = [(20.0, 3.0), (20.0, -10.0), (40.0, -10.0)];
    let contour = straight(Approach::Rapid, (40.0, 2.0), &before);
    check_error(&contour, &turning, RoughingError::BeyondStart { piece: None, along: true });
}

#[test]
fn a_contour_without_depth_or_length_leaves_nothing_to_cut() {
    let turning = type_one(Direction::Turning, 2.0, 0.5, (0.0, 0.0));
    let flat = straight(Approach::Rapid, (40.0, 2.0), &[(40.0, 2.0), (40.0, -20.0)]);
    check_error(&flat, &turning, RoughingError::NothingToCut);
    let bare = straight(Approach::Rapid, (40.0, 2.0), &[(20.0, 2.0)]);
    check_error(&bare, &turning, RoughingError::NothingToCut);
}

#[test]
fn a_tiny_depth_is_refused_at_once() {
    let points = [(0.0, 2.0), (0.0, 0.0), (2000.0, -1000.0)];
    let contour = straight(Approach::Rapid, (2000.0, 2.0), &points);
    for depth in [1e-4, 1e-12, 1e-300, 0.0] {
        for shape in [Shape::Monotone, Shape::Pockets] {
            let how = how(Direction::Turning, shape, depth, 0.5, (0.0, 0.0));
            assert_eq!(rough(&contour, &how, 1_000_000), Err(RoughingError::TooManyMoves), "{depth}");
        }
    }
    let fine = type_one(Direction::Turning, 0.01, 0.5, (0.0, 0.0));
    assert!(rough(&contour, &fine, 1_000_000).is_ok());
}

#[test]
fn an_allowance_into_the_work_is_seen_in_every_quadrant() {
    for (depth, along) in [(-1.0, -1.0), (1.0, -1.0), (-1.0, 1.0), (1.0, 1.0)] {
        let points = [(100.0 + depth * 20.0, 0.0), (100.0, along * 30.0)];
        let contour = straight(Approach::Rapid, (100.0, 0.0), &points);
        let turning = |x: f64, z: f64| type_one(Direction::Turning, 2.0, 0.5, (x, z));
        assert_eq!(allowance_into_material(&contour, &turning(-0.4 * depth, -0.1 * along)), []);
        assert_eq!(allowance_into_material(&contour, &turning(0.4 * depth, -0.1 * along)), [Axis::X]);
        assert_eq!(allowance_into_material(&contour, &turning(-0.4 * depth, 0.1 * along)), [Axis::Z]);
    }
    let facing = type_one(Direction::Facing, 2.0, 0.5, (-0.1, 0.2));
    assert_eq!(allowance_into_material(&faced(), &facing), [Axis::X]);
}
