//! Rough turning G71 and rough facing G72, type I (monotone contours) and type II (contours with pockets).
//!
//! In: the finished contour and the parameters of roughing. Out: the moves, or the error in the contour. Must
//! not know words, diameters or messages. Semantics §7.1–§7.3; zero-length moves are kept: the code that
//! stores motions drops them.
//!
//! All four quadrants and both cycles use the same code: everything is transformed into a [`Frame`] whose
//! origin is C, the start point displaced by the allowance. **There `x` is the depth in the workpiece and `z`
//! the distance along a pass**, both from C and increasing in the order of the passes; the contour is the
//! bottom below the tool.
//!
//! A single walk along the contour finds all passes: where it falls below a level, a pass at that level
//! opens; where it rises above the level, the pass closes. The order in which passes open is the order of
//! cutting: each pocket to its bottom before the next one.

use super::{Approach, Contour, Move, Piece, sign};
use crate::geometry::{Arc, Point, SAME, Turn, within};
use crate::motion::{MotionKind, Step};

/// Direction of the passes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// G71: passes along Z, depth in X.
    Turning,
    /// G72: passes along X, depth in Z.
    Facing,
}

impl Direction {
    /// The code of the cycle.
    pub fn code(self) -> &'static str {
        match self {
            Self::Turning => "G71",
            Self::Facing => "G72",
        }
    }
}

/// The permitted contours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shape {
    /// Type I: neither axis reverses.
    Monotone,
    /// Type II: the depth axis may rise and fall.
    Pockets,
}

/// Strictness of the checks of a type I contour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Checks {
    /// Everything that may raise an alarm on a control is an error.
    All,
    /// The depth axis may reverse, arcs may bulge back along the passes, and the contour may reach beyond the
    /// start point by at most one pass. The passes stop at the first wall, and the cut along the contour
    /// removes the rest.
    Forgiving,
}

/// The moves after the passes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LastPass {
    /// One cut along the whole rough contour.
    Contour,
    /// None: directly to the start point (GSK type II without J1).
    Nothing,
}

/// The parameters of roughing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Roughing {
    /// G71 or G72.
    pub direction: Direction,
    /// Type I or II.
    pub shape: Shape,
    /// Depth of a pass, mm, above 0: a radius for G71, a length for G72.
    pub depth: f64,
    /// Escape e, mm, unsigned: the same distance back along the pass and out of the workpiece (radius).
    pub escape: f64,
    /// Displacement of the rough contour from the finished one: `x` a radius, mm, both signed.
    pub allowance: Point,
    /// Motion of the escape: `Rapid` or `Feed`.
    pub escape_kind: MotionKind,
    /// The moves after the passes.
    pub last_pass: LastPass,
    /// Strictness of the checks.
    pub checks: Checks,
}

/// Why a contour cannot be roughed; `piece` is an index into [`Contour::pieces`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RoughingError {
    /// The axis of the passes (G71: Z, G72: X) reverses. PS0064, PS0329.
    NotMonotoneAlong {
        /// The piece where it reverses.
        piece: usize,
    },
    /// Type I: the depth axis (G71: X, G72: Z) reverses. PS0329, PS0064.
    NotMonotoneAcross {
        /// The piece where it reverses.
        piece: usize,
    },
    /// The contour reaches beyond the start point. PS0322.
    BeyondStart {
        /// The piece that does; `None` if the first block (ns) does.
        piece: Option<usize>,
        /// Whether it does so along the passes (G71: in Z) rather than across them.
        along: bool,
    },
    /// The contour has no length to cut along, or no depth.
    NothingToCut,
    /// More moves than allowed: the depth is too small for the size of the workpiece.
    TooManyMoves,
}

/// An axis of the lathe.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// Across the spindle.
    X,
    /// Along the spindle.
    Z,
}

/// Rounding in a drawing, mm: a contour may reverse, or reach beyond the start, by this much.
const DRAWN: f64 = 0.001;

