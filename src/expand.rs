//! Expands every cycle, corner, compensation, subprogram and macro of a program to plain G00, G01, G02, G03
//! and G32 blocks.
//!
//! In: a program, its motions and its executed blocks. Out: a program that makes the same motions to 0.001 mm
//! under G40, at the same feed and speed. It is written in execution order: a subprogram appears where it was
//! called, a loop as often as it ran. Plain blocks stay as they were typed, except that their lengths get a
//! decimal point if other moves are expanded with one. Other words of a cycle block (S, T, M, other G codes)
//! are kept on a separate line, as are such words in the blocks of its contour. Blocks between G12.1 and
//! G13.1 stay as they are. An ignored contour is omitted; a cycle that could not run stays as it is. All
//! blocks that depend on a block that was not executed, or that such a block depends on, stay as they are
//! too: their motions remain uncertain.
//!
//! The expanded program is run once. If its motions still differ, there is no expansion.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::mem::discriminant;
use std::ops::Range;

use crate::control::codes::{self, G, MotionMode, Plane, Switch};
use crate::control::interpreter::{Context, Executed};
use crate::control::words::plain;
use crate::geometry::virtual_plane::{VirtualMove, Way};
use crate::geometry::{Point, Turn};
use crate::message::said;
use crate::motion::{Feed, Motion, MotionKind, Motions, Process, SpindleSpeed, SpindleTurn};
use crate::provenance;
use crate::run::{Analysis, Run};
use crate::setup::dialect::{CodeList, DecimalRule, Dialect};
use crate::setup::{Setup, tool_word};
use crate::text::block::{Block, BlockKind, Value, Word};
use crate::text::parser::{Parser, Resume};
use crate::units::{Diameter, Unit};

/// Expands a program; returns it unchanged if it has no expansion.
pub fn expand(text: &[u8], setup: &Setup) -> String {
    expansion(text, setup).unwrap_or_else(|| String::from_utf8_lossy(text).into_owned())
}

/// The expanded program; `None` if it would make other motions.
pub fn expansion(text: &[u8], setup: &Setup) -> Option<String> {
    let mut run = Run::new(text.to_vec(), setup.clone()).traced();
    while !run.advance(usize::MAX) {}
    write_out(text, &run.into_analysis())
}

/// Expands a program whose run recorded a trace. `None` if the expanded program would make other motions.
pub fn write_out(text: &[u8], analysis: &Analysis) -> Option<String> {
    let mut setup = analysis.setup.clone();
    if analysis.decides_decimal {
        setup.dialect.decimal = None;
    }
    let makes_same = |expanded: &String| {
        expanded.as_bytes() == text
            || same_motions(&analysis.motions, &crate::analyze(expanded.as_bytes(), &setup).motions)
    };
    let expanded = unchecked(text, analysis, Uncertain::Expanded);
    if makes_same(&expanded) {
        return Some(expanded);
    }
    let as_typed = unchecked(text, analysis, Uncertain::AsTyped);
    (as_typed != expanded && makes_same(&as_typed)).then_some(as_typed)
}

/// How to handle a cycle whose moves are all uncertain.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Uncertain {
    /// Expand it to incremental moves; the position after it is as uncertain as before.
    Expanded,
    /// Keep it as typed.
    AsTyped,
}

fn unchecked(text: &[u8], analysis: &Analysis, uncertain: Uncertain) -> String {
    let as_typed = write_with(text, analysis, Points::AsTyped, uncertain);
    let rule = Dialect::new(&analysis.setup.dialect).decimal;
    let mut out = as_typed.out;
    if as_typed.any_written {
        // Numbers with and without a point in one program look like a mistake, and may be read as one.
        out = write_with(text, analysis, Points::Everywhere(rule), uncertain).out;
    }
    if analysis.concludes_inches
        && provenance::recognise(out.as_bytes()).is_none_or(|shown| shown.inches.is_none())
    {
        out.insert_str(end_of_head(&out), "(DIALECT UNIT=INCH)\n");
    }
    if analysis.decides_decimal && provenance::numbers(out.as_bytes()).rule() != rule {
        // The numbers that showed the rule have been expanded, so state the rule in a comment.
        let name = match rule {
            DecimalRule::LeastIncrement => "LEASTINCREMENT",
            DecimalRule::Calculator => "CALCULATOR",
        };
        out.insert_str(end_of_head(&out), &format!("(DIALECT DECIMAL={name})\n"));
    }
    out
}

/// The end of the `%` line and the program number line at the beginning of a text.
fn end_of_head(text: &str) -> usize {
    let is_head = |line: &&str| line.starts_with(['%', 'O', 'o']) && line.ends_with('\n');
    text.split_inclusive('\n').take(2).take_while(is_head).map(str::len).sum()
}

/// Whether two programs make the same motions, within the rounding of an expanded program.
fn same_motions(before: &Motions, after: &Motions) -> bool {
    let (mut before, mut after) = (before.iter().peekable(), after.iter().peekable());
    loop {
        match (before.peek(), after.peek()) {
            (None, None) => return true,
            (Some(one), Some(other)) if same_motion(one, other) => {
                before.next();
                after.next();
            }
            (Some(one), _) if may_be_lost(one) => drop(before.next()),
            (_, Some(other)) if may_be_lost(other) => drop(after.next()),
            _ => return false,
        }
    }
}

