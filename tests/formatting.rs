//! `format`: words that change, words that stay, and that no program runs differently.

use crate::cli::{file, run};
use crate::expand::shop::{mistyped, shop_program};
use crate::fixtures;
use crate::project::source;
use crate::random_programs;

use gcode_playground::analyze;
use gcode_playground::api;
use gcode_playground::format::{self, edits};
use gcode_playground::message::applied;
use gcode_playground::proof::{Difference, difference};
use gcode_playground::run::Run;
use gcode_playground::setup::Setup;
use gcode_playground::setup::dialect::DecimalRule;
use proptest::prelude::*;
use random_programs::{any_setup, piece, program, small};

fn formatted(text: &[u8]) -> Vec<u8> {
    let after = applied(text, &edits(text));
    assert_eq!(format::formatted(text), after);
    after
}

#[track_caller]
fn check(before: &str, after: &str) {
    let found = formatted(before.as_bytes());
    assert_eq!(String::from_utf8_lossy(&found), after, "from {before:?}");
    assert_eq!(formatted(&found), found, "the second time");
}

#[track_caller]
fn check_stays(text: &str) {
    check(text, text);
}

/// The motions as rows, without the places in the text.
fn motions(text: &[u8], setup: &Setup) -> Vec<String> {
    let analysis = analyze(text, setup);
    let rows = api::motions(&analysis.motions, &analysis.setup.machine);
    rows.map(|row| serde_json::to_string(&row).expect("a row")).collect()
}

/// Formatting changes no motion and no message, and formatting again changes nothing.
fn check_runs_the_same(text: &[u8], setup: &Setup) -> Result<(), String> {
    let after = formatted(text);
    let shown = |what: &str| {
        Err(format!(
            "{what}:\n{}\n--- became:\n{}",
            String::from_utf8_lossy(text),
            String::from_utf8_lossy(&after)
        ))
    };
    if formatted(&after) != after {
        return shown("not the same the second time");
    }
    for block_skip in [Vec::new(), (1..=9).collect()] {
        let setup = Setup { block_skip, ..setup.clone() };
        if motions(text, &setup) != motions(&after, &setup) {
            return shown("other motions");
        }
    }
    match difference(&Run::finished(text.to_vec(), setup.clone()), after.clone()) {
        None | Some(Difference::OtherControl) => Ok(()),
        // Advice about a word depends on the length of a message about its block (`Diagnostic::is_about`). Such a
        // program stays as it is.
        Some(Difference::Messages) if !analyze(text, setup).diagnostics.is_empty() => Ok(()),
        Some(found) => shown(&format!("{found:?}")),
    }
}

/// Numbers are read in the first 256 KB of a text only: the blanks push the evidence for least increments out of it.
#[test]
fn a_program_whose_numbers_would_be_read_in_another_unit_stays() {
    let compact = "G1X100.Z-3.\n".repeat(21_800);
    let text = format!("{compact}X50000\nU1\n").into_bytes();
    let run = Run::finished(text.clone(), Setup::default());
    assert_eq!(run.decimal_rule(), DecimalRule::LeastIncrement);
    assert!(matches!(difference(&run, formatted(&text)), Some(Difference::Motions(_))));
}

#[test]
fn one_blank_is_between_words_and_none_in_a_word() {
    check("G01X50.Z-2F.1", "G01 X50. Z-2 F.1");
    check("N10G01  X 26\tZ - 5.", "N10 G01 X26 Z-5.");
    check("G01 X50,C2", "G01 X50 ,C2");
    check("G01 X50 , R 1", "G01 X50 ,R1");
    check("N10(FACE)G01(IN)X5", "N10 (FACE) G01 (IN) X5");
    check("O 0001(DEMO)N5", "O0001 (DEMO) N5");
}

#[test]
fn letters_are_capitals_except_in_comments_and_names() {
    check("n10 g01 x5 (face)", "N10 G01 X5 (face)");
    check("o1 <shaft-1>g0", "O1<shaft-1> G00");
    check("o<Sub>", "O<Sub>");
    check("m98<Sub-1>l2", "M98 <Sub-1> L2");
    check(":12g01", ":12 G01");
}

#[test]
fn codes_have_two_digits() {
    check("G0 M3", "G00 M03");
    check("G001 M003 M030", "G01 M03 M30");
    check("G000", "G00");
    check_stays("G10 L2 P1\nG50.3 P1\nG54.1 P1\nG7.1 C20\nG1. X5\nM100\nG112\n");
    check_stays("T101 S5 F1 D2 H3 O1 N1 P1 Q2 L3 X0 R0001");
}

/// `X50` and `X50.` differ a thousandfold on some controls.
#[test]
fn points_signs_and_digits_stay() {
    check_stays("X50 Z50. U+5 W-0.500 F.1 R00.10 X-0");
    check_stays("N0010 T0101 O0002 S0500");
}

