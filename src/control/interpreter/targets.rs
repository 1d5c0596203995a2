//! The words of a block as targets of a move: axes, leads, angles. In millimetres and radii.

use super::request::Request;
use super::{Interpreter, TURNS};
use crate::control::codes::MotionMode;
use crate::control::events::Event;
use crate::control::modal::{Angle, Lead, Target};
use crate::control::words::{Counts, Words, plain, quote};
use crate::geometry::virtual_plane::{Flat, Surface};
use crate::geometry::{Point, SAME};
use crate::message::{Diagnostic, Fix, said};
use crate::setup::dialect::{DecimalRule, IInG92, PolarX, XuConflict};
use crate::source::Span;
use crate::text::block::{Block, Value, Word};

impl Interpreter {
    /// The end point given by X, U, Z and W.
    #[inline]
    pub(super) fn target(&mut self, text: &[u8], words: &Words) -> Point {
        let from = self.state.position;
        let x = self.axis(text, words, b'X', b'U', Counts::Diameter);
        let z = self.axis(text, words, b'Z', b'W', Counts::Length);
        Point::new(x.from(from.x), z.from(from.z))
    }

    /// The target given by the absolute and the incremental word of an axis.
    #[inline]
    pub(super) fn axis(
        &mut self,
        text: &[u8],
        words: &Words,
        absolute: u8,
        incremental: u8,
        counts: Counts,
    ) -> Target {
        let reading = self.reading();
        let (a, i) = (words.get(absolute), words.get(incremental));
        let value = |word: &Word| reading.coordinate(word, counts).unwrap_or(0.0);
        match (a, i) {
            (Some(a), None) if self.state.incremental => Target::Incremental(value(a)),
            (Some(a), None) => Target::Absolute(value(a)),
            (None, Some(i)) => Target::Incremental(value(i)),
            (None, None) => Target::Stay,
            (Some(a), Some(i)) => self.conflict(text, a, i, counts),
        }
    }

    /// X with U, or Z with W: reports it and returns the effective target.
    #[cold]
    fn conflict(&mut self, text: &[u8], a: &Word, i: &Word, counts: Counts) -> Target {
        let reading = self.reading();
        let value = |word: &Word| reading.coordinate(word, counts).unwrap_or(0.0);
        match self.absolute_counts(text, a, i) {
            true => Target::Absolute(value(a)),
            false => Target::Incremental(value(i)),
        }
    }

    /// Reports an absolute and an incremental word of one axis in a block. Returns whether the absolute one
    /// takes effect.
    #[cold]
    fn absolute_counts(&mut self, text: &[u8], a: &Word, i: &Word) -> bool {
        let absolute_counts = match self.dialect.xu_conflict {
            XuConflict::Absolute => true,
            XuConflict::Last => a.span.start > i.span.start,
        };
        let (absolute, incremental) = (quote(text, a.span), quote(text, i.span));
        let used = if absolute_counts { absolute.clone() } else { incremental.clone() };
        let span = a.span.to(i.span);
        let mut fixes = [i.span, a.span].map(|span| Fix::delete(text, span));
        if !absolute_counts {
            fixes.reverse();
        }
        let diagnostic = Diagnostic::new(said::AbsoluteAndIncremental { absolute, incremental, used }, span);
        self.report(Diagnostic { fixes: fixes.into(), ..diagnostic });
        absolute_counts
    }

    /// Whether the tip is on the spindle axis.
    #[inline]
    pub(super) fn is_on_axis(&self) -> bool {
        self.state.position.x.abs() <= SAME
    }

    /// The angle word of a straight move: `,A` or A, degrees.
    pub(super) fn angle(
        &self,
        text: &[u8],
        block: &Block,
        request: &Request,
        words: &Words,
    ) -> Option<Angle> {
        let word = request.comma[2].map(|index| &block.words[index]).or_else(|| words.get(b'A'))?;
        let Value::Number { number, .. } = word.value else { return None };
        // Without a point under the least-increment rule the unit of an angle is 0.001°.
        let fine = self.dialect.decimal == DecimalRule::LeastIncrement && !number.has_point();
        let degrees = if fine { plain(word)? / 1000.0 } else { plain(word)? };
        Some(Angle { radians: degrees.to_radians(), span: word.span, word: quote(text, word.span) })
    }

