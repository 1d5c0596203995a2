//! Rows for the report on an answer to an exercise.
//!
//! In: a report and the text of the answer. Out: a [`Graded`] for the command line and other programs: verdict, cause,
//! measuring report and checks, in a language. X is a diameter, lines count from 1.

use serde::Serialize;

#[cfg(target_arch = "wasm32")]
use tsify::Tsify;

use super::{Places, rounded};
use crate::exercise::{
    Checked, Exercise, Measured, NoTarget, Quantity, Report, Tolerance, Verdict, check, key_of,
};
use crate::message::Severity;
use crate::sentences::Language;
use crate::sentences::exercise::{
    describe_cause, describe_check, describe_finding, describe_verdict, place_of, quantity,
};
use crate::sentences::exercise_file::{describe_fault, describe_no_target};
use crate::source::{LineIndex, Span};
use crate::units::Diameter;

/// The report on an answer.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
#[serde(rename_all = "camelCase")]
pub struct Graded {
    /// Whether the part is the wanted one and all checks are passed.
    pub passed: bool,
    /// The points of the answer: the points of the exercise, or 0.
    pub points: u32,
    /// Whether the part is the wanted one.
    pub same_part: bool,
    /// The verdict on the part: `Same part`, or where it differs.
    pub part: String,
    /// The line that made the surface that differs.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub line: Option<u32>,
    /// Why the part differs, if a slip in the program explains it.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub cause: Option<Cause>,
    /// The measuring report.
    pub sizes: Vec<Size>,
    /// The checks.
    pub checks: Vec<Check>,
    /// Number of errors.
    pub errors: usize,
    /// Number of warnings.
    pub warnings: usize,
    /// Time of the program, seconds; omitted if it is not known.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub seconds: Option<f64>,
    /// The codes that the program uses, in the spelling of FANUC's system A.
    pub codes: Vec<String>,
    /// The earlier answer with the same text, apart from blanks, comments and N numbers.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub same_text_as: Option<String>,
}

/// Why a part differs.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct Cause {
    /// The cause, a sentence.
    pub text: String,
    /// The line of the word.
    pub line: u32,
}

/// A row of the measuring report.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct Size {
    /// The quantity.
    #[cfg_attr(
        target_arch = "wasm32",
        tsify(
            type = "\"diameter\" | \"length\" | \"face\" | \"angle\" | \"radius\" | \"width\" | \"lead\" | \"root\" | \"crest\" | \"thread-length\" | \"flats\""
        )
    )]
    pub quantity: &'static str,
    /// Its name.
    pub name: &'static str,
    /// Its place, such as `Z-20`.
    pub place: String,
    /// X of the place, a diameter, mm.
    pub x: Diameter,
    /// Z of the place, mm.
    pub z: f64,
    /// The wanted size, mm or degrees.
    pub nominal: f64,
    /// The size of the part; omitted if it has no such surface.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub actual: Option<f64>,
    /// Actual minus nominal size.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub deviation: Option<f64>,
    /// Least permitted deviation.
    pub lower: f64,
    /// Greatest permitted deviation.
    pub upper: f64,
    /// Whether the size is within its tolerance.
    #[serde(rename = "in")]
    pub is_in: bool,
}

/// The result of a check.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct Check {
    /// The check.
    pub check: String,
    /// Whether it is passed.
    pub passed: bool,
    /// What was found; empty if the check says it all.
    pub found: String,
    /// The line in the program.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub line: Option<u32>,
}

/// The blocks `setup` and `target` of an exercise whose part the program makes.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
#[serde(rename_all = "camelCase", tag = "kind")]
pub enum ExerciseBlocks {
    /// The blocks.
    Blocks {
        /// Their text.
        text: String,
    },
    /// The part has no target.
    None {
        /// The reason, without a full stop.
        reason: &'static str,
    },
}

