//! The page of a rule: its texts in all languages, a program that triggers the rule, and the corrected
//! program.

use super::{LANGUAGES, Mistake, Mistakes};

/// The texts and examples of a rule.
#[derive(Clone, Debug)]
pub struct Page {
    /// The setup of both programs, JSON.
    pub setup: String,
    /// Whether the suggested fixes change `wrong` to `right`.
    pub is_fixed: bool,
    /// Whether the message has no place in the text.
    pub is_placeless: bool,
    /// What the user stops to trigger the message.
    pub stop: Option<Stop>,
    /// Other rules that are triggered by `wrong`.
    pub also: Vec<String>,
    /// A program that triggers the rule.
    pub wrong: String,
    /// The places of its messages, sorted.
    pub marks: Vec<Mark>,
    /// The same program, corrected.
    pub right: String,
    /// The texts, in the order of `LANGUAGES`.
    pub texts: [Text; 3],
}

impl Default for Page {
    fn default() -> Self {
        Self {
            setup: "{}".to_owned(),
            is_fixed: false,
            is_placeless: false,
            stop: None,
            also: Vec::new(),
            wrong: String::new(),
            marks: Vec::new(),
            right: String::new(),
            texts: Default::default(),
        }
    }
}

/// The operation that the user stops while it is running.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// Running the program.
    Run,
    /// Material removal.
    Part,
}

/// A range of characters on one line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Mark {
    /// The line, from 0.
    pub line: usize,
    /// The first character, from 0.
    pub column: usize,
    /// The number of characters.
    pub length: usize,
}

/// The page in one language.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Text {
    /// The name of the fault.
    pub title: String,
    /// What the rule checks.
    pub what: String,
    /// The consequence at the machine.
    pub why: String,
    /// How to repair it.
    pub repair: String,
}

/// Indentation of a line of a program, to make room for `//` in the line of carets below it. It is not part
/// of the program.
pub const INDENT: &str = "   ";

/// Maximum length of a title, characters.
const MAX_TITLE: usize = 60;

/// Selects a paragraph of a text.
type Field = fn(&mut Text) -> &mut String;

/// The part that is being read.
#[derive(Clone, Copy, Default)]
enum Part {
    #[default]
    Examples,
    Wrong,
    Right,
    Text(usize),
}

/// Reads a page line by line.
#[derive(Default)]
pub(super) struct Reader {
    part: Part,
    /// The current paragraph; a line without a keyword continues it.
    field: Option<Field>,
    /// Whether the last line of a program was indented.
    is_indented: bool,
}

impl Reader {
    pub(super) fn is_in_program(&self) -> bool {
        matches!(self.part, Part::Wrong | Part::Right)
    }

    pub(super) fn heading(&mut self, line: &str, page: &mut Page, mistakes: &mut Mistakes) {
        if line.trim_end() == "## examples" {
            self.part = Part::Examples;
            return;
        }
        match heading(line) {
            Some((index, title)) => {
                (self.part, self.field) = (Part::Text(index), None);
                title.clone_into(&mut page.texts[index].title);
            }
            None => mistakes.add(format!(
                "not `## message Name`, `## examples`, `## en: …`, `## zh: …` or `## ru: …`: {line}"
            )),
        }
    }

    pub(super) fn read_line(&mut self, line: &str, page: &mut Page, mistakes: &mut Mistakes) {
        match self.part {
            Part::Wrong | Part::Right if line.trim_end() == "```" => self.part = Part::Examples,
            Part::Wrong => self.wrong_line(line, page, mistakes),
            Part::Right if marks_of(line).is_some() => mistakes.add("nothing is marked in `right`"),
            Part::Right => page.right.extend([unindented(line), "\n"]),
            Part::Examples if line == "```wrong" => self.part = Part::Wrong,
            Part::Examples if line == "```right" => self.part = Part::Right,
            Part::Examples if !line.trim().is_empty() => option(line, page, mistakes),
            Part::Examples => {}
            Part::Text(_) if line.trim().is_empty() => self.field = None,
            Part::Text(index) => self.text_line(line, &mut page.texts[index], mistakes),
        }
    }

    fn text_line(&mut self, line: &str, text: &mut Text, mistakes: &mut Mistakes) {
        let keywords: [(_, Field); 3] = [
            ("What:", |text| &mut text.what),
            ("Why:", |text| &mut text.why),
            ("Repair:", |text| &mut text.repair),
        ];
        let begun = keywords.into_iter().find_map(|(word, field)| Some((line.strip_prefix(word)?, field)));
        let said = begun.map_or(line, |(rest, begun)| {
            self.field = Some(begun);
            rest
        });
        match self.field {
            Some(field) => append(field(text), said.trim()),
            None => mistakes.add(format!("a paragraph begins with `What:`, `Why:` or `Repair:`: {line}")),
        }
    }

