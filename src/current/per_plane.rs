//! One value for each picture: the section and the end face.
//!
//! In: a [`Plane`]. Out: the value of its picture. Must not know what is kept.

use std::ops::{Index, IndexMut};

use crate::scene::Plane;

/// A value for each [`Plane`].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PerPlane<T> {
    section: T,
    face: T,
}

impl<T> PerPlane<T> {
    /// The value that is made for each of them.
    pub fn new(mut make: impl FnMut(Plane) -> T) -> Self {
        Self { section: make(Plane::Section), face: make(Plane::Face) }
    }

    /// That of the section, and that of the face.
    pub fn both_mut(&mut self) -> (&mut T, &mut T) {
        (&mut self.section, &mut self.face)
    }
}

impl<T> Index<Plane> for PerPlane<T> {
    type Output = T;

    fn index(&self, plane: Plane) -> &T {
        match plane {
            Plane::Section => &self.section,
            Plane::Face => &self.face,
        }
    }
}

impl<T> IndexMut<Plane> for PerPlane<T> {
    fn index_mut(&mut self, plane: Plane) -> &mut T {
        match plane {
            Plane::Section => &mut self.section,
            Plane::Face => &mut self.face,
        }
    }
}
