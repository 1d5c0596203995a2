//! The exercises of `www/exercises`, with answers whose results are worked out by hand; and the form of their files.
//!
//! `tests/exercise/<id>` has `reference.nc`, `other.nc` (an independent solution), wrong answers, and `expect.json`:
//! for each answer the verdict on the part, the line, the cause (a part of it) and the failed checks. Without `part`
//! an answer named `wrong` must only differ.

use std::collections::BTreeSet;
use std::path::Path;

use gcode_playground::analyze;
use gcode_playground::api::exercise::Graded;
use gcode_playground::api::{self, Places};
use gcode_playground::exercise::{self, Exercise, Kind, Part, Problem, Quantity, TargetFault, key_of};
use gcode_playground::sentences::Language;
use gcode_playground::sentences::exercise_file::describe_fault;
use gcode_playground::source::LineIndex;
use serde_json::Value;

use crate::project;

const FOLDER: &str = "www/exercises/";

/// The ids of all exercises.
fn ids() -> Vec<String> {
    let files = project::files().into_iter();
    files.filter_map(|file| Some(file.strip_prefix(FOLDER)?.strip_suffix(".md")?.to_owned())).collect()
}

#[test]
fn the_course_has_each_exercise_once() {
    let course: Vec<String> =
        serde_json::from_str(&project::source("www/exercises/course.json")).expect("a list");
    let [course, all] = [course, ids()].map(|mut ids| {
        ids.sort();
        ids
    });
    assert_eq!(course, all);
}

fn read(id: &str) -> Exercise {
    let text = project::source(&format!("{FOLDER}{id}.md"));
    Exercise::read(&text)
        .unwrap_or_else(|error| panic!("{id}:{}: {}", error.line, describe_fault(&error, Language::English)))
}

fn graded(exercise: &Exercise, text: &str, language: Language) -> Graded {
    let report = exercise::check(exercise, text.as_bytes());
    let lines = LineIndex::as_written(text.as_bytes());
    Graded::new(&report, exercise, Places { text: text.as_bytes(), lines: &lines }, language)
}

/// The answers of an exercise: name and text.
fn answers(id: &str) -> Vec<(String, String)> {
    let folder = format!("tests/exercise/{id}/");
    let files = project::files();
    let names =
        files.iter().filter_map(|file| file.strip_prefix(&folder)).filter(|name| name.ends_with(".nc"));
    names.map(|name| (name.to_owned(), project::source(&format!("{folder}{name}")))).collect()
}

/// The differences between a report and the expectation.
fn wrong(name: &str, graded: &Graded, expected: &Value) -> Vec<String> {
    let mut wrong = Vec::new();
    let mut differs = |what: &str, found: &str, wanted: &str| {
        wrong.push(format!("{name}: {what}: `{found}` instead of `{wanted}`"));
    };
    match expected["part"].as_str() {
        Some(part) if part != graded.part => differs("part", &graded.part, part),
        None if graded.same_part == name.starts_with("wrong") => differs("part", &graded.part, ""),
        _ => {}
    }
    if let Some(line) = expected["line"].as_u64().filter(|line| graded.line.map(u64::from) != Some(*line)) {
        differs("line", &format!("{:?}", graded.line), &line.to_string());
    }
    let cause = graded.cause.as_ref().map(|cause| cause.text.clone()).unwrap_or_default();
    match expected["cause"].as_str() {
        Some(part) if !cause.contains(part) => differs("cause", &cause, part),
        None if !cause.is_empty() => differs("cause", &cause, ""),
        _ => {}
    }
    let failed: Vec<&str> = graded.failed().map(|check| check.check.as_str()).collect();
    let wanted: Vec<&str> =
        expected["failed"].as_array().into_iter().flatten().filter_map(Value::as_str).collect();
    if failed != wanted {
        differs("failed", &failed.join("; "), &wanted.join("; "));
    }
    wrong
}