    /// The lead of a thread, mm.
    pub(super) fn lead(
        &mut self,
        text: &[u8],
        block: &Block,
        words: &Words,
        code: &'static str,
    ) -> Option<f64> {
        let reading = self.reading();
        if self.dialect.i_in_g92 == IInG92::Tpi
            && let Some(threads) = words.get(b'I').and_then(plain).filter(|&threads| threads > 0.0)
        {
            self.state.lead = Some(Lead::ThreadsPerInch(threads));
        }
        if let Some(lead) = words.get(b'E').and_then(|word| reading.feed(word)) {
            self.state.lead = Some(Lead::ByE(lead));
        }
        let own = self.state.lead.map(Lead::mm);
        let lead = own.or(self.state.feed).filter(|&lead| lead > 0.0);
        match lead {
            None => self.report(Diagnostic::new(said::LeadMissing { code }, block.words_span())),
            Some(feed) if own.is_none() => {
                self.observe(text, Event::LeadOfFeed { block, code, feed });
            }
            Some(_) => {}
        }
        lead
    }

    /// C moves: from here on C words are an axis, not a chamfer.
    pub(super) fn connect_c(&mut self, text: &[u8], span: Span) {
        self.observe(text, Event::CAxis { span });
        self.state.c_axis = true;
    }

    /// The target angle of C and H outside a virtual plane, degrees; `None` if C does not move.
    pub(super) fn turn_target(&mut self, text: &[u8], words: &Words) -> Option<f64> {
        if !words.has_any(TURNS) || self.state.virtual_plane.is_some() {
            return None;
        }
        let is_axis =
            self.state.c_axis || self.state.motion == MotionMode::Rapid || words.peek(b'H').is_some();
        if !is_axis {
            return None;
        }
        let (reading, from) = (self.reading(), self.state.c);
        let (c, h) = match (words.get(b'C'), words.get(b'H')) {
            (Some(c), Some(h)) if self.absolute_counts(text, c, h) => (Some(c), None),
            (Some(_), Some(h)) => (None, Some(h)),
            one => one,
        };
        let absolute = c.and_then(|word| reading.degrees(word));
        let turned = h.and_then(|word| reading.degrees(word));
        let span = words.span(if absolute.is_some() { b'C' } else { b'H' });
        self.connect_c(&[], span);
        match (absolute, turned) {
            (Some(way), _) if self.state.incremental => Some(from + way),
            (absolute, turned) => absolute.or(turned.map(|turned| from + turned)),
        }
    }

    /// The targets along the two axes of the path, upwards and to the right, from X, Z, C and their
    /// incremental words.
    pub(super) fn plane_targets(&mut self, text: &[u8], words: &Words) -> (Target, Target) {
        let Some(plane) = self.state.virtual_plane else {
            let x = self.axis(text, words, b'X', b'U', Counts::Diameter);
            return (x, self.axis(text, words, b'Z', b'W', Counts::Length));
        };
        let (up, right, third) = match plane.surface {
            Surface::Face => {
                let x_counts = match self.dialect.polar_x {
                    PolarX::Diameter => Counts::Diameter,
                    PolarX::Radius => Counts::Length,
                };
                let up = self.axis(text, words, b'C', b'H', Counts::Length);
                let right = self.axis(text, words, b'X', b'U', x_counts);
                (up, right, self.axis(text, words, b'Z', b'W', Counts::Length))
            }
            Surface::Cylinder { radius, .. } => {
                let reading = self.reading();
                let unrolled = |word: &Word| reading.degrees(word).map(|angle| radius * angle.to_radians());
                let up = match (words.get(b'C'), words.get(b'H')) {
                    (Some(c), _) if self.state.incremental => Target::Incremental(unrolled(c).unwrap_or(0.0)),
                    (Some(c), _) => Target::Absolute(unrolled(c).unwrap_or(0.0)),
                    (None, Some(h)) => Target::Incremental(unrolled(h).unwrap_or(0.0)),
                    (None, None) => Target::Stay,
                };
                let right = self.axis(text, words, b'Z', b'W', Counts::Length);
                (up, right, self.axis(text, words, b'X', b'U', Counts::Diameter))
            }
            Surface::Flat(flat) => {
                let x = self.axis(text, words, b'X', b'U', Counts::Diameter);
                let y = self.axis(text, words, b'Y', b'V', Counts::Length);
                let z = self.axis(text, words, b'Z', b'W', Counts::Length);
                match flat {
                    Flat::Xy => (y, x, z),
                    Flat::Zx => (x, z, y),
                    Flat::Yz => (z, y, x),
                }
            }
        };
        if let Some(plane) = &mut self.state.virtual_plane {
            let from = plane.third.1;
            plane.third = (from, third.from(from));
        }
        (up, right)
    }
}
