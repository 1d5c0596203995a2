//! Complaints of users of other viewers and controls, one per test. Each cites the project and the number of
//! its thread.
use std::time::{Duration, Instant};

use gcode_playground::analyze;
use gcode_playground::geometry::Point;
use gcode_playground::motion::{Cycle, Motion, MotionKind, Step};
use gcode_playground::run::Analysis;
use gcode_playground::scene::Scene;
use gcode_playground::scene::path_index::PathIndex;
use gcode_playground::scene::svg::{SvgOptions, svg};
use gcode_playground::setup::Setup;

/// The head of every program: spindle on, feed per revolution, first tool.
const HEAD: &str = "M3 S500\nG99 F0.2\nT0101\n";

/// Runs a program and checks that it ends within a second.
#[track_caller]
fn run_with(setup: &str, program: &str) -> Analysis {
    let setup = Setup::from_json(setup).expect("setup");
    let begun = Instant::now();
    let analysis = analyze(format!("{HEAD}{program}\nM30\n").as_bytes(), &setup);
    let took = begun.elapsed();
    assert!(took < Duration::from_secs(1), "{took:?}\n{program}");
    analysis
}

/// The same for programs without errors and warnings.
#[track_caller]
fn motions_with(setup: &str, program: &str) -> Vec<Motion> {
    let analysis = run_with(setup, program);
    assert_eq!(codes(&analysis), Vec::<&str>::new(), "\n{program}");
    analysis.motions.iter().collect()
}

#[track_caller]
fn motions(program: &str) -> Vec<Motion> {
    motions_with("{}", program)
}

fn codes(analysis: &Analysis) -> Vec<&'static str> {
    analysis.diagnostics.iter().map(|found| found.message.code()).collect()
}

/// The end of the first motion that belongs to a step.
#[track_caller]
fn first(motions: &[Motion], step: Step) -> Point {
    let of_step = |motion: &&Motion| motion.cycle.is_some_and(|cycle| cycle.step == step);
    motions.iter().find(of_step).expect("such a step").to
}

#[track_caller]
fn assert_near(found: f64, expected: f64, what: &str) {
    assert!((found - expected).abs() < 1e-6, "{what}: {found} instead of {expected}");
}

// linuxcnc#2948: cycle R word ignores diameter mode.

/// R is a radius: the cut begins at a diameter 2·R away from its end, at any diameter and with any notation
/// of X.
#[test]
fn linuxcnc_2948_r_of_g90_and_g92_is_a_radius_whatever_x_is() {
    for end in [20.0, 50.0, 200.0] {
        let start = end + 40.0;
        for x in [format!("X{end}"), "U-40".to_owned()] {
            for cycle in ["G90", "G92"] {
                let program = format!("G0 X{start} Z2\n{cycle} {x} Z-30 R-5 F1.5");
                let infeed = first(&motions(&program), Step::Infeed);
                assert_near(2.0 * infeed.x, end - 10.0, &program);
                // A second pass keeps the taper.
                let program = format!("{program}\nX{}", end - 1.0);
                let second = motions(&program).into_iter().rfind(|motion| {
                    motion.cycle.is_some_and(|cycle| cycle.step == Step::Infeed && cycle.pass == 2)
                });
                assert_near(2.0 * second.expect("a second pass").to.x, end - 11.0, &program);
            }
        }
    }
}

/// R of G94 is a length along Z: neither doubled nor halved.
#[test]
fn linuxcnc_2948_r_of_g94_is_a_length_along_z() {
    for (x, start) in [(20.0, 60.0), (100.0, 140.0)] {
        let program = format!("G0 X{start} Z2\nG94 X{x} Z-10 R-4");
        let motions = motions(&program);
        assert_near(first(&motions, Step::Infeed).z, -14.0, &program);
        let cut = first(&motions, Step::Cut);
        assert_near(cut.z, -10.0, &program);
        assert_near(2.0 * cut.x, x, &program);
    }
}

#[test]
fn linuxcnc_2948_r_of_g76_is_a_radius_whatever_x_is() {
    for end in [20.0, 50.0, 200.0] {
        let start = end + 20.0;
        for x in [format!("X{end}"), "U-20".to_owned()] {
            let program = format!("G0 X{start} Z5\nG76 P010000 Q50 R0.05\nG76 {x} Z-30 R-2 P1300 Q400 F2");
            // With an angle of 0 the infeed is along X, so the last pass begins at the Z of the start point.
            let motions = motions(&program);
            let last = motions.iter().rfind(|motion| {
                motion
                    .cycle
                    .is_some_and(|cycle| cycle.cycle == Cycle::MultiThreading && cycle.step == Step::Infeed)
            });
            let begin = last.expect("an infeed").to;
            assert_near(2.0 * begin.x, end - 4.0, &program);
            assert_near(begin.z, 5.0, &program);
        }
    }
}

