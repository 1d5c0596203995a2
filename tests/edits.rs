//! After an edit only a part of the program runs again; motions and messages equal the result of a full run.
#[allow(dead_code, reason = "one of its programs is enough here")]
#[path = "speed/workload.rs"]
mod workload;

use crate::fixtures;
use std::sync::LazyLock;

use gcode_playground::limits::Limits;
use gcode_playground::message::Severity;
use gcode_playground::run::{Run, TextEdit};
use gcode_playground::setup::Setup;
use gcode_playground::setup::dialect::DecimalRule;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

/// The full result of a run, including the sign of zeros.
fn outcome(run: &Run) -> Vec<String> {
    let motions = run.motions();
    let rows = (0..motions.len())
        .map(|at| format!("{} {:?} {:?}", motions.line(at), motions.span(at), motions.get(at)));
    let messages = run.diagnostics().iter().map(|found| format!("{found:?}"));
    rows.chain(messages).chain([format!("{} blocks, {:?}", run.blocks(), run.code_list())]).collect()
}

fn finish(run: &mut Run) {
    while !run.advance(1_000) {}
}

/// Checks that an edited run equals a new one under the same decimal rule.
#[track_caller]
fn check(changed: &Run, setup: &Setup) {
    let (text, setup) = (changed.text().to_vec(), setup.clone());
    let mut whole = match changed.decided_rule() {
        Some(rule) => Run::with_decimal_rule(text, setup, rule),
        None => Run::new(text, setup),
    };
    finish(&mut whole);
    let (own, wanted) = (outcome(changed), outcome(&whole));
    if own != wanted {
        let first = own.iter().zip(&wanted).position(|(a, b)| a != b).unwrap_or(own.len().min(wanted.len()));
        let text = String::from_utf8_lossy(changed.text());
        panic!("{:?}\nis not\n{:?}\nin\n{text}", own.get(first), wanted.get(first));
    }
}

/// A typical edit of a text.
#[derive(Clone, Debug)]
enum Change {
    /// Types some text.
    Type(usize, String),
    /// Deletes this number of bytes.
    Delete(usize, usize),
    /// Deletes this number of lines.
    DeleteLines(usize, usize),
    /// Inserts a copy of this number of lines before another line.
    CopyLines(usize, usize, usize),
    /// Replaces the next digit.
    Digit(usize, u8),
    /// Undoes the last change.
    Undo,
    /// Replaces the whole text by itself.
    All,
}

fn change() -> impl Strategy<Value = Change> {
    let typed = prop_oneof![
        4 => "[0-9]",
        1 => "[XZ]-?[1-9]000\n|G71U800R500\n",
        2 => "[A-Z./\\- ]",
        2 => "(G1 X[1-9]0\\. Z-[1-9]\\.5|G0|G2 U2 W-1 R5|F0\\.[1-9]|S[1-9]00|X[1-9]|N10|M3|M00|M01|T0101|G4 P100|,R1|,C2|A30)\n?",
        1 => "(Y3 |Y0 |V1\n|G31 Z-3\n|G777 |G68\n|G69\n|G300\n|G28 U0 W0\n|G50 X50\n|F-1 )",
        1 => "(\n|\r\n|\r|;|\\(|\\)|%|O2\n|M30\n|/|#1=2\n|G41 |G42 |G40 |G90 |M99\n|M98 P2\n|外)",
    ];
    let at = || any::<prop::sample::Index>().prop_map(|at| at.index(1 << 24));
    prop_oneof![
        8 => (at(), typed).prop_map(|(at, text)| Change::Type(at, text)),
        4 => (at(), 1usize..6).prop_map(|(at, bytes)| Change::Delete(at, bytes)),
        2 => (at(), 1usize..20).prop_map(|(at, lines)| Change::DeleteLines(at, lines)),
        2 => (at(), at(), 1usize..20).prop_map(|(from, to, lines)| Change::CopyLines(from, to, lines)),
        6 => (at(), b'0'..=b'9').prop_map(|(at, digit)| Change::Digit(at, digit)),
        2 => Just(Change::Undo),
        1 => Just(Change::All),
    ]
}

