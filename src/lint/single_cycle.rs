//! Lints for G90, G92 and G94: tapers, blocks without an axis, passes that cut nothing, start points too far
//! from the workpiece.

use super::once::Once;
use super::taper;
use crate::control::codes::MotionMode;
use crate::control::compensation::Axis;
use crate::control::events::{EventContext, SinglePass};
use crate::control::modal::Target;
use crate::control::words::{Words, after_letter, letters, plain, quote};
use crate::cycles::single::{self, Single, Work};
use crate::geometry::Point;
use crate::message::{Diagnostic, Fix, Message, said};
use crate::setup::Stock;
use crate::setup::dialect::{DecimalRule, FeedMode};
use crate::setup::stock::{ONE_PASS_FEED, deepest_cut};
use crate::source::Span;
use crate::source::shift::Shift;
use crate::text::block::{Block, Word};
use crate::units::Diameter;

/// Lengths that differ by at most this are equal, mm.
const LENGTH_TOLERANCE: f64 = 0.001;
/// A pass deeper than this is unusual on a small lathe, mm (radius).
const MAX_PASS_DEPTH: f64 = 3.0;
/// A start point farther from the workpiece than this wastes time in each pass, mm.
const MAX_START_DISTANCE: f64 = 10.0;

/// The deepest pass of a sequence of G90 or G94.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DeepestPass {
    /// Start point.
    start: Point,
    /// End of the cut.
    end: Point,
    /// Taper, mm.
    taper: f64,
}

impl DeepestPass {
    /// Whether everything that the pass removes was removed by `other` already.
    fn is_within(&self, other: &Self, cycle: Single) -> bool {
        // Along the cut, and into the workpiece.
        let axes = |point: Point| match cycle.work() {
            Work::Facing => (point.x, point.z),
            _ => (point.z, point.x),
        };
        let ways = |pass: &Self| {
            let ((along, into), (end_along, end_into)) = (axes(pass.start), axes(pass.end));
            (end_along - along, end_into - into)
        };
        let ((length, depth), (other_length, other_depth)) = (ways(self), ways(other));
        let (forward, inward) = (other_length.signum(), (2.0 * other_depth + other.taper).signum());
        let (length, other_length) = (length * forward, other_length * forward);
        let at_begin = |depth: f64, taper: f64| (depth + taper) * inward;
        let (begin, other_begin) = (at_begin(depth, self.taper), at_begin(other_depth, other.taper));
        let (end, other_end) = (depth * inward, other_depth * inward);
        let other_there = other_begin + (other_end - other_begin) * length / other_length;
        self.start.distance(other.start) <= LENGTH_TOLERANCE
            && length > 0.0
            && length <= other_length + LENGTH_TOLERANCE
            && begin.min(end) >= -LENGTH_TOLERANCE
            && begin <= other_begin + LENGTH_TOLERANCE
            && end <= other_there + LENGTH_TOLERANCE
    }
}

/// The state of the lints for single cycles.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SingleCycles {
    /// G90 without an axis, and no move since: the next code of group 01 may end it.
    g90_alone: Option<Span>,
    /// The last named axis.
    named: Option<Axis>,
    /// The deepest pass since the cycle is active.
    deepest: Option<DeepestPass>,
    /// The axis word of a pass that repeats the deepest one: a spring pass, unless a deeper one follows.
    repeated: Option<Span>,
    /// The last pass with a taper, which is checked unless a steeper one follows.
    last_taper: Option<TaperedPass>,
    reported: Reported,
}

/// A pass with a taper.
#[derive(Clone, Copy, Debug, PartialEq)]
struct TaperedPass {
    cycle: Single,
    start: Point,
    end: Point,
    taper: f64,
    /// R, or the block if the taper is modal.
    span: Span,
}

