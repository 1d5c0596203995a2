//! Lints for the contours of multiple cycles: start, end, and remaining material.

use std::collections::{BTreeMap, BTreeSet};

use crate::control::contour::{ContourUse, Landmarks};
use crate::control::events::{ContourCall, EventContext, FinishingCall};
use crate::control::words::{Words, with_other_sign};
use crate::cycles::Contour;
use crate::cycles::pattern::Pattern;
use crate::cycles::roughing::{self, Direction, Roughing};
use crate::geometry::{Point, SAME};
use crate::message::{Diagnostic, Fix, Message, said};
use crate::motion::Motion;
use crate::setup::Stock;
use crate::source::Span;
use crate::source::shift::Shift;
use crate::units::Diameter;

/// Lengths that differ by at most this are equal, mm.
const LENGTH_TOLERANCE: f64 = 0.001;
/// Greatest depth of a pass of G73, mm: twice the usual 3 mm of roughing.
const MAX_PATTERN_DEPTH: f64 = 6.0;
/// No insert cuts deeper than this, mm (radius): the infeed of G71 or G72 lacks its decimal point.
const MAX_INFEED: f64 = 15.0;

/// M codes at which another part may be clamped, or this part turned around: stops, program ends, chuck.
const PART_CHANGES: [u64; 8] = [0, 1, 2, 10, 11, 30, 68, 69];

/// The state of the lints for contours.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Contours {
    /// P and Q of the cycle that reads a contour, or read the last one.
    named: (u32, u32),
    /// P and Q of all roughing cycles, including those that could not run.
    asked_to_rough: BTreeSet<(u32, u32)>,
    /// Remarks about words in contours that roughing ignores, with P and Q of the contour: G70 may still use
    /// the words.
    for_finishing: Vec<((u32, u32), Diagnostic)>,
    /// The last roughing of each contour, by P and Q, unless a G70 followed.
    roughed: BTreeMap<(u32, u32), Roughed>,
}

/// The roughing of a contour.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Roughed {
    /// The block of the cycle.
    block: Span,
    code: &'static str,
    /// Start point of the cycle, first and last point of the contour.
    corners: [Point; 3],
    allowance: Point,
    /// Origin of the coordinates: the shifts of G50 and of G52, and the frame.
    zero: (Point, Point, u16),
    tool: (u16, u16),
}

impl Contours {
    /// Handles P and Q of a cycle.
    pub fn named(&mut self, purpose: ContourUse, named: (u32, u32)) {
        self.named = named;
        match purpose {
            ContourUse::Roughing => {
                self.asked_to_rough.insert(named);
            }
            ContourUse::Finishing => {
                self.for_finishing.retain(|other| other.0 != named);
                self.roughed.remove(&named);
            }
        }
    }

    /// Reports a contour that is roughed twice in the same way: the second cycle has nothing to remove.
    pub fn roughs<How>(
        &mut self,
        code: &'static str,
        allowance: Point,
        call: &ContourCall<How>,
        at: &EventContext,
        reports: &mut Vec<Diagnostic>,
    ) {
        let frames = &at.state.frames;
        let own = Roughed {
            block: call.block.span,
            code,
            corners: [call.contour.start, call.contour.first, call.contour.last()],
            allowance,
            zero: (frames.shift, frames.local, frames.active),
            tool: at.state.tool,
        };
        let before = self.roughed.insert(self.named, own);
        // A block that runs again is for the next part.
        if before
            .is_some_and(|before| before.block != own.block && Roughed { block: own.block, ..before } == own)
        {
            let (first, last) = self.named;
            let message = said::ContourRoughedTwice { code, first, last };
            reports.push(Diagnostic::new(message, call.block.words_span()));
        }
    }

    /// Handles an M code: the next part is not roughed yet.
    pub fn m_code(&mut self, number: u64) {
        if PART_CHANGES.contains(&number) {
            self.roughed.clear();
        }
    }

