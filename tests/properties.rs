//! What holds for any input at all: no panic, no hang, spans in bounds, nothing lost; and invariants of the
//! cycles over random numbers.
#![cfg(not(target_arch = "wasm32"))]

use std::time::{Duration, Instant};

use gcode_playground::analyze;
use gcode_playground::api::Places;
use gcode_playground::control::modal::State;
use gcode_playground::expand::expand;
use gcode_playground::findings;
use gcode_playground::geometry::Point;
use gcode_playground::limits::Limits;
use gcode_playground::machine::SimulationResult;
use gcode_playground::motion::{Motion, MotionKind, Motions};
use gcode_playground::run::{Analysis, Run, TextEdit};
use gcode_playground::scene::Scene;
use gcode_playground::scene::face::Face;
use gcode_playground::scene::path_index::PathIndex;
use gcode_playground::scene::svg::{SvgOptions, svg};
use gcode_playground::scene::work::{Moment, Work};
use gcode_playground::sentences::Language;
use gcode_playground::setup::Setup;
use gcode_playground::source::LineIndex;
use gcode_playground::text::highlight::highlight;
use gcode_playground::text::lexer::Lexer;
use proptest::prelude::*;

/// Runs some bytes through everything and checks what must always hold.
fn check(text: &[u8]) {
    let mut at = 0;
    for token in Lexer::new(text, 0) {
        assert_eq!(token.span.start, at, "tokens leave no byte out");
        at = token.span.end;
    }
    assert_eq!(at as usize, text.len());
    let mut last = 0;
    for (span, _) in highlight(text, 0, text.len()) {
        assert!(last <= span.start && span.start < span.end && span.end as usize <= text.len());
        last = span.end;
    }
    check_analysis(text, &analyze(text, &Setup::default()));
}

/// Checks what must always hold of what a program gives.
fn check_analysis(text: &[u8], analysis: &Analysis) {
    let lines = LineIndex::new(text);
    let places = Places { text, lines: &lines };
    for diagnostic in &analysis.diagnostics {
        assert!(diagnostic.span.start <= diagnostic.span.end && diagnostic.span.end as usize <= text.len());
        for language in Language::ALL {
            let row = places.diagnostic(diagnostic, language);
            assert!(row.line >= 1 && row.column >= 1 && row.from <= row.to && !row.message.is_empty());
        }
        for edit in diagnostic.fixes.iter().flat_map(|fix| &fix.edits) {
            assert!(edit.span.end as usize <= text.len());
        }
    }
    for index in 0..analysis.motions.len() {
        let (motion, span) = (analysis.motions.get(index), analysis.motions.span(index));
        assert!(span.end as usize <= text.len() && !span.is_empty());
        assert_eq!(analysis.motions.line(index), lines.line_of(span.start));
        let programmed = motion.programmed.map(|programmed| programmed.to);
        let places = [Some(motion.from), Some(motion.to), motion.center, programmed];
        for place in places.into_iter().flatten() {
            assert!(place.x.is_finite() && place.z.is_finite(), "{motion:?}");
        }
        let turn = motion.rotary.map_or(0.0, |rotary| rotary.from + rotary.to);
        assert!(turn.is_finite() && motion.lead.or(motion.seconds).unwrap_or(0.0).is_finite(), "{motion:?}");
    }
    let path_index = PathIndex::of(&analysis.motions);
    let picture = svg(&Scene::new(&analysis.motions, &path_index, None), &SvgOptions::default());
    assert!(picture.contains("<svg"));
    // One of them for each program: there are enough programs.
    check_machine(analysis, &at_machine()[text.len() % 3]);
}

