//! How a control carries out a block, calculated by hand from manuals and geometry, for cases that are easily
//! misunderstood. Each test cites the manual or shows the calculation.
use gcode_playground::analyze;
use gcode_playground::geometry::Point;
use gcode_playground::motion::{Cycle, Motion, MotionKind};
use gcode_playground::playback::timing::seconds;
use gcode_playground::setup::Setup;
use gcode_playground::units::Diameter;

struct Ran {
    motions: Vec<Motion>,
    /// Slugs and line numbers, counted from 1.
    told: Vec<String>,
    setup: Setup,
}

fn run(setup: &str, text: &str) -> Ran {
    let setup = Setup::from_json(setup).expect("a setup");
    let analysis = analyze(text.as_bytes(), &setup);
    let line = |byte: u32| text[..byte as usize].matches('\n').count() + 1;
    let told = analysis.diagnostics.iter();
    Ran {
        told: told.map(|told| format!("{} {}", told.message.slug(), line(told.span.start))).collect(),
        motions: analysis.motions.iter().collect(),
        setup,
    }
}

impl Ran {
    /// The leads of the thread passes, in thousandths of a mm.
    fn leads(&self) -> Vec<i64> {
        let passes = self.motions.iter().filter(|motion| motion.kind == MotionKind::Thread);
        passes.map(|pass| (1000.0 * pass.lead.expect("a lead")).round() as i64).collect()
    }

    /// Kind, diameter and Z of the end of each motion.
    fn moves(&self) -> Vec<(MotionKind, f64, f64)> {
        let place = |motion: &Motion| (motion.kind, Diameter::from_radius(motion.to.x).mm(), motion.to.z);
        self.motions.iter().map(place).collect()
    }

    /// Seconds of the last cut, to a tenth.
    fn seconds_of_last_cut(&self) -> Option<f64> {
        let cut = self.motions.iter().rev().find(|motion| motion.kind.cuts()).expect("a cut");
        seconds(cut, &self.setup.machine).map(|seconds| (10.0 * seconds).round() / 10.0)
    }
}

/// FANUC B-64604EN, G92: "F or E: lead of the thread"; both are modal. 0.0714286 inch are 1.814 mm.
#[test]
fn the_lead_by_e_holds_for_the_passes_after_it() {
    let head = "G97 S500 M3\nG00 X34 Z8\nG01 X33 F0.254\nG00 Z8\n";
    let ran = run("{}", &format!("{head}G92 X29.2 Z-20 E1.5\nX28.6\nG92 X28.2\nG00 X40\nM30\n"));
    assert_eq!((ran.leads(), ran.told), (vec![1500; 3], vec![]));
    // A new F cancels it, even if it is a feed between the threads.
    let ran = run("{}", &format!("{head}G92 X29.2 Z-20 E1.5\nX28.6 F2\nX28.2\nG00 X40\nM30\n"));
    assert_eq!(ran.leads(), [1500, 2000, 2000]);
    let ran =
        run("{}", &format!("{head}G00 X29.2\nG32 Z-20 E1.5\nG00 X34\nZ8\nX28.6\nG32 Z-20\nG00 X40\nM30\n"));
    assert_eq!((ran.leads(), ran.told), (vec![1500; 2], vec![]));
    let inch = "G20\nG97 S500 M3\nG00 X1.2 Z.3\nG92 X.95 Z-.5 E.0714286\nX.93\nX.92\nG00 X2.\nM30\n";
    assert_eq!(run("{}", inch).leads(), [1814; 3]);
    // The feed is that of F: E is only a lead.
    let ran = run("{}", &format!("{head}G92 X29.2 Z-20 E1.5\nG00 X40\nG01 X39 F0.1\nZ-5\nM30\n"));
    assert_eq!(ran.seconds_of_last_cut(), Some(15.6), "13 mm at 0.1 mm and 500 turns a minute");
}