// linuxcnc#1146, linuxcnc PR#1869 and PR#2907: G71 never ends or uses all memory.

#[test]
fn linuxcnc_1146_no_g71_runs_for_ever() {
    let good = "N1 G0 X20\nG1 Z-20\nN2 X60 Z-30";
    let cycle = |contour: &str| format!("G71 U2 R0.5\nG71 P1 Q2 U0.4 W0.1\n{contour}");
    let depth = |words: &str| format!("G71 {words}\nG71 P1 Q2 U0.4 W0.1\n{good}");
    for (program, code) in [
        (depth("U0.001 R0.5").replace("X20", "X-900"), "E-TOO-MANY-PASSES"),
        (depth("U0.0001 R0.5"), "E-G71-U-SIGN"),
        (depth("U0 R0.5"), "E-G71-U-SIGN"),
        (depth("U-2 R0.5"), "E-G71-U-SIGN"),
        (depth("R0.5"), "E-G71-U-ROLE"),
        // The contour reverses, in Z and in both axes.
        (cycle("N1 G0 X20\nG1 Z-20\nZ-10\nN2 X60 Z-30"), "E-NOT-MONOTONE"),
        (cycle("N1 G0 X20\nG1 Z-20\nX40\nX20\nN2 Z2"), "E-NOT-MONOTONE"),
        (cycle("N1 G0 X20\nG1 Z-20\nX30\nX20\nX30\nN2 X20"), "E-NOT-MONOTONE"),
        // A contour without length.
        (cycle("N1 G0 X60\nN2 X60"), "PS0322"),
        (cycle("N1 G0 X20\nN2 X20"), "PS0322"),
        (cycle("N1 G0 X70\nN2 G1 Z-20"), "W-ALLOWANCE-SIGN"),
        // Arcs almost closed, closed, and without size.
        (cycle("N1 G0 X20\nG1 Z-20\nG3 X20.002 Z-20.001 I5 K0\nN2 G1 X60 Z-30"), "E-NOT-MONOTONE"),
        (cycle("N1 G0 X20\nG1 Z-20\nG2 I5 K0\nN2 G1 X60 Z-30"), "E-NOT-MONOTONE"),
        (cycle("N1 G0 X20\nG1 Z-20\nG2 X20 Z-20 R0\nN2 G1 X60 Z-30"), "W-ARC-NOWHERE"),
        (cycle("N1 G0 X20\nG1 Z-20\nG3 X60 Z-30 R-25\nN2 G1 Z-31"), "E-NOT-MONOTONE"),
        // P and Q.
        ("N1 G71 P1 Q1".to_owned(), "PS0325"),
        ("N1 G71 P2 Q2\nN2 G71 P1 Q1".to_owned(), "PS0325"),
        ("G71 U2 R0.5\nN1 G71 P2 Q1\nN2 G71 P1 Q2".to_owned(), "PS0325"),
        (format!("G71 U2 R0.5\nG71 P2 Q1\n{good}"), "E-NS-NOT-FOUND"),
        (format!("G71 U2 R0.5\nG71 P1\n{good}"), "PS0061"),
        (format!("G71 U2 R0.5\nG71 P99999999 Q99999999\n{good}"), "E-NS-NOT-FOUND"),
        (format!("G71 U2 R0.5\nG71 P1 Q99999999\n{good}"), "E-NS-NOT-FOUND"),
        (format!("{good}\nG71 U2 R0.5\nG71 P1 Q2"), "E-NOT-MONOTONE"),
        // Another cycle, a call and an end of program within the contour.
        (cycle("N1 G0 X20\nG71 P1 Q2 U0.4\nN2 G1 X60 Z-30"), "PS0325"),
        (cycle("N1 G0 X20\nG70 P1 Q2\nN2 G1 X60 Z-30"), "PS0325"),
        (cycle("N1 G0 X20\nM98 P1\nN2 G1 X60 Z-30"), "E-SUB-IN-CONTOUR"),
        (cycle("N1 G0 X20\nM30\nN2 G1 X60 Z-30"), "PS0325"),
        (cycle("N1 G0 X20\nO2\nN2 G1 X60 Z-30"), "E-NS-NOT-FOUND"),
    ] {
        let strict = r#"{"dialect": {"strict": true}}"#;
        let analysis = run_with(strict, &format!("G0 X60 Z2\n{program}"));
        let found = codes(&analysis);
        assert!(found.contains(&code), "{found:?} instead of {code}\n{program}");
        assert!(analysis.motions.len() < 100, "{}\n{program}", analysis.motions.len());
        if !code.starts_with('W') {
            let is_certain = |motion: Motion| motion.cycle.is_some() && !motion.process.uncertain;
            assert!(!analysis.motions.iter().any(is_certain), "{program}");
        }
    }
    // One fault, one message.
    assert_eq!(codes(&run_with("{}", "N1 G71 P1 Q1")), ["PS0325"]);
    // The shorter arc is as short as it looks.
    let short =
        motions(&format!("G0 X60 Z2\n{}", cycle("N1 G0 X20\nG1 Z-20\nG3 X20.002 Z-20 R5\nN2 G1 X60 Z-30")));
    assert!(
        short.len() > 40 && short.iter().all(|motion| motion.arc().is_none_or(|arc| arc.length() < 0.01))
    );
}

