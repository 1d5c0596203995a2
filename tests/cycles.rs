//! The cycles on random contours, from program text to motions, checked with independent plain geometry.
//!
//! Programs are defined in the plane of one quadrant and rendered in any: `P` is the axis along which the
//! depth is measured, `L` the axis of the cut, both as radius values in micrometres. Without a transformation
//! P is X and L is Z, the work lies towards -P and the cut goes towards -L. A [`Frame`] swaps the axes,
//! mirrors them and moves the zero.
use std::f64::consts::TAU;

use gcode_playground::analyze;
use gcode_playground::expand::expand;
use gcode_playground::geometry::Point;
use gcode_playground::message::Severity;
use gcode_playground::motion::{Cycle, CycleStep, Feed, Motion, MotionKind};
use gcode_playground::setup::Setup;
use proptest::prelude::*;
use proptest::sample::select;

/// Words are rounded to 0.001 mm.
const TOLERANCE: f64 = 2e-3;

#[derive(Clone, Copy, Debug, PartialEq)]
enum Axis {
    P,
    L,
}
use Axis::{L, P};

/// The placement of the plane of a program on the lathe.
#[derive(Clone, Copy, Debug)]
struct Frame {
    /// P is Z and L is X.
    swap: bool,
    /// Signs of X and Z.
    sign: [i64; 2],
    /// Added to X (radius) and Z.
    shift: [i64; 2],
}

impl Frame {
    const PLAIN: Frame = Frame { swap: false, sign: [1, 1], shift: [0, 0] };

    /// 0 for X, 1 for Z.
    fn axis(self, axis: Axis) -> usize {
        usize::from((axis == L) != self.swap)
    }

    /// Whether clockwise and counter-clockwise are swapped.
    fn reflects(self) -> bool {
        self.swap != (self.sign[0] * self.sign[1] < 0)
    }

    /// A lathe position in the plane of the program, mm.
    fn back(self, point: Point) -> [f64; 2] {
        let [x, z] = [(point.x, 0), (point.z, 1)]
            .map(|(value, at)| (value - mm(self.shift[at])) * self.sign[at] as f64);
        if self.swap { [z, x] } else { [x, z] }
    }

    fn cycle(self, cycle: Cycle) -> Cycle {
        match cycle {
            _ if !self.swap => cycle,
            Cycle::Turning => Cycle::Facing,
            Cycle::Facing => Cycle::Turning,
            Cycle::RoughTurning => Cycle::RoughFacing,
            Cycle::RoughFacing => Cycle::RoughTurning,
            Cycle::FacePecking => Cycle::Grooving,
            Cycle::Grooving => Cycle::FacePecking,
            _ => cycle,
        }
    }

    fn tip(self) -> u8 {
        match self.sign {
            [1, 1] => 3,
            [1, _] => 4,
            [_, 1] => 2,
            _ => 1,
        }
    }
}

fn frame(swaps: bool) -> impl Strategy<Value = Frame> {
    let sign = || select(vec![1i64, -1]);
    (any::<bool>(), sign(), sign(), 0i64..50_000, -50_000i64..50_000).prop_map(move |(swap, x, z, dx, dz)| {
        let dx = if x < 0 { dx + 300_000 } else { dx };
        Frame { swap: swap && swaps, sign: [x, z], shift: [dx, dz] }
    })
}

fn mm(micrometres: i64) -> f64 {
    micrometres as f64 / 1000.0
}

fn decimal(value: i64) -> String {
    let sign = if value < 0 { "-" } else { "" };
    format!("{sign}{}.{:03}", value.abs() / 1000, value.abs() % 1000)
}

