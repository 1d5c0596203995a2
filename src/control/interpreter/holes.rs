//! Hole cycles as blocks call them: G83 to G85 along Z, G87 to G89 along X, G80.
//!
//! In: the words of a block. Out: the moves of a hole at each position that the block gives.
//! `cycles::drilling` has the geometry; this file has the words, their memory and their alarms.

use super::request::{OneShot, Request};
use super::{AXES, Interpreter, TURNS};
use crate::control::codes::{Hole, HoleReturn};
use crate::control::events::Event;
use crate::control::modal::{HoleMemory, Lead, Once, Target};
use crate::control::words::{Counts, Words, letters, plain, quote};
use crate::cycles::drilling::{self, Exit};
use crate::cycles::units;
use crate::geometry::Point;
use crate::message::{Diagnostic, Fix, Severity, said};
use crate::motion::{CycleStep, Feed, Motion, MotionKind, SpindleTurn, Step};
use crate::parts::{Part, early};
use crate::setup::dialect::{Control, FeedMode, GSystem};
use crate::source::Span;
use crate::text::block::Block;
use crate::units::Diameter;

/// Distance between the start of a peck and the previous depth, mm (parameter 5114).
const CLEARANCE: f64 = 1.0;

/// Maximum number of repeats of a hole.
const MAX_REPEATS: f64 = 9_999.0;

early! {
    fn hole(control: &mut Interpreter, text: &[u8], block: &Block, request: &mut Request, words: &Words) {
        control.hole_cycle(text, block, request, words);
    }
}

impl Interpreter {
    /// A hole cycle comes into force, possibly again.
    #[inline(never)]
    pub(super) fn enter_hole(&mut self, kind: Hole, span: Span) {
        if matches!(kind, Hole::G81 | Hole::G82 | Hole::G86) && self.dialect.g_system == GSystem::A {
            let code = kind.code();
            self.report(Diagnostic::new(said::HoleOfOthers { code }, span));
        }
        if self.state.hole.is_none() {
            self.state.reported.reset(Once::HoleInForce);
        }
        self.state.hole = Some(match self.state.hole {
            // For a cycle along the same axis, values stay in force until G80.
            Some(hole) if hole.kind.is_face() == kind.is_face() => HoleMemory { kind, ..hole },
            Some(hole) => HoleMemory::at(kind, self.state.position, hole.before),
            None => HoleMemory::at(kind, self.state.position, self.state.motion),
        });
    }

    /// Whether a one-shot code is allowed while a hole cycle is in force (PS0044, PS0327). False: reported.
    #[inline(never)]
    pub(super) fn allowed_with_hole(&mut self, text: &[u8], block: &Block, one_shot: OneShot) -> bool {
        let alarm = match one_shot {
            OneShot::Home | OneShot::OtherHome | OneShot::CheckHome | OneShot::FromHome => "PS0044",
            OneShot::Multiple(_) => "PS0327",
            _ => return true,
        };
        let Some(hole) = self.state.hole else { return true };
        // Programs for controls with G81 often go to the reference point without G80.
        let lenient = alarm == "PS0044" && !self.dialect.strict;
        if lenient {
            self.state.motion = hole.before;
            self.state.hole = None;
        }
        // The alarm is not in the manuals of a control that lacks the cycle.
        let foreign = lenient && matches!(hole.kind, Hole::G81 | Hole::G82 | Hole::G86);
        if foreign || !self.state.reported.mark_reported(Once::HoleInForce) {
            return lenient;
        }
        let severity = if lenient { Severity::Warning } else { Severity::Error };
        let word = block.words.iter().rev().find(|word| word.address == b'G');
        let span = word.map_or_else(|| block.words_span(), |word| word.span);
        let (word, hole) = (quote(text, span), hole.kind.code());
        let diagnostic =
            Diagnostic::new(said::HoleInForce { word, hole, alarm }, span).with_severity(severity);
        self.report(diagnostic.with(Fix::insert(block.span.start, "G80\n".to_owned())));
        lenient
    }

    /// A block while a hole cycle is in force.
    pub(super) fn hole(&mut self, text: &[u8], block: &Block, request: &mut Request, words: &Words) {
        if self.has(Part::Early) {
            hole(self, text, block, request, words);
        }
    }

