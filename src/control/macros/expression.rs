//! Expressions and conditions, evaluated while they are parsed.
//!
//! ```text
//! address   = { sign } ( number | variable | function | "[" sum "]" )
//! variable  = "#" ( number | "[" sum "]" )
//! joined    = all { ( "OR" | "XOR" ) all }                           only conditions are joined
//! all       = comparison { "AND" comparison }
//! comparison = sum [ ( "EQ" | "NE" | "GT" | "GE" | "LT" | "LE" ) sum ]
//! sum       = product { ( "+" | "-" | "OR" | "XOR" ) product }       OR, XOR, AND of numbers: bit by bit
//! product   = factor { ( "*" | "/" | "MOD" | "AND" ) factor }
//! factor    = { sign } ( number | variable | function | "[" joined "]" )
//! function  = name "[" sum [ "," sum ] "]" [ "/" "[" sum "]" ]       two numbers for ATAN and POW only
//! ```
//!
//! In: text and the memory of the variables. Out: a value, or the [`MacroError`]. The text is read once,
//! apart from a lookahead at AND, OR and XOR. The recursion is limited to five nested brackets.

use std::ops::Range;

use super::cursor::{Arithmetic, Cursor, Operator};
use super::functions::{self, Function};
use super::{MacroError, MacroErrorKind, Memory};
use crate::limits::MAX_BRACKETS;

/// The value after an address letter; `None` for a vacant variable, whose word is ignored. `increment` is the
/// least increment of the address, in its own unit; ROUND rounds to it here.
pub fn address_value(
    text: &[u8],
    increment: f64,
    memory: &mut impl Memory,
) -> Result<Option<f64>, MacroError> {
    let mut evaluator = Evaluator::new(text, memory);
    evaluator.rounding = Rounding::Increment(increment);
    let negative = evaluator.signs().unwrap_or(false);
    let value = evaluator.term()?;
    let value = value.number()?.map(|value| if negative { 0.0 - value } else { value });
    match evaluator.cursor.peek() {
        Some(_) => Err(MacroErrorKind::Expression.at(evaluator.cursor.here())),
        None => Ok(value),
    }
}

/// Value of a part of an expression.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Outcome {
    /// A number, or a vacant variable.
    Number(Option<f64>),
    /// A condition.
    Truth(bool),
}

/// Value of a part of an expression, with its position.
#[derive(Clone, Debug)]
pub(super) struct Value {
    pub outcome: Outcome,
    pub at: Range<usize>,
}

impl Value {
    /// The number; `None` for a vacant variable.
    pub fn number(&self) -> Result<Option<f64>, MacroError> {
        match self.outcome {
            Outcome::Number(number) => Ok(number),
            Outcome::Truth(_) => Err(MacroErrorKind::NumberOrCondition.at(self.at.clone())),
        }
    }

    /// The number for arithmetic, where a vacant variable is zero.
    pub fn or_zero(&self) -> Result<f64, MacroError> {
        self.number().map(|number| number.unwrap_or(0.0))
    }

    /// The value of the condition.
    pub fn truth(&self) -> Result<bool, MacroError> {
        match self.outcome {
            Outcome::Truth(truth) => Ok(truth),
            Outcome::Number(_) => Err(MacroErrorKind::NumberOrCondition.at(self.at.clone())),
        }
    }
}

/// Unit of ROUND.
#[derive(Clone, Copy, Debug)]
enum Rounding {
    Integer,
    /// The least increment of an address.
    Increment(f64),
}

/// Whether a sum follows a comparison, so that AND, OR and XOR may begin the next condition.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum NextToken {
    Nothing,
    Comparison,
}

/// Operator precedence, the tighter first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Priority {
    /// `* / MOD AND`.
    Product,
    /// `+ - OR XOR`.
    Sum,
}

/// Parses and evaluates expressions.
pub(super) struct Evaluator<'a> {
    pub cursor: Cursor<'a>,
    memory: &'a mut dyn Memory,
    rounding: Rounding,
    /// Number of open brackets.
    depth: u8,
}

impl<'a> Evaluator<'a> {
    pub fn new(text: &'a [u8], memory: &'a mut impl Memory) -> Self {
        Self { cursor: Cursor::new(text), memory, rounding: Rounding::Integer, depth: 0 }
    }

    /// Writes the variable whose name is at `at`.
    pub fn write(&mut self, variable: u32, value: Option<f64>, at: Range<usize>) -> Result<(), MacroError> {
        self.memory.write(variable, value).map_err(|kind| kind.at(at))
    }

