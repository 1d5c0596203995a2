//! The head of an exercise file: lines `key: value` between two lines `---`.
//!
//! In: the lines of the file. Out: a [`Head`]. Each key appears at most once.

use super::Kind;
use super::checks::Checks;
use super::codes;
use super::fault::{Part, Problem, ReadError, at_most};
use super::values::{Range, Tolerance, position};
use crate::message::levels::nearest_of;
use crate::setup::dialect::Control;
use crate::units::read_number;

/// Most lines of a head.
const MOST_LINES: usize = 40;
/// Most predicted lines.
const MOST_PREDICTED: usize = 20;
/// Longest name of an exercise or of a page, characters.
const LONGEST_NAME: usize = 60;
/// Most points.
const MOST_POINTS: f64 = 1000.0;
/// Least distance of a safe end from the blank if none is given, and the greatest one, mm.
const SAFE_END: f64 = 2.0;
const MOST_SAFE_END: f64 = 1000.0;
/// Largest rounding of inside corners, mm.
const MOST_CORNER: f64 = 5.0;
/// Rounding of inside corners that tools leave, mm, if none is given.
const CORNER: f64 = 0.5;
/// Tolerance of sizes without their own, mm, if none is given.
const GENERAL: Tolerance = Tolerance::both(0.1);

/// The keys, in the order of the documentation.
const KEYS: [&str; 19] = [
    "id",
    "kind",
    "points",
    "chapter",
    "control",
    "tolerance",
    "corners",
    "require",
    "forbid",
    "depth",
    "feed",
    "speed",
    "cutting-speed",
    "time",
    "cuts-to",
    "safe-end",
    "collisions",
    "alarms",
    "predict",
];

/// The values of the head.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Head {
    pub id: String,
    pub kind: Kind,
    pub points: u32,
    pub chapter: Option<String>,
    pub control: Option<Control>,
    /// Tolerance of the sizes without an explicit one.
    pub tolerance: Tolerance,
    /// Largest rounding of inside corners, mm.
    pub corners: f64,
    pub checks: Checks,
    /// One past the index of the last line of the head.
    pub end: usize,
}

impl Head {
    /// Reads the head at the beginning of the lines of a file.
    pub(super) fn read(lines: &[&str]) -> Result<Self, ReadError> {
        if lines.first().map(|line| line.trim_end()) != Some("---") {
            return Err(ReadError::at(1, Problem::NoHead));
        }
        let rest = &lines[1..];
        let count = rest.iter().position(|line| line.trim_end() == "---");
        let count = count.ok_or(ReadError::at(1, Problem::HeadOpen))?;
        at_most(Part::Head, count, MOST_LINES, MOST_LINES + 2)?;
        let mut head = Self::empty(count + 2);
        let mut seen: Vec<&str> = Vec::new();
        for (line, number) in rest[..count].iter().zip(2..) {
            let (key, value) = entry(line, number)?;
            if seen.contains(&key) {
                return Err(ReadError::at(number, Problem::Twice { name: key.to_owned() }));
            }
            seen.push(key);
            head.set(key, value, number)?;
        }
        head.check(&seen)?;
        Ok(head)
    }

    fn empty(end: usize) -> Self {
        Self {
            id: String::new(),
            kind: Kind::default(),
            points: 10,
            chapter: None,
            control: None,
            tolerance: GENERAL,
            corners: CORNER,
            checks: Checks::default(),
            end,
        }
    }

    /// The keys that an exercise cannot do without.
    fn check(&self, seen: &[&str]) -> Result<(), ReadError> {
        let missing = |name| Err(ReadError::at(1, Problem::Missing { name }));
        if !seen.contains(&"id") {
            return missing("id");
        }
        if self.kind == Kind::Predict && self.checks.predict.is_empty() {
            return missing("predict");
        }
        Ok(())
    }