/// Nothing that a program does at the machine breaks the simulation, and no part is more than its blank.
fn check_machine(analysis: &Analysis, setup: &Setup) {
    let motions = &analysis.motions;
    let simulation = SimulationResult::of(motions, setup);
    for told in findings::diagnostics(&simulation, motions, &setup.rules, &[]) {
        assert!(!told.message.sentence(Language::English).message.contains("NaN"), "{told:?}");
    }
    if let Some(face) = Face::of(motions, &simulation) {
        let work = face.work(&simulation, None);
        let picture = svg(&face.moves().scene(work.as_ref()), &SvgOptions::default());
        assert!(!picture.contains("NaN") && !picture.contains("inf"));
    }
    let (Some(blank), Some(part)) = (simulation.blank(), simulation.finished()) else { return };
    assert!(part.area() <= blank.area() + 1e-3, "{} of {}", part.area(), blank.area());
    let moment = Moment { motion: motions.len() / 2, share: 0.5, tip: Point::default() };
    for moment in [None, Some(moment)] {
        let work = Work::of(&simulation, motions, moment);
        let path_index = PathIndex::of(motions);
        let picture = svg(&Scene::new(motions, &path_index, work.as_ref()), &SvgOptions::default());
        assert!(!picture.contains("NaN") && !picture.contains("inf"));
    }
}

/// Setups to hold programs against: nothing named, a blank alone, everything.
fn at_machine() -> [Setup; 3] {
    [
        "{}",
        r#"{"stock": {"diameter": 80, "bore": 10, "length": 90, "face": 1}}"#,
        r#"{"stock": {"diameter": 80, "length": 90, "grip": 20}, "tailstock": {"z": 5, "diameter": 20},
            "tools": {"T0101": {"type": "turning", "insert": "DNMG150604"}, "T0202": {"type": "boring", "shank": 8},
                      "T0303": {"type": "grooving", "reach": 10}, "T0404": {"type": "threading", "noseRadius": 0.1}},
            "machine": {"rapidX": 5000, "rapidZ": 8000, "travel": {"xMin": -50, "xMax": 300}}}"#,
    ]
    .map(|json| Setup::from_json(json).expect("a setup"))
}

/// Pieces that programs are made of, good and bad.
fn piece() -> impl Strategy<Value = String> {
    let codes =
        "(G0|G00|G1|G2|G3|G4|G20|G21|G28|G32|G50|G52|G54|G59|G90|G92|G94|G96|G97|G98|G99|G71|G33|M3|M30)";
    prop_oneof![
        6 => codes,
        8 => "[XZUWRIKFSTPQJL] ?-?[0-9]{0,3}\\.?[0-9]{0,4}",
        1 => "[ \\t;\\n\r%/(),.:#\\[\\]=*A-Z−；（）外0-9-]{1,3}",
        1 => "(O0002|N10|\\(a\\)|;|\n|\r\n|#1=2|IF\\[#1 EQ 2\\]GOTO 10| )",
        2 => "\n",
    ]
}

/// A number as a program writes it: plain, by a variable or an expression, or far too large.
fn number() -> impl Strategy<Value = String> {
    prop_oneof![
        8 => "-?[0-9]{1,2}(\\.[0-9]{0,3})?",
        2 => prop::sample::select(vec!["#1", "-#2", "[#1+1]", "#5041", "#5042", "[#2*#1]", "#100", "[#3-1.5]"])
            .prop_map(String::from),
        1 => prop::sample::select(vec!["0", "0.001", "-0", "99999999", "-9999.999", "ROUND[#1/3]", "SIN[#1]"])
            .prop_map(String::from),
    ]
}

/// Some of the words whose letters are given; those that count something seldom have a sign.
fn words(letters: &'static str) -> impl Strategy<Value = String> {
    let word = (prop::sample::select(letters.chars().collect::<Vec<_>>()), number(), 1u32..900, 0u32..20);
    let written = |(letter, number, whole, rare): (char, String, u32, u32)| match letter {
        'F' => format!("F.{whole} "),
        'P' | 'Q' | 'S' | 'T' | 'L' if rare > 0 => format!("{letter}{whole} "),
        _ => format!("{letter}{number} "),
    };
    prop::collection::vec(word, 0..4).prop_map(move |words| words.into_iter().map(written).collect())
}

/// One of some codes, with some words after it.
fn coded(codes: &'static [&'static str], letters: &'static str) -> impl Strategy<Value = String> {
    (prop::sample::select(codes), words(letters)).prop_map(|(code, words)| format!("{code} {words}"))
}

