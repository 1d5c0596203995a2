//! Parts of the sentences about strokes, fixes and rewrites.

/// Lists the phrases once, for the enum and for tests of all phrases.
macro_rules! phrases {
    ($($name:ident),* $(,)?) => {
        /// A part of a sentence, or a short sentence, in any language.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub(super) enum Phrase { $($name),* }

        #[cfg(test)]
        impl Phrase {
            /// Every phrase.
            pub(super) const ALL: &[Self] = &[$(Self::$name),*];
        }
    };
}

phrases! {
    // Titles of fixes
    CloseComment, DecimalPoint, LetterO, Minus, Write, Delete, Insert,
    // Moves that form a cycle
    AsCycle, AsCyclePasses,
    // Motions
    Rapid, Feed, ArcClockwise, ArcCounterclockwise, Thread, Dwell, DwellFor,
    // Motions of cycles, and their parts
    OfCycle, CutOfCycle, Pass, PassOf,
    Infeed, Cut, PullOut, Retract, Return, Approach, Escape, Contour, Relief, Stepover,
    AtRapid, WithSpindle, AtFeed,
}
