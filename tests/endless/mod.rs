//! Programs that would take for ever, for the native and the wasm tests: cycles with an amount that is far too small,
//! loops and calls without an end, and texts that are long and of no sense.

/// Longest time a page may stand still, seconds.
pub const MOST_SECONDS: f64 = 1.0;

/// A program with one move before its cycle, which is not carried out, and what must be said of it.
pub struct Endless {
    /// What it is.
    pub name: &'static str,
    /// Its setup.
    pub setup: &'static str,
    /// Its text.
    pub text: String,
    /// Code of the message.
    pub code: &'static str,
}

/// All of them.
pub fn endless() -> Vec<Endless> {
    const CONTOUR: &str = "N1 G0 X0\nN2 G1 X1000 Z-500\nM30\n";
    let microns = r#"{"dialect": {"pqUnit": "um"}}"#;
    let case = |name, setup, text: &str, code| Endless {
        name,
        setup,
        text: format!("M3 S500\nG99 F0.2\nG0 X1000 Z2\n{text}"),
        code,
    };
    let passes = "E-TOO-MANY-PASSES";
    vec![
        // Digits below a thousandth do not count: the depth is zero (PS0062).
        case("G71 U0.0001", "{}", &format!("G71 U0.0001 R0.5\nG71 P1 Q2 U0 W0\n{CONTOUR}"), "W-G71-U-SIGN"),
        case("G71 U0.001", "{}", &format!("G71 U0.001 R0.5\nG71 P1 Q2 U0 W0\n{CONTOUR}"), passes),
        case(
            "G71 U0.0001 in inches",
            "{}",
            "G20\nG71 U0.0001 R0.5\nG71 P1 Q2 U0 W0\nN1 G0 X0\nN2 G1 X39.37 Z-20\nM30\n",
            passes,
        ),
        case("G71 D1 in one block", "{}", &format!("G71 P1 Q2 U0 W0 D1\n{CONTOUR}"), passes),
        case(
            "G71 U0.001 into a pocket",
            "{}",
            "G71 U0.001 R0.5\nG71 P1 Q2 U0 W0\nN1 G0 X990 W0\nG1 X0 Z-200\nN2 X1000 Z-500\nM30\n",
            passes,
        ),
        case("G72 W0.001", "{}", "G72 W0.001 R0.5\nG72 P1 Q2 U0 W0\nN1 G0 Z-500\nN2 G1 X0 Z0\nM30\n", passes),
        case("G76 Q1", microns, "G76 P010060 Q0 R0\nG76 X900 Z-100 P50000 Q1 F2\nM30\n", passes),
        case("G76 Q0.001", "{}", "G76 P010060 Q0 R0\nG76 X900 Z-100 P50. Q0.001 F2\nM30\n", passes),
        case("G73 R99999999", "{}", &format!("G73 U5 W2 R99999999\nG73 P1 Q2 U1 W0.5\n{CONTOUR}"), passes),
        case("G74 Q1", microns, "G74 R0.5\nG74 Z-500 Q1\nM30\n", passes),
        case("G75 P1 Q1", microns, "G75 R0.5\nG75 X900 Z-100 P1 Q1\nM30\n", passes),
    ]
}

/// A program that never ends or is of no sense, and what must be said of it.
pub struct Hostile {
    /// What it is.
    pub name: &'static str,
    /// Its setup.
    pub setup: &'static str,
    /// Its text.
    pub text: String,
    /// Code of the message.
    pub code: &'static str,
    /// Line of the message, from 1.
    pub line: u32,
}

/// About a megabyte of a text again and again.
fn megabyte(of: &str) -> String {
    of.repeat((1 << 20) / of.len())
}

/// A text for each of the numbers from 1 until it is about a megabyte.
fn numbered(of: impl Fn(usize) -> String) -> String {
    let mut text = String::new();
    for number in 1.. {
        if text.len() >= 1 << 20 {
            break;
        }
        text += &of(number);
    }
    text
}

/// All of them.
pub fn hostile() -> Vec<Hostile> {
    let mut all = never_ending();
    all.extend(repeated_work());
    all.extend(deep_expressions());
    all.extend(long_texts());
    all
}

fn case(name: &'static str, text: impl Into<String>, code: &'static str, line: u32) -> Hostile {
    Hostile { name, setup: "{}", text: text.into(), code, line }
}

