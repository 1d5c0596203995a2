//! The programs in the source files of a manual, with their positions.
//!
//! In: the text of a page (Markdown, HTML, reStructuredText) and its name. Out: [`Example`]s. Must not know:
//! the meaning of a program, or its use.

pub mod attributes;
mod entities;
mod html;
mod mapped;
mod markdown;
mod restructured;

pub use mapped::Mapped;

use crate::source::Span;

/// A program in a page.
#[derive(Clone, Debug)]
pub struct Example {
    /// Byte offset in the page where the block or element begins.
    pub at: usize,
    /// The program, as the element reads it.
    pub program: Mapped,
    /// Its attributes, with the names of the element's attributes.
    pub attributes: Attributes,
    /// Kind of block or element that contains it.
    pub holder: Holder,
    /// The SVG shown in place of the element.
    pub picture: Option<Mapped>,
    /// Whether the picture is a JavaScript template literal, as in JSX.
    pub picture_is_quoted: bool,
    /// Whether `<` is written as `&lt;` in it.
    pub is_escaped: bool,
    /// Whether it is properly closed. In Markdown a blank line ends an element.
    pub is_closed: bool,
}

impl Example {
    /// Converts a span of the program to a span of the page; an empty program maps to the start of the block.
    pub fn in_page(&self, span: Span) -> Span {
        match self.program.text() {
            [] => Span::new(self.at, self.at),
            _ => self.program.in_page(span),
        }
    }
}

/// Kind of block or element that contains a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Holder {
    /// A code block, or a directive.
    Code,
    /// `<gcode-playground>`.
    Element,
    /// A marked `pre`, or a script.
    Marked,
}

/// Maximum number of attributes that are read of a tag; the element has fewer.
const MAX_ATTRIBUTES: usize = 100;

/// Attributes of an element, in order; the first one of a name counts.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Attributes(Vec<(String, String)>);

impl Attributes {
    /// Creates a list from names and values.
    pub fn of(attributes: &[(String, String)]) -> Self {
        Self(attributes.to_vec())
    }

    /// The value of an attribute.
    pub fn get(&self, name: &str) -> Option<&str> {
        self.0.iter().find(|(own, _)| own == name).map(|(_, value)| value.as_str())
    }

    /// Names and values, in order.
    pub fn all(&self) -> impl Iterator<Item = (&str, &str)> {
        self.0.iter().map(|(name, value)| (name.as_str(), value.as_str()))
    }

    fn put_if_missing(&mut self, name: &str, value: String) {
        if self.0.len() < MAX_ATTRIBUTES && self.get(name).is_none() {
            self.0.push((name.to_owned(), value));
        }
    }

    /// The `data-…` attributes, without the prefix.
    fn of_data(&self) -> Self {
        let own = self.0.iter().filter_map(|(name, value)| {
            let name = name.strip_prefix("data-").filter(|name| *name != "gcode-playground")?;
            Some((name.to_owned(), value.clone()))
        });
        Self(own.collect())
    }
}

/// Markup language of a page.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Markup {
    /// CommonMark with the extensions that manuals use.
    Markdown,
    /// Markdown with JSX.
    Mdx,
    /// HTML.
    Html,
    /// reStructuredText.
    Restructured,
}

impl Markup {
    /// Chooses by the ending of a file name; Markdown for an unknown ending.
    pub fn of(name: &str) -> Self {
        let ending = name.rsplit_once('.').map_or(String::new(), |(_, ending)| ending.to_ascii_lowercase());
        match ending.as_str() {
            "html" | "htm" | "xhtml" => Self::Html,
            "rst" | "rest" => Self::Restructured,
            "mdx" => Self::Mdx,
            _ => Self::Markdown,
        }
    }
}

/// The examples of a page, in order.
pub fn examples(page: &[u8], markup: Markup) -> Vec<Example> {
    let mut found = match markup {
        Markup::Markdown => markdown::examples(&characters(page), page),
        Markup::Mdx => markdown::examples_with_jsx(&characters(page), page),
        Markup::Html => html::examples(&Mapped::of(page, 0..page.len()), html::Dialect::Html),
        Markup::Restructured => restructured::examples(page),
    };
    found.sort_by_key(|example| example.at);
    found
}

/// A JavaScript template literal that contains no end tag of the element.
pub fn quoted(text: &str) -> String {
    let text = text.replace('\\', r"\\").replace('`', r"\`").replace("${", r"\${");
    text.replace("</gcode-playground", r"<\/gcode-playground")
}

/// Escapes a text for HTML.
pub fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            letter => escaped.push(letter),
        }
    }
    escaped
}

/// The page as a string with the same byte offsets.
fn characters(page: &[u8]) -> String {
    let mut text = String::with_capacity(page.len());
    for chunk in page.utf8_chunks() {
        text.push_str(chunk.valid());
        text.extend(chunk.invalid().iter().map(|_| '?'));
    }
    text
}

/// Whether the language of a code block is G-code.
fn is_gcode(language: &str) -> bool {
    ["gcode", "g-code", "nc", "cnc", "gcode-playground"].iter().any(|own| own.eq_ignore_ascii_case(language))
}

/// The program as the element reads it from a text: line ends are LF, without blank first and last lines and
/// common indentation.
fn dedented(text: &Mapped) -> Mapped {
    let lines = lines(text.text());
    let blank = |line: &(usize, usize, usize)| indent(&text.text()[line.0..line.1]).is_none();
    let first = lines.iter().position(|line| !blank(line)).unwrap_or(lines.len());
    let last = lines.iter().rposition(|line| !blank(line)).map_or(first, |last| last + 1);
    let lines = &lines[first..last];
    let common = lines.iter().filter_map(|line| indent(&text.text()[line.0..line.1])).min().unwrap_or(0);
    let mut program = Mapped::default();
    for (index, &(start, end, _)) in lines.iter().enumerate() {
        if index > 0 {
            let (_, before, next) = lines[index - 1];
            match text.text()[before..next] == *b"\n" {
                true => program.keep_of(text, before..next),
                false => program.read_of(b"\n", text, before..next),
            }
        }
        program.keep_of(text, start + width(&text.text()[start..end], common)..end);
    }
    program
}

/// Start and end of each line, and the start of the next one.
fn lines(text: &[u8]) -> Vec<(usize, usize, usize)> {
    let mut lines = Vec::new();
    let mut start = 0;
    while let Some(end) = memchr::memchr2(b'\n', b'\r', &text[start..]).map(|end| start + end) {
        let next = if text[end..].starts_with(b"\r\n") { end + 2 } else { end + 1 };
        lines.push((start, end, next));
        start = next;
    }
    lines.push((start, text.len(), text.len()));
    lines
}

/// Indentation of a line in characters; `None` if the line is blank.
fn indent(line: &[u8]) -> Option<usize> {
    let chunk = line.utf8_chunks().next()?;
    // JavaScript's definition of white space, as in `trim`.
    let is_blank = |letter: char| letter == '\u{feff}' || letter.is_whitespace() && letter != '\u{85}';
    let word = chunk.valid().chars().position(|letter| !is_blank(letter));
    word.or_else(|| (!chunk.invalid().is_empty()).then(|| chunk.valid().chars().count()))
}

/// Length of the first `characters` characters of a line, in bytes.
fn width(line: &[u8], characters: usize) -> usize {
    let line = line.utf8_chunks().next().map_or("", |chunk| chunk.valid());
    line.char_indices().nth(characters).map_or(line.len(), |(byte, _)| byte)
}

#[cfg(test)]
mod tests;
