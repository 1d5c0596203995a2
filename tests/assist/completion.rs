//! The completions at a position.

use gcode_playground::api::assist::CompletionItem;
use gcode_playground::message::Severity;
use gcode_playground::run::replay::VisitChoice;
use gcode_playground::sentences::Language;
use gcode_playground::setup::Setup;

use super::asking::Asking;

impl Asking {
    /// The completions at a byte, on explicit request or while the user types.
    pub fn completion(&mut self, byte: u32, language: Language, asked_for: bool) -> Vec<CompletionItem> {
        let end = self.run.state().clone();
        self.with(byte, VisitChoice::Usual, language, |asked, reader, _| {
            reader.completion(asked, byte, &end, asked_for).map_or_else(Vec::new, |found| found.items)
        })
    }
}

/// The completions at the mark `$0` of a program.
fn proposed(program: &str, setup: &str, asked_for: bool) -> Vec<CompletionItem> {
    let byte = program.find("$0").expect("a mark");
    let setup = Setup::from_json(setup).expect("a setup");
    Asking::new(&program.replace("$0", ""), setup).completion(byte as u32, Language::English, asked_for)
}

fn labels(items: &[CompletionItem]) -> Vec<&str> {
    items.iter().map(|item| item.label.as_str()).collect()
}

const STOCK: &str = r#"{"stock": {"diameter": 40, "length": 60}, "tools": {"T0303": {"type": "threading"}}}"#;
const HEAD: &str = "O1\nT0101 M3 S800 F0.2\nG00 X42 Z2\n";

