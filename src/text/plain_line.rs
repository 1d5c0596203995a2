//! Lines with only positions, read as a whole: `N10 G01 X20. Z-5.`.
//!
//! In: text. Out: [`PlainLine`]. Nearly all lines of a long program are of this kind; reading them as blocks
//! gives the same result, only slower. Knows no more of the meaning of words than the parser.

use super::lexer::{Number, plain_number};
use crate::source::Span;

/// A line with X, Z or both, optionally after a sequence number and a G word; all plain words, in this order.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PlainLine {
    /// The sequence number.
    pub sequence: Option<u32>,
    /// The number of the G word.
    pub code: Option<Number>,
    /// The number of the X word, and whether it is negative.
    pub x: Option<(bool, Number)>,
    /// The number of the Z word, and whether it is negative.
    pub z: Option<(bool, Number)>,
    /// All its bytes, without the line end.
    pub span: Span,
}

impl PlainLine {
    /// The line that begins at byte `start` of a text, if it is a plain one.
    #[inline]
    pub(super) fn read(text: &[u8], start: usize) -> Option<Self> {
        let mut line = Self::default();
        let mut at = start;
        loop {
            let byte = *text.get(at)?;
            if byte == b' ' {
                at += 1;
                continue;
            }
            let has_place = line.x.is_some() || line.z.is_some();
            if byte == b'\n' {
                line.span = Span::new(start, at);
                return has_place.then_some(line);
            }
            // No letter may appear twice, or after a letter that must follow it.
            let may_stand = match byte {
                b'Z' => line.z.is_none(),
                b'X' => !has_place,
                b'G' => !has_place && line.code.is_none(),
                b'N' => !has_place && line.code.is_none() && line.sequence.is_none(),
                _ => false,
            };
            if !may_stand {
                return None;
            }
            let (negative, number, end) = plain_number(text, at + 1)?;
            at = end;
            match byte {
                b'Z' => line.z = Some((negative, number)),
                b'X' => line.x = Some((negative, number)),
                _ if negative => return None,
                b'G' => line.code = Some(number),
                _ if number.has_point() => return None,
                _ => line.sequence = Some(number.mantissa as u32),
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::text::block::{Block, Value};
    use crate::text::parser::Parser;

    /// The numbers of a line read as a block: sequence number, G, X, Z.
    fn as_block(text: &str) -> PlainLine {
        let (mut parser, mut block) = (Parser::new(text.as_bytes()), Block::default());
        assert!(parser.next_block(&mut block) && block.faults.is_empty(), "{text}");
        let number = |address: u8| {
            let mut words = block.words.iter().filter(|word| word.address == address);
            let word = words.next()?;
            assert!(words.next().is_none(), "{text}");
            match word.value {
                Value::Number { number, negative } => Some((negative, number)),
                Value::Expression => None,
            }
        };
        let code = number(b'G').map(|(_, number)| number);
        PlainLine { sequence: block.sequence, code, x: number(b'X'), z: number(b'Z'), span: block.span }
    }

    #[test]
    fn a_plain_line_is_what_its_block_is() {
        for text in
            ["X1\n", "G01X-20.5Z-3\n", "N10 G1 X20. Z.5\n", " N0007 Z-0 \n", "N1 G00 X1 Z-12345.678\n"]
        {
            let line = PlainLine::read(text.as_bytes(), 0);
            assert_eq!(line, Some(as_block(text)), "{text}");
            assert_eq!(line.map(|line| line.span.end as usize), Some(text.len() - 1));
        }
    }

    #[test]
    fn other_lines_are_left_to_the_parser() {
        for text in [
            "X1",
            "\n",
            "N10\n",
            "G1\n",
            "Z1 X1\n",
            "X1 X2\n",
            "G0 G1 X1\n",
            "X1 N5\n",
            "X1 F2\n",
            "X1;\n",
            "X1 (A)\n",
            "/X1\n",
            "G-1 X1\n",
            "N-1 X1\n",
            "N1. X1\n",
            "X1 0\n",
            "X1.2.3\n",
            "X\n",
            "X-\n",
            "X1O\n",
            "X123456789\n",
            "x1\n",
            "X#1\n",
            "X+1\n",
            "X1\tZ1\n",
            "X1\r\n",
            ",X1\n",
            "U1\n",
        ] {
            assert_eq!(PlainLine::read(text.as_bytes(), 0), None, "{text}");
        }
    }
}
