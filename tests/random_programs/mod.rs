//! Random programs, good and bad, and setups for them: what a reader of programs has to take.
#![cfg(not(target_arch = "wasm32"))]

use gcode_playground::setup::Setup;
use proptest::prelude::*;

/// Pieces that programs are made of, good and bad.
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
pub fn program() -> impl Strategy<Value = String> {
    let parts = |most: usize| prop::collection::vec(part(), 1..most).prop_map(|parts| parts.concat());
    (parts(5), parts(3), parts(3), any::<bool>()).prop_map(|(main, second, third, plain)| {
        let end = if plain { "M30\n" } else { "" };
        format!("O1\nM3 S500 F.2\n{main}{end}O2\n{second}M99\nO3\n{third}M99\n")
    })
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

/// A number of a shop program: mostly with a point, mostly of a size that a lathe has.
fn length(low: i32, high: i32) -> impl Strategy<Value = String> {
    (low * 4..high * 4, 0..8).prop_map(|(quarters, form)| match form {
        0 => format!("{}", quarters / 4),
        _ => format!("{}", f64::from(quarters) / 4.0) + if quarters % 4 == 0 { "." } else { "" },
    })
}

/// Words that name a place: absolute, incremental, one axis or both.
fn place() -> impl Strategy<Value = String> {
    let x = prop_oneof![4 => length(10, 60).prop_map(|x| format!("X{x} ")), 1 => length(-8, 8).prop_map(|u| format!("U{u} "))];
    let z = prop_oneof![4 => length(-40, 5).prop_map(|z| format!("Z{z} ")), 1 => length(-6, 6).prop_map(|w| format!("W{w} "))];
    (prop::option::weighted(0.7, x), prop::option::weighted(0.7, z))
        .prop_map(|(x, z)| x.unwrap_or_default() + &z.unwrap_or_default())
}

/// A block of a shop program, or a few that belong together.
fn shop_blocks() -> impl Strategy<Value = String> {
    let choice = |from: &'static [&'static str]| prop::sample::select(from).prop_map(String::from);
    let code =
        choice(&["G00 ", "G01 ", "", "", "", "G02 ", "G03 ", "G32 ", "G90 ", "G92 ", "G94 ", "G83 ", "G85 "]);
    let more = choice(&[
        "",
        "",
        "",
        "",
        "",
        "F0.2 ",
        "F100 ",
        ",R1 ",
        ",C1 ",
        "R2 ",
        "R-1 ",
        "C1 ",
        "I2 ",
        "K-1 ",
        "I3. K-2. ",
        ",A170 ",
        "A135 ",
        "R-2 Q3000 F0.1 ",
        "C25 ",
        "H5 ",
        "R20. ",
        "F1.5 ",
        "T0202 ",
        "S900 ",
        "M08 ",
        "/ ",
        "(X1) ",
    ]);
    let plain = (code, place(), more).prop_map(|(code, place, more)| format!("{code}{place}{more}"));
    let odd = choice(&[
        "C25",
        "H1",
        "C5",
        "M45",
        "M46",
        "G28 U0",
        "G28 W0",
        "G28 U0 W0",
        "G28 H0",
        "G30 P2 U0",
        "G40",
        "G42",
        "G41",
        "G98",
        "G99",
        "G20",
        "G21",
        "G97 S600 M03",
        "G96 S120",
        "G50 S2000",
        "G50 X50. Z3.",
        "G04 X1.",
        "G04",
        "M05",
        "M03 S500",
        "M13",
        "T0101",
        "T0303",
        "G80",
        "G67",
        "G54",
        "G55",
        "G52 X1.",
        "G52 X0",
        "G53 X0 Z0",
        "G65 P2 A1. B2.",
        "M98 P2",
        "M98 P3 L2",
        "G66 P2 A1.",
        "M98 P7",
        "#1=5",
        "#2=#1+1",
        "G01 X#1 F0.1",
        "G00 X[#1*4] Z#2",
        "IF[#1 EQ 5]GOTO 9",
        "N9",
        "X",
        "IF[#1 LT 3]THEN G01 X30.",
        "#3=FOO[2]",
        "G71 U1. R.5",
        "G70 P10 Q20",
        "G29 X30.",
        "G27 X100.",
        "G18",
        "G17",
        "G10 P1 X0.1",
        "A89",
        "A150 X40.",
        "G76 P010060 Q50 R.1",
        "G76 X20. Z-20. P900 Q300 F1.5",
        "G74 R1.",
        "G74 Z-10. Q3000 F0.1",
        "G75 X30. Z-10. P500 Q700 F0.1",
        "G84 Z-20. R-2. F1.5",
        "G87 X20. R-2. Q4000 C0 F.1",
        "X3O.",
        "Z-1.5.2",
        "G01 X40 F",
        "G0l X5.",
        "X=64",
        "R5",
        "Z-",
        "G71 P50 Q60",
        "M99",
        "F0.3",
        "S800",
        "Q4000",
        "%",
    ]);
    let contour = (any::<bool>(), choice(&["G71 U1. R.5", "G72 W1. R.5", "G73 U2. W1. R2"]), place(), place(), choice(&[
        "", ",R1 ", ",C1 ", "F0.1 ", "S900 ", "R1. ", "A135 ", ", ", "X ",
    ]), 10..16u32).prop_map(|(finished, first, one, two, more, number)| {
        let cycle = &first[..3];
        let finish = if finished { format!("G70 P{number} Q{0}\n", number + 10) } else { String::new() };
        format!(
            "G00 X62. Z2.\n{first}\n{cycle} P{number} Q{0} U.4 W.1 F.3\nN{number} G00 X20.\nG01 {one}{more}\n{two}\nN{0} X60.\n{finish}",
            number + 10
        )
    });
    let compensated = (place(), place())
        .prop_map(|(one, two)| format!("G00 X62. Z2.\nG42 X40. Z1.\nG01 {one}F.2\n{two}\nG40 X64.\n"));
    let holes = place().prop_map(|place| format!("G00 X0 Z5.\nG83 Z-20. R-2. Q5000 F.1\n{place}\nG80\n"));
    prop_oneof![12 => plain, 8 => odd, 1 => contour, 1 => compensated, 1 => holes]
}

