//! The body of a macro that is run as a main program, without its arguments.
//!
//! In: vacant variables that are read, and statements that depend on them. Out: which variables have an
//! unknown value. One message reports this. An unknown value raises no alarm, and the results that depend on
//! it are uncertain.

use super::Interpreter;
use crate::control::doubt::{Doubt, Doubts};
use crate::control::words::plain;
use crate::message::{Diagnostic, said};
use crate::text::block::Block;
use crate::text::parser::Parser;

impl Interpreter {
    /// Called when a vacant variable that may be an argument is read. Reports it if the main program is the
    /// body of a macro.
    #[cold]
    pub(super) fn report_missing_arguments(&mut self, text: &[u8], block: &Block, variable: u32) {
        let is_own = self.state.variables.level() == 0 && !self.state.variables.has_unknown_arguments();
        if !is_own || !self.is_macro_body(text) {
            return;
        }
        self.state.variables.mark_arguments_unknown();
        self.report(Diagnostic::new(said::ArgumentsUnknown { variable }, block.words_span()));
        self.add_doubts(Doubts::of(&[Doubt::Values]));
    }

    /// Whether the main program can only be the body of a macro: it returns with M99, and neither ends nor
    /// selects a tool. A program that a bar feeder repeats also ends with M99, but it selects tools.
    fn is_macro_body(&mut self, text: &[u8]) -> bool {
        if let Some(known) = self.program.is_macro_body {
            return known;
        }
        // The result depends on later blocks: with labels the run no longer counts as straight
        // (`Program::is_in_linear_order`).
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
}
