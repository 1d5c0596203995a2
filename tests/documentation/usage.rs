//! In: a usage line such as `check FILE… [--fix [--dry-run]] [--format text|json]`. Out: the calls that it
//! allows: the plain one, each option alone, and each of its values.

/// A part of a usage line.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Part {
    /// A word, or one of several.
    Word(Vec<String>),
    /// An optional part.
    Optional(Vec<Part>),
}

/// All calls that a usage line allows, as words.
pub fn calls(line: &str) -> Vec<Vec<String>> {
    let mut tokens = tokens(line).into_iter();
    let parts = parts(&mut tokens);
    expand(&parts)
}

/// Brackets are separate tokens, everything else is split into words.
fn tokens(line: &str) -> Vec<String> {
    line.replace('[', " [ ").replace(']', " ] ").split_whitespace().map(str::to_owned).collect()
}

fn parts(tokens: &mut impl Iterator<Item = String>) -> Vec<Part> {
    let mut parts = Vec::new();
    while let Some(token) = tokens.next() {
        match token.as_str() {
            "[" => parts.push(Part::Optional(self::parts(tokens))),
            "]" => break,
            word => parts.push(Part::Word(word.split('|').map(str::to_owned).collect())),
        }
    }
    parts
}

/// The plain call first; then, for each part with a choice, one call per choice, with the other parts plain.
fn expand(parts: &[Part]) -> Vec<Vec<String>> {
    let plain = |part: &Part| match part {
        Part::Word(choices) => vec![choices[0].clone()],
        Part::Optional(_) => Vec::new(),
    };
    let mut calls = vec![parts.iter().flat_map(plain).collect::<Vec<_>>()];
    for (at, part) in parts.iter().enumerate() {
        let choices = match part {
            Part::Word(choices) => choices[1..].iter().map(|choice| vec![choice.clone()]).collect(),
            Part::Optional(inner) => expand(inner),
        };
        for choice in choices {
            let before = parts[..at].iter().flat_map(plain);
            let after = parts[at + 1..].iter().flat_map(plain);
            calls.push(before.chain(choice).chain(after).collect());
        }
    }
    calls
}

#[test]
fn every_option_and_value_is_called_once() {
    let calls: Vec<_> =
        calls("do FILE [--fix [--dry]] [--form a|b]").iter().map(|call| call.join(" ")).collect();
    assert_eq!(
        calls,
        ["do FILE", "do FILE --fix", "do FILE --fix --dry", "do FILE --form a", "do FILE --form b"]
    );
}
