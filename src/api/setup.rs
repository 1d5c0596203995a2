//! The rows of the setup form: given values, assumed values, and errors in the entries.
//!
//! In: the given setup, the inferred one, the entries of a form. Out: rows for a page that knows nothing of
//! tools and stock.

use crate::order;
use std::collections::BTreeMap;

use serde::Serialize;

#[cfg(target_arch = "wasm32")]
use tsify::Tsify;

use super::{Edit, Places, rounded_to_thousandth};
use crate::machine::defaults::with_defaults;
use crate::machine::resolved_setup::{Basis, ResolvedSetup};
use crate::message::{Levels, Severity};
use crate::motion::Motions;
use crate::playback::timing::ASSUMED_RAPID;
use crate::sentences::{Language, labels};
use crate::setup::as_comments::{self, Change};
use crate::setup::dialect::{DecimalChoice, DecimalRule, Dialect, DialectChoice, GSystem};
use crate::setup::draft::{self, Draft, Entry as Entered, NO_STOCK, NO_TAILSTOCK};
use crate::setup::fields::{self, Entry, Field, Value};
use crate::setup::notes::{Notes, tool_name};
use crate::setup::{Blank, Machine, Setup, Stock, Tool, ToolKind};
use crate::units::{Diameter, Unit};

/// Key of the outline of the blank.
const OUTLINE_KEY: &str = "stock.outline";

/// Which of stock and tools are given, and which are inferred.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct SetupOverview {
    /// Whether the blank is given; absent without a blank.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "\"given\" | \"inferred\""))]
    pub stock: Option<&'static str>,
    /// Diameter and length of the blank, mm.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "readonly [number, number]"))]
    pub blank: Option<[f64; 2]>,
    /// X (a diameter) and Z of the tool before the first motion, mm.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional, type = "readonly [number, number]"))]
    pub start: Option<[f64; 2]>,
    /// The tools in use.
    pub tools: Vec<ToolOverview>,
}

/// A tool in use.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct ToolOverview {
    /// Turret station; 0 before the first T word.
    pub station: u16,
    /// The kind of tool, as text.
    pub kind: String,
    /// Whether it is given.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "\"given\" | \"inferred\""))]
    pub known: &'static str,
}

/// The initial state of the form.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct SetupForm {
    /// The groups, in display order.
    pub groups: Vec<SetupGroup>,
    /// Where the setup is stored.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "SetupPlace"))]
    pub place: &'static str,
}

/// A group of fields.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct SetupGroup {
    /// The group.
    #[cfg_attr(
        target_arch = "wasm32",
        tsify(
            type = "\"stock\" | \"tool\" | \"start\" | \"machine\" | \"tailstock\" | \"control\" | \"rules\""
        )
    )]
    pub group: &'static str,
    /// Its title.
    pub title: String,
    /// The source of the values: a comment of the program, the page, or none.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "SetupPlace | \"nobody\""))]
    pub source: &'static str,
    /// Its fields.
    pub fields: Vec<SetupField>,
}

/// A field of the form.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct SetupField {
    /// Its key in a setup: `stock.diameter`.
    pub key: String,
    /// Its label.
    pub label: String,
    /// Its unit.
    pub unit: String,
    /// The type of entry.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "\"number\" | \"text\" | \"choice\""))]
    pub entry: &'static str,
    /// The choices.
    pub choices: Vec<SetupChoice>,
    /// The given value; empty if none is given.
    pub value: String,
}

/// A choice.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct SetupChoice {
    /// The value to store.
    pub value: String,
    /// The text to show.
    pub text: String,
}

/// What to show for the entries, and what to store.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct SetupAnswer {
    /// The state of each entry, in order.
    pub fields: Vec<SetupState>,
    /// The resulting setup of the page, as JSON; empty if it is empty.
    pub setup: String,
    /// Edits to the program.
    pub edits: Vec<Edit>,
}

/// The state of a field.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(target_arch = "wasm32", derive(Tsify))]
pub struct SetupState {
    /// Its key.
    pub key: String,
    /// The assumed value if the field is empty; empty if there is none.
    pub assumed: String,
    /// The error in the entry.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(target_arch = "wasm32", tsify(optional))]
    pub error: Option<String>,
    /// Whether the field is used by this kind of tool.
    #[cfg_attr(target_arch = "wasm32", tsify(type = "\"shown\" | \"hidden\""))]
    pub shown: &'static str,
}

