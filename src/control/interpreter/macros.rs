//! Macro statements, values from variables, and macro calls (G65, G66, G67) as blocks use them.
//!
//! In: the text of a block. Out: its effect on the variables, the words with their values, and where the
//! program continues. `control::macros` evaluates; this file has jumps, loops, calls and messages.

use super::core::shortened;
use super::loops::{Mark, loop_mark, statement_span};
use super::macro_values::Evaluated;
use super::{BlockPosition, Flow, Interpreter};
use crate::control::codes::{self, MacroCall};
use crate::control::events::Event;
use crate::control::macros::{self, Action, Knowledge, Locals, MacroError, MacroErrorKind, Stored};
use crate::control::modal::MACROS;
use crate::control::program::{CallKind, ModalCall, Rounds};
use crate::control::words::{plain, quote};
use crate::message::{Diagnostic, said};
use crate::parts::early;
use crate::setup::TriedValue;
use crate::source::Span;
use crate::text::block::{Block, BlockKind, Word};
use crate::text::parser::{Parser, Resume};

early! {
    fn macro_statement(control: &mut Interpreter, text: &[u8], block: &Block, here: BlockPosition) -> Statement {
        control.statement(text, block, here)
    }

    fn macro_call(control: &mut Interpreter, text: &[u8], block: &Block, here: BlockPosition, call: MacroCall) -> Flow {
        control.call_of_macro(text, block, here, call)
    }

    fn modal_call(control: &mut Interpreter, block: &Block, back: Resume) -> Option<Flow> {
        control.call_of_modal_macro(block, back)
    }

    fn set_tried_value(control: &mut Interpreter, tried: TriedValue) {
        control.assign_tried_value(tried);
    }
}

/// What is left to do after a statement.
pub(super) enum Statement {
    /// Nothing; the program continues here.
    Done(Flow),
    /// The block that IF runs.
    Words(Block),
}

impl From<Flow> for Statement {
    fn from(flow: Flow) -> Self {
        Self::Done(flow)
    }
}

impl Interpreter {
    /// Carries out a macro statement.
    #[cold]
    pub(super) fn macro_statement(&mut self, text: &[u8], block: &Block, here: BlockPosition) -> Statement {
        if self.has(MACROS) { macro_statement(self, text, block, here) } else { Statement::Done(Flow::Next) }
    }

    /// Assigns a value that the user tries out, as if its block had assigned it; ignored if the variable
    /// cannot be written.
    pub fn set_tried_value(&mut self, tried: TriedValue) {
        if self.has(MACROS) {
            set_tried_value(self, tried);
        }
    }

    fn assign_tried_value(&mut self, TriedValue { block, variable, value, .. }: TriedValue) {
        let variables = &mut self.state.variables;
        if variables.write(variable, Some(value)) == Ok(Stored::Done) {
            variables.set_unknown(variable, Knowledge::Known);
            let level = variables.level();
            self.note_access(block, variable, None);
            self.note_assigned(level, variable, block);
        }
    }

    fn statement(&mut self, text: &[u8], block: &Block, here: BlockPosition) -> Statement {
        if let Some(word) = block.words.first() {
            self.report_macro(MacroErrorKind::WordsBehind, word.span.to(block.span));
            self.doubt_statement(block.span.of(text));
            return Flow::Next.into();
        }
        if !self.count_macro_step(block) {
            return Flow::End.into();
        }
        let span = statement_span(block);
        let statement = span.of(text);
        let action = match self.evaluate(text, block, statement, here) {
            Evaluated::Action(action) => action,
            Evaluated::Flow(flow) => return flow.into(),
            Evaluated::Fault(fault) => {
                self.faulty_statement(text, block, here, &fault);
                return Flow::Next.into();
            }
        };
        let within = |range: std::ops::Range<usize>| Span {
            start: span.start + range.start as u32,
            end: span.start + range.end as u32,
        };
        let flow = match action {
            Action::Done | Action::Print | Action::Pause { .. } => Flow::Next,
            Action::Goto(sequence) => self.go_to(text, block, sequence, block.words_span()),
            Action::Alarm { number, message } => {
                let words = within(message);
                let end = block.statement_end.max(if words.is_empty() { 0 } else { words.end + 1 });
                let (words, span) = (shortened(&words.quote(text)), Span { end: end.min(span.end), ..span });
                // The number that a control displays.
                let number = number.saturating_add(3000);
                self.report_always(Diagnostic::new(said::MacroAlarm { number, words }, span));
                Flow::End
            }
            Action::While { number, enter: true } | Action::Do { number } => {
                self.begin_loop(text, block, number, here)
            }
            Action::While { number, enter: false } => {
                self.observe(text, Event::While { statement: block.words_span(), enter: false });
                self.leave_loop(here);
                match self.block_after_end(text, block, number, here) {
                    Some(behind) => {
                        self.program.skip_loop();
                        Flow::Jump(behind)
                    }
                    None if self.sink.is_full() => Flow::End,
                    None => Flow::Next,
                }
            }
            Action::End { .. } => self.end_loop(block, here),
            Action::Words(range) => {
                let words = within(range);
                let mut parser =
                    Parser::resume(&text[..words.end as usize], Resume::inside(words.start, block.line));
                let mut own = Block::default();
                parser.next_block(&mut own);
                if own.kind != BlockKind::Words || parser.position().byte < words.end {
                    self.report_macro(MacroErrorKind::Format, words);
                    self.doubt_after_missing_program();
                    return Flow::Next.into();
                }
                own.span = block.span;
                self.report_faults(&own);
                match own.is_broken() {
                    true => self.trace_fault(),
                    false if self.trace.is_some() => self.trace_values(&own, &[]),
                    false => {}
                }
                return Statement::Words(own);
            }
        };
        Statement::Done(flow)
    }