#[test]
fn every_answer_has_the_result_that_was_worked_out() {
    let mut all = Vec::new();
    for id in ids() {
        let exercise = read(&id);
        let expected: Value =
            serde_json::from_str(&project::source(&format!("tests/exercise/{id}/expect.json")))
                .expect("JSON");
        let answers = answers(&id);
        let names: BTreeSet<&str> = answers.iter().map(|(name, _)| name.as_str()).collect();
        assert!(names.contains("reference.nc") && names.contains("other.nc"), "{id}: {names:?}");
        let count = names.iter().filter(|name| name.starts_with("wrong-")).count();
        assert!(count >= 3, "{id} has {count} wrong answers");
        for (name, text) in &answers {
            let none = Value::Null;
            let own = if name == "reference.nc" { &none } else { &expected[name] };
            assert!(name == "reference.nc" || own.is_object(), "{id}: {name} is not in expect.json");
            let graded = graded(&exercise, text, Language::English);
            all.extend(wrong(name, &graded, own).into_iter().map(|wrong| format!("{id}/{wrong}")));
            if name.starts_with("wrong") && graded.passed {
                all.push(format!("{id}/{name} is passed"));
            }
        }
    }
    assert!(all.is_empty(), "{}", all.join("\n"));
}

#[test]
fn every_exercise_is_complete_in_three_languages() {
    let ids = ids();
    assert!(ids.len() >= 6, "{ids:?}");
    for id in &ids {
        let exercise = read(id);
        assert_eq!(&exercise.id, id);
        for texts in &exercise.texts {
            let texts = texts.as_ref().unwrap_or_else(|| panic!("{id}: a language is missing"));
            assert_eq!(texts.hints.len(), 3, "{id}: {}", texts.title);
        }
        let chapter = exercise.chapter.as_ref().unwrap_or_else(|| panic!("{id}: no chapter"));
        for language in ["en", "zh", "ru"] {
            let page = format!("www/manual/{language}/{chapter}.md");
            assert!(Path::new(project::ROOT).join(&page).exists(), "{id}: {page}");
        }
    }
}

#[test]
fn no_exercise_contains_its_solution() {
    for id in ids() {
        let exercise = read(&id);
        let graded = graded(&exercise, &exercise.program, Language::English);
        let shows_itself = exercise.kind == Kind::Predict;
        assert!(!graded.passed || shows_itself, "{id}: the program to start with is a solution");
        let file = project::source(&format!("{FOLDER}{id}.md"));
        let reference = project::source(&format!("tests/exercise/{id}/reference.nc"));
        assert!(!file.contains(reference.trim()), "{id}");
    }
}

#[test]
fn verdicts_are_in_three_languages() {
    let exercise = read("one-cycle");
    let text = project::source("tests/exercise/one-cycle/wrong-3.nc");
    let said = |language| {
        let graded = graded(&exercise, &text, language);
        (graded.part, graded.cause.expect("a cause").text, graded.checks[0].check.clone())
    };
    let texts = |part: &str, cause: &str, check: &str| (part.to_owned(), cause.to_owned(), check.to_owned());
    assert_eq!(
        said(Language::Chinese),
        texts("Z-15：Ø13，应为 Ø26 ±0.05", "X13 写成了半径，而 X 是直径：应为 X26", "运行无报警")
    );
    assert_eq!(
        said(Language::Russian),
        texts(
            "Z-15: Ø13, нужно Ø26 ±0.05",
            "X13 – радиус, а X задают диаметром: нужно X26",
            "выполняется без аварийных сигналов"
        )
    );
}

// ---- files ----------------------------------------------------------------------------------------

const FILE: &str = "---\nid: step\n---\n\n```setup\n(STOCK D=30 LENGTH=60)\n```\n\n```target\nX0 Z0\nX26\nZ-30\nX30\nZ-40 free\n```\n\n# en: A step\n\nTurn it.\n\n> A hint.\n";

fn fault(text: &str) -> (usize, Problem) {
    let error = Exercise::read(text).expect_err("a fault");
    for language in Language::ALL {
        assert!(!describe_fault(&error, language).contains("{}"), "{error:?}");
    }
    (error.line, error.problem)
}

