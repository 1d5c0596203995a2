//! Random contours: no gouge, no remaining material, no rapid in uncut material, the same result in every
//! quadrant.
//!
//! Contours are created in the frame of the passes (`x` depth, `z` along the passes) and transformed to the
//! lathe by a separate [`View`], so that one picture serves both cycles and all quadrants.

use proptest::prelude::*;

use super::*;

/// Distance from a sampled place to the wall beside it, mm: the rounding error of a crossing.
const BESIDE: f64 = 1e-5;
const CLOSE: f64 = 1e-5;
const SAMPLES: usize = 300;

/// One quadrant of one cycle.
#[derive(Clone, Copy, Debug)]
struct View {
    direction: Direction,
    depth: f64,
    along: f64,
}

const PLAIN: View = View { direction: Direction::Turning, depth: 1.0, along: 1.0 };

impl View {
    fn all() -> impl Iterator<Item = View> {
        [Direction::Turning, Direction::Facing].into_iter().flat_map(|direction| {
            [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)].map(|(depth, along)| View {
                direction,
                depth,
                along,
            })
        })
    }

    /// From the picture to the lathe.
    fn out(self, place: Point) -> Point {
        match self.direction {
            Direction::Turning => Point::new(self.depth * place.x, self.along * place.z),
            Direction::Facing => Point::new(self.along * place.z, self.depth * place.x),
        }
    }

    /// From the lathe to the picture.
    fn back(self, place: Point) -> Point {
        match self.direction {
            Direction::Turning => Point::new(self.depth * place.x, self.along * place.z),
            Direction::Facing => Point::new(self.depth * place.z, self.along * place.x),
        }
    }

    fn turn(self, turn: Turn) -> Turn {
        let mirrors = [self.depth < 0.0, self.along < 0.0, self.direction == Direction::Facing];
        match (mirrors.into_iter().filter(|mirror| *mirror).count() % 2, turn) {
            (0, same) => same,
            (_, Turn::Clockwise) => Turn::Counterclockwise,
            (_, Turn::Counterclockwise) => Turn::Clockwise,
        }
    }

    fn contour(self, contour: &Contour) -> Contour {
        let pieces = contour.pieces.iter().map(|piece| Piece {
            from: self.out(piece.from),
            to: self.out(piece.to),
            arc: piece.arc.map(|(center, turn)| (self.out(center), self.turn(turn))),
        });
        Contour {
            start: self.out(contour.start),
            first: self.out(contour.first),
            approach: contour.approach,
            pieces: pieces.collect(),
        }
    }
}

/// The random values of one piece: steps of a quarter millimetre, so that levels often meet corners.
type Stroke = (i32, i32, Option<(f64, bool)>);

fn stroke() -> impl Strategy<Value = Stroke> {
    let length = prop_oneof![1 => Just(0), 4 => 1..40i32];
    (length, -24..24i32, proptest::option::of((prop_oneof![Just(1.0), 1.0..4.0f64], any::<bool>())))
}

/// An arc from `from` to `to` that does not reverse along the passes, nor (`Monotone`) in depth.
fn bow(from: Point, to: Point, shape: Shape, factor: f64, is_left: bool) -> Option<Piece> {
    let (dx, dz, chord) = ((to.x - from.x).abs(), (to.z - from.z).abs(), from.distance(to));
    let narrow = match shape {
        Shape::Monotone => dx.min(dz),
        Shape::Pockets => dz,
    };
    if narrow < 0.1 {
        return None;
    }
    let radius = factor * chord * chord / (2.0 * narrow);
    let turn = if is_left { Turn::Counterclockwise } else { Turn::Clockwise };
    Some(arc(from, to, radius.max(0.5 * chord), turn))
}

