//! In: a program and both results. Out: whether the results agree, apart from known differences.

use std::collections::BTreeMap;

use gcode_playground::control::compensation::{Nose, Side};
use gcode_playground::geometry::{Point, Turn};
use gcode_playground::units::Unit;

use crate::canon;
use crate::contour::{Corner, InContour, Way, corner, unit};
use crate::known::{self, KnownDifference, Refused};
use crate::motion::{Feed, Motion, Origin, Run, Shape};
use crate::program::{Axis, Block, Count, Place, Program, places_of};
use crate::translate::millimetres;

/// Largest allowed distance between two points, mm.
const TOLERANCE: f64 = 0.001;
/// Rounding error of the four decimals that `rs274` prints in inches, mm.
const INCH_ROUNDING: f64 = 0.00005 * 25.4;

/// The result of a comparison.
#[derive(Clone, Debug, Default)]
pub struct Comparison {
    /// Number of equal motions.
    pub same: usize,
    /// Number of equal compensated elements.
    pub compensated: usize,
    /// Known differences.
    pub known: Vec<KnownDifference>,
    /// Our slug for an error that both report.
    pub both_refuse: Option<&'static str>,
    /// The first unknown difference.
    pub failure: Option<Failure>,
}

/// An unknown difference.
#[derive(Clone, Debug, PartialEq)]
pub struct Failure {
    /// What differs, worded the same for all such failures.
    pub what: String,
    /// The block.
    pub block: usize,
    /// The two values.
    pub detail: String,
}

/// Compares both results for a program.
pub fn compare(program: &Program, ours: &Run, theirs: &canon::Run) -> Comparison {
    let mut comparison = Comparison::default();
    let checked = Check { program, ours, theirs, places: program.places() }.run(&mut comparison);
    comparison.failure = checked.err();
    comparison
}

struct Check<'a> {
    program: &'a Program,
    ours: &'a Run,
    theirs: &'a canon::Run,
    places: Vec<Place>,
}

/// An element of a compensated contour in both results.
struct Element<'a> {
    block: usize,
    programmed: Way,
    ours: &'a Motion,
    theirs: &'a Motion,
    /// The motions before it, around the corner.
    around: [&'a [Motion]; 2],
}

