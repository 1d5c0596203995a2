//! The ticks of the rulers and their labels.
//!
//! In: a camera, and the unit with its symbol. Out: ticks at round values, as many as fit. Z and C are in
//! that unit, X is a **diameter** in that unit: only here does the picture convert radii to diameters, and mm
//! to inches. Knows no language.

use super::camera::{BOTTOM_RULER, Camera, LEFT_RULER, Pixel, XPlus};
use crate::units::{Diameter, Unit};

/// The unit of all rulers of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Scale {
    /// The unit of the numbers.
    pub unit: Unit,
    /// The symbol of the unit, in the language of the picture.
    pub symbol: &'static str,
}

impl Scale {
    /// A unit with its international symbol.
    pub fn of(unit: Unit) -> Self {
        let symbol = match unit {
            Unit::Millimetre => "mm",
            Unit::Inch => "in",
        };
        Self { unit, symbol }
    }
}

impl Default for Scale {
    fn default() -> Self {
        Self::of(Unit::Millimetre)
    }
}

/// An axis of the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Axis {
    /// Along the bottom edge.
    Z,
    /// Along the left edge, in diameters.
    X,
    /// Along the bottom edge of the face view, in diameters.
    FaceX,
    /// Along the left edge of the face view: C as a length, as under G12.1.
    FaceC,
    /// Y: along the left edge of the face view if all moves there are along Y, and of the side view.
    Y,
    /// Along the left edge of the unrolled side: C in degrees.
    Around {
        /// The radius at which angles are unrolled, mm.
        radius: f64,
    },
    /// Along the left edge of the chart of speeds: spindle speed in rpm.
    Speed {
        /// Speed for each mm of the picture, rpm.
        scale: f64,
    },
}

impl Axis {
    /// The name beside the ruler; `unit` is the unit symbol in the language of the picture.
    pub fn name(self, unit: &str) -> String {
        let letter = match self {
            Self::Z => "Z",
            Self::X | Self::FaceX => "X Ø",
            Self::FaceC => "C",
            Self::Y => "Y",
            Self::Around { .. } => return "C °".to_owned(),
            Self::Speed { .. } => return "n".to_owned(),
        };
        format!("{letter} {unit}")
    }

    /// Whether the name is too long for the corner of the rulers; it is then inside the picture.
    pub fn has_long_name(self) -> bool {
        matches!(self, Self::FaceX)
    }

    /// Whether the axis is along the bottom edge.
    fn is_level(self) -> bool {
        matches!(self, Self::Z | Self::FaceX)
    }

    /// The ruler value of one mm of the picture.
    fn count(self, unit: Unit) -> f64 {
        let across = match self {
            Self::X | Self::FaceX => Diameter::from_radius(1.0).mm(),
            Self::Z | Self::FaceC | Self::Y => 1.0,
            Self::Around { radius } => return radius.recip().to_degrees(),
            Self::Speed { scale } => return scale,
        };
        across / unit.millimetres()
    }

    /// The ruler value at a number of steps from zero: in a section, the diameter is the same on both sides
    /// of the spindle axis.
    fn read(self, steps: i64) -> i64 {
        match self {
            Self::X => steps.abs(),
            Self::Z | Self::FaceX | Self::FaceC | Self::Y | Self::Around { .. } | Self::Speed { .. } => steps,
        }
    }

    /// Minimum distance between labelled ticks, CSS pixels.
    fn room(self) -> f64 {
        match self {
            Self::Z | Self::FaceX => 64.0,
            Self::X | Self::FaceC | Self::Y | Self::Around { .. } | Self::Speed { .. } => 44.0,
        }
    }
}

/// The length of a tick.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TickWeight {
    /// At a round value: with a grid line, and a label if it fits.
    Major,
    /// Between two major ticks.
    Minor,
}

impl TickWeight {
    /// Length of the tick, CSS pixels.
    pub fn length(self) -> f64 {
        match self {
            Self::Major => 6.0,
            Self::Minor => 3.0,
        }
    }
}

