//! Expensive work in each of many rounds.

use super::{Hostile, case, megabyte};

/// Expensive work in each of many rounds.
pub fn repeated_work() -> Vec<Hostile> {
    let repeats = "E-ENDLESS";
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
            "9 999 999 rounds of a G71 with an error in its contour",
            cycle("G71 U1 R1\nG71 P1 Q2 U0 W0\nN1 G0 X1\nG1 Z-9\nM98 P2\nN2 G1 X99 Z-9"),
            motions,
            8,
        ),
        case(
            "9 999 999 rounds of a refused G71",
            cycle("G71 P1 Q2 U0 W0\nN1 G0 X1\nN2 G1 X99 Z-9"),
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
