//! Small marks with a fixed size on the screen: arrow heads on strokes, and the tool.
//!
//! In: shapes in mm and a camera. Out: corners in CSS pixels, to be filled by an exporter.

use super::StrokeShape;
use super::camera::{Camera, Pixel, XPlus};

/// Length of an arrow head, CSS pixels.
const HEAD: f64 = 8.0;
/// Half the width of an arrow head, CSS pixels.
const HALF_HEAD: f64 = 2.8;
/// Minimum length on screen of a stroke with an arrow head, CSS pixels.
pub const MIN_FOR_ARROW: f64 = 44.0;
/// Minimum distance between two arrow heads, CSS pixels.
const APART: f64 = 16.0;
/// Maximum number of arrow heads in one picture.
const MAX_ARROWS: usize = 400;
/// Maximum number of visible motions for arrow heads; with more, they would only clutter the picture.
pub const MAX_WITH_ARROWS: usize = 3000;
/// Edge length of the insert, CSS pixels.
const EDGE: f64 = 19.0;
/// Angles of the two cutting edges of an 80° insert from +Z, degrees, counter-clockwise: an approach angle of
/// 95° for both turning and facing.
const EDGES: [f64; 2] = [5.0, 85.0];

/// The arrow head in the middle of a stroke, tip first; `None` if the stroke is shorter than `least` CSS
/// pixels.
fn arrow_head(shape: &StrokeShape, camera: &Camera, least: f64) -> Option<[Pixel; 3]> {
    if shape.length() * camera.scale() < least {
        return None;
    }
    let middle = camera.to_screen(shape.at(0.5));
    let [back, front] = [0.499, 0.501].map(|t| camera.to_screen(shape.at(t)));
    let length = back.distance(front);
    if length <= 0.0 {
        return None;
    }
    let (ux, uy) = ((front.x - back.x) / length, (front.y - back.y) / length);
    let corner = |along: f64, aside: f64| {
        Pixel::new(middle.x + ux * along - uy * aside, middle.y + uy * along + ux * aside)
    };
    Some([corner(HEAD / 2.0, 0.0), corner(-HEAD / 2.0, HALF_HEAD), corner(-HEAD / 2.0, -HALF_HEAD)])
}

/// Arrow heads in the middle of `shapes` that are visible and at least `least` CSS pixels long. Arrow heads
/// close to another one are omitted; the rest is enough to show the direction.
pub fn arrow_heads(
    shapes: impl Iterator<Item = StrokeShape>,
    camera: &Camera,
    least: f64,
) -> Vec<[Pixel; 3]> {
    let mut heads = Vec::new();
    add_arrow_heads(&mut heads, shapes, camera, least);
    heads
}

/// Adds the arrow heads of further shapes, except those close to another one.
pub fn add_arrow_heads(
    heads: &mut Vec<[Pixel; 3]>,
    shapes: impl Iterator<Item = StrokeShape>,
    camera: &Camera,
    least: f64,
) {
    let seen = camera.seen();
    for shape in shapes {
        if heads.len() >= MAX_ARROWS {
            break;
        }
        let Some(head) = arrow_head(&shape, camera, least) else { continue };
        let crowded = heads.iter().any(|other| other[0].distance(head[0]) < APART);
        if !crowded && seen.contains(camera.to_world(head[0])) {
            heads.push(head);
        }
    }
}

/// The outline of an 80° insert with its tip at `tip`, tip first.
pub fn insert(tip: Pixel, x_plus: XPlus) -> [Pixel; 4] {
    let outwards = match x_plus {
        XPlus::Up => -1.0,
        XPlus::Down => 1.0,
    };
    let [low, high] = EDGES.map(|degrees: f64| {
        let angle = degrees.to_radians();
        Pixel::new(EDGE * angle.cos(), outwards * EDGE * angle.sin())
    });
    let corner = |dx: f64, dy: f64| Pixel::new(tip.x + dx, tip.y + dy);
    [tip, corner(low.x, low.y), corner(low.x + high.x, low.y + high.y), corner(high.x, high.y)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::bounds::Bounds;
    use crate::geometry::{Arc, Point, Turn};
    use crate::scene::camera::Size;

    #[test]
    fn arrows_point_the_way_the_tool_goes() {
        let size = Size { width: 500.0, height: 500.0 };
        let camera = Camera::fit(Bounds::around(Point::new(-10.0, -10.0), Point::new(10.0, 10.0)), size);
        let left = StrokeShape::Line { from: Point::new(5.0, 8.0), to: Point::new(5.0, -8.0) };
        let [tip, a, b] = arrow_head(&left, &camera, 40.0).expect("long enough");
        assert!(tip.x < a.x && tip.x < b.x && (a.y + b.y - 2.0 * tip.y).abs() < 1e-6);
        // From the right-most point of a circle over the top to the left: the tip points up on the screen,
        // then left.
        let (start, end, center) = (Point::new(0.0, 8.0), Point::new(0.0, -8.0), Point::default());
        let arc = |turn| StrokeShape::Arc(Arc { start, end, center, turn });
        let [tip, a, _] = arrow_head(&arc(Turn::Counterclockwise), &camera, 40.0).expect("long enough");
        assert!(tip.x < a.x && tip.y < 250.0);
        let [tip, a, _] = arrow_head(&arc(Turn::Clockwise), &camera, 40.0).expect("long enough");
        assert!(tip.x < a.x && tip.y > camera.to_screen(center).y);
        let short = StrokeShape::Line { from: Point::new(5.0, 0.1), to: Point::new(5.0, 0.0) };
        assert_eq!(arrow_head(&short, &camera, 40.0), None);
    }
}
