//! Comments that hide messages in their line: `(IGNORE RULE=UNKNOWN-M-CODE)`.
//!
//! In: a text, its messages. Out: the messages that remain, and those about the comments: words that cannot be
//! read, rules without a message in the line. Such a comment ends at the next bracket or at the end of its
//! line, so a change of the text affects the comments of its lines only. Messages are hidden after the run, so
//! the motions are the same.

use std::ops::Range;

use memchr::memchr;

use super::notes::{self, UnreadableWord, Word};
use crate::limits::WORDS_PER_BLOCK;
use crate::message::levels::{self, known};
use crate::message::{Diagnostic, Fix, Levels, RULES, Repair, Rule, Severity, said};
use crate::source::{Span, line_around, line_end};

/// The first word of such a comment.
const KEYWORD: &[u8] = b"IGNORE";

/// The key before a rule.
const KEY: &str = "RULE";

/// The comments of a text that hide messages.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct IgnoreComments {
    /// The words of all comments, in text order.
    entries: Vec<Entry>,
    /// Messages about comments that have hidden nothing yet.
    unused: Vec<Diagnostic>,
}

/// A word of such a comment.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Entry {
    /// The line of the comment.
    line: Span,
    /// The word.
    word: Span,
    /// What is deleted with the word: its comment, if there is no other word.
    removed: Span,
    /// What it names.
    named: Named,
}

/// What a word names.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Named {
    /// A rule, or a group of rules.
    Rule(&'static str),
    /// Nothing that is known.
    Unknown,
    /// One rule more than a line may name.
    TooMany,
}

/// What a run can say about the comments.
#[derive(Clone, Copy)]
pub struct Ran<'a> {
    /// The text of the run.
    pub text: &'a [u8],
    /// The severities of its setup.
    pub levels: &'a Levels,
    /// Maximum number of messages.
    pub most: usize,
    /// Whether all messages were reported, so that a missing one shows a comment without effect.
    pub is_complete: bool,
}

impl IgnoreComments {
    /// Reads all comments of a text.
    pub fn read(text: &[u8]) -> Self {
        Self { entries: entries(text, 0..text.len()), unused: Vec::new() }
    }

    /// Updates the comments after a change: `inserted` bytes have replaced the range `replaced`, and the text
    /// is now `text`.
    pub fn edit(&mut self, text: &[u8], replaced: &Range<usize>, inserted: usize) {
        let (first, last) =
            (line_around(text, replaced.start).start as usize, line_end(text, replaced.start + inserted));
        let moved = (inserted as u32).wrapping_sub(replaced.len() as u32);
        let last_before = (last as u32).wrapping_sub(moved);
        let from = self.entries.partition_point(|entry| (entry.word.start as usize) < first);
        let to = self.entries.partition_point(|entry| entry.word.start <= last_before);
        self.entries[to..].iter_mut().for_each(|entry| entry.shift(moved));
        self.entries.splice(from..to.max(from), entries(text, first..last));
    }

    /// Removes the hidden messages of a run, and adds those about words that cannot be read.
    pub fn hide_of_run(&mut self, messages: &mut Vec<Diagnostic>, ran: Ran<'_>) {
        let used = self.hide(messages);
        let room = ran.most.saturating_sub(messages.len());
        let told = self.entries.iter().filter_map(|entry| entry.unreadable(ran.text));
        let told = told.filter_map(|told| ran.levels.apply_to(told));
        messages.extend(told.take(room));
        let is_unused = |&(entry, used): &(&Entry, bool)| {
            ran.is_complete && !used && entry.rule().is_some_and(|rule| is_on(rule, ran.levels))
        };
        let unused = self.entries.iter().zip(used).filter(is_unused);
        let told = unused.filter_map(|(entry, _)| ran.levels.apply_to(entry.unused(ran.text)?));
        self.unused = told.take(ran.most.saturating_sub(messages.len())).collect();
    }