/// The same for an arc, mm: its radius is rounded as well as its ends.
const DRAWN_ARC: f64 = 0.005;

/// All moves of the cycle, from A to A; at most `most_moves`.
pub fn rough(contour: &Contour, how: &Roughing, most_moves: usize) -> Result<Vec<Move>, RoughingError> {
    let frame = Frame::new(contour, how).ok_or(RoughingError::NothingToCut)?;
    let bottom = bottom(contour, &frame, how)?;
    if contour.pieces.len() > most_moves {
        return Err(RoughingError::TooManyMoves);
    }
    let passes = passes(&bottom, how, most_moves / MOVES_OF_A_PASS)?;
    let mut tool = Tool { frame, at: Point::default(), pass: 0, moves: Vec::new() };
    tool.moves.reserve(passes.len() * MOVES_OF_A_PASS + contour.pieces.len() + 5);
    tool.go(MotionKind::Rapid, Step::Approach, Point::default());
    for pass in &passes {
        tool.cut_pass(pass, &bottom, contour.approach, how);
        if tool.moves.len() > most_moves {
            return Err(RoughingError::TooManyMoves);
        }
    }
    tool.finish(contour, &bottom, how);
    if tool.moves.len() > most_moves { Err(RoughingError::TooManyMoves) } else { Ok(tool.moves) }
}

/// The axes in which the allowance points into the finished shape (GSK980TDb p. 100).
pub fn allowance_into_material(contour: &Contour, how: &Roughing) -> Vec<Axis> {
    let Some(frame) = Frame::new(contour, how) else { return Vec::new() };
    let inward = frame.turned(how.allowance);
    // If the start point is at the end of the contour, the direction of cut is unknown.
    let (first, last) = (contour.first, contour.last());
    let runs_back = frame.turned(Point::new(last.x - first.x, last.z - first.z)).z < -SAME;
    let (across, along) = match how.direction {
        Direction::Turning => (Axis::X, Axis::Z),
        Direction::Facing => (Axis::Z, Axis::X),
    };
    [(inward.x, across), (inward.z, along)]
        .into_iter()
        .filter(|&(way, axis)| way > SAME && !(runs_back && axis == along))
        .map(|(_, axis)| axis)
        .collect()
}

/// Infeed, cut, escape and return.
const MOVES_OF_A_PASS: usize = 4;

/// Coordinates with depth in `x` and the distance along the passes in `z`, both from C: see the head of the
/// file.
#[derive(Clone, Copy)]
struct Frame {
    direction: Direction,
    /// C in the plane of the lathe.
    origin: Point,
    /// −1 or 1 each: the signs of the depth and of the direction along the passes.
    depth: f64,
    along: f64,
}

impl Frame {
    /// `None` without a depth or a length to cut.
    fn new(contour: &Contour, how: &Roughing) -> Option<Self> {
        let start = contour.start;
        let plain = Self { direction: how.direction, origin: start, depth: 1.0, along: 1.0 };
        let ends = || contour.pieces.iter().map(|piece| plain.enter(piece.to));
        let far = |first: f64, others: &mut dyn Iterator<Item = f64>| match sign(first) {
            // Then the farthest point of the contour gives the direction.
            0.0 => sign(others.fold(0.0, |far, other| if other.abs() > far.abs() { other } else { far })),
            known => known,
        };
        let depth = far(plain.enter(contour.first).x, &mut ends().map(|end| end.x));
        let along = far(plain.enter(contour.last()).z, &mut ends().map(|end| end.z));
        let origin = Point::new(start.x + how.allowance.x, start.z + how.allowance.z);
        (depth != 0.0 && along != 0.0).then_some(Self { origin, depth, along, ..plain })
    }

    /// Transforms a displacement of the lathe into the frame.
    fn turned(&self, way: Point) -> Point {
        match self.direction {
            Direction::Turning => Point::new(way.x * self.depth, way.z * self.along),
            Direction::Facing => Point::new(way.z * self.depth, way.x * self.along),
        }
    }

