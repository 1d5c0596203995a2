//! Lints for nose radius compensation: the wrong side, compensation left on, and compensation without effect.

use super::once::Once;
use crate::control::codes::{Compensation, MotionMode, Multiple};
use crate::control::events::{CompensatedMove, EventContext, SinglePass};
use crate::control::tool_offset;
use crate::control::words::{plain, quote};
use crate::geometry::Point;
use crate::message::{Diagnostic, Severity, said};
use crate::motion::{Motion, MotionKind};
use crate::setup::ToolKind;
use crate::source::Span;
use crate::text::block::{Block, Word};

/// A cut along Z shows the side of the workpiece if it is at least this many times as long as across.
const ALONG: f64 = 2.0;

/// The state of the lints for compensation.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Compensations {
    /// Whether it was switched since the last motion, and so has not shifted a path yet.
    is_idle: bool,
    reported: Reported,
    /// Offsets whose unknown radius was reported, one bit for each number.
    unknown: u128,
}

/// The remarks that were made.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Reported {
    /// Compensation is left on.
    left_on: Once,
    /// It is on the wrong side.
    side: Once,
    /// The path reverses.
    turns_back: Once,
    /// The tool has no tip direction.
    tip: Once,
    /// Two blocks without a move.
    idle_blocks: Once,
    /// It has no effect here.
    no_effect: Once,
}

impl Compensations {
    /// Handles G40, G41 or G42.
    pub fn switched(&mut self) {
        self.is_idle = true;
        self.reported.no_effect.reset();
        self.reported.left_on.reset();
        self.reported.side.reset();
        self.reported.turns_back.reset();
    }

    /// Reports compensation that is still on when the tool leaves the workpiece at `span`.
    pub fn left_on(&mut self, span: Span, at: &EventContext, reports: &mut Vec<Diagnostic>) {
        let code = match at.state.compensation {
            Compensation::Off => return,
            Compensation::Left => "G41",
            Compensation::Right => "G42",
        };
        // If it was switched on for the next tool, it has not shifted a path yet.
        if at.contour.is_none()
            && !self.is_idle
            && at.state.virtual_plane.is_none()
            && self.reported.left_on.mark_reported()
        {
            let message = said::CompensationLeftOn { code, word: quote(at.text, span) };
            reports.push(Diagnostic::new(message, span));
        }
    }

    /// Checks moves to machine positions (G27, G28, G30, G53).
    pub fn machine_place(&mut self, block: &Block, at: &EventContext, reports: &mut Vec<Diagnostic>) {
        let goes = |word: &&Word| {
            word.address == b'G'
                && matches!(plain(word), Some(code) if [27.0, 28.0, 30.0, 53.0].contains(&code))
        };
        if let Some(word) = block.words.iter().find(goes) {
            self.left_on(word.span, at, reports);
        }
    }

    /// Handles the end of a block. Reports two blocks without a move while compensation is on.
    pub fn block_ends(
        &mut self,
        block: &Block,
        moved: bool,
        at: &EventContext,
        reports: &mut Vec<Diagnostic>,
    ) {
        self.is_idle &= !moved;
        if moved {
            self.radius_unknown(block, at, reports);
        }
        let compensating = at.state.compensating.as_ref().filter(|_| !moved);
        if compensating.is_some_and(|own| own.idle_blocks == 2 && !own.waiting.is_empty())
            && self.reported.idle_blocks.mark_reported()
        {
            reports.push(Diagnostic::new(said::CompensationIdleBlocks, block.words_span()));
        }
    }

    /// Reports a cut under compensation with an unknown nose radius, once for each offset.
    fn radius_unknown(&mut self, block: &Block, at: &EventContext, reports: &mut Vec<Diagnostic>) {
        let cuts = matches!(at.state.motion, MotionMode::Line | MotionMode::Arc(_));
        if at.state.compensation == Compensation::Off
            || !cuts
            || at.state.virtual_plane.is_some()
            || at.state.c_axis
        {
            return;
        }
        let Some(offset) = tool_offset::unknown_radius(at.state, at.setup) else { return };
        let bit = 1 << offset.min(127);
        if self.unknown & bit == 0 {
            self.unknown |= bit;
            let message = said::NoseRadiusUnknown { offset: u32::from(offset) };
            reports.push(Diagnostic::new(message, block.words_span()));
        }
    }

    /// Compares the side of compensation with the side of the workpiece in a straight cut (outside towards
    /// the chuck G42, in a bore G41).
    pub fn line(&mut self, block: &Block, to: Point, at: &EventContext, reports: &mut Vec<Diagnostic>) {
        if at.state.virtual_plane.is_some() {
            return;
        }
        let (radius, tip) = (at.nose_radius(), at.tip_direction());
        let (station, offset) = at.state.tool;
        let kind = at.setup.tool((station, offset)).and_then(|tool| tool.kind);
        let turns = !matches!(kind, Some(ToolKind::Endmill | ToolKind::Drill));
        if turns && matches!(tip, 0 | 9) && radius > 0.0 && self.reported.tip.mark_reported() {
            let message = said::CompensationTip { tip: f64::from(tip) };
            reports.push(Diagnostic::new(message, block.words_span()));
        }
        let wrong = wrong_side(at.state.compensation, tip, at.state.position, to);
        if let Some((code, right)) = wrong
            && self.reported.side.mark_reported()
        {
            reports.push(Diagnostic::new(said::CompensationSide { code, right }, block.words_span()));
        }
    }