impl ExerciseBlocks {
    /// The blocks, or the reason in a language.
    pub fn new(blocks: Result<String, NoTarget>, language: Language) -> Self {
        match blocks {
            Ok(text) => Self::Blocks { text },
            Err(why) => Self::None { reason: describe_no_target(why, language) },
        }
    }
}

/// The report on one of many answers to an exercise, or the fault of the exercise file.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
#[serde(rename_all = "camelCase", tag = "kind")]
pub enum AnswerReport {
    /// The report.
    Answer(Box<GradedAnswer>),
    /// The exercise file has a fault.
    Fault {
        /// The line, from 1.
        line: usize,
        /// The fault.
        message: String,
    },
}

/// The report on one of many answers to an exercise.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct GradedAnswer {
    /// The id of the exercise.
    pub id: String,
    /// The checksum of its file, as in [`ExerciseText`].
    pub version: String,
    /// Its title.
    pub title: String,
    /// The report.
    pub report: Graded,
    /// The blocks of the answer without blanks, comments and N numbers: equal for identical answers.
    pub blocks: String,
}

/// An exercise file as it was read.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
#[serde(rename_all = "camelCase", rename_all_fields = "camelCase", tag = "kind")]
pub enum ExerciseRead {
    /// The exercise.
    Exercise(Box<ExerciseText>),
    /// The file has a fault.
    Fault {
        /// The line, from 1.
        line: usize,
        /// The fault.
        message: String,
    },
}

/// The texts of an exercise in a language, and the program that the learner begins with.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
#[serde(rename_all = "camelCase")]
pub struct ExerciseText {
    /// Its name.
    pub id: String,
    /// A checksum of the file, 16 hexadecimal digits: another version of the exercise has another one.
    pub version: String,
    /// The title.
    pub title: String,
    /// The task, Markdown without HTML.
    pub task: String,
    /// The hints, Markdown without HTML.
    pub hints: Vec<String>,
    /// The points of a passed answer.
    pub points: u32,
    /// The page of the manual that it practises.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub chapter: Option<String>,
    /// What the learner does, as in the file.
    #[cfg_attr(
        target_arch = "wasm32",
        tsify(type = "\"write\" | \"fault\" | \"predict\" | \"order\" | \"blanks\"")
    )]
    pub task_kind: &'static str,
    /// Lines of the program, from 1, whose end points are predicted.
    pub predict: Vec<u32>,
    /// The program that the learner starts with; may be empty.
    pub program: String,
    /// Blank, tools and machine: JSON, or comments.
    pub setup: String,
}

impl ExerciseRead {
    /// Reads the text of a file.
    pub fn new(text: &str, language: Language) -> Self {
        match Exercise::read(text) {
            Ok(exercise) => {
                Self::Exercise(Box::new(ExerciseText::new(&exercise, version_of(text), language)))
            }
            Err(fault) => Self::Fault { line: fault.line, message: describe_fault(&fault, language) },
        }
    }
}

impl AnswerReport {
    /// Checks a program as the answer to the exercise with the text of a file.
    pub fn new(text: &str, answer: &[u8], language: Language) -> Self {
        let exercise = match Exercise::read(text) {
            Ok(exercise) => exercise,
            Err(fault) => {
                return Self::Fault { line: fault.line, message: describe_fault(&fault, language) };
            }
        };
        let title = exercise.texts(language as usize).map_or_else(String::new, |texts| texts.title.clone());
        Self::Answer(Box::new(GradedAnswer {
            version: version_of(text),
            title,
            report: Graded::of_answer(&exercise, answer, language),
            blocks: String::from_utf8_lossy(&key_of(answer)).into_owned(),
            id: exercise.id,
        }))
    }
}

