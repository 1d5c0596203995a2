//! Messages about the machining.
//!
//! In: the findings of the simulation, the severity levels of the setup. Out: messages at the blocks that
//! made the motions, one for each block and danger, because a cycle repeats a collision in every pass.

use crate::geometry::SAME;
use crate::limits::INFERRED_FROM;
use crate::machine::danger::{Axis, Danger, Finding};
use crate::machine::live_holes::goes_into_side;
use crate::machine::removal::{Removal, Unusual};
use crate::machine::resolved_setup::{Basis, ResolvedSetup};
use crate::machine::thread_run_out::ShortRunOut;
use crate::machine::turned_material::rapids_into_material;
use crate::machine::{SimulationLimit, SimulationResult};
use crate::message::{Diagnostic, Levels, Message, Severity, said};
use crate::motion::{Feed, Motions, Process, SpindleSpeed};
use crate::setup::stock::ONE_PASS_FEED;
use crate::setup::{Side, ToolKind, tool_word};
use crate::source::Span;
use crate::units::Diameter;

/// How far a tool in a bore may run out behind the back of the blank, mm.
const RUN_OUT_INSIDE: f64 = 15.0;

/// How many findings are checked for being about the next part; each check scans all motions.
const MAX_COMPARED: usize = 50;

/// The messages about all findings, about a limit that was reached, and about skipped checks. `run`: the
/// messages already reported by the run.
pub fn diagnostics(
    simulation: &SimulationResult,
    motions: &Motions,
    levels: &Levels,
    run: &[Diagnostic],
) -> Vec<Diagnostic> {
    let mut told: Vec<Diagnostic> = Vec::new();
    told.extend(simulation.limit().map(|full| {
        let message: Message = match full {
            SimulationLimit::Motions(most) => said::PartTooManyMotions { most }.into(),
            SimulationLimit::Corners(most) => said::PartTooManyCorners { most }.into(),
            SimulationLimit::Stopped { done, all } => said::PartStopped { done, all }.into(),
        };
        Diagnostic::new(message, Span::new(0, 0))
    }));
    told.extend(unchecked_after_failure(simulation, motions));
    told.extend(without_simulation(simulation.resolved_setup(), motions, usize::MAX));
    for finding in simulation.findings() {
        let is_feed = matches!(finding.danger, Danger::FastFeed { .. });
        let motion = if is_feed { feed_begins(motions, finding.motion) } else { finding.motion };
        let (message, span) = (message(finding, motions), motions.span(motion));
        // A thread that starts below its crest is already reported.
        let is_known = |other: &Diagnostic| {
            (other.message.is::<said::ThreadStartInside>() || other.message.is::<said::ThreadStartAtCrest>())
                && span.contains(other.span)
        };
        if message.is::<said::StartInStock>() && run.iter().any(is_known) {
            continue;
        }
        // A feed without a decimal point or in the wrong unit is reported where it is written, perhaps in an
        // earlier block.
        let is_about_feed = |other: &Diagnostic| {
            other.message.is::<said::LeadingZero>()
                || other.message.is::<said::FeedPerTurnTooLarge>() && span.contains(other.span)
        };
        if message.is::<said::FeedPerTurnHigh>() && run.iter().any(is_about_feed) {
            continue;
        }
        let same = |other: &Diagnostic| other.span == span && other.message.slug() == message.slug();
        if !told.iter().rev().take(20).any(same) {
            told.push(Diagnostic::new(message, span));
        }
    }
    let is_about_thread = |other: &Diagnostic| {
        let slug = other.message.slug();
        other.severity > Severity::Info && (slug.starts_with("thread-") || slug.starts_with("lead-"))
    };
    let removals = simulation.removals();
    for (index, unusual) in removals.iter().enumerate() {
        let span = motions.span(unusual.motion);
        let follows = match unusual.removal {
            // The following passes end at the same Z.
            Removal::BeyondBlank { .. } => {
                removals[..index].iter().any(|other| other.removal == unusual.removal)
            }
            Removal::ThreadDepth { .. } => run.iter().any(is_about_thread),
            Removal::ThreadRunOut(_) | Removal::Nothing(_) | Removal::TooDeep { .. } => false,
        };
        let is_of_next_part = || index < MAX_COMPARED && cuts_next_part(unusual, motions);
        if follows || is_intended(unusual, simulation.resolved_setup(), motions) || is_of_next_part() {
            continue;
        }
        // If a message about the block is already reported, the unusual removal is a consequence of that
        // fault.
        let is_known = |other: &Diagnostic| {
            other.severity > Severity::Info && (span.contains(other.span) || other.span.contains(span))
        };
        if !run.iter().chain(&told).any(is_known) {
            told.push(Diagnostic::new(removal(unusual, motions), span));
        }
    }
    told.into_iter().filter_map(|found| levels.apply_to(found)).collect()
}

