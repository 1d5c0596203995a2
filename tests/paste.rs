//! Programs inside other text: detection, cleaning, questions; and that no text is lost.
use gcode_playground::api::paste::{FoundPrograms, pieces, shortened};
use gcode_playground::control::codes::{self, Section};
use gcode_playground::limits::{MAX_FOUND_PROGRAMS, MAX_PASTED_TEXT};
use gcode_playground::paste::{Found, Name, Program, Reason, Review, find};
use gcode_playground::sentences::Language;
use gcode_playground::setup::Setup;
use proptest::prelude::*;

/// The cleaned programs of a text, with questions as printed.
fn cleaned(text: &str) -> Vec<String> {
    checked(text).programs.iter().map(Program::text).collect()
}

/// Finds programs, and checks that no text is lost.
fn checked(text: &str) -> Found {
    let found = find(text);
    let mut end = 0;
    for program in &found.programs {
        assert!(program.span.start >= end, "programs overlap in {text:?}");
        let mut at = program.span.start;
        for piece in &program.pieces {
            assert_eq!(piece.span.start, at, "a gap in {text:?}");
            at = piece.span.end;
            let was = &text[piece.span.start as usize..piece.span.end as usize];
            // Without a reason, a piece may differ only in whitespace.
            if piece.reason.is_none() {
                let solid = |text: &str| {
                    text.chars().filter(|c| !c.is_whitespace() && !c.is_control()).collect::<String>()
                };
                assert_eq!(solid(was), solid(&piece.now), "lost without a word in {text:?}");
            }
            if piece.is_question() {
                assert_eq!(piece.choices[0], piece.now, "a question is answered in {text:?}");
            }
        }
        assert_eq!(at, program.span.end);
        end = program.span.end;
    }
    assert!(end as usize <= text.len());
    found
}

fn only(text: &str) -> String {
    let mut programs = cleaned(text);
    assert_eq!(programs.len(), 1, "{programs:#?}");
    programs.remove(0)
}

fn reasons(text: &str) -> Vec<Reason> {
    checked(text)
        .programs
        .iter()
        .flat_map(|program| &program.pieces)
        .filter_map(|piece| piece.reason)
        .collect()
}

#[test]
fn a_slide_with_bullets_becomes_one_block_a_line() {
    let text = "Write the roughing and finishing blocks\n16\n•O8234 •N10 G50 X100.0 Z100.0; •N20 M03 S1000; •N30 G00 X85.0 Z5.0; •N90 M30;\n图4-4\n";
    assert_eq!(only(text), "O8234\nN10 G50 X100.0 Z100.0;\nN20 M03 S1000;\nN30 G00 X85.0 Z5.0;\nN90 M30;\n");
    let found = find(text);
    assert_eq!(found.programs[0].name, Name::Number(8234));
    assert_eq!(found.programs[0].lines, (2, 2));
    assert_eq!(found.review, Review::Programs);
}

#[test]
fn a_zero_for_the_letter_of_a_program_number() {
    assert_eq!(
        only("• 00006; • N10 T0101; • N40 G90 X50.0 Z-30.0;\nN80 X40.5; • N110 M30\n"),
        "O0006;\nN10 T0101;\nN40 G90 X50.0 Z-30.0;\nN80 X40.5;\nN110 M30\n"
    );
}

#[test]
fn both_copies_of_a_program_are_listed() {
    let text = "N80 X40.5; N90 X40.0 F60; N100 G40 G00 X100.0; N110 M30\nN80 X40.5; N90 X40.0 F60; N100 G00 X100.0;\nN110 M30\n";
    assert_eq!(
        cleaned(text),
        [
            "N80 X40.5;\nN90 X40.0 F60;\nN100 G40 G00 X100.0;\nN110 M30\n",
            "N80 X40.5;\nN90 X40.0 F60;\nN100 G00 X100.0;\nN110 M30\n",
        ]
    );
}

#[test]
fn a_fragment_without_number_or_end_is_a_program() {
    let text =
        "程序编制:\nN140 G90 X58 Z-25R-10.8 F0.2; N150 X56; N180 X54 N190 X50;\n格式:G90 X(U) Z(W) R F ;\n";
    let found = checked(text);
    assert_eq!(found.programs.len(), 1);
    assert_eq!(found.programs[0].name, Name::Title("程序编制".into()));
    assert_eq!(found.programs[0].text(), "N140 G90 X58 Z-25R-10.8 F0.2;\nN150 X56;\nN180 X54\nN190 X50;\n");
}

