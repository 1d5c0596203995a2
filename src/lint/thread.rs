//! Threads: what an instructor would remark of a pass, of a tap, and of the amounts of G76.

use super::once::Once;
use super::taper;
use crate::control::events::{Moment, ThreadPass, ThreadedBy, ThreadingCall};
use crate::control::words::{self, Words, plain, quote};
use crate::cycles::single::Single;
use crate::cycles::threading::MultiThread;
use crate::geometry::{Point, SAME};
use crate::message::{Diagnostic, Edit, Fix, Message, Repair, Severity, said};
use crate::motion::SpindleTurn;
use crate::order;
use crate::source::Span;
use crate::text::block::{Block, Word};
use crate::units::Diameter;

/// n ≤ 1200 / P − K (seed 001).
const SPEED_OF_PITCH: f64 = 1200.0;
/// K of that rule.
const SPEED_MARGIN: f64 = 80.0;
/// Pitches for which the rule was made, mm.
const PITCHES: std::ops::RangeInclusive<f64> = 0.2..=10.0;
/// Leads that controls take as F, mm (seed 001).
const LEADS: std::ops::RangeInclusive<f64> = 0.001..=500.0;
/// The same as I: 25400 to 0.06 threads per inch.
const LEADS_OF_INCH: std::ops::RangeInclusive<f64> = 25.4 / 25400.0..=25.4 / 0.06;
/// The finest pitch of a standard thread, mm (ISO 261: M1 fine).
const FINEST: f64 = 0.2;
/// Lengths this near are the same, mm.
const NEAR: f64 = 0.001;
/// Few slides are faster than this, mm/min.
const FAST_SLIDE: f64 = 4000.0;
/// Most starts of a thread that are looked for.
const STARTS: u32 = 8;

/// The last pass of a thread.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Pass {
    /// Where the thread began.
    start: Point,
    /// Where it ended.
    end: Point,
    /// Its lead, mm.
    lead: f64,
    /// Spindle speed, rpm.
    speed: f64,
    /// Station and offset of its tool.
    tool: (u16, u16),
    /// The number of its Q, where that is an angle.
    angle: Option<f64>,
}

/// The passes of a thread that are compared with the next one.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Passes {
    /// X of its first pass, as a radius.
    first: f64,
    /// The newest first: of more starts than these there is seldom a thread.
    recent: [Option<Pass>; 4],
    /// 1 where a deeper pass has a larger X, -1 where it has a smaller one, 0 where that is not known yet.
    outwards: f64,
    /// A pass was as deep as one before it.
    repeats: bool,
}

/// What is remembered of threads.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Threads {
    passes: Passes,
    /// A tap stands in its hole: the direction in which the spindle turned it in.
    tap: Option<SpindleTurn>,
    /// That the spindle turns at a constant surface speed.
    surface_speed: Once,
}

impl Threads {
    /// A thread begins: it needs a spindle that turns at a constant speed. `to`: its
    /// end, where the path is known.
    pub fn begins(
        &mut self,
        block: &Block,
        code: &'static str,
        to: Option<Point>,
        at: &Moment,
        reports: &mut Vec<Diagnostic>,
    ) {
        if !at.state.spindle.surface {
            return;
        }
        if to.is_some_and(|to| is_on_axis(at.state.position, to)) {
            // Reported of the tap.
            self.surface_speed.leave_out();
        }
        if self.surface_speed.first() {
            let diagnostic = Diagnostic::new(said::ThreadAtSurfaceSpeed { code }, block.words_span());
            // The speed that G96 has here, to the next ten below.
            let speed = at.spindle_speed(at.state.position.x).filter(|&speed| speed >= 10.0);
            let block_before = |speed: f64| format!("G97 S{}\n", 10.0 * (speed / 10.0).floor());
            let fix = speed.map(|speed| Fix::insert(block.span.start, block_before(speed)));
            reports.push(Diagnostic { fixes: fix.into_iter().collect(), ..diagnostic });
        }
    }