/// Whether an unusual removal is intended.
fn is_intended(unusual: &Unusual, resolved: &ResolvedSetup, motions: &Motions) -> bool {
    let motion = motions.get(unusual.motion);
    match unusual.removal {
        Removal::TooDeep { .. } => feed_per_turn(&motion.process).is_some_and(|feed| feed < ONE_PASS_FEED),
        Removal::BeyondBlank { z, back } => {
            let tool = &resolved.tool(&motion).tool;
            let is_inside = tool.kind == Some(ToolKind::Boring) || tool.side == Some(Side::Inside);
            let leads = motion.lead.map_or(0.0, |lead| 2.0 * lead.abs());
            is_inside && back - z <= RUN_OUT_INSIDE.max(leads)
        }
        _ => false,
    }
}

/// Whether a cycle that removes nothing repeats the first cut of one before a stop or another tool: the part
/// was changed in between.
fn cuts_next_part(unusual: &Unusual, motions: &Motions) -> bool {
    if !matches!(unusual.removal, Removal::Nothing(_)) {
        return false;
    }
    let first = unusual.motion;
    let own = motions.glance(first);
    let Some(before) = (0..first).rev().find(|&index| motions.glance(index) == own) else { return false };
    let other_tool = (before..first).any(|index| motions.glance(index).station != own.station);
    other_tool || motions.stops(before + 1..first + 1).next().is_some()
}

/// The feed, mm/rev, if it is known.
fn feed_per_turn(process: &Process) -> Option<f64> {
    match (process.feed, process.speed) {
        (Feed::PerTurn(feed), _) => Some(feed),
        (Feed::PerMinute(feed), SpindleSpeed::Constant(speed)) if speed > 0.0 => Some(feed / speed),
        _ => None,
    }
}

/// The message that after a block that was not executed, material is neither removed nor checked. Its place
/// is the first motion after this block.
fn unchecked_after_failure(simulation: &SimulationResult, motions: &Motions) -> Option<Diagnostic> {
    let first = motions.first_incomplete().filter(|_| simulation.limit().is_none())?;
    let cuts = motions.uncertain_cuts();
    // Without a given blank, collisions are not checked at all.
    let looked_for = simulation.resolved_setup().stock().is_some_and(|(_, basis)| basis == Basis::Given);
    let message: Message =
        if cuts == 0 { said::BehindLeftOut.into() } else { said::BehindLeftOutCuts { cuts }.into() };
    (cuts > 0 || looked_for).then(|| Diagnostic::new(message, motions.span(first)))
}

/// The messages that need no simulation: cuts and tools omitted from the part, and rapids into turned
/// surfaces if the blank is inferred.
pub fn without_simulation(resolved: &ResolvedSetup, motions: &Motions, most: usize) -> Vec<Diagnostic> {
    let has_too_many = motions.len() > most && resolved.stock().is_some();
    let too_many = has_too_many.then(|| Diagnostic::new(said::PartTooManyMotions { most }, Span::new(0, 0)));
    let rapids = rapids_into_material(motions, resolved);
    let rapids =
        rapids.iter().map(|finding| Diagnostic::new(message(finding, motions), motions.span(finding.motion)));
    too_many.into_iter().chain(not_shown(resolved, motions)).chain(rapids).collect()
}

