//! Tests of the scene, and hand-built paths for the tests of its parts.

use crate::geometry::{Point, Turn};
use crate::machine::SimulationResult;
use crate::motion::{Chunk, Feed, Motion, MotionKind, Motions, Process, Quill, SpindleSpeed, SpindleTurn};
use crate::playback::clock::Playhead;
use crate::scene::work::Work;
use crate::setup::{Blank, Setup, Stock};
use crate::source::Span;
use crate::units::Diameter;

use super::Scene;
use super::path_index::{PathIndex, STRETCH, Stretch, StretchKey};
use crate::geometry::bounds::Bounds;

/// A point by its diameter and Z.
pub(super) fn point(diameter: f64, z: f64) -> Point {
    Point::new(Diameter::new(diameter).radius(), z)
}

/// A path built by hand; X values are diameters. Each motion has a separate line of ten bytes.
pub(super) struct Path {
    at: Point,
    list: Vec<Motion>,
    uncertain: bool,
}

impl Path {
    pub(super) fn from(diameter: f64, z: f64) -> Self {
        Self { at: point(diameter, z), list: Vec::new(), uncertain: false }
    }

    pub(super) fn rapid(self, diameter: f64, z: f64) -> Self {
        self.with(MotionKind::Rapid, point(diameter, z), None)
    }

    pub(super) fn feed(self, diameter: f64, z: f64) -> Self {
        self.with(MotionKind::Feed, point(diameter, z), None)
    }

    pub(super) fn thread(self, diameter: f64, z: f64) -> Self {
        self.with(MotionKind::Thread, point(diameter, z), None)
    }

    pub(super) fn dwell(self) -> Self {
        let at = self.at;
        self.with(MotionKind::Dwell, at, None)
    }

    pub(super) fn arc(self, turn: Turn, to: (f64, f64), center: (f64, f64)) -> Self {
        let kind = match turn {
            Turn::Clockwise => MotionKind::ArcClockwise,
            Turn::Counterclockwise => MotionKind::ArcCounterclockwise,
        };
        self.with(kind, point(to.0, to.1), Some(point(center.0, center.1)))
    }

    /// Marks all following motions as uncertain.
    pub(super) fn uncertain(mut self) -> Self {
        self.uncertain = true;
        self
    }

    pub(super) fn motions(self) -> Motions {
        self.chunks_of(300)
    }

    pub(super) fn chunks_of(self, size: usize) -> Motions {
        let mut motions = Motions::default();
        for (index, part) in self.list.chunks(size).enumerate() {
            let line = index * size;
            let mut chunk = Chunk::new(line as u32 * 10, line as u32, part[0].from);
            for (offset, motion) in part.iter().enumerate() {
                let line = line + offset;
                chunk.push(motion, Span::new(line * 10, line * 10 + 9), line as u32);
            }
            motions.push(chunk);
        }
        motions
    }

    fn with(mut self, kind: MotionKind, to: Point, center: Option<Point>) -> Self {
        let process = Process {
            feed: Feed::PerTurn(0.2),
            speed: SpindleSpeed::Constant(800.0),
            turn: SpindleTurn::Forward,
            clamp: None,
            lowest: None,
            tool: (1, 1),
            quill: Quill::Unknown,
            uncertain: self.uncertain,
            incomplete: self.uncertain,
            other_setup: false,
            still: false,
            frame: 0,
            zero: Point::default(),
            tip_shift: Point::default(),
        };
        self.list.push(Motion { center, ..Motion::straight(kind, self.at, to, process) });
        self.at = to;
        self
    }
}

const STOCK: Stock =
    Stock { diameter: Diameter::new(60.0), bore: Diameter::new(20.0), face: 1.0, length: 80.0, grip: None };

fn check_bounds(path: Path, stock: Option<Stock>, (low, high): ((f64, f64), (f64, f64))) {
    let motions = path.motions();
    let path_index = PathIndex::of(&motions);
    let setup = Setup { stock: stock.map(Blank::from), ..Setup::default() };
    let work = stock.and_then(|_| Work::of(&SimulationResult::of(&motions, &setup), &motions, None));
    let bounds = Scene::new(&motions, &path_index, work.as_ref()).bounds();
    let expected = Bounds::around(point(low.0, low.1), point(high.0, high.1));
    assert!(bounds.min.is_same(expected.min) && bounds.max.is_same(expected.max), "{bounds:?} {expected:?}");
}

#[test]
fn the_box_worth_looking_at() {
    let turning = || Path::from(200.0, 200.0).rapid(64.0, 2.0).feed(50.0, -30.0).rapid(200.0, 200.0);
    check_bounds(turning(), None, ((0.0, -30.0), (64.0, 2.0)));
    check_bounds(turning(), Some(STOCK), ((-60.0, -79.0), (64.0, 2.0)));
    let nothing_cuts = Path::from(200.0, 200.0).rapid(64.0, 2.0).rapid(100.0, -20.0);
    check_bounds(nothing_cuts, None, ((0.0, -20.0), (100.0, 2.0)));
    check_bounds(Path::from(0.0, 0.0), None, ((0.0, -50.0), (40.0, 10.0)));
    // A feed all the way from home and back does not make the workpiece small.
    let fed = Path::from(200.0, 200.0).feed(64.0, 2.0).feed(50.0, -30.0).feed(200.0, 200.0);
    check_bounds(fed, Some(STOCK), ((-60.0, -79.0), (64.0, 2.0)));
    let bulge = Path::from(40.0, 0.0).arc(Turn::Clockwise, (40.0, -20.0), (40.0, -10.0));
    check_bounds(bulge, None, ((0.0, -20.0), (40.0, 0.0)));
}

