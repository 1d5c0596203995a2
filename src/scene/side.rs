//! The picture of the side: cylindrical interpolation (G07.1), live drills and the Y axis under G19, usually
//! unrolled.
//!
//! In: the motions of a run and the simulation. Out: [`Side`]: these moves as [`SurfaceMoves`], and the area
//! swept by live tools. Points have Z in `z` (to the right) and the distance around the workpiece in `x`, mm.
//! C and Y increase downwards, as seen from outside with Z to the right. Angles are unrolled at the radius of
//! the first cylinder, or at that of the blank. If all moves are along Y with the same angle of C, nothing is
//! unrolled: the workpiece is seen along X. Must not know of canvases.

use std::f64::consts::TAU;

use super::ruler::Axis;
use super::seam::{Taken, Window, extent};
use super::surface_moves::{Gathered, Origin, Passed, SurfaceMoves, cutter_radius, on_way, passed};
use super::work::Work;
use super::{Place, Plane};
use crate::geometry::bounds::Bounds;
use crate::geometry::virtual_plane::{Flat, Surface, VirtualMove, Way};
use crate::geometry::{Arc, Point, SAME};
use crate::machine::SimulationResult;
use crate::machine::live_holes::goes_into_side;
use crate::machine::region::Region;
use crate::motion::{Motion, MotionKind, Motions, Programmed};
use crate::source::Span;

/// Number of segments of an arc that is unrolled at another radius than its own.
const PIECES: u32 = 32;

/// Maximum number of moves; further moves are not split at the seam.
const MAX_CUT: usize = 20_000;

/// The side of the workpiece and the moves over it.
#[derive(Clone, Debug)]
pub struct Side {
    moves: SurfaceMoves,
    shown: Shown,
}

/// How the side is shown.
#[derive(Clone, Copy, Debug)]
enum Shown {
    /// One turn, unrolled at a radius, mm.
    Unrolled { radius: f64, window: Window },
    /// Seen along X, for a workpiece of a radius, mm.
    FromAbove { radius: f64 },
}

/// A move over the side, before it is placed in the picture.
struct OverSide {
    index: usize,
    motion: Motion,
    block: (Span, u32),
    /// `None` for a hole.
    moved: Option<VirtualMove>,
    /// Angle of C, degrees.
    c: f64,
    cutter: Option<f64>,
}

impl Side {
    /// The side of a program; `None` if no motion moves over it.
    pub fn of(motions: &Motions, simulation: &SimulationResult) -> Option<Self> {
        let surface = simulation.resolved_setup().stock().map(|(stock, _)| stock.diameter.radius());
        let (mut cylinder, mut first, mut c_of_all) = (None, None, None);
        let mut only_y = true;
        each(motions, simulation, |own| {
            if let Some(Surface::Cylinder { radius, .. }) = own.moved.map(|moved| moved.surface) {
                cylinder.get_or_insert(radius);
            }
            first.get_or_insert(own.motion.from.x.abs());
            only_y &= own.moved.is_some_and(|moved| moved.has_y()) && *c_of_all.get_or_insert(own.c) == own.c;
        });
        let radius = cylinder.or(surface).unwrap_or(first?).max(SAME);
        let shown = if only_y {
            Shown::FromAbove { radius: surface.unwrap_or(radius) }
        } else {
            let mut taken = Taken::none(TAU * radius);
            each(motions, simulation, |own| {
                let radius_of_cutter = own.cutter.unwrap_or(0.0);
                for way in ways(&own, radius) {
                    taken.add(extent(&way), radius_of_cutter);
                }
            });
            Shown::Unrolled { radius, window: taken.window() }
        };
        let mut moves = Gathered::default();
        each(motions, simulation, |own| gather(&mut moves, &own, shown));
        let up = match shown {
            Shown::Unrolled { radius, .. } => Axis::Around { radius },
            Shown::FromAbove { .. } => Axis::Y,
        };
        Some(Self { moves: moves.finish(Plane::Side, [Axis::Z, up])?, shown })
    }

    /// The moves over the side.
    pub fn moves(&self) -> &SurfaceMoves {
        &self.moves
    }

    /// The point of the picture at a position: Z in mm, and the value on the other ruler, degrees of C or Y
    /// in mm.
    pub fn point(&self, z: f64, other: f64) -> Point {
        match self.shown {
            Shown::Unrolled { radius, window } => {
                let at = radius * other.to_radians();
                Point::new(at + window.move_of(at), z)
            }
            Shown::FromAbove { .. } => Point::new(other, z),
        }
    }

