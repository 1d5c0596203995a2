//! Conversion between millimetres and pixels.
//!
//! In: the box to show, the size of the picture, the user's pans and zooms. Out: [`Camera`]. Z points to the
//! right and X up, or down for a turret in front of the spindle, both at the same scale. Pixels are CSS
//! pixels from the top left corner. Knows nothing of motions.

use crate::geometry::{Point, within};
use crate::setup::Turret;

use crate::geometry::bounds::Bounds;

/// A position in the picture, CSS pixels from the top left corner, `y` down.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pixel {
    /// To the right.
    pub x: f64,
    /// Down.
    pub y: f64,
}

impl Pixel {
    /// The position `x` pixels to the right of the top left corner and `y` pixels below it.
    pub fn new(x: f64, y: f64) -> Self {
        Self { x, y }
    }

    /// The position at a share of a line.
    pub fn at_share([from, to]: [Self; 2], share: f64) -> Self {
        Self::new(from.x + share * (to.x - from.x), from.y + share * (to.y - from.y))
    }

    /// Distance to another position, CSS pixels.
    pub fn distance(self, other: Pixel) -> f64 {
        (self.x - other.x).hypot(self.y - other.y)
    }
}

/// A width and a height, CSS pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Size {
    /// Width, CSS pixels.
    pub width: f64,
    /// Height, CSS pixels.
    pub height: f64,
}

/// Width of the ruler along the left edge, CSS pixels.
pub const LEFT_RULER: f64 = 46.0;
/// Height of the ruler along the bottom edge, CSS pixels.
pub const BOTTOM_RULER: f64 = 26.0;
/// Free space around a fitted picture, CSS pixels: left, top, right and bottom inside the rulers.
const PADDING: [f64; 4] = [14.0, 26.0, 22.0, 22.0];
/// Minimum and maximum scale, CSS pixels per mm: 20 m on the width of a phone, and 0.5 µm per pixel.
pub const SCALES: [f64; 2] = [0.02, 2000.0];
/// Minimum extent that is fitted, mm, so that a single point is not magnified without limit.
const MIN_EXTENT: f64 = 2.0;

/// The direction of X+ in the picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum XPlus {
    /// Up, for a rear turret.
    #[default]
    Up,
    /// Down, for a turret in front of the spindle, on the side of the operator.
    Down,
}

impl XPlus {
    /// 1 for up, −1 for down.
    fn sign(self) -> f64 {
        match self {
            Self::Up => 1.0,
            Self::Down => -1.0,
        }
    }
}

impl From<Turret> for XPlus {
    fn from(turret: Turret) -> Self {
        match turret {
            Turret::Rear => Self::Up,
            Turret::Front => Self::Down,
        }
    }
}

/// The visible part of the plane, and its scale.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Size of the picture.
    size: Size,
    /// The point at the top left corner: radius and Z, mm.
    origin: Point,
    /// CSS pixels per mm of Z or of radius.
    scale: f64,
    /// The direction of X+.
    x_plus: XPlus,
}

impl Camera {
    /// A camera that shows all of `bounds` inside the rulers of a picture of `size`, X+ up.
    pub fn fit(bounds: Bounds, size: Size) -> Self {
        Self::fit_with(bounds, size, XPlus::Up)
    }

    /// Like [`Camera::fit`], with the direction of X+.
    pub fn fit_with(bounds: Bounds, size: Size, x_plus: XPlus) -> Self {
        let [left, top, right, bottom] = PADDING;
        let width = (size.width - LEFT_RULER - left - right).max(1.0);
        let height = (size.height - BOTTOM_RULER - top - bottom).max(1.0);
        let along = width / bounds.length().max(MIN_EXTENT);
        let across = height / bounds.height().max(MIN_EXTENT);
        let scale = within(along.min(across), SCALES[0], SCALES[1]);
        let center_z = (bounds.min.z + bounds.max.z) / 2.0;
        let center_x = (bounds.min.x + bounds.max.x) / 2.0;
        let origin = Point::new(
            center_x + x_plus.sign() * (top + height / 2.0) / scale,
            center_z - (LEFT_RULER + left + width / 2.0) / scale,
        );
        Self { size, origin, scale, x_plus }
    }

