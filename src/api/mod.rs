//! The data structures that leave the crate: rows for JavaScript and for the JSON output of the command line.
//!
//! In: motions and messages. Out: rows, plain data in user conventions: lengths in mm, X is a diameter, lines
//! and columns count from 1, columns in UTF-16 units. A row is one serialised object, for example one line of
//! JSON output. No other room derives `Serialize`, except for `units::Diameter`, which these rows contain
//! (`tests/rooms.rs`). The TypeScript types are generated from these rows.

pub mod assist;
pub mod calculate;
mod converted;
pub mod difference;
pub mod exercise;
mod inferred_stock;
mod manual;
pub mod paste;
mod profiles;
mod read_as;
mod readout;
mod rewrite;
mod rules;
mod settings;
pub mod setup;
mod tidied;
mod units;

use serde::Serialize;

pub use converted::{Converted, LeftWord};
pub use inferred_stock::{InferredStock, StockRow};
pub use manual::{ElementNote, InManual};
pub use profiles::Profiles;
pub use read_as::{ReadAs, ReadFact};
pub use readout::{Readout, Shown, Stop, Time};
pub use rewrite::Rewriting;
pub use rules::{Rule, RulePage};
pub use tidied::Tidied;
pub use units::Units;

use crate::control::codes;
use crate::control::offsets::STANDARD_FRAMES;
use crate::current::measuring;
use crate::figures::measure::{self, Measured, Picked};
use crate::geometry::Point;
use crate::geometry::virtual_plane::{Flat, Surface, VirtualMove, Way};
use crate::machine::compare;
use crate::machine::feature::{Feature, Shape};
use crate::machine::live_holes::LiveHole;
use crate::machine::region::{Piece, Region};
use crate::message::{self, Severity};
use crate::motion::{self, MotionKind, Motions, StopKind};
use crate::playback::timing;
use crate::playback::totals::ToolTotals;
use crate::run::Run;
use crate::sentences::{Language, describe_motion};
use crate::setup::dialect::CodeList;
use crate::setup::{Machine, tool_word};
use crate::source::{LineIndex, Span};
use crate::units::{Diameter, Unit};

#[cfg(target_arch = "wasm32")]
use tsify::Tsify;

/// A message with its place, in a language.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
#[serde(rename_all = "camelCase")]
pub struct Diagnostic {
    /// First line, from 1.
    pub line: u32,
    /// First column, from 1, in UTF-16 units.
    pub column: u32,
    /// Last line.
    pub end_line: u32,
    /// One past the last column.
    pub end_column: u32,
    /// UTF-16 offset of the start in the original text, where CR LF counts as two units. In the page's
    /// internal protocol each line end counts as one.
    pub from: u32,
    /// UTF-16 offset of the end.
    pub to: u32,
    /// An alarm number, or a letter and a name. Only codes of errors have the letter E; W, I and N do not
    /// give the severity.
    pub code: String,
    /// Slug of the rule, such as `lead-missing`; it does not change.
    pub slug: String,
    /// Its severity.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "\"error\" | \"warning\" | \"info\""))]
    pub severity: String,
    /// Whether the program is wrong, the playground does not support something, or the answer depends on the
    /// machine.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "\"wrong\" | \"unsupported\" | \"machine\""))]
    pub kind: String,
    /// The message, one sentence.
    pub message: String,
    /// The reason, and what to do.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub help: Option<String>,
    /// The alarm of the control as it is displayed; absent if a control raises none.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub alarm: Option<String>,
    /// Suggested fixes.
    pub fixes: Vec<Fix>,
}

/// A key of a configuration with its value and source.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Configured {
    /// The key.
    pub key: String,
    /// Its value.
    pub value: String,
    /// The source of the value: a file with its line, or an option. `None` for a default.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub from: Option<String>,
}

/// A row about a file; the file name is the first field.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct InFile<'a, T> {
    /// The file name, as given by the user.
    pub file: &'a str,
    /// The row.
    #[serde(flatten)]
    pub row: T,
}

/// A row about a message, with the title and the page of its rule.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct OfRule<T> {
    /// The row.
    #[serde(flatten)]
    pub row: T,
    /// The title of the rule.
    pub title: &'static str,
    /// The address of the page of the rule, if it is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub url: Option<String>,
}

/// A fix for a fault.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct Fix {
    /// Description of the fix.
    pub title: String,
    /// Whether it can be applied without asking the user.
    pub safe: bool,
    /// Its text edits.
    pub edits: Vec<Edit>,
    /// The setting to change in the setup, for a fix without text edits.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub setting: Option<Setting>,
}

