//! What a program lets one guess of the tools and the blank that nobody has named.
//!
//! In: the motions. Out: a [`Tool`] for each use a station is put to (`seen`, `choice`), and a [`Stock`] (how large it is: `blank`). A guess is
//! sharp, and can follow every slope it is led along; it is shown as a guess, and no alarm is raised because of one.

use std::collections::BTreeMap;

use super::blank::{Cuts, clear_of_rapids};
use super::choice;
use super::seen::{Clamping, Seen, Use};
use crate::geometry::SAME;
use crate::motion::Motions;
use crate::setup::{Stock, Tool};

/// The guesses for a program.
#[derive(Clone, Debug, Default)]
pub struct Guesses {
    tools: Vec<(u16, Use, Tool)>,
    /// The first motion of each use of a station that no tool is known for: with each that was tried it cuts into the contour.
    pub unknown: Vec<usize>,
    /// The blank; nothing where nothing cuts.
    pub stock: Option<Stock>,
}

impl Guesses {
    /// Looks at a program of which nothing else is known.
    pub fn of(motions: &Motions) -> Self {
        Self::with(motions, &BTreeMap::new(), None)
    }

    /// Looks at a program. `spoken` is what its comments say of the tools, by station; `stock` the blank, where one is given.
    pub fn with(motions: &Motions, spoken: &BTreeMap<u16, Tool>, stock: Option<Stock>) -> Self {
        let seen = Seen::all(motions, spoken, stock, Clamping::First);
        let mut tools = tools_of(&seen);
        let mut cuts = Cuts::default();
        for (own, (.., tool)) in seen.iter().zip(&tools) {
            cuts.add(&own.extents, tool);
        }
        let guessed = cuts.blank().map(|stock| clear_of_rapids(stock, motions));
        let choices = tools.iter_mut().map(|(.., tool)| tool).collect();
        let unknown = choice::decide(motions, &seen, spoken, stock.or(guessed), choices);
        let mut guesses = Self { tools, unknown, stock: guessed };
        // Nothing is taken off there: for these a first guess will do.
        if motions.cuts_elsewhere().is_some() {
            for other in tools_of(&Seen::all(motions, spoken, stock, Clamping::Other)) {
                if guesses.tools.iter().all(|own| (own.0, own.1) != (other.0, other.1)) {
                    guesses.tools.push(other);
                }
            }
        }
        guesses
    }

    /// All tools: station, use and tool, in the order in which they are first put to use.
    pub fn tools(&self) -> impl Iterator<Item = (u16, Use, &Tool)> {
        self.tools.iter().map(|(station, purpose, tool)| (*station, *purpose, tool))
    }
}

/// A first guess of the tool of each use.
fn tools_of(seen: &[Seen]) -> Vec<(u16, Use, Tool)> {
    // What a drill leaves is where boring begins.
    let inside = seen.iter().filter(|own| own.is_inside());
    let bore = inside.map(|own| own.extents.least()).fold(f64::INFINITY, f64::min);
    let holes = seen.iter().filter(|own| own.purpose == Use::Hole);
    let deepest = holes.map(|own| own.deepest).fold(f64::INFINITY, f64::min);
    // A centre drill comes before the drill that makes the bore.
    let bore_of = |own: &Seen| if own.deepest <= deepest + SAME { bore } else { f64::INFINITY };
    seen.iter().map(|own| (own.station, own.purpose, own.tool(bore_of(own)))).collect()
}