#[test]
fn ends_of_blocks_that_print_has_lost_are_put_in() {
    assert_eq!(
        only("……G00 X55 Z2G90 X45 Z-25 F0.2X40X35G00 X100 Z100M30\n"),
        "G00 X55 Z2\nG90 X45 Z-25 F0.2\nX40\nX35\nG00 X100 Z100M30\n"
    );
    assert_eq!(only("O1; Z0 G90 X62 Z-43 F0.3 X60.4 M30"), "O1;\nZ0\nG90 X62 Z-43 F0.3\nX60.4 M30\n");
}

#[test]
fn captions_between_blocks_are_left_out() {
    let text = "A\n2工进\nO0002;\n3工进\n4快退\nT0101;\n\nG00 X32 Z2; G90 X26 Z-30 F0.1;\n\nM30;\n\n1快进\n";
    assert_eq!(only(text), "O0002;\nT0101;\nG00 X32 Z2;\nG90 X26 Z-30 F0.1;\nM30;\n");
}

#[test]
fn an_unreadable_digit_may_be_that_of_any_turning_cycle() {
    let choices = |read: &str| -> Vec<String> {
        let found = checked(&format!("O0001; G00 X26; {read}ቤተ X20 Z-30 F0.1; X32; M30;"));
        found.programs[0].questions().flat_map(|piece| piece.choices.clone()).collect()
    };
    assert_eq!(choices("G7"), ["G7", "G70", "G71", "G72", "G73", "G74", "G75", "G76"]);
    assert_eq!(choices("G9"), ["G9", "G90", "G92", "G94", "G96", "G97", "G98"]);
    for row in codes::rows() {
        if matches!(row.function.section(), Section::SingleCycles | Section::MultipleCycles) {
            let code = &row.codes[0];
            assert!(choices(&code[..2]).contains(code), "{code}");
        }
    }
}

#[test]
fn a_digit_lost_in_other_signs_is_asked_for() {
    let found = checked("O0001; G00 X 26 ; G0ቤተ መጻሕፍቲ Z-30 F0.1; X32; M30;");
    let program = &found.programs[0];
    let asked: Vec<_> = program.questions().collect();
    assert_eq!(asked.len(), 1);
    assert_eq!(asked[0].choices, ["G0", "G01", "G02", "G03", "G04"]);
    assert_eq!(program.answered(|_| 1), "O0001;\nG00 X 26 ;\nG01 Z-30 F0.1;\nX32;\nM30;\n");
}

#[test]
fn a_lost_minus_is_asked_for_and_never_guessed() {
    let text =
        "程 序 O1; N1; X80.0 Z30.0; G98 G01 Z?20.0 F100; G12.1(G112); X-50.0;. C-25.0; … 说 明 切削至Z?20.0";
    let found = checked(text);
    assert_eq!(
        found.programs[0].text(),
        "O1;\nN1;\nX80.0 Z30.0;\nG98 G01 Z?20.0 F100;\nG12.1(G112);\nX-50.0;\nC-25.0;\n"
    );
    let asked: Vec<_> = found.programs[0].questions().collect();
    assert_eq!(asked.len(), 1);
    assert_eq!(asked[0].choices, ["Z?20.0", "Z-20.0", "Z20.0"]);
}

/// A setup sheet that was read column by column: the block numbers are in a separate column, descriptions
/// between the blocks, a repeated header where the table continues, and all minus signs are lost.
const CARD: &str = "表 6-9 程序号 N010 N020 N030 N040 编程原点 实训车间 O6003 FANUC 编程系统 程序 简要说明 G50 X200 Z200 建立工件坐标系 \
M03 S475 T0101 选择 1 号外圆刀 G99 设定 mm/r G00 X70 Z3 距端面 3 mm G94 X0 Z0.5 F0.1 加工端面 Z0 G90 X62 Z43 F0.3 粗加工 X60.4 \
G90 X58.4 Z20 R2.3 粗加工外锥面 G00 X13 Z3 定位\n续 表\n数控车床的程序卡在下一页上继续,请注意\n说明文字很长的一行说明文字很长的一行\n刀具 T01\n\
续表 1 N160 N170 N180 材料 O6003 编程系统 G01 X50 Z20 F0.1 快速定位至(X45.4,Z3) G00 X70 Z43 切断 M30 程序结束\n";

#[test]
fn a_table_goes_on_under_its_number() {
    let program = only(CARD);
    assert_eq!(program, "O6003\nG50 X200 Z200\nM03 S475 T0101\nG99\nG00 X70 Z3\nG94 X0 Z0.5 F0.1\nZ0\nG90 X62 Z43 F0.3\nX60.4\n\
G90 X58.4 Z20 R2.3\nG00 X13 Z3\nG01 X50 Z20 F0.1\nG00 X70 Z43\nM30 (程序结束)\n".replace(" (程序结束)", ""));
    assert!(reasons(CARD).contains(&Reason::RepeatedHead));
}

