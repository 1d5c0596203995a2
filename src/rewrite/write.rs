//! Makes the edits that write moves as a cycle.
//!
//! In: moves and their passes. Out: an [`Offer`], not tried yet. Words are kept as typed if they have the
//! same meaning; comments are kept; the next block gets a G00 if it relied on one that is removed.

use super::Offer;
use super::places::{Move, Places, ends_program, g, is_plain};
use super::shape::{Pass, level};
use crate::control::codes::{self, G, MotionMode};
use crate::control::words::{Reading, plain, quote};
use crate::cycles::single::{Single, Work};
use crate::message::Edit;
use crate::run::Analysis;
use crate::setup::dialect::DecimalRule;
use crate::source::Span;
use crate::text::block::{Block, Word};
use crate::text::parser::{Parser, Resume};
use crate::units::Unit;

/// Addresses that a block without a code of group 01 may contain, and that have no meaning without such a
/// code.
const MODAL: &[u8] = b"XZUWYVCHIJKRAE";

/// Writes the cycles of one program.
pub struct Writer<'a> {
    /// The program.
    pub text: &'a [u8],
    /// Its traced run.
    pub analysis: &'a Analysis,
    /// Properties of its blocks.
    pub places: &'a Places,
    /// Meaning of numbers without a decimal point.
    pub decimal: DecimalRule,
}

/// The formatting of the program around the change.
struct Style {
    /// Space between two words.
    gap: &'static str,
    lower_case: bool,
    /// Decimal point after integers, if used.
    point: &'static str,
    /// G00 as written in this program.
    rapid: String,
}

/// A block and its end.
struct Placed {
    block: Block,
    /// One past its last byte, including its end of block.
    next: u32,
}