    /// The blank, the rest of its surface, and the cutter: at a position in the run, or at its end.
    pub fn work(&self, simulation: &SimulationResult, place: Option<Place>) -> Option<Work> {
        let (stock, basis) = simulation.resolved_setup().stock()?;
        let (low, high) = match self.shown {
            Shown::Unrolled { window, .. } => (window.low, window.low + window.around),
            Shown::FromAbove { radius } => (-radius, radius),
        };
        let corner = |x, z| Point::new(x, z);
        let bounds = Bounds { min: corner(low, stock.back()), max: corner(high, stock.face) };
        let blank =
            Region::inside(&[bounds.min, corner(low, stock.face), bounds.max, corner(high, stock.back())]);
        let mut left = blank.clone();
        let swept = self.moves.swept(place);
        let mut seams = Vec::new();
        if let Shown::Unrolled { window: Window { around, .. }, .. } = self.shown {
            // Areas that cross one edge reappear at the other.
            for turn in [-around, around] {
                let moved =
                    swept.iter().map(|outline| outline.iter().map(|at| corner(at.x + turn, at.z)).collect());
                left.cut(&moved.collect::<Vec<Vec<Point>>>());
            }
            // Longer than the workpiece, so that its corners lie on the seams in spite of rounding.
            seams =
                [low, high].map(|x| vec![corner(x, stock.back() - 1.0), corner(x, stock.face + 1.0)]).into();
        }
        left.cut(&swept);
        let tool = place.and_then(|place| self.moves.tool(place));
        Some(Work::on_side(&blank, &left, basis, tool, bounds).with_seams(seams))
    }
}

/// Calls `visit` for each move over the side.
fn each(motions: &Motions, simulation: &SimulationResult, mut visit: impl FnMut(OverSide)) {
    let resolved = simulation.resolved_setup();
    let surface = resolved.stock().map(|(stock, _)| stock.diameter.radius());
    for Passed { index, motion, block, c } in passed(motions, resolved) {
        let moved = motion.virtual_move().filter(is_of_side);
        let tool = resolved.tool(&motion);
        if moved.is_none() && !goes_into_side(&motion, tool) {
            continue;
        }
        let depth = moved.map_or(motion.to.x, |moved| moved.third.0.min(moved.third.1));
        let cuts = motion.kind.cuts() && surface.is_some_and(|surface| depth < surface);
        let cutter = cutter_radius(tool).filter(|_| cuts);
        visit(OverSide { index, motion, block, moved, c, cutter });
    }
}

fn is_of_side(moved: &VirtualMove) -> bool {
    matches!(moved.surface, Surface::Cylinder { .. } | Surface::Flat(Flat::Yz))
}

/// Maps points of the plane of a move to the side unrolled at a radius, without wrapping at a turn.
fn place(own: &OverSide, radius: f64) -> impl Fn(Point) -> Point {
    let surface = own.moved.map(|moved| moved.surface);
    let c = radius * own.c.to_radians();
    move |point| match surface {
        Some(Surface::Cylinder { radius: own, .. }) => Point::new(point.x * radius / own, point.z),
        // The plane has Y to the right and Z up, seen from the same side: the picture is rotated by a quarter
        // turn.
        Some(Surface::Flat(_) | Surface::Face) => Point::new(c + point.z, point.x),
        None => Point::new(c, point.z),
    }
}

/// Whether arcs of the move are true arcs in the picture.
fn is_true(own: &OverSide, radius: f64) -> bool {
    !matches!(own.moved.map(|moved| moved.surface), Some(Surface::Cylinder { radius: own, .. }) if own != radius)
}

/// The paths of a move on the side unrolled at a radius, without wrapping at a turn.
fn ways(own: &OverSide, radius: f64) -> Vec<Way> {
    let place = place(own, radius);
    match own.moved.map(|moved| moved.way) {
        None => vec![Way::Line(place(own.motion.to), place(own.motion.to))],
        Some(Way::Line(from, to)) => vec![Way::Line(place(from), place(to))],
        Some(Way::Arc(arc)) if is_true(own, radius) => {
            // The axes of G19 are swapped in the picture, which reverses the arc.
            let turn =
                if own.moved.is_some_and(|moved| moved.has_y()) { arc.turn.opposite() } else { arc.turn };
            vec![Way::Arc(Arc {
                start: place(arc.start),
                end: place(arc.end),
                center: place(arc.center),
                turn,
            })]
        }
        Some(Way::Arc(arc)) => {
            let at = |piece: u32| place(arc.at(f64::from(piece) / f64::from(PIECES)));
            (0..PIECES).map(|piece| Way::Line(at(piece), at(piece + 1))).collect()
        }
    }
}