    /// Transforms a point of the lathe into the frame.
    fn enter(&self, place: Point) -> Point {
        self.turned(Point::new(place.x - self.origin.x, place.z - self.origin.z))
    }

    /// Transforms a point of the frame to the plane of the lathe.
    fn leave(&self, place: Point) -> Point {
        let (depth, along) = (place.x * self.depth, place.z * self.along);
        match self.direction {
            Direction::Turning => Point::new(self.origin.x + depth, self.origin.z + along),
            Direction::Facing => Point::new(self.origin.x + along, self.origin.z + depth),
        }
    }

    /// Transforms the direction of an arc, into the frame or out of it.
    fn turn(&self, turn: Turn) -> Turn {
        let mirrors = (self.depth < 0.0) ^ (self.along < 0.0) ^ (self.direction == Direction::Facing);
        match (mirrors, turn) {
            (false, same) => same,
            (true, Turn::Clockwise) => Turn::Counterclockwise,
            (true, Turn::Counterclockwise) => Turn::Clockwise,
        }
    }
}

/// The rough contour in the frame, checked, as pieces that do not reverse in either axis.
///
/// If the first block of type II runs along the passes, it is the first piece: its slope is a wall.
fn bottom(contour: &Contour, frame: &Frame, how: &Roughing) -> Result<Vec<Piece>, RoughingError> {
    // The finished contour relative to A equals the rough one relative to C.
    let finished = Frame { origin: contour.start, ..*frame };
    let first = finished.enter(contour.first);
    let shape = how.shape;
    let rough_leniently = how.checks == Checks::Forgiving;
    let beyond = if rough_leniently { how.depth } else { DRAWN };
    if first.x < -DRAWN || first.z < -DRAWN {
        return Err(RoughingError::BeyondStart { piece: None, along: first.x >= -DRAWN });
    }
    let mut bottom = Vec::with_capacity(contour.pieces.len() + 1);
    if shape == Shape::Pockets && first.z > SAME {
        bottom.push(Piece { from: Point::default(), to: first, arc: None });
    }
    let (mut highest, mut farthest) = (first.x, first.z);
    for (index, piece) in contour.pieces.iter().enumerate() {
        let seen = Piece {
            from: finished.enter(piece.from),
            to: finished.enter(piece.to),
            arc: piece.arc.map(|(center, turn)| (finished.enter(center), finished.turn(turn))),
        };
        let known = bottom.len();
        split(&seen, &mut bottom);
        let bulges = rough_leniently && seen.arc.is_some();
        if bulges {
            // An arc of slightly more than a quarter: the passes ignore how far it goes back beyond its
            // start.
            let mut far = farthest;
            for part in &mut bottom[known..] {
                let (from, to) = (part.from.z.max(far), part.to.z.max(far));
                if (from, to) != (part.from.z, part.to.z) {
                    (part.from.z, part.to.z, part.arc) = (from, to, None);
                }
                far = to;
            }
        }
        let rounding = if seen.arc.is_some() { DRAWN_ARC } else { DRAWN };
        for end in bottom[known..].iter().map(|part| part.to) {
            if end.z < farthest - rounding {
                return Err(RoughingError::NotMonotoneAlong { piece: index });
            }
            if shape == Shape::Monotone && end.x > highest + rounding && !rough_leniently {
                return Err(RoughingError::NotMonotoneAcross { piece: index });
            }
            if end.x < -beyond {
                return Err(RoughingError::BeyondStart { piece: Some(index), along: false });
            }
            highest = highest.min(end.x);
            farthest = farthest.max(end.z);
        }
    }
    Ok(bottom)
}

