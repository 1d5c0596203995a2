//! A setup as the state of a form: one text for each key, possibly invalid or empty.
//!
//! In: the entries, and the defaults for empty fields. Out: the setup, and the error of each entry; the setup
//! as JSON, merged into a JSON text whose other keys are kept. The requirements on values are in `invalid`.

use crate::order;
use serde_json::{Map, Value as Json};

use super::blank::Outline;
use super::fields::{self, Field, Name, ReadError, Value};
use super::invalid::Requirement;
use super::{Blank, Machine, Position, Setup, Stock, Tailstock, Tool};
use crate::message::{Levels, Severity, levels};
use crate::setup::dialect::DialectChoice;
use crate::units::Diameter;

/// The content of a field of the form.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entry {
    /// Key as in JSON: `stock.diameter`, `tools.T0101.width`, `machine.travel.xMin`.
    pub key: String,
    /// Text as typed; blank for the default.
    pub text: String,
}

/// Why an entry is wrong.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum EntryError {
    /// It cannot be read.
    Unreadable(ReadError),
    /// It is empty, and there is no default.
    Missing,
    /// The value is invalid.
    Unmet(Requirement),
    /// The outline of the blank gives this size.
    OfOutline,
}

/// The content of a form.
#[derive(Clone, Debug, PartialEq)]
pub struct Draft {
    /// Stock, tools, tailstock, machine, start, rules and switches of the control, as they would be saved.
    pub setup: Setup,
    /// Errors, by key.
    pub errors: Vec<(String, EntryError)>,
}

/// Placeholder for an unknown length. It only occurs in forms, a setup has no notation for it.
const UNKNOWN: f64 = f64::INFINITY;

/// A blank with unknown sizes.
pub const NO_STOCK: Stock = Stock {
    diameter: Diameter::new(UNKNOWN),
    bore: Diameter::new(0.0),
    face: 0.0,
    length: UNKNOWN,
    grip: None,
};

/// A tailstock of unknown position with the usual quill.
pub const NO_TAILSTOCK: Tailstock = Tailstock { z: UNKNOWN, diameter: Diameter::new(20.0) };

impl Draft {
    /// Reads a form. If only some fields of a group are filled in, the others have the values that the form
    /// showed as assumed: defaults for the `given` tools and blanks, inferred values for others.
    pub fn read(entries: &[Entry], given: &Setup, inferred: &Setup) -> Self {
        let mut form = FormReader { entries, errors: Vec::new() };
        let rules = single_rules(entries, given.rules.clone().without_groups());
        let mut setup = Setup {
            stock: form.blank(stock_base(given, inferred)),
            tailstock: form.group("tailstock.", fields::TAILSTOCK, NO_TAILSTOCK),
            machine: form.group("machine.", fields::MACHINE, Machine::default()).unwrap_or_default(),
            initial: form.group("initial.", fields::START, start_base()),
            rules: form.group("rules.", fields::RULES, rules.clone()).unwrap_or(rules),
            dialect: form.group("dialect.", fields::DIALECT, DialectChoice::default()).unwrap_or_default(),
            ..Setup::default()
        };
        for name in form.tools() {
            let prefix = format!("tools.{name}.");
            let base = if given.tools.contains_key(&name) { None } else { inferred.tools.get(&name) };
            let base = base.cloned().unwrap_or_default();
            let tool = form.group(&prefix, fields::TOOL, form.matching_base(&prefix, base));
            setup.tools.extend(tool.map(|tool| (name, tool)));
        }
        let mut errors = form.errors;
        let told = |key: &str, errors: &[(String, EntryError)]| errors.iter().any(|error| error.0 == key);
        for invalid in setup.clone().without_invalid_values().1 {
            if !told(&invalid.key, &errors) {
                errors.push((invalid.key, EntryError::Unmet(invalid.requirement)));
            }
        }
        Self { setup, errors }
    }
}

