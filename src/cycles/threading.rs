//! Threads: a single pass with its pull-out, as in G92, and the passes of G76.
//!
//! In: start point A, thread end E, height and depths. Out: the depth table and the moves. External if E is
//! nearer to the axis than A, internal if farther; the signs alone determine the quadrant. The passes of G76
//! follow seed 003 and GSK980TDb p. 138. Must not know words and leads. Zero-length moves are kept: the code
//! that stores motions drops them.

use super::{Move, sign};
use crate::geometry::{Point, SAME};
use crate::motion::{MotionKind, Step};

/// δ2 = n·L / 1800 (seed 001): the distance in which the slide stops at the end of a thread, mm. `speed`: rpm;
/// `lead`: mm.
pub fn run_out(speed: f64, lead: f64) -> f64 {
    speed * lead / 1800.0
}

/// δ1 = δ2 · (−1 − ln a): the distance in which the slide reaches the lead, mm, except for a permitted error `a`.
pub fn run_in(speed: f64, lead: f64, error: f64) -> f64 {
    run_out(speed, lead) * (-1.0 - error.ln())
}

/// The usual permitted error of the lead: 1 %.
pub const LEAD_ERROR: f64 = 0.01;

/// How a thread leaves the workpiece before its end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PullOut {
    /// Length along the thread, mm, unsigned.
    pub along: f64,
    /// Distance out of the workpiece, radius in mm, unsigned; equal to `along` for the usual 45°.
    pub out: f64,
}

/// One pass of a thread.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pass {
    /// Pass, from 1.
    pub number: u32,
    /// Start of the cut.
    pub begin: Point,
    /// End of the cut without a pull-out.
    pub end: Point,
    /// Direction out of the workpiece in X: 1 for larger radii (external), −1 for smaller, 0 for none.
    pub away: f64,
    /// The pull-out, if any.
    pub pull_out: Option<PullOut>,
}

impl Pass {
    /// Rapid to the depth, cut, pull-out, rapid out of the workpiece to the X of `home`, rapid to `home`.
    pub fn push_moves(&self, home: Point, moves: &mut Vec<Move>) {
        let mut push = |kind, step, to| moves.push(Move::new(kind, step, self.number, to));
        push(MotionKind::Rapid, Step::Infeed, self.begin);
        let mut last = self.end;
        if let Some(pull_out) = self.pull_out {
            let (from, to) = self.leave(home, pull_out);
            push(MotionKind::Thread, Step::Cut, from);
            push(MotionKind::Thread, Step::PullOut, to);
            last = to;
        } else {
            push(MotionKind::Thread, Step::Cut, self.end);
        }
        push(MotionKind::Rapid, Step::Retract, Point::new(home.x, last.z));
        push(MotionKind::Rapid, Step::Return, home);
    }

    /// Start and end of the pull-out. It is not longer than the thread and does not pass the X of `home`; its
    /// angle is kept (seeds 000, 001 and 004).
    fn leave(&self, home: Point, pull_out: PullOut) -> (Point, Point) {
        let length = self.end.z - self.begin.z;
        let along = pull_out.along.min(length.abs());
        let out = if along < pull_out.along { pull_out.out * along / pull_out.along } else { pull_out.out };
        let part = if length.abs() > SAME { along / length.abs() } else { 0.0 };
        let from =
            Point::new(self.end.x + part * (self.begin.x - self.end.x), self.end.z - along.copysign(length));
        let room = self.away * (home.x - from.x);
        let to = if room <= 0.0 {
            from
        } else if out > room {
            Point::new(home.x, from.z + (along * room / out).copysign(length))
        } else {
            Point::new(from.x + self.away * out, self.end.z)
        };
        (from, to)
    }
}

/// The cutting edges of the tool: P1 to P4 of the one-block G76.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Edge {
    /// The leading edge: infeed along the other flank (P1, P3, and the two-block G76).
    Leading,
    /// Both edges alternately (P2, P4).
    InTurn,
}

/// How the depth grows from pass to pass.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Load {
    /// Equal chip areas: depth √n · Δd (P1, P2, and the two-block G76).
    EvenArea,
    /// Equal steps: depth n · Δd (P3, P4).
    EvenDepth,
}

