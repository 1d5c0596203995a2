//! `renumber`: the numbers of blocks and the words that refer to them, refusals, and that no program
//! runs differently.

use crate::cli::{file, run};
use crate::fixtures;
use crate::random_programs;

use gcode_playground::message::applied;
use gcode_playground::proof::{Difference, difference};
use gcode_playground::renumber::{Blocks, Numbering, Reason, Refused, Source, edits};
use gcode_playground::run::Run;
use gcode_playground::setup::Setup;
use gcode_playground::setup::dialect::{CodeList, Control};
use gcode_playground::{analyze, api};
use proptest::prelude::*;
use random_programs::{any_setup, program, small};

const TENS: Numbering = Numbering::Ascending { from: 10, step: 10, blocks: Blocks::Numbered };
const ALL: Numbering = Numbering::Ascending { from: 10, step: 10, blocks: Blocks::All };

fn source(text: &str) -> Source<'_> {
    Source { text: text.as_bytes(), own: text.len(), codes: CodeList::A, control: Control::Fanuc }
}

fn renumbered(text: &str, numbering: Numbering) -> Result<String, Refused> {
    let edits = edits(source(text), numbering)?;
    Ok(String::from_utf8(applied(text.as_bytes(), &edits)).expect("UTF-8"))
}

#[track_caller]
fn check_with(numbering: Numbering, before: &str, after: &str) {
    assert_eq!(renumbered(before, numbering).as_deref(), Ok(after), "from:\n{before}");
    assert_eq!(renumbered(after, numbering).as_deref(), Ok(after), "the second time");
    assert_eq!(
        difference(&Run::finished(before.into(), Setup::default()), after.into()),
        None,
        "\n{before}\n{after}"
    );
}

#[track_caller]
fn check(before: &str, after: &str) {
    check_with(TENS, before, after);
}

/// The reason why a program is not renumbered, and the text that it is about.
#[track_caller]
fn refusal(text: &str, numbering: Numbering) -> (Reason, String) {
    let refused = renumbered(text, numbering).expect_err(text);
    (refused.reason, refused.span.quote(text.as_bytes()))
}

#[test]
fn blocks_with_a_number_get_new_ones() {
    check("O1\nN5 G00 X50\nZ2\nN7G01 Z-5 F.1\nM30\n", "O1\nN10 G00 X50\nZ2\nN20G01 Z-5 F.1\nM30\n");
    check("n3 G00 X5\n/N4 Z2\nN 9 M30\n", "n10 G00 X5\n/N20 Z2\nN 30 M30\n");
    check("(N1 A) N1 G00 X5 (N1)\n(N2)\nM30\n", "(N1 A) N10 G00 X5 (N1)\n(N2)\nM30\n");
    let odd = Numbering::Ascending { from: 1, step: 2, blocks: Blocks::Numbered };
    check_with(odd, "N10\nN20\nN30 M30\n", "N1\nN3\nN5 M30\n");
}

#[test]
fn numbers_with_leading_zeros_keep_their_width() {
    check("N0005 G00 X5\nN0006 M30\n", "N0010 G00 X5\nN0020 M30\n");
    let far = Numbering::Ascending { from: 9990, step: 10, blocks: Blocks::Numbered };
    check_with(far, "N0001\nN0002 M30\n", "N9990\nN10000 M30\n");
    check_with(ALL, "N0001 G00 X5\nZ2\nM30\n", "N0010 G00 X5\nN0020 Z2\nN0030 M30\n");
}

#[test]
fn the_contour_of_a_cycle_keeps_its_blocks() {
    check(
        "O1\nT0101\nM03 S500\nG00 X52 Z2\nG71 U2 R1\nG71 P7Q8 U.4 W.1 F.2\nN7 G00 X30\nN8 G01 Z-20\nG70 P7 Q 8\nM30\n",
        "O1\nT0101\nM03 S500\nG00 X52 Z2\nG71 U2 R1\nG71 P10Q20 U.4 W.1 F.2\nN10 G00 X30\nN20 G01 Z-20\nG70 P10 Q 20\nM30\n",
    );
    // P and Q of other cycles, and of G04, are no numbers of blocks.
    let text = "N1 G00 X30 Z2\nN2 G04 P1\nN3 G75 R1\nN4 G75 X20 P2 Q3 F.1\nN5 M30\n";
    check(
        text,
        &text
            .replace("N1 ", "N10 ")
            .replace("N2", "N20")
            .replace("N3", "N30")
            .replace("N4", "N40")
            .replace("N5", "N50"),
    );
}

