//! A program with every cycle, corner and compensation written out as plain G00, G01, G02, G03 and G32 blocks.
//!
//! In: a program and its setup. Out: a program that makes the same motions to 0.001 mm under G40. Blocks that are
//! plain already stay as they were typed; what a cycle block commands besides (S, T, M, other G codes) stays on a
//! line of its own. A contour that was passed over is left out; a cycle that could not run stays as it is.

use std::fmt::Write;
use std::ops::Range;

use crate::control::setup::Setup;
use crate::diagnostics::Message;
use crate::motion::{Cycle, CycleStep, Feed, Motion, MotionKind, Motions, Step};
use crate::run::Analysis;
use crate::text::block::{Block, BlockKind, Value, Word};
use crate::text::parser::Parser;
use crate::text::source::Span;

/// Writes out a program.
pub fn expand(text: &[u8], setup: &Setup) -> String {
    write_out(text, &crate::analyze(text, setup))
}

/// Writes out a program that was run already.
pub fn write_out(text: &[u8], analysis: &Analysis) -> String {
    let mut writer = Writer {
        out: String::new(),
        motions: &analysis.motions,
        code: None,
        feed: None,
        inch: false,
        moved_start: false,
        any_failed: false,
    };
    let blocks = motions_by_block(analysis);
    let own_of =
        |start: u32| blocks.binary_search_by_key(&start, |entry| entry.0).ok().map(|at| blocks[at].1.clone());
    // A contour is left out where its cycle was written out; a cycle that could not run keeps it.
    let left_out: Vec<Span> = analysis
        .skipped
        .iter()
        .filter(|skipped| own_of(skipped.cycle).is_some())
        .map(|skipped| skipped.span)
        .collect();
    writer.any_failed = left_out.len() < analysis.skipped.len();
    let mut parser = Parser::new(text);
    let mut block = Block::default();
    let mut copied = 0;
    while parser.next_block(&mut block) {
        let end = parser.position().byte as usize;
        if left_out.iter().any(|span| span.start <= block.span.start && block.span.start < span.end) {
            copied = end;
            writer.comments(text, &block);
            continue;
        }
        let own = own_of(block.span.start);
        if writer.must_write(&block, own.clone()) {
            writer.write(text, &block, own.unwrap_or(0..0));
        } else {
            writer.copy(text, &block, &text[copied.max(block.span.start as usize)..end], own);
        }
        copied = end;
    }
    writer.out
}

/// The motions of each block, in order of the text.
fn motions_by_block(analysis: &Analysis) -> Vec<(u32, Range<usize>)> {
    let mut blocks: Vec<(u32, Range<usize>)> = Vec::new();
    for index in 0..analysis.motions.len() {
        let start = analysis.motions.span(index).start;
        match blocks.last_mut() {
            Some((last, range)) if *last == start => range.end = index + 1,
            _ => blocks.push((start, index..index + 1)),
        }
    }
    blocks.sort_by_key(|entry| entry.0);
    blocks
}

struct Writer<'a> {
    out: String,
    motions: &'a Motions,
    /// The code of group 01 in force in the text written so far.
    code: Option<&'static str>,
    feed: Option<f64>,
    inch: bool,
    /// The block before was written out as moves of the path: the start of this one may have moved.
    moved_start: bool,
    /// A contour cycle could not run: first blocks are kept, for its sake.
    any_failed: bool,
}

