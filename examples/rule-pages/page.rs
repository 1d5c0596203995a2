//! A rule's page as it is written: `src/diagnostics/pages/<slug>.md`.
//!
//! In: the text of the file. Out: its parts, or all that is wrong with it. `README.md` tells the format. Must not know: what
//! a program does, or what becomes of the page.

use std::fs;
use std::path::{Path, PathBuf};

use gcode_playground::diagnostics::messages::Language;

/// A page, in its parts.
#[derive(Clone, Debug)]
pub struct Page {
    /// The rule.
    pub slug: String,
    /// The setup of both programs, JSON.
    pub setup: String,
    /// Whether the repairs that are offered make `right` of `wrong`.
    pub is_fixed: bool,
    /// Whether the message stands at no place of the text.
    pub is_placeless: bool,
    /// What is stopped from outside, so that the message is told.
    pub stop: Option<Stop>,
    /// Further rules that speak in `wrong`.
    pub also: Vec<String>,
    /// A program the rule speaks in.
    pub wrong: String,
    /// The places it speaks of, in order.
    pub marks: Vec<Mark>,
    /// Whether the line before was indented.
    is_indented: bool,
    /// The same, repaired.
    pub right: String,
    /// What is said of the rule, in the order of `Language::ALL`.
    pub texts: [Text; 3],
}

/// What somebody stops while it is under way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// The run of the program.
    Run,
    /// The taking off of material.
    Part,
}

/// Characters of one line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Mark {
    /// From 0.
    pub line: usize,
    /// The first one, from 0.
    pub column: usize,
    /// How many.
    pub length: usize,
}

/// What is said of a rule in one language.
#[derive(Clone, Debug, Default)]
pub struct Text {
    /// Names the fault.
    pub title: String,
    /// What the rule looks at.
    pub what: String,
    /// What would happen at the machine.
    pub why: String,
    /// What to do.
    pub repair: String,
}

/// Blanks in front of a line of a program, so that carets below it have room behind `//`. They are no part of it.
pub const INDENT: &str = "   ";

/// Most characters of a title.
const MOST_TITLE: usize = 60;

/// The folder of the pages.
pub fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src/diagnostics/pages")
}

/// All pages by the names of their files, in order: each read, or what is wrong with it.
pub fn all() -> Vec<(String, Result<Page, Vec<String>>)> {
    let files = fs::read_dir(folder()).expect("the folder of the pages");
    let mut paths: Vec<PathBuf> = files.map(|file| file.expect("a file").path()).collect();
    paths.retain(|path| path.extension().is_some_and(|kind| kind == "md") && !path.ends_with("README.md"));
    paths.sort();
    paths
        .into_iter()
        .map(|path| {
            let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
            let text = fs::read_to_string(&path).map_err(|error| vec![error.to_string()]);
            let page = text.and_then(|text| Page::read(&text)).and_then(|page| match page.slug == name {
                true => Ok(page),
                false => Err(vec![format!("its heading is `{}`", page.slug)]),
            });
            (name, page)
        })
        .collect()
}

/// A paragraph of a text.
type Field = fn(&mut Text) -> &mut String;

/// Where the reading of a page is.
#[derive(Clone, Copy)]
enum Part {
    Head,
    Wrong,
    Right,
    Text(usize),
}

impl Page {
    /// Reads a page, or says all that is wrong with it.
    pub fn read(text: &str) -> Result<Self, Vec<String>> {
        let mut page = Self {
            slug: String::new(),
            setup: "{}".to_owned(),
            is_fixed: false,
            is_placeless: false,
            stop: None,
            also: Vec::new(),
            wrong: String::new(),
            marks: Vec::new(),
            is_indented: false,
            right: String::new(),
            texts: Default::default(),
        };
        let (mut part, mut slips) = (Part::Head, Vec::new());
        // The paragraph under way; a line without a keyword goes on with it.
        let mut field = None::<Field>;
        for (number, line) in text.lines().enumerate() {
            let mut slip = |what: &str| slips.push(format!("line {}: {what}: {line}", number + 1));
            match part {
                Part::Wrong | Part::Right if line.trim_end() == "```" => part = Part::Head,
                Part::Wrong => page.program_line(line, &mut slip),
                Part::Right if marks_of(line).is_some() => slip("nothing is marked in what is right"),
                Part::Right => page.right.extend([unindented(line), "\n"]),
                Part::Head if line == "```wrong" => part = Part::Wrong,
                Part::Head if line == "```right" => part = Part::Right,
                Part::Head | Part::Text(_) if line.starts_with("## ") => match heading(line) {
                    Some((index, title)) => {
                        (part, field) = (Part::Text(index), None);
                        page.texts[index].title = title.to_owned();
                    }
                    None => slip("not `## en: …`, `## zh: …` or `## ru: …`"),
                },
                Part::Head if !line.trim().is_empty() => page.head_line(line, &mut slip),
                Part::Text(_) if line.trim().is_empty() => field = None,
                Part::Text(index) => {
                    let keywords: [(_, Field); 3] = [
                        ("What:", |text| &mut text.what),
                        ("Why:", |text| &mut text.why),
                        ("Repair:", |text| &mut text.repair),
                    ];
                    let begun = keywords
                        .into_iter()
                        .find_map(|(word, field)| Some((line.strip_prefix(word)?, field)));
                    let said = begun.map_or(line, |(rest, begun)| {
                        field = Some(begun);
                        rest
                    });
                    match field {
                        Some(field) => append(field(&mut page.texts[index]), said.trim()),
                        None => slip("a paragraph begins with `What:`, `Why:` or `Repair:`"),
                    }
                }
                Part::Head => {}
            }
        }
        page.look_over(&mut slips);
        if slips.is_empty() { Ok(page) } else { Err(slips) }
    }

