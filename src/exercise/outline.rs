//! Reads the lines of the outline of a target.
//!
//! ```text
//! X0 Z0                        the first point: X is a diameter
//! X25 ±0.1                     a face, with the tolerance of its Z
//! Z-20 +0 -0.05 width ±0.1     a cylinder, with the tolerance of its diameter; the bottom of a groove
//! X30 Z-30 ±0.05 angle ±0.2    a cone
//! G03 X40 Z-35 R5 ±0.1         an arc, with the tolerance of its radius
//! Z-60 thread 2 root 37.4 ±0.1
//! Z-80 free                    not measured
//! flats 6 width 24 ±0.1 Z-10   a hexagon that is milled down to Z-10; no edge
//! X25 ±0.1 (Z-30)              a comment
//! ```
//!
//! In: the lines. Out: the edges, or the first fault with the index of its line.

use super::edge::{Edge, Size, ThreadOf};
use super::fault::TargetFault;
use super::flats::Flats;
use super::values::Tolerance;
use crate::control::arcs::{CenterWords, center};
use crate::geometry::{Arc, Point, Turn};
use crate::setup::blank::Outline;
use crate::units::{Diameter, read_number};

/// Longest word in a message, characters.
const SHOWN: usize = 20;

/// Reads the edges and the flats; `general` is the tolerance of sizes without their own.
pub(super) fn read(
    lines: &[&str],
    general: Tolerance,
) -> Result<(Vec<Edge>, Option<Flats>), (usize, TargetFault)> {
    let lines: Vec<(usize, String)> = lines.iter().map(|line| without_comments(line)).enumerate().collect();
    let lines: Vec<(usize, &str)> =
        lines.iter().map(|(at, line)| (*at, line.trim())).filter(|(_, line)| !line.is_empty()).collect();
    if lines.len() > TargetFault::MOST_LINES {
        return Err((lines[TargetFault::MOST_LINES].0, TargetFault::TooMany { lines: lines.len() }));
    }
    let mut rest = lines.into_iter();
    let (at, first) = rest.next().ok_or((0, TargetFault::TooFew))?;
    let mut place = first_point(first).map_err(|fault| (at, fault))?;
    let (mut edges, mut flats) = (Vec::new(), None);
    for (at, line) in rest {
        if let Some(words) = line.strip_prefix("flats ") {
            let words: Vec<&str> = words.split_whitespace().collect();
            flats = Some(Flats::read(&words).map_err(|fault| (at, fault))?);
            continue;
        }
        let edge =
            Line::read(line).and_then(|line| line.edge(place, general)).map_err(|fault| (at, fault))?;
        place = edge.to;
        edges.push(edge);
    }
    Ok((edges, flats))
}

/// The line without what is in parentheses.
fn without_comments(line: &str) -> String {
    let mut pieces = line.split('(');
    let first = pieces.next().unwrap_or_default().to_owned();
    first + &pieces.map(|piece| piece.split_once(')').map_or("", |(_, after)| after)).collect::<String>()
}

fn first_point(line: &str) -> Result<Point, TargetFault> {
    match Line::read(line)? {
        Line { turn: None, x: Some(x), z: Some(z), radius: None, words } if words.is_empty() => {
            Ok(Point::new(x.radius(), z))
        }
        _ => Err(TargetFault::First),
    }
}

/// A line: its coordinates, and the words after them.
struct Line<'a> {
    turn: Option<Turn>,
    x: Option<Diameter>,
    z: Option<f64>,
    radius: Option<f64>,
    words: Vec<&'a str>,
}

impl<'a> Line<'a> {
    fn read(line: &'a str) -> Result<Self, TargetFault> {
        let mut read = Self { turn: None, x: None, z: None, radius: None, words: Vec::new() };
        let mut words = line.split_whitespace().peekable();
        read.turn = match words.peek().map(|word| word.to_ascii_uppercase()).as_deref() {
            Some("G02" | "G2") => Some(Turn::Clockwise),
            Some("G03" | "G3") => Some(Turn::Counterclockwise),
            _ => None,
        };
        if read.turn.is_some() {
            words.next();
        }
        while let Some(word) = words.next_if(|word| word.starts_with(['X', 'x', 'Z', 'z', 'R', 'r'])) {
            read.coordinate(word)?;
        }
        read.words = words.collect();
        Ok(read)
    }