/// FANUC B-64304EN, "Feed of linear interpolation with a rotary axis": one degree counts as one mm.
#[test]
fn degrees_of_c_count_as_millimetres_of_the_feed() {
    let head = "M45\nG28 H0\nG98\nG00 X40 Z5 C0\n";
    // C alone: 90° at 360 degrees per minute.
    let ran = run("{}", &format!("{head}G01 C90 F360\nM46\nM30\n"));
    assert_eq!(ran.seconds_of_last_cut(), Some(15.0));
    // 15 mm and 90°: √(15² + 90²) = 91.24 at 100 per minute are 54.7 s.
    let ran = run("{}", &format!("{head}G00 C90\nG01 Z-10 C180 F100\nM46\nM30\n"));
    assert_eq!(ran.seconds_of_last_cut(), Some(54.7));
    let ran = run("{}", &format!("{head}G01 H-45 F90\nM46\nM30\n"));
    assert_eq!(ran.seconds_of_last_cut(), Some(30.0));
    // With G99, 0.2 per revolution at 500 rpm is 100 per minute: 90° and 91.24.
    let head = head.replace("G98", "G99 G97 S500 M03");
    let ran = run("{}", &format!("{head}G01 C90 F0.2\nM46\nM30\n"));
    assert_eq!(ran.seconds_of_last_cut(), Some(54.0));
    let ran = run("{}", &format!("{head}G00 C90\nG01 Z-10 C180 F0.2\nM46\nM30\n"));
    assert_eq!(ran.seconds_of_last_cut(), Some(54.7));
}

