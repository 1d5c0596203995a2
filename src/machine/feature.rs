//! Finds the feature of the part at a point: a cylinder, face, taper, arc or thread, with its dimensions.
//!
//! In: the half-section, whose arcs are chords, and a point on it. Out: the [`Feature`] of the nearest edge.
//! Neighbouring edges on one line or one circle are one feature. Must not know the picture.

use super::region::Region;
use super::resolved_setup::ResolvedSetup;
use crate::geometry::{Point, SAME, nearest_on};
use crate::motion::{MotionKind, Motions};
use crate::setup::Side;

/// Greatest distance of corners from the line or circle of their feature, mm: from the chords of arcs and of
/// the nose.
const OFF: f64 = 0.006;
/// Greatest error of a corner, mm. Larger than `OFF`, because the errors of two edges add up.
const OFF_CORNER: f64 = 0.01;
/// Least number of chords of a circle.
const MIN_CHORDS: usize = 4;
/// Least sweep of a circle, radians.
const MIN_SWEEP: f64 = 0.05;
/// Larger arcs are treated as lines, mm.
const LARGEST_RADIUS: f64 = 5000.0;
/// Most motions that are searched for a stated size: this runs at each movement of the pointer.
const MAX_MOTIONS: usize = 100_000;
/// Most corners of a part whose features are listed.
const MAX_CORNERS: usize = 3000;
/// Most edges that are examined on either side.
const MAX_EDGES: usize = 600;

/// The shape of a feature. Radii, mm; Z, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// Parallel to the spindle axis.
    Cylinder,
    /// Perpendicular to the spindle axis.
    Face,
    /// Straight, neither parallel nor perpendicular to the spindle axis.
    Taper {
        /// Angle to the spindle axis, radians: half the cone angle.
        half_angle: f64,
        /// The n of the ratio 1:n, the change of diameter per length.
        ratio: Option<f64>,
    },
    /// A circular arc.
    Arc {
        /// Radius, mm.
        radius: f64,
    },
    /// A thread; `from` and `to` are its ends at the crests.
    Thread {
        /// Lead, mm.
        lead: f64,
        /// Radius at the roots of an outside thread or the crests of an inside one, mm.
        minor: f64,
        /// Radius at the crests of an outside thread or the roots of an inside one, mm.
        major: f64,
    },
    /// A section inside the material, at one Z: from the outside to the bore or the axis.
    Across,
}

/// A feature of the part.
#[derive(Clone, Debug, PartialEq)]
pub struct Feature {
    /// Its shape.
    pub shape: Shape,
    /// Its corners from one end to the other.
    pub corners: Vec<Point>,
}

impl Feature {
    /// The two ends.
    pub fn ends(&self) -> [Point; 2] {
        [self.corners.first(), self.corners.last()].map(|end| end.copied().unwrap_or_default())
    }

    /// The feature with the sizes that the program states: each end whose X or Z is within `OFF` of a
    /// programmed one takes that value.
    pub fn as_programmed(mut self, motions: &Motions) -> Self {
        if motions.len() > MAX_MOTIONS {
            return self;
        }
        let mut ends = self.ends().map(Stated::new);
        let mut diameters = match self.shape {
            Shape::Thread { minor, major, .. } => {
                [minor, major].map(|radius| Stated::new(Point::new(radius, 0.0)))
            }
            _ => [Stated::new(Point::default()); 2],
        };
        for chunk in motions.chunks() {
            for index in (0..chunk.len()).filter(|&index| chunk.kind(index).cuts()) {
                let motion = chunk.get_on_workpiece(index);
                let programmed = motion.programmed.filter(|_| motion.rotary.is_none());
                for point in programmed.map_or([motion.from, motion.to], |own| [own.from, own.to]) {
                    ends.iter_mut().chain(&mut diameters).for_each(|stated| stated.meet(point));
                }
            }
        }
        let is_stated = ends.iter().all(|end| end.point.is_some());
        let [from, to] = ends.map(Stated::place);
        match &mut self.shape {
            Shape::Thread { minor, major, .. } => [*minor, *major] = diameters.map(|stated| stated.x.0),
            // Nose radius moves the ends of a taper along it, and the angle is that of the program.
            Shape::Taper { .. } if is_stated => self.shape = taper(from, to),
            Shape::Taper { .. } | Shape::Cylinder | Shape::Face | Shape::Arc { .. } | Shape::Across => {}
        }
        if let [first, .., last] = &mut self.corners[..] {
            [*first, *last] = [from, to];
        }
        self
    }
}

