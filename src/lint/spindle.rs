//! Lints for the spindle before a cut: whether it turns, its speed, and its highest speed; and the classroom
//! checklist of each tool.

use super::feed::{code_of, feed_codes};
use super::once::Once;
use crate::control::codes::G;
use crate::control::events::EventContext;
use crate::control::words::{Words, letters, plain, quote};
use crate::message::{Diagnostic, Fix, Message, Severity, said};
use crate::motion::SpindleTurn;
use crate::source::Span;
use crate::source::shift::Shift;
use crate::text::block::{Block, Word};

/// M10 and M11, M68 and M69: which code of a pair closes the chuck depends on the manufacturer.
const CLAMP_ON: u64 = 10;
const CLAMP_OFF: u64 = 11;
const CHUCK_CLOSE: u64 = 68;
const CHUCK_OPEN: u64 = 69;

/// M19 and M20 each stop the spindle at a fixed angle. M20 has other meanings on many machines.
const ORIENTATION: u64 = 19;
const SECOND_ORIENTATION: u64 = 20;
/// Inserts seldom cut faster than this, m/min; programs in feet without their G20 do not reach it.
const MAX_CUTTING_SPEED: f64 = 1800.0;
/// Slowest usual cutting speed, m/min: chilled rolls, and high-speed steel in hard material, come close to
/// it.
const MIN_CUTTING_SPEED: f64 = 5.0;
/// Sliding-head lathes come close to this speed, rpm; a common lathe reaches half of it.
const MAX_SPEED: f64 = 12_000.0;
/// The same for small bars, and without a given blank.
const MAX_SPEED_SMALL_BAR: f64 = 20_000.0;
/// Largest diameter of a small bar, mm.
const MAX_SMALL_BAR: f64 = 20.0;

/// A move at feed with the spindle stopped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct StoppedMove {
    /// Its block.
    block: Span,
    /// The words of the block.
    words: Span,
    /// Whether M03 is the missing code: a speed is active, and no tap is turned out.
    starts_forward: bool,
}

/// G96 without a highest speed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Unclamped {
    /// Its S, or its block.
    span: Span,
    /// Where a block before it would be inserted.
    before: u32,
}

/// G97 without S.
#[derive(Clone, Copy, Debug, PartialEq)]
struct KeptSpeed {
    /// The words of its block.
    block: Span,
    /// The current speed, rpm.
    speed: f64,
}

/// The state of the lints for the spindle.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Spindle {
    /// G96 without a highest speed, and no cut since: G50 may still set one.
    unclamped: Option<Unclamped>,
    /// A move at feed with the spindle stopped, without a rapid away since. If the chuck opens or closes now,
    /// the tool stops or pulls the bar.
    stopped_move: Option<StoppedMove>,
    /// Whether an M code appeared whose meaning depends on the machine: it may have connected C or started a
    /// live tool.
    pub unknown_m: bool,
    /// The orientation code (M19, M20) that holds the spindle, if nothing has started it since.
    held: Option<u64>,
    /// G97 without S, which keeps the current speed; S may still follow.
    kept: Option<KeptSpeed>,
    /// Whether coolant is on (M07, M08).
    coolant: bool,
    /// Remark: the spindle is stopped.
    pub stopped: Once,
    /// Remark: it has no speed.
    speed_missing: Once,
    /// Remark: it has no highest speed.
    no_clamp: Once,
    /// Remark: the checklist of the tool.
    checklist: Once,
}

impl Spindle {
    /// Checks a cut at feed. `feed_mode_named`: a code of the feed mode appeared before it.
    #[inline]
    pub fn cut(
        &mut self,
        block: &Block,
        feed_mode_named: bool,
        at: &EventContext,
        reports: &mut Vec<Diagnostic>,
    ) {
        if let Some(KeptSpeed { block, speed }) = self.kept.take() {
            let message = said::SpeedNotRepeated { code: "G97", speed };
            reports.push(Diagnostic::new(message, block));
        }
        if self.checklist.mark_reported() {
            self.report_checklist(block, feed_mode_named, at, reports);
        }
        if self.unclamped.is_some() {
            self.report_speed_clamp(at, reports);
        }
        let spindle = &at.state.spindle;
        if spindle.turn == SpindleTurn::Stopped || spindle.zero_speed {
            self.cut_while_stopped(block, at, reports);
        } else {
            let speed = if spindle.surface { spindle.cutting_speed } else { spindle.rpm };
            if speed == 0.0 && !self.may_be_driven(at) && self.speed_missing.mark_reported() {
                let of_surface = spindle.surface && spindle.rpm > 0.0;
                let message: Message =
                    if of_surface { said::SurfaceSpeedMissing.into() } else { said::SpeedMissing.into() };
                reports.push(Diagnostic::new(message, block.words_span()));
            }
        }
    }

