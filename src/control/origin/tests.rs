//! One small program for each origin and system, and near misses that must not be taken for one.

use super::*;
use std::fs;
use std::path::Path;

/// The one door for foreign programs: this origin, shown by this evidence.
#[track_caller]
fn check(program: &str, origin: Origin, evidence: &str) {
    let found =
        foreign(program.as_bytes()).map(|found| (found.origin, found.evidence.quote(program.as_bytes())));
    assert_eq!(found, Some((origin, evidence.to_owned())), "\n{program}");
}

/// The one door for systems B and C.
#[track_caller]
fn check_system(program: &str, system: GSystem, evidence: &str) {
    let found = g_system(program.as_bytes()).map(|(system, span)| (system, span.quote(program.as_bytes())));
    assert_eq!(found, Some((system, evidence.to_owned())), "\n{program}");
}

#[track_caller]
fn check_at_home(program: &str) {
    assert_eq!(foreign(program.as_bytes()), None, "\n{program}");
    assert_eq!(g_system(program.as_bytes()), None, "\n{program}");
}

#[test]
fn hnc_has_both_blocks_of_a_cycle_in_one() {
    let roughing =
        "%0021\nT0101\nM03 S500\nG00 X42 Z2\nG71 U1.5 R1 P1 Q2 X0.5 Z0.1 F120\nN1 G01 X20 Z0\nN2 X40\nM30\n";
    check(roughing, Origin::Hnc, "G71");
    check("%7\nT0101\nG00 X42 Z2\nG80 X38 Z-20 F100\nX36\nM30\n", Origin::Hnc, "%7");
    check("G36\nG00 X42 Z2\nG80 X38 Z-20 I-2 F100\nM30\n", Origin::Hnc, "G36");
    check("%0003\nT0101\nG82 X19.2 Z-18 F1.5\nM30\n", Origin::Hnc, "%0003");
}

#[test]
fn gsk928_cycles_have_i_and_k() {
    check("N1 G00 X40 Z2\nN2 G81 X20 Z-30 I2 K1 L3 F80\nN3 M2\n", Origin::Gsk928, "G81");
}

#[test]
fn siemens_has_names_and_r_parameters() {
    check("N10 G90 G95 DIAMON\nN20 T1 D1\nN30 G0 X40 Z2\n", Origin::Siemens, "DIAMON");
    check("G95\nCYCLE95(\"SHAFT\",2,0.1,0.3)\nM30\n", Origin::Siemens, "CYCLE95");
    check("R1=20 R2=5\nG0 X=R1 Z=R2 ; start\n", Origin::Siemens, "R1=");
    check("%_N_SHAFT_MPF\nG0 X10\n", Origin::Siemens, "%_N_SHAFT_MPF");
    check("T=\"ROUGH\" D1\nG96 S200 LIMS=3000 M4\nG1 Z-5 F0.2\n", Origin::Siemens, "T=");
    check("TRANS Z80\nG3 X20 Z-5 CR=5\n", Origin::Siemens, "TRANS");
}

#[test]
fn linuxcnc_has_o_words_and_names_of_variables() {
    check("o100 sub\nG1 X#1 F0.1\no100 endsub\nM2\n", Origin::LinuxCnc, "o100 sub");
    check("#<deep> = 3\no<pass> call [#<deep>]\nM2\n", Origin::LinuxCnc, "o<pass> call [#<deep>]");
    check("G18 G8 G21 G40 G90\nG64 P0.01\nT1 M6\nG0 X10 Z2\n", Origin::LinuxCnc, "G8");
    check("G76 P1 Z-20 I-1 J0.2 K1.1 R1.5\n", Origin::LinuxCnc, "G76");
}

#[test]
fn fagor_has_statements_in_brackets() {
    check("N10 G0 X20 Z2\nN20 G1 Z-10\n(RPT N10,N20) N3\n", Origin::Fagor, "(RPT N10,N20)");
    check("P1=K20 P2=K5\nG0 XP1 ZP2\n", Origin::Fagor, "P1=");
    check("(P1=20)\n(IF P1 GT 10 GOTO N40)\nG1 X10\n", Origin::Fagor, "(P1=20)");
    check("%SHAFT,MX,\nG0 X20\n", Origin::Fagor, "%SHAFT,MX,");
}

#[test]
fn heidenhain_writes_plain_text() {
    check("0 BEGIN PGM 12 MM\n1 BLK FORM 0.1 Z X+0\n2 L X+10 Y+5 R0 FMAX\n", Origin::Heidenhain, "BEGIN PGM");
    check("5 TOOL CALL 3 Z S900\n6 L Z+50 R0 FMAX M3\n", Origin::Heidenhain, "FMAX");
}

#[test]
fn okuma_names_its_sequences() {
    check("$SHAFT.MIN%\nG50 S2000\nG00 X500 Z500\n", Origin::Okuma, "$SHAFT.MIN%");
    check("NAT01\nG50 S2000\nG85 NLAP1 D4 U0.3 W0.1 F0.3\nNLAP1 G81\nG80\n", Origin::Okuma, "NLAP1");
    check("VZSHZ=80\nG00 X500 Z500\n", Origin::Okuma, "VZSHZ");
}

#[test]
fn a_mill_has_its_tool_length_and_y() {
    let mill = "O1\nG17 G21 G40 G49 G80 G90\nT2 M06\nG54 G00 X5 Y5 S900 M03\nG43 H2 Z20\nG81 X5 Y5 Z-3 R2 F80\nM30\n";
    check(mill, Origin::Mill, "G43 H2");
    let moves: String = (0..9).map(|y| format!("G1 X10 Y{y}\n")).collect();
    check(&format!("G17 G90\nM6 T1\nG41 D1 X0 Y0\n{moves}M30\n"), Origin::Mill, "T1");
}

