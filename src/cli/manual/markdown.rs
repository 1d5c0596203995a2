//! Programs in Markdown: code blocks with a G-code language, and the HTML between them.
//!
//! In: a page. Out: its examples. A CommonMark parser finds the blocks, so that fences in lists, in
//! quotations and in other fences are handled as on the rendered page.

use std::ops::Range;

use pulldown_cmark::{CodeBlockKind, Event, Options, Parser, Tag, TagEnd};

use super::html::{self, Dialect};
use super::mapped::Mapped;
use super::{Attributes, Example, Holder, is_gcode};

const START: &str = "<gcode-playground";
const END: &str = "</gcode-playground>";

/// The examples of a page; `text` is the page as a string.
pub fn examples(text: &str, page: &[u8]) -> Vec<Example> {
    let mut reader = Reader { page, found: Vec::new(), code: None, html: None, inline: None };
    for (event, range) in parser(text).into_offset_iter() {
        reader.event(event, range);
    }
    reader.found
}

/// The examples of a page with JSX, where elements may contain blank lines.
pub fn examples_with_jsx(text: &str, page: &[u8]) -> Vec<Example> {
    let mut reader = Reader { page, found: Vec::new(), code: None, html: None, inline: None };
    let mut outside = Mapped::default();
    let mut from = 0;
    for (event, range) in parser(&without_elements(text)).into_offset_iter() {
        let is_code = match &event {
            Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(_))) => true,
            // Braces contain a JSX string.
            Event::Code(_) => !page[..range.start].ends_with(b"{"),
            _ => false,
        };
        if is_code && range.start >= from {
            outside.keep(page, from..range.start);
            outside.read(b"\n", page, range.clone());
            from = range.end;
        }
        if reader.code.is_some() || is_code {
            reader.event(event, range);
        }
    }
    outside.keep(page, from..page.len());
    reader.found.extend(html::examples(&outside, Dialect::Jsx));
    reader.found
}

/// Replaces elements at the start of a line by letters, so that a fence inside a program does not count.
fn without_elements(text: &str) -> String {
    let mut left = String::with_capacity(text.len());
    // The end of the current element, while its lines continue.
    let mut end = 0;
    let mut at = 0;
    for line in text.split_inclusive('\n') {
        let start = at + line.len() - line.trim_start().len();
        if at >= end && text[start..].starts_with(START) {
            end = match html::end_of_tag(text.as_bytes(), start) {
                Some((open, false)) => {
                    let inside = &text[open..];
                    let next = inside.find(&["\n", START].concat()).unwrap_or(inside.len());
                    inside[..next].find(END).map_or(open, |end| open + end + END.len())
                }
                Some((open, true)) => open,
                // The tag extends to the end of the text.
                None => text.len(),
            };
        }
        for (place, letter) in line.char_indices() {
            match at + place < end && !letter.is_whitespace() {
                true => left.extend(std::iter::repeat_n('x', letter.len_utf8())),
                false => left.push(letter),
            }
        }
        at += line.len();
    }
    left
}

/// The parser, with the extensions that affect where blocks begin and end.
fn parser(text: &str) -> Parser<'_> {
    let options = Options::ENABLE_TABLES
        | Options::ENABLE_FOOTNOTES
        | Options::ENABLE_DEFINITION_LIST
        | Options::ENABLE_YAML_STYLE_METADATA_BLOCKS
        | Options::ENABLE_PLUSES_DELIMITED_METADATA_BLOCKS;
    Parser::new_ext(text, options)
}

struct Reader<'a> {
    page: &'a [u8],
    found: Vec<Example>,
    code: Option<Code>,
    html: Option<Mapped>,
    /// An inline element, from its start tag.
    inline: Option<Mapped>,
}

/// A code block with a program.
struct Code {
    at: usize,
    attributes: Attributes,
    is_directive: bool,
    text: Mapped,
}

