//! Chooses the tool of each use that leaves the contour intact.
//!
//! In: the motions, the uses, the tools that comments describe, the blank. Out: the inferred tools. If the
//! first tool would cut into the surface that all tips leave together, it is replaced by another one, or the
//! tool is reported as unknown. Must not know the text.

use std::collections::{BTreeMap, BTreeSet};

use super::evidence::Evidence;
use super::surface::{Facing, SHIFT, Surface, Track, WIDEST_SHIFT};
use super::sweep::path_of;
use super::tool::{BLADE, EDGE, takes};
use super::tool_use::{Purpose, ToolUse};
use super::z_positions::{Places, ZPositions};
use crate::geometry::{Point, SAME};
use crate::motion::{Cycle, Motion};
use crate::order;
use crate::setup::{Side, Stock, Tool, ToolKind};

/// Widths of grooving inserts that are tried, mm.
const WIDTHS: [f64; 4] = [3.0, 2.0, 1.5, 1.0];

/// Width assumed for a grooving insert of unknown width, mm: only the tip cuts, and the contour is as
/// programmed.
const THIN: f64 = 0.04;

/// Angle assumed for a turning insert of unknown angle, degrees: only the tip cuts, and undercuts are as
/// programmed.
const NEEDLE: f64 = 0.1;

/// A cut across the axis that ends closer to it than this, mm, faces the workpiece or parts it off.
pub(super) const TO_AXIS: f64 = 1.0;

/// Longest piece in front of a face that facing removes, mm: if the tool continues behind it, and if not. A
/// longer piece is parted off.
const IN_FRONT: [f64; 2] = [3.0, 0.5];

/// If a grooving insert that roughs for other tools makes at most this many plunges, one of them may be a
/// groove.
const FEW: usize = 4;

/// Share of the space beside the wall of a recess that an insert takes at most.
const ROOM: f64 = 0.9;

/// A program that is longer than this, mm, has a typing error and gets no blank.
const MAX_PROGRAM_LENGTH: f64 = 5000.0;

/// Replaces each inferred tool that would cut too deep by one that does not; `tools` has one entry for each
/// use. Returns the first motion of each use for which no tool is known.
pub(super) fn decide(
    evidence: &Evidence,
    uses: &[ToolUse],
    described_tools: &BTreeMap<u16, Tool>,
    stock: Option<Stock>,
    mut tools: Vec<&mut Tool>,
) -> Vec<usize> {
    for (own, tool) in uses.iter().zip(&mut tools) {
        if let Some(words) = described_tools.get(&own.station) {
            **tool = with_words(own.purpose, tool, words);
        }
    }
    let mut unknown = Vec::new();
    let Some(stock) = stock else { return unknown };
    let Some(led) = Tracks::of(evidence, uses, &stock) else { return unknown };
    let mut uncertain: Option<BTreeSet<u16>> = None;
    for (index, own) in uses.iter().enumerate().filter(|(_, own)| own.purpose == Purpose::Turning) {
        let Some(first) = tools.get_mut(index) else { continue };
        if first.kind == Some(ToolKind::Grooving) {
            // It only plunges.
            continue;
        }
        let grooves =
            uses.iter().any(|other| other.station == own.station && other.purpose == Purpose::Grooving);
        let words = described_tools.get(&own.station).cloned().unwrap_or_default();
        let is_blade = words.kind == Some(ToolKind::Grooving) || (grooves && own.station > 0 && !own.contour);
        let mut all = candidates(first, own, &words);
        let (inserts, blades): (Vec<Tool>, Vec<Tool>) =
            all.drain(..).partition(|tool| tool.kind != Some(ToolKind::Grooving) && !is_tip_alone(tool));
        let mut found = None;
        if is_blade {
            found = blades.iter().find(|tool| led.does(index, own, tool));
        }
        let found = found
            .or_else(|| inserts.iter().find(|tool| led.does(index, own, tool)))
            .or_else(|| blades.iter().find(|tool| led.does(index, own, tool)))
            .or_else(|| blades.iter().find(|tool| words.kind == tool.kind && led.grooves(index, own, tool)))
            .or_else(|| inserts.iter().find(|tool| led.follows(index, own, tool, WIDEST_SHIFT)));
        match found {
            Some(tool) => **first = tool.clone(),
            // Some cuts of this tool are uncertain, and the others are not enough evidence.
            None if uncertain.get_or_insert_with(|| with_uncertain_cuts(evidence)).contains(&own.station) => {
            }
            None => unknown.push(own.first),
        }
    }
    keep_within_recesses(uses, &stock, &mut tools);
    unknown
}

