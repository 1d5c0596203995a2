//! Answers calculated by hand: each value from the block, a manual or geometry, none from the output of the
//! program.

use gcode_playground::api::assist::{FormHelp, StateHelp};
use gcode_playground::run::replay::VisitChoice;
use gcode_playground::sentences::Language;
use gcode_playground::setup::Setup;

use super::asking::Asking;

/// A program, and questions about the blocks of its lines, counted from 1.
struct Program {
    text: &'static str,
    asking: Asking,
}

impl Program {
    fn new(text: &'static str) -> Self {
        Self::with(text, Setup::default())
    }

    fn with(text: &'static str, setup: Setup) -> Self {
        Self { text, asking: Asking::new(text, setup) }
    }

    fn byte(&self, line: usize) -> u32 {
        self.text.split_inclusive('\n').take(line - 1).map(str::len).sum::<usize>() as u32
    }

    fn state(&mut self, line: usize, time: VisitChoice) -> StateHelp {
        let byte = self.byte(line);
        self.asking.state(byte, time, Language::English)
    }

    fn explanation(&mut self, line: usize) -> String {
        self.state(line, VisitChoice::Usual).explanation
    }

    /// The positions before and after: `X Ø80 mm > Ø50 mm`.
    fn axes(&mut self, line: usize) -> Vec<String> {
        let axes = self.state(line, VisitChoice::Usual).axes;
        axes.iter().map(|row| format!("{} {} > {}", row.name, row.before, row.after)).collect()
    }

    fn form(&mut self, line: usize) -> Option<FormHelp> {
        let byte = self.byte(line);
        self.asking.form(byte, Language::English)
    }

    /// The letters of the words of the form.
    fn letters(&mut self, line: usize) -> Vec<String> {
        let form = self.form(line).expect("a form");
        let own = form.lines.into_iter().find(|line| line.own).expect("the block");
        own.words.into_iter().map(|word| word.letters).collect()
    }

    fn otherwise(&mut self, line: usize, letters: &str) -> String {
        let form = self.form(line).expect("a form");
        let own = form.lines.into_iter().find(|line| line.own).expect("the block");
        own.words.into_iter().find(|word| word.letters == letters).expect("a word").otherwise
    }

    /// The value of a word in a line, and the facts about it.
    fn word(&mut self, line: usize, word: &str) -> (String, Vec<String>) {
        let start = self.byte(line) as usize;
        let at = start + self.text[start..].find(word).expect("the word");
        let help = self.asking.word(at as u32, VisitChoice::Usual, Language::English).expect("a word");
        (help.value.unwrap_or_default(), help.facts.into_iter().map(|fact| fact.text).collect())
    }
}

/// The square of seed 002 with G12.1 and a cutter of radius 10.
const SQUARE: &str = "O1\nM45\nG28 H0\nG00 T0101\nG97 S100 M13\nG00 X80 Z30\nG98 G01 Z-20 F100\nG12.1\nG42 X50\nC25\nX-50\n\
                      C-25\nX50\nC0\nG40 X100\nG13.1\nM30\n";

fn square() -> Program {
    let setup = r#"{"tools": {"T0101": {"toolRadius": 10, "type": "endmill", "geometryR": 10}}}"#;
    Program::with(SQUARE, Setup::from_json(setup).expect("a setup"))
}

/// X and C are the coordinates of the virtual plane, both in mm as in the program; Z stays.
#[test]
fn the_state_under_g121_is_in_the_words_of_the_program() {
    let mut square = square();
    assert_eq!(square.axes(8), ["X Ø80 mm > Ø80 mm", "Z -20 mm > -20 mm", "C 0° > 0 mm"]);
    assert_eq!(square.axes(9), ["X Ø80 mm > Ø50 mm", "Z -20 mm > -20 mm", "C 0 mm > 0 mm"]);
    assert_eq!(square.axes(10), ["X Ø50 mm > Ø50 mm", "Z -20 mm > -20 mm", "C 0 mm > 25 mm"]);
    assert_eq!(square.axes(12), ["X Ø-50 mm > Ø-50 mm", "Z -20 mm > -20 mm", "C 25 mm > -25 mm"]);
    // After a full turn C is at 360°.
    assert_eq!(square.axes(16), ["X Ø100 mm > Ø100 mm", "Z -20 mm > -20 mm", "C 0 mm > 360°"]);
    assert!(square.word(10, "C25").1.contains(&"From 0 mm to 25 mm.".to_owned()));
    assert!(square.word(9, "X50").1.contains(&"From Ø80 mm to Ø50 mm.".to_owned()));
}

