//! Motion times, compared with sums over many small pieces of the path.
use std::f64::consts::{PI, TAU};

use gcode_playground::analyze;
use gcode_playground::geometry::Point;
use gcode_playground::motion::{Feed, Motion, MotionKind, SpindleSpeed, SpindleTurn};
use gcode_playground::playback::timing::{feed_at, seconds, speed_at, surface_speed};
use gcode_playground::playback::totals::totals;
use gcode_playground::setup::{Machine, Setup};

fn run(machine: &str, program: &str) -> (Vec<Motion>, Machine) {
    let setup = format!(
        r#"{{"dialect": {{"threadChamfer": 0}}, "initial": {{"x": 100, "z": 50}}, "machine": {{{machine}}}}}"#
    );
    let setup = Setup::from_json(&setup).expect("a setup");
    let motions = analyze(program.as_bytes(), &setup).motions.iter().collect();
    (motions, setup.machine)
}

/// Spindle speed, rpm, calculated independently.
fn turns_a_minute(motion: &Motion, machine: &Machine, radius: f64) -> f64 {
    let most = machine.max_speed.unwrap_or(f64::INFINITY);
    match motion.process.speed {
        SpindleSpeed::Constant(speed) => speed.min(most),
        SpindleSpeed::Surface { speed } => {
            let clamp = motion.process.clamp.unwrap_or(f64::INFINITY);
            let lowest = motion.process.lowest.unwrap_or(0.0);
            (1000.0 * speed / (PI * 2.0 * radius.abs())).max(lowest).min(most).min(clamp)
        }
    }
}

/// The point at a fraction of the path.
fn place(motion: &Motion, t: f64) -> Point {
    let Motion { from, to, .. } = *motion;
    let Some(center) = motion.center else {
        return Point::new(from.x + t * (to.x - from.x), from.z + t * (to.z - from.z));
    };
    let angle = |point: Point| (point.x - center.x).atan2(point.z - center.z);
    let mut sweep = angle(to) - angle(from);
    match motion.kind {
        MotionKind::ArcCounterclockwise if sweep <= 1e-9 => sweep += TAU,
        MotionKind::ArcClockwise if sweep >= -1e-9 => sweep -= TAU,
        _ => {}
    }
    let (angle, radius) = (angle(from) + t * sweep, from.distance(center));
    Point::new(center.x + radius * angle.sin(), center.z + radius * angle.cos())
}

/// Time of a cut in seconds, summed over small pieces.
fn summed(motion: &Motion, machine: &Machine) -> f64 {
    const PIECES: u32 = 40_000;
    let at = |piece: u32| place(motion, f64::from(piece) / f64::from(PIECES));
    let long = (motion.to.x - motion.from.x).abs().max((motion.to.z - motion.from.z).abs());
    let pieces = (0..PIECES).map(|piece| {
        let (a, b) = (at(piece), at(piece + 1));
        let turns = |radius| turns_a_minute(motion, machine, radius) / 60.0;
        let radius = f64::midpoint(a.x, b.x);
        match (motion.kind, motion.process.feed) {
            // A thread advances one lead along its long axis in each turn.
            (MotionKind::Thread, _) => {
                long / f64::from(PIECES) / (motion.lead.expect("a lead") * turns(radius))
            }
            (_, Feed::PerMinute(feed)) => a.distance(b) / (feed / 60.0),
            (_, Feed::PerTurn(feed)) => a.distance(b) / (feed * turns(radius)),
            (_, Feed::Unset) => panic!("no feed"),
        }
    });
    pieces.sum()
}

/// Checks that all cuts of a program take as long as their pieces. Returns the seconds of the last one.
fn check(machine: &str, program: &str) -> f64 {
    let (motions, machine) = run(machine, program);
    let mut last = None;
    for motion in motions.iter().filter(|motion| motion.kind.cuts()) {
        let (found, expected) = (seconds(motion, &machine).expect(program), summed(motion, &machine));
        let allowed = if motion.center.is_some() { 2e-3 } else { 1e-5 };
        assert!((found - expected).abs() <= allowed * expected, "{program}: {found}, summed {expected}");
        last = Some(found);
    }
    last.expect(program)
}

fn check_seconds(machine: &str, program: &str, expected: f64) {
    let found = check(machine, program);
    assert!((found - expected).abs() < 1e-4 * expected, "{program}: {found}, not {expected}");
}

/// Checks that the time of the last motion is unknown.
fn check_unknown(machine: &str, program: &str) {
    let (motions, machine) = run(machine, program);
    assert_eq!(seconds(motions.last().expect(program), &machine), None, "{program}");
}

