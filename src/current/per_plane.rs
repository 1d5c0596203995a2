//! One value for each picture: the section, the end face and the side.
//!
//! In: a [`Plane`]. Out: the value of its picture. Must not know the type of the values.

use std::ops::{Index, IndexMut};

use crate::scene::Plane;

/// A value for each [`Plane`], in the order of [`Plane::ALL`].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PerPlane<T>([T; Plane::ALL.len()]);

impl<T> PerPlane<T> {
    /// Calls `make` for each plane.
    pub fn new(make: impl FnMut(Plane) -> T) -> Self {
        Self(Plane::ALL.map(make))
    }

    /// The value of the section, and the values of the surfaces.
    pub fn section_and_surfaces(&mut self) -> (&mut T, [(Plane, &mut T); Plane::SURFACES.len()]) {
        let [section, face, side] = &mut self.0;
        (section, [(Plane::Face, face), (Plane::Side, side)])
    }

    /// The values of all planes.
    pub fn iter_mut(&mut self) -> impl Iterator<Item = &mut T> {
        self.0.iter_mut()
    }
}

impl<T> Index<Plane> for PerPlane<T> {
    type Output = T;

    fn index(&self, plane: Plane) -> &T {
        let [section, face, side] = &self.0;
        match plane {
            Plane::Section => section,
            Plane::Face => face,
            Plane::Side => side,
        }
    }
}

impl<T> IndexMut<Plane> for PerPlane<T> {
    fn index_mut(&mut self, plane: Plane) -> &mut T {
        let [section, face, side] = &mut self.0;
        match plane {
            Plane::Section => section,
            Plane::Face => face,
            Plane::Side => side,
        }
    }
}
