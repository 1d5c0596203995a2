//! Where the program continues: subprograms (M97, M98, M99) and their limits.
//!
//! In: the words of a block and its position. Out: the position of the next block.

use super::request::CallCode;
use super::{BlockPosition, Flow, Interpreter};
use crate::control::modal::MACROS;
use crate::control::program::{Call, CallKind, program_and_repeats};
use crate::control::words::{Words, plain, quote};
use crate::message::{Diagnostic, said};
use crate::parts::early;
use crate::source::Span;
use crate::text::block::{Block, Word};
use crate::text::parser::Resume;

early! {
    fn changes_in_next_pass(control: &mut Interpreter, text: &[u8], block: &Block, from: Option<Resume>) -> bool {
        control.begin_next_pass(text, block, from.map(|from| from.byte))
    }
}

impl Interpreter {
    /// Counts blocks executed in jumps, loops and calls. False: the limit is exceeded, and the run ends here.
    #[inline]
    pub(super) fn count_block(&mut self, block: &Block) -> bool {
        if self.state.call_stack.calls.is_empty() && self.program.is_first_reading(block.span.start) {
            return true;
        }
        self.count_repeat(block, block)
    }

    /// M97, M98, M99.
    #[inline(never)]
    pub(super) fn carry_out_call(
        &mut self,
        text: &[u8],
        block: &Block,
        words: &Words,
        call_code: CallCode,
        here: BlockPosition,
    ) -> Flow {
        match call_code {
            CallCode::Return => self.go_back(text, block, words),
            CallCode::Call | CallCode::LocalCall => {
                let named = words.get(b'P').and_then(plain).filter(|&number| number >= 1.0);
                let Some(named) = named.map(|number| number as u64) else {
                    // Only Haas calls with M97, and always with P; on other machines M97 is a
                    // machine-specific code.
                    let is_m97 = |word: &&Word| word.address == b'M' && plain(word) == Some(97.0);
                    let of_machine = call_code == CallCode::LocalCall && words.get(b'P').is_none();
                    if let Some(word) = block.words.iter().find(is_m97).filter(|_| of_machine) {
                        let word_text = quote(text, word.span);
                        self.report(Diagnostic::new(said::UnknownM { word: word_text }, word.span));
                        return Flow::Next;
                    }
                    let code = if call_code == CallCode::Call { "M98" } else { "M97" };
                    self.report(Diagnostic::new(said::CallNoNumber { code }, block.words_span()));
                    self.doubt_after_missing_program();
                    return Flow::Next;
                };
                if ![b'P', b'Q', b'L']
                    .into_iter()
                    .all(|address| words.get(address).is_none_or(|word| self.is_whole(text, word)))
                {
                    self.doubt_after_missing_program();
                    return Flow::Next;
                }
                let repeats = words.get(b'L').and_then(plain).map(|repeats| repeats as u32);
                let (head, packed) = if call_code == CallCode::LocalCall {
                    let Some(head) = self.sequence(text, block, named as u32) else {
                        self.sequence_not_found(named as u32, words.span(b'P'));
                        return Flow::Next;
                    };
                    (head, 1)
                } else {
                    let (Some(head), packed) = self.subprogram(text, named) else {
                        let word = words.quote(text, b'P');
                        self.report(Diagnostic::new(said::ProgramNotFound { word }, words.span(b'P')));
                        self.doubt_after_missing_program();
                        return Flow::Next;
                    };
                    // Q: the block in the subprogram with that number.
                    let begin = words.get(b'Q').and_then(plain).map(|sequence| sequence as u32);
                    match begin.map(|begin| (begin, self.program.labels(text).find(begin, head.byte))) {
                        Some((begin, None)) => {
                            self.sequence_not_found(begin, words.span(b'Q'));
                            return Flow::Next;
                        }
                        Some((_, Some(begin))) => (begin, packed),
                        None => (head, packed),
                    }
                };
                match repeats.unwrap_or(packed) {
                    0 => Flow::Next,
                    rounds => self.call(block, CallKind::Subprogram, head, here.next, rounds),
                }
            }
        }
    }

    /// The head of a subprogram, and the repeats that are packed into the number.
    fn subprogram(&mut self, text: &[u8], named: u64) -> (Option<Resume>, u32) {
        let labels = self.program.labels(text);
        let whole = u32::try_from(named).ok().and_then(|number| labels.program(number));
        let (number, repeats) = program_and_repeats(named);
        match whole {
            Some(head) => (Some(head), 1),
            None => (labels.program(number), repeats),
        }
    }

    /// The block with a sequence number in the program of `block`.
    pub(super) fn sequence(&mut self, text: &[u8], block: &Block, sequence: u32) -> Option<Resume> {
        self.program.labels(text).find(sequence, block.span.start)
    }

