//! `convert`: coordinates, arcs, cycles and lengths in another form; the words that stay, and that no program runs differently.

use crate::cli::{file, run};
use crate::fixtures;
use crate::random_programs;

use gcode_playground::analyze;
use gcode_playground::api::{Converted, LeftWord, Places};
use gcode_playground::convert::unit::NEAR;
use gcode_playground::convert::{Conversion, ProgramForm, converted};
use gcode_playground::message::applied;
use gcode_playground::run::Run;
use gcode_playground::sentences::Language;
use gcode_playground::setup::Setup;
use gcode_playground::setup::dialect::GSystem;
use gcode_playground::source::LineIndex;
use proptest::prelude::*;
use random_programs::{any_setup, program, small};

/// The forms that leave the motions as they are, apart from the rounding of a centre.
const FORMS: [ProgramForm; 6] = [
    ProgramForm::Absolute,
    ProgramForm::Incremental,
    ProgramForm::Radius,
    ProgramForm::Center,
    ProgramForm::OneBlock,
    ProgramForm::TwoBlocks,
];

fn conversion(text: &str, form: ProgramForm) -> Conversion {
    converted(text.as_bytes(), text.len(), &Setup::default(), form)
}

fn form_of(system: GSystem) -> ProgramForm {
    match system {
        GSystem::A => ProgramForm::SystemA,
        GSystem::B => ProgramForm::SystemB,
        GSystem::C => ProgramForm::SystemC,
    }
}

/// The program in a form, and the words that stay.
fn written(text: &str, form: ProgramForm) -> (String, Vec<String>) {
    let found = conversion(text, form);
    let after = String::from_utf8(applied(text.as_bytes(), &found.edits)).expect("UTF-8");
    (after, found.left.iter().map(|word| word.quote(text.as_bytes())).collect())
}

#[track_caller]
fn check(form: ProgramForm, before: &str, after: &str, left: &[&str]) {
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
    check(ProgramForm::Absolute, INCREMENTAL, ABSOLUTE, &[]);
    check(ProgramForm::Incremental, ABSOLUTE, INCREMENTAL, &["X32", "Z2"]);
    // X30 Z-5, then 4 mm on the diameter; the word keeps its point.
    check(
        ProgramForm::Absolute,
        "G00 X30. Z-5.\nG01 U4. W-1.25 F.1\nM30\n",
        "G00 X30. Z-5.\nG01 X34. Z-6.25 F.1\nM30\n",
        &[],
    );
}

#[test]
fn a_distance_from_an_unknown_place_stays() {
    // The start is assumed; after G28 and a new tool the place is that of the machine.
    check(ProgramForm::Absolute, "G00 U-4\nX30\nU-2\nM30\n", "G00 U-4\nX30\nX28\nM30\n", &["U-4"]);
    check(
        ProgramForm::Absolute,
        "G00 X30 Z2\nG28 U0 W0\nG00 U-10\nX20 W-5\nM30\n",
        "G00 X30 Z2\nG28 U0 W0\nG00 U-10\nX20 W-5\nM30\n",
        &["U-10", "W-5"],
    );
    check(
        ProgramForm::Incremental,
        "T0101\nG00 X30 Z2\nX20\nT0202\nX30 Z2\nZ-5\nM30\n",
        "T0101\nG00 X30 Z2\nU-10\nT0202\nX30 Z2\nW-7\nM30\n",
        &["X30", "Z2", "X30", "Z2"],
    );
}

#[test]
fn a_block_at_several_places_stays() {
    let text = "O1\nG00 X30 Z2\nM98 P2 L3\nM30\nO2\nG01 U-2 F.2\nU1 W-1\nM99\n";
    check(ProgramForm::Absolute, text, text, &["U-2", "U1", "W-1"]);
    // The way is the same each time.
    let text =
        "O1\nG00 X30 Z0\nG01 Z-5 F.2\n#1=0\nWHILE[#1LT2]DO1\nG00 X32\nZ0\nX30\nG01 Z-5\n#1=#1+1\nEND1\nM30\n";
    let (after, _) = written(text, ProgramForm::Incremental);
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
    check(ProgramForm::Absolute, &contour("X20", "W-12\nU10 W-5"), &contour("X20", "Z-10\nX30 Z-15"), &[]);
}