#[test]
fn a_table_ends_before_another_program() {
    let other = "刀具 T01\n另一个程序的例子说明文字\n\nN10 G00 X1 Z2\nN20 G01 X3 Z4 F0.1\nN30 X5\n\n说明文字很长的一行说明文字很长的一行\n";
    let programs = cleaned(&CARD.replace("刀具 T01\n", other));
    let heads: Vec<_> = programs.iter().map(|program| program.lines().next().unwrap_or_default()).collect();
    assert_eq!(heads, ["O6003", "T01", "O6003"], "{programs:#?}");
    // A single block between them changes nothing.
    let block =
        "\n\n说明文字很长的一行说明文字很长的一行\nG00 X9\n说明文字很长的一行说明文字很长的一行\n续表 1";
    let programs = cleaned(&CARD.replace("刀具 T01\n", other).replace("\n续表 1", block));
    let heads: Vec<_> = programs.iter().map(|program| program.lines().next().unwrap_or_default()).collect();
    assert_eq!(heads, ["O6003", "T01", "O6003"], "{programs:#?}");
}

#[test]
fn a_program_without_any_minus_is_asked_about() {
    let found = checked(CARD);
    let asked: Vec<_> = found.programs[0].questions().map(|piece| piece.choices[1].clone()).collect();
    assert_eq!(asked, ["Z-43", "Z-20", "R-2.3", "Z-20", "Z-43"]);
    // With the zero at the chuck, cuts go towards smaller Z.
    assert_eq!(
        checked("O1\nG00 X50 Z54\nG90 X46 Z25.9 F0.2\nX40 Z20\nM30\n").programs[0].questions().count(),
        0
    );
}

#[test]
fn the_tails_of_a_forum_are_left_out() {
    let text = "例题 如图所示。 + q ^\" a- B. X, a7 a\n\n: N* e' M, L/ Z1 b7 M8\n\n\
N010 G50 X150 Z100 & a8 |3 x# b0 J/ \\, q\n\nN020 G00 X41 Z0 8 a- F, X1 E2 l# {8 m\n\nN050 G01 X0 Z1 o2 g$ A' G4( Z. n\n\n\
N130 G70 P50 Q120 F30 r, C1 Y( o8 q6 R* n\n\nK1 }8 }9 h! I8\n2. 端面(G72) ( Q' h' H% c*\n指令格式  G72 WΔd Re ) X) v\"\n";
    assert_eq!(only(text), "N010 G50 X150 Z100\nN020 G00 X41 Z0\nN050 G01 X0 Z1\nN130 G70 P50 Q120 F30\n");
    assert!(reasons(text).iter().all(|reason| *reason == Reason::Noise));
}

/// Noise before a program may begin with lower-case words, and may contain brackets.
#[test]
fn noise_before_a_program_is_no_block() {
    let text = "8 d6 w, |2 R/ H2 P\n\nm8 k/ h( y9 I& ]$ C1 V! K\n\nG50 X60 Z40 0 y1 l\" d o q( W0 o+ q, r\n\n\
G00 X0 Z2 ( i: c' ?2 `, D2 ~) {/ H\n\nG74 R1 ' c\" b! E3 o- X. ?8 w\n\nG74 Z-12 Q5 F30 S250 : K% L2 T( B; _6 J2\n";
    assert_eq!(only(text), "G50 X60 Z40\nG00 X0 Z2\nG74 R1\nG74 Z-12 Q5 F30 S250\n");
    // A lower-case program may have lines of short words, and remarks with signs.
    let small = "g00 x50 z2\ng01 z-20 f0.2\nm9 q( W0 o+ q, r: {\nm30 l\" d' o: q(\n";
    assert!(only(small).contains("m9\nm30"), "{}", only(small));
    assert_eq!(
        only("G00 X50 Z2 (8 +/- .1 ?)\nG01 Z-20 F0.2\nM30\n"),
        "G00 X50 Z2 (8 +/- .1 ?)\nG01 Z-20 F0.2\nM30\n"
    );
}

#[test]
fn programs_in_a_sentence_need_two_moves() {
    let text = "программа записана как G00X54Z5; G94x30z0r-20f0.1, ошибка в том, что точка A (54,5). Запись G90 X50 Z-30 режет цилиндр.";
    assert_eq!(only(text), "G00X54Z5;\nG94x30z0r-20f0.1\n");
    assert_eq!(cleaned("Use G90 X50 Z-30 to cut a cylinder."), [""; 0]);
    assert_eq!(cleaned("G90的用法: X30 Z5"), [""; 0]);
}

