//! Every message once, with words and numbers made up: for the list of rules, and for the tests of the templates.
//!
//! In: nothing. Out: messages of which each wording says one, and one for each alarm where several are raised.

use crate::control::macros::FaultKind;
use crate::diagnostics::Message;
use crate::origin::{Measure, Origin};
use crate::setup::dialect::{DecimalRule, GSystem};
use crate::setup::faults::Need;

/// A message for each wording; a test misses one that is not here.
pub(crate) fn samples() -> Vec<Message> {
    let mut samples = vec![
        Message::NumberMissing { address: 'X' },
        Message::AddressMissing { number: "X1".into() },
        Message::NotUnderstood { text: "X1".into() },
        Message::PlainText { text: "X1".into() },
        Message::SecondPoint { word: "X1".into() },
        Message::TooManyDigits { word: "X1".into() },
        Message::BlankInNumber { written: "X1".into(), joined: "X1".into() },
        Message::LetterForDigit { address: 'X', word: "X1".into(), digit: "G71" },
        Message::ZeroForO { number: "X1".into() },
        Message::PrintedMinus,
        Message::FullWidth { word: "X1".into(), plain: "X1".into() },
        Message::CommaForPoint { address: 'X', word: "X1".into() },
        Message::CommentOpen,
        Message::CommentNested,
        Message::TextAfterSemicolon { text: "X1".into() },
        Message::BlockTooLong { most: 5 },
        Message::TextTooLong { bytes: 5, most: 5 },
        Message::EmptyProgram,
        Message::ProgramNumberZero,
        Message::DuplicateProgram { number: 7 },
        Message::NoEnd,
        Message::MoreMessages { hidden: 5 },
        Message::TooManyMotions { most: 5 },
        Message::TooMuchWork { most: 5 },
        Message::Stopped { seconds: 1.5 },
        Message::CallNoNumber { code: "G71" },
        Message::ProgramNotFound { word: "X1".into() },
        Message::SequenceNotFound { sequence: 7 },
        Message::CallTooDeep { most: 5, alarm: "PS0077" },
        Message::CallTooDeep { most: 5, alarm: "PS0122" },
        Message::NoReturn,
        Message::EndlessMain,
        Message::TooManyRepeats { most: 5 },
        Message::TooMuchRepeated { most: 5 },
        Message::TooManyRounds { most: 5 },
        Message::TooManyMacroSteps { most: 5 },
        Message::NotRun { number: 7 },
        Message::NumberFromVariable { word: "X1".into() },
        Message::MacroAlarm { number: 3001, words: "X1".into() },
        Message::SystemVariable { variable: 7 },
        Message::ArgumentsUnknown { variable: 7 },
        Message::SystemGuessed { system: GSystem::B },
        Message::DecimalRule {
            word: "X1".into(),
            value: 1.5,
            measure: Measure::Millimetre,
            rule: DecimalRule::LeastIncrement,
        },
        Message::DecimalRule {
            word: "X1".into(),
            value: 1.5,
            measure: Measure::Inch,
            rule: DecimalRule::LeastIncrement,
        },
        Message::DecimalRule {
            word: "X1".into(),
            value: 1.5,
            measure: Measure::Second,
            rule: DecimalRule::LeastIncrement,
        },
        Message::DecimalRule {
            word: "X1".into(),
            value: 1.5,
            measure: Measure::Millimetre,
            rule: DecimalRule::Calculator,
        },
        Message::DecimalRule {
            word: "X1".into(),
            value: 1.5,
            measure: Measure::Inch,
            rule: DecimalRule::Calculator,
        },
        Message::DecimalRule {
            word: "X1".into(),
            value: 1.5,
            measure: Measure::Second,
            rule: DecimalRule::Calculator,
        },
        Message::ReferenceNumber { word: "X1".into() },
        Message::NotAtReference { x: 1.5, z: 1.5 },
        Message::NoIntermediate,
        Message::MachineZero { x: 1.5, z: 1.5 },
        Message::OffsetNumber { word: "X1".into() },
        Message::TipNumber { word: "X1".into() },
        Message::DataPassedOver,
        Message::HoleInForce { word: "X1".into(), hole: "G83", alarm: "PS0044" },
        Message::HoleInForce { word: "X1".into(), hole: "G83", alarm: "PS0327" },
        Message::PeckZero { word: "X1".into() },
        Message::HoleNoDepth { code: "G71" },
        Message::HoleOfOthers { code: "G71" },
        Message::UnknownG { word: "X1".into() },
        Message::UnknownM { word: "X1".into() },
        Message::NotSupported { what: "X1".into() },
        Message::MakerG { word: "X1".into() },
        Message::PointNotAllowed { word: "X1".into() },
        Message::MinusNotAllowed { word: "X1".into() },
        Message::DuplicateWord { address: 'X', used: "X1".into() },
        Message::SameGroup { dropped: "X1".into(), used: "X1".into() },
        Message::AbsoluteAndIncremental {
            absolute: "X1".into(),
            incremental: "X1".into(),
            used: "X1".into(),
        },
        Message::ToolWithSetting { word: "X1".into(), only_speed: false },
        Message::ToolWithSetting { word: "X1".into(), only_speed: true },
        Message::ShortTool { word: "X1".into(), offset: 5 },
        Message::ToolNumber { word: "X1".into(), of_machine: false },
        Message::ToolNumber { word: "X1".into(), of_machine: true },
        Message::G90AsAbsolute,
        Message::LetterIInG92,
        Message::G28NoAxis { code: "G28" },
        Message::DwellWithPoint { word: "X1".into() },
        Message::DwellNoTime,
        Message::AxisNotHere { word: "X1".into() },
        Message::PlaneNotHere { word: "G71" },
        Message::CAxisNotConnected,
        Message::LiveToolStopped,
        Message::PolarForbidden { word: "X1".into() },
        Message::PolarFrame { word: "X1".into() },
        Message::PolarNotAlone { code: "G71", other: "X1".into() },
        Message::PlaneCompensation { code: "G71" },
        Message::PolarFeedPerTurn,
        Message::PolarNoRadius { offset: None },
        Message::PolarNoRadius { offset: Some(5) },
        Message::PolarAngle { word: "X1".into() },
        Message::PolarCenter { distance: 1.5 },
        Message::PlaneLeftOn { code: "X1".into(), off: "G71" },
        Message::CylinderFormat,
        Message::CylinderForbidden { word: "X1".into() },
        Message::FeedMissing,
        Message::LeadMissing { code: "G71" },
        Message::FeedUnit { word: "X1".into(), feed: 1.5, per_turn: true },
        Message::FeedUnit { word: "X1".into(), feed: 1.5, per_turn: false },
        Message::FeedNotRepeated { feed: 1.5, per_turn: true },
        Message::FeedNotRepeated { feed: 1.5, per_turn: false },
        Message::SpindleStopped,
        Message::NoSpeedClamp,
        Message::ClampReversed { lowest: 1.5, highest: 1.5 },
        Message::ThreadAtSurfaceSpeed { code: "G71" },
        Message::ArcNoCenter { code: "G71" },
        Message::ArcRadiusTooSmall { word: "X1".into(), distance: 1.5 },
        Message::ArcEndOffCircle { start_radius: 1.5, end_radius: 1.5 },
        Message::ArcEndOffCircle { start_radius: 0.0, end_radius: 1.5 },
        Message::ArcRadiusNegative { word: "X1".into() },
        Message::ArcNowhere,
        Message::TaperBeyondStart { word: "X1".into(), limit: 1.5, axis: 'U' },
        Message::TaperBeyondStart { word: "X1".into(), limit: 1.5, axis: 'W' },
        Message::TaperNotExtended { taper: 1.5, needed: 1.5, crossing: 1.5, wanted: 1.5, axis: 'X' },
        Message::ContourNotNamed { code: "G71" },
        Message::ContourNotFound { word: "X1".into() },
        Message::ContourReversed { first: 7, word: "X1".into() },
        Message::ContourFirstBlock { code: "G71" },
        Message::ContourIllegal { word: "X1".into() },
        Message::ContourReachesOver { code: "G71", word: "X1".into(), line: 7 },
        Message::ContourCall { word: "X1".into() },
        Message::ContourBothAxes { code: "G71", other: 'X' },
        Message::ContourTypeTwo { code: "G71" },
        Message::ContourTurnsBack { code: "G71", axis: 'X', line: 7 },
        Message::ContourTurnsBack { code: "G71", axis: 'Z', line: 7 },
        Message::ContourBeyondStart { code: "G71", axis: 'X' },
        Message::ContourNothingToCut { code: "G71" },
        Message::ContourOpenEnd { word: "X1".into(), alarm: "PS0326" },
        Message::ContourOpenEnd { word: "X1".into(), alarm: "PS0069" },
        Message::DepthNotPositive { code: "G71", depth: None },
        Message::DepthNotPositive { code: "G71", depth: Some(-1.0) },
        Message::AllowanceSign { word: "X1".into() },
        Message::PatternPasses { passes: None },
        Message::PatternPasses { passes: Some(0.0) },
        Message::TooManyPasses { code: "G71", most: 5 },
        Message::PeckNegative { word: "X1".into() },
        Message::PeckMissing { code: "G71", address: 'X' },
        Message::ReliefNegative { word: "X1".into() },
        Message::AmountInMillimetres { word: "X1".into() },
        Message::ThreadAngle { angle: 1.5 },
        Message::ThreadLeastDepth { least: 1.5, height: 1.5 },
        Message::ThreadNoDepth { word: 'P' },
        Message::ThreadNoDepth { word: 'Q' },
        Message::ThreadStartInside { start: 1.5, crest: 1.5, at_crest: false },
        Message::ThreadStartInside { start: 1.5, crest: 1.5, at_crest: true },
        Message::CornerNoMove { word: "X1".into() },
        Message::CornerTooLarge { word: "X1".into() },
        Message::CornerNone { word: "X1".into() },
        Message::CornerStraight { word: "X1".into() },
        Message::CornerNoLine { word: "X1".into() },
        Message::CornerAxis { word: "X1".into(), alarm: "PS0051" },
        Message::CornerAxis { word: "X1".into(), alarm: "PS0054" },
        Message::CornerAxis { word: "X1".into(), alarm: "PS0306" },
        Message::CornerTwice { word: "X1".into(), other: "X1".into() },
        Message::CornerInThread { word: "X1".into() },
        Message::CornerWithCompensation { word: "X1".into() },
        Message::CyclePlane { code: "G71", alarm: "PS0327" },
        Message::CyclePlane { code: ",A", alarm: "PS0212" },
        Message::CycleWord { code: "G71", word: "X1".into() },
        Message::CycleAxis { code: "G71", word: "X1".into() },
        Message::FinishStart { roughed_x: 1.5, roughed_z: 1.5 },
        Message::FinishWithoutRoughing { first: 7, last: 7 },
        Message::AngleNoPoint { word: "X1".into(), alarm: "PS0056" },
        Message::AngleNoPoint { word: "X1".into(), alarm: "PS0057" },
        Message::AngleNoPoint { word: "X1".into(), alarm: "PS0058" },
        Message::CompensationOnArc { code: "G71" },
        Message::CompensationOvercut { radius: 1.5, alarm: "PS0041" },
        Message::CompensationOvercut { radius: 1.5, alarm: "PS0038" },
        Message::CompensationNoIntersection { radius: 1.5 },
        Message::CompensationPlane,
        Message::LeadRunsOut { word: "X1".into(), reached: 1.5, length: 1.5 },
        Message::CompensationIdle { code: "G71" },
        Message::LeadingZero { word: "X1".into(), value: 1.5, meant: "X1".into() },
        Message::PointMissing { word: "X1".into(), thousandths: 1.5 },
        Message::FarOff { word: "X1".into(), axis: 'X', to: 1.5, farthest: 1.5 },
        Message::MinusMissing { word: "X1".into(), meant: "X1".into() },
        Message::IncrementalForAbsolute { word: "X1".into(), axis: 'X', to: 1.5, meant: "X1".into() },
        Message::SpeedMissing { of_surface: false },
        Message::SpeedMissing { of_surface: true },
        Message::SpeedNotRepeated { code: "G71", speed: 1.5 },
        Message::ThreadTooFast { speed: 1.5, pitch: 1.5, limit: 1.5, slide: 1.5 },
        Message::ThreadSpeedChanged { before: 1.5, now: 1.5 },
        Message::ThreadStartMoved { before: 1.5, now: 1.5, lead: 1.5 },
        Message::ThreadRunIn { have: 1.5, need: 1.5 },
        Message::ThreadHeight { height: 1.5, pitch: 1.5, usual: 1.5 },
        Message::ThreadFirstDepth { first: 1.5, height: 1.5 },
        Message::ThreadLeastLarge { word: "X1".into(), least: 1.5 },
        Message::ThreadPullOut { pull_out: 1.5, way: 1.5 },
        Message::FeedOfThread { feed: 1.5 },
        Message::LeadOfFeed { code: "G71", feed: 1.5 },
        Message::TaperNarrows { word: "X1".into() },
        Message::TaperCrossesAxis { word: "X1".into(), x: 1.5 },
        Message::TaperEdge { depth: 1.5 },
        Message::PassNotDeeper { word: "X1".into(), axis: 'X', deepest: 1.5 },
        Message::AirCut { axis: 'X', distance: 1.5 },
        Message::StartBehindFace { z: 1.5, face: 1.5 },
        Message::StartInStock { code: "G71", x: 1.5 },
        Message::ToolChangeNear { tool: "X1".into(), x: 1.5, z: 1.5 },
        Message::BoreRetract { x: 1.5, z: 1.5 },
        Message::GrooveStep { word: "X1".into(), step: 1.5, width: 1.5 },
        Message::EscapeTooLarge { word: "X1".into(), depth: 1.5 },
        Message::ContourStartMoved { code: "G71", axis: 'X', start: 1.5, first: 1.5 },
        Message::ContourNotClosed { x: 1.5, diameter: 1.5 },
        Message::PatternShallow { depth: 1.5, relief: 1.5 },
        Message::PatternAir { share: 1.5 },
        Message::CompensationInCycle { word: "X1".into(), code: "G71" },
        Message::CompensationLeftOn { code: "G71", word: "X1".into() },
        Message::CompensationSide { code: "G71", right: "G71" },
        Message::CompensationTurnsBack { code: "G71" },
        Message::CompensationIdleBlocks,
        Message::CompensationShort { length: 1.5, radius: 1.5 },
        Message::CompensationTip { tip: 1.5 },
        Message::ChuckOpen { word: "X1".into() },
        Message::TapReverse,
        Message::TapSurface,
        Message::DuplicateSequence { sequence: 7, line: 7 },
        Message::ArcOverHalf { word: "X1".into() },
        Message::NotCompared { most: 5 },
        Message::CoolantOff,
        Message::FeedModeNotNamed,
        Message::ToolNotNamed,
        Message::FeedOnlyForFinishing { word: "X1".into() },
        Message::StopBehindMove,
        Message::SetupValue { key: "X1".into(), value: -1.5, need: Need::Positive },
        Message::SetupValue { key: "X1".into(), value: -1.5, need: Need::NotNegative },
        Message::SetupValue { key: "X1".into(), value: 1.5, need: Need::Below(1.0) },
        Message::SetupValue { key: "X1".into(), value: 1.5, need: Need::AtMost(1.0) },
        Message::NoteWord { word: "X1".into(), expected: "G71".into() },
        Message::PartTooManyMotions { most: 5 },
        Message::PartTooManyCorners { most: 5 },
        Message::PartStopped { done: 3, all: 5 },
        Message::BehindLeftOut { cuts: 0 },
        Message::BehindLeftOut { cuts: 3 },
        Message::ElsewhereLeftOut { cuts: 3 },
        Message::ToolUnknown { tool: "X1".into() },
        Message::ToolNotListed { tool: "X1".into() },
        Message::RapidThroughStock { x: 1.5, z: 1.5 },
        Message::DoglegThroughStock { x: 1.5, z: 1.5 },
        Message::RapidAlongStock { x: 1.5 },
        Message::IntoJaws { x: 1.5, z: 1.5 },
        Message::IntoTailstock { x: 1.5, z: 1.5 },
        Message::HolderInStock { x: 1.5, z: 1.5 },
        Message::SlopeTooSteep { slope: 1.5, follows: 1.5 },
        Message::BelowCenter { x: 1.5 },
        Message::OverTravel { axis: 'X', to: 1.5, limit: 1.5 },
    ];
    let kinds = [
        FaultKind::Overflow,
        FaultKind::DivisionByZero,
        FaultKind::UnknownFunction,
        FaultKind::Expression,
        FaultKind::BracketOpen,
        FaultKind::NumberOrCondition,
        FaultKind::VariableNumber,
        FaultKind::ReadOnly,
        FaultKind::BracketsTooDeep,
        FaultKind::FunctionArgument,
        FaultKind::EndMissing,
        FaultKind::Format,
        FaultKind::LoopNumber,
        FaultKind::WordsBehind,
        FaultKind::JumpTarget,
        FaultKind::ArgumentLetter,
    ];
    samples.extend(kinds.map(|kind| Message::Macro { kind }));
    samples.extend(Origin::ALL.map(|origin| Message::Foreign { origin }));
    samples
}

