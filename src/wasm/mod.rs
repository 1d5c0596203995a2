//! The wasm interface, the only interface for JavaScript.
//!
//! In: text, a setup as JSON, user actions in the picture. Out: typed arrays for motions and tokens, plain
//! objects for everything small, and a drawn canvas. Offsets are UTF-16 offsets into the document, where
//! every line end counts as one unit, as in editors. Knows no G-code.

mod assist;
mod calculate;
mod decimal;
mod difference;
mod exercise;
mod files;
mod motions;
mod paste;
mod picture_name;
mod pictures;
mod playback;
mod profiles;
mod rewrite;
mod setup;
mod tidied;

pub use motions::{MotionChunk, MotionChunkView};
pub use picture_name::PictureName;
pub use pictures::Drawn;

use js_sys::{Float64Array, RangeError, Reflect, Uint8Array};
use serde::de::IntoDeserializer;
use serde::de::value::Error as ValueError;
use serde::{Deserialize, Serialize};
use wasm_bindgen::prelude::*;

use crate::api::{self, Places, Summary};
use crate::current::Current;
use crate::current::per_plane::PerPlane;
use crate::current::question::Question;
use crate::findings;
use crate::geometry::Point;
use crate::limits;
use crate::machine::region::Region;
use crate::message::{Diagnostic, sort_by_place};
use crate::motion::Chunk;
#[cfg(parts)]
use crate::parts::entry;
use crate::parts::{Part, late};
use crate::scene::canvas::Painter;
use crate::sentences::{Language, labels};
use crate::setup::{Setup, TriedValue};
use crate::source::LineIndex;
use crate::text::highlight::highlight;
use crate::units::Unit;

/// A program, its run and its pictures.
#[wasm_bindgen]
pub struct Playground {
    setup: Setup,
    language: Language,
    current: Current,
    /// The painter of each picture, once it has a canvas.
    painters: PerPlane<Option<Painter>>,
    /// The buffer for a text that is being passed in.
    incoming: Vec<u8>,
    /// The current question about a block.
    question: Question,
}

#[wasm_bindgen]
impl Playground {
    /// An empty program with the default setup.
    #[wasm_bindgen(constructor)]
    #[allow(clippy::new_without_default, reason = "JavaScript has no Default")]
    pub fn new() -> Playground {
        Playground {
            setup: Setup::default(),
            language: Language::default(),
            current: Current::new(Vec::new(), Setup::default()),
            painters: PerPlane::default(),
            incoming: Vec::new(),
            question: Question::default(),
        }
    }

    /// Sets the program and discards the previous run.
    #[wasm_bindgen(js_name = setText)]
    pub fn set_text(&mut self, text: String) {
        self.begin(text.into_bytes());
    }

    /// A buffer for a long text in the memory of the module: a view of `capacity` bytes, to be filled with
    /// `TextEncoder.encodeInto` and then taken by [`Self::set_text_from_buffer`]. Another call with more
    /// bytes keeps the contents. A view becomes invalid when any call makes the memory grow, so fill it
    /// before the next call. Throws a `RangeError` if there is not enough memory, or for more than 512 MB.
    #[wasm_bindgen(js_name = textBuffer)]
    pub fn text_buffer(&mut self, capacity: usize) -> Result<Uint8Array, JsValue> {
        let more = capacity.saturating_sub(self.incoming.len());
        if capacity > limits::TEXT_BUFFER || self.incoming.try_reserve_exact(more).is_err() {
            return Err(RangeError::new("there is no room for so long a text").into());
        }
        self.incoming.resize(capacity, 0);
        Ok(view_to_fill(&mut self.incoming))
    }

    /// Takes the first `written` bytes of the buffer as the program.
    #[wasm_bindgen(js_name = setTextFromBuffer)]
    pub fn set_text_from_buffer(&mut self, written: usize) {
        let mut bytes = std::mem::take(&mut self.incoming);
        bytes.truncate(written);
        self.begin(bytes);
    }

    /// Sets the program from bytes, such as the contents of a file.
    #[wasm_bindgen(js_name = setBytes)]
    pub fn set_bytes(&mut self, bytes: Vec<u8>) {
        self.begin(bytes);
    }