impl Reader<'_> {
    fn event(&mut self, event: Event, range: Range<usize>) {
        match event {
            Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(info))) => {
                self.end_inline();
                self.code = info_string(&info).map(|(attributes, is_directive)| {
                    let text = Mapped::default();
                    Code { at: range.start, attributes, is_directive, text }
                });
            }
            Event::End(TagEnd::CodeBlock) => {
                if let Some(code) = self.code.take() {
                    self.found.push(code.example());
                }
            }
            Event::Text(text) if self.code.is_some() => {
                if let Some(code) = &mut self.code {
                    code.text.read(text.as_bytes(), self.page, range);
                }
            }
            Event::Start(Tag::HtmlBlock) => {
                self.end_inline();
                self.html = Some(Mapped::default());
            }
            Event::Html(text) => {
                if let Some(html) = &mut self.html {
                    html.read(text.as_bytes(), self.page, range);
                }
            }
            Event::End(TagEnd::HtmlBlock) => {
                if let Some(html) = self.html.take() {
                    self.found.extend(html::examples(&html, Dialect::Html));
                }
            }
            Event::InlineHtml(tag) => {
                if self.inline.is_none() && tag.to_ascii_lowercase().starts_with(START) {
                    self.inline = Some(Mapped::default());
                }
                if let Some(inline) = &mut self.inline {
                    inline.read(tag.as_bytes(), self.page, range);
                    if tag.to_ascii_lowercase().starts_with("</gcode-playground") {
                        self.end_inline();
                    }
                }
            }
            Event::Text(text) | Event::Code(text) => self.words(&text, range),
            Event::SoftBreak | Event::HardBreak => self.words("\n", range),
            Event::Start(tag) if !is_among_words(&tag.to_end()) => self.end_inline(),
            Event::End(tag) if !is_among_words(&tag) => self.end_inline(),
            _ => {}
        }
    }

    /// Appends the text of an inline element.
    fn words(&mut self, text: &str, range: Range<usize>) {
        let Some(inline) = &mut self.inline else { return };
        if !text.contains(['<', '&']) {
            inline.read(text.as_bytes(), self.page, range);
            return;
        }
        let same = self.page[range.clone()] == *text.as_bytes();
        for (at, letter) in text.char_indices() {
            let own = match same {
                true => range.start + at..range.start + at + letter.len_utf8(),
                false => range.clone(),
            };
            let mut buffer = [0; 4];
            let read = match letter {
                '<' => "&lt;",
                '&' => "&amp;",
                letter => letter.encode_utf8(&mut buffer),
            };
            inline.read(read.as_bytes(), self.page, own);
        }
    }

    fn end_inline(&mut self) {
        if let Some(inline) = self.inline.take() {
            self.found.extend(html::examples(&inline, Dialect::Html));
        }
    }
}

fn is_among_words(tag: &TagEnd) -> bool {
    matches!(tag, TagEnd::Emphasis | TagEnd::Strong | TagEnd::Strikethrough | TagEnd::Link | TagEnd::Image)
}

impl Code {
    fn example(mut self) -> Example {
        if self.is_directive {
            let start = options(self.text.text(), &mut self.attributes);
            self.text = self.text.part(start..self.text.text().len());
        }
        Example {
            at: self.at,
            program: self.text,
            attributes: self.attributes,
            holder: Holder::Code,
            picture: None,
            picture_is_quoted: false,
            is_escaped: false,
            is_closed: true,
        }
    }
}

/// Parses the info string of a fence: `gcode control=gsk`, `gcode,control=gsk`, `{code-block} gcode`. `None`
/// for another language. The second value says whether options may follow in the block, such as `:control:
/// gsk`.
fn info_string(info: &str) -> Option<(Attributes, bool)> {
    let mut words = words(info).into_iter();
    let mut language = words.next()?;
    let is_directive = info.trim_start().starts_with("{gcode-playground");
    if ["code-block", "code", "sourcecode"].contains(&language.as_str()) {
        language = words.next()?;
    }
    if !is_gcode(language.trim_start_matches('.')) {
        return None;
    }
    let mut attributes = Attributes::default();
    for word in words {
        let (name, value) = word.split_once('=').unwrap_or((&word, ""));
        attributes.put_if_missing(&name.to_ascii_lowercase(), value.to_owned());
    }
    Some((attributes, is_directive))
}

/// Splits at spaces, commas and braces; quotes group words and are removed.
fn words(info: &str) -> Vec<String> {
    let mut words = Vec::new();
    let mut word = String::new();
    let mut quote = None;
    for letter in info.chars() {
        match quote {
            Some(own) if own == letter => quote = None,
            Some(_) => word.push(letter),
            None if letter == '"' || letter == '\'' => quote = Some(letter),
            None if letter.is_whitespace() || [',', '{', '}'].contains(&letter) => {
                words.extend(Some(std::mem::take(&mut word)).filter(|word| !word.is_empty()));
            }
            None => word.push(letter),
        }
    }
    words.extend(Some(word).filter(|word| !word.is_empty()));
    words
}

/// Parses the options at the start of a directive, one `:control: gsk` per line; returns their end.
pub fn options(text: &[u8], attributes: &mut Attributes) -> usize {
    let mut start = 0;
    for (from, end, next) in super::lines(text) {
        let line = String::from_utf8_lossy(&text[from..end]);
        let Some((name, value)) = line.trim().strip_prefix(':').and_then(|line| line.split_once(':')) else {
            break;
        };
        if name.is_empty() || !name.chars().all(|letter| letter.is_ascii_alphanumeric() || letter == '-') {
            break;
        }
        attributes.put_if_missing(&name.to_ascii_lowercase(), value.trim().to_owned());
        start = next;
    }
    start
}