    /// What it says in a language.
    pub fn text(&self, language: Language) -> &Text {
        let index = Language::ALL.iter().position(|known| *known == language);
        &self.texts[index.unwrap_or_default()]
    }

    fn head_line(&mut self, line: &str, slip: &mut impl FnMut(&str)) {
        if let Some(slug) = line.strip_prefix("# ") {
            self.slug = slug.trim().to_owned();
            return;
        }
        let (key, value) = line.split_once(':').unwrap_or((line, ""));
        match (key, value.trim()) {
            ("setup", json) => self.setup = json.to_owned(),
            ("fix", "yes") => self.is_fixed = true,
            ("placeless", "yes") => self.is_placeless = true,
            ("stop", "run") => self.stop = Some(Stop::Run),
            ("stop", "part") => self.stop = Some(Stop::Part),
            ("also", slugs) => self.also.extend(slugs.split(',').map(|slug| slug.trim().to_owned())),
            _ => slip("not understood"),
        }
    }

    fn program_line(&mut self, line: &str, slip: &mut impl FnMut(&str)) {
        match (marks_of(line), self.wrong.lines().count().checked_sub(1)) {
            (None, _) => {
                self.wrong.extend([unindented(line), "\n"]);
                self.is_indented = line.starts_with(INDENT);
            }
            (Some(_), None) => slip("no line to mark"),
            (Some(columns), Some(line)) => {
                let indent = if self.is_indented { INDENT.len() } else { 0 };
                for (column, length) in columns {
                    match column.checked_sub(indent) {
                        Some(column) => self.marks.push(Mark { line, column, length }),
                        None => slip("the blanks in front are no part of the program"),
                    }
                }
            }
        }
    }

    /// Says what is missing.
    fn look_over(&mut self, slips: &mut Vec<String>) {
        self.marks.sort_unstable();
        // The last line of a program needs no end.
        for program in [&mut self.wrong, &mut self.right] {
            program.truncate(program.trim_end_matches('\n').len());
        }
        if self.slug.is_empty() {
            slips.push("no heading `# slug`".to_owned());
        }
        if self.right == self.wrong {
            slips.push("`wrong` and `right` are the same".to_owned());
        }
        if self.is_placeless != self.marks.is_empty() {
            slips.push("marks are needed, or else `placeless: yes`".to_owned());
        }
        for (language, text) in Language::ALL.iter().zip(&self.texts) {
            let tag = language.tag();
            let Text { title, what, why, repair } = text;
            for (name, said) in [("title", title), ("What:", what), ("Why:", why), ("Repair:", repair)] {
                if said.is_empty() {
                    slips.push(format!("{tag}: no {name}"));
                }
                if said.contains(['{', '}']) {
                    slips.push(format!("{tag}: {name} has a bracket of a template"));
                }
                if said.matches('`').count() % 2 == 1 {
                    slips.push(format!("{tag}: {name} has a backtick without its other one"));
                }
            }
            if title.chars().count() > MOST_TITLE {
                slips.push(format!("{tag}: the title has more than {MOST_TITLE} characters"));
            }
        }
    }
}

/// A line of a program without the blanks that make room for carets.
fn unindented(line: &str) -> &str {
    line.strip_prefix(INDENT).unwrap_or(line)
}

/// The first columns and lengths of the carets of a line that is nothing but `//` and carets.
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
    let index = Language::ALL.iter().position(|language| language.tag() == tag)?;
    Some((index, title.trim()))
}

/// Adds a line to a paragraph: with a blank, except between two Chinese characters.
fn append(paragraph: &mut String, line: &str) {
    let is_wide = |letter: Option<char>| letter.is_some_and(|letter| letter >= '\u{2e80}');
    let together = is_wide(paragraph.chars().next_back()) && is_wide(line.chars().next());
    if !paragraph.is_empty() && !together {
        paragraph.push(' ');
    }
    paragraph.push_str(line);
}
