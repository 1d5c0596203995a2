//! In: random numbers. Out: a neutral program. Most of it is correct; some blocks are wrong on purpose.

use std::f64::consts::TAU;

use gcode_playground::control::compensation::Side;
use gcode_playground::geometry::Turn;
use gcode_playground::units::Unit;

use crate::program::{
    Axis, Block, Center, Code, Count, DwellWord, FeedMode, Joined, Program, Straight, places_of,
};
use crate::random::Random;

/// Optional parts of the language.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Language {
    /// Frames with origins, set by G10 L2. Off because the playground does not carry them out yet.
    pub frame_origins: bool,
}

/// One program.
pub fn program(random: &mut Random, language: Language) -> Program {
    let start = (random.within(20_000, 200_000), random.within(-50_000, 100_000));
    let nose = random.pick(&[200, 400, 800, 1_200, 1_600]);
    let mut maker =
        Maker { random, language, unit: Unit::Millimetre, at: Some(start), nose, blocks: Vec::new() };
    if maker.random.percent(96) {
        maker.feed_mode();
    }
    for _ in 0..maker.random.within(3, 18) {
        maker.blocks();
    }
    let blocks = std::mem::take(&mut maker.blocks);
    Program { start, nose, blocks }
}

struct Maker<'r> {
    random: &'r mut Random,
    language: Language,
    unit: Unit,
    /// Tool position in the active frame, in counts, if it is a whole number of counts.
    at: Option<(Count, Count)>,
    nose: Count,
    blocks: Vec<Block>,
}