/// Splits an arc where it reverses in an axis, so that the ends of each part are its extremes.
fn split(piece: &Piece, parts: &mut Vec<Piece>) {
    let Some((center, turn)) = piece.arc else {
        parts.push(*piece);
        return;
    };
    let arc = Arc { start: piece.from, end: piece.to, center, turn };
    let (radius, start, sweep) = (arc.radius(), arc.start_angle(), arc.sweep());
    let quarter = std::f64::consts::FRAC_PI_2;
    let mut from = piece.from;
    let mut add = |to: Point| {
        if !from.is_same(to) {
            parts.push(Piece { from, to, arc: piece.arc });
            from = to;
        }
    };
    // The quarter points after the start, in order.
    let quarters = start / quarter;
    let mut next = if sweep > 0.0 { quarters.floor() + 1.0 } else { quarters.ceil() - 1.0 };
    for _ in 0..4 {
        let fraction = (next * quarter - start) / sweep;
        // A quarter point at an end, within the tolerance, is not a reversal.
        if radius * (1.0 - fraction) * sweep.abs() <= SAME || !fraction.is_finite() {
            break;
        }
        if radius * fraction * sweep.abs() > SAME {
            add(arc.at(fraction));
        }
        next += sweep.signum();
    }
    add(piece.to);
}

/// Position along the passes where a piece of the bottom has the depth `level`; that of its nearer end if it
/// never has.
fn crossing(piece: &Piece, level: f64) -> f64 {
    let (from, to) = (piece.from, piece.to);
    if (level - from.x) * (to.x - from.x) <= 0.0 || (level - from.x).abs() <= SAME {
        return from.z;
    }
    if (level - to.x) * (to.x - from.x) >= 0.0 || (level - to.x).abs() <= SAME {
        return to.z;
    }
    let along = match piece.arc {
        None => from.z + (to.z - from.z) * ((level - from.x) / (to.x - from.x)),
        Some((center, _)) => {
            let (radius, depth) = (from.distance(center), level - center.x);
            // The part lies in one quarter of the circle.
            let side = 0.5 * (from.z + to.z) - center.z;
            center.z + ((radius - depth) * (radius + depth)).max(0.0).sqrt().copysign(side)
        }
    };
    within(along, from.z.min(to.z), from.z.max(to.z))
}

/// A pass at the depth `level`·Δd.
struct Pass {
    /// From 1.
    level: usize,
    opening: Opening,
    closing: Gate,
}

/// Where a pass begins.
#[derive(Clone, Copy)]
enum Opening {
    /// At C, in the open.
    Front,
    /// At the foot of a wall, inside a pocket.
    Wall(Gate),
}

impl Opening {
    fn along(self) -> f64 {
        match self {
            Self::Front => 0.0,
            Self::Wall(gate) => gate.along,
        }
    }
}

/// A point where the contour crosses a level.
#[derive(Clone, Copy)]
struct Gate {
    /// Index of the piece of the bottom; the number of pieces for the end of the contour.
    piece: usize,
    /// Distance from C along the passes, mm.
    along: f64,
}

/// A pass whose end was not found yet.
struct Open {
    /// Index of the pass.
    pass: usize,
    /// Greatest depth of the contour since its start.
    deepest: f64,
}