/// A line of a program that uses all that can steer it.
fn line() -> impl Strategy<Value = String> {
    let paths = coded(&["G0", "G1", "G2", "G3", "", "G32"], "XYZUVWRIJKFCHA");
    let corners = coded(&["G1", ""], "XZUW").prop_flat_map(|line| {
        prop::sample::select(vec![",R1", ",C1", ",A30", "R2", "C-1", "K1"])
            .prop_map(move |corner| format!("{line}{corner}"))
    });
    let states = coded(
        &[
            "G20", "G21", "G40", "G41", "G42", "G90", "G91", "G96", "G97", "G98", "G99", "M3", "M5", "M45",
            "M46",
        ],
        "XZSFT",
    );
    let cycles = coded(&["G90", "G92", "G94", "G77", "G78", "G79", "G20", "G21", "G24"], "XZUWRFIKQ");
    let contours = prop::sample::select(vec![
        "G71 U1 R1",
        "G71 P1 Q2 U.5 W.1",
        "G72 W1 R1",
        "G72 P1 Q2",
        "G73 U2 W1 R3",
        "G73 P1 Q2",
        "G70 P1 Q2",
        "G70 P3 Q1",
        "G71 P10 Q2 D1000",
        "G76 P010060 Q50 R.1",
        "G76 X8 Z-9 P900 Q300 F1",
        "G74 R1",
        "G74 X1 Z-9 P500 Q700",
        "G75 X1 Z-9 P500 Q700",
    ]);
    let holes = coded(&["G80", "G83", "G84", "G85", "G87", "G88", "G89", "G81", "G82"], "XZUWCHRQPKF");
    let planes = prop::sample::select(vec![
        "G12.1", "G13.1", "G112", "G113", "G7.1 C20", "G07.1 C0", "G107 C#1", "G18", "G19", "G17",
    ]);
    let places = coded(
        &[
            "G28", "G30", "G29", "G27", "G53", "G54", "G55", "G54.1 P3", "G50", "G52", "G92", "G4", "T0101",
            "T0303",
        ],
        "XZUWPSCH",
    );
    let data = coded(&["G10 L2", "G10 L20", "G10", "G10 L10", "G10 L11", "G10 L50", "G11"], "PXZUWRQC");
    let statements = (1u32..=4, number(), 0u32..6, 1u32..=3).prop_map(|(variable, value, form, number)| {
        let condition = ["EQ", "NE", "GT", "GE", "LT", "LE"][(variable as usize + form as usize) % 6];
        match form {
            0 => format!("#{variable}={value}"),
            1 => format!("#{variable}=#{variable}+1"),
            2 => format!("IF[#{variable} {condition} {value}]GOTO {number}"),
            3 => format!("IF[#{variable} {condition} {value}]THEN G1 X{value} F1"),
            4 => format!("WHILE[#{variable} {condition} {value}]DO{number}"),
            _ => format!("#[{variable}+#{number}]=-{value}"),
        }
    });
    let steering = prop::sample::select(vec![
        "END1",
        "END2",
        "END3",
        "DO1",
        "DO2",
        "GOTO 1",
        "GOTO 2",
        "GOTO #1",
        "GOTO 10",
        "M98 P2",
        "M98 P3 L3",
        "M98 P30002",
        "M98 P2 Q1 L2",
        "M97 P1",
        "M99",
        "M99 P2",
        "M98 P#1",
        "G65 P2 A1 B#1 I3 I4",
        "G65 P3 L2 X-2",
        "G66 P2 A2",
        "G66 P3 L2",
        "G67",
        "O2",
        "O3",
        "O0",
        "O4",
        "M30",
        "M2",
        "%",
        "#3000=1(STOP)",
        "#3006=1",
        "#2001=1",
        "#5221=#5041",
        "#7001=2",
        "#1000=#1000+1",
        "#500=#0",
        "(A(B)",
        ";",
        "IF[#1EQ#0]GOTO2",
        "M1",
    ]);
    let line = prop_oneof![
        8 => paths,
        2 => corners,
        3 => states,
        2 => cycles,
        2 => contours.prop_map(String::from),
        3 => holes,
        2 => planes.prop_map(String::from),
        2 => places,
        1 => data,
        5 => statements,
        5 => steering.prop_map(String::from),
        1 => piece(),
    ];
    let plain = "(G0?[01] ?)?(X-?[0-9]{1,2}(\\.[0-9]{0,4})? ?)?(Z-?[0-9]{1,2}(\\.[0-9]{0,4})? ?)?";
    let line = prop_oneof![2 => line, 1 => plain];
    let head = prop_oneof![
        6 => Just(""),
        2 => prop::sample::select(vec!["N1 ", "N2 ", "N3 ", "N10 "]),
        1 => prop::sample::select(vec!["/", "/2 ", "/N1 "]),
    ];
    (head, line).prop_map(|(head, line)| format!("{head}{line}\n"))
}