#[test]
fn jumps_lead_to_the_same_blocks() {
    check(
        "#1=0\nN1 #1=#1+1\nIF[#1LT3]GOTO1\nIF [#1 GT 9] GOTO 2 (GOTO 3)\nGOTO 2\nN3 X1\nN2 M30\n",
        "#1=0\nN10 #1=#1+1\nIF[#1LT3]GOTO10\nIF [#1 GT 9] GOTO 30 (GOTO 3)\nGOTO 30\nN20 X1\nN30 M30\n",
    );
    check("#1=2\nIF[#1EQ1]THEN GOTO 5\nN5 M30\n", "#1=2\nIF[#1EQ1]THEN GOTO 10\nN10 M30\n");
    // Macro A: `G65 H80 P` jumps, `G65 P` calls.
    check(
        "G65 H02 P#200 Q1 R5\nG65 H81 P5 Q#200 R7\nG65 P9010 A5\nN5 M30\nO9010\nN5 M99\n",
        "G65 H02 P#200 Q1 R5\nG65 H81 P10 Q#200 R7\nG65 P9010 A5\nN10 M30\nO9010\nN10 M99\n",
    );
}

#[test]
fn calls_and_returns_lead_to_the_same_blocks() {
    // N5 of the caller is its second number, N5 of the subprogram the first.
    check(
        "O1\nN4 M98 P2 Q5\nG00 X1\nN5 M30\nO2\nG00 X2\nN5 X3\nM99 P5\n",
        "O1\nN10 M98 P2 Q10\nG00 X1\nN20 M30\nO2\nG00 X2\nN10 X3\nM99 P20\n",
    );
    check("M97 P7 L2\nN1 M30\nN7 G00 W1\nM99\n", "M97 P20 L2\nN10 M30\nN20 G00 W1\nM99\n");
    // M99 P in the main program is a jump in it.
    check("N1 G00 X1\n/M99 P3\nX2\nN3 M30\n", "N10 G00 X1\n/M99 P20\nX2\nN20 M30\n");
    check(
        "O1\nM98 P30002\nN8 X1\nM30\nO2\nIF[#500EQ1]THEN M99 P8\nM99\n",
        "O1\nM98 P30002\nN10 X1\nM30\nO2\nIF[#500EQ1]THEN M99 P10\nM99\n",
    );
    // By name.
    check("<A>\nM98 <SUB> Q3\nM30\n<SUB>\nN3 M99\n", "<A>\nM98 <SUB> Q10\nM30\n<SUB>\nN10 M99\n");
}

#[test]
fn several_callers_may_have_the_block_at_the_same_number() {
    let text = |number: u32| {
        format!("O1\nM98 P3\nM98 P2\nN{number} M30\nO2\nM98 P3\nN{number} M99\nO3\n/M99 P{number}\nM99\n")
    };
    check(&text(7), &text(10));
    let shifted = text(7).replace("O2\n", "O2\nN1\n");
    assert_eq!(refusal(&shifted, TENS), (Reason::SeveralCallers { number: 7 }, "P7".to_owned()));
}

#[test]
fn each_program_is_numbered_on_its_own() {
    check(
        "O1\nN3 M98 P2\nN4 M30\nO2\nN3 G00 X1\nN9 M99\n",
        "O1\nN10 M98 P2\nN20 M30\nO2\nN10 G00 X1\nN20 M99\n",
    );
}

#[test]
fn all_blocks_can_be_numbered() {
    check_with(
        ALL,
        "%\nO0001 (SHAFT)\n(ROUGH)\nG00 X50 Z2; Z1;\n\n/2 G01 Z-5 F.1\n  N1 #1=2\nIF[#1EQ1]GOTO1\n(A) X2\nM30\n%\nX1\n",
        "%\nO0001 (SHAFT)\n(ROUGH)\nN10 G00 X50 Z2; N20 Z1;\n\n/2 N30 G01 Z-5 F.1\n  N40 #1=2\nN50 IF[#1EQ1]GOTO40\nN60 (A) X2\nN70 M30\n%\nX1\n",
    );
}