impl Writer<'_> {
    /// Whether a block is more than plain moves.
    fn must_write(&self, block: &Block, own: Option<Range<usize>>) -> bool {
        if block.kind != BlockKind::Words || block.is_broken() {
            return false;
        }
        let code = |key: f64| block.words.iter().any(|word| word.address == b'G' && value(word) == Some(key));
        let multiple = [70.0, 71.0, 72.0, 73.0, 74.0, 75.0, 76.0].into_iter().any(code);
        let Some(own) = own else {
            // A first block of a cycle sets only what the cycle is written out with.
            let first = multiple
                && !block.words.iter().any(|word| matches!(word.address, b'P' | b'Q' if !code(76.0)));
            return (first && !self.any_failed) || code(41.0) || code(42.0);
        };
        let cornered =
            block.words.iter().any(|word| word.comma || matches!(word.address, b'A' | b'C' | b'L' | b'D'));
        let mut rounds = false;
        for index in own {
            let motion = self.motions.get(index);
            if motion.cycle.is_some() || motion.programmed.is_some() || self.moved_start {
                return true;
            }
            let word = |address: u8| block.words.iter().any(|word| word.address == address);
            rounds |= motion.kind == MotionKind::Feed && (word(b'R') || word(b'I') || word(b'K'));
        }
        cornered || rounds || code(41.0) || code(42.0)
    }

    /// A plain block as it was typed.
    fn copy(&mut self, text: &[u8], block: &Block, bytes: &[u8], own: Option<Range<usize>>) {
        let codes = |word: &&Word| {
            word.address == b'G' && matches!(value(word), Some(0.0 | 1.0 | 2.0 | 3.0 | 32.0 | 34.0))
        };
        let spelled = block.words.iter().any(|word| codes(&word));
        for word in &block.words {
            match (word.address, value(word)) {
                (b'G', Some(20.0)) => self.inch = true,
                (b'G', Some(21.0)) => self.inch = false,
                _ => {}
            }
        }
        if let Some(own) = own {
            self.moved_start = false;
            let last = self.motions.get(own.end - 1);
            let code = code_of(&last);
            let moves = block
                .words
                .iter()
                .any(|word| matches!(word.address, b'X' | b'Z' | b'U' | b'W' | b'I' | b'K'));
            if !spelled && moves && code.is_some() && self.code != code {
                let _ = write!(self.out, "{} ", code.unwrap_or_default());
            }
            self.code = if moves { code.or(self.code) } else { self.code };
            let feed = feed_of(&last);
            let cuts = matches!(
                last.kind,
                MotionKind::Feed | MotionKind::ArcClockwise | MotionKind::ArcCounterclockwise
            );
            let has_feed = block.words.iter().any(|word| word.address == b'F');
            if cuts && !has_feed && self.feed.is_some() && feed.is_some() && feed != self.feed {
                // A thread written out before left its lead as F.
                let unit = if self.inch { 25.4 } else { 1.0 };
                let _ =
                    write!(self.out, "F{} ", feed.map_or_else(String::new, |feed| fine_decimal(feed / unit)));
            }
            self.feed = feed.or(self.feed);
        }
        let remark =
            block.faults.iter().any(|fault| matches!(fault.message, Message::TextAfterSemicolon { .. }));
        if remark && self.out.ends_with('\n') {
            // Prose behind a `;` is a remark only on the line of its block, which was written out.
            self.comments(text, block);
            return;
        }
        self.out.push_str(&String::from_utf8_lossy(bytes));
    }

    /// A block as plain moves.
    fn write(&mut self, text: &[u8], block: &Block, own: Range<usize>) {
        let mut before = String::new();
        let mut after = String::new();
        for word in &block.words {
            let quoted: String = word.span.quote(text).chars().filter(|ch| !ch.is_whitespace()).collect();
            let target = match (word.address, value(word)) {
                (b'M', Some(0.0 | 1.0 | 2.0 | 5.0 | 9.0 | 30.0)) => &mut after,
                (b'M' | b'S' | b'T', _) => &mut before,
                (
                    b'G',
                    Some(
                        0.0 | 1.0 | 2.0 | 3.0 | 32.0 | 33.0 | 34.0 | 40.0 | 41.0 | 42.0 | 90.0 | 92.0 | 94.0,
                    ),
                ) => continue,
                (b'G', Some(70.0..=76.0)) => continue,
                (b'G', _) => &mut before,
                _ => continue,
            };
            if !target.is_empty() {
                target.push(' ');
            }
            target.push_str(&quoted);
        }
        let number = block.sequence.map_or_else(String::new, |_| sequence_as_written(text, block));
        let source: String =
            block.words_span().quote(text).chars().filter(|ch| !matches!(ch, '(' | ')')).collect();
        let delete = block.delete.map_or_else(String::new, |level| format!("/{level} "));
        let _ = writeln!(self.out, "{delete}{number}({})", source.trim());
        self.comments(text, block);
        let angle = block.words.iter().find(|word| word.address == b'Q').map(|word| word.span.quote(text));
        self.line(&before);
        let inch = self.inch && !own.is_empty();
        if inch {
            self.line("G21");
        }
        let mut pass = None;
        for index in own.clone() {
            let motion = self.motions.get(index);
            if let Some(step) =
                motion.cycle.filter(|step| step.pass > 0 && pass != Some((step.cycle, step.pass)))
            {
                pass = Some((step.cycle, step.pass));
                let _ = writeln!(self.out, "({} PASS {})", step.cycle.code(), step.pass);
            }
            let first_cut = |step: CycleStep| step.cycle == Cycle::Threading && step.step == Step::Cut;
            let is_thread = motion.cycle.is_some_and(first_cut);
            self.motion(&motion, angle.as_deref().filter(|_| is_thread));
        }
        if inch {
            self.line("G20");
            self.feed = None;
        }
        self.line(&after);
        let last_is_cycle = own.clone().last().is_some_and(|index| self.motions.get(index).cycle.is_some());
        self.moved_start = !own.is_empty() && !last_is_cycle;
    }

    fn line(&mut self, words: &str) {
        if !words.is_empty() {
            let _ = writeln!(self.out, "{words}");
        }
    }

    /// The comments of a block, each on a line of its own.
    fn comments(&mut self, text: &[u8], block: &Block) {
        for comment in &block.comments {
            let quoted: String =
                comment.quote(text).chars().filter(|ch| !matches!(ch, '(' | ')' | '（' | '）')).collect();
            let _ = writeln!(self.out, "({})", quoted.trim());
        }
    }

    /// A motion as a block; `start_angle` is the Q of a thread.
    fn motion(&mut self, motion: &Motion, start_angle: Option<&str>) {
        if let Some(seconds) = motion.seconds {
            let _ = writeln!(self.out, "G04 X{}", decimal(seconds));
            return;
        }
        let code = code_of(motion).unwrap_or("G00");
        let (x, z) = (decimal(2.0 * motion.to.x), decimal(motion.to.z));
        let _ = write!(self.out, "{code} X{x} Z{z}");
        if let Some(center) = motion.center {
            let (i, k) = (decimal(center.x - motion.from.x), decimal(center.z - motion.from.z));
            let _ = write!(self.out, " I{i} K{k}");
        }
        let feed = feed_of(motion);
        if motion.kind != MotionKind::Rapid
            && feed.is_some()
            && (feed != self.feed || motion.kind == MotionKind::Thread)
        {
            let _ = write!(self.out, " F{}", feed.map_or_else(String::new, fine_decimal));
            self.feed = feed;
        }
        if let Some(start_angle) = start_angle {
            let _ = write!(self.out, " {start_angle}");
        }
        self.out.push('\n');
        self.code = Some(code);
    }
}

