//! Motions on their way into the list, and the bounds of that list.
//!
//! In: motions. Out: those that have a length, in the coordinates of the machine.

use super::*;

impl Interpreter {
    /// A motion from where the tip stands.
    #[inline]
    pub(super) fn motion(&self, kind: MotionKind, to: Point) -> Motion {
        Motion {
            kind,
            from: self.state.position,
            to,
            center: None,
            lead: None,
            seconds: None,
            programmed: None,
            rotary: None,
            cycle: None,
            process: self.state.process(),
        }
    }

    /// Keeps a motion unless it has no length, and puts the tip at its end.
    #[inline]
    pub(super) fn push(&mut self, block: &Block, motion: Motion) {
        self.emit(self.routed(block, motion));
        self.state.position = motion.to;
    }

    /// M00, M01: the program stops once all moves before it are made, those that wait for a next one included.
    #[cold]
    pub(super) fn stop(&mut self, block: &Block, kind: StopKind) {
        // A contour is read for its shape alone.
        if self.contours.recorded.is_none() {
            let here = self.motion(MotionKind::Dwell, self.state.position);
            self.wait_here(Routed { stop: Some(kind), ..self.routed(block, here) });
        }
    }

    /// Keeps a motion unless it has no length.
    #[inline]
    pub(super) fn emit(&mut self, mut routed: Routed) {
        if let Some(kind) = routed.stop {
            let stop = Stop { kind, span: routed.span, line: routed.line };
            // Of several stops at one place the one that cannot be skipped counts.
            let own = &mut self.state.stop;
            if own.is_none_or(|before| before.kind == StopKind::Optional) {
                *own = Some(stop);
            }
            return;
        }
        if let Some(tip) = self.state.tip.take() {
            routed.motion.from = tip;
        }
        let motion = &routed.motion;
        let still = motion.from.is_same(motion.to)
            && motion.center.is_none()
            && motion.seconds.is_none()
            && motion.rotary.is_none()
            && routed.third.is_none_or(|(from, to)| from == to);
        if still || self.sink.is_full() {
            return;
        }
        if let Some(third) = routed.third {
            routed = self.on_machine(routed, third);
        }
        match &mut self.contours.recorded {
            // One more than a cycle may have, so that it is refused rather than cut short.
            Some(recorded) if recorded.len() <= self.setup.limits.moves_per_cycle => recorded.push(routed),
            Some(_) => {}
            None => self.store(routed),
        }
    }

    /// Keeps a motion for good.
    #[inline]
    fn store(&mut self, mut routed: Routed) {
        if !self.sink.has_room() {
            self.sink.end(Message::TooManyMotions { most: self.setup.limits.motions }, routed.span);
            return;
        }
        // A block after that of a motion that waited may have failed.
        routed.motion.process.incomplete |= self.state.incomplete;
        if let Some(stop) = self.state.stop.take() {
            self.sink.chunk.stop(&stop);
        }
        if routed.motion.kind.cuts() {
            self.state.frames.cut();
        }
        self.sink.chunk.push(&routed.motion, routed.span, routed.line);
    }
}
