//! A small program for each target and system, and near misses that must not be recognised as one.

use super::*;
use crate::setup::dialect::DecimalRule;
use std::fs;
use std::path::Path;

/// The result of the detailed check. Asserts that the quick check asks for it if there is anything to find.
#[track_caller]
fn found(program: &str) -> Provenance {
    let found = recognise(program.as_bytes()).expect("all parts are there");
    let look = quick_check(program.as_bytes());
    let is_unusual = found.foreign.is_some() || found.system.is_some();
    let is_seen = (look.is_unusual || !is_unusual) && (look.may_be_inches || found.inches.is_none());
    assert!(is_seen, "the first look does not see {found:?}\n{program}");
    found
}

/// Checks that a program is recognised as foreign, with this target and evidence.
#[track_caller]
fn check(program: &str, target: Target, evidence: &str) {
    let found = found(program).foreign.map(|found| (found.target, found.evidence.quote(program.as_bytes())));
    assert_eq!(found, Some((target, evidence.to_owned())), "\n{program}");
}

/// Checks that a program is recognised as system B or C, with this evidence.
#[track_caller]
fn check_system(program: &str, system: GSystem, evidence: &str) {
    let found = found(program).system.map(|(system, span)| (system, span.quote(program.as_bytes())));
    assert_eq!(found, Some((system, evidence.to_owned())), "\n{program}");
}

#[track_caller]
fn check_at_home(program: &str) {
    assert_eq!(found(program).foreign, None, "\n{program}");
    assert_eq!(found(program).system, None, "\n{program}");
}

#[test]
fn hnc_has_both_blocks_of_a_cycle_in_one() {
    let roughing =
        "%0021\nT0101\nM03 S500\nG00 X42 Z2\nG71 U1.5 R1 P1 Q2 X0.5 Z0.1 F120\nN1 G01 X20 Z0\nN2 X40\nM30\n";
    check(roughing, Target::Hnc, "G71");
    // The word E is the allowance of a contour with a recess (HNC-18iT programming manual, G71).
    check(
        "%0001\nT0101\nG00 X50 Z2\nG71 U1.5 R1 P10 Q20 E0.4 F100\nN10 G00 X30\nN20 X50\nM30\n",
        Target::Hnc,
        "G71",
    );
    check(
        "%0001\nT0101\nG00 X50 Z2\nG72 U1.5 R1 P10 Q20 F100\nN10 G00 X30\nN20 X50\nM30\n",
        Target::Hnc,
        "%0001",
    );
    // Its allowances may be U and W, as on FANUC, if no block has two U.
    let twice = |head: &str| {
        format!("{head}\nT0101\nG00 X46 Z3\nG71 U2 R1 P10 Q20 U0.4 W0.1 F100\nN10 G00 X20\nN20 Z-40\nM30\n")
    };
    check(&twice("%0003"), Target::Hnc, "%0003");
    check_at_home(&twice("O0003"));
    check("%7\nT0101\nG00 X42 Z2\nG80 X38 Z-20 F100\nX36\nM30\n", Target::Hnc, "%7");
    check("G36\nG00 X42 Z2\nG80 X38 Z-20 I-2 F100\nM30\n", Target::Hnc, "G36");
    check("%0003\nT0101\nG82 X19.2 Z-18 F1.5\nM30\n", Target::Hnc, "%0003");
}

#[test]
fn gsk928_cycles_have_i_and_k() {
    check("N1 G00 X40 Z2\nN2 G81 X20 Z-30 I2 K1 L3 F80\nN3 M2\n", Target::Gsk928, "G81");
}

#[test]
fn siemens_has_names_and_r_parameters() {
    check("N10 G90 G95 DIAMON\nN20 T1 D1\nN30 G0 X40 Z2\n", Target::Siemens, "DIAMON");
    check("G95\nCYCLE95(\"SHAFT\",2,0.1,0.3)\nM30\n", Target::Siemens, "CYCLE95");
    check("R1=20 R2=5\nG0 X=R1 Z=R2 ; start\n", Target::Siemens, "R1=");
    check("%_N_SHAFT_MPF\nG0 X10\n", Target::Siemens, "%_N_SHAFT_MPF");
    check("T=\"ROUGH\" D1\nG96 S200 LIMS=3000 M4\nG1 Z-5 F0.2\n", Target::Siemens, "T=");
    check("TRANS Z80\nG3 X20 Z-5 CR=5\n", Target::Siemens, "TRANS");
}

