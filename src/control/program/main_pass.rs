//! Data that a repetition of the main program (M99) takes over from the pass before.
//!
//! In: each read and write of a variable, with its block. Out: the variables that a pass reads before it
//! assigns them, with their values at its beginning. Only these can make the next pass different.

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::order;

/// The value of a variable; `None` if it is vacant.
type Value = Option<f64>;

/// The first access of a block to a variable.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Access {
    /// Number of accesses recorded before it.
    order: u32,
    /// The value at the beginning of the pass; `None`: the block assigns the variable.
    read: Option<Value>,
}

/// A pass of the main program, from its head or the block of `M99 P` to M99.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MainPass {
    /// Number of passes that M99 has ended.
    ended: u32,
    /// First byte of its first block, if it does not begin with the head of the program.
    start: Option<u32>,
    /// Whether a block has moved X to an absolute position, and whether one has moved Z.
    pub absolute_axes: [bool; 2],
    /// By the first byte of the block in the main program, and by variable.
    accesses: Arc<BTreeMap<(u32, u32), Access>>,
    /// The system variables that earlier passes read, with their values at the beginning of the pass.
    system: Arc<BTreeMap<u32, f64>>,
}

impl MainPass {
    /// From this number of accesses on, they are stored by variable only, without the block.
    const MAX_DETAILED: usize = 10_000;

    /// From this number of passes on, only some are compared, because the comparison takes longer than a
    /// pass.
    const MAX_COMPARED: u32 = 64;

    /// Whether this is the first pass.
    pub fn is_first(&self) -> bool {
        self.ended == 0
    }

    /// Whether the end of this pass is compared with its beginning.
    pub fn is_compared(&self) -> bool {
        let number = self.ended + 1;
        number <= Self::MAX_COMPARED || number.is_power_of_two()
    }

    /// Value of a system variable at the beginning of a pass that is not the first. NaN if no earlier pass
    /// has read it.
    pub fn system_at_start(&self, variable: u32) -> f64 {
        self.system.get(&variable).copied().unwrap_or(f64::NAN)
    }

    /// Whether the access of a block to a variable has not been recorded yet.
    pub fn is_new(&self, block: u32, variable: u32) -> bool {
        self.is_compared() && !self.accesses.contains_key(&self.key(block, variable))
    }

    /// Records that a block assigns a variable (`None`), or reads one that had this value when the pass
    /// began.
    pub fn note(&mut self, block: u32, variable: u32, read: Option<Value>) {
        if self.is_new(block, variable) {
            let (key, order) = (self.key(block, variable), self.accesses.len() as u32);
            Arc::make_mut(&mut self.accesses).insert(key, Access { order, read });
        }
    }

    fn key(&self, block: u32, variable: u32) -> (u32, u32) {
        (if self.accesses.len() < Self::MAX_DETAILED { block } else { u32::MAX }, variable)
    }

    /// The variables that a pass from the block at byte `from` on reads before it assigns them; `None`: from
    /// the head of the program.
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

    /// The system variables that this pass and earlier ones have read.
    pub fn system_read(&self) -> Vec<u32> {
        let read = self.accesses.iter().filter(|(_, access)| access.read.is_some());
        let read = read.map(|(&(_, variable), _)| variable).filter(|&variable| variable >= 1000);
        read.chain(self.system.keys().copied()).collect()
    }

    /// The next pass, from the block at byte `start` or from the head. `system`: the system variables that
    /// have been read, with their values.
    pub fn next(&self, start: Option<u32>, system: BTreeMap<u32, f64>) -> Self {
        Self { ended: self.ended.saturating_add(1), start, system: Arc::new(system), ..Self::default() }
    }

    /// Moves the positions of blocks after a change of the text before them.
    pub fn shift(&mut self, byte: impl Fn(u32) -> u32) {
        if !self.accesses.is_empty() {
            let moved = |(&(block, variable), &access): (&(u32, u32), &Access)| {
                ((if block == u32::MAX { block } else { byte(block) }, variable), access)
            };
            self.accesses = Arc::new(order::gathered(self.accesses.iter().map(moved)));
        }
    }
}
