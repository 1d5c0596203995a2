//! Lints for threads: passes, taps, and the parameters of G76.

use super::once::Once;
use super::taper;
use crate::control::codes::M;
use crate::control::events::{EventContext, ThreadPass, ThreadSource, ThreadingCall};
use crate::control::words::{self, Words, plain, quote};
use crate::cycles::single::Single;
use crate::cycles::threading::{self, MultiThread};
use crate::geometry::{Point, SAME};
use crate::message::{Diagnostic, Edit, Fix, Message, Repair, Severity, said};
use crate::motion::SpindleTurn;
use crate::order;
use crate::source::Span;
use crate::text::block::{Block, Word};
use crate::units::Diameter;

/// n ≤ 1200 / P − K (seed 001).
const SPEED_OF_PITCH: f64 = 1200.0;
/// Pitches for which the rule was made, mm.
const PITCHES: std::ops::RangeInclusive<f64> = 0.2..=10.0;
/// Leads that controls accept as F, mm (seed 001).
const LEADS: std::ops::RangeInclusive<f64> = 0.001..=500.0;
/// The same as I: 25400 to 0.06 threads per inch.
const LEADS_OF_INCH: std::ops::RangeInclusive<f64> = 25.4 / 25400.0..=25.4 / 0.06;
/// The finest pitch of a standard thread, mm (ISO 261: M1 fine).
const MIN_PITCH: f64 = 0.2;
/// Greatest ratio of the depth step of a pass to the largest step before it. Usually the steps decrease,
/// because each pass cuts on wider flanks.
const MAX_STEP_RATIO: f64 = 2.0;
/// A depth step up to this is never too deep, mm (radius).
const DEEP_STEP: f64 = 0.3;
/// A depth step below this only scratches the workpiece to show the lead, mm (radius).
const SCRATCH: f64 = 0.05;
/// Passes widen their groove by up to this share of the lead: infeed along both flanks, and finishing of the
/// flanks.
const GROOVE_WIDENING: f64 = 0.2;
/// Share of the lead that a tap holder compensates between the way in and the way out.
const HOLDER_COMPENSATION: f64 = 0.05;
/// Lengths that differ by at most this are equal, mm.
const LENGTH_TOLERANCE: f64 = 0.001;
/// Few slides are faster than this while they cut a thread, mm/min.
const MAX_SLIDE_SPEED: f64 = 4000.0;
/// Most starts of a thread that are searched for.
const MAX_STARTS: u32 = 12;

/// The last pass of a thread.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Pass {
    /// Start of the thread.
    start: Point,
    /// End of the thread.
    end: Point,
    /// Lead, mm.
    lead: f64,
    /// Spindle speed, rpm.
    speed: f64,
    /// Station and offset of its tool.
    tool: (u16, u16),
    /// The number of its Q, if that is an angle.
    angle: Option<f64>,
    /// Whether it was as deep as the one before it from the same start.
    repeats: bool,
}

/// The passes of a thread that are compared with the next one.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Passes {
    /// Its first pass: X of the end, as a radius, and Z of the start.
    first: Point,
    /// The last passes, newest first: threads seldom have more starts.
    recent: [Option<Pass>; 4],
    /// 1 if a deeper pass has a larger X, −1 if it has a smaller one, 0 if unknown.
    outwards: f64,
    /// Remark: a pass was as deep as the one before it, and then a deeper one followed.
    repeated: Once,
    /// Greatest depth step from one pass to the next, mm; 0 before the second pass.
    step: f64,
}

/// A tap in its hole on the axis.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Tap {
    /// The direction in which the spindle turned it in.
    turn: SpindleTurn,
    /// The lead with which it went in, mm.
    lead: f64,
    /// Whether the spindle continues to turn it in.
    turns_on: bool,
}

/// The code of the tapping cycle of GSK controls.
const TAPPING_CYCLE: &str = "G33";

