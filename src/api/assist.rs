//! Rows for help at a place of the program: the word there, and the state of the control.
//!
//! In: results of `assist`, a language. Out: texts, with the UTF-16 offsets of the blocks that they refer to.

use serde::Serialize;
#[cfg(target_arch = "wasm32")]
use tsify::Tsify;

use super::Places;
use crate::assist::Query;
use crate::assist::complete::{Item, ProposalKind};
use crate::assist::fact::{Fact, Quantity};
use crate::assist::form::Form;
use crate::assist::hover::Hover;
use crate::assist::names::{Name, Named};
use crate::assist::outline::{Entry, Kind, outline};
use crate::assist::signature::{Place, WhenOmitted};
use crate::assist::snippet::Piece;
use crate::assist::state::{Frame, StateTable};
use crate::assist::uses::uses;
use crate::calculate::{Calculator, at_word};
use crate::control::codes::{self, G, MacroCall};
use crate::control::modal::State;
use crate::motion::Motions;
use crate::sentences::Language;
use crate::sentences::assist::{Speaker, block_of};
use crate::sentences::calculate;
use crate::setup::dialect::CodeList;
use crate::source::Span;
use crate::text::program_name::is_name;
use crate::units::Unit;

/// Help for the word at a place.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct WordHelp {
    /// UTF-16 offset of the word.
    pub from: u32,
    /// UTF-16 offset of its end.
    pub to: u32,
    /// The word, without blanks.
    pub word: String,
    /// The meaning of the word.
    pub title: String,
    /// The value with its unit.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub value: Option<String>,
    /// More facts, the most important first.
    pub facts: Vec<HelpLine>,
    /// Blocks that the word refers to: pairs of UTF-16 offsets.
    pub marks: Vec<(u32, u32)>,
    /// The calculators that fit the word.
    pub calculators: Vec<CalculatorName>,
}

/// The name of a calculator.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct CalculatorName {
    /// Its name.
    pub name: &'static str,
    /// Its title.
    pub title: &'static str,
}

/// A sentence, and the block that it refers to.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct HelpLine {
    /// The sentence.
    pub text: String,
    /// UTF-16 offset of the block.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub at: Option<u32>,
}

/// The state of the control before and after a block.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct StateHelp {
    /// Line of the block, from 1.
    pub line: u32,
    /// Which visit to the block this is, from 1: an execution, or a reading by a contour cycle. 0 if the
    /// block is never visited; all lists are then empty.
    pub number: u32,
    /// Number of visits to the block.
    pub times: u32,
    /// UTF-16 offset of the block.
    pub block: u32,
    /// The number of this execution, from 1, for trying a value there. 0 if a cycle only reads the block.
    pub execution: u32,
    /// What the block does, in sentences with calculated numbers; may be empty.
    pub explanation: String,
    /// Says that a cycle reads the block as a part of its contour.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub purpose: Option<&'static str>,
    /// Position of the tip: a row for each axis.
    pub axes: Vec<StateRow>,
    /// Spindle speed and cutting speed after the block, if they are known.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub speeds: Option<String>,
    /// The modal state.
    pub rows: Vec<StateRow>,
    /// The variables that have a value; those that the block changes are first.
    pub variables: Vec<StateRow>,
    /// Number of variables that are not listed.
    pub hidden: u32,
    /// Active calls and loops, the outermost first.
    pub frames: Vec<HelpLine>,
}

/// The form of the requested block: a cycle, a move or a call.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct FormHelp {
    /// The blocks: two for a multiple repetitive cycle in two-block format.
    pub lines: Vec<FormLine>,
}

/// A block of a form.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
#[serde(rename_all = "camelCase")]
pub struct FormLine {
    /// The code, as the control writes it.
    pub code: String,
    /// The code in G-code system A, under which the manual has it; empty if that system lacks it.
    pub in_manual: String,
    /// Whether it is the requested block.
    pub own: bool,
    /// Its words, in the usual order.
    pub words: Vec<FormWord>,
}

