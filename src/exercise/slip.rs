//! Why a part differs: a slip in the program, such as R taken from the drawing.
//!
//! In: an answer whose part differs, and the target. Out: the [`Cause`]. A slip is named only if undoing it and running
//! the program again gives the target. The number of such runs is limited.

use std::collections::BTreeMap;

use super::Exercise;
use super::answer::Answer;
use super::codes::each_block;
use super::edge::Size;
use super::measure;
use super::quantity::Measured;
use super::shape::Shape;
use super::target::Target;
use crate::control::words::{plain, with_other_sign};
use crate::cycles::single::{Single, cuts_along_x};
use crate::geometry::{Point, SAME};
use crate::message::applied;
use crate::message::{Diagnostic, Edit};
use crate::motion::{Motion, Step};
use crate::order;
use crate::source::Span;
use crate::text::block::{Value, Word};
use crate::units::{Diameter, number};

/// Most runs with a slip undone, and most motions of all of them.
const MOST_TRIES: usize = 80;
const MOST_WORK: usize = 60_000;
/// Most words of one kind of slip that are tried one by one.
const MOST_WORDS: usize = 12;
/// Most rounds of fixes of one rule.
const MOST_ROUNDS: usize = 6;
/// Difference up to which a programmed R is that of the drawing, mm.
const SAME_R: f64 = 0.011;

/// A slip: the word as written, and the right one.
#[derive(Clone, Debug, PartialEq)]
pub enum Slip {
    /// R (I, K) was taken from the drawing, and not calculated for the real start of the cut.
    TaperFromDrawing {
        /// The word as written.
        written: String,
        /// The right word.
        right: String,
        /// The axis along which the cut starts further out.
        axis: char,
        /// Where the cone of the drawing begins; X as a diameter, mm.
        from: f64,
        /// Where the cut starts; X as a diameter, mm.
        start: f64,
    },
    /// The sign of R (I, K) is wrong.
    TaperSign {
        /// The word as written.
        written: String,
        /// The right word.
        right: String,
    },
    /// X is a radius instead of a diameter.
    RadiusForDiameter {
        /// The first such word.
        written: String,
        /// The right word.
        right: String,
    },
    /// X has a wrong minus sign.
    SignOfX {
        /// The first such word.
        written: String,
        /// The right word.
        right: String,
    },
    /// A minus sign of Z or W is missing.
    MissingMinus {
        /// The first such word.
        written: String,
        /// The right word.
        right: String,
    },
    /// The fault that a message reports, with its fix.
    Reported(Box<Diagnostic>),
}

/// A slip with its place.
#[derive(Clone, Debug, PartialEq)]
pub struct Cause {
    /// The slip.
    pub slip: Slip,
    /// The first word.
    pub span: Span,
    /// The number of words with the slip.
    pub words: usize,
}

/// A slip that may be the cause, with the edits that undo it.
struct Candidate {
    slip: Slip,
    edits: Vec<Edit>,
}

/// The cause of a difference; `None` if no known slip explains it.
pub(super) fn cause(exercise: &Exercise, answer: &Answer) -> Option<Cause> {
    let tries = MOST_TRIES.min(MOST_WORK / answer.analysis.motions.len().max(1));
    if tries < MOST_ROUNDS {
        return None;
    }
    let makes_target =
        |text: &[u8]| is_of(&Answer::without_findings(text, &exercise.setup), &exercise.target);
    let undoes = |candidate: &Candidate| makes_target(&applied(&answer.text, &candidate.edits));
    let mut candidates = candidates(&exercise.target, answer);
    candidates.truncate(tries);
    let found = candidates.into_iter().find(undoes).map(|found| Cause {
        span: found.edits.first().map_or(Span::default(), |edit| edit.span),
        words: found.edits.len(),
        slip: found.slip,
    });
    found.or_else(|| reported(exercise, answer))
}

/// Whether the part of an answer is that of the target.
fn is_of(answer: &Answer, target: &Target) -> bool {
    let Some(part) = &answer.part else { return false };
    let shape = Shape::new(target, part.clone(), &answer.threads);
    measure::report(target, &shape, answer).iter().all(Measured::is_in) && shape.excess().is_none()
}

