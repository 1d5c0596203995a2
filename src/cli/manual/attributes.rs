//! Validates the attributes of an element.
//!
//! In: name and value of an attribute. Out: the fault, if any. The page has its own list in
//! `element-attributes.ts`, which the test below compares with this one.

/// Attributes with their allowed values; empty if any text is allowed.
const KNOWN: [(&str, &[&str]); 28] = [
    ("src", &[]),
    ("control", &["fanuc", "gsk", "forum"]),
    ("setup", &[]),
    ("block-skip", &[]),
    ("program", &[]),
    ("language", &["en", "zh", "ru"]),
    ("theme", &["auto", "light", "dark"]),
    ("view", &["all", "picture", "playback", "code"]),
    ("controls", &[]),
    ("readonly", &[]),
    ("step", &[]),
    ("highlight", &[]),
    ("lines", &[]),
    ("fit", &["part", "path"]),
    ("turret", &["front", "rear"]),
    ("annotate", &["none", "word", "cycle", "part"]),
    (
        "calculator",
        &[
            "cone",
            "r-of-g90",
            "r-of-g94",
            "passes-of-a-cone",
            "thread-speed",
            "run-in",
            "thread-height",
            "thread-by-name",
            "passes-of-g76",
            "passes-of-g71",
            "steps-of-g73",
            "columns-of-g75",
            "speed",
        ],
    ),
    ("exercise", &[]),
    ("caption", &[]),
    ("loading", &["lazy", "eager", "click"]),
    ("playground", &[]),
    ("rules", &[]),
    ("docs", &[]),
    ("manual", &[]),
    ("speed", &[]),
    ("height", &["auto"]),
    ("rows-min", &[]),
    ("rows-max", &[]),
];
/// Attributes of the element that do not concern its program.
const OF_THE_PAGE: [&str; 2] = ["split", "hints"];
/// Global attributes of HTML.
const OF_HTML: [&str; 13] = [
    "class", "dir", "hidden", "id", "key", "lang", "no-check", "part", "role", "slot", "style", "tabindex",
    "title",
];
/// Prefixes of other allowed names.
const BEGINNINGS: [&str; 4] = ["aria-", "data-", "on", "item"];
const CONTROLS: [&str; 10] =
    ["none", "file", "setup", "problems", "views", "playback", "status", "tools", "help", "link"];

/// A fault in an attribute.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Fault {
    /// Unknown name.
    Name,
    /// Invalid value.
    Value {
        /// The allowed values, or the expected syntax.
        expected: String,
    },
}

/// The fault in an attribute of an element, if any.
pub fn fault(name: &str, value: &str) -> Option<Fault> {
    let value = value.trim();
    let expects = |expected: &str| Some(Fault::Value { expected: expected.to_owned() });
    let Some((_, values)) = KNOWN.iter().find(|(known, _)| *known == name) else {
        let is_of_html = OF_HTML.contains(&name) || BEGINNINGS.iter().any(|start| name.starts_with(start));
        return (!is_of_html && !OF_THE_PAGE.contains(&name)).then_some(Fault::Name);
    };
    match name {
        _ if !values.is_empty() => {
            (!values.contains(&value)).then(|| Fault::Value { expected: values.join(", ") })
        }
        "controls" if !words(value).all(|word| CONTROLS.contains(&word)) => expects(&CONTROLS.join(", ")),
        "step" if !is_step(value) => expects("12, line 8"),
        "highlight" | "lines" if !words(value).all(is_lines) => expects("6-8, 12"),
        "block-skip" if !words(value).all(|word| matches!(word.parse(), Ok(1..=9_u8))) => expects("1,2"),
        "program" if value.parse::<u32>().is_err() => expects("2"),
        "rows-min" | "rows-max" if !matches!(value.parse(), Ok(1..=999_u16)) => expects("12"),
        "speed" if !is_speed(value) => expects("5, 20 s"),
        _ => None,
    }
}

/// Whether the attribute is an event handler, like `onclick`, whose value is a script.
pub fn is_handler(name: &str) -> bool {
    name.starts_with("on")
}

/// Whether the element reads the attribute. The page for frames accepts no others in its address.
pub fn is_of_the_element(name: &str) -> bool {
    KNOWN.iter().any(|(known, _)| *known == name)
}

/// Names of all attributes that concern the program.
#[cfg(test)]
pub fn names() -> Vec<&'static str> {
    KNOWN.iter().map(|(name, _)| *name).collect()
}

fn words(value: &str) -> impl Iterator<Item = &str> {
    value.split(|letter: char| letter == ',' || letter.is_whitespace()).filter(|word| !word.is_empty())
}

fn is_number(text: &str) -> bool {
    text.parse::<u32>().is_ok()
}

fn is_lines(word: &str) -> bool {
    word.split_once(['-', '–']).map_or(is_number(word), |(first, last)| is_number(first) && is_number(last))
}

fn is_step(value: &str) -> bool {
    is_number(value.strip_prefix("line").map_or(value, str::trim_start))
}

/// A multiple of the speed of the machine, or a number of seconds for the whole program.
fn is_speed(value: &str) -> bool {
    let number = value.strip_suffix('s').map_or(value, str::trim_end);
    let has_digits = number.chars().all(|letter| letter.is_ascii_digit() || letter == '.');
    has_digits && number.parse::<f64>().is_ok_and(|number| number > 0.0 && number < 10_000.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn attributes_are_those_of_the_element() {
        let source = include_str!("../../../www/src/shell/element-attributes.ts");
        let list = source.split("observedAttributes = [").nth(1).and_then(|rest| rest.split(']').next());
        let own: Vec<&str> = list.unwrap_or_default().split('\'').skip(1).step_by(2).collect();
        assert_eq!(own, names());
    }

    #[test]
    fn a_mistyped_attribute_is_found() {
        for (name, value) in [
            ("view", "picture"),
            ("controls", "playback status"),
            ("highlight", "6-8, 12"),
            ("lines", "3–20"),
            ("step", "line 8"),
            ("step", "12"),
            ("speed", "0.5"),
            ("speed", "20 s"),
            ("height", "auto"),
            ("rows-max", "12"),
            ("readonly", ""),
            ("data-x", "y"),
            ("aria-label", "y"),
            ("class", "wide"),
            ("caption", "anything"),
        ] {
            assert_eq!(fault(name, value), None, "{name}={value}");
        }
        assert_eq!(fault("veiw", "playback"), Some(Fault::Name));
        for (name, value) in [
            ("view", "playbck"),
            ("controls", "nonsense"),
            ("highlight", "40-x"),
            ("step", "block 8"),
            ("turret", "left"),
            ("block-skip", "12"),
            ("speed", "fast"),
            ("speed", "0"),
            ("height", "full"),
            ("rows-min", "0"),
        ] {
            assert!(matches!(fault(name, value), Some(Fault::Value { .. })), "{name}={value}");
        }
    }
}