    /// Shifts the stored spans after an edit.
    pub fn shift(&mut self, shift: &Shift) {
        for roughed in self.roughed.values_mut() {
            roughed.block = shift.span(roughed.block);
        }
    }

    /// Handles F, S or T in a contour that is roughed.
    pub fn ignored(&mut self, address: u8, words: &Words, at: &EventContext) {
        if self.for_finishing.len() < at.setup.limits.messages {
            let word = words.quote(at.text, address);
            let diagnostic = Diagnostic::new(said::FeedOnlyForFinishing { word }, words.span(address));
            self.for_finishing.push((self.named, diagnostic));
        }
    }

    /// Reports, at the end of the run, the words of a contour that neither roughing nor a G70 has used.
    pub fn run_ends(&mut self, reports: &mut Vec<Diagnostic>) {
        reports.extend(std::mem::take(&mut self.for_finishing).into_iter().map(|(_, diagnostic)| diagnostic));
    }

    /// Checks G70, which begins and ends with rapids: it needs the start point of the roughing cycle (seed
    /// 003, GSK980TDb p. 102).
    pub fn finishing(&self, call: &FinishingCall, reports: &mut Vec<Diagnostic>) {
        let Some((own, before)) = call.landmarks.split_last() else { return };
        if own.span != call.block.span {
            return;
        }
        let roughed = before.iter().rev().find(|other| other.roughed && other.named == own.named);
        let message: Message = match roughed {
            // A cycle that could not run was reported already.
            None if self.asked_to_rough.contains(&own.named) => return,
            None => said::FinishWithoutRoughing { first: own.named.0, last: own.named.1 }.into(),
            Some(other)
                if other.start.distance(own.start) > LENGTH_TOLERANCE && !clears(own.start, other, call) =>
            {
                said::FinishStart {
                    roughed_x: Diameter::from_radius(other.start.x).mm(),
                    roughed_z: other.start.z,
                }
                .into()
            }
            Some(_) => return,
        };
        reports.push(Diagnostic::new(message, call.block.words_span()));
    }
}

/// Whether rapids between `start` and the contour stay outside: `start` is in front of the whole contour, on
/// the side from which it was roughed, and the tool moves away from the workpiece to get there.
fn clears(start: Point, roughed: &Landmarks, call: &FinishingCall) -> bool {
    let ends = || call.ends.iter();
    let front = if roughed.start.z >= roughed.last.z { 1.0 } else { -1.0 };
    let outside = if roughed.start.x >= roughed.first.x { 1.0 } else { -1.0 };
    let Some(last) = ends().next_back() else { return true };
    // The face is at Z0 if the roughing cycle began in front of it.
    let face = if front * roughed.start.z >= 0.0 { 0.0 } else { roughed.start.z };
    if front * (start.z - face) < -LENGTH_TOLERANCE {
        return false;
    }
    // Above all cuts of the contour the way back is free, even if a rapid at the end of the contour went
    // farther out.
    let above = |x: f64| ends().rev().skip(1).all(|end| outside * (x - end.x) > LENGTH_TOLERANCE);
    let way_back = outside * (start.x - last.x) >= -LENGTH_TOLERANCE
        || call.leaves_at_rapid && above(start.x) && above(last.x);
    ends().all(|end| front * (start.z - end.z) >= -LENGTH_TOLERANCE) && way_back
}

/// Checks G71 or G72 before its passes are made: allowances that point into the part.
pub fn roughing_called(call: &ContourCall<Roughing>, at: &EventContext, reports: &mut Vec<Diagnostic>) {
    for axis in roughing::allowance_into_material(call.contour, call.how) {
        let address = match axis {
            roughing::Axis::X => b'U',
            roughing::Axis::Z => b'W',
        };
        let mut diagnostic = allowance_sign(call.words, address, at);
        if axis == roughing::Axis::X && call.how.direction == Direction::Turning && starts_on_wrong_side(call)
        {
            diagnostic.fixes.clear();
        }
        reports.push(diagnostic);
    }
    let depth = call.how.depth;
    if depth >= MAX_INFEED - SAME {
        let message = said::InfeedTooDeep { depth, most: MAX_INFEED };
        reports.push(Diagnostic::new(message, call.block.words_span()));
    }
}

