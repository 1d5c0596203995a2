//! The picture of the end face: milling with polar interpolation (G12.1) or the Y axis, and holes of live
//! drills.
//!
//! In: the motions of a run and the simulation. Out: [`Face`]: the moves of the virtual plane, the moves
//! along Y and the holes off the axis, as [`SurfaceMoves`], and the area swept by live tools. Points have C
//! or Y in `x` (upwards) and X in `z` (to the right), mm, seen from the tailstock. Must not know of canvases.

use super::ruler::Axis;
use super::surface_moves::{Gathered, Origin, Passed, SurfaceMoves, circle, cutter_radius, on_way, passed};
use super::work::Work;
use super::{Place, Plane, StrokeShape};
use crate::geometry::bounds::{Bounds, join};
use crate::geometry::virtual_plane::{Flat, Surface, VirtualMove, Way};
use crate::geometry::{Point, SAME, within};
use crate::machine::SimulationResult;
use crate::machine::region::Region;
use crate::machine::resolved_setup::ResolvedTool;
use crate::motion::{CycleFamily, Motion, MotionKind, Motions};
use crate::setup::Stock;

/// The end face and the moves over it.
#[derive(Clone, Debug)]
pub struct Face {
    moves: SurfaceMoves,
    /// For each move, the box in the section that its cutter reaches; `None` if it does not cut.
    reached: Vec<Option<Bounds>>,
}

impl Face {
    /// The face of a program; `None` if no motion is in it.
    pub fn of(motions: &Motions, simulation: &SimulationResult) -> Option<Self> {
        let stock = simulation.resolved_setup().stock().map(|(stock, _)| stock);
        let face_of_stock = stock.map_or(f64::INFINITY, |stock| stock.face);
        let (mut moves, mut reached) = (Gathered::default(), Vec::new());
        // The vertical axis: C, or Y if nothing moves in the plane of X and C.
        let mut up = Axis::Y;
        let drills = simulation.resolved_setup().has_live_drill();
        for Passed { index, motion, block, c } in passed(motions, simulation.resolved_setup()) {
            let milled = motion.virtual_move().and_then(|moved| moved.over_face());
            if milled.is_none() && motion.cycle.is_none() && !drills {
                continue;
            }
            let tool = simulation.resolved_setup().tool(&motion);
            let hole = || hole(&motion, tool, c);
            let Some((moved, flat)) = milled.map(|moved| (moved, on_way(&motion, &moved.way))).or_else(hole)
            else {
                continue;
            };
            if !motion.virtual_move().is_some_and(|moved| moved.has_y()) {
                up = Axis::FaceC;
            }
            let cuts = motion.kind.cuts() && moved.third.0.min(moved.third.1) < face_of_stock;
            let cutter = cutter_radius(tool).filter(|_| cuts && is_seen_from_above(&motion));
            moves.push(&flat, block, Origin { motion: index, shares: [0.0, 1.0], cutter });
            // A box around holes all around the axis would look like a flat.
            let cutter = cutter.filter(|_| milled.is_some());
            reached.push(cutter.zip(stock).map(|(radius, stock)| reach(&moved, radius, &stock)));
        }
        Some(Self { moves: moves.finish(Plane::Face, [Axis::FaceX, up])?, reached })
    }

    /// The moves over the face.
    pub fn moves(&self) -> &SurfaceMoves {
        &self.moves
    }

    /// The box in the section that cutters reach in the motions of the run before `until`; `None` if they cut
    /// nothing.
    pub fn milled(&self, until: usize) -> Option<Bounds> {
        let count = self.moves.before(until);
        self.reached[..count].iter().fold(None, |all, own| join(all, *own))
    }

    /// The blank, the rest of the face, and the cutter: at a position in the run, or at its end.
    pub fn work(&self, simulation: &SimulationResult, place: Option<Place>) -> Option<Work> {
        let (stock, basis) = simulation.resolved_setup().stock()?;
        let mut blank = Region::inside(&circle(stock.diameter.radius()));
        if stock.bore.mm() > 0.0 {
            blank.cut(&[circle(stock.bore.radius())]);
        }
        let mut left = blank.clone();
        left.cut(&self.moves.swept(place));
        let tool = place.and_then(|place| self.moves.tool(place));
        Some(Work::on_face(&blank, &left, basis, tool, stock.diameter.radius()))
    }
}

/// Whether the cutter of a motion points at the end face; under G19 it points at the side.
fn is_seen_from_above(motion: &Motion) -> bool {
    motion.virtual_move().is_none_or(|moved| matches!(moved.surface, Surface::Face | Surface::Flat(Flat::Xy)))
}

/// A cut into a hole off the axis with C at `c` degrees: as a move of the plane, and as the dot that is drawn
/// there.
fn hole(motion: &Motion, tool: &ResolvedTool, c: f64) -> Option<(VirtualMove, Motion)> {
    let is_hole = match motion.cycle {
        Some(step) => step.cycle.family() == CycleFamily::FaceHole,
        // Without a cycle: straight in.
        None => tool.is_live_drill() && motion.from.x == motion.to.x && motion.to.z < motion.from.z,
    };
    if !is_hole || !motion.kind.cuts() || motion.to.x <= SAME || !tool.is_live_in(motion) {
        return None;
    }
    let angle = c.to_radians();
    let at = Point::new(motion.to.x * angle.sin(), motion.to.x * angle.cos());
    let moved =
        VirtualMove { surface: Surface::Face, way: Way::Line(at, at), third: (motion.from.z, motion.to.z) };
    Some((moved, Motion { kind: MotionKind::Dwell, ..on_way(motion, &moved.way) }))
}

