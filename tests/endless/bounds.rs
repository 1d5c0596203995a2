//! Every limit of a run, with a program just within it and one that exceeds it by one.

use gcode_playground::limits::{Limits, WORDS_PER_BLOCK};

/// A limit and two programs.
pub struct Bound {
    /// Slug of its message.
    pub slug: &'static str,
    /// The setup that sets it.
    pub setup: String,
    /// A program without the message.
    pub within: String,
    /// A program with the message.
    pub beyond: String,
}

/// All limits.
pub fn bounds() -> Vec<Bound> {
    let bound = |slug, setup: &str, within: &str, beyond: &str| Bound {
        slug,
        setup: format!(r#"{{"limits": {{{setup}}}, "stock": {{"diameter": 20, "length": 50}}}}"#),
        within: within.into(),
        beyond: beyond.into(),
    };
    // A peck of 1 mm takes three moves.
    let hole = |depth: u32| format!("M3 S1 F1 M45\nX0 Z0\nG83 X0 Z-{depth} Q1000\nM30");
    // Three blocks per round: `O2`, `G0 X1` and `M99` have ten characters.
    let calls = |rounds: u32| format!("O1\nM98 P2 L{rounds}\nM30\nO2\nG0 X1\nM99\n");
    // G70 reads its contour of two blocks each time.
    let finishing =
        |times: usize| format!("M3 S1 F1\nX9 Z0\n{}M30\nN1 G0 X1\nN2 G1 Z-1\n", "G70 P1 Q2\n".repeat(times));
    // WHILE, two expressions in X and Z, one statement and END per round, and WHILE once more at the end.
    // Work before the first jump does not count.
    let sums = |rounds: u32| format!("#1=0\nWHILE[#1 LT {rounds}]DO1\nG0 X[#1] Z[#1]\n#1=#1+1\nEND1\nM30\n");
    // The bar has four corners, and a plunge adds a groove of four.
    let grooves = |count: u32| {
        let plunge = |index: u32| format!("G0 X22 Z-{}\nG1 X10\nG0 X22\n", 10 * index);
        format!("M3 S1 F1\n{}", (1..=count).map(plunge).collect::<String>())
    };
    let words = |count: usize| "M0".repeat(count);
    let mut all = vec![
        bound("text-too-long", r#""text": 9"#, "G0X1\nM30\n", "G0 X1\nM30\n"),
        bound("too-many-motions", r#""motions": 2"#, "X1\nX2\nM30", "X1\nX2\nX3\nM30"),
        bound("more-messages", r#""messages": 2"#, "X\nX\nM30", "X\nX\nX\nM30"),
        bound("too-many-passes", r#""movesPerCycle": 13"#, &hole(3), &hole(4)),
        bound("too-much-work", r#""cycleWork": 6"#, &finishing(3), &finishing(4)),
        bound("too-many-repeats", r#""repeatedBlocks": 9"#, &calls(3), &calls(4)),
        bound("too-much-text-repeated", r#""repeatedText": 30"#, &calls(3), &calls(4)),
        bound("too-many-rounds", r#""rounds": 2"#, &calls(3), &calls(4)),
        bound("too-many-rounds", r#""rounds": 3"#, &sums(3), &sums(4)),
        bound("too-many-macro-steps", r#""macroSteps": 11"#, &sums(3), &sums(4)),
        bound("part-too-many-motions", r#""partMotions": 2"#, "X1\nX2\nM30", "X1\nX2\nX3\nM30"),
        bound("part-too-many-corners", r#""partCorners": 8"#, &grooves(1), &grooves(2)),
        bound("numbers-not-compared", r#""comparedBlocks": 3"#, "X1\nX2\nM30", "X1\nX2\nX3\nM30"),
        bound("block-too-long", "", &words(WORDS_PER_BLOCK), &words(WORDS_PER_BLOCK + 1)),
        bound("too-many-digits", "", "X12345.678", "X12345.6789"),
        bound("macro-brackets-too-deep", "", "#1=[[[[[1]]]]]", "#1=[[[[[[1]]]]]]"),
        bound("macro-overflow", "", "#1=POW[10,47]", "#1=POW[10,47.1]"),
    ];
    let levels = |call: &str, most: usize| -> String {
        (1..=most).map(|own| format!("O{own}\n{call} P{}\nM99\n", own + 1)).collect::<String>()
            + &format!("O{}\nM99\n", most + 1)
    };
    let usual = Limits::default();
    for (call, key, most) in
        [("M98", "callDepth", usual.call_depth), ("G65", "macroDepth", usual.macro_depth)]
    {
        for most in [most, 2] {
            let setup = format!(r#""{key}": {most}"#);
            all.push(bound("calls-too-deep", &setup, &levels(call, most), &levels(call, most + 1)));
        }
    }
    all
}
