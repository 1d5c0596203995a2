//! Cycles that are expensive to calculate; about a megabyte of calls of each.

use super::{Hostile, called, case};

/// The head of a program, and a contour of zigzags that each pass crosses repeatedly.
fn zigzags(count: usize) -> String {
    let mut text = String::from("M3 S500\nG99 F.2\nG0 X200 Z2\nG71 U2 R.5\nG72 W2 R.5\nN1 G0 X100 W0\n");
    for _ in 0..count {
        text += "G1 X20 W-.01\nX90 W-.01\n";
    }
    text + "N2 X200\nG0 X200 Z2\n"
}

/// The head of a program, and a contour that only rises.
fn rising(blocks: usize) -> String {
    let mut text = String::from("M3 S500\nG99 F.2\nG0 X200 Z2\nG71 U.1 R.1\nG72 W.1 R.1\nN1 G0 X10\n");
    for _ in 0..blocks {
        text += "G1 U.005 W-.005\n";
    }
    text + "N2 X200\nG0 X200 Z2\n"
}

/// All expensive cycles.
pub fn dear_cycles() -> Vec<Hostile> {
    const START: &str = "M3 S500\nG99 F.2\nG0 X100 Z2\n";
    let short = format!("{START}N1 G0 X1\nN2 G1 X99 Z-9\nG0 X100 Z2\n");
    let um = |name, text, code, line| Hostile {
        setup: r#"{"dialect": {"pqUnit": "um"}}"#,
        ..case(name, text, code, line)
    };
    vec![
        case("G71 over a short contour", called(&short, "G71U1R1\nG71P1Q2\n"), "E-TOO-MANY-MOTIONS", 40208),
        case("G72 over a short contour", called(&short, "G72W1R1\nG72P1Q2\n"), "E-NOT-MONOTONE", 5),
        case("G71 of 98 000 passes", called(&short, "G71U.001R0\nG71P1Q2\n"), "E-TOO-MUCH-WORK", 48),
        case("G71 of too many passes", called(&short, "G71U.0005R0\nG71P1Q2\n"), "E-G71-U-SIGN", 7),
        case(
            "G73 R999 over a short contour",
            called(&short, "G73U9W9R999\nG73P1Q2\n"),
            "E-TOO-MANY-MOTIONS",
            2676,
        ),
        case("G70 over a short contour", called(&short, "G70P1Q2\n"), "W-G70-NO-ROUGH", 7),
        case("G71 over 10 000 pockets", called(&zigzags(10_000), "G71P1Q2\n"), "E-TOO-MANY-PASSES", 20009),
        case("G71 over 1000 pockets", called(&zigzags(1000), "G71P1Q2\n"), "E-TOO-MANY-MOTIONS", 2053),
        case("G72 over 10 000 pockets", called(&zigzags(10_000), "G72P1Q2\n"), "E-TOO-MUCH-WORK", 20058),
        case(
            "G73 over 10 000 pockets",
            called(&zigzags(10_000), "G73U9W9R9\nG73P1Q2\n"),
            "E-TOO-MANY-MOTIONS",
            20054,
        ),
        case(
            "G73 R999 over 100 pockets",
            called(&zigzags(100), "G73U9W9R999\nG73P1Q2\n"),
            "E-TOO-MANY-PASSES",
            210,
        ),
        case("G70 over 20 000 blocks", called(&zigzags(10_000), "G70P1Q2\n"), "E-TOO-MUCH-WORK", 20058),
        case("G71 over 20 000 rising blocks", called(&rising(20_000), "G71P1Q2\n"), "E-TOO-MUCH-WORK", 20058),
        case("G72 over 20 000 rising blocks", called(&rising(20_000), "G72P1Q2\n"), "E-TOO-MUCH-WORK", 20058),
        um(
            "G76 of 66 000 passes",
            called(START, "G76P010060Q1R0\nG76X90Z-9P9999Q1F2\n"),
            "E-TOO-MANY-MOTIONS",
            205,
        ),
        um(
            "G76 of many passes",
            called(START, "G76P010060Q10R0\nG76X90Z-9P9999Q99F2\n"),
            "E-TOO-MANY-MOTIONS",
            2051,
        ),
        um("G74 of 9000 pecks", called(START, "G74R.1\nG74Z-9Q1\n"), "E-TOO-MANY-MOTIONS", 367),
        um("G75 of pecks both ways", called(START, "G75R.1\nG75X90Z-9P99Q99\n"), "E-TOO-MANY-MOTIONS", 691),
        um("G75 of too many pecks", called(START, "G75R.1\nG75X90Z-9P1Q1\n"), "E-TOO-MANY-PASSES", 5),
        case("G83 by far too little", called(START, "G83Z-9999.Q1F1\n"), "E-TOO-MANY-MOTIONS", 137),
        case("G90 again and again", called(START, "G90X90Z-9\n"), "W-NO-END", 104858),
        case("G92 again and again", called(START, "G92X90Z-9F2\n"), "W-NO-END", 87383),
        case("G90 in a loop", format!("O1\n{START}N9 G90X90Z-9\nGOTO 9\n"), "E-ENDLESS", 6),
        case("G92 in a loop", format!("O1\n{START}N9 G92X90Z-9F2\nGOTO 9\n"), "E-ENDLESS", 6),
        case("G83 in a loop", format!("O1\n{START}N9 G83Z-9Q1000F1\nGOTO 9\n"), "E-TOO-MANY-MOTIONS", 5),
        case(
            "G65 with many arguments in a loop",
            format!("O1\nN9 G65P2{}\nGOTO 9\nO2\nM99\n", "I[#1]J[#2]K[#3]".repeat(10)),
            "E-ENDLESS",
            2,
        ),
        case(
            "G66 of a macro with a cycle",
            called("O1\nM3 S1 F.1\nG66 P2\n", "X1\nX2\n") + "O2\nG90X1Z-9\nM99\n",
            "W-NO-END",
            349524,
        ),
    ]
}
