//! What the playback shows beside the picture: where the tool is, how it cuts, and when.
//!
//! In: a place of the program. Out: a [`Readout`], numbers only, in the units people read.

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

/// The tool at a place of the program.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
#[serde(rename_all = "camelCase")]
pub struct Readout {
    /// How much of the animation has been shown: 0 to 1.
    pub share: f64,
    /// The stroke the tool is on, and where.
    pub stroke: Stroke,
    /// Angle of C, degrees, of motions it takes part in.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub c: Option<f64>,
    /// Place along Y, mm, of moves on a machine with a Y axis.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub y: Option<f64>,
    /// Feed along the path, mm/min; left out at rapid, or where it cannot be known.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub feed: Option<f64>,
    /// Feed or lead as it is programmed, mm/rev.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub feed_per_turn: Option<f64>,
    /// A thread is cut: feed override counts as 100 %, and feed hold waits.
    pub locked: bool,
    /// Spindle speed, rpm; 0 while it stands, left out where it cannot be known.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub rpm: Option<f64>,
    /// Cutting speed at the tip, m a minute.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub surface_speed: Option<f64>,
    /// The time so far.
    pub elapsed: Time,
    /// The time of the whole program.
    pub total: Time,
    /// The T word in force, such as `T0101`; left out before the first one.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub tool: Option<String>,
    /// What kind of tool it is, in words.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub tool_kind: Option<&'static str>,
    /// Nobody has said so: it is concluded from what the program does with it.
    pub tool_inferred: bool,
    /// The stop of the program at which the tool stands.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub stop: Option<Stop>,
}

/// The time of motions, as far as it is known.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
#[serde(rename_all = "camelCase")]
pub struct Time {
    /// Seconds of the motions whose time is known.
    pub seconds: f64,
    /// Cuts whose time is not known.
    pub unknown_cuts: u32,
    /// Rapids whose time is not known.
    pub unknown_rapids: u32,
}

/// The program waits for the operator.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct Stop {
    /// Whether the switch for optional stops lets the program run through it.
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

/// What a readout is made from.
pub struct Shown<'a> {
    /// The text.
    pub places: Places<'a>,
    /// The motions.
    pub motions: &'a Motions,
    /// Their clock.
    pub clock: &'a Clock,
    /// The unit lengths are shown in.
    pub unit: Unit,
    /// The tools; nothing before the run has ended.
    pub resolved: Option<&'a ResolvedSetup>,
}

impl Readout {
    /// The readout at a place of the program, where the tip is at `at` on the workpiece.
    pub fn new(shown: &Shown, playhead: Playhead, at: Point, language: Language) -> Self {
        let Shown { places, motions, clock, unit, resolved } = shown;
        let motion = motions.get(playhead.motion);
        let radius = at.x - motion.process.zero.x;
        let (reading, whole) = (clock.at(motions, playhead), clock.whole());
        let machine = clock.machine();
        let rpm = timing::speed_at(&motion.process, machine, radius);
        let own = motion.rotary.and(motion.first_part(playhead.share).rotary);
        let y = motion.virtual_move().filter(VirtualMove::has_y).map(|own| own.y_at(playhead.share));
        let resolved_tool = resolved.map(|resolved| resolved.tool(&motion));
        Self {
            share: if whole.pace > 0.0 { reading.pace / whole.pace } else { playhead.share },
            stroke: places.stroke(motions, playhead.motion, at, *unit, language),
            c: own.filter(|own| y.is_none() || own.from != own.to).map(|own| rounded(own.to)),
            y: y.map(rounded),
            feed: timing::feed_at(&motion, machine, radius).map(rounded),
            feed_per_turn: per_turn(&motion).map(rounded),
            locked: motion.kind == MotionKind::Thread,
            rpm: if motion.process.turn != SpindleTurn::Stopped { rpm.map(rounded) } else { Some(0.0) },
            surface_speed: rpm.map(|rpm| rounded(timing::surface_speed(rpm, radius))),
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
        }
    }
}

/// The feed of a cut as the program gives it a turn.
fn per_turn(motion: &Motion) -> Option<f64> {
    match (motion.kind, motion.process.feed) {
        (MotionKind::Rapid | MotionKind::Dwell, _) => None,
        (MotionKind::Thread, _) => motion.lead.map(f64::abs),
        (_, Feed::PerTurn(feed)) => Some(feed),
        (_, Feed::PerMinute(_) | Feed::Unset) => None,
    }
}
