//! Lints for the C axis and live tools: whether they were connected or started, and the program in a virtual
//! plane.

use super::feed::feed_codes;
use super::once::Once;
use super::spindle::block_start;
use crate::control::codes::{Compensation, M, Switch};
use crate::control::events::EventContext;
use crate::control::modal::VirtualPlane;
use crate::control::tool_offset;
use crate::control::words::{Words, quote};
use crate::geometry::virtual_plane::Surface;
use crate::message::{Diagnostic, Fix, Severity, said};
use crate::motion::SpindleTurn;
use crate::setup::dialect::FeedMode;
use crate::source::Span;
use crate::source::shift::Shift;
use crate::text::block::{Block, Word};

/// Least distance to the centre at which C can follow without an extreme speed, mm.
const CENTER: f64 = 0.1;

/// Progress of a sequence that begins with M45, as on the machine of seed 002. On other machines M45 has
/// another meaning, or M03 starts the live tool while C is connected.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Connected {
    /// C is released, or was not connected by M45.
    #[default]
    No,
    /// M45.
    ByCode,
    /// Then C moved.
    Moved,
    /// Then M13 or M14 started a live tool.
    Milled,
}

/// M03 or M04 while C is connected. If C moves again before it is released, the code starts the live tool.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct StartWithC {
    /// The word.
    word: Span,
    /// 3 or 4.
    number: u8,
    /// Where a block before it would be inserted.
    before: u32,
}

/// The state of the lints for C and live tools.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rotary {
    /// Progress of the M45 sequence.
    connected: Connected,
    /// A start of the spindle with C connected that has no explanation yet.
    start: Option<StartWithC>,
    /// Remark: C is not connected.
    c_axis: Once,
    /// Remark: the live tool does not turn.
    live_tool: Once,
    /// Remark: F is per revolution of a spindle that only positions.
    pub feed: Once,
    /// Remark: compensation has no radius.
    radius: Once,
    /// Remark: C looks like an angle.
    angle: Once,
    /// Remark: the path passes the centre.
    center: Once,
}

impl Rotary {
    /// Reports a move of C that is not connected. The M code for this depends on the machine. `unknown_m`: a
    /// code appeared that may have connected it.
    pub fn c_moves(&mut self, span: Span, unknown_m: bool, at: &EventContext) -> Option<Diagnostic> {
        // After M45 a live tool may be started by M03, which does not change C.
        let is_connected = at.state.c_axis || self.connected != Connected::No;
        let is_new = !is_connected && !unknown_m && self.c_axis.mark_reported();
        is_new.then(|| Diagnostic::new(said::CAxisNotConnected, span))
    }

    /// Handles a move of C.
    pub fn c_is_used(&mut self) {
        if self.start.take().is_some() {
            self.connected = Connected::Milled;
        } else if self.connected == Connected::ByCode {
            self.connected = Connected::Moved;
        }
    }

    /// Reports a start of the spindle with C connected if C has not moved since. Called when C is released or
    /// the program ends.
    pub fn report_start_with_c(&mut self) -> Option<Diagnostic> {
        let StartWithC { word, number, before } = self.start.take()?;
        // As written: M3 or M03.
        let digits = word.len().saturating_sub(1);
        let message = said::CAxisStillConnected { word: format!("M{number:0digits$}") };
        let fix = Fix::insert(before, "M46\n".to_owned());
        Some(Diagnostic::new(message, word).with(fix))
    }

    /// First byte of a word that may be reported later.
    pub fn waiting(&self) -> Option<u32> {
        self.start.map(|start| start.before)
    }

    /// Shifts the stored spans after an edit.
    pub fn shift(&mut self, shift: &Shift) {
        self.start = self.start.map(|start| StartWithC {
            word: shift.span(start.word),
            before: shift.byte(start.before),
            ..start
        });
    }

