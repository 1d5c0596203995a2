//! `(IGNORE RULE=…)`: messages of one line are hidden, in the run and in the findings about the machine.
use gcode_playground::analyze;
use gcode_playground::message::{Diagnostic, Fix};
use gcode_playground::run::{Run, TextEdit};
use gcode_playground::setup::Setup;

use crate::folder::{Folder, err, out, rows};

/// Line and slug of each message, as `check` reports them.
fn told(text: &str) -> Vec<(usize, &'static str)> {
    told_with(text, &Setup::default())
}

fn told_with(text: &str, setup: &Setup) -> Vec<(usize, &'static str)> {
    let mut analysis = analyze(text.as_bytes(), setup);
    analysis.check_at_machine();
    let line = |told: &Diagnostic| 1 + text[..told.span.start as usize].matches('\n').count();
    analysis.diagnostics.iter().map(|told| (line(told), told.message.slug())).collect()
}

/// A program with two unknown M codes and a rapid into the blank.
const PROGRAM: &str = "O0001 (STOCK D=50 LENGTH=80)\nT0101\nG97 S500 M03\nM203\nM203\nG00 X46 Z2\nG00 Z-30\nG00 X100 Z100\nM30\n";

const ALL: [(usize, &str); 4] =
    [(4, "unknown-m-code"), (5, "unknown-m-code"), (7, "rapid-through-stock"), (8, "rapid-through-stock")];

/// The program with a comment at the end of a line, from 1.
fn with_comment(line: usize, comment: &str) -> String {
    let lines = PROGRAM.lines().zip(1..);
    lines
        .map(|(text, at)| if at == line { format!("{text} {comment}\n") } else { format!("{text}\n") })
        .collect()
}

#[test]
fn a_comment_hides_a_rule_in_its_line() {
    assert_eq!(told(PROGRAM), ALL);
    assert_eq!(told(&with_comment(4, "(IGNORE RULE=UNKNOWN-M-CODE)")), ALL[1..]);
    assert_eq!(told(&with_comment(7, "(ignore rule=rapid-through-stock)")), [ALL[0], ALL[1], ALL[3]]);
    let two = "(IGNORE RULE=RAPID-THROUGH-STOCK RULE=UNKNOWN-M-CODE)";
    let both = told(&with_comment(4, two));
    assert_eq!(both, [(4, "ignore-unused"), ALL[1], ALL[2], ALL[3]]);
}

#[test]
fn what_it_hides_makes_no_difference_to_the_motions() {
    let motions = |text: &str| analyze(text.as_bytes(), &Setup::default()).motions.len();
    // Three rapids.
    let hidden = with_comment(7, "(IGNORE RULE=RAPID-THROUGH-STOCK)");
    assert_eq!((motions(PROGRAM), motions(&hidden)), (3, 3));
    // A block with an error makes no motion, whether the error is shown or hidden.
    let faulty = "O1\nM3 S500\nG1 Z F0.2 X50\nM30\n";
    let ignored = faulty.replace("X50\n", "X50 (IGNORE RULE=NUMBER-MISSING)\n");
    assert_eq!((told(faulty), told(&ignored)), (vec![(3, "number-missing")], vec![]));
    assert_eq!((motions(faulty), motions(&ignored)), (0, 0));
}

