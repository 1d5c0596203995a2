//! Macro statements, values from variables, and macro calls (G65, G66, G67) as blocks use them.
//!
//! In: the text of a block. Out: its effect on the variables, the words with their values, and where the
//! program continues. `control::macros` evaluates; this file has jumps, loops, calls and messages.

use super::calls::Here;
use super::store::Store;
use super::{Flow, Interpreter, shortened};
use crate::control::codes::{self, MacroCall};
use crate::control::doubt::Doubt;
use crate::control::events::Event;
use crate::control::macros::{self, Action, Knowledge, Locals, MacroError, MacroErrorKind, Stored};
use crate::control::modal::MACROS;
use crate::control::program::{CallKind, Loop, ModalCall, Rounds};
use crate::control::words::{plain, quote};
use crate::limits::LOOPS;
use crate::message::{Diagnostic, Fix, said};
use crate::parts::early;
use crate::setup::TriedValue;
use crate::setup::dialect::Control;
use crate::source::Span;
use crate::text::block::{Block, BlockKind, Value, Word};
use crate::text::lexer::Number;
use crate::text::parser::{Parser, Resume};
use crate::units::Unit;

early! {
    fn macro_statement(control: &mut Interpreter, text: &[u8], block: &Block, here: Here) -> Flow {
        control.statement(text, block, here)
    }

    fn words_of(control: &mut Interpreter, text: &[u8], block: &Block, here: Here) -> Flow {
        control.words_with_expressions(text, block, here)
    }

    fn macro_call(control: &mut Interpreter, text: &[u8], block: &Block, here: Here, call: MacroCall) -> Flow {
        control.call_of_macro(text, block, here, call)
    }

    fn modal_call(control: &mut Interpreter, block: &Block, back: Resume) -> Option<Flow> {
        control.call_of_modal_macro(block, back)
    }

    fn give(control: &mut Interpreter, tried: TriedValue) {
        control.give_tried(tried);
    }
}

/// Result of a statement.
pub(super) enum Evaluated {
    /// The action to carry out.
    Action(Action),
    /// Finished; the program continues here.
    Flow(Flow),
    /// The statement cannot be carried out.
    Fault(MacroError),
}

impl Interpreter {
    /// Carries out a macro statement.
    #[cold]
    pub(super) fn macro_statement(&mut self, text: &[u8], block: &Block, here: Here) -> Flow {
        if self.has(MACROS) { macro_statement(self, text, block, here) } else { Flow::Next }
    }

    /// Assigns a value that the user tries out, as if its block had assigned it; ignored if the variable
    /// cannot be written.
    pub fn give(&mut self, tried: TriedValue) {
        if self.has(MACROS) {
            give(self, tried);
        }
    }

    fn give_tried(&mut self, TriedValue { block, variable, value, .. }: TriedValue) {
        let variables = &mut self.state.variables;
        if variables.write(variable, Some(value)) == Ok(Stored::Done) {
            variables.set_unknown(variable, Knowledge::Known);
            let level = variables.level();
            self.note_access(block, variable, None);
            self.note_assigned(level, variable, block);
        }
    }

    /// Evaluates the statement of a block. Unknown values are handled here.
    pub(super) fn evaluate(&mut self, text: &[u8], block: &Block, statement: &[u8], here: Here) -> Evaluated {
        let mut store = Store::new(self, text, block);
        let outcome = macros::statement(statement, &mut store);
        let unknown = store.knowledge == Knowledge::Unknown;
        match outcome {
            Err(fault) if unknown && fault.kind.depends_on_values() => {
                Evaluated::Flow(self.unknown_statement(text, block, statement, here))
            }
            Ok(Action::Goto(_) | Action::While { .. }) if unknown => {
                Evaluated::Flow(self.unknown_statement(text, block, statement, here))
            }
            // The macro checks its arguments with an alarm; they are unknown here.
            Ok(Action::Alarm { .. }) if self.state.variables.lacks_arguments() => {
                self.lose_program();
                Evaluated::Flow(Flow::Next)
            }
            Ok(action) => {
                if unknown {
                    self.unknown_condition(text, block, statement);
                }
                Evaluated::Action(action)
            }
            Err(fault) => {
                self.lose_statement(statement);
                Evaluated::Fault(fault)
            }
        }
    }

