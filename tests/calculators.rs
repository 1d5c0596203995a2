//! The calculators at a word of a program: their first values, and the edits that write a result.
//!
//! A `$0` marks the cursor. Expectations are worked out from the geometry of the block, as the comments say.

use crate::assist::asking::Asking;
use gcode_playground::api::calculate::{CalculatorForm, form_at};
use gcode_playground::calculate::{ALL, Calculator, THREAD, Writing, at_word};
use gcode_playground::message::Severity;
use gcode_playground::run::{Run, replay::VisitChoice};
use gcode_playground::sentences::Language;
use gcode_playground::setup::Setup;

struct At {
    text: String,
    byte: u32,
    asking: Asking,
}

impl At {
    fn new(text: &str) -> Self {
        let byte = text.find("$0").expect("a mark");
        let text = text.replace("$0", "");
        let asking = Asking::new(&text, Setup::default());
        Self { text, byte: byte as u32, asking }
    }

    fn names(&mut self) -> Vec<&'static str> {
        let (byte, language) = (self.byte, Language::English);
        self.asking.with(byte, VisitChoice::Usual, language, |asked, _, run| {
            at_word::calculators(asked, byte, run.motions()).to_vec()
        })
    }

    fn values(&mut self, name: &str) -> Vec<String> {
        let calculator = Calculator::find(name).expect("a calculator");
        let form: CalculatorForm =
            self.asking.with(self.byte, VisitChoice::Usual, Language::English, |asked, _, run| {
                form_at(calculator, asked, run.motions(), Language::English)
            });
        form.fields.into_iter().map(|field| field.value).collect()
    }

    /// The text after a calculation with some other values.
    fn written(&mut self, name: &str, changed: &[(usize, &str)]) -> String {
        let calculator = Calculator::find(name).expect("a calculator");
        let mut fields = self.values(name);
        for &(at, value) in changed {
            fields[at] = value.to_owned();
        }
        let edits = self.asking.with(self.byte, VisitChoice::Usual, Language::English, |asked, _, run| {
            let writing = Writing::of(asked);
            let values = calculator.read(&fields, writing.unit).expect("values");
            let outcome = calculator.compute(&values, &fields[0]).expect("results");
            at_word::edits(asked, run.motions(), &outcome, writing)
        });
        let mut text = self.text.clone();
        for edit in edits.iter().rev() {
            text.replace_range(edit.span.start as usize..edit.span.end as usize, &edit.text);
        }
        text
    }
}

/// The present R of -8 over 27 mm leads to 40 - 2·8·25/27 = 25.185 mm at Z0. For 20 mm there R is -10.8.
#[test]
fn r_of_a_turning_cycle() {
    let mut at = At::new("G00 X44 Z2\nG90 X40 Z-25 $0R-8 F0.2\nM30\n");
    assert_eq!(at.names(), ["r-of-g90"]);
    assert_eq!(at.values("r-of-g90"), ["25.185", "0", "40", "-25", "2"]);
    assert_eq!(at.written("r-of-g90", &[(0, "20")]), "G00 X44 Z2\nG90 X40 Z-25 R-10.8 F0.2\nM30\n");
    assert_eq!(at.written("r-of-g90", &[]), at.text, "nothing was changed");
}

/// U and W stay distances: X50 Z-20 from X64 Z3 are U-14 W-23.
#[test]
fn distances_stay_distances() {
    let mut at = At::new("G00 X64 Z3\nG90 U-14 W-23 $0R-2 F0.2\nM30\n");
    assert_eq!(at.written("r-of-g90", &[(0, "46")]), "G00 X64 Z3\nG90 U-14 W-23 R-2.3 F0.2\nM30\n");
    assert_eq!(
        at.written("r-of-g90", &[(0, "46"), (2, "48")]),
        "G00 X64 Z3\nG90 U-16 W-23 R-1.15 F0.2\nM30\n"
    );
}

/// A later pass replaces R in its own block only; X and Z in force are not written again.
#[test]
fn a_taper_of_a_later_pass() {
    let mut at = At::new("G00 X64 Z3\nG90 X58 Z-20 R-2.3 F0.2\nX54 $0R-2\nM30\n");
    assert_eq!(at.written("r-of-g90", &[(0, "50")]), "G00 X64 Z3\nG90 X58 Z-20 R-2.3 F0.2\nX54 R-2.3\nM30\n");
}

