//! Converts a program to pieces: old text, new text, reason.
//!
//! In: the blocks of a program. Out: [`Piece`]s without gaps. White space within a block is kept; everything
//! between blocks is omitted, becomes a comment, or is a line end.

use super::Piece;
use super::blocks::{Blocks, NO_BLOCK};
use super::items::{Item, Kind, Word, is_blank, is_invisible, plain_signs, plain_word, slice, spell};
use super::programs::Stretch;
use super::reason::Reason;
use crate::control::codes;
use crate::order;
use crate::source::Span;

/// Maximum length of text after a block that becomes a comment, characters.
const LONGEST_REMARK: usize = 40;

/// Codes, besides the turning cycles, that may complete a G word with an unreadable second digit; `G0`
/// already means G00.
const CODES: [&str; 12] =
    ["G01", "G02", "G03", "G04", "G20", "G21", "G28", "G32", "G50", "G96", "G97", "G98"];

/// All codes that begin with the readable part, sorted by number. Hole cycles are excluded: ten codes with
/// the same beginning would be no useful choice.
fn longer_codes(read: &str) -> Vec<String> {
    let all = CODES.into_iter().map(str::to_owned).chain(codes::turning_cycles());
    let mut longer: Vec<String> =
        all.filter(|code| code.len() > read.len() && code.starts_with(read)).collect();
    order::by(&mut longer, Ord::cmp);
    longer
}

/// Converts a program to pieces.
pub(super) fn write(text: &str, items: &[Item], blocks: &Blocks, stretch: &Stretch) -> Vec<Piece> {
    let (Some(&first), Some(&last)) = (stretch.blocks.first(), stretch.blocks.last()) else {
        return Vec::new();
    };
    let (first, end) = (blocks.list[first as usize].first, blocks.list[last as usize].end);
    let mut writer = Writer { text, items, blocks, pieces: Vec::new(), at: items[first].span.start as usize };
    let mut before: Option<u32> = None;
    let mut gap = first;
    for (at, item) in items.iter().enumerate().take(end).skip(first) {
        let owner = blocks.owner[at];
        if owner == NO_BLOCK || item.kind == Kind::Foreign {
            continue;
        }
        match before {
            Some(block) if block == owner => writer.within(gap..at),
            Some(_) => writer.between(gap..at),
            None => {}
        }
        writer.keep(at);
        before = Some(owner);
        gap = at + 1;
    }
    writer.behind(end);
    writer.pieces
}

struct Writer<'a> {
    text: &'a str,
    items: &'a [Item],
    blocks: &'a Blocks,
    pieces: Vec<Piece>,
    /// First byte that is not yet in a piece.
    at: usize,
}

