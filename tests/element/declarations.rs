//! Reads the declarations of a class or an interface in TypeScript, as `element.d.ts` has them.
//!
//! In: the text between the braces. Out: names, types and comments. It knows only the forms that occur there.

use std::collections::BTreeSet;

/// A member of a class, or a key of an interface.
#[derive(Debug, PartialEq)]
pub struct Declaration {
    pub name: String,
    /// Its comment, in one line; empty if there is none.
    pub doc: String,
    pub kind: Kind,
    /// The type of a field, or the type that a method returns.
    pub of: String,
}

#[derive(Debug, PartialEq)]
pub enum Kind {
    Field {
        is_readonly: bool,
    },
    /// Names and types of the parameters.
    Method(Vec<(String, String)>),
}

/// The text between the brace at the end of `start` and the brace that closes it.
pub fn body<'a>(text: &'a str, start: &str) -> &'a str {
    let (_, rest) = text.split_once(start).unwrap_or_else(|| panic!("no {start}"));
    &rest[..end_of(rest, '}')]
}

/// The declarations, in their order. A getter and a setter are one field.
pub fn declarations(body: &str) -> Vec<Declaration> {
    let statements = statements(body);
    let set: BTreeSet<&str> = statements
        .iter()
        .filter_map(|(_, statement)| statement.strip_prefix("set ")?.split('(').next())
        .collect();
    statements
        .iter()
        .filter(|(_, statement)| !statement.starts_with("set "))
        .map(|(doc, statement)| declaration(doc, statement, &set))
        .collect()
}

/// Each statement in one line, with its comment.
fn statements(body: &str) -> Vec<(String, String)> {
    let mut found = Vec::new();
    let mut rest = body.trim_start();
    while !rest.is_empty() {
        let mut doc = String::new();
        if let Some((comment, after)) = rest.strip_prefix("/**").and_then(|rest| rest.split_once("*/")) {
            doc = in_one_line(&comment.replace("\n   *", "\n"));
            rest = after.trim_start();
        }
        let end = end_of(rest, ';');
        found.push((doc, in_one_line(&rest[..end])));
        rest = rest[end + 1..].trim_start();
    }
    found
}

fn in_one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The place of a character that is not inside brackets.
fn end_of(text: &str, wanted: char) -> usize {
    let mut depth = 0;
    for (at, letter) in text.char_indices() {
        if depth == 0 && letter == wanted {
            return at;
        }
        match letter {
            '(' | '{' | '[' => depth += 1,
            ')' | '}' | ']' => depth -= 1,
            _ => {}
        }
    }
    panic!("no `{wanted}` after {text}");
}

fn declaration(doc: &str, statement: &str, set: &BTreeSet<&str>) -> Declaration {
    let made = |name: &str, kind, of: &str| Declaration {
        name: name.trim_matches('\'').to_owned(),
        doc: doc.to_owned(),
        kind,
        of: of.to_owned(),
    };
    if let Some(getter) = statement.strip_prefix("get ") {
        let (name, of) = getter.split_once("(): ").expect("a getter has a type");
        return made(name, Kind::Field { is_readonly: !set.contains(name) }, of);
    }
    let rest = statement.strip_prefix("readonly ");
    let name_end = statement.find([':', '(']).expect("a declaration has a type");
    if rest.is_some() || statement[name_end..].starts_with(':') {
        let (name, of) = rest.unwrap_or(statement).split_once(": ").expect("a field has a type");
        return made(name, Kind::Field { is_readonly: rest.is_some() }, of);
    }
    let (name, after) = statement.split_at(name_end);
    let end = end_of(&after[1..], ')') + 1;
    let of = after[end + 1..].trim_start_matches(": ");
    made(name, Kind::Method(parameters(&after[1..end])), of)
}

fn parameters(text: &str) -> Vec<(String, String)> {
    let mut found = Vec::new();
    let mut rest = text.to_owned() + ",";
    while let Some((name, _)) = rest.split_once(": ").map(|(name, of)| (name.trim().to_owned(), of)) {
        let end = end_of(&rest, ',');
        let of = rest[..end].split_once(": ").map_or("", |(_, of)| of).trim_end_matches(';');
        found.push((name, of.trim().to_owned()));
        rest = rest[end + 1..].trim_start().to_owned();
    }
    found
}

#[test]
fn fields_getters_and_methods_are_read() {
    let read = declarations(
        "
  /** The program. */
  value: string;
  get setup(): string | null;
  set setup(setup: object | null);
  get file(): string;
  /**
   * Two
   * lines.
   */
  other(first: { readonly a: string; b: [x: number, y: number] }, second?: number): Promise<void>;
  readonly length: number;
  'gcode-change': CustomEvent<{ readonly value: string }>;
",
    );
    let field = |name: &str, doc: &str, is_readonly, of: &str| Declaration {
        name: name.to_owned(),
        doc: doc.to_owned(),
        kind: Kind::Field { is_readonly },
        of: of.to_owned(),
    };
    let parameters = [("first", "{ readonly a: string; b: [x: number, y: number] }"), ("second?", "number")];
    let other = Declaration {
        name: "other".to_owned(),
        doc: "Two lines.".to_owned(),
        kind: Kind::Method(parameters.map(|(name, of)| (name.to_owned(), of.to_owned())).to_vec()),
        of: "Promise<void>".to_owned(),
    };
    assert_eq!(
        read,
        [
            field("value", "The program.", false, "string"),
            field("setup", "", false, "string | null"),
            field("file", "", true, "string"),
            other,
            field("length", "", true, "number"),
            field("gcode-change", "", false, "CustomEvent<{ readonly value: string }>"),
        ]
    );
}
