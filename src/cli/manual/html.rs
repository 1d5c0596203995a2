//! Programs in HTML, found in the same way as by a browser and the element: in `<gcode-playground>`, in
//! marked `<pre>` and `<script>`, and in scripts of the type `text/x-gcode`.
//!
//! In: a page, or a block of HTML in a page. Out: its examples. Tags are parsed as in browsers; slotted
//! content is not part of the program. With JSX, attributes and text may also be `{…}`.

use std::ops::Range;

use memchr::{memchr, memmem};

use super::entities;
use super::mapped::Mapped;
use super::{Attributes, Example, Holder, dedented};

/// Tag name of the element.
const ELEMENT: &[u8] = b"gcode-playground";
/// Attribute that marks a `pre` or a script as an element.
const MARK: &str = "data-gcode-playground";
/// Tags without an end tag.
const VOID: [&[u8]; 14] = [
    b"area", b"base", b"br", b"col", b"embed", b"hr", b"img", b"input", b"link", b"meta", b"param",
    b"source", b"track", b"wbr",
];
/// Tags whose content is not displayed.
const NO_TEXT: [&[u8]; 2] = [b"template", b"noscript"];
/// Tags whose content is not markup.
const RAW: [&[u8]; 4] = [b"script", b"style", b"textarea", b"title"];

/// Syntax allowed besides HTML.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dialect {
    /// HTML only.
    Html,
    /// JSX: `{…}` is allowed, and `<a/>` is an empty element.
    Jsx,
}

/// The examples in a text, in order.
pub fn examples(html: &Mapped, dialect: Dialect) -> Vec<Example> {
    let mut scanner =
        Scanner { html, text: html.text(), dialect, found: Vec::new(), open: None, braces: true };
    scanner.all();
    scanner.found
}

/// A tag in the text.
struct Tag {
    /// In lower case.
    name: Vec<u8>,
    is_end: bool,
    /// Whether it ends in `/>`.
    is_closed: bool,
    attributes: Attributes,
    range: Range<usize>,
}

impl Tag {
    fn has_type(&self, kind: &str) -> bool {
        self.attributes.get("type").is_some_and(|own| own.trim().eq_ignore_ascii_case(kind))
    }
}

/// An element whose end tag was not read yet.
struct Open {
    name: Vec<u8>,
    start: usize,
    attributes: Attributes,
    holder: Holder,
    own: Mapped,
    pre: Option<Mapped>,
    in_pre: bool,
    script: Option<Mapped>,
    /// Slotted or hidden content: tag name, nesting depth of this name, start.
    aside: Option<(Vec<u8>, usize, usize)>,
    is_picture: bool,
    picture: Option<Mapped>,
    picture_is_quoted: bool,
}

impl Open {
    /// The buffer that current text is appended to; `None` inside slotted content.
    fn text(&mut self) -> Option<&mut Mapped> {
        match &mut self.pre {
            _ if self.aside.is_some() => None,
            Some(pre) if self.in_pre => Some(pre),
            _ => Some(&mut self.own),
        }
    }
}

struct Scanner<'a> {
    html: &'a Mapped,
    text: &'a [u8],
    dialect: Dialect,
    found: Vec<Example>,
    open: Option<Open>,
    /// Whether a `{` may still have a matching `}`.
    braces: bool,
}

