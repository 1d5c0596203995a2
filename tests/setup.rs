//! Setups: written as comments they are read back unchanged, any setup results in a picture, and the
//! reference lists every field.
use gcode_playground::analyze;
use gcode_playground::machine::SimulationResult;
use gcode_playground::message::{Levels, RULES, Severity};
use gcode_playground::setup::as_comments::{changes, lines};
use gcode_playground::setup::blank::Outline;
use gcode_playground::setup::dialect::{
    Control, DecimalChoice, DialectChoice, FeedMode, GSystem, NegativeArcR, PqUnit,
};
use gcode_playground::setup::draft::put_into_json;
use gcode_playground::setup::fields::{self, Entry, Field, Unit};
use gcode_playground::setup::notes::{
    DIALECT_WORDS, MACHINE_WORDS, Notes, RULE_WORDS, STOCK_WORDS, TOOL_WORDS,
};
use gcode_playground::setup::{
    Blank, Machine, Position, Setup, Side, Stock, Tailstock, Tool, ToolKind, Travel, Turret,
};
use gcode_playground::units::{self, Diameter};
use proptest::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

const PROGRAM: &str = "O0001\nT0101\nG97 S800 M3\nG0 X40 Z2\nG1 Z-20 F0.2\nX44\nG0 X100 Z100\nM30\n";

/// Lengths as users write them: JSON numbers with more digits may lose the last one.
fn length() -> impl Strategy<Value = f64> {
    prop_oneof![
        (-90000i32..90000).prop_map(|thousandths| f64::from(thousandths) / 1000.0),
        Just(0.0),
        Just(6e9)
    ]
}

fn diameter() -> impl Strategy<Value = Diameter> {
    length().prop_map(Diameter::new)
}

fn maybe_diameter() -> impl Strategy<Value = Option<Diameter>> {
    proptest::option::of(diameter())
}

fn maybe() -> impl Strategy<Value = Option<f64>> {
    proptest::option::of(length())
}

prop_compose! {
    fn tool()(
        kind in proptest::option::of(proptest::sample::select(ToolKind::ALL.to_vec())),
        side in proptest::option::of(proptest::sample::select(Side::ALL.to_vec())),
        insert in proptest::option::of("[CDVTSRW][A-Z]{3}[0-9]{0,6}"),
        tip in proptest::option::of(any::<u8>()),
        (nose_radius, tool_radius, geometry_r, point_angle) in (maybe(), maybe(), maybe(), maybe()),
        (entering_angle, edge_length, width, diameter) in (maybe(), maybe(), maybe(), maybe_diameter()),
        (reach, shank, angle) in (maybe(), maybe(), maybe()),
        (geometry_x, geometry_z, wear_x) in (maybe_diameter(), maybe(), maybe_diameter()),
        (wear_z, wear_r) in (maybe(), maybe()),
    ) -> Tool {
        Tool {
            nose_radius, tip, tool_radius, geometry_r, kind, side, insert, point_angle, entering_angle, edge_length,
            width, diameter, reach, shank, angle, geometry_x, geometry_z, wear_x, wear_z, wear_r,
        }
    }
}

prop_compose! {
    fn machine()(
        (rapid_x, rapid_z, max_speed, thread_speed_margin) in (maybe(), maybe(), maybe(), maybe()),
        (x_min, x_max, z_min, z_max) in (maybe_diameter(), maybe_diameter(), maybe(), maybe()),
        (turret, y_axis) in (
            prop_oneof![Just(Turret::Rear), Just(Turret::Front)],
            proptest::option::of(any::<bool>()),
        ),
    ) -> Machine {
        let travel = Travel { x_min, x_max, z_min, z_max };
        Machine { rapid_x, rapid_z, max_speed, thread_speed_margin, travel, turret, y_axis }
    }
}

/// Another severity for rules that these programs do not trigger.
fn rules() -> impl Strategy<Value = Levels> {
    let names =
        proptest::sample::select(vec!["classroom", "coolant-off", "arc-without-way", "rule-of-stock"]);
    let list = proptest::collection::vec((names, proptest::sample::select(Severity::ALL.to_vec())), 0..4);
    list.prop_map(|list| {
        let mut levels = Levels::default();
        for (name, level) in list {
            assert_eq!(levels.set(name, level), name != "rule-of-stock");
        }
        levels
    })
}

