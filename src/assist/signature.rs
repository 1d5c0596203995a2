//! The signature of a cycle, a move or a call: its words in the usual order, optional words, and defaults.
//!
//! In: the form of a block. Out: one line for each block of the form; two for the current multiple cycles.
//! Tests check the table against the control by leaving out each word.

use super::Query;
use super::fact::Quantity;
use super::form::Form;
use super::hover::feed_of;
use super::role::Role;
pub use crate::control::codes::cycles::WhenOmitted;
use crate::control::codes::cycles::{CycleBlock, CycleWord};
use crate::control::codes::{self, G, Hole, M, MacroCall, MotionMode, Multiple, Plane};
use crate::control::modal::{State, Target};
use crate::control::words::Reading;
use crate::geometry::SAME;
use crate::geometry::virtual_plane::Surface;
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

const fn must(letters: &'static [u8]) -> Slot {
    Slot { letters, comma: false, otherwise: WhenOmitted::Missing }
}

const fn stays(letters: &'static [u8]) -> Slot {
    Slot { letters, comma: false, otherwise: WhenOmitted::Stays }
}

const fn zero(letters: &'static [u8]) -> Slot {
    Slot { letters, comma: false, otherwise: WhenOmitted::Zero }
}

const fn as_set(letters: &'static [u8]) -> Slot {
    Slot { letters, comma: false, otherwise: WhenOmitted::AsSet }
}

const fn may(letters: &'static [u8]) -> Slot {
    Slot { letters, comma: false, otherwise: WhenOmitted::Nothing }
}

const fn corner(letters: &'static [u8]) -> Slot {
    Slot { letters, comma: true, otherwise: WhenOmitted::Nothing }
}

const RAPID: &[Slot] = &[stays(b"XU"), stays(b"ZW")];
const LINE: &[Slot] = &[stays(b"XU"), stays(b"ZW"), as_set(b"F"), corner(b"C"), corner(b"R"), corner(b"A")];
const RAPID_AND_C: &[Slot] = &[stays(b"XU"), stays(b"ZW"), stays(b"CH")];
const LINE_AND_C: &[Slot] =
    &[stays(b"XU"), stays(b"ZW"), stays(b"CH"), as_set(b"F"), corner(b"C"), corner(b"R"), corner(b"A")];
const FACE_LINE: &[Slot] = &[stays(b"XU"), stays(b"CH"), as_set(b"F")];
const SIDE_LINE: &[Slot] = &[stays(b"ZW"), stays(b"CH"), as_set(b"F")];
const SIDE_ARC: &[Slot] = &[stays(b"ZW"), stays(b"CH"), must(b"R"), as_set(b"F")];
const ARC: &[Slot] = &[stays(b"XU"), stays(b"ZW"), must(b"RIK"), as_set(b"F")];
const FACE_ARC: &[Slot] = &[stays(b"XU"), stays(b"CH"), must(b"RIJ"), as_set(b"F")];
const XY_ARC: &[Slot] = &[stays(b"XU"), stays(b"YV"), must(b"RIJ"), as_set(b"F")];
const YZ_ARC: &[Slot] = &[stays(b"YV"), stays(b"ZW"), must(b"RJK"), as_set(b"F")];
const THREAD: &[Slot] = &[stays(b"XU"), stays(b"ZW"), as_set(b"F"), zero(b"Q")];
const VARIABLE_THREAD: &[Slot] = &[stays(b"XU"), stays(b"ZW"), as_set(b"F"), must(b"K")];
const FACE_HOLE: &[Slot] =
    &[stays(b"XU"), may(b"CH"), must(b"ZW"), zero(b"R"), may(b"Q"), zero(b"P"), as_set(b"F"), may(b"K")];
const SIDE_HOLE: &[Slot] =
    &[must(b"XU"), may(b"CH"), stays(b"ZW"), zero(b"R"), may(b"Q"), zero(b"P"), as_set(b"F"), may(b"K")];
const DWELL: &[Slot] = &[must(b"XUP")];
const HOME: &[Slot] = &[stays(b"XU"), stays(b"ZW")];
const OTHER_HOME: &[Slot] = &[may(b"P"), stays(b"XU"), stays(b"ZW")];
const MACHINE: &[Slot] = &[stays(b"X"), stays(b"Z")];
const SETTING: &[Slot] = &[may(b"XU"), may(b"ZW"), may(b"S"), may(b"Q")];
const LOCAL_FRAME: &[Slot] = &[stays(b"X"), stays(b"Z")];
const CALL: &[Slot] = &[must(b"P"), may(b"L")];
const MACRO_CALL: &[Slot] = &[must(b"P"), may(b"L"), may(b"ABC")];
const RETURN: &[Slot] = &[may(b"P")];