/// Jumps, loops and calls without an end.
fn never_ending() -> Vec<Hostile> {
    const REPEATS: &str = "W-ENDLESS";
    let moves = "G1 U1 W-1\nU-1 W1\n".repeat(20_000);
    vec![
        case("M99 in the main program", "O1\nG0 X1\nM99\n", "W-ENDLESS", 3),
        case("M99 with a counter", "O1\n#1=#1+1\nIF[#1 EQ 0]GOTO 9\nM99\nN9 M30\n", REPEATS, 4),
        case("M99 with a system counter", "O1\n#1000=#1000+1\nM99\n", REPEATS, 3),
        case("M99 P to itself", "O1\nG0 X1\nN5 M99 P5\n", REPEATS, 3),
        case("M99 P to the head", "O1\nN1 G0 X1\nG0 Z1\nM99 P1\n", REPEATS, 4),
        case("GOTO to itself", "O1\nN1 GOTO 1\nM30\n", REPEATS, 2),
        case("GOTO by a variable", "O1\n#1=7\nN7 GOTO #1\nM30\n", REPEATS, 3),
        case("GOTO over a long body", format!("O1\nF1 M3 S1\nN1\n{moves}GOTO 1\nM30\n"), REPEATS, 40_004),
        case("IF GOTO to itself", "O1\nN1 IF[1 EQ 1]GOTO 1\nM30\n", REPEATS, 2),
        case("GOTO out of WHILE", "O1\nN1 WHILE[1 EQ 1]DO1\nGOTO 1\nEND1\nM30\n", REPEATS, 3),
        case("an empty WHILE", "O1\nWHILE[1 EQ 1]DO1\nEND1\nM30\n", REPEATS, 3),
        case("DO without WHILE", "O1\nDO1\nG0 U0.001\nEND1\nM30\n", REPEATS, 4),
        case(
            "three long WHILE one within the other",
            "O1\n#1=0\nWHILE[#1 LT 99999]DO1\n#2=0\nWHILE[#2 LT 99999]DO2\n#3=0\nWHILE[#3 LT 99999]DO3\n#3=#3+1\nEND3\n#2=#2+1\nEND2\n#1=#1+1\nEND1\nM30\n",
            REPEATS,
            9,
        ),
        case("M98 of itself", "O1\nM98 P1\nM30\n", "PS0077", 2),
        case(
            "two programs that call each other",
            "O1\nM98 P2\nM30\nO2\nM98 P3\nM99\nO3\nM98 P2\nM99\n",
            "PS0077",
            8,
        ),
        case("M97 of itself", "O1\nN1 M97 P1\nM30\n", "PS0077", 2),
        case(
            "M98 L9999 of M98 L9999",
            "O1\nM98 P2 L9999\nM30\nO2\nM98 P3 L9999\nM99\nO3\nM98 P4 L9999\nM99\nO4\nM99\n",
            REPEATS,
            8,
        ),
        case(
            "M98 of 9999 rounds in P",
            "O1\nM98 P99990002\nM30\nO2\nM98 P99990003\nM99\nO3\nM99\n",
            REPEATS,
            5,
        ),
        case("G65 of itself", "O1\nG65 P1 A1\nM30\n", "PS0122", 2),
        case(
            "two macros that call each other",
            "O1\nG65 P2\nM30\nO2\nG65 P3 A#1\nM99\nO3\nG65 P2 A#1\nM99\n",
            "PS0122",
            5,
        ),
        case("G65 L9999999", "O1\nG65 P2 L9999999\nM30\nO2\nM99\n", REPEATS, 2),
        case("G65 and M98 in turn", "O1\nG65 P2\nM30\nO2\nM98 P3\nM99\nO3\nG65 P2\nM99\n", "PS0122", 8),
        case(
            "G66 with a macro that moves",
            format!("O1\nG66 P2 L9999\n{}M30\nO2\nG0 U1\nU-1\nM99\n", "G0 X1\nX2\n".repeat(500)),
            REPEATS,
            28,
        ),
        case("jumps to and fro", "O1\nN1 GOTO 3\nN2 GOTO 1\nN3 GOTO 2\nM30\n", REPEATS, 3),
        case("an alarm in a loop", "O1\nN1 #3000=1(STOP)\nGOTO 1\n", "E-MACRO-ALARM", 2),
        case("a fault in a loop", "O1\nN1 G0 X[1/0]\nGOTO 1\n", REPEATS, 3),
        case(
            "G71 in a loop",
            "O1\nM3 S1\nG0 X50 Z2 F.1\nN9 G71 U.1 R.1\nG71 P1 Q2 U0 W0\nN1 G0 X1\nN2 G1 X49 Z-9\nGOTO 9\n",
            "E-TOO-MANY-MOTIONS",
            5,
        ),
    ]
}