/// The file with a line added to its head.
fn with_head(line: &str) -> String {
    FILE.replacen("id: step\n", &format!("id: step\n{line}\n"), 1)
}

#[test]
fn a_small_file_is_read() {
    let exercise = Exercise::read(FILE).expect("an exercise");
    assert_eq!((exercise.kind, exercise.points, exercise.program.as_str()), (Kind::Write, 10, ""));
    assert_eq!(exercise.target.edges.len(), 4);
    // Missing languages show the first one.
    assert_eq!(exercise.texts(2).expect("texts").title, "A step");
    let crlf = FILE.replace('\n', "\r\n");
    assert_eq!(Exercise::read(&crlf).expect("an exercise"), exercise);
    let marked = format!("\u{feff}{FILE}");
    assert_eq!(Exercise::read(&marked).expect("an exercise"), exercise);
    let json = FILE.replace("(STOCK D=30 LENGTH=60)", r#"{"stock": {"diameter": 30, "length": 60}}"#);
    assert_eq!(Exercise::read(&json).expect("an exercise").setup.stock, exercise.setup.stock);
}

#[test]
fn every_check_of_the_head_is_read() {
    let head = "kind: blanks\npoints: 30\nchapter: g90\ncontrol: gsk\ntolerance: +0.1 -0.05\ncorners: 0.8\nrequire: g1, M8\nforbid: G90\ndepth: ..2\nfeed: 0.1..0.3\nspeed: 300..\ncutting-speed: 80..200\ntime: ..60\ncuts-to: X26 Z-30\nsafe-end: 5\ncollisions: any\nalarms: none";
    let text = with_head(head).replacen("```target", "```gcode\nG90 X__\n```\n\n```target", 1);
    let exercise = Exercise::read(&text).expect("an exercise");
    let checks = &exercise.checks;
    assert_eq!((exercise.kind, exercise.points, exercise.target.corners), (Kind::Blanks, 30, 0.8));
    assert_eq!(
        (&checks.require[..], &checks.forbid[..]),
        (&["G01".to_owned(), "M08".into()][..], &["G90".into()][..])
    );
    assert_eq!((checks.collisions, checks.alarms, checks.safe_end), (false, true, Some(5.0)));
    assert_eq!((checks.cuts_to, checks.depth.and_then(|own| own.most)), (Some([26.0, -30.0]), Some(2.0)));
    assert_eq!(exercise.target.edges[0].tolerance.lower, -0.05);
}

#[test]
fn faults_are_reported_with_their_line() {
    assert_eq!(fault("id: step"), (1, Problem::NoHead));
    assert_eq!(fault("---\nid: step\n"), (1, Problem::HeadOpen));
    assert_eq!(fault("---\nid step\n---\n"), (2, Problem::HeadLine));
    assert_eq!(fault("---\nkind: write\n---\n"), (1, Problem::Missing { name: "id" }));
    let unknown = Problem::UnknownKey { key: "feeds".into(), nearest: Some("feed") };
    assert_eq!(fault(&with_head("feeds: ..1")), (3, unknown));
    assert_eq!(fault(&with_head("id: step")), (3, Problem::Twice { name: "id".into() }));
    assert_eq!(fault(&with_head("kind: fault")), (1, Problem::Missing { name: "gcode" }));
    assert_eq!(fault(&with_head("kind: predict")), (1, Problem::Missing { name: "predict" }));
    for line in [
        "kind: draw",
        "points: 0",
        "points: 1.5",
        "chapter: ../g90",
        "control: siemens",
        "tolerance: 0.1",
        "corners: 9",
        "require: G71;G70",
        "forbid: T01",
        "depth: 2",
        "cuts-to: X26",
        "safe-end: far",
        "alarms: no",
        "predict: 0",
    ] {
        let key = line.split(':').next().expect("a key");
        let found = fault(&with_head(line));
        assert!(matches!(found, (3, Problem::Value { key: own, .. }) if own == key), "{line}: {found:?}");
    }
    let change = |from: &str, to: &str| fault(&FILE.replacen(from, to, 1));
    assert_eq!(change("```setup", "```text"), (5, Problem::UnknownBlock { name: "text".into() }));
    assert_eq!(change("```target", "```setup"), (9, Problem::Twice { name: "setup".into() }));
    assert_eq!(change("free\n```\n", "free\n"), (9, Problem::BlockOpen));
    assert_eq!(change("# en", "Text\n# en"), (17, Problem::StrayText));
    assert_eq!(change("# en", "# de"), (17, Problem::Heading));
    assert_eq!(change("# en: A step", "## A step"), (17, Problem::NoText));
    assert_eq!(change("A hint.", "<script>"), (21, Problem::Html));
    assert_eq!(change("(STOCK D=30 LENGTH=60)", "(TOOL T0101 TYPE=TURNING)"), (6, Problem::NoBlank));
    assert!(matches!(change("D=30", "D=-30"), (6, Problem::SetupValue(_))));
    assert!(matches!(change("D=30", "W=30"), (6, Problem::SetupValue(_))));
    assert!(matches!(change("(STOCK", "G90 (STOCK"), (6, Problem::Setup { .. })));
    assert!(matches!(change("(STOCK D=30 LENGTH=60)", "{\"stok\": {}}"), (6, Problem::Setup { .. })));
    let target = |fault| Problem::Target(fault);
    assert_eq!(change("X26\n", "X2G\n"), (11, target(TargetFault::Word { word: "X2G".into() })));
    assert_eq!(change("X0 Z0\n", "X0\n"), (10, target(TargetFault::First)));
    assert_eq!(change("X26\n", "X99999\n"), (11, target(TargetFault::Range { word: "X99999".into() })));
    let twice = format!("{FILE}\n# en: Again\n\nText.\n");
    assert_eq!(fault(&twice), (23, Problem::Twice { name: "en".into() }));
}

#[test]
fn hostile_files_are_refused_with_a_message() {
    let part = |text: &str| match fault(text).1 {
        Problem::TooMany { part, .. } => part,
        other => panic!("{other:?}"),
    };
    assert_eq!(part(&"-".repeat(10_000_000)), Part::File);
    let checks: String = (0..2000).map(|_| "depth: ..2\n").collect();
    assert_eq!(part(&with_head(&checks)), Part::Head);
    let codes: Vec<String> = (0..1000).map(|code| format!("G{}", code % 100)).collect();
    assert_eq!(part(&with_head(&format!("require: {}", codes.join(", ")))), Part::Codes);
    let program = format!("```gcode\n{}```\n\n```target", "G01 X1 Z1 F0.1\n".repeat(2000));
    assert_eq!(part(&FILE.replacen("```target", &program, 1)), Part::Program);
    let setup = "(TOOL T0101 TYPE=TURNING)\n".repeat(1000);
    assert_eq!(part(&FILE.replacen("(STOCK D=30", &format!("{setup}(STOCK D=30"), 1)), Part::Setup);
    let huge: String = (0..5000).map(|at| format!("Z-{}\nX{}\n", at + 1, 30 + at % 2)).collect();
    let huge = fault(&FILE.replacen("X26\n", &huge, 1)).1;
    assert!(matches!(huge, Problem::Target(TargetFault::TooMany { lines }) if lines > 9000), "{huge:?}");
    // No text panics, whatever it contains.
    for cut in 0..FILE.len() {
        let _ = Exercise::read(&FILE[..cut]);
        let _ = Exercise::read(&FILE[cut..]);
    }
    for letter in ["\0", "\u{202e}", "é", "```", "---", "#", ">", "\u{2028}"] {
        for at in (0..FILE.len()).step_by(3) {
            let _ = Exercise::read(&format!("{}{letter}{}", &FILE[..at], &FILE[at..]));
        }
    }
}

#[test]
fn hostile_answers_are_bounded() {
    let exercise = Exercise::read(FILE).expect("an exercise");
    let answers = [
        String::new(),
        "\0\u{ffff}".repeat(1000),
        "N1 GOTO 1\n".to_owned(),
        "#1=0\nWHILE[1]DO1\nG01 X#1 Z-#1 F0.1\n#1=#1+1\nEND1\n".to_owned(),
        "G90 X26 Z-30 F0.1\n".repeat(20_000),
        "(STOCK D=1 LENGTH=1)\nG00 X32 Z2\nG71 U0.0001 R1\nG71 P1 Q2 U0 W0 F0.1\nN1 X1\nN2 Z-30\n".to_owned(),
        "G01 X-99999 Z99999 F0\n".to_owned(),
        "(".repeat(100_000),
    ];
    for text in answers {
        let report = exercise::check(&exercise, text.as_bytes());
        assert!(!report.is_passed(), "{}", &text[..text.len().min(20)]);
    }
    assert!(!exercise::check(&exercise, &[0xff; 1000]).is_passed());
}

#[test]
fn an_answer_cannot_bring_its_own_blank_or_tools() {
    let exercise = Exercise::read(FILE).expect("an exercise");
    let cheat = "(STOCK X=0 Z=0 X=26 Z=0 X=26 Z=-30 X=30 Z=-30)\n(STOCK X=30 Z=-60)\nG00 X100 Z100\nM30\n";
    let report = exercise::check(&exercise, cheat.as_bytes());
    assert_ne!(report.verdict, exercise::Verdict::Same);
}

// ---- measuring ------------------------------------------------------------------------------------

/// A random program of steps and cones, and the diameter of its part at each whole place between shoulders.
fn random_part(random: &mut impl FnMut(u64) -> u64) -> (String, String) {
    let steps = 2 + random(4);
    let mut program = String::from("T0101\nG97 S500 M03\nG00 X46 Z2\n");
    let (mut x, mut z) = (14.0 + random(100) as f64 / 10.0, 0.0);
    program += &format!("G00 X{x}\nG01 Z0 F0.2\n");
    let mut target = format!("X0 Z0\nX{x}\n");
    for _ in 0..steps {
        z -= 4.0 + random(80) as f64 / 10.0;
        let cone = random(3) == 0;
        if cone {
            x += random(20) as f64 / 20.0 + 0.4;
        }
        program += &format!("G01 X{x:.2} Z{z:.1} F0.2\n");
        target += &format!("X{x:.2} Z{z:.1}\n");
        x += 0.4 + random(20) as f64 / 20.0;
        program += &format!("X{x:.2}\n");
        target += &format!("X{x:.2}\n");
    }
    program += "X46\nG00 X100 Z100\nM30\n";
    target += &format!("X44\nZ{:.1} free\n", z - 5.0);
    (program, target)
}

/// The measuring report of a hundred random parts agrees with the part that `part` prints, to a micrometre.
#[test]
fn the_measuring_report_agrees_with_the_part() {
    let mut seed = 1u64;
    let mut random = |most: u64| {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 33) % most
    };
    let mut measured = 0;
    for round in 0..100 {
        let (program, target) = random_part(&mut random);
        let text = FILE.replacen("X0 Z0\nX26\nZ-30\nX30\nZ-40 free\n", &target, 1);
        let text = text.replacen(
            "(STOCK D=30 LENGTH=60)",
            "(STOCK D=44 LENGTH=120)\n(TOOL T0101 TYPE=TURNING INSERT=V KR=93 EDGE=60)",
            1,
        );
        let exercise = Exercise::read(&text).unwrap_or_else(|error| panic!("{error:?}\n{text}"));
        let report = exercise::check(&exercise, program.as_bytes());
        assert_eq!(report.verdict, exercise::Verdict::Same, "{round}:\n{program}\n{target}");
        let part = analyze(program.as_bytes(), &exercise.setup).simulate().finished().expect("a part");
        let polygons = api::Part::new(&part).polygons;
        for size in report.sizes.iter().filter(|size| size.quantity == Quantity::Diameter) {
            let actual = size.actual.expect("a size");
            let found = diameter_at(&polygons, size.at.z);
            assert!((actual - found).abs() < 0.001, "{round}: Z{}: {actual}, part {found}", size.at.z);
            measured += 1;
        }
    }
    assert!(measured > 250, "{measured}");
}