/// The sequence number of a block as it was typed, with a blank behind it.
fn sequence_as_written(text: &[u8], block: &Block) -> String {
    let quoted = block.span.quote(text);
    let from = quoted.find(['N', 'n']).unwrap_or(0);
    let digits: String = quoted[from + 1..].trim_start().chars().take_while(char::is_ascii_digit).collect();
    format!("N{digits} ")
}

/// The code of group 01 that makes a motion.
fn code_of(motion: &Motion) -> Option<&'static str> {
    Some(match motion.kind {
        MotionKind::Rapid => "G00",
        MotionKind::Feed => "G01",
        MotionKind::ArcClockwise => "G02",
        MotionKind::ArcCounterclockwise => "G03",
        MotionKind::Thread => "G32",
        MotionKind::Dwell => return None,
    })
}

/// The F that belongs to a motion: the lead of a thread.
fn feed_of(motion: &Motion) -> Option<f64> {
    match (motion.kind, motion.lead, motion.process.feed) {
        (MotionKind::Thread, Some(lead), _) => Some(lead),
        (_, _, Feed::PerMinute(feed) | Feed::PerTurn(feed)) => Some(feed),
        (_, _, Feed::Unset) => None,
    }
}

fn value(word: &Word) -> Option<f64> {
    match word.value {
        Value::Number { number, negative: false } => Some(number.value()),
        Value::Number { number, negative: true } => Some(-number.value()),
        Value::Expression => None,
    }
}

/// A length with a point, to a thousandth: `20.`, `-0.5`.
fn decimal(value: f64) -> String {
    trimmed(format!("{value:.3}"))
}

/// The same to a hundred-thousandth, for feeds and leads.
fn fine_decimal(value: f64) -> String {
    trimmed(format!("{value:.5}"))
}

fn trimmed(text: String) -> String {
    let text = text.trim_end_matches('0').to_owned();
    if text == "-0." { "0.".into() } else { text }
}
