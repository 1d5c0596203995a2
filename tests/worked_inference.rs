//! Inference of tools and blank that a program does not name. The expected parts are calculated by hand from
//! the drawing of each program; see `src/machine/inferred.rs` for the order of evidence.
use crate::ran::{run, run_under};
use gcode_playground::geometry::Point;
use gcode_playground::setup::{Stock, ToolKind};
use gcode_playground::units::Diameter;

/// The outside is turned to Ø40 and Ø48, a hole is drilled to Z-30, then an unnamed tool turns Ø13.2: it
/// bores.
#[test]
fn a_bore_after_drilling_leaves_the_outside() {
    let outside = "T0404\nG97S900M3\nG0X40.Z2.\nG1Z-8.F0.2\nX48.\nG0X100.Z50.\n";
    let drill = "T0101\nG97S700M3\nG0X0.Z3.\nG74R0.3\nG74Z-30.Q4000F0.1\nG0Z50.\n";
    let bore = |way: &str| format!("T0606\nG97S900M3\nG0X14.6\nZ2.\nG1Z0F0.3\n{way}G0Z50.\nM30\n");
    let ways = [
        "X13.2Z-0.7F0.08\nZ-24.F0.1\nU-0.6\nZ2.F2.\n",
        "X13.2,A45.F0.08\nZ-24.F0.1\nU-0.6\nZ2.F2.\n",
        // Back out at feed on the same diameter.
        "X13.2Z-0.7F0.08\nZ-24.F0.1\nZ2.F2.\n",
        "X13.2F0.08\nZ-24.F0.1\nZ2.F2.\n",
    ];
    for way in ways {
        let ran = run(&format!("O1\nG21G99\n{outside}{drill}{}", bore(way)));
        ran.check(&[(-4.0, &[(13.2, 40.0)]), (-20.0, &[(13.2, 48.0)])]);
    }
    // Nothing else is turned: an inward chamfer opens a bore. The wall is inferred.
    let ran = run(&format!("O1\nG21G99\n{drill}{}", bore(ways[0])));
    let part = ran.simulation.finished().expect("a part");
    let material = part.radii(-10.0);
    assert!(
        material.len() == 1 && (material[0].0 - 6.6).abs() < 0.02 && material[0].1 > 10.0,
        "{material:?}"
    );
    // A pin after a centre drill is turned from outside, pass by pass, and is longer than the hole is deep.
    let pin = "T0101\nG97S700M3\nG0X0.Z3.\nG83Z-3.F0.1\nG80\nG0Z50.\nT0404\nG0X36.Z2.\nG1Z-20.F0.2\nG0U1.Z2.\nG0X32.\nG1Z-20.\nG0U1.Z2.\nM30\n";
    run(&format!("O1\nG21G99\nG97S900M3\n{pin}")).check(&[(-10.0, &[(0.0, 32.0)])]);
}

/// A plunge to the axis in two steps, or with chip breaking, parts off with an insert of 3 mm: Z-40 to Z-37.
#[test]
fn a_plunge_in_steps_is_one_of_a_grooving_tool() {
    let program =
        |tool: &str, way: &str| format!("O1\nG21G99\n{tool}\nG97S800M3\nG0X64.Z-40.\n{way}G0X85.\nM30\n");
    let pecks = "G1X50.F0.08\nG0X52.\nG1X38.\nG0X40.\nG1X26.\nG0X28.\nG1X14.\nG0X16.\nG1X-1.\n";
    for tool in ["T0202 (PARTING 3MM)", "T0202 (CUTOFF)", "T0202"] {
        for way in ["G1X50.F0.08\nX-1.\n", "G1X50.F0.08\nX20.\nX-1.\n", "G1X-1.F0.08\n", pecks] {
            let ran = run(&program(tool, way));
            ran.check(&[
                (-36.9, &[(0.0, 64.0)]),
                (-37.1, &[]),
                (-39.9, &[]),
                (-40.1, &[(0.0, 64.0)]),
                (-1.0, &[(0.0, 64.0)]),
            ]);
        }
    }
    let groove = run(&program("T0202", &pecks.replace("X-1.", "X5.")));
    groove.check(&[(-36.9, &[(0.0, 64.0)]), (-38.0, &[(0.0, 5.0)]), (-40.1, &[(0.0, 64.0)])]);
}

/// A bar puller, a gripper or a stop moves with the spindle stopped: it neither cuts nor defines the blank.
#[test]
fn nothing_is_cut_with_the_spindle_stopped() {
    let turned = "O1\nG21G99\nT0101(OD CNMG)\nG50S3000\nG97S800M3\nG0X34.Z2.\nG1X28.F0.2\nZ-30.\nX34.\nG0X80.Z50.\nT0505(PARTING 3MM)\nG97S600M3\nG0X34.Z-33.\nG1X0F0.06\nG0X80.\nZ50.\n";
    let axis = "M5\nG0X0Z5.\nG98G1Z-25.F300\nM11\nG4X1.\nG1Z40.F800\nM10\nG0Z80.\nM30\n";
    let side = "M5\nG0Z-30.\nX70.\nG98G1X0F200.\nM11\nG4X1.\nW32.\nM10\nG0X80.\nZ80.\nM30\n";
    for (tool, way) in
        [("T0707(BAR PULLER)\n", axis), ("T0707\n", axis), ("T0707(BAR PULLER)\n", side), ("T0707\n", side)]
    {
        let ran = run(&format!("{turned}{tool}{way}"));
        ran.check(&[(-10.0, &[(0.0, 28.0)]), (-31.5, &[]), (-35.0, &[(0.0, 34.0)])]);
        assert!(!ran.told.contains(&"rapid-through-stock"), "{:?}", ran.told);
    }
    // A fragment without any M03 before is drawn: its spindle is only not programmed.
    run("O1\nG21G99\nT0101\nG0X34.Z2.\nG1X28.F0.2\nZ-30.\nX36.\nG0Z2.\nM30\n")
        .check(&[(-10.0, &[(0.0, 28.0)])]);
    // Rigid tapping with the spindle stopped, before a drill.
    let tap = run(
        "O1\n(STOCK D=40 LENGTH=50)\nG21G99\nT0101(DRILL 10)\nG97S800M3\nG0X0Z5.\nG1Z-20.F.1\nG0Z5.\nM5\n(TOOL T0202 TYPE=TAP D=12)\nT0202\nG0X0Z5.\nM29S300\nG84Z-15.F1.75\nG80\nM30\n",
    );
    let material = tap.simulation.finished().expect("a part").radii(-8.0);
    assert!(material.len() == 1 && material[0].0 > 5.5, "{material:?}");
}

/// After the first M05 a tool named as a bar puller in a comment cuts nothing either, with any codes for the
/// chuck.
#[test]
fn a_bar_puller_drills_nothing() {
    for words in ["(BARPULLER)", "(BARPULER)", "(BAR STOP)"] {
        let ran = run(&format!(
            "O1\nG21G99\nT0303\nG97S2000M3\nG0X30.Z2.\nX24.\nG1Z-12.F0.1\nX30.\nG0Z50.\nT0808(CUT-OFF 2MM)\nG97S1200M3\nG0X30.Z-10.\n\
             G1X-1.F0.08\nG0X30.\nZ50.\nM5\nT0505{words}\nG98\nG0X0.Z10.\nG1Z-6.F2000.\nZ-14.F500.\nG4X2.\nM21\nG1Z2.F500.\nG4X2.\nM22\nG0Z10.\nG99\nM30\n"
        ));
        ran.check(&[(-4.0, &[(0.0, 24.0)]), (-9.0, &[]), (-11.0, &[(0.0, 24.0)]), (-13.0, &[(0.0, 30.0)])]);
        assert!(!ran.told.contains(&"spindle-stopped"), "{:?}", ran.told);
    }
}