/// Much work for each of many rounds.
fn repeated_work() -> Vec<Hostile> {
    let repeats = "W-ENDLESS";
    let motions = "E-TOO-MANY-MOTIONS";
    let cycle =
        |cycle: &str| format!("O1\nM3 S500\nG0 X100 Z2 F.1\nM98 P2 L9999999\nM30\nO2\n{cycle}\nM99\n");
    let expression = |round: &str| format!("O1\nN1 #1=1{}\n{round}\nM30\n", megabyte("+1"));
    let writes =
        |body: &str, rounds: u32| format!("O1\n#1=0\nWHILE[#1 LT {rounds}]DO1\n{body}\n#1=#1+1\nEND1\nM30\n");
    vec![
        case("9 999 999 rounds of G90", cycle("G90 X90 Z-90"), repeats, 4),
        case(
            "9 999 999 rounds of G71",
            cycle("G71 U1 R1\nG71 P1 Q2 U0 W0\nN1 G0 X1\nN2 G1 X99 Z-9"),
            motions,
            8,
        ),
        case(
            "9 999 999 rounds of G76",
            cycle("G76 P010060 Q50 R.05\nG76 X90 Z-90 P1000 Q100 F2"),
            motions,
            8,
        ),
        case("9 999 999 rounds of G83 K9999", cycle("G83 Z-9 K9999 C0 H1 Q1000 F.1"), motions, 7),
        case(
            "9 999 999 rounds of a refused G71",
            cycle("G71 U1 R1\nG71 P1 Q2 U0 W0\nN1 G0 X1\nG1 Z-9\nM98 P2\nN2 G1 X99 Z-9"),
            repeats,
            4,
        ),
        case("an expression of a megabyte again and again", expression("GOTO 1"), repeats, 3),
        case(
            "an address of a megabyte again and again",
            format!("O1\nN1 X[1{}]\nGOTO 1\nM30\n", megabyte("+1")),
            repeats,
            3,
        ),
        case(
            "a comment of a megabyte again and again",
            format!("O1\nN1 ({})\nGOTO 1\nM30\n", megabyte("a")),
            repeats,
            3,
        ),
        case(
            "a broken block of a megabyte again and again",
            format!("O1\nN1 {}\nGOTO 1\nM30\n", megabyte("X-")),
            repeats,
            3,
        ),
        case(
            "WHILE over a megabyte again and again",
            format!("O1\nN1 WHILE[0 EQ 1]DO1\n#1={}\nEND1\nGOTO 1\nM30\n", megabyte("+1")),
            repeats,
            5,
        ),
        case(
            "a condition of a megabyte",
            format!("O1\nWHILE[1 EQ 1{}]DO1\nEND1\nM30\n", megabyte(" AND 1 EQ 1")),
            repeats,
            3,
        ),
        case(
            "kept variables written again and again",
            writes("#[1000+#1-FIX[#1/1000]*1000]=#1", 9_999_999),
            repeats,
            6,
        ),
        case("offsets written again and again", writes("#[2001+#1-FIX[#1/64]*64]=#1", 9_999_999), repeats, 6),
        case(
            "frames written again and again",
            writes("#[5221+20*[#1-FIX[#1/6]*6]]=#1", 9_999_999),
            repeats,
            6,
        ),
        case(
            "long offsets written again and again",
            writes("#[10001+#1-FIX[#1/999]*999]=#1", 9_999_999),
            repeats,
            6,
        ),
        case(
            "long frames written again and again",
            writes("#[7001+20*[#1-FIX[#1/300]*300]]=#1", 9_999_999),
            repeats,
            6,
        ),
        case(
            "unknown variables written again and again",
            writes("#[20000+#1]=#1", 9_999_999),
            "W-MACRO-SYSTEM",
            4,
        ),
        case("G10 again and again", writes("G10 L20 P[1+#1-FIX[#1/300]*300] X#1", 9_999_999), repeats, 6),
        case(
            "kept variables at each M99",
            format!(
                "O1\n{}N9 #1000=#1000+1\nM99 \n",
                "IF[#1000 GT 0]GOTO 9\n".to_owned()
                    + &(1001..1900).map(|n| format!("#{n}=1\n")).collect::<String>()
            ),
            repeats,
            903,
        ),
        case("common variables at each M99", "O1\n#500=#500+1\nM99\n", repeats, 3),
    ]
}

