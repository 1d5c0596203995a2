//! The words and numbers a sentence quotes, and how they get into it.
//!
//! In: a message; a template such as `{word} has no number.`. Out: the message's arguments by name; the sentence.
//! The sentences are data: nothing here knows a language.

use super::{Language, labels};
use crate::diagnostics::message::Message;
use crate::setup::faults::Need;
use crate::units::Unit;
use crate::units::number;

/// A word or number that a sentence quotes.
#[derive(Clone, Copy, Debug)]
pub(super) enum Value<'a> {
    /// Words, as they are.
    Text(&'a str),
    /// An address or an axis.
    Letter(char),
    /// A whole number.
    Count(i64),
    /// A measure, as people write it.
    Number(f64),
    /// A length, mm; or a feed, mm a minute or a turn. It is shown in the unit of the program.
    Length(f64),
    /// The number of a program, in four digits at least.
    Program(u32),
}

impl Value<'_> {
    fn write(self, out: &mut String) {
        match self {
            Self::Text(text) => out.push_str(text),
            Self::Letter(letter) => out.push(letter),
            Self::Count(count) => out.push_str(&count.to_string()),
            // Whoever shows a length has made it a number of the program's unit.
            Self::Number(value) | Self::Length(value) => out.push_str(&number(value)),
            Self::Program(program) => {
                let digits = program.to_string();
                out.extend(std::iter::repeat_n('0', 4usize.saturating_sub(digits.len())));
                out.push_str(&digits);
            }
        }
    }
}

/// Arguments of a sentence by the names that stand in its templates.
pub(super) type Arguments<'a> = Vec<(&'static str, Value<'a>)>;

/// A template with its arguments in place of the `{names}`. A name that is none stays as it is; the tests find it.
pub(super) fn fill(template: &str, arguments: &Arguments) -> String {
    let mut out = String::with_capacity(template.len() + 16);
    let mut rest = template.split('{');
    out.push_str(rest.next().unwrap_or_default());
    for part in rest {
        let value =
            |name: &str| arguments.iter().find(|argument| argument.0 == name).map(|argument| argument.1);
        match part.split_once('}').and_then(|(name, behind)| Some((value(name)?, behind))) {
            Some((value, behind)) => {
                value.write(&mut out);
                out.push_str(behind);
            }
            None => {
                out.push('{');
                out.push_str(part);
            }
        }
    }
    out
}