/// The state of the lints for threads.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Threads {
    passes: Passes,
    /// The tap that is in its hole.
    tap: Option<Tap>,
    /// Remark: the spindle turns at a constant surface speed.
    surface_speed: Once,
}

impl Threads {
    /// Checks the start of a thread, which needs a constant spindle speed. `to` is its end, if the path is
    /// known.
    pub fn begins(
        &mut self,
        block: &Block,
        code: &'static str,
        to: Option<Point>,
        at: &EventContext,
        reports: &mut Vec<Diagnostic>,
    ) {
        if !at.state.spindle.surface {
            return;
        }
        if to.is_some_and(|to| is_on_axis(at.state.position, to)) {
            // Reported for the tap.
            self.surface_speed.suppress();
        }
        if self.surface_speed.mark_reported() {
            let diagnostic = Diagnostic::new(said::ThreadAtSurfaceSpeed { code }, block.words_span());
            // The current speed under G96, rounded down to a multiple of ten.
            let speed = at.spindle_speed(at.state.position.x).filter(|&speed| speed >= 10.0);
            let block_before = |speed: f64| format!("G97 S{}\n", 10.0 * (speed / 10.0).floor());
            let fix = speed.map(|speed| Fix::insert(block.span.start, block_before(speed)));
            reports.push(Diagnostic { fixes: fix.into_iter().collect(), ..diagnostic });
        }
    }

    /// Checks a cycle that taps a hole on the axis.
    pub fn tap_on_axis(&mut self, block: &Block, at: &EventContext, reports: &mut Vec<Diagnostic>) {
        if at.state.spindle.surface && self.surface_speed.mark_reported() {
            tap_at_surface_speed(block, at, reports);
        }
    }

    /// Checks a cut of G32 to G34. `pass` is the same cut as a pass of a thread. The tapping cycle of GSK controls
    /// turns the tap out itself.
    pub fn cuts(&mut self, pass: &ThreadPass, code: &str, at: &EventContext, reports: &mut Vec<Diagnostic>) {
        let is_cycle = code == TAPPING_CYCLE;
        if !is_cycle {
            self.tap_moves(pass, at, reports);
        } else if is_on_axis(pass.start, pass.end) {
            tap_at_surface_speed(pass.block, at, reports);
        }
        if !is_cycle && !is_on_axis(pass.start, pass.end) {
            self.pass(pass, at, reports);
        } else if pass.lead > *LEADS.end() {
            // The moves of an expanded hole cycle have the lead that results from its feed, however small.
            reports.extend(unusual_lead(at.text, pass.words, pass.lead, 1));
        }
    }

    /// A tap on the axis goes in by G32 and must be turned out by a G32 of the same lead, with the spindle
    /// reversed (seed 002).
    fn tap_moves(&mut self, pass: &ThreadPass, at: &EventContext, reports: &mut Vec<Diagnostic>) {
        let &ThreadPass { block, words, start, end, lead, .. } = pass;
        if !is_on_axis(start, end) {
            return;
        }
        let turn = at.state.spindle.turn;
        if end.z < start.z {
            self.tap = Some(Tap { turn, lead, turns_on: turn != SpindleTurn::Stopped });
            return tap_at_surface_speed(block, at, reports);
        }
        let Some(tap) = self.tap.take() else { return };
        if tap.turn == turn && turn != SpindleTurn::Stopped {
            reports.push(Diagnostic::new(said::TapReverse, block.words_span()));
        } else if (tap.lead - lead).abs() > HOLDER_COMPENSATION * tap.lead + LENGTH_TOLERANCE {
            let span = lead_word(words).map_or_else(|| block.words_span(), |word| word.span);
            reports.push(Diagnostic::new(said::TapLeadChanged { into: tap.lead, out: lead }, span));
        }
    }

    /// Handles M05.
    pub fn spindle_stops(&mut self) {
        if let Some(tap) = &mut self.tap {
            tap.turns_on = false;
        }
    }