/// Whether a move may vanish when rounded to 0.001 mm.
fn may_be_lost(motion: &Motion) -> bool {
    const SHORT: f64 = 2.5e-3;
    motion.kind != MotionKind::Dwell && motion.rotary.is_none() && motion.length() < SHORT
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() <= 0.002
}

fn same_place(a: Point, b: Point) -> bool {
    near(a.x, b.x) && near(a.z, b.z)
}

fn same_virtual_move(a: &VirtualMove, b: &VirtualMove) -> bool {
    let same_way = match (&a.way, &b.way) {
        (Way::Line(from, to), Way::Line(other_from, other_to)) => {
            same_place(*from, *other_from) && same_place(*to, *other_to)
        }
        (Way::Arc(a), Way::Arc(b)) => {
            same_place(a.start, b.start)
                && same_place(a.end, b.end)
                && same_place(a.center, b.center)
                && a.turn == b.turn
        }
        _ => false,
    };
    a.surface == b.surface && same_way && near(a.third.0, b.third.0) && near(a.third.1, b.third.1)
}

fn same_motion(before: &Motion, after: &Motion) -> bool {
    let same_center = match (before.center, after.center) {
        (Some(a), Some(b)) => same_place(a, b),
        (a, b) => a.is_none() && b.is_none(),
    };
    let same_turn = match (before.rotary, after.rotary) {
        (Some(a), Some(b)) => {
            let same_way = match (a.virtual_move, b.virtual_move) {
                (Some(a), Some(b)) => same_virtual_move(&a, &b),
                (a, b) => a.is_none() && b.is_none(),
            };
            near(a.from, b.from) && near(a.to, b.to) && same_way
        }
        (a, b) => a.is_none() && b.is_none(),
    };
    let relative = |a: f64, b: f64| (a - b).abs() <= 1e-4 * (1.0 + a.abs());
    let same_feed = match (before.process.feed, after.process.feed) {
        (Feed::PerMinute(a), Feed::PerMinute(b)) | (Feed::PerTurn(a), Feed::PerTurn(b)) => relative(a, b),
        (a, b) => a == b,
    };
    let is_thread = before.kind == MotionKind::Thread;
    let same = |before: Option<f64>, after: Option<f64>| match (before, after) {
        (Some(a), Some(b)) => relative(a, b),
        (a, b) => a.is_none() && b.is_none(),
    };
    let same_lead = same(before.lead, after.lead)
        && same(before.lead_change, after.lead_change)
        && relative(before.start_angle, after.start_angle);
    let spindle =
        |process: &Process| (process.turn, process.tool, process.clamp, process.lowest, process.speed);
    before.kind == after.kind
        && same_place(before.from, after.from)
        && same_place(before.to, after.to)
        && same_place(before.process.zero, after.process.zero)
        && (before.process.frame, before.process.other_setup)
            == (after.process.frame, after.process.other_setup)
        && same_center
        && same_turn
        && match (before.seconds, after.seconds) {
            (Some(a), Some(b)) => near(a, b),
            (a, b) => a.is_none() && b.is_none(),
        }
        && (same_lead || !is_thread)
        && (same_feed || is_thread || !before.kind.cuts())
        && before.process.uncertain == after.process.uncertain
        && spindle(&before.process) == spindle(&after.process)
}

