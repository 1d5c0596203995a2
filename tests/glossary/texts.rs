//! In: the files of the project. Out: the texts that people read: paragraphs of Markdown, comments, and strings of the
//! program and of the page. What stands in backticks (code, names) and in braces (arguments of a message) is not searched.

use std::fs;
use std::path::Path;

use super::project;

/// A text.
pub struct Text {
    /// Its file.
    pub file: String,
    /// Its first line.
    pub line: usize,
    /// As written.
    pub written: String,
    /// In lower case; a `□` for each character of code and of arguments.
    pub searched: String,
}

impl Text {
    /// The line of a character of it: its number and what is written there.
    pub fn line_at(&self, character: usize) -> (usize, &str) {
        let before = self.searched.chars().take(character).filter(|&letter| letter == '\n').count();
        (self.line + before, self.written.lines().nth(before).unwrap_or_default().trim())
    }
}

/// Folders whose strings are texts. The strings of tests are programs and names.
const STRINGS: [&str; 5] = ["src/", "www/src/", "www/docs/", "www/rules/", "xtask/src/"];

/// Files that are not searched, and why.
const LEFT_OUT: [(&str, &str); 3] = [
    ("www/docs/glossary.md", "it lists the words"),
    ("tests/glossary", "its tests use the words"),
    ("tests/endless", "hostile programs, made to be no text"),
];

/// Files whose strings are not searched, and why.
const VOCABULARY: [(&str, &str); 2] = [
    ("tool_words", "words that programs of other people use in comments"),
    ("tests.rs", "programs and expected messages"),
];

/// All texts of the project.
pub fn all() -> Vec<Text> {
    let mut texts = Vec::new();
    for file in project::files() {
        if LEFT_OUT.iter().any(|(left_out, _)| file.starts_with(left_out)) {
            continue;
        }
        let content = fs::read_to_string(Path::new(project::ROOT).join(&file)).unwrap_or_default();
        let found = match file.rsplit('.').next() {
            Some("md") => paragraphs(&content),
            Some("rs") => code(&content, Syntax::Rust, strings_of(&file)),
            Some("ts" | "css" | "mjs") => code(&content, Syntax::Script, strings_of(&file)),
            // Titles and sentences of the gallery.
            Some("json") if file.ends_with("/about.json") => code(&content, Syntax::Script, Strings::Read),
            _ => Vec::new(),
        };
        texts.extend(found.into_iter().map(|(line, written)| {
            let searched = prose(&written).to_lowercase();
            Text { file: file.clone(), line, written, searched }
        }));
    }
    texts
}

/// Whether the strings of a file are texts.
fn strings_of(file: &str) -> Strings {
    let vocabulary = VOCABULARY.iter().any(|(part, _)| file.contains(part));
    let texts = STRINGS.iter().any(|folder| file.starts_with(folder));
    if texts && !vocabulary { Strings::Read } else { Strings::Skip }
}

/// The paragraphs of a Markdown document with their first lines; a row of a table is one. Code blocks are left out.
fn paragraphs(text: &str) -> Vec<(usize, String)> {
    let mut found: Vec<(usize, String)> = Vec::new();
    let (mut fenced, mut goes_on) = (false, false);
    for (at, line) in text.lines().enumerate() {
        if line.starts_with("```") {
            fenced = !fenced;
        }
        let blank = line.trim().is_empty() || fenced || line.starts_with("```") || line.starts_with("    ");
        let begins = line.trim_start().starts_with(['|', '#', '*', '-']);
        match found.last_mut() {
            _ if blank => goes_on = false,
            Some((_, paragraph)) if goes_on && !begins => {
                paragraph.push('\n');
                paragraph.push_str(line);
            }
            _ => {
                found.push((at + 1, line.to_owned()));
                goes_on = true;
            }
        }
    }
    found
}

/// What of the strings of a source file is a text.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Strings {
    Read,
    Skip,
}

/// How a language writes its strings.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Syntax {
    /// `"` over several lines, `r#"…"#`; `'` is a character or a lifetime.
    Rust,
    /// `"` and `'` in one line, backticks over several.
    Script,
}

