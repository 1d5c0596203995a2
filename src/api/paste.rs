//! Rows for the programs found in a text: a list, and the pieces of each program.
//!
//! In: the programs found. Out: rows in a language. Omitted text is shortened; the kept and the new text is
//! complete, so that the pieces of a program together give the cleaned program.

use serde::Serialize;

#[cfg(target_arch = "wasm32")]
use tsify::Tsify;

use crate::paste::{Found, Name, Program, Review};
use crate::sentences::Language;

/// Maximum length of quoted text that was omitted, characters.
const QUOTE: usize = 160;
/// Maximum number of pieces shown separately; the rest of the program is one piece.
const MAX_PIECES: usize = 3_000;

/// The programs found in a text.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
#[serde(rename_all = "camelCase")]
pub struct FoundPrograms {
    /// The programs, in text order.
    pub programs: Vec<FoundProgram>,
    /// Number of programs that are not listed.
    pub more: u32,
    /// Whether the text was too long to be searched completely.
    pub too_long: bool,
    /// What the user has to review: nothing, a few stray characters, or the programs.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "\"nothing\" | \"few-characters\" | \"programs\""))]
    pub review: &'static str,
}

/// A program found in a text.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
#[serde(rename_all = "camelCase")]
pub struct FoundProgram {
    /// Its number, `O0006`, or the title before it; empty if it has neither.
    pub name: String,
    /// First line in the text, from 1.
    pub first_line: u32,
    /// Last line in the text.
    pub last_line: u32,
    /// Number of repairs and omissions.
    pub changes: u32,
    /// Number of pieces that the user has to decide on.
    pub questions: u32,
}

/// A piece of a found program.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
#[serde(rename_all = "camelCase")]
pub struct FoundPiece {
    /// The original text, shortened if it is long; empty if it was not changed.
    pub was: String,
    /// The new text.
    pub now: String,
    /// The reason for the change; empty if it was not changed.
    pub reason: String,
    /// The possible readings, the printed one first; empty if there is no choice.
    pub choices: Vec<String>,
}

impl FoundPrograms {
    /// The rows of the found programs.
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

/// The pieces of a found program.
pub fn pieces(text: &str, program: &Program, language: Language) -> Vec<FoundPiece> {
    let mut rows: Vec<FoundPiece> = Vec::new();
    let (shown, rest) = program.pieces.split_at(program.pieces.len().min(MAX_PIECES));
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

/// A quotation on one line, shortened.
pub fn shortened(text: &str) -> String {
    let words: Vec<&str> = text.split_whitespace().take(QUOTE).collect();
    let line = words.join(" ");
    match line.char_indices().nth(QUOTE) {
        None => line,
        Some((cut, _)) => format!("{}…", line[..cut].trim_end()),
    }
}
