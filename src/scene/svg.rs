//! The picture as a stand-alone SVG file.
//!
//! In: a scene. Out: text that any browser or manual can show.

use super::Scene;

/// How the file is to look.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SvgOptions {
    /// Width, CSS pixels; the height follows from the picture.
    pub width: f64,
}

impl Default for SvgOptions {
    fn default() -> Self {
        Self { width: 960.0 }
    }
}

/// The picture as an SVG file.
pub fn svg(_scene: &Scene, _options: &SvgOptions) -> String {
    String::new()
}