/// The examples of the reference, one for each rule.
#[test]
fn the_examples_of_the_reference_are_true() {
    let document = source("www/docs/command-line.md");
    let table = document.split("| part | rule | before | after |").nth(1).expect("a table");
    let rows: Vec<&str> = table.lines().skip(2).take_while(|line| line.starts_with('|')).collect();
    for row in &rows {
        let code =
            |cell: &str| -> Vec<String> { cell.split('`').skip(1).step_by(2).map(str::to_owned).collect() };
        let cells: Vec<&str> = row.split(" | ").collect();
        let [_, _, before, after] = cells[..] else { panic!("{row}") };
        let (before, after) = (code(before), code(after));
        assert!(!before.is_empty() && before.len() == after.len(), "{row}");
        before.iter().zip(&after).for_each(|(before, after)| check(before, after));
    }
    assert_eq!(rows.len(), 7);
}

#[test]
fn skipped_blocks_keep_their_slash() {
    check("/ g01 x5", "/G01 X5");
    check("/2g01x5", "/2 G01 X5");
    check("/n10g01", "/N10 G01");
    check("N10/X5", "N10 /X5");
    check("X5/3Z2", "X5 /3 Z2");
    check_stays("/");
}

#[test]
fn lines_and_indentation_stay_and_blanks_at_line_ends_go() {
    check("  g01 x5  \n\n\t\n\tZ2\t\n", "  G01 X5\n\n\n\tZ2\n");
    check("(a)  \nG01 X1 (b) ", "(a)\nG01 X1 (b)");
    check("g01x1;z2 ;(a);\n;x3", "G01 X1; Z2; (a);\n; X3");
    check("g01x1\r\nz2 \r\n\rx3 \r", "G01 X1\r\nZ2\r\n\rX3\r");
}

#[test]
fn a_macro_statement_keeps_what_is_in_its_brackets() {
    check("n5#1=[#2 +  3]", "N5 #1=[#2 +  3]");
    check("#1  =  2 (a  b)", "#1 = 2 (a  b)");
    check("if [#1 eq  2]  goto 10", "IF [#1 EQ  2] GOTO 10");
    check("IF[#1EQ1]THEN g1x5", "IF[#1EQ1]THEN G1X5");
    check("while[#1 lt 5]do1\nend1", "WHILE[#1 LT 5]DO1\nEND1");
    check("x#1z-[ #2+1 ]f.1", "X#1 Z-[ #2+1 ] F.1");
    check("g1 x round[#1]", "G01 XROUND[#1]");
    check("#3000=1(Stop  here)", "#3000=1 (Stop  here)");
    // What is printed is text.
    check_stays("DPRNT[x#100[53]  text]\npopen\n");
    check("n5dprnt[x#1[53] a]", "N5 dprnt[x#1[53] a]");
}

#[test]
fn the_tape_ends_the_program() {
    check("% \ng0x1\n%\ng0x1 \n", "%\nG00 X1\n%\ng0x1 \n");
    check_stays("%leader \nG00 X1\nM30%\n");
    check("o1\ng0x1\nm30 %\n", "O1\nG00 X1\nM30 %\n");
    check("\u{feff}g0x1", "\u{feff}G00 X1");
}

#[test]
fn what_is_not_well_formed_stays() {
    for block in [
        "g1 x5O",
        "GO1 x5",
        "g1  z,5",
        "x 1 0",
        "x5  hello",
        "x",
        "x-",
        "g1 (open",
        "x--5",
        "z–2",
        "g0x1；",
        "5 x",
        "[billet x62  z70",
        "g1 x5 // feed  back",
        "x1.2.3",
        "g0 x1  goto 5",
    ] {
        check_stays(block);
        check(&format!("{block}\ng0x1\n"), &format!("{block}\nG00 X1\n"));
    }
    // Other characters than blanks between the words.
    check("g0\0x1\u{a0}z2", "G00\0X1\u{a0}Z2");
}

#[test]
fn bytes_that_are_not_text_stay() {
    assert_eq!(formatted(b"g0x1(\xb4\xd6\xff)\r\nz2"), b"G00 X1 (\xb4\xd6\xff)\r\nZ2");
}

#[test]
fn the_programs_of_the_gallery_run_the_same() {
    for program in fixtures::all() {
        let setup = Setup::from_json(&program.setup).expect("a setup");
        let text = program.text.as_bytes();
        check_runs_the_same(text, &setup).unwrap_or_else(|why| panic!("{}: {why}", program.id));
        let run = Run::finished(text.to_vec(), setup.clone());
        assert_eq!(difference(&run, formatted(text)), None, "{}", program.id);
    }
}