    /// Replaces the text `from..to` (UTF-16 offsets) and runs again from there; results from before it are
    /// kept. If a text has several changes, apply the last one in the text first.
    pub fn edit(&mut self, from: u32, to: u32, insert: &str) {
        self.current.edit(from, to, insert);
    }

    /// The original text of the lines `first..end` (from 0), with their line ends.
    #[wasm_bindgen(js_name = linesAsWritten)]
    pub fn lines_as_written(&self, first: u32, end: u32) -> String {
        let (text, lines) = (self.current.run().text(), self.current.lines());
        let start =
            |line: u32| if line < lines.len() { lines.line(text, line).start as usize } else { text.len() };
        String::from_utf8_lossy(&text[start(first)..start(end.max(first))]).into_owned()
    }

    /// The line (from 0) that contains an offset.
    #[wasm_bindgen(js_name = lineAt)]
    pub fn line_at(&self, offset: u32) -> u32 {
        self.current.lines().line_of(self.current.lines().byte_at_utf16(self.current.run().text(), offset))
    }

    /// Sets a setup given as JSON, and begins a run of the text with it. Throws an `Error` that names the
    /// fault, such as an unknown key; the previous setup is then kept. In a module that is split into parts,
    /// only `{}` can be parsed before the part `early` is loaded.
    #[wasm_bindgen(js_name = setSetup)]
    pub fn set_setup(&mut self, json: &str) -> Result<(), JsValue> {
        let setup = Setup::from_json(json).map_err(|problem| error(&problem))?;
        self.setup = Setup { tried: std::mem::take(&mut self.setup.tried), ..setup };
        self.current.set_setup(self.setup.clone());
        Ok(())
    }

    /// Begins a run that tries values: each variable gets its value before a block at an offset, in one of
    /// the executions of the block, from 1. The four lists have the same length. Empty lists end the trial.
    #[wasm_bindgen(js_name = tryValues)]
    pub fn try_values(&mut self, blocks: &[u32], times: &[u32], variables: &[u32], values: &[f64]) {
        let rest = times.iter().zip(variables).zip(values);
        let tried = blocks.iter().zip(rest).map(|(&offset, ((&time, &variable), &value))| TriedValue {
            block: self.current.start_of_block(offset),
            time,
            variable,
            value,
        });
        let tried: Vec<_> = tried.collect();
        if !(tried.is_empty() && self.setup.tried.is_empty()) {
            self.setup.tried = tried;
            self.current.set_setup(self.setup.clone());
        }
    }

    /// Sets the language of the messages and pictures: `en`, `zh` or `ru`.
    #[wasm_bindgen(js_name = setLanguage)]
    pub fn set_language(&mut self, tag: &str) {
        self.language = Language::from_tag(tag);
        let symbols = [Unit::Millimetre, Unit::Inch];
        self.current.set_unit_symbols(symbols.map(|unit| labels::unit_of_ruler(unit, self.language)));
    }

    /// Sets the unit in which lengths are shown: `mm` or `inch`. Any other value selects the unit of the
    /// program.
    #[wasm_bindgen(js_name = setUnit)]
    pub fn set_unit(&mut self, name: &str) {
        self.current.set_unit(match name {
            "mm" => Some(Unit::Millimetre),
            "inch" => Some(Unit::Inch),
            _ => None,
        });
    }

    /// The unit in which lengths are shown, and the unit of the program.
    #[wasm_bindgen(unchecked_return_type = "Units")]
    pub fn units(&self) -> Result<JsValue, JsValue> {
        units(self)
    }

    /// Runs at most `blocks` blocks; returns true once the run has ended.
    pub fn advance(&mut self, blocks: u32) -> bool {
        self.current.advance(blocks as usize)
    }

    /// Removes the material of at most `motions` motions from the blank, once the run has ended; returns true
    /// when it is finished. It also makes the messages about collisions available.
    #[wasm_bindgen(js_name = removeMaterial)]
    pub fn remove_material(&mut self, motions: u32) -> bool {
        self.current.remove_material(motions as usize)
    }

