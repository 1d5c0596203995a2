//! What is assumed where nobody has said anything: the guesses as a setup, and what is usual of a tool.
//!
//! In: the motions, the setup. Out: a [`Setup`] of guesses; a tool with everything filled in, as its shape has it.

use super::guess::Guesses;
use super::thread_point::ThreadPoint;
use super::tool::{BLADE, DRILL, DRILL_POINT, EDGE, ENTERING, POINT};
use crate::motion::Motions;
use crate::setup::{Setup, Tool, ToolKind};

/// So many motions are looked at for names of tools.
const LOOKED_AT: usize = 200_000;

/// The blank and the tools a program lets one guess. A tool is named as the program first calls it; `T0000` is what cuts
/// before any T word.
pub fn guessed(motions: &Motions, given: &Setup) -> Setup {
    let guesses = Guesses::with(motions, &given.spoken, given.stock);
    let mut setup = Setup { stock: guesses.stock, ..Setup::default() };
    let mut names: Vec<(u16, u16)> = Vec::new();
    for motion in motions.iter().take(LOOKED_AT).filter(|motion| motion.kind.cuts()) {
        let name = motion.process.tool;
        if names.last() != Some(&name) && names.iter().all(|own| own.0 != name.0) {
            names.push(name);
        }
    }
    for (station, offset) in names {
        let guess = guesses.tools().find(|guess| guess.0 == station);
        if let Some((.., tool)) = guess {
            setup.tools.insert(format!("T{station:02}{offset:02}"), tool.clone());
        }
    }
    setup
}

/// The tool with what is usual where it says nothing.
pub fn usual(tool: &Tool) -> Tool {
    let kind = tool.kind.unwrap_or(ToolKind::Turning);
    let insert = tool.insert();
    let nose = Some(tool.nose());
    let mut usual = Tool { kind: Some(kind), ..tool.clone() };
    match kind {
        ToolKind::Turning | ToolKind::Boring => {
            usual.nose_radius = nose;
            usual.tip = Some(tool.tip_direction());
            usual.entering_angle = tool.entering_angle.or(Some(ENTERING));
            let point = insert.map_or(Some(POINT), |insert| insert.point_angle);
            usual.point_angle = tool.point_angle.or(point);
            let edge = insert.and_then(|insert| insert.edge_length).unwrap_or(EDGE);
            usual.edge_length = tool.edge_length.or(Some(edge));
        }
        ToolKind::Grooving => {
            usual.side = Some(tool.side.unwrap_or_default());
            usual.nose_radius = nose;
            usual.tip = Some(tool.tip_direction());
            usual.width = tool.width.or(Some(BLADE));
        }
        ToolKind::Threading => {
            usual.side = Some(tool.working_side());
            usual.nose_radius = nose;
            usual.tip = Some(tool.tip_direction());
            // How long its flanks are depends on the pitch it cuts.
            usual.angle = Some(ThreadPoint::of(tool).angle);
        }
        ToolKind::Drill => {
            usual.diameter = tool.diameter.or(Some(DRILL));
            usual.angle = tool.angle.or(Some(DRILL_POINT));
        }
        ToolKind::Tap => usual.diameter = tool.diameter.or(Some(DRILL)),
        ToolKind::Endmill => {
            let diameter = tool.tool_radius.map(|radius| 2.0 * radius);
            usual.diameter = tool.diameter.or(diameter).or(Some(DRILL));
        }
    }
    usual
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analyze;
    use crate::machine::tool::Shape;

    #[test]
    fn what_is_usual_has_the_same_shape() {
        for kind in ToolKind::ALL {
            let tool = Tool { kind: Some(kind), ..Tool::default() };
            assert_eq!(Shape::of(&usual(&tool)), Shape::of(&tool), "{kind:?}");
        }
        let tool = Tool { insert: Some("DNMG150608".into()), ..Tool::default() };
        assert_eq!(Shape::of(&usual(&tool)).edge, Shape::of(&tool).edge);
    }

    #[test]
    fn stations_are_named_as_the_program_calls_them() {
        let text = b"M3 S500\nG0 X40 Z2\nG1 Z-5 F.2\nT0305\nG0 X40 Z2\nG75 R1\nG75 X20 Z-9 P2000 Q2000 F.1\nT0300\nG1 X60\n";
        let guessed = guessed(&analyze(text, &Setup::default()).motions, &Setup::default());
        let tools: Vec<_> = guessed.tools.iter().map(|(name, tool)| (name.as_str(), tool.kind)).collect();
        assert_eq!(tools, [("T0000", Some(ToolKind::Turning)), ("T0305", Some(ToolKind::Grooving))]);
        assert!(guessed.stock.is_some());
    }
}
