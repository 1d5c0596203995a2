//! The input of a run besides the program text: the control, the tools, the stock, the machine, the start.
//!
//! In: a setup as JSON (a file, or the form of the page), and setup comments of the program (`notes`). Out:
//! [`Setup`]. Lengths are in the notation of users: X values are diameters, mm.

pub mod as_comments;
pub mod blank;
pub mod dialect;
pub mod draft;
pub mod fields;
mod first_unit;
pub mod ignored;
pub mod invalid;
pub mod machine;
mod nose_comment;
pub mod notes;
pub mod profile;
mod side;
pub mod stock;
pub mod thread_insert;
pub mod tool;
pub mod tool_words;

use std::collections::BTreeMap;

use serde::Deserialize;

use crate::limits::Limits;
use crate::message::Levels;
use crate::parts::early;
use crate::units::Diameter;
pub use blank::Blank;
use dialect::DialectChoice;
pub use machine::{Machine, Tailstock, Travel, Turret};
pub use nose_comment::DescribedNose;
pub use side::Side;
pub use stock::{DescribedStock, Stock};
pub use tool::{Tool, ToolKind};

/// A setup as written. Every key is optional; an unknown key is an error that names it.
#[derive(Debug, Default, PartialEq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[serde(default, deny_unknown_fields, rename_all = "camelCase")]
pub struct Setup {
    /// The control and its switches.
    pub dialect: DialectChoice,
    /// Position of the tool tip before the first block.
    pub initial: Option<Position>,
    /// Tools by their T word in four digits (`T0101`).
    #[cfg_attr(feature = "cli", schemars(extend("propertyNames" = {"pattern": "^[Tt][0-9]{1,4}$"})))]
    pub tools: BTreeMap<String, Tool>,
    /// Tools described by prose in comments, by turret station: a hint for inference. Never in a file; a run
    /// has them only in the setup for its machine (`Run::setup_at_machine`).
    #[serde(skip)]
    pub described_tools: BTreeMap<u16, Tool>,
    /// The noses of tools described by prose in comments: compensation uses them if `tools` lacks the tool.
    /// Never in a file.
    #[serde(skip)]
    pub described_noses: Vec<DescribedNose>,
    /// The blank described by prose in comments.
    #[serde(skip)]
    pub described_stock: DescribedStock,
    /// The blank.
    #[cfg_attr(feature = "cli", schemars(with = "Option<blank::WrittenBlank>"))]
    pub stock: Option<Blank>,
    /// The centre of the tailstock, if it supports the workpiece.
    pub tailstock: Option<Tailstock>,
    /// The machine.
    pub machine: Machine,
    /// Levels of block skip (`/` and `/1` to `/9`) that are switched on: such blocks are ignored.
    pub block_skip: Vec<u8>,
    /// Number of the O program to run; by default the first program of the text.
    #[cfg_attr(feature = "cli", schemars(range(max = u32::MAX)))]
    pub program: Option<u32>,
    /// The limits of a run.
    pub limits: Limits,
    /// The severity of a rule, or of a group of rules.
    pub rules: Levels,
    /// Severities that override comments in the program. Never in a file.
    #[serde(skip)]
    pub forced_rules: Levels,
    /// Whether lints observe the run.
    pub lints: Lints,
    /// Values of variables that the reader tries. Never in a file.
    #[serde(skip)]
    pub tried: Vec<TriedValue>,
}

/// A trial value for a variable, assigned before one execution of a block.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TriedValue {
    /// First byte of the block.
    pub block: u32,
    /// Which execution of the block, from 1.
    pub time: u32,
    /// Number of the variable; a local variable in the scope of the block.
    pub variable: u32,
    /// The trial value.
    pub value: f64,
}

/// Whether lints observe a run: they report what an instructor would, although the control accepts it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema), schemars(inline))]
#[serde(rename_all = "lowercase")]
pub enum Lints {
    /// All lints observe the run.
    #[default]
    On,
    /// No lint observes the run, and they cost nothing.
    Off,
}

impl Clone for Setup {
    /// A setup has tools only after the part that reads and describes them has been loaded; that part copies
    /// them.
    fn clone(&self) -> Self {
        let mut setup = Self {
            dialect: self.dialect.clone(),
            initial: self.initial,
            tools: BTreeMap::new(),
            described_tools: BTreeMap::new(),
            described_noses: self.described_noses.clone(),
            described_stock: self.described_stock,
            stock: self.stock.clone(),
            tailstock: self.tailstock,
            machine: self.machine,
            block_skip: self.block_skip.clone(),
            program: self.program,
            limits: self.limits,
            rules: self.rules.clone(),
            forced_rules: self.forced_rules.clone(),
            lints: self.lints,
            tried: self.tried.clone(),
        };
        if !self.tools.is_empty() || !self.described_tools.is_empty() {
            copy_tools(self, &mut setup);
        }
        setup
    }
}

impl Setup {
    /// Reads a setup from JSON. Anything but `{}` needs the part `Early` of the module. The error says what
    /// is wrong and where, and names an unknown key or a limit that is set too high.
    pub fn from_json(json: &str) -> Result<Self, String> {
        if json == "{}" { Ok(Self::default()) } else { read_json(json) }
    }

    /// The tool of a station and an offset number.
    pub fn tool(&self, called: (u16, u16)) -> Option<&Tool> {
        self.tools.get(&tool_word(called))
    }

    /// The given bar or tube, or that around the outline of the given blank.
    pub fn extents(&self) -> Option<Stock> {
        self.stock.as_ref().map(Blank::extents)
    }

    /// The nose of a tool that a comment describes.
    pub fn described_nose(&self, station: u16) -> Option<&DescribedNose> {
        self.described_noses.iter().find(|nose| nose.station == station)
    }

    /// Position of the tip at the start: X200 Z200 by default.
    pub fn start(&self) -> Position {
        self.initial.unwrap_or(Position { x: Diameter::new(200.0), z: 200.0 })
    }
}

early! {
    fn copy_tools(from: &Setup, to: &mut Setup) {
        (to.tools, to.described_tools) = (from.tools.clone(), from.described_tools.clone());
    }

    fn read_json(json: &str) -> Result<Setup, String> {
        let setup: Setup = serde_json::from_str(json).map_err(|error| {
            match key_before(json, error.line(), error.column()) {
                Some(key) => format!("{key}: {error}"),
                None => error.to_string(),
            }
        })?;
        setup.limits.check()?;
        if let Some(name) = setup.tools.keys().find(|name| notes::tool_name(name).is_none()) {
            return Err(format!("tools.{name}: a tool is named by T and four digits, such as T0101"));
        }
        Ok(setup)
    }
}

/// The last key, in quotes, before a place (line and column from 1) of a JSON text: the key that an error is
/// about.
fn key_before(json: &str, line: usize, column: usize) -> Option<&str> {
    let start: usize = json.split_inclusive('\n').take(line.checked_sub(1)?).map(str::len).sum();
    let end = (start + column).min(json.len());
    let before = json.get(..end)?;
    let colon = before.rfind(':')?;
    let name = before[..colon].trim_end().strip_suffix('"')?;
    Some(&before[name.rfind('"')?..=name.len()])
}

/// The T word of a station and an offset, in four digits: the key of a tool.
pub fn tool_word((station, offset): (u16, u16)) -> String {
    format!("T{station:02}{offset:02}")
}

/// A position in the notation of users.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Position {
    /// Diameter, mm.
    pub x: Diameter,
    /// Z, mm.
    pub z: f64,
}
