//! DO and END of macros: open loops, and where each of them ends.

use super::{BlockPosition, Flow, Interpreter};
use crate::control::events::Event;
use crate::control::macros::{MacroError, MacroErrorKind};
use crate::control::program::{Loop, Rounds};
use crate::limits::MAX_LOOPS;
use crate::message::{Diagnostic, Fix};
use crate::source::Span;
use crate::text::block::{Block, BlockKind};
use crate::text::parser::{Parser, Resume};

impl Interpreter {
    /// Begins a loop whose condition cannot be evaluated: it runs once.
    pub(super) fn run_once(&mut self, number: u32, here: BlockPosition) {
        self.leave_loop(here);
        self.open_loop(Loop { number, head: here.at, rounds: Rounds::One });
    }

    /// Index of the active loop that ends in this block.
    pub(super) fn loop_that_ends(&mut self, here: BlockPosition) -> Option<usize> {
        let ends = &self.program.loop_ends;
        let is_own = |own: &Loop| {
            ends.get(&own.head.byte).copied().flatten().is_some_and(|end| end.byte == here.next.byte)
        };
        self.state.call_stack.loops().iter().rposition(is_own)
    }

    pub(super) fn report_fault(&mut self, text: &[u8], fault: &MacroError, within: Span) {
        let at = |place: usize| within.start + place as u32;
        let span = Span { start: at(fault.at.start), end: at(fault.at.end) };
        self.report_macro_with(fault.kind, span, repair(text, fault.kind, within, span));
    }

    pub(super) fn report_macro(&mut self, kind: MacroErrorKind, span: Span) {
        self.report_macro_with(kind, span, None);
    }

    fn report_macro_with(&mut self, kind: MacroErrorKind, span: Span, fix: Option<Fix>) {
        self.trace_fault();
        let diagnostic = Diagnostic::new(kind.message(), span);
        self.report(Diagnostic { fixes: fix.into_iter().collect(), ..diagnostic });
        self.mark_left_out();
    }

    /// DO: begins a loop, or its next round.
    pub(super) fn begin_loop(
        &mut self,
        text: &[u8],
        block: &Block,
        number: u32,
        here: BlockPosition,
    ) -> Flow {
        let head = here.at;
        if self.block_after_end(text, block, number, here).is_none() {
            return if self.sink.is_full() { Flow::End } else { Flow::Next };
        }
        let loops = self.state.call_stack.loops();
        if let Some(own) = loops.iter().position(|own| own.head.byte == head.byte) {
            loops.truncate(own + 1);
            return Flow::Next;
        }
        if let Some(old) = loops.iter().rposition(|own| own.number == number) {
            let outer = loops[old].head.byte;
            let end = self.program.loop_ends.get(&outer).copied().flatten();
            if end.is_some_and(|end| outer < head.byte && head.byte < end.byte) {
                self.report_macro(MacroErrorKind::LoopNumber, block.words_span());
                self.doubt_after_missing_program();
            } else {
                // A jump out of the loop has left it open.
                self.state.call_stack.loops().truncate(old);
            }
        }
        self.observe(text, Event::While { statement: block.words_span(), enter: true });
        self.open_loop(Loop { number, head, rounds: Rounds::All });
        Flow::Next
    }

    /// Adds an active loop. Ignored at the limit: loop numbers have one digit, so a deeper loop was already
    /// reported as nested in itself.
    fn open_loop(&mut self, own: Loop) {
        let loops = self.state.call_stack.loops();
        if loops.len() < MAX_LOOPS {
            loops.push(own);
        }
    }

    pub(super) fn leave_loop(&mut self, here: BlockPosition) {
        let loops = self.state.call_stack.loops();
        if let Some(old) = loops.iter().position(|own| own.head.byte == here.at.byte) {
            loops.truncate(old);
        }
    }

    /// END: returns to the beginning of the loop.
    pub(super) fn end_loop(&mut self, block: &Block, here: BlockPosition) -> Flow {
        let Some(old) = self.loop_that_ends(here) else {
            // The END of a DO that was reported as missing: its number is wrong.
            if !self.program.lacks_end {
                self.report_macro(MacroErrorKind::LoopNumber, block.words_span());
                self.doubt_after_missing_program();
            }
            return Flow::Next;
        };
        let loops = self.state.call_stack.loops();
        let Loop { head, rounds, .. } = loops[old];
        if rounds == Rounds::One {
            loops.truncate(old);
            return Flow::Next;
        }
        loops.truncate(old + 1);
        self.program.jump_by(block.words_span());
        if self.count_round(block) { Flow::Jump(head) } else { Flow::End }
    }

    /// The block after the END of a loop that begins here. `None`: no END, reported (PS0124).
    pub(super) fn block_after_end(
        &mut self,
        text: &[u8],
        block: &Block,
        number: u32,
        here: BlockPosition,
    ) -> Option<Resume> {
        let found = self.end_of_loop(text, block, number, here);
        if found.is_none() && !self.sink.is_full() {
            self.report_macro(MacroErrorKind::EndMissing, block.words_span());
            self.doubt_after_missing_program();
        }
        found
    }