/// Expressions of a megabyte.
fn deep_expressions() -> Vec<Hostile> {
    let statement = |of: &str| format!("O1\n#1={}\nM30\n", megabyte(of));
    let address = |of: &str| format!("O1\nG0 X{}\nM30\n", megabyte(of));
    vec![
        case("#[#[#[", format!("O1\n{}\nM30\n", megabyte("#[")), "PS0118", 2),
        case("[[[[", statement("["), "PS0118", 2),
        case("X[[[[", address("["), "PS0118", 2),
        case("SIN[SIN[", statement("SIN["), "PS0118", 2),
        case("XSIN[SIN[", address("SIN["), "PS0118", 2),
        case("X#[#[", address("#["), "PS0118", 2),
        case("-----#1", format!("O1\n#1={}#1 2\nM30\n", megabyte("-")), "PS0114", 2),
        case("X-----#1", format!("O1\nG0 X{}[#1 2]\nM30\n", megabyte("-")), "PS0114", 2),
        case("X- X- X-", address("- X"), "PS0005", 2),
        case("IF THEN IF THEN", format!("O1\n{}\nM30\n", megabyte("IF[1EQ1]THEN ")), "PS0125", 2),
        case("IF IF IF", format!("O1\n{}\nM30\n", megabyte("IF")), "PS0125", 2),
        case("#1=1#1=1", format!("O1\n{}\nM30\n", megabyte("#1=1")), "PS0125", 2),
        case("#1=#1=", format!("O1\n{}\nM30\n", megabyte("#1=")), "PS0125", 2),
        case("]]]]", statement("]"), "PS0114", 2),
        case("1 EQ 1 EQ", format!("O1\nIF[{}1]GOTO 1\nM30\n", megabyte("1 EQ ")), "PS0114", 2),
        case("1 EQ 1 AND", format!("O1\nIF[{}1]GOTO 1\nM30\n", megabyte("1 AND ")), "PS0114", 2),
        case("1 EQ 1 OR [", format!("O1\nIF[1 EQ 1{}]GOTO 1\nM30\n", megabyte(" OR [1]")), "PS0128", 2),
        case("ATAN[1]/ATAN[1]/", statement("ATAN[1]/"), "PS0114", 2),
        case("digits", statement("9"), "PS0111", 2),
        case("a number of a megabyte", address("9"), "PS0003", 2),
        case("letters", statement("A"), "PS0113", 2),
        case("comments in an expression", format!("O1\n#1={}+\nM30\n", megabyte("(A)+1")), "PS0114", 2),
        case("open comments in an expression", statement("+("), "PS0114", 2),
        case(
            "G65 with a million arguments",
            format!("O1\nG65 P2 {}\nM30\nO2\nM99\n", megabyte("A1")),
            "E-BLOCK-TOO-LONG",
            2,
        ),
        case("G65 P1 of a million digits", format!("O1\nG65 P{}\nM30\n", megabyte("1")), "PS0003", 2),
        case("GOTO of a million digits", format!("O1\nGOTO {}\nM30\n", megabyte("1")), "PS0111", 2),
        case("an alarm of a megabyte", format!("O1\n#3000=1({})\nM30\n", megabyte("A")), "E-MACRO-ALARM", 2),
    ]
}