/// The slips that may be the cause, fewest words first.
fn candidates(target: &Target, answer: &Answer) -> Vec<Candidate> {
    let words = Words::of(answer);
    let mut all = words.tapers_from_drawing(target);
    let sign = Words::other_sign;
    let taper = |written, right| Slip::TaperSign { written, right };
    all.extend(words.each_and_all(b"RIK", |own| own.is_of_taper, sign, taper));
    let minus = |written, right| Slip::MissingMinus { written, right };
    all.extend(words.each_and_all(b"ZW", |own| own.value > SAME && own.cuts, sign, minus));
    all.extend(words.each_and_all(b"ZW", |own| own.value > SAME && !own.cuts, sign, minus));
    let radius = |written, right| Slip::RadiusForDiameter { written, right };
    all.extend(words.each_and_all(b"XU", |own| own.value != 0.0, Words::doubled, radius));
    let side = |written, right| Slip::SignOfX { written, right };
    all.extend(words.each_and_all(b"X", |own| own.value < -SAME, sign, side));
    order::by_key(&mut all, |candidate| candidate.edits.len());
    all
}

/// A word of an executed block.
struct Own {
    word: Word,
    written: String,
    value: f64,
    /// Whether its block cuts.
    cuts: bool,
    /// Whether it is the taper of a single cycle.
    is_of_taper: bool,
    /// The first cut of its block.
    cut: Option<Motion>,
}

/// The words of the executed blocks, in the order of the text.
struct Words(Vec<Own>);

impl Words {
    fn of(answer: &Answer) -> Self {
        let (mut all, cuts) = (Vec::new(), first_cuts(answer));
        each_block(&answer.text, &answer.analysis, |block| {
            let words = block.words.iter().filter(|word| b"XUZWRIK".contains(&word.address) && !word.comma);
            let cut = cuts.get(&block.span.start).copied();
            all.extend(words.filter_map(|&word| {
                let is_single =
                    cut.is_some_and(|cut| cut.cycle.is_some_and(|tag| Single::of(tag.cycle).is_some()));
                Some(Own {
                    written: word.span.quote(&answer.text),
                    value: plain(&word)?,
                    cuts: cut.is_some(),
                    is_of_taper: is_single && b"RIK".contains(&word.address),
                    cut,
                    word,
                })
            }));
        });
        Self(all)
    }

    /// R of single cycles that fits the cone of the drawing, but not the start of the cut.
    fn tapers_from_drawing(&self, target: &Target) -> Vec<Candidate> {
        let tapers = || target.edges.iter().filter(|edge| edge.size() == Size::Taper);
        let mut found: Vec<Candidate> = Vec::new();
        for edge in tapers() {
            for begin in [edge.from, edge.to] {
                let own = self.0.iter().filter(|own| own.is_of_taper);
                let slips: Vec<_> =
                    own.filter_map(|own| own.taper_from_drawing([edge.from, edge.to], begin)).collect();
                let edits = slips.iter().map(|(_, edit)| edit.clone()).collect();
                if let Some((slip, _)) = slips.into_iter().next() {
                    found.push(Candidate { slip, edits });
                }
            }
        }
        found
    }

    /// A candidate for each of the words with these addresses, and one that changes all of them.
    fn each_and_all(
        &self,
        addresses: &[u8],
        is_meant: impl Fn(&Own) -> bool,
        right: impl Fn(&Own) -> String,
        slip: impl Fn(String, String) -> Slip,
    ) -> Vec<Candidate> {
        let meant = self.0.iter().filter(|own| addresses.contains(&own.word.address) && is_meant(own));
        let meant: Vec<&Own> = meant.collect();
        let change = |words: &[&Own]| {
            let first = words.first()?;
            let edit = |own: &&Own| Edit { span: own.word.span, text: right(own) };
            let slip = slip(first.written.clone(), right(first));
            Some(Candidate { slip, edits: words.iter().map(edit).collect() })
        };
        let each = meant.iter().take(MOST_WORDS).filter_map(|own| change(&[own]));
        each.chain(change(&meant).filter(|_| meant.len() > 1)).collect()
    }

    fn other_sign(own: &Own) -> String {
        with_other_sign(&own.written)
    }

    /// The word with the diameter of the radius that is written; a number without a point stays one.
    fn doubled(own: &Own) -> String {
        let diameter = Diameter::from_radius(own.value).mm();
        let has_point = matches!(own.word.value, Value::Number { number, .. } if number.has_point());
        let letter = char::from(own.word.address);
        if has_point { with_point(letter, diameter) } else { format!("{letter}{}", number(diameter)) }
    }
}