/// Adds a move at its position in the picture, in as many pieces as needed.
fn gather(moves: &mut Gathered, own: &OverSide, shown: Shown) {
    let (radius, window, c) = match shown {
        Shown::Unrolled { radius, window } => (radius, Some(window), own.c),
        Shown::FromAbove { radius } => (radius, None, 0.0),
    };
    let own = &OverSide { c, motion: own.motion, ..*own };
    let is_true = is_true(own, radius);
    let ways = ways(own, radius);
    let count = ways.len() as f64;
    for (number, way) in ways.iter().enumerate() {
        let whole = || vec![super::seam::Piece { way: *way, shares: [0.0, 1.0], moved: 0.0 }];
        let window = window.filter(|_| moves.len() < MAX_CUT);
        for piece in window.map_or_else(whole, |window| window.pieces(way)) {
            // The programmed path is not split; it is added to the first piece of its move.
            let programmed = own.motion.programmed.filter(|_| is_true && piece.shares[0] == 0.0);
            let place = place(own, radius);
            let place = |at: Point| {
                let at = place(at);
                Point::new(at.x + piece.moved, at.z)
            };
            let programmed = programmed.map(|own| Programmed {
                from: place(own.from),
                to: place(own.to),
                center: own.center.map(place),
            });
            let kind = if own.moved.is_some() { own.motion.kind } else { MotionKind::Dwell };
            let flat = on_way(&Motion { kind, ..own.motion }, &piece.way);
            let shares = piece.shares.map(|share| (number as f64 + share) / count);
            let origin = Origin { motion: own.index, shares, cutter: own.cutter };
            moves.push(&Motion { programmed, ..flat }, own.block, origin);
        }
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;
    use crate::analyze;
    use crate::setup::Setup;

    fn side(program: &str, setup: &str) -> (Side, SimulationResult) {
        let setup = Setup::from_json(setup).expect("a setup");
        let analysis = analyze(program.as_bytes(), &setup);
        let simulation = SimulationResult::of(&analysis.motions, &setup);
        (Side::of(&analysis.motions, &simulation).expect("a side"), simulation)
    }

    fn taken(side: &Side, simulation: &SimulationResult) -> f64 {
        let work = side.work(simulation, None).expect("a blank");
        let area = |outlines: &[Vec<Point>]| {
            outlines.iter().map(|outline| Region::inside(outline).area()).sum::<f64>()
        };
        let blank = area(&work.blank);
        assert!((blank - 60.0 * TAU * 30.0).abs() < 1e-3, "{blank}");
        // Holes in the part are outlines too.
        area(&work.part) - blank
    }

    const DRILL: &str =
        r#"{"stock": {"diameter": 60, "length": 60}, "tools": {"T0303": {"type": "drill", "diameter": 8}}}"#;

    /// Three holes of ⌀8 at Z-30, a quarter turn apart: C·r is 0, 47.124 and −47.124 (C270 is C−90).
    #[test]
    fn holes_of_the_side_are_where_c_takes_them() {
        let program = "M45\nT0303\nG97 S1000 M13\nG00 X66 Z-30 C0\nG98 G87 Z-30 C0 X30 R-1 F80\nC90\nC270\nG80\nG00 X100";
        let (side, simulation) = side(program, DRILL);
        let ends: Vec<Point> = side.moves().scene(None).strokes().map(|stroke| stroke.shape.end()).collect();
        let expected = [0.0, 47.1239, -47.1239];
        assert_eq!(ends.len(), 3, "{ends:?}");
        assert!(
            ends.iter().zip(expected).all(|(at, up)| at.distance(Point::new(up, -30.0)) < 1e-3),
            "{ends:?}"
        );
        let holes = taken(&side, &simulation);
        assert!((holes - 3.0 * PI * 16.0).abs() < 0.1, "{holes}");
    }

    /// Four holes: the seam is half-way before the first, so that no hole is split, and angles are as
    /// programmed.
    #[test]
    fn four_holes_are_a_quarter_of_a_turn_apart() {
        let program = "M45\nT0303\nG97 S1000 M13\nG00 X66 Z-30 C0\nG98 G87 Z-30 C0 X30 R-1 F80\nC90\nC180\nC270\nG80\nG00 X100";
        let (side, simulation) = side(program, DRILL);
        let ends: Vec<Point> = side.moves().scene(None).strokes().map(|stroke| stroke.shape.end()).collect();
        let expected = [0.0, 47.1239, 94.2478, 141.3717];
        assert!(
            ends.len() == 4
                && ends.iter().zip(expected).all(|(at, c)| at.distance(Point::new(c, -30.0)) < 1e-3),
            "{ends:?}"
        );
        let work = side.work(&simulation, None).expect("a blank");
        // The outline, and four whole holes.
        assert_eq!(work.part.len(), 5);
        for (hole, c) in work.part[1..].iter().map(|hole| (hole, hole[0].x)).collect::<Vec<_>>() {
            let at = expected.iter().find(|at| (*at - c).abs() < 4.1).expect("a place");
            assert!(hole.iter().all(|corner| (corner.distance(Point::new(*at, -30.0)) - 4.0).abs() < 0.01));
        }
        let [cut, _] = work.part_edges(Plane::Side, 1.0);
        let around = |line: &Vec<Point>| line.iter().any(|at| (at.x - work.bounds().min.x).abs() < 1e-3);
        assert!(
            cut.iter().filter(|line| around(line)).all(|line| line.iter().all(|at| at.z == line[0].z)),
            "{cut:?}"
        );
        assert!((work.bounds().min.x + 45f64.to_radians() * 30.0).abs() < 0.6, "{:?}", work.bounds());
        assert!(side.point(-30.0, 270.0).distance(ends[3]) < 1e-3);
        assert!(side.point(-30.0, -90.0).distance(ends[3]) < 1e-3);
    }

    const MILL: &str = r#"{"stock": {"diameter": 60, "length": 60}, "tools": {"T0101": {"type": "endmill", "toolRadius": 5}}}"#;

    /// A groove all around: one turn from its start, nothing beyond the edge.
    #[test]
    fn a_groove_all_around_is_one_turn() {
        let program = "M45\nT0101\nG98 G97 S1000 M13\nG00 X70 Z-30 C0\nG01 X50 F100\nG07.1 C30\nG01 C180\nC360\nG07.1 C0\nG00 X70";
        let (side, simulation) = side(program, MILL);
        let work = side.work(&simulation, None).expect("a blank");
        assert!(work.bounds().min.x.abs() < 1e-9 && (work.bounds().max.x - TAU * 30.0).abs() < 1e-9);
        assert!((taken(&side, &simulation) + TAU * 30.0 * 10.0).abs() < 1e-3);
        // The seam is not an edge: the part has two pieces, with three edges of the blank and two of the
        // groove.
        let [cut, _] = work.part_edges(Plane::Side, 1.0);
        let along: f64 =
            cut.iter().flat_map(|line| line.windows(2)).map(|ends| (ends[0].z - ends[1].z).abs()).sum();
        assert!(along < 1e-6, "{cut:?}");
    }

    /// From C180 on to C200, with holes elsewhere: the move is split, and the tool goes from one piece to the
    /// other.
    #[test]
    fn the_tool_goes_over_the_seam() {
        let program = "M45\nT0101\nG98 G97 S1000 M13\nG00 X70 Z-30 C0\nG01 X50 F100\nG07.1 C30\nG01 C300\nZ-40\nC400\nG07.1 C0\nG00 X70";
        let (side, simulation) = side(program, MILL);
        let moves = side.moves();
        let first = moves.motion(0).expect("a motion");
        let last = (0..).map_while(|own| moves.motion(own)).last().expect("a motion");
        let pieces = moves.own(last);
        assert_eq!((moves.own(first).len(), pieces.len()), (1, 2));
        let place = |fraction| Place { motion: last, fraction, at: Point::default() };
        // From 300 to 400 degrees: at 0.6 it is at 360.
        let before = moves.playhead(place(0.3));
        let after = moves.playhead(place(0.8));
        assert_eq!((before.motion, after.motion), (pieces.start, pieces.start + 1));
        assert!((before.share - 0.5).abs() < 1e-9 && (after.share - 0.5).abs() < 1e-9);
        let tool = side.work(&simulation, Some(place(0.8))).and_then(|work| work.tool).expect("a tool");
        assert!(
            tool.tip.distance(side.point(-40.0, 380.0)) < 1e-9
                && tool.tip.distance(side.point(-40.0, 20.0)) < 1e-9
        );
        assert!(tool.edge.iter().all(|at| (at.distance(tool.tip) - 5.0).abs() < 1e-9));
        // What is not cut yet is still there.
        let area = |place| -> f64 {
            let work = side.work(&simulation, place).expect("a blank");
            work.part.iter().map(|outline| Region::inside(outline).area()).sum()
        };
        assert!(area(Some(place(0.0))) > area(Some(place(0.5))) && area(Some(place(0.5))) > area(None));
        let start = Place { motion: 0, fraction: 0.5, at: Point::default() };
        assert!((area(Some(start)) - 60.0 * TAU * 30.0).abs() < 1e-3);
    }

    /// An arc over the seam, and one on a cylinder of another radius, which is not a circle in the picture.
    #[test]
    fn arcs_go_over_the_seam() {
        let begin = "M45\nT0101\nG98 G97 S1000 M13\nG00 X70 Z-10 C0\nG01 X50 F100\n";
        let program = format!(
            "{begin}G07.1 C30\nG01 C350\nG02 Z-20 C369.0986 R10\nG07.1 C0\nG07.1 C20\nG03 Z-30 C380 R15\nG07.1 C0\nG00 X70"
        );
        let (side, _) = side(&program, MILL);
        let scene = side.moves().scene(None);
        let half = TAU * 30.0;
        for stroke in scene.strokes() {
            let bounds = stroke.shape.bounds();
            assert!(bounds.min.x >= -1e-6 && bounds.max.x <= half + 1e-6, "{stroke:?}");
        }
        let lines: Vec<u32> = scene.strokes().map(|stroke| stroke.line + 1).collect();
        assert!(lines.iter().filter(|line| **line == 8).count() == 2, "{lines:?}");
        assert!(lines.iter().filter(|line| **line == 11).count() >= 32, "{lines:?}");
    }

    /// A slot of 10 mm from C0 to C90 on ⌀60, 47.124 mm long with round ends.
    #[test]
    fn a_slot_on_the_cylinder_is_straight() {
        let program = "M45\nT0101\nG98 G97 S1000 M13\nG00 X70 Z-30 C0\nG01 X50 F100\nG07.1 C30\nG01 C90\nG07.1 C0\nG00 X70";
        let (side, simulation) = side(program, MILL);
        let work = side.work(&simulation, None).expect("a blank");
        let left: f64 = work.part.iter().map(|outline| Region::inside(outline).area()).sum();
        let slot = left - 60.0 * TAU * 30.0;
        assert!((slot - (471.239 + PI * 25.0)).abs() < 0.2, "{slot}");
    }

    /// G19 with the same angle of C: the workpiece is seen along X, at its true width. In picture
    /// coordinates, with Y in place of Z and drawn downwards, G02 has the opposite direction; on screen it
    /// turns as G02 does.
    #[test]
    fn arcs_of_g19_are_on_the_side() {
        let setup = r#"{"stock": {"diameter": 60, "length": 60}, "machine": {"yAxis": true}}"#;
        let program = "M45\nT0101\nG98 G97 S1000 M13\nG00 X50 Z-10\nG19\nG02 Y10 Z-20 R10 F100\nG18";
        let (side, simulation) = side(program, setup);
        let strokes: Vec<_> = side.moves().scene(None).strokes().collect();
        let arc = strokes.iter().find_map(|stroke| match stroke.shape {
            super::super::StrokeShape::Arc(arc) => Some(arc),
            _ => None,
        });
        let arc = arc.expect("an arc");
        assert!(
            arc.end.is_same(Point::new(10.0, -20.0)) && arc.center.is_same(Point::new(0.0, -20.0)),
            "{arc:?}"
        );
        assert!((arc.sweep() - PI / 2.0).abs() < 1e-9, "{arc:?}");
        let work = side.work(&simulation, None).expect("a blank");
        assert_eq!(work.bounds(), Bounds { min: Point::new(-30.0, -60.0), max: Point::new(30.0, 0.0) });
        assert!(side.point(-5.0, 7.0).is_same(Point::new(7.0, -5.0)));
    }
}
