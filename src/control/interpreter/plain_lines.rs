//! Fast path for plain lines, which contain only a motion target. Most lines of a long program are plain.
//!
//! In: the program, at a possible start of plain lines. Out: their motions. All conditions are checked once,
//! before the first line, because plain lines do not change them. Executing each line as a block has the same
//! result, but is slower; a line that may not be plain is left to [`Interpreter::run`].

use super::Interpreter;
use crate::control::codes::{Compensation, MotionMode, Plane};
use crate::control::events::Event;
use crate::control::modal::CycleMemory;
use crate::control::words::Reading;
use crate::geometry::Point;
use crate::motion::MotionKind;
use crate::text::parser::Parser;
use crate::text::plain_line::PlainLine;
use crate::units::Diameter;

impl Interpreter {
    /// Executes at most `most` plain lines that begin before the byte `end`; returns their number.
    ///
    /// This is a separate function that returns now and then: a browser uses the optimised code of a loop
    /// only when the loop is entered again.
    #[inline(never)]
    pub fn plain_lines(&mut self, parser: &mut Parser, most: usize, end: u32) -> usize {
        let begin = parser.position();
        if !self.allows_fast_path() || !self.program.is_unread_from(begin.byte) {
            return 0;
        }
        let room = self.setup.limits.motions.saturating_sub(self.sink.kept());
        let cuts_plainly = !self.cut_context_changed && self.state.feed.is_some_and(|feed| feed > 0.0);
        let (process, reading) = (self.state.process(), self.reading());
        let (mut taken, mut moves) = (0, false);
        let mut placed = self.state.call_stack.main_pass.absolute_axes;
        // A drill may be on the axis, which may cause a message.
        while taken < most.min(room) && !self.is_on_axis() {
            let Some(line) = parser.plain_line().filter(|line| line.span.start < end) else { break };
            let Some((mode, kind)) = mode(&line, self.state.motion) else { break };
            if kind.cuts() && !cuts_plainly {
                break;
            }
            let number = parser.take(&line);
            if mode != self.state.motion {
                self.observe(&[], Event::MotionCode { mode });
                self.state.motion = mode;
                if let Some(recorder) = &mut self.recorder {
                    recorder.note_motion(mode, line.span.start);
                }
            }
            if kind == MotionKind::Rapid {
                self.observe(&[], Event::Rapid);
            }
            let from = self.state.position;
            let to = end_point(&line, from, reading);
            if !from.is_same(to) {
                if !std::mem::replace(&mut moves, true) {
                    self.sink.chunk.begin_process(&process);
                }
                self.sink.chunk.push_on(kind, from, to, None, line.span, number);
                if kind.cuts() && self.state.frames.cut() {
                    self.place_motions_before();
                }
            }
            self.state.position = to;
            placed = [placed[0] | line.x.is_some(), placed[1] | line.z.is_some()];
            self.state.sequence = line.sequence.unwrap_or(self.state.sequence);
            taken += 1;
        }
        if taken > 0 {
            self.state.call_stack.main_pass.absolute_axes = placed;
            self.program.is_first_reading(parser.position().byte - 1);
            self.sink.fault = None;
        }
        taken
    }

    /// Whether lines of only X and Z make straight moves from the position of the tip, without any message.
    fn allows_fast_path(&self) -> bool {
        let state = &self.state;
        state.compensation == Compensation::Off
            && state.compensating.is_none()
            && state.pending.is_none()
            && state.virtual_plane.is_none()
            && state.y == 0.0
            && (state.plane == Plane::Zx || !self.setup.machine.has_y())
            && state.tip.is_none()
            && state.stop.is_none()
            && state.hole.is_none()
            && state.doubts.is_empty()
            && !state.incremental
            && !state.data_input
            && state.memory == CycleMemory::EMPTY
            && state.call_stack.calls.is_empty()
            && state.call_stack.modal.is_none()
            && self.contours.recorded.is_none()
            && self.contours.purpose.is_none()
            && self.trace.is_none()
            && !self.sink.muted
            && !self.sink.is_full()
    }
}

/// The code of group 01 in force in a line, if it is G00 or G01. `before`: the code in force before the line.
fn mode(line: &PlainLine, before: MotionMode) -> Option<(MotionMode, MotionKind)> {
    let mode = match line.code.map(|code| code.tenths()) {
        None => before,
        Some(Some(0)) => MotionMode::Rapid,
        Some(Some(10)) => MotionMode::Line,
        Some(_) => return None,
    };
    match mode {
        MotionMode::Rapid => Some((mode, MotionKind::Rapid)),
        MotionMode::Line => Some((mode, MotionKind::Feed)),
        MotionMode::Arc(_)
        | MotionMode::Thread
        | MotionMode::VariableThread
        | MotionMode::Tapping
        | MotionMode::Cycle(_) => None,
    }
}

/// End point of a line that begins at `from`.
fn end_point(line: &PlainLine, from: Point, reading: Reading) -> Point {
    let x = line.x.map_or(from.x, |(negative, x)| Diameter::new(reading.length_of(x, negative)).radius());
    Point::new(x, line.z.map_or(from.z, |(negative, z)| reading.length_of(z, negative)))
}
