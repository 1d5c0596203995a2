//! What a file is read as, worked out by hand: control characters, programs of other controls, G-code systems, program names.
use gcode_playground::analyze;
use gcode_playground::message::Severity;
use gcode_playground::setup::Setup;

/// What is said of a program: code and line, the first being 1. Notes have a question mark, warnings an exclamation mark.
fn told(text: &str, setup: &str) -> Vec<String> {
    let analysis = analyze(text.as_bytes(), &Setup::from_json(setup).expect("a setup"));
    let told = analysis.diagnostics.into_iter().map(|told| {
        let line = text[..told.span.start as usize].matches('\n').count() + 1;
        let mark = match told.severity {
            Severity::Info => "?",
            Severity::Warning => "!",
            Severity::Error | Severity::Off => "",
        };
        format!("{}{mark} {line}", told.message.slug())
    });
    told.collect()
}

/// Where the moves of a program end: X as a diameter, Z.
fn ends(text: &str, setup: &str) -> Vec<(f64, f64)> {
    let analysis = analyze(text.as_bytes(), &Setup::from_json(setup).expect("a setup"));
    let round = |value: f64| (value * 1e4).round() / 1e4;
    analysis.motions.iter().map(|motion| (round(2.0 * motion.to.x), round(motion.to.z))).collect()
}

/// B-64304EN (ISO code): the tape has NUL, DC1 to DC4 and DEL, which are no significant characters. None is part of a word.
#[test]
fn control_characters_are_passed_over_outside_comments() {
    let plain =
        "%\nO0001\nG21 G99 G97 S500 M03 T0101\nG00 X60. Z2.\nG01 Z-14. F.2\nG00 X100. Z100.\nM30\n%\n";
    for byte in (1..=0x1Fu8).filter(|byte| !b"\n\r".contains(byte)).chain([0, 0x7F]) {
        let sign = char::from(byte);
        let marked: String = plain
            .lines()
            .map(|line| format!("{sign}{}{sign}\n", line.replace(' ', &format!("{sign} "))))
            .collect();
        assert_eq!(told(&marked, "{}"), told(plain, "{}"), "{byte:#x}");
        assert_eq!(ends(&marked, "{}"), [(60.0, 2.0), (60.0, -14.0), (100.0, 100.0)], "{byte:#x}");
    }
}

/// B-64484EN, program name: 32 characters in `< >`, called by `M98 <NAME>` and `G65 <NAME>`.
#[test]
fn programs_are_called_by_their_names() {
    let text = |head: &str, call: &str, sub: &str| {
        format!(
            "%\n{head}\nG21 G99 G97 S500 M03 T0101\nG00 X52. Z2.\n{call}\nG00 X100. Z100.\nM30\n{sub}\nG01 W-5. F.2\nM99\n%\n"
        )
    };
    let twice = [(52.0, 2.0), (52.0, -3.0), (52.0, -8.0), (100.0, 100.0)];
    for (head, call, sub) in [
        ("<SHAFT-1>", "M98 <SUB1> L2", "<SUB1>"),
        ("<SHAFT-1>", "M98 <SUB1> L2", "O<SUB1>"),
        ("O<SHAFT-1> (TURNED)", "M98<sub1>L2", "<SUB1> (CUT)"),
        ("O1234<SHAFT-1>", "G65 <SUB.2> L2", "<SUB.2>"),
        ("O1234", "M98 P20007", "O0007<SUB1>"),
        ("O1234", "M98 <FINISHING PASS> L2", "O0007 <FINISHING PASS>"),
        ("", "M98 <SUB1>\nM98 <SUB1>", "<SUB1>"),
    ] {
        let text = text(head, call, sub);
        assert_eq!(told(&text, "{}"), [""; 0], "{text}");
        assert_eq!(ends(&text, "{}"), twice, "{text}");
    }
    let missing = text("<MAIN>", "M98 <SUB2>", "<SUB1>");
    assert_eq!(told(&missing, "{}"), ["program-not-found! 5", "program-not-run? 8"]);
    let analysis = analyze(missing.as_bytes(), &Setup::default());
    let said =
        analysis.diagnostics.iter().map(|told| told.span.quote(missing.as_bytes())).collect::<Vec<_>>();
    assert_eq!(said, ["<SUB2>", "<SUB1>"]);
    assert!(told(&text("<SUB1>", "", "<SUB1>"), "{}").contains(&"duplicate-program-number! 8".to_owned()));
}

/// A name has its place at the head of a block and after the code of a call; elsewhere it is no word.
#[test]
fn a_name_without_a_place_is_reported() {
    for block in ["G00 X50. <NAME>", "M98 P1000 <", "N10 <NAME>", "M98 <NA*ME>", "IF[#1<2]GOTO5"] {
        let text = format!("O1\nG21 G99 G97 S500 M03 T0101\n{block}\nG00 X100. Z100.\nM30\n");
        assert!(
            told(&text, "{}").iter().any(|told| told.ends_with(" 3") && !told.contains(['!', '?'])),
            "{block}"
        );
    }
}
