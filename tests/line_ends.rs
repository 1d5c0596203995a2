//! A program gives the same result with every line end (LF, CR LF, CR, `;`) and in lower case: motions,
//! tools, part and messages, each at its block.

use crate::fixtures;
use gcode_playground::api;
use gcode_playground::machine::resolved_setup::ResolvedTool;
use gcode_playground::motion::Motion;
use gcode_playground::run::Analysis;
use gcode_playground::sentences::Language;
use gcode_playground::setup::Setup;
use gcode_playground::text::block::Block;
use gcode_playground::text::parser::Parser;
use gcode_playground::{analyze, run::Run};

/// The result of a program, with block numbers as positions.
#[derive(Debug, PartialEq)]
struct Outcome {
    motions: Vec<(usize, Motion)>,
    messages: Vec<(usize, &'static str, String)>,
    tools: Vec<ResolvedTool>,
    part: String,
}

/// The block that contains a byte; empty blocks and line ends do not count.
fn block_of(starts: &[u32], byte: u32) -> usize {
    starts.partition_point(|&start| start <= byte)
}

fn starts(text: &[u8]) -> Vec<u32> {
    let (mut parser, mut block, mut starts) = (Parser::new(text), Block::default(), Vec::new());
    while parser.next_block(&mut block) {
        if !block.is_empty() || block.sequence.is_some() || !block.comments.is_empty() {
            starts.push(block.span.start);
        }
    }
    starts
}

fn outcome(text: &str, setup: &Setup, has_sentences: bool) -> (Outcome, Analysis) {
    let mut run = Run::new(text.as_bytes().to_vec(), setup.clone());
    while !run.advance(usize::MAX) {}
    let mut analysis = run.into_analysis();
    analysis.check_at_machine();
    let starts = starts(text.as_bytes());
    let motions = (0..analysis.motions.len())
        .map(|at| (block_of(&starts, analysis.motions.span(at).start), analysis.motions.get(at)))
        .collect();
    let messages = analysis.diagnostics.iter().map(|found| {
        let sentence = if has_sentences { found.sentence(Language::English).message } else { String::new() };
        (block_of(&starts, found.span.start), found.message.slug(), sentence)
    });
    let finished = analysis.simulate().finished();
    let part = finished.map(|region| serde_json::to_string(&api::Part::new(&region)).expect("JSON"));
    let outcome = Outcome {
        motions,
        messages: messages.collect(),
        tools: analysis.resolved_setup().tools().cloned().collect(),
        part: part.unwrap_or_default(),
    };
    (outcome, analysis)
}

/// A text in lower case, except for its comments.
fn in_lower_case(text: &str) -> String {
    let mut depth = 0;
    let small = text.chars().map(|letter| {
        match letter {
            '(' => depth += 1,
            ')' => depth -= 1,
            '\n' => depth = 0,
            _ => {}
        }
        if depth > 0 { letter } else { letter.to_ascii_lowercase() }
    });
    small.collect()
}

#[track_caller]
fn same(name: &str, expected: &Outcome, text: &str, setup: &Setup, has_sentences: bool) {
    let (found, _) = outcome(text, setup, has_sentences);
    assert_eq!(found.messages, expected.messages, "messages of {name}\n{text}");
    assert_eq!(found.tools, expected.tools, "tools of {name}");
    assert!(found.motions == expected.motions, "motions of {name}");
    assert_eq!(found.part, expected.part, "part of {name}");
}

/// A program whose grooving insert is 5 mm wide; only a comment states it.
const GROOVE: &str = "O1\nT0101 (TURNING R0.8)\nG97 S500 M03\nG00 X38 Z2\nG01 Z-5 F0.1\nG00 X100 Z100\nT0303 (GROOVE W=5)\nG00 X40 Z-10\nG01 X25 F0.1\nX40\nG00 X100\nM30\n";

#[test]
fn a_program_does_not_depend_on_its_line_ends() {
    let mut semicolons = 0;
    let groove = (GROOVE.to_owned(), "{}".to_owned(), "a groove".to_owned());
    let programs = fixtures::all().into_iter().map(|program| (program.text, program.setup, program.id));
    for (text, setup, id) in programs.chain([groove]) {
        let text = text.replace("\r\n", "\n").replace('\r', "\n");
        let setup = Setup::from_json(&setup).expect("a setup");
        let (expected, analysis) = outcome(&text, &setup, true);
        for (name, end) in [("CR LF", "\r\n"), ("CR", "\r")] {
            same(&format!("{id} with {name}"), &expected, &text.replace('\n', end), &setup, true);
        }
        // A `;` ends neither a comment nor a line with `%`, and text after it is reported as a remark.
        let is_plain =
            !text.contains([';', '%']) && !analysis.diagnostics.iter().any(|found| found.is_error());
        if is_plain {
            semicolons += 1;
            same(&format!("{id} with semicolons"), &expected, &text.replace('\n', ";"), &setup, true);
        }
    }
    assert!(semicolons > 10, "{semicolons}");
}

#[test]
fn a_program_does_not_depend_on_the_case_of_its_letters() {
    let groove = (GROOVE.to_owned(), "{}".to_owned(), "a groove".to_owned());
    let programs = fixtures::all().into_iter().map(|program| (program.text, program.setup, program.id));
    for (text, setup, id) in programs.chain([groove]) {
        let setup = Setup::from_json(&setup).expect("a setup");
        let (expected, _) = outcome(&text, &setup, false);
        same(&format!("{id} in lower case"), &expected, &in_lower_case(&text), &setup, false);
    }
}

/// The groove is as wide as the comment states, with any line end. Without the comment, a 3 mm insert is
/// assumed.
#[test]
fn a_comment_names_the_tool_of_its_own_line() {
    for end in ["\n", "\r\n", "\r", ";"] {
        for text in [GROOVE.replace('\n', end), in_lower_case(GROOVE).replace('\n', end)] {
            let analysis = analyze(text.as_bytes(), &Setup::default());
            let tools = analysis.resolved_setup().tools();
            let widths: Vec<_> = tools.filter_map(|own| Some((own.station, own.tool.width?))).collect();
            assert_eq!(widths, [(3, 5.0)], "{text:?}");
        }
    }
}
