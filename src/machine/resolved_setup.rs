//! The tools and the blank of a run: from the setup, or inferred if the setup does not give them.
//!
//! In: the setup and the motions. Out: a shape for each motion, and for everything whether it is given or
//! inferred.

use std::collections::BTreeSet;

use super::inferred::InferredSetup;
use super::sweep::Outline;
use super::thread_point::{for_pitch, leads};
use super::tool::{Action, DRILL, Shape, over_edge};
use super::tool_use::Purpose;
use crate::geometry::{Point, SAME};
use crate::motion::{CycleFamily, Motion, Motions};
use crate::setup::{Blank, DescribedNose, Setup, Side, Stock, Tool, ToolKind};
use crate::units::Diameter;

/// The origin of a tool or a blank.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Basis {
    /// The setup, or a comment of the program.
    Given,
    /// Inferred from the program.
    Inferred,
    /// Unknown: each possible tool would cut into the contour. It removes nothing.
    Unknown,
}

/// A tool with its shape.
#[derive(Clone, Debug, PartialEq)]
pub struct ResolvedTool {
    /// Turret station.
    pub station: u16,
    /// The tool.
    pub tool: Tool,
    /// Its shape.
    pub shape: Shape,
    /// The outline that removes material along its path.
    pub takes: Outline,
    /// Whether it is given or inferred.
    pub basis: Basis,
    /// Whether comments describe something that cannot cut, such as a bar stop.
    cuts_nothing: bool,
}

/// Size of the part of an inferred tool that is checked for collisions, as a share of the tool: the rest is
/// unknown.
const TIP: f64 = 0.02;

/// Least depth of the tip of an inferred tool in the workpiece to be reported, mm: the surface left by its
/// real edges is not known more exactly.
const DEPTH: f64 = 0.5;

/// Tools and blank.
#[derive(Clone, Debug)]
pub struct ResolvedSetup {
    given: Vec<(u16, u16, ResolvedTool)>,
    inferred: Vec<(u16, Purpose, ResolvedTool)>,
    /// The tool if no other is known, in a program without cuts.
    other: ResolvedTool,
    blank: Option<(Blank, Basis)>,
    /// The first motion of each tool that is neither given nor can be inferred.
    unknown: Vec<usize>,
}

impl ResolvedSetup {
    /// The tools and the blank of a program that has run.
    pub fn new(motions: &Motions, setup: &Setup) -> Self {
        let inferred =
            InferredSetup::with(motions, &setup.described_tools, setup.described_stock, setup.extents());
        let leads = leads(motions);
        let for_pitch = |station: u16, tool: &Tool| for_pitch(tool, leads.get(&station).copied());
        let shaped = setup.tools.iter().filter(|(_, tool)| !tool.has_only_offsets());
        let given = shaped.filter_map(|(name, tool)| {
            let (station, offset) = station_of(name)?;
            Some((station, offset, ResolvedTool::given(station, for_pitch(station, tool))))
        });
        let mut given: Vec<_> = given.collect();
        let mut unknown = inferred.unknown.clone();
        unknown.retain(|&index| given.iter().all(|own| own.0 != motions.get(index).process.tool.0));
        let unknown_uses: Vec<_> = unknown
            .iter()
            .map(|&index| motions.get_on_workpiece(index).on_positive_side())
            .map(|motion| (motion.process.tool.0, Purpose::of(&motion)))
            .collect();
        let inferred_tools = inferred.tools().map(|(station, purpose, tool)| {
            let nose = setup.described_nose(station);
            let tool = nose.map_or_else(|| tool.clone(), |nose| with_nose(tool, nose));
            let mut tool = ResolvedTool::inferred(station, for_pitch(station, &tool));
            if unknown_uses.contains(&(station, purpose)) {
                tool.basis = Basis::Unknown;
            }
            tool.cuts_nothing = setup.described_tools.get(&station) == Some(&Tool::default());
            if tool.cuts_nothing && purpose == Purpose::Hole {
                tool.takes = Outline::default();
            }
            if purpose == Purpose::Live {
                tool.shape.action = Action::Live;
            }
            (station, purpose, tool)
        });
        let blank = setup.stock.clone().map(|blank| (blank, Basis::Given));
        if given.iter().any(|(.., tool)| tool.is_drill()) {
            let stations = live_drills(motions);
            for (station, _, tool) in &mut given {
                if tool.is_drill() && stations.contains(station) {
                    tool.shape.action = Action::Live;
                }
            }
        }
        Self {
            unknown,
            given,
            inferred: inferred_tools.collect(),
            other: ResolvedTool::inferred(0, Tool::default()),
            blank: blank.or_else(|| inferred.stock.map(|stock| (stock.into(), Basis::Inferred))),
        }
    }