#[test]
fn numbers_that_nothing_refers_to_can_be_removed() {
    check_with(
        Numbering::Remove,
        "O1\nN10 G00 X50\nN20G71 U2 R1\n/N25 G71 P30 Q40 U.4 F.2\nN30 G00 X30\nN35 (N35)\nN40 G01 Z-20\nN50 GOTO 60\nN60 M30\n",
        "O1\nG00 X50\nG71 U2 R1\n/G71 P30 Q40 U.4 F.2\nN30 G00 X30\n(N35)\nN40 G01 Z-20\nGOTO 60\nN60 M30\n",
    );
}

/// Without its number, the block would begin a program, or another block number would be its own.
#[test]
fn a_number_before_another_one_stays() {
    let text = "O1\nN1 O2\nN2 N3 X1\nN4 :5\nN6 <A>\nM30\n";
    assert_eq!(renumbered(text, Numbering::Remove).as_deref(), Ok(text));
}

#[test]
fn a_number_that_is_only_known_at_run_time_is_refused() {
    for (block, word) in [
        ("GOTO #1", " #1"),
        ("IF[#1EQ1]GOTO[#1+10]", "[#1+10]"),
        ("M99 P#1", "P#1"),
        ("G71 P#1 Q2", "P#1"),
        ("G65 H80 P#1", "P#1"),
        ("M97 P[#1]", "P[#1]"),
        ("IF[#1EQ1]THEN M99 P#1", "P#1"),
        ("M98 P#1 Q2", "Q2"),
    ] {
        let text = format!("#1=2\n{block}\nN2 M30\n");
        assert_eq!(refusal(&text, TENS), (Reason::Computed, word.to_owned()), "{block}");
        assert_eq!(refusal(&text, Numbering::Remove).0, Reason::Computed, "{block}");
    }
}

#[test]
fn a_number_that_is_not_clear_is_refused() {
    let missing = |text: &str, number: u32, word: &str| {
        assert_eq!(refusal(text, TENS), (Reason::Missing { number }, word.to_owned()), "{text}");
    };
    missing("GOTO 5\nN4 M30\n", 5, "5");
    missing("O1\nN4 M98 P2\nM30\nO2\nN7 M99 P7\n", 7, "P7");
    missing("O1\nM98 P2 Q9\nM30\nO2\nN7 M99\n", 9, "Q9");
    missing("O2\nN7 M99 P8\n", 8, "P8");
    let (reason, word) = refusal("N1 G00 X1\nIF[#1EQ1]GOTO 5\nN5 X2\nN5 M30\n", TENS);
    assert!(matches!(reason, Reason::Twice { number: 5, .. }) && word == "5", "{reason:?} {word}");
    // Two blocks with a number that nothing refers to are no obstacle.
    check("N5 G00 X1\nN5 M30\n", "N10 G00 X1\nN20 M30\n");
    assert_eq!(refusal("N1 #1=#4114\nM30\n", TENS), (Reason::Variable, "#4114".to_owned()));
    assert_eq!(refusal("N1 G00 X1\nG71 P1 Q2 X\nN2 M30\n", TENS).0, Reason::NotWellFormed);
    assert_eq!(refusal("N1 G00 X1\nGOTO N 2\nN2O M30\n", TENS).0, Reason::Missing { number: 2 });
    // A text that names no block is no obstacle.
    assert!(renumbered("N1 G00 X1\nhello world\nN2 M30\n", TENS).is_ok());
}

#[test]
fn a_call_of_a_program_that_is_not_there_stays() {
    check("N1 M98 P9000 Q5\nN2 M30\n", "N10 M98 P9000 Q5\nN20 M30\n");
}

#[test]
fn the_number_is_within_the_range_of_the_control() {
    let text = "N1 G00 X1\nN2 X2\nN3 M30\n";
    let numbering = |from| Numbering::Ascending { from, step: 10, blocks: Blocks::Numbered };
    let refused =
        |source: Source, from: u32| edits(source, numbering(from)).err().map(|refused| refused.reason);
    assert_eq!(refused(source(text), 99_979), None);
    assert_eq!(refused(source(text), 99_980), Some(Reason::TooLarge { most: 99_999 }));
    let gsk = Source { control: Control::Gsk, codes: CodeList::Gsk, ..source(text) };
    assert_eq!(refused(gsk, 9_979), None);
    assert_eq!(refused(gsk, 9_980), Some(Reason::TooLarge { most: 9_999 }));
    assert_eq!(refused(source(text), u32::MAX), Some(Reason::TooLarge { most: 99_999 }));
}