/// FANUC B-64304EN-1, boring cycles of systems B and C: G85 retracts at feed, G86 at rapid with the spindle
/// stopped.
#[test]
fn g86_leaves_the_hole_at_rapid_and_g85_at_feed() {
    let hole = |code: &str| {
        let text = format!("G90 G98 G95 G97 S500 M3\nG00 X0 Z5\n{code} Z-20 R2 F0.1\nG80\nM30\n");
        run(r#"{"dialect": {"gSystem": "B"}}"#, &text).moves()
    };
    let (rapid, feed) = (MotionKind::Rapid, MotionKind::Feed);
    let begin = [(rapid, 0.0, 5.0), (rapid, 0.0, 2.0), (feed, 0.0, -20.0)];
    assert!(hole("G86").ends_with(&[begin[1], begin[2], (rapid, 0.0, 5.0)]), "{:?}", hole("G86"));
    assert!(
        hole("G85").ends_with(&[begin[1], begin[2], (feed, 0.0, 2.0), (rapid, 0.0, 5.0)]),
        "{:?}",
        hole("G85")
    );
}

/// FANUC B-64304EN-1: G81 and G82 drill in one cut; Q is only a word of G83 (and G87).
#[test]
fn a_peck_of_g83_is_none_of_g81() {
    let cuts = |blocks: &str| {
        let text = format!("G90 G98 G95 G97 S500 M3\nG00 X0 Z5\n{blocks}\nG80\nM30\n");
        let ran = run(r#"{"dialect": {"gSystem": "B"}}"#, &text);
        ran.motions.iter().filter(|motion| motion.kind.cuts()).count()
    };
    // 22 mm in pecks of 5 mm: five cuts.
    assert_eq!(cuts("G83 Z-20 R2 Q5000 F0.1"), 5);
    // From R2 to Z-30 in one cut.
    assert_eq!(cuts("G83 Z-20 R2 Q5000 F0.1\nG81 Z-30"), 6);
    assert_eq!(cuts("G83 Z-20 R2 Q5000 F0.1\nG82 Z-30 P500"), 6);
    // G83 uses its Q again.
    assert_eq!(cuts("G83 Z-20 R2 Q5000 F0.1\nG81 Z-30\nG83 Z-20"), 11);
}

/// A thread of n turns by G34 is F·n + K·n²/2 long (FANUC B-64304EN, G34). At 300 rpm, over 44 mm from F2:
/// K0.1 gives n = 15.777, 3.155 s; K-0.04 gives 32.68, 6.536 s; K0 gives 22, 4.4 s.
#[test]
fn the_time_of_g34_follows_the_changing_lead() {
    let time = |k: &str| {
        let text = format!("G97 S300 M3\nG00 X30 Z4\nG34 Z-40 F2 {k}\nG00 X40\nM30\n");
        let ran = run("{}", &text);
        let thread = ran.motions.iter().find(|motion| motion.kind == MotionKind::Thread).expect("a thread");
        (1000.0 * seconds(thread, &ran.setup.machine).expect("a time")).round() / 1000.0
    };
    assert_eq!((time("K0.1"), time("K-0.04"), time("K0.5"), time("")), (3.155, 6.536, 1.971, 4.4));
}

/// K repeats a hole (FANUC B-64304EN-1, G83 to G89), also in a later block: a count takes no decimal point.
#[test]
fn a_count_of_repeats_lacks_no_point() {
    let head = "M45\nG28 H0\nG98 G97 S500 M13\nG00 X60. Z-10. C0.\n";
    for repeat in ["W-5. K3", "G87 W-5. K3", "H30. K11"] {
        let text = format!(
            "{head}G87 X40. R-2. Q2000 F50.\n{repeat}\nG80\nG00 X80.\nG00 Z-12.5 C45.\nG01 X50. F30.\nX60.\nM46\nM30\n"
        );
        let ran = run("{}", &text);
        assert!(!ran.told.iter().any(|told| told.starts_with("point-missing")), "{repeat}: {:?}", ran.told);
    }
    // A centre without a point, after G80, is reported.
    let text = format!(
        "{head}G87 X40. R-2. Q2000 F50.\nG80\nG00 X80. Z2.5\nG01 X50. F30.\nG01 Z-2.5\nG03 X60. Z-7.5 I0. K-5\nG01 Z-12.5\nX62.\nM46\nM30\n"
    );
    let told = run("{}", &text).told;
    assert!(told.contains(&"point-missing 10".to_owned()), "{told:?}");
}

/// Such a code calls a macro of the machine builder (FANUC B-64304EN-1, G65 and codes that call macros): all
/// words of its block are arguments. The cut after it programs everything: 20 mm at 0.2 mm/rev and 500 rpm
/// are 12 s.
#[test]
fn words_beside_a_code_of_the_machine_are_arguments() {
    for code in ["G1461", "G114", "G200", "G333", "G399", "G411", "G600", "G900", "G103", "G110"] {
        let block = format!("{code} W1. D8. X50 Z-4. L1.25 H0.767 C2. P1.25 S2. T7 M1. M30 M8. F9");
        let text = format!(
            "T0101\nG97 G99 S500 M3\nG00 X30. Z2.\nG01 Z0 F.1\n{block}\nG01 X30. Z-20. F.2\nG00 X50.\nM30\n"
        );
        let ran = run("{}", &text);
        assert_eq!(ran.told, ["g-code-of-the-machine 5"], "{code}");
        let [.., before, cut, _] = ran.motions[..] else { panic!("{code}: {:?}", ran.motions) };
        assert_eq!(
            (before.to, cut.from, cut.to),
            (Point::new(15.0, 0.0), Point::new(15.0, 0.0), Point::new(15.0, -20.0))
        );
        assert_eq!((cut.process.tool, seconds(&cut, &ran.setup.machine)), ((1, 1), Some(12.0)), "{code}");
        // Without a code of group 01 the kind of move is unknown.
        let ran = run("{}", &text.replace("G01 X30. Z-20.", "X30. Z-20."));
        assert!(ran.motions[ran.motions.len() - 2].process.uncertain, "{code}");
    }
    // G43 is a tool length offset: only its H word makes no move.
    let ran = run("{}", "T0101\nG97 G99 S500 M3\nG43 H1 G00 X30. Z2.\nG01 Z-20. F.2\nM30\n");
    assert_eq!(ran.moves()[0], (MotionKind::Rapid, 30.0, 2.0));
    // Words beside an unknown M code take effect.
    let ran = run("{}", "G97 G99 S500 M3\nT01 M06\nG00 X30. Z2. M77\nG01 Z-20. F.2 T0202\nM30\n");
    assert_eq!(
        ran.motions.last().map(|cut| (cut.to, cut.process.tool)),
        Some((Point::new(15.0, -20.0), (2, 2)))
    );
}

/// I and K of a G40 block are the direction of a wall (FANUC 16-TC, 15.3.4), not a corner. With a nose of 0.8
/// mm and tip 3, the cut along X30 to Z-20 ends where the nose touches a wall that rises there: its tip is at
/// X30 Z-20. Without a wall the nose centre is beside the end, and the tip is 0.8 mm further, at Z-20.8.
#[test]
fn i_and_k_of_g40_name_a_wall() {
    let setup = r#"{"tools": {"T0101": {"type": "turning", "noseRadius": 0.8, "tip": 3}}}"#;
    let ends = |leave: &str| {
        let text = format!(
            "T0101\nG97 G99 S500 M3\nG00 X60. Z5.\nG42 G00 X30. Z2.\nG01 Z-20. F.2\n{leave}\nG00 X80. Z20.\nM30\n"
        );
        let ran = run(setup, &text);
        let cut = ran.motions.iter().find(|motion| motion.kind == MotionKind::Feed).expect("a cut");
        let rounded = |at: Point| ((1000.0 * at.x).round() / 1000.0, (1000.0 * at.z).round() / 1000.0);
        let after =
            ran.motions.iter().skip_while(|motion| motion.kind != MotionKind::Feed).nth(1).expect("a move");
        (rounded(cut.to), rounded(after.to), ran.told)
    };
    let at_wall = ((15.0, -20.0), (30.0, -20.0), vec![]);
    assert_eq!(ends("G40 G01 X60. Z-20. I10. K0."), at_wall);
    assert_eq!(ends("G40 G01 X60. Z-20. I10."), at_wall);
    assert_eq!(ends("G40 G00 X60. Z-20. I10. K0."), at_wall);
    assert_eq!(ends("G40 G01 X60. Z-20."), ((15.0, -20.8), (30.0, -20.0), vec![]));
    // Without a direction there is no wall.
    for none in ["I0", "I0 K0", "K0."] {
        assert_eq!(
            ends(&format!("G40 G01 X60. Z-20. {none}")),
            ((15.0, -20.8), (30.0, -20.0), vec![]),
            "{none}"
        );
    }
    // In a contour too: G71 ignores the wall together with the compensation, and G70 ends at the wall.
    let contour = |leave: &str| {
        let cycles = "G71 U2. R1.\nG71 P10 Q20 U0 W0 F.2";
        let text = format!(
            "T0101\nG97 G99 S500 M3\nG00 X60. Z5.\n{cycles}\nN10 G42 G00 X30.\nG01 Z-20. F.2\n{leave}\nG70 P10 Q20\nM30\n"
        );
        let ran = run(setup, &text);
        let motions = ran.motions.iter().map(|motion| (motion.cycle.map(|step| step.cycle), motion.to));
        (motions.collect::<Vec<_>>(), ran.told)
    };
    let (plain, walled) = (contour("N20 G40 G01 X60."), contour("N20 G40 G01 X60. I10. K0."));
    assert_eq!((&plain.1, &walled.1), (&vec![], &vec![]));
    let rough = |motions: &[(Option<Cycle>, Point)]| -> Vec<_> {
        motions.iter().filter(|own| own.0 == Some(Cycle::RoughTurning)).copied().collect()
    };
    assert_eq!(rough(&plain.0), rough(&walled.0));
    assert!(plain.0.contains(&(Some(Cycle::Finishing), Point::new(15.0, -20.8))), "{plain:?}");
    assert!(walled.0.contains(&(Some(Cycle::Finishing), Point::new(15.0, -20.0))), "{walled:?}");
    // A cone of 45°: the offset paths meet r·tan 22.5° before the end.
    let r = 0.8 * (std::f64::consts::PI / 8.0).tan();
    let ((x, z), ..) = ends("G40 G01 X60. Z-20. I5. K-5.");
    assert!((x - 15.0).abs() < 0.001 && (z - (-20.0 + r - 0.8)).abs() < 0.001, "{x} {z}");
}

/// Codes of FANUC's and GSK's lists that are not supported are no errors. If they change the meaning of
/// coordinates, the path is uncertain until they are switched off. The codes that switch them off are
/// accepted: many headers contain them.
#[test]
fn codes_that_controls_have_are_never_denied() {
    let told = |code: &str| {
        run(
            "{}",
            &format!("T0101\nG97 G99 S500 M3\nG00 X30. Z2.\n{code}\nG01 X30. Z-20. F.2\nG00 X50.\nM30\n"),
        )
    };
    for code in [
        "G50.3", "G66.1", "G68.1", "G35", "G43.7", "G30.1", "G38", "G39", "G60", "G62", "G96.1", "G10.9",
        "G53.1", "G61.1", "G06.2", "G07.2",
    ] {
        assert_eq!(told(code).told, ["not-supported 4"], "{code}");
    }
    for code in ["G15", "G40.1", "G49.1", "G50.1", "G69.1"] {
        assert_eq!(told(code).told, [""; 0], "{code}");
    }
    let last_cut = |text: &str| {
        told(text).motions.iter().rfind(|motion| motion.kind.cuts()).expect("a cut").process.uncertain
    };
    // The motions after an unsupported modal code are uncertain.
    let after_curve = told("G06.2 X30. Z0 R1. F.2\nX32. Z-5.\nX36. Z-10.").motions;
    let between = after_curve.iter().filter(|motion| (-11.0..-1.0).contains(&motion.to.z));
    assert_eq!(between.map(|motion| motion.process.uncertain).collect::<Vec<_>>(), [true, true]);
    assert!(last_cut("G68.1 X0. Z0. R45.") && !last_cut("G68.1 X0. Z0. R45.\nG69.1\nG00 X30. Z2."));
    assert_eq!(told("G47").told, ["unknown-g-code 4"]);
}

/// A subprogram at the beginning of the file that ends with M99 P is not a main program: P refers to a block
/// of the caller.
#[test]
fn a_subprogram_that_comes_first_may_end_in_m99_p() {
    let caller = "O1001\nG21G40G99\nT0101\nG97S800M3\nG00X44.Z2.\nG01X40.F0.2\nZ-30.\nG00X44.\nM98P1000\nN300G00X100.Z100.\nM30\n";
    let sub = |end: &str| format!("O1000\nG00X42.Z-20.\nG01X38.F0.1\nG00X44.\nM99{end}\n");
    let [plain, to_block] = ["", " P300"].map(|end| run("{}", &format!("{}{caller}", sub(end))));
    assert_eq!(plain.moves(), to_block.moves());
    assert_eq!(plain.moves()[0], (MotionKind::Rapid, 44.0, 2.0));
    let to_block = run("{}", &format!("{}{caller}", sub(" P300")));
    assert!(
        to_block.told.iter().all(|told| !told.contains("sequence") && !told.contains("not-run")),
        "{:?}",
        to_block.told
    );
}

/// A contour of G71 that begins in front of the start point exceeds it in Z.
#[test]
fn a_contour_in_front_of_the_start_point_goes_beyond_it_in_z() {
    let text = |first: &str| {
        format!(
            "O1\nG21G40G99\nT0101\nG97S1000M3\nG00X30.Z0.\nG71U2.R0.5\nG71P10Q20U0.4W0.1F0.2\nN10{first}\nZ-32.\nX25.\nN20Z-42.\nM30\n"
        )
    };
    let axis = |first: &str| {
        let analysis =
            gcode_playground::analyze(text(first).as_bytes(), &gcode_playground::setup::Setup::default());
        let told =
            analysis.diagnostics.iter().find(|told| told.message.slug() == "contour-beyond-start-point");
        told.map(|told| {
            format!(
                "{:?}",
                told.message.arguments().iter().find(|(name, _)| *name == "axis").map(|found| &found.1)
            )
        })
    };
    assert!(axis("G01X14.Z1.").is_some_and(|axis| axis.contains('Z')), "{:?}", axis("G01X14.Z1."));
    assert!(axis("G00X32.").is_some_and(|axis| axis.contains('X')), "{:?}", axis("G00X32."));
}