/// The cutter passes 10 mm beside the square: from X80 to X70 (5 mm of radius, 3 s), then 35 mm up to its
/// corner at 45° (21 s), 70 mm to the next one (42 s).
#[test]
fn the_sentence_under_g121_is_of_the_block_itself() {
    let mut square = square();
    assert_eq!(square.explanation(9), "Cuts straight from X80 C0 to X50 C0: 15 mm. Time 3 s at 100 mm/min.");
    assert_eq!(
        square.explanation(10),
        "Cuts straight from X50 C0 to X50 C25: 25 mm. Turns C to 45°. Time 21 s at 100 mm/min."
    );
    assert_eq!(
        square.explanation(11),
        "Cuts straight from X50 C25 to X-50 C25: 50 mm. Turns C to 135°. Time 42 s at 100 mm/min."
    );
    assert_eq!(square.letters(10), ["X/U", "C/H", "F"]);
}

/// Haas names the second axis Y: the help describes it as C, as which it is read.
#[test]
fn y_under_g112_is_the_second_axis() {
    let mut program = Program::new(
        "O1\nM45\nG28 H0\nG00 T0101\nG97 S100 M13\nG00 X80 Z30\nG98 G01 Z-20 F100\nG112\nG01 X50\nY25\nX-50\nV-50\nG113\nM30\n",
    );
    assert_eq!(program.axes(10), ["X Ø50 mm > Ø50 mm", "Z -20 mm > -20 mm", "C 0 mm > 25 mm"]);
    assert_eq!(program.letters(10), ["X/U", "C/H", "F"]);
    let explained = program.explanation(10);
    assert!(explained.starts_with("Cuts straight from X50 C0 to X50 C25: 25 mm."), "{explained}");
    let (value, facts) = program.word(10, "Y25");
    assert_eq!(value, "25 mm");
    assert!(facts.contains(&"From 0 mm to 25 mm.".to_owned()), "{facts:?}");
    assert_eq!(program.word(12, "V-50").0, "-50 mm");
}

/// Q3 would mean thousands of pecks of 0.003 mm: the control uses 3 mm, and so does the help.
#[test]
fn the_peck_of_a_hole_counts_as_the_control_took_it() {
    let counts = |facts: &[String]| facts.iter().any(|fact| fact.contains("without a point"));
    for (word, in_increments) in [("Q3", false), ("Q3.", false), ("Q3000", true)] {
        let text = format!("O1\nT0101\nG97 S800 M03\nG00 X0 Z5\nG98 G83 Z-40 R-3 {word} F100\nG80\nM30\n");
        let mut program = Program::new(text.leak());
        let (value, facts) = program.word(5, word);
        assert_eq!((value.as_str(), counts(&facts)), ("3 mm", in_increments), "{word}: {facts:?}");
    }
}

/// On the cylinder, C is an angle: 90° at a radius of 20 mm is 31.42 mm.
#[test]
fn the_state_and_the_sentence_under_g071() {
    let mut program = Program::new(
        "O1\nM45\nG28 H0\nG97 S100 M13\nG00 X40 Z-5\nG98 G01 X36 F100\nG07.1 C20\nG01 Z-15 F100\nC90\nZ-5 C180\nG07.1 C0\nM30\n",
    );
    assert_eq!(program.axes(9), ["X Ø36 mm > Ø36 mm", "Z -15 mm > -15 mm", "C 0° > 90°"]);
    let explained = program.explanation(9);
    assert!(
        explained.starts_with("Cuts straight from Z-15 C0 to Z-15 C90: 31.42 mm. Turns C to 90°."),
        "{explained}"
    );
    assert_eq!(program.word(9, "C90").0, "90°");
    assert_eq!(program.letters(9), ["Z/W", "C/H", "F"]);
}

/// With C connected, a move can program it; a rapid with X and C moves both.
#[test]
fn c_beside_x_and_z() {
    let mut program = Program::new("O1\nM45\nG28 H0\nG00 X50 Z2\nG00 X40 C90\nG98 G01 C180 F360\nM30\n");
    let explained = program.explanation(5);
    assert!(explained.starts_with("Rapid from X50 Z2 to X40 Z2. Turns C to 90°."), "{explained}");
    let explained = program.explanation(6);
    assert!(explained.starts_with("Turns C to 180°."), "{explained}");
    assert_eq!(program.letters(6), ["X/U", "Z/W", "C/H", "F", ",C", ",R", ",A"]);
}