/// A tick of a ruler.
#[derive(Clone, Debug, PartialEq)]
pub struct Tick {
    /// Position, CSS pixels: from the left edge on a horizontal ruler, from the top on a vertical one.
    pub pixel: f64,
    /// Its length.
    pub weight: TickWeight,
    /// The label, if the tick has one and it fits.
    pub label: Option<String>,
}

/// Minimum distance of a label from the right end of its ruler, CSS pixels.
const END_ROOM: f64 = 14.0;

/// The visible ticks of an axis, by increasing value.
pub fn ticks(axis: Axis, camera: &Camera, unit: Unit) -> Vec<Tick> {
    let size = camera.size();
    let low = camera.to_world(Pixel::new(LEFT_RULER, size.height - BOTTOM_RULER));
    let high = camera.to_world(Pixel::new(size.width, 0.0));
    let zero = camera.to_screen(Default::default());
    let ends = if axis.is_level() { [low.z, high.z] } else { [low.x.min(high.x), low.x.max(high.x)] };
    let [from, to] = ends.map(|end| end * axis.count(unit));
    let pixels = camera.scale() / axis.count(unit);
    let step = match axis {
        Axis::Around { .. } => Step::of_angle(axis.room() / pixels),
        Axis::Z | Axis::X | Axis::FaceX | Axis::FaceC | Axis::Y | Axis::Speed { .. } => {
            Step::at_least(axis.room() / pixels)
        }
    };
    let minor = step.value() / f64::from(step.parts());
    let (first, last) = ((from / minor).ceil(), (to / minor).floor());
    // Never more ticks than pixels, and none for values too large to count.
    let count = last - first;
    if !(0.0..=size.width.max(size.height)).contains(&count) || first.abs() > 1e12 {
        return Vec::new();
    }
    (0..count as i64 + 1)
        .map(|offset| {
            let index = first as i64 + offset;
            let away = index as f64 * minor * pixels;
            let pixel = match (axis.is_level(), camera.x_plus()) {
                (true, _) => zero.x + away,
                (false, XPlus::Up) => zero.y - away,
                (false, XPlus::Down) => zero.y + away,
            };
            let parts = i64::from(step.parts());
            let weight = if index % parts == 0 { TickWeight::Major } else { TickWeight::Minor };
            let free = match axis.is_level() {
                true => LEFT_RULER + 13.0..size.width - END_ROOM,
                false => 8.0..size.height - BOTTOM_RULER - 4.0,
            };
            let labelled = weight == TickWeight::Major && free.contains(&pixel);
            Tick { pixel, weight, label: labelled.then(|| step.label(axis.read(index / parts))) }
        })
        .collect()
}

/// A round distance between labelled ticks: 1, 2 or 5 times a power of ten; for angles, also a simple
/// fraction of a turn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Step {
    /// 1, 2 or 5; or a number of degrees.
    digit: i64,
    /// The power of ten.
    power: i32,
}

impl Step {
    /// The smallest round step that is at least `least`.
    fn at_least(least: f64) -> Self {
        let least = crate::geometry::within(least, 1e-6, 1e9);
        let power = least.log10().floor() as i32;
        let digits = [(1, power), (2, power), (5, power), (1, power + 1)];
        let fits = |step: &Step| step.value() >= least * (1.0 - 1e-9);
        let steps = digits.map(|(digit, power)| Step { digit, power });
        steps.into_iter().find(fits).unwrap_or(Step { digit: 1, power: power + 1 })
    }

    /// The smallest round step in degrees that is at least `least`.
    fn of_angle(least: f64) -> Self {
        let parts = [15, 30, 45, 90, 180, 360].map(|digit| Self { digit, power: 0 });
        let fits = |step: &Step| least > 10.0 && step.value() >= least * (1.0 - 1e-9);
        parts.into_iter().find(fits).unwrap_or_else(|| Self::at_least(least))
    }

    fn value(self) -> f64 {
        match self.power {
            power if power < 0 => self.digit as f64 / 10f64.powi(-power),
            power => self.digit as f64 * 10f64.powi(power),
        }
    }