#[test]
fn the_subprograms_of_other_files_stay() {
    let own = "O1\nN3 M98 P2 Q7\nN5 M30\n";
    let with = |sub: &str| {
        let text = format!("{own}{sub}");
        let source = Source { own: own.len(), ..source(&text) };
        edits(source, TENS).map(|edits| String::from_utf8(applied(text.as_bytes(), &edits)).expect("UTF-8"))
    };
    // Neither its numbers nor its jumps change, whatever they are.
    let sub = "O2\nN7 GOTO #1\nM99\n";
    assert_eq!(with(sub).as_deref(), Ok(&*format!("O1\nN10 M98 P2 Q7\nN20 M30\n{sub}")));
    let refused = with("O2\nN7 M99 P5\n").expect_err("it refers to N5");
    assert_eq!(
        (refused.reason, refused.span.quote(own.as_bytes())),
        (Reason::OtherFile { number: 5 }, "N5".into())
    );
    assert_eq!(with("O2\nN7 M99 P#1\n").map_err(|refused| refused.reason), Err(Reason::Computed));
}

/// The motions as rows, without the places in the text.
fn motions(text: &str, setup: &Setup) -> Vec<String> {
    let analysis = analyze(text.as_bytes(), setup);
    let rows = api::motions(&analysis.motions, &analysis.setup.machine);
    rows.map(|row| serde_json::to_string(&row).expect("a row")).collect()
}

/// Renumbers in each way: no motion and no message changes, and the second time nothing changes. Returns
/// whether a program was renumbered.
fn check_runs_the_same(text: &str, setup: &Setup) -> Result<bool, String> {
    let analysis = analyze(text.as_bytes(), setup);
    let control = setup.dialect.control.unwrap_or_default();
    let renumbered = |text: &str, numbering| {
        let source = Source { text: text.as_bytes(), own: text.len(), codes: analysis.codes, control };
        let edits = edits(source, numbering).ok()?;
        Some(String::from_utf8(applied(text.as_bytes(), &edits)).expect("UTF-8"))
    };
    let mut was_renumbered = false;
    for numbering in [TENS, ALL, Numbering::Remove] {
        let Some(after) = renumbered(text, numbering) else { continue };
        was_renumbered = true;
        let shown = |what: &str| Err(format!("{what}: {numbering:?}\n{text}\n--- became:\n{after}"));
        if renumbered(&after, numbering).as_ref() != Some(&after) {
            return shown("not the same the second time");
        }
        for block_skip in [Vec::new(), (1..=9).collect()] {
            let setup = Setup { block_skip, ..setup.clone() };
            if motions(text, &setup) != motions(&after, &setup) {
                return shown("other motions");
            }
        }
        match difference(&Run::finished(text.into(), setup.clone()), after.clone().into()) {
            None | Some(Difference::OtherControl) => {}
            // Advice about a word depends on the length of a message about its block (`Diagnostic::is_about`). Such a
            // program stays as it is.
            Some(Difference::Messages) if !analysis.diagnostics.is_empty() => {}
            Some(found) => return shown(&format!("{found:?}")),
        }
    }
    Ok(was_renumbered)
}

#[test]
fn the_programs_of_the_gallery_run_the_same() {
    let (mut count, mut all) = (0, 0);
    for program in fixtures::all() {
        let setup = Setup::from_json(&program.setup).expect("a setup");
        let was_renumbered = check_runs_the_same(&program.text, &setup);
        count += usize::from(was_renumbered.unwrap_or_else(|why| panic!("{}: {why}", program.id)));
        all += 1;
    }
    assert!(10 * count > 9 * all, "{count} of {all}");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_programs_run_the_same(text in program(), setup in any_setup()) {
        check_runs_the_same(&text, &small(&setup)).map_err(TestCaseError::fail)?;
    }
}

/// A line of a program; the numbers of blocks are indices of labels.
#[derive(Clone, Debug)]
struct Line {
    /// The index of the label of the line.
    label: Option<usize>,
    /// Before its reference, and after it.
    words: (&'static str, &'static str),
    /// The program and the label that it refers to.
    refers: Option<(usize, usize)>,
}