impl Maker<'_> {
    /// Adds the next block, or a few that belong together.
    fn blocks(&mut self) {
        match self.random.within(0, 99) {
            0..38 => self.straight(),
            38..66 => self.arc(),
            66..72 => self.thread(),
            72..77 => {
                let word = self.random.pick(&[DwellWord::X, DwellWord::U, DwellWord::P]);
                let milliseconds = self.random.within(1, 5_000);
                self.blocks.push(Block::Dwell { milliseconds, word });
            }
            77..81 => self.feed_mode(),
            81..83 => self.change_unit(),
            83..85 => {
                let (x, z) = self.axes();
                self.at = None;
                self.blocks.push(Block::Home { x, z });
            }
            85..91 => self.frame(),
            _ => self.compensated(),
        }
    }

    fn straight(&mut self) {
        let kind = if self.random.percent(25) { Straight::Rapid } else { Straight::Feed };
        let (x, z) = self.axes();
        let feed = self.feed(if kind == Straight::Feed { 20 } else { 0 });
        let code = self.code();
        self.blocks.push(Block::Straight { kind, x, z, feed, code });
    }

    fn thread(&mut self) {
        let (x, z) = match self.random.within(0, 2) {
            0 => self.axes(),
            _ => {
                let z = self.length(-80.0, 40.0);
                (Axis::Stay, self.axis(z, 1))
            }
        };
        let feed = if self.random.percent(70) { Some(self.lead()) } else { None };
        let code = self.code();
        self.blocks.push(Block::Straight { kind: Straight::Thread, x, z, feed, code });
    }

    /// Moves one or both axes to random positions.
    fn axes(&mut self) -> (Axis, Axis) {
        let (x, z) = (self.diameter(), self.length(-120.0, 60.0));
        match self.random.within(0, 4) {
            0 => (self.axis(x, 0), Axis::Stay),
            1 => (Axis::Stay, self.axis(z, 1)),
            _ => (self.axis(x, 0), self.axis(z, 1)),
        }
    }

    /// The word of an axis for a target: absolute, or incremental if the position is known. Index 0 is X.
    fn axis(&mut self, to: Count, index: usize) -> Axis {
        let incremental = self.random.percent(30);
        match self.at.map(|at| [at.0, at.1][index]) {
            Some(from) if incremental => {
                self.stand(index, Some(to));
                Axis::By(to - from)
            }
            None if incremental => Axis::By(self.length(-20.0, 20.0)),
            known => {
                // A move of one axis alone does not make an unknown position known.
                self.stand(index, known.and(Some(to)));
                Axis::To(to)
            }
        }
    }

    fn stand(&mut self, index: usize, to: Option<Count>) {
        if let (Some(at), Some(to)) = (&mut self.at, to) {
            *[&mut at.0, &mut at.1][index] = to;
        }
    }

    /// An arc of any quadrant and size, sometimes slightly wrong.
    fn arc(&mut self) {
        let turn = self.random.pick(&[Turn::Clockwise, Turn::Counterclockwise]);
        let radius = self.millimetres(0.2, 40.0);
        let (begin, end) = (self.random.fraction() * TAU, self.random.fraction() * TAU);
        // Radius values, in counts: the centre is rounded first, then the end is put as near to the circle as
        // possible. Sometimes the centre lies exactly along an axis, and one of I and K is not written.
        let (i, k) = match self.random.within(0, 9) {
            0 => (None, Some(-radius)),
            1 => (Some(radius), None),
            _ => (Some(-radius * begin.sin()), Some(-radius * begin.cos())),
        };
        let [i_written, k_written] = [i, k].map(|count| count.map(|count| count.round() as Count));
        let [i, k] = [i_written, k_written].map(|count| count.unwrap_or(0) as f64);
        let exact = i.hypot(k);
        let (mut dx, mut dz) =
            ((2.0 * (i + exact * end.sin())).round() as Count, (k + exact * end.cos()).round() as Count);
        let mut center = Center { r: None, i: i_written, k: k_written };
        match self.random.within(0, 99) {
            // A full circle.
            0..4 => (dx, dz) = (0, 0),
            // An end off the circle: within both tolerances, within one of them, or outside both.
            4..7 => dz += self.random.pick(&[-100, -30, -20, -15, -5, 5, 15, 20, 30, 100]),
            7..8 => dz += self.millimetres(-5.0, 5.0) as Count,
            8..9 => center = Center::default(),
            20..50 => {
                let half = (dx as f64 / 2.0).hypot(dz as f64) / 2.0;
                let sign = if self.random.percent(30) { -1 } else { 1 };
                let longer = match self.random.within(0, 19) {
                    0 => 0.0,
                    1 => self.random.pick(&[-20.0, -9.0, -5.0, -2.0, -1.0, 1.0, 2.0, 5.0]),
                    2 => half * -0.3 * self.random.fraction(),
                    _ => half * 4.0 * self.random.fraction() + 10.0,
                };
                let r = Some(sign * (half + longer).round().max(1.0) as Count);
                center = Center { r, i: None, k: None };
                if self.random.percent(1) {
                    center.i = Some(i as Count);
                }
                if self.random.percent(1) {
                    (dx, dz) = (0, 0);
                }
            }
            _ => {}
        }
        let (x, z) = (self.moved_by(dx, 0), self.moved_by(dz, 1));
        let (feed, code) = (self.feed(10), self.code());
        self.blocks.push(Block::Arc { turn, x, z, center, feed, code });
    }

    /// The word of an axis for a distance, absolute or incremental.
    fn moved_by(&mut self, by: Count, index: usize) -> Axis {
        if by == 0 && self.random.percent(50) {
            return Axis::Stay;
        }
        let to = self.at.map(|at| [at.0, at.1][index] + by);
        self.stand(index, to);
        match to {
            Some(to) if self.random.percent(70) => Axis::To(to),
            _ => Axis::By(by),
        }
    }

    fn feed_mode(&mut self) {
        let mode = self.random.pick(&[FeedMode::PerMinute, FeedMode::PerTurn]);
        let feed = if self.random.percent(97) { Some(self.feed_value()) } else { None };
        self.blocks.push(Block::Feed { mode, feed });
    }

    /// The other unit, and a move to a whole number of its increments.
    fn change_unit(&mut self) {
        self.unit = match self.unit {
            Unit::Millimetre => Unit::Inch,
            Unit::Inch => Unit::Millimetre,
        };
        self.blocks.push(Block::Unit(self.unit));
        self.at = None;
        if self.random.percent(70) {
            self.rapid_somewhere();
        }
    }

    fn frame(&mut self) {
        match self.random.within(0, if self.language.frame_origins { 12 } else { 9 }) {
            0..3 => {
                self.at = None;
                self.blocks.push(Block::Frame(self.random.within(0, 5) as usize));
            }
            3..6 => {
                self.at = None;
                let (x, z) = (self.length(-40.0, 40.0), self.length(-40.0, 40.0));
                let (x, z) = match self.random.within(0, 4) {
                    0 => (Some(x), None),
                    1 => (None, Some(z)),
                    2 => (Some(0), Some(0)),
                    _ => (Some(x), Some(z)),
                };
                self.blocks.push(Block::Local { x, z });
            }
            6..10 => {
                let (x, z) = self.axes();
                self.blocks.push(Block::Preset { x, z });
            }
            _ => {
                self.at = None;
                let frame = self.random.within(0, 5) as usize;
                let (x, z) = (self.length(-40.0, 40.0), self.length(-40.0, 40.0));
                self.blocks.push(Block::Origin { frame, x, z });
            }
        }
        if self.at.is_none() && self.random.percent(60) {
            self.rapid_somewhere();
        }
    }

    fn rapid_somewhere(&mut self) {
        let (x, z) = (self.diameter(), self.length(-120.0, 60.0));
        self.rapid_to(x, z);
    }

    fn rapid_to(&mut self, x: Count, z: Count) {
        self.at = Some((x, z));
        let (x, z) = (Axis::To(x), Axis::To(z));
        let code = self.code();
        self.blocks.push(Block::Straight { kind: Straight::Rapid, x, z, feed: None, code });
    }

    /// A contour with the nose on one side of it: approach, G41 or G42, elements, G40, and away.
    fn compensated(&mut self) {
        let side = self.random.pick(&[Side::Left, Side::Right]);
        let joined = self.random.pick(&[Joined::Alone, Joined::WithMove]);
        let mut contour = Contour { heading: self.random.pick(&HEADINGS), elements: Vec::new() };
        for _ in 0..self.random.within(1, 7) {
            contour.element(self);
        }
        let (first_heading, first) = contour.elements[0];
        // The entry usually continues straight into the contour: there both interpreters begin alike.
        let entry_heading = if self.random.percent(60) { first_heading } else { self.turned(first_heading) };
        let entry = Element::line(entry_heading, self.scaled(1.0, 12.0));
        self.rapid_somewhere();
        self.blocks.push(Block::Nose { side, tip: self.random.within(0, 9) as u8, joined });
        let rapid = self.random.percent(30);
        self.element(entry, rapid);
        self.element(first, false);
        for &(_, element) in &contour.elements[1..] {
            if self.random.percent(4) {
                self.blocks.push(Block::Dwell { milliseconds: 500, word: DwellWord::P });
            }
            let rapid = self.random.percent(3);
            self.element(element, rapid);
        }
        self.blocks.push(Block::NoseOff { joined: self.random.pick(&[Joined::Alone, Joined::WithMove]) });
        if self.random.percent(98) {
            self.rapid_somewhere();
        } else {
            self.arc();
        }
    }

    fn element(&mut self, element: Element, rapid: bool) {
        let (x, z) = (self.moved_by(2 * element.by.0, 0), self.moved_by(element.by.1, 1));
        let (x, z) = match (x, z) {
            (Axis::Stay, Axis::Stay) if element.arc.is_none() => (Axis::Stay, Axis::By(0)),
            axes => axes,
        };
        let code = self.code();
        let feed = self.feed(5);
        self.blocks.push(match element.arc {
            None if rapid => Block::Straight { kind: Straight::Rapid, x, z, feed: None, code },
            None => Block::Straight { kind: Straight::Feed, x, z, feed, code },
            Some((turn, (i, k))) => {
                let center = Center { r: None, i: Some(i), k: Some(k) };
                Block::Arc { turn, x, z, center, feed, code }
            }
        });
    }

    fn code(&mut self) -> Code {
        if self.random.percent(60) { Code::Written } else { Code::Modal }
    }

    fn feed(&mut self, chance: i64) -> Option<Count> {
        self.random.percent(chance).then(|| self.feed_value())
    }

    fn feed_value(&mut self) -> Count {
        self.millimetres(0.05, 300.0).round().max(1.0) as Count
    }

    fn lead(&mut self) -> Count {
        self.millimetres(0.25, 6.0).round().max(1.0) as Count
    }

    fn diameter(&mut self) -> Count {
        match self.random.percent(8) {
            true => self.length(-60.0, 0.0),
            false => self.length(0.0, 200.0),
        }
    }

    /// A length between two bounds in mm, in counts: often a round number.
    fn length(&mut self, low: f64, high: f64) -> Count {
        let exact = self.millimetres(low, high);
        let grain = self.random.pick(&[1.0, 10.0, 500.0, 1000.0]);
        ((exact / grain).round() * grain) as Count
    }

    /// A number of counts between two bounds in mm.
    fn millimetres(&mut self, low: f64, high: f64) -> f64 {
        let exact = low + (high - low) * self.random.fraction();
        exact / self.unit.millimetres() * 10f64.powi(places_of(self.unit) as i32)
    }

    /// Another direction, but not straight back: no two controls agree on such a corner.
    fn turned(&mut self, heading: (Count, Count)) -> (Count, Count) {
        let other = self.random.pick(&HEADINGS);
        if other == (-heading.0, -heading.1) { heading } else { other }
    }

    /// A multiple of five counts, which is a whole number of counts along any of [`HEADINGS`].
    fn scaled(&mut self, low: f64, high: f64) -> Count {
        (self.millimetres(low, high) / 5.0).round().max(1.0) as Count
    }
}