    /// A condition, which begins with a bracket.
    pub fn condition(&mut self) -> Result<bool, MacroError> {
        match self.cursor.peek() {
            Some(b'[') => self.joined()?.truth(),
            _ => Err(MacroErrorKind::Format.at(self.cursor.here())),
        }
    }

    /// A number, as after `=`.
    pub fn sum(&mut self) -> Result<Value, MacroError> {
        self.sum_before(NextToken::Nothing)
    }

    /// A number, variable, function or bracket, without a sign.
    pub fn term(&mut self) -> Result<Value, MacroError> {
        let start = self.cursor.start();
        let outcome = match self.cursor.peek() {
            Some(b'#') => {
                let variable = self.variable()?;
                let read = self.memory.read(variable);
                Outcome::Number(read.map_err(|kind| kind.at(self.cursor.since(start)))?)
            }
            Some(b'[') => self.bracket(Self::joined)?.outcome,
            Some(b'A'..=b'Z') => Outcome::Number(Some(self.function()?)),
            _ => match self.cursor.number() {
                Some(number) => {
                    let number = functions::check_range(number);
                    Outcome::Number(Some(number.map_err(|kind| kind.at(self.cursor.since(start)))?))
                }
                None => return Err(MacroErrorKind::Expression.at(self.cursor.here())),
            },
        };
        Ok(Value { outcome, at: self.cursor.since(start) })
    }

    /// Takes a variable and returns its number.
    pub fn variable(&mut self) -> Result<u32, MacroError> {
        let start = self.cursor.start();
        self.cursor.take(1);
        let number = if self.cursor.peek() == Some(b'[') {
            let rounding = std::mem::replace(&mut self.rounding, Rounding::Integer);
            let number = self.bracket(Self::sum)?.or_zero()?;
            self.rounding = rounding;
            number
        } else if self.is_named() {
            self.cursor.name();
            return Err(MacroErrorKind::NotSupported("#NAME (SETVN)").at(self.cursor.since(start)));
        } else {
            self.cursor.number().ok_or_else(|| MacroErrorKind::Expression.at(self.cursor.here()))?
        };
        functions::count(number).ok_or_else(|| MacroErrorKind::VariableNumber.at(self.cursor.since(start)))
    }

    /// Whether a name follows, as in SETVN, rather than a misread digit such as `O` or `l`.
    fn is_named(&self) -> bool {
        let mut ahead = self.cursor;
        // `# Title` is text.
        let follows_at_once = ahead.here().start == ahead.since(0).end;
        follows_at_once
            && ahead.name().iter().any(|letter| !b"OILSBZQ".contains(&letter.to_ascii_uppercase()))
    }

    /// Conditions joined by OR or XOR.
    fn joined(&mut self) -> Result<Value, MacroError> {
        let mut left = self.all()?;
        while let Some((Operator::Arithmetic(operator @ (Arithmetic::Or | Arithmetic::Xor)), length)) =
            self.cursor.operator()
        {
            self.cursor.take(length);
            let right = self.all()?;
            let (first, second) = (left.truth()?, right.truth()?);
            let truth = if operator == Arithmetic::Or { first | second } else { first ^ second };
            left = Value { outcome: Outcome::Truth(truth), at: left.at.start..right.at.end };
        }
        Ok(left)
    }

    /// Conditions joined by AND.
    fn all(&mut self) -> Result<Value, MacroError> {
        let mut left = self.comparison()?;
        while let Some((Operator::Arithmetic(Arithmetic::And), length)) = self.cursor.operator() {
            self.cursor.take(length);
            let right = self.comparison()?;
            let truth = left.truth()? & right.truth()?;
            left = Value { outcome: Outcome::Truth(truth), at: left.at.start..right.at.end };
        }
        Ok(left)
    }

    fn comparison(&mut self) -> Result<Value, MacroError> {
        let left = self.sum()?;
        let Some((Operator::Comparison(comparison), length)) = self.cursor.operator() else {
            return Ok(left);
        };
        self.cursor.take(length);
        let right = self.sum_before(NextToken::Comparison)?;
        let truth = functions::compare(comparison, left.number()?, right.number()?);
        Ok(Value { outcome: Outcome::Truth(truth), at: left.at.start..right.at.end })
    }

    fn sum_before(&mut self, behind: NextToken) -> Result<Value, MacroError> {
        let mut left = self.product(behind)?;
        while let Some(operator) = self.arithmetic(Priority::Sum, &left, behind) {
            let right = self.product(behind)?;
            left = combined(operator, &left, &right)?;
        }
        Ok(left)
    }