    /// The tool of a motion: the given tool with its station and offset, the given tool with its station, or
    /// the inferred tool for its purpose.
    pub fn tool(&self, motion: &Motion) -> &ResolvedTool {
        let (station, offset) = motion.process.tool;
        let own = self.given.iter().filter(|given| given.0 == station);
        let given = own.clone().find(|given| given.1 == offset).or_else(|| own.clone().next());
        if let Some((.., tool)) = given {
            return tool;
        }
        let purpose = Purpose::of(motion);
        let own = self.inferred.iter().filter(|inferred| inferred.0 == station);
        let inferred = own.clone().find(|inferred| inferred.1 == purpose).or_else(|| own.clone().next());
        inferred.map_or(&self.other, |(.., tool)| tool)
    }

    /// Whether the setup names tools, but none for this station.
    pub fn lacks_tool(&self, station: u16) -> bool {
        station > 0 && !self.given.is_empty() && self.given.iter().all(|given| given.0 != station)
    }

    /// The first motion of each tool that is neither given nor can be inferred, because each tool that was
    /// tried would cut into the contour.
    pub fn unknown(&self) -> &[usize] {
        &self.unknown
    }

    /// Whether there is a part to show: a blank, and, if there are cuts, a tool that removes material.
    pub fn shows_part(&self) -> bool {
        let all_unknown = || self.tools().all(|tool| tool.basis == Basis::Unknown);
        self.blank.is_some() && (self.unknown.is_empty() || !all_unknown())
    }

    /// The blank, and whether it is given or inferred.
    pub fn blank(&self) -> Option<(&Blank, Basis)> {
        self.blank.as_ref().map(|(blank, basis)| (blank, *basis))
    }

    /// The extents of the blank, and whether it is given or inferred.
    pub fn stock(&self) -> Option<(Stock, Basis)> {
        self.blank().map(|(blank, basis)| (blank.extents(), basis))
    }

    /// Whether one of its tools is a live drill.
    pub fn has_live_drill(&self) -> bool {
        self.tools().any(ResolvedTool::is_live_drill)
    }

    /// All tools that the program uses or the setup names.
    pub fn tools(&self) -> impl Iterator<Item = &ResolvedTool> {
        let covered = |station: u16| self.given.iter().any(|given| given.0 == station);
        let inferred =
            self.inferred.iter().filter(move |inferred| !covered(inferred.0)).map(|(.., tool)| tool);
        self.given.iter().map(|(.., tool)| tool).chain(inferred)
    }
}

/// The stations of live drills and taps: those that drill the side of the workpiece, and those between whose
/// moves C turns, unless they also drill on the axis.
fn live_drills(motions: &Motions) -> BTreeSet<u16> {
    let (mut live, mut on_axis) = (BTreeSet::new(), BTreeSet::new());
    for motion in motions.on_workpiece() {
        let side = motion.cycle.is_some_and(|step| step.cycle.family() == CycleFamily::SideHole);
        let station = motion.process.tool.0;
        if motion.rotary.is_some() || side {
            live.insert(station);
        } else if motion.kind.cuts() && Purpose::of(&motion) == Purpose::Hole {
            on_axis.insert(station);
        }
    }
    &live - &on_axis
}

