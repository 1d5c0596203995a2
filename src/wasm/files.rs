//! What leaves the page as a file, and the part as a body: the exporters for JavaScript.
//!
//! In: the program as it has run. Out: texts, bytes, a painted canvas.

use wasm_bindgen::prelude::*;
use web_sys::OffscreenCanvas;

use super::{Playground, to_js};
use crate::api;
use crate::export::card::{self, Card};
use crate::export::{csv, dxf, stl};
use crate::scene::canvas::{Painter, Progress};
use crate::scene::path_index::PathIndex;
use crate::scene::source::Picture;
use crate::scene::svg::{Ground, SvgOptions, svg};
use crate::scene::work::Work;
use crate::scene::{Plane, Scene};
use crate::sentences::labels;
use crate::setup::fields::Unit;

#[wasm_bindgen]
impl Playground {
    /// The drawing as an SVG file, all of it.
    pub fn svg(&mut self) -> String {
        self.current.finish_part();
        self.drawing(Ground::AsSystem)
    }

    /// All motions as a table.
    pub fn csv(&self) -> String {
        csv::csv(self.current.motions(), &self.current.run().setup().machine)
    }

    /// The setup sheet as an HTML file to print, in the language of the messages.
    pub fn card(&mut self) -> String {
        self.current.finish_part();
        let run = self.current.run();
        let motions = run.motions();
        let drawing = (motions.len() <= card::MOST_DRAWN).then(|| self.drawing(Ground::Paper));
        let card = Card {
            text: run.text(),
            motions,
            setup: run.setup(),
            codes: run.code_list(),
            drawing: drawing.as_deref(),
        };
        card.html(self.language)
    }

    /// The profile of the finished part as a DXF file; nothing where there is no part.
    pub fn dxf(&mut self) -> Option<String> {
        self.current.finish_part();
        dxf::dxf(self.current.part()?)
    }

    /// The finished part as an STL file; nothing where there is no part.
    pub fn stl(&mut self) -> Option<Vec<u8>> {
        self.current.finish_part();
        stl::stl(self.current.part()?)
    }

    /// Paints the picture as it is shown on another canvas, so many device pixels a CSS pixel.
    pub fn paint(&mut self, canvas: OffscreenCanvas, pixel_ratio: f64) -> Result<(), JsValue> {
        self.current.finish_part();
        let Some(Picture { scene, view, source }) = self.current.picture(Plane::Section) else {
            return Ok(());
        };
        let mut view = view.clone();
        view.resize(&scene, view.camera().size(), pixel_ratio);
        let mut painter = Painter::new(canvas)?;
        while painter.draw(&Picture { scene, view: &view, source })? != Progress::Done {}
        Ok(())
    }

    /// What is left of the blank at the moment that is shown: pieces with their holes; none where there is no blank, or not
    /// yet.
    #[wasm_bindgen(unchecked_return_type = "SectionPiece[]")]
    pub fn section(&mut self) -> Result<JsValue, JsValue> {
        let shown = self.current.part_shown();
        to_js(&shown.map(|region| api::section(&region)).unwrap_or_default())
    }
}

impl Playground {
    fn drawing(&self, ground: Ground) -> String {
        let motions = self.current.motions();
        let path_index = PathIndex::of(motions);
        let work = self.current.simulation().and_then(|simulation| Work::of(simulation, motions, None));
        let millimetre = labels::unit(Unit::Millimetre, self.language);
        let options = SvgOptions { ground, millimetre, ..SvgOptions::default() };
        svg(&Scene::new(motions, &path_index, work.as_ref()), &options)
    }
}