prop_compose! {
    fn dialect()(
        control in proptest::option::of(proptest::sample::select(Control::ALL.to_vec())),
        g_system in proptest::option::of(proptest::sample::select(GSystem::ALL.to_vec())),
        unit in proptest::option::of(proptest::sample::select(units::Unit::ALL.to_vec())),
        feed_mode in proptest::option::of(proptest::sample::select(FeedMode::ALL.to_vec())),
        decimal in proptest::option::of(proptest::sample::select(DecimalChoice::ALL.to_vec())),
        pq_unit in proptest::option::of(proptest::sample::select(PqUnit::ALL.to_vec())),
        negative_arc_r in proptest::option::of(proptest::sample::select(NegativeArcR::ALL.to_vec())),
        ref_point in proptest::option::of((diameter(), length())),
        (recognise, strict, type_ii) in (any::<Option<bool>>(), any::<Option<bool>>(), any::<Option<bool>>()),
    ) -> DialectChoice {
        let ref_point = ref_point.map(|(x, z)| Position { x, z });
        DialectChoice {
            control, g_system, unit, feed_mode, decimal, pq_unit, negative_arc_r, ref_point, recognise, strict, type_ii,
            ..DialectChoice::default()
        }
    }
}

/// A bar or tube, or an outline.
fn blank() -> impl Strategy<Value = Blank> {
    let bar = (diameter(), diameter(), length(), length(), maybe());
    let bar = bar.prop_map(|(diameter, bore, face, length, grip)| {
        Blank::from(Stock { diameter, bore, face, length, grip })
    });
    let points = proptest::collection::vec((diameter(), length()), 1..12);
    let outlined = (points, maybe()).prop_map(|(points, grip)| {
        let points = points.into_iter().map(|(x, z)| Position { x, z }).collect();
        Blank::with_outline(Outline::new(points), grip)
    });
    prop_oneof![bar, outlined]
}

prop_compose! {
    fn setup()(
        stock in proptest::option::of(blank()),
        tailstock in proptest::option::of((length(), diameter())),
        start in proptest::option::of((diameter(), length())),
        machine in machine(),
        rules in rules(),
        dialect in dialect(),
        tools in proptest::collection::btree_map("T[0-9]{4}", tool(), 0..4),
    ) -> Setup {
        Setup {
            stock,
            tailstock: tailstock.map(|(z, diameter)| Tailstock { z, diameter }),
            initial: start.map(|(x, z)| Position { x, z }),
            machine,
            rules,
            dialect,
            // A tool without any fields is not written.
            tools: tools.into_iter().filter(|(_, tool)| *tool != Tool::default()).collect(),
            ..Setup::default()
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(200) })]

    /// A setup written as comments or as JSON is read back unchanged, and writing it again changes nothing.
    #[test]
    fn written_and_read_again(setup in setup(), head in "(%\n)?(O[0-9]{1,4}( \\(PART\\))?\n)?(\\(STOCK D=1 L=2\\)\n)?") {
        let mut text = format!("{head}G0 X50 Z2\n").into_bytes();
        let lines = lines(&setup);
        for change in changes(&text, &lines).into_iter().rev() {
            text.splice(change.span.start as usize..change.span.end as usize, change.insert.into_bytes());
        }
        let notes = Notes::read(&text);
        prop_assert_eq!(&notes.unreadable, &[]);
        prop_assert_eq!(&notes.applied_to(Setup::default()), &setup);
        prop_assert!(text.ends_with(b"G0 X50 Z2\n"));
        let json = put_into_json("{}", &setup);
        prop_assert_eq!(Setup::from_json(if json.is_empty() { "{}" } else { &json }), Ok(setup));
    }

    /// Any setup leaves a path and a part, and a message for each fault.
    #[test]
    fn whatever_is_given_leaves_a_part(setup in setup()) {
        let analysis = analyze(PROGRAM.as_bytes(), &setup);
        prop_assert_eq!(analysis.motions.len(), 4);
        let (sound, faults) = setup.clone().without_invalid_values();
        let told = analysis.diagnostics.iter().filter(|found| found.message.slug() == "setup-value").count();
        prop_assert_eq!(told, faults.len());
        let simulation = SimulationResult::of(&analysis.motions, &sound);
        prop_assert!(simulation.finished().is_some());
    }
}