#[test]
fn feed_a_minute() {
    // 60 mm at 120 mm/min; over 30 and 40 mm; a quarter of a circle of 10 mm.
    check_seconds("", "G00 X40 Z0\nG98 G01 Z-60 F120", 30.0);
    check_seconds("", "G00 X40 Z0\nG98 G01 X100 Z-40 F100", 30.0);
    check_seconds("", "G00 X40 Z0\nG98 G03 X60 Z-10 R10 F60", 5.0 * PI);
    // It does not need a running spindle.
    check_seconds("", "M05\nG00 X40 Z0\nG98 G01 Z-60 F120", 30.0);
}

#[test]
fn feed_a_turn() {
    // 60 mm / (0.2 mm × 500/min).
    check_seconds("", "G97 S500 M03\nG00 X40 Z0\nG99 G01 Z-60 F0.2", 36.0);
    check_seconds("\"maxSpeed\": 250", "G97 S500 M03\nG00 X40 Z0\nG99 G01 Z-60 F0.2", 72.0);
    // G50 S does not limit G97.
    check_seconds("", "G50 S100\nG97 S500 M03\nG00 X40 Z0\nG99 G01 Z-60 F0.2", 36.0);
    check("", "G97 S500 M04\nG00 X40 Z0\nG99 G02 X60 Z-10 R10 F0.1\nG03 X80 Z-20 R30\nG01 X20 Z0");
}

#[test]
fn constant_cutting_speed() {
    // At ⌀40, 100 m/min are 795.77/min: 60 mm / (0.2 × 795.77).
    check_seconds("", "G96 S100 M03\nG00 X40 Z0\nG99 G01 Z-60 F0.2", 60.0 * 60.0 / (0.2 * 795.7747));
    // Facing from ⌀100 to ⌀20: the mean diameter of 60 determines the time. 40 mm / 0.2 = 200 turns at
    // 530.5/min.
    check_seconds("", "G96 S100 M03\nG00 X100 Z0\nG99 G01 X20 F0.2", 200.0 * 60.0 / 530.5165);
    // Limited to 1000/min below ⌀31.831; to the axis and across it.
    for end in ["X20", "X0", "X-10", "X-100", "X20 Z-30", "X0 Z-80"] {
        check("", &format!("G50 S1000\nG96 S100 M03\nG00 X100 Z0\nG99 G01 {end} F0.2"));
        check("\"maxSpeed\": 800", &format!("G96 S100 M03\nG00 X100 Z0\nG99 G01 {end} F0.2"));
        check("\"maxSpeed\": 800", &format!("G50 S1000\nG96 S100 M03\nG00 X100 Z0\nG99 G01 {end} F0.2"));
    }
    // Outwards from the axis, completely below the limit, completely above it.
    check("", "G50 S1000\nG96 S100 M03\nG00 X0 Z0\nG99 G01 X100 F0.2");
    check_seconds("", "G50 S100\nG96 S100 M03\nG00 X50 Z0\nG99 G01 X30 F0.2", 30.0);
    check("", "G50 S3000\nG96 S100 M03\nG00 X100 Z0\nG99 G01 X80 Z-70 F0.2");
}

#[test]
fn constant_cutting_speed_on_arcs() {
    for clamp in ["", "G50 S900\n"] {
        check("", &format!("{clamp}G96 S100 M03\nG00 X20 Z0\nG99 G03 X60 Z-20 R20 F0.1\nG02 X80 Z-30 R60"));
        check("", &format!("{clamp}G96 S100 M03\nG00 X40 Z-20\nG99 G02 I20 K0 F0.1"));
    }
    // A ball starting at the axis.
    check("", "G50 S900\nG96 S100 M03\nG00 X0 Z0\nG99 G03 X40 Z-20 R20 F0.1");
}

/// With G20, S of G96 is in feet per minute: 12·S / (π·X) with X in inches.
#[test]
fn cutting_speed_in_feet() {
    let facing = "G20 G99\nG50 S5000\nG96 S300 M3\nG0 X2. Z0\nG1 Z-1. F.01";
    // 1 inch at 0.01 inch per revolution and 573/min.
    check_seconds("", facing, 100.0 * 60.0 * PI * 2.0 / (12.0 * 300.0));
    let speed_of = |program: &str, radius: f64| {
        let (motions, machine) = run("", program);
        speed_at(&motions.last().expect(program).process, &machine, radius).expect(program)
    };
    assert!((speed_of(facing, 25.4) - 572.958).abs() < 0.001);
    // The limits are in rpm in every unit.
    assert!((speed_of(facing, 1.0) - 5000.0).abs() < 1e-9);
    // S keeps the meaning that it had when it was programmed.
    let after = "G20 G96 S300 M3\nG21 G0 X50.8 Z0\nG1 Z-10 F.2";
    assert!((speed_of(after, 25.4) - 572.958).abs() < 0.001);
    // G97 without S keeps the speed; #4119 reads the feet.
    assert!((speed_of("G20 G96 S300 M3\nG0 X2. Z0\nG97\nG1 Z-1. F.01", 1.0) - 572.958).abs() < 0.001);
    assert!((speed_of("G20 G96 S300 M3\nG97 S#4119\nG0 X2. Z0\nG1 Z-1. F.01", 1.0) - 300.0).abs() < 1e-9);
    assert!((speed_of("G20 G97 S300 M3\nG0 X2. Z0\nG1 Z-1. F.01", 1.0) - 300.0).abs() < 1e-9);
}