impl Scanner<'_> {
    fn all(&mut self) {
        let mut at = 0;
        while at < self.text.len() {
            at = match self.text[at] {
                b'<' => self.markup(at),
                b'{' if self.dialect == Dialect::Jsx && self.open.is_some() && self.braces => self.braced(at),
                _ => self.words(at),
            };
        }
        if let Some(open) = self.open.take() {
            self.finish(open, self.text.len(), false);
        }
    }

    /// Reads text up to the next markup; returns the position of the markup.
    fn words(&mut self, at: usize) -> usize {
        let rest = &self.text[at + 1..];
        let next = match self.dialect {
            Dialect::Jsx if self.open.is_some() && self.braces => memchr::memchr2(b'<', b'{', rest),
            _ => memchr(b'<', rest),
        };
        let end = next.map_or(self.text.len(), |next| at + 1 + next);
        self.say(at..end);
        end
    }

    /// Appends text of the page to the open element.
    fn say(&mut self, range: Range<usize>) {
        if let Some(text) = self.open.as_mut().and_then(Open::text) {
            entities::read(self.html, range, text);
        }
    }

    /// Reads `{…}`; appends it if it is a string literal.
    fn braced(&mut self, at: usize) -> usize {
        let Some(end) = braces(self.text, at) else {
            self.braces = false;
            return self.words(at);
        };
        if let Some(text) = self.open.as_mut().and_then(Open::text)
            && let Some(inner) = literal(self.text, at + 1..end - 1)
        {
            unquoted(self.html, inner, text);
        }
        end
    }

    /// Reads a tag, a comment, or a `<` that is neither; returns its end.
    fn markup(&mut self, at: usize) -> usize {
        let rest = &self.text[at..];
        if rest.starts_with(b"<!--") {
            return memmem::find(&rest[4..], b"-->").map_or(self.text.len(), |end| at + 4 + end + 3);
        }
        let letter = |index: usize| rest.get(index).is_some_and(u8::is_ascii_alphabetic);
        match rest.get(1) {
            Some(b'/') if letter(2) => {}
            Some(b'!' | b'?' | b'/') => {
                return memchr(b'>', rest).map_or(self.text.len(), |end| at + end + 1);
            }
            _ if letter(1) => {}
            _ => return self.words(at),
        }
        let Some(tag) = tag(self.text, at, self.dialect) else { return self.text.len() };
        let end = tag.range.end;
        if tag.is_end {
            self.end_tag(&tag);
            return end;
        }
        let is_raw = RAW.contains(&tag.name.as_slice()) && !(tag.is_closed && self.in_picture());
        let raw = is_raw.then(|| raw_text(self.text, end, &tag.name));
        self.start_tag(tag, raw.clone());
        raw.map_or(end, |raw| raw.end)
    }

    /// Whether `/>` closes a tag: it does in SVG and JSX.
    fn in_picture(&self) -> bool {
        self.dialect == Dialect::Jsx || self.open.as_ref().is_some_and(|open| open.is_picture)
    }

    fn start_tag(&mut self, tag: Tag, raw: Option<Range<usize>>) {
        // An element inside an element: the outer one was never closed.
        if tag.name == ELEMENT
            && let Some(open) = self.open.take()
        {
            self.finish(open, tag.range.start, false);
        }
        let Some(open) = &mut self.open else {
            self.outermost(tag, raw);
            return;
        };
        let closed = tag.is_closed && (open.is_picture || self.dialect == Dialect::Jsx);
        if let Some((name, depth, _)) = &mut open.aside {
            if *name == tag.name && !closed {
                *depth += 1;
            }
            return;
        }
        let is_slotted = tag.attributes.get("slot").is_some();
        if tag.name == b"script" {
            let raw = raw.unwrap_or_default();
            if !is_slotted && tag.has_type("text/x-gcode") {
                open.script.get_or_insert_with(|| self.html.part(raw));
            } else if !is_slotted && tag.has_type("application/json") {
                let json = String::from_utf8_lossy(&self.text[raw]).trim().to_owned();
                open.attributes.put_if_missing("setup", json);
            }
        } else if raw.is_some() || VOID.contains(&tag.name.as_slice()) {
            // Raw text and void elements contain no program text.
        } else if is_slotted && let Some(inner) = inner_html(self.text, &tag, self.dialect) {
            let mut picture = Mapped::default();
            unquoted(self.html, inner, &mut picture);
            (open.picture, open.picture_is_quoted) = (Some(picture), true);
        } else if is_slotted || NO_TEXT.contains(&tag.name.as_slice()) {
            open.is_picture = tag.name == b"svg" && open.picture.is_none();
            if !(tag.is_closed && (open.is_picture || self.dialect == Dialect::Jsx)) {
                open.aside = Some((tag.name, 1, tag.range.start));
            }
        } else if tag.name == b"pre" && open.pre.is_none() && open.holder == Holder::Element {
            (open.pre, open.in_pre) = (Some(Mapped::default()), true);
        }
    }

    /// Handles a tag outside of any element.
    fn outermost(&mut self, tag: Tag, raw: Option<Range<usize>>) {
        let is_marked = tag.attributes.get(MARK).is_some();
        let holder = match tag.name.as_slice() {
            ELEMENT => Holder::Element,
            b"pre" if is_marked => Holder::Marked,
            b"script" if tag.has_type("text/x-gcode") => Holder::Marked,
            _ => return,
        };
        let attributes = match holder {
            Holder::Marked => tag.attributes.of_data(),
            _ => tag.attributes,
        };
        let open = Open {
            start: tag.range.start,
            attributes,
            holder,
            own: Mapped::default(),
            pre: None,
            in_pre: false,
            script: raw.clone().map(|raw| self.html.part(raw)),
            aside: None,
            is_picture: false,
            picture: None,
            picture_is_quoted: false,
            name: tag.name,
        };
        match raw {
            Some(raw) => {
                let is_ended = raw.end < self.text.len();
                self.finish(open, raw.end, is_ended);
            }
            None if tag.is_closed && self.dialect == Dialect::Jsx => self.finish(open, tag.range.end, true),
            None => self.open = Some(open),
        }
    }

    fn end_tag(&mut self, tag: &Tag) {
        let Some(open) = &mut self.open else { return };
        if let Some((name, depth, start)) = &mut open.aside
            && *name == tag.name
            && *name != open.name
        {
            *depth -= 1;
            if *depth == 0 {
                if open.is_picture {
                    open.picture = Some(self.html.part(*start..tag.range.end));
                }
                (open.aside, open.is_picture) = (None, false);
            }
            return;
        }
        if open.aside.is_none() && tag.name == b"pre" && open.in_pre {
            open.in_pre = false;
        } else if tag.name == open.name
            && let Some(open) = self.open.take()
        {
            self.finish(open, tag.range.end, true);
        }
    }

    fn finish(&mut self, open: Open, end: usize, is_closed: bool) {
        let is_escaped = open.script.is_none() && self.dialect == Dialect::Html;
        let text = open.script.or(open.pre).unwrap_or(open.own);
        let place = self.html.in_page(crate::source::Span::new(open.start, end));
        self.found.push(Example {
            at: place.start as usize,
            program: dedented(&text),
            attributes: open.attributes,
            holder: open.holder,
            picture: open.picture,
            picture_is_quoted: open.picture_is_quoted,
            is_escaped,
            is_closed,
        });
    }
}