/// Shortens the edges of inserts that turn within a face recess, so that they do not cut its outer wall.
fn keep_within_recesses(uses: &[ToolUse], stock: &Stock, tools: &mut [&mut Tool]) {
    let is_face = |tool: &Tool| tool.kind == Some(ToolKind::Grooving) && tool.side == Some(Side::Face);
    let recesses = uses.iter().zip(&*tools).filter(|(_, tool)| is_face(tool));
    let recesses: Vec<_> = recesses
        .map(|(own, tool)| (own.extents.behind() + tool.width.unwrap_or(BLADE), own.deepest))
        .filter(|&(wall, _)| wall < stock.diameter.radius() - SAME)
        .collect();
    for (own, tool) in uses.iter().zip(tools).filter(|(_, tool)| tool.kind == Some(ToolKind::Turning)) {
        let turned = own.extents.behind();
        let within = recesses.iter().filter(|&&(wall, bottom)| turned < wall && own.deepest >= bottom - SAME);
        if let Some(room) = within.map(|(wall, _)| wall - turned).min_by(f64::total_cmp) {
            tool.edge_length = Some(EDGE.min(ROOM * room));
        }
    }
}

/// The stations with uncertain cuts.
fn with_uncertain_cuts(evidence: &Evidence) -> BTreeSet<u16> {
    let cuts = evidence.moves().filter(|motion| motion.kind.cuts());
    order::gathered(cuts.filter(|cut| cut.process.uncertain).map(|cut| cut.process.tool.0))
}

/// An inferred tool with the measures that comments give, if they name the same kind of tool.
fn with_words(purpose: Purpose, inferred: &Tool, words: &Tool) -> Tool {
    let same = inferred.kind == words.kind;
    let mut tool = inferred.clone();
    match purpose {
        Purpose::Hole | Purpose::Live if same => tool.diameter = words.diameter.or(tool.diameter),
        _ if same && inferred.kind == Some(ToolKind::Grooving) => {
            tool.width = words.width.or(tool.width);
            tool.tip = words.tip.filter(|_| tool.side == Some(Side::Outside)).or(tool.tip);
            // G74 grooves a face, G75 the other sides.
            tool.side = words.side.filter(|_| inferred.side != Some(Side::Face)).or(tool.side);
        }
        Purpose::Threading if same => tool.side = words.side.or(tool.side),
        _ => {}
    }
    tool
}

/// The tools to try for a turning use: inserts from the usual to the sharpest, then grooving inserts from the
/// widest.
fn candidates(first: &Tool, own: &ToolUse, words: &Tool) -> Vec<Tool> {
    let inside = own.is_inside();
    let kind = if inside { ToolKind::Boring } else { ToolKind::Turning };
    let insert = |insert: &str, entering: Option<f64>| Tool {
        kind: Some(kind),
        insert: Some(insert.into()),
        entering_angle: entering,
        tip: first.tip,
        ..Tool::default()
    };
    let mut all = Vec::new();
    if let Some(letter) = words.insert.as_deref().and_then(|insert| insert.chars().next()) {
        let entering = match letter {
            'C' | 'W' => Some(95.0),
            'D' | 'V' | 'K' => Some(93.0),
            'T' => Some(91.0),
            _ => None,
        };
        all.push(insert(words.insert.as_deref().unwrap_or_default(), entering));
    }
    all.push(first.clone());
    all.extend([insert("D", Some(93.0)), insert("V", Some(93.0)), insert("V", Some(72.5))]);
    let needle = Tool { insert: None, point_angle: Some(1.0), ..insert("", Some(91.0)) };
    all.push(needle);
    let side = words.side.unwrap_or(if inside { Side::Inside } else { Side::Outside });
    let blade = |width: f64| Tool {
        kind: Some(ToolKind::Grooving),
        side: Some(side),
        width: Some(width),
        tip: words.tip.filter(|_| side == Side::Outside),
        ..Tool::default()
    };
    match words.width {
        Some(width) => all.push(blade(width)),
        None => all.extend(WIDTHS.map(blade)),
    }
    let tip = Some(if inside { 6 } else { 8 });
    all.push(match words.kind {
        Some(ToolKind::Grooving) => Tool { tip, ..blade(THIN) },
        _ => Tool { kind: Some(kind), point_angle: Some(NEEDLE), tip, ..Tool::default() },
    });
    all
}