/// How the minimum depth of cut is applied.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Clamp {
    /// To the difference from the previous depth: every step is at least Δdmin.
    Previous,
    /// To the root formula, √(n−1) · Δd: as printed by GSK.
    Root,
}

/// The parameters of G76. Depths are radii in mm, below the crest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MultiThread {
    /// E: end of the thread, at its root.
    pub end: Point,
    /// i: radius at the start of the thread (Z of A) minus radius at its end, mm.
    pub taper: f64,
    /// k: height of the thread.
    pub height: f64,
    /// Δd: depth of the first pass.
    pub first_depth: f64,
    /// Δdmin: least step from pass to pass; zero for none.
    pub least_depth: f64,
    /// d: allowance for the first finishing pass; its sign is ignored.
    pub allowance: f64,
    /// m: number of finishing passes; at least one is made.
    pub finishing: u32,
    /// The pull-out of each pass, if any.
    pub pull_out: Option<PullOut>,
    /// a: angle of the tool, radians, from 0 to less than half a turn; at 0 the infeed is along X.
    pub angle: f64,
    /// How the minimum depth of cut is applied.
    pub clamp: Clamp,
    /// The cutting edges.
    pub edge: Edge,
    /// How the depth grows.
    pub load: Load,
}

/// Why there are no moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ThreadingError {
    /// The angle of the tool is invalid (PS0315).
    Angle,
    /// The least depth is larger than the height (PS0316).
    LeastDepthTooLarge,
    /// The height is zero or negative (PS0317).
    NoHeight,
    /// The first depth is zero or negative (PS0317).
    NoFirstDepth,
    /// More moves than allowed.
    TooManyMoves,
}

impl MultiThread {
    /// Depth of roughing pass `number` (from 1), not limited by the height. Never decreases with `number`.
    fn roughing(&self, number: f64) -> f64 {
        let (first, least) = (self.first_depth, self.least_depth.max(0.0));
        match (self.load, self.clamp) {
            (Load::EvenDepth, _) => number * first.max(least),
            (Load::EvenArea, Clamp::Root) => {
                (number.sqrt() * first).max((number - 1.0).sqrt() * first + least)
            }
            (Load::EvenArea, Clamp::Previous) => {
                // After this many passes √n − √(n−1) is always below Δdmin/Δd.
                let ratio = first / least;
                let free = if ratio > 1.0 { ((ratio + 1.0 / ratio) / 2.0).powi(2).floor() } else { 0.0 };
                if number <= free {
                    number.sqrt() * first
                } else {
                    free.sqrt() * first + (number - free) * least
                }
            }
        }
    }

    /// Start of the cut of a pass along Z, mm from A towards E. It advances with the depth, so that one flank
    /// is not cut. With both edges alternately, every second pass follows the other flank; both meet at full
    /// depth (GSK980TDb p. 138; the zero of the shift differs between controls).
    fn advance(&self, number: u32, depth: f64) -> f64 {
        let across = match self.edge {
            Edge::InTurn if number.is_multiple_of(2) => 2.0 * self.height - depth,
            Edge::InTurn | Edge::Leading => depth,
        };
        across * (self.angle / 2.0).tan()
    }
}

/// The depth of every pass: roughing down to k − d, then m passes at k, of which the first removes d.
///
/// If d leaves no depth for roughing, there are finishing passes only.
pub fn depths(thread: &MultiThread, most_passes: usize) -> Result<Vec<f64>, ThreadingError> {
    if sign(thread.height) <= 0.0 {
        return Err(ThreadingError::NoHeight);
    }
    if sign(thread.first_depth) <= 0.0 {
        return Err(ThreadingError::NoFirstDepth);
    }
    if thread.least_depth > thread.height + SAME {
        return Err(ThreadingError::LeastDepthTooLarge);
    }
    let finishing = thread.finishing.max(1) as usize;
    let Some(most_roughing) = most_passes.checked_sub(finishing) else {
        return Err(ThreadingError::TooManyMoves);
    };
    let rough = thread.height - thread.allowance.abs();
    let reached = |number: usize| thread.roughing(number as f64) >= rough - SAME;
    let mut out = Vec::new();
    if rough > SAME {
        if most_roughing == 0 || !reached(most_roughing) {
            return Err(ThreadingError::TooManyMoves);
        }
        out.extend((1..).take_while(|&number| !reached(number)).map(|number| thread.roughing(number as f64)));
        out.push(rough);
    }
    out.resize(out.len() + finishing, thread.height);
    Ok(out)
}