/// A point, and the nearest programmed point, X and Z, each with its distance, mm.
#[derive(Clone, Copy)]
struct Stated {
    at: Point,
    point: Option<(Point, f64)>,
    x: (f64, f64),
    z: (f64, f64),
}

impl Stated {
    fn new(at: Point) -> Self {
        Self { at, point: None, x: (at.x, OFF), z: (at.z, OFF) }
    }

    fn meet(&mut self, point: Point) {
        let off = point.distance(self.at);
        if off < self.point.map_or(OFF_CORNER, |(_, least)| least) {
            self.point = Some((point, off));
        }
        for (nearest, own, value) in [(&mut self.x, self.at.x, point.x), (&mut self.z, self.at.z, point.z)] {
            let off = (value - own).abs();
            if off < nearest.1 {
                *nearest = (value, off);
            }
        }
    }

    fn place(self) -> Point {
        self.point.map_or(Point::new(self.x.0, self.z.0), |(point, _)| point)
    }
}

/// A thread cut by the program.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Thread {
    /// Lead, mm/rev.
    pub lead: f64,
    /// Least and greatest Z of its passes, mm.
    pub z: [f64; 2],
    /// Radius of the deepest pass, mm: the smallest of an outside thread, the greatest of an inside one.
    pub depth: f64,
    /// Side of the workpiece.
    pub side: Side,
}

/// The threads of a program along the spindle axis.
pub fn threads(motions: &Motions, resolved: &ResolvedSetup) -> Vec<Thread> {
    let mut threads: Vec<Thread> = Vec::new();
    for chunk in motions.chunks() {
        for index in (0..chunk.len()).filter(|&index| chunk.kind(index) == MotionKind::Thread) {
            let motion = chunk.get_on_workpiece(index);
            let (low, high) = (motion.from.z.min(motion.to.z), motion.from.z.max(motion.to.z));
            let Some(lead) = motion.lead.filter(|_| high - low > (motion.to.x - motion.from.x).abs()) else {
                continue;
            };
            let side = resolved.tool(&motion).tool.working_side();
            let depth = match side {
                Side::Inside => motion.from.x.max(motion.to.x),
                Side::Outside | Side::Face => motion.from.x.min(motion.to.x),
            };
            let same = threads.iter_mut().find(|thread| {
                thread.side == side
                    && (thread.lead - lead).abs() < SAME
                    && thread.z[0] < high
                    && low < thread.z[1]
            });
            match same {
                Some(thread) => {
                    thread.z = [thread.z[0].min(low), thread.z[1].max(high)];
                    thread.depth = match side {
                        Side::Inside => thread.depth.max(depth),
                        Side::Outside | Side::Face => thread.depth.min(depth),
                    };
                }
                None => threads.push(Thread { lead, z: [low, high], depth, side }),
            }
        }
    }
    threads
}

/// The feature whose edge is nearest to a point, within `reach` mm; inside the material, its diameters there.
pub fn at(part: &Region, threads: &[Thread], place: Point, reach: f64) -> Option<Feature> {
    let outlines: Vec<Vec<Point>> = part.outlines().map(Iterator::collect).collect();
    let distances = outlines.iter().enumerate().flat_map(|(outline, corners)| {
        (0..corners.len()).map(move |edge| {
            let (a, b) = (corners[edge], corners[(edge + 1) % corners.len()]);
            (distance(place, a, b), outline, edge)
        })
    });
    // Between two crests no edge is near.
    let on_thread =
        |corners: &Vec<Point>| threads.iter().find_map(|thread| thread_at(thread, corners, place, reach));
    if let Some(thread) = outlines.iter().find_map(on_thread) {
        return Some(thread);
    }
    let (near, outline, edge) = distances.min_by(|a, b| a.0.total_cmp(&b.0))?;
    if near > reach {
        let (inner, outer) =
            part.radii(place.z).into_iter().find(|(inner, outer)| (*inner..*outer).contains(&place.x))?;
        let corners = [outer, inner].map(|radius| Point::new(radius, place.z)).to_vec();
        return Some(Feature { shape: Shape::Across, corners });
    }
    let corners = &outlines[outline];
    let feature = edge_feature(corners, edge)?;
    // The spindle axis is not an edge of the part.
    let [from, to] = feature.ends();
    (from.x.abs() > SAME || to.x.abs() > SAME).then_some(feature)
}

