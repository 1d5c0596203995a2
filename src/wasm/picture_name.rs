//! The names of the pictures in JavaScript.
#![allow(missing_docs, reason = "the macro adds functions of its own")]

use wasm_bindgen::prelude::*;

use crate::scene::Plane;

/// One of the pictures.
#[wasm_bindgen]
#[derive(Clone, Copy, Debug)]
pub enum PictureName {
    /// The section along the spindle axis.
    Section = "section",
    /// The end face, seen from the tailstock.
    Face = "face",
    /// The side, seen from outside and usually unrolled.
    Side = "side",
}

impl From<PictureName> for Plane {
    fn from(name: PictureName) -> Self {
        match name {
            PictureName::Face => Self::Face,
            PictureName::Side => Self::Side,
            _ => Self::Section,
        }
    }
}
