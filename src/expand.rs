//! A program with every cycle, corner, compensation, subprogram and macro written out as plain G00, G01, G02, G03
//! and G32 blocks.
//!
//! In: a program, its motions and the blocks that were carried out. Out: a program that makes the same motions to
//! 0.001 mm under G40. It is written in the order of execution: a subprogram stands where it was called, a loop as
//! often as it ran. Blocks that are plain already stay as they were typed; what a cycle block commands besides (S,
//! T, M, other G codes) stays on a line of its own. What lies between G12.1 and G13.1 stays as it is. A contour that
//! was passed over is left out; a cycle that could not run stays as it is.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::ops::Range;

use crate::control::codes::{self, G, Switch};
use crate::control::dialect::CodeList;
use crate::control::interpreter::Executed;
use crate::control::setup::Setup;
use crate::control::words::plain;
use crate::diagnostics::Message;
use crate::motion::{Cycle, CycleStep, Feed, Motion, MotionKind, Motions, Step};
use crate::run::{Analysis, Run};
use crate::text::block::{Block, BlockKind, Value, Word};
use crate::text::parser::{Parser, Resume};

/// Writes out a program.
pub fn expand(text: &[u8], setup: &Setup) -> String {
    let mut run = Run::new(text.to_vec(), setup.clone()).traced();
    while !run.advance(usize::MAX) {}
    write_out(text, &run.into_analysis())
}

/// Writes out a program whose run kept its blocks.
pub fn write_out(text: &[u8], analysis: &Analysis) -> String {
    let trace = &analysis.trace;
    let mut writer = Writer {
        text,
        out: String::new(),
        motions: &analysis.motions,
        list: analysis.codes,
        code: None,
        feed: None,
        inch: false,
        incremental: false,
        in_plane: false,
        moved_start: false,
        any_failed: false,
    };
    let own = motions_of(trace, &analysis.motions);
    let jumps = trace.iter().any(|executed| executed.steers);
    // What lies between a block and the next one was passed over: a contour, unless the program jumps about.
    let gap = |index: usize, end: Resume| -> Range<usize> {
        let next = trace.get(index + 1).map_or(end.byte, |next| next.at.byte);
        if jumps { 0..0 } else { end.byte as usize..(next as usize).max(end.byte as usize) }
    };
    let mut block = Block::default();
    let read = |at: Resume, block: &mut Block| {
        let mut parser = Parser::resume(text, at);
        parser.next_block(block);
        parser.position()
    };
    for (index, executed) in trace.iter().enumerate() {
        let end = read(executed.at, &mut block);
        writer.any_failed |= !gap(index, end).is_empty() && own[index].is_empty();
    }
    let mut end = Resume::default();
    for (index, executed) in trace.iter().enumerate() {
        end = read(executed.at, &mut block);
        let range = own[index].clone();
        // What stands behind THEN is a block of its own; a macro statement with values writes to a table.
        let words = |values: &&String| block.kind == BlockKind::Words || !values.starts_with('#');
        if let Some(values) = executed.values.as_ref().filter(words) {
            with_values(&mut block, values);
        }
        let is_last = index + 1 == trace.len();
        // A block may end the text without a line end, and still be followed by others.
        if index > 0 && !writer.out.ends_with(['\n', ';', '\r']) {
            writer.out.push('\n');
        }
        // A program number within a program would end it: those of subprograms become remarks.
        let is_called = jumps && index > 0 && block.program.is_some();
        if is_called && range.is_empty() {
            writer.remark(&block);
            writer.comments(&block);
        } else if executed.steers && !(is_last && ends_main(&block)) {
            writer.steer(&block, executed.values.as_deref(), range.clone());
        } else if writer.must_write(&block, range.clone()) {
            writer.write(&block, range.clone());
        } else {
            if executed.values.as_ref().is_some_and(String::is_empty) {
                // None of its words has a value.
                writer.remark(&block);
                writer.comments(&block);
                continue;
            }
            let bytes = match &executed.values {
                Some(_) => None,
                None => Some(&text[executed.at.byte as usize..end.byte as usize]),
            };
            writer.copy(&block, bytes, executed.values.as_deref(), range.clone());
        }
        let passed = gap(index, end);
        if !range.is_empty() && !passed.is_empty() {
            writer.comments_between(passed);
        } else {
            writer.out.push_str(&String::from_utf8_lossy(&text[passed]));
        }
    }
    if !jumps {
        writer.out.push_str(&String::from_utf8_lossy(&text[end.byte as usize..]));
    }
    writer.out
}

