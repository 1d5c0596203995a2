//! Proposes words for a block, and values for them: from the blank, the tool and the text.

use super::{Item, ProposalKind, Proposer, ValueSource, fixed};
use crate::assist::form::{Form, letters_without_comma};
use crate::assist::role::{Role, axes};
use crate::assist::signature::{WhenOmitted, lines, role_of};
use crate::assist::snippet::{Piece, written};
use crate::control::words::{Reading, letters};
use crate::order;
use crate::units::Diameter;

#[derive(Clone, Copy)]
enum Axis {
    X,
    Z,
}

/// The axis of a coordinate word, and whether the word is incremental; `None` for other words.
fn axis_of(role: Role) -> Option<(Axis, bool)> {
    Some(match role {
        Role::EndX | Role::CycleEndX | Role::PeckEndX | Role::HoleEndX | Role::HolePlaceX => (Axis::X, false),
        Role::EndZ
        | Role::CycleEndZ
        | Role::PeckEndZ
        | Role::ThreadEndZ
        | Role::HoleEndZ
        | Role::HolePlaceZ => (Axis::Z, false),
        Role::WayX | Role::CycleWayX | Role::PeckWayX => (Axis::X, true),
        Role::WayZ | Role::CycleWayZ | Role::PeckWayZ | Role::ThreadWayZ => (Axis::Z, true),
        _ => return None,
    })
}

impl Proposer<'_> {
    fn form(&self) -> Form {
        match self.is_same_line {
            true => Form::of(self.query.block, self.state, self.query.codes),
            false => Form::Nothing,
        }
    }

    /// Proposals for a word whose letter was typed: possible values.
    pub fn word(&self, letter: u8) -> Vec<Item> {
        let form = match self.form() {
            // A line without a code continues the modal motion.
            Form::Nothing => Form::Motion { mode: self.state.motion, own: false },
            // The word without its value is not in the block yet, and may decide which block of the cycle it is.
            Form::Multiple(cycle, _) => {
                let given = letters_without_comma(self.query.block) | letters(&[letter]);
                Form::Multiple(cycle, cycle.spec().block(given))
            }
            form => form,
        };
        let role = role_of(letter, form, self.state);
        let value = |value: String, why: ValueSource| {
            fixed(format!("{}{value}", letter as char), ProposalKind::Word(role, Some(why)))
        };
        match role {
            Role::ContourFirst | Role::ContourLast | Role::CalledSequence | Role::ReturnsTo => {
                return self.sequences("P").into_iter().map(|item| with_letter(item, letter)).collect();
            }
            Role::CalledProgram => return self.programs(),
            Role::Ignored => return Vec::new(),
            _ => {}
        }
        let mut items: Vec<Item> = self.places(role).into_iter().map(|(at, why)| value(at, why)).collect();
        // The most recent value first.
        let used = self.around.rates.iter().rev().filter(|(of, _)| *of == letter);
        items.extend(used.map(|(_, used)| value(used.clone(), ValueSource::Used)));
        items.dedup_by(|one, other| one.pieces == other.pieces);
        items
    }

    /// Possible values of a coordinate, formatted, with their sources.
    fn places(&self, role: Role) -> Vec<(String, ValueSource)> {
        let Some((axis, is_way)) = axis_of(role) else { return Vec::new() };
        let reading = Reading { unit: self.state.unit, decimal: self.query.dialect.decimal };
        let stock = self.query.setup.extents();
        let targets: Vec<(f64, ValueSource)> = match axis {
            Axis::X => {
                let outside = stock.map(|stock| (stock.diameter.mm(), ValueSource::Outside));
                let bore =
                    stock.map(|stock| (stock.bore.mm(), ValueSource::Bore)).filter(|&(bore, _)| bore > 0.0);
                let fixed = [(self.here(axis), ValueSource::ToolPosition), (0.0, ValueSource::Axis)];
                outside.into_iter().chain(bore).chain(fixed).collect()
            }
            Axis::Z => {
                let face = (stock.map_or(0.0, |stock| stock.face), ValueSource::Face);
                let back = stock.map(|stock| (stock.back(), ValueSource::Back));
                [face, (self.here(axis), ValueSource::ToolPosition)].into_iter().chain(back).collect()
            }
        };
        let mut found: Vec<(String, ValueSource)> = Vec::new();
        for (at, why) in targets {
            let text = written(if is_way { at - self.here(axis) } else { at }, reading);
            let is_double = found.iter().any(|(other, _)| *other == text);
            // An incremental move to the current position would be zero.
            let is_nowhere = is_way && why == ValueSource::ToolPosition;
            if !is_double && !is_nowhere {
                found.push((text, why));
            }
        }
        found
    }

    /// The current position as programs write it: a diameter for X, Z in mm.
    fn here(&self, axis: Axis) -> f64 {
        match axis {
            Axis::X => Diameter::from_radius(self.state.position.x).mm(),
            Axis::Z => self.state.position.z,
        }
    }

    /// Proposals if no word was begun: the missing words of the form, or whatever can begin a block.
    pub fn anything(&self, is_explicit: bool) -> Vec<Item> {
        let form = self.form();
        let missing = self.missing(form, is_explicit);
        if !missing.is_empty() || !is_explicit {
            return missing;
        }
        if self.is_same_line && self.query.block.words.iter().any(|word| word.span.end <= self.span.start) {
            return Vec::new();
        }
        let mut items = self.snippets();
        items.extend(self.g_codes("G").into_iter().take(12));
        items
    }

    /// Words of the form that the block lacks; optional words only if the user requested completion.
    fn missing(&self, form: Form, is_explicit: bool) -> Vec<Item> {
        if !self.is_same_line || matches!(form, Form::Motion { own: false, .. } | Form::Macro | Form::Nothing)
        {
            return Vec::new();
        }
        let lines = lines(form, self.query.dialect, axes(self.state, self.state.c_axis));
        let Some(line) = lines.iter().find(|line| line.form == form) else { return Vec::new() };
        let stands = |letters: &[u8], comma: bool| {
            let words = &self.query.block.words;
            words.iter().any(|word| letters.contains(&word.address) && word.comma == comma)
        };
        let mut slots: Vec<_> = line
            .slots
            .iter()
            .filter(|slot| !stands(slot.letters, slot.comma))
            .filter(|slot| is_explicit || slot.otherwise == WhenOmitted::Missing)
            .collect();
        order::by_key(&mut slots, |slot| slot.otherwise != WhenOmitted::Missing);
        let items = slots.into_iter().map(|slot| {
            let letter = slot.letters[0];
            let role = role_of(letter, form, self.state);
            let comma = if slot.comma { "," } else { "" };
            let first = Piece::Fixed(format!("{comma}{}", letter as char));
            Item { pieces: vec![first, Piece::Fill(String::new())], kind: ProposalKind::Word(role, None) }
        });
        items.collect()
    }
}

fn with_letter(mut item: Item, letter: u8) -> Item {
    if let Some(Piece::Fixed(text)) = item.pieces.first_mut() {
        text.replace_range(..1, &(letter as char).to_string());
    }
    item
}
