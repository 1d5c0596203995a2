//! The programs in the sources of a manual, each with its places there.
//!
//! In: the text of a page (Markdown, HTML, reStructuredText) and its name. Out: [`Example`]s. Must not know: what a
//! program says, or what becomes of it.

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
    /// Where that begins which holds it: a byte of the page.
    pub at: usize,
    /// The program, as the element reads it.
    pub program: Mapped,
    /// What is said of it, by the names of the element's attributes.
    pub attributes: Attributes,
    /// What holds it.
    pub holder: Holder,
    /// The SVG that is shown in place of the element.
    pub picture: Option<Mapped>,
    /// Whether the picture is a text between back quotes, as JSX has it.
    pub picture_is_quoted: bool,
    /// Whether `<` is written `&lt;` in it.
    pub is_escaped: bool,
    /// Whether it ends where it should. In Markdown a blank line ends an element.
    pub is_closed: bool,
}

impl Example {
    /// A span of the program as one of the page; an empty program is where it begins.
    pub fn in_page(&self, span: Span) -> Span {
        match self.program.text() {
            [] => Span::new(self.at, self.at),
            _ => self.program.in_page(span),
        }
    }
}

/// What holds a program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Holder {
    /// A block of code, or a directive.
    Code,
    /// `<gcode-playground>`.
    Element,
    /// A marked `pre`, or a script.
    Marked,
}

/// More attributes than the element has, which a tag may have all the same, are not looked at.
const MOST_ATTRIBUTES: usize = 100;

/// Attributes of an element, in their order; the first of a name counts.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Attributes(Vec<(String, String)>);

impl Attributes {
    /// Attributes with their values.
    pub fn of(attributes: &[(String, String)]) -> Self {
        Self(attributes.to_vec())
    }

    /// The value of an attribute.
    pub fn get(&self, name: &str) -> Option<&str> {
        self.0.iter().find(|(own, _)| own == name).map(|(_, value)| value.as_str())
    }

    /// Names and values, in their order.
    pub fn all(&self) -> impl Iterator<Item = (&str, &str)> {
        self.0.iter().map(|(name, value)| (name.as_str(), value.as_str()))
    }

    fn put_if_missing(&mut self, name: &str, value: String) {
        if self.0.len() < MOST_ATTRIBUTES && self.get(name).is_none() {
            self.0.push((name.to_owned(), value));
        }
    }

    /// Those that are written as `data-…`, without that.
    fn of_data(&self) -> Self {
        let own = self.0.iter().filter_map(|(name, value)| {
            let name = name.strip_prefix("data-").filter(|name| *name != "gcode-playground")?;
            Some((name.to_owned(), value.clone()))
        });
        Self(own.collect())
    }
}

/// How a page is written.
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
    /// By the ending of a file's name; Markdown for any other ending.
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

/// The examples of a page, in their order.
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

/// A text between back quotes of JavaScript, in which no element ends.
pub fn quoted(text: &str) -> String {
    let text = text.replace('\\', r"\\").replace('`', r"\`").replace("${", r"\${");
    text.replace("</gcode-playground", r"<\/gcode-playground")
}

/// A text as it is written in HTML.
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

/// The page as characters, byte for byte in the same places.
fn characters(page: &[u8]) -> String {
    let mut text = String::with_capacity(page.len());
    for chunk in page.utf8_chunks() {
        text.push_str(chunk.valid());
        text.extend(chunk.invalid().iter().map(|_| '?'));
    }
    text
}

/// Whether the language that a block of code names is this one.
fn is_gcode(language: &str) -> bool {
    ["gcode", "g-code", "nc", "cnc", "gcode-playground"].iter().any(|own| own.eq_ignore_ascii_case(language))
}

/// The program as the element takes it from a text: line ends are LF, without blank first and last lines and the
/// common indent.
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

/// Start and end of each line, and the start of the next.
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

/// How many characters before the first word of a line are blank; nothing in a blank line.
fn indent(line: &[u8]) -> Option<usize> {
    let chunk = line.utf8_chunks().next()?;
    // As JavaScript trims.
    let is_blank = |letter: char| letter == '\u{feff}' || letter.is_whitespace() && letter != '\u{85}';
    let word = chunk.valid().chars().position(|letter| !is_blank(letter));
    word.or_else(|| (!chunk.invalid().is_empty()).then(|| chunk.valid().chars().count()))
}

/// The bytes of the first characters of a line.
fn width(line: &[u8], characters: usize) -> usize {
    let line = line.utf8_chunks().next().map_or("", |chunk| chunk.valid());
    line.char_indices().nth(characters).map_or(line.len(), |(byte, _)| byte)
}

#[cfg(test)]
mod tests;
