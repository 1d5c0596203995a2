//! Lines on the screen: whether they cross, coincide or pass through an area, and arrow heads.
//!
//! In: lines and areas in CSS pixels. Out: answers, and corners of arrow heads.

use super::super::camera::Pixel;
use super::super::occupied::Rectangle;
use super::LABEL_HEIGHT;
use crate::geometry::within;

/// Length and half width of an arrow head, CSS pixels.
pub(super) const HEAD: [f64; 2] = [8.0, 2.4];
/// Lengths of marks, each with the gap after it, CSS pixels: the dashes of rapids, and the dash and two dots of another
/// position (ISO 128-24, 05.1).
pub(super) const RAPID: &[[f64; 2]] = &[[5.0, 3.0]];
pub(super) const OTHER_POSITION: &[[f64; 2]] = &[[12.0, 3.0], [1.0, 3.0], [1.0, 3.0]];
/// Maximum number of repetitions of the marks in a line.
const MAX_PERIODS: f64 = 200.0;

/// Whether two straight lines along one axis of the screen run side by side, too close to tell apart.
pub(super) fn run_together(a: &[Pixel], b: &[Pixel]) -> bool {
    let (Some(a), Some(b)) = (ends_of(a), ends_of(b)) else { return false };
    let overlap =
        |a: [f64; 2], b: [f64; 2]| a[0].max(a[1]).min(b[0].max(b[1])) - a[0].min(a[1]).max(b[0].min(b[1]));
    let [ax, ay] = [[a[0].x, a[1].x], [a[0].y, a[1].y]];
    let [bx, by] = [[b[0].x, b[1].x], [b[0].y, b[1].y]];
    let is_flat = |values: [f64; 2]| (values[0] - values[1]).abs() < 0.5;
    let is_near = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).abs() < LABEL_HEIGHT / 2.0;
    (is_flat(ay) && is_flat(by) && is_near(ay, by) && overlap(ax, bx) > 1.0)
        || (is_flat(ax) && is_flat(bx) && is_near(ax, bx) && overlap(ay, by) > 1.0)
}

/// Whether a horizontal and a vertical line cross, not only touch.
pub(super) fn do_cross(a: &[Pixel], b: &[Pixel]) -> bool {
    let (Some(a), Some(b)) = (ends_of(a), ends_of(b)) else { return false };
    let is_inside = |at: f64, one: f64, other: f64| one.min(other) + 1.0 < at && at < one.max(other) - 1.0;
    let cross = |flat: [Pixel; 2], steep: [Pixel; 2]| {
        (flat[0].y - flat[1].y).abs() < 0.5
            && (steep[0].x - steep[1].x).abs() < 0.5
            && is_inside(steep[0].x, flat[0].x, flat[1].x)
            && is_inside(flat[0].y, steep[0].y, steep[1].y)
    };
    cross(a, b) || cross(b, a)
}

/// Whether two straight lines cross, not only touch.
pub(super) fn do_meet([a, b]: [Pixel; 2], [c, d]: [Pixel; 2]) -> bool {
    let cross = |u: Pixel, v: Pixel| u.x * v.y - u.y * v.x;
    let from = |p: Pixel, q: Pixel| Pixel::new(q.x - p.x, q.y - p.y);
    let (u, v, w) = (from(a, b), from(c, d), from(a, c));
    let area = cross(u, v);
    if area.abs() < 1e-9 {
        return false;
    }
    let is_inside = |share: f64, length: f64| share * length > 1.0 && (1.0 - share) * length > 1.0;
    is_inside(cross(w, v) / area, a.distance(b)) && is_inside(cross(w, u) / area, c.distance(d))
}

/// Whether one of two straight lines begins or ends within a distance of the other one.
pub(super) fn do_touch(a: [Pixel; 2], b: [Pixel; 2], distance: f64) -> bool {
    let is_at =
        |ends: [Pixel; 2], other| ends.iter().any(|end| nearest_on(other, *end).distance(*end) < distance);
    is_at(a, b) || is_at(b, a)
}

