//! Default values of a tool.
//!
//! In: a tool. Out: the same tool with every measure filled in, as its shape uses it.

use super::thread_point::ThreadPoint;
use super::tool::{BLADE, DRILL, DRILL_POINT, EDGE, ENTERING, POINT};
use crate::setup::{Tool, ToolKind};
use crate::units::Diameter;

/// Fills in the default for each measure that the tool does not give.
pub fn with_defaults(tool: &Tool) -> Tool {
    let kind = tool.kind.unwrap_or(ToolKind::Turning);
    let insert = tool.insert();
    let nose = Some(tool.nose());
    let mut complete = Tool { kind: Some(kind), ..tool.clone() };
    match kind {
        ToolKind::Turning | ToolKind::Boring => {
            complete.nose_radius = nose;
            complete.tip = Some(tool.tip_direction());
            complete.entering_angle = tool.entering_angle.or(Some(ENTERING));
            let point = insert.map_or(Some(POINT), |insert| insert.point_angle);
            complete.point_angle = tool.point_angle.or(point);
            let edge = insert.and_then(|insert| insert.edge_length).unwrap_or(EDGE);
            complete.edge_length = tool.edge_length.or(Some(edge));
        }
        ToolKind::Grooving => {
            complete.side = Some(tool.side.unwrap_or_default());
            complete.nose_radius = nose;
            complete.tip = Some(tool.tip_direction());
            complete.width = tool.width.or(Some(BLADE));
        }
        ToolKind::Threading => {
            complete.side = Some(tool.working_side());
            complete.nose_radius = nose;
            complete.tip = Some(tool.tip_direction());
            // The length of its flanks depends on the pitch it cuts.
            complete.angle = Some(ThreadPoint::of(tool).angle);
        }
        ToolKind::Drill => {
            complete.diameter = tool.diameter.or(Some(DRILL));
            complete.angle = tool.angle.or(Some(DRILL_POINT));
        }
        ToolKind::Tap => complete.diameter = tool.diameter.or(Some(DRILL)),
        ToolKind::Endmill => {
            let diameter = tool.cutter_radius().map(Diameter::from_radius);
            complete.diameter = tool.diameter.or(diameter).or(Some(DRILL));
        }
    }
    complete
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::tool::Shape;

    #[test]
    fn defaults_have_the_same_shape() {
        for kind in ToolKind::ALL {
            let tool = Tool { kind: Some(kind), ..Tool::default() };
            assert_eq!(Shape::of(&with_defaults(&tool)), Shape::of(&tool), "{kind:?}");
        }
        let tool = Tool { insert: Some("DNMG150608".into()), ..Tool::default() };
        assert_eq!(Shape::of(&with_defaults(&tool)).edge, Shape::of(&tool).edge);
    }
}