    /// Checks a compensated move: it may reverse, or be too short to begin or end compensation.
    pub fn compensated(&mut self, own: &CompensatedMove, at: &EventContext, reports: &mut Vec<Diagnostic>) {
        if own.before.is_some_and(|before| turns_straight_back(before, own.motion))
            && self.reported.turns_back.mark_reported()
        {
            let code = if at.state.compensation == Compensation::Left { "G41" } else { "G42" };
            reports.push(Diagnostic::new(said::CompensationTurnsBack { code }, own.words));
        }
        let length = own.motion.from.distance(own.motion.to);
        let radius = at.nose_radius().abs();
        if own.begins_or_ends && length > 0.0 && length < radius && at.contour.is_none() {
            reports.push(Diagnostic::new(said::CompensationShort { length, radius }, own.span));
        }
    }

    /// Reports a thread under compensation, which has no effect on it.
    pub fn thread(
        &mut self,
        block: &Block,
        code: &'static str,
        at: &EventContext,
        reports: &mut Vec<Diagnostic>,
    ) {
        if at.state.compensation != Compensation::Off && self.reported.no_effect.mark_reported() {
            reports.push(Diagnostic::new(said::CompensationIdle { code }, block.words_span()));
        }
    }

    /// Reports roughing, pecking and thread cycles under compensation, which has no effect on them.
    pub fn multiple_cycle(
        &mut self,
        block: &Block,
        cycle: Multiple,
        at: &EventContext,
        reports: &mut Vec<Diagnostic>,
    ) {
        let is_on = cycle != Multiple::Finishing && at.state.compensation != Compensation::Off;
        if at.contour.is_none() && is_on && self.reported.no_effect.mark_reported() {
            let code = cycle.cycle().code();
            let diagnostic = Diagnostic::new(said::CompensationIdle { code }, block.words_span());
            // Newer controls rough with compensation that was on before (alarm PS0328).
            let rough = cycle.is_roughing();
            reports.push(if rough { diagnostic.with_severity(Severity::Info) } else { diagnostic });
        }
    }

    /// Checks G90 and G94. They are compensated, but need a nose radius, and their block must not contain a
    /// code of compensation.
    pub fn single_cycle(&mut self, pass: &SinglePass, at: &EventContext, reports: &mut Vec<Diagnostic>) {
        let code = pass.cycle.cycle().code();
        if pass.lead.is_none()
            && at.state.compensation != Compensation::Off
            && at.nose_radius() == 0.0
            && self.reported.no_effect.mark_reported()
        {
            let diagnostic = Diagnostic::new(said::CompensationIdle { code }, pass.block.words_span());
            // The radius may be in the offset table of the control.
            reports.push(diagnostic.with_severity(Severity::Info));
        }
    }

    /// Takes over the remarks that `other` has made.
    pub fn inherit_reported(&mut self, other: &Self) {
        self.reported = other.reported;
        self.unknown = other.unknown;
    }
}

/// A code of compensation in the block of a single cycle.
pub fn switched_in_cycle(pass: &SinglePass, at: &EventContext) -> Option<Diagnostic> {
    let switches = |word: &&Word| {
        let code = if word.address == b'G' { plain(word) } else { None };
        code.is_some_and(|code| {
            (41.0..=42.0).contains(&code) || code == 40.0 && at.state.compensating.is_some()
        })
    };
    let word = pass.block.words.iter().find(switches)?;
    let message =
        said::CompensationInCycle { word: quote(at.text, word.span), code: pass.cycle.cycle().code() };
    Some(Diagnostic::new(message, word.span))
}

/// Whether a straight move goes back along the cut before it.
fn turns_straight_back(before: &Motion, next: &Motion) -> bool {
    /// Sine of the largest angle between the two that counts as zero.
    const STRAIGHT: f64 = 1e-6;
    let way = |motion: &Motion| (motion.to.x - motion.from.x, motion.to.z - motion.from.z);
    let ((x, z), (next_x, next_z)) = (way(before), way(next));
    let (along, across) = (x * next_x + z * next_z, x * next_z - z * next_x);
    before.kind == MotionKind::Feed
        && next.center.is_none()
        && before.to.is_same(next.from)
        && along < 0.0
        && across.abs() <= STRAIGHT * along.abs()
}

/// The active code and the correct one, if they differ. `tip` is the direction of the imaginary tip, which
/// distinguishes outside work (3) from a bore (2).
fn wrong_side(
    compensation: Compensation,
    tip: u8,
    from: Point,
    to: Point,
) -> Option<(&'static str, &'static str)> {
    let (dx, dz) = ((to.x - from.x).abs(), to.z - from.z);
    if dz.abs() < ALONG * dx || dz == 0.0 || from.x <= 0.0 {
        return None;
    }
    let outside = match tip {
        3 | 4 => true,
        1 | 2 => false,
        _ => return None,
    };
    // In the picture (Z to the right, X up), the workpiece is on the left of an outside cut towards the
    // chuck.
    let right = if outside == (dz < 0.0) { Compensation::Right } else { Compensation::Left };
    let name = |side| if side == Compensation::Right { "G42" } else { "G41" };
    (compensation != right).then(|| (name(compensation), name(right)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn outside_work_toward_the_chuck_needs_g42() {
        let (from, to) = (Point::new(20.0, 2.0), Point::new(20.0, -30.0));
        assert_eq!(wrong_side(Compensation::Left, 3, from, to), Some(("G41", "G42")));
        assert_eq!(wrong_side(Compensation::Right, 3, from, to), None);
        assert_eq!(wrong_side(Compensation::Right, 2, from, to), Some(("G42", "G41")));
        assert_eq!(wrong_side(Compensation::Left, 3, to, from), None);
    }
}
