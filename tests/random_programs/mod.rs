//! Random programs, correct and faulty, and setups for them.
#![cfg(not(target_arch = "wasm32"))]

use gcode_playground::limits::Limits;
use gcode_playground::setup::Setup;
use proptest::prelude::*;

/// Fragments of programs, correct and faulty.
pub fn piece() -> impl Strategy<Value = String> {
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

/// A number as in a program: plain, a variable, an expression, or far too large.
fn number() -> impl Strategy<Value = String> {
    prop_oneof![
        8 => "-?[0-9]{1,2}(\\.[0-9]{0,3})?",
        2 => prop::sample::select(vec!["#1", "-#2", "[#1+1]", "#5041", "#5042", "[#2*#1]", "#100", "[#3-1.5]"])
            .prop_map(String::from),
        1 => prop::sample::select(vec!["0", "0.001", "-0", "99999999", "-9999.999", "ROUND[#1/3]", "SIN[#1]"])
            .prop_map(String::from),
    ]
}

/// Some words with the given letters. Counts rarely have a sign.
fn words(letters: &'static str) -> impl Strategy<Value = String> {
    let word = (prop::sample::select(letters.chars().collect::<Vec<_>>()), number(), 1u32..900, 0u32..20);
    let written = |(letter, number, whole, rare): (char, String, u32, u32)| match letter {
        'F' => format!("F.{whole} "),
        'P' | 'Q' | 'S' | 'T' | 'L' if rare > 0 => format!("{letter}{whole} "),
        _ => format!("{letter}{number} "),
    };
    prop::collection::vec(word, 0..4).prop_map(move |words| words.into_iter().map(written).collect())
}

/// One of the codes, followed by some words.
fn coded(codes: &'static [&'static str], letters: &'static str) -> impl Strategy<Value = String> {
    (prop::sample::select(codes), words(letters)).prop_map(|(code, words)| format!("{code} {words}"))
}

/// A line of a program with any control flow.
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

/// Lines, alone or within a context: a loop, a contour, a plane.
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
pub fn program() -> impl Strategy<Value = String> {
    let parts = |most: usize| prop::collection::vec(part(), 1..most).prop_map(|parts| parts.concat());
    (parts(5), parts(3), parts(3), any::<bool>()).prop_map(|(main, second, third, plain)| {
        let end = if plain { "M30\n" } else { "" };
        format!("O1\nM3 S500 F.2\n{main}{end}O2\n{second}M99\nO3\n{third}M99\n")
    })
}

/// The setup with limits, so that a random program ends soon.
pub fn small(setup: &Setup) -> Setup {
    let limits =
        Limits { motions: 3000, repeated_blocks: 2000, rounds: 500, macro_steps: 2000, ..setup.limits };
    Setup { limits, ..setup.clone() }
}

/// A setup of any control and system.
pub fn any_setup() -> impl Strategy<Value = Setup> {
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
