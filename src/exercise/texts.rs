//! The texts of an exercise in one language.
//!
//! In: the lines of a section `# en: Title`. Out: [`Texts`]: title, task and hints. Hints are block quotes. HTML, and
//! links other than `https:` and relative ones, are refused, so a text can be shown on any page.

use super::fault::{Part, Problem, ReadError, at_most};
use crate::source::is_unprintable;

/// Greatest number of characters of a title, a task and a hint.
const LONGEST_TITLE: usize = 200;
const LONGEST_TASK: usize = 5000;
const LONGEST_HINT: usize = 500;
/// Greatest number of hints.
const MOST_HINTS: usize = 3;

/// Title, task and hints in one language.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Texts {
    /// The title, one line of plain text.
    pub title: String,
    /// The task, Markdown without HTML.
    pub task: String,
    /// The hints, in the order in which they are given; at most three.
    pub hints: Vec<String>,
}

impl Texts {
    /// Reads the lines below the heading of a section. `first` is the line number of the heading.
    pub(super) fn read(title: &str, lines: &[&str], first: usize) -> Result<Self, ReadError> {
        let mut texts = Self { title: title.trim().to_owned(), ..Self::default() };
        let mut is_in_hint = false;
        for (index, line) in lines.iter().enumerate() {
            let number = first + 1 + index;
            check_line(line, number)?;
            match line.strip_prefix('>') {
                Some(hint) => {
                    texts.add_hint(hint.trim(), is_in_hint, number)?;
                    is_in_hint = true;
                }
                None => {
                    is_in_hint = false;
                    texts.task.push_str(line.trim_end());
                    texts.task.push('\n');
                }
            }
        }
        check_line(title, first)?;
        texts.task = texts.task.trim().to_owned();
        texts.check_lengths(first)?;
        Ok(texts)
    }

    fn add_hint(&mut self, line: &str, goes_on: bool, number: usize) -> Result<(), ReadError> {
        if let Some(hint) = self.hints.last_mut().filter(|_| goes_on) {
            hint.push(' ');
            hint.push_str(line);
            return Ok(());
        }
        at_most(Part::Hints, self.hints.len() + 1, MOST_HINTS, number)?;
        self.hints.push(line.to_owned());
        Ok(())
    }

    fn check_lengths(&self, line: usize) -> Result<(), ReadError> {
        if self.title.is_empty() || self.task.is_empty() {
            return Err(ReadError::at(line, Problem::NoText));
        }
        at_most(Part::Title, self.title.chars().count(), LONGEST_TITLE, line)?;
        at_most(Part::Task, self.task.chars().count(), LONGEST_TASK, line)?;
        self.hints.iter().try_for_each(|hint| at_most(Part::Hint, hint.chars().count(), LONGEST_HINT, line))
    }
}

/// Refuses HTML, unsafe links and control characters.
fn check_line(line: &str, number: usize) -> Result<(), ReadError> {
    if line.contains(is_unprintable) {
        return Err(ReadError::at(number, Problem::ControlCharacter));
    }
    let begins_tag =
        |after: &str| after.starts_with(|next: char| next.is_alphabetic() || "/!?".contains(next));
    if line.split('<').skip(1).any(begins_tag) {
        return Err(ReadError::at(number, Problem::Html));
    }
    let is_definition = line.trim_start().starts_with('[') && line.contains("]:");
    let has_other_link = line.split("](").skip(1).any(|target| !is_safe_link(target));
    if is_definition || has_other_link {
        return Err(ReadError::at(number, Problem::Link));
    }
    Ok(())
}

/// Whether the target of a link is an address with `https:` or a relative one.
fn is_safe_link(target: &str) -> bool {
    let target = target.split(')').next().unwrap_or_default();
    let is_plain = |letter: char| letter.is_ascii_alphanumeric() || "/.#-_".contains(letter);
    match target.strip_prefix("https://") {
        Some(rest) => !rest.contains(char::is_whitespace),
        None => !target.starts_with("//") && target.chars().all(is_plain),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Texts, Problem> {
        let lines: Vec<&str> = text.lines().collect();
        Texts::read("A step", &lines, 1).map_err(|error| error.problem)
    }

    #[test]
    fn hints_are_block_quotes() {
        let texts = read("\nTurn it.\n\nAll of it.\n\n> First\n> line.\n\n> Second.\n").expect("texts");
        assert_eq!(texts.task, "Turn it.\n\nAll of it.");
        assert_eq!(texts.hints, ["First line.", "Second."]);
        let four = "Task.\n> a\n\n> b\n\n> c\n\n> d\n";
        assert_eq!(read(four), Err(Problem::TooMany { part: Part::Hints, count: 4, most: 3 }));
        assert_eq!(read("> only a hint"), Err(Problem::NoText));
    }

    #[test]
    fn scripts_in_every_shape_are_refused() {
        for text in
            ["<script>alert(1)</script>", "a <img src=x onerror=y>", "</p>", "<!-- c -->", "`<b>`", "<?x"]
        {
            assert_eq!(read(text), Err(Problem::Html), "{text}");
        }
        for text in [
            "[a](javascript:alert(1))",
            "[a](JaVaScript:x)",
            "[a](data:text/html,x)",
            "[a](//host)",
            "[a](&#106;avascript:x)",
            "[a]: javascript:x",
            "![a](http://host/x.png)",
        ] {
            assert_eq!(read(text), Err(Problem::Link), "{text}");
        }
        assert_eq!(read("a\u{202e}b"), Err(Problem::ControlCharacter));
        for text in ["a < b and 3<4", "[G90](../manual/en/g90.html#form)", "[a](https://host/page)"] {
            assert!(read(text).is_ok(), "{text}");
        }
    }

    #[test]
    fn lengths_are_limited() {
        let long = "a".repeat(LONGEST_TASK + 1);
        let most = Problem::TooMany { part: Part::Task, count: LONGEST_TASK + 1, most: LONGEST_TASK };
        assert_eq!(read(&long), Err(most));
        let hint = format!("Task.\n> {}", "a".repeat(LONGEST_HINT + 1));
        let most = Problem::TooMany { part: Part::Hint, count: LONGEST_HINT + 1, most: LONGEST_HINT };
        assert_eq!(read(&hint), Err(most));
    }
}