const COMPENSATED: &str =
    "O1\nT0101 M3 S1000\nG00 X60 Z5\nG42 G00 X30 Z2\nG99 G01 Z-20 F0.2\nX40\nX50 Z-40\nG40 G00 X60\nM30\n";

fn compensated(text: &'static str) -> Program {
    let setup = r#"{"tools": {"T0101": {"noseRadius": 0.8, "tip": 3}}}"#;
    Program::with(text, Setup::from_json(setup).expect("a setup"))
}

/// With G42 each move is made while a later block is read; the sentence uses the programmed positions of the
/// block.
#[test]
fn the_sentence_under_g42_is_of_the_block_itself() {
    let mut program = compensated(COMPENSATED);
    let begins = |explained: String, expected: &str| assert!(explained.starts_with(expected), "{explained}");
    begins(program.explanation(4), "Rapid from X60 Z5 to X30 Z2.");
    begins(program.explanation(5), "Cuts straight from X30 Z2 to X30 Z-20: 22 mm.");
    begins(program.explanation(6), "Cuts straight from X30 Z-20 to X40 Z-20: 5 mm.");
    // 5 mm of radius along 20 mm: 14.036°.
    begins(program.explanation(7), "Cuts a taper from X40 Z-20 to X50 Z-40, 14.0362° to the Z axis.");
    begins(program.explanation(8), "Rapid from X50 Z-40 to X60 Z-40.");
}

/// A move that waits for its corner is explained with the corner, the next block without it.
#[test]
fn the_sentence_of_a_block_with_a_corner_is_of_the_block_itself() {
    let mut program =
        Program::new("O1\nT0101 M3 S1000\nG00 X30 Z2\nG99 G01 Z-20 ,C2 F0.2\nX50\nZ-40 A180\nG00 X60\nM30\n");
    let explained = program.explanation(4);
    let corner = "Cuts straight from X30 Z2 to X30 Z-18: 20 mm. Cuts a taper from X30 Z-18 to X34 Z-20, 45° to the Z axis.";
    assert!(explained.starts_with(corner), "{explained}");
    let explained = program.explanation(5);
    assert!(explained.starts_with("Cuts straight from X34 Z-20 to X50 Z-20: 8 mm."), "{explained}");
}

/// In a loop of one block, each execution has its own move, even if it is made during the next one.
#[test]
fn each_time_of_a_compensated_loop_has_its_own_sentence() {
    let mut program = compensated(
        "O1\nT0101 M3 S1000\nG00 X60 Z5\nG42 G00 X30 Z2\n#1=0\nWHILE[#1LT3]DO1\nG01 W-5 F0.2\n#1=#1+1\nEND1\nG01 X50\nX52 Z-20\nG40 G00 X60\nM30\n",
    );
    for (time, from, to) in [(1, 2, -3), (2, -3, -8), (3, -8, -13)] {
        let explained = program.state(7, VisitChoice::Number(time)).explanation;
        let expected = format!("Cuts straight from X30 Z{from} to X30 Z{to}: 5 mm.");
        assert!(explained.starts_with(&expected), "{time}: {explained}");
    }
}

/// R of a taper is modal with its code: without the word, the pass has the taper of the previous one.
#[test]
fn r_of_a_modal_taper_stays_in_force() {
    let mut program = Program::new(
        "O1\nT0101 M3 S800\nG00 X62 Z2\nG99 G90 X50 Z-30 R-5 F0.2\nX46\nG90 X44\nG94 X40 Z-5 R-3\nZ-7\nG92 X50 Z-20 R-1 F2\nX49\nG00 X80\nM30\n",
    );
    assert_eq!(program.otherwise(5, "R"), "Without it: -5 mm, as set before.");
    assert_eq!(program.otherwise(8, "R"), "Without it: -3 mm, as set before.");
    assert_eq!(program.otherwise(10, "R"), "Without it: -1 mm, as set before.");
    // Repeating the code resets the taper (seed 000).
    assert_eq!(program.otherwise(6, "R"), "Without it: 0.");
}

/// The pull-out of a pass ends farther out than the thread.
#[test]
fn the_last_pass_of_g76_is_its_last_cut() {
    let mut program = Program::new(
        "O1\nT0101 M3 S400\nG00 X60 Z10\nG76 P011060 Q100 R0.1\nG76 X33.8 Z-60 P2400 Q700 F4\nG00 X80\nM30\n",
    );
    let (_, facts) = program.word(5, "Q700");
    assert!(facts.contains(&"The last is at Ø33.8 mm.".to_owned()), "{facts:?}");
    assert!(program.explanation(5).contains("the last cuts at Ø33.8 mm"));
}