    /// The part of the module that the run needed but that was not loaded. If there is one, the results of
    /// the run are unusable; call [`Self::begin_again`] once the part is loaded.
    #[wasm_bindgen(js_name = missingPart)]
    pub fn missing_part(&self) -> Option<String> {
        self.current.run().missing().map(|part| part.name().to_owned())
    }

    /// Restarts the run if something that it lacks has been loaded since: such a part, or the lints. Returns
    /// whether it restarted.
    #[wasm_bindgen(js_name = beginAgain)]
    pub fn begin_again(&mut self) -> bool {
        self.current.rerun_if_outdated()
    }

    /// The fraction of the program that has run, 0 to 1.
    pub fn progress(&self) -> f64 {
        self.current.run().progress()
    }

    /// Ends the run early, after `seconds` seconds, and reports that.
    pub fn stop(&mut self, seconds: f64) {
        self.current.stop(seconds);
    }

    /// Counts of the run. They count the messages of [`Self::diagnostics`]; if the part with the simulation
    /// is not loaded, only the messages about the path.
    #[wasm_bindgen(unchecked_return_type = "Summary")]
    pub fn summary(&self) -> Result<JsValue, JsValue> {
        let mut summary = Summary {
            blocks: self.current.run().blocks() as u32,
            lines: self.current.lines().len(),
            finished: self.current.run().is_finished(),
            ..Summary::new(self.current.motions(), self.current.run().diagnostics())
        };
        if Part::Late.is_loaded() {
            count_findings(self, &mut summary);
        }
        // Built by hand, because the general serializer is not loaded before the first picture.
        let row = js_sys::Object::new();
        for (name, count) in summary.counts() {
            Reflect::set(&row, &JsValue::from_str(name), &JsValue::from_f64(f64::from(count)))?;
        }
        Reflect::set(&row, &JsValue::from_str("finished"), &JsValue::from_bool(summary.finished))?;
        Ok(row.into())
    }

    /// The number of motions, and the number of errors in the path.
    #[wasm_bindgen(js_name = motionsAndErrors)]
    pub fn motions_and_errors(&self) -> Vec<u32> {
        let errors = self.current.run().diagnostics().iter().filter(|told| told.is_error()).count();
        vec![self.current.motions().len() as u32, errors as u32]
    }

    /// The messages of the run.
    #[wasm_bindgen(unchecked_return_type = "Diagnostic[]")]
    pub fn diagnostics(&self) -> Result<JsValue, JsValue> {
        diagnostics(self)
    }

    /// The messages for the Node package: offsets refer to the original text, where CR LF counts as two
    /// units.
    #[wasm_bindgen(js_name = diagnosticsAsWritten, unchecked_return_type = "Diagnostic[]")]
    pub fn diagnostics_as_written(&self) -> Result<JsValue, JsValue> {
        diagnostics_as_written(self)
    }

    /// The names of all rules that the setup switches off.
    #[wasm_bindgen(js_name = rulesOff)]
    pub fn rules_off(&self) -> Vec<String> {
        rules_off(self)
    }

    /// Tokens of the lines `first..end` (from 0): triples of offset, end offset and class.
    pub fn tokens(&self, first: u32, end: u32) -> Vec<u32> {
        tokens(self, first, end)
    }

    /// The program with every cycle, corner and compensation expanded to plain moves.
    pub fn expand(&self) -> String {
        expanded(self)
    }

    /// The table of supported codes; the codes of this program's control come first.
    #[wasm_bindgen(unchecked_return_type = "Codes")]
    pub fn codes(&self) -> Result<JsValue, JsValue> {
        codes(self)
    }

    /// Highlights the strokes of the block at an offset.
    #[wasm_bindgen(js_name = setCursor)]
    pub fn set_cursor(&mut self, offset: Option<u32>) {
        self.current.set_cursor(offset);
    }

    /// Highlights the strokes of lines while there is no cursor: pairs of the first line, from 0, and the
    /// end.
    #[wasm_bindgen(js_name = setMarkedLines)]
    pub fn set_marked_lines(&mut self, lines: &[u32]) {
        self.current
            .set_marked_lines(lines.as_chunks::<2>().0.iter().map(|&[first, end]| first..end).collect());
    }