impl Own {
    /// The slip and its edit, if the value is that of the cone of the drawing, which begins at `begin`.
    fn taper_from_drawing(&self, cone: [Point; 2], begin: Point) -> Option<(Slip, Edit)> {
        let cut = self.cut?;
        let [a, b] = cone;
        let is_facing = cut.cycle.is_some_and(|tag| cuts_along_x(tag.cycle));
        let (slope, axis, from, start, end) = match is_facing {
            true => ((b.z - a.z) / (b.x - a.x), 'X', begin.x, cut.from.x, cut.to.x),
            false => ((b.x - a.x) / (b.z - a.z), 'Z', begin.z, cut.from.z, cut.to.z),
        };
        let of_drawing = slope * (from - end);
        let is_that = (self.value - of_drawing).abs() <= SAME_R && of_drawing.abs() > SAME_R;
        if !is_that || (from - start).abs() <= SAME_R {
            return None;
        }
        let right = with_point(char::from(self.word.address), slope * (start - end));
        let shown = |place: f64| if is_facing { Diameter::from_radius(place).mm() } else { place };
        let (from, start) = (shown(from), shown(start));
        let edit = Edit { span: self.word.span, text: right.clone() };
        let right = right.trim_end_matches('.').to_owned();
        Some((Slip::TaperFromDrawing { written: self.written.clone(), right, axis, from, start }, edit))
    }
}

/// The first cut of each block, by the first byte of the block.
fn first_cuts(answer: &Answer) -> BTreeMap<u32, Motion> {
    let motions = &answer.analysis.motions;
    let mut cuts = BTreeMap::new();
    for index in (0..motions.len()).filter(|&index| motions.kind(index).cuts()) {
        let motion = motions.get_on_workpiece(index);
        if motion.cycle.is_none_or(|tag| tag.step == Step::Cut) {
            cuts.entry(motions.span(index).start).or_insert(motion);
        }
    }
    cuts
}

/// A word with a decimal point, which every control reads as millimetres.
fn with_point(letter: char, value: f64) -> String {
    let rounded = number((value * 1000.0).round() / 1000.0);
    let point = if rounded.contains('.') { "" } else { "." };
    format!("{letter}{rounded}{point}")
}

/// A fault that messages report and whose fixes, applied until none is left, give the target: the fixes of one rule, or
/// of all rules.
fn reported(exercise: &Exercise, answer: &Answer) -> Option<Cause> {
    let has_fix = |found: &&Diagnostic| found.fixes.iter().any(|fix| !fix.edits.is_empty());
    let found: Vec<&Diagnostic> = answer.analysis.diagnostics.iter().filter(has_fix).collect();
    let mut rules: Vec<Option<&str>> = Vec::new();
    for slug in found.iter().map(|found| Some(found.message.slug())).chain([None]) {
        if !rules.contains(&slug) && rules.len() < MOST_ROUNDS {
            rules.push(slug);
        }
    }
    let rule = rules.into_iter().find(|rule| is_repaired_by(*rule, exercise, answer))?;
    let own = || found.iter().filter(|found| is_of_rule(found, rule));
    let first = own().next()?;
    let slip = Slip::Reported(Box::new((*first).clone()));
    Some(Cause { slip, span: first.span, words: own().count() })
}

/// Whether a message is of a rule; `None` means all rules.
fn is_of_rule(found: &Diagnostic, rule: Option<&str>) -> bool {
    rule.is_none_or(|rule| found.message.slug() == rule)
}

/// Whether the fixes of a rule, or of all rules, give the target.
fn is_repaired_by(rule: Option<&str>, exercise: &Exercise, answer: &Answer) -> bool {
    let mut text = answer.text.clone();
    for _ in 0..MOST_ROUNDS {
        let run = Answer::without_findings(&text, &exercise.setup);
        if is_of(&run, &exercise.target) {
            return true;
        }
        let own = run.analysis.diagnostics.iter().filter(|found| is_of_rule(found, rule));
        let edits = own.filter_map(|found| found.fixes.first()).flat_map(|fix| fix.edits.clone());
        let edits = apart(edits.collect());
        if edits.is_empty() {
            return false;
        }
        text = applied(&text, &edits);
    }
    false
}

/// The edits in the order of the text, without those that touch an earlier one.
fn apart(mut edits: Vec<Edit>) -> Vec<Edit> {
    order::by_key(&mut edits, |edit| edit.span.start);
    let mut end = None;
    edits.retain(|edit| {
        let is_apart = end.is_none_or(|end| edit.span.start > end);
        if is_apart {
            end = Some(edit.span.end);
        }
        is_apart
    });
    edits
}