/// A setting and its value.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct Setting {
    /// Key, as in the setup form: `dialect.pqUnit`.
    pub key: String,
    /// The value to enter in the form. Absent if only the user knows it.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub value: Option<String>,
}

/// A text edit: replaces a range of the text.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
#[serde(rename_all = "camelCase")]
pub struct Edit {
    /// First line, from 1.
    pub line: u32,
    /// First column, from 1.
    pub column: u32,
    /// Last line.
    pub end_line: u32,
    /// One past the last column.
    pub end_column: u32,
    /// UTF-16 offset of the start.
    pub from: u32,
    /// UTF-16 offset of the end.
    pub to: u32,
    /// The new text.
    pub text: String,
}

/// A position of the tool, or a point of the part.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct Place {
    /// X as a diameter, mm.
    pub x: Diameter,
    /// Z, mm.
    pub z: f64,
    /// Angle of C, degrees. Under polar interpolation, the second axis of the virtual plane, mm.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub c: Option<f64>,
    /// Y, mm, for moves on a machine with a Y axis.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub y: Option<f64>,
}

/// The machine position of a move in a virtual plane.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct MachinePlace {
    /// X as a diameter, mm.
    pub x: Diameter,
    /// Angle of C, degrees, not reduced to one turn.
    #[serde(rename = "c_deg")]
    pub c: f64,
}

/// One motion.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct Motion {
    /// The kind of motion.
    #[cfg_attr(
        target_arch = "wasm32",
        tsify(type = "\"rapid\" | \"feed\" | \"arc\" | \"thread\" | \"dwell\"")
    )]
    pub kind: &'static str,
    /// End point.
    pub to: Place,
    /// Line of its block, from 1.
    pub line: u32,
    /// Centre, for arcs.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub center: Option<Place>,
    /// Radius, mm, for arcs.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub r: Option<f64>,
    /// Direction, for arcs.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "\"cw\" | \"ccw\""))]
    pub dir: Option<&'static str>,
    /// The interpolation, or the plane on a machine with a Y axis, in which end point and centre are given.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(
        target_arch = "wasm32",
        tsify(optional, type = "\"polar\" | \"cylinder\" | \"xy\" | \"zx\" | \"yz\"")
    )]
    pub mode: Option<&'static str>,
    /// The machine position at the end of a move under such an interpolation.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub machine: Option<MachinePlace>,
    /// The work coordinate system of `to` and `center`, such as `G55` or `G54.1 P1`; omitted for G54.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub frame: Option<String>,
    /// The current work zero relative to that of the first cut, mm, X as a diameter: added to `to` and
    /// `center`, it gives the position on the workpiece. Omitted if zero.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub offset: Option<Place>,
    /// Lead of a thread, mm.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub lead: Option<f64>,
    /// How far the spindle turns past its zero mark before a thread begins, degrees; omitted if 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub start_angle: Option<f64>,
    /// Duration, seconds; omitted if it is unknown.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub seconds: Option<f64>,
    /// Feed along the path at the end of the motion, mm/min; omitted at rapid, or if unknown.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub feed: Option<f64>,
    /// Spindle speed at the end of the motion, rpm; omitted if unknown.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub rpm: Option<f64>,
    /// The tool, such as `T0101`.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub tool: Option<String>,
    /// The code of its cycle, such as `G71`.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub cycle: Option<&'static str>,
    /// Pass of the cycle, from 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub pass: Option<u32>,
    /// The step of the pass: `infeed`, `cut`, `pull-out`, `retract`, `return`, `approach`, `escape`,
    /// `contour`, `relief` or `stepover`.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub step: Option<&'static str>,
    /// Whether the motion may be wrong because an earlier block was not executed.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub uncertain: bool,
}

/// A stroke of the picture: a motion with the block that made it.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
#[serde(rename_all = "camelCase")]
pub struct Stroke {
    /// Index of the motion.
    pub motion: u32,
    /// The kind of motion.
    #[cfg_attr(
        target_arch = "wasm32",
        tsify(type = "\"rapid\" | \"feed\" | \"arc\" | \"thread\" | \"dwell\"")
    )]
    pub kind: &'static str,
    /// Line of its block, from 1.
    pub line: u32,
    /// UTF-16 offset of the start of its block.
    pub from: u32,
    /// UTF-16 offset of the end of its block.
    pub to: u32,
    /// X of the end point as a diameter, mm.
    pub x: Diameter,
    /// Z of the end point, mm.
    pub z: f64,
    /// X of the tool position as a diameter, mm.
    pub at_x: Diameter,
    /// Z of the tool position, mm.
    pub at_z: f64,
    /// Description of the motion.
    pub text: String,
}

