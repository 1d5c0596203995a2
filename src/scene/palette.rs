//! The colours of the picture.
//!
//! In: nothing, or the colours of the page around it. Out: [`Palette`], read by every exporter.

use std::borrow::Cow;

/// Makes the palette of rows: what a colour is of, its name for JavaScript, on white paper, on a dark ground.
macro_rules! palette {
    ($($(#[$doc:meta])+ $field:ident $name:literal: $light:literal, $dark:literal;)+) => {
        /// CSS colours of everything that is drawn.
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

            /// Light lines on a dark ground.
            pub const fn dark() -> Self {
                Self { $($field: Cow::Borrowed($dark)),+ }
            }

            /// All colours by their names for JavaScript.
            pub fn by_name(&mut self) -> impl Iterator<Item = (&'static str, &mut Cow<'static, str>)> {
                [$(($name, &mut self.$field)),+].into_iter()
            }
        }
    };
}

palette! {
    /// The background.
    background "background": "#ffffff", "#15181c";
    /// Grid lines.
    grid "grid": "#eceff2", "#23282e";
    /// Rulers, ticks and the spindle centre line.
    axis "axis": "#8b95a1", "#6b7681";
    /// Tick labels.
    text "text": "#56606b", "#a3aeb9";
    /// The blank, where material is gone from it.
    stock "stock": "#f6f3ec", "#211f1b";
    /// Outline of the blank.
    stock_edge "stockEdge": "#c8bda6", "#6a6250";
    /// What is left of it.
    part "part": "#e3dcc8", "#3a3629";
    /// Outline of what is left, and its hatching.
    part_edge "partEdge": "#8a7f63", "#a0936f";
    /// Where something runs into something.
    danger "danger": "#c02b2b", "#ff8f87";
    /// What only the part has that was kept for comparison, or the first of two.
    only_first "onlyFirst": "#9c36b5", "#da9bea";
    /// What only the other one has.
    only_second "onlySecond": "#0b7285", "#66d9e8";
    /// Rapids.
    rapid "rapid": "#7f8b98", "#7d8894";
    /// Cuts at feed.
    feed "feed": "#174ea6", "#7fb2ff";
    /// Threads.
    thread "thread": "#0b7a53", "#4fd0a0";
    /// Strokes of the block the cursor is in.
    highlight "highlight": "#e8590c", "#ff9248";
    /// The stroke under the pointer.
    hover "hover": "#f08c00", "#ffc46b";
    /// The tool at the playhead.
    tool "tool": "#b3261e", "#ff8178";
    /// Strokes that may be wrong.
    uncertain "uncertain": "#b6bec8", "#4b545e";
}

impl Default for Palette {
    fn default() -> Self {
        Self::light()
    }
}
