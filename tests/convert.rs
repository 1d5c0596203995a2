//! `convert`: coordinates and arcs in another form; the words that stay, and that no program runs differently.

use crate::cli::{file, run};
use crate::fixtures;
use crate::random_programs;

use gcode_playground::analyze;
use gcode_playground::convert::{Conversion, Form, converted};
use gcode_playground::message::applied;
use gcode_playground::setup::Setup;
use proptest::prelude::*;
use random_programs::{any_setup, program, small};

const FORMS: [Form; 4] = [Form::Absolute, Form::Incremental, Form::Radius, Form::Center];

fn conversion(text: &str, form: Form) -> Conversion {
    converted(text.as_bytes(), text.len(), &Setup::default(), form)
}

/// The program in a form, and the words that stay.
fn written(text: &str, form: Form) -> (String, Vec<String>) {
    let found = conversion(text, form);
    let after = String::from_utf8(applied(text.as_bytes(), &found.edits)).expect("UTF-8");
    (after, found.left.iter().map(|word| word.quote(text.as_bytes())).collect())
}

#[track_caller]
fn check(form: Form, before: &str, after: &str, left: &[&str]) {
    assert_eq!(
        written(before, form),
        (after.to_owned(), left.iter().map(|word| (*word).to_owned()).collect())
    );
    assert_eq!(written(after, form).0, after, "the second time");
}

const ABSOLUTE: &str =
    "O1\nT0101\nM03 S500\nG00 X32 Z2\nG00 X28\nG01 Z-20 F0.2\nX32. Z-21.5\nG00 X100 Z98.5\nM30\n";
/// The first position is absolute, and so are the first ones after the tool.
const INCREMENTAL: &str =
    "O1\nT0101\nM03 S500\nG00 X32 Z2\nG00 U-4\nG01 W-22 F0.2\nU4. W-1.5\nG00 U68 W120.\nM30\n";

#[test]
fn distances_become_positions_and_positions_distances() {
    check(Form::Absolute, INCREMENTAL, ABSOLUTE, &[]);
    check(Form::Incremental, ABSOLUTE, INCREMENTAL, &["X32", "Z2"]);
    // X30 Z-5, then 4 mm on the diameter; the word keeps its point.
    check(
        Form::Absolute,
        "G00 X30. Z-5.\nG01 U4. W-1.25 F.1\nM30\n",
        "G00 X30. Z-5.\nG01 X34. Z-6.25 F.1\nM30\n",
        &[],
    );
}

#[test]
fn a_distance_from_an_unknown_place_stays() {
    // The start is assumed; after G28 and a new tool the place is that of the machine.
    check(Form::Absolute, "G00 U-4\nX30\nU-2\nM30\n", "G00 U-4\nX30\nX28\nM30\n", &["U-4"]);
    check(
        Form::Absolute,
        "G00 X30 Z2\nG28 U0 W0\nG00 U-10\nX20 W-5\nM30\n",
        "G00 X30 Z2\nG28 U0 W0\nG00 U-10\nX20 W-5\nM30\n",
        &["U-10", "W-5"],
    );
    check(
        Form::Incremental,
        "T0101\nG00 X30 Z2\nX20\nT0202\nX30 Z2\nZ-5\nM30\n",
        "T0101\nG00 X30 Z2\nU-10\nT0202\nX30 Z2\nW-7\nM30\n",
        &["X30", "Z2", "X30", "Z2"],
    );
}

#[test]
fn a_block_at_several_places_stays() {
    let text = "O1\nG00 X30 Z2\nM98 P2 L3\nM30\nO2\nG01 U-2 F.2\nU1 W-1\nM99\n";
    check(Form::Absolute, text, text, &["U-2", "U1", "W-1"]);
    // The way is the same each time.
    let text =
        "O1\nG00 X30 Z0\nG01 Z-5 F.2\n#1=0\nWHILE[#1LT2]DO1\nG00 X32\nZ0\nX30\nG01 Z-5\n#1=#1+1\nEND1\nM30\n";
    let (after, _) = written(text, Form::Incremental);
    assert!(after.contains("G00 U2\nW5\nU-2\nG01 W-5\n"), "{after}");
}

#[test]
fn the_contour_of_a_finishing_cycle_is_written_too() {
    let contour = |first: &str, rest: &str| {
        format!(
            "G00 X42 Z2 M03 S500\nG71 U2 R1\nG71 P1 Q2 U.4 W.1 F.2\nN1 G00 {first}\nG01 {rest}\nN2 X42\nG70 P1 Q2\nM30\n"
        )
    };
    // X20, then to Z-10, then 10 mm on the diameter over 5 mm.
    check(Form::Absolute, &contour("X20", "W-12\nU10 W-5"), &contour("X20", "Z-10\nX30 Z-15"), &[]);
}