/// All features along the outlines of the part; the teeth of a thread are one feature. Empty for a part with
/// more than [`MAX_CORNERS`] corners.
pub fn all(part: &Region, threads: &[Thread]) -> Vec<Feature> {
    let mut found = Vec::new();
    if part.corners() > MAX_CORNERS {
        return found;
    }
    for outline in part.outlines() {
        let corners: Vec<Point> = outline.collect();
        let count = corners.len();
        let mut is_covered = vec![false; count];
        for edge in 0..count {
            if is_covered[edge] {
                continue;
            }
            let ends = [corners[edge], corners[(edge + 1) % count]];
            let own = threads.iter().find(|thread| ends.iter().all(|end| thread.has_tooth(*end)));
            let feature = match own {
                Some(thread) => {
                    let place = Point::new(thread.depth, (ends[0].z + ends[1].z) / 2.0);
                    thread_at(thread, &corners, place, thread.lead)
                }
                None => edge_feature(&corners, edge),
            };
            let belongs = |at: Point| match own {
                Some(thread) => thread.has_tooth(at),
                None => feature.iter().any(|feature| feature.corners.contains(&at)),
            };
            for (other, covered) in is_covered.iter_mut().enumerate() {
                *covered |= belongs(corners[other]) && belongs(corners[(other + 1) % count]);
            }
            is_covered[edge] = true;
            found.extend(feature);
        }
    }
    found
}

impl Thread {
    /// Whether a corner of the part is on a tooth of the thread.
    fn has_tooth(&self, at: Point) -> bool {
        let [low, high] = self.z;
        (low - SAME..=high + SAME).contains(&at.z) && (at.x - self.depth).abs() < 1.5 * self.lead
    }
}

/// The thread, if a point is on it or within `reach` mm of it.
fn thread_at(thread: &Thread, corners: &[Point], place: Point, reach: f64) -> Option<Feature> {
    let [low, high] = thread.z;
    if !(low..=high).contains(&place.z) {
        return None;
    }
    let tooth = 1.5 * thread.lead;
    let near = |at: &&Point| (low..=high).contains(&at.z) && (at.x - thread.depth).abs() < tooth;
    let own = corners.iter().filter(near);
    let inside = thread.side == Side::Inside;
    let crest = own.clone().map(|at| at.x).reduce(if inside { f64::min } else { f64::max })?;
    let (minor, major) = if inside { (crest, thread.depth) } else { (thread.depth, crest) };
    let slack = 0.05 * thread.lead;
    if !(minor - reach..=major + reach).contains(&place.x) || major - minor < slack {
        return None;
    }
    let on_crest = own.filter(|at| (at.x - crest).abs() < slack);
    let (from, to) = on_crest.fold((high, low), |(a, b), at| (a.min(at.z), b.max(at.z)));
    let corners = vec![Point::new(crest, from), Point::new(crest, to)];
    Some(Feature { shape: Shape::Thread { lead: thread.lead, minor, major }, corners })
}

