//! The checks of an exercise besides the part.
//!
//! In: the checks of the file, and an answer that has run. Out: one [`Checked`] for each check: passed or not, what
//! was found, and the place in the program.

use super::Exercise;
use super::Kind;
use super::answer::Answer;
use super::codes;
use super::depth::deepest;
use super::same_text::blocks_of;
use super::values::{Range, position};
use crate::control::words::plain;
use crate::machine::danger::Danger;
use crate::message::Diagnostic;
use crate::motion::{Motion, MotionKind, SpindleSpeed, Step};
use crate::playback::timing::{assumed_seconds, feed_at, seconds, speed_at, surface_speed};
use crate::source::Span;
use crate::text::block::Block;
use crate::text::parser::Parser;
use crate::units::Diameter;

/// Greatest distance of two places that are the same, mm.
const SAME_PLACE: f64 = 0.005;

/// What an exercise checks besides the part.
#[derive(Clone, Debug, PartialEq)]
pub struct Checks {
    /// Codes that the program must use, in the spelling of system A.
    pub require: Vec<String>,
    /// Codes that it must not use.
    pub forbid: Vec<String>,
    /// Depth of the deepest cut, mm on the radius.
    pub depth: Option<Range>,
    /// Feed of each cut, mm/rev.
    pub feed: Option<Range>,
    /// Spindle speed of each cut, rpm.
    pub speed: Option<Range>,
    /// Cutting speed at the end of each cut, m/min.
    pub cutting_speed: Option<Range>,
    /// Time of the whole program, seconds.
    pub time: Option<Range>,
    /// A place to which a cut must go: X as a diameter, and Z, mm.
    pub cuts_to: Option<[f64; 2]>,
    /// Least distance of the tip from the blank at the end, mm.
    pub safe_end: Option<f64>,
    /// Whether nothing may collide.
    pub collisions: bool,
    /// Whether no block may stop with an alarm.
    pub alarms: bool,
    /// Lines of the program, from 1, whose end points the learner predicts.
    pub predict: Vec<u32>,
}

impl Default for Checks {
    fn default() -> Self {
        Self {
            require: Vec::new(),
            forbid: Vec::new(),
            depth: None,
            feed: None,
            speed: None,
            cutting_speed: None,
            time: None,
            cuts_to: None,
            safe_end: None,
            collisions: true,
            alarms: true,
            predict: Vec::new(),
        }
    }
}

/// A single check.
#[derive(Clone, Debug, PartialEq)]
pub enum Check {
    /// No alarm.
    Alarms,
    /// No collision.
    Collisions,
    /// A code is used.
    Required(String),
    /// A code is not used.
    Forbidden(String),
    /// Depth of the deepest cut, mm.
    Depth(Range),
    /// Feed, mm/rev.
    Feed(Range),
    /// Spindle speed, rpm.
    Speed(Range),
    /// Cutting speed, m/min.
    CuttingSpeed(Range),
    /// Time, seconds.
    Time(Range),
    /// A cut goes to this place: X as a diameter, and Z, mm.
    CutsTo([f64; 2]),
    /// The tip ends this far from the blank, mm.
    SafeEnd(f64),
    /// The program consists of the given blocks.
    SameBlocks,
    /// The program differs from the given one only in its blanks.
    OnlyBlanks,
    /// The predicted end point of a line, from 1.
    Prediction(u32),
}

/// What was found.
#[derive(Clone, Debug, PartialEq)]
pub enum Finding {
    /// Nothing more to say.
    None,
    /// A message of the run.
    Message(Box<Diagnostic>),
    /// A value in the unit of the check.
    Value(f64),
    /// The value is not known.
    Unknown,
    /// No word with this address is in force: F or S.
    NoWord(char),
    /// The program does not cut.
    NoCut,
    /// The learner has not answered.
    NoAnswer,
    /// A place: X as a diameter, and Z, mm.
    Place([f64; 2]),
}

/// The result of a check.
#[derive(Clone, Debug, PartialEq)]
pub struct Checked {
    /// The check.
    pub check: Check,
    /// Whether it is passed.
    pub passed: bool,
    /// What was found.
    pub finding: Finding,
    /// The place in the program.
    pub span: Option<Span>,
}

impl Checked {
    fn new(check: Check, passed: bool, finding: Finding, span: Option<Span>) -> Self {
        Self { check, passed, finding, span }
    }
}

