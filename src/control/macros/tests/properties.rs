//! Properties of any text: no panic, spans inside the text, work proportional to its length; and random
//! arithmetic against a simple reference.

use std::time::{Duration, Instant};

use proptest::prelude::*;

use super::*;

/// Evaluates some bytes in every possible way.
fn evaluate(text: &[u8]) {
    let mut variables = Variables::default();
    let _ = variables.write(1, Some(2.0));
    for fault in [address_value(text, 0.001, &mut variables).err(), statement(text, &mut variables).err()]
        .into_iter()
        .flatten()
    {
        assert!(fault.at.start <= fault.at.end && fault.at.end <= text.len(), "{fault:?}");
        assert!(text.is_empty() || !fault.at.is_empty(), "{fault:?}");
    }
    if let Ok(Action::Words(at) | Action::Alarm { message: at, .. } | Action::Pause { message: at }) =
        statement(text, &mut variables)
    {
        assert!(at.start <= at.end && at.end <= text.len(), "{at:?}");
    }
}

/// A text of signs and words from macros.
fn pieces() -> impl Strategy<Value = String> {
    let piece = prop::sample::select(vec![
        "#", "[", "]", "=", "+", "-", "*", "/", ",", " ", "(", ")", ".", "1", "2.5", "#1", "#[", "AND", "OR",
        "XOR", "MOD", "EQ", "NE", "LT", "GE", "IF", "IF[", "THEN", "WHILE[", "GOTO", "DO", "END", "SIN[",
        "ATAN[", "POW[", "ROUND[", "#3000=", "#2=", "X5", "é", "DPRNT",
    ]);
    prop::collection::vec(piece, 0..24).prop_map(|pieces| pieces.concat())
}

/// A sum of products, with nested brackets.
#[derive(Clone, Debug)]
enum Tree {
    Number(u32),
    Negative(Box<Tree>),
    Sum(Vec<(char, Tree)>),
    Product(Vec<(char, Tree)>),
}

impl Tree {
    fn write(&self, text: &mut String) {
        match self {
            Self::Number(number) => *text += &(f64::from(*number) / 8.0).to_string(),
            Self::Negative(tree) => {
                *text += "-[";
                tree.write(text);
                text.push(']');
            }
            Self::Sum(parts) => {
                for (index, (sign, part)) in parts.iter().enumerate() {
                    if index > 0 || *sign == '-' {
                        text.push(*sign);
                    }
                    part.in_brackets(text, matches!(part, Self::Sum(_)));
                }
            }
            Self::Product(parts) => {
                for (index, (sign, part)) in parts.iter().enumerate() {
                    if index > 0 {
                        text.push(*sign);
                    }
                    part.in_brackets(text, matches!(part, Self::Sum(_) | Self::Product(_)));
                }
            }
        }
    }

    fn in_brackets(&self, text: &mut String, brackets: bool) {
        if brackets {
            text.push('[');
        }
        self.write(text);
        if brackets {
            text.push(']');
        }
    }

    /// The value; NaN after a division by zero.
    fn value(&self) -> f64 {
        match self {
            Self::Number(number) => f64::from(*number) / 8.0,
            Self::Negative(tree) => -tree.value(),
            Self::Sum(parts) => parts.iter().fold(0.0, |sum, (sign, part)| match sign {
                '-' => sum - part.value(),
                _ => sum + part.value(),
            }),
            Self::Product(parts) => {
                let (first, rest) = parts.split_first().expect("a product has parts");
                rest.iter().fold(first.1.value(), |product, (sign, part)| match (sign, part.value()) {
                    ('/', 0.0) => f64::NAN,
                    ('/', divisor) => product / divisor,
                    (_, factor) => product * factor,
                })
            }
        }
    }
}

fn trees() -> impl Strategy<Value = Tree> {
    (0..800u32).prop_map(Tree::Number).prop_recursive(4, 24, 4, |inner| {
        let signs = |signs: &'static [char]| prop::sample::select(signs);
        prop_oneof![
            inner.clone().prop_map(|tree| Tree::Negative(Box::new(tree))),
            prop::collection::vec((signs(&['+', '-']), inner.clone()), 1..4).prop_map(Tree::Sum),
            prop::collection::vec((signs(&['*', '/']), inner), 1..4).prop_map(Tree::Product),
        ]
    })
}

proptest! {
    #[test]
    fn any_bytes_are_answered(text in prop::collection::vec(any::<u8>(), 0..80)) {
        evaluate(&text);
    }

    #[test]
    fn any_macro_like_text_is_answered(text in pieces()) {
        evaluate(text.as_bytes());
    }

    #[test]
    fn arithmetic_is_that_of_the_reference(tree in trees()) {
        let mut text = String::new();
        tree.write(&mut text);
        let expected = tree.value();
        match assigned(&text) {
            Ok(Some(value)) => prop_assert!(
                (value - expected).abs() <= 1e-9 * expected.abs().max(1e-9), "{text}: {value}, not {expected}"
            ),
            Ok(None) => prop_assert!(false, "{text} is vacant"),
            Err(fault) => prop_assert!(
                fault.kind == MacroErrorKind::DivisionByZero && expected.is_nan(), "{text}: {fault:?}"
            ),
        }
    }

    #[test]
    fn sines_are_those_of_the_reference(degrees in -1000.0..1000.0f64) {
        for (function, expected) in [
            ("SIN", degrees.to_radians().sin()),
            ("COS", degrees.to_radians().cos()),
        ] {
            let value = assigned(&format!("{function}[{degrees}]")).unwrap().unwrap();
            prop_assert!((value - expected).abs() < 1e-11);
        }
    }

    #[test]
    fn bcd_and_back_is_the_same(number in 0..100_000_000u32) {
        exact(&format!("BIN[BCD[{number}]]"), f64::from(number));
    }
}

#[test]
fn long_texts_take_time_in_step_with_their_length() {
    let start = Instant::now();
    for piece in [
        "1+",
        "-",
        "[",
        "#",
        "#[",
        "(",
        "(()",
        "(a)",
        "1 ",
        "9",
        ".",
        "A",
        "SIN[",
        "1 AND ",
        "1 EQ 1 AND ",
        "[1 EQ 1]OR",
        "1 OR (() ",
        "#1 EQ 1 XOR #1 AND ",
        "é",
        "]",
        " ",
    ] {
        for head in ["", "#1=", "#1=[", "IF[", "IF[1 EQ ", "WHILE[[[[1 EQ 1 AND ", "#3000=1", "GOTO "] {
            evaluate((head.to_owned() + &piece.repeat(20_000)).as_bytes());
        }
    }
    assert!(start.elapsed() < Duration::from_secs(10), "{:?}", start.elapsed());
}
