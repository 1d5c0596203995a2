//! A replay finds the same state as stepping through the program: tested with random programs with calls,
//! loops, jumps and contours, and with different distances between snapshots.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::ops::Range;

use proptest::prelude::*;

use super::{Replay, VisitChoice};
use crate::control::modal::State;
use crate::run::Run;
use crate::setup::Setup;
use crate::text::parser::Resume;

/// A construct of a random program.
#[derive(Clone, Debug)]
enum Piece {
    Move {
        code: u8,
        x: u8,
        z: u8,
    },
    Feed {
        per_minute: bool,
        value: u8,
    },
    Speed {
        cutting: bool,
        value: u8,
    },
    Add {
        variable: u8,
        value: i8,
    },
    /// A turning cycle, and a block that continues it.
    Cycle {
        x: u8,
        z: u8,
    },
    Contour {
        depth: u8,
    },
    Loop {
        rounds: u8,
        body: Vec<Piece>,
    },
    /// Skips the body if a variable is larger than `above`.
    Skip {
        variable: u8,
        above: i8,
        body: Vec<Piece>,
    },
    Call {
        program: u8,
        repeats: u8,
    },
    Macro {
        program: u8,
        value: u8,
    },
}

fn piece() -> impl Strategy<Value = Piece> {
    let leaf = prop_oneof![
        4 => (0..2_u8, any::<u8>(), any::<u8>()).prop_map(|(code, x, z)| Piece::Move { code, x, z }),
        1 => (any::<bool>(), 1..200_u8).prop_map(|(per_minute, value)| Piece::Feed { per_minute, value }),
        1 => (any::<bool>(), 1..200_u8).prop_map(|(cutting, value)| Piece::Speed { cutting, value }),
        3 => (1..5_u8, any::<i8>()).prop_map(|(variable, value)| Piece::Add { variable, value }),
        1 => (0..40_u8, 1..20_u8).prop_map(|(x, z)| Piece::Cycle { x, z }),
        1 => (1..6_u8).prop_map(|depth| Piece::Contour { depth }),
        2 => (0..3_u8, 1..4_u8).prop_map(|(program, repeats)| Piece::Call { program, repeats }),
        2 => (0..3_u8, any::<u8>()).prop_map(|(program, value)| Piece::Macro { program, value }),
    ];
    leaf.prop_recursive(3, 24, 5, |inner| {
        let body = || prop::collection::vec(inner.clone(), 1..5);
        prop_oneof![
            (0..4_u8, body()).prop_map(|(rounds, body)| Piece::Loop { rounds, body }),
            (1..5_u8, any::<i8>(), body()).prop_map(|(variable, above, body)| Piece::Skip {
                variable,
                above,
                body
            }),
        ]
    })
}

/// Writes constructs as blocks. A called program has a higher number than its caller, so there is no
/// recursion.
struct Writer {
    text: String,
    sequence: u32,
    loops: u32,
    /// The program being written; 0 is the main program.
    program: u8,
}

impl Writer {
    fn line(&mut self, line: std::fmt::Arguments) {
        let _ = writeln!(self.text, "{line}");
    }

    fn pieces(&mut self, pieces: &[Piece]) {
        for piece in pieces {
            self.piece(piece);
        }
    }

    fn piece(&mut self, piece: &Piece) {
        match piece {
            Piece::Move { code, x, z } => self.line(format_args!("G{code} X[{x}+#1] Z-{z} ")),
            Piece::Feed { per_minute, value } => {
                let code = if *per_minute { 98 } else { 99 };
                self.line(format_args!("G{code} F{value}"));
            }
            Piece::Speed { cutting, value } => {
                self.line(format_args!("G{} S{value} M3", if *cutting { 96 } else { 97 }));
            }
            Piece::Add { variable, value } => {
                self.line(format_args!("#{variable}=#{variable}+[{value}]"));
                self.line(format_args!("#10{variable}=#{variable}"));
            }
            Piece::Cycle { x, z } => {
                self.line(format_args!("G90 X{} Z-{z} F0.2", 10 + x));
                self.line(format_args!("X{}", 9 + x));
            }
            Piece::Contour { depth } if self.program == 0 => {
                let first = self.next_sequence();
                let last = self.next_sequence();
                self.line(format_args!("G0 X60 Z2"));
                self.line(format_args!("G71 U{depth} R1"));
                self.line(format_args!("G71 P{first} Q{last} U0.4 W0.1 F0.3"));
                self.line(format_args!("N{first} G0 X30 F0.1"));
                self.line(format_args!("G1 Z-10"));
                self.line(format_args!("N{last} X60 Z-20"));
                self.line(format_args!("G70 P{first} Q{last}"));
            }
            Piece::Contour { .. } => self.line(format_args!("G4 X1")),
            Piece::Loop { rounds, body } if self.loops < 3 => {
                self.loops += 1;
                let number = self.loops;
                self.line(format_args!("#2{number}=0"));
                self.line(format_args!("WHILE[#2{number}LT{rounds}]DO{number}"));
                self.pieces(body);
                self.line(format_args!("#2{number}=#2{number}+1"));
                self.line(format_args!("END{number}"));
                self.loops -= 1;
            }
            Piece::Loop { body, .. } => self.pieces(body),
            Piece::Skip { variable, above, body } => {
                let after = self.next_sequence();
                self.line(format_args!("IF[#{variable}GT[{above}]]GOTO{after}"));
                // A jump must not leave a loop, so the body contains no further loops.
                let loops = std::mem::replace(&mut self.loops, 3);
                self.pieces(body);
                self.loops = loops;
                self.line(format_args!("N{after}"));
            }
            Piece::Call { program, repeats } => match self.callee(*program) {
                Some(callee) => self.line(format_args!("M98 P{repeats:03}{callee:04}")),
                None => self.line(format_args!("G0 U1")),
            },
            Piece::Macro { program, value } => match self.callee(*program) {
                Some(callee) => self.line(format_args!("G65 P{callee} A{value}. B2.")),
                None => self.line(format_args!("G0 W-1")),
            },
        }
    }