    /// The block after the END of a loop that begins here; cached. The search also records the ends of the
    /// nested loops it passes.
    pub(super) fn end_of_loop(
        &mut self,
        text: &[u8],
        block: &Block,
        number: u32,
        here: BlockPosition,
    ) -> Option<Resume> {
        if let Some(found) = self.program.loop_ends.get(&here.at.byte) {
            return *found;
        }
        let mut parser = Parser::resume(text, here.next);
        let mut other = Block::default();
        // First bytes of the open loops, by loop number, which is one digit.
        let mut open: [Vec<u32>; 10] = Default::default();
        open[number as usize].push(here.at.byte);
        loop {
            let at = parser.position();
            if !parser.next_block(&mut other) || other.program.is_some() {
                break;
            }
            if !self.count_repeat(&other, block) {
                return None;
            }
            match loop_mark(text, &other) {
                Some((Mark::Do, own)) => open[own as usize].push(at.byte),
                Some((Mark::End, own)) => {
                    let Some(head) = open[own as usize].pop() else { continue };
                    self.program.loop_ends.insert(head, Some(parser.position()));
                    if head == here.at.byte {
                        return Some(parser.position());
                    }
                }
                None => {}
            }
        }
        self.program.lacks_end = true;
        self.program.loop_ends.extend(open.into_iter().flatten().map(|head| (head, None)));
        None
    }
}

/// The role of a block in a loop.
pub(super) enum Mark {
    Do,
    End,
}

/// The loop mark of a macro statement, and its number: `DO m` at the end, or `END m` at the beginning.
pub(super) fn loop_mark(text: &[u8], block: &Block) -> Option<(Mark, u32)> {
    if block.kind != BlockKind::Macro {
        return None;
    }
    let statement = statement_span(block).of(text);
    let is =
        |head: &[u8], word: &[u8]| head.len() >= word.len() && head[..word.len()].eq_ignore_ascii_case(word);
    let number = |digits: &[u8]| {
        let digit = digits.iter().find(|byte| !byte.is_ascii_whitespace())?;
        digit.is_ascii_digit().then(|| u32::from(digit - b'0'))
    };
    if is(statement, b"END") {
        return Some((Mark::End, number(&statement[3..])?));
    }
    if !is(statement, b"WHILE") && !is(statement, b"DO") {
        return None;
    }
    let at = statement.windows(2).rposition(|pair| pair.eq_ignore_ascii_case(b"DO"))?;
    Some((Mark::Do, number(&statement[at + 2..])?))
}

/// A likely correction of a statement or expression with an error at `span`: a jump to a literal number, a
/// comparison by its letters, or square brackets instead of round ones.
fn repair(text: &[u8], kind: MacroErrorKind, within: Span, span: Span) -> Option<Fix> {
    const SIGNS: [(&str, &str); 7] =
        [("<>", "NE"), ("<=", "LE"), (">=", "GE"), ("==", "EQ"), ("=", "EQ"), (">", "GT"), ("<", "LT")];
    if kind == MacroErrorKind::JumpTarget {
        let written = span.quote(text);
        let digits = written.strip_prefix(['N', 'n', '#'])?.trim();
        let is_number = (1..=8).contains(&digits.len()) && digits.bytes().all(|byte| byte.is_ascii_digit());
        return is_number.then(|| Fix::write(span, digits.to_owned()));
    }
    if !matches!(kind, MacroErrorKind::Expression | MacroErrorKind::Format) {
        return None;
    }
    let rest = &text[span.start as usize..within.end as usize];
    let compares = [&b"IF"[..], b"WHILE"].iter().any(|word| {
        let head = within.of(text).get(..word.len());
        head.is_some_and(|head| head.eq_ignore_ascii_case(word))
    });
    if compares
        && let Some((sign, letters)) = SIGNS.iter().find(|(sign, _)| rest.starts_with(sign.as_bytes()))
    {
        let end = span.start + sign.len() as u32;
        let blank = |place: usize| text.get(place).is_none_or(|byte| *byte == b' ');
        let before = if blank(span.start as usize - 1) { "" } else { " " };
        let behind = if blank(end as usize) { "" } else { " " };
        return Some(Fix::write(Span { start: span.start, end }, format!("{before}{letters}{behind}")));
    }
    square_brackets(text, within)
}

/// Replaces round brackets that contain an expression, rather than a comment, by square ones.
fn square_brackets(text: &[u8], within: Span) -> Option<Fix> {
    let written = within.of(text);
    let mut meant = written.to_vec();
    let (mut at, mut is_sure) = (0, false);
    while let Some(found) = written[at..].iter().position(|&byte| byte == b'(') {
        let open = at + found;
        // The matching closing bracket.
        let mut depth = 0;
        let closes = |byte: &u8| {
            depth += i32::from(*byte == b'(') - i32::from(*byte == b')');
            depth == 0
        };
        let close = open + written[open..].iter().position(closes)?;
        let inside = &written[open + 1..close];
        let counts = inside.iter().any(u8::is_ascii_digit)
            && (inside.contains(&b'#') || !inside.iter().any(u8::is_ascii_alphabetic))
            && inside.iter().all(|byte| byte.is_ascii_alphanumeric() || b" #.+-*/,[]()".contains(byte));
        if counts {
            is_sure = true;
            let turned = |byte: &mut u8| match *byte {
                b'(' => *byte = b'[',
                b')' => *byte = b']',
                _ => {}
            };
            meant[open..=close].iter_mut().for_each(turned);
        }
        at = close + 1;
    }
    let meant = String::from_utf8(meant).ok().filter(|_| is_sure)?;
    let trimmed = meant.trim_end();
    let end = within.start + trimmed.len() as u32;
    Some(Fix::write(Span { end, ..within }, trimmed.to_owned()))
}

/// The macro statement of a block.
pub(super) fn statement_span(block: &Block) -> Span {
    Span { start: block.statement, end: block.span.end }
}
