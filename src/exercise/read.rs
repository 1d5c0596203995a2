//! Reads an exercise file.
//!
//! In: the text of the file: a head, blocks of code `setup`, `gcode` and `target`, and a section for each language.
//! Out: an [`Exercise`], or the first fault with its line. Each part has a limit, so a file cannot exhaust memory.

use super::fault::{Part, Problem, ReadError, at_most};
use super::head::Head;
use super::target::Target;
use super::texts::Texts;
use super::{Exercise, Kind};
use crate::limits::Limits;
use crate::setup::Setup;
use crate::setup::notes::Notes;

/// Most bytes of a file, of its program and of its setup.
const MOST_BYTES: usize = 64 << 10;
const MOST_PROGRAM: usize = 16 << 10;
const MOST_SETUP: usize = 8 << 10;

/// The limits of the run of an answer: a class of answers is checked in seconds.
const LIMITS: Limits = Limits {
    text: 1 << 20,
    motions: 100_000,
    moves_per_cycle: 10_000,
    cycle_work: 200_000,
    repeated_blocks: 100_000,
    repeated_text: 2_000_000,
    rounds: 50_000,
    macro_steps: 200_000,
    call_depth: 10,
    macro_depth: 5,
    messages: 500,
    part_motions: 10_000,
    part_corners: 10_000,
    compared_blocks: 10_000,
    stride: 4096,
};

/// The blocks of code of a file, each with the line of its first line.
#[derive(Default)]
struct Blocks<'a> {
    setup: Option<Code<'a>>,
    gcode: Option<Code<'a>>,
    target: Option<Code<'a>>,
}

/// The lines of a block of code.
struct Code<'a> {
    lines: &'a [&'a str],
    /// Number of its first line, from 1.
    first: usize,
}

impl Code<'_> {
    fn text(&self) -> String {
        self.lines.iter().flat_map(|line| [line.trim_end(), "\n"]).collect()
    }
}

/// Reads a file.
pub(super) fn read(text: &str) -> Result<Exercise, ReadError> {
    at_most(Part::File, text.len(), MOST_BYTES, 1)?;
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let lines: Vec<&str> = text.lines().collect();
    let head = Head::read(&lines)?;
    let (blocks, end) = blocks(&lines, head.end)?;
    let texts = texts(&lines, end)?;
    let missing = |name| ReadError::at(1, Problem::Missing { name });
    let code = blocks.setup.ok_or(missing("setup"))?;
    let setup = setup(&code, &head)?;
    let outline = blocks.target.ok_or(missing("target"))?;
    let target = Target::read(outline.lines, head.tolerance, head.corners)
        .map_err(|(line, fault)| ReadError::at(outline.first + line, Problem::Target(fault)))?;
    Ok(Exercise {
        program: program(blocks.gcode, head.kind)?,
        id: head.id,
        kind: head.kind,
        points: head.points,
        chapter: head.chapter,
        setup,
        setup_text: code.text(),
        target,
        tolerance: head.tolerance,
        checks: head.checks,
        texts,
    })
}

/// The blocks of code from a line on, and the line at which the texts begin.
fn blocks<'a>(lines: &'a [&'a str], from: usize) -> Result<(Blocks<'a>, usize), ReadError> {
    let (mut blocks, mut at) = (Blocks::default(), from);
    while let Some(line) = lines.get(at) {
        if line.starts_with('#') {
            break;
        }
        if line.trim().is_empty() {
            at += 1;
            continue;
        }
        let name = line.strip_prefix("```").ok_or(ReadError::at(at + 1, Problem::StrayText))?.trim();
        let rest = &lines[at + 1..];
        let count = rest.iter().position(|line| line.trim_end() == "```");
        let count = count.ok_or(ReadError::at(at + 1, Problem::BlockOpen))?;
        blocks.put(name, Code { lines: &rest[..count], first: at + 2 }, at + 1)?;
        at += count + 2;
    }
    Ok((blocks, at))
}

