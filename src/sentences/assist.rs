//! Sentences for the help at a word: roles, facts and quantities of `assist`.
//!
//! In: an answer, a language, the unit of the user, the lines of the text. Out: short sentences.

use super::labels;
use super::language::Language;
use super::template::fill;
use crate::assist::complete::{ProposalKind, ValueSource};
use crate::assist::explain::{Action, Explanation};
use crate::assist::fact::{Fact, NoMotion, Quantity};
use crate::assist::place::Place;
use crate::assist::role::Role;
use crate::assist::signature::WhenOmitted;
use crate::assist::snippet::Snippet;
use crate::assist::state::{Frame, InForce};
use crate::control::codes::{self, G, Group};
use crate::control::contour::ContourUse;
use crate::control::origins::Modal;
use crate::control::program::CallKind;
use crate::message::{Arguments, Value};
use crate::motion::Cycle;
use crate::setup::dialect::FeedMode;
use crate::setup::{fields, tool_word};
use crate::units::{Diameter, Unit, number};

/// Lists the templates of facts once, for the enum and for tests of all templates.
macro_rules! told {
    ($($name:ident),* $(,)?) => {
        /// The template of a fact.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub(super) enum Told { $($name),* }

        #[cfg(test)]
        impl Told {
            /// Every template.
            pub(super) const ALL: &[Self] = &[$(Self::$name),*];
        }
    };
}

told! {
    // Modality of a code
    OneShot, GroupMotion, GroupSpeed, GroupDistance, GroupFeed, GroupUnit, GroupCompensation, GroupHole, GroupFrame, GroupPlane,
    GroupOther,
    // Earlier values
    UnchangedSince, UnchangedFromStart, BeforeSince, BeforeFromStart, ByCodeSince, ByCodeFromStart, ByFeedSince, ByFeedOfContour,
    ByFeedFromStart,
    // Meaning of a value
    FromTo, FromCentre, TaperFromTo, TaperOtherSign, WithoutPoint, FeedAtSpeed, SpeedAt, SpeedHeldSince, SpeedHeld, ThreadPackedOf, StationAndOffset, OffsetCancelled,
    NoseRadius, TipShift, TaperBefore, TaperKept, Passes, LastPass,
    // Other blocks
    ContourLines, NamesLine, NamesNothing,
    // Variables
    VariableIs, VariableVacant, VariableSet, VariableBecomes, VariableBecomesVacant, ArgumentIs,
    // Execution of the block
    ThreadLocked, NoMotionWithoutAxis, NoMotionSamePlace, NoMotionByCode, NotCarriedOut, Skipped, IgnoredByRoughing, TakenByFinishing, TimeOf,
    // The state
    Vacant, CallFrame, MacroFrame, LoopFrame, ReadByRoughing, ReadByFinishing, ReadByBoth,
    // Explanation of a block
    ExplainRapid, ExplainStraight, ExplainTaper, ExplainClockwise, ExplainCounterclockwise, ExplainThread, ExplainDwell, ExplainTurn, ExplainAlongY,
    ExplainMoves, ExplainPass, ExplainTaperPass, ExplainPasses, ExplainPassesZ, ExplainPassTo, ExplainPassesTo, ExplainPattern, ExplainContour,
    ExplainPecks, ExplainPecksInColumns, ExplainHole, ExplainHoleInPecks,
    // Feed and time, and settings
    ExplainFeedTime, ExplainFeedTimeWithoutRapids, ExplainTime, ExplainTimeWithoutRapids, ExplainFeed, ExplainSets,
    // Signature of a cycle
    SlotMissing, SlotStays, SlotZero, SlotAsSet, SlotAsSetTo, SlotMay,
    // Completion
    CompleteLine, CompleteNext, SnippetHead, SnippetEnd, SnippetSubprogram, SnippetCall, SnippetLoop, SnippetCondition,
    SnippetSecond, SnippetContour, WhyFace, WhyBack, WhyOutside, WhyBore, WhyAxis, WhyHere, WhyUsed, WhyInSetup,
}