/// On the side of -X a pin of Ø1.3 and Ø2 is turned; facing across the axis to X-1.6 turns none.
#[test]
fn a_pin_is_turned_on_the_negative_side() {
    for side in ["-", ""] {
        run(&format!(
            "O1\nG21G99\nT0101\nG97S1200M3\nG0X{side}6.Z2.\nX{side}1.3\nG1Z-6.5F.1\nX{side}2.\nZ-10.5\nX{side}6.\nG0Z10.\nM30\n"
        ))
        .check(&[(-3.0, &[(0.0, 1.3)]), (-8.0, &[(0.0, 2.0)]), (-11.0, &[(0.0, 6.0)])]);
    }
    run("O1\nG21G99\nT0101\nG97S1200M3\nG0X32.Z0\nG1X-1.6F.1\nG0Z2.\nX28.\nG1Z-20.\nX32.\nG0Z50.\nM30\n")
        .check(&[(-0.1, &[(0.0, 28.0)]), (-10.0, &[(0.0, 28.0)])]);
    // From beyond the axis back across it: a tip, Ø1 at Z-2.
    run("O1\nG21G99\nT0101\nG97S1200M3\nG0X32.Z-0.5\nG1X-2.F.1\nX1.Z-2.\nX30.Z-20.\nG0X32.\nZ50.\nM30\n")
        .check(&[(-1.2, &[]), (-2.0, &[(0.0, 1.0)])]);
}

/// A tool that returns to its start diameter outside of the work turns the outside, even if it continues to a
/// smaller diameter.
#[test]
fn a_tool_that_returns_to_its_clearance_turns_outside() {
    run("O1\nG21G99\nT0505\nG97S750M3\nG0X25.1Z3.\nX17.88\nG1Z-14.7F.1\nX25.1\nG0X18.4Z10.\nZ.2\nG1X12.F.2\nG0Z30.\nM30\n")
        .check(&[(-7.0, &[(0.0, 17.88)]), (-14.0, &[(0.0, 17.88)]), (-16.0, &[(0.0, 25.1)])]);
}

/// G71 whose contour with its allowance ends beyond the start point: its pass still begins outside of the
/// cut.
#[test]
fn a_pass_of_g71_that_goes_in_turns_outside() {
    run("O1\nG21G99\nT0505\nG97S750M3\nG0X25.1Z3.\nG71U4.5R.5\nG71P21Q22U6.W.2F.2\nN21G0X16.48\nG1Z-12.3F.08\nN22X25.1\nG70P21Q22\nG0Z30.\nM30\n")
        .check(&[(-6.0, &[(0.0, 16.48)]), (-12.0, &[(0.0, 16.48)])]);
}

/// The first full facing cut, with nothing cut before, is at the front of the blank.
#[test]
fn the_first_face_is_the_front_of_the_blank() {
    let ran = run(
        "O1\nG21G99\nT0101(OD CNMG)\nG50S3000\nG97S500M3\nG0Z-80.\nX60.\nG1X-1.6F0.2\nX60.\nG0X62.\nG0Z-79.\nX50.\nG1Z-100.\nX60.\nG28U0\nG28W0\nM30\n",
    );
    ran.check(&[(-40.0, &[]), (-79.5, &[]), (-90.0, &[(0.0, 50.0)]), (-101.0, &[(0.0, 60.0)])]);
    // Parting off alone leaves the piece in front.
    run("O1\nG21G99\nT0303\nG97S500M3\nG0X52.Z-40.\nG1X-1.F.1\nG0X60.\nM30\n")
        .check(&[(-20.0, &[(0.0, 52.0)])]);
    // Turned first, then parted off by the same tool.
    let both = run("O1\nG21G99\nT0303\nG97S500M3\nG0X52.Z1.\nG1X48.F.1\nZ-45.\nG0X52.Z-40.\nM30\n");
    both.check(&[(-20.0, &[(0.0, 48.0)])]);
}

/// A tap on the axis needs a bar to tap.
#[test]
fn a_tapped_bar_has_a_wall() {
    let ran = run("O1\nG21G99\nT0101\nG97S300M3\nG0X0Z5.\nG32Z-20.F1.5\nM5\nM4\nG32Z5.F1.5\nM30\n");
    assert!(ran.stock.diameter.mm() >= 20.0, "{:?}", ran.stock);
    let material = ran.simulation.finished().expect("a part").radii(-10.0);
    assert!(material.len() == 1 && material[0].1 - material[0].0 > 5.0, "{material:?}");
}

/// `T01 M06` in a program without four-digit T words selects a station.
#[test]
fn short_tool_words_beside_m06_are_stations() {
    let program = |first: &str, second: &str| {
        format!(
            "O1\nG21G99\n{first}\nG97S900M3\nG0X42.Z2.\nG1X36.F0.2\nZ-40.\nG0X60.Z60.\n{second}\nG97S600M3\nG0X44.Z-18.\nG1X28.F0.08\nG0X44.\nG0Z60.\nM30\n"
        )
    };
    let groove: &[(f64, &[(f64, f64)])] =
        &[(-10.0, &[(0.0, 36.0)]), (-14.9, &[(0.0, 36.0)]), (-16.0, &[(0.0, 28.0)]), (-18.1, &[(0.0, 36.0)])];
    run(&program("T0101", "T0303")).check(groove);
    for (first, second) in
        [("T01 M06", "T03 M06"), ("M06 T01", "M06 T03"), ("T1 M6", "T3 M6"), ("T1 M06 M04", "T3 M06 M04")]
    {
        let ran = run(&program(first, second));
        ran.check(groove);
        assert!(!ran.told.contains(&"tool-unknown"), "{:?}", ran.told);
    }
    // Among four-digit words, two digits are an offset.
    let ran = run(&program("T0101", "T03 M06"));
    assert!(ran.told.contains(&"short-tool-word"), "{:?}", ran.told);
}

/// Work on the second side, in the opposite direction: faced at Z0, turned to Ø38 towards +Z.
#[test]
fn work_towards_positive_z_has_its_blank_there() {
    let ran = run(
        "O1\nG21G99\nG55\nT0101(OD CNMG)\nG50S3000\nG97S700M4\nG0X46.Z-2.\nG1Z0F0.1\nX-1.\nG0X38.Z-2.\nG1Z15.F0.15\nX46.\nG0Z-5.\nM30\n",
    );
    ran.check(&[(-1.0, &[]), (1.0, &[(0.0, 38.0)]), (14.0, &[(0.0, 38.0)]), (16.0, &[(0.0, 46.0)])]);
    // Facing retracts along +Z.
    let faced = run("O1\nG21G99\nT0101\nG97S700M3\nG0X54.Z4.\nG94X20.Z0F0.15\nZ-2.\nZ-4.\nM30\n");
    faced.check(&[(-1.0, &[(0.0, 20.0)]), (-5.0, &[(0.0, 52.0)])]);
    // With the zero at the chuck the work is also at +Z, but the tool goes towards −Z.
    let usual = run(
        "O1\nG21G99\nT0101\nG97S700M3\nG0X46.Z50.\nG1X-1.F.1\nG0X38.Z52.\nG1Z30.F0.15\nX46.\nG0Z55.\nM30\n",
    );
    usual.check(&[(51.0, &[]), (40.0, &[(0.0, 38.0)]), (29.0, &[(0.0, 46.0)])]);
}

