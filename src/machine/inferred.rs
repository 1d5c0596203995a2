//! Infers the tools and the blank that are not given.
//!
//! In: the motions. Out: a [`Tool`] for each purpose of a station (`tool_use`, `choice`), and a [`Stock`]
//! (its size: `blank`). An inferred tool is sharp and can follow every slope of its path. It is shown as
//! inferred, and raises no alarm.
//!
//! The order of evidence, strongest first:
//!
//! 1. Tools and blanks given by the setup or by a `(TOOL …)` or `(STOCK …)` comment are never inferred.
//! 2. A motion that cannot cut is no evidence: an uncertain one, one in an unknown frame, one with the
//!    spindle stopped by M05 (`Process::removes_material`).
//! 3. The direction of work: if all cuts go towards +Z into the workpiece, Z is mirrored (`evidence`).
//! 4. The cycle, or a path on the axis, gives the purpose: a hole, a thread, a groove, a contour
//!    (`tool_use::Purpose`). A drill may be slightly off the axis while the spindle turns. Off the axis, a
//!    drill or end mill named by a comment is a live tool, and so is a tool that only plunges while C turns
//!    between plunges.
//! 5. The roughing cycle of a contour: G70 finishes on the side from which it was roughed, wherever G70
//!    starts (`finishing`).
//! 6. How cuts end: a tool that leaves the workpiece outwards turns, one that leaves it inwards bores; one
//!    that only plunges, in one step or several, grooves or parts off (`tool_use`).
//! 7. Comments about the tool, if the motions do not decide (`Setup::described_tools`).
//! 8. The work of other tools: a tool deep within turned material and in a hole drilled before bores; an
//!    insert within a recess of the face is not larger than the recess.
//! 9. The contour that all tips make together: of the possible tools, the most usual one that leaves it
//!    intact (`choice`).
//! 10. The blank surrounds all cuts (`blank`). A first cut across the whole face is its front. Sizes in
//!     comments count if they fit the cuts (`Setup::described_stock`).

use std::collections::{BTreeMap, BTreeSet};

use super::blank::{Cuts, ON_AXIS, clear_of_rapids, first_face, larger_than_first_pass, smaller_than_bored};
use super::choice;
use super::evidence::Evidence;
use super::tool::DRILL;
use super::tool_use::{Clamping, Purpose, ToolUse};
use crate::geometry::SAME;
use crate::limits::INFERRED_FROM;
use crate::motion::Motions;
use crate::setup::{Blank, DescribedStock, Setup, Stock, Tool, ToolKind, tool_word};

/// The tools and the blank inferred from a program.
#[derive(Clone, Debug, Default)]
pub struct InferredSetup {
    tools: Vec<(u16, Purpose, Tool)>,
    /// The first motion of each use for which no tool is known: each tool that was tried cuts into the
    /// contour.
    pub unknown: Vec<usize>,
    /// The blank. `None` if there are no cuts.
    pub stock: Option<Stock>,
}

impl InferredSetup {
    /// Infers tools and blank from the motions alone.
    pub fn of(motions: &Motions) -> Self {
        Self::with(motions, &BTreeMap::new(), DescribedStock::default(), None)
    }

    /// Infers tools and blank. `described_tools` are the tools that comments describe, by station;
    /// `described_stock` is the blank that comments describe; `stock` is the given blank or its extents, if any.
    pub fn with(
        motions: &Motions,
        described_tools: &BTreeMap<u16, Tool>,
        described_stock: DescribedStock,
        stock: Option<Stock>,
    ) -> Self {
        let evidence = Evidence::of(motions, stock);
        let stock = stock.map(|stock| evidence.stock(stock));
        let uses = ToolUse::all(&evidence, described_tools, stock, Clamping::First);
        let mut tools = tools_of(&uses);
        let mut cuts = Cuts::default();
        for (own, (.., tool)) in uses.iter().zip(&tools) {
            let is_live = own.purpose == Purpose::Live;
            // Off the axis a drill goes into the blank like any live tool.
            let milled = Tool { kind: Some(ToolKind::Endmill), ..Tool::default() };
            cuts.add(&own.extents, if is_live { &milled } else { tool });
        }
        let front = first_face(&evidence, |motion| {
            let of = |(station, purpose, _): &&(u16, Purpose, Tool)| {
                (*station, *purpose) == (motion.process.tool.0, Purpose::of(motion))
            };
            tools.iter().find(of).is_some_and(|(.., tool)| tool.kind == Some(ToolKind::Grooving))
        });
        let blank = cuts.blank(front).map(|stock| clear_of_rapids(stock, &evidence));
        let blank = blank.map(|stock| larger_than_first_pass(stock, &evidence));
        let blank = blank.map(|stock| smaller_than_bored(stock, &evidence));
        let blank = blank.map(|stock| described_stock.applied_to(stock));
        let choices = tools.iter_mut().map(|(.., tool)| tool).collect();
        let unknown = choice::decide(&evidence, &uses, described_tools, stock.or(blank), choices);
        tools.iter_mut().for_each(|(.., tool)| evidence.tool(tool));
        let blank = blank.map(|stock| evidence.stock(stock));
        let mut inferred = Self { tools, unknown, stock: blank };
        // No material is removed in other clampings, so the first tool is good enough.
        if motions.cuts_elsewhere().is_some() {
            for mut other in tools_of(&ToolUse::all(&evidence, described_tools, stock, Clamping::Other)) {
                evidence.tool(&mut other.2);
                if inferred.tools.iter().all(|own| (own.0, own.1) != (other.0, other.1)) {
                    inferred.tools.push(other);
                }
            }
        }
        inferred
    }

