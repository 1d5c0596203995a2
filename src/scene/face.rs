//! The end face: what polar interpolation (G12.1) makes of it, in a picture of its own.
//!
//! In: the motions of a run and the simulation. Out: [`Face`], whose [`Scene`] is drawn, picked in and
//! exported as the section is: the moves of the virtual plane, as a list of motions of their own, and the
//! area that live cutters sweep. Points have C in `x` (upwards) and X in `z` (to the right), mm, seen from
//! the tailstock. Must not know of canvases.

use std::f64::consts::TAU;

use super::path_index::PathIndex;
use super::work::{ToolOutline, Work};
use super::{Place, Plane, Scene, StrokeShape};
use crate::geometry::bounds::{Bounds, join};
use crate::geometry::virtual_plane::{Surface, VirtualMove, Way};
use crate::geometry::{Point, Turn, within};
use crate::machine::SimulationResult;
use crate::machine::region::Region;
use crate::machine::resolved_setup::ResolvedTool;
use crate::machine::sweep::{self, way_of};
use crate::motion::{Chunk, Motion, MotionKind, Motions};
use crate::playback::clock::Playhead;
use crate::setup::Stock;

/// Most moves whose swept area is worked out; of more only the paths are drawn.
const MOST_SWEPT: usize = 2000;

/// Corners that a circle is drawn with.
const CORNERS: u32 = 256;

/// The end face and what moves over it.
#[derive(Clone, Debug)]
pub struct Face {
    /// The moves, in the plane of the face.
    motions: Motions,
    path_index: PathIndex,
    /// For each of them the motion of the run it is.
    of: Vec<usize>,
    /// For each of them what its cutter sweeps, where its radius is known and it cuts.
    cutters: Vec<Option<f64>>,
    /// For each of them the box in the section that its cutter reaches, where it cuts.
    reached: Vec<Option<Bounds>>,
}

impl Face {
    /// The face of a program; nothing where no motion moves in it.
    pub fn of(motions: &Motions, simulation: &SimulationResult) -> Option<Self> {
        let stock = simulation.resolved_setup().stock().map(|(stock, _)| stock);
        let face_of_stock = stock.map_or(f64::INFINITY, |stock| stock.face);
        let (mut of, mut cutters, mut reached) = (Vec::new(), Vec::new(), Vec::new());
        let mut own: Option<Chunk> = None;
        let mut index = 0;
        for chunk in motions.chunks() {
            for at in 0..chunk.len() {
                let motion = chunk.get(at);
                let place = index;
                index += 1;
                let Some(moved) = motion.virtual_move().filter(|moved| moved.surface == Surface::Face) else {
                    continue;
                };
                let flat = in_plane(&motion, &moved);
                own.get_or_insert_with(|| Chunk::new(0, 0, flat.from)).push(
                    &flat,
                    chunk.span(at),
                    chunk.line(at),
                );
                of.push(place);
                let cuts = moved.third.0.min(moved.third.1) < face_of_stock;
                let cutter = cutter_radius(simulation.resolved_setup().tool(&motion)).filter(|_| cuts);
                cutters.push(cutter);
                reached.push(cutter.zip(stock).map(|(radius, stock)| reach(&moved, radius, &stock)));
            }
        }
        let mut list = Motions::default();
        list.push(own?);
        let path_index = PathIndex::of(&list);
        Some(Self { motions: list, path_index, of, cutters, reached })
    }

    /// The picture.
    pub fn scene<'a>(&'a self, work: Option<&'a Work>) -> Scene<'a> {
        Scene::new(&self.motions, &self.path_index, work).on(Plane::Face)
    }

    /// The motion of the run that a move of this picture is.
    pub fn motion(&self, own: usize) -> Option<usize> {
        self.of.get(own).copied()
    }

    /// The move of this picture that a motion of the run is.
    pub fn own(&self, motion: usize) -> Option<usize> {
        self.of.binary_search(&motion).ok()
    }