    /// A hole is tapped on the axis by a cycle.
    pub fn tap_on_axis(&mut self, block: &Block, at: &Moment, reports: &mut Vec<Diagnostic>) {
        if at.state.spindle.surface && self.surface_speed.first() {
            reports.push(Diagnostic::new(said::TapSurface, block.words_span()));
        }
    }

    /// G32 to G34 cut to a place. `pass`: the same as a pass of a thread, whose spindle goes on turning.
    pub fn cuts(&mut self, pass: &ThreadPass, code: &str, at: &Moment, reports: &mut Vec<Diagnostic>) {
        self.tap_moves(pass.block, pass.start, pass.end, at, reports);
        if code != "G33" && !is_on_axis(pass.start, pass.end) {
            self.pass(pass, at, reports);
        } else if pass.lead > *LEADS.end() {
            // The moves of an expanded hole cycle have the lead that its feed makes, however small.
            reports.extend(unusual_lead(at.text, pass.words, pass.lead, 1));
        }
    }

    /// A tap on the axis goes in by G32 and must be turned out again by a G32 with the spindle reversed.
    fn tap_moves(
        &mut self,
        block: &Block,
        from: Point,
        to: Point,
        at: &Moment,
        reports: &mut Vec<Diagnostic>,
    ) {
        if !is_on_axis(from, to) {
            return;
        }
        let turn = at.state.spindle.turn;
        if to.z < from.z {
            self.tap = Some(turn);
            if at.state.spindle.surface {
                reports.push(Diagnostic::new(said::TapSurface, block.words_span()));
            }
        } else if self.tap.take() == Some(turn) && turn != SpindleTurn::Stopped {
            reports.push(Diagnostic::new(said::TapReverse, block.words_span()));
        }
    }

    /// A move other than a thread: a tap must not leave its hole by it.
    #[inline]
    pub fn moves(&mut self, block: &Block, to: Point, at: &Moment, reports: &mut Vec<Diagnostic>) {
        if self.tap.is_some() && to.z > at.state.position.z {
            self.tap = None;
            reports.push(Diagnostic::new(said::TapReverse, block.words_span()));
        }
    }

    /// A pass, against the one before.
    pub fn pass(&mut self, pass: &ThreadPass, at: &Moment, reports: &mut Vec<Diagnostic>) {
        let unusual = unusual_lead(at.text, pass.words, pass.lead, pass.starts);
        let spindle = &at.state.spindle;
        let speed = if spindle.surface { 0.0 } else { spindle.rpm };
        let &ThreadPass { start, end, lead, by, .. } = pass;
        let angle_word = pass.words.get(b'Q').filter(|_| by != ThreadedBy::Passes);
        let angle = angle_word.and_then(plain);
        let own = Pass { start, end, lead, speed, tool: at.state.tool, angle };
        if let Some((word, angle)) = angle_word.zip(angle) {
            reports.extend(small_angle(at.text, word.span, angle));
        }
        let face = at.setup.stock.map(|stock| stock.face);
        let span = pass.block.words_span();
        let mut passes = self.passes;
        let before = passes.recent[0].filter(|before| is_near(&own, before));
        if before.is_none() {
            passes = Passes { first: end.x, ..Passes::default() };
        }
        if let ThreadedBy::Pass { outwards } = by {
            passes.outwards = if outwards { 1.0 } else { -1.0 };
        }
        if let Some(before) = before.filter(|before| (before.lead - lead).abs() > NEAR) {
            // It is reported where it is given; the thread goes on with the lead it had.
            if let Some(word) = lead_word(pass.words) {
                let message = said::ThreadLeadChanged { before: before.lead, now: lead };
                reports.push(unusual.unwrap_or_else(|| Diagnostic::new(message, word.span)));
            }
            return;
        }
        if let Some(unusual) = unusual {
            reports.push(unusual);
        } else {
            let begun = passes.recent.iter().flatten().any(|before| is_same_start(&own, before));
            let deeper = before.filter(|_| !begun).map_or(0.0, |before| passes.deeper(&own, &before));
            let has_angle = pass.words.get(b'Q').is_some();
            let starts = pass.starts as f64;
            reports.append(&mut remarks(&own, before.as_ref(), deeper, has_angle, starts, face, span));
        }
        if by != ThreadedBy::Passes {
            reports.extend(passes.not_deeper(&own, pass, at));
        }
        passes.recent.rotate_right(1);
        passes.recent[0] = Some(own);
        self.passes = passes;
    }