#[test]
fn cycles_and_other_words_stay() {
    for text in [
        "G00 X30 Z2\nG90 U-4 W-20 F.2\nM30\n",
        "G00 X30 Z2\nG04 U1\nM30\n",
        "G00 X30 Z2\n#1=4\nG01 U#1 F.2\nM30\n",
        "G00 X30 Z2\nG01 W-10,C1 F.2\nX40\nM30\n",
    ] {
        assert_eq!(written(text, ProgramForm::Absolute).0, text);
    }
    // G90 of system B is not a cycle.
    let setup = Setup::from_json(r#"{"dialect": {"gSystem": "B"}}"#).expect("a setup");
    let text = "G90 G00 X30 Z2\nG91 G01 X-4 F.2\nM30\n";
    assert_eq!(converted(text.as_bytes(), text.len(), &setup, ProgramForm::Incremental).edits, []);
}

#[test]
fn an_arc_has_a_radius_or_a_centre() {
    // From X20 Z-5 to X30 Z-10, a quarter with its centre at X30 Z-5: I5 K0.
    let arc = |words: &str| format!("G00 X20 Z-5\nG02 X30 Z-10 {words} F.1\nM30\n");
    check(ProgramForm::Center, &arc("R5"), &arc("I5 K0"), &[]);
    check(ProgramForm::Radius, &arc("I5 K0"), &arc("R5"), &[]);
    check(ProgramForm::Radius, &arc("I5. K0."), &arc("R5."), &[]);
    // Incremental, in inches.
    check(
        ProgramForm::Center,
        "G20\nG00 X2. Z0\nG03 U.5 W-.25 R.25 F.01\nM30\n",
        "G20\nG00 X2. Z0\nG03 U.5 W-.25 I0. K-0.25 F.01\nM30\n",
        &[],
    );
    // Three quarters around X20 Z-10, and a full circle: R is for arcs of less than half a turn.
    check(ProgramForm::Radius, &arc("I0 K-5"), &arc("I0 K-5"), &["I0", "K-5"]);
    let circle = "G00 X20 Z-5\nG02 I5 K0 F.1\nM30\n";
    check(ProgramForm::Radius, circle, circle, &["I5", "K0"]);
}

/// A contour after its cycle, and the end of the program.
const CONTOUR: &str = "N1 G00 X20\nG01 Z-10\nX30 Z-15\nN2 X42\nG70 P1 Q2\nM30\n";

#[test]
fn roughing_in_one_block_has_the_depth_in_least_increments() {
    let program = |call: &str| format!("G00 X42 Z2 M03 S500\n{call}\n{CONTOUR}");
    // The escape of 1 mm is the one in force.
    check(
        ProgramForm::OneBlock,
        &program("G71 U2 R1\nG71 P1 Q2 U.4 W.1 F.2"),
        &program("G71 P1 Q2 U.4 W.1 D2000 F.2"),
        &[],
    );
    check(
        ProgramForm::TwoBlocks,
        &program("G71 P1 Q2 U.4 W.1 D2000 F.2"),
        &program("G71 U2\nG71 P1 Q2 U.4 W.1 F.2"),
        &[],
    );
    check(
        ProgramForm::OneBlock,
        &program("G71 U1.5\nN9 G71 P1 Q2 U.4 W.1"),
        &program("N9 G71 P1 Q2 U.4 W.1 D1500"),
        &[],
    );
    // Another escape has no word in one block, and a block number may be needed.
    for call in ["G71 U2 R.5\nG71 P1 Q2 U.4 W.1 F.2", "N8 G71 U2\nG71 P1 Q2 U.4 W.1 F.2\nIF[1EQ2]GOTO8"] {
        let text = program(call);
        assert_eq!(written(&text, ProgramForm::OneBlock), (text.clone(), vec!["G71".to_owned()]), "{text}");
    }
    // D of G73 is the number of its passes.
    check(
        ProgramForm::TwoBlocks,
        &program("G73 P1 Q2 I6. K2. U.4 W.1 D3 F.2"),
        &program("G73 U6. W2. R3\nG73 P1 Q2 U.4 W.1 F.2"),
        &[],
    );
    check(
        ProgramForm::OneBlock,
        &program("G73 U6. W2. R3\nG73 P1 Q2 U.4 W.1 F.2"),
        &program("G73 P1 Q2 U.4 W.1 I6. K2. D3 F.2"),
        &[],
    );
}

#[test]
fn pecking_and_threading_in_one_block() {
    let program = |call: &str| format!("G00 X42 Z2 M03 S500\n{call}\nG00 X60 Z10\nM30\n");
    check(
        ProgramForm::TwoBlocks,
        &program("G75 X30 Z-10 I2. K3. F.1"),
        &program("G75 X30 Z-10 P2000 Q3000 F.1"),
        &[],
    );
    check(
        ProgramForm::OneBlock,
        &program("G74 R1\nG74 X30 Z-10 P3000 Q2500 F.1"),
        &program("G74 X30 Z-10 I3 K2.5 F.1"),
        &[],
    );
    // Without I or K, the block would not have the one-block form.
    for (call, form) in [("G75 X30 R.1", ProgramForm::OneBlock), ("G74 Z-10 R.1 F.1", ProgramForm::OneBlock)]
    {
        let text = program(call);
        assert_eq!(written(&text, form).0, text, "{call}");
    }
    // One finishing pass, no pull-out, 60 degrees, no least depth, no allowance.
    let thread = "G00 X42 Z10 M03 S300\n";
    let one = format!("{thread}G76 X35.1 Z-30 K2.45 D700 F4 A60\nM30\n");
    let two = format!("{thread}G76 P010060 Q0 R0\nG76 X35.1 Z-30 P2450 Q700 F4\nM30\n");
    check(ProgramForm::TwoBlocks, &one, &two, &[]);
    check(ProgramForm::OneBlock, &two, &format!("{thread}G76 X35.1 Z-30 K2.45 D700 A60 F4\nM30\n"), &[]);
    // The allowance of the last pass has no word in one block.
    let own = format!("{thread}G76 P010060 Q0 R.1\nG76 X35.1 Z-30 P2450 Q700 F4\nM30\n");
    assert_eq!(written(&own, ProgramForm::OneBlock).0, own);
}

#[test]
fn lengths_are_written_in_millimetres_or_inches() {
    // 2 in = 50.8 mm; 0.01 in/rev = 0.254 mm/rev; 400 ft/min = 121.92 m/min.
    let inches =
        "G20\nG96 S400 M03\nG00 X2. Z.1\nG01 Z-1.25 F.01\nG04 X1.5\nG97 S500\nG92 X1.9 Z-1. F.125\nM30\n";
    let millimetres = "G21\nG96 S122 M03\nG00 X50.8 Z2.54\nG01 Z-31.75 F0.254\nG04 X1.5\nG97 S500\nG92 X48.26 Z-25.4 F3.175\nM30\n";
    check(ProgramForm::Mm, inches, millimetres, &[]);
    let back =
        "G20\nG96 S400 M03\nG00 X2. Z0.1\nG01 Z-1.25 F0.01\nG04 X1.5\nG97 S500\nG92 X1.9 Z-1. F0.125\nM30\n";
    assert_eq!(written(millimetres, ProgramForm::Inch).0, back);
    // Without a code for the unit it is added; 10 mm = 0.3937 in. Q counts 0.001 mm or 0.0001 in.
    assert_eq!(
        written("O1\nT0101 M03 S500\nG00 X60. Z2.\nG75 X10. Z2. P2540 F.1\nM30\n", ProgramForm::Inch),
        (
            "O1\nG20\nT0101 M03 S500\nG00 X2.3622 Z0.0787\nG75 X0.3937 Z0.0787 P1000 F0.0039\nM30\n"
                .to_owned(),
            Vec::new()
        )
    );
    // A length that is not known stays, and so does all of the program.
    let text = "G21\n#1=20\nG00 X#1\nM30\n";
    assert_eq!(written(text, ProgramForm::Inch).0, text);
    let text = "G21\nG00 X20 C5\nM30\n";
    assert_eq!(written(text, ProgramForm::Inch), (text.to_owned(), vec!["C5".to_owned()]));
}

#[test]
fn codes_are_written_in_another_system() {
    let system = |text: &str, from: &str, to: GSystem| {
        let setup = Setup::from_json(&format!(r#"{{"dialect": {{"gSystem": "{from}"}}}}"#)).expect("a setup");
        let found = converted(text.as_bytes(), text.len(), &setup, form_of(to));
        let left: Vec<String> = found.left.iter().map(|word| word.quote(text.as_bytes())).collect();
        (String::from_utf8(applied(text.as_bytes(), &found.edits)).expect("UTF-8"), left)
    };
    // FANUC B-64304, list of G codes: G90 G92 G94 G98 G50 of A are G77 G78 G79 G94 G92 of B, G20 G21 G24 G94 G92 of C.
    let a = "G21 G99 G50 S2000\nT0101 M03 S500\nG00 X32 Z2\nG90 X28 Z-20 F.2\nX26\nG00 U10 W5\nW-3\nX30\nG04 U1\nG98\nM30\n";
    let b = "G21 G95 G92 S2000\nT0101 M03 S500\nG90 G00 X32 Z2\nG77 X28 Z-20 F.2\nX26\nG91 G00 X10 Z5\nZ-3\nG90 X30\nG04 X1\nG94\nM30\n";
    let c = "G71 G95 G92 S2000\nT0101 M03 S500\nG90 G00 X32 Z2\nG20 X28 Z-20 F.2\nX26\nG91 G00 X10 Z5\nZ-3\nG90 X30\nG04 X1\nG94\nM30\n";
    assert_eq!(system(a, "A", GSystem::B), (b.to_owned(), Vec::new()));
    assert_eq!(system(a, "A", GSystem::C), (c.to_owned(), Vec::new()));
    assert_eq!(system(b, "B", GSystem::C), (c.to_owned(), Vec::new()));
    let back = "G21 G99 G50 S2000\nT0101 M03 S500\nG00 X32 Z2\nG90 X28 Z-20 F.2\nX26\nG00 U10 W5\nW-3\nX30\nG04 X1\nG98\nM30\n";
    assert_eq!(system(b, "B", GSystem::A), (back.to_owned(), Vec::new()));
    assert_eq!(system(c, "C", GSystem::A), (back.to_owned(), Vec::new()));
    // G90 or G91, not both.
    let mixed = "G00 X32 Z2\nX30 W-3\nM30\n";
    assert_eq!(system(mixed, "A", GSystem::B), (mixed.to_owned(), vec!["W-3".to_owned()]));
    // The allowances of G71 are no distances.
    let call = format!("G00 X42 Z2 M03 S500\nG71 U2 R1\nG71 P1 Q2 U.4 W.1 F.2\n{CONTOUR}");
    let (after, _) = system(&call, "A", GSystem::C);
    assert!(after.contains("G73 U2 R1\nG73 P1 Q2 U.4 W.1 F.2\n"), "{after}");
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
    Ok(count + check_units(text, setup)? + check_systems(text, setup)?)
}

/// Converts to each system: a run with that system makes the same motions.
fn check_systems(text: &str, setup: &Setup) -> Result<usize, String> {
    let mut count = 0;
    for system in GSystem::ALL {
        let found = converted(text.as_bytes(), text.len(), setup, form_of(system));
        if found.edits.is_empty() {
            continue;
        }
        count += found.edits.len();
        let after = String::from_utf8(applied(text.as_bytes(), &found.edits)).expect("UTF-8");
        let mut other = setup.clone();
        other.dialect.g_system = Some(system);
        let ends = |text: &str, setup: &Setup| -> Vec<_> {
            analyze(text.as_bytes(), setup).motions.iter().map(|motion| (motion.kind, motion.to)).collect()
        };
        let (one, after_ends) = (ends(text, setup), ends(&after, &other));
        let near =
            |((kind, to), (other, at)): (&(_, _), &(_, _))| kind == other && distance(*to, *at) <= 1e-6;
        if one.len() != after_ends.len() || !one.iter().zip(&after_ends).all(near) {
            return Err(format!("other motions: {system:?}\n{text}\n--- became:\n{after}"));
        }
        if !converted(after.as_bytes(), after.len(), &other, form_of(system)).edits.is_empty() {
            return Err(format!("not the same the second time: {system:?}\n{text}\n--- became:\n{after}"));
        }
    }
    Ok(count)
}

/// Converts to the other unit and back: the ends of the motions stay within the increments of both units.
fn check_units(text: &str, setup: &Setup) -> Result<usize, String> {
    let ends = |text: &str| -> Vec<_> {
        analyze(text.as_bytes(), setup).motions.iter().map(|motion| (motion.kind, motion.to)).collect()
    };
    let mut count = 0;
    for form in [ProgramForm::Inch, ProgramForm::Mm] {
        let found = converted(text.as_bytes(), text.len(), setup, form);
        count += found.edits.len();
        let after = String::from_utf8(applied(text.as_bytes(), &found.edits)).expect("UTF-8");
        let (one, other) = (ends(text), ends(&after));
        let near =
            |((kind, to), (other, at)): (&(_, _), &(_, _))| kind == other && distance(*to, *at) <= NEAR;
        if one.len() != other.len() || !one.iter().zip(&other).all(near) {
            return Err(format!("other motions: {form:?}\n{text}\n--- became:\n{after}"));
        }
        if !found.edits.is_empty() && !converted(after.as_bytes(), after.len(), setup, form).edits.is_empty()
        {
            return Err(format!("not the same the second time: {form:?}\n{text}\n--- became:\n{after}"));
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

/// The answer for the page and for Node.
fn answer(text: &str, form: ProgramForm) -> Converted {
    let text = text.as_bytes();
    let mut run = Run::new(text.to_vec(), Setup::default());
    while !run.advance(1_000) {}
    let lines = LineIndex::new(text);
    Places { text, lines: &lines }.converted(&run, form, Language::English)
}

#[test]
fn the_first_word_that_stays_is_named() {
    let check = |text: &str, form: ProgramForm, edits: usize, left: u32, first: Option<(u32, &str)>| {
        let Converted::Edits { edits: found, left: count, first_left } = answer(text, form) else {
            panic!("{text} is refused");
        };
        assert_eq!((found.len(), count), (edits, left), "{text}");
        let first = first.map(|(line, text)| LeftWord { line, text: text.to_owned() });
        assert_eq!(first_left, first, "{text}");
    };
    check("G00 U-4\nX30\nU-2\nM30\n", ProgramForm::Absolute, 1, 1, Some((1, "U-4")));
    check("G00 X30\nM30\n", ProgramForm::Absolute, 0, 0, None);
    // A unit is converted as a whole or not at all.
    check("G21\nG00 X30\nG20\nM30\n", ProgramForm::Inch, 0, 2, Some((1, "G21")));
    let siemens = "(STOCK D=50 LENGTH=60)\nG18 G90 G95 DIAMON\nT1 D1\nG0 X46 Z2\nM30\n";
    let refused = Converted::Refused { reason: "it is a program for another control".to_owned() };
    for form in [ProgramForm::Absolute, ProgramForm::OneBlock, ProgramForm::Inch, ProgramForm::SystemB] {
        assert_eq!(answer(siemens, form), refused);
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
