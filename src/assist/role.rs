//! The role of a word in its block: the first depth of cut, a coordinate of the end point, an argument.
//!
//! In: a word and the form of its block. Out: its [`Role`]. The build fails if a role lacks a text in one of
//! the languages (`sentences::assist`).

use super::form::Form;
pub use crate::control::codes::role::Role;
use crate::control::codes::words::{self, Axes, CodeWord, role_in};
use crate::control::modal::State;
use crate::text::block::Word;

/// The axes and the plane of a move in a state. `c_axis`: C is an axis word.
pub fn axes(state: &State, c_axis: bool) -> Axes {
    Axes { surface: state.interpolation().map(|plane| plane.surface), plane: state.plane, c_axis }
}

impl Role {
    /// The role of a word other than G, M, N and O in a block of a form. `surface`: S is a cutting speed.
    pub fn of(word: &Word, form: Form, surface: bool, axes: Axes) -> Self {
        let letter = word.address;
        if form == Form::MacroCall && !matches!(letter, b'P' | b'L') {
            return Self::Argument;
        }
        if word.comma {
            return role_in(words::AFTER_COMMA, letter, true);
        }
        let role = role_in(words_of(form, axes), letter, false);
        match (role, letter) {
            (Self::Ignored, b'T') => Self::ToolAndOffset,
            (Self::Ignored | Self::SpindleSpeed, b'S') if surface => Self::CuttingSpeed,
            (Self::Ignored, b'S') => Self::SpindleSpeed,
            _ => role,
        }
    }
}

/// The words of a form.
pub fn words_of(form: Form, axes: Axes) -> &'static [CodeWord] {
    match form {
        Form::Motion { mode, .. } => words::of_motion(mode, axes),
        Form::Hole { hole, .. } => words::of_hole(hole),
        Form::Multiple(cycle, block) => cycle.spec().words(block),
        Form::OneShot(code) => words::of_one_shot(code),
        Form::MacroCall => words::MACRO_CALL,
        Form::Call(call) => words::of_call(call),
        Form::Macro | Form::Nothing => &[],
    }
}
