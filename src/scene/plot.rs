//! Rasterises hundreds of thousands of strokes: all solid and one device pixel wide.
//!
//! In: strokes in mm and the camera. Out: for each ink, how much of every pixel it covers. A browser takes
//! several times as long to draw a million lines, mainly because of the calls. Knows no colours.

use std::ops::Range;

use crate::geometry::{Arc, Point, Turn, within};

use super::StrokeShape;
use super::camera::{Camera, Pixel};

/// Minimum distance to the next point of a line, CSS pixels; closer points are skipped.
const MIN_STEP: f64 = 0.8;
/// Maximum distance of a chord from its arc, device pixels.
const SAGITTA: f64 = 0.3;
/// Maximum number of chords of an arc.
const MAX_CHORDS: f64 = 512.0;
/// Radius of the dot of a dwell, CSS pixels.
const DOT: f64 = 3.0;
/// Number of fraction bits of fixed-point positions, in pixels.
const PARTS: u32 = 20;
const ONE: i64 = 1 << PARTS;

/// Several layers of the same picture.
#[derive(Debug)]
pub struct Plot {
    frame: Frame,
    layers: Vec<Layer>,
}

/// The geometry that all layers share.
#[derive(Clone, Copy, Debug)]
struct Frame {
    width: usize,
    height: usize,
    /// Device pixels per mm.
    scale: f64,
    /// Device pixels upwards per mm of radius; negative if X+ points down.
    upward: f64,
    /// The position of X0 Z0, device pixels.
    zero: Pixel,
    /// [`MIN_STEP`] and [`DOT`], device pixels.
    least_step: f64,
    dot: f64,
}

/// A layer.
#[derive(Clone, Debug, Default)]
struct Layer {
    /// The coverage of each pixel, 255 for full; empty until something is drawn.
    cover: Vec<u8>,
    /// End of the last stroke.
    end: Option<Point>,
    /// The end of the drawn part of the current line, and the end of a short piece that is not drawn yet.
    drawn: Pixel,
    to: Option<Pixel>,
}

impl Plot {
    /// Empty layers of `size` device pixels, for the view of a camera.
    pub fn new(camera: &Camera, size: (u32, u32), pixel_ratio: f64, layers: usize) -> Self {
        let zero = camera.to_screen(Point::default());
        let frame = Frame {
            width: size.0 as usize,
            height: size.1 as usize,
            scale: camera.scale() * pixel_ratio,
            upward: camera.upward() * pixel_ratio,
            zero: Pixel::new(zero.x * pixel_ratio, zero.y * pixel_ratio),
            least_step: MIN_STEP * pixel_ratio,
            dot: DOT * pixel_ratio,
        };
        Self { frame, layers: vec![Layer::default(); layers] }
    }

    /// Width and height, device pixels.
    pub fn size(&self) -> (usize, usize) {
        (self.frame.width, self.frame.height)
    }

    /// Draws a shape in a layer.
    pub fn draw(&mut self, layer: usize, shape: &StrokeShape) {
        let (frame, layer) = (self.frame, &mut self.layers[layer]);
        match shape {
            StrokeShape::Line { from, to } => layer.line(frame, *from, *to),
            StrokeShape::Arc(arc) => layer.arc(frame, arc),
            StrokeShape::Virtual(own) => {
                for ends in StrokeShape::curve(own).windows(2) {
                    layer.line(frame, ends[0], ends[1]);
                }
            }
            StrokeShape::Dot(at) => layer.disc(frame, *at),
        }
    }

    /// Draws a straight line in a layer.
    #[inline]
    pub fn line(&mut self, layer: usize, from: Point, to: Point) {
        self.layers[layer].line(self.frame, from, to);
    }

    /// Ends all lines, so that the next one is not joined to them.
    pub fn lift(&mut self) {
        for layer in &mut self.layers {
            layer.finish(self.frame);
            layer.end = None;
        }
    }

