//! Lints: remarks that an instructor would make about code that the control accepts. One file for each family
//! of rules.
//!
//! In: the events of a run (`control::events`), in one pass. Out: remarks. [`Lints`] dispatches each event to
//! the families that handle it; each family has its own state. Lints do not change what the control does, so
//! a run without them makes the same motions. `plausible` compares the numbers of the whole program after it
//! has run. Lints that need the part are in `findings`.

mod compensation;
mod contour;
mod dwell;
mod feed;
mod once;
pub mod plausible;
mod rotary;
mod single_cycle;
mod spindle;
mod taper;
mod thread;
mod tool;
mod words;

use std::any::Any;
use std::ops::Range;

use crate::control::codes::MotionMode;
use crate::control::events::{Event, EventContext, Observer};
use crate::cycles::single::Single;
use crate::message::Diagnostic;
use crate::source::shift::Shift;
use crate::text::block::Block;

/// All lints of a run with their state.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Lints {
    compensations: compensation::Compensations,
    contours: contour::Contours,
    feed: feed::Feed,
    loops: words::Loops,
    vacant: words::Vacant,
    rotary: rotary::Rotary,
    single_cycles: single_cycle::SingleCycles,
    spindle: spindle::Spindle,
    threads: thread::Threads,
    tool_changes: tool::ToolChanges,
}

impl Observer for Lints {
    fn on_event(&mut self, event: &Event<'_>, at: &EventContext<'_>, reports: &mut Vec<Diagnostic>) {
        match *event {
            Event::Cut { block, words, feed } => {
                self.feed.cut(block, words, feed, at, reports);
                if !spindle::stays(words) {
                    self.spindle.cut(block, self.feed.mode_named, at, reports);
                }
            }
            Event::CutWithoutFeed { block } => self.spindle.cut(block, self.feed.mode_named, at, reports),
            Event::Rapid => self.spindle.report_stopped_move(reports),
            _ => self.handle_other_events(event, at, reports),
        }
    }

    fn clone_box(&self) -> Box<dyn Observer> {
        Box::new(self.clone())
    }

    fn continues_like(&self, other: &dyn Observer) -> bool {
        own(other).is_some_and(|other| self == other)
    }

    fn shift(&mut self, shift: &Shift) {
        self.contours.shift(shift);
        self.feed.shift(shift);
        self.loops.shift(shift);
        self.rotary.shift(shift);
        self.single_cycles.shift(shift);
        self.spindle.shift(shift);
    }

    fn waits_for(&self, changed: Range<u32>) -> bool {
        let waiting = self.feed.waiting().into_iter().chain(self.single_cycles.waiting());
        waiting
            .chain([self.rotary.waiting()])
            .chain(self.spindle.waiting())
            .flatten()
            .any(|byte| changed.contains(&byte))
    }

    fn fork_for_contour(&mut self) -> Box<dyn Observer> {
        // The state of the contours may be large, so it is not copied; `inherit_reported` takes it over later.
        let contours = std::mem::take(&mut self.contours);
        let aside = self.clone_box();
        self.contours = contours;
        aside
    }

    fn inherit_reported(&mut self, before: &mut dyn Observer) {
        let Some(other) = (before as &mut dyn Any).downcast_mut::<Self>() else { return };
        self.contours = std::mem::take(&mut other.contours);
        self.compensations.inherit_reported(&other.compensations);
        self.feed.inherit_reported(&other.feed);
        self.loops.inherit_reported(&mut other.loops);
        self.vacant.inherit_reported(&mut other.vacant);
        self.rotary = other.rotary;
        self.single_cycles.inherit_reported(&other.single_cycles);
        self.spindle.inherit_reported(&other.spindle);
        self.threads.inherit_reported(&other.threads);
    }
}