impl ResolvedTool {
    /// Whether the tool is live in a motion, which then removes nothing all around the axis: a live cutter,
    /// any tool while C turns or in a hole of the side, and a drill or tap in a hole cycle off the axis.
    pub fn is_live_in(&self, motion: &Motion) -> bool {
        let family = motion.cycle.map(|step| step.cycle.family());
        let reach = self.tool.diameter.unwrap_or(DRILL).radius();
        let beside_axis = motion.from.x.min(motion.to.x) >= reach - SAME;
        self.shape.action == Action::Live
            || motion.rotary.is_some()
            || family == Some(CycleFamily::SideHole)
            || self.is_drill() && beside_axis && family == Some(CycleFamily::FaceHole)
    }

    /// The diameter assumed for an inferred drill if neither setup nor comments give one.
    pub fn assumed_diameter(&self) -> Option<Diameter> {
        let is_inferred = self.basis != Basis::Given && self.tool.kind == Some(ToolKind::Drill);
        let is_drill = is_inferred && !self.cuts_nothing;
        (is_drill && self.tool.diameter.is_none()).then_some(DRILL)
    }

    /// Whether it is a drill or tap that is live in all its motions.
    pub fn is_live_drill(&self) -> bool {
        self.is_drill() && self.shape.action == Action::Live
    }

    fn is_drill(&self) -> bool {
        matches!(self.tool.kind, Some(ToolKind::Drill | ToolKind::Tap))
    }

    fn given(station: u16, tool: Tool) -> Self {
        let shape = Shape::of(&tool);
        Self { station, takes: shape.edge.clone(), shape, tool, basis: Basis::Given, cuts_nothing: false }
    }

    /// Whether it is an assumed tool that works from outside.
    pub fn is_assumed_outside(&self) -> bool {
        let kind = matches!(self.tool.kind, Some(ToolKind::Turning | ToolKind::Grooving));
        self.basis != Basis::Given && kind && self.tool.working_side() == Side::Outside
    }

    fn inferred(station: u16, tool: Tool) -> Self {
        let mut shape = Shape::of(&tool);
        // The position of the point in an inferred threading tool is unknown, too.
        shape.core = match tool.kind {
            Some(ToolKind::Threading) => Outline::default(),
            _ => inner(&tool, &shape.edge).near_tip(TIP),
        };
        shape.body = None;
        let takes = over_edge(&tool, &shape);
        Self { station, shape, takes, tool, basis: Basis::Inferred, cuts_nothing: false }
    }
}

/// The part of the edge of an inferred tool that lies [`DEPTH`] inside it. In a needle or a narrow grooving
/// insert no point lies that deep on all sides, so the depth is measured along the axis of the tool.
fn inner(tool: &Tool, edge: &Outline) -> Outline {
    let inner = edge.shrunk(DEPTH);
    if inner.points().len() > 2 {
        return inner;
    }
    let inside = if tool.kind == Some(ToolKind::Boring) { Side::Inside } else { Side::Outside };
    let inwards = match tool.side.unwrap_or(inside) {
        Side::Outside => Point::new(1.0, 0.0),
        Side::Inside => Point::new(-1.0, 0.0),
        Side::Face => Point::new(0.0, 1.0),
    };
    edge.beyond(DEPTH, inwards)
}

/// An inferred tool with the nose that a comment describes, because compensation uses it, too.
fn with_nose(tool: &Tool, nose: &DescribedNose) -> Tool {
    match tool.kind {
        Some(ToolKind::Turning | ToolKind::Boring) => {
            Tool { nose_radius: Some(nose.radius), tip: Some(nose.tip), ..tool.clone() }
        }
        _ => tool.clone(),
    }
}

/// Station and offset of a T word such as `T0101`.
fn station_of(name: &str) -> Option<(u16, u16)> {
    let digits = name.strip_prefix(['T', 't'])?;
    if digits.is_empty() || digits.len() > 4 || !digits.bytes().all(|byte| byte.is_ascii_digit()) {
        return None;
    }
    let number: u16 = digits.parse().ok()?;
    Some(if digits.len() <= 2 { (number, number) } else { (number / 100, number % 100) })
}
