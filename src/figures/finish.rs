//! What single cycles make in the end: the finished diameter, and the cone of a taper with its drawing.
//!
//! In: a call of a cycle, and the blank. Out: annotations. G90 shows the height of the cone over its length; G94 shows the
//! material that remains if R is only the length of the cone in the drawing (seed 004).

use super::cycle::{Call, SAME_DEPTH};
use crate::cycles::single::{Single, Work, cuts_along_x};
use crate::geometry::{Point, at_share};
use crate::motion::{Motion, Step};
use crate::scene::annotation::{Annotation, Importance, Label, Measure, Shape};
use crate::setup::Stock;
use crate::units::Diameter;

impl Call {
    /// Moves the diameter of the end point to the last of adjacent calls: a drawing has the finished diameter.
    pub fn finish_diameter(&self, all: &mut [Annotation]) {
        let Some(finish) = self.finish else { return };
        let is_facing = cuts_along_x(self.cycle);
        for own in all {
            if let (Shape::Diameter(at), Some(Measure::Diameter(_))) = (&own.shape, own.label.value) {
                let place = if is_facing { finish.to } else { Point::new(finish.to.x, at.z) };
                *own = diameter(place);
            }
        }
    }

    /// Where the cone of the finished taper meets the blank: G94 at its diameter, G90 at its face. `stock`: the given
    /// blank.
    pub fn corner_of_taper(&self, stock: impl FnOnce() -> Option<Stock>) -> Vec<Annotation> {
        let Some(cut) = self.finish.as_ref().or(self.step(Step::Cut)) else { return Vec::new() };
        let (x, z) = (cut.to.x - cut.from.x, cut.to.z - cut.from.z);
        if x.abs() < SAME_DEPTH || z.abs() < SAME_DEPTH {
            return Vec::new();
        }
        let work = Single::of(self.cycle).map(Single::work);
        let share = match work {
            Some(Work::Facing) => stock().map(|stock| (stock.diameter.radius() - cut.from.x) / x),
            Some(Work::Turning) => stock().map(|stock| (stock.face - cut.from.z) / z),
            _ => None,
        };
        let share = share.filter(|share| (SAME_DEPTH..1.0 - SAME_DEPTH).contains(share));
        let Some(at) = share.map(|share| at_share([cut.from, cut.to], share)) else { return Vec::new() };
        let mut all = vec![diameter(at)];
        match work {
            Some(Work::Facing) => all.extend(undercut(cut, at)),
            _ => all.extend(height_over_length(cut, at)),
        }
        all.retain(|own| own.shape.is_visible());
        all
    }
}

/// The drawing of the cone of G94 with its length, and the material that a cut with this length as R would leave: this cut
/// starts at G, above the corner C, and enters the blank at a shorter distance from the face. `at`: C.
fn undercut(cut: &Motion, at: Point) -> [Annotation; 5] {
    let end = cut.to;
    let start = Point::new(cut.from.x, at.z);
    let surface = at_share([start, end], (at.x - start.x) / (end.x - start.x));
    let length = at.z - end.z;
    // At its wide end, away from the arrow in the middle of the cut.
    let mark = at_share([at_share([at, surface], 0.5), end], 0.2);
    let zone = Shape::Zone { outline: vec![at, end, surface], way: [start, end], mark };
    let label = Label::of("", Some(Measure::Coordinate('R', length)));
    let entered = Shape::Axial([Point::new(surface.x, end.z), surface]);
    // Below the axis, where there are no strokes.
    let drawn = Shape::Axial([end.z, at.z].map(|z| Point::new(-at.x, z)));
    [
        Annotation::point(at, "C"),
        Annotation::point(start, "G"),
        below_axis(drawn, length),
        Annotation::dimension(entered, "", Measure::Length((surface.z - end.z).abs())),
        Annotation { shape: zone, label, importance: Importance::Usual },
    ]
}

/// The height and the length of a cone, below the axis, where there are no strokes. `at`: its end at the face.
fn height_over_length(cut: &Motion, at: Point) -> [Annotation; 2] {
    let [corner, end] = [at, cut.to].map(|at| Point::new(-at.x, at.z));
    let across = Shape::Radial([corner, Point::new(end.x, corner.z)]);
    let along = Shape::Axial([corner, end]);
    [below_axis(across, end.x - corner.x), below_axis(along, end.z - corner.z)]
}

/// A length below the axis. In a window, only the half above the axis may be visible.
fn below_axis(shape: Shape, mm: f64) -> Annotation {
    Annotation { importance: Importance::Low, ..Annotation::dimension(shape, "", Measure::Length(mm.abs())) }
}

fn diameter(at: Point) -> Annotation {
    let value = Measure::Diameter(Diameter::from_radius(at.x).mm());
    Annotation::dimension(Shape::Diameter(at), "", value)
}
