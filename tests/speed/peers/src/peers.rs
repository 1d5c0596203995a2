//! Crates that read G-code, each used as its documentation shows.

use async_gcode::{Error, GCode, Parser};
use futures_util::stream;
use gcode::core::{
    BlockVisitor, CommandVisitor, ControlFlow, Diagnostics, HasDiagnostics, Noop, Number, ProgramVisitor,
    Span, Value,
};

use crate::Outcome;

/// Runs the named peer.
pub fn run(name: &str, text: Vec<u8>) -> Option<Outcome> {
    // The peers take text, and some keep slices of it.
    let text: &'static str = String::from_utf8(text).ok()?.leak();
    Some(match name {
        "gcode" => motions(text),
        "async-gcode" => words(text),
        "nom-gcode" => {
            let line = |line| nom_gcode::parse_gcode(line).ok().and_then(|(_, found)| found);
            Outcome::new(text.lines().filter_map(line).collect())
        }
        "gcode-nom" => {
            let line = |line| gcode_nom::command::Command::parse_line(line).ok().map(|(_, found)| found);
            Outcome::new(text.lines().filter_map(line).collect())
        }
        _ => return None,
    })
}

/// `async-gcode`: a stream of words, polled to its end.
fn words(text: &'static str) -> Outcome {
    let bytes = stream::iter(text.bytes().map(Ok::<u8, Error>));
    Outcome::new(futures_executor::block_on(async {
        let mut parser = Parser::new(bytes);
        let mut found: Vec<GCode> = Vec::new();
        while let Some(word) = parser.next().await {
            found.extend(word.ok());
        }
        found
    }))
}

/// `gcode`: its visitor, with the minimum that a user adds to get motions.
fn motions(text: &str) -> Outcome {
    let mut lathe = Lathe::default();
    gcode::core::parse(text, &mut lathe);
    Outcome::new(lathe.moves)
}

/// Motion, X, Z, R and F of each block that moves.
type Move = (u8, f64, f64, f64, f64);

#[derive(Default)]
struct Lathe {
    motion: u8,
    x: f64,
    z: f64,
    radius: f64,
    feed: f64,
    moved: bool,
    moves: Vec<Move>,
}

impl Lathe {
    fn word(&mut self, letter: char, value: &Value<'_>) {
        let Value::Literal(number) = *value else { return };
        let number = f64::from(number);
        match letter {
            'X' => (self.x, self.moved) = (number, true),
            'Z' => (self.z, self.moved) = (number, true),
            'R' => self.radius = number,
            'F' => self.feed = number,
            _ => {}
        }
    }
}

impl Diagnostics for Lathe {}

impl ProgramVisitor for Lathe {
    fn start_block(&mut self) -> ControlFlow<impl BlockVisitor + '_> {
        ControlFlow::Continue(InBlock(self))
    }
}

struct InBlock<'a>(&'a mut Lathe);

impl HasDiagnostics for InBlock<'_> {
    fn diagnostics(&mut self) -> &mut dyn Diagnostics {
        self.0
    }
}

impl BlockVisitor for InBlock<'_> {
    fn word_address(&mut self, letter: char, value: Value<'_>, _span: Span) {
        self.0.word(letter, &value);
    }

    fn start_general_code(&mut self, number: Number) -> ControlFlow<impl CommandVisitor + '_> {
        if number.major() < 4 {
            self.0.motion = number.major() as u8;
        }
        ControlFlow::Continue(InBlock(self.0))
    }

    fn start_miscellaneous_code(&mut self, _number: Number) -> ControlFlow<impl CommandVisitor + '_> {
        ControlFlow::Continue(Noop)
    }

    fn end_line(self, _span: Span) {
        let lathe = self.0;
        if std::mem::take(&mut lathe.moved) {
            let radius = std::mem::take(&mut lathe.radius);
            lathe.moves.push((lathe.motion, lathe.x, lathe.z, radius, lathe.feed));
        }
    }
}

impl CommandVisitor for InBlock<'_> {
    fn argument(&mut self, letter: char, value: Value<'_>, _span: Span) {
        self.0.word(letter, &value);
    }
}
