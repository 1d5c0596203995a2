//! Exercises.
//!
//! In: the text of an exercise file; the answer is the current program. Out: the texts and the drawing of the exercise,
//! the report on the answer. A part that differs is compared with the target in the picture.

use wasm_bindgen::prelude::*;

use super::{Playground, to_js};
use crate::api::exercise::{AnswerReport, ExerciseBlocks, ExerciseRead, Graded};
use crate::exercise::{Exercise, NoTarget, blocks_of_exercise, check};
use crate::export::wanted_part;
use crate::parts::late;
use crate::scene::svg::{Ground, SvgOptions};

/// Width of the drawing, mm.
const DRAWING_WIDTH: f64 = 100.0;

#[wasm_bindgen]
impl Playground {
    /// Reads an exercise file.
    #[wasm_bindgen(unchecked_return_type = "ExerciseRead")]
    pub fn exercise(&self, text: &str) -> Result<JsValue, JsValue> {
        read_exercise(self, text)
    }

    /// The drawing of the wanted part, as SVG; `undefined` if the file has a fault.
    #[wasm_bindgen(js_name = exerciseDrawing)]
    pub fn exercise_drawing(&self, text: &str) -> Option<String> {
        drawing(self, text)
    }

    /// Checks the program as the answer to an exercise; `undefined` if the file has a fault. The picture compares a part
    /// that differs with the target.
    #[wasm_bindgen(js_name = checkExercise, unchecked_return_type = "Graded | undefined")]
    pub fn check_exercise(&mut self, text: &str) -> Result<JsValue, JsValue> {
        check_answer(self, text)
    }

    /// The blocks of an exercise whose part the current program makes.
    #[wasm_bindgen(js_name = exerciseBlocks, unchecked_return_type = "ExerciseBlocks")]
    pub fn exercise_blocks(&self) -> Result<JsValue, JsValue> {
        blocks(self)
    }

    /// Checks another program than the current one as an answer.
    #[wasm_bindgen(js_name = gradeAnswer, unchecked_return_type = "AnswerReport")]
    pub fn grade_answer(&self, text: &str, answer: &str) -> Result<JsValue, JsValue> {
        grade(self, text, answer)
    }
}

late! {
    fn read_exercise(playground: &Playground, text: &str) -> Result<JsValue, JsValue> {
        to_js(&ExerciseRead::new(text, playground.language))
    }

    fn drawing(playground: &Playground, text: &str) -> Option<String> {
        let exercise = Exercise::read(text).ok()?;
        let options = SvgOptions { ground: Ground::Paper, ..SvgOptions::default() };
        wanted_part::drawing(&exercise, options.on_paper(DRAWING_WIDTH), playground.language)
    }

    fn blocks(playground: &Playground) -> Result<JsValue, JsValue> {
        let run = playground.current.run();
        let decides = run.decided_rule().is_some();
        let blocks = playground.current.simulation().ok_or(NoTarget::NoPart).and_then(|simulation| {
            blocks_of_exercise(simulation, run.motions(), &run.setup_at_machine(), decides)
        });
        to_js(&ExerciseBlocks::new(blocks, playground.language))
    }

    fn grade(playground: &Playground, text: &str, answer: &str) -> Result<JsValue, JsValue> {
        to_js(&AnswerReport::new(text, answer.as_bytes(), playground.language))
    }

    fn check_answer(playground: &mut Playground, text: &str) -> Result<JsValue, JsValue> {
        let Ok(exercise) = Exercise::read(text) else { return Ok(JsValue::UNDEFINED) };
        let report = check(&exercise, playground.current.run().text());
        let graded = Graded::new(&report, &exercise, playground.places(), playground.language);
        if graded.same_part {
            playground.current.end_comparison();
        } else {
            playground.current.compare_with(exercise.target.region.clone(), exercise.target.left);
        }
        to_js(&graded)
    }
}