    fn statement(&mut self, text: &[u8], block: &Block, here: Here) -> Flow {
        if let Some(word) = block.words.first() {
            self.report_macro(MacroErrorKind::WordsBehind, word.span.to(block.span));
            self.lose_statement(block.span.of(text));
            return Flow::Next;
        }
        if !self.count_macro_step(block) {
            return Flow::End;
        }
        let span = statement_span(block);
        let statement = span.of(text);
        let action = match self.evaluate(text, block, statement, here) {
            Evaluated::Action(action) => action,
            Evaluated::Flow(flow) => return flow,
            Evaluated::Fault(fault) => {
                self.faulty_statement(text, block, here, &fault);
                return Flow::Next;
            }
        };
        let within = |range: std::ops::Range<usize>| Span {
            start: span.start + range.start as u32,
            end: span.start + range.end as u32,
        };
        match action {
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
                match self.behind_end(text, block, number, here) {
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
                    self.lose_program();
                    return Flow::Next;
                }
                own.span = block.span;
                self.report_faults(&own);
                match own.is_broken() {
                    true => self.trace_fault(),
                    false if self.trace.is_some() => self.trace_values(&own, &[]),
                    false => {}
                }
                self.words_of(text, &own, here)
            }
        }
    }

    /// Handles a faulty statement. If it begins a loop, the loop runs once, so that its END needs no separate
    /// message.
    fn faulty_statement(&mut self, text: &[u8], block: &Block, here: Here, fault: &MacroError) {
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

    /// Begins a loop whose condition cannot be evaluated: it runs once.
    pub(super) fn run_once(&mut self, number: u32, here: Here) {
        self.leave_loop(here);
        self.open_loop(Loop { number, head: here.at, rounds: Rounds::One });
    }

    /// Index of the active loop that ends in this block.
    fn loop_that_ends(&mut self, here: Here) -> Option<usize> {
        let ends = &self.program.loop_ends;
        let is_own = |own: &Loop| {
            ends.get(&own.head.byte).copied().flatten().is_some_and(|end| end.byte == here.next.byte)
        };
        self.state.call_stack.loops().iter().rposition(is_own)
    }

    fn report_fault(&mut self, text: &[u8], fault: &MacroError, within: Span) {
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
        self.left_out();
    }

    /// DO: begins a loop, or its next round.
    fn begin_loop(&mut self, text: &[u8], block: &Block, number: u32, here: Here) -> Flow {
        let head = here.at;
        if self.behind_end(text, block, number, here).is_none() {
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
                self.lose_program();
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
        if loops.len() < LOOPS {
            loops.push(own);
        }
    }

    fn leave_loop(&mut self, here: Here) {
        let loops = self.state.call_stack.loops();
        if let Some(old) = loops.iter().position(|own| own.head.byte == here.at.byte) {
            loops.truncate(old);
        }
    }

    /// END: returns to the beginning of the loop.
    fn end_loop(&mut self, block: &Block, here: Here) -> Flow {
        let Some(old) = self.loop_that_ends(here) else {
            // The END of a DO that was reported as missing: its number is wrong.
            if !self.program.lacks_end {
                self.report_macro(MacroErrorKind::LoopNumber, block.words_span());
                self.lose_program();
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
    pub(super) fn behind_end(
        &mut self,
        text: &[u8],
        block: &Block,
        number: u32,
        here: Here,
    ) -> Option<Resume> {
        let found = self.end_of_loop(text, block, number, here);
        if found.is_none() && !self.sink.is_full() {
            self.report_macro(MacroErrorKind::EndMissing, block.words_span());
            self.lose_program();
        }
        found
    }

    /// The block after the END of a loop that begins here; cached. The search also records the ends of the
    /// nested loops it passes.
    fn end_of_loop(&mut self, text: &[u8], block: &Block, number: u32, here: Here) -> Option<Resume> {
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

    /// Carries out a block of words, some of which may have expressions as values.
    #[inline]
    pub(super) fn words_of(&mut self, text: &[u8], block: &Block, here: Here) -> Flow {
        if !block.has_expressions {
            return self.words(text, block, here);
        }
        if self.has(MACROS) { words_of(self, text, block, here) } else { Flow::Next }
    }

    fn words_with_expressions(&mut self, text: &[u8], block: &Block, here: Here) -> Flow {
        if let Some(operation) = self.macro_a_of(text, block).filter(|_| !block.is_broken()) {
            return self.macro_a(text, block, here, operation);
        }
        self.guessing = false;
        let own = self.evaluated(text, block);
        if std::mem::take(&mut self.guessing) && !self.sink.muted {
            // Messages about such values do not apply to the macro.
            self.sink.muted = true;
            let flow = self.evaluated_words(text, block, own, here);
            self.sink.muted = false;
            return flow;
        }
        self.evaluated_words(text, block, own, here)
    }

    /// Carries out a block with the values of its expressions. `None`: an expression has no value, which was
    /// reported.
    fn evaluated_words(&mut self, text: &[u8], block: &Block, own: Option<Block>, here: Here) -> Flow {
        match own {
            Some(own) => {
                if self.trace.is_some() {
                    self.trace_values(&own, &block.words);
                }
                if !self.state.doubts.has(Doubt::Values) {
                    return self.words(text, &own, here);
                }
                // Values from variables are as doubtful as the variables.
                let doubtful = Self::from_variables(block);
                self.lose(doubtful);
                let flow = self.words(text, &own, here);
                self.lose(doubtful);
                flow
            }
            None => {
                self.trace_nothing();
                self.lose(Self::from_variables(block));
                if self.sink.is_full() { Flow::End } else { Flow::Next }
            }
        }
    }

    /// The block with values in place of expressions; words with a vacant variable are left out. `None`: an
    /// error was reported.
    #[cold]
    pub(super) fn evaluated(&mut self, text: &[u8], block: &Block) -> Option<Block> {
        let mut own = block.clone();
        own.has_expressions = false;
        own.words.clear();
        let mut handed_over = false;
        for word in &block.words {
            if word.value != Value::Expression {
                own.words.push(*word);
                handed_over |= codes::calls_macro(word);
                continue;
            }
            if matches!(word.address, b'N' | b'O') && !handed_over {
                let message = said::NumberFromVariable { word: quote(text, word.span) };
                self.report(Diagnostic::new(message, word.span));
                return None;
            }
            // Arguments of a macro keep all digits.
            let places =
                (!handed_over || matches!(word.address, b'P' | b'L')).then(|| self.places(word.address));
            let (number, negative) = self.value_of(text, block, word, places)?;
            if number.is_none() && !handed_over && !self.guessing {
                self.observe(text, Event::VacantWord { word });
            }
            let value = number.map(|number| Word { value: Value::Number { number, negative }, ..*word });
            handed_over |= value.as_ref().is_some_and(codes::calls_macro);
            own.words.extend(value);
        }
        Some(own)
    }

    /// The value of a word's expression, rounded to `places` decimals if given. The outer `None`: an error
    /// was reported.
    fn value_of(
        &mut self,
        text: &[u8],
        block: &Block,
        word: &Word,
        places: Option<u8>,
    ) -> Option<(Option<Number>, bool)> {
        if !self.count_macro_step(block) {
            return None;
        }
        // The letter, with an optional comma and blanks, comes before the expression.
        let written = word.span.of(text);
        let letter = written.iter().position(u8::is_ascii_alphabetic).unwrap_or(0) + 1;
        let increment = 10f64.powi(-i32::from(self.places(word.address)));
        let mut store = Store::new(self, text, block);
        let value = macros::address_value(&written[letter..], increment, &mut store);
        if store.knowledge == Knowledge::Unknown {
            self.guessing = true;
        }
        match value {
            Err(fault) if self.guessing && fault.kind.depends_on_values() => {
                self.left_out();
                None
            }
            Ok(None) => Some((None, false)),
            Ok(Some(value)) => match number_of(value, places.unwrap_or_else(|| places_of(value))) {
                Some(number) => Some((Some(number), value < 0.0)),
                None => {
                    let (word, word_span) = (quote(text, word.span), word.span);
                    self.report(Diagnostic::new(said::TooManyDigits { word }, word_span));
                    None
                }
            },
            Err(fault) => {
                let start = word.span.start + letter as u32;
                self.report_fault(text, &fault, Span { start, end: word.span.end });
                None
            }
        }
    }

    /// Number of decimals of an address.
    fn places(&self, address: u8) -> u8 {
        match address {
            b'M' | b'S' | b'T' | b'N' | b'O' | b'L' => 0,
            b'P' | b'Q' if self.dialect.control != Control::Forum => 0,
            b'G' => 1,
            b'F' | b'E' => 6,
            _ => match self.state.unit {
                Unit::Millimetre => 3,
                Unit::Inch => 4,
            },
        }
    }

    /// G65: calls a macro with arguments. G66: calls it after every block with a move, until G67.
    pub(super) fn macro_call(&mut self, text: &[u8], block: &Block, here: Here, call: MacroCall) -> Flow {
        if self.has(MACROS) { macro_call(self, text, block, here, call) } else { Flow::Next }
    }

    fn call_of_macro(&mut self, text: &[u8], block: &Block, here: Here, call: MacroCall) -> Flow {
        if let Some(operation) = self.macro_a_of(text, block) {
            return self.macro_a(text, block, here, operation);
        }
        let value = |word: &&Word| plain(word);
        let find = |address: u8| block.words.iter().find(|word| word.address == address);
        let Some(number) = find(b'P').as_ref().and_then(value).filter(|&number| number >= 1.0) else {
            self.report(Diagnostic::new(said::CallNoNumber { code: call.code() }, block.words_span()));
            self.lose_program();
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
                self.lose_program();
                return Flow::Next;
            }
        };
        let head =
            u32::try_from(number as u64).ok().and_then(|number| self.program.labels(text).program(number));
        let Some(head) = head else {
            let word = find(b'P').map_or(String::new(), |word| quote(text, word.span));
            let span = find(b'P').map_or(block.words_span(), |word| word.span);
            self.report(Diagnostic::new(said::ProgramNotFound { word }, span));
            self.lose_program();
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
fn statement_span(block: &Block) -> Span {
    Span { start: block.statement, end: block.span.end }
}

/// Number of decimals that keeps all significant digits of a double.
fn places_of(value: f64) -> u8 {
    const DIGITS: f64 = 15.0;
    crate::geometry::within(DIGITS - value.abs().max(1.0).log10().ceil(), 0.0, DIGITS) as u8
}

/// A value as a number with `places` decimals; `None` if it is too large for any address.
fn number_of(value: f64, places: u8) -> Option<Number> {
    const LARGEST: f64 = 99_999_999.0;
    if value.is_nan() || value.abs() > LARGEST {
        return None;
    }
    let mantissa = (value.abs() * 10f64.powi(i32::from(places))).round() as u64;
    // A value never counts least increments: it has a point if the address allows one.
    Some(Number { mantissa, decimals: places, digits: 8, points: u8::from(places > 0) })
}