/// Q of G50 is the lowest speed of G96.
#[test]
fn lowest_speed() {
    // Without Q, 100 m/min at ⌀100 are 318/min; Q keeps the spindle at 500.
    check_seconds("", "G50 S3000 Q500\nG96 S100 M03\nG00 X100 Z0\nG99 G01 Z-50 F0.2", 30.0);
    // Q alone, and above the limit of the machine.
    check_seconds("", "G50 Q500\nG96 S100 M03\nG00 X100 Z0\nG99 G01 Z-50 F0.2", 30.0);
    check_seconds("\"maxSpeed\": 400", "G50 Q500\nG96 S100 M03\nG00 X100 Z0\nG99 G01 Z-50 F0.2", 37.5);
    // Q has no effect with G97.
    check_seconds("", "G50 Q500\nG97 S250 M03\nG00 X100 Z0\nG99 G01 Z-50 F0.2", 60.0);
    // If the limits are reversed, the maximum applies.
    check_seconds("", "G50 S250 Q500\nG96 S100 M03\nG00 X100 Z0\nG99 G01 Z-50 F0.2", 60.0);
    // Limited to 500/min beyond ⌀63.66, to 1000/min below ⌀31.83.
    for end in ["X200", "X90", "X50", "X20", "X0", "X-10", "X-100", "X20 Z-30", "X0 Z-80"] {
        check("", &format!("G50 S1000 Q500\nG96 S100 M03\nG00 X100 Z0\nG99 G01 {end} F0.2"));
        check("\"maxSpeed\": 450", &format!("G50 Q500\nG96 S100 M03\nG00 X100 Z0\nG99 G01 {end} F0.2"));
    }
    check("", "G50 S900 Q600\nG96 S100 M03\nG00 X20 Z0\nG99 G03 X60 Z-20 R20 F0.1\nG02 X80 Z-30 R60");
    // G97 without S keeps the current speed.
    check_seconds("", "G50 Q500\nG96 S100 M03\nG00 X100 Z0\nG97\nG99 G01 Z-50 F0.2", 30.0);
}

#[test]
fn threads() {
    // 40 mm with a lead of 2 are 20 turns at 300/min.
    check_seconds("", "G97 S300 M03\nG00 X30 Z0\nG32 Z-40 F2", 4.0);
    // The lead counts along the longer axis.
    check_seconds("", "G97 S300 M03\nG00 X30 Z0\nG32 X50 Z-40 F2", 4.0);
    check_seconds("", "G97 S300 M03\nG00 X30 Z0\nG32 X110 Z-20 F2", 4.0);
    check("", "G97 S300 M03\nG00 X40 Z5\nG92 X30 Z-20 R-2 F3\nX29");
    check("", "G50 S1000\nG96 S100 M03\nG00 X20 Z0\nG32 X50 Z-40 F2");
    // The feed per minute does not matter for a thread.
    check_seconds("", "G98 G97 S300 M03\nG00 X30 Z0\nG32 Z-40 F2", 4.0);
}

#[test]
fn dwells_and_rapids() {
    let at = |machine: &str, program: &str| {
        let (motions, machine) = run(machine, program);
        seconds(motions.last().expect("a motion"), &machine)
    };
    assert_eq!(at("", "G04 X2.5"), Some(2.5));
    assert_eq!(at("", "G04 P1500"), Some(1.5));
    let both = "\"rapidX\": 6000, \"rapidZ\": 12000";
    // From X100 Z50: 30 mm of X at 100 mm/s, 150 mm of Z at 200 mm/s.
    assert_eq!(at(both, "G00 X40 Z-100"), Some(0.75));
    assert_eq!(at(both, "G00 X-100 Z0"), Some(1.0));
    assert_eq!(at("\"rapidX\": 6000", "G00 X40"), Some(0.3));
    assert_eq!(at("\"rapidZ\": 12000", "G00 Z-100"), Some(0.75));
}