impl Role {
    /// A noun phrase for the role, in a language.
    pub fn words(self, language: Language) -> &'static str {
        language.text(self)
    }
}

impl Modal {
    /// Its name in a language.
    pub fn name(self, language: Language) -> &'static str {
        language.text(self)
    }
}

/// Settings for making sentences.
#[derive(Clone, Copy)]
pub struct Speaker<'a> {
    /// The language.
    pub language: Language,
    /// The unit of lengths.
    pub unit: Unit,
    /// Maps a byte of the text to its line, from 1.
    pub line_of: &'a dyn Fn(u32) -> u32,
}

impl Speaker<'_> {
    /// Formats a number with its unit.
    pub fn quantity(&self, quantity: Quantity) -> String {
        let (language, unit) = (self.language, self.unit);
        let length = |mm: f64| number(mm / unit.millimetres());
        let with = |value: String, unit: &str| format!("{value} {unit}");
        match quantity {
            Quantity::Length(mm) => with(length(mm), labels::length(unit, language)),
            Quantity::Diameter(diameter) => {
                format!("Ø{}", with(length(diameter.mm()), labels::length(unit, language)))
            }
            Quantity::FeedPerMinute(feed) => with(
                rounded(feed / unit.millimetres()),
                labels::feed_unit(FeedMode::PerMinute, unit, language),
            ),
            Quantity::FeedPerTurn(feed) => {
                with(number(feed / unit.millimetres()), labels::feed_unit(FeedMode::PerTurn, unit, language))
            }
            Quantity::ThreadsPerInch(threads) => number(threads),
            Quantity::Speed(speed) => {
                with(rounded(speed), labels::unit(fields::Unit::TurnsPerMinute, language))
            }
            Quantity::CuttingSpeed(speed) => {
                with(rounded(speed / unit.surface_metres()), labels::surface_speed(unit, language))
            }
            Quantity::Degrees(degrees) => format!("{}°", number(degrees)),
            Quantity::Seconds(seconds) => with(number(seconds), labels::seconds(language)),
            Quantity::Count(count) => number(count),
            Quantity::Sequence(sequence) => format!("N{sequence}"),
            Quantity::Program(program) => format!("O{program:04}"),
            Quantity::Variable(variable) => format!("#{variable}"),
        }
    }

    /// A fact as a sentence.
    pub fn fact(&self, fact: &Fact) -> String {
        let what = |quantity: Quantity| ("what", Value::Text(self.quantity(quantity).into()));
        let line = |byte: u32| ("line", Value::count((self.line_of)(byte) as usize));
        let count = |count: u32| Value::Count(i64::from(count));
        // A diameter, a position along Z, or an angle.
        let level = |quantity: Quantity| match quantity {
            Quantity::Length(z) => Value::Text(self.place(Place { x: None, z: Some(z), c: None }).into()),
            other => Value::Text(self.quantity(other).into()),
        };
        let (told, arguments): (Told, Arguments) = match *fact {
            Fact::Group(group) => (group_told(group), Vec::new()),
            Fact::Unchanged(Some(since)) => (Told::UnchangedSince, vec![line(since)]),
            Fact::Unchanged(None) => (Told::UnchangedFromStart, Vec::new()),
            Fact::CodeBefore(ref code, since) => {
                self.since(Told::BeforeSince, Told::BeforeFromStart, code, since)
            }
            Fact::ValueBefore(value, since) => {
                self.since(Told::BeforeSince, Told::BeforeFromStart, &self.quantity(value), since)
            }
            Fact::ByCode(ref code, since) => {
                self.since(Told::ByCodeSince, Told::ByCodeFromStart, code, since)
            }
            Fact::ByFeed(feed, since) => {
                self.since(Told::ByFeedSince, Told::ByFeedFromStart, &self.quantity(feed), since)
            }
            Fact::ByFeedOfContour(first) => (Told::ByFeedOfContour, vec![line(first)]),
            Fact::FromTo(from, to) => {
                let place = |quantity| Value::Text(self.quantity(quantity).into());
                (Told::FromTo, vec![("from", place(from)), ("to", place(to))])
            }
            Fact::FromCentre(distance) => (Told::FromCentre, vec![what(distance)]),
            Fact::TaperFromTo(from, to, angle) => {
                (Told::TaperFromTo, vec![("from", level(from)), ("to", level(to)), ("angle", level(angle))])
            }
            Fact::TaperOtherSign(from) => (Told::TaperOtherSign, vec![("what", level(from))]),
            Fact::WithoutPoint(increment) => (Told::WithoutPoint, vec![what(increment)]),
            Fact::FeedAtSpeed(feed, speed) => {
                let named = |quantity| Value::Text(self.quantity(quantity).into());
                (Told::FeedAtSpeed, vec![("feed", named(feed)), ("speed", named(speed))])
            }
            Fact::SpeedAt(speed, at) => {
                let named = |quantity| Value::Text(self.quantity(quantity).into());
                (Told::SpeedAt, vec![("speed", named(speed)), ("at", named(at))])
            }
            Fact::SpeedHeld(limit, since) => {
                self.since(Told::SpeedHeldSince, Told::SpeedHeld, &self.quantity(limit), since)
            }
            Fact::ThreadPacked(passes, pull, angle) => {
                let pull = Value::Number(f64::from(pull) / 10.0);
                (
                    Told::ThreadPackedOf,
                    vec![("passes", count(passes)), ("pull", pull), ("angle", count(angle))],
                )
            }
            Fact::StationAndOffset(station, offset) => {
                let told = if offset == 0 { Told::OffsetCancelled } else { Told::StationAndOffset };
                (told, vec![("station", count(station.into())), ("offset", count(offset.into()))])
            }
            Fact::NoseRadius(radius) => (Told::NoseRadius, vec![what(radius)]),
            Fact::TipShift(x, z) => {
                let by = |quantity| Value::Text(self.quantity(quantity).into());
                (Told::TipShift, vec![("x", by(x)), ("z", by(z))])
            }
            Fact::TaperBefore(taper) => (Told::TaperBefore, vec![what(taper)]),
            Fact::TaperKept(taper) => (Told::TaperKept, vec![what(taper)]),
            Fact::Passes(passes) => (Told::Passes, vec![("count", count(passes))]),
            Fact::LastPass(at) => (Told::LastPass, vec![what(at)]),
            Fact::Contour(first, last) => {
                let of = |byte: u32| Value::count((self.line_of)(byte) as usize);
                (Told::ContourLines, vec![("first", of(first.start)), ("last", of(last.start))])
            }
            Fact::Names(block) => (Told::NamesLine, vec![line(block)]),
            Fact::NamesNothing => (Told::NamesNothing, Vec::new()),
            Fact::Variable(variable, value) => {
                variable_told(Told::VariableIs, Told::VariableVacant, variable, value)
            }
            Fact::VariableSet(_, by) => (Told::VariableSet, vec![line(by)]),
            Fact::VariableBecomes(variable, value) => {
                variable_told(Told::VariableBecomes, Told::VariableBecomesVacant, variable, value)
            }
            Fact::Argument(variable) => (Told::ArgumentIs, vec![("number", count(variable))]),
            Fact::NoMotion(why) => {
                let told = match why {
                    NoMotion::WithoutAxis => Told::NoMotionWithoutAxis,
                    NoMotion::SamePlace => Told::NoMotionSamePlace,
                    NoMotion::ByCode => Told::NoMotionByCode,
                };
                (told, Vec::new())
            }
            Fact::NotCarriedOut => (Told::NotCarriedOut, Vec::new()),
            Fact::Skipped(level) => {
                let mark = if level == 1 { "/".to_owned() } else { format!("/{level}") };
                (Told::Skipped, vec![("what", Value::Text(mark.into()))])
            }
            Fact::ReadBy(ContourUse::Roughing) => (Told::ReadByRoughing, Vec::new()),
            Fact::ReadBy(ContourUse::Finishing) => (Told::ReadByFinishing, Vec::new()),
            Fact::ReadByBoth => (Told::ReadByBoth, Vec::new()),
            Fact::ThreadLocked => (Told::ThreadLocked, Vec::new()),
            Fact::IgnoredByRoughing => (Told::IgnoredByRoughing, Vec::new()),
            Fact::TakenByFinishing => (Told::TakenByFinishing, Vec::new()),
            Fact::Time(number, times) => {
                (Told::TimeOf, vec![("number", count(number)), ("times", count(times))])
            }
        };
        self.filled(told, &arguments)
    }

    /// Formats a value in force.
    pub fn in_force(&self, value: &InForce) -> String {
        match value {
            InForce::Code(code, function, role) => {
                let words = role.map(|role| role.words(self.language));
                match words.or(function.map(|function| function.describe(self.language))) {
                    // The table contains only the name, without the explanation.
                    Some(words) => format!("{code} – {}", words.split([':', '：']).next().unwrap_or(words)),
                    None => code.clone(),
                }
            }
            InForce::Quantity(quantity) => self.quantity(*quantity),
            InForce::Pair(x, z) => format!("X {}, Z {}", self.quantity(*x), self.quantity(*z)),
            InForce::Tool(station, offset) => tool_word((*station, *offset)),
            InForce::Role(role) => role.words(self.language).to_owned(),
            InForce::Nothing => "–".to_owned(),
        }
    }

    /// The value of a variable.
    pub fn variable(&self, value: Option<f64>) -> String {
        value.map_or_else(|| self.language.text(Told::Vacant).to_owned(), number)
    }

    /// Describes a call or loop in progress.
    pub fn frame(&self, frame: &Frame) -> String {
        let line = |byte: u32| Value::count((self.line_of)(byte) as usize);
        let count = |count: u32| Value::Count(i64::from(count));
        let (told, arguments) = match *frame {
            Frame::Call { kind, head, caller, rounds_left } => {
                let told = match kind {
                    CallKind::Subprogram => Told::CallFrame,
                    CallKind::Macro => Told::MacroFrame,
                };
                (told, vec![("line", line(head)), ("caller", line(caller)), ("left", count(rounds_left))])
            }
            Frame::Loop { number, head } => {
                (Told::LoopFrame, vec![("number", count(number)), ("line", line(head))])
            }
        };
        self.filled(told, &arguments)
    }

    /// The default of an omitted word.
    pub fn otherwise(&self, otherwise: WhenOmitted, in_force: Option<Quantity>) -> String {
        let told = match (otherwise, in_force) {
            (WhenOmitted::Missing, _) => Told::SlotMissing,
            (WhenOmitted::Stays, _) => Told::SlotStays,
            (WhenOmitted::Zero, _) => Told::SlotZero,
            (WhenOmitted::AsSet, None) => Told::SlotAsSet,
            (WhenOmitted::AsSet, Some(_)) => Told::SlotAsSetTo,
            (WhenOmitted::Nothing, _) => Told::SlotMay,
        };
        let what = in_force.map(|quantity| ("what", Value::Text(self.quantity(quantity).into())));
        self.filled(told, &what.into_iter().collect())
    }

    /// Describes a proposal, and the source of its value.
    pub fn proposed(&self, kind: &ProposalKind) -> String {
        let function =
            |code: G| codes::g_code_of(code).map_or("", |found| found.function().describe(self.language));
        let named =
            |told: Told, code: G| self.filled(told, &vec![("what", Value::Text(function(code).into()))]);
        let alone = |told: Told| self.filled(told, &Vec::new());
        match *kind {
            ProposalKind::Code(function, role) => {
                role.map_or(function.describe(self.language), |role| role.words(self.language)).to_owned()
            }
            ProposalKind::Word(role, None) => role.words(self.language).to_owned(),
            ProposalKind::Word(role, Some(why)) => {
                self.named(role.words(self.language), &alone(why_told(why)))
            }
            ProposalKind::Sequence(at) | ProposalKind::Program(at) => {
                let line = Value::count((self.line_of)(at) as usize);
                self.filled(Told::CompleteLine, &vec![("line", line)])
            }
            ProposalKind::NextSequence => alone(Told::CompleteNext),
            ProposalKind::Variable(value) => format!("= {}", number(value)),
            ProposalKind::Snippet(snippet) => match snippet {
                Snippet::Head => alone(Told::SnippetHead),
                Snippet::End => alone(Told::SnippetEnd),
                Snippet::Subprogram => alone(Told::SnippetSubprogram),
                Snippet::Call => alone(Told::SnippetCall),
                Snippet::Loop => alone(Told::SnippetLoop),
                Snippet::Condition => alone(Told::SnippetCondition),
                Snippet::Second(cycle) => named(Told::SnippetSecond, G::Multiple(cycle)),
                Snippet::Cycle(cycle) if cycle.is_roughing() => {
                    named(Told::SnippetContour, G::Multiple(cycle))
                }
                Snippet::Cycle(_) | Snippet::Pass(_) | Snippet::Drilling | Snippet::MacroCall => {
                    snippet.code().map_or("", function).to_owned()
                }
            },
        }
    }

    /// Explains a block; empty if the block moves nothing.
    pub fn explanation(&self, explanation: &Explanation) -> String {
        let mut sentences: Vec<String> =
            explanation.actions.iter().map(|action| self.action(action)).collect();
        let named = |quantity: Quantity| Value::Text(self.quantity(quantity).into());
        let feed = explanation.feed.map(|feed| ("feed", named(feed)));
        let time = explanation.time.map(|time| ("time", named(time)));
        let told = match (&feed, &time, explanation.without_rapids) {
            (None, None, _) => None,
            (Some(_), None, _) => Some(Told::ExplainFeed),
            (None, Some(_), false) => Some(Told::ExplainTime),
            (None, Some(_), true) => Some(Told::ExplainTimeWithoutRapids),
            (Some(_), Some(_), false) => Some(Told::ExplainFeedTime),
            (Some(_), Some(_), true) => Some(Told::ExplainFeedTimeWithoutRapids),
        };
        let arguments: Arguments = feed.into_iter().chain(time).collect();
        sentences.extend(told.map(|told| self.filled(told, &arguments)));
        sentences.join(self.language.among([" ", "", " "]))
    }

    /// A sentence that lists the values that a block sets.
    pub fn sets(&self, list: &[String]) -> String {
        let list = list.join(self.language.among(["; ", "；", "; "]));
        self.filled(Told::ExplainSets, &vec![("what", Value::Text(list.into()))])
    }

    /// A name with a value.
    pub fn named(&self, name: &str, value: &str) -> String {
        format!("{name}{}{value}", self.language.among([": ", "：", ": "]))
    }

    fn action(&self, action: &Action) -> String {
        let named =
            |name: &'static str, quantity: Quantity| (name, Value::Text(self.quantity(quantity).into()));
        let place = |name: &'static str, at: Place| (name, Value::Text(self.place(at).into()));
        let count = |name: &'static str, count: u32| (name, Value::Count(i64::from(count)));
        // A diameter, or a position along Z.
        let level = |at: Quantity| match at {
            Quantity::Length(z) => place("at", Place { x: None, z: Some(z), c: None }),
            at => named("at", at),
        };
        let code = |cycle: Cycle| ("cycle", Value::Text(cycle.code().into()));
        let (told, arguments): (Told, Arguments) = match *action {
            Action::Rapid(from, to) => (Told::ExplainRapid, vec![place("from", from), place("to", to)]),
            Action::Straight(from, to, length) => {
                (Told::ExplainStraight, vec![place("from", from), place("to", to), named("length", length)])
            }
            Action::Taper(from, to, angle) => {
                (Told::ExplainTaper, vec![place("from", from), place("to", to), named("angle", angle)])
            }
            Action::Arc(to, radius, clockwise) => {
                let told = if clockwise { Told::ExplainClockwise } else { Told::ExplainCounterclockwise };
                (told, vec![place("to", to), named("radius", radius)])
            }
            Action::Thread(from, to, lead) => {
                (Told::ExplainThread, vec![place("from", from), place("to", to), named("lead", lead)])
            }
            Action::Dwell(time) => (Told::ExplainDwell, vec![named("time", time)]),
            Action::Turn(to) => (Told::ExplainTurn, vec![named("to", to)]),
            Action::AlongY(from, to) => (Told::ExplainAlongY, vec![named("from", from), named("to", to)]),
            Action::Moves(moves, from, to) => {
                (Told::ExplainMoves, vec![count("count", moves), place("from", from), place("to", to)])
            }
            Action::Pass(cycle, Some(at), from, to) => {
                (Told::ExplainPass, vec![code(cycle), level(at), place("from", from), place("to", to)])
            }
            Action::Pass(cycle, None, from, to) => {
                (Told::ExplainTaperPass, vec![code(cycle), place("from", from), place("to", to)])
            }
            Action::Passes { cycle, passes, each, depth, last } => {
                let told = if matches!(last, Quantity::Diameter(_)) {
                    Told::ExplainPasses
                } else {
                    Told::ExplainPassesZ
                };
                let depths = [named("each", each), named("depth", depth), level(last)];
                (told, [code(cycle), count("passes", passes)].into_iter().chain(depths).collect())
            }
            Action::PassesTo(cycle, passes, at) => {
                let told = if passes == 1 { Told::ExplainPassTo } else { Told::ExplainPassesTo };
                (told, vec![code(cycle), count("passes", passes), level(at)])
            }
            Action::Pattern(cycle, passes) => {
                (Told::ExplainPattern, vec![code(cycle), count("passes", passes)])
            }
            Action::Contour(length) => (Told::ExplainContour, vec![named("length", length)]),
            Action::Pecks(cycle, pecks, columns, at) => {
                let told = if columns == 1 { Told::ExplainPecks } else { Told::ExplainPecksInColumns };
                (told, vec![code(cycle), count("pecks", pecks), count("columns", columns), level(at)])
            }
            Action::Hole(cycle, from, to, pecks) => {
                let told = if pecks == 1 { Told::ExplainHole } else { Told::ExplainHoleInPecks };
                (told, vec![code(cycle), named("from", from), named("to", to), count("pecks", pecks)])
            }
        };
        self.filled(told, &arguments)
    }

    fn filled(&self, told: Told, arguments: &Arguments) -> String {
        fill(self.language.text(told), arguments)
    }

    /// Formats a position like the words of a block.
    fn place(&self, at: Place) -> String {
        let length = |mm: f64| number(mm / self.unit.millimetres());
        let x = at.x.map(|x| format!("X{}", length(Diameter::from_radius(x).mm())));
        let z = at.z.map(|z| format!("Z{}", length(z)));
        let c = at.c.map(|c| match c {
            Quantity::Length(mm) => format!("C{}", length(mm)),
            Quantity::Degrees(c) => format!("C{}", number(c)),
            other => self.quantity(other),
        });
        [x, z, c].into_iter().flatten().collect::<Vec<_>>().join(" ")
    }

    /// Describes the cycle that reads a block as a part of its contour.
    pub fn purpose(&self, purpose: ContourUse) -> &'static str {
        self.language.text(match purpose {
            ContourUse::Roughing => Told::ReadByRoughing,
            ContourUse::Finishing => Told::ReadByFinishing,
        })
    }

    /// Chooses a template: with the line of a block, or without.
    fn since(&self, with: Told, without: Told, what: &str, since: Option<u32>) -> (Told, Arguments<'static>) {
        let mut arguments = vec![("what", Value::Text(what.to_owned().into()))];
        match since {
            Some(since) => {
                arguments.push(("line", Value::count((self.line_of)(since) as usize)));
                (with, arguments)
            }
            None => (without, arguments),
        }
    }
}