impl Change {
    fn edit(&self, text: &[u8], undo: Option<TextEdit>) -> TextEdit {
        let at = |place: usize| place % (text.len() + 1);
        let line_start =
            |at: usize| text[..at].iter().rposition(|&byte| byte == b'\n').map_or(0, |found| found + 1);
        let lines_end = |at: usize, lines: usize| {
            let mut ends = text[at..].iter().enumerate().filter(|(_, byte)| **byte == b'\n');
            ends.nth(lines - 1).map_or(text.len(), |(found, _)| at + found + 1)
        };
        match self {
            Self::Type(place, typed) => {
                TextEdit { start: at(*place), end: at(*place), insert: typed.clone().into_bytes() }
            }
            Self::Delete(place, bytes) => {
                TextEdit { start: at(*place), end: (at(*place) + bytes).min(text.len()), insert: vec![] }
            }
            Self::DeleteLines(place, lines) => {
                let start = line_start(at(*place));
                TextEdit { start, end: lines_end(start, *lines), insert: vec![] }
            }
            Self::CopyLines(from, to, lines) => {
                let (from, to) = (line_start(at(*from)), line_start(at(*to)));
                TextEdit { start: to, end: to, insert: text[from..lines_end(from, *lines)].to_vec() }
            }
            Self::Digit(place, digit) => {
                let start = at(*place);
                let found = text[start..].iter().position(u8::is_ascii_digit);
                let start = found.map_or(text.len(), |found| start + found);
                TextEdit { start, end: (start + 1).min(text.len()), insert: vec![*digit] }
            }
            Self::Undo => undo.unwrap_or(TextEdit { start: 0, end: 0, insert: vec![] }),
            Self::All => TextEdit { start: 0, end: text.len(), insert: text.to_vec() },
        }
    }
}

/// Applies changes one after the other. With `patience` the run advances only by that number of blocks before
/// the next change.
fn change_again_and_again(text: Vec<u8>, setup: &Setup, stride: usize, changes: &[(Change, Option<usize>)]) {
    let limits = Limits { stride, messages: 40, motions: 20_000, ..Limits::default() };
    let setup = &Setup { limits, ..setup.clone() };
    let mut run = Run::new(text, setup.clone());
    finish(&mut run);
    let mut undo = None;
    for (change, patience) in changes {
        let edit = change.edit(run.text(), undo.take());
        let (start, end) = (edit.start, edit.start + edit.insert.len());
        undo = Some(TextEdit { start, end, insert: run.text()[start..edit.end].to_vec() });
        run.edit(edit);
        match patience {
            Some(blocks) => {
                run.advance(*blocks);
            }
            None => {
                finish(&mut run);
                check(&run, setup);
            }
        }
    }
    finish(&mut run);
    check(&run, setup);
}

/// All programs of the gallery and of the tests, with their setups.
static PROGRAMS: LazyLock<Vec<(String, Setup)>> = LazyLock::new(|| {
    let read = |program: fixtures::Program| (program.text, Setup::from_json(&program.setup).expect("setup"));
    let found: Vec<_> = fixtures::all().into_iter().map(read).collect();
    assert!(found.len() > 40);
    found
});

/// A program of many short blocks of all kinds, none of which refers to another place of the text.
fn generated(seed: u32) -> String {
    let mut number = seed;
    let mut next = |below: u32| {
        number = number.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (number >> 8) % below
    };
    let mut text = String::from("%\nO7 (MANY KINDS)\nG21 G40 G99\nT0101\nM3 S500\nG0 X60. Z5.\nG1 Z0 F0.2\n");
    for _ in 0..120 {
        text += &match next(18) {
            0 => format!("G0 X{}. Z{}.\n", 20 + next(60), next(9)),
            1 => format!("G1 X{}.5 F0.{}\n", 20 + next(60), 1 + next(9)),
            2..6 => format!("Z-{}.{}\n", next(60), next(99)),
            6 => format!("G2 U2. W-1. R{}.\n", 2 + next(9)),
            7 => format!("G1 Z-{}. ,R0.{}\n", next(60), 1 + next(9)),
            8 => format!("(REMARK {})\n", next(99)),
            9 => format!("G90 X{}. Z-{}.\n", 20 + next(30), next(60)),
            10 => format!("G{} G1 X{}. Z-{}.\n", 40 + next(3), 20 + next(40), next(60)),
            11 => format!("G4 P{}\n", 100 * next(9)),
            12 => format!("G96 S{} ; M8\n", 100 + next(99)),
            13 => format!("#{}={}\nG1 U-0.5 W-0.[#1]\n", 1 + next(3), next(9)),
            14 => format!("X{}.Z\n", next(99)),
            15 => format!("M{:02}\n", next(2)),
            16 => format!("G1 Z-{}. M{}\n", next(60), next(2)),
            _ => format!("N{} G1 U0.{} W-0.{}\n", next(999), next(9), next(9)),
        };
    }
    text + "G0 X100. Z50.\nM30\n%\n"
}