/// Directions in which five counts are whole counts of X (radius) and Z.
const HEADINGS: [(Count, Count); 12] = [
    (5, 0),
    (-5, 0),
    (0, 5),
    (0, -5),
    (3, 4),
    (3, -4),
    (-3, 4),
    (-3, -4),
    (4, 3),
    (4, -3),
    (-4, 3),
    (-4, -3),
];

/// One element of a contour: its increments in X (radius) and Z; for an arc also the centre from its start.
#[derive(Clone, Copy, Debug)]
struct Element {
    by: (Count, Count),
    arc: Option<(Turn, (Count, Count))>,
}

impl Element {
    fn line(heading: (Count, Count), fives: Count) -> Self {
        Self { by: (heading.0 * fives, heading.1 * fives), arc: None }
    }
}

/// A contour under construction: its elements and the heading of each at its start.
struct Contour {
    heading: (Count, Count),
    elements: Vec<((Count, Count), Element)>,
}

impl Contour {
    /// Adds an element: usually in a new direction, sometimes tangent to the one before.
    fn element(&mut self, maker: &mut Maker) {
        if maker.random.percent(60) {
            self.heading = maker.turned(self.heading);
        }
        let heading = self.heading;
        let short = maker.random.percent(8);
        let element = if maker.random.percent(60) {
            let low = maker.nose as f64 / 1000.0;
            let fives = if short { maker.scaled(0.05, low) } else { maker.scaled(3.0 * low, 25.0) };
            let mut element = Element::line(heading, fives);
            if maker.random.percent(10) {
                // In any direction at all.
                element.by.0 += maker.scaled(-2.0, 2.0);
                element.by.1 += maker.scaled(-2.0, 2.0);
            }
            element
        } else {
            let turn = maker.random.pick(&[Turn::Clockwise, Turn::Counterclockwise]);
            let low = maker.nose as f64 / 1000.0;
            let fives = if short { maker.scaled(0.3 * low, low) } else { maker.scaled(2.0 * low, 15.0) };
            // Whether an arc with exactly the nose radius fits depends on binary rounding.
            let fives = if 5 * fives == maker.nose { fives + 1 } else { fives };
            let end = maker.random.pick(&HEADINGS);
            // From a point of the circle to the centre: perpendicular to the heading, to the left with G03.
            let inwards = |heading: (Count, Count)| match turn {
                Turn::Counterclockwise => (heading.1 * fives, -heading.0 * fives),
                Turn::Clockwise => (-heading.1 * fives, heading.0 * fives),
            };
            let (from, to) = (inwards(heading), inwards(end));
            self.heading = end;
            Element { by: (from.0 - to.0, from.1 - to.1), arc: Some((turn, from)) }
        };
        self.elements.push((heading, element));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::translate;

    #[test]
    fn a_seed_gives_the_same_program_again() {
        let made = |index| program(&mut Random::new(1, index), Language::default());
        assert_eq!(made(5), made(5));
        assert_ne!(made(5), made(6));
    }

    #[test]
    fn every_kind_of_block_comes_up_and_can_be_written() {
        let programs: Vec<Program> = (0..300)
            .map(|index| program(&mut Random::new(2, index), Language { frame_origins: true }))
            .collect();
        let text: String = programs.iter().map(translate::ours).collect();
        for word in [
            "G00", "G01", "G02", "G03", "G04", "G10", "G20", "G21", "G28", "G32", "G40", "G41", "G42", "G50",
            "G52", "G54", "G59", "G98", "G99", " R-", " I", " K", " U", " W",
        ] {
            assert!(text.contains(word), "{word}");
        }
    }

    #[test]
    fn frames_get_origins_only_where_asked() {
        let blocks = |language| -> Vec<Block> {
            (0..200).flat_map(|index| program(&mut Random::new(3, index), language).blocks).collect()
        };
        let origins = |blocks: Vec<Block>| blocks.iter().any(|block| matches!(block, Block::Origin { .. }));
        assert!(!origins(blocks(Language::default())));
        assert!(origins(blocks(Language { frame_origins: true })));
    }
}