    /// Another tool comes: the next pass is the first of its thread.
    pub fn tool_changes(&mut self) {
        self.passes = Passes::default();
    }

    /// What `other` has reported counts as reported.
    pub fn has_heard_of(&mut self, other: &Self) {
        self.surface_speed = other.surface_speed;
    }
}

fn is_on_axis(from: Point, to: Point) -> bool {
    from.x.abs() <= SAME && to.x.abs() <= SAME
}

impl Passes {
    /// How much deeper a pass is than another, mm; 0 where the side is not known.
    fn deeper(&self, own: &Pass, before: &Pass) -> f64 {
        self.outwards * (own.end.x - before.end.x)
    }

    /// A pass that is not deeper than the one before it from the same start.
    fn not_deeper(&mut self, own: &Pass, pass: &ThreadPass, at: &Moment) -> Option<Diagnostic> {
        let mut of_thread = self.recent.iter().flatten();
        let before = of_thread.find(|before| before.angle == own.angle && is_same_start(own, before))?;
        if self.outwards == 0.0 {
            // Of moves the first two passes show it.
            let way = own.end.x - before.end.x;
            if way.abs() > NEAR {
                self.outwards = way.signum();
            }
            return None;
        }
        let deeper = self.deeper(own, before);
        let before = Diameter::from_radius(before.end.x).mm();
        let letter = *b"XU".iter().find(|&&letter| pass.words.get(letter).is_some()).unwrap_or(&b'Z');
        let span = pass.words.get(letter).map_or_else(|| pass.block.words_span(), |word| word.span);
        // From its first pass a thread begins anew: the same once more, for another part.
        if deeper < -NEAR && (own.end.x - self.first).abs() > NEAR {
            let word = quote(at.text, span);
            return Some(Diagnostic::new(said::ThreadPassNotDeeper { word, before }, span));
        }
        let is_first = deeper.abs() <= NEAR && !std::mem::replace(&mut self.repeats, true);
        is_first.then(|| Diagnostic::new(said::ThreadPassRepeats { before }, span).graded(Severity::Info))
    }
}

/// The word that gives the lead: in millimetres, or as threads per inch.
fn lead_word<'a>(words: &Words<'a>) -> Option<&'a Word> {
    words.get(b'F').or_else(|| words.get(b'I'))
}

/// A lead that no control takes, or no standard has, at the word that gives it.
fn unusual_lead(text: &[u8], words: &Words, lead: f64, starts: u64) -> Option<Diagnostic> {
    let word = lead_word(words)?;
    let leads = if word.address == b'F' { LEADS } else { LEADS_OF_INCH };
    let quoted = || quote(text, word.span);
    if !leads.contains(&lead) {
        return Some(Diagnostic::new(said::LeadOutOfRange { word: quoted() }, word.span));
    }
    let is_fine = lead < starts as f64 * FINEST - NEAR;
    is_fine.then(|| Diagnostic::new(said::ThreadVeryFine { word: quoted() }, word.span))
}

/// Degrees where thousandths of a degree are counted.
fn small_angle(text: &[u8], span: Span, angle: f64) -> Option<Diagnostic> {
    let word = quote(text, span);
    if angle <= 0.0 || angle >= 1000.0 || word.contains('.') {
        return None;
    }
    let fix = Fix::write(span, format!("Q{}", angle as u32 * 1000));
    Some(Diagnostic::new(said::ThreadAngleSmall { word, degrees: angle / 1000.0 }, span).with(fix))
}

/// Whether two passes may be of one thread, whatever their leads: one tool, one end, nearly one diameter.
fn is_near(own: &Pass, before: &Pass) -> bool {
    own.tool == before.tool
        && (own.end.z - before.end.z).abs() <= NEAR
        && own.end.z < own.start.z
        && (own.end.x - before.end.x).abs() <= 2.0 * own.lead.max(before.lead)
}