/// A bar of 50 mm: from X54 to X30 R-20 leads to Z-20·20/24 = -16.667 at the bar; Z-20 there needs R-24.
#[test]
fn r_of_a_facing_cycle() {
    let mut at = At::new("(STOCK D=50 LENGTH=80)\nG00 X54 Z2\nG94 X30 Z0 $0R-20 F0.2\nM30\n");
    assert_eq!(at.names(), ["r-of-g94"]);
    assert_eq!(at.values("r-of-g94"), ["50", "-16.667", "30", "0", "54"]);
    let written = at.written("r-of-g94", &[(1, "-20")]);
    assert_eq!(written, "(STOCK D=50 LENGTH=80)\nG00 X54 Z2\nG94 X30 Z0 R-24 F0.2\nM30\n");
}

/// Seed 003, example 6. The words of the first block are found from the second one; one finishing pass more stays.
#[test]
fn the_two_blocks_of_a_thread() {
    let mut at =
        At::new("G97 S200 M03\nG00 X60 Z10\nG76 P020660 Q100 R0.1\nG76 X33.8 Z-60 $0P2400 Q700 F4\nM30\n");
    assert_eq!(at.names(), ["passes-of-g76"]);
    let values = ["33.8", "-60", "10", "2.4", "0.7", "0.1", "0.1", "60", "4"];
    assert_eq!(at.values("passes-of-g76"), values);
    let written = at.written("passes-of-g76", &[(3, "2.454"), (5, "0.05"), (7, "55")]);
    let first = "G97 S200 M03\nG00 X60 Z10\nG76 P020655 Q50 R0.1\n";
    assert_eq!(written, format!("{first}G76 X33.8 Z-60 P2454 Q700 F4\nM30\n"));
}

/// M20×1.5: core 20 - 2·0.9201 = 18.160; a third of the height is 0.307.
#[test]
fn a_thread_by_name() {
    let mut at =
        At::new("G97 S200 M03\nG00 X26 Z5\nG76 P010060 Q100 R0.05\nG76 X17 Z-20 P1300 Q400 $0F2\nM30\n");
    assert_eq!(at.values("thread-by-name"), ["", "5", "-20"]);
    assert!(at.written("thread-by-name", &[(0, "M20x1.5")]).contains("\nG76 X18.16 Z-20 P920 Q307 F1.5\n"));
    // G92 and G32 have one block for each pass.
    let mut at = At::new("G97 S200 M03\nG00 X26 Z5\nG92 X19.4 Z-20 $0F2\nM30\n");
    assert_eq!(at.names()[0], "thread-by-name");
    assert!(at.written("thread-by-name", &[(0, "M20x1,5")]).contains("\nG92 X19.4 Z-20 F1.5\n"));
}

/// Δi of a bar of 50 mm and a contour of 34 mm is 8 mm; with five passes each step is 2 mm.
#[test]
fn depths_of_contours_and_grooves() {
    let contour = "N10 G00 X34\nG01 Z-20 F0.1\nN20 X50\nM30\n";
    let mut at = At::new(&format!(
        "(STOCK D=50 LENGTH=60)\nG00 X54 Z2\nG73 $0U6 W2 R4\nG73 P10 Q20 U0.4 W0.1 F0.2\n{contour}"
    ));
    assert_eq!(at.names(), ["steps-of-g73"]);
    assert_eq!(at.values("steps-of-g73"), ["50", "38", "4"]);
    assert!(at.written("steps-of-g73", &[(1, "34"), (2, "5")]).contains("\nG73 U8 W2 R5\n"));

    let mut at = At::new(&format!(
        "(STOCK D=50 LENGTH=60)\nG00 X52 Z2\nG71 $0U2 R0.5\nG71 P10 Q20 U0.4 W0.1 F0.2\n{contour}"
    ));
    assert_eq!(at.values("passes-of-g71"), ["52", "", "2"], "the block does not give A′");
    assert!(at.written("passes-of-g71", &[(1, "34"), (2, "2.5")]).contains("\nG71 U2.5 R0.5\n"));

    let tool = "(TOOL T0303 TYPE=GROOVING WIDTH=4 REACH=15)\nT0303\n";
    let mut at = At::new(&format!("{tool}G00 X54 Z-20\nG75 R0.5\nG75 X34 Z-32 P3000 $0Q3500 F0.08\nM30\n"));
    assert_eq!(at.values("columns-of-g75"), ["-12", "3.5", "4"]);
    assert!(at.written("columns-of-g75", &[(1, "3.8")]).contains("G75 X34 Z-32 P3000 Q3800 F0.08"));
    // A groove 1 mm longer: Z keeps its absolute value, -20 - 13 = -33.
    assert!(at.written("columns-of-g75", &[(0, "-13")]).contains("G75 X34 Z-33 P3000 Q3500 F0.08"));
}

