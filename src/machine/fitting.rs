//! Which tool and which blank a program is run with: those of the setup, and guesses for what it does not name.
//!
//! In: the setup and the motions. Out: a shape for each motion. Says of everything whether it is a guess.

use super::guess::Guesses;
use super::seen::Use;
use super::sweep::Outline;
use super::thread_point::{for_pitch, leads};
use super::tool::{Shape, over_edge};
use crate::motion::{Motion, Motions};
use crate::setup::{Setup, Stock, Tool, ToolKind};

/// Whether somebody has said so.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Known {
    /// By the setup, or a comment of the program.
    Given,
    /// Concluded from the program.
    Guessed,
}

/// A tool with its shape.
#[derive(Clone, Debug, PartialEq)]
pub struct Fitted {
    /// Turret station.
    pub station: u16,
    /// The tool.
    pub tool: Tool,
    /// Its shape.
    pub shape: Shape,
    /// What of the work it takes off on its way.
    pub takes: Outline,
    /// Whether somebody has named it.
    pub known: Known,
}

/// How large the part of a guessed tool is that is held against the work, as a share of it: nothing is known of the rest.
const TIP: f64 = 0.02;

/// How deep the tip of a guessed tool must be in the work to be reported, mm: what its true edges leave is not known to less.
const DEPTH: f64 = 0.5;

/// Tools and blank.
#[derive(Clone, Debug)]
pub struct Fitting {
    given: Vec<(u16, u16, Fitted)>,
    guessed: Vec<(u16, Use, Fitted)>,
    /// For what no tool is known of: a program without cuts.
    other: Fitted,
    stock: Option<(Stock, Known)>,
    /// The first motion of each tool that is neither given nor to be concluded.
    unknown: Vec<usize>,
}

impl Fitting {
    /// Fits out a program.
    pub fn new(motions: &Motions, setup: &Setup) -> Self {
        let guesses = Guesses::with(motions, &setup.spoken, setup.stock);
        let leads = leads(motions);
        let for_pitch = |station: u16, tool: &Tool| {
            let lead = leads.iter().find(|own| own.0 == station);
            for_pitch(tool, lead.map(|own| own.1))
        };
        let given = setup.tools.iter().filter_map(|(name, tool)| {
            let (station, offset) = station_of(name)?;
            Some((station, offset, Fitted::given(station, for_pitch(station, tool))))
        });
        let guessed = guesses.tools().map(|(station, purpose, tool)| {
            (station, purpose, Fitted::guessed(station, for_pitch(station, tool)))
        });
        let stock = setup.stock.map(|stock| (stock, Known::Given));
        let given: Vec<_> = given.collect();
        let mut unknown = guesses.unknown.clone();
        unknown.retain(|&index| given.iter().all(|own| own.0 != motions.get(index).process.tool.0));
        Self {
            unknown,
            given,
            guessed: guessed.collect(),
            other: Fitted::guessed(0, Tool::default()),
            stock: stock.or_else(|| guesses.stock.map(|stock| (stock, Known::Guessed))),
        }
    }

    /// The tool of a motion: of its station and offset, of its station, or the guess for what it does.
    pub fn tool(&self, motion: &Motion) -> &Fitted {
        let (station, offset) = motion.process.tool;
        let own = self.given.iter().filter(|given| given.0 == station);
        let given = own.clone().find(|given| given.1 == offset).or_else(|| own.clone().next());
        if let Some((.., tool)) = given {
            return tool;
        }
        let purpose = Use::of(motion);
        let own = self.guessed.iter().filter(|guess| guess.0 == station);
        let guess = own.clone().find(|guess| guess.1 == purpose).or_else(|| own.clone().next());
        guess.map_or(&self.other, |(.., tool)| tool)
    }

    /// Whether the setup names tools, but none for this station.
    pub fn misses(&self, station: u16) -> bool {
        station > 0 && !self.given.is_empty() && self.given.iter().all(|given| given.0 != station)
    }

    /// The first motion of each tool that is neither given nor to be concluded: each that was tried would cut into the contour.
    pub fn unknown(&self) -> &[usize] {
        &self.unknown
    }

    /// The blank, and whether somebody has named it.
    pub fn stock(&self) -> Option<(Stock, Known)> {
        self.stock
    }

    /// All tools that the program uses or the setup names.
    pub fn tools(&self) -> impl Iterator<Item = &Fitted> {
        let covered = |station: u16| self.given.iter().any(|given| given.0 == station);
        let guessed = self.guessed.iter().filter(move |guess| !covered(guess.0)).map(|(.., tool)| tool);
        self.given.iter().map(|(.., tool)| tool).chain(guessed)
    }
}

impl Fitted {
    fn given(station: u16, tool: Tool) -> Self {
        let shape = Shape::of(&tool);
        Self { station, takes: shape.edge.clone(), shape, tool, known: Known::Given }
    }

    fn guessed(station: u16, tool: Tool) -> Self {
        let mut shape = Shape::of(&tool);
        // Where in a threading tool its point is, is not known either.
        shape.core = match tool.kind {
            Some(ToolKind::Threading) => Outline::default(),
            _ => shape.edge.shrunk(DEPTH).near_tip(TIP),
        };
        shape.body = None;
        let takes = over_edge(&tool, &shape);
        Self { station, shape, takes, tool, known: Known::Guessed }
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