/// A contour in the picture, beginning at the depth `first`·¼ mm above A = (0, 0).
fn draw(first: i32, strokes: &[Stroke], shape: Shape) -> Contour {
    let mut at = match shape {
        Shape::Monotone => {
            Point::new(strokes.iter().map(|stroke| 0.25 * f64::from(stroke.1.abs())).sum(), 0.0)
        }
        Shape::Pockets => Point::new(0.25 * f64::from(first), 0.0),
    };
    let start = at;
    let mut pieces = Vec::new();
    for &(length, fall, round) in strokes {
        let fall = 0.25
            * f64::from(match shape {
                Shape::Monotone => -fall.abs(),
                Shape::Pockets => fall,
            });
        let to = Point::new((at.x + fall).max(0.0), at.z + 0.25 * f64::from(length));
        let piece = round
            .and_then(|(factor, is_left)| bow(at, to, shape, factor, is_left))
            .filter(|bow| points(bow).iter().all(|point| point.x >= 0.0))
            .unwrap_or(line(at, to));
        if !piece.is_empty() {
            pieces.push(piece);
            at = to;
        }
    }
    Contour { start: Point::default(), first: start, approach: Approach::Feed, pieces }
}

/// Points along a piece.
fn points(piece: &Piece) -> Vec<Point> {
    let steps = 200;
    (0..=steps)
        .map(|step| {
            let t = f64::from(step) / f64::from(steps);
            match piece.arc {
                Some((center, turn)) => Arc { start: piece.from, end: piece.to, center, turn }.at(t),
                None => Point::new(
                    piece.from.x + t * (piece.to.x - piece.from.x),
                    piece.from.z + t * (piece.to.z - piece.from.z),
                ),
            }
        })
        .collect()
}

/// Least and greatest depth of a piece at `z`, if it gets there; not computed with the code of the cycle.
fn depths(piece: &Piece, z: f64) -> Option<(f64, f64)> {
    let (low, high) = (piece.from.z.min(piece.to.z), piece.from.z.max(piece.to.z));
    if z < low - BESIDE || z > high + BESIDE {
        return None;
    }
    if high - low <= 2.0 * BESIDE {
        return Some((piece.from.x.min(piece.to.x), piece.from.x.max(piece.to.x)));
    }
    let depth_at = |z: f64| {
        let z = z.clamp(low, high);
        match piece.arc {
            None => {
                piece.from.x + (piece.to.x - piece.from.x) * (z - piece.from.z) / (piece.to.z - piece.from.z)
            }
            Some((center, turn)) => {
                let radius = piece.from.distance(center);
                let side = Arc { start: piece.from, end: piece.to, center, turn }.at(0.5).x - center.x;
                let rise = (radius * radius - (z - center.z).powi(2)).max(0.0).sqrt();
                center.x + rise.copysign(side)
            }
        }
    };
    let all = [z - BESIDE, z, z + BESIDE].map(depth_at);
    Some((all.into_iter().fold(f64::INFINITY, f64::min), all.into_iter().fold(f64::NEG_INFINITY, f64::max)))
}

/// Least and greatest depth of the contour at `z`. Nothing is cut before its start and after its end.
fn depth_of(pieces: &[Piece], z: f64) -> Option<(f64, f64)> {
    pieces
        .iter()
        .filter_map(|piece| depths(piece, z))
        .reduce(|one, other| (one.0.min(other.0), one.1.max(other.1)))
}

/// The workpiece: the depth already cut at each place along the passes.
struct Work {
    places: Vec<(f64, f64)>,
    cuts: Vec<Piece>,
    end: f64,
}

impl Work {
    fn new(end: f64) -> Self {
        let place = |index: usize| end * (index as f64 + 0.377) / SAMPLES as f64;
        Self { places: (0..SAMPLES).map(|index| (place(index), 0.0)).collect(), cuts: Vec::new(), end }
    }

