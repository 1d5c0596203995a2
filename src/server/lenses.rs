//! Code lenses: the time of each tool and cycle, and the passes of each cycle.
//!
//! In: a document whose run has ended. Out: a lens above each of their blocks, if the client requests them in
//! its initialization options.

use gen_lsp_types::{CodeLens, CodeLensParams, Command};

use super::context::Asked;
use super::message::Failure;
use crate::assist::explain::{Passes, has_passes};
use crate::assist::outline::{Entry, Kind, Outline, outline};
use crate::motion::{Cycle, Motion, MotionKind, Motions};
use crate::playback::timing::Total;
use crate::sentences::server;
use crate::setup::Machine;
use crate::source::{Span, line_end};

/// The answer to `textDocument/codeLens`.
pub fn lenses(asked: &Asked, _: &CodeLensParams) -> Result<Option<Vec<CodeLens>>, Failure> {
    if !asked.client.shows_lenses {
        return Ok(None);
    }
    let run = asked.document.run();
    let mut parts = Parts::new(asked.text(), &outline(asked.text(), run.code_list()));
    parts.add_all(run.motions(), &run.setup().machine);
    let mut works: Vec<Work> = parts.tools.into_iter().map(|(_, work)| work).chain(parts.cycles).collect();
    works.sort_by_key(|work| work.at);
    Ok(Some(works.iter().filter_map(|work| lens(asked, work)).collect()))
}

/// The motions of a tool or of a cycle.
#[derive(Clone, Copy, Debug)]
struct Work {
    /// First byte of its block.
    at: u32,
    time: Total,
    motions: usize,
    passes: Passes,
    /// How often the block begins a cycle.
    times: u32,
}

impl Work {
    fn of(entry: &Entry) -> Self {
        Self { at: entry.at, time: Total::default(), motions: 0, passes: Passes::default(), times: 0 }
    }

    fn add(&mut self, motion: &Motion, machine: &Machine) {
        self.time.add(motion, machine);
        self.motions += 1;
    }
}

/// The tools and the cycles of a program, in text order, while their motions are added in the order of execution.
struct Parts {
    /// The length of the program, bytes. Later blocks are from other files.
    own: u32,
    /// The tools, with their stations.
    tools: Vec<(u16, Work)>,
    cycles: Vec<Work>,
    /// The station in use, and the index of its tool.
    tool: Option<(u16, Option<usize>)>,
    /// The cycle of the last motion, which stays modal, with its index and the block of that motion.
    series: Option<(usize, Cycle, u32)>,
}

impl Parts {
    fn new(text: &[u8], outline: &Outline) -> Self {
        let tool = |entry: &Entry| Some((station(entry.name.of(text))?, Work::of(entry)));
        let tools = outline.entries.iter().filter(|entry| entry.kind == Kind::Tool).filter_map(tool);
        let cycles = outline.entries.iter().filter(|entry| matches!(entry.kind, Kind::Cycle(_)));
        let mut parts = Self {
            own: text.len() as u32,
            tools: tools.collect(),
            cycles: cycles.map(Work::of).collect(),
            tool: None,
            series: None,
        };
        // The work of the last ones may continue where the outline of a very long program is cut off.
        if outline.is_cut {
            parts.tools.pop();
            parts.cycles.pop();
        }
        parts
    }

    fn add_all(&mut self, motions: &Motions, machine: &Machine) {
        for (index, motion) in motions.iter().enumerate() {
            let block = motions.span(index).start;
            self.add_to_tool(block, &motion, machine);
            self.add_to_cycle(block, &motion, machine);
        }
    }

    /// Adds a motion of the block at a byte to its tool, which stays in use in subprograms.
    fn add_to_tool(&mut self, block: u32, motion: &Motion, machine: &Machine) {
        let station = motion.process.tool.0;
        if self.tool.is_none_or(|(used, _)| used != station) {
            self.tool = Some((station, self.tool_before(block, station)));
        }
        if let Some((_, Some(tool))) = self.tool {
            self.tools[tool].1.add(motion, machine);
        }
    }

    /// The last tool of a station before a block, or its first one in the text.
    fn tool_before(&self, block: u32, station: u16) -> Option<usize> {
        let is_of = |index: &usize| self.tools[*index].0 == station;
        let before = self.tools.partition_point(|(_, tool)| tool.at <= block);
        (0..before).rev().find(is_of).or_else(|| (before..self.tools.len()).find(is_of))
    }

    fn add_to_cycle(&mut self, block: u32, motion: &Motion, machine: &Machine) {
        if motion.kind == MotionKind::Dwell && motion.cycle.is_none() {
            return;
        }
        let Some(step) = motion.cycle.filter(|_| block < self.own) else {
            self.series = None;
            return;
        };
        if let Ok(cycle) = self.cycles.binary_search_by_key(&block, |cycle| cycle.at) {
            let begins = self.series.is_none_or(|(_, _, last)| last != block);
            self.cycles[cycle].times += u32::from(begins);
            self.series = Some((cycle, step.cycle, block));
        }
        let Some((cycle, _, last)) = self.series.as_mut().filter(|(_, cycle, _)| *cycle == step.cycle) else {
            return;
        };
        *last = block;
        let work = &mut self.cycles[*cycle];
        work.add(motion, machine);
        if has_passes(step.cycle) {
            work.passes.add(step);
        }
    }
}

/// The station of a T word.
fn station(word: &[u8]) -> Option<u16> {
    let digits = word.iter().skip(1).map(|byte| char::from(*byte)).filter(char::is_ascii_digit);
    let number = digits.collect::<String>().parse::<u16>().ok()?;
    Some(if number > 99 { number / 100 } else { number })
}

/// The lens of a block that moves; without passes if it is executed several times, and without a time if that of a
/// cut is unknown.
fn lens(asked: &Asked, work: &Work) -> Option<CodeLens> {
    let passes = Some(work.passes.count()).filter(|count| *count > 0 && work.times == 1);
    let seconds = (work.motions > 0 && work.time.unknown_cuts == 0).then(|| work.time.estimated());
    let title = server::work(passes, seconds, asked.language)?;
    let line = Span { start: work.at, end: line_end(asked.text(), work.at as usize) as u32 };
    let command = Command { title, tooltip: None, command: String::new(), arguments: None };
    Some(CodeLens { range: asked.range(line), command: Some(command), data: None })
}