// linuxcnc#2939: G71 stock allowance adds a bogus half circle.

/// A ball, a neck and a fillet, as the contour from P to Q.
const ROUND: &str = "N1 G0 X0\nG1 Z0\nG3 X22 Z-11 R11\nG1 Z-30\nG2 X32 Z-35 R5\nN2 G1 X50";

/// Every arc is one of the contour, with the same radius, shifted by the allowance.
#[test]
fn linuxcnc_2939_an_allowance_adds_no_half_circle() {
    let contour = [(11.0, Point::new(0.0, -11.0)), (5.0, Point::new(16.0, -30.0))];
    for (u, w) in [(0.0, 0.0), (0.4, 0.0), (0.0, 0.1), (0.4, 0.1), (3.0, 1.0), (0.002, 0.001)] {
        for (cycle, passes) in [("G71 U2 R0.5\nG71", 1), ("G73 U6 W0 R4\nG73", 4)] {
            let motions = motions(&format!("G0 X50 Z2\n{cycle} P1 Q2 U{u} W{w}\n{ROUND}"));
            let arcs: Vec<_> = motions.iter().filter_map(Motion::arc).collect();
            assert_eq!(arcs.len(), 2 * passes, "{cycle} U{u} W{w}");
            for (index, arc) in arcs.iter().enumerate() {
                let (radius, center) = contour[index % 2];
                assert_near(arc.radius(), radius, "radius");
                assert_near(arc.end.distance(arc.center), radius, "radius at the end");
                assert!(arc.sweep().abs() < 1.6, "{arc:?}: more than a quarter");
                if index + 2 >= arcs.len() {
                    let moved = Point::new(center.x + u / 2.0, center.z + w);
                    assert!(arc.center.is_same(moved), "{:?} instead of {moved:?}", arc.center);
                }
            }
        }
    }
}

// linuxcnc#707: G72 draws nothing for Z-40 but works for Z-39.999.

#[test]
fn linuxcnc_707_g72_to_z_40_is_as_good_as_to_z_39_999() {
    let cuts = |far: f64| -> Vec<Point> {
        let program =
            format!("G0 X60 Z2\nG72 W2 R0.5\nG72 P1 Q2 U0 W0\nN1 G0 Z{far}\nG1 X40\nZ-20\nX20\nN2 Z2");
        let cut = |motion: &Motion| {
            motion.cycle.is_some_and(|cycle| matches!(cycle.step, Step::Cut | Step::Contour))
        };
        motions(&program).into_iter().filter(cut).map(|motion| motion.to).collect()
    };
    let (round, beside) = (cuts(-40.0), cuts(-39.999));
    assert_eq!(round.len(), beside.len());
    assert!(round.len() > 20);
    for (round, beside) in round.iter().zip(&beside) {
        assert!(round.distance(*beside) < 0.0011, "{round:?} {beside:?}");
    }
}

// linuxcnc#1120: G70 return move digs into the part. linuxcnc#1785: G42 with G70 goes through the profile.

