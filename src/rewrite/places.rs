//! Finds blocks that are nothing but one straight move, and may be rewritten.
//!
//! In: a text and its traced run. Out: the moves in order, each with properties of its block. Excluded are
//! subprograms, loops, contours between P and Q, moves under compensation, and blocks that contain more than
//! a move.

use crate::order;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use crate::control::codes::{self, Compensation, G, M, MotionMode};
use crate::control::words::plain;
use crate::expand::motions_of;
use crate::motion::{Motion, MotionKind};
use crate::run::Analysis;
use crate::setup::dialect::CodeList;
use crate::text::block::{Block, BlockKind, Word};
use crate::text::parser::{Parser, Resume};
use crate::units::Unit;

/// Maximum number of blocks that may begin a contour; in a text with more, everything counts as a contour.
const MAX_LABELS: usize = 100_000;

/// A block that consists of one straight move.
#[derive(Clone, Copy, Debug)]
pub struct Move {
    /// Index in the sequence of executed blocks.
    pub index: usize,
    /// Position of the block in the text.
    pub at: Resume,
    /// Its motion.
    pub motion: Motion,
    /// Unit of its numbers.
    pub unit: Unit,
    /// Whether X and Z are incremental (G91 of systems B and C).
    pub incremental: bool,
    /// Whether only blocks without words are between it and the previous move in the list.
    pub follows: bool,
}

/// Blocks of a text that may or may not be rewritten.
pub struct Places {
    /// Blocks that may be rewritten.
    pub moves: Vec<Move>,
    /// Sequence numbers that are referred to.
    targets: BTreeSet<u32>,
    /// Whether a block refers to a sequence number that is only known at run time.
    any_target: bool,
    /// Byte ranges of loops and contours, sorted, disjoint.
    excluded_ranges: Vec<Range<u32>>,
    /// End of the main program, bytes.
    end: u32,
}

impl Places {
    /// Analyses a program.
    pub fn of(text: &[u8], analysis: &Analysis) -> Self {
        let head = analysis.trace.first().map_or(0, |first| first.at.byte);
        let mut places = Self::read(text, head);
        places.find_moves(text, analysis);
        places
    }

    /// Whether another block may jump or refer to a block.
    pub fn is_target(&self, block: &Block) -> bool {
        block.sequence.is_some_and(|number| self.any_target || self.targets.contains(&number))
    }

    /// Whether a byte is inside a loop or a contour.
    fn is_excluded(&self, byte: u32) -> bool {
        let behind = self.excluded_ranges.partition_point(|excluded_ranges| excluded_ranges.start <= byte);
        behind.checked_sub(1).is_some_and(|index| byte < self.excluded_ranges[index].end)
    }

    /// Collects everything that the text alone determines; the main program begins at byte `head`.
    fn read(text: &[u8], head: u32) -> Self {
        let mut places = Self {
            moves: Vec::new(),
            targets: BTreeSet::new(),
            any_target: false,
            excluded_ranges: Vec::new(),
            end: text.len() as u32,
        };
        let (mut labels, mut pairs, mut loops) =
            (BTreeMap::<u32, Vec<u32>>::new(), BTreeSet::new(), Vec::new());
        let mut ended = false;
        let mut parser = Parser::new(text);
        let mut block = Block::default();
        while parser.next_block(&mut block) {
            let (start, next) = (block.span.start, parser.position().byte);
            if start > head && !ended && (block.program.is_some() || block.words.iter().any(ends_program)) {
                (ended, places.end) = (true, start);
            }
            if let Some(number) = block.sequence {
                labels.entry(number).or_default().push(start);
            }
            if block.kind == BlockKind::Macro {
                places.read_statement(&block.span.quote(text), start..next, &mut loops);
            }
            let named = |address: u8| block.words.iter().find(|word| word.address == address);
            for word in [b'P', b'Q'].into_iter().filter_map(named) {
                match plain(word) {
                    Some(number) if number >= 0.0 => drop(places.targets.insert(number as u32)),
                    _ => places.any_target = true,
                }
            }
            if let (Some(first), Some(last)) = (named(b'P').and_then(plain), named(b'Q').and_then(plain)) {
                pairs.insert((first as u32, last as u32));
            }
        }
        let mut looked_at = 0;
        for (first, last) in pairs {
            let (starts, ends) = (labels.get(&first), labels.get(&last));
            looked_at += starts.map_or(0, Vec::len);
            if looked_at > MAX_LABELS {
                places.excluded_ranges.push(0..u32::MAX);
                break;
            }
            for (&start, ends) in starts.into_iter().flatten().zip(std::iter::repeat(ends)) {
                let end = ends.and_then(|ends| ends.get(ends.partition_point(|&end| end < start)));
                places.excluded_ranges.extend(end.map(|&end| start..end + 1));
            }
        }
        places.excluded_ranges = merged(places.excluded_ranges);
        places
    }