#[test]
fn a_comment_that_hides_nothing_is_reported_as_information() {
    let setup = |json: &str| Setup::from_json(json).expect("a setup");
    let text = with_comment(6, "(IGNORE RULE=UNKNOWN-M-CODE)");
    let unused = [ALL[0], ALL[1], (6, "ignore-unused"), ALL[2], ALL[3]];
    assert_eq!(told(&text), unused);
    // It may hide a message of a rule that is switched off, of lints that are, and of other programs.
    let off = told_with(&text, &setup(r#"{"rules": {"unknown-m-code": "off"}}"#));
    assert_eq!(off, ALL[2..]);
    let lints = told_with(&text, &setup(r#"{"lints": "off"}"#));
    assert!(!lints.contains(&(6, "ignore-unused")), "{lints:?}");
    assert_eq!(told_with(&text, &setup(r#"{"rules": {"ignore-unused": "off"}}"#)), ALL);
    // A group is unused if none of its rules is switched on.
    let group = with_comment(6, "(IGNORE RULE=CLASSROOM)");
    assert_eq!(told(&group), ALL);
}

#[test]
fn a_slip_in_such_a_comment_is_told_once() {
    let text = with_comment(4, "(IGNORE RULE=UNKNOWN-M-CODES)");
    assert_eq!(told(&text), [ALL[0], (4, "setup-comment"), ALL[1], ALL[2], ALL[3]]);
    let mut analysis = analyze(text.as_bytes(), &Setup::default());
    analysis.check_at_machine();
    let slip = analysis.diagnostics.iter().find(|told| told.message.slug() == "setup-comment").expect("it");
    let [Fix { edits, .. }] = &slip.fixes[..] else { panic!("{slip:?}") };
    assert_eq!(edits[0].text, "RULE=UNKNOWN-M-CODE");
}

/// The words of a rule are no description of a tool.
#[test]
fn a_rule_in_a_comment_describes_no_tool() {
    let program = |comment: &str| {
        format!(
            "O1\nG99 G97 S500 M03\nT0101 {comment}\nG00 X52 Z2\nG01 X40 F0.2\nZ-30\nX52\nG00 X100 Z100\nM30\n"
        )
    };
    let described = |comment: &str| {
        let analysis = analyze(program(comment).as_bytes(), &Setup::default());
        analysis.setup.described_tools
    };
    assert_eq!(described("(THREAD-ANGLE)").len(), 1);
    for slug in ["THREAD-ANGLE", "DRILL-DIAMETER-ASSUMED", "GROOVE-STEP-TOO-WIDE"] {
        assert!(described(&format!("(IGNORE RULE={slug})")).is_empty(), "{slug}");
    }
}

/// An edited run has the messages of a fresh one.
#[test]
fn comments_are_heeded_after_an_edit() {
    let finished = |run: &mut Run| while !run.advance(usize::MAX) {};
    let slugs = |run: &Run| -> Vec<(u32, &str)> {
        run.diagnostics().iter().map(|told| (told.span.start, told.message.slug())).collect()
    };
    let mut run = Run::new(PROGRAM.as_bytes().to_vec(), Setup::default());
    finished(&mut run);
    let at = PROGRAM.find("M203").expect("M203") + 4;
    let comment = " (IGNORE RULE=UNKNOWN-M-CODE)";
    for (end, insert) in
        [(at, comment), (at + comment.len(), ""), (at, " (IGNORE RULE=UNKNOWN-M"), (at, "-CODE)")]
    {
        run.edit(TextEdit { start: at, end, insert: insert.as_bytes().to_vec() });
        finished(&mut run);
        let fresh = Run::finished(run.text().to_vec(), Setup::default());
        assert_eq!(slugs(&run), slugs(&fresh), "{}", String::from_utf8_lossy(run.text()));
    }
}

#[test]
fn the_command_line_heeds_comments_in_each_format_and_fixes_nothing_there() {
    let program =
        "O1\nM3 S500\nGO0 X50 Z2 (IGNORE RULE=LETTER-FOR-DIGIT)\nG0 X (IGNORE RULE=NUMBER-MISSING)\nM30\n";
    let folder = Folder::new("ignored").with("a.nc", program);
    let output = folder.check(&["a.nc"]);
    assert_eq!((out(&output).as_str(), output.status.code()), ("nothing found in 1 file\n", Some(0)));
    assert_eq!(rows(&folder.check(&["a.nc", "--format", "json"])), Vec::<serde_json::Value>::new());
    // A severity of the command line does not show it.
    let graded = folder.check(&["a.nc", "--severity", "number-missing=warning", "--max-warnings", "0"]);
    assert_eq!(graded.status.code(), Some(0), "{}", out(&graded));
    assert_eq!(out(&folder.check(&["a.nc", "--diff"])), "");
    assert_eq!(err(&folder.check(&["a.nc", "--diff"])), "");
}

/// A danger in a subprogram of another file is reported at its call, and hidden there.
#[test]
fn a_comment_at_a_call_hides_what_is_reported_there() {
    let main = |comment: &str| {
        format!(
            "O0001 (STOCK D=50 LENGTH=80)\nG21 G99 G97 S500 M03 T0101\nG00 X60. Z2.\nM98 P2001{comment}\nG00 X100. Z100.\nM30\n"
        )
    };
    let folder = Folder::new("ignored-call")
        .with("plain.nc", main(""))
        .with("hidden.nc", main(" (IGNORE RULE=RAPID-THROUGH-STOCK)"))
        .with("O2001.nc", "O2001\nG00 X40.\nG00 Z-20.\nG00 X60.\nM99\n");
    let slugs = |file: &str| -> Vec<String> {
        let rows = rows(&folder.check(&[file, "--format", "json"]));
        rows.iter().filter_map(|row| row["slug"].as_str().map(str::to_owned)).collect()
    };
    assert_eq!(slugs("plain.nc"), ["rapid-through-stock"]);
    assert_eq!(slugs("hidden.nc"), [""; 0]);
}