/// End of the JSX tag at `at`, and whether the tag is self-closing; `None` if the tag is not terminated.
pub fn end_of_tag(text: &[u8], at: usize) -> Option<(usize, bool)> {
    tag(text, at, Dialect::Jsx).map(|tag| (tag.range.end, tag.is_closed))
}

/// Parses the tag at `at`; `None` if it is not terminated.
fn tag(text: &[u8], at: usize, dialect: Dialect) -> Option<Tag> {
    let is_end = text.get(at + 1) == Some(&b'/');
    let mut from = at + 1 + usize::from(is_end);
    let name = from;
    while !matches!(text.get(from)?, b' ' | b'\t' | b'\n' | b'\r' | b'\x0c' | b'/' | b'>') {
        from += 1;
    }
    let name = text[name..from].to_ascii_lowercase();
    let mut attributes = Attributes::default();
    loop {
        match text.get(from)? {
            b' ' | b'\t' | b'\n' | b'\r' | b'\x0c' => from += 1,
            b'>' => {
                let is_closed = text[from - 1] == b'/';
                return Some(Tag { name, is_end, is_closed, attributes, range: at..from + 1 });
            }
            b'/' => from += 1,
            // `{...properties}` and comments.
            b'{' if dialect == Dialect::Jsx => from = braces(text, from)?,
            _ => {
                let (own, value, end) = attribute(text, from, dialect)?;
                attributes.put_if_missing(&own, value);
                from = end;
            }
        }
    }
}

