//! The body of a macro that is run as a main program, without its arguments.
//!
//! In: vacant variables that are read, and statements that depend on them. Out: which variables have an
//! unknown value. One message reports this. An unknown value raises no alarm, and the results that depend on
//! it are uncertain.

use super::loops::{Mark, loop_mark};
use super::store::Store;
use super::{Flow, Here, Interpreter};
use crate::control::doubt::{Doubt, Doubts};
use crate::control::macros::{self, Knowledge};
use crate::control::words::plain;
use crate::message::{Diagnostic, said};
use crate::text::block::Block;
use crate::text::parser::Parser;

impl Interpreter {
    /// Called when a vacant variable that may be an argument is read. Reports it if the main program is the
    /// body of a macro.
    #[cold]
    pub(super) fn miss_arguments(&mut self, text: &[u8], block: &Block, variable: u32) {
        let is_own = self.state.variables.level() == 0 && !self.state.variables.lacks_arguments();
        if !is_own || !self.is_macro_body(text) {
            return;
        }
        self.state.variables.lack_arguments();
        self.report(Diagnostic::new(said::ArgumentsUnknown { variable }, block.words_span()));
        self.lose(Doubts::of(&[Doubt::Values]));
    }

    /// Whether the main program can only be the body of a macro: it returns with M99, and neither ends nor
    /// selects a tool. A program that a bar feeder repeats also ends with M99, but it selects tools.
    fn is_macro_body(&mut self, text: &[u8]) -> bool {
        if let Some(known) = self.program.is_macro_body {
            return known;
        }
        // The result depends on later blocks: with labels the run no longer counts as straight
        // (`Program::is_straight`).
        self.program.labels(text);
        let mut parser = Parser::resume(text, self.state.call_stack.head);
        let (mut block, mut begun, mut returns, mut is_main) = (Block::default(), false, false, false);
        while parser.next_block(&mut block) && !(begun && block.program.is_some()) {
            begun |= !block.is_empty();
            // `GOT0300` for GOTO300 selects no tool.
            let read = if block.is_broken() { &[] } else { &block.words[..] };
            for word in read {
                match (word.address, plain(word)) {
                    (b'M', Some(99.0)) => returns = true,
                    (b'M', Some(2.0 | 30.0)) | (b'T', _) => is_main = true,
                    _ => {}
                }
            }
        }
        *self.program.is_macro_body.insert(returns && !is_main)
    }

    /// A statement depends on an unknown value: it may have assigned a variable or jumped.
    #[cold]
    pub(super) fn unknown_condition(&mut self, text: &[u8], block: &Block, statement: &[u8]) {
        match macros::assigned(behind_condition(statement), &mut Store::new(self, text, block)) {
            Some(variable) => self.state.variables.set_unknown(variable, Knowledge::Unknown),
            None => self.lose_program(),
        }
    }

    /// A statement depends on an unknown value and has no value itself, or jumps: the program continues after
    /// it.
    #[cold]
    pub(super) fn unknown_statement(
        &mut self,
        text: &[u8],
        block: &Block,
        statement: &[u8],
        here: Here,
    ) -> Flow {
        self.unknown_condition(text, block, statement);
        if let Some((Mark::Do, number)) = loop_mark(text, block)
            && self.behind_end(text, block, number, here).is_some()
        {
            self.run_once(number, here);
        }
        Flow::Next
    }
}

/// The text after the condition of IF; the whole text of any other statement.
fn behind_condition(statement: &[u8]) -> &[u8] {
    let statement = statement.trim_ascii_start();
    if !statement.get(..2).is_some_and(|head| head.eq_ignore_ascii_case(b"IF")) {
        return statement;
    }
    let mut depth = 0;
    let closing = statement.iter().position(|byte| {
        depth += i32::from(*byte == b'[') - i32::from(*byte == b']');
        *byte == b']' && depth == 0
    });
    let rest = closing.map_or(&[][..], |closing| statement[closing + 1..].trim_ascii_start());
    match rest.get(..4) {
        Some(then) if then.eq_ignore_ascii_case(b"THEN") => rest[4..].trim_ascii_start(),
        _ => rest,
    }
}
