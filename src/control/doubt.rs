//! What is unknown after something that could not be carried out: a refused block, an unsupported code, a
//! call of a missing program.
//!
//! Only dependent values are uncertain: each axis until the program gives its position again, the kind of
//! move until a code of group 01. Part of [`super::modal::State`].

/// A part of the state that may be wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Doubt {
    /// The X position of the tip, until the next absolute X.
    X,
    /// The Z position.
    Z,
    /// The angle of C.
    C,
    /// The drawn path: the tip is not at Y0, where the path is drawn.
    Y,
    /// The path of the next move: its code or a word that shapes it (I, K, R or A) is unknown, or it may
    /// start at another point.
    Path,
    /// The code of group 01, until the next one.
    Code,
    /// Values that a cycle keeps from earlier blocks: the end point and taper of G90, G92 and G94, the
    /// parameters of G71 to G76.
    Cycle,
    /// The running cycle: an error in its blocks or contour was reported.
    Contour,
    /// The values of variables. They stay in doubt until the end.
    Values,
    /// The meaning of coordinates: a mirror image, or a plane that was not switched on.
    Coordinates,
}

/// A set of doubts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Doubts(u16);

impl Doubts {
    /// The set of these doubts.
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

    /// Whether any of these is in doubt.
    pub fn has_any(self, doubts: Self) -> bool {
        self.0 & doubts.0 != 0
    }

    /// Whether this is in doubt.
    pub fn has(self, doubt: Doubt) -> bool {
        self.has_any(Self::of(&[doubt]))
    }

    /// Adds all of these.
    pub fn join(&mut self, doubts: Self) {
        self.0 |= doubts.0;
    }

    /// Adds one.
    pub fn add(&mut self, doubt: Doubt) {
        self.join(Self::of(&[doubt]));
    }

    /// Removes one: its value is known again.
    pub fn remove(&mut self, doubt: Doubt) {
        self.0 &= !Self::of(&[doubt]).0;
    }
}