/// A program that mills with a Y axis: moves in all planes, compensation on and off.
fn milled(seed: u32) -> String {
    let mut number = seed;
    let mut next = |below: u32| {
        number = number.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (number >> 8) % below
    };
    let mut text = String::from("O8\nG21 G40 G98\nT0101\nM45\nM13 S500\nG0 X60. Z5.\nG1 Z0 F200\n");
    for _ in 0..120 {
        text += &match next(12) {
            0 => format!("G{} G{}\n", 17 + next(3), 40 + next(3)),
            1 => format!("G0 X{}. Y{}.\n", 20 + next(60), next(9)),
            2..5 => format!("G1 X{}. Y-{}.5\n", 20 + next(60), next(30)),
            5 => format!("Z-{}. V{}.\n", next(9), next(3)),
            6 => format!("G3 U2. V2. R{}.\n", 2 + next(9)),
            7 => format!("G2 W-2. V2. R{}.\n", 2 + next(9)),
            8 => format!("G1 Y{}. ,R0.{}\n", next(60), 1 + next(9)),
            9 => format!("G1 X{}. Z-{}.\n", 20 + next(40), next(60)),
            10 => "Y0\n".to_owned(),
            _ => format!("C{}\n", 90 * next(4)),
        };
    }
    text + "G0 G40 X100. Y0 Z50.\nM30\n"
}

fn changes(most: usize) -> impl Strategy<Value = Vec<(Change, Option<usize>)>> {
    let patience = prop_oneof![3 => Just(None), 1 => (0usize..60).prop_map(Some)];
    prop::collection::vec((change(), patience), 1..most)
}

proptest! {
    // The same cases on every machine. This number takes seconds; `PROPTEST_CASES` can request more.
    #![proptest_config(ProptestConfig {
        rng_seed: RngSeed::Fixed(5), max_shrink_iters: 2_000, failure_persistence: None,
        ..ProptestConfig::default()
    })]

    #[test]
    fn changed_programs_of_the_gallery(which in any::<prop::sample::Index>(), changes in changes(30), stride in 1usize..30) {
        let (text, setup) = &PROGRAMS[which.index(PROGRAMS.len())];
        change_again_and_again(text.clone().into_bytes(), setup, stride, &changes);
    }

    #[test]
    fn changed_programs_of_all_kinds_of_blocks(seed in any::<u32>(), changes in changes(30), stride in 1usize..50) {
        let setup = Setup::from_json(r#"{"tools": {"T0101": {"noseRadius": 0.4, "tip": 3}}}"#).expect("setup");
        change_again_and_again(generated(seed).into_bytes(), &setup, stride, &changes);
    }

    #[test]
    fn changed_programs_with_a_y_axis(seed in any::<u32>(), changes in changes(20), stride in 1usize..50) {
        let setup = r#"{"machine": {"yAxis": true}, "tools": {"T0101": {"toolRadius": 2}}}"#;
        let setup = Setup::from_json(setup).expect("setup");
        change_again_and_again(milled(seed).into_bytes(), &setup, stride, &changes);
    }

    #[test]
    fn changed_programs_in_least_increments(changes in changes(30), stride in 1usize..30) {
        let text: String = (0..60).map(|at| format!("G1 X{}. Z-{at}500\nU-1000\nX2.\n", 20 + at)).collect();
        let text = format!("G21 M3 S500 F.2\nG0 X90. Z2.\n{text}M30\n");
        change_again_and_again(text.into_bytes(), &Setup::default(), stride, &changes);
    }

    #[test]
    fn changed_plain_programs(lines in 50usize..600, changes in changes(20), stride in 1usize..300) {
        change_again_and_again(workload::plain(lines).into_bytes(), &Setup::default(), stride, &changes);
    }
}