impl TaperedPass {
    /// Whether `next` continues the series in which R grows and the ends stay: then only its last R is that of the part.
    fn is_before(&self, next: &Self) -> bool {
        self.cycle == next.cycle
            && self.start.distance(next.start) <= LENGTH_TOLERANCE
            && self.end.distance(next.end) <= LENGTH_TOLERANCE
            && self.taper * next.taper > 0.0
            && next.taper.abs() > self.taper.abs() + LENGTH_TOLERANCE
    }
}

/// The remarks that were made.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Reported {
    /// I of G92 is an older spelling of R.
    old_taper_word: Once,
    /// G90 is meant as absolute.
    g90_as_absolute: Once,
    /// A pass is not deeper.
    pass_not_deeper: Once,
    /// A pass is far too deep.
    too_deep: Once,
    /// A taper is not extended to the start point.
    taper_not_extended: Once,
}

impl SingleCycles {
    /// Handles another code of group 01 that is not a cycle.
    pub fn ends(&mut self, at: &EventContext, reports: &mut Vec<Diagnostic>) {
        self.series_ends(at, reports);
        self.reported.taper_not_extended.reset();
        self.reported.pass_not_deeper.reset();
        self.reported.too_deep.reset();
        self.one_shot();
        self.g90_alone = None;
    }

    /// Handles the code of a cycle.
    pub fn begins(
        &mut self,
        cycle: Single,
        block: &Block,
        words: &Words,
        at: &EventContext,
        reports: &mut Vec<Diagnostic>,
    ) {
        match at.state.motion {
            MotionMode::Cycle(before) if before == cycle => {}
            MotionMode::Cycle(_) => {
                self.series_ends(at, reports);
                self.reported.taper_not_extended.reset();
                self.reported.pass_not_deeper.reset();
                self.reported.too_deep.reset();
            }
            _ => self.ends(at, reports),
        }
        // With F it is certainly a cycle: the ends of its passes follow.
        const NAMES: u32 = letters(b"XZUWFR");
        let alone = cycle == Single::Turning && !words.has_any(NAMES);
        self.g90_alone = alone.then(|| {
            let g90 = block.words.iter().find(|word| word.address == b'G' && plain(word) == Some(90.0));
            g90.map_or_else(|| block.words_span(), |word| word.span)
        });
    }

    /// Handles a one-shot code, which resets the cycle.
    pub fn one_shot(&mut self) {
        (self.deepest, self.named, self.repeated) = (None, None, None);
    }

    /// Reports a taper of G92 given by I instead of R.
    pub fn old_taper_word(&mut self, words: &Words, at: &EventContext) -> Option<Diagnostic> {
        self.reported.old_taper_word.mark_reported().then(|| {
            let (word, span) = (words.quote(at.text, b'I'), words.span(b'I'));
            let fix = Fix::write(span, format!("R{}", after_letter(&word)));
            Diagnostic::new(said::LetterIInG92, span).with(fix)
        })
    }

    /// The last named axis and its end point, once a pass was cut.
    pub fn end(&self, at: &EventContext) -> Option<(Axis, Target)> {
        let memory = &at.state.memory;
        let end = self.named.map(|axis| (axis, if axis == Axis::X { memory.x } else { memory.z }));
        end.filter(|_| memory.passes > 0)
    }

    /// Checks a call of a cycle: a G90 that was meant as absolute, and a taper not extended to the start
    /// point.
    pub fn called(&mut self, pass: &SinglePass, at: &EventContext, reports: &mut Vec<Diagnostic>) {
        let is_axis = |word: &&Word| matches!(word.address, b'X' | b'U' | b'Z' | b'W');
        let named = pass.block.words.iter().rfind(is_axis);
        self.named = named.map(|word| if matches!(word.address, b'X' | b'U') { Axis::X } else { Axis::Z });
        if let Some(span) = self.g90_alone.take()
            && self.reported.g90_as_absolute.mark_reported()
        {
            reports.push(Diagnostic::new(said::G90AsAbsolute, span));
        }
        let &SinglePass { cycle, start, end, .. } = pass;
        let own = TaperedPass { cycle, start, end, taper: at.state.memory.taper, span: pass.taper_span };
        if self.last_taper.is_some_and(|last| last.is_before(&own)) {
            self.last_taper = None;
        }
        self.series_ends(at, reports);
        let way = if cycle.work() == Work::Facing { end.z - start.z } else { end.x - start.x };
        // A cut that begins beyond the start point is reported elsewhere.
        self.last_taper =
            Some(own).filter(|own| own.taper != 0.0 && !single::begins_beyond_start(way, own.taper));
    }