    fn product(&mut self, behind: NextToken) -> Result<Value, MacroError> {
        let mut left = self.factor()?;
        while let Some(operator) = self.arithmetic(Priority::Product, &left, behind) {
            let right = self.factor()?;
            left = combined(operator, &left, &right)?;
        }
        Ok(left)
    }

    /// Takes the operator after a value if it has this priority and does not join conditions.
    fn arithmetic(&mut self, priority: Priority, left: &Value, behind: NextToken) -> Option<Arithmetic> {
        let (Operator::Arithmetic(operator), length) = self.cursor.operator()? else { return None };
        let (of, may_join) = match operator {
            Arithmetic::Multiply | Arithmetic::Divide | Arithmetic::Modulo => (Priority::Product, false),
            Arithmetic::And => (Priority::Product, true),
            Arithmetic::Add | Arithmetic::Subtract => (Priority::Sum, false),
            Arithmetic::Or | Arithmetic::Xor => (Priority::Sum, true),
        };
        let joins = || {
            matches!(left.outcome, Outcome::Truth(_))
                || (behind == NextToken::Comparison && self.cursor.joins_conditions())
        };
        if of != priority || (may_join && joins()) {
            return None;
        }
        self.cursor.take(length);
        Some(operator)
    }

    fn factor(&mut self) -> Result<Value, MacroError> {
        let start = self.cursor.start();
        let Some(negative) = self.signs() else { return self.term() };
        let value = self.term()?.or_zero()?;
        let value = if negative { 0.0 - value } else { value };
        Ok(Value { outcome: Outcome::Number(Some(value)), at: self.cursor.since(start) })
    }

    /// Takes the signs before a value. Returns whether they make it negative; `None` if there are none.
    fn signs(&mut self) -> Option<bool> {
        let mut negative = None;
        loop {
            match self.cursor.peek() {
                Some(b'-') => negative = Some(negative != Some(true)),
                Some(b'+') => negative = Some(negative == Some(true)),
                _ => return negative,
            }
            self.cursor.take(1);
        }
    }

    /// A value in brackets.
    fn bracket(
        &mut self,
        inside: impl FnOnce(&mut Self) -> Result<Value, MacroError>,
    ) -> Result<Value, MacroError> {
        let open = self.cursor.here();
        if !self.cursor.eat(b'[') {
            return Err(MacroErrorKind::Expression.at(open));
        }
        if self.depth == MAX_BRACKETS {
            return Err(MacroErrorKind::BracketsTooDeep.at(open));
        }
        self.depth += 1;
        let value = inside(self)?;
        if !self.cursor.eat(b']') {
            return Err(match self.cursor.peek() {
                None => MacroErrorKind::BracketOpen.at(open),
                Some(_) => MacroErrorKind::Expression.at(self.cursor.here()),
            });
        }
        self.depth -= 1;
        Ok(value)
    }

    fn function(&mut self) -> Result<f64, MacroError> {
        let start = self.cursor.start();
        let name = self.cursor.name();
        // PRM reads a parameter of the control.
        let kind = if name.eq_ignore_ascii_case(b"PRM") {
            MacroErrorKind::NotSupported("PRM")
        } else {
            MacroErrorKind::UnknownFunction
        };
        let unknown = kind.at(self.cursor.since(start));
        let function = Function::named(name).ok_or(unknown)?;
        let mut second = None;
        let first = self.bracket(|evaluator| {
            let first = evaluator.sum()?;
            if function.takes_two() && evaluator.cursor.eat(b',') {
                second = Some(evaluator.sum()?.or_zero()?);
            }
            Ok(first)
        })?;
        let first = first.or_zero()?;
        if function == Function::Atan && second.is_none() {
            let mut ahead = self.cursor;
            if ahead.eat(b'/') && ahead.peek() == Some(b'[') {
                self.cursor = ahead;
                second = Some(self.bracket(Self::sum)?.or_zero()?);
            }
        }
        let result = match (second, self.rounding) {
            (Some(second), _) => function.of_two(first, second),
            (None, Rounding::Increment(increment)) if function == Function::Round => {
                functions::round_to(first, increment)
            }
            (None, _) => function.of(first),
        };
        result.map_err(|kind| kind.at(self.cursor.since(start)))
    }
}

fn combined(operator: Arithmetic, left: &Value, right: &Value) -> Result<Value, MacroError> {
    let at = left.at.start..right.at.end;
    match functions::combine(operator, left.or_zero()?, right.or_zero()?) {
        Ok(value) => Ok(Value { outcome: Outcome::Number(Some(value)), at }),
        Err(MacroErrorKind::DivisionByZero) => Err(MacroErrorKind::DivisionByZero.at(right.at.clone())),
        Err(kind) => Err(kind.at(at)),
    }
}