/// The checksum of a text, whatever its line ends are: FNV-1a, 64 bits.
fn version_of(text: &str) -> String {
    let bytes = text.bytes().filter(|byte| *byte != b'\r');
    let sum = bytes.fold(0xcbf2_9ce4_8422_2325_u64, |sum, byte| {
        (sum ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
    });
    format!("{sum:016x}")
}

impl ExerciseText {
    fn new(exercise: &Exercise, version: String, language: Language) -> Self {
        let texts = exercise.texts(language as usize).cloned().unwrap_or_default();
        Self {
            id: exercise.id.clone(),
            version,
            title: texts.title,
            task: texts.task,
            hints: texts.hints,
            points: exercise.points,
            chapter: exercise.chapter.clone(),
            task_kind: exercise.kind.name(),
            predict: exercise.checks.predict.clone(),
            program: exercise.program.clone(),
            setup: exercise.setup_text.clone(),
        }
    }
}

impl Graded {
    /// The report on a program as an answer.
    pub fn of_answer(exercise: &Exercise, answer: &[u8], language: Language) -> Self {
        let lines = LineIndex::as_written(answer);
        let report = check(exercise, answer);
        Self::new(&report, exercise, Places { text: answer, lines: &lines }, language)
    }

    /// The row of a report. `places`: positions in the text of the answer.
    pub fn new(report: &Report, exercise: &Exercise, places: Places, language: Language) -> Self {
        let line = |span: Span| places.lines.line_of(span.start.min(places.text.len() as u32)) + 1;
        let place = match &report.verdict {
            Verdict::Differs(place) => place.span,
            Verdict::Same | Verdict::NoPart => None,
        };
        let passed = report.is_passed();
        let cause = report.cause.as_ref();
        Self {
            passed,
            points: if passed { exercise.points } else { 0 },
            same_part: report.verdict == Verdict::Same,
            part: describe_verdict(&report.verdict, language),
            line: place.map(line),
            cause: cause.map(|own| Cause { text: describe_cause(own, language), line: line(own.span) }),
            sizes: report.sizes.iter().map(|size| Size::new(size, language)).collect(),
            checks: report.checks.iter().map(|check| Check::new(check, line, language)).collect(),
            errors: report.count(Severity::Error),
            warnings: report.count(Severity::Warning),
            seconds: report.seconds.map(rounded),
            codes: report.codes.clone(),
            same_text_as: None,
        }
    }

    /// The failed checks.
    pub fn failed(&self) -> impl Iterator<Item = &Check> {
        self.checks.iter().filter(|check| !check.passed)
    }
}

impl Size {
    fn new(own: &Measured, language: Language) -> Self {
        let Tolerance { lower, upper } = own.tolerance;
        Self {
            quantity: name_of(own.quantity),
            name: quantity(own.quantity, language),
            place: place_of(own),
            x: Diameter::from_radius(own.at.x).map(rounded),
            z: rounded(own.at.z),
            nominal: rounded(own.nominal),
            actual: own.actual.map(rounded),
            deviation: own.deviation().map(rounded),
            lower: rounded(lower),
            upper: rounded(upper),
            is_in: own.is_in(),
        }
    }
}

impl Check {
    fn new(own: &Checked, line: impl Fn(Span) -> u32, language: Language) -> Self {
        Self {
            check: describe_check(&own.check, language),
            passed: own.passed,
            found: describe_finding(own, language),
            line: own.span.map(line),
        }
    }
}

fn name_of(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::Diameter => "diameter",
        Quantity::Length => "length",
        Quantity::Face => "face",
        Quantity::Angle => "angle",
        Quantity::Radius => "radius",
        Quantity::Width => "width",
        Quantity::Lead => "lead",
        Quantity::Root => "root",
        Quantity::Crest => "crest",
        Quantity::ThreadLength => "thread-length",
        Quantity::Flats => "flats",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The values of the reference implementation of FNV-1a for the empty text, `a` and `foobar`.
    #[test]
    fn the_version_is_the_checksum_of_the_text() {
        assert_eq!(version_of(""), "cbf29ce484222325");
        assert_eq!(version_of("a"), "af63dc4c8601ec8c");
        assert_eq!(version_of("foobar"), "85944171f73967e8");
        assert_eq!(version_of("G90\r\nM30\r\n"), version_of("G90\nM30\n"));
    }
}