    /// Marks the stroke under the pointer.
    #[wasm_bindgen(js_name = setHover)]
    pub fn set_hover(&mut self, motion: Option<u32>) {
        self.current.set_hover(motion.map(|index| index as usize));
    }

    /// The finished part, once all material is removed; `undefined` without a blank.
    #[wasm_bindgen(unchecked_return_type = "Part | undefined")]
    pub fn part(&self) -> Result<JsValue, JsValue> {
        self.current.part().map_or(Ok(JsValue::UNDEFINED), part)
    }
}

late! {
    fn diagnostics(playground: &Playground) -> Result<JsValue, JsValue> {
        playground.rows(playground.places())
    }

    fn diagnostics_as_written(playground: &Playground) -> Result<JsValue, JsValue> {
        let text = playground.current.run().text();
        playground.rows(Places { text, lines: &LineIndex::as_written(text) })
    }

    fn count_findings(playground: &Playground, summary: &mut Summary) {
        for found in playground.findings() {
            summary.count(found.severity);
        }
    }

    fn rules_off(playground: &Playground) -> Vec<String> {
        playground.current.run().setup().rules.rules_off().map(str::to_owned).collect()
    }

    fn units(playground: &Playground) -> Result<JsValue, JsValue> {
        let current = &playground.current;
        to_js(&api::Units::new(current.unit(), current.run().state().unit))
    }

    fn tokens(playground: &Playground, first: u32, end: u32) -> Vec<u32> {
        let (text, lines) = (playground.current.run().text(), playground.current.lines());
        let end = end.min(lines.len());
        if first >= end {
            return Vec::new();
        }
        let places = playground.places();
        let found = highlight(text, lines.line(text, first).start as usize, lines.line(text, end - 1).end as usize);
        let triple = |(span, class)| {
            let (from, to) = places.offsets(span);
            [from, to, class as u32]
        };
        found.into_iter().flat_map(triple).collect()
    }

    fn expanded(playground: &Playground) -> String {
        let run = playground.current.run();
        crate::expand::expand(run.text(), &run.setup_to_repeat())
    }

    fn codes(playground: &Playground) -> Result<JsValue, JsValue> {
        to_js(&api::codes(playground.current.run().code_list(), playground.language))
    }

    fn part(region: &Region) -> Result<JsValue, JsValue> {
        to_js(&api::Part::new(region))
    }
}

/// Installs a part whose code has been loaded into the module; its functions can be called from now on.
#[wasm_bindgen(js_name = partLoaded)]
pub fn part_loaded(name: &str) {
    let Some(part) = Part::ALL.into_iter().find(|part| part.name() == name) else { return };
    #[cfg(parts)]
    match part {
        Part::Early => install_early(),
        Part::Late => {
            install_early();
            install_late();
        }
    }
    part.loaded();
}

#[cfg(parts)]
entry! { Early install_early {
    crate::control::interpreter::with_y::install();
    crate::control::interpreter::block::install();
    crate::control::interpreter::calls::install();
    crate::control::interpreter::compensated::install();
    crate::control::interpreter::corner::install();
    crate::control::interpreter::holes::install();
    crate::control::interpreter::macros::install();
    crate::control::interpreter::path::install();
    crate::control::interpreter::read_words::install();
    crate::control::interpreter::y_axis::install();
    crate::control::tool_offset::install();
    crate::message::levels::install();
    crate::provenance::install();
    crate::run::repeated::install();
    crate::setup::install();
    crate::setup::invalid::install();
    crate::setup::notes::install();
    crate::setup::tool::install();
    crate::text::parser::install();
} }