    /// Records jumps and loops of a macro statement.
    fn read_statement(&mut self, statement: &str, bytes: Range<u32>, loops: &mut Vec<u32>) {
        let statement: String = statement.to_ascii_uppercase().split_whitespace().collect();
        if let Some((_, target)) = statement.split_once("GOTO") {
            let digits: String = target.chars().take_while(char::is_ascii_digit).collect();
            match digits.parse() {
                Ok(number) => drop(self.targets.insert(number)),
                Err(_) => self.any_target = true,
            }
        }
        let is_number = |rest: &str| rest.starts_with(|ch: char| ch.is_ascii_digit());
        let is_end = statement.find("END").is_some_and(|at| is_number(&statement[at + 3..]));
        if is_end {
            self.excluded_ranges.extend(loops.pop().map(|start| start..bytes.end));
        } else if statement.rfind("DO").is_some_and(|at| is_number(&statement[at + 2..])) {
            loops.push(bytes.start);
        }
    }

    fn find_moves(&mut self, text: &[u8], analysis: &Analysis) {
        let trace = &analysis.trace;
        let own = motions_of(trace, &analysis.motions);
        let mut times = BTreeMap::new();
        if trace.iter().any(|executed| executed.is_flow_control) {
            for executed in trace {
                *times.entry(executed.at.byte).or_insert(0u32) += 1;
            }
        }
        let (mut unit, mut incremental, mut compensates) = (Unit::Millimetre, false, false);
        let mut follows = false;
        let mut block = Block::default();
        for (index, executed) in trace.iter().enumerate() {
            Parser::resume(text, executed.at).next_block(&mut block);
            let byte = executed.at.byte;
            let inside = byte < self.end && !self.is_excluded(byte);
            let once = times.get(&byte).is_none_or(|&times| times == 1);
            let mut is_plain = executed.values.is_none() && !executed.is_flow_control && is_plain(&block);
            for found in block.words.iter().filter_map(|word| g(word, analysis.codes)) {
                match found {
                    G::Unit(new) => unit = new,
                    G::Distance { incremental: new } => incremental = new,
                    G::Compensation(new) => compensates = new != Compensation::Off,
                    _ => {}
                }
            }
            if is_plain && block.is_empty() && own[index].is_empty() {
                continue;
            }
            is_plain &= inside && once && !compensates && holds_only_a_move(&block, analysis.codes);
            let motion = (own[index].len() == 1).then(|| analysis.motions.get(own[index].start));
            match motion.filter(|motion| is_plain && is_simple(motion)) {
                Some(motion) => {
                    self.moves.push(Move { index, at: executed.at, motion, unit, incremental, follows });
                    follows = true;
                }
                None => follows = false,
            }
        }
    }
}

/// Sorts ranges and merges overlapping ones.
fn merged(mut ranges: Vec<Range<u32>>) -> Vec<Range<u32>> {
    order::by_key(&mut ranges, |range| range.start);
    let mut found: Vec<Range<u32>> = Vec::new();
    for range in ranges {
        match found.last_mut().filter(|last| range.start <= last.end) {
            Some(last) => last.end = last.end.max(range.end),
            None => found.push(range),
        }
    }
    found
}

/// The G code of a word.
pub fn g(word: &Word, list: CodeList) -> Option<G> {
    let crate::text::block::Value::Number { number, .. } = word.value else { return None };
    let tenths = number.tenths().filter(|_| word.address == b'G')?;
    codes::g_code(tenths, list).map(|found| found.code)
}

/// Whether a word ends or leaves a main program.
pub fn ends_program(word: &Word) -> bool {
    let number = plain(word).filter(|number| word.address == b'M' && *number >= 0.0);
    let code = number.and_then(|number| codes::m_code(number as u64));
    matches!(code, Some(M::End | M::Return))
}

/// Whether a block contains only words and comments, without faults and without a slash.
pub fn is_plain(block: &Block) -> bool {
    block.kind == BlockKind::Words
        && block.delete.is_none()
        && block.optional.is_none()
        && block.program.is_none()
        && !block.has_expressions
        && block.faults.is_empty()
}

/// Whether the words of a block form one straight move, each at most once.
fn holds_only_a_move(block: &Block, list: CodeList) -> bool {
    let mut seen = 0u32;
    for word in &block.words {
        let is_move = match word.address {
            b'G' => matches!(
                g(word, list),
                Some(G::Motion(MotionMode::Rapid | MotionMode::Line | MotionMode::Thread))
            ),
            b'X' | b'Z' | b'U' | b'W' | b'F' => !word.comma,
            _ => false,
        };
        let bit = 1
            << match word.address {
                b'U' => b'X' - b'A',
                b'W' => b'Z' - b'A',
                other => other - b'A',
            };
        if !is_move || seen & bit != 0 {
            return false;
        }
        seen |= bit;
    }
    true
}

/// Whether a motion is straight, and made by its own block alone.
fn is_simple(motion: &Motion) -> bool {
    matches!(motion.kind, MotionKind::Rapid | MotionKind::Feed | MotionKind::Thread)
        && motion.cycle.is_none()
        && motion.rotary.is_none()
        && motion.programmed.is_none()
        && !motion.process.uncertain
        && !motion.process.incomplete
}