/// Closely spaced points along the side of a polygon.
fn side(from: (f64, f64), to: (f64, f64)) -> impl Iterator<Item = (f64, f64)> {
    let mix = move |a: f64, b: f64, t: f64| a + t * (b - a);
    (0..=1000).map(move |n| f64::from(n) / 1000.0).map(move |t| (mix(from.0, to.0, t), mix(from.1, to.1, t)))
}

/// The part that both programs turn, as points (Z, radius): shank, cone, fillet, shoulder.
fn profile() -> Vec<(f64, f64)> {
    let mut points: Vec<(f64, f64)> = side((0.0, 10.0), (-20.0, 10.0)).collect();
    points.extend(side((-20.0, 10.0), (-30.0, 15.0)));
    points.extend(side((-30.0, 15.0), (-40.0, 15.0)));
    // The fillet turns around (-40, 20).
    points.extend(
        (0..=1000)
            .map(|n| f64::from(n) / 1000.0 * std::f64::consts::FRAC_PI_2)
            .map(|turn| (-40.0 - 5.0 * turn.sin(), 20.0 - 5.0 * turn.cos())),
    );
    points.extend(side((-45.0, 20.0), (-45.0, 30.0)));
    points
}

/// Radius of the part at a Z; zero in front of its face.
fn radius_at(z: f64) -> f64 {
    match z {
        z if z > 0.0 => 0.0,
        z if z >= -20.0 => 10.0,
        z if z >= -30.0 => 10.0 + 0.5 * (-20.0 - z),
        z if z >= -40.0 => 15.0,
        z if z >= -45.0 - 1e-9 => 20.0 - (25.0 - (z + 40.0).powi(2)).max(0.0).sqrt(),
        _ => 30.0,
    }
}

/// Positions of the tip along a motion.
fn places(motion: &Motion) -> impl Iterator<Item = Point> {
    let (motion, steps) = (*motion, 400);
    (0..=steps).map(move |n| f64::from(n) / f64::from(steps)).map(move |t| match motion.arc() {
        Some(arc) => arc.at(t),
        None => Point::new(
            motion.from.x + t * (motion.to.x - motion.from.x),
            motion.from.z + t * (motion.to.z - motion.from.z),
        ),
    })
}

/// The contour of the part as blocks, with an extra word in the first one.
fn part(word: &str) -> String {
    format!("N1 {word} G0 X20\nG1 Z-20\nX30 Z-30\nZ-40\nG2 X40 Z-45 R5\nN2 G1 X60")
}

#[test]
fn linuxcnc_1120_the_return_of_g70_does_not_dig_into_the_part() {
    let program = format!("G0 X60 Z2\nG71 U2 R0.5\nG71 P1 Q2 U0.4 W0.1\n{}\nG70 P1 Q2", part(""));
    let motions = motions(&program);
    let last = motions.last().expect("motions");
    assert_eq!(last.cycle.map(|cycle| (cycle.cycle, cycle.step)), Some((Cycle::Finishing, Step::Return)));
    assert_eq!(last.kind, MotionKind::Rapid);
    assert!(last.to.is_same(Point::new(30.0, 2.0)));
    for motion in &motions {
        for tip in places(motion) {
            assert!(tip.x >= radius_at(tip.z) - 1e-6, "{motion:?} digs in at {tip:?}");
        }
    }
    // A bore: the same with the part outside.
    let bore = "N1 G0 X40\nG1 Z-20\nX30 Z-30\nN2 X20";
    let program = format!("G0 X20 Z2\nG71 U2 R0.5\nG71 P1 Q2 U-0.4 W0.1\n{bore}\nG70 P1 Q2");
    for motion in self::motions(&program).iter().filter(|motion| motion.cycle.is_some()) {
        for tip in places(motion) {
            let bore = if tip.z >= -20.0 { 20.0 } else { 20.0 + 0.5 * (tip.z + 20.0) };
            let bore = if tip.z >= -30.0 { bore } else { 0.0 };
            assert!(tip.x <= bore.max(10.0) + 1e-6, "{motion:?} digs in at {tip:?}");
        }
    }
}

