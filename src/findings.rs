//! Messages about what happens at the machine.
//!
//! In: the findings of the machine, the levels that are asked for. Out: messages at the blocks that made the
//! motions, one for each block and danger: a cycle that runs into something does so in every pass.

use crate::machine::danger::{Axis, Danger, Finding};
use crate::machine::resolved_setup::{Basis, ResolvedSetup};
use crate::machine::{SimulationLimit, SimulationResult};
use crate::message::{Diagnostic, Levels, Message, said};
use crate::motion::Motions;
use crate::source::Span;
use crate::units::Diameter;

/// The messages of all findings, of a bound that was met, and of what was not looked at. `run`:
/// what the run has reported.
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
    told.extend(behind_left_out(simulation, motions));
    told.extend(not_shown(simulation.resolved_setup(), motions));
    for finding in simulation.findings() {
        let (message, span) = (message(finding, motions), motions.span(finding.motion));
        // A thread that starts below its own crest was reported so.
        let is_known = |other: &Diagnostic| {
            (other.message.is::<said::ThreadStartInside>() || other.message.is::<said::ThreadStartAtCrest>())
                && span.contains(other.span)
        };
        if message.is::<said::StartInStock>() && run.iter().any(is_known) {
            continue;
        }
        let same = |other: &Diagnostic| other.span == span && other.message.slug() == message.slug();
        if !told.iter().rev().take(20).any(same) {
            told.push(Diagnostic::new(message, span));
        }
    }
    told.into_iter().filter_map(|found| levels.graded(found)).collect()
}

/// What is not taken off and not looked at after a block that was not carried out, at
/// the first motion after it.
fn behind_left_out(simulation: &SimulationResult, motions: &Motions) -> Option<Diagnostic> {
    let first = motions.first_incomplete().filter(|_| simulation.limit().is_none())?;
    let cuts = motions.uncertain_cuts();
    // Without a blank that somebody has named no collision is looked for at all.
    let looked_for = simulation.resolved_setup().stock().is_some_and(|(_, basis)| basis == Basis::Given);
    let message: Message =
        if cuts == 0 { said::BehindLeftOut.into() } else { said::BehindLeftOutCuts { cuts }.into() };
    (cuts > 0 || looked_for).then(|| Diagnostic::new(message, motions.span(first)))
}

/// What the part is not made of: cuts in a work frame whose zero nobody gave, reported at the first; and each
/// tool that is not known, at its first cut. Nothing where no part could be shown anyway.
pub fn not_shown(resolved: &ResolvedSetup, motions: &Motions) -> impl Iterator<Item = Diagnostic> {
    let has_part = resolved.stock().is_some();
    let elsewhere = motions.cuts_elsewhere().filter(|_| has_part);
    let elsewhere =
        elsewhere.map(|(first, cuts)| Diagnostic::new(said::ElsewhereLeftOut { cuts }, motions.span(first)));
    let unknown = if has_part { resolved.unknown() } else { &[] };
    let unknown = unknown.iter().map(|&index| {
        let (station, offset) = motions.get(index).process.tool;
        let tool = format!("T{station:02}{offset:02}");
        Diagnostic::new(said::ToolUnknown { tool }, motions.span(index))
    });
    elsewhere.into_iter().chain(unknown)
}

fn message(finding: &Finding, motions: &Motions) -> Message {
    let hundredth = |length: f64| (100.0 * length).round() / 100.0;
    let (x, z) = (Diameter::from_radius(finding.at.x).map(hundredth), hundredth(finding.at.z));
    match finding.danger {
        Danger::RapidThroughStock => said::RapidThroughStock { x, z }.into(),
        Danger::DoglegThroughStock => said::DoglegThroughStock { x, z }.into(),
        Danger::RapidAlongStock => said::RapidAlongStock { x }.into(),
        Danger::LeavesBore => said::BoreRetract { x, z }.into(),
        Danger::BehindFace { face } => said::StartBehindFace { z, face }.into(),
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
            // Unrounded: it may be a little beyond.
            Axis::X => {
                said::OverTravel { axis: 'X', to: Diameter::from_radius(finding.at.x).mm(), limit }.into()
            }
            Axis::Z => said::OverTravel { axis: 'Z', to: finding.at.z, limit }.into(),
        },
        Danger::ToolNotListed { station } => {
            let offset = motions.get(finding.motion).process.tool.1;
            said::ToolNotListed { tool: format!("T{station:02}{offset:02}") }.into()
        }
    }
}
