//! A megabyte of meaningless blocks.

use super::{Hostile, case, megabyte, numbered};

/// A megabyte of meaningless blocks.
pub fn long_texts() -> Vec<Hostile> {
    let half = |of: &str| of.repeat(100_000);
    let text = |of: &str| format!("O1\n{}", megabyte(of));
    let found_nowhere = |of: &str| format!("O1\n{}{}", numbered(|n| format!("N{n}\n")), of.repeat(100_000));
    vec![
        case("M98P1", megabyte("M98P1\n"), "PS0076", 1),
        case("O1 M98P1", text("M98P1\n"), "PS0077", 2),
        case("N1 GOTO1", text("N1 GOTO1\n"), "E-ENDLESS", 67937),
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
        case("DO1 1", text("DO1 1\n"), "PS0114", 2),
        case("DO1 and as many END1", format!("O1\n{}{}", half("DO1\n"), half("END1\n")), "PS0126", 3),
        case("DO1 1 and as many END1", format!("O1\n{}{}", half("DO1 1\n"), half("END1\n")), "PS0114", 2),
        case("O1", megabyte("O1\n"), "W-DUP-O", 2),
        case(
            "text in front of a % and lines of text after it",
            format!("{}%\n{}", "foo bar baz qux\n".repeat(60), megabyte("some more words here\n")),
            "E-PLAIN-TEXT",
            62,
        ),
        case("keywords after ;", format!("O1\n{}", megabyte(";IF")), "PS0125", 2),
        case("a keyword of prose again and again", format!("O1\nG0 X1; {}", megabyte("if ")), "PS0005", 2),
        case("remarks after // in faulty blocks", text("G1 X40,5 F0.2 // feed in\n"), "E-OCR", 2),
        case("O1 O2 O3", numbered(|n| format!("O{n}\n")), "I-EMPTY", 1),
        case(
            "O1 O2 O3 and motions behind them",
            (1..75_000).map(|n| format!("O{n}\n")).collect::<String>() + &half("X1\nX2\n"),
            "W-NO-END",
            274_999,
        ),
        case("O1 X1 O2 X1", numbered(|n| format!("O{n}\nX1\n")), "I-NOT-RUN", 3),
        case("O1 M98P1 O2 M98P1", numbered(|n| format!("O{n} M98 P1\n")), "PS0077", 1),
        case("O1 M98P2 O2 M98P3", numbered(|n| format!("O{n} M98 P{}\n", n + 1)), "PS0077", 11),
        // P belongs to M99: O1 is a subprogram that comes first, and O2 is run instead.
        case("O1 M99 O2 M98P1", numbered(|n| format!("O{n} M98 P1 M99\n")), "I-NOT-RUN", 3),
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
            "E-ENDLESS",
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
        case("G66 X1", text("G66 P1\nX1\nX2\n"), "E-ENDLESS", 9),
        case("G65 P2 of nothing", text("G65 P2\n"), "PS0076", 2),
        case("GOTO among many numbers", found_nowhere("GOTO 99999\n"), "E-ENDLESS", 144963),
        case("GOTO of no number among many", found_nowhere("GOTO 99999999\n"), "PS0128", 144963),
        case("slash", text("/"), "I-EMPTY", 1),
        case("slashes", text("/X1"), "E-BLOCK-TOO-LONG", 2),
        case("slash lines", text("/M98P1\n"), "PS0077", 2),
        case("X1;", text("X1;"), "W-NO-END", 2),
        case(";text", text(";text"), "W-TEXT-AFTER-EOB", 2),
        // It may mean A44.
        case(";A", text(";AAA"), "E-PLAIN-TEXT", 2),
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
        case("G1 X1 ,R1", text("G1 U1 ,R1 F1\n"), "W-CORNER-STRAIGHT", 2),
        case("G4", text("G4 U1\n"), "W-NO-END", 174_763),
    ]
}