/// P and Q count millimetres if the setup says so (seed 003).
#[test]
fn p_and_q_in_millimetres() {
    let millimetres =
        || Setup::from_json(r#"{"dialect": {"control": "forum", "pqUnit": "mm"}}"#).expect("a setup");
    let thread =
        "O1\nM3 S200\nG00 X60 Z10\nG76 P011060 Q0.1 R0.1\nG76 X33.8 Z-60 R0 P2.4 Q0.7 F4\nG00 X80\nM30\n";
    let mut program = Program::with(thread, millimetres());
    assert_eq!(program.word(4, "Q0.1").0, "0.1 mm");
    let state = program.state(4, VisitChoice::Usual);
    let least = state.rows.iter().find(|row| row.name.contains("G76") && row.after == "0.1 mm");
    assert!(least.is_some() && !state.explanation.contains("0.0001"), "{state:#?}");
    assert_eq!(program.word(5, "P2.4").0, "2.4 mm");

    let mut program =
        Program::with("O1\nM3 S250\nG00 X0 Z2\nG74 R1\nG74 Z-12 Q5 F30\nG00 X60 Z40\nM30\n", millimetres());
    let (value, facts) = program.word(5, "Q5");
    assert_eq!(value, "5 mm");
    assert!(facts.iter().all(|fact| !fact.contains("0.001")), "{facts:?}");
    let groove = "O1\nM3 S250\nG00 X42 Z-20\nG75 R1\nG75 X30 Z-30 P3 Q2 F30\nG00 X60 Z40\nM30\n";
    let mut program = Program::with(groove, millimetres());
    for (word, expected) in [("P3", "3 mm"), ("Q2", "2 mm")] {
        let (value, facts) = program.word(5, word);
        assert_eq!(value, expected);
        assert!(facts.iter().all(|fact| !fact.contains("0.001")), "{facts:?}");
    }
    // On a control they count micrometres.
    let control = "O1\nM3 S250\nG00 X0 Z2\nG74 R1\nG74 Z-12 Q5000 F0.1\nG00 X60 Z40\nM30\n";
    let (value, facts) = Program::new(control).word(5, "Q5000");
    assert_eq!(value, "5 mm");
    assert!(facts.iter().any(|fact| fact.contains("0.001 mm")), "{facts:?}");
}

/// A tapered pass has no single diameter or Z.
#[test]
fn the_sentence_of_a_tapered_pass() {
    let mut program = Program::new(
        "O1\nT0101 M3 S800\nG00 X62 Z2\nG99 G90 X58 Z-25 R-10.8 F0.2\nG90 X56 Z-25\nG94 X40 Z-5 R-3\nG94 X40 Z-6\nG00 X80\nM30\n",
    );
    let begins = |explained: String, expected: &str| assert!(explained.starts_with(expected), "{explained}");
    begins(program.explanation(4), "G90: one taper pass from X36.4 Z2 to X58 Z-25, and back to the start.");
    begins(
        program.explanation(5),
        "G90: one pass at Ø56 mm, from X56 Z2 to X56 Z-25, and back to the start.",
    );
    begins(program.explanation(6), "G94: one taper pass from X62 Z-8 to X40 Z-5, and back to the start.");
    begins(program.explanation(7), "G94: one pass at Z-6, from X62 Z-6 to X40 Z-6, and back to the start.");
    let mut program = Program::new(
        "O1\nT0101 M3 S400\nG00 X60 Z10\nG76 P011060 Q100 R0.1\nG76 X33.8 Z-60 P2400 Q700 F4\nG76 P021560 Q100 R0.1\nG00 X80\nM30\n",
    );
    let (_, facts) = program.word(4, "P011060");
    assert!(
        facts.contains(&"Finishing passes: 1. Pull-out: 1 × lead. Tool angle: 60°.".to_owned()),
        "{facts:?}"
    );
    let (_, facts) = program.word(6, "P021560");
    assert!(
        facts.contains(&"Finishing passes: 2. Pull-out: 1.5 × lead. Tool angle: 60°.".to_owned()),
        "{facts:?}"
    );
}

/// A block without a motion code and without an axis has no form.
#[test]
fn a_block_that_moves_nothing_has_no_form() {
    let mut program = Program::new(
        "O1\nT0101 M3 S400\nG00 X60 Z10\nM05\nM712\nS300 M03\nG97 S500\nG99 F0.2\nG32 Z-20 F2\nM05\nX70\nM30\n",
    );
    for line in [2, 4, 5, 6, 7, 8, 10, 12] {
        assert!(program.form(line).is_none(), "line {line}");
    }
    for line in [3, 9, 11] {
        assert!(program.form(line).is_some(), "line {line}");
    }
}

/// The offset in force: wear of the setup, and what G10 adds to it. X on the diameter, in the unit of the reader.
#[test]
fn a_tool_word_says_how_far_its_offset_moves_the_tip() {
    let text = "(TOOL T0101 TYPE=TURNING WEARX=0.04)\nT0101\nG10 P1 U0.02 W-0.1\nT0101\nT0100\n";
    let mut program = Program::new(text);
    let facts = |program: &mut Program, line: usize, language: Language| {
        let byte = program.byte(line);
        let help = program.asking.word(byte, VisitChoice::Usual, language).expect("help");
        help.facts.iter().map(|fact| fact.text.clone()).collect::<Vec<_>>().join(" ")
    };
    let english = |program: &mut Program, line| facts(program, line, Language::English);
    assert!(english(&mut program, 2).contains("moves the tip: X by 0.04 mm on the diameter, Z by 0 mm"));
    assert!(english(&mut program, 4).contains("moves the tip: X by 0.06 mm on the diameter, Z by -0.1 mm"));
    assert!(!english(&mut program, 5).contains("moves the tip"));
    assert!(facts(&mut program, 2, Language::Chinese).contains("刀补使刀尖移动"));
    assert!(facts(&mut program, 2, Language::Russian).contains("Коррекция смещает вершину"));
}

/// The contour is in lines 6 to 9, with F in lines 6 and 8; F of roughing has the value of line 6.
const FINISHED: &str = "O1\nT0101 M3 S800 G99\nG0 X52 Z2\nG71 U2 R1\nG71 P10 Q20 U0.4 W0.1 F0.1\nN10 G0 X20 F0.1\nG1 Z-20\n\
                        X40 Z-30 F0.15\nN20 X52\nG70 P10 Q20\nM30\n";

#[test]
fn the_feed_of_finishing_comes_from_the_contour() {
    let mut program = Program::new(FINISHED);
    let mut feed = |line: usize, word: &str| {
        let facts = program.word(line, word).1;
        facts.into_iter().find(|fact| fact.starts_with("Feed rate")).unwrap_or_default()
    };
    assert_eq!(feed(7, "Z-20"), "Feed rate here: 0.1 mm/rev, from line 6.");
    assert_eq!(feed(9, "X52"), "Feed rate here: 0.15 mm/rev, from line 8.");
    assert_eq!(feed(10, "P10"), "Feed rate here: the F words of the contour, the first in line 6.");
    // Without F in the contour, that of roughing is in force.
    let mut program = Program::new(
        "O1\nT0101 M3 S800 G99\nG0 X52 Z2\nG71 U2 R1\nG71 P10 Q20 U0.4 W0.1 F0.2\nN10 G0 X20\nN20 G1 Z-20\nG70 P10 Q20\nM30\n",
    );
    assert!(program.word(8, "P10").1.contains(&"Feed rate here: 0.2 mm/rev, from line 5.".to_owned()));
}

#[test]
fn all_cycles_that_read_a_contour_are_named() {
    let read = |text: &'static str| {
        let facts = Program::new(text).word(7, "Z-20").1;
        facts.into_iter().filter(|fact| fact.starts_with("Read by")).collect::<Vec<_>>()
    };
    assert_eq!(
        read(FINISHED),
        ["Read by a roughing cycle and by finishing (G70) as a part of their contour."]
    );
    let roughed = "O1\nT0101 M3 S800 G99\nG0 X52 Z2\nG71 U2 R1\nG71 P10 Q20 U0.4 W0.1 F0.1\nN10 G0 X20\nG1 Z-20\nN20 X52\nM30\n";
    assert_eq!(read(roughed), ["Read by a roughing cycle as a part of its contour."]);
    let finished =
        "O1\nT0101 M3 S800 G99\nG0 X52 Z2\n\nG70 P10 Q20 F0.1\nN10 G0 X20\nG1 Z-20\nN20 X52\nM30\n";
    assert_eq!(read(finished), ["Read by finishing (G70) as a part of its contour."]);
}