    /// Checks a thread. Other kinds of cuts may be made with the spindle held, such as shaping a keyway.
    pub fn thread(
        &mut self,
        block: &Block,
        feed_mode_named: bool,
        at: &EventContext,
        reports: &mut Vec<Diagnostic>,
    ) {
        self.cut(block, feed_mode_named, at, reports);
        // After M05 in a thread, M04 may be missing: a tap is turned out.
        if at.state.spindle.is_stopped
            && let Some(still) = self.stopped_move.as_mut().filter(|still| still.block == block.span)
        {
            still.starts_forward = false;
        }
        if self.held == Some(ORIENTATION) && at.state.spindle.turn != SpindleTurn::Stopped {
            self.cut_while_stopped(block, at, reports);
        }
    }

    /// Whether an unknown code may drive the workpiece or a live tool.
    fn may_be_driven(&self, at: &EventContext) -> bool {
        let spindle = &at.state.spindle;
        // The M code that starts a live tool depends on the machine.
        let milling = at.state.c_axis || at.state.virtual_plane.is_some();
        spindle.live_tool || spindle.machine_code_with_speed || milling && self.unknown_m
    }

    /// Handles a cut with the spindle stopped.
    #[inline(never)]
    fn cut_while_stopped(&mut self, block: &Block, at: &EventContext, reports: &mut Vec<Diagnostic>) {
        if self.may_be_driven(at) || !self.stopped.mark_reported() {
            return;
        }
        let starts_forward = at.state.spindle.rpm > 0.0 || at.state.spindle.cutting_speed > 0.0;
        let still = StoppedMove { block: block.span, words: block.words_span(), starts_forward };
        match at.contour {
            None => self.stopped_move = Some(still),
            // State stored while a contour is read is discarded, so the move is reported now.
            Some(_) => reports.push(still.message()),
        }
    }

    /// Reports what is missing before the first cut of a tool according to the classroom checklist.
    #[inline(never)]
    fn report_checklist(
        &self,
        block: &Block,
        feed_mode_named: bool,
        at: &EventContext,
        reports: &mut Vec<Diagnostic>,
    ) {
        let missing: [Option<Message>; 3] = [
            (at.state.tool == (0, 0)).then(|| said::ToolNotNamed.into()),
            (!feed_mode_named).then(|| {
                let (per_turn, per_minute) = feed_codes(at);
                said::FeedModeNotNamed { per_turn, per_minute }.into()
            }),
            (!self.coolant).then(|| said::CoolantOff.into()),
        ];
        let missing = missing.into_iter().flatten();
        reports.extend(missing.map(|message| Diagnostic::new(message, block.words_span())));
    }

    /// Reports a motion under G96 without a highest speed, once in a program.
    #[inline(never)]
    pub fn report_speed_clamp(&mut self, at: &EventContext, reports: &mut Vec<Diagnostic>) {
        if let Some(Unclamped { span, before }) = self.unclamped.take()
            && self.no_clamp.mark_reported()
        {
            let code = code_of(G::Setting, at);
            let fix = Fix::insert(before, format!("{code} S2000\n"));
            reports.push(Diagnostic::new(said::NoSpeedClamp { code }, span).with(fix));
        }
    }

    /// Reports a move at feed with the spindle stopped that was not the work of a bar puller.
    #[inline]
    pub fn report_stopped_move(&mut self, reports: &mut Vec<Diagnostic>) {
        if let Some(still) = self.stopped_move.take() {
            reports.push(still.message());
        }
    }

    /// Does not report a block as a cut with the spindle stopped: another message has its cause.
    pub fn forget_stopped_move(&mut self, block: &Block) {
        self.stopped_move = self.stopped_move.filter(|still| still.block != block.span);
    }