/// Whether only the tip of a tool is known.
fn is_tip_alone(tool: &Tool) -> bool {
    tool.width == Some(THIN) || tool.point_angle == Some(NEEDLE)
}

/// The paths of the tools, and the surfaces that must remain.
struct Tracks {
    tracks: Vec<Track>,
    positions: ZPositions,
    outside: Surface,
    inside: Surface,
    /// Z of the finished face, mm.
    front: f64,
}

impl Tracks {
    fn of(evidence: &Evidence, uses: &[ToolUse], stock: &Stock) -> Option<Self> {
        let turns = |own: &ToolUse| matches!(own.purpose, Purpose::Turning | Purpose::Grooving);
        if !uses.iter().any(|own| own.purpose == Purpose::Turning) {
            return None;
        }
        let cuts = || {
            let counts = |motion: &Motion| motion.kind.cuts() && motion.process.removes_material();
            evidence.moves().filter(move |motion| counts(motion) && motion.rotary.is_none())
        };
        let index_of = |motion: &Motion| {
            let (station, purpose) = (motion.process.tool.0, Purpose::of(motion));
            let found = uses.iter().position(|own| own.station == station && own.purpose == purpose);
            found.filter(|&index| turns(&uses[index]))
        };
        let (mut low, mut high) = (f64::INFINITY, stock.face);
        let mut places = Places::default();
        for motion in cuts() {
            low = low.min(motion.to.z.min(motion.from.z));
            high = high.max(motion.from.z);
            if index_of(&motion).is_some() {
                places.add(&path_of(&motion));
            }
        }
        let behind = low < -SAME;
        // The bar behind all cuts is clamped and not part of the workpiece.
        let back = low.max(stock.back());
        low = low.min(stock.back());
        if high - low > MAX_PROGRAM_LENGTH {
            return None;
        }
        // Where the workpiece may begin and end.
        [back, stock.face, 0.0].into_iter().for_each(|z| places.end(z));
        let positions = places.between(low, high);
        let facing = |own: &ToolUse| if own.is_inside() { Facing::Inwards } else { Facing::Outwards };
        let mut tracks = vec![Track::new(&positions); uses.len()];
        let mut faces: Vec<(f64, usize)> = Vec::new();
        let mut roughs_by_facing = false;
        for motion in cuts() {
            let Some(index) = index_of(&motion) else { continue };
            let way = path_of(&motion);
            let cycle = motion.cycle.map(|own| own.cycle);
            if let Some(roughing) = cycle.filter(|&cycle| cycle != Cycle::Finishing) {
                roughs_by_facing = roughing == Cycle::RoughFacing;
            }
            let is_facing = cycle.is_some() && roughs_by_facing;
            let across = (motion.to.z - motion.from.z).abs() <= SAME;
            if is_facing && across && facing(&uses[index]) == Facing::Outwards {
                // In front of a facing pass nothing higher remains: the contour falls towards the face.
                let front = Point::new(motion.to.x, stock.face);
                tracks[index].add(&[front, motion.to], Facing::Outwards, &positions);
            }
            // Along the outside of the blank the tool is in the air.
            let outside = stock.diameter.radius() - SAME;
            if facing(&uses[index]) == Facing::Outwards && way.iter().all(|at| at.x >= outside) {
                continue;
            }
            tracks[index].add(&way, facing(&uses[index]), &positions);
            if across && motion.to.x <= TO_AXIS && motion.from.x > TO_AXIS {
                faces.push((motion.to.z, index));
            }
        }
        let of = |side: Facing| {
            let own = move |(own, _): &(&ToolUse, &Track)| turns(own) && facing(own) == side;
            uses.iter().zip(&tracks).filter(own).map(|(_, track)| track)
        };
        // A cut to the axis behind a turned stretch parts it off.
        let turned = of(Facing::Outwards).filter_map(|track| {
            track.highest_between(&positions, 2.0 * TO_AXIS, stock.diameter.radius() - SAME)
        });
        let turned = turned.fold(f64::NEG_INFINITY, f64::max);
        let face = if behind { stock.face.min(0.0) } else { stock.face };
        let is_face = |&(z, index): &(f64, usize)| {
            let [goes_on, ends] = IN_FRONT;
            let left = if tracks[index].continues_after(&positions, z) { goes_on } else { ends };
            z + left >= turned
        };
        let front = faces.iter().filter(|face| is_face(face)).map(|face| face.0).fold(face, f64::min);
        let outside = Surface::of(
            of(Facing::Outwards),
            (Facing::Outwards, positions.clone()),
            stock.diameter.radius(),
            (back, front),
        );
        let inside = Surface::of(
            of(Facing::Inwards),
            (Facing::Inwards, positions.clone()),
            stock.bore.radius(),
            (back, front),
        );
        Some(Self { tracks, positions, outside, inside, front })
    }

