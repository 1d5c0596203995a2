//! Cycles with a far too small step: each is rejected immediately.

/// A program with one move before a cycle that is not carried out, and the expected message.
pub struct Endless {
    /// Its description.
    pub name: &'static str,
    /// Its setup.
    pub setup: &'static str,
    /// Its text.
    pub text: String,
    /// Code of the message.
    pub code: &'static str,
}

/// All such cycles.
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
        case("G71 U0.0001", "{}", &format!("G71 U0.0001 R0.5\nG71 P1 Q2 U0 W0\n{CONTOUR}"), "E-G71-U-SIGN"),
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
