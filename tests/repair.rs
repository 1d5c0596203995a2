//! A safe fix never hides a fault: either it restores the original program, or an error remains at the faulty
//! block and the motions after it are uncertain.
//!
//! `cargo test --test it repair:: -- --nocapture` prints how many faults were fixed, and how many still have
//! an error.
#[path = "repair/invariants.rs"]
mod invariants;
#[path = "repair/misread.rs"]
mod misread;

use crate::classes;
use crate::fixtures;
use crate::text;
use std::collections::{BTreeMap, HashSet};

use classes::{CLASSES, Place};
use gcode_playground::analyze;
use gcode_playground::motion::{Motion, Process};
use gcode_playground::run::Analysis;
use gcode_playground::setup::Setup;
use gcode_playground::text::block::{Block, Value};
use gcode_playground::text::parser::Parser;
use misread::Random;

fn fixed(text: &str) -> String {
    let fixed = invariants::repair(text.as_bytes(), &Setup::default());
    String::from_utf8(fixed.text).expect("UTF-8")
}

fn errors(analysis: &Analysis) -> Vec<String> {
    analysis.diagnostics.iter().filter(|told| told.is_error()).map(|told| told.code()).collect()
}

const HEAD: &str = "O0001\nT0101\nG97 G99 S800 M03\nG00 X66 Z2\n";

/// Checks the result of the safe fixes of a block, and whether an error remains.
#[track_caller]
fn check(block: &str, expected: &str, remains: bool) {
    let text = format!("{HEAD}{block}\nG01 Z-5 F0.2\nG00 X100\nM30\n");
    let after = fixed(&text);
    assert_eq!(after, format!("{HEAD}{expected}\nG01 Z-5 F0.2\nG00 X100\nM30\n"));
    let analysis = analyze(after.as_bytes(), &Setup::default());
    assert_eq!(!errors(&analysis).is_empty(), remains, "{block}: {:?}", analysis.diagnostics);
}

#[test]
fn only_plain_words_come_into_brackets() {
    for (block, expected) in [
        ("G00 X64 retract", "G00 X64 (retract)"),
        ("G28 U0 home", "G28 U0 (home)"),
        ("M03 S500 rpm", "M03 S500 (rpm)"),
        ("N20 X18 finish pass", "N20 X18 (finish pass)"),
        ("rough Z2 then finish X60 slowly", "rough Z2 then finish X60 slowly"),
        ("rough Z2 finish X60 slowly", "(rough) Z2 (finish) X60 (slowly)"),
        ("N50 (safe) X60 shift home", "N50 (safe) X60 (shift home)"),
        ("G00 XO", "G00 X0"),
        ("GO0 X6O retract", "G00 X60 (retract)"),
        ("N10 turning the outside", "N10 (turning the outside)"),
        ("turning the outside", "(turning the outside)"),
        ("G00 X64 退刀", "G00 X64 (退刀)"),
        ("G00 X64 отвод", "G00 X64 (отвод)"),
        ("G00 X60; turn to the shoulder", "G00 X60; (turn to the shoulder)"),
    ] {
        check(block, expected, block == expected);
    }
}

#[test]
fn what_cannot_be_read_stays_an_error() {
    for block in [
        "N50 X=64",
        "T0303 groove 3mm",
        "Gº0 X60",
        "N080 X14 ２1",
        "N50 X60 “safe”",
        "G00 X64 retract.",
        "G00 X=64 retract",
        "G00 XSO",
        "XZ",
        "TOIOI",
        "G00 X64 tool",
        "GO home",
        "G00 X64 retract 5",
        "G00 X64 AND",
        "G00 X64 done",
        "G00 ＺＯ",
        "N080 X14 ２０",
        "G00 X60; X5 retract=",
        "G00 X60; XSO",
        "X Z",
        "X=",
        "X50 go",
        "G00 X60 (face Z2",
        "G:00 X60",
        "G00 X l0O",
    ] {
        check(block, block, true);
    }
}