/// Name and value of the attribute at `from`, and its end.
fn attribute(text: &[u8], from: usize, dialect: Dialect) -> Option<(String, String, usize)> {
    let is_blank = |byte: u8| matches!(byte, b' ' | b'\t' | b'\n' | b'\r' | b'\x0c');
    let mut at = from + 1;
    while !is_blank(*text.get(at)?) && !matches!(text[at], b'/' | b'>' | b'=') {
        at += 1;
    }
    let name = String::from_utf8_lossy(&text[from..at]).to_ascii_lowercase();
    let mut after = at;
    while is_blank(*text.get(after)?) {
        after += 1;
    }
    if text[after] != b'=' {
        return Some((name, String::new(), at));
    }
    after += 1;
    while is_blank(*text.get(after)?) {
        after += 1;
    }
    let (value, end) = match text[after] {
        quote @ (b'"' | b'\'') => {
            let end = after + 1 + memchr(quote, &text[after + 1..])?;
            (entities::decoded(&text[after + 1..end]), end + 1)
        }
        b'{' if dialect == Dialect::Jsx => {
            let end = braces(text, after)?;
            let inner = literal(text, after + 1..end - 1).unwrap_or(after + 1..end - 1);
            let value = String::from_utf8_lossy(&text[inner]).into_owned();
            (value.replace("\\'", "'").replace("\\\"", "\"").replace("\\`", "`"), end)
        }
        b'>' => (String::new(), after),
        _ => {
            let mut end = after;
            while !is_blank(*text.get(end)?) && text[end] != b'>' {
                end += 1;
            }
            (entities::decoded(&text[after..end]), end)
        }
    };
    Some((name, value, end))
}

/// The content of a script or similar, from `from` to its end tag.
fn raw_text(text: &[u8], from: usize, name: &[u8]) -> Range<usize> {
    for at in memmem::find_iter(&text[from..], b"</") {
        let rest = &text[from + at + 2..];
        let is_name = rest.get(..name.len()).is_some_and(|own| own.eq_ignore_ascii_case(name));
        let ends = rest.get(name.len()).is_none_or(|byte| !byte.is_ascii_alphanumeric() && *byte != b'-');
        if is_name && ends {
            return from..from + at;
        }
    }
    from..text.len()
}

/// The end of the braces that begin at `at`.
fn braces(text: &[u8], at: usize) -> Option<usize> {
    let mut depth = 0_usize;
    let mut quote = None;
    let mut from = at;
    loop {
        let byte = *text.get(from)?;
        if quote.is_none() && text[from..].starts_with(b"/*") {
            from += 2 + memmem::find(&text[from + 2..], b"*/")? + 2;
            continue;
        }
        match (quote, byte) {
            (_, b'\\') => from += 1,
            (Some(own), byte) if own == byte => quote = None,
            (Some(_), _) => {}
            (None, b'"' | b'\'' | b'`') => quote = Some(byte),
            (None, b'{') => depth += 1,
            (None, b'}') => depth -= 1,
            (None, _) => {}
        }
        from += 1;
        if depth == 0 {
            return Some(from);
        }
    }
}

/// The value of `dangerouslySetInnerHTML`, if it is a string literal.
fn inner_html(text: &[u8], tag: &Tag, dialect: Dialect) -> Option<Range<usize>> {
    if dialect == Dialect::Html || tag.attributes.get("dangerouslysetinnerhtml").is_none() {
        return None;
    }
    let after = |at: usize, what: &[u8]| memmem::find(&text[at..tag.range.end], what).map(|found| at + found);
    let start = after(after(tag.range.start, b"dangerouslySetInnerHTML")?, b"{")?;
    let end = braces(text, start)?;
    let value = after(after(start, b"__html")?, b":")? + 1;
    literal(text, value..end.checked_sub(2).filter(|end| *end > value)?)
}

/// Decodes the contents of a string literal.
fn unquoted(html: &Mapped, inner: Range<usize>, into: &mut Mapped) {
    let text = html.text();
    let mut from = inner.start;
    while let Some(back) = memchr(b'\\', &text[from..inner.end]) {
        let back = from + back;
        into.keep_of(html, from..back);
        let after = (back + 2).min(inner.end);
        into.read_of(&text[back + 1..after], html, back..after);
        from = after;
    }
    into.keep_of(html, from..inner.end);
}

/// The range between the quotes of a string literal; `None` if it is something else.
fn literal(text: &[u8], range: Range<usize>) -> Option<Range<usize>> {
    let all = &text[range.clone()];
    let trimmed = all.trim_ascii();
    let start = range.start + all.len() - all.trim_ascii_start().len();
    match trimmed {
        [first @ (b'"' | b'\'' | b'`'), .., last] if first == last => {
            Some(start + 1..start + trimmed.len() - 1)
        }
        _ => None,
    }
}