#[test]
fn formats_are_no_programs() {
    for text in [
        "代码格式: G90 X(U)__ Z(W)__ F__; (圆柱切削)\nG90 X(U) Z(W) R F ;\n",
        "指令格式:G76 P(m)(r)(a)Q(Δdmin) R(d)\nG76 X(U)Z(W) R(i)P(k)Q(Δd)F(L)\n",
        "G71 U(Δd) R(e)\nG71 P(ns) Q(nf) U(Δu) W(Δw) F(f)\n",
        "G90 X(U)~Z(W)~I(或R)~F~\nG94 X(U)_ Z(W)_ F_\n",
    ] {
        assert_eq!(cleaned(text), [""; 0], "{text}");
    }
}

#[test]
fn signs_of_print_become_plain() {
    let text =
        "Ｏ０００１；\nＧ００ Ｘ３２ Ｚ２\nG01 Z−30 F0。1\nGO1 X4O.5 Z\u{2013}5\n\u{200b}G00\u{a0}X50\nМ30\n";
    assert_eq!(only(text), "O0001;\nG00 X32 Z2\nG01 Z-30 F0.1\nG01 X40.5 Z-5\nG00 X50\nM30\n");
    let found = reasons(text);
    for reason in
        [Reason::FullWidth, Reason::Minus, Reason::LetterForDigit, Reason::LookAlike, Reason::DecimalPoint]
    {
        assert!(found.contains(&reason), "{reason:?} in {found:?}");
    }
}

#[test]
fn a_level_of_block_skip_is_one_sign() {
    let program = |skip: &str| format!("O1\nG00 X50 Z2\n{skip} G01 X40\nG01 Z-5\nM30\n");
    for skip in ["/1", "/\u{ad}1", "/\u{200b}1", "/１", "／１", "/"] {
        let cleaned = only(&program(skip));
        assert_eq!(
            cleaned.lines().nth(2),
            Some(if skip == "/" { "/ G01 X40" } else { "/1 G01 X40" }),
            "{skip:?}"
        );
    }
}

#[test]
fn line_numbers_fences_quotes_and_tables() {
    assert_eq!(
        only("Here you go:\n```gcode\n1  O0001\n2  G00 X32 Z2\n3. G01 Z-30 F0.1\n```\nGood luck!"),
        "O0001\nG00 X32 Z2\nG01 Z-30 F0.1\n"
    );
    assert_eq!(only("> G00 X32 Z2\n> G01 Z-30 F0.1\n"), "G00 X32 Z2\nG01 Z-30 F0.1\n");
    assert_eq!(
        only("| N10 | G00 X32 Z2 |\n|---|---|\n| N20 | G01 Z-30 F0.1 |\n"),
        "N10 G00 X32 Z2\nN20 G01 Z-30 F0.1\n"
    );
}

#[test]
fn a_few_stray_characters_are_worth_a_line_not_a_dialog() {
    let text = "O1\nG00 X32， Z2\nG01 X30 Z-30 F0.2\nM30\n";
    let found = checked(text);
    assert_eq!(found.review, Review::FewCharacters, "{found:#?}");
    assert_eq!(found.programs[0].text(), text.replace('，', ""));
    // Full-width letters, zero-width characters.
    assert_eq!(checked("O1\nG00 Ｘ32 Z2\nG01\u{200b} Z-5 F0.2\nM30\n").review, Review::FewCharacters);
    let many = "O1\nG00 X32， Z2，\nG01 X30， Z-30， F0.2，\nM30\n";
    assert_eq!(checked(many).review, Review::Programs);
    // Text around it, or a question in it, needs the full review.
    assert_eq!(checked("Example\nO1\nG00 X32， Z2\nM30\n").review, Review::Programs);
    assert_eq!(checked("O1\nG00 X32， Z2\nG01 Z?30.0 F0.2\nM30\n").review, Review::Programs);
}

#[test]
fn short_text_behind_a_block_becomes_a_remark() {
    assert_eq!(
        only("O1\nG00 X32 Z2 to the start\nG01 Z-30 F0.1; 粗车外圆\nM30 конец (программы)\n"),
        "O1\nG00 X32 Z2 (to the start)\nG01 Z-30 F0.1; (粗车外圆)\nM30 (конец [программы])\n"
    );
    let long = format!("O1\nG00 X32 Z2 {}\nM30\n", "and then another word ".repeat(9));
    assert_eq!(only(&long), "O1\nG00 X32 Z2\nM30\n");
}