/// For each motion after the block, whether it is uncertain.
fn uncertain(block: &str) -> Vec<bool> {
    let text = format!("{HEAD}{block}\nG01 Z-5 F0.2\nG00 X100 Z9\nX90\nM30\n");
    let motions = analyze(text.as_bytes(), &Setup::default()).motions;
    motions.iter().skip(1).map(|motion| motion.process.uncertain).collect()
}

#[test]
fn what_follows_is_uncertain() {
    for block in [
        "G00 X64 retract",
        "N50 X=64",
        "T0303 groove 3mm",
        "Gº0 X60",
        "N080 X14 ２1",
        "G28 U0 home",
        "G00 XSO",
        "GO home",
    ] {
        assert_eq!(uncertain(block), [true, true, false], "{block}");
    }
    // Text makes no motion.
    assert_eq!(uncertain("turning the outside"), [false; 3]);
    assert_eq!(uncertain("N10 turning the outside"), [false; 3]);
}

#[test]
fn a_contour_keeps_its_numbers() {
    let text = "O1\nT0101\nG97 G99 S800 M03\nG00 X52 Z2\nG71 U2 R1\nG71 P10 Q20 U0.4 W0.1 F0.2\nN10 G00 X16 start\nG01 Z-9\n\
                N20 X52 end of contour\nG70 P10 Q20\nM30\n";
    let after = fixed(&text.replace("end of contour", "last block"));
    assert!(after.contains("N10 G00 X16 (start)\n") && after.contains("N20 X52 (last block)\n"), "{after}");
    assert!(errors(&analyze(after.as_bytes(), &Setup::default())).is_empty());
}

#[test]
fn one_m30_comes_before_the_sign_that_ends_the_tape() {
    let program = "O1\nT0101\nG97 S800 M03\nG00 X50 Z2";
    for end in [
        "%EOF",
        "%\u{1a}",
        "%;",
        "% (END)",
        "%\0",
        "%%",
        "%",
        "%\n%",
        "%\nO2\nG00 X9\nM30\n%",
        "%\nG00 X9\n%",
        " %x",
        "\u{c}%",
    ] {
        assert_eq!(fixed(&format!("{program}\n{end}")), format!("{program}\nM30\n{end}"), "{end:?}");
    }
    for (end, expected) in [
        ("%", "\nM30\n%"),
        ("%;", "\nM30\n%;"),
        ("% ;;\u{1a}", "\nM30\n% ;;\u{1a}"),
        ("%\u{b};\n", "\nM30\n%\u{b};\n"),
        (" (END)%;", " (END)\nM30\n%;"),
        (";\n", ";\nM30\n"),
        (";%", ";M30\n%"),
        (";\n", ";\nM30\n"),
        ("\n\n\n", "\nM30\n\n\n"),
        ("\u{1a}", "\nM30\u{1a}"),
        ("\n\u{1a}\0\0", "\nM30\n\u{1a}\0\0"),
        (" (END)\n", " (END)\nM30\n"),
        (" (OPEN %", " (OPEN %)\nM30"),
        ("\nO2\nG00 X9\nM99\n%", "\nM30\nO2\nG00 X9\nM99\n%"),
        ("\n/O2\nG00 X9\nM99\n%", "\nM30\n/O2\nG00 X9\nM99\n%"),
        ("\nM30\u{c}\n%", "\nM30\u{c}\n%"),
        ("\n\u{c}M30\n", "\n\u{c}M30\n"),
    ] {
        assert_eq!(fixed(&format!("{program}{end}")), format!("{program}{expected}"), "{end:?}");
    }
    // Here M30 would be data.
    let data = format!("{program}\nG10 L50\nN1 R5\n");
    assert_eq!(fixed(&data), data);
}