#[test]
fn strokes_carry_their_block_through_all_chunks() {
    let mut path = Path::from(20.0, 0.0);
    for step in 1..=5000 {
        path = path.feed(20.0, -f64::from(step));
    }
    let motions = path.chunks_of(7);
    let path_index = PathIndex::of(&motions);
    let scene = Scene::new(&motions, &path_index, None);
    assert_eq!(scene.strokes().count(), 5000);
    for (index, stroke) in scene.strokes().enumerate() {
        assert_eq!((stroke.motion, stroke.line as usize), (index, index));
        assert_eq!(stroke.shape.end().z, -(index as f64 + 1.0));
    }
    assert_eq!(scene.stroke(4321), scene.strokes().nth(4321));
    assert_eq!(scene.stroke(5000), None);
    assert_eq!(scene.motions_of(Span::new(30_000, 30_025)), vec![3000..3002]);
}

/// Turning passes, ten motions in each chunk of the list.
fn passes(count: usize) -> Vec<Chunk> {
    let mut path = Path::from(20.0, 0.0);
    for step in 0..count {
        path = path.rapid(20.0 + step as f64, 0.0).feed(20.0 + step as f64, -1.0);
    }
    path.chunks_of(10).chunks().to_vec()
}

/// The path index as text, without the chunks of its stretches.
fn said(path_index: &PathIndex) -> Vec<String> {
    let row = |s: &Stretch| (s.motions.clone(), s.cuts, s.rapids, s.bounds, s.span);
    path_index.stretches().iter().map(|stretch| format!("{:?}", row(stretch))).collect()
}

#[test]
fn an_outline_that_grew_equals_one_made_at_once() {
    let chunks = passes(200);
    let (mut grown, mut motions) = (PathIndex::new(), Motions::default());
    for chunk in chunks {
        motions.push(chunk);
        let id = grown.id();
        grown.update(&motions);
        assert_ne!(grown.id(), id);
        assert_eq!(said(&grown), said(&PathIndex::of(&motions)));
    }
    assert_eq!((grown.len(), grown.stretches().len()), (400, 40));
    let id = grown.id();
    grown.update(&motions);
    assert_eq!(grown.id(), id);
}

#[test]
fn an_edit_leaves_the_measures_of_the_chunks_that_stay() {
    let mut motions = Motions::default();
    passes(100).into_iter().for_each(|chunk| motions.push(chunk));
    let mut path_index = PathIndex::of(&motions);
    let before: Vec<StretchKey> = path_index.stretches().iter().map(|stretch| stretch.key).collect();
    // As in a run: the chunks after the edit return once those before them are complete again.
    let rest = motions.split_off(10).split_off(2);
    path_index.update(&motions);
    for chunk in passes(3) {
        motions.push(chunk);
        path_index.update(&motions);
    }
    motions.append(rest, |_, chunk| (chunk.base, chunk.first_line) = (chunk.base + 7, chunk.first_line + 1));
    path_index.update(&motions);
    path_index.settle();
    assert_eq!(said(&path_index), said(&PathIndex::of(&motions)));
    let after: Vec<StretchKey> = path_index.stretches().iter().map(|stretch| stretch.key).collect();
    assert_eq!((&after[..10], &after[11..]), (&before[..10], &before[12..]));
    assert!(!before.contains(&after[10]));
}

#[test]
fn a_long_chunk_has_several_stretches() {
    let mut path = Path::from(20.0, 0.0);
    for step in 1..=3000 {
        path = path.feed(20.0, -f64::from(step));
    }
    let motions = path.chunks_of(3000);
    let path_index = PathIndex::of(&motions);
    assert_eq!(path_index.stretches().len(), 3000usize.div_ceil(STRETCH));
    let scene = Scene::new(&motions, &path_index, None);
    assert_eq!(scene.motions_of(Span::new(20_470, 20_490)), vec![2047..2049]);
}

#[test]
fn places_along_the_path() {
    // 30 mm of radius, a dwell, a half circle of radius 10, 10 mm back.
    let path = Path::from(100.0, 0.0)
        .rapid(40.0, 0.0)
        .dwell()
        .arc(Turn::Counterclockwise, (40.0, -20.0), (40.0, -10.0))
        .feed(60.0, -20.0);
    let motions = path.motions();
    let path_index = PathIndex::of(&motions);
    let scene = Scene::new(&motions, &path_index, None);
    let check = |motion: usize, share: f64, at: Point| {
        let place = scene.place(Playhead { motion, share }).expect("a place");
        assert!(place.motion == motion && place.at.is_same(at), "{motion}: {place:?}");
    };
    check(0, 0.0, point(100.0, 0.0));
    check(0, 0.5, point(70.0, 0.0));
    check(1, 0.5, point(40.0, 0.0));
    check(2, 0.5, point(60.0, -10.0));
    check(3, 0.5, point(50.0, -20.0));
    check(3, 1.0, point(60.0, -20.0));
    assert_eq!(scene.place(Playhead::end_of(4)), None);
}

#[test]
fn a_stroke_split_at_a_place_keeps_its_length() {
    let path = Path::from(60.0, 0.0).arc(Turn::Clockwise, (60.0, 0.0), (40.0, 0.0)).feed(20.0, -7.0);
    let motions = path.motions();
    let path_index = PathIndex::of(&motions);
    let scene = Scene::new(&motions, &path_index, None);
    for stroke in scene.strokes() {
        for t in [0.0, 0.3, 1.0] {
            let (before, after) = stroke.shape.split(t);
            assert!(
                (before.length() + after.length() - stroke.shape.length()).abs() < 1e-6,
                "{t} {before:?}"
            );
            assert!(before.end().is_same(stroke.shape.at(t)) && after.start().is_same(stroke.shape.at(t)));
        }
    }
}