    fn coordinate(&mut self, word: &str) -> Result<(), TargetFault> {
        let value = read_number(&word[1..]).ok_or_else(|| wrong(word))?;
        let is_negative = value < 0.0 && !word.starts_with(['Z', 'z']);
        if is_negative || value.abs() > Outline::FARTHEST {
            return Err(TargetFault::Range { word: shown(word) });
        }
        let is_twice = match word.as_bytes()[0] {
            b'X' | b'x' => self.x.replace(Diameter::new(value)).is_some(),
            b'Z' | b'z' => self.z.replace(value).is_some(),
            _ => self.radius.replace(value).is_some(),
        };
        if is_twice { Err(wrong(word)) } else { Ok(()) }
    }

    /// The edge from a point.
    fn edge(self, from: Point, general: Tolerance) -> Result<Edge, TargetFault> {
        let to = Point::new(self.x.map_or(from.x, Diameter::radius), self.z.unwrap_or(from.z));
        if from.is_same(to) {
            return Err(TargetFault::NoMove);
        }
        let mut edge = Edge { arc: self.arc(from, to)?, ..Edge::line(from, to, general) };
        let mut rest = &self.words[..];
        if let Some((tolerance, count)) = Tolerance::read(rest) {
            edge.tolerance = tolerance;
            rest = &rest[count..];
        }
        while let Some((&word, after)) = rest.split_first() {
            rest = edge.add(word, after)?;
        }
        Ok(edge)
    }

    fn arc(&self, start: Point, end: Point) -> Result<Option<Arc>, TargetFault> {
        match (self.turn, self.radius) {
            (None, None) => Ok(None),
            (Some(turn), Some(radius)) => {
                let center = center(start, end, turn, CenterWords::Radius(radius)).ok().flatten();
                let center = center.ok_or(TargetFault::Radius)?;
                Ok(Some(Arc { start, end, center, turn }))
            }
            _ => Err(TargetFault::Radius),
        }
    }
}

impl Edge {
    /// Takes a word and those that belong to it; returns the others.
    fn add<'a, 'w>(&mut self, word: &str, after: &'a [&'w str]) -> Result<&'a [&'w str], TargetFault> {
        let tolerance = || Tolerance::read(after).ok_or_else(|| wrong(word));
        let (tolerance, count) = match word {
            "free" => {
                self.is_free = true;
                return Ok(after);
            }
            "thread" => return self.add_thread(after),
            "width" | "angle" => tolerance()?,
            _ => return Err(wrong(word)),
        };
        match (word, self.size()) {
            ("width", Size::Diameter) => self.width = Some(tolerance),
            ("angle", Size::Taper) => self.angle = tolerance,
            ("width", _) => return Err(TargetFault::NotFor { word: "width" }),
            _ => return Err(TargetFault::NotFor { word: "angle" }),
        }
        Ok(&after[count..])
    }

    /// Takes `2 root 27.4 ±0.1`, the words of a thread.
    fn add_thread<'a, 'w>(&mut self, words: &'a [&'w str]) -> Result<&'a [&'w str], TargetFault> {
        let number =
            |text: &str| read_number(text).filter(|value| (0.01..=Outline::FARTHEST).contains(value));
        let read = match words {
            [lead, "root", root, rest @ ..] => number(lead).zip(number(root)).zip(Tolerance::read(rest)),
            _ => None,
        };
        let ((lead, root), (tolerance, count)) = read.ok_or_else(|| wrong("thread"))?;
        if self.size() != Size::Diameter {
            return Err(TargetFault::NotFor { word: "thread" });
        }
        self.thread = Some(ThreadOf { lead, root: Diameter::new(root), tolerance });
        Ok(&words[3 + count..])
    }
}

