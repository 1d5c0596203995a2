//! Settings of a block without a move: F, S, T, coordinate systems, speed limits; and the one-shot codes G04
//! and G28, which read the words of their block in their own way.

use super::Interpreter;
use super::request::{OneShot, Request};
use crate::control::contour::ContourUse;
use crate::control::events::Event;
use crate::control::modal::Once;
use crate::control::offsets::{EXTENDED_FRAMES, STANDARD_FRAMES};
use crate::control::tool_offset;
use crate::control::words::{Words, as_meant, letters, plain, quote};
use crate::geometry::Point;
use crate::message::{Diagnostic, Message, Severity, said};
use crate::motion::{Motion, MotionKind, SpindleTurn};
use crate::setup::dialect::Control;
use crate::source::Span;
use crate::text::block::{Block, Value, Word};

impl Interpreter {
    /// S, F and T, with the effect of G96, G97 and G50 on S.
    #[inline]
    pub(super) fn set_feed_speed_tool(
        &mut self,
        text: &[u8],
        block: &Block,
        request: &Request,
        words: &Words,
    ) {
        const FEED_SPEED_TOOL: u32 = letters(b"FST");
        if request.surface.is_none() && !words.has_any(FEED_SPEED_TOOL) {
            return;
        }
        let reading = self.reading();
        if self.contours.purpose == Some(ContourUse::Roughing)
            && let Some(address) =
                [b'F', b'S', b'T'].into_iter().find(|&address| words.peek(address).is_some())
        {
            self.observe(text, Event::IgnoredInRoughing { address, words });
        }
        let setting = request.one_shot == Some(OneShot::Setting);
        if let Some(surface) = request.surface {
            self.surface_speed(text, block, surface, words);
        }
        if let Some(word) = words.get(b'S').filter(|_| !setting)
            && let Some(value) = plain(word)
        {
            self.observe(text, Event::SpindleSpeed { value, word });
            let spindle = &mut self.state.spindle;
            spindle.zero_speed = value == 0.0;
            if spindle.surface {
                spindle.cutting_speed = value * self.state.unit.surface_metres();
            } else {
                spindle.rpm = value;
            }
        }
        if let Some(value) = words.get(b'F').and_then(|word| reading.feed(word)) {
            self.observe(text, Event::Feed);
            self.state.feed = Some(value);
            self.state.reported.reset(Once::FeedZero);
            self.state.lead = None;
        }
        if let Some(word) = words.get(b'T') {
            self.plane_left_on(text, word.span);
            let before = self.state.tool;
            self.tool(text, word, request.changes_tool);
            let goes_home = matches!(request.one_shot, Some(OneShot::Home | OneShot::OtherHome));
            self.observe(text, Event::Tool { word, before, goes_home });
        }
    }

    #[inline(never)]
    fn surface_speed(&mut self, text: &[u8], block: &Block, surface: bool, words: &Words) {
        self.observe(text, Event::SpeedMode { surface, block, words });
        let most = self.setup.machine.max_speed;
        let spindle = &mut self.state.spindle;
        if !surface && spindle.surface && words.get(b'S').is_none() {
            // G97 without S keeps the last speed.
            spindle.rpm = spindle.speed_within(self.state.position.x, most).unwrap_or(spindle.rpm);
        }
        spindle.surface = surface;
    }

    /// The T word: station and offset (seed 001).
    #[inline(never)]
    pub(super) fn tool(&mut self, text: &[u8], word: &Word, changes_tool: bool) {
        let Value::Number { number, .. } = word.value else { return };
        let value = number.mantissa;
        let written = as_meant(text, word.span);
        let digits = match written.contains(['#', '[']) {
            // A value from a variable has no leading zeros.
            true => value.checked_ilog10().map_or(1, |power| power as usize + 1),
            false => written.bytes().filter(u8::is_ascii_digit).count(),
        };
        let (station, offset) = match digits {
            0..=2 => (0, value),
            3 | 4 => (value / 100, value % 100),
            _ => (value / 1000, value % 1000),
        };
        // `T2200` and later `T22`: the station is already at work, and gets its offset now.
        let (at_work, in_force) = self.state.tool;
        let adds_offset = in_force == 0 && u64::from(at_work) == value;
        let is_short = digits <= 2 && value > 0;
        self.state.has_long_tools |= digits > 2;
        // With M06, and no T word of four digits: a turret with two-digit T words, or a tool changer.
        let is_station = is_short && changes_tool && !self.state.has_long_tools;
        if is_station {
            let message = said::ShortToolAsStation { word: quote(text, word.span), station: value as u32 };
            self.report(Diagnostic::new(message, word.span).with_severity(Severity::Info));
        } else if is_short && !adds_offset {
            let message = said::ShortTool { word: quote(text, word.span), offset: offset as u32 };
            let diagnostic = Diagnostic::new(message, word.span);
            self.report(if changes_tool { diagnostic.with_severity(Severity::Info) } else { diagnostic });
        }
        // Six digits are split three and three: `T010101` would be offset 101; some machines have that many.
        let beyond = station > 999 || digits > 6;
        if beyond || (digits == 6 && offset > 99) {
            // With M06 it is the number of a tool changer.
            let of_machine = !beyond || changes_tool;
            let word_text = quote(text, word.span);
            let message: Message = match of_machine {
                true => said::ToolNumberOfMachine { word: word_text }.into(),
                false => said::ToolNumber { word: word_text }.into(),
            };
            let diagnostic = Diagnostic::new(message, word.span);
            self.report(if of_machine { diagnostic.with_severity(Severity::Info) } else { diagnostic });
            if beyond {
                return;
            }
        }
        let station = match digits {
            0..=2 if is_station => value as u16,
            0..=2 => at_work,
            _ => station as u16,
        };
        self.state.tool = (station, offset as u16);
        self.update_tip_shift();
    }

