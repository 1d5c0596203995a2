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
