//! The C axis and live tools: whether something has connected or started them, and what is
//! programmed in a virtual plane.

use super::once::Once;
use crate::control::codes::Compensation;
use crate::control::events::Moment;
use crate::control::modal::VirtualPlane;
use crate::control::tool_offset;
use crate::control::words::{Words, quote};
use crate::geometry::virtual_plane::Surface;
use crate::message::{Diagnostic, Severity, said};
use crate::setup::dialect::FeedMode;
use crate::source::Span;
use crate::text::block::Block;

/// Nearest to the centre that C can follow without running away, mm.
const CENTER: f64 = 0.1;

/// What was reported of C and of live tools.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rotary {
    /// That C is not connected.
    c_axis: Once,
    /// That the live tool does not turn.
    live_tool: Once,
    /// That F counts a turn of a spindle that only positions.
    pub feed: Once,
    /// That compensation has no radius.
    radius: Once,
    /// That C looks like an angle.
    angle: Once,
    /// That the path passes the centre.
    center: Once,
}

impl Rotary {
    /// C moves though nothing has connected it: which M code does depends on the machine. `unknown_m`:
    /// one appeared that may have.
    pub fn c_moves(&mut self, span: Span, unknown_m: bool, at: &Moment) -> Option<Diagnostic> {
        let is_new = !at.state.c_axis && !unknown_m && self.c_axis.first();
        is_new.then(|| Diagnostic::new(said::CAxisNotConnected, span))
    }

    /// A live tool should turn where the spindle only positions; which M code starts
    /// it depends on the machine.
    pub fn mills(&mut self, block: &Block, unknown_m: bool, at: &Moment) -> Option<Diagnostic> {
        let is_new = !at.state.spindle.live_tool && !unknown_m && self.live_tool.first();
        is_new.then(|| Diagnostic::new(said::LiveToolStopped, block.words_span()))
    }

    /// A move in the plane of polar interpolation. True: the unit of F is reported to be wrong.
    pub fn face_move(
        &mut self,
        block: &Block,
        words: &Words,
        plane: &VirtualPlane,
        at: &Moment,
        reports: &mut Vec<Diagnostic>,
    ) -> bool {
        if plane.surface != Surface::Face {
            return false;
        }
        let feed_is_wrong = at.state.feed_mode == FeedMode::PerTurn && self.feed.first();
        if feed_is_wrong {
            reports.push(Diagnostic::new(said::PolarFeedPerTurn, block.words_span()));
        }
        if at.state.compensation != Compensation::Off && at.nose_radius() == 0.0 && self.radius.first() {
            let span = block.words_span();
            reports.push(match tool_offset::unknown(at.state, at.setup) {
                Some(offset) => {
                    let message = said::PolarRadiusUnknown { offset: u32::from(offset) };
                    Diagnostic::new(message, span).graded(Severity::Info)
                }
                None => Diagnostic::new(said::PolarNoRadius, span),
            });
        }
        let reading = at.reading();
        if let Some((word, c)) = words.get(b'C').and_then(|word| Some((word, reading.length(word)?.abs()))) {
            let x = words.get(b'X').and_then(|word| reading.radius(word)).unwrap_or(at.state.position.z);
            let like_degrees = c >= 90.0 && c % 90.0 == 0.0 && x.abs() < c / 2.0;
            let outside = at.setup.stock.is_some_and(|stock| c > stock.diameter.mm());
            if (like_degrees || outside) && self.angle.first() {
                let message = said::PolarAngle { word: quote(at.text, word.span) };
                reports.push(Diagnostic::new(message, word.span));
            }
        }
        feed_is_wrong
    }

    /// The path passes this near the centre of the face, mm.
    pub fn passes_center(&mut self, distance: f64, words: Span) -> Option<Diagnostic> {
        let is_new = distance < CENTER && self.center.first();
        is_new.then(|| Diagnostic::new(said::PolarCenter { distance }, words))
    }
}