    /// Handles an M code. `is_known`: this control knows its meaning.
    pub fn m_code(
        &mut self,
        number: u64,
        is_known: bool,
        word: &Word,
        at: &EventContext,
        reports: &mut Vec<Diagnostic>,
    ) {
        let spindle = &at.state.spindle;
        // M11 opens the chuck on many machines. M69 does on machines with two spindles, which transfer the
        // part while both turn.
        if number == CLAMP_OFF
            && spindle.turn != SpindleTurn::Stopped
            && self.held.is_none()
            && !spindle.live_tool
            && !at.state.c_axis
        {
            let message = said::ChuckOpen { word: quote(at.text, word.span) };
            reports.push(Diagnostic::new(message, word.span));
        }
        match number {
            // A bar is pulled, or fed against a stop, with the spindle stopped and the chuck open.
            CLAMP_ON | CLAMP_OFF | CHUCK_CLOSE | CHUCK_OPEN => self.chuck_moves(number, at),
            // On some machines other codes open and close the chuck.
            _ if !is_known && self.stopped_move.is_some() => self.chuck_moves(number, at),
            3 | 4 => {
                self.held = None;
                self.report_stopped_move(reports);
            }
            13 | 14 => self.report_stopped_move(reports),
            ORIENTATION | SECOND_ORIENTATION => self.held = Some(number),
            7 | 8 => self.coolant = true,
            9 => self.coolant = false,
            _ => {}
        }
        self.unknown_m |= !is_known;
    }

    /// Handles the chuck. With the spindle stopped, moves at feed hold or pull the bar.
    fn chuck_moves(&mut self, number: u64, at: &EventContext) {
        if at.state.spindle.turn != SpindleTurn::Stopped {
            return;
        }
        let held = self.stopped_move.take().is_some();
        if held || matches!(number, CLAMP_OFF | CHUCK_OPEN) {
            // Moves at feed before the spindle turns again belong to the bar feed.
            self.stopped.suppress();
        }
    }

    /// Handles S outside of G50: S0 stops the spindle, another speed lets it turn again.
    pub fn speed(&mut self, value: f64, word: &Word, at: &EventContext, reports: &mut Vec<Diagnostic>) {
        self.kept = None;
        reports.extend(unusual_speed(value, word, at));
        if at.state.spindle.zero_speed != (value == 0.0) {
            self.stopped.reset();
        }
    }

    /// Handles G96 or G97.
    pub fn speed_mode(&mut self, surface: bool, block: &Block, words: &Words, at: &EventContext) {
        let spindle = &at.state.spindle;
        let speed_given = words.peek(b'S').is_some();
        self.kept = None;
        if !surface {
            self.unclamped = None;
            if spindle.surface && !speed_given {
                // G97 without S keeps the current speed.
                let kept = at.spindle_speed(at.state.position.x).unwrap_or(spindle.rpm).floor();
                if kept > 0.0 {
                    self.kept = Some(KeptSpeed { block: block.words_span(), speed: kept });
                }
            }
        } else if !spindle.surface && spindle.highest.is_none() {
            let span = words.span(b'S');
            self.unclamped = Some(Unclamped { span, before: block_start(at.text, span.start) });
        }
    }

    /// Handles G50 S.
    pub fn highest_speed(&mut self, word: &Word, at: &EventContext, reports: &mut Vec<Diagnostic>) {
        self.unclamped = None;
        if plain(word).is_some_and(|highest| highest > MAX_SPEED_SMALL_BAR.max(max_usual_speed(at))) {
            let message = said::SpindleSpeedHigh { word: quote(at.text, word.span) };
            reports.push(Diagnostic::new(message, word.span));
        } else if let Some(highest) = plain(word) {
            // Under G96 the machine holds the speed at its own limit.
            let above = above_machine(highest, word, at);
            reports.extend(above.map(|above| above.with_severity(Severity::Info)));
        }
    }

    /// Handles M05.
    pub fn stops(&mut self, block: &Block, moved: bool, reports: &mut Vec<Diagnostic>) {
        if moved {
            let stop = block.words.iter().find(|word| word.address == b'M' && plain(word) == Some(5.0));
            let span = stop.map_or_else(|| block.words_span(), |word| word.span);
            reports.push(Diagnostic::new(said::StopBehindMove, span));
        }
        self.stopped.reset();
    }

    /// Handles a tool change.
    pub fn tool_changes(&mut self, reports: &mut Vec<Diagnostic>) {
        self.checklist.reset();
        self.report_stopped_move(reports);
    }

    /// Suppresses the remark about a missing speed, because a skipped block may have set it.
    pub fn suppress_speed_missing(&mut self, at: &EventContext) {
        let spindle = &at.state.spindle;
        if spindle.rpm == 0.0 && spindle.cutting_speed == 0.0 {
            self.speed_missing.suppress();
        }
    }

    /// Suppresses the remarks about settings that a block or program may have made.
    pub fn suppress_unknown_settings(&mut self) {
        self.stopped.suppress();
        self.no_clamp.suppress();
    }

