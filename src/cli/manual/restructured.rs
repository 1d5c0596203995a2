//! Programs in reStructuredText: `.. code-block:: gcode`, `.. gcode-playground::`, and the HTML of `.. raw:: html`.
//!
//! In: a page. Out: its examples. Directives are found line by line; the indented lines below a directive are
//! its content.

use super::html::{self, Dialect};
use super::mapped::Mapped;
use super::markdown::options;
use super::{Attributes, Example, Holder, dedented, indent, is_gcode, lines, width};

/// Content of a directive.
enum Content {
    Program,
    Html,
    /// Code in another language.
    Code,
    /// Text that may contain further directives.
    Text,
}

/// The examples of a page.
pub fn examples(page: &[u8]) -> Vec<Example> {
    let lines = lines(page);
    let mut found = Vec::new();
    let mut index = 0;
    while index < lines.len() {
        let (start, end, _) = lines[index];
        index += 1;
        let Some((indent_of_own, content)) = directive(&page[start..end]) else { continue };
        if matches!(content, Content::Text) {
            continue;
        }
        // The lines that are indented more than the directive, up to the last one that is not blank.
        let below = lines[index..]
            .iter()
            .position(|line| indent(&page[line.0..line.1]).is_some_and(|indent| indent <= indent_of_own));
        let below = below.map_or(lines.len(), |below| index + below);
        if below == index {
            continue;
        }
        let block = Mapped::of(page, lines[index].0..lines[below - 1].2);
        index = below;
        match content {
            Content::Html => found.extend(html::examples(&block, Dialect::Html)),
            Content::Program => {
                let mut attributes = Attributes::default();
                let own = options(block.text(), &mut attributes);
                let program = dedented(&block.part(own..block.text().len()));
                let at = start + width(&page[start..end], indent_of_own);
                found.push(Example {
                    at,
                    program,
                    attributes,
                    holder: Holder::Code,
                    picture: None,
                    picture_is_quoted: false,
                    is_escaped: false,
                    is_closed: true,
                });
            }
            Content::Code | Content::Text => {}
        }
    }
    found
}

/// Indentation and content of the directive in a line; `None` if the line is not a directive.
fn directive(line: &[u8]) -> Option<(usize, Content)> {
    let text = std::str::from_utf8(line).ok()?;
    let (name, argument) = text.trim().strip_prefix(".. ")?.split_once("::")?;
    let content = match (name.trim(), argument.trim()) {
        ("gcode-playground", _) => Content::Program,
        ("code-block" | "code" | "sourcecode", language) if is_gcode(language) => Content::Program,
        ("raw", "html") => Content::Html,
        ("code-block" | "code" | "sourcecode" | "raw", _) => Content::Code,
        _ => Content::Text,
    };
    Some((indent(line)?, content))
}