/// A slot for a word.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct FormWord {
    /// The possible letters: `X`, or `X/U`.
    pub letters: String,
    /// The meaning of the word.
    pub title: &'static str,
    /// Whether the word can be omitted.
    pub optional: bool,
    /// Whether the requested block contains the word, lacks it although it is required, or omits it.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "\"there\" | \"missing\" | \"left-out\""))]
    pub state: &'static str,
    /// What applies if the word is omitted.
    pub otherwise: String,
    /// Whether it is the requested word.
    pub marked: bool,
}

/// The completions at a place.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct CompletionHelp {
    /// UTF-16 offset of the start of the text to replace.
    pub from: u32,
    /// UTF-16 offset of its end.
    pub to: u32,
    /// The completions, the most likely first.
    pub items: Vec<CompletionItem>,
}

/// A completion.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct CompletionItem {
    /// The first line of its text.
    pub label: String,
    /// The text to insert.
    pub text: String,
    /// Fields to fill in, in order: pairs of offsets in `text`.
    pub fills: Vec<(u32, u32)>,
    /// A description.
    pub detail: String,
    /// The kind of completion.
    #[cfg_attr(
        target_arch = "wasm32",
        tsify(type = "\"code\" | \"word\" | \"place\" | \"variable\" | \"snippet\"")
    )]
    pub kind: &'static str,
}

/// All uses of the number at a place: a sequence number, a program number or a variable.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct UsesHelp {
    /// The number, as written: `N10`, `O1000`, `#100`.
    pub name: String,
    /// The uses, in text order.
    pub places: Vec<Use>,
    /// Index of the use to go to next.
    pub next: u32,
    /// Whether there are more.
    pub cut: bool,
}

/// A place where a number is used.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct Use {
    /// UTF-16 offset of the word.
    pub from: u32,
    /// UTF-16 offset of its end.
    pub to: u32,
    /// Line, from 1.
    pub line: u32,
    /// The block, shortened if it is long.
    pub text: String,
    /// Whether this is the definition: the numbered block, or an assignment to the variable.
    pub defines: bool,
}

/// The outline of a text, and its foldable ranges.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct OutlineHelp {
    /// The entries, in text order.
    pub entries: Vec<OutlineEntry>,
    /// Foldable ranges, as pairs of UTF-16 offsets: from the end of a block to the end of the last block that
    /// belongs to it.
    pub folds: Vec<(u32, u32)>,
    /// Whether the text continues after the last entry.
    pub cut: bool,
}

/// An entry of the outline.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct OutlineEntry {
    /// The kind of entry.
    #[cfg_attr(
        target_arch = "wasm32",
        tsify(type = "\"program\" | \"tool\" | \"operation\" | \"block\" | \"cycle\"")
    )]
    pub kind: &'static str,
    /// Depth in the outline: the number of entries above it.
    pub depth: u8,
    /// UTF-16 offset of its block.
    pub from: u32,
    /// Line, from 1.
    pub line: u32,
    /// Its name in the text.
    pub name: String,
    /// A description; may be empty.
    pub detail: String,
}

/// A value of the state before and after a block.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct StateRow {
    /// Name of the value.
    pub name: String,
    /// Before the block.
    pub before: String,
    /// After it.
    pub after: String,
    /// Whether the block changes it.
    pub changed: bool,
    /// Line of the block that set it, from 1; omitted if it still has its initial value.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub line: Option<u32>,
    /// UTF-16 offset of that block.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub at: Option<u32>,
    /// Number of the variable, if it is one.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub variable: Option<u32>,
}

/// The text, the language and the unit of the rows.
#[derive(Clone, Copy)]
pub struct Reader<'a> {
    /// The text.
    pub places: Places<'a>,
    /// The language of the sentences.
    pub language: Language,
    /// The unit of lengths.
    pub unit: Unit,
}