    /// Reports the last taper if it is not extended to the start point.
    pub fn series_ends(&mut self, at: &EventContext, reports: &mut Vec<Diagnostic>) {
        let Some(TaperedPass { cycle, start, end, taper, span }) = self.last_taper.take() else { return };
        if let Some(diagnostic) = taper::not_extended(cycle, start, end, taper, span, at)
            && self.reported.taper_not_extended.mark_reported()
        {
            reports.push(diagnostic);
        }
    }

    /// Checks a pass before it is cut.
    pub fn pass(&mut self, pass: &SinglePass, at: &EventContext, reports: &mut Vec<Diagnostic>) {
        let &SinglePass { block, words, cycle, start, end, .. } = pass;
        let taper = at.state.memory.taper;
        let own = DeepestPass { start, end, taper };
        let before = self.deepest.filter(|_| at.state.memory.passes > 0);
        if let Some(address) = pass.taper_word {
            reports.extend(taper::shape(cycle, start, end, taper, words, address, at));
        }
        let surface = before
            .map(|before| before.end.x + before.taper)
            .or(at.bar().map(|bar| start.x.min(bar.diameter.radius())));
        let face = at.bar().map(|bar| bar.face);
        if let Some(depth) = edge_depth(cycle, &own, surface, face, before.is_none()) {
            let depth = (10.0 * depth).round() / 10.0;
            reports.push(Diagnostic::new(said::TaperEdge { depth }, block.words_span()));
        }
        let moved = match cycle.work() {
            Work::Facing => [b'Z', b'W'],
            Work::Turning | Work::Threading => [b'X', b'U'],
        };
        let own_word = moved.into_iter().find(|&address| words.peek(address).is_some());
        let place = b"XUZW".iter().find_map(|&address| words.peek(own_word.unwrap_or(address)));
        let repeats = self.repeats(&own, before.as_ref(), cycle, place.map(|word| word.span));
        if let Some(span) = repeats.filter(|_| self.reported.pass_not_deeper.mark_reported()) {
            let message = said::PassRemovesNothing { word: quote(at.text, span) };
            reports.push(Diagnostic::new(message, span));
        } else if let (Some(before), Some(address)) = (before, own_word)
            && !is_one_pass_feed(at)
            && let Some(message) = too_deep(cycle, &own, &before, at.stock().as_ref())
        {
            // The passes after it are compared with those before it.
            if self.reported.too_deep.mark_reported() {
                reports.push(Diagnostic::new(message, words.span(address)));
            }
            return;
        }
        if let (Some(before), Some(address)) = (before, own_word) {
            if let Some(message) = pass_not_deeper(cycle, &own, &before)
                && self.reported.pass_not_deeper.mark_reported()
            {
                let message = message(words.quote(at.text, address));
                reports.push(Diagnostic::new(message, words.span(address)));
            }
        } else if before.is_none()
            && let Some(message) = at.bar().as_ref().and_then(|bar| far_start(cycle, &own, bar))
        {
            reports.push(Diagnostic::new(message, block.words_span()));
        }
        if cycle.work() != Work::Threading {
            self.deepest = Some(deeper(cycle, own, before));
        }
    }