#[test]
fn linuxcnc_has_o_words_and_names_of_variables() {
    check("o100 sub\nG1 X#1 F0.1\no100 endsub\nM2\n", Target::LinuxCnc, "o100 sub");
    check("#<deep> = 3\no<pass> call [#<deep>]\nM2\n", Target::LinuxCnc, "o<pass> call [#<deep>]");
    check("G18 G8 G21 G40 G90\nG64 P0.01\nT1 M6\nG0 X10 Z2\n", Target::LinuxCnc, "G8");
    // ioSender and grblHAL use radii; X would be read as a diameter.
    check("G18 G8 G21\nM3S100 G4P1\nG0 X7.750\nG1 X5.673 F200.000\nM30\n", Target::LinuxCnc, "G8");
    check("G18 G20 G90 G95\nG96 D2500 S120 M3\nG0 X1.2 Z.1\n", Target::LinuxCnc, "G96");
    check("G7 G18 G21 G40 G90 G94\nT1 M6 G43\nG93\nG1 X10 Z2 F5\n", Target::LinuxCnc, "G7");
    // A postprocessor for turning: arcs with incremental centres.
    check(
        "G18\nG90 G94 G91.1\nG20\nG53 G0 X0.\nT1 M6\nG90 G0 X1.2 Z.2\nG1 X1. F4.4\n",
        Target::LinuxCnc,
        "G91.1",
    );
    check("G76 P1 Z-20 I-1 J0.2 K1.1 R1.5\n", Target::LinuxCnc, "G76");
}

#[test]
fn fagor_has_statements_in_brackets() {
    check("N10 G0 X20 Z2\nN20 G1 Z-10\n(RPT N10,N20) N3\n", Target::Fagor, "(RPT N10,N20)");
    check("P1=K20 P2=K5\nG0 XP1 ZP2\n", Target::Fagor, "P1=");
    check("(P1=20)\n(IF P1 GT 10 GOTO N40)\nG1 X10\n", Target::Fagor, "(P1=20)");
    check("%SHAFT,MX,\nG0 X20\n", Target::Fagor, "%SHAFT,MX,");
}

#[test]
fn heidenhain_writes_plain_text() {
    check("0 BEGIN PGM 12 MM\n1 BLK FORM 0.1 Z X+0\n2 L X+10 Y+5 R0 FMAX\n", Target::Heidenhain, "BEGIN PGM");
    check("5 TOOL CALL 3 Z S900\n6 L Z+50 R0 FMAX M3\n", Target::Heidenhain, "FMAX");
}

#[test]
fn okuma_names_its_sequences() {
    check("$SHAFT.MIN%\nG50 S2000\nG00 X500 Z500\n", Target::Okuma, "$SHAFT.MIN%");
    check("NAT01\nG50 S2000\nG85 NLAP1 D4 U0.3 W0.1 F0.3\nNLAP1 G81\nG80\n", Target::Okuma, "NAT01");
    check("O100\nNAT01\nG50 S2000\nG97 S600 M03 M42 T010101\nM02\n", Target::Okuma, "NAT01");
    check("G50 S2000\nT010101\nG71 X36.4 Z-20 B60 D0.6 U0.1 H1.8 F2 M32 M73\nM02\n", Target::Okuma, "G71");
    check("$SHAFT.SSB%\nOSUB1\nG00 X500\nRTS\n", Target::Okuma, "$SHAFT.SSB%");
    check("VZSHZ=80\nG00 X500 Z500\n", Target::Okuma, "VZSHZ");
}

