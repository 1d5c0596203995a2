//! A bar or a tube, and the sizes that comments describe.

use crate::geometry::Point;
use crate::units::Diameter;

/// A bar or a tube, and the length of it in the chuck.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stock {
    /// Outside diameter, mm.
    pub diameter: Diameter,
    /// Bore diameter, mm; 0 for a solid bar.
    pub bore: Diameter,
    /// Z of the front face, mm.
    pub face: f64,
    /// Length from the face towards −Z, mm.
    pub length: f64,
    /// Clamping length from the back, mm; without it there are no jaws.
    pub grip: Option<f64>,
}

/// The sizes of a blank described by prose.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DescribedStock {
    /// Outside diameter, mm.
    pub diameter: Option<Diameter>,
    /// Length, mm.
    pub length: Option<f64>,
}

impl DescribedStock {
    /// The inferred blank with the described sizes, if they fit the cuts. Other sizes describe the part.
    pub fn applied_to(self, inferred: Stock) -> Stock {
        /// Least and greatest ratio of a described size to the inferred one.
        const DIAMETERS: [f64; 2] = [0.9, 2.0];
        const LENGTHS: [f64; 2] = [0.83, 3.0];
        let suits = |size: f64, inferred: f64, [least, most]: [f64; 2]| {
            (least * inferred..=most * inferred).contains(&size)
        };
        let diameter = self.diameter.filter(|own| suits(own.mm(), inferred.diameter.mm(), DIAMETERS));
        let length = self.length.filter(|&own| suits(own, inferred.length, LENGTHS));
        Stock {
            diameter: diameter.unwrap_or(inferred.diameter),
            length: length.unwrap_or(inferred.length),
            ..inferred
        }
    }
}

impl Stock {
    /// The blank in shifted coordinates. A solid bar stays solid.
    pub fn moved(self, by: Point) -> Self {
        let radially = |own: Diameter| Diameter::from_radius(own.radius() + by.x);
        let bore = if self.bore.mm() == 0.0 { self.bore } else { radially(self.bore) };
        Self { diameter: radially(self.diameter), bore, face: self.face + by.z, ..self }
    }

    /// Z of the back, mm.
    pub fn back(&self) -> f64 {
        self.face - self.length
    }
}

/// Below this feed, mm/rev, sliding-head lathes turn small parts to size in one pass, however deep.
pub const ONE_PASS_FEED: f64 = 0.06;

/// Greatest depth of a pass in a workpiece of this radius, mm, both as a radius: a thick bar bears more, and
/// is turned on a larger lathe. Twice the usual depth, since deeper roughing is intended.
pub fn deepest_cut(radius: f64) -> f64 {
    (radius / 4.0).clamp(6.0, 15.0)
}