/// The first byte of the block that a fact refers to.
pub fn block_of(fact: &Fact) -> Option<u32> {
    match *fact {
        Fact::Unchanged(since)
        | Fact::CodeBefore(_, since)
        | Fact::ValueBefore(_, since)
        | Fact::ByCode(_, since)
        | Fact::ByFeed(_, since)
        | Fact::SpeedHeld(_, since) => since,
        Fact::Contour(first, _) => Some(first.start),
        Fact::Names(block) | Fact::VariableSet(_, block) | Fact::ByFeedOfContour(block) => Some(block),
        _ => None,
    }
}

fn why_told(why: ValueSource) -> Told {
    match why {
        ValueSource::Face => Told::WhyFace,
        ValueSource::Back => Told::WhyBack,
        ValueSource::Outside => Told::WhyOutside,
        ValueSource::Bore => Told::WhyBore,
        ValueSource::Axis => Told::WhyAxis,
        ValueSource::ToolPosition => Told::WhyHere,
        ValueSource::Used => Told::WhyUsed,
        ValueSource::InSetup => Told::WhyInSetup,
    }
}

fn group_told(group: Group) -> Told {
    match group {
        0 => Told::OneShot,
        1 => Told::GroupMotion,
        2 => Told::GroupSpeed,
        3 => Told::GroupDistance,
        5 => Told::GroupFeed,
        6 => Told::GroupUnit,
        7 => Told::GroupCompensation,
        10 => Told::GroupHole,
        14 => Told::GroupFrame,
        16 => Told::GroupPlane,
        _ => Told::GroupOther,
    }
}