/// Messages about what the part does not include: cuts in a work frame with an unknown zero, reported at the
/// first one; each unknown tool and each drill with an unknown diameter, at its first cut; and the first hole
/// across the axis. Empty if no part could be shown anyway.
fn not_shown(resolved: &ResolvedSetup, motions: &Motions) -> impl Iterator<Item = Diagnostic> {
    let has_part = resolved.stock().is_some();
    let elsewhere = motions.cuts_elsewhere().filter(|_| has_part);
    let elsewhere = elsewhere.map(|(first, cuts)| {
        let frame_of_first_cut =
            motions.iter().find(|motion| motion.kind.cuts()).map(|cut| cut.process.frame);
        // In the frame of the first cut it can only be the other end.
        let message: Message = match frame_of_first_cut == Some(motions.get(first).process.frame) {
            true => said::OtherEndLeftOut { cuts }.into(),
            false => said::ElsewhereLeftOut { cuts }.into(),
        };
        Diagnostic::new(message, motions.span(first))
    });
    let unknown = if has_part { resolved.unknown() } else { &[] };
    let shows_part = resolved.shows_part();
    let unknown = unknown.iter().map(move |&index| {
        let tool = tool_word(motions.get(index).process.tool);
        let message: Message = match shows_part {
            true => said::ToolUnknownCuts { tool }.into(),
            false => said::ToolUnknown { tool }.into(),
        };
        Diagnostic::new(message, motions.span(index))
    });
    let drills = if has_part { assumed_drills(resolved, motions) } else { Vec::new() };
    let is_cross_hole = |&index: &usize| {
        let motion = motions.get_on_workpiece(index).on_positive_side();
        goes_into_side(&motion, resolved.tool(&motion))
    };
    let cross_hole = (0..motions.len().min(INFERRED_FROM)).filter(|_| has_part).find(is_cross_hole);
    let cross_hole = cross_hole.map(|index| Diagnostic::new(said::CrossHolesLeftOut, motions.span(index)));
    elsewhere.into_iter().chain(unknown).chain(drills).chain(cross_hole)
}

/// The first cut of each drill whose diameter is assumed. Omits centre drills: a deeper drill makes their
/// hole.
fn assumed_drills(resolved: &ResolvedSetup, motions: &Motions) -> Vec<Diagnostic> {
    struct Hole {
        tool: (u16, u16),
        first: usize,
        deepest: f64,
        assumed: Option<Diameter>,
    }
    let mut holes: Vec<Hole> = Vec::new();
    if resolved.tools().all(|tool| tool.assumed_diameter().is_none()) {
        return Vec::new();
    }
    let cuts = (0..motions.len().min(INFERRED_FROM)).filter(|&index| motions.kind(index).cuts());
    for index in cuts {
        let motion = motions.get_on_workpiece(index).on_positive_side();
        let tool = resolved.tool(&motion);
        // The section does not show off-axis holes of a live drill.
        let is_left_out = tool.is_live_in(&motion) || !motion.process.removes_material();
        if tool.tool.kind != Some(ToolKind::Drill) || is_left_out {
            continue;
        }
        match holes.iter_mut().find(|hole| hole.tool.0 == motion.process.tool.0) {
            Some(hole) => hole.deepest = hole.deepest.min(motion.to.z),
            None => holes.push(Hole {
                tool: motion.process.tool,
                first: index,
                deepest: motion.to.z,
                assumed: tool.assumed_diameter(),
            }),
        }
    }
    let deepest = holes.iter().map(|hole| hole.deepest).fold(f64::INFINITY, f64::min);
    let shown = holes.iter().filter(|hole| hole.deepest <= deepest + SAME);
    let told = shown.filter_map(|hole| {
        let (tool, diameter) = (tool_word(hole.tool), hole.assumed?.mm());
        Some(Diagnostic::new(said::DrillAssumed { tool, diameter }, motions.span(hole.first)))
    });
    told.collect()
}

/// The first cut with the feed of a cut; it may come before the tool reaches the workpiece.
fn feed_begins(motions: &Motions, index: usize) -> usize {
    let feed = motions.get(index).process.feed;
    let same = (0..index).rev().take_while(|&before| motions.get(before).process.feed == feed);
    same.filter(|&before| motions.kind(before).cuts()).last().unwrap_or(index)
}

/// The T word of a station with the offset of a motion.
fn tool_of(finding: &Finding, motions: &Motions, station: u16) -> String {
    tool_word((station, motions.get(finding.motion).process.tool.1))
}

