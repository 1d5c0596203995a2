//! In: a seed. Out: pseudo-random numbers, the same on every machine (SplitMix64).

/// A random number generator.
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// The generator for one program of a run: each program can be reproduced without the earlier ones.
    pub fn new(seed: u64, index: u64) -> Self {
        let mut random = Self(seed);
        let start = random.next() ^ index;
        Self(start)
    }

    /// An integer from `low` up to and including `high`.
    pub fn within(&mut self, low: i64, high: i64) -> i64 {
        let span = (high - low + 1).max(1) as u64;
        low + (self.next() % span) as i64
    }

    /// True with a probability of `chance` percent.
    pub fn percent(&mut self, chance: i64) -> bool {
        self.within(0, 99) < chance
    }

    /// From 0 up to, but not including, 1.
    pub fn fraction(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// One of the given values.
    pub fn pick<T: Copy>(&mut self, things: &[T]) -> T {
        things[self.within(0, things.len() as i64 - 1) as usize]
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }
}