/// The outside diameter of polygons at Z.
fn diameter_at(polygons: &[Vec<[f64; 2]>], z: f64) -> f64 {
    let edges = polygons.iter().flat_map(|own| own.iter().zip(own.iter().cycle().skip(1)));
    let crossing = edges.filter(|(a, b)| (a[0] < z) != (b[0] < z));
    let diameters = crossing.map(|(a, b)| a[1] + (z - a[0]) / (b[0] - a[0]) * (b[1] - a[1]));
    diameters.fold(0.0, f64::max)
}

#[test]
fn identical_text_is_recognised() {
    let reference = project::source("tests/exercise/one-cycle/reference.nc");
    let numbered: String =
        reference.lines().zip(1..).map(|(line, n)| format!("N{n}0 {line} (mine)\n")).collect();
    assert_eq!(key_of(reference.as_bytes()), key_of(numbered.as_bytes()));
    let other = project::source("tests/exercise/one-cycle/wrong-1.nc");
    assert_ne!(key_of(reference.as_bytes()), key_of(other.as_bytes()));
}

/// The file of an exercise with another target.
fn with_target(id: &str, target: &str) -> String {
    let text = project::source(&format!("{FOLDER}{id}.md"));
    let (before, rest) = text.split_once("```target\n").expect("a target");
    let (_, after) = rest.split_once("```").expect("its end");
    format!("{before}```target\n{target}```{after}")
}

