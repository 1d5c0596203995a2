//! Macro A: `G65 H02 P#200 Q#201 R5`, a statement of a macro written as a block (GSK980TD; FANUC 0).
//!
//! In: a block. Out: the changed variables, and where the program continues. Each operation is a statement of macro B,
//! which `control::macros` evaluates; this file contains only the forms of these statements.

use super::macro_values::Evaluated;
use super::{BlockPosition, Flow, Interpreter};
use crate::control::codes;
use crate::control::macros::{Action, MacroErrorKind};
use crate::control::words::plain;
use crate::message::{Diagnostic, said};
use crate::setup::dialect::Control;
use crate::text::block::Block;

/// The operations by number (GSK980TDi manual, macro command list; H28 is FANUC's). Small letters are the
/// values of P, Q and R. Angles are in degrees.
const OPERATIONS: [(u32, &str); 28] = [
    (1, "p=q"),
    (2, "p=q+r"),
    (3, "p=q-r"),
    (4, "p=q*r"),
    (5, "p=q/r"),
    (11, "p=q OR r"),
    (12, "p=q AND r"),
    (13, "p=q XOR r"),
    (21, "p=SQRT[q]"),
    (22, "p=ABS[q]"),
    (23, "p=q-FIX[q/r]*r"),
    (24, "p=BIN[q]"),
    (25, "p=BCD[q]"),
    (26, "p=p*q/r"),
    (27, "p=SQRT[q*q+r*r]"),
    (28, "p=SQRT[q*q-r*r]"),
    (31, "p=q*SIN[r]"),
    (32, "p=q*COS[r]"),
    (33, "p=q*TAN[r]"),
    (34, "p=ATAN[q]/[r]"),
    (80, "GOTOp"),
    (81, "IF[q EQ r]GOTOp"),
    (82, "IF[q NE r]GOTOp"),
    (83, "IF[q GT r]GOTOp"),
    (84, "IF[q LT r]GOTOp"),
    (85, "IF[q GE r]GOTOp"),
    (86, "IF[q LE r]GOTOp"),
    (99, "#3000=p"),
];

/// Added to the number of H99 (GSK980TDi: alarm 500+n).
const FIRST_ALARM: i64 = 500;

impl Interpreter {
    /// The number of the operation, if the block is macro A: H follows G65, and P is not a program of this
    /// text.
    pub(super) fn macro_a_of(&mut self, text: &[u8], block: &Block) -> Option<u32> {
        let operation = codes::macro_a(block)?;
        let called = block.words.iter().find(|word| word.address == b'P');
        let number = called.and_then(plain).map(|number| number as u32);
        let is_call = |number: u32| self.program.labels(text).program(number).is_some();
        let is_other = self.dialect.control != Control::Gsk && number.is_some_and(is_call);
        (!is_other).then_some(operation)
    }

    /// Carries out a block of macro A.
    pub(super) fn macro_a(
        &mut self,
        text: &[u8],
        block: &Block,
        here: BlockPosition,
        operation: u32,
    ) -> Flow {
        if !self.count_macro_step(block) {
            return Flow::End;
        }
        let span = block.words_span();
        let form = OPERATIONS.iter().find(|(number, _)| *number == operation);
        let Some((_, form)) = form else {
            let what = format!("G65 H{operation:02}");
            self.report(Diagnostic::new(said::NotSupported { what }, span));
            self.doubt_after_missing_program();
            return Flow::Next;
        };
        let Some(statement) = written(text, block, form) else {
            self.report_macro(MacroErrorKind::Format, span);
            self.doubt_after_missing_program();
            return Flow::Next;
        };
        match self.evaluate(text, block, statement.as_bytes(), here) {
            Evaluated::Action(Action::Goto(sequence)) => self.go_to(text, block, sequence, span),
            Evaluated::Action(Action::Alarm { number, .. }) => {
                let number = number.saturating_add(FIRST_ALARM);
                let words = span.quote(text);
                self.report_always(Diagnostic::new(said::MacroAlarm { number, words }, span));
                Flow::End
            }
            Evaluated::Action(_) => Flow::Next,
            Evaluated::Flow(flow) => flow,
            Evaluated::Fault(fault) => {
                self.report_macro(fault.kind, span);
                Flow::Next
            }
        }
    }
}

/// The statement of a form with the values of the block; `None` if a value is missing.
fn written(text: &[u8], block: &Block, form: &str) -> Option<String> {
    let value = |letter: char| {
        let word = block
            .words
            .iter()
            .find(|word| word.address == letter.to_ascii_uppercase() as u8 && !word.comma)?;
        let written = word.span.quote(text);
        Some(written[1..].trim().to_owned())
    };
    let mut statement = String::new();
    for letter in form.chars() {
        match letter {
            'p' => statement += &value('p')?,
            'q' | 'r' => statement += &format!("[{}]", value(letter)?),
            other => statement.push(other),
        }
    }
    Some(statement)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::text::parser::Parser;

    #[test]
    fn an_operation_is_a_statement_of_macro_b() {
        let read = |text: &str| {
            let (mut parser, mut block) = (Parser::new(text.as_bytes()), Block::default());
            parser.next_block(&mut block);
            let operation = codes::macro_a(&block)?;
            let (_, form) = OPERATIONS.iter().find(|(number, _)| *number == operation)?;
            written(text.as_bytes(), &block, form)
        };
        assert_eq!(read("N5 G65 H02 P#200 Q#201 R5").as_deref(), Some("#200=[#201]+[5]"));
        assert_eq!(read("G65 H28 P#1 Q-#2 R1.5").as_deref(), Some("#1=SQRT[[-#2]*[-#2]-[1.5]*[1.5]]"));
        assert_eq!(read("G65H85P20Q#200R-3").as_deref(), Some("IF[[#200] GE [-3]]GOTO20"));
        assert_eq!(read("G65 H80 P90").as_deref(), Some("GOTO90"));
        assert_eq!(read("G65 H02 P#200 Q#201"), None);
        assert_eq!(read("G65 P9010 H2"), None);
    }
}
