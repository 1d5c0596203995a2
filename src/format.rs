//! Writes a program uniformly: blanks, case, and the leading zeros of G and M codes.
//!
//! In: a text. Out: the edits. Lines, comments, signs, decimal points and all other digits stay as they are:
//! `X50` and `X50.` differ a thousandfold on some controls. A block that is not well formed stays as it is, and
//! so does a gap with other characters than spaces and tabs. Must not know what a code does.

use crate::control::words::plain;
use crate::message::Edit;
use crate::order;
use crate::source::Span;
use crate::text::block::{Block, BlockKind, Value, Word};
use crate::text::highlight::sequence_span;
use crate::text::lexer::{Lexer, TokenKind};
use crate::text::parser::Parser;

/// The edits that format a text, sorted by position, not overlapping.
pub fn edits(text: &[u8]) -> Vec<Edit> {
    let mut edits: Vec<Edit> = Vec::new();
    rewrite(text, |span, new| match edits.last_mut().filter(|last| last.span.end == span.start) {
        Some(last) => {
            last.span.end = span.end;
            last.text.push_str(new);
        }
        None => edits.push(Edit { span, text: new.to_owned() }),
    });
    edits
}

/// The formatted text.
pub fn formatted(text: &[u8]) -> Vec<u8> {
    let (mut written, mut from) = (Vec::with_capacity(text.len() + text.len() / 8), 0);
    rewrite(text, |span, new| {
        written.extend_from_slice(&text[from..span.start as usize]);
        written.extend_from_slice(new.as_bytes());
        from = span.end as usize;
    });
    written.extend_from_slice(&text[from..]);
    written
}

/// Formats a text; passes each replaced span and its new text to `replace`, in text order.
fn rewrite(text: &[u8], replace: impl FnMut(Span, &str)) {
    let (mut parser, mut block) = (Parser::new(text), Block::default());
    let mut writer = Writer { text, replace };
    let mut elements = Vec::new();
    loop {
        let begins_line = parser.position().begins_line();
        if !parser.next_block(&mut block) {
            return;
        }
        elements.clear();
        if find_elements(text, &block, &mut elements).is_some() {
            writer.block(&block, &elements, begins_line);
        }
    }
}

/// A part of a block, with gaps before and after it.
#[derive(Clone, Copy)]
enum Element {
    /// A comment, a `%`: stays as it is.
    Kept(Span),
    /// A program or sequence number.
    Head(Span),
    /// The name after a program number: `O1234<NAME>`.
    Name(Span),
    Word(Word),
    Statement(Span),
}

impl Element {
    fn span(self) -> Span {
        match self {
            Self::Kept(span) | Self::Head(span) | Self::Name(span) | Self::Statement(span) => span,
            Self::Word(word) => word.span,
        }
    }
}

/// Finds the elements of a block, in text order; `None` if the block is not well formed.
fn find_elements(text: &[u8], block: &Block, found: &mut Vec<Element>) -> Option<()> {
    let is_comment = |span: &Span| span.of(text).first() == Some(&b'(');
    // `G00 X1 GOTO 5`: words before a macro statement.
    let is_mixed = block.kind == BlockKind::Macro && !block.words.is_empty();
    if !block.faults.is_empty() || block.is_unread || is_mixed || !block.comments.iter().all(is_comment) {
        return None;
    }
    found.extend(block.program.iter().map(|(_, span)| Element::Head(*span)));
    found.extend(block.second_name.iter().map(|(_, span)| Element::Name(*span)));
    if block.sequence.is_some() {
        found.push(Element::Head(sequence_span(text, block)?));
    }
    found.extend(block.words.iter().copied().map(Element::Word));
    let statement = Span { start: block.statement, end: block.statement_end };
    let is_inside = |comment: &Span| block.kind == BlockKind::Macro && statement.contains(*comment);
    match block.kind {
        BlockKind::Words => {}
        BlockKind::Macro if is_print(statement.of(text)) => found.push(Element::Kept(statement)),
        BlockKind::Macro => found.push(Element::Statement(statement)),
        BlockKind::Percent => {
            let sign =
                block.span.start as usize + block.span.of(text).iter().position(|byte| *byte == b'%')?;
            found.push(Element::Kept(Span::new(sign, sign + 1)));
        }
    }
    found.extend(block.comments.iter().filter(|comment| !is_inside(comment)).copied().map(Element::Kept));
    order::by_key(found, |element| element.span().start);
    Some(())
}

/// Whether a macro statement prints: its text and its blanks are part of the output.
fn is_print(statement: &[u8]) -> bool {
    let begins =
        |word: &[u8]| statement.get(..word.len()).is_some_and(|head| head.eq_ignore_ascii_case(word));
    [&b"POPEN"[..], b"PCLOS", b"BPRNT", b"DPRNT", b"SETVN"].into_iter().any(begins)
}

fn is_gap(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t')
}

struct Writer<'a, R> {
    text: &'a [u8],
    /// Takes each span and its new text.
    replace: R,
}

