//! Threads by name: their dimensions by the standards.
//!
//! In: a name, such as `M30×2`, `1/4-20 UNC`, `G1/2`, `1/2-14 NPT`, `Tr40×7`. Out: a [`Thread`]; or the
//! designations that begin with a text. Every thread is a row of a table in `threads/*.tsv`, which names its
//! standards; a name without a row is not found. Does not know how a thread is cut.

mod name;
mod table;
#[cfg(test)]
mod tests;

use crate::units::{Diameter, number};
pub use name::Hand;
use name::Name;
pub use table::Standard;
use table::{Profile, Row};

/// Most designations of a suggestion.
const SUGGESTIONS: usize = 12;

/// Most starts of a thread.
const MAX_STARTS: u32 = 12;

/// Height of the fundamental triangle of a thread angle of 60°, as a share of the pitch: √3 / 2.
const TRIANGLE: f64 = 0.866_025_403_784_438_6;

/// Basic dimensions of a thread.
#[derive(Clone, Debug, PartialEq)]
pub struct Thread {
    /// The standard.
    pub standard: Standard,
    /// Designation by the standard, without tolerance class and hand: `M30×2`, `Tr40×14 P7`.
    pub designation: String,
    /// Major diameter of the outside thread. NPT: outside diameter of the pipe.
    pub major: Diameter,
    /// Pitch, mm.
    pub pitch: f64,
    /// Lead, mm: starts times pitch.
    pub lead: f64,
    /// Number of starts.
    pub starts: u32,
    /// Hand.
    pub hand: Hand,
    /// Thread angle, between the flanks, degrees.
    pub angle: f64,
    /// The thread of a shaft or pipe.
    pub outside: Outside,
    /// The thread of a hole.
    pub inside: Inside,
    /// The taper, for NPT.
    pub taper: Option<Taper>,
}

/// Dimensions of an outside thread. NPT: at the end of the pipe.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outside {
    /// Thread height, mm.
    pub height: f64,
    /// Core diameter: X of the last pass.
    pub core: Diameter,
}

/// Dimensions of an inside thread. NPT: at the face of the hole, where E1 is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inside {
    /// Thread height, mm.
    pub height: f64,
    /// Diameter of the hole before the first pass.
    pub hole: Diameter,
    /// Diameter at the root: X of the last pass.
    pub root: Diameter,
}

/// Dimensions of a taper pipe thread, measured from the end of the pipe.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Taper {
    /// Difference of the diameters divided by the length: 1/16.
    pub ratio: f64,
    /// Pitch diameter at the end of the pipe, E0.
    pub pitch_at_end: Diameter,
    /// Pitch diameter at the length of hand-tight engagement, E1.
    pub pitch_at_engagement: Diameter,
    /// Length of hand-tight engagement, mm, L1.
    pub engagement: f64,
    /// Length of effective thread, mm, L2.
    pub effective: f64,
    /// Length of the thread with its vanishing part, mm, L4.
    pub overall: f64,
}

impl Thread {
    /// The standards that the dimensions are taken from, such as `ISO 228-1`.
    pub fn source(&self) -> &'static str {
        self.standard.source()
    }
}

/// The thread with a name. Capital and small letters, spaces, `×`, `x` and `*`, decimal comma and point are
/// the same. Tolerance classes are accepted and have no effect, because the dimensions are basic dimensions.
pub fn find(name: &str) -> Option<Thread> {
    let name = Name::read(name)?;
    let numbered = name.numbered();
    let names = std::iter::once(name).chain(numbered);
    names.filter_map(|name| Some((name, row(&name)?))).find_map(|(name, row)| thread(&name, &row))
}

/// The designations that begin with a text, at most 12: coarse threads first, each in the order of its table.
/// The series may be written first (`UNC 1/4`), and the sign of a screw's number left out (`10-32`).
pub fn suggest(prefix: &str) -> Vec<&'static str> {
    let Some(prefix) = name::compact(prefix).filter(|prefix| !prefix.is_empty()) else {
        return Vec::new();
    };
    let begins = |text: &str| name::compact(text).is_some_and(|text| text.starts_with(&prefix));
    let fits = |designation: &str| {
        let series_first = |(size, series): (&str, &str)| {
            series.starts_with(['U', 'N']) && begins(&format!("{series} {size}"))
        };
        begins(designation)
            || designation.strip_prefix('#').is_some_and(begins)
            || designation.rsplit_once(' ').is_some_and(series_first)
    };
    let designations = || Standard::ALL.into_iter().flat_map(Standard::rows).map(|row| row.designation);
    let is_fine = |designation: &&str| designation.starts_with('M') && designation.contains('×');
    let coarse = designations().filter(|designation| !is_fine(designation));
    let all = coarse.chain(designations().filter(is_fine));
    all.filter(|designation| fits(designation)).take(SUGGESTIONS).collect()
}