#[derive(Clone, Debug)]
enum Word {
    Text(String),
    /// A code, and its counterpart with the axes swapped.
    Code(&'static str, &'static str),
    /// G02 if `true`, otherwise G03.
    Clockwise(bool),
    /// G41 if `true`, otherwise G42.
    Left(bool),
    /// X or Z.
    To(Axis, i64),
    /// U or W.
    By(Axis, i64),
    /// A signed radius value along an axis, with its letters for X and for Z.
    Part([&'static str; 2], Axis, i64),
    /// An unsigned length.
    Size([&'static str; 2], Axis, i64),
    /// The same in micrometres.
    Micro([&'static str; 2], Axis, i64),
}
use Word::{By, Clockwise, Code, Left, Micro, Part, Size, To};

const TAPER: [&str; 2] = ["R", "R"];
const INCREMENT: [&str; 2] = ["U", "W"];
const CENTER: [&str; 2] = ["I", "K"];
const PECK: [&str; 2] = ["P", "Q"];

fn word(text: impl Into<String>) -> Word {
    Word::Text(text.into())
}

/// A word such as `R1.5`.
fn plain(letter: &str, value: i64) -> Word {
    word(format!("{letter}{}", decimal(value)))
}

impl Word {
    fn render(&self, frame: Frame) -> String {
        let signed = |axis: Axis, value: i64| (frame.axis(axis), frame.sign[frame.axis(axis)] * value);
        match *self {
            Word::Text(ref text) => text.clone(),
            Code(plain, swapped) => (if frame.swap { swapped } else { plain }).to_owned(),
            Clockwise(clockwise) => (if clockwise != frame.reflects() { "G02" } else { "G03" }).to_owned(),
            Left(left) => (if left != frame.reflects() { "G41" } else { "G42" }).to_owned(),
            To(axis, value) => {
                let (at, value) = signed(axis, value);
                let value = value + frame.shift[at];
                if at == 0 { format!("X{}", decimal(2 * value)) } else { format!("Z{}", decimal(value)) }
            }
            By(axis, value) => {
                let (at, value) = signed(axis, value);
                if at == 0 { format!("U{}", decimal(2 * value)) } else { format!("W{}", decimal(value)) }
            }
            Part(letters, axis, value) => {
                let (at, value) = signed(axis, value);
                format!("{}{}", letters[at], decimal(value))
            }
            Size(letters, axis, value) => format!("{}{}", letters[frame.axis(axis)], decimal(value)),
            Micro(letters, axis, value) => format!("{}{value}", letters[frame.axis(axis)]),
        }
    }
}

/// A program: an approach to the start point, some blocks, a last move from the start point.
#[derive(Clone, Debug)]
struct Program {
    start: [i64; 2],
    blocks: Vec<Vec<Word>>,
    /// Nose radius of the tool.
    nose: i64,
    /// Pull-out of G92 in tenths of the lead.
    chamfer: i64,
    /// Further dialect settings.
    switches: &'static str,
    /// Every deviation is an alarm.
    strict: bool,
}

impl Program {
    fn new(start: [i64; 2], blocks: Vec<Vec<Word>>) -> Self {
        Self { start, blocks, nose: 0, chamfer: 0, switches: "", strict: false }
    }

    fn text(&self, frame: Frame) -> String {
        let mut text = String::from("O1\nG21 G97 G99 T0101\nM3 S500\n");
        let first = vec![word("G0"), To(P, self.start[0]), To(L, self.start[1]), word("F0.25")];
        let last = vec![word("G0"), By(P, 1500), By(L, 2500)];
        for block in [&first].into_iter().chain(&self.blocks).chain([&last]) {
            let words: Vec<String> = block.iter().map(|word| word.render(frame)).collect();
            text.push_str(&words.join(" "));
            text.push('\n');
        }
        text.push_str("M30\n");
        text
    }

    fn setup(&self, frame: Frame) -> Setup {
        let json = format!(
            r#"{{"initial": {{"x": 990, "z": 700}}, "dialect": {{"threadChamfer": {}{}, "strict": {}}},
                "tools": {{"T0101": {{"noseRadius": {}, "tip": {}}}}}}}"#,
            self.chamfer,
            self.switches,
            self.strict,
            decimal(self.nose),
            frame.tip(),
        );
        Setup::from_json(&json).expect("setup")
    }

    /// The motions after the approach.
    #[track_caller]
    fn run(&self, frame: Frame) -> Vec<Motion> {
        let text = self.text(frame);
        let motions: Vec<Motion> = analyze(text.as_bytes(), &self.setup(frame)).motions.iter().collect();
        let [p, l] = frame.back(motions[0].to);
        assert!(
            (p - mm(self.start[0])).abs() < 1e-9 && (l - mm(self.start[1])).abs() < 1e-9,
            "the approach ends at A\n{text}"
        );
        motions[1..].to_vec()
    }

    /// The same, but checks that there are no errors.
    #[track_caller]
    fn run_whole(&self, frame: Frame) -> Vec<Motion> {
        let motions = self.run(frame);
        let refused = motions.iter().any(|motion| motion.process.incomplete);
        assert!(!refused, "{}{:?}", self.text(frame), self.messages(frame));
        motions
    }

    fn messages(&self, frame: Frame) -> Vec<String> {
        let analysis = analyze(self.text(frame).as_bytes(), &self.setup(frame));
        analysis.diagnostics.iter().map(|one| format!("{}: {:?}", one.message.code(), one.message)).collect()
    }
}

/// One block of a contour after the first.
#[derive(Clone, Debug)]
struct Leg {
    by: [i64; 2],
    /// Radius, and whether it is clockwise.
    arc: Option<(i64, bool)>,
    /// For a quarter circle: its centre relative to the start.
    center: Option<[i64; 2]>,
    /// Corner rounding if `true`, otherwise a chamfer; and the value of its word.
    corner: Option<(bool, i64)>,
    incremental: bool,
}

impl Leg {
    fn line(p: i64, l: i64) -> Self {
        Self { by: [p, l], arc: None, center: None, corner: None, incremental: false }
    }

    fn length(&self) -> f64 {
        (self.by[0] as f64).hypot(self.by[1] as f64)
    }
}

/// How the first block of the contour programs the axis of the cut.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Along {
    /// Not at all: type I.
    Silent,
    /// `W0`.
    Zero,
    /// Its word, without a move.
    Same,
    /// A move by this distance.
    Move(i64),
}

/// A contour: from B along its blocks, ending at the same P as the start point A.
#[derive(Clone, Debug)]
struct Shape {
    rapid: bool,
    along: Along,
    first: [i64; 2],
    legs: Vec<Leg>,
}

/// P of A; L of B.
const BAR: i64 = 100_000;

impl Shape {
    /// The start point A.
    fn start(&self) -> [i64; 2] {
        let lead = if let Along::Move(lead) = self.along { lead } else { 0 };
        [BAR, self.first[1] + lead]
    }

    fn blocks(&self) -> Vec<Vec<Word>> {
        let mut ns = vec![word("N10"), word(if self.rapid { "G00" } else { "G01" }), To(P, self.first[0])];
        match self.along {
            Along::Silent => {}
            Along::Zero => ns.push(By(L, 0)),
            Along::Same | Along::Move(_) => ns.push(To(L, self.first[1])),
        }
        let mut blocks = vec![ns];
        let mut at = self.first;
        for (index, leg) in self.legs.iter().enumerate() {
            let mut block = Vec::new();
            if index + 1 == self.legs.len() {
                block.push(word("N20"));
            }
            block.push(match leg.arc {
                Some((_, clockwise)) => Clockwise(clockwise),
                None => word("G01"),
            });
            for (index, axis) in [P, L].into_iter().enumerate() {
                let by = leg.by[index];
                at[index] += by;
                if by != 0 {
                    block.push(if leg.incremental { By(axis, by) } else { To(axis, at[index]) });
                }
            }
            match (leg.arc, leg.center, leg.corner) {
                (_, Some(center), _) => {
                    block.extend([Part(CENTER, P, center[0]), Part(CENTER, L, center[1])]);
                }
                (Some((radius, _)), ..) => block.push(plain("R", radius)),
                (.., Some((round, value))) => block.push(plain(if round { ",R" } else { ",C" }, value)),
                _ => {}
            }
            if index == 0 {
                block.push(word("F0.1"));
            }
            blocks.push(block);
        }
        blocks
    }

    /// The finished contour including its corners, mm.
    fn pieces(&self) -> Vec<Path> {
        let mut pieces: Vec<Path> = Vec::new();
        let mut at = self.first.map(mm);
        // The length that the previous corner takes from this leg.
        let mut from = at;
        for (index, leg) in self.legs.iter().enumerate() {
            let to = [at[0] + mm(leg.by[0]), at[1] + mm(leg.by[1])];
            let Some((round, value)) = leg.corner else {
                let arc = leg.arc.map(|(radius, clockwise)| {
                    let center = match leg.center {
                        Some(center) => [from[0] + mm(center[0]), from[1] + mm(center[1])],
                        None => arc_center(from, to, mm(radius), clockwise),
                    };
                    (center, clockwise)
                });
                pieces.push(Path { rapid: false, from, to, arc, cycle: None });
                (at, from) = (to, to);
                continue;
            };
            let next = self.legs[index + 1].by.map(mm);
            let (u1, u2) = (unit([to[0] - at[0], to[1] - at[1]]), unit(next));
            let cosine = u1[0] * u2[0] + u1[1] * u2[1];
            // With L to the right and P up, positive is to the left.
            let left = u1[1] * u2[0] - u1[0] * u2[1];
            let trim = if round { mm(value) * (cosine.acos() / 2.0).tan() } else { mm(value) };
            let begin = [to[0] - trim * u1[0], to[1] - trim * u1[1]];
            let end = [to[0] + trim * u2[0], to[1] + trim * u2[1]];
            let arc = round.then(|| (arc_center(begin, end, mm(value), left < 0.0), left < 0.0));
            pieces.push(Path { rapid: false, from, to: begin, arc: None, cycle: None });
            pieces.push(Path { rapid: false, from: begin, to: end, arc, cycle: None });
            (at, from) = (to, end);
        }
        pieces
    }
}

fn unit(vector: [f64; 2]) -> [f64; 2] {
    let length = vector[0].hypot(vector[1]);
    [vector[0] / length, vector[1] / length]
}

/// The centre of the shorter arc: to the right of the path for a clockwise one.
fn arc_center(from: [f64; 2], to: [f64; 2], radius: f64, clockwise: bool) -> [f64; 2] {
    let (dp, dl) = (to[0] - from[0], to[1] - from[1]);
    let chord = dp.hypot(dl);
    let height = (radius * radius - chord * chord / 4.0).max(0.0).sqrt();
    let right = [-dl / chord, dp / chord];
    let side = if clockwise { height } else { -height };
    [(from[0] + to[0]) / 2.0 + side * right[0], (from[1] + to[1]) / 2.0 + side * right[1]]
}

/// Random legs that always continue towards -L; with `pockets` some of them fall.
fn legs(pockets: bool) -> impl Strategy<Value = Vec<Leg>> {
    let leg = (0..6, 100i64..5000, 100i64..8000, 0..6, 10i64..100, any::<[bool; 3]>());
    prop::collection::vec(leg, 1..8).prop_map(move |numbers| {
        let mut legs: Vec<Leg> = Vec::new();
        let corners: Vec<(i32, i64)> = numbers.iter().map(|leg| (leg.3, leg.4)).collect();
        for (kind, p, l, _, _, [falls, clockwise, incremental]) in numbers {
            let p = if pockets && falls { -p } else { p };
            let after_face = legs.last().is_some_and(|leg| leg.by[1] == 0 && leg.by[0] * p < 0);
            let mut leg = match kind {
                0 => Leg::line(0, -l),
                1 if !after_face => Leg::line(p, 0),
                5 => Leg::line(p, -p.abs()),
                _ => Leg::line(p, -l),
            };
            leg.incremental = incremental;
            if kind == 5 {
                leg.arc = Some((p.abs(), clockwise));
                // Going up, a counter-clockwise quarter begins along P.
                let along_p = clockwise != (p > 0);
                leg.center = Some(if along_p { [0, -p.abs()] } else { [p, 0] });
            } else if kind >= 3 {
                // Within one quadrant of the circle.
                let least = leg.length().powi(2) / (2 * p.abs().min(l)) as f64;
                leg.arc = Some((least.ceil() as i64 + l % 100 * 20, kind == 3));
            }
            legs.push(leg);
        }
        for (index, (choice, share)) in corners.into_iter().enumerate().take(legs.len() - 1) {
            let (one, two) = (&legs[index], &legs[index + 1]);
            if choice > 1 || one.arc.is_some() || two.arc.is_some() {
                continue;
            }
            let room = 0.0045 * share as f64 * one.length().min(two.length());
            let (u1, u2) = (unit(one.by.map(mm)), unit(two.by.map(mm)));
            let turn = (u1[0] * u2[0] + u1[1] * u2[1]).clamp(-1.0, 1.0).acos();
            let value = if choice == 1 { room / (turn / 2.0).tan() } else { room };
            if (0.1..2.6).contains(&turn) && value >= 20.0 {
                legs[index].corner = Some((choice == 1, value as i64));
            }
        }
        legs
    })
}

/// A contour that ends at the P of A.
fn shape(pockets: bool, along: impl Strategy<Value = Along>) -> impl Strategy<Value = Shape> {
    (legs(pockets), along, any::<bool>()).prop_map(move |(mut legs, along, rapid)| {
        if legs.iter().all(|leg| leg.by[1] == 0) {
            legs.push(Leg::line(0, -3000));
        }
        let (mut height, mut highest) = (0, 0);
        for leg in &legs {
            height += leg.by[0];
            highest = highest.max(height);
        }
        if pockets || height == 0 {
            highest += 1000;
            let slope = legs.last().is_some_and(|leg| leg.by[0] < 0);
            legs.push(Leg::line(highest - height, if slope { -1000 } else { 0 }));
        }
        Shape { rapid, along, first: [BAR - highest, BAR], legs }
    })
}

fn monotone() -> impl Strategy<Value = Shape> {
    shape(false, Just(Along::Silent))
}

fn pocketed() -> impl Strategy<Value = Shape> {
    let along = prop_oneof![
        2 => Just(Along::Zero),
        1 => Just(Along::Same),
        1 => (500i64..5000).prop_map(Along::Move),
    ];
    shape(true, along)
}

fn any_shape() -> impl Strategy<Value = Shape> {
    prop_oneof![monotone(), pocketed()]
}

/// G71 (G72) in two blocks or in one, then G70.
#[derive(Clone, Copy, Debug)]
struct Roughing {
    depth: i64,
    escape: i64,
    allowance: [i64; 2],
    one_block: bool,
    finish: bool,
    /// The escape is at feed, as on GSK.
    feeds: bool,
}

fn roughing() -> impl Strategy<Value = Roughing> {
    (200i64..4000, 0i64..3000, 0i64..1500, 0i64..1000, 0..4, any::<bool>()).prop_map(
        |(depth, escape, u, w, form, feeds)| Roughing {
            depth,
            escape,
            allowance: [u, w],
            one_block: form == 1,
            finish: form != 2,
            feeds,
        },
    )
}

fn rough_program(shape: &Shape, roughing: Roughing) -> Program {
    let mut blocks = Vec::new();
    let code = || Code("G71", "G72");
    let mut second =
        vec![code(), word("P10 Q20"), By(P, roughing.allowance[0]), By(L, roughing.allowance[1])];
    if roughing.one_block {
        second.push(plain("D", roughing.depth));
    } else {
        blocks.push(vec![code(), Size(INCREMENT, P, roughing.depth), plain("R", roughing.escape)]);
    }
    second.push(word("F0.3"));
    blocks.push(second);
    blocks.extend(shape.blocks());
    if roughing.finish {
        blocks.push(vec![word("G70 P10 Q20")]);
    }
    let mut program = Program::new(shape.start(), blocks);
    if roughing.feeds {
        program.switches = r#", "g71Retract": "feed""#;
    }
    program
}

/// Lowers some contours so that they end below A. The return from there leads through the material that an
/// allowance along L leaves after the contour, so that allowance is removed.
fn lowered(mut shape: Shape, mut roughing: Roughing, below: i64) -> (Shape, Roughing) {
    if below >= 3000 {
        shape.first[0] -= below;
        roughing.allowance[1] = 0;
    }
    (shape, roughing)
}

/// G73, then G70.
#[derive(Clone, Copy, Debug)]
struct Pattern {
    relief: [i64; 2],
    passes: i64,
    allowance: [i64; 2],
    one_block: bool,
}

fn pattern() -> impl Strategy<Value = Pattern> {
    (0i64..20_000, 0i64..5000, 1i64..8, 0i64..1500, 0i64..1000, any::<bool>()).prop_map(
        |(i, k, passes, u, w, one_block)| Pattern { relief: [i, k], passes, allowance: [u, w], one_block },
    )
}

fn pattern_program(shape: &Shape, pattern: Pattern) -> Program {
    let relief = |letters| [Part(letters, P, pattern.relief[0]), Part(letters, L, pattern.relief[1])];
    let mut blocks = Vec::new();
    let mut second = vec![word("G73 P10 Q20"), By(P, pattern.allowance[0]), By(L, pattern.allowance[1])];
    if pattern.one_block {
        second.extend(relief(CENTER));
        second.push(word(format!("D{}", pattern.passes)));
    } else {
        let mut first = vec![word("G73")];
        first.extend(relief(INCREMENT));
        first.push(word(format!("R{}", pattern.passes)));
        blocks.push(first);
    }
    second.push(word("F0.3"));
    blocks.push(second);
    blocks.extend(shape.blocks());
    blocks.push(vec![word("G70 P10 Q20 F0.15")]);
    Program::new(shape.start(), blocks)
}

/// G74: pecks along L, columns along P; G75 with the axes swapped.
#[derive(Clone, Copy, Debug)]
struct Pecking {
    depth: i64,
    peck: i64,
    retract: i64,
    /// Distance to the last column, and step.
    columns: Option<(i64, i64)>,
    relief: i64,
    incremental: bool,
}

fn pecking(columns: bool) -> impl Strategy<Value = Pecking> {
    let column = ((-20_000i64..20_000).prop_filter("a step", |way| way.abs() > 10), 300i64..8000);
    (
        1000i64..40_000,
        500i64..9000,
        0.0..1.0,
        prop::option::weighted(0.7, column),
        -1500i64..1500,
        any::<bool>(),
    )
        .prop_map(move |(depth, peck, share, column, relief, incremental)| {
            let columns = column.filter(|_| columns);
            // Signed only if no step gives the direction.
            let relief = if columns.is_some() { relief.abs() } else { relief };
            Pecking { depth, peck, retract: (share * peck as f64) as i64, columns, relief, incremental }
        })
}

const HOLE: [i64; 2] = [60_000, 60_000];

fn pecking_program(pecking: Pecking) -> Program {
    let code = || Code("G74", "G75");
    let mut second = vec![code()];
    let goal = |axis: Axis, by: i64| {
        let start = HOLE[usize::from(axis == L)];
        if pecking.incremental { By(axis, by) } else { To(axis, start + by) }
    };
    if let Some((way, step)) = pecking.columns {
        second.extend([goal(P, way), Micro(PECK, P, step)]);
    }
    second.extend([goal(L, -pecking.depth), Micro(PECK, L, pecking.peck)]);
    if pecking.columns.is_some() {
        second.push(plain("R", pecking.relief));
    } else if pecking.relief != 0 {
        second.push(Part(TAPER, P, pecking.relief));
    }
    second.push(word("F0.1"));
    Program::new(HOLE, vec![vec![code(), plain("R", pecking.retract)], second])
}

/// The moves according to §7.5.
fn pecks_expected(pecking: Pecking) -> Vec<(bool, [f64; 2])> {
    let mut moves: Vec<(bool, [i64; 2])> = Vec::new();
    let end = HOLE[1] - pecking.depth;
    let mut columns = vec![HOLE[0]];
    if let Some((way, step)) = pecking.columns {
        let count = (way.abs() + step - 1) / step;
        columns.extend((1..count).map(|column| HOLE[0] + way.signum() * step * column));
        columns.push(HOLE[0] + way);
    }
    for (index, &column) in columns.iter().enumerate() {
        if index > 0 {
            moves.push((true, [column, HOLE[1]]));
        }
        let mut target = HOLE[1] - pecking.peck;
        while target > end {
            moves.push((false, [column, target]));
            moves.push((true, [column, target + pecking.retract]));
            target -= pecking.peck;
        }
        moves.push((false, [column, end]));
        let aside = column + pecking.relief * pecking.columns.map_or(1, |(way, _)| -way.signum());
        moves.push((true, [aside, end]));
        moves.push((true, [aside, HOLE[1]]));
    }
    moves.push((true, HOLE));
    without_rests(HOLE.map(mm), moves.into_iter().map(|(rapid, to)| (rapid, to.map(mm))))
}

/// Removes moves without length: they make no motion.
fn without_rests(start: [f64; 2], moves: impl Iterator<Item = (bool, [f64; 2])>) -> Vec<(bool, [f64; 2])> {
    let mut at = start;
    moves.filter(|&(_, to)| std::mem::replace(&mut at, to) != to).collect()
}

/// G76; radius values, micrometres.
#[derive(Clone, Copy, Debug)]
struct Threading {
    finishing: i64,
    pull_out: i64,
    angle: i64,
    least: i64,
    allowance: i64,
    height: i64,
    first: i64,
    lead: i64,
    taper: i64,
    /// From A to the root and to the end.
    way: [i64; 2],
}

fn threading() -> impl Strategy<Value = Threading> {
    (
        (1i64..5, 0i64..21, select(vec![80, 60, 55, 30, 29, 0])),
        (400i64..3000, 0.0..1.0, 0.0..0.5, 0.02..1.2),
        (500i64..4000, -1500i64..1500, 2000i64..6000, 20_000i64..60_000),
    )
        .prop_map(
            |((finishing, pull_out, angle), (height, least, allowance, first), (lead, taper, p, l))| {
                let share = |of: f64| (of * height as f64) as i64;
                Threading {
                    finishing,
                    pull_out,
                    angle,
                    least: share(least * least * 0.5),
                    allowance: share(allowance),
                    height,
                    first: share(first).max(50),
                    lead,
                    taper,
                    way: [height + p, l],
                }
            },
        )
}

fn threading_program(thread: Threading) -> Program {
    let first = format!(
        "G76 P{:02}{:02}{:02} Q{} R{}",
        thread.finishing,
        thread.pull_out,
        thread.angle,
        thread.least,
        decimal(thread.allowance),
    );
    let mut second = vec![word("G76"), To(P, HOLE[0] - thread.way[0]), To(L, HOLE[1] - thread.way[1])];
    if thread.taper != 0 {
        second.push(Part(TAPER, P, thread.taper));
    }
    second.push(word(format!("P{} Q{} F{}", thread.height, thread.first, decimal(thread.lead))));
    Program::new(HOLE, vec![vec![word(first)], second])
}

/// The depths of the passes below the crest, §7.7, mm.
fn thread_depths(thread: Threading) -> Vec<f64> {
    let bottom = mm(thread.height - thread.allowance);
    let mut depths = Vec::new();
    let mut last = 0.0;
    loop {
        let table = mm(thread.first) * (depths.len() as f64 + 1.0).sqrt();
        let depth = table.max(last + mm(thread.least));
        last = depth;
        if depth >= bottom - 1e-6 {
            depths.push(bottom);
            break;
        }
        depths.push(depth);
    }
    depths.extend((0..thread.finishing).map(|_| mm(thread.height)));
    depths
}

/// G90 (G94) and G92, repeated while they are modal.
fn single_program() -> impl Strategy<Value = Program> {
    (
        select(vec![("G90", "G94"), ("G94", "G90"), ("G92", "G92")]),
        prop::collection::vec((100i64..20_000, prop::option::of(500i64..40_000), any::<bool>()), 1..4),
        -4000i64..4000,
        0i64..40,
        0i64..800,
    )
        .prop_map(|((code, swapped), cuts, taper, chamfer, nose)| {
            let mut blocks: Vec<Vec<Word>> = Vec::new();
            for (depth, length, incremental) in cuts {
                let goal = |axis: Axis, start: i64, by: i64| {
                    if incremental { By(axis, -by) } else { To(axis, start - by) }
                };
                let mut block = Vec::new();
                let length = length.or(blocks.is_empty().then_some(30_000));
                if blocks.is_empty() {
                    block.push(Code(code, swapped));
                }
                block.push(goal(P, HOLE[0], depth));
                block.extend(length.map(|length| goal(L, HOLE[1], length)));
                if blocks.is_empty() {
                    let axis = if code == "G94" { L } else { P };
                    block.push(Part(TAPER, axis, taper));
                    block.push(word(if code == "G92" { "F1.5" } else { "F0.2" }));
                }
                blocks.push(block);
            }
            let mut program = Program::new(HOLE, blocks);
            program.chamfer = chamfer;
            if code != "G92" && nose > 400 {
                program.nose = nose;
                let aside = vec![word("G0"), By(P, 2000), By(L, 2000)];
                let on = vec![word("G0"), Left(false), To(P, HOLE[0]), To(L, HOLE[1])];
                program.blocks.splice(0..0, [aside, on]);
                program.blocks.push(vec![word("G0 G40"), By(P, 3000), By(L, 3000)]);
            }
            program
        })
}

fn roughing_programs() -> impl Strategy<Value = Program> {
    (any_shape(), roughing(), 0i64..600).prop_map(|(mut shape, roughing, nose)| {
        // Compensation must not start with an arc.
        shape.legs.insert(0, Leg::line(0, -2000));
        let mut program = rough_program(&shape, roughing);
        if nose > 300 {
            // The nose radius applies to G70 only.
            program.nose = nose;
            for block in &mut program.blocks {
                match &block[..] {
                    [Word::Text(name), ..] if name == "N10" => block.insert(1, Left(false)),
                    [Word::Text(name), Word::Text(_), ..] if name == "N20" => block.insert(1, word("G40")),
                    _ => {}
                }
            }
        }
        program
    })
}

fn pattern_programs() -> impl Strategy<Value = Program> {
    (any_shape(), pattern()).prop_map(|(shape, pattern)| pattern_program(&shape, pattern))
}

fn pecking_programs() -> impl Strategy<Value = Program> {
    pecking(true).prop_map(pecking_program)
}

fn threading_programs() -> impl Strategy<Value = Program> {
    threading().prop_map(threading_program)
}

/// First property: the program in a frame makes the plain motions, transformed to that frame.
#[track_caller]
fn check_turned(program: &Program, frame: Frame) {
    let (plain, turned) = if program.nose == 0 {
        (program.run_whole(Frame::PLAIN), program.run_whole(frame))
    } else {
        // The nose may not fit into a contour: then it fits in no frame.
        (program.run(Frame::PLAIN), program.run(frame))
    };
    let both = || format!("{}{}", program.text(Frame::PLAIN), program.text(frame));
    let near = |a: Option<Point>, b: Option<Point>| match (a, b) {
        (Some(a), Some(b)) => {
            let (a, b) = (Frame::PLAIN.back(a), frame.back(b));
            (a[0] - b[0]).abs() < TOLERANCE && (a[1] - b[1]).abs() < TOLERANCE
        }
        (a, b) => a.is_none() && b.is_none(),
    };
    for (index, (one, two)) in plain.iter().zip(&turned).enumerate() {
        let kind = match two.kind {
            MotionKind::ArcClockwise if frame.reflects() => MotionKind::ArcCounterclockwise,
            MotionKind::ArcCounterclockwise if frame.reflects() => MotionKind::ArcClockwise,
            kind => kind,
        };
        let cycle = two.cycle.map(|step| CycleStep { cycle: frame.cycle(step.cycle), ..step });
        let same = one.kind == kind
            && one.cycle == cycle
            && one.lead == two.lead
            && one.seconds == two.seconds
            && one.process == two.process
            && near(Some(one.from), Some(two.from))
            && near(Some(one.to), Some(two.to))
            && near(one.center, two.center)
            && near(one.programmed.map(|own| own.from), two.programmed.map(|own| own.from))
            && near(one.programmed.map(|own| own.to), two.programmed.map(|own| own.to));
        assert!(same, "motion {index}: {one:?}\n{two:?}\n{}", both());
    }
    assert_eq!(plain.len(), turned.len(), "\n{}", both());
}

/// Property of `expand`: its output makes the same motions to 0.001 mm, and contains no cycle.
#[track_caller]
fn check_expanded(program: &Program, frame: Frame) {
    /// Shorter moves may vanish by rounding.
    const SHORT: f64 = 2.5e-3;
    let (text, setup) = (program.text(frame), program.setup(frame));
    let written = expand(text.as_bytes(), &setup);
    let analysis = analyze(text.as_bytes(), &setup);
    // A finishing cycle that cannot run stays unchanged, with the contour and the other cycles that use it.
    let is_faulty = analysis.diagnostics.iter().any(|found| found.severity == Severity::Error);
    let whole: Vec<Motion> = analysis.motions.iter().collect();
    let again: Vec<Motion> = analyze(written.as_bytes(), &setup).motions.iter().collect();
    let near = |a: Point, b: Point| (a.x - b.x).abs() < 1.001e-3 && (a.z - b.z).abs() < 1.001e-3;
    let (mut ours, mut theirs) = (whole.iter().peekable(), again.iter().peekable());
    loop {
        let (one, two) = match (ours.peek(), theirs.peek()) {
            (None, None) => break,
            (one, two) => (one.copied(), two.copied()),
        };
        if let (Some(one), Some(two)) = (one, two)
            && one.kind == two.kind
            && near(one.from, two.from)
            && near(one.to, two.to)
        {
            let centers = match (one.center, two.center) {
                (Some(a), Some(b)) => near(a, b),
                (a, b) => a.is_none() && b.is_none(),
            };
            let fed = |motion: &Motion| match motion.process.feed {
                _ if motion.kind == MotionKind::Rapid => None,
                _ if motion.kind == MotionKind::Thread => motion.lead,
                Feed::PerTurn(feed) | Feed::PerMinute(feed) => Some(feed),
                Feed::Unset => None,
            };
            assert!(centers && fed(one) == fed(two), "{one:?}\n{two:?}\n{text}\n{written}");
            assert!(two.cycle.is_none() || is_faulty, "{two:?}\n{text}\n{written}");
            ours.next();
            theirs.next();
        } else if one.is_some_and(|motion| motion.length() < SHORT) {
            ours.next();
        } else if two.is_some_and(|motion| motion.length() < SHORT) {
            theirs.next();
        } else {
            panic!("{one:?}\n{two:?}\n{text}\n{written}");
        }
    }
}

/// A stroke in the plane of the program, mm.
#[derive(Clone, Debug)]
struct Path {
    rapid: bool,
    from: [f64; 2],
    to: [f64; 2],
    /// Centre, and whether it is clockwise.
    arc: Option<([f64; 2], bool)>,
    cycle: Option<Cycle>,
}

impl Path {
    fn of(motion: &Motion, frame: Frame) -> Self {
        let clockwise = (motion.kind == MotionKind::ArcClockwise) != frame.reflects();
        Self {
            rapid: !motion.kind.cuts(),
            from: frame.back(motion.from),
            to: frame.back(motion.to),
            arc: motion.center.map(|center| (frame.back(center), clockwise)),
            cycle: motion.cycle.map(|step| frame.cycle(step.cycle)),
        }
    }

    /// The lowest P at `l`, if the path reaches it.
    fn lowest(&self, l: f64) -> Option<f64> {
        let Some((center, clockwise)) = self.arc else {
            let share = (l - self.from[1]) / (self.to[1] - self.from[1]);
            return (0.0..=1.0).contains(&share).then(|| self.from[0] + share * (self.to[0] - self.from[0]));
        };
        let angle = |point: [f64; 2]| (point[0] - center[0]).atan2(point[1] - center[1]);
        let turn = |to: [f64; 2]| {
            let way = if clockwise { angle(self.from) - angle(to) } else { angle(to) - angle(self.from) };
            way.rem_euclid(TAU)
        };
        let radius = (self.from[0] - center[0]).hypot(self.from[1] - center[1]);
        let height = (radius * radius - (l - center[1]).powi(2)).sqrt();
        [center[0] - height, center[0] + height]
            .into_iter()
            .find(|&p| p.is_finite() && turn([p, l]) <= turn(self.to) + 1e-9)
    }
}

/// Second property: after roughing exactly the allowance is left on the contour, and after finishing nothing.
/// No rapid goes through the stock, a bar that ends at the P of A.
#[track_caller]
fn check_cleared(shape: &Shape, allowance: [i64; 2], program: &Program, frame: Frame) {
    let text = program.text(frame);
    let paths: Vec<Path> = program.run_whole(frame).iter().map(|motion| Path::of(motion, frame)).collect();
    let pieces = shape.pieces();
    let [up, off] = allowance.map(mm);
    let (face, end) = (mm(shape.first[1]), pieces[pieces.len() - 1].to[1]);
    let walls: Vec<f64> = pieces
        .iter()
        .flat_map(|piece| [piece.from[1], piece.to[1]])
        .flat_map(|wall| [wall, wall + off])
        .collect();
    let finished = |l: f64| pieces.iter().filter_map(|piece| piece.lowest(l)).reduce(f64::min);

    let (low, high, count) = (end - 3.0, face + off + 3.0, 240);
    let spots: Vec<f64> = (0..count)
        .map(|index| low + (high - low) * (f64::from(index) + 0.4142) / f64::from(count))
        .filter(|l| walls.iter().all(|wall| (l - wall).abs() > 3e-3))
        .collect();
    let mut stock: Vec<f64> =
        spots.iter().map(|&l| if l < face { mm(BAR) } else { f64::NEG_INFINITY }).collect();
    let mut lowest = vec![f64::INFINITY; spots.len()];
    let compare = |lowest: &[f64], up: f64, off: f64, what: &str| {
        for (&l, &found) in spots.iter().zip(lowest) {
            let Some(expected) = finished(l - off) else { continue };
            let expected = expected + up;
            assert!(
                (found - expected).abs() < TOLERANCE,
                "{what}: at L {l} the lowest cut is {found}, not {expected}\n{text}"
            );
        }
    };
    let mut roughed = false;
    for (index, path) in paths.iter().enumerate() {
        if path.cycle == Some(Cycle::Finishing) && !roughed {
            roughed = true;
            compare(&lowest, up, off, "roughing");
        }
        for (spot, &l) in spots.iter().enumerate() {
            let Some(p) = path.lowest(l) else { continue };
            if path.rapid {
                let top = stock[spot];
                assert!(
                    p > top - TOLERANCE,
                    "rapid at L {l}, P {p} through stock up to {top}: {path:?}\n{text}"
                );
                continue;
            }
            if let Some(part) = finished(l) {
                assert!(p > part - TOLERANCE, "{path:?} is inside the part at L {l}\n{text}");
            }
            stock[spot] = stock[spot].min(p);
            lowest[spot] = lowest[spot].min(p);
        }
        // A rapid parallel to P meets no sample position: it must not go below the stock on both sides.
        if path.rapid && (path.from[1] - path.to[1]).abs() < 1e-9 {
            let beside = |l: f64| {
                let cuts = paths[..index].iter().filter(|path| !path.rapid);
                let top = if l < face { mm(BAR) } else { f64::NEG_INFINITY };
                cuts.filter_map(|path| path.lowest(l)).fold(top, f64::min)
            };
            let top = beside(path.to[1] - 1e-5).min(beside(path.to[1] + 1e-5));
            let bottom = path.from[0].min(path.to[0]);
            assert!(bottom > top - TOLERANCE, "{path:?} plunges through stock up to {top}\n{text}");
        }
    }
    if roughed {
        compare(&lowest, 0.0, 0.0, "finishing");
    } else {
        compare(&lowest, up, off, "roughing");
    }
    // The last motion comes after the cycles, which left the tool at A.
    let start = shape.start().map(mm);
    let left = paths[paths.len() - 1].from;
    assert!((left[0] - start[0]).hypot(left[1] - start[1]) < 1e-9, "left at {left:?}\n{text}");
}

/// Checks that the motions of a cycle are these strokes.
#[track_caller]
fn check_strokes(program: &Program, frame: Frame, expected: &[(bool, [f64; 2])]) -> Vec<Path> {
    let text = program.text(frame);
    let mut paths: Vec<Path> =
        program.run_whole(frame).iter().map(|motion| Path::of(motion, frame)).collect();
    paths.pop();
    for (index, (path, &(rapid, to))) in paths.iter().zip(expected).enumerate() {
        let near = (path.to[0] - to[0]).abs() < TOLERANCE && (path.to[1] - to[1]).abs() < TOLERANCE;
        assert!(path.rapid == rapid && near, "stroke {index}: {path:?}, not {rapid} {to:?}\n{text}");
    }
    assert_eq!(paths.len(), expected.len(), "{expected:?}\n{text}");
    paths
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn g71_g72_g70_turn_over_and_move_with_their_program(program in roughing_programs(), frame in frame(true)) {
        check_turned(&program, frame);
    }

    #[test]
    fn g73_g70_turn_over_and_move_with_their_program(program in pattern_programs(), frame in frame(true)) {
        check_turned(&program, frame);
    }

    #[test]
    fn g74_g75_turn_over_and_move_with_their_program(program in pecking_programs(), frame in frame(true)) {
        check_turned(&program, frame);
    }

    #[test]
    fn g76_turns_over_and_moves_with_its_program(program in threading_programs(), frame in frame(false)) {
        check_turned(&program, frame);
    }

    #[test]
    fn g90_g92_g94_turn_over_and_move_with_their_program(
        (program, frame) in single_program().prop_flat_map(|program| {
            let thread = program.text(Frame::PLAIN).contains("G92");
            (Just(program), frame(!thread))
        }),
    ) {
        check_turned(&program, frame);
    }

    #[test]
    fn expanded_programs_make_the_same_motions(
        program in prop_oneof![
            roughing_programs(), pattern_programs(), pecking_programs(), threading_programs(), single_program(),
        ],
        frame in frame(false),
    ) {
        check_expanded(&program, frame);
    }

    #[test]
    fn type_i_roughing_and_finishing_leave_the_contour(
        shape in monotone(), roughing in roughing(), frame in frame(true), below in 0i64..5000,
    ) {
        let (shape, roughing) = lowered(shape, roughing, below);
        check_cleared(&shape, roughing.allowance, &rough_program(&shape, roughing), frame);
    }

    #[test]
    fn type_ii_roughing_and_finishing_leave_the_contour(
        shape in pocketed(), roughing in roughing(), frame in frame(true), below in 0i64..5000,
    ) {
        let roughing = Roughing { allowance: [roughing.allowance[0], 0], ..roughing };
        // G70 returns straight to the start, through the part if a contour ends below its own height.
        let (shape, roughing) = lowered(shape, roughing, if roughing.finish { 0 } else { below });
        check_cleared(&shape, roughing.allowance, &rough_program(&shape, roughing), frame);
    }

    #[test]
    fn pattern_repeating_and_finishing_leave_the_contour(
        shape in monotone(), pattern in pattern(), frame in frame(true),
    ) {
        check_cleared(&shape, pattern.allowance, &pattern_program(&shape, pattern), frame);
    }

    #[test]
    fn pattern_repeating_and_finishing_leave_the_pockets(
        shape in pocketed(), pattern in pattern(), frame in frame(true),
    ) {
        let (relief, allowance) = ([pattern.relief[0], 0], [pattern.allowance[0], 0]);
        let pattern = Pattern { relief, allowance, ..pattern };
        check_cleared(&shape, allowance, &pattern_program(&shape, pattern), frame);
    }

    /// A hole drilled in pecks ends where the same hole drilled in one cut ends; each feed starts from the
    /// retract.
    #[test]
    fn pecked_drilling_ends_where_straight_drilling_ends(pecking in pecking(false), frame in frame(true)) {
        let pecked = check_strokes(&pecking_program(pecking), frame, &pecks_expected(pecking));
        let goal = HOLE[1] - pecking.depth;
        let straight = Program::new(HOLE, vec![vec![word("G1"), To(L, goal)], vec![word("G0"), To(L, HOLE[1])]]);
        let straight = check_strokes(
            &straight, frame, &[(false, [mm(HOLE[0]), mm(goal)]), (true, HOLE.map(mm))],
        );
        let deepest = |paths: &[Path]| paths.iter().map(|path| path.to[1]).fold(f64::INFINITY, f64::min);
        prop_assert!((deepest(&pecked) - deepest(&straight)).abs() < 1e-9);
        let feeds: Vec<&Path> = pecked.iter().filter(|path| !path.rapid).collect();
        prop_assert!((feeds[feeds.len() - 1].to[1] - straight[0].to[1]).abs() < 1e-9);
        for pair in feeds.windows(2) {
            prop_assert!((pair[1].from[1] - pair[0].to[1] - mm(pecking.retract)).abs() < 1e-9);
            prop_assert!(pair[1].to[1] < pair[0].to[1]);
        }
    }

    #[test]
    fn pecks_are_in_columns(pecking in pecking(true), frame in frame(true)) {
        check_strokes(&pecking_program(pecking), frame, &pecks_expected(pecking));
    }

    /// Depths by the table, X at the thread end by the depth, for outside and inside threads.
    #[test]
    fn thread_passes_follow_the_table(thread in threading(), frame in frame(false)) {
        let program = threading_program(thread);
        let [p, l] = HOLE.map(mm);
        let (root, end) = (p - mm(thread.way[0]), l - mm(thread.way[1]));
        let pull = 0.1 * thread.pull_out as f64 * mm(thread.lead);
        let taper = |at: f64| mm(thread.taper) * (end - at) / (end - l);
        let mut strokes = Vec::new();
        let depths = thread_depths(thread);
        for &depth in &depths {
            let bottom = root + mm(thread.height) - depth;
            let begin = l - depth * (thread.angle as f64 / 2.0).to_radians().tan();
            let turn = end + pull;
            let leave = bottom + taper(turn);
            let out = pull.min(p - leave);
            strokes.push((true, [bottom + taper(begin), begin]));
            strokes.push((false, [leave, turn]));
            strokes.push((false, [leave + out, turn - out]));
            strokes.push((true, [p, turn - out]));
            strokes.push((true, [p, l]));
        }
        let strokes = without_rests([p, l], strokes.into_iter());
        check_strokes(&program, frame, &strokes);
        let passes = program.run(frame).iter().filter_map(|motion| motion.cycle).map(|step| step.pass).max();
        prop_assert_eq!(passes, Some(depths.len() as u32));
    }

    /// A cycle that cannot run makes no motions, or uncertain ones along a contour with an error.
    #[test]
    fn a_cycle_that_cannot_run_makes_no_certain_motion(
        shape in monotone(), fault in 0..FAULTS, frame in frame(false), roughing in roughing(),
    ) {
        // A lenient control may run a contour in spite of its fault.
        let mut program = faulty(shape, fault, roughing);
        program.strict = true;
        check_refused(&program, frame);
    }
}

/// Number of faults in [`faulty`].
const FAULTS: usize = 24;

/// A program whose cycle cannot run.
fn faulty(mut shape: Shape, fault: usize, roughing: Roughing) -> Program {
    let [u, w] = roughing.allowance;
    let rough = |shape: &Shape, first: &str, second: &str| {
        let mut blocks = vec![vec![word(first)], vec![word(second), By(P, u), By(L, w), word("F0.3")]];
        blocks.retain(|block| !matches!(&block[0], Word::Text(text) if text.is_empty()));
        blocks.extend(shape.blocks());
        Program::new(shape.start(), blocks)
    };
    let two = |first: &str, second: &str| Program::new(HOLE, vec![vec![word(first)], vec![word(second)]]);
    let whole = Roughing { one_block: false, finish: false, ..roughing };
    match fault {
        // Not monotone: P falls; under both types L reverses.
        0 => {
            shape.legs.insert(0, Leg::line(-1000, -1000));
            rough_program(&shape, whole)
        }
        1 => {
            shape.legs.insert(0, Leg::line(0, -3000));
            shape.legs.insert(1, Leg::line(0, 1000));
            rough_program(&shape, whole)
        }
        2 => {
            shape.along = Along::Zero;
            shape.legs.insert(0, Leg::line(0, -3000));
            shape.legs.insert(1, Leg::line(100, 1000));
            shape.first[0] -= 100;
            rough_program(&shape, whole)
        }
        // Blocks that are missing, or referenced in the wrong order.
        3 => rough(&shape, "G71 U2. R1.", "G71 P10 Q99"),
        4 => rough(&shape, "G71 U2. R1.", "G71 P11 Q20"),
        5 => rough(&shape, "G71 U2. R1.", "G71 Q20"),
        6 => rough(&shape, "G71 U2. R1.", "G71 P10"),
        7 => rough(&shape, "G71 U2. R1.", "G71 P20 Q10"),
        // Depths and passes.
        8 => rough(&shape, "G71 U0. R1.", "G71 P10 Q20"),
        9 => rough(&shape, "G72 W0. R1.", "G72 P10 Q20"),
        10 => rough(&shape, "", "G71 P10 Q20"),
        11 => rough(&shape, "G73 U5. W2. R0", "G73 P10 Q20"),
        12 => rough(&shape, "", "G73 P10 Q20"),
        // Contours that cannot be followed.
        13 => {
            shape.legs.push(Leg::line(2000, -1000));
            rough_program(&shape, whole)
        }
        14 => {
            let last = shape.legs.len() - 1;
            shape.legs[last] = Leg { corner: Some((false, 100)), ..Leg::line(shape.legs[last].by[0], -1000) };
            rough_program(&shape, whole)
        }
        15 => {
            let mut program = rough_program(&shape, whole);
            program.blocks.insert(3, vec![word("G28 U0 W0")]);
            program
        }
        16 => {
            shape.along = Along::Move(2000);
            let mut program = rough_program(&shape, whole);
            program.switches = r#", "typeII": false"#;
            program
        }
        17 => Program::new(shape.start(), vec![vec![word("G70 P10 Q20")]]),
        // Pecks and threads.
        18 => Program::new(HOLE, vec![vec![word("G74 R1.")], vec![word("G74 W-20. Q-3000 F0.1")]]),
        19 => Program::new(HOLE, vec![vec![word("G75 R1.")], vec![word("G75 U-20. P-3000 F0.1")]]),
        20 => two("G76 P011060 Q100 R0.05", "G76 U-6. W-30. P0 Q300 F2."),
        21 => two("G76 P011060 Q100 R0.05", "G76 U-6. W-30. P1200 Q0 F2."),
        22 => two("G76 P011060 Q1300 R0.05", "G76 U-6. W-30. P1200 Q300 F2."),
        _ => two("G76 P011045 Q100 R0.05", "G76 U-6. W-30. P1200 Q300 F2."),
    }
}

/// Last property: no certain motions of the cycle.
#[track_caller]
fn check_refused(program: &Program, frame: Frame) {
    let text = program.text(frame);
    let motions = program.run(frame);
    for motion in motions.iter().filter(|motion| motion.cycle.is_some()) {
        assert!(motion.process.uncertain, "{motion:?} is certain\n{text}");
    }
    for motion in motions.iter().filter(|motion| motion.cycle.is_none()) {
        assert!(motion.process.incomplete, "{motion:?} hides that something was left out\n{text}");
        // The tool is where the cycle would have left it.
        assert!(!motion.process.uncertain, "{motion:?} is uncertain\n{text}");
    }
    let [p, l] = frame.back(motions[0].from);
    let start = program.start.map(mm);
    assert!((p - start[0]).hypot(l - start[1]) < 1e-9, "{:?}\n{text}", motions[0]);
}
