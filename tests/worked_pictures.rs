//! Parts in the picture where the program alone determines what is cut: finishing that starts inside the
//! contour, drills beside the axis, holes of live tools, parts that are turned around. The expected parts are
//! calculated by hand.
use crate::ran::run;

const OUTSIDE: &str = "T0101\nG97S800M3\nG0X52.Z2.\nX40.\nG1Z-30.F.2\nX52.\nG0X100.Z100.\n";

/// The contour is roughed from outside and finished: wherever G70 starts, the bar stays solid.
#[test]
fn finishing_is_on_the_side_of_roughing() {
    let contour = "N10G0X20.\nG1Z-30.\nX38.\nZ-60.\nN20X52.\n";
    for roughing in [
        format!("G0X52.Z2.\nG71U1.5R.5\nG71P10Q20U.3W.1F.2\n{contour}"),
        format!("G0X52.Z2.\nG73U10.W2.R4\nG73P10Q20U.3W.1F.2\n{contour}"),
    ] {
        for start in ["X20.Z2.", "X0.Z5.", "X52.Z2."] {
            let ran = run(&format!(
                "O1\nG21G99\nT0101\nG97S800M3\n{roughing}G0X100.Z50.\nT0202\nG0{start}\nG70P10Q20F.1\nG0X100.Z50.\nM30\n"
            ));
            ran.check(&[(-15.0, &[(0.0, 20.0)]), (-45.0, &[(0.0, 38.0)])]);
            let stock = ran.stock;
            assert!(stock.bore.mm() == 0.0 && stock.diameter.mm() < 60.0, "{start}: {stock:?}");
        }
    }
    // A bore stays a bore, although G70 starts at X60.
    let bore = "G0X18.Z2.\nG71U1.R.5\nG71P10Q20U-.3W.1F.2\nN10G0X40.\nG1Z-20.\nX30.\nZ-40.\nN20X18.\n";
    for start in ["X18.Z2.", "X60.Z2."] {
        let ran = run(&format!(
            "O1\n(STOCK D=70 BORE=18 LENGTH=60)\nG21G99\nT0303\nG97S800M3\n{bore}G0Z50.\nX100.\nT0404\nG0{start}\nG70P10Q20F.1\nG0Z50.\nM30\n"
        ));
        ran.check(&[(-10.0, &[(40.0, 70.0)]), (-30.0, &[(30.0, 70.0)]), (-50.0, &[(18.0, 70.0)])]);
    }
}

/// A drill in a hole cycle slightly off the axis makes a hole on the axis, and the same tool bores it.
#[test]
fn an_indexable_drill_off_the_axis_makes_a_hole() {
    for hole in ["G83X1.8Z-25.R2.Q5000F.05\nG80\n", "G74R.5\nG74Z-25.Q5000F.05\n"] {
        let ran = run(&format!(
            "O1\nG21G99\n{OUTSIDE}T0707\nG97S1700M3\nG0X1.8Z5.\n{hole}G0Z5.\nG0X30.Z2.\nG1Z-20.F.1\nG0X20.\nZ100.\nM30\n"
        ));
        ran.check(&[(-10.0, &[(30.0, 40.0)])]);
        let bottom = ran.simulation.finished().expect("a part").radii(-24.0);
        assert!(bottom.len() == 1 && bottom[0].0 > 0.0, "{bottom:?}");
        assert!(!ran.tells("live-tool-stopped"), "{:?}", ran.told);
    }
    // Farther from the axis it is a live tool.
    let beside = run(&format!(
        "O1\nG21G99\n{OUTSIDE}T0707\nG97S1700M3\nG0X20.Z5.\nG83X20.Z-25.R2.Q5000F.05\nG80\nG0Z5.\nM30\n"
    ));
    beside.check(&[(-10.0, &[(0.0, 40.0)])]);
    assert!(beside.tells("live-tool-stopped"), "{:?}", beside.told);
}

/// A face groove beside the axis is a groove if the comment says so: an insert of 3 mm from X0 to X4 leaves
/// ⌀10 with a flat bottom.
#[test]
fn a_face_groove_beside_the_axis_is_no_hole() {
    let program = |tool: &str| {
        format!(
            "O1\n(STOCK D=50 LENGTH=80)\nG21G99\nT0202{tool}\nG97S800M3\nG0X4.Z2.\nG74R.5\nG74X0Z-5.P1000Q2000F.05\nG0Z50.\nM30\n"
        )
    };
    run(&program("(GROOVE FACE)")).check(&[(-4.0, &[(10.0, 50.0)]), (-5.1, &[(0.0, 50.0)])]);
    // A drill of ⌀10 with a point of 118°: 1 mm above its tip it has a radius of tan 59° = 1.664.
    let drilled = run(&program("(DRILL)")).simulation.finished().expect("a part").radii(-4.0);
    assert!(drilled.len() == 1 && drilled[0].0 < 4.5, "{drilled:?}");
}