/// Lines, alone or within what gives them a meaning: a loop, a contour, a plane.
fn part() -> impl Strategy<Value = String> {
    let lines = |most: usize| prop::collection::vec(line(), 0..most).prop_map(|lines| lines.concat());
    let around = prop::sample::select(vec![
        ("#1=0\nWHILE[#1 LT 5]DO1\n", "#1=#1+1\nEND1\n"),
        ("#2=9\nWHILE[#2 GT 0]DO2\n", "#2=#2-1\nIF[#2 EQ 3]GOTO 3\nEND2\nN3\n"),
        ("#3=1\nN3 #3=#3+1\n", "IF[#3 LT 4]GOTO 3\n"),
        ("G40 G0 X30 Z2\nG71 U1 R.5\nG71 P1 Q2 U.4 W.1\nN1 G0 X10\nG1 Z-5\n", "N2 X30\nG70 P1 Q2\n"),
        ("G40 G0 X30 Z2\nG72 W1 R.5\nG72 P1 Q2\nN1 G0 Z-9\nG1 X20\n", "N2 Z2\n"),
        ("G40 G0 X30 Z2\nG73 U2 W1 R2\nG73 P1 Q2\nN1 G0 X10\n", "N2 G1 X30\n"),
        ("M5 M45\nG98\nG12.1\nG1 F100\n", "G13.1\n"),
        ("G12.1\nG42 X10 C3 F9\n", "G40\nG13.1\n"),
        ("M45 G98\nG1 F9\nG7.1 C20\nC90\n", "G7.1 C0\n"),
        ("M45 G98\nG17\nG1 Y3 F9\n", "G18\nG0 Y0\n"),
        ("T0303\nM45 G98\nG17 G41\nG1 X10 Y3 F9\n", "G40\nG0 X50 Y0\nG18\n"),
        ("G19\nG42 G1 Y3 Z-3 F9\n", "G40 Y0\n"),
        ("G66 P2 A2 B3\nG0 X3\n", "G67\n"),
        ("G0 X0 Z5\nG83 Z-10 R-3 Q3000 F.1\n", "G80\n"),
        ("M45\nG0 X40 Z-5\nG87 X20 R-2 Q4000 C0 F.1\nC90\n", "G80\n"),
        ("T0101\nG42 G0 X20 Z1\nG1 Z-3 F.1\n", "G40 G0 X50\n"),
        ("G91\n", "G90\n"),
        ("G10 L50\n", "G11\n"),
    ]);
    prop_oneof![
        lines(5),
        (around, lines(4)).prop_map(|((before, behind), lines)| format!("{before}{lines}{behind}")),
    ]
}

/// A program of several O programs.
fn program() -> impl Strategy<Value = String> {
    let parts = |most: usize| prop::collection::vec(part(), 1..most).prop_map(|parts| parts.concat());
    (parts(5), parts(3), parts(3), any::<bool>()).prop_map(|(main, second, third, plain)| {
        let end = if plain { "M30\n" } else { "" };
        format!("O1\nM3 S500 F.2\n{main}{end}O2\n{second}M99\nO3\n{third}M99\n")
    })
}