    /// Takes over the remarks that `other` has made.
    pub fn inherit_reported(&mut self, other: &Self) {
        (self.stopped, self.speed_missing) = (other.stopped, other.speed_missing);
        (self.no_clamp, self.checklist) = (other.no_clamp, other.checklist);
    }

    /// First bytes of the blocks and words that may be reported later.
    pub fn waiting(&self) -> [Option<u32>; 3] {
        [
            self.unclamped.map(|unclamped| unclamped.before),
            self.stopped_move.map(|still| still.block.start),
            self.kept.map(|kept| kept.block.start),
        ]
    }

    /// Shifts the stored spans after an edit.
    pub fn shift(&mut self, shift: &Shift) {
        self.unclamped = self.unclamped.map(|unclamped| Unclamped {
            span: shift.span(unclamped.span),
            before: shift.byte(unclamped.before),
        });
        self.kept = self.kept.map(|kept| KeptSpeed { block: shift.span(kept.block), ..kept });
        self.stopped_move = self.stopped_move.map(|still| StoppedMove {
            block: shift.span(still.block),
            words: shift.span(still.words),
            ..still
        });
    }
}

impl StoppedMove {
    #[cold]
    fn message(self) -> Diagnostic {
        // With M03 alone the speed would be missing next.
        let fix = self.starts_forward.then(|| Fix::insert(self.block.start, "M03\n".to_owned()));
        let diagnostic = Diagnostic::new(said::SpindleStopped, self.words);
        Diagnostic { fixes: fix.into_iter().collect(), ..diagnostic }
    }
}

/// Start of the block that contains a byte.
pub fn block_start(text: &[u8], byte: u32) -> u32 {
    let end = text[..byte as usize].iter().rposition(|byte| matches!(byte, b'\n' | b'\r' | b';'));
    end.map_or(0, |end| end as u32 + 1)
}

/// Reports an S that cannot be a cutting speed, or a spindle speed.
fn unusual_speed(value: f64, word: &Word, at: &EventContext) -> Option<Diagnostic> {
    let quoted = || quote(at.text, word.span);
    let spindle = &at.state.spindle;
    let message: Message = if spindle.surface {
        let metres = value * at.state.unit.surface_metres();
        if metres > MAX_CUTTING_SPEED {
            said::CuttingSpeedHigh { word: quoted(), metres: metres.round() }.into()
        } else if metres > 0.0 && metres <= MIN_CUTTING_SPEED {
            said::CuttingSpeedLow { word: quoted(), metres: (10.0 * metres).round() / 10.0 }.into()
        } else {
            return None;
        }
    } else if value > max_usual_speed(at)
        && !spindle.live_tool
        && !spindle.machine_code_with_speed
        && !at.state.c_axis
    {
        said::SpindleSpeedHigh { word: quoted() }.into()
    } else {
        return above_machine(value, word, at);
    };
    Some(Diagnostic::new(message, word.span))
}

/// Reports a speed of the spindle above the highest speed of the machine, if the setup gives it.
fn above_machine(value: f64, word: &Word, at: &EventContext) -> Option<Diagnostic> {
    let spindle = &at.state.spindle;
    let may_be_live = spindle.live_tool || spindle.machine_code_with_speed || at.state.c_axis;
    let highest = at.setup.machine.max_speed.filter(|&highest| value > highest && !may_be_live)?;
    let message = said::SpeedAboveMachine { word: quote(at.text, word.span), highest };
    Some(Diagnostic::new(message, word.span))
}

/// Fastest usual spindle speed of this setup, rpm.
fn max_usual_speed(at: &EventContext) -> f64 {
    let is_small = at.setup.extents().is_none_or(|stock| stock.diameter.mm() <= MAX_SMALL_BAR);
    match at.setup.machine.max_speed {
        Some(own) => own.max(MAX_SPEED),
        None if is_small => MAX_SPEED_SMALL_BAR,
        None => MAX_SPEED,
    }
}

/// Whether the words of a block do not move the tool: `W0`.
pub fn stays(words: &Words) -> bool {
    let idle = |address: u8| words.peek(address).and_then(plain).is_some_and(|way| way == 0.0);
    !words.has_any(letters(b"XZCHA"))
        && words.has_any(letters(b"UW"))
        && !words.has_any(letters(b"RIK"))
        && [b'U', b'W'].into_iter().all(|address| words.peek(address).is_none() || idle(address))
}
