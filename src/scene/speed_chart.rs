//! The spindle speed over the diameter, for a program that sets speeds.
//!
//! In: cutting speeds with their limits. Out: [`SpeedChart`], drawn like the moves over a surface: the diameter to the
//! right, the speed upwards.

use std::f64::consts::PI;

use super::Plane;
use super::ruler::Axis;
use super::surface_moves::{Gathered, Origin, SurfaceMoves};
use crate::control::modal::Spindle;
use crate::geometry::Point;
use crate::motion::{Motion, MotionKind, Process};
use crate::source::Span;
use crate::units::Diameter;

/// A constant surface speed with its limits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Curve {
    /// The spindle under G96.
    pub spindle: Spindle,
    /// Feed, spindle and tool in force.
    pub process: Process,
    /// The block that sets it, and its line, from 0.
    pub block: (Span, u32),
}

impl Curve {
    /// Spindle speed at a diameter in mm, rpm; 0 at the axis without a limit.
    pub fn speed(&self, diameter: f64) -> f64 {
        self.spindle.speed_at(Diameter::new(diameter).radius()).unwrap_or(0.0)
    }

    /// The diameters below `end` at which a limit begins to hold, mm: of the highest, then of the lowest speed.
    pub fn limits_until(&self, end: f64) -> impl Iterator<Item = f64> {
        let Spindle { cutting_speed, highest, lowest, .. } = self.spindle;
        let limits = [highest, lowest].into_iter().flatten();
        limits.map(move |limit| 1000.0 * cutting_speed / (PI * limit)).filter(move |at| *at < end)
    }
}

/// The chart.
#[derive(Clone, Debug)]
pub struct SpeedChart {
    moves: SurfaceMoves,
    /// Speed for each mm of the picture, rpm.
    scale: f64,
}

/// Height of the chart as a share of its width.
const HEIGHT: f64 = 0.6;
/// Number of pieces of a curve.
const PIECES: u32 = 96;
/// Without a limit, curves begin at this share of the largest diameter.
const FIRST: f64 = 0.1;

impl SpeedChart {
    /// The chart of curves up to a diameter, mm; `None` without a curve.
    pub fn of(curves: &[Curve], diameter: f64) -> Option<Self> {
        let start = |curve: &Curve| if curve.spindle.highest.is_some() { 0.0 } else { FIRST * diameter };
        let top = |curve: &Curve| curve.speed(start(curve).max(1e-6));
        let highest = curves.iter().map(top).fold(0.0, f64::max);
        let scale = Some(highest / (HEIGHT * Diameter::new(diameter).radius()))
            .filter(|scale| *scale > 0.0 && scale.is_finite())?;
        let mut gathered = Gathered::default();
        for curve in curves {
            let from = start(curve);
            let step = (diameter - from) / f64::from(PIECES);
            let steps = (0..=PIECES).map(|piece| from + step * f64::from(piece));
            let limits = curve.limits_until(diameter).filter(|at| *at > from);
            let mut diameters: Vec<f64> = steps.chain(limits).collect();
            diameters.sort_by(f64::total_cmp);
            let place = |at: f64| Point::new(curve.speed(at.max(1e-6)) / scale, Diameter::new(at).radius());
            for ends in diameters.windows(2) {
                let process =
                    Process { zero: Point::default(), tip_shift: Point::default(), ..curve.process };
                let [from, to] = [ends[0], ends[1]].map(place);
                let motion = Motion::straight(MotionKind::Feed, from, to, process);
                let origin = Origin { motion: gathered.len(), shares: [0.0, 1.0], cutter: None };
                gathered.push(&motion, curve.block, origin);
            }
        }
        let moves = gathered.finish(Plane::Face, [Axis::FaceX, Axis::Speed { scale }])?;
        Some(Self { moves, scale })
    }

    /// The curves.
    pub fn moves(&self) -> &SurfaceMoves {
        &self.moves
    }

    /// The place of a speed in rpm at a diameter in mm.
    pub fn place(&self, diameter: f64, speed: f64) -> Point {
        Point::new(speed / self.scale, Diameter::new(diameter).radius())
    }
}
