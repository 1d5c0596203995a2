//! The signature of a cycle, a move or a call: its words in the usual order, optional words, and defaults.
//!
//! In: the form of a block. Out: one line for each block of the form; two for the current multiple cycles.
//! Tests check the table against the control by leaving out each word.

use super::Query;
use super::fact::Quantity;
use super::form::Form;
use super::hover::feed_of;
use super::role::{Role, axes, words_of};
use crate::control::codes::cycles::CycleBlock;
pub use crate::control::codes::words::WhenOmitted;
use crate::control::codes::words::{Axes, CodeWord};
use crate::control::codes::{self, G, MacroCall, MotionMode, Multiple};
use crate::control::modal::{State, Target};
use crate::control::words::Reading;
use crate::geometry::SAME;
use crate::setup::dialect::{Control, Dialect};
use crate::source::Span;
use crate::text::block::{Value, Word};
use crate::units::Diameter;

/// A word of a signature.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Slot {
    /// Its possible letters, such as X or U.
    pub letters: &'static [u8],
    /// Whether it follows a comma: `,C`.
    pub comma: bool,
    /// Meaning if it is omitted.
    pub otherwise: WhenOmitted,
}

impl Slot {
    fn takes(&self, word: &Word) -> bool {
        self.letters.contains(&word.address) && word.comma == self.comma
    }
}

/// One block of a signature.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// The code, as the control writes it.
    pub code: String,
    /// What the words of the block belong to.
    pub form: Form,
    /// Its words.
    pub slots: Vec<Slot>,
}

/// A slot, filled in for a given block.
#[derive(Clone, Debug, PartialEq)]
pub struct Place {
    /// The slot.
    pub slot: Slot,
    /// Role of the word.
    pub role: Role,
    /// The word in the block, if present.
    pub word: Option<Span>,
    /// The value in force, if the word is omitted and an earlier block set it.
    pub in_force: Option<Quantity>,
}

/// The signature of a given block.
#[derive(Clone, Debug, PartialEq)]
pub struct Signature {
    /// Each block of the form, with its words.
    pub lines: Vec<(Line, Vec<Place>)>,
    /// Index of the given block.
    pub own: usize,
}

/// The blocks of a form, in order; empty if the form has no words.
pub fn lines(form: Form, dialect: &Dialect, axes: Axes) -> Vec<Line> {
    let list = dialect.code_list();
    let line = |code: Option<String>, form: Form, words: &[CodeWord]| {
        let slots: Vec<_> = words.iter().filter_map(slot).collect();
        code.filter(|_| !slots.is_empty()).map(|code| Line { code, form, slots })
    };
    let code = |code: G| codes::written(code, list);
    let words = words_of(form, axes);
    let one = |code: Option<String>| line(code, form, words).into_iter().collect();
    match form {
        Form::Motion { mode: mode @ MotionMode::Cycle(cycle), .. } => {
            let spec = cycle.spec();
            let words = if dialect.control == Control::Gsk { spec.on_gsk } else { spec.words };
            line(code(G::Motion(mode)), form, words).into_iter().collect()
        }
        Form::Motion { mode, .. } => one(code(G::Motion(mode))),
        Form::Hole { hole, .. } => one(code(G::Hole(hole))),
        Form::Multiple(cycle, half) => {
            let blocks: &[CycleBlock] = match half {
                CycleBlock::Whole => &[CycleBlock::Whole],
                _ if cycle.spec().first.is_empty() => &[CycleBlock::Second],
                _ => &[CycleBlock::First, CycleBlock::Second],
            };
            let own = |block: &CycleBlock| {
                line(code(G::Multiple(cycle)), Form::Multiple(cycle, *block), cycle.spec().words(*block))
            };
            blocks.iter().filter_map(own).collect()
        }
        Form::OneShot(own) => one(code(own)),
        Form::MacroCall => one(code(G::MacroCall(MacroCall::Once))),
        Form::Call(call) => one(codes::written_m(call)),
        Form::Macro | Form::Nothing => Vec::new(),
    }
}

/// The slot of a word, if the signature shows it.
fn slot(word: &CodeWord) -> Option<Slot> {
    word.otherwise.map(|otherwise| Slot { letters: word.letters, comma: word.comma, otherwise })
}