impl Reader<'_> {
    /// Help for the word at a byte.
    pub fn word(&self, asked: &Query, byte: u32, notes: &[Span], motions: &Motions) -> Option<WordHelp> {
        let hover = asked.hover(byte, notes, motions)?;
        let (from, to) = self.places.offsets(hover.span);
        let quoted = hover.span.quote(self.places.text);
        let word = quoted.split_whitespace().collect::<Vec<_>>().join(" ");
        let block = hover
            .block
            .iter()
            .map(|block| HelpLine { text: self.speak(|speaker| speaker.explanation(block)), at: None });
        let facts: Vec<_> = block.chain(hover.facts.iter().map(|fact| self.line(fact))).collect();
        let marks = hover.facts.iter().filter_map(|fact| match fact {
            Fact::Contour(first, last) => Some(self.places.offsets(first.to(*last))),
            _ => None,
        });
        let value = hover.quantity.map(|quantity| self.speak(|speaker| speaker.quantity(quantity)));
        let value = value.filter(|value| *value != word);
        let names = at_word::calculators(asked, byte, motions).iter().copied();
        let calculators = names
            .filter_map(Calculator::find)
            .map(|own| CalculatorName { name: own.name, title: calculate::title(own, self.language) });
        let (marks, calculators) = (marks.collect(), calculators.collect());
        Some(WordHelp { from, to, word, title: self.title(&hover), value, facts, marks, calculators })
    }

    /// The form of the block, with the word at a byte marked; `None` if the block has no form.
    pub fn form(&self, asked: &Query, byte: u32) -> Option<FormHelp> {
        let signature = asked.signature()?;
        let own = signature.own;
        let lines = signature.lines.iter().enumerate().map(|(index, (line, places))| FormLine {
            code: line.code.clone(),
            in_manual: name_in_manual(line.form),
            own: index == own,
            words: places.iter().map(|place| self.form_word(place, index == own, byte)).collect(),
        });
        Some(FormHelp { lines: lines.collect() })
    }

    fn form_word(&self, place: &Place, own: bool, byte: u32) -> FormWord {
        let letters: Vec<String> = place
            .slot
            .letters
            .iter()
            .map(|&letter| format!("{}{}", if place.slot.comma { "," } else { "" }, letter as char))
            .collect();
        let optional = place.slot.otherwise != WhenOmitted::Missing;
        FormWord {
            letters: letters.join("/"),
            title: place.role.words(self.language),
            optional,
            state: match place.word {
                Some(_) => "there",
                None if own && !optional => "missing",
                None => "left-out",
            },
            otherwise: self.speak(|speaker| speaker.otherwise(place.slot.otherwise, place.in_force)),
            marked: place.word.is_some_and(|word| word.start <= byte && byte <= word.end),
        }
    }

    /// The completions at a byte. `end`: the state after the run. `is_explicit`: whether the user requested
    /// them explicitly.
    pub fn completion(
        &self,
        asked: &Query,
        byte: u32,
        end: &State,
        is_explicit: bool,
    ) -> Option<CompletionHelp> {
        let completion = asked.complete(byte, end, is_explicit)?;
        let (from, to) = self.places.offsets(completion.span);
        let typed = completion.span.quote(self.places.text).to_lowercase();
        let by_name = completion.by_name.iter().filter(|item| !completion.items.contains(item));
        let by_name = by_name.map(|item| self.proposal(item));
        let by_name = by_name.filter(|proposal| proposal.detail.to_lowercase().contains(&typed));
        let items: Vec<_> = completion.items.iter().map(|item| self.proposal(item)).chain(by_name).collect();
        (!items.is_empty()).then_some(CompletionHelp { from, to, items })
    }

    /// The uses of the number at a byte; `None` if there is no number.
    pub fn uses(&self, codes: CodeList, byte: u32) -> Option<UsesHelp> {
        let text = self.places.text;
        let found = uses(text, codes, byte)?;
        let place = |named: &Named| {
            let (from, to) = self.places.offsets(named.span);
            let line = self.line_of(named.span.start);
            let block = self.places.lines.line(text, line - 1);
            Use { from, to, line, text: shortened(&block.quote(text)), defines: named.defines }
        };
        let name = match found.name {
            Name::Sequence(number) => format!("N{number}"),
            Name::Program(number) if is_name(number) => {
                found.places.first().map_or_else(String::new, |named| named.span.quote(text))
            }
            Name::Program(number) => format!("O{number:04}"),
            Name::Variable(number) => format!("#{number}"),
        };
        let places = found.places.iter().map(place).collect();
        Some(UsesHelp { name, places, next: found.next as u32, cut: found.is_cut })
    }

    /// The outline of the text.
    pub fn outline(&self, codes: CodeList) -> OutlineHelp {
        let text = self.places.text;
        let found = outline(text, codes);
        let comment = |span: Span| {
            shortened(span.quote(text).trim_matches(|c: char| matches!(c, '(' | ')' | ';' | ' ')))
        };
        let entry = |own: &Entry| {
            let said = own.comment.map_or_else(String::new, comment);
            let (kind, name, detail) = match own.kind {
                Kind::Program => ("program", own.name.quote(text), said),
                Kind::Tool => ("tool", own.name.quote(text), said),
                Kind::Operation => ("operation", comment(own.name), said),
                Kind::Sequence => ("block", shortened(&own.name.quote(text)), said),
                Kind::Cycle(function) => {
                    ("cycle", shortened(&own.name.quote(text)), function.describe(self.language).to_owned())
                }
            };
            let (from, line) = (self.offset(own.at), self.line_of(own.at));
            OutlineEntry { kind, depth: own.depth, from, line, name, detail }
        };
        OutlineHelp {
            entries: found.entries.iter().map(entry).collect(),
            folds: found.folds.iter().map(|fold| self.places.offsets(*fold)).collect(),
            cut: found.is_cut,
        }
    }

    fn proposal(&self, item: &Item) -> CompletionItem {
        let (mut text, mut fills) = (String::new(), Vec::new());
        for piece in &item.pieces {
            // Completions are ASCII, so bytes are UTF-16 units.
            let from = text.len() as u32;
            match piece {
                Piece::Fixed(fixed) => text.push_str(fixed),
                Piece::Fill(filled) => {
                    text.push_str(filled);
                    fills.push((from, text.len() as u32));
                }
            }
        }
        let label = match text.split_once('\n') {
            Some((first, _)) => format!("{first} …"),
            None => text.clone(),
        };
        let kind = match item.kind {
            ProposalKind::Code(..) => "code",
            ProposalKind::Word(..) => "word",
            ProposalKind::Sequence(_) | ProposalKind::NextSequence | ProposalKind::Program(_) => "place",
            ProposalKind::Variable(_) => "variable",
            ProposalKind::Snippet(_) => "snippet",
        };
        CompletionItem {
            label,
            text,
            fills,
            detail: self.speak(|speaker| speaker.proposed(&item.kind)),
            kind,
        }
    }

    /// The state at the block.
    pub fn state(&self, asked: &Query, motions: &Motions) -> StateHelp {
        let line = self.line_of(asked.block.span.start);
        let block = self.offset(asked.block.span.start);
        let Some(table) = asked.state() else {
            return StateHelp { line, block, ..StateHelp::default() };
        };
        let explanation = asked.explanation(motions);
        self.speak(|speaker| {
            let mut help = self.rows(block, line, &table, speaker);
            help.explanation = match speaker.explanation(&explanation) {
                moves if !moves.is_empty() || table.purpose.is_some() => moves,
                _ => sets(&help, speaker),
            };
            help
        })
    }

    /// A description of the motions of the block, in sentences; empty if it makes none.
    pub fn explanation(&self, asked: &Query, motions: &Motions) -> String {
        self.speak(|speaker| speaker.explanation(&asked.explanation(motions)))
    }

    fn rows(&self, block: u32, line: u32, table: &StateTable, speaker: &Speaker) -> StateHelp {
        let row = |name: String, before: String, after: String, since: Option<u32>| {
            let changed = before != after;
            let at = since.map(|byte| self.offset(byte));
            StateRow {
                name,
                before,
                after,
                changed,
                line: since.map(|byte| self.line_of(byte)),
                at,
                variable: None,
            }
        };
        let axis = |own: &crate::assist::state::AxisRow| {
            row(own.axis.to_string(), speaker.quantity(own.before), speaker.quantity(own.after), None)
        };
        let modal = |own: &crate::assist::state::Row| {
            let name = own.modal.name(self.language).to_owned();
            row(name, speaker.in_force(&own.before), speaker.in_force(&own.after), own.since)
        };
        let variable = |own: &crate::assist::state::VariableRow| {
            let name = format!("#{}", own.number);
            let own_row = row(name, speaker.variable(own.before), speaker.variable(own.after), own.since);
            StateRow { variable: Some(own.number), ..own_row }
        };
        let frame = |own: &Frame| {
            let (Frame::Call { head, .. } | Frame::Loop { head, .. }) = *own;
            HelpLine { text: speaker.frame(own), at: Some(self.offset(head)) }
        };
        StateHelp {
            line,
            number: table.number,
            times: table.times,
            block,
            execution: table.carried_out,
            explanation: String::new(),
            purpose: table.purpose.map(|purpose| speaker.purpose(purpose)),
            axes: table.axes.iter().map(axis).collect(),
            speeds: table.speeds.map(|(speed, cutting)| {
                format!("{}, {}", speaker.quantity(speed), speaker.quantity(cutting))
            }),
            rows: table.rows.iter().map(modal).collect(),
            variables: table.variables.iter().map(variable).collect(),
            hidden: u32::try_from(table.variables_hidden).unwrap_or(u32::MAX),
            frames: table.frames.iter().map(frame).collect(),
        }
    }

    fn title(&self, hover: &Hover) -> String {
        let role = hover.role.map(|role| role.words(self.language));
        let words = role.or(hover.function.map(|function| function.describe(self.language)));
        words.unwrap_or_default().to_owned()
    }

    fn line(&self, fact: &Fact) -> HelpLine {
        let at = block_of(fact).map(|byte| self.offset(byte));
        HelpLine { text: self.speak(|speaker| speaker.fact(fact)), at }
    }

    /// A number with its unit.
    pub fn quantity(&self, quantity: Quantity) -> String {
        self.speak(|speaker| speaker.quantity(quantity))
    }

    fn speak<R>(&self, say: impl FnOnce(&Speaker) -> R) -> R {
        let line_of = |byte: u32| self.line_of(byte);
        say(&Speaker { language: self.language, unit: self.unit, line_of: &line_of })
    }

    fn line_of(&self, byte: u32) -> u32 {
        self.places.lines.line_of(byte) + 1
    }

    fn offset(&self, byte: u32) -> u32 {
        self.places.lines.utf16_offset(self.places.text, byte)
    }
}