fn write_with<'a>(
    text: &'a [u8],
    analysis: &'a Analysis,
    points: Points,
    uncertain: Uncertain,
) -> Writer<'a> {
    let trace = &analysis.trace;
    let mut writer = Writer {
        text,
        out: String::new(),
        motions: &analysis.motions,
        list: analysis.codes,
        mode: MotionMode::Rapid,
        written: MotionMode::Rapid,
        feed: None,
        lead: None,
        inch: false,
        incremental: false,
        in_plane: false,
        has_y: analysis.setup.machine.has_y(),
        moved_start: false,
        turns_by_way: false,
        any_failed: false,
        process: None,
        points,
        any_written: false,
    };
    let Some(first) = trace.first() else {
        writer.out.push_str(&String::from_utf8_lossy(text));
        return writer;
    };
    (writer.process, writer.mode, writer.written) = (Some(*first.before), first.mode, first.mode);
    let own = motions_of(trace, &analysis.motions);
    let jumps = trace.iter().any(|executed| executed.is_flow_control);
    let kept = writer.kept_blocks(trace, &own, uncertain);
    let mut block = Block::default();
    // Copy the text before the first block.
    if !jumps {
        writer.out.push_str(&String::from_utf8_lossy(&text[..first.at.byte as usize]));
    }
    for (index, executed) in trace.iter().enumerate() {
        let end = read(text, executed.at, &mut block);
        let range = own[index].clone();
        // The statement after THEN is a block itself; a macro statement with values writes to a table.
        let words = |values: &&str| block.kind == BlockKind::Words || !values.starts_with('#');
        if let Some(values) = executed.values.as_deref().filter(words) {
            with_values(&mut block, values);
        }
        let mode = writer.codes(&block).find_map(|code| match code {
            G::Motion(mode) => Some(mode),
            _ => None,
        });
        writer.mode = mode.unwrap_or(executed.mode);
        let is_last = index + 1 == trace.len();
        // The last block of the text may lack a line end, and other blocks may still be executed after it.
        if index > 0 && !writer.out.ends_with(['\n', ';', '\r']) {
            writer.out.push('\n');
        }
        writer.write_process_changes(&executed.before, Units::OfProgram);
        let leaves = trace.get(index + 1).map_or(*executed.ready, |next| *next.before);
        // A program number inside a program would end it, so the numbers of subprograms become comments.
        let is_called = jumps && index > 0 && block.program.is_some();
        let refused = kept[index] && executed.failed && range.is_empty();
        let mut is_copied = false;
        if is_called && range.is_empty() && block.words.is_empty() {
            writer.remark(&block);
            writer.comments(&block);
        } else if is_called && range.is_empty() {
            // `O2 G55`: its codes still apply.
            writer.write(&block, executed, range.clone(), leaves);
        } else if executed.is_flow_control && !refused && !(is_last && ends_main(&block)) {
            writer.write_flow_block(&block, executed, range.clone(), leaves);
        } else if !kept[index] && writer.must_write(&block, executed, range.clone()) {
            writer.write(&block, executed, range.clone(), leaves);
        } else if executed.values.as_deref().is_some_and(str::is_empty) && !refused {
            // None of its words has a value.
            writer.remark(&block);
            writer.comments(&block);
        } else {
            is_copied = true;
            let values = executed.values.as_deref().filter(|values| !values.is_empty());
            let bytes = match values {
                Some(_) => None,
                None => Some(executed.at.byte as usize..end as usize),
            };
            let depends_on_motion_code =
                executed.context != Context::Data && writer.depends_on_motion_code(&block);
            writer.restore(&block, executed, range.clone(), depends_on_motion_code, kept[index]);
            writer.copy(&block, bytes, values, range.clone());
            let after = trace.get(index + 1).map_or(executed.mode, |next| next.mode);
            if mode.is_some() || after != executed.mode {
                writer.written = after;
            }
            writer.process = Some(leaves);
        }
        let (passed, until) = (executed.passed as usize, executed.until as usize);
        let contour = end as usize..passed.max(end as usize);
        if is_copied {
            writer.out.push_str(&String::from_utf8_lossy(&text[contour]));
        } else {
            writer.comments_between(contour);
        }
        writer.out.push_str(&String::from_utf8_lossy(&text[passed..until.max(passed)]));
        // The text up to the next block was deleted, or comes after the end of the program.
        let next = trace.get(index + 1).map_or(text.len(), |next| next.at.byte as usize);
        if !jumps {
            writer.out.push_str(&String::from_utf8_lossy(&text[until..next.max(until)]));
        }
    }
    writer
}

/// Reads the block at a position; returns its end.
fn read(text: &[u8], at: Resume, block: &mut Block) -> u32 {
    let mut parser = Parser::resume(text, at);
    parser.next_block(block);
    parser.position().byte
}

/// The motions of each executed block. Motions may be delayed by a later block, but keep their order. If a
/// block is executed again, the motions before that belong to its first execution.
pub(crate) fn motions_of(trace: &[Executed], motions: &Motions) -> Vec<Range<usize>> {
    let mut limits = Vec::new();
    if trace.iter().zip(trace.iter().skip(1)).any(|(one, next)| next.at.byte <= one.at.byte) {
        let mut again = BTreeMap::new();
        limits = vec![motions.len(); trace.len()];
        for (index, executed) in trace.iter().enumerate().rev() {
            let first = executed.first as usize;
            limits[index] = again.insert(executed.at.byte, first).unwrap_or(motions.len());
        }
    }
    let mut next = 0;
    let mut own = Vec::with_capacity(trace.len());
    for (index, executed) in trace.iter().enumerate() {
        let limit = limits.get(index).copied().unwrap_or(motions.len());
        let first = next;
        while next < limit && motions.span(next).start == executed.at.byte {
            next += 1;
        }
        own.push(first..next);
    }
    own
}

/// Replaces the words of a block by its words with values in place of expressions.
fn with_values(block: &mut Block, values: &str) {
    let mut own = Block::default();
    Parser::new(values.as_bytes()).next_block(&mut own);
    // Only letters and values of the words are used; their span is that of the block.
    let span = block.words_span();
    block.kind = BlockKind::Words;
    block.words = own.words.iter().map(|word| Word { span, ..*word }).collect();
}

/// Whether the block is M99 alone, as at the end of a main program.
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
    /// The code of group 01 of the current block.
    mode: MotionMode,
    /// The code of group 01 at the end of the written text.
    written: MotionMode,
    feed: Option<f64>,
    /// The lead set by E, or by I on GSK, at the end of the written text, mm; `None` after an F.
    lead: Option<f64>,
    inch: bool,
    /// G91 of systems B and C.
    incremental: bool,
    /// Whether the tool is between G12.1 and G13.1, on a cylinder, or in a plane with Y: nothing is expanded
    /// there.
    in_plane: bool,
    has_y: bool,
    /// Whether the previous block was expanded to moves, so that the start of this one may have moved.
    moved_start: bool,
    /// Whether the current block turns C by H.
    turns_by_way: bool,
    /// Whether a contour cycle could not run: first blocks are then kept, because it needs them.
    any_failed: bool,
    /// Feed, spindle and tool at the end of the written text; of the feed, only G98 or G99 is used.
    process: Option<Process>,
    points: Points,
    /// Whether moves were expanded.
    any_written: bool,
}