/// The comments of a source file, those in consecutive lines as one, and its strings that are texts.
fn code(text: &str, syntax: Syntax, strings: Strings) -> Vec<(usize, String)> {
    let mut found: Vec<(usize, String)> = Vec::new();
    // The line of the last comment, if it is the last text.
    let mut comment_at = None;
    let mut line = 1;
    let mut rest = text;
    while let Some(letter) = rest.chars().next() {
        let mut length = letter.len_utf8();
        if rest.starts_with("//") {
            length = rest.find('\n').unwrap_or(rest.len());
            let comment = rest[..length].trim_start_matches(['/', '!']);
            match found.last_mut() {
                Some((_, before)) if comment_at.is_some_and(|at: usize| at + 1 == line) => {
                    before.push('\n');
                    before.push_str(comment);
                }
                _ => found.push((line, comment.to_owned())),
            }
            comment_at = Some(line);
        } else if rest.starts_with("/*") {
            length = rest.find("*/").map_or(rest.len(), |end| end + 2);
            found.push((line, rest[..length].to_owned()));
            comment_at = None;
        } else if let Some((quoted, inside)) = quoted(rest, syntax) {
            length = quoted;
            if strings == Strings::Read && is_text(inside) {
                found.push((line, inside.replace("\\n", "\n").replace("\\\n", "\n")));
                comment_at = None;
            }
        }
        line += rest[..length].matches('\n').count();
        rest = &rest[length..];
    }
    found
}

/// Whether a string is a text, and not a key or a name: several words, a label with a capital letter, or another script.
fn is_text(string: &str) -> bool {
    string.contains([' ', '\n']) || string.starts_with(char::is_uppercase) || !string.is_ascii()
}

/// The length of a string that a text begins with, quotes included, and what is between them.
fn quoted(text: &str, syntax: Syntax) -> Option<(usize, &str)> {
    if syntax == Syntax::Rust && text.starts_with("r#\"") {
        let end = text[3..].find("\"#")?;
        return Some((end + 5, &text[3..3 + end]));
    }
    let quote = text.chars().next().filter(|quote| ['"', '\'', '`'].contains(quote))?;
    let mut escaped = false;
    let mut letters = 0;
    for (at, letter) in text.char_indices().skip(1) {
        match letter {
            '\n' if syntax == Syntax::Script && quote != '`' => return None,
            _ if escaped => escaped = false,
            '\\' => escaped = true,
            letter if letter == quote => return Some((at + 1, &text[1..at])),
            _ => {}
        }
        letters += usize::from(!escaped);
        let is_lifetime = syntax == Syntax::Rust && quote == '\'' && letters > 1 && !text.starts_with("'\\");
        if is_lifetime || syntax == Syntax::Rust && quote == '`' {
            return None;
        }
    }
    None
}

/// A text with a `□` for each character in backticks and braces, as long as it was.
fn prose(text: &str) -> String {
    let mut inside = false;
    let hidden = |letter| {
        let mark = ['`', '{', '}'].contains(&letter);
        match letter {
            '`' => inside = !inside,
            '{' => inside = true,
            '}' => inside = false,
            _ => {}
        }
        if (mark || inside) && letter != '\n' { '□' } else { letter }
    };
    text.chars().map(hidden).collect()
}

#[test]
fn paragraphs_rows_and_lists_are_texts() {
    let found = paragraphs("# a\n\nb\nc\n* d\n  e\n\n    code\n\n| f |\n| g |\n```\nh\n```\n");
    let texts: Vec<_> = found.iter().map(|(line, text)| (*line, text.as_str())).collect();
    assert_eq!(texts, [(1, "# a"), (3, "b\nc"), (5, "* d\n  e"), (10, "| f |"), (11, "| g |")]);
}

#[test]
fn comments_and_strings_are_texts() {
    let source = "//! a\n//! b\nfn c<'d>(e: &'d str) {\n    let e = \"f g\"; // h\n    /* i\n j */\n    k('l', '\"', \"m\\\"n o\");\n}\n";
    let wanted = [(1, " a\n b"), (4, "f g"), (4, " h"), (5, "/* i\n j */"), (7, "m\\\"n o")];
    let wanted = wanted.map(|(line, text)| (line, text.to_owned()));
    assert_eq!(code(source, Syntax::Rust, Strings::Read), wanted);
    assert_eq!(code(source, Syntax::Rust, Strings::Skip).len(), 3);
    let raw = "r#\"a \"b c\" d\"# // e";
    assert_eq!(code(raw, Syntax::Rust, Strings::Read), [(1, "a \"b c\" d".to_owned()), (1, " e".to_owned())]);
    let script = "x = /'/; // a\ny = 'b c' + `d\n${e} f`;";
    let wanted = [(1, " a"), (2, "b c"), (2, "d\n${e} f")].map(|(line, text)| (line, text.to_owned()));
    assert_eq!(code(script, Syntax::Script, Strings::Read), wanted);
}

#[test]
fn code_and_arguments_are_not_searched() {
    assert_eq!(prose("`to\nld` is {tell}, not told"), "□□□\n□□□ is □□□□□□, not told");
    let [written, searched] = ["a `b\nc` told", ""].map(str::to_owned);
    let text = Text { file: String::new(), line: 7, searched: prose(&written) + &searched, written };
    assert_eq!(text.line_at(8), (8, "c` told"));
}