#[test]
fn every_reference_makes_the_target_that_is_written_from_it() {
    for id in ids() {
        let exercise = read(&id);
        let program = match exercise.kind {
            Kind::Predict => exercise.program.clone(),
            _ => project::source(&format!("tests/exercise/{id}/reference.nc")),
        };
        let analysis = analyze(program.as_bytes(), &exercise.setup);
        let target = exercise::target_of(&analysis.simulate(), &analysis.motions)
            .unwrap_or_else(|why| panic!("{id}: {why:?}"));
        let own = Exercise::read(&with_target(&id, &target))
            .unwrap_or_else(|error| panic!("{id}: {error:?}\n{target}"));
        let report = exercise::check(&own, program.as_bytes());
        assert_eq!(report.verdict, exercise::Verdict::Same, "{id}:\n{target}");
    }
}

#[test]
fn a_target_is_written_from_a_program() {
    // Without a nose radius, the part has the sizes of the drawing.
    for id in ["two-steps", "cone-30-40", "face-step", "facing"] {
        let exercise = read(id);
        let program = project::source(&format!("tests/exercise/{id}/reference.nc"));
        let analysis = analyze(program.as_bytes(), &exercise.setup);
        let target = exercise::target_of(&analysis.simulate(), &analysis.motions).expect(id);
        let points = |target: &exercise::Target| -> Vec<[i64; 2]> {
            let micrometres = |value: f64| (value * 1000.0).round() as i64;
            target.edges.iter().map(|edge| [micrometres(edge.to.x), micrometres(edge.to.z)]).collect()
        };
        let text = FILE.replacen("X0 Z0\nX26\nZ-30\nX30\nZ-40 free\n", &target, 1);
        let text = text.replacen("D=30", "D=80", 1);
        let own = Exercise::read(&text).unwrap_or_else(|error| panic!("{id}: {error:?}\n{target}"));
        let (own, wanted) = (points(&own.target), points(&exercise.target));
        // An open outline ends in the bar; how far behind the part does not matter.
        let count = if exercise.target.is_parted { wanted.len() } else { wanted.len() - 1 };
        assert_eq!(own[..count], wanted[..count], "{id}:\n{target}");
    }
}