#[test]
fn cycles_and_other_words_stay() {
    for text in [
        "G00 X30 Z2\nG90 U-4 W-20 F.2\nM30\n",
        "G00 X30 Z2\nG04 U1\nM30\n",
        "G00 X30 Z2\n#1=4\nG01 U#1 F.2\nM30\n",
        "G00 X30 Z2\nG01 W-10,C1 F.2\nX40\nM30\n",
    ] {
        assert_eq!(written(text, Form::Absolute).0, text);
    }
    // G90 of system B is not a cycle.
    let setup = Setup::from_json(r#"{"dialect": {"gSystem": "B"}}"#).expect("a setup");
    let text = "G90 G00 X30 Z2\nG91 G01 X-4 F.2\nM30\n";
    assert_eq!(converted(text.as_bytes(), text.len(), &setup, Form::Incremental).edits, []);
}

#[test]
fn an_arc_has_a_radius_or_a_centre() {
    // From X20 Z-5 to X30 Z-10, a quarter with its centre at X30 Z-5: I5 K0.
    let arc = |words: &str| format!("G00 X20 Z-5\nG02 X30 Z-10 {words} F.1\nM30\n");
    check(Form::Center, &arc("R5"), &arc("I5 K0"), &[]);
    check(Form::Radius, &arc("I5 K0"), &arc("R5"), &[]);
    check(Form::Radius, &arc("I5. K0."), &arc("R5."), &[]);
    // Incremental, in inches.
    check(
        Form::Center,
        "G20\nG00 X2. Z0\nG03 U.5 W-.25 R.25 F.01\nM30\n",
        "G20\nG00 X2. Z0\nG03 U.5 W-.25 I0. K-0.25 F.01\nM30\n",
        &[],
    );
    // Three quarters around X20 Z-10, and a full circle: R is for arcs of less than half a turn.
    check(Form::Radius, &arc("I0 K-5"), &arc("I0 K-5"), &["I0", "K-5"]);
    let circle = "G00 X20 Z-5\nG02 I5 K0 F.1\nM30\n";
    check(Form::Radius, circle, circle, &["I5", "K0"]);
}

/// Converts to each form: the motions stay the same to 0.001 mm, and the second time nothing changes.
fn check_runs_the_same(text: &str, setup: &Setup) -> Result<usize, String> {
    let mut count = 0;
    for form in FORMS {
        let found = converted(text.as_bytes(), text.len(), setup, form);
        let after = String::from_utf8(applied(text.as_bytes(), &found.edits)).expect("UTF-8");
        count += found.edits.len();
        let shown = |what: &str| Err(format!("{what}: {form:?}\n{text}\n--- became:\n{after}"));
        for block_skip in [Vec::new(), (1..=9).collect()] {
            let setup = Setup { block_skip, ..setup.clone() };
            let ends = |text: &str| -> Vec<_> {
                let run = analyze(text.as_bytes(), &setup);
                let motion = |motion: gcode_playground::motion::Motion| (motion.kind, motion.to);
                run.motions.iter().map(motion).collect()
            };
            let (one, other) = (ends(text), ends(&after));
            let near =
                |((kind, to), (other, at)): (&(_, _), &(_, _))| kind == other && distance(*to, *at) <= 0.0011;
            if one.len() != other.len() || !one.iter().zip(&other).all(near) {
                return shown("other motions");
            }
        }
        if !converted(after.as_bytes(), after.len(), setup, form).edits.is_empty() {
            return shown("not the same the second time");
        }
    }
    Ok(count)
}

fn distance(one: gcode_playground::geometry::Point, other: gcode_playground::geometry::Point) -> f64 {
    one.distance(other)
}

#[test]
fn the_programs_of_the_gallery_run_the_same() {
    let mut edits = 0;
    for program in fixtures::all() {
        let setup = Setup::from_json(&program.setup).expect("a setup");
        edits +=
            check_runs_the_same(&program.text, &setup).unwrap_or_else(|why| panic!("{}: {why}", program.id));
    }
    assert!(edits > 150, "{edits} words");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_programs_run_the_same(text in program(), setup in any_setup()) {
        check_runs_the_same(&text, &small(&setup)).map_err(TestCaseError::fail)?;
    }
}

#[test]
fn a_file_is_converted_in_place() {
    let path = file("convert-in-place.nc", INCREMENTAL);
    let name = path.to_str().expect("a name");
    let output = run(&["convert", "--to", "absolute", "--check", name], b"");
    assert_eq!((output.status.code(), output.stdout), (Some(1), format!("{name}\n").into_bytes()));
    let output = run(&["convert", "--to", "absolute", name], b"");
    assert_eq!((output.status.code(), output.stderr), (Some(0), Vec::new()));
    assert_eq!(std::fs::read_to_string(&path).expect("a file"), ABSOLUTE);
    let output = run(&["convert", "--to", "incremental", "-"], ABSOLUTE.as_bytes());
    assert_eq!(String::from_utf8_lossy(&output.stdout), INCREMENTAL);
    assert_eq!(String::from_utf8_lossy(&output.stderr), "<stdin>:4: `X32` stays (2 in all)\n");
}