    /// The axis word of a pass that removes nothing: either this pass, whose word is at `span`, or the one
    /// before it, which turns out not to be a spring pass.
    fn repeats(
        &mut self,
        own: &DeepestPass,
        before: Option<&DeepestPass>,
        cycle: Single,
        span: Option<Span>,
    ) -> Option<Span> {
        let repeated = self.repeated.take();
        let before = before.filter(|_| cycle.work() != Work::Threading)?;
        let (is_within, contains) = (own.is_within(before, cycle), before.is_within(own, cycle));
        self.repeated = span.filter(|_| is_within && contains);
        match (is_within, contains) {
            (false, true) => repeated,
            (true, false) if pass_not_deeper(cycle, own, before).is_none() => span,
            _ => None,
        }
    }

    /// Takes over the remarks that `other` has made.
    pub fn inherit_reported(&mut self, other: &Self) {
        self.reported = other.reported;
    }

    /// First bytes of the words that may be reported later.
    pub fn waiting(&self) -> [Option<u32>; 3] {
        [self.g90_alone, self.repeated, self.last_taper.map(|last| last.span)].map(|span| Some(span?.start))
    }

    /// Shifts the stored spans after an edit.
    pub fn shift(&mut self, shift: &Shift) {
        self.g90_alone = self.g90_alone.map(|span| shift.span(span));
        self.repeated = self.repeated.map(|span| shift.span(span));
        self.last_taper = self.last_taper.map(|last| TaperedPass { span: shift.span(last.span), ..last });
    }
}

/// Reports a block of a cycle with the word at `span`, but without an axis, which makes no pass. `end` is the
/// last named axis with its end point.
pub fn axis_missing(at: &EventContext, span: Span, cycle: Single, end: (Axis, Target)) -> Option<Diagnostic> {
    let (axis, target) = end;
    let letters = if axis == Axis::X { ['X', 'U'] } else { ['Z', 'W'] };
    let (letter, value) = match target {
        Target::Stay => return None,
        Target::Absolute(place) => (letters[0], place),
        Target::Incremental(way) => (letters[usize::from(!at.state.incremental)], way),
    };
    let written = if axis == Axis::X { Diameter::from_radius(value).mm() } else { value };
    let number = crate::units::number(written / at.state.unit.millimetres());
    let needs_point = at.dialect.decimal == DecimalRule::LeastIncrement && !number.contains('.');
    let end = format!("{letter}{number}{}", if needs_point { "." } else { "" });
    let word = quote(at.text, span);
    let fix = Fix::insert(span.start, format!("{end} "));
    let meant = format!("{end} {word}");
    let message = said::CycleAxisMissing { word, code: cycle.cycle().code(), meant };
    Some(Diagnostic::new(message, span).with(fix))
}

/// The remark about a pass that is not deeper than a previous one with the same start and end.
fn pass_not_deeper(
    cycle: Single,
    own: &DeepestPass,
    before: &DeepestPass,
) -> Option<impl FnOnce(String) -> Message> {
    let same = own.start.distance(before.start) <= LENGTH_TOLERANCE
        && (own.taper - before.taper).abs() <= LENGTH_TOLERANCE;
    let (deep, other, deepest) = match cycle.work() {
        Work::Turning => {
            let deep = own.end.x - before.end.x;
            (deep, (own.end.z - before.end.z).abs(), Diameter::from_radius(before.end.x).mm())
        }
        Work::Facing => (own.end.z - before.end.z, (own.end.x - before.end.x).abs(), before.end.z),
        Work::Threading => return None,
    };
    let axis = if cycle.work() == Work::Facing { 'Z' } else { 'X' };
    // The direction of the infeed, if both ends of the cut are on the same side of the start.
    let side = |pass: &DeepestPass| {
        let infeed = match cycle.work() {
            Work::Facing => pass.end.z - pass.start.z,
            _ => pass.end.x - pass.start.x,
        };
        let ends = [infeed, infeed + pass.taper];
        let is_beyond = |sign: f64| ends.iter().all(|end| sign * end >= -LENGTH_TOLERANCE);
        [-1.0, 1.0].into_iter().find(|&sign| is_beyond(sign))
    };
    let message = move |word| said::PassNotDeeper { word, axis, deepest }.into();
    let side = side(own).filter(|_| side(own) == side(before))?;
    (same && other <= LENGTH_TOLERANCE && side * deep < -LENGTH_TOLERANCE).then_some(message)
}