fn removal(unusual: &Unusual, motions: &Motions) -> Message {
    let tenth = |length: f64| (10.0 * length).round() / 10.0;
    let hundredth = |length: f64| (100.0 * length).round() / 100.0;
    match unusual.removal {
        Removal::Nothing(Some(cycle)) => said::CycleCutsAir { code: cycle.code() }.into(),
        Removal::Nothing(None) => {
            said::ToolCutsAir { tool: tool_word(motions.get(unusual.motion).process.tool) }.into()
        }
        Removal::TooDeep { depth, most } => {
            said::CutTooDeep { depth: tenth(depth), most: tenth(most) }.into()
        }
        Removal::ThreadDepth { depth, lead } => {
            said::ThreadDepthUnusual { depth: hundredth(depth), lead, usual: hundredth(0.65 * lead) }.into()
        }
        Removal::ThreadRunOut(ShortRunOut { available, required }) => {
            said::ThreadRunOut { have: hundredth(available), need: hundredth(required) }.into()
        }
        Removal::BeyondBlank { z, back } => {
            let zero = motions.get(unusual.motion).process.zero.z;
            said::CutBeyondBlank { z: z - zero, back: back - zero }.into()
        }
    }
}

fn message(finding: &Finding, motions: &Motions) -> Message {
    let hundredth = |length: f64| (100.0 * length).round() / 100.0;
    // In the coordinates of the program at this motion.
    let zero = motions.get(finding.motion).process.zero;
    let at = finding.at.moved(zero.opposite());
    let (x, z) = (Diameter::from_radius(at.x).map(hundredth), hundredth(at.z));
    match finding.danger {
        Danger::RapidThroughStock => said::RapidThroughStock { x, z }.into(),
        Danger::DoglegThroughStock => said::DoglegThroughStock { x, z }.into(),
        Danger::RapidAlongStock => said::RapidAlongStock { x }.into(),
        Danger::LeavesBore => said::BoreRetract { x, z }.into(),
        Danger::BehindFace { face } => said::StartBehindFace { z, face: face - zero.z }.into(),
        Danger::CycleStart => {
            let cycle = motions.get(finding.motion).cycle.map_or("", |tag| tag.cycle.code());
            said::StartInStock { code: cycle, x }.into()
        }
        Danger::IntoJaws => said::IntoJaws { x, z }.into(),
        Danger::IntoTailstock => said::IntoTailstock { x, z }.into(),
        Danger::HolderInStock => said::HolderInStock { x, z }.into(),
        Danger::SlopeTooSteep { slope, tool } => {
            let tenth = |angle: f64| (10.0 * angle).round() / 10.0;
            said::SlopeTooSteep { slope: tenth(slope), follows: tenth(tool) }.into()
        }
        Danger::BelowCenter => said::BelowCenter { x }.into(),
        Danger::OverTravel { axis, limit } => match axis {
            // Not rounded: the position may be only slightly beyond the limit.
            Axis::X => {
                said::OverTravel { axis: 'X', to: Diameter::from_radius(finding.at.x).mm(), limit }.into()
            }
            Axis::Z => said::OverTravel { axis: 'Z', to: finding.at.z, limit }.into(),
        },
        Danger::ToolNotListed { station } => {
            said::ToolNotListed { tool: tool_of(finding, motions, station) }.into()
        }
        Danger::OtherWork { kind, station } => {
            let tool = tool_of(finding, motions, station);
            match kind {
                ToolKind::Drill | ToolKind::Tap => said::DrillTurns { tool }.into(),
                ToolKind::Threading => said::ThreadingToolTurns { tool }.into(),
                ToolKind::Turning | ToolKind::Boring | ToolKind::Grooving | ToolKind::Endmill => {
                    said::NoThreadingTool { tool }.into()
                }
            }
        }
        Danger::WrongSide { kind, station } => {
            let tool = tool_of(finding, motions, station);
            match kind {
                ToolKind::Boring => said::BoringBarOutside { tool }.into(),
                _ => said::OutsideToolBores { tool }.into(),
            }
        }
        Danger::FastFeed { per_turn } => said::FeedPerTurnHigh { feed: hundredth(per_turn) }.into(),
    }
}