    /// The range of pixel rows that are not empty.
    pub fn rows(&self) -> Range<usize> {
        let covers = || self.layers.iter().map(|layer| &layer.cover);
        let first = covers().filter_map(|cover| cover.iter().position(|&part| part > 0)).min();
        let last = covers().filter_map(|cover| cover.iter().rposition(|&part| part > 0)).max();
        match (first, last) {
            (Some(first), Some(last)) => first / self.frame.width..last / self.frame.width + 1,
            _ => 0..0,
        }
    }

    /// The coverage of each pixel in a layer, row by row from the top, 255 for full; empty if nothing is
    /// drawn.
    pub fn cover(&self, layer: usize) -> &[u8] {
        &self.layers[layer].cover
    }
}

impl Frame {
    #[inline]
    fn pixel(self, point: Point) -> Pixel {
        Pixel::new(self.zero.x + point.z * self.scale, self.zero.y - point.x * self.upward)
    }
}

impl Layer {
    #[inline]
    fn line(&mut self, frame: Frame, from: Point, to: Point) {
        if self.end != Some(from) {
            self.finish(frame);
            self.drawn = frame.pixel(from);
        }
        self.end = Some(to);
        let (at, drawn) = (frame.pixel(to), self.drawn);
        if (at.x - drawn.x).abs() < frame.least_step && (at.y - drawn.y).abs() < frame.least_step {
            self.to = Some(at);
        } else {
            self.to = None;
            self.drawn = at;
            self.ink(frame, drawn, at);
        }
    }

    /// Draws a short piece that is still waiting.
    fn finish(&mut self, frame: Frame) {
        if let Some(to) = self.to.take() {
            self.ink(frame, self.drawn, to);
        }
    }

    fn arc(&mut self, frame: Frame, arc: &Arc) {
        let chords = chords(arc, frame.scale);
        let mut from = arc.start;
        for chord in 1..chords {
            let to = arc.at(f64::from(chord) / f64::from(chords));
            self.line(frame, from, to);
            from = to;
        }
        self.line(frame, from, arc.end);
    }

    /// Covers the pixels along a line, the ones at its ends partially.
    fn ink(&mut self, frame: Frame, from: Pixel, to: Pixel) {
        let steep = (to.y - from.y).abs() > (to.x - from.x).abs();
        // The line advances pixel by pixel in its longer direction; in the other direction it lies between
        // two pixels.
        let (mut a, mut b, length, breadth, along, across) = if steep {
            ((from.y, from.x), (to.y, to.x), frame.height, frame.width, frame.width, 1)
        } else {
            ((from.x, from.y), (to.x, to.y), frame.width, frame.height, 1, frame.width)
        };
        if a.0 > b.0 {
            (a, b) = (b, a);
        }
        let (first, last) = (a.0.max(0.0), b.0.min(length as f64));
        if first >= last || a.1.min(b.1) > breadth as f64 + 1.0 || a.1.max(b.1) < -1.0 {
            return;
        }
        let slope = (b.1 - a.1) / (b.0 - a.0);
        self.begin(frame);
        // Divides the coverage between the two pixels beside the line, according to their distance. `middle`
        // is a fixed-point position.
        let cover = &mut self.cover[..];
        let mut put = |place: usize, middle: i64, share: i64| {
            let (low, upper) = (middle >> PARTS, ((middle & (ONE - 1)) * share) >> PARTS);
            for (at, part) in [(low, share - upper), (low + 1, upper)] {
                if (0..breadth as i64).contains(&at) {
                    let pixel = &mut cover[place * along + at as usize * across];
                    *pixel = pixel.saturating_add(part as u8);
                }
            }
        };
        let middle = |from: f64, to: f64| {
            ((a.1 + slope * ((from + to) / 2.0 - a.0) - 0.5) * ONE as f64).floor() as i64
        };
        let share = |from: f64, to: f64| ((to - from) * 255.0 + 0.5) as i64;
        let (begin, end) = (first as usize, (last.ceil() as usize).min(length) - 1);
        if begin == end {
            return put(begin, middle(first, last), share(first, last));
        }
        put(begin, middle(first, (begin + 1) as f64), share(first, (begin + 1) as f64));
        let mut at = middle((begin + 1) as f64, (begin + 2) as f64);
        let step = (slope * ONE as f64) as i64;
        for place in begin + 1..end {
            put(place, at, 255);
            at = at.wrapping_add(step);
        }
        put(end, middle(end as f64, last), share(end as f64, last));
    }

