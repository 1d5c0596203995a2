//! In: a neutral program. Out: its text for the playground (G-code system A) and for LinuxCNC.
//!
//! Line 1 of our text is the preamble; block `n` (from 0) is line `n + 2`. In LinuxCNC's text a comment
//! `(Bn)` precedes each block: comments keep their order relative to the motions, even if compensation delays
//! motions.

use std::fmt::Write;

use gcode_playground::control::compensation::Side;
use gcode_playground::geometry::Turn;
use gcode_playground::units::Unit;

use crate::program::{
    Axis, Block, Center, Code, Count, DwellWord, FeedMode, Joined, Program, Straight, places_of, written,
};

/// Index of the line with block 0 in our text, counted from 0.
pub const FIRST_LINE: u32 = 1;

/// Target of G28 in machine coordinates: diameter and Z, mm.
const REFERENCE: [f64; 2] = [300.0, 200.0];

/// The program in G-code system A.
pub fn ours(program: &Program) -> String {
    let mut text = String::from("G21 G98 G40 G18 M03 S500\n");
    let mut unit = Unit::Millimetre;
    let mut modal = None;
    let mut ahead = "";
    for (index, block) in program.blocks.iter().enumerate() {
        let next_is_straight = matches!(program.blocks.get(index + 1), Some(Block::Straight { .. }));
        let mut words = Vec::new();
        let number = |count: Count| written(count, places_of(unit));
        let axes = |words: &mut Vec<String>, x: Axis, z: Axis| {
            for (axis, absolute, incremental) in [(x, 'X', 'U'), (z, 'Z', 'W')] {
                match axis {
                    Axis::Stay => {}
                    Axis::To(count) => words.push(format!("{absolute}{}", number(count))),
                    Axis::By(count) => words.push(format!("{incremental}{}", number(count))),
                }
            }
        };
        let mut group_01 = |words: &mut Vec<String>, code: &'static str, how: Code| {
            if how == Code::Written || modal != Some(code) {
                words.push(code.to_owned());
            }
            modal = Some(code);
        };
        match *block {
            Block::Unit(new) => {
                unit = new;
                words.push(unit_code(new).to_owned());
            }
            Block::Feed { mode, feed } => {
                words.push(if mode == FeedMode::PerMinute { "G98" } else { "G99" }.to_owned());
                words.extend(feed.map(|feed| format!("F{}", number(feed))));
            }
            Block::Straight { kind, x, z, feed, code } => {
                words.extend((!ahead.is_empty()).then(|| std::mem::take(&mut ahead).to_owned()));
                let word = match kind {
                    Straight::Rapid => "G00",
                    Straight::Feed => "G01",
                    Straight::Thread => "G32",
                };
                group_01(&mut words, word, code);
                axes(&mut words, x, z);
                words.extend(feed.map(|feed| format!("F{}", number(feed))));
            }
            Block::Arc { turn, x, z, center, feed, code } => {
                group_01(&mut words, if turn == Turn::Clockwise { "G02" } else { "G03" }, code);
                axes(&mut words, x, z);
                words.extend(center_words(center, unit));
                words.extend(feed.map(|feed| format!("F{}", number(feed))));
            }
            Block::Dwell { milliseconds, word } => words.push(match word {
                DwellWord::X => format!("G04 X{}", written(milliseconds, 3)),
                DwellWord::U => format!("G04 U{}", written(milliseconds, 3)),
                DwellWord::P => format!("G04 P{milliseconds}"),
            }),
            Block::Home { x, z } => {
                words.push("G28".to_owned());
                axes(&mut words, x, z);
            }
            Block::Preset { x, z } => {
                words.push("G50".to_owned());
                axes(&mut words, x, z);
            }
            Block::Local { x, z } => {
                words.push("G52".to_owned());
                axes(&mut words, x.map_or(Axis::Stay, Axis::To), z.map_or(Axis::Stay, Axis::To));
            }
            Block::Frame(frame) => words.push(format!("G{}", 54 + frame)),
            Block::Origin { frame, x, z } => {
                words.push(format!("G10 L2 P{}", frame + 1));
                axes(&mut words, Axis::To(x), Axis::To(z));
            }
            Block::Nose { side, tip, joined } => {
                words.push(tool_word(tip));
                let code = if side == Side::Left { "G41" } else { "G42" };
                match joined {
                    Joined::WithMove if next_is_straight => ahead = code,
                    _ => words.push(code.to_owned()),
                }
            }
            Block::NoseOff { joined } => match joined {
                Joined::WithMove if next_is_straight => ahead = "G40",
                _ => words.push("G40".to_owned()),
            },
        }
        text.push_str(&words.join(" "));
        text.push('\n');
    }
    text.push_str("M30\n");
    text
}

