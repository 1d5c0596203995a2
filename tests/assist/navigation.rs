//! The outline of a text, foldable ranges, and the uses of a number.

use gcode_playground::api::Places;
use gcode_playground::api::assist::Reader;
use gcode_playground::assist::names::{Name, computed, names};
use gcode_playground::assist::uses::{all, first_computed};
use gcode_playground::sentences::Language;
use gcode_playground::setup::dialect::CodeList;
use gcode_playground::source::LineIndex;
use gcode_playground::text::block::Block;
use gcode_playground::text::parser::{Parser, Resume};
use gcode_playground::units::Unit;
use proptest::prelude::*;

use crate::random_programs::program;

const SHAFT: &str = "\
O0001 (SHAFT)
(STOCK D50 L80)
G21 G40
(ROUGH OUTSIDE)
T0101
G96 S180 M03
G00 X52 Z2
G71 U2 R1
G71 P10 Q20 U0.4 W0.1 F0.25
N10 G00 X20
G01 Z-20
N20 X52
(FINISH)
(TWO SPARK PASSES)
G70 P10 Q20
G00 X100 Z100 T0100
N7 T0303 (THREAD)
#1=0
WHILE [#1 LT 3] DO1
G90 X[50-#1] Z-5
#1=#1+1
END1
M98 P32000
GOTO 99
N99 M30
O2000
N10 G01 W-1
M99
";

fn with<R>(text: &str, language: Language, ask: impl FnOnce(&Reader) -> R) -> R {
    let lines = LineIndex::new(text.as_bytes());
    let places = Places { text: text.as_bytes(), lines: &lines };
    ask(&Reader { places, language, unit: Unit::Millimetre })
}

#[test]
fn the_outline_has_programs_tools_operations_cycles_and_blocks_that_are_named() {
    let outline = with(SHAFT, Language::English, |reader| reader.outline(CodeList::A));
    let rows = outline.entries.iter().map(|own| {
        let indent = "  ".repeat(own.depth.into());
        format!("{} {indent}{} {} ({})", own.line, own.kind, own.name, own.detail)
    });
    let expected = "\
1 program O0001 (SHAFT)
5   tool T0101 (ROUGH OUTSIDE)
9     cycle G71 P10 Q20 U0.4 W0.1 F0.25 (rough turning, types I and II)
10     block N10 G00 X20 ()
12     block N20 X52 ()
13     operation FINISH ()
15     cycle G70 P10 Q20 (finishing along the contour)
17   tool T0303 (THREAD)
20     cycle G90 X[50-#1] Z-5 (turning cycle, straight or taper)
25     block N99 M30 ()
26 program O2000 ()
27   block N10 G01 W-1 ()";
    assert_eq!(rows.collect::<Vec<_>>().join("\n"), expected);
    assert!(!outline.cut);
}

#[test]
fn programs_tools_contours_and_loops_can_be_folded() {
    let outline = with(SHAFT, Language::English, |reader| reader.outline(CodeList::A));
    let line = |offset: u32| SHAFT[..offset as usize].matches('\n').count() + 1;
    let lines: Vec<_> = outline.folds.iter().map(|&(from, to)| (line(from), line(to))).collect();
    assert_eq!(lines, [(1, 25), (5, 16), (9, 12), (17, 25), (19, 22), (26, 28)]);
}

/// The uses of the number at the mark as `line:word`, with a star at definitions; and the line to which
/// navigation jumps.
fn places(text: &str) -> Option<(String, Vec<String>, u32)> {
    let byte = text.find("$0").expect("a mark") as u32;
    let text = text.replace("$0", "");
    let uses = with(&text, Language::English, |reader| reader.uses(CodeList::A, byte))?;
    let place = |own: &gcode_playground::api::assist::Use| {
        let star = if own.defines { "*" } else { "" };
        format!("{}:{}{star}", own.line, &text[own.from as usize..own.to as usize])
    };
    let next = uses.places[uses.next as usize].line;
    Some((uses.name, uses.places.iter().map(place).collect(), next))
}

fn at(word: &str, offset: usize) -> String {
    let mut text = SHAFT.to_owned();
    text.insert_str(SHAFT.find(word).expect(word) + offset, "$0");
    text
}

#[test]
fn a_number_leads_to_its_block_and_back() {
    let uses = |list: &[&str]| list.iter().map(|own| (*own).to_owned()).collect::<Vec<_>>();
    let contour = uses(&["9:P10", "10:N10*", "15:P10"]);
    // N10 of the other program is another block.
    assert_eq!(places(&at("P10 Q20 U", 1)), Some(("N10".into(), contour.clone(), 10)));
    assert_eq!(places(&at("N10 G00", 0)), Some(("N10".into(), contour, 15)));
    let other = places(&at("N10 G01", 2)).expect("a number");
    assert_eq!(other.1, ["27:N10*"]);
    assert_eq!(places(&at("99\nN99", 1)), Some(("N99".into(), uses(&["24:99", "25:N99*"]), 25)));
    // P32000 calls O2000 three times.
    let called = uses(&["23:P32000", "26:O2000*"]);
    assert_eq!(places(&at("P32000", 3)), Some(("O2000".into(), called.clone(), 26)));
    assert_eq!(places(&at("O2000", 0)), Some(("O2000".into(), called, 23)));
    let variable = uses(&["18:#1*", "19:#1", "20:#1", "21:#1*", "21:#1"]);
    assert_eq!(places(&at("#1 LT", 1)), Some(("#1".into(), variable, 20)));
    assert_eq!(places(&at("X52 Z2", 1)), None, "a coordinate is no name");
}

#[test]
fn the_name_of_a_program_leads_to_it() {
    let text = "<MAIN>\nN10 G0 X1\nM98 <SUB-1>\nM98 P7\nM30\nO0007<sub-1>\nN10 M99\n";
    let at = |word: &str, offset: usize| {
        let mut marked = text.to_owned();
        marked.insert_str(text.find(word).expect(word) + offset, "$0");
        places(&marked).map(|(_, places, next)| (places, next))
    };
    let uses = |list: [&str; 2]| list.map(str::to_owned).to_vec();
    assert_eq!(at("<SUB-1>", 2), Some((uses(["3:<SUB-1>", "6:<sub-1>*"]), 6)));
    assert_eq!(at("<sub-1>", 2), Some((uses(["3:<SUB-1>", "6:<sub-1>*"]), 3)));
    assert_eq!(at("P7", 1), Some((uses(["4:P7", "6:O0007*"]), 6)));
    // A name begins a program: N10 of the other program is another block.
    assert_eq!(at("N10 M99", 0).map(|found| found.0), Some(vec!["7:N10*".to_owned()]));
}

#[test]
fn local_variables_are_those_of_their_program_and_a_return_goes_to_the_caller() {
    let text = "O1\n#1=5\n#100=#1\nM98 P2\nN50 M30\nO2\n#$01=6\n#100=7\nM99 P50\n";
    let (name, local, _) = places(text).expect("a variable");
    assert_eq!((name.as_str(), local), ("#1", vec!["7:#1*".to_owned()]));
    let (_, common, _) = places(&text.replace("$0", "").replacen("#100", "#$0100", 1)).expect("a variable");
    assert_eq!(common, ["3:#100*", "8:#100*"]);
    let (_, back, next) = places(&text.replace("$0", "").replace("P50", "P$050")).expect("a number");
    assert_eq!((back, next), (vec!["5:N50*".to_owned(), "9:P50".to_owned()], 5));
}

/// For every number of every seed and test program, its uses include its own position, and nothing panics.
#[test]
fn the_number_that_is_asked_about_is_among_its_uses() {
    let mut asked = 0;
    for program in crate::fixtures::all() {
        let text = &program.text;
        for (at, _) in text.match_indices(['N', 'P', 'Q', '#', 'O']) {
            let found = with(text, Language::English, |reader| reader.uses(CodeList::A, at as u32));
            let Some(uses) = found else { continue };
            asked += 1;
            let offset = text[..at].encode_utf16().count() as u32;
            assert!(uses.places.iter().any(|own| (own.from..=own.to).contains(&offset)), "{uses:?}");
            assert!((uses.next as usize) < uses.places.len());
        }
    }
    assert!(asked > 200, "{asked}");
}

/// A text with numbers in usual and unusual places.
fn numbered() -> impl Strategy<Value = String> {
    let letters = "[NOPQ#:;GXZT\\[\\]<>%().,+ \t\n\r\x1a/=-]|GOTO|IF|THEN|M98|G65|G71|M99|O<|外";
    let digits = "[0-9]|10|0010|110|1010|100000";
    prop::collection::vec(prop_oneof![2 => letters, 3 => digits], 0..60).prop_map(|pieces| pieces.concat())
}

proptest! {
    #[test]
    fn a_search_finds_what_reading_each_line_finds(
        text in prop_oneof![2 => numbered(), 1 => program()],
        name in prop_oneof![
            prop::sample::select(vec![0, 1, 5, 10, 110, 1010]).prop_map(Name::Sequence),
            prop::sample::select(vec![1, 10, 1000, 2000]).prop_map(Name::Program),
            prop::sample::select(vec![1, 10, 100, 110]).prop_map(Name::Variable),
        ],
    ) {
        let text = text.as_bytes();
        let lines = LineIndex::new(text);
        let (mut places, mut first) = (Vec::new(), None);
        let begin = text.iter().position(u8::is_ascii_alphanumeric).unwrap_or(text.len());
        let (mut program, mut has_begun) = (0, false);
        for line in 0..lines.len() {
            let span = lines.line(text, line);
            let mut parser = Parser::resume(&text[..span.end as usize], Resume::inside(span.start, 0));
            let mut block = Block::default();
            while parser.next_block(&mut block) {
                // The first program may lack a number.
                program += u32::from(block.program.is_some() && (has_begun || begin < span.start as usize));
                has_begun |= block.program.is_some() || !block.is_empty();
                let own = names(text, &block, CodeList::A).into_iter().filter(|named| named.name == name);
                places.extend(own.map(|named| (named, program)));
                first = first.or_else(|| computed(text, &block, CodeList::A).into_iter().next());
            }
        }
        prop_assert_eq!(all(text, CodeList::A, name), places);
        prop_assert_eq!(first_computed(text, CodeList::A, |_, _| true), first);
    }
}

#[test]
fn a_comment_of_the_setup_names_no_tool() {
    let names = |text: &str| {
        let lines = LineIndex::new(text.as_bytes());
        let places = Places { text: text.as_bytes(), lines: &lines };
        let reader = Reader { places, language: Language::English, unit: Unit::Millimetre };
        let entries = reader.outline(CodeList::A).entries;
        entries
            .into_iter()
            .map(|own| format!("{} {} ({})", own.kind, own.name, own.detail))
            .collect::<Vec<_>>()
    };
    let stock = "O0001\n(STOCK D=62 LENGTH=80)\nT0101\nG00 X60 Z2\nM30\n";
    assert_eq!(names(stock), ["program O0001 ()", "tool T0101 ()"]);
    let name_before = "O0001\n(ROUGH)\n(STOCK D=62 LENGTH=80)\nT0101\nG00 X60 Z2\nM30\n";
    assert_eq!(names(name_before), ["program O0001 ()", "tool T0101 (ROUGH)"]);
    let beside = "O0001\nT0303 (TOOL T0303 TYPE=THREADING)(THREAD)\nG00 X60 Z2\nM30\n";
    assert_eq!(names(beside), ["program O0001 ()", "tool T0303 (THREAD)"]);
    let later = "O0001\nT0101\nG00 X60 Z2\n(FINISH)\n(TOOL T0303 WIDTH=3)\nT0303\nG00 X60 Z2\nM30\n";
    assert_eq!(names(later), ["program O0001 ()", "tool T0101 ()", "tool T0303 (FINISH)"]);
}