#[test]
fn other_machines_have_words_of_their_own() {
    // Mitsubishi M70 and FANUC on Swiss-type lathes: `$1` is the program of the first path, `!L1` waits for
    // the other.
    check("O1000\n$1\nG50 Z0\nM03 S1=2000\n!L1\nG0 X20 Z0 T0100\n$2\n!L1\nM30\n", Target::Channels, "$1");
    check("O1\n!L1\nM3 S1=500\nG0 X20 Z0\n", Target::Channels, "!L1");
    check("$1 (MAIN)\nG0 X1\n", Target::Channels, "$1 (MAIN)");
    check("G0 X40 Z2\nWAITM(1,1,2)\n", Target::Siemens, "WAITM(");
    check("O1\nG109 L1\nT001001\nG96 S120\nG0 X40. Z2.\n", Target::Mazak, "G109");
    check("$AddRegPart 1 2\nG0 X40 Z2\n", Target::CncSimulator, "$AddRegPart 1 2");
    check("%MPF1005\nN10 G54\nN20 T1 D1 G96 S300 F0.2 M4\nN30 X22 Z1\n", Target::Siemens, "%MPF1005");
    check("%PM\nN9000\nN20 G99 X105 Z1237\nN40 G96 S250 D1600 M39\n", Target::Philips, "%PM");
    let cycle = "G68 X39.8 Z-60 C1 L0.25 M0.1 H0 S310 E350";
    check(&format!("N10 G90 G95 G96\nG92 S2000\nN20 {cycle}\nN150 G36 R20 X55 Z-25\n"), Target::Fagor, "G68");
    check("N10 G90\nN20 G81 X50 Z-10 Q80 R-10 C2 L1 M1\n", Target::Fagor, "G81");
    check("$Message \"hello\"\nG0 X40 Z2\n", Target::CncSimulator, "$Message \"hello\"");
}

#[test]
fn a_mill_has_its_tool_length_and_y() {
    let mill = "O1\nG17 G21 G40 G49 G80 G90\nT2 M06\nG54 G00 X5 Y5 S900 M03\nG43 H2 Z20\nG81 X5 Y5 Z-3 R2 F80\nM30\n";
    check(mill, Target::Mill, "G43 H2");
    let moves: String = (0..9).map(|y| format!("G1 X10 Y{y}\n")).collect();
    check(&format!("G17 G90\nM6 T1\nG41 D1 X0 Y0\n{moves}M30\n"), Target::Mill, "T1");
}

#[test]
fn a_printer_heats_and_pushes() {
    check("M140 S60\nM104 S200\nG28\nM82\nG92 E0\nG1 X10 Y5 E0.4\n", Target::Printer, "G92");
    check(";FLAVOR:Marlin\n;LAYER:0\nG1 X10 Y5 E0.4 F900\n", Target::Printer, "FLAVOR");
}

#[test]
fn lathe_programs_are_at_home() {
    check_at_home("");
    // G68 mirrors for a second turret, G81 and G83 drill at a place, with the clamp of the C axis.
    check_at_home("G66 P9100 X4. Z-6. C1. S3. E4.\nG82 X30. Z-10. C90. R-3. Q500 L2 P100 F40.\n");
    check_at_home("G68\nG0 X40 Z2\nG69\nG83 X30 C90 Z-20 R-3 Q5000 F40 M31\nG80\n");
    check_at_home(
        "%\nO0001\nG50 S2000\nT0101\nG96 S150 M03\nG0 X42. Z2.\nG71 U2. R1.\nG71 P10 Q20 U.5 W.1 F.2\nM30\n%",
    );
    // A header copied from a mill, and a tool change with M6.
    check_at_home("G17 G20 G40 G49 G80 G90 G99\nT0101 M06\nG43 H01\nG00 X2. Z.1\nG01 Z-1. F.01\nG28 U0 W0\n");
    check_at_home("G17 G21 G40 G49 G90\nM06 T01\nG43 H01 Z50\nG00 X20 Y0 Z2\nG01 Z-10 F80\n");
    check_at_home("M06 T01\nM03 S900\nG00 X20 Z2\nG01 Z-10 F80\n");
    // A cycle in one line, as on Haas; a beginner's block with too many words.
    check_at_home(
        "T101\nG71 P10 Q20 U0.01 W0.005 D0.05 F0.01\nN10 G00 X1.\nN20 G01 Z-1.\nG76 X.9 Z-1. K.05 D.01 F.08\n",
    );
    check_at_home("T0101\nG71 X52 P70 Q90 U0 W0.1 F1\n");
    // A hole on the axis.
    check_at_home("T0404\nG0 X0 Z2\nG81 X0 Z-20 F80\nG80\nG82 X0 Z-5 P500\n");
    // Live tools with Y and C.
    let moves: String = (0..20).map(|y| format!("X1.2 Y.{y}\n")).collect();
    check_at_home(&format!(
        "T0909\nG98 G17\nG97 S3000 M34\nG0 X2. Y0. Z.1\nG1 Z-.2 F10.\n{moves}G2 X1. Y2. I.1 J.1\nG83 X1. Y1. Z-.5 R.1\nG28 U0\n"
    ));
    check_at_home(&format!(
        "G17\nG0 X2. Y0. Z.1\nG41 D1 X1.\n{moves}G2 X1. Y2. I.1 J.1\nG83 X1. Y1. Z-.5 R.1\nM99\n"
    ));
    // M codes of machine builders.
    check_at_home("T0101\nM104\nM109 S500\nM82\nG0 X10 Z2\nM17\n");
    // Names of other controls in remarks and prose.
    check_at_home(
        "(CYCLE95 WAS: DIAMON, BEGIN PGM)\nT0101 (CALL 1 MAN)\nG1 X10 Z-5 F.1 ; DIAMON G43 H1\nTOOL CALL BY HAND\n",
    );
    check_at_home("(P1=FIRST PASS)\n#1=5\nIF[#1 GT 2]GOTO10\nWHILE[#1 LT 9]DO1\nEND1\nN10 M99\n");
    // A jump in system A; an angle; only the program number of another control.
    check_at_home("%1234\nT0101\nG0 X20 Z2\nG1 Z-5 F0.1\nM30\n");
    check_at_home("G36 X50\nG37 Z10\nG07 Z0\nG08 P1\nG0 X10 Z5\n");
}