#[test]
fn a_printer_heats_and_pushes() {
    check("M140 S60\nM104 S200\nG28\nM82\nG92 E0\nG1 X10 Y5 E0.4\n", Origin::Printer, "G92");
    check(";FLAVOR:Marlin\n;LAYER:0\nG1 X10 Y5 E0.4 F900\n", Origin::Printer, "FLAVOR");
}

#[test]
fn lathe_programs_are_at_home() {
    check_at_home("");
    check_at_home(
        "%\nO0001\nG50 S2000\nT0101\nG96 S150 M03\nG0 X42. Z2.\nG71 U2. R1.\nG71 P10 Q20 U.5 W.1 F.2\nM30\n%",
    );
    // A header pasted from a mill, and a tool change with M6.
    check_at_home("G17 G20 G40 G49 G80 G90 G99\nT0101 M06\nG43 H01\nG00 X2. Z.1\nG01 Z-1. F.01\nG28 U0 W0\n");
    check_at_home("G17 G21 G40 G49 G90\nM06 T01\nG43 H01 Z50\nG00 X20 Y0 Z2\nG01 Z-10 F80\n");
    check_at_home("M06 T01\nM03 S900\nG00 X20 Z2\nG01 Z-10 F80\n");
    // One line for a cycle, as Haas writes it; a student with too many words.
    check_at_home(
        "T101\nG71 P10 Q20 U0.01 W0.005 D0.05 F0.01\nN10 G00 X1.\nN20 G01 Z-1.\nG76 X.9 Z-1. K.05 D.01 F.08\n",
    );
    check_at_home("T0101\nG71 X52 P70 Q90 U0 W0.1 F1\n");
    // A drill in the middle.
    check_at_home("T0404\nG0 X0 Z2\nG81 X0 Z-20 F80\nG80\nG82 X0 Z-5 P500\n");
    // Live tools with Y and C.
    let moves: String = (0..20).map(|y| format!("X1.2 Y.{y}\n")).collect();
    check_at_home(&format!(
        "T0909\nG98 G17\nG97 S3000 M34\nG0 X2. Y0. Z.1\nG1 Z-.2 F10.\n{moves}G2 X1. Y2. I.1 J.1\nG83 X1. Y1. Z-.5 R.1\nG28 U0\n"
    ));
    check_at_home(&format!(
        "G17\nG0 X2. Y0. Z.1\nG41 D1 X1.\n{moves}G2 X1. Y2. I.1 J.1\nG83 X1. Y1. Z-.5 R.1\nM99\n"
    ));
    // The makers' own M codes.
    check_at_home("T0101\nM104\nM109 S500\nM82\nG0 X10 Z2\nM17\n");
    // Names of others in remarks and prose.
    check_at_home(
        "(CYCLE95 WAS: DIAMON, BEGIN PGM)\nT0101 (CALL 1 MAN)\nG1 X10 Z-5 F.1 ; DIAMON G43 H1\nTOOL CALL BY HAND\n",
    );
    check_at_home("(P1=FIRST PASS)\n#1=5\nIF[#1 GT 2]GOTO10\nWHILE[#1 LT 9]DO1\nEND1\nN10 M99\n");
    // A jump in system A; an angle; another's program number alone.
    check_at_home("%1234\nT0101\nG0 X20 Z2\nG1 Z-5 F0.1\nM30\n");
    check_at_home("G36 X50\nG37 Z10\nG07 Z0\nG08 P1\nG0 X10 Z5\n");
}

#[test]
fn systems_b_and_c() {
    check_system("G21 G40 G90 G95\nG92 S2500\nG28 U0\nG71 U2 R1\nG71 P1 Q2 U.5 W.1 F.3\n", GSystem::B, "G95");
    check_system("G0 X30 Z2\nG92 S1500\n", GSystem::B, "G92");
    check_system("G0 X30 Z2\nG77 X28 Z-20 F0.2\nX26\n", GSystem::B, "G77");
    check_system("G91 G28 X0 Z0\nG90 G94 F200\nG1 Z-5\n", GSystem::B, "G91");
    check_system("G97 S400\nG0 X30 Z5\nG33 Z-20 F1.5\nG91 G0 X2\n", GSystem::B, "G33");
    check_system("G95 G90\nT0909\nG98 G83 Z-20 R-3 Q5000 F.1\nG99 G83 Z-9 R-3 F.1\n", GSystem::B, "G95");
    check_system("G0 X30 Z2\nG24 X0 Z1 F0.2\nG21 X18 Z-20 F1.5\n", GSystem::C, "G24");
}

#[test]
fn doubts_leave_system_a() {
    for program in [
        "G18 G20 G40 G80 G90 G99\nG50 S2000\nG0 X2. Z.1\n",
        "G98\nG0 X40 Z2\nG90 X38 Z-20 F100\nX36\nG94 X0 Z-1\nG92 X38 Z-20 F1.5\n",
        // Words of both: whoever wrote it, A is as good.
        "G99 G96 S515 G95 M03\nG94 X0 Z2.5\n",
        "G94\nG0 X120 C0\nG12.1\nG1 X40 F100\n",
        "G50 S2000\nG99\nG91 G28 Z0.\n",
        "G20 G0 X1. Z.1\nG21\n",
        "(G95 G92 S100)\nG0 X1\n",
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

#[test]
fn any_bytes_are_read() {
    let bytes: Vec<u8> = (0..=255u8).cycle().take(70_000).collect();
    for start in 0..256 {
        foreign(&bytes[start..]);
        g_system(&bytes[start..]);
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
