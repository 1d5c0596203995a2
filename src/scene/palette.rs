//! The colours of the picture.
//!
//! In: nothing, or the colours of the page around it. Out: [`Palette`], read by every exporter.

/// CSS colours of everything that is drawn.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(target_arch = "wasm32", derive(tsify::Tsify), serde(rename_all = "camelCase"))]
pub struct Palette {
    /// The background.
    pub background: String,
    /// Grid lines.
    pub grid: String,
    /// Rulers, ticks and the spindle centre line.
    pub axis: String,
    /// Tick labels.
    pub text: String,
    /// The blank, where material is gone from it.
    pub stock: String,
    /// Outline of the blank.
    pub stock_edge: String,
    /// What is left of it.
    pub part: String,
    /// Outline of what is left, and its hatching.
    pub part_edge: String,
    /// Where something runs into something.
    pub danger: String,
    /// What only the part has that was kept for comparison, or the first of two.
    pub only_first: String,
    /// What only the other one has.
    pub only_second: String,
    /// Rapids.
    pub rapid: String,
    /// Cuts at feed.
    pub feed: String,
    /// Threads.
    pub thread: String,
    /// Strokes of the block the cursor is in.
    pub highlight: String,
    /// The stroke under the pointer.
    pub hover: String,
    /// The tool at the playhead.
    pub tool: String,
    /// Strokes that may be wrong.
    pub uncertain: String,
}

impl Palette {
    /// Dark lines on white paper.
    pub fn light() -> Self {
        Self {
            background: "#ffffff".into(),
            grid: "#eceff2".into(),
            axis: "#8b95a1".into(),
            text: "#56606b".into(),
            stock: "#f6f3ec".into(),
            stock_edge: "#c8bda6".into(),
            part: "#e3dcc8".into(),
            part_edge: "#8a7f63".into(),
            danger: "#c02b2b".into(),
            only_first: "#9c36b5".into(),
            only_second: "#0b7285".into(),
            rapid: "#7f8b98".into(),
            feed: "#174ea6".into(),
            thread: "#0b7a53".into(),
            highlight: "#e8590c".into(),
            hover: "#f08c00".into(),
            tool: "#b3261e".into(),
            uncertain: "#b6bec8".into(),
        }
    }

    /// Light lines on a dark ground.
    pub fn dark() -> Self {
        Self {
            background: "#15181c".into(),
            grid: "#23282e".into(),
            axis: "#6b7681".into(),
            text: "#a3aeb9".into(),
            stock: "#211f1b".into(),
            stock_edge: "#6a6250".into(),
            part: "#3a3629".into(),
            part_edge: "#a0936f".into(),
            danger: "#ff8f87".into(),
            only_first: "#da9bea".into(),
            only_second: "#66d9e8".into(),
            rapid: "#7d8894".into(),
            feed: "#7fb2ff".into(),
            thread: "#4fd0a0".into(),
            highlight: "#ff9248".into(),
            hover: "#ffc46b".into(),
            tool: "#ff8178".into(),
            uncertain: "#4b545e".into(),
        }
    }
}

impl Default for Palette {
    fn default() -> Self {
        Self::light()
    }
}