/// An insert that turns a hub in a recess of the face leaves the rim.
#[test]
fn a_hub_in_a_recess_leaves_the_rim() {
    let recess = "T0101(FACE GROOVE W4)\nG97S400M3\nG0X40.Z2.\nG1Z-3.F0.1\nX68.\nZ-6.\nX40.\nG0Z50.\n";
    let hub = "T0202(OD FINISH)\nG97S900M3\nG0X39.Z2.\nG1Z-6.F0.1\nU1.\nG0Z2.\nM30\n";
    let ran = run(&format!("O1\n(STOCK D=120 LENGTH=40)\nG21G99\n{recess}{hub}"));
    ran.check(&[
        (-1.0, &[(0.0, 39.0), (68.08, 120.0)]),
        (-5.0, &[(0.0, 39.0), (68.08, 120.0)]),
        (-7.0, &[(0.0, 120.0)]),
    ]);
}

/// A bar without a bore stays solid in a frame that is shifted along X.
#[test]
fn a_solid_bar_stays_solid_in_a_shifted_frame() {
    let bar = Stock {
        diameter: Diameter::new(50.0),
        bore: Diameter::new(0.0),
        face: 0.0,
        length: 80.0,
        grip: None,
    };
    let moved = bar.moved(Point::new(3.0, -10.0));
    assert_eq!((moved.diameter.mm(), moved.bore.mm(), moved.face), (56.0, 0.0, -10.0));
    let tube = Stock { bore: Diameter::new(20.0), ..bar };
    assert_eq!(tube.moved(Point::new(3.0, 0.0)).bore.mm(), 26.0);
}