    /// Removes the hidden messages about the machining, and adds those about rules that have no message in
    /// their line.
    pub fn hide_at_machine(&self, messages: &mut Vec<Diagnostic>) {
        let used = self.hide(messages);
        messages.extend(self.unused.iter().filter(|told| !self.is_used(told, &used)).cloned());
    }

    /// Removes hidden messages after some of them have been moved to other lines.
    pub fn hide_moved(&self, messages: &mut Vec<Diagnostic>) {
        let used = self.hide(messages);
        messages.retain(|told| !told.message.is::<said::IgnoreUnused>() || !self.is_used(told, &used));
    }

    /// Removes hidden messages, and returns for each entry whether it hides any.
    fn hide(&self, messages: &mut Vec<Diagnostic>) -> Vec<bool> {
        let mut used = vec![false; self.entries.len()];
        if self.entries.is_empty() {
            return used;
        }
        messages.retain(|told| {
            let at = told.span.start;
            let first = self.entries.partition_point(|entry| entry.line.end < at);
            let in_line = self.entries[first..].iter().take_while(|entry| entry.line.start <= at);
            let mut is_hidden = false;
            for (entry, used) in in_line.zip(&mut used[first..]) {
                let hides = entry.rule().is_some_and(|rule| is_named(told.message.rule(), rule));
                *used |= hides;
                is_hidden |= hides;
            }
            !is_hidden
        });
        used
    }

    /// Whether the word that a message about a comment names is used.
    fn is_used(&self, told: &Diagnostic, used: &[bool]) -> bool {
        let entry = self.entries.binary_search_by_key(&told.span.start, |entry| entry.word.start);
        entry.is_ok_and(|entry| used[entry])
    }
}

impl Entry {
    fn shift(&mut self, by: u32) {
        for span in [&mut self.line, &mut self.word, &mut self.removed] {
            *span = Span { start: span.start.wrapping_add(by), end: span.end.wrapping_add(by) };
        }
    }

    /// The rule or the group that the word names.
    fn rule(&self) -> Option<&'static str> {
        match self.named {
            Named::Rule(rule) => Some(rule),
            Named::Unknown | Named::TooMany => None,
        }
    }

    /// The message that the word cannot be read, if so.
    fn unreadable(&self, text: &[u8]) -> Option<Diagnostic> {
        let told = |expected: String| {
            let word = UnreadableWord { span: self.word, expected: expected.into(), nearest: None };
            word.diagnostic(text)
        };
        match self.named {
            Named::Rule(_) => None,
            Named::TooMany => Some(told(format!("at most {WORDS_PER_BLOCK} rules in a line"))),
            Named::Unknown => {
                let word = self.word.quote(text);
                // `(IGNORE UNKNOWN-M-CODE)` lacks the key.
                let rule = word.split_once('=').map_or(&*word, |(_, rule)| rule);
                let rule = known(rule).or_else(|| levels::nearest(rule));
                let entry = |rule: &str| format!("{KEY}={}", rule.to_ascii_uppercase());
                let fix = rule.map(|rule| Fix::write(self.word, entry(rule)));
                let told = told(entry(rule.unwrap_or("no-program-end")));
                Some(Diagnostic { fixes: fix.into_iter().collect(), ..told })
            }
        }
    }

    /// The message that the word hides nothing.
    fn unused(&self, text: &[u8]) -> Option<Diagnostic> {
        let title = Repair::Delete { text: self.removed.quote(text).trim().to_owned() };
        let fix = Fix::replace(title, self.removed, "").needs_confirmation();
        Some(Diagnostic::new(said::IgnoreUnused { rule: self.rule()? }, self.word).with(fix))
    }
}

/// Whether the text of a comment hides messages.
pub fn is_ignore_comment(inside: &[u8]) -> bool {
    begins(inside) && std::str::from_utf8(inside).is_ok_and(|inside| is_meant(&notes::words(inside, 0)))
}