#[test]
fn a_program_as_a_control_takes_it_stays_as_it_is() {
    let text = "%\nO1000 (PART)\n(ROUGH)\nN10 G18 G20 G40 G80 G99\n/2 M98 P2000\n/\n#100=[#1+2.5]*3\nIF [#100 GT 4] GOTO 20\n\
G01 X#100 Z[-#3/2] ,C2 ,R1. F.2\nX-21.75,A30\nN20 G65 P9010 A1. B2.\nWHILE [#1 LT 3] DO1\nEND1\nG28 U0. W0.\nM30\n%\n";
    let found = checked(text);
    assert_eq!(found.review, Review::Nothing, "{found:#?}");
    assert_eq!(found.programs.len(), 1);
    assert_eq!(found.programs[0].text(), text.replace("%\n", ""));
    assert_eq!(checked("O1;\nG00U2W1;每刀切深2毫米\nM30;\n").review, Review::Nothing);
    let with_subprogram = "O1\nG00 X5 Z5\nM98 P2\nM30\nO2\nG01 U-1 F.1\nM99\n";
    assert_eq!(checked(with_subprogram).review, Review::Nothing);
    assert_eq!(checked(with_subprogram).programs.len(), 2);
}

#[test]
fn every_fixture_stays_as_it_is() {
    for folder in std::fs::read_dir("tests/programs").expect("fixtures") {
        let path = folder.expect("a folder").path().join("program.nc");
        let Ok(text) = std::fs::read_to_string(&path) else { continue };
        let found = checked(&text);
        assert_eq!(found.review, Review::Nothing, "{}: {found:#?}", path.display());
        for program in &found.programs {
            let motions =
                |text: &str| gcode_playground::analyze(text.as_bytes(), &Setup::default()).motions.len();
            assert_eq!(motions(&program.text()), motions(&text), "{}", path.display());
        }
    }
}

#[test]
fn bounds_are_told() {
    let many = "O1 G00 X1 Z1 M30\n".repeat(MAX_FOUND_PROGRAMS + 7);
    let found = find(&many);
    assert_eq!((found.programs.len(), found.more), (MAX_FOUND_PROGRAMS, 7));
    assert!(find(&" ".repeat(MAX_PASTED_TEXT + 1)).too_long);
}

#[test]
fn rows_put_together_are_the_cleaned_program() {
    let text = format!("O1 {} G00 X1 Z–2; X?3 M30", "prose ".repeat(30));
    let found = find(&text);
    let rows = pieces(&text, &found.programs[0], Language::Russian);
    assert_eq!(rows.iter().map(|row| row.now.as_str()).collect::<String>(), found.programs[0].text());
    assert!(rows.iter().all(|row| row.was.chars().count() < 170));
    let list = FoundPrograms::new(&found);
    assert_eq!((list.programs[0].name.as_str(), list.programs[0].questions), ("O0001", 1));
    assert_eq!(shortened(" a \n b "), "a b");
}

#[test]
fn every_reason_is_said_in_every_language() {
    for reason in Reason::ALL {
        let said: Vec<_> = Language::ALL.iter().map(|language| reason.phrase(*language)).collect();
        assert!(said.iter().all(|phrase| !phrase.is_empty()) && said[0] != said[1] && said[1] != said[2]);
    }
}

/// Fragments of programs and of surrounding text.
fn bit() -> impl Strategy<Value = String> {
    let bits = [
        "G01 ",
        "X50.",
        "Z-20 ",
        "Z?20",
        "N10 ",
        "O0001",
        ";",
        "\n",
        "\r\n",
        "(a)",
        "(",
        ")",
        "M30",
        "；",
        "Ｇ００",
        "G0ቤተ",
        "–5",
        "•",
        "|",
        "text ",
        "текст ",
        "说明",
        "X(U)_",
        "[#1+2]",
        "#1=2",
        "% ",
        "/2",
        "/",
        "\u{ad}",
        "２",
        "…",
        "GO1",
        "{8 m!",
        "00006;",
        "1. ",
        "R",
        ",C2",
        "\u{200b}",
        "M99\n",
        "IF[",
        "F0,2",
    ];
    prop_oneof![3 => proptest::sample::select(bits.to_vec()).prop_map(str::to_string), 1 => any::<char>().prop_map(String::from)]
}

proptest! {
    #[test]
    fn nothing_is_lost_and_nothing_panics(bits in proptest::collection::vec(bit(), 0..80)) {
        let text: String = bits.concat();
        let found = checked(&text);
        for program in &found.programs {
            // A cleaned program is still a program.
            checked(&program.text());
            for language in Language::ALL {
                pieces(&text, program, language);
            }
        }
    }
}