    /// Handles a known M code. Reports a spindle that is reversed without a stop at the bottom of a tapped
    /// hole.
    pub fn m_code(&mut self, code: M, word: &Word) -> Option<Diagnostic> {
        if matches!(code, M::Pause(_)) {
            // The operator may have measured: the next pass is not compared with the passes before.
            self.passes.step = 0.0;
        }
        let tap = self.tap.as_mut().filter(|tap| tap.turns_on && code == M::Spindle(tap.turn.reversed()))?;
        tap.turns_on = false;
        Some(Diagnostic::new(said::TapNotStopped, word.span))
    }

    /// Handles a move other than a thread: a tap must not leave its hole by it.
    #[inline]
    pub fn moves(&mut self, block: &Block, to: Point, at: &EventContext, reports: &mut Vec<Diagnostic>) {
        if self.tap.is_some() && to.z > at.state.position.z {
            self.tap = None;
            reports.push(Diagnostic::new(said::TapReverse, block.words_span()));
        }
    }

    /// Compares a pass with the one before.
    pub fn pass(&mut self, pass: &ThreadPass, at: &EventContext, reports: &mut Vec<Diagnostic>) {
        let unusual = unusual_lead(at.text, pass.words, pass.lead, pass.starts);
        let spindle = &at.state.spindle;
        let speed = if spindle.surface { 0.0 } else { spindle.rpm };
        let &ThreadPass { start, end, lead, by, .. } = pass;
        let angle_word = pass.words.peek(b'Q').filter(|_| by != ThreadSource::Passes);
        let angle = angle_word.and_then(plain);
        let mut own = Pass { start, end, lead, speed, tool: at.state.tool, angle, repeats: false };
        if let Some((word, angle)) = angle_word.zip(angle) {
            reports.extend(small_angle(at.text, word.span, angle));
        }
        let known = Known {
            face: at.stock().map(|stock| stock.face),
            margin: at.setup.machine.thread_speed_margin,
            rapid: at.setup.machine.rapid_z,
        };
        let span = pass.block.words_span();
        let mut passes = self.passes;
        let before = passes.recent[0].filter(|before| is_near(&own, before));
        if before.is_none() {
            passes = Passes { first: Point::new(end.x, start.z), ..Passes::default() };
        }
        if let ThreadSource::Pass { outwards } = by {
            passes.outwards = if outwards { 1.0 } else { -1.0 };
        }
        if let Some(before) = before.filter(|before| (before.lead - lead).abs() > LENGTH_TOLERANCE) {
            // A change of the lead is reported at its word; the thread continues with its previous lead.
            if let Some(word) = lead_word(pass.words) {
                let message = said::ThreadLeadChanged { before: before.lead, now: lead };
                reports.push(unusual.unwrap_or_else(|| Diagnostic::new(message, word.span)));
            }
            return;
        }
        if let Some(unusual) = unusual {
            reports.push(unusual);
        } else {
            let fits = pass.words.peek(b'Q').is_some() || passes.has_valid_start(&own);
            let starts = pass.starts as f64;
            reports.append(&mut remarks(&own, before.as_ref(), fits, starts, known, span));
        }
        if by != ThreadSource::Passes {
            reports.extend(passes.not_deeper(&mut own, pass, at));
        }
        passes.recent.rotate_right(1);
        passes.recent[0] = Some(own);
        self.passes = passes;
    }

    /// Handles a tool change: the next pass is the first of its thread.
    pub fn tool_changes(&mut self) {
        self.passes = Passes::default();
    }

    /// Takes over the remarks that `other` has made.
    pub fn inherit_reported(&mut self, other: &Self) {
        self.surface_speed = other.surface_speed;
    }
}

/// Reports a tap under constant surface speed: on the axis the spindle turns at its highest speed.
fn tap_at_surface_speed(block: &Block, at: &EventContext, reports: &mut Vec<Diagnostic>) {
    if at.state.spindle.surface {
        reports.push(Diagnostic::new(said::TapSurface, block.words_span()));
    }
}