/// The motions of each block that was carried out. Motions may wait for a later block, but keep their order; where a
/// block is carried out again, what came before belongs to the first time.
pub(crate) fn motions_of(trace: &[Executed], motions: &Motions) -> Vec<Range<usize>> {
    let mut again = BTreeMap::new();
    let mut limits = vec![motions.len(); trace.len()];
    for (index, executed) in trace.iter().enumerate().rev() {
        limits[index] = again.insert(executed.at.byte, executed.first).unwrap_or(motions.len());
    }
    let mut next = 0;
    let mut own = Vec::with_capacity(trace.len());
    for (executed, limit) in trace.iter().zip(limits) {
        let first = next;
        while next < limit && motions.span(next).start == executed.at.byte {
            next += 1;
        }
        own.push(first..next);
    }
    own
}

/// The block as it was carried out: its words with values in place of expressions.
fn with_values(block: &mut Block, values: &str) {
    let mut own = Block::default();
    Parser::new(values.as_bytes()).next_block(&mut own);
    // The words are looked at for their letters and values only; their places are those of the block.
    let span = block.words_span();
    block.kind = BlockKind::Words;
    block.words = own.words.iter().map(|word| Word { span, ..*word }).collect();
}

/// M99 alone, as a main program ends.
fn ends_main(block: &Block) -> bool {
    block.kind == BlockKind::Words
        && block.words.iter().any(|word| word.address == b'M' && plain(word) == Some(99.0))
        && !block.words.iter().any(|word| word.address == b'P')
}

struct Writer<'a> {
    text: &'a [u8],
    out: String,
    motions: &'a Motions,
    list: CodeList,
    /// The code of group 01 in force in the text written so far.
    code: Option<&'static str>,
    feed: Option<f64>,
    inch: bool,
    /// G91 of systems B and C.
    incremental: bool,
    /// Between G12.1 and G13.1, or on a cylinder: nothing is written out there.
    in_plane: bool,
    /// The block before was written out as moves of the path: the start of this one may have moved.
    moved_start: bool,
    /// A contour cycle could not run: first blocks are kept, for its sake.
    any_failed: bool,
}