fn variable_told(is: Told, vacant: Told, variable: u32, value: Option<f64>) -> (Told, Arguments<'static>) {
    let name = ("number", Value::Count(i64::from(variable)));
    match value {
        Some(value) => (is, vec![name, ("what", Value::Text(number(value).into()))]),
        None => (vacant, vec![name]),
    }
}

/// Formats a rate: with one decimal, large ones without.
fn rounded(value: f64) -> String {
    let places = if value.abs() < 100.0 { 10.0 } else { 1.0 };
    number((value * places).round() / places)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The names in braces in a template.
    fn names(template: &str) -> Vec<&str> {
        let parts = template.split('{').skip(1);
        let mut names: Vec<_> = parts.filter_map(|part| part.split_once('}').map(|(name, _)| name)).collect();
        names.sort_unstable();
        names
    }

    #[test]
    fn each_template_has_the_same_arguments_in_all_languages() {
        for &told in Told::ALL {
            let [english, chinese, russian] = Language::ALL.map(|language| language.text(told));
            assert_eq!(names(english), names(chinese), "{told:?}");
            assert_eq!(names(english), names(russian), "{told:?}");
        }
    }

    #[test]
    fn each_role_and_name_is_another_text() {
        for language in Language::ALL {
            let mut seen = std::collections::BTreeMap::new();
            for &role in Role::ALL {
                if let Some(other) = seen.insert(role.words(language), role) {
                    panic!("{role:?} and {other:?} are both `{}`", role.words(language));
                }
            }
            for &modal in Modal::ALL {
                assert!(!modal.name(language).is_empty());
            }
        }
    }
}