/// A program without G20 whose numbers look like inches is read in inches: X.95 is 24.13 mm.
#[test]
fn an_inch_program_without_g20_is_read_in_inches() {
    let way = "G0X.95Z.1\nG1Z0F.006\nX-.06\nG0X.87Z.1\nG1Z-1.125F.008\nX.95\nG28U0\nG28W0\nM30\n";
    let program = |head: &str, tool: &str| format!("{head}\nG99G18\nT0101{tool}\nG50S3000\nG96S450M3\n{way}");
    let (inches, millimetres) = ((-10.0, &[(0.0, 0.87 * 25.4)][..]), (-0.5, &[(0.0, 0.87)][..]));
    for (head, tool, setup, is_inch) in [
        ("O0065(PIN 1/2 IN)", "(1/32R CNMG)", "{}", true),
        ("O0065", "(1/32R CNMG)", "{}", true),
        ("O0065(PIN .5\" DIA)", "", "{}", true),
        ("O0065(DIMENSIONS IN INCHES)", "", "{}", true),
        // In metres per minute, 450 would need 150,000 rpm; the limit is 3000.
        ("O0065", "", "{}", true),
        // Given by a code or the setup.
        ("O0065(PIN 1/2 IN)\nG21", "", "{}", false),
        ("O0065(PIN 1/2 IN)", "", r#"{"dialect": {"unit": "mm"}}"#, false),
        ("(DIALECT UNIT=MM)(PIN 1/2 IN)", "(1/32R CNMG)", "{}", false),
    ] {
        let ran = run_under(&program(head, tool), setup);
        ran.check(&[if is_inch { inches } else { millimetres }]);
        assert_eq!(ran.told.contains(&"inches-concluded"), is_inch, "{head} {tool} {setup}: {:?}", ran.told);
    }
    // If the setup gives the unit, nothing is concluded.
    let ran = run_under(&program("O0065", ""), r#"{"dialect": {"unit": "inch"}}"#);
    ran.check(&[inches]);
    assert!(!ran.told.contains(&"inches-concluded"));
    // A feed per minute with G01, and machine positions, are no evidence of millimetres.
    let pulled = run(
        "O3001(PAWN)\n(2.0IN STOCK STICKOUT)\nG10L2P1Z-25.\nG53X0Z-43.\nT0101\nG97S300M03\nG00X1.325Z.25\nX0.95\nG01Z-1.25F0.005\nX1.325\nG00Z.25\n\
         T0707(STOCK PULLER)\nG00Z2.\nX0\nG98G01Z1.F50.\nG99\nM30\n",
    );
    assert!(pulled.told.contains(&"inches-concluded"), "{:?}", pulled.told);
    // Four decimals are usual in inches; a lead of 1/14 inch.
    let fine = run("O1\nT0101\nG97S800M3\nG0X1.0625Z.1\nG1Z-1.F.008\nX1.2\nG0Z.1\nM30\n");
    fine.check(&[(-10.0, &[(0.0, 1.0625 * 25.4)])]);
    // Small work in millimetres: its size and its feeds alone would suggest inches.
    let fast = run("O1\nT0101\nG50S8000\nG96S200M3\nG0X3.995Z.5\nG1Z-6.F.02\nX5.\nG0Z1.\nM30\n");
    fast.check(&[(-3.0, &[(0.0, 3.995)])]);
    for small in ["(PIN 3MM)", "(2/3)", "(IN THE VICE)", "(DATE 1/12/26)"] {
        let text = format!("O1{small}\nT0101\nG97S6000M3\nG0X3.995Z.5\nG1Z-6.F.02\nX5.\nG0Z1.\nM30\n");
        run(&text).check(&[(-3.0, &[(0.0, 3.995)])]);
    }
}
/// G90 from X60 Z0 with U20 W30 R-5 bores a cone from Ø70 at Z0 to Ø80 at Z30: a tube with a bore of 60 at +Z
/// (seed 000, case 3).
#[test]
fn a_cone_bored_towards_positive_z_is_in_a_tube() {
    let ran = run("G00 X60 Z0 M03 S500\nG90 U20 W30 R-5 F0.2\nM30\n");
    let part = ran.simulation.finished().expect("a part");
    for (z, inner) in [(0.1, 70.03), (15.0, 75.0), (29.9, 79.97), (31.0, 60.0)] {
        let material = part.radii(z);
        assert!(material.len() == 1, "Z{z}: {material:?}");
        assert!((2.0 * material[0].0 - inner).abs() < 0.05 && material[0].1 > 42.0, "Z{z}: {material:?}");
    }
    assert!(part.radii(-0.1).is_empty(), "{:?}", ran.stock);
}

/// G75 with columns 3.5 mm apart is one groove, from Z-29 to the right corner of the insert: no ridges of 0.5
/// mm remain.
#[test]
fn columns_of_pecks_leave_no_ridges() {
    let program = |columns: &str| {
        format!("T0202\nG97S500M03\nG00X52Z-20\nG75R0.4\nG75X36Z-29P3000{columns}R0F60\nG00X200\nM30\n")
    };
    let ran = run(&program("Q3500"));
    for z in [-28.9, -24.5, -23.75, -20.25, -17.5, -16.1] {
        ran.check(&[(z, &[(0.0, 36.0)])]);
    }
    // Farther apart they are separate grooves, with lands from Z-24.5 to Z-23 and from Z-29 to Z-26.
    run(&program("Q6000")).check(&[(-21.5, &[(0.0, 50.0)]), (-25.0, &[(0.0, 36.0)])]);
}

/// G73 with U18 machines a bar of Ø36.5 to a ball of R6 whose nose is at Z1: its first pass touches the bar
/// where the contour is deepest, at X0 with 0.25 mm for finishing (seed 003).
#[test]
fn the_first_pass_of_g73_touches_the_blank() {
    let ran = run(
        "N010 G50 X100 Z100\nN020 G00 X50 Z10 M03 S600\nN030 G73 U18 W5 R10\nN040 G73 P50 Q100 U0.5 W0.5 F100\nN050 G01 X0 Z1\nN060 G03 X12 W-6 R6\nN070 G01 W-10\nN080 X20 W-15\nN090 W-13\nN100 G02 X34 W-7 R7\nN110 G70 P50 Q100 F30\nN120 M30\n",
    );
    let ball = 2.0 * (36f64 - 5.5 * 5.5).sqrt();
    ran.check(&[(0.5, &[(0.0, ball)]), (-10.0, &[(0.0, 12.0)]), (-55.0, &[(0.0, 36.5)])]);
    assert_eq!((ran.stock.diameter.mm(), ran.stock.face), (36.5, 1.0));
}

/// The blank is consistent with the turning: no smaller than the widest cut along Z, and larger than a single
/// pass.
#[test]
fn a_blank_is_no_smaller_than_what_is_turned() {
    // One pass, approached at feed from X50: a bar of 48.
    let one = run("O1\nG21G40G99\nT0101\nG97S1000M3\nG00X50.Z2.\nG01X45.F0.2\nZ-30.\nG00X60.\nZ2.\nM30\n");
    one.check(&[(-10.0, &[(0.0, 45.0)]), (-31.0, &[(0.0, 48.0)])]);
    // The contour of G72 has a land at X50; rapids run along X51.
    let land = run(
        "O1\nG21G40G99\nT0101\nG97S1000M3\nG00X51.Z0.\nG01X0.F0.1\nG00Z1.\nX51.\nZ0.\nG72W1.5R0.5\nG72P1Q2U0.25W0.25\nN1G00Z-30.\nG01X50.F0.1\nZ-20.\nX30.\nZ0\nN2X0.\nG70P1Q2\nG00Z10.\nM30\n",
    );
    land.check(&[(-25.0, &[(0.0, 50.0)]), (-10.0, &[(0.0, 30.0)])]);
    // An inch program: 2 mm would be more than the usual clearance.
    let inch = run(
        "O1\nG20G40G99\nT0101\nG97S400M3\nG00X.777Z.1\nG01Z0F.006\nX-.1\nG00X.309\nG01Z-.12\nG00X.777Z-.75\nZ-.12\nX.735\nG01Z-1.075\nG00X.777\nX4.Z4.\nM30\n",
    );
    inch.check(&[(-10.0, &[(0.0, 0.735 * 25.4)])]);
}

/// A program may end at the bottom of a groove: that is not a bore.
#[test]
fn a_program_that_ends_in_a_groove_has_no_bore() {
    let turned = "O1\nG21G99\nT0101\nG97S800M3\nG0X24.Z2.\nG1Z-45.F.2\nG0X26.Z2.\nX18.\nG1Z-22.\nG0X30.Z50.\nT0202\nG0X26.Z-39.\n";
    let ran = run(&format!("{turned}G1X25.F.05\nZ-39.5\nX18.\nM30\n"));
    ran.check(&[(-10.0, &[(0.0, 18.0)]), (-30.0, &[(0.0, 24.0)])]);
}

/// A plunge with a dwell at its bottom is made by a grooving tool, even if it then breaks an edge: 3 mm wide.
#[test]
fn a_plunge_with_a_dwell_is_one_of_a_grooving_tool() {
    let turned = "O1\nG21G40G99\nT0101\nG97S600M3\nG00X46.Z2.\nX40.\nG01Z-60.F0.2\nX46.\nG00X50.Z60.\n";
    let groove = "T0202\nS200M3\nG00X42.Z-14.\nG01X36.F0.03\nG04P1000\nG00X42.\nZ-11.\nG01X36.Z-14.F0.1\nG00X50.\nZ60.\nM30\n";
    run(&format!("{turned}{groove}")).check(&[
        (-14.1, &[(0.0, 40.0)]),
        (-12.5, &[(0.0, 36.0)]),
        (-11.1, &[(0.0, 36.0)]),
    ]);
}

/// The passes of G73 approach from outside, although its start point is within the largest diameter.
#[test]
fn a_pattern_from_outside_is_turned_outside() {
    let ran = run(
        "O1\nG21G40G98\nT0101\nM03S1000\nG00X20.Z10.\nG73U9.75W0R5F100\nG73P10Q20U0.5W0\nN10G00X0Z10.\nG01Z0\nX14.\nZ-10.\nX20.Z-20.\nN20G00X40.\nG70P10Q20F50\nG00X60.Z100.\nM30\n",
    );
    ran.check(&[(-5.0, &[(0.0, 14.0)]), (-15.0, &[(0.0, 17.0)])]);
}

/// A tool that only approaches along the outside of the bar and then plunges is a grooving tool of 3 mm.
#[test]
fn an_approach_along_the_outside_is_no_contour() {
    let ran =
        run("O1\nG21G99\nG50S3000\nT0101\nG97S650M3\nG0X45.Z2.\nG1Z-80.F5.\nX33.F0.2\nG0X60.\nZ50.\nM30\n");
    ran.check(&[(-81.0, &[(0.0, 45.0)]), (-78.5, &[(0.0, 33.0)]), (-76.0, &[(0.0, 45.0)])]);
}

/// The work rotates: a cut at X-40 removes the same as one at X40. Facing slightly past the axis is not such
/// a cut.
#[test]
fn cuts_on_the_side_of_negative_x_are_removed() {
    let program = |sign: &str| {
        format!(
            "O1\nG21G40G99\nT0101\nG97S800M3\nG00X{sign}55.Z0.\nG01X0.F0.1\nG00Z2.\nX{sign}50.\nG01Z-30.F0.2\nX{sign}55.\nG00Z2.\nX{sign}40.\nG01Z-18.F0.2\nG0{}X{sign}44.Z-20.R2.\nG01X{sign}55.\nG00Z2.\nM30\n",
            if sign.is_empty() { 2 } else { 3 }
        )
    };
    let expected: &[(f64, &[(f64, f64)])] =
        &[(-10.0, &[(0.0, 40.0)]), (-20.1, &[(0.0, 50.0)]), (-25.0, &[(0.0, 50.0)]), (-31.0, &[(0.0, 55.0)])];
    for sign in ["", "-"] {
        let ran = run(&program(sign));
        ran.check(expected);
        assert!(!ran.simulation.finished().expect("a part").radii(-19.0).is_empty());
    }
    let past = run(
        "O1\nG21G40G99\nT0101\nG97S800M3\nG00X52.Z0.\nG01X-1.6F0.1\nG00Z2.\nX50.\nG01Z-30.F0.2\nX52.\nG00Z2.\nX48.\nG01Z-20.\nX52.\nM30\n",
    );
    past.check(&[(-10.0, &[(0.0, 48.0)]), (-25.0, &[(0.0, 50.0)])]);
}

/// A lead of .0625 is 16 threads per inch: in millimetres no thread is so fine.
#[test]
fn a_lead_too_fine_for_millimetres_shows_inches() {
    for head in ["(NAT#1 THREADING)\nG50S1500\n", "O0066(SCREW)\nG99G18\n"] {
        let ran = run(&format!(
            "{head}T0303\nG97S800M3\nG0X1.0Z0.2\nG76P010060Q50R0.002\nG76X0.9Z-0.8P500Q50F0.0625\nG0X2.0Z1.0\nM30\n"
        ));
        assert!(ran.told.contains(&"inches-concluded"), "{:?}", ran.told);
    }
    let millimetres = run("O1\nT0303\nG97S800M3\nG0X8.Z2.\nG92X5.5Z-8.F0.5\nX5.2\nG0X20.\nM30\n");
    assert!(!millimetres.told.contains(&"inches-concluded"));
}

/// A single pass after a rapid approach removes 1 mm from the bar.
#[test]
fn a_single_pass_is_seen() {
    run("O1001\nG99G21G40\nT0202\nG97S220M03\nG00X80.0Z2.0\nG01Z-12.0F0.20\nG00X100.0\nM30\n")
        .check(&[(-5.0, &[(0.0, 80.0)]), (-13.0, &[(0.0, 82.0)])]);
}

/// The first of several passes removes material as well: the tool came to Ø35 from Ø45, the blank is between
/// the two.
#[test]
fn the_first_of_several_passes_is_seen() {
    let ran = run(
        "O7\nG21G99\nT0101\nG97S800M03\nG00X45.Z2.\nX35.\nG01Z-50.F0.2\nG00X45.Z2.\nX31.\nG01Z-38.\nG00X100.Z100.\nM30\n",
    );
    ran.check(&[(-20.0, &[(0.0, 31.0)]), (-45.0, &[(0.0, 35.0)]), (-51.0, &[(0.0, 37.0)])]);
}

/// A bore of Ø30 to Z-50 in a tube, with the tool back at Ø26: the hole of the tube is between the two, and
/// the end of the cut is visible.
#[test]
fn the_end_of_a_bore_is_seen() {
    let ran =
        run("O8\nG21G99\nT0404\nG97S800M03\nG00X36.Z2.\nG01X30.Z-1.F0.1\nZ-50.\nG00X26.Z-40.\nZ4.\nM30\n");
    let outside = ran.stock.diameter.mm();
    ran.check(&[(-20.0, &[(30.0, outside)]), (-51.0, &[(28.0, outside)])]);
}

/// A thread with an endlessly growing lead does not make a blank of a metre: the thread is in a bar of Ø30,
/// 30 long.
#[test]
fn a_lead_without_end_makes_no_large_blank() {
    let ran = run(
        "O8\nG21G99\nT0303\nG97S400M3\nG0X35.Z5.\n#100=1.5\nN1G0X29.7\nG32Z-30.F#100\nG0X35.\nZ5.\n#100=#100+1.\nIF[#100LT400.]GOTO1\nM30\n",
    );
    assert!((29.7..=32.0).contains(&ran.stock.diameter.mm()) && ran.stock.length <= 45.0, "{:?}", ran.stock);
}

/// The unit stays when the run restarts with the program that calls the first one.
#[test]
fn the_unit_holds_where_a_run_begins_again() {
    let ran = run(
        "O0002(GROOVE)\nG01U-.1F.005\nU.1\nM99\nO0001(PIN 1/2 IN)\nT0101\nG97G99S800M3\nG0X.7Z.1\nG1Z-1.F.008\nX.8\nG0Z.1\nX.6\nG1Z-.5\nX.8\nM98P0002\nM30\n",
    );
    ran.check(&[(-5.0, &[(0.0, 0.6 * 25.4)])]);
}

/// Comments without a size in inches: pages, operations, dates, prose. A long word takes no extra time.
#[test]
fn comments_without_inches() {
    let program =
        |comment: &str| format!("O1 ({comment})\nT0101\nG97G99S3000M3\nG0X8.5Z1.\nG1Z-12.F.02\nX9.\nM30\n");
    for comment in ["OP 1/2", "TOOL 1 IN USE", "2/3", "1/12/26", "PAGE 1/4", "FINISH"] {
        let ran = run(&program(comment));
        assert!(!ran.told.contains(&"inches-concluded"), "{comment}");
    }
    for comment in ["1/2 IN", "3/8-16 UNC", "1/32R", "5 IN BAR", "ALL IN INCHES", "DIA .5\""] {
        let ran = run(&program(comment));
        assert!(ran.told.contains(&"inches-concluded"), "{comment}");
    }
    let begun = std::time::Instant::now();
    run(&program(&"I".repeat(1_000_000)));
    assert!(begun.elapsed().as_secs() < 10);
}

/// A facing cut to Z0 leaves no loose piece in front of the face, for any entering angle.
#[test]
fn nothing_floats_in_front_of_the_face() {
    let ran = run(
        "O1\nG21G99\nT0101\nG97S1000M3\nG0Z3.\nX42.\nG72W1.R1.\nG72P10Q20U0.W0.F0.3\nN10G0Z0.\nG1X-1.6F0.1\nN20Z1.\n\
         G0X42.Z3.\nX30.\nG1Z-20.F0.2\nX42.\nG0Z50.\nM30\n",
    );
    ran.check(&[(0.5, &[]), (1.5, &[]), (-1.0, &[(0.0, 30.0)]), (-19.9, &[(0.0, 30.0)])]);
    // A piece that is parted off is not removed like that.
    let parted = run(
        "O1\nG21G99\nT0101\nG97S1000M3\nG0X42.Z2.\nG1X38.F0.2\nZ-20.\nX42.\nG0X60.Z50.\nT0202(PARTING W=3)\nG0X44.Z-5.\n\
         G1X-1.F0.1\nG0X60.\nZ50.\nM30\n",
    );
    assert_eq!(parted.simulation.finished().expect("a part").pieces().count(), 2);
}

/// T0303 plunges and turns as no usual insert can. The part is that of T0101, and a message reports it.
#[test]
fn a_tool_that_is_not_known_leaves_the_cuts_of_the_others() {
    let unknown = "T0303\nG0X54.Z2.\nX42.Z-10.\nG1X40.F0.1\nX30.\nZ-20.\nX36.Z-30.\nX28.Z-38.\nX42.\nG0Z-24.\nG1X20.\nG0X54.\n";
    let outside = "T0101\nG0X54.Z2.\nX46.\nG1Z-45.F0.2\nX54.\nG0X80.Z50.\n";
    let ran = run(&format!("O1\nG21G99\nG97S600M3\n{outside}{unknown}G0X80.Z50.\nM30\n"));
    assert_eq!(ran.told, ["tool-unknown"]);
    ran.check(&[(-5.0, &[(0.0, 46.0)]), (-24.0, &[(0.0, 46.0)]), (-46.0, &[(0.0, 54.0)])]);
    // If it is the only tool, there is no part to show.
    let alone = run(&format!("O1\nG21G99\nG97S600M3\n{unknown}G0X80.Z50.\nM30\n"));
    assert_eq!(alone.told, ["tool-unknown"]);
    assert!(alone.simulation.finished().is_none());
}

/// The rapid to X48 Z-1 enters a bar of 50 mm, with any tool.
#[test]
fn a_rapid_of_a_tool_that_is_not_known_runs_into_the_stock() {
    let cycle =
        "G71U2.R0.5\nG71P10Q20U0.4W0.1F0.25\nN10G0X20.\nG1Z-20.F0.1\nX30.Z-30.\nN20X48.\nG0X100.Z50.\nM30\n";
    let program = |x: f64| {
        format!("O1\n(STOCK D=50 LENGTH=80)\nG21G99\nT0101\nG97S800M3\nG0X60.Z5.\nG0X{x}Z-1.\n{cycle}")
    };
    let crash = run(&program(48.0));
    assert!(crash.told.contains(&"rapid-through-stock"), "{:?}", crash.told);
    assert!(!run(&program(52.0)).told.contains(&"rapid-through-stock"));
}

/// The last block of the contour returns on a slope from X50 Z-60 to X55 Z2: its diameter at Z0 is not a bar
/// size.
#[test]
fn a_blank_has_a_diameter_in_whole_millimetres() {
    let ran = run(
        "O1\nG21G99\nT0101\nG97S800M3\nG0X55.Z2.\nG71U2.R0.5\nG71P10Q20U0.5W0.1F0.3\nN10G0X20.\nG1Z-30.F0.15\nX40.\nZ-60.\n\
         X50.\nN20X55.Z2.\nG70P10Q20F0.1\nG0X100.Z50.\nM30\n",
    );
    assert_eq!(ran.stock.diameter, Diameter::new(55.0));
}

/// A bar size in a comment is used if it matches the cuts: Ø44 is turned to Z-30 from an approach at X56.
#[test]
fn a_blank_in_words() {
    let program = |words: &str| {
        format!(
            "O1 ({words})\nG21G99\nT0101\nG97S800M3\nG0X56.Z2.\nG1X50.F0.2\nZ-30.\nX56.\nG0Z2.\nX44.\nG1Z-30.\nX56.\nG0Z50.\nM30\n"
        )
    };
    let sizes = |words: &str| {
        let stock = run(&program(words)).stock;
        (stock.diameter.mm(), stock.length)
    };
    let (inferred, length) = sizes("SHAFT");
    assert_eq!(sizes("BRUT PHI55 X 60MM"), (55.0, 60.0));
    assert_eq!(sizes("Ø55 bar stock"), (55.0, length));
    // That size is the part, or a mistake.
    for words in ["BLANK D20", "BLANK D500", "毛坯 φ30×10"] {
        assert_eq!(sizes(words), (inferred, length), "{words}");
    }
}

/// The assumed diameter of a drill is reported once, unless a tool bores the hole afterwards.
#[test]
fn a_drill_of_assumed_diameter_is_said() {
    let drill = |words: &str| {
        format!(
            "O1\nG21G99\nG97S800M3\nT0202{words}\nG0X0Z5.\nG1Z-20.F0.1\nG0Z5.\nG1Z-30.\nG0Z5.\nX80.Z50.\n"
        )
    };
    let told =
        |text: String| run(&text).told.iter().filter(|slug| **slug == "drill-diameter-assumed").count();
    assert_eq!(told(drill("") + "M30\n"), 1);
    assert_eq!(told(drill("(DRILL D12)") + "M30\n"), 0);
    // A deeper drill removes the hole of a centre drill.
    let centre = "T0404\nG0X0Z5.\nG1Z-5.F0.1\nG0Z5.\nX80.Z50.\n";
    let before = |words: &str| drill(words).replacen("T0202", &format!("{centre}T0202"), 1);
    assert_eq!(told(before("(DRILL D12)") + "M30\n"), 0);
    assert_eq!(told(before("") + "M30\n"), 1);
    assert_eq!(told(drill("") + "T0303\nG0X18.Z2.\nG1Z-15.F0.1\nX16.\nG0Z2.\nZ50.\nM30\n"), 0);
    // Devices that hold or move the work drill nothing.
    for words in ["(BAR STOP)", "(BAR PULLER)", "(TAILSTOCK CENTER)"] {
        assert_eq!(told(drill(words) + "M30\n"), 0, "{words}");
    }
    // Holes of a live drill in the side are not in the section.
    let turned = "T0101\nG0X52.Z2.\nX40.\nG1Z-30.F.2\nX52.\nG0X100.Z100.\n";
    let radial = "M5\nG97S2500M13\nG0Z-20.X60.\nC0\nG1X30.F.1\nG0X60.\nC180.\nG1X30.F.1\nG0X100.\n";
    for tool in ["T0303 (LIVE DRILL)", "T0303 (DRILL)", "T0303"] {
        assert_eq!(told(format!("O1\nG21G99\nG97S800M3\n{turned}{tool}\n{radial}M30\n")), 0, "{tool}");
    }
}

/// A contour with a step inwards, Ø20 from Z-30 to Z-32: no known insert can make it, and the step is cut as
/// programmed.
#[test]
fn a_contour_with_a_step_inwards_is_turned() {
    let ran = run(
        "O1\nG21G40G98\nT0101\nM3S1000\nG0X60.Z50.\nG73U6.W0R3F100\nG73P10Q20U0.5W0\nN10G0X12.Z10.\nG1Z0\nX24.Z-10.\nZ-30.\n\
         X20.\nZ-32.\nX24.\nZ-36.\nN20G0X30.\nG70P10Q20F50\nG0X60.Z100.\nM30\n",
    );
    let tool = ran.simulation.resolved_setup().tools().next().expect("a tool").tool.clone();
    assert_eq!((tool.kind, tool.width), (Some(ToolKind::Turning), None));
    ran.check(&[
        (-29.99, &[(0.0, 24.0)]),
        (-30.01, &[(0.0, 20.0)]),
        (-31.99, &[(0.0, 20.0)]),
        (-32.01, &[(0.0, 24.0)]),
    ]);
}

/// G72 from outside leaves a nub of Ø20 in front of a cone: an outside tool, not a grooving insert.
#[test]
fn a_facing_cycle_from_outside_has_an_outside_tool() {
    let ran = run(
        "O1\nG21G99\nT0101\nG97S500M3\nG0X85.Z2.\nG72W2.R0.5\nG72P10Q50U0.W0.F0.25\nN10G0Z-20.\nG1X70.F0.15\nZ-15.\nX40.Z-8.\n\
         N50X20.\nG70P10Q50\nG0X100.Z50.\nM30\n",
    );
    let tool = ran.simulation.resolved_setup().tools().next().expect("a tool").tool.clone();
    assert_eq!(tool.kind, Some(ToolKind::Turning));
    ran.check(&[(-17.0, &[(0.0, 70.0)]), (-11.5, &[(0.0, 55.0)])]);
}

/// The return of G94 to its start in the plane of the first pass is not a cut of a left-hand tool. Each pass
/// leaves its face.
#[test]
fn a_facing_cycle_from_the_plane_of_its_first_pass_faces() {
    let stock = "O1(STOCK D=44 LENGTH=80)\nG21G99\nT0101M3S800\n";
    for start in ["G0X46.Z-2.\n", "G0X46.Z-1.\n", "G0X46.Z2.\n"] {
        let ran = run(&format!("{stock}{start}G94X-1.Z-2.F0.3\nZ-4.\nG0X100.Z100.\nM30\n"));
        ran.check(&[(-0.5, &[]), (-3.9, &[]), (-4.1, &[(0.0, 44.0)]), (-16.0, &[(0.0, 44.0)])]);
    }
    // The same, as single moves.
    let ran = run(&format!(
        "{stock}G0X46.Z-1.\nG1X20.F0.2\nG0X46.\nZ-4.\nG1X20.\nZ-1.\nG0X46.\nZ-6.\nG1X20.\nZ-1.\nG0X100.Z50.\nM30\n"
    ));
    ran.check(&[(-0.5, &[(0.0, 20.0)]), (-5.9, &[(0.0, 20.0)]), (-6.1, &[(0.0, 44.0)])]);
    // The contour of G72 reverses towards the face: 0.1 and 0.2 mm remain.
    let ran = run(
        "O1\nG21G99\nT0101M3S800\nG0X85.Z2.\nG72W2.R1.\nG72P70Q100U0.2W0.1F0.25\nN70G0Z-10.\nN80G1X40.\nN90Z-5.\n\
         N100X80.\nG0X100.Z50.\nM30\n",
    );
    let part = ran.simulation.finished().expect("a part");
    assert!(part.radii(-11.0).first().is_some_and(|material| material.1 > 40.0), "{:?}", part.radii(-11.0));
    assert!(part.radii(-22.0).first().is_some_and(|material| material.1 > 40.0), "{:?}", part.radii(-22.0));
}

/// A drill of 10 mm drills to Z-56 and moves 2.5 mm off the axis down to Z-28: a hole of 15 mm there.
#[test]
fn a_drill_that_is_fed_off_the_axis_makes_a_larger_hole() {
    let ran = run(
        "O1(STOCK D=60 LENGTH=98)\nG21G99\nT0202(DRILL 10)\nG97S800M3\nG0X0Z2.\nG74R1.\nG74Z-56.Q5000F0.1\nG0Z0\n\
         G1X5.F0.1\nZ-28.\nG0Z2.\nG0X100.Z100.\nM30\n",
    );
    ran.check(&[(-10.0, &[(15.0, 60.0)]), (-40.0, &[(10.0, 60.0)]), (-57.0, &[(0.0, 60.0)])]);
}

/// A tool that cuts straight in, and again after C has turned by 180°, makes two holes, not a groove.
#[test]
fn cross_holes_are_no_groove() {
    let turned = "O1\nG21G99\nT0101\nG97S800M3\nG0X85.Z2.\nG1X80.F0.2\nZ-60.\nG0X90.Z50.\nM5\n";
    let ways = [
        "G0X85.Z-18.\nM35\nG28H0\nG98G1X20.F100.\nG0X85.\nC180.\nG1X20.\nG0X85.\n",
        // Chamfered from both sides of the wall.
        "G0X85.Z-18.\nM35\nG28H0\nG98G1X76.F100.\nG4X0.5\nG0X70.\nG1X72.\nG4X0.5\nG0X85.\nC180.\nG1X76.\nG4X0.5\nG0X70.\nG1X72.\n\
         G4X0.5\nG0X85.\n",
    ];
    for way in ways {
        for tool in ["T0707", "T0707 (LIVE DRILL)", "T0707 (DEBURR CROSS HOLES)"] {
            let ran = run(&format!("{turned}{tool}\nG97S4000M3P12\n{way}M5P12\nM34\nG0X150.Z150.\nM30\n"));
            ran.check(&[(-10.0, &[(0.0, 80.0)]), (-17.0, &[(0.0, 80.0)]), (-59.0, &[(0.0, 80.0)])]);
            let holes = way == ways[0];
            assert!(!holes || ran.told.contains(&"cross-holes-left-out"), "{tool}: {:?}", ran.told);
        }
    }
    // Without C in between they are grooves.
    let groove = run(&format!(
        "{turned}T0303\nM3S500\nG0X85.Z-18.\nG1X60.F0.1\nG0X85.\nZ-30.\nG1X60.\nG0X85.\nZ150.\nM30\n"
    ));
    groove.check(&[(-17.0, &[(0.0, 60.0)]), (-29.0, &[(0.0, 60.0)]), (-40.0, &[(0.0, 80.0)])]);
    assert!(!groove.told.contains(&"cross-holes-left-out"), "{:?}", groove.told);
}

/// An insert of 35° leaves a cone of 5.9 mm on the face at Z-3.24, which is not connected to the part.
#[test]
fn a_cone_that_facing_leaves_falls_off() {
    let ran = run(
        "O1(STOCK D=118 LENGTH=60)\nG21G99\nT0101M3S800\nG0X138.Z25.\nZ-1.803\nX118.11\nG1X110.824F0.127\nX107.95Z-3.24\n\
         X-1.6\nX1.274Z-1.803\nG0X138.\nZ25.\nM30\n",
    );
    ran.check(&[(-0.5, &[]), (-2.0, &[]), (-3.3, &[(0.0, 118.0)])]);
    // A thin ring that is parted off stays.
    let ring = run(
        "O1(STOCK D=40 LENGTH=60)\nG21G99\nT0101(PARTING W=3)\nG97S1000M3\nG0X44.Z-5.\nG1X-1.F0.1\nG0X60.\nZ50.\nM30\n",
    );
    assert_eq!(ring.simulation.finished().expect("a part").pieces().count(), 2);
}

/// A groove from Z-31.5 to Z-28.5, approached along the work at feed instead of G00.
#[test]
fn a_groove_approached_by_a_feed_is_one_of_a_grooving_tool() {
    let turned = "O1\nG21G99\nT0101M3S800\nG0X52.Z2.\nX40.\nG1Z-32.F0.2\nX45.\nZ-60.\nX52.\nG0X60.Z20.\n";
    for approach in ["G0X50.Z2.\nG1Z-31.5F0.3\n", "G0X50.Z-31.5\n"] {
        let ran = run(&format!("{turned}T0202M3S600\n{approach}G1X35.F0.1\nX50.\nG0X100.Z50.\nM30\n"));
        ran.check(&[
            (-28.0, &[(0.0, 40.0)]),
            (-29.0, &[(0.0, 35.0)]),
            (-31.0, &[(0.0, 35.0)]),
            (-31.8, &[(0.0, 40.0)]),
            (-40.0, &[(0.0, 45.0)]),
        ]);
        assert!(!ran.told.contains(&"tool-unknown"), "{:?}", ran.told);
    }
}

/// The grooves of a tool are cut outwards, and so is its retract: it works in a bore.
#[test]
fn a_tool_whose_grooves_go_outwards_bores() {
    let ran = run(
        "O1\nG21G99\nT0101\nG97S400M3\nG0X52.Z2.\nG1Z-22.5F2.\nX53.5F0.3\nG75R0.05\nG75Z-30.5X57.05P200Q2500F0.04\n\
         G1Z-21.45F0.3\nM30\n",
    );
    let part = ran.simulation.finished().expect("a part");
    for (z, bore) in [(-10.0, 26.0), (-28.0, 28.525)] {
        let material = part.radii(z);
        assert!(
            material.len() == 1 && (material[0].0 - bore).abs() < 0.02 && material[0].1 > 28.6,
            "{z}: {material:?}"
        );
    }
}

/// A drill of Ø25 with its edge at X-25 or X25 makes a hole of Ø25 with a flat bottom. A boring bar then widens it.
#[test]
fn a_drill_is_led_by_its_edge() {
    let turned = "O1\nG21G99\nT0101(OD TURN)\nG97S1000M3\nG0X56.Z1.\nX50.\nG1Z-30.F0.2\nX56.\nG0X60.Z50.\n";
    for (comment, x) in [("25 MM INSERT DRILL", "-25."), ("DRILL D25", "25."), ("INSERT DRILL", "-25.")] {
        let drilled = format!("{turned}T0202({comment})\nG97S1400M3\nG0X{x}Z1.\nG1Z-20.F0.1\nG0Z50.\n");
        let solid = run(&format!("{drilled}M30\n"));
        solid.check(&[(-10.0, &[(25.0, 50.0)]), (-19.9, &[(25.0, 50.0)]), (-20.1, &[(0.0, 50.0)])]);
        assert!(!solid.told.contains(&"tool-unknown"), "{comment}: {:?}", solid.told);
        let bored =
            run(&format!("{drilled}T0303(BORING BAR)\nG0X28.Z1.\nG1Z-15.F0.1\nX25.\nG0Z1.\nZ50.\nM30\n"));
        bored.check(&[(-10.0, &[(28.0, 50.0)]), (-16.0, &[(25.0, 50.0)]), (-20.1, &[(0.0, 50.0)])]);
    }
    // A diameter other than that of the drill is not its edge.
    let wrong = run(&format!("{turned}T0202(DRILL D10)\nG97S1400M3\nG0X40.Z1.\nG1Z-20.F0.1\nG0Z50.\nM30\n"));
    wrong.check(&[(-10.0, &[(0.0, 40.0)])]);
}

/// Two drills of unknown diameter before a boring bar that begins at X7.8: neither hole is larger.
#[test]
fn no_assumed_drill_is_larger_than_the_bore_after_it() {
    let ran = run(
        "O1\nG21G99\nT0101\nG97S800M3\nG0X0.Z3.\nG1Z-15.F0.1\nG0Z30.\nT0303\nG0X0.Z3.\nG1Z-18.F0.1\nG0Z30.\nT0202\n\
         G0X7.8Z2.\nG1Z-6.7F0.1\nX6.8\nG0Z30.\nT0404\nG0X22.Z1.\nX20.\nG1Z-30.\nX22.\nG0Z30.\nM30\n",
    );
    let part = ran.simulation.finished().expect("a part");
    for z in [-5.0, -10.0] {
        let material = part.radii(z);
        assert!(material.len() == 1 && material[0].0 <= 3.91, "{z}: {material:?}");
        assert!((material[0].1 - 10.0).abs() < 0.02, "{z}: {material:?}");
    }
}

/// Outside Ø9.65 to Z-13 on a bar of Ø25.1, in it a bore of Ø3.7 to Z-7.7 with an undercut of Ø4.6 to Z-9,
/// made by a tool that returns at Ø3.7: outside it would hit the undercut.
#[test]
fn a_tool_that_comes_back_within_its_cuts_bores() {
    let pin = "O1\nG21G40G99\nT0505\nG97S750M3\nG0X25.1Z3.\nX9.65\nG1Z-13.F.1\nX25.1\nG0Z30.\n";
    let undercut = run(&format!(
        "{pin}T0707\nG97S300M3\nG0X3.7Z30.\nZ1.\nG1Z-7.7F2.5\nX4.1Z-7.9F.04\nZ-9.\nX4.6\nZ-8.55\nX3.7F.3\nZ1.F3.\nG0Z30.\nM30\n"
    ));
    undercut.check(&[(-5.0, &[(3.7, 9.65)]), (-8.8, &[(4.6, 9.65)]), (-12.0, &[(3.7, 9.65)])]);
    // A drilled bore whose bottom is faced to Ø1.8 by the tool, which then retracts through it at rapid.
    let bore = run(&format!(
        "{pin}T0909(2.0 DRILL)\nG97S800M3\nG0X0Z3.\nG1Z-9.5F.1\nG0Z30.\nT0606\nG97S350M3\nG0X4.897Z30.\nZ1.\nG1Z0F.1\n\
         X4.Z-1.673F.03\nZ-4.8F.1\nX1.8\nG0Z3.\nZ30.\nM30\n"
    ));
    bore.check(&[(-3.0, &[(4.0, 9.65)]), (-6.0, &[(2.0, 9.65)]), (-12.0, &[(0.0, 9.65)])]);
    // The bottom of a raw hole: Ø24.7 to Z-18, and Ø19.9 from Z-21.6 on.
    let tube = run(
        "O1\nG21G40G99\nT0202\nG97S900M3\nG0X49.Z2.\nX40.\nG1Z-24.F.1\nX49.\nG0Z2.\nT0404\nG97S1700M3\nG0Z2.\nX20.\n\
         G1Z-20.5F1.\nX24.7F.1\nZ-18.\nX26.Z-19.4\nZ-21.05\nX19.9Z-21.6\nZ-22.8\nG0Z5.\nM30\n",
    );
    tube.check(&[(-10.0, &[(20.0, 40.0)]), (-20.0, &[(26.0, 40.0)]), (-22.5, &[(19.9, 40.0)])]);
}

/// An outside tool that does not retract before its rapid is still an outside tool.
#[test]
fn a_tool_alone_that_runs_into_its_own_cuts_does_not_bore() {
    let ran = run("O1\nG21G99\nT0101\nG97S800M3\nG0X52.Z2.\nX40.\nG1Z-20.F0.2\nX30.Z-30.\nG0Z50.\nM30\n");
    ran.check(&[(-10.0, &[(0.0, 40.0)])]);
}

/// A boring bar centres the face: from X0.1 Z-1 at 45 degrees out to X5.1 Z1.5. At Z0 the countersink has
/// Ø2.1.
#[test]
fn a_cut_from_the_axis_to_the_front_is_a_countersink() {
    let ran = run(
        "O1\nG21G40G99\nT0101\nG97S250M3\nG0X0.1Z30.\nZ2.\nG1Z-1.F.06\nX5.1Z1.5\nG0Z30.\nT0505\nG97S750M3\nG0X25.1Z3.\n\
         X7.93\nG1Z-9.5F.1\nX25.1\nG0Z30.\nM30\n",
    );
    ran.check(&[(-5.0, &[(0.0, 7.93)])]);
    let part = ran.simulation.finished().expect("a part");
    let material = part.radii(-0.5);
    assert!(material.len() == 1 && (material[0].0 - 0.55).abs() < 0.1, "{material:?}");
}

/// A ring groove in the face, inner corner at X40, 3 mm wide and 5 mm deep: a comment names the tool.
#[test]
fn a_face_groove_is_one_by_its_comment() {
    let ran = run(
        "O1\nG21G99\nT0101\nG97S660M3\nG0X62.Z0.\nG1X-1.F.1\nG0Z10.\nT1010(FACE GROOVE 3MM)\nG97S550M3\nG0X40.Z1.\n\
         G1Z-5.F.05\nG0Z1.\nZ10.\nM30\n",
    );
    ran.check(&[(-2.0, &[(0.0, 40.0), (46.0, 62.0)]), (-6.0, &[(0.0, 62.0)])]);
}

/// The only tool on the side of -X only goes straight in and back, with chip breaking: a drill positioned by
/// its edge.
#[test]
fn a_tool_alone_on_the_negative_side_that_only_goes_straight_in_drills() {
    let ran = run(
        "O1\nG21G99\nT0101\nG97S800M3\nG0X62.Z0.\nG1X-1.F.1\nG0Z1.\nX60.\nG1Z-50.F.2\nX62.\nG0Z10.\nT0404\nG97S2000M3\n\
         G0X-20.6\nZ1.\nG1Z-8.F.15\nZ-7.8\nZ-20.\nZ-19.8\nZ-33.\nG0Z50.\nM30\n",
    );
    ran.check(&[(-10.0, &[(20.6, 60.0)]), (-32.9, &[(20.6, 60.0)]), (-34.0, &[(0.0, 60.0)])]);
}

/// A bore of Ø14 to Z-25 in a hole to Z-30: the drill before it was smaller.
#[test]
fn an_assumed_drill_leaves_something_for_the_bore() {
    let ran = run(
        "O1\nG21G99\nT0606(DRILL)\nG97S900M3\nG0X0Z2.\nG1Z-30.F0.1\nG0Z2.\nT0505\nG0X14.Z2.\nG1Z-25.F0.1\nG0X0\nZ2.\nM30\n",
    );
    let part = ran.simulation.finished().expect("a part");
    let (bore, hole) = (part.radii(-10.0), part.radii(-26.0));
    assert!((bore[0].0 - 7.0).abs() < 0.01, "{bore:?}");
    assert!(hole[0].0 > 3.0 && hole[0].0 < 6.9, "{hole:?}");
}

/// A grooving insert of 4 mm that the program positions by its right corner: the groove is from Z-15 to Z-11,
/// the piece ends at Z-50.
#[test]
fn a_comment_names_the_right_corner_of_a_grooving_insert() {
    let turned =
        "O1\nG21G99\nT0101\nG97S800M3\nG0X42.Z0.\nG1X-1.F.1\nG0Z2.\nX36.\nG1Z-60.F.2\nX42.\nG0Z20.\n";
    for (comment, groove) in [("TRONZADO 4MM, PUNTO = ESQUINA DERECHA", -14.9), ("TRONZADO 4MM", -7.1)] {
        let ran = run(&format!(
            "{turned}T0909({comment})\nG0X40.Z-11.\nG1X20.F.1\nG0X40.\nZ-50.\nG1X-1.\nG0X60.\nZ20.\nM30\n"
        ));
        ran.check(&[(groove, &[(0.0, 20.0)])]);
    }
}