    /// Applies the offset in force, after a T word or a change of the offset table.
    pub(super) fn update_tip_shift(&mut self) {
        let has_values = !self.setup.tools.is_empty() || !self.state.offsets.is_empty();
        if !has_values || !self.has(tool_offset::OFFSETS) {
            return;
        }
        let shift = tool_offset::tip_shift(&self.state, &self.setup);
        if shift != self.state.tip_shift {
            self.leave_compensation();
            self.state.set_tip_shift(shift);
        }
    }

    /// G04.
    pub(super) fn dwell(&mut self, text: &[u8], block: &Block, words: &Words, request: &mut Request) {
        let reading = self.reading();
        // If X or U gives the time, P is not read.
        let by_seconds = words.get(b'X').or_else(|| words.get(b'U')).and_then(|word| reading.seconds(word));
        let milliseconds = if by_seconds.is_none() { words.get(b'P') } else { None };
        let pointed = milliseconds
            .filter(|word| matches!(word.value, Value::Number { number, .. } if number.has_point()));
        let forum = self.dialect.control == Control::Forum;
        if let Some(word) = pointed.filter(|_| !forum) {
            // Haas reads seconds if there is a point.
            let severity = if self.dialect.strict { Severity::Error } else { Severity::Warning };
            let message = said::DwellWithPoint { word: quote(text, word.span) };
            self.report(Diagnostic::new(message, word.span).with_severity(severity));
            if severity == Severity::Error {
                request.drop = true;
                return;
            }
        }
        let scale = if pointed.is_some() && !forum { 1.0 } else { 1000.0 };
        let by_milliseconds = milliseconds.and_then(plain).map(|value| value / scale);
        match by_seconds.or(by_milliseconds) {
            Some(seconds) if seconds > 0.0 => {
                self.observe(text, Event::Dwell { words, seconds });
                let motion = self.motion(MotionKind::Dwell, self.state.position);
                let motion = Motion { seconds: Some(seconds), ..motion };
                self.push_dwell(self.path_move(block, motion));
            }
            _ => {
                let diagnostic = Diagnostic::new(said::DwellNoTime, block.words_span());
                // Many controls take a G04 without time as an exact stop; with the spindle stopped, no groove
                // waits for a revolution.
                let only_stops = self.state.spindle.turn == SpindleTurn::Stopped
                    && !self.state.spindle.zero_speed
                    && !words.has_any(letters(b"XUPF"));
                self.report(if only_stops { diagnostic.with_severity(Severity::Info) } else { diagnostic });
            }
        }
    }

    /// G50: coordinate setting and speed limits (seed 002, FANUC 16/18-T B-62754EN p. 127).
    pub(super) fn setting(&mut self, text: &[u8], words: &Words) {
        let reading = self.reading();
        let length = |address: u8| words.get(address).and_then(|word| reading.length(word));
        self.leave_compensation();
        let at = self.state.position;
        let radius = |address: u8| words.get(address).and_then(|word| reading.radius(word));
        let (x, z) = (radius(b'X'), length(b'Z'));
        // New coordinates of the tip: old programs set them for each tool.
        let named = Point::new(x.map_or(0.0, |x| x - at.x), z.map_or(0.0, |z| z - at.z));
        self.state.shift_coordinates(named);
        self.sink.chunk.shift_coordinates(named);
        let or_zero =
            |given: Option<f64>, other: Option<f64>| given.filter(|_| other.is_none()).unwrap_or(0.0);
        let (u, w) = (or_zero(radius(b'U'), x), or_zero(length(b'W'), z));
        self.change_frame(|frames| frames.shift = Point::new(frames.shift.x - u, frames.shift.z - w));
        let spindle = &mut self.state.spindle;
        if let Some((word, highest)) = words.get(b'S').and_then(|word| Some((word, plain(word)?))) {
            spindle.highest = Some(highest);
            self.observe(text, Event::HighestSpeed { word });
        }
        let spindle = &mut self.state.spindle;
        if let Some(lowest) = words.get(b'Q').and_then(plain) {
            spindle.lowest = Some(lowest);
        }
        let limit = [b'Q', b'S'].into_iter().find(|&address| words.peek(address).is_some());
        if let (Some(lowest), Some(highest), Some(limit)) = (spindle.lowest, spindle.highest, limit)
            && lowest > highest
        {
            self.report(Diagnostic::new(said::ClampReversed { lowest, highest }, words.span(limit)));
        }
    }

    /// G52: local shift, in every frame; X0 Z0 cancels it.
    pub(super) fn local_frame(&mut self, words: &Words) {
        let reading = self.reading();
        let length = |address: u8| words.get(address).and_then(|word| reading.length(word));
        let (x, z) = (words.get(b'X').and_then(|word| reading.radius(word)), length(b'Z'));
        self.change_frame(|frames| {
            let local = frames.local;
            frames.local = Point::new(x.unwrap_or(local.x), z.unwrap_or(local.z));
        });
    }

    /// G54.1 Pn: the frames beyond G59.
    pub(super) fn extended_frame(&mut self, text: &[u8], request: &mut Request, words: &Words, span: Span) {
        let named = words.get(b'P').and_then(plain).map(|number| number as u32);
        match named {
            Some(frame) if (1..=u32::from(EXTENDED_FRAMES)).contains(&frame) => {
                self.change_frame(|frames| frames.active = STANDARD_FRAMES + frame as u16 - 1);
            }
            _ => {
                let word = words.get(b'P').map_or(quote(text, span), |word| quote(text, word.span));
                self.report(Diagnostic::new(
                    said::OffsetNumber { word },
                    words.get(b'P').map_or(span, |word| word.span),
                ));
                request.drop = true;
            }
        }
    }
}