/// The levels of single rules, which have no fields in the form. Only rules with an entry change: a page that
/// hides a rule writes `off`, and an empty text to restore the rule's own level.
fn single_rules(entries: &[Entry], mut levels: Levels) -> Levels {
    for Entry { key, text } in entries {
        let Some(rule) = key.strip_prefix("rules.").and_then(levels::known) else { continue };
        match Severity::named(text.trim()) {
            Some(level) => {
                levels.set(rule, level);
            }
            None => levels.unset(rule),
        }
    }
    levels.without_groups()
}

/// The values assumed for the empty fields of a blank.
pub fn stock_base(given: &Setup, inferred: &Setup) -> Stock {
    let inferred = inferred.extents().unwrap_or(NO_STOCK);
    match &given.stock {
        // The sizes of the outline.
        Some(blank) if blank.outline().is_some() => Stock { grip: None, ..blank.extents() },
        Some(_) => Stock { bore: Diameter::default(), face: 0.0, ..inferred },
        None => inferred,
    }
}

/// The default start position.
pub fn start_base() -> Position {
    Setup::default().start()
}

/// The entries, and the errors found in them.
struct FormReader<'a> {
    entries: &'a [Entry],
    errors: Vec<(String, EntryError)>,
}

impl<'a> FormReader<'a> {
    /// The entries of a group that are not blank: the rest of the key, and the text.
    fn entered<'k>(&self, prefix: &'k str) -> impl Iterator<Item = (&'a str, &'a str)> + use<'a, 'k> {
        let filled = self.entries.iter().filter(|entry| !entry.text.trim().is_empty());
        filled.filter_map(move |entry| Some((entry.key.strip_prefix(prefix)?, entry.text.trim())))
    }

    /// A group with its entries applied to the assumed values; `None` if no field is filled in.
    fn group<T>(&mut self, prefix: &str, fields: &[Field<T>], base: T) -> Option<T> {
        let mut own = base;
        let entered: Vec<_> = self.entered(prefix).collect();
        if entered.is_empty() {
            return None;
        }
        for (key, text) in entered {
            let Some(field) = fields.iter().find(|field| field.key == key) else { continue };
            match field.entry.read(text) {
                Ok(value) => (field.set)(&mut own, &value),
                Err(error) => self.errors.push((format!("{prefix}{key}"), EntryError::Unreadable(error))),
            }
        }
        let mut whole = true;
        for field in fields.iter().filter(|field| field.name.is_needed() && (field.get)(&own).is_none()) {
            whole = false;
            let key = format!("{prefix}{}", field.key);
            if self.errors.iter().all(|error| error.0 != key) {
                self.errors.push((key, EntryError::Missing));
            }
        }
        whole.then_some(own)
    }

    /// The blank: a bar or tube, or an outline, which leaves only the clamping length to enter.
    fn blank(&mut self, base: Stock) -> Option<Blank> {
        const PREFIX: &str = "stock.";
        let outline = self.entered(PREFIX).find(|(key, _)| *key == fields::OUTLINE).map(|found| found.1);
        let Some(text) = outline else {
            return self.group(PREFIX, fields::STOCK, base).map(Blank::from);
        };
        let replaced: Vec<_> = self.entered(PREFIX).map(|(key, _)| key).collect();
        for field in fields::STOCK.iter().filter(|field| field.name != Name::Grip) {
            if replaced.contains(&field.key) {
                self.errors.push((format!("{PREFIX}{}", field.key), EntryError::OfOutline));
            }
        }
        let grip = self.group(PREFIX, fields::OUTLINED, NO_STOCK).and_then(|stock| stock.grip);
        let outline = Outline::read(text);
        if outline.is_none() {
            let error = EntryError::Unreadable(ReadError::NotAnOutline);
            self.errors.push((format!("{PREFIX}{}", fields::OUTLINE), error));
        }
        outline.map(|outline| Blank::with_outline(outline, grip))
    }

    /// The names of the tools that have entries.
    fn tools(&self) -> Vec<String> {
        let mut names: Vec<String> =
            self.entered("tools.").filter_map(|(rest, _)| Some(rest.split_once('.')?.0.to_owned())).collect();
        order::by(&mut names, Ord::cmp);
        names.dedup();
        names
    }

    /// An inferred tool without the values that contradict the entries: nothing is left if the kind differs.
    fn matching_base(&self, prefix: &str, inferred: Tool) -> Tool {
        let entered =
            |wanted: &str| self.entered(prefix).find(|(key, _)| *key == wanted).map(|found| found.1);
        let other_kind = |kind: &str| inferred.kind.is_none_or(|own| !own.name().eq_ignore_ascii_case(kind));
        if entered("type").is_some_and(other_kind) {
            return Tool::default();
        }
        if entered("insert").is_some() {
            return Tool { insert: None, point_angle: None, edge_length: None, ..inferred };
        }
        inferred
    }
}