fn is_on_axis(from: Point, to: Point) -> bool {
    from.x.abs() <= SAME && to.x.abs() <= SAME
}

impl Passes {
    /// Depth step between two passes, mm; 0 if the side is unknown.
    fn deeper(&self, own: &Pass, before: &Pass) -> f64 {
        self.outwards * (own.end.x - before.end.x)
    }

    /// Whether a pass without Q repeats the start at 0, as deep as `before`. This is a lost angle if all
    /// passes have a Q, or if the thread has other starts and the start at 0 was cut just before.
    fn angle_is_missing(&self, own: &Pass, before: &Pass) -> bool {
        let mut recent = self.recent.iter().flatten();
        let all_have_one = recent.clone().all(|pass| pass.angle.is_some());
        let has_starts = recent.any(|pass| pass.angle.is_some_and(|angle| angle != 0.0));
        let just_before = self.recent[0].as_ref() == Some(before);
        own.angle.is_none() && (all_have_one || has_starts && just_before)
    }

    /// Whether a pass begins in an existing groove, or at another start of the thread.
    fn has_valid_start(&self, own: &Pass) -> bool {
        let places = || self.recent.iter().flatten().map(|pass| pass.start.z).chain([self.first.z]);
        places().any(|place| is_in_groove(own.start.z - place, own.lead))
            || self.restarts_depths(own)
                && places().any(|place| is_start_of_lead(own.start.z - place, own.lead))
    }

    /// Whether the depths of a thread may start again with a pass: it is not deeper than the first one, or
    /// less deep than the one before it.
    fn restarts_depths(&self, own: &Pass) -> bool {
        let below_first = self.outwards * (own.end.x - self.first.x);
        below_first <= LENGTH_TOLERANCE
            || self.recent[0].is_some_and(|before| self.deeper(own, &before) < -LENGTH_TOLERANCE)
    }

    /// The last pass from the same start.
    fn of_same_start(&self, own: &Pass) -> Option<Pass> {
        let angle = |pass: &Pass| pass.angle.unwrap_or(0.0);
        let is_one = |before: &&Pass| angle(before) == angle(own) && is_same_start(own, before);
        self.recent.iter().flatten().find(is_one).copied()
    }

    /// Reports a pass that is not deeper than the one before it from the same start, that is much deeper, or
    /// that continues after a pass was repeated.
    fn not_deeper(&mut self, own: &mut Pass, pass: &ThreadPass, at: &EventContext) -> Option<Diagnostic> {
        let before = self.of_same_start(own)?;
        if self.outwards == 0.0 {
            // The first two passes show the side.
            let way = own.end.x - before.end.x;
            if way.abs() > LENGTH_TOLERANCE {
                self.outwards = way.signum();
            }
            return None;
        }
        let deeper = self.deeper(own, &before);
        if deeper.abs() <= LENGTH_TOLERANCE {
            if self.angle_is_missing(own, &before) {
                let word = quote(at.text, pass.block.words_span());
                return Some(Diagnostic::new(said::ThreadAngleMissing { word }, pass.block.words_span()));
            }
            // A spring pass, unless a deeper one follows.
            own.repeats = true;
            return None;
        }
        let repeats = before.repeats;
        let before = Diameter::from_radius(before.end.x).mm();
        let letter = *b"XU".iter().find(|&&letter| pass.words.peek(letter).is_some()).unwrap_or(&b'Z');
        let span = pass.words.peek(letter).map_or_else(|| pass.block.words_span(), |word| word.span);
        // A pass like the first one starts the thread again, for another part.
        if deeper < -LENGTH_TOLERANCE && (own.end.x - self.first.x).abs() > LENGTH_TOLERANCE {
            let word = quote(at.text, span);
            return Some(Diagnostic::new(said::ThreadPassNotDeeper { word, before }, span));
        }
        // The first passes may only scratch the workpiece; and a pass that is missing was reported when it
        // occurred.
        let step = self.step;
        if deeper > SCRATCH - LENGTH_TOLERANCE {
            self.step = deeper.max(step);
        }
        if step > 0.0 && deeper > MAX_STEP_RATIO * step && deeper > DEEP_STEP + LENGTH_TOLERANCE {
            let message = said::ThreadPassJumps { deeper, step };
            return Some(Diagnostic::new(message, span));
        }
        let is_told = deeper > LENGTH_TOLERANCE && repeats && self.repeated.mark_reported();
        is_told
            .then(|| Diagnostic::new(said::ThreadPassRepeats { before }, span).with_severity(Severity::Info))
    }
}

