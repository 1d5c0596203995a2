//! The profile of the part for CAD programs: text DXF of AutoCAD release 12, in mm.
//!
//! In: the half-section and its dimensions. Out: lines and true arcs on the layer `PROFILE`, the spindle axis on
//! the layer `CENTER`, lines, arrows and texts on the layer `DIMENSIONS`. X of the drawing is Z of the lathe, Y is
//! the radius.

use std::fmt::{Display, Write};

use super::profile::{self, Segment};
use crate::geometry::bounds::{Bounds, join};
use crate::geometry::{Arc, Point, Turn};
use crate::machine::region::Region;
use crate::scene::annotation::Annotation;
use crate::scene::camera::{Camera, Pixel, Size, XPlus};
use crate::scene::occupied::Occupied;
use crate::scene::placement::{FONT_SIZE, place};
use crate::units::Unit;

/// Length of the centre line beyond the part at each end, as usual in drawings, mm.
const CENTER_LINE_OVER: f64 = 3.0;

/// Width of the picture in which the dimensions are placed, CSS pixels; their size on paper follows from it.
const WIDTH: f64 = 960.0;
/// Space for dimensions around the part in that picture, as a share of its length.
const ROOM: f64 = 0.15;

/// The half-section above the spindle axis as a drawing, with dimensions; `None` if nothing is left of the blank.
pub fn dxf(region: &Region, dimensions: &[Annotation]) -> Option<String> {
    let chains = profile::outlines(region);
    let bounds = chains.iter().flatten().fold(None, |bounds, segment| join(bounds, Some(around(segment))))?;
    let (left, right) = (bounds.min.z - CENTER_LINE_OVER, bounds.max.z + CENTER_LINE_OVER);
    let mut file = File { text: String::new() };
    file.head(Point::new(0.0, left), Point::new(bounds.max.x, right));
    file.tables();
    file.pair(0, "SECTION");
    file.pair(2, "ENTITIES");
    for segment in chains.iter().flatten() {
        match segment {
            Segment::Line(from, to) => file.line("PROFILE", *from, *to),
            Segment::Arc(arc) => file.arc("PROFILE", arc),
        }
    }
    file.line("CENTER", Point::new(0.0, left), Point::new(0.0, right));
    file.dimensions(region, bounds, dimensions);
    file.pair(0, "ENDSEC");
    file.pair(0, "EOF");
    Some(file.text)
}

fn around(segment: &Segment) -> Bounds {
    match segment {
        Segment::Line(from, to) => Bounds::around(*from, *to),
        Segment::Arc(arc) => Bounds::of_arc(arc),
    }
}

/// The file being written: pairs of a group code and a value, each on a separate line.
struct File {
    text: String,
}

impl File {
    fn pair(&mut self, code: u16, value: impl Display) {
        let _ = write!(self.text, "{code:>3}\r\n{value}\r\n");
    }

    /// Writes a length in mm or an angle in degrees, rounded to 1e-6.
    fn number(&mut self, code: u16, value: f64) {
        let rounded = (value * 1e6).round() / 1e6 + 0.0;
        self.pair(code, format_args!("{rounded:.6}"));
    }

    /// Writes a point, with `code` for X, `code` + 10 for Y and `code` + 20 for Z.
    fn point(&mut self, code: u16, at: Point) {
        self.number(code, at.z);
        self.number(code + 10, at.x);
        self.number(code + 20, 0.0);
    }

    fn head(&mut self, low: Point, high: Point) {
        self.pair(0, "SECTION");
        self.pair(2, "HEADER");
        self.pair(9, "$ACADVER");
        self.pair(1, "AC1009");
        for (name, at) in [("$EXTMIN", low), ("$EXTMAX", high)] {
            self.pair(9, name);
            self.point(10, at);
        }
        self.pair(0, "ENDSEC");
    }

