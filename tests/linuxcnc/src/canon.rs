//! In: the output of `rs274 -g`, a list of canonical functions. Out: the motions of each block.
//!
//! Comments written by [`crate::translate`] name the program and block of the lines that follow.

use std::collections::BTreeMap;

use gcode_playground::geometry::{Point, Turn};

use crate::motion::{Feed, Motion, Motions, Origin, Shape};

/// What `rs274` made of a program.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Run {
    /// Motions by block.
    pub motions: Motions,
    /// The block at which it stopped, and its error message.
    pub refused: Option<(usize, String)>,
    /// Its output lines, for reports.
    pub lines: Vec<String>,
}

/// The state of the machine that the canonical functions drive.
struct Machine {
    /// Millimetres in the unit of the numbers.
    unit: f64,
    /// Offsets of the frame and of G92: radius and Z, mm.
    frame: Point,
    preset: Point,
    /// Position of the tool without any offset, mm.
    at: Point,
    per_turn: bool,
    feed: f64,
    lead: Option<f64>,
}

/// All programs in an output, by name. An error may have cut the last one short.
pub fn read(output: &str) -> Result<BTreeMap<usize, Run>, String> {
    let mut runs: BTreeMap<usize, Run> = BTreeMap::new();
    let zero = Point::default();
    let mut machine =
        Machine { unit: 1.0, frame: zero, preset: zero, at: zero, per_turn: false, feed: 0.0, lead: None };
    let mut program = None;
    let mut block = None;
    for line in output.lines() {
        let Some((name, arguments)) = call(line) else { continue };
        if name == "COMMENT" {
            match arguments.trim_matches('"').split_at_checked(1) {
                Some(("P", number)) => (program, block) = (number.parse::<usize>().ok(), None),
                Some(("B", number)) => block = number.parse::<usize>().ok(),
                _ if arguments == "\"END\"" => (program, block) = (None, None),
                _ => {}
            }
            if let Some(program) = program {
                runs.entry(program).or_default();
            }
            continue;
        }
        let motion = machine.run(name, arguments).ok_or_else(|| format!("cannot read `{line}`"))?;
        let Some(run) = program.map(|program| runs.entry(program).or_default()) else { continue };
        let what = line.trim_start().split_once(' ').map_or(line, |(_, rest)| rest);
        run.lines.push(match block {
            Some(block) => format!("block {block:<3} {}", what.get(7..).unwrap_or(what)),
            None => what.to_owned(),
        });
        if let (Some(motion), Some(block)) = (motion, block) {
            run.motions.entry(block).or_default().push(motion);
        }
    }
    Ok(runs)
}

/// The name and the arguments of a canonical function.
fn call(line: &str) -> Option<(&str, &str)> {
    let (before, rest) = line.split_once('(')?;
    let arguments = rest.trim_end().strip_suffix(')')?;
    Some((before.split_whitespace().last()?, arguments))
}

impl Machine {
    /// Carries out one function. Returns `None` if it is malformed. Functions that do not matter here do
    /// nothing.
    fn run(&mut self, name: &str, arguments: &str) -> Option<Option<Motion>> {
        let numbers: Vec<f64> = arguments.split([',', ' ']).filter_map(|word| word.parse().ok()).collect();
        let number = |index: usize| numbers.get(index).copied();
        match name {
            "USE_LENGTH_UNITS" => {
                self.unit = match arguments {
                    "CANON_UNITS_MM" => 1.0,
                    "CANON_UNITS_INCHES" => 25.4,
                    _ => return None,
                }
            }
            "SET_G5X_OFFSET" => self.frame = self.point(number(1)?, number(3)?),
            "SET_G92_OFFSET" => self.preset = self.point(number(0)?, number(2)?),
            "SET_FEED_MODE" => self.per_turn = number(1)? != 0.0,
            "SET_FEED_RATE" => self.feed = number(0)? * self.unit,
            "START_SPEED_FEED_SYNC" | "START_SPEED_FEED_SYNCH" => self.lead = Some(number(0)? * self.unit),
            "STOP_SPEED_FEED_SYNC" | "STOP_SPEED_FEED_SYNCH" => self.lead = None,
            "STRAIGHT_TRAVERSE" => {
                let to = self.point(number(0)?, number(2)?);
                return Some(Some(self.go(Shape::Rapid, to)));
            }
            "STRAIGHT_FEED" => {
                let to = self.point(number(0)?, number(2)?);
                let shape = self.lead.map_or(Shape::Line, |lead| Shape::Thread { lead });
                return Some(Some(self.go(shape, to)));
            }
            "ARC_FEED" => {
                // The first axis of the plane G18 is Z.
                let to = self.point(number(1)?, number(0)?);
                let center = self.point(number(3)?, number(2)?);
                let turn = if number(4)? < 0.0 { Turn::Clockwise } else { Turn::Counterclockwise };
                return Some(Some(self.go(Shape::Arc { center, turn }, to)));
            }
            "DWELL" => {
                let at = self.here();
                return Some(Some(self.go(Shape::Dwell { seconds: number(0)? }, at)));
            }
            _ => {}
        }
        Some(None)
    }