/// Counts of a run.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
#[serde(rename_all = "camelCase")]
pub struct Summary {
    /// All motions.
    pub motions: u32,
    /// Rapids.
    pub rapids: u32,
    /// Straight cuts.
    pub feeds: u32,
    /// Arcs.
    pub arcs: u32,
    /// Threads.
    pub threads: u32,
    /// Dwells.
    pub dwells: u32,
    /// Errors.
    pub errors: u32,
    /// Warnings.
    pub warnings: u32,
    /// Other messages.
    pub infos: u32,
    /// Blocks read.
    pub blocks: u32,
    /// Lines of the text.
    pub lines: u32,
    /// Optional stops (M01) between motions.
    pub optional_stops: u32,
    /// Whether the run has ended.
    pub finished: bool,
}

impl Summary {
    /// The counts with their JavaScript names.
    pub fn counts(&self) -> [(&'static str, u32); 12] {
        [
            ("motions", self.motions),
            ("rapids", self.rapids),
            ("feeds", self.feeds),
            ("arcs", self.arcs),
            ("threads", self.threads),
            ("dwells", self.dwells),
            ("errors", self.errors),
            ("warnings", self.warnings),
            ("infos", self.infos),
            ("blocks", self.blocks),
            ("lines", self.lines),
            ("optionalStops", self.optional_stops),
        ]
    }

    /// Counts motions and messages. The caller sets `blocks`, `lines` and `finished`.
    pub fn new(motions: &Motions, diagnostics: &[message::Diagnostic]) -> Self {
        let mut summary = Self { motions: motions.len() as u32, ..Self::default() };
        for chunk in motions.chunks() {
            for &kind in chunk.kinds() {
                match MotionKind::ALL[kind as usize] {
                    MotionKind::Rapid => summary.rapids += 1,
                    MotionKind::Feed => summary.feeds += 1,
                    MotionKind::ArcClockwise | MotionKind::ArcCounterclockwise => summary.arcs += 1,
                    MotionKind::Thread => summary.threads += 1,
                    MotionKind::Dwell => summary.dwells += 1,
                }
            }
        }
        let stops = motions.stops(0..motions.len());
        summary.optional_stops = stops.filter(|(_, stop)| stop.kind == StopKind::Optional).count() as u32;
        for diagnostic in diagnostics {
            summary.count(diagnostic.severity);
        }
        summary
    }

    /// Counts one more message of this severity.
    pub fn count(&mut self, severity: Severity) {
        match severity {
            Severity::Error => self.errors += 1,
            Severity::Warning => self.warnings += 1,
            Severity::Info => self.infos += 1,
            Severity::Off => {}
        }
    }
}

/// The finished part: the half-section above the spindle axis.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct Part {
    /// The outline of each piece, counter-clockwise: `[z, x]`, mm, x a diameter.
    pub polygons: Vec<Vec<[f64; 2]>>,
    /// The holes in all pieces, clockwise. [`SectionPiece`] has the holes of each piece.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub holes: Vec<Vec<[f64; 2]>>,
}

impl Part {
    /// The pieces of a region.
    pub fn new(region: &Region) -> Self {
        let mut part = Self::default();
        for piece in region.pieces() {
            part.polygons.push(outline(piece.outline));
            part.holes.extend(piece.holes.into_iter().map(outline));
        }
        part
    }
}

/// A piece of the half-section, for the 3D view: `[z, x]`, mm, x a diameter.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct SectionPiece {
    /// The outline, counter-clockwise.
    pub outline: Vec<[f64; 2]>,
    /// The holes, clockwise.
    pub holes: Vec<Vec<[f64; 2]>>,
}

/// The half-section above the spindle axis, each piece with its holes.
pub fn section(region: &Region) -> Vec<SectionPiece> {
    let piece = |piece: Piece| SectionPiece {
        outline: outline(piece.outline),
        holes: piece.holes.into_iter().map(outline).collect(),
    };
    region.pieces().map(piece).collect()
}

/// An outline as `[z, x]`, mm, x a diameter.
fn outline(points: Vec<Point>) -> Vec<[f64; 2]> {
    points.into_iter().map(|point| [rounded(point.z), rounded(Diameter::from_radius(point.x).mm())]).collect()
}