    fn tables(&mut self) {
        self.pair(0, "SECTION");
        self.pair(2, "TABLES");
        self.table("LTYPE", 2);
        self.line_type("CONTINUOUS", "Solid line", &[]);
        self.line_type("CENTER", "____ _ ____ _ ____", &[6.0, -1.0, 1.0, -1.0]);
        self.pair(0, "ENDTAB");
        self.table("LAYER", 4);
        for (name, colour, line_type) in [
            ("0", 7, "CONTINUOUS"),
            ("PROFILE", 7, "CONTINUOUS"),
            ("CENTER", 1, "CENTER"),
            ("DIMENSIONS", 3, "CONTINUOUS"),
        ] {
            self.pair(0, "LAYER");
            self.pair(2, name);
            self.pair(70, 0);
            self.pair(62, colour);
            self.pair(6, line_type);
        }
        self.pair(0, "ENDTAB");
        self.pair(0, "ENDSEC");
    }

    fn table(&mut self, name: &str, rows: usize) {
        self.pair(0, "TABLE");
        self.pair(2, name);
        self.pair(70, rows);
    }

    /// Defines a line type. Dashes in mm; negative values are gaps.
    fn line_type(&mut self, name: &str, looks: &str, dashes: &[f64]) {
        self.pair(0, "LTYPE");
        self.pair(2, name);
        self.pair(70, 0);
        self.pair(3, looks);
        self.pair(72, 65);
        self.pair(73, dashes.len());
        self.number(40, dashes.iter().map(|dash| dash.abs()).sum());
        for dash in dashes {
            self.number(49, *dash);
        }
    }

    /// Writes dimensions as lines, filled arrow heads and texts, which every program reads in the same way.
    fn dimensions(&mut self, region: &Region, part: Bounds, dimensions: &[Annotation]) {
        if dimensions.is_empty() {
            return;
        }
        let both = Bounds::around(Point::new(-part.max.x, part.min.z), part.max);
        let bounds = both.grown(ROOM * both.length().max(both.height()));
        let height = Camera::height_for(bounds, WIDTH, WIDTH / 4.0, WIDTH * 4.0);
        let camera = Camera::fit_with(bounds, Size { width: WIDTH, height }, XPlus::Up);
        let placed = place(dimensions, &Occupied::of_part(region, &camera), &camera, Unit::Millimetre);
        let at = |pixel: Pixel| camera.to_world(pixel);
        for ends in placed.lines.iter().flat_map(|line| line.windows(2)) {
            self.line("DIMENSIONS", at(ends[0]), at(ends[1]));
        }
        for head in &placed.heads {
            self.pair(0, "SOLID");
            self.pair(8, "DIMENSIONS");
            let [tip, left, right] = head.map(at);
            for (code, corner) in [(10, tip), (11, left), (12, right), (13, right)] {
                self.point(code, corner);
            }
        }
        for label in &placed.labels {
            let middle = at(label.area.middle());
            self.pair(0, "TEXT");
            self.pair(8, "DIMENSIONS");
            self.point(10, middle);
            self.number(40, 0.7 * FONT_SIZE / camera.scale());
            self.pair(1, in_ascii(&label.text));
            // Centred at the second point.
            self.pair(72, 1);
            self.point(11, middle);
            self.pair(73, 2);
        }
    }

    fn line(&mut self, layer: &str, from: Point, to: Point) {
        self.pair(0, "LINE");
        self.pair(8, layer);
        self.point(10, from);
        self.point(11, to);
    }

    /// Writes an arc. Arcs in DXF are always counter-clockwise.
    fn arc(&mut self, layer: &str, arc: &Arc) {
        let (from, to) = match arc.turn {
            Turn::Counterclockwise => (arc.start_angle(), arc.end_angle()),
            Turn::Clockwise => (arc.end_angle(), arc.start_angle()),
        };
        self.pair(0, "ARC");
        self.pair(8, layer);
        self.point(10, arc.center);
        self.number(40, arc.radius());
        self.number(50, from.to_degrees().rem_euclid(360.0));
        self.number(51, to.to_degrees().rem_euclid(360.0));
    }
}

/// A label in ASCII, with the codes of DXF for diameter and degree.
fn in_ascii(text: &str) -> String {
    text.replace('Ø', "%%c").replace('°', "%%d").replace('−', "-").replace('×', "x")
}