fn wrong(word: &str) -> TargetFault {
    TargetFault::Word { word: shown(word) }
}

fn shown(word: &str) -> String {
    word.chars().take(SHOWN).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fault(text: &str) -> (usize, TargetFault) {
        let lines: Vec<&str> = text.lines().collect();
        read(&lines, Tolerance::both(0.1)).expect_err(text)
    }

    #[test]
    fn lines_become_edges() {
        let text = "X0 Z0\nX25 ±0.2 (Z0)\n(Ø25)\nZ-20 +0 -0.05 width ±0.3\nX30 Z-30 angle ±0.2\nG03 X40 Z-35 R5\n\
                    Z-60 ±0.04 (Ø40) thread 2 root 37.4 ±0.1\nZ-80 free\nflats 6 width 24 ±0.1 Z-10";
        let lines: Vec<&str> = text.lines().collect();
        let (edges, flats) = read(&lines, Tolerance::both(0.1)).expect("edges");
        let sizes: Vec<Size> = edges.iter().map(Edge::size).collect();
        use Size::*;
        assert_eq!(sizes, [Length, Diameter, Taper, Radius, Diameter, Diameter]);
        assert_eq!(edges[0].tolerance, Tolerance::both(0.2));
        assert_eq!(edges[1].tolerance, Tolerance { lower: -0.05, upper: 0.0 });
        assert_eq!((edges[1].width, edges[2].angle), (Some(Tolerance::both(0.3)), Tolerance::both(0.2)));
        let thread = edges[4].thread.expect("a thread");
        assert_eq!((thread.lead, thread.root.mm(), thread.tolerance.upper), (2.0, 37.4, 0.1));
        // From X30 Z-30 to X40 Z-35, a quarter with its centre below the end.
        let center = edges[3].arc.expect("an arc").center;
        assert!(center.distance(Point::new(15.0, -35.0)) < 1e-9, "{center:?}");
        assert!(edges[5].is_free && !edges[4].is_free);
        assert_eq!(flats.map(|own| own.count), Some(6));
    }

    #[test]
    fn faults_have_their_line() {
        let word = |word: &str| TargetFault::Word { word: word.to_owned() };
        assert_eq!(fault(""), (0, TargetFault::TooFew));
        assert_eq!(fault("X0"), (0, TargetFault::First));
        assert_eq!(fault("X0 Z0 ±0.1"), (0, TargetFault::First));
        assert_eq!(fault("X0 Z0\n\nX0"), (2, TargetFault::NoMove));
        assert_eq!(fault("X0 Z0\nX2O"), (1, word("X2O")));
        assert_eq!(fault("X0 Z0\nX20 X30"), (1, word("X30")));
        assert_eq!(fault("X0 Z0\nX20 wide"), (1, word("wide")));
        assert_eq!(fault("X0 Z0\nX-20"), (1, TargetFault::Range { word: "X-20".to_owned() }));
        assert_eq!(fault("X0 Z0\nX1e9"), (1, TargetFault::Range { word: "X1e9".to_owned() }));
        assert_eq!(fault("X0 Z0\nG02 X20 Z-1"), (1, TargetFault::Radius));
        assert_eq!(fault("X0 Z0\nG02 X20 Z-1 R2"), (1, TargetFault::Radius));
        assert_eq!(fault("X0 Z0\nX20 thread 2 root 18 ±1"), (1, TargetFault::NotFor { word: "thread" }));
        assert_eq!(fault("X0 Z0\nX20 thread 2"), (1, word("thread")));
        assert_eq!(fault("X0 Z0\nX20 width ±1"), (1, TargetFault::NotFor { word: "width" }));
        let many = "X0 Z0\n".to_owned() + &"X1 Z-1\nX0 Z0\n".repeat(60);
        assert_eq!(fault(&many).1, TargetFault::TooMany { lines: 121 });
    }
}