/// Whether the start point is on the wrong side of the contour: towards the chuck, a bore gets narrower and a
/// shaft thicker. Then the sign of the allowance is correct.
fn starts_on_wrong_side(call: &ContourCall<Roughing>) -> bool {
    let (start, first) = (call.contour.start, call.contour.first);
    let Some(deepest) = call.contour.pieces.iter().map(|piece| piece.to).min_by(|a, b| a.z.total_cmp(&b.z))
    else {
        return false;
    };
    let (side, way) = (start.x - first.x, deepest.x - first.x);
    deepest.z < first.z - SAME && way.abs() > SAME && side.abs() > SAME && side.signum() != way.signum()
}

/// Checks G71 or G72 after its passes were made: the first block of the contour, its start and its end.
pub fn roughing(call: &ContourCall<Roughing>, at: &EventContext, reports: &mut Vec<Diagnostic>) {
    // A contour with a pocket needs the word.
    if call.how.shape == roughing::Shape::Monotone {
        reports.extend(needless_axis(call, at));
    }
    let turning = call.how.direction == Direction::Turning;
    let both = call.first.x && call.first.z;
    let code = call.how.direction.code();
    for message in remarks(code, turning, call.contour, both, at.bar()) {
        let place =
            if message.is::<said::ContourNotClosed>() { call.last_span } else { Some(call.first_span) };
        reports.push(Diagnostic::new(message, place.unwrap_or_else(|| call.block.words_span())));
    }
}

/// A word in the first block of the contour whose axis does not move.
fn needless_axis(call: &ContourCall<Roughing>, at: &EventContext) -> Option<Diagnostic> {
    let (start, first) = (call.contour.start, call.contour.first);
    let (second_named, idiom, moves, other, word) = match call.how.direction {
        Direction::Turning => {
            (call.first.z, call.first.w_zero, (first.z - start.z).abs() > SAME, 'Z', call.first.z_word)
        }
        Direction::Facing => {
            (call.first.x, call.first.u_zero, (first.x - start.x).abs() > SAME, 'X', call.first.x_word)
        }
    };
    let code = call.how.direction.code();
    let message = || Diagnostic::new(said::ContourBothAxes { code, other }, word);
    (second_named && !idiom && !moves).then(|| message().with(Fix::delete(at.text, word)))
}

/// Checks G73.
pub fn pattern(call: &ContourCall<Pattern>, at: &EventContext, reports: &mut Vec<Diagnostic>) {
    for address in allowance_into_part(call.contour, call.how.allowance) {
        reports.push(allowance_sign(call.words, address, at));
    }
    let turned = |stock| turned_before(call.contour, stock, at.motions());
    let diagnostic = pattern_remarks(call.contour, call.how.relief.x, at.bar(), turned);
    reports.extend(diagnostic.map(|message| Diagnostic::new(message, call.block.words_span())));
}

/// Reports an allowance that points into the part.
fn allowance_sign(words: &Words, address: u8, at: &EventContext) -> Diagnostic {
    let word = words.quote(at.text, address);
    let fix = Fix::write(words.span(address), with_other_sign(&word));
    Diagnostic::new(said::AllowanceSign { word }, words.span(address)).with(fix)
}

/// Checks the contour of G71 (`turning`) or G72. `both`: its first block names both axes.
fn remarks(
    code: &'static str,
    turning: bool,
    contour: &Contour,
    both: bool,
    stock: Option<Stock>,
) -> Vec<Message> {
    let (start, first, last) = (contour.start, contour.first, contour.last());
    let mut found = Vec::new();
    let (axis, own, other) = if turning {
        ('Z', start.z, first.z)
    } else {
        ('X', Diameter::from_radius(start.x).mm(), Diameter::from_radius(first.x).mm())
    };
    if both && (own - other).abs() > LENGTH_TOLERANCE {
        found.push(said::ContourStartMoved { code, axis, start: own, first: other }.into());
    }
    if let Some(stock) = stock.filter(|_| turning) {
        let outside = first.x < start.x;
        let end = Diameter::from_radius(last.x).mm();
        if outside
            && start.x >= stock.diameter.radius() - LENGTH_TOLERANCE
            && last.x < stock.diameter.radius() - LENGTH_TOLERANCE
        {
            found.push(said::ContourNotClosed { x: end, diameter: stock.diameter.mm() }.into());
        }
    }
    found
}

