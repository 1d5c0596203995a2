//! State that belongs to the user and persists from one run to the next.

use std::ops::Range;

use super::machined::Kept;
use super::per_plane::PerPlane;
use crate::figures::measure::Picked;
use crate::scene::Plane;
use crate::scene::annotation::Annotate;
use crate::scene::ruler::Scale;
use crate::scene::view::View;
use crate::setup::Turret;
use crate::units::Unit;

pub(super) struct ViewState {
    /// The view of each picture. Selection and tool position are kept in the view of the section; the others
    /// follow it.
    pub(super) views: PerPlane<View>,
    /// Position of the cursor, UTF-16 offset.
    pub(super) cursor: Option<u32>,
    /// Lines, from 0, whose strokes are highlighted while there is no cursor.
    pub(super) marked: Vec<Range<u32>>,
    /// The turret side that the user has chosen; `None` for the side in the setup.
    pub(super) turret: Option<Turret>,
    /// The part that is kept for comparison with later ones.
    pub(super) kept: Option<Kept>,
    /// The annotations that the user has chosen.
    pub(super) annotate: Annotate,
    /// The places that the user has picked to measure: at most two.
    pub(super) picked: Vec<Picked>,
    /// The unit that the user has chosen; `None` for the unit of the program.
    pub(super) unit: Option<Unit>,
    /// The symbols of millimetre and inch in the user's language.
    pub(super) unit_symbols: [&'static str; 2],
}

impl ViewState {
    pub(super) fn new(views: PerPlane<View>) -> Self {
        Self {
            views,
            cursor: None,
            marked: Vec::new(),
            turret: None,
            kept: None,
            annotate: Annotate::default(),
            picked: Vec::new(),
            unit: None,
            unit_symbols: ["mm", "in"],
        }
    }

    /// The view of the section, which also contains the selection and the tool position.
    pub(super) fn section(&self) -> &View {
        &self.views[Plane::Section]
    }

    pub(super) fn section_mut(&mut self) -> &mut View {
        &mut self.views[Plane::Section]
    }

    /// Drops what refers to motions of the last run: stroke numbers now belong to other strokes.
    pub(super) fn drop_selections(&mut self) {
        self.picked.clear();
        for view in self.views.iter_mut() {
            *view = view.without_selection(None);
        }
    }

    pub(super) fn clear_annotations(&mut self) {
        self.views.iter_mut().for_each(|view| view.annotations.clear());
    }

    /// Sets the unit of the rulers.
    pub(super) fn set_scale(&mut self, unit: Unit) {
        let scale = Scale { unit, symbol: self.unit_symbols[unit as usize] };
        // The other pictures follow the section, but only if something moves in them; so set all of them
        // here.
        for view in self.views.iter_mut() {
            view.scale = scale;
        }
    }
}
