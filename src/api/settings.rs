//! Fixes of a message that change a setting of the setup instead of the program.
//!
//! In: a message. Out: fixes that change a setting, each with its key as in the setup form and its value. A
//! value that only the user knows is absent: the user enters it in the form.

use super::{Fix, Setting};
use crate::message::{Message, Value, said};
use crate::sentences::{Language, labels};
use crate::setup::fields::{self, Entry, Field};

/// The fixes of a message that change a setting, the most likely first.
pub fn fixes(message: &Message, language: Language) -> Vec<Fix> {
    let fix = |key: &'static str, value: Option<&str>| fix(key, value, language);
    if message.is::<said::ForeignControl>()
        || message.is::<said::ForeignMill>()
        || message.is::<said::ForeignPrinter>()
    {
        return vec![fix("recognise", Some("false"))];
    }
    // Only the Y axis has a setting; the A and B axes have none.
    if message.is::<said::AxisNotHere>() || message.is::<said::PlaneNotHere>() {
        let field = fields::MACHINE.iter().find(|field| field.key == "yAxis");
        return vec![written(field, "machine.yAxis", Some("true"), language)];
    }
    if message.is::<said::SystemGuessed>() {
        let arguments = message.arguments();
        let system = arguments.iter().find_map(|(name, value)| match value {
            Value::Text(text) if *name == "system" => Some(text.as_ref()),
            _ => None,
        });
        return vec![fix("gSystem", system), fix("gSystem", Some("A"))];
    }
    match message.slug() {
        "inches-concluded" => vec![fix("unit", Some("inch")), fix("unit", Some("mm"))],
        "least-increments-concluded" => {
            vec![fix("decimal", Some("leastIncrement")), fix("decimal", Some("calculator"))]
        }
        "too-large-without-point" => vec![fix("decimal", Some("leastIncrement"))],
        "amount-in-millimetres" => vec![fix("pqUnit", Some("mm")), fix("pqUnit", Some("um"))],
        "pockets-not-available" => vec![fix("typeII", Some("true"))],
        "arc-radius-negative" => vec![fix("negativeArcR", Some("over180"))],
        "machine-zero-unknown" | "not-at-reference-point" => vec![fix("refPoint.x", None)],
        _ => Vec::new(),
    }
}

fn fix(key: &'static str, value: Option<&str>, language: Language) -> Fix {
    let field = fields::DIALECT.iter().find(|field| field.key == key);
    written(field, &format!("dialect.{key}"), value, language)
}

/// The fix that sets a field of the setup to a value.
fn written<T>(field: Option<&Field<T>>, key: &str, value: Option<&str>, language: Language) -> Fix {
    let name = field.map_or("", |field| labels::field(field.name, language));
    let choices = field.map_or(&[][..], |field| match field.entry {
        Entry::Choice(choices) => choices,
        Entry::Switch => fields::SWITCH,
        Entry::Number(_) | Entry::Whole | Entry::Text => &[],
    });
    let chosen = choices.iter().find(|choice| Some(**choice) == value);
    let words = field.zip(chosen).map(|(field, chosen)| labels::choice(field.name, chosen, language));
    Fix {
        title: labels::setting(name, words, language),
        safe: false,
        edits: Vec::new(),
        setting: Some(Setting { key: key.to_owned(), value: value.map(str::to_owned) }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analyze;
    use crate::setup::Setup;
    use crate::setup::draft::{Draft, Entry as Entered, put_into_json};

    /// Checks which settings are offered for the message `slug`, and that each of them makes the message
    /// disappear.
    #[track_caller]
    fn check(text: &str, setup: &str, slug: &str, settings: &[(&str, Option<&str>)]) {
        let given = Setup::from_json(setup).expect("a setup");
        let found = analyze(text.as_bytes(), &given).diagnostics;
        let told = found.iter().find(|found| found.message.slug() == slug);
        let told = told.unwrap_or_else(|| panic!("{slug} is not reported: {found:?}"));
        let offered = fixes(&told.message, Language::English);
        let named: Vec<_> = offered.iter().flat_map(|fix| &fix.setting).collect();
        let plain = |setting: &&Setting| (setting.key.clone(), setting.value.clone());
        let whole = |key: &str| match key {
            "yAxis" => format!("machine.{key}"),
            key => format!("dialect.{key}"),
        };
        let wanted = settings.iter().map(|(key, value)| (whole(key), value.map(str::to_owned)));
        assert_eq!(named.iter().map(plain).collect::<Vec<_>>(), wanted.collect::<Vec<_>>());
        for setting in named {
            let text_entered = setting.value.clone().unwrap_or_else(|| "250".into());
            let entries = [Entered { key: setting.key.clone(), text: text_entered }];
            let draft = Draft::read(&entries, &given, &Setup::default());
            assert_eq!(draft.errors, []);
            let json = put_into_json("{}", &draft.setup);
            let changed = Setup::from_json(&json).expect("a setup");
            let left = analyze(text.as_bytes(), &changed).diagnostics;
            assert!(left.iter().all(|found| found.message.slug() != slug), "{slug} is left under {json}");
        }
    }

    #[test]
    fn each_setting_answers_its_message() {
        let mill =
            "O1\nG90 G54 G17\nT1 M6\nG43 H1 Z50.\nS1200 M3\nG0 X10. Y20.\nG1 Z-2. F200\nX40. Y35.\nM30\n";
        check(mill, "{}", "program-for-another-control", &[("recognise", Some("false"))]);
        let system = "O1\nG21 G95 G90\nG92 S2000\nT0101\nG96 S120 M3\nG0 X50 Z2\nG77 X40 Z-20 F0.2\nM30\n";
        check(system, "{}", "g-code-system-concluded", &[("gSystem", Some("B")), ("gSystem", Some("A"))]);
        let groove = "O1\nT0101\nG97 S300 M3\nG0 X52 Z-10\nG75 R1\nG75 X40 Z-20 P3 Q3 F0.1\nM30\n";
        check(groove, "{}", "amount-in-millimetres", &[("pqUnit", Some("mm")), ("pqUnit", Some("um"))]);
        let arc = "O1\nT0101 S800 M3\nG0 X40 Z0\nG1 F0.2\nG3 X50 Z-5 R-5\nM30\n";
        let alarm = r#"{"dialect": {"negativeArcR": "alarm"}}"#;
        check(arc, alarm, "arc-radius-negative", &[("negativeArcR", Some("over180"))]);
        let machine = "O1\nT0101 S800 M3\nG0 X40 Z2\nG1 Z-20 F0.2\nG53 X0 Z0\nM30\n";
        check(machine, "{}", "machine-zero-unknown", &[("refPoint.x", None)]);
        let beside = "O1\nT0101 S800 M3\nG0 X40 Z2\nG1 Y8 F0.2\nY0\nM30\n";
        check(beside, "{}", "axis-not-supported", &[("yAxis", Some("true"))]);
        let other = "O1\nT0101 S800 M3\nG0 X40 Z2\nG1 B8 F0.2\nM30\n";
        check(other, "{}", "axis-not-supported", &[]);
        let plane = "O1\nG17\nT0101 S800 M3\nG0 X40 Z2\nG3 X50 Z-5 R5 F0.2\nM30\n";
        check(plane, "{}", "plane-not-supported", &[("yAxis", Some("true"))]);
    }
}