/// All passes in the order of cutting, at most `most`.
///
/// "Reaches a level" means within [`SAME`]: a piece at the level does not end the pass; a piece that starts
/// there and rises ends it at its start. Where nothing is deeper than the level, there is no pass: the last
/// cut along the contour removes the rest.
fn passes(bottom: &[Piece], how: &Roughing, most: usize) -> Result<Vec<Pass>, RoughingError> {
    let levels_above = |depth: f64| ((depth + SAME) / how.depth).floor().max(0.0) as usize;
    let mut passes: Vec<Pass> = Vec::new();
    // The pass at level n is `open[n - 1]`: a pass lies within the one above it.
    let mut open: Vec<Open> = Vec::new();
    let mut useless = Vec::new();
    let end = Gate { piece: bottom.len(), along: bottom.last().map_or(0.0, |piece| piece.to.z) };

    let start = bottom.first().map_or(0.0, |piece| piece.from.x);
    let levels = levels_above(start);
    if levels > most {
        return Err(RoughingError::TooManyMoves);
    }
    for level in 1..=levels {
        open.push(Open { pass: passes.len(), deepest: start });
        passes.push(Pass { level, opening: Opening::Front, closing: end });
    }
    let mut close = |open: &mut Vec<Open>, passes: &mut Vec<Pass>, gate: &dyn Fn(f64) -> Gate| {
        let Some(Open { pass, deepest }) = open.pop() else { return };
        let depth = passes[pass].level as f64 * how.depth;
        passes[pass].closing = gate(depth);
        if deepest - depth <= SAME {
            useless.push(pass);
        }
        if let Some(above) = open.last_mut() {
            above.deepest = above.deepest.max(deepest);
        }
    };
    for (index, piece) in bottom.iter().enumerate() {
        let levels = levels_above(piece.to.x);
        let gate = |depth: f64| Gate { piece: index, along: crossing(piece, depth) };
        while open.len() > levels {
            close(&mut open, &mut passes, &gate);
        }
        if how.shape == Shape::Pockets && open.len() < levels {
            if passes.len().saturating_add(levels - open.len()) > most {
                return Err(RoughingError::TooManyMoves);
            }
            for level in open.len() + 1..=levels {
                let opening = Opening::Wall(gate(level as f64 * how.depth));
                open.push(Open { pass: passes.len(), deepest: piece.to.x });
                passes.push(Pass { level, opening, closing: end });
            }
        }
        if let Some(lowest) = open.last_mut() {
            lowest.deepest = lowest.deepest.max(piece.to.x);
        }
    }
    while !open.is_empty() {
        close(&mut open, &mut passes, &|_| end);
    }
    let mut is_useful = vec![true; passes.len()];
    for pass in useless {
        is_useful[pass] = false;
    }
    let mut each = is_useful.into_iter();
    passes.retain(|_| each.next() == Some(true));
    Ok(passes)
}

/// The wall down which the tool moves to the start of a pass at `depth`: the part that falls without a step,
/// from `above` at most.
fn wall_down(bottom: &[Piece], gate: Gate, depth: f64, above: f64) -> Vec<Piece> {
    let mut wall = Vec::new();
    let mut to = Point::new(depth, gate.along);
    for piece in bottom[..=gate.piece].iter().rev() {
        if piece.to.x <= piece.from.x + SAME {
            break;
        }
        let is_top = piece.from.x <= above;
        let from = if is_top { Point::new(above, crossing(piece, above)) } else { piece.from };
        wall.extend(part(piece, from, to));
        to = from;
        if is_top {
            break;
        }
    }
    wall.reverse();
    wall
}

/// The wall up which the tool moves from the end of a pass at `depth`: the part that rises without a step, up
/// to `above` at most.
fn wall_up(bottom: &[Piece], gate: Gate, depth: f64, above: f64) -> Vec<Piece> {
    let mut wall = Vec::new();
    let mut from = Point::new(depth, gate.along);
    for piece in &bottom[gate.piece..] {
        if piece.to.x >= piece.from.x - SAME {
            break;
        }
        let is_top = piece.to.x <= above;
        let to = if is_top { Point::new(above, crossing(piece, above)) } else { piece.to };
        wall.extend(part(piece, from, to));
        from = to;
        if is_top {
            break;
        }
    }
    wall
}

/// The part of a piece between two of its points, if it has any length.
fn part(piece: &Piece, from: Point, to: Point) -> Option<Piece> {
    // The rounding of the drawing might turn a very short arc into nearly a full circle.
    let arc = piece.arc.filter(|_| from.distance(to) > DRAWN);
    (!from.is_same(to)).then_some(Piece { from, to, arc })
}

/// The moving tool.
struct Tool {
    frame: Frame,
    /// Its position in the frame.
    at: Point,
    pass: u32,
    moves: Vec<Move>,
}

impl Tool {
    fn go(&mut self, kind: MotionKind, step: Step, to: Point) {
        self.moves.push(Move::new(kind, step, self.pass, self.frame.leave(to)));
        self.at = to;
    }