#[test]
fn systems_b_and_c() {
    check_system("G21 G40 G90 G95\nG92 S2500\nG28 U0\nG71 U2 R1\nG71 P1 Q2 U.5 W.1 F.3\n", GSystem::B, "G95");
    check_system("G0 X30 Z2\nG92 S1500\n", GSystem::B, "G92");
    check_system("G92 X100 Z50\nG94 G90\nT0101\nG0 X32 Z2\nG1 X28 F100\n", GSystem::B, "G94");
    check_system("G0 X30 Z2\nG77 X28 Z-20 F0.2\nX26\n", GSystem::B, "G77");
    // Increments by G91 show B despite the speed limit of A.
    let slip =
        "G90 G18 G21\nG28 G91 Z0 X0\nG90\nT0101 M03 S800\nG00 G90 X55. Z5.\nG50 S3000\nG01 Z-60. F0.2\n";
    check_system(slip, GSystem::B, "G90");
    check_system("G91 G28 X0 Z0\nG90 G94 F200\nG1 Z-5\n", GSystem::B, "G91");
    check_system("G97 S400\nG0 X30 Z5\nG33 Z-20 F1.5\nG91 G0 X2\n", GSystem::B, "G33");
    check_system("G95 G90\nT0909\nG98 G83 Z-20 R-3 Q5000 F.1\nG99 G83 Z-9 R-3 F.1\n", GSystem::B, "G95");
    // A postprocessor for system B that uses G32.
    check_system(
        "G90 G94 G18\nG28 U0.\nT0101\nG90 G95 G18\nG92 S3000\nG32 X35.5 F1.5\nG32 X35. Z-18. F1.5\n",
        GSystem::B,
        "G95",
    );
    check_system("G18 G20\nG94\nG90 G0 X1.2 Z.2\nG1 X1. F4.4\nG90 G94\n", GSystem::B, "G90");
    // Two cycles of A in one block without a place.
    for head in ["G21 G90 G94", "G90 G95", "G91 G94", "G95 G91"] {
        let program =
            format!("{head}\nG28 U0 W0\nT0101\nM03 S1500\nG00 X44 Z0\nG01 X0 F120\nG00 X44 Z2\nG28 U0 W0\n");
        let found = found(&program).system.map(|(system, _)| system);
        assert_eq!(found, Some(GSystem::B), "{head}");
    }
    check_system("G90 G94 G18\nG90 G95\nG28 U0.\nG0 X50. Z5.\n", GSystem::B, "G95");
    // EMCO with FANUC 0-TC: the numbers of cycles differ by one from system A, and G78 is threading.
    let emco =
        "G92 S2000\nT0101\nG95\nG0 X52. Z2.\nG73 U2. R1.\nG73 P10 Q20 U.5 W.1 F.25\nN10 G00 X30.\nN20 X52.\n";
    check_system(&format!("{emco}G72 P10 Q20\n"), GSystem::C, "G72");
    check_system(&format!("{emco}G78 P021560 Q50 R.02\nG78 X27.4 Z-20. P1300 Q400 F2.\n"), GSystem::C, "G78");
    check_system("G71\nG0 X34. Z4.\nG78 P021560 Q50 R.02\n", GSystem::C, "G78");
    check_system("G95\nG92 S900\nG0 X52. Z-9.\nG77 R1.\nG77 X40. Z-20. P2000 Q3000 F.1\n", GSystem::C, "G77");
    check_system("G95\nG0 X52. Z2.\nG75 U9. W2. R4\nG75 P1 Q2 U.5 W.1 F.2\nG72 P1 Q2\n", GSystem::C, "G72");
    check_system("G0 X30 Z2\nG24 X0 Z1 F0.2\nG21 X18 Z-20 F1.5\n", GSystem::C, "G24");
}