#[test]
fn a_printed_minus_is_the_same_error_before_and_after() {
    for minus in ["\u{2212}", "\u{2013}", "\u{ff0d}"] {
        for block in [
            "G01 X40 F-0.2",
            "G-4",
            "S-5",
            "T-1",
            "M-3",
            "P-5",
            "N-5 X40",
            "G71 U-2 R1",
            "G04 P-5",
            "G01 X-5 Z-4 F.1",
            "G01 X-5O=",
        ] {
            let text = format!("{HEAD}{block}\nM30\n");
            let printed = text.replace("-", minus);
            let of = |text: &str| errors(&analyze(text.as_bytes(), &Setup::default()));
            assert_eq!(of(&printed), of(&text), "{printed}");
            assert_eq!(fixed(&printed), fixed(&text));
        }
    }
}

#[test]
fn a_word_that_is_too_long_is_the_same_error_before_and_after() {
    for (block, plain) in [
        ("G0 X１２３４５６７８９", "G0 X123456789"),
        ("Ｎ１２３４５６７８９ G0 X1", "N123456789 G0 X1"),
        ("T０１０１０１０１０１", "T0101010101"),
        ("G0 X１.２.３", "G0 X1.2.3"),
    ] {
        let text = format!("{HEAD}{plain}\nM30\n");
        let wide = text.replace(plain, block);
        let of = |text: &str| errors(&analyze(text.as_bytes(), &Setup::default()));
        assert_eq!(of(&wide), of(&text), "{wide}");
        assert_eq!(fixed(&wide), text);
    }
    // A program number has at most eight digits: with more, the first zero is not a misread letter.
    assert_eq!(fixed("012345678\nM30\n"), "O12345678\nM30\n");
    for text in ["0123456789\nM30\n", "002126021260\nM30\n"] {
        assert_eq!(fixed(text), text);
        assert_eq!(errors(&analyze(text.as_bytes(), &Setup::default())), ["PS0004"]);
    }
}

#[test]
fn commas_that_cannot_all_be_points_stay() {
    for block in
        ["G01 Z0,,208", "G01 Z0 ,,208", "G01 Z0 ,.208", "G01 Z0.5,208", "G01 Z,5,2", "G01 X,,5", "G01 Z1,2,3"]
    {
        check(block, block, true);
    }
    check("G01 Z-0,208 F,1", "G01 Z-0.208 F.1", false);
    check("G01 X20,5,C1 F0.2", "G01 X20.5,C1 F0.2", false);
    check("G01 X10,5, Z2", "G01 X10.5, Z2", true);
    check("G01 Z20，5", "G01 Z20.5", false);
    // The words before it are kept.
    let words = |block: &str| {
        let (mut read, text) = (Block::default(), format!("{block}\n"));
        assert!(Parser::new(text.as_bytes()).next_block(&mut read));
        (read.words.iter().map(|word| char::from(word.address)).collect::<String>(), read.faults.len())
    };
    assert_eq!(words("G01 F0.2 Z1,2,3"), ("GF".to_owned(), 1));
    assert_eq!(words("G01 Z1，2，3"), ("G".to_owned(), 1));
}

#[test]
fn a_letter_before_a_number_stays() {
    for block in ["G01 XO 8", "G01 ZO\t8", "G01 Xl0O -5", "G01 XO ８"] {
        check(block, block, true);
    }
    check("G01 XO Z-8", "G01 X0 Z-8", false);
    check("YN![gCO2", "YN![gCO2", true);
    // The number on the next line is not part of this word.
    let text = "10 G00 XO\n20 G01 Z-5 F0.2\n";
    assert!(fixed(text).starts_with("10 G00 X0\n"), "{}", fixed(text));
}

#[test]
fn words_in_an_expression_stay() {
    for block in
        ["G01 X[#1 retract", "G01 X[#1 retract ] Z-5", "G01 X[10 +done + 5] Z-2", "X[CC CCCCCC CCCCCC(end)"]
    {
        check(block, block, true);
    }
    // After the expression they are plain words.
    check("G01 X[10+5] retract F0.2", "G01 X[10+5] (retract) F0.2", false);
}

#[test]
fn many_faults_of_one_kind_are_all_cured() {
    let block = "G01 X\u{2212}1 （a） Z\u{2212}2 （b） U\u{2212}3 （c） W\u{2212}4 （d） R\u{2212}5 （e） I\u{2212}6 F1O\n";
    let text = format!("{HEAD}{}M30\n", block.repeat(700));
    let after = fixed(&text);
    assert!(after.is_ascii() && !after.contains("1O"));
}