/// The line or circle that an edge belongs to.
fn edge_feature(corners: &[Point], edge: usize) -> Option<Feature> {
    let line = grown(corners, edge, |run| run.len() < 3 || lie_on_line(run));
    let arc = grown(corners, edge, |run| run.len() < 4 || circle_of(run).is_some());
    if let Some((center, radius)) = circle_of(&arc).filter(|_| arc.len() > MIN_CHORDS) {
        let sweep: f64 = arc.windows(2).map(|ends| angle(center, ends[0], ends[1])).sum();
        if sweep.abs() >= MIN_SWEEP && length(&arc) > 1.5 * length(&line) {
            return Some(Feature { shape: Shape::Arc { radius: round_if_near(radius) }, corners: arc });
        }
    }
    let (from, to) = (*line.first()?, *line.last()?);
    let (dx, dz) = (to.x - from.x, to.z - from.z);
    let shape = if dx.abs() < OFF / 2.0 && dz.abs() > dx.abs() {
        Shape::Cylinder
    } else if dz.abs() < OFF / 2.0 {
        Shape::Face
    } else {
        taper(from, to)
    };
    Some(Feature { shape, corners: line })
}

fn taper(from: Point, to: Point) -> Shape {
    let (dx, dz) = (to.x - from.x, to.z - from.z);
    let ratio = dz.abs() / (2.0 * dx.abs());
    let is_near = (ratio - ratio.round()).abs() < 0.002 * ratio && (1.0..=200.0).contains(&ratio.round());
    let half_angle = dx.abs().atan2(dz.abs());
    Shape::Taper { half_angle, ratio: is_near.then(|| ratio.round()) }
}

/// Extends the run of corners from an edge in both directions while it fits.
fn grown(corners: &[Point], edge: usize, fits: impl Fn(&[Point]) -> bool) -> Vec<Point> {
    let count = corners.len();
    let corner = |index: usize| corners[index % count];
    let mut run = vec![corner(edge), corner(edge + 1)];
    let most = MAX_EDGES.min(count.saturating_sub(2));
    let mut forward = 0;
    while forward < most {
        run.push(corner(edge + 2 + forward));
        if !fits(&run) {
            run.pop();
            break;
        }
        forward += 1;
    }
    run.reverse();
    for back in 1..=most - forward {
        run.push(corner(edge + count - back));
        if !fits(&run) {
            run.pop();
            break;
        }
    }
    run.reverse();
    run
}

fn lie_on_line(run: &[Point]) -> bool {
    let (from, to) = (run[0], run[run.len() - 1]);
    // A line that turns back is another edge.
    let forward = run.windows(2).all(|ends| {
        (ends[1].x - ends[0].x) * (to.x - from.x) + (ends[1].z - ends[0].z) * (to.z - from.z) >= 0.0
    });
    forward && run.iter().all(|at| distance(*at, from, to) <= OFF / 2.0)
}

/// The circle through the corners and the midpoints of the chords between them: centre and radius, mm.
fn circle_of(run: &[Point]) -> Option<(Point, f64)> {
    let count = run.len() as f64;
    let mean = |of: &dyn Fn(&Point) -> f64| run.iter().map(of).sum::<f64>() / count;
    let (mx, mz) = (mean(&|at| at.x), mean(&|at| at.z));
    // Least squares of x² + z² − 2·a·x − 2·b·z − c (Kåsa), relative to the mean of the corners.
    let [mut xx, mut zz, mut xz, mut xr, mut zr] = [0.0; 5];
    for at in run {
        let (x, z) = (at.x - mx, at.z - mz);
        let square = x * x + z * z;
        xx += x * x;
        zz += z * z;
        xz += x * z;
        xr += x * square / 2.0;
        zr += z * square / 2.0;
    }
    let determinant = xx * zz - xz * xz;
    if determinant.abs() <= 1e-12 * (xx + zz) * (xx + zz) {
        return None;
    }
    let (a, b) = ((xr * zz - zr * xz) / determinant, (zr * xx - xr * xz) / determinant);
    let radius = (a * a + b * b + (xx + zz) / count).sqrt();
    let center = Point::new(mx + a, mz + b);
    let off = |at: Point| (at.distance(center) - radius).abs();
    let middle = |ends: &[Point]| Point::new((ends[0].x + ends[1].x) / 2.0, (ends[0].z + ends[1].z) / 2.0);
    // The chords of an arc all turn the same way.
    let turns = run.windows(2).map(|ends| angle(center, ends[0], ends[1]));
    let one_way = turns.clone().all(|turn| turn > -1e-6) || turns.clone().all(|turn| turn < 1e-6);
    let fits = run.iter().all(|at| off(*at) <= OFF) && run.windows(2).all(|ends| off(middle(ends)) <= OFF);
    (fits && one_way && radius < LARGEST_RADIUS).then_some((center, radius))
}