    /// Handles a faulty statement. If it begins a loop, the loop runs once, so that its END needs no separate
    /// message.
    fn faulty_statement(&mut self, text: &[u8], block: &Block, here: BlockPosition, fault: &MacroError) {
        let mark = loop_mark(text, block);
        if matches!(mark, Some((Mark::End, _)))
            && let Some(open) = self.loop_that_ends(here)
            && self.state.call_stack.loops()[open].rounds == Rounds::One
        {
            self.state.call_stack.loops().truncate(open);
            return;
        }
        self.report_fault(text, fault, statement_span(block));
        if let Some((Mark::Do, number)) = mark {
            self.end_of_loop(text, block, number, here);
            self.run_once(number, here);
        }
    }

    /// G65: calls a macro with arguments. G66: calls it after every block with a move, until G67.
    pub(super) fn macro_call(
        &mut self,
        text: &[u8],
        block: &Block,
        here: BlockPosition,
        call: MacroCall,
    ) -> Flow {
        if self.has(MACROS) { macro_call(self, text, block, here, call) } else { Flow::Next }
    }

    fn call_of_macro(&mut self, text: &[u8], block: &Block, here: BlockPosition, call: MacroCall) -> Flow {
        if let Some(operation) = self.macro_a_of(text, block) {
            return self.macro_a(text, block, here, operation);
        }
        let value = |word: &&Word| plain(word);
        let find = |address: u8| block.words.iter().find(|word| word.address == address);
        let Some(number) = find(b'P').as_ref().and_then(value).filter(|&number| number >= 1.0) else {
            self.report(Diagnostic::new(said::CallNoNumber { code: call.code() }, block.words_span()));
            self.doubt_after_missing_program();
            return Flow::Next;
        };
        let rounds = find(b'L').as_ref().and_then(value).map_or(1, |rounds| rounds as u32);
        let begin = block.words.iter().position(codes::calls_macro).map_or(0, |at| at + 1);
        let handed: Vec<&Word> = block.words[begin..]
            .iter()
            .filter(|word| !matches!(word.address, b'P' | b'L') && !word.comma)
            .collect();
        let values = handed.iter().filter_map(|word| Some((word.address, plain(word)?)));
        let arguments = match macros::arguments(values) {
            Ok(arguments) => arguments,
            Err(fault) => {
                let span = handed.get(fault.index).map_or(block.words_span(), |word| word.span);
                self.report_macro(fault.kind, span);
                self.doubt_after_missing_program();
                return Flow::Next;
            }
        };
        let head =
            u32::try_from(number as u64).ok().and_then(|number| self.program.labels(text).program(number));
        let Some(head) = head else {
            let word = find(b'P').map_or(String::new(), |word| quote(text, word.span));
            let span = find(b'P').map_or(block.words_span(), |word| word.span);
            self.report(Diagnostic::new(said::ProgramNotFound { word }, span));
            self.doubt_after_missing_program();
            return Flow::Next;
        };
        match call {
            MacroCall::Once => self.enter_macro(block, head, here.next, rounds, arguments),
            MacroCall::Modal => {
                self.state.call_stack.modal = Some(ModalCall { head, rounds, arguments });
                Flow::Next
            }
        }
    }

    /// Calls the macro of G66 after a block with a move.
    pub(super) fn modal_call(&mut self, block: &Block, back: Resume) -> Option<Flow> {
        if self.has(MACROS) { modal_call(self, block, back) } else { None }
    }

    fn call_of_modal_macro(&mut self, block: &Block, back: Resume) -> Option<Flow> {
        let modal = self.state.call_stack.modal.clone()?;
        // The moves of the macro do not call it again.
        if self.state.call_stack.calls.iter().any(|call| call.head == modal.head) {
            return None;
        }
        Some(self.enter_macro(block, modal.head, back, modal.rounds, modal.arguments))
    }

    fn enter_macro(
        &mut self,
        block: &Block,
        head: Resume,
        back: Resume,
        rounds: u32,
        arguments: Locals,
    ) -> Flow {
        if rounds == 0 {
            return Flow::Next;
        }
        let flow = self.call(block, CallKind::Macro, head, back, rounds);
        if matches!(flow, Flow::Jump(_)) {
            // A call at too deep a level was already reported.
            let given = (1..).zip(&arguments).filter(|(_, value)| value.is_some());
            for (variable, _) in given {
                self.note_assigned(self.state.variables.level() + 1, variable, block.span.start);
            }
            self.state.variables.push_level(arguments);
        }
        flow
    }
}