/// A hole drilled by a live tool, for the 3D view.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct DrilledHole {
    /// The centre of the hole where it enters the material, with C.
    pub mouth: Place,
    /// The deepest position of the tool.
    pub bottom: Place,
    /// Diameter, mm.
    pub diameter: f64,
}

/// The holes of live tools.
pub fn holes(holes: &[LiveHole]) -> Vec<DrilledHole> {
    let row = |hole: &LiveHole| DrilledHole {
        mouth: Place { c: Some(rounded(hole.c)), ..place(hole.mouth) },
        bottom: Place { c: Some(rounded(hole.c)), ..place(hole.bottom) },
        diameter: rounded(Diameter::from_radius(hole.radius).mm()),
    };
    holes.iter().map(row).collect()
}

/// The comparison of two parts.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct Comparison {
    /// The pieces that only one part has, the largest first; empty if the parts are the same.
    pub differences: Vec<Difference>,
    /// The largest radial difference.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub radial: Option<Measure>,
    /// The largest axial difference.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub axial: Option<Measure>,
}

/// A piece that only one part has.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct Difference {
    /// The part that has it: `first` (or the one kept for comparison) or `second`.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "'first' | 'second'"))]
    pub only: &'static str,
    /// Area in the half-section, mm².
    pub area: f64,
    /// Minimum and maximum diameter, mm.
    pub x: [Diameter; 2],
    /// Minimum and maximum Z, mm.
    pub z: [f64; 2],
    /// The longest radial measurement.
    pub radial: Measure,
    /// The longest axial measurement.
    pub axial: Measure,
}

/// A straight measurement.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct Measure {
    /// Length, mm; a radial one on the radius.
    pub length: f64,
    /// The end closer to the axis, or to −Z.
    pub from: Place,
    /// The other end.
    pub to: Place,
}

impl Comparison {
    /// The row of a comparison.
    pub fn new(comparison: &compare::Comparison) -> Self {
        let differences = comparison.differences.iter().map(|difference| Difference {
            only: match difference.side {
                compare::Side::First => "first",
                compare::Side::Second => "second",
            },
            area: rounded_to_thousandth(difference.area),
            x: [difference.bounds.min.x, difference.bounds.max.x]
                .map(|x| Diameter::from_radius(x).map(rounded_to_thousandth)),
            z: [difference.bounds.min.z, difference.bounds.max.z].map(rounded_to_thousandth),
            radial: Measure::new(difference.radial),
            axial: Measure::new(difference.axial),
        });
        Self {
            differences: differences.collect(),
            radial: comparison.radial().map(Measure::new),
            axial: comparison.axial().map(Measure::new),
        }
    }
}

impl Measure {
    fn new(measure: compare::Measure) -> Self {
        Self {
            length: rounded_to_thousandth(measure.length()),
            from: measured_place(measure.from),
            to: measured_place(measure.to),
        }
    }
}

/// A measured position in the section.
fn measured_place(at: Point) -> Place {
    Place {
        x: Diameter::from_radius(at.x).map(rounded_to_thousandth),
        z: rounded_to_thousandth(at.z),
        c: None,
        y: None,
    }
}

/// Rounds to three decimals, the precision of a measurement on a part. −0 becomes 0.
fn rounded_to_thousandth(value: f64) -> f64 {
    rounded_to(value, 1e3)
}

/// An edge of the part with its dimensions.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
#[serde(rename_all = "camelCase")]
pub struct Dimension {
    /// The kind of edge. `across`: a section through the material at one Z, from the outside to the bore or
    /// the axis.
    #[cfg_attr(
        target_arch = "wasm32",
        tsify(type = "'cylinder' | 'face' | 'taper' | 'arc' | 'thread' | 'across'")
    )]
    pub kind: &'static str,
    /// Diameters of the ends, mm; for a thread, minor and major diameter.
    pub x: [Diameter; 2],
    /// Z of the ends, mm.
    pub z: [f64; 2],
    /// Length, mm: along the axis, also for a taper (L in C = (D − d) / L); on the radius for a face; the
    /// chord for an arc.
    pub length: f64,
    /// Half angle of a taper, degrees.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub angle: Option<f64>,
    /// n of a taper 1:n.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub ratio: Option<f64>,
    /// Radius of an arc, mm.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub radius: Option<f64>,
    /// Lead of a thread, mm.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub lead: Option<f64>,
}