/// The playground's setup for a program: the start position, and one tool for each tip.
pub fn setup(program: &Program) -> String {
    let (x, z, radius) =
        (millimetres(program.start.0), millimetres(program.start.1), millimetres(program.nose));
    let tools: Vec<String> = (0..10)
        .map(|tip| format!(r#""{}": {{"noseRadius": {radius}, "tip": {tip}}}"#, tool_word(tip)))
        .collect();
    let [home_x, home_z] = REFERENCE;
    format!(
        r#"{{"dialect": {{"strict": true, "refPoint": {{"x": {home_x}, "z": {home_z}}}}},
"initial": {{"x": {x}, "z": {z}}},
"tools": {{{}}}}}"#,
        tools.join(", ")
    )
}

/// The program for LinuxCNC. It first resets the machine to the start state. The comment `(Pn)` names it.
pub fn linuxcnc(program: &Program, name: usize) -> String {
    let mut text = String::new();
    let mut line = |words: std::fmt::Arguments| {
        let _ = writeln!(text, "{words}");
    };
    // The same initial state as ours: no offset, no feed, the tool at its start.
    line(format_args!("G40\nG21 G18 G7 G90 G94 G54\nG92.1\nF0\nM3 S500"));
    // These are radius and inches in every mode.
    line(format_args!("#5161={:.9}\n#5163={:.9}", REFERENCE[0] / 2.0 / 25.4, REFERENCE[1] / 25.4));
    for frame in 1..=6 {
        line(format_args!("G10 L2 P{frame} X0 Z0"));
    }
    line(format_args!("G0 X{} Z{}\n(P{name})", millimetres(program.start.0), millimetres(program.start.1)));
    let mut account = Account::new(program);
    for (index, block) in program.blocks.iter().enumerate() {
        line(format_args!("(B{index})"));
        for words in account.block(block, millimetres(program.nose)) {
            line(format_args!("N{index} {words}"));
        }
    }
    text.push_str("(END)\n");
    text
}

/// The state that a translation to LinuxCNC needs: the tool position (for U with Z, X with W, and G50 U W,
/// which LinuxCNC does not have), the local shift of G52, the lead of a thread.
struct Account {
    unit: Unit,
    /// Feed or lead, mm.
    feed: Option<f64>,
    /// Machine coordinates: X as a diameter, and Z; mm.
    machine: [f64; 2],
    /// Shift of all frames by G50, mm.
    shift: [f64; 2],
    /// Active frame.
    frame: usize,
    /// Origins of the frames (G10 L2), mm.
    origins: [[f64; 2]; 6],
    /// Local shift of all frames (G52), mm.
    local: [f64; 2],
    /// Origins as LinuxCNC has them. Inactive frames may lack the local shift.
    known: [[f64; 2]; 6],
}

impl Account {
    fn new(program: &Program) -> Self {
        Self {
            unit: Unit::Millimetre,
            feed: None,
            machine: [millimetres(program.start.0), millimetres(program.start.1)],
            shift: [0.0; 2],
            frame: 0,
            origins: [[0.0; 2]; 6],
            local: [0.0; 2],
            known: [[0.0; 2]; 6],
        }
    }

