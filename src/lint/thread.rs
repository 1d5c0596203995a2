//! Threads: what an instructor would remark of a pass.

use crate::control::modal::ThreadPass;
use crate::message::{Diagnostic, Message, Severity};
use crate::source::Span;

/// n ≤ 1200 / P − K (seed 001).
const SPEED_OF_PITCH: f64 = 1200.0;
/// K of that rule.
const SPEED_MARGIN: f64 = 80.0;
/// Pitches for which the rule was made, mm.
const PITCHES: std::ops::RangeInclusive<f64> = 0.2..=10.0;
/// Lengths this near are the same, mm.
const NEAR: f64 = 0.001;
/// Few slides are faster than this, mm/min.
const FAST_SLIDE: f64 = 4000.0;
/// Most starts of a thread that are looked for.
const STARTS: u32 = 8;

/// Remarks about a pass: its speed, and whether it meets the pass before it. `angle`: a word gives the angle at which it starts.
/// `starts`: of how many starts the thread is. `face`: Z of the face of the blank, if one is known. `span`: the block.
pub fn remarks(
    own: &ThreadPass,
    before: Option<&ThreadPass>,
    angle: bool,
    starts: f64,
    face: Option<f64>,
    span: Span,
) -> Vec<Diagnostic> {
    let pitch = own.lead / starts;
    let mut told = Vec::new();
    let before = before.filter(|before| is_same_thread(own, before));
    if before.is_none() {
        let limit = SPEED_OF_PITCH / pitch - SPEED_MARGIN;
        if PITCHES.contains(&pitch) && own.speed > limit {
            let speed = own.speed;
            let message = Message::ThreadTooFast { speed, pitch, limit: limit.floor() };
            let told_of = Diagnostic::new(message, span);
            // The rule of thumb is for small lathes.
            let is_fast = speed * own.lead > FAST_SLIDE;
            told.push(if is_fast { told_of.graded(Severity::Warning) } else { told_of });
        } else if let Some(run_in) = run_in(own, face) {
            told.push(Diagnostic::new(run_in, span));
        }
        return told;
    }
    let Some(before) = before else { return told };
    if (own.speed - before.speed).abs() > NEAR && own.speed > 0.0 && before.speed > 0.0 {
        let message = Message::ThreadSpeedChanged { before: before.speed, now: own.speed };
        told.push(Diagnostic::new(message, span));
    }
    let moved = own.start.z - before.start.z;
    let deeper = (own.start.x - before.start.x).abs().max((own.end.x - before.end.x).abs());
    if !angle && !is_start_of_lead(moved, own.lead) && !is_along_flank(moved, deeper) {
        let (before, now) = (before.start.z, own.start.z);
        told.push(Diagnostic::new(Message::ThreadStartMoved { before, now, lead: own.lead }, span));
    }
    told
}

/// Whether a pass begins as far to the side as infeed along a flank leads it, which is up to 30° off the square.
fn is_along_flank(moved: f64, deeper: f64) -> bool {
    const STEEPEST: f64 = std::f64::consts::FRAC_PI_6;
    moved.abs() <= deeper * STEEPEST.tan() + NEAR
}

/// Two passes with one tool, lead and end are one thread.
fn is_same_thread(own: &ThreadPass, before: &ThreadPass) -> bool {
    own.tool == before.tool
        && (own.lead - before.lead).abs() <= NEAR
        && (own.end.z - before.end.z).abs() <= NEAR
        && own.end.z < own.start.z
}

/// Whether a shift of the start is a whole number of leads, or leads to another start of a thread of several.
fn is_start_of_lead(moved: f64, lead: f64) -> bool {
    let turns = moved / lead;
    (1..=STARTS).any(|starts| {
        let parts = turns * f64::from(starts);
        (parts - parts.round()).abs() * lead <= NEAR * f64::from(starts)
    })
}

/// δ1 = 3.605 · n·L / 1800: what a slide needs to reach its speed.
fn run_in(own: &ThreadPass, face: Option<f64>) -> Option<Message> {
    let face = face?;
    if own.start.z <= face || own.end.z >= face {
        return None;
    }
    let (have, need) = (own.start.z - face, 3.605 * own.speed * own.lead / 1800.0);
    (have < need).then_some(Message::ThreadRunIn { have, need })
}

/// What of the amounts of a G76 does not fit: the height of a 60° thread is 0.5 to 0.75 of its pitch, and more than the
/// first cut. Lengths in mm, the angle in degrees.
pub fn amounts(height: f64, first: f64, lead: f64, angle: f64) -> Option<Message> {
    if first > height + NEAR {
        return Some(Message::ThreadFirstDepth { first, height });
    }
    // A thread of two or three starts is lower, measured by its lead.
    let share = height / lead;
    let unusual = angle == 60.0 && !(0.2..=1.0).contains(&share);
    let usual = 0.001 * (650.0 * lead).round();
    unusual.then_some(Message::ThreadHeight { height, pitch: lead, usual })
}