impl<R: FnMut(Span, &str)> Writer<'_, R> {
    fn block(&mut self, block: &Block, elements: &[Element], begins_line: bool) {
        let mut from = block.span.start;
        for (index, element) in elements.iter().enumerate() {
            let span = element.span();
            let gap = Span { start: from, end: span.start.max(from) };
            match element {
                _ if index == 0 && begins_line => self.indent(gap),
                Element::Name(_) => self.gap(gap, ""),
                _ => self.gap(gap, " "),
            }
            self.element(*element);
            from = span.end;
        }
        self.gap(Span { start: from, end: block.span.end }, "");
    }

    fn element(&mut self, element: Element) {
        match element {
            Element::Kept(_) | Element::Name(_) => {}
            Element::Head(span) => self.head(span),
            Element::Word(word) => self.word(&word),
            Element::Statement(span) => self.statement(span),
        }
    }

    /// Writes the gap at the head of a line: its indentation stays.
    fn indent(&mut self, gap: Span) {
        let blanks = gap.of(self.text).iter().take_while(|byte| is_gap(**byte)).count() as u32;
        let rest = Span { start: gap.start + blanks, end: gap.end };
        if let Some(slash) = slash(rest.of(self.text)) {
            self.replace(rest, &slash);
        }
    }

    /// Writes a gap as `blank`, with the slash in it.
    fn gap(&mut self, gap: Span, blank: &str) {
        let bytes = gap.of(self.text);
        // Without the blanks between them, CR and LF would be one line end.
        let is_between_line_ends = self.text[..gap.start as usize].ends_with(b"\r")
            && self.text[gap.end as usize..].starts_with(b"\n");
        if is_between_line_ends {
            return;
        }
        if bytes.iter().all(|byte| is_gap(*byte)) {
            self.replace(gap, blank);
        } else if let Some(slash) = slash(bytes).filter(|_| !blank.is_empty()) {
            self.replace(gap, &format!("{blank}{slash}"));
        }
    }

    /// Writes a program or sequence number.
    fn head(&mut self, span: Span) {
        let name = span.of(self.text).iter().position(|byte| *byte == b'<');
        self.address(Span { end: name.map_or(span.end, |at| span.start + at as u32), ..span });
    }

    fn word(&mut self, word: &Word) {
        let bytes = word.span.of(self.text);
        // G7 and G8 in this spelling show that a program is for LinuxCNC.
        let is_foreign = word.address == b'G' && matches!(plain(word), Some(7.0 | 8.0));
        if bytes.starts_with(b"<") || is_foreign {
            return;
        }
        let is_number = |byte: &u8| byte.is_ascii_digit() || matches!(byte, b'.' | b'#' | b'[');
        let head = bytes.iter().position(is_number).unwrap_or(bytes.len()) as u32;
        let (address, number) = (
            Span { end: word.span.start + head, ..word.span },
            Span { start: word.span.start + head, ..word.span },
        );
        match word.value {
            // The address may include the name of a function.
            Value::Expression => {
                self.address(address);
                self.upper(number);
            }
            Value::Number { .. } => {
                self.address(address);
                if matches!(word.address, b'G' | b'M') && !word.comma {
                    self.code(address, number);
                }
            }
        }
    }

    /// Writes the number of a G or M code with at least two digits.
    fn code(&mut self, address: Span, number: Span) {
        let has_sign = address.of(self.text).iter().any(|byte| matches!(byte, b'+' | b'-'));
        let digits = number.of(self.text);
        if digits.len() == 2 || has_sign || !digits.iter().all(u8::is_ascii_digit) {
            return;
        }
        let zeros = digits.iter().take_while(|digit| **digit == b'0').count();
        let short = match digits[zeros..] {
            [] => [b'0', b'0'],
            [digit] => [b'0', digit],
            _ => return self.replace(Span { end: number.start + zeros as u32, ..number }, ""),
        };
        self.replace(number, std::str::from_utf8(&short).unwrap_or_default());
    }

    /// Writes letters and signs in capitals and without blanks.
    fn address(&mut self, span: Span) {
        for at in span.start..span.end {
            let byte = Span { start: at, end: at + 1 };
            match self.text[at as usize] {
                blank if is_gap(blank) => self.replace(byte, ""),
                _ => self.upper(byte),
            }
        }
    }

    fn upper(&mut self, span: Span) {
        for at in span.start..span.end {
            let byte = self.text[at as usize];
            if byte.is_ascii_lowercase() {
                let upper = char::from(byte.to_ascii_uppercase());
                self.replace(Span { start: at, end: at + 1 }, upper.encode_utf8(&mut [0; 4]));
            }
        }
    }

    /// Writes a macro statement: in capitals, and each gap outside brackets as one blank.
    fn statement(&mut self, span: Span) {
        let mut depth = 0_usize;
        let lexer = Lexer::new(&self.text[..span.end as usize], span.start as usize);
        for token in lexer {
            match token.kind {
                TokenKind::Macro(b'[') => depth += 1,
                TokenKind::Macro(b']') => depth = depth.saturating_sub(1),
                TokenKind::Letter(_) => self.upper(token.span),
                TokenKind::Blank if depth == 0 => self.gap(token.span, " "),
                _ => {}
            }
        }
    }

    /// Replaces a span, unless it has this text.
    fn replace(&mut self, span: Span, text: &str) {
        if span.of(self.text) != text.as_bytes() {
            (self.replace)(span, text);
        }
    }
}

/// A gap with one slash, with its level and without other blanks: `/`, or `/2` and one blank.
fn slash(gap: &[u8]) -> Option<String> {
    let first = gap.iter().position(|byte| !is_gap(*byte))?;
    let last = gap.iter().rposition(|byte| !is_gap(*byte))?;
    match &gap[first..=last] {
        b"/" => Some("/".to_owned()),
        [b'/', level @ b'1'..=b'9'] => Some(format!("/{} ", char::from(*level))),
        _ => None,
    }
}
