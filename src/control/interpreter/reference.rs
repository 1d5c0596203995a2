//! Reference points and machine coordinates: G27, G28, G29, G30, G53 (seed 002); and the tables that G10
//! writes (FANUC 16i/18i-TB B-63524EN p. 285).
//!
//! In: the words of a block. Out: rapids, and changed tables.

use super::request::{OneShot, Request};
use super::{AXES, Interpreter, TURNS};
use crate::control::events::Event;
use crate::control::modal::{Once, Target};
use crate::control::offsets::{Column, EXTENDED_FRAMES, OFFSETS, STANDARD_FRAMES, Setting};
use crate::control::tool_offset;
use crate::control::words::{Counts, Words, letters, plain, quote};
use crate::geometry::Point;
use crate::message::{Diagnostic, said};
use crate::motion::MotionKind;
use crate::source::Span;
use crate::text::block::Block;
use crate::units::Diameter;

impl Interpreter {
    /// Programmed position that brings the tip to the reference point.
    fn reference_point(&self) -> Point {
        let home = self.dialect.ref_point;
        self.of_machine(Point::new(home.x.radius(), home.z))
    }

    /// Programmed position that brings the tip to a machine position.
    fn of_machine(&self, place: Point) -> Point {
        let (offset, shift) = (self.state.frames.offset(), self.state.tip_shift);
        Point::new(place.x - offset.x - shift.x, place.z - offset.z - shift.z)
    }

    /// G28, and G30 to the other reference points. The reference point of Y is over the spindle axis.
    pub(super) fn home(&mut self, text: &[u8], block: &Block, request: &mut Request, words: &Words) {
        self.go_home(text, block, request, words);
        if words.has_any(letters(b"YV")) {
            self.y_goes_home(block);
        }
    }

    /// Moves over the intermediate point to a reference point.
    fn go_home(&mut self, text: &[u8], block: &Block, request: &mut Request, words: &Words) {
        if request.one_shot == Some(OneShot::OtherHome)
            && let Some(word) = words.get(b'P')
            && !matches!(plain(word), Some(2.0 | 3.0 | 4.0))
        {
            let message = said::ReferenceNumber { word: quote(text, word.span) };
            self.report(Diagnostic::new(message, word.span));
            request.drop = true;
            return;
        }
        self.observe(text, Event::Home);
        self.other_axes(text, block, words);
        let turns = words.has_any(TURNS);
        if !words.has_any(AXES) && !turns {
            if !words.has_any(letters(b"YVAB")) && self.state.reported.mark_reported(Once::G28NoAxis) {
                let code = if request.one_shot == Some(OneShot::OtherHome) { "G30" } else { "G28" };
                self.report(Diagnostic::new(said::G28NoAxis { code }, block.words_span()));
            }
            return;
        }
        // On many machines C is connected by returning it to its reference point.
        self.state.c_axis |= turns;
        let middle = self.target(text, words);
        request.moved = true;
        // Each axis keeps the intermediate position it was last given.
        let named = |axes: u32| words.has_any(axes);
        let kept = self.state.intermediate.unwrap_or(middle);
        self.state.intermediate = Some(Point::new(
            if named(letters(b"XU")) { middle.x } else { kept.x },
            if named(letters(b"ZW")) { middle.z } else { kept.z },
        ));
        let c = self.turn_target(text, words);
        let motion = self.motion(MotionKind::Rapid, middle);
        let motion = self.turning(motion, c);
        self.push(block, motion);
        let (from, home) = (self.state.position, self.reference_point());
        let to = Point::new(
            if words.has_any(letters(b"XU")) { home.x } else { from.x },
            if words.has_any(letters(b"ZW")) { home.z } else { from.z },
        );
        let motion = self.motion(MotionKind::Rapid, to);
        let motion = self.turning(motion, turns.then_some(0.0));
        self.push(block, motion);
    }