/// Remarks about a G76 that has its passes.
pub fn multi_threading(call: &ThreadingCall, at: &Moment, reports: &mut Vec<Diagnostic>) {
    let &ThreadingCall { block, words, start, how, lead, angle, one_block } = call;
    if let Some(unusual) = unusual_lead(at.text, words, lead, 1) {
        // What else is compared with the lead would say the same.
        reports.push(unusual);
        return;
    }
    reports.extend(start_clears_crest(block, start, how));
    if let Some(message) = amounts(how.height, how.first_depth, lead, angle) {
        let address = if message.is::<said::ThreadFirstDepth>() { b'Q' } else { b'P' };
        let span = if one_block { block.words_span() } else { words.span(address) };
        let fixes = swapped_amounts(at.text, words, &message);
        reports.push(Diagnostic { fixes, ..Diagnostic::new(message, span) });
    }
    let way = (start.x - how.end.x).abs();
    if let Some(out) = how.pull_out.filter(|pull_out| pull_out.out >= way - NEAR) {
        let message = said::ThreadPullOut { pull_out: out.out, way };
        reports.push(Diagnostic::new(message, block.words_span()));
    }
    let taper_word = if one_block { b'I' } else { b'R' };
    if words.get(taper_word).is_some() {
        reports.extend(taper::shape(Single::Threading, start, how.end, how.taper, words, taper_word, at));
    }
}

/// P and Q of G76 with their letters exchanged, where that is what the message is about.
fn swapped_amounts(text: &[u8], words: &Words, message: &Message) -> Vec<Fix> {
    let (Some(p), Some(q), true) = (words.get(b'P'), words.get(b'Q'), message.is::<said::ThreadFirstDepth>())
    else {
        return Vec::new();
    };
    let (p_text, q_text) = (quote(text, p.span), quote(text, q.span));
    let mut edits = [
        (p.span, format!("Q{}", words::behind_letter(&p_text))),
        (q.span, format!("P{}", words::behind_letter(&q_text))),
    ];
    order::by_key(&mut edits, |edit| edit.0.start);
    let title =
        Repair::Write { text: edits.iter().map(|edit| edit.1.as_str()).collect::<Vec<_>>().join(" ") };
    let edits = edits.map(|(span, text)| Edit { span, text });
    vec![Fix { title, safe: false, edits: edits.into() }]
}

/// The tool returns to the start X after each pass: it must clear the crest.
fn start_clears_crest(block: &Block, start: Point, how: &MultiThread) -> Option<Diagnostic> {
    let external = how.end.x < start.x;
    let crest = if external { how.end.x + how.height } else { how.end.x - how.height };
    let inside = if external { start.x <= crest + NEAR } else { start.x >= crest - NEAR };
    if !inside {
        return None;
    }
    // Exactly at the crest that P gives: the work may have been turned a little smaller.
    let at_crest = (start.x - crest).abs() <= NEAR;
    let [start, crest] = [start.x, crest].map(|radius| Diameter::from_radius(radius).mm());
    let message: Message = match at_crest {
        true => said::ThreadStartAtCrest { start }.into(),
        false => said::ThreadStartInside { start, crest }.into(),
    };
    let diagnostic = Diagnostic::new(message, block.words_span());
    Some(if at_crest { diagnostic.graded(Severity::Info) } else { diagnostic })
}