impl Check<'_> {
    fn run(&self, comparison: &mut Comparison) -> Result<(), Failure> {
        let end = self.refusals(comparison)?;
        let mut section = None;
        for block in 0..end.unwrap_or(self.program.blocks.len()) {
            match (self.places[block], section) {
                (Place::Compensated(..), None) => section = Some(block),
                (Place::Plain, Some(first)) => {
                    self.contour(first, block, true, comparison)?;
                    section = None;
                }
                _ => {}
            }
            if section.is_none() {
                self.plain(block, comparison)?;
            }
        }
        if let Some(first) = section {
            // Compensation delays motions: those before a refusal may be missing on one side.
            let end = end.unwrap_or(self.program.blocks.len());
            self.contour(first, end.saturating_sub(2), false, comparison)?;
        }
        Ok(())
    }

    /// Compares the errors. Returns the block at which the comparison must end, if any.
    fn refusals(&self, comparison: &mut Comparison) -> Result<Option<usize>, Failure> {
        let (ours, theirs) = (&self.ours.refused, &self.theirs.refused);
        let compensated = |block: usize| {
            let first = block.saturating_sub(1);
            (first..=block).any(|block| matches!(self.places.get(block), Some(Place::Compensated(..))))
        };
        let refused = |at: usize, by_whom: &dyn Fn(&Refused) -> Option<KnownDifference>| {
            let block = *self.program.blocks.get(at)?;
            let remarks: Vec<&'static str> = self
                .ours
                .remarks
                .iter()
                .filter(|(remarked, _)| *remarked == at)
                .map(|(_, slug)| *slug)
                .collect();
            let arc_end_tolerance = match self.unit(at) {
                Unit::Millimetre => 0.02 * std::f64::consts::SQRT_2,
                Unit::Inch => 0.002 * std::f64::consts::SQRT_2 * 25.4,
            };
            let (contour, feed_unsaid) = (self.in_contour(at), self.feed_unsaid(at));
            by_whom(&Refused { block, contour, arc_end_tolerance, feed_unsaid, remarks: &remarks })
        };
        match (ours, theirs) {
            (None, None) => Ok(None),
            (Some((block, refusal)), Some((other, _)))
                if block == other || (block.abs_diff(*other) <= 2 && compensated(*block.max(other))) =>
            {
                comparison.both_refuse = Some(refusal.slug);
                Ok(Some(*block.min(other)))
            }
            (Some((block, refusal)), theirs) if theirs.as_ref().is_none_or(|(other, _)| block < other) => {
                let known = refused(*block, &|here| known::refused_by_ours(refusal, here));
                let detail = format!("only ours refuses: {}, {:?}", refusal.slug, refusal.message);
                comparison.known.push(known.ok_or(Failure {
                    what: format!("refusal by ours alone ({})", refusal.slug),
                    block: *block,
                    detail,
                })?);
                Ok(Some(*block))
            }
            (_, Some((block, message))) => {
                let known = refused(*block, &|here| known::refused_by_linuxcnc(message, here));
                let detail = format!("only LinuxCNC refuses: {message}");
                let reason = message.split(':').next().unwrap_or_default();
                let what = format!("refusal by LinuxCNC alone ({reason})");
                let failure = Failure { what, block: *block, detail };
                comparison.known.push(known.ok_or(failure)?);
                Ok(Some(*block))
            }
            (Some(_), None) => Ok(None),
        }
    }

    /// Whether the last feed setting was a code for the unit of F without an F word.
    fn feed_unsaid(&self, block: usize) -> bool {
        let before = self.program.blocks.iter().take(block + 1).rev();
        let mut said = before.filter_map(|block| match block {
            Block::Feed { feed, .. } => Some(feed.is_none()),
            Block::Straight { feed: Some(_), .. } | Block::Arc { feed: Some(_), .. } => Some(false),
            _ => None,
        });
        said.next().unwrap_or(false)
    }

    /// Position of a block in a contour under compensation.
    fn in_contour(&self, block: usize) -> Option<InContour> {
        let is_nose = |block: &usize| matches!(self.program.blocks.get(*block), Some(Block::Nose { .. }));
        let first = (0..=block).rev().find(is_nose)?;
        let Some(&Place::Compensated(side, _)) = self.places.get(first) else { return None };
        let ways = self.ways(first);
        // A block that does not move, such as G40, counts as following the last element.
        let at = ways.iter().filter(|(at, _)| *at < block).count();
        let corner_at = |first: usize| Some(corner(&ways.get(first)?.1, &ways.get(first + 1)?.1, side));
        Some(InContour {
            index: at,
            fits_exactly: at.checked_sub(1).is_some_and(|before| self.fits_exactly(ways[before].0, block)),
            unfinished: self.places[first..].iter().all(|place| *place != Place::Plain),
            after_circle: at.checked_sub(1).is_some_and(|before| ways[before].1.is_circle()),
            entry: corner_at(0).unwrap_or(Corner::Open),
            last_but_one: at.checked_sub(2).and_then(corner_at).unwrap_or(Corner::Open),
            before: at.checked_sub(1).and_then(corner_at).unwrap_or(Corner::Open),
            after: corner_at(at).unwrap_or(Corner::Open),
        })
    }

    /// Whether our motions of two blocks meet in the same or in opposite directions, or nothing is left of
    /// the first.
    fn fits_exactly(&self, first: usize, second: usize) -> bool {
        let (Some(first), Some(second)) = (self.ours_at(first).last(), self.ours_at(second).first()) else {
            return self.ours_at(first).is_empty();
        };
        let way = |motion: &Motion| Way {
            from: motion.from,
            to: motion.to,
            arc: match motion.shape {
                Shape::Arc { center, turn } => Some((center, turn)),
                _ => None,
            },
        };
        let ((x1, z1), (x2, z2)) = (way(first).direction(first.to), way(second).direction(second.from));
        (z1 * x2 - x1 * z2).abs() < 1e-3
    }

    /// The programmed elements, read from the words, of the contour whose compensation begins at `first`.
    fn ways(&self, first: usize) -> Vec<(usize, Way)> {
        let compensated = (first..self.places.len()).take_while(|&block| self.places[block] != Place::Plain);
        let blocks: Vec<usize> = compensated.filter(|&block| self.program.blocks[block].moves()).collect();
        let first_motion = blocks.iter().find_map(|&block| match self.ours_at(block).last()?.origin {
            Origin::Compensated(programmed) => Some(programmed.from),
            Origin::Program => None,
        });
        let before = self.ours.motions.range(..first).next_back().and_then(|(_, motions)| motions.last());
        let start = Point::new(millimetres(self.program.start.0) / 2.0, millimetres(self.program.start.1));
        let mut at = first_motion.or(before.map(|motion| motion.to)).unwrap_or(start);
        let unit = self.unit(first);
        let length = |count: Count| count as f64 / 10f64.powi(places_of(unit) as i32) * unit.millimetres();
        let moved = |axis: Axis, from: f64, scale: f64| match axis {
            Axis::Stay => from,
            Axis::To(count) => length(count) * scale,
            Axis::By(count) => from + length(count) * scale,
        };
        let way = |block: usize| {
            let (x, z, arc) = match self.program.blocks[block] {
                Block::Straight { x, z, .. } => (x, z, None),
                Block::Arc { x, z, center, turn, .. } => (x, z, Some((center, turn))),
                _ => return None,
            };
            let from = at;
            at = Point::new(moved(x, from.x, 0.5), moved(z, from.z, 1.0));
            let arc = arc.map(|(center, turn)| {
                let (i, k) = (length(center.i.unwrap_or(0)), length(center.k.unwrap_or(0)));
                (Point::new(from.x + i, from.z + k), turn)
            });
            Some((block, Way { from, to: at, arc }))
        };
        blocks.into_iter().filter_map(way).collect()
    }

    /// Compares a block outside of compensation: the motions must be equal.
    fn plain(&self, block: usize, comparison: &mut Comparison) -> Result<(), Failure> {
        let moving = |motions: &[Motion]| -> Vec<Motion> {
            motions.iter().filter(|motion| !motion.is_still()).copied().collect()
        };
        let (ours, mut theirs) = (moving(self.ours_at(block)), moving(self.theirs_at(block)));
        if ours.is_empty() {
            // In inches, rounding can turn a move to the current position into a short one.
            theirs.retain(|motion| {
                motion.may_stay() || motion.from.distance(motion.to) > self.tolerance(block)
            });
        }
        if let (Block::Arc { center, .. }, [], [circle]) =
            (self.program.blocks[block], &ours[..], &theirs[..])
            && center.r.is_some()
            && circle.from.distance(circle.to) <= self.tolerance(block)
        {
            comparison.known.push(KnownDifference::ArcNowhere);
            return Ok(());
        }
        if ours.len() != theirs.len() {
            let detail = format!("ours makes {} motions, LinuxCNC {}", ours.len(), theirs.len());
            return Err(Failure { what: "number of motions".into(), block, detail });
        }
        for (ours, theirs) in ours.iter().zip(&theirs) {
            self.same_shape(block, ours, theirs)?;
            self.same_place("start", block, ours.from, theirs.from)?;
            self.same_place("end", block, ours.to, theirs.to)?;
            comparison.same += 1;
        }
        Ok(())
    }

    fn same_shape(&self, block: usize, ours: &Motion, theirs: &Motion) -> Result<(), Failure> {
        let differs = |what: &str| {
            let detail = format!("ours {ours:?}\nLinuxCNC {theirs:?}");
            Err(Failure { what: String::from(what), block, detail })
        };
        let near = |one: f64, other: f64| (one - other).abs() <= 2.0 * INCH_ROUNDING + 1e-9 * one.abs();
        match (ours.shape, theirs.shape) {
            (Shape::Rapid, Shape::Rapid) => return Ok(()),
            (Shape::Line, Shape::Line) => {}
            (Shape::Thread { lead: one }, Shape::Thread { lead: other }) => {
                return if near(one, other) { Ok(()) } else { differs("lead") };
            }
            (Shape::Dwell { seconds: one }, Shape::Dwell { seconds: other }) => {
                return if (one - other).abs() <= 1e-4 { Ok(()) } else { differs("time") };
            }
            (Shape::Arc { center: one, turn }, Shape::Arc { center: other, turn: their_turn }) => {
                if turn != their_turn {
                    return differs("direction");
                }
                self.same_place("centre", block, one, other)?;
            }
            _ => return differs("kind"),
        }
        let same_feed = match (ours.feed, theirs.feed) {
            (Some(Feed::PerMinute(one)), Some(Feed::PerMinute(other)))
            | (Some(Feed::PerTurn(one)), Some(Feed::PerTurn(other))) => near(one, other),
            _ => false,
        };
        if same_feed { Ok(()) } else { differs("feed") }
    }

    fn same_place(
        &self,
        what: &'static str,
        block: usize,
        ours: Point,
        theirs: Point,
    ) -> Result<(), Failure> {
        let far = ours.distance(theirs);
        if far <= self.tolerance(block) {
            return Ok(());
        }
        let show = |point: Point| format!("X(radius) {:.5} Z {:.5}", point.x, point.z);
        let detail = format!("ours {}, LinuxCNC {}: {far:.5} mm apart", show(ours), show(theirs));
        Err(Failure { what: what.into(), block, detail })
    }

    /// Compares the blocks under compensation from `first` up to `end`. `whole` is whether the contour is
    /// known to end there.
    fn contour(
        &self,
        first: usize,
        end: usize,
        whole: bool,
        comparison: &mut Comparison,
    ) -> Result<(), Failure> {
        let Some(&Place::Compensated(side, tip)) = self.places.get(first) else { return Ok(()) };
        let nose = Nose { radius: millimetres(self.program.nose), tip };
        let ways: BTreeMap<usize, Way> = self.ways(first).into_iter().collect();
        let mut elements = Vec::new();
        let mut whole = whole;
        for block in first..end {
            let way = ways.get(&block).copied();
            match self.element(block, way)? {
                Some(element) => elements.push(element),
                None if way.is_none() => {}
                // The corners remove the whole element, so the next one begins elsewhere.
                None => {
                    whole = false;
                    break;
                }
            }
        }
        let corners: Vec<Corner> =
            elements.windows(2).map(|pair| corner(&pair[0].programmed, &pair[1].programmed, side)).collect();
        for (index, element) in elements.iter().enumerate() {
            let at = |index: Option<usize>| index.and_then(|index| corners.get(index)).copied();
            let before = at(index.checked_sub(1)).unwrap_or(Corner::Open);
            let after = at(Some(index)).unwrap_or(Corner::Open);
            let (is_entry, after_entry) = (index == 0, index == 1);
            let near = [before, after].iter().any(|corner| matches!(corner, Corner::Near | Corner::Back));
            let kind = |shape: Shape| std::mem::discriminant(&shape);
            if near && kind(element.ours.shape) == kind(element.theirs.shape) {
                // Direction and end points may differ.
            } else {
                self.same_shape(element.block, element.ours, element.theirs)?;
            }
            if !is_entry && !near {
                for motion in [element.ours, element.theirs] {
                    self.on_offset_path(element, motion, side, nose)?;
                }
            }
            let same_start = match before {
                Corner::Open => is_entry,
                Corner::Straight => true,
                Corner::Inner => !after_entry,
                Corner::Outer => after_entry,
                Corner::Near | Corner::Back => false,
            };
            let same_end = match after {
                Corner::Open => whole,
                Corner::Straight => true,
                Corner::Inner => !is_entry,
                Corner::Outer | Corner::Near | Corner::Back => false,
            };
            if same_start {
                self.same_place("start", element.block, element.ours.from, element.theirs.from)?;
            }
            if same_end {
                self.same_place("end", element.block, element.ours.to, element.theirs.to)?;
            }
            self.around_corner(element, before, nose)?;
            comparison.compensated += 1;
            comparison.known.extend(match (before, after_entry) {
                (Corner::Near, _) => Some(KnownDifference::NearlyStraight),
                (Corner::Back, _) => Some(KnownDifference::StraightBack),
                (Corner::Inner | Corner::Outer, true) => Some(KnownDifference::StartUp),
                (Corner::Outer, false) => Some(KnownDifference::OuterCorner),
                _ => None,
            });
        }
        Ok(())
    }

    /// The element of a block under compensation, if it moves. Dwells are compared here.
    fn element(&self, block: usize, programmed: Option<Way>) -> Result<Option<Element<'_>>, Failure> {
        let (ours, theirs) = (self.ours_at(block), self.theirs_at(block));
        let Some(programmed) = programmed else {
            if ours.len() != theirs.len() {
                return Err(Failure {
                    what: "dwell".into(),
                    block,
                    detail: format!("ours {ours:?}\nLinuxCNC {theirs:?}"),
                });
            }
            for (ours, theirs) in ours.iter().zip(theirs) {
                self.same_shape(block, ours, theirs)?;
            }
            return Ok(None);
        };
        let (Some((ours, ours_around)), Some((theirs, theirs_around))) =
            (ours.split_last(), theirs.split_last())
        else {
            let detail = format!("ours makes {} motions, LinuxCNC {}", ours.len(), theirs.len());
            return if ours.is_empty()
                && theirs.iter().all(|motion| motion.from.distance(motion.to) <= TOLERANCE)
            {
                Ok(None)
            } else {
                Err(Failure { what: "number of motions".into(), block, detail })
            };
        };
        Ok(Some(Element { block, programmed, ours, theirs, around: [ours_around, theirs_around] }))
    }

    /// Checks that both motions lie on the programmed element offset by the nose radius.
    fn on_offset_path(
        &self,
        element: &Element,
        motion: &Motion,
        side: Side,
        nose: Nose,
    ) -> Result<(), Failure> {
        let Way { from, to, arc } = element.programmed;
        let center = arc.map(|(center, _)| center);
        let tip = nose.vector();
        // The path is offset for the centre of the nose, not for its tip.
        let at = |point: Point| Point::new(point.x + tip.x * nose.radius, point.z + tip.z * nose.radius);
        let left = if side == Side::Left { 1.0 } else { -1.0 };
        let off = |point: Point| match (center, motion.shape) {
            (Some(center), Shape::Arc { turn, .. }) => {
                let inside = if turn == Turn::Counterclockwise { left } else { -left };
                at(point).distance(center) - (from.distance(center) - inside * nose.radius)
            }
            _ => {
                let (x, z) = unit(from, to);
                let point = at(point);
                left * (z * (point.x - from.x) - x * (point.z - from.z)) - nose.radius
            }
        };
        let (begin, end) = (off(motion.from), off(motion.to));
        // Ends of arcs may be off the circle by the arc tolerance.
        let allowed = self.tolerance(element.block) + if center.is_some() { TOLERANCE } else { 0.0 };
        if begin.abs() <= allowed && end.abs() <= allowed {
            return Ok(());
        }
        let detail = format!("{begin:.5} mm off at the start, {end:.5} mm at the end: {motion:?}");
        Err(Failure { what: "not on the offset path".into(), block: element.block, detail })
    }

    /// Compares the motions around the corner before an element.
    fn around_corner(&self, element: &Element, corner: Corner, nose: Nose) -> Result<(), Failure> {
        let [ours, theirs] = element.around;
        let block = element.block;
        let tip = nose.vector();
        let from = element.programmed.from;
        let middle = Point::new(from.x - tip.x * nose.radius, from.z - tip.z * nose.radius);
        // Where a joint is tangent apart from rounding, our motion may be too short to see.
        let seen = |motion: &&Motion| motion.from.distance(motion.to) > TOLERANCE;
        let moves = |motions: &[Motion]| motions.iter().filter(seen).count();
        match corner {
            Corner::Outer => {
                for motion in theirs {
                    let Shape::Arc { center, .. } = motion.shape else { continue };
                    self.same_place("centre of the corner", block, middle, center)?;
                }
                if ours.iter().any(|motion| !matches!(motion.shape, Shape::Line | Shape::Rapid)) {
                    return Err(Failure { what: "corner".into(), block, detail: format!("{ours:?}") });
                }
            }
            Corner::Near | Corner::Back => {}
            _ if moves(ours) + moves(theirs) > 0 => {
                let detail = format!("{corner:?} corner: ours {ours:?}\nLinuxCNC {theirs:?}");
                return Err(Failure { what: "motions around a corner".into(), block, detail });
            }
            _ => {}
        }
        Ok(())
    }

    fn ours_at(&self, block: usize) -> &[Motion] {
        self.ours.motions.get(&block).map_or(&[], Vec::as_slice)
    }

    fn theirs_at(&self, block: usize) -> &[Motion] {
        self.theirs.motions.get(&block).map_or(&[], Vec::as_slice)
    }

    /// Unit in force at a block.
    fn unit(&self, block: usize) -> Unit {
        let before = self.program.blocks.iter().take(block + 1).rev();
        let mut units = before.filter_map(|block| match block {
            Block::Unit(unit) => Some(*unit),
            _ => None,
        });
        units.next().unwrap_or(Unit::Millimetre)
    }

    /// Largest allowed distance between two points in a block, mm. Positions printed in inches are coarse,
    /// and so are positions that include an offset printed in inches.
    fn tolerance(&self, block: usize) -> f64 {
        let blocks = &self.program.blocks[..=block.min(self.program.blocks.len() - 1)];
        match blocks.contains(&Block::Unit(Unit::Inch)) {
            true => TOLERANCE + 4.0 * INCH_ROUNDING,
            false => TOLERANCE,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion;
    use crate::program::{Code, Joined, Straight};

    fn line(x: Count, z: Count) -> Block {
        let (x, z) = (Axis::To(x), Axis::To(z));
        Block::Straight { kind: Straight::Feed, x, z, feed: Some(100_000), code: Code::Written }
    }

    /// Compares blocks with output of `rs274`. Returns the known differences, or the failure.
    fn check(blocks: Vec<Block>, printed: &str) -> Result<Vec<KnownDifference>, String> {
        let program = Program { start: (40_000, 0), nose: 1_000, blocks };
        let printed = format!(
            "1 N... STRAIGHT_TRAVERSE(20, 0, 0, 0, 0, 0)\n1 N... SET_FEED_RATE(100.0)\n1 N... COMMENT(\"P0\")\n{printed}"
        );
        let theirs = canon::read(&printed).unwrap().remove(&0).unwrap();
        let comparison = compare(&program, &motion::ours(&program).unwrap(), &theirs);
        comparison.failure.map_or(Ok(comparison.known), |failure| Err(failure.what))
    }

    #[test]
    fn motions_are_held_against_each_other() {
        let printed = |x: &str| format!("1 N0 COMMENT(\"B0\")\n2 N0 STRAIGHT_FEED({x}, 0, -5, 0, 0, 0)");
        assert_eq!(check(vec![line(50_000, -5_000)], &printed("25.0004")), Ok(vec![]));
        assert_eq!(check(vec![line(50_000, -5_000)], &printed("25.0020")), Err("end".into()));
        assert_eq!(
            check(vec![line(50_000, -5_000)], "1 N0 COMMENT(\"B0\")"),
            Err("number of motions".into())
        );
        let rapid = printed("25").replace("FEED", "TRAVERSE");
        assert_eq!(check(vec![line(50_000, -5_000)], &rapid), Err("kind".into()));
    }

    #[test]
    fn under_compensation_an_outer_corner_may_differ_and_the_elements_may_not() {
        let blocks = vec![
            Block::Nose { side: Side::Left, tip: 0, joined: Joined::Alone },
            line(40_000, -5_000),
            line(40_000, -20_000),
            line(60_000, -20_000),
            Block::NoseOff { joined: Joined::Alone },
            line(80_000, -30_000),
        ];
        let printed = |x: &str| {
            format!(
                "1 N1 COMMENT(\"B1\")\n2 N1 STRAIGHT_FEED({x}, 0, -5, 0, 0, 0)\n\
                 1 N2 COMMENT(\"B2\")\n2 N2 STRAIGHT_FEED({x}, 0, -20, 0, 0, 0)\n\
                 1 N3 COMMENT(\"B3\")\n2 N3 ARC_FEED(-21, 20, -20, 20, -1, 0)\n\
                 2 N3 STRAIGHT_FEED(30, 0, -21, 0, 0, 0)\n\
                 1 N5 COMMENT(\"B5\")\n2 N5 STRAIGHT_FEED(40, 0, -30, 0, 0, 0)"
            )
        };
        assert_eq!(check(blocks.clone(), &printed("19")), Ok(vec![KnownDifference::OuterCorner]));
        assert_eq!(check(blocks, &printed("18.99")), Err("end".into()));
    }

    #[test]
    fn a_refusal_by_one_side_alone_is_told() {
        let arc = |z| Block::Arc {
            turn: Turn::Clockwise,
            x: Axis::By(10_000),
            z: Axis::By(z),
            center: crate::program::Center { r: None, i: Some(5_000), k: None },
            feed: Some(100_000),
            code: Code::Written,
        };
        let printed = "1 N0 COMMENT(\"B0\")\n2 N0 ARC_FEED(5, 25, 0, 25, -1, 0)";
        assert_eq!(check(vec![arc(5_020)], printed), Ok(vec![KnownDifference::ArcEnd]));
        assert_eq!(
            check(vec![arc(5_100)], printed),
            Err("refusal by ours alone (arc-end-off-circle)".into())
        );
    }
}