/// Where a setup is stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SetupPlace {
    /// In comments of the program.
    Program,
    /// In the setup of the page.
    Page,
}

impl SetupPlace {
    /// The name in rows.
    pub fn name(self) -> &'static str {
        match self {
            Self::Program => "program",
            Self::Page => "page",
        }
    }

    /// The place with this name; [`Self::Page`] for any other name.
    pub fn of(name: &str) -> Self {
        if name == "program" { Self::Program } else { Self::Page }
    }
}

/// The input for a form.
pub struct FormInput<'a> {
    /// The setup of the page with the additions from comments.
    pub given: &'a Setup,
    /// The setup of the page, without comments.
    pub page: &'a Setup,
    /// The additions from comments.
    pub notes: &'a Notes,
    /// The setup inferred from the program.
    pub inferred: &'a Setup,
    /// What numbers without a decimal point count in the run.
    pub decimal: DecimalRule,
    /// The G-code system that was recognised in the program.
    pub system: Option<GSystem>,
    /// The unit that was recognised in the program, if no code selects it.
    pub unit: Option<Unit>,
    /// The language of labels.
    pub language: Language,
}

impl SetupOverview {
    /// The overview of a resolved setup, and of a program's motions.
    pub fn new(resolved: &ResolvedSetup, motions: &Motions, language: Language) -> Self {
        let name = |basis: Basis| match basis {
            Basis::Given => "given",
            Basis::Inferred | Basis::Unknown => "inferred",
        };
        let tools = resolved.tools().map(|tool| ToolOverview {
            station: tool.station,
            kind: labels::tool_kind(tool.tool.kind.unwrap_or(ToolKind::Turning), language).into(),
            known: name(tool.basis),
        });
        let start = (!motions.is_empty()).then(|| motions.get(0).at_tip().from);
        Self {
            stock: resolved.stock().map(|stock| name(stock.1)),
            blank: resolved
                .stock()
                .map(|(stock, _)| [stock.diameter.mm(), stock.length].map(rounded_to_thousandth)),
            start: start.map(|at| [Diameter::from_radius(at.x).mm(), at.z].map(rounded_to_thousandth)),
            tools: tools.collect(),
        }
    }
}

