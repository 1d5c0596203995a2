//! Moves that a block programs directly: G00, G01, G02, G03, G32.
//!
//! In: the words of a block. Out: motions. Handles corner words and angles, too.

use super::repairs::offer_other_sign;
use super::request::Request;
use super::{AXES, Interpreter};
use crate::control::arcs::{self, CenterWords};
use crate::control::codes::{Compensation, MotionMode, Plane};
use crate::control::events::{Event, ThreadPass, ThreadSource};
use crate::control::modal::{PathMove, Target};
use crate::control::words::{self, Words, letters, quote};
use crate::cycles::single::Single;
use crate::geometry::virtual_plane::{Flat, Surface};
use crate::geometry::{Point, SAME, Turn};
use crate::message::{Diagnostic, Edit, Fix, Message, Repair, Severity, said};
use crate::motion::{Motion, MotionKind};
use crate::setup::dialect::{Control, NegativeArcR};
use crate::text::block::Block;

impl Interpreter {
    /// G01, with its corner and angle words.
    pub(super) fn line(&mut self, text: &[u8], block: &Block, request: &mut Request, words: &Words) {
        let (x, z) = self.plane_targets(text, words);
        let angle = self.angle(text, block, request, words);
        let c = self.turn_target(text, words);
        if c.is_none() && angle.is_none() && !words.has_any(AXES) && self.state.virtual_plane.is_none() {
            // A chamfer word without axis words.
            if self.joint(text, block, request, words).is_err() {
                request.drop = true;
            }
            return;
        }
        request.moved = angle.is_some() || words.has_any(AXES) || self.state.virtual_plane.is_some();
        let absolute = |target: Target| match target {
            Target::Absolute(place) => Some(place),
            Target::Stay | Target::Incremental(_) => None,
        };
        let was_open = self.state.pending.as_ref().is_some_and(|pending| pending.angle.is_some());
        if was_open && !self.close_angle(absolute(x), absolute(z), angle.as_ref().map(|angle| angle.radians))
        {
            request.drop = true;
            return;
        }
        if !self.may_cut(text, block, words, request) {
            return;
        }
        let Ok(joint) = self.joint(text, block, request, words) else {
            request.drop = true;
            return;
        };
        if let Some(angle) =
            angle.as_ref().filter(|_| self.state.plane != Plane::Zx || self.state.virtual_plane.is_some())
        {
            let message = said::CyclePlane { code: ",A", alarm: "PS0212" };
            self.report(Diagnostic::new(message, angle.span));
            request.drop = true;
            return;
        }
        let from = self.state.position;
        let named = |target: Target, from: f64| match target {
            Target::Stay => None,
            target => Some(target.from(from)),
        };
        let to = match angle {
            Some(angle) if x == Target::Stay && z == Target::Stay => {
                self.push_at_angle(block, angle, joint);
                return;
            }
            Some(angle) if !was_open => {
                match self.end_by_angle(angle.radians, named(x, from.x), named(z, from.z)) {
                    Ok(to) => to,
                    Err(fault) => {
                        let alarm = fault.alarm().unwrap_or("PS0057");
                        let message = said::AngleNoPoint { word: angle.word, alarm };
                        self.report(Diagnostic::new(message, angle.span));
                        request.drop = true;
                        return;
                    }
                }
            }
            _ => Point::new(x.from(from.x), z.from(from.z)),
        };
        if self.state.compensation != Compensation::Off {
            self.observe(text, Event::CompensatedLine { block, to });
        }
        if self.is_on_axis() && self.state.virtual_plane.is_none() {
            self.observe(text, Event::FromAxis { block, to });
        }
        if joint.is_none() && c.is_none() && self.push_fast(block, MotionKind::Feed, to, None) {
            return;
        }
        let motion = self.motion(MotionKind::Feed, to);
        let motion = self.turning(motion, c);
        self.push_path_move(PathMove { wall: request.wall, ..self.path_move(block, motion) }, joint);
    }