impl Dimension {
    /// The row of a feature.
    pub fn new(feature: &Feature) -> Self {
        let [from, to] = feature.ends();
        let diameter = |radius: f64| Diameter::from_radius(radius).map(rounded_to_thousandth);
        let (kind, x) = match feature.shape {
            Shape::Cylinder => ("cylinder", [from.x, to.x]),
            Shape::Face => ("face", [from.x, to.x]),
            Shape::Taper { .. } => ("taper", [from.x, to.x]),
            Shape::Arc { .. } => ("arc", [from.x, to.x]),
            Shape::Across => ("across", [from.x, to.x]),
            Shape::Thread { minor, major, .. } => ("thread", [minor, major]),
        };
        let (mut angle, mut ratio, mut radius, mut lead) = (None, None, None, None);
        match feature.shape {
            Shape::Taper { half_angle, ratio: own } => {
                (angle, ratio) = (Some(rounded_to_thousandth(half_angle.to_degrees())), own);
            }
            Shape::Arc { radius: own } => radius = Some(rounded_to_thousandth(own)),
            Shape::Thread { lead: own, .. } => lead = Some(rounded_to_thousandth(own)),
            Shape::Cylinder | Shape::Face | Shape::Across => {}
        }
        Self {
            kind,
            x: x.map(diameter),
            z: [from.z, to.z].map(rounded_to_thousandth),
            length: rounded_to_thousandth(match feature.shape {
                Shape::Taper { .. } => (from.z - to.z).abs(),
                _ => from.distance(to),
            }),
            angle,
            ratio,
            radius,
            lead,
        }
    }
}

/// What is measured at one or two picked places of the section.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct Measurement {
    /// The edge, if a single edge of the part is picked.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub edge: Option<Dimension>,
    /// The corner, if a single corner is picked.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub corner: Option<Place>,
    /// Axial, radial and direct distance of the two places, or of the ends of a single line, mm.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub distances: Option<[f64; 3]>,
    /// Angle between two edges, or of the direct distance to the spindle axis, degrees.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub angle: Option<f64>,
}

impl Measurement {
    /// The result of a pick.
    pub fn new(found: &measuring::Measurement) -> Self {
        use measuring::Measurement as Found;
        let measured = match found {
            Found::One(_, Some(feature)) => {
                return Self { edge: Some(Dimension::new(feature)), ..Self::default() };
            }
            Found::One(Picked { at, edge: None }, None) => {
                let above = Point::new(at.x.abs(), at.z);
                return Self { corner: Some(measured_place(above)), ..Self::default() };
            }
            Found::One(Picked { edge: Some([from, to]), .. }, None) => measure::lengths(*from, *to),
            Found::Two(measured) => *measured,
        };
        match measured {
            Measured::Angle(degrees) => {
                Self { angle: Some(rounded_to_thousandth(degrees)), ..Self::default() }
            }
            Measured::Lengths { axial, radial, distance } => Self {
                distances: Some([axial, radial, distance].map(rounded_to_thousandth)),
                angle: Some(rounded_to_thousandth(radial.atan2(axial).to_degrees())),
                ..Self::default()
            },
        }
    }
}

/// Totals of a tool or of a whole program.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
#[serde(rename_all = "camelCase")]
pub struct Totals {
    /// The tool, such as `T0101`; omitted for moves before the first one, and for the whole program.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub tool: Option<String>,
    /// Seconds of all motions with a known duration.
    pub seconds: f64,
    /// Number of cuts with an unknown duration: no feed, or the spindle is stopped.
    pub unknown_cuts: u32,
    /// Number of rapids with an unknown duration: the rapid rate of the machine is not given.
    pub unknown_rapids: u32,
    /// Seconds of those rapids at the assumed rate, 8 m/min.
    pub assumed_seconds: f64,
    /// Path length at feed, mm.
    pub cut: f64,
    /// Path length at rapid, mm.
    pub rapid: f64,
    /// Minimum X and Z of the cuts.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub low: Option<Place>,
    /// Maximum X and Z of the cuts.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub high: Option<Place>,
}

impl Totals {
    /// The row of totals.
    pub fn new(own: &ToolTotals) -> Self {
        Self {
            tool: tool_name(own.tool),
            seconds: rounded(own.time.known),
            unknown_cuts: own.time.unknown_cuts,
            unknown_rapids: own.time.unknown_rapids,
            assumed_seconds: rounded(own.time.assumed),
            cut: rounded(own.cut),
            rapid: rounded(own.rapid),
            low: own.extents.map(|extents| place(extents.min)),
            high: own.extents.map(|extents| place(extents.max)),
        }
    }
}

