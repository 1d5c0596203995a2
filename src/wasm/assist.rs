//! Help at a place of the program: the word there, and the state of the control.
//!
//! In: a place, and which visit to its block. Out: rows. The run is replayed in slices; the result is cached
//! until the question is about another block, or the run changes.

use wasm_bindgen::prelude::*;

use super::{Playground, to_js};
use crate::api::assist::Reader;
use crate::assist::Query;
use crate::current::question::Question;
use crate::parts::late;
use crate::run::replay::VisitChoice;
use crate::scene::annotation::Annotate;
use crate::source::Span;

#[wasm_bindgen]
impl Playground {
    /// Asks about the block at an offset: about the visit with the number `time`, from 1, or the usual one.
    /// The run must have ended. Returns whether the answer is already available.
    #[wasm_bindgen(js_name = askBlock)]
    pub fn ask_block(&mut self, offset: u32, time: Option<u32>) -> bool {
        ask(self, offset, time)
    }

    /// Asks about the block of a motion, in the visit that makes the motion. The run must have ended. Returns
    /// whether the answer is already available.
    #[wasm_bindgen(js_name = askMotion)]
    pub fn ask_motion(&mut self, motion: u32) -> bool {
        ask_motion(self, motion)
    }

    /// Continues the search for at most `blocks` blocks. Returns whether the answer is available.
    #[wasm_bindgen(js_name = lookForAnswer)]
    pub fn look_for_answer(&mut self, blocks: u32) -> bool {
        look(self, blocks)
    }

    /// Help for the word at the requested place; `undefined` if there is no word, or no answer yet.
    #[wasm_bindgen(js_name = wordHelp, unchecked_return_type = "WordHelp | undefined")]
    pub fn word_help(&self) -> Result<JsValue, JsValue> {
        word(self)
    }

    /// Chooses the annotations of the section: `none`, `word`, `cycle` or `part`; `word` for others.
    #[wasm_bindgen(js_name = setAnnotate)]
    pub fn set_annotate(&mut self, name: &str) {
        self.current.set_annotate(match name {
            "none" => Annotate::None,
            "cycle" => Annotate::Cycle,
            "part" => Annotate::Part,
            _ => Annotate::Word,
        });
    }

    /// Draws the chosen annotations, of the requested place if it `isAtCursor`.
    pub fn annotate(&mut self, is_at_cursor: bool) {
        annotate(self, is_at_cursor);
    }

    /// A description of the requested block; `undefined` if there is no answer yet.
    #[wasm_bindgen(unchecked_return_type = "string | undefined")]
    pub fn explanation(&self) -> Result<JsValue, JsValue> {
        explanation(self)
    }

    /// The uses of the number at an offset; `undefined` if there is no number.
    #[wasm_bindgen(js_name = usesAt, unchecked_return_type = "UsesHelp | undefined")]
    pub fn uses_at(&self, offset: u32) -> Result<JsValue, JsValue> {
        uses(self, offset)
    }

    /// The outline of the text.
    #[wasm_bindgen(unchecked_return_type = "OutlineHelp")]
    pub fn outline(&self) -> Result<JsValue, JsValue> {
        outline(self)
    }

    /// The state before and after the requested block; `undefined` if there is no answer yet.
    #[wasm_bindgen(js_name = stateHelp, unchecked_return_type = "StateHelp | undefined")]
    pub fn state_help(&self) -> Result<JsValue, JsValue> {
        state(self)
    }

    /// The completions at the requested place. `asked_for`: whether the user requested them explicitly.
    /// `undefined` if there are none, or no answer yet.
    #[wasm_bindgen(js_name = completionHelp, unchecked_return_type = "CompletionHelp | undefined")]
    pub fn completion_help(&self, asked_for: bool) -> Result<JsValue, JsValue> {
        completion(self, asked_for)
    }

