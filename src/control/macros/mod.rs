//! Custom macro B: variables, expressions and statements.
//!
//! In: the text of an address value or of a macro statement, and the [`Memory`] with its variables. Out: a
//! number, the [`Action`] of the statement, or a [`MacroError`]. The text is evaluated directly, without a
//! syntax tree, so a loop parses its blocks again in each round. Knows nothing of blocks, motions or the
//! meaning of system variables.

mod arguments;
mod cursor;
mod expression;
mod functions;
mod statement;
#[cfg(test)]
mod tests;
mod variables;

use std::ops::Range;

use crate::message::{Message, said};

pub use arguments::{ArgumentError, arguments};
pub use expression::address_value;
pub use statement::{Action, assigned, statement};
pub use variables::{Found, Knowledge, LOCALS, Locals, MAX_LEVELS, Stored, Variables};

/// Storage of variables.
pub trait Memory {
    /// The value of a variable; `None` if it is vacant.
    fn read(&mut self, variable: u32) -> Result<Option<f64>, MacroErrorKind>;

    /// Assigns a variable, or makes it vacant.
    fn write(&mut self, variable: u32, value: Option<f64>) -> Result<(), MacroErrorKind>;
}

/// An error in a macro, with its position.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MacroError {
    /// The kind of error.
    pub kind: MacroErrorKind,
    /// Bytes of the given text; empty only if the text is empty.
    pub at: Range<usize>,
}

/// Kinds of errors in a macro.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MacroErrorKind {
    /// A value beyond ±10^47, or not a number: PS0111.
    Overflow,
    /// Division, or MOD, by zero: PS0112.
    DivisionByZero,
    /// A function that does not exist: PS0113.
    UnknownFunction,
    /// An expression that cannot be parsed: PS0114.
    Expression,
    /// A `[` without its `]`: PS0114.
    BracketOpen,
    /// A condition where a number belongs, or a number where a condition belongs: PS0114.
    NumberOrCondition,
    /// A variable that does not exist: PS0115.
    VariableNumber,
    /// A read-only variable: PS0116.
    ReadOnly,
    /// More than five nested brackets: PS0118.
    BracketsTooDeep,
    /// An argument for which the function has no result: PS0119.
    FunctionArgument,
    /// DO without its END; reported by the caller, which has the blocks: PS0124.
    EndMissing,
    /// A statement that cannot be parsed: PS0125.
    Format,
    /// A loop number that is not 1, 2 or 3: PS0126.
    LoopNumber,
    /// Words of an ordinary block after a macro statement: PS0127.
    WordsBehind,
    /// A number that no block can have; the caller also reports a missing block this way: PS0128.
    JumpTarget,
    /// A letter that cannot pass an argument: PS0129.
    ArgumentLetter,
    /// A feature of real controls that is not supported here.
    NotSupported(&'static str),
}

impl MacroErrorKind {
    /// Whether the error might not occur with other values of the variables.
    pub fn depends_on_values(self) -> bool {
        match self {
            Self::Overflow
            | Self::DivisionByZero
            | Self::VariableNumber
            | Self::ReadOnly
            | Self::FunctionArgument
            | Self::JumpTarget => true,
            Self::UnknownFunction
            | Self::Expression
            | Self::BracketOpen
            | Self::NumberOrCondition
            | Self::BracketsTooDeep
            | Self::EndMissing
            | Self::Format
            | Self::LoopNumber
            | Self::WordsBehind
            | Self::ArgumentLetter
            | Self::NotSupported(_) => false,
        }
    }

    /// The message for the error.
    pub fn message(self) -> Message {
        match self {
            Self::Overflow => said::MacroOverflow.into(),
            Self::DivisionByZero => said::MacroDivisionByZero.into(),
            Self::UnknownFunction => said::MacroUnknownFunction.into(),
            Self::Expression => said::MacroExpression.into(),
            Self::BracketOpen => said::MacroBracketOpen.into(),
            Self::NumberOrCondition => said::MacroNumberOrCondition.into(),
            Self::VariableNumber => said::MacroVariableNumber.into(),
            Self::ReadOnly => said::MacroReadOnly.into(),
            Self::BracketsTooDeep => said::MacroBracketsTooDeep.into(),
            Self::FunctionArgument => said::MacroFunctionArgument.into(),
            Self::EndMissing => said::MacroEndMissing.into(),
            Self::Format => said::MacroFormat.into(),
            Self::LoopNumber => said::MacroLoopNumber.into(),
            Self::WordsBehind => said::MacroWordsBehind.into(),
            Self::JumpTarget => said::MacroJumpTarget.into(),
            Self::ArgumentLetter => said::MacroArgumentLetter.into(),
            Self::NotSupported(what) => said::NotSupported { what: what.to_owned() }.into(),
        }
    }

    fn at(self, at: Range<usize>) -> MacroError {
        MacroError { kind: self, at }
    }
}