impl Query<'_> {
    /// The signature of the block; `None` if its form has no words.
    pub fn signature(&self) -> Option<Signature> {
        let state = &*self.before();
        let form = Form::of(self.block, state, self.codes);
        let axes = axes(state, state.c_axis);
        let lines = lines(form, self.dialect, axes);
        let own = lines.iter().position(|line| line.form == form)?;
        // A block without a code has the form of a move only if it contains one of its words.
        if let Form::Motion { own: false, .. } | Form::Hole { own: false, .. } = form
            && !self.block.words.iter().any(|word| word.address != b'F' && takes(&lines[own], word))
        {
            return None;
        }
        let surface = state.spindle.surface;
        let reading = Reading { unit: state.unit, decimal: self.dialect.decimal };
        let (start, end) = (state.position, self.end(state, reading));
        // A step over is required only for more than one column of pecks.
        let steps_over = match form {
            Form::Multiple(Multiple::FacePecking, _) => (end.x - start.x).abs() > SAME,
            Form::Multiple(Multiple::Grooving, _) => (end.z - start.z).abs() > SAME,
            _ => false,
        };
        let places = |index: usize, line: &Line| -> Vec<Place> {
            line.slots
                .iter()
                .map(|slot| {
                    let found =
                        self.block.words.iter().find(|word| slot.takes(word)).filter(|_| index == own);
                    let letter = found.map_or(slot.letters[0], |word| word.address);
                    let role = Role::of(&sample(letter, slot.comma), line.form, surface, axes);
                    let mut slot = *slot;
                    if role == Role::StepOver && steps_over {
                        slot.otherwise = WhenOmitted::Missing;
                    }
                    // Passes without a code keep R; repeating the code resets it.
                    let keeps_taper = matches!(form, Form::Motion { own: false, .. })
                        && matches!(role, Role::TaperX | Role::TaperZ)
                        && state.memory.taper != 0.0;
                    if keeps_taper {
                        slot.otherwise = WhenOmitted::AsSet;
                    }
                    let in_force = match slot.otherwise {
                        WhenOmitted::AsSet if found.is_none() => in_force(role, state),
                        _ => None,
                    };
                    Place { slot, role, word: found.map(|word| word.span), in_force }
                })
                .collect()
        };
        let lines = lines.into_iter().enumerate().map(|(index, line)| {
            let places = places(index, &line);
            (line, places)
        });
        Some(Signature { lines: lines.collect(), own })
    }
}

/// Whether a line has a slot for a word.
fn takes(line: &Line, word: &Word) -> bool {
    line.slots.iter().any(|slot| slot.takes(word))
}

/// The role of a letter in a form.
pub fn role_of(letter: u8, form: Form, state: &State) -> Role {
    Role::of(&sample(letter, false), form, state.spindle.surface, axes(state, state.c_axis))
}

/// A word with a letter and no value.
fn sample(address: u8, comma: bool) -> Word {
    Word { address, comma, value: Value::Expression, span: Span::new(0, 0) }
}

/// The value in force for an omitted word.
fn in_force(role: Role, state: &State) -> Option<Quantity> {
    let (cycle, multiple) = (&state.memory, &state.parameters);
    let target = |target: Target, across: bool| match target {
        Target::Absolute(place) if across => Some(Quantity::Diameter(Diameter::from_radius(place))),
        Target::Absolute(place) => Some(Quantity::Length(place)),
        Target::Stay | Target::Incremental(_) => None,
    };
    match role {
        Role::Feed | Role::Lead => feed_of(state),
        Role::CycleEndX => target(cycle.x, true),
        Role::CycleEndZ => target(cycle.z, false),
        Role::TaperX | Role::TaperZ => Some(Quantity::Length(cycle.taper)),
        Role::PassDepth | Role::PassDepthZ => multiple.depth.map(Quantity::Length),
        Role::Escape => Some(Quantity::Length(multiple.escape)),
        Role::PeckRetract => Some(Quantity::Length(multiple.retract)),
        Role::ThreadAllowance => Some(Quantity::Length(multiple.thread_allowance)),
        _ => None,
    }
}