    /// The lines of a block.
    fn block(&mut self, block: &Block, nose: f64) -> Vec<String> {
        let places = places_of(self.unit);
        match *block {
            Block::Unit(unit) => {
                self.unit = unit;
                vec![unit_code(unit).to_owned()]
            }
            Block::Feed { mode, feed } => {
                let code = if mode == FeedMode::PerMinute { "G94" } else { "G95" };
                vec![format!("{code}{}", self.feed_word(feed))]
            }
            Block::Straight { kind: Straight::Thread, x, z, feed, .. } => {
                // G33 takes no F; ours keeps it as the feed, too.
                let feed_word = self.feed_word(feed);
                let axes = self.axes(x, z);
                let lead = self.feed.map(|lead| format!(" K{}", self.in_unit(lead))).unwrap_or_default();
                let mut lines = vec![];
                lines.extend((!feed_word.is_empty()).then(|| feed_word.trim().to_owned()));
                lines.push(format!("{axes}{lead}").replacen(' ', " G33 ", 1));
                lines
            }
            Block::Straight { kind, x, z, feed, .. } => {
                let code = if kind == Straight::Rapid { " G0 " } else { " G1 " };
                let feed = self.feed_word(feed);
                vec![format!("{}{feed}", self.axes(x, z)).replacen(' ', code, 1)]
            }
            Block::Arc { turn, x, z, center, feed, .. } => {
                let code = if turn == Turn::Clockwise { " G2 " } else { " G3 " };
                let feed = self.feed_word(feed);
                let center = center_words(center, self.unit).join(" ");
                vec![format!("{} {center}{feed}", self.axes(x, z)).replacen(' ', code, 1)]
            }
            Block::Dwell { milliseconds, .. } => vec![format!("G4 P{}", written(milliseconds, 3))],
            Block::Home { x, z } => {
                let axes = self.axes(x, z).replacen(' ', " G28 ", 1);
                for (index, axis) in [x, z].into_iter().enumerate() {
                    if axis != Axis::Stay {
                        self.machine[index] = REFERENCE[index];
                    }
                }
                vec![axes]
            }
            Block::Preset { x, z } => {
                let at = self.position();
                let mut words = String::from("G92");
                for (index, (axis, letter)) in [(x, 'X'), (z, 'Z')].into_iter().enumerate() {
                    let Some(new) = self.target(axis, at[index]) else { continue };
                    self.shift[index] += at[index] - new;
                    match axis {
                        Axis::To(count) => words += &format!(" {letter}{}", written(count, places)),
                        _ => words += &format!(" {letter}{}", self.in_unit(new)),
                    }
                }
                vec![words]
            }
            Block::Local { x, z } => {
                for (index, count) in [x, z].into_iter().enumerate() {
                    if let Some(count) = count {
                        self.local[index] = self.length(count);
                    }
                }
                vec![self.set_frame(self.frame)]
            }
            Block::Frame(frame) => {
                self.frame = frame;
                let mut lines = vec![];
                if self.known[frame] != self.origin(frame) {
                    lines.push(self.set_frame(frame));
                }
                lines.push(format!("G{}", 54 + frame));
                lines
            }
            Block::Origin { frame, x, z } => {
                self.origins[frame] = [self.length(x), self.length(z)];
                vec![self.set_frame(frame)]
            }
            Block::Nose { side, tip, .. } => {
                let code = if side == Side::Left { "G41.1" } else { "G42.1" };
                vec![format!("{code} D{} L{}", self.in_unit(2.0 * nose), orientation(tip))]
            }
            Block::NoseOff { .. } => vec!["G40".to_owned()],
        }
    }

    /// G90 or G91 and the words of the axes; U with Z and X with W become absolute.
    fn axes(&mut self, x: Axis, z: Axis) -> String {
        let at = self.position();
        let absolute = matches!(x, Axis::To(_)) || matches!(z, Axis::To(_));
        let mut words = String::from(if absolute { "G90 " } else { "G91 " });
        for (index, (axis, letter)) in [(x, 'X'), (z, 'Z')].into_iter().enumerate() {
            let Some(target) = self.target(axis, at[index]) else { continue };
            self.machine[index] += target - at[index];
            let number = match axis {
                Axis::By(_) if absolute => self.in_unit(target),
                Axis::To(count) | Axis::By(count) => written(count, places_of(self.unit)),
                Axis::Stay => continue,
            };
            words += &format!("{letter}{number} ");
        }
        words.trim_end().to_owned() + if words.len() == 4 { " " } else { "" }
    }

    fn target(&self, axis: Axis, at: f64) -> Option<f64> {
        match axis {
            Axis::Stay => None,
            Axis::To(count) => Some(self.length(count)),
            Axis::By(count) => Some(at + self.length(count)),
        }
    }

    /// Coordinates in the active frame, mm.
    fn position(&self) -> [f64; 2] {
        let origin = self.origin(self.frame);
        [0, 1].map(|index| self.machine[index] - self.shift[index] - origin[index])
    }

    /// Origin of a frame with the local shift, mm.
    fn origin(&self, frame: usize) -> [f64; 2] {
        [0, 1].map(|index| self.origins[frame][index] + self.local[index])
    }

    fn set_frame(&mut self, frame: usize) -> String {
        self.known[frame] = self.origin(frame);
        let [x, z] = self.known[frame].map(|place| self.in_unit(place));
        format!("G10 L2 P{} X{x} Z{z}", frame + 1)
    }

    fn feed_word(&mut self, feed: Option<Count>) -> String {
        let Some(count) = feed else { return String::new() };
        self.feed = Some(self.length(count));
        format!(" F{}", written(count, places_of(self.unit)))
    }

    fn length(&self, count: Count) -> f64 {
        count as f64 / 10f64.powi(places_of(self.unit) as i32) * self.unit.millimetres()
    }

    /// A length in mm, written in the active unit.
    fn in_unit(&self, length: f64) -> String {
        format!("{:.9}", length / self.unit.millimetres())
    }
}

fn center_words(center: Center, unit: Unit) -> Vec<String> {
    let words = [('R', center.r), ('I', center.i), ('K', center.k)];
    words
        .into_iter()
        .filter_map(|(letter, count)| Some(format!("{letter}{}", written(count?, places_of(unit)))))
        .collect()
}