impl FormInput<'_> {
    /// The initial state of the form.
    pub fn form(&self) -> SetupForm {
        let given = self.given;
        let mut groups = vec![self.stock()];
        let mut names: Vec<&String> = self.inferred.tools.keys().collect();
        // A given tool replaces an inferred one of the same station.
        names.retain(|name| given.tools.keys().all(|own| own.get(..3) != name.get(..3)));
        names.extend(given.tools.keys());
        order::by(&mut names, Ord::cmp);
        groups.extend(names.into_iter().map(|name| self.tool(name)));
        let start = given.initial.as_ref();
        groups.push(self.group("start", "initial.", fields::START, start, start.is_some()));
        let is_said = given.machine != Machine::default();
        groups.push(self.group("machine", "machine.", fields::MACHINE, Some(&given.machine), is_said));
        let tailstock = given.tailstock.as_ref();
        groups.push(self.group("tailstock", "tailstock.", fields::TAILSTOCK, tailstock, tailstock.is_some()));
        let dialect = &given.dialect;
        let is_said = fields::values(fields::DIALECT, dialect).next().is_some();
        groups.push(self.group("control", "dialect.", fields::DIALECT, Some(dialect), is_said));
        let rules = &given.rules;
        groups.push(self.group("rules", "rules.", fields::RULES, Some(rules), !rules.is_empty()));
        let place = if self.notes.spans().next().is_some() { SetupPlace::Program } else { SetupPlace::Page };
        SetupForm { groups, place: place.name() }
    }

    /// Fields for one more tool; `None` if `word` is not a T word.
    pub fn another_tool(&self, word: &str) -> Option<SetupGroup> {
        let word = word.trim();
        let digits = word.strip_prefix(['T', 't']).unwrap_or(word);
        tool_name(&format!("T{digits}")).map(|name| self.tool(&name))
    }

    /// The sizes of a bar or tube, and the points of an outline, which replaces the sizes.
    fn stock(&self) -> SetupGroup {
        let blank = self.given.stock.as_ref();
        let outline = blank.and_then(Blank::outline);
        let sizes = blank.map(Blank::extents).map(|stock| match outline {
            Some(_) => Stock { grip: stock.grip, ..NO_STOCK },
            None => stock,
        });
        let mut group = self.group("stock", "stock.", fields::STOCK, sizes.as_ref(), blank.is_some());
        group.fields.push(SetupField {
            key: OUTLINE_KEY.into(),
            label: labels::field(fields::Name::Outline, self.language).into(),
            unit: labels::unit(fields::Unit::Millimetre, self.language).into(),
            entry: "text",
            choices: Vec::new(),
            value: outline.map(ToString::to_string).unwrap_or_default(),
        });
        group
    }

    fn tool(&self, name: &str) -> SetupGroup {
        let given = self.given.tools.get(name);
        let prefix = format!("tools.{name}.");
        let group = self.group("tool", &prefix, fields::TOOL, given, given.is_some());
        SetupGroup { title: labels::tool(name, self.language), ..group }
    }

    fn group<T>(
        &self,
        group: &'static str,
        prefix: &str,
        fields: &'static [Field<T>],
        own: Option<&T>,
        is_given: bool,
    ) -> SetupGroup {
        let source = match (is_given, self.notes.names(prefix)) {
            (_, true) => SetupPlace::Program.name(),
            (true, false) => SetupPlace::Page.name(),
            (false, false) => "nobody",
        };
        let rows = fields.iter().map(|field| {
            let choices: &[&'static str] = match field.entry {
                Entry::Choice(choices) => choices,
                Entry::Switch => fields::SWITCH,
                _ => &[],
            };
            let unit = match field.entry {
                Entry::Number(unit) => labels::unit(unit, self.language),
                _ => "",
            };
            SetupField {
                key: format!("{prefix}{}", field.key),
                label: labels::field(field.name, self.language).into(),
                unit: unit.into(),
                entry: match field.entry {
                    Entry::Number(_) | Entry::Whole => "number",
                    Entry::Text => "text",
                    Entry::Choice(_) | Entry::Switch => "choice",
                },
                choices: choices
                    .iter()
                    .map(|value| SetupChoice {
                        value: (*value).into(),
                        text: labels::choice(field.name, value, self.language).into(),
                    })
                    .collect(),
                value: own
                    .and_then(|own| (field.get)(own))
                    .map_or_else(String::new, |value| value.to_string()),
            }
        });
        let title = labels::group(group, self.language).into();
        SetupGroup { group, title, source, fields: rows.collect() }
    }

    /// Checks entries, and returns the changes that store them in `keep`; `json` is the current setup of the
    /// page.
    pub fn answer(
        &self,
        entries: &[Entered],
        keep: SetupPlace,
        json: &str,
        text: &[u8],
        places: &Places,
    ) -> SetupAnswer {
        let draft = Draft::read(entries, self.given, self.inferred);
        let assumed = self.assumed(entries, &draft);
        let (lines, page) = match keep {
            SetupPlace::Program => (as_comments::lines(&draft.setup), self.covered(&draft.setup)),
            SetupPlace::Page => (Vec::new(), draft.setup.clone()),
        };
        let fields = entries.iter().map(|entry| {
            let error = draft.errors.iter().find(|error| error.0 == entry.key);
            let shown = assumed.get(&entry.key);
            SetupState {
                key: entry.key.clone(),
                assumed: shown.cloned().flatten().unwrap_or_default(),
                error: error.map(|error| labels::entry_error(error.1, self.language)),
                shown: if shown.is_some() || !entry.text.trim().is_empty() { "shown" } else { "hidden" },
            }
        });
        let edits = as_comments::changes(text, &lines);
        SetupAnswer {
            fields: fields.collect(),
            setup: draft::put_into_json(json, &page),
            edits: edits.into_iter().map(|Change { span, insert }| places.edit(span, insert)).collect(),
        }
    }

    /// The values of the page's setup that the comments override. They are kept, so that undo in the editor
    /// restores them.
    fn covered(&self, written: &Setup) -> Setup {
        let page = self.page;
        let machine = if written.machine == Machine::default() { Machine::default() } else { page.machine };
        let mut tools = page.tools.clone();
        tools.retain(|name, _| written.tools.contains_key(name));
        Setup {
            stock: written.stock.as_ref().and(page.stock.clone()),
            tailstock: written.tailstock.and(page.tailstock),
            initial: written.initial.and(page.initial),
            machine,
            tools,
            dialect: fields::covered(fields::DIALECT, &written.dialect, &page.dialect),
            rules: if written.rules.is_empty() { Levels::default() } else { page.rules.clone() },
            ..Setup::default()
        }
    }

    /// The assumed value of each field that is in use, if the field is empty.
    fn assumed(&self, entries: &[Entered], draft: &Draft) -> BTreeMap<String, Option<String>> {
        let mut all = BTreeMap::new();
        let language = self.language;
        let stock = draft::stock_base(self.given, self.inferred);
        put(&mut all, "stock.", fields::STOCK, &stock, language);
        all.insert(OUTLINE_KEY.into(), None);
        put(&mut all, "initial.", fields::START, &draft::start_base(), language);
        put(&mut all, "tailstock.", fields::TAILSTOCK, &NO_TAILSTOCK, language);
        let rapid = Some(ASSUMED_RAPID);
        let machine = Machine { rapid_x: rapid, rapid_z: rapid, y_axis: Some(false), ..Machine::default() };
        put(&mut all, "machine.", fields::MACHINE, &machine, language);
        for (key, usual) in [("stock.bore", "0"), ("stock.face", "0")] {
            let place = all.entry(key.into()).or_insert(None);
            place.get_or_insert_with(|| usual.into());
        }
        let rear = labels::choice(fields::Name::Turret, "rear", language);
        all.insert("machine.turret".into(), Some(rear.into()));
        put(&mut all, "dialect.", fields::DIALECT, &self.in_force(draft), language);
        let holds = labels::choice(fields::Name::Decimal, DecimalChoice::from(self.decimal).name(), language);
        all.insert("dialect.decimal".into(), Some(holds.into()));
        put(&mut all, "rules.", fields::RULES, &Levels::default(), language);
        all.insert("rules.classroom".into(), Some(labels::severity(Severity::Off, language).into()));
        let mut last = "";
        for entry in entries {
            let Some((name, _)) = entry.key.strip_prefix("tools.").and_then(|rest| rest.split_once('.'))
            else {
                continue;
            };
            if name == last {
                continue;
            }
            last = name;
            let own = draft.setup.tools.get(name).or_else(|| self.inferred.tools.get(name));
            let tool = with_defaults(own.unwrap_or(&Tool::default()));
            let kind = tool.kind.unwrap_or(ToolKind::Turning);
            let of_use = |field: &&Field<Tool>| field.is_for(kind);
            for field in fields::TOOL.iter().filter(of_use) {
                let value = (field.get)(&tool).map(|value| in_words(field, value, language));
                all.insert(format!("tools.{name}.{}", field.key), value);
            }
        }
        all
    }

    /// The defaults of the control switches, for the control that is entered.
    fn in_force(&self, draft: &Draft) -> DialectChoice {
        let entered = &draft.setup.dialect;
        let dialect = Dialect::new(entered);
        DialectChoice {
            control: Some(dialect.control),
            g_system: entered.g_system.or(self.system).or(Some(dialect.g_system)),
            unit: entered.unit.or(self.unit).or(Some(dialect.unit)),
            feed_mode: Some(dialect.feed_mode),
            pq_unit: Some(dialect.pq_unit),
            ref_point: Some(dialect.ref_point),
            recognise: Some(entered.recognise.unwrap_or(true)),
            strict: Some(dialect.strict),
            type_ii: Some(dialect.type_ii),
            negative_arc_r: Some(dialect.negative_arc_r),
            ..DialectChoice::default()
        }
    }
}

fn put<T>(
    all: &mut BTreeMap<String, Option<String>>,
    prefix: &str,
    fields: &'static [Field<T>],
    own: &T,
    language: Language,
) {
    for field in fields {
        let value = (field.get)(own).map(|value| in_words(field, value, language));
        all.insert(format!("{prefix}{}", field.key), value);
    }
}

/// A value as text; a choice by its translated name.
fn in_words<T>(field: &Field<T>, value: Value, language: Language) -> String {
    match (field.entry, value) {
        (Entry::Choice(choices), Value::Text(text)) => {
            let own = choices.iter().find(|choice| **choice == text);
            own.map_or(text, |own| labels::choice(field.name, own, language).into())
        }
        (_, Value::Number(number)) => crate::units::number(number),
        (_, Value::Switch(is_on)) => {
            labels::choice(field.name, fields::SWITCH[usize::from(!is_on)], language).into()
        }
        (_, value) => value.to_string(),
    }
}
