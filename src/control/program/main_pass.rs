//! What a pass of a main program that M99 repeats takes over from the pass before it.
//!
//! In: each reading and writing of a variable, with its block. Out: the variables that the pass reads before it
//! assigns them, with their values at its beginning. Only these can make the next pass another one.

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::order;

/// The value of a variable; `None` when it is vacant.
type Value = Option<f64>;

/// The first access of a block to a variable.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Access {
    /// Accesses noted before it.
    order: u32,
    /// The value at the beginning of the pass; `None`: the block assigns the variable.
    read: Option<Value>,
}

/// A pass of the main program, from its head or the block of `M99 P` to M99.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MainPass {
    /// Passes that M99 has ended.
    ended: u32,
    /// First byte of its first block, where that is not the head of the program.
    start: Option<u32>,
    /// Whether a block has moved X to an absolute position, and whether one has moved Z.
    pub placed: [bool; 2],
    /// By the first byte of the block of the main program, and the variable.
    accesses: Arc<BTreeMap<(u32, u32), Access>>,
    /// Values at the beginning of the pass of the system variables that earlier passes read.
    system: Arc<BTreeMap<u32, f64>>,
}

impl MainPass {
    /// From this many accesses on they are kept by variable alone.
    const MOST: usize = 10_000;

    /// From this many passes on they are compared now and then only: the comparison takes longer than a pass.
    const COMPARED: u32 = 64;

    /// Whether this is the first pass.
    pub fn is_first(&self) -> bool {
        self.ended == 0
    }

    /// Whether the end of this pass is compared with its beginning.
    pub fn is_compared(&self) -> bool {
        let number = self.ended + 1;
        number <= Self::COMPARED || number.is_power_of_two()
    }

    /// Value of a system variable at the beginning of a pass that is not the first. Not a number where no
    /// earlier pass has read it.
    pub fn system_at_start(&self, variable: u32) -> f64 {
        self.system.get(&variable).copied().unwrap_or(f64::NAN)
    }

    /// Whether the access of a block to a variable is still to be noted.
    pub fn is_new(&self, block: u32, variable: u32) -> bool {
        self.is_compared() && !self.accesses.contains_key(&self.key(block, variable))
    }

    /// Notes that a block assigns a variable (`None`), or reads one that had this value when the pass began.
    pub fn note(&mut self, block: u32, variable: u32, read: Option<Value>) {
        if self.is_new(block, variable) {
            let (key, order) = (self.key(block, variable), self.accesses.len() as u32);
            Arc::make_mut(&mut self.accesses).insert(key, Access { order, read });
        }
    }

    fn key(&self, block: u32, variable: u32) -> (u32, u32) {
        (if self.accesses.len() < Self::MOST { block } else { u32::MAX }, variable)
    }

    /// The variables that the pass reads before it assigns them, as far as it goes from the block at byte
    /// `from` on; `None`: from the head of the program.
    pub fn inputs(&self, from: Option<u32>) -> Vec<(u32, Value)> {
        let begin = if from == self.start { 0 } else { from.unwrap_or(0) };
        let mut first: BTreeMap<u32, Access> = BTreeMap::new();
        for (&(_, variable), &access) in self.accesses.range((begin, 0)..) {
            let known = first.entry(variable).or_insert(access);
            if access.order < known.order {
                *known = access;
            }
        }
        first.into_iter().filter_map(|(variable, access)| Some((variable, access.read?))).collect()
    }

    /// The system variables that this pass and those before it have read.
    pub fn system_read(&self) -> Vec<u32> {
        let read = self.accesses.iter().filter(|(_, access)| access.read.is_some());
        let read = read.map(|(&(_, variable), _)| variable).filter(|&variable| variable >= 1000);
        read.chain(self.system.keys().copied()).collect()
    }

    /// The next pass, from the block at byte `start` or from the head. `system`: system variables that have been read,
    /// with their values.
    pub fn next(&self, start: Option<u32>, system: BTreeMap<u32, f64>) -> Self {
        Self { ended: self.ended.saturating_add(1), start, system: Arc::new(system), ..Self::default() }
    }

    /// Moves the places of blocks along, when the text before them has changed.
    pub fn shift(&mut self, byte: impl Fn(u32) -> u32) {
        if !self.accesses.is_empty() {
            let moved = |(&(block, variable), &access): (&(u32, u32), &Access)| {
                ((if block == u32::MAX { block } else { byte(block) }, variable), access)
            };
            self.accesses = Arc::new(order::gathered(self.accesses.iter().map(moved)));
        }
    }
}
