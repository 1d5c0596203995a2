//! Everything a run needs that is not in the program text: the control, the tools, the
//! stock, the machine, the start.
//!
//! In: a setup as JSON (a file, the page's form), and what comments of the program say of it (`notes`). Out:
//! [`Setup`]. Lengths here are as people write them: X values are diameters, mm.

pub mod as_comments;
pub mod dialect;
pub mod draft;
pub mod fields;
pub mod invalid;
pub mod machine;
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
use dialect::DialectChoice;
pub use machine::{Machine, Tailstock, Travel, Turret};
pub use side::Side;
pub use stock::{DescribedStock, Stock};
pub use tool::{Tool, ToolKind};

/// A setup as written: every key optional, an unknown key is an error that names it.
#[derive(Debug, Default, PartialEq, Deserialize)]
#[serde(default, deny_unknown_fields, rename_all = "camelCase")]
pub struct Setup {
    /// The control and its switches.
    pub dialect: DialectChoice,
    /// Where the tool tip stands before the first block.
    pub initial: Option<Position>,
    /// Tools by their T word in four digits (`T0101`).
    pub tools: BTreeMap<String, Tool>,
    /// What prose in comments says of tools, by turret station: a hint for inferring them. Never in a file,
    /// and of a run only in the setup for its machine (`Run::setup_at_machine`).
    #[serde(skip)]
    pub described_tools: BTreeMap<u16, Tool>,
    /// The same of the blank.
    #[serde(skip)]
    pub described_stock: DescribedStock,
    /// The blank.
    pub stock: Option<Stock>,
    /// The centre of the tailstock, where the work is held by one.
    pub tailstock: Option<Tailstock>,
    /// What the machine can do.
    pub machine: Machine,
    /// Levels of block skip (`/` and `/1` to `/9`) that are switched on: such blocks are ignored.
    pub block_skip: Vec<u8>,
    /// Number of the O program to run; the first of the text when nothing is said.
    pub program: Option<u32>,
    /// What a run may use up.
    pub limits: Limits,
    /// The severity of a rule, or of a group of rules.
    pub rules: Levels,
    /// The severity of rules whatever comments in the program say. Never in a file.
    #[serde(skip)]
    pub forced_rules: Levels,
    /// Whether lints listen to the run.
    pub lints: Lints,
    /// Values of variables that a reader tries. Never in a file.
    #[serde(skip)]
    pub tried: Vec<TriedValue>,
}

/// What if a variable had another value: it gets it before a block, one of the times that is carried out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TriedValue {
    /// First byte of the block.
    pub block: u32,
    /// Which of the times it is carried out, from 1.
    pub time: u32,
    /// Number of the variable, local ones as the block sees them.
    pub variable: u32,
    /// Its value from there on.
    pub value: f64,
}

/// Whether lints listen to a run: what an instructor would say though the control runs it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Lints {
    /// They do.
    #[default]
    On,
    /// None does, and the run costs nothing for them.
    Off,
}

impl Clone for Setup {
    /// A setup has tools only once the part that reads and describes them has been loaded: it copies them.
    fn clone(&self) -> Self {
        let mut setup = Self {
            dialect: self.dialect.clone(),
            initial: self.initial,
            tools: BTreeMap::new(),
            described_tools: BTreeMap::new(),
            described_stock: self.described_stock,
            stock: self.stock,
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
    /// Reads a setup from JSON; what says more than `{}` needs the part `Early` of the module. The error says what is wrong and where, and names an unknown key or a limit
    /// that is set too high.
    pub fn from_json(json: &str) -> Result<Self, String> {
        if json == "{}" { Ok(Self::default()) } else { read_json(json) }
    }

    /// Where the tip stands at the start: X200 Z200 when nothing is said.
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

/// The last key of a JSON text before a place (line and column from 1), in quotes: what an error is about.
fn key_before(json: &str, line: usize, column: usize) -> Option<&str> {
    let start: usize = json.split_inclusive('\n').take(line.checked_sub(1)?).map(str::len).sum();
    let end = (start + column).min(json.len());
    let before = json.get(..end)?;
    let colon = before.rfind(':')?;
    let name = before[..colon].trim_end().strip_suffix('"')?;
    Some(&before[name.rfind('"')?..=name.len()])
}

/// A place as people write it.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Position {
    /// Diameter, mm.
    pub x: Diameter,
    /// Length, mm.
    pub z: f64,
}