    fn disc(&mut self, frame: Frame, at: Point) {
        let (center, radius) = (frame.pixel(at), frame.dot);
        // A cast clamps negative and too large values to the range of the type.
        let reach = |middle: f64, most: usize| {
            (middle - radius - 1.0) as usize..most.min((middle + radius + 1.0) as usize)
        };
        self.begin(frame);
        for row in reach(center.y, frame.height) {
            for column in reach(center.x, frame.width) {
                let away = center.distance(Pixel::new(column as f64 + 0.5, row as f64 + 0.5));
                let part = (within(radius - away + 0.5, 0.0, 1.0) * 255.0) as u8;
                let pixel = &mut self.cover[row * frame.width + column];
                *pixel = (*pixel).max(part);
            }
        }
    }

    fn begin(&mut self, frame: Frame) {
        if self.cover.is_empty() {
            self.cover.resize(frame.width * frame.height, 0);
        }
    }
}

/// How many chords are needed for an arc at `scale` device pixels per mm.
fn chords(arc: &Arc, scale: f64) -> u32 {
    let radius = arc.radius();
    let to = (arc.end.z - arc.start.z, arc.end.x - arc.start.x);
    let center = (arc.center.z - arc.start.z, arc.center.x - arc.start.x);
    // Most arcs in a crowded picture are short, and can be checked without angles.
    let is_left = to.0 * center.1 - to.1 * center.0 > 0.0;
    let is_short_way = is_left == (arc.turn == Turn::Counterclockwise) && !arc.start.is_same(arc.end);
    if is_short_way {
        let half = (to.0 * to.0 + to.1 * to.1) / 4.0;
        let height = radius - (radius * radius - half).max(0.0).sqrt();
        if height * scale < SAGITTA {
            return 1;
        }
    }
    // The height of a flat arc is its radius times an eighth of its squared angle.
    let pieces = (arc.sweep().abs() * (radius * scale / (8.0 * SAGITTA)).sqrt()).ceil();
    within(pieces, 3.0, MAX_CHORDS) as u32
}

#[cfg(test)]
mod tests {
    use super::super::camera::Size;
    use super::*;
    use crate::geometry::bounds::Bounds;

    /// The coverage of `shapes` in a layer of 200 × 100 pixels, 1 mm each, in whole pixels.
    fn covered(shapes: &[StrokeShape]) -> f64 {
        let plot = drawn(shapes);
        plot.cover(0).iter().map(|&part| f64::from(part) / 255.0).sum()
    }

    fn drawn(shapes: &[StrokeShape]) -> Plot {
        let bounds = Bounds::around(Point::new(0.0, 0.0), Point::new(50.0, 100.0));
        let mut camera = Camera::fit(bounds, Size { width: 200.0, height: 100.0 });
        camera.zoom(1.0 / camera.scale(), camera.to_screen(Point::new(25.0, 50.0)));
        let mut plot = Plot::new(&camera, (200, 100), 1.0, 1);
        shapes.iter().for_each(|shape| plot.draw(0, shape));
        plot.lift();
        plot
    }

    fn line(from: (f64, f64), to: (f64, f64)) -> StrokeShape {
        StrokeShape::Line { from: Point::new(from.0, from.1), to: Point::new(to.0, to.1) }
    }

    #[track_caller]
    fn check(shapes: &[StrokeShape], pixels: f64) {
        let found = covered(shapes);
        assert!((found - pixels).abs() < 0.02 * pixels + 0.1, "{found}, not {pixels}");
    }