/// The messages of rules follow an edit of the rules comment, even with snapshots made under the earlier
/// comment.
#[test]
fn a_changed_comment_of_rules_counts_for_the_whole_program() {
    let limits = Limits { stride: 20, ..Limits::default() };
    let setup = Setup { limits, ..Setup::default() };
    let moves: String = (0..200).map(|x| format!("G00 X{x} Z2\n")).collect();
    let text = format!("(RULES cut-with-spindle-stopped=info)\n{moves}G7.7\n{moves}");
    let mut run = Run::new(text.into_bytes(), setup.clone());
    finish(&mut run);
    let told = |run: &Run| -> Vec<_> {
        let of_rule = |slug: &str| {
            let mut found = run.diagnostics().iter().filter(|found| found.message.slug() == slug);
            found.next().map(|found| found.severity)
        };
        ["unknown-g-code", "no-program-end"].map(of_rule).to_vec()
    };
    let mut rules = "cut-with-spindle-stopped=info".to_owned();
    for (next, expected) in [
        ("unknown-g-code=warning", [Some(Severity::Warning), Some(Severity::Warning)]),
        ("unknown-g-code=off no-program-end=error", [None, Some(Severity::Error)]),
        ("no-program-end=off", [Some(Severity::Error), None]),
    ] {
        let (start, end) = ("(RULES ".len(), "(RULES ".len() + rules.len());
        run.edit(TextEdit { start, end, insert: next.into() });
        finish(&mut run);
        check(&run, &setup);
        assert_eq!(told(&run), expected, "{next}");
        rules = next.to_owned();
    }
}