/// The word of the lead: in millimetres, or as threads per inch.
fn lead_word<'a>(words: &Words<'a>) -> Option<&'a Word> {
    [b'E', b'F', b'I'].into_iter().find_map(|letter| words.peek(letter))
}

/// Reports a lead that no control accepts, or no standard has, at its word.
fn unusual_lead(text: &[u8], words: &Words, lead: f64, starts: u64) -> Option<Diagnostic> {
    let word = lead_word(words)?;
    let leads = if word.address == b'I' { LEADS_OF_INCH } else { LEADS };
    let quoted = || quote(text, word.span);
    if !leads.contains(&lead) {
        return Some(Diagnostic::new(said::LeadOutOfRange { word: quoted() }, word.span));
    }
    let is_fine = lead < starts as f64 * MIN_PITCH - LENGTH_TOLERANCE;
    is_fine.then(|| Diagnostic::new(said::ThreadVeryFine { word: quoted() }, word.span))
}

/// Reports an angle in degrees instead of thousandths of a degree.
fn small_angle(text: &[u8], span: Span, angle: f64) -> Option<Diagnostic> {
    let word = quote(text, span);
    if angle <= 0.0 || angle >= 1000.0 || word.contains('.') {
        return None;
    }
    // A larger number is not an angle in degrees: it may be a depth of G76.
    let fix = (angle <= 360.0).then(|| Fix::write(span, format!("Q{}", angle as u32 * 1000)));
    let diagnostic = Diagnostic::new(said::ThreadAngleSmall { word, degrees: angle / 1000.0 }, span);
    Some(Diagnostic { fixes: fix.into_iter().collect(), ..diagnostic })
}

/// Whether two passes may belong to one thread, apart from their leads: one tool, one end, nearly one
/// diameter.
fn is_near(own: &Pass, before: &Pass) -> bool {
    own.tool == before.tool
        && (own.end.z - before.end.z).abs() <= LENGTH_TOLERANCE
        && own.end.z < own.start.z
        && (own.end.x - before.end.x).abs() <= 2.0 * own.lead.max(before.lead)
}