    /// The playhead of this picture, when the tool is at a place of the run: on one of its
    /// moves, or before the next one.
    pub fn playhead(&self, place: Place) -> Playhead {
        let motion = self.of.partition_point(|&motion| motion < place.motion);
        let share = self.own(place.motion).map_or(0.0, |_| place.fraction);
        Playhead { motion, share }
    }

    /// The box in the section that cutters reach in the motions of the run before `until`; nothing where they cut nothing.
    pub fn milled(&self, until: usize) -> Option<Bounds> {
        let count = self.of.partition_point(|&motion| motion < until);
        self.reached[..count].iter().fold(None, |all, own| join(all, *own))
    }

    /// Blank, what is left of the face, and the cutter: when all is done, or with the
    /// tool at a place of the run.
    pub fn work(&self, simulation: &SimulationResult, place: Option<Place>) -> Option<Work> {
        let (stock, basis) = simulation.resolved_setup().stock()?;
        let mut blank = Region::inside(&circle(stock.diameter.radius()));
        if stock.bore.mm() > 0.0 {
            blank.cut(&[circle(stock.bore.radius())]);
        }
        let until = place.map_or(self.of.len(), |at| self.of.partition_point(|&motion| motion < at.motion));
        let mut left = blank.clone();
        left.cut(&self.swept(until, place));
        let own = place.and_then(|at| Some((at, self.own(at.motion)?)));
        let tool = own.and_then(|(at, own)| {
            let tip = self.scene(None).stroke(own)?.shape.at(at.fraction);
            let radius = self.cutters[own]?;
            let edge = sweep::Outline::around(circle(radius)).at(tip);
            Some(ToolOutline { edge, body: None, tip })
        });
        Some(Work::on_face(&blank, &left, basis, tool, stock.diameter.radius()))
    }

    /// What the cutters sweep in the moves before `until`, and in a part of the next one.
    fn swept(&self, until: usize, place: Option<Place>) -> Vec<Vec<Point>> {
        if self.of.len() > MOST_SWEPT {
            return Vec::new();
        }
        let mut swept = Vec::new();
        let mut cutter: Option<(f64, sweep::Outline)> = None;
        for index in 0..self.of.len().min(until + 1) {
            let Some(radius) = self.cutters[index] else { continue };
            let mut motion = self.motions.get(index);
            if index == until {
                let Some(at) = place.filter(|at| self.of[index] == at.motion && at.fraction > 0.0) else {
                    continue;
                };
                motion = motion.first_part(at.fraction);
            }
            let outline = match cutter.take() {
                Some((own, outline)) if own == radius => outline,
                _ => sweep::Outline::around(circle(radius)),
            };
            swept.extend(outline.along(&way_of(&motion)));
            cutter = Some((radius, outline));
        }
        swept
    }
}

/// A motion as it runs in the plane of the face.
fn in_plane(motion: &Motion, moved: &VirtualMove) -> Motion {
    let (kind, from, to, center) = match moved.way {
        Way::Line(from, to) => (MotionKind::Feed, from, to, None),
        Way::Arc(arc) => {
            let kind = match arc.turn {
                Turn::Clockwise => MotionKind::ArcClockwise,
                Turn::Counterclockwise => MotionKind::ArcCounterclockwise,
            };
            (kind, arc.start, arc.end, Some(arc.center))
        }
    };
    let kind = if motion.kind == MotionKind::Dwell { MotionKind::Dwell } else { kind };
    Motion { kind, from, to, center, rotary: None, lead: None, cycle: None, ..*motion }
}

/// The radius of a live cutter, mm, where somebody has said it.
fn cutter_radius(resolved_tool: &ResolvedTool) -> Option<f64> {
    let tool = &resolved_tool.tool;
    let radius = tool.cutter_radius().or(tool.geometry_r)?;
    (radius > 0.0 && radius.is_finite()).then_some(radius)
}

/// Where a cutter reaches in a move, as radius and Z, within the stock.
fn reach(moved: &VirtualMove, radius: f64, stock: &Stock) -> Bounds {
    let path = StrokeShape::Virtual(*moved).bounds();
    let edge = stock.diameter.radius();
    let [low, high] = [path.min.x - radius, path.max.x + radius].map(|x| within(x, 0.0, edge));
    let back = path.min.z.max(stock.back());
    Bounds { min: Point::new(low, back), max: Point::new(high, stock.face) }
}