#[test]
fn codes_are_proposed_as_the_control_writes_them_those_usual_here_first() {
    let g = |setup: &str| proposed(&format!("{HEAD}G$0\n"), setup, false);
    let found = g("{}");
    assert_eq!(labels(&found)[..4], ["G00", "G01", "G02", "G03"]);
    assert!(found.iter().all(|item| item.detail.len() > 2), "each has one line of words");
    let with_1 = proposed(&format!("{HEAD}G1$0\n"), "{}", false);
    assert_eq!(labels(&with_1)[0], "G01", "G1 is G01");
    assert!(labels(&with_1)[1..].iter().all(|label| label.starts_with("G1")), "{:?}", labels(&with_1));
    let in_b = g(r#"{"dialect": {"gSystem": "B"}}"#);
    assert!(labels(&in_b).contains(&"G77") && !labels(&in_b).contains(&"G94 X"), "{:?}", labels(&in_b));
    let m = proposed("O1\nT0101\nM$0\n", "{}", false);
    assert_eq!(labels(&m)[..2], ["M03", "M04"], "the spindle stands still");
}

#[test]
fn a_cycle_proposes_its_words_and_the_second_block_after_the_first() {
    let second = proposed(&format!("{HEAD}G76 P021260 Q100 R0.05\nG$0\n"), STOCK, false);
    assert!(second[0].label.starts_with("G76 X"), "{:?}", labels(&second));
    let missing = proposed(&format!("{HEAD}G76 P021260 Q100 R0.05\nG76 X37.4 Z-20 $0\n"), STOCK, false);
    assert_eq!(labels(&missing), ["P", "Q", "F"], "what it needs and does not have");
    let asked = proposed(&format!("{HEAD}G76 P021260 Q100 R0.05\nG76 X37.4 Z-20 $0\n"), STOCK, true);
    assert_eq!(labels(&asked), ["P", "Q", "F", "R"], "what can be left out, after that");
    let nothing = proposed(&format!("{HEAD}G01 X30 $0\n"), STOCK, false);
    assert!(nothing.is_empty(), "a list that nobody asked for is in the way");
}

#[test]
fn values_come_from_the_blank_the_tool_and_the_text() {
    let x = proposed(&format!("{HEAD}G01 X$0\n"), STOCK, false);
    assert_eq!(labels(&x), ["X40", "X42", "X0"]);
    assert!(x[0].detail.ends_with("diameter of the blank"), "{}", x[0].detail);
    let z = proposed(&format!("{HEAD}G01 Z-$0\n"), STOCK, false);
    assert_eq!(labels(&z), ["Z-60"], "the back; the face and the tool are not below zero");
    let w = proposed(&format!("{HEAD}G01 W$0\n"), STOCK, false);
    assert_eq!(labels(&w), ["W-2", "W-62"], "to the face, and to the back");
    let f = proposed(&format!("{HEAD}G01 X30 F0.15\nG01 Z-5 F$0\n"), STOCK, false);
    assert_eq!(labels(&f), ["F0.15", "F0.2"], "the newest first");
    let t = proposed(&format!("{HEAD}T$0\n"), STOCK, false);
    assert_eq!(labels(&t), ["T0101", "T0303"]);
    let point = proposed(
        &format!("{HEAD}G01 X$0\n"),
        r#"{"dialect": {"decimal": "leastIncrement"}, "stock": {"diameter": 40, "length": 60}}"#,
        false,
    );
    assert_eq!(point[0].label, "X40.", "without a point it would be 0.040 mm");
}

#[test]
fn numbers_that_exist_are_proposed_where_a_number_is_named() {
    let contour = "N10 G00 X20\nG01 Z-5\nN20 X42\nM30\nO9000\nM99\n";
    let p = proposed(&format!("{HEAD}G71 U2 R1\nG71 P$0\n{contour}"), "{}", false);
    assert_eq!(labels(&p), ["P10", "P20"]);
    assert_eq!(p[0].detail, "line 6");
    let call = proposed(&format!("{HEAD}M98 P$0\n{contour}"), "{}", false);
    assert_eq!(labels(&call), ["P9000"]);
    let next = proposed(&format!("{HEAD}N$0\n{contour}"), "{}", false);
    assert_eq!(labels(&next), ["N30"]);
    let goto = proposed(&format!("{HEAD}IF [#1 EQ 2] GOTO $0\n{contour}"), "{}", false);
    assert_eq!(labels(&goto), ["10", "20"]);
    let variable = proposed(&format!("{HEAD}#100=5\nG01 X#$0\n"), "{}", false);
    assert_eq!(labels(&variable), ["#100"]);
    assert_eq!(variable[0].detail, "= 5");
    assert!(proposed(&format!("{HEAD}(G$0\n"), "{}", true).is_empty(), "nothing in a comment");
}

/// Each unmodified snippet runs after a head without a warning: completions must not be wrong.
#[test]
fn snippets_run_as_they_are() {
    let controls = [
        ("", "G99", "G98", ["G21", "G20"]),
        (r#""gSystem": "B""#, "G95", "G94", ["G21", "G20"]),
        (r#""gSystem": "C""#, "G95", "G94", ["G71", "G70"]),
        (r#""control": "gsk""#, "G99", "G98", ["G21", "G20"]),
        (r#""decimal": "leastIncrement""#, "G99", "G98", ["G21", "G20"]),
    ];
    let blanks = ["null", r#"{"diameter": 40, "length": 60}"#, r#"{"diameter": 8, "length": 12, "grip": 4}"#];
    let all = controls.iter().flat_map(|control| blanks.map(|blank| (control, blank)));
    for ((&(dialect, per_turn, per_minute, units), blank), is_metric) in
        all.flat_map(|control| [true, false].map(|is_metric| (control, is_metric)))
    {
        let unit = units[usize::from(!is_metric)];
        let setup = format!(r#"{{"stock": {blank}, "dialect": {{{dialect}}}}}"#);
        let snippets_in = |program: &str| {
            let items = proposed(program, &setup, true);
            items.into_iter().filter(|item| item.kind == "snippet").collect::<Vec<_>>()
        };
        let named = |items: &[CompletionItem], begins: &str| {
            let found = items.iter().find(|item| item.detail.starts_with(begins));
            found.unwrap_or_else(|| panic!("{dialect}: no {begins}: {:?}", labels(items))).text.clone()
        };
        let first = snippets_in(&format!("{unit}\n$0"));
        let (head, end) = (named(&first, "head of a program"), named(&first, "end of a program"));
        assert!(head.contains(per_turn), "{head}");
        let nearer = match (blank.contains("40"), is_metric) {
            (true, true) => "G00 X41. Z1.",
            (true, false) => "G00 X1.6 Z.05",
            (false, true) => "G00 X7. Z1.",
            (false, false) => "G00 X.3 Z.05",
        };
        for head in [head.clone(), head.replace(per_turn, per_minute), format!("{head}\n{nearer}")] {
            let snippets = snippets_in(&format!("{head}\n$0\n{end}\n"));
            assert!(!snippets.iter().any(|item| item.detail.starts_with("head of")), "it has one");
            assert!(snippets.len() > 12, "{dialect}: {:?}", labels(&snippets));
            for CompletionItem { text, detail, .. } in snippets {
                let program = match () {
                    () if detail.starts_with("end of") => format!("{head}\n{text}\n"),
                    () if detail.starts_with("a subprogram") => format!("{head}\nM98 P2000\n{end}\n{text}\n"),
                    () => format!("{head}\n{text}\n{end}\nO2000\nM99\nO9000\nM99\n"),
                };
                let run = Asking::new(&program, Setup::from_json(&setup).expect("a setup")).run;
                let serious = run.diagnostics().iter().filter(|told| told.severity != Severity::Info);
                let wrong: Vec<_> = serious.map(|told| told.message.slug()).collect();
                assert!(wrong.is_empty(), "{dialect}: {wrong:?} in\n{program}");
            }
        }
    }
}

/// The height is 0.65 of the lead, and X is smaller than the blank of 40 mm by twice the height.
#[test]
fn a_threading_cycle_takes_the_lead_of_the_program() {
    let whole = |head: &str, setup: &str| {
        let items = proposed(&format!("{head}G76$0\n"), setup, false);
        let snippet = items.into_iter().find(|item| item.kind == "snippet").expect("a snippet");
        snippet.text
    };
    let first = |lead: &str| format!("G76 P{lead} Q100 R0.05\n");
    let check = |head: &str, packed: &str, second: &str| {
        let text = whole(head, STOCK);
        let words: Vec<_> = second.split(' ').collect();
        assert!(text.starts_with(&first(packed)[..11]), "{text}");
        let own = text.lines().nth(1).expect("two blocks");
        assert!(words.iter().all(|word| own.split(' ').any(|other| other == *word)), "{own}: {second}");
    };
    check(HEAD, "021060", "X37.4 P1300 Q400 F2");
    check(&format!("{HEAD}(THREAD M40X1.5)\n"), "021060", "X38.05 P975 Q300 F1.5");
    check(&format!("{HEAD}G92 X39 Z-20 F1\nX38.7\n"), "021060", "X38.7 P650 Q200 F1");
    // A pull-out over one lead of 4 mm reaches beyond X42, which is 3.6 mm from the root.
    check(&format!("{HEAD}(M40X4)\n"), "020560", "X34.8 P2600 Q800 F4");
    // 16 threads per inch: 0.0625 · 0.65 = 0.0406. The blank has 40 / 25.4 = 1.5748 in.
    let inches = "O1\nG20 T0101 M3 S800 F0.01\nG00 X1.66 Z0.1\n";
    check(inches, "021060", "X1.4936 P406 F0.0625");
    // 12 threads per inch: 0.083333 · 0.65 = 0.0542.
    let twelve = format!("{inches}G92 X1.5 Z-1. F.083333\n");
    check(&twelve, "021060", "X1.4664 P542 F0.083333");
}

#[test]
fn a_code_proposes_its_whole_cycle_first() {
    let at = |typed: &str, asked: bool| proposed(&format!("{HEAD}{typed}$0\n"), STOCK, asked);
    let first = |typed: &str, asked: bool| at(typed, asked)[0].label.clone();
    for (typed, begins) in
        [("G7", "G71 U"), ("g71", "G71 U"), ("G72", "G72 W"), ("G76", "G76 P"), ("G90", "G90 X")]
    {
        assert!(first(typed, false).starts_with(begins), "{typed}: {:?}", labels(&at(typed, false)));
        assert!(!labels(&at(typed, false)).contains(&typed), "{typed} itself is no proposal");
    }
    // After the code: only on request, because the words of a cycle can also be typed one by one.
    assert!(first("G71 ", true).starts_with("G71 U"));
    assert!(first("G92  ", true).starts_with("G92 X"));
    assert_eq!(labels(&at("G00 ", true))[0], "X", "a code without a snippet proposes its words");
    let second = proposed(&format!("{HEAD}G76 P021260 Q100 R0.05\nG76$0\n"), STOCK, false);
    assert!(second[0].label.starts_with("G76 X"), "{:?}", labels(&second));
}

#[test]
fn a_name_proposes_the_cycles_whose_description_contains_it() {
    let named = |typed: &str, language: Language| {
        let text = format!("{HEAD}{typed}\n");
        let byte = text.trim_end().len() as u32;
        Asking::new(&text, Setup::from_json(STOCK).expect("a setup")).completion(byte, language, false)
    };
    let rough = named("rough", Language::English);
    assert!(rough.iter().all(|item| item.detail.contains("rough")), "{:?}", labels(&rough));
    assert!(labels(&rough)[0].starts_with("G71 U"), "{:?}", labels(&rough));
    assert!(labels(&named("Thread", Language::English)).iter().any(|label| label.starts_with("G76 P")));
    assert!(labels(&named("粗车", Language::Chinese))[0].starts_with("G71 U"));
    assert!(labels(&named("черн", Language::Russian))[0].starts_with("G71 U"));
    assert!(named("ro", Language::English).is_empty());
    assert!(named("approach", Language::English).is_empty());
}