/// Checks G76 after its passes were made.
pub fn multi_threading(call: &ThreadingCall, at: &EventContext, reports: &mut Vec<Diagnostic>) {
    let &ThreadingCall { block, words, start, how, lead, angle, one_block } = call;
    if let Some(unusual) = unusual_lead(at.text, words, lead, 1) {
        // The other comparisons with the lead would report the same mistake.
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
    if let Some(out) = how.pull_out.filter(|pull_out| pull_out.out >= way - LENGTH_TOLERANCE) {
        let message = said::ThreadPullOut { pull_out: out.out, way };
        reports.push(Diagnostic::new(message, block.words_span()));
    }
    let taper_word = if one_block { b'I' } else { b'R' };
    if words.peek(taper_word).is_some() {
        reports.extend(taper::shape(Single::Threading, start, how.end, how.taper, words, taper_word, at));
    }
}

/// Fixes that exchange P and Q of G76, if the message is about that.
fn swapped_amounts(text: &[u8], words: &Words, message: &Message) -> Vec<Fix> {
    let (Some(p), Some(q), true) =
        (words.peek(b'P'), words.peek(b'Q'), message.is::<said::ThreadFirstDepth>())
    else {
        return Vec::new();
    };
    let (p_text, q_text) = (quote(text, p.span), quote(text, q.span));
    let mut edits = [
        (p.span, format!("Q{}", words::after_letter(&p_text))),
        (q.span, format!("P{}", words::after_letter(&q_text))),
    ];
    order::by_key(&mut edits, |edit| edit.0.start);
    let title =
        Repair::Write { text: edits.iter().map(|edit| edit.1.as_str()).collect::<Vec<_>>().join(" ") };
    let edits = edits.map(|(span, text)| Edit { span, text });
    vec![Fix { title, safe: false, edits: edits.into() }]
}

/// Reports a start X inside the crest: the tool returns to it after each pass.
fn start_clears_crest(block: &Block, start: Point, how: &MultiThread) -> Option<Diagnostic> {
    let external = how.end.x < start.x;
    let crest = if external { how.end.x + how.height } else { how.end.x - how.height };
    let inside =
        if external { start.x <= crest + LENGTH_TOLERANCE } else { start.x >= crest - LENGTH_TOLERANCE };
    if !inside {
        return None;
    }
    // Exactly at the crest that P gives: the workpiece may have been turned slightly smaller.
    let at_crest = (start.x - crest).abs() <= LENGTH_TOLERANCE;
    let [start, crest] = [start.x, crest].map(|radius| Diameter::from_radius(radius).mm());
    let message: Message = match at_crest {
        true => said::ThreadStartAtCrest { start }.into(),
        false => said::ThreadStartInside { start, crest }.into(),
    };
    let diagnostic = Diagnostic::new(message, block.words_span());
    Some(if at_crest { diagnostic.with_severity(Severity::Info) } else { diagnostic })
}

/// Values of the setup that matter for a thread.
#[derive(Clone, Copy, Debug)]
struct Known {
    /// Z of the face of the blank, mm, if given.
    face: Option<f64>,
    /// K of n ≤ 1200/P − K, rpm, if given.
    margin: Option<f64>,
    /// Rapid rate along Z, mm/min, if given.
    rapid: Option<f64>,
}

/// Reports a spindle speed that the slide cannot follow, or that exceeds the rule of thumb if the setup gives its
/// K.
fn too_fast(own: &Pass, pitch: f64, known: Known) -> Option<Message> {
    let Pass { speed, lead, .. } = *own;
    let slide = speed * lead;
    let limit = known.rapid.unwrap_or(MAX_SLIDE_SPEED);
    if slide > limit + LENGTH_TOLERANCE {
        return Some(said::ThreadSlideTooFast { speed, lead, slide, limit }.into());
    }
    let margin = known.margin.filter(|_| PITCHES.contains(&pitch))?;
    let limit = SPEED_OF_PITCH / pitch - margin;
    (speed > limit)
        .then(|| said::ThreadTooFast { speed, pitch, limit: limit.floor().max(0.0), margin }.into())
}

/// Remarks about a pass: its speed, and whether it fits the pass before it. `fits`: it begins in a groove or
/// at another start of the thread, or a word gives its start angle. `starts`: number of starts of the thread.
/// `known`: values of the setup. `span`: the block.
fn remarks(
    own: &Pass,
    before: Option<&Pass>,
    fits: bool,
    starts: f64,
    known: Known,
    span: Span,
) -> Vec<Diagnostic> {
    let pitch = own.lead / starts;
    let mut diagnostics = Vec::new();
    let before = before.filter(|before| is_same_thread(own, before));
    if before.is_none() {
        if let Some(message) = too_fast(own, pitch, known) {
            let is_slide = message.is::<said::ThreadSlideTooFast>();
            let diagnostic = Diagnostic::new(message, span);
            // The rule of thumb is for small lathes.
            diagnostics.push(if is_slide { diagnostic.with_severity(Severity::Warning) } else { diagnostic });
        } else if let Some(run_in) = run_in(own, known.face) {
            diagnostics.push(Diagnostic::new(run_in, span));
        }
        return diagnostics;
    }
    let Some(before) = before else { return diagnostics };
    if (own.speed - before.speed).abs() > LENGTH_TOLERANCE && own.speed > 0.0 && before.speed > 0.0 {
        let message = said::ThreadSpeedChanged { before: before.speed, now: own.speed };
        diagnostics.push(Diagnostic::new(message, span));
    }
    let moved = own.start.z - before.start.z;
    let deeper = (own.start.x - before.start.x).abs().max((own.end.x - before.end.x).abs());
    if !fits && !is_along_flank(moved, deeper) {
        let (before, now) = (before.start.z, own.start.z);
        diagnostics.push(Diagnostic::new(said::ThreadStartMoved { before, now, lead: own.lead }, span));
    }
    diagnostics
}

/// Whether the start of a pass is shifted sideways by an infeed along a flank, which is up to 30° from
/// perpendicular.
fn is_along_flank(moved: f64, deeper: f64) -> bool {
    const STEEPEST: f64 = std::f64::consts::FRAC_PI_6;
    moved.abs() <= deeper * STEEPEST.tan() + LENGTH_TOLERANCE
}

/// Whether two passes belong to one thread: same tool, lead and end.
fn is_same_thread(own: &Pass, before: &Pass) -> bool {
    own.tool == before.tool
        && (own.lead - before.lead).abs() <= LENGTH_TOLERANCE
        && (own.end.z - before.end.z).abs() <= LENGTH_TOLERANCE
        && own.end.z < own.start.z
}

/// Whether a pass of the same thread began at the same start of it, possibly some leads away.
fn is_same_start(own: &Pass, before: &Pass) -> bool {
    is_same_thread(own, before) && is_whole_lead(own.start.z - before.start.z, own.lead)
}

/// Whether a shift of the start is a whole number of leads.
fn is_whole_lead(moved: f64, lead: f64) -> bool {
    let turns = moved / lead;
    (turns - turns.round()).abs() * lead <= LENGTH_TOLERANCE
}

/// Whether a shift of the start leads to the same groove, or so close beside it that the groove only gets
/// wider.
fn is_in_groove(moved: f64, lead: f64) -> bool {
    let turns = moved / lead;
    (turns - turns.round()).abs() * lead <= GROOVE_WIDENING * lead + LENGTH_TOLERANCE
}

/// Whether a shift of the start is a whole number of leads, or leads to another start of a multi-start
/// thread.
fn is_start_of_lead(moved: f64, lead: f64) -> bool {
    (1..=MAX_STARTS).any(|starts| is_whole_lead(moved, lead / f64::from(starts)))
}

/// A run-in that is shorter than δ1.
fn run_in(own: &Pass, face: Option<f64>) -> Option<Message> {
    let face = face?;
    if own.start.z <= face || own.end.z >= face {
        return None;
    }
    let (have, need) = (own.start.z - face, threading::run_in(own.speed, own.lead, threading::LEAD_ERROR));
    (have < need).then_some(said::ThreadRunIn { have, need }.into())
}

/// Checks the parameters of G76: the height of a 60° thread is 0.5 to 0.75 of its pitch, and more than the
/// first cut. Lengths in mm, the angle in degrees.
fn amounts(height: f64, first: f64, lead: f64, angle: f64) -> Option<Message> {
    if first > height + LENGTH_TOLERANCE {
        return Some(said::ThreadFirstDepth { first, height }.into());
    }
    // Relative to its lead, a thread with two or three starts is lower.
    let share = height / lead;
    let unusual = angle == 60.0 && !(0.2..=1.0).contains(&share);
    let usual = 0.001 * (650.0 * lead).round();
    unusual.then_some(said::ThreadHeight { height, pitch: lead, usual }.into())
}
