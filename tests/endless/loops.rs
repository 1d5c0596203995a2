//! Endless jumps, loops and calls.

use super::{Hostile, case};

/// Endless jumps, loops and calls.
pub fn never_ending() -> Vec<Hostile> {
    const REPEATS: &str = "E-ENDLESS";
    const FAULTY: &str = "G0 X1,5 Z1,5 F1,2 S1,2 U1,3 W1,2 R1,2\n";
    let moves = "G1 U1 W-1\nU-1 W1\n".repeat(20_000);
    vec![
        case("M99 in the main program", "O1\nG0 X1\nM99\n", "W-ENDLESS", 3),
        case("M99 with a counter", "O1\n#1=#1+1\nIF[#1 EQ 0]GOTO 9\nM99\nN9 M30\n", REPEATS, 4),
        case("M99 with a system counter", "O1\n#1000=#1000+1\nM99\n", REPEATS, 3),
        case("M99 P to itself", "O1\nG0 X1\nN5 M99 P5\n", "W-ENDLESS", 3),
        case("M99 P to the head", "O1\nN1 G0 X1\nG0 Z1\nM99 P1\n", "W-ENDLESS", 4),
        case("GOTO to itself", "O1\nN1 GOTO 1\nM30\n", REPEATS, 2),
        case("GOTO to a faulty block", format!("O1\nN1 {FAULTY}GOTO 1\nM30\n"), REPEATS, 3),
        case("GOTO to faulty blocks", format!("O1\nN1\n{}GOTO 1\nM30\n", FAULTY.repeat(60)), REPEATS, 63),
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