#[test]
fn doubts_leave_system_a() {
    for program in [
        "G18 G20 G40 G80 G90 G99\nG50 S2000\nG0 X2. Z.1\n",
        "G98\nG0 X40 Z2\nG90 X38 Z-20 F100\nX36\nG94 X0 Z-1\nG92 X38 Z-20 F1.5\n",
        // Words of both systems: A is as good a choice.
        "G99 G96 S515 G95 M03\nG94 X0 Z2.5\n",
        "G94\nG0 X120 C0\nG12.1\nG1 X40 F100\n",
        "G50 S2000\nG99\nG91 G28 Z0.\n",
        "G20 G0 X1. Z.1\nG21\n",
        // A facing cycle of A, and G72 instead of G70.
        "G72 W1. R.5\nG72 P10 Q20 U.2 W.1 F.2\nG70 P10 Q20\n",
        "G73 U9. W2. R4\nG73 P1 Q2 U.5 W.1 F.2\nG72 P1 Q2\n",
        "G32 Z-20. F1.5\nG0 U2.\n",
        // The head of a mill and one similar block.
        "G90 G0 X50. Z2.\nG1 Z-20. F.2\n",
        "(G95 G92 S100)\nG0 X1\n",
        "G21 G90 G94\nG50 S2000\nG00 X44 Z0\nG01 X0 F120\n",
        "G21 G90 G94\nG00 X44 Z2\nG92 X40 Z-20 F1.5\n",
    ] {
        check_at_home(program);
    }
}

#[test]
fn programs_of_the_gallery_are_at_home() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/programs");
    let mut seen = 0;
    for entry in fs::read_dir(folder).expect("programs").flatten() {
        if let Ok(program) = fs::read_to_string(entry.path().join("program.nc")) {
            check_at_home(&program);
            seen += 1;
        }
    }
    assert!(seen > 40);
}

/// Checks the decimal rule: the word that shows least increments, or `None` for whole units.
#[track_caller]
fn check_decimal(program: &str, evidence: Option<&str>) {
    let found = numbers(program.as_bytes());
    let shown = found.evidence().map(|bare| bare.span.quote(program.as_bytes()));
    assert_eq!(shown.as_deref(), evidence, "\n{program}");
    assert_eq!(found.rule() == DecimalRule::LeastIncrement, evidence.is_some());
}

const INCHES: &str = "G20\nG0 X2. Z.1\nG1 X1.18 F.016\nZ-1.\nX2.0\n";

#[test]
fn whole_numbers_with_a_point_and_one_that_cannot_be_a_unit_show_least_increments() {
    check_decimal(&format!("{INCHES}G71U800R500\nG71P1Q2U150W20\n"), Some("U800"));
    check_decimal(&format!("{INCHES}G71 P1 Q2 U150 W20\n"), Some("U150"));
    check_decimal(&format!("{INCHES}G75 R100\n"), Some("R100"));
    check_decimal(&format!("{INCHES}G76 P011060 R10\n"), Some("R10"));
    check_decimal(&format!("{INCHES}G1 Z-2500\n"), Some("Z-2500"));
    let metric = "G21\nG0 X52. Z2.\nG1 X40. F.2\nZ-30.\n";
    check_decimal(&format!("{metric}G71 U2000 R500\n"), Some("U2000"));
    check_decimal(&format!("{metric}G73 U12000 W3000 R6\n"), Some("U12000"));
    check_decimal(&format!("{metric}G76 P011060 Q100 R50\n"), Some("R50"));
    check_decimal(&format!("{metric}G04 X1000\n"), Some("X1000"));
    check_decimal(&format!("{metric}G28 U0 W0\nG0 U-5000\n"), Some("U-5000"));
}