/// A correct program.
struct Correct {
    id: String,
    text: String,
    setup: Setup,
    analysis: Analysis,
}

fn programs() -> Vec<Correct> {
    let programs = fixtures::all().into_iter().map(|program| {
        let setup = Setup::from_json(&program.setup).expect("a setup");
        // Some are fragments without M30.
        let fixed = invariants::repair(program.text.as_bytes(), &setup);
        let text = String::from_utf8(fixed.text).expect("UTF-8");
        let analysis = analyze(text.as_bytes(), &setup);
        Correct { id: program.id, text, setup, analysis }
    });
    programs.filter(|program| errors(&program.analysis).is_empty()).collect()
}

/// A motion without the uncertain and incomplete marks.
fn seen(motion: &Motion) -> Motion {
    Motion { process: Process { uncertain: false, incomplete: false, ..motion.process }, ..*motion }
}

/// The T, S, M and F words with their values, in order.
fn technology(text: &str) -> Vec<String> {
    let (mut parser, mut block, mut found) = (Parser::new(text.as_bytes()), Block::default(), Vec::new());
    while parser.next_block(&mut block) {
        for word in block.words.iter().filter(|word| matches!(word.address, b'T' | b'S' | b'M' | b'F')) {
            let value = match word.value {
                Value::Number { number, negative } => format!("{negative}{}", number.value()),
                Value::Expression => word.span.quote(text.as_bytes()),
            };
            found.push(format!("{}{value}", word.address as char));
        }
    }
    found
}

/// The geometry of a motion, as comparable text.
fn way(motion: &Motion) -> String {
    format!("{:?} {:?} {:?} {:?}", motion.kind, motion.from, motion.to, motion.center)
}

/// The result of a fault.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Outcome {
    /// The original program was restored.
    Restored,
    /// An error remains at the faulty block.
    LeftWithError,
    /// No safe fix changes the line, and no error is reported: it is a different valid program.
    AnotherProgram,
}

/// Judges a text with a fault on one line.
fn judge(correct: &Correct, faulty: &str, line: usize) -> Result<Outcome, String> {
    let fixed = invariants::repair(faulty.as_bytes(), &correct.setup);
    let text = String::from_utf8_lossy(&fixed.text).into_owned();
    let after = analyze(&fixed.text, &correct.setup);
    let (before, motions) = (&correct.analysis.motions, &after.motions);
    let same =
        before.len() == motions.len() && before.iter().zip(motions.iter()).all(|(a, b)| seen(&a) == seen(&b));
    if same && technology(&correct.text) == technology(&text) {
        return Ok(Outcome::Restored);
    }
    let line_of = |byte: u32| text.as_bytes()[..byte as usize].iter().filter(|sign| **sign == b'\n').count();
    let remains = after.diagnostics.iter().any(|told| told.is_error() && line_of(told.span.start) == line);
    let shown = |what: &str| {
        let (old, new) = (faulty.lines().nth(line), text.lines().nth(line));
        let was = correct.text.lines().nth(line);
        Err(format!("{what} | {} | line {} | {was:?} | {old:?} | {new:?}", correct.id, line + 1))
    };
    if !remains {
        // A fix must not change the faulty line.
        let is_left = text.lines().nth(line) == faulty.lines().nth(line);
        return if is_left { Ok(Outcome::AnotherProgram) } else { shown("hidden") };
    }
    // An unreadable block makes no motion: the next motion is uncertain, or equals one of the original.
    let ways: HashSet<String> = before.iter().map(|motion| way(&motion)).collect();
    let next =
        (0..motions.len()).find(|index| motions.line(*index) as usize > line).map(|index| motions.get(index));
    match next {
        Some(next)
            if is_unreadable(&text, line) && !next.process.uncertain && !ways.contains(&way(&next)) =>
        {
            shown(&format!("certain {}", way(&next)))
        }
        _ => Ok(Outcome::LeftWithError),
    }
}

