//! Random programs as in a workshop, with typical faults.

use proptest::prelude::*;

/// A number of a workshop program: usually with a point, and of a size that fits a lathe.
fn length(low: i32, high: i32) -> impl Strategy<Value = String> {
    (low * 4..high * 4, 0..8).prop_map(|(quarters, form)| match form {
        0 => format!("{}", quarters / 4),
        _ => format!("{}", f64::from(quarters) / 4.0) + if quarters % 4 == 0 { "." } else { "" },
    })
}

/// Words of a position: absolute, incremental, one axis or both.
fn place() -> impl Strategy<Value = String> {
    let x = prop_oneof![4 => length(10, 60).prop_map(|x| format!("X{x} ")), 1 => length(-8, 8).prop_map(|u| format!("U{u} "))];
    let z = prop_oneof![4 => length(-40, 5).prop_map(|z| format!("Z{z} ")), 1 => length(-6, 6).prop_map(|w| format!("W{w} "))];
    (prop::option::weighted(0.7, x), prop::option::weighted(0.7, z))
        .prop_map(|(x, z)| x.unwrap_or_default() + &z.unwrap_or_default())
}

/// A block of a workshop program, or a few that belong together.
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

/// A workshop program with typical faults: words that do not fit together, unreadable blocks, missing codes.
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

/// A program with a few typing errors: a character is wrong, missing or duplicated.
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
