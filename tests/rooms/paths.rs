//! The module paths and method calls in a Rust source file.
//!
//! In: the text of a file. Out: the paths of its `use` items, the paths in its code that begin with `crate`,
//! `super` or `self`, the methods that it defines, and the methods that it calls on `self` or on a reference
//! whose type is declared. Code under `#[cfg(test)]` is left out: a test may use everything. Does not know
//! where modules are.

use std::collections::BTreeMap;

/// The paths in a file.
#[derive(Debug, Default, PartialEq)]
pub struct Named {
    /// Paths in code, and those of private `use` items.
    pub paths: Vec<Vec<String>>,
    /// Paths of `pub use` items, with the exported name; `*` for all names of a module.
    pub offered: Vec<(String, Vec<String>)>,
    /// Modules for tests only.
    pub test_modules: Vec<String>,
    /// Methods that the file defines.
    pub methods: Vec<Method>,
    /// Methods that it calls.
    pub calls: Vec<Method>,
    /// The type of the `impl` block that is being read.
    own_type: Option<(String, usize)>,
    /// Types of the references that parameters and fields declare, by name.
    references: BTreeMap<String, String>,
}

/// A method of a type.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Method {
    /// The type, without its path and arguments.
    pub of: String,
    /// The name of the method.
    pub name: String,
}

impl Named {
    /// Parses a file.
    pub fn read(source: &str) -> Self {
        let tokens = tokens(source);
        let mut named = Self::default();
        let mut at = 0;
        while at < tokens.len() {
            at = named.read_item(&tokens, at);
        }
        named
    }

    /// Parses the item at a token. Returns the index of the token after it.
    fn read_item(&mut self, tokens: &[String], at: usize) -> usize {
        let is = |index: usize, text: &str| tokens.get(index).is_some_and(|token| token == text);
        if tokens[at..].starts_with(&["#", "[", "cfg", "(", "test", ")", "]"].map(str::to_owned)) {
            let item = skip_attributes(tokens, at);
            if is(item, "mod") && is(item + 2, ";") {
                self.test_modules.push(tokens[item + 1].clone());
            }
            return skip_item(tokens, item);
        }
        self.read_method(tokens, at);
        let begins_path = matches!(tokens[at].as_str(), "crate" | "super" | "self");
        if begins_path && is(at + 1, "::") && (at == 0 || tokens[at - 1] != "::") {
            let mut path = vec![tokens[at].clone()];
            let mut end = at + 1;
            while is(end, "::") && tokens.get(end + 1).is_some_and(|name| is_name(name)) {
                path.push(tokens[end + 1].clone());
                end += 2;
            }
            self.paths.push(path);
            return end;
        }
        // `use<…>` in a type names lifetimes.
        if tokens[at] != "use" || is(at + 1, "<") {
            return at + 1;
        }
        let is_public = at > 0 && (tokens[at - 1] == "pub" || tokens[at - 1] == ")");
        let mut found = Vec::new();
        let end = read_tree(tokens, at + 1, &[], &mut found);
        for (name, path) in found {
            if is_public {
                self.offered.push((name, path));
            } else {
                self.paths.push(path);
            }
        }
        end
    }

    /// Notes the method that a token defines or calls.
    fn read_method(&mut self, tokens: &[String], at: usize) {
        let token = |index: usize| tokens.get(index).map_or("", |token| token);
        let before = at.checked_sub(1).map_or("", token);
        let own_type = self.own_type.as_ref().filter(|(_, end)| at < *end).map(|(own_type, _)| own_type);
        let method = |of: &String, name: &str| Method { of: of.clone(), name: name.to_owned() };
        match token(at) {
            "impl" if !matches!(before, ":" | "&" | "(" | ">") => {
                self.own_type = implemented(tokens, at);
            }
            "fn" => self.methods.extend(own_type.map(|own_type| method(own_type, token(at + 1)))),
            ":" if token(at + 1) == "&" => {
                let mut end = at + 2;
                if token(end) == "'" {
                    end += 2;
                }
                end += usize::from(token(end) == "mut");
                if token(end).starts_with(char::is_uppercase) {
                    self.references.insert(before.to_owned(), token(end).to_owned());
                }
            }
            "." if token(at + 2) == "(" => {
                let of = if before == "self" { own_type } else { self.references.get(before) };
                self.calls.extend(of.map(|of| method(of, token(at + 1))));
            }
            "::" if before == "Self" => {
                self.calls.extend(own_type.map(|own_type| method(own_type, token(at + 1))));
            }
            _ => {}
        }
    }
}