/// Checks an answer. `used` are its codes, `given` the text as it was handed in.
pub(super) fn checked(exercise: &Exercise, answer: &Answer, used: &[String], given: &[u8]) -> Vec<Checked> {
    let run = Checker { exercise, answer };
    let checks = &exercise.checks;
    let mut all = Vec::new();
    all.extend(checks.alarms.then(|| run.alarms()));
    all.extend(checks.collisions.then(|| run.collisions()));
    let is_used = |code: &String| used.contains(code);
    let required =
        |code: &String| Checked::new(Check::Required(code.clone()), is_used(code), Finding::None, None);
    all.extend(checks.require.iter().map(required));
    all.extend(checks.forbid.iter().map(|code| run.forbidden(code, is_used(code))));
    all.extend(checks.depth.map(|range| run.depth(range)));
    all.extend(checks.feed.map(|range| run.each(Check::Feed(range), range, |motion| run.feed(motion))));
    all.extend(checks.speed.map(|range| run.each(Check::Speed(range), range, |motion| run.speed(motion))));
    let surface = |range| run.each(Check::CuttingSpeed(range), range, |motion| run.cutting_speed(motion));
    all.extend(checks.cutting_speed.map(surface));
    all.extend(checks.time.map(|range| run.time(range)));
    all.extend(checks.cuts_to.map(|at| run.cuts_to(at)));
    all.extend(checks.safe_end.map(|distance| run.safe_end(distance)));
    match exercise.kind {
        Kind::Write | Kind::Fault => {}
        Kind::Order => all.push(run.same_blocks(given)),
        Kind::Blanks => all.push(run.only_blanks(given)),
        Kind::Predict => all.extend(run.predictions(given)),
    }
    all
}

struct Checker<'a> {
    exercise: &'a Exercise,
    answer: &'a Answer,
}