impl Writer<'_> {
    /// The offer for moves that form these passes; `None` if something would be lost.
    pub fn offer(&self, moves: &[Move], passes: &[Pass]) -> Option<Offer> {
        let single = passes.first()?.single;
        let code = self.code(single)?;
        let blocks: Vec<Placed> = moves.iter().map(|own| self.read(own.at)).collect();
        let style = self.style(&blocks);
        let mut edits = Vec::new();
        let mut feed = None;
        for (number, pass) in passes.iter().enumerate() {
            let own = 4 * number..4 * number + 4;
            let before = number.checked_sub(1).map(|before| &passes[before]);
            let (moves, blocks) = (&moves[own.clone()], &blocks[own]);
            // A jump may only lead to the first block.
            if blocks[1..].iter().any(|placed| self.places.is_target(&placed.block)) {
                return None;
            }
            let mut words = Vec::new();
            words.extend(before.is_none().then(|| code.clone()));
            words.extend(self.cycle_words(moves, blocks, pass, before, &style));
            words.extend(self.feed_word(blocks, &mut feed)?);
            let mut line = words.join(style.gap);
            if style.lower_case {
                line.make_ascii_lowercase();
            }
            edits.push(self.replaced(&blocks[0].block, line));
            edits.extend(blocks[1..].iter().map(|placed| self.removed(placed)));
        }
        let (last, move_) = (blocks.last()?, moves.last()?);
        self.restore_rapid(move_.index, last, &style.rapid, &mut edits);
        let span = Span { start: blocks[0].block.words_span().start, end: last.block.words_span().end };
        Some(Offer { span, single, code, passes: passes.len(), edits })
    }

    /// X, Z and R, as far as they differ from the previous pass.
    fn cycle_words(
        &self,
        moves: &[Move],
        blocks: &[Placed],
        pass: &Pass,
        before: Option<&Pass>,
        style: &Style,
    ) -> Vec<String> {
        let mut words = Vec::new();
        let differs =
            |value: fn(&Pass) -> f64| before.is_none_or(|before| !level(value(before), value(pass)));
        let (x, z) = (differs(|pass| pass.end.x), differs(|pass| pass.end.z));
        // A repeated pass at the same depth still needs a word.
        let again = before.is_some() && !x && !z;
        if x || (again && pass.single.work() != Work::Facing) {
            words.push(self.axis_word(moves, blocks, b"XU", (pass.start.x, pass.end.x), style));
        }
        if z || (again && pass.single.work() == Work::Facing) {
            words.push(self.axis_word(moves, blocks, b"ZW", (pass.start.z, pass.end.z), style));
        }
        if before.map_or(pass.taper != 0.0, |before| !level(before.taper, pass.taper)) {
            words.push(format!("R{}", number(pass.taper, moves[0].unit, style.point)));
        }
        words
    }

    /// The word for the end of the cut along an axis; rewritten only if the typed word would mean another
    /// position.
    fn axis_word(
        &self,
        moves: &[Move],
        blocks: &[Placed],
        letters: &[u8; 2],
        (start, end): (f64, f64),
        style: &Style,
    ) -> String {
        let unit = moves[0].unit;
        let scale = if letters[0] == b'X' { 2.0 } else { 1.0 };
        let find =
            |placed: &Placed| placed.block.words.iter().find(|word| letters.contains(&word.address)).copied();
        let typed = find(&blocks[1]).or_else(|| find(&blocks[0]));
        let letter = typed.map_or(letters[0], |word: Word| word.address);
        let way = letter == letters[1] || moves[0].incremental;
        let target = scale * if way { end - start } else { end };
        let reading = Reading { unit, decimal: self.decimal };
        let means_it = |word: &Word| reading.length(word).is_some_and(|value| level(value, target));
        match typed.filter(means_it) {
            Some(word) => quote(self.text, word.span),
            None => format!("{}{}", char::from(letter), number(target, unit, style.point)),
        }
    }

    /// F, if it differs from the previous one; `None` if one of the blocks sets an F that the cycle cannot
    /// contain.
    fn feed_word(&self, blocks: &[Placed], feed: &mut Option<f64>) -> Option<Option<String>> {
        let find = |placed: &Placed| placed.block.words.iter().find(|word| word.address == b'F').copied();
        let own = find(&blocks[1]).or_else(|| find(&blocks[0]));
        let value = own.as_ref().and_then(plain);
        let new = own.filter(|_| *feed != value).map(|word| quote(self.text, word.span));
        *feed = value.or(*feed);
        let late = blocks[2..].iter().filter_map(find).all(|word| plain(&word) == *feed);
        late.then_some(new)
    }

    /// Replaces the words of a block; comments between them are moved behind.
    fn replaced(&self, block: &Block, mut line: String) -> Edit {
        let span = block.words_span();
        for comment in block.comments.iter().filter(|own| span.start < own.start && own.end < span.end) {
            line = format!("{line} {}", comment.quote(self.text));
        }
        Edit { span, text: line }
    }

    /// Removes a block, but keeps its comments.
    fn removed(&self, placed: &Placed) -> Edit {
        let block = &placed.block;
        let comments: Vec<String> = block.comments.iter().map(|own| own.quote(self.text)).collect();
        if comments.is_empty() {
            return Edit {
                span: Span { start: block.span.start, end: self.cut_end(placed) },
                text: String::new(),
            };
        }
        Edit { span: self.content(block), text: comments.join(" ") }
    }

    /// The span of a block without surrounding spaces.
    fn content(&self, block: &Block) -> Span {
        let bytes = block.span.of(self.text);
        let start = block.span.start as usize + bytes.len() - bytes.trim_ascii_start().len();
        Span::new(start, start + bytes.trim_ascii().len())
    }

    /// End of the text to remove with a block: includes its end of block, and the line end if the block is
    /// alone on its line.
    fn cut_end(&self, placed: &Placed) -> u32 {
        let (span, next) = (placed.block.span, placed.next as usize);
        let is_line_end = |byte: &u8| matches!(byte, b'\n' | b'\r');
        let begins_line = span.start == 0 || is_line_end(&self.text[span.start as usize - 1]);
        let semicolon = self.text[span.end as usize..next].contains(&b';');
        match (begins_line, semicolon) {
            (true, true) => {
                let blank = self.text[next..].iter().take_while(|byte| matches!(byte, b' ' | b'\t')).count();
                let rest = &self.text[next + blank..];
                let end = if rest.starts_with(b"\r\n") {
                    2
                } else {
                    rest.iter().take(1).filter(|byte| is_line_end(byte)).count()
                };
                if end > 0 || rest.is_empty() { (next + blank + end) as u32 } else { placed.next }
            }
            (true, false) => placed.next,
            // After other blocks on its line, the line end is kept.
            (false, true) => placed.next,
            (false, false) => span.end,
        }
    }

    /// Adds G00 to the block after the cycle if it relies on that of the last block, which is at `index`.
    fn restore_rapid(&self, index: usize, last: &Placed, rapid: &str, edits: &mut Vec<Edit>) {
        let mut at = last.block.span.start;
        for executed in &self.analysis.trace[index + 1..] {
            let Placed { block, .. } = self.read(executed.at);
            let has = |letters: &[u8]| block.words.iter().any(|word| letters.contains(&word.address));
            let found = || block.words.iter().filter_map(|word| g(word, self.analysis.codes));
            if is_plain(&block)
                && block.words.iter().any(|word| ends_program(word) && !codes::is_call_or_return(word))
            {
                return;
            }
            let straight = executed.at.byte > at && !executed.is_flow_control && executed.values.is_none();
            at = executed.at.byte;
            // The program may reach a block from elsewhere, or not at all.
            if !straight || !is_plain(&block) || self.places.is_target(&block) {
                break;
            }
            if found().any(|code| matches!(code, G::Motion(_))) {
                return;
            }
            if found().any(|code| matches!(code, G::Multiple(_) | G::Hole(_) | G::Polar(_) | G::Cylinder)) {
                break;
            }
            let alone = found().any(|code| {
                matches!(code, G::Dwell | G::Home | G::OtherHome | G::Setting | G::LocalFrame | G::Data)
            });
            if alone || !has(MODAL) {
                continue;
            }
            let start = block.words_span().start;
            edits.push(Edit { span: Span { start, end: start }, text: format!("{rapid} ") });
            return;
        }
        if self.analysis.trace.len() == index + 1 {
            return;
        }
        // As a separate block, in place of the last one.
        let mut line = rapid.to_owned();
        for comment in &last.block.comments {
            line = format!("{line} {}", comment.quote(self.text));
        }
        edits.pop();
        edits.push(Edit { span: self.content(&last.block), text: line });
    }

    /// The code of a cycle in the code list in use.
    fn code(&self, single: Single) -> Option<String> {
        let is_it = |number: &u64| {
            codes::g_code(10 * number, self.analysis.codes)
                .is_some_and(|found| found.code == G::Motion(MotionMode::Cycle(single)))
        };
        (0..100).find(is_it).map(|number| format!("G{number:02}"))
    }

    fn style(&self, blocks: &[Placed]) -> Style {
        let words = || blocks[..2].iter().flat_map(|placed| &placed.block.words);
        let has_gap =
            |placed: &Placed| placed.block.words.windows(2).any(|pair| pair[0].span.end < pair[1].span.start);
        let tight = blocks[..2].iter().all(|placed| !has_gap(placed))
            && blocks[..2].iter().any(|placed| placed.block.words.len() > 1);
        let lower_case = words().all(|word| self.text[word.span.start as usize].is_ascii_lowercase());
        let has_point = |word: &Word| quote(self.text, word.span).ends_with('.');
        let pointed = self.decimal == DecimalRule::LeastIncrement
            || words().any(|word| word.address != b'F' && has_point(word));
        let is_rapid = |word: &&Word| g(word, self.analysis.codes) == Some(G::Motion(MotionMode::Rapid));
        let typed = blocks.iter().rev().find_map(|placed| placed.block.words.iter().find(is_rapid));
        Style {
            gap: if tight { "" } else { " " },
            lower_case,
            point: if pointed { "." } else { "" },
            rapid: typed.map_or_else(|| "G00".into(), |word| quote(self.text, word.span)),
        }
    }

    fn read(&self, at: Resume) -> Placed {
        let mut parser = Parser::resume(self.text, at);
        let mut block = Block::default();
        parser.next_block(&mut block);
        Placed { block, next: parser.position().byte }
    }
}

/// Formats a length in mm as a number of the program, rounded to its least increment.
fn number(value: f64, unit: Unit, point: &str) -> String {
    let text = match unit {
        Unit::Millimetre => format!("{value:.3}"),
        Unit::Inch => format!("{:.4}", value / unit.millimetres()),
    };
    let text = text.trim_end_matches('0').trim_end_matches('.');
    let text = if text == "-0" { "0" } else { text };
    if text.contains('.') { text.to_owned() } else { format!("{text}{point}") }
}