    fn next_sequence(&mut self) -> u32 {
        self.sequence += 1;
        self.sequence
    }

    fn callee(&self, program: u8) -> Option<u32> {
        (program >= self.program).then(|| u32::from(program) + 11)
    }
}

fn programs() -> impl Strategy<Value = String> {
    let body = || prop::collection::vec(piece(), 1..8);
    (body(), [body(), body(), body()]).prop_map(|(main, called)| {
        let mut writer = Writer {
            text: String::from("O1\nT0101\n#1=0\n#2=0\n#3=0\n#4=0\n"),
            sequence: 0,
            loops: 0,
            program: 0,
        };
        writer.pieces(&main);
        writer.line(format_args!("M30"));
        for (at, body) in called.iter().enumerate() {
            (writer.program, writer.sequence) = (at as u8 + 1, 0);
            writer.line(format_args!("O{}", at + 11));
            writer.pieces(body);
            writer.line(format_args!("M99"));
        }
        writer.text
    })
}

/// A block as executed when stepping through the program.
struct Stepped {
    before: State,
    after: State,
    motions: Range<usize>,
}

/// Maximum number of blocks to step through: calls in loops can make very many.
const MAX_STEPS: usize = 800;

/// The executions of each block, by its first byte; `None` if there are too many.
fn stepped(text: &str) -> Option<BTreeMap<u32, Vec<Stepped>>> {
    let mut run = Run::new(text.into(), Setup::default());
    let mut found: BTreeMap<u32, Vec<Stepped>> = BTreeMap::new();
    for _ in 0..MAX_STEPS {
        if run.finished || run.ended {
            return Some(found);
        }
        let (byte, before, first) =
            (run.at.byte, run.interpreter.state.clone(), run.interpreter.kept_motions());
        run.advance(1);
        let after = run.interpreter.state.clone();
        found.entry(byte).or_default().push(Stepped {
            before,
            after,
            motions: first..run.interpreter.kept_motions(),
        });
    }
    None
}

/// Whether two states are equal. `incomplete` is ignored: a snapshot moves it from the state to the motions.
fn same(one: &State, other: &State) -> bool {
    State { incomplete: other.incomplete, ..one.clone() } == *other
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 50, ..ProptestConfig::default() })]

    #[test]
    fn a_replay_finds_what_stepping_finds(
        text in programs(),
        stride in 1..40_usize,
        slice in 1..50_usize,
        continues in any::<bool>(),
    ) {
        let Some(stepped) = stepped(&text) else { return Ok(()) };
        let mut setup = Setup::default();
        setup.limits.stride = stride;
        let mut run = Run::new(text.clone().into(), setup);
        while !run.advance(slice) {}
        let mut earlier: Option<Replay> = None;
        for (&byte, steps) in &stepped {
            let line = text[..byte as usize].matches('\n').count() as u32;
            let mut find = |time| {
                let line = Resume::inside(byte, line);
                let mut replay = match earlier.take().filter(|_| continues) {
                    Some(earlier) => run.replay_after(earlier, line, byte, time),
                    None => run.replay(line, byte, time),
                };
                while !run.advance_replay(&mut replay, slice) {}
                let found = replay.found();
                earlier = Some(replay);
                found
            };
            let times = find(VisitChoice::Usual).visits;
            prop_assert!(times as usize >= steps.len(), "line {}: {times} times", line + 1);
            let mut carried_out = 0;
            for number in 1..=times {
                let visit = find(VisitChoice::Number(number)).visit.expect("a visit");
                prop_assert_eq!(visit.number, number);
                if visit.purpose.is_some() {
                    continue;
                }
                let step = &steps[carried_out];
                carried_out += 1;
                prop_assert_eq!(visit.carried_out as usize, carried_out);
                prop_assert!(same(&visit.before.state, &step.before), "line {}, time {number}: before", line + 1);
                prop_assert!(same(&visit.after.state, &step.after), "line {}, time {number}: after", line + 1);
                prop_assert_eq!(&visit.motions, &step.motions);
            }
            prop_assert_eq!(carried_out, steps.len(), "line {}", line + 1);
        }
    }
}