impl Writer<'_> {
    /// The G codes of a block.
    fn codes<'b>(&self, block: &'b Block) -> impl Iterator<Item = G> + use<'b> {
        let list = self.list;
        block.words.iter().filter_map(move |word| code(word, list))
    }

    /// Whether a block is one of those between G12.1 and G13.1, or on a cylinder.
    fn is_in_plane(&self, own: &Range<usize>) -> bool {
        let moved = own.clone().next().map(|index| self.motions.get(index).rotary);
        moved.map_or(self.in_plane, |rotary| rotary.is_some_and(|rotary| rotary.virtual_move.is_some()))
    }

    /// Whether a block is more than plain moves.
    fn must_write(&self, block: &Block, own: Range<usize>) -> bool {
        if block.kind != BlockKind::Words || block.is_broken() || self.is_in_plane(&own) {
            return false;
        }
        let multiple = self.codes(block).find_map(|code| match code {
            G::Multiple(cycle) => Some(cycle),
            _ => None,
        });
        let compensates = self.codes(block).any(|code| {
            matches!(code, G::Compensation(codes::Compensation::Left | codes::Compensation::Right))
        });
        if own.is_empty() {
            // A first block of a cycle sets only what the cycle is written out with.
            let word = |address: u8| block.words.iter().any(|word| word.address == address);
            let first = multiple
                .is_some_and(|cycle| cycle == codes::Multiple::Threading || !(word(b'P') || word(b'Q')));
            let hole = self.codes(block).any(|code| matches!(code, G::Hole(_)));
            return (first && !self.any_failed) || compensates || hole;
        }
        let cornered = block.words.iter().any(|word| {
            word.comma
                || matches!(word.address, b'A' | b'L' | b'D')
                || (word.address == b'C' && !self.turns(&own))
        });
        let mut rounds = false;
        for index in own {
            let motion = self.motions.get(index);
            if motion.cycle.is_some() || motion.programmed.is_some() || self.moved_start {
                return true;
            }
            let word = |address: u8| block.words.iter().any(|word| word.address == address);
            rounds |= motion.kind == MotionKind::Feed && (word(b'R') || word(b'I') || word(b'K'));
        }
        cornered || rounds || compensates
    }

    /// Whether C is an axis in some motions.
    fn turns(&self, own: &Range<usize>) -> bool {
        own.clone().any(|index| self.motions.get(index).rotary.is_some())
    }

    /// Keeps in mind what a block that is copied switches.
    fn watch(&mut self, block: &Block) {
        for code in self.codes(block).collect::<Vec<_>>() {
            match code {
                G::Unit(unit) => self.inch = unit == crate::control::words::Unit::Inch,
                G::Distance { incremental } => self.incremental = incremental,
                G::Polar(switch) => self.in_plane = switch == Switch::On,
                G::Cylinder => {
                    let radius = block.words.iter().find(|word| word.address == b'C').and_then(plain);
                    self.in_plane = radius.is_some_and(|radius| radius != 0.0);
                }
                _ => {}
            }
        }
    }

    /// A plain block as it was typed, or with its values.
    fn copy(&mut self, block: &Block, bytes: Option<&[u8]>, values: Option<&str>, own: Range<usize>) {
        let spelled = self.codes(block).any(|code| matches!(code, G::Motion(_)));
        self.watch(block);
        if !own.is_empty() {
            self.moved_start = false;
            let last = self.motions.get(own.end - 1);
            let code = self.code_of(&last);
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
            self.comments(block);
            return;
        }
        match (bytes, values) {
            (Some(bytes), _) => self.out.push_str(&String::from_utf8_lossy(bytes)),
            (None, values) => {
                self.line(values.unwrap_or_default());
                self.comments(block);
            }
        }
    }

    /// A block that steers the program, as a remark; its own moves are written out.
    fn steer(&mut self, block: &Block, values: Option<&str>, own: Range<usize>) {
        if let Some(values) = values.filter(|_| block.kind == BlockKind::Macro && own.is_empty()) {
            // The tables of the control are written to as before.
            self.line(values);
        } else if block.kind == BlockKind::Macro && own.is_empty() {
            self.remark(block);
            self.comments(block);
        } else if !own.is_empty() && self.is_in_plane(&own) {
            // Its move, as it is, and its call as a remark.
            self.remark(block);
            self.comments(block);
            let is_call =
                |word: &&Word| codes::is_passage(word) || matches!(word.address, b'P' | b'L' | b'Q');
            let words: Vec<String> = match values {
                Some(values) => {
                    let mut own = Block::default();
                    Parser::new(values.as_bytes()).next_block(&mut own);
                    let kept = own.words.iter().filter(|word| !is_call(word));
                    kept.map(|word| word.span.quote(values.as_bytes())).collect()
                }
                None => {
                    let kept = block.words.iter().filter(|word| !is_call(word));
                    kept.map(|word| word.span.quote(self.text)).collect()
                }
            };
            self.line(&words.join(" "));
        } else {
            self.write(block, own);
        }
    }

    /// What a block says, as a remark.
    fn remark(&mut self, block: &Block) {
        let number = block.sequence.map_or_else(String::new, |_| sequence_as_written(self.text, block));
        let head = block.program.map(|(_, span)| span.to(block.words_span()));
        let span = match block.kind {
            BlockKind::Words if !block.words.is_empty() => head.unwrap_or_else(|| block.words_span()),
            BlockKind::Words => block.program.map_or(block.span, |(_, span)| span),
            _ => block.span,
        };
        let source: String =
            span.quote(self.text).chars().filter(|ch| !matches!(ch, '(' | ')' | '\n')).collect();
        let delete = block.delete.map_or_else(String::new, |level| format!("/{level} "));
        let source = source.trim().trim_start_matches(number.trim());
        let _ = writeln!(self.out, "{delete}{number}({})", source.trim());
    }

    /// A block as plain moves.
    fn write(&mut self, block: &Block, own: Range<usize>) {
        let mut before = String::new();
        let mut after = String::new();
        let called = block.words.iter().position(codes::calls_macro);
        for word in &block.words[..called.unwrap_or(block.words.len())] {
            let quoted: String =
                word.span.quote(self.text).chars().filter(|ch| !ch.is_whitespace()).collect();
            let target = match (word.address, plain(word)) {
                _ if codes::is_passage(word) => continue,
                (b'M', Some(0.0 | 1.0 | 2.0 | 5.0 | 9.0 | 30.0)) => &mut after,
                (b'M' | b'S' | b'T', _) => &mut before,
                (b'G', _) => match code(word, self.list) {
                    Some(
                        G::Motion(_)
                        | G::Multiple(_)
                        | G::Compensation(_)
                        | G::Hole(_)
                        | G::MacroCall(_)
                        | G::NoModalMacro,
                    ) => continue,
                    _ => &mut before,
                },
                _ => continue,
            };
            if !target.is_empty() {
                target.push(' ');
            }
            target.push_str(&quoted);
        }
        self.remark(block);
        self.comments(block);
        self.watch(block);
        let angle =
            block.words.iter().find(|word| word.address == b'Q').map(|word| word.span.quote(self.text));
        self.line(&before);
        let (inch, incremental) = (self.inch && !own.is_empty(), self.incremental && !own.is_empty());
        if inch {
            self.line(if self.list == CodeList::C { "G71" } else { "G21" });
        }
        if incremental {
            self.line("G90");
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
        if incremental {
            self.line("G91");
        }
        if inch {
            self.line(if self.list == CodeList::C { "G70" } else { "G20" });
            self.feed = None;
        }
        self.line(&after);
        let last_is_cycle = own.clone().last().is_some_and(|index| self.motions.get(index).cycle.is_some());
        if !own.is_empty() {
            self.moved_start = !last_is_cycle;
        }
    }

    fn line(&mut self, words: &str) {
        if !words.is_empty() {
            let _ = writeln!(self.out, "{words}");
        }
    }

    /// The comments of a block, each on a line of its own.
    fn comments(&mut self, block: &Block) {
        for comment in &block.comments {
            let quoted: String = comment
                .quote(self.text)
                .chars()
                .filter(|ch| !matches!(ch, '(' | ')' | '（' | '）'))
                .collect();
            let _ = writeln!(self.out, "({})", quoted.trim());
        }
    }

    /// The comments of a part of the text that was passed over.
    fn comments_between(&mut self, part: Range<usize>) {
        let mut parser = Parser::resume(&self.text[..part.end], Resume::inside(part.start as u32, 0));
        let mut block = Block::default();
        while parser.next_block(&mut block) {
            self.comments(&block);
        }
    }

    /// A motion as a block; `start_angle` is the Q of a thread.
    fn motion(&mut self, motion: &Motion, start_angle: Option<&str>) {
        if let Some(seconds) = motion.seconds {
            let _ = writeln!(self.out, "G04 X{}", decimal(seconds));
            return;
        }
        let code = self.code_of(motion).unwrap_or("G00");
        let (x, z) = (decimal(2.0 * motion.to.x), decimal(motion.to.z));
        let _ = write!(self.out, "{code} X{x} Z{z}");
        if let Some(rotary) = motion.rotary {
            let _ = write!(self.out, " C{}", decimal(rotary.to));
        }
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

    /// The code of group 01 that makes a motion.
    fn code_of(&self, motion: &Motion) -> Option<&'static str> {
        Some(match motion.kind {
            MotionKind::Rapid => "G00",
            MotionKind::Feed => "G01",
            MotionKind::ArcClockwise => "G02",
            MotionKind::ArcCounterclockwise => "G03",
            MotionKind::Thread if matches!(self.list, CodeList::B | CodeList::C) => "G33",
            MotionKind::Thread => "G32",
            MotionKind::Dwell => return None,
        })
    }
}

/// The G code of a word.
fn code(word: &Word, list: CodeList) -> Option<G> {
    let Value::Number { number, .. } = word.value else { return None };
    let tenths = number.tenths().filter(|_| word.address == b'G')?;
    codes::g_code(tenths, list).map(|found| found.code)
}

/// The sequence number of a block as it was typed, with a blank behind it.
fn sequence_as_written(text: &[u8], block: &Block) -> String {
    let quoted = block.span.quote(text);
    let from = quoted.find(['N', 'n']).unwrap_or(0);
    let digits: String = quoted[from + 1..].trim_start().chars().take_while(char::is_ascii_digit).collect();
    format!("N{digits} ")
}

/// The F that belongs to a motion: the lead of a thread.
fn feed_of(motion: &Motion) -> Option<f64> {
    match (motion.kind, motion.lead, motion.process.feed) {
        (MotionKind::Thread, Some(lead), _) => Some(lead),
        (_, _, Feed::PerMinute(feed) | Feed::PerTurn(feed)) => Some(feed),
        (_, _, Feed::Unset) => None,
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