/// The type of the `impl` block at a token, and the index of the token after the block.
fn implemented(tokens: &[String], at: usize) -> Option<(String, usize)> {
    let body = at + tokens[at..].iter().position(|token| token == "{")?;
    let head = &tokens[at..body];
    let after_for = head.iter().position(|token| token == "for").map_or(1, |index| index + 1);
    let is_type = |token: &&String| token.starts_with(char::is_uppercase);
    let own_type = match head.get(after_for).map(String::as_str) {
        // Parameters of the block come before the type.
        Some("<") => head[skip_angles(head, after_for)..].iter().find(is_type)?,
        _ => head[after_for..].iter().find(is_type)?,
    };
    Some((own_type.clone(), skip_group(tokens, body)))
}

/// The index of the token after the angle brackets at `at`.
fn skip_angles(tokens: &[String], at: usize) -> usize {
    let mut depth = 0;
    for (index, token) in tokens.iter().enumerate().skip(at) {
        match token.as_str() {
            "<" => depth += 1,
            ">" => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return index + 1;
        }
    }
    tokens.len()
}

/// Parses a tree of a `use` item into names and paths. Returns the index of the token after it.
fn read_tree(
    tokens: &[String],
    mut at: usize,
    prefix: &[String],
    found: &mut Vec<(String, Vec<String>)>,
) -> usize {
    let mut path = prefix.to_vec();
    while let Some(token) = tokens.get(at) {
        match token.as_str() {
            "::" => at += 1,
            "{" => {
                at += 1;
                while tokens.get(at).is_some_and(|token| token != "}") {
                    let end = read_tree(tokens, at, &path, found);
                    let comma = tokens.get(end).is_some_and(|token| token == ",");
                    at = (end + usize::from(comma)).max(at + 1);
                }
                return at + 1;
            }
            "," | ";" | "}" | "as" => break,
            "self" if path.len() > prefix.len() || !prefix.is_empty() => at += 1,
            _ => {
                path.push(token.clone());
                at += 1;
            }
        }
    }
    let mut name = path.last().cloned().unwrap_or_default();
    if tokens.get(at).is_some_and(|token| token == "as") {
        name = tokens[at + 1].clone();
        at += 2;
    }
    found.push((name, path));
    at
}

/// The index of the token after the attributes at `at`.
fn skip_attributes(tokens: &[String], mut at: usize) -> usize {
    while tokens.get(at).is_some_and(|token| token == "#") {
        at = skip_group(tokens, at + 1);
    }
    at
}

/// The index of the token after an item: after its `;` or its braces.
fn skip_item(tokens: &[String], mut at: usize) -> usize {
    while let Some(token) = tokens.get(at) {
        match token.as_str() {
            ";" => return at + 1,
            "{" => return skip_group(tokens, at),
            "(" | "[" => at = skip_group(tokens, at),
            _ => at += 1,
        }
    }
    at
}

/// The index of the token after the group at `at`.
fn skip_group(tokens: &[String], mut at: usize) -> usize {
    let mut depth = 0;
    while let Some(token) = tokens.get(at) {
        at += 1;
        match token.as_str() {
            "{" | "(" | "[" => depth += 1,
            "}" | ")" | "]" => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            break;
        }
    }
    at
}

fn is_name(token: &str) -> bool {
    token.starts_with(|ch: char| ch.is_alphabetic() || ch == '_')
}