/// Blocks of no sense, a megabyte of them.
fn long_texts() -> Vec<Hostile> {
    let text = |of: &str| format!("O1\n{}", megabyte(of));
    let found_nowhere = |of: &str| format!("O1\n{}{}", numbered(|n| format!("N{n}\n")), of.repeat(100_000));
    vec![
        case("M98P1", megabyte("M98P1\n"), "PS0076", 1),
        case("O1 M98P1", text("M98P1\n"), "PS0077", 2),
        case("N1 GOTO1", text("N1 GOTO1\n"), "W-ENDLESS", 67937),
        case("GOTO1", text("GOTO1\n"), "PS0128", 2),
        case("IF GOTO 1", text("IF[1EQ1]GOTO1\n"), "PS0128", 2),
        case("DO1", text("DO1\n"), "PS0124", 2),
        case("END1", text("END1\n"), "PS0126", 2),
        case("WHILE DO1 without END", text("WHILE[0EQ1]DO1\n"), "PS0124", 2),
        case(
            "WHILE DO1, DO2, DO3 without END",
            text("WHILE[0EQ1]DO1\nWHILE[0EQ1]DO2\nWHILE[0EQ1]DO3\n"),
            "PS0124",
            2,
        ),
        case("WHILE DO1 DO1", text("WHILE[0EQ1]DO1 DO1\n"), "PS0127", 2),
        case("O1", megabyte("O1\n"), "W-DUP-O", 2),
        case("O1 O2 O3", numbered(|n| format!("O{n}\n")), "I-EMPTY", 1),
        case("O1 X1 O2 X1", numbered(|n| format!("O{n}\nX1\n")), "I-NOT-RUN", 3),
        case("O1 M98P1 O2 M98P1", numbered(|n| format!("O{n} M98 P1\n")), "PS0077", 1),
        case("O1 M98P2 O2 M98P3", numbered(|n| format!("O{n} M98 P{}\n", n + 1)), "PS0077", 11),
        case("O1 M99 O2 M98P1", numbered(|n| format!("O{n} M98 P1 M99\n")), "I-NOT-RUN", 2),
        case(
            "O1 M99 and many that call it",
            format!("O1\nM99\n{}", numbered(|n| format!("O{} M98 P1\n", n + 1))),
            "W-NO-END",
            4,
        ),
        case(
            "a loop of calls among a megabyte of programs",
            format!(
                "O1\nN1 M98 P99999999\nGOTO 1\n{}O99999999\nM99\n",
                numbered(|n| format!("O{}\n", n + 10))
            ),
            "W-ENDLESS",
            2,
        ),
        case("G12.1", text("G12.1\n"), "E-G121-GCODE", 3),
        case("G12.1 G1 X1C1", text("G12.1\nG1 X1 C1 F1\nG13.1\n"), "W-POLAR-FEEDMODE", 3),
        case("G7.1 C1", text("G1\nG7.1 C1\nG7.1 C0\n"), "W-C-AXIS", 3),
        case("G10", text("G10 L2 P1 X1\n"), "W-NO-END", 80660),
        case(
            "G10 of all frames",
            numbered(|n| format!("G10 L20 P{} X1 Z{n}\n", n % 300 + 1)),
            "W-NO-END",
            46807,
        ),
        case("G83", text("G83 Z-1 Q1 F1\n"), "E-TOO-MANY-MOTIONS", 6657),
        case("G83 K9999", text("G83 Z-9 Q1 F1 K9999\n"), "E-TOO-MANY-MOTIONS", 2),
        case("G83 X0 K9999 with a shallow peck", text("G83 X0 Z-9 Q1 F1 K9999\n"), "E-TOO-MANY-MOTIONS", 2),
        case("G66", text("G66 P1\n"), "W-NO-END", 149797),
        case("G66 X1", text("G66 P1\nX1\nX2\n"), "W-ENDLESS", 9),
        case("G65 P2 of nothing", text("G65 P2\n"), "PS0076", 2),
        case("GOTO among many numbers", found_nowhere("GOTO 99999\n"), "W-ENDLESS", 144963),
        case("GOTO of no number among many", found_nowhere("GOTO 99999999\n"), "PS0128", 144963),
        case("slash", text("/"), "I-EMPTY", 1),
        case("slashes", text("/X1"), "E-BLOCK-TOO-LONG", 2),
        case("slash lines", text("/M98P1\n"), "PS0077", 2),
        case("X1;", text("X1;"), "W-NO-END", 2),
        case(";A", text(";AAA"), "W-TEXT-AFTER-EOB", 2),
        case("M99", text("M99\n"), "W-ENDLESS", 2),
        case("M99P1", text("M99P1\n"), "PS0128", 2),
        case("M97P1", text("M97P1\n"), "PS0128", 2),
        case("#1=#1+1", text("#1=#1+1\n"), "I-EMPTY", 1),
        case("#1=", text("#1="), "PS0125", 2),
        case("X#1", text("X#1\n"), "W-NO-END", 262145),
        case("X[#1]", text("X[#1]"), "E-BLOCK-TOO-LONG", 2),
        case("X SIN", text("X SIN[1"), "PS0114", 2),
        case("POPEN", text("POPEN"), "I-EMPTY", 1),
        case("[X1", text("[X1\n"), "I-EMPTY", 1),
        case(
            "G41 X",
            format!("O1\nG42 F1 M3 S1\n{}", megabyte("G1 U1 W-1\nG1 U-1 W-1\n")),
            "W-NO-END",
            99866,
        ),
        case("G1 A1", text("G1 A1 F1\n"), "PS0056", 2),
        case("G1 X1 ,R1", text("G1 U1 ,R1 F1\n"), "PS0051", 2),
        case("G4", text("G4 U1\n"), "W-NO-END", 174_763),
    ]
}