    /// Whether a grooving insert roughs in steps for other tools and also makes a few grooves. Only the
    /// grooves may be deeper than the surface that all tools leave.
    fn grooves(&self, index: usize, own: &ToolUse, tool: &Tool) -> bool {
        let surface = self.side(own).1;
        let track = &self.tracks[index];
        let steps = track.without_grooves(surface);
        let few = FEW * (track.plunges.len() - steps.plunges.len()) <= track.plunges.len();
        few && (is_tip_alone(tool) || !surface.is_gouged(&takes(tool), &steps, SHIFT))
    }

    fn side(&self, own: &ToolUse) -> (Facing, &Surface) {
        match own.is_inside() {
            true => (Facing::Inwards, &self.inside),
            false => (Facing::Outwards, &self.outside),
        }
    }

    /// Whether an insert on the path of this use leaves the surface intact, except for walls that it shifts
    /// by at most `shift`, mm.
    fn follows(&self, index: usize, own: &ToolUse, tool: &Tool, shift: f64) -> bool {
        !self.side(own).1.is_gouged(&takes(tool), &self.tracks[index], shift)
    }

    /// Whether a tool can do the work of a use.
    fn does(&self, index: usize, own: &ToolUse, tool: &Tool) -> bool {
        if tool.kind != Some(ToolKind::Grooving) && !is_tip_alone(tool) {
            return self.follows(index, own, tool, SHIFT);
        }
        let track = &self.tracks[index];
        let (facing, surface) = self.side(own);
        if !track.plunges.iter().any(|(z, _)| *z < self.front - SAME) {
            return false;
        }
        // Only the tip is known, so its path is the contour if it, or the path of another tool, covers all of
        // it.
        if is_tip_alone(tool) {
            if own.contour {
                return surface.clears_plunges(&track.without_last_step(&self.positions), self.front);
            }
            return surface.clears_plunges(track, self.front);
        }
        // Each corner of a grooving insert follows one wall of a groove, programmed in separate blocks. A
        // contour is made by one corner.
        let begins_at_face = track.continues_after(&self.positions, self.front);
        let is_groove = !own.contour && !begins_at_face && track.is_valley(&self.positions);
        let own_surface = Surface::of_one(track, (facing, self.positions.clone()));
        let parting = if own.is_inside() { f64::NEG_INFINITY } else { TO_AXIS };
        is_groove || !own_surface.is_gouged(&takes(tool), &track.without_parting(parting), SHIFT)
    }
}