    fn follow(&mut self, wall: &[Piece]) {
        for piece in wall {
            let leave = |point| self.frame.leave(point);
            let seen = Piece {
                from: leave(piece.from),
                to: leave(piece.to),
                arc: piece.arc.map(|(center, turn)| (leave(center), self.frame.turn(turn))),
            };
            self.moves.push(Move::along(&seen, Step::Contour, self.pass));
            self.at = piece.to;
        }
    }

    fn cut_pass(&mut self, pass: &Pass, bottom: &[Piece], approach: Approach, how: &Roughing) {
        self.pass += 1;
        let depth = pass.level as f64 * how.depth;
        let above = (pass.level - 1) as f64 * how.depth;
        match pass.opening {
            Opening::Front => self.go(approach.kind(), Step::Infeed, Point::new(depth, 0.0)),
            Opening::Wall(gate) => {
                let wall = wall_down(bottom, gate, depth, above);
                let top = wall.first().map_or(Point::new(depth, gate.along), |piece| piece.from);
                // Everything above `above` is cut at this place: the tool approaches a new pocket at rapid up
                // to the escape distance.
                let clear = (above - how.escape).max(0.0);
                if self.at.x > clear {
                    self.go(MotionKind::Rapid, Step::Retract, Point::new(clear, self.at.z));
                }
                if (self.at.z - top.z).abs() > SAME {
                    self.go(MotionKind::Rapid, Step::Infeed, Point::new(self.at.x, top.z));
                    self.go(MotionKind::Rapid, Step::Infeed, Point::new(clear, top.z));
                }
                self.go(MotionKind::Feed, Step::Infeed, top);
                self.follow(&wall);
            }
        }
        self.go(MotionKind::Feed, Step::Cut, Point::new(depth, pass.closing.along));
        if how.shape == Shape::Pockets && pass.closing.piece < bottom.len() {
            self.follow(&wall_up(bottom, pass.closing, depth, above));
        }
        let home = pass.opening.along();
        let back = self.at.z - how.escape;
        let back = match pass.opening {
            Opening::Front => back,
            // A narrow pocket has no space for the whole escape.
            Opening::Wall(_) => back.max(home),
        };
        self.go(how.escape_kind, Step::Escape, Point::new(self.at.x - how.escape, back));
        self.go(MotionKind::Rapid, Step::Return, Point::new(self.at.x, home));
    }

    fn finish(&mut self, contour: &Contour, bottom: &[Piece], how: &Roughing) {
        self.pass = 0;
        if how.shape == Shape::Pockets && self.at.z > SAME {
            self.go(MotionKind::Rapid, Step::Retract, Point::new(self.at.x.min(0.0), self.at.z));
            self.go(MotionKind::Rapid, Step::Return, Point::new(self.at.x, 0.0));
        }
        if how.last_pass == LastPass::Contour {
            let rough = Point::new(contour.first.x + how.allowance.x, contour.first.z + how.allowance.z);
            let first = self.frame.enter(rough);
            // A first block along the passes is a wall, on which material may remain.
            let is_wall = how.shape == Shape::Pockets && first.z > SAME;
            let kind = if is_wall { MotionKind::Feed } else { contour.approach.kind() };
            self.go(kind, Step::Infeed, first);
            for piece in &contour.pieces {
                let rough = piece.shifted(how.allowance.x, how.allowance.z);
                self.moves.push(Move::along(&rough, Step::Contour, 0));
                self.at = self.frame.enter(rough.to);
            }
            let highest = bottom.iter().map(|piece| piece.from.x).fold(self.at.x, f64::min);
            let winds = how.shape == Shape::Pockets || how.checks == Checks::Forgiving;
            if winds && highest < self.at.x - SAME {
                // The straight move to the start point would cross the part.
                self.go(MotionKind::Rapid, Step::Retract, Point::new(highest.min(0.0), self.at.z));
            }
        }
        self.moves.push(Move::new(MotionKind::Rapid, Step::Return, 0, contour.start));
    }
}

#[cfg(test)]
mod tests;