/// n = 1000·100 / (π·60) = 530.5 rpm; the S of a cutting speed is not written over.
#[test]
fn speeds() {
    let mut at = At::new("G00 X60 Z2\nG97 $0S530 M03\nG01 Z-5 F0.1\nM30\n");
    assert_eq!(at.names(), ["speed"]);
    assert_eq!(at.values("speed")[..2], ["99.903", "60"]);
    assert!(at.written("speed", &[(0, "120"), (2, "0.1"), (3, "0.4")]).contains("G97 S637 M03"));
    let mut at = At::new("G00 X60 Z2\nG96 $0S100 M03\nG01 Z-5 F0.1\nM30\n");
    assert_eq!(at.written("speed", &[(0, "120"), (2, "0.1"), (3, "0.4")]), at.text);
}

/// An inch program: 1.5748 in = 40 mm. R is written in inches with four decimals.
#[test]
fn inches() {
    let mut at = At::new("G20\nG00 X1.8 Z.1\nG90 X1.6 Z-1. $0R-.1 F.01\nM30\n");
    assert_eq!(at.values("r-of-g90")[2..], ["1.6", "-1", "0.1"]);
    // (1.2 - 1.6) / 2 · 1.1 / 1 = -0.22
    assert!(at.written("r-of-g90", &[(0, "1.2"), (1, "0")]).contains("G90 X1.6 Z-1. R-0.22 F.01"));
    assert_eq!(At::new("G20\nG97 $0S500 M03\nG00 X2. Z.1\nM30\n").names(), <[&str; 0]>::default());
}

/// Where `X10` is 0.01 mm, a length is written with a point.
#[test]
fn a_decimal_point_where_it_matters() {
    let mut at = At::new("G00 X44000 Z2000\nG90 X40000 Z-25000 $0R-8000 F0.2\nM30\n");
    let setup = Setup::from_json(r#"{"dialect": {"decimal": "leastIncrement"}}"#);
    at.asking = Asking::new(&at.text, setup.expect("a setup"));
    assert_eq!(at.values("r-of-g90")[2..], ["40", "-25", "2"]);
    // (22 - 40) / 2 · 27 / 25 = -9.72; (15 - 40) / 2 · 27 / 25 = -13.5
    assert!(at.written("r-of-g90", &[(0, "22"), (1, "0")]).contains("R-9.72 "));
    // 2 mm over 27 mm: (40 - 2·25/27·… ) gives the whole number R-27 for X1 = -10.
    assert!(at.written("r-of-g90", &[(0, "-10"), (1, "0")]).contains("R-27. "));
}

#[test]
fn other_words_have_no_calculator() {
    for text in
        ["G00 $0X44 Z2\nM30\n", "G01 X40 Z-5 $0F0.2\nM30\n", "G90 $0X40 Z-25 R-8 F0.2\nM30\n", "($0R)\nM30\n"]
    {
        assert_eq!(At::new(text).names(), <[&str; 0]>::default(), "{text}");
    }
}

/// The program of each calculator runs without a message, and shows its result.
#[test]
fn the_programs_of_the_examples_run() {
    for calculator in ALL {
        let examples: Vec<f64> = calculator.fields.iter().map(|field| field.example).collect();
        let outcome = calculator.compute(&examples, THREAD).expect("results");
        let program = calculator.program(&examples, &outcome);
        let mut analysis = Run::finished(program.clone().into_bytes(), Setup::default()).into_analysis();
        analysis.check_at_machine();
        let serious = analysis.diagnostics.iter().filter(|found| found.severity > Severity::Info);
        let found: Vec<_> = serious.map(|found| found.sentence(Language::English).message).collect();
        assert!(found.is_empty(), "{}:\n{program}\n{found:?}", calculator.name);
        assert!(analysis.motions.len() >= 4, "{}:\n{program}", calculator.name);
    }
}