/// The table of supported codes.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct Codes {
    /// The controls; the selected one is first.
    pub columns: Vec<CodeColumn>,
    /// The rows, in the order of the table.
    pub rows: Vec<CodeRow>,
}

/// A control of the table of supported codes.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct CodeColumn {
    /// The field of a row that contains the codes of this control.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "\"a\" | \"b\" | \"c\" | \"gsk\""))]
    pub key: &'static str,
    /// Its name; not translated.
    pub name: &'static str,
}

/// A row of the table of supported codes: the effect of the codes, and how the controls write them.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct CodeRow {
    /// The heading of the section.
    pub section: &'static str,
    /// The codes in FANUC's system A, separated by spaces; empty if there is none.
    pub a: String,
    /// In system B.
    pub b: String,
    /// In system C.
    pub c: String,
    /// On GSK 980TD.
    pub gsk: String,
    /// What they do.
    pub does: &'static str,
    /// Modal group of G codes; 0: not modal.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub group: Option<u8>,
    /// How the playground handles them.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "\"done\" | \"accepted\" | \"unsupported\""))]
    pub effect: &'static str,
    /// The effect as text; empty if the codes are executed.
    pub note: &'static str,
}

/// The table of supported codes in a language, with one list of codes first.
pub fn codes(first: CodeList, language: Language) -> Codes {
    let others = CodeList::ALL.into_iter().filter(|&list| list != first);
    let lists = [first].into_iter().chain(others);
    let columns = lists.map(|list| CodeColumn { key: column_key(list), name: list.name() }).collect();
    Codes { columns, rows: codes::rows().map(|row| code_row(row, language)).collect() }
}

fn column_key(list: CodeList) -> &'static str {
    match list {
        CodeList::A => "a",
        CodeList::B => "b",
        CodeList::C => "c",
        CodeList::Gsk => "gsk",
    }
}

fn code_row(row: codes::Row, language: Language) -> CodeRow {
    let [a, b, c, gsk] = row.codes;
    CodeRow {
        section: row.function.section().title(language),
        a,
        b,
        c,
        gsk,
        does: row.function.describe(language),
        group: row.group,
        effect: match row.effect {
            codes::Effect::Done => "done",
            codes::Effect::Accepted => "accepted",
            codes::Effect::NotSupported => "unsupported",
        },
        note: row.effect.note(language),
    }
}

impl CodeRow {
    /// The codes of a list.
    pub fn codes(&self, list: CodeList) -> &str {
        match list {
            CodeList::A => &self.a,
            CodeList::B => &self.b,
            CodeList::C => &self.c,
            CodeList::Gsk => &self.gsk,
        }
    }

    /// The codes of a list for a printed table: `=` if they are the same as in system A, `–` if there is
    /// none.
    pub fn printed(&self, list: CodeList) -> &str {
        match self.codes(list) {
            "" => "–",
            codes if list != CodeList::A && codes == self.a => "=",
            codes => codes,
        }
    }
}

/// A text with its lines; converts its spans to lines, columns and UTF-16 offsets. Not positions of the tool,
/// see [`Place`].
#[derive(Clone, Copy)]
pub struct Places<'a> {
    /// The text.
    pub text: &'a [u8],
    /// Its lines.
    pub lines: &'a LineIndex,
}