/// Angle from one point to another about a centre, radians, counter-clockwise.
fn angle(center: Point, from: Point, to: Point) -> f64 {
    let (ax, az) = (from.x - center.x, from.z - center.z);
    let (bx, bz) = (to.x - center.x, to.z - center.z);
    (az * bx - ax * bz).atan2(az * bz + ax * bx)
}

/// Rounds a fitted radius, which is accurate to a few micrometres, to the nearest round value.
fn round_if_near(radius: f64) -> f64 {
    let round = (radius * 100.0).round() / 100.0;
    if (round - radius).abs() < OFF { round } else { radius }
}

fn length(run: &[Point]) -> f64 {
    run.windows(2).map(|ends| ends[0].distance(ends[1])).sum()
}

fn distance(place: Point, a: Point, b: Point) -> f64 {
    place.distance(nearest_on([a, b], place))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analyze;
    use crate::machine::SimulationResult;
    use crate::setup::Setup;
    use crate::units::Diameter;

    const SETUP: &str = r#"{"stock": {"diameter": 60, "bore": 20, "length": 80},
        "tools": {"T0101": {"type": "turning", "noseRadius": NOSE, "tip": 3}, "T0303": {"type": "threading"}}}"#;

    fn feature_with(nose: &str, program: &str, diameter: f64, z: f64) -> Option<Feature> {
        let setup = Setup::from_json(&SETUP.replace("NOSE", nose)).expect("a setup");
        let analysis = analyze(program.as_bytes(), &setup);
        let simulation = SimulationResult::of(&analysis.motions, &setup);
        let threads = threads(&analysis.motions, simulation.resolved_setup());
        at(
            &simulation.finished().expect("a part"),
            &threads,
            Point::new(Diameter::new(diameter).radius(), z),
            0.3,
        )
    }

    fn feature(program: &str, diameter: f64, z: f64) -> Feature {
        feature_with("0", program, diameter, z).expect("an edge")
    }

    const PROFILE: &str = "T0101\nG00 X40 Z2\nG01 Z-10 F0.2\nX44\nX48 Z-30\nG02 X58 Z-35 R5\nG00 X70";

    #[test]
    fn straight_edges_are_told_apart() {
        let cylinder = feature(PROFILE, 40.0, -5.0);
        assert_eq!(cylinder.shape, Shape::Cylinder);
        let [from, to] = cylinder.ends();
        assert!(((from.z - to.z).abs() - 10.0).abs() < 1e-3 && (from.x - 20.0).abs() < 1e-3);
        assert_eq!(feature(PROFILE, 42.0, -10.0).shape, Shape::Face);
        let Shape::Taper { half_angle, ratio } = feature(PROFILE, 46.0, -20.0).shape else {
            panic!("a taper")
        };
        assert!((half_angle - 0.1f64.atan()).abs() < 1e-5);
        assert_eq!(ratio, Some(5.0));
        assert_eq!(feature(PROFILE, 20.0, -40.0).shape, Shape::Cylinder);
    }

    #[test]
    fn inside_the_material_are_the_diameters_at_that_z() {
        for (diameter, z, outside) in [(30.0, -5.0, 40.0), (35.0, -20.0, 46.0), (21.0, -60.0, 60.0)] {
            let across = feature(PROFILE, diameter, z);
            assert_eq!(across.shape, Shape::Across);
            let [outer, inner] = across.ends().map(|end| Diameter::from_radius(end.x).mm());
            assert!((outer - outside).abs() < 1e-3 && (inner - 20.0).abs() < 1e-3, "{outer} {inner}");
            assert_eq!(across.ends().map(|end| end.z), [z, z]);
        }
        // In the bore, and outside of the part.
        assert_eq!(feature_with("0", PROFILE, 10.0, -20.0), None);
        assert_eq!(feature_with("0", PROFILE, 70.0, -20.0), None);
    }

    #[test]
    fn sizes_are_those_the_program_states() {
        // A cone from Ø40 to Ø50; its chords are off by a few micrometres.
        let program = "T0101\nG00 X70 Z2\nG42 G00 X36 Z0\nG01 X40 F0.2\nX50 Z-20\nZ-45\nX70\nG40 G00 X75 Z2";
        let setup = Setup::from_json(&SETUP.replace("NOSE", "0.4")).expect("a setup");
        let motions = analyze(program.as_bytes(), &setup).motions;
        let stated = |diameter: f64, z: f64| {
            let found = feature_with("0.4", program, diameter, z).expect("an edge");
            let [from, to] = found.as_programmed(&motions).ends();
            let (first, last) = if from.z > to.z { (from, to) } else { (to, from) };
            [first.x, first.z, last.x, last.z]
        };
        assert_eq!(stated(45.0, -10.0), [20.0, 0.0, 25.0, -20.0]);
        let [x, z, end, _] = stated(50.0, -38.0);
        assert_eq!([x, z, end], [25.0, -20.0, 25.0]);
        // A size that no program states is unchanged.
        let other =
            Feature { shape: Shape::Cylinder, corners: vec![Point::new(23.3, -1.0), Point::new(23.3, -9.0)] };
        assert_eq!(other.clone().as_programmed(&motions), other);
    }

    #[test]
    fn chords_are_the_arc_they_stand_for() {
        for degrees in [10.0, 45.0, 80.0f64] {
            let angle = degrees.to_radians();
            let on = (58.0 - 10.0 * angle.cos(), -30.0 - 5.0 * angle.sin());
            let arc = feature(PROFILE, on.0, on.1);
            assert_eq!(arc.shape, Shape::Arc { radius: 5.0 }, "{degrees}");
            let [from, to] = arc.ends();
            assert!((from.distance(to) - 50f64.sqrt()).abs() < 0.02, "{from:?} {to:?}");
        }
        let large = "T0101\nG00 X30 Z0\nG03 X50 Z-20 R60 F0.2\nG00 X70 Z2";
        let chord = feature(large, 41.86, -9.53);
        assert!(
            matches!(chord.shape, Shape::Arc { radius } if (radius - 60.0).abs() < 0.05),
            "{:?}",
            chord.shape
        );
    }

    #[test]
    fn a_nose_makes_its_own_radius() {
        // With compensation the arc is the programmed one; the corner at its foot has the nose radius.
        let program =
            "T0101\nG00 X70 Z2\nG42 G00 X40\nG01 Z-20 F0.2\nG02 X50 Z-25 R5\nG01 X64\nG40 G00 X70 Z2";
        let angle = 45f64.to_radians();
        let arc = feature_with("0.8", program, 50.0 - 10.0 * angle.cos(), -20.0 - 5.0 * angle.sin());
        assert!(matches!(arc.expect("an edge").shape, Shape::Arc { radius: 5.0 }));
        let corner = "T0101\nG00 X40 Z2\nG01 Z-20 F0.2\nX64\nG00 Z2";
        let found = feature_with("0.8", corner, 40.47, -19.77).expect("an edge");
        assert!(
            matches!(found.shape, Shape::Arc { radius } if (radius - 0.8).abs() < 0.01),
            "{:?}",
            found.shape
        );
    }

    #[test]
    fn a_thread_has_lead_and_diameters() {
        let program = "T0101\nG00 X40 Z2\nG01 Z-30 F0.2\nX64\nG00 Z2\nT0303\nG97 S300 M03\nG00 X44 Z5\nG92 X39 Z-20 F2\nX38\nX37.4";
        let thread = feature(program, 38.0, -10.0);
        let Shape::Thread { lead, minor, major } = thread.shape else {
            panic!("a thread: {:?}", thread.shape)
        };
        assert!(
            (lead - 2.0).abs() < 1e-9
                && (Diameter::from_radius(minor).mm() - 37.4).abs() < 1e-3
                && (Diameter::from_radius(major).mm() - 40.0).abs() < 1e-3
        );
        assert_eq!(feature(program, 40.0, -26.0).shape, Shape::Cylinder);
    }
}