fn unit_code(unit: Unit) -> &'static str {
    match unit {
        Unit::Millimetre => "G21",
        Unit::Inch => "G20",
    }
}

/// The T word for a tip: T0101 has tip 0.
fn tool_word(tip: u8) -> String {
    format!("T{0:02}{0:02}", tip + 1)
}

/// LinuxCNC counts the tips with X pointing down, so its numbers are ours mirrored in X.
fn orientation(tip: u8) -> u8 {
    match tip {
        1 => 4,
        2 => 3,
        3 => 2,
        4 => 1,
        6 => 8,
        8 => 6,
        same => same,
    }
}

/// A count of 0.001 mm, in mm.
pub fn millimetres(count: Count) -> f64 {
    count as f64 / 1000.0
}

#[cfg(test)]
mod tests {
    use super::*;

    fn program(blocks: Vec<Block>) -> Program {
        Program { start: (50_000, 5_000), nose: 800, blocks }
    }

    fn line(x: Axis, z: Axis) -> Block {
        Block::Straight { kind: Straight::Feed, x, z, feed: Some(100_000), code: Code::Modal }
    }

    /// Compares the blocks with their text in both languages; LinuxCNC's text is without reset and comments.
    fn check(blocks: Vec<Block>, in_ours: &str, in_linuxcnc: &str) {
        let program = program(blocks);
        let own = ours(&program);
        let own: Vec<&str> = own.lines().skip(1).take(program.blocks.len()).collect();
        assert_eq!(own.join("\n"), in_ours);
        let other = linuxcnc(&program, 7);
        let other: Vec<&str> = other.lines().filter(|line| line.starts_with('N')).collect();
        assert_eq!(other.join("\n"), in_linuxcnc);
    }

    #[test]
    fn increments_alone_are_g91_and_mixed_words_become_absolute() {
        check(
            vec![line(Axis::To(40_000), Axis::By(-2_500)), line(Axis::By(-1_000), Axis::Stay)],
            "G01 X40. W-2.5 F100.\nU-1. F100.",
            "N0 G90 G1 X40. Z2.500000000 F100.\nN1 G91 G1 X-1. F100.",
        );
    }

    #[test]
    fn a_thread_takes_its_lead_from_f_and_inches_are_converted() {
        let thread = Block::Straight {
            kind: Straight::Thread,
            x: Axis::Stay,
            z: Axis::To(-1),
            feed: None,
            code: Code::Written,
        };
        check(
            vec![Block::Feed { mode: FeedMode::PerTurn, feed: Some(2_540) }, Block::Unit(Unit::Inch), thread],
            "G99 F2.54\nG20\nG32 Z-0.0001",
            "N0 G95 F2.54\nN1 G20\nN2 G90 G33 Z-0.0001 K0.100000000",
        );
    }

    #[test]
    fn frames_are_moved_by_what_means_the_same() {
        check(
            vec![
                Block::Preset { x: Axis::To(0), z: Axis::By(1_000) },
                Block::Frame(1),
                Block::Local { x: Some(3_000), z: None },
                Block::Frame(2),
            ],
            "G50 X0. W1.\nG55\nG52 X3.\nG56",
            "N0 G92 X0. Z6.000000000\nN1 G55\nN2 G10 L2 P2 X3.000000000 Z0.000000000\n\
             N3 G10 L2 P3 X3.000000000 Z0.000000000\nN3 G56",
        );
    }

    #[test]
    fn g28_goes_home_in_the_axes_that_are_named() {
        check(
            vec![
                Block::Home { x: Axis::By(2_000), z: Axis::Stay },
                Block::Preset { x: Axis::By(0), z: Axis::By(0) },
            ],
            "G28 U2.\nG50 U0. W0.",
            "N0 G91 G28 X2.\nN1 G92 X300.000000000 Z5.000000000",
        );
    }

    #[test]
    fn compensation_may_begin_in_the_block_of_the_move_and_tips_are_mirrored() {
        check(
            vec![
                Block::Nose { side: Side::Right, tip: 3, joined: Joined::WithMove },
                line(Axis::Stay, Axis::To(0)),
                Block::NoseOff { joined: Joined::Alone },
            ],
            "T0404\nG42 G01 Z0. F100.\nG40",
            "N0 G42.1 D1.600000000 L2\nN1 G90 G1 Z0. F100.\nN2 G40",
        );
    }

    #[test]
    fn every_program_has_a_setup_we_can_read() {
        let setup = gcode_playground::setup::Setup::from_json(&setup(&program(vec![]))).unwrap();
        assert_eq!(setup.tools["T0404"].tip, Some(3));
        assert_eq!(setup.start().x.mm(), 50.0);
    }
}