    fn each(&mut self, piece: &Piece, mut visit: impl FnMut(&mut (f64, f64), f64)) {
        let (low, high) = (piece.from.z.min(piece.to.z), piece.from.z.max(piece.to.z));
        for place in self.places.iter_mut().filter(|place| low < place.0 && place.0 < high) {
            let depth = match piece.arc {
                None => {
                    let t = (place.0 - piece.from.z) / (piece.to.z - piece.from.z);
                    piece.from.x + t * (piece.to.x - piece.from.x)
                }
                Some(_) => match depths(piece, place.0) {
                    Some((least, _)) => least,
                    None => continue,
                },
            };
            visit(place, depth);
        }
    }

    fn cut(&mut self, piece: &Piece) {
        self.each(piece, |place, depth| place.1 = place.1.max(depth));
        self.cuts.push(*piece);
    }

    /// Whether a rapid along `piece` meets uncut material.
    fn hits(&mut self, piece: &Piece) -> bool {
        let mut hits = false;
        self.each(piece, |place, depth| hits |= depth > place.1 + CLOSE);
        // For a rapid straight down or up, the depth must have been cut before.
        if (piece.from.z - piece.to.z).abs() < SAME && 0.0 < piece.to.z && piece.to.z < self.end {
            let cut = depth_of(&self.cuts, piece.to.z).map_or(0.0, |(_, deepest)| deepest.max(0.0));
            hits |= piece.from.x.max(piece.to.x) > cut + CLOSE;
        }
        hits
    }
}

/// The moves in the picture, each with its start point.
fn pictured(view: View, start: Point, moves: &[Move]) -> Vec<(Move, Piece)> {
    let mut from = start;
    let picture = |step: &Move| {
        let to = view.back(step.to);
        let turn = match step.kind {
            MotionKind::ArcClockwise => Some(Turn::Clockwise),
            MotionKind::ArcCounterclockwise => Some(Turn::Counterclockwise),
            _ => None,
        };
        let arc = step.center.zip(turn).map(|(center, turn)| (view.back(center), view.turn(turn)));
        let piece = Piece { from, to, arc };
        from = to;
        (*step, piece)
    };
    moves.iter().map(picture).collect()
}

fn check_cut(contour: &Contour, how: &Roughing) -> Result<(), TestCaseError> {
    let Ok(moves) = rough(contour, how, 100_000) else {
        prop_assert!(
            sign(contour.last().z) == 0.0 || contour.pieces.iter().all(|piece| piece.to.x <= SAME),
            "refused: {:?}",
            rough(contour, how, 100_000)
        );
        return Ok(());
    };
    let bottom: Vec<Piece> =
        contour.pieces.iter().map(|piece| piece.shifted(how.allowance.x, how.allowance.z)).collect();
    // Relative to C, so that the surface is at depth 0 and the front at 0.
    let seen = |piece: &Piece| piece.shifted(-how.allowance.x, -how.allowance.z);
    let bottom: Vec<Piece> = bottom.iter().map(seen).collect();
    let end = bottom.last().unwrap().to.z;
    let steps = pictured(PLAIN, contour.start, &moves);
    let last_pass = moves.iter().rposition(|step| step.pass > 0).unwrap_or(0);
    let mut work = Work::new(end);
    let mut seen_passes = 0;
    for (index, (step, piece)) in steps.iter().enumerate() {
        if !how.allowance.is_same(Point::default()) && (index == 0 || index + 1 == steps.len()) {
            // A lies deeper than C by the allowance.
            continue;
        }
        let piece = seen(piece);
        if step.pass > 0 {
            prop_assert!(step.pass == seen_passes || step.pass == seen_passes + 1, "pass numbers");
            seen_passes = step.pass;
        }
        if step.kind == MotionKind::Rapid {
            prop_assert!(!work.hits(&piece), "rapid into the work: move {index} {step:?}");
        } else {
            work.cut(&piece);
        }
        for point in points(&piece) {
            if let Some((_, deepest)) = depth_of(&bottom, point.z) {
                prop_assert!(point.x <= deepest + CLOSE, "gouge: move {index} {step:?} at {point:?}");
            } else {
                prop_assert!(point.z <= 0.0 || point.x <= CLOSE, "outside: move {index} {step:?} {point:?}");
            }
        }
        if index == last_pass {
            for &(z, cut) in &work.places {
                let (least, _) = depth_of(&bottom, z).expect("within the contour");
                prop_assert!(least - cut <= how.depth + CLOSE, "{} mm left at {z}", least - cut);
            }
        }
    }
    for &(z, cut) in &work.places {
        let (least, _) = depth_of(&bottom, z).expect("within the contour");
        prop_assert!(cut >= least - CLOSE, "{} mm left at {z} in the end", least - cut);
    }
    prop_assert_eq!(moves.last().unwrap().to, contour.start);
    Ok(())
}