    /// The horizontal and vertical pixel ranges inside the rulers and a margin, CSS pixels.
    pub fn inside(&self, margin: f64) -> [[f64; 2]; 2] {
        let Size { width, height } = self.size;
        [[LEFT_RULER + margin, width - margin], [margin, height - BOTTOM_RULER - margin]]
    }

    /// The height of a picture `width` CSS pixels wide that `bounds` fill exactly, between `least` and
    /// `most`.
    pub fn height_for(bounds: Bounds, width: f64, least: f64, most: f64) -> f64 {
        let [left, top, right, bottom] = PADDING;
        let scale = (width - LEFT_RULER - left - right).max(1.0) / bounds.length().max(MIN_EXTENT);
        let height = bounds.height().max(MIN_EXTENT) * scale + BOTTOM_RULER + top + bottom;
        within(height, least, most).round()
    }

    /// Size of the picture.
    pub fn size(&self) -> Size {
        self.size
    }

    /// CSS pixels per mm of Z or of radius.
    pub fn scale(&self) -> f64 {
        self.scale
    }

    /// The direction of X+.
    pub fn x_plus(&self) -> XPlus {
        self.x_plus
    }

    /// CSS pixels upwards per mm of radius; negative if X+ points down.
    pub fn upward(&self) -> f64 {
        self.x_plus.sign() * self.scale
    }

    /// Sets the direction of X+. If it changes, the axis is mirrored about the middle of the area inside the
    /// rulers.
    pub fn turn(&mut self, x_plus: XPlus) {
        if self.x_plus != x_plus {
            let axis = self.to_screen(Point::default()).y;
            self.x_plus = x_plus;
            let moved = self.to_screen(Point::default()).y;
            self.pan(0.0, self.size.height - BOTTOM_RULER - axis - moved);
        }
    }

    /// The position of a point in the picture.
    pub fn to_screen(&self, point: Point) -> Pixel {
        Pixel::new((point.z - self.origin.z) * self.scale, (self.origin.x - point.x) * self.upward())
    }

    /// The point at a position in the picture.
    pub fn to_world(&self, pixel: Pixel) -> Point {
        Point::new(self.origin.x - pixel.y / self.upward(), self.origin.z + pixel.x / self.scale)
    }

    /// The visible part of the plane, mm.
    pub fn seen(&self) -> Bounds {
        Bounds::around(self.origin, self.to_world(Pixel::new(self.size.width, self.size.height)))
    }

    /// Moves the picture by CSS pixels, to the right and down.
    pub fn pan(&mut self, dx: f64, dy: f64) {
        if dx.is_finite() && dy.is_finite() {
            self.origin = self.to_world(Pixel::new(-dx, -dy));
        }
    }

    /// Zooms by `factor`, within [`SCALES`]; the point at `fixed` does not move.
    pub fn zoom(&mut self, factor: f64, fixed: Pixel) {
        if !(factor.is_finite() && factor > 0.0 && fixed.x.is_finite() && fixed.y.is_finite()) {
            return;
        }
        let point = self.to_world(fixed);
        self.scale = within(self.scale * factor, SCALES[0], SCALES[1]);
        let moved = self.to_screen(point);
        self.pan(fixed.x - moved.x, fixed.y - moved.y);
    }