/// A circle about the origin as a polygon, counter-clockwise.
fn circle(radius: f64) -> Vec<Point> {
    let corner = |index: u32| {
        let angle = TAU * f64::from(index) / f64::from(CORNERS);
        Point::new(radius * angle.sin(), radius * angle.cos())
    };
    (0..CORNERS).map(corner).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analyze;
    use crate::setup::Setup;

    const SETUP: &str = r#"{"stock": {"diameter": 80, "length": 60},
        "tools": {"T0101": {"type": "endmill", "toolRadius": 10, "geometryR": 10}}}"#;
    const SQUARE: &str = "T0101\nG97 S100 M13\nG00 X80 Z30\nG98 G01 Z-20 F100\nG12.1\nG42 X50\nC25\nX-50\nC-25\nX50\nC0\n\
        G40 X100\nG13.1\nG00 X120";

    fn face(program: &str) -> (Face, SimulationResult) {
        let setup = Setup::from_json(SETUP).expect("a setup");
        let analysis = analyze(program.as_bytes(), &setup);
        let simulation = SimulationResult::of(&analysis.motions, &setup);
        (Face::of(&analysis.motions, &simulation).expect("a face"), simulation)
    }

    #[test]
    fn a_square_is_a_square() {
        let (face, simulation) = face(SQUARE);
        let work = face.work(&simulation, None).expect("a blank");
        let mut middle = Region::default();
        for outline in &work.part {
            if outline.iter().all(|at| at.x.hypot(at.z) < 36.0) {
                middle = Region::inside(outline);
            }
        }
        assert!((middle.area() - 2500.0).abs() < 1e-3, "{}", middle.area());
        let lines: Vec<u32> = face.scene(None).strokes().map(|stroke| stroke.line + 1).collect();
        assert_eq!(lines, [6, 7, 8, 9, 10, 11, 12]);
        // The programmed path is the square, the cutter's centre goes 10 mm outside of it.
        let bounds = |shapes: &mut dyn Iterator<Item = super::super::StrokeShape>| {
            shapes.map(|shape| shape.bounds()).reduce(|a, b| a.union(b)).expect("shapes")
        };
        let programmed = bounds(&mut face.scene(None).programmed());
        assert!((programmed.min.z + 25.0).abs() < 1e-6 && (programmed.max.x - 25.0).abs() < 1e-6);
        let cut = bounds(&mut face.scene(None).strokes().map(|stroke| stroke.shape));
        assert!((cut.min.z + 35.0).abs() < 1e-6 && (cut.max.x - 35.0).abs() < 1e-6);
    }

    #[test]
    fn the_tool_is_where_it_is_in_the_section() {
        let (face, simulation) = face(SQUARE);
        let third = face.motion(2).expect("a motion");
        let place = Place { motion: third, fraction: 0.5, at: Point::default() };
        let tool = face.work(&simulation, Some(place)).and_then(|work| work.tool).expect("a tool");
        assert!(tool.tip.is_same(Point::new(35.0, 0.0)), "{:?}", tool.tip);
        assert_eq!(face.playhead(place), Playhead { motion: 2, share: 0.5 });
        let before = Place { motion: 0, fraction: 0.3, at: Point::default() };
        assert_eq!(face.playhead(before), Playhead::START);
        let work = face.work(&simulation, Some(before)).expect("a blank");
        assert!(work.tool.is_none() && work.part == work.blank);
    }

    #[test]
    fn only_polar_moves_are_on_the_face() {
        let setup = Setup::from_json(SETUP).expect("a setup");
        let analysis = analyze(b"T0101\nG00 X62 Z2\nG98 G01 Z-20 F100", &setup);
        assert!(Face::of(&analysis.motions, &SimulationResult::of(&analysis.motions, &setup)).is_none());
    }
}