    fn wrong_line(&mut self, line: &str, page: &mut Page, mistakes: &mut Mistakes) {
        match (marks_of(line), page.wrong.lines().count().checked_sub(1)) {
            (None, _) => {
                page.wrong.extend([unindented(line), "\n"]);
                self.is_indented = line.starts_with(INDENT);
            }
            (Some(_), None) => mistakes.add("no line to mark"),
            (Some(columns), Some(line)) => {
                let indent = if self.is_indented { INDENT.len() } else { 0 };
                for (column, length) in columns {
                    match column.checked_sub(indent) {
                        Some(column) => page.marks.push(Mark { line, column, length }),
                        None => mistakes.add("the blanks in front are no part of the program"),
                    }
                }
            }
        }
    }
}

/// Reads an option of the examples.
fn option(line: &str, page: &mut Page, mistakes: &mut Mistakes) {
    let (key, value) = line.split_once(':').unwrap_or((line, ""));
    match (key, value.trim()) {
        ("setup", json) => json.clone_into(&mut page.setup),
        ("fix", "yes") => page.is_fixed = true,
        ("placeless", "yes") => page.is_placeless = true,
        ("stop", "run") => page.stop = Some(Stop::Run),
        ("stop", "part") => page.stop = Some(Stop::Part),
        ("also", slugs) => page.also.extend(slugs.split(',').map(|slug| slug.trim().to_owned())),
        _ => mistakes.add(format!("not understood: {line}")),
    }
}

impl Page {
    /// Uses the English texts for languages without texts; returns what was missing.
    pub(super) fn fill_in_english(&mut self) -> Vec<Mistake> {
        let [english, others @ ..] = &mut self.texts;
        let missing = others.iter_mut().zip(&LANGUAGES[1..]).filter(|(text, _)| **text == Text::default());
        missing
            .map(|(text, tag)| {
                text.clone_from(english);
                Mistake { line: 1, what: format!("no `## {tag}: …`") }
            })
            .collect()
    }
}

/// Checks that nothing is missing.
pub(super) fn check(page: &mut Page, mistakes: &mut Mistakes) {
    page.marks.sort_unstable();
    // The last line of a program needs no line end.
    for program in [&mut page.wrong, &mut page.right] {
        program.truncate(program.trim_end_matches('\n').len());
    }
    if page.right == page.wrong {
        mistakes.add("`wrong` and `right` are the same");
    }
    if page.is_placeless != page.marks.is_empty() {
        mistakes.add("marks are needed, or else `placeless: yes`");
    }
    for (tag, text) in LANGUAGES.iter().zip(&page.texts) {
        let Text { title, what, why, repair } = text;
        for (name, said) in [("title", title), ("What:", what), ("Why:", why), ("Repair:", repair)] {
            if said.is_empty() {
                mistakes.add(format!("{tag}: no {name}"));
            }
            if said.contains(['{', '}']) {
                mistakes.add(format!("{tag}: {name} has a bracket of a template"));
            }
            if said.matches('`').count() % 2 == 1 {
                mistakes.add(format!("{tag}: {name} has a backtick without its other one"));
            }
        }
        if title.chars().count() > MAX_TITLE {
            mistakes.add(format!("{tag}: the title has more than {MAX_TITLE} characters"));
        }
    }
}

/// Removes the indentation that makes room for carets.
fn unindented(line: &str) -> &str {
    line.strip_prefix(INDENT).unwrap_or(line)
}

/// The columns and lengths of the carets, if a line consists of `//` and carets.
fn marks_of(line: &str) -> Option<Vec<(usize, usize)>> {
    let carets = line.strip_prefix("//")?;
    if !carets.contains('^') || carets.contains(|letter| letter != '^' && letter != ' ') {
        return None;
    }
    let mut marks: Vec<(usize, usize)> = Vec::new();
    for (column, _) in line.match_indices('^') {
        match marks.last_mut() {
            Some((from, length)) if *from + *length == column => *length += 1,
            _ => marks.push((column, 1)),
        }
    }
    Some(marks)
}

/// Language and title of `## en: Title`.
fn heading(line: &str) -> Option<(usize, &str)> {
    let (tag, title) = line.strip_prefix("## ")?.split_once(':')?;
    let index = LANGUAGES.iter().position(|language| *language == tag)?;
    Some((index, title.trim()))
}

/// Appends a line to a paragraph, with a blank in between unless both characters are Chinese.
fn append(paragraph: &mut String, line: &str) {
    let is_wide = |letter: Option<char>| letter.is_some_and(|letter| letter >= '\u{2e80}');
    let together = is_wide(paragraph.chars().next_back()) && is_wide(line.chars().next());
    if !paragraph.is_empty() && !together {
        paragraph.push(' ');
    }
    paragraph.push_str(line);
}