    /// Calls a subprogram or macro, unless too many calls are active (PS0077, PS0122).
    pub(super) fn call(
        &mut self,
        block: &Block,
        kind: CallKind,
        head: Resume,
        back: Resume,
        rounds: u32,
    ) -> Flow {
        let macros = self.state.call_stack.macros();
        let (depth, most) = match kind {
            CallKind::Macro => (macros, self.setup.limits.macro_depth),
            CallKind::Subprogram => {
                (self.state.call_stack.calls.len() - macros, self.setup.limits.call_depth)
            }
        };
        if depth >= most {
            let alarm = if kind == CallKind::Macro { "PS0122" } else { "PS0077" };
            // The control stops here; continuing would only call again.
            self.sink.end(said::CallTooDeep { most, alarm }.into(), block.words_span());
            return Flow::End;
        }
        let caller = block.span.start;
        let call = Call { kind, head, back, caller, rounds, loops: Vec::new() };
        self.state.call_stack.calls.push(call);
        self.program.jump_by(block.words_span());
        Flow::Jump(head)
    }

    /// M99: returns to the caller, or to the head of the main program.
    fn go_back(&mut self, text: &[u8], block: &Block, words: &Words) -> Flow {
        let named = words.get(b'P').and_then(plain).map(|number| number as u32);
        let Some(call) = self.state.call_stack.calls.last_mut() else {
            let behind = |at: &Resume| at.byte > block.span.start;
            return match named.map(|sequence| (sequence, self.sequence(text, block, sequence))) {
                // A sequence number further on is an ordinary jump, unless this program is a subprogram: then
                // the number is in its caller.
                Some((sequence, at))
                    if at.as_ref().map_or_else(|| self.top_level_caller(text, block).is_none(), behind) =>
                {
                    self.go_to(text, block, sequence, words.span(b'P'))
                }
                named => self.repeat_main(text, block, named.and_then(|(_, at)| at)),
            };
        };
        if named.is_none() && call.rounds > 1 {
            call.rounds -= 1;
            call.loops.clear();
            let head = call.head;
            return if self.count_round(block) { Flow::Jump(head) } else { Flow::End };
        }
        let (caller, back) = (call.caller, call.back);
        self.leave_call();
        let Some(sequence) = named else { return Flow::Jump(back) };
        match self.program.labels(text).find(sequence, caller) {
            Some(at) => Flow::Jump(at),
            None => {
                self.sequence_not_found(sequence, words.span(b'P'));
                Flow::Jump(back)
            }
        }
    }

    /// Ends the innermost call.
    fn leave_call(&mut self) {
        if self.state.call_stack.calls.pop().is_some_and(|call| call.kind == CallKind::Macro) {
            if let Some(recorder) = &mut self.recorder {
                recorder.macro_returned(self.state.variables.level());
            }
            self.state.variables.pop_level();
        }
    }

    /// The end of a subprogram without M99: a control stops; here the caller continues.
    pub fn end_without_return(&mut self, span: Span) -> Option<Resume> {
        let back = self.state.call_stack.calls.last()?.back;
        self.report(Diagnostic::new(said::NoReturn, span));
        self.leave_call();
        Some(back)
    }

    /// Continues at a sequence number of the same program (M99 P in the main program, GOTO).
    pub(super) fn go_to(&mut self, text: &[u8], block: &Block, sequence: u32, span: Span) -> Flow {
        match self.sequence(text, block, sequence) {
            Some(at) => {
                self.program.jump_by(block.words_span());
                Flow::Jump(at)
            }
            None => {
                self.sequence_not_found(sequence, span);
                Flow::Next
            }
        }
    }

    fn sequence_not_found(&mut self, sequence: u32, span: Span) {
        self.report(Diagnostic::new(said::SequenceNotFound { sequence }, span));
        self.doubt_after_missing_program();
    }

    /// The program that calls the program of `block`, if the run began with the latter only because it is
    /// first in the text.
    fn top_level_caller(&mut self, text: &[u8], block: &Block) -> Option<Resume> {
        // If the run began elsewhere, the setup or this search has already chosen the program.
        if self.program.started_at_other_program {
            return None;
        }
        let labels = self.program.labels(text);
        labels.number_at(block.span.start).and_then(|own| labels.top_level_caller(own))
    }

    /// M99 in the main program: repeats it from its head, or from the block in P, endlessly.
    fn repeat_main(&mut self, text: &[u8], block: &Block, from: Option<Resume>) -> Flow {
        if let Some(main) = self.top_level_caller(text, block) {
            return Flow::Restart(main);
        }
        if self.state.variables.has_unknown_arguments() {
            // The body of a macro returns to its caller, which is not in the text.
            return Flow::End;
        }
        // Without macros no pass reads a variable.
        if !MACROS.is_loaded() || !changes_in_next_pass(self, text, block, from) {
            self.report_always(Diagnostic::new(said::EndlessMain, block.words_span()));
            return Flow::End;
        }
        self.program.jump_by(block.words_span());
        Flow::Jump(from.unwrap_or(self.state.call_stack.head))
    }
}
