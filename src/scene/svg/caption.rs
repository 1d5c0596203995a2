//! The caption under the drawing: its title, and a legend of its lines and areas.
//!
//! In: a scene and the words. Out: rows of text with samples, as wide as the drawing. Knows no language.

use super::super::annotation::Shape;
use super::super::{Scene, StrokeStyle};
use super::{Contents, Drawing, SvgOptions, drawn, number};
use crate::source::is_unprintable;

/// Distance between rows, CSS pixels.
const LEADING: f64 = 20.0;
/// Width of a sample and the space after it, CSS pixels.
const SAMPLE: f64 = 30.0;
/// Space between two entries, CSS pixels.
const BETWEEN: f64 = 18.0;
/// Margin of the rows, CSS pixels.
const MARGIN: f64 = 12.0;

/// The caption of a drawing, in its language.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Caption {
    /// The title, such as the number and the name of the program.
    pub title: String,
    /// The names of the entries, in the order of [`LEGEND`].
    pub legend: [&'static str; LEGEND.len()],
}

/// The samples of a legend, each as the text before and after the coordinates of its left middle.
///
/// Rapids, cuts, threads; the blank where material was removed, the part, chuck and tailstock, a collision,
/// milling under G12.1; a note that passes are displaced; the material of a zone; a tool.
pub const LEGEND: [[&str; 2]; 11] = [
    [r#"<g><path class="rapid" d="M"#, r#"h24"/></g>"#],
    [r#"<g><path class="feed" d="M"#, r#"h24"/></g>"#],
    [r#"<g><path class="thread" d="M"#, r#"h24"/></g>"#],
    [r#"<path class="blank blank-frame" d="M"#, r#"m0 -6h24v12h-24z"/>"#],
    [r#"<path class="part part-frame" d="M"#, r#"m0 -6h24v12h-24zm2 12l12 -12m-4 12l12 -12"/>"#],
    [r#"<path class="obstacle" d="M"#, r#"m0 -6h24v12h-24z"/>"#],
    [r#"<path class="danger" d="M"#, r#"m4 0a8 8 0 1 0 16 0a8 8 0 1 0 -16 0m4 -4l8 8m0 -8l-8 8"/>"#],
    [r#"<path class="milled" d="M"#, r#"m0 -6h24v12h-24zl24 12m0 -12l-24 12"/>"#],
    ["", ""],
    [r#"<path class="hatch" d="M"#, r#"m0 -6h24v12h-24zl12 12m-6 -12l12 12m-6 -12l12 12"/>"#],
    [
        r#"<g class="annotations"><path class="dimension" fill="none" d="M"#,
        r#"m5 -6l14 2l-2 11l-14 -2z"/></g>"#,
    ],
];

impl Drawing {
    /// Writes the rows from `top` down and from `left` on; returns their height.
    pub(super) fn caption(
        &mut self,
        scene: &Scene,
        caption: &Caption,
        options: &SvgOptions,
        [left, top]: [f64; 2],
    ) -> f64 {
        let [left, right] = [left + MARGIN, self.camera.size().width - MARGIN];
        let (mut x, mut y) = (left, top + LEADING - 4.0);
        if !caption.title.is_empty() {
            self.key(["name", &escaped(&caption.title)], x, y);
            y += LEADING;
        }
        let there = self.there(scene, options);
        for (index, text) in caption.legend.into_iter().enumerate() {
            if !there[index] {
                continue;
            }
            let [begin, end] = LEGEND[index];
            let sample = if begin.is_empty() { 0.0 } else { SAMPLE };
            let wide = sample + wide(text);
            if x > left && x + wide > right {
                (x, y) = (left, y + LEADING);
            }
            if !begin.is_empty() {
                let line = [begin, &number(x), " ", &number(y - 4.0), end].concat();
                self.line(&line);
            }
            self.key(["key", text], x + sample, y);
            x += wide + BETWEEN;
        }
        y + 10.0 - top
    }

    fn key(&mut self, [class, text]: [&str; 2], x: f64, y: f64) {
        let (x, y) = (number(x), number(y));
        let line =
            [r#"<text class=""#, class, r#"" x=""#, &x, r#"" y=""#, &y, r#"">"#, text, "</text>"].concat();
        self.line(&line);
    }

    /// Which entries occur in the drawing.
    fn there(&self, scene: &Scene, options: &SvgOptions) -> [bool; LEGEND.len()] {
        let mut there = [false; LEGEND.len()];
        if options.contents == Contents::Part {
            return there;
        }
        for stroke in drawn(scene, options) {
            match stroke.style {
                StrokeStyle::Rapid => there[0] = true,
                StrokeStyle::Feed => there[1] = true,
                StrokeStyle::Thread => there[2] = true,
                StrokeStyle::Dwell => {}
            }
        }
        if let Some(work) = scene.work() {
            there[3] = true;
            there[4] = !work.part.is_empty();
            let seen = self.camera.seen();
            there[5] = !options.is_figure() && work.obstacles.iter().flatten().any(|at| seen.contains(*at));
            there[6] = !work.dangers.is_empty();
            there[7] = work.milled.is_some();
        }
        there[8] = self.apart.has_passes;
        let has = |is_meant: fn(&Shape) -> bool| options.annotations.iter().any(|own| is_meant(&own.shape));
        there[9] = has(|shape| matches!(shape, Shape::Zone { .. }));
        there[10] = has(|shape| matches!(shape, Shape::Outline(_)));
        there
    }
}

/// Approximate width of a text, CSS pixels: Chinese characters are twice as wide as others.
fn wide(text: &str) -> f64 {
    text.chars().map(|c| if c > '\u{2e80}' { 12.0 } else { 6.8 }).sum()
}

/// Escapes a text for XML.
pub(super) fn escaped(text: &str) -> String {
    let mut escaped = String::new();
    for c in text.chars() {
        match c {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            c if c.is_control() || is_unprintable(c) => {}
            c => escaped.push(c),
        }
    }
    escaped
}
