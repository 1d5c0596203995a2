//! The inks: the style in which a stroke is drawn, and whether it is certain.
//!
//! In: strokes. Out: [`Ink`], in drawing order. Knows no colours or widths.

use super::{Stroke, StrokeStyle};

/// A stroke style, certain or uncertain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ink {
    /// Drawn in its style.
    Sure(StrokeStyle),
    /// Drawn dimmed, because the stroke may be wrong.
    Uncertain(StrokeStyle),
}

impl Ink {
    /// All inks, in drawing order.
    pub const ALL: [Ink; 8] = [
        Ink::Uncertain(StrokeStyle::Rapid),
        Ink::Sure(StrokeStyle::Rapid),
        Ink::Uncertain(StrokeStyle::Dwell),
        Ink::Uncertain(StrokeStyle::Feed),
        Ink::Uncertain(StrokeStyle::Thread),
        Ink::Sure(StrokeStyle::Dwell),
        Ink::Sure(StrokeStyle::Feed),
        Ink::Sure(StrokeStyle::Thread),
    ];

    /// The stroke style.
    pub fn style(self) -> StrokeStyle {
        match self {
            Self::Sure(style) | Self::Uncertain(style) => style,
        }
    }

    /// The ink of a stroke.
    pub fn of(stroke: &Stroke) -> Self {
        Self::new(stroke.style, stroke.uncertain)
    }

    /// The ink of a style.
    pub fn new(style: StrokeStyle, uncertain: bool) -> Self {
        if uncertain { Self::Uncertain(style) } else { Self::Sure(style) }
    }

    /// A unique index, less than the length of [`Ink::ALL`]; the order has no meaning.
    pub fn index(self) -> usize {
        match self {
            Self::Sure(style) => style as usize,
            Self::Uncertain(style) => StrokeStyle::ALL.len() + style as usize,
        }
    }
}