    /// All tools with station and purpose, in the order of their first use.
    pub fn tools(&self) -> impl Iterator<Item = (u16, Purpose, &Tool)> {
        self.tools.iter().map(|(station, purpose, tool)| (*station, *purpose, tool))
    }
}

/// The inferred blank and tools as a setup. A tool has the name of its first T word; `T0000` is the tool of
/// cuts before any T word.
pub fn inferred_setup(motions: &Motions, given: &Setup) -> Setup {
    let (tools, stock) = (&given.described_tools, given.described_stock);
    let inferred = InferredSetup::with(motions, tools, stock, given.extents());
    let mut setup = Setup { stock: inferred.stock.map(Blank::from), ..Setup::default() };
    let (mut names, mut stations): (Vec<(u16, u16)>, BTreeSet<u16>) = Default::default();
    for motion in motions.iter().take(INFERRED_FROM).filter(|motion| motion.kind.cuts()) {
        let name = motion.process.tool;
        if names.last() != Some(&name) && stations.insert(name.0) {
            names.push(name);
        }
    }
    for (station, offset) in names {
        if let Some((.., tool)) = inferred.tools().find(|inferred| inferred.0 == station) {
            setup.tools.insert(tool_word((station, offset)), tool.clone());
        }
    }
    setup
}

/// Allowance that a drill leaves for boring, radius, mm.
const ALLOWANCE: f64 = 0.5;

/// A first tool for each use.
fn tools_of(uses: &[ToolUse]) -> Vec<(u16, Purpose, Tool)> {
    // Boring begins at the radius of the drill.
    let inside = || uses.iter().filter(|own| own.is_inside());
    let bores = inside().map(|own| own.extents.least()).filter(|&least| least >= ON_AXIS);
    let least = bores.fold(f64::INFINITY, f64::min);
    // A boring cut at that radius removes material, so the drill was smaller.
    let is_cut = inside().any(|own| own.turned <= least + SAME);
    let bore = if is_cut { least - ALLOWANCE.min(least / 10.0) } else { least };
    let holes = uses.iter().filter(|own| own.purpose == Purpose::Hole);
    let deepest = holes.map(|own| own.deepest).fold(f64::INFINITY, f64::min);
    // A centre drill or a first drill comes before the drill that makes the bore, and is not larger.
    let bore_of = |own: &ToolUse| match own.deepest <= deepest + SAME || bore < DRILL.radius() {
        true => bore,
        false => f64::INFINITY,
    };
    uses.iter().map(|own| (own.station, own.purpose, own.tool(bore_of(own)))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analyze;

    #[test]
    fn stations_are_named_as_the_program_calls_them() {
        let text = b"M3 S500\nG0 X40 Z2\nG1 Z-5 F.2\nT0305\nG0 X40 Z2\nG75 R1\nG75 X20 Z-9 P2000 Q2000 F.1\nT0300\nG1 X60\n";
        let inferred = inferred_setup(&analyze(text, &Setup::default()).motions, &Setup::default());
        let tools: Vec<_> = inferred.tools.iter().map(|(name, tool)| (name.as_str(), tool.kind)).collect();
        assert_eq!(tools, [("T0000", Some(ToolKind::Turning)), ("T0305", Some(ToolKind::Grooving))]);
        assert!(inferred.stock.is_some());
    }
}