impl Places<'_> {
    /// The row of a message.
    pub fn diagnostic(&self, diagnostic: &message::Diagnostic, language: Language) -> Diagnostic {
        let (start, end) = self.corners(diagnostic.span);
        let (from, to) = self.offsets(diagnostic.span);
        let sentence = diagnostic.sentence(language);
        Diagnostic {
            line: start.0,
            column: start.1,
            end_line: end.0,
            end_column: end.1,
            from,
            to,
            code: diagnostic.code(),
            slug: diagnostic.message.slug().to_owned(),
            severity: diagnostic.severity.name().to_owned(),
            kind: diagnostic.message.kind().name().to_owned(),
            message: sentence.message,
            help: sentence.help,
            alarm: diagnostic.message.alarm().map(str::to_owned),
            fixes: {
                let edits = diagnostic.fixes.iter().map(|fix| self.fix(fix, language));
                edits.chain(settings::fixes(&diagnostic.message, language)).collect()
            },
        }
    }

    /// The stroke of a motion, with the tip at `at` on the workpiece; its description gives lengths in
    /// `unit`.
    pub fn stroke(
        &self,
        motions: &Motions,
        index: usize,
        at: Point,
        unit: Unit,
        language: Language,
    ) -> Stroke {
        let motion = motions.get(index);
        let (from, to) = self.offsets(motions.span(index));
        let at = at.moved(motion.process.zero.opposite());
        Stroke {
            motion: index as u32,
            kind: kind_name(motion.kind),
            line: motions.line(index) + 1,
            from,
            to,
            x: diameter(motion.to.x),
            z: rounded(motion.to.z),
            at_x: diameter(at.x),
            at_z: rounded(at.z),
            text: describe_motion(&motion, passes(motions, index), unit, language),
        }
    }

    /// UTF-16 offsets of a span.
    pub fn offsets(&self, span: Span) -> (u32, u32) {
        (self.lines.utf16_offset(self.text, span.start), self.lines.utf16_offset(self.text, span.end))
    }

    /// The row of an edit.
    fn edit(&self, span: Span, text: String) -> Edit {
        let (start, end) = self.corners(span);
        let (from, to) = self.offsets(span);
        let text = self.lines.with_line_ends(text);
        Edit { line: start.0, column: start.1, end_line: end.0, end_column: end.1, from, to, text }
    }

    fn fix(&self, fix: &message::Fix, language: Language) -> Fix {
        let edits = fix.edits.iter().map(|edit| self.edit(edit.span, edit.text.clone()));
        Fix { title: fix.title.words(language), safe: fix.safe, edits: edits.collect(), setting: None }
    }

    /// First line and column, last line and column, from 1.
    fn corners(&self, span: Span) -> ((u32, u32), (u32, u32)) {
        let start = self.lines.line_column(self.text, span.start);
        let end = self.lines.line_column(self.text, span.end);
        ((start.line + 1, start.column + 1), (end.line + 1, end.column + 1))
    }
}

/// How many motions are examined in each direction to count the passes of a cycle.
const MAX_SCANNED_MOTIONS: usize = 20_000;

/// The number of passes of a motion's cycle: in its own call, or in the whole sequence of a modal cycle.
fn passes(motions: &Motions, index: usize) -> Option<u32> {
    let own = motions.get(index).cycle?;
    let end = motions.len().min(index + MAX_SCANNED_MOTIONS);
    let mut last = own.pass;
    for step in (index + 1..end).map(|next| motions.get(next).cycle) {
        match step {
            // Pass numbers only increase; a smaller number starts another call.
            Some(step) if step.cycle == own.cycle && (step.pass == 0 || step.pass >= last) => {
                last = last.max(step.pass);
            }
            _ => break,
        }
    }
    Some(last).filter(|&last| last > 0)
}

/// The row of a motion on a line (from 0).
pub fn motion(motion: &motion::Motion, line: u32, machine: &Machine) -> Motion {
    let motion = &motion.at_tip();
    let virtual_move = motion.virtual_move();
    let arc = match virtual_move {
        Some(VirtualMove { way: Way::Arc(arc), .. }) => Some(arc),
        _ => motion.arc(),
    };
    Motion {
        kind: kind_name(motion.kind),
        to: virtual_move.map_or_else(
            || Place { c: motion.rotary.map(|rotary| rounded(rotary.to)), ..place(motion.to) },
            |own| {
                let turns = motion.rotary.filter(|rotary| own.has_y() && rotary.from != rotary.to);
                let place = place_on(own.surface, own.way.at(1.0), own.third.1);
                Place { c: turns.map(|rotary| rounded(rotary.to)).or(place.c), ..place }
            },
        ),
        line: line + 1,
        center: arc.map(|arc| match virtual_move {
            Some(own) => place_on(own.surface, arc.center, own.third.1),
            None => place(arc.center),
        }),
        r: arc.map(|arc| rounded(arc.radius())),
        dir: match motion.kind {
            MotionKind::ArcClockwise => Some("cw"),
            MotionKind::ArcCounterclockwise => Some("ccw"),
            _ => None,
        },
        mode: virtual_move.map(|own| match own.surface {
            Surface::Face => "polar",
            Surface::Cylinder { .. } => "cylinder",
            Surface::Flat(Flat::Xy) => "xy",
            Surface::Flat(Flat::Zx) => "zx",
            Surface::Flat(Flat::Yz) => "yz",
        }),
        machine: virtual_move
            .filter(|own| !own.has_y())
            .and(motion.rotary)
            .map(|rotary| MachinePlace { x: diameter(motion.to.x), c: rounded(rotary.to) }),
        frame: frame_name(motion.process.frame),
        offset: Some(motion.process.zero).filter(|zero| *zero != Point::default()).map(place),
        lead: motion.lead.map(rounded),
        start_angle: Some(motion.start_angle).filter(|&angle| angle != 0.0).map(rounded),
        seconds: timing::seconds(motion, machine).map(rounded),
        feed: timing::feed_at(motion, machine, motion.to.x).map(rounded),
        rpm: timing::speed_at(&motion.process, machine, motion.to.x).map(rounded),
        tool: tool_name(motion.process.tool),
        cycle: motion.cycle.map(|step| step.cycle.code()),
        pass: motion.cycle.map(|step| step.pass).filter(|&pass| pass > 0),
        step: motion.cycle.map(|step| step.step.name()),
        uncertain: motion.process.uncertain,
    }
}

