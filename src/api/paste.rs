//! The rows of the programs found in a text: a list, and each of them as pieces to be shown.
//!
//! In: what was found. Out: rows in a language. What is left out is quoted short; what is kept and what
//! stands there now is whole, so that the text put together from a program's pieces is the cleaned program.

use serde::Serialize;

#[cfg(target_arch = "wasm32")]
use tsify::Tsify;

use crate::paste::{Found, Name, Program, Review};
use crate::sentences::Language;

/// Longest quotation of what was left out, characters.
const QUOTE: usize = 160;
/// Most pieces of a program that are shown one by one; the rest of it is one piece.
const MOST_PIECES: usize = 3_000;

/// The programs found in a text.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
#[serde(rename_all = "camelCase")]
pub struct FoundPrograms {
    /// In the order in which they stand.
    pub programs: Vec<FoundProgram>,
    /// How many more there are than are listed.
    pub more: u32,
    /// The text is longer than is looked through.
    pub too_long: bool,
    /// How much the reader has to see: nothing, that there are a few stray characters, or the programs.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "\"nothing\" | \"few-characters\" | \"programs\""))]
    pub review: &'static str,
}

/// A program found in a text.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
#[serde(rename_all = "camelCase")]
pub struct FoundProgram {
    /// Its number, `O0006`, or the text before it; empty where nothing names it.
    pub name: String,
    /// First and last line in the text, from 1.
    pub first_line: u32,
    /// The last of them.
    pub last_line: u32,
    /// How much was repaired or left out.
    pub changes: u32,
    /// How much the reader is to say.
    pub questions: u32,
}

/// A piece of a program found.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
#[serde(rename_all = "camelCase")]
pub struct FoundPiece {
    /// What stood there, cut short where it is long; empty where it stayed.
    pub was: String,
    /// What stands there now.
    pub now: String,
    /// Why; empty where it stayed.
    pub reason: String,
    /// What it can be read as, the first as printed; empty where nothing is asked.
    pub choices: Vec<String>,
}

impl FoundPrograms {
    /// The list.
    pub fn new(found: &Found) -> Self {
        Self {
            programs: found.programs.iter().map(FoundProgram::new).collect(),
            more: found.more as u32,
            too_long: found.too_long,
            review: match found.review {
                Review::Nothing => "nothing",
                Review::FewCharacters => "few-characters",
                Review::Programs => "programs",
            },
        }
    }
}

impl FoundProgram {
    fn new(program: &Program) -> Self {
        let name = match &program.name {
            Name::Number(number) => format!("O{number:04}"),
            Name::Title(title) => title.clone(),
            Name::Line(_) => String::new(),
        };
        Self {
            name,
            first_line: program.lines.0 + 1,
            last_line: program.lines.1 + 1,
            changes: program.changes().count() as u32,
            questions: program.questions().count() as u32,
        }
    }
}

/// The pieces of a program found in a text.
pub fn pieces(text: &str, program: &Program, language: Language) -> Vec<FoundPiece> {
    let mut rows: Vec<FoundPiece> = Vec::new();
    let (shown, rest) = program.pieces.split_at(program.pieces.len().min(MOST_PIECES));
    for piece in shown {
        let was = &text[piece.span.start as usize..piece.span.end as usize];
        rows.push(match piece.reason {
            None => FoundPiece {
                was: String::new(),
                now: piece.now.clone(),
                reason: String::new(),
                choices: vec![],
            },
            Some(reason) => FoundPiece {
                was: shortened(was),
                now: piece.now.clone(),
                reason: reason.phrase(language).into(),
                choices: piece.choices.clone(),
            },
        });
    }
    if !rest.is_empty() {
        let now = rest.iter().map(|piece| piece.now.as_str()).collect();
        rows.push(FoundPiece { was: String::new(), now, reason: String::new(), choices: vec![] });
    }
    rows
}

/// A quotation on one line, short.
pub fn shortened(text: &str) -> String {
    let words: Vec<&str> = text.split_whitespace().take(QUOTE).collect();
    let line = words.join(" ");
    match line.char_indices().nth(QUOTE) {
        None => line,
        Some((cut, _)) => format!("{}…", line[..cut].trim_end()),
    }
}
