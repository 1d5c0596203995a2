//! The colours of the picture.
//!
//! In: nothing, or the colours of the surrounding page. Out: [`Palette`], read by every exporter. The
//! defaults are the colours of the page (`www/src/tokens.css`), on white paper.

use std::borrow::Cow;

/// Defines the palette from rows: the documentation of a colour, its name in JavaScript, its values on light
/// and dark background.
macro_rules! palette {
    ($($(#[$doc:meta])+ $field:ident $name:literal: $light:literal, $dark:literal;)+) => {
        /// The CSS colours of everything that is drawn.
        #[derive(Clone, Debug, PartialEq, Eq)]
        #[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), serde(rename_all = "camelCase"))]
        pub struct Palette {
            $($(#[$doc])+ #[cfg_attr(target_arch = "wasm32", tsify(type = "string"))] pub $field: Cow<'static, str>,)+
        }

        impl Palette {
            /// Dark lines on white paper.
            pub const fn light() -> Self {
                Self { $($field: Cow::Borrowed($light)),+ }
            }

            /// Light lines on a dark background.
            pub const fn dark() -> Self {
                Self { $($field: Cow::Borrowed($dark)),+ }
            }

            /// All colours with their JavaScript names.
            pub fn by_name(&mut self) -> impl Iterator<Item = (&'static str, &mut Cow<'static, str>)> {
                const NAMES: &[&str] = &[$($name),+];
                NAMES.iter().copied().zip([$(&mut self.$field),+])
            }
        }
    };
}

palette! {
    /// The background.
    background "background": "#ffffff", "#14191f";
    /// Grid lines.
    grid "grid": "#ebedeb", "#20272e";
    /// Rulers, ticks and the spindle centre line.
    axis "axis": "#8a949b", "#66737f";
    /// Tick labels.
    text "text": "#5a656e", "#97a4b0";
    /// The blank where material has been removed.
    stock "stock": "#f5f3ec", "#252c33";
    /// Outline of the blank.
    stock_edge "stockEdge": "#b9b09a", "#555e66";
    /// The part.
    part "part": "#e4ddc9", "#353a3d";
    /// Outline and hatching of the part.
    part_edge "partEdge": "#857a5e", "#8f99a1";
    /// Collisions.
    danger "danger": "#c02b2b", "#ff8f87";
    /// Areas that only the first of two compared parts has (the one kept for comparison).
    only_first "onlyFirst": "#9c36b5", "#da9bea";
    /// Areas that only the second part has.
    only_second "onlySecond": "#0b7285", "#66d9e8";
    /// Rapids.
    rapid "rapid": "#b85c1e", "#e59a5f";
    /// Cuts at feed.
    feed "feed": "#1565a8", "#6fb6f5";
    /// Threads.
    thread "thread": "#7a3fae", "#c59bf2";
    /// Strokes of the block the cursor is in.
    highlight "highlight": "#cf1f6b", "#ff79ad";
    /// The stroke under the pointer.
    hover "hover": "#b07800", "#ffc94d";
    /// The tool at the playhead.
    tool "tool": "#26323c", "#f0f3f5";
    /// Strokes that may be wrong.
    uncertain "uncertain": "#8a7a2b", "#cbb964";
}

impl Default for Palette {
    #[inline(never)]
    fn default() -> Self {
        Self::light()
    }
}