impl Lints {
    /// Handles the events that are less frequent than moves.
    #[inline(never)]
    fn handle_other_events(
        &mut self,
        event: &Event<'_>,
        at: &EventContext<'_>,
        reports: &mut Vec<Diagnostic>,
    ) {
        match *event {
            Event::Cut { .. } | Event::CutWithoutFeed { .. } | Event::Rapid => {}
            Event::FromAxis { block, to } => self.threads.moves(block, to, at, reports),
            Event::CompensatedLine { block, to } => self.compensations.line(block, to, at, reports),
            Event::CompensatedBlock { block, moved } => {
                self.compensations.block_ends(block, moved, at, reports);
            }
            Event::FeedMode(mode) => self.feed.mode(mode, at),
            Event::Feed => self.feed.given(at, reports),
            Event::SpindleSpeed { value, word } => self.spindle.speed(value, word, at, reports),
            Event::UnreadWords { block, words, unread, code } => {
                reports.extend(words::unread(block, words, unread, code, at));
            }
            Event::Dwell { words, seconds } => reports.extend(dwell::check_dwell(words, seconds, at)),
            Event::VacantWord { word } => reports.extend(self.vacant.report_vacant(word, at)),
            Event::While { statement, enter } => self.loops.record(statement, enter, at),
            Event::SpeedMode { surface, block, words } => {
                self.spindle.speed_mode(surface, block, words, at);
            }
            Event::HighestSpeed { word } => self.spindle.highest_speed(word, at, reports),
            Event::SpindleStops { block, moved } => {
                self.spindle.stops(block, moved, reports);
                self.threads.spindle_stops();
            }
            Event::MCode { number, known, word } => {
                self.contours.m_code(number);
                self.spindle.m_code(number, known.is_some(), word, at, reports);
                if let Some(code) = known {
                    reports.extend(self.rotary.m_code(code, word, at));
                    reports.extend(self.threads.m_code(code, word));
                }
            }
            Event::Tool { word, before, goes_home } => {
                if goes_home {
                    self.tool_changes.home(at);
                }
                if at.state.tool.0 != before.0 {
                    self.threads.tool_changes();
                    self.spindle.tool_changes(reports);
                    if before.0 != 0 {
                        self.compensations.left_on(word.span, at, reports);
                        reports.extend(self.tool_changes.turns(word, at));
                    }
                }
            }
            Event::Home => {
                self.tool_changes.home(at);
                self.spindle.report_stopped_move(reports);
            }
            Event::MachinePlace { block } => self.compensations.machine_place(block, at, reports),
            Event::Compensation => self.compensations.switched(),
            Event::Compensated(own) => self.compensations.compensated(&own, at, reports),
            Event::MotionCode { .. } => self.single_cycles.ends(at, reports),
            Event::CycleCode { cycle, block, words } => {
                // In code system B a lone G94 sets feed per minute.
                let is_lone = block.words.len() == 1 && at.state.motion != MotionMode::Cycle(cycle);
                if is_lone && cycle == Single::Facing {
                    self.feed.unit_is_chosen();
                    self.rotary.feed.suppress();
                }
                self.single_cycles.begins(cycle, block, words, at, reports);
            }
            Event::OneShot => {
                self.single_cycles.series_ends(at, reports);
                self.single_cycles.one_shot();
            }
            Event::OldTaperWord { words } => reports.extend(self.single_cycles.old_taper_word(words, at)),
            Event::CycleWithoutAxis { words, cycle, taper } => {
                reports.extend(words::without_axis(words, cycle, at));
                if let Some(end) = self.single_cycles.end(at) {
                    if let Some(word) = taper {
                        reports.extend(single_cycle::axis_missing(at, word.span, cycle, end));
                    } else if let Some(word) = words.peek(b'F') {
                        self.feed.note_lone_feed(word, cycle, end);
                    }
                }
            }
            Event::SinglePass(pass) => {
                self.single_cycles.called(&pass, at, reports);
                self.compensations.single_cycle(&pass, at, reports);
                if let Some(thread) = pass.thread(at) {
                    self.threads.pass(&thread, at, reports);
                }
                self.single_cycles.pass(&pass, at, reports);
                reports.extend(compensation::switched_in_cycle(&pass, at));
            }
            Event::LeadOfFeed { block, code, feed } => self.feed.check_lead(block, code, feed, reports),
            Event::Thread { block, code, to } => {
                self.spindle.thread(block, self.feed.mode_named, at, reports);
                self.threads.begins(block, code, to, at, reports);
                self.compensations.thread(block, code, at, reports);
            }
            Event::ThreadMove { pass, code } => self.threads.cuts(&pass, code, at, reports),
            Event::ThreadPass(pass) => self.threads.pass(&pass, at, reports),
            Event::TapOnAxis { block } => self.threads.tap_on_axis(block, at, reports),
            Event::Threading(call) => thread::multi_threading(&call, at, reports),
            Event::MultipleCycle { block, cycle } => {
                self.feed.multiple_cycle();
                self.compensations.multiple_cycle(block, cycle, at, reports);
            }
            Event::ContourNamed { purpose, named } => self.contours.named(purpose, named),
            Event::IgnoredInRoughing { address, words } => self.contours.ignored(address, words, at),
            Event::Finishing(call) => self.contours.finishing(&call, reports),
            Event::RoughingCalled(call) => contour::roughing_called(&call, at, reports),
            Event::Roughing(call) => {
                let (code, allowance) = (call.how.direction.code(), call.how.allowance);
                self.contours.roughs(code, allowance, &call, at, reports);
                contour::roughing(&call, at, reports);
            }
            Event::Pattern(call) => {
                self.contours.roughs("G73", call.how.allowance, &call, at, reports);
                contour::pattern(&call, at, reports);
            }
            Event::Milling { block } => self.mills(block, at, reports),
            Event::PlaneMove { block, words, plane } => {
                self.mills(block, at, reports);
                if self.rotary.face_move(block, words, &plane, at, reports) {
                    self.feed.unit_is_reported();
                }
            }
            Event::CAxis { span } => {
                self.rotary.c_is_used();
                reports.extend(self.rotary.c_moves(span, self.spindle.unknown_m, at));
            }
            Event::NearCenter { distance, words } => {
                reports.extend(self.rotary.passes_center(distance, words));
            }
            Event::LeftOut => self.spindle.suppress_speed_missing(at),
            Event::SettingsUnknown => self.spindle.suppress_unknown_settings(),
            Event::ProgramEnds { end } => {
                self.feed.report_lone_feed(at, reports);
                self.single_cycles.series_ends(at, reports);
                self.spindle.report_stopped_move(reports);
                reports.extend(self.rotary.report_start_with_c());
                if let Some(end) = end {
                    self.compensations.left_on(end.span, at, reports);
                }
            }
            Event::RunEnds => {
                self.feed.report_doubtful(at, reports);
                self.single_cycles.series_ends(at, reports);
                self.spindle.report_stopped_move(reports);
                self.spindle.report_speed_clamp(at, reports);
                reports.extend(self.rotary.report_start_with_c());
                self.contours.run_ends(reports);
                self.loops.report(reports);
            }
        }
    }

    fn mills(&mut self, block: &Block, at: &EventContext, reports: &mut Vec<Diagnostic>) {
        if let Some(diagnostic) = self.rotary.mills(block, self.spindle.unknown_m, at) {
            // It is reported for the live tool, so not for the spindle as well.
            self.spindle.stopped.suppress();
            self.spindle.forget_stopped_move(block);
            reports.push(diagnostic);
        }
    }
}

/// The observer as lints, if it is one.
fn own(observer: &dyn Observer) -> Option<&Lints> {
    (observer as &dyn Any).downcast_ref()
}
