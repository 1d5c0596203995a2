//! Long paths of blocks that wait for the next move: corners, open angles, compensation, the planes of G12.1
//! and G07.1; and positions that exceed all bounds.

use super::{Hostile, case, megabyte, numbered};

/// All long paths.
pub fn long_paths() -> Vec<Hostile> {
    let path = |head: &str, of: &str| format!("O1\nM3 S1 F1 G98\nG0 X9 Z9\n{head}\n{}", megabyte(of));
    vec![
        case("corners of R", path("G1", "U1,R.1\nW-1,R.1\n"), "PS0052", 139814),
        case("open angles", path("G1", ",A10\nX9Z9,A80\n"), "W-NO-END", 149800),
        case("open angles with corners", path("G1", ",A10,R1\nX9Z9,A80,C1\n"), "PS0055", 5),
        case("angles that never close", path("G1", ",A10\n"), "PS0056", 5),
        case("tiny moves under G42", path("G42 T0101", "G1U.001W-.001\nU.001\n"), "W-NO-END", 104860),
        case("turns to and fro under G41", path("G41 T0101", "G1U1\nU-1\n"), "W-NO-END", 233020),
        case("arcs under G41", path("G41 T0101", "G2U1W-1R5\nG3U1W-1R5\n"), "W-NO-END", 104860),
        case("G40 and G41 in turn", path("T0101", "G41G1U1W-1\nG40U1\n"), "W-NO-END", 123364),
        case("blocks without a move under G41", path("G41 T0101 G1 U1", "M8\n"), "W-NO-END", 349529),
        case("dwells under G41", path("G41 T0101 G1 U1", "G4U1\nW-1\n"), "W-NO-END", 233020),
        case("arcs under G12.1", path("M45\nG12.1", "G2X9C9R9\nX-9C-9\n"), "PS0022", 7),
        case("corners under G12.1", path("M45\nG12.1", "G1X9C9,R1\nX-9C-9,C1\n"), "PS0051", 7),
        case("compensation under G12.1", path("M45\nG12.1\nG41 T0101", "G1X9C9\nX-9C-9\n"), "W-POLAR-END", 6),
        case("many turns of G07.1", path("M45\nG7.1 C9", "G1 Z9 C99999\nZ1 H-99999\n"), "PS0176", 5),
        case("C far away", path("M45", "G1 H99999999\n"), "W-NO-END", 80663),
        case("U99999999", path("G1", "U99999999\n"), "W-NO-END", 104861),
        case("W-99999999", path("G0", "W-99999999\n"), "W-NO-END", 95329),
        case("arcs of all sizes", path("G1", "G2U1W-1R99999999\nG3U1W-1R.71\n"), "W-NO-END", 72318),
        case("whole circles", path("G1", "G2I99999\nG3K99\n"), "W-NO-END", 139814),
        case("frames moved on and on", path("G1", "G50U99999999\nG52X99999999\n"), "W-NO-END", 80662),
        case("inch and metric in turn", path("G1", "G20X1\nG21X1\n"), "W-NO-END", 174766),
        case("G28 and G30", path("G0", "G28U0\nG30W0\n"), "W-NO-END", 174766),
        case("tools without an end", numbered(|n| format!("T{:04}\n", n % 9999)), "W-NO-END", 174763),
        case("threads", path("G97", "G32W-9F1\nG34W-9F1K1\n"), "W-NO-END", 104860),
        case(
            "threads of a lead out of all measure",
            path("G97", "G34Z-99999F500K500\nZ9\n"),
            "W-NO-END",
            95328,
        ),
    ]
}