/// A setup of any control and system.
fn any_setup() -> impl Strategy<Value = Setup> {
    let dialect = (
        prop::sample::select(vec!["fanuc", "fanuc", "gsk", "forum"]),
        prop::sample::select(vec!["A", "B", "C"]),
        prop::sample::select(vec![r#""decimal": "leastIncrement","#, r#""strict": true,"#, "", ""]),
    );
    let rest = prop::sample::select(vec![
        r#""blockSkip": [1]"#,
        r#""program": 2"#,
        r#""initial": {"x": 20, "z": 2}"#,
        r#""stock": {"diameter": 50, "length": 80}"#,
        r#""machine": {"yAxis": true}"#,
        r#""stock": {"diameter": 50, "length": 80}, "machine": {"yAxis": true}"#,
    ]);
    (dialect, rest).prop_map(|((control, system, more), rest)| {
        let dialect =
            format!(r#"{{"control": "{control}", {more} "gSystem": "{system}", "recognise": false}}"#);
        let tools = r#"{"T0101": {"noseRadius": 0.8, "tip": 3}, "T0303": {"toolRadius": 4}}"#;
        Setup::from_json(&format!(r#"{{"dialect": {dialect}, "tools": {tools}, {rest}}}"#)).expect("setup")
    })
}

/// Bounds that are soon met.
const SMALL: Limits = Limits {
    text: 10_000,
    motions: 600,
    moves_per_cycle: 200,
    cycle_work: 900,
    repeated_blocks: 300,
    repeated_text: 6_000,
    rounds: 150,
    macro_steps: 200,
    call_depth: 4,
    macro_depth: 3,
    messages: 30,
    part_motions: 1000,
    part_corners: 1000,
    compared_blocks: 20_000,
    stride: 7,
};

/// Runs a program within small bounds, `slice` blocks at a time, and checks that it ends.
fn run_small(text: &str, setup: &Setup, slice: usize) -> Run {
    to_its_end(begin_small(text, setup), text, slice)
}

fn begin_small(text: &str, setup: &Setup) -> Run {
    Run::new(text.as_bytes().to_vec(), Setup { limits: SMALL, ..setup.clone() })
}

fn to_its_end(mut run: Run, text: &str, slice: usize) -> Run {
    // Each block is read straight through, and once more for the mistakes of what was jumped over; both again
    // when the program that was begun turns out to be a subprogram.
    let most = 2 * (SMALL.repeated_blocks + 2 * text.len() + 4);
    let mut slices = most / slice + 1;
    while !run.advance(slice) {
        slices -= 1;
        assert!(slices > 0, "never ends");
    }
    run
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(512))]

    #[test]
    fn no_macros_calls_and_cycles_break_anything(text in program(), setup in any_setup(), slice in 1usize..9) {
        let whole = run_small(&text, &setup, usize::MAX);
        let state = whole.state();
        prop_assert!([state.position.x, state.position.z, state.c].iter().all(|place| place.is_finite()));
        // Where each block is kept, lines are not carried out together.
        let kept = to_its_end(begin_small(&text, &setup).traced(), &text, usize::MAX);
        // Nor are snapshots made, from which on errors are counted anew.
        let incomplete = kept.state().incomplete;
        prop_assert_eq!(&State { incomplete, ..state.clone() }, kept.state());
        prop_assert_eq!(whole.blocks(), kept.blocks());
        let (state, sliced) = (state.clone(), run_small(&text, &setup, slice));
        let rule = whole.decided_rule();
        prop_assert_eq!(&state, sliced.state());
        let (whole, sliced, kept) = (whole.into_analysis(), sliced.into_analysis(), kept.into_analysis());
        prop_assert!(whole.motions.iter().eq(kept.motions.iter()));
        let place = |motions: &Motions, index| (motions.span(index), motions.line(index));
        let places = |motions: &Motions| (0..motions.len()).map(|index| place(motions, index)).collect::<Vec<_>>();
        prop_assert_eq!(places(&whole.motions), places(&kept.motions));
        prop_assert_eq!(&whole.diagnostics, &kept.diagnostics);
        prop_assert_eq!(&whole.motions, &sliced.motions);
        prop_assert_eq!(&whole.diagnostics, &sliced.diagnostics);
        // Without its middle, and then with it again, it is the same program.
        let (start, end) = (text.len() / 3, text.len() / 2);
        let without = [&text.as_bytes()[..start], &text.as_bytes()[end..]].concat();
        let small = Setup { limits: SMALL, ..setup.clone() };
        // An edit decides nothing anew.
        let mut changed = match rule {
            Some(rule) => Run::with_decimal_rule(without, small, rule),
            None => Run::new(without, small),
        };
        while !changed.advance(usize::MAX) {}
        changed.edit(TextEdit { start, end: start, insert: text.as_bytes()[start..end].to_vec() });
        while !changed.advance(usize::MAX) {}
        let changed = changed.into_analysis();
        prop_assert!(whole.motions.iter().eq(changed.motions.iter()));
        prop_assert_eq!(&whole.diagnostics, &changed.diagnostics);
        prop_assert!(whole.motions.len() <= SMALL.motions);
        prop_assert!(whole.diagnostics.len() <= SMALL.messages + 3);
        check_analysis(text.as_bytes(), &whole);
        // Expanded, it can be read and run again.
        let plain = expand(text.as_bytes(), &Setup { limits: SMALL, ..setup.clone() });
        let _ = run_small(&plain, &setup, usize::MAX);
    }

    #[test]
    fn no_bytes_break_anything(text in prop::collection::vec(any::<u8>(), 0..400)) {
        check(&text);
    }

    #[test]
    fn no_program_breaks_anything(pieces in prop::collection::vec(piece(), 0..60)) {
        check(pieces.concat().as_bytes());
    }

    /// Slices of a run make no difference.
    #[test]
    fn a_run_in_slices_is_the_same_run(pieces in prop::collection::vec(piece(), 0..60), slice in 1usize..5) {
        let text = pieces.concat().into_bytes();
        let whole = analyze(&text, &Setup::default());
        let mut run = Run::new(text, Setup::default());
        while !run.advance(slice) {}
        let sliced = run.into_analysis();
        prop_assert_eq!(whole.motions, sliced.motions);
        prop_assert_eq!(whole.diagnostics, sliced.diagnostics);
    }

    /// G90, G92 and G94 end where they began, and turn over with their program.
    #[test]
    fn mirrored_cycles_make_mirrored_motions(
        code in prop::sample::select(vec![90, 92, 94]),
        start in (20i32..200, -20i32..20),
        end in (20i32..200, -100i32..-1),
        taper in -9i32..9,
    ) {
        let program = |sign: i32| {
            let taper = if code == 94 { sign * taper } else { taper };
            format!(
                "M3 S500\nG0 X{} Z{}\nG{code} X{} Z{} R{taper} F0.2\nX{}\nG0 X300",
                start.0, sign * start.1, end.0, sign * end.1, end.0 - 2,
            )
        };
        let setup = Setup::from_json(r#"{"dialect": {"threadChamfer": 10}}"#).unwrap();
        let run = |text: String| -> Vec<Motion> { analyze(text.as_bytes(), &setup).motions.iter().collect() };
        let (plain, mirrored) = (run(program(1)), run(program(-1)));
        prop_assert_eq!(plain.len(), mirrored.len());
        // The first motion comes from the start point of the setup, which is not mirrored.
        for (plain, mirrored) in plain.iter().zip(&mirrored).skip(1) {
            prop_assert_eq!(plain.kind, mirrored.kind);
            prop_assert!((plain.to.x - mirrored.to.x).abs() < 1e-9 && (plain.to.z + mirrored.to.z).abs() < 1e-9);
        }
        let home = plain[0].to;
        let returns: Vec<&Motion> = plain.iter().filter(|m| m.cycle.is_some()).collect();
        if let Some(last) = returns.last() {
            prop_assert!(last.to.is_same(home));
        }
    }

    /// The arc drawn meets the programmed end, whichever way its centre is given.
    #[test]
    fn arcs_meet_their_end(end in (10i32..100, -50i32..50), radius in 60i32..200, turn in 2..=3) {
        let text = format!("M3 S1\nG0 X40 Z0\nG{turn} X{} Z{} R{radius} F0.1", end.0, end.1);
        let analysis = analyze(text.as_bytes(), &Setup::default());
        for motion in analysis.motions.iter() {
            if let Some(arc) = motion.arc() {
                prop_assert!((arc.radius() - f64::from(radius)).abs() < 1e-6);
                prop_assert!(arc.at(1.0).distance(arc.end) < 1e-6);
                prop_assert!(arc.sweep().abs() <= std::f64::consts::PI + 1e-9);
                prop_assert_eq!(arc.sweep() < 0.0, motion.kind == MotionKind::ArcClockwise);
            }
        }
    }
}

/// Bad input is answered at once.
#[test]
fn hostile_texts_are_answered_at_once() {
    // Every byte at a length that shows a square law; some at the full 5 MB.
    let (short, five) = (50 << 10, 5 << 20);
    let mut texts: Vec<(String, Vec<u8>)> =
        (0..=255u8).map(|byte| (format!("50 kB of {byte:#04x}"), vec![byte; short])).collect();
    texts.extend(b"X(0\n ;\xff".iter().map(|&byte| (format!("5 MB of {byte:#04x}"), vec![byte; five])));
    for unit in [
        "X1", "G1X1Z1\n", "(", "()", "G0 X1;", "X1 ", "O1\n", "N1", "#1=", "[", "Z,", "GO", "−", "%\n",
        "\r\n",
    ] {
        texts.push((format!("50 kB of {unit:?}"), unit.repeat(short / unit.len()).into_bytes()));
    }
    for (name, text) in texts {
        let begun = Instant::now();
        let analysis = analyze(&text, &Setup::default());
        let took = begun.elapsed();
        assert!(took < Duration::from_secs(10), "{name}: {took:?}");
        assert!(!analysis.diagnostics.is_empty() || !analysis.motions.is_empty(), "{name}: nothing is said");
    }
}

#[test]
fn every_bound_has_its_message() {
    let codes = |text: &str, limits: Limits| -> Vec<&'static str> {
        let mut run = Run::new(text.as_bytes().to_vec(), Setup { limits, ..Setup::default() });
        while !run.advance(usize::MAX) {}
        run.diagnostics().iter().map(|diagnostic| diagnostic.message.code()).collect()
    };
    let limits = Limits::default();
    assert!(codes(&"X1".repeat(100), limits).contains(&"E-BLOCK-TOO-LONG"));
    assert!(codes("G0 X1", Limits { text: 3, ..limits }).contains(&"E-TEXT-TOO-LONG"));
    assert!(codes("G0 X1\nX2\nX3", Limits { motions: 2, ..limits }).contains(&"E-TOO-MANY-MOTIONS"));
    assert!(codes("X\nX\nX\nX\n", Limits { messages: 2, ..limits }).contains(&"I-MORE"));
    assert!(codes("", limits).contains(&"I-EMPTY"));
    let cycle = "F1\nG73 U1 R9\nG73 P1 Q2\nN1 G0 X1\nN2 X2\nG70 P1 Q2\nG70 P1 Q2";
    assert!(codes(cycle, Limits { moves_per_cycle: 8, ..limits }).contains(&"E-TOO-MANY-PASSES"));
    assert!(codes(cycle, Limits { moves_per_cycle: 1, ..limits }).contains(&"E-TOO-MANY-PASSES"));
    assert!(codes(cycle, Limits { cycle_work: 3, ..limits }).contains(&"E-TOO-MUCH-WORK"));
    assert!(!codes(cycle, limits).iter().any(|code| code.starts_with("E-TOO")));
    let mut run = Run::new(b"G0 X1\nX2".to_vec(), Setup::default());
    run.advance(1);
    run.stop(10.0);
    assert!(run.diagnostics().iter().any(|diagnostic| diagnostic.message.code() == "E-STOPPED"));
}