/// Whether a straight line crosses a polyline.
pub(super) fn meets(line: [Pixel; 2], other: &[Pixel]) -> bool {
    other.windows(2).any(|ends| do_meet(line, [ends[0], ends[1]]))
}

/// The marks of a line.
pub(super) fn dashed(ends: [Pixel; 2], pattern: &[[f64; 2]]) -> Vec<Vec<Pixel>> {
    let length = ends[0].distance(ends[1]);
    let at = |along: f64| Pixel::at_share(ends, (along / length).min(1.0));
    let period: f64 = pattern.iter().flatten().sum();
    let periods = (length / period).min(MAX_PERIODS) as usize;
    let mut start = 0.0;
    let marks = (0..=periods).flat_map(|_| pattern).map(|[mark, gap]| {
        let ends = [start, start + mark];
        start += mark + gap;
        ends
    });
    marks.filter(|mark| mark[0] < length).map(|mark| mark.map(at).to_vec()).collect()
}

/// The ends of a line with two corners.
pub(super) fn ends_of(line: &[Pixel]) -> Option<[Pixel; 2]> {
    line.try_into().ok()
}

/// The part of a line that a leader may touch: not its arrows.
pub(super) fn middle_part(line: &[Pixel]) -> Option<[Pixel; 2]> {
    let ends = [*line.first()?, *line.last()?];
    Some([0.35, 0.65].map(|share| Pixel::at_share(ends, share)))
}

/// The point of a straight line that is nearest to `at`.
pub(super) fn nearest_on([from, to]: [Pixel; 2], at: Pixel) -> Pixel {
    let (x, y) = (to.x - from.x, to.y - from.y);
    let square = x * x + y * y;
    let share = if square < 1e-9 { 0.0 } else { ((at.x - from.x) * x + (at.y - from.y) * y) / square };
    Pixel::at_share([from, to], within(share, 0.0, 1.0))
}

/// Whether a leader is neither level nor upright: those could be taken for strokes and dimension lines (ISO 128-22).
pub(super) fn is_slanted([from, to]: [Pixel; 2]) -> bool {
    let unit = direction(from, to);
    unit.x.abs().min(unit.y.abs()) > 0.12
}

/// The unit vector from one position to another.
pub(super) fn direction(from: Pixel, to: Pixel) -> Pixel {
    let length = from.distance(to);
    if length < 1e-9 {
        return Pixel::new(0.0, -1.0);
    }
    Pixel::new((to.x - from.x) / length, (to.y - from.y) / length)
}

/// An arrow head with its tip at `tip`, coming from `from`.
pub(super) fn head(from: Pixel, tip: Pixel) -> [Pixel; 3] {
    let unit = direction(from, tip);
    let corner = |side: f64| {
        Pixel::new(
            tip.x - unit.x * HEAD[0] - unit.y * side * HEAD[1],
            tip.y - unit.y * HEAD[0] + unit.x * side * HEAD[1],
        )
    };
    [tip, corner(1.0), corner(-1.0)]
}

/// Whether a polyline passes through a rectangle.
pub(super) fn crosses(line: &[Pixel], area: &Rectangle) -> bool {
    line.windows(2).any(|ends| {
        let [from, to] = [ends[0], ends[1]];
        // Liang and Barsky: the part of the line inside each pair of parallel borders.
        let (mut enter, mut leave) = (0.0, 1.0f64);
        for (delta, start, min, max) in
            [(to.x - from.x, from.x, area.min.x, area.max.x), (to.y - from.y, from.y, area.min.y, area.max.y)]
        {
            if delta.abs() < 1e-9 {
                if start <= min || start >= max {
                    return false;
                }
                continue;
            }
            let (a, b) = ((min - start) / delta, (max - start) / delta);
            enter = f64::max(enter, a.min(b));
            leave = f64::min(leave, a.max(b));
        }
        enter < leave
    })
}