impl<'a> Blocks<'a> {
    fn put(&mut self, name: &str, code: Code<'a>, line: usize) -> Result<(), ReadError> {
        let own = match name {
            "setup" => &mut self.setup,
            "gcode" => &mut self.gcode,
            "target" => &mut self.target,
            _ => {
                let name = name.chars().take(20).collect();
                return Err(ReadError::at(line, Problem::UnknownBlock { name }));
            }
        };
        match own.replace(code) {
            None => Ok(()),
            Some(_) => Err(ReadError::at(line, Problem::Twice { name: name.to_owned() })),
        }
    }
}

/// The sections of the languages, in the order English, Chinese, Russian.
fn texts(lines: &[&str], from: usize) -> Result<[Option<Texts>; 3], ReadError> {
    let mut all = [const { None }; 3];
    let heads: Vec<usize> = (from..lines.len()).filter(|&at| lines[at].starts_with("# ")).collect();
    if heads.first() != Some(&from) {
        return Err(ReadError::at(from + 1, Problem::NoText));
    }
    let ends = heads.iter().copied().skip(1).chain([lines.len()]);
    for (&at, end) in heads.iter().zip(ends) {
        let heading = lines[at][2..].split_once(':');
        let place = heading.and_then(|(tag, _)| ["en", "zh", "ru"].iter().position(|own| *own == tag.trim()));
        let (Some((tag, title)), Some(place)) = (heading, place) else {
            return Err(ReadError::at(at + 1, Problem::Heading));
        };
        let texts = Texts::read(title, &lines[at + 1..end], at + 1)?;
        if all[place].replace(texts).is_some() {
            return Err(ReadError::at(at + 1, Problem::Twice { name: tag.trim().to_owned() }));
        }
    }
    Ok(all)
}

/// The program that the learner starts with.
fn program(code: Option<Code>, kind: Kind) -> Result<String, ReadError> {
    let Some(code) = code else {
        let is_missing = kind.needs_program();
        let missing = ReadError::at(1, Problem::Missing { name: "gcode" });
        return if is_missing { Err(missing) } else { Ok(String::new()) };
    };
    let text = code.text();
    at_most(Part::Program, text.len(), MOST_PROGRAM, code.first)?;
    if text.contains(crate::source::is_unprintable) {
        return Err(ReadError::at(code.first, Problem::ControlCharacter));
    }
    Ok(text)
}

/// The setup of a block: JSON, or comments as in a program.
fn setup(code: &Code, head: &Head) -> Result<Setup, ReadError> {
    let text = code.text();
    at_most(Part::Setup, text.len(), MOST_SETUP, code.first)?;
    let written = if text.trim_start().starts_with('{') { from_json(&text) } else { from_notes(&text) };
    let fault = |problem| ReadError::at(code.first, problem);
    let mut setup = written.map_err(fault)?;
    setup.limits = LIMITS;
    setup.dialect.control = head.control.or(setup.dialect.control);
    let (setup, invalid) = setup.without_invalid_values();
    if let Some(value) = invalid.into_iter().next() {
        return Err(fault(Problem::SetupValue(Box::new(value.message()))));
    }
    if setup.stock.is_none() {
        return Err(fault(Problem::NoBlank));
    }
    Ok(setup)
}

fn from_json(text: &str) -> Result<Setup, Problem> {
    Setup::from_json(text.trim()).map_err(|reason| Problem::Setup { reason })
}

/// Reads comments such as `(STOCK D=30 LENGTH=60)`; each line is one.
fn from_notes(text: &str) -> Result<Setup, Problem> {
    let notes = Notes::read(text.as_bytes());
    let first = notes.diagnostics(Vec::new(), text.as_bytes()).into_iter().next();
    if let Some(fault) = first {
        return Err(Problem::SetupValue(Box::new(fault.message)));
    }
    let lines = text.lines().filter(|line| !line.trim().is_empty());
    let is_note = |line: &str| crate::setup::notes::is_note(line.trim().trim_matches(['(', ')']));
    if let Some(line) = lines.clone().find(|line| !is_note(line)) {
        return Err(Problem::Setup { reason: line.chars().take(80).collect() });
    }
    Ok(notes.applied_to(Setup::default()))
}