/// A program such as a shop has, with what goes wrong in one: words that do not belong together, blocks that
/// cannot be read, codes that are missing.
pub fn shop_program() -> impl Strategy<Value = String> {
    let lines = |most: usize| {
        prop::collection::vec(shop_blocks(), 0..most)
            .prop_map(|lines| lines.iter().map(|line| format!("{}\n", line.trim_end())).collect::<String>())
    };
    let head = prop::sample::select(vec![
        "T0101\nG97 S500 M03\nG00 X50. Z2. F0.2\n",
        "G21 G99 T0101\nG96 S150 M03\nG50 S2500\nG00 X60. Z5.\nG01 Z2. F0.2\n",
        "G20\nT0101\nG97 S500 M03\nG00 X2. Z1. F0.01\n",
        "T0101\nG97 S500 M13\nM45\nG98 G00 X50. Z2.\nG01 X48. F100\n",
        "T0101\nM03 S500\nG00 X50 Z2\nG90 X40 Z-20 F0.2\n",
        "",
    ]);
    (head, lines(14), lines(3), lines(3)).prop_map(|(head, main, second, third)| {
        format!("O1\n{head}{main}G00 X100. Z100.\nM30\nO2\n{second}M99\nO3\n{third}M99\n")
    })
}

/// A program with a few slips of the keys: one character is another one, or missing, or there twice.
pub fn mistyped(program: impl Strategy<Value = String>) -> impl Strategy<Value = String> {
    let slips = prop::collection::vec(
        (any::<prop::sample::Index>(), 0..3u8, prop::sample::select(b"0OXZGRC.,-# \n1(;".to_vec())),
        0..4,
    );
    (program, slips).prop_map(|(program, slips)| {
        let mut text = program.into_bytes();
        for (at, kind, other) in slips {
            let at = at.index(text.len());
            match kind {
                0 => text[at] = other,
                1 => drop(text.remove(at)),
                _ => text.insert(at, text[at]),
            }
        }
        String::from_utf8_lossy(&text).into_owned()
    })
}
