//! Programs in HTML, as a browser and the element find them: in `<gcode-playground>`, in marked `<pre>` and
//! `<script>`, and in scripts of the type `text/x-gcode`.
//!
//! In: a page, or a block of HTML in a page. Out: its examples. A tag is read as browsers read it; what is slotted is
//! no program. With JSX, attributes and text may also be `{…}`.

use std::ops::Range;

use memchr::{memchr, memmem};

use super::entities;
use super::mapped::Mapped;
use super::{Attributes, Example, Holder, dedented};

/// The tag of the element.
const ELEMENT: &[u8] = b"gcode-playground";
/// What marks a `pre` or a script as an element.
const MARK: &str = "data-gcode-playground";
/// What has no end tag.
const VOID: [&[u8]; 14] = [
    b"area", b"base", b"br", b"col", b"embed", b"hr", b"img", b"input", b"link", b"meta", b"param",
    b"source", b"track", b"wbr",
];
/// What is in these is no text of a page.
const NO_TEXT: [&[u8]; 2] = [b"template", b"noscript"];
/// What is in these is no markup.
const RAW: [&[u8]; 4] = [b"script", b"style", b"textarea", b"title"];

/// What else than HTML may stand there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dialect {
    /// Nothing.
    Html,
    /// `{…}`, and `<a/>` is closed.
    Jsx,
}

/// The examples of a text, in their order.
pub fn examples(html: &Mapped, dialect: Dialect) -> Vec<Example> {
    let mut scanner =
        Scanner { html, text: html.text(), dialect, found: Vec::new(), open: None, braces: true };
    scanner.all();
    scanner.found
}

/// A tag as it stands in the text.
struct Tag {
    /// In lower case.
    name: Vec<u8>,
    is_end: bool,
    /// Ends in `/>`.
    is_closed: bool,
    attributes: Attributes,
    range: Range<usize>,
}

impl Tag {
    fn has_type(&self, kind: &str) -> bool {
        self.attributes.get("type").is_some_and(|own| own.trim().eq_ignore_ascii_case(kind))
    }
}

/// An element whose end has not come.
struct Open {
    name: Vec<u8>,
    start: usize,
    attributes: Attributes,
    holder: Holder,
    own: Mapped,
    pre: Option<Mapped>,
    in_pre: bool,
    script: Option<Mapped>,
    /// What is slotted, or no text: its name, how many of this name are open, where it begins.
    aside: Option<(Vec<u8>, usize, usize)>,
    is_picture: bool,
    picture: Option<Mapped>,
    picture_is_quoted: bool,
}

impl Open {
    /// What text of now belongs to; nothing where it is for a slot.
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
    /// Whether a `{` may still have its `}`.
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

    /// Text up to the next markup; the answer is where that is.
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

    /// Text of the page.
    fn say(&mut self, range: Range<usize>) {
        if let Some(text) = self.open.as_mut().and_then(Open::text) {
            entities::read(self.html, range, text);
        }
    }

    /// `{…}`: text, where it is a text.
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

    /// A tag, a comment, or a `<` that is neither; the answer is where it ends.
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

    /// SVG has tags that close themselves.
    fn in_picture(&self) -> bool {
        self.dialect == Dialect::Jsx || self.open.as_ref().is_some_and(|open| open.is_picture)
    }

    fn start_tag(&mut self, tag: Tag, raw: Option<Range<usize>>) {
        // An element in an element: the first one was never closed.
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
            // No program.
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

    /// A tag outside of any element.
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

/// Where the tag of JSX ends that is at `at`, and whether nothing is in it; nothing where it never ends.
pub fn end_of_tag(text: &[u8], at: usize) -> Option<(usize, bool)> {
    tag(text, at, Dialect::Jsx).map(|tag| (tag.range.end, tag.is_closed))
}

/// The tag at `at`; nothing where it never ends.
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

/// Name and value of the attribute at `from`, and where it ends.
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

/// What a script and the like hold: from `from` to their end tag.
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

/// Where the braces end that begin at `at`.
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

/// What JSX puts into an element as HTML, if that is a text.
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

/// Reads what stands between the quotes of a text.
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

/// What stands between the quotes of a text; nothing where it is no text.
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
