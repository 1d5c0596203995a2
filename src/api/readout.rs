//! The playback readout beside the picture: where the tool is, how it cuts, and when.
//!
//! In: a position in the program. Out: a [`Readout`] with numbers only, in user units.

use serde::Serialize;

use super::{Places, Stroke, rounded, tool_name};
use crate::geometry::Point;
use crate::geometry::virtual_plane::VirtualMove;
use crate::machine::resolved_setup::{Basis, ResolvedSetup};
use crate::motion::{Feed, Motion, MotionKind, Motions, SpindleTurn, StopKind};
use crate::playback::clock::{Clock, Playhead};
use crate::playback::holds::stop_at;
use crate::playback::timing::{self, Total};
use crate::sentences::{Language, labels};
use crate::setup::ToolKind;
use crate::units::Unit;

#[cfg(target_arch = "wasm32")]
use tsify::Tsify;

/// The tool at a position in the program.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
#[serde(rename_all = "camelCase")]
pub struct Readout {
    /// Progress of the animation, 0 to 1.
    pub share: f64,
    /// The current stroke and the tool position on it.
    pub stroke: Stroke,
    /// Angle of C, degrees, for motions in which C takes part.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub c: Option<f64>,
    /// Y, mm, for moves on a machine with a Y axis.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub y: Option<f64>,
    /// Feed along the path, mm/min; omitted at rapid, or if it is unknown.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub feed: Option<f64>,
    /// Programmed feed or lead, mm/rev.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub feed_per_turn: Option<f64>,
    /// Whether a thread is being cut: feed override is fixed at 100 %, and feed hold is delayed.
    pub locked: bool,
    /// Spindle speed, rpm; 0 if stopped, omitted if it is unknown.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub rpm: Option<f64>,
    /// Cutting speed at the tip, m/min; omitted if the motion does not cut.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub surface_speed: Option<f64>,
    /// The elapsed time.
    pub elapsed: Time,
    /// The time of the whole program.
    pub total: Time,
    /// The current T word, such as `T0101`; omitted before the first one.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub tool: Option<String>,
    /// The kind of tool, as text.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub tool_kind: Option<&'static str>,
    /// Whether the kind of tool was inferred from the program rather than given.
    pub tool_inferred: bool,
    /// The stop at which the tool is.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub stop: Option<Stop>,
}

/// The duration of motions, as far as it is known.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
#[serde(rename_all = "camelCase")]
pub struct Time {
    /// Seconds of the motions with a known duration.
    pub seconds: f64,
    /// Number of cuts with an unknown duration.
    pub unknown_cuts: u32,
    /// Number of rapids with an unknown duration.
    pub unknown_rapids: u32,
    /// Seconds of those rapids at the assumed rate, 8000 mm/min.
    pub assumed_seconds: f64,
}

/// A stop: the program waits for the operator.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct Stop {
    /// Whether the stop is optional.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "\"always\" | \"optional\""))]
    pub kind: &'static str,
    /// Its code: `M00` or `M01`.
    pub code: &'static str,
    /// Line of its block, from 1.
    pub line: u32,
    /// UTF-16 offset of the start of its block.
    pub from: u32,
    /// UTF-16 offset of the end of its block.
    pub to: u32,
}

/// The input for a readout.
pub struct Shown<'a> {
    /// The text.
    pub places: Places<'a>,
    /// The motions.
    pub motions: &'a Motions,
    /// The clock of the motions.
    pub clock: &'a Clock,
    /// The unit in which lengths are shown.
    pub unit: Unit,
    /// The tools; `None` before the run has ended.
    pub resolved: Option<&'a ResolvedSetup>,
}

impl Readout {
    /// The readout at a position in the program, with the tip at `at` on the workpiece.
    pub fn new(shown: &Shown, playhead: Playhead, at: Point, language: Language) -> Self {
        let Shown { places, motions, clock, unit, resolved } = shown;
        let motion = motions.get(playhead.motion);
        let radius = at.x - motion.process.zero.x;
        let (reading, whole) = (clock.at(motions, playhead), clock.total());
        let machine = clock.machine();
        let rpm = timing::speed_at(&motion.process, machine, radius);
        let own = motion.rotary.and(motion.first_part(playhead.share).rotary);
        let y = motion.virtual_move().filter(VirtualMove::has_y).map(|own| own.y_at(playhead.share));
        let resolved_tool = resolved.map(|resolved| resolved.tool(&motion));
        Self {
            share: if whole.animation_seconds > 0.0 {
                reading.animation_seconds / whole.animation_seconds
            } else {
                playhead.share
            },
            stroke: places.stroke(motions, playhead.motion, at, *unit, language),
            c: own.filter(|own| y.is_none() || own.from != own.to).map(|own| rounded(own.to)),
            y: y.map(rounded),
            feed: timing::feed_at(&motion, machine, radius).map(rounded),
            feed_per_turn: per_turn(&motion).map(rounded),
            locked: motion.kind == MotionKind::Thread,
            rpm: if motion.process.turn != SpindleTurn::Stopped { rpm.map(rounded) } else { Some(0.0) },
            surface_speed: rpm
                .filter(|_| motion.kind.cuts())
                .map(|rpm| rounded(timing::surface_speed(rpm, radius))),
            elapsed: Time::new(&reading.time),
            total: Time::new(&whole.time),
            tool: tool_name(motion.process.tool),
            tool_kind: resolved_tool.map(|resolved_tool| {
                labels::tool_kind(resolved_tool.tool.kind.unwrap_or(ToolKind::Turning), language)
            }),
            tool_inferred: resolved_tool.is_some_and(|resolved_tool| {
                resolved_tool.basis != Basis::Given || resolved_tool.tool.kind.is_none()
            }),
            stop: stop_at(motions, playhead).map(|stop| {
                let (from, to) = places.offsets(stop.span);
                let kind = match stop.kind {
                    StopKind::Always => "always",
                    StopKind::Optional => "optional",
                };
                Stop { kind, code: stop.kind.code(), line: stop.line + 1, from, to }
            }),
        }
    }
}

impl Time {
    fn new(total: &Total) -> Self {
        Self {
            seconds: rounded(total.known),
            unknown_cuts: total.unknown_cuts,
            unknown_rapids: total.unknown_rapids,
            assumed_seconds: rounded(total.assumed),
        }
    }
}

/// The programmed feed per revolution of a cut.
fn per_turn(motion: &Motion) -> Option<f64> {
    match (motion.kind, motion.process.feed) {
        (MotionKind::Rapid | MotionKind::Dwell, _) => None,
        (MotionKind::Thread, _) => motion.lead.map(f64::abs),
        (_, Feed::PerTurn(feed)) => Some(feed),
        (_, Feed::PerMinute(_) | Feed::Unset) => None,
    }
}
