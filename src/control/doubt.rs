//! What is not known after something that could not be carried out: a refused block, an unsupported code, a
//! call of a program that is missing.
//!
//! Only what depends on it is uncertain: each axis until a program names its place again, the kind of a move
//! until a code of group 01. Plain values, part of [`super::modal::State`].

/// One thing that may be other than the state says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Doubt {
    /// The place of the tip along X; the next absolute X ends it.
    X,
    /// The place along Z.
    Z,
    /// The angle of C.
    C,
    /// The tip stands beside the plane of X and Z, in which everything is drawn.
    Y,
    /// The way of the next move: it does not begin where it should.
    Path,
    /// Group 01; the next code of the group ends it.
    Code,
    /// What a cycle keeps from its blocks before: the place of G90 to G94, the amounts of G71 to G76.
    Cycle,
    /// The cycle that runs: an error in its blocks or in its contour was reported.
    Contour,
    /// What stands in variables; nothing ends it.
    Values,
    /// What coordinates mean: a mirror image, or a plane that was not switched on.
    Coordinates,
}

/// Everything that is in doubt.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Doubts(u16);

impl Doubts {
    /// These things.
    pub const fn of(doubts: &[Doubt]) -> Self {
        let (mut bits, mut at) = (0, 0);
        while at < doubts.len() {
            bits |= 1 << doubts[at] as u16;
            at += 1;
        }
        Self(bits)
    }

    /// Whether nothing is in doubt.
    #[inline]
    pub fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// Whether one of these things is in doubt.
    pub fn has_any(self, doubts: Self) -> bool {
        self.0 & doubts.0 != 0
    }

    /// Whether this is in doubt.
    pub fn has(self, doubt: Doubt) -> bool {
        self.has_any(Self::of(&[doubt]))
    }

    /// These are in doubt as well.
    pub fn join(&mut self, doubts: Self) {
        self.0 |= doubts.0;
    }

    /// This is in doubt as well.
    pub fn add(&mut self, doubt: Doubt) {
        self.join(Self::of(&[doubt]));
    }

    /// This is known again.
    pub fn remove(&mut self, doubt: Doubt) {
        self.0 &= !Self::of(&[doubt]).0;
    }
}