    /// The form of the requested block; `undefined` if it has none, or there is no answer yet.
    #[wasm_bindgen(js_name = formHelp, unchecked_return_type = "FormHelp | undefined")]
    pub fn form_help(&self) -> Result<JsValue, JsValue> {
        form(self)
    }
}

late! {
    fn ask(playground: &mut Playground, offset: u32, time: Option<u32>) -> bool {
        let current = &playground.current;
        let byte = current.lines().byte_at_utf16(current.run().text(), offset);
        begin(playground, byte, time.map_or(VisitChoice::Usual, VisitChoice::Number))
    }

    fn ask_motion(playground: &mut Playground, motion: u32) -> bool {
        let (motions, motion) = (playground.current.motions(), motion as usize);
        if motion >= motions.len() {
            playground.question = Question::default();
            return true;
        }
        let byte = motions.span(motion).start;
        begin(playground, byte, VisitChoice::Motion(motion))
    }

    fn explanation(playground: &Playground) -> Result<JsValue, JsValue> {
        let motions = playground.current.motions();
        with_answer(playground, |reader, asked| Ok(reader.explanation(asked, motions).into()))
    }

    fn look(playground: &mut Playground, blocks: u32) -> bool {
        let Playground { current, question, .. } = playground;
        question.look(current, blocks as usize)
    }

    fn uses(playground: &Playground, offset: u32) -> Result<JsValue, JsValue> {
        let run = playground.current.run();
        let byte = playground.current.lines().byte_at_utf16(run.text(), offset);
        to_js(&reader(playground).uses(run.code_list(), byte))
    }

    fn outline(playground: &Playground) -> Result<JsValue, JsValue> {
        to_js(&reader(playground).outline(playground.current.run().code_list()))
    }

    fn word(playground: &Playground) -> Result<JsValue, JsValue> {
        let notes: Vec<Span> = playground.current.run().notes().spans().collect();
        let (byte, motions) = (playground.question.byte(), playground.current.motions());
        with_answer(playground, |reader, asked| to_js(&reader.word(asked, byte, &notes, motions)))
    }

    fn annotate(playground: &mut Playground, is_at_cursor: bool) {
        let Playground { current, question, .. } = playground;
        let found = question.found(current).filter(|_| is_at_cursor);
        current.annotate(found.map(|found| (question.byte(), found)));
    }

    fn completion(playground: &Playground, asked_for: bool) -> Result<JsValue, JsValue> {
        let (byte, end) = (playground.question.byte(), playground.current.run().state());
        with_answer(playground, |reader, asked| to_js(&reader.completion(asked, byte, end, asked_for)))
    }

    fn form(playground: &Playground) -> Result<JsValue, JsValue> {
        let byte = playground.question.byte();
        with_answer(playground, |reader, asked| to_js(&reader.form(asked, byte)))
    }

    fn state(playground: &Playground) -> Result<JsValue, JsValue> {
        let motions = playground.current.motions();
        with_answer(playground, |reader, asked| to_js(&reader.state(asked, motions)))
    }
}

/// Starts the search for the answer; returns true if it is already available.
fn begin(playground: &mut Playground, byte: u32, time: VisitChoice) -> bool {
    let Playground { current, question, .. } = playground;
    question.ask(current, byte, time)
}

/// Calls `make` with the answer; returns `undefined` if there is none yet.
pub(super) fn with_answer(
    playground: &Playground,
    make: impl FnOnce(&Reader, &Query) -> Result<JsValue, JsValue>,
) -> Result<JsValue, JsValue> {
    let run = playground.current.run();
    let Some(found) = playground.question.found(&playground.current) else { return Ok(JsValue::UNDEFINED) };
    let block = found.block(run);
    let asked = Query::new(run, found, &block);
    make(&reader(playground), &asked)
}

fn reader(playground: &Playground) -> Reader<'_> {
    Reader { places: playground.places(), language: playground.language, unit: playground.current.unit() }
}
