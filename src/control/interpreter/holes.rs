//! Hole cycles as blocks call them: G83 to G85 along Z, G87 to G89 along X, G80 (semantics §10).
//!
//! In: the words of a block. Out: the moves of a hole at each place the block names. The geometry is in
//! `cycles::drilling`; here are the words, their memory and their alarms.

use super::*;
use crate::control::codes::Hole;
use crate::control::modal::HoleMemory;
use crate::cycles::drilling::{self, Exit};
use crate::cycles::units;

/// How far above the last depth a peck begins, mm (parameter 5114).
const CLEARANCE: f64 = 1.0;

/// Most repeats of a hole.
const MOST_REPEATS: f64 = 9_999.0;

impl Interpreter {
    /// A hole cycle comes into force, or is spelled once more.
    pub(super) fn enter_hole(&mut self, kind: Hole, span: Span) {
        let (before, level) = match &self.state.hole {
            Some(hole) => (hole.before, hole.level),
            None => (self.state.motion, self.state.position),
        };
        if matches!(kind, Hole::G81 | Hole::G82 | Hole::G86) && self.dialect.g_system == GSystem::A {
            let code = kind.code();
            self.tell(Diagnostic::new(Message::HoleOfOthers { code }, span));
        }
        self.state.hole = Some(HoleMemory::at(kind, level, before));
    }

    /// A block while a hole cycle is in force.
    pub(super) fn hole(&mut self, text: &[u8], block: &Block, request: &mut Request, words: &Words) {
        let Some(mut memory) = self.state.hole else { return };
        let (kind, reading) = (memory.kind, self.reading());
        let length = |address: u8| words.get(address).and_then(|word| reading.length(word));
        let face = kind.is_face();
        if let Some(r) = length(b'R') {
            memory.r = Some(r);
        }
        if let Some(dwell) = words.get(b'P').and_then(plain) {
            memory.dwell = dwell / 1000.0;
        }
        let depth_words = if face { letters(b"ZW") } else { letters(b"XU") };
        let x = self.axis(text, words, b'X', b'U', 0.5);
        let z = self.axis(text, words, b'Z', b'W', 1.0);
        let (place, depth) = if face { (x, z) } else { (z, x) };
        if depth != Target::Stay {
            memory.depth = depth;
        }
        if !words.has_any(AXES | TURNS) {
            self.state.hole = Some(memory);
            return;
        }
        // The initial level is where the tool stood when the cycle came into force.
        let at = match (face, place) {
            (true, place) => Point::new(place.from(self.state.position.x), memory.level.z),
            (false, place) => Point::new(memory.level.x, place.from(self.state.position.z)),
        };
        let turn = if face || !words.has_any(depth_words) || words.has_any(TURNS) {
            self.turn_target(words)
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
                self.tell(Diagnostic::new(Message::HoleNoDepth { code }, block.words_span()));
                request.drop = true;
                return;
            }
        };
        let point = |level: f64| if face { Point::new(at.x, level) } else { Point::new(level, at.z) };
        if words.get(b'Q').is_some() {
            let (start, end) = (point(r_level), point(bottom));
            let Some((_, _, q)) = self.amounts(text, words, |_, q| units::pecking(start, end, None, q))
            else {
                request.drop = true;
                return;
            };
            memory.peck = q.map(f64::abs).filter(|&q| q > 0.0);
        }
        self.state.hole = Some(memory);
        let lead = kind.is_tap().then(|| self.lead(block, words, kind.code())).flatten();
        if (kind.is_tap() && lead.is_none()) || (!kind.is_tap() && !self.may_cut(block, words, request)) {
            request.drop = true;
            return;
        }
        if turn.is_some() || !face || at.x.abs() > crate::geometry::SAME {
            self.watch_live_tool(block);
        }
        let hole = drilling::Hole {
            initial: at,
            r: point(r_level),
            bottom: point(bottom),
            peck: memory.peck.filter(|_| kind.is_drill()),
            clearance: CLEARANCE,
            waits: memory.dwell > 0.0,
            exit: if kind.is_tap() {
                Exit::Thread
            } else if kind.is_drill() {
                Exit::Rapid
            } else {
                Exit::Feed
            },
        };
        request.moved = true;
        self.leave_compensation();
        let repeats = words.get(b'K').and_then(plain).map_or(1.0, |repeats| repeats.clamp(0.0, MOST_REPEATS));
        let turned = words.get(b'H').and_then(|word| reading.degrees(word)).unwrap_or(0.0);
        for round in 0..repeats as u32 {
            let c = if round == 0 { turn } else { Some(self.state.c + turned) };
            if !self.one_hole(block, kind, &hole, lead, memory.dwell, c) {
                return;
            }
        }
    }

    /// The R level. R counts from the initial level towards the hole (system A); one that would lead away from it,
    /// or a system with absolute words, means a place.
    fn r_level(&self, memory: &HoleMemory, level: f64) -> f64 {
        let Some(r) = memory.r else { return level };
        let absolute = self.dialect.g_system != GSystem::A && !self.state.incremental;
        // A place along X is a diameter.
        let place = if memory.kind.is_face() { r } else { r / 2.0 };
        let bottom = match memory.depth {
            Target::Absolute(place) => place,
            Target::Incremental(way) => level + way,
            Target::Stay => level,
        };
        let away = (bottom - level) * r < 0.0;
        if absolute || away { place } else { level + r }
    }

    /// One hole. False: it was refused.
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
            self.spend(most, block);
            let message = Message::TooManyPasses { code: kind.code(), most };
            self.tell(Diagnostic::new(message, block.words_span()));
            return false;
        };
        let tag = |step: Step, pass: u32| Some(CycleStep { cycle: kind.cycle(), pass, step });
        let approach =
            Motion { cycle: tag(Step::Approach, 0), ..self.motion(MotionKind::Rapid, hole.initial) };
        let approach = self.turning(approach, c);
        self.push(block, approach);
        let kept = self.kept();
        for step in &moves {
            let mut motion =
                Motion { cycle: tag(step.step, step.pass), lead, ..self.motion(step.kind, step.to) };
            motion.seconds = (step.kind == MotionKind::Dwell).then_some(dwell);
            if step.kind == MotionKind::Feed && step.step == Step::Retract {
                // A boring tool comes back twice as fast as it went in.
                motion.process.feed = match motion.process.feed {
                    Feed::PerMinute(feed) => Feed::PerMinute(2.0 * feed),
                    Feed::PerTurn(feed) => Feed::PerTurn(2.0 * feed),
                    Feed::Unset => Feed::Unset,
                };
            }
            self.push(block, motion);
        }
        self.spend((moves.len() + 1).saturating_sub(self.kept() - kept), block)
    }
}