impl Writer<'_> {
    fn push(&mut self, end: usize, now: String, reason: Option<Reason>) {
        if end == self.at && now.is_empty() {
            return;
        }
        let span = Span::new(self.at, end);
        self.at = end;
        let was = slice(self.text, span);
        let thinned = was.chars().any(is_invisible) && !now.chars().any(is_invisible);
        let reason = reason.or(thinned.then_some(Reason::Invisible));
        // Unchanged text is merged into one piece.
        if reason.is_none()
            && let Some(last) = self.pieces.last_mut()
            && last.reason.is_none()
        {
            last.span.end = span.end;
            last.now.push_str(&now);
            return;
        }
        self.pieces.push(Piece { span, now, reason, choices: Vec::new() });
    }

    /// Adds an item, unchanged or with corrected spelling.
    fn keep(&mut self, at: usize) {
        let item = self.items[at];
        let was = slice(self.text, item.span);
        let end = item.span.end as usize;
        match item.kind {
            Kind::Word(word) => self.word(at, word),
            Kind::Comment => {
                let now = was.replace('（', "(").replace('）', ")");
                let reason = (now != was).then_some(Reason::FullWidth);
                self.push(end, now, reason);
            }
            Kind::Slash => {
                let (now, reason) = plain_signs(was);
                self.push(end, now, reason);
            }
            Kind::Semicolon if was != ";" => self.push(end, ";".into(), Some(Reason::FullWidth)),
            _ => self.push(end, was.to_string(), None),
        }
    }

    fn word(&mut self, at: usize, word: Word) {
        let item = self.items[at];
        let was = slice(self.text, item.span);
        let end = item.span.end as usize;
        let start = item.span.start as usize;
        if word.letter == b'O' && word.reason == Some(Reason::ZeroForO) {
            // `00006` is a misprint of O0006.
            return self.push(end, format!("O{}", &was[1..]), word.reason);
        }
        let now = match plain_word(self.text, start) {
            Some(_) => was.to_string(),
            None => spell(self.text, start).map_or_else(|| was.to_string(), |(_, _, now)| now),
        };
        if word.lost_sign {
            let number = now.trim_start_matches(|c: char| !c.is_ascii_digit() && c != '.');
            let letter = char::from(word.letter);
            let choices = vec![was.to_string(), format!("{letter}-{number}"), format!("{letter}{number}")];
            self.push(end, was.to_string(), Some(Reason::UnreadableSign));
            return self.ask(choices);
        }
        let next = self
            .items
            .get(at + 1)
            .filter(|next| next.kind == Kind::Foreign && next.span.start == item.span.end);
        if next.is_some() && word.letter == b'G' && self.blocks.owner[at + 1] == self.blocks.owner[at] {
            let choices: Vec<String> = [now.clone()].into_iter().chain(longer_codes(&now)).collect();
            let reason = if choices.len() > 1 { Some(Reason::UnreadableDigit) } else { word.reason };
            self.push(end, now, reason);
            return self.ask(choices);
        }
        let reason = if now == was { None } else { word.reason };
        self.push(end, now, reason);
    }

    fn ask(&mut self, choices: Vec<String>) {
        if let Some(last) = self.pieces.last_mut() {
            last.choices = choices;
        }
    }

    /// Adds the text between two words of a block.
    fn within(&mut self, range: std::ops::Range<usize>) {
        let (from, to) = (self.at, self.items[range.end].span.start as usize);
        if range.is_empty() {
            let was = &self.text[from..to];
            let now = if was.is_empty() {
                ""
            } else if was.chars().all(|c| c == ' ') {
                was
            } else {
                " "
            };
            return self.push(to, now.to_string(), None);
        }
        self.drop(range);
        self.push(to, " ".into(), None);
    }

    /// Adds the text between two blocks.
    fn between(&mut self, range: std::ops::Range<usize>) {
        let to = self.items[range.end].span.start as usize;
        let line_end = range.clone().find(|&at| self.items[at].kind == Kind::LineEnd);
        if range.is_empty() {
            return self.push(to, "\n".into(), Some(Reason::Split));
        }
        let mut range = range;
        if let Some(line_end) = line_end
            && self.remark(range.start..line_end)
        {
            range.start = line_end;
        }
        let blank = range.clone().all(|at| self.items[at].kind == Kind::LineEnd);
        if blank && line_end.is_some() {
            return self.push(to, "\n".into(), None);
        }
        self.drop(range);
        self.push(to, "\n".into(), None);
    }

    /// Converts short text after a block to a comment; returns false if this does not apply.
    fn remark(&mut self, range: std::ops::Range<usize>) -> bool {
        let items = &self.items[range.clone()];
        let (Some(first), Some(last)) = (items.first(), items.last()) else { return false };
        let readable = |item: &Item| {
            matches!(
                item.kind,
                Kind::Prose | Kind::Letter | Kind::Mark | Kind::Comma | Kind::Comment | Kind::Word(_)
            )
        };
        if !items.iter().all(readable) || !items.iter().any(|item| item.kind == Kind::Prose) {
            return false;
        }
        let span = first.span.to(last.span);
        let was = slice(self.text, span);
        let letters = was.chars().filter(|c| c.is_alphabetic()).count();
        if was.chars().count() > LONGEST_REMARK || letters < 2 || !self.is_alone(range.start) {
            return false;
        }
        let inner: String = was
            .chars()
            .filter(|c| !c.is_control())
            .map(|c| match c {
                '(' | '（' => '[',
                ')' | '）' => ']',
                c => c,
            })
            .collect();
        let inner = inner
            .trim_matches(|c: char| is_blank(c) || matches!(c, ';' | ',' | '，' | '。' | '/' | '-' | '—'));
        self.push(span.end as usize, format!(" ({inner})"), Some(Reason::Remark));
        true
    }

    /// Whether only list numbers precede the block on its line.
    fn is_alone(&self, behind: usize) -> bool {
        let owner = behind.checked_sub(1).map_or(NO_BLOCK, |at| self.blocks.owner[at]);
        owner != NO_BLOCK && self.blocks.list[owner as usize].gap.before == 0
    }

    /// Omits items; consecutive items with the same reason become one piece.
    fn drop(&mut self, range: std::ops::Range<usize>) {
        let mut at = range.start;
        while at < range.end {
            let mut end = at + 1;
            let reason = self.why(at);
            while end < range.end
                && reason.is_some()
                && self.why(end).is_none_or(|other| Some(other) == reason)
            {
                end += 1;
            }
            // Trailing line ends are part of the layout.
            while end > at + 1 && self.items[end - 1].kind == Kind::LineEnd {
                end -= 1;
            }
            let start = self.items[at].span.start as usize;
            self.push(start, String::new(), None);
            self.push(self.items[end - 1].span.end as usize, String::new(), reason);
            at = end;
        }
    }

    /// Adds the rest of the last line.
    fn behind(&mut self, end: usize) {
        let line_end = (end..self.items.len()).find(|&at| self.items[at].kind == Kind::LineEnd);
        let line_end = line_end.unwrap_or(self.items.len());
        let free = self.blocks.owner[end..line_end].iter().all(|&owner| owner == NO_BLOCK);
        if free && end < line_end {
            self.remark(end..line_end);
        }
        self.push(self.at, "\n".into(), None);
    }

    /// Why an item is omitted; `None` for line ends.
    fn why(&self, at: usize) -> Option<Reason> {
        Some(match self.items[at].kind {
            Kind::LineEnd => return None,
            Kind::Bullet => Reason::Bullet,
            Kind::LineNumber => Reason::LineNumber,
            Kind::Placeholder => Reason::Format,
            Kind::Noise | Kind::Comma | Kind::Mark | Kind::Foreign | Kind::Ellipsis => Reason::Noise,
            Kind::Word(_) if self.items.get(at + 1).is_some_and(|next| next.kind == Kind::Noise) => {
                Reason::Noise
            }
            Kind::Word(word) if word.letter == b'N' => Reason::LoneNumbers,
            Kind::Word(word) if word.letter == b'O' => Reason::RepeatedHead,
            _ => Reason::Prose,
        })
    }
}