#[cfg(test)]
mod tests {
    //! The templates of all languages, held against the messages they are filled from.

    use super::super::wording::Wording;
    use super::super::*;
    use super::samples;
    use crate::units::Unit;

    #[test]
    fn every_sentence_quotes_nothing_but_what_its_message_has() {
        let mut said = Vec::new();
        for message in samples() {
            for language in Language::ALL {
                let arguments = message.arguments_in(language, Unit::Inch);
                let template = language.template(Wording::of(&message));
                for name in placeholders(template) {
                    assert!(arguments.iter().any(|argument| argument.0 == name), "{name} in {template}");
                }
                assert!(!template.is_empty() && template.lines().count() <= 2, "{template}");
                let sentence = message.sentence(language);
                let help = sentence.help.unwrap_or_default();
                assert!(!format!("{}{help}", sentence.message).contains(['{', '}']), "{template}");
            }
            said.push(Wording::of(&message));
        }
        for wording in Wording::ALL {
            assert!(said.contains(wording), "no sample is said by {wording:?}");
        }
    }

    #[test]
    fn languages_quote_the_same() {
        let sorted = |template| {
            let mut names: Vec<&str> = placeholders(template).collect();
            names.sort_unstable();
            names.dedup();
            names
        };
        for &wording in Wording::ALL {
            let [english, others @ ..] = Language::ALL.map(|language| sorted(language.template(wording)));
            for other in others {
                assert_eq!(english, other, "{wording:?}");
            }
        }
        for &phrase in Phrase::ALL {
            let [english, others @ ..] = Language::ALL.map(|language| sorted(language.phrase(phrase)));
            for other in others {
                assert_eq!(english, other, "{phrase:?}");
            }
        }
    }

    #[test]
    fn what_a_message_quotes_is_not_a_template() {
        let text = "{text} {0}".to_owned();
        let message = Message::PlainText { text }.sentence(Language::English).message;
        assert_eq!(message, "`{text} {0}` is plain text, not a block.");
    }

    fn placeholders(template: &str) -> impl Iterator<Item = &str> {
        template.split('{').skip(1).map(|part| part.split_once('}').expect("a closed placeholder").0)
    }
}