    /// Checks that a thread has no corner words (PS0050). False: an error was reported.
    fn no_corner_in_thread(&mut self, text: &[u8], block: &Block, request: &Request, words: &Words) -> bool {
        let comma = request.comma.into_iter().flatten().next().map(|index| &block.words[index]);
        let plain_word = [b'C', b'R'].into_iter().find_map(|address| words.get(address));
        let Some(word) = comma.or(plain_word.filter(|_| !self.state.c_axis)) else { return true };
        let message = said::CornerInThread { word: quote(text, word.span) };
        self.report(Diagnostic::new(message, word.span).with(Fix::delete(text, word.span)));
        false
    }

    pub(super) fn arc(
        &mut self,
        text: &[u8],
        block: &Block,
        request: &mut Request,
        words: &Words,
        turn: Turn,
    ) {
        let surface = self.state.virtual_plane.map(|plane| plane.surface);
        let reading = self.reading();
        let code = if turn == Turn::Clockwise { "G02" } else { "G03" };
        let given = |address: u8| words.get(address).and_then(|word| reading.length(word));
        // The addresses of the centre along the second, the first and the third axis of the plane.
        let (up, right, third) = match surface {
            None | Some(Surface::Flat(Flat::Zx)) => (b'I', b'K', b'J'),
            Some(Surface::Face | Surface::Flat(Flat::Xy)) => (b'J', b'I', b'K'),
            Some(Surface::Flat(Flat::Yz)) => (b'K', b'J', b'I'),
            Some(Surface::Cylinder { .. }) => {
                if let Some(address) = [b'I', b'J', b'K'].into_iter().find(|&word| words.peek(word).is_some())
                {
                    let word = words.quote(text, address);
                    self.report(Diagnostic::new(said::CylinderForbidden { word }, words.span(address)));
                    request.drop = true;
                    return;
                }
                (b'J', b'K', b'I')
            }
        };
        let turn = match surface {
            Some(Surface::Cylinder { turned: true, .. }) => turn.opposite(),
            _ => turn,
        };
        let [first, second] = [up.min(right), up.max(right)].map(char::from);
        // With R, the words of the centre are not read.
        let radius = given(b'R');
        let of_centre = |address: u8| if radius.is_none() { given(address) } else { None };
        let stray = of_centre(third).filter(|&way| way != 0.0).map(|_| {
            let word = words.quote(text, third);
            Diagnostic::new(said::CenterOutsidePlane { word, first, second }, words.span(third))
        });
        let center_words = match (radius, of_centre(up), of_centre(right)) {
            (Some(radius), ..) => CenterWords::Radius(radius),
            (None, None, None) => {
                let alarm = self.dialect.strict || self.dialect.control == Control::Gsk;
                let severity = if alarm { Severity::Error } else { Severity::Warning };
                let no_center =
                    || Diagnostic::new(said::ArcNoCenter { code, first, second }, block.words_span());
                self.report(stray.unwrap_or_else(no_center).with_severity(severity));
                if alarm {
                    request.drop = true;
                } else {
                    // FANUC goes there in a straight line unless parameter 3403#5 selects the alarm.
                    self.line(text, block, request, words);
                }
                return;
            }
            (None, i, k) => CenterWords::Offset { i: i.unwrap_or(0.0), k: k.unwrap_or(0.0) },
        };
        if let CenterWords::Radius(radius) = center_words
            && radius < 0.0
            && self.dialect.negative_arc_r == NegativeArcR::Alarm
        {
            let (span, word) = (words.span(b'R'), words.quote(text, b'R'));
            let diagnostic = Diagnostic::new(said::ArcRadiusNegative { word }, span);
            self.report(offer_other_sign(diagnostic, text, span));
            request.drop = true;
            return;
        }
        if let CenterWords::Radius(radius) = center_words
            && radius < 0.0
            && surface.is_none()
        {
            let word = words.quote(text, b'R');
            let span = words.span(b'R');
            let fix =
                Fix::write(span, format!("R{}", words::after_letter(&word).trim_start_matches([' ', '-'])));
            self.report(Diagnostic::new(said::ArcOverHalf { word }, span).with(fix));
        }
        let of_center = [up, right];
        let (up, right) = self.plane_targets(text, words);
        let to = Point::new(up.from(self.state.position.x), right.from(self.state.position.z));
        if !self.may_cut(text, block, words, request) {
            return;
        }
        self.flush_open_angle();
        let Ok(joint) = self.joint(text, block, request, words) else {
            request.drop = true;
            return;
        };
        request.moved = true;
        let (kind, from) = match turn {
            Turn::Clockwise => (MotionKind::ArcClockwise, self.state.position),
            Turn::Counterclockwise => (MotionKind::ArcCounterclockwise, self.state.position),
        };
        match arcs::center(from, to, turn, center_words) {
            Ok(Some(center)) => {
                if let Some(stray) = stray {
                    self.report(stray);
                }
                if joint.is_none() && self.push_fast(block, kind, to, Some(center)) {
                    return;
                }
                let motion = Motion { center: Some(center), ..self.motion(kind, to) };
                self.push_path_move(self.path_move(block, motion), joint);
            }
            // It goes along Y, which was reported.
            Ok(None) if words.has_any(letters(b"YV")) && surface.is_none() => {}
            Ok(None) => self.report(Diagnostic::new(said::ArcNowhere, block.words_span())),
            // The arc may begin elsewhere: an earlier block was not carried out, which was reported.
            Err(_) if self.state.is_path_doubtful() => request.drop = true,
            Err(fault) => {
                let message: Message = match fault {
                    arcs::ArcError::RadiusTooSmall { distance } => {
                        let word = words.quote(text, b'R');
                        said::ArcRadiusTooSmall { word, distance, least: distance / 2.0 }.into()
                    }
                    arcs::ArcError::EndOffCircle { start_radius: 0.0, .. } => said::ArcNoRadius.into(),
                    arcs::ArcError::EndOffCircle { start_radius, end_radius } => {
                        said::ArcEndOffCircle { start_radius, end_radius }.into()
                    }
                };
                let mut diagnostic = Diagnostic::new(message, block.words_span());
                if let CenterWords::Offset { i, k } = center_words {
                    let meets = |i: f64, k: f64| {
                        matches!(arcs::center(from, to, turn, CenterWords::Offset { i, k }), Ok(Some(_)))
                    };
                    diagnostic.fixes.extend(center_repair(text, words, of_center, [i, k], meets));
                }
                // One error, one message.
                self.report(stray.map_or(diagnostic, |stray| stray.with_severity(Severity::Error)));
                request.drop = true;
            }
        }
    }

