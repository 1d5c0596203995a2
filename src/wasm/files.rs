//! File export, and the part as a body, for JavaScript.
//!
//! In: the finished run of the program. Out: bytes, a painted canvas.

use wasm_bindgen::prelude::*;
use web_sys::OffscreenCanvas;

use super::{Playground, to_js, variant};
use crate::api;
use crate::current::Current;
use crate::expand::expand;
use crate::export::file::{Exportable, FileFormat, file, speed_chart};
use crate::machine::SimulationResult;
use crate::motion::Motions;
use crate::parts::late;
use crate::run::Run;
use crate::scene::Plane;
use crate::scene::camera::XPlus;
use crate::scene::canvas::{Painter, Progress};
use crate::scene::source::Picture;
use crate::setup::Setup;
use crate::setup::dialect::CodeList;
use crate::units::Unit;

#[wasm_bindgen]
impl Playground {
    /// The bytes of a file, in the language of the messages; `undefined` if the file needs a part and there
    /// is none.
    #[wasm_bindgen(js_name = exportFile)]
    pub fn export_file(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "FileFormat")] format: &str,
    ) -> Result<Option<Vec<u8>>, JsValue> {
        bytes_of(self, format)
    }

    /// The chart of the speeds of a program that does not move, as SVG; `undefined` if it sets no cutting speed.
    #[wasm_bindgen(js_name = speedChart)]
    pub fn speed_chart(&self) -> Option<String> {
        chart_of_speeds(&self.current)
    }

    /// The extension of such a file.
    #[wasm_bindgen(js_name = fileEnding)]
    pub fn file_ending(
        &self,
        #[wasm_bindgen(unchecked_param_type = "FileFormat")] format: &str,
    ) -> Result<String, JsValue> {
        ending_of(format)
    }

    /// Paints the current picture on another canvas, with `pixel_ratio` device pixels per CSS pixel.
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

    /// The part at the displayed moment, as pieces with their holes; empty without a blank, or if it is not
    /// available yet.
    #[wasm_bindgen(unchecked_return_type = "SectionPiece[]")]
    pub fn section(&mut self) -> Result<JsValue, JsValue> {
        section(self)
    }

    /// The holes at that moment that live tools have drilled off the axis and into the side.
    #[wasm_bindgen(unchecked_return_type = "DrilledHole[]")]
    pub fn holes(&mut self) -> Result<JsValue, JsValue> {
        holes(self)
    }
}

late! {
    fn bytes_of(playground: &mut Playground, format: &str) -> Result<Option<Vec<u8>>, JsValue> {
        let format: FileFormat = variant(format)?;
        playground.current.finish_part();
        let (current, setup) = (&playground.current, playground.current.run().setup_at_machine());
        Ok(file(format, &FinishedProgram { current, setup }, playground.language))
    }

    fn chart_of_speeds(current: &Current) -> Option<String> {
        speed_chart(&FinishedProgram { current, setup: current.run().setup_at_machine() }, |options| options)
    }

    fn section(playground: &mut Playground) -> Result<JsValue, JsValue> {
        let shown = playground.current.part_shown();
        to_js(&shown.map(|region| api::section(&region)).unwrap_or_default())
    }

    fn holes(playground: &mut Playground) -> Result<JsValue, JsValue> {
        to_js(&api::holes(&playground.current.holes_shown()))
    }

    fn ending_of(format: &str) -> Result<String, JsValue> {
        Ok(variant::<FileFormat>(format)?.ending().to_owned())
    }
}

/// The current program with all its material removed.
struct FinishedProgram<'a> {
    current: &'a Current,
    setup: Setup,
}

impl Exportable for FinishedProgram<'_> {
    fn text(&self) -> &[u8] {
        self.current.run().text()
    }

    fn motions(&self) -> &Motions {
        self.current.motions()
    }

    fn setup(&self) -> &Setup {
        &self.setup
    }

    fn codes(&self) -> CodeList {
        self.current.run().code_list()
    }

    fn simulation(&self) -> Option<&SimulationResult> {
        self.current.simulation()
    }

    fn expanded(&self) -> Vec<u8> {
        expand(self.text(), &self.current.run().setup_to_repeat()).into_bytes()
    }

    fn finished_run(&self) -> Run {
        Run::finished(self.text().to_vec(), self.current.run().setup_to_repeat())
    }

    fn unit(&self) -> Unit {
        self.current.unit()
    }

    fn x_plus(&self) -> XPlus {
        self.current.turret().into()
    }
}
