//! What a control does with a block, worked out by hand from manuals and geometry, where it is easily taken otherwise.
//! Each test names the line of the manual, or the sum.
use gcode_playground::analyze;
use gcode_playground::motion::{Motion, MotionKind};
use gcode_playground::playback::timing::seconds;
use gcode_playground::setup::Setup;
use gcode_playground::units::Diameter;

struct Ran {
    motions: Vec<Motion>,
    /// Slugs and lines, the first being 1.
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
    // A new F ends it, a feed between the threads too.
    let ran = run("{}", &format!("{head}G92 X29.2 Z-20 E1.5\nX28.6 F2\nX28.2\nG00 X40\nM30\n"));
    assert_eq!(ran.leads(), [1500, 2000, 2000]);
    let ran =
        run("{}", &format!("{head}G00 X29.2\nG32 Z-20 E1.5\nG00 X34\nZ8\nX28.6\nG32 Z-20\nG00 X40\nM30\n"));
    assert_eq!((ran.leads(), ran.told), (vec![1500; 2], vec![]));
    let inch = "G20\nG97 S500 M3\nG00 X1.2 Z.3\nG92 X.95 Z-.5 E.0714286\nX.93\nX.92\nG00 X2.\nM30\n";
    assert_eq!(run("{}", inch).leads(), [1814; 3]);
    // The feed is that of F: E is a lead alone.
    let ran = run("{}", &format!("{head}G92 X29.2 Z-20 E1.5\nG00 X40\nG01 X39 F0.1\nZ-5\nM30\n"));
    assert_eq!(ran.seconds_of_last_cut(), Some(15.6), "13 mm at 0.1 mm and 500 turns a minute");
}

/// FANUC B-64304EN, "Feed of linear interpolation with a rotary axis": one degree counts as one mm.
#[test]
fn degrees_of_c_count_as_millimetres_of_the_feed() {
    let head = "M45\nG28 H0\nG98\nG00 X40 Z5 C0\n";
    // C alone: 90° at 360 degrees a minute.
    let ran = run("{}", &format!("{head}G01 C90 F360\nM46\nM30\n"));
    assert_eq!(ran.seconds_of_last_cut(), Some(15.0));
    // 15 mm and 90°: √(15² + 90²) = 91.24 at 100 a minute are 54.7 s.
    let ran = run("{}", &format!("{head}G00 C90\nG01 Z-10 C180 F100\nM46\nM30\n"));
    assert_eq!(ran.seconds_of_last_cut(), Some(54.7));
    let ran = run("{}", &format!("{head}G01 H-45 F90\nM46\nM30\n"));
    assert_eq!(ran.seconds_of_last_cut(), Some(30.0));
}

/// FANUC B-64304EN-1, boring cycles of systems B and C: G85 leaves the hole at feed, G86 at rapid with the spindle stopped.
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

/// FANUC B-64304EN-1: G81 and G82 drill in one cut; Q is a word of G83 (and G87) alone.
#[test]
fn a_peck_of_g83_is_none_of_g81() {
    let cuts = |blocks: &str| {
        let text = format!("G90 G98 G95 G97 S500 M3\nG00 X0 Z5\n{blocks}\nG80\nM30\n");
        let ran = run(r#"{"dialect": {"gSystem": "B"}}"#, &text);
        ran.motions.iter().filter(|motion| motion.kind.cuts()).count()
    };
    // 22 mm in pecks of 5 mm: five cuts.
    assert_eq!(cuts("G83 Z-20 R2 Q5000 F0.1"), 5);
    // From R2 to Z-30 in one.
    assert_eq!(cuts("G83 Z-20 R2 Q5000 F0.1\nG81 Z-30"), 6);
    assert_eq!(cuts("G83 Z-20 R2 Q5000 F0.1\nG82 Z-30 P500"), 6);
    // G83 has its Q again.
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

/// K repeats a hole (FANUC B-64304EN-1, G83 to G89), also in a block after it: a count takes no decimal point.
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
    // A centre without a point, after G80, lacks one.
    let text = format!(
        "{head}G87 X40. R-2. Q2000 F50.\nG80\nG00 X80. Z2.5\nG01 X50. F30.\nG01 Z-2.5\nG03 X60. Z-7.5 I0. K-5\nG01 Z-12.5\nX62.\nM46\nM30\n"
    );
    let told = run("{}", &text).told;
    assert!(told.contains(&"point-missing 10".to_owned()), "{told:?}");
}