#[test]
fn fractions_and_plausible_numbers_show_nothing() {
    // A fraction has its point on every control; two whole numbers may be chance.
    check_decimal("G20\nG0 X2.5 Z.1\nG1 X1.18\nZ-1.25\nX2.125\nG71U800R500\n", None);
    check_decimal("G20\nG0 X2. Z.1\nG1 X1.18\nZ-1.\nG71U800R500\n", None);
    let metric = "G21\nG0 X52. Z2.\nG1 X40. F.2\nZ-30.\n";
    for rest in [
        "G71 U2 R1\nG71 P1 Q2 U1 W0\nG1 Z-120\nG0 X300\nZ400\n",
        "G73 U14 W5 R10\nG76 P011060 Q100 R1\nG76 X30. Z-20. P1300 Q400 F2.\n",
        "G04 P1000\nG04 X30\nG50 S3000\nG96 S200\n",
        "G65 P9010 X5000 Z9000\nG74 X10. Z-60. P2500 Q9000 F.1\n",
        "(G71 U2000 R500)\n#1=5000\nG1 X[#1/100]\nG2 X50. R6000\n",
        "G28 U0 W0\nG0 X1000.0\n",
    ] {
        check_decimal(&format!("{metric}{rest}"), None);
    }
    // `U1` without a point is too much as inches and too little as increments.
    check_decimal(&format!("{INCHES}G71 U1 R1\n"), None);
}

#[test]
fn a_program_without_any_point_shows_least_increments_where_most_would_be_too_large() {
    check_decimal("G0 X50000 Z2000\nG1 Z-30000 F.2\nX52000\nZ500\n", Some("X50000"));
    check_decimal("G20\nG0 X20000 Z1000\nG71 U450 R500\nG71 P1 Q2 U100 W50\n", Some("X20000"));
    check_decimal("G0 X50 Z2\nG1 Z-30 F.2\nX52\nG0 X1500\n", None);
    check_decimal("G0 X50000\n", None);
    check_decimal("G0 X50000 Z2.5\nG1 Z-30000\n", None);
    // System C: these are cycles, not inches.
    check_decimal("G0 X60 Z2\nG20 X50 Z-90 F.2\nX45\n", None);
    check_decimal("", None);
}

#[test]
fn programs_of_the_gallery_count_units() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/programs");
    for entry in fs::read_dir(folder).expect("programs").flatten() {
        if let Ok(program) = fs::read_to_string(entry.path().join("program.nc")) {
            check_decimal(&program, None);
        }
    }
}

/// A statement for each sign.
const SIGNS: &str = "%1234|G71 U1 R1 P1 Q2 X1 Z1|G71 U1 R1 P1 Q2 E1|G72 U1 R1 P1 Q2|G80 X38 Z-20 F100|G81 X20 Z-3|G82 X19 Z-18 F1.5|G76 C2 A60 X20 Z-30 K1 F2|G36|G37|G36 R2 X5 Z1|G68 X4 Z-6 C1 S3 E4|G81 X5 Z-1 Q8 R-1 C2 L1|%PM|%MPF10|\
ENDW|CYCLE95(1,2)|LCYC95|DIAMON|%_N_SHAFT_MPF|R1=5|X=R1|LIMS=3000|MSG(1)|X=IC(5)|T=\"ROUGH\"|G2 X1 Z2 CR=5|TRANS Z80|GOTOF 1|M17|\
G290|o100 sub|#<deep> = 3|G7|G8|G64 P0.01|T1 G43|G91.1|G93|G33.1 Z-5 K1|G33 Z-5 K1|G96 D2500 S200|G76 P1.5 Z-20 I-1 J0.2 K0.9|G92.1|(DEBUG, x)|(MSG, x)|\
(RPT N10,N20)|(GOTO N10)|(IF P1 EQ 1 GOTO N2)|(P1=20)|(CALL 1)|(SUB 1)|(RET)|P1=K20|%SHAFT,MX,1|BEGIN PGM X MM|BLK FORM 0.1|\
TOOL CALL 1|L X+10 FMAX|L X+10|LBL 1|$SHAFT.MIN%|$1|!L1|S1=500|WAITM(1,1,2)|G109 L1|$AddRegPart 1|T010101|G71 X1 Z1 B1 D1 H1 F1|NAT01|G85 NLAP1|VZSHZ=1|V1=5|NOEX|SB=500|G81 X20 Z-30 I2 K1|G82 X1 Z-3 I2 K1 L3|\
G71 X20 I1 K2 L3|G43 H1|T1 M6|Y5|G2 X1 Y2 I3 J4|G81 X1 Y2 Z-3|G41 D1|G17|G49|G91 G28 Z0|M104 S200|M109 S200|M140 S60|M190 S60|\
G1 X1 Y1 E2|G1 X1 Y0 E2|G92 E0|M82|G29|;LAYER:1|G95|G92 S2000|G77 X20 Z-10|G78 X20 Z-10|G79 X20 Z-10|G91|G94 F100|G33 Z-20 F1.5|\
G24 X20 Z-5|G21 X20 Z-10 F1|G20 X20 Z-10 F1|G98|G50 S2000|G90 X20 Z-10 F1|X1 W-2|T0101|G96 S100|G70 P1 Q2|N10 G0 X50 Z2|(ROUGH)";