/// Addresses of the allowances of G73 (radius and length, mm) that point into the part.
fn allowance_into_part(contour: &Contour, allowance: Point) -> Vec<u8> {
    let way =
        |from: f64, to: f64| if (to - from).abs() <= LENGTH_TOLERANCE { 0.0 } else { (to - from).signum() };
    // Direction from the start point into the part: across to the start of the contour, along to its end.
    let inward = Point::new(way(contour.start.x, contour.first.x), way(contour.start.z, contour.last().z));
    let mut found = Vec::new();
    if allowance.x * inward.x > LENGTH_TOLERANCE {
        found.push(b'U');
    }
    if allowance.z * inward.z > LENGTH_TOLERANCE {
        found.push(b'W');
    }
    found
}

/// The radius of the bar all along a contour after previous cuts, mm; `None` without such cuts.
fn turned_before(contour: &Contour, stock: Stock, cuts: impl Iterator<Item = Motion>) -> Option<f64> {
    let along =
        |motion: &Motion| motion.kind.cuts() && (motion.to.x - motion.from.x).abs() <= LENGTH_TOLERANCE;
    let places = || contour.pieces.iter().flat_map(|piece| [piece.from.z, piece.to.z]);
    let front = places().fold(contour.first.z, f64::max).min(stock.face);
    let back = places().fold(contour.first.z, f64::min);
    let covers = |motion: &Motion| {
        let (one, other) = (motion.from.z, motion.to.z);
        one.max(other) >= front - LENGTH_TOLERANCE && one.min(other) <= back + LENGTH_TOLERANCE
    };
    // Boring does not change the outside.
    let start = contour.start.x.min(stock.diameter.radius());
    let outside = |motion: &Motion| motion.to.x > start / 2.0;
    cuts.filter(|cut| along(cut) && covers(cut) && outside(cut)).map(|cut| cut.to.x).reduce(f64::min)
}

/// Checks G73 in a bar. `relief` is the distance of the first pass from the contour, radius, mm; `turned`
/// returns the radius left by previous cuts, if any.
fn pattern_remarks(
    contour: &Contour,
    relief: f64,
    stock: Option<Stock>,
    turned: impl FnOnce(Stock) -> Option<f64>,
) -> Option<Message> {
    let stock = stock?;
    let radius = stock.diameter.radius();
    if contour.first.x >= contour.start.x {
        return None;
    }
    let low = contour.pieces.iter().map(|piece| piece.to.x).fold(contour.first.x, f64::min);
    let mut depth = radius - (low + relief);
    if depth > MAX_PATTERN_DEPTH {
        depth = turned(stock).map_or(radius, |turned| turned.min(radius)) - (low + relief);
    }
    if depth > MAX_PATTERN_DEPTH {
        return Some(said::PatternShallow { depth, relief }.into());
    }
    let cutting = contour.pieces.iter().filter(|piece| piece.from.z < stock.face || piece.to.z < stock.face);
    let (mut whole, mut air) = (0.0, 0.0);
    for piece in cutting {
        let length = piece.from.distance(piece.to);
        let middle = (piece.from.x + piece.to.x) / 2.0 + relief;
        whole += length;
        air += if middle >= radius { length } else { 0.0 };
    }
    let share = (100.0 * air / whole).round();
    // A relief no larger than the material to remove is intended.
    let needed = radius - low;
    (whole > 0.0 && share > 50.0 && relief > needed + LENGTH_TOLERANCE)
        .then_some(said::PatternAir { share }.into())
}