/// Words before and after the number of a block, and the program that contains the block: that of the line,
/// or that number.
const REFERENCES: [(&str, &str, Option<usize>); 12] = [
    ("GOTO ", "", None),
    ("GOTO", " (GOTO 1)", None),
    ("IF[#1EQ1]GOTO ", "", None),
    ("/GOTO ", "", None),
    ("IF[#1EQ1]THEN M97 P", "", None),
    ("M97 P", " L2", None),
    ("G65 H81 P", " Q1 R2", None),
    ("G70 P", " Q@", None),
    ("G71 P", " Q@ U.1", None),
    ("M98 P2 Q", "", Some(1)),
    ("G00 X1 M98 P30002 L1 Q", "", Some(1)),
    ("M98 Q", " P2", Some(1)),
];

/// References of the subprogram to blocks of the first program, which alone calls it.
const RETURNS: [(&str, &str); 3] = [("M99 P", ""), ("/M99 P", ""), ("IF[#1EQ1]THEN M99 P", "")];

const PLAIN: [&str; 6] =
    ["G00 X50 Z2", "#1=2", "X1 (N1 P1 GOTO 1)", "G04 P10", "DPRNT[GOTO 1]", "G76 P010060 Q50 R.1"];

/// Programs with these numbers of lines, each with the seed of its content.
fn lines(seeds: &[Vec<u32>]) -> Vec<Vec<Line>> {
    let labels: Vec<usize> =
        seeds.iter().map(|seeds| seeds.iter().filter(|seed| seed.is_multiple_of(2)).count()).collect();
    let line = |program: usize, label: &mut usize, seed: u32| {
        let own = seed.is_multiple_of(2).then(|| (*label, *label += 1).0);
        let (choice, target) = ((seed / 2) as usize, (seed / 64) as usize);
        let reference = match choice % 32 {
            // Only the first program calls the second.
            at if at < REFERENCES.len() => Some(REFERENCES[at]).filter(|own| program == 0 || own.2.is_none()),
            at if at < 16 && program == 1 => {
                let (before, after) = RETURNS[at % RETURNS.len()];
                Some((before, after, Some(0)))
            }
            _ => None,
        };
        let to = |in_program: Option<usize>| in_program.unwrap_or(program);
        match reference.filter(|(_, _, in_program)| labels[to(*in_program)] > 0) {
            Some((before, after, in_program)) => {
                let to = to(in_program);
                Line { label: own, words: (before, after), refers: Some((to, target % labels[to])) }
            }
            None => Line { label: own, words: (PLAIN[choice % PLAIN.len()], ""), refers: None },
        }
    };
    let program = |(program, seeds): (usize, &Vec<u32>)| {
        let mut label = 0;
        seeds.iter().map(|seed| line(program, &mut label, *seed)).collect()
    };
    seeds.iter().enumerate().map(program).collect()
}

/// The text of programs in which `number` is the number of a label.
fn written(programs: &[Vec<Line>], number: impl Fn(usize, usize) -> u32) -> String {
    let mut text = String::new();
    for (program, lines) in programs.iter().enumerate() {
        text += &format!("O{}\n{}", program + 1, if program == 0 { "M98 P2\n" } else { "" });
        for line in lines {
            text += &line.label.map_or(String::new(), |label| format!("N{} ", number(program, label)));
            let referred = line.refers.map(|(program, label)| number(program, label).to_string());
            let referred = referred.unwrap_or_default();
            text += &format!("{}{referred}{}\n", line.words.0, line.words.1.replace('@', &referred));
        }
    }
    text
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1000, failure_persistence: None, ..ProptestConfig::default() })]

    /// The expected text is written from the same lines with the new numbers, without reading a program.
    #[test]
    fn each_reference_leads_to_the_block_that_it_led_to(
        seeds in prop::collection::vec(prop::collection::vec(any::<u32>(), 1..9), 2..4),
        offset in 10u32..900, factor in prop::sample::select(vec![1u32, 7, 13]),
        from in 1u32..50, step in 1u32..20,
    ) {
        let programs = lines(&seeds);
        // Unique numbers, not ascending: the factors have no divisor in common with 101.
        let number = |program: usize, label: usize| offset + 101 * program as u32 + factor * label as u32 % 101;
        let before = written(&programs, number);
        let after = written(&programs, |_, label| from + step * label as u32);
        let numbering = Numbering::Ascending { from, step, blocks: Blocks::Numbered };
        prop_assert_eq!(renumbered(&before, numbering).map_err(|refused| (refused, before)), Ok(after));
    }
}