impl Message {
    /// What its sentences quote in a language, lengths in a unit, whose name is `mm`.
    pub(super) fn arguments_in(&self, language: Language, unit: Unit) -> Arguments<'_> {
        let mut arguments = self.arguments();
        for (_, value) in &mut arguments {
            if let Value::Length(length) = value {
                *value = Value::Number(*length / unit.millimetres());
            }
        }
        arguments.push(("mm", Value::Text(labels::length(unit, language))));
        arguments
    }

    /// What its sentences quote.
    pub(super) fn arguments(&self) -> Arguments<'_> {
        use Value::{Count, Length, Letter, Number, Program, Text};
        match self {
            Self::NumberMissing { address } => vec![("address", Letter(*address))],
            Self::AddressMissing { number } | Self::ZeroForO { number } => vec![("number", Text(number))],
            Self::NotUnderstood { text } | Self::PlainText { text } | Self::TextAfterSemicolon { text } => {
                vec![("text", Text(text))]
            }
            Self::SecondPoint { word }
            | Self::TooManyDigits { word }
            | Self::CommaForPoint { word, .. }
            | Self::ProgramNotFound { word }
            | Self::NumberFromVariable { word }
            | Self::ReferenceNumber { word }
            | Self::OffsetNumber { word }
            | Self::TipNumber { word }
            | Self::PeckZero { word }
            | Self::UnknownG { word }
            | Self::UnknownM { word }
            | Self::MakerG { word }
            | Self::PointNotAllowed { word }
            | Self::MinusNotAllowed { word }
            | Self::ToolWithSetting { word, .. }
            | Self::ToolNumber { word, .. }
            | Self::DwellWithPoint { word }
            | Self::AxisNotHere { word }
            | Self::PolarForbidden { word }
            | Self::PolarFrame { word }
            | Self::PolarAngle { word }
            | Self::CylinderForbidden { word }
            | Self::ContourNotFound { word }
            | Self::ContourIllegal { word }
            | Self::ContourCall { word }
            | Self::ContourOpenEnd { word, .. }
            | Self::AllowanceSign { word }
            | Self::PeckNegative { word }
            | Self::ReliefNegative { word }
            | Self::AmountInMillimetres { word }
            | Self::CornerNoMove { word }
            | Self::CornerTooLarge { word }
            | Self::CornerNone { word }
            | Self::CornerStraight { word }
            | Self::CornerNoLine { word }
            | Self::CornerAxis { word, .. }
            | Self::CornerInThread { word }
            | Self::CornerWithCompensation { word }
            | Self::AngleNoPoint { word, .. } => vec![("word", Text(word))],
            Self::FullWidth { word, plain } => vec![("word", Text(word)), ("plain", Text(plain))],
            Self::BlankInNumber { written, joined } => {
                vec![("written", Text(written)), ("joined", Text(joined))]
            }
            Self::LetterForDigit { word, digit, .. } => vec![("word", Text(word)), ("digit", Text(digit))],
            Self::PrintedMinus
            | Self::CommentOpen
            | Self::CommentNested
            | Self::EmptyProgram
            | Self::ProgramNumberZero
            | Self::NoEnd
            | Self::NoReturn
            | Self::EndlessMain
            | Self::Macro { .. }
            | Self::NoIntermediate
            | Self::DataPassedOver
            | Self::G90AsAbsolute
            | Self::LetterIInG92
            | Self::DwellNoTime
            | Self::CAxisNotConnected
            | Self::LiveToolStopped
            | Self::PolarFeedPerTurn
            | Self::CylinderFormat
            | Self::FeedMissing
            | Self::SpindleStopped
            | Self::NoSpeedClamp
            | Self::ArcNowhere
            | Self::ThreadNoDepth { .. }
            | Self::CompensationPlane => vec![],
            Self::BlockTooLong { most }
            | Self::TooManyMotions { most }
            | Self::TooMuchWork { most }
            | Self::CallTooDeep { most, .. }
            | Self::TooManyRepeats { most }
            | Self::TooManyRounds { most }
            | Self::TooManyMacroSteps { most }
            | Self::PartTooManyMotions { most }
            | Self::PartTooManyCorners { most }
            | Self::TooMuchRepeated { most } => vec![("most", Count(*most as i64))],
            Self::TextTooLong { bytes, most } => {
                vec![("bytes", Count(*bytes as i64)), ("most", Count(*most as i64))]
            }
            Self::DuplicateProgram { number } => vec![("number", Count(i64::from(*number)))],
            Self::NotRun { number } => vec![("number", Program(*number))],
            Self::MoreMessages { hidden } => vec![("hidden", Count(*hidden as i64))],
            Self::Stopped { seconds } => vec![("seconds", Number(*seconds))],
            Self::CallNoNumber { code }
            | Self::G28NoAxis { code }
            | Self::HoleNoDepth { code }
            | Self::HoleOfOthers { code }
            | Self::PlaneCompensation { code }
            | Self::LeadMissing { code }
            | Self::ThreadAtSurfaceSpeed { code }
            | Self::ArcNoCenter { code }
            | Self::ContourNotNamed { code }
            | Self::ContourFirstBlock { code }
            | Self::ContourTypeTwo { code }
            | Self::ContourNothingToCut { code }
            | Self::CyclePlane { code, .. }
            | Self::CompensationOnArc { code }
            | Self::CompensationTurnsBack { code }
            | Self::CompensationIdle { code } => vec![("code", Text(code))],
            Self::SequenceNotFound { sequence } => vec![("sequence", Count(i64::from(*sequence)))],
            Self::MacroAlarm { number, words } => vec![("number", Count(*number)), ("words", Text(words))],
            Self::SystemVariable { variable } | Self::ArgumentsUnknown { variable } => {
                vec![("variable", Count(i64::from(*variable)))]
            }
            Self::Foreign { origin } => vec![("origin", Text(origin.name()))],
            Self::DecimalRule { word, value, .. } => vec![("word", Text(word)), ("value", Number(*value))],
            Self::SystemGuessed { system } => vec![("system", Text(system.name()))],
            Self::NotAtReference { x, z } | Self::MachineZero { x, z } => {
                vec![("x", Length(*x)), ("z", Length(*z))]
            }
            Self::HoleInForce { word, hole, .. } => vec![("word", Text(word)), ("hole", Text(hole))],
            Self::NotSupported { what } => vec![("what", Text(what))],
            Self::DuplicateWord { address, used } => {
                vec![("address", Letter(*address)), ("used", Text(used))]
            }
            Self::SameGroup { dropped, used } => vec![("dropped", Text(dropped)), ("used", Text(used))],
            Self::AbsoluteAndIncremental { absolute, incremental, used } => {
                vec![("absolute", Text(absolute)), ("incremental", Text(incremental)), ("used", Text(used))]
            }
            Self::ShortTool { word, offset } => {
                vec![("word", Text(word)), ("offset", Count(i64::from(*offset)))]
            }
            Self::PlaneNotHere { word } => vec![("word", Text(word))],
            Self::PolarNotAlone { code, other } => vec![("code", Text(code)), ("other", Text(other))],
            Self::PolarCenter { distance } => vec![("distance", Length(*distance))],
            Self::PlaneLeftOn { code, off } => vec![("code", Text(code)), ("off", Text(off))],
            Self::FeedUnit { word, feed, .. } => vec![("word", Text(word)), ("feed", Length(*feed))],
            Self::FeedNotRepeated { feed, .. } => vec![("feed", Length(*feed))],
            Self::ClampReversed { lowest, highest } => {
                vec![("lowest", Number(*lowest)), ("highest", Number(*highest))]
            }
            Self::ArcRadiusTooSmall { word, distance } => {
                vec![("word", Text(word)), ("distance", Length(*distance)), ("least", Length(distance / 2.0))]
            }
            Self::ArcEndOffCircle { start_radius, end_radius } => {
                vec![("start_radius", Length(*start_radius)), ("end_radius", Length(*end_radius))]
            }
            Self::ArcRadiusNegative { word } => vec![("word", Text(word))],
            Self::CompensationOvercut { radius, .. } | Self::CompensationNoIntersection { radius } => {
                vec![("radius", Length(*radius))]
            }
            Self::TaperBeyondStart { word, limit, axis } => {
                vec![("word", Text(word)), ("limit", Length(*limit)), ("axis", Letter(*axis))]
            }
            Self::TaperNotExtended { taper, needed, crossing, wanted, axis } => vec![
                ("taper", Length(*taper)),
                ("needed", Length(*needed)),
                ("crossing", Length(*crossing)),
                ("wanted", Length(*wanted)),
                ("axis", Letter(*axis)),
            ],
            Self::ContourReversed { first, word } => {
                vec![("first", Count(i64::from(*first))), ("word", Text(word))]
            }
            Self::ContourReachesOver { code, word, line } => {
                vec![("code", Text(code)), ("word", Text(word)), ("line", Count(i64::from(*line)))]
            }
            Self::ContourBothAxes { code, other } => vec![("code", Text(code)), ("other", Letter(*other))],
            Self::ContourTurnsBack { code, axis, line } => {
                vec![("code", Text(code)), ("axis", Letter(*axis)), ("line", Count(i64::from(*line)))]
            }
            Self::ContourBeyondStart { code, axis } => vec![("code", Text(code)), ("axis", Letter(*axis))],
            Self::DepthNotPositive { code, depth } => {
                vec![("code", Text(code)), ("depth", Length(depth.unwrap_or_default()))]
            }
            Self::PatternPasses { passes } => vec![("passes", Number(passes.unwrap_or_default()))],
            Self::TooManyPasses { code, most } => vec![("code", Text(code)), ("most", Count(*most as i64))],
            Self::PeckMissing { code, address } => vec![("code", Text(code)), ("address", Letter(*address))],
            Self::ThreadAngle { angle } => vec![("angle", Number(*angle))],
            Self::ThreadLeastDepth { least, height } => {
                vec![("least", Length(*least)), ("height", Length(*height))]
            }
            Self::ThreadStartInside { start, crest, .. } => {
                vec![("start", Length(*start)), ("crest", Length(*crest))]
            }
            Self::CornerTwice { word, other } => vec![("word", Text(word)), ("other", Text(other))],
            Self::CycleWord { code, word } | Self::CycleAxis { code, word } => {
                vec![("code", Text(code)), ("word", Text(word))]
            }
            Self::FinishStart { roughed_x, roughed_z } => {
                vec![("roughed_x", Length(*roughed_x)), ("roughed_z", Length(*roughed_z))]
            }
            Self::FinishWithoutRoughing { first, last } => {
                vec![("first", Count(i64::from(*first))), ("last", Count(i64::from(*last)))]
            }
            Self::LeadRunsOut { word, reached, length } => {
                vec![("word", Text(word)), ("reached", Length(*reached)), ("length", Length(*length))]
            }
            Self::LeadingZero { word, value, meant } => {
                vec![("word", Text(word)), ("value", Number(*value)), ("meant", Text(meant))]
            }
            Self::PointMissing { word, thousandths } => {
                vec![("word", Text(word)), ("thousandths", Length(*thousandths))]
            }
            Self::FarOff { word, axis, to, farthest } => vec![
                ("word", Text(word)),
                ("axis", Letter(*axis)),
                ("to", Length(*to)),
                ("farthest", Length(*farthest)),
            ],
            Self::MinusMissing { word, meant } => vec![("word", Text(word)), ("meant", Text(meant))],
            Self::IncrementalForAbsolute { word, axis, to, meant } => vec![
                ("word", Text(word)),
                ("axis", Letter(*axis)),
                ("to", Length(*to)),
                ("meant", Text(meant)),
            ],
            Self::SpeedMissing { .. } | Self::PolarNoRadius { offset: None } => vec![],
            Self::PolarNoRadius { offset: Some(offset) } => vec![("offset", Count(i64::from(*offset)))],
            Self::SpeedNotRepeated { code, speed } => vec![("code", Text(code)), ("speed", Number(*speed))],
            Self::ThreadTooFast { speed, pitch, limit, .. } => {
                vec![("speed", Number(*speed)), ("pitch", Length(*pitch)), ("limit", Number(*limit))]
            }
            Self::ThreadSpeedChanged { before, now } => {
                vec![("before", Number(*before)), ("now", Number(*now))]
            }
            Self::ThreadStartMoved { before, now, lead } => {
                vec![("before", Length(*before)), ("now", Length(*now)), ("lead", Length(*lead))]
            }
            Self::ThreadRunIn { have, need } => vec![("have", Length(*have)), ("need", Length(*need))],
            Self::ThreadHeight { height, pitch, usual } => {
                vec![("height", Length(*height)), ("pitch", Length(*pitch)), ("usual", Length(*usual))]
            }
            Self::ThreadFirstDepth { first, height } => {
                vec![("first", Length(*first)), ("height", Length(*height))]
            }
            Self::ThreadLeastLarge { word, least } => vec![("word", Text(word)), ("least", Length(*least))],
            Self::ThreadPullOut { pull_out, way } => {
                vec![("pull_out", Length(*pull_out)), ("way", Length(*way))]
            }
            Self::FeedOfThread { feed } => vec![("feed", Length(*feed))],
            Self::LeadOfFeed { code, feed } => vec![("code", Text(code)), ("feed", Length(*feed))],
            Self::TaperNarrows { word } => vec![("word", Text(word))],
            Self::TaperCrossesAxis { word, x } => vec![("word", Text(word)), ("x", Length(*x))],
            Self::TaperEdge { depth } => vec![("depth", Length(*depth))],
            Self::PassNotDeeper { word, axis, deepest } => {
                vec![("axis", Letter(*axis)), ("word", Text(word)), ("deepest", Length(*deepest))]
            }
            Self::AirCut { axis, distance } => vec![("axis", Letter(*axis)), ("distance", Length(*distance))],
            Self::StartBehindFace { z, face } => vec![("z", Length(*z)), ("face", Length(*face))],
            Self::StartInStock { code, x } => vec![("code", Text(code)), ("x", Length(*x))],
            Self::ToolChangeNear { tool, x, z } => {
                vec![("tool", Text(tool)), ("x", Length(*x)), ("z", Length(*z))]
            }
            Self::BoreRetract { x, z } => vec![("x", Length(*x)), ("z", Length(*z))],
            Self::GrooveStep { word, step, width } => {
                vec![("word", Text(word)), ("step", Length(*step)), ("width", Length(*width))]
            }
            Self::EscapeTooLarge { word, depth } => {
                vec![("word", Text(word)), ("depth", Length(*depth))]
            }
            Self::ContourStartMoved { code, axis, start, first } => vec![
                ("code", Text(code)),
                ("axis", Letter(*axis)),
                ("start", Length(*start)),
                ("first", Length(*first)),
            ],
            Self::ContourNotClosed { x, diameter } => {
                vec![("x", Length(*x)), ("diameter", Length(*diameter))]
            }
            Self::PatternShallow { depth, relief } => {
                vec![("depth", Length(*depth)), ("relief", Length(*relief))]
            }
            Self::PatternAir { share } => vec![("share", Number(*share))],
            Self::CompensationInCycle { word, code } => vec![("word", Text(word)), ("code", Text(code))],
            Self::CompensationLeftOn { code, word } => vec![("code", Text(code)), ("word", Text(word))],
            Self::CompensationSide { code, right } => vec![("code", Text(code)), ("right", Text(right))],
            Self::CompensationIdleBlocks => vec![],
            Self::CompensationShort { length, radius } => {
                vec![("length", Length(*length)), ("radius", Length(*radius))]
            }
            Self::CompensationTip { tip } => vec![("tip", Number(*tip))],
            Self::ChuckOpen { word } => vec![("word", Text(word))],
            Self::TapReverse => vec![],
            Self::TapSurface => vec![],
            Self::DuplicateSequence { sequence, line } => {
                vec![("sequence", Count(i64::from(*sequence))), ("line", Count(i64::from(*line)))]
            }
            Self::ArcOverHalf { word } => vec![("word", Text(word))],
            Self::NotCompared { most } => vec![("most", Count(*most as i64))],
            Self::CoolantOff => vec![],
            Self::FeedModeNotNamed => vec![],
            Self::ToolNotNamed => vec![],
            Self::FeedOnlyForFinishing { word } => vec![("word", Text(word))],
            Self::StopBehindMove => vec![],
            Self::SetupValue { key, value, need } => {
                let mut all = vec![("key", Text(key)), ("value", Number(*value))];
                if let Need::Below(most) | Need::AtMost(most) = need {
                    all.push(("most", Number(*most)));
                }
                all
            }
            Self::PartStopped { done, all } => {
                vec![("done", Count(*done as i64)), ("all", Count(*all as i64))]
            }
            Self::BehindLeftOut { cuts } | Self::ElsewhereLeftOut { cuts } => {
                vec![("cuts", Count(*cuts as i64))]
            }
            Self::NoteWord { word, expected } => vec![("word", Text(word)), ("expected", Text(expected))],
            Self::ToolNotListed { tool } | Self::ToolUnknown { tool } => vec![("tool", Text(tool))],
            Self::RapidThroughStock { x, z }
            | Self::DoglegThroughStock { x, z }
            | Self::IntoJaws { x, z }
            | Self::IntoTailstock { x, z }
            | Self::HolderInStock { x, z } => vec![("x", Length(*x)), ("z", Length(*z))],
            Self::RapidAlongStock { x } | Self::BelowCenter { x } => vec![("x", Length(*x))],
            Self::SlopeTooSteep { slope, follows } => {
                vec![("slope", Number(*slope)), ("follows", Number(*follows))]
            }
            Self::OverTravel { axis, to, limit } => {
                vec![("axis", Letter(*axis)), ("to", Length(*to)), ("limit", Length(*limit))]
            }
        }
    }
}