/// The format of lengths in copied moves.
#[derive(Clone, Copy)]
enum Points {
    AsTyped,
    /// With a decimal point. The rule gives the unit of those typed without one.
    Everywhere(DecimalRule),
}

/// The units in force at the current position of the output.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Units {
    /// The units chosen by the program.
    OfProgram,
    /// Millimetres, regardless of the program.
    Millimetres,
}

impl Writer<'_> {
    fn codes<'b>(&self, block: &'b Block) -> impl Iterator<Item = G> + use<'b> {
        let list = self.list;
        block.words.iter().filter_map(move |word| code(word, list))
    }

    /// Whether a block is between G12.1 and G13.1, or on a cylinder.
    fn is_in_plane(&self, own: &Range<usize>) -> bool {
        let moved = own.clone().next().map(|index| self.motions.get(index).rotary);
        moved.map_or(self.in_plane, |rotary| rotary.is_some_and(|rotary| rotary.virtual_move.is_some()))
    }

    /// The blocks that stay as typed: each block that was not executed, and the blocks before and after it
    /// that share modal state with it, up to the next settled block.
    fn kept_blocks(&mut self, trace: &[Executed], own: &[Range<usize>], uncertain: Uncertain) -> Vec<bool> {
        let mut kept = vec![false; trace.len()];
        let mut block = Block::default();
        let any_failed = trace.iter().any(|executed| executed.failed);
        let (mut start, mut is_faulty) = (0, false);
        // P of the contours that a kept block may read.
        let mut contours = BTreeSet::new();
        let mut calls = Vec::new();
        let contour = |block: &Block| block.words.iter().find(|word| word.address == b'P').and_then(plain);
        for (index, executed) in trace.iter().enumerate() {
            let end = read(self.text, executed.at, &mut block);
            let ends_cycle = |code| matches!(code, G::Motion(mode) if !matches!(mode, MotionMode::Cycle(_)));
            let is_settled = match executed.context {
                Context::Settled => true,
                Context::Cycle => self.codes(&block).any(ends_cycle),
                Context::Open | Context::Data => false,
            };
            if is_settled {
                kept[start..index].fill(is_faulty);
                (start, is_faulty) = (index, false);
            }
            is_faulty |= executed.failed
                || executed.context == Context::Open && is_uncertain(&own[index], self.motions);
            let multiple = self.codes(&block).any(|code| matches!(code, G::Multiple(_)));
            if multiple {
                calls.push((index, contour(&block).map(f64::to_bits)));
                let has_contour = executed.passed > end && own[index].is_empty();
                self.any_failed |= has_contour && contour(&block).is_some();
            }
        }
        if any_failed {
            kept[start..].fill(is_faulty);
        }
        if uncertain == Uncertain::Expanded && any_failed && !matches!(self.list, CodeList::B | CodeList::C) {
            let is_own = |motion: Motion| motion.cycle.is_some() && motion.process.uncertain;
            for (index, executed) in trace.iter().enumerate() {
                let mut motions = own[index].clone().map(|index| self.motions.get(index));
                let is_cycle = !own[index].is_empty() && motions.all(is_own);
                kept[index] &= !is_cycle || executed.failed;
            }
        }
        for (index, contour) in &calls {
            if kept[*index] {
                self.any_failed = true;
                contours.extend(*contour);
            }
        }
        for (index, contour) in calls {
            kept[index] |= contour.is_some_and(|contour| contours.contains(&contour));
        }
        kept
    }

    /// Whether the words of a block depend on the current code of group 01.
    fn depends_on_motion_code(&self, block: &Block) -> bool {
        let has_own = |code| {
            matches!(
                code,
                G::Motion(_)
                    | G::Dwell
                    | G::CheckHome
                    | G::Home
                    | G::FromHome
                    | G::OtherHome
                    | G::Machine
                    | G::Data
                    | G::Hole(_)
                    | G::MacroCall(_)
                    | G::Setting
                    | G::LocalFrame
                    | G::ExtendedFrame
                    | G::Polar(_)
                    | G::Cylinder
                    | G::Multiple(_)
                    | G::NotSupported
            )
        };
        let moves = |word: &Word| word.comma || b"XZUWYVCHAIJKR".contains(&word.address);
        block.kind == BlockKind::Words && block.words.iter().any(moves) && !self.codes(block).any(has_own)
    }

    /// Writes the modal words that a copied block depends on, if others are in force at the end of the
    /// written text.
    fn restore(
        &mut self,
        block: &Block,
        executed: &Executed,
        own: Range<usize>,
        depends_on_motion_code: bool,
        is_kept: bool,
    ) {
        if depends_on_motion_code
            && self.written != executed.mode
            && let Some(code) = self.code_of_mode(executed.mode)
        {
            let _ = write!(self.out, "{code} ");
            self.written = executed.mode;
        }
        let last = own.clone().next_back().map(|index| self.motions.get(index));
        let lead = last.filter(|last| last.kind == MotionKind::Thread).and_then(|last| last.lead);
        let has = |letter: u8| block.words.iter().any(|word| word.address == letter);
        let names_lead = lead.is_some() && (has(b'E') || has(b'I'));
        let feed = match (executed.ready.feed, &last) {
            (Feed::PerMinute(feed) | Feed::PerTurn(feed), _) if is_kept && lead.is_none() => Some(feed),
            (_, Some(last)) => feed_of(last),
            _ => None,
        };
        let needs_feed = match is_kept {
            true => depends_on_motion_code || last.is_some(),
            false => last.as_ref().is_some_and(|last| last.kind.cuts()),
        };
        // A thread that was expanded before has written its lead as F.
        let in_force = self.lead.filter(|_| lead.is_some()).or(self.feed);
        match (executed.ready.feed, feed) {
            (Feed::PerMinute(feed) | Feed::PerTurn(feed), _) if has(b'F') => self.set_feed(feed),
            (_, Some(feed)) if needs_feed && !names_lead && in_force != Some(feed) => {
                let unit = if self.inch { 25.4 } else { 1.0 };
                let _ = write!(self.out, "F{} ", fine_decimal(feed / unit));
                self.set_feed(feed);
            }
            _ => {}
        }
        if names_lead && lead != self.feed {
            self.lead = lead;
        }
    }

    /// Sets the feed after an F, which ends a lead set by another word.
    fn set_feed(&mut self, feed: f64) {
        self.feed = Some(feed);
        self.lead = None;
    }

    /// Whether a block is more than plain moves, so that it must be rewritten.
    fn must_write(&self, block: &Block, executed: &Executed, own: Range<usize>) -> bool {
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
        if self.has_y && self.codes(block).any(|code| matches!(code, G::Plane(plane) if plane != Plane::Zx)) {
            return false;
        }
        if own.is_empty() {
            // The first block of a two-block cycle only sets values that the expansion has used.
            let word = |address: u8| block.words.iter().any(|word| word.address == address);
            let first = multiple
                .is_some_and(|cycle| cycle == codes::Multiple::Threading || !(word(b'P') || word(b'Q')));
            let hole = self.codes(block).any(|code| matches!(code, G::Hole(_)));
            // The control ignores words without an axis while such a code is in force, but G00 or G01 would
            // execute them.
            let is_path = matches!(executed.mode, MotionMode::Rapid | MotionMode::Line | MotionMode::Arc(_));
            let ignored =
                (executed.context == Context::Cycle || !is_path) && self.depends_on_motion_code(block);
            return (first && !self.any_failed) || compensates || hole || ignored;
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
            // A rounding may consume the whole move and leave only its arc.
            let straight = motion.kind == MotionKind::Feed
                || motion.kind.cuts() && motion.center.is_some() && self.mode == MotionMode::Line;
            rounds |= straight && (word(b'R') || word(b'I') || word(b'K'));
        }
        cornered || rounds || compensates
    }

    /// Whether C moves as an axis in any of the motions.
    fn turns(&self, own: &Range<usize>) -> bool {
        own.clone().any(|index| self.motions.get(index).rotary.is_some())
    }

    /// Records the modal codes of a copied block.
    fn record_modes(&mut self, block: &Block) {
        for code in self.codes(block).collect::<Vec<_>>() {
            match code {
                G::Unit(unit) => self.inch = unit == Unit::Inch,
                G::Distance { incremental } => self.incremental = incremental,
                G::Polar(switch) => self.in_plane = switch == Switch::On,
                G::Plane(plane) if self.has_y => self.in_plane = plane != Plane::Zx,
                G::Cylinder => {
                    let radius = block.words.iter().find(|word| word.address == b'C').and_then(plain);
                    self.in_plane = radius.is_some_and(|radius| radius != 0.0);
                }
                _ => {}
            }
        }
    }

    /// Copies a plain block as typed, or with its values.
    fn copy(&mut self, block: &Block, bytes: Option<Range<usize>>, values: Option<&str>, own: Range<usize>) {
        let lengths = self.lengths_of(block, own.clone());
        self.record_modes(block);
        if !own.is_empty() {
            self.moved_start = false;
        }
        let remark = block.faults.iter().any(|fault| fault.message.is::<said::TextAfterSemicolon>());
        if remark && self.out.ends_with('\n') {
            // Text after a `;` counts as a comment only on the line of its block, which was expanded.
            self.comments(block);
            return;
        }
        match (bytes, values) {
            (Some(bytes), _) => {
                let written = self.with_points(self.text, bytes, &block.words, lengths);
                self.out.push_str(&written);
            }
            (None, values) => {
                // Values of expressions have a decimal point.
                self.any_written |= !own.is_empty();
                let values = values.unwrap_or_default().as_bytes();
                let mut own = Block::default();
                Parser::new(values).next_block(&mut own);
                let written = self.with_points(values, 0..values.len(), &own.words, lengths);
                self.line(&written);
                self.comments(block);
            }
        }
    }

    /// The letters of a copied block whose numbers get a decimal point: the lengths, if the block only moves.
    fn lengths_of(&self, block: &Block, own: Range<usize>) -> &'static [u8] {
        let path = |code| {
            matches!(
                code,
                G::Motion(_)
                    | G::Unit(_)
                    | G::Plane(_)
                    | G::Distance { .. }
                    | G::Frame(_)
                    | G::Compensation(_)
                    | G::Feed(_)
                    | G::SurfaceSpeed
                    | G::ConstantSpeed
            )
        };
        let kinds =
            || own.clone().map(|index| self.motions.get(index)).map(|motion| (motion.kind, motion.rotary));
        if own.is_empty()
            || !self.codes(block).all(path)
            || kinds().any(|(kind, rotary)| kind == MotionKind::Dwell || rotary.is_some())
        {
            return b"";
        }
        // I, K and R of a thread are not lengths of its path.
        if kinds().any(|(kind, _)| kind == MotionKind::Thread) { b"XZUW" } else { b"XZUWIKR" }
    }

    /// Part of a text, with a decimal point added to the lengths among its words.
    fn with_points(&self, text: &[u8], part: Range<usize>, words: &[Word], lengths: &[u8]) -> String {
        let mut out = String::new();
        let mut done = part.start;
        for word in words.iter().filter(|word| lengths.contains(&word.address)) {
            let Value::Number { number, negative } = word.value else { continue };
            let (start, end) = (word.span.start as usize, word.span.end as usize);
            let Points::Everywhere(rule) = self.points else { continue };
            if number.has_point() || number.value() == 0.0 || start < done {
                continue;
            }
            match rule {
                DecimalRule::Calculator => {
                    out.push_str(&String::from_utf8_lossy(&text[done..end]));
                    out.push('.');
                }
                DecimalRule::LeastIncrement => {
                    let (unit, digits) = if self.inch { (10_000.0, 4) } else { (1_000.0, 3) };
                    out.push_str(&String::from_utf8_lossy(&text[done..start]));
                    let (letter, sign) = (word.address as char, if negative { "-" } else { "" });
                    let value = trimmed(format!("{:.digits$}", number.value() / unit));
                    let _ = write!(out, "{letter}{sign}{value}");
                }
            }
            done = end;
        }
        out.push_str(&String::from_utf8_lossy(&text[done..part.end]));
        out
    }

    /// Writes the commands that change feed, spindle and tool from their values in the written text to their
    /// values in the program, each on a separate line. Such changes come from blocks of a contour, or from
    /// the reversal after tapping.
    fn write_process_changes(&mut self, process: &Process, units: Units) {
        let Some(now) = self.process.replace(*process) else { return };
        let unit = if self.inch { Unit::Inch } else { Unit::Millimetre };
        let mut lines = Vec::new();
        if now.tool != process.tool {
            lines.push(tool_word(process.tool));
        }
        let limits = [('S', now.clamp, process.clamp), ('Q', now.lowest, process.lowest)];
        let limits = limits.into_iter().filter(|(_, before, after)| before != after);
        let limits: String =
            limits.filter_map(|(letter, _, after)| Some(format!(" {letter}{}", whole(after?)))).collect();
        if !limits.is_empty() {
            let code = if matches!(self.list, CodeList::B | CodeList::C) { "G92" } else { "G50" };
            lines.push(format!("{code}{limits}"));
        }
        if now.speed != process.speed {
            lines.push(match process.speed {
                SpindleSpeed::Constant(rpm) => format!("G97 S{}", whole(rpm)),
                SpindleSpeed::Surface { speed } => format!("G96 S{}", whole(speed / unit.surface_metres())),
            });
        }
        if now.turn != process.turn {
            // The spindle stops before it reverses.
            if now.turn != SpindleTurn::Stopped {
                lines.push("M05".to_owned());
            }
            match process.turn {
                SpindleTurn::Stopped => {}
                SpindleTurn::Forward => lines.push("M03".to_owned()),
                SpindleTurn::Reverse => lines.push("M04".to_owned()),
            }
        }
        let systems = matches!(self.list, CodeList::B | CodeList::C);
        let mode = match (now.feed, process.feed) {
            (Feed::PerTurn(_) | Feed::Unset, Feed::PerMinute(_)) => Some(if systems { "G94" } else { "G98" }),
            (Feed::PerMinute(_) | Feed::Unset, Feed::PerTurn(_)) => Some(if systems { "G95" } else { "G99" }),
            _ => None,
        };
        if let Some(mode) = mode {
            lines.push(mode.to_owned());
            // The unit of F changes here, so F must be written again.
            self.feed = None;
        }
        if lines.is_empty() {
            return;
        }
        if !self.out.is_empty() && !self.out.ends_with(['\n', '\r']) {
            self.out.push('\n');
        }
        // The cutting speed was given in feet, as a whole number.
        let in_feet = self.inch && units == Units::Millimetres && now.speed != process.speed;
        if in_feet {
            self.line(self.unit_code(Unit::Inch));
        }
        for line in lines {
            self.line(&line);
        }
        if in_feet {
            self.line(self.unit_code(Unit::Millimetre));
        }
    }

    fn unit_code(&self, unit: Unit) -> &'static str {
        match (unit, self.list) {
            (Unit::Inch, CodeList::C) => "G70",
            (Unit::Millimetre, CodeList::C) => "G71",
            (Unit::Inch, _) => "G20",
            (Unit::Millimetre, _) => "G21",
        }
    }

    /// Writes a block that controls the program flow as a comment; expands its moves.
    fn write_flow_block(&mut self, block: &Block, executed: &Executed, own: Range<usize>, leaves: Process) {
        let values = executed.values.as_deref();
        if let Some(values) = values.filter(|_| block.kind == BlockKind::Macro && own.is_empty()) {
            // Still write to the tables of the control.
            self.line(values);
        } else if block.kind == BlockKind::Macro && own.is_empty() {
            self.remark(block);
            self.comments(block);
        } else if !own.is_empty() && self.is_in_plane(&own) {
            // Keep the move as it is, and the call as a comment.
            self.remark(block);
            self.comments(block);
            let is_call =
                |word: &&Word| codes::is_call_or_return(word) || matches!(word.address, b'P' | b'L' | b'Q');
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
            self.process = Some(leaves);
        } else {
            self.write(block, executed, own, leaves);
        }
    }

    /// Writes a block as a comment.
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

    /// Writes a block as plain moves. `leaves`: feed, spindle and tool after it.
    fn write(&mut self, block: &Block, executed: &Executed, own: Range<usize>, leaves: Process) {
        let mut before = String::new();
        let mut after = String::new();
        let called = block.words.iter().position(codes::calls_macro);
        for word in &block.words[..called.unwrap_or(block.words.len())] {
            let quoted: String =
                word.span.quote(self.text).chars().filter(|ch| !ch.is_whitespace()).collect();
            let target = match (word.address, plain(word)) {
                _ if codes::is_call_or_return(word) => continue,
                (b'M', Some(0.0 | 1.0 | 2.0 | 5.0 | 9.0 | 25.0 | 30.0)) => &mut after,
                (b'M' | b'S' | b'T', _) => &mut before,
                // P selects the frame of G54.1.
                (b'P', _) if self.codes(block).any(|code| code == G::ExtendedFrame) => &mut before,
                (b'G', _) => match code(word, self.list) {
                    Some(
                        G::Motion(_)
                        | G::Multiple(_)
                        | G::Compensation(_)
                        | G::Hole(_)
                        | G::Home
                        | G::OtherHome
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
        self.record_modes(block);
        self.line(&before);
        let counted = self.process.replace(*executed.ready).map(|process| discriminant(&process.feed));
        if counted != Some(discriminant(&executed.ready.feed)) {
            // G98 or G99 in the block itself: the unit of F changes, so F must be written again.
            self.feed = None;
        }
        let (inch, incremental) = (self.inch && !own.is_empty(), self.incremental && !own.is_empty());
        if inch {
            self.line(self.unit_code(Unit::Millimetre));
        }
        if incremental {
            self.line("G90");
        }
        let mut pass = None;
        self.any_written |= !own.is_empty();
        let has = |address: u8| block.words.iter().any(|word| word.address == address);
        self.turns_by_way = has(b'H') && !has(b'C');
        let home = block
            .words
            .iter()
            .find(|word| matches!(code(word, self.list), Some(G::Home | G::OtherHome)) && !own.is_empty());
        let home = home.map(|word| word.span.quote(self.text));
        for index in own.clone() {
            let motion = self.motions.get(index);
            if let Some(step) =
                motion.cycle.filter(|step| step.pass > 0 && pass != Some((step.cycle, step.pass)))
            {
                pass = Some((step.cycle, step.pass));
                let _ = writeln!(self.out, "({} PASS {})", step.cycle.code(), step.pass);
            }
            self.write_process_changes(
                &motion.process,
                if inch { Units::Millimetres } else { Units::OfProgram },
            );
            if let Some(home) = home.as_deref().filter(|_| index + 1 == own.end) {
                self.go_home(block, home, &motion);
                continue;
            }
            self.motion(&motion);
        }
        // An M05 in the block itself takes effect after its moves.
        let stops = block.words.iter().any(|word| word.address == b'M' && plain(word) == Some(5.0));
        let behind = Process { turn: if stops { executed.ready.turn } else { leaves.turn }, ..leaves };
        self.write_process_changes(&behind, if inch { Units::Millimetres } else { Units::OfProgram });
        self.process = Some(leaves);
        if incremental {
            self.line("G91");
        }
        if inch {
            self.line(self.unit_code(Unit::Inch));
            self.feed = None;
        }
        self.line(&after);
        let last_is_cycle = own.clone().last().is_some_and(|index| self.motions.get(index).cycle.is_some());
        if !own.is_empty() {
            self.moved_start = !last_is_cycle;
        }
    }

    /// Writes G28 or G30 from the current tool position; `code` as typed.
    fn go_home(&mut self, block: &Block, code: &str, motion: &Motion) {
        let names = |letters: &[u8]| block.words.iter().any(|word| letters.contains(&word.address));
        let mut home = code.trim().to_owned();
        if let Some(point) = block.words.iter().find(|word| word.address == b'P') {
            let _ = write!(home, " {}", point.span.quote(self.text).trim());
        }
        if names(b"XU") {
            let _ = write!(home, " X{}", decimal(Diameter::from_radius(motion.from.x).mm()));
        }
        if names(b"ZW") {
            let _ = write!(home, " Z{}", decimal(motion.from.z));
        }
        self.line(&home);
    }

    fn line(&mut self, words: &str) {
        if !words.is_empty() {
            let _ = writeln!(self.out, "{words}");
        }
    }

    /// Writes the comments of a block, each on a separate line.
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

    /// Writes the comments in an ignored part of the text.
    fn comments_between(&mut self, part: Range<usize>) {
        let mut parser = Parser::resume(&self.text[..part.end], Resume::inside(part.start as u32, 0));
        let mut block = Block::default();
        while parser.next_block(&mut block) {
            self.comments(&block);
        }
    }

    /// Writes a motion as a block.
    fn motion(&mut self, motion: &Motion) {
        if let Some(seconds) = motion.seconds {
            let _ = writeln!(self.out, "G04 X{}", decimal(seconds));
            return;
        }
        let code = self.code_of(motion).unwrap_or("G00");
        let from = if motion.process.uncertain { motion.from } else { Point::default() };
        let (x, z) = if motion.process.uncertain { ('U', 'W') } else { ('X', 'Z') };
        // The way between rounded ends, so that the rounding of many moves does not add up.
        let way = |to: f64, from: f64| decimal(thousandth(to) - thousandth(from));
        let diameter = |radius: f64| Diameter::from_radius(radius).mm();
        let (along_x, along_z) = (way(diameter(motion.to.x), diameter(from.x)), way(motion.to.z, from.z));
        let _ = write!(self.out, "{code} {x}{along_x} {z}{along_z}");
        if let Some(rotary) = motion.rotary {
            let _ = match self.turns_by_way {
                // H makes C an axis; without M45, C in a cut is a chamfer.
                true => write!(self.out, " H{}", decimal(rotary.to - rotary.from)),
                false => write!(self.out, " C{}", decimal(rotary.to)),
            };
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
            self.lead = None;
        }
        if motion.start_angle != 0.0 {
            let _ = write!(self.out, " Q{:.0}", 1000.0 * motion.start_angle);
        }
        self.out.push('\n');
        self.written = match motion.kind {
            MotionKind::Rapid | MotionKind::Dwell => MotionMode::Rapid,
            MotionKind::Feed => MotionMode::Line,
            MotionKind::ArcClockwise => MotionMode::Arc(Turn::Clockwise),
            MotionKind::ArcCounterclockwise => MotionMode::Arc(Turn::Counterclockwise),
            MotionKind::Thread => MotionMode::Thread,
        };
    }

    /// The G code of a mode of group 01; `None` for cycles, which need more than their code.
    fn code_of_mode(&self, mode: MotionMode) -> Option<&'static str> {
        Some(match mode {
            MotionMode::Rapid => "G00",
            MotionMode::Line => "G01",
            MotionMode::Arc(Turn::Clockwise) => "G02",
            MotionMode::Arc(Turn::Counterclockwise) => "G03",
            MotionMode::Thread if matches!(self.list, CodeList::B | CodeList::C) => "G33",
            MotionMode::Thread => "G32",
            MotionMode::VariableThread => "G34",
            MotionMode::Tapping => "G33",
            MotionMode::Cycle(_) => return None,
        })
    }

    /// The code of group 01 for a motion; `None` if there is none.
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

/// Whether a block makes an uncertain motion.
fn is_uncertain(own: &Range<usize>, motions: &Motions) -> bool {
    own.clone().any(|index| motions.get(index).process.uncertain)
}

/// The G code of a word.
fn code(word: &Word, list: CodeList) -> Option<G> {
    let Value::Number { number, .. } = word.value else { return None };
    let tenths = number.tenths().filter(|_| word.address == b'G')?;
    codes::g_code(tenths, list).map(|found| found.code)
}

/// The sequence number of a block as typed, followed by a blank.
fn sequence_as_written(text: &[u8], block: &Block) -> String {
    let quoted = block.span.quote(text);
    let from = quoted.find(['N', 'n']).unwrap_or(0);
    let digits: String = quoted[from + 1..].trim_start().chars().take_while(char::is_ascii_digit).collect();
    format!("N{digits} ")
}

/// The F of a motion; for a thread, its lead.
fn feed_of(motion: &Motion) -> Option<f64> {
    match (motion.kind, motion.lead, motion.process.feed) {
        (MotionKind::Thread, Some(lead), _) => Some(lead),
        (_, _, Feed::PerMinute(feed) | Feed::PerTurn(feed)) => Some(feed),
        (_, _, Feed::Unset) => None,
    }
}

/// A length rounded to a thousandth.
fn thousandth(value: f64) -> f64 {
    (1000.0 * value).round() / 1000.0
}

/// A length with a decimal point, to a thousandth: `20.`, `-0.5`.
fn decimal(value: f64) -> String {
    trimmed(format!("{value:.3}"))
}

/// A speed; without a decimal point if it is a whole number.
fn whole(value: f64) -> String {
    trimmed(format!("{value:.5}")).trim_end_matches('.').to_owned()
}

/// A number to a hundred-thousandth, for feeds and leads.
fn fine_decimal(value: f64) -> String {
    trimmed(format!("{value:.5}"))
}

fn trimmed(text: String) -> String {
    let text = text.trim_end_matches('0').to_owned();
    if text == "-0." { "0.".into() } else { text }
}