/// G76: each pass has an infeed along a flank, a cut, a pull-out and a return to the start point.
pub fn thread(start: Point, thread: &MultiThread, most_moves: usize) -> Result<Vec<Move>, ThreadingError> {
    if !(0.0..std::f64::consts::PI).contains(&thread.angle) {
        return Err(ThreadingError::Angle);
    }
    let moves_a_pass = if thread.pull_out.is_some() { 5 } else { 4 };
    let depths = depths(thread, most_moves / moves_a_pass)?;
    let way = thread.end.z - start.z;
    let away = sign(start.x - thread.end.x);
    let mut moves = Vec::with_capacity(depths.len() * moves_a_pass);
    for (number, depth) in (1..).zip(depths) {
        let x = thread.end.x + away * (thread.height - depth);
        let advance = thread.advance(number, depth).min(way.abs());
        let left = if way.abs() > SAME { 1.0 - advance / way.abs() } else { 1.0 };
        let pass = Pass {
            number,
            begin: Point::new(x + thread.taper * left, start.z + sign(way) * advance),
            end: Point::new(x, thread.end.z),
            away,
            pull_out: thread.pull_out,
        };
        pass.push_moves(start, &mut moves);
    }
    Ok(moves)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cycles::listing::{MANY, Map, at, check};

    fn same_way(length: f64) -> Option<PullOut> {
        Some(PullOut { along: length, out: length })
    }

    /// Seed 003, example 6: lead 4, pull-out of one lead.
    fn seed() -> MultiThread {
        MultiThread {
            end: at(33.8, -60.0),
            taper: 0.0,
            height: 2.4,
            first_depth: 0.7,
            least_depth: 0.1,
            allowance: 0.1,
            finishing: 1,
            pull_out: same_way(4.0),
            angle: 60_f64.to_radians(),
            clamp: Clamp::Previous,
            edge: Edge::Leading,
            load: Load::EvenArea,
        }
    }

    /// `G76 P020060 Q100 R0.05`, `G76 X27.4 Z-30 P1300 Q450 F2`.
    fn metric() -> MultiThread {
        MultiThread {
            end: at(27.4, -30.0),
            height: 1.3,
            first_depth: 0.45,
            allowance: 0.05,
            finishing: 2,
            pull_out: None,
            ..seed()
        }
    }

    #[test]
    fn seed_003_example_6() {
        let start = at(60.0, 10.0);
        check(
            start,
            &thread(start, &seed(), MANY).unwrap(),
            "
            #1 R(37.2,9.5959) T(37.2,-56) T(45.2,-60) R(60,-60) R(60,10)
            #2 R(36.6201,9.4285) T(36.6201,-56) T(44.6201,-60) R(60,-60) R(60,10)
            #3 R(36.1751,9.3) T(36.1751,-56) T(44.1751,-60) R(60,-60) R(60,10)
            #4 R(35.8,9.1917) T(35.8,-56) T(43.8,-60) R(60,-60) R(60,10)
            #5 R(35.4695,9.0963) T(35.4695,-56) T(43.4695,-60) R(60,-60) R(60,10)
            #6 R(35.1707,9.0101) T(35.1707,-56) T(43.1707,-60) R(60,-60) R(60,10)
            #7 R(34.8959,8.9307) T(34.8959,-56) T(42.8959,-60) R(60,-60) R(60,10)
            #8 R(34.6402,8.8569) T(34.6402,-56) T(42.6402,-60) R(60,-60) R(60,10)
            #9 R(34.4,8.7876) T(34.4,-56) T(42.4,-60) R(60,-60) R(60,10)
            #10 R(34.1728,8.722) T(34.1728,-56) T(42.1728,-60) R(60,-60) R(60,10)
            #11 R(34,8.6721) T(34,-56) T(42,-60) R(60,-60) R(60,10)
            #12 R(33.8,8.6144) T(33.8,-56) T(41.8,-60) R(60,-60) R(60,10)
            ",
        );
    }

    #[test]
    fn the_least_depth_is_kept_and_finishing_repeats() {
        let start = at(36.0, 5.0);
        let moves = thread(start, &metric(), MANY).unwrap();
        check(
            start,
            &moves,
            "
            #1 R(29.1,4.7402) T(29.1,-30) R(36,-30) R(36,5)
            #2 R(28.7272,4.6326) T(28.7272,-30) R(36,-30) R(36,5)
            #3 R(28.4412,4.55) T(28.4412,-30) R(36,-30) R(36,5)
            #4 R(28.2,4.4804) T(28.2,-30) R(36,-30) R(36,5)
            #5 R(27.9875,4.4191) T(27.9875,-30) R(36,-30) R(36,5)
            #6 R(27.7875,4.3613) T(27.7875,-30) R(36,-30) R(36,5)
            #7 R(27.5875,4.3036) T(27.5875,-30) R(36,-30) R(36,5)
            #8 R(27.5,4.2783) T(27.5,-30) R(36,-30) R(36,5)
            #9 R(27.4,4.2494) T(27.4,-30) R(36,-30) R(36,5)
            #10 R(27.4,4.2494) T(27.4,-30) R(36,-30) R(36,5)
            ",
        );
        let steps: Vec<Step> = moves[..5].iter().map(|step| step.step).collect();
        assert_eq!(steps, [Step::Infeed, Step::Cut, Step::Retract, Step::Return, Step::Infeed]);
    }

    #[test]
    fn a_tapered_thread_runs_parallel_to_its_taper() {
        // 1:16 over 40 mm: 1.25 in radius. Straight infeed: the cone begins at the Z of A.
        let start = at(50.0, 5.0);
        let pipe = MultiThread {
            end: at(40.0, -35.0),
            taper: -1.25,
            height: 1.0,
            first_depth: 1.0,
            allowance: 0.0,
            pull_out: same_way(2.0),
            angle: 0.0,
            ..seed()
        };
        let one = "R(37.5,5) T(39.875,-33) T(43.875,-35) R(50,-35) R(50,5)";
        check(start, &thread(start, &pipe, MANY).unwrap(), &format!("#1 {one}\n#2 {one}"));
        // With a flank infeed the cut begins farther along the same line.
        let flank = MultiThread { angle: 60_f64.to_radians(), ..pipe };
        let moves = thread(start, &flank, MANY).unwrap();
        let along = 30_f64.to_radians().tan();
        assert!(moves[0].to.is_same(Point::new(18.75 + 1.25 * along / 40.0, 5.0 - along)));
        assert!(moves[1].to.is_same(at(39.875, -33.0)));
    }

    #[test]
    fn a_tapered_thread_with_everything() {
        // `G76 P021060 Q120 R0.05`, `G76 X28.6 Z-24 P1100 Q400 F2`.
        let start = at(40.0, 6.0);
        let wanted = MultiThread {
            end: at(28.6, -24.0),
            taper: -1.5,
            height: 1.1,
            first_depth: 0.4,
            least_depth: 0.12,
            pull_out: same_way(2.0),
            ..metric()
        };
        check(
            start,
            &thread(start, &wanted, MANY).unwrap(),
            "
            #1 R(27.0231,5.7691) T(29.8,-22) T(33.8,-24) R(40,-24) R(40,6)
            #2 R(26.7013,5.6734) T(29.4686,-22) T(33.4686,-24) R(40,-24) R(40,6)
            #3 R(26.4544,5.6) T(29.2144,-22) T(33.2144,-24) R(40,-24) R(40,6)
            #4 R(26.2213,5.5307) T(28.9744,-22) T(32.9744,-24) R(40,-24) R(40,6)
            #5 R(25.9882,5.4614) T(28.7344,-22) T(32.7344,-24) R(40,-24) R(40,6)
            #6 R(25.7606,5.3938) T(28.5,-22) T(32.5,-24) R(40,-24) R(40,6)
            #7 R(25.6635,5.3649) T(28.4,-22) T(32.4,-24) R(40,-24) R(40,6)
            #8 R(25.6635,5.3649) T(28.4,-22) T(32.4,-24) R(40,-24) R(40,6)
            ",
        );
    }

    #[test]
    fn mirrored_threads_make_mirrored_moves() {
        let start = Point::new(30.0, 10.0);
        let outside = MultiThread { taper: -1.5, ..seed() };
        let plain = thread(start, &outside, MANY).unwrap();
        // Reflected in X about A, an external thread becomes an internal one.
        let maps: [(Map, f64); 3] = [
            (|point| Point::new(point.x, -point.z), 1.0),
            (|point| Point::new(60.0 - point.x, point.z), -1.0),
            (|point| Point::new(60.0 - point.x, -point.z), -1.0),
        ];
        for (map, turned) in maps {
            let mirrored = MultiThread { end: map(outside.end), taper: turned * outside.taper, ..outside };
            let other = thread(map(start), &mirrored, MANY).unwrap();
            assert_eq!(plain.len(), other.len());
            for (plain, other) in plain.iter().zip(&other) {
                assert!(map(plain.to).is_same(other.to), "{plain:?} {other:?}");
                assert_eq!((plain.kind, plain.step, plain.pass), (other.kind, other.step, other.pass));
            }
        }
    }

    #[test]
    fn depths_follow_the_formula_word_by_word() {
        for clamp in [Clamp::Previous, Clamp::Root] {
            for first in 1..40 {
                for least in 0..12 {
                    let thread = MultiThread {
                        first_depth: f64::from(first) * 0.05,
                        least_depth: f64::from(least) * 0.03,
                        clamp,
                        ..seed()
                    };
                    let (mut wanted, mut before, mut number) = (Vec::new(), 0.0, 1.0_f64);
                    while before < 2.3 - SAME {
                        let root = number.sqrt() * thread.first_depth;
                        let base = match clamp {
                            Clamp::Previous => before,
                            Clamp::Root => (number - 1.0).sqrt() * thread.first_depth,
                        };
                        before = f64::max(root, base + thread.least_depth);
                        if before >= 2.3 - SAME {
                            before = 2.3;
                        }
                        wanted.push(before);
                        number += 1.0;
                    }
                    wanted.push(2.4);
                    let got = depths(&thread, MANY).unwrap();
                    assert_eq!(got.len(), wanted.len(), "{thread:?}");
                    for (got, wanted) in got.iter().zip(&wanted) {
                        assert!((got - wanted).abs() < SAME, "{got} {wanted} {thread:?}");
                    }
                }
            }
        }
    }

    #[test]
    fn equal_steps_of_depth() {
        let even = MultiThread { load: Load::EvenDepth, ..seed() };
        let wanted = [0.7, 1.4, 2.1, 2.3, 2.4];
        for (got, wanted) in depths(&even, MANY).unwrap().iter().zip(wanted) {
            assert!((got - wanted).abs() < SAME);
        }
    }

    #[test]
    fn one_roughing_pass_where_the_first_is_deep_and_none_where_finishing_takes_all() {
        let deep = MultiThread { first_depth: 5.0, ..metric() };
        assert_eq!(depths(&deep, MANY), Ok(vec![1.25, 1.3, 1.3]));
        let all = MultiThread { allowance: 1.3, ..metric() };
        assert_eq!(depths(&all, MANY), Ok(vec![1.3, 1.3]));
        let none = MultiThread { first_depth: 5.0, allowance: 0.0, finishing: 0, ..metric() };
        assert_eq!(depths(&none, MANY), Ok(vec![1.3, 1.3]));
    }

    #[test]
    fn both_edges_in_turn_stay_within_the_finished_groove() {
        let start = at(36.0, 5.0);
        let turns = MultiThread { edge: Edge::InTurn, ..metric() };
        let moves = thread(start, &turns, MANY).unwrap();
        let single = thread(start, &metric(), MANY).unwrap();
        let center = 5.0 - 1.3 * 30_f64.to_radians().tan();
        let infeeds = |moves: &[Move]| moves.iter().filter(|step| step.step == Step::Infeed).count();
        assert_eq!(infeeds(&moves), infeeds(&single));
        for (step, one) in moves.iter().zip(&single).filter(|(step, _)| step.step == Step::Infeed) {
            assert!((step.to.x - one.to.x).abs() < SAME);
            let (side, one) = (step.to.z - center, one.to.z - center);
            assert!((side - if step.pass % 2 == 0 { -one } else { one }).abs() < SAME);
        }
    }

    #[test]
    fn pull_outs_pass_neither_the_start_x_nor_the_thread() {
        for start_x in [34.0, 36.0, 38.6, 44.0, 60.0] {
            for length in [0.0, 0.4, 4.0, 30.0, 200.0] {
                for taper in [-3.0, 0.0, 3.0] {
                    let start = at(start_x, 10.0);
                    let wanted = MultiThread { pull_out: same_way(length), taper, ..seed() };
                    let moves = thread(start, &wanted, MANY).unwrap();
                    for five in moves.chunks(5) {
                        let [begin, from, to] = [five[0].to, five[1].to, five[2].to];
                        assert_eq!((five[1].step, five[2].step), (Step::Cut, Step::PullOut));
                        assert!(from.z <= begin.z + SAME && from.z >= -60.0 - SAME);
                        assert!(to.z <= from.z + SAME && to.z >= -60.0 - SAME);
                        assert!(to.x >= from.x - SAME);
                        assert!(to.x <= from.x.max(start.x) + SAME);
                        // At 45°, however it was shortened.
                        assert!((to.x - from.x - (from.z - to.z)).abs() < SAME);
                    }
                }
            }
        }
    }

    #[test]
    fn a_thread_shorter_than_its_flank_shift_does_not_run_backwards() {
        let start = at(36.0, -29.5);
        for step in thread(start, &metric(), MANY).unwrap() {
            assert!(step.to.z <= -29.5 + SAME && step.to.z >= -30.0 - SAME);
        }
    }

    #[test]
    fn faults() {
        let with = |wanted: MultiThread| thread(at(60.0, 10.0), &wanted, MANY).unwrap_err();
        assert_eq!(with(MultiThread { angle: 180_f64.to_radians(), ..seed() }), ThreadingError::Angle);
        assert_eq!(with(MultiThread { angle: -0.1, ..seed() }), ThreadingError::Angle);
        assert_eq!(with(MultiThread { height: 0.0, ..seed() }), ThreadingError::NoHeight);
        assert_eq!(with(MultiThread { first_depth: -0.7, ..seed() }), ThreadingError::NoFirstDepth);
        assert_eq!(with(MultiThread { least_depth: 2.5, ..seed() }), ThreadingError::LeastDepthTooLarge);
    }

    #[test]
    fn too_many_passes_answer_at_once() {
        // A first depth of a micrometre on a deep thread: (2.4 / 0.001)² passes.
        let slow = MultiThread { first_depth: 0.001, least_depth: 0.0, ..seed() };
        for wanted in [
            slow,
            MultiThread { height: 1e9, ..slow },
            MultiThread { height: 1e9, least_depth: 0.001, ..slow },
            MultiThread { height: 1e9, load: Load::EvenDepth, ..slow },
            MultiThread { height: 1e9, clamp: Clamp::Root, ..slow },
            MultiThread { finishing: u32::MAX, ..slow },
        ] {
            let fault = thread(at(60.0, 10.0), &wanted, MANY).unwrap_err();
            assert_eq!(fault, ThreadingError::TooManyMoves, "{wanted:?}");
        }
        assert_eq!(thread(at(60.0, 10.0), &seed(), 60).map(|moves| moves.len()), Ok(60));
        assert_eq!(thread(at(60.0, 10.0), &seed(), 59), Err(ThreadingError::TooManyMoves));
    }
}