/// Checks the error for an invalid JSON setup, or the message reported for it.
#[track_caller]
fn refused(json: &str, words: &[&str]) {
    let told = match Setup::from_json(json) {
        Err(reason) => reason,
        Ok(setup) => {
            let found = analyze(PROGRAM.as_bytes(), &setup).diagnostics;
            let language = gcode_playground::sentences::Language::English;
            found.iter().map(|found| found.message.sentence(language).message).collect::<Vec<_>>().join("\n")
        }
    };
    for word in words {
        assert!(told.contains(word), "{json}: {told}");
    }
}

#[test]
fn bad_setups_are_told_by_name() {
    refused(
        r#"{"stock": {"diameter": -60, "length": 80}}"#,
        &["`stock.diameter`", "-60", "greater than zero"],
    );
    refused(
        r#"{"stock": {"diameter": 60, "length": 80, "bore": 70}}"#,
        &["`stock.bore`", "70", "less than 60"],
    );
    refused(r#"{"stock": {"diameter": NaN, "length": 80}}"#, &["\"diameter\"", "expected value"]);
    refused(r#"{"stock": {"diameter": 1e999, "length": 80}}"#, &["\"diameter\"", "number out of range"]);
    refused(
        "{\"stock\":\n {\"diameter\": \"60\", \"length\": 80}}",
        &["\"diameter\"", "expected f64", "line 2"],
    );
    refused(r#"{"stock": {"diameter": 60}}"#, &["missing field `length`"]);
    refused(r#"{"stock": {"length": 80}}"#, &["missing field `diameter`"]);
    refused(r#"{"tools": {"X1": {"tip": 3}}}"#, &["tools.X1", "T0101"]);
    refused(r#"{"initial": {"x": 1e300, "z": 0}}"#, &["`initial.x`", "5000"]);
    refused("garbage", &["expected value"]);
    refused(
        "{\"rules\": {\"no-program-end\": \"off\",\n \"coolant-of\": \"off\"}}",
        &["`coolant-of`", "nearest is `coolant-off`", "line 2"],
    );
    refused(r#"{"rules": {"no-program-end": "loud"}}"#, &["\"no-program-end\"", "`loud`", "warning"]);
    refused(r#"{"rules": {"no-program-end": 1}}"#, &["\"no-program-end\"", "expected a string"]);
    refused(r#"{"rules": ["no-program-end"]}"#, &["an object of rules"]);
}

#[test]
fn bad_outlines_are_told_by_point() {
    let outline = |points: &str, words: &[&str]| {
        refused(&format!(r#"{{"stock": {{"outline": [{points}]}}}}"#), words);
    };
    outline("[30, 2]", &["2 to 200 points; it has 1"]);
    outline("", &["`outline` needs points"]);
    let many: Vec<String> = (0..201).map(|index| format!("[30, -{index}]")).collect();
    outline(&many.join(", "), &["2 to 200 points; it has 201"]);
    outline("[30, 2], [-30, -60]", &["Point 2", "X-30", "negative"]);
    outline("[30, 2], [30, -6000]", &["Point 2", "-6000", "5000"]);
    outline("[8000, 2], [30, -60]", &["Point 1", "8000", "5000"]);
    // On the axis, straight across, and a line there and back.
    outline("[0, 2], [0, -60]", &["no area"]);
    outline("[0, 2], [30, 2]", &["no area"]);
    outline("[10, 0], [30, -60], [10, 0]", &["no area"]);
    // The line from the third point crosses the first line.
    outline("[20, 0], [40, -40], [40, 0], [20, -40]", &["crosses itself", "point 3"]);
    // The line to the axis touches the first point.
    outline("[20, 0], [20, -40], [30, -40], [30, 0]", &["crosses itself", "point 4"]);
    // The third line runs back along the second.
    outline("[20, 0], [20, -40], [20, -20], [30, -60]", &["crosses itself", "point 2"]);
    refused(r#"{"stock": {"outline": [[30, 2], [50, -60]], "diameter": 60}}"#, &["`outline` replaces"]);
    refused(r#"{"stock": {"outline": [[30, 2, 5], [50, -60]]}}"#, &["a point of `outline` is [x, z]"]);
    refused(r#"{"stock": {"outline": [[30, 2], [50, -60]], "grip": 70}}"#, &["`stock.grip`", "less than 62"]);
}

/// The beginning of each row of the table in the reference.
fn rows<T>(json: &str, note: &str, fields: &[Field<T>]) -> Vec<String> {
    let rows = fields.iter().map(|field| {
        let unit = match field.entry {
            Entry::Number(Unit::Millimetre) => "mm".into(),
            Entry::Number(Unit::Degree) => "degrees".into(),
            Entry::Number(Unit::MillimetrePerMinute) => "mm/min".into(),
            Entry::Number(Unit::TurnsPerMinute) => "rpm".into(),
            Entry::Whole => "whole number".into(),
            Entry::Text => "letters and digits".into(),
            Entry::Switch => "`true` `false`".into(),
            Entry::Choice(choices) => {
                choices.iter().map(|one| format!("`{one}`")).collect::<Vec<_>>().join(" ")
            }
        };
        format!("| `{json}{}` | `{note} {}=` | {unit} |", field.key, field.word)
    });
    rows.collect()
}

#[test]
fn the_reference_lists_every_field_of_a_setup() {
    let page = include_str!("../www/docs/setup.md");
    let table = page.split("<!-- setup -->").nth(1).and_then(|rest| rest.split("<!-- /setup -->").next());
    let found: Vec<&str> = table.expect("a table").lines().filter(|line| line.starts_with("| `")).collect();
    let wanted = [
        rows("stock.", "STOCK", fields::STOCK),
        vec![format!("| `stock.{}` | `STOCK X= Z=` | points |", fields::OUTLINE)],
        rows("tools.T0101.", "TOOL T0101", fields::TOOL),
        rows("initial.", "START", fields::START),
        rows("tailstock.", "TAILSTOCK", fields::TAILSTOCK),
        rows("machine.", "MACHINE", fields::MACHINE),
        rows("dialect.", "DIALECT", fields::DIALECT),
        rows("rules.", "RULES", fields::RULES),
    ]
    .concat();
    assert_eq!(found.len(), wanted.len(), "setup.md should have\n{}", wanted.join("\n"));
    for (row, wanted) in found.iter().zip(&wanted) {
        assert!(row.starts_with(wanted), "setup.md has\n{row}\ninstead of\n{wanted}");
    }
    let example = page.split("```text\n").find(|part| part.starts_with("(STOCK")).expect("an example");
    let notes = Notes::read(example.split("```").next().unwrap_or_default().as_bytes());
    assert_eq!(notes.unreadable, []);
    assert!(notes.stock.is_some() && notes.tools.len() >= 2 && notes.machine.is_some());
    assert!(!notes.rules.is_empty());
}

/// A message lists exactly the words that are valid there.
#[test]
fn messages_offer_every_word() {
    let missing = |words: &[&str], offered: &str| {
        words
            .iter()
            .filter(|word| !offered.contains(&format!("{word}=")))
            .map(|word| word.to_string())
            .collect::<Vec<_>>()
    };
    let tool: Vec<_> = fields::TOOL.iter().map(|field| field.word).collect();
    let machine: Vec<_> = fields::MACHINE.iter().map(|field| field.word).collect();
    assert_eq!(missing(&tool, TOOL_WORDS), [""; 0]);
    assert_eq!(missing(&machine, MACHINE_WORDS), [""; 0]);
    let stock: Vec<_> = fields::STOCK.iter().map(|field| field.word).chain(["X", "Z"]).collect();
    assert_eq!(missing(&stock, STOCK_WORDS[0]), [""; 0]);
    assert_eq!(missing(&["X", "Z", "GRIP"], STOCK_WORDS[1]), [""; 0]);
    let switches: Vec<_> = fields::DIALECT.iter().map(|field| field.word).collect();
    assert_eq!(missing(&switches, DIALECT_WORDS), [""; 0]);
    let groups: Vec<_> = fields::RULES.iter().map(|field| field.word).collect();
    assert_eq!(missing(&groups, RULE_WORDS), [""; 0]);
}

/// Every rule can be set by its slug, in JSON and in a comment.
#[test]
fn every_rule_can_be_set() {
    for rule in &RULES {
        let json = format!(r#"{{"rules": {{"{}": "off"}}}}"#, rule.slug);
        let rules = Setup::from_json(&json).map(|setup| setup.rules);
        let note = Notes::read(format!("(RULES {}=OFF)", rule.slug.to_uppercase()).as_bytes());
        assert_eq!((rules, note.unreadable.len()), (Ok(note.rules.clone()), 0), "{}", rule.slug);
        assert_eq!(note.rules.of(rule.slug), Some(Severity::Off));
    }
}

/// The keys of an interface of `www/embed/node/setup.d.ts`, with their types.
fn typed(name: &str) -> BTreeMap<String, String> {
    let text = include_str!("../www/embed/node/setup.d.ts");
    let body = text.split(&format!("interface {name} {{")).nth(1).and_then(|rest| rest.split("\n}").next());
    let keys = body.expect(name).lines().filter_map(|line| line.trim().strip_prefix("readonly "));
    let keys = keys.filter_map(|line| line.trim_end_matches(';').split_once(": "));
    keys.map(|(key, of)| (key.trim_end_matches('?').to_owned(), of.to_owned())).collect()
}

/// The types of the npm package contain the setup keys that are read, and the choices of the fields.
#[test]
fn the_types_of_a_setup_are_what_is_read() {
    for (name, wrong) in [
        ("Setup", r#"{"zz": 1}"#),
        ("SetupDialect", r#"{"dialect": {"zz": 1}}"#),
        ("SetupPosition", r#"{"initial": {"zz": 1}}"#),
        ("SetupTool", r#"{"tools": {"T0101": {"zz": 1}}}"#),
        ("SetupStock", r#"{"stock": {"zz": 1}}"#),
        ("SetupTailstock", r#"{"tailstock": {"zz": 1}}"#),
        ("SetupMachine", r#"{"machine": {"zz": 1}}"#),
        ("SetupTravel", r#"{"machine": {"travel": {"zz": 1}}}"#),
        ("SetupLimits", r#"{"limits": {"zz": 1}}"#),
    ] {
        let error = Setup::from_json(wrong).expect_err(name);
        let expected = error.split("expected").nth(1).expect("the keys");
        let expected: BTreeSet<_> = expected.split('`').skip(1).step_by(2).map(str::to_owned).collect();
        assert_eq!(typed(name).into_keys().collect::<BTreeSet<_>>(), expected, "{name}");
    }
    /// Types in alphabetical order.
    fn in_order(types: impl Iterator<Item = String>) -> String {
        types.collect::<BTreeSet<_>>().into_iter().collect::<Vec<_>>().join(" | ")
    }
    fn choices<T>(name: &str, fields: &[Field<T>]) {
        let typed = typed(name);
        for field in fields.iter().filter(|field| !field.key.contains('.')) {
            let expected = match field.entry {
                Entry::Choice(choices) => in_order(choices.iter().map(|one| format!("'{one}'"))),
                Entry::Switch => "boolean".to_owned(),
                Entry::Text => "string".to_owned(),
                Entry::Number(_) | Entry::Whole => "number".to_owned(),
            };
            let own = in_order(typed[field.key].split(" | ").map(str::to_owned));
            assert_eq!(own, expected, "{name}.{}", field.key);
        }
    }
    choices("SetupStock", fields::STOCK);
    choices("SetupTool", fields::TOOL);
    choices("SetupTailstock", fields::TAILSTOCK);
    choices("SetupMachine", fields::MACHINE);
    choices("SetupDialect", fields::DIALECT);
    choices("SetupPosition", fields::START);
}
