//! The playback interface for JavaScript: tool position and readout.

use wasm_bindgen::prelude::*;

use super::{Playground, to_js};
use crate::api::{Readout, Shown, Totals};
use crate::current::Current;
use crate::parts::late;
use crate::playback::clock::Playhead;
use crate::playback::holds::{self, PauseRules, Stops};
use crate::playback::steps::{Direction, Unit, step};
use crate::playback::totals;
use crate::scene::Plane;

/// The size of a step.
#[wasm_bindgen]
#[derive(Clone, Copy, Debug)]
pub enum StepUnit {
    /// One motion.
    Motion = "motion",
    /// All motions of a block.
    Block = "block",
    /// All motions of a pass of a cycle; outside cycles, of a block.
    Pass = "pass",
}

/// The direction of a step.
#[wasm_bindgen]
#[derive(Clone, Copy, Debug)]
pub enum StepDirection {
    /// Forward.
    Next = "next",
    /// Backward.
    Previous = "previous",
}

/// The stops of the program at which the tool is held.
#[wasm_bindgen]
#[derive(Clone, Copy, Debug)]
pub enum StopSwitch {
    /// M00 and M01.
    All = "all",
    /// M00 only.
    NotOptional = "not-optional",
}

/// The reason why the tool is held.
#[wasm_bindgen]
#[derive(Clone, Copy, Debug)]
pub enum HeldBy {
    /// Not held: the tool moves on, or is at the end.
    Nothing = "nothing",
    /// M00 or M01.
    Stop = "stop",
    /// The end of a block.
    Block = "block",
    /// A marked line, which would be next.
    Line = "line",
}

#[wasm_bindgen]
impl Playground {
    /// Duration of the whole animation at machine speed, seconds; partly assumed.
    #[wasm_bindgen(js_name = animationSeconds)]
    pub fn animation_seconds(&self) -> f64 {
        animation_seconds(&self.current)
    }

    /// Shows all strokes and no tool.
    #[wasm_bindgen(js_name = showWhole)]
    pub fn show_whole(&mut self) {
        self.current.seek(None);
    }

    /// Moves the tool to a fraction of the animation, 0 to 1.
    pub fn seek(&mut self, share: f64) {
        seek(&mut self.current, share);
    }

    /// Moves the tool forward by `seconds` seconds of the animation, or to where it is held: at a stop of the
    /// program, at the end of a block, or before a block of one of `lines`, from 0. A line without a move is
    /// replaced by the next one with a move.
    pub fn play(&mut self, seconds: f64, stops: StopSwitch, each_block: bool, lines: &[u32]) -> HeldBy {
        let stops = match stops {
            StopSwitch::NotOptional => Stops::NotOptional,
            _ => Stops::All,
        };
        play(&mut self.current, seconds, PauseRules { stops, each_block, lines })
    }

    /// Moves the tool to the start of the block at a UTF-16 offset, or of the next block that moves it.
    #[wasm_bindgen(js_name = seekBlock)]
    pub fn seek_block(&mut self, offset: u32) {
        seek_block(&mut self.current, offset);
    }

    /// Moves the tool to the end of the previous or the next step.
    pub fn step(&mut self, unit: StepUnit, direction: StepDirection) {
        let unit = match unit {
            StepUnit::Block => Unit::Block,
            StepUnit::Pass => Unit::Pass,
            _ => Unit::Motion,
        };
        let direction = match direction {
            StepDirection::Previous => Direction::Previous,
            _ => Direction::Next,
        };
        step_on(&mut self.current, unit, direction);
    }

    /// Moves the tool to the end of a motion.
    #[wasm_bindgen(js_name = goTo)]
    pub fn go_to(&mut self, motion: u32) {
        let motion = motion as usize;
        let there = motion < self.current.motions().len();
        self.current.seek(there.then_some(Playhead { motion, share: 1.0 }));
    }

    /// Descriptions of the motions `first..end`, each with the tool position at its end.
    #[wasm_bindgen(unchecked_return_type = "Stroke[]")]
    pub fn strokes(&self, first: u32, end: u32) -> Result<JsValue, JsValue> {
        strokes(self, first, end)
    }

    /// Time, path lengths and extents of each tool, in order of first use, then of the whole program.
    #[wasm_bindgen(unchecked_return_type = "Totals[]")]
    pub fn totals(&self) -> Result<JsValue, JsValue> {
        totals_of(&self.current)
    }

    /// The readout at the tool position.
    #[wasm_bindgen(unchecked_return_type = "Readout | undefined")]
    pub fn readout(&mut self) -> Result<JsValue, JsValue> {
        readout(self)
    }
}

late! {
    fn animation_seconds(current: &Current) -> f64 {
        current.clock().total().animation_seconds
    }

    fn seek(current: &mut Current, share: f64) {
        let clock = current.clock();
        let place = clock.playhead_at(current.motions(), share * clock.total().animation_seconds);
        current.seek(Some(place));
        current.keep_tool_in_view();
    }

    fn play(current: &mut Current, seconds: f64, asked: PauseRules) -> HeldBy {
        let from = current.view(Plane::Section).playhead.unwrap_or(Playhead::START);
        let lines = current.lines_that_move(asked.lines);
        let rules = PauseRules { lines: &lines, ..asked };
        let (place, by) = holds::play(current.clock(), current.motions(), from, seconds, rules);
        current.seek(Some(place));
        current.keep_tool_in_view();
        match by {
            None => HeldBy::Nothing,
            Some(holds::PauseReason::Stop) => HeldBy::Stop,
            Some(holds::PauseReason::Block) => HeldBy::Block,
            Some(holds::PauseReason::Line) => HeldBy::Line,
        }
    }

    fn step_on(current: &mut Current, unit: Unit, direction: Direction) {
        let place = step(current.motions(), current.view(Plane::Section).playhead, unit, direction);
        current.seek(Some(place));
        current.keep_tool_in_view();
    }

    fn seek_block(current: &mut Current, offset: u32) {
        current.seek_block(offset);
        current.keep_tool_in_view();
    }

    fn totals_of(current: &Current) -> Result<JsValue, JsValue> {
        let (tools, all) = totals::totals(current.motions(), &current.run().setup().machine);
        to_js(&tools.iter().chain([&all]).map(Totals::new).collect::<Vec<_>>())
    }

    fn strokes(playground: &Playground, first: u32, end: u32) -> Result<JsValue, JsValue> {
        let motions = playground.current.motions();
        let rows = js_sys::Array::new();
        for motion in first as usize..motions.len().min(end as usize) {
            rows.push(&playground.stroke(motion, motions.get_on_workpiece(motion).to)?);
        }
        Ok(rows.into())
    }

    fn readout(playground: &mut Playground) -> Result<JsValue, JsValue> {
        let Some((playhead, place)) = playground.current.place() else { return Ok(JsValue::UNDEFINED) };
        let shown = Shown {
            places: playground.places(),
            motions: playground.current.motions(),
            clock: playground.current.clock(),
            unit: playground.current.unit(),
            resolved: playground.current.resolved_setup(),
        };
        to_js(&Readout::new(&shown, playhead, place.at, playground.language))
    }
}
