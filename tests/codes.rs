//! The table of supported codes: the one in the reference equals the registry, every row has its texts in
//! every language, and the interpreter recognises exactly the codes of the table.
//! `UPDATE_EXPECT=1 cargo test --test it codes::` writes it.
use std::collections::HashSet;
use std::fmt::Write;

use expect_test::expect_file;
use gcode_playground::analyze;
use gcode_playground::api::{self, CodeRow};
use gcode_playground::control::codes::{self, Effect};
use gcode_playground::sentences::Language;
use gcode_playground::setup::Setup;
use gcode_playground::setup::dialect::CodeList;

const BEGIN: &str = "<!-- codes -->\n";
const END: &str = "<!-- /codes -->";

fn rows(language: Language) -> Vec<CodeRow> {
    api::codes(CodeList::A, language).rows
}

fn setup(list: CodeList) -> Setup {
    let dialect = match list {
        CodeList::A => r#""control": "fanuc", "gSystem": "A""#,
        CodeList::B => r#""control": "fanuc", "gSystem": "B""#,
        CodeList::C => r#""control": "fanuc", "gSystem": "C""#,
        CodeList::Gsk => r#""control": "gsk", "gSystem": "A""#,
    };
    Setup::from_json(&format!(r#"{{"dialect": {{{dialect}, "recognise": false}}}}"#)).expect("setup")
}

/// The codes of the messages for a program.
fn told(program: &str, list: CodeList) -> Vec<String> {
    let analysis = analyze(program.as_bytes(), &setup(list));
    analysis.diagnostics.iter().map(|found| found.message.code().to_owned()).collect()
}

/// The table as Markdown.
fn table() -> String {
    let mut text =
        String::from("| code (A) | B | C | GSK | what it does | note |\n|---|---|---|---|---|---|\n");
    let mut section = "";
    for row in rows(Language::English) {
        if section != row.section {
            section = row.section;
            let _ = writeln!(text, "| **{section}** | | | | | |");
        }
        for list in CodeList::ALL {
            let _ = write!(text, "| {} ", row.printed(list));
        }
        let _ = writeln!(text, "| {} | {} |", row.does, row.note);
    }
    text
}

#[test]
fn the_reference_shows_the_registry() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/www/docs/codes.md");
    let page = std::fs::read_to_string(path).expect("codes.md");
    let begin = page.find(BEGIN).expect("the table's begin") + BEGIN.len();
    let end = page.find(END).expect("the table's end");
    let wanted = format!("{}{}{}", &page[..begin], table(), &page[end..]);
    expect_file![path].assert_eq(&wanted);
}

#[test]
fn every_row_has_codes_and_words() {
    for language in Language::ALL {
        for row in rows(language) {
            assert!(CodeList::ALL.iter().any(|&list| !row.codes(list).is_empty()), "{row:?}");
            assert!(!row.section.is_empty() && !row.does.is_empty(), "{row:?}");
            assert_eq!(row.note.is_empty(), row.effect == "done", "{row:?}");
            for (what, text) in [("does", row.does), ("section", row.section)] {
                let cyrillic = text.chars().any(|ch| ('а'..='я').contains(&ch));
                let chinese = text.chars().any(|ch| ('一'..='龥').contains(&ch));
                let expected = match language {
                    Language::English => (false, false),
                    Language::Chinese => (false, true),
                    Language::Russian => (true, false),
                };
                assert_eq!((cyrillic, chinese), expected, "{what} of {row:?}");
            }
        }
    }
}

#[test]
fn a_code_is_recognised_if_and_only_if_it_has_a_row() {
    for list in CodeList::ALL {
        let written: HashSet<String> = rows(Language::English)
            .iter()
            .flat_map(|row| row.codes(list).split(' ').map(str::to_owned).collect::<Vec<_>>())
            .collect();
        for tenths in 0..1_200 {
            let code = match tenths % 10 {
                0 => format!("G{:02}", tenths / 10),
                decimal => format!("G{:02}.{decimal}", tenths / 10),
            };
            let unknown = told(&code, list).iter().any(|found| found == "PS0010" || found == "W-G-MAKER");
            assert_eq!(!unknown, written.contains(&code), "{code} in {}", list.name());
        }
        for number in 0..1_000 {
            let code = format!("M{number:02}");
            // Without P it is a code of the machine builder.
            let block = if number == 97 { "M97 P1".to_owned() } else { code.clone() };
            let unknown = told(&block, list).iter().any(|found| found == "W-M-UNKNOWN");
            assert_eq!(!unknown, written.contains(&code), "{code}");
        }
    }
}

#[test]
fn what_is_called_unsupported_is_answered_so() {
    for row in codes::rows() {
        for (codes, list) in row.codes.iter().zip(CodeList::ALL) {
            for code in codes.split(' ').filter(|code| code.starts_with(['G', 'M'])) {
                let answered = told(code, list).iter().any(|found| found == "N-UNSUPPORTED");
                assert_eq!(answered, row.effect == Effect::NotSupported, "{code} in {}", list.name());
            }
        }
    }
}

#[test]
fn words_that_are_no_codes_are_understood() {
    let start = "M3 S500 F0.2\nG0 X40 Z2\n";
    let everywhere = [
        "G1 Z-20 ,C2\nX60",
        "G1 Z-20 C2\nX60",
        "G1 Z-20 I2\nX60",
        "G1 X30 K-2\nZ-30",
        "G1 Z-20 ,R2\nX60",
        "G1 Z-20 R2\nX60",
        "G1 X60 ,A135",
        "G1 X60 A135",
        "T0101",
        "#1=SQRT[4]\nG1 Z-#1",
        "IF[1 EQ 1]THEN #1=2",
        "IF[1 EQ 1]GOTO 5\n#3000=1(NO)\nN5 G1 Z-1",
        "#1=0\nWHILE[#1 LT 2]DO1\n#1=#1+1\nEND1",
        "POPEN\nBPRNT[X]\nDPRNT[X]\nPCLOS\nSETVN 101[A]",
        "/G1 Z-1\n/2 G1 Z-2\n/9 G1 Z-3",
    ];
    let gsk = ["G1 Z-20 L2\nX60", "G1 Z-20 D2\nX60"];
    for (list, program) in CodeList::ALL
        .into_iter()
        .flat_map(|list| everywhere.map(|program| (list, program)))
        .chain(gsk.map(|program| (CodeList::Gsk, program)))
    {
        let analysis = analyze(format!("{start}{program}\nM30").as_bytes(), &setup(list));
        let errors: Vec<_> = analysis.diagnostics.iter().filter(|found| found.is_error()).collect();
        assert!(errors.is_empty(), "{program} in {}: {errors:?}", list.name());
    }
    // Each word of the table appears in one of these programs.
    let all = [&everywhere[..], &gsk].concat().join("\n");
    for row in codes::rows().filter(|row| row.group.is_none()) {
        for word in row.codes[3].split(' ').filter(|word| !word.starts_with('M')) {
            assert!(all.contains(word.split('…').next().unwrap_or(word)), "{word}");
        }
    }
}