#[test]
fn linuxcnc_1785_g42_with_g70_stays_outside_the_profile() {
    const NOSE: f64 = 0.8;
    let setup = r#"{"tools": {"T0101": {"noseRadius": 0.8, "tip": 3}},
                    "rules": {"compensation-left-on": "off"}}"#;
    let program = format!("G0 X60 Z5\nG71 U2 R0.5\nG71 P1 Q2 U0.4 W0.1\n{}\nG70 P1 Q2", part("G42"));
    let motions = motions_with(setup, &program);
    let finishing: Vec<&Motion> = motions
        .iter()
        .filter(|motion| motion.cycle.is_some_and(|cycle| cycle.cycle == Cycle::Finishing))
        .collect();
    assert!(finishing.len() >= 7, "{}", finishing.len());
    let profile = profile();
    for motion in finishing {
        let cuts = motion.cycle.is_some_and(|cycle| cycle.step == Step::Contour);
        for tip in places(motion) {
            // The nose centre of tip 3 is a radius out and a radius to the right of the programmed point.
            let (z, x) = (tip.z + NOSE, tip.x + NOSE);
            let apart = profile.iter().map(|place| (z - place.0).hypot(x - place.1)).fold(f64::MAX, f64::min);
            assert!(x > radius_at(z), "{motion:?} is inside at {tip:?}");
            assert!(apart >= NOSE - 0.001, "{motion:?} cuts {} mm too deep at {tip:?}", NOSE - apart);
            // At the outer corner after the cone the offset lines meet slightly farther out.
            let at_corner = (z + 30.0).hypot(x - 15.0) < 1.04 * NOSE;
            if cuts && z < 0.0 && !at_corner {
                assert!(apart <= NOSE + 0.001, "{motion:?} leaves {} mm at {tip:?}", apart - NOSE);
            }
        }
    }
}

// TinyG#120, bCNC#241, webgcode#19: G18 arcs in the wrong direction. Candle#9: arcs drawn as straight lines.

/// Signed area that a motion sweeps around its centre, in the picture of a rear turret (Z to the right, X
/// up): positive for counter-clockwise.
fn swept(motion: &Motion) -> f64 {
    let center = motion.center.expect("a centre");
    let places: Vec<Point> = places(motion).collect();
    let cross =
        |a: Point, b: Point| (a.z - center.z) * (b.x - center.x) - (a.x - center.x) * (b.z - center.z);
    places.windows(2).map(|pair| cross(pair[0], pair[1]) / 2.0).sum()
}

#[test]
fn tinyg_120_g2_turns_clockwise_with_z_to_the_right_and_x_up() {
    for (code, sign) in [("G2", -1.0), ("G02", -1.0), ("G3", 1.0), ("G03", 1.0)] {
        for plane in ["", "G18 "] {
            for (start, end) in
                [((40, 0), (60, -10)), ((60, -10), (40, 0)), ((60, 0), (40, -10)), ((40, -10), (60, 0))]
            {
                let program =
                    format!("G0 X{} Z{}\n{plane}{code} X{} Z{} R10", start.0, start.1, end.0, end.1);
                let motions = motions(&program);
                let arc = motions.last().expect("an arc");
                let quarter = sign * std::f64::consts::FRAC_PI_4 * 100.0;
                assert!((swept(arc) - quarter).abs() < 0.01, "{program}: {}", swept(arc));
            }
        }
    }
    // The calculated case: G03 outwards and to the left goes around the outside of the corner's centre.
    let motions = motions("G0 X20 Z0\nG3 X40 Z-10 R10");
    assert!(motions[1].center.is_some_and(|center| center.is_same(Point::new(10.0, -10.0))));
}

#[test]
fn candle_9_arcs_are_never_drawn_straight() {
    for (code, flag) in [("G2", '1'), ("G3", '0')] {
        for (x, z, radius) in
            [(60.0, -10.0, 10.0), (40.2, -0.1, 0.1), (40.0, -20.0, 500.0), (44.0, -2.0, 2.0)]
        {
            let program = format!("G0 X40 Z0\n{code} X{x} Z{z} R{radius}");
            let analysis = run_with("{}", &program);
            let path_index = PathIndex::of(&analysis.motions);
            let picture = svg(&Scene::new(&analysis.motions, &path_index, None), &SvgOptions::default());
            // The arc is in the fifth line, after three lines of the head.
            let mark = r#"<path data-line="5" class="feed" d=""#;
            let d = picture.split(mark).nth(1).and_then(|rest| rest.split('"').next()).expect("a path");
            assert!(d.contains('A') && !d.contains(['L', 'H', 'V']), "{program}: {d}");
            for arc in d.split('A').skip(1) {
                let words: Vec<&str> = arc.split_whitespace().collect();
                assert_eq!(words[0], words[1], "{program}: {d}");
                assert!(words[4].starts_with(flag), "{program}: {d}");
            }
        }
    }
}