    /// G32: one thread cut. G34: one with a variable lead. G33 on GSK: in and out again (seeds 001 and 002,
    /// GSK980TDb p. 122).
    #[inline(never)]
    pub(super) fn thread(&mut self, text: &[u8], block: &Block, request: &mut Request, words: &Words) {
        let code = match self.state.motion {
            MotionMode::VariableThread => "G34",
            MotionMode::Tapping => "G33",
            _ => "G32",
        };
        let to = self.target(text, words);
        let Some(lead) = self.lead(text, block, words, code) else {
            request.drop = true;
            return;
        };
        self.leave_compensation();
        self.observe(text, Event::Thread { block, code, to: Some(to) });
        if !self.has_whole_angle(text, words) || !self.no_corner_in_thread(text, block, request, words) {
            request.drop = true;
            return;
        }
        let reading = self.reading();
        let given = |address: u8| words.get(address).and_then(|word| reading.length(word));
        let from = self.state.position;
        let starts = self.starts(words, Single::Threading);
        let pass = ThreadPass { block, words, start: from, end: to, lead, starts, by: ThreadSource::Move };
        self.observe(text, Event::ThreadMove { pass, code });
        let gsk = self.dialect.control == Control::Gsk;
        let is_variable = self.state.motion == MotionMode::VariableThread;
        let j = if gsk { given(b'J') } else { None };
        let k = if gsk || is_variable { given(b'K') } else { None };
        let ends = match (self.state.motion, j, k) {
            (MotionMode::Tapping, ..) => [Some(to), Some(from)],
            (MotionMode::VariableThread, _, change) => {
                let length = (to.z - from.z).abs().max((to.x - from.x).abs());
                let reached = lead_ends(lead, change.unwrap_or(0.0));
                if let Some(reached) = reached.filter(|&reached| reached <= length + SAME) {
                    // In hundredths of a millimetre, the usual precision of measurement.
                    let reached = (100.0 * reached).round() / 100.0;
                    let message = said::LeadRunsOut { word: words.quote(text, b'K'), reached, length };
                    self.report(Diagnostic::new(message, words.span(b'K')));
                    request.drop = true;
                    return;
                }
                [Some(to), None]
            }
            (_, j, k) if gsk && (j.is_some() || k.is_some()) => {
                let (out, along) = (j.or(k).unwrap_or(0.0), k.or(j).unwrap_or(0.0));
                gsk_pull_out(from, to, out, along)
            }
            _ => [Some(to), None],
        };
        let lead_change = k.filter(|_| is_variable);
        let mut start_angle = self.start_angle(words);
        for end in ends.into_iter().flatten() {
            let motion = self.motion(MotionKind::Thread, end);
            self.push(block, Motion { lead: Some(lead), lead_change, start_angle, ..motion });
            start_angle = 0.0;
        }
    }