/// A point of a virtual plane as the program gives it.
fn place_on(surface: Surface, point: Point, third: f64) -> Place {
    match surface {
        Surface::Face => {
            Place { x: diameter(point.z), z: rounded(third), c: Some(rounded(point.x)), y: None }
        }
        Surface::Cylinder { radius, .. } => Place {
            x: diameter(third),
            z: rounded(point.z),
            c: Some(rounded((point.x / radius).to_degrees())),
            y: None,
        },
        Surface::Flat(flat) => {
            let at = flat.space(point, third);
            Place { x: diameter(at.x), z: rounded(at.z), c: None, y: Some(rounded(at.y)) }
        }
    }
}

/// The T word of a tool; `None` before the first one.
fn tool_name((station, offset): (u16, u16)) -> Option<String> {
    (station > 0).then(|| tool_word((station, offset)))
}

/// The code of a work coordinate system; `None` for G54.
fn frame_name(frame: u16) -> Option<String> {
    match frame {
        0 => None,
        1..STANDARD_FRAMES => Some(format!("G{}", 54 + frame)),
        _ => Some(format!("G54.1 P{}", frame - STANDARD_FRAMES + 1)),
    }
}

/// The rows of all motions.
pub fn motions(motions: &Motions, machine: &Machine) -> impl Iterator<Item = Motion> {
    motions.chunks().iter().flat_map(move |chunk| {
        (0..chunk.len()).map(move |index| motion(&chunk.get(index), chunk.line(index), machine))
    })
}

fn kind_name(kind: MotionKind) -> &'static str {
    match kind {
        MotionKind::Rapid => "rapid",
        MotionKind::Feed => "feed",
        MotionKind::ArcClockwise | MotionKind::ArcCounterclockwise => "arc",
        MotionKind::Thread => "thread",
        MotionKind::Dwell => "dwell",
    }
}

/// The diameter of a radius, mm, without binary rounding errors.
fn diameter(radius: f64) -> Diameter {
    Diameter::from_radius(radius).map(rounded)
}

fn place(point: Point) -> Place {
    Place { x: diameter(point.x), z: rounded(point.z), c: None, y: None }
}

/// Rounds to six decimals, which removes binary rounding errors. −0 becomes 0.
fn rounded(value: f64) -> f64 {
    rounded_to(value, 1e6)
}

/// Rounds to a fraction 1/`factor`. −0 becomes 0.
fn rounded_to(value: f64, factor: f64) -> f64 {
    let rounded = (value * factor).round() / factor;
    if rounded == 0.0 { 0.0 } else { rounded }
}

/// The message about numbers without a decimal point, if a run has one: one line of plain text.
pub fn decimal_notice(run: &Run, language: Language) -> Option<String> {
    let sentence = run.decimal_message()?.message.sentence(language).message;
    Some(sentence.trim_end_matches(['.', '。']).replace('`', ""))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::setup::Setup;

    #[test]
    fn counts_have_the_names_of_the_row() {
        let analysis = crate::analyze(
            b"G0 X20 Z0\nM1\nG1 Z-5 F0.1\nG4 P1\nG2 X30 Z-10 R5\nG32 Z-20 F1\nG7 X1\nM30",
            &Setup::default(),
        );
        let summary = Summary {
            blocks: 7,
            lines: 8,
            finished: true,
            ..Summary::new(&analysis.motions, &analysis.diagnostics)
        };
        let mut row = serde_json::Map::new();
        row.extend(summary.counts().map(|(name, count)| (name.to_owned(), count.into())));
        row.insert("finished".to_owned(), summary.finished.into());
        assert_eq!(serde_json::to_value(&summary).unwrap(), serde_json::Value::Object(row));
    }
}