    fn set(&mut self, key: &'static str, value: &str, line: usize) -> Result<(), ReadError> {
        let taken = |expected: &'static str, taken: Option<()>| {
            taken.ok_or(ReadError::at(line, Problem::Value { key, expected }))
        };
        let range = |own: &mut Option<Range>| {
            let read = Range::read(value).map(|range| *own = Some(range));
            taken("0.1..0.3, ..2.5, 80..", read)
        };
        match key {
            "id" => taken(NAME, name(value).map(|name| self.id = name)),
            "kind" => {
                let kind = Kind::ALL.into_iter().find(|kind| kind.name() == value);
                taken("write, fault, predict, order, blanks", kind.map(|kind| self.kind = kind))
            }
            "points" => {
                let points = number(value, 1.0, MOST_POINTS).filter(|points| points.fract() == 0.0);
                taken("1 … 1000", points.map(|points| self.points = points as u32))
            }
            "chapter" => taken(NAME, name(value).map(|name| self.chapter = Some(name))),
            "control" => {
                let control = Control::ALL.into_iter().find(|control| control.name() == value);
                taken("fanuc, gsk, forum", control.map(|control| self.control = Some(control)))
            }
            "tolerance" => {
                let words: Vec<&str> = value.split_whitespace().collect();
                let read = Tolerance::read(&words).filter(|(_, count)| *count == words.len());
                taken("±0.1, +0.1 -0.05", read.map(|(tolerance, _)| self.tolerance = tolerance))
            }
            "corners" => {
                taken("0 … 5", number(value, 0.0, MOST_CORNER).map(|corners| self.corners = corners))
            }
            "require" => codes::read(key, value, line).map(|codes| self.checks.require = codes),
            "forbid" => codes::read(key, value, line).map(|codes| self.checks.forbid = codes),
            "depth" => range(&mut self.checks.depth),
            "feed" => range(&mut self.checks.feed),
            "speed" => range(&mut self.checks.speed),
            "cutting-speed" => range(&mut self.checks.cutting_speed),
            "time" => range(&mut self.checks.time),
            "cuts-to" => taken("X26 Z-30", position(value).map(|at| self.checks.cuts_to = Some(at))),
            "safe-end" => taken("no, yes, 10", safe_end(value).map(|end| self.checks.safe_end = end)),
            "collisions" => {
                taken("none, any", is_none(value).map(|checked| self.checks.collisions = checked))
            }
            "alarms" => taken("none, any", is_none(value).map(|checked| self.checks.alarms = checked)),
            _ => taken("6, 8", lines_of(value).map(|lines| self.checks.predict = lines)),
        }
    }
}

/// What a name is made of; shown in a message.
const NAME: &str = "a-z, 0-9, -";

/// Key and value of a line.
fn entry(line: &str, number: usize) -> Result<(&'static str, &str), ReadError> {
    let (key, value) = line.split_once(':').ok_or(ReadError::at(number, Problem::HeadLine))?;
    let (key, value) = (key.trim_end(), value.trim());
    if value.contains(crate::source::is_unprintable) {
        return Err(ReadError::at(number, Problem::ControlCharacter));
    }
    let known = KEYS.into_iter().find(|known| *known == key);
    known.map(|known| (known, value)).ok_or_else(|| {
        let key: String = key.chars().take(LONGEST_NAME).collect();
        let nearest = nearest_of(&key, KEYS.into_iter());
        ReadError::at(number, Problem::UnknownKey { key, nearest })
    })
}

fn name(value: &str) -> Option<String> {
    let fits = |byte: u8| byte.is_ascii_lowercase() || byte.is_ascii_digit() || byte == b'-';
    let is_name = (1..=LONGEST_NAME).contains(&value.len()) && value.bytes().all(fits);
    is_name.then(|| value.to_owned())
}

fn number(value: &str, least: f64, most: f64) -> Option<f64> {
    read_number(value).filter(|number| (least..=most).contains(number))
}

/// `none` is checked, `any` is not.
fn is_none(value: &str) -> Option<bool> {
    match value {
        "none" => Some(true),
        "any" => Some(false),
        _ => None,
    }
}

/// The distance of a safe end from the blank, mm; `None` inside if it is not checked.
fn safe_end(value: &str) -> Option<Option<f64>> {
    match value {
        "no" => Some(None),
        "yes" => Some(Some(SAFE_END)),
        _ => number(value, 0.0, MOST_SAFE_END).map(Some),
    }
}

fn lines_of(value: &str) -> Option<Vec<u32>> {
    let lines: Option<Vec<u32>> = value.split(',').map(|line| line.trim().parse().ok()).collect();
    lines.filter(|lines| (1..=MOST_PREDICTED).contains(&lines.len()) && !lines.contains(&0))
}