    /// G00.
    #[inline]
    pub(super) fn rapid(&mut self, text: &[u8], block: &Block, request: &mut Request, words: &Words) {
        self.flush_open_angle();
        if let Some(index) = request.comma.into_iter().flatten().next() {
            let span = block.words[index].span;
            self.report(Diagnostic::new(said::CornerNoLine { word: quote(text, span) }, span));
            request.drop = true;
            return;
        }
        let (x, z) = self.plane_targets(text, words);
        let to = Point::new(x.from(self.state.position.x), z.from(self.state.position.z));
        self.observe(text, Event::Rapid);
        if self.is_on_axis() && self.state.virtual_plane.is_none() {
            self.observe(text, Event::FromAxis { block, to });
        }
        request.moved = words.has_any(AXES);
        let c = self.turn_target(text, words);
        if c.is_some() || !self.push_fast(block, MotionKind::Rapid, to, None) {
            let motion = self.motion(MotionKind::Rapid, to);
            let motion = self.turning(motion, c);
            self.push_path_move(PathMove { wall: request.wall, ..self.path_move(block, motion) }, None);
        }
    }
}

/// A fix that changes signs of the words of the centre, if exactly one change leads to the end. `meets`:
/// whether these distances lead there.
#[cold]
#[inline(never)]
fn center_repair(
    text: &[u8],
    words: &Words,
    [first, second]: [u8; 2],
    [i, k]: [f64; 2],
    meets: impl Fn(f64, f64) -> bool,
) -> Option<Fix> {
    let turned = |letter: u8| {
        let word = words.get(letter)?;
        Some(Edit { span: word.span, text: words::with_other_sign(&quote(text, word.span)) })
    };
    let (mut edits, title) = match [i != 0.0 && meets(-i, k), k != 0.0 && meets(i, -k)] {
        [true, false] => (vec![turned(first)?], None),
        [false, true] => (vec![turned(second)?], None),
        [false, false] if i != 0.0 && k != 0.0 && meets(-i, -k) => {
            let (one, other) = (turned(first)?, turned(second)?);
            let title = format!("{} {}", one.text, other.text);
            (vec![one, other], Some(title))
        }
        _ => return None,
    };
    if edits[0].span.start > edits[edits.len() - 1].span.start {
        edits.reverse();
    }
    let title = title.unwrap_or_else(|| edits[0].text.clone());
    Some(Fix { title: Repair::Write { text: title }, safe: false, edits })
}

/// Pull-out of GSK's G32: K along the long axis (unsigned), J along the short one (signed, a radius for X).
fn gsk_pull_out(from: Point, to: Point, out: f64, along: f64) -> [Option<Point>; 2] {
    let (way_x, way_z) = (to.x - from.x, to.z - from.z);
    let long = way_x.abs().max(way_z.abs());
    if long == 0.0 {
        return [Some(to), None];
    }
    let part = (along.abs() / long).min(1.0);
    let leave = Point::new(to.x - part * way_x, to.z - part * way_z);
    let end = if way_z.abs() >= way_x.abs() {
        Point::new(leave.x + out, to.z)
    } else {
        Point::new(to.x, leave.z + out)
    };
    [Some(leave), Some(end)]
}

/// Length, mm, that a G34 can cut until its lead is zero: n turns make a thread of F·n + K·n²/2, and the lead
/// is zero after F/−K turns. `None` if the lead does not decrease.
fn lead_ends(lead: f64, change: f64) -> Option<f64> {
    (change < 0.0).then(|| lead * lead / (-2.0 * change))
}
