//! Decodes character references in HTML: `&lt;` is `<`.
//!
//! In: text of a page. Out: the decoded text, mapped to its positions in the page.

use std::ops::Range;

use memchr::memchr;
use pulldown_cmark::{Event, Parser};

use super::mapped::Mapped;

/// Maximum length of a character name.
const LONGEST: usize = 34;

/// References that need no semicolon, as far as programs use them.
const LOOSE: [(&[u8], &[u8]); 4] = [(b"&amp", b"&"), (b"&lt", b"<"), (b"&gt", b">"), (b"&quot", b"\"")];

/// Where a reference without a semicolon is valid.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Loose {
    /// In text: before any character.
    Anywhere,
    /// In an attribute: not before a character that could continue the name, as in `?a=1&lt=2`.
    Alone,
}

/// Appends the decoded text of a part of `html`.
pub fn read(html: &Mapped, range: Range<usize>, into: &mut Mapped) {
    read_with(html, range, into, Loose::Anywhere);
}

fn read_with(html: &Mapped, range: Range<usize>, into: &mut Mapped, loose: Loose) {
    let text = html.text();
    let mut from = range.start;
    let mut look = from;
    while let Some(found) = memchr(b'&', &text[look..range.end]) {
        let at = look + found;
        look = at + 1;
        if let Some((character, length)) = reference(&text[at..range.end], loose) {
            into.keep_of(html, from..at);
            into.read_of(&character, html, at..at + length);
            (from, look) = (at + length, at + length);
        }
    }
    into.keep_of(html, from..range.end);
}

/// Decodes the value of an attribute.
pub fn decoded(text: &[u8]) -> String {
    let html = Mapped::of(text, 0..text.len());
    let mut into = Mapped::default();
    read_with(&html, 0..text.len(), &mut into, Loose::Alone);
    String::from_utf8_lossy(into.text()).into_owned()
}

/// The character of the reference at the start of a text, and the length of the reference.
fn reference(text: &[u8], loose: Loose) -> Option<(Vec<u8>, usize)> {
    let named = |byte: &u8| byte.is_ascii_alphanumeric() || *byte == b'#';
    let length = 1 + text[1..].iter().take(LONGEST).take_while(|byte| named(byte)).count();
    let own = LOOSE.iter().find(|(name, _)| text.starts_with(name));
    if text.get(length) == Some(&b';') {
        if let Some((name, character)) = own.filter(|(name, _)| name.len() == length) {
            return Some((character.to_vec(), name.len() + 1));
        }
        let whole = std::str::from_utf8(&text[..=length]).ok()?;
        if let Some(Event::Text(read)) = Parser::new(whole).nth(1)
            && *read != *whole
        {
            return Some((read.as_bytes().to_vec(), length + 1));
        }
    }
    let (name, character) = own?;
    let goes_on = name.len() < length || text.get(length) == Some(&b'=');
    (loose == Loose::Anywhere || !goes_on).then(|| (character.to_vec(), name.len()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn references_are_read_as_browsers_do() {
        let in_text = |text: &str| {
            let mut into = Mapped::default();
            read(&Mapped::of(text.as_bytes(), 0..text.len()), 0..text.len(), &mut into);
            String::from_utf8_lossy(into.text()).into_owned()
        };
        for (text, read) in [
            ("A&lt;B &amp;&gt; &quot;&#39;&#x3c;", "A<B &> \"'<"),
            ("&amp;lt;", "&lt;"),
            ("&minus;5 &times;", "\u{2212}5 \u{d7}"),
            ("& && &; &lt; &nosuch; &#;", "& && &; < &nosuch; &#;"),
            ("&#10;", "\n"),
            ("", ""),
        ] {
            assert_eq!(decoded(text.as_bytes()), read, "{text}");
            assert_eq!(in_text(text), read, "{text}");
        }
        assert_eq!([in_text("&ltA"), decoded(b"&ltA"), decoded(b"?a&lt=2")], ["<A", "&ltA", "?a&lt=2"]);
    }
}