/// An indexable drill off the axis is no evidence of the bar size.
#[test]
fn a_hole_off_the_axis_defines_no_bar() {
    for start in ["0", "2."] {
        let ran = run(&format!(
            "O1\nG21G99\nT0202(U DRILL D25)\nG97S800M3\nG0X{start}Z2.\nG74R.5\nG74Z-30.Q5000F.05\nG0Z50.\nM30\n"
        ));
        let stock = ran.stock;
        assert!(stock.diameter.mm() > 25.0, "{start}: {stock:?}");
    }
}

/// Holes drilled by a live tool beside the axis leave no ring: with G01 along X or Z, identified by a comment
/// or by C.
#[test]
fn holes_of_live_tools_leave_no_ring() {
    let radial = "G0Z-20.X60.\nC0\nG1X30.F.1\nG0X60.\nC180.\nG1X30.F.1\nG0X60.\n";
    let last_diagonal = "G0Z-20.X60.\nG1X30.F.1\nG0X60.\nZ-20.\nG1X30.F.1\n";
    let slot = "G0Z-20.X60.\nC90.\nG1X34.F.1\nZ-15.\nX60.\n";
    let axial = "G0X24.Z2.\nC0\nG1Z-10.F.1\nG0Z2.\nC180.\nG1Z-10.F.1\nG0Z2.\n";
    for (tool, way) in [
        ("T0606(LIVE DRILL 8MM)", radial),
        ("T0606(DRILL D8)", radial),
        ("T0606(DRILL D8)", last_diagonal),
        ("T0606(FRESA D8)", slot),
        ("T0606(ENDMILL D8)", radial),
        ("T0606", radial),
        ("T0606(LIVE DRILL 8MM)", axial),
        ("T0606", axial),
    ] {
        let ran = run(&format!("O1\nG21G99\n{OUTSIDE}M5\n{tool}\nG97S2500M13\n{way}G0X100.Z100.\nM5\nM30\n"));
        ran.check(&[(-5.0, &[(0.0, 40.0)]), (-18.5, &[(0.0, 40.0)]), (-20.5, &[(0.0, 40.0)])]);
    }
    // The same path with the turning spindle, without C and comment, is a groove of 3 mm.
    let groove =
        run(&format!("O1\nG21G99\n{OUTSIDE}T0606\nG97S500M3\nG0Z-20.X60.\nG1X30.F.1\nG0X60.\nG0Z50.\nM30\n"));
    groove.check(&[(-18.5, &[(0.0, 30.0)])]);
}

/// Blocks after a stop at which the part is turned around machine the other end: this is reported, and not
/// cut into the first end.
#[test]
fn the_other_end_is_not_cut_into_the_first() {
    let second = "T0101\nG97S800M3\nG0X30.Z2.\nG1Z-12.F.2\nX52.\nG0X100.Z100.\nM30\n";
    let first: &[(f64, &[(f64, f64)])] = &[(-6.0, &[(0.0, 40.0)]), (-20.0, &[(0.0, 40.0)])];
    for stop in [
        "M5\nM00(FLIP PART)\n",
        "M0 (TURN PART AROUND)\n",
        "(FLIP PART)\nG28U0W0\nM00\n",
        "M00\n\n(SECOND SIDE)\n",
        "M01 (FLIP)\n",
        "M00 (OP20)\n",
        "M00 (wenden)\n",
        "M00 (TEIL UMSPANNEN)\n",
        "M00 (调头)\n",
        "M00 (掉头装夹)\n",
        "M00 (Перевернуть деталь)\n",
        "M00 (retourner la piece)\n",
        "M00 (virar a peça)\n",
        "M00 (dar vuelta la pieza)\n",
        "M00 (FLIP PART, CHANGE TOOL)\n",
        "M00 (OTHER SIDE OF THE PART)\n",
        "M00 (SIDE 2)\n",
    ] {
        let ran = run(&format!("O1\nG21G99\n{OUTSIDE}{stop}{second}"));
        ran.check(first);
        assert!(ran.tells("work-zero-unknown"), "{stop}: {:?}", ran.told);
    }
    // Another operation on the same end.
    for stop in [
        "M00\n",
        "M01 (OP2 FINISH)\n",
        "M00\n(OP 2, FINISHING)\n",
        "M00 (CHECK SIZE)\n",
        "M00 (FLIP INSERT)\n",
        "(TURN PART)\nG1X60.F.2\nM00\n",
        "(FLIP PART AFTERWARDS)\n",
        "M00 (DO NOT FLIP PART)\n",
        "M00 (НЕ ПЕРЕВОРАЧИВАТЬ, НЕ ПЕРЕВЕРНУТЬ)\n",
        "M01\n(FACE SIDE 2.5 DEEP)\n",
        "M00 (FACE SIDE 2.5 DEEP)\n",
        "M00 (SIDE 25 LONG)\n",
        "M01\n(GROOVE SIDE 2)\n",
        "M00\nT0303 (FINISH OTHER END OF GROOVE)\n",
        "M00\nT0303 (FINISH 2ND END)\n",
        "M00 (OTHER SIDE OF SHOULDER)\n",
        "M01\n(OTHER SIDE OF SHOULDER)\n",
        "M00\n(FLIP CHIP CONVEYOR ON)\n",
        "M00\n(GIRARE MANDRINO)\n",
        "M00\n(RETOURNER AU ZERO)\n",
        "M00\n(ПЕРЕУСТАНОВКА РЕЗЦА)\n",
        "M00\n(反面刀)\n",
        "M00 (PLATTE WENDEN)\n",
    ] {
        let ran = run(&format!("O1\nG21G99\n{OUTSIDE}{stop}{second}"));
        ran.check(&[(-6.0, &[(0.0, 30.0)]), (-20.0, &[(0.0, 40.0)])]);
        assert!(!ran.tells("work-zero-unknown"), "{stop}: {:?}", ran.told);
    }
    // Before the first cut, the comment names the side to machine.
    run(&format!("O1\nG21G99\nM00(SECOND SIDE)\n{OUTSIDE}M30\n")).check(&[(-20.0, &[(0.0, 40.0)])]);
}