/// A program without blanks, in small letters: its formatted form is that of the program.
#[test]
fn a_program_without_blanks_is_formatted_the_same() {
    let text = "N10 G00 X52. Z2. M08\nN20 G71 U2. R0.5\n/N30 G01 X-1. F0.2\nM30\n";
    check(&text.replace([' '], "").to_lowercase(), text);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_programs_run_the_same(text in program(), setup in any_setup()) {
        check_runs_the_same(text.as_bytes(), &small(&setup)).map_err(TestCaseError::fail)?;
    }

    #[test]
    fn programs_of_a_workshop_run_the_same(text in prop_oneof![shop_program(), mistyped(shop_program())]) {
        check_runs_the_same(text.as_bytes(), &small(&Setup::default())).map_err(TestCaseError::fail)?;
    }

    #[test]
    fn pieces_run_the_same(pieces in prop::collection::vec(piece(), 0..40)) {
        check_runs_the_same(pieces.concat().as_bytes(), &small(&Setup::default())).map_err(TestCaseError::fail)?;
    }

    #[test]
    fn no_bytes_break_it(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        let after = formatted(&bytes);
        prop_assert_eq!(formatted(&after), after);
    }
}

#[test]
fn files_are_formatted_in_place() {
    // (粗车) in GB18030, and Windows line ends.
    let (before, after) = (
        &b"o1 (\xb4\xd6\xb3\xb5)\r\ng0x60z2m3s500 \r\nm30\r\n"[..],
        b"O1 (\xb4\xd6\xb3\xb5)\r\nG00 X60 Z2 M03 S500\r\nM30\r\n",
    );
    let path = file("format-in-place.nc", "");
    std::fs::write(&path, before).expect("a file");
    let name = path.to_str().expect("a name");
    let output = run(&["format", name, "--check"], b"");
    assert_eq!((output.status.code(), output.stdout), (Some(1), format!("{name}\n").into_bytes()));
    assert_eq!(std::fs::read(&path).expect("a file"), before);
    let output = run(&["format", name], b"");
    assert_eq!((output.status.code(), output.stdout.len()), (Some(0), 0));
    assert_eq!(std::fs::read(&path).expect("a file"), after);
    let told = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(told.contains("1 of 1 program formatted"), "{told}");
    assert_eq!(run(&["format", name, "--check"], b"").status.code(), Some(0));
}

#[test]
fn standard_input_is_formatted_to_standard_output() {
    let output = run(&["format", "-"], b"g0x1\nm30\n");
    assert_eq!(
        (output.status.code(), output.stdout, output.stderr),
        (Some(0), b"G00 X1\nM30\n".to_vec(), Vec::new())
    );
    // A program that does not change is written as well.
    assert_eq!(run(&["format", "-"], b"G00 X1\nM30\n").stdout, b"G00 X1\nM30\n");
    assert_eq!(run(&["format", "-", "--check"], b"g0\n").stdout, b"<stdin>\n");
}

#[test]
fn a_diff_names_the_lines() {
    let output = run(&["format", "-", "--diff"], b"O1\ng0x1\nM30\n");
    let diff = "--- <stdin>\n+++ <stdin>\n@@ -1,3 +1,3 @@\n O1\n-g0x1\n+G00 X1\n M30\n";
    assert_eq!((output.status.code(), String::from_utf8_lossy(&output.stdout).as_ref()), (Some(1), diff));
    let output = run(&["format", "-", "--diff"], b"G00 X1\nM30\n");
    assert_eq!((output.status.code(), output.stdout.len()), (Some(0), 0));
}

#[test]
fn a_folder_stands_for_its_programs() {
    let folder = std::path::PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("format-folder");
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(folder.join("old")).expect("a folder");
    for name in ["a.nc", "b.nc", "old/c.nc"] {
        std::fs::write(folder.join(name), "g0x1\nm30\n").expect(name);
    }
    let name = folder.to_str().expect("a name");
    let output = run(&["format", name, "--exclude", "old/"], b"");
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    let read = |name: &str| std::fs::read_to_string(folder.join(name)).expect(name);
    assert_eq!(
        [read("a.nc"), read("b.nc"), read("old/c.nc")],
        ["G00 X1\nM30\n", "G00 X1\nM30\n", "g0x1\nm30\n"]
    );
}

#[test]
fn one_program_can_be_written_elsewhere() {
    let (from, to) = (file("format-from.nc", "g0x1\nm30\n"), file("format-to.nc", ""));
    let [from, to] = [&from, &to].map(|path| path.to_str().expect("a name"));
    assert_eq!(run(&["format", from, "-o", to], b"").status.code(), Some(0));
    assert_eq!(std::fs::read(to).expect("a file"), b"G00 X1\nM30\n");
    assert_eq!(std::fs::read(from).expect("a file"), b"g0x1\nm30\n");
    assert_eq!(run(&["format", from, to, "-o", to], b"").status.code(), Some(2));
}

#[test]
fn a_program_for_another_control_stays() {
    let siemens = "%_N_PART_MPF\nN10 G0 X50 Z2\nn20 g1 x40 f.2\nM30\n";
    let path = file("format-foreign.nc", siemens);
    let output = run(&["format", path.to_str().expect("a name")], b"");
    let told = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(told.contains("not formatted: it is a program for another control"), "{told}");
    assert_eq!(output.status.code(), Some(2));
    assert_eq!(std::fs::read_to_string(&path).expect("a file"), siemens);
}