fn check_quadrants(contour: &Contour, how: &Roughing) -> Result<(), TestCaseError> {
    let plain = rough(contour, how, 100_000);
    for view in View::all() {
        let placed = Roughing { direction: view.direction, allowance: view.out(how.allowance), ..*how };
        let seen = rough(&view.contour(contour), &placed, 100_000);
        let (plain, seen) = match (&plain, &seen) {
            (Ok(plain), Ok(seen)) => (plain, seen),
            (plain, seen) => {
                prop_assert_eq!(plain, seen);
                continue;
            }
        };
        prop_assert_eq!(plain.len(), seen.len());
        let plain = pictured(PLAIN, contour.start, plain);
        for ((plain, one), (seen, other)) in plain.iter().zip(pictured(view, contour.start, seen)) {
            prop_assert_eq!((plain.step, plain.pass), (seen.step, seen.pass));
            prop_assert!(one.to.distance(other.to) < 1e-6, "{:?}: {:?} {:?}", view, plain, seen);
            prop_assert_eq!(one.arc.map(|arc| arc.1), other.arc.map(|arc| arc.1));
            if let (Some((one, _)), Some((other, _))) = (one.arc, other.arc) {
                prop_assert!(one.distance(other) < 1e-9);
            }
            prop_assert_eq!(plain.kind.cuts(), seen.kind.cuts());
        }
    }
    Ok(())
}

fn task(shape: Shape) -> impl Strategy<Value = (Contour, Roughing)> {
    let depth = prop_oneof![Just(0.5), Just(1.0), Just(2.5), 0.3..4.0f64];
    let escape = prop_oneof![Just(0.0), Just(0.5), 0.0..3.0f64];
    let allowance = prop_oneof![
        Just(Point::default()),
        (0.0..0.5f64, 0.0..0.5f64).prop_map(|(x, z)| Point::new(-x, -z)),
    ];
    let approach = prop_oneof![Just(Approach::Rapid), Just(Approach::Feed)];
    let strokes = proptest::collection::vec(stroke(), 1..14);
    (0..60i32, strokes, depth, escape, allowance, approach).prop_map(
        move |(first, strokes, depth, escape, allowance, approach)| {
            let contour = Contour { approach, ..draw(first, &strokes, shape) };
            let how = Roughing {
                direction: Direction::Turning,
                shape,
                depth,
                escape,
                allowance,
                escape_kind: MotionKind::Rapid,
                last_pass: LastPass::Contour,
                checks: Checks::All,
            };
            (contour, how)
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(200) })]

    #[test]
    fn type_one_leaves_nothing_and_gouges_nothing((contour, how) in task(Shape::Monotone)) {
        check_cut(&contour, &how)?;
    }

    #[test]
    fn type_two_leaves_nothing_and_gouges_nothing((contour, how) in task(Shape::Pockets)) {
        check_cut(&contour, &how)?;
    }

    #[test]
    fn type_one_is_the_same_in_every_quadrant((contour, how) in task(Shape::Monotone)) {
        check_quadrants(&contour, &how)?;
    }

    #[test]
    fn type_two_is_the_same_in_every_quadrant((contour, how) in task(Shape::Pockets)) {
        check_quadrants(&contour, &how)?;
    }
}