impl Name {
    /// Whether a group requires this field.
    pub fn is_needed(self) -> bool {
        matches!(
            self,
            Self::StockDiameter
                | Self::Length
                | Self::StartX
                | Self::StartZ
                | Self::CenterZ
                | Self::QuillDiameter
        )
    }
}

/// Puts stock, tools, tailstock, machine, start, rules and switches of the control into the JSON of another
/// setup. A JSON text that is not an object is replaced.
pub fn put_into_json(json: &str, setup: &Setup) -> String {
    let mut all = match serde_json::from_str(json) {
        Ok(Json::Object(all)) => all,
        _ => Map::new(),
    };
    // The form does not edit the other switches.
    let mut dialect = match all.remove("dialect") {
        Some(Json::Object(dialect)) => dialect,
        _ => Map::new(),
    };
    for field in fields::DIALECT {
        dialect.remove(field.key.split('.').next().unwrap_or(field.key));
    }
    dialect.extend(object(fields::DIALECT, &setup.dialect));
    let mut put = |key: &str, group: Map<String, Json>| {
        if group.is_empty() {
            all.remove(key);
        } else {
            all.insert(key.into(), Json::Object(group));
        }
    };
    put("dialect", dialect);
    put("stock", setup.stock.as_ref().map_or_else(Map::new, blank));
    let tools =
        setup.tools.iter().map(|(name, tool)| (name.clone(), Json::Object(object(fields::TOOL, tool))));
    put("tools", order::gathered(tools));
    put("tailstock", setup.tailstock.map_or_else(Map::new, |own| object(fields::TAILSTOCK, &own)));
    put("machine", object(fields::MACHINE, &setup.machine));
    let levels = setup.rules.iter().map(|(name, level)| (name.into(), level.name().into()));
    put("rules", order::gathered(levels));
    put("initial", setup.initial.map_or_else(Map::new, |start| object(fields::START, &start)));
    if all.is_empty() { String::new() } else { Json::Object(all).to_string() }
}

/// A blank as a JSON object.
fn blank(blank: &Blank) -> Map<String, Json> {
    let Some(outline) = blank.outline() else { return object(fields::STOCK, &blank.extents()) };
    let points = outline.points().iter().map(|point| [point.x.mm(), point.z].map(number));
    let points = points.map(|point| Json::Array(point.into())).collect();
    let mut object = object(fields::OUTLINED, &blank.extents());
    object.insert(fields::OUTLINE.into(), Json::Array(points));
    object
}

/// A number in JSON. A whole number is written without a fraction: `tip` accepts nothing else.
fn number(number: f64) -> Json {
    let is_whole = number.fract() == 0.0 && number.abs() < 1e15;
    if is_whole { Json::from(number as i64) } else { Json::from(number) }
}