    /// The number of intervals between minor ticks.
    fn parts(self) -> i32 {
        match self.digit {
            2 | 360 => 4,
            15 | 30 | 45 | 90 | 180 => 3,
            _ => 5,
        }
    }

    /// The value of `count` steps as text, with a true minus sign and without binary rounding errors.
    fn label(self, count: i64) -> String {
        let decimals = (-self.power).max(0);
        let units = (count * self.digit).unsigned_abs();
        let sign = if count < 0 { "\u{2212}" } else { "" };
        let zeros = 10u64.pow(self.power.max(0) as u32);
        let split = 10u64.pow(decimals as u32);
        match decimals {
            0 => format!("{sign}{}", units * zeros),
            _ => format!("{sign}{}.{:0width$}", units / split, units % split, width = decimals as usize),
        }
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;
    use crate::geometry::Point;
    use crate::geometry::bounds::Bounds;
    use crate::scene::camera::Size;

    fn labels(axis: Axis, camera: &Camera) -> String {
        let labels: Vec<String> =
            ticks(axis, camera, Unit::Millimetre).into_iter().filter_map(|tick| tick.label).collect();
        labels.join(" ")
    }

    fn camera(low: (f64, f64), high: (f64, f64), width: f64, height: f64) -> Camera {
        let bounds = Bounds::around(Point::new(low.0, low.1), Point::new(high.0, high.1));
        Camera::fit(bounds, Size { width, height })
    }

    #[test]
    fn a_diameter_is_the_same_on_both_sides_of_the_axis() {
        let camera = camera((-30.0, -60.0), (30.0, 10.0), 500.0, 800.0);
        assert_eq!(labels(Axis::X, &camera), "120 100 80 60 40 20 0 20 40 60 80 100 120");
        assert!(labels(Axis::FaceX, &camera).starts_with('\u{2212}'));
    }

    #[test]
    fn x_reads_in_diameters() {
        let camera = camera((0.0, -60.0), (40.0, 10.0), 800.0, 500.0);
        assert_eq!(labels(Axis::X, &camera), "0 10 20 30 40 50 60 70 80");
        assert_eq!(
            labels(Axis::Z, &camera),
            "\u{2212}60 \u{2212}50 \u{2212}40 \u{2212}30 \u{2212}20 \u{2212}10 0 10"
        );
        let tick = ticks(Axis::X, &camera, Unit::Millimetre)
            .into_iter()
            .find(|tick| tick.label.as_deref() == Some("80"));
        assert!((tick.expect("80").pixel - camera.to_screen(Point::new(40.0, 0.0)).y).abs() < 1e-9);
    }

    #[test]
    fn rulers_read_in_inches() {
        let camera = camera((0.0, -50.8), (25.4, 6.0), 800.0, 400.0);
        let inches = |axis| {
            let labels = ticks(axis, &camera, Unit::Inch).into_iter().filter_map(|tick| tick.label);
            labels.collect::<Vec<_>>().join(" ")
        };
        assert_eq!(inches(Axis::X), "0.0 0.5 1.0 1.5 2.0");
        assert_eq!(
            inches(Axis::Z),
            "\u{2212}2.0 \u{2212}1.8 \u{2212}1.6 \u{2212}1.4 \u{2212}1.2 \u{2212}1.0 \u{2212}0.8 \u{2212}0.6 \u{2212}0.4 \u{2212}0.2 0.0 0.2"
        );
        let mut ticks = ticks(Axis::Z, &camera, Unit::Inch).into_iter();
        let tick = ticks.find(|tick| tick.label.as_deref() == Some("\u{2212}1.0"));
        assert!((tick.expect("-1").pixel - camera.to_screen(Point::new(0.0, -25.4)).x).abs() < 1e-9);
    }

    #[test]
    fn the_face_reads_x_in_diameters_and_c_in_mm() {
        let camera = camera((-40.0, -20.0), (40.0, 20.0), 500.0, 500.0);
        assert!(labels(Axis::FaceX, &camera).contains("\u{2212}50 0 50"), "{}", labels(Axis::FaceX, &camera));
        assert!(labels(Axis::FaceC, &camera).contains("\u{2212}10 0 10"), "{}", labels(Axis::FaceC, &camera));
    }

    #[test]
    fn the_side_reads_degrees() {
        let radius = 30.0;
        let bounds = Bounds::around(Point::new(-30.0 * PI, -60.0), Point::new(30.0 * PI, 0.0));
        let axis = Axis::Around { radius };
        let camera = Camera::fit_with(bounds, Size { width: 300.0, height: 500.0 }, XPlus::Down);
        assert_eq!(labels(axis, &camera), "\u{2212}180 \u{2212}135 \u{2212}90 \u{2212}45 0 45 90 135 180");
        let tick =
            ticks(axis, &camera, Unit::Inch).into_iter().find(|tick| tick.label.as_deref() == Some("90"));
        let quarter = camera.to_screen(Point::new(radius * PI / 2.0, 0.0)).y;
        assert!((tick.expect("90").pixel - quarter).abs() < 1e-9 && quarter > 230.0);
        let mut near = camera;
        near.zoom(40.0, near.to_screen(Point::default()));
        assert!(labels(axis, &near).contains("\u{2212}1 0 1"), "{}", labels(axis, &near));
    }

    #[test]
    fn a_front_turret_reads_downwards() {
        let bounds = Bounds::around(Point::new(0.0, -60.0), Point::new(40.0, 10.0));
        let camera = Camera::fit_with(bounds, Size { width: 800.0, height: 500.0 }, XPlus::Down);
        assert_eq!(labels(Axis::X, &camera), "0 10 20 30 40 50 60 70 80");
        let tick = ticks(Axis::X, &camera, Unit::Millimetre)
            .into_iter()
            .find(|tick| tick.label.as_deref() == Some("80"));
        assert!((tick.expect("80").pixel - camera.to_screen(Point::new(40.0, 0.0)).y).abs() < 1e-9);
    }

    #[test]
    fn labels_have_no_noise() {
        let camera = camera((10.0, -0.3), (10.1, 0.1), 800.0, 500.0);
        assert!(!labels(Axis::Z, &Camera::fit(camera.seen(), camera.size())).contains("00000"));
        let mut near = camera;
        near.zoom(8.0, near.to_screen(Point::new(10.0, 0.0)));
        assert!(labels(Axis::Z, &near).contains("\u{2212}0.05 0.00 0.05"), "{}", labels(Axis::Z, &near));
    }

    #[test]
    fn steps_are_round() {
        let step = |least: f64| {
            let step = Step::at_least(least);
            (step.digit, step.power)
        };
        assert_eq!(step(1.0), (1, 0));
        assert_eq!(step(1.1), (2, 0));
        assert_eq!(step(3.0), (5, 0));
        assert_eq!(step(7.0), (1, 1));
        assert_eq!(step(0.1), (1, -1));
        assert_eq!(step(0.02), (2, -2));
        assert_eq!(step(0.04), (5, -2));
        assert_eq!(Step { digit: 2, power: -2 }.label(-3), "\u{2212}0.06");
        assert_eq!(Step { digit: 5, power: 2 }.label(3), "1500");
    }

    #[test]
    fn ticks_are_few_at_any_scale() {
        let mut camera = camera((0.0, -60.0), (40.0, 10.0), 800.0, 500.0);
        for factor in [1e-9, 3.0, 7.0, 11.0, 100.0, 1e9] {
            camera.zoom(factor, Pixel::new(400.0, 200.0));
            for axis in [Axis::Z, Axis::X] {
                let ticks = ticks(axis, &camera, Unit::Millimetre);
                assert!((4..=80).contains(&ticks.len()), "{factor} {axis:?} {}", ticks.len());
                assert!(ticks.iter().any(|tick| tick.label.is_some()));
            }
        }
        let none = Camera::fit(Bounds::of(Point::default()), Size { width: 0.0, height: 0.0 });
        assert!(ticks(Axis::Z, &none, Unit::Millimetre).is_empty());
    }
}