impl Checker<'_> {
    fn alarms(&self) -> Checked {
        self.with_message(Check::Alarms, self.answer.alarm.as_ref())
    }

    fn collisions(&self) -> Checked {
        let findings = self.answer.simulation.findings();
        let first = findings.iter().find(|finding| is_collision(&finding.danger));
        let span = first.map(|finding| self.answer.analysis.motions.span(finding.motion));
        let message = span.and_then(|span| {
            let mut found = self.answer.analysis.diagnostics.iter();
            found.find(|found| found.span == span && Some(*found) != self.answer.alarm.as_ref())
        });
        match (first, message) {
            (Some(_), None) => Checked::new(Check::Collisions, false, Finding::None, span),
            _ => self.with_message(Check::Collisions, message),
        }
    }

    /// A check that fails with a message.
    fn with_message(&self, check: Check, first: Option<&Diagnostic>) -> Checked {
        let finding = first.map_or(Finding::None, |found| Finding::Message(Box::new(found.clone())));
        Checked::new(check, first.is_none(), finding, first.map(|found| found.span))
    }

    fn forbidden(&self, code: &str, is_used: bool) -> Checked {
        let span = is_used.then(|| codes::place_of(code, &self.answer.text, &self.answer.analysis)).flatten();
        Checked::new(Check::Forbidden(code.to_owned()), !is_used, Finding::None, span)
    }

    fn depth(&self, range: Range) -> Checked {
        let found = deepest(self.answer);
        let passed = found.is_some_and(|found| range.contains(found.depth));
        let finding = found.map_or(Finding::NoCut, |found| Finding::Value(found.depth));
        let span = found.map(|found| self.answer.analysis.motions.span(found.motion));
        Checked::new(Check::Depth(range), passed, finding, span.filter(|_| !passed))
    }

    /// Checks a value of each cut; the finding is the first value outside the range, or the last one.
    fn each(&self, check: Check, range: Range, value: impl Fn(&Motion) -> Option<f64>) -> Checked {
        let motions = &self.answer.analysis.motions;
        let mut last = None;
        for index in (0..motions.len()).filter(|&index| is_cut(motions.kind(index))) {
            let motion = motions.get(index);
            let found = value(&motion);
            if !found.is_some_and(|found| range.contains(found)) {
                let missing = if self.speed(&motion).is_none() { 'S' } else { 'F' };
                let finding = found.map_or(Finding::NoWord(missing), Finding::Value);
                return Checked::new(check, false, finding, Some(motions.span(index)));
            }
            last = found;
        }
        Checked::new(check, last.is_some(), last.map_or(Finding::NoCut, Finding::Value), None)
    }

    /// Feed of a cut, mm/rev.
    fn feed(&self, motion: &Motion) -> Option<f64> {
        let machine = &self.answer.analysis.setup.machine;
        Some(feed_at(motion, machine, motion.to.x)? / self.speed(motion)?)
    }

    /// Spindle speed of a cut, rpm.
    fn speed(&self, motion: &Motion) -> Option<f64> {
        speed_at(&motion.process, &self.answer.analysis.setup.machine, motion.to.x)
    }

    /// Cutting speed of a cut, m/min; with G96 the programmed one.
    fn cutting_speed(&self, motion: &Motion) -> Option<f64> {
        match motion.process.speed {
            SpindleSpeed::Surface { speed } => Some(speed),
            SpindleSpeed::Constant(_) => {
                let widest = motion.from.x.abs().max(motion.to.x.abs());
                Some(surface_speed(self.speed(motion)?, widest))
            }
        }
    }

    fn time(&self, range: Range) -> Checked {
        let time = self.answer.time();
        let finding = time.map_or(Finding::Unknown, Finding::Value);
        Checked::new(Check::Time(range), time.is_some_and(|time| range.contains(time)), finding, None)
    }

    fn cuts_to(&self, [x, z]: [f64; 2]) -> Checked {
        let radius = Diameter::new(x).radius();
        let goes_there = |motion: &Motion| {
            is_pass(motion) && (motion.to.x - radius).abs().max((motion.to.z - z).abs()) <= SAME_PLACE
        };
        let passed = self.answer.analysis.motions.on_workpiece().any(|motion| goes_there(&motion));
        Checked::new(Check::CutsTo([x, z]), passed, Finding::None, None)
    }

    fn safe_end(&self, distance: f64) -> Checked {
        let motions = &self.answer.analysis.motions;
        let (Some(last), Some(bar)) = (motions.len().checked_sub(1), self.exercise.setup.extents()) else {
            return Checked::new(Check::SafeEnd(distance), false, Finding::Unknown, None);
        };
        let at = motions.get_on_workpiece(last).to;
        let passed = at.x.abs() >= bar.diameter.radius() + distance || at.z >= bar.face + distance;
        let place = Finding::Place([Diameter::from_radius(at.x).mm(), at.z]);
        Checked::new(Check::SafeEnd(distance), passed, place, Some(motions.span(last)).filter(|_| !passed))
    }

    fn same_blocks(&self, given: &[u8]) -> Checked {
        let sorted = |text: &[u8]| {
            let mut blocks = blocks_of(text);
            blocks.sort_unstable();
            blocks
        };
        let passed = sorted(given) == sorted(self.exercise.program.as_bytes());
        Checked::new(Check::SameBlocks, passed, Finding::None, None)
    }

    /// Whether each block is that of the program, with anything in place of `__`.
    fn only_blanks(&self, given: &[u8]) -> Checked {
        let (own, wanted) = (blocks_of(given), blocks_of(self.exercise.program.as_bytes()));
        let passed =
            own.len() == wanted.len() && own.iter().zip(&wanted).all(|(own, wanted)| fills(own, wanted));
        Checked::new(Check::OnlyBlanks, passed, Finding::None, None)
    }

    /// Compares each predicted point with the end of the motions of its line.
    fn predictions(&self, given: &[u8]) -> Vec<Checked> {
        let lines = &self.exercise.checks.predict;
        let compare = |(&line, own): (&u32, Option<[f64; 2]>)| {
            let end = self.end_of_line(line);
            let is_near = |own: [f64; 2], end: [f64; 2]| (own[0] - end[0]).abs().max((own[1] - end[1]).abs());
            let passed = own.zip(end).is_some_and(|(own, end)| is_near(own, end) <= SAME_PLACE);
            let finding = own.map_or(Finding::NoAnswer, Finding::Place);
            Checked::new(Check::Prediction(line), passed, finding, None)
        };
        lines.iter().zip(predicted(given, lines)).map(compare).collect()
    }

    /// The end of the last motion of a line, from 1: X as a diameter, and Z, mm.
    fn end_of_line(&self, line: u32) -> Option<[f64; 2]> {
        let motions = &self.answer.analysis.motions;
        let last = (0..motions.len()).rfind(|&index| motions.line(index) + 1 == line)?;
        let to = motions.get(last).to;
        Some([Diameter::from_radius(to.x).mm(), to.z])
    }
}