    /// Changes the size of the picture; the point in the middle stays there.
    pub fn resize(&mut self, size: Size) {
        let middle = |size: Size| Pixel::new(size.width / 2.0, size.height / 2.0);
        let (before, after) = (middle(self.size), middle(size));
        self.size = size;
        self.pan(after.x - before.x, after.y - before.y);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: Size = Size { width: 800.0, height: 500.0 };

    fn camera() -> Camera {
        Camera::fit(Bounds::around(Point::new(0.0, -60.0), Point::new(40.0, 10.0)), SIZE)
    }

    fn same(a: Pixel, b: Pixel) -> bool {
        a.distance(b) < 1e-6
    }

    #[test]
    fn z_runs_right_and_x_up() {
        let camera = camera();
        let [a, b] = [Point::new(10.0, -5.0), Point::new(20.0, 5.0)].map(|point| camera.to_screen(point));
        assert!(b.x > a.x && b.y < a.y);
        assert!(((b.x - a.x) - (a.y - b.y)).abs() < 1e-9, "equal scale");
    }

    #[test]
    fn a_front_turret_has_x_down() {
        let bounds = Bounds::around(Point::new(-5.0, -60.0), Point::new(40.0, 10.0));
        let mut camera = Camera::fit_with(bounds, SIZE, Turret::Front.into());
        let [a, b] = [Point::new(10.0, -5.0), Point::new(20.0, 5.0)].map(|point| camera.to_screen(point));
        assert!(b.x > a.x && b.y > a.y);
        assert!(camera.to_world(a).is_same(Point::new(10.0, -5.0)) && camera.seen().contains(bounds.max));
        let before = camera;
        camera.turn(XPlus::Up);
        assert!(camera.to_screen(Point::new(20.0, 5.0)).y < camera.to_screen(Point::new(10.0, 5.0)).y);
        camera.turn(XPlus::Down);
        assert!(same(camera.to_screen(Point::new(20.0, 5.0)), before.to_screen(Point::new(20.0, 5.0))));
    }

    #[test]
    fn there_and_back() {
        let camera = camera();
        for point in [Point::new(0.0, 0.0), Point::new(31.25, -17.3), Point::new(-4.0, 200.0)] {
            assert!(camera.to_world(camera.to_screen(point)).is_same(point));
        }
    }

    #[test]
    fn a_fitted_box_lies_inside_the_rulers() {
        for bounds in [
            Bounds::around(Point::new(0.0, -60.0), Point::new(40.0, 10.0)),
            Bounds::around(Point::new(0.0, -600.0), Point::new(4.0, 10.0)),
            Bounds::around(Point::new(0.0, 5.0), Point::new(100.0, 5.0)),
            Bounds::of(Point::new(0.0, 0.0)),
        ] {
            let camera = Camera::fit(bounds, SIZE);
            let [low, high] = [bounds.min, bounds.max].map(|point| camera.to_screen(point));
            assert!(low.x > LEFT_RULER && low.y < SIZE.height - BOTTOM_RULER, "{low:?}");
            assert!(high.x < SIZE.width && high.y > 0.0, "{high:?}");
        }
    }

    #[test]
    fn a_canvas_without_size_does_not_break_it() {
        let camera = Camera::fit(Bounds::of(Point::default()), Size { width: 0.0, height: 0.0 });
        assert!(camera.to_screen(Point::new(1.0, 1.0)).x.is_finite());
    }

    #[test]
    fn zoom_keeps_the_point_under_the_cursor() {
        let mut camera = camera();
        let cursor = Pixel::new(123.0, 77.0);
        let point = camera.to_world(cursor);
        for factor in [1.3, 4.0, 1e9, 1e-12, 0.5, f64::NAN, 0.0, -2.0] {
            camera.zoom(factor, cursor);
            assert!(same(camera.to_screen(point), cursor), "factor {factor}");
            assert!((SCALES[0]..=SCALES[1]).contains(&camera.scale()));
        }
    }

    #[test]
    fn pan_moves_what_is_seen() {
        let mut camera = camera();
        let before = camera.to_screen(Point::new(3.0, 4.0));
        camera.pan(15.0, -6.0);
        assert!(same(camera.to_screen(Point::new(3.0, 4.0)), Pixel::new(before.x + 15.0, before.y - 6.0)));
    }

    #[test]
    fn resize_keeps_the_middle() {
        let mut camera = camera();
        let point = camera.to_world(Pixel::new(400.0, 250.0));
        camera.resize(Size { width: 300.0, height: 900.0 });
        assert!(same(camera.to_screen(point), Pixel::new(150.0, 450.0)));
    }
}
