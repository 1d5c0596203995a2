//! Descriptions of strokes of the picture, and titles of fixes and rewrites, in every language.

use super::language::Language;
use super::phrases::Phrase;
use super::template::fill;
use crate::geometry::virtual_plane::Surface;
use crate::message::{Arguments, Repair, Value};
use crate::motion::{CycleStep, Motion, MotionKind, Step};
use crate::units::{Diameter, Unit};

impl Repair {
    /// The title of a button for the fix, in a language.
    pub fn words(&self, language: Language) -> String {
        let (phrase, text) = match self {
            Self::CloseComment => (Phrase::CloseComment, ""),
            Self::DecimalPoint => (Phrase::DecimalPoint, ""),
            Self::LetterO => (Phrase::LetterO, ""),
            Self::Minus => (Phrase::Minus, ""),
            Self::Write { text } => (Phrase::Write, text.as_str()),
            Self::Delete { text } => (Phrase::Delete, text.as_str()),
            Self::Insert { text } => (Phrase::Insert, text.as_str()),
        };
        fill(language.phrase(phrase), &vec![("text", Value::Text(text.into()))])
    }
}

/// The title of the rewrite that writes the moves of `passes` passes as a cycle.
pub fn describe_rewrite(code: &str, passes: usize, language: Language) -> String {
    let phrase = if passes == 1 { Phrase::AsCycle } else { Phrase::AsCyclePasses };
    let arguments: Arguments = vec![
        ("cycle", Value::Text(code.into())),
        ("passes", Value::Count(passes.try_into().unwrap_or(i64::MAX))),
    ];
    fill(language.phrase(phrase), &arguments)
}

/// Describes a stroke of the picture, its end in a unit; `passes` is the number of passes of its cycle.
pub fn describe_motion(motion: &Motion, passes: Option<u32>, unit: Unit, language: Language) -> String {
    let to = end_of(motion, unit);
    let mut arguments: Arguments = vec![("to", Value::Text(to.into()))];
    if let Some(seconds) = motion.seconds {
        arguments.push(("seconds", Value::Number(seconds)));
        return fill(language.phrase(Phrase::DwellFor), &arguments);
    }
    let Some(cycle) = motion.cycle else {
        return fill(language.phrase(kind(motion.kind)), &arguments);
    };
    let pass = describe_pass(cycle, passes, language);
    arguments.push(("cycle", Value::Text(cycle.cycle.code().into())));
    arguments.push(("pass", Value::Text(pass.into())));
    arguments.push(("step", Value::Text(language.phrase(step(cycle.step)).into())));
    arguments.push(("manner", Value::Text(language.phrase(manner(motion.kind)).into())));
    let whole = match cycle.step {
        Step::Cut | Step::PullOut => Phrase::CutOfCycle,
        _ => Phrase::OfCycle,
    };
    fill(language.phrase(whole), &arguments)
}

/// The number of the pass, and the number of passes; empty if the motion belongs to none.
fn describe_pass(cycle: CycleStep, passes: Option<u32>, language: Language) -> String {
    if cycle.pass == 0 {
        return String::new();
    }
    let template = language.phrase(if passes.is_some() { Phrase::PassOf } else { Phrase::Pass });
    let count = |count: u32| Value::Count(i64::from(count));
    fill(template, &vec![("pass", count(cycle.pass)), ("passes", count(passes.unwrap_or_default()))])
}

fn kind(kind: MotionKind) -> Phrase {
    match kind {
        MotionKind::Rapid => Phrase::Rapid,
        MotionKind::Feed => Phrase::Feed,
        MotionKind::ArcClockwise => Phrase::ArcClockwise,
        MotionKind::ArcCounterclockwise => Phrase::ArcCounterclockwise,
        MotionKind::Thread => Phrase::Thread,
        MotionKind::Dwell => Phrase::Dwell,
    }
}

fn manner(kind: MotionKind) -> Phrase {
    match kind {
        MotionKind::Rapid => Phrase::AtRapid,
        MotionKind::Thread => Phrase::WithSpindle,
        _ => Phrase::AtFeed,
    }
}

fn step(step: Step) -> Phrase {
    match step {
        Step::Infeed => Phrase::Infeed,
        Step::Cut => Phrase::Cut,
        Step::PullOut => Phrase::PullOut,
        Step::Retract => Phrase::Retract,
        Step::Return => Phrase::Return,
        Step::Approach => Phrase::Approach,
        Step::Escape => Phrase::Escape,
        Step::Contour => Phrase::Contour,
        Step::Relief => Phrase::Relief,
        Step::Stepover => Phrase::Stepover,
    }
}

/// The end of a motion, like the words of a block. For a program in a virtual plane, an arrow and the machine
/// position follow.
pub(super) fn end_of(motion: &Motion, unit: Unit) -> String {
    let place = |template: &str, numbers: &[(&'static str, f64)]| {
        fill(template, &numbers.iter().map(|&(name, value)| (name, Value::Number(value))).collect())
    };
    let length = |mm: f64| mm / unit.millimetres();
    let (x, z) = (("x", length(Diameter::from_radius(motion.to.x).mm())), ("z", length(motion.to.z)));
    let Some(rotary) = motion.rotary else { return place("X{x} Z{z}", &[x, z]) };
    let c = ("c", rotary.to);
    let flat = rotary.virtual_move.filter(|own| own.has_y());
    if let Some(own) = flat {
        let y = ("y", length(own.y_at(1.0)));
        let turns = rotary.from != rotary.to;
        return place(if turns { "X{x} Y{y} Z{z} C{c}°" } else { "X{x} Y{y} Z{z}" }, &[x, y, z, c]);
    }
    let own = rotary.virtual_move.filter(|own| own.surface == Surface::Face);
    let Some(end) = own.map(|own| own.way.at(1.0)) else { return place("X{x} Z{z} C{c}°", &[x, z, c]) };
    let (right, up) = (("right", length(2.0 * end.z)), ("up", length(end.x)));
    place("X{right} C{up} Z{z} → X{x} C{c}°", &[x, z, c, right, up])
}