    /// Handles a known M code. Reports M03 and M04 that start the spindle while C holds it.
    pub fn m_code(&mut self, code: M, word: &Word, at: &EventContext) -> Option<Diagnostic> {
        match code {
            M::CAxis(switch) => {
                self.connected = if switch == Switch::On { Connected::ByCode } else { Connected::No };
                return self.report_start_with_c();
            }
            M::LiveTool if self.connected == Connected::Moved => self.connected = Connected::Milled,
            M::Spindle(turn @ (SpindleTurn::Forward | SpindleTurn::Reverse)) => {
                let before = block_start(at.text, word.span.start);
                // The block starts another spindle, such as that of the live tools.
                if chooses_spindle(&at.text[before as usize..]) {
                    return None;
                }
                if std::mem::take(&mut self.connected) == Connected::Milled {
                    let number = if turn == SpindleTurn::Forward { 3 } else { 4 };
                    self.start = Some(StartWithC { word: word.span, number, before });
                }
            }
            _ => {}
        }
        None
    }

    /// Reports a live tool that does not turn while the spindle only positions. The M code that starts it
    /// depends on the machine.
    pub fn mills(&mut self, block: &Block, unknown_m: bool, at: &EventContext) -> Option<Diagnostic> {
        let is_new = !at.state.spindle.live_tool && !unknown_m && self.live_tool.mark_reported();
        is_new.then(|| Diagnostic::new(said::LiveToolStopped, block.words_span()))
    }

    /// Checks a move in the plane of polar interpolation. Returns true if the unit of F was reported as
    /// wrong.
    pub fn face_move(
        &mut self,
        block: &Block,
        words: &Words,
        plane: &VirtualPlane,
        at: &EventContext,
        reports: &mut Vec<Diagnostic>,
    ) -> bool {
        if plane.surface != Surface::Face {
            return false;
        }
        let feed_is_wrong = at.state.feed_mode == FeedMode::PerTurn && self.feed.mark_reported();
        if feed_is_wrong {
            let (per_turn, per_minute) = feed_codes(at);
            reports
                .push(Diagnostic::new(said::PolarFeedPerTurn { per_turn, per_minute }, block.words_span()));
        }
        if at.state.compensation != Compensation::Off
            && at.nose_radius() == 0.0
            && self.radius.mark_reported()
        {
            let span = block.words_span();
            reports.push(match tool_offset::unknown(at.state, at.setup) {
                Some(offset) => {
                    let message = said::PolarRadiusUnknown { offset: u32::from(offset) };
                    Diagnostic::new(message, span).with_severity(Severity::Info)
                }
                None => Diagnostic::new(said::PolarNoRadius, span),
            });
        }
        let reading = at.reading();
        if let Some((word, c)) = words.peek(b'C').and_then(|word| Some((word, reading.length(word)?.abs()))) {
            let x = words.peek(b'X').and_then(|word| reading.radius(word)).unwrap_or(at.state.position.z);
            let like_degrees = c >= 90.0 && c % 90.0 == 0.0 && x.abs() < c / 2.0;
            let outside = at.setup.extents().is_some_and(|stock| c > stock.diameter.mm());
            if (like_degrees || outside) && self.angle.mark_reported() {
                let message = said::PolarAngle { word: quote(at.text, word.span) };
                reports.push(Diagnostic::new(message, word.span));
            }
        }
        feed_is_wrong
    }

    /// Reports a path that passes the centre of the face at `distance`, mm.
    pub fn passes_center(&mut self, distance: f64, words: Span) -> Option<Diagnostic> {
        let is_new = distance < CENTER && self.center.mark_reported();
        is_new.then(|| Diagnostic::new(said::PolarCenter { distance }, words))
    }
}

/// Whether the block at the head of a text chooses the spindle of its M code: `P2`, or `S2=1000`.
fn chooses_spindle(text: &[u8]) -> bool {
    let block = text.iter().take_while(|byte| !matches!(byte, b'\n' | b'\r' | b';'));
    let (mut written, mut in_comment) = (Vec::new(), false);
    for &byte in block {
        match byte {
            b'(' => in_comment = true,
            b')' => in_comment = false,
            _ if in_comment || byte == b' ' => {}
            _ => written.push(byte.to_ascii_uppercase()),
        }
    }
    let is_p = |two: &[u8]| two[0] == b'P' && two[1].is_ascii_digit();
    let is_numbered_s = |three: &[u8]| three[0] == b'S' && three[1].is_ascii_digit() && three[2] == b'=';
    written.windows(2).any(is_p) || written.windows(3).any(is_numbered_s)
}