#[test]
fn the_first_look_sees_whatever_a_closer_one_finds() {
    let signs: Vec<&str> = SIGNS.split('|').collect();
    let mut random = 1_u64;
    let mut unusual = 0;
    for round in 0..60_000 {
        let mut pick = || {
            random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            signs[(random >> 33) as usize % signs.len()]
        };
        let program = (0..1 + round % 6).map(|_| pick()).collect::<Vec<_>>().join("\n");
        let shown = found(&program);
        unusual += usize::from(shown.foreign.is_some() || shown.system.is_some());
    }
    assert!(unusual > 5_000, "{unusual}");
    for each in signs {
        for more in ["", "G98\nX1 W-2\n"] {
            found(&format!("{more}{each}\n{each}"));
        }
    }
}

#[test]
fn an_ordinary_program_needs_no_closer_look() {
    let shaft = "%\nO0001 (SHAFT, ROUGH AND FINISH)\nG21 G40 G80 G97 G99\nG28 U0 W0\nT0101\nG50 S2000\nG96 S180 M03\nG00 X52. Z2. M08\n\
                 G71 U2. R1.\nG71 P10 Q20 U0.4 W0.1 F0.25\nN10 G00 G42 X20.\nG01 Z0 F0.1\nG03 X30. Z-5. R5.\nN20 X50.\nG70 P10 Q20\n\
                 G76 P020060 Q100 R0.05\nG76 X18.2 Z-20. P900 Q300 F1.5\nG92 X19. Z-20. F1.5\nG90 X40. Z-30. R-2.\nG94 X0 Z0 F0.1\n\
                 G74 R1.\nG74 Z-40. Q5000 F0.1\nM98 P1000\nG04 X1.0\nM05\nM30\n%\n";
    assert!(!quick_check(shaft.as_bytes()).is_unusual);
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/programs");
    let programs = fs::read_dir(folder).expect("programs").flatten();
    let programs: Vec<_> =
        programs.filter_map(|entry| fs::read_to_string(entry.path().join("program.nc")).ok()).collect();
    let unusual = programs.iter().filter(|program| {
        found(program);
        quick_check(program.as_bytes()).is_unusual
    });
    let unusual = unusual.count();
    assert!(unusual * 3 < programs.len(), "{unusual} of {}", programs.len());
}

#[test]
fn any_bytes_are_read() {
    let bytes: Vec<u8> = (0..=255u8).cycle().take(70_000).collect();
    for start in 0..256 {
        recognise(&bytes[start..]);
        quick_check(&bytes[start..]);
        numbers(&bytes[start..]);
    }
    for end in
        ["T=", "R1=", "L X", "%", "$", "#<", "(P", "o<", "G", "X-", "CYCLE95", "=\"", "99999999999999999999"]
    {
        check_at_home(end);
        check_at_home(&format!("G{end}"));
    }
}

#[test]
fn only_the_head_is_looked_at() {
    let far = format!("{}DIAMON\nG95\n", "G1 X1\n".repeat(HEAD / 6 + 1));
    check_at_home(&far);
}