/// A group as a JSON object. The first part of a key such as `travel.xMin` names a nested object.
fn object<T>(fields: &[Field<T>], own: &T) -> Map<String, Json> {
    let mut object = Map::new();
    for (field, value) in fields::values(fields, own) {
        let value = match value {
            Value::Number(value) => number(value),
            Value::Text(text) => Json::from(text),
            Value::Switch(is_on) => Json::from(is_on),
        };
        match field.key.split_once('.') {
            None => {
                object.insert(field.key.into(), value);
            }
            Some((outer, inner)) => {
                let place = object.entry(outer).or_insert_with(|| Json::Object(Map::new()));
                if let Json::Object(place) = place {
                    place.insert(inner.into(), value);
                }
            }
        }
    }
    object
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::setup::blank::OutlineFault;

    fn entries(list: &[(&str, &str)]) -> Vec<Entry> {
        list.iter().map(|(key, text)| Entry { key: (*key).into(), text: (*text).into() }).collect()
    }

    /// Checks the JSON and the errors of a list of entries, given an inferred setup.
    #[track_caller]
    fn check(list: &[(&str, &str)], inferred: &str, json: &str, errors: &[(&str, EntryError)]) {
        let inferred = Setup::from_json(inferred).expect("a setup");
        let draft = Draft::read(&entries(list), &Setup::default(), &inferred);
        let found: Vec<_> = draft.errors.iter().map(|(key, error)| (key.as_str(), *error)).collect();
        assert_eq!(found, errors);
        if errors.is_empty() {
            assert_eq!(put_into_json("{}", &draft.setup), json);
            let read = Setup::from_json(if json.is_empty() { "{}" } else { json });
            assert_eq!(read, Ok(draft.setup));
        }
    }

    #[test]
    fn what_is_left_empty_is_what_was_assumed() {
        let inferred = r#"{"stock": {"diameter": 60, "length": 75},
            "tools": {"T0303": {"type": "grooving", "side": "face"}}}"#;
        check(&[], inferred, "", &[]);
        check(&[("stock.diameter", " ")], inferred, "", &[]);
        check(&[("stock.diameter", "65,5")], inferred, r#"{"stock":{"diameter":65.5,"length":75}}"#, &[]);
        check(
            &[("tools.T0303.width", "4")],
            inferred,
            r#"{"tools":{"T0303":{"side":"face","type":"grooving","width":4}}}"#,
            &[],
        );
        check(
            &[("tools.T0303.type", "drill"), ("tools.T0303.diameter", "12")],
            inferred,
            r#"{"tools":{"T0303":{"diameter":12,"type":"drill"}}}"#,
            &[],
        );
        check(
            &[("machine.travel.xMin", "-5"), ("machine.turret", "front"), ("initial.x", "150")],
            inferred,
            r#"{"initial":{"x":150,"z":200},"machine":{"travel":{"xMin":-5},"turret":"front"}}"#,
            &[],
        );
    }

    #[test]
    fn an_outline_is_entered_as_points() {
        check(
            &[
                ("stock.outline", "X0 Z2 x30Z2 X=30,5 Z−20 Z-60"),
                ("stock.grip", "15"),
                ("stock.diameter", " "),
            ],
            "{}",
            r#"{"stock":{"grip":15,"outline":[[0,2],[30,2],[30.5,-20],[30.5,-60]]}}"#,
            &[],
        );
        // Without the outline the inferred blank is assumed, as without any entry.
        check(&[("stock.outline", ""), ("stock.grip", " ")], "{}", "", &[]);
        for text in ["round", "30 2 50 -60", "Z2 X50", "X30 Z2 X50", "X30 X40 Z2", "X Z", "="] {
            let error = EntryError::Unreadable(ReadError::NotAnOutline);
            check(&[("stock.outline", text)], "{}", "", &[("stock.outline", error)]);
        }
        check(
            &[("stock.diameter", "60"), ("stock.outline", "X30 Z2 X50 Z-60")],
            "{}",
            "",
            &[("stock.diameter", EntryError::OfOutline)],
        );
        check(
            &[("stock.outline", "X30 Z2 X-50 Z-60")],
            "{}",
            "",
            &[(
                "stock.outline",
                EntryError::Unmet(Requirement::Outline(OutlineFault::NegativeX {
                    point: 2,
                    x: Diameter::new(-50.0),
                })),
            )],
        );
    }

    /// Without its outline the blank is the bar around it.
    #[test]
    fn an_outline_can_be_replaced_by_a_bar() {
        let given = r#"{"stock": {"outline": [[30, 2], [50, -60]], "grip": 15}}"#;
        let given = Setup::from_json(given).expect("a setup");
        let base = stock_base(&given, &Setup::default());
        assert_eq!((base.diameter.mm(), base.face, base.length, base.grip), (50.0, 2.0, 62.0, None));
        let draft = Draft::read(&entries(&[("stock.grip", "15")]), &given, &Setup::default());
        assert_eq!(draft.errors, []);
        let json = r#"{"stock":{"diameter":50,"face":2,"grip":15,"length":62}}"#;
        assert_eq!(put_into_json("{}", &draft.setup), json);
    }

    #[test]
    fn each_slip_is_told_at_its_key() {
        check(
            &[("stock.diameter", "abc"), ("stock.length", "NaN")],
            "{}",
            "",
            &[
                ("stock.diameter", EntryError::Unreadable(ReadError::NotANumber)),
                ("stock.length", EntryError::Unreadable(ReadError::NotANumber)),
            ],
        );
        check(&[("stock.diameter", "60")], "{}", "", &[("stock.length", EntryError::Missing)]);
        check(
            &[("stock.diameter", "60"), ("stock.length", "80"), ("stock.bore", "70")],
            "{}",
            "",
            &[("stock.bore", EntryError::Unmet(Requirement::Below(60.0)))],
        );
        check(
            &[("tools.T0101.tip", "3.5"), ("tools.T0101.type", "hammer"), ("tools.T0101.insert", "(C)")],
            "{}",
            "",
            &[
                ("tools.T0101.tip", EntryError::Unreadable(ReadError::NotWhole)),
                ("tools.T0101.type", EntryError::Unreadable(ReadError::NotKnown)),
                ("tools.T0101.insert", EntryError::Unreadable(ReadError::NotKnown)),
            ],
        );
        check(
            &[("stock.diameter", "-1"), ("stock.length", "1e999")],
            r#"{"stock": {"diameter": 60, "length": 75}}"#,
            "",
            &[
                ("stock.length", EntryError::Unreadable(ReadError::NotANumber)),
                ("stock.diameter", EntryError::Unmet(Requirement::Positive)),
            ],
        );
    }

    #[test]
    fn a_single_rule_is_hidden_and_shown_again() {
        let given = Setup::from_json(r#"{"rules": {"no-program-end": "error"}}"#).expect("a setup");
        let read = |given: &Setup, list: &[(&str, &str)]| {
            let draft = Draft::read(&entries(list), given, &Setup::default());
            assert_eq!(draft.errors, []);
            draft.setup
        };
        let hidden = read(&given, &[("rules.classroom", "warning"), ("rules.Unknown-M-Code", "off")]);
        assert_eq!(
            put_into_json("{}", &hidden),
            r#"{"rules":{"classroom":"warning","no-program-end":"error","unknown-m-code":"off"}}"#
        );
        assert_eq!(hidden.rules.rules_off().collect::<Vec<_>>(), ["unknown-m-code"]);
        let shown = read(&hidden, &[("rules.classroom", "warning"), ("rules.unknown-m-code", "")]);
        assert_eq!(
            put_into_json("{}", &shown),
            r#"{"rules":{"classroom":"warning","no-program-end":"error"}}"#
        );
    }

    #[test]
    fn the_rest_of_a_json_is_kept() {
        let setup = Setup::from_json(r#"{"stock": {"diameter": 60, "length": 80}}"#).expect("a setup");
        let json = r#"{"dialect": {"polarX": "radius"}, "tools": {"T0101": {"tip": 3}}, "blockSkip": [1]}"#;
        assert_eq!(
            put_into_json(json, &setup),
            r#"{"blockSkip":[1],"dialect":{"polarX":"radius"},"stock":{"diameter":60,"length":80}}"#
        );
        assert_eq!(put_into_json("garbage", &setup), r#"{"stock":{"diameter":60,"length":80}}"#);
        assert_eq!(put_into_json("{}", &Setup::default()), "");
    }
}