/// Whether a line has a syntax error.
fn is_unreadable(text: &str, line: usize) -> bool {
    let (mut parser, mut block) = (Parser::new(text.as_bytes()), Block::default());
    while parser.next_block(&mut block) {
        if block.line as usize == line && block.is_broken() {
            return true;
        }
    }
    false
}

/// Judges many faults, prints the number of each outcome, and fails if a fix hides a fault.
fn judge_all(faults: impl Iterator<Item = (&'static str, usize, String, usize)>, programs: &[Correct]) {
    let mut counts: BTreeMap<&str, [usize; 3]> = BTreeMap::new();
    let mut wrong = Vec::new();
    for (class, program, text, line) in faults {
        match judge(&programs[program], &text, line) {
            Ok(outcome) => counts.entry(class).or_default()[outcome as usize] += 1,
            Err(what) => wrong.push(format!("{class} | {what}")),
        }
    }
    println!("{:36} {:>8} {:>10} {:>15}", "fault", "restored", "with error", "another program");
    let mut whole = [0; 3];
    for (class, [restored, left, another]) in counts {
        println!("{class:36} {restored:>8} {left:>10} {another:>15}");
        whole = [whole[0] + restored, whole[1] + left, whole[2] + another];
    }
    println!("{:36} {:>8} {:>10} {:>15}", "all", whole[0], whole[1], whole[2]);
    assert!(wrong.is_empty(), "{} faults are hidden:\n{}", wrong.len(), wrong.join("\n"));
}

#[test]
fn a_fix_hides_no_fault_of_reading() {
    const FAULTS: usize = 2000;
    let programs = programs();
    assert!(programs.len() >= 30, "{} programs", programs.len());
    let mut random = Random(35);
    let faults = std::iter::repeat_with(|| {
        let program = random.below(programs.len());
        let fault = misread::fault(&programs[program].text, &mut random)?;
        Some((fault.class, program, fault.text, fault.line))
    });
    judge_all(faults.flatten().take(FAULTS), &programs);
}

#[test]
fn a_fix_hides_no_fault_of_people() {
    // Faults of each class in each program, spread over the program.
    const EACH: usize = 2;
    let programs = programs();
    let mut faults = Vec::new();
    for (number, program) in programs.iter().enumerate() {
        let words = text::Words::of(&program.text);
        for class in CLASSES {
            let mutants = (class.make)(&words);
            let step = mutants.len().div_ceil(EACH).max(1);
            faults.extend(mutants.into_iter().step_by(step).map(|mutant| {
                let (Place::At(at, _) | Place::Needed(at, _)) = mutant.place;
                let line = mutant.text[..at.min(mutant.text.len())].matches('\n').count();
                (class.name, number, mutant.text, line)
            }));
        }
    }
    judge_all(faults.into_iter(), &programs);
}

#[test]
fn any_text_can_be_repaired() {
    let mut random = Random(1);
    let programs = programs();
    for program in &programs {
        invariants::repair(program.text.as_bytes(), &program.setup);
    }
    const PIECES: [&str; 40] = [
        "G00 ",
        "G1",
        "X5",
        "Z−2 ",
        "\n",
        "\n",
        "\n",
        ";",
        "%",
        "(",
        ")",
        "（",
        "）",
        "retract ",
        "tool",
        "GO",
        "XSO ",
        "O0002",
        "N10 ",
        "M30",
        "M99",
        "#1=2",
        "IF[#1 EQ 2]GOTO 10",
        "END",
        "shift",
        ",",
        ",5",
        ".",
        "=",
        "º",
        "２",
        "\u{c}",
        "\0",
        "\u{1a}",
        "/",
        "退刀 ",
        " ",
        "U--3",
        "5 0",
        "G10 L50",
    ];
    for _ in 0..1500 {
        let pieces = 1 + random.below(30);
        let text: String = (0..pieces).map(|_| PIECES[random.below(PIECES.len())]).collect();
        invariants::repair(text.as_bytes(), &Setup::default());
    }
}