    /// G27: moves to a point and checks that it is the reference point (PS0092).
    pub(super) fn check_home(&mut self, text: &[u8], block: &Block, request: &mut Request, words: &Words) {
        request.moved = true;
        let to = self.target(text, words);
        self.push(block, self.motion(MotionKind::Rapid, to));
        let home = self.reference_point();
        let off = |named: u32, a: f64, b: f64| words.has_any(named) && (a - b).abs() > 0.001;
        if off(letters(b"XU"), to.x, home.x) || off(letters(b"ZW"), to.z, home.z) {
            let message = said::NotAtReference { x: Diameter::from_radius(home.x).mm(), z: home.z };
            self.report(Diagnostic::new(message, block.words_span()));
        }
    }

    /// G29: moves over the intermediate point of G28 to the end point.
    pub(super) fn leave_home(&mut self, text: &[u8], block: &Block, request: &mut Request, words: &Words) {
        let Some(middle) = self.state.intermediate else {
            self.report(Diagnostic::new(said::NoIntermediate, block.words_span()));
            request.drop = true;
            return;
        };
        request.moved = true;
        // Incremental words are relative to the intermediate point; an axis without a word does not move.
        let from = self.state.position;
        let x = self.axis(text, words, b'X', b'U', Counts::Diameter);
        let z = self.axis(text, words, b'Z', b'W', Counts::Length);
        let over = |target: Target, from: f64, middle: f64| match target {
            Target::Stay => (from, from),
            target => (middle, target.from(middle)),
        };
        let ((over_x, to_x), (over_z, to_z)) = (over(x, from.x, middle.x), over(z, from.z, middle.z));
        self.push(block, self.motion(MotionKind::Rapid, Point::new(over_x, over_z)));
        self.push(block, self.motion(MotionKind::Rapid, Point::new(to_x, to_z)));
    }

    /// G53: a rapid in machine coordinates; incremental words are ignored.
    pub(super) fn machine_move(&mut self, text: &[u8], block: &Block, request: &mut Request, words: &Words) {
        let reading = self.reading();
        if let Some((word, y)) = words.get(b'Y').and_then(|word| Some((word, reading.length(word)?))) {
            self.move_y(text, block, word, y);
        }
        let x = words.get(b'X').and_then(|word| reading.radius(word));
        let z = words.get(b'Z').and_then(|word| reading.length(word));
        if x.is_none() && z.is_none() {
            return;
        }
        request.moved = true;
        let from = self.state.position;
        // Most machines measure from their reference point, where the slides are fully retracted. Coordinates
        // at zero or below are measured from there, because in the work frame they would be inside the chuck.
        let from_reference = x.unwrap_or(0.0) <= 0.0 && z.unwrap_or(0.0) <= 0.0;
        let zero = match from_reference {
            true => self.reference_point(),
            false => self.of_machine(Point::default()),
        };
        if from_reference
            && !self.dialect.ref_point_given
            && self.state.reported.mark_reported(Once::MachineZero)
        {
            let home = self.dialect.ref_point;
            self.report(Diagnostic::new(said::MachineZero { x: home.x.mm(), z: home.z }, block.words_span()));
        }
        let to = Point::new(x.map_or(from.x, |x| zero.x + x), z.map_or(from.z, |z| zero.z + z));
        self.push(block, self.motion(MotionKind::Rapid, to));
    }