#[test]
fn a_file_is_renumbered_in_place() {
    let path = file("renumber.nc", "O1\r\nN1 G00 X50\r\nGOTO 3\r\nN3 M30\r\n");
    let name = path.to_str().expect("a name");
    let diff = run(&["renumber", name, "--diff", "--from", "5", "--step", "5"], b"");
    assert_eq!(diff.status.code(), Some(1));
    assert!(
        String::from_utf8_lossy(&diff.stdout).contains("-GOTO 3"),
        "{}",
        String::from_utf8_lossy(&diff.stdout)
    );
    assert_eq!(run(&["renumber", name, "--check"], b"").status.code(), Some(1));
    assert_eq!(run(&["renumber", name, "--from", "5", "--step", "5"], b"").status.code(), Some(0));
    let text = || std::fs::read_to_string(&path).expect("a file");
    assert_eq!(text(), "O1\r\nN5 G00 X50\r\nGOTO 10\r\nN10 M30\r\n");
    assert_eq!(run(&["renumber", name, "--all"], b"").status.code(), Some(0));
    assert_eq!(text(), "O1\r\nN10 G00 X50\r\nN20 GOTO 30\r\nN30 M30\r\n");
    assert_eq!(run(&["renumber", name, "--remove"], b"").status.code(), Some(0));
    assert_eq!(text(), "O1\r\nG00 X50\r\nGOTO 30\r\nN30 M30\r\n");
    assert_eq!(run(&["renumber", "-"], b"N1 M30\n").stdout, b"N10 M30\n");
}

#[test]
fn a_refusal_names_the_place() {
    for (text, told) in [
        ("N1 G00 X1\nGOTO #1\nM30\n", "2: not renumbered: `#1` is known only at run time"),
        (
            "N1 G00 X1\nGOTO 5\nN5 X1\nN5 M30\n",
            "2: not renumbered: `5` refers to N5, which is there again in line 4",
        ),
        ("N1 G00 X1\nM99 P7\n", "2: not renumbered: `P7` refers to N7, and no such block is there"),
    ] {
        let path = file("renumber-refused.nc", text);
        let output = run(&["renumber", path.to_str().expect("a name")], b"");
        let found = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(found.contains(&format!("renumber-refused.nc:{told}")), "{found}");
        assert_eq!(output.status.code(), Some(2));
        assert_eq!(std::fs::read_to_string(&path).expect("a file"), text);
    }
    let many = "N1 X1\n".repeat(10_000);
    let output = run(&["renumber", "-"], many.as_bytes());
    let found = String::from_utf8_lossy(&output.stderr).into_owned();
    // The 10,000th block would be N100000.
    assert!(
        found.contains("<stdin>:10000: not renumbered: the number of this block would be above N99999"),
        "{found}"
    );
    assert_eq!(run(&["renumber", "-", "--step", "0"], b"").status.code(), Some(2));
    assert_eq!(run(&["renumber", "-", "--remove", "--all"], b"").status.code(), Some(2));
}

/// A subprogram in another file takes part in the comparison, and stays.
#[test]
fn a_subprogram_of_another_file_can_refer_to_a_block() {
    let folder = std::path::PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("renumber-folder");
    std::fs::create_dir_all(&folder).expect("a folder");
    let (main, sub) = (folder.join("main.nc"), folder.join("O0002.nc"));
    std::fs::write(&main, "O1\nN3 M98 P2\nN5 M30\n").expect("a file");
    let renumber = || run(&["renumber", main.to_str().expect("a name")], b"");
    std::fs::write(&sub, "O2\nN5 G00 X1\nM99 P5\n").expect("a file");
    let output = renumber();
    let told = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(told.contains("main.nc:3: not renumbered: a subprogram in another file refers to N5"), "{told}");
    std::fs::write(&sub, "O2\nN5 G00 X1\nM99\n").expect("a file");
    assert_eq!(renumber().status.code(), Some(0));
    assert_eq!(std::fs::read_to_string(&main).expect("a file"), "O1\nN10 M98 P2\nN20 M30\n");
    assert_eq!(std::fs::read_to_string(&sub).expect("a file"), "O2\nN5 G00 X1\nM99\n");
}