/// The tokens of a file, without comments and literals; `::` is one token.
fn tokens(source: &str) -> Vec<String> {
    let mut tokens = Vec::new();
    let mut rest = source;
    while let Some(first) = rest.chars().next() {
        let length = if rest.starts_with("//") {
            rest.find('\n').unwrap_or(rest.len())
        } else if rest.starts_with("/*") {
            rest.find("*/").map_or(rest.len(), |end| end + 2)
        } else if let Some(length) = literal(rest) {
            length
        } else if is_name(rest) || first.is_ascii_digit() {
            let length = rest.find(|ch: char| !(ch.is_alphanumeric() || ch == '_')).unwrap_or(rest.len());
            tokens.push(rest[..length].to_owned());
            length
        } else if rest.starts_with("::") {
            tokens.push("::".to_owned());
            2
        } else {
            if !first.is_whitespace() {
                tokens.push(first.to_string());
            }
            first.len_utf8()
        };
        rest = &rest[length..];
    }
    tokens
}

/// The length of the string or character literal at the start of the text, if there is one.
fn literal(text: &str) -> Option<usize> {
    let body = text.strip_prefix('b').unwrap_or(text);
    let before = text.len() - body.len();
    if let Some(raw) = body.strip_prefix('r') {
        let marks = raw.len() - raw.trim_start_matches('#').len();
        if raw[marks..].starts_with('"') {
            let close = format!("\"{}", "#".repeat(marks));
            let end = raw[marks + 1..].find(&close)?;
            return Some(before + 1 + marks + 1 + end + close.len());
        }
    }
    let quote = body.chars().next().filter(|ch| matches!(ch, '"' | '\''))?;
    let mut escaped = false;
    for (at, ch) in body.char_indices().skip(1) {
        match ch {
            _ if escaped => escaped = false,
            '\\' => escaped = true,
            _ if ch == quote => return Some(before + at + ch.len_utf8()),
            _ => {}
        }
        // A quote without a closing one belongs to a lifetime.
        if quote == '\'' && !escaped && !body[at + ch.len_utf8()..].starts_with('\'') {
            return None;
        }
    }
    None
}

#[test]
fn paths_are_read_as_they_are_written() {
    let named = Named::read(
        "//! crate::comment\nuse crate::a::{self, B, c::{D, E as F}};\npub use g::H;\npub(crate) use super::i::*;\n\
         #[cfg(test)]\nmod checks;\nfn f<'a>(x: &'a str, q: char) { crate::j::k(\"crate::no\", '\\'', r#\"super::no\"#); }\n\
         #[cfg(test)]\n#[allow(unused)]\nmod tests {\n    use crate::l::M;\n}\nfn last<'a>() -> impl Fn(super::n::O) + use<'a> { ; }\n",
    );
    let written = |path: &Vec<String>| path.join("::");
    let paths: Vec<String> = named.paths.iter().map(written).collect();
    assert_eq!(
        paths,
        ["crate::a", "crate::a::B", "crate::a::c::D", "crate::a::c::E", "crate::j::k", "super::n::O"]
    );
    let offered: Vec<(&str, String)> =
        named.offered.iter().map(|(name, path)| (name.as_str(), written(path))).collect();
    assert_eq!(offered, [("H", "g::H".to_owned()), ("*", "super::i::*".to_owned())]);
    assert_eq!(named.test_modules, ["checks"]);
}

#[test]
fn methods_are_read_with_their_types() {
    let named = Named::read(
        "impl<'a> A { fn b(&self, c: &mut C) { self.d(); c.e(1); x.f(); self.g.h(); Self::i(); } }\n\
         impl Iterator for J<K> { fn next(&mut self) { self.l() } }\n\
         struct M<'a> { g: &'a mut N }\nimpl M<'_> { fn o(&self) { self.g.p() } }\n\
         fn q(r: &S) -> impl T { r.u(); self.v() }\n#[cfg(test)]\nmod tests { impl W { fn x(&self) {} } }\n",
    );
    let written = |methods: &[Method]| -> Vec<String> {
        methods.iter().map(|method| format!("{}::{}", method.of, method.name)).collect()
    };
    assert_eq!(written(&named.methods), ["A::b", "J::next", "M::o"]);
    assert_eq!(written(&named.calls), ["A::d", "C::e", "A::i", "J::l", "N::p", "S::u"]);
}
