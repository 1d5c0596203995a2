//! Under the drawing: its title, and what its lines and areas are.
//!
//! In: a scene and the words. Out: rows of text with samples, as wide as the drawing. Knows no language.

use super::super::{Scene, StrokeStyle};
use super::{Drawing, number};

/// From one row to the next, CSS pixels.
const LEADING: f64 = 20.0;
/// A sample and the space after it, CSS pixels.
const SAMPLE: f64 = 30.0;
/// Between two entries, CSS pixels.
const BETWEEN: f64 = 18.0;

/// What stands under a drawing, in its language.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Caption {
    /// What the drawing shows, such as the number and the name of the program.
    pub title: String,
    /// Rapids, cuts, threads.
    pub strokes: [&'static str; 3],
    /// The blank, where material is gone from it; what is left of it; chuck and tailstock; a collision.
    pub work: [&'static str; 4],
    /// What is milled under G12.1.
    pub milled: &'static str,
    /// That passes are drawn beside their places.
    pub apart: &'static str,
}

/// What explains a class of the drawing.
struct Entry {
    sample: String,
    text: &'static str,
}

impl Drawing {
    /// The rows, from `top` down; the answer is their height.
    pub(super) fn caption(&mut self, scene: &Scene, caption: &Caption, top: f64) -> f64 {
        let width = self.camera.size().width;
        let mut y = top + LEADING - 4.0;
        if !caption.title.is_empty() {
            self.text.push_str(&format!(
                r#"<text class="name" x="12" y="{}">{}</text>"#,
                number(y),
                escaped(&caption.title)
            ));
            self.text.push('\n');
            y += LEADING;
        }
        let mut x = 12.0;
        for Entry { sample, text } in self.entries(scene, caption) {
            let start = if sample.is_empty() { 0.0 } else { SAMPLE };
            let wide = start + wide(text);
            if x > 12.0 && x + wide > width - 12.0 {
                (x, y) = (12.0, y + LEADING);
            }
            let at = sample.replace("{x}", &number(x)).replace("{y}", &number(y - 4.0));
            let at = at.replace("{top}", &number(y - 10.0));
            self.text.push_str(&at);
            self.line(&format!(
                r#"<text class="key" x="{}" y="{}">{text}</text>"#,
                number(x + start),
                number(y)
            ));
            x += wide + BETWEEN;
        }
        y + 10.0 - top
    }

    /// What is in the drawing, and nothing else.
    fn entries(&self, scene: &Scene, caption: &Caption) -> Vec<Entry> {
        let mut entries = Vec::new();
        let styles = [StrokeStyle::Rapid, StrokeStyle::Feed, StrokeStyle::Thread];
        for (style, text) in styles.into_iter().zip(caption.strokes) {
            if scene.strokes().any(|stroke| stroke.style == style) {
                let name = style.name();
                entries.push(Entry {
                    sample: [r#"<g><path class=""#, name, r#"" d="M{x} {y}h24"/></g>"#].concat(),
                    text,
                });
            }
        }
        if let Some(work) = scene.work() {
            let there = [true, !work.part.is_empty(), !work.obstacles.is_empty(), !work.dangers.is_empty()];
            let classes = ["blank blank-frame", "part part-frame", "obstacle"];
            for (index, text) in caption.work.into_iter().enumerate().filter(|(index, _)| there[*index]) {
                let sample = match classes.get(index) {
                    Some(class) => {
                        [r#"<path class=""#, class, r#"" d="M{x} {top}h24v12h-24z"/>"#].concat()
                    }
                    None => r#"<path class="danger" d="M{x} {y}m4 0a8 8 0 1 0 16 0a8 8 0 1 0 -16 0m4 -4l8 8m0 -8l-8 8"/>"#.to_owned(),
                };
                entries.push(Entry { sample, text });
            }
        }
        if scene.work().is_some_and(|work| work.milled.is_some()) {
            let sample = r#"<path class="milled" d="M{x} {top}h24v12h-24zl24 12m0 -12l-24 12"/>"#.to_owned();
            entries.push(Entry { sample, text: caption.milled });
        }
        if self.apart.is_any() {
            entries.push(Entry { sample: String::new(), text: caption.apart });
        }
        entries
    }
}

/// About how wide a text is, CSS pixels: Chinese characters are twice as wide as others.
fn wide(text: &str) -> f64 {
    text.chars().map(|c| if c > '\u{2e80}' { 12.0 } else { 6.8 }).sum()
}

/// A text as XML has it.
pub(super) fn escaped(text: &str) -> String {
    let text: String = text.chars().filter(|c| !c.is_control()).collect();
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