/// Remarks about a pass: its speed, and whether it meets the pass before it. `deepens`: how much deeper it is, mm, from a new
/// start; 0 where that is not known. `angle`: a word gives the angle at which it starts. `starts`: of how many starts the thread is. `face`: Z of the face of the blank, if one
/// is known. `span`: the block.
fn remarks(
    own: &Pass,
    before: Option<&Pass>,
    deepens: f64,
    angle: bool,
    starts: f64,
    face: Option<f64>,
    span: Span,
) -> Vec<Diagnostic> {
    let pitch = own.lead / starts;
    let mut diagnostics = Vec::new();
    let before = before.filter(|before| is_same_thread(own, before));
    if before.is_none() {
        let limit = SPEED_OF_PITCH / pitch - SPEED_MARGIN;
        if PITCHES.contains(&pitch) && own.speed > limit {
            let speed = own.speed;
            let message = said::ThreadTooFast { speed, pitch, limit: limit.floor() };
            let diagnostic = Diagnostic::new(message, span);
            // The rule of thumb is for small lathes.
            let is_fast = speed * own.lead > FAST_SLIDE;
            diagnostics.push(if is_fast { diagnostic.graded(Severity::Warning) } else { diagnostic });
        } else if let Some(run_in) = run_in(own, face) {
            diagnostics.push(Diagnostic::new(run_in, span));
        }
        return diagnostics;
    }
    let Some(before) = before else { return diagnostics };
    if (own.speed - before.speed).abs() > NEAR && own.speed > 0.0 && before.speed > 0.0 {
        let message = said::ThreadSpeedChanged { before: before.speed, now: own.speed };
        diagnostics.push(Diagnostic::new(message, span));
    }
    let moved = own.start.z - before.start.z;
    let deeper = (own.start.x - before.start.x).abs().max((own.end.x - before.end.x).abs());
    // Another start of the thread begins anew: it goes no deeper than the pass before.
    let is_start = is_whole_lead(moved, own.lead) || deepens <= NEAR && is_start_of_lead(moved, own.lead);
    if !angle && !is_start && !is_along_flank(moved, deeper) {
        let (before, now) = (before.start.z, own.start.z);
        diagnostics.push(Diagnostic::new(said::ThreadStartMoved { before, now, lead: own.lead }, span));
    }
    diagnostics
}

/// Whether a pass begins as far to the side as infeed along a flank leads it, which is
/// up to 30° off the square.
fn is_along_flank(moved: f64, deeper: f64) -> bool {
    const STEEPEST: f64 = std::f64::consts::FRAC_PI_6;
    moved.abs() <= deeper * STEEPEST.tan() + NEAR
}

/// Two passes with one tool, lead and end are one thread.
fn is_same_thread(own: &Pass, before: &Pass) -> bool {
    own.tool == before.tool
        && (own.lead - before.lead).abs() <= NEAR
        && (own.end.z - before.end.z).abs() <= NEAR
        && own.end.z < own.start.z
}

/// Whether a pass of the same thread began at the same start of it, be it some leads away.
fn is_same_start(own: &Pass, before: &Pass) -> bool {
    is_same_thread(own, before) && is_whole_lead(own.start.z - before.start.z, own.lead)
}

/// Whether a shift of the start is a whole number of leads.
fn is_whole_lead(moved: f64, lead: f64) -> bool {
    let turns = moved / lead;
    (turns - turns.round()).abs() * lead <= NEAR
}

/// Whether a shift of the start is a whole number of leads, or leads to another start of a thread of several.
fn is_start_of_lead(moved: f64, lead: f64) -> bool {
    (1..=STARTS).any(|starts| is_whole_lead(moved, lead / f64::from(starts)))
}

/// δ1 = 3.605 · n·L / 1800: what a slide needs to reach its speed.
fn run_in(own: &Pass, face: Option<f64>) -> Option<Message> {
    let face = face?;
    if own.start.z <= face || own.end.z >= face {
        return None;
    }
    let (have, need) = (own.start.z - face, 3.605 * own.speed * own.lead / 1800.0);
    (have < need).then_some(said::ThreadRunIn { have, need }.into())
}

/// What of the amounts of a G76 does not fit: the height of a 60° thread is 0.5 to 0.75 of its pitch, and
/// more than the first cut. Lengths in mm, the angle in degrees.
fn amounts(height: f64, first: f64, lead: f64, angle: f64) -> Option<Message> {
    if first > height + NEAR {
        return Some(said::ThreadFirstDepth { first, height }.into());
    }
    // A thread of two or three starts is lower, measured by its lead.
    let share = height / lead;
    let unusual = angle == 60.0 && !(0.2..=1.0).contains(&share);
    let usual = 0.001 * (650.0 * lead).round();
    unusual.then_some(said::ThreadHeight { height, pitch: lead, usual }.into())
}