/// The blocks of a form, in order; empty if the form has no words.
pub fn lines(form: Form, dialect: &Dialect) -> Vec<Line> {
    let list = dialect.code_list();
    let line = |code: G, form: Form, slots: Vec<Slot>| {
        codes::written(code, list).map(|code| Line { code, form, slots })
    };
    let one = |code: G, slots: &[Slot]| line(code, form, slots.to_vec()).into_iter().collect();
    match form {
        Form::Motion { mode: mode @ MotionMode::Cycle(cycle), .. } => {
            let spec = cycle.spec();
            let words = if dialect.control == Control::Gsk { spec.on_gsk } else { spec.words };
            line(G::Motion(mode), form, words.iter().filter_map(slot).collect()).into_iter().collect()
        }
        Form::Motion { mode, .. } => one(
            G::Motion(mode),
            match mode {
                MotionMode::Line => LINE,
                MotionMode::Arc(_) => ARC,
                MotionMode::Thread | MotionMode::Tapping => THREAD,
                MotionMode::VariableThread => VARIABLE_THREAD,
                MotionMode::Rapid | MotionMode::Cycle(_) => RAPID,
            },
        ),
        Form::Hole { hole, .. } => one(G::Hole(hole), of_hole(hole)),
        Form::Multiple(cycle, half) => {
            let blocks: &[CycleBlock] = match half {
                CycleBlock::Whole => &[CycleBlock::Whole],
                _ if cycle.spec().first.is_empty() => &[CycleBlock::Second],
                _ => &[CycleBlock::First, CycleBlock::Second],
            };
            let own = |block: &CycleBlock| {
                let slots = cycle.spec().words(*block).iter().filter_map(slot).collect();
                line(G::Multiple(cycle), Form::Multiple(cycle, *block), slots)
            };
            blocks.iter().filter_map(own).collect()
        }
        Form::OneShot(code) => match code {
            G::Dwell => one(code, DWELL),
            G::Home | G::FromHome | G::CheckHome => one(code, HOME),
            G::OtherHome => one(code, OTHER_HOME),
            G::Machine => one(code, MACHINE),
            G::Setting => one(code, SETTING),
            G::LocalFrame => one(code, LOCAL_FRAME),
            _ => Vec::new(),
        },
        Form::MacroCall => one(G::MacroCall(MacroCall::Once), MACRO_CALL),
        Form::Call(call) => {
            let (code, slots) = match call {
                M::LocalCall => ("M97", CALL),
                M::Return => ("M99", RETURN),
                _ => ("M98", CALL),
            };
            vec![Line { code: code.to_owned(), form, slots: slots.to_vec() }]
        }
        Form::Macro | Form::Nothing => Vec::new(),
    }
}

/// The slot of a word of a cycle, if the signature shows it.
fn slot(word: &CycleWord) -> Option<Slot> {
    word.otherwise.map(|otherwise| Slot { letters: word.letters, comma: false, otherwise })
}

fn of_hole(hole: Hole) -> &'static [Slot] {
    if hole.is_face() { FACE_HOLE } else { SIDE_HOLE }
}

impl Query<'_> {
    /// The signature of the block; `None` if its form has no words.
    pub fn signature(&self) -> Option<Signature> {
        let state = &*self.before();
        let form = Form::of(self.block, state, self.codes);
        let mut lines = lines(form, self.dialect);
        let other_axes = other_axes(form, state);
        if let Some((line, slots)) = lines.first_mut().zip(other_axes) {
            line.slots = slots.to_vec();
        }
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
                    let role = Role::of(&sample(letter, slot.comma), line.form, surface, state.c_axis);
                    let role = if other_axes.is_some() { role.in_plane_of(letter, state) } else { role };
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

/// The words of a move with other axes than X and Z.
fn other_axes(form: Form, state: &State) -> Option<&'static [Slot]> {
    let Form::Motion { mode, .. } = form else { return None };
    let surface = state.interpolation().map(|plane| plane.surface);
    match (mode, surface, state.plane) {
        (MotionMode::Arc(_), Some(Surface::Face), _) => Some(FACE_ARC),
        (MotionMode::Arc(_), Some(_), _) => Some(SIDE_ARC),
        (MotionMode::Arc(_), None, Plane::Xy) => Some(XY_ARC),
        (MotionMode::Arc(_), None, Plane::Yz) => Some(YZ_ARC),
        (MotionMode::Line, Some(Surface::Face), _) => Some(FACE_LINE),
        (MotionMode::Line, Some(_), _) => Some(SIDE_LINE),
        (MotionMode::Line, None, _) if state.c_axis => Some(LINE_AND_C),
        (MotionMode::Rapid, None, _) if state.c_axis => Some(RAPID_AND_C),
        _ => None,
    }
}

/// Whether a line has a slot for a word.
fn takes(line: &Line, word: &Word) -> bool {
    line.slots.iter().any(|slot| slot.takes(word))
}

/// The role of a letter in a form.
pub fn role_of(letter: u8, form: Form, state: &State) -> Role {
    Role::of(&sample(letter, false), form, state.spindle.surface, state.c_axis)
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
