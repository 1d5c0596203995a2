//! The ways of drawing strokes: each style, sure or not.
//!
//! In: strokes. Out: [`Ink`], in the order in which they are drawn. Knows no colours or widths.

use super::{Stroke, StrokeStyle};

/// A way of drawing: a style, or that style where the stroke may be wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ink {
    /// As the style says.
    Sure(StrokeStyle),
    /// Dimmed.
    Uncertain(StrokeStyle),
}

impl Ink {
    /// All ways, in the order in which they are drawn.
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

    /// The style drawn.
    pub fn style(self) -> StrokeStyle {
        match self {
            Self::Sure(style) | Self::Uncertain(style) => style,
        }
    }

    /// The way a stroke is drawn.
    pub fn of(stroke: &Stroke) -> Self {
        Self::new(stroke.style, stroke.uncertain)
    }

    /// The way strokes of a style are drawn.
    pub fn new(style: StrokeStyle, uncertain: bool) -> Self {
        if uncertain { Self::Uncertain(style) } else { Self::Sure(style) }
    }

    /// Where it stands among as many as [`Ink::ALL`], in no order that matters.
    pub fn index(self) -> usize {
        match self {
            Self::Sure(style) => style as usize,
            Self::Uncertain(style) => StrokeStyle::ALL.len() + style as usize,
        }
    }
}