    fn hole_cycle(&mut self, text: &[u8], block: &Block, request: &mut Request, words: &Words) {
        let Some(mut memory) = self.state.hole else { return };
        let (kind, reading) = (memory.kind, self.reading());
        let length = |address: u8| words.get(address).and_then(|word| reading.length(word));
        let face = kind.is_face();
        if let Some(r) = length(b'R') {
            memory.r = Some(r);
        }
        // P of G54.1 is a frame, and P of G96 an axis.
        let is_dwell = request.extended_frame.is_none() && request.surface.is_none();
        if let Some(dwell) = words.get(b'P').filter(|_| is_dwell).and_then(plain) {
            memory.dwell = dwell / 1000.0;
        }
        let depth_words = if face { letters(b"ZW") } else { letters(b"XU") };
        let x = self.axis(text, words, b'X', b'U', Counts::Diameter);
        let z = self.axis(text, words, b'Z', b'W', Counts::Length);
        let (place, depth) = if face { (x, z) } else { (z, x) };
        if depth != Target::Stay {
            memory.depth = depth;
        }
        if !words.has_any(AXES | TURNS) {
            self.state.hole = Some(memory);
            return;
        }
        // The initial level is the position of the tool when the cycle came into force.
        let from = self.state.position;
        let at = match face {
            true => Point::new(place.from(from.x), memory.level.z),
            false => Point::new(memory.level.x, place.from(from.z)),
        };
        let turn = if face || !words.has_any(depth_words) || words.has_any(TURNS) {
            self.turn_target(text, words)
        } else {
            None
        };
        let level = if face { at.z } else { at.x };
        let r_level = self.r_level(&memory, level);
        let bottom = match memory.depth {
            Target::Absolute(place) => place,
            Target::Incremental(way) => r_level + way,
            Target::Stay => {
                let code = kind.code();
                self.report(Diagnostic::new(said::HoleNoDepth { code }, block.words_span()));
                request.drop = true;
                return;
            }
        };
        let point = |level: f64| if face { Point::new(at.x, level) } else { Point::new(level, at.z) };
        if words.peek(b'Q').is_some() {
            let (start, end) = (point(r_level), point(bottom));
            let Some((_, _, q)) = self.amounts(text, words, |_, q| units::pecking(start, end, None, q))
            else {
                request.drop = true;
                return;
            };
            memory.peck = q.map(f64::abs).filter(|&q| q > 0.0);
            if memory.peck.is_none() && kind.pecks() {
                let message = said::PeckZero { word: words.quote(text, b'Q') };
                self.report(Diagnostic::new(message, words.span(b'Q')));
                request.drop = true;
                return;
            }
        }
        self.state.hole = Some(memory);
        let lead = kind.is_tap().then(|| self.tap_lead(text, block, words, kind)).flatten();
        if (kind.is_tap() && lead.is_none()) || (!kind.is_tap() && !self.may_cut(text, block, words, request))
        {
            request.drop = true;
            return;
        }
        let spindle = &self.state.spindle;
        let turns = spindle.turn != SpindleTurn::Stopped && !spindle.is_held && !self.state.c_axis;
        let off_center = if turns && !kind.is_tap() { drilling::OFF_CENTER } else { crate::geometry::SAME };
        if turn.is_some() || !face || at.x.abs() > off_center {
            self.observe(text, Event::Milling { block });
        }
        let hole = drilling::Hole {
            initial: at,
            r: point(r_level),
            bottom: point(bottom),
            peck: memory.peck.filter(|_| kind.pecks()),
            clearance: CLEARANCE,
            waits: memory.dwell > 0.0,
            back_to: match self.state.hole_return {
                HoleReturn::Initial => at,
                HoleReturn::RPoint => point(r_level),
            },
            exit: if kind.is_tap() {
                Exit::Thread
            } else if kind.is_drill() || kind == Hole::G86 {
                Exit::Rapid
            } else {
                Exit::Feed
            },
        };
        request.moved = true;
        self.leave_compensation();
        if kind.is_tap() && face && at.x.abs() <= crate::geometry::SAME {
            self.observe(text, Event::TapOnAxis { block });
        }
        let repeats = words
            .get(b'K')
            .and_then(plain)
            .map_or(1.0, |repeats| crate::geometry::within(repeats, 0.0, MAX_REPEATS));
        let turning =
            if self.state.incremental { words.get(b'C').or(words.get(b'H')) } else { words.get(b'H') };
        let turned = turning.and_then(|word| reading.degrees(word)).unwrap_or(0.0);
        // Repeats continue by incremental positions: a row of holes.
        let step = match place {
            Target::Incremental(step) if face => Point::new(step, 0.0),
            Target::Incremental(step) => Point::new(0.0, step),
            _ => Point::default(),
        };
        let mut hole = hole;
        for round in 0..repeats as u32 {
            let c = if round == 0 { turn } else { Some(self.state.c + turned) };
            if round > 0 {
                hole = hole.moved_by(step);
            }
            if !self.one_hole(block, kind, &hole, lead, memory.dwell, c) {
                return;
            }
        }
    }