    #[test]
    fn a_line_covers_a_pixel_for_each_step_of_its_longer_way() {
        check(&[line((10.0, 10.0), (10.0, 60.0))], 50.0);
        check(&[line((10.2, 10.3), (40.7, 10.9))], 30.5);
        check(&[line((10.0, 60.0), (30.0, 10.0))], 50.0);
        check(&[line((10.0, 10.0), (10.0, 10.2))], 0.2);
    }

    #[test]
    fn many_short_pieces_cover_what_one_line_does() {
        let pieces: Vec<_> = (0..500)
            .map(|i| line((10.0, 10.0 + 0.1 * f64::from(i)), (10.0, 10.1 + 0.1 * f64::from(i))))
            .collect();
        check(&pieces, 50.0);
    }

    #[test]
    fn what_lies_outside_covers_nothing_and_breaks_nothing() {
        let far = [1e3, 1e6, 1e12, 1e300];
        for reach in far {
            check(&[line((reach, -reach), (reach, reach)), line((-reach, reach), (-2.0 * reach, 0.0))], 0.0);
            covered(&[line((-reach, -reach), (reach, reach)), line((25.0, -reach), (25.0, reach))]);
            let (start, center) = (Point::new(0.0, 0.0), Point::new(reach, 0.0));
            covered(&[StrokeShape::Arc(Arc { start, end: start, center, turn: Turn::Clockwise })]);
            covered(&[StrokeShape::Dot(center), line((f64::NAN, 0.0), (1.0, f64::INFINITY))]);
        }
        // Across the whole picture.
        check(&[line((25.0, -1e6), (25.0, 1e6))], 200.0);
    }

    #[test]
    fn arcs_are_drawn_on_the_side_they_bulge_to() {
        let (start, end, center) = (Point::new(10.0, 50.0), Point::new(30.0, 50.0), Point::new(20.0, 50.0));
        let side = |turn| {
            let plot = drawn(&[StrokeShape::Arc(Arc { start, end, center, turn })]);
            let (width, _) = plot.size();
            let middle = plot.frame.pixel(center).x as usize;
            let right = |(at, _): &(usize, &u8)| at % width > middle;
            let all = plot.cover(0).iter().enumerate();
            all.filter(right).map(|(_, &part)| f64::from(part)).sum::<f64>() / 255.0
        };
        // Counter-clockwise from bottom to top passes on the right.
        assert!(side(Turn::Counterclockwise) > 20.0 && side(Turn::Clockwise) < 2.0);
        let round = StrokeShape::Arc(Arc { start, end: start, center, turn: Turn::Clockwise });
        // A circle covers eight times the half width that a diagonal cuts off.
        check(&[round], 8.0 * 10.0 / f64::sqrt(2.0));
    }

    #[test]
    fn flat_arcs_are_one_chord_and_long_ways_round_are_not() {
        let (start, center) = (Point::new(10.0, 0.0), Point::new(0.0, 0.0));
        let end = Point::new(10.0 * f64::cos(0.1), 10.0 * f64::sin(0.1));
        // From above the centre towards +Z is clockwise.
        assert_eq!(chords(&Arc { start, end, center, turn: Turn::Clockwise }, 1.0), 1);
        assert!(chords(&Arc { start, end, center, turn: Turn::Counterclockwise }, 1.0) > 8);
        assert!(chords(&Arc { start, end: start, center, turn: Turn::Clockwise }, 1.0) > 8);
        assert!(chords(&Arc { start, end, center, turn: Turn::Clockwise }, 1000.0) > 3);
    }

    #[test]
    fn only_rows_with_something_in_them_are_told() {
        assert_eq!(drawn(&[]).rows(), 0..0);
        let plot = drawn(&[line((25.0, 10.0), (20.0, 60.0))]);
        let row = |x| plot.frame.pixel(Point::new(x, 0.0)).y as usize;
        assert!(plot.rows().start.abs_diff(row(25.0)) <= 1 && plot.rows().end.abs_diff(row(20.0)) <= 1);
    }

    #[test]
    fn a_dot_is_a_disc() {
        check(&[StrokeShape::Dot(Point::new(25.0, 50.0))], std::f64::consts::PI * DOT * DOT);
    }
}