impl Answer {
    /// Time of the program, seconds; rapids without a rate of the machine count at the assumed one.
    pub(super) fn time(&self) -> Option<f64> {
        let machine = &self.analysis.setup.machine;
        let time = |motion: Motion| {
            let known = seconds(&motion, machine);
            known.or_else(|| (motion.kind == MotionKind::Rapid).then(|| assumed_seconds(&motion, machine)))
        };
        self.analysis.motions.iter().map(time).sum()
    }
}

/// The predicted points of lines, from 1. An answer is one point on each line, or the program with the points as X
/// and Z of these lines.
fn predicted(given: &[u8], lines: &[u32]) -> Vec<Option<[f64; 2]>> {
    let text = String::from_utf8_lossy(given);
    let mut points = text.lines().filter(|line| !line.trim().is_empty()).map(position).peekable();
    if points.peek().is_some_and(Option::is_some) {
        return lines.iter().map(|_| points.next().flatten()).collect();
    }
    let rows: Vec<&str> = text.lines().collect();
    lines.iter().map(|line| end_point(rows.get(*line as usize - 1)?)).collect()
}

/// X and Z of a block, mm; `None` if one is missing, or if the block has a distance, U or W.
fn end_point(block_text: &str) -> Option<[f64; 2]> {
    let mut block = Block::default();
    Parser::new(block_text.as_bytes()).next_block(&mut block);
    let value = |address: u8| block.words.iter().find(|word| word.address == address).and_then(plain);
    if value(b'U').or(value(b'W')).is_some() {
        return None;
    }
    Some([value(b'X')?, value(b'Z')?])
}

/// Whether a block fills the blanks, `__`, of another one; a blank is not empty.
fn fills(own: &[u8], wanted: &[u8]) -> bool {
    let (own, wanted) = (String::from_utf8_lossy(own), String::from_utf8_lossy(wanted));
    let mut pieces = wanted.split("__");
    let first = pieces.next().unwrap_or_default();
    let Some(mut rest) = own.strip_prefix(first) else { return false };
    let mut pieces = pieces.peekable();
    while let Some(piece) = pieces.next() {
        let is_last = pieces.peek().is_none();
        let at = match is_last {
            true => rest.len().checked_sub(piece.len()).filter(|_| rest.ends_with(piece)),
            false => rest.char_indices().skip(1).map(|(at, _)| at).find(|&at| rest[at..].starts_with(piece)),
        };
        let Some(at) = at.filter(|at| *at > 0) else { return false };
        rest = &rest[at + piece.len()..];
    }
    rest.is_empty()
}

/// Whether a motion is a cut, and not the infeed or the retract of a cycle.
fn is_pass(motion: &Motion) -> bool {
    let step = motion.cycle.map(|tag| tag.step);
    motion.kind.cuts() && matches!(step, None | Some(Step::Cut | Step::Contour))
}

/// Whether a motion cuts, other than a thread: feed and speed checks apply to it.
fn is_cut(kind: MotionKind) -> bool {
    kind.cuts() && kind != MotionKind::Thread
}

/// Whether a danger is a collision.
fn is_collision(danger: &Danger) -> bool {
    match danger {
        Danger::RapidThroughStock
        | Danger::DoglegThroughStock
        | Danger::LeavesBore
        | Danger::CycleStart
        | Danger::BehindFace { .. }
        | Danger::IntoJaws
        | Danger::IntoTailstock
        | Danger::HolderInStock => true,
        Danger::RapidAlongStock
        | Danger::SlopeTooSteep { .. }
        | Danger::BelowCenter
        | Danger::OverTravel { .. }
        | Danger::ToolNotListed { .. }
        | Danger::OtherWork { .. }
        | Danger::WrongSide { .. }
        | Danger::FastFeed { .. } => false,
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn blanks_are_filled_by_anything_but_nothing() {
        let fills = |own: &str, wanted: &str| super::fills(own.as_bytes(), wanted.as_bytes());
        assert!(fills("G90X26Z-30F0.1", "G90X__Z__F0.1"));
        assert!(fills("G90X26", "G90X26") && fills("G90X26", "__") && fills("G90X2", "G__X2"));
        for (own, wanted) in [
            ("G90X26Z-30", "G90X__Z__F0.1"),
            ("G90XZ-30F0.1", "G90X__Z__F0.1"),
            ("G91X26", "G90X__"),
            ("", "__"),
        ] {
            assert!(!fills(own, wanted), "{own} {wanted}");
        }
    }
}