/// A rapid into a turned surface is reported although the blank is inferred: ⌀44 remains from Z-50 to Z-70
/// with any bar.
#[test]
fn a_rapid_into_a_turned_surface_is_reported() {
    let shaft =
        "O1\nG21G99\nT0101\nG97S800M3\nG0X52.Z2.\nX36.\nG1Z-50.F.2\nX44.\nZ-70.\nX52.\nG0X100.Z100.\n";
    let blade = "T0303\nG97S600M3\nG0X40.Z-40.\nG1X30.F.05\n";
    for (way, is_reported) in [
        // Along the wall of the groove into the step.
        ("G0X37.\nZ-56.\nX100.\n", true),
        // Straight in.
        ("G0X50.\nZ-60.\nX40.\nX100.\n", true),
        // Above the step.
        ("G0X46.\nZ-56.\nX100.\n", false),
        ("G0X37.\nZ-45.\nX100.\n", false),
        ("G0X100.\nZ-56.\nX45.\n", false),
        // On the chuck side of all cuts the bar may be thinner.
        ("G0X60.\nZ-90.\nX40.\nX100.\n", false),
        // There may be another part in the chuck.
        ("G0X100.\nM00\nX37.Z-40.\nZ-56.\nX100.\n", false),
        // Into the groove that was cut, and out of it.
        ("G0X50.\nX31.\nX100.\n", false),
    ] {
        let ran = run(&format!("{shaft}{blade}{way}G0X100.Z100.\nM30\n"));
        assert_eq!(ran.tells("rapid-through-stock"), is_reported, "{way}: {:?}", ran.told);
    }
    // Between two turned sections, from the rear one into the wall at the end of the front one.
    let between = |way: &str| {
        format!(
            "O1\nG21G99\nT0505\nG97S800M3\nG0X92.Z8.\nG1X78.F.2\nZ-18.\nX84.\nG0X96.\nZ-42.\nG1X74.\nZ-58.\n{way}M30\n"
        )
    };
    assert!(run(&between("G0X120.Z120.\n")).tells("rapid-through-stock"));
    assert!(!run(&between("G0X120.\nZ120.\n")).tells("rapid-through-stock"));
    // Into a fillet: at Z-53 it has a diameter of 44 - 2√7 = 38.7.
    let fillet = |z: &str| {
        format!(
            "O1\nG21G99\nT0101\nG97S800M3\nG0X52.Z2.\nX36.\nG1Z-50.F.2\nG2X44.Z-54.R4.\nG1Z-70.\nX52.\nG0X100.Z100.\nX36.Z-46.\nZ{z}\nX100.\nM30\n"
        )
    };
    assert!(run(&fillet("-54.")).tells("rapid-through-stock"));
    assert!(!run(&fillet("-50.5")).tells("rapid-through-stock"));
    // The first passes of G73 are outside of the bar: the wall at Z-36 goes from ⌀24 to ⌀30.
    let pattern = "O1\nG21G40G98\nT0100\nM3S1000\nG0X60.Z100.\nG73U6.W0R3F100\nG73P10Q20U0.5W0\nN10G0X12.Z10.\nG1Z0\nX24.Z-10.\nZ-36.\nN20G0X30.\nG70P10Q20F50\nG0X60.Z100.\nT0303\nG0X27.Z-38.\nG1X2.F20\nG0X46.\nZ150.\nM30\n";
    assert!(!run(pattern).tells("rapid-through-stock"));
    // Through the wall at the end, 1 mm deep.
    let end = |z: &str| {
        format!(
            "O1\nG21G99\nT0404\nG97S800M3\nG0X15.Z1.\nG1Z-52.F.2\nX22.\nG0Z50.\nT0808\nG0X15.Z3.\nZ{z}\nG1X10.F.1\nG0X50.\nM30\n"
        )
    };
    assert!(run(&end("-53.")).tells("rapid-through-stock"));
    assert!(!run(&end("-52.")).tells("rapid-through-stock"));
}