/// Depth of the first pass of an outside taper at its thin end, where it enters the blank, if it is far deeper
/// than a usual pass (radius, mm).
fn edge_depth(
    cycle: Single,
    own: &DeepestPass,
    surface: Option<f64>,
    face: Option<f64>,
    first: bool,
) -> Option<f64> {
    let outside = cycle.work() == Work::Turning
        && own.taper < -LENGTH_TOLERANCE
        && own.end.x <= own.start.x + LENGTH_TOLERANCE;
    // The cut begins in front of the face.
    let share = face
        .filter(|face| (own.end.z..own.start.z).contains(face))
        .map_or(1.0, |face| (face - own.end.z) / (own.start.z - own.end.z));
    let depth = surface? - (own.end.x + share * own.taper);
    // A thick bar bears a deeper cut.
    let deepest = MAX_PASS_DEPTH.max(0.14 * surface?);
    (first && outside && depth > deepest).then_some(depth)
}

/// Whether the feed is usual for small parts that are turned to size in one pass.
fn is_one_pass_feed(at: &EventContext) -> bool {
    let millimetres = at.state.feed.map(|feed| feed * at.state.unit.millimetres());
    at.state.feed_mode == FeedMode::PerTurn && millimetres.is_some_and(|feed| feed < ONE_PASS_FEED)
}

/// Reports a pass that removes far more below the previous one than an insert bears.
fn too_deep(
    cycle: Single,
    own: &DeepestPass,
    before: &DeepestPass,
    stock: Option<&Stock>,
) -> Option<Message> {
    let way = match cycle.work() {
        Work::Turning => before.end.x - own.end.x,
        Work::Facing => before.end.z - own.end.z,
        Work::Threading => return None,
    };
    let inward = match cycle.work() {
        Work::Facing => own.start.z - own.end.z,
        _ => own.start.x - own.end.x,
    };
    let depth = way * inward.signum();
    let radius = stock.map_or(own.start.x.max(own.end.x), |stock| stock.diameter.radius());
    let most = deepest_cut(radius);
    let tenth = |length: f64| (10.0 * length).round() / 10.0;
    (depth > most).then_some(said::CutTooDeep { depth: tenth(depth), most: tenth(most) }.into())
}

/// The deeper of two passes.
fn deeper(cycle: Single, own: DeepestPass, before: Option<DeepestPass>) -> DeepestPass {
    before.filter(|before| own.is_within(before, cycle)).unwrap_or(own)
}

/// Reports a cycle whose start is too far from the blank.
fn far_start(cycle: Single, own: &DeepestPass, stock: &Stock) -> Option<Message> {
    let radius = stock.diameter.radius();
    let outside = own.end.x < own.start.x;
    let far_x = own.start.x - radius.max(own.end.x);
    // The end of a taper may be at the surface of the blank, or in front of it.
    let (x, z) = match cycle.work() {
        Work::Facing => (own.end.x, own.end.z + own.taper.min(0.0)),
        Work::Turning | Work::Threading => (own.end.x + own.taper.min(0.0), own.end.z),
    };
    if outside && far_x > MAX_START_DISTANCE && x < radius {
        return Some(said::AirCut { axis: 'X', distance: far_x }.into());
    }
    let far_z = own.start.z - stock.face.max(own.end.z);
    if cycle.work() != Work::Threading && far_z > MAX_START_DISTANCE && z < stock.face {
        return Some(said::AirCut { axis: 'Z', distance: far_z }.into());
    }
    None
}