/// The row of a table with a name.
fn row(name: &Name) -> Option<Row> {
    name.standard.rows().find(|row| {
        Name::read(row.designation).is_some_and(|designation| name.names(&designation, row.pitch))
    })
}

/// The dimensions of a row. `None` if the lead is not a multiple of the pitch.
fn thread(name: &Name, row: &Row) -> Option<Thread> {
    let Row { designation, major, pitch, profile } = *row;
    let lead = name.lead.unwrap_or(pitch);
    let starts = (1..=MAX_STARTS).find(|&starts| (f64::from(starts) * pitch - lead).abs() < 1e-6)?;
    let designation = match profile {
        _ if starts == 1 => designation.to_owned(),
        Profile::Metric => format!("M{}×Ph{}P{}", number(major), number(lead), number(pitch)),
        _ => format!("Tr{}×{} P{}", number(major), number(lead), number(pitch)),
    };
    let (angle, outside, inside, taper) = dimensions(major, pitch, profile);
    Some(Thread {
        standard: name.standard,
        designation,
        major: Diameter::new(major),
        pitch,
        lead,
        starts,
        hand: name.hand,
        angle,
        outside,
        inside,
        taper,
    })
}

/// Thread angle and dimensions of a profile, from the major diameter and the pitch, mm.
fn dimensions(major: f64, pitch: f64, profile: Profile) -> (f64, Outside, Inside, Option<Taper>) {
    let triangle = TRIANGLE * pitch;
    match profile {
        // ISO 68-1, ISO 724: D1 = d − 5/4 H. Root rounded by H/6, ISO 898-1: d3 = d − 17/12 H.
        Profile::Metric => {
            let (outside, inside) = (17.0 / 24.0 * triangle, 5.0 / 8.0 * triangle);
            (60.0, Outside::of(major, outside), Inside::of(major, inside), None)
        }
        // ASME B1.1: D1 = D − 5/4 H. Rounded root, UNR: d3 = D − 11/8 H.
        Profile::Unified => {
            let (outside, inside) = (11.0 / 16.0 * triangle, 5.0 / 8.0 * triangle);
            (60.0, Outside::of(major, outside), Inside::of(major, inside), None)
        }
        // ISO 228-1: h = 0.640327 P, rounded in the table of the standard.
        Profile::Pipe { minor } => {
            let height = Diameter::new(major - minor).radius();
            (55.0, Outside::of(major, height), Inside::of(major, height), None)
        }
        // ASME B1.20.1: h = 0.8 P, E0 = D − (0.05 D + 1.1 inch) P, L2 = (0.8 D + 6.8 inch) P, P per inch;
        // 3.47 vanishing threads.
        Profile::TaperPipe { engagement } => {
            let (height, ratio) = (0.8 * pitch, 1.0 / 16.0);
            let at_end = major - (0.05 * major / 25.4 + 1.1) * pitch;
            let at_engagement = at_end + ratio * engagement;
            let effective = (0.8 * major / 25.4 + 6.8) * pitch;
            let taper = Taper {
                ratio,
                pitch_at_end: Diameter::new(at_end),
                pitch_at_engagement: Diameter::new(at_engagement),
                engagement,
                effective,
                overall: effective + 3.47 * pitch,
            };
            let outside = Outside::of(at_end + height, height);
            (60.0, outside, Inside::of(at_engagement + height, height), Some(taper))
        }
        // ISO 2904: h3 = H4 = 0.5 P + a_c, d3 = d − 2 h3, D1 = d − P, D4 = d + 2 a_c.
        Profile::Trapezoidal { clearance } => {
            let height = 0.5 * pitch + clearance;
            let root = major + 2.0 * clearance;
            (30.0, Outside::of(major, height), Inside::of(root, height), None)
        }
    }
}

impl Outside {
    /// A thread height below a crest diameter, mm.
    fn of(crest: f64, height: f64) -> Self {
        Self { height, core: Diameter::new(crest - 2.0 * height) }
    }
}

impl Inside {
    /// A thread height above a hole, from the diameter at the root, mm.
    fn of(root: f64, height: f64) -> Self {
        Self { height, hole: Diameter::new(root - 2.0 * height), root: Diameter::new(root) }
    }
}