    fn go(&mut self, shape: Shape, to: Point) -> Motion {
        let from = self.here();
        self.at = Point::new(to.x + self.frame.x + self.preset.x, to.z + self.frame.z + self.preset.z);
        let feed = if self.per_turn { Feed::PerTurn(self.feed) } else { Feed::PerMinute(self.feed) };
        Motion { shape, from, to, feed: Some(feed), origin: Origin::Program }
    }

    /// Position of the tool in the active frame.
    fn here(&self) -> Point {
        Point::new(self.at.x - self.frame.x - self.preset.x, self.at.z - self.frame.z - self.preset.z)
    }

    fn point(&self, x: f64, z: f64) -> Point {
        Point::new(x * self.unit, z * self.unit)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const OUTPUT: &str = r#"
    1 N..... USE_LENGTH_UNITS(CANON_UNITS_MM)
    2 N..... SET_G5X_OFFSET(1, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000)
    3 N..... STRAIGHT_TRAVERSE(9.0000, 0.0000, 9.0000, 0.0000, 0.0000, 0.0000)
   14 N..... COMMENT("P3")
   15 N..... COMMENT("B0")
   17 N0     STRAIGHT_TRAVERSE(25.0000, 0.0000, 5.0000, 0.0000, 0.0000, 0.0000)
   18 N0     SET_FEED_MODE(0, 1)
   18 N0     SET_FEED_RATE(0.2000)
   18 N0     COMMENT("B2")
   19 N1     START_SPEED_FEED_SYNC(1.500000,0)
   20 N1     STRAIGHT_FEED(25.0000, 0.0000, -10.0000, 0.0000, 0.0000, 0.0000)
   21 N1     STOP_SPEED_FEED_SYNCH()
   22 N1     SET_G92_OFFSET(20.0000, 0.0000, 5.0000, 0.0000, 0.0000, 0.0000)
   23 N1     ARC_FEED(-22.0000, 15.0000, -21.0000, 17.0000, -1, 0.0000, 0.0000, 0.0000, 0.0000)
   23 N1     DWELL(1.5000)
"#;

    #[test]
    fn motions_are_read_with_their_blocks_units_and_frames() {
        let runs = read(OUTPUT).unwrap();
        assert_eq!(runs.keys().collect::<Vec<_>>(), [&3]);
        let motions = &runs[&3].motions;
        assert_eq!(motions[&0][0].shape, Shape::Rapid);
        assert_eq!(motions[&0][0].from, Point::new(9.0, 9.0));
        let [thread, arc, dwell] = motions[&2][..] else { panic!("{motions:?}") };
        assert_eq!(thread.shape, Shape::Thread { lead: 1.5 });
        assert_eq!(thread.feed, Some(Feed::PerTurn(0.2)));
        assert_eq!(arc.from, Point::new(5.0, -15.0));
        assert_eq!(arc.to, Point::new(15.0, -22.0));
        assert_eq!(arc.shape, Shape::Arc { center: Point::new(17.0, -21.0), turn: Turn::Clockwise });
        assert_eq!((dwell.shape, dwell.to), (Shape::Dwell { seconds: 1.5 }, arc.to));
    }

    #[test]
    fn a_function_that_is_not_written_as_expected_is_told() {
        assert!(read("1 N1 STRAIGHT_FEED(25.0000)").is_err());
        assert!(read("1 N1 SOMETHING_NEW(1)").is_ok());
    }
}