    /// G10: the program writes offsets and zero points; L3, L50 and others begin data up to G11.
    pub(super) fn write_data(&mut self, text: &[u8], request: &mut Request, words: &Words) {
        let reading = self.reading();
        let length = |address: u8| words.get(address).and_then(|word| reading.length(word));
        let number = words.get(b'P').and_then(plain);
        if number.is_some_and(|number| number < 0.0 || number.fract() != 0.0) {
            self.bad_data(text, request, words, b'P');
            return;
        }
        if let Some(word) = words.get(b'Q').filter(|word| !matches!(plain(word), Some(0.0..=9.0))) {
            let message = said::TipNumber { word: quote(text, word.span) };
            self.report(Diagnostic::new(message, word.span));
            request.drop = true;
            return;
        }
        let kind = words.get(b'L').and_then(plain).map(|kind| kind as u32);
        let (x, z) = (length(b'X'), length(b'Z'));
        let (u, w) = (length(b'U'), length(b'W'));
        // Under G91 of systems B and C, X and Z are incremental, too.
        let (x, u) = if self.state.incremental { (None, x.or(u)) } else { (x, u) };
        let (z, w) = if self.state.incremental { (None, z.or(w)) } else { (z, w) };
        let setting = if x.is_some() || z.is_some() { Setting::Absolute } else { Setting::Relative };
        let zero = |point: &mut Point| {
            let radius = |diameter: f64| Diameter::new(diameter).radius();
            point.x = x.map_or(point.x + radius(u.unwrap_or(0.0)), radius);
            point.z = z.unwrap_or(point.z + w.unwrap_or(0.0));
        };
        match (kind, number.map(|number| number as u32)) {
            (None, Some(0)) => self.change_frame(|frames| zero(&mut frames.external)),
            (Some(2), Some(0)) => self.change_frame(|frames| zero(&mut frames.external)),
            (Some(2), Some(frame @ 1..=6)) => {
                self.set_zero(frame as u16 - 1, setting, zero, words.span(b'P'));
            }
            (Some(20), Some(frame)) if (1..=u32::from(EXTENDED_FRAMES)).contains(&frame) => {
                self.set_zero(STANDARD_FRAMES + frame as u16 - 1, setting, zero, words.span(b'P'));
            }
            (None | Some(1 | 10..=13), Some(number)) => {
                let (geometry, offset) = match (kind, number) {
                    (None, 10_001..) => (true, number - 10_000),
                    (None, _) => (false, number),
                    (Some(kind), _) => (kind == 10 || kind == 12, number),
                };
                if !(1..=u32::from(OFFSETS)).contains(&offset) {
                    self.bad_data(text, request, words, b'P');
                    return;
                }
                self.write_offset(offset as u16, geometry, words);
            }
            (Some(1 | 2 | 10..=13 | 20), _) => self.bad_data(text, request, words, b'P'),
            // Tool life, parameters and other tables: no motion depends on them.
            (Some(_), _) => {
                self.state.data_input = true;
                self.report(Diagnostic::new(said::DataPassedOver, words.span(b'L')));
            }
            (None, None) => self.bad_data(text, request, words, b'P'),
        }
    }

    /// Changes the zero of a frame, given by the words at `span`.
    pub(super) fn set_zero(
        &mut self,
        frame: u16,
        setting: Setting,
        change: impl FnOnce(&mut Point),
        span: Span,
    ) {
        if setting == Setting::Absolute && self.state.frames.is_workpiece_not_given(frame) {
            self.report(Diagnostic::new(said::ZeroTaken, span));
        }
        self.change_frame(|frames| change(frames.work_mut(frame, setting)));
    }

    fn bad_data(&mut self, text: &[u8], request: &mut Request, words: &Words, address: u8) {
        let word = words.get(address).map_or("G10".to_owned(), |word| quote(text, word.span));
        self.report(Diagnostic::new(said::OffsetNumber { word }, words.span(address)));
        request.drop = true;
    }

    fn write_offset(&mut self, offset: u16, geometry: bool, words: &Words) {
        if !self.has(tool_offset::OFFSETS) {
            return;
        }
        let reading = self.reading();
        let length = |address: u8| words.get(address).and_then(|word| reading.length(word));
        let (x, z, radius) = match geometry {
            true => (Column::X, Column::Z, Column::Radius),
            false => (Column::WearX, Column::WearZ, Column::WearRadius),
        };
        let entries = [(x, b'X', b'U'), (z, b'Z', b'W'), (radius, b'R', b'C')];
        for (column, absolute, incremental) in entries {
            if let Some(value) = length(absolute) {
                self.set_offset(offset, column, value, Setting::Absolute);
            } else if let Some(more) = length(incremental) {
                let value = tool_offset::value(&self.state, &self.setup, offset, column) + more;
                self.set_offset(offset, column, value, Setting::Relative);
            }
        }
        if let Some(tip) = words.get(b'Q').and_then(plain) {
            self.set_offset(offset, Column::Tip, tip, Setting::Absolute);
        }
    }
}