/// A text on one line, shortened if it is long.
fn shortened(text: &str) -> String {
    const MAX_CHARACTERS: usize = 60;
    let words = text.split_whitespace().collect::<Vec<_>>().join(" ");
    match words.char_indices().nth(MAX_CHARACTERS) {
        Some((end, _)) => format!("{}…", &words[..end]),
        None => words,
    }
}

/// Describes the settings made by a block without motions.
fn sets(help: &StateHelp, speaker: &Speaker) -> String {
    let changed = |row: &&StateRow| row.changed;
    let rows = help.rows.iter().filter(changed).map(|row| speaker.named(&row.name, &row.after));
    let variables = help.variables.iter().filter(changed).map(|row| format!("{} = {}", row.name, row.after));
    let list: Vec<String> = rows.chain(variables).collect();
    if list.is_empty() { String::new() } else { speaker.sets(&list) }
}

/// The code of a form in G-code system A.
fn name_in_manual(form: Form) -> String {
    let code = match form {
        Form::Motion { mode, .. } => G::Motion(mode),
        Form::Hole { hole, .. } => G::Hole(hole),
        Form::Multiple(cycle, _) => G::Multiple(cycle),
        Form::OneShot(code) => code,
        Form::MacroCall => G::MacroCall(MacroCall::Once),
        Form::Call(call) => return codes::written_m(call).unwrap_or_default(),
        Form::Macro | Form::Nothing => return String::new(),
    };
    codes::written(code, CodeList::A).unwrap_or_default()
}