#[test]
fn what_cannot_be_known() {
    check_unknown("", "G00 X40");
    check_unknown("\"rapidX\": 6000", "G00 X40 Z0");
    check_unknown("\"rapidZ\": 6000", "G00 X40");
    // The spindle is stopped, or never had a speed.
    check_unknown("", "G97 S500\nG00 X40 Z0\nG99 G01 Z-10 F0.2");
    check_unknown("", "G97 S500 M03\nM05\nG00 X40 Z0\nG99 G01 Z-10 F0.2");
    check_unknown("", "M03\nG00 X40 Z0\nG99 G01 Z-10 F0.2");
    check_unknown("", "M03\nG00 X40 Z0\nG32 Z-10 F2");
    check_unknown("", "G96 S0 M03\nG00 X40 Z0\nG99 G01 Z-10 F0.2");
    check_unknown("\"maxSpeed\": 3000", "G96 S0 M03\nG00 X40 Z0\nG99 G01 X0 F0.2");
    // Without a limit the speed at the axis is undefined.
    check_unknown("", "G96 S100 M03\nG00 X40 Z0\nG99 G01 X0 F0.2");
    check_unknown("", "G96 S100 M03\nG00 X40 Z0\nG99 G01 X-1 F0.2");
    check_unknown("", "G96 S100 M03\nG00 X0 Z0\nG99 G01 Z-10 F0.2");
}

#[test]
fn speeds_and_feeds_at_a_place() {
    let (motions, machine) = run("", "G50 S2000\nG96 S150 M03\nG00 X60 Z0\nG99 G01 X0 F0.25");
    let cut = motions.last().expect("a cut");
    let near = |found: Option<f64>, expected: f64| {
        assert!((found.expect("a value") - expected).abs() < 0.01, "{found:?}, not {expected}");
    };
    near(speed_at(&cut.process, &machine, 30.0), 1000.0 * 150.0 / (PI * 60.0));
    near(speed_at(&cut.process, &machine, -30.0), 1000.0 * 150.0 / (PI * 60.0));
    near(speed_at(&cut.process, &machine, 0.0), 2000.0);
    near(feed_at(cut, &machine, 30.0), 0.25 * 1000.0 * 150.0 / (PI * 60.0));
    near(Some(surface_speed(1000.0, 20.0)), 125.664);
    assert_eq!(feed_at(&motions[0], &machine, 30.0), None);
    // Without a cutting speed there is no speed, not even the maximum at the axis.
    let mut process = cut.process;
    process.speed = SpindleSpeed::Surface { speed: 0.0 };
    assert_eq!(speed_at(&process, &machine, 0.0), None);
    process.turn = SpindleTurn::Stopped;
    assert_eq!(speed_at(&process, &machine, 10.0), None);
}

/// Tool 1: 60 mm at 120 mm/min and 0.5 s; tool 2: a cut with unknown time. Back to tool 1: 20 mm in 10 s.
#[test]
fn times_are_added_up_for_each_tool() {
    let program = "G98\nT0101\nG00 X40 Z0\nG01 Z-60 F120\nG04 X0.5\nT0202\nG00 X30 Z0\nG99 G01 Z-10 F0.1\nT0101\n\
                   G98 G01 X70 F120";
    let setup =
        Setup::from_json(r#"{"initial": {"x": 100, "z": 50}, "machine": {"rapidX": 6000, "rapidZ": 6000}}"#)
            .expect("a setup");
    let analysis = analyze(program.as_bytes(), &setup);
    let (tools, all) = totals(&analysis.motions, &setup.machine);
    assert_eq!(tools.iter().map(|own| own.tool).collect::<Vec<_>>(), [(1, 1), (2, 2)]);
    let [first, second] = &tools[..] else { unreachable!() };
    let near =
        |found: f64, expected: f64| assert!((found - expected).abs() < 1e-6, "{found}, not {expected}");
    // Rapid: 30 and 50 mm at 100 mm/s.
    near(first.time.known, 0.5 + 30.0 + 0.5 + 10.0);
    near(first.cut, 80.0);
    near(first.rapid, 30f64.hypot(50.0));
    assert_eq!((first.time.unknown_cuts, first.time.unknown_rapids), (0, 0));
    near(second.time.known, 0.6);
    assert_eq!((second.time.unknown_cuts, second.time.unknown_rapids), (1, 0));
    near(second.cut, 10.0);
    near(all.time.known, first.time.known + second.time.known);
    near(all.cut, 90.0);
    let extents = first.extents.expect("cuts");
    near(extents.max.x, 35.0);
    near(extents.min.z, -60.0);
    let (tools, _) = totals(&analysis.motions, &Machine::default());
    assert_eq!(tools[0].time.unknown_rapids + tools[1].time.unknown_rapids, 2);
}