/// The area that a cutter reaches in a move, as radius and Z, within the stock.
fn reach(moved: &VirtualMove, radius: f64, stock: &Stock) -> Bounds {
    let path = StrokeShape::Virtual(*moved).bounds();
    let edge = stock.diameter.radius();
    let [low, high] = [path.min.x - radius, path.max.x + radius].map(|x| within(x, 0.0, edge));
    let back = path.min.z.max(stock.back());
    Bounds { min: Point::new(low, back), max: Point::new(high, stock.face) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analyze;
    use crate::playback::clock::Playhead;
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
        let lines: Vec<u32> = face.moves().scene(None).strokes().map(|stroke| stroke.line + 1).collect();
        assert_eq!(lines, [6, 7, 8, 9, 10, 11, 12]);
        // The programmed path is the square; the centre of the cutter moves 10 mm outside it.
        let bounds = |shapes: &mut dyn Iterator<Item = super::super::StrokeShape>| {
            shapes.map(|shape| shape.bounds()).reduce(|a, b| a.union(b)).expect("shapes")
        };
        let programmed = bounds(&mut face.moves().scene(None).programmed());
        assert!((programmed.min.z + 25.0).abs() < 1e-6 && (programmed.max.x - 25.0).abs() < 1e-6);
        let cut = bounds(&mut face.moves().scene(None).strokes().map(|stroke| stroke.shape));
        assert!((cut.min.z + 35.0).abs() < 1e-6 && (cut.max.x - 35.0).abs() < 1e-6);
    }

    #[test]
    fn the_tool_is_where_it_is_in_the_section() {
        let (face, simulation) = face(SQUARE);
        let third = face.moves().motion(2).expect("a motion");
        let place = Place { motion: third, fraction: 0.5, at: Point::default() };
        let tool = face.work(&simulation, Some(place)).and_then(|work| work.tool).expect("a tool");
        assert!(tool.tip.is_same(Point::new(35.0, 0.0)), "{:?}", tool.tip);
        assert_eq!(face.moves().playhead(place), Playhead { motion: 2, share: 0.5 });
        let before = Place { motion: 0, fraction: 0.3, at: Point::default() };
        assert_eq!(face.moves().playhead(before), Playhead::START);
        let work = face.work(&simulation, Some(before)).expect("a blank");
        assert!(work.tool.is_none() && work.part == work.blank);
    }

    /// Four holes of ⌀6 on ⌀40, a quarter turn apart, C0 to the right.
    #[test]
    fn holes_beside_the_axis_are_on_the_face() {
        let setup = r#"{"stock": {"diameter": 80, "length": 60}, "tools": {"T0202": {"type": "drill", "diameter": 6}}}"#;
        let setup = Setup::from_json(setup).expect("a setup");
        let program = "M45\nT0202\nG97 S1000 M13\nG00 X40 Z5 C0\nG98 G83 X40 C0 Z-12 R-3 F100\nC90\nC180\nC270\nG80\nG00 X100";
        let analysis = analyze(program.as_bytes(), &setup);
        let simulation = SimulationResult::of(&analysis.motions, &setup);
        let face = Face::of(&analysis.motions, &simulation).expect("a face");
        let ends: Vec<Point> = face.moves().scene(None).strokes().map(|stroke| stroke.shape.end()).collect();
        let expected = [(0.0, 20.0), (20.0, 0.0), (0.0, -20.0), (-20.0, 0.0)];
        assert_eq!(ends.len(), 4, "{ends:?}");
        assert!(ends.iter().zip(expected).all(|(at, (c, x))| at.is_same(Point::new(c, x))), "{ends:?}");
        let work = face.work(&simulation, None).expect("a blank");
        let area = |outlines: &[Vec<Point>]| {
            outlines.iter().map(|outline| Region::inside(outline).area()).sum::<f64>()
        };
        // The outline, and four holes in it, each a polygon of 256 corners.
        assert_eq!(work.part.len(), 5);
        let holes = area(&work.part) - area(&work.blank);
        assert!((holes - 4.0 * std::f64::consts::PI * 9.0).abs() < 0.1, "{holes}");
        assert!(face.milled(usize::MAX).is_none());
        // The same holes without a cycle.
        let program = "M45\nT0202\nG97 S1000 M13\nG00 X40 Z5 C0\nG98 G01 Z-12 F100\nG00 Z5\nC90\nG01 Z-12\nG00 Z5\nX100";
        let analysis = analyze(program.as_bytes(), &setup);
        let simulation = SimulationResult::of(&analysis.motions, &setup);
        let face = Face::of(&analysis.motions, &simulation).expect("a face");
        let ends: Vec<Point> = face.moves().scene(None).strokes().map(|stroke| stroke.shape.end()).collect();
        assert!(ends.len() == 2 && ends[1].is_same(Point::new(20.0, 0.0)), "{ends:?}");
        assert!(simulation.findings().is_empty());
        assert_eq!(simulation.finished().expect("a blank").radii(-5.0), [(0.0, 40.0)]);
    }

    #[test]
    fn what_is_turned_is_not_on_the_face() {
        let setup = Setup::from_json(SETUP).expect("a setup");
        let analysis = analyze(b"T0101\nG00 X62 Z2\nG98 G01 Z-20 F100", &setup);
        assert!(Face::of(&analysis.motions, &SimulationResult::of(&analysis.motions, &setup)).is_none());
    }
}