    /// The R level. R is measured from the initial level towards the hole (system A). If that would lead away
    /// from the hole, or the system has absolute words, R is a position.
    fn r_level(&self, memory: &HoleMemory, level: f64) -> f64 {
        let Some(r) = memory.r else { return level };
        let absolute = self.dialect.g_system != GSystem::A && !self.state.incremental;
        // A position along X is a diameter.
        let place = if memory.kind.is_face() { r } else { Diameter::new(r).radius() };
        let bottom = match memory.depth {
            Target::Absolute(place) => place,
            Target::Incremental(way) => level + way,
            Target::Stay => level,
        };
        let away = (bottom - level) * r < 0.0;
        if absolute || away { place } else { level + r }
    }

    /// The lead of a tap, mm. On FANUC its F is an ordinary feed: feed per minute divided by revolutions per
    /// minute.
    fn tap_lead(&mut self, text: &[u8], block: &Block, words: &Words, kind: Hole) -> Option<f64> {
        let lead = self.lead(text, block, words, kind.code())?;
        let (rpm, gsk) = (self.state.spindle.rpm, self.dialect.control == Control::Gsk);
        let by_e = matches!(self.state.lead, Some(Lead::ByE(_)));
        let by_minute = self.state.feed_mode == FeedMode::PerMinute && !by_e && !gsk;
        Some(if by_minute && rpm > 0.0 { lead / rpm } else { lead })
    }

    /// Makes one hole. False: it was refused.
    fn one_hole(
        &mut self,
        block: &Block,
        kind: Hole,
        hole: &drilling::Hole,
        lead: Option<f64>,
        dwell: f64,
        c: Option<f64>,
    ) -> bool {
        let most = self.moves_left();
        let Ok(moves) = drilling::drill(hole, most) else {
            self.refuse_long_cycle(block, kind.code(), most, most);
            return false;
        };
        let tag = |step: Step, pass: u32| Some(CycleStep { cycle: kind.cycle(), pass, step });
        // Along its own axis the tool moves only within the cycle.
        let from = self.state.position;
        let start = match kind.is_face() {
            true => Point::new(hole.initial.x, from.z),
            false => Point::new(from.x, hole.initial.z),
        };
        let approach = Motion { cycle: tag(Step::Approach, 0), ..self.motion(MotionKind::Rapid, start) };
        let approach = self.turning(approach, c);
        self.push(block, approach);
        let kept = self.sink.kept();
        // Rigid tapping turns the spindle itself; with a live tool the spindle does not turn.
        let in_axis = kind.is_face() && hole.initial.x.abs() <= crate::geometry::SAME && c.is_none();
        let tapping = match self.state.spindle.turn {
            SpindleTurn::Stopped if in_axis && !self.state.spindle.live_tool => SpindleTurn::Forward,
            turn => turn,
        };
        for step in &moves {
            let mut motion = Motion { cycle: tag(step.step, step.pass), ..self.motion(step.kind, step.to) };
            // Rigid tapping, or a live tool that a machine-specific M code has started.
            motion.process.still = false;
            motion.lead = lead.filter(|_| step.kind == MotionKind::Thread);
            if step.kind == MotionKind::Thread {
                motion.process.turn = match step.step {
                    // The tap turns the other way to come out.
                    Step::Retract => tapping.reversed(),
                    _ => tapping,
                };
            }
            motion.seconds = (step.kind == MotionKind::Dwell).then_some(dwell);
            if step.kind == MotionKind::Feed && step.step == Step::Retract {
                // Boring retracts at twice the feed.
                motion.process.feed = match motion.process.feed {
                    Feed::PerMinute(feed) => Feed::PerMinute(2.0 * feed),
                    Feed::PerTurn(feed) => Feed::PerTurn(2.0 * feed),
                    Feed::Unset => Feed::Unset,
                };
            }
            self.push(block, motion);
        }
        self.spend((moves.len() + 1).saturating_sub(self.sink.kept() - kept), block)
    }
}