#[cfg(parts)]
entry! { Late install_late {
    install();
    assist::install();
    calculate::install();
    decimal::install();
    difference::install();
    exercise::install();
    files::install();
    motions::install();
    paste::install();
    pictures::install();
    playback::install();
    profiles::install();
    rewrite::install();
    setup::install();
    tidied::install();
    crate::control::interpreter::contours::install();
    crate::control::interpreter::cycle_moves::install();
    crate::control::interpreter::output::install();
    crate::control::interpreter::repairs::install();
    crate::control::interpreter::singles::install();
    crate::control::interpreter::threads::install();
    crate::control::interpreter::trace::install();
    crate::control::interpreter::unread::install();
    crate::current::install();
    crate::current::machined::install();
    crate::run::install();
    crate::run::edit::install();
    crate::scene::canvas::install();
    crate::scene::canvas::layer::install();
    crate::scene::canvas::sheet::install();
} }

/// Loads the texts of a language, given by its tag. Returns false if they belong to another version.
#[wasm_bindgen(js_name = textsLoaded)]
pub fn texts_loaded(tag: &str, list: String) -> bool {
    Language::from_tag(tag).load(list)
}

impl Playground {
    fn begin(&mut self, text: Vec<u8>) {
        self.current.set_text(text, self.setup.clone());
    }

    /// The findings of the simulation, in the unit of the program.
    fn findings(&self) -> impl Iterator<Item = Diagnostic> {
        let (run, motions) = (self.current.run(), self.current.motions());
        let (levels, told, unit) = (&run.setup().rules, run.diagnostics(), run.state().unit);
        let mut found = Vec::new();
        if let Some(simulation) = self.current.simulation() {
            found = findings::diagnostics(simulation, motions, levels, told);
            run.hide_at_machine(&mut found);
        }
        found.into_iter().map(move |found| found.in_unit(unit))
    }

    /// All messages sorted by place, in the displayed unit.
    fn all_diagnostics(&self) -> Vec<Diagnostic> {
        let mut all = self.current.run().diagnostics().to_vec();
        all.extend(self.findings());
        if let Some(chosen) = self.current.chosen_unit() {
            all.iter_mut().for_each(|found| found.unit = chosen);
        }
        sort_by_place(&mut all);
        all
    }

    fn rows(&self, places: Places<'_>) -> Result<JsValue, JsValue> {
        let all = self.all_diagnostics();
        let rows = all.iter().map(|found| places.diagnostic(found, self.language));
        to_js(&rows.collect::<Vec<_>>())
    }

    fn places(&self) -> Places<'_> {
        Places { text: self.current.run().text(), lines: self.current.lines() }
    }

    fn stroke(&self, motion: usize, at: Point) -> Result<JsValue, JsValue> {
        to_js(&self.places().stroke(self.current.motions(), motion, at, self.current.unit(), self.language))
    }
}

/// The error to throw for an invalid argument.
fn error(text: &str) -> JsValue {
    js_sys::Error::new(text).into()
}

/// The variant of an enum that a name selects.
fn variant<'a, T: Deserialize<'a>>(name: &'a str) -> Result<T, JsValue> {
    T::deserialize(name.into_deserializer()).map_err(|problem: ValueError| error(&problem.to_string()))
}

fn to_js(value: &impl Serialize) -> Result<JsValue, JsValue> {
    Ok(value.serialize(&serde_wasm_bindgen::Serializer::new())?)
}

/// A JavaScript view of bytes that JavaScript will fill.
#[allow(unsafe_code)]
fn view_to_fill(bytes: &mut [u8]) -> Uint8Array {
    // SAFETY: the bytes are initialised and do not move until the next call into the module; until then only
    // JavaScript's single thread can access them. A stale view is detached or stays within the memory of the
    // module, so it can reach no other memory.
    unsafe { Uint8Array::view_mut_raw(bytes.as_mut_ptr(), bytes.len()) }
}

/// JavaScript views of the columns of a chunk.
#[allow(unsafe_code)]
fn view_of(chunk: &Chunk) -> MotionChunkView {
    // SAFETY: the columns do not move before the next call into the module, and the views are documented to
    // be valid only until then. JavaScript only reads, and any bit pattern is a valid number.
    unsafe {
        MotionChunkView {
            kind: Uint8Array::view(chunk.kinds()),
            x: Float64Array::view(chunk.xs()),
            z: Float64Array::view(chunk.zs()),
        }
    }
}