/// Whether a text begins with the keyword and a blank.
fn begins(inside: &[u8]) -> bool {
    let inside = inside.trim_ascii_start();
    let word = inside.get(..KEYWORD.len()).unwrap_or_default();
    word.eq_ignore_ascii_case(KEYWORD) && inside.get(KEYWORD.len()).is_some_and(u8::is_ascii_whitespace)
}

/// Whether words after the keyword name rules; otherwise the comment is prose.
fn is_meant(words: &[Word<'_>]) -> bool {
    let is_key = |word: &Word<'_>| word.value_of(KEY).is_some() || word.value_of("RULES").is_some();
    words.get(1).is_some_and(|word| is_key(word) || known(word.key()).is_some())
}

/// The words of the comments in some whole lines of a text.
fn entries(text: &[u8], lines: Range<usize>) -> Vec<Entry> {
    let mut found: Vec<Entry> = Vec::new();
    let (mut at, mut line) = (lines.start, Span::default());
    let text = &text[..lines.end];
    while let Some(open) = memchr(b'(', &text[at..]) {
        let start = at + open + 1;
        at = start;
        if !begins(&text[start..]) {
            continue;
        }
        let ends = |byte: &u8| matches!(byte, b'(' | b')' | b'\n' | b'\r');
        at = text[start..].iter().position(ends).map_or(text.len(), |length| start + length);
        if found.is_empty() || line.end < start as u32 {
            line = line_around(text, start);
        }
        let Ok(inside) = std::str::from_utf8(&text[start..at]) else { continue };
        let words = notes::words(inside, start);
        if is_meant(&words) {
            add(&mut found, text, line, &words[1..]);
        }
    }
    found
}

/// Adds the words of a comment. The first word of a line above the limit counts as one that cannot be read.
fn add(found: &mut Vec<Entry>, text: &[u8], line: Span, words: &[Word<'_>]) {
    let known_in_line = found.iter().rev().take_while(|entry| entry.line == line).count();
    let room = (WORDS_PER_BLOCK + 1).saturating_sub(known_in_line);
    for (index, word) in words.iter().enumerate().take(room) {
        let span = word.span();
        let named = match word.value_of(KEY).and_then(known) {
            _ if known_in_line + index >= WORDS_PER_BLOCK => Named::TooMany,
            Some(rule) => Named::Rule(rule),
            None => Named::Unknown,
        };
        let removed = if words.len() == 1 { comment_around(text, span) } else { span };
        found.push(Entry { line, word: span, removed: with_blanks_before(text, removed), named });
    }
}

/// The comment around its only entry, with the brackets.
fn comment_around(text: &[u8], word: Span) -> Span {
    let start = text[..word.start as usize].iter().rposition(|byte| *byte == b'(').unwrap_or_default();
    let end = word.end as usize;
    let blanks = text[end..].iter().take_while(|byte| matches!(byte, b' ' | b'\t')).count();
    let closed = text.get(end + blanks) == Some(&b')');
    Span::new(start, if closed { end + blanks + 1 } else { end })
}

/// A span with the blanks before it.
fn with_blanks_before(text: &[u8], span: Span) -> Span {
    let before = text[..span.start as usize].iter().rev();
    let blanks = before.take_while(|byte| matches!(byte, b' ' | b'\t')).count() as u32;
    Span { start: span.start - blanks, ..span }
}

/// Whether a rule has this name, or is in the group of this name.
fn is_named(rule: &Rule, name: &str) -> bool {
    rule.slug == name || rule.group.is_some_and(|group| group.name() == name)
}

/// Whether a rule, or a rule of a group, is reported.
fn is_on(name: &str, levels: &Levels) -> bool {
    let mut rules = RULES.iter().filter(|rule| is_named(rule, name));
    rules.any(|rule| levels.of(rule.slug).unwrap_or(rule.severity) > Severity::Off)
}

#[cfg(test)]
mod tests;