/// The decimal rule is decided when a text is loaded, and stays while the user types.
#[test]
fn the_decimal_rule_is_not_decided_anew_while_typing() {
    let program = "G20 M3 S500 F.01\nG0 X2. Z.1\nG1 X1. F.016\nZ-1.\nX2.\n";
    let last = |run: &Run| run.motions().get(run.motions().len() - 1).to.z;
    let typed = |text: &str| TextEdit { start: program.len(), end: program.len(), insert: text.into() };
    let out = |length: usize| TextEdit { start: program.len(), end: program.len() + length, insert: vec![] };

    let mut run = Run::new(program.into(), Setup::default());
    finish(&mut run);
    run.edit(typed("Z-8000\n"));
    finish(&mut run);
    check(&run, &Setup::default());
    assert_eq!((run.decided_rule(), last(&run)), (Some(DecimalRule::Calculator), -8000.0 * 25.4));
    let told = |run: &Run, slug: &str| run.diagnostics().iter().any(|found| found.message.slug() == slug);
    assert!(!told(&run, "least-increments-concluded"));
    // The user requests a new decision.
    assert!(run.reinfer_decimal_rule());
    finish(&mut run);
    assert_eq!((run.decided_rule(), last(&run)), (Some(DecimalRule::LeastIncrement), -0.8 * 25.4));
    assert!(told(&run, "least-increments-concluded"));
    assert!(!run.reinfer_decimal_rule());
    // The number that showed the rule is deleted; the rule stays.
    run.edit(out("Z-8000\n".len()));
    run.edit(typed("Z-9\n"));
    finish(&mut run);
    check(&run, &Setup::default());
    assert_eq!(last(&run), -0.0009 * 25.4);

    let fixed = Setup::from_json(r#"{"dialect": {"decimal": "calculator"}}"#).expect("setup");
    let mut run = Run::new(format!("{program}Z-8000\n").into_bytes(), fixed);
    assert_eq!((run.decided_rule(), run.reinfer_decimal_rule()), (None, false));
    finish(&mut run);
    assert_eq!(last(&run), -8000.0 * 25.4);
}

/// A keystroke in a long program runs at most two stretches of it, at any place and even if it causes an
/// error.
#[test]
fn a_change_costs_no_more_than_its_surroundings() {
    let setup = Setup { limits: Limits { stride: 512, ..Limits::default() }, ..Setup::default() };
    let mut run = Run::new(workload::plain(60_000).into_bytes(), setup.clone());
    finish(&mut run);
    for place in 1..20 {
        let line = place * 3_000;
        let at =
            run.text().iter().enumerate().filter(|(_, byte)| **byte == b'\n').nth(line).expect("a line").0;
        for typed in ["G1 X77. Z-300.5\n", "Y", "X"] {
            let edit = TextEdit { start: at + 1, end: at + 1, insert: typed.into() };
            run.edit(edit);
            assert!(run.advance(1_400), "{typed:?} in line {line}");
            if place % 6 == 0 {
                check(&run, &setup);
            }
            run.edit(TextEdit { start: at + 1, end: at + 1 + typed.len(), insert: Vec::new() });
            assert!(run.advance(1_400), "{typed:?} out of line {line}");
        }
    }
    check(&run, &setup);
}

/// The same while a message depends on later blocks (the spindle is stopped, and no block starts it), and for
/// text before the first block.
#[test]
fn a_change_costs_no_more_than_its_surroundings_while_a_message_waits() {
    let setup = Setup { limits: Limits { stride: 512, ..Limits::default() }, ..Setup::default() };
    let mut text = String::from("G0 X100. Z5.\nG1 X90. Z4. F200\n");
    for line in 0..20_000 {
        text += &format!("G1 X{}. Z-{}.\n", 50 + line % 30, 1 + line % 7);
    }
    text += "M30\n";
    let mut run = Run::new(text.into_bytes(), setup.clone());
    finish(&mut run);
    let last = run.text().len() - 1;
    for (at, typed) in [
        (0, "G4 P100\n"),
        (12, " "),
        (10_000, "(B)"),
        (10_001, "\nG1 X7. Z3."),
        (0, "(A)\n"),
        (last, "G4 P5\n"),
    ] {
        let line_end = run.text()[at..].iter().position(|&byte| byte == b'\n').map_or(at, |found| at + found);
        let at = if at == 0 { 0 } else { line_end };
        run.edit(TextEdit { start: at, end: at, insert: typed.into() });
        assert!(run.advance(1_600), "{typed:?} at byte {at}");
        check(&run, &setup);
    }
}

/// Once a stopped run has continued to the end, the stop no longer matters.
#[test]
fn a_change_costs_no_more_than_its_surroundings_after_a_stop_too() {
    let setup = Setup { limits: Limits { stride: 512, ..Limits::default() }, ..Setup::default() };
    let mut run = Run::new(workload::plain(20_000).into_bytes(), setup.clone());
    run.advance(10_000);
    run.stop(1.0);
    let mut type_in_line = |line: usize, blocks: usize| {
        let mut ends = run.text().iter().enumerate().filter(|(_, byte)| **byte == b'\n');
        let at = ends.nth(line).expect("a line").0 + 1;
        run.edit(TextEdit { start: at, end: at, insert: b"G1 X77. Z-300.5\n".to_vec() });
        run.advance(blocks)
    };
    assert!(type_in_line(5_000, 20_000));
    assert!(type_in_line(9_000, 1_400));
    check(&run, &setup);
}

/// Functions that repeat a run (expansion, offers of cycles) read numbers as the run does, even if the
/// evidence for its decision was deleted.
#[test]
fn a_run_repeated_reads_numbers_as_the_run_does() {
    let text = b"G20\nG00 X20000 Z1000\nG71 U800 R500\nG01 Z-5000 F100\nX25000\nM30\n";
    let mut run = Run::new(text.to_vec(), Setup::default());
    finish(&mut run);
    assert_eq!(run.decided_rule(), Some(DecimalRule::LeastIncrement));
    let tail = b"G00 X20\nM30\n";
    run.edit(TextEdit { start: 0, end: text.len(), insert: tail.to_vec() });
    finish(&mut run);
    let mut again = Run::new(tail.to_vec(), run.setup_to_repeat());
    finish(&mut again);
    assert_eq!(run.decided_rule(), Some(DecimalRule::LeastIncrement));
    assert_eq!(again.motions().get(0), run.motions().get(0));
    let mut other = Run::new(tail.to_vec(), Setup::default());
    finish(&mut other);
    assert_ne!(other.motions().get(0), run.motions().get(0));
}
